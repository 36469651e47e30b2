// Copyright the limpet authors. GPL-3.0-or-later.
//
// All that a const Polygon is asked, by several threads at once.
#include <limpet/geometry/search.hpp>

#include "../geometry/perimeters.hpp"
#include "readers.hpp"

namespace limpet::geometry {
namespace {

using threads::Answer;
using threads::Question;

constexpr double kGap = 40;  // grid steps

/// Candidate changes, valid and not: one chain in place of a few edges, two chains that join or split cycles,
/// removed cycles, and new holes.
std::vector<Edit> some_edits(const Polygon& p) {
  Random random(1);
  const auto any_slot = [&] { return Slot{static_cast<std::uint32_t>(random.bits() % p.slot_count())}; };
  const auto any_points = [&] {
    std::vector<NewVertex> points;
    for (auto n = random.whole(0, 2); n > 0; --n) points.push_back({telling_point(random, p, kGap / 2)});
    return points;
  };
  std::vector<Edit> edits(60);
  for (std::size_t k = 0; k < edits.size(); ++k) {
    const Slot from = any_slot(), other = any_slot();
    if (k % 4 == 1) {
      edits[k].chains = {{from, any_points(), p.next(other)}, {other, any_points(), p.next(from)}};
    } else if (k % 8 == 2) {
      edits[k].removed_cycles = {p.node(from).cycle};
    } else if (k % 8 == 6) {
      const Point2 q = telling_point(random, p, kGap);
      edits[k].loops = {reversed(rectangle(q.x, q.y, q.x + 3, q.y + 3))};
    } else {
      edits[k].chains = {{from, any_points(), p.next(random.chance(0.5) ? from : p.next(from))}};
    }
  }
  return edits;
}

std::vector<Point2> some_points(const Polygon& p) {
  Random random(2);
  std::vector<Point2> points;
  for (int k = 0; k < 60; ++k) points.push_back(telling_point(random, p, kGap));
  return points;
}

double number(Slot s) { return static_cast<double>(static_cast<std::uint32_t>(s)); }

/// The polygon and what it is asked about.
class Asked {
 public:
  explicit Asked(Polygon polygon)
      : polygon_(std::move(polygon)), edits_(some_edits(polygon_)), points_(some_points(polygon_)) {}

  std::vector<Question> questions() const {
    return {[this] { return verdicts(); }, [this] { return sides(); },   [this] { return sights_between(); },
            [this] { return near(); },     [this] { return nearest(); }, [this] { return state(); },
            [this] { return boundary(); }};
  }

  Answer verdicts() const {
    Answer answer;
    for (const Edit& edit : edits_) answer.push_back(static_cast<double>(polygon_.judge(edit)));
    return answer;
  }

 private:
  Answer sides() const {
    Answer answer;
    for (const Point2 p : points_) answer.push_back(static_cast<double>(polygon_.locate(p)));
    return answer;
  }
  Answer sights_between() const {
    Answer answer;
    for (std::size_t i = 1; i < points_.size(); ++i)
      answer.push_back(sights(polygon_, {points_[i - 1]}, {points_[i]}));
    return answer;
  }
  Answer near() const {
    Answer answer;
    for (const Point2 p : points_)
      polygon_.any_edge_near(Box2{p, p}.grown(kGap),
                             [&](Slot s) { return answer.push_back(number(s)), false; });
    return answer;
  }
  Answer nearest() const {
    Answer answer;
    for (const Point2 p : points_)
      if (const auto found = nearest_perimeter_point(polygon_, p, kGap))
        answer.insert(answer.end(), {number(found->edge), found->fraction, found->squared_distance});
    return answer;
  }
  Answer state() const {
    const PolygonState state = polygon_.state();
    Answer answer{state.twice_area, static_cast<double>(state.version),
                  static_cast<double>(state.index_edges)};
    for (const auto& n : state.nodes)
      answer.insert(answer.end(), {n.at.x, n.at.y, number(n.next), static_cast<double>(n.edge.value)});
    return answer;
  }
  Answer boundary() const {
    Answer answer;
    for (const auto& cycle : polygon_.boundary())
      for (const NewVertex& v : cycle)
        answer.insert(answer.end(), {v.at.x, v.at.y, static_cast<double>(v.edge.value)});
    return answer;
  }

  const Polygon polygon_;
  const std::vector<Edit> edits_;
  const std::vector<Point2> points_;
};

Polygon enlarged(Cycles cycles) {
  shapes::map_all(cycles, {10, 0, 0, 10});
  EdgeIds ids;
  return make(cycles, ids);
}

void expect_readers_agree(const Cycles& cycles) {
  const Asked asked(enlarged(cycles));
  const Answer verdicts = asked.verdicts();
  const auto valid = std::count(verdicts.begin(), verdicts.end(), static_cast<double>(Verdict::valid));
  ASSERT_GT(valid, 2);
  ASSERT_LT(valid, static_cast<std::ptrdiff_t>(verdicts.size()) - 2);
  threads::expect_same_answers(asked.questions());
}

TEST(PolygonReaders, OfFewEdges) { expect_readers_agree(shapes::ring(4, 9)); }

TEST(PolygonReaders, OfManyEdges) { expect_readers_agree(shapes::comb(60, 3, 2, 30, 4)); }  // with an index

TEST(PolygonReaders, OfManyHoles) { expect_readers_agree(shapes::sieve(6, 5, 4, 3, 3)); }

}  // namespace
}  // namespace limpet::geometry
