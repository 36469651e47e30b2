// Copyright the limpet authors. GPL-3.0-or-later.
//
// Random degenerate perimeter operations; the whole polygon is judged from scratch after each. Batches run in
// child processes, so that a crash or a hang is counted and not fatal.
//
//   limpet_perimeter_operations [--operations N] [--seed S] [--json FILE] [--replay BATCH]
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/fissure.hpp>
#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/merge.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/unite.hpp>

#include "perimeter_figures.hpp"
#include "perimeter_laws.hpp"

namespace limpet::benchmarks {
namespace {

using namespace geometry;
using namespace shapes;

constexpr std::size_t kBatch = 2000;
constexpr unsigned kSecondsPerBatch = 20;

void print(const char* name, const Cycles& cycles) {
  std::fprintf(stderr, "  %s = {", name);
  for (const auto& c : cycles) {
    std::fprintf(stderr, "{");
    for (const NewVertex& v : c)
      std::fprintf(stderr, "{{%.17g, %.17g}%s}, ", v.at.x, v.at.y, v.shared ? ", {}, true" : "");
    std::fprintf(stderr, "},\n");
  }
  std::fprintf(stderr, "}\n");
}

class Batch {
 public:
  Batch(std::uint64_t seed, Figures& figures, bool verbose)
      : random_(seed), figures_(figures), verbose_(verbose) {}

  void run(std::size_t operations) {
    while (operations > 0) {
      begin_episode();
      for (std::int64_t k = random_.whole(1, 40); k > 0 && operations > 0; --k, --operations)
        if (!step()) break;
    }
  }

 private:
  void begin_episode() {
    ids_ = EdgeIds(1);
    scale_ = random_.chance(0.5) ? 1 : random_.scale(1, 1e6);
    gap_ = random_.chance(0.5) ? random_.scale(2, 20) * scale_ : random_.scale(2, 1e4);
    gap_ = std::floor(std::min(gap_, 1e4));
    place_ = random_.chance(0.7) ? 0 : random_.scale(1, 4e9);
    polygon_ = shape(5);
    polygon_.take_created();
  }

  /// A valid polygon; some edges are shared.
  Polygon shape(int tries, std::optional<Map> map = {}) {
    for (;; --tries) {
      Cycles cycles = tries > 0 ? raw_shape(random_) : Cycles{rectangle(0, 0, 3, 2)};
      if (!map) map = random_map(random_, scale_, place_);
      map_all(cycles, *map);
      if (random_.chance(0.2))
        for (auto& c : cycles)
          for (NewVertex& v : c) v.shared = random_.chance(0.1);
      if (auto p = Polygon::from_cycles(cycles, ids_)) return *std::move(p);
      if (tries < 0) std::abort();
    }
  }

  NewVertex any_vertex() {
    const Cycles cycles = cycles_of(polygon_);
    const auto& c =
        cycles[static_cast<std::size_t>(random_.whole(0, static_cast<std::int64_t>(cycles.size()) - 1))];
    return c[static_cast<std::size_t>(random_.whole(0, static_cast<std::int64_t>(c.size()) - 1))];
  }

  Point2 near_perimeter() {
    const Point2 a = any_vertex().at, b = any_vertex().at;
    const double reach = random_.chance(0.5) ? 3 : gap_;
    Point2 p = random_.chance(0.4) ? a
                                   : a + (random_.chance(0.3) ? 1 + 2 / (1 + std::sqrt(squared_length(b - a)))
                                                              : random_.unit()) *
                                             (b - a);
    if (random_.chance(0.9))
      p = p + Point2{(2 * random_.unit() - 1) * reach, (2 * random_.unit() - 1) * reach};
    return {std::floor(p.x), std::floor(p.y)};
  }

  /// Something to merge with: often the polygon's own shape, or one that lies on its vertices.
  Polygon operand() {
    Cycles cycles;
    if (random_.chance(0.3)) {
      cycles = cycles_of(polygon_);
      if (random_.chance(0.5)) cycles.resize(1);
      const Point2 p = any_vertex().at, q = any_vertex().at;
      const Point2 by = random_.chance(0.2)   ? Point2{0, 0}
                        : random_.chance(0.5) ? q - p
                                              : Point2{static_cast<double>(random_.whole(-3, 3)),
                                                       static_cast<double>(random_.whole(-3, 3))};
      for (auto& c : cycles)
        for (NewVertex& v : c) v.at = v.at + by, v.edge = {};
      if (auto p2 = Polygon::from_cycles(cycles, ids_)) return *std::move(p2);
    }
    Map map = random_map(random_, random_.chance(0.6) ? scale_ : random_.scale(1, 1 + scale_), 0);
    const Point2 at = random_.chance(0.6) ? any_vertex().at : near_perimeter();
    map.x = at.x, map.y = at.y;
    Cycles shift = {
        rectangle(0, 0, static_cast<double>(random_.whole(0, 6)), static_cast<double>(random_.whole(0, 6)))};
    map_all(shift, map);
    map.x -= shift[0][2].at.x - at.x, map.y -= shift[0][2].at.y - at.y;
    return shape(5, map);
  }

