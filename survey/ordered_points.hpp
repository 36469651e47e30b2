// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limpet/survey/point_stream.hpp>
#include <memory>
#include <vector>

namespace limpet::survey {

/// How points are put in order before they are modelled.
struct Ordering {
  double cell = 0;  ///< edge of the curve's cells, scan's unit, > 0: the resolution λ suits
  std::size_t memory_bytes = std::size_t{256} << 20;  ///< what lies in memory at most, beyond it on disk
  /// Where there is one, asked now and then whether reading is to end early; nothing is handed out then.
  std::function<bool()> stop{};
};

/// Puts a scan in the order in which it is modelled fastest and best, whatever the order it was scanned in:
/// first a few readings of every cell of the scan, so that all surfaces are there before any of them is full,
/// then as many again, then twice as many, until none is left; each time from cell to cell along a Morton
/// curve, so that neighbours in space come together. Where a scan has few readings in a cell, all of them
/// come at once. Within a cell the order is by chance, with a fixed seed: rows of a raster say nothing of a
/// surface.
///
/// All of the scan is read before its first reading is handed out; what does not fit into the given memory is
/// sorted through temporary files (TemporaryFile). The same scan gives the same order, however much memory
/// there is. See docs/order.md.
class OrderedPoints {
 public:
  /// The next reading in the scan's own order, its place not looked at; false at the end.
  using Source = std::function<bool(Reading&)>;

  OrderedPoints(Source source, Ordering ordering);
  /// The readings that are left of `points`, which has to outlive this.
  OrderedPoints(PointStream& points, Ordering ordering);
  ~OrderedPoints();
  OrderedPoints(OrderedPoints&&) noexcept;
  OrderedPoints& operator=(OrderedPoints&&) noexcept;

  /// The next reading, with its place among the source's; false at the end. The first call reads the source
  /// to its end. Errors: those of the source; io::OutputError when there is no space for temporary files.
  bool next(Reading& reading);

  /// The next set of at most `size` points; false when there is none left. Errors: those of next().
  bool next_set(std::vector<model::SensorPoint>& set, std::size_t size = kSetSize);

  /// Readings read from the source.
  std::int64_t points() const;
  /// Bytes written to temporary files.
  std::int64_t bytes_on_disk() const;

 private:
  class Sorter;
  std::unique_ptr<Sorter> sorter_;
};

}  // namespace limpet::survey
