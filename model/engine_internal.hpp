// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <span>

#include <limpet/model/model.hpp>

#include "agenda_internal.hpp"
#include "complex_internal.hpp"
#include "insertion_internal.hpp"
#include "labels_internal.hpp"
#include "setting_internal.hpp"
#include "stage_clock_internal.hpp"

namespace limpet::model::internal {

/// The inside of a model: parts that each own their state (docs/architecture.md, "rooms"). The update
/// procedure works on them. This header is not installed.
struct Engine {
  explicit Engine(const Parameters& p) : setting(p) {}
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  const Setting setting;  ///< parameters, and what follows from them
  Agenda agenda{setting.parameters.neighbours};
  Complex complex{setting, agenda};
  Labels labels;
  Successors successors;
  Insertion insertion{complex, agenda, labels};
  Counts counts;  ///< only those that cannot be counted from the rest; Counts::points is Complex::now()
  StageClock clock;
};

// update.cpp: thesis §2.3

void add_initial_faces(Engine&, std::span<const InitialFace>);
void update_set(Engine&, std::span<const SensorPoint>);
void finish(Engine&, const std::function<bool()>& stop = {});
/// How far the last rounds of finish() search.
SharingReach last_reach(const Rules&);

}  // namespace limpet::model::internal

namespace limpet::model {
struct Model::State {
  explicit State(const Parameters& p) : engine(p) {}
  internal::Engine engine;
  bool half_changed = false;  ///< a change was ended by an exception: law (10) of Model
};
}  // namespace limpet::model
