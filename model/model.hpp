// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
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

/// A face known beforehand, as boundary cycles (world, scan's unit): the outer one first, then the holes,
/// each with the interior on its left as seen from outside. Precondition, not checked: flat to within λ.
struct InitialFace {
  std::vector<std::vector<Eigen::Vector3d>> cycles;
};

/// Counts of what a model has taken in so far, and of what it consists of now.
struct Counts {
  std::int64_t points = 0;     ///< sensor points accepted
  std::int64_t refused = 0;    ///< readings that were no point (Model::update())
  std::int64_t expired = 0;    ///< points given up: outliers, and of redundant segments
  std::int64_t loose = 0;      ///< sensor points in point segments
  std::int64_t confirmed = 0;  ///< sensor points that lie on initial segments (Model::add_initial())
  std::int64_t sets = 0;
  std::int64_t point_segments = 0, polygons = 0, holes = 0;
  std::int64_t edges = 0, shared_edges = 0;
  std::int64_t redundant_by_count = 0, redundant_by_position = 0;  ///< segments deleted (thesis §2.9)
};

class View;

namespace internal {
struct Engine;
}

/// What every call on a model throws once an exception has left it half changed, or after it was moved from.
class ModelUnusable : public std::logic_error {
  using std::logic_error::logic_error;
};

/// An incremental planar polyhedral surface model (thesis chapter 2).
///
///     Model model({.resolution = 0.05, .noise = 0.001});
///     while (robot.moves()) model.update(robot.sense());
///     model.finish();
///     io::save_mesh("model.off", model.record());
///
/// Here `robot` is the user's own class; sense() returns the readings of one step, as a
/// std::vector<SensorPoint>.
///
///  (1) After every call the promise of docs/exactness.md holds: each perimeter is a simple polygon,
///      anticlockwise, its holes inside and disjoint; and so do the other laws of audit/laws.cpp;
///  (2) the same calls give the same model, byte for byte;
///  (3) every reading is accounted for: it was refused, has expired, lies on an initial segment, or is in
///      exactly one segment;
///  (4) the changes that a call returns tell everything that happened to segments, edges and shared edges: a
///      caller can keep a copy by applying them and asking where the named edges are now (changes.hpp);
///  (5) a shared edge has one partner, on another segment of the same surface, and is its partner's partner;
///      so the neighbour relation is symmetric, and a segment is in at most one surface;
///  (6) constant member functions change nothing observable, and may be called by several threads at once;
///  (7) a refused reading is counted, has the label 0, and changes nothing else;
///  (8) a model made from a record has that record;
///  (9) an empty set is counted and changes nothing else;
///  (10) a call that changes the model and is ended by an exception (std::bad_alloc, in practice) leaves it
///      half changed, and every later call throws ModelUnusable; it may be destroyed, moved, and assigned to.
///      A face that add_initial() refuses, a parameter or a record leaves nothing half changed, and neither
///      does a constant member function that throws: the model is as it was, and goes on.
/// Not promised: the same polygons to the last bit when all readings are moved together (charts and lifts are
/// doubles); and that a second finish() changes nothing (points in point segments are inserted again, under
/// new identities).
class Model {
 public:
  /// Throws std::invalid_argument when a parameter is out of range.
  explicit Model(const Parameters&);
  /// Continues from a record. Throws std::invalid_argument, with the reason, when a parameter is out of range
  /// or the grid step another than theirs, a number is not finite or beyond what a model can hold
  /// (docs/native_format.md, "Limits"), a perimeter is not valid, an identity is 0 or occurs twice, a shared
  /// edge has no partner or joins parallel planes, or a segment is confirmed that is not an initial one. The
  /// laws hold for what follows, but later calls may give other results than on the recorded model;
  /// from_state() keeps these.
  explicit Model(const ModelRecord&);
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  /// Adds initial model segments (thesis §4.3): they represent no points, merge with nothing and are never
  /// modified, but share edges and corners with other segments. Where exactly two of these faces have an edge
  /// in common, from one vertex to the same other one and back, they share it at once, at less than μ, too,
  /// but for angles of about a degree and less.
  ///
  /// A reading that lies on one of them confirms it: it is counted, and makes no segment. It lies on it when
  /// it was sensed from outside, its projection is inside the perimeter or on it, and it is no farther from
  /// the plane than a reading may be from that of a polygon with many points: the tolerance, or three
  /// standard deviations if that is more, and less than λ. A polygon that the reading fits comes before the
  /// initial segment if it is nearer and at an angle of more than μ to it, as a neighbour near the common
  /// edge. Readings farther from the plane, or from behind, are modelled like any others: they contradict it.
  ///
  /// Throws std::invalid_argument when a face has fewer than three vertices, no area, a vertex that is not
  /// finite or beyond 2^48 grid steps, is wider than 2^40 of them, or is no simple polygon; the faces before
  /// it stay. The changes are valid until the next call.
  const std::vector<Change>& add_initial(std::span<const InitialFace> faces);

