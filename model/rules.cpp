// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/rules.hpp>

#include <array>
#include <stdexcept>
#include <utility>

namespace limpet::model {
namespace {

constexpr std::array<std::pair<const char*, bool Rules::*>, 21> kRules = {{
    {"promotion", &Rules::promotion}, {"chance", &Rules::chance},     {"patch", &Rules::patch},
    {"arrival", &Rules::arrival},     {"residual", &Rules::residual}, {"relief", &Rules::relief},
    {"best", &Rules::best},           {"dissolve", &Rules::dissolve}, {"strays", &Rules::strays},
    {"refresh", &Rules::refresh},     {"near", &Rules::near},         {"holes", &Rules::holes},
    {"voids", &Rules::voids},         {"spurs", &Rules::spurs},       {"bends", &Rules::bends},
    {"pinches", &Rules::pinches},     {"twins", &Rules::twins},       {"rays", &Rules::rays},
    {"position", &Rules::position},   {"finish", &Rules::finish},     {"expiry", &Rules::expiry},
}};

}  // namespace

Rules Rules::thesis() {
  Rules rules;
  for (const auto& [name, member] : kRules) rules.*member = false;
  return rules;
}

std::vector<std::string> Rules::names() {
  std::vector<std::string> names;
  for (const auto& [name, member] : kRules) names.emplace_back(name);
  return names;
}

Rules Rules::parse(std::string_view text) {
  if (text == "limpet") return {};
  if (text == "thesis") return thesis();
  Rules rules = text.starts_with('-') ? Rules{} : thesis();
  while (!text.empty()) {
    const auto comma = std::min(text.find(','), text.size());
    std::string_view name = text.substr(0, comma);
    text.remove_prefix(std::min(comma + 1, text.size()));
    const bool on = !name.starts_with('-');
    if (!on) name.remove_prefix(1);
    bool known = false;
    for (const auto& [rule, member] : kRules)
      if (name == rule) rules.*member = on, known = true;
    if (known) continue;
    std::string message = "unknown update rule '" + std::string(name) + "'; known are limpet, thesis";
    for (const auto& rule : names()) message += ", " + rule;
    throw std::invalid_argument(message);
  }
  return rules;
}

std::string Rules::to_string() const {
  std::string text;
  for (const auto& [name, member] : kRules)
    if (this->*member) text += (text.empty() ? "" : ",") + std::string(name);
  return text.empty() ? "thesis" : text;
}

}  // namespace limpet::model
