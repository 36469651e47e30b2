// Copyright the limpet authors. GPL-3.0-or-later.
//
// The union of two polygons within a window, by a CGAL arrangement whose curves remember their source edges.
#include "outline_internal.hpp"

#include <exception>
#include <map>
#include <memory>
#include <unordered_map>

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#if defined(LIMPET_ARITHMETIC_EXACT)
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#else
#include <CGAL/Simple_cartesian.h>
#endif

#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry::internal {
namespace {

#if defined(LIMPET_ARITHMETIC_EXACT)
using ArrangementKernel = CGAL::Exact_predicates_exact_constructions_kernel;
// Made exact first: the double nearest to a lazy number depends on how far it has been evaluated already.
double number(const ArrangementKernel::FT& x) { return CGAL::to_double(CGAL::exact(x)); }
#else
using ArrangementKernel = CGAL::Simple_cartesian<double>;
double number(double x) { return x; }
#endif

enum class Owner { a, b, window };
struct Label {
  Owner owner;
  std::uint32_t index;
  friend bool operator==(const Label&, const Label&) = default;
};

using Traits =
    CGAL::Arr_consolidated_curve_data_traits_2<CGAL::Arr_segment_traits_2<ArrangementKernel>, Label>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Halfedge = Arrangement::Halfedge_const_handle;
using Vertex = Arrangement::Vertex_const_handle;
using Face = Arrangement::Face_const_handle;

/// An arrangement that an exception (out of memory) has left half made cannot even be destroyed: CGAL's
/// destructor walks lists that are not there yet. Its memory is given up.
struct DeleteWhole {
  int exceptions = std::uncaught_exceptions();
  void operator()(Arrangement* arrangement) const {
    if (std::uncaught_exceptions() == exceptions) delete arrangement;
  }
};

struct FaceState {
  bool in_window = false, in_a = false, in_b = false;
};

class UnionOutline {
 public:
  UnionOutline(const std::vector<SourceEdge>& a, const std::vector<SourceEdge>& b, const Box2& window)
      : a_(a), b_(b), window_(window) {
    std::vector<Traits::Curve_2> curves;
    const auto add = [&](Point2 p, Point2 q, Owner owner, std::size_t i) {
      const Traits::Base_curve_2 segment(Traits::Point_2(p.x, p.y), Traits::Point_2(q.x, q.y));
      curves.emplace_back(segment, Label{owner, static_cast<std::uint32_t>(i)});
    };
    for (std::size_t i = 0; i < a.size(); ++i) add(a[i].a, a[i].b, Owner::a, i);
    for (std::size_t i = 0; i < b.size(); ++i) add(b[i].a, b[i].b, Owner::b, i);
    const auto c = corners(window);
    for (std::size_t i = 0; i < 4; ++i) add(c[i], c[(i + 1) % 4], Owner::window, i);
    CGAL::insert(*arrangement_, curves.begin(), curves.end());
    for (const SourceEdge& edge : a) starts_a_[{edge.a.x, edge.a.y}] = edge.slot;
  }