  /// Takes in one set of sensor points, the unit of an update (thesis §2.3). Readings that are no point are
  /// counted and left out: position, axis or range not finite, axis zero, or position beyond 2^48 grid steps.
  /// The changes are valid until the next call.
  const std::vector<Change>& update(std::span<const SensorPoint> set);

  /// At the end of input: repeats steps 2 to 5 of the update until nothing changes; then again with sections
  /// searched for farther from their lines, and again with short edges allowed (at most 20 rounds each time).
  /// Does nothing without the rule `finish`. More sets may follow.
  ///
  /// `stop`, where there is one, is asked again and again, some thousands of times a second, and must go on
  /// saying true once it has. Then finish() ends early: all that a call promises holds, with more edges open,
  /// and a later finish() takes up what is left.
  const std::vector<Change>& finish(const std::function<bool()>& stop = {});

  const Parameters& parameters() const;
  Counts counts() const;
  /// The whole model as plain data, for the native file.
  ModelRecord record() const;
  /// Answers questions about places, segments and edges (view.hpp).
  View view() const;

  /// Everything that later calls depend on, as bytes: also what a record leaves out, such as the worklists.
  /// The same model gives the same bytes. Another version may refuse them. Some tens of bytes per edge, and
  /// eight per reading where labels are kept.
  std::string state() const;
  /// The model of which state() gave these bytes: every later call has the same effects and results, to the
  /// bit, as on the original. Throws std::invalid_argument when the bytes are damaged, or of another version
  /// or arithmetic.
  static Model from_state(std::string_view bytes);

  /// The surfaces: connected components of the neighbour relation (thesis §2.2). Each is ascending, and they
  /// are ordered by lowest identity. A segment without neighbours is a surface of its own.
  std::vector<std::vector<SegmentId>> surfaces() const;

  /// The segment that this one has become part of by mergers, or this one itself; none when it was dissolved,
  /// redundant or an outlier. Of merged point segments and redundant polygons this is known until the next
  /// call that changes the model, and not after from_state(); of other polygons, as long as the result exists
  /// (some tens of bytes for each one that ever merged).
  SegmentId now(SegmentId) const;

  /// Which open edges finish() would close if it were called now, and why it would leave others open. It is
  /// tried on a copy, which takes about as long as state(), finish() and open_edges() together.
  Outcome would_finish() const;

  /// For each open edge, the condition that refuses it a neighbour now, at the reach of the last rounds of
  /// finish(); by segment, then edge. Empty when Parameters::neighbours is off. Takes about as long as one
  /// round of finish().
  std::vector<OpenEdge> open_edges() const;

  /// From now on, remembers which segment each reading went to (eight bytes per reading).
  void keep_labels();
  /// For each reading since keep_labels(), in order of arrival, the segment it is in now, or the initial
  /// segment that it confirms; 0 when it was refused or given up.
  std::vector<SegmentId> labels() const;

  /// From now on, measures the time of each stage (a few nanoseconds per point). The model is not affected.
  void measure_stages();
  /// The times since measure_stages(); all zero if it was not called.
  StageTimes stage_times() const;

 private:
  struct State;

  /// Throws ModelUnusable where there is none that is whole.
  const internal::Engine& engine() const;
  template <class Call>
  const std::vector<Change>& change(Call&& call);

  std::unique_ptr<State> state_;
};

}  // namespace limpet::model
