// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace limpet::simulation {

/// A mesh that cannot be read or made. The message is one line, and names the file if there is one.
class MeshError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A triangle mesh that knows its true planar faces: maximal sets of triangles in one plane, facing the same
/// way, connected through shared edges. Triangles are anticlockwise seen from outside. Coordinates are in the
/// world frame, in the scan's unit. A face need not be convex and may have holes.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;      ///< no two at the same position
  std::vector<std::array<int, 3>> triangles;  ///< indices of vertices
  std::vector<int> face_of_triangle;          ///< 0 … face_count − 1, for each triangle
  int face_count = 0;
};

/// How far a triangle's corners may be from the plane of the largest triangle of its face, as a fraction of
/// the diagonal of the mesh's bounding box. It forgives the rounding of single-precision and six-digit files;
/// facets of a curved surface stand apart more.
inline constexpr double kPlanarity = 1e-5;

/// Makes a mesh of polygons (three or more vertex indices each, anticlockwise seen from outside, planar, not
/// necessarily convex). Vertices at exactly the same position become one, polygons are cut into triangles,
/// and the faces are found and numbered in the order of their first triangles. Polygons of no extent (fewer
/// than three different vertices) are dropped. The same input gives the same mesh. Throws MeshError if an
/// index is out of range, a coordinate is not finite or beyond 1e75, or no triangle is left.
Mesh make_mesh(const std::vector<Eigen::Vector3d>& vertices, const std::vector<std::vector<int>>& polygons,
               double planarity = kPlanarity);

/// Reads OFF (also COFF, NOFF, STOFF: what is not position is ignored), STL (text or binary), OBJ or PLY
/// (text or binary), told by the name's ending, in any case. Many closed meshes are stored inside out: one
/// with a negative volume is turned, unless it is to `keep_inward`, as the inside of a room. A
/// name of another ending is refused before anything is read, and so is a device. Throws MeshError.
Mesh load_mesh(const std::string& path, double planarity = kPlanarity, bool keep_inward = false);

/// One true face.
struct Face {
  double area = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, outward
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  /// Boundary, interior on the left: the outer loop (anticlockwise about the normal) first, then the holes
  /// (clockwise). Vertices in the middle of a straight side are left out.
  std::vector<std::vector<Eigen::Vector3d>> loops;
  std::vector<int> triangles;  ///< indices into the mesh's triangles, ascending
};

/// All faces of a mesh, in their order.
std::vector<Face> faces_of(const Mesh& mesh);

/// The narrowest place of any face: the smallest distance from a vertex to a side of its face that it is not
/// on. A resolution of a fifth of it shows every face.
double narrowest_place(const Mesh& mesh);

/// Smallest and largest coordinates. Precondition: the mesh has a vertex.
struct Bounds {
  Eigen::Vector3d low, high;
  Eigen::Vector3d centre() const { return (low + high) / 2; }
  double diagonal() const { return (high - low).norm(); }
};
Bounds bounds_of(const Mesh& mesh);

/// Twice the area of a triangle, as a vector along its outward normal.
Eigen::Vector3d area_vector(const Mesh& mesh, int triangle);

/// Edges as the mesh's triangles see them: a closed surface has no open and no crowded edges.
struct EdgeCounts {
  long edges = 0;    ///< undirected edges
  long open = 0;     ///< of one triangle only
  long crowded = 0;  ///< of more than two triangles, or of two that disagree about the direction
};
EdgeCounts count_edges(const Mesh& mesh);

/// Volume enclosed by a closed mesh; negative if it faces inward.
double signed_volume(const Mesh& mesh);

}  // namespace limpet::simulation
