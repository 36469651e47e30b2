// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "engine_internal.hpp"

namespace limpet::model::internal {

/// Everything that outlasts a call, as bytes: see Model::state(). Without labels: as if none had been kept.
std::string to_state(const Engine&, bool with_labels = true);

/// What to_state() wrote.
class StoredState {
 public:
  /// `bytes` must outlive this. Throws std::invalid_argument when they are damaged, or of another version or
  /// arithmetic.
  explicit StoredState(std::string_view bytes);
  const Parameters& parameters() const { return parameters_; }
  /// Precondition: the engine is new, with these parameters. Throws std::invalid_argument when the stored
  /// data is not a possible state of a model.
  void restore(Engine&) const;

 private:
  Parameters parameters_;
  std::string_view rest_;
};

/// Throws std::invalid_argument when it would be unsafe to continue from an engine that is being restored.
/// Precondition: its segments and edges are listed by identity.
void require_sound(const Engine&, const std::map<SegmentId, SegmentId>& successors);

}  // namespace limpet::model::internal
