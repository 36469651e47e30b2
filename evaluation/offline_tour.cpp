// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/offline_tour.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limpet/evaluation/greedy_cover.hpp>
#include <limpet/evaluation/short_tour.hpp>
#include <limpet/simulation/ray_caster.hpp>
#include <map>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;

constexpr double kReadings = 3;   // per λ²
constexpr double kLinking = 0.9;  // in λ: how near a reading must be

using Square = std::array<int, 3>;  // a face, and where on it

/// Square grids of pitch λ on the faces.
class Squares {
 public:
  Squares(const std::vector<simulation::Face>& faces, double pitch) : faces_(faces), pitch_(pitch) {}

  Square of(int face, const Vector3d& at) const {
    const simulation::Face& plane = faces_[static_cast<std::size_t>(face)];
    const Vector3d u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u), p = at - plane.centroid;
    return {face, static_cast<int>(std::floor(p.dot(u) / pitch_)),
            static_cast<int>(std::floor(p.dot(v) / pitch_))};
  }

 private:
  const std::vector<simulation::Face>& faces_;
  double pitch_;
};

struct Candidate {
  Vector3d at;
  std::vector<simulation::RayCaster::Hit> readings;
};

std::vector<Candidate> candidates_of(const simulation::Mesh& mesh, const FreeSpace& space,
                                     const Reachability& truth, const Sensing& sensing,
                                     const TourOptions& options) {
  const simulation::RayCaster caster(mesh);
  std::vector<Candidate> candidates;
  // Every k-th sample of a low-discrepancy sequence is spread as evenly, √k times as far apart.
  const double ratio = options.resolution / (2 * truth.spacing);
  const std::size_t stride = static_cast<std::size_t>(std::max(1.0, std::floor(ratio * ratio + 0.5)));
  for (std::size_t i = 0; i < truth.samples.size(); i += stride) {
    if (truth.verdicts[i] != Verdict::yes) continue;
    Candidate& candidate = candidates.emplace_back();
    candidate.at = truth.samples[i].at + options.follow_distance * truth.samples[i].normal;
    if (space.holds(candidate.at) != Verdict::yes) candidate.at = truth.seen_from[i];
    for (const Vector3d& axis : sensing.axes)
      if (const auto hit = caster.first_hit(candidate.at, axis); hit && hit->range <= sensing.range)
        candidate.readings.push_back(*hit);
  }
  return candidates;
}

/// The squares as items of a cover, each with the number of readings it asks for.
struct SquareDemand {
  std::map<Square, std::size_t> index;
  std::vector<int> readings;
};

SquareDemand demand_of(const Reachability& truth, const Squares& squares, double resolution) {
  std::map<Square, double> area;
  for (std::size_t i = 0; i < truth.samples.size(); ++i)
    if (truth.verdicts[i] == Verdict::yes)
      area[squares.of(truth.samples[i].face, truth.samples[i].at)] += truth.samples[i].area;
  SquareDemand demand;
  for (const auto& [square, reachable] : area) {
    demand.index.emplace(square, demand.readings.size());
    demand.readings.push_back(
        static_cast<int>(std::floor(kReadings * reachable / (resolution * resolution) + 0.5)));
  }
  return demand;
}

Offers offers_of(const std::vector<Candidate>& candidates, const SquareDemand& demand,
                 const Squares& squares) {
  Offers offers;
  for (const Candidate& candidate : candidates) {
    auto& offer = offers.emplace_back();
    for (const auto& reading : candidate.readings)
      if (const auto found = demand.index.find(squares.of(reading.face, reading.position));
          found != demand.index.end())
        offer.push_back(found->second);
  }
  return offers;
}

/// Reachable samples that no reading is near enough to yet, by square.
class Unlinked {
 public:
  Unlinked(const Reachability& truth, const Squares& squares, double resolution)
      : truth_(truth), squares_(squares), reach_(kLinking * resolution) {
    for (std::size_t i = 0; i < truth.samples.size(); ++i)
      if (truth.verdicts[i] == Verdict::yes)
        in_[squares.of(truth.samples[i].face, truth.samples[i].at)].push_back(i);
  }

