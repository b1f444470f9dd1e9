// Fits laws with few numbers. All of these numbers are free, shape parameters as well as scales.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "fit/hypothesis.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis::results {

using Entries = std::vector<element::ElementDescription>;

/// Position of a number in a list of entries. A fit varies ln(number / start), so that the sign cannot change.
struct NumberPlace {
  std::size_t entry = 0;
  std::string key;
  std::size_t index = 0;  ///< index in the list of that key
};

/// Returns the numbers that a fit varies: scales and shape parameters, and each number of a list. Numbers that select
/// an option or state a reference are not varied, and neither are values at an end of their range.
std::vector<NumberPlace> numbersOf(const Entries& entries);

/// Law of one effect of a hypothesis (a member). It consists of basis terms, or of entries whose numbers are free.
struct MemberLaw {
  int member = 0;                     ///< index among the candidates
  std::vector<fit::BasisTerm> terms;  ///< empty if the law consists of `start`
  Entries start;
  /// Upper bound of the times in `start` [s]. The logs cannot distinguish longer times.
  double longest_time = std::numeric_limits<double>::infinity();

  std::size_t size() const { return terms.empty() ? numbersOf(start).size() : terms.size(); }

  /// Returns the entries of the law. `scales` contains the scale of each term, or ln(number / start) for each number.
  Entries at(const Eigen::VectorXd& scales) const;
};

struct Law {
  std::vector<MemberLaw> members;
  fit::Hypothesis about;  ///< contains only the parameters that are free in each log

  /// Returns the hypothesis for a fit. Numbers of entries become terms that have bounds, but no entries of their own.
  fit::Hypothesis hypothesis() const;

  std::vector<Entries> at(const Eigen::VectorXd& scales) const;
};

struct FittedLaw {
  Law law;
  fit::Fit fit;
};

/// A law, and its odds relative to the first of several laws.
struct WeighedLaw {
  FittedLaw fitted;
  double odds = 1.0;
};

}  // namespace rubber_suspension::diagnosis::results
