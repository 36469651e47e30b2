// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/reachable.hpp>

namespace limpet::evaluation {

/// Fills in the shares, of all and of each face, from samples and verdicts. Precondition: `faces` has as many
/// as the samples' numbers say, and all of it is 0.
void sum_up(Reachability&);

}  // namespace limpet::evaluation
