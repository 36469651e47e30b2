// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/follow_judgement.hpp>

#include <Eigen/Geometry>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>
#include <vector>

namespace limpet::app {
namespace {

/// The marks of a run as the judge takes them. `view` is that of the model they were made in.
std::vector<evaluation::GivenUp> given_up(const model::View& view, const following::Marks& marks) {
  std::vector<evaluation::GivenUp> result;
  const auto add = [&](const model::View::Edge& edge) {
    const Eigen::Vector3d normal = view.segment(edge.segment)->plane.normal;
    const Eigen::Vector3d outward = (edge.to - edge.from).cross(normal);
    if (outward.norm() > 0) result.push_back({edge.from, edge.to, outward.normalized()});
  };
  for (const auto* ids : {&marks.unreachable_edges, &marks.unclosable_edges})
    for (const geometry::EdgeId id : *ids)
      if (const auto edge = view.edge(id)) add(*edge);
  std::vector<model::View::Edge> edges;
  for (const model::SegmentId segment : marks.unreachable_segments) {
    view.open_edges(segment, edges);
    for (const auto& edge : edges) add(edge);
  }
  return result;
}

}  // namespace

evaluation::RunJudgement judge_by_truth(const FollowSetup& setup, const FollowOutcome& outcome,
                                        const model::Model& model, bool with_tour,
                                        const evaluation::SearchProgress& progress) {
  evaluation::RunJudgementOptions options;
  options.progress = progress;
  options.resolution = setup.following.resolution;
  options.follow_distance = setup.following.follow_distance;
  options.ceiling = setup.robot.ceilings.prismatic;
  options.tour = with_tour && !setup.links;
  if (setup.links)
    options.arm = evaluation::PlacedArm{setup.robot, setup.configuration, outcome.way,
                                        setup.links->least_distance, setup.links->spared};
  else
    options.sensing = evaluation::sensing_of(kinematics::Posture(setup.robot, setup.configuration));
  return evaluation::judge_run(
      *setup.world.truth, {outcome.path, model.record(), given_up(model.view(), outcome.marks)}, options);
}

std::optional<evaluation::LinkClearance> judge_links(const FollowSetup& setup, const FollowOutcome& outcome) {
  if (!setup.links || !setup.world.truth) return std::nullopt;
  return evaluation::link_clearance(setup.robot, outcome.way, evaluation::TrueSurface(*setup.world.truth),
                                    setup.following.resolution / 5);
}

}  // namespace limpet::app
