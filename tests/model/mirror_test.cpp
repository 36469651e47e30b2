// Copyright the limpet authors. GPL-3.0-or-later.
//
// Changes tell all: a copy that applies them is the model after every call. And what is kept beside the model
// is what it would be if it were worked out anew: surfaces, what became of segments, what finishing closes.
#include "mirror.hpp"

#include <gtest/gtest.h>

#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

#include "judged_scan.hpp"
#include "neighbour_ledger.hpp"
#include "random_streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// How many random streams are read: LIMPET_STREAMS, else 100.
const std::uint64_t kMirroredStreams = wanted("LIMPET_STREAMS", 100);

/// Connected components of the neighbour relation, from the record alone.
std::vector<std::vector<SegmentId>> surfaces_in(const ModelRecord& record) {
  std::map<std::uint64_t, std::uint64_t> root, segment_of;
  const std::function<std::uint64_t(std::uint64_t)> find = [&](std::uint64_t id) {
    return root[id] == id ? id : root[id] = find(root[id]);
  };
  for (const auto& s : record.point_segments) root[s.id] = s.id;
  for (const auto& s : record.polygon_segments) {
    root[s.id] = s.id;
    for (const auto& cycle : s.cycles)
      for (const auto& v : cycle) segment_of[v.edge] = s.id;
  }
  for (const auto& s : record.polygon_segments)
    for (const auto& cycle : s.cycles)
      for (const auto& v : cycle)
        if (v.partner != 0) root[find(s.id)] = find(segment_of.at(v.partner));
  std::map<std::uint64_t, std::vector<SegmentId>> members;
  for (const auto& [id, parent] : root) members[find(id)].push_back({id});
  std::vector<std::vector<SegmentId>> surfaces;
  for (auto& [id, all] : members) surfaces.push_back(std::move(all));
  std::sort(surfaces.begin(), surfaces.end());
  return surfaces;
}

/// All of them, asked one by one of the view.
std::string view_of_surfaces(const Model& model) {
  const View view = model.view();
  std::vector<SegmentId> members, seen;
  for (const auto& surface : model.surfaces())
    for (const SegmentId id : surface) {
      view.surface(id, members);
      if (members != surface || view.surface_of(id) != surface.front() ||
          !view.same_surface(id, surface.back()))
        return "segment " + std::to_string(id.value) + " is seen in another surface\n";
    }
  return {};
}

/// What became of every segment there has been, from the changes of all calls.
class Descent {
 public:
  void apply(std::span<const Change> changes) {
    last_.clear();
    for (const Change& c : changes) {
      if (c.kind == Change::Kind::created) now_[c.result] = c.result;
      if (c.kind == Change::Kind::became_polygon) polygons_.insert(c.result);
      if (c.kind == Change::Kind::deleted) become(c.first, {});
      if (c.kind != Change::Kind::merged) continue;
      // A redundant polygon's data becomes part of another one; it is gone, not merged.
      const bool gone = c.result == c.first && polygons_.count(c.second) > 0;
      if (c.result != c.first) polygons_.insert(c.result), now_[c.result] = c.result;
      if (gone) gone_.insert(c.second);
      for (const SegmentId id : {c.first, c.second})
        if (id != c.result) become(id, c.result), last_.insert(id);
    }
  }
  /// What Model::now() says otherwise; empty if nothing.
  std::string difference(const Model& model) const {
    for (const auto& [id, now] : now_) {
      const SegmentId told = model.now(id);
      const bool forgotten = !told && (gone_.count(id) || !polygons_.count(id)) && !last_.count(id);
      if (told != now && !forgotten)
        return "segment " + std::to_string(id.value) + " is " + std::to_string(now.value) + ", not " +
               std::to_string(told.value) + "\n";
    }
    return {};
  }

 private:
  void become(SegmentId id, SegmentId result) {
    for (auto& [before, now] : now_)
      if (now == id) {
        now = result;
        if (gone_.count(id)) gone_.insert(before);
      }
  }

  std::map<SegmentId, SegmentId> now_;
  std::set<SegmentId> polygons_, gone_, last_;
};

/// Everything that is kept beside the model, after every call.
class Watch {
 public:
  explicit Watch(const Parameters& parameters) : model_(parameters) {}

