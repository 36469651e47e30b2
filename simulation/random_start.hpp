// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <limpet/simulation/mesh.hpp>

namespace limpet::simulation {

/// A position at this distance outside a random place of the surface (uniform over its area) and no nearer to
/// any of the rest of it (to a millionth): where a robot can begin to follow it. The first such position that
/// is `good`, if this is asked for. The same mesh, distance and seed give the same position. Throws MeshError
/// when the distance is not positive, the surface has no area, or none is found in many tries, as where the
/// surface is nowhere that far from itself.
Eigen::Vector3d random_start(const Mesh&, double distance, std::uint64_t seed,
                             const std::function<bool(const Eigen::Vector3d&)>& good = {});

/// A rotation, uniform over all; the same seed gives the same one.
Eigen::Quaterniond random_rotation(std::uint64_t seed);

}  // namespace limpet::simulation
