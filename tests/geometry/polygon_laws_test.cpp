// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of judge.hpp and polygon.hpp.
#include "laws.hpp"

namespace limpet::geometry {
namespace {

Cycles mirrored(const Cycles& cycles) {
  Cycles result = shapes::mapped(cycles, shapes::kMirror);
  for (auto& cycle : result) cycle = reversed(cycle);
  return result;
}

// judge_cycles

TEST(JudgeCyclesLaws, ItAcceptsWhatIsValidByDefinition) {
  expect_law("judge_cycles in whole numbers", 4000, [] {
    const Boundary b = *boundaries();
    RC_ASSERT((judge_cycles(b.cycles) == Verdict::valid) == whole_numbers::is_valid(b.cycles));
  });
}

TEST(JudgeCyclesLaws, NoStartAndNoOrderOfHolesIsSpecial) {
  expect_law("judge_cycles (1)", 2000, [] {
    Cycles cycles = (*boundaries()).cycles;
    const Verdict verdict = judge_cycles(cycles);
    for (auto& c : cycles) std::rotate(c.begin(), c.begin() + whole(0, 99) % std::ssize(c), c.end());
    std::reverse(cycles.begin() + 1, cycles.end());
    RC_ASSERT(judge_cycles(cycles) == verdict);
  });
}

TEST(JudgeCyclesLaws, MotionsAndMirrorKeepTheVerdict) {
  expect_law("judge_cycles (2)", 2000, [] {
    const Cycles cycles = (*boundaries()).cycles;
    const Verdict verdict = judge_cycles(cycles);
    RC_ASSERT(judge_cycles(shapes::mapped(cycles, any_motion())) == verdict);
    RC_ASSERT(judge_cycles(mirrored(cycles)) == verdict);
  });
}

std::vector<KeyedEdge> keyed_edges(const Cycles& cycles) {
  std::vector<KeyedEdge> edges;
  for (const auto& c : cycles) {
    const std::uint64_t base = edges.size();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const std::size_t j = (i + 1) % c.size();
      edges.push_back({c[i].at, c[j].at, base + i, base + j});
    }
  }
  return edges;
}

TEST(FindConflictsLaws, TheyAreThoseOfAllPairs) {
  expect_law("in_conflict (1), find_conflicts (1)", 1500, [] {
    const auto edges = keyed_edges((*boundaries()).cycles);
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size(); ++j) {
        const KeyedEdge &e = edges[i], &f = edges[j];
        const bool conflict = in_conflict(e, f);
        RC_ASSERT(in_conflict(f, e) == conflict);
        RC_ASSERT(in_conflict({e.b, e.a, e.key_b, e.key_a}, f) == conflict);
        if (conflict) all.emplace_back(i, j);
      }
    RC_ASSERT(find_conflicts(edges) == all);
  });
}

// Polygon::locate

TEST(LocateLaws, ItIsWhatTheWindingNumberSays) {
  expect_law("locate (1)", 3000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const Polygon p = make(b.cycles, ids);
    for (int k = 0; k < 8; ++k) {
      const Point2 q = properties::telling_point(b.cycles, k);
      RC_LOG() << q << "\n";
      RC_ASSERT(static_cast<int>(p.locate(q)) - 1 == whole_numbers::locate(b.cycles, q));
    }
  });
}

TEST(LocateLaws, MotionsOrderAndStartsKeepIt) {
  expect_law("locate (2) (3)", 2000, [] {
    EdgeIds ids;
    const Boundary b = *polygons();
    const shapes::Map m = any_motion();
    Cycles moved = shapes::mapped(b.cycles, m);
    for (auto& c : moved) std::rotate(c.begin(), c.begin() + whole(0, 99) % std::ssize(c), c.end());
    std::reverse(moved.begin() + 1, moved.end());
    const Polygon p = make(b.cycles, ids), q = make(moved, ids);
    for (int k = 0; k < 4; ++k) {
      const Point2 at = properties::telling_point(b.cycles, k);
      RC_ASSERT(p.locate(at) == q.locate(m(at)));
    }
  });
}

