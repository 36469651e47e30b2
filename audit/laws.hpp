// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/audit/document.hpp>
#include <string>
#include <vector>

namespace limpet::audit {

/// A law that every model must satisfy: a short name that never changes, and one line that says what it
/// demands.
struct Law {
  std::string name;
  std::string statement;
};

/// All laws.
const std::vector<Law>& laws();

struct Violation {
  std::string law;    ///< the name of a law
  std::string where;  ///< e.g. "segment 7 cycle 0 vertex 12"
  std::string what;
};

/// Checks a model against all laws, from the definitions alone and in exact arithmetic. Empty: no law is
/// broken. Where one broken law leaves another without meaning (the orientation of a perimeter that crosses
/// itself), only the first is reported.
std::vector<Violation> judge(const Document& document);

}  // namespace limpet::audit
