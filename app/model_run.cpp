// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/model_run.hpp>
#include <limpet/io/text.hpp>

#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/simulation/initial_faces.hpp>
#include <stdexcept>
#include <utility>

namespace limpet::app {
namespace {

constexpr double kEnoughPoints = 3;  ///< per λ²; with fewer nothing links up

model::Model make_model(const model::Parameters& parameters) {
  try {
    return model::Model(parameters);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

void add_initial(model::Model& model, const std::string& mesh) {
  try {
    model.add_initial(simulation::initial_faces(simulation::load_mesh(mesh)));
  } catch (const std::invalid_argument& error) {
    throw UsageError(mesh + ": " + error.what());
  }
}

}  // namespace

int say_nothing_is_written() {
  std::fprintf(
      stderr,
      "limpet: interrupted before the first set; nothing is written (with --order arrival points are "
      "modelled as they come)\n");
  return kFallsShort;
}

ModelRun::ModelRun(const ModelArguments& args, std::optional<Checkpoint> checkpoint)
    : args_(args),
      options_(args.checkpoint.empty() ? std::vector<CheckpointOption>{} : options_of(args)),
      from_(std::move(checkpoint)),
      scan_(open_scan(args, interrupted)),
      keeper_(args.checkpoint, args.checkpoint_every, args.scan),
      stages_(args.stages) {
  if (from_) require_same_options(args.checkpoint, *from_, options_);
}

int ModelRun::go() {
  require_points(scan_, args_);
  warn_of_axes(scan_);
  model::Model model = from_ ? resume() : begin();
  if (from_ && !catch_up()) return kFallsShort;
  from_.reset();
  read_all(model);
  if (interrupted_ && sets_ == 0) return say_nothing_is_written();
  return write(model);
}

model::Model ModelRun::begin() {
  const survey::Choice choice = choose(scan_, args_);
  say_choice(args_, choice.parameters);
  total_ = choice.points;
  voxel_edge_ = choice.voxel_edge;
  if (voxel_edge_ > 0) orient(scan_, args_, voxel_edge_);
  model::Model model = make_model(choice.parameters);
  if (!args_.initial.empty()) add_initial(model, args_.initial);
  if (!args_.labels.empty()) model.keep_labels();
  order_cell_ = choice.near_resolution;
  put_in_order();
  return model;
}

model::Model ModelRun::resume() {
  total_ = scan_.promised();
  try {
    model::Model model = model::Model::from_state(from_->model);
    from_->model = std::string();
    stages_.restore(from_->stages);
    say_choice(args_, model.parameters());
    voxel_edge_ = from_->voxel_edge;
    if (scan_.has_axes() != (voxel_edge_ == 0))
      throw io::InputError(scan_.name(), "is not the scan that " + args_.checkpoint +
                                             " was written for, or it has changed since");
    if (voxel_edge_ > 0) orient(scan_, args_, voxel_edge_);
    order_cell_ = from_->order_cell;
    put_in_order();
    return model;
  } catch (const std::invalid_argument& error) {
    throw io::InputError(args_.checkpoint, error.what());
  }
}

void ModelRun::put_in_order() {
  if (args_.in_arrival_order) return;
  const auto memory = static_cast<std::size_t>(args_.order_memory) << 20;
  ordered_.emplace([this](Reading& reading) { return !interrupted() && read(reading); },
                   survey::Ordering{order_cell_, memory, interrupted});
}

bool ModelRun::read(Reading& reading) {
  if (!scan_.next(reading)) return false;
  ++read_;
  if (ordered_) digest(reading);
  return true;
}

void ModelRun::digest(const Reading& reading) {
  if (!keeper_.on()) return;
  for (const Eigen::Vector3d& v : {reading.point.position, reading.point.axis})
    digest_.add(v.x()), digest_.add(v.y()), digest_.add(v.z());
  digest_.add(reading.point.range);
  digest_.add(static_cast<std::uint64_t>(reading.skipped));
}

bool ModelRun::catch_up() {
  Progress progress("reading again", from_->points, args_.quiet);
  Reading reading;
  while (given_ < from_->points && !interrupted() && next(reading)) {
    count_in(reading);
    progress.step(given_);
  }
  progress.clear();
  if (interrupted()) {
    std::fprintf(stderr, "limpet: interrupted on the way to where %s goes on; nothing is written\n",
                 args_.checkpoint.c_str());
    return false;
  }
  if (given_ < from_->points && !scan_.damage().empty()) throw io::InputError(scan_.damage());
  if (given_ < from_->points || digest_.value() != from_->digest)
    throw io::InputError(scan_.name(), "is not the scan that " + args_.checkpoint +
                                           " was written for, or it has changed since");
  sets_ = from_->sets;
  violations_ = from_->violations;
  before_ = from_->seconds;
  return true;
}

void ModelRun::read_all(model::Model& model) {
  Progress progress("modelling", total_, args_.quiet);
  start_ = Clock::now();
  std::vector<Reading> set;
  for (;;) {
    read_set(set);
    if (interrupted() || set.empty()) break;
    give(model, set);
    if (keeper_.due(sets_)) keep_checkpoint(model);
    progress.step(given_);
  }
  // The state before finish(): a run that is ended there goes on from here.
  if (sets_ > 0 && !(keeper_.due(sets_) && keeper_.failure().empty())) keep_checkpoint(model);
  if (interrupted() && !set.empty()) give(model, set);
  if (!interrupted()) model.finish(interrupted);
  interrupted_ = interrupted();
  seconds_ = seconds_so_far();
  records_.skip(read_, scan_.skipped_at_end());
}

void ModelRun::read_set(std::vector<Reading>& set) {
  set.clear();
  Reading reading;
  while (static_cast<std::int64_t>(set.size()) < args_.set_size && !interrupted() && next(reading))
    set.push_back(reading);
}

void ModelRun::count_in(const Reading& reading) {
  ++given_;
  if (!args_.labels.empty()) records_.add(reading);
  sample_.add(reading.point);
  if (!ordered_) digest(reading);
}

void ModelRun::give(model::Model& model, const std::vector<Reading>& set) {
  points_.clear();
  for (const Reading& reading : set) {
    count_in(reading);
    points_.push_back(reading.point);
  }
  model.update(points_);
  stages_.look(model);
  ++sets_;
  if (args_.check_every > 0 && sets_ % args_.check_every == 0)
    judge(model.record(), "set " + std::to_string(sets_));
}

void ModelRun::keep_checkpoint(const model::Model& model) {
  if (!keeper_.on()) return;
  const auto start = Clock::now();
  keeper_.keep([&] {
    return Checkpoint{options_,         given_,      sets_,       digest_.value(), violations_,
                      seconds_so_far(), voxel_edge_, order_cell_, stages_.state(), model.state()};
  });
  apart_ += std::chrono::duration<double>(Clock::now() - start).count();
}

void ModelRun::judge(const model::ModelRecord& record, const std::string& when) {
  const auto start = Clock::now();
  for (const auto& violation : app::judge(record)) {
    if (violations_++ < 20) {
      std::fprintf(stderr, "limpet: broken after %s: %s, %s: %s\n", when.c_str(), violation.law.c_str(),
                   violation.where.c_str(), violation.what.c_str());
    }
  }
  apart_ += std::chrono::duration<double>(Clock::now() - start).count();
}

double ModelRun::seconds_so_far() const {
  return before_ + std::chrono::duration<double>(Clock::now() - start_).count() - apart_;
}

int ModelRun::write(const model::Model& model) {
  const model::ModelRecord record = model.record();
  Outputs outputs;
  save(model, record, outputs);
  judge(record, "the final model");
  const Summary summary = summarise_run(model, record);
  if (!args_.json.empty()) outputs.attempt(args_.json, [&] { save_text(args_.json, to_json(summary)); });
  report(summary);
  if (!keeper_.failure().empty()) {
    const bool written = !outputs.failed();
    outputs.add(keeper_.failure() + (written ? "; the model is written, but not the last checkpoint"
                                             : "; nor is the last checkpoint written"));
  }
  if (!summary.damage.empty()) {
    const std::string damage = summary.damage + "; what was read before it is modelled";
    if (!outputs.failed()) throw io::InputError(damage);
    outputs.add(damage);
  }
  outputs.require_all();
  return summary.violations > 0 || summary.interrupted ? kFallsShort : kDone;
}

Summary ModelRun::summarise_run(const model::Model& model, const model::ModelRecord& record) const {
  // Why edges are open takes as long to find out as a round of finish(): not after an interruption.
  Summary summary = summarise(record, interrupted_ ? std::vector<model::OpenEdge>() : model.open_edges());
  summary.refused += scan_.skipped();
  summary.violations = violations_;
  summary.seconds = seconds_;
  summary.in_arrival_order = !ordered_;
  if (ordered_) summary.order_disk_bytes = ordered_->bytes_on_disk();
  summary.axes_guessed = voxel_edge_ > 0;
  summary.interrupted = interrupted_;
  if (!interrupted_) summary.damage = scan_.damage();
  return summary;
}

/// What the model is for comes first: the rest takes its time.
void ModelRun::save(const model::Model& model, const model::ModelRecord& record, Outputs& outputs) const {
  for (const std::string& path : args_.models) outputs.attempt(path, [&] { io::save_model(path, record); });
  if (!args_.labels.empty())
    outputs.attempt(args_.labels, [&] { save_text(args_.labels, records_.lines(read_, model.labels())); });
  stages_.save(args_.models.front(), record, outputs);
  if (interrupted_)
    std::fprintf(stderr, "limpet: interrupted after %s points; the model so far is written\n",
                 io::grouped(record.points).c_str());
}

void ModelRun::report(const Summary& summary) const {
  warn_of_density(summary);
  if (args_.quiet) {
    if (summary.refused > 0)
      std::fprintf(stderr, "limpet: warning: %s records were no point\n",
                   io::grouped(summary.refused).c_str());
    return;
  }
  std::string text = to_text(summary) + "written:";
  for (const std::string& path : args_.models) text += " " + path;
  std::fprintf(for_people(args_), "%s\n", text.c_str());
}

void ModelRun::warn_of_density(const Summary& summary) const {
  // A λ that was chosen to grow was chosen by two looks at the scan: what the sample tells is coarser.
  if (summary.resolution.varies() && !args_.resolution) return;
  const survey::Estimate found = survey::estimate(sample_);
  const double density = survey::points_to_square(found, summary.resolution);
  if (!(found.area_per_point > 0) || !(density < kEnoughPoints)) return;
  std::fprintf(stderr,
               "limpet: warning: %.1f points per square of the resolution %s are too few for surfaces to "
               "link up; --resolution %s would do\n",
               density, short_text(summary.resolution).c_str(),
               short_text(survey::suitable_resolution(found, summary.noise)).c_str());
}

}  // namespace limpet::app
