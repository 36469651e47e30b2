// Copyright the limpet authors. GPL-3.0-or-later.
#include "cloud.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

#include "scan_case.hpp"

namespace limpet::benchmarks {
namespace {

using simulation::LabelledPoint;
using simulation::ScanOptions;

/// A point in the file: position, sensing axis, index of the face.
using Record = std::array<double, 7>;

ScanOptions::Order order_of(const std::string& name) {
  if (name == "raster") return ScanOptions::Order::raster;
  if (name == "shuffled") return ScanOptions::Order::shuffled;
  if (name == "sampled") return ScanOptions::Order::sampled;
  throw std::invalid_argument("no such order: " + name);
}

}  // namespace

ScanCase::ScanCase(const CloudSpec& s)
    : spec(s), scene(simulation::make_scene(s.shape)), faces(simulation::faces_of(scene.mesh)) {
  const double area = area_of(scene.mesh);
  noise = spec.noise_ratio * size_of(spec.shape, scene.mesh, scene.feature);
  spacing = benchmarks::spacing(area, spec.points);
  resolution = benchmarks::resolution(
      scene.feature, area, spec.points_for_resolution > 0 ? spec.points_for_resolution : spec.points);
  double smallest = area;
  for (const auto& face : faces) smallest = std::min(smallest, face.area);
  smallest_face_points = smallest / area * static_cast<double>(spec.points);
}

model::Parameters ScanCase::parameters() const {
  model::Parameters parameters;
  parameters.resolution = resolution;
  parameters.noise = noise;
  return parameters;
}

void ScanCase::scan(const std::function<void(const LabelledPoint&)>& take) const {
  ScanOptions options;
  options.points = spec.points;
  options.order = order_of(spec.order);
  options.noise = noise;
  options.outliers = spec.outliers;
  options.seed = spec.seed;
  options.viewpoints = scene.viewpoints;
  simulation::scan(scene.mesh, options, take);
}

std::int64_t write_cloud(const ScanCase& scan_case, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  std::int64_t count = 0;
  scan_case.scan([&](const LabelledPoint& p) {
    const auto &at = p.point.position, &axis = p.point.axis;
    const Record record{at.x(), at.y(), at.z(), axis.x(), axis.y(), axis.z(), static_cast<double>(p.face)};
    file.write(reinterpret_cast<const char*>(record.data()), sizeof record);
    ++count;
  });
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
  return count;
}

CloudReader::CloudReader(const std::string& path) : file_(path, std::ios::binary) {
  if (!file_) throw std::runtime_error("cannot read " + path);
}

std::span<const LabelledPoint> CloudReader::next(std::size_t most) {
  bytes_.resize(most * sizeof(Record));
  file_.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
  points_.resize(static_cast<std::size_t>(file_.gcount()) / sizeof(Record));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Record r;
    std::memcpy(r.data(), bytes_.data() + i * sizeof r, sizeof r);
    points_[i] = {{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}}, static_cast<int>(r[6])};
  }
  return points_;
}

}  // namespace limpet::benchmarks
