// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <limpet/app/pages.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/app/run_reader.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/following/follower.hpp>
#include <limpet/io/error.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "page_builder_internal.hpp"

namespace limpet::app {
namespace {

using Clock = std::chrono::steady_clock;
using drawing::TimelineEvent;
using Eigen::Vector3d;

constexpr std::int64_t kMostReasons = 400;  ///< times that it is asked why edges are open
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

model::Capsule in_world(const model::Capsule& part, const Eigen::Isometry3d& link) {
  return {link * part.a, link * part.b, part.radius};
}

/// The robot's body in the world; of a robot without extent, its control point.
std::vector<model::Capsule> body_of(const kinematics::Posture& posture) {
  std::vector<model::Capsule> body;
  for (std::size_t i = 0; i < posture.robot().links.size(); ++i)
    for (const model::Capsule& part : posture.robot().links[i].body)
      body.push_back(in_world(part, posture.link(i)));
  if (body.empty()) body.push_back({posture.control_point(), posture.control_point(), 0});
  return body;
}

std::unique_ptr<following::Follower> follower_of(const RunHead& head) {
  std::unique_ptr<following::LinkMotion> links;
  if (head.links) links = std::make_unique<following::LinkMotion>(head.robot, *head.links);
  return following::make_follower(head.strategy, head.following, std::move(links));
}

/// What there is of each set beside the model.
struct SetArrays {
  std::vector<std::uint8_t> mode;
  std::vector<float> path, joints, range, off_axis_place, clearance, true_clearance, time_us;
  std::vector<std::uint16_t> count, sensor;
  std::vector<std::uint16_t> seeing_count, seeing;  ///< of robots with switches
  std::vector<std::uint32_t> off_axis;

  void put(drawing::PageData& data) const {
    data.put("mode", mode);
    data.put("path", path);
    data.put("joints", joints);
    data.put("reading_count", count);
    data.put("reading_sensor", sensor);
    data.put("reading_range", range);
    data.put("clearance", clearance);
    if (!off_axis.empty()) data.put("off_axis_reading", off_axis), data.put("off_axis_place", off_axis_place);
    if (!seeing_count.empty()) data.put("seeing_count", seeing_count), data.put("seeing_switch", seeing);
    if (!true_clearance.empty()) data.put("true_clearance", true_clearance);
    if (!time_us.empty()) data.put("time_us", time_us);
  }
};

/// Plays a run again, and writes down all that a page shows of it.
class RunPlayer {
 public:
  RunPlayer(const std::string& path, std::int64_t sets, const PageOptions&, bool with_intent);

  /// To the end of the run. False where the follower did not move as it did in the run.
  bool play();
  std::string page();

 private:
  bool play(const RunSet&);
  void add_readings(const RunSet&, const kinematics::Posture&);
  void add_clearance(const kinematics::Posture&);
  void add_mode(std::optional<following::Mode>);
  void add_marks(const following::Marks&);
  void finish();
  drawing::TimelineSpace space_at(const Vector3d& origin) const {
    return {origin, drawing::timeline_step(reader_.head().model.resolution)};
  }
  bool was_finished() const { return !(reader_.is_whole() && reader_.end().reason == "interrupted"); }

