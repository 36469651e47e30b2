// Copyright the limpet authors. GPL-3.0-or-later.
#include "run_case.hpp"

#include <filesystem>

#include <limpet/simulation/shapes.hpp>

namespace limpet::benchmarks {

std::string quoted(const std::string& text) { return Json(text).dump(); }

SceneText& SceneText::set(const std::string& section, const std::string& key, double value) {
  return set_text(section, key, Json(value).dump());
}

SceneText& SceneText::set_text(const std::string& section, const std::string& key, const std::string& value) {
  sections_[section][key] = value;
  return *this;
}

std::string SceneText::toml() const {
  std::string text;
  for (const auto& [section, keys] : sections_) {
    if (!section.empty()) text.append("[").append(section).append("]\n");
    for (const auto& [key, value] : keys) text.append(key).append(" = ").append(value).append("\n");
  }
  return text;
}

SceneText scene_of(const RunPlan& plan, const std::string& shape_or_mesh) {
  SceneText scene;
  if (simulation::is_shape(shape_or_mesh))
    scene.set_text("world", "shape", quoted(shape_or_mesh));
  else
    scene.set_text("world", "mesh", quoted(std::filesystem::absolute(shape_or_mesh).string()));
  scene.set_text("", "strategy", quoted(plan.strategy));
  scene.set_text("", "max_sets", std::to_string(plan.max_sets));
  scene.set_text("robot", "heading", quoted("random"));
  scene.set("errors", "noise", plan.noise);
  if (plan.resolution > 0) scene.set("parameters", "resolution", plan.resolution);
  return scene;
}

void add_runs(const RunPlan& plan, const std::string& name, const SceneText& scene,
              std::vector<RunCase>& cases) {
  for (int i = 0; i < plan.starts; ++i) {
    const std::uint64_t seed = plan.first_seed + static_cast<std::uint64_t>(i);
    SceneText seeded = scene;
    seeded.set_text("", "seed", std::to_string(seed));
    cases.push_back({name, seeded.toml(), seed, plan.max_seconds, plan.tour, plan.oracle_every});
  }
}

std::string seeds_text(const RunPlan& plan) {
  const std::string first = std::to_string(plan.first_seed);
  if (plan.starts == 1) return "seed " + first;
  return "seeds " + first + " to " +
         std::to_string(plan.first_seed + static_cast<std::uint64_t>(plan.starts) - 1);
}

}  // namespace limpet::benchmarks
