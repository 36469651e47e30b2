// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/world_description.hpp>

#include <algorithm>
#include <cmath>
#include <limpet/io/scan_reader.hpp>
#include <limpet/simulation/initial_faces.hpp>
#include <limpet/simulation/random_start.hpp>
#include <limpet/simulation/range_image.hpp>
#include <limpet/simulation/scene.hpp>
#include <utility>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> read_image(const std::string& path) {
  io::ScanOptions options;
  options.ignore_axes = true;
  const auto scan = io::open_scan(path, options);
  std::vector<Vector3d> points;
  for (io::ScanRecord record; scan->next(record);) points.push_back(record.point.position);
  return points;
}

/// Where the scanner looked, in the world; none when the points are to have no front.
std::optional<Vector3d> front(const WorldDescription& wanted, const Eigen::Affine3d& transform) {
  if (!wanted.direction || wanted.two_sided) return std::nullopt;
  return transform.linear() * *wanted.direction;
}

void build_from_file(const WorldDescription& wanted, const Eigen::Affine3d& transform, BuiltWorld& built) {
  if (wanted.initial_occluded || !wanted.initial_faces.empty() || wanted.pitch)
    throw MeshError(wanted.image + ": is an image of no known mesh, so none of its faces can be named");
  built.image = placed(read_image(wanted.image), transform);
  built.world = make_range_image_world(built.image, wanted.epsilon, front(wanted, transform));
}

void build_from_mesh(const WorldDescription& wanted, const Eigen::Affine3d& transform, BuiltWorld& built) {
  built.truth = placed(make_scene(wanted.mesh).mesh, transform);
  if (wanted.pitch) {
    if (!wanted.direction) throw MeshError("a range image of a mesh needs a direction");
    const RangeImage image =
        take_range_image(*built.truth, transform.linear() * *wanted.direction, *wanted.pitch);
    built.world = make_range_image_world(image.points, wanted.epsilon, front(wanted, transform));
    built.image = image.points;
    if (wanted.initial_occluded)
      built.initial = initial_faces(*built.truth, occluded_faces(*built.truth, image, *wanted.pitch));
  } else {
    if (wanted.initial_occluded) throw MeshError("no face of the mesh is occluded: it is no range image");
    built.world = make_mesh_world(*built.truth);
  }
  if (!wanted.initial_faces.empty()) built.initial = initial_faces(*built.truth, wanted.initial_faces);
}

}  // namespace

BuiltWorld build_world(const WorldDescription& wanted, std::uint64_t seed) {
  const Eigen::Affine3d transform = transform_of(wanted.placement, seed);
  BuiltWorld built;
  if (wanted.mesh.empty())
    build_from_file(wanted, transform, built);
  else
    build_from_mesh(wanted, transform, built);
  if (!wanted.initial_mesh.empty())
    built.initial = initial_faces(placed(load_mesh(wanted.initial_mesh), transform));
  return built;
}

Vector3d random_start(const BuiltWorld& built, double distance, std::uint64_t seed) {
  if (!built.truth) throw MeshError("a range image of no known mesh has no random start: give one");
  if (built.image.empty()) return random_start(*built.truth, distance, seed);
  const double epsilon = image_epsilon(built.image);
  const double reach2 = distance * distance + epsilon * epsilon;
  return random_start(*built.truth, distance, seed, [&](const Vector3d& start) {
    return std::any_of(built.image.begin(), built.image.end(),
                       [&](const Vector3d& p) { return (p - start).squaredNorm() <= reach2; });
  });
}

}  // namespace limpet::simulation
