// Checks that the verdict, gaps, noise floor, intervals, sizes and probabilities of a report are consistent.
#include "diagnosis/invariants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/results/left_of_logs.h"
#include "diagnosis/words/candidates.h"
#include "diagnosis/words/model_values.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kRounding = 1e-9;
constexpr double kReplayed = 1e-3;  // relative difference between gaps of blocks and gaps of whole logs
constexpr double kWorthListing = 0.02;

bool nearly(double a, double b, double tolerance = kRounding) { return std::abs(a - b) <= tolerance; }

template <class List, class Function>
bool all(const List& list, const Function& holds) {
  return std::all_of(list.begin(), list.end(), holds);
}

template <class List, class Function>
double sumOf(const List& list, const Function& number) {
  return std::accumulate(list.begin(), list.end(), 0.0, [&](double sum, const auto& one) { return sum + number(one); });
}

double probabilityOf(const Diagnosis& d, const std::string& effect) {
  const auto found = std::find_if(d.candidates.begin(), d.candidates.end(),
                                  [&](const CandidateResult& candidate) { return candidate.effect == effect; });
  return found == d.candidates.end() ? 0.0 : found->probability;
}

bool posteriorIsOne(const Diagnosis& d) {
  const Posterior& p = d.answer.posterior;
  return nearly(p.none + p.parameter_error + p.effects + p.none_of_these, 1.0);
}

bool verdictIsTheLikeliest(const Diagnosis& d) {
  const Posterior& p = d.answer.posterior;
  const double said = namesEffects(d.answer.verdict)                 ? p.effects
                      : d.answer.verdict == Verdict::none            ? p.none
                      : d.answer.verdict == Verdict::parameter_error ? p.parameter_error
                                                                     : p.none_of_these;
  return said >= std::max({p.none, p.parameter_error, p.effects, p.none_of_these}) - kRounding;
}

bool nothingHalvesTheUnknown(const Diagnosis& d) {
  const judge::ScoreTable& table = d.workings->table;
  for (Eigen::Index row = judge::Evidence::kFirstSingle; row < table.errors.rows(); ++row) {
    if (d.answer.verdict == Verdict::unknown && halvesWhatIsLeft(table, row)) {
      return false;
    }
  }
  return true;
}

bool alternativesFollow(const Diagnosis& d) {
  const bool falling = std::is_sorted(d.answer.alternatives.begin(), d.answer.alternatives.end(),
                                      [](const auto& a, const auto& b) { return a.probability > b.probability; });
  return falling && d.answer.probability +
                            sumOf(d.answer.alternatives, [](const Alternative& other) { return other.probability; }) <=
                        1.0 + kRounding;
}

bool verdictHasItsEffects(const Diagnosis& d) {
  return !d.answer.effects.empty() == namesEffects(d.answer.verdict) &&
         d.answer.confounded.empty() == d.answer.effects.empty();
}

bool candidatesAreOfTheSets(const Diagnosis& d) {
  const double effects = d.answer.posterior.effects;
  return all(d.candidates, [&](const CandidateResult& c) { return c.probability <= effects + kRounding; }) &&
         sumOf(d.candidates, [](const CandidateResult& c) { return c.probability; }) >= effects - kRounding &&
         all(d.answer.excluded, [&](const auto& one) { return probabilityOf(d, one.effect) == 0.0; });
}

bool firstSetIsNamed(const Diagnosis& d) {
  return d.answer.confounded.empty() ||
         std::is_permutation(d.answer.confounded.front().begin(), d.answer.confounded.front().end(),
                             d.answer.effects.begin(), d.answer.effects.end());
}

bool setsAreProbable(const Diagnosis& d) {
  const auto listed = [&](const std::string& effect) { return probabilityOf(d, effect) >= kWorthListing; };
  return d.answer.confounded.empty() || std::all_of(d.answer.confounded.begin() + 1, d.answer.confounded.end(),
                                                    [&](const auto& set) { return all(set, listed); });
}

