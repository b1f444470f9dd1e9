// Logs as a measurement for the search.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/measured.h"
#include "fit/fitter.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Returns the elements with dashpots of order 2, which interpolate a smooth displacement; empty if there are no
/// dashpots. Dashpots for a displacement that is linear between samples lag by half a step, which looks like a delay.
std::vector<element::ElementDescription> withSmoothDashpots(std::vector<element::ElementDescription> elements);

/// Logs as a measurement. The fitter has to outlive it.
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

/// Returns a search without fits, for a plan: candidates are implanted into logs simulated with the configured
/// component. `noise`: white noise in the logs as a share of the force [-]. Must not be called while fits run.
Search implanted(fit::Fitter& fitter, double noise, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
