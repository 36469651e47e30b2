// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "engine_internal.hpp"

namespace limpet::model::internal {

/// All that lasts between two calls, as bytes: see Model::state().
std::string to_state(const Engine&);

/// What to_state() wrote.
class StoredState {
 public:
  /// `bytes` have to live as long. Throws std::invalid_argument when they are damaged, or of another version
  /// or arithmetic.
  explicit StoredState(std::string_view bytes);
  const Parameters& parameters() const { return parameters_; }
  /// Precondition: the engine is new, with these parameters. Throws std::invalid_argument when what was
  /// stored is no model that calls could have left behind.
  void restore(Engine&) const;

 private:
  Parameters parameters_;
  std::string_view rest_;
};

/// Throws std::invalid_argument when an engine that is being restored could do harm if one went on from it.
/// Precondition: its segments and edges are listed by identity.
void require_sound(const Engine&, const std::map<SegmentId, SegmentId>& successors);

}  // namespace limpet::model::internal
