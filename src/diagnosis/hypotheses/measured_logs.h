// Logs as the data that the search fits.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/measured.h"
#include "fit/fitter.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Returns the elements with dashpots of order 2, which interpolate the displacement smoothly, or an empty list without
/// dashpots. Other dashpots lag by half a time step, which looks like a delay.
std::vector<element::ElementDescription> withSmoothDashpots(std::vector<element::ElementDescription> elements);

/// Logs to which hypotheses are fitted. The fitter has to outlive this object.
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

/// Returns a search without fits, for a plan: candidates are added to logs simulated with the configured component.
/// `noise` is the RMS noise of the logs divided by the standard deviation of the force. Not to be called during a fit.
Search implanted(fit::Fitter& fitter, double noise, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
