// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/evaluation/planar_face.hpp>
#include <limpet/model/record.hpp>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/scan.hpp>
#include <span>
#include <string>
#include <vector>

namespace limpet::evaluation {

// Judging a model by the truth it was scanned from. Everything here is deterministic: areas and boundaries
// are sampled by fixed sequences. Lengths are in the scan's unit, angles in radians.

// ---- Surface against surface -------------------------------------------------------------------

struct DistanceSummary {
  double max = 0, mean = 0, median = 0, p90 = 0, p99 = 0;
};

struct Comparison {
  DistanceSummary model_to_truth;  ///< over the model's area, and its vertices
  DistanceSummary truth_to_model;  ///< over the truth's area, and its vertices
  std::int64_t polygons = 0, true_faces = 0;
  double model_area = 0, true_area = 0;
};

/// Distances both ways by `samples` points each, spread evenly over the area. All distances are infinite if
/// the model has no area. The normals are not looked at.
Comparison compare(const std::vector<PlanarFace>& model, const simulation::Mesh& truth,
                   int samples = 100'000);

/// How closed a model is: edges that are one of a corresponding pair, and those that are not.
struct Closedness {
  std::int64_t edges = 0, open_edges = 0;
  double length = 0, open_length = 0;
  bool closed() const { return edges > 0 && open_edges == 0; }
};
Closedness closedness(const model::ModelRecord& record);

// ---- Face by face ------------------------------------------------------------------------------

struct JudgeOptions {
  double resolution = 0;  ///< λ
  double noise = 0;       ///< standard deviation along a face's normal; 0: taken from the points of each face
  double max_angle_rad = 0.3490658503988659;  ///< 20°: a polygon that turns more from a face is not of it
  std::int64_t min_points = 50;               ///< a face with fewer points does not count
  double min_density = 4;                     ///< nor does one with fewer points per λ² of its area
  double min_width = 0;                       ///< nor a narrower one (area / largest distance in it)
};

/// What became of a true face.
enum class Fate {
  represented,  ///< by one polygon
  split,        ///< by several
  merged,       ///< most of it is covered by a polygon that belongs to another face
  missed
};

struct FaceJudgement {
  int face = 0;
  std::int64_t points = 0;  ///< scanned on it
  double density = 0;       ///< points per λ² of its area
  bool counts = false;      ///< it was scanned well enough to be asked for
  Fate fate = Fate::missed;
  std::vector<int> polygons;  ///< indices of its polygons, the largest first
  int true_holes = 0;
  int model_holes = 0;  ///< of its largest polygon
};

struct PolygonJudgement {
  int polygon = 0;
  int face = -1;       ///< the true face it lies on; −1: none
  bool extra = false;  ///< it lies on no face, or on one that has a larger polygon
  // The following only if it is not extra:
  double angle = 0;  ///< between its normal and that of the least-squares plane of the face's own points
  double standard_error = 0;  ///< of that plane's normal, in the worse of the two directions: σ/√(m·u₂)
  double true_angle = 0;      ///< between its normal and the true one
  double offset = 0;          ///< its plane over the least-squares plane, at the centroid of the points
  double overshoot = 0;       ///< how far its boundary is, in the plane, from the true face's area
  double shortfall = 0;       ///< how far the true face's boundary is, in the plane, from its area
  double unreached = 0;       ///< how far any point scanned on the face is, in the plane, from its area
};

struct FacesReport {
  std::vector<FaceJudgement> faces;        ///< one for each true face
  std::vector<PolygonJudgement> polygons;  ///< one for each polygon
  std::int64_t outliers = 0;               ///< points that are of no face
  // Over the faces that count; `represented` are those with a polygon, the split ones among them:
  int counted = 0, represented = 0, split = 0, merged = 0, missed = 0;
  int wrong_holes = 0;  ///< represented or split, with another number of holes than the truth
  double max_angle = 0, max_overshoot = 0, max_shortfall = 0, max_unreached = 0;
  double max_angle_excess = 0;  ///< the largest angle / standard error
  // Over all polygons:
  int extra = 0;      ///< polygons that are extra
  int unmatched = 0;  ///< of them, those on no face
};

/// Compares each polygon with the true face it lies on (regions within λ, normals within 20°) and tells what
/// became of each face. `points` are the readings the model was made from. Throws std::invalid_argument if λ
/// is not positive or a point's face is not one of the truth's.
FacesReport judge_faces(const std::vector<PlanarFace>& model, const simulation::Mesh& truth,
                        std::span<const simulation::LabelledPoint> points, const JudgeOptions& options);

/// One line for each face that counts and is not simply represented with the right holes, and one for each
/// extra polygon; empty for a faultless model.
std::vector<std::string> faults(const FacesReport& report, const std::vector<PlanarFace>& model);

// ---- Model against model -----------------------------------------------------------------------

/// Hausdorff distance between the boundaries (all cycles) of two polygons, sampled every `spacing`; infinite
/// if just one of them has none.
double boundary_distance(const PlanarFace& a, const PlanarFace& b, double spacing);

struct BoundaryPair {
  int a = 0, b = 0;     ///< indices of the polygons
  double distance = 0;  ///< boundary_distance
};
struct BoundaryComparison {
  std::vector<BoundaryPair> pairs;  ///< polygons that lie on each other, mutually best
  std::vector<int> only_a, only_b;  ///< polygons without a partner
  double max_distance = 0;          ///< over the pairs
};

/// Compares two models of the same object polygon by polygon. Precondition: resolution λ > 0.
BoundaryComparison compare_boundaries(const std::vector<PlanarFace>& a, const std::vector<PlanarFace>& b,
                                      double resolution);

}  // namespace limpet::evaluation
