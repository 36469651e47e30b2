// Copyright the limpet authors. GPL-3.0-or-later.
//
// The union step alone, beside Boost.Geometry's.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "builds.hpp"
#include "case_list.hpp"
#include "ratios.hpp"
#include "record.hpp"
#include "union_answers.hpp"

namespace limpet::benchmarks {
namespace {

constexpr std::array kContestants = {"limpet", "limpet-float-grid", "limpet-float", "boost_double",
                                     "boost_long_long"};

struct Pairs {
  std::vector<cases::PerimeterCase> list;
  std::vector<TrueUnion> truth;
};

/// Those whose union is one piece: unite() is for polygons that overlap.
Pairs make_pairs(const Setting& setting, std::size_t count) {
  Pairs pairs;
  for (auto& pair : record_pairs(setting, count, 1)) {
    const TrueUnion truth = true_union(pair);
    if (truth.components != 1) continue;
    pairs.list.push_back(std::move(pair));
    pairs.truth.push_back(truth);
  }
  return pairs;
}

std::vector<std::vector<Json>> ask_all(const std::string& path, std::size_t count, int rounds, int repeats) {
  std::vector<std::vector<Json>> told(kContestants.size());
  const std::string times = std::to_string(repeats);
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < kContestants.size(); ++k) {
      const std::size_t c = (k + static_cast<std::size_t>(round)) % kContestants.size();
      if (c < kBuilds.size())
        replay_once({replay_program(c), "perimeters", path, "--repeats", times}, count, told[c]);
      else
        replay_once(
            {"/proc/self/exe", "boost", path, c == 4 ? "--integers" : "--no-integers", "--repeats", times},
            count, told[c]);
    }
  return told;
}

/// What became of the pairs with one contestant.
struct Tally {
  int no_answer = 0, exceptions = 0, hangs = 0, crashes = 0, invalid = 0, wrong_area = 0, other_law = 0;
  double worst = 0;  ///< largest error of an area beyond what is allowed, as a part of the true area
  std::vector<double> us, ratios;

  int wrong() const { return no_answer + exceptions + hangs + crashes + invalid + wrong_area + other_law; }
};

bool answered(const Json& told) {
  return told.contains("us") && told["outcome"] != "refused" && told["outcome"] != "unfit" &&
         told["law"] != "exception";
}

void tally(const Json& told, const cases::PerimeterCase& pair, const TrueUnion& truth, bool is_boost,
           Tally& t) {
  if (told.contains("ended")) {
    ++(told["ended"] == "hang" ? t.hangs : told["ended"] == "exception" ? t.exceptions : t.crashes);
    return;
  }
  const std::string law = told.value("law", "");
  if (law == "exception") ++t.exceptions;
  if (!answered(told)) {
    t.no_answer += law != "exception";
    return;
  }
  const bool invalid = law == "invalid" || law == "simple" || law == "audit";
  t.invalid += invalid;
  t.other_law += !law.empty() && !invalid && law != "area";
  const double slack = is_boost ? boost_tolerance(pair, truth.area)
                                : limpet_tolerance(pair, told["attempts"].get<std::size_t>());
  const Json& area = told["area"];  // null: not finite
  const double more = (area.is_number() ? area.get<double>() : std::nan("")) - truth.area;
  const double error = std::max(-more, more - (is_boost ? 0 : truth.droppable)) - slack;
  if (!(error <= 0)) {
    ++t.wrong_area;
    t.worst = std::max(t.worst, (error + slack) / truth.area);
  }
}

/// A pair that broke something is kept beside the report.
void keep(const std::string& folder, const std::string& name, const cases::PerimeterCase& pair) {
  std::filesystem::create_directories(folder);
  save_cases(folder + "/" + name + ".case", {pair});
}

void add_rows(const Setting& setting, const PredicatesOptions& options, Table& table) {
  const Pairs pairs = make_pairs(setting, options.full ? 5000 : 400);
  const std::string path = options.scratch + "/pairs.cases";
  save_cases(path, pairs.list);
  const auto told = ask_all(path, pairs.list.size(), options.full ? 5 : 3, options.full ? 10 : 5);
  for (std::size_t c = 0; c < kContestants.size(); ++c) {
    Tally t;
    for (std::size_t i = 0; i < pairs.list.size(); ++i) {
      const int wrong_before = t.wrong();
      tally(told[c][i], pairs.list[i], pairs.truth[i], c >= kBuilds.size(), t);
      if (c == 0 && t.wrong() > wrong_before)
        keep(options.folder + "/found", setting.position() + "_" + setting.regime + "_" + std::to_string(i),
             pairs.list[i]);
      if (!answered(told[c][i]) || told[c][i].contains("ended")) continue;
      t.us.push_back(told[c][i]["us"]);
      if (answered(told[0][i])) t.ratios.push_back(told[0][i]["us"].get<double>() / t.us.back());
    }
    const Spread ratio = spread_of(t.ratios);
    table.add({setting.position(), setting.regime, kContestants[c], pairs.list.size(), spread_of(t.us).median,
               ratio.median, ratio.low, ratio.high, t.no_answer, t.exceptions, t.hangs, t.crashes, t.invalid,
               t.other_law, t.wrong_area, t.worst});
  }
}

}  // namespace

void add_unions(const PredicatesOptions& options, ReportPage& report) {
  Table table({{"position"},
               {"regime"},
               {"contestant"},
               {"pairs"},
               {"us"},
               {"limpet_over_it"},
               {"low"},
               {"high"},
               {"no_answer"},
               {"exceptions"},
               {"hangs"},
               {"crashes"},
               {"invalid"},
               {"other_law"},
               {"wrong_area"},
               {"worst_error", 2}});
  for (const Setting& setting : all_settings()) {
    std::fprintf(stderr, "union: %s, %s\n", setting.position().c_str(), setting.regime.c_str());
    add_rows(setting, options, table);
  }
  report.add(
      "The union step beside Boost.Geometry",
      "The same pairs of overlapping polygons. *us*: median; *limpet over it*: exact limpet's time over "
      "the contestant's, median, and where a tenth is below and above. *Invalid*: by the oracle "
      "(limpet), by Boost's own is_valid (Boost). *Wrong area*: beyond what is allowed from the exact "
      "union's (docs/predicates.md); *worst error*: of those, as a part of the area.",
      table, "unions", true);
}

}  // namespace limpet::benchmarks
