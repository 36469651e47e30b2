// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <limpet/kinematics/quadratic_program.hpp>
#include <limpet/survey/random.hpp>

/// Quadratic programmes at random, and what makes a solution one.
namespace limpet::kinematics::testing {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using survey::Random;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// How many programmes a test tries: as the environment says, else so many.
inline std::uint64_t wanted_programs(std::uint64_t otherwise) {
  const char* text = std::getenv("LIMPET_QUADRATIC_PROGRAMS");
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

inline Index index_below(Random& random, Index count) {
  return static_cast<Index>(random.below(static_cast<std::uint64_t>(count)));
}

inline MatrixXd normal_matrix(Random& random, Index rows, Index columns) {
  MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = random.normal();
  return matrix;
}

/// Integers from −reach to reach.
inline MatrixXd integer_matrix(Random& random, Index rows, Index columns, int reach) {
  MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped())
    value = static_cast<double>(index_below(random, 2 * reach + 1) - reach);
  return matrix;
}

inline QuadraticProgram without_constraints(const MatrixXd& hessian, const VectorXd& gradient) {
  QuadraticProgram p;
  p.hessian = hessian;
  p.gradient = gradient;
  return p;
}

inline void require(QuadraticProgram& p, const VectorXd& normal, double b) {
  const Index row = p.inequality_vector.size();
  p.inequality_matrix.conservativeResize(row + 1, normal.size());
  p.inequality_matrix.row(row) = normal.transpose();
  p.inequality_vector.conservativeResize(row + 1);
  p.inequality_vector[row] = b;
}

inline void require_equal(QuadraticProgram& p, const VectorXd& normal, double b) {
  const Index row = p.equality_vector.size();
  p.equality_matrix.conservativeResize(row + 1, normal.size());
  p.equality_matrix.row(row) = normal.transpose();
  p.equality_vector.conservativeResize(row + 1);
  p.equality_vector[row] = b;
}

inline QuadraticSolution solved(const QuadraticProgram& p) { return QuadraticSolver().solve(p); }

/// Met by the point, by some constraints with equality, so that more than n may meet there.
inline QuadraticProgram feasible_program(Random& random, VectorXd& point) {
  const Index n = 1 + index_below(random, 12), e = index_below(random, n), m = index_below(random, 200);
  const MatrixXd root = normal_matrix(random, n, n);
  const MatrixXd hessian = root.transpose() * root + 0.01 * MatrixXd::Identity(n, n);
  QuadraticProgram p = without_constraints(hessian, 10 * normal_matrix(random, n, 1));
  point = normal_matrix(random, n, 1);
  const auto room = [&] { return random.below(3) == 0 ? 0 : random.uniform(); };
  p.equality_matrix = normal_matrix(random, e, n);
  p.equality_vector = p.equality_matrix * point;
  p.inequality_matrix = normal_matrix(random, m, n);
  p.inequality_vector = p.inequality_matrix * point;
  for (double& b : p.inequality_vector) b -= room();
  if (random.below(2) == 0) {
    p.low = p.high = point;
    for (double& bound : p.low) bound -= random.below(4) == 0 ? kUnbounded : room();
    for (double& bound : p.high) bound += random.below(4) == 0 ? kUnbounded : room();
  }
  return p;
}

/// Of small integers: dependent, parallel, repeated constraints and normals of length 0 are common, as are
/// programmes that nothing meets.
inline QuadraticProgram integer_program(Random& random) {
  const Index n = 1 + index_below(random, 6), e = random.below(2) * index_below(random, n + 1);
  const Index m = index_below(random, random.below(4) == 0 ? 40 : 8);
  const MatrixXd root = integer_matrix(random, n, n, 2);
  const MatrixXd hessian = root.transpose() * root + MatrixXd::Identity(n, n);
  QuadraticProgram p = without_constraints(hessian, integer_matrix(random, n, 1, 6));
  const VectorXd point = integer_matrix(random, n, 1, 2);
  p.equality_matrix = integer_matrix(random, e, n, 1);
  p.equality_vector = p.equality_matrix * point;
  p.inequality_matrix = integer_matrix(random, m, n, 1 + static_cast<int>(random.below(2)));
  p.inequality_vector = p.inequality_matrix * point;
  for (double& b : p.inequality_vector) b -= static_cast<double>(random.below(2));
  if (random.below(2) == 0) {
    p.low = p.high = point;
    for (double& bound : p.low) bound -= static_cast<double>(random.below(3));
    for (double& bound : p.high)
      bound += random.below(3) == 0 ? kUnbounded : static_cast<double>(random.below(3));
  }
  for (Index row = 0; row < m; ++row)  // a constraint once more, or turned round
    if (random.below(5) == 0) {
      const Index other = index_below(random, m);
      const double factor = static_cast<double>(index_below(random, 7) - 3);
      p.inequality_matrix.row(row) = factor * p.inequality_matrix.row(other);
      p.inequality_vector[row] = factor * p.inequality_vector[other];
    }
  if (m > 0 && random.below(3) == 0) p.inequality_vector[index_below(random, m)] += 1;
  if (e > 0 && random.below(6) == 0) p.equality_vector[index_below(random, e)] += 1;
  return p;
}

/// The same programme with bounds as inequality constraints, after the others: each low one, each high one.
inline QuadraticProgram with_bounds_as_rows(const QuadraticProgram& p) {
  QuadraticProgram q = p;
  q.low.resize(0);
  q.high.resize(0);
  const Index n = p.gradient.size();
  const auto append = [&](Index i, double sign, double b) {
    const Index row = q.inequality_vector.size();
    q.inequality_matrix.conservativeResize(row + 1, n);
    q.inequality_matrix.row(row) = sign * VectorXd::Unit(n, i).transpose();
    q.inequality_vector.conservativeResize(row + 1);
    q.inequality_vector[row] = b;
  };
  for (Index i = 0; i < p.low.size(); ++i)
    if (std::isfinite(p.low[i])) append(i, 1, p.low[i]);
  for (Index i = 0; i < p.high.size(); ++i)
    if (std::isfinite(p.high[i])) append(i, -1, -p.high[i]);
  return q;
}

/// Σ λa of equality constraints and inequality constraints, bounds left out.
inline VectorXd sum_of_normals(const QuadraticProgram& p, const QuadraticSolution& s) {
  VectorXd sum = VectorXd::Zero(p.gradient.size());
  if (p.equality_vector.size() > 0) sum += p.equality_matrix.transpose() * s.equality_multipliers;
  if (p.inequality_vector.size() > 0) sum += p.inequality_matrix.transpose() * s.inequality_multipliers;
  return sum;
}

inline double objective(const QuadraticProgram& p, const VectorXd& x) {
  return 0.5 * x.dot(p.hessian * x) + p.gradient.dot(x);
}

/// What the Karush-Kuhn-Tucker conditions have against a solution, plainly, in the programme's own units; no
/// bounds.
inline double kkt_error(const QuadraticProgram& p, const QuadraticSolution& s) {
  double error = (p.hessian * s.x + p.gradient - sum_of_normals(p, s)).cwiseAbs().maxCoeff();
  for (Index i = 0; i < p.equality_vector.size(); ++i)
    error = std::max(error, std::abs(p.equality_matrix.row(i).dot(s.x) - p.equality_vector[i]));
  for (Index i = 0; i < p.inequality_vector.size(); ++i) {
    const double slack = p.inequality_matrix.row(i).dot(s.x) - p.inequality_vector[i];
    const double lambda = s.inequality_multipliers[i];
    error = std::max({error, -slack, -lambda, std::abs(slack * lambda)});
  }
  return error;
}

/// Does Σ λa = 0 with Σ λb > 0 show that nothing meets the constraints? No bounds.
inline bool certifies_infeasible(const QuadraticProgram& p, const QuadraticSolution& s) {
  double gain = 0, terms = 0;
  for (Index i = 0; i < p.equality_vector.size(); ++i) {
    gain += s.equality_multipliers[i] * p.equality_vector[i];
    terms += std::abs(s.equality_multipliers[i]) * p.equality_matrix.row(i).norm();
  }
  for (Index i = 0; i < p.inequality_vector.size(); ++i) {
    if (s.inequality_multipliers[i] < 0) return false;
    gain += s.inequality_multipliers[i] * p.inequality_vector[i];
    terms += s.inequality_multipliers[i] * p.inequality_matrix.row(i).norm();
  }
  return gain > 1e-9 * terms && sum_of_normals(p, s).norm() <= 1e-11 * terms;
}

/// All numbers of a solution, byte for byte.
inline std::string bytes_of(const QuadraticSolution& s) {
  std::string bytes;
  const auto append = [&](const double* data, Index count) {
    bytes.append(reinterpret_cast<const char*>(data), static_cast<std::size_t>(count) * sizeof(double));
  };
  for (const VectorXd* v : {&s.x, &s.equality_multipliers, &s.inequality_multipliers, &s.bound_multipliers})
    append(v->data(), v->size());
  append(&s.residual.primal, 1);
  append(&s.residual.stationarity, 1);
  append(&s.residual.complementarity, 1);
  return bytes + std::to_string(static_cast<int>(s.status)) + " " + std::to_string(s.iterations);
}

}  // namespace limpet::kinematics::testing
