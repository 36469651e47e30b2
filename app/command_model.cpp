// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet model`: what can be refused is refused before any work is done.
#include <cstdio>
#include <filesystem>
#include <limpet/app/arguments.hpp>
#include <limpet/app/checkpoint.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/model_run.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/output_file.hpp>

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

/// The checkpoint must not take the place of a file that is none.
void require_checkpoint_place(const ModelArguments& args) {
  const std::string& path = args.checkpoint;
  std::error_code error;
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) > 0 && !is_checkpoint(path))
    throw io::InputError(path, "is no checkpoint of limpet, and is not overwritten");
  if (!fs::exists(path, error) || fs::is_regular_file(path, error)) {
    const io::OutputFile attempt(path);  // leaves nothing behind
  }
}

void require_files(const ModelArguments& args) {
  FileRoles files;
  files.reads("SCAN", args.scan);
  files.reads("--initial", args.initial);
  for (const std::string& path : args.models) files.writes_model("-o", path);
  files.writes("--labels", args.labels);
  files.writes("--json", args.json);
  files.writes("--checkpoint", args.checkpoint);
  for (const std::string& path : Stages::names(args.models.front(), args.stages))
    files.writes("--stages", path);
  files.require_apart();
  if (!args.checkpoint.empty()) require_checkpoint_place(args);
}

/// The checkpoint that --resume continues from. The first of many starts of one command finds none yet.
std::optional<Checkpoint> found_checkpoint(const ModelArguments& args) {
  if (!args.resume) return std::nullopt;
  auto found = load_checkpoint(args.checkpoint);
  if (!found)
    std::fprintf(stderr, "limpet: %s: there is no checkpoint yet; the run begins at the start\n",
                 args.checkpoint.c_str());
  return found;
}

}  // namespace

int run(const ModelArguments& args) {
  require_files(args);
  catch_interrupts();
  try {
    return ModelRun(args, found_checkpoint(args)).go();
  } catch (const io::InputError&) {  // a scan that is cut short by a signal may seem to hold nothing
    if (!interrupted()) throw;
    return say_nothing_is_written();
  }
}

}  // namespace limpet::app
