// Copyright the limpet authors. GPL-3.0-or-later.
//
// A young segment whose points mostly belong to a mature neighbour (a sliver across an edge, say) is
// dissolved, and its points find their segments again.
#include <algorithm>
#include <cassert>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

bool fits_a_mature_polygon(Engine& e, const RawPoint& raw, const Segment& own) {
  const Eigen::Vector3d p = e.world(raw.at);
  e.index.query(box_around(p, 0), e.found);
  for (const std::uint32_t slot : e.found) {
    const Segment& s = e.at(slot);
    if (&s == &own || !s.mature_polygon()) continue;
    const double h = s.fit.plane().height_of(p);
    if (h * h <= residual_limit(e, s, p) && standing(e, s, p, raw.axis, h * h).near) return true;
  }
  return false;
}

bool mostly_fits_neighbours(Engine& e, const Segment& s) {
  std::size_t fitting = 0;
  for (const RawPoint& raw : s.raw) {
    if (raw.returned >= kMaxReturns) return false;
    fitting += fits_a_mature_polygon(e, raw, s);
  }
  return fitting > 0 && 5 * fitting >= s.raw.size();
}

}  // namespace

void release_points(Engine& e, Segment& s, bool count_return) {
  assert(static_cast<std::int64_t>(s.raw.size()) == s.moments.count());
  for (RawPoint raw : s.raw) {
    raw.returned += count_return;
    e.pending.push_back(raw);
  }
  e.changes.push_back({Change::Kind::deleted, s.id, {}, {}, {}});
  erase_segment(e, s);
}

bool dissolve_young(Engine& e) {
  if (!e.rules().dissolve) return false;
  // Young segments that were modified, and those near where a mature polygon's description changed.
  std::vector<std::pair<SegmentId, std::uint32_t>> look;
  for (const std::uint32_t slot : e.modified) {
    if (!e.segments[slot]) continue;
    const Segment& s = e.at(slot);
    if (s.young()) look.emplace_back(s.id, slot);
    if (!s.mature_polygon() || s.polygon->changed.isEmpty()) continue;
    e.index.query(s.polygon->changed, e.found);
    for (const std::uint32_t near : e.found)
      if (e.at(near).young()) look.emplace_back(e.at(near).id, near);
  }
  std::sort(look.begin(), look.end());
  look.erase(std::unique(look.begin(), look.end()), look.end());
  bool any = false;
  for (const auto& [id, slot] : look) {
    Segment* s = e.find(id);
    if (!s || !mostly_fits_neighbours(e, *s)) continue;
    release_points(e, *s, true);
    any = true;
  }
  insert_pending(e);
  return any;
}

}  // namespace limpet::model::internal
