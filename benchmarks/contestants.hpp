// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cloud.hpp"
#include "process.hpp"

/// Those who find planes in the same cloud, each in a process of its own. All answer with "points", "seconds"
/// (of processor time, without reading the file), "megabytes" (what the process has grown by at its peak),
/// "planes", "in_planes" (points), "faces_counted" and "faces_right".
namespace limpet::benchmarks {

/// Streams the cloud through a model in sets of 26. Also answers with "reading_seconds" and "finish_seconds";
/// with "stages" in the request, with seconds by stage before finishing, on the wall clock; with "judge",
/// with what the floor takes on the final model ("floor_seconds"), and a face is right when judge_faces()
/// finds it represented by one polygon with as many holes. The model is left at "mesh" if the request has it.
Json answer_limpet(const Json& request);

/// As `limpet model SCAN` does it, with nothing given: the cloud is written as a PLY file at "scan" of the
/// request, which is not counted; reading it (three times), choosing λ, noise and tolerance, putting the
/// points in order (not with "arrival"), updates and finishing are. Also answers with "resolution", λ as it
/// was chosen, "choosing_seconds" and "finish_seconds"; with "judge" as above.
Json answer_default(const Json& request);

/// CGAL's region growing and Efficient RANSAC. A face is right by its points (faces_right_by_points()).
/// "estimate" in the request: normals from the 12 nearest points, that cost included; else the true ones, a
/// gift. "sphere": neighbours within a sphere of about 15 points instead of the 12 nearest.
Json answer_region_growing(const Json& request);
Json answer_ransac(const Json& request);

/// CGAL's PolyFit on the planes of region growing with the true normals: leaves a mesh (OFF) at "mesh" of the
/// request. Answers with "points", "seconds", of them "detecting_seconds" (planes), "generating_seconds"
/// (candidate faces) and "solving_seconds", "megabytes", "planes", "candidates" and "faces" (the mesh's
/// facets); tells those it has so far. "failed" if it was built without the solver, or found no solution.
Json answer_polyfit(const Json& request);

/// Sensor points in a set.
inline constexpr std::size_t kSet = 26;

/// Which faces count: as judge_faces() has it.
struct RightFaces {
  int counted = 0, right = 0;
};
/// A face is right when one plane, and one only, has most of its points on it, and that plane holds at least
/// four fifths of the face's points. `face` and `plane` are of each point, −1 for none.
RightFaces faces_right_by_points(const ScanCase&, const std::vector<int>& face,
                                 const std::vector<int>& plane);

}  // namespace limpet::benchmarks
