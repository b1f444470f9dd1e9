// Fits of laws with few numbers, all of which are free: shapes as well as scales.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fit/fitter.h"
#include "gap/simulate.h"
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
  /// That a number of the entries may grow to [s]: logs do not tell it from longer ones.
  double longest_time = std::numeric_limits<double>::infinity();

  std::size_t size() const { return terms.empty() ? numbersOf(start).size() : terms.size(); }

  /// Its entries where its part of the scales is this.
  Entries at(const Eigen::VectorXd& scales) const;
};

/// All members of a hypothesis.
struct Law {
  std::vector<MemberLaw> members;
  fit::Hypothesis about;  ///< what is free in each log; without terms

  /// The bounds of each unknown, for the fit.
  fit::Hypothesis hypothesis() const;

  /// Entries of each member at these scales.
  std::vector<Entries> at(const Eigen::VectorXd& scales) const;
};

/// A law and where its fit ended.
struct FittedLaw {
  Law law;
  fit::Fit fit;
};

/// Forces of a law about a model over some records [N].
class LawForces {
 public:
  /// The model has to outlive it.
  LawForces(std::shared_ptr<const std::vector<log::Record>> records, const fit::ModelParameters& model, const Law& law);

  /// Nothing where the model has no solution, or a law none of these numbers.
  std::optional<gap::Forces> at(const fit::ParameterVector& parameters) const;

  /// Derivatives by the model's parameters and by the scales, `base` being the forces there; on up to `threads`
  /// threads.
  std::vector<fit::ForceColumn> columns(const fit::ParameterVector& parameters, const gap::Forces& base,
                                        int threads) const;

 private:
  // Scales of the members that have terms, in the order of terms_.
  fit::ParameterVector ofTerms(const fit::ParameterVector& parameters) const;
  Entries entriesAt(const Eigen::VectorXd& scales) const;
  // Derivative by a number of entries, the unknown at this place among all scales.
  fit::ForceColumn byNumber(const fit::ParameterVector& parameters, const gap::Forces& base,
                            const fit::BasisTerm& number, Eigen::Index t) const;

  fit::HypothesisForces forces_;
  Law law_;
  fit::Hypothesis terms_;             // of the members that have terms
  std::vector<Eigen::Index> places_;  // of these among all scales
};

/// Fits a law to the records of a fitter, which has to outlive it, on up to `threads` threads.
class LawFitter final : public fit::HypothesisFitter {
 public:
  LawFitter(const fit::Fitter& fitter, const Law& law, int threads);

 private:
  std::optional<gap::Forces> simulate(const fit::Hypothesis& /*hypothesis*/,
                                      const fit::ParameterVector& parameters) const override {
    return forces_.at(parameters);
  }
  double gapOf(const fit::Hypothesis& hypothesis, const gap::Forces& forces) const override {
    return fitter_.gapOf(hypothesis, forces);
  }
  /// Few unknowns, all of which move.
  std::vector<fit::BlockGrams> normalEquationsAbout(const fit::Hypothesis& /*hypothesis*/,
                                                    const fit::ParameterVector& parameters, const gap::Forces& base,
                                                    const Linearised& how) const override {
    return fitter_.blocks().normalEquations(base, forces_.columns(parameters, base, threads_), how.free, how.kept,
                                            threads_);
  }

  const fit::Fitter& fitter_;
  LawForces forces_;
  int threads_;
};

}  // namespace rubber_suspension::diagnosis::results