  bool step() {
    const auto kind =
        static_cast<Kind>(std::array{0, 0, 0, 1, 1, 2, 3, 3}[static_cast<std::size_t>(random_.whole(0, 7))]);
    figures_.running = kind;
    before_ = cycles_of(polygon_);
    polygon_.take_removed();
    std::optional<Polygon> other;
    Point2 q;
    std::vector<std::pair<Slot, EdgeId>> fresh;
    if (kind == kExtend) q = near_perimeter();
    if (kind == kMerge || kind == kUnite) other = operand();
    if (kind == kFill) {
      fresh = polygon_.take_created();
      if (fresh.empty() || random_.chance(0.3))
        for (std::uint32_t i = 0; i < polygon_.slot_count(); ++i)
          if (polygon_.alive(Slot{i})) fresh.emplace_back(Slot{i}, polygon_.node(Slot{i}).edge);
    }
    Outcome outcome = kNothing;
    std::size_t attempts = 0;
    bool fault = false;
    const auto begin = std::chrono::steady_clock::now();
    try {
      outcome = operate(kind, q, other, fresh, attempts);
    } catch (const std::exception&) {
      fault = true;
    }
    const auto ns = static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - begin)
            .count());
    ++figures_.operations;
    ++figures_.outcome[kind][outcome];
    figures_.total_ns[kind] += ns;
    figures_.longest_ns[kind] = std::max(figures_.longest_ns[kind], ns);
    if (kind == kUnite && outcome == kChanged) ++figures_.unite_attempt[std::min<std::size_t>(attempts, 7)];
    figures_.edges_max = std::max<std::uint64_t>(figures_.edges_max, polygon_.edge_count());
    figures_.holes_max = std::max<std::uint64_t>(figures_.holes_max, polygon_.hole_count());
    if (ns > 20'000'000) report(kind, "slow", q, other);
    if (outcome == kRefused && other) report(kind, "refused", q, other);
    const Fault found = fault ? kException : judge_result(outcome, other);
    if (found != kFaults) {
      ++figures_.fault[kind][found];
      report(kind, kFaultNames[found], q, other);
    }
    return found == kFaults && polygon_.edge_count() < 3000;
  }

  Outcome operate(Kind kind, Point2 q, const std::optional<Polygon>& other,
                  const std::vector<std::pair<Slot, EdgeId>>& fresh, std::size_t& attempts) {
    if (kind == kExtend) {
      const Extension e = extend_to_point(polygon_, q, gap_, ids_);
      return e == Extension::extended ? kChanged : e == Extension::refused ? kRefused : kNothing;
    }
    if (kind == kFill) return fill_fissures(polygon_, fresh, gap_, ids_) > 0 ? kChanged : kNothing;
    if (kind == kUnite) return unite(polygon_, *other, gap_, ids_, &attempts) ? kChanged : kRefused;
    const Merger m = merge_polygons(polygon_, *other, gap_, ids_);
    ++figures_.merger[static_cast<std::size_t>(m)];
    return m == Merger::united || m == Merger::bridged ? kChanged
           : m == Merger::refused                      ? kRefused
                                                       : kNothing;
  }

  Fault judge_result(Outcome outcome, const std::optional<Polygon>& other) {
    const Cycles after = cycles_of(polygon_);
    if (outcome != kChanged && !same(before_, after)) return kTouched;
    if (judge_cycles(after) != Verdict::valid) return kBroken;
    // The float builds would be judged by their own predicates alone otherwise.
    const bool audited = random_.chance(1.0 / 16) || std::strcmp(arithmetic(), "exact") != 0;
    if (audited && ++figures_.audited && !audit_accepts(after)) return kAudit;
    if (!identities_hold(after)) return kIdentity;
    // Coordinates are rounded, operands are moved by up to 32 steps.
    const double slack = 2 * length_of(before_) + (other ? 64 * length_of(cycles_of(*other)) : 0);
    if (area_of(after) < area_of(before_) * (1 - 1e-9) - slack) return kShrunk;
    return sides_hold(after) ? kFaults : kLocate;
  }

  /// Unique; what is gone was logged, once.
  bool identities_hold(const Cycles& after) {
    std::vector<EdgeId> old_ids, new_ids;
    for (const auto& c : before_)
      for (const NewVertex& v : c) old_ids.push_back(v.edge);
    for (const auto& c : after)
      for (const NewVertex& v : c) new_ids.push_back(v.edge);
    std::vector<EdgeId> removed = polygon_.take_removed();
    for (auto* ids : {&old_ids, &new_ids, &removed}) {
      std::sort(ids->begin(), ids->end());
      if (std::adjacent_find(ids->begin(), ids->end()) != ids->end()) return false;
    }
    for (const EdgeId id : old_ids)
      if (std::binary_search(new_ids.begin(), new_ids.end(), id) ==
          std::binary_search(removed.begin(), removed.end(), id))
        return false;
    return std::none_of(removed.begin(), removed.end(),
                        [&](EdgeId id) { return std::binary_search(new_ids.begin(), new_ids.end(), id); });
  }

