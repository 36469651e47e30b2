// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/open_edges.hpp>
#include <vector>

#include "sections_internal.hpp"

namespace limpet::model::internal {

/// Sections P and Q that fulfil the conditions of thesis §2.6; the changed perimeters have not been judged
/// yet.
struct SectionPair {
  const Side &side_p, &side_q;
  const Section &p, &q;
  geometry::Point2 begin_p, end_p, begin_q, end_q;  ///< ends of L in the two charts
  bool joins = false;                               ///< L replaces edges that the two share already
};

/// All chains of two segments along their line, and their concavity there.
struct PairOfChains {
  std::vector<LineChain> of_a, of_b;
  Concavity concavity = Concavity::undecided;
};
/// Nothing when one of the two has no chain in the window.
std::optional<PairOfChains> chains_of_both(const Complex&, const Segment& a, const Segment& b,
                                           const CommonLine&, const LineWindow&, const SharingReach&);

/// Receives the pairs of sections that a search finds.
class SectionUser {
 public:
  virtual ~SectionUser() = default;
  /// Forms a shared edge from the pair. Refusal::none ends the search.
  virtual Refusal form(const SectionPair&) = 0;
  /// Told for each stretch of the line, between two places, from which nothing could be formed.
  virtual void refused(const Side&, const Side&, double /*begin*/, double /*end*/, Refusal) {}
};

/// Searches the chains of two segments along their line for a pair of sections, the longest first.
class SectionSearch {
 public:
  /// Precondition: the concavity is decided.
  SectionSearch(const Complex&, const Segment& a, const Segment& b, const CommonLine&, const SharingReach&,
                const PairOfChains&);

  /// Returns whether an edge was formed.
  bool run(SectionUser&);

 private:
  /// A stretch of the line beside which an edge of a chain lies beyond it, if only in part.
  struct Beyond {
    double begin, end;
    std::size_t chain;
  };
  static std::vector<Beyond> beyond_line(const std::vector<LineChain>&);
  bool goes_on_beyond(double begin, double end) const;
  void set_scale(double low, double high);
  bool form(const LineChain& p, const LineChain& q);
  bool form_between(std::size_t low, std::size_t high);
  bool form_section(double begin, double end);
  Refusal try_section(double begin, double end);
  bool correspond(const std::vector<geometry::EdgeId>& on_p, const std::vector<geometry::EdgeId>& on_q) const;
  geometry::Point2 seen_in(const Segment&, double place) const;

  const Complex& complex_;
  const Segment &a_, &b_;
  const CommonLine& line_;
  double sign_;
  SharingReach reach_;
  bool neighbours_;          ///< do the two share edges already?
  double lambda_ = 0;        ///< between the chains that are tried, scan's unit, as the following
  double least_length_ = 0;  ///< least length of L
  double at_angle_ = 0;      ///< SharingReach::at_angle() of the line
  double overshoot_ = 0;     ///< by which sections between ends of shared edges may overshoot them
  std::vector<LineChain> chains_p_, chains_q_;
  std::vector<Beyond> beyond_p_, beyond_q_;
  SectionUser* user_ = nullptr;
  std::size_t p_at_ = 0, q_at_ = 0;  ///< indices of the chains being tried
  Side p_, q_;
  std::vector<double> places_;
};

}  // namespace limpet::model::internal
