// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <span>

namespace limpet::geometry::internal {

/// Scratch space of one call: a vector whose first `N` elements lie within the object itself, on the stack.
/// So the usual small case allocates nothing, and nothing has to be kept between calls, where threads would
/// share it.
template <class T, std::size_t N>
using SmallVector = boost::container::small_vector<T, N>;

/// Boost's iterators are not declared contiguous, so that a span has to be asked for.
template <class T, std::size_t N>
std::span<const T> as_span(const SmallVector<T, N>& v) {
  return {v.data(), v.size()};
}

}  // namespace limpet::geometry::internal
