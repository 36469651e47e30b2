// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/error.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/io/text.hpp>
#include <ostream>
#include <stdexcept>

namespace limpet::io {
namespace {

constexpr std::size_t kFlushBytes = 1 << 20;
const model::Parameters kUsual;  ///< the lines of a file that would say these are left out

/// One line: a word, then fields. Ends itself.
class Line {
 public:
  explicit Line(std::string& text) : text_(text) {}
  Line(std::string& text, std::string_view word) : text_(text), first_(false) { text_ += word; }
  ~Line() { text_ += '\n'; }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  template <class Number>
  Line& operator<<(Number value) {
    separate();
    append(text_, value);
    return *this;
  }
  Line& operator<<(const Eigen::Vector3d& v) { return *this << v.x() << v.y() << v.z(); }
  Line& operator<<(const model::MomentsRecord& moments) {
    *this << moments.count;
    for (const model::Int128 sum : moments.sum) *this << sum;
    for (const model::Int128 product : moments.product) *this << product;
    return *this;
  }

 private:
  void separate() {
    if (!first_) text_ += ' ';
    first_ = false;
  }
  std::string& text_;
  bool first_ = true;
};

const std::string& word(const std::string& text, const char* what) {
  if (text.empty() || text.find_first_of(" \n") != std::string::npos) {
    throw std::invalid_argument(std::string("a native model file cannot hold the ") + what + " '" + text +
                                "'");
  }
  return text;
}

void write_raw(std::string& text, const std::vector<model::RawPointRecord>& raw) {
  Line(text, "raw") << static_cast<std::uint64_t>(raw.size());
  for (const model::RawPointRecord& point : raw) {
    Line(text) << point.at[0] << point.at[1] << point.at[2] << point.axis
               << static_cast<std::int64_t>(point.returned);
  }
}

/// Where the noise is the same everywhere it says nothing and is left out.
void write_variance(std::string& text, double sum) {
  if (sum != 0) Line(text, "variance") << sum;
}

void write_segment(std::string& text, const model::PointSegmentRecord& segment) {
  Line(text, "point") << segment.id << segment.moments << segment.axis_sum;
  write_variance(text, segment.variance_sum);
  write_raw(text, segment.raw);
}

void write_segment(std::string& text, const model::PolygonSegmentRecord& segment) {
  Line(text, "polygon") << segment.id << segment.moments << segment.axis_sum;
  write_variance(text, segment.variance_sum);
  Line(text, "chart") << segment.chart_origin << segment.chart_u << segment.chart_v << segment.chart_normal;
  Line(text, "height") << segment.height[0] << segment.height[1] << segment.height[2];
  Line(text, "initial") << segment.initial_centroid << segment.initial_normal;
  if (segment.confirmed > 0) Line(text, "confirmed") << segment.confirmed;
  Line(text, "cycles") << static_cast<std::uint64_t>(segment.cycles.size());
  for (const auto& cycle : segment.cycles) {
    Line(text, "cycle") << static_cast<std::uint64_t>(cycle.size());
    for (const model::VertexRecord& vertex : cycle) {
      Line(text) << vertex.x << vertex.y << vertex.edge << vertex.partner;
    }
  }
  write_raw(text, segment.raw);
}

void write_head(std::string& text, const model::ModelRecord& model) {
  text += "limpet 1\n";
  const model::Parameters& p = model.parameters;
  Line(text, "resolution") << p.resolution;
  if (p.resolution_per_range > 0) {
    Line(text, "widening") << p.resolution_per_range << static_cast<std::uint64_t>(p.sensors.size());
    for (const Eigen::Vector3d& at : p.sensors) Line(text, "sensor") << at.x() << at.y() << at.z();
  }
  Line(text, "angle") << p.angle_rad;
  Line(text, "noise") << p.noise;
  Line(text, "tolerance") << p.tolerance;
  if (p.noise_per_range > 0 || p.noise_per_range2 > 0)
    Line(text, "growth") << p.noise_per_range << p.noise_per_range2;
  if (p.input_quantum != kUsual.input_quantum) Line(text, "quantum") << p.input_quantum;
  if (p.outlier_patience != kUsual.outlier_patience) Line(text, "patience") << p.outlier_patience;
  if (!p.neighbours || p.redundancy_count != kUsual.redundancy_count ||
      p.redundancy_ratio != kUsual.redundancy_ratio)
    Line(text, "neighbours") << std::int64_t{p.neighbours} << p.redundancy_count << p.redundancy_ratio;
  Line(text, "grid") << model.grid_step;
  text += "arithmetic " + word(model.arithmetic, "arithmetic") + "\n";
  text += "rules " + p.rules.to_string() + "\n";
  Line(text, "counts") << model.points << model.refused << model.expired << model.sets;
  if (model.redundant_by_count + model.redundant_by_position > 0)
    Line(text, "redundant") << model.redundant_by_count << model.redundant_by_position;
  Line(text, "next") << model.next_segment << model.next_edge;
  Line(text, "segments") << static_cast<std::uint64_t>(model.point_segments.size())
                         << static_cast<std::uint64_t>(model.polygon_segments.size());
}

/// Hands `put` the file piece by piece, so a large model is never held twice.
template <class Put>
void write_pieces(const model::ModelRecord& model, Put put) {
  std::string text;
  write_head(text, model);
  const auto spill = [&](std::size_t limit) {
    if (text.size() < limit) return;
    put(text);
    text.clear();
  };
  for (const auto& segment : model.point_segments) {
    write_segment(text, segment);
    spill(kFlushBytes);
  }
  for (const auto& segment : model.polygon_segments) {
    write_segment(text, segment);
    spill(kFlushBytes);
  }
  text += "end\n";
  spill(0);
}

}  // namespace

void write_native(std::ostream& stream, const model::ModelRecord& model) {
  write_pieces(model, [&](const std::string& text) {
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  });
}

void save_native(const std::string& path, const model::ModelRecord& model) {
  OutputFile file(path);
  write_pieces(model, [&](const std::string& text) { file.write(text); });
  file.close();
}

}  // namespace limpet::io
