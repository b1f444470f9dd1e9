// The judgement on made-up evidence: each verdict and each rule, without a simulation.
#include "diagnosis/judge/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "diagnosis/judge/evidence_json.h"
#include "diagnosis/judge/weighing.h"

namespace rubber_suspension::diagnosis {
namespace {

// Effects of the made-up list: two of many numbers, one of a single number, a drift, and a last resort.
enum Effect { kMany, kSimple, kDrift, kLastResort, kOther, kEffects };
constexpr int kOfKnown = Evidence::kFirstSingle;

HypothesisEvidence fitted(std::vector<int> members, double held_out) {
  HypothesisEvidence hypothesis;
  hypothesis.held_out = held_out;
  for (const int member : members) {
    hypothesis.terms += member == kSimple || member == kDrift ? 1 : 8;
    hypothesis.free_trends = hypothesis.free_trends || member == kDrift;
    hypothesis.last_resort = hypothesis.last_resort || member == kLastResort;
  }
  hypothesis.members = std::move(members);
  return hypothesis;
}

// A gap of 30 % as configured and of 20 % re-estimated over a floor of 1 %, of which no effect closes anything.
Evidence unexplained() {
  Evidence evidence;
  evidence.noise_floor = 0.01;
  evidence.element_level = 0.2;
  evidence.hypotheses = {fitted({}, 0.3), fitted({}, 0.2)};
  for (int effect = 0; effect < kEffects; ++effect) {
    evidence.hypotheses.push_back(fitted({effect}, 0.2));
  }
  evidence.testable.assign(kEffects, true);
  return evidence;
}

HypothesisEvidence& single(Evidence& evidence, int effect) {
  return evidence.hypotheses[static_cast<std::size_t>(kOfKnown + effect)];
}

HypothesisEvidence& configured(Evidence& evidence) { return evidence.hypotheses[Evidence::kAsConfigured]; }
HypothesisEvidence& reEstimated(Evidence& evidence) { return evidence.hypotheses[Evidence::kReEstimated]; }

// Unseen logs on which each hypothesis is as good as on blocks of the logs of the fit.
void addUnseenLogs(Evidence& evidence) {
  evidence.has_unseen_logs = true;
  for (HypothesisEvidence& hypothesis : evidence.hypotheses) {
    hypothesis.unseen = UnseenErrors{hypothesis.held_out, evidence.noise_floor, {}};
  }
}

// Model parameters that re-estimation moves far, where one number would do with the parameters as specified.
void hideSimpleEffect(Evidence& evidence) {
  reEstimated(evidence).held_out = 0.0101;
  reEstimated(evidence).penalty = 0.05;
  reEstimated(evidence).largest_change = 0.5;
  single(evidence, kSimple).held_out = 0.0101;
}

// Other values leave 1.9 % of the force, four floors, and a fifth of the gap.
void leaveLittleByValues(Evidence& evidence) {
  evidence.noise_floor = 0.005;
  configured(evidence).held_out = 0.1;
  reEstimated(evidence).held_out = 0.02;
  for (int effect = 0; effect < kEffects; ++effect) {
    single(evidence, effect).held_out = 0.02;
  }
}

// Residuals of 2 % in the band of the motion, which no effect explains.
void leaveResidualNearNoise(Evidence& evidence) {
  configured(evidence).held_out = 0.05;
  reEstimated(evidence).held_out = 0.02;
  for (int effect = 0; effect < kEffects; ++effect) {
    single(evidence, effect).held_out = 0.02;
  }
  addUnseenLogs(evidence);
}

// One factor on all forces closes the gap, and so do values that are all off by it.
void doAsValuesDo(Evidence& evidence) {
  configured(evidence).held_out = 0.3;
  reEstimated(evidence).held_out = 0.0105;
  evidence.element_level = 0.0105;
  single(evidence, kOther).held_out = 0.0105;
  single(evidence, kOther).like_parameters = true;
}

// A surrogate predicts three tenths of the squared gap; an effect closes an eighth of the gap.
void closeLittle(Evidence& evidence) {
  evidence.caused_by_motion = 0.3;
  single(evidence, kOther).held_out = 0.175;
}

// Errors of a hypothesis on logs of one block each.
void errInLogs(HypothesisEvidence& hypothesis, Evidence& evidence, const std::vector<double>& errors) {
  evidence.block_logs.resize(errors.size());
  std::iota(evidence.block_logs.begin(), evidence.block_logs.end(), 0);
  evidence.block_weights.assign(errors.size(), 1.0);
  for (const double error : errors) {
    hypothesis.block_errors.push_back(error * error);
  }
}

// Parameters leave 2.1 % in each of three logs, and another effect this much.
void gainInLogs(Evidence& evidence, const std::vector<double>& errors) {
  reEstimated(evidence).held_out = 0.021;
  single(evidence, kOther).held_out = 0.009;
  evidence.noise_floor = 0.008;
  evidence.element_level = 0.021;
  configured(evidence).held_out = 0.1;
  errInLogs(reEstimated(evidence), evidence, std::vector<double>(errors.size(), 0.021));
  errInLogs(single(evidence, kOther), evidence, errors);
}

// Ten parts of unseen logs, of which each has so much of the hypothesis's error.
void scatter(HypothesisEvidence& hypothesis, const std::vector<double>& factors) {
  hypothesis.unseen->parts.clear();
  for (const double factor : factors) {
    hypothesis.unseen->parts.push_back({std::pow(factor * hypothesis.unseen->gap, 2), 0.1});
  }
}

const std::vector<double> kEven(10, 1.0);

// A drift for each log, or the zero that it contains, beside an effect that leaves half of the gap.
void driftBesideAnother(Evidence& evidence) {
  evidence.contains = {{}, {}, {kSimple}, {}, {}};
  single(evidence, kMany).held_out = 0.1;
  evidence.hypotheses.push_back(fitted({kMany, kSimple}, 0.0300));
  evidence.hypotheses.push_back(fitted({kMany, kDrift}, 0.0102));
}

// An effect that changes from log to log by what was before leaves 6 %, and with a gain of each log beside it so much.
void gainBesideHistory(Evidence& evidence, double held_out) {
  single(evidence, kMany).held_out = 0.06;
  single(evidence, kMany).history = true;
  single(evidence, kOther).free_gains = true;
  HypothesisEvidence both = fitted({kMany, kOther}, held_out);
  both.history = both.free_gains = true;
  evidence.hypotheses.push_back(both);
}

struct Row {
  std::string rule;
  std::function<void(Evidence&, Criteria&)> change;  // of the unexplained gap
  Verdict verdict;
  std::vector<int> effects;
};

void PrintTo(const Row& row, std::ostream* stream) { *stream << row.rule; }

const std::vector<Row> kRows = {
    {"a gap that nothing closes is unknown", [](Evidence&, Criteria&) {}, Verdict::unknown, {}},
    // none
    {"at the noise floor there is no gap",
     [](Evidence& e, Criteria&) { configured(e).held_out = 0.0105; },
     Verdict::none,
     {}},
    {"a gap of half a per cent is within the accuracy of discretisation",
     [](Evidence& e, Criteria&) {
       e.noise_floor = 0.0005;
       configured(e).held_out = 0.005;
     },
     Verdict::none,
     {}},
    {"a gap that the time steps explain is none",
     [](Evidence& e, Criteria&) {
       e.discretisation = 0.025;
       configured(e).held_out = 0.025;
     },
     Verdict::none,
     {}},
    // parameter_error
    {"parameters that leave noise are the error",
     [](Evidence& e, Criteria&) { reEstimated(e).held_out = 0.0105; },
     Verdict::parameter_error,
     {}},
    {"parameters that leave a tenth of the gap and no more than 2 % of the force are the error",
     [](Evidence& e, Criteria&) { reEstimated(e).held_out = 0.022; },  // over a floor of 1 %
     Verdict::parameter_error,
     {}},
    {"no more than that is accepted, however many floors it is",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = 0.024;
       for (int effect = 0; effect < kEffects; ++effect) {
         single(e, effect).held_out = 0.024;
       }
     },
     Verdict::unknown,
     {}},
    {"parameters that leave a tenth of the gap far above the noise are not",
     [](Evidence& e, Criteria&) {
       configured(e).held_out = 1.0;
       reEstimated(e).held_out = 0.08;
       for (int effect = 0; effect < kEffects; ++effect) {
         single(e, effect).held_out = 0.08;
       }
     },
     Verdict::unknown,
     {}},
    {"parameters of all elements count where the specification's close most",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = 0.08;
       e.element_level = 0.0105;
     },
     Verdict::parameter_error,
     {}},
    {"parameters of all elements do not count where the specification's close little",
     [](Evidence& e, Criteria&) { e.element_level = 0.0105; },
     Verdict::unknown,
     {}},
    // effects that re-estimation hides
    {"one number with the parameters as specified is simpler than parameters moved far",
     [](Evidence& e, Criteria&) { hideSimpleEffect(e); },
     Verdict::named,
     {kSimple}},
    {"where other values leave what an engineer accepts, an effect has to gain as a further one has to",
     [](Evidence& e, Criteria&) {
       leaveLittleByValues(e);
       single(e, kOther).held_out = 0.013;  // a third less
     },
     Verdict::parameter_error,
     {}},
    {"and is named where it does",
     [](Evidence& e, Criteria&) {
       leaveLittleByValues(e);
       single(e, kOther).held_out = 0.007;
     },
     Verdict::named,
     {kOther}},
    {"an effect of many numbers is no simpler",
     [](Evidence& e, Criteria&) {
       hideSimpleEffect(e);
       single(e, kSimple).terms = 8;
     },
     Verdict::parameter_error,
     {}},
    {"an effect is no simpler that moves the parameters far itself",
     [](Evidence& e, Criteria&) {
       hideSimpleEffect(e);
       single(e, kSimple).largest_change = 0.5;
     },
     Verdict::parameter_error,
     {}},
    {"parameters that hardly moved hide nothing",
     [](Evidence& e, Criteria&) {
       hideSimpleEffect(e);
       reEstimated(e).largest_change = 0.1;
     },
     Verdict::parameter_error,
     {}},
    // named, confounded, partly, unknown
    {"an effect that leaves noise is named",
     [](Evidence& e, Criteria&) { single(e, kMany).held_out = 0.011; },
     Verdict::named,
     {kMany}},
    {"two effects that leave the same are confounded",
     [](Evidence& e, Criteria&) { single(e, kMany).held_out = single(e, kOther).held_out = 0.011; },
     Verdict::confounded,
     {kMany}},
    {"a law that contains a simpler one has to be clearly better",
     [](Evidence& e, Criteria&) {
       e.contains = {{kOther}, {}, {}, {}, {}};
       single(e, kMany).held_out = 0.0400;
       single(e, kOther).held_out = 0.0415;
       errInLogs(single(e, kMany), e, {0.03, 0.05, 0.03, 0.05});  // better in every other log
       errInLogs(single(e, kOther), e, {0.05, 0.032, 0.05, 0.032});
     },
     Verdict::partly,
     {kOther}},
    {"and is named where it is",
     [](Evidence& e, Criteria&) {
       e.contains = {{kOther}, {}, {}, {}, {}};
       single(e, kMany).held_out = 0.011;
       single(e, kOther).held_out = 0.08;
     },
     Verdict::named,
     {kMany}},
    {"the simplest of a chain stands for all of it",
     [](Evidence& e, Criteria&) {
       e.contains = {{kOther}, {}, {}, {}, {kSimple}};  // the last one is settled after what contains it
       single(e, kMany).held_out = 0.0400;
       single(e, kOther).held_out = 0.0410;
       single(e, kSimple).held_out = 0.0430;
       errInLogs(single(e, kMany), e, {0.03, 0.05, 0.03, 0.05});
       errInLogs(single(e, kOther), e, {0.05, 0.031, 0.05, 0.031});
       errInLogs(single(e, kSimple), e, {0.033, 0.053, 0.033, 0.053});
     },
     Verdict::partly,
     {kSimple}},
    {"a further effect is sought in no rest smaller than the noise",
     [](Evidence& e, Criteria&) {
       e.noise_floor = 0.03;
       single(e, kMany).held_out = 0.04;  // 0.84 of a floor of 3 % are left above it
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.031));
     },
     Verdict::named,
     {kMany}},
    {"nor in one that an engineer accepts",
     [](Evidence& e, Criteria&) {
       e.noise_floor = 0.005;
       single(e, kMany).held_out = 0.018;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0052));
       addUnseenLogs(e);
     },
     Verdict::named,
     {kMany}},
    {"but in one that unseen logs show to be more",
     [](Evidence& e, Criteria&) {
       e.noise_floor = 0.005;
       single(e, kMany).held_out = 0.015;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0052));
       addUnseenLogs(e);
       single(e, kMany).unseen->gap = 0.025;  // 2.02 % over all logs
     },
     Verdict::named,
     {kMany, kOther}},
    {"each of the simpler ones that it contains stands for it",
     [](Evidence& e, Criteria&) {
       e.contains = {{kSimple, kOther}, {}, {}, {}, {}};
       single(e, kMany).held_out = 0.0400;
       single(e, kOther).held_out = 0.0415;
       errInLogs(single(e, kMany), e, {0.03, 0.05, 0.03, 0.05});
       errInLogs(single(e, kOther), e, {0.05, 0.032, 0.05, 0.032});
       errInLogs(single(e, kSimple), e, {0.2, 0.2, 0.2, 0.2});
     },
     Verdict::partly,
     {kOther}},
    {"moved parameters count against an effect",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = single(e, kOther).held_out = 0.011;
       single(e, kMany).penalty = 0.08;
     },
     Verdict::named,
     {kOther}},
    {"an effect that leaves half of the gap explains it in part",
     [](Evidence& e, Criteria&) { single(e, kMany).held_out = 0.1; },
     Verdict::partly,
     {kMany}},
    {"an effect that closes a tenth of the gap does not explain it",
     [](Evidence& e, Criteria&) { single(e, kMany).held_out = 0.18; },
     Verdict::unknown,
     {}},
    {"an effect that these logs hardly show is not named for a small gain",
     [](Evidence& e, Criteria&) {
       e.testable.assign(kEffects, false);
       single(e, kMany).held_out = 0.15;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.149));
     },
     Verdict::unknown,
     {}},
    {"an effect that closes much does show, typical or not",
     [](Evidence& e, Criteria&) {
       e.testable.assign(kEffects, false);
       single(e, kMany).held_out = 0.011;
     },
     Verdict::named,
     {kMany}},
    // several effects
    {"two effects are named where one leaves much",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.1;
       single(e, kOther).held_out = 0.15;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.011));
     },
     Verdict::named,
     {kMany, kOther}},
    {"the effect without which most would be left comes first",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.15;
       single(e, kOther).held_out = 0.1;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.011));
     },
     Verdict::named,
     {kOther, kMany}},
    {"a second effect that gains little is not named",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.05;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.045));
     },
     Verdict::partly,
     {kMany}},
    {"three effects are named where two leave much",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.12;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.06));
       e.hypotheses.push_back(fitted({kMany, kSimple, kOther}, 0.011));
     },
     Verdict::named,
     {kMany, kOther, kSimple}},
    {"a second effect is named beside one that closes nine tenths, where more than 2 % of the force is left",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.03;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0105));
     },
     Verdict::named,
     {kMany, kOther}},
    {"a gain of each log beside an effect that changes from log to log may be what its law leaves",
     [](Evidence& e, Criteria&) { gainBesideHistory(e, 0.03); },
     Verdict::partly,
     {kMany}},
    {"and is named where it gains what two further effects would",
     [](Evidence& e, Criteria&) { gainBesideHistory(e, 0.0105); },
     Verdict::named,
     {kMany, kOther}},
    {"a third effect has to gain over the best two, even where these are not named",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.06;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.045));
       e.hypotheses.push_back(fitted({kMany, kSimple, kOther}, 0.03));
     },
     Verdict::partly,
     {kMany}},
    {"what moved parameters cost with and without it hides no second effect",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.08;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.02));
       single(e, kMany).penalty = e.hypotheses.back().penalty = 0.1;
     },
     Verdict::named,
     {kMany, kOther}},
    {"one more effect that closes as much of the gap as an explanation has to is named",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.1;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.068));
     },
     Verdict::partly,
     {kMany, kOther}},
    {"not one that closes what the form of the first may leave",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.07;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.048));
     },
     Verdict::partly,
     {kMany}},
    {"nor gains of each log, which follow any law's",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.1;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.068));
       e.hypotheses.back().free_gains = true;
       single(e, kOther).free_gains = true;
     },
     Verdict::partly,
     {kMany}},
    {"no more effects are named than may be",
     [](Evidence& e, Criteria& c) {
       c.most_effects = 1;
       single(e, kMany).held_out = 0.1;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.011));
     },
     Verdict::partly,
     {kMany}},
    // drift and last resort
    {"an effect goes before a drift that leaves as little",
     [](Evidence& e, Criteria&) { single(e, kDrift).held_out = single(e, kOther).held_out = 0.011; },
     Verdict::named,
     {kOther}},
    {"nothing is sought in a rest below the noise, whatever moved parameters cost",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.0105;
       single(e, kMany).penalty = 0.03;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0));
     },
     Verdict::named,
     {kMany}},
    {"an effect goes before gains of each log that leave as little",
     [](Evidence& e, Criteria&) {
       single(e, kOther).free_gains = true;
       single(e, kMany).held_out = 0.0112;
       single(e, kOther).held_out = 0.011;
     },
     Verdict::named,
     {kMany}},
    {"gains of each log that leave less are named",
     [](Evidence& e, Criteria&) {
       single(e, kOther).free_gains = true;
       single(e, kMany).held_out = 0.1;
       single(e, kOther).held_out = 0.011;
     },
     Verdict::named,
     {kOther}},
    {"a last resort gives way to any effect that explains as much",
     [](Evidence& e, Criteria&) { single(e, kLastResort).held_out = single(e, kOther).held_out = 0.02; },
     Verdict::named,
     {kOther}},
    {"a last resort is named where all others fail",
     [](Evidence& e, Criteria&) { single(e, kLastResort).held_out = 0.02; },
     Verdict::named,
     {kLastResort}},
    {"a last resort that leaves more than 0.71 of the gap explains it no more than another effect",
     [](Evidence& e, Criteria&) { single(e, kLastResort).held_out = 0.15; },
     Verdict::unknown,
     {}},
    {"nor where it errs less than another effect by chance",
     [](Evidence& e, Criteria&) {
       single(e, kLastResort).held_out = 0.080;
       single(e, kOther).held_out = 0.085;
       errInLogs(single(e, kLastResort), e, {0.06, 0.10, 0.06, 0.10});
       errInLogs(single(e, kOther), e, {0.10, 0.07, 0.10, 0.07});
     },
     Verdict::partly,
     {kOther}},
    {"but where it errs less in all logs",
     [](Evidence& e, Criteria&) {
       single(e, kLastResort).held_out = 0.07;
       single(e, kOther).held_out = 0.085;
       errInLogs(single(e, kLastResort), e, {0.06, 0.08, 0.06, 0.08});
       errInLogs(single(e, kOther), e, {0.075, 0.098, 0.074, 0.099});
     },
     Verdict::partly,
     {kLastResort}},
    {"no set of effects stands for a last resort that would not be named itself",
     [](Evidence& e, Criteria&) {
       single(e, kLastResort).held_out = 0.020;
       single(e, kOther).held_out = 0.033;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0205));
     },
     Verdict::named,
     {kLastResort}},
    {"but one that errs less does",
     [](Evidence& e, Criteria&) {
       single(e, kLastResort).held_out = 0.0206;
       single(e, kOther).held_out = 0.033;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0203));
     },
     Verdict::partly,
     {kOther}},
    {"one that would be does",
     [](Evidence& e, Criteria&) {
       single(e, kLastResort).held_out = 0.020;
       single(e, kOther).held_out = 0.06;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0206));
     },
     Verdict::named,
     {kOther, kMany}},
    {"a last resort gives way to another one that it contains",
     [](Evidence& e, Criteria&) {
       e.contains = {{}, {}, {}, {kOther}, {}};
       single(e, kOther).last_resort = true;
       single(e, kLastResort).held_out = 0.0200;
       single(e, kOther).held_out = 0.0205;
     },
     Verdict::named,
     {kOther}},
    {"and goes before one that explains most, likewise",
     [](Evidence& e, Criteria&) {
       single(e, kLastResort).held_out = 0.011;
       single(e, kOther).held_out = 0.016;
       errInLogs(single(e, kLastResort), e, {0.010, 0.012, 0.010, 0.012});
       errInLogs(single(e, kOther), e, {0.015, 0.017, 0.015, 0.017});
     },
     Verdict::named,
     {kLastResort}},
    {"a last resort beside an effect is named where all others fail",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.1;
       single(e, kLastResort).held_out = 0.12;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.09));
       e.hypotheses.push_back(fitted({kMany, kLastResort}, 0.02));
     },
     Verdict::named,
     {kMany, kLastResort}},
    {"but not where two others explain as much",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.1;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.02));
       e.hypotheses.push_back(fitted({kMany, kLastResort}, 0.02));
     },
     Verdict::named,
     {kMany, kOther}},
    {"a zero goes before a drift beside another effect that gains no more than slow noise may",
     [](Evidence& e, Criteria&) {
       driftBesideAnother(e);
       e.slow_noise = 0.05;
     },
     Verdict::partly,
     {kMany, kSimple}},
    {"a drift that gains more is one",
     [](Evidence& e, Criteria&) {
       driftBesideAnother(e);
       e.slow_noise = 0.01;
     },
     Verdict::named,
     {kMany, kDrift}},
    // unseen logs
    {"an effect that unseen logs confirm is named",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       addUnseenLogs(e);
     },
     Verdict::named,
     {kMany}},
    {"an effect that closes nothing of unseen logs is a false positive",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       addUnseenLogs(e);
       single(e, kMany).unseen->gap = 0.21;
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
     },
     Verdict::unknown,
     {}},
    {"the next best effect is named where unseen logs refute the best",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       single(e, kOther).held_out = 0.05;
       addUnseenLogs(e);
       single(e, kMany).unseen->gap = 0.21;
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
       scatter(single(e, kOther), kEven);
     },
     Verdict::partly,
     {kOther}},
    {"but not one that closes less than a third of what unseen logs show",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       single(e, kOther).held_out = 0.05;
       addUnseenLogs(e);
       single(e, kMany).unseen->gap = 0.21;
       single(e, kOther).unseen->gap = 0.15;
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
       scatter(single(e, kOther), kEven);
     },
     Verdict::unknown,
     {}},
    {"the second effect is withdrawn where only the first predicts unseen logs",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.05;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.011));
       addUnseenLogs(e);
       e.hypotheses.back().unseen->gap = 0.25;
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
       scatter(e.hypotheses.back(), kEven);
     },
     Verdict::partly,
     {kMany}},
    {"unseen logs that show nothing speak neither for an effect nor against wrong values",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       addUnseenLogs(e);
       reEstimated(e).unseen = UnseenErrors{0.0105, 0.01, {}};
       single(e, kMany).unseen = UnseenErrors{0.02, 0.01, {}};
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
     },
     Verdict::confounded,
     {kMany}},
    {"a drift that surely makes unseen logs no better is a false positive",
     [](Evidence& e, Criteria&) {
       single(e, kDrift).held_out = 0.011;
       addUnseenLogs(e);
       single(e, kDrift).unseen->gap = 0.21;
       scatter(reEstimated(e), kEven);
       scatter(single(e, kDrift), kEven);
     },
     Verdict::unknown,
     {}},
    {"an effect that gains in one part of unseen logs, and loses in others, may do so by chance",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.1;
       addUnseenLogs(e);
       scatter(reEstimated(e), {3.0, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2});
       scatter(single(e, kMany), kEven);
     },
     Verdict::unknown,
     {}},
    {"a second effect that closes nothing of unseen logs is not named",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.04;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.011));
       addUnseenLogs(e);
       e.hypotheses.back().unseen = single(e, kMany).unseen;
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
       scatter(e.hypotheses.back(), kEven);
     },
     Verdict::partly,
     {kMany}},
    {"a second effect is named that unseen logs do not excite",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.04;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.011));
       addUnseenLogs(e);
       single(e, kMany).unseen = UnseenErrors{0.0105, 0.01, {}};
       e.hypotheses.back().unseen = single(e, kMany).unseen;
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
       scatter(e.hypotheses.back(), kEven);
     },
     Verdict::named,
     {kMany, kOther}},
    {"the next best two are named where unseen logs refute the best two",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.1;
       e.hypotheses.push_back(fitted({kMany, kOther}, 0.0105));
       e.hypotheses.push_back(fitted({kMany, kSimple}, 0.011));
       addUnseenLogs(e);
       e.hypotheses[e.hypotheses.size() - 2].unseen = UnseenErrors{0.21, 0.01, {}};
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
       scatter(single(e, kSimple), kEven);
       scatter(e.hypotheses[e.hypotheses.size() - 2], kEven);
       scatter(e.hypotheses.back(), kEven);
     },
     Verdict::named,
     {kMany, kSimple}},
    {"a law that gives way under the motion of unseen logs is not named",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       single(e, kOther).held_out = 0.02;
       addUnseenLogs(e);
       single(e, kMany).unseen->gap = std::numeric_limits<double>::infinity();
     },
     Verdict::named,
     {kOther}},
    {"an effect that is best on all logs together goes before one that is best on those of the fit",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       single(e, kOther).held_out = 0.015;
       addUnseenLogs(e);
       single(e, kMany).unseen->gap = 0.05;
     },
     Verdict::named,
     {kOther}},
    {"an effect that gains in all parts of unseen logs does not",
     [](Evidence& e, Criteria&) {
       single(e, kMany).held_out = 0.011;
       addUnseenLogs(e);
       scatter(reEstimated(e), kEven);
       scatter(single(e, kMany), kEven);
     },
     Verdict::named,
     {kMany}},
    {"a hidden effect that unseen logs do not prefer stands beside wrong values",
     [](Evidence& e, Criteria&) {
       hideSimpleEffect(e);
       addUnseenLogs(e);
       scatter(reEstimated(e), kEven);
       scatter(single(e, kSimple), kEven);
     },
     Verdict::confounded,
     {kSimple}},
    {"a hidden effect that leaves more of unseen logs than wrong values do is not named",
     [](Evidence& e, Criteria&) {
       hideSimpleEffect(e);
       addUnseenLogs(e);
       scatter(reEstimated(e), kEven);
       scatter(single(e, kSimple), kEven);
       single(e, kSimple).unseen->gap = 1.05 * reEstimated(e).unseen->gap;
     },
     Verdict::parameter_error,
     {}},
    {"an effect that explains unseen logs goes before wrong values that do not",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = 0.0105;
       single(e, kOther).held_out = 0.0104;
       addUnseenLogs(e);
       reEstimated(e).unseen = UnseenErrors{0.2, 0.01, {}};
       single(e, kOther).unseen = UnseenErrors{0.02, 0.01, {}};
     },
     Verdict::named,
     {kOther}},
    {"a small residual that unseen logs show as configured only is a parameter error",
     [](Evidence& e, Criteria&) {
       leaveResidualNearNoise(e);
       reEstimated(e).unseen->gap = 0.0105;
     },
     Verdict::parameter_error,
     {}},
    {"what does exactly as values do stands beside them",
     [](Evidence& e, Criteria&) { doAsValuesDo(e); },
     Verdict::confounded,
     {kOther}},
    {"what does as values do within what they err by does not",
     [](Evidence& e, Criteria&) {
       doAsValuesDo(e);
       single(e, kOther).within_tolerance = true;
     },
     Verdict::parameter_error,
     {}},
    {"what does as values do is never named where these do not close the gap",
     [](Evidence& e, Criteria&) {
       doAsValuesDo(e);
       reEstimated(e).held_out = 0.15;
     },
     Verdict::unknown,
     {}},
    {"a residual of less than 2 % on all logs is accepted",
     [](Evidence& e, Criteria&) { leaveResidualNearNoise(e); },
     Verdict::parameter_error,
     {}},
    {"a residual of less than 2 % with nothing that parameters could mend is no gap",
     [](Evidence& e, Criteria&) {
       leaveResidualNearNoise(e);
       configured(e).held_out = 0.021;
       addUnseenLogs(e);
     },
     Verdict::none,
     {}},
    {"a residual of 2 % that is beyond the noise on unseen logs stays unknown",
     [](Evidence& e, Criteria&) {
       leaveResidualNearNoise(e);
       for (HypothesisEvidence& hypothesis : e.hypotheses) {
         hypothesis.unseen->gap = 0.06;
       }
     },
     Verdict::unknown,
     {}},
    {"a large residual is no noise, whatever unseen logs show",
     [](Evidence& e, Criteria&) {
       addUnseenLogs(e);
       configured(e).unseen->gap = reEstimated(e).unseen->gap = 0.0105;
     },
     Verdict::unknown,
     {}},
    {"agreement that unseen logs deny is unknown",
     [](Evidence& e, Criteria&) {
       configured(e).held_out = 0.0105;
       addUnseenLogs(e);
       configured(e).unseen = UnseenErrors{0.2, 0.01, {}};
     },
     Verdict::unknown,
     {}},
    {"a parameter error that unseen logs deny is unknown",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = 0.0105;
       addUnseenLogs(e);
       reEstimated(e).unseen = UnseenErrors{0.2, 0.01, {}};
     },
     Verdict::unknown,
     {}},
    {"unseen logs deny nothing below 2 % of the force",
     [](Evidence& e, Criteria&) {
       addUnseenLogs(e);
       for (HypothesisEvidence& hypothesis : e.hypotheses) {
         hypothesis.held_out = 0.0105;
         hypothesis.unseen = UnseenErrors{0.024, 0.015, {}};
       }
     },
     Verdict::none,
     {}},
    {"a trend that the rig's slow noise may be is no gap",
     [](Evidence& e, Criteria&) {
       configured(e).held_out = 0.2;
       single(e, kDrift).held_out = 0.0105;
       e.slow_noise = 0.3;
     },
     Verdict::none,
     {}},
    {"a trend that the rig's slow noise may be leaves the parameters to blame for the rest",
     [](Evidence& e, Criteria&) {
       single(e, kDrift).held_out = 0.0105;
       e.slow_noise = 0.3;
     },
     Verdict::parameter_error,
     {}},
    {"a trend that the rig's slow noise cannot be is a drift",
     [](Evidence& e, Criteria&) {
       single(e, kDrift).held_out = 0.0105;
       e.slow_noise = 0.1;
     },
     Verdict::named,
     {kDrift}},
    {"an effect goes before slow noise of the rig",
     [](Evidence& e, Criteria&) {
       single(e, kDrift).held_out = 0.0105;
       single(e, kOther).held_out = 0.0105;
       e.slow_noise = 0.3;
     },
     Verdict::named,
     {kOther}},
    // what is left
    {"an effect is named where unseen logs refute the parameters and confirm the effect",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = 0.02;
       single(e, kOther).held_out = 0.0105;
       addUnseenLogs(e);
       reEstimated(e).unseen = UnseenErrors{0.08, 0.01, {}};
     },
     Verdict::named,
     {kOther}},
    {"an effect that unseen logs do not confirm is no better than parameters that they refute",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = 0.02;
       single(e, kOther).held_out = 0.0105;
       addUnseenLogs(e);
       reEstimated(e).unseen = UnseenErrors{0.08, 0.01, {}};
       single(e, kOther).unseen->gap = 0.075;
     },
     Verdict::unknown,
     {}},
    {"an effect that gains little in one log of three is chance",
     [](Evidence& e, Criteria&) {
       gainInLogs(e, {0.012, 0.021, 0.021});
     },
     Verdict::parameter_error,
     {}},
    {"an effect that gains as much in all logs is not",
     [](Evidence& e, Criteria&) {
       gainInLogs(e, {0.0122, 0.012, 0.0118});
     },
     Verdict::named,
     {kOther}},
    {"a rest beyond noise is one, whatever share is closed",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = 0.29;
       for (int effect = 0; effect < kEffects; ++effect) {
         single(e, effect).held_out = effect == kOther ? 0.06 : 0.29;
       }
     },
     Verdict::partly,
     {kOther}},
    {"a second effect is named that one large trivial effect hides",
     [](Evidence& e, Criteria&) {
       reEstimated(e).held_out = configured(e).held_out = 16.0;
       for (int effect = 0; effect < kEffects; ++effect) {
         single(e, effect).held_out = effect == kSimple ? 1.0 : 15.0;
       }
       e.hypotheses.push_back(fitted({kSimple, kOther}, 0.012));
     },
     Verdict::named,
     {kSimple, kOther}},
    {"a rest on unseen logs is one, too",
     [](Evidence& e, Criteria&) {
       single(e, kOther).held_out = 0.0105;
       addUnseenLogs(e);
       single(e, kOther).unseen = UnseenErrors{0.08, 0.01, {}};
     },
     Verdict::partly,
     {kOther}},
    // what no motion causes
    {"beside what no motion causes, a cause may close a small part",
     [](Evidence& e, Criteria&) { closeLittle(e); },
     Verdict::partly,
     {kOther}},
    {"not where the motion causes the larger part",
     [](Evidence& e, Criteria&) {
       closeLittle(e);
       e.caused_by_motion = 0.6;
     },
     Verdict::unknown,
     {}},
    {"nor an error of the force channel, which it does not cause",
     [](Evidence& e, Criteria&) {
       closeLittle(e);
       single(e, kOther).sensor = true;
     },
     Verdict::unknown,
     {}},
    {"nor less than counts as explained",
     [](Evidence& e, Criteria&) {
       closeLittle(e);
       single(e, kOther).held_out = 0.1991;
     },
     Verdict::unknown,
     {}},
    {"nor what unseen logs do not show",
     [](Evidence& e, Criteria&) {
       closeLittle(e);
       addUnseenLogs(e);
       single(e, kOther).unseen->gap = 0.1991;
     },
     Verdict::unknown,
     {}},
    {"nor by chance",
     [](Evidence& e, Criteria&) {
       closeLittle(e);
       errInLogs(reEstimated(e), e, {0.2, 0.2, 0.2, 0.2});
       errInLogs(single(e, kOther), e, {0.21, 0.1, 0.19, 0.21});
     },
     Verdict::unknown,
     {}},
    {"what moved parameters cost is no rest",
     [](Evidence& e, Criteria&) {
       single(e, kOther).held_out = 0.0105;
       single(e, kOther).penalty = 0.07;
     },
     Verdict::named,
     {kOther}},
};

