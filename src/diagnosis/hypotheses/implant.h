// Effects implanted into the component, motion and noise of the logs, and their residuals under each hypothesis.
#pragma once

#include <cstddef>
#include <vector>

#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

class Screening;

/// Residual of an implanted effect after a refit of a hypothesis, linearised about a fitted model, for an effect that
/// causes a gap of 1 before the refit. They are proportional to the size of the effect.
struct Residuals {
  double gap = 1.0;    ///< RMS residual over the force's standard deviation
  double chi = 0.0;    ///< root of chi^2 of the change of the model parameters
  double added = 0.0;  ///< RMS force that the candidate adds, over the force's standard deviation
  /// Numbers in use beyond the laws that the candidate contains (fit::numbersBeyond()).
  std::size_t beyond = 0;
};

/// One shape of a candidate effect, implanted.
struct Implant {
  int effect = 0;
  double scale = 0.0;              ///< of its basis term, at a gap of 1
  std::size_t term = 0;            ///< index of this basis term among those of its effect
  bool hidden_by_rig = false;      ///< it adds no force to these logs, even at its typical size
  std::size_t blocks = 0;          ///< number of blocks of the logs with known errors
  Residuals model;                 ///< with model parameters alone
  std::vector<Residuals> singles;  ///< with each candidate, in their order
};

/// Implants each candidate in the shapes of its basis terms, with both signs if the terms are signed, by the normal
/// equations of a screening: no log is simulated again. The model parameters are eliminated once (Frisch and Waugh),
/// then the basis terms of each candidate are fitted, with scales of 0 or more unless they are signed.
std::vector<Implant> implantAll(const fit::HypothesisFitter& fitter, const Screening& screening, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
