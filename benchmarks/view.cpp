// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <limpet/model/view.hpp>
#include <limpet/survey/random.hpp>

#include "contestants.hpp"
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

using Eigen::Vector3d;
using model::View;
using survey::Random;

constexpr std::size_t kQuestions = 10'000;
constexpr std::int64_t kUpdatePoints = 200'000;
constexpr int kRounds = 3;

/// A place to ask about, and a direction.
struct Place {
  Vector3d at, direction;
};

Vector3d any_direction(Random& random) {
  for (;;) {
    const Vector3d d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (d.norm() > 0.1 && d.norm() < 1) return d.normalized();
  }
}

/// Where a follower is: up to 8 λ off the true surface, evenly over it, on a route that goes to and fro in
/// stripes 10 λ wide, with about λ of way from one question to the next, as what moves through a scene does.
std::vector<Place> places_near(const ScanCase& scan_case) {
  Random random(1);
  const double lambda = scan_case.resolution, stripe_width = 10 * lambda;
  double area = 0;
  for (const auto& face : simulation::faces_of(scan_case.scene.mesh)) area += face.area;
  simulation::ScanOptions options;
  options.points =
      std::max<std::int64_t>(kQuestions, static_cast<std::int64_t>(area / (stripe_width * lambda)));
  options.order = simulation::ScanOptions::Order::sampled, options.seed = 2;
  std::vector<Place> places;
  simulation::scan(scan_case.scene.mesh, options, [&](const simulation::LabelledPoint& p) {
    const double off = random.uniform(0, 8 * lambda);
    places.push_back({p.point.position - off * p.point.axis, any_direction(random)});
  });
  const auto stripe = [&](const Place& p) { return std::floor(p.at.x() / stripe_width); };
  std::sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
    if (stripe(a) != stripe(b)) return stripe(a) < stripe(b);
    return std::fmod(stripe(a), 2) == 0 ? a.at.y() < b.at.y() : a.at.y() > b.at.y();
  });
  return places;
}

/// Anywhere in the scene's box, each far from the last: what lies there is in no cache.
std::vector<Place> places_anywhere(const ScanCase& scan_case) {
  Random random(3);
  const auto bounds = simulation::bounds_of(scan_case.scene.mesh);
  std::vector<Place> places;
  for (std::size_t i = 0; i < kQuestions; ++i) {
    Vector3d p;
    for (int k = 0; k < 3; ++k) p[k] = random.uniform(bounds.low[k], bounds.high[k]);
    places.push_back({p, any_direction(random)});
  }
  return places;
}

/// Microseconds that questions take, each in the fastest of some rounds through all of them. Every round
/// comes to each question anew, so that caches help as much as they would.
template <class Ask>
Json times_of(std::size_t count, Ask&& ask) {
  std::vector<double> micros(count, 1e300);
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < count; ++i) {
      const WallWatch watch;
      ask(i);
      micros[i] = std::min(micros[i], 1e6 * watch.seconds());
    }
  std::sort(micros.begin(), micros.end());
  const auto quantile = [&](double share) {
    return micros[static_cast<std::size_t>(std::ceil(share * static_cast<double>(count))) - 1];
  };
  return {{"asked", count}, {"median", quantile(0.5)}, {"q99", quantile(0.99)}, {"worst", quantile(1)}};
}

/// What questions about places come to; so that none is left out by the compiler.
struct Found {
  std::size_t some = 0;
  void count(bool found) { some += found; }
};

void ask_about_places(const View& view, const std::vector<Place>& places, double reach, double lambda,
                      const std::string& where, Json& answer) {
  Found found;
  std::vector<View::Nearest> all;
  std::vector<View::LinkNearest> all_links;
  const auto link_at = [&](const Place& p) {
    return model::Capsule{p.at, p.at + 10 * lambda * p.direction, lambda};
  };
  const auto add = [&](const std::string& question, auto&& ask) {
    Json times = times_of(places.size(), [&](std::size_t i) { ask(places[i]); });
    times["question"] = question + where;
    answer.push_back(times);
  };
  add("nearest to a point", [&](const Place& p) { found.count(view.nearest(p.at, reach).has_value()); });
  add("nearest to a link", [&](const Place& p) { found.count(view.nearest(link_at(p), reach).has_value()); });
  add("first hit of a ray",
      [&](const Place& p) { found.count(view.first_hit(p.at, p.direction, reach).has_value()); });
  if (reach < std::numeric_limits<double>::infinity()) {
    add("all within reach of a point", [&](const Place& p) { view.nearest(p.at, reach, all); });
    add("all within reach of a link", [&](const Place& p) { view.nearest(link_at(p), reach, all_links); });
  }
  answer.back()["found"] = found.some;
}

