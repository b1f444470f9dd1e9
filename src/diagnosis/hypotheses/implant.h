// Predicts how each hypothesis would fit logs to which the force of an effect is added.
#pragma once

#include <cstddef>
#include <vector>

#include "fit/hypothesis_fitter.h"

namespace rubber_suspension::diagnosis::hypotheses {

class Screening;

/// Residual that a refitted hypothesis leaves of an added effect with a gap of 1. The hypothesis is linearised about a
/// fitted model, so that all values but `beyond` are proportional to the size of the effect.
struct Residuals {
  double gap = 1.0;    ///< RMS residual divided by the standard deviation of the force
  double chi = 0.0;    ///< square root of chi^2 of the change of the model parameters
  double added = 0.0;  ///< RMS force of the candidate divided by the standard deviation of the force
  /// Number of nonzero parameters beyond those of the laws that the candidate contains (fit::numbersBeyond()).
  std::size_t beyond = 0;
};

/// A candidate effect in one form of its law, added to the logs.
struct Implant {
  int effect = 0;
  double scale = 0.0;              ///< scale of its basis term for a gap of 1
  std::size_t term = 0;            ///< index of this term among the terms of the effect
  bool adds_nothing = false;       ///< the effect adds no force to these logs, even at its typical size
  std::size_t blocks = 0;          ///< number of blocks of the logs in which errors are known
  Residuals model;                 ///< residual after a refit of the model parameters alone
  std::vector<Residuals> singles;  ///< residual after a refit with each candidate, in the order of the candidates
};

/// Adds each candidate to the logs in the forms of its basis terms, with both signs if terms may have either. No log is
/// simulated again: the normal equations of a screening predict the residuals. The model parameters are eliminated once
/// (Frisch and Waugh). The scales of each candidate are fitted, nonnegative unless a term may have either sign.
std::vector<Implant> implantAll(const fit::HypothesisFitter& fitter, const Screening& screening, int threads);

}  // namespace rubber_suspension::diagnosis::hypotheses
