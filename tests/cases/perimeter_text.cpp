// Copyright the limpet authors. GPL-3.0-or-later.
//
// Perimeter cases as text, and smaller ones.
#include <algorithm>
#include <cmath>

#include "perimeter_case.hpp"

namespace limpet::cases {
namespace {

/// One line a cycle; a star behind a vertex: the edge that leaves it is shared.
void add_cycles(std::string& text, const Cycles& cycles) {
  for (const auto& cycle : cycles) {
    text += "cycle";
    for (const NewVertex& v : cycle)
      text += " " + shown(v.at.x) + " " + shown(v.at.y) + (v.shared ? " *" : "");
    text += "\n";
  }
}

Cycles read_cycles(CaseLines& lines) {
  Cycles cycles;
  while (lines.next()) {
    if (!lines.is("cycle")) {
      lines.back();
      break;
    }
    auto& cycle = cycles.emplace_back();
    for (std::size_t i = 1; i < lines.size();) {
      if (lines.word(i) == "*" && !cycle.empty()) {
        cycle.back().shared = true;
        ++i;
        continue;
      }
      cycle.push_back({{lines.real(i), lines.real(i + 1)}});
      i += 2;
    }
  }
  if (cycles.empty()) lines.fail("a cycle is missing");
  return cycles;
}

Step read_step(CaseLines& lines) {
  Step step;
  const auto name = std::find(kOperations.begin(), kOperations.end(), lines.word(0));
  if (name == kOperations.end()) lines.fail("'" + lines.word(0) + "' is no operation");
  step.operation = static_cast<Operation>(name - kOperations.begin());
  if (step.operation == Operation::extend) step.q = {lines.real(1), lines.real(2)};
  if (step.operation == Operation::fill) step.all_fresh = lines.size() > 1 && lines.word(1) == "all";
  if (step.operation == Operation::merge || step.operation == Operation::unite)
    step.other = read_cycles(lines);
  return step;
}

template <class F>
void each_cycle_list(PerimeterCase& c, F&& f) {
  f(c.start);
  for (Step& s : c.steps)
    if (!s.other.empty()) f(s.other);
}

std::size_t vertices(const PerimeterCase& c) {
  std::size_t n = 0;
  PerimeterCase copy = c;
  each_cycle_list(copy, [&](Cycles& cycles) {
    for (const auto& cycle : cycles) n += cycle.size();
  });
  return n;
}

void add_without_steps(const PerimeterCase& c, std::vector<PerimeterCase>& smaller) {
  for (std::size_t n = c.steps.size(); n >= 1; n /= 2)
    for (std::size_t i = 0; i + n <= c.steps.size(); i += n) {
      PerimeterCase& less = smaller.emplace_back(c);
      less.steps.erase(less.steps.begin() + static_cast<std::ptrdiff_t>(i),
                       less.steps.begin() + static_cast<std::ptrdiff_t>(i + n));
    }
}

void add_without_vertices(const PerimeterCase& c, std::vector<PerimeterCase>& smaller) {
  const std::size_t lists = 1 + c.steps.size();
  for (std::size_t list = 0; list < lists; ++list) {
    const auto pick = [&](PerimeterCase& of) -> Cycles& {
      return list == 0 ? of.start : of.steps[list - 1].other;
    };
    PerimeterCase copy = c;
    const Cycles& whole = pick(copy);
    for (std::size_t k = 0; k < whole.size(); ++k) {
      if (k > 0) {
        auto& cycles = pick(smaller.emplace_back(c));
        cycles.erase(cycles.begin() + static_cast<std::ptrdiff_t>(k));
      }
      for (std::size_t n = whole[k].size() / 2; n >= 1; n /= 2)
        for (std::size_t i = 0; i + n <= whole[k].size() && whole[k].size() >= n + 3; i += n) {
          auto& cycle = pick(smaller.emplace_back(c))[k];
          cycle.erase(cycle.begin() + static_cast<std::ptrdiff_t>(i),
                      cycle.begin() + static_cast<std::ptrdiff_t>(i + n));
        }
    }
  }
}

/// The same, moved to the origin or drawn together.
void add_nearer(const PerimeterCase& c, std::vector<PerimeterCase>& smaller) {
  const auto mapped = [&](auto&& map) {
    PerimeterCase& other = smaller.emplace_back(c);
    each_cycle_list(other, [&](Cycles& cycles) {
      for (auto& cycle : cycles)
        for (NewVertex& v : cycle) v.at = map(v.at);
    });
    for (Step& s : other.steps) s.q = map(s.q);
  };
  const Point2 first = c.start[0][0].at;
  if (first.x != 0 || first.y != 0) mapped([&](Point2 p) { return p - first; });
  mapped([](Point2 p) { return Point2{std::floor(p.x / 2), std::floor(p.y / 2)}; });
  smaller.back().gap = std::max(2.0, std::floor(c.gap / 2));
}

}  // namespace

std::string to_text(const PerimeterCase& c) {
  std::string text = std::string(kCaseMagic) + PerimeterCase::kKind + "\n";
  if (!c.law.empty()) text += "law " + c.law + "\n";
  text += "tolerance " + shown(c.area_tolerance) + " " + shown(c.step_tolerance) + "\n";
  text += "gap " + shown(c.gap) + "\npolygon\n";
  add_cycles(text, c.start);
  for (const Step& s : c.steps) {
    text += kOperations[static_cast<std::size_t>(s.operation)];
    if (s.operation == Operation::extend) text += " " + shown(s.q.x) + " " + shown(s.q.y);
    if (s.operation == Operation::fill) text += s.all_fresh ? " all" : " new";
    text += "\n";
    if (s.operation == Operation::merge || s.operation == Operation::unite) add_cycles(text, s.other);
  }
  return text;
}

PerimeterCase perimeter_case(std::string_view text) {
  PerimeterCase c;
  CaseLines lines(text);
  if (!lines.next() || !lines.is("limpet") || lines.word(2) != PerimeterCase::kKind)
    lines.fail("no perimeter case");
  while (lines.next()) {
    if (lines.is("law"))
      c.law = lines.word(1);
    else if (lines.is("tolerance"))
      c.area_tolerance = lines.real(1), c.step_tolerance = lines.real(2);
    else if (lines.is("gap"))
      c.gap = lines.real(1);
    else if (lines.is("polygon"))
      c.start = read_cycles(lines);
    else
      c.steps.push_back(read_step(lines));
  }
  if (c.start.empty()) lines.fail("the polygon is missing");
  return c;
}

std::vector<PerimeterCase> reductions(const PerimeterCase& c) {
  std::vector<PerimeterCase> smaller;
  add_without_steps(c, smaller);
  add_without_vertices(c, smaller);
  std::stable_sort(smaller.begin(), smaller.end(), [](const auto& a, const auto& b) {
    return a.steps.size() * 4 + vertices(a) < b.steps.size() * 4 + vertices(b);
  });
  add_nearer(c, smaller);
  return smaller;
}

}  // namespace limpet::cases
