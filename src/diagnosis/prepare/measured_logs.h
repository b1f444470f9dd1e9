// Logs as a search takes them.
#pragma once

#include <vector>

#include "diagnosis/prepare/measured.h"
#include "fit/fitter.h"
#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis {

/// The elements with dashpots that take the displacement as smooth, not as linear between samples; empty where there
/// are no dashpots. A dashpot of the first kind lags by half a step, which looks like a delay.
std::vector<element::ElementDescription> withSmoothDashpots(std::vector<element::ElementDescription> elements);

/// The fitters have to outlive it.
class MeasuredLogs final : public Measured {
 public:
  MeasuredLogs(fit::Fitter& fitter, const fit::Fitter& element_fitter)
      : fitter_(fitter), element_fitter_(element_fitter) {}

  const fit::HypothesisFitter& fitter() const override { return fitter_; }
  const fit::HypothesisFitter& elementFitter() const override { return element_fitter_; }
  fit::Excitation excitation() const override;
  std::vector<fit::Candidate> candidates(const fit::Excitation& excitation, const FittedHypothesis& re_estimated,
                                         int threads) const override;
  double discretisationError(const FittedHypothesis& model) const override;
  void estimateNoise(const FittedHypothesis& best, Search& result) const override;

 private:
  fit::Fitter& fitter_;
  const fit::Fitter& element_fitter_;
};

}  // namespace rubber_suspension::diagnosis
