// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/bridge.hpp>

#include <cmath>
#include <tuple>

#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>

#include "bridge_sections_internal.hpp"
#include "small_vector_internal.hpp"

namespace limpet::geometry {
namespace {

using internal::Contact;
using internal::Foot;
using internal::SectionEnd;
using internal::SectionSearch;

constexpr std::size_t kMaxContacts = 24;

/// The last vertex kept before Q, and the first one kept after it.
Slot kept_before(const Foot& q1) { return q1.edge; }
Slot kept_after(const Polygon& y, const Foot& q2) { return q2.cut ? y.next(q2.edge) : q2.edge; }

/// The vertices of `p` from `first` to `last` in order; the edge that leaves `last` is a new one.
void append_kept(const Polygon& p, Slot first, Slot last, std::vector<NewVertex>& via) {
  for (Slot s = first;; s = p.next(s)) {
    const auto& n = p.node(s);
    if (s == last) return via.push_back({n.at});
    via.push_back({n.at, n.edge, n.shared});
  }
}

void append_other_cycles(const Polygon& b, CycleId joined, Edit& edit) {
  for (std::size_t i = 0; i < b.cycles().size(); ++i)
    if (b.cycles()[i].size > 0 && i != static_cast<std::size_t>(joined))
      edit.loops.push_back(b.vertices(b.cycles()[i]));
}

/// P on a, Q on b.
Edit join_p_on_a(const Polygon& b, const SectionEnd& p1, const SectionEnd& p2) {
  Edit edit;
  Chain chain{p1.kept, {}, p2.kept};
  const Foot &q1 = p2.foot, &q2 = p1.foot;
  if (p1.cut) chain.via.push_back({*p1.cut});
  if (q2.cut) chain.via.push_back({*q2.cut});
  append_kept(b, kept_after(b, q2), kept_before(q1), chain.via);
  if (q1.cut) chain.via.push_back({*q1.cut});
  if (p2.cut) chain.via.push_back({*p2.cut});
  edit.chains.push_back(std::move(chain));
  append_other_cycles(b, b.node(q1.edge).cycle, edit);
  return edit;
}

/// P on b, Q on a.
Edit join_p_on_b(const Polygon& a, const Polygon& b, const SectionEnd& p1, const SectionEnd& p2) {
  Edit edit;
  const Foot &q1 = p2.foot, &q2 = p1.foot;
  Chain chain{kept_before(q1), {}, kept_after(a, q2)};
  if (q1.cut) chain.via.push_back({*q1.cut});
  if (p2.cut) chain.via.push_back({*p2.cut});
  append_kept(b, p2.kept, p1.kept, chain.via);
  if (p1.cut) chain.via.push_back({*p1.cut});
  if (q2.cut) chain.via.push_back({*q2.cut});
  edit.chains.push_back(std::move(chain));
  append_other_cycles(b, b.node(p1.kept).cycle, edit);
  return edit;
}

Edit split(const Polygon& a, const SectionEnd& p1, const SectionEnd& p2) {
  Edit edit;
  const Foot &q1 = p2.foot, &q2 = p1.foot;
  Chain first{p1.kept, {}, kept_after(a, q2)}, second{kept_before(q1), {}, p2.kept};
  if (p1.cut) first.via.push_back({*p1.cut});
  if (q2.cut) first.via.push_back({*q2.cut});
  if (q1.cut) second.via.push_back({*q1.cut});
  if (p2.cut) second.via.push_back({*p2.cut});
  edit.chains.push_back(std::move(first));
  edit.chains.push_back(std::move(second));
  return edit;
}

/// Vertices of either polygon within gap of the other's perimeter, with their nearest points there, nearest
/// first. Without crossings the nearest pair of all has a vertex on one side.
std::vector<Contact> contacts(const Polygon& a, const Polygon& b, const Gap& gap) {
  std::vector<Contact> result;
  const auto at_start = [](const Polygon& p,
                           PerimeterPoint q) {  // the end of an edge is the start of the next
    if (q.fraction == 1) q.edge = p.next(q.edge), q.fraction = 0;
    return q;
  };
  for (std::uint32_t i = 0; i < b.slot_count(); ++i) {
    const Slot s{i};
    if (!b.alive(s)) continue;
    if (const auto x = nearest_perimeter_point(a, b.at(s), gap.at(b.at(s))))
      result.push_back({at_start(a, *x), {s, 0, b.at(s), x->squared_distance}});
  }
  const Box2 around = b.box().grown(gap.most());
  a.any_edge_near(around, [&](Slot s) {
    if (!around.contains(a.at(s))) return false;
    if (const auto y = nearest_perimeter_point(b, a.at(s), gap.at(a.at(s))))
      result.push_back({{s, 0, a.at(s), y->squared_distance}, at_start(b, *y)});
    return false;
  });
  std::sort(result.begin(), result.end(), [&](const Contact& p, const Contact& q) {
    if (p.x.squared_distance != q.x.squared_distance) return p.x.squared_distance < q.x.squared_distance;
    const auto key = [&](const Contact& c) {  // between parallel edges several pairs are equally near
      return std::tuple(a.node(c.x.edge).edge, b.node(c.y.edge).edge, c.x.fraction, c.y.fraction);
    };
    return key(p) < key(q);
  });
  result.erase(std::unique(result.begin(), result.end(),
                           [](const Contact& p, const Contact& q) {
                             return p.x.edge == q.x.edge && p.y.edge == q.y.edge &&
                                    p.x.fraction == q.x.fraction && p.y.fraction == q.y.fraction;
                           }),
               result.end());
  return result;
}

/// Does the line from vertex v to p leave v on the outside of the perimeter?
bool leaves_outside(const Polygon& polygon, Slot v, Point2 p) {
  const Point2 a = polygon.at(polygon.prev(v)), b = polygon.at(v), c = polygon.end(v);
  const bool left_of_in = orientation(a, b, p) > 0, left_of_out = orientation(b, c, p) > 0;
  return orientation(a, b, c) > 0 ? !(left_of_in && left_of_out) : !(left_of_in || left_of_out);
}

/// The edges that are less than `length` from vertex v along the perimeter, in either direction.
internal::SmallVector<Slot, 32> edges_along(const Polygon& polygon, Slot v, double length) {
  internal::SmallVector<Slot, 32> edges;
  double way = 0;
  const auto pass = [&](Slot s) {
    edges.push_back(s);
    way += std::sqrt(squared_length(polygon.end(s) - polygon.at(s)));
  };
  Slot s = v;
  do pass(s), s = polygon.next(s);
  while (way < length && s != v);
  way = 0;
  s = v;
  do s = polygon.prev(s), pass(s);
  while (way < length && s != v);
  return edges;
}

}  // namespace

bool bridge_polygons(Polygon& a, const Polygon& b, const Gap& gap, EdgeIds& ids) {
  const auto attempt = [&](const Edit& edit) { return a.grow(edit, ids, b.area()) == Verdict::valid; };
  const auto around = contacts(a, b, gap);
  for (std::size_t k = 0; k < std::min(around.size(), kMaxContacts); ++k) {
    const Contact& contact = around[k];
    const double here = gap.at(contact.x.at);
    if (SectionSearch(a, b, contact, here).search([&](const SectionEnd& p1, const SectionEnd& p2) {
          return attempt(join_p_on_a(b, p1, p2));
        }))
      return true;
    if (SectionSearch(b, a, {contact.y, contact.x}, here)
            .search([&](const SectionEnd& p1, const SectionEnd& p2) {
              return attempt(join_p_on_b(a, b, p1, p2));
            }))
      return true;
  }
  return false;
}

bool bridge_self(Polygon& polygon, Slot vertex, double gap, EdgeIds& ids) {
  const Point2 v = polygon.at(vertex);
  const auto along = edges_along(polygon, vertex, 2 * gap);
  internal::SmallVector<PerimeterPoint, 16> near;
  polygon.any_edge_near(Box2{v, v}.grown(gap), [&](Slot s) {
    const auto& n = polygon.node(s);
    if (n.cycle != polygon.node(vertex).cycle || n.shared) return false;
    const double t = nearest_fraction(n.at, polygon.end(s), v);
    const Point2 at = n.at + t * (polygon.end(s) - n.at);
    if (squared_length(at - v) < gap * gap && std::find(along.begin(), along.end(), s) == along.end() &&
        leaves_outside(polygon, vertex, at))
      near.push_back({s, t, at, squared_length(at - v)});
    return false;
  });
  if (near.empty()) return false;
  std::sort(near.begin(), near.end(), [&](const PerimeterPoint& p, const PerimeterPoint& q) {
    if (p.squared_distance != q.squared_distance) return p.squared_distance < q.squared_distance;
    return polygon.node(p.edge).edge < polygon.node(q.edge).edge;
  });
  near.erase(
      std::unique(near.begin(), near.end(), [](const auto& p, const auto& q) { return p.edge == q.edge; }),
      near.end());
  for (std::size_t k = 0; k < std::min<std::size_t>(near.size(), 3); ++k) {
    const Contact contact{{vertex, 0, v, near[k].squared_distance}, near[k]};
    if (SectionSearch(polygon, polygon, contact, gap).search([&](const SectionEnd& p1, const SectionEnd& p2) {
          const Edit edit = split(polygon, p1, p2);
          return polygon.grow(edit, ids) == Verdict::valid;
        }))
      return true;
  }
  return false;
}

}  // namespace limpet::geometry
