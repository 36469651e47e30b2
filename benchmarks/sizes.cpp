// Copyright the limpet authors. GPL-3.0-or-later.
#include "sections.hpp"

namespace limpet::benchmarks {

ThroughputTables measure_sizes(const SizeOptions& options, const Limits& limits) {
  ThroughputTables tables;
  for (const auto& order : options.orders)
    for (const int boxes : options.boxes)
      measure_throughput({.shape = "city:" + std::to_string(boxes),
                          .order = order,
                          .points = options.points_per_face * (5 * boxes + 1)},
                         options.throughput, limits, tables);
  return tables;
}

}  // namespace limpet::benchmarks