// Returns true if the gap of every fit on its own data is at most its gap on held-out data, up to chance. Fits with an
// infinite gap are accepted; their law has no finite force on some log.
bool noFitPredictsBetter(const Diagnosis& d) {
  const auto holds = [](const hypotheses::FittedHypothesis& fitted) {
    const fit::Fit& fit = fitted.fit;
    return !std::isfinite(fit.gap) ||
           fit.gap <= hypotheses::kBetterByChance * fit.held_out * (1.0 + kRounding) + kRounding;
  };
  const hypotheses::Search& search = d.workings->search;
  return holds(search.re_estimated) && all(search.withEffects(), [&](const auto* fitted) { return holds(*fitted); });
}

bool floorIsLeast(const Diagnosis& d) {
  const double most =
      std::min({d.gaps.unseen.as_configured, d.gaps.unseen.re_estimated, d.gaps.unseen.augmented}) + kRounding;
  return d.gaps.unseen.noise_floor <= most &&
         all(d.candidates, [&](const CandidateResult& c) { return d.gaps.unseen.noise_floor <= c.gap + kRounding; });
}

// Returns true if the named effects close more of the gap than re-estimated values. It is enough that they close any of
// the configured gap if their values are nearer to the data sheet than the re-estimated ones.
bool whatIsNamedCloses(const Diagnosis& d) {
  if (d.answer.effects.empty() || !d.law.withheld.empty()) {
    return true;
  }
  const Gap& gap = d.gaps.unseen;
  return (gap.augmented < gap.re_estimated && d.gaps.closed_interval[0] > 0.0) ||
         (gap.augmented < gap.as_configured && d.workings->isNearerToTheSheet(d.workings->answer.model));
}

bool closedIsOfTheGaps(const Diagnosis& d) {
  const double fraction =
      (d.gaps.unseen.re_estimated - d.gaps.unseen.augmented) / (d.gaps.unseen.re_estimated - d.gaps.unseen.noise_floor);
  return d.answer.effects.empty() || nearly(d.gaps.closed, std::min(1.0, fraction));
}

bool intervalHoldsWhatIsClosed(const Diagnosis& d) {
  return d.answer.effects.empty() ||
         (d.gaps.closed_interval[0] <= d.gaps.closed && d.gaps.closed <= d.gaps.closed_interval[1]);
}

// Returns true if the sentence begins with the value that deviates most from the component file.
bool headlineIsTheLargest(const Diagnosis& d) {
  const SizedValue* const headline = words::headlineValue(d);
  return all(words::changedValues(d), [&](const SizedValue* size) {
    return !words::mayBeHeadline(*size) || (headline != nullptr && words::farOff(*size) <= words::farOff(*headline));
  });
}

// Returns true if each interval with a lower end of 0, except for values of 0, is marked as limited by a bound.
bool boundsAreSaid(const Diagnosis& d) {
  const auto holds = [](const SizedValue& size) {
    return size.interval_95[0] != 0.0 || size.value == 0.0 || size.at_bound[0];
  };
  return all(d.law.model_sizes, holds) && all(d.law.effect_sizes, holds);
}

// Returns true if the reason why a candidate is not named is consistent with its gap.
bool reasonsAgree(const Diagnosis& d) {
  return all(d.candidates, [&](const CandidateResult& c) {
    const words::Out reason = words::reasonOf(d, c);
    return (reason != words::Out::more_than_named || c.gap > d.gaps.unseen.augmented) &&
           (reason != words::Out::less_probable || c.gap <= d.gaps.unseen.augmented);
  });
}

bool takenOutAddsUp(const Diagnosis& d) {
  return all(d.logs.admission, [&](const Admission& log) {
    const double left = log.recorded * log.recorded - sumOf(d.logs.taken_out, [&](const TakenOut& part) {
                          return part.log == log.log ? std::copysign(part.share * part.share, part.share) : 0.0;
                        });
    return nearly(left, log.left * log.left, kRounding * (1.0 + left));
  });
}

bool isInPieces(const Diagnosis& d) {
  return !all(d.logs.admission, [](const Admission& log) {
    return all(log.notes, [](const std::string& note) { return note.find("time gaps") == std::string::npos; });
  });
}

