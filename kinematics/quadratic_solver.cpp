// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <limpet/kinematics/nearest_point_internal.hpp>
#include <limpet/kinematics/quadratic_program_internal.hpp>

namespace limpet::kinematics {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Status = QuadraticSolution::Status;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Less than this of a diagonal element of H left as pivot: not positive definite.
constexpr double kPivot = 1e-12;
/// What rounding may leave of 0, for numbers of size 1 and pivots of all of the diagonal elements.
constexpr double kRoundingLeaves = 1e-13;
/// Largest residual of an optimum.
constexpr double kAccepted = 1e-8;

/// A length, of which only what is above 0 counts, in a unit that is 0 only where all is; never NaN.
double relative(double length, double unit) {
  if (length <= 0) return 0;
  return length <= std::numeric_limits<double>::max() && unit > 0 ? length / unit : kInfinity;
}

}  // namespace

struct QuadraticSolver::Workspace {
  int iteration_limit = 0;
  QuadraticSolution solution;
  Eigen::LLT<Eigen::MatrixXd> cholesky;
  VectorXd centre;  ///< L⁻¹g: z = Lᵀx + centre
  Polyhedron polyhedron;
  NearestPoint nearest;
  VectorXd lengths;  ///< of normals, while they are made to be 1
  VectorXd weights;  ///< of each row: |L⁻¹a|; where that is 0, another unit of its b
  VectorXd slacks;   ///< of each row: aᵀx − b
  VectorXd gaps;     ///< of the working set: b − aᵀx over their weights
  VectorXd change;   ///< of z
  VectorXd rest;     ///< what is left of stationarity

  const QuadraticSolution& solve(const QuadraticProgram&);

 private:
  void begin(const QuadraticProgram&, const ConstraintRows&);
  bool factorise(const QuadraticProgram&);
  void take_rows(const QuadraticProgram&, const ConstraintRows&);
  void normalise();
  void publish(const ConstraintRows&, Index row, double multiplier);
  void publish_multipliers(const ConstraintRows&);
  void publish_certificate(const ConstraintRows&);
  void refine(const QuadraticProgram&, const ConstraintRows&);
  void measure_rest(const QuadraticProgram&);
  void measure_residual(const QuadraticProgram&, const ConstraintRows&);
  QuadraticSolution::Unmet unmet(const ConstraintRows&) const;
};

const QuadraticSolution& QuadraticSolver::Workspace::solve(const QuadraticProgram& p) {
  const ConstraintRows rows(p);
  begin(p, rows);
  if (!factorise(p)) return solution;
  take_rows(p, rows);
  normalise();
  const NearestPoint::End end = nearest.search(polyhedron, iteration_limit);
  solution.iterations = nearest.iterations();
  solution.x = nearest.point() - centre;
  cholesky.matrixU().solveInPlace(solution.x);
  if (end == NearestPoint::End::empty) {
    solution.status = Status::infeasible;
    publish_certificate(rows);
    measure_residual(p, rows);
    solution.unmet = unmet(rows);
  } else {
    publish_multipliers(rows);
    if (end == NearestPoint::End::found) refine(p, rows);
    measure_residual(p, rows);
    if (end == NearestPoint::End::found && solution.residual.largest() <= kAccepted)
      solution.status = Status::optimal;
  }
  return solution;
}

void QuadraticSolver::Workspace::begin(const QuadraticProgram& p, const ConstraintRows& rows) {
  const Index n = p.gradient.size();
  solution.x.setConstant(n, std::numeric_limits<double>::quiet_NaN());
  solution.equality_multipliers.setZero(rows.inequality);
  solution.inequality_multipliers.setZero(rows.low - rows.inequality);
  solution.bound_multipliers.setZero(n);
  solution.residual = {kInfinity, kInfinity, kInfinity};
  solution.unmet.reset();
  solution.iterations = 0;
}

