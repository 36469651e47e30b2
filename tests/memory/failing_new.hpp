// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>

/// Memory that runs out when a test says so: operator new of this program.
namespace limpet::memory {

/// From now on counts requests from 0, and fails the nth of them and all after it, until relent().
void fail_from(std::int64_t nth);
/// From now on fails every request for more than so many bytes, until relent().
void fail_above(std::size_t bytes);
/// No request fails any more. Returns how many there were since fail_from().
std::int64_t relent();

}  // namespace limpet::memory
