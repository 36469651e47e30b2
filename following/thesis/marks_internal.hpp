// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <limpet/following/follower.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

#include "changes_internal.hpp"

namespace limpet::following::internal {

/// Which edges, segments and surfaces are complete (thesis §3.4), and what has been given up.
///
/// An edge is complete when it is shared, marked unreachable or unclosable, or when finishing the model would
/// close it: the model shares edges late while readings come in, and waiting for it costs steps. A polygon is
/// complete when its edges are or it is marked unreachable; a point segment when it is marked.
class Completeness {
 public:
  using Edge = model::View::Edge;

  /// Drops what is known of edges and segments that are gone, and counts a step.
  void take(const Changes&);

  void mark_unreachable(geometry::EdgeId id) { unreachable_edges_.insert(id), new_edges_.push_back(id); }
  void mark_unclosable(geometry::EdgeId id) { unclosable_edges_.insert(id); }
  void mark_unreachable(model::SegmentId id) {
    unreachable_segments_.insert(id), new_segments_.push_back(id);
  }

  /// What was marked unreachable since the last call, edges before segments.
  struct NewMark {
    geometry::EdgeId edge;  ///< none: the segment
    model::SegmentId segment;
  };
  std::vector<NewMark> take_new_marks();
  void take_back(const NewMark&);

  /// The control point has come closest to this segment, and edge if any. If it was marked unreachable it is
  /// tried once more; literally done each time (thesis §3.4.2), this would never end.
  void came_closest(const model::View::Nearest&);

  /// Asks the model what finishing would close, if enough steps have been made since the last time;
  /// `surely`: if any has, for readings that change no edge may still change the answer. Returns whether it
  /// was asked.
  bool ask_what_would_close(const model::Model&, bool surely);

  bool is_complete(const Edge&) const;
  /// Also when it is gone.
  bool is_complete(const model::View&, model::SegmentId) const;
  bool is_unreachable(model::SegmentId id) const { return unreachable_segments_.count(id) > 0; }

  Marks marks() const;
  /// How often the model was asked.
  std::int64_t outcomes_asked() const { return asked_; }

 private:
  std::set<geometry::EdgeId> unreachable_edges_, unclosable_edges_, edges_tried_again_;
  std::set<geometry::EdgeId> closing_;  ///< finishing would close them
  std::set<model::SegmentId> unreachable_segments_, segments_tried_again_;
  std::vector<geometry::EdgeId> new_edges_;  ///< marked since take_new_marks()
  std::vector<model::SegmentId> new_segments_;
  std::int64_t asked_ = 0;
  int steps_ = 0;  ///< since the model was asked
  static constexpr int kLeastPatience = 100;
  int patience_ = kLeastPatience;  ///< steps before it is asked again
};

}  // namespace limpet::following::internal
