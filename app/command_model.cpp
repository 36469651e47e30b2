// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet model`: what can be refused is refused before any work is done.
#include <cstdio>
#include <filesystem>
#include <limpet/app/arguments.hpp>
#include <limpet/app/checkpoint.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/model_run.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/output_file.hpp>

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

/// The checkpoint's name must not be that of another file, which would be overwritten.
void require_checkpoint_place(const ModelArguments& args) {
  const std::string& path = args.checkpoint;
  require_writable(path);
  std::error_code error;
  std::vector<std::string> others = args.models;
  others.insert(others.end(), {args.labels, args.json, args.scan});
  for (const std::string& other : others) {
    if (!other.empty() && fs::weakly_canonical(other, error) == fs::weakly_canonical(path, error))
      throw UsageError("--checkpoint " + path + ": is the name of another file of this run");
  }
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) > 0 && !is_checkpoint(path))
    throw io::InputError(path, "is no checkpoint of limpet, and is not overwritten");
  if (!fs::exists(path, error) || fs::is_regular_file(path, error)) {
    const io::OutputFile attempt(path);  // leaves nothing behind
  }
}

void require_outputs(const ModelArguments& args) {
  for (const std::string& path : args.models) {
    require_model_name(path);
    require_writable(path);
  }
  if (!args.labels.empty()) require_writable(args.labels);
  if (!args.json.empty() && args.json != "-") require_writable(args.json);
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
  require_outputs(args);
  catch_interrupts();
  return ModelRun(args, found_checkpoint(args)).go();
}

}  // namespace limpet::app
