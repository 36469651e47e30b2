// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/evaluation/free_space.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::evaluation {

/// A point of the true surface, and the area that it stands for.
struct SurfaceSample {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of its true face: unit, outward
  int face = 0;
  double area = 0;
};

/// Samples of every true face, about `spacing` apart, at least one a face: a low-discrepancy sequence, the
/// same every time. Their areas add up to the mesh's. Precondition: spacing > 0.
std::vector<SurfaceSample> samples_of(const simulation::Mesh& mesh, double spacing);

/// The sensors of a point robot: all at the control point, and turned the same way all the time.
struct Sensing {
  std::vector<Eigen::Vector3d> axes;  ///< sensing axes in the world, unit vectors
  double range = 0;                   ///< sensing range, > 0
  /// Of the angle of incidence, > 0; 85°. At grazing incidence a range finder has no return; and a surface
  /// that is off by a tenth of the resolution is met more than the resolution away.
  double least_cosine = 0.087;
};

/// The sensors of a robot as it stands. Throws std::invalid_argument if one of them is not at the control
/// point, or their ranges differ, or there is none.
Sensing sensing_of(const kinematics::Posture& posture);

/// Which part of the true surface the robot can feel at all.
struct Reachability {
  std::vector<SurfaceSample> samples;
  std::vector<Verdict> verdicts;  ///< of each sample
  /// For each sample that is reachable, a place that it was found to be seen from; else the sample.
  std::vector<Eigen::Vector3d> seen_from;
  double spacing = 0;   ///< of the samples
  double share = 0;     ///< of the area, what is reachable without doubt
  double doubtful = 0;  ///< of the area, what is neither proven nor ruled out

  struct Face {
    double area = 0, share = 0, doubtful = 0;
  };
  std::vector<Face> faces;  ///< for each true face
};

/// Finds what is reachable: a sample p is when for one of the sensing axes a, with no more than the
/// largest incidence, there is a t in (0, range] such that
///   - the robot gets to p − t·a (FreeSpace::holds()), and
///   - nothing of the surface lies between.
/// t is searched with steps that cannot pass a place that keeps the clearance, or not shorter than a
/// sixteenth of the lattice's pitch. A sample is doubtful when it is not found to be reachable, but some such
/// place, or step, is not ruled out. Precondition: spacing > 0. The margin of `space` should be at least the
/// range.
Reachability find_reachable(const simulation::Mesh& mesh, const TrueSurface& truth, const FreeSpace& space,
                            const Sensing& sensing, double spacing);

}  // namespace limpet::evaluation
