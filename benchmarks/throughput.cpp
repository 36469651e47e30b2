// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cstdio>
#include <map>

#include "cloud_file.hpp"
#include "contestants.hpp"
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

const std::map<std::string, Json>& requests() {
  static const std::map<std::string, Json> all{
      {"limpet", {{"what", "limpet"}}},
      {"limpet_default", {{"what", "default"}}},
      {"limpet_default_arrival", {{"what", "default"}, {"arrival", true}}},
      {"region_growing", {{"what", "region_growing"}}},
      {"region_growing_estimated", {{"what", "region_growing"}, {"estimate", true}}},
      {"region_growing_sphere", {{"what", "region_growing"}, {"sphere", true}}},
      {"region_growing_sphere_estimated", {{"what", "region_growing"}, {"sphere", true}, {"estimate", true}}},
      {"ransac", {{"what", "ransac"}}},
      {"ransac_estimated", {{"what", "ransac"}, {"estimate", true}}},
      {"polyfit", {{"what", "polyfit"}}}};
  return all;
}

bool is_own(const std::string& what) { return what == "limpet" || what == "default"; }

/// The faster of two answers, with what only one of them holds; a failure gives way to anything else.
void keep_best(Json& best, Json answer) {
  if (best.is_null() || best.contains("failed")) {
    best = std::move(answer);
    return;
  }
  if (answer.contains("failed")) return;
  if (answer["seconds"] > best["seconds"]) std::swap(answer, best);
  for (const auto& [key, value] : answer.items())
    if (!best.contains(key)) best[key] = value;
  if (answer.contains("floor_seconds") && answer["floor_seconds"] < best["floor_seconds"])
    best["floor_seconds"] = answer["floor_seconds"];
}

void add_contestant(const CloudSpec& spec, const Json& cloud, const std::string& name, const Json& a,
                    double limpet_ns, double floor_ns, Table& table) {
  std::vector<Json> row{spec.shape,
                        cloud["faces"],
                        spec.order,
                        cloud["points"],
                        a.value("resolution", cloud["resolution"].get<double>()),
                        name};
  if (a.contains("failed")) {
    row.resize(15);
    row[14] = a["failed"];
    return table.add(row);
  }
  const auto points = a["points"].get<double>();
  const double seconds = a["seconds"], ns = 1e9 * seconds / points;
  const double counted = a.value("faces_counted", 0), right = a.value("faces_right", 0);
  row.insert(row.end(), {ns, points / seconds});
  row.push_back(floor_ns > 0 ? Json(ns / floor_ns) : Json());
  row.push_back(limpet_ns > 0 ? Json(ns / limpet_ns) : Json());
  row.insert(row.end(),
             {a["megabytes"], a["planes"], counted > 0 ? Json(100 * right / counted) : Json(),
              a.contains("in_planes") ? Json(100 * a["in_planes"].get<double>() / points) : Json(), Json()});
  table.add(row);
}

/// The shares of the run that was timed by stage, of the time of the fastest run.
void add_stages(const CloudSpec& spec, const Json& best, const Json& staged, Table& table) {
  if (best.contains("failed") || staged.contains("failed")) return;
  const auto points = best["points"].get<double>();
  const auto ns = [&](double seconds) { return 1e9 * seconds / points; };
  double timed = staged["finish_wall_seconds"];
  for (const auto& [stage, seconds] : staged["stages"].items()) timed += seconds.get<double>();
  std::vector<Json> row{spec.shape, spec.order, best["points"], ns(best["floor_seconds"]),
                        ns(best["reading_seconds"])};
  const double all = ns(best["seconds"]);
  for (const char* stage : {"insertion", "dissolving", "mergers", "fissures", "sharing", "rest"})
    row.push_back(all * staged["stages"][stage].get<double>() / timed);
  row.push_back(all * staged["finish_wall_seconds"].get<double>() / timed);
  row.push_back(all);
  table.add(row);
}

}  // namespace

const std::vector<std::string>& contestant_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, request] : requests()) all.push_back(name);
    return all;
  }();
  return names;
}

ThroughputTables::ThroughputTables()
    : contestants({{"shape"},
                   {"true_faces"},
                   {"order"},
                   {"points"},
                   {"resolution"},
                   {"contestant"},
                   {"ns_per_point"},
                   {"points_per_second"},
                   {"times_floor"},
                   {"times_limpet"},
                   {"megabytes"},
                   {"planes"},
                   {"faces_right_%", 4},
                   {"in_planes_%", 4},
                   {"note"}}),
      stages({{"shape"},
              {"order"},
              {"points"},
              {"floor"},
              {"reading"},
              {"insertion"},
              {"dissolving"},
              {"mergers"},
              {"fissures"},
              {"sharing"},
              {"rest"},
              {"finishing"},
              {"all"}}) {}

void measure_throughput(const CloudSpec& spec, const ThroughputOptions& options, const Limits& limits,
                        ThroughputTables& tables) {
  std::fprintf(stderr, "%s, %ld points, %s: cloud", spec.shape.c_str(), spec.points, spec.order.c_str());
  const CloudFile cloud(spec, limits);
  const NamedFile mesh(limits, ".off"), scan(limits, ".ply");
  std::map<std::string, Json> best;
  Json staged;
  const auto ask = [&](Json request) {
    const std::string what = request["what"];
    request["spec"] = spec, request["cloud"] = cloud.path();
    if (what == "polyfit") request["mesh"] = mesh.path();
    if (what == "default") request["scan"] = scan.path();
    return ask_process(request, is_own(what) ? limits.own_seconds : limits.peer_seconds);
  };
  for (int run = 0; run < std::max(options.runs, options.peer_runs); ++run) {
    for (const auto& name : options.contestants) {
      const bool is_limpet = is_own(requests().at(name)["what"]);
      if (run >= (is_limpet ? options.runs : options.peer_runs)) continue;
      if (best[name].contains("failed")) continue;  // it would be too slow once more
      std::fprintf(stderr, ", %s", name.c_str());
      Json request = requests().at(name);
      if (is_limpet && run == 0) request["judge"] = true;
      keep_best(best[name], ask(request));
    }
  }
  if (options.stages && best.contains("limpet")) {
    std::fprintf(stderr, ", stages");
    staged = ask({{"what", "limpet"}, {"stages", true}});
  }
  std::fprintf(stderr, "\n");

  double limpet_ns = 0, floor_ns = 0;
  const auto own = std::find_if(options.contestants.begin(), options.contestants.end(),
                                [](const std::string& name) { return is_own(requests().at(name)["what"]); });
  if (own != options.contestants.end() && !best[*own].contains("failed")) {
    const Json& a = best[*own];
    limpet_ns = 1e9 * a["seconds"].get<double>() / a["points"].get<double>();
    floor_ns = 1e9 * a["floor_seconds"].get<double>() / a["points"].get<double>();
  }
  for (const auto& name : options.contestants)
    add_contestant(spec, cloud.answer(), name, best[name], limpet_ns, floor_ns, tables.contestants);
  if (!staged.is_null()) add_stages(spec, best["limpet"], staged, tables.stages);
}

}  // namespace limpet::benchmarks
