// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/reachable.hpp>

#include <algorithm>
#include <cmath>
#include <limpet/evaluation/reachable_internal.hpp>
#include <limpet/evaluation/region.hpp>
#include <stdexcept>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;

constexpr double kLift = 1e-9;  // off the surface, as a fraction of the range, before one looks along a ray
constexpr double kLeastStep = 1.0 / 16;  // along a ray, in pitches of the lattice

/// The axes that meet a face from outside, the steepest first: it most often sees.
std::vector<Vector3d> axes_onto(const Vector3d& normal, const Sensing& sensing) {
  std::vector<Vector3d> onto;
  for (const Vector3d& axis : sensing.axes)
    if (axis.dot(normal) <= -sensing.least_cosine) onto.push_back(axis);
  std::stable_sort(onto.begin(), onto.end(),
                   [&](const Vector3d& a, const Vector3d& b) { return a.dot(normal) < b.dot(normal); });
  return onto;
}

class Search {
 public:
  Search(const TrueSurface& truth, const FreeSpace& space, double range)
      : truth_(truth), space_(space), range_(range) {}

  /// Looks for a place that sees `at` along one of the axes, and leaves it in `from`.
  Verdict sighted(const Vector3d& at, const Vector3d& normal, const std::vector<Vector3d>& axes,
                  Vector3d& from) const {
    Verdict best = Verdict::no;
    for (const Vector3d& axis : axes) {
      const double begin = past_ruled_out(at, axis, space_.clearance());
      if (begin > range_) continue;
      const double end = in_sight(at, axis);
      const double guess =
          space_.clearance() / -axis.dot(normal) + space_.pitch();  // if nothing else is near
      if (guess <= end && is_held(at, axis, guess, from)) return Verdict::yes;
      best = std::max(best, sighted_along(at, axis, begin, end, from));
      if (best == Verdict::yes) break;
    }
    return best;
  }

 private:
  /// The first t, from this one on, at which the lattice does not rule out that the robot gets there; more
  /// than the range: there is none.
  double past_ruled_out(const Vector3d& at, const Vector3d& axis, double t) const {
    while (t <= range_) {
      const double further = space_.ruled_out(at - t * axis, -axis);
      if (further == 0) break;
      t += further;
    }
    return t;
  }

  /// How far from `at` nothing is in the way, as far as the range.
  double in_sight(const Vector3d& at, const Vector3d& axis) const {
    const double lift = kLift * range_;
    return std::min(range_, truth_.first_crossing(at - lift * axis, -axis).value_or(range_) + lift);
  }

  bool is_held(const Vector3d& at, const Vector3d& axis, double t, Vector3d& from) const {
    from = at - t * axis;
    return space_.holds(from) == Verdict::yes;
  }

  Verdict sighted_along(const Vector3d& at, const Vector3d& axis, double begin, double end,
                        Vector3d& from) const {
    Verdict best = Verdict::no;
    for (double t = begin; t <= end; t = past_ruled_out(at, axis, t)) {
      from = at - t * axis;
      const double over = truth_.distance(from) - space_.clearance();
      const Verdict here = over >= 0 ? space_.connects(from) : Verdict::no;
      best = std::max(best, here);
      if (best == Verdict::yes || t == end) break;
      // No nearer than by what it lacks or has over can a place be of another kind: the distance changes no
      // faster than t, and what keeps the clearance without a break hangs together.
      const double sure = here == Verdict::doubtful ? 0 : std::abs(over);
      if (sure < kLeastStep * space_.pitch()) best = Verdict::doubtful;
      t = std::min(end, t + std::max(sure, kLeastStep * space_.pitch()));
    }
    return best;
  }

  const TrueSurface& truth_;
  const FreeSpace& space_;
  double range_;
};

}  // namespace

std::vector<SurfaceSample> samples_of(const simulation::Mesh& mesh, double spacing) {
  std::vector<SurfaceSample> samples;
  const std::vector<simulation::Face> faces = simulation::faces_of(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<Triangle3> triangles;
    for (const int t : faces[f].triangles) {
      const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(t)];
      triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
    const int count = std::max(1, static_cast<int>(std::ceil(faces[f].area / (spacing * spacing))));
    for (const Vector3d& at : spread_over(triangles, count))
      samples.push_back({at, faces[f].normal, static_cast<int>(f), faces[f].area / count});
  }
  return samples;
}

Sensing sensing_of(const kinematics::Posture& posture) {
  Sensing sensing;
  for (std::size_t i = 0; i < posture.robot().sensors.size(); ++i) {
    const auto sensor = posture.sensor(i);
    if ((sensor.position - posture.control_point()).norm() > 1e-9)
      throw std::invalid_argument("sensor " + std::to_string(i) + " is not at the control point");
    if (i > 0 && sensor.range != sensing.range)
      throw std::invalid_argument("the ranges of the sensors differ");
    sensing.axes.push_back(sensor.axis);
    sensing.range = sensor.range;
  }
  if (sensing.axes.empty()) throw std::invalid_argument("the robot has no sensors");
  return sensing;
}

Reachability find_reachable(const simulation::Mesh& mesh, const TrueSurface& truth, const FreeSpace& space,
                            const Sensing& sensing, double spacing) {
  Reachability result;
  result.samples = samples_of(mesh, spacing);
  result.spacing = spacing;
  result.faces.resize(static_cast<std::size_t>(mesh.face_count));
  const Search search(truth, space, sensing.range);
  std::vector<Vector3d> axes;
  int face = -1;
  for (const SurfaceSample& sample : result.samples) {
    if (sample.face != face) axes = axes_onto(sample.normal, sensing);
    face = sample.face;
    Vector3d from;
    result.verdicts.push_back(search.sighted(sample.at, sample.normal, axes, from));
    result.seen_from.push_back(result.verdicts.back() == Verdict::yes ? from : sample.at);
  }
  sum_up(result);
  return result;
}

void sum_up(Reachability& result) {
  double area = 0;
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const SurfaceSample& sample = result.samples[i];
    Reachability::Face& face = result.faces[static_cast<std::size_t>(sample.face)];
    area += sample.area;
    face.area += sample.area;
    if (result.verdicts[i] == Verdict::yes) result.share += sample.area, face.share += sample.area;
    if (result.verdicts[i] == Verdict::doubtful) result.doubtful += sample.area, face.doubtful += sample.area;
  }
  if (area > 0) result.share /= area, result.doubtful /= area;
  for (Reachability::Face& face : result.faces)
    if (face.area > 0) face.share /= face.area, face.doubtful /= face.area;
}

}  // namespace limpet::evaluation
