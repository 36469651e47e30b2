// Copyright the limpet authors. GPL-3.0-or-later.
#include "urdf_bodies_internal.hpp"

#include <algorithm>
#include <filesystem>
#include <limpet/kinematics/enclosing_capsule.hpp>
#include <limpet/kinematics/mesh_path.hpp>

#include "urdf_document_internal.hpp"

namespace limpet::kinematics::internal {
namespace {

using Eigen::Vector3d;
using model::Capsule;

/// Of one link of a file.
class BodyReader {
 public:
  BodyReader(const urdf::Link& link, const std::string& path, const UrdfOptions& options)
      : link_(link), path_(path), options_(options) {}

  std::vector<Capsule> read(const urdf::Collision& collision) const {
    const Eigen::Isometry3d pose = to_pose(collision.origin);
    if (!collision.geometry) fail("a collision shape has no geometry");
    switch (collision.geometry->type) {
      case urdf::Geometry::SPHERE:
        return of_sphere(static_cast<const urdf::Sphere&>(*collision.geometry), pose);
      case urdf::Geometry::CYLINDER:
        return of_cylinder(static_cast<const urdf::Cylinder&>(*collision.geometry), pose);
      case urdf::Geometry::BOX:
        return of_box(static_cast<const urdf::Box&>(*collision.geometry), pose);
      case urdf::Geometry::MESH:
        return of_mesh(static_cast<const urdf::Mesh&>(*collision.geometry), pose);
    }
    fail("a collision shape is of no known kind");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw RobotError(path_ + ": link '" + link_.name + "': " + what);
  }

  void require_size(bool good, const std::string& what) const {
    if (!good) fail("the sizes of its collision shapes must not be negative: " + what);
  }

  std::vector<Capsule> of_sphere(const urdf::Sphere& sphere, const Eigen::Isometry3d& pose) const {
    require_size(sphere.radius >= 0, "the radius of a sphere");
    return {{pose.translation(), pose.translation(), sphere.radius}};
  }

  std::vector<Capsule> of_cylinder(const urdf::Cylinder& cylinder, const Eigen::Isometry3d& pose) const {
    require_size(cylinder.radius >= 0 && cylinder.length >= 0, "a cylinder");
    const Vector3d half(0, 0, cylinder.length / 2);
    return {{pose * Vector3d(-half), pose * half, cylinder.radius}};
  }

  std::vector<Capsule> of_box(const urdf::Box& box, const Eigen::Isometry3d& pose) const {
    const Vector3d half = to_vector(box.dim) / 2;
    require_size((half.array() >= 0).all(), "a box");
    std::vector<Vector3d> corners, sides;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      corners.emplace_back(pose * signs.cwiseProduct(half));
    }
    for (int i = 0; i < 3; ++i) sides.emplace_back(pose.linear().col(i).normalized());
    return {enclosing_capsule(corners, sides)};
  }

  std::vector<Capsule> of_mesh(const urdf::Mesh& mesh, const Eigen::Isometry3d& pose) const {
    std::vector<Vector3d> corners = load(mesh.filename);
    for (Vector3d& corner : corners) corner = pose * corner.cwiseProduct(to_vector(mesh.scale));
    if (corners.empty() || corners.size() % 3 != 0) fail("the mesh '" + mesh.filename + "' has no triangles");
    if (!std::all_of(corners.begin(), corners.end(), [](const Vector3d& p) { return p.norm() < 1e75; }))
      fail("the mesh '" + mesh.filename + "' is not finite");
    return enclosing_capsules(corners);
  }

  std::vector<Vector3d> load(const std::string& name) const {
    const std::string beside = std::filesystem::path(path_).parent_path().string();
    const auto found = find_robot_file(name, beside, options_.package_paths);
    const std::string instead =
        "or give the link's shape in a robot file, as capsules in [shapes." + link_.name + "]";
    if (!found)
      fail("its mesh '" + name + "' is not there: say by a package path in which folder it is, " + instead);
    if (!options_.load_mesh) fail("its shape is the mesh '" + name + "', and meshes are not read here");
    try {
      return options_.load_mesh(*found);
    } catch (const std::exception& error) {
      fail("its mesh cannot be read: " + std::string(error.what()) + "; mend it, " + instead);
    }
  }

  const urdf::Link& link_;
  const std::string& path_;
  const UrdfOptions& options_;
};

}  // namespace

std::vector<Capsule> body_of(const urdf::Link& link, const std::string& path, const UrdfOptions& options) {
  if (const auto given = options.shapes.find(link.name); given != options.shapes.end()) return given->second;
  const BodyReader reader(link, path, options);
  std::vector<Capsule> body;
  for (const auto& collision : link.collision_array) {
    const std::vector<Capsule> more = reader.read(*collision);
    body.insert(body.end(), more.begin(), more.end());
  }
  return without_covered(body);
}

}  // namespace limpet::kinematics::internal