  std::string path_;
  PageOptions options_;
  RunReader reader_;
  model::Model model_;
  std::unique_ptr<following::Follower> follower_;  ///< none: what it was after is left out
  std::optional<evaluation::TrueSurface> truth_;
  std::optional<drawing::Timeline> timeline_;  ///< from the first set on, whose place is its origin
  SetArrays arrays_;
  following::Marks marks_;
  Progress progress_;
  std::int64_t sets_ = 0, reasons_every_;
};

RunPlayer::RunPlayer(const std::string& path, std::int64_t sets, const PageOptions& options, bool with_intent)
    : path_(path),
      options_(options),
      reader_(path),
      model_(model_before(reader_.head())),
      progress_("playing", sets, options.quiet),
      reasons_every_(1 + sets / kMostReasons) {
  if (with_intent) follower_ = follower_of(reader_.head());
  if (options.truth) truth_.emplace(*options.truth);
}

bool RunPlayer::play() {
  for (RunSet set; reader_.next(set);) {
    if (!timeline_) timeline_.emplace(space_at(set.control_point));
    if (!play(set)) return false;
    progress_.step(++sets_);
  }
  if (was_finished()) finish();
  progress_.clear();
  return true;
}

bool RunPlayer::play(const RunSet& set) {
  const auto begin = Clock::now();
  const auto& changes = model_.update(set.sensed.points);
  const std::chrono::duration<float, std::micro> time = Clock::now() - begin;
  const kinematics::Posture posture(reader_.head().robot, set.sensed.measured);
  std::optional<following::Intent> intent;
  if (follower_) {
    const auto motion = follower_->next({model_, changes, posture, set.sensed.points, set.sensed.seeing});
    if (set.mode && motion.mode != *set.mode) return false;
    intent = follower_->intent(model_.view());
  }
  std::vector<model::OpenEdge> reasons;
  const bool with_reasons = sets_ % reasons_every_ == 0;
  if (with_reasons) reasons = model_.open_edges();
  timeline_->add(model_.view(), changes, {with_reasons ? &reasons : nullptr, intent ? &*intent : nullptr});
  if (follower_) add_marks(follower_->marks());
  add_mode(set.mode);
  add_readings(set, posture);
  add_clearance(posture);
  if (options_.times) arrays_.time_us.push_back(time.count());
  return true;
}

void RunPlayer::add_mode(std::optional<following::Mode> mode) {
  constexpr std::uint8_t kNone = 255;
  const std::uint8_t now = mode ? static_cast<std::uint8_t>(*mode) : kNone;
  if (now != kNone && (arrays_.mode.empty() || arrays_.mode.back() != now))
    timeline_->add(TimelineEvent::Kind::mode, now, 0);
  arrays_.mode.push_back(now);
}

/// Marks that were not there before are events.
void RunPlayer::add_marks(const following::Marks& now) {
  const auto add_new = [&](const auto& ids, const auto& before, std::uint64_t kind) {
    for (const auto id : ids)
      if (std::find(before.begin(), before.end(), id) == before.end())
        timeline_->add(TimelineEvent::Kind::mark, id.value, kind);
  };
  add_new(now.unreachable_segments, marks_.unreachable_segments, 0);
  add_new(now.unreachable_edges, marks_.unreachable_edges, 1);
  add_new(now.unclosable_edges, marks_.unclosable_edges, 2);
  marks_ = now;
}

void RunPlayer::add_readings(const RunSet& set, const kinematics::Posture& posture) {
  const Vector3d& origin = timeline_->space().origin;
  drawing::append(arrays_.path, set.control_point - origin);
  for (const double joint : set.sensed.measured) arrays_.joints.push_back(static_cast<float>(joint));
  arrays_.count.push_back(static_cast<std::uint16_t>(set.sensed.points.size()));
  for (std::size_t i = 0; i < set.sensed.points.size(); ++i) {
    const model::SensorPoint& point = set.sensed.points[i];
    const std::size_t sensor = set.sensed.sensors[i];
    if (posture.sensor_point(sensor, point.range).position != point.position) {
      arrays_.off_axis.push_back(static_cast<std::uint32_t>(arrays_.range.size()));
      drawing::append(arrays_.off_axis_place, point.position - origin);
    }
    arrays_.sensor.push_back(static_cast<std::uint16_t>(sensor));
    arrays_.range.push_back(static_cast<float>(point.range));
  }
  if (posture.robot().switches.empty()) return;
  arrays_.seeing_count.push_back(static_cast<std::uint16_t>(set.sensed.seeing.size()));
  for (const std::size_t i : set.sensed.seeing) arrays_.seeing.push_back(static_cast<std::uint16_t>(i));
}

void RunPlayer::add_clearance(const kinematics::Posture& posture) {
  const double reach = reader_.head().following.sensing_range;
  double least = std::numeric_limits<double>::infinity(), true_least = least;
  for (const model::Capsule& part : body_of(posture)) {
    if (const auto nearest = model_.view().nearest(part, reach)) least = std::min(least, nearest->distance);
    if (truth_) true_least = std::min(true_least, truth_->distance_along(part.a, part.b) - part.radius);
  }
  arrays_.clearance.push_back(std::isfinite(least) ? static_cast<float>(least) : kUnknown);
  if (truth_) arrays_.true_clearance.push_back(static_cast<float>(true_least));
}

/// What finishing does is one more step, at which the robot stands still.
void RunPlayer::finish() {
  const auto& changes = model_.finish();
  const auto reasons = model_.open_edges();
  const following::Intent nothing;
  timeline_->add(model_.view(), changes, {&reasons, follower_ ? &nothing : nullptr});
  const auto repeat_last = [](std::vector<float>& numbers) {
    if (!numbers.empty()) numbers.push_back(numbers.back());
  };
  repeat_last(arrays_.clearance), repeat_last(arrays_.true_clearance);
  if (!arrays_.time_us.empty()) arrays_.time_us.push_back(kUnknown);
  add_mode(std::nullopt);
}

std::string RunPlayer::page() {
  const RunHead& head = reader_.head();
  internal::PageBuilder page("run", std::filesystem::path(path_).filename().string(), head.model,
                             timeline_->space());
  const auto ids = [](const auto& marks) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto id : marks) list.push_back(id.value);
    return list;
  };
  const following::Marks& marks = reader_.end().marks;
  page.head["run"] = {{"strategy", head.strategy == following::Strategy::thesis ? "thesis" : "frontier"},
                      {"ended", reader_.end().reason},
                      {"seed", head.seed},
                      {"sets", sets_},
                      {"marks",
                       {{"unreachable_segments", ids(marks.unreachable_segments)},
                        {"unreachable_edges", ids(marks.unreachable_edges)},
                        {"unclosable_edges", ids(marks.unclosable_edges)}}},
                      {"reasons_every", reasons_every_},
                      {"intent", follower_ != nullptr}};
  page.head["robot"] = internal::json_of(head.robot);
  page.head["finished"] = was_finished();
  page.add(*timeline_);
  arrays_.put(page.data);
  if (options_.truth) page.add_truth(options_.truth_name, *options_.truth);
  return page.bytes();
}

}  // namespace

std::string page_of_run(const std::string& path, const PageOptions& options) {
  const std::int64_t sets = count_sets(path);
  if (sets == 0) throw io::InputError(path, "the run has no set: there is nothing to play");
  auto player = std::make_unique<RunPlayer>(path, sets, options, true);
  if (!player->play()) {
    warn_of_run(path, "its follower was another one: what it was after is left out");
    player = std::make_unique<RunPlayer>(path, sets, options, false);
    player->play();
  }
  return player->page();
}

}  // namespace limpet::app
