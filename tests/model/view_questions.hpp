// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <sstream>
#include <string>
#include <tuple>

#include "view_truth.hpp"

/// Questions about places that tell most, and what is wrong with their answers.
namespace limpet::model::testing {

/// A model, the window onto it, and the truth about it.
struct Asked {
  explicit Asked(const Model& model) : view(model.view()), truth(model.record()) {}
  View view;
  TrueModel truth;
  /// Some of the rounding that coordinates of this size, and the model's, come with.
  Real rounding(Real size) const { return 1e-12L * std::max(size, truth.size); }
};

struct Question {
  Vector3d p = Vector3d::Zero(), q = Vector3d::Zero();  ///< a place; another one, or where a ray goes
  double radius = 0, reach = 0;
  Which which;
};

inline std::string text_of(const Question& q) {
  std::ostringstream out;
  out.precision(17);
  out << "p {" << q.p.transpose() << "} q {" << q.q.transpose() << "} radius " << q.radius << " reach "
      << q.reach << " only " << q.which.only.value << " but " << q.which.but.value << " kinds "
      << q.which.polygons << q.which.points << q.which.initial;
  return out.str();
}

/// At a vertex, on an edge, near the middle of a polygon or a hole, in its plane, or a little beside.
inline Vector3d telling_place(const TrueModel& model, Random& random) {
  const Real lambda = model.resolution;
  if (model.segments.empty()) return model.resolution * Vector3d(random.normal(), random.normal(), 0);
  const TrueSegment& s = model.segments[random.below(model.segments.size())];
  Vector p = s.some_point();
  if (s.polygon()) {
    const auto some_edge = [&] { return s.edges()[random.below(s.edges().size())]; };
    const auto edge = some_edge();
    const auto how = random.below(5);
    if (how == 0) p = edge.from;
    if (how == 1) p = edge.from + Real(random.uniform()) * (edge.to - edge.from);
    if (how == 2) p = (edge.from + some_edge().from + some_edge().to) / 3;
    if (how == 3) p = edge.from + Real(random.uniform(-1, 2)) * (some_edge().from - edge.from);
    if (how == 4) p = (edge.from + edge.to) / 2;
    if (random.below(3) == 0) p += lambda * Real(4 * random.normal()) * s.normal();
  }
  const auto beside = random.below(6);
  const Vector off(random.normal(), random.normal(), random.normal());
  if (beside == 1) p += Real(1e-4) * lambda * off;
  if (beside == 2) p += lambda * off;
  if (beside == 3) p += 10 * lambda * off;
  if (beside == 4 && random.below(4) == 0) p += Real(std::pow(10, random.uniform(2, 9))) * lambda * off;
  return p.cast<double>();
}

inline Which any_which(const TrueModel& model, Random& random) {
  Which which;
  if (random.below(2) || model.segments.empty()) return which;
  const SegmentId some = model.segments[random.below(model.segments.size())].id();
  const auto how = random.below(6);
  if (how == 0) which.only = some;
  if (how == 1) which.but = some;
  if (how == 2) which.points = false;
  if (how == 3) which.polygons = false;
  if (how == 4) which.initial = false;
  if (how == 5) which.but = some, which.points = false;
  return which;
}

inline Question any_question(const TrueModel& model, Random& random) {
  Question question;
  question.p = telling_place(model, random);
  question.q = random.below(8) == 0 ? question.p
               : random.below(3) == 0
                   ? telling_place(model, random)
                   : Vector3d(question.p + 5 * model.resolution * random.uniform() *
                                               Vector3d(random.normal(), random.normal(),
                                                        random.below(4) ? random.normal() : 0));
  if (random.below(4)) question.radius = 2 * model.resolution * random.uniform();
  const auto how = random.below(8);
  question.reach = how == 0   ? 0
                   : how == 1 ? std::numeric_limits<double>::infinity()
                   : how == 2 ? 1e6 * model.resolution
                              : model.resolution * std::pow(10, random.uniform(-2, 1.5));
  question.which = any_which(model, random);
  return question;
}

/// Each segment asked alone; of those that answer the best by (distance, segment), and all in that order.
template <class Found, class AskAlone>
std::vector<Found> one_by_one(const TrueModel& model, const Which& which, AskAlone&& ask) {
  std::vector<Found> all;
  for (const TrueSegment& s : model.segments) {
    if (!is_asked(which, s)) continue;
    Which alone = which;
    alone.only = s.id();
    if (const auto found = ask(alone)) all.push_back(*found);
  }
  std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) {
    return std::tie(a.distance, a.segment) < std::tie(b.distance, b.segment);
  });
  return all;
}

