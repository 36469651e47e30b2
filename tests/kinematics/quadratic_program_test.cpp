// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "programs.hpp"

namespace limpet::kinematics::testing {
namespace {

using Eigen::Vector2d;
using Status = QuadraticSolution::Status;
using Kind = QuadraticSolution::Unmet::Kind;

constexpr double kInf = kUnbounded;

QuadraticProgram nearest_to(const VectorXd& point) {
  return without_constraints(MatrixXd::Identity(point.size(), point.size()), -point);
}

void expect_optimum(const QuadraticProgram& p, const VectorXd& x) {
  const QuadraticSolution s = solved(p);
  EXPECT_EQ(s.status, Status::optimal);
  EXPECT_LT((s.x - x).cwiseAbs().maxCoeff(), 1e-14) << s.x.transpose();
  EXPECT_LT(s.residual.largest(), 1e-14);
}

void expect_unmet(const QuadraticProgram& p, Kind kind, Index index, double violation) {
  const QuadraticSolution s = solved(p);
  ASSERT_EQ(s.status, Status::infeasible);
  ASSERT_TRUE(s.unmet);
  EXPECT_EQ(s.unmet->kind, kind);
  EXPECT_EQ(s.unmet->index, index);
  EXPECT_NEAR(s.unmet->violation, violation, 1e-12);
  EXPECT_LT(s.residual.stationarity, 1e-14);
  EXPECT_GT(s.residual.primal, 0);
}

TEST(QuadraticProgram, SmallOnesByHand) {
  QuadraticProgram p = nearest_to(Vector2d(2, 1));
  expect_optimum(p, Vector2d(2, 1));
  require(p, Vector2d(-1, -1), -2);  // x + y ≤ 2
  expect_optimum(p, Vector2d(1.5, 0.5));
  p.high = Vector2d(1, kInf);
  expect_optimum(p, Vector2d(1, 1));
  p.low = Vector2d(-kInf, 1.25);  // which leaves x + y ≤ 2 in the corner
  expect_optimum(p, Vector2d(0.75, 1.25));
  require_equal(p, Vector2d(1, -2), -2.5);
  expect_optimum(p, Vector2d(0.5, 1.5));

  // From the minimum without constraints, (-2, -1), all three are violated; Hx + g = (5, 5) at (½, 1½).
  const Eigen::Matrix2d hessian{{4, -2}, {-2, 4}};
  QuadraticProgram three = without_constraints(hessian, Vector2d(6, 0));
  three.low = Vector2d(0, 0);
  require(three, Vector2d(1, 1), 2);
  const QuadraticSolution s = solved(three);
  EXPECT_NEAR(s.x[0], 0.5, 1e-15);
  EXPECT_NEAR(s.x[1], 1.5, 1e-15);
  EXPECT_NEAR(objective(three, s.x), 6.5, 1e-14);
  EXPECT_NEAR(s.inequality_multipliers[0], 5, 1e-14);
  EXPECT_EQ(s.bound_multipliers, Vector2d(0, 0));
}

TEST(QuadraticProgram, MultipliersOfBoundsTellTheSide) {
  QuadraticProgram p = nearest_to(Vector2d(2, -3));
  p.low = Vector2d(-1, -1);
  p.high = Vector2d(1, 1);
  expect_optimum(p, Vector2d(1, -1));
  EXPECT_EQ(solved(p).bound_multipliers, Vector2d(-1, 2));
}

TEST(QuadraticProgram, DegenerateOnesByHand) {
  QuadraticProgram fixed = nearest_to(Vector2d(3, 4));
  fixed.low = fixed.high = Vector2d(1, -2);
  expect_optimum(fixed, Vector2d(1, -2));

  QuadraticProgram corner = nearest_to(Vector2d(-1, -1));  // many more constraints than variables meet in 0
  for (const int factor : {1, 1, 3, 1000})
    for (const Vector2d& normal : {Vector2d(1, 0), Vector2d(0, 1), Vector2d(1, 1), Vector2d(2, 1)})
      require(corner, factor * normal, 0);
  corner.low = Vector2d(0, 0);
  expect_optimum(corner, Vector2d(0, 0));

  QuadraticProgram needle = nearest_to(Vector2d(5, 1));  // only x = 2 y is left, and of it one half
  require(needle, Vector2d(1, -2), 0);
  require(needle, Vector2d(-1, 2), 0);
  require(needle, Vector2d(-2, 4), 0);
  require(needle, Vector2d(-1, -1), -3);
  expect_optimum(needle, Vector2d(2, 1));

  QuadraticProgram redundant = nearest_to(Vector2d(0, 0));
  for (const double factor : {1.0, -2.0, 0.0}) require_equal(redundant, factor * Vector2d(1, 1), factor * 2);
  expect_optimum(redundant, Vector2d(1, 1));

  QuadraticProgram nothing = nearest_to(Vector2d(1, 1));
  require(nothing, Vector2d(0, 0), 0);
  require(nothing, Vector2d(0, 0), -1);
  require(nothing, Vector2d(1e-310, 0), -1);
  require_equal(nothing, Vector2d(0, 0), 0);
  expect_optimum(nothing, Vector2d(1, 1));
}

TEST(QuadraticProgram, SaysWhatCannotBeMet) {
  QuadraticProgram p = nearest_to(Vector2d(0, 0));
  p.low = Vector2d(1, 0);
  p.high = Vector2d(0, 5);
  expect_unmet(p, Kind::high, 0, 1);
  p.high = Vector2d(2, 5);
  require(p, Vector2d(-1, -1), -4);
  require(p, Vector2d(0, 2), 9);  // y ≥ 4.5, x ≥ 1, x + y ≤ 4: met at y = 4, as soon as possible
  const QuadraticSolution s = solved(p);
  ASSERT_EQ(s.status, Status::infeasible);
  EXPECT_TRUE(certifies_infeasible(with_bounds_as_rows(p), solved(with_bounds_as_rows(p))));

  QuadraticProgram equal = nearest_to(Vector2d(0, 0));
  require_equal(equal, Vector2d(1, 1), 1);
  require_equal(equal, Vector2d(2, 2), 3);
  expect_unmet(equal, Kind::equality, 1, 1);
  QuadraticProgram above = nearest_to(Vector2d(0, 0));
  require_equal(above, Vector2d(1, 1), 1);
  require_equal(above, Vector2d(2, 2), 1);
  expect_unmet(above, Kind::equality, 1, 1);
  EXPECT_TRUE(certifies_infeasible(above, solved(above)));

  QuadraticProgram nothing = nearest_to(Vector2d(1, 1));
  require(nothing, Vector2d(0, 0), 1e-30);
  EXPECT_EQ(solved(nothing).status, Status::infeasible);
  EXPECT_EQ(solved(nothing).unmet->violation, 1e-30);
}

TEST(QuadraticProgram, NotConvex) {
  for (const Eigen::Matrix2d& h :
       {Eigen::Matrix2d{{1, 1}, {1, 1}}, Eigen::Matrix2d{{1, 2}, {2, 1}}, Eigen::Matrix2d{{-1, 0}, {0, 1}},
        Eigen::Matrix2d{{0, 0}, {0, 0}}, Eigen::Matrix2d{{1, 1}, {1, 1 + 1e-15}}}) {
    const QuadraticSolution s = solved(without_constraints(h, Vector2d(1, 1)));
    EXPECT_EQ(s.status, Status::not_convex);
    EXPECT_TRUE(s.x.array().isNaN().all());
    EXPECT_EQ(s.residual.largest(), kInf);
  }
  expect_optimum(without_constraints(MatrixXd{{1e-200, 0}, {0, 1e200}}, Vector2d(-1e-200, 1e200)),
                 Vector2d(1, -1));
}

TEST(QuadraticProgram, EndsAtTheIterationLimit) {
  QuadraticProgram p = nearest_to(Vector2d(2, 3));
  p.high = Vector2d(1, 1);
  QuadraticSolver solver(1);
  EXPECT_EQ(solver.solve(p).status, Status::iterations);
  EXPECT_EQ(solver.solve(p).x, Vector2d(2, 1));
  EXPECT_NEAR(solver.solve(p).residual.primal, 1 / (std::sqrt(13) + std::sqrt(5)), 1e-15);
  EXPECT_EQ(QuadraticSolver(2).solve(p).status, Status::optimal);
}

std::string complaint(const std::function<void(QuadraticProgram&)>& damage) {
  QuadraticProgram p = nearest_to(Vector2d(1, 1));
  require(p, Vector2d(1, 0), 0);
  require_equal(p, Vector2d(0, 1), 0);
  p.low = Vector2d(-kInf, -1);
  p.high = Vector2d(1, kInf);
  damage(p);
  try {
    solved(p);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(QuadraticProgram, RefusesWhatIsNoProgramme) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string who = "quadratic programme: ";
  EXPECT_EQ(complaint([](auto&) {}), "");
  EXPECT_EQ(complaint([](auto& p) { p = {}; }), who + "H must be n x n, g of size n, n at least 1");
  EXPECT_EQ(complaint([](auto& p) { p.gradient.resize(3); }),
            who + "H must be n x n, g of size n, n at least 1");
  EXPECT_EQ(complaint([=](auto& p) { p.hessian(0, 1) = nan; }), who + "H and g must be finite");
  EXPECT_EQ(complaint([](auto& p) { p.gradient[1] = kInf; }), who + "H and g must be finite");
  EXPECT_EQ(complaint([](auto& p) { p.hessian(0, 1) = 0.1; }), who + "H must be symmetric");
  EXPECT_EQ(complaint([=](auto& p) { p.equality_matrix(0, 1) = nan; }),
            who + "equality constraints must be finite");
  EXPECT_EQ(complaint([](auto& p) { p.inequality_vector[0] = -kInf; }),
            who + "inequality constraints must be finite");
  EXPECT_EQ(complaint([](auto& p) { p.inequality_vector.resize(0); }),
            who + "an inequality constraint must have n coefficients and one right-hand side");
  EXPECT_EQ(complaint([](auto& p) { p.low.resize(1); }),
            who + "there must be a bound for each variable, or none");
  const std::string bounds =
      who + "a low bound must be a number or -infinity, a high one a number or infinity";
  EXPECT_EQ(complaint([=](auto& p) { p.low[0] = nan; }), bounds);
  EXPECT_EQ(complaint([=](auto& p) { p.high[0] = nan; }), bounds);
  EXPECT_EQ(complaint([](auto& p) { p.low[0] = kInf; }), bounds);
  EXPECT_EQ(complaint([](auto& p) { p.hessian *= 1e-300, p.gradient *= 1e200; }),
            who + "its minimum without constraints is out of range");
}

}  // namespace
}  // namespace limpet::kinematics::testing
