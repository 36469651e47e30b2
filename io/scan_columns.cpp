// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/io/error.hpp>
#include <limpet/io/scan_columns.hpp>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

int find(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

constexpr std::array<std::string_view, 15> kLabelNames = {
    "face",        "label",          "segment_index",  "segment",      "plane",
    "plane_index", "shape_index",    "scalar_label",   "scalar_Label", "region",
    "class",       "classification", "Classification", "scalar_class", "scalar_Classification"};

int find_label(const std::vector<std::string>& names) {
  for (const std::string_view name : kLabelNames) {
    if (const int column = find(names, name); column >= 0) return column;
  }
  return -1;
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    if (!name.empty() && list.size() < 200) list += " " + name;
  }
  return list;
}

/// The length of a vector, even where its square is beyond what doubles hold.
double length(const Eigen::Vector3d& v) {
  const double squared = v.dot(v);
  return squared < std::numeric_limits<double>::infinity() ? std::sqrt(squared) : v.stableNorm();
}

}  // namespace

bool normalise(Eigen::Vector3d& v) {
  const double largest = std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  if (!v.allFinite() || largest == 0) return false;
  const double squared = v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
  if (std::abs(squared - 1) <= 1e-15) return true;
  v /= largest;  // so that no square over- or underflows
  v /= std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
  return true;
}

ScanColumns::ScanColumns(const std::vector<std::string>& names, const ScanOptions& options,
                         const std::string& where) {
  column_.fill(-1);
  for (const auto& [role, name] : {std::pair{kX, "x"}, {kY, "y"}, {kZ, "z"}}) {
    column_[role] = find(names, name);
    if (column_[role] < 0) throw InputError(where, std::string("the points have no ") + name);
  }
  const auto axis_columns = [&](std::string_view x, std::string_view y, std::string_view z) {
    const std::array<int, 3> found = {find(names, x), find(names, y), find(names, z)};
    if (found[0] < 0 || found[1] < 0 || found[2] < 0) return false;
    std::copy(found.begin(), found.end(), column_.begin() + kAxisX);
    return true;
  };
  keep_axisless_ = options.keep_axisless;
  if (options.viewpoint) viewpoint_ = *options.viewpoint;
  has_viewpoint_ = options.viewpoint && !options.ignore_axes;
  if (options.ignore_axes) {
    axis_source_ = AxisSource::kNone;
  } else if (options.ignore_axis_columns) {
    axis_source_ = has_viewpoint_ ? AxisSource::kViewpoint : AxisSource::kNone;
  } else if (axis_columns("ax", "ay", "az")) {
    axis_source_ = AxisSource::kAxis;
    column_[kRange] = find(names, "range");
  } else if (axis_columns("nx", "ny", "nz") || axis_columns("normal_x", "normal_y", "normal_z")) {
    axis_source_ = AxisSource::kNormal;
  } else if (options.viewpoint) {
    axis_source_ = AxisSource::kViewpoint;
  }
  if (options.label_column.empty()) {
    column_[kLabel] = find_label(names);
    return;
  }
  column_[kLabel] = find(names, options.label_column);
  if (column_[kLabel] < 0) {
    throw InputError(where,
                     "the points have no " + in_quotes(options.label_column) + "; they have" + listed(names));
  }
  if (role(static_cast<std::size_t>(column_[kLabel])) != kLabel) {
    throw InputError(where, in_quotes(options.label_column) + " is a coordinate, not a label");
  }
}

ScanColumns::Role ScanColumns::role(std::size_t column) const {
  const auto found = std::find(column_.begin(), column_.end(), static_cast<int>(column));
  return static_cast<Role>(found - column_.begin());
}

void ScanColumns::from_viewpoint(model::SensorPoint& point) const {
  point.axis = point.position - viewpoint_;
  point.range = length(point.axis);
}

bool ScanColumns::make(const Row& row, ScanRecord& record) const {
  Eigen::Vector3d& p = record.point.position;
  Eigen::Vector3d& a = record.point.axis;
  p = {row[kX], row[kY], row[kZ]};
  if (!p.allFinite()) return false;
  record.point.range = 0;
  record.has_axis = axis_source_ != AxisSource::kNone;
  record.axisless = false;
  switch (axis_source_) {
    case AxisSource::kNone:
      a.setZero();
      break;
    case AxisSource::kAxis:
      a = {row[kAxisX], row[kAxisY], row[kAxisZ]};
      // What is no distance says nothing.
      if (column_[kRange] >= 0 && row[kRange] > 0 && std::isfinite(row[kRange]))
        record.point.range = row[kRange];
      break;
    case AxisSource::kNormal:
      a = {0 - row[kAxisX], 0 - row[kAxisY], 0 - row[kAxisZ]};
      break;
    case AxisSource::kViewpoint:
      from_viewpoint(record.point);
      break;
  }
  if (record.has_axis && !normalise(a)) {
    if (!keep_axisless_ || axis_source_ == AxisSource::kViewpoint) return false;
    record.axisless = true;
    record.has_axis = has_viewpoint_;
    a.setZero();
    if (has_viewpoint_ && (from_viewpoint(record.point), !normalise(a))) return false;
  }
  record.label = -1;
  if (column_[kLabel] >= 0) {
    constexpr double kExact = 9007199254740992.0;  // 2⁵³
    const double label = row[kLabel];
    if (label > -kExact && label < kExact && std::floor(label) == label) {
      record.label = static_cast<std::int64_t>(label);
    }
  }
  return true;
}

}  // namespace limpet::io
