// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "engine_internal.hpp"

/// What readings say of where no surface is (rule `rays`).
namespace limpet::model::internal {

/// Notes, with each polygon whose plane the reading has passed near it, where. Nothing without a range. It
/// has to come from one side of the plane and lie on the other, farther from it than noise and tolerance can
/// bring it.
void note_passages(Engine&, const RawPoint&, double range);
/// Deletes the polygons that so many readings of the set have passed through, with those before, that they
/// are no surface. Their points go to polygons that they fit, or are given up.
void delete_passed(Engine&);

}  // namespace limpet::model::internal
