// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/estimate.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/mesh_model.hpp>
#include <limpet/app/point_stream.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/app/stages.hpp>
#include <limpet/app/summary.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/text.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/mesh.hpp>
#include <optional>

namespace limpet::app {
namespace {

constexpr std::int64_t kLookAheadFile = 2'000'000, kLookAheadStream = 100'000;
constexpr double kEnoughPoints = 3;  ///< per λ²; with fewer nothing links up

void require_outputs(const ModelArguments& args) {
  for (const std::string& path : args.models) {
    const std::string extension = io::extension_of(path);
    if (extension != "limpet" && !io::is_mesh_extension(extension)) {
      throw UsageError("-o " + path + ": a model is written as .limpet, .off, .ply, .obj or .stl");
    }
    require_writable(path);
  }
  if (!args.labels.empty()) require_writable(args.labels);
  if (!args.json.empty() && args.json != "-") require_writable(args.json);
}

/// With --json - standard output is for the summary alone.
std::FILE* for_people(const ModelArguments& args) { return args.json == "-" ? stderr : stdout; }

void require_points(PointStream& scan, const ModelArguments& args) {
  const std::string name = scan.is_standard_input() ? "standard input" : args.scan;
  if (scan.first() == nullptr) {
    if (!scan.damage().empty()) throw io::InputError(scan.damage());
    const std::string none = scan.skipped() > 0 ? " (" + grouped(scan.skipped()) + " records are none)" : "";
    throw io::InputError(name, "holds no point" + none);
  }
  if (args.noise && args.noise->varies() && scan.first()->point.range == 0) {
    throw io::InputError(name,
                         "does not say from how far its points were sensed; give --noise as one number");
  }
}

/// A damaged scan has few points because of its damage: then that is what has to be said.
[[noreturn]] void refuse_few_points(const ModelArguments& args, PointStream& scan) {
  model::SensorPoint point;
  for (std::int64_t skipped = 0; scan.next(point, skipped);) {
  }
  if (!scan.damage().empty()) throw io::InputError(scan.damage());
  throw io::InputError(scan.is_standard_input() ? "standard input" : args.scan,
                       "too few points lie on a surface to choose a resolution; give --resolution");
}

void set_noise(model::Parameters& parameters, const NoiseArgument& noise) {
  parameters.noise = noise.fixed;
  parameters.noise_per_range = noise.per_range;
  parameters.noise_per_range2 = noise.per_range2;
}

NoiseArgument rounded(const NoiseArgument& noise) {
  return {short_number(noise.fixed), short_number(noise.per_range), short_number(noise.per_range2)};
}

/// What the scan says of itself, from a look ahead that is taken when first asked for, and once.
class LookAhead {
 public:
  explicit LookAhead(PointStream& scan) : scan_(scan) {}

  const Estimate& estimate() {
    if (!found_) found_ = app::estimate([&](const Take& take) { scan_.look_ahead(most(), take); });
    return *found_;
  }
  /// How many points the scan has; −1: not known.
  std::int64_t points() const {
    return found_ && found_->points < most() ? found_->points : scan_.promised();
  }

 private:
  std::int64_t most() const { return scan_.is_standard_input() ? kLookAheadStream : kLookAheadFile; }

