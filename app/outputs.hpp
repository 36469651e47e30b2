// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <string>

namespace limpet::app {

/// The outputs at the end of a run: each is tried, whatever has become of the others.
class Outputs {
 public:
  /// Calls write(), which writes the file of this name, and notes io::OutputError and std::bad_alloc.
  void attempt(const std::string& name, const std::function<void()>& write);
  /// Notes what else went wrong, in one line.
  void add(const std::string& failure);
  bool failed() const { return !failures_.empty(); }
  /// Throws io::OutputError that names all failures, if there are any.
  void require_all() const;

 private:
  std::string failures_;
};

}  // namespace limpet::app
