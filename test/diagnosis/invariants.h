// What every report has to hold, whatever it found (docs/diagnosis.md lists it; test/blind_trial/invariants.py asks the
// same of report.json).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "diagnosis/experiment/explanation.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/page.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/text.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::test {

constexpr double kRounding = 1e-9;
constexpr double kWorthListing = 0.02;

using diagnosis::CandidateResult;
using diagnosis::Diagnosis;
using diagnosis::SizedValue;

inline double probabilityOf(const Diagnosis& d, const std::string& effect) {
  const auto found = std::find_if(d.candidates.begin(), d.candidates.end(),
                                  [&](const CandidateResult& candidate) { return candidate.effect == effect; });
  return found == d.candidates.end() ? 0.0 : found->probability;
}

/// Answers add up to 1, and the verdict's is the likeliest; what may be instead follows by probability.
inline void checkAnswers(const Diagnosis& d) {
  const diagnosis::Posterior& p = d.posterior;
  EXPECT_NEAR(p.none + p.parameter_error + p.effects + p.none_of_these, 1.0, kRounding);
  const double said = namesEffects(d.verdict)                            ? p.effects
                      : d.verdict == diagnosis::Verdict::none            ? p.none
                      : d.verdict == diagnosis::Verdict::parameter_error ? p.parameter_error
                                                                         : p.none_of_these;
  EXPECT_GE(said, std::max({p.none, p.parameter_error, p.effects, p.none_of_these}) - kRounding);
  double sum = d.probability;
  double last = 1.0;
  for (const diagnosis::Alternative& other : d.alternatives) {
    EXPECT_LE(other.probability, last);
    last = other.probability;
    sum += last;
  }
  EXPECT_LE(sum, 1.0 + kRounding);
}

/// Effects where the verdict names any, their set first of those that cannot be told apart; no other set holds an
/// effect that the table gives below 2 %.
inline void checkSets(const Diagnosis& d) {
  EXPECT_EQ(!d.effects.empty(), namesEffects(d.verdict));
  EXPECT_EQ(d.confounded.empty(), d.effects.empty());
  double of_candidates = 0.0;
  for (const CandidateResult& candidate : d.candidates) {
    EXPECT_LE(candidate.probability, d.posterior.effects + kRounding) << candidate.effect;
    of_candidates += candidate.probability;
  }
  EXPECT_GE(of_candidates, d.posterior.effects - kRounding);
  for (std::size_t s = 0; s < d.confounded.size(); ++s) {
    const std::vector<std::string>& set = d.confounded[s];
    if (s == 0) {
      EXPECT_TRUE(std::is_permutation(set.begin(), set.end(), d.effects.begin(), d.effects.end()));
      continue;
    }
    for (const std::string& effect : set) {
      EXPECT_GE(probabilityOf(d, effect), kWorthListing) << effect;
    }
  }
}

/// No gap is below the floor; what is closed is that of the gaps, and lies in its interval.
inline void checkGaps(const Diagnosis& d) {
  EXPECT_LE(d.gap.noise_floor, std::min({d.gap.as_configured, d.gap.re_estimated, d.gap.augmented}) + kRounding);
  for (const CandidateResult& candidate : d.candidates) {
    EXPECT_LE(d.gap.noise_floor, candidate.gap + kRounding) << candidate.effect;
  }
  if (d.effects.empty()) {
    return;
  }
  EXPECT_LT(d.gap.augmented, d.gap.re_estimated);
  const double fraction = (d.gap.re_estimated - d.gap.augmented) / (d.gap.re_estimated - d.gap.noise_floor);
  EXPECT_NEAR(d.closed, std::min(1.0, fraction), kRounding);
  EXPECT_LE(d.closed_interval[0], d.closed);
  EXPECT_GE(d.closed_interval[1], d.closed);
  EXPECT_GT(d.closed_interval[0], 0.0);
}

/// No other value than that of the headline is in the sentence; an interval that ends at a bound says so.
inline void checkSizes(const Diagnosis& d) {
  const SizedValue* const headline = diagnosis::words::headlineValue(d);
  for (const SizedValue* size : diagnosis::words::changedValues(d)) {  // the largest change first
    EXPECT_TRUE(size == headline || d.sentence.find(diagnosis::words::offText(*size)) == std::string::npos)
        << size->name;
  }
  for (const auto* sizes : {&d.model_sizes, &d.effect_sizes}) {
    for (const SizedValue& size : *sizes) {
      const bool says = diagnosis::words::intervalText(size).find("bound") != std::string::npos;
      EXPECT_EQ(says, size.at_bound[0] || size.at_bound[1]) << size.name;
      EXPECT_TRUE(size.interval_95[0] != 0.0 || size.value == 0.0 || size.at_bound[0]) << size.name << " may be 0";
    }
  }
}

