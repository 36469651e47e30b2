// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/model.hpp>

#include <limpet/model/view.hpp>

#include "engine_internal.hpp"

namespace limpet::model {
namespace {

Parameters parameters_of(const ModelRecord& r) {
  Parameters p;
  p.resolution = r.resolution;
  p.angle_rad = r.angle_rad;
  p.noise = r.noise;
  p.noise_per_range = r.noise_per_range;
  p.noise_per_range2 = r.noise_per_range2;
  p.tolerance = r.tolerance;
  p.neighbours = r.neighbours;
  p.redundancy_count = r.redundancy_count;
  p.redundancy_ratio = r.redundancy_ratio;
  p.rules = Rules::parse(r.rules);
  return p;
}

}  // namespace

Model::Model(const Parameters& p) : state_(std::make_unique<State>(State{internal::Engine(p)})) {}

Model::Model(const ModelRecord& r) : Model(parameters_of(r)) { internal::from_record(state_->engine, r); }

Model::Model(std::unique_ptr<State> state) : state_(std::move(state)) {}

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

void Model::add_initial(std::span<const InitialFace> faces) {
  for (std::size_t i = 0; i < faces.size(); ++i) internal::add_initial(state_->engine, i, faces[i]);
}

const std::vector<Change>& Model::update(std::span<const SensorPoint> set) {
  internal::update_set(state_->engine, set);
  return state_->engine.changes;
}

const std::vector<Change>& Model::finish() {
  internal::finish(state_->engine);
  return state_->engine.changes;
}

const Parameters& Model::parameters() const { return state_->engine.parameters; }

Counts Model::counts() const {
  Counts c = state_->engine.counts;
  for (const auto& s : state_->engine.segments) {
    if (!s) continue;
    if (!s->polygon) {
      ++c.point_segments;
      c.loose += s->moments.count();
      continue;
    }
    ++c.polygons;
    c.holes += static_cast<std::int64_t>(s->polygon->perimeter.hole_count());
    c.edges += static_cast<std::int64_t>(s->polygon->perimeter.edge_count());
  }
  c.shared_edges = static_cast<std::int64_t>(state_->engine.shared.size() / 2);
  return c;
}

ModelRecord Model::record() const { return internal::to_record(state_->engine); }

View Model::view() const { return View(state_->engine); }

std::string Model::state() const {
  internal::settle_labels(state_->engine);
  return internal::to_state(state_->engine);
}

Model Model::from_state(std::string_view bytes) {
  return Model(std::make_unique<State>(State{internal::from_state(bytes)}));
}

std::vector<std::vector<SegmentId>> Model::surfaces() const { return internal::surfaces(state_->engine); }

std::vector<OpenEdge> Model::open_edges() const { return internal::open_edges(state_->engine); }

void Model::keep_labels() { state_->engine.labels_kept = true; }

void Model::measure_stages() { state_->engine.stage_clock.measure(); }

StageTimes Model::stage_times() const { return state_->engine.stage_clock.times(); }

std::vector<SegmentId> Model::labels() const {
  internal::settle_labels(state_->engine);
  std::vector<SegmentId> result;
  result.reserve(state_->engine.labels.size());
  for (const std::uint64_t id : state_->engine.labels) result.push_back({id});
  return result;
}

}  // namespace limpet::model
