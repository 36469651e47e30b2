// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <limpet/geometry/chart.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/model/fit.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/moments.hpp>
#include <limpet/model/spatial_index.hpp>

#include "places_internal.hpp"
#include "relief_internal.hpp"
#include "series_internal.hpp"
#include "stage_clock_internal.hpp"

/// The state behind a Model and the operations of chapter 2 on it, one file each. Nothing here is installed.
namespace limpet::model::internal {

/// Young segments keep their sensor points: up to this many, and, where points lie densely, up to kMostYoung
/// of them while they span less than kYoungArea (λ²), which is what so many span where they do not.
inline constexpr std::int64_t kYoung = 64, kMostYoung = 512;
inline constexpr double kYoungArea = 12;
/// A sensor point goes through at most this many dissolved segments.
inline constexpr int kMaxReturns = 4;

struct RawPoint {
  GridPoint at{};
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  double variance = 0;  ///< about its plane: noise, grid and input rounding together
  int returned = 0;
  std::int64_t since = -1;   ///< counts.points when it came; not yet: −1
  std::int64_t serial = -1;  ///< place in the labels, when they are kept
};

/// What a planar polygon segment has beyond a point segment.
struct PolygonPart {
  geometry::Chart chart;
  geometry::Polygon perimeter;
  geometry::Lift published;                           ///< plane that perimeters are lifted to
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();  ///< normal of the published plane
  geometry::Plane initial;                            ///< thesis §2.4.1
  Box3 box;                                           ///< of the perimeter in the world
  Relief relief;                                      ///< none while young
  Places changed;           ///< where the description has changed since step 2 last saw it
  bool stale = false;       ///< the fit has moved on, but its plane could not be published
  double counted_area = 0;  ///< what of its area is in Engine::modelled_area, λ²
  std::uint64_t shape = 0;  ///< counts changes of the description
  std::vector<std::pair<geometry::Slot, geometry::EdgeId>> fresh;  ///< edges not yet looked at for fissures
  std::vector<geometry::EdgeId> shared;       ///< its edges that are shared with neighbours, ascending
  Places unshared;                            ///< where the description has changed since step 4 last saw it
  std::int64_t next_share = 0;                ///< count of its points at which step 4 looks at it again
  bool shared_later = false;                  ///< it is in Engine::share_later
  std::vector<geometry::EdgeId> corners_due;  ///< shared edges that step 5 has not seen yet

  /// A vertex in the world.
  Eigen::Vector3d position(geometry::Slot s) const {
    const geometry::Point2 v = perimeter.at(s);
    return chart.at(v, published(v));
  }
  geometry::Plane plane() const { return published.plane(chart); }
};

/// One copy of a shared edge: where it is, and its other copy (thesis §2.2).
struct SharedEdge {
  std::uint32_t segment = 0;  ///< slot of its segment
  geometry::Slot slot = geometry::kNoSlot;
  geometry::EdgeId partner;
};

struct alignas(64) Segment {
  Fit fit;
  std::unique_ptr<PolygonPart> polygon;  ///< none: a point segment
  SegmentId id;
  std::uint32_t slot = 0;
  Moments moments;
  Eigen::Vector3d axis_sum = Eigen::Vector3d::Zero();
  double variance_sum = 0;    ///< of its points
  std::int64_t next_fit = 0;  ///< count at which the fit is computed anew
  std::vector<RawPoint> raw;  ///< all its points while young, else none
  std::size_t seen = 0;       ///< of these, how many dissolve_young() has tried on mature polygons
  double since_sum = 0;       ///< of its points while young: counts.points when they came
  std::int64_t last_joined = 0;
  Box3 indexed;  ///< as it is in the spatial index
  bool indexed_as_polygon = false;
  bool modified = false;

  /// Mean variance of a point about its plane.
  double variance() const {
    return variance_sum / static_cast<double>(std::max<std::int64_t>(moments.count(), 1));
  }
  bool young() const { return !raw.empty(); }
  /// Known beforehand (thesis §4.3): represents no points.
  bool initial() const { return polygon && moments.count() == 0; }
  bool mature_polygon() const { return polygon && !young() && !initial(); }
};

/// How far steps 4 and 5 go, in λ.
struct SharingReach {
  double section = 1;  ///< how far a section that gives way to a shared edge may be from its line
  double least = 2;    ///< no shorter edge makes two segments neighbours
};

using SlotPair = std::pair<std::uint32_t, std::uint32_t>;

struct Engine {
  explicit Engine(const Parameters&);

