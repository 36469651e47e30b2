// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "contestants.hpp"
#include "hostile_cloud.hpp"
#include "latencies.hpp"
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

using model::StageTimes;

struct Stage {
  const char* name;
  double StageTimes::*seconds;
};
constexpr std::array kStages{
    Stage{"insertion", &StageTimes::insertion}, Stage{"dissolving", &StageTimes::dissolving},
    Stage{"mergers", &StageTimes::mergers},     Stage{"fissures", &StageTimes::fissures},
    Stage{"sharing", &StageTimes::sharing},     Stage{"rest", &StageTimes::rest}};

/// What each stage took, in processor time: the stage clock, which goes on while others have the processor,
/// only divides a set's time.
class StagesOfSets {
 public:
  void add(const StageTimes& now, double cpu_seconds) {
    double all = 0;
    for (const Stage& s : kStages) all += now.*s.seconds - before_.*s.seconds;
    for (std::size_t i = 0; i < kStages.size() && all > 0; ++i) {
      const auto of = kStages[i].seconds;
      const double seconds = (now.*of - before_.*of) / all * cpu_seconds;
      total_[i] += seconds;
      worst_[i] = std::max(worst_[i], seconds);
      if (cpu_seconds > 0.001) over_[i] += seconds;
    }
    before_ = now;
  }

  Json summary() const {
    Json stages;
    for (std::size_t i = 0; i < kStages.size(); ++i)
      stages[kStages[i].name] = {{"total", total_[i]}, {"worst", worst_[i]}, {"over", over_[i]}};
    return stages;
  }

 private:
  StageTimes before_;
  std::array<double, kStages.size()> total_{}, worst_{}, over_{};
};

std::size_t edges_of_largest(const model::ModelRecord& record) {
  std::size_t most = 0;
  for (const auto& polygon : record.polygon_segments) {
    std::size_t edges = 0;
    for (const auto& cycle : polygon.cycles) edges += cycle.size();
    most = std::max(most, edges);
  }
  return most;
}

/// Sizes of one shape, ascending; as many, but larger ones, in full.
struct Family {
  const char* name;
  std::vector<HostileSpec> sizes, more;
};

std::vector<Family> families() {
  return {{"holes", {{"holes:1024"}, {"holes:2025"}, {"holes:4096"}}, {{"holes:8100"}, {"holes:16384"}}},
          {"combs", {{"combs:16"}, {"combs:24"}, {"combs:32"}}, {{"combs:48"}, {"combs:64"}}},
          {"planes", {{"planes:10"}, {"planes:20"}, {"planes:40"}}, {{"planes:80"}}},
          {"noise", {{"noise:20000"}, {"noise:40000"}, {"noise:80000"}}, {{"noise:160000"}}},
          {"city:200",
           {{"city:200", 125'000}, {"city:200", 250'000}, {"city:200", 500'000}},
           {{"city:200", 1'000'000}}}};
}

/// The slope of the line of best fit through the logarithms, if there are any.
std::optional<double> exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(y[i] > 0)) return std::nullopt;
    const double p = std::log(x[i]), q = std::log(y[i]);
    n += 1, sx += p, sy += q, sxx += p * p, sxy += p * q;
  }
  if (n < 2) return std::nullopt;
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Json or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

/// How one stage of a family grows with the number of points; `name` "all" for all of them together.
void add_growth(const std::string& family, const std::string& name, const std::vector<Json>& answers,
                Table& growth) {
  std::vector<double> points, total, worst;
  for (const Json& a : answers) {
    points.push_back(a["points"]);
    if (name == "all") {
      double all = 0;
      for (const Json& stage : a["stages"]) all += stage["total"].get<double>();
      total.push_back(all);
      worst.push_back(1e-6 * a["times"]["worst"].get<double>());
    } else {
      total.push_back(a["stages"][name]["total"]);
      worst.push_back(a["stages"][name]["worst"]);
    }
  }
  growth.add({family, name, total.back(), or_null(exponent(points, total)), 1e3 * worst.back(),
              or_null(exponent(points, worst))});
}

void add_times(const std::string& shape, const Json& a, Table& times) {
  double all = 0, most = 0;
  std::string stage;
  for (const auto& [name, seconds] : a["stages"].items()) {
    const double over = seconds["over"];
    all += over;
    if (over > most) most = over, stage = name;
  }
  const Json& t = a["times"];
  const double sets = t["sets"];
  times.add({shape,
             a["points"],
             t["sets"],
             a["polygons"],
             a["largest_edges"],
             t["median"],
             t["q99"],
             t["q999"],
             1e-3 * t["worst"].get<double>(),
             100 * t["over_a_millisecond"].get<double>() / sets,
             all > 0 ? Json(stage) : Json(),
             all > 0 ? Json(100 * most / all) : Json(),
             {}});
}

}  // namespace

HostileTables::HostileTables()
    : times({{"shape"},
             {"points"},
             {"sets"},
             {"polygons"},
             {"edges_of_largest"},
             {"median_us", 3},
             {"q99_us", 3},
             {"q99.9_us", 3},
             {"worst_ms", 3},
             {"over_1_ms_%", 3},
             {"there_most_of_it_in"},
             {"of_it_%", 2},
             {"note"}}),
      growth({{"shape"},
              {"stage"},
              {"seconds", 3},
              {"seconds_grow_by", 2},
              {"worst_ms", 3},
              {"worst_grows_by", 2}}) {}

Json answer_hostile(const Json& request) {
  const HostileCloud cloud = hostile_cloud(request.at("spec").get<HostileSpec>());
  model::Model model(cloud.parameters);
  model.measure_stages();
  Latencies times;
  StagesOfSets stages;
  std::vector<model::SensorPoint> set;
  cloud.scan([&](const model::SensorPoint& p) {
    set.push_back(p);
    if (set.size() < kSet) return;
    const CpuWatch watch;
    model.update(set);
    const double seconds = watch.seconds();
    times.add(seconds);
    stages.add(model.stage_times(), seconds);
    set.clear();
  });
  const auto counts = model.counts();
  return {{"points", counts.points},
          {"polygons", counts.polygons},
          {"largest_edges", edges_of_largest(model.record())},
          {"times", times.summary()},
          {"stages", stages.summary()}};
}

HostileTables measure_hostile(const HostileOptions& options, const Limits& limits) {
  HostileTables tables;
  for (const Family& family : families()) {
    const std::string name = family.name;
    if (std::find(options.shapes.begin(), options.shapes.end(), name) == options.shapes.end()) continue;
    std::vector<HostileSpec> sizes = family.sizes;
    if (options.full) sizes.insert(sizes.end(), family.more.begin(), family.more.end());
    std::vector<Json> answers;
    for (const HostileSpec& spec : sizes) {
      std::fprintf(stderr, "hostile, %s\n", spec.shape.c_str());
      const Json answer = ask_process({{"what", "hostile"}, {"spec", spec}}, limits.own_seconds);
      if (answer.contains("failed")) {
        tables.times.add({spec.shape, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, answer["failed"]});
        continue;
      }
      add_times(spec.shape, answer, tables.times);
      answers.push_back(answer);
    }
    if (answers.size() < 2) continue;
    for (const Stage& stage : kStages) add_growth(name, stage.name, answers, tables.growth);
    add_growth(name, "all", answers, tables.growth);
  }
  return tables;
}

}  // namespace limpet::benchmarks
