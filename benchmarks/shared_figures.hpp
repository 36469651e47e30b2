// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <sys/mman.h>

#include <new>
#include <stdexcept>

namespace limpet::benchmarks {

/// Figures that children count in and that outlive them, however they end. They last as long as the program.
template <class Figures>
Figures& shared_figures() {
  void* memory = ::mmap(nullptr, sizeof(Figures), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory to share");
  return *new (memory) Figures;
}

}  // namespace limpet::benchmarks