class Judge : public testing::TestWithParam<Row> {};

INSTANTIATE_TEST_SUITE_P(Rules, Judge, testing::ValuesIn(kRows));

TEST_P(Judge, FollowsTheRule) {
  Evidence evidence = unexplained();
  Criteria criteria;
  GetParam().change(evidence, criteria);
  const Judgement judgement = judge(evidence, criteria);
  EXPECT_EQ(toString(judgement.verdict), toString(GetParam().verdict)) << GetParam().rule;
  EXPECT_EQ(judgement.effects, GetParam().effects) << GetParam().rule;
}

// Whatever the evidence: what a report relies on.
TEST_P(Judge, AgreesWithItself) {
  Evidence evidence = unexplained();
  Criteria criteria;
  GetParam().change(evidence, criteria);
  const Judgement judgement = judge(evidence, criteria);
  ASSERT_EQ(judgement.probabilities.size(), evidence.testable.size());
  ASSERT_EQ(judgement.testable.size(), evidence.testable.size());
  for (const double probability : judgement.probabilities) {
    EXPECT_GE(probability, 0.0);
    EXPECT_LE(probability, 1.0);
  }
  ASSERT_EQ(judgement.confounded.size(), judgement.effects.size());
  for (std::size_t i = 0; i < judgement.effects.size(); ++i) {
    const std::vector<int>& set = judgement.confounded[i];
    EXPECT_NE(std::find(set.begin(), set.end(), judgement.effects[i]), set.end()) << "named, and not in its own set";
  }
  std::vector<int> named = judgement.effects;
  std::sort(named.begin(), named.end());
  EXPECT_EQ(evidence.at(judgement.model).members, named) << "the model is made of what is named";
  const bool names = judgement.verdict == Verdict::named || judgement.verdict == Verdict::confounded ||
                     judgement.verdict == Verdict::partly;
  EXPECT_EQ(names, !judgement.effects.empty());
  const Posterior& posterior = judgement.posterior;
  EXPECT_NEAR(posterior.none + posterior.parameter_error + posterior.effects + posterior.none_of_these, 1.0, 1e-12);
  const double verdict = judgement.verdict == Verdict::none              ? posterior.none
                         : judgement.verdict == Verdict::parameter_error ? posterior.parameter_error
                         : names                                         ? posterior.effects
                                                                         : posterior.none_of_these;
  EXPECT_EQ(verdict, std::max({posterior.none, posterior.parameter_error, posterior.effects, posterior.none_of_these}));
}

