// Predicts the held-out errors of many hypotheses at once, to choose those that are worth a full fit.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// A set of effects and its held-out error.
struct Screened {
  std::vector<int> members;
  double error;
};

/// Normal equations of a model with the basis terms of all candidates, linearised about one fit. The error of any
/// hypothesis follows from them without a simulation. There is one system for each combination of per-log nuisance
/// parameters. The fitter and the candidates have to outlive this object.
class Screening {
 public:
  /// Linearises about a fitted hypothesis, in which the scales of all other candidates are 0. Laws that follow a curve
  /// in this hypothesis follow the same curve here.
  Screening(const fit::HypothesisFitter& fitter, const std::vector<fit::Candidate>& candidates,
            const FittedHypothesis& about, int threads);

  /// Returns the hypothesis with these effects. If an effect contains several laws, the terms of one of them are added:
  /// those of a law that is in the hypothesis about which this object is linearised or, if there is none, those of the
  /// law with the least error when fitted alone.
  fit::Hypothesis hypothesisOf(const std::vector<int>& members) const;

  /// Returns a set of effects with its held-out error.
  Screened screen(std::vector<int> members) const;

  /// Returns the error of a set on the blocks to which it is fitted. This takes less time than screen().
  double leftBy(const std::vector<int>& members) const;

  /// Adds each of these candidates to a set and screens the results. Returns the best sets, sorted by error.
  std::vector<Screened> additions(const std::vector<int>& candidates, const std::vector<int>& members) const;

  /// Replaces each effect of a set by candidates that its law contains, which may explain the logs almost as well with
  /// fewer parameters. Returns the best of the resulting sets with `effects` members, sorted by error.
  std::vector<Screened> withContained(const std::vector<int>& candidates, const std::vector<int>& members,
                                      std::size_t effects) const;

  /// Screens all pairs of these candidates. Returns the best pairs, sorted by error.
  std::vector<Screened> pairs(const std::vector<int>& candidates) const;

  /// Returns the parameters of a set at which its error is least, within one step of a fit.
  fit::ParameterVector bestOf(const std::vector<int>& members) const;

  /// Returns the normal equations after elimination of the per-log nuisance parameters `free`. Their columns are the
  /// model parameters, followed by the basis terms of each candidate and the residual.
  const fit::BlockGrams& blocks(const fit::PerLogNuisances& free = {}) const { return blocks_[placeOf(free)]; }
  Eigen::Index modelSize() const { return model_size_; }
  /// Returns the columns of each candidate. Those of its own terms precede those of the laws that it contains.
  const std::vector<std::vector<Eigen::Index>>& columnsOf() const { return columns_of_; }
  const std::vector<fit::BasisTerm>& terms() const { return all_.terms; }
  const std::vector<fit::Candidate>& candidates() const { return candidates_; }

  /// Returns, for each candidate, the part of its force that model parameters cannot reproduce, and whether an effect
  /// of typical size would be visible in noise of this level.
  std::vector<Visibility> visibility(double noise) const;

 private:
  /// The columns of one hypothesis, and the bounds of a step of their coefficients.
  struct Part {
    std::vector<Eigen::Index> columns;
    numerics::Limits bounds;
    fit::PerLogNuisances free;
  };
  static std::size_t placeOf(const fit::PerLogNuisances& free) {
    return (free.trend ? 1U : 0U) + (free.offset ? 2U : 0U) + (free.gain ? 4U : 0U);
  }
  Part partOf(const std::vector<int>& members) const;
  std::vector<Eigen::Index> columnsOf(const fit::Hypothesis& hypothesis) const;
  void preferLawsAtWork(const fit::Hypothesis& about);
  /// Returns true if a candidate may be added to a set: it contains no effect of the set, and none contains it.
  bool joins(int candidate, const std::vector<int>& members) const;
  std::vector<Screened> screenAll(const std::vector<std::vector<int>>& sets) const;

  const std::vector<fit::Candidate>& candidates_;
  Eigen::Index model_size_;
  int threads_;
  fit::ParameterVector about_;  // parameters of all candidates about which the equations are linearised
  fit::Hypothesis all_;
  std::vector<std::vector<Eigen::Index>> columns_of_;
  std::vector<int> preferred_;           // order of preference of the laws that others contain
  std::vector<fit::BlockGrams> blocks_;  // one element for each combination of nuisance parameters (placeOf())
  numerics::Limits bounds_;
};

}  // namespace rubber_suspension::diagnosis::hypotheses
