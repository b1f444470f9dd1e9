// Fits the numbers of the judgement to cases with known causes, by maximum posterior probability.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/numbers.h"
#include "diagnosis/judge/score.h"
#include "judged_case.h"

namespace rubber_suspension::blind_trial {

/// Added to the probability of the true cause before the logarithm, so that no single case outweighs all others.
constexpr double kLeastProbability = 1e-3;

/// A case as input of the fit.
struct FittedCase {
  diagnosis::judge::ScoreTable table;
  Truth truth;
  bool hidden = false;
  bool far_off = false;  ///< the gap as configured exceeds what an engineer accepts
};

/// Returns the cases with evidence. Other cases contain no information about the numbers.
std::vector<FittedCase> fittedCases(const std::vector<TrialCase>& cases);

/// Returns the probability that the judgement assigns to the labelled truth, as the sum over all accepted answers.
double probabilityOfTruth(const FittedCase& known, const diagnosis::judge::JudgeNumbers& numbers);

/// Maximises the probability of the labels and of the prior numbers with L-BFGS (Ceres). There are several maxima, so
/// it starts from the prior means and from the last fitted numbers, and returns the better result. Base rates are those
/// of the effects in the evidence. If `only` is not empty, only the numbers of these names are fitted, and the others
/// stay as fitted last. Throws std::invalid_argument without cases, or for a name that is not in numberTable().
diagnosis::judge::JudgeNumbers calibrate(const std::vector<FittedCase>& cases,
                                         const std::vector<std::string>& only = {});

/// How well the cases determine the numbers, from the Hessian of the loss at its minimum.
struct Certainty {
  std::vector<double> errors;  ///< standard errors of the rows of numberTable(), in logarithms of positive numbers
  int known = 0;               ///< directions that the cases determine better than the prior does
  int directions = 0;          ///< number of all directions
};

Certainty certaintyOf(const std::vector<FittedCase>& cases, const diagnosis::judge::JudgeNumbers& numbers);

/// Returns the source file with the numbers. `of` describes the fit in words.
std::string fittedNumbersSource(const diagnosis::judge::JudgeNumbers& numbers, const std::string& of);

}  // namespace rubber_suspension::blind_trial
