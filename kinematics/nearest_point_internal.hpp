// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace limpet::kinematics {

/// Where normal · z ≥ offset in each row; equal in the first ones.
struct Polyhedron {
  Eigen::MatrixXd normals;  ///< rows of length 1, or 0
  Eigen::VectorXd offsets;  ///< −∞: nothing is asked; ∞, with a normal of length 0: cannot be met
  Eigen::Index equalities = 0;
  double unit = 0;      ///< length of what offsets were computed from, beside themselves
  double rounding = 0;  ///< what rounding may leave of 0, for numbers of size 1
};

/// The point of a polyhedron nearest to the origin, which is what a strictly convex quadratic programme comes
/// down to, by the dual active-set method (Goldfarb and Idnani 1983, §3). Of equals the row of lowest index
/// is taken.
class NearestPoint {
 public:
  using Index = Eigen::Index;
  enum class End { found, empty, iterations };

  End search(const Polyhedron&, int iteration_limit);

  /// The point; when empty or given up, the last one tried.
  const Eigen::VectorXd& point() const { return z_; }
  int iterations() const { return iterations_; }

  /// The working set: rows that hold with equality at the point, which is the sum of multiplier · normal.
  Index working_count() const { return static_cast<Index>(working_.size()); }
  Index working_row(Index position) const { return working_[static_cast<std::size_t>(position)]; }
  double multiplier(Index position) const { return u_[position]; }

  /// When empty: the row that is not met, −1 otherwise. Its normal is the sum of coefficient · normal over
  /// the working set, no coefficient of an inequality constraint being positive (Farkas).
  Index unmet() const { return unmet_; }
  double coefficient(Index position) const { return coefficients_[position]; }
  /// Is the point on the side of that row, an equality constraint, to which its normal points?
  bool above_unmet() const { return above_unmet_; }

  /// One step of refinement, for what a point found is short of elsewhere: its working set's rows by `gaps`,
  /// one each, and stationarity by `pull`, which its multipliers do not balance. Corrects them; the point's
  /// change is given.
  void correct(const Eigen::VectorXd& pull, const Eigen::VectorXd& gaps, Eigen::VectorXd& change);

 private:
  void begin(const Polyhedron&);
  bool meet_equality(Index row);
  Index most_violated();
  enum class Step { full, partial, none };
  Step approach(Index row);
  void project(Index row);
  Index first_to_give_up() const;
  void add(Index row);
  void drop(Index position);
  void solve_working_set();
  void solve_triangle(Eigen::Ref<Eigen::VectorXd>) const;
  void solve_transposed_triangle(Eigen::Ref<Eigen::VectorXd>) const;
  bool is_inequality(Index position) const;
  double kept_sign(Index position, double multiplier) const;
  bool dependent() const;
  bool matters(double violation) const;
  double violation(Index row) const;
  double size() const { return polyhedron_->unit + z_.norm(); }

  const Polyhedron* polyhedron_ = nullptr;
  int iterations_ = 0;
  Index unmet_ = -1;
  bool above_unmet_ = false;
  Eigen::VectorXd z_;
  std::vector<Index> working_;
  Eigen::VectorXd u_;  ///< multipliers of the working set
  Eigen::MatrixXd q_,
      r_;  ///< the working set's normals, as columns, are Q₁R, where Q = (Q₁ Q₂) is orthogonal
  std::vector<char> passed_over_;  ///< rows that are met but for rounding

  Eigen::VectorXd normal_;        ///< of the row to be met
  Eigen::VectorXd projected_;     ///< Qᵀ normal
  Eigen::VectorXd coefficients_;  ///< R⁻¹Q₁ᵀ normal: what it is of normals of the working set
  Eigen::VectorXd direction_;     ///< Q₂Q₂ᵀ normal: the rest
  double rest_ = 0;               ///< length of that
  Eigen::VectorXd slacks_;        ///< of all rows
};

}  // namespace limpet::kinematics
