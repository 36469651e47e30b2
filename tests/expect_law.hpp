// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "generators/property.hpp"

namespace limpet::properties {

/// Fails with the smallest case found that breaks the law, and its seed; or when too few cases were
/// classified.
template <class Property>
void expect_law(const std::string& law, Cases cases, Property&& property) {
  const std::string broken = check(law, cases, std::forward<Property>(property));
  if (!broken.empty()) ADD_FAILURE() << broken;
}

}  // namespace limpet::properties
