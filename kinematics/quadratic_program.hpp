// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

namespace limpet::kinematics {

/// A strictly convex quadratic programme in n variables: minimise ½ xᵀHx + gᵀx subject to equality
/// constraints aᵀx = b, inequality constraints aᵀx ≥ b, and bounds. What is left empty is not asked for.
struct QuadraticProgram {
  Eigen::MatrixXd hessian;            ///< H, n × n: symmetric, positive definite
  Eigen::VectorXd gradient;           ///< g, n: the gradient at x = 0
  Eigen::MatrixXd equality_matrix;    ///< a row aᵀ for each equality constraint
  Eigen::VectorXd equality_vector;    ///< b of each of them
  Eigen::MatrixXd inequality_matrix;  ///< a row aᵀ for each inequality constraint
  Eigen::VectorXd inequality_vector;  ///< b of each of them
  Eigen::VectorXd low, high;          ///< bounds, n each; −∞ and ∞: none
};

/// The Karush-Kuhn-Tucker conditions, and how far they are missed. The figures are computed from the
/// programme as it was given, and are without units: lengths are those of the programme's own metric, √(xᵀHx)
/// of a point, √(aᵀH⁻¹a) of a normal, over √(gᵀH⁻¹g) + √(xᵀHx). No scaling of constraints, objective or
/// variables changes them.
struct KktResidual {
  double primal = 0;           ///< how far x is outside the constraint that it violates most
  double stationarity = 0;     ///< length of Hx + g − Σ λa
  double complementarity = 0;  ///< largest λ(aᵀx − b), over the square of that

  double largest() const;
};

/// What came of a quadratic programme.
struct QuadraticSolution {
  enum class Status {
    optimal,  ///< x is the minimum: no residual is above 1e-8
    /// No x meets the constraints, or only such as are 100 times as far away as the last iterate, as
    /// KktResidual has lengths: in data that are rounded the two are not told apart.
    infeasible,
    iterations,  ///< gave up: at the iteration limit, or since rounding left a residual above 1e-8
    not_convex   ///< H is not positive definite, or is too near: a pivot is not above 1e-12 of H's diagonal
  };
  Status status = Status::iterations;

  /// The minimum; when infeasible or given up the last iterate, when not convex NaN.
  Eigen::VectorXd x;

  /// Lagrange multipliers λ: Hx + g = Σ λa, those of inequality constraints not below 0. A bound's is
  /// positive where x lies at the low one, negative at the high one. When infeasible, a certificate instead
  /// (Farkas): Σ λa = 0 and Σ λb > 0, which no x allows, since Σ λ(aᵀx − b) would have to be 0 or more; of a
  /// bound's two multipliers it has the difference. Both up to rounding.
  Eigen::VectorXd equality_multipliers, inequality_multipliers, bound_multipliers;

  /// At x. When infeasible, stationarity is the length of Σ λa over the sum of the lengths of its terms.
  KktResidual residual;

  /// When infeasible: a constraint that could not be met beside others, and |aᵀx − b| there.
  struct Unmet {
    enum class Kind { equality, inequality, low, high };
    Kind kind = Kind::equality;
    Eigen::Index index = 0;  ///< row of its matrix, or variable
    double violation = 0;    ///< in the units of its b
  };
  std::optional<Unmet> unmet;

  int iterations = 0;  ///< steps made
};

/// Solves quadratic programmes by the dual active-set method (Goldfarb and Idnani 1983, A numerically stable
/// dual method for solving strictly convex quadratic programs): from the minimum without constraints, the
/// constraint violated most is met in each step, others being given up where their multipliers would change
/// sign. With H = LLᵀ the programme is to find the point nearest to the origin, in coordinates z = Lᵀx +
/// L⁻¹g, where all normals are given unit length; no scaling of constraints, objective or variables changes
/// that programme, to which all tolerances refer. For a few variables and some hundreds of constraints.
///
/// The same programme gives the same bytes, whatever was solved before; of equals the one of lowest index is
/// taken, equality constraints before inequality constraints, low bounds, high bounds. Constraints may be
/// redundant, dependent and have normals of length 0.
class QuadraticSolver {
 public:
  /// At most so many steps.
  explicit QuadraticSolver(int iteration_limit = 1000);
  ~QuadraticSolver();
  QuadraticSolver(QuadraticSolver&&) noexcept;
  QuadraticSolver& operator=(QuadraticSolver&&) noexcept;

  /// The solution is kept until the next call, which allocates nothing if sizes are the same. Throws
  /// std::invalid_argument, with one line that says what, when sizes do not fit, H is not symmetric, or a
  /// number is NaN or infinite, bounds −∞ and ∞ excepted, or becomes so.
  const QuadraticSolution& solve(const QuadraticProgram&);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace limpet::kinematics
