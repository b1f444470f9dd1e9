// Numbers of the judgement of greatest posterior probability on cases of known cause.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/numbers.h"
#include "diagnosis/judge/score.h"
#include "judged_case.h"

namespace rubber_suspension::blind_trial {

/// Added to the probability of a truth before its logarithm is taken: one case must not outweigh all others.
constexpr double kLeastProbability = 1e-3;

/// A case as the fit takes it.
struct FittedCase {
  diagnosis::judge::ScoreTable table;
  Truth truth;
  bool hidden = false;
  bool far_off = false;  ///< the model as configured leaves more than an engineer accepts
};

/// Cases with evidence; the others tell nothing of the numbers.
std::vector<FittedCase> fittedCases(const std::vector<TrialCase>& cases);

/// Probability that the judge gives to what the label says; where that has several answers, to all of them.
double probabilityOfTruth(const FittedCase& known, const diagnosis::judge::JudgeNumbers& numbers);

/// Logarithms of these probabilities and the prior of the numbers are made greatest together
/// (L-BFGS of Ceres), from what is believed beforehand and from the numbers as fitted last: there are several such
/// places, and the best one counts. Base rates are of the effects that occur in the evidence.
diagnosis::judge::JudgeNumbers calibrate(const std::vector<FittedCase>& cases);

/// The source file that holds the numbers; `of` tells in words how they were fitted.
std::string fittedNumbersSource(const diagnosis::judge::JudgeNumbers& numbers, const std::string& of);

}  // namespace rubber_suspension::blind_trial