  std::string update(std::span<const SensorPoint> set) { return look(model_.update(set)); }
  std::string finish() { return look(model_.finish()); }
  std::string add_initial(std::span<const InitialFace> faces) { return look(model_.add_initial(faces)); }
  const Model& model() const { return model_; }
  long named() const { return named_; }

 private:
  std::string look(const std::vector<Change>& changes) {
    for (const Change& c : changes) named_ += static_cast<long>(c.edges.size());
    const ModelRecord record = model_.record();
    mirror_.apply(changes, model_.view());
    descent_.apply(changes);
    std::string wrong = mirror_.difference(record) + view_of_surfaces(model_) + descent_.difference(model_);
    if (model_.surfaces() != surfaces_in(record)) wrong += "other surfaces\n";
    return wrong;
  }

  Model model_;
  Mirror mirror_;
  Descent descent_;
  long named_ = 0;
};

TEST(Mirror, IsAnyStreamsModelAfterEverySet) {
  long named = 0;
  for (std::uint64_t seed = 1; seed <= kMirroredStreams; ++seed) {
    const Stream stream = random_stream(seed);
    Watch watch(stream.parameters);
    for (std::size_t i = 0; i < stream.sets.size(); ++i)
      ASSERT_EQ(watch.update(stream.sets[i]), "") << "seed " << seed << " set " << i;
    ASSERT_EQ(watch.finish(), "") << "seed " << seed << " finished";
    named += watch.named();
  }
  EXPECT_GT(named, 500 * static_cast<long>(kMirroredStreams));
}

/// Mergers, corners and surfaces that meet and part.
TEST(Mirror, IsTheModelOfSolidsAfterEverySet) {
  for (const std::string name : {"cube", "L", "step_hole", "open_box", "city:4", "room:2"})
    for (const Order order : {Order::raster, Order::shuffled}) {
      const JudgedScan scan = judged_shape(name, 6'000, 0.002, order);
      Watch watch(scan.parameters);
      for (std::size_t i = 0; i < scan.points.size(); i += 60) {
        const auto set = std::span(scan.points).subspan(i, std::min<std::size_t>(60, scan.points.size() - i));
        ASSERT_EQ(watch.update(set), "") << name << " set " << i / 60;
      }
      ASSERT_EQ(watch.finish(), "") << name << " finished";
    }
}

TEST(Mirror, KnowsInitialSegmentsToo) {
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
  const std::array faces = {InitialFace{{{a, b, c, d}}}};
  Parameters parameters;
  parameters.resolution = 0.05;
  Watch watch(parameters);
  EXPECT_EQ(watch.add_initial(faces), "");
  EXPECT_EQ(watch.model().counts().edges, 4);
}

/// Finishing in fact does what was said before.
TEST(WouldFinish, IsWhatFinishingComesTo) {
  std::size_t closing = 0, staying = 0;
  for (const std::string name : {"cube", "L", "open_box", "step_hole", "pyramid"})
    for (const double part : {0.4, 0.7, 1.0}) {
      const JudgedScan scan = judged_shape(name, 8'000, 0.002, Order::shuffled);
      const auto points =
          std::span(scan.points)
              .first(static_cast<std::size_t>(part * static_cast<double>(scan.points.size())));
      Model model(scan.parameters);
      for (std::size_t i = 0; i < points.size(); i += 100)
        model.update(points.subspan(i, std::min<std::size_t>(100, points.size() - i)));
      const std::string before = model.state();
      const Outcome outcome = model.would_finish();
      EXPECT_EQ(model.state(), before) << "nothing is changed";
      std::vector<View::Edge> open;
      model.view().open_edges(open);
      ASSERT_EQ(outcome.edges.size(), open.size()) << name;
      model.finish();
      model.view().open_edges(open);
      EXPECT_EQ(outcome.open_edges, open.size()) << name << " " << part;
      EXPECT_EQ(outcome.polygons, static_cast<std::size_t>(model.counts().polygons)) << name;
      for (const Outcome::Edge& edge : outcome.edges) {
        ++(edge.closes ? closing : staying);
        const auto now = model.view().edge(edge.edge);
        EXPECT_TRUE(!now || edge.closes == bool(now->partner)) << name << " edge " << edge.edge.value;
      }
      for (const Outcome::Edge& edge : outcome.edges) EXPECT_TRUE(edge.closes || !outcome.closed()) << name;
    }
  EXPECT_GT(closing, 100u);
  EXPECT_GT(staying, 20u);
}

}  // namespace
}  // namespace limpet::model
