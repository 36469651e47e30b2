// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <memory>
#include <utility>

namespace limpet::model::internal {

/// Owns one T or none, and passes on constness: through a constant Owned the T is constant. (A constant
/// std::unique_ptr lets its T be changed.)
template <class T>
class Owned {
 public:
  Owned() = default;
  Owned(std::unique_ptr<T> one) : one_(std::move(one)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return one_ != nullptr; }
  T* get() { return one_.get(); }
  const T* get() const { return one_.get(); }
  T& operator*() { return *one_; }
  const T& operator*() const { return *one_; }
  T* operator->() { return one_.get(); }
  const T* operator->() const { return one_.get(); }
  void reset() { one_.reset(); }

 private:
  std::unique_ptr<T> one_;
};

}  // namespace limpet::model::internal
