// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/follow_run.hpp>
#include <limpet/app/summary.hpp>
#include <limpet/evaluation/link_clearance.hpp>
#include <limpet/evaluation/run_judgement.hpp>
#include <optional>
#include <string>

namespace limpet::app {

/// What `limpet follow` says of a run.
struct FollowSummary {
  Summary model;
  FollowOutcome run;
  std::optional<evaluation::RunJudgement> truth;   ///< where the true surface is known
  std::optional<evaluation::LinkClearance> links;  ///< and the robot has some
  bool has_switches = false;                       ///< are its links covered with proximity switches?
  double seconds = 0;
};

std::string to_json(const FollowSummary&);
/// For people, in a few lines.
std::string to_text(const FollowSummary&);

}  // namespace limpet::app
