// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/unreachable.hpp>

#include <algorithm>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;

Vector3d nearest_of(const GivenUp& mark, const Vector3d& place) {
  const Vector3d along = mark.to - mark.from;
  const double length2 = along.squaredNorm();
  if (!(length2 > 0)) return mark.from;
  return mark.from + std::clamp((place - mark.from).dot(along) / length2, 0.0, 1.0) * along;
}

/// The samples beyond a mark that are, or may be, joined to it: those near it first.
struct Beyond {
  std::vector<std::size_t> joined, others;
};

Beyond around(const GivenUp& mark, const Reachability& truth, double resolution) {
  Beyond found;
  for (std::size_t i = 0; i < truth.samples.size(); ++i) {
    const Vector3d& at = truth.samples[i].at;
    const Vector3d away = at - nearest_of(mark, at);
    if (away.norm() > 2 * resolution || away.dot(mark.outward) < -resolution / 2) continue;
    (away.norm() <= resolution ? found.joined : found.others).push_back(i);
  }
  return found;
}

/// All that hangs together with what is joined already.
std::vector<std::size_t> connected(Beyond found, const Reachability& truth) {
  for (std::size_t next = 0; next < found.joined.size(); ++next) {
    const Vector3d at = truth.samples[found.joined[next]].at;
    const auto far = [&](std::size_t i) { return (truth.samples[i].at - at).norm() > 2 * truth.spacing; };
    const auto first = std::stable_partition(found.others.begin(), found.others.end(), far);
    found.joined.insert(found.joined.end(), first, found.others.end());
    found.others.erase(first, found.others.end());
  }
  return found.joined;
}

}  // namespace

FalseUnreachable false_unreachable(const std::vector<GivenUp>& marks, const Reachability& truth,
                                   const Coverage& covered, double resolution) {
  FalseUnreachable result;
  for (const GivenUp& mark : marks) {
    double area = 0;
    for (const std::size_t i : connected(around(mark, truth, resolution), truth))
      if (truth.verdicts[i] == Verdict::yes && covered.covered[i] == 0) area += truth.samples[i].area;
    result.areas.push_back(area);
    result.count += area > 0;
  }
  return result;
}

std::vector<SurfaceSample> near_marks(const std::vector<GivenUp>& marks,
                                      const std::vector<SurfaceSample>& samples, double resolution) {
  std::vector<SurfaceSample> near;
  for (const SurfaceSample& sample : samples)
    if (std::any_of(marks.begin(), marks.end(), [&](const GivenUp& mark) {
          return (sample.at - nearest_of(mark, sample.at)).norm() <= 2 * resolution;
        }))
      near.push_back(sample);
  return near;
}

}  // namespace limpet::evaluation