inline bool same(const View::Nearest& a, const View::Nearest& b) {
  return a.at == b.at && a.distance == b.distance && a.segment == b.segment && a.edge == b.edge;
}
inline bool same(const View::LinkNearest& a, const View::LinkNearest& b) {
  return a.at == b.at && a.distance == b.distance && a.segment == b.segment && a.edge == b.edge &&
         a.on_axis == b.on_axis && a.fraction == b.fraction && a.away == b.away;
}
inline bool same(const View::Hit& a, const View::Hit& b) {
  return a.at == b.at && a.range == b.range && a.segment == b.segment && a.from_outside == b.from_outside;
}

/// Are the best one, and all, what comes of asking one by one? What is wrong, else nothing.
template <class Found>
std::string compare(const std::optional<Found>& best, const std::vector<Found>& all,
                    const std::vector<Found>& expected) {
  if (best.has_value() == expected.empty()) return best ? "found what is not there" : "missed the nearest";
  if (best && !same(*best, expected.front())) return "found another one than the nearest";
  if (all.size() != expected.size()) return "found too many or too few";
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!same(all[i], expected[i])) return "found others, or in another order";
  return {};
}

/// Is `at` of the segment, and on the edge that is named, if one is?
inline std::string judge_place(const TrueSegment& s, const Vector3d& at, geometry::EdgeId edge,
                               Real rounding) {
  if (s.distance(at.cast<Real>()) > rounding) return "not of the segment";
  if (!edge) return {};
  for (const auto& e : s.edges())
    if (e.id == edge)
      return truth_distance(e.from, e.to, at.cast<Real>()) > rounding ? "not on the edge" : "";
  return "no such edge";
}

/// Are the distances right, and has no segment been missed? `distance` of a segment by the plain formulas.
template <class Found, class Distance>
std::string judge_all(const TrueModel& model, const Question& q, const std::vector<Found>& all, Real rounding,
                      Distance&& distance) {
  for (const TrueSegment& s : model.segments) {
    if (!is_asked(q.which, s)) continue;
    const Real truth = distance(s);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Found& f) { return f.segment == s.id(); });
    if (found == all.end()) {
      if (truth < q.reach - rounding) return "missed segment " + std::to_string(s.id().value);
      continue;
    }
    if (std::abs(found->distance - truth) > rounding)
      return "distance of segment " + std::to_string(s.id().value) + " off by " +
             std::to_string(static_cast<double>((found->distance - truth) / model.resolution)) + " lambda";
    if (auto wrong = judge_place(s, found->at, found->edge, rounding); !wrong.empty()) return wrong;
  }
  return {};
}

inline std::string judge_point(const Asked& asked, const Question& q) {
  const auto best = asked.view.nearest(q.p, q.reach, q.which);
  std::vector<View::Nearest> all;
  asked.view.nearest(q.p, q.reach, all, q.which);
  const auto expected = one_by_one<View::Nearest>(
      asked.truth, q.which, [&](const Which& alone) { return asked.view.nearest(q.p, q.reach, alone); });
  if (auto wrong = compare(best, all, expected); !wrong.empty()) return "point: " + wrong;
  const Vector p = q.p.cast<Real>();
  const std::string wrong = judge_all(asked.truth, q, all, asked.rounding(p.cwiseAbs().maxCoeff()),
                                      [&](const TrueSegment& s) { return s.distance(p); });
  return wrong.empty() ? wrong : "point: " + wrong;
}

