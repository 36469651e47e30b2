// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <limpet/kinematics/quadratic_program_internal.hpp>

namespace limpet::kinematics {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Asymmetry of H that is let pass, of numbers of size 1.
constexpr double kSymmetric = 1e-9;
void require_program(bool good, const char* what) {
  if (!good) throw std::invalid_argument(std::string("quadratic programme: ") + what);
}

bool is_symmetric(const Eigen::MatrixXd& h) {
  for (Index j = 0; j < h.cols(); ++j)
    for (Index i = j + 1; i < h.rows(); ++i) {
      const double unit = std::sqrt(std::abs(h(i, i))) * std::sqrt(std::abs(h(j, j)));
      if (std::abs(h(i, j) - h(j, i)) > kSymmetric * unit) return false;
    }
  return true;
}

void require_constraints(const Eigen::MatrixXd& matrix, const VectorXd& vector, Index variables,
                         const char* sizes, const char* finite) {
  require_program(matrix.rows() == vector.size() && (matrix.rows() == 0 || matrix.cols() == variables),
                  sizes);
  require_program(matrix.allFinite() && vector.allFinite(), finite);
}

void require_bounds(const VectorXd& low, const VectorXd& high, Index variables) {
  const bool fit =
      (low.size() == 0 || low.size() == variables) && (high.size() == 0 || high.size() == variables);
  require_program(fit, "there must be a bound for each variable, or none");
  require_program((low.array() < std::numeric_limits<double>::infinity()).all() &&
                      (high.array() > -std::numeric_limits<double>::infinity()).all(),
                  "a low bound must be a number or -infinity, a high one a number or infinity");
}

}  // namespace

double KktResidual::largest() const { return std::max({primal, stationarity, complementarity}); }

void require_sound(const QuadraticProgram& p) {
  const Index n = p.gradient.size();
  require_program(n > 0 && p.hessian.rows() == n && p.hessian.cols() == n,
                  "H must be n x n, g of size n, n at least 1");
  require_program(p.hessian.allFinite() && p.gradient.allFinite(), "H and g must be finite");
  require_program(is_symmetric(p.hessian), "H must be symmetric");
  require_constraints(p.equality_matrix, p.equality_vector, n,
                      "an equality constraint must have n coefficients and one right-hand side",
                      "equality constraints must be finite");
  require_constraints(p.inequality_matrix, p.inequality_vector, n,
                      "an inequality constraint must have n coefficients and one right-hand side",
                      "inequality constraints must be finite");
  require_bounds(p.low, p.high, n);
}

void measure_slacks(const QuadraticProgram& p, const ConstraintRows& rows, const VectorXd& x,
                    VectorXd& slacks) {
  slacks.resize(rows.end);
  slacks.head(rows.inequality) = -p.equality_vector;
  slacks.segment(rows.inequality, p.inequality_vector.size()) = -p.inequality_vector;
  for (Index j = 0; j < x.size(); ++j) {
    if (p.equality_vector.size() > 0) slacks.head(rows.inequality) += x[j] * p.equality_matrix.col(j);
    if (p.inequality_vector.size() > 0)
      slacks.segment(rows.inequality, p.inequality_vector.size()) += x[j] * p.inequality_matrix.col(j);
  }
  if (p.low.size() > 0) slacks.segment(rows.low, p.low.size()) = x - p.low;
  if (p.high.size() > 0) slacks.segment(rows.high, p.high.size()) = p.high - x;
}

void add_normals(const QuadraticProgram& p, const QuadraticSolution& s, VectorXd& v) {
  if (p.equality_vector.size() > 0) v.noalias() += p.equality_matrix.transpose() * s.equality_multipliers;
  if (p.inequality_vector.size() > 0)
    v.noalias() += p.inequality_matrix.transpose() * s.inequality_multipliers;
  v += s.bound_multipliers;
}

}  // namespace limpet::kinematics
