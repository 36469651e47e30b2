// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/noise_law.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limpet/io/text.hpp>
#include <optional>

namespace limpet::survey {
namespace {

constexpr std::size_t kGroups = 10,
                      kGroup = 40;  ///< at most kGroups groups of at least kGroup neighbourhoods
constexpr double kGrazing =
    0.6;  ///< cosine of the incidence below which a surface is seen at a grazing angle
constexpr std::size_t kFewestBands = 3;  ///< of such incidences
constexpr double kSame = 0.12;           ///< relative scatter that estimates of one and the same noise have

/// The median, unless half of the neighbourhoods cross edges of the surface: then an estimate from the flat
/// ones.
double typical(const std::vector<double>& noises) {
  const double low = 1.2 * quantile(noises, 0.2);  // 1.2: the median over the lower fifth's end, 13 degrees
  const double middle = quantile(noises, 0.5);
  return middle > 1.5 * low ? low : middle;
}

double typical(const std::vector<NoiseAt>& found) {
  std::vector<double> noises;
  for (const NoiseAt& one : found) noises.push_back(one.noise);
  return typical(noises);
}

/// One estimate for each of some bands of range, which hold equally many neighbourhoods.
std::vector<NoiseAt> by_range(std::vector<NoiseAt> found) {
  std::sort(found.begin(), found.end(), [](const NoiseAt& a, const NoiseAt& b) {
    return a.range != b.range ? a.range < b.range : a.noise < b.noise;
  });
  const std::size_t groups = std::min(kGroups, found.size() / kGroup);
  std::vector<NoiseAt> result;
  for (std::size_t g = 0; g < groups; ++g) {
    const auto first = found.begin() + static_cast<std::ptrdiff_t>(found.size() * g / groups);
    const auto last = found.begin() + static_cast<std::ptrdiff_t>(found.size() * (g + 1) / groups);
    const std::vector<NoiseAt> group(first, last);
    result.push_back({group[group.size() / 2].range, typical(group)});
  }
  return result;
}

struct Law {
  NoiseLaw noise;
  double misfit = 0;  ///< relative, root of the mean square
};

/// The law of these powers of the range with the least squared relative error; nothing if a coefficient would
/// not be positive.
std::optional<Law> fitted(const std::vector<NoiseAt>& groups, const std::vector<int>& powers) {
  const auto rows = static_cast<Eigen::Index>(groups.size());
  Eigen::MatrixXd terms(rows, static_cast<Eigen::Index>(powers.size()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const NoiseAt& group = groups[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < powers.size(); ++k) {
      const double term = powers[k] == 0 ? 1 : powers[k] == 1 ? group.range : group.range * group.range;
      terms(i, static_cast<Eigen::Index>(k)) = term / group.noise;
    }
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows);
  const Eigen::VectorXd weights = terms.colPivHouseholderQr().solve(ones);
  if (!(weights.minCoeff() > 0)) return std::nullopt;
  Law law;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    double* const coefficients[] = {&law.noise.fixed, &law.noise.per_range, &law.noise.per_range2};
    *coefficients[powers[k]] = weights[static_cast<Eigen::Index>(k)];
  }
  law.misfit = std::sqrt((terms * weights - ones).squaredNorm() / static_cast<double>(rows));
  return law;
}

}  // namespace

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

namespace {

NoiseLaw fit_along_axes(std::vector<NoiseAt> found) {
  const Law constant{{typical(found), 0, 0}, 0};
  const auto groups = by_range(std::move(found));
  const auto known = [](const NoiseAt& group) { return group.range > 0 && group.noise > 0; };
  if (groups.size() < 4 || !std::all_of(groups.begin(), groups.end(), known)) return constant.noise;
  if (groups.back().range < 1.2 * groups.front().range) return constant.noise;
  const auto one_number = fitted(groups, {0});
  if (!one_number || one_number->misfit < kSame) return constant.noise;
  // Of the laws that grow, one with two terms has to be better by a fifth.
  std::optional<Law> best;
  for (const auto& [powers, handicap] : {std::pair{std::vector{1}, 1.0},
                                         {std::vector{2}, 1.0},
                                         {std::vector{0, 1}, 1.2},
                                         {std::vector{0, 2}, 1.2}}) {
    const auto law = fitted(groups, powers);
    if (law && (!best || handicap * law->misfit < best->misfit)) {
      best = law;
      best->misfit *= handicap;
    }
  }
  return best && best->misfit < 0.6 * one_number->misfit ? best->noise : constant.noise;
}

/// By how much readings scatter about surfaces that are seen at a grazing angle, over what the law says of
/// them along their axes: the median of some bands of incidence. 0: too few such surfaces.
double across_when_grazing(std::vector<NoiseAt> found, const NoiseLaw& law) {
  std::erase_if(found, [](const NoiseAt& one) { return one.cosine > kGrazing; });
  std::stable_sort(found.begin(), found.end(),
                   [](const NoiseAt& a, const NoiseAt& b) { return a.cosine < b.cosine; });
  const std::size_t groups = std::min(kGroups, found.size() / kGroup);
  std::vector<double> across;
  for (std::size_t g = 0; g < groups; ++g) {
    std::vector<double> ratios;
    for (std::size_t i = found.size() * g / groups; i < found.size() * (g + 1) / groups; ++i)
      ratios.push_back(found[i].noise * found[i].cosine / law.at(found[i].range));
    across.push_back(typical(ratios));
  }
  std::sort(across.begin(), across.end());
  return across.size() < kFewestBands ? 0 : across[across.size() / 2];
}

}  // namespace

NoiseLaw fit_noise_law(const std::vector<NoiseAt>& found) {
  const NoiseLaw along = fit_along_axes(found);
  if (!(along.at(0) > 0) && !along.varies()) return along;
  const double across = across_when_grazing(found, along);
  if (!(across > 1 + 2 * kSame)) return along;
  return {across * along.fixed, across * along.per_range, across * along.per_range2};
}

std::string short_text(const NoiseLaw& noise) {
  std::string text = io::short_text(noise.fixed);
  if (noise.varies()) text += "," + io::short_text(noise.per_range);
  if (noise.per_range2 > 0) text += "," + io::short_text(noise.per_range2);
  return text;
}

}  // namespace limpet::survey
