// Copyright the limpet authors. GPL-3.0-or-later.
#include "varied.hpp"

namespace limpet::benchmarks {
namespace {

Variation row(const std::string& what, const std::string& value, std::function<void(SceneText&)> change) {
  return {what, value, {}, std::move(change)};
}

/// What is wrong, and how much of it.
Variation error(const std::string& what, const std::string& value, const std::string& key,
                const std::string& toml) {
  return row(what, value, [key, toml](SceneText& scene) { scene.set_text("errors", key, toml); });
}

/// The model is told another noise than the readings have.
Variation told_noise(const RunPlan& plan, const std::string& value, double factor) {
  return row("noise given", value,
             [&plan, factor](SceneText& scene) { scene.set("parameters", "noise", factor * plan.noise); });
}

}  // namespace

Measured measure_faults(const RunPlan& plan, const VariedOptions& options) {
  const auto in_lambda = [&plan](double times) { return Json(times * plan.resolution).dump(); };
  // Along a cube's edge direction; it says that there is surface at the follow distance, always.
  const std::string stuck = "[{ sensor = 7, distance = " + in_lambda(2) + " }]";
  const std::string stuck_near = "[{ sensor = 7, distance = " + in_lambda(0.5) + " }]";
  return measure_varied(
      plan, options,
      {row("none", "", [](SceneText&) {}), error("drop-outs", "5 %", "dropouts", "0.05"),
       error("outliers", "1 %", "outliers", "0.01"), error("stuck sensor", "at δ", "stuck", stuck),
       error("stuck sensor", "at λ/2", "stuck", stuck_near),
       error("encoder noise", "0.2 λ", "encoder_noise", in_lambda(0.2)), told_noise(plan, "half of it", 0.5),
       told_noise(plan, "twice of it", 2)},
      "Faults of the sensors");
}

}  // namespace limpet::benchmarks
