// Evidence by log: the error of each hypothesis, the force of each member, and the noise floor with its uncertainty.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/evidence.h"
#include "measurement/rig_noise.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// Returns the parameters of a fitted hypothesis with the scales of one member, by its place, set to 0.
fit::ParameterVector withoutMember(const FittedHypothesis& fitted, std::size_t member);

/// Returns, for each member of a fitted hypothesis and each record, the mean square of the force that the member adds,
/// in units of the variance of the record's force: the force with the member minus that without it, all other numbers
/// as fitted. For members of the rubber the mean is removed, because an offset would absorb it. The residual that the
/// per-log unknowns of a member absorb is added.
std::vector<std::vector<double>> memberSizes(const std::vector<fit::Candidate>& candidates,
                                             const fit::HypothesisForces& forces, const FittedHypothesis& fitted);

/// Returns the noise floor of each held-out log, from the hypothesis with the least error on the logs of the fit: the
/// floor belongs to the measurement, whichever effects are named.
std::vector<double> floorsOfUnseen(const PreparedCase& prepared, const Search& search);

/// Returns the evidence of a search that has these floors, over the logs of the fit and then the held-out ones.
judge::Evidence evidenceOfLogs(const PreparedCase& prepared, const Search& search, int threads);

/// Returns the shares of the mean and of each octave of frequency in the energy of evenly spaced samples. The octaves
/// begin at the lowest frequency of the transform (numerics::paddedSpectrum), so that they do not depend on the unit of
/// time. Empty if the energy is 0 or not finite.
std::vector<double> octaveShares(const Eigen::VectorXd& values);

}  // namespace rubber_suspension::diagnosis::hypotheses
