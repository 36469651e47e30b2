// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <map>
#include <string_view>

#include "engine_internal.hpp"

namespace limpet::model::internal {

/// The one friend of all parts of an engine: it takes them apart for a record or for stored bytes, and puts
/// them together again. It checks little; record.cpp and state_checks.cpp check what was read.
struct Storage {
  // The members of each part that outlast a call, for an archive that reads or writes them. Left out is what
  // follows from them: places of identities, indices, and lists of shared edges.

  static void describe_data(auto& archive, auto& data) {
    auto& sums = data.sums_;
    archive(sums.moments, sums.axis, sums.variance, sums.since, data.raw_, data.last_joined_);
  }
  static void describe_agenda(auto& archive, auto& agenda) {
    archive(agenda.modified_, agenda.to_share_, agenda.share_later_, agenda.looks_due_, agenda.last_look_,
            agenda.looked_at_, agenda.disordered_, agenda.redundant_);
  }
  static void describe_due(auto& archive, auto& agenda, std::uint32_t slot) {
    auto& due = agenda.due_[slot];
    archive(due.modified, due.seen, due.polygon);
  }
  static void describe_segments(auto& archive, auto& table) {
    archive(table.next_id_, table.segments_, table.free_);
  }
  static void describe_complex(auto& archive, auto& complex) {
    archive(complex.edge_ids_, complex.now_, complex.modelled_area_, complex.modelled_points_);
    describe_segments(archive, complex.segments_);
  }

  /// Puts all segments into the spatial index, with the boxes they have stored (Segment::indexed).
  static void fill_index(Complex&);
  static void reindex(Complex& complex, Segment& s) { complex.segments_.reindex(complex.setting_, s); }
  static const auto& free_slots(const Complex& complex) { return complex.segments_.free_; }
  static std::uint64_t next_segment(const Complex& complex) { return complex.segments_.next_id_; }
  static const Agenda& agenda(const Complex& complex) { return complex.agenda_; }
  static const auto& modified(const Agenda& agenda) { return agenda.modified_; }
  static const auto& to_share(const Agenda& agenda) { return agenda.to_share_; }
  static const auto& share_later(const Agenda& agenda) { return agenda.share_later_; }
  static const auto& looks_due(const Agenda& agenda) { return agenda.looks_due_; }
  static bool has_polygon_due(const Agenda& agenda, std::uint32_t slot) {
    return bool(agenda.due_[slot].polygon);
  }
  static std::int64_t looked_at(const Agenda& agenda) { return agenda.looked_at_; }
  static auto& by_age(Agenda& agenda) { return agenda.by_age_; }
  static const auto& by_age(const Agenda& agenda) { return agenda.by_age_; }
  static auto& refused(Agenda& agenda) { return agenda.refused_; }
  static const auto& refused(const Agenda& agenda) { return agenda.refused_; }
  static auto& labels(Labels& labels) { return labels.segments_; }

  static SegmentData data(const SegmentData::Sums& sums, std::vector<RawPoint> raw,
                          std::int64_t last_joined) {
    SegmentData result;
    result.sums_ = sums;
    result.raw_ = std::move(raw);
    result.last_joined_ = last_joined;
    return result;
  }
  /// Sets the counters of an empty complex.
  static void set_counters(Complex& complex, std::int64_t now, std::uint64_t next_segment,
                           std::uint64_t next_edge) {
    complex.now_ = now;
    complex.segments_.next_id_ = next_segment;
    complex.edge_ids_ = geometry::EdgeIds(next_edge);
  }
  /// Adds an empty segment of this identity in the next slot; null when there is one already.
  static Segment* add_segment(Complex& complex, Agenda& agenda, SegmentId);
  /// Enters the polygon of a segment in the complex: its points, its area, and the places of its edges.
  static void book_polygon(Complex& complex, Segment&);
  /// Enters all segments and edges by identity. Calls `refuse`, which throws, when two have the same
  /// identity.
  static void list_segments(Complex&, void (*refuse)(const char* what));
  /// Makes these edges partners. Calls `refuse`, which throws, for an edge that does not exist, is not marked
  /// as shared, is on its partner's segment, or is marked and has no partner.
  static void pair_edges(Complex&, const std::map<geometry::EdgeId, geometry::EdgeId>& partners,
                         void (*refuse)(geometry::EdgeId));
  static std::map<geometry::EdgeId, geometry::EdgeId> partners(const Complex&);
  /// The initial segments that readings lie on, with the number of these.
  static std::map<SegmentId, std::int64_t> confirmations(const Complex&);
  /// Calls `refuse`, which throws, for a segment that is not an initial one, and for a number below 1.
  static void set_confirmations(Complex&, const std::map<SegmentId, std::int64_t>&,
                                void (*refuse)(const char* what));
  static std::map<SegmentId, SegmentId> successors(const Successors&);
  static void set_successors(Successors&, const std::map<SegmentId, SegmentId>&);
};

}  // namespace limpet::model::internal
