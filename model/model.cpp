// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/model.hpp>

#include <limpet/model/view.hpp>

#include "engine_internal.hpp"
#include "initial_internal.hpp"
#include "open_edges_internal.hpp"
#include "record_internal.hpp"
#include "state_internal.hpp"
#include "would_finish_internal.hpp"

namespace limpet::model {
Model::Model(const Parameters& p) : state_(std::make_unique<State>(p)) {}

Model::Model(const ModelRecord& r) : Model(r.parameters) { internal::from_record(state_->engine, r); }

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

const internal::Engine& Model::engine() const {
  if (!state_)
    throw ModelUnusable("this model has been moved from: assign another to it before anything else is asked");
  if (state_->half_changed)
    throw ModelUnusable(
        "this model is unusable: an exception (out of memory, most likely) ended a call that was changing "
        "it; "
        "destroy it, or assign another to it, as one made by from_state() of an earlier state()");
  return state_->engine;
}

template <class Call>
const std::vector<Change>& Model::change(Call&& call) {
  engine();  // throws where there is none to be changed
  internal::Engine& e = state_->engine;
  try {
    call(e);
  } catch (const internal::Refused&) {
    throw;
  } catch (...) {
    state_->half_changed = true;
    throw;
  }
  return e.complex.changes();
}

const std::vector<Change>& Model::add_initial(std::span<const InitialFace> faces) {
  return change([&](internal::Engine& e) { internal::add_initial_faces(e, faces); });
}

const std::vector<Change>& Model::update(std::span<const SensorPoint> set) {
  return change([&](internal::Engine& e) { internal::update_set(e, set); });
}

const std::vector<Change>& Model::finish(const std::function<bool()>& stop) {
  return change([&](internal::Engine& e) { internal::finish(e, stop); });
}

const Parameters& Model::parameters() const { return engine().setting.parameters; }

Counts Model::counts() const {
  const internal::Engine& e = engine();
  Counts c = e.counts;
  c.points = e.complex.now();
  e.complex.segments().for_each([&](const internal::Segment& s) {
    if (!s.polygon) {
      ++c.point_segments;
      c.loose += s.count();
      return;
    }
    ++c.polygons;
    c.confirmed += s.polygon->confirmed;
    c.holes += static_cast<std::int64_t>(s.polygon->perimeter.hole_count());
  });
  c.edges = static_cast<std::int64_t>(e.complex.edges().size());
  c.shared_edges = static_cast<std::int64_t>(e.complex.edges().pair_count());
  return c;
}

ModelRecord Model::record() const { return internal::to_record(engine()); }

std::string Model::state() const { return internal::to_state(engine()); }

View Model::view() const { return View(engine().complex); }

Model Model::from_state(std::string_view bytes) {
  const internal::StoredState stored(bytes);
  Model model(stored.parameters());
  stored.restore(model.state_->engine);
  return model;
}

SegmentId Model::now(SegmentId id) const {
  const internal::Engine& e = engine();
  if (e.complex.find(id)) return id;
  for (const Change& c : e.complex.changes())  // in order, so one pass is enough
    if (c.kind == Change::Kind::merged && (c.first == id || c.second == id)) id = c.result;
  if (e.complex.find(id)) return id;
  return e.successors.of(id);
}

std::vector<std::vector<SegmentId>> Model::surfaces() const {
  return internal::surfaces_of(engine().complex);
}

std::vector<OpenEdge> Model::open_edges() const {
  const internal::Engine& e = engine();
  return internal::open_edges(e.complex, internal::last_reach(e.setting.rules()));
}

Outcome Model::would_finish() const { return internal::would_finish(engine()); }

void Model::keep_labels() {
  change([](internal::Engine& e) { e.labels.keep(); });
}

void Model::measure_stages() {
  change([](internal::Engine& e) { e.clock.measure(); });
}

StageTimes Model::stage_times() const { return engine().clock.times(); }

std::vector<SegmentId> Model::labels() const {
  const internal::Engine& e = engine();
  std::vector<SegmentId> result;
  for (const std::uint64_t id : e.labels.settled(e.complex.segments())) result.push_back({id});
  return result;
}

}  // namespace limpet::model
