// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/app/commands.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Checkpoints of `limpet model` (docs/checkpoints.md).
namespace limpet::app {

/// An option that what comes out depends on, and its value, as text on one line.
struct CheckpointOption {
  std::string name, value;
};

/// All that a run needs, besides its scan, to go on after a whole set as if it had not stopped.
struct Checkpoint {
  std::vector<CheckpointOption> options;
  std::int64_t points = 0;   ///< of the scan that were given to the model
  std::int64_t sets = 0;     ///< that they came in
  std::uint64_t digest = 0;  ///< of these points
  std::int64_t violations = 0;
  double seconds = 0;     ///< spent so far
  double voxel_edge = 0;  ///< by which the scan was oriented; 0: it says its axes
  std::string stages;     ///< Stages::state()
  std::string model;      ///< Model::state()
};

/// Those of the arguments that what comes out depends on. Reads the mesh of --initial: its errors.
std::vector<CheckpointOption> options_of(const ModelArguments& args);

/// Written aside, synced and renamed. Errors: io::OutputError.
void save_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// Nothing when there is no such file. Errors: io::InputError when it is damaged, none, or another version's.
std::optional<Checkpoint> load_checkpoint(const std::string& path);

/// Is what is there one, as far as its first bytes tell?
bool is_checkpoint(const std::string& path);

/// Throws io::InputError, naming the option, when a run of these options cannot go on from the checkpoint.
void require_same_options(const std::string& path, const Checkpoint& checkpoint,
                          const std::vector<CheckpointOption>& options);

}  // namespace limpet::app
