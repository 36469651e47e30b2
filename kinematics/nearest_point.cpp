// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <limits>

#include <limpet/kinematics/nearest_point_internal.hpp>

namespace limpet::kinematics {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
/// How far the point may be outside a row, for numbers of size 1.
constexpr double kFeasible = 1e-12;
/// A normal less than this far outside the span of others, in units of rounding, depends on them.
constexpr double kDependent = 100;
/// Where nothing is to be found nearer than this, in units of the point's distance, nothing is said to be.
constexpr double kFar = 100;

}  // namespace

NearestPoint::End NearestPoint::search(const Polyhedron& polyhedron, int iteration_limit) {
  begin(polyhedron);
  for (Index row = 0; row < polyhedron.equalities; ++row)
    if (!meet_equality(row)) return End::empty;
  for (Index row = most_violated(); row >= 0; row = most_violated()) {
    Step step = Step::partial;
    while (step == Step::partial) {
      if (iterations_ == iteration_limit) return End::iterations;
      ++iterations_;
      step = approach(row);
    }
    if (step == Step::none) return End::empty;
  }
  return End::found;
}

void NearestPoint::begin(const Polyhedron& polyhedron) {
  polyhedron_ = &polyhedron;
  const Index n = polyhedron.normals.cols();
  iterations_ = 0;
  unmet_ = -1;
  above_unmet_ = false;
  z_.setZero(n);
  u_.setZero(n);
  working_.clear();
  working_.reserve(static_cast<std::size_t>(n));
  q_.setIdentity(n, n);
  r_.setZero(n, n);
  normal_.resize(n);
  projected_.resize(n);
  coefficients_.resize(n);
  direction_.resize(n);
  slacks_.resize(polyhedron.normals.rows());
  passed_over_.assign(static_cast<std::size_t>(polyhedron.normals.rows()), 0);
}

bool NearestPoint::meet_equality(Index row) {
  project(row);
  if (!dependent()) {
    add(row);
    solve_working_set();
  } else if (matters(std::abs(violation(row)))) {
    unmet_ = row;
    above_unmet_ = violation(row) < 0;
  }
  return unmet_ < 0;
}

/// The inequality constraint outside which the point is farthest; −1: it is outside none.
NearestPoint::Index NearestPoint::most_violated() {
  slacks_ = -polyhedron_->offsets;
  for (Index i = 0; i < z_.size(); ++i) slacks_ += z_[i] * polyhedron_->normals.col(i);
  for (const Index row : working_) slacks_[row] = 0;
  double least = -kFeasible * size();
  Index worst = -1;
  for (Index row = polyhedron_->equalities; row < slacks_.size(); ++row)
    if (slacks_[row] < least && !passed_over_[static_cast<std::size_t>(row)]) {
      least = slacks_[row];
      worst = row;
    }
  return worst;
}

/// A step towards the row: a full one up to it, or a partial one up to where a multiplier of the working set
/// becomes 0, whose row is given up. Where the working set leaves no direction, only multipliers change.
NearestPoint::Step NearestPoint::approach(Index row) {
  project(row);
  const double gap = violation(row);
  if (dependent() && !matters(gap)) {
    passed_over_[static_cast<std::size_t>(row)] = 1;
    solve_working_set();
    return Step::full;
  }
  const Index leaving = first_to_give_up();
  if (dependent() && leaving < 0) {
    unmet_ = row;
    for (Index i = 0; i < working_count(); ++i)
      if (is_inequality(i)) coefficients_[i] = std::min(0.0, coefficients_[i]);  // but for rounding they are
    return Step::none;
  }
  const double full = dependent() ? kUnlimited : std::max(0.0, gap / (rest_ * rest_));
  const double partial = leaving < 0 ? kUnlimited : u_[leaving] / coefficients_[leaving];
  if (full <= partial) {
    add(row);
    solve_working_set();
    std::fill(passed_over_.begin(), passed_over_.end(), 0);
    return Step::full;
  }
  if (!dependent()) z_ += partial * direction_;
  for (Index i = 0; i < working_count(); ++i) u_[i] = kept_sign(i, u_[i] - partial * coefficients_[i]);
  drop(leaving);
  return Step::partial;
}

/// Divides the normal of a row into what the working set spans and the rest.
void NearestPoint::project(Index row) {
  const Index n = z_.size(), count = working_count();
  normal_ = polyhedron_->normals.row(row);
  projected_.noalias() = q_.transpose() * normal_;
  coefficients_.head(count) = projected_.head(count);
  solve_triangle(coefficients_);
  rest_ = projected_.tail(n - count).norm();
  direction_.noalias() = q_.rightCols(n - count) * projected_.tail(n - count);
}

