// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/drawing/boundary.hpp>

#include <cstddef>
#include <unordered_map>

namespace limpet::drawing {
namespace {

/// The boundary before, flattened, with its vertices by their edges.
class Before {
 public:
  explicit Before(const Boundary& boundary) {
    for (const Boundary::Cycle& cycle : boundary.cycles)
      for (const BoundaryVertex& vertex : cycle.vertices) {
        index_.emplace(vertex.edge, static_cast<std::int64_t>(vertices_.size()));
        vertices_.push_back(&vertex);
      }
  }
  /// Where the vertex was, with the same edge, or −1.
  std::int64_t find(const BoundaryVertex& vertex) const {
    const auto found = index_.find(vertex.edge);
    return found == index_.end() ? -1 : found->second;
  }
  const BoundaryVertex& at(std::int64_t i) const { return *vertices_[static_cast<std::size_t>(i)]; }
  /// Where the vertex was, just as it is now, or −1.
  std::int64_t find_same(const BoundaryVertex& vertex) const {
    const std::int64_t i = find(vertex);
    return i >= 0 && at(i) == vertex ? i : -1;
  }

 private:
  std::vector<const BoundaryVertex*> vertices_;
  std::unordered_map<std::uint64_t, std::int64_t> index_;
};

struct Run {
  std::size_t first = 0, length = 0;
  std::int64_t copied_from = -1;  ///< −1: told in full
};

std::vector<Run> runs_of(const std::vector<BoundaryVertex>& vertices, const Before& before) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::int64_t from = before.find_same(vertices[i]);
    const bool goes_on =
        !runs.empty() &&
        (from < 0 ? runs.back().copied_from < 0
                  : runs.back().copied_from >= 0 &&
                        from == runs.back().copied_from + static_cast<std::int64_t>(runs.back().length));
    if (!goes_on) runs.push_back({i, 0, from});
    ++runs.back().length;
  }
  return runs;
}

/// Puts runs of vertices one after the other.
class BoundaryWriter {
 public:
  BoundaryWriter(const Before& before, VarintWriter& out) : before_(before), out_(out) {}

  void put(const Run& run, const std::vector<BoundaryVertex>& vertices) {
    out_.put(2 * run.length + (run.copied_from < 0));
    if (run.copied_from >= 0) {
      out_.put_signed(run.copied_from - expected_);
      expected_ = run.copied_from + static_cast<std::int64_t>(run.length);
    }
    for (std::size_t i = run.first; i < run.first + run.length; ++i) {
      if (run.copied_from < 0) put(vertices[i]);
      last_ = vertices[i];
    }
  }

 private:
  void put(const BoundaryVertex& vertex) {
    out_.put_signed(difference(vertex.edge, last_.edge));
    out_.put(vertex.partner == 0 ? 0 : VarintWriter::zigzag(difference(vertex.partner, vertex.edge)) + 1);
    const std::int64_t old = before_.find(vertex);
    const Place& reference = old >= 0 ? before_.at(old).at : last_.at;
    for (std::size_t k = 0; k < 3; ++k) out_.put_signed(vertex.at[k] - reference[k]);
  }
  static std::int64_t difference(std::uint64_t a, std::uint64_t b) {
    return static_cast<std::int64_t>(a - b);
  }

  const Before& before_;
  VarintWriter& out_;
  BoundaryVertex last_;
  std::int64_t expected_ = 0;  ///< just after the last vertex that was copied
};

}  // namespace

void put_boundary(const Boundary& now, const Boundary& before, VarintWriter& out) {
  const Before old(before);
  BoundaryWriter writer(old, out);
  out.put(now.cycles.size());
  for (const Boundary::Cycle& cycle : now.cycles) {
    const std::vector<Run> runs = runs_of(cycle.vertices, old);
    out.put(cycle.hole);
    out.put(runs.size());
    for (const Run& run : runs) writer.put(run, cycle.vertices);
  }
}

}  // namespace limpet::drawing
