// Fits the numbers of the judgement to cases of known cause by maximum posterior probability.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/numbers.h"
#include "diagnosis/judge/score.h"
#include "judged_case.h"

namespace rubber_suspension::blind_trial {

/// Added to the probability of a truth before the logarithm, so that no single case outweighs all others.
constexpr double kLeastProbability = 1e-3;

/// A case as input of the fit.
struct FittedCase {
  diagnosis::judge::ScoreTable table;
  Truth truth;
  bool hidden = false;
  bool far_off = false;  ///< the gap as configured exceeds what an engineer accepts
};

/// Returns the cases with evidence; others contain no information on the numbers.
std::vector<FittedCase> fittedCases(const std::vector<TrialCase>& cases);

/// Returns the probability that the judge gives to the labelled truth, summed over its accepted answers.
double probabilityOfTruth(const FittedCase& known, const diagnosis::judge::JudgeNumbers& numbers);

/// Maximises the probability of labels and prior numbers by L-BFGS (Ceres). It starts from the prior means and from the
/// last fitted numbers, because there are several maxima, and keeps the best. Base rates are those of the effects in
/// the evidence.
diagnosis::judge::JudgeNumbers calibrate(const std::vector<FittedCase>& cases);

/// Returns the source file with the numbers; `of` describes the fit in words.
std::string fittedNumbersSource(const diagnosis::judge::JudgeNumbers& numbers, const std::string& of);

}  // namespace rubber_suspension::blind_trial
