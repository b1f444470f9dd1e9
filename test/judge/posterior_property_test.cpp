// Properties of the judgement by posterior that hold on any evidence: RapidCheck draws it. Needs RapidCheck.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "diagnosis/judge/answer.h"
#include "judge/made_evidence.h"

namespace rubber_suspension::test {
namespace {

using diagnosis::Answer;
using diagnosis::Evidence;
using diagnosis::HypothesisEvidence;
using diagnosis::NamedEvidence;
using diagnosis::SetPosterior;
using diagnosis::SetProbability;
using diagnosis::Verdict;

// The same evidence in every run, unless the environment asks for others.
const bool kSeeded = setenv("RC_PARAMS", "seed=20261126", 0) == 0;

// Gaps in steps of 0.1 %, which make short counterexamples.
double anyGap(int least, int most) { return 0.001 * *rc::gen::inRange(least, most); }

std::vector<double> anySquares(std::size_t logs) {
  std::vector<double> squares;
  for (std::size_t l = 0; l < logs; ++l) {
    squares.push_back(std::pow(anyGap(1, 500), 2));
  }
  return squares;
}

// All singles and some pairs, whatever they leave and add.
NamedEvidence anyEvidence() {
  const auto logs = static_cast<std::size_t>(*rc::gen::inRange(1, 7));
  const int effects = *rc::gen::inRange(1, 6);
  NamedEvidence named = unexplained(logs, effects, anyGap(5, 400));
  for (int effect = 0; effect < effects; ++effect) {
    named.evidence.hypotheses[static_cast<std::size_t>(Evidence::kFirstSingle + effect)] =
        fitted({effect}, anySquares(logs), {anySquares(logs)});
  }
  for (int effect = 1; effect < effects; ++effect) {
    named.evidence.hypotheses.push_back(fitted({0, effect}, anySquares(logs), {anySquares(logs), anySquares(logs)}));
  }
  return named;
}

SetPosterior posteriorOf(const NamedEvidence& named) {
  return setPosterior(scoreTable(named), diagnosis::fittedNumbers());
}

double probabilityOf(const SetPosterior& posterior, const std::vector<int>& members) {
  for (const SetProbability& set : posterior.sets) {
    if (set.members == members) {
      return set.sum();
    }
  }
  return 0.0;
}

bool names(Verdict verdict) {
  return verdict == Verdict::named || verdict == Verdict::confounded || verdict == Verdict::partly;
}

RC_GTEST_PROP(AnyEvidence, HasProbabilitiesThatAddUpToOne, ()) {
  const NamedEvidence named = anyEvidence();
  const SetPosterior posterior = posteriorOf(named);
  RC_ASSERT(std::abs(posterior.none + posterior.parameter_error + posterior.unknown + posterior.ofSets() - 1.0) < 1e-9);
  const Answer answer = diagnosis::answer(posterior, named.effects.size());
  for (const double probability : answer.candidates) {
    RC_ASSERT(probability >= 0.0 && probability < posterior.ofSets() + 1e-9);
  }
}

// The sets that cannot be told apart are as few as hold 90 % of all, and the one that is named is among them.
RC_GTEST_PROP(AnyEvidence, ListsTheFewestSets, ()) {
  const NamedEvidence named = anyEvidence();
  const SetPosterior posterior = posteriorOf(named);
  const Answer answer = diagnosis::answer(posterior, named.effects.size());
  RC_PRE(names(answer.verdict));
  double sum = 0.0;
  for (const std::vector<int>& set : answer.confounded) {
    RC_ASSERT(sum < 0.9 * posterior.ofSets());
    sum += probabilityOf(posterior, set);
  }
  RC_ASSERT(sum >= 0.9 * posterior.ofSets() - 1e-9);
  std::vector<int> effects = answer.effects;
  std::sort(effects.begin(), effects.end());
  RC_ASSERT(effects == answer.confounded.front());
}

RC_GTEST_PROP(AnyEvidence, SaysTheSameInAnyOrderOfItsLogs, ()) {
  const NamedEvidence named = anyEvidence();
  NamedEvidence turned = named;
  const auto turn = [](auto& list) { std::rotate(list.begin(), list.begin() + 1, list.end()); };
  turn(turned.evidence.logs);
  for (HypothesisEvidence& hypothesis : turned.evidence.hypotheses) {
    turn(hypothesis.log_errors);
    for (std::vector<double>& sizes : hypothesis.sizes) {
      turn(sizes);
    }
  }
  const SetPosterior before = posteriorOf(named);
  const SetPosterior after = posteriorOf(turned);
  RC_ASSERT(std::abs(before.unknown - after.unknown) < 1e-9);
  for (const SetProbability& set : before.sets) {
    RC_ASSERT(std::abs(set.sum() - probabilityOf(after, set.members)) < 1e-9);
  }
}

// Weights of logs are relative: only what one log counts beside another one matters.
RC_GTEST_PROP(AnyEvidence, SaysTheSameAtAnyScaleOfTheWeights, ()) {
  NamedEvidence named = anyEvidence();
  const SetPosterior before = posteriorOf(named);
  const double factor = std::pow(10.0, *rc::gen::inRange(-6, 7));
  for (diagnosis::LogEvidence& log : named.evidence.logs) {
    log.weight *= factor;
  }
  const SetPosterior after = posteriorOf(named);
  RC_ASSERT(std::abs(before.ofSets() - after.ofSets()) < 1e-9);
  RC_ASSERT(std::abs(before.none - after.none) < 1e-9);
}

// What no model run follows is not the answer, however well it does on the other logs.
RC_GTEST_PROP(AnyEvidence, NeverNamesWhatCannotBeSimulated, ()) {
  NamedEvidence named = anyEvidence();
  HypothesisEvidence& first = named.evidence.hypotheses[Evidence::kFirstSingle];
  first.log_errors.back() = std::numeric_limits<double>::infinity();
  RC_ASSERT(probabilityOf(posteriorOf(named), {0}) == 0.0);
}

RC_GTEST_PROP(AnEffectThatRemovesNothing, IsNeverNamed, ()) {
  const auto logs = static_cast<std::size_t>(*rc::gen::inRange(1, 7));
  const NamedEvidence named = unexplained(logs, *rc::gen::inRange(1, 25), anyGap(4, 500));
  RC_ASSERT(!names(diagnosis::answer(named).verdict));
}

// Two effects of the same kind, of which one leaves less: the more blocks say so, the surer it is.
RC_GTEST_PROP(MoreData, IsSurer, ()) {
  const double left = anyGap(60, 400);
  const double better = *rc::gen::inRange(10, 60) * 0.01 * left;
  const double worse = better * (1.0 + 0.01 * *rc::gen::inRange(10, 60));
  const int blocks = *rc::gen::inRange(20, 200);
  const auto odds = [&](int of_blocks) {
    NamedEvidence named = unexplained(5, 2, left, static_cast<std::size_t>(of_blocks));
    explain(named, 0, better);
    explain(named, 1, worse);
    const SetPosterior posterior = posteriorOf(named);
    return std::log(probabilityOf(posterior, {0}) / probabilityOf(posterior, {1}));
  };
  RC_ASSERT(odds(blocks) > 0.0);
  RC_ASSERT(odds(4 * blocks) > odds(blocks));
}

// An effect that explains a gap down to the noise is named, and nothing beside it.
RC_GTEST_PROP(AnEffectThatExplainsTheGap, IsNamed, ()) {
  NamedEvidence named = unexplained(5, *rc::gen::inRange(2, 20), anyGap(80, 400));
  explain(named, 1, anyGap(3, 6));
  const Answer answer = diagnosis::answer(named);
  RC_ASSERT(answer.verdict == Verdict::named);
  RC_ASSERT(answer.effects == std::vector<int>{1});
}

// An effect whose force is twice that of something that the list lacks: four fifths of the square of the gap are its.
RC_GTEST_PROP(AListedEffectBesideAnUnlistedOne, KeepsItsName, ()) {
  const double left = anyGap(150, 400);
  NamedEvidence named = unexplained(5, *rc::gen::inRange(2, 20), left);
  explain(named, 1, std::sqrt(0.2) * left);
  const Answer answer = diagnosis::answer(named);
  RC_ASSERT(answer.verdict == Verdict::partly);
  RC_ASSERT(answer.effects == std::vector<int>{1});
}

}  // namespace
}  // namespace rubber_suspension::test
