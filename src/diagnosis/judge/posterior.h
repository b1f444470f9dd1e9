// How probable each answer is: no gap, wrong values, an effect of the list, none of these.
#pragma once

#include "diagnosis/judge/judge.h"

namespace rubber_suspension::diagnosis {

/// Probabilities of the answers, which add up to 1; that of the verdict is the largest.
///
/// An answer weighs as the power `sharpness` of the squared ratio of what the configured model leaves to what it leaves
/// itself, less the weight of the simpler answer that it contains: wrong values contain the configured model, an effect
/// contains re-estimated values (pseudo-BMA, Yao et al. 2018, with a power in place of the number of samples, since
/// residuals of a model that is wrong hang together). "None of these" stands for a law that closes what an effect has
/// to close at least to be named. What counts as nothing left is told from nothing at even odds. An answer that a test
/// refuted, on unseen logs or by chance, although it weighs more than the verdict, counts half as much as that.
Posterior posterior(const Evidence& evidence, const Criteria& criteria, const Judgement& judgement);

/// The same where an effect does exactly what wrong values do: both are as probable as the other.
Posterior sharedWithValues(Posterior answers);

}  // namespace rubber_suspension::diagnosis
