// The interface through which a search uses a measurement: logs or a table.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/excitation.h"
#include "fit/hypothesis.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// A measurement of one component to which hypotheses are fitted.
class Measured {
 public:
  Measured() = default;
  virtual ~Measured() = default;
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;

  /// Returns the fitter, whose model parameters are the numbers of the specification.
  virtual const fit::HypothesisFitter& fitter() const = 0;

  /// Returns the records on which the forces of basis terms are simulated (fit::findUnitEffects()).
  virtual const std::vector<gap::PreparedRecord>& records() const = 0;

  virtual fit::Excitation excitation() const = 0;

  /// Returns the candidates with their simulated forces. Candidates that such a measurement never shows have no terms.
  virtual std::vector<fit::Candidate> candidates(const fit::Excitation& excitation,
                                                 const FittedHypothesis& re_estimated, int threads) const = 0;

  /// Returns the error of a model that is due to the time steps of the simulation, expressed as a gap.
  virtual double discretisationError(const FittedHypothesis& model) const = 0;

  /// Estimates the noise from the residual of the best hypothesis so far. It is called again whenever a better
  /// hypothesis is found. `search` contains the re-estimated model and the previous estimate.
  virtual Noise estimateNoise(const FittedHypothesis& best, const Search& search) const = 0;
};

}  // namespace rubber_suspension::diagnosis::hypotheses
