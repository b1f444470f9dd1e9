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

/// Normal equations with the basis terms of all candidates, from which any hypothesis about the same model follows as
/// if it were linear: one set for each choice of what is free in a log. Fitter and candidates have to outlive it.
class Screening {
 public:
  /// About a fitted hypothesis: its model parameters and scales, all other candidates at nothing. Along a curve are
  /// those that are in it.
  Screening(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
            const FittedHypothesis& about, int threads);

  /// A set as it is screened: of several laws that a member contains, beyond the one that leaves least by itself.
  fit::Hypothesis hypothesisOf(const std::vector<int>& members) const;

  Screened screen(std::vector<int> members) const;

  /// In-sample error of a hypothesis, which is found faster.
  double leftBy(const std::vector<int>& members) const;

  /// Each other one of these candidates added to a set, best first.
  std::vector<Screened> additions(const std::vector<int>& candidates, const std::vector<int>& members) const;

  /// Sets of so many, with those of these candidates that a member contains in its place: they do much the same, with
  /// fewer numbers.
  std::vector<Screened> withContained(const std::vector<int>& candidates, const std::vector<int>& members,
                                      std::size_t effects) const;

  /// The best of all pairs of these candidates, best first.
  std::vector<Screened> pairs(const std::vector<int>& candidates) const;

  /// Where the parameters of a hypothesis leave least.
  fit::ParameterVector bestOf(const std::vector<int>& members) const;

  /// The normal equations: model parameters, basis terms of one candidate after the other, residual. What is free in
  /// each log is taken out. A candidate's own terms come first among its columns.
  const fit::BlockGrams& blocks(const fit::PerLogNuisances& free = {}) const { return blocks_[placeOf(free)]; }
  Eigen::Index modelSize() const { return model_size_; }
  const std::vector<std::vector<Eigen::Index>>& columnsOf() const { return columns_of_; }
  const std::vector<fit::BasisTerm>& terms() const { return all_.terms; }
  const std::vector<fit::Candidate>& candidates() const { return candidates_; }

  /// Part of each candidate's force that the model parameters cannot take over, and whether a typical size of it stands
  /// out of the noise.
  std::vector<Visibility> visibility(double noise) const;

 private:
  /// Columns of a hypothesis among all, and how far each may move.
  struct Part {
    std::vector<Eigen::Index> columns;
    numerics::Limits bounds;
    fit::PerLogNuisances free;
  };
  static std::size_t placeOf(const fit::PerLogNuisances& free) {
    return (free.trend ? 1U : 0U) + (free.offset ? 2U : 0U) + (free.gain ? 4U : 0U);
  }
  Part partOf(const std::vector<int>& members) const;
  /// The columns of the terms of a hypothesis.
  std::vector<Eigen::Index> columnsOf(const fit::Hypothesis& hypothesis) const;
  void preferLawsAtWork(const fit::Hypothesis& about);
  /// True if a candidate and a set make a larger set: neither contains the other.
  bool joins(int candidate, const std::vector<int>& members) const;
  std::vector<Screened> screenAll(const std::vector<std::vector<int>>& sets) const;

  const std::vector<fit::Candidate>& candidates_;
  Eigen::Index model_size_;
  int threads_;
  fit::ParameterVector about_;  // of all candidates
  fit::Hypothesis all_;
  std::vector<std::vector<Eigen::Index>> columns_of_;
  std::vector<int> preferred_;           // of laws that others contain
  std::vector<fit::BlockGrams> blocks_;  // at placeOf() what is free
  numerics::Limits bounds_;
};

}  // namespace rubber_suspension::diagnosis::hypotheses
