// Families of laws.
#include "diagnosis/judge/families.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "diagnosis/judge/weighing.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kLittleMore = 1.0 + 1e-6;  // the simpler law is the better one, and by no more

// True if a hypothesis frees in logs no more than another one does for its effects but one.
bool freesLess(const HypothesisEvidence& hypothesis, const HypothesisEvidence& large, const HypothesisEvidence& one) {
  const bool trends = large.free_trends && !one.free_trends;
  const bool gains = large.free_gains && !one.free_gains;
  return (trends || !hypothesis.free_trends) && (gains || !hypothesis.free_gains);
}

// True if each effect of a hypothesis gains what a further one has to: else fewer would be named.
bool needsAllOf(const Evidence& evidence, const Weighing& weighing, int hypothesis) {
  const HypothesisEvidence& all = evidence.at(hypothesis);
  return all.members.size() < 2 || std::all_of(all.members.begin(), all.members.end(), [&](int member) {
           const std::optional<int> fewer = evidence.without(hypothesis, member);
           return !fewer || weighing.gainsEnough(all, evidence.at(*fewer));
         });
}

// The hypotheses that stand for one where it errs no less than they do: with the simpler law that one of its laws
// contains in its place. A trend for each log follows whatever is slow, a gain for each whatever depends on a log's
// amplitude or frequency: any laws that do not are simpler, as many of them. A law that can look like several others
// is the last one to be believed: any laws without it are simpler, however many.
std::vector<int> simplerThan(const Evidence& evidence, const Weighing& weighing, int hypothesis, int member) {
  const HypothesisEvidence& large = evidence.at(hypothesis);
  const bool in_log = evidence.single(member).freesInLogs();
  const bool like_others = evidence.single(member).last_resort;
  std::vector<int> simpler;
  for (const int contained : evidence.containedIn(member)) {
    if (const auto found = evidence.inPlaceOf(hypothesis, member, contained)) {
      simpler.push_back(*found);
    }
  }
  if (in_log || like_others) {
    for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
      const HypothesisEvidence& other = evidence.at(h);
      const bool as_many = like_others || other.members.size() == large.members.size();
      const bool without = !other.last_resort && (like_others || freesLess(other, large, evidence.single(member)));
      if (as_many && without && weighing.mayBeACause(other) && std::isfinite(other.held_out)) {
        simpler.push_back(h);
      }
    }
    if (evidence.single(member).free_gains && !simpler.empty()) {  // the best one stands for all
      return {*std::min_element(simpler.begin(), simpler.end(), [&](int a, int b) {
        return weighing.left(evidence.at(a)) < weighing.left(evidence.at(b));
      })};
    }
  }
  return simpler;
}

// A gain of each log is as many numbers as there are logs: it has to gain as a further effect has to. What can look
// like several others has to err no more than sets of them that would not be named.
bool isBetter(const Evidence& evidence, const Weighing& weighing, const Criteria& criteria, int member,
              const HypothesisEvidence& large, int other) {
  const HypothesisEvidence& simpler = evidence.at(other);
  if (evidence.single(member).last_resort && !needsAllOf(evidence, weighing, other)) {
    return weighing.left(large) <= weighing.left(simpler);
  }
  if (!evidence.single(member).free_gains) {
    return weighing.errsLess(large, simpler);
  }
  return weighing.gainsEnough(large, simpler) && weighing.chanceOfGain(large, simpler) < criteria.chance;
}

// True if that changes anything.
bool settle(const Weighing& weighing, const Criteria& criteria, int hypothesis, Evidence& evidence) {
  HypothesisEvidence& large = evidence.hypotheses[static_cast<std::size_t>(hypothesis)];
  const double before = large.at_least;
  for (const int member : large.members) {
    for (const int simpler : simplerThan(evidence, weighing, hypothesis, member)) {
      if (!isBetter(evidence, weighing, criteria, member, large, simpler)) {
        large.does_no_better = true;
        large.at_least = std::max(large.at_least, kLittleMore * weighing.left(evidence.at(simpler)));
      }
    }
  }
  return large.at_least > before;
}

}  // namespace

void settleFamilies(Evidence& evidence, const Criteria& criteria) {
  constexpr int kLongestChain = 4;  // a simpler law may have a simpler one: asymmetric, progressive; of three effects
  const Weighing weighing(evidence, criteria);
  bool changed = true;
  for (int i = 0; changed && i < kLongestChain; ++i) {
    changed = false;
    for (int h = Evidence::kFirstSingle; h < static_cast<int>(evidence.hypotheses.size()); ++h) {
      changed = settle(weighing, criteria, h, evidence) || changed;
    }
  }
}

}  // namespace rubber_suspension::diagnosis
