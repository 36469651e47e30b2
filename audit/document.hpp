// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace limpet::audit {

__extension__ typedef __int128 Int128;
using Vector = std::array<double, 3>;

/// How the engine that wrote the file computed; `float` alone is free of the grid.
enum class Arithmetic { kExact, kFloatGrid, kFloat };

/// Number of sensor points, their sums, and their sums of products xx xy xz yy yz zz; in grid steps.
struct Moments {
  std::uint64_t m = 0;
  std::array<Int128, 3> sum{};
  std::array<Int128, 6> product{};
};

/// A sensor point a young segment still holds; its position in grid steps.
struct RawPoint {
  Vector position{};
  Vector axis{};
  std::uint64_t returned = 0;
};

/// What every segment has. A point segment has nothing else.
struct Segment {
  std::uint64_t id = 0;
  Moments moments;
  Vector axis_sum{};
  double variance = 0;  ///< sum over its points; 0 where the noise does not grow
  std::vector<RawPoint> raw;
};

/// A vertex in chart coordinates, and the edge that leaves it.
struct Vertex {
  double x = 0, y = 0;
  std::uint64_t edge = 0;
  std::uint64_t partner = 0;  ///< 0: not shared
};
using Cycle = std::vector<Vertex>;

struct Polygon : Segment {
  Vector origin{}, u{}, v{}, n{};  ///< the chart
  double h0 = 0, hx = 0, hy = 0;   ///< the published plane as a height over the chart
  Vector initial_centroid{}, initial_normal{};
  std::vector<Cycle> cycles;  ///< the outer perimeter, then the holes
};

/// A native model file, as written: nothing in it has been checked but its syntax.
struct Document {
  double resolution = 0, angle = 0, noise = 0, tolerance = 0, step = 0;
  double growth = 0, growth2 = 0;      ///< of the noise with the range and its square
  double quantum = 0;                  ///< to which the scan's coordinates are rounded
  std::uint64_t patience = 1'000'000;  ///< sensor points after which outliers are given up
  std::uint64_t neighbours = 1;        ///< 0: none are formed
  double redundancy_count = 20, redundancy_ratio = 0.05;
  Arithmetic arithmetic = Arithmetic::kExact;
  std::string rules;
  std::uint64_t points = 0, refused = 0, expired = 0, sets = 0;
  std::uint64_t redundant_by_count = 0, redundant_by_position = 0;
  std::uint64_t next_segment = 0, next_edge = 0;
  std::uint64_t declared_points = 0, declared_polygons = 0;
  std::vector<Segment> point_segments;
  std::vector<Polygon> polygons;
};

/// The text is no native model file; `what()` names the line.
class DocumentError : public std::runtime_error {
 public:
  DocumentError(std::size_t line, const std::string& what);
  std::size_t line() const { return line_; }

 private:
  std::size_t line_;
};

/// Reads a native model file (docs/native_format.md). Throws DocumentError.
/// Memory is bounded by the length of the input, whatever its counts claim.
Document parse_document(std::istream& input);
Document parse_document(std::string_view text);

}  // namespace limpet::audit
