// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/follow_run.hpp>
#include <limpet/app/follow_setup.hpp>
#include <limpet/evaluation/link_clearance.hpp>
#include <limpet/evaluation/run_judgement.hpp>
#include <limpet/model/model.hpp>
#include <optional>

namespace limpet::app {

/// Judges a run by the mesh that it took place over. `model` is that of the run, finished. `with_tour`:
/// compare a point robot's with an offline tour, too, which takes longer than all the rest. An arm's is
/// judged by what an arm could feel, which may take tens of seconds: `progress` is told of each search.
/// Precondition: the true surface is known (BuiltWorld::truth).
evaluation::RunJudgement judge_by_truth(const FollowSetup&, const FollowOutcome&, const model::Model& model,
                                        bool with_tour = false,
                                        const evaluation::SearchProgress& progress = {});

/// How near the links of a robot that has some truly came to the surface and to each other; none: it has
/// none, or the truth is not known.
std::optional<evaluation::LinkClearance> judge_links(const FollowSetup&, const FollowOutcome&);

}  // namespace limpet::app