/// H = LLᵀ, and the minimum without constraints. False: H is not positive definite.
bool QuadraticSolver::Workspace::factorise(const QuadraticProgram& p) {
  solution.status = Status::not_convex;
  cholesky.compute(p.hessian);
  if (cholesky.info() != Eigen::Success) return false;
  double least = 1;
  for (Index i = 0; i < p.hessian.rows(); ++i) {
    const double l = cholesky.matrixLLT()(i, i);
    least = std::min(least, l * l / p.hessian(i, i));
  }
  if (!(least > kPivot)) return false;
  centre = p.gradient;
  cholesky.matrixL().solveInPlace(centre);
  polyhedron.unit = centre.norm();
  polyhedron.rounding = kRoundingLeaves / std::sqrt(least);
  if (!std::isfinite(polyhedron.unit))
    throw std::invalid_argument("quadratic programme: its minimum without constraints is out of range");
  solution.status = Status::iterations;  // until an end is reached
  return true;
}

void QuadraticSolver::Workspace::take_rows(const QuadraticProgram& p, const ConstraintRows& rows) {
  const Index n = p.gradient.size();
  polyhedron.equalities = rows.inequality;
  polyhedron.normals.resize(rows.end, n);
  polyhedron.offsets.resize(rows.end);
  const auto take = [&](Index first, const auto& matrix, const auto& vector) {
    if (vector.size() == 0) return;
    polyhedron.normals.middleRows(first, vector.size()) = matrix;
    polyhedron.offsets.segment(first, vector.size()) = vector;
  };
  take(0, p.equality_matrix, p.equality_vector);
  take(rows.inequality, p.inequality_matrix, p.inequality_vector);
  take(rows.low, Eigen::MatrixXd::Identity(n, n), p.low);
  take(rows.high, -Eigen::MatrixXd::Identity(n, n), -p.high);
}

/// From aᵀx ≥ b to normal · z ≥ offset.
void QuadraticSolver::Workspace::normalise() {
  Eigen::MatrixXd& normals = polyhedron.normals;
  VectorXd& offsets = polyhedron.offsets;
  const auto& l = cholesky.matrixLLT();
  // Largest coefficients first, so that no square is out of range.
  weights.setZero(normals.rows());
  for (Index j = 0; j < normals.cols(); ++j) weights = weights.cwiseMax(normals.col(j).cwiseAbs());
  weights = (weights.array() > 0).select(weights, 1);
  lengths = weights.cwiseInverse();
  for (Index j = 0; j < normals.cols(); ++j) {
    normals.col(j).array() *= lengths.array();
    for (Index k = 0; k < j; ++k) normals.col(j) -= l(j, k) * normals.col(k);
    normals.col(j) /= l(j, j);
  }
  lengths.setZero(normals.rows());
  for (Index j = 0; j < normals.cols(); ++j) lengths += normals.col(j).cwiseAbs2();
  lengths = lengths.cwiseSqrt();
  for (Index row = 0; row < normals.rows(); ++row) {
    const double b = offsets[row], offset = b / weights[row] / lengths[row];
    if (std::isfinite(offset)) {
      offsets[row] = offset;
      weights[row] *= lengths[row];
      continue;
    }
    // A normal of length 0, or so short that b is out of reach; an absent bound, too.
    const bool equality = row < polyhedron.equalities, met = equality ? b == 0 : b <= 0;
    normals.row(row).setZero();
    offsets[row] = met ? (equality ? 0 : -kInfinity) : std::copysign(kInfinity, b);
    weights[row] = b != 0 && std::isfinite(b) ? std::abs(b) : 1;
    lengths[row] = 1;
  }
  lengths = lengths.cwiseInverse();
  for (Index j = 0; j < normals.cols(); ++j) {
    normals.col(j).array() *= lengths.array();
    offsets += centre[j] * normals.col(j);
  }
}

/// λ of a row, from its multiplier in z.
void QuadraticSolver::Workspace::publish(const ConstraintRows& rows, Index row, double multiplier) {
  const double lambda = multiplier / weights[row];
  if (row < rows.inequality)
    solution.equality_multipliers[row] = lambda;
  else if (row < rows.low)
    solution.inequality_multipliers[row - rows.inequality] = lambda;
  else if (row < rows.high)
    solution.bound_multipliers[row - rows.low] += lambda;
  else
    solution.bound_multipliers[row - rows.high] -= lambda;
}

void QuadraticSolver::Workspace::publish_multipliers(const ConstraintRows& rows) {
  solution.bound_multipliers.setZero();
  for (Index i = 0; i < nearest.working_count(); ++i)
    publish(rows, nearest.working_row(i), nearest.multiplier(i));
}

