// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <charconv>
#include <limpet/audit/document.hpp>
#include <sstream>
#include <type_traits>
#include <vector>

namespace limpet::audit {
namespace {

// A decimal number with an optional minus sign, anywhere in the range of a signed 128-bit integer.
bool read_number(std::string_view text, Int128& value) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (text.empty()) return false;
  value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return false;
    const Int128 digit = negative ? '0' - c : c - '0';
    if (__builtin_mul_overflow(value, Int128{10}, &value)) return false;
    if (__builtin_add_overflow(value, digit, &value)) return false;
  }
  return true;
}

template <typename Number>
bool read_number(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

class Reader {
 public:
  explicit Reader(std::istream& input) : input_(input), line_(kLongestLine + 1) { advance(); }

  std::string_view line() const { return {line_.data(), length_}; }

  // The first word of the current line.
  std::string_view keyword() const { return fields_.front(); }

  // Checks the line's keyword and reads its fields; an empty `name` is for lines without a keyword.
  template <typename... Fields>
  void take(std::string_view name, Fields&... fields) {
    next_field_ = 0;
    if (!name.empty() && take_text() != name) fail("expected '" + std::string(name) + "'");
    (take_field(fields), ...);
    if (next_field_ != fields_.size()) fail("too many fields");
    advance();
  }

  void take_end() {
    if (fields_.size() != 1 || keyword() != "end") fail("expected 'point', 'polygon' or 'end'");
    if (input_.peek() != std::istream::traits_type::eof()) {
      ++line_number_;
      fail("nothing may follow 'end'");
    }
  }

  [[noreturn]] void fail(const std::string& what) const { throw DocumentError(line_number_, what); }

 private:
  void read_line() {
    input_.getline(line_.data(), static_cast<std::streamsize>(line_.size()));
    const auto taken = static_cast<std::size_t>(input_.gcount());
    if (taken == 0) fail("the file ends early");
    if (input_.eof())
      length_ = taken;  // the last line, which has no end
    else if (input_.fail())
      fail("a line of more than 1 MiB");
    else
      length_ = taken - 1;
  }

  void advance() {
    do {
      ++line_number_;
      read_line();
    } while (line().starts_with('#'));
    fields_.clear();
    const std::string_view line = this->line();
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(' ', begin), line.size());
      if (end == begin) fail(line.empty() ? "empty line" : "empty field");
      fields_.push_back(line.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  std::string_view take_text() {
    if (next_field_ == fields_.size()) fail("too few fields");
    return fields_[next_field_++];
  }

  void take_field(std::string& value) { value = take_text(); }
  void take_field(Vector& value) {
    for (double& x : value) take_field(x);
  }
  void take_field(Moments& value) {
    take_field(value.m);
    for (Int128& x : value.sum) take_field(x);
    for (Int128& x : value.product) take_field(x);
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number> || std::is_same_v<Number, Int128>
  void take_field(Number& value) {
    const std::string_view text = take_text();
    if (!read_number(text, value)) fail("bad number '" + std::string(text.substr(0, 60)) + "'");
  }

  std::istream& input_;
  std::vector<char> line_;  // its first length_ bytes
  std::size_t length_ = 0;
  std::vector<std::string_view> fields_;
  std::size_t next_field_ = 0;
  std::size_t line_number_ = 0;
};

Arithmetic arithmetic_of(const std::string& name, const Reader& reader) {
  if (name == "exact") return Arithmetic::kExact;
  if (name == "float-grid") return Arithmetic::kFloatGrid;
  if (name == "float") return Arithmetic::kFloat;
  reader.fail("unknown arithmetic '" + name.substr(0, 60) + "'");
}

void read_header(Reader& reader, Document& document) {
  if (reader.line().starts_with("limpet checkpoint "))
    reader.fail("this is the checkpoint of a run, not a model");
  if (reader.line() != "limpet 1") reader.fail("unknown version, or no model at all");
  std::uint64_t version = 0;
  reader.take("limpet", version);
  reader.take("resolution", document.resolution);
  if (reader.keyword() == "widening") {
    std::uint64_t sensors = 0;
    reader.take("widening", document.widening, sensors);
    for (std::uint64_t i = 0; i < sensors; ++i) {
      Vector at{};
      reader.take("sensor", at);
      document.sensors.push_back(at);
    }
  }
  reader.take("angle", document.angle);
  reader.take("noise", document.noise);
  reader.take("tolerance", document.tolerance);
  if (reader.keyword() == "growth") reader.take("growth", document.growth, document.growth2);
  if (reader.keyword() == "quantum") reader.take("quantum", document.quantum);
  if (reader.keyword() == "patience") reader.take("patience", document.patience);
  if (reader.keyword() == "neighbours")
    reader.take("neighbours", document.neighbours, document.redundancy_count, document.redundancy_ratio);
  reader.take("grid", document.step);
  std::string arithmetic;
  reader.take("arithmetic", arithmetic);
  document.arithmetic = arithmetic_of(arithmetic, reader);
  reader.take("rules", document.rules);
  reader.take("counts", document.points, document.refused, document.expired, document.sets);
  if (reader.keyword() == "redundant")
    reader.take("redundant", document.redundant_by_count, document.redundant_by_position);
  reader.take("next", document.next_segment, document.next_edge);
  reader.take("segments", document.declared_points, document.declared_polygons);
}

// The declared count is not trusted: memory grows with the lines that are there, nothing is reserved ahead.
void read_raw(Reader& reader, Segment& segment) {
  std::uint64_t count = 0;
  reader.take("raw", count);
  for (std::uint64_t i = 0; i < count; ++i) {
    RawPoint point;
    reader.take("", point.position, point.axis, point.returned);
    segment.raw.push_back(point);
  }
}

void read_segment(Reader& reader, std::string_view keyword, Segment& segment) {
  reader.take(keyword, segment.id, segment.moments, segment.axis_sum);
  if (reader.keyword() == "variance") reader.take("variance", segment.variance);
}

void read_cycles(Reader& reader, Polygon& polygon) {
  std::uint64_t cycles = 0;
  reader.take("cycles", cycles);
  for (std::uint64_t i = 0; i < cycles; ++i) {
    std::uint64_t vertices = 0;
    reader.take("cycle", vertices);
    Cycle& cycle = polygon.cycles.emplace_back();
    for (std::uint64_t j = 0; j < vertices; ++j) {
      Vertex vertex;
      reader.take("", vertex.x, vertex.y, vertex.edge, vertex.partner);
      cycle.push_back(vertex);
    }
  }
}

void read_polygon(Reader& reader, Polygon& polygon) {
  read_segment(reader, "polygon", polygon);
  reader.take("chart", polygon.origin, polygon.u, polygon.v, polygon.n);
  reader.take("height", polygon.h0, polygon.hx, polygon.hy);
  reader.take("initial", polygon.initial_centroid, polygon.initial_normal);
  if (reader.keyword() == "confirmed") reader.take("confirmed", polygon.confirmed);
  read_cycles(reader, polygon);
  read_raw(reader, polygon);
}

}  // namespace

DocumentError::DocumentError(std::size_t line, const std::string& what)
    : std::runtime_error("line " + std::to_string(line) + ": " + what), line_(line) {}

Document parse_document(std::istream& input) {
  Reader reader(input);
  Document document;
  read_header(reader, document);
  for (;;) {
    if (reader.keyword() == "point") {
      Segment& segment = document.point_segments.emplace_back();
      read_segment(reader, "point", segment);
      read_raw(reader, segment);
    } else if (reader.keyword() == "polygon") {
      read_polygon(reader, document.polygons.emplace_back());
    } else {
      reader.take_end();
      return document;
    }
  }
}

Document parse_document(std::string_view text) {
  std::istringstream input{std::string(text)};
  return parse_document(input);
}

}  // namespace limpet::audit
