// Copyright the limpet authors. GPL-3.0-or-later.
//
// A coverage-guided fuzzer of one kind of input; LIMPET_FUZZ_KIND says which. A broken law ends it like a
// crash; the input, which libFuzzer keeps, becomes a case by `limpet_case show`.
#include <cstdio>
#include <cstdlib>

#include "../cases/any_case.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto broken =
      limpet::cases::broken_law_of_bytes(LIMPET_FUZZ_KIND, {data, size}, [](const std::string&) {});
  if (!broken) return 0;
  std::fprintf(stderr, "broken law: %s: %s\n", broken->law.c_str(), broken->what.c_str());
  std::abort();
}
