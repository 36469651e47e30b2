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

/// An option of the command line on which the resulting model depends, and its value, as text on one line.
struct CheckpointOption {
  std::string name, value;
};

/// All that a run needs, besides its scan, to go on after a whole set as if it had not stopped.
struct Checkpoint {
  std::vector<CheckpointOption> options;
  std::int64_t points = 0;   ///< points of the scan that the model has been given
  std::int64_t sets = 0;     ///< sets in which they were given
  std::uint64_t digest = 0;  ///< of these points; of all where they are put in order
  std::int64_t violations = 0;
  double seconds = 0;     ///< spent so far
  double voxel_edge = 0;  ///< by which the scan was oriented; 0: it says its axes
  double order_cell = 0;  ///< of the curve along which the scan is put in order, scan's unit
  std::string stages;     ///< Stages::state()
  std::string model;      ///< Model::state()
};

/// The options on which the resulting model depends. The mesh of --initial is read for it; errors as of
/// simulation::load_mesh().
std::vector<CheckpointOption> options_of(const ModelArguments& args);

/// Writes the whole file or leaves the old one (see io::OutputFile). Who may not read `scan` may not read the
/// checkpoint, which holds readings. Errors: io::OutputError.
void save_checkpoint(const std::string& path, const Checkpoint& checkpoint, const std::string& scan);

/// Reads a checkpoint; nothing when there is no such file. Errors: io::InputError when the file is damaged,
/// is no checkpoint, or is of another version of the program.
std::optional<Checkpoint> load_checkpoint(const std::string& path);

/// Do the first bytes of this file say that it is a checkpoint?
bool is_checkpoint(const std::string& path);

/// Throws io::InputError, naming the option, when a run of these options cannot go on from the checkpoint.
void require_same_options(const std::string& path, const Checkpoint& checkpoint,
                          const std::vector<CheckpointOption>& options);

}  // namespace limpet::app
