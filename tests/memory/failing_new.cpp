// Copyright the limpet authors. GPL-3.0-or-later.
#include "failing_new.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
constexpr std::size_t kAnySize = std::numeric_limits<std::size_t>::max();
std::int64_t requests = 0, first_failure = kNever;
std::size_t largest = kAnySize;

void* request(std::size_t size, std::size_t alignment = alignof(std::max_align_t)) {
  if (requests++ >= first_failure || size > largest) throw std::bad_alloc();
  const std::size_t whole = (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole);
  if (!memory) throw std::bad_alloc();
  return memory;
}

void* request_or_null(std::size_t size) noexcept {
  try {
    return request(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace

/// What a union gives up when memory runs out (geometry/outline.cpp) is known.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): a name of the sanitizer
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }

namespace limpet::memory {

void fail_from(std::int64_t nth) { requests = 0, first_failure = nth; }

void fail_above(std::size_t bytes) { largest = bytes; }

std::int64_t relent() {
  first_failure = kNever;
  largest = kAnySize;
  return requests;
}

}  // namespace limpet::memory

void* operator new(std::size_t size) { return request(size); }
void* operator new[](std::size_t size) { return request(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return request(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return request(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return request_or_null(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return request_or_null(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
