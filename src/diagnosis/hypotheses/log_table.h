// Evidence by log: what each hypothesis errs by, what each of its members adds, and how well the noise floor is known.
#pragma once

#include <vector>

#include "diagnosis/hypotheses/search.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/evidence.h"
#include "measurement/rig_noise.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// The parameters of a fitted hypothesis without the terms of one member, by its place among them: terms lie one member
/// after the other.
fit::ParameterVector withoutMember(const FittedHypothesis& fitted, std::size_t member);

/// Mean square of the force that each member of a fitted hypothesis adds to each record, in units of the variance of
/// its force: of the force with the member less that without it, all other numbers as fitted; without its mean, which
/// is a zero, where the member belongs to the rubber. What a member frees in each log counts as its own. Members
/// without any force there have 0.
std::vector<std::vector<double>> memberSizes(const std::vector<fit::Candidate>& candidates,
                                             const fit::HypothesisForces& forces, const FittedHypothesis& fitted);

/// Noise floor of each log held out, beside the hypothesis that leaves least of the logs of the fit: the floor is of
/// the measurement, whatever is named.
std::vector<double> floorsOfUnseen(const PreparedCase& prepared, const Search& search);

/// The evidence of a search, which has these floors, over the logs of the fit and then the unseen ones.
judge::Evidence evidenceOfLogs(const PreparedCase& prepared, const Search& search, int threads);

/// Shares of octaves of frequency in the energy of evenly spaced samples: of their mean, then of the octaves from the
/// lowest frequency of the transform on (numerics::paddedSpectrum), so that they do not depend on the unit of time.
/// Empty where there is no energy or it is not finite.
std::vector<double> octaveShares(const Eigen::VectorXd& values);

}  // namespace rubber_suspension::diagnosis::hypotheses