  /// locate() against all edges.
  bool sides_hold(const Cycles& cycles) {
    std::vector<Segment2> edges;
    for (const auto& c : cycles)
      for (std::size_t i = 0; i < c.size(); ++i) edges.emplace_back(c[i].at, c[(i + 1) % c.size()].at);
    for (int k = 0; k < 4; ++k) {
      const Point2 p = near_perimeter();
      Polygon::Side side = inside_even_odd(edges, p) ? Polygon::Side::inside : Polygon::Side::outside;
      for (const auto& [a, b] : edges)
        if (segments_meet(a, b, p, p)) side = Polygon::Side::boundary;
      if (polygon_.locate(p) != side) return false;
    }
    return true;
  }

  void report(Kind kind, const char* what, Point2 q, const std::optional<Polygon>& other) {
    if (!verbose_) return;
    std::fprintf(stderr, "%s: %s gap %.17g operation %llu\n", what, kKindNames[kind], gap_,
                 static_cast<unsigned long long>(figures_.operations));
    print("a", before_);
    if (other) print("b", cycles_of(*other));
    if (kind == kExtend) std::fprintf(stderr, "  q = {%.17g, %.17g}\n", q.x, q.y);
    print("result", cycles_of(polygon_));
  }

  Random random_;
  Figures& figures_;
  bool verbose_;
  EdgeIds ids_;
  Polygon polygon_;
  Cycles before_;
  double scale_ = 1, gap_ = 2, place_ = 0;
};

std::uint64_t batch_seed(std::uint64_t seed, std::uint64_t batch) {
  return Random(seed * 1'000'003 + batch).bits();
}

/// Runs one batch in a child; what it counted before it died stays.
void run_batch(std::uint64_t seed, std::uint64_t batch, std::size_t operations, Figures& figures) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    // Of its own time: a loaded machine is no hang.
    const itimerval limit{{0, 0}, {kSecondsPerBatch, 0}};
    setitimer(ITIMER_VIRTUAL, &limit, nullptr);
    Batch(batch_seed(seed, batch), figures, false).run(operations);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const bool hang = WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM;
  ++(hang ? figures.hangs : figures.crashes);
  ++figures.operations;
  std::fprintf(stderr, "batch %llu %s during %s\n", static_cast<unsigned long long>(batch),
               hang ? "hung" : "crashed", figures.running < kKinds ? kKindNames[figures.running] : "setup");
}

int run(int argc, char** argv) {
  std::uint64_t operations = 20000, seed = 1, replay = ~std::uint64_t{0};
  const char* json = nullptr;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--operations")) operations = std::strtoull(argv[i + 1], nullptr, 10);
    if (!std::strcmp(argv[i], "--seed")) seed = std::strtoull(argv[i + 1], nullptr, 10);
    if (!std::strcmp(argv[i], "--replay")) replay = std::strtoull(argv[i + 1], nullptr, 10);
    if (!std::strcmp(argv[i], "--json")) json = argv[i + 1];
  }
  void* memory = mmap(nullptr, sizeof(Figures), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return 2;
  Figures& figures = *new (memory) Figures;
  const auto begin = std::chrono::steady_clock::now();
  if (replay != ~std::uint64_t{0}) {
    Batch(batch_seed(seed, replay), figures, true).run(kBatch);
  } else {
    for (std::uint64_t batch = 0; figures.operations < operations; ++batch) {
      const Figures before = figures;
      run_batch(seed, batch, std::min<std::size_t>(kBatch, operations - figures.operations), figures);
      for (std::size_t k = 0; k < kKinds; ++k)
        for (std::size_t i = 0; i < kFaults; ++i)
          if (figures.fault[k][i] != before.fault[k][i])
            std::fprintf(stderr, "batch %llu: %s, %s\n", static_cast<unsigned long long>(batch),
                         kKindNames[k], kFaultNames[i]);
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const std::string text = json_of(figures, seed, seconds.count());
  std::fputs(text.c_str(), stdout);
  if (json) {
    std::FILE* file = std::fopen(json, "w");
    if (!file) return 2;
    std::fputs(text.c_str(), file);
    std::fclose(file);
  }
  std::uint64_t faults = figures.crashes + figures.hangs;
  for (const auto& kind : figures.fault)
    for (const std::uint64_t n : kind) faults += n;
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace limpet::benchmarks

int main(int argc, char** argv) { return limpet::benchmarks::run(argc, argv); }
