// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limpet/evaluation/empty_disc_internal.hpp>
#include <numbers>

namespace limpet::evaluation {
namespace {

using Eigen::Vector2d;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;

Vector2d vector(const Kernel::Point_2& p) { return {p.x(), p.y()}; }

/// Where the largest disc may be, and no more readings than `most` are expected in it.
struct Candidate {
  Vector2d centre;
  double radius, density, most;
  bool on_perimeter;
  bool operator<(const Candidate& other) const { return most < other.most; }
};

Candidate candidate(const Vector2d& centre, double radius, double density, bool on_perimeter) {
  return {centre, radius, density, density * std::numbers::pi * radius * radius, on_perimeter};
}

}  // namespace

struct EmptyDiscs::Inside {
  Delaunay triangles;
  const FlatPolygon& polygon;
  const LocalDensity& density;

  void add_circumcentres(std::vector<Candidate>& candidates) const {
    if (triangles.dimension() < 2) return;
    for (auto face = triangles.finite_faces_begin(); face != triangles.finite_faces_end(); ++face) {
      const Vector2d centre = vector(triangles.circumcenter(face)), rim = vector(face->vertex(0)->point());
      if (!centre.allFinite()) continue;
      double least = density.at(rim);
      for (int k = 1; k < 3; ++k) least = std::min(least, density.at(vector(face->vertex(k)->point())));
      candidates.push_back(candidate(centre, (centre - rim).norm(), least, false));
    }
  }

  void add_perimeter(const std::vector<Vector2d>& places, std::vector<Candidate>& candidates) const {
    for (const Vector2d& place : places) {
      const Vector2d rim = nearest(place);
      candidates.push_back(candidate(place, (place - rim).norm(), density.at(rim), true));
    }
  }

  FlatDisc disc(const Candidate& found, const Excuse& excuse) const {
    const double area = polygon.area_within(found.centre, found.radius);
    const double share = area / (std::numbers::pi * found.radius * found.radius);
    return {found.centre, found.radius, found.density * area,
            excuse.holds(found.centre, found.radius, share)};
  }

  Vector2d nearest(const Vector2d& place) const {
    return vector(triangles.nearest_vertex({place.x(), place.y()})->point());
  }
};

EmptyDiscs::EmptyDiscs(const std::vector<Vector2d>& readings, const FlatPolygon& polygon,
                       const LocalDensity& density)
    : inside_(new Inside{{}, polygon, density}) {
  std::vector<Kernel::Point_2> points;
  points.reserve(readings.size());
  for (const Vector2d& reading : readings) points.emplace_back(reading.x(), reading.y());
  inside_->triangles.insert(points.begin(), points.end());
}

EmptyDiscs::~EmptyDiscs() = default;
EmptyDiscs::EmptyDiscs(EmptyDiscs&&) noexcept = default;
EmptyDiscs& EmptyDiscs::operator=(EmptyDiscs&&) noexcept = default;

FlatDisc EmptyDiscs::emptiest(const std::vector<Vector2d>& perimeter, const Excuse& excuse) const {
  std::vector<Candidate> candidates;
  inside_->add_circumcentres(candidates);
  inside_->add_perimeter(perimeter, candidates);
  // The most promising first: what a disc has inside the polygon is asked of few.
  std::make_heap(candidates.begin(), candidates.end());
  FlatDisc best;
  double most = 0;  // readings that the best one counts for
  while (!candidates.empty() && candidates.front().most > most) {
    std::pop_heap(candidates.begin(), candidates.end());
    const Candidate next = candidates.back();
    candidates.pop_back();
    if (!next.on_perimeter && !inside_->polygon.inside(next.centre)) continue;
    const FlatDisc disc = inside_->disc(next, excuse);
    const double counts = disc.excused ? std::min(disc.expected, excuse.chance()) : disc.expected;
    if (counts > most) best = disc, most = counts;
  }
  return best;
}

Vector2d EmptyDiscs::nearest(const Vector2d& place) const { return inside_->nearest(place); }

}  // namespace limpet::evaluation
