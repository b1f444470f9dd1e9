// Logs as a search takes them.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/measured.h"
#include "fit/fitter.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// The elements with dashpots that take the displacement as smooth, not as linear between samples; empty where there
/// are no dashpots. A dashpot of the first kind lags by half a step, which looks like a delay.
std::vector<element::ElementDescription> withSmoothDashpots(std::vector<element::ElementDescription> elements);

/// The fitter has to outlive it.
class MeasuredLogs final : public Measured {
 public:
  explicit MeasuredLogs(fit::Fitter& fitter) : fitter_(fitter) {}

  const fit::HypothesisFitter& fitter() const override { return fitter_; }
  const std::vector<gap::PreparedRecord>& records() const override { return fitter_.records(); }
  fit::Excitation excitation() const override;
  std::vector<fit::Candidate> candidates(const fit::Excitation& excitation, const FittedHypothesis& re_estimated,
                                         int threads) const override;
  double discretisationError(const FittedHypothesis& model) const override;
  Noise estimateNoise(const FittedHypothesis& best, const Search& search) const override;

 private:
  fit::Fitter& fitter_;
};

/// Candidates implanted into logs that a component makes as configured, with white noise of this share of the force
/// [-]: the search of a plan, in which nothing is fitted. Not while fits run.
Search implanted(fit::Fitter& fitter, double noise, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