  Parameters parameters;
  double step = 0;                      ///< grid step, scan's unit
  double rounding = 0;                  ///< variance of grid and input rounding together
  double gap = 0;                       ///< λ in grid steps
  double sin_angle = 0, cos_angle = 0;  ///< of μ

  geometry::EdgeIds edge_ids;
  std::uint64_t next_segment = 1;
  std::vector<std::unique_ptr<Segment>> segments;  ///< by slot
  std::vector<std::uint32_t> free_slots;
  SpatialIndex polygons, points;     ///< of polygon and point segments, boxes fattened by λ
  double modelled_area = 0;          ///< of all polygons, λ²
  std::int64_t modelled_points = 0;  ///< in all polygons

  Counts counts;
  std::vector<std::uint32_t> modified;    ///< slots whose flag is set (thesis §2.3)
  std::vector<std::uint32_t> to_share;    ///< slots that were modified since step 4 was last taken
  std::deque<std::uint32_t> share_later;  ///< slots of polygons that have changed, but were not due then
  /// Pairs of slots that step 4 has to look at, the lower one first, and where; and the last it looked at.
  std::map<SlotPair, Places> looks_due;
  SlotPair last_look{};
  std::int64_t looked_at = 0;  ///< counts.points then
  std::vector<Change> changes;
  std::deque<RawPoint> pending;                           ///< sensor points to be inserted (again)
  std::deque<std::pair<std::int64_t, SegmentId>> by_age;  ///< (last joined, segment), for expiry
  std::unordered_map<std::uint64_t, std::uint32_t> slot_of;
  /// Pairs whose merger the geometry refused, with their shapes at that time: not tried again until one has
  /// changed.
  std::map<std::pair<SegmentId, SegmentId>, std::pair<std::uint64_t, std::uint64_t>> refused_pairs;

  bool labels_kept = false;
  std::vector<std::uint64_t> labels;                               ///< segment each point joined
  std::unordered_map<std::uint64_t, std::uint64_t> label_goes_to;  ///< merged segments

  std::unordered_map<std::uint64_t, SharedEdge> shared;  ///< by the edge's identity
  /// Of each pair of neighbours, by pair_key(), the copies on the one that is in the lower slot, ascending.
  std::unordered_map<std::uint64_t, std::vector<geometry::EdgeId>> neighbour_edges;
  std::vector<SegmentId> redundant;                      ///< found so by step 4, to be deleted behind it
  std::set<std::pair<SegmentId, SegmentId>> disordered;  ///< dissolved: not tried again before the next set
  int ends_held = 0;                                     ///< see with_ends_apart()
  std::vector<geometry::EdgeId> ends_due;                ///< shared edges whose ends are to be looked at then
  bool finishing = false;
  SharingReach sharing;

  std::vector<std::uint32_t> found;  ///< scratch of queries
  StageClock stage_clock;