/// What cannot be met less the combination of others that it is.
void QuadraticSolver::Workspace::publish_certificate(const ConstraintRows& rows) {
  const double sign = nearest.above_unmet() ? -1 : 1;
  publish(rows, nearest.unmet(), sign);
  for (Index i = 0; i < nearest.working_count(); ++i)
    publish(rows, nearest.working_row(i), -sign * nearest.coefficient(i));
}

/// One step of iterative refinement, by what the programme as given has x and λ short of; and x into its
/// bounds, to the last bit.
void QuadraticSolver::Workspace::refine(const QuadraticProgram& p, const ConstraintRows& rows) {
  measure_slacks(p, rows, solution.x, slacks);
  gaps.resize(solution.x.size());
  const Index count = nearest.working_count();
  for (Index i = 0; i < count; ++i)
    gaps[i] = -slacks[nearest.working_row(i)] / weights[nearest.working_row(i)];
  measure_rest(p);
  nearest.correct(rest, gaps, change);
  cholesky.matrixU().solveInPlace(change);
  solution.x += change;
  if (p.low.size() > 0) solution.x = solution.x.cwiseMax(p.low);
  if (p.high.size() > 0) solution.x = solution.x.cwiseMin(p.high);
  publish_multipliers(rows);
}

/// L⁻¹(Σ λa − Hx − g); of a certificate L⁻¹Σ λa.
void QuadraticSolver::Workspace::measure_rest(const QuadraticProgram& p) {
  if (solution.status == Status::infeasible) {
    rest.setZero(p.gradient.size());
  } else {
    rest = -p.gradient;
    rest.noalias() -= p.hessian * solution.x;
  }
  add_normals(p, solution, rest);
  cholesky.matrixL().solveInPlace(rest);
}

void QuadraticSolver::Workspace::measure_residual(const QuadraticProgram& p, const ConstraintRows& rows) {
  KktResidual& residual = solution.residual = {};
  change.noalias() = cholesky.matrixU() * solution.x;
  const double unit = polyhedron.unit + change.norm();
  measure_slacks(p, rows, solution.x, slacks);
  for (Index row = 0; row < rows.end; ++row) {
    const double slack = slacks[row] / weights[row];
    residual.primal =
        std::max(residual.primal, relative(row < rows.inequality ? std::abs(slack) : -slack, unit));
  }
  measure_rest(p);
  double terms = unit;
  if (solution.status == Status::infeasible) {
    terms = 1;
    for (Index i = 0; i < nearest.working_count(); ++i) terms += std::abs(nearest.coefficient(i));
  } else {
    for (Index i = 0; i < nearest.working_count(); ++i) {
      const Index row = nearest.working_row(i);
      const double product = std::abs(nearest.multiplier(i) * slacks[row] / weights[row]);
      residual.complementarity = std::max(residual.complementarity, relative(relative(product, unit), unit));
    }
  }
  residual.stationarity = relative(rest.norm(), terms);
}

QuadraticSolution::Unmet QuadraticSolver::Workspace::unmet(const ConstraintRows& rows) const {
  using Kind = QuadraticSolution::Unmet::Kind;
  const Index row = nearest.unmet();
  const double violation = std::abs(slacks[row]);
  if (row < rows.inequality) return {Kind::equality, row, violation};
  if (row < rows.low) return {Kind::inequality, row - rows.inequality, violation};
  if (row < rows.high) return {Kind::low, row - rows.low, violation};
  return {Kind::high, row - rows.high, violation};
}

QuadraticSolver::QuadraticSolver(int iteration_limit) : workspace_(std::make_unique<Workspace>()) {
  workspace_->iteration_limit = iteration_limit;
}
QuadraticSolver::~QuadraticSolver() = default;
QuadraticSolver::QuadraticSolver(QuadraticSolver&&) noexcept = default;
QuadraticSolver& QuadraticSolver::operator=(QuadraticSolver&&) noexcept = default;

const QuadraticSolution& QuadraticSolver::solve(const QuadraticProgram& program) {
  require_sound(program);
  return workspace_->solve(program);
}

}  // namespace limpet::kinematics