/// The inequality constraint of the working set whose multiplier becomes 0 first as that of the row to be met
/// grows; −1: none does.
NearestPoint::Index NearestPoint::first_to_give_up() const {
  const Index count = working_count();
  if (count == 0) return -1;
  const double least = polyhedron_->rounding * coefficients_.head(count).cwiseAbs().maxCoeff();
  double first = kUnlimited;
  Index leaving = -1;
  for (Index i = 0; i < count; ++i) {
    if (!is_inequality(i) || coefficients_[i] <= least) continue;
    const double length = u_[i] / coefficients_[i];
    if (length < first || (length == first && working_row(i) < working_row(leaving))) {
      first = length;
      leaving = i;
    }
  }
  return leaving;
}

/// Takes the projected row into the working set.
void NearestPoint::add(Index row) {
  const Index last = working_count();
  Eigen::JacobiRotation<double> rotation;
  for (Index i = z_.size() - 1; i > last; --i) {
    rotation.makeGivens(projected_[i - 1], projected_[i]);
    projected_.applyOnTheLeft(i - 1, i, rotation.adjoint());
    q_.applyOnTheRight(i - 1, i, rotation);
  }
  r_.col(last).head(last + 1) = projected_.head(last + 1);
  working_.push_back(row);
}

void NearestPoint::drop(Index position) {
  const Index last = working_count() - 1;
  working_.erase(working_.begin() + position);
  Eigen::JacobiRotation<double> rotation;
  for (Index i = position; i < last; ++i) {
    u_[i] = u_[i + 1];
    r_.col(i).head(i + 2) = r_.col(i + 1).head(i + 2);
  }
  for (Index i = position; i < last; ++i) {
    rotation.makeGivens(r_(i, i), r_(i + 1, i));
    r_.middleCols(i, last - i).applyOnTheLeft(i, i + 1, rotation.adjoint());
    q_.applyOnTheRight(i, i + 1, rotation);
  }
}

/// The point and its multipliers as the working set alone has them, so that rounding does not gather over
/// steps: z = Q₁R⁻ᵀ offsets, and R multipliers = Q₁ᵀz.
void NearestPoint::solve_working_set() {
  const Index count = working_count();
  for (Index i = 0; i < count; ++i) u_[i] = polyhedron_->offsets[working_row(i)];
  solve_transposed_triangle(u_);
  z_.noalias() = q_.leftCols(count) * u_.head(count);
  solve_triangle(u_);
  for (Index i = 0; i < count; ++i) u_[i] = kept_sign(i, u_[i]);
}

void NearestPoint::correct(const Eigen::VectorXd& pull, const Eigen::VectorXd& gaps,
                           Eigen::VectorXd& change) {
  const Index count = working_count();
  projected_.noalias() = q_.transpose() * pull;
  coefficients_.head(count) = gaps.head(count);
  solve_transposed_triangle(coefficients_);
  for (Index i = 0; i < count; ++i) {
    const double along = coefficients_[i];
    coefficients_[i] = along - projected_[i];
    projected_[i] = along;
  }
  change.noalias() = q_ * projected_;
  solve_triangle(coefficients_);
  for (Index i = 0; i < count; ++i) u_[i] = kept_sign(i, u_[i] + coefficients_[i]);
}

void NearestPoint::solve_triangle(Eigen::Ref<Eigen::VectorXd> v) const {
  const Index count = working_count();
  r_.topLeftCorner(count, count).triangularView<Eigen::Upper>().solveInPlace(v.head(count));
}

void NearestPoint::solve_transposed_triangle(Eigen::Ref<Eigen::VectorXd> v) const {
  const Index count = working_count();
  r_.topLeftCorner(count, count).transpose().triangularView<Eigen::Lower>().solveInPlace(v.head(count));
}

bool NearestPoint::is_inequality(Index position) const {
  return working_row(position) >= polyhedron_->equalities;
}

/// A multiplier, which rounding does not turn into one of the wrong sign.
double NearestPoint::kept_sign(Index position, double multiplier) const {
  return is_inequality(position) ? std::max(0.0, multiplier) : multiplier;
}

bool NearestPoint::dependent() const { return rest_ <= kDependent * polyhedron_->rounding; }

double NearestPoint::violation(Index row) const { return polyhedron_->offsets[row] - normal_.dot(z_); }

/// Is a dependent row's violation more than what rounding leaves of those of the working set, of which it is
/// made? And than what the rest of its normal could make up for, not farther away than kFar times what the
/// point is?
bool NearestPoint::matters(double violation) const {
  const double sum = coefficients_.head(working_count()).lpNorm<1>();
  return violation > (polyhedron_->rounding * (1 + sum) + kFar * rest_) * size();
}

}  // namespace limpet::kinematics
