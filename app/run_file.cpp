// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/run_file.hpp>

#include <charconv>
#include <cmath>

namespace limpet::app {

model::Model model_before(const RunHead& head) {
  model::Model model(head.model);
  model.add_initial(head.initial);
  return model;
}

std::string hexadecimal(double x) {
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  char digits[40];
  const auto end = std::to_chars(digits, digits + sizeof digits, std::abs(x), std::chars_format::hex).ptr;
  return (std::signbit(x) ? "-0x" : "0x") + std::string(digits, end);
}

}  // namespace limpet::app
