// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <limpet/model/record.hpp>

/// Serialises plain data to bytes and back, little-endian and of fixed width. The members of a struct are
/// listed once, for both directions:
///
///     void describe(auto& archive, Is<RawPoint> auto& r) { archive(r.at, r.axis, r.variance); }
namespace limpet::model::internal {

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Appends to a string of bytes.
class Writer {
 public:
  static constexpr bool kReads = false;

  template <class... T>
  void operator()(const T&... parts) {
    (describe(*this, parts), ...);
  }
  /// The lowest `size` bytes of a word.
  void word(std::uint64_t word, std::size_t size) {
    char bytes[8];
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(word >> (8 * i));
    bytes_.append(bytes, size);
  }
  void append(std::string_view bytes) { bytes_ += bytes; }
  std::string& bytes() { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads what a Writer wrote. Throws std::invalid_argument when the bytes end too early or hold impossible
/// values. A false count cannot make it allocate more than the number of remaining bytes justifies.
class Reader {
 public:
  static constexpr bool kReads = true;

  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <class... T>
  void operator()(T&... parts) {
    (describe(*this, parts), ...);
  }
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) refuse("ends too early");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  std::uint64_t word(std::size_t size) {
    std::uint64_t word = 0;
    const std::string_view bytes = take(size);
    for (std::size_t i = 0; i < size; ++i)
      word |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return word;
  }
  std::size_t left() const { return rest_.size(); }
  [[noreturn]] static void refuse(const std::string& what) {
    throw std::invalid_argument("a stored model " + what);
  }

 private:
  std::string_view rest_;
};

template <Number T>
std::uint64_t word_of(T x) {
  if constexpr (std::is_enum_v<T>)
    return word_of(static_cast<std::underlying_type_t<T>>(x));
  else if constexpr (std::is_same_v<T, double>)
    return std::bit_cast<std::uint64_t>(x);
  else
    return static_cast<std::uint64_t>(x);
}

/// Refuses numbers that no model has: Booleans other than 0 and 1, doubles that are not finite, and integers
/// so large that the sum of two would overflow.
template <Number T>
T number_from(std::uint64_t word) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(number_from<std::underlying_type_t<T>>(word));
  } else if constexpr (std::is_same_v<T, bool>) {
    if (word > 1) Reader::refuse("has a truth value that is none");
    return word == 1;
  } else if constexpr (std::is_same_v<T, double>) {
    const double x = std::bit_cast<double>(word);
    if (!std::isfinite(x)) Reader::refuse("has a number that is not finite");
    return x;
  } else {
    const T x = static_cast<T>(word);
    if constexpr (std::is_signed_v<T> && sizeof(T) > 1)
      if (x > std::numeric_limits<T>::max() / 2 || x < std::numeric_limits<T>::min() / 2)
        Reader::refuse("has a number that is too large");
    return x;
  }
}

template <class Archive, Number T>
void describe(Archive& archive, T& x) {
  if constexpr (Archive::kReads)
    x = number_from<T>(archive.word(sizeof(T)));
  else
    archive.word(word_of(x), sizeof(T));
}

template <class Archive, Is<Int128> T>
void describe(Archive& archive, T& x) {
  if constexpr (Archive::kReads) {
    const std::uint64_t low = archive.word(8);
    x = (Int128{static_cast<std::int64_t>(archive.word(8))} << 64) | Int128{low};
  } else {
    archive.word(static_cast<std::uint64_t>(x), 8);
    archive.word(static_cast<std::uint64_t>(x >> 64), 8);
  }
}

void describe(auto& archive, Is<Eigen::Vector3d> auto& v) { archive(v[0], v[1], v[2]); }
void describe(auto& archive, Is<Eigen::AlignedBox3d> auto& box) { archive(box.min(), box.max()); }

template <class T>
struct TakenAs {
  using type = T;
};
template <class K, class V>  // a map's own pairs have constant keys, which cannot be read into
struct TakenAs<std::pair<const K, V>> {
  using type = std::pair<K, V>;
};

template <class T>
inline constexpr bool kIsContainer = false;
template <class... T>
inline constexpr bool kIsContainer<std::vector<T...>> = true;
template <class... T>
inline constexpr bool kIsContainer<std::deque<T...>> = true;
template <class... T>
inline constexpr bool kIsContainer<std::map<T...>> = true;
template <class... T>
inline constexpr bool kIsContainer<std::set<T...>> = true;

/// A container: the number of elements, then each of them.
template <class Archive, class T>
requires kIsContainer<std::remove_const_t<T>>
void describe(Archive& archive, T& all) {
  if constexpr (Archive::kReads) {
    all.clear();
    const std::uint64_t count = archive.word(8);
    if (count > archive.left()) Reader::refuse("promises more than there is");
    for (std::uint64_t i = 0; i < count; ++i) {
      typename TakenAs<typename T::value_type>::type one{};
      archive(one);
      all.insert(all.end(), std::move(one));
    }
    if (all.size() != count) Reader::refuse("has something twice");
  } else {
    archive.word(all.size(), 8);
    for (const auto& one : all) archive(one);
  }
}

template <class Archive, class T, std::size_t N>
void describe(Archive& archive, std::array<T, N>& all) {
  for (T& one : all) archive(one);
}
template <class Archive, class T, std::size_t N>
void describe(Archive& archive, const std::array<T, N>& all) {
  for (const T& one : all) archive(one);
}

template <class Archive, class A, class B>
void describe(Archive& archive, std::pair<A, B>& both) {
  archive(both.first, both.second);
}
template <class Archive, class A, class B>
void describe(Archive& archive, const std::pair<A, B>& both) {
  archive(both.first, both.second);
}

/// An owning pointer: whether there is an object, then the object.
template <class Archive, class Pointer>
requires requires(Pointer p) {
  p.get();
  typename std::remove_cvref_t<decltype(*p)>;
}
void describe(Archive& archive, Pointer& one) {
  if constexpr (Archive::kReads) {
    using T = std::remove_cvref_t<decltype(*one)>;
    bool there = false;
    archive(there);
    one = there ? std::make_unique<T>() : nullptr;
    if (there) archive(*one);
  } else {
    archive(one.get() != nullptr);
    if (one) archive(std::as_const(*one));
  }
}

}  // namespace limpet::model::internal
