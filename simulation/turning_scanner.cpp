// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/turning_scanner.hpp>

#include <cmath>
#include <complex>
#include <numbers>

namespace limpet::simulation {
namespace {

using Direction = std::complex<double>;  ///< in a plane, of length 1

constexpr double kAround = 2 * std::numbers::pi, kUpwards = std::numbers::pi * 5 / 6;
const Direction kLowest(0.5, -0.8660254037844386);

/// A turn by about `angle`, less by its third power over 12: without trigonometry, so that every machine
/// gives the same bits.
Direction turn_by(double angle) {
  const double half = angle / 2;
  return {(1 - half * half) / (1 + half * half), angle / (1 + half * half)};
}

Direction turned(const Direction& d, const Direction& turn) {
  const Direction product(d.real() * turn.real() - d.imag() * turn.imag(),
                          d.real() * turn.imag() + d.imag() * turn.real());
  return product / std::sqrt(product.real() * product.real() + product.imag() * product.imag());
}

}  // namespace

void TurningScanner::send(double pitch, const Send& send) const {
  const Direction turn = turn_by(pitch);
  for (const Eigen::Vector3d& viewpoint : viewpoints_) {
    Direction around(1, 0);
    for (double angle = 0; angle < kAround; angle += pitch, around = turned(around, turn)) {
      Direction upwards = kLowest;
      for (double height = 0; height < kUpwards; height += pitch, upwards = turned(upwards, turn))
        send(viewpoint, {upwards.real() * around.real(), upwards.real() * around.imag(), upwards.imag()});
    }
  }
}

double TurningScanner::extent() const { return kAround * kUpwards * static_cast<double>(viewpoints_.size()); }

}  // namespace limpet::simulation