// Returns true if the gaps of the logs agree with the gaps as recorded and, after removal of the errors of the rig,
// with the held-out gap. Without hold-outs, the held-out gap is that of blocks outside the fit, which may be larger.
bool takenOutExplainsTheGaps(const Diagnosis& d) {
  const bool held_out = !all(d.logs.admission, [](const Admission& log) { return !log.hold_out; });
  std::vector<Admission> logs;
  std::copy_if(d.logs.admission.begin(), d.logs.admission.end(), std::back_inserter(logs),
               [&](const Admission& log) { return log.hold_out == held_out; });
  if (logs.empty() || d.samples.searched != d.samples.recorded || isInPieces(d)) {
    return true;  // a table was diagnosed, or only parts of the logs
  }
  const double recorded = std::sqrt(sumOf(logs, [](const Admission& log) { return log.recorded * log.recorded; }) /
                                    static_cast<double>(logs.size()));
  const auto [least, most] = std::minmax_element(
      logs.begin(), logs.end(), [](const Admission& a, const Admission& b) { return a.left < b.left; });
  return nearly(recorded, d.gap_as_recorded.augmented, kReplayed * d.gap_as_recorded.augmented + kRounding) &&
         least->left < (1.0 + kReplayed) * d.gaps.unseen.augmented &&
         (!held_out || d.gaps.unseen.augmented < (1.0 + kReplayed) * most->left);
}

bool whereIsOne(const Diagnosis& d) {
  return d.where.before.empty() ||
         nearly(sumOf(d.where.before, [](const gap::GapCell& cell) { return cell.share; }), 1.0);
}

bool whereAddsUp(const Diagnosis& d) {
  const auto isOf = [](const std::vector<gap::GapCell>& cells, double gap) {
    const double squared = sumOf(cells, [](const gap::GapCell& cell) { return cell.squared; });
    return cells.empty() || nearly(squared, gap * gap, kRounding * (1.0 + gap * gap));
  };
  return d.table || (isOf(d.where.before, d.gaps.unseen.as_configured) && isOf(d.where.after, d.gaps.unseen.augmented));
}

bool sharesAddUp(const Diagnosis& d) {
  return nearly(
      sumOf(d.shares, [](const auto& part) { return part.share; }),
      1.0 - d.gaps.unseen.augmented / std::max(d.gaps.unseen.as_configured, std::numeric_limits<double>::min()));
}

bool isWritten(const Diagnosis& d, const std::string& effect) {
  return std::count(d.law.added_for.begin(), d.law.added_for.end(), effect) > 0;
}

// Returns true if the written component has no larger residual than the configured one, on each log and on all logs
// together. Effects that would increase the residual are withheld.
bool fileLeavesNoMore(const Diagnosis& d) {
  const auto square = [](double gap) { return gap * gap; };
  const double pooled =
      sumOf(d.law.left_of_logs, [&](const LeftOfLog& log) { return square(log.written) - square(log.configured); });
  return pooled <= static_cast<double>(d.law.left_of_logs.size()) * results::asMuchAs() + kRounding &&
         all(d.law.left_of_logs,
             [&](const LeftOfLog& log) {
               return square(log.written) <= square(log.configured) + log.allowed + kRounding;
             }) &&
         all(d.law.withheld, [&](const Withheld& one) { return !isWritten(d, one.effect); });
}

// Returns true if the numbers of named effects come from the written law, and those of all others from full laws.
bool numbersAreOfTheFile(const Diagnosis& d) {
  return d.table || all(d.candidates, [&](const CandidateResult& c) {
           const bool named = std::count(d.answer.effects.begin(), d.answer.effects.end(), c.effect) > 0;
           return c.written == (named && isWritten(d, c.effect)) &&
                  (!c.written || (c.gap == d.gaps.unseen.augmented && c.closed == d.gaps.closed));
         });
}

bool eachEffectRemoves(const Diagnosis& d) {
  return d.table ||
         all(d.shares, [](const GapShare& part) { return part.by == "values" || part.squares_at_least > 0.0; });
}

