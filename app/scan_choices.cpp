// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/scan_choices.hpp>

#include <cmath>
#include <limpet/app/arguments.hpp>
#include <limpet/app/orientation.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/io/error.hpp>

namespace limpet::app {
namespace {

constexpr std::int64_t kLookAheadFile = 2'000'000, kLookAheadStream = 100'000;

/// A damaged scan has few points because of its damage: then that is what has to be said.
[[noreturn]] void refuse_few_points(const ModelArguments& args, PointStream& scan) {
  model::SensorPoint point;
  for (std::int64_t skipped = 0; scan.next(point, skipped);) {
  }
  if (!scan.damage().empty()) throw io::InputError(scan.damage());
  throw io::InputError(name_of(scan, args),
                       "too few points lie on a surface to choose a resolution; give --resolution");
}

void set_noise(model::Parameters& parameters, const NoiseArgument& noise) {
  parameters.noise = noise.fixed;
  parameters.noise_per_range = noise.per_range;
  parameters.noise_per_range2 = noise.per_range2;
}

NoiseArgument rounded(const NoiseArgument& noise) {
  return {short_number(noise.fixed), short_number(noise.per_range), short_number(noise.per_range2)};
}

}  // namespace

const Estimate& LookAhead::estimate() {
  if (!found_) found_ = app::estimate([&](const Take& take) { scan_.look_ahead(most(), take); });
  return *found_;
}

std::int64_t LookAhead::points() const {
  return found_ && found_->points < most() ? found_->points : scan_.promised();
}

std::int64_t LookAhead::most() const { return scan_.is_standard_input() ? kLookAheadStream : kLookAheadFile; }

std::string name_of(const PointStream& scan, const ModelArguments& args) {
  return scan.is_standard_input() ? "standard input" : args.scan;
}

std::FILE* for_people(const ModelArguments& args) { return args.json == "-" ? stderr : stdout; }

void require_points(PointStream& scan, const ModelArguments& args) {
  if (scan.first() == nullptr) {
    if (!scan.damage().empty()) throw io::InputError(scan.damage());
    const std::string none = scan.skipped() > 0 ? " (" + grouped(scan.skipped()) + " records are none)" : "";
    throw io::InputError(name_of(scan, args), "holds no point" + none);
  }
  if (args.noise && args.noise->varies() && scan.first()->point.range == 0) {
    throw io::InputError(name_of(scan, args),
                         "does not say from how far its points were sensed; give --noise as one number");
  }
}

model::Parameters choose_parameters(const ModelArguments& args, PointStream& scan, LookAhead& ahead) {
  model::Parameters parameters;
  parameters.angle_rad = args.angle_deg * M_PI / 180;
  parameters.rules = args.rules;
  parameters.neighbours = !args.open;
  parameters.redundancy_count = args.redundancy.count;
  parameters.redundancy_ratio = args.redundancy.ratio;
  const NoiseArgument noise = args.noise ? *args.noise : rounded(ahead.estimate().noise);
  set_noise(parameters, noise);
  if (!args.resolution && !(ahead.estimate().area_per_point > 0)) refuse_few_points(args, scan);
  parameters.resolution =
      args.resolution ? *args.resolution : short_number(suitable_resolution(ahead.estimate(), noise));
  if (args.tolerance) {
    parameters.tolerance = *args.tolerance;
  } else {
    const double far_noise = noise.varies() ? noise.at(ahead.estimate().far_range) : noise.fixed;
    parameters.tolerance = short_number(suitable_tolerance(far_noise, parameters.resolution));
  }
  return parameters;
}

void say_choice(const ModelArguments& args, const model::Parameters& parameters) {
  if (args.quiet || (args.resolution && args.noise)) return;
  std::string text;
  if (!args.resolution) text += " --resolution " + short_text(parameters.resolution);
  if (!args.noise)
    text += " --noise " + short_text(NoiseArgument{parameters.noise, parameters.noise_per_range,
                                                   parameters.noise_per_range2});
  if (!args.tolerance) text += " --tolerance " + short_text(parameters.tolerance);
  std::fprintf(for_people(args), "chosen from the scan:%s\n", text.c_str());
}

double voxel_edge(LookAhead& ahead, double resolution) {
  const Estimate& found = ahead.estimate();
  return Orientation::suitable_edge(found.area_per_point, found.noise.at(found.far_range), resolution);
}

void orient(PointStream& scan, const ModelArguments& args, double voxel_edge) {
  scan.orient(voxel_edge);
  if (args.orient) return;
  const int pieces = scan.orientation()->components();
  std::fprintf(
      stderr,
      "limpet: warning: %s says neither normals nor sensing axes; oriented by neighbour consistency, "
      "%s, turned up and outward; if it was scanned from elsewhere, give --viewpoint x,y,z, where the "
      "sensor stood\n",
      name_of(scan, args).c_str(),
      pieces == 1 ? "as one piece" : ("in " + grouped(pieces) + " pieces").c_str());
}

}  // namespace limpet::app
