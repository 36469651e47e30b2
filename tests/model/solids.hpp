// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/mesh.hpp>
#include <limpet/survey/random.hpp>

/// Worlds in which planes meet in all the ways they can.
namespace limpet::model::testing {

using simulation::Mesh;

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// A mesh that grows polygon by polygon.
class MeshMaker {
 public:
  using Loop = std::vector<Eigen::Vector3d>;

  MeshMaker& face(const Loop& loop) {
    auto& polygon = polygons_.emplace_back();
    for (const auto& p : loop) {
      polygon.push_back(static_cast<int>(vertices_.size()));
      vertices_.push_back(p);
    }
    return *this;
  }
  MeshMaker& mesh(const Mesh& other) {
    for (const auto& t : other.triangles)
      face({other.vertices[static_cast<std::size_t>(t[0])], other.vertices[static_cast<std::size_t>(t[1])],
            other.vertices[static_cast<std::size_t>(t[2])]});
    return *this;
  }
  Mesh make() const { return simulation::make_mesh(vertices_, polygons_); }

 private:
  Loop vertices_;
  std::vector<std::vector<int>> polygons_;
};

/// The planes at z = 0 for x < 0 and, turned up by `degrees`, for x > 0, 1.25 × 1.25 each,
/// seen from above.
inline Mesh folded(double degrees) {
  constexpr double kSize = 1.25;
  const double x = kSize * std::cos(radians(degrees)), z = kSize * std::sin(radians(degrees));
  return MeshMaker()
      .face({{-kSize, 0, 0}, {0, 0, 0}, {0, kSize, 0}, {-kSize, kSize, 0}})
      .face({{0, 0, 0}, {x, 0, z}, {x, kSize, z}, {0, kSize, 0}})
      .make();
}

/// A prism 1 long and 1 deep whose two large faces meet at `degrees`.
inline Mesh wedge(double degrees) {
  const double h = std::tan(radians(degrees));
  return MeshMaker()
      .face({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}})
      .face({{0, 0, 0}, {1, 0, h}, {1, 1, h}, {0, 1, 0}})
      .face({{1, 0, 0}, {1, 1, 0}, {1, 1, h}, {1, 0, h}})
      .face({{0, 0, 0}, {1, 0, 0}, {1, 0, h}})
      .face({{0, 1, 0}, {1, 1, h}, {1, 1, 0}})
      .make();
}

inline Mesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  simulation::BoxWorld world;
  world.add(low, high);
  return world.surface();
}

/// What lies within all of the planes n·x ≤ 1. Empty when `shortest` is longer than its shortest edge.
inline Mesh convex(const std::vector<Eigen::Vector3d>& normals, double shortest) {
  constexpr double kOn = 1e-9;
  std::vector<MeshMaker::Loop> faces;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    MeshMaker::Loop corners;
    for (std::size_t j = 0; j < normals.size(); ++j)
      for (std::size_t k = j + 1; k < normals.size(); ++k) {
        if (j == i || k == i) continue;
        Eigen::Matrix3d a;
        a << normals[i].transpose(), normals[j].transpose(), normals[k].transpose();
        if (std::abs(a.determinant()) < 1e-6) continue;
        const Eigen::Vector3d p = a.inverse() * Eigen::Vector3d::Ones();
        bool inside = true, known = false;
        for (const auto& n : normals) inside &= n.dot(p) <= 1 + kOn;
        for (const auto& c : corners) known |= (c - p).norm() < kOn;
        if (inside && !known) corners.push_back(p);
      }
    if (corners.size() < 3) continue;
    const Eigen::Vector3d n = normals[i].normalized(), u = n.unitOrthogonal(), v = n.cross(u);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& c : corners) middle += c / static_cast<double>(corners.size());
    std::sort(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
      return std::atan2(v.dot(a - middle), u.dot(a - middle)) <
             std::atan2(v.dot(b - middle), u.dot(b - middle));
    });
    for (std::size_t c = 0; c < corners.size(); ++c)
      if ((corners[c] - corners[(c + 1) % corners.size()]).norm() < shortest) return {};
    faces.push_back(corners);
  }
  // A corner that several planes meet in comes out a little different on each.
  MeshMaker maker;
  std::vector<Eigen::Vector3d> known;
  for (auto& face : faces) {
    for (auto& p : face) {
      const auto same =
          std::find_if(known.begin(), known.end(), [&](const auto& q) { return (p - q).norm() < 1e-7; });
      if (same == known.end())
        known.push_back(p);
      else
        p = *same;
    }
    maker.face(face);
  }
  return maker.make();
}

/// A polyhedron of 7 to 12 planes about the unit ball, no two of them nearer than 25° to each other, and no
/// edge shorter than `shortest`.
inline Mesh random_convex(survey::Random& random, double shortest) {
  for (;;) {
    const auto wanted = 7 + random.below(6);
    std::vector<Eigen::Vector3d> normals;
    for (int attempt = 0; attempt < 200 && normals.size() < wanted; ++attempt) {
      const Eigen::Vector3d n =
          Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      const bool apart = std::all_of(normals.begin(), normals.end(), [&](const auto& other) {
        return n.dot(other.normalized()) < std::cos(radians(25));
      });
      if (apart) normals.push_back(n * random.uniform(0.85, 1.15));
    }
    bool bounded = true;  // no corner farther than 3 from the middle, or none at all
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector3d d =
          Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      bounded &= std::any_of(normals.begin(), normals.end(), [&](const auto& n) { return 3 * n.dot(d) > 1; });
    }
    if (!bounded) continue;
    Mesh mesh = convex(normals, shortest);
    if (!mesh.triangles.empty() && simulation::count_edges(mesh).open == 0 &&
        simulation::bounds_of(mesh).diagonal() < 8)
      return mesh;
  }
}

}  // namespace limpet::model::testing
