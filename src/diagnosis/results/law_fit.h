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

/// A number of a list of entries that a fit moves, by the logarithm of its ratio to the start: it keeps its sign.
struct NumberPlace {
  std::size_t entry = 0;
  std::string key;
  std::size_t index = 0;  ///< in the list of that key
};

/// The numbers of entries that count: scales and shapes that are given, each of a list; not choices and references, nor
/// a value at the end of its range.
std::vector<NumberPlace> numbersOf(const Entries& entries);

/// One member of a hypothesis: by its basis terms, or by entries whose numbers are free.
struct MemberLaw {
  int member = 0;                     ///< by its index among the candidates
  std::vector<fit::BasisTerm> terms;  ///< empty where entries stand for it
  Entries start;
  /// Largest value of the times among the numbers of the entries [s]: logs do not distinguish longer ones.
  double longest_time = std::numeric_limits<double>::infinity();

  std::size_t size() const { return terms.empty() ? numbersOf(start).size() : terms.size(); }

  /// Its entries where its part of the scales is this.
  Entries at(const Eigen::VectorXd& scales) const;
};

/// All members of a hypothesis.
struct Law {
  std::vector<MemberLaw> members;
  fit::Hypothesis about;  ///< what is free in each log; without terms

  /// As the fit has it: the numbers of its entries as terms with bounds and without entries of their own.
  fit::Hypothesis hypothesis() const;

  /// Entries of each member at these scales.
  std::vector<Entries> at(const Eigen::VectorXd& scales) const;
};

/// A law and where its fit ended.
struct FittedLaw {
  Law law;
  fit::Fit fit;
};

/// A law, and how probable it is over the first of several.
struct WeighedLaw {
  FittedLaw fitted;
  double odds = 1.0;
};

}  // namespace rubber_suspension::diagnosis::results
