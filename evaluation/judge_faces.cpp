// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/region.hpp>
#include <optional>
#include <stdexcept>

namespace limpet::evaluation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Positions = std::vector<Vector3d>;

std::vector<Positions> by_face(std::span<const simulation::LabelledPoint> points, int faces,
                               std::int64_t& outliers) {
  std::vector<Positions> sorted(faces);
  for (const simulation::LabelledPoint& point : points) {
    if (point.face >= faces) throw std::invalid_argument("a point of a face the truth does not have");
    if (point.face < 0)
      ++outliers;
    else
      sorted[point.face].push_back(point.point.position);
  }
  return sorted;
}

struct Plane {
  Vector3d centroid, normal;
  double standard_error = 0;  ///< of the normal
};

/// The least-squares plane of points, its normal on the side of `outward`; none for fewer than three points.
std::optional<Plane> fitted(const Positions& points, const Vector3d& outward, double noise) {
  if (points.size() < 3) return std::nullopt;
  const double m = static_cast<double>(points.size());
  const Vector3d& near = points.front();  // centring twice loses nothing to a far origin
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p - near;
  mean = near + mean / m;
  Matrix3d covariance = Matrix3d::Zero();
  for (const Vector3d& p : points) covariance += (p - mean) * (p - mean).transpose() / m;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solved(covariance);
  const Vector3d spread = solved.eigenvalues().cwiseMax(0.0);  // ascending
  Plane plane{mean, solved.eigenvectors().col(0), 0};
  if (plane.normal.dot(outward) < 0) plane.normal = -plane.normal;
  const double sigma = noise > 0 ? noise : std::sqrt(spread[0]);
  plane.standard_error = spread[1] > 0 ? sigma / std::sqrt(m * spread[1]) : 0;
  return plane;
}

/// How far points are, in the plane of the region, from its area.
double farthest(const Positions& points, const Region& from) {
  double result = 0;
  for (const Vector3d& p : points) result = std::max(result, from.surface.distance(from.foot(p)));
  return result;
}

void measure(PolygonJudgement& judgement, const Region& polygon, const Region& truth, const Positions& points,
             const JudgeOptions& options) {
  judgement.true_angle = angle_between(polygon.face.normal, truth.face.normal);
  if (const auto plane = fitted(points, truth.face.normal, options.noise)) {
    judgement.angle = angle_between(polygon.face.normal, plane->normal);
    judgement.standard_error = plane->standard_error;
    judgement.offset = (polygon.foot(plane->centroid) - plane->centroid).dot(plane->normal);
  }
  judgement.overshoot = farthest(along_boundary(polygon.face, options.resolution / 4), truth);
  judgement.shortfall = farthest(along_boundary(truth.face, options.resolution / 4), polygon);
  judgement.unreached = farthest(points, polygon);
}

int holes(const PlanarFace& face) { return std::max(0, static_cast<int>(face.cycles.size()) - 1); }

void sum_up(FacesReport& report) {
  for (const FaceJudgement& face : report.faces) {
    if (!face.counts) continue;
    ++report.counted;
    if (face.fate == Fate::merged) ++report.merged;
    if (face.fate == Fate::missed) ++report.missed;
    if (face.fate == Fate::split) ++report.split;
    if (face.polygons.empty()) continue;
    ++report.represented;
    if (face.model_holes != face.true_holes) ++report.wrong_holes;
    const PolygonJudgement& polygon = report.polygons[face.polygons.front()];
    report.max_angle = std::max(report.max_angle, polygon.angle);
    report.max_overshoot = std::max(report.max_overshoot, polygon.overshoot);
    report.max_shortfall = std::max(report.max_shortfall, polygon.shortfall);
    report.max_unreached = std::max(report.max_unreached, polygon.unreached);
    if (polygon.standard_error > 0)
      report.max_angle_excess = std::max(report.max_angle_excess, polygon.angle / polygon.standard_error);
  }
  for (const PolygonJudgement& polygon : report.polygons) {
    if (polygon.extra) ++report.extra;
    if (polygon.face < 0) ++report.unmatched;
  }
}

