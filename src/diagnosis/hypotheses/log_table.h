// Evidence for each log: the error of each hypothesis, the force of each of its effects, and the noise floor.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/evidence.h"
#include "measurement/rig_noise.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Returns the parameters of a fitted hypothesis in which the scales of the effect `member` (an index) are 0.
fit::ParameterVector withoutMember(const FittedHypothesis& fitted, std::size_t member);

/// Returns, for each effect of a fitted hypothesis and each record, the mean square of the force that the effect adds,
/// divided by the variance of the record's force. The added force is the difference from the force without the effect,
/// with all other parameters as fitted. For effects of the rubber its mean is removed, because an offset would absorb
/// it. The squared residual that the effect's per-log nuisance parameters absorb is added.
std::vector<std::vector<double>> memberSizes(const std::vector<fit::Candidate>& candidates,
                                             const fit::HypothesisForces& forces, const FittedHypothesis& fitted);

/// Returns the noise floor of each held-out log. It is estimated from the hypothesis with the least error on the logs
/// of the fit, because noise belongs to the measurement and not to the named effects.
std::vector<double> floorsOfUnseen(const PreparedCase& prepared, const Search& search);

/// Returns the evidence of a search with known noise floors: the logs of the fit, followed by the held-out logs.
judge::Evidence evidenceOfLogs(const PreparedCase& prepared, const Search& search, int threads);

/// Returns the fractions of the energy of evenly spaced samples in the mean and in each octave of frequency. The first
/// octave begins at the lowest frequency of the transform (numerics::paddedSpectrum), so that the octaves do not depend
/// on the unit of time. Returns an empty list if the energy is 0 or not finite.
std::vector<double> octaveShares(const Eigen::VectorXd& values);

}  // namespace rubber_suspension::diagnosis::hypotheses
