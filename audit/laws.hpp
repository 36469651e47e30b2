// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/audit/document.hpp>
#include <string>
#include <vector>

namespace limpet::audit {

/// A law has a short name that never changes, and one line that says what it demands.
struct Law {
  std::string name;
  std::string statement;
};

/// All laws, in the order they are judged.
const std::vector<Law>& laws();

struct Violation {
  std::string law;    ///< the name of a law
  std::string where;  ///< e.g. "segment 7 cycle 0 vertex 12"
  std::string what;
};

/// Judges a model from the definitions alone, exactly. Empty: nothing is broken.
/// A law that another broken law leaves without meaning (the area of a perimeter that crosses itself) is not
/// judged there, so that what is named is what is wrong.
std::vector<Violation> judge(const Document& document);

}  // namespace limpet::audit