double width(const Region& region) {
  double diameter2 = 0;
  for (const Eigen::Vector3d& p : region.face.cycles.front())
    for (const Eigen::Vector3d& q : region.face.cycles.front())
      diameter2 = std::max(diameter2, (p - q).squaredNorm());
  return region.area / std::sqrt(diameter2);
}

}  // namespace

FacesReport judge_faces(const std::vector<PlanarFace>& model, const simulation::Mesh& truth,
                        std::span<const simulation::LabelledPoint> points, const JudgeOptions& options) {
  if (!(options.resolution > 0)) throw std::invalid_argument("judging needs a linear resolution above zero");
  FacesReport report;
  const std::vector<Positions> points_of = by_face(points, truth.face_count, report.outliers);
  const std::vector<Region> true_regions = regions(planar_faces(truth)), polygons = regions(model);

  report.faces.resize(true_regions.size());
  for (int f = 0; f < static_cast<int>(true_regions.size()); ++f) {
    FaceJudgement& face = report.faces[f];
    face.face = f;
    face.points = static_cast<std::int64_t>(points_of[f].size());
    face.density =
        static_cast<double>(face.points) * options.resolution * options.resolution / true_regions[f].area;
    face.counts = face.points >= options.min_points && face.density >= options.min_density &&
                  width(true_regions[f]) >= options.min_width;
    face.true_holes = holes(true_regions[f].face);
  }

  const std::vector<int> match = matches(polygons, true_regions, options.resolution, options.max_angle_rad);
  for (int p = 0; p < static_cast<int>(polygons.size()); ++p) {
    report.polygons.push_back({.polygon = p, .face = match[p], .extra = true});
    if (match[p] >= 0) report.faces[match[p]].polygons.push_back(p);
  }
  for (FaceJudgement& face : report.faces) {
    std::stable_sort(face.polygons.begin(), face.polygons.end(),
                     [&](int a, int b) { return polygons[a].area > polygons[b].area; });
    const Region& true_region = true_regions[face.face];
    if (face.polygons.empty()) {
      const double share = covered_share(true_region, polygons, options.resolution, options.max_angle_rad);
      face.fate = share >= 0.5 ? Fate::merged : Fate::missed;
      continue;
    }
    face.fate = face.polygons.size() == 1 ? Fate::represented : Fate::split;
    const int largest = face.polygons.front();
    face.model_holes = holes(model[largest]);
    report.polygons[largest].extra = false;
    measure(report.polygons[largest], polygons[largest], true_region, points_of[face.face], options);
  }
  sum_up(report);
  return report;
}

std::vector<std::string> faults(const FacesReport& report, const std::vector<PlanarFace>& model) {
  std::vector<std::string> lines;
  for (const FaceJudgement& face : report.faces) {
    if (!face.counts) continue;
    const std::string name = "face " + std::to_string(face.face) + ": ";
    if (face.fate == Fate::missed) lines.push_back(name + "missed");
    if (face.fate == Fate::merged) lines.push_back(name + "merged into another face's polygon");
    if (face.fate == Fate::split)
      lines.push_back(name + "split into " + std::to_string(face.polygons.size()));
    if (!face.polygons.empty() && face.model_holes != face.true_holes)
      lines.push_back(name + std::to_string(face.model_holes) + " holes for " +
                      std::to_string(face.true_holes));
  }
  for (const PolygonJudgement& polygon : report.polygons) {
    if (!polygon.extra) continue;
    lines.push_back("polygon " + std::to_string(model[polygon.polygon].id) + ": " +
                    (polygon.face < 0 ? "on no face" : "second on face " + std::to_string(polygon.face)));
  }
  return lines;
}

}  // namespace limpet::evaluation
