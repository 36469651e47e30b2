// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>
#include <filesystem>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/run_reader.hpp>
#include <limpet/app/run_stages.hpp>
#include <limpet/drawing/drawing.hpp>
#include <limpet/drawing/mesh_record.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/text.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/scene.hpp>
#include <stdexcept>

namespace limpet::app {
namespace {

/// The open edges of a model and what refused them a neighbour; none where the record is no valid model.
std::vector<model::OpenEdge> open_edges_of(const model::ModelRecord& record) {
  try {
    return model::Model(record).open_edges();
  } catch (const std::invalid_argument&) {
    return {};
  }
}

drawing::View view_from(const Eigen::Vector3d& from, const std::optional<Eigen::Vector3d>& up) {
  try {
    return drawing::view_from(from, up);
  } catch (const std::invalid_argument&) {
    throw UsageError(from.norm() > 0 ? "--up lies along --view; give another"
                                     : "--view 0,0,0: give a direction");
  }
}

}  // namespace

int run(const DrawArguments& args) {
  FileRoles files;
  for (const std::string& path : args.models) files.reads("MODEL", path);
  files.writes("-o", args.picture);
  files.require_apart();
  const std::string extension = io::extension_of(args.picture);
  if (extension != "png" && extension != "svg") {
    throw UsageError("-o " + args.picture + ": a picture is written as .png or .svg");
  }
  drawing::DrawOptions options;
  std::vector<drawing::Figure> figures;
  for (const std::string& path : args.models) {
    const std::string name = std::filesystem::path(path).stem().string();
    if (simulation::is_scene_name(path)) {
      figures.push_back({drawing::record_of(simulation::make_scene(path).mesh), name});
      continue;
    }
    if (std::error_code none; std::filesystem::is_regular_file(path, none) && is_run(path)) {
      for (drawing::Figure& figure : run_stages(path, args.stages)) figures.push_back(std::move(figure));
      options.vertices = options.loose_points = false;  // which dots of the path could be taken for
      continue;
    }
    model::ModelRecord record = io::load_native(path);
    auto open_edges = open_edges_of(record);
    figures.push_back({std::move(record), name, std::move(open_edges)});
  }
  options.width = args.width;
  for (const Eigen::Vector3d& from : args.views) options.views.push_back(view_from(from, args.up));
  if (args.up && args.views.empty()) {
    options.views = drawing::default_views(figures);
    for (drawing::View& view : options.views) view.up = view_from(-view.toward, args.up).up;
  }
  drawing::draw(figures, args.picture, options);
  if (!args.quiet) std::printf("written: %s\n", args.picture.c_str());
  return kDone;
}

}  // namespace limpet::app