TEST(Judgement, SaysWhereOnlyUnseenLogsDiffer) {
  Evidence evidence = unexplained();
  configured(evidence).held_out = 0.0105;
  addUnseenLogs(evidence);
  EXPECT_FALSE(judge(evidence).only_unseen_logs_differ);
  configured(evidence).unseen = UnseenErrors{0.2, 0.01, {}};
  EXPECT_TRUE(judge(evidence).only_unseen_logs_differ);
}

TEST(Judgement, HoldsBothOfTwoEqualEffectsInTheSet) {
  Evidence evidence = unexplained();
  single(evidence, kMany).held_out = single(evidence, kOther).held_out = 0.011;
  const Judgement judgement = judge(evidence);
  ASSERT_EQ(judgement.confounded.size(), 1U);
  EXPECT_EQ(judgement.confounded[0], (std::vector<int>{kMany, kOther}));
  EXPECT_DOUBLE_EQ(judgement.probabilities[kMany], judgement.probabilities[kOther]);
}

TEST(Weighing, CallsForFurtherEffectsWhereMuchIsLeft) {
  Evidence evidence = unexplained();
  const Criteria criteria;
  EXPECT_TRUE(needsFurtherEffects(evidence, criteria));
  single(evidence, kMany).held_out = 0.011;
  EXPECT_FALSE(needsFurtherEffects(evidence, criteria));
  single(evidence, kDrift).held_out = 0.0;  // may stand for two effects that are slow
  single(evidence, kMany).held_out = 0.05;
  EXPECT_TRUE(needsFurtherEffects(evidence, criteria));
  reEstimated(evidence).held_out = 0.0105;
  EXPECT_FALSE(needsFurtherEffects(evidence, criteria));
}

