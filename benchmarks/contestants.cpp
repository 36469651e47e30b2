// Copyright the limpet authors. GPL-3.0-or-later.
#include "contestants.hpp"

#include <map>

#include <limpet/evaluation/judgement.hpp>

namespace limpet::benchmarks {

RightFaces faces_right_by_points(const ScanCase& scan_case, const std::vector<int>& face,
                                 const std::vector<int>& plane) {
  const evaluation::JudgeOptions options;
  const double lambda2 = scan_case.resolution * scan_case.resolution;
  std::vector<std::int64_t> on_face(scan_case.faces.size());
  std::map<int, std::int64_t> on_plane;
  std::map<std::pair<int, int>, std::int64_t> on_both;  // (plane, face)
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (face[i] >= 0) ++on_face[static_cast<std::size_t>(face[i])];
    if (plane[i] >= 0) ++on_plane[plane[i]];
    if (face[i] >= 0 && plane[i] >= 0) ++on_both[{plane[i], face[i]}];
  }
  std::vector<int> planes_of(on_face.size());
  std::vector<std::int64_t> held(on_face.size());
  for (const auto& [both, count] : on_both) {
    if (2 * count <= on_plane[both.first]) continue;
    const auto f = static_cast<std::size_t>(both.second);
    ++planes_of[f];
    held[f] = count;
  }
  RightFaces result;
  for (std::size_t f = 0; f < on_face.size(); ++f) {
    const auto count = static_cast<double>(on_face[f]);
    if (on_face[f] < options.min_points || count * lambda2 / scan_case.faces[f].area < options.min_density)
      continue;
    ++result.counted;
    result.right += planes_of[f] == 1 && 5 * held[f] >= 4 * on_face[f];
  }
  return result;
}

}  // namespace limpet::benchmarks
