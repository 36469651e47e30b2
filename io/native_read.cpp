// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <limpet/io/native.hpp>
#include <limpet/io/native_fields_internal.hpp>
#include <stdexcept>
#include <utility>

namespace limpet::io {
namespace {

using internal::Fields;

// Limits of what is read, with their reasons: docs/native_format.md. No sound model comes near them.
constexpr double kFarthestSteps = 0x1p49;  ///< of places, from the world's origin and in a chart
constexpr int kMostExponent = 520;         ///< of the grid step
constexpr double kSteepest = 1;            ///< slope of a published plane over its chart
constexpr double kLongestAxis = 2;         ///< in each coordinate, of what is to be a unit vector

constexpr const char* kTooFar = "farther than 2^49 grid steps";
constexpr const char* kTooSteep = "too steep: a plane is within 45 degrees of its chart";
constexpr const char* kTooLong = "no coordinate of a unit vector";

double single(Fields& in, std::string_view word) {
  in.line(word);
  const double value = in.real();
  in.done();
  return value;
}

model::MomentsRecord read_moments(Fields& in) {
  model::MomentsRecord moments;
  moments.count = in.count();
  for (model::Int128& sum : moments.sum) sum = in.integer<model::Int128>();
  for (model::Int128& product : moments.product) product = in.integer<model::Int128>();
  return moments;
}

std::vector<model::RawPointRecord> read_raw(Fields& in) {
  in.line("raw");
  const std::int64_t count = in.count();
  in.done();
  std::vector<model::RawPointRecord> raw;
  for (std::int64_t i = 0; i < count; ++i) {
    in.line();
    model::RawPointRecord& point = raw.emplace_back();
    for (std::int64_t& coordinate : point.at) {
      coordinate = in.integer<std::int64_t>();
      if (std::abs(static_cast<double>(coordinate)) > kFarthestSteps)
        in.fail("a sensor point is " + std::string(kTooFar));
    }
    point.axis = in.vector_within(kLongestAxis, kTooLong);
    const std::int64_t returned = in.count();
    if (returned > std::numeric_limits<int>::max()) in.fail("a point returned too often");
    point.returned = static_cast<int>(returned);
    in.done();
  }
  return raw;
}

template <class Segment>
Segment begin_segment(Fields& in, std::string_view word) {
  Segment segment;
  in.line(word);
  segment.id = in.integer<std::uint64_t>();
  segment.moments = read_moments(in);
  segment.axis_sum = in.vector();
  in.done();
  if (in.optional_line("variance")) {
    segment.variance_sum = in.real();
    in.done();
  }
  return segment;
}

std::vector<model::VertexRecord> read_cycle(Fields& in) {
  in.line("cycle");
  const std::int64_t count = in.count();
  in.done();
  std::vector<model::VertexRecord> cycle;
  for (std::int64_t i = 0; i < count; ++i) {
    in.line();
    model::VertexRecord& vertex = cycle.emplace_back();
    vertex.x = in.real_within(kFarthestSteps, kTooFar);
    vertex.y = in.real_within(kFarthestSteps, kTooFar);
    vertex.edge = in.integer<std::uint64_t>();
    vertex.partner = in.integer<std::uint64_t>();
    in.done();
  }
  return cycle;
}

void read_planes(Fields& in, double step, model::PolygonSegmentRecord& segment) {
  const double farthest = kFarthestSteps * step;
  in.line("chart");
  segment.chart_origin = in.vector_within(farthest, kTooFar);
  segment.chart_u = in.vector_within(kLongestAxis, kTooLong);
  segment.chart_v = in.vector_within(kLongestAxis, kTooLong);
  segment.chart_normal = in.vector_within(kLongestAxis, kTooLong);
  in.done();
  in.line("height");
  segment.height[0] = in.real_within(kFarthestSteps, kTooFar);
  segment.height[1] = in.real_within(kSteepest, kTooSteep);
  segment.height[2] = in.real_within(kSteepest, kTooSteep);
  in.done();
  in.line("initial");
  segment.initial_centroid = in.vector_within(farthest, kTooFar);
  segment.initial_normal = in.vector_within(kLongestAxis, kTooLong);
  in.done();
}

model::PolygonSegmentRecord read_polygon(Fields& in, double step) {
  auto segment = begin_segment<model::PolygonSegmentRecord>(in, "polygon");
  read_planes(in, step, segment);
  if (in.optional_line("confirmed")) {
    segment.confirmed = in.count();
    in.done();
  }
  in.line("cycles");
  const std::int64_t cycles = in.count();
  in.done();
  for (std::int64_t i = 0; i < cycles; ++i) segment.cycles.push_back(read_cycle(in));
  segment.raw = read_raw(in);
  return segment;
}

void read_version(Fields& in) {
  in.line("limpet");
  if (const std::string version = in.word(); version == "checkpoint") {
    in.fail("this is the checkpoint of a run, not a model; 'limpet model' goes on from it with --resume");
  } else if (version != "1") {
    in.fail("version " + in_quotes(version) + " of the format is not known (this program reads version 1)");
  }
  in.done();
}

/// How λ grows with the distance to the nearest of some places.
void read_widening(Fields& in, model::Parameters& p) {
  p.resolution_per_range = in.real();
  const std::int64_t sensors = in.count();
  if (sensors < 1 || sensors > std::int64_t{model::kMostSensors})
    in.fail("the resolution grows from 1 to 64 places");
  in.done();
  for (std::int64_t i = 0; i < sensors; ++i) {
    in.line("sensor");
    Eigen::Vector3d& at = p.sensors.emplace_back();
    at.x() = in.real(), at.y() = in.real(), at.z() = in.real();
    in.done();
  }
}

/// The parameters except the rules, which come later. Those that the file leaves out keep their usual values.
void read_parameters(Fields& in, model::Parameters& p) {
  p.resolution = single(in, "resolution");
  if (in.optional_line("widening")) read_widening(in, p);
  p.angle_rad = single(in, "angle");
  p.noise = single(in, "noise");
  p.tolerance = single(in, "tolerance");
  if (in.optional_line("growth")) {
    p.noise_per_range = in.real();
    p.noise_per_range2 = in.real();
    in.done();
  }
  if (in.optional_line("quantum")) {
    p.input_quantum = in.real();
    in.done();
  }
  if (in.optional_line("patience")) {
    p.outlier_patience = in.count();
    in.done();
  }
  if (in.optional_line("neighbours")) {
    const std::int64_t formed = in.count();
    if (formed > 1) in.fail("neighbours are formed (1) or not (0)");
    p.neighbours = formed == 1;
    p.redundancy_count = in.real();
    p.redundancy_ratio = in.real();
    in.done();
  }
}

double read_grid(Fields& in) {
  const double step = single(in, "grid");
  int exponent = 0;
  if (!(step > 0) || std::frexp(step, &exponent) != 0.5) in.fail("the grid step is not a power of two");
  if (std::abs(exponent) > kMostExponent) in.fail("the grid step is none that a model has");
  return step;
}

std::string read_arithmetic(Fields& in) {
  in.line("arithmetic");
  const std::string arithmetic = in.word();
  in.done();
  if (arithmetic != "exact" && arithmetic != "float-grid" && arithmetic != "float") {
    in.fail("the arithmetic " + in_quotes(arithmetic) + " is not one of exact, float-grid, float");
  }
  return arithmetic;
}

/// The names have to be in the order in which they are written, so that a file reads and writes back to the
/// same bytes.
model::Rules read_rules(Fields& in) {
  in.line("rules");
  const std::string names = in.word();
  in.done();
  try {
    const model::Rules rules = model::Rules::parse(names);
    if (rules.to_string() == names) return rules;
  } catch (const std::invalid_argument&) {
    in.fail("the rules " + in_quotes(names) + " are not all known to this program");
  }
  in.fail("the rules " + in_quotes(names) + " are not in the order in which a model file names them");
}

void read_head(Fields& in, model::ModelRecord& model) {
  read_version(in);
  read_parameters(in, model.parameters);
  model.grid_step = read_grid(in);
  model.arithmetic = read_arithmetic(in);
  model.parameters.rules = read_rules(in);
  in.line("counts");
  model.points = in.count();
  model.refused = in.count();
  model.expired = in.count();
  model.sets = in.count();
  in.done();
  if (in.optional_line("redundant")) {
    model.redundant_by_count = in.count();
    model.redundant_by_position = in.count();
    in.done();
  }
  in.line("next");
  model.next_segment = in.integer<std::uint64_t>();
  model.next_edge = in.integer<std::uint64_t>();
  in.done();
}

}  // namespace

model::ModelRecord read_native(std::istream& stream, const std::string& name) {
  if (stream.peek() == std::istream::traits_type::eof()) throw InputError(name, "the file is empty");
  Fields in(stream, name);
  model::ModelRecord model;
  read_head(in, model);
  in.line("segments");
  const std::int64_t points = in.count(), polygons = in.count();
  in.done();
  for (std::int64_t i = 0; i < points; ++i) {
    auto& segment = model.point_segments.emplace_back(begin_segment<model::PointSegmentRecord>(in, "point"));
    segment.raw = read_raw(in);
  }
  for (std::int64_t i = 0; i < polygons; ++i)
    model.polygon_segments.push_back(read_polygon(in, model.grid_step));
  in.line("end");
  in.done();
  in.nothing_more();
  return model;
}

model::ModelRecord load_native(const std::string& path) {
  if (path == "-") return read_native(std::cin, "standard input");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path, "cannot be opened; is the name right?");
  stream.peek();
  if (stream.bad()) throw InputError(path, "cannot be read; is it a folder?");
  return read_native(stream, path);
}

}  // namespace limpet::io
