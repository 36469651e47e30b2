// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limpet/app/arguments.hpp>
#include <limpet/app/suggested_angle.hpp>
#include <limpet/audit/laws.hpp>
#include <limpet/model/open_edges.hpp>
#include <limpet/model/record.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace limpet::app {

/// What a run of `limpet model` comes to: the keys of --json (a contract), and the lines on standard output.
struct Summary {
  std::int64_t points = 0;     ///< accepted
  std::int64_t loose = 0;      ///< in point segments
  std::int64_t refused = 0;    ///< records that were no point
  std::int64_t expired = 0;    ///< given up as outliers
  std::int64_t confirmed = 0;  ///< on faces known beforehand
  std::int64_t sets = 0;
  std::int64_t segments = 0, polygons = 0, holes = 0;
  std::int64_t shared_edges = 0;  ///< corresponding pairs
  std::int64_t open_edges = 0;
  std::map<model::Refusal, std::int64_t>
      open_because;                               ///< of the open edges, by what refused them a neighbour
  std::optional<SuggestedAngle> suggested_angle;  ///< where μ keeps most of them open
  std::int64_t redundant_by_count = 0, redundant_by_position = 0;  ///< segments deleted (thesis §2.9)
  std::int64_t corner_vertices = 0;
  double corner_distance = 0;   ///< largest from a corner to a plane that should hold it, scan's unit
  std::int64_t violations = 0;  ///< the oracle's count
  double seconds = 0;           ///< reading and modelling; neither the oracle nor writing
  survey::ResolutionLaw resolution;
  double tolerance = 0;
  survey::NoiseLaw noise;
  bool in_arrival_order = true;
  std::int64_t order_disk_bytes = 0;  ///< written to put the scan in order
  bool axes_guessed = false;          ///< the scan says no axes: they were found by neighbour consistency
  bool interrupted = false;
  std::string damage;  ///< of the scan, after the last point

  bool closed() const { return polygons > 0 && open_edges == 0; }
};

/// The counts of what is in the model; what only the run knows (damage, seconds, violations) is left to the
/// caller.
Summary summarise(const model::ModelRecord& model, std::span<const model::OpenEdge> open_edges);

/// One JSON object, indented.
std::string to_json(const Summary& summary);
/// A few lines for people.
std::string to_text(const Summary& summary);

/// Largest resident set of this process so far, bytes.
std::int64_t peak_memory_bytes();

/// The oracle's judgement of a model as it would be written.
std::vector<audit::Violation> judge(const model::ModelRecord& model);

}  // namespace limpet::app
