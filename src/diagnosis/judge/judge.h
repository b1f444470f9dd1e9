// From the evidence to a judgement: what is named, how sure it is, what cannot be told apart.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/criteria.h"
#include "diagnosis/judge/evidence.h"
#include "rubber_suspension/diagnosis/posterior.h"

namespace rubber_suspension::diagnosis {

enum class Verdict { none, parameter_error, named, confounded, unknown, partly, check_bench };

/// As in reports.
std::string toString(Verdict verdict);

struct Judgement {
  Verdict verdict = Verdict::none;
  std::vector<int> effects;                  ///< named, most important first
  int model = Evidence::kReEstimated;        ///< the hypothesis that the augmented component is made of
  Posterior posterior;                       ///< of the answers; the verdict's is the largest
  std::vector<double> probabilities;         ///< of each effect to be the (most important) one
  std::vector<std::vector<int>> confounded;  ///< for each effect named, the set that holds it at 90 %
  bool values_would_do = false;              ///< wrong values cannot be told from what is named
  std::vector<bool> testable;                ///< of each effect: these logs would show it, or it is named
  bool only_unseen_logs_differ = false;      ///< the logs of the fit confirm the model, unseen ones do not

  /// Name no effect any more, but this verdict and the hypothesis that stands for it.
  void withdraw(Verdict without_effects, int without_model);
};

/// A pure function: the same evidence gives the same judgement. Where there are unseen logs, each hypothesis has its
/// errors on them: they count as further logs in every comparison, and what they refute is not named.
Judgement judge(const Evidence& evidence, const Criteria& criteria = {});

}  // namespace rubber_suspension::diagnosis
