// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/Gmpz.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <gtest/gtest.h>

#include "programs.hpp"

namespace limpet::kinematics::testing {
namespace {

using Oracle = CGAL::Quadratic_program<int>;

int integer(double value) { return static_cast<int>(value); }

/// A programme of integers for CGAL's solver, which is exact.
Oracle oracle_of(const QuadraticProgram& p) {
  Oracle oracle(CGAL::LARGER, false, 0, false, 0);
  const int n = static_cast<int>(p.gradient.size());
  for (int i = 0; i < n; ++i) {
    oracle.set_c(i, integer(p.gradient[i]));
    for (int j = 0; j <= i; ++j) oracle.set_d(i, j, integer(p.hessian(i, j)));  // it asks for twice xᵀDx
    if (p.low.size() > 0)
      oracle.set_l(i, std::isfinite(p.low[i]), std::isfinite(p.low[i]) ? integer(p.low[i]) : 0);
    if (p.high.size() > 0)
      oracle.set_u(i, std::isfinite(p.high[i]), std::isfinite(p.high[i]) ? integer(p.high[i]) : 0);
  }
  int row = 0;
  const auto append = [&](const MatrixXd& matrix, const VectorXd& vector, CGAL::Comparison_result relation) {
    for (Index i = 0; i < vector.size(); ++i, ++row) {
      for (int j = 0; j < n; ++j) oracle.set_a(j, row, integer(matrix(i, j)));
      oracle.set_b(row, integer(vector[i]));
      oracle.set_r(row, relation);
    }
  };
  append(p.equality_matrix, p.equality_vector, CGAL::EQUAL);
  append(p.inequality_matrix, p.inequality_vector, CGAL::LARGER);
  return oracle;
}

/// On programmes of small integers, most of them degenerate: feasible or not without exception, and the same
/// x.
TEST(QuadraticOracle, ExactSolverSaysTheSame) {
  constexpr std::uint64_t kSeed = 83;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  QuadraticSolver solver;
  const std::uint64_t count = wanted_programs(3000);
  std::uint64_t infeasible = 0, degenerate = 0;
  double objective_error = 0, x_error = 0, residual = 0;
  int most_iterations = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const QuadraticProgram p = integer_program(random);
    const Oracle oracle = oracle_of(p);
    const auto truth = CGAL::solve_quadratic_program(oracle, CGAL::Gmpz());
    const QuadraticSolution& s = solver.solve(p);
    most_iterations = std::max(most_iterations, s.iterations);
    if (truth.is_infeasible()) {
      ASSERT_EQ(s.status, QuadraticSolution::Status::infeasible) << "programme " << i;
      ++infeasible;
      continue;
    }
    ASSERT_EQ(s.status, QuadraticSolution::Status::optimal) << "programme " << i;
    residual = std::max(residual, s.residual.largest());
    const double least = CGAL::to_double(truth.objective_value());
    objective_error = std::max(objective_error, std::abs(objective(p, s.x) - least) / (1 + std::abs(least)));
    VectorXd x(p.gradient.size());
    std::transform(truth.variable_values_begin(), truth.variable_values_end(), x.begin(),
                   [](const auto& value) { return CGAL::to_double(value); });
    x_error = std::max(x_error, (s.x - x).cwiseAbs().maxCoeff() / (1 + x.cwiseAbs().maxCoeff()));
    VectorXd slacks = p.inequality_matrix * x - p.inequality_vector;
    degenerate += (slacks.array().abs() < 1e-9).count() + p.equality_vector.size() > p.gradient.size();
  }
  EXPECT_LT(objective_error, 1e-11);
  EXPECT_LT(x_error, 1e-11);
  EXPECT_LT(residual, 1e-13);
  EXPECT_LT(most_iterations, 100);
  EXPECT_GT(infeasible, count / 10);
  EXPECT_GT(degenerate, count / 10);
  std::cout << count << " programmes, " << infeasible << " infeasible, " << degenerate
            << " degenerate: largest deviation of the objective " << objective_error << ", of x " << x_error
            << ", residual " << residual << ", iterations " << most_iterations << "\n";
}

}  // namespace
}  // namespace limpet::kinematics::testing
