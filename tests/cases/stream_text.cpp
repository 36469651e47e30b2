// Copyright the limpet authors. GPL-3.0-or-later.
//
// Stream cases as text, and smaller ones.
#include <algorithm>
#include <cmath>

#include "stream_case.hpp"

namespace limpet::cases {
namespace {

using model::Parameters;
using model::SensorPoint;

/// The parameters by the names they have in a case.
template <class P, class F>
void each_parameter(P& p, F&& f) {
  f("resolution", p.resolution);
  f("angle", p.angle_rad);
  f("noise", p.noise);
  f("noise-per-range", p.noise_per_range);
  f("noise-per-range2", p.noise_per_range2);
  f("quantum", p.input_quantum);
  f("tolerance", p.tolerance);
  f("psi", p.redundancy_count);
  f("phi", p.redundancy_ratio);
}

SensorPoint read_point(const CaseLines& lines) {
  SensorPoint p;
  for (int i = 0; i < 3; ++i) {
    p.position[i] = lines.real(static_cast<std::size_t>(i));
    p.axis[i] = lines.real(static_cast<std::size_t>(i) + 3);
  }
  if (lines.size() > 6) p.range = lines.real(6);
  return p;
}

void read_parameter(const CaseLines& lines, Parameters& parameters) {
  bool known = true;
  if (lines.is("rules"))
    parameters.rules = model::Rules::parse(lines.word(1));
  else if (lines.is("patience"))
    parameters.outlier_patience = lines.whole(1);
  else if (lines.is("open"))
    parameters.neighbours = false;
  else
    known = false;
  each_parameter(parameters, [&](const char* name, double& value) {
    if (lines.is(name)) value = lines.real(1), known = true;
  });
  if (!known) lines.fail("'" + lines.word(0) + "' is no parameter");
}

std::size_t points_of(const StreamCase& c) {
  std::size_t n = 0;
  for (const auto& set : c.sets) n += set.size();
  return n;
}

template <class F>
void add_with(const StreamCase& c, std::vector<StreamCase>& smaller, F&& change) {
  change(smaller.emplace_back(c));
}

void add_fewer(const StreamCase& c, std::vector<StreamCase>& smaller) {
  for (std::size_t n = c.sets.size(); n >= 1; n /= 2)
    for (std::size_t i = 0; i + n <= c.sets.size(); i += n)
      add_with(c, smaller, [&](StreamCase& less) {
        less.sets.erase(less.sets.begin() + static_cast<std::ptrdiff_t>(i),
                        less.sets.begin() + static_cast<std::ptrdiff_t>(i + n));
      });
  for (std::size_t k = 0; k < c.sets.size(); ++k)
    for (std::size_t n = c.sets[k].size() / 2; n >= 1; n /= 2)
      for (std::size_t i = 0; i + n <= c.sets[k].size(); i += n)
        add_with(c, smaller, [&](StreamCase& less) {
          auto& set = less.sets[k];
          set.erase(set.begin() + static_cast<std::ptrdiff_t>(i),
                    set.begin() + static_cast<std::ptrdiff_t>(i + n));
        });
}

/// The same with shorter numbers, or plainer parameters.
void add_plainer(const StreamCase& c, std::vector<StreamCase>& smaller) {
  for (const double per_unit : {1.0, 8.0, 64.0, 1024.0})
    add_with(c, smaller, [&](StreamCase& other) {
      bool changed = false;
      for (auto& set : other.sets)
        for (auto& p : set)
          for (int i = 0; i < 3; ++i) {
            const double unit = c.parameters.resolution / per_unit;
            const double rounded = std::floor(p.position[i] / unit + 0.5) * unit;
            changed |= rounded != p.position[i];
            p.position[i] = rounded;
          }
      if (!changed) smaller.pop_back();
    });
  const Parameters plain;
  if (c.parameters.rules.to_string() != plain.rules.to_string())
    add_with(c, smaller, [&](StreamCase& other) { other.parameters.rules = plain.rules; });
  if (c.parameters.noise != 0) add_with(c, smaller, [&](StreamCase& other) { other.parameters.noise = 0; });
  if (c.parameters.angle_rad != plain.angle_rad)
    add_with(c, smaller, [&](StreamCase& other) { other.parameters.angle_rad = plain.angle_rad; });
}

}  // namespace

std::string to_text(const StreamCase& c) {
  const Parameters plain;
  std::string text = std::string(kCaseMagic) + StreamCase::kKind + "\n";
  if (!c.law.empty()) text += "law " + c.law + "\n";
  Parameters defaults;
  std::vector<double> usual;
  each_parameter(defaults, [&](const char*, double value) { usual.push_back(value); });
  std::size_t i = 0;
  each_parameter(c.parameters, [&](const char* name, double value) {
    if (value != usual[i++]) text += std::string(name) + " " + shown(value) + "\n";
  });
  if (c.parameters.outlier_patience != plain.outlier_patience)
    text += "patience " + std::to_string(c.parameters.outlier_patience) + "\n";
  if (!c.parameters.neighbours) text += "open\n";
  if (c.parameters.rules.to_string() != plain.rules.to_string())
    text += "rules " + c.parameters.rules.to_string() + "\n";
  for (const auto& set : c.sets) {
    text += "set\n";
    for (const SensorPoint& p : set) {
      for (int k = 0; k < 6; ++k) text += (k ? " " : "") + shown(k < 3 ? p.position[k] : p.axis[k - 3]);
      if (p.range != 0) text += " " + shown(p.range);
      text += "\n";
    }
  }
  return text;
}

StreamCase stream_case(std::string_view text) {
  StreamCase c;
  CaseLines lines(text);
  if (!lines.next() || !lines.is("limpet") || lines.word(2) != StreamCase::kKind)
    lines.fail("no stream case");
  while (lines.next()) {
    if (lines.is("set"))
      c.sets.emplace_back();
    else if (lines.is("law"))
      c.law = lines.word(1);
    else if (!c.sets.empty())
      c.sets.back().push_back(read_point(lines));
    else
      read_parameter(lines, c.parameters);
  }
  return c;
}

std::vector<StreamCase> reductions(const StreamCase& c) {
  std::vector<StreamCase> smaller;
  add_fewer(c, smaller);
  std::stable_sort(smaller.begin(), smaller.end(),
                   [](const auto& a, const auto& b) { return points_of(a) < points_of(b); });
  add_plainer(c, smaller);
  return smaller;
}

}  // namespace limpet::cases
