// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/kinematics/quadratic_program.hpp>

namespace limpet::kinematics {

/// Throws what QuadraticSolver::solve() does when something is not as it must be.
void require_sound(const QuadraticProgram&);

/// All constraints as rows, equality constraints first: where each other kind begins.
struct ConstraintRows {
  Eigen::Index inequality = 0, low = 0, high = 0, end = 0;

  explicit ConstraintRows(const QuadraticProgram& p)
      : inequality(p.equality_vector.size()),
        low(inequality + p.inequality_vector.size()),
        high(low + p.low.size()),
        end(high + p.high.size()) {}
};

/// aᵀx − b of each row.
void measure_slacks(const QuadraticProgram&, const ConstraintRows&, const Eigen::VectorXd& x,
                    Eigen::VectorXd& slacks);

/// v + Σ λa.
void add_normals(const QuadraticProgram&, const QuadraticSolution&, Eigen::VectorXd& v);

}  // namespace limpet::kinematics
