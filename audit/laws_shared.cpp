// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/audit/exact_internal.hpp>
#include <limpet/audit/laws_internal.hpp>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace limpet::audit::internal {
namespace {

constexpr double kParallelSine = 1e-9;
constexpr int kLineSteps = 2;
constexpr int kEndSteps = 2 * kLineSteps;  // either copy's end may be kLineSteps from their common point
constexpr double kRunsOnSine = 0.2;        // below it, two edges with one end run on in one line
constexpr double kRunsOnReach = 0.25;      // resolutions: from the common line, where they do

struct EdgePlace {
  std::size_t polygon, cycle, vertex;
};

struct Pair {
  EdgePlace first, second;
};

class Sharing {
 public:
  Sharing(const Document& document, Report& report) : document_(document), report_(report) {
    for (std::size_t s = 0; s < document.polygons.size(); ++s) {
      const auto& cycles = document.polygons[s].cycles;
      for (std::size_t c = 0; c < cycles.size(); ++c)
        for (std::size_t i = 0; i < cycles[c].size(); ++i)
          places_.insert({cycles[c][i].edge, EdgePlace{s, c, i}});
    }
  }

  void judge() {
    judge_partners();
    for (std::size_t s = 0; s < document_.polygons.size(); ++s)
      for (std::size_t c = 0; c < document_.polygons[s].cycles.size(); ++c) {
        judge_global_order(s, c);
        judge_local_order(s, c);
      }
    if (!(std::isfinite(document_.step) && document_.step > 0)) return;
    for (const Polygon& polygon : document_.polygons)
      planes_.push_back(is_finite(polygon) ? std::optional<ExactPlane>(std::in_place, polygon, document_.step)
                                           : std::nullopt);
    for (const Pair& pair : pairs_) judge_geometry(pair);
  }

 private:
  const Vertex& vertex(const EdgePlace& at) const {
    return document_.polygons[at.polygon].cycles[at.cycle][at.vertex];
  }
  std::string name(const EdgePlace& at) const { return "edge " + std::to_string(vertex(at).edge); }
  EdgePlace next(EdgePlace at) const {
    at.vertex = (at.vertex + 1) % document_.polygons[at.polygon].cycles[at.cycle].size();
    return at;
  }
  EdgePlace previous(EdgePlace at) const {
    const std::size_t n = document_.polygons[at.polygon].cycles[at.cycle].size();
    at.vertex = (at.vertex + n - 1) % n;
    return at;
  }

  // Why the edge is not one of a valid pair of shared edges; null when it is.
  const char* fault(const EdgePlace& at) const {
    const auto found = places_.find(vertex(at).partner);
    if (found == places_.end()) return "its partner does not exist";
    if (found->second.polygon == at.polygon) return "its partner is on the same segment";
    if (vertex(found->second).partner != vertex(at).edge) return "its partner has another partner";
    return nullptr;
  }

  // The partner of an edge, if the two are a valid pair.
  std::optional<EdgePlace> partner(const EdgePlace& at) const {
    if (vertex(at).partner == 0 || fault(at)) return {};
    return places_.at(vertex(at).partner);
  }

  void judge_partners() {
    for (std::size_t s = 0; s < document_.polygons.size(); ++s)
      for (std::size_t c = 0; c < document_.polygons[s].cycles.size(); ++c)
        for (std::size_t i = 0; i < document_.polygons[s].cycles[c].size(); ++i) {
          const EdgePlace at{s, c, i};
          if (vertex(at).partner == 0) continue;
          if (const char* what = fault(at)) {
            report_.add("partner", name(at), what);
          } else if (const EdgePlace other = *partner(at); s < other.polygon) {
            pairs_.push_back({at, other});
          }
        }
  }

  // Two neighbours alternate on a cycle (a b a b) exactly when their edges do not nest like brackets.
  // Neighbours met so far are on a stack; one that is met again closes those above it; a closed one must not
  // come again.
  void judge_global_order(std::size_t s, std::size_t c) {
    std::vector<std::size_t> open;
    std::unordered_set<std::size_t> seen, closed;
    for (std::size_t i = 0; i < document_.polygons[s].cycles[c].size(); ++i) {
      const auto other = partner({s, c, i});
      if (!other) continue;
      const std::size_t neighbour = other->polygon;
      if (closed.count(neighbour)) {
        report_.add("global-order", name({s, c, i}),
                    "edges shared with segment " + std::to_string(document_.polygons[neighbour].id) +
                        " alternate with another neighbour's");
        return;
      }
      if (seen.insert(neighbour).second) {
        open.push_back(neighbour);
        continue;
      }
      for (; open.back() != neighbour; open.pop_back()) closed.insert(open.back());
    }
  }

  // Along this cycle, the indices of the partners on any other cycle must decrease, wrapping around once at
  // most.
  void judge_local_order(std::size_t s, std::size_t c) {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<EdgePlace>> partners;
    for (std::size_t i = 0; i < document_.polygons[s].cycles[c].size(); ++i)
      if (const auto other = partner({s, c, i}); other && s < other->polygon)
        partners[{other->polygon, other->cycle}].push_back(*other);
    for (const auto& [cycle, sequence] : partners) {
      std::size_t rises = 0;
      for (std::size_t k = 0; k < sequence.size(); ++k)
        if (sequence[k].vertex < sequence[(k + 1) % sequence.size()].vertex) ++rises;
      if (rises > 1)
        report_.add("local-order", cycle_name(document_.polygons[s], c),
                    "edges shared with " + cycle_name(document_.polygons[cycle.first], cycle.second) +
                        " are not in its reverse order");
    }
  }

