// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/lattice_internal.hpp>

namespace limpet::evaluation {
namespace {

const double kHalfDiagonal = std::sqrt(3.0) / 2;  // of a cell, in pitches

}  // namespace

Lattice::Lattice(const TrueSurface& truth, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                 double clearance, double pitch)
    : low_(low), clearance_(clearance), pitch_(pitch) {
  for (int i = 0; i < 3; ++i) bricks_[i] = static_cast<int>(std::floor((high[i] - low[i]) / (8 * pitch))) + 1;
  const std::size_t count = static_cast<std::size_t>(bricks_.cast<std::int64_t>().prod());
  dense_of_.assign(count, kUniform);
  uniform_.assign(count, 0);
  for (int z = 0; z < bricks_.z(); ++z)
    for (int y = 0; y < bricks_.y(); ++y)
      for (int x = 0; x < bricks_.x(); ++x) fill_brick(truth, 8 * Node(x, y, z));
}

Lattice::Flags Lattice::at_distance(double distance) const {
  Flags flags = 0;
  if (distance >= clearance_) flags |= kPassable;
  if (distance >= clearance_ + pitch_ / 2) flags |= kRoomy;
  if (distance >= clearance_ - kHalfDiagonal * pitch_) flags |= kPossible;
  return flags;
}

void Lattice::fill_brick(const TrueSurface& truth, const Node& first) {
  const double distance = truth.distance(place(first) + Eigen::Vector3d::Constant(3.5 * pitch_));
  const std::size_t brick = static_cast<std::size_t>(brick_index(first));
  const double least = distance - 7 * kHalfDiagonal * pitch_;
  if (least >= clearance_ + pitch_) {
    uniform_[brick] = at_distance(least);
    return;
  }
  dense_of_[brick] = static_cast<std::int32_t>(dense_.size());
  dense_.emplace_back().fill(0);
  fill(truth, first, 8);
}

/// The distance in the middle of a block bounds those of its nodes; where that does not settle their flags,
/// the block is halved.
void Lattice::fill(const TrueSurface& truth, const Node& first, int size) {
  const double middle = (size - 1) / 2.0, reach = (size - 1) * kHalfDiagonal * pitch_;
  const double distance = truth.distance(place(first) + Eigen::Vector3d::Constant(middle * pitch_));
  const Flags least = at_distance(distance - reach), most = at_distance(distance + reach);
  if (least != most) {
    for (int k = 0; k < 8; ++k) fill(truth, first + size / 2 * Node(k & 1, k >> 1 & 1, k >> 2), size / 2);
    return;
  }
  Brick& brick = dense_[static_cast<std::size_t>(dense_of_[static_cast<std::size_t>(brick_index(first))])];
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        brick[static_cast<std::size_t>(inner_index(first + Node(x, y, z)))] = least;
}

Lattice::Node Lattice::nearest(const Eigen::Vector3d& place) const {
  Node node;
  for (int i = 0; i < 3; ++i)
    node[i] = static_cast<int>(
        std::clamp(std::floor((place[i] - low_[i]) / pitch_ + 0.5), 0.0, 8.0 * bricks_[i] - 1));
  return node;
}

Lattice::Flags Lattice::flags(const Node& node) const {
  const std::size_t brick = static_cast<std::size_t>(brick_index(node));
  if (dense_of_[brick] == kUniform) return uniform_[brick];
  return dense_[static_cast<std::size_t>(dense_of_[brick])][static_cast<std::size_t>(inner_index(node))];
}

void Lattice::mark(const Node& node, Flags flag) {
  const std::size_t brick = static_cast<std::size_t>(brick_index(node));
  if (dense_of_[brick] == kUniform)
    uniform_[brick] |= flag;
  else
    dense_[static_cast<std::size_t>(dense_of_[brick])][static_cast<std::size_t>(inner_index(node))] |= flag;
}

void Lattice::leave(const Node& node,
                    const std::function<void(const Node& from, const Node& to)>& visit) const {
  const bool uniform = dense_of_[static_cast<std::size_t>(brick_index(node))] == kUniform;
  const Node first = uniform ? Node(node / 8 * 8) : node;
  const int size = uniform ? 8 : 1;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      for (int k = 0; k < size * size; ++k) {
        Node from = first;
        from[axis] += side * (size - 1);
        from[(axis + 1) % 3] += k % size;
        from[(axis + 2) % 3] += k / size;
        Node to = from;
        to[axis] += 2 * side - 1;
        if (contains(to)) visit(from, to);
      }
    }
  }
}

void Lattice::for_each(const TrueSurface& truth, Flags flag, double within,
                       const std::function<void(const Node&)>& visit) const {
  const double reach = 7 * kHalfDiagonal * pitch_;
  for (int b = 0; b < bricks_.prod(); ++b) {
    const Node first =
        8 * Node(b % bricks_.x(), b / bricks_.x() % bricks_.y(), b / bricks_.x() / bricks_.y());
    if (truth.distance(place(first) + Eigen::Vector3d::Constant(3.5 * pitch_)) - reach > within) continue;
    for (int k = 0; k < 512; ++k)
      if (const Node node = first + Node(k % 8, k / 8 % 8, k / 64); (flags(node) & flag) != 0) visit(node);
  }
}

}  // namespace limpet::evaluation
