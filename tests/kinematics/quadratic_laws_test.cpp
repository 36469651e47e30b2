// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include "programs.hpp"

namespace limpet::kinematics::testing {
namespace {

using Status = QuadraticSolution::Status;

TEST(QuadraticLaws, MeetsTheKktConditions) {
  constexpr std::uint64_t kSeed = 17;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  QuadraticSolver solver;
  VectorXd point;
  double error = 0, residual = 0;
  int iterations = 0;
  for (std::uint64_t i = 0; i < wanted_programs(3000); ++i) {
    const QuadraticProgram p = feasible_program(random, point), rows = with_bounds_as_rows(p);
    const QuadraticSolution& s = solver.solve(p);
    ASSERT_EQ(s.status, Status::optimal) << "programme " << i;
    residual = std::max(residual, s.residual.largest());
    EXPECT_LE(objective(p, s.x), objective(p, point) + 1e-9);
    if (p.low.size() > 0) {
      EXPECT_TRUE((s.x.array() >= p.low.array()).all() && (s.x.array() <= p.high.array()).all());
    }
    const QuadraticSolution& same = solver.solve(rows);
    ASSERT_EQ(same.status, Status::optimal) << "programme " << i;
    error = std::max(error, kkt_error(rows, same));
    iterations = std::max(iterations, same.iterations);
  }
  EXPECT_LT(residual, 1e-11);
  EXPECT_LT(error, 1e-9);
  EXPECT_LT(iterations, 100);
  std::cout << "residual " << residual << ", in the programmes' units " << error << ", iterations "
            << iterations << "\n";
}

TEST(QuadraticLaws, InfeasibleOnesHaveACertificate) {
  constexpr std::uint64_t kSeed = 5;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  QuadraticSolver solver;
  int infeasible = 0;
  for (std::uint64_t i = 0; i < wanted_programs(3000); ++i) {
    QuadraticProgram p;
    VectorXd point;
    if (i % 2 == 0) {
      p = with_bounds_as_rows(integer_program(random));
    } else {  // a combination of constraints turned round and moved beyond
      p = with_bounds_as_rows(feasible_program(random, point));
      const Index m = p.inequality_vector.size();
      if (m == 0) continue;
      VectorXd factors = VectorXd::Zero(m);
      for (int k = 0; k < 5; ++k) factors[index_below(random, m)] = random.uniform();
      require(p, -p.inequality_matrix.transpose() * factors, 0.01 - p.inequality_vector.dot(factors));
    }
    const QuadraticSolution& s = solver.solve(p);
    if (i % 2 == 0 && s.status == Status::optimal) {
      EXPECT_LT(kkt_error(p, s), 1e-9);
      continue;
    }
    ASSERT_EQ(s.status, Status::infeasible) << "programme " << i;
    EXPECT_TRUE(certifies_infeasible(p, s)) << "programme " << i;
    EXPECT_GT(s.unmet->violation, 0);
    ++infeasible;
  }
  EXPECT_GT(infeasible, 1000);
}

double change_of(const VectorXd& x, const VectorXd& y) {
  return (x - y).cwiseAbs().maxCoeff() / (1 + x.cwiseAbs().maxCoeff());
}

QuadraticProgram with_rows_scaled(QuadraticProgram p, Random& random) {
  for (Index i = 0; i < p.inequality_vector.size(); ++i) {
    const double factor = std::ldexp(1.0, static_cast<int>(random.below(400)) - 200);
    p.inequality_matrix.row(i) *= factor;
    p.inequality_vector[i] *= factor;
  }
  return p;
}

QuadraticProgram with_rows_permuted(QuadraticProgram p, Random& random) {
  for (Index i = p.inequality_vector.size(); i > 1; --i) {
    const Index j = index_below(random, i);
    p.inequality_matrix.row(i - 1).swap(p.inequality_matrix.row(j));
    std::swap(p.inequality_vector[i - 1], p.inequality_vector[j]);
  }
  return p;
}

/// With x = scales · x′; the scales are returned.
VectorXd scale_variables(QuadraticProgram& p, Random& random) {
  VectorXd scales(p.gradient.size());
  for (double& scale : scales) scale = std::ldexp(1.0, static_cast<int>(random.below(60)) - 30);
  p.hessian = scales.asDiagonal() * p.hessian * scales.asDiagonal();
  p.gradient.array() *= scales.array();
  p.equality_matrix *= scales.asDiagonal();
  p.inequality_matrix *= scales.asDiagonal();
  p.low.array() /= scales.head(p.low.size()).array();
  p.high.array() /= scales.head(p.high.size()).array();
  return scales;
}

TEST(QuadraticLaws, ScalesOrdersAndRedundantConstraintsDoNotMatter) {
  constexpr std::uint64_t kSeed = 99;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  VectorXd point;
  double change = 0;
  for (std::uint64_t i = 0; i < wanted_programs(1000); ++i) {
    const QuadraticProgram p = i % 2 == 0 ? integer_program(random) : feasible_program(random, point);
    const QuadraticSolution s = solved(p);
    const auto compare = [&](const QuadraticProgram& other, const char* what, const VectorXd& scales) {
      const QuadraticSolution t = solved(other);
      ASSERT_EQ(s.status, t.status) << "programme " << i << ", " << what;
      if (s.status == Status::optimal) change = std::max(change, change_of(s.x, scales.cwiseProduct(t.x)));
    };
    const VectorXd ones = VectorXd::Ones(p.gradient.size());
    compare(with_rows_scaled(p, random), "rows scaled", ones);
    compare(with_rows_permuted(p, random), "rows permuted", ones);
    compare(with_bounds_as_rows(p), "bounds as rows", ones);
    QuadraticProgram other = p;
    other.hessian *= 0x1p100;
    other.gradient *= 0x1p100;
    compare(other, "objective scaled", ones);
    other = p;
    const VectorXd scales = scale_variables(other, random);
    compare(other, "variables scaled", scales);
    if (p.inequality_vector.size() < 2) continue;
    other = p;  // the sum of two constraints, and one of them moved back
    require(other, p.inequality_matrix.row(0) + p.inequality_matrix.row(1),
            p.inequality_vector[0] + p.inequality_vector[1]);
    require(other, p.inequality_matrix.row(0), p.inequality_vector[0] - 1);
    compare(other, "redundant", ones);
  }
  EXPECT_LT(change, 1e-9);
  std::cout << "largest change of x " << change << "\n";
}

TEST(QuadraticLaws, GivesTheSameBytesWhateverWasSolvedBefore) {
  Random random(3);
  QuadraticSolver used;
  VectorXd point;
  for (int i = 0; i < 300; ++i) {
    const QuadraticProgram p = i % 2 == 0 ? integer_program(random) : feasible_program(random, point);
    const std::string bytes = bytes_of(solved(p));
    EXPECT_EQ(bytes_of(used.solve(p)), bytes);
    EXPECT_EQ(bytes_of(used.solve(QuadraticProgram(p))), bytes);
  }
}

/// Normals that differ by less and less, H nearer and nearer to singular: what is said to be optimal is.
TEST(QuadraticLaws, IllConditionedOnesEndHonestly) {
  constexpr std::uint64_t kSeed = 41;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  QuadraticSolver solver;
  VectorXd point;
  int optimal = 0, infeasible = 0, gave_up = 0, not_convex = 0;
  double worst = 0;  // not above 1e-8 by the status
  const std::uint64_t count = wanted_programs(3000);
  for (std::uint64_t i = 0; i < count; ++i) {
    QuadraticProgram p = with_bounds_as_rows(feasible_program(random, point));
    const Index n = p.gradient.size(), m = p.inequality_vector.size();
    for (Index row = 1; row < m; row += 2) {
      const double angle = std::pow(10, -random.uniform(0, 16)), sign = random.below(2) == 0 ? 1 : -1;
      p.inequality_matrix.row(row) =
          sign * p.inequality_matrix.row(row - 1) + angle * normal_matrix(random, 1, n);
      p.inequality_vector[row] = p.inequality_matrix.row(row).dot(point) - angle * random.uniform();
    }
    MatrixXd root = normal_matrix(random, n, n);
    root.col(0) *= std::pow(10, -random.uniform(0, 8));
    p.hessian = root * root.transpose();
    const QuadraticSolution& s = solver.solve(p);
    optimal += s.status == Status::optimal;
    infeasible += s.status == Status::infeasible;
    gave_up += s.status == Status::iterations;
    not_convex += s.status == Status::not_convex;
    if (s.status == Status::optimal) worst = std::max(worst, s.residual.largest());
  }
  EXPECT_EQ(infeasible, 0);
  EXPECT_LT(gave_up, 0.01 * static_cast<double>(count));
  EXPECT_GT(not_convex, 0);
  std::cout << optimal << " optimal, worst residual " << worst << "; " << infeasible << " infeasible, "
            << gave_up << " given up, " << not_convex << " not convex\n";
}

}  // namespace
}  // namespace limpet::kinematics::testing
