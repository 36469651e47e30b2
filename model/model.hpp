// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <limpet/model/changes.hpp>
#include <limpet/model/open_edges.hpp>
#include <limpet/model/outcome.hpp>
#include <limpet/model/parameters.hpp>
#include <limpet/model/record.hpp>
#include <limpet/model/sensor_point.hpp>
#include <limpet/model/stage_times.hpp>

namespace limpet::model {

/// A face known beforehand, in the world, scan's unit: cycles with the interior on the left as seen from
/// outside, the outer one first, then the holes. Flat to within λ.
struct InitialFace {
  std::vector<std::vector<Eigen::Vector3d>> cycles;
};

/// Counts over the life of a model.
struct Counts {
  std::int64_t points = 0;   ///< sensor points accepted
  std::int64_t refused = 0;  ///< records that were no point
  std::int64_t expired = 0;  ///< sensor points given up as outliers
  std::int64_t loose = 0;    ///< sensor points in point segments
  std::int64_t sets = 0;
  std::int64_t point_segments = 0, polygons = 0, holes = 0;
  std::int64_t edges = 0, shared_edges = 0;
  std::int64_t redundant_by_count = 0, redundant_by_position = 0;  ///< segments deleted (thesis §2.9)
};

class View;

/// An incremental planar polyhedral surface model (thesis chapter 2).
///
///     Model model({.resolution = 0.05, .noise = 0.001});
///     while (robot.moves()) model.update(robot.sense());
///     model.finish();
///     io::save_mesh("model.off", model.record());
///
/// Here `robot` is the user's own; sense() gives the readings of one step, as a std::vector<SensorPoint>.
///
///  (1) After every call the promise of docs/exactness.md holds: each perimeter is a simple polygon,
///      anticlockwise, its holes inside and disjoint; and so do the other laws of audit/laws.cpp;
///  (2) the same calls give the same model, byte for byte;
///  (3) every reading is accounted for: it was refused, has expired, or is in exactly one segment;
///  (4) the changes a call returns tell all that happened to segments, edges and shared edges: who applies
///      them to a copy, and asks where the edges are that they name, has the model (changes.hpp);
///  (5) a shared edge has one partner, whose partner it is, on another segment of the same surface; so the
///      neighbour relation is symmetric, and a segment is in at most one surface;
///  (6) what is constant changes nothing that can be seen, and may be called by several threads at once;
///  (7) a reading that is none is counted and changes nothing else;
///  (8) a model from a record has that record;
///  (9) an empty set is counted and changes nothing else.
/// Not promised: the same polygons to the last bit when all readings move (charts and lifts are doubles), and
/// that a second finish() finds nothing to do (loose points are tried again, under new identities).
class Model {
 public:
  /// Throws std::invalid_argument when a parameter is out of range.
  explicit Model(const Parameters&);
  /// Goes on from a record. Throws std::invalid_argument when a perimeter in it is not valid. The laws hold
  /// of what follows, but it is not what the model of the record would have come to: for that there is
  /// from_state().
  explicit Model(const ModelRecord&);
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  /// Initial model segments (thesis §4.3): they represent no points, merge with nothing and are never
  /// modified, but share edges and corners with what is modelled. Throws std::invalid_argument when a face
  /// has no area or is no simple polygon; those before it stay.
  /// The changes are valid until the next call.
  const std::vector<Change>& add_initial(std::span<const InitialFace> faces);

  /// One set of sensor points, the unit of an update (thesis §2.3). Readings that are no point (coordinates
  /// not finite, no axis, or beyond 2^48 grid steps) are counted and left out. The changes are valid until
  /// the next call.
  const std::vector<Change>& update(std::span<const SensorPoint> set);

  /// At the end of input: tries everything once more until nothing changes, then again with sections looked
  /// for farther from their lines, and with short edges (at most 20 rounds each time). Points may follow all
  /// the same.
  const std::vector<Change>& finish();

  const Parameters& parameters() const;
  Counts counts() const;
  /// Everything, as plain data.
  ModelRecord record() const;
  /// To be asked about places, segments and edges (view.hpp).
  View view() const;

  /// All that what follows depends on, between two calls, as bytes: also what a record leaves out, as what is
  /// to be looked at next. The same model gives the same bytes. For this build of the program: what another
  /// version wrote may be refused. Some tens of bytes an edge, and eight a point where labels are kept.
  std::string state() const;
  /// Goes on where state() was taken: every later call changes the same, gives the same, and leaves the same
  /// state behind, to the bit, as if nothing had been in between. Throws std::invalid_argument when the bytes
  /// are damaged, or of another version or arithmetic.
  static Model from_state(std::string_view bytes);

  /// Connected components of the neighbour relation, each ascending, in the order of their lowest identity
  /// (thesis §2.2).
  std::vector<std::vector<SegmentId>> surfaces() const;

  /// The segment that one became part of by mergers, or itself; none when it is gone: dissolved, redundant,
  /// an outlier. What became of a point segment is known until the next call that changes the model; of a
  /// polygon, as long as what it became is there (some tens of bytes for each polygon that ever merged).
  SegmentId now(SegmentId) const;

  /// What finish() would close and leave open, with its reasons, if it were called now. Nothing is changed:
  /// it is tried on a copy, which takes about as long as state(), finish() and open_edges() together.
  Outcome would_finish() const;

  /// For each open edge the condition that last refused it a neighbour, with what finish() would try at last;
  /// by segment and edge. Empty where neighbours are not asked for. Takes about as long as one look of
  /// finish().
  std::vector<OpenEdge> open_edges() const;

  /// From now on remember which segment each sensor point went to (eight bytes a point).
  void keep_labels();
  /// For each point since keep_labels() the segment it is in now; 0 when it expired or was no point.
  std::vector<SegmentId> labels() const;

  /// From now on measure where time goes (a few nanoseconds a point); the model stays the same.
  void measure_stages();
  /// Since measure_stages(); all zero without it.
  StageTimes stage_times() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace limpet::model
