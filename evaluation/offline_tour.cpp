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

constexpr double kSquare = 2;     // in λ: the size of the squares that readings are counted in
constexpr double kLinking = 0.9;  // in λ: how near a reading must be

using Square = std::array<int, 3>;  // a face, and where on it

/// Square grids on the faces.
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

struct Stand {
  Vector3d at;
  std::vector<simulation::RayCaster::Hit> readings;
};

/// Places for candidates: on the offset surface, and beside the samples that it is too narrow for.
std::vector<Vector3d> places_of(const FreeSpace& space, const Reachability& truth,
                                const TourOptions& options) {
  std::vector<Vector3d> places = space.places_at(options.follow_distance);
  // Every k-th sample of a low-discrepancy sequence is spread as evenly, √k times as far apart.
  const double ratio = options.resolution / (2 * truth.spacing);
  const std::size_t stride = static_cast<std::size_t>(std::max(1.0, std::floor(ratio * ratio + 0.5)));
  for (std::size_t i = 0; i < truth.samples.size(); i += stride) {
    if (truth.verdicts[i] != Verdict::yes) continue;
    const Vector3d above = truth.samples[i].at + options.follow_distance * truth.samples[i].normal;
    if (space.holds(above) != Verdict::yes) places.push_back(truth.seen_from[i]);
  }
  return places;
}

std::vector<Stand> candidates_of(const simulation::Mesh& mesh, const std::vector<Vector3d>& places,
                                 const Sensing& sensing) {
  const simulation::RayCaster caster(mesh);
  std::vector<Stand> candidates;
  for (const Vector3d& place : places) {
    Stand& candidate = candidates.emplace_back(Stand{place, {}});
    for (const Vector3d& axis : sensing.axes)
      if (const auto hit = caster.first_hit(place, axis); hit && hit->range <= sensing.range)
        candidate.readings.push_back(*hit);
  }
  return candidates;
}

/// The squares as items of a cover, each with the number of readings it asks for.
struct SquareDemand {
  std::map<Square, std::size_t> index;
  std::vector<int> readings;
};

SquareDemand demand_of(const Reachability& truth, const Squares& squares, const TourOptions& options) {
  std::map<Square, double> area;
  for (std::size_t i = 0; i < truth.samples.size(); ++i)
    if (truth.verdicts[i] == Verdict::yes)
      area[squares.of(truth.samples[i].face, truth.samples[i].at)] += truth.samples[i].area;
  SquareDemand demand;
  for (const auto& [square, reachable] : area) {
    demand.index.emplace(square, demand.readings.size());
    const double asked = options.density * reachable / (options.resolution * options.resolution);
    demand.readings.push_back(static_cast<int>(std::floor(asked + 0.5)));
  }
  return demand;
}

Offers offers_of(const std::vector<Stand>& candidates, const SquareDemand& demand, const Squares& squares) {
  Offers offers;
  for (const Stand& candidate : candidates) {
    auto& offer = offers.emplace_back();
    for (const auto& reading : candidate.readings)
      if (const auto found = demand.index.find(squares.of(reading.face, reading.position));
          found != demand.index.end())
        offer.push_back(found->second);
  }
  return offers;
}

/// Reachable samples, and which of them have a reading near enough.
class Links {
 public:
  Links(const Reachability& truth, const Squares& squares, double resolution)
      : truth_(truth), squares_(squares), reach_(kLinking * resolution), linked_(truth.samples.size(), 0) {
    for (std::size_t i = 0; i < truth.samples.size(); ++i)
      if (truth.verdicts[i] == Verdict::yes)
        in_[squares.of(truth.samples[i].face, truth.samples[i].at)].push_back(i);
  }

  /// The samples that a candidate's readings would link and that are not linked.
  std::vector<std::size_t> offered_by(const Stand& candidate) const {
    std::vector<std::size_t> offered;
    for (const auto& reading : candidate.readings) add_offered(reading, offered);
    std::sort(offered.begin(), offered.end());
    offered.erase(std::unique(offered.begin(), offered.end()), offered.end());
    return offered;
  }

  void link(const Stand& candidate) {
    for (const std::size_t i : offered_by(candidate)) linked_[i] = 1;
  }

  /// Share of the reachable area that is not linked.
  double lacking() const {
    double all = 0, missed = 0;
    for (const auto& [square, samples] : in_)
      for (const std::size_t i : samples) {
        all += truth_.samples[i].area;
        if (!linked_[i]) missed += truth_.samples[i].area;
      }
    return all > 0 ? missed / all : 0;
  }

 private:
  void add_offered(const simulation::RayCaster::Hit& reading, std::vector<std::size_t>& offered) const {
    const auto [face, x, y] = squares_.of(reading.face, reading.position);
    for (int k = 0; k < 9; ++k) {
      const auto square = in_.find({face, x + k % 3 - 1, y + k / 3 - 1});
      if (square == in_.end()) continue;
      for (const std::size_t i : square->second)
        if (!linked_[i] && (truth_.samples[i].at - reading.position).norm() <= reach_) offered.push_back(i);
    }
  }

  const Reachability& truth_;
  const Squares& squares_;
  double reach_;
  std::vector<char> linked_;
  std::map<Square, std::vector<std::size_t>> in_;
};

/// Adds candidates until all samples that can be are linked.
void add_links(const std::vector<Stand>& candidates, Links& links, std::size_t samples,
               std::vector<std::size_t>& chosen) {
  for (const std::size_t i : chosen) links.link(candidates[i]);
  Offers offers;
  for (const Stand& candidate : candidates) offers.push_back(links.offered_by(candidate));
  for (const std::size_t i : greedy_cover(offers, std::vector<int>(samples, 1))) {
    links.link(candidates[i]);
    chosen.push_back(i);
  }
}

/// Puts the start first; one that is too near to the surface to be left straight gives way to the place that
/// is nearest to it.
void begin_at(const Vector3d& start, const FreeSpace& space, std::vector<Vector3d>& places) {
  if (places.empty() || space.holds(start) == Verdict::yes) {
    places.insert(places.begin(), start);
    return;
  }
  const auto nearer = [&](const Vector3d& a, const Vector3d& b) {
    return (a - start).squaredNorm() < (b - start).squaredNorm();
  };
  std::iter_swap(places.begin(), std::min_element(places.begin(), places.end(), nearer));
}

void travel(OfflineTour& result, const std::vector<Vector3d>& places, const TrueSurface& truth,
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
  const Squares squares(faces, kSquare * options.resolution);
  const std::vector<Stand> candidates = candidates_of(mesh, places_of(space, reachability, options), sensing);
  const SquareDemand demand = demand_of(reachability, squares, options);
  std::vector<std::size_t> chosen = greedy_cover(offers_of(candidates, demand, squares), demand.readings);
  Links links(reachability, squares, options.resolution);
  add_links(candidates, links, reachability.samples.size(), chosen);

  OfflineTour result;
  result.sets = chosen.size();
  result.unlinked = links.lacking();
  std::vector<Vector3d> places;
  for (const std::size_t i : chosen) places.push_back(candidates[i].at);
  begin_at(options.start, space, places);
  travel(result, places, truth, space, options.max_step);
  return result;
}

}  // namespace limpet::evaluation
