// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limpet/drawing/boundary.hpp>
#include <limpet/drawing/varint.hpp>
#include <limpet/following/intent.hpp>
#include <limpet/model/changes.hpp>
#include <limpet/model/open_edges.hpp>
#include <limpet/model/view.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace limpet::drawing {

/// Where the places of a timeline are: origin + step · (three whole numbers). World, scan's unit.
struct TimelineSpace {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double step = 0;

  Place at(const Eigen::Vector3d& p) const;
  Eigen::Vector3d world(const Place& place) const;
};

/// The steps that are fine enough to look at a model of this resolution: the largest power of two that is no
/// more than λ/1024.
double timeline_step(double resolution);

/// Something that happened to a model, to jump to.
struct TimelineEvent {
  enum class Kind : std::uint8_t {
    became_polygon,
    merged,
    deleted,
    shared,
    unshared,
    mode,
    mark,
    corner_formed
  };
  std::uint32_t step = 0;  ///< counted from 1
  Kind kind{};
  std::uint64_t a = 0, b = 0;  ///< whom it happened to (docs/page_format.md, "Events")
};
inline constexpr std::size_t kTimelineEventKinds = 8;
const char* name_of(TimelineEvent::Kind);

/// Writes down how a model grows: for each step what has changed, in the form of docs/page_format.md.
///
///     Timeline timeline(space);
///     for (...) timeline.add(model.view(), model.update(set), {});
class Timeline {
 public:
  /// What else there is to a step.
  struct Aside {
    const std::vector<model::OpenEdge>* reasons = nullptr;  ///< of all open edges; none: as they were
    const following::Intent* intent = nullptr;  ///< of the follower; given at each step, or at none
  };

  explicit Timeline(const TimelineSpace& space) : space_(space) {}

  /// One more step: the model is this now, and these are all the changes since the last step.
  void add(const model::View&, std::span<const model::Change>, const Aside&);
  /// One more event, of the last step.
  void add(TimelineEvent::Kind, std::uint64_t a, std::uint64_t b);

  const TimelineSpace& space() const { return space_; }
  std::uint32_t steps() const { return steps_; }
  const std::string& stream() const { return out_.bytes(); }
  const std::vector<TimelineEvent>& events() const { return events_; }
  /// Of all polygons after each step, in the square of the scan's unit, and the length of their open edges.
  const std::vector<float>& area() const { return area_; }
  const std::vector<float>& open_length() const { return open_length_; }
  /// Of all that was ever there; empty if there was nothing.
  const Eigen::AlignedBox3d& box() const { return box_; }

 private:
  struct Point {
    Place at{};
    std::int64_t count = 0;
    friend bool operator==(const Point&, const Point&) = default;
  };
  struct Polygon {
    std::int64_t count = 0;
    std::uint64_t residual = 0;  ///< sixteenths of a step
    std::array<std::int64_t, 4> plane{};
    Boundary boundary;
    double area = 0, open_length = 0;
  };
  struct Reason {
    std::uint64_t code = 0, other = 0;
    friend bool operator==(const Reason&, const Reason&) = default;
  };
  using Touched = std::set<model::SegmentId>;

  Touched note(std::span<const model::Change>);
  void note_merger(const model::Change&, const std::set<model::SegmentId>& new_polygons);
  void put_gone(const std::vector<model::SegmentId>& there);
  void put_points(const model::View&, const std::vector<model::SegmentId>& there);
  void put_polygons(const model::View&, const std::vector<model::SegmentId>& there, const Touched&);
  void put_polygon(std::uint64_t id, const Polygon& now, bool initial);
  void put_reasons(const std::vector<model::OpenEdge>*);
  void put_intent(const following::Intent&);
  void put_places(const std::vector<Eigen::Vector3d>&);
  void put_place(const Place& place, const Place& before);
  Polygon polygon_of(const model::View&, const model::View::Segment&);
  void sum_up();

  TimelineSpace space_;
  VarintWriter out_;
  std::uint32_t steps_ = 0;
  std::map<std::uint64_t, Point> points_;      ///< point segments, as they were put last
  std::map<std::uint64_t, Polygon> polygons_;  ///< the same of polygons
  std::map<std::uint64_t, Reason> reasons_;    ///< of open edges
  std::vector<TimelineEvent> events_;
  std::vector<float> area_, open_length_;
  Eigen::AlignedBox3d box_;
};

}  // namespace limpet::drawing