// Evidence that went through a file is judged as it was.
TEST(EvidenceJson, GivesTheSameJudgement) {
  Evidence evidence = unexplained();
  single(evidence, kMany).held_out = 0.011;
  gainInLogs(evidence, {0.009, 0.01, 0.011});
  addUnseenLogs(evidence);
  scatter(reEstimated(evidence), kEven);
  single(evidence, kDrift).held_out = std::numeric_limits<double>::infinity();  // no model run follows it
  evidence.logs = {{0.01, 0.1, 1.0, false}, {0.02, 0.3, 0.5, true}};
  reEstimated(evidence).log_errors = {0.04, 0.05};
  single(evidence, kMany).log_errors = {1e-4, std::numeric_limits<double>::infinity()};
  single(evidence, kMany).sizes = {{0.03, 0.02}};
  const NamedEvidence written{
      evidence, {"many", "simple", "drift", "last", "other"}, {false, false, true, false, false}};
  const NamedEvidence read = parseEvidence(toJson(written));
  EXPECT_EQ(toJson(read), toJson(written));
  EXPECT_EQ(read.effects, written.effects);
  EXPECT_EQ(read.on_rig, written.on_rig);
  EXPECT_EQ(judge(read.evidence).probabilities, judge(evidence).probabilities);
}

