// The rig's part in the logs of a diagnosis: what it may have added to each, as columns with a prior that every fit
// has, and what is told of it.
#pragma once

#include <vector>

#include "diagnosis/prepare/rig_noise.h"
#include "fit/free_in_log.h"
#include "fit/model_parameters.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis::prepare {

/// Zeros of the displacement that records may have: those of the logs of the fit, and of unseen ones.
struct ZeroPriors {
  std::vector<fit::DisplacementZero> training;
  std::vector<fit::DisplacementZero> held_out;
};

/// Whether zeros and lags of the logs tell how they scatter; those that are simulated do not.
enum class RigScatter { as_found, as_tolerated };

/// Give each record what the rig may have added to it (Record::nuisances): zero, lag, clock, gain, what a motion before
/// the log left, and noise slower than the motion as a random walk, each as wide as its tolerance. One standard
/// deviation of any of them counts as ErrorScale::oneDeviation(). Zeros and lags that are much alike in
/// all logs are no scatter of the rig: then they are no wider than they differ, and what they have in common is left to
/// the effects. The model is re-estimated for that, and for how much each log counts (weighByNoise()).
ZeroPriors setRigPriors(const fit::ModelParameters& model, const io::RigTolerances& tolerances, const ErrorScale& scale,
                        std::vector<log::Record>& training, std::vector<log::Record>& held_out,
                        RigScatter scatter = RigScatter::as_found);

/// The faults of the rig in each record, by what `judged` leaves of it: the values that the priors and the accepted
/// error allow, each with the uncertainty that the accepted error leaves it. Not told where `rival`, the next likely
/// elements, gives a value outside of its interval, but for zeros and gains of each log that the verdict names: those
/// of `named`. `zeros`: of the records.
std::vector<measurement::RigFinding> rigFindings(const std::vector<element::ElementDescription>& judged,
                                                 const std::vector<element::ElementDescription>& rival,
                                                 const io::RigTolerances& tolerances,
                                                 const std::vector<log::Record>& records,
                                                 const std::vector<fit::DisplacementZero>& zeros,
                                                 const fit::FreeInLog& named, int threads);

}  // namespace rubber_suspension::diagnosis::prepare
