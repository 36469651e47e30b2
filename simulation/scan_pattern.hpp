// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/ray_caster.hpp>

namespace limpet::simulation {

/// The rays of a scanner, in the order in which it sends them, and what of a mesh they meet.
class ScanPattern {
 public:
  using Take = std::function<void(const RayCaster::Hit&, const Eigen::Vector3d& direction)>;

  explicit ScanPattern(const Mesh& mesh) : caster_(mesh) {}
  virtual ~ScanPattern() = default;

  /// All hits of rays that are `pitch` from their neighbours.
  void sweep(double pitch, const Take& take) const;

  /// A pitch that gives about so many hits. Throws MeshError if no viewpoint sees the surface.
  double pitch_for(std::int64_t points) const;

 protected:
  using Send = std::function<void(const Eigen::Vector3d& source, const Eigen::Vector3d& direction)>;

  virtual void send(double pitch, const Send&) const = 0;
  /// The number of rays times the square of their pitch.
  virtual double extent() const = 0;

 private:
  std::int64_t count(double pitch) const;

  RayCaster caster_;
};

}  // namespace limpet::simulation
