// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "run_case.hpp"

namespace limpet::benchmarks {

/// How times of single sets are spread, microseconds.
struct Spread {
  std::int64_t count = 0;
  double mean = 0, median = 0, p99 = 0, max = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Spread, count, mean, median, p99, max)

Spread spread_of(const std::vector<double>& times);

/// What one run comes to. All but counts and times of the run are judged by the truth (evaluation/).
struct RunFigures {
  std::string failed;  ///< why there is nothing else; empty: there is
  std::string ended;   ///< as in docs/following.md
  std::int64_t sets = 0, polygons = 0, open_edges = 0;
  double path = 0;
  double area = 0;  ///< of the true surface, but for initial faces
  bool closed = false;
  bool isomorphic = false;            ///< to the whole truth
  bool isomorphic_reachable = false;  ///< to the truth over the faces that can be reached throughout
  bool reachable_throughout = false;  ///< each face is one of these
  double reachable = 0, coverage = 0, coverage_total = 0;  ///< shares of area
  std::int64_t collisions = 0;
  double clearance = 0;  ///< smallest distance of the control point from the truth, over δ − λ
  /// Of an arm: steps on which a link touched the surface or another link; smallest distances of links from
  /// the surface and from each other, over λ. Of a robot without links 0.
  std::int64_t link_collisions = 0;
  double link_clearance = 0, link_own_clearance = 0;
  std::int64_t unreachable = 0, unclosable = 0, false_unreachable = 0;
  std::int64_t tour_sets = 0, tour_transit = 0;  ///< of the offline tour; 0: there is none
  double tour_path = 0;
  Spread step, asking, update;  ///< of deciding without and with a look at what would close; of modelling
  std::int64_t oracle_models = 0, violations = 0;
  double seconds = 0, judge_seconds = 0;  ///< of the run; of judging it
  double resolution = 0;

  /// Seconds of deciding and modelling, for each set.
  double seconds_per_set() const;
  /// Did it end by itself with nothing left to do?
  bool complete() const { return ended == "complete"; }
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunFigures, failed, ended, sets, polygons, open_edges, path, area, closed,
                                   isomorphic, isomorphic_reachable, reachable_throughout, reachable,
                                   coverage, coverage_total, collisions, clearance, link_collisions,
                                   link_clearance, link_own_clearance, unreachable, unclosable,
                                   false_unreachable, tour_sets, tour_transit, tour_path, step, asking,
                                   update, oracle_models, violations, seconds, judge_seconds, resolution)

/// Makes a run in this process, and judges it. Throws what make_setup(), FollowRun and judge_run() do.
RunFigures measure_run(const RunCase&);

}  // namespace limpet::benchmarks
