// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/choose.hpp>

#include <limpet/io/text.hpp>
#include <limpet/survey/orientation.hpp>

namespace limpet::survey {
namespace {

constexpr std::int64_t kLookAhead = 2'000'000;

/// What the scan tells about itself. The scan is gone through when this is first asked for, and only then.
class LookAhead {
 public:
  explicit LookAhead(PointStream& points) : points_(points) {}

  const Estimate& estimate() {
    if (!found_) found_ = survey::estimate([&](const Take& take) { points_.look_ahead(kLookAhead, take); });
    return *found_;
  }
  const std::optional<Estimate>& found() const { return found_; }
  /// How many points the scan has; -1: not known.
  std::int64_t count() const {
    return found_ && found_->points < kLookAhead ? found_->points : points_.promised();
  }

 private:
  PointStream& points_;
  std::optional<Estimate> found_;
};

/// A damaged scan may have few points because of its damage; then the damage is what has to be reported.
[[noreturn]] void refuse_few_points(PointStream& points) {
  for (Reading reading; points.next(reading);) {
  }
  if (!points.damage().empty()) throw io::InputError(points.damage());
  throw TooFewPoints(points.name(), "too few points lie on a surface to choose a resolution; give one");
}

ResolutionLaw rounded(const ResolutionLaw& resolution) {
  return {io::short_number(resolution.fixed), io::short_number(resolution.per_range)};
}

NoiseLaw rounded(const NoiseLaw& noise) {
  return {io::short_number(noise.fixed), io::short_number(noise.per_range),
          io::short_number(noise.per_range2)};
}

void set_noise(model::Parameters& parameters, const NoiseLaw& noise) {
  parameters.noise = noise.fixed;
  parameters.noise_per_range = noise.per_range;
  parameters.noise_per_range2 = noise.per_range2;
}

std::string resolution_reason(const Choice& choice) {
  if (choice.known.resolution || !choice.estimate) return "given";
  if (resolution_of(choice.parameters).varies())
    return "by the space between points, which grows with the range";
  const NoiseLaw noise = choice.known.noise ? *choice.known.noise : rounded(choice.estimate->noise);
  const ResolutionBounds bounds = resolution_bounds(*choice.estimate, noise);
  if (bounds.largest() == bounds.noise) return "ten times the least noise, or five times the greatest";
  if (bounds.largest() == bounds.density)
    return "five points per square of it, with an area of " +
           io::short_text(choice.estimate->area_per_point) + " a point";
  return "three points per square of it where the scan is sparse";
}

std::string noise_reason(const Choice& choice) {
  if (choice.known.noise) return "given";
  if (noise_of(choice.parameters).fixed > rounded(choice.estimate->noise).fixed)
    return "scatter about planes as wide as the facets of a curved surface";
  return noise_of(choice.parameters).varies() ? "scatter about planes, which grows with the range"
                                              : "scatter about planes, the same at all ranges";
}

std::string tolerance_reason(const Choice& choice) {
  if (choice.known.tolerance) return "given";
  return choice.parameters.tolerance > io::short_number(choice.near_resolution / 5)
             ? "three times the noise, where it is greatest"
             : "a fifth of the resolution";
}

}  // namespace

void require_points(PointStream& points) {
  if (points.first() != nullptr) return;
  if (!points.damage().empty()) throw io::InputError(points.damage());
  const std::string none =
      points.skipped() > 0 ? " (" + io::grouped(points.skipped()) + " records are none)" : "";
  throw io::InputError(points.name(), "holds no point" + none);
}

Choice choose(PointStream& points, const Known& known) {
  require_points(points);
  if (known.noise && known.noise->varies() && points.first()->point.range == 0)
    throw io::InputError(points.name(),
                         "does not say from how far its points were sensed; give the noise as one number");
  LookAhead ahead(points);
  Choice choice;
  choice.known = known;
  choice.parameters = known.others;
  const NoiseLaw measured = known.noise ? *known.noise : rounded(ahead.estimate().noise);
  if (known.resolution && known.resolution->varies() && points.first()->point.range == 0)
    throw io::InputError(
        points.name(), "does not say from how far its points were sensed; give the resolution as one number");
  if (!known.resolution && !(ahead.estimate().area_per_point > 0)) refuse_few_points(points);
  const ResolutionLaw resolution =
      known.resolution ? *known.resolution : rounded(suitable_resolution(ahead.estimate(), measured));
  choice.parameters.resolution = resolution.fixed;
  choice.parameters.resolution_per_range = resolution.per_range;
  if (resolution.varies()) choice.parameters.sensors = ahead.estimate().sensors;
  choice.near_resolution =
      resolution.varies() ? resolution.at(ahead.estimate().near_range) : resolution.fixed;
  const NoiseLaw noise =
      known.noise ? measured : rounded(facet_noise(ahead.estimate(), measured, choice.near_resolution));
  set_noise(choice.parameters, noise);
  if (known.tolerance) {
    choice.parameters.tolerance = *known.tolerance;
  } else {
    const double far_noise = noise.varies() ? noise.at(ahead.estimate().far_range) : noise.fixed;
    choice.parameters.tolerance = io::short_number(suitable_tolerance(far_noise, choice.near_resolution));
  }
  if (!points.has_axes()) {
    const Estimate& found = ahead.estimate();
    choice.voxel_edge = Orientation::suitable_edge(found.area_per_point, found.noise.at(found.far_range),
                                                   choice.near_resolution);
  }
  choice.estimate = ahead.found();
  choice.points = ahead.count();
  return choice;
}

std::string explanation(const Choice& choice) {
  const model::Parameters& parameters = choice.parameters;
  return "resolution " + short_text(resolution_of(parameters)) + ": " + resolution_reason(choice) + "\n" +
         "noise " + short_text(noise_of(parameters)) + ": " + noise_reason(choice) + "\n" + "tolerance " +
         io::short_text(parameters.tolerance) + ": " + tolerance_reason(choice) + "\n";
}

}  // namespace limpet::survey
