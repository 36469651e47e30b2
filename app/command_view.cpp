// Copyright the limpet authors. GPL-3.0-or-later.
#include <array>
#include <cstdio>
#include <filesystem>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/model_series.hpp>
#include <limpet/app/outputs.hpp>
#include <limpet/app/pages.hpp>
#include <limpet/app/run_reader.hpp>
#include <limpet/drawing/page.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/io/text.hpp>
#include <limpet/simulation/scene.hpp>
#include <optional>

namespace limpet::app {
namespace {

bool ends_with(const std::string& path, const char* extension) { return io::extension_of(path) == extension; }

bool any_ends_with(const std::vector<std::string>& paths, const char* extension) {
  for (const std::string& path : paths)
    if (ends_with(path, extension)) return true;
  return false;
}

void require_output_name(const std::string& path, bool of_run) {
  for (const char* extension : {"html", "glb", "vtp"})
    if (ends_with(path, extension)) return;
  if (!ends_with(path, "pvd"))
    throw UsageError("-o " + path +
                     ": a page is written as .html; also to be had are .glb, .vtp and, of a run, .pvd");
  if (!of_run) throw UsageError("-o " + path + ": a .pvd is of a recorded run; of a model give .vtp");
}

void require_sound(const ViewArguments& args, bool of_run) {
  FileRoles files;
  files.reads("MODEL", args.source);
  files.reads("--truth", simulation::is_scene_name(args.truth) && !std::filesystem::exists(args.truth)
                             ? ""
                             : args.truth);
  for (const std::string& path : args.outputs) {
    require_output_name(path, of_run);
    files.writes("-o", path);
  }
  files.require_apart();
}

void save_bytes(const std::string& path, const std::string& bytes) {
  io::OutputFile file(path);
  file.write(bytes);
  file.close();
}

std::string page_data(const ViewArguments& args, bool of_run) {
  std::optional<simulation::Scene> truth;
  if (!args.truth.empty()) truth = simulation::make_scene(args.truth);
  const PageOptions options{std::filesystem::path(args.truth).filename().string(),
                            truth ? &truth->mesh : nullptr, args.times, args.quiet};
  return of_run ? page_of_run(args.source, options) : page_of_model(args.source, options);
}

}  // namespace

int run(const ViewArguments& args) {
  refuse_folder(args.source);
  std::error_code none;
  const bool of_run = std::filesystem::is_regular_file(args.source, none) && is_run(args.source);
  require_sound(args, of_run);
  const bool with_page = any_ends_with(args.outputs, "html");
  if (with_page) drawing::require_page();
  const std::string data = with_page ? page_data(args, of_run) : std::string();
  std::optional<model::ModelRecord> record;
  if (any_ends_with(args.outputs, "glb") || any_ends_with(args.outputs, "vtp"))
    record = of_run ? model_at_end(args.source) : io::load_native(args.source);
  Outputs outputs;
  for (const std::string& path : args.outputs) {
    outputs.attempt(path, [&] {
      if (ends_with(path, "html"))
        save_bytes(path, drawing::page(std::filesystem::path(args.source).filename().string(), data));
      else if (ends_with(path, "pvd"))
        save_series(path, args.source, args.stages, args.quiet);
      else
        io::save_mesh(path, *record);
    });
  }
  outputs.require_all();
  if (!args.quiet)
    for (const std::string& path : args.outputs) std::printf("written: %s\n", path.c_str());
  return kDone;
}

}  // namespace limpet::app
