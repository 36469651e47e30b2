// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limits>
#include <limpet/evaluation/arm_search_internal.hpp>
#include <limpet/evaluation/out_of_reach_internal.hpp>
#include <utility>

namespace limpet::evaluation {
namespace {

using kinematics::Configuration;
using kinematics::Posture;

constexpr int kRounds = 8;              // over all samples
constexpr std::size_t kMostHints = 10;  // that are tried for a sample in a round
constexpr double kHint = 1.5;           // how far from a sample hints are, in spacings
constexpr std::size_t kNear = 6;        // nodes near a sample that are tried in a round
constexpr int kTries = 15;              // random configurations that are tried in a round
constexpr double kOffSurface = 1.2;     // nearest place of the control point on an axis, in clearances

}  // namespace

ArmSearch::ArmSearch(const ArmSpace& space, ArmPlanner& planner, const std::vector<SurfaceSample>& samples,
                     double spacing, const SightOptions& sight, survey::Random& random)
    : space_(space),
      planner_(planner),
      samples_(samples),
      spacing_(spacing),
      sight_(sight),
      random_(random),
      hints_(samples.size()),
      found_(samples.size()) {
  for (std::size_t i = 0; i < planner.known_count(); ++i) take_hints(true, i);
}

std::optional<ArmSearch::Sighting> ArmSearch::sighting(std::size_t sample) const {
  for (const Sighting& found : found_[sample])
    if (planner_.roadmap().is_reached(found.node)) return found;
  return std::nullopt;
}

void ArmSearch::look_for(const std::vector<char>& wanted, const SearchProgress& progress) {
  const std::int64_t whole =
      kRounds * std::count_if(wanted.begin(), wanted.end(), [](char w) { return w != 0; });
  std::int64_t done = 0;
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (wanted[i] == 0) continue;
      if (progress) progress(done++, whole);
      if (sighting(i)) continue;
      take_hints();
      look_by_hints(i);
      if (round > 0 && !sighting(i)) look_from_near(i, kNear);
      if (round > 1 && !sighting(i)) look_from_anywhere(i, kTries);
    }
}

void ArmSearch::take_hints() {
  for (; hinted_ < planner_.roadmap().size(); ++hinted_) take_hints(false, hinted_);
}

/// Where the sensors meet the surface.
void ArmSearch::take_hints(bool known, std::size_t index) {
  const Posture posture(space_.robot(), known ? planner_.known(index) : planner_.roadmap().at(index));
  for (std::size_t sensor = 0; sensor < space_.robot().sensors.size(); ++sensor) {
    const Posture::Sensor s = posture.sensor(sensor);
    const auto range = space_.truth().first_crossing(s.position, s.axis);
    if (!range || *range > s.range) continue;
    const Eigen::Vector3d at = s.position + *range * s.axis;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (const double off = (samples_[i].at - at).norm(); off < kHint * spacing_)
        hints_[i].push_back({off, known, index, sensor});
  }
}

void ArmSearch::look_by_hints(std::size_t sample) {
  std::vector<Hint>& hints = hints_[sample];
  std::stable_sort(hints.begin(), hints.end(), [](const Hint& a, const Hint& b) { return a.off > b.off; });
  for (std::size_t tried = 0; tried < kMostHints && !hints.empty() && !sighting(sample); ++tried) {
    const Hint hint = hints.back();
    hints.pop_back();
    const Node node = hint.known ? planner_.node_of_known(hint.index) : hint.index;
    look_from(planner_.roadmap().at(node), {node}, hint.sensor, sample, false);
  }
}

void ArmSearch::look_from_near(std::size_t sample, std::size_t count) {
  std::vector<std::pair<double, Node>> near;
  for (Node node = 0; node < planner_.roadmap().size(); ++node) {
    if (!planner_.roadmap().is_reached(node)) continue;
    const Posture posture(space_.robot(), planner_.roadmap().at(node));
    near.emplace_back((posture.control_point() - samples_[sample].at).norm(), node);
  }
  count = std::min(count, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
  for (std::size_t i = 0; i < count && !sighting(sample); ++i) {
    const Configuration at = planner_.roadmap().at(near[i].second);
    look_from(at, {near[i].second}, best_sensor(at, samples_[sample]), sample, true);
  }
}

void ArmSearch::look_from_anywhere(std::size_t sample, int tries) {
  const std::size_t sensors = space_.robot().sensors.size();
  for (int i = 0; i < tries && !sighting(sample); ++i)
    look_from(space_.random(random_), {}, static_cast<std::size_t>(random_.below(sensors)), sample, true);
}

bool ArmSearch::look_from(const Configuration& at, const std::vector<Node>& beside, std::size_t sensor,
                          std::size_t sample, bool search) {
  const auto found = aimed(space_, at, sensor, samples_[sample], nearest_for(sensor), sight_);
  if (!found || !space_.holds(*found)) return false;
  if (!sees(Posture(space_.robot(), *found).sensor(sensor), samples_[sample], space_.truth(), sight_))
    return false;
  found_[sample].push_back({planner_.add(*found, beside, search), sensor});
  return true;
}

std::size_t ArmSearch::best_sensor(const Configuration& at, const SurfaceSample& sample) const {
  const Posture posture(space_.robot(), at);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < space_.robot().sensors.size(); ++i)
    if (const double off = misses_by(posture.sensor(i), sample, nearest_for(i)); off < least)
      least = off, best = i;
  return best;
}

double ArmSearch::nearest_for(std::size_t sensor) const {
  const ArmClearances& clearances = space_.clearances();
  return kOffSurface *
         (is_at_control_point(space_.robot(), sensor) ? clearances.control_point : clearances.links);
}

}  // namespace limpet::evaluation
