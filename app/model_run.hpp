// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <chrono>
#include <cstdint>
#include <limpet/app/checkpoint.hpp>
#include <limpet/app/checkpoint_keeper.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/outputs.hpp>
#include <limpet/app/record_labels.hpp>
#include <limpet/app/scan_choices.hpp>
#include <limpet/app/stages.hpp>
#include <limpet/app/summary.hpp>
#include <limpet/model/digest.hpp>
#include <limpet/model/model.hpp>
#include <limpet/survey/estimate.hpp>
#include <limpet/survey/ordered_points.hpp>
#include <limpet/survey/point_stream.hpp>
#include <optional>
#include <string>
#include <vector>

namespace limpet::app {

/// One run of `limpet model`: from the first set of points, or the one after a checkpoint, until all files
/// are written.
class ModelRun {
 public:
  /// The run continues from `checkpoint` if there is one. Throws io::InputError when the scan cannot be
  /// opened, or the checkpoint was written with other options.
  ModelRun(const ModelArguments& args, std::optional<Checkpoint> checkpoint);

  /// Returns the exit code. Errors: those of a command.
  int go();

 private:
  using Reading = survey::Reading;

  model::Model begin();
  model::Model resume();
  /// Sees to it that points come in the order asked for. Precondition: λ is known, and axes are found.
  void put_in_order();
  /// The next reading that the model is given.
  bool next(Reading& reading) { return ordered_ ? ordered_->next(reading) : read(reading); }
  /// The next reading of the scan.
  bool read(Reading& reading);
  /// Reads again the points that the checkpoint's model has been given; they must be the same. False: it was
  /// interrupted.
  bool catch_up();
  void read_all(model::Model& model);
  void read_set(std::vector<Reading>& set);
  /// Counts a point that the model is given, for labels, for the density warning and for checkpoints.
  void count_in(const Reading& reading);
  void digest(const Reading& reading);
  void give(model::Model& model, const std::vector<Reading>& set);
  void keep_checkpoint(const model::Model& model);
  void judge(const model::ModelRecord& record, const std::string& when);
  double seconds_so_far() const;
  int write(const model::Model& model);
  Summary summarise_run(const model::Model& model, const model::ModelRecord& record) const;
  void save(const model::Model& model, const model::ModelRecord& record, Outputs& outputs) const;
  void report(const Summary& summary) const;
  void warn_of_density(const Summary& summary) const;

  using Clock = std::chrono::steady_clock;

  const ModelArguments& args_;
  std::vector<CheckpointOption> options_;  ///< only where checkpoints are kept
  std::optional<Checkpoint> from_;         ///< the checkpoint that the run continues from
  survey::PointStream scan_;
  CheckpointKeeper keeper_;
  Stages stages_;
  // What follows, apart from the times, depends on the points alone.
  survey::Sample sample_;
  RecordLabels records_;    ///< where labels are asked for
  model::Digest digest_;    ///< of all points of a scan put in order, else of those given; for checkpoints
  std::int64_t given_ = 0;  ///< points handed to the model
  std::int64_t sets_ = 0, violations_ = 0;
  std::int64_t read_ = 0;                         ///< points read of the scan
  std::optional<survey::OrderedPoints> ordered_;  ///< of the scan, unless it is modelled as it arrives
  std::vector<model::SensorPoint> points_;        ///< scratch of give()
  std::int64_t total_ = -1;                       ///< points of the scan; -1: not known
  double order_cell_ = 0;                         ///< of the curve (survey::Ordering)
  double voxel_edge_ = 0;                         ///< by which the scan was oriented; 0: it says its axes
  Clock::time_point start_;                       ///< of reading and modelling
  double before_ = 0;                             ///< seconds spent before the checkpoint
  double apart_ = 0;  ///< seconds since `start_` that do not count: spent on the oracle and on checkpoints
  double seconds_ = 0;
  bool interrupted_ = false;
};

/// Says that a signal came before anything was modelled. Returns the exit code.
int say_nothing_is_written();

}  // namespace limpet::app
