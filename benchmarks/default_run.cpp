// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>

#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

struct Entry {
  const char* shape;
  std::int64_t points;
  bool few_faces = true;
  double noise_ratio = 0.002;
};

/// Cities at one density of points, to see whether the time a point takes grows with their number.
std::vector<Entry> entries(bool full) {
  constexpr bool kMany = false;  // faces: PolyFit's candidates are too many
  std::vector<Entry> all{{"cube", 10'000},
                         {"cube", 100'000},
                         {"cube", 1'000'000},
                         {"step_hole", 100'000, true, 0.0005},
                         {"room", 100'000, kMany, 0.0005},
                         {"city:10", 100'000, kMany},
                         {"city:100", 1'000'000, kMany}};
  if (full) all.insert(all.end(), {{"cube", 10'000'000, kMany}, {"city:1000", 10'000'000, kMany}});
  return all;
}

}  // namespace

Table measure_default_run(const DefaultRunOptions& options, const Limits& limits) {
  ThroughputTables tables;
  for (const Entry& e : entries(options.full)) {
    ThroughputOptions throughput = options.throughput;
    if (!e.few_faces) std::erase(throughput.contestants, "polyfit");
    measure_throughput(
        {.shape = e.shape, .order = "shuffled", .points = e.points, .noise_ratio = e.noise_ratio}, throughput,
        limits, tables);
  }
  return tables.contestants;
}

}  // namespace limpet::benchmarks
