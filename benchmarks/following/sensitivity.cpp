// Copyright the limpet authors. GPL-3.0-or-later.
//
// Thesis §4.3 says of each parameter what happens when it is too small or too large; this measures it.
#include <cmath>

#include "varied.hpp"

namespace limpet::benchmarks {
namespace {

constexpr double kFactors[] = {0.5, 0.70710678118654752, 1.4142135623730951, 2};
constexpr const char* kFactorNames[] = {"1/2", "1/√2", "√2", "2"};

/// The usual values (thesis §4.3), in a run of this resolution.
struct Usual {
  explicit Usual(const RunPlan& plan) : resolution(plan.resolution), noise(plan.noise) {}

  double resolution, noise;
  double follow_distance = 2 * resolution, step = 2 * resolution, ceiling = resolution;
  double range = 4 * resolution, stray = range;
  double angle = 10, period = 10, psi = 20, phi = 0.05;
};

/// All lengths of a scene, so that what is not varied stays when λ is.
void set_usual(const Usual& u, SceneText& scene) {
  scene.set("parameters", "follow_distance", u.follow_distance)
      .set("parameters", "step", u.step)
      .set("parameters", "stray", u.stray)
      .set("robot", "ceiling", u.ceiling)
      .set("robot", "sensing_range", u.range);
}

/// Which relation forbids these values; empty: none.
std::string broken_relation(const Usual& u) {
  const double rounding = 1 - 1e-12;
  if (u.follow_distance * rounding <= u.resolution) return "must exceed λ";
  if (u.follow_distance >= u.range * rounding) return "δ must be below the range";
  if (u.step >= u.range * rounding) return "must be below the range";
  if (u.stray * rounding <= u.follow_distance) return "ρ must exceed δ";
  return {};
}

Variation with(const std::string& what, const std::string& value, const Usual& u) {
  return {what, value, broken_relation(u), [u](SceneText& scene) {
            set_usual(u, scene);
            scene.set("parameters", "resolution", u.resolution)
                .set("parameters", "angle", u.angle)
                .set_text("parameters", "period", std::to_string(std::lround(u.period)))
                .set_text("parameters", "redundancy", Json({u.psi, u.phi}).dump())
                .set("errors", "noise", u.noise);
          }};
}

void vary(const std::string& what, const Usual& usual, double Usual::*parameter,
          std::vector<Variation>& rows) {
  for (int i = 0; i < 4; ++i) {
    Usual varied = usual;
    varied.*parameter *= kFactors[i];
    rows.push_back(with(what, kFactorNames[i], varied));
  }
}

/// λ with the lengths that follow from it, as --resolution has it.
void vary_all_lengths(const RunPlan& plan, std::vector<Variation>& rows) {
  for (int i = 0; i < 4; ++i) {
    RunPlan scaled = plan;
    scaled.resolution *= kFactors[i];
    rows.push_back(with("λ with all lengths", kFactorNames[i], Usual(scaled)));
  }
}

}  // namespace

Measured measure_sensitivity(const RunPlan& plan, const VariedOptions& options) {
  const Usual usual(plan);
  Usual far = usual;  // so that σ_max, and not γ, is what cuts a motion
  far.ceiling = 0.9 * usual.range;
  std::vector<Variation> rows{with("usual", "1", usual)};
  vary_all_lengths(plan, rows);
  vary("λ alone", usual, &Usual::resolution, rows);
  vary("μ", usual, &Usual::angle, rows);
  vary("δ", usual, &Usual::follow_distance, rows);
  vary("σ_max", usual, &Usual::step, rows);
  rows.push_back(with("σ_max at γ 3.6 λ", "1", far));
  vary("σ_max at γ 3.6 λ", far, &Usual::step, rows);
  vary("γ", usual, &Usual::ceiling, rows);
  vary("ρ", usual, &Usual::stray, rows);
  vary("τ", usual, &Usual::period, rows);
  vary("ψ", usual, &Usual::psi, rows);
  vary("φ", usual, &Usual::phi, rows);
  vary("noise", usual, &Usual::noise, rows);
  return measure_varied(plan, options, rows, "Sensitivity");
}

}  // namespace limpet::benchmarks