  PointStream& scan_;
  std::optional<Estimate> found_;
};

/// λ, noise and tolerance as given, or else from the scan, which is then said.
model::Parameters choose_parameters(const ModelArguments& args, PointStream& scan, LookAhead& ahead) {
  model::Parameters parameters;
  parameters.angle_rad = args.angle_deg * M_PI / 180;
  parameters.rules = args.rules;
  parameters.neighbours = !args.open;
  parameters.redundancy_count = args.redundancy.count;
  parameters.redundancy_ratio = args.redundancy.ratio;
  const NoiseArgument noise = args.noise ? *args.noise : rounded(ahead.estimate().noise);
  set_noise(parameters, noise);
  if (!args.resolution && !(ahead.estimate().area_per_point > 0)) refuse_few_points(args, scan);
  parameters.resolution =
      args.resolution ? *args.resolution : short_number(suitable_resolution(ahead.estimate(), noise));
  if (args.tolerance) {
    parameters.tolerance = *args.tolerance;
  } else {
    const double far_noise = noise.varies() ? noise.at(ahead.estimate().far_range) : noise.fixed;
    parameters.tolerance = short_number(suitable_tolerance(far_noise, parameters.resolution));
  }
  if (!args.quiet && (!args.resolution || !args.noise)) {
    std::string text;
    if (!args.resolution) text += " --resolution " + short_text(parameters.resolution);
    if (!args.noise) text += " --noise " + short_text(noise);
    if (!args.tolerance) text += " --tolerance " + short_text(parameters.tolerance);
    std::fprintf(for_people(args), "chosen from the scan:%s\n", text.c_str());
  }
  return parameters;
}

/// A scan that says no axes gets them from its own shape, which can only be a guess.
void orient(PointStream& scan, const ModelArguments& args, LookAhead& ahead, double resolution) {
  const Estimate& found = ahead.estimate();
  scan.orient(Orientation::suitable_edge(found.area_per_point, found.noise.at(found.far_range), resolution));
  if (args.orient) return;
  const int pieces = scan.orientation()->components();
  std::fprintf(
      stderr,
      "limpet: warning: %s says neither normals nor sensing axes; oriented by neighbour consistency, "
      "%s, turned up and outward; if it was scanned from elsewhere, give --viewpoint x,y,z, where the "
      "sensor stood\n",
      scan.is_standard_input() ? "standard input" : args.scan.c_str(),
      pieces == 1 ? "as one piece" : ("in " + grouped(pieces) + " pieces").c_str());
}

/// How many records without a point stand before which point, for --labels.
class Gaps {
 public:
  void add(std::int64_t before_point, std::int64_t records) {
    if (records > 0) gaps_.emplace_back(before_point, records);
  }
  std::string label_lines(const std::vector<model::SegmentId>& labels) const {
    std::string text;
    auto gap = gaps_.begin();
    for (std::size_t i = 0; i <= labels.size(); ++i) {
      for (; gap != gaps_.end() && gap->first == static_cast<std::int64_t>(i); ++gap) {
        for (std::int64_t k = 0; k < gap->second; ++k) text += "0\n";
      }
      if (i < labels.size()) text += std::to_string(labels[i].value) + "\n";
    }
    return text;
  }

 private:
  std::vector<std::pair<std::int64_t, std::int64_t>> gaps_;
};

/// One run, from the first set to the last file.
class Run {
 public:
  explicit Run(const ModelArguments& args)
      : args_(args), scan_(args.scan, {args.viewpoint, args.orient, {}, {}}), stages_(args.stages) {}

  int go() {
    require_points(scan_, args_);
    LookAhead ahead(scan_);
    const model::Parameters parameters = choose_parameters(args_, scan_, ahead);
    axes_guessed_ = !scan_.first()->has_axis;
    if (axes_guessed_) orient(scan_, args_, ahead, parameters.resolution);
    noise_ = {parameters.noise, parameters.noise_per_range, parameters.noise_per_range2};
    model::Model model = make_model(parameters);
    if (!args_.initial.empty()) add_initial(model);
    if (!args_.labels.empty()) model.keep_labels();
    read_all(model, ahead.points());
    const model::ModelRecord record = model.record();
    judge(record, "the final model");
    const Summary summary = summarise_run(model, record);
    save(model, record, summary);
    report(summary);
    if (!summary.damage.empty())
      throw io::InputError(summary.damage + "; what was read before it is modelled");
    return summary.violations > 0 || summary.interrupted ? kFallsShort : kDone;
  }

 private:
  static model::Model make_model(const model::Parameters& parameters) {
    try {
      return model::Model(parameters);
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());
    }
  }

