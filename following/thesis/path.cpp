// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <limits>
#include <map>
#include <unordered_map>

#include "edges_internal.hpp"
#include "path_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using geometry::EdgeId;
using model::SegmentId;
using model::View;

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                    boost::property<boost::edge_weight_t, double>>;
constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// Vertex i of the graph is where edge i begins; one more is the start.
class Network {
 public:
  Network(const View& view, const std::set<EdgeId>& barred, double rim) : barred_(barred), rim_(rim) {
    std::vector<SegmentId> segments;
    model::Which polygons;
    polygons.points = false;
    view.segments(segments, polygons);
    std::vector<View::Edge> of_one;
    for (const SegmentId id : segments) {
      view.edges(id, of_one);
      edges_.insert(edges_.end(), of_one.begin(), of_one.end());
      planes_.resize(edges_.size(), view.segment(id)->plane);
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) index_.emplace(edges_[i].id.value, i);
    graph_ = Graph(edges_.size() + 1);
    for (std::size_t i = 0; i < edges_.size(); ++i) add(i);
  }

  std::optional<Path> path(const Vector3d& start, const std::vector<SegmentId>& goals) {
    const auto first = nearest(start);
    if (!first) return std::nullopt;
    for (const std::size_t same : {*first, partner(*first)})
      if (is_goal(same, goals)) return Path{{leg(same, true)}, edges_[same].segment};
    begin_at(*first, start);
    auto goal = search(goals);
    if (!goal) add_hops(), goal = search(goals);
    if (!goal) return std::nullopt;
    return traced(*goal, *first);
  }

 private:
  bool is_barred(std::size_t i) const {
    return barred_.count(edges_[i].id) || barred_.count(edges_[i].partner);
  }
  std::size_t next(std::size_t i) const { return index_.at(edges_[i].next.value); }
  std::size_t partner(std::size_t i) const {
    return edges_[i].partner ? index_.at(edges_[i].partner.value) : i;
  }
  std::size_t start() const { return edges_.size(); }
  bool is_goal(std::size_t i, const std::vector<SegmentId>& goals) const {
    return !is_barred(i) && std::binary_search(goals.begin(), goals.end(), edges_[i].segment);
  }
  Path::Leg leg(std::size_t i, bool forwards) const {
    const View::Edge& e = edges_[i];
    return forwards ? Path::Leg{e.id, e.from, e.to, true} : Path::Leg{e.id, e.to, e.from, false};
  }

  void add(std::size_t i) {
    if (!is_barred(i)) boost::add_edge(i, next(i), length(edges_[i]), graph_);
    // The two copies of a shared edge run in opposite directions: one begins where the other ends.
    if (edges_[i].partner) boost::add_edge(i, next(partner(i)), 0.0, graph_);
  }

  void begin_at(std::size_t first, const Vector3d& place) {
    const Vector3d at = nearest_on(edges_[first], place);
    boost::add_edge(start(), first, (edges_[first].from - at).norm(), graph_);
    boost::add_edge(start(), next(first), (edges_[first].to - at).norm(), graph_);
  }

  std::optional<std::size_t> nearest(const Vector3d& place) const {
    std::optional<std::size_t> best;
    double least = kUnreached;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const double d = is_barred(i) ? kUnreached : distance(edges_[i], place);
      if (d < least) least = d, best = i;
    }
    return best;
  }

  /// The nearest vertex from which an edge of a goal leaves.
  std::optional<std::size_t> search(const std::vector<SegmentId>& goals) {
    before_.assign(boost::num_vertices(graph_), 0);
    std::vector<double> far(boost::num_vertices(graph_));
    boost::dijkstra_shortest_paths(
        graph_, start(),
        boost::predecessor_map(before_.data()).distance_map(far.data()).distance_inf(kUnreached));
    std::optional<std::size_t> best;
    double least = kUnreached;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (far[i] < least && is_goal(i, goals)) least = far[i], best = i;
    return best;
  }

  /// How far a hop between two vertices is, if that is less than `least`. One that leads from behind one
  /// polygon to behind another, through the body, is as good as none.
  double hop_length(std::size_t a, std::size_t b, double least) const {
    constexpr double kThroughBody = 10;
    const Vector3d &from = edges_[a].from, &to = edges_[b].from;
    const double length = (to - from).norm();
    if (length >= least) return length;
    // So are the two rims of a gap at a convex edge, but not by much.
    const double behind = std::max(planes_[a].height_of(to), planes_[b].height_of(from));
    return behind < -rim_ ? kThroughBody * length : length;
  }

  /// Joins every two parts of the graph by their nearest vertices.
  void add_hops() {
    std::vector<std::size_t> part(boost::num_vertices(graph_));
    boost::connected_components(graph_, part.data());
    struct Hop {
      double length = kUnreached;
      std::size_t from = 0, to = 0;
    };
    std::map<std::pair<std::size_t, std::size_t>, Hop> hops;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (part[i] == part[j]) continue;
        Hop& hop = hops[std::minmax(part[i], part[j])];
        const double length = hop_length(i, j, hop.length);
        if (length < hop.length) hop = {length, i, j};
      }
    for (const auto& [parts, hop] : hops) boost::add_edge(hop.from, hop.to, hop.length, graph_);
  }

  /// From one vertex to the next: an edge, one of its copies, or a hop; nothing between two copies of a
  /// vertex.
  std::optional<Path::Leg> leg_between(std::size_t a, std::size_t b) const {
    if (next(a) == b && !is_barred(a)) return leg(a, true);
    if (next(b) == a && !is_barred(b)) return leg(b, false);
    const bool copies =
        (edges_[a].partner && next(partner(a)) == b) || (edges_[b].partner && next(partner(b)) == a);
    if (copies) return std::nullopt;
    return Path::Leg{{}, edges_[a].from, edges_[b].from};
  }

  Path traced(std::size_t goal, std::size_t first) const {
    Path path{{leg(goal, true)}, edges_[goal].segment};
    std::size_t at = goal;
    for (; before_[at] != start(); at = before_[at])
      if (const auto l = leg_between(before_[at], at)) path.legs.push_back(*l);
    path.legs.push_back(leg(first, at != first));
    std::reverse(path.legs.begin(), path.legs.end());
    return path;
  }

  const std::set<EdgeId>& barred_;
  double rim_;
  std::vector<View::Edge> edges_;
  std::vector<geometry::Plane> planes_;  ///< of the edges' segments
  std::unordered_map<std::uint64_t, std::size_t> index_;
  Graph graph_;
  std::vector<std::size_t> before_;
};

}  // namespace

std::optional<Path> shortest_path(const View& view, const Vector3d& start,
                                  const std::vector<SegmentId>& goals, const std::set<EdgeId>& barred,
                                  double rim) {
  return Network(view, barred, rim).path(start, goals);
}

}  // namespace limpet::following::internal