// Polygon::judge and change

/// An edit, and the boundary that it makes by its definition.
struct EditCase {
  Edit edit;
  Cycles result;
};

EditCase any_edit(const Polygon& p) {
  EditCase made;
  const auto near = [&] { return properties::telling_point(p.boundary(), 3); };
  for (std::size_t c = 0; c < p.cycles().size(); ++c) {
    const Polygon::Cycle& cycle = p.cycles()[c];
    if (cycle.size == 0) continue;
    const auto vertices = p.vertices(cycle);
    const auto n = static_cast<std::int64_t>(vertices.size());
    const int kind = one_of(3);
    if (kind == 1) {  // a chain past some vertices
      const auto first = whole(0, 99) % n, passed = std::min(whole(0, 4), n - 2);
      Chain chain;
      chain.from = cycle.first;
      for (auto i = first; i > 0; --i) chain.from = p.next(chain.from);
      chain.to = p.next(chain.from);
      for (auto i = passed; i > 0; --i) chain.to = p.next(chain.to);
      auto& ring = made.result.emplace_back();
      for (auto i = whole(0, 2); i > 0; --i) chain.via.push_back({near()}), ring.push_back(chain.via.back());
      for (auto i = passed + 1; i <= n; ++i)
        ring.push_back({vertices[static_cast<std::size_t>((first + i) % n)].at});
      made.edit.chains.push_back(chain);
    } else if (kind == 2 && one_of(2)) {
      made.edit.removed_cycles.push_back(CycleId{static_cast<std::uint32_t>(c)});
    } else {
      made.result.push_back(vertices);
    }
  }
  if (one_of(4) == 3) {
    auto& loop = made.edit.loops.emplace_back();
    for (auto i = whole(3, 5); i > 0; --i) loop.push_back({near()});
    made.result.push_back(loop);
  }
  std::stable_sort(made.result.begin(), made.result.end(), [](const auto& a, const auto& b) {
    return whole_numbers::twice_area(a) > 0 && !(whole_numbers::twice_area(b) > 0);
  });
  return made;
}

TEST(ChangeLaws, ItIsMadeExactlyWhenItsResultIsValid) {
  expect_law("change (1) (2) (3)", Cases{4000, 0.6}, [] {
    EdgeIds ids;
    Polygon p = make((*polygons()).cycles, ids);
    for (int k = 0; k < 3; ++k) {
      const EditCase made = any_edit(p);
      const Polygon before = p;
      RC_LOG() << Boundary{before.boundary()} << " to " << Boundary{made.result} << "\n";
      const Verdict verdict = p.judge(made.edit);
      RC_ASSERT((verdict == Verdict::valid) == whole_numbers::is_valid(made.result));
      RC_ASSERT(p.change(made.edit, ids) == verdict);
      RC_CLASSIFY(verdict == Verdict::valid);
      if (verdict != Verdict::valid) {
        RC_ASSERT(same_boundary(before, p));
        RC_ASSERT(p.version() == before.version());
        continue;
      }
      RC_ASSERT(outline(p) == outline(made.result));
      const double wanted = static_cast<double>(whole_numbers::twice_area(made.result)) / 2;
      const Point2 size = p.box().high - p.box().low;
      RC_ASSERT(std::abs(p.area() - wanted) <= 1e-12 * size.x * size.y);
    }
  });
}

TEST(ChangeLaws, TheHistoryOfEditsDoesNotShow) {
  expect_law("locate (2) after edits", 1500, [] {
    EdgeIds ids;
    Polygon p = make((*polygons()).cycles, ids);
    for (int k = 0; k < 6; ++k) p.change(any_edit(p).edit, ids);
    const Cycles cycles = p.boundary();
    for (int k = 0; k < 6; ++k) {
      const Point2 q = properties::telling_point(cycles, k);
      RC_ASSERT(static_cast<int>(p.locate(q)) - 1 == whole_numbers::locate(cycles, q));
    }
  });
}

}  // namespace
}  // namespace limpet::geometry
