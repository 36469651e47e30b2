// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <limpet/model/outcome.hpp>
#include <limpet/model/view.hpp>

#include <limpet/following/space_hash_internal.hpp>

namespace limpet::following::internal {

/// What there is to be done outside a part of an open edge.
enum class PartState : std::uint8_t {
  wanted,       ///< surface is expected there, or it is not known yet
  done,         ///< what is there is known
  unreachable,  ///< given up: no position to look from could be reached
  unclosable    ///< given up: looked at in vain
};

/// A part of an open edge, at most 2 λ long.
struct OpenPart {
  geometry::EdgeId edge;
  std::uint32_t part = 0;  ///< its number along the edge
  model::SegmentId segment;
  Eigen::Vector3d from, to;
  PartState state = PartState::wanted;
  bool insist = false;  ///< to be looked at, although what is there seemed to be known
  bool closes = false;  ///< finishing would close the edge
  Eigen::Vector3d middle() const { return (from + to) / 2; }
};

/// The open edges of the model by place, kept by the changes that updates tell (model::Change).
class OpenEdgeMap {
 public:
  explicit OpenEdgeMap(double resolution) : places_(3 * resolution), part_length_(2 * resolution) {}

  void apply(std::span<const model::Change>, const model::View&);
  /// Forgets all, and takes the open edges of the model.
  void read(const model::View&);

  /// The parts with their middle within `reach` of p, as they are now, by edge and part. Edges that are gone
  /// are forgotten; those that would close are among them.
  void near(const Eigen::Vector3d& p, double reach, const model::View&, std::vector<OpenPart>&);

  /// A part of an edge that is new, or has moved, is wanted.
  void set(const OpenPart&, PartState);
  /// Notes which edges finishing would close as they are: none with an edge near that would be left. An edge
  /// that is new, or has moved, would not.
  void note(const model::Outcome&);
  /// What seemed to be done, and yet would not close, is wanted again, once for each edge. Returns whether
  /// there was any.
  bool insist();
  /// What was unreachable is wanted again. Returns whether there was any.
  bool retry();
  /// The parts within `reach` of p that are wanted become unreachable.
  void give_up(const Eigen::Vector3d& p, double reach);
  /// The parts that are wanted or unreachable, of edges that would not close, the nearest to p first.
  std::vector<OpenPart> left(const Eigen::Vector3d& p, const model::View&) const;
  /// The middle of the part of an initial segment's edge that is wanted and nearest to p; none: there is no
  /// such part. It may be far from where anything was felt. Takes time for all open edges.
  std::optional<Eigen::Vector3d> nearest_wanted_of_initial(const Eigen::Vector3d& p,
                                                           const model::View&) const;
  /// Is there a part within `reach` of p that is wanted, of an edge that would not close?
  bool any_wanted(const Eigen::Vector3d& p, double reach) const;

  /// The edges that would not close and some part of which is in this state, by identity.
  std::vector<geometry::EdgeId> edges(PartState) const;

 private:
  struct Entry {
    Eigen::Vector3d from, to;
    std::vector<PartState> parts;
    bool closes = false, insist = false;

    OpenPart part(std::uint32_t i) const;
  };
  struct Place {
    std::uint64_t edge;
    std::uint32_t part;
  };
  void put(geometry::EdgeId, const model::View&);
  void forget(geometry::EdgeId);

  std::unordered_map<std::uint64_t, Entry> edges_;
  SpaceHash<Place> places_;  ///< by the middle of the part
  std::vector<Place> found_;
  double part_length_;
};

}  // namespace limpet::following::internal