bool surrogateIsThere(const Diagnosis& d) {
  return d.surrogate.has_value() == (leavesRest(d.answer.verdict) && !d.table);
}

struct Invariant {
  const char* name;
  bool (*holds)(const Diagnosis&);
};

// test/blind_trial/invariants.py, which checks report.json, uses the same names.
constexpr Invariant kInvariants[] = {
    {"effects are named if and only if the verdict names effects", verdictHasItsEffects},
    {"the probabilities add up to 1", posteriorIsOne},
    {"the verdict is the most probable explanation", verdictIsTheLikeliest},
    {"with the verdict unknown, no set of effects halves the residual", nothingHalvesTheUnknown},
    {"the probabilities of effects agree with the sets that contain them", candidatesAreOfTheSets},
    {"the first set in the list is the named set", firstSetIsNamed},
    {"no set contains an improbable effect", setsAreProbable},
    {"alternatives are sorted by probability", alternativesFollow},
    {"no other fit predicts unseen data better", noFitPredictsBetter},
    {"the noise floor is not above any gap", floorIsLeast},
    {"with the verdict named, the gap falls and its interval excludes 0, or the data sheet is right",
     whatIsNamedCloses},
    {"the share closed agrees with the gaps", closedIsOfTheGaps},
    {"the interval contains the share closed", intervalHoldsWhatIsClosed},
    {"the headline has the largest change", headlineIsTheLargest},
    {"an interval that ends at a bound is marked", boundsAreSaid},
    {"reasons agree with the gaps", reasonsAgree},
    {"the parts removed from the logs add up", takenOutAddsUp},
    {"the parts removed from the logs explain the gaps", takenOutExplainsTheGaps},
    {"the shares in `where` add up to 1", whereIsOne},
    {"the cells in `where` add up to the gap", whereAddsUp},
    {"shares add up to the removed part of the gap", sharesAddUp},
    {"the written file is not worse on any log", fileLeavesNoMore},
    {"the numbers of named effects equal the numbers in the written file", numbersAreOfTheFile},
    {"each named effect removes some of the gap", eachEffectRemoves},
    {"with the verdict unknown or partly, there is a surrogate", surrogateIsThere},
    {"there is a next experiment, or a reason for none", [](const Diagnosis& d) { return !d.next.text.empty(); }}};

Admission asRecorded(Admission log) {
  log.noise = log.recorded = log.left = kNotComputed;
  log.rating.reset();
  return log;
}

}  // namespace

std::vector<std::string> brokenInvariants(const Diagnosis& diagnosis) {
  std::vector<std::string> broken;
  for (const Invariant& invariant : kInvariants) {
    if (diagnosis.workings && !invariant.holds(diagnosis)) {  // without workings, nothing was judged
      broken.emplace_back(invariant.name);
    }
  }
  return broken;
}

Diagnosis heldToInvariants(Diagnosis diagnosis) {
  const std::vector<std::string> broken = brokenInvariants(diagnosis);
  if (broken.empty()) {
    return diagnosis;
  }
  Diagnosis told;  // contains what was recorded, but no result of the judgement
  told.component = diagnosis.component;
  told.turns = diagnosis.turns;
  told.configured = diagnosis.configured;
  told.answer.verdict = Verdict::defect;
  told.defect = fmt::format("{}", fmt::join(broken, "; "));
  told.sentence = fmt::format(
      "No verdict: this report would contradict itself ({}). This is a defect of rubber_suspension, not of the logs.",
      told.defect);
  told.next.text =
      "No experiment is proposed: please report the defect with report.json and evidence.json (option --evidence).";
  told.samples = diagnosis.samples;
  for (const Admission& log : diagnosis.logs.admission) {
    told.logs.admission.push_back(asRecorded(log));
  }
  if (diagnosis.table) {
    told.table = DiagnosedTable{diagnosis.table->name, {}, diagnosis.table->never_shown, diagnosis.table->notes};
  }
  told.workings = diagnosis.workings;  // for evidence.json
  return told;
}

}  // namespace rubber_suspension::diagnosis
