// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/scan_choices.hpp>

#include <cmath>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>

namespace limpet::app {

std::FILE* for_people(const ModelArguments& args) { return args.json == "-" ? stderr : stdout; }

survey::PointStream open_scan(const ModelArguments& args, const std::function<bool()>& stop) {
  return survey::PointStream(args.scan, {.viewpoint = args.viewpoint, .ignore_axes = args.orient}, stop);
}

void warn_of_axes(survey::PointStream& scan) {
  if (!scan.axes_say_nothing()) return;
  std::fprintf(stderr,
               "limpet: warning: all normals or axes that %s says are zero; it is read as one without\n",
               scan.name().c_str());
}

void require_points(survey::PointStream& scan, const ModelArguments& args) {
  survey::require_points(scan);
  if (args.noise && args.noise->varies() && scan.first()->point.range == 0) {
    throw io::InputError(scan.name(),
                         "does not say from how far its points were sensed; give --noise as one number");
  }
  if (args.resolution && args.resolution->varies() && scan.first()->point.range == 0) {
    throw io::InputError(scan.name(),
                         "does not say from how far its points were sensed; give --resolution as one number");
  }
}

survey::Choice choose(survey::PointStream& scan, const ModelArguments& args) {
  survey::Known known{args.resolution, args.noise, args.tolerance, {}};
  known.others.angle_rad = args.angle_deg * M_PI / 180;
  known.others.rules = args.rules;
  known.others.neighbours = !args.open;
  known.others.redundancy_count = args.redundancy.count;
  known.others.redundancy_ratio = args.redundancy.ratio;
  try {
    return survey::choose(scan, known);
  } catch (const survey::TooFewPoints&) {
    throw io::InputError(scan.name(),
                         "too few points lie on a surface to choose a resolution; give --resolution");
  }
}

void say_choice(const ModelArguments& args, const model::Parameters& parameters) {
  if (args.quiet || (args.resolution && args.noise)) return;
  std::string text;
  if (!args.resolution) text += " --resolution " + short_text(survey::resolution_of(parameters));
  if (!args.noise) text += " --noise " + short_text(survey::noise_of(parameters));
  if (!args.tolerance) text += " --tolerance " + io::short_text(parameters.tolerance);
  std::fprintf(for_people(args), "chosen from the scan:%s\n", text.c_str());
}

void orient(survey::PointStream& scan, const ModelArguments& args, double voxel_edge) {
  scan.orient(voxel_edge);
  if (args.orient) return;
  const int pieces = scan.orientation()->components();
  std::fprintf(
      stderr,
      "limpet: warning: %s says neither normals nor sensing axes; oriented by neighbour consistency, "
      "%s, turned up and outward; if it was scanned from elsewhere, give --viewpoint x,y,z, where the "
      "sensor stood\n",
      scan.name().c_str(), pieces == 1 ? "as one piece" : ("in " + io::grouped(pieces) + " pieces").c_str());
}

}  // namespace limpet::app
