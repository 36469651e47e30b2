// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "cloud.hpp"
#include "table.hpp"

/// What the report is made of. Each section runs its measurements one process after the other, tells their
/// progress on standard error and returns tables.
namespace limpet::benchmarks {

struct Limits {
  double peer_seconds = 60;      ///< for a process of a peer; beyond that it is ended and noted
  double own_seconds = 3600;     ///< for any other process
  std::string scratch = "/tmp";  ///< folder for clouds (56 bytes a point)
};

// ---- Throughput (throughput.cpp) ---------------------------------------------------------------

/// Names: limpet (in live sets, told λ and σ), limpet_default (as `limpet model SCAN`),
/// limpet_default_arrival; region_growing, ransac, also with _estimated, region_growing also with _sphere and
/// _sphere_estimated; polyfit.
const std::vector<std::string>& contestant_names();

struct ThroughputOptions {
  std::vector<std::string> contestants{"limpet", "region_growing", "region_growing_estimated", "ransac"};
  int runs = 3;       ///< of limpet; the best counts. Contestants take turns
  int peer_runs = 1;  ///< of the others
  bool stages = true;
};
struct ThroughputTables {
  ThroughputTables();
  Table contestants, stages;
};
/// All contestants on one cloud.
void measure_throughput(const CloudSpec&, const ThroughputOptions&, const Limits&, ThroughputTables&);

// ---- What a newcomer's first run takes (default_run.cpp) ------------------------------------------

struct DefaultRunOptions {
  bool full = false;  ///< with 10⁷ points and 5,001 faces
  ThroughputOptions throughput{.contestants = {"limpet_default", "limpet_default_arrival", "region_growing",
                                               "region_growing_estimated", "ransac", "polyfit"},
                               .runs = 2,
                               .stages = false};
};
/// `limpet model SCAN` with nothing given, beside CGAL's detectors. PolyFit where there are few faces.
Table measure_default_run(const DefaultRunOptions&, const Limits&);

// ---- Cities of n boxes, as many points for each face (sizes.cpp) ---------------------------------

struct SizeOptions {
  std::vector<int> boxes{1, 3, 10, 30, 100};
  std::vector<std::string> orders{"shuffled", "raster"};
  std::int64_t points_per_face = 1000;
  ThroughputOptions throughput;
};
ThroughputTables measure_sizes(const SizeOptions&, const Limits&);

// ---- One long stream, looked at on its way (streams.cpp) -----------------------------------------

struct StreamOptions {
  CloudSpec spec;
  std::int64_t first_mark = 100'000;
};
/// At the λ that suits the first mark, with 1 % outliers.
StreamOptions stream_of(const std::string& shape, std::int64_t points, std::int64_t first_mark);
Table measure_streams(const std::vector<StreamOptions>&, const Limits&);
Json answer_stream(const Json& request);

// ---- How long one set takes (latency.cpp) ---------------------------------------------------------

struct LatencyOptions {
  int boxes = 200;
  std::vector<std::string> orders{"sampled", "raster"};
  std::int64_t points_per_face = 1000;
  std::int64_t points_after = 1'000'000;
};
Table measure_latency(const LatencyOptions&, const Limits&);
Json answer_latency(const Json& request);

// ---- How long one set takes of clouds that are hard on a model (hostile.cpp) ----------------------

struct HostileOptions {
  std::vector<std::string> shapes{"holes", "combs", "planes", "noise", "city:200"};
  bool full = false;  ///< larger ones, too
};
struct HostileTables {
  HostileTables();
  Table times, growth;  ///< by shape and size; by shape and stage, against the number of points
};
HostileTables measure_hostile(const HostileOptions&, const Limits&);
Json answer_hostile(const Json& request);

// ---- How long questions to a model take (view.cpp) -------------------------------------------------

struct ViewOptions {
  std::vector<int> boxes{9, 200, 1000};
  std::int64_t points_per_face = 1000;
};
/// Questions of model::View, asked of cities as they stand after a scan, and finished.
Table measure_view(const ViewOptions&, const Limits&);
Json answer_view(const Json& request);

// ---- Whole polyhedra beside PolyFit's (polyhedra.cpp) ----------------------------------------------

struct PolyhedraOptions {
  std::vector<std::string> shapes{"cube", "L", "step_hole", "city:3", "city:5", "city:10", "room"};
  std::vector<std::int64_t> points{20'000, 100'000};  ///< for up to 16 faces; for more as many for each face
  std::vector<std::string> contestants{"limpet", "polyfit"};
};
Table polyhedra_table();
void measure_polyhedra(const PolyhedraOptions&, const Limits&, Table&);
/// Judges the mesh at "mesh" by the truth (judge_polyhedron.cpp).
Json answer_judgement(const Json& request);

// ---- The thresholds of redundancy (redundancy.cpp) --------------------------------------------------

struct RedundancyOptions {
  std::vector<std::string> rules{"limpet", "-dissolve,-position"};
  std::vector<double> psi{0, 20, 40, 80, 160}, phi{0.01, 0.05, 0.2};
  std::vector<std::string> shapes{"cube", "pyramid"}, orders{"raster", "shuffled"};
  std::int64_t points = 10'000;
  double noise_ratio = 0.01, outliers = 0;
  int seeds = 5;
};
/// All shapes, orders and seeds together, for each set of rules, ψ and φ.
Table measure_redundancy(const RedundancyOptions&);

}  // namespace limpet::benchmarks
