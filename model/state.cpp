// Copyright the limpet authors. GPL-3.0-or-later.
//
// A whole model as bytes, so that what follows is the same to the bit. Entries about segments that are gone
// are not stored: identities are never reused, so nothing will ask for them. Indices are rebuilt, since no
// result depends on their order.
#include <algorithm>

#include <limpet/geometry/predicates.hpp>
#include <limpet/model/digest.hpp>

#include "describe_internal.hpp"
#include "state_internal.hpp"

namespace limpet::model::internal {
namespace {

constexpr std::string_view kMagic = "limpet model state 4 ";  ///< followed by the arithmetic and a newline
constexpr std::size_t kDigestBytes = 8;

std::string head() { return std::string(kMagic) + geometry::arithmetic() + "\n"; }

std::uint64_t digest_of(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.value();
}

using Age = std::pair<std::int64_t, SegmentId>;

/// The entries of point segments: only these expire, and no polygon becomes one again.
std::deque<Age> ages_that_matter(const Engine& e) {
  std::deque<Age> ages;
  const auto& all = Storage::by_age(e.agenda);
  std::copy_if(all.begin(), all.end(), std::back_inserter(ages), [&](const Age& age) {
    const Segment* s = e.complex.find(age.second);
    return s && !s->polygon;
  });
  return ages;
}

auto refusals_that_matter(const Engine& e) {
  auto refused = Storage::refused(e.agenda);
  std::erase_if(refused, [&](const auto& r) {
    return !e.complex.find(r.first.first) || !e.complex.find(r.first.second);
  });
  return refused;
}

/// The worklists of the segments, slot by slot; free slots have none.
template <class Archive, class AnyAgenda>
void describe_dues(Archive& archive, const Complex& complex, AnyAgenda& agenda) {
  for (std::uint32_t slot = 0; slot < complex.segments().slot_count(); ++slot) {
    if constexpr (Archive::kReads) agenda.opened(slot);
    if (complex.in_slot(slot)) Storage::describe_due(archive, agenda, slot);
  }
}

[[noreturn]] void refuse(const char* what) { Reader::refuse(what); }
[[noreturn]] void refuse_unpaired(geometry::EdgeId) { Reader::refuse("has a shared edge without a partner"); }

}  // namespace

std::string to_state(const Engine& e, bool with_labels) {
  Writer writer;
  writer.append(head());
  writer(e.setting.parameters, e, e.insertion.pending());
  describe_dues(writer, e.complex, e.agenda);
  const bool labels = with_labels && e.labels.kept();
  writer(ages_that_matter(e), refusals_that_matter(e), Storage::partners(e.complex), labels,
         labels ? e.labels.settled(e.complex.segments()) : std::vector<std::uint64_t>(),
         Storage::successors(e.successors));
  // Left out where there is nothing to say, as in states that were written before there were any.
  if (const auto confirmations = Storage::confirmations(e.complex); !confirmations.empty())
    writer(confirmations);
  writer(digest_of(writer.bytes()));
  return std::move(writer.bytes());
}

StoredState::StoredState(std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) Reader::refuse("is of another version, or no such thing");
  if (!bytes.starts_with(head())) Reader::refuse("is of another arithmetic");
  if (bytes.size() < head().size() + kDigestBytes) Reader::refuse("ends too early");
  const std::string_view body = bytes.substr(0, bytes.size() - kDigestBytes);
  if (Reader(bytes.substr(body.size())).word(kDigestBytes) != digest_of(body))
    Reader::refuse("is damaged: its digest is another");
  Reader reader(body.substr(head().size()));
  reader(parameters_);
  rest_ = reader.take(reader.left());
}

void StoredState::restore(Engine& e) const {
  Reader reader(rest_);
  reader(e, e.insertion.pending());
  describe_dues(reader, e.complex, e.agenda);
  std::map<geometry::EdgeId, geometry::EdgeId> partners;
  std::map<SegmentId, SegmentId> successors;
  bool labels_kept = false;
  reader(Storage::by_age(e.agenda), Storage::refused(e.agenda), partners, labels_kept,
         Storage::labels(e.labels), successors);
  std::map<SegmentId, std::int64_t> confirmations;
  if (reader.left() > 0) reader(confirmations);
  if (reader.left() > 0) Reader::refuse("goes on behind its end");
  if (labels_kept) e.labels.keep();
  Storage::list_segments(e.complex, refuse);
  Storage::set_confirmations(e.complex, confirmations, refuse);
  require_sound(e, successors);
  Storage::pair_edges(e.complex, partners, refuse_unpaired);
  Storage::set_successors(e.successors, successors);
  Storage::fill_index(e.complex);
}

}  // namespace limpet::model::internal
