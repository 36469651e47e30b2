// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/drawing/timeline.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <utility>

namespace limpet::drawing {
namespace {

using Eigen::Vector3d;
using model::Change;
using model::SegmentId;

constexpr std::uint64_t kNoReason = model::kRefusals;  ///< an edge that is open no more
constexpr double kNormalScale = 0x1p24, kFraction = 16;

/// Which parts follow, one bit for each.
std::uint64_t flags(std::initializer_list<bool> parts) {
  std::uint64_t bits = 0, bit = 1;
  for (const bool part : parts) bits |= part ? bit : 0, bit <<= 1;
  return bits;
}

std::int64_t rounded(double x) { return std::llround(x); }

/// Identities in ascending order are put as differences.
class Ascending {
 public:
  explicit Ascending(VarintWriter& out) : out_(out) {}
  void put(std::uint64_t id) { out_.put(id - std::exchange(last_, id)); }

 private:
  VarintWriter& out_;
  std::uint64_t last_ = 0;
};

/// The area of the cycles of a planar polygon, holes taken off.
double area_of(const std::vector<model::View::Edge>& edges, const Vector3d& normal) {
  if (edges.empty()) return 0;
  const Vector3d about = edges.front().from;
  double twice = 0;
  for (const model::View::Edge& e : edges) twice += normal.dot((e.from - about).cross(e.to - about));
  return twice / 2;
}

}  // namespace

Place TimelineSpace::at(const Vector3d& p) const {
  const Vector3d steps = (p - origin) / step;
  return {rounded(steps.x()), rounded(steps.y()), rounded(steps.z())};
}

Vector3d TimelineSpace::world(const Place& place) const {
  return origin + step * Vector3d(static_cast<double>(place[0]), static_cast<double>(place[1]),
                                  static_cast<double>(place[2]));
}

double timeline_step(double resolution) { return std::exp2(std::floor(std::log2(resolution / 1024))); }

const char* name_of(TimelineEvent::Kind kind) {
  static constexpr std::array<const char*, kTimelineEventKinds> kNames = {
      "became_polygon", "merged", "deleted", "shared", "unshared", "mode", "mark", "corner_formed"};
  return kNames[static_cast<std::size_t>(kind)];
}

void Timeline::add(const model::View& view, std::span<const Change> changes, const Aside& aside) {
  ++steps_;
  const Touched touched = note(changes);
  std::vector<SegmentId> points, polygons, there;
  view.segments(points, {.polygons = false, .initial = false});
  view.segments(polygons, {.points = false});
  std::merge(points.begin(), points.end(), polygons.begin(), polygons.end(), std::back_inserter(there));
  put_gone(there);
  put_points(view, points);
  put_polygons(view, polygons, touched);
  put_reasons(aside.reasons);
  if (aside.intent) put_intent(*aside.intent);
  sum_up();
}

void Timeline::add(TimelineEvent::Kind kind, std::uint64_t a, std::uint64_t b) {
  events_.push_back({steps_, kind, a, b});
}

/// Makes events of the changes; returns the segments whose edges or partners may be others now.
Timeline::Touched Timeline::note(std::span<const Change> changes) {
  using Kind = TimelineEvent::Kind;
  Touched touched, new_polygons;
  for (const Change& change : changes) {
    for (const SegmentId id : {change.first, change.second, change.result}) touched.insert(id);
    const auto edge = [&](std::size_t i) { return i < change.edges.size() ? change.edges[i].value : 0; };
    switch (change.kind) {
      case Change::Kind::became_polygon:
        add(Kind::became_polygon, change.result.value, 0);
        new_polygons.insert(change.result);
        break;
      case Change::Kind::merged:
        note_merger(change, new_polygons);
        break;
      case Change::Kind::deleted:
        if (polygons_.contains(change.first.value)) add(Kind::deleted, change.first.value, 0);
        break;
      case Change::Kind::shared:
        add(Kind::shared, edge(0), edge(1));
        break;
      case Change::Kind::unshared:
        add(Kind::unshared, edge(0), edge(1));
        break;
      case Change::Kind::corner_formed:
        add(Kind::corner_formed, change.first.value, change.second.value);
        break;
      default:
        break;
    }
  }
  return touched;
}

/// That points come together, or join a polygon, is nothing to jump to.
void Timeline::note_merger(const Change& change, const std::set<SegmentId>& new_polygons) {
  const auto is_polygon = [&](SegmentId id) {
    return polygons_.contains(id.value) || new_polygons.contains(id);
  };
  if (!is_polygon(change.first) || !is_polygon(change.second)) return;
  const SegmentId gone = change.result == change.first ? change.second : change.first;
  add(TimelineEvent::Kind::merged, change.result.value, gone.value);
}

void Timeline::put_gone(const std::vector<SegmentId>& there) {
  std::vector<std::uint64_t> gone;
  const auto take_out = [&](auto& known) {
    std::erase_if(known, [&](const auto& entry) {
      const bool is_gone = !std::binary_search(there.begin(), there.end(), SegmentId{entry.first});
      if (is_gone) gone.push_back(entry.first);
      return is_gone;
    });
  };
  take_out(points_), take_out(polygons_);
  std::sort(gone.begin(), gone.end());
  out_.put(gone.size());
  Ascending ids(out_);
  for (const std::uint64_t id : gone) ids.put(id);
}

void Timeline::put_place(const Place& place, const Place& before) {
  for (std::size_t k = 0; k < 3; ++k) out_.put_signed(place[k] - before[k]);
}

void Timeline::put_points(const model::View& view, const std::vector<SegmentId>& there) {
  std::vector<std::pair<std::uint64_t, Point>> changed;
  for (const SegmentId id : there) {
    const model::View::Segment segment = *view.segment(id);
    const Point now{space_.at(segment.plane.point), segment.points};
    const auto known = points_.find(id.value);
    if (known == points_.end() || known->second != now) changed.emplace_back(id.value, now);
  }
  out_.put(changed.size());
  Ascending ids(out_);
  for (const auto& [id, point] : changed) {
    ids.put(id);
    put_place(point.at, points_[id].at);
    out_.put(static_cast<std::uint64_t>(point.count));
    points_[id] = point;
    box_.extend(space_.world(point.at));
  }
}

/// What is known of a polygon now.
Timeline::Polygon Timeline::polygon_of(const model::View& view, const model::View::Segment& segment) {
  Polygon polygon;
  std::vector<model::View::Edge> edges;
  view.edges(segment.id, edges);
  std::optional<geometry::CycleId> cycle;
  for (const model::View::Edge& e : edges) {
    if (cycle != e.cycle) polygon.boundary.cycles.push_back({e.hole, {}});
    cycle = e.cycle;
    const Place at = space_.at(e.from);
    polygon.boundary.cycles.back().vertices.push_back({e.id.value, e.partner.value, at});
    box_.extend(space_.world(at));
    if (!e.partner) polygon.open_length += (e.to - e.from).norm();
  }
  const Vector3d normal = segment.plane.normal;
  polygon.area = area_of(edges, normal);
  for (int k = 0; k < 3; ++k) polygon.plane[static_cast<std::size_t>(k)] = rounded(kNormalScale * normal[k]);
  polygon.plane[3] = rounded(kFraction / space_.step * normal.dot(segment.plane.point - space_.origin));
  return polygon;
}

void Timeline::put_polygons(const model::View& view, const std::vector<SegmentId>& there,
                            const Touched& touched) {
  std::vector<std::pair<std::uint64_t, Polygon>> changed;
  for (const SegmentId id : there) {
    const auto known = polygons_.find(id.value);
    const model::View::Segment segment = *view.segment(id);
    const std::int64_t count = segment.points + segment.confirmed;
    const bool is_touched = known == polygons_.end() || touched.contains(id);
    if (!is_touched && known->second.count == count) continue;
    Polygon now = is_touched ? polygon_of(view, segment) : known->second;
    now.count = count;
    now.residual =
        static_cast<std::uint64_t>(rounded(view.residual(id).value_or(0) * kFraction / space_.step));
    changed.emplace_back(id.value, std::move(now));
  }
  out_.put(changed.size());
  Ascending ids(out_);
  for (auto& [id, now] : changed) {
    points_.erase(id);
    ids.put(id);
    put_polygon(id, now, view.segment({id})->kind == model::View::Kind::initial);
    for (const Boundary::Cycle& cycle : now.boundary.cycles)  // who reads forgets the reasons of shared edges
      for (const BoundaryVertex& vertex : cycle.vertices)
        if (vertex.partner != 0) reasons_.erase(vertex.edge);
    polygons_[id] = std::move(now);
  }
}

/// What of a polygon is not as it was put last.
void Timeline::put_polygon(std::uint64_t id, const Polygon& now, bool initial) {
  static const Polygon nothing;
  const auto known = polygons_.find(id);
  const bool is_new = known == polygons_.end();
  const Polygon& before = is_new ? nothing : known->second;
  const bool figures = is_new || now.count != before.count || now.residual != before.residual;
  const bool plane = is_new || now.plane != before.plane;
  const bool boundary = is_new || now.boundary != before.boundary;
  out_.put(flags({figures, plane, boundary, initial}));
  if (figures) out_.put(static_cast<std::uint64_t>(now.count)), out_.put(now.residual);
  if (plane)
    for (const std::int64_t number : now.plane) out_.put_signed(number);
  if (boundary) put_boundary(now.boundary, before.boundary, out_);
}

void Timeline::put_reasons(const std::vector<model::OpenEdge>* open_edges) {
  std::map<std::uint64_t, Reason> now;
  if (open_edges)
    for (const model::OpenEdge& e : *open_edges)
      now[e.edge.value] = {static_cast<std::uint64_t>(e.refusal), e.other.value};
  std::map<std::uint64_t, Reason> changed;
  if (open_edges) {
    for (const auto& [edge, reason] : now)
      if (const auto known = reasons_.find(edge); known == reasons_.end() || known->second != reason)
        changed[edge] = reason;
    for (const auto& [edge, reason] : reasons_)
      if (!now.contains(edge)) changed[edge] = {kNoReason, 0};
    reasons_ = std::move(now);
  }
  out_.put(changed.size());
  Ascending ids(out_);
  for (const auto& [edge, reason] : changed) ids.put(edge), out_.put(reason.code), out_.put(reason.other);
}

void Timeline::put_places(const std::vector<Vector3d>& places) {
  out_.put(places.size());
  Place before{};
  for (const Vector3d& p : places) {
    const Place at = space_.at(p);
    put_place(at, std::exchange(before, at));
  }
}

void Timeline::put_intent(const following::Intent& intent) {
  out_.put(flags({!intent.targets.empty(), intent.aim.has_value(), !intent.way.empty(), bool(intent.edge),
                  bool(intent.segment), intent.slice.has_value()}));
  if (!intent.targets.empty()) put_places(intent.targets);
  if (intent.aim) put_place(space_.at(intent.aim->target), {}), put_place(space_.at(intent.aim->place), {});
  if (!intent.way.empty()) put_places(intent.way);
  if (intent.edge) out_.put(intent.edge.value);
  if (intent.segment) out_.put(intent.segment.value);
  if (intent.slice) {
    const auto& [one, other] = *intent.slice;
    put_places({one[0], one[1], other[0], other[1]});
  }
}

void Timeline::sum_up() {
  double area = 0, open_length = 0;
  for (const auto& [id, polygon] : polygons_) area += polygon.area, open_length += polygon.open_length;
  area_.push_back(static_cast<float>(area));
  open_length_.push_back(static_cast<float>(open_length));
}

}  // namespace limpet::drawing