void ask_about_identities(const View& view, Json& answer) {
  Random random(4);
  std::vector<model::SegmentId> segments, neighbours;
  view.segments(segments, {.points = false});
  std::vector<View::Edge> open, edges;
  view.open_edges(open);
  std::vector<geometry::EdgeId> some_open, some_shared;
  std::vector<model::SegmentId> some_segments;
  for (std::size_t i = 0; i < kQuestions; ++i) {
    some_segments.push_back(segments[random.below(segments.size())]);
    if (!open.empty() && i < kQuestions / 10) some_open.push_back(open[random.below(open.size())].id);
    view.edges(some_segments.back(), edges);
    const auto& edge = edges[random.below(edges.size())];
    if (edge.partner) some_shared.push_back(edge.id);
  }
  const auto add = [&](const char* question, std::size_t count, auto&& ask) {
    if (count == 0) return;
    Json times = times_of(count, ask);
    times["question"] = question;
    answer.push_back(times);
  };
  Found found;
  add("segment by identity", some_segments.size(),
      [&](std::size_t i) { found.count(view.segment(some_segments[i]).has_value()); });
  add("shared edge by identity", some_shared.size(),
      [&](std::size_t i) { found.count(view.edge(some_shared[i]).has_value()); });
  add("open edge by identity", some_open.size(),
      [&](std::size_t i) { found.count(view.edge(some_open[i]).has_value()); });
  add("a segment's edges", some_segments.size(), [&](std::size_t i) { view.edges(some_segments[i], edges); });
  add("a segment's open edges", some_segments.size(),
      [&](std::size_t i) { view.open_edges(some_segments[i], edges); });
  add("a segment's neighbours", some_segments.size(),
      [&](std::size_t i) { view.neighbours(some_segments[i], neighbours); });
  add("all open edges", 20, [&](std::size_t) { view.open_edges(open); });
  answer.back()["found"] = found.some;
}

/// The time that updates take when a reader asks for each point of the last set what is nearest, over the
/// time they take without. Two models get the same sets, one after the other, in turns; the questions are not
/// timed.
double update_ratio(const ScanCase& scan_case) {
  model::Model read(scan_case.parameters()), alone(scan_case.parameters());
  const double reach = 10 * scan_case.resolution;
  std::vector<model::SensorPoint> set;
  std::array<double, 2> seconds{};
  std::int64_t points = 0;
  bool first = false;
  Found found;
  const auto update = [&](bool with_reader) {
    const auto start = std::chrono::steady_clock::now();
    (with_reader ? read : alone).update(set);
    seconds[with_reader] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  scan_case.scan([&](const simulation::LabelledPoint& p) {
    set.push_back(p.point);
    if (set.size() < kSet) return;
    if (points >= kUpdatePoints) return set.clear();
    first = !first;
    update(first), update(!first);
    for (const auto& q : set) found.count(read.view().nearest(q.position, reach).has_value());
    points += static_cast<std::int64_t>(set.size());
    set.clear();
  });
  return found.some > 0 ? seconds[1] / seconds[0] : 0;
}

}  // namespace

Json answer_view(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  model::Model model(scan_case.parameters());
  std::vector<model::SensorPoint> set;
  scan_case.scan([&](const simulation::LabelledPoint& p) {
    set.push_back(p.point);
    if (set.size() < kSet) return;
    model.update(set);
    set.clear();
  });
  if (request.at("finish")) model.finish();
  const double lambda = scan_case.resolution;
  Json questions = Json::array();
  const View view = model.view();
  ask_about_places(view, places_near(scan_case), 10 * lambda, lambda, ", near", questions);
  ask_about_places(view, places_anywhere(scan_case), std::numeric_limits<double>::infinity(), lambda,
                   ", anywhere", questions);
  ask_about_identities(view, questions);
  const auto counts = model.counts();
  return {{"polygons", counts.polygons},
          {"points", counts.point_segments},
          {"edges", counts.edges},
          {"update_ratio", update_ratio(scan_case)},
          {"questions", questions}};
}

Table measure_view(const ViewOptions& options, const Limits& limits) {
  Table table({{"shape"},
               {"finished"},
               {"polygons"},
               {"point_segments"},
               {"edges"},
               {"question"},
               {"asked"},
               {"median_us", 3},
               {"q99_us", 3},
               {"worst_us", 3},
               {"update_with_readers", 3},
               {"note"}});
  for (const int boxes : options.boxes)
    for (const bool finish : {false, true}) {
      const std::string shape = "city:" + std::to_string(boxes);
      const CloudSpec spec{
          .shape = shape, .order = "sampled", .points = options.points_per_face * (5 * boxes + 1)};
      std::fprintf(stderr, "view, %s%s\n", shape.c_str(), finish ? ", finished" : "");
      const Json answer =
          ask_process({{"what", "view"}, {"spec", spec}, {"finish", finish}}, limits.own_seconds);
      if (answer.contains("failed")) {
        table.add({shape, finish, {}, {}, {}, {}, {}, {}, {}, {}, {}, answer["failed"]});
        continue;
      }
      for (const Json& q : answer["questions"])
        table.add({shape,
                   finish,
                   answer["polygons"],
                   answer["points"],
                   answer["edges"],
                   q["question"],
                   q["asked"],
                   q["median"],
                   q["q99"],
                   q["worst"],
                   answer["update_ratio"],
                   {}});
    }
  return table;
}

}  // namespace limpet::benchmarks
