// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/io/scan_writer.hpp>
#include <limpet/io/text.hpp>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/shapes.hpp>
#include <map>

namespace limpet::app {
namespace {

struct Interrupted {};

simulation::ScanOptions::Order order_of(const std::string& name) {
  using Order = simulation::ScanOptions::Order;
  static const std::map<std::string, Order> orders = {{"raster", Order::raster},
                                                      {"turning", Order::turning},
                                                      {"shuffled", Order::shuffled},
                                                      {"sampled", Order::sampled}};
  const auto found = orders.find(name);
  if (found == orders.end()) {
    throw UsageError("--order '" + name + "': give raster, turning, shuffled or sampled");
  }
  return found->second;
}

simulation::ScanOptions options_of(const ScanArguments& args, const simulation::Scene& scene) {
  simulation::ScanOptions options;
  options.points = args.points;
  options.order = order_of(args.order);
  options.noise = args.noise;
  options.noise_per_range = args.noise_per_range;
  options.outliers = args.outliers;
  options.seed = args.seed;
  options.viewpoints = args.viewpoints.empty() ? scene.viewpoints : args.viewpoints;
  return options;
}

std::string header_of(const ScanArguments& args) {
  return "limpet scan " + args.mesh + " --points " + std::to_string(args.points) + " --order " + args.order +
         " --noise " + io::short_text(args.noise) + " --outliers " + io::short_text(args.outliers) +
         " --seed " + std::to_string(args.seed);
}

}  // namespace

int run(const ScanArguments& args) {
  FileRoles files;
  files.reads("MESH", args.mesh);
  files.writes("-o", args.scan);
  files.require_apart();
  order_of(args.order);
  refuse_folder(args.mesh);
  const simulation::Scene scene = simulation::make_scene(args.mesh);
  const simulation::ScanOptions options = options_of(args, scene);

  io::ScanWriterOptions format;
  format.ascii = args.ascii;
  format.labels = args.faces;
  format.ranges = args.ranges;
  format.comment = header_of(args);
  const auto writer = io::create_scan(args.scan, format);
  Progress progress("scanning", args.points, args.quiet);
  catch_interrupts();
  std::int64_t points = 0, outliers = 0;
  bool stopped = false;
  try {
    simulation::scan(scene.mesh, options, [&](const simulation::LabelledPoint& p) {
      if (interrupted()) throw Interrupted();
      writer->write({p.point, true, p.face});
      outliers += p.face < 0;
      if (++points % 1024 == 0) progress.step(points);
    });
  } catch (const Interrupted&) {
    stopped = true;
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  writer->close();
  progress.clear();
  if (stopped) {
    std::fprintf(stderr, "limpet: interrupted after %s points; the scan so far is written\n",
                 io::grouped(points).c_str());
  }
  if (!args.quiet) {
    const auto from = options.viewpoints.empty() ? std::string("around the mesh")
                                                 : std::to_string(options.viewpoints.size()) + " viewpoints";
    std::printf("%s: %s points of %d faces, %s%s%s; noise %s, %s outliers, seed %llu\nwritten: %s\n",
                args.mesh.c_str(), io::grouped(points).c_str(), scene.mesh.face_count, args.order.c_str(),
                args.order == "sampled" ? "" : " from ", args.order == "sampled" ? "" : from.c_str(),
                io::short_text(args.noise).c_str(), io::grouped(outliers).c_str(),
                static_cast<unsigned long long>(args.seed), args.scan.c_str());
  }
  return stopped ? kFallsShort : kDone;
}

}  // namespace limpet::app
