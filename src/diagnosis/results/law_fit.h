// Fits of laws with few numbers, all of which are free: shapes as well as scales.
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

/// Place of a number in a list of entries. A fit varies the logarithm of its ratio to the start: the sign is kept.
struct NumberPlace {
  std::size_t entry = 0;
  std::string key;
  std::size_t index = 0;  ///< in the list of that key
};

/// Returns the numbers that a fit varies: scales and shapes, each number of a list; neither choices and references nor
/// values at an end of their range.
std::vector<NumberPlace> numbersOf(const Entries& entries);

/// Law of one member of a hypothesis: basis terms, or entries whose numbers are free.
struct MemberLaw {
  int member = 0;                     ///< index among the candidates
  std::vector<fit::BasisTerm> terms;  ///< empty if the law is `start`
  Entries start;
  /// Upper bound of the times among the numbers of `start` [s]: logs do not distinguish longer ones.
  double longest_time = std::numeric_limits<double>::infinity();

  std::size_t size() const { return terms.empty() ? numbersOf(start).size() : terms.size(); }

  /// Returns the entries at these scales of its terms or numbers.
  Entries at(const Eigen::VectorXd& scales) const;
};

/// All members of a hypothesis.
struct Law {
  std::vector<MemberLaw> members;
  fit::Hypothesis about;  ///< unknowns in each log; without terms

  /// Returns the hypothesis for a fit: numbers of entries become terms with bounds and without entries of their own.
  fit::Hypothesis hypothesis() const;

  /// Returns the entries of each member at these scales.
  std::vector<Entries> at(const Eigen::VectorXd& scales) const;
};

/// A law and its fit.
struct FittedLaw {
  Law law;
  fit::Fit fit;
};

/// A law, and its odds over the first of several laws.
struct WeighedLaw {
  FittedLaw fitted;
  double odds = 1.0;
};

}  // namespace rubber_suspension::diagnosis::results
