// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <Eigen/Geometry>
#include <string>

namespace limpet::kinematics::internal {

/// What urdfdom makes of a URDF, without what is for the eye or for dynamics. Its own messages go into that
/// of the error, and nowhere else. Throws RobotError.
urdf::ModelInterfaceSharedPtr parse_document(const std::string& text, const std::string& path);

inline Eigen::Vector3d to_vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

inline Eigen::Isometry3d to_pose(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  Eigen::Isometry3d to = Eigen::Isometry3d::Identity();
  to.translation() = to_vector(pose.position);
  to.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  return to;
}

}  // namespace limpet::kinematics::internal
