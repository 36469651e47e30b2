// Copyright the limpet authors. GPL-3.0-or-later.
//
// A coverage-guided fuzzer of one kind of input; LIMPET_FUZZ_KIND says which. A broken law ends it like a
// crash; the input, which libFuzzer keeps, becomes a case by `limpet_case show`.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "../cases/any_case.hpp"
#include "tokens.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto broken =
      limpet::cases::broken_law_of_bytes(LIMPET_FUZZ_KIND, {data, size}, [](const std::string&) {});
  if (!broken) return 0;
  std::fprintf(stderr, "broken law: %s: %s\n", broken->law.c_str(), broken->what.c_str());
  std::abort();
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// Text is mostly changed as text.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  const std::string text(data, data + size);
  const bool printable = text.find_first_not_of(
                             "\n\r\t !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`"
                             "abcdefghijklmnopqrstuvwxyz{|}~",
                             1) == std::string::npos;
  if (size < 8 || !printable || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string changed = limpet::fuzz::TokenMutator(seed)(text);
  const std::size_t length = std::min(changed.size(), most);
  std::memcpy(data, changed.data(), length);
  return length;
}