inline std::string judge_link(const Asked& asked, const Question& q) {
  const Capsule link{q.p, q.q, q.radius};
  const auto best = asked.view.nearest(link, q.reach, q.which);
  std::vector<View::LinkNearest> all;
  asked.view.nearest(link, q.reach, all, q.which);
  const auto expected = one_by_one<View::LinkNearest>(
      asked.truth, q.which, [&](const Which& alone) { return asked.view.nearest(link, q.reach, alone); });
  if (auto wrong = compare(best, all, expected); !wrong.empty()) return "link: " + wrong;
  const Vector a = q.p.cast<Real>(), b = q.q.cast<Real>();
  const Real rounding = asked.rounding(std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) + q.radius);
  for (const auto& f : all) {
    const Vector3d on = q.p + f.fraction * (q.q - q.p);
    if ((on - f.on_axis).norm() > rounding || f.fraction < 0 || f.fraction > 1)
      return "link: not on the axis";
    if (std::abs((f.at - f.on_axis).norm() - q.radius - f.distance) > rounding) return "link: distance";
    if (std::abs(f.away.norm() - 1) > 1e-12) return "link: no unit vector away";
    const double apart = f.distance + q.radius;
    if (((f.at + apart * f.away) - f.on_axis).norm() > rounding) return "link: another way away";
  }
  const std::string wrong = judge_all(asked.truth, q, all, rounding,
                                      [&](const TrueSegment& s) { return s.distance(a, b) - q.radius; });
  return wrong.empty() ? wrong : "link: " + wrong;
}

/// The ray of a question; nothing where it has no direction.
inline std::optional<Vector3d> axis_of(const Question& q) {
  if (q.p == q.q) return std::nullopt;
  return Vector3d(q.q - q.p);
}

inline std::string judge_ray(const Asked& asked, const Question& q) {
  const auto axis = axis_of(q);
  if (!axis) return {};
  const auto first = asked.view.first_hit(q.p, *axis, q.reach, q.which);
  std::optional<View::Hit> expected;
  const Vector from = q.p.cast<Real>(), along = axis->cast<Real>().normalized();
  Real size = from.cwiseAbs().maxCoeff();
  if (first) size = std::max(size, first->at.cwiseAbs().maxCoeff() * Real(1));
  const Real rounding = asked.rounding(size);
  for (const TrueSegment& s : asked.truth.segments) {
    if (!is_asked(q.which, s)) continue;
    Which alone = q.which;
    alone.only = s.id();
    const auto hit = asked.view.first_hit(q.p, *axis, q.reach, alone);
    if (hit && (!expected || hit->range < expected->range)) expected = hit;
    if (!s.polygon()) {
      if (hit) return "ray: met a point segment";
      continue;
    }
    // Where the ray is steep enough for the place to be well known, what is surely inside must be met, and
    // what is surely outside not.
    const Real climb = along.dot(s.normal()), t = -s.height(from) / climb;
    if (!(std::abs(climb) > 1e-3L) || !(std::abs(t) < 1e9L * asked.truth.resolution)) continue;
    const Real unsure = 1e4L * (rounding + 1e-12L * std::abs(t));
    const Vector at = from + t * along;
    const bool surely = s.distance_from_edges(at) > unsure, inside = s.holds(at);
    if (surely && inside && t > unsure && t < q.reach - unsure && !hit)
      return "ray: passed through segment " + std::to_string(s.id().value);
    if (hit && surely && !inside)
      return "ray: met segment " + std::to_string(s.id().value) + " outside of it";
    if (hit && std::abs(hit->range - t) > unsure) return "ray: range";
    if (hit && (hit->at.cast<Real>() - at).norm() > unsure) return "ray: place";
    if (hit && hit->from_outside != (climb < 0)) return "ray: side";
  }
  if (first.has_value() != expected.has_value()) return "ray: found what is not there, or nothing";
  if (first && !same(*first, *expected)) return "ray: found another one than the first";
  return {};
}

/// What is wrong with the answers to a question, all three kinds of it; nothing when they are right.
inline std::string judge(const Asked& asked, const Question& q) {
  for (const auto& ask : {judge_point, judge_link, judge_ray})
    if (auto wrong = ask(asked, q); !wrong.empty()) return wrong + ": " + text_of(q);
  return {};
}

}  // namespace limpet::model::testing
