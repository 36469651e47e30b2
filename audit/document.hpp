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

/// The arithmetic of the engine that wrote the file. Only with `float` are coordinates not on the grid.
enum class Arithmetic { kExact, kFloatGrid, kFloat };

/// Moments of the sensor points a segment represents: their number, the sums of their coordinates, and the
/// sums of the products xx xy xz yy yz zz; in grid steps.
struct Moments {
  std::uint64_t m = 0;
  std::array<Int128, 3> sum{};
  std::array<Int128, 6> product{};
};

/// A sensor point that a young segment still keeps.
struct RawPoint {
  Vector position{};           ///< in grid steps
  Vector axis{};               ///< unit vector of the sensing axis, into the surface
  std::uint64_t returned = 0;  ///< how often a dissolved segment has handed it back
};

/// What segments of both kinds have; a point segment has nothing else.
struct Segment {
  std::uint64_t id = 0;
  Moments moments;
  Vector axis_sum{};
  double variance = 0;  ///< sum over its points; 0 where the noise does not grow with the range
  std::vector<RawPoint> raw;
};

/// A vertex in chart coordinates, in grid steps, and the edge that leaves it.
struct Vertex {
  double x = 0, y = 0;
  std::uint64_t edge = 0;
  std::uint64_t partner = 0;  ///< 0: not shared
};
using Cycle = std::vector<Vertex>;

struct Polygon : Segment {
  Vector origin{}, u{}, v{}, n{};  ///< the chart
  /// The published plane as a height map over the chart: h0 + hx·x + hy·y, in grid steps.
  double h0 = 0, hx = 0, hy = 0;
  Vector initial_centroid{}, initial_normal{};
  std::uint64_t confirmed = 0;  ///< sensor points that lie on it, and are not among its data
  std::vector<Cycle> cycles;    ///< the outer perimeter, then the holes
};

/// A native model file as parsed: only its syntax has been checked.
struct Document {
  double resolution = 0, angle = 0, noise = 0, tolerance = 0, step = 0;
  double widening = 0;                                    ///< of the resolution with the range
  std::vector<Vector> sensors;                            ///< from the nearest of which that counts
  double growth = 0, growth2 = 0;                         ///< of the noise with the range and with its square
  double quantum = 0;                                     ///< to which the scan's coordinates are rounded
  std::uint64_t patience = 1'000'000;                     ///< sensor points after which outliers are given up
  std::uint64_t neighbours = 1;                           ///< 1: shared edges are formed, 0: they are not
  double redundancy_count = 20, redundancy_ratio = 0.05;  ///< ψ and φ (thesis §2.9)
  Arithmetic arithmetic = Arithmetic::kExact;
  std::string rules;
  std::uint64_t points = 0, refused = 0, expired = 0, sets = 0;
  std::uint64_t redundant_by_count = 0, redundant_by_position = 0;
  std::uint64_t next_segment = 0, next_edge = 0;
  std::uint64_t declared_points = 0, declared_polygons = 0;
  std::vector<Segment> point_segments;
  std::vector<Polygon> polygons;
};

/// The text is not a native model file; what() names the line and the reason.
class DocumentError : public std::runtime_error {
 public:
  DocumentError(std::size_t line, const std::string& what);
  std::size_t line() const { return line_; }

 private:
  std::size_t line_;
};

/// Bytes of the longest line that is read. No line of a model comes near it; without a limit an endless line
/// would be read until memory is full.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// Parses a native model file (docs/native_format.md). Throws DocumentError, also for a line of more than
/// 1 MiB. Memory use is proportional to the length of the input, whatever counts it claims.
Document parse_document(std::istream& input);
Document parse_document(std::string_view text);

}  // namespace limpet::audit
