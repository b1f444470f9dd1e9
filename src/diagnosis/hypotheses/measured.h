// The interface of a measurement to a search, be it logs or a table.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "fit/excitation.h"
#include "fit/hypothesis.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// A measurement of one component that hypotheses are fitted to.
class Measured {
 public:
  Measured() = default;
  virtual ~Measured() = default;
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;

  /// Fits with the numbers of the specification free.
  virtual const fit::HypothesisFitter& fitter() const = 0;

  /// Records for the unit effects of terms (fit::findUnitEffects()).
  virtual const std::vector<gap::PreparedRecord>& records() const = 0;

  virtual fit::Excitation excitation() const = 0;

  /// The list of effects with their unit effects; those that such a measurement can never show have no terms.
  virtual std::vector<fit::Candidate> candidates(const fit::Excitation& excitation,
                                                 const FittedHypothesis& re_estimated, int threads) const = 0;

  /// The error of a model by the time steps of the simulation, as a gap.
  virtual double discretisationError(const FittedHypothesis& model) const = 0;

  /// The noise by what the best hypothesis so far leaves; found again where a better one is. `search` has the
  /// re-estimated model and the noise found before.
  virtual Noise estimateNoise(const FittedHypothesis& best, const Search& search) const = 0;
};

}  // namespace rubber_suspension::diagnosis::hypotheses