  /// The samples that a candidate's readings link.
  std::vector<std::size_t> linked_by(const Candidate& candidate) const {
    std::vector<std::size_t> linked;
    for (const auto& reading : candidate.readings) {
      const auto [face, x, y] = squares_.of(reading.face, reading.position);
      for (int k = 0; k < 9; ++k) {
        const auto square = in_.find({face, x + k % 3 - 1, y + k / 3 - 1});
        if (square == in_.end()) continue;
        for (const std::size_t i : square->second)
          if ((truth_.samples[i].at - reading.position).norm() <= reach_) linked.push_back(i);
      }
    }
    std::sort(linked.begin(), linked.end());
    linked.erase(std::unique(linked.begin(), linked.end()), linked.end());
    return linked;
  }

  void link(const Candidate& candidate) {
    const std::vector<std::size_t> linked = linked_by(candidate);
    for (auto& [square, samples] : in_)
      std::erase_if(samples,
                    [&](std::size_t i) { return std::binary_search(linked.begin(), linked.end(), i); });
  }

  double area() const {
    double sum = 0;
    for (const auto& [square, samples] : in_)
      for (const std::size_t i : samples) sum += truth_.samples[i].area;
    return sum;
  }

 private:
  const Reachability& truth_;
  const Squares& squares_;
  double reach_;
  std::map<Square, std::vector<std::size_t>> in_;
};

/// Adds candidates until all samples that can be are linked.
void add_links(const std::vector<Candidate>& candidates, Unlinked& unlinked, std::size_t samples,
               std::vector<std::size_t>& chosen) {
  for (const std::size_t i : chosen) unlinked.link(candidates[i]);
  Offers offers;
  for (const Candidate& candidate : candidates) offers.push_back(unlinked.linked_by(candidate));
  for (const std::size_t i : greedy_cover(offers, std::vector<int>(samples, 1))) {
    unlinked.link(candidates[i]);
    chosen.push_back(i);
  }
}

void travel(OfflineTour& result, std::vector<Vector3d> places, const TrueSurface& truth,
            const FreeSpace& space, double max_step) {
  const ShortTour tour = short_tour(places, truth, space);
  for (const std::size_t i : tour.order) result.positions.push_back(places[i]);
  for (const double leg : tour.legs) {
    result.path_length += leg;
    result.transit_steps += static_cast<std::size_t>(std::max(0.0, std::ceil(leg / max_step - 1e-9) - 1));
  }
}

}  // namespace

OfflineTour offline_tour(const simulation::Mesh& mesh, const TrueSurface& truth, const FreeSpace& space,
                         const Reachability& reachability, const Sensing& sensing,
                         const TourOptions& options) {
  const std::vector<simulation::Face> faces = simulation::faces_of(mesh);
  const Squares squares(faces, options.resolution);
  const std::vector<Candidate> candidates = candidates_of(mesh, space, reachability, sensing, options);
  const SquareDemand demand = demand_of(reachability, squares, options.resolution);
  std::vector<std::size_t> chosen = greedy_cover(offers_of(candidates, demand, squares), demand.readings);
  Unlinked unlinked(reachability, squares, options.resolution);
  add_links(candidates, unlinked, reachability.samples.size(), chosen);

  OfflineTour result;
  result.sets = chosen.size();
  std::vector<Vector3d> places{options.start};
  for (const std::size_t i : chosen) places.push_back(candidates[i].at);
  travel(result, std::move(places), truth, space, options.max_step);
  double reachable = 0;
  for (std::size_t i = 0; i < reachability.samples.size(); ++i)
    if (reachability.verdicts[i] == Verdict::yes) reachable += reachability.samples[i].area;
  if (reachable > 0) result.unlinked = unlinked.area() / reachable;
  return result;
}

}  // namespace limpet::evaluation
