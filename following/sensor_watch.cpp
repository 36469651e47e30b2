// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/sensor_watch.hpp>

#include <Eigen/Eigenvalues>
#include <stdexcept>

namespace limpet::following {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SensorWatch::SensorWatch(double resolution, std::size_t sensors)
    : least_spread_(resolution / 2), records_(sensors) {
  if (!(resolution > 0)) throw std::invalid_argument("the resolution λ must be positive");
}

bool SensorWatch::is_stuck(std::size_t sensor, const Vector3d& position, std::optional<double> distance) {
  Record& record = records_[sensor];
  if (record.stuck) return true;
  if (distance != record.distance) record = {distance};
  if (!distance) return false;
  ++record.count;
  const Vector3d off = position - record.mean;
  record.mean += off / record.count;
  record.spread += off * (position - record.mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(record.spread / record.count, Eigen::EigenvaluesOnly);
  return record.stuck = axes.eigenvalues()[0] > least_spread_ * least_spread_;
}

std::vector<std::size_t> SensorWatch::stuck() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < records_.size(); ++i)
    if (records_[i].stuck) result.push_back(i);
  return result;
}

}  // namespace limpet::following