TEST(EvidenceJson, RefusesWhatIsNone) {
  for (const char* text : {"", "[]", "{}", R"({"schema": "rubber_suspension/gap_report/1"})",
                           R"({"schema": "rubber_suspension/evidence/3", "effects": 3})"}) {
    EXPECT_THROW(parseEvidence(text), std::invalid_argument) << text;
  }
}

// The set holds the right answer as probably as it has to, wrong values being one of the answers.
TEST(Judge, PutsWrongValuesIntoTheSetByTheRuleForEffects) {
  const Criteria criteria;
  int within = 0;
  int without = 0;
  for (double left = 0.011; left < 0.1; left *= 1.03) {
    Evidence evidence = unexplained();
    hideSimpleEffect(evidence);
    reEstimated(evidence).penalty = 0.0;
    reEstimated(evidence).held_out = left;
    const Judgement judgement = judge(evidence, criteria);
    if (judgement.effects.empty()) {
      continue;
    }
    const Posterior& answers = judgement.posterior;
    if (answers.effects < criteria.set_probability * (answers.effects + answers.parameter_error)) {
      EXPECT_TRUE(judgement.values_would_do) << left;
      EXPECT_EQ(judgement.verdict, Verdict::confounded) << left;
      ++within;
    } else {
      ++without;
    }
  }
  EXPECT_GT(within, 0);
  EXPECT_GT(without, 0);
}

}  // namespace
}  // namespace rubber_suspension::diagnosis