  Eigen::Vector3d world(const GridPoint& p) const {
    return step *
           Eigen::Vector3d(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
  }
  /// Variance of a point about its plane, sensed from `range`.
  double variance_at(double range) const {
    const Parameters& p = parameters;
    const double sigma = p.noise + (p.noise_per_range + p.noise_per_range2 * range) * range;
    return sigma * sigma + rounding;
  }
  bool noise_grows() const { return parameters.noise_per_range > 0 || parameters.noise_per_range2 > 0; }
  Segment& at(std::uint32_t slot) { return *segments[slot]; }
  const Segment& at(std::uint32_t slot) const { return *segments[slot]; }
  Segment* find(SegmentId);
  /// The segment if it is still in the slot it was in.
  Segment* find(SegmentId id, std::uint32_t slot) {
    return segments[slot] && segments[slot]->id == id ? segments[slot].get() : nullptr;
  }
  const Rules& rules() const { return parameters.rules; }
};

/// Does an outward normal face away from where the sensing axes point? With a margin, so that it holds
/// exactly, too.
inline bool faces_outside(const Eigen::Vector3d& normal, const Eigen::Vector3d& axis_sum) {
  return normal.dot(axis_sum) < -1e-6;
}

// engine.cpp: segments and their bookkeeping
/// With an identity and a place of its own.
Segment& new_segment(Engine&);
/// Not yet in the spatial index.
Segment& create_point_segment(Engine&, const RawPoint&);
void erase_segment(Engine&, Segment&);
void mark_modified(Engine&, Segment&);
void update_index(Engine&, Segment&);
void set_label(Engine&, const RawPoint&, SegmentId);
void forward_label(Engine&, SegmentId from, SegmentId to);
/// Makes labels name the segments where the points are now; 0: nowhere. Nothing else is changed by it.
void settle_labels(Engine&);
/// Notes that the description changed in `where` (world).
void description_changed(Engine&, Segment&, const Places& where);
void count_area(Engine&, PolygonPart&);
/// Of the segments in these slots the polygons that `has_turn`, each once, by identity. What they merge into
/// is not among them: ask find() before each.
using Turn = std::vector<std::pair<SegmentId, std::uint32_t>>;
template <class F>
Turn polygons_of(const Engine& e, const std::vector<std::uint32_t>& slots, F&& has_turn) {
  Turn turn;
  for (const std::uint32_t slot : slots)
    if (const Segment* s = e.segments[slot].get(); s && s->polygon && has_turn(*s->polygon))
      turn.emplace_back(s->id, slot);
  std::sort(turn.begin(), turn.end());
  turn.erase(std::unique(turn.begin(), turn.end()), turn.end());
  return turn;
}
/// The polygon segments near these places, but for the one in this slot, by identity.
Turn polygons_near(Engine&, const Places&, std::uint32_t but);
/// World boxes.
Box3 box_around(const Eigen::Vector3d& p, double reach);
Box3 perimeter_box(const PolygonPart&);

// places.cpp
/// Slots of segments near the places, in ascending order.
void query(const SpatialIndex&, const Places&, std::vector<std::uint32_t>& found);
/// Where those of the edges lie that are still there.
Places places_of(const PolygonPart&, std::span<const std::pair<geometry::Slot, geometry::EdgeId>> edges);

// insert.cpp: a sensor point finds its segment (thesis §2.3 step 2a for points)
void insert_point(Engine&, const RawPoint&);
void insert_pending(Engine&);

// merge_points.cpp: §2.4.1
enum class PointMerger { refused, point, polygon };
PointMerger merge_point_segments(Engine&, Segment& into, Segment& from);
/// At a few points per λ², point segments settle about λ apart with too few points each for a normal: a point
/// segment and the young ones around it that lie in one plane with it may know it together. Whether the seed
/// is a polygon now.
bool promote_patch(Engine&, Segment& seed);

/// May a segment with so many points, spread as the fit says, still be young?
bool may_be_young(const Engine&, std::int64_t count, const Fit&);

// promotion.cpp: when a segment is a polygon
/// Is the normal known well enough to be a polygon's? `raw` are all the points behind the fit, or none.
/// `variance` is one point's about its plane; `since_sum` that of their times.
bool promotable(const Engine&, const Fit&, double variance, const Eigen::Vector3d& axis_sum,
                const std::vector<const std::vector<RawPoint>*>& raw, double since_sum);
/// Have far fewer points come to it, while they waited, than to the rest of the scene?
bool too_few_arrived(const Engine&, const Fit&, double since_sum);
/// The same of a point segment, which stands for about λ² of surface if it is any.
bool points_came_too_slowly(const Engine&, const Segment& point_segment);
/// Chart and diamond (thesis §2.4.1); nothing when that is too small for the grid.
std::unique_ptr<PolygonPart> diamond_part(Engine&, const Fit&);
/// Makes a point segment a polygon and extends its diamond to the points it keeps.
void promote(Engine&, Segment&, std::unique_ptr<PolygonPart>);

// merge_point_polygon.cpp: §2.4.2
/// How a point stands to a polygon segment; `distance2` is from the polygon, squared.
struct Standing {
  bool near = false;  ///< nearer than λ, on the right side, and fitting
  double distance2 = 0;
  bool outside = false;           ///< of the perimeter
  double perimeter_distance = 0;  ///< grid steps, when outside
  geometry::Point2 chart_point;
};
/// Largest squared residual that data of this variance centred at p may have about the segment's plane.
double residual_limit(const Engine&, const Segment& polygon, const Eigen::Vector3d& p, double variance);
Standing standing(const Engine&, const Segment& polygon, const Eigen::Vector3d& p,
                  const Eigen::Vector3d& axis, double squared_residual, double variance);
bool merge_point_into_polygon(Engine&, Segment& polygon, const RawPoint&, const Standing&);
bool merge_segment_into_polygon(Engine&, Segment& polygon, Segment& point_segment, const Standing&);

// relief.cpp
/// Does a polygon keep its relief? Only where its points may lie farther off its plane than the noise says.
bool relief_kept(const Engine&);
void add_to_relief(const Engine&, PolygonPart&, const Eigen::Vector3d& p, double count);
void add_to_relief(const Engine&, PolygonPart&, const Segment& other);
/// After the chart has changed.
void rechart_relief(const Engine&, PolygonPart&, const geometry::Chart& from);
/// A point's height over the surface near it, the variance of the surface's height, and the square of what it
/// may have bent on the way. Nothing where no relief is known.
struct LocalResidual {
  double height = 0, variance = 0, bend2 = 0;
};
std::optional<LocalResidual> local_residual(const Engine&, const Segment& polygon, const Eigen::Vector3d& p);
/// Does the small one go on from the large one where both are known?
bool surfaces_continue(const Engine&, const Segment& large, const Segment& small);

// meeting.cpp
/// Does `other` come within the gap of `s`, or lie inside or around it, where s has changed? Never false when
/// a merger could succeed there.
bool may_meet_where_changed(const Engine&, const Segment& s, const Segment& other);
/// Is p within λ of the polygon?
bool lies_near(const Engine&, const PolygonPart&, const Eigen::Vector3d& p);

// merge_polygons.cpp: §2.4.3
/// Tries to merge `other` with a segment that has changed.
bool merge_polygon_segments(Engine&, Segment& changed, Segment& other);
/// Step 2a for polygons; returns whether any merger succeeded.
bool merge_modified_polygons(Engine&);

/// Would the points' variance about the published plane stay below λ² with these moments (thesis §2.2)?
bool variance_allowed(const Engine&, const PolygonPart&, const Moments& merged);

// publish.cpp: the fit, the published plane, the chart
void refit(Engine&, Segment&);
void refit_if_due(Engine&, Segment&);
void publish(Engine&, Segment&);
bool differs_from_initial(const Engine&, const PolygonPart&, const Fit&);
/// b's cycles as seen in a's chart, valid, or nothing.
std::optional<geometry::Polygon> in_chart_of(Engine&, const geometry::Chart&, const PolygonPart& b);

// dissolve.cpp: young segments beside mature polygons
bool dissolve_young(Engine&);
/// Young polygons that are none (rule `arrival`): their points are loose again.
void release_slow_polygons(Engine&);
void release_points(Engine&, Segment&, bool count_return);

// neighbours.cpp: who shares what (§2.2, §2.8)
/// The copy on the other side of a shared edge. Precondition: the edge is shared.
const SharedEdge& across(const Engine&, geometry::EdgeId);
/// The edges that two segments share: the copies on the one in the lower slot. Empty if they are no
/// neighbours.
std::span<const geometry::EdgeId> edges_between(const Engine&, const Segment&, const Segment&);
/// Fills Engine::neighbour_edges from Engine::shared.
void list_all_pairs(Engine&);
/// Edge a of one segment and edge b of the other are a corresponding pair from now on. Both are in their
/// perimeters, or will be before boundary_changed() of their segments is called.
void pair_edges(Engine&, Segment& of_a, geometry::EdgeId a, Segment& of_b, geometry::EdgeId b);
/// After a change of its perimeter that may have touched shared edges: those that went are unshared, those
/// that moved to other slots, or came from another segment, are found again. Edges put in place become fresh.
/// Returns the edges that went and those put in place.
struct BoundaryChange {
  std::vector<geometry::EdgeId> removed;
  std::vector<std::pair<geometry::Slot, geometry::EdgeId>> created;
};
BoundaryChange boundary_changed(Engine&, Segment&);
/// boundary_changed(), and all that follows from where the perimeter is now.
void perimeter_changed(Engine&, Segment&);
/// Does a vertex join two edges that are shared with different neighbours?
bool is_corner(const Engine&, const Segment&, geometry::Slot vertex);
/// Unsharing (§2.8): both copies become open edges. Where that leaves the copies of another shared edge with
/// ends apart, that edge goes the same way.
void unshare(Engine&, geometry::EdgeId);
/// The two are no neighbours any more.
void dissolve_neighbours(Engine&, Segment&, Segment&);
void dissolve_all_neighbours(Engine&, Segment&);
/// Notes these edges, and those that adjoin their copies, to be looked at when ends meet again.
void note_ends(Engine&, std::span<const geometry::EdgeId> edges);
/// Unshares, of the edges noted, those with copies whose ends do not meet.
void unshare_where_ends_part(Engine&);
/// Does something that leaves the ends of copies apart for the moment: planes move, edges change hands. What
/// is unshared meanwhile asks nothing of its neighbours' ends; in the end all concerned are looked at.
template <class F>
void with_ends_apart(Engine& e, F&& change) {
  ++e.ends_held;
  change();
  if (--e.ends_held == 0) unshare_where_ends_part(e);
}
/// The segments across these edges, as far as they are shared, by slot.
std::vector<std::uint32_t> neighbours_across(Engine&, std::span<const geometry::EdgeId> edges);
/// Neighbours have one type of concavity (thesis §2.2): where a merger has brought `edges` to s, and two
/// together, those of the shorter one are unshared.
void keep_one_concavity(Engine&, Segment& s, std::span<const geometry::EdgeId> edges);
/// The perimeter has been made anew, its edges with their identities: shared edges that did not come along
/// are unshared.
void perimeter_made_anew(Engine&, Segment&);

// ordering.cpp: local and global ordering (§2.2)
/// Is an order broken on one of the boundary cycles of s?
bool is_disordered(const Engine&, const Segment& s);
/// Dissolves what is disordered on the boundary cycles of s (§2.4.3, §2.6); whether anything was.
bool dissolve_disordered(Engine&, Segment& s);
/// Quick and sure, but not complete: does an edge just shared leave the orderings as they were, because it is
/// the first of its two segments, or next to another one of theirs on both perimeters?
bool order_stays(Engine&, geometry::EdgeId);

// share_edges.cpp: §2.6 and step 4
bool share_modified(Engine&);

// redundancy.cpp: §2.9
/// After the two, no neighbours, found no edge to share: is the smaller one redundant, by ψ and φ?
void note_if_redundant(Engine&, const Segment&, const Segment&);
/// Deletes what was noted and, when finishing, segments without neighbours that lie on others.
bool delete_redundant(Engine&);

// corners.cpp: §2.7 and step 5
bool form_corners_of_modified(Engine&);

// reposition.cpp: §2.4.4
/// Puts these shared edges of s, and their copies, onto the lines where the planes meet now. What cannot
/// follow is unshared.
void reposition(Engine&, Segment& s, std::vector<geometry::EdgeId> edges);

// fissures.cpp: §2.5 and step 3
bool fill_modified(Engine&);

// initial.cpp: §4.3
void add_initial(Engine&, std::size_t number, const InitialFace&);

// voids.cpp: holes that chance alone explains
/// Would chance alone leave this area empty between k of m points of which there are `density` to a unit of
/// area? Lengths in grid steps.
bool empty_by_chance(double area, std::size_t k, std::int64_t m, double density, double gap);
/// The same of a bay in the segment's perimeter, or a hole, with k points around it.
bool empty_by_chance(const Engine&, const Segment&, double area, std::size_t k);
bool drop_chance_holes(Engine&, Segment&);
/// Is a part of a polygon that goes on beyond a line so thin, or so small, that it is no surface at this
/// resolution? Lengths in grid steps.
bool is_spur(const Engine&, double area, double depth);

// update.cpp: §2.3
void update_set(Engine&, std::span<const SensorPoint>);
/// How far the last look of finish() goes.
SharingReach last_reach(const Engine&);
void finish(Engine&);

// record.cpp
ModelRecord to_record(const Engine&);
void from_record(Engine&, const ModelRecord&);

// state.cpp
/// Precondition: labels are settled.
std::string to_state(const Engine&);
Engine from_state(std::string_view);

// state_checks.cpp
/// Throws std::invalid_argument when what was read is none that calls could have left behind, as far as going
/// on from it could do harm. Precondition: Engine::slot_of and Engine::shared are filled.
void require_sound(const Engine&);

// open_edges.cpp
std::vector<OpenEdge> open_edges(const Engine&);

// surfaces.cpp
std::vector<std::vector<SegmentId>> surfaces(const Engine&);

}  // namespace limpet::model::internal

namespace limpet::model {
struct Model::State {
  internal::Engine engine;
};
}  // namespace limpet::model