/// In squares, what was taken out of a log is the difference between what it leaves as recorded and then.
inline void checkTakenOut(const Diagnosis& d) {
  for (const diagnosis::Admission& log : d.admission) {
    double left = log.recorded * log.recorded;
    for (const diagnosis::TakenOut& part : d.taken_out) {
      left -= part.log == log.log ? std::copysign(part.share * part.share, part.share) : 0.0;
    }
    EXPECT_NEAR(left, log.left * log.left, kRounding * (1.0 + left)) << log.log;
  }
}

inline bool isInPieces(const Diagnosis& d) {
  return std::any_of(d.admission.begin(), d.admission.end(), [](const diagnosis::Admission& log) {
    return std::any_of(log.notes.begin(), log.notes.end(),
                       [](const std::string& note) { return note.find("time gaps") != std::string::npos; });
  });
}

/// Over the logs that the gaps are of, what they leave as recorded is what `replay` gives, and what they leave is the
/// gap; without held-out logs the gap is of blocks that took no part in a fit, and more.
inline void checkThatTakenOutExplainsTheGaps(const Diagnosis& d) {
  constexpr double kReplayed = 1e-3;
  const bool held_out =
      std::any_of(d.admission.begin(), d.admission.end(), [](const diagnosis::Admission& log) { return log.hold_out; });
  std::vector<double> recorded;
  std::vector<double> left;
  for (const diagnosis::Admission& log : d.admission) {
    if (log.hold_out == held_out) {
      recorded.push_back(log.recorded);
      left.push_back(log.left);
    }
  }
  if (recorded.empty() || d.samples != d.recorded_samples || isInPieces(d)) {
    return;  // a table, or parts of logs
  }
  const double squares = std::inner_product(recorded.begin(), recorded.end(), recorded.begin(), 0.0);
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(recorded.size())), d.gap_as_recorded.augmented,
              kReplayed * d.gap_as_recorded.augmented + kRounding);
  EXPECT_LT(*std::min_element(left.begin(), left.end()), (1.0 + kReplayed) * d.gap.augmented);
  EXPECT_TRUE(!held_out || d.gap.augmented < (1.0 + kReplayed) * *std::max_element(left.begin(), left.end()));
}

/// Why a candidate is out agrees with its gap: what leaves less is never said to add nothing or to leave more.
inline void checkCandidates(const Diagnosis& d) {
  for (const CandidateResult& candidate : d.candidates) {
    const std::string why = diagnosis::report::whyOut(d, candidate);
    const auto says = [&](const char* words) { return why.find(words) != std::string::npos; };
    EXPECT_TRUE(!says("where what is named leaves") || candidate.gap > d.gap.augmented) << candidate.effect;
    EXPECT_TRUE(!says("no more than what is named") || candidate.gap <= d.gap.augmented) << candidate.effect;
    EXPECT_FALSE(says("adds nothing")) << candidate.effect;
  }
}

/// A hypothesis leaves no more of the logs of the fit than one whose terms are among its own, a law that contains
/// another than that one above all.
inline void checkContainment(const Diagnosis& d) {
  using diagnosis::hypotheses::FittedHypothesis;
  constexpr double kAsMuch = 1.01;
  constexpr double kOfFloor = 0.1;
  const diagnosis::hypotheses::Search& search = d.workings->search;
  const std::vector<const FittedHypothesis*> all = search.withEffects();
  for (const FittedHypothesis* larger : all) {
    for (const FittedHypothesis* smaller : all) {
      if (larger != smaller && smaller->hypothesis.competes() &&
          fit::holds(search.candidates, larger->hypothesis.members, smaller->hypothesis.members)) {
        EXPECT_LE(larger->fit.gap, kAsMuch * smaller->fit.gap + kOfFloor * search.noise)
            << diagnosis::experiment::nameOf(search, *larger) << " above "
            << diagnosis::experiment::nameOf(search, *smaller);
      }
    }
  }
}

inline void checkInvariants(const Diagnosis& d) {
  SCOPED_TRACE(d.sentence);
  if (d.verdict == diagnosis::Verdict::check_bench) {
    EXPECT_TRUE(d.effects.empty());
    return;
  }
  checkAnswers(d);
  checkSets(d);
  checkGaps(d);
  checkSizes(d);
  checkCandidates(d);
  checkTakenOut(d);
  checkThatTakenOutExplainsTheGaps(d);
  checkContainment(d);
  const double where = std::accumulate(d.where.begin(), d.where.end(), 0.0,
                                       [](double sum, const gap::GapCell& cell) { return sum + cell.share; });
  EXPECT_TRUE(d.where.empty() || std::abs(where - 1.0) < kRounding) << where;
  const double removed = std::accumulate(d.shares.begin(), d.shares.end(), 0.0,
                                         [](double sum, const auto& part) { return sum + part.share; });
  EXPECT_NEAR(removed, 1.0 - d.gap.augmented / d.gap.as_configured, 1e-6);
  EXPECT_EQ(d.surrogate.has_value(), leavesRest(d.verdict) && !d.table);
  EXPECT_FALSE(d.next_experiment.empty());
}

}  // namespace rubber_suspension::test
