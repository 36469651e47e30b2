// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <limpet/io/scan_reader.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace limpet::io {

/// What the columns (properties, fields) of a scan mean, and how a row of numbers becomes a record: the part
/// all formats have in common.
class ScanColumns {
 public:
  enum Role { kX, kY, kZ, kAxisX, kAxisY, kAxisZ, kRange, kLabel, kRoles };
  using Row = std::array<double, kRoles>;

  /// Finds the columns by name. Of several that could be the axis or the label, the first in order of
  /// trust is taken. `where` is for messages. Errors: InputError when x, y or z is missing, or the label
  /// column that `options` name.
  ScanColumns(const std::vector<std::string>& names, const ScanOptions& options, const std::string& where);

  /// Index of the column with this role; -1: none.
  int column(Role role) const { return column_[role]; }

  /// The role of a column; kRoles: none.
  Role role(std::size_t column) const;

  /// Makes the record of a row; false when the row is no point.
  bool make(const Row& row, ScanRecord& record) const;

 private:
  enum class AxisSource { kNone, kAxis, kNormal, kViewpoint };

  void from_viewpoint(model::SensorPoint& point) const;

  AxisSource axis_source_ = AxisSource::kNone;
  std::array<int, kRoles> column_;
  Eigen::Vector3d viewpoint_ = Eigen::Vector3d::Zero();
  bool has_viewpoint_ = false, keep_axisless_ = false;
};

/// Scales `v` to length 1 with + - × ÷ √ alone; false when its length is zero or not finite. A vector whose
/// length is 1 to rounding stays as it is, so that writing and reading again changes nothing.
bool normalise(Eigen::Vector3d& v);

}  // namespace limpet::io