  const ExactPlane& plane(const EdgePlace& at) const { return *planes_[at.polygon]; }

  ExactVector position(const EdgePlace& at) const {
    const Vertex& p = vertex(at);
    const ExactPlane& on = plane(at);
    return on.q + Dyadic(document_.step) * (Dyadic(p.x) * on.along_x + Dyadic(p.y) * on.along_y);
  }

  // A corner vertex joins two edges shared with different neighbours.
  bool is_corner(const EdgePlace& at) const {
    const auto before = partner(previous(at));
    const auto after = partner(at);
    return before && after && before->polygon != after->polygon;
  }

  // Do the two edges at a corner vertex run on in one line, or nearly so? As two planes that are parallel or
  // nearly so then cut the polygon's, the lines do not say where the corner is.
  bool runs_on(const EdgePlace& at) const {
    if (!is_corner(at) || !std::isfinite(document_.resolution)) return false;
    const EdgePlace before = previous(at);
    const std::size_t first = partner(before)->polygon, second = partner(at)->polygon;
    if (!planes_[first] || !planes_[second]) return false;
    if (dot(position(at) - position(before), position(next(at)) - position(at)).sign() <= 0) return false;
    const ExactVector a = cross(plane(at).normal, planes_[first]->normal),
                      b = cross(plane(at).normal, planes_[second]->normal), turn = cross(a, b);
    return dot(turn, turn) <= Dyadic(kRunsOnSine) * Dyadic(kRunsOnSine) * dot(a, a) * dot(b, b);
  }

  void judge_geometry(const Pair& pair) {
    const auto& [e, f] = pair;
    if (!planes_[e.polygon] || !planes_[f.polygon]) return;
    const Dyadic normals = dot(plane(e).normal, plane(e).normal) * dot(plane(f).normal, plane(f).normal);
    const ExactVector line = cross(plane(e).normal, plane(f).normal);
    const Dyadic line_squared = dot(line, line);
    if (line_squared <= Dyadic(kParallelSine) * Dyadic(kParallelSine) * normals) {
      report_.add("shared-line", name(e), "its plane and that of " + name(f) + " are parallel");
      return;
    }
    judge_line(e, f);
    judge_line(f, e);
    const int way_e = dot(line, position(next(e)) - position(e)).sign();
    const int way_f = dot(line, position(next(f)) - position(f)).sign();
    if (way_e == 0 || way_f != -way_e) {
      report_.add("shared-direction", name(e), "it does not run opposite to " + name(f));
      return;
    }
    judge_concavity(e, f, way_e);
    judge_overlap(e, f, line, way_e);
    // (distance · sin θ)² <= (kEndSteps · step)², multiplied by |n1|²|n2|².
    const Dyadic reach = Dyadic(kEndSteps) * Dyadic(document_.step);
    judge_ends(e, next(f), line_squared, reach * reach * normals);
    judge_ends(next(e), f, line_squared, reach * reach * normals);
  }

  // A point of one plane that is at distance d from the other plane is d / sin θ from their common line. So
  // "within 2 steps / sin θ of the line" is checked as "within 2 steps of the other plane".
  void judge_line(const EdgePlace& at, const EdgePlace& other) {
    const ExactVector& normal = plane(other).normal;
    for (const EdgePlace& end : {at, next(at)}) {
      const Dyadic reach = runs_on(end) ? Dyadic(kRunsOnReach) * Dyadic(document_.resolution)
                                        : Dyadic(kLineSteps) * Dyadic(document_.step);
      const Dyadic off = dot(normal, position(end) - plane(other).q);
      if (reach * reach * dot(normal, normal) < off * off)
        report_.add("shared-line", name(at),
                    "vertex " + std::to_string(end.vertex) + " is off the common line with " + name(other));
    }
  }

  // The first edge of a convex pair runs along n1 × n2, that of a concave pair against it.
  void judge_concavity(const EdgePlace& e, const EdgePlace& f, int way) {
    const auto [known, added] = concavity_.insert({{e.polygon, f.polygon}, way});
    if (!added && known->second != way)
      report_.add("concavity", name(e),
                  way > 0 ? "convex, but its segments are concave" : "concave, but its segments are convex");
  }

  void judge_overlap(const EdgePlace& e, const EdgePlace& f, const ExactVector& line, int way) {
    const ExactVector along = Dyadic(way) * line;
    const Dyadic e_begin = dot(along, position(e)), e_end = dot(along, position(next(e)));
    const Dyadic f_begin = dot(along, position(next(f))), f_end = dot(along, position(f));
    if (e_end <= f_begin || f_end <= e_begin)
      report_.add("shared-overlap", name(e), "it does not overlap " + name(f));
  }

  void judge_ends(const EdgePlace& a, const EdgePlace& b, const Dyadic& line_squared, const Dyadic& limit) {
    if (is_corner(a) || is_corner(b)) return;
    const ExactVector gap = position(a) - position(b);
    if (limit < dot(gap, gap) * line_squared)
      report_.add("shared-ends", vertex_name(document_.polygons[a.polygon], a.cycle, a.vertex),
                  "does not meet " + vertex_name(document_.polygons[b.polygon], b.cycle, b.vertex));
  }

  const Document& document_;
  Report& report_;
  std::unordered_map<std::uint64_t, EdgePlace> places_;
  std::vector<Pair> pairs_;
  std::vector<std::optional<ExactPlane>> planes_;  // by polygon
  std::map<std::pair<std::size_t, std::size_t>, int> concavity_;
};

}  // namespace

void judge_shared_edges(const Document& document, Report& report) { Sharing(document, report).judge(); }

}  // namespace limpet::audit::internal
