// Effects implanted into the component, motion and noise of the logs: what each hypothesis would leave of them.
#pragma once

#include <cstddef>
#include <vector>

#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

class Screening;

/// The rest of an implanted effect that a hypothesis leaves, about a fitted model taken as linear. Gaps, for an effect
/// that makes a gap of 1 before any refit; all of it grows in proportion to the effect.
struct Residuals {
  double gap = 1.0;    ///< RMS force over the force's standard deviation
  double chi = 0.0;    ///< root of chi^2 of the model parameters that moved
  double added = 0.0;  ///< RMS force that the candidate adds, over the force's standard deviation
  /// Numbers at work beyond the laws that the candidate contains, for an effect of this size (fit::numbersBeyond()).
  std::size_t beyond = 0;
};

/// One shape of a candidate effect, implanted.
struct Implant {
  int effect = 0;
  double scale = 0.0;              ///< of its basis term, at a gap of 1
  std::size_t term = 0;            ///< that it is the shape of, among those of its effect
  bool hidden_by_rig = false;      ///< what the rig may do to a log takes all of it
  std::size_t blocks = 0;          ///< of the logs that errors would be known of
  Residuals model;                 ///< model parameters alone
  std::vector<Residuals> singles;  ///< with each candidate, in their order
};

/// Each candidate in the shapes of its basis terms, in both directions where it has two, as the normal equations of a
/// screening tell: no log is simulated again. Model parameters are taken out once (Frisch and Waugh), then the basis
/// terms of each candidate are fitted within their bounds.
std::vector<Implant> implantAll(const fit::HypothesisFitter& fitter, const Screening& screening, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
