// Held-out errors of many hypotheses at once, to choose those that are worth a full fit.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// A hypothesis by its members, and its held-out error.
struct Screened {
  std::vector<int> members;
  double error;
};

/// Normal equations of a model with the basis terms of all candidates, linearised about one fit. The error of any
/// hypothesis follows from them without a simulation. There is one set for each combination of per-log unknowns. Fitter
/// and candidates have to outlive this object.
class Screening {
 public:
  /// Linearises about a fitted hypothesis, with the scales of all other candidates at 0. The laws that follow a curve
  /// in this hypothesis follow it here.
  Screening(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
            const FittedHypothesis& about, int threads);

  /// Returns the hypothesis of a set. Of several laws that a member contains, it is beyond one: a law of the hypothesis
  /// of the linearisation, or else the law with the least error by itself.
  fit::Hypothesis hypothesisOf(const std::vector<int>& members) const;

  /// Returns the held-out error of a set.
  Screened screen(std::vector<int> members) const;

  /// Returns the in-sample error of a set, which takes less time than screen().
  double leftBy(const std::vector<int>& members) const;

  /// Screens a set with each of these candidates added. Returns the best sets, sorted by error.
  std::vector<Screened> additions(const std::vector<int>& candidates, const std::vector<int>& members) const;

  /// Screens sets of `effects` members in which the candidates that a member contains replace it: they explain much the
  /// same with fewer numbers. Returns the best sets, sorted by error.
  std::vector<Screened> withContained(const std::vector<int>& candidates, const std::vector<int>& members,
                                      std::size_t effects) const;

  /// Screens all pairs of these candidates. Returns the best pairs, sorted by error.
  std::vector<Screened> pairs(const std::vector<int>& candidates) const;

  /// Returns the parameters of a set with the least error, within one step of a fit.
  fit::ParameterVector bestOf(const std::vector<int>& members) const;

  /// Returns the normal equations after elimination of the per-log unknowns `free`. The columns are the model
  /// parameters, the basis terms of one candidate after the other, and the residual.
  const fit::BlockGrams& blocks(const fit::PerLogNuisances& free = {}) const { return blocks_[placeOf(free)]; }
  Eigen::Index modelSize() const { return model_size_; }
  /// Returns the columns of each candidate, its own terms before those of the laws that it contains.
  const std::vector<std::vector<Eigen::Index>>& columnsOf() const { return columns_of_; }
  const std::vector<fit::BasisTerm>& terms() const { return all_.terms; }
  const std::vector<fit::Candidate>& candidates() const { return candidates_; }

  /// Returns the part of each candidate's force that model parameters cannot reproduce, and whether its typical size is
  /// visible beside the noise.
  std::vector<Visibility> visibility(double noise) const;

 private:
  /// Columns of a hypothesis among all, and the bounds of their steps.
  struct Part {
    std::vector<Eigen::Index> columns;
    numerics::Limits bounds;
    fit::PerLogNuisances free;
  };
  static std::size_t placeOf(const fit::PerLogNuisances& free) {
    return (free.trend ? 1U : 0U) + (free.offset ? 2U : 0U) + (free.gain ? 4U : 0U);
  }
  Part partOf(const std::vector<int>& members) const;
  /// Returns the columns of the terms of a hypothesis.
  std::vector<Eigen::Index> columnsOf(const fit::Hypothesis& hypothesis) const;
  void preferLawsAtWork(const fit::Hypothesis& about);
  /// Returns true if a candidate may join a set: it contains no member, and no member contains it.
  bool joins(int candidate, const std::vector<int>& members) const;
  std::vector<Screened> screenAll(const std::vector<std::vector<int>>& sets) const;

  const std::vector<fit::Candidate>& candidates_;
  Eigen::Index model_size_;
  int threads_;
  fit::ParameterVector about_;  // of all candidates
  fit::Hypothesis all_;
  std::vector<std::vector<Eigen::Index>> columns_of_;
  std::vector<int> preferred_;           // order of laws that others contain
  std::vector<fit::BlockGrams> blocks_;  // by placeOf()
  numerics::Limits bounds_;
};

}  // namespace rubber_suspension::diagnosis::hypotheses
