// Copyright the limpet authors. GPL-3.0-or-later.
//
// All of a model as bytes, so that what follows is the same to the bit. What is dead is not stored:
// identities are never used again, so nothing will ask for it. Indices are made anew: no result depends on
// their order.
#include <algorithm>

#include <limpet/geometry/predicates.hpp>
#include <limpet/model/digest.hpp>

#include "describe_internal.hpp"

namespace limpet::model::internal {
namespace {

constexpr std::string_view kMagic = "limpet model state 1 ";  ///< then the arithmetic and a line's end
constexpr std::size_t kDigestBytes = 8;

std::string head() { return std::string(kMagic) + geometry::arithmetic() + "\n"; }

std::uint64_t digest_of(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.value();
}

using Age = std::pair<std::int64_t, SegmentId>;
using Refused = std::map<std::pair<SegmentId, SegmentId>, std::pair<std::uint64_t, std::uint64_t>>;

bool lives(const Engine& e, SegmentId id) { return e.slot_of.count(id.value) > 0; }

/// Only point segments expire, and a polygon never becomes one.
std::deque<Age> ages_that_matter(const Engine& e) {
  std::deque<Age> ages;
  std::copy_if(e.by_age.begin(), e.by_age.end(), std::back_inserter(ages), [&](const Age& age) {
    const auto entry = e.slot_of.find(age.second.value);
    return entry != e.slot_of.end() && !e.at(entry->second).polygon;
  });
  return ages;
}

Refused refusals_that_matter(const Engine& e) {
  Refused refused = e.refused_pairs;
  std::erase_if(refused,
                [&](const auto& r) { return !lives(e, r.first.first) || !lives(e, r.first.second); });
  return refused;
}

std::map<geometry::EdgeId, SharedEdge> shared_in_order(const Engine& e) {
  std::map<geometry::EdgeId, SharedEdge> shared;
  for (const auto& [edge, entry] : e.shared) shared.emplace(geometry::EdgeId{edge}, entry);
  return shared;
}

/// Segments know their places, and are found by identity and by place.
void list_segments(Engine& e) {
  for (std::uint32_t slot = 0; slot < e.segments.size(); ++slot) {
    Segment* s = e.segments[slot].get();
    if (!s) continue;
    s->slot = slot;
    if (!e.slot_of.emplace(s->id.value, slot).second) Reader::refuse("has two segments of one identity");
  }
}

void list_shared(Engine& e, const std::map<geometry::EdgeId, SharedEdge>& shared) {
  for (const auto& [edge, entry] : shared) {
    e.shared.emplace(edge.value, entry);
    if (entry.segment < e.segments.size() && e.segments[entry.segment] && e.at(entry.segment).polygon)
      e.at(entry.segment).polygon->shared.push_back(edge);  // in ascending order
  }
}

void fill_indices(Engine& e) {
  for (const auto& s : e.segments)
    if (s) (s->polygon ? e.polygons : e.points).insert(s->indexed, s->slot);
}

}  // namespace

std::string to_state(const Engine& e) {
  Writer writer;
  writer.append(head());
  writer(e.parameters, e, ages_that_matter(e), refusals_that_matter(e), e.labels, shared_in_order(e));
  writer(digest_of(writer.bytes()));
  return std::move(writer.bytes());
}

Engine from_state(std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) Reader::refuse("is of another version, or no such thing");
  if (!bytes.starts_with(head())) Reader::refuse("is of another arithmetic");
  if (bytes.size() < head().size() + kDigestBytes) Reader::refuse("ends too early");
  const std::string_view body = bytes.substr(0, bytes.size() - kDigestBytes);
  if (Reader(bytes.substr(body.size())).word(kDigestBytes) != digest_of(body))
    Reader::refuse("is damaged: its digest is another");

  Reader reader(body.substr(head().size()));
  Parameters parameters;
  reader(parameters);
  Engine e(parameters);
  std::map<geometry::EdgeId, SharedEdge> shared;
  reader(e, e.by_age, e.refused_pairs, e.labels, shared);
  if (reader.left() > 0) Reader::refuse("goes on behind its end");
  list_segments(e);
  list_shared(e, shared);
  require_sound(e);
  list_all_pairs(e);
  fill_indices(e);
  return e;
}

}  // namespace limpet::model::internal
