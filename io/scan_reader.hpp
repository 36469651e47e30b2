// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limpet/model/sensor_point.hpp>
#include <memory>
#include <optional>
#include <string>

namespace limpet::io {

/// One reading of a scan.
struct ScanRecord {
  model::SensorPoint point;  ///< scan's unit; the axis is zero when the scan does not tell it
  bool has_axis = false;     ///< the axis is known and has length 1
  std::int64_t label = -1;   ///< what the scan says the point belongs to; -1: nothing, or no whole number
  /// The scan has columns for an axis or a normal, but they say none here (zero, not finite). The axis is
  /// then the one from the viewpoint, if that is known. Only with ScanOptions::keep_axisless.
  bool axisless = false;
};

struct ScanOptions {
  /// Where the sensor stood, scan's unit: gives each point without axis or normal the axis from here to it.
  /// A PCD file's own VIEWPOINT is used where this is empty.
  std::optional<Eigen::Vector3d> viewpoint;
  /// Take no axis, whatever the scan says.
  bool ignore_axes = false;
  /// Give out points whose axis or normal is none (zero, not finite), too.
  bool keep_axisless = false;
  /// Take no axis from columns, but one from the viewpoint.
  bool ignore_axis_columns = false;
  /// Asked while a pipe or a terminal is waited for; true ends the scan there (ByteSource).
  std::function<bool()> stop{};
  /// "ply", "pcd", "xyz" or "pwn"; empty: told by the first bytes, then by the file's extension.
  std::string format{};
  /// The column (property, field) that says which region a point is of; empty: the first that is there of the
  /// names known for it (see ScanColumns). It must be there when named.
  std::string label_column{};
};

/// A scan, read in order, one record at a time, in memory that does not depend on its size (a compressed PCD
/// excepted, which is held whole: packed and unpacked, of which the format allows 4 GiB each).
class ScanReader {
 public:
  virtual ~ScanReader() = default;

  /// The next record that is a point; false at the end. Records that are none (coordinates or axis not
  /// finite, axis of length zero) are counted and passed over. Errors: InputError at structural damage, after
  /// every record before it has been given out.
  virtual bool next(ScanRecord& record) = 0;

  /// Records the file promises; -1 when it does not say.
  virtual std::int64_t promised() const { return -1; }

  /// Records passed over so far.
  std::int64_t skipped() const { return skipped_; }

 protected:
  std::int64_t skipped_ = 0;
};

/// Opens a scan: PLY (ASCII, binary little and big endian), PCD (ASCII, binary, compressed), XYZ
/// (`x y z [nx ny nz]`, or columns named by a comment such as `# x y z ax ay az`) or PWN (`x y z nx ny nz`).
/// `path` "-" is standard input. Text is ASCII or UTF-8, its lines end as ByteSource::line() says, and tables
/// are written as TableDialect says. A first line of names (`"X","Y","Z",...`) names the columns of a table
/// too. Without names, columns four to six are a normal, unless the first point's look like a colour (whole
/// numbers of 0 to 255, one of them above 9). The axis of a point comes from `ax ay az`, else minus the
/// normal, else the direction from the viewpoint; it is left bit for bit where its length is 1 already, and
/// normalised otherwise. Errors: InputError for what cannot be read, a damaged header, an unknown format, or
/// a mesh.
std::unique_ptr<ScanReader> open_scan(const std::string& path, const ScanOptions& options);

}  // namespace limpet::io