  bool classify(const std::vector<int>& corner_sides) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (corner_sides[i] == 0) continue;
      const auto f = window_face_at(corners(window_)[i]);
      if (!f) continue;
      spread(*f, FaceState{true, corner_sides[i] > 0, false});
      return true;
    }
    return false;
  }

  std::vector<Outline> trace() {
    std::vector<Halfedge> boundary;
    std::map<const void*, bool> reached;  // vertices some boundary piece leads to
    for (auto h = arrangement_->halfedges_begin(); h != arrangement_->halfedges_end(); ++h)
      if (on_boundary(h)) {
        boundary.push_back(h);
        reached[&*h->target()] = true;
      }
    std::vector<Outline> outlines;
    for (const bool open : {true, false})
      for (const Halfedge h : boundary)
        if (!done_.count(&*h) && (!open || !reached.count(&*h->source()))) outlines.push_back(follow(h));
    return outlines;
  }

 private:
  /// Over all faces of the window, and no further: outside it a's edges are cut off, so that the sides there
  /// would depend on the way taken.
  void spread(Face from, FaceState start) {
    std::vector<Face> stack{from};
    state_[&*from] = start;
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      const auto across = [&](Arrangement::Ccb_halfedge_const_circulator begin) {
        auto h = begin;
        do {
          const Face g = h->twin()->face();
          if (state_.count(&*g)) continue;
          FaceState s = state_.at(&*f);
          for (const Label& l : h->curve().data()) {
            s.in_window ^= l.owner == Owner::window;
            s.in_a ^= l.owner == Owner::a;
            s.in_b ^= l.owner == Owner::b;
          }
          if (!s.in_window) continue;
          state_[&*g] = s;
          stack.push_back(g);
        } while (++h != begin);
      };
      for (auto ccb = f->outer_ccbs_begin(); ccb != f->outer_ccbs_end(); ++ccb) across(*ccb);
      for (auto ccb = f->inner_ccbs_begin(); ccb != f->inner_ccbs_end(); ++ccb) across(*ccb);
    }
  }

  FaceState state(Face f) const {
    const auto found = state_.find(&*f);
    return found == state_.end() ? FaceState{} : found->second;
  }

  std::optional<Face> window_face_at(Point2 corner) const {
    // The window's border is anticlockwise through its corners: its halfedge that leaves this corner has the
    // window on its left.
    const Traits::Point_2 p(corner.x, corner.y);
    for (auto v = arrangement_->vertices_begin(); v != arrangement_->vertices_end(); ++v) {
      if (v->is_isolated() || v->point() != p) continue;
      auto h = v->incident_halfedges();
      const auto begin = h;
      do {
        const Halfedge out = h->twin();
        for (const Label& l : out->curve().data())
          if (l.owner == Owner::window && corners(window_)[l.index] == corner) return out->face();
      } while (++h != begin);
    }
    return std::nullopt;
  }

  bool along(Halfedge h, const SourceEdge& e) const {
    const bool forward = e.a.x != e.b.x ? e.a.x < e.b.x : e.a.y < e.b.y;
    return (h->direction() == CGAL::ARR_LEFT_TO_RIGHT) == forward;
  }

  bool on_boundary(Halfedge h) const {
    const FaceState left = state(h->face()), right = state(h->twin()->face());
    if (left.in_window && right.in_window) return (left.in_a || left.in_b) && !(right.in_a || right.in_b);
    if (left.in_window != right.in_window) return false;  // the window's own border
    for (const Label& l : h->curve().data())
      if (l.owner == Owner::a && along(h, a_[l.index])) return true;
    return false;
  }

  OutlinePiece piece(Halfedge h) const {
    OutlinePiece p;
    const auto& q = h->source()->point();
    p.at = {number(q.x()), number(q.y())};
    if (const auto found = starts_a_.find({p.at.x, p.at.y}); found != starts_a_.end())
      if (q == Traits::Point_2(p.at.x, p.at.y)) p.vertex = found->second;
    p.at = round_to_grid(p.at);
    for (const Label& l : h->curve().data()) {
      if (l.owner == Owner::a && along(h, a_[l.index])) p.edge_a = a_[l.index].slot;
      if (l.owner == Owner::b && along(h, b_[l.index])) p.edge_b = b_[l.index].slot;
    }
    return p;
  }

  Outline follow(Halfedge first) {
    Outline outline;
    Halfedge h = first;
    for (;;) {
      done_[&*h] = true;
      const OutlinePiece p = piece(h);
      // Where one source edge merely goes on (past the window's border, or where the other polygon met it),
      // no vertex is needed.
      const bool goes_on =
          !outline.pieces.empty() && p.vertex == kNoSlot && goes_on_from(outline.pieces.back(), p);
      if (goes_on) {
        if (outline.pieces.back().edge_a != p.edge_a) outline.pieces.back().edge_a = kNoSlot;
        if (outline.pieces.back().edge_b != p.edge_b) outline.pieces.back().edge_b = kNoSlot;
      } else {
        outline.pieces.push_back(p);
      }
      Halfedge next = h->next();
      for (std::size_t turns = 0; !on_boundary(next); next = next->twin()->next())
        if (next == h->twin() || ++turns > arrangement_->number_of_halfedges()) break;
      if (!on_boundary(next)) {  // an end outside the window
        const auto& q = h->target()->point();
        for (const SourceEdge& e : a_)
          if (e.slot == p.edge_a && q == Traits::Point_2(e.b.x, e.b.y)) outline.end = e.next;
        return outline;
      }
      if (done_.count(&*next)) break;
      h = next;
    }
    auto& pieces = outline.pieces;
    if (pieces.size() > 1 && pieces.front().vertex == kNoSlot &&
        goes_on_from(pieces.back(), pieces.front())) {
      const OutlinePiece front = pieces.front();
      pieces.erase(pieces.begin());
      if (pieces.back().edge_a != front.edge_a) pieces.back().edge_a = kNoSlot;
      if (pieces.back().edge_b != front.edge_b) pieces.back().edge_b = kNoSlot;
    }
    return outline;
  }

  static bool goes_on_from(const OutlinePiece& before, const OutlinePiece& p) {
    return (p.edge_a != kNoSlot && p.edge_a == before.edge_a) ||
           (p.edge_b != kNoSlot && p.edge_b == before.edge_b);
  }

  const std::vector<SourceEdge>&a_, &b_;
  Box2 window_;
  std::unique_ptr<Arrangement, DeleteWhole> arrangement_{new Arrangement};
  std::map<std::pair<double, double>, Slot> starts_a_;
  std::unordered_map<const void*, FaceState> state_;
  std::unordered_map<const void*, bool> done_;
};

}  // namespace

bool union_outlines(const std::vector<SourceEdge>& edges_a, const std::vector<SourceEdge>& edges_b,
                    const Box2& window, const std::vector<int>& corner_sides,
                    std::vector<Outline>& outlines) {
  UnionOutline outline(edges_a, edges_b, window);
  if (!outline.classify(corner_sides)) return false;
  outlines = outline.trace();
  return true;
}

}  // namespace limpet::geometry::internal
