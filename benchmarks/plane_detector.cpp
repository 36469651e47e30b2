// Copyright the limpet authors. GPL-3.0-or-later.
#include "plane_detector.hpp"

#include <algorithm>

namespace limpet::benchmarks {

double max_distance(const ScanCase& s) { return std::max(3 * s.noise, s.resolution / 20); }

std::size_t smallest_plane(const ScanCase& s) {
  return static_cast<std::size_t>(std::max(50.0, s.smallest_face_points / 4));
}

Json answer_of(const ScanCase& scan_case, const std::string& path,
               const std::vector<std::vector<std::size_t>>& planes, double seconds, double megabytes) {
  std::vector<int> face_of;
  CloudReader reader(path);
  for (auto some = reader.next(4096); !some.empty(); some = reader.next(4096))
    for (const auto& p : some) face_of.push_back(p.face);
  std::vector<int> plane_of(face_of.size(), -1);
  std::size_t in_planes = 0;
  for (std::size_t plane = 0; plane < planes.size(); ++plane) {
    for (const std::size_t i : planes[plane]) plane_of[i] = static_cast<int>(plane);
    in_planes += planes[plane].size();
  }
  const RightFaces faces = faces_right_by_points(scan_case, face_of, plane_of);
  return {{"points", face_of.size()},  {"seconds", seconds},     {"megabytes", megabytes},
          {"planes", planes.size()},   {"in_planes", in_planes}, {"faces_counted", faces.counted},
          {"faces_right", faces.right}};
}

}  // namespace limpet::benchmarks
