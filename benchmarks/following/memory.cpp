// Copyright the limpet authors. GPL-3.0-or-later.
//
// A run that has come to its end goes on, over its own path to and fro, with new noise in every reading. What
// model and follower hold must then depend on the surface, and not on the number of sets.
#include <malloc.h>

#include <cstdlib>

#include <limpet/app/follow_run.hpp>
#include <limpet/app/follow_setup.hpp>

#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

/// Beyond what a run of 10⁵ sets takes.
constexpr double kLimitSeconds = 7200;

/// Blocks that malloc keeps at hand for a thread count as allocated, whoever needed them last: it must keep
/// none.
constexpr const char* kNoneKept = "glibc.malloc.tcache_count=0";

/// What calls have left allocated, bytes. One thread.
class Ledger {
 public:
  template <class Call>
  auto book(Call&& call) {
    const std::int64_t before = allocated();
    auto result = call();
    bytes_ += allocated() - before;
    return result;
  }
  double megabytes() const { return 1e-6 * static_cast<double>(bytes_); }

 private:
  static std::int64_t allocated() {
    const struct mallinfo2 info = ::mallinfo2();
    return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
  }
  std::int64_t bytes_ = 0;
};

std::vector<Eigen::Vector3d> path_of_run(const app::FollowSetup& setup) {
  app::FollowRun run(setup);
  return run.go([](const app::FollowStep&) {}).path;
}

/// To and fro: 0 1 2 3 2 1 0 1 …
std::size_t to_and_fro(std::int64_t step, std::size_t places) {
  if (places < 2) return 0;
  const std::size_t at = static_cast<std::size_t>(step) % (2 * (places - 1));
  return at < places ? at : 2 * (places - 1) - at;
}

class EndlessRun {
 public:
  explicit EndlessRun(const app::FollowSetup& setup)
      : setup_(setup),
        path_(path_of_run(setup)),
        model_(model_bytes_.book([&] { return model::Model(setup.model); })),
        follower_(
            follower_bytes_.book([&] { return following::make_follower(setup.strategy, setup.following); })),
        sensing_(*setup.world.world, setup.errors) {}

  std::int64_t sets_of_run() const { return std::ssize(path_); }

  void step(std::int64_t set) {
    const kinematics::Configuration at = path_[to_and_fro(set, path_.size())];
    const simulation::Sensed sensed = sensing_.sense(setup_.robot, at);
    const kinematics::Posture posture(setup_.robot, sensed.measured);
    const auto* changes = model_bytes_.book([&] { return &model_.update(sensed.points); });
    follower_bytes_.book([&] { return follower_->next({model_, *changes, posture, sensed.points}); });
  }

  Json look(std::int64_t sets) const {
    ::malloc_trim(0);
    const model::Counts counts = model_.counts();
    return {{"sets", sets},
            {"points", counts.points},
            {"polygons", counts.polygons},
            {"edges", counts.edges},
            {"model_MB", model_bytes_.megabytes()},
            {"state_MB", 1e-6 * static_cast<double>(model_.state().size())},
            {"follower_MB", follower_bytes_.megabytes()},
            {"resident_MB", resident_megabytes()}};
  }

 private:
  const app::FollowSetup& setup_;
  std::vector<Eigen::Vector3d> path_;
  Ledger model_bytes_, follower_bytes_;
  model::Model model_;
  std::unique_ptr<following::Follower> follower_;
  simulation::Sensing sensing_;
};

}  // namespace

Json answer_memory(const Json& request) {
  const RunCase wanted = request.at("case");
  const std::int64_t sets = request.at("sets"), every = request.at("every");
  const app::FollowSetup setup = app::make_setup(app::parse_scene(wanted.scene, wanted.name));
  EndlessRun run(setup);
  Json marks = Json::array();
  for (std::int64_t set = 0; set < sets; ++set) {
    run.step(set);
    if ((set + 1) % every == 0 || set + 1 == run.sets_of_run()) {
      marks.push_back(run.look(set + 1));
      tell_so_far({{"sets_of_run", run.sets_of_run()}, {"marks", marks}});
    }
  }
  return {{"sets_of_run", run.sets_of_run()}, {"marks", marks}};
}

Measured measure_memory(const RunPlan& plan, const MemoryOptions& options) {
  ::setenv("GLIBC_TUNABLES", kNoneKept, 1);  // for the process that measures
  RunPlan once = plan;
  once.starts = 1;
  Table table({{"world"},
               {"sets"},
               {"points"},
               {"polygons"},
               {"edges"},
               {"model_MB"},
               {"state_MB"},
               {"follower_MB"},
               {"resident_MB"}});
  for (const std::string& world : options.worlds) {
    std::vector<RunCase> cases;
    add_runs(once, world, scene_of(once, world), cases);
    Json told = ask_process(
        {{"what", "memory"}, {"case", cases.front()}, {"sets", options.sets}, {"every", options.every}},
        kLimitSeconds);
    if (told.contains("failed")) {
      table.add({world + ": " + told.at("failed").get<std::string>(), Json(), Json(), Json(), Json(), Json(),
                 Json(), Json(), Json()});
      told = told.at("so_far");
    }
    if (!told.contains("marks")) continue;
    for (const Json& mark : told.at("marks"))
      table.add({mark.at("sets") == told.at("sets_of_run") ? world + " (end of the run)" : world,
                 mark.at("sets"), mark.at("points"), mark.at("polygons"), mark.at("edges"),
                 mark.at("model_MB"), mark.at("state_MB"), mark.at("follower_MB"), mark.at("resident_MB")});
  }
  Measured measured;
  measured.tables.push_back(
      {"Memory of a run that goes on (" + plan.strategy + ", " + seeds_text(once) + ")", table});
  return measured;
}

}  // namespace limpet::benchmarks