  void add_initial(model::Model& model) const {
    try {
      model.add_initial(initial_faces(args_.initial));
    } catch (const std::invalid_argument& error) {
      throw UsageError(args_.initial + ": " + error.what());
    }
  }

  void read_all(model::Model& model, std::int64_t total) {
    Progress progress("modelling", total, args_.quiet);
    const auto start = std::chrono::steady_clock::now();
    std::vector<model::SensorPoint> set;
    while (!interrupted()) {
      read_set(set);
      if (set.empty()) break;
      model.update(set);
      stages_.look(model);
      ++sets_;
      if (args_.check_every > 0 && sets_ % args_.check_every == 0) {
        judge(model.record(), "set " + std::to_string(sets_));
      }
      progress.step(given_);
    }
    interrupted_ = interrupted();
    if (!interrupted_) model.finish();
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() - judging_;
    gaps_.add(given_, scan_.skipped_at_end());
  }

  void read_set(std::vector<model::SensorPoint>& set) {
    set.clear();
    model::SensorPoint point;
    std::int64_t skipped = 0;
    while (static_cast<std::int64_t>(set.size()) < args_.set_size && !interrupted() &&
           scan_.next(point, skipped)) {
      gaps_.add(given_++, skipped);
      set.push_back(point);
      sample_.add(point);
    }
  }

  void judge(const model::ModelRecord& record, const std::string& when) {
    const auto start = std::chrono::steady_clock::now();
    for (const auto& violation : app::judge(record)) {
      if (violations_++ < 20) {
        std::fprintf(stderr, "limpet: broken after %s: %s, %s: %s\n", when.c_str(), violation.law.c_str(),
                     violation.where.c_str(), violation.what.c_str());
      }
    }
    judging_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  Summary summarise_run(const model::Model& model, const model::ModelRecord& record) const {
    Summary summary = summarise(record, model.open_edges());
    summary.refused += scan_.skipped();
    summary.violations = violations_;
    summary.seconds = seconds_;
    summary.axes_guessed = axes_guessed_;
    summary.interrupted = interrupted_;
    if (!interrupted_) summary.damage = scan_.damage();
    return summary;
  }

  void save(const model::Model& model, const model::ModelRecord& record, const Summary& summary) const {
    for (const std::string& path : args_.models) io::save_model(path, record);
    if (args_.stages > 0) stages_.save(args_.models.front(), record);
    if (!args_.labels.empty()) save_text(args_.labels, gaps_.label_lines(model.labels()));
    if (!args_.json.empty()) save_text(args_.json, to_json(summary));
  }

  void report(const Summary& summary) const {
    if (summary.interrupted) {
      std::fprintf(stderr, "limpet: interrupted after %s points; the model so far is written\n",
                   grouped(summary.points).c_str());
    }
    warn_of_density(summary);
    if (args_.quiet) return;
    std::string text = to_text(summary) + "written:";
    for (const std::string& path : args_.models) text += " " + path;
    std::fprintf(for_people(args_), "%s\n", text.c_str());
  }

  void warn_of_density(const Summary& summary) const {
    const Estimate found = estimate(sample_);
    const double density = summary.resolution * summary.resolution / found.area_per_point;
    if (!(found.area_per_point > 0) || density >= kEnoughPoints) return;
    std::fprintf(stderr,
                 "limpet: warning: %.1f points per square of the resolution %.4g are too few for surfaces to "
                 "link up; --resolution %.3g would do\n",
                 density, summary.resolution, suitable_resolution(found, noise_));
  }

  const ModelArguments& args_;
  PointStream scan_;
  Stages stages_;
  Sample sample_;
  Gaps gaps_;
  NoiseArgument noise_;
  std::int64_t given_ = 0;  ///< points handed to the model
  std::int64_t sets_ = 0, violations_ = 0;
  double seconds_ = 0, judging_ = 0;
  bool axes_guessed_ = false, interrupted_ = false;
};

}  // namespace

int run(const ModelArguments& args) {
  require_outputs(args);
  catch_interrupts();
  return Run(args).go();
}

}  // namespace limpet::app
