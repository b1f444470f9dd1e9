// Writes the sentences of the report.
#include "diagnosis/words/sentence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::words {
namespace {

std::string setText(const std::vector<std::string>& set) { return fmt::format("{}", fmt::join(set, " + ")); }

// Returns sets of effects that cannot be distinguished, such as "friction; friction + creep".
std::string setsText(const std::vector<std::vector<std::string>>& sets) { return element::joined(sets, "; ", setText); }

// Returns a sentence on other answers that may be right, or an empty text if there are none.
std::string otherwise(const Diagnosis& diagnosis) {
  std::vector<std::string> texts;
  for (const Alternative& other : diagnosis.answer.alternatives) {
    const std::string what = other.verdict == Verdict::none              ? "no gap"
                             : other.verdict == Verdict::parameter_error ? "only wrong values of the model"
                             : other.verdict == Verdict::unknown         ? "something that is not in the list"
                                                                         : setText(other.effects);
    texts.push_back(fmt::format("{} ({} %)", what, chance(other.probability)));
  }
  return texts.empty() ? "" : " Also possible: " + enumerated(texts) + ".";
}

// Texts of the gap before and after a change, and of the noise. Up to three decimals distinguish before and after.
struct ChangeTexts {
  ChangeTexts(double from, double to, double floor) {
    int decimals = 1;
    while (decimals < 3 && percent(from, decimals) == percent(to, decimals)) {
      ++decimals;
    }
    before = percent(from, decimals);
    after = percent(to, decimals);
    noise = percent(floor, decimals);
  }

  std::string before;
  std::string after;
  std::string noise;
};

// Returns the named effects with their first numbers, such as "friction (maximum force 199 N, half of this force at
// 0.12 mm)". A number without a unit, such as a width, is included only if there is no other number before it.
std::string effectsText(const Diagnosis& diagnosis) {
  constexpr std::size_t kMost = 4;  // two stops have four numbers: a gap and a stiffness each
  std::vector<std::string> texts;
  for (const std::string& effect : diagnosis.answer.effects) {
    const Effect& known = effectNamed(effect);
    const std::string readings = known.readings == nullptr ? "" : known.readings(diagnosis.configured);
    std::vector<std::string> sizes;
    if (known.facts != nullptr) {
      sizes = known.facts(diagnosis.law.augmented.add);
    }
    for (const SizedValue& size : diagnosis.law.effect_sizes) {
      const bool tells = size.unit != "1" || sizes.empty();
      if (size.owner == effect && tells && !isAtBound(size) && sizes.size() < kMost) {
        sizes.push_back(sizeName(size) + " " + quantity(size.value, size.unit));
      }
    }
    const std::string inside =
        fmt::format("{}{}{}", readings, readings.empty() || sizes.empty() ? "" : ": ", fmt::join(sizes, ", "));
    texts.push_back(inside.empty() ? effect : fmt::format("{} ({})", effect, inside));
  }
  return enumerated(texts);
}

std::string ownValuesText(const Diagnosis& diagnosis) {
  const SizedValue* const value = headlineValue(diagnosis);
  return value == nullptr ? "The model's parameter values are wrong" : offText(*value);
}

bool isWithheld(const Diagnosis& diagnosis, const std::string& effect) {
  const auto& withheld = diagnosis.law.withheld;
  return std::any_of(withheld.begin(), withheld.end(), [&](const Withheld& one) { return one.effect == effect; });
}

bool writesAnEffect(const Diagnosis& diagnosis) { return !diagnosis.law.added_for.empty() || diagnosis.table; }

// Returns " Friction is not written: with it, the gap of the component file would be 3.10 % on log sweep, ...".
std::string withheldNote(const Diagnosis& diagnosis) {
  std::string note;
  for (const Withheld& one : diagnosis.law.withheld) {
    const bool values = one.effect == "values";
    note += fmt::format(
        " {} not written: with {}, the gap of the component file would be {} on {}, but it is {} as configured.",
        values ? "Other parameter values are" : capitalised(spoken(one.effect)) + " is", values ? "them" : "it",
        percent(one.after, 2), one.log == "all logs" ? one.log : "log " + one.log, percent(one.before, 2));
  }
  return note;
}

// Returns " A spectral line that the motion does not cause is removed: 50.0 Hz, ...", for the first log with a line.
std::string linesNote(const Diagnosis& diagnosis) {
  std::string note;
  std::string log;
  for (const measurement::RigFinding& finding : diagnosis.rig_findings) {
    if (finding.finding == measurement::finding::kLine && (log.empty() || finding.log == log)) {
      log = finding.log;
      note += fmt::format(" A spectral line that the motion does not cause is removed: {}.", finding.text);
    }
  }
  return note;
}

// " Log b has forces 10 % higher than the other logs.", for each gain beyond the rig's tolerance. If all logs have one,
// the text compares two groups of logs, because the logs do not show which of them is right.
std::string gainsNote(const Diagnosis& diagnosis) {
  std::vector<const measurement::RigFinding*> gains;
  for (const measurement::RigFinding& finding : diagnosis.rig_findings) {
    if (finding.finding == measurement::finding::kSensorGain && finding.beyond_tolerance) {
      gains.push_back(&finding);
    }
  }
  std::string note;
  if (gains.size() < 2 || gains.size() < diagnosis.logs.admission.size()) {
    for (const measurement::RigFinding* gain : gains) {
      note += fmt::format(" Log {} has forces {} % {} than the other logs.", gain->log,
                          wholePercent(std::abs(gain->value)), gain->value > 0.0 ? "higher" : "lower");
    }
    return note;
  }
  std::sort(gains.begin(), gains.end(), [](const auto* a, const auto* b) { return a->value < b->value; });
  std::size_t split = 1;  // split where neighbouring gains differ most
  for (std::size_t i = 1; i < gains.size(); ++i) {
    const auto step = [&](std::size_t at) { return gains[at]->value - gains[at - 1]->value; };
    split = step(i) > step(split) ? i : split;
  }
  const auto begin = gains.begin();
  const auto names = [](auto from, auto to) {
    return enumerated(element::each(std::vector<const measurement::RigFinding*>(from, to),
                                    [](const measurement::RigFinding* gain) { return gain->log; }));
  };
  const auto middle = begin + static_cast<std::ptrdiff_t>(split);
  const double more = (1.0 + (*middle)->value) / (1.0 + (*(middle - 1))->value) - 1.0;
  const bool one = middle + 1 == gains.end();
  return fmt::format(" {} {} {} forces {} % higher than {}; the logs do not determine which of them {} right.",
                     one ? "Log" : "Logs", names(middle, gains.end()), one ? "has" : "have", wholePercent(more),
                     names(begin, middle), gains.size() == 2 ? "is" : "are");
}

// Returns " All displacements are negative: ..." if the motion of the logs stays on one side of zero.
std::string oneSideNote(const Diagnosis& diagnosis) {
  constexpr double kSensorOffset = 0.05;  // share of the largest displacement; a smaller one is an offset of the sensor
  double above = 0.0;
  double below = 0.0;
  if (diagnosis.workings) {
    for (const log::Record& record : diagnosis.workings->simulated.records) {
      above = std::max(above, record.displacement.maxCoeff());
      below = std::max(below, -record.displacement.minCoeff());
    }
  }
  if (std::min(above, below) >= kSensorOffset * std::max(above, below)) {
    return "";
  }
  return fmt::format(" All displacements are {}: these logs do not determine the force at {} displacements.",
                     below > above ? "negative" : "positive", below > above ? "positive" : "negative");
}

// Returns ", 3.1 % on further logs" if there is a prediction for further logs.
std::string furtherText(const Diagnosis& diagnosis) {
  const double gap = diagnosis.gaps.further_log;
  return std::isfinite(gap) ? ", " + percent(gap) + " on further logs" : "";
}

// Returns possible answers with their probabilities, the most probable first. Returns an empty list if a named effect
// has a probability of one half or more.
std::vector<std::string> openTexts(const Diagnosis& diagnosis, std::size_t most) {
  constexpr double kMajority = 0.5;
  constexpr double kWorthSaying = 0.05;
  const auto named = [&](const CandidateResult& candidate) {
    const std::vector<std::string>& effects = diagnosis.answer.effects;
    return std::find(effects.begin(), effects.end(), candidate.effect) != effects.end();
  };
  const auto leads = [&](const CandidateResult& c) { return named(c) && c.probability >= kMajority; };
  std::vector<std::string> texts;
  if (diagnosis.candidates.empty() || std::any_of(diagnosis.candidates.begin(), diagnosis.candidates.end(), leads)) {
    return texts;
  }
  const Posterior& posterior = diagnosis.answer.posterior;
  std::vector<std::pair<double, std::string>> open = {
      {posterior.none, "nothing (model as configured)"},
      {posterior.parameter_error, "nothing (only its values are wrong)"},
      {posterior.none_of_these, "something that is not in the list"}};
  for (const CandidateResult& candidate : diagnosis.candidates) {
    open.emplace_back(candidate.probability, spoken(candidate.effect));
  }
  std::stable_sort(open.begin(), open.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [probability, what] : open) {
    if (texts.size() < most && probability >= kWorthSaying) {
      texts.push_back(fmt::format("{} ({} %)", what, chance(probability)));
    }
  }
  return texts;
}

// Returns the share of the gap as configured that the values remove: the first share in the list.
double shareOfValues(const Diagnosis& diagnosis) {
  return diagnosis.shares.empty() ? 0.0 : diagnosis.shares.front().share;
}

// Returns "of the gap as configured, friction removes 84 % and other parameter values remove 6 %".
std::string sharesText(const Diagnosis& diagnosis) {
  std::vector<std::string> texts;
  for (auto part = diagnosis.shares.rbegin(); part != diagnosis.shares.rend(); ++part) {
    const bool values = part->by == "values";
    if (isWithheld(diagnosis, part->by)) {
      continue;
    }
    texts.push_back(fmt::format("{} {}{} {} %", values ? "other parameter values" : part->by,
                                part->share < 0.0 ? "add" : "remove", values ? "" : "s",
                                wholePercent(std::abs(part->share))));
  }
  return texts.empty() ? "the component file removes nothing of the gap as configured"
                       : "of the gap as configured, " + enumerated(texts);
}

// Returns a text that begins with the values of the model if they remove more of the gap than all effects, and with the
// effects otherwise. The text ends with the share that each of them removes.
std::string withOwnValues(const Diagnosis& diagnosis, const std::string& effects) {
  const SizedValue* const value = headlineValue(diagnosis);
  double by_effects = 0.0;
  for (const GapShare& part : diagnosis.shares) {
    by_effects += part.by == "values" ? 0.0 : part.share;
  }
  const bool values_first = value != nullptr && shareOfValues(diagnosis) > by_effects;
  return (values_first ? offText(*value) + "; besides, " + effects : capitalised(effects)) + ": " +
         sharesText(diagnosis);
}

// Returns " Deviations in tolerances of the data sheet: K_st -1.2, ...", with deviations of at least half a tolerance.
std::string deviationsText(const Diagnosis& diagnosis) {
  constexpr double kWorthSaying = 0.5;
  std::vector<std::string> texts;
  for (const SheetDeviation& number : diagnosis.parameters.sheet_deviations) {
    if (std::abs(number.tolerances) >= kWorthSaying) {
      texts.push_back(fmt::format("{} {:+.1f}", symbolOf(number.name), number.tolerances));
    }
  }
  return texts.empty() || diagnosis.parameters.guess
             ? ""
             : fmt::format(" Deviations in tolerances of the data sheet: {}.", fmt::join(texts, ", "));
}

// Returns the identified values if the model is a guess, and the parameters at a bound of the fit.
std::string identifiedText(const Diagnosis& diagnosis) {
  std::string text;
  if (diagnosis.parameters.guess) {
    std::vector<std::string> values;
    for (const SizedValue& size : diagnosis.law.model_sizes) {
      if (size.owner != "specification" || estimation::isOfSheet(size.name)) {
        values.push_back(valueName(size) + " " + quantity(size.value, size.unit));
      }
    }
    text += fmt::format(" Identified values: {}.", fmt::join(values, ", "));
  }
  for (const std::string& name : diagnosis.parameters.at_bounds) {
    text +=
        fmt::format(" {} is at a bound of the fit: these logs do not determine this value.", capitalised(spoken(name)));
  }
  return text;
}

std::string remarkText(const Diagnosis& diagnosis) {
  const std::string& first = diagnosis.answer.effects.front();
  const auto found = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                  [&](const CandidateResult& candidate) { return candidate.effect == first; });
  const auto remark = effectNamed(first).remark;
  return remark == nullptr || found == diagnosis.candidates.end() ? "" : remark(found->parameters);
}

// Returns remarks on single effects that could explain the logs instead of wrong values.
std::string besideValuesText(const Diagnosis& diagnosis) {
  std::string text;
  for (const Alternative& other : diagnosis.answer.alternatives) {
    text += other.effects.size() == 1 ? effectNamed(other.effects.front()).beside_values : "";
  }
  return text;
}

// Returns " of the unseen logs" if the gaps were computed on held-out logs.
std::string ofUnseenLogs(const Diagnosis& diagnosis) {
  const bool any = std::any_of(diagnosis.logs.admission.begin(), diagnosis.logs.admission.end(),
                               [](const Admission& log) { return log.hold_out; });
  return any ? " of the unseen logs" : "";
}

std::string agreement(const Diagnosis& diagnosis) {
  const Gap& gap = diagnosis.gaps.unseen;
  return fmt::format("The model agrees with the measurement: gap {}{}, noise floor {}.", percent(gap.as_configured),
                     furtherText(diagnosis), percent(gap.noise_floor));
}

using experiment::NextExperiment;
using experiment::Proposal;
using experiment::WiderLimit;

std::string limitText(const Diagnosis& d, const NextExperiment& next) {
  switch (next.limit) {
    case WiderLimit::stroke:
      return "a stroke of " + quantity(next.wider.stroke.half, unitOf(d, "m"));
    case WiderLimit::speed:
      return fmt::format("{:.3g} Hz and a speed of {}", next.wider.frequency,
                         quantity(next.wider.speed, unitOf(d, "m/s")));
    default:
      return "a log of " + quantity(next.wider.duration, "s");
  }
}

std::string openText(double left, const NextExperiment& next) {
  return fmt::format("{:.2g} of {:.2g} bit", left, next.open);
}

std::string proposedText(const Diagnosis& d, const NextExperiment& next) {
  const std::string nearest =
      next.nearest.empty()
          ? ""
          : fmt::format("If {} is right, {} would be off by {} there after a refit. ", next.names.front(), next.nearest,
                        quantity(next.proposed.difference, unitOf(d, "N")));
  return fmt::format(
      "{}. It decides between {}. {}The entropy of these explanations is expected to fall to {}. Only the right one "
      "remains in {} % of cases.",
      inUnits(d, next.motion), enumerated(next.names), nearest, openText(next.open_after, next),
      chance(next.proposed.probability));
}

std::string noneText(const Diagnosis& d, const NextExperiment& next) {
  return fmt::format(
             "No motion within the limits decides: the entropy of the explanations {} would only fall to {}. The best "
             "motion is: {}. ",
             enumerated(next.names), openText(next.open_after, next), inUnits(d, next.motion)) +
         (next.proposal == Proposal::beyond_limits
              ? fmt::format("A better motion needs {}: {}; the entropy would then fall to {}.", limitText(d, next),
                            inUnits(d, next.wider_motion), openText(next.wider_open_after, next))
              : "Even twice the stroke, twice the speed or five times the duration would not be enough.");
}

std::string judgementText(const Diagnosis& diagnosis) {
  const Gap& gap = diagnosis.gaps.unseen;
  const std::string lacks = "the model lacks " + effectsText(diagnosis);
  const ChangeTexts closed(gap.re_estimated, gap.augmented, gap.noise_floor);
  const ChangeTexts moved(gap.as_configured, gap.re_estimated, gap.noise_floor);
  const std::string closes =
      !writesAnEffect(diagnosis)
          ? ""
          : fmt::format(
                " Adding {} removes {} % of the error that other parameter values cannot remove: gap {} to {}{}, noise "
                "{}.",
                diagnosis.answer.effects.size() == 1 ? "it" : "them", wholePercent(diagnosis.gaps.closed),
                closed.before, closed.after, furtherText(diagnosis), closed.noise);
  const std::string values = deviationsText(diagnosis) + identifiedText(diagnosis);
  constexpr std::size_t kMost = 5;
  const std::vector<std::string> open =
      diagnosis.answer.effects.empty() ? std::vector<std::string>{} : openTexts(diagnosis, kMost);
  if (!open.empty()) {
    return fmt::format("The missing effect is uncertain with {}; possible: {}. The component file contains {}: {}.",
                       sourceOf(diagnosis), enumerated(open),
                       writesAnEffect(diagnosis) ? effectsText(diagnosis) : "no such effect", sharesText(diagnosis)) +
           closes + values + remarkText(diagnosis);
  }
  switch (diagnosis.answer.verdict) {
    case Verdict::none:
      return agreement(diagnosis);
    case Verdict::parameter_error:
      return fmt::format(
          "{}: other parameter values remove {} % of the gap as configured, from {} to {}{} (noise {}).{}{}",
          diagnosis.parameters.guess ? "The data sheet is a guess" : ownValuesText(diagnosis),
          wholePercent(shareOfValues(diagnosis)), moved.before, moved.after, furtherText(diagnosis), moved.noise,
          values, otherwise(diagnosis) + besideValuesText(diagnosis));
    case Verdict::named:
      return withOwnValues(diagnosis, lacks) + "." + closes + values + remarkText(diagnosis);
    case Verdict::confounded:
      return withOwnValues(diagnosis, "most probably " + lacks) + "." + closes + " " +
             capitalised(sourceOf(diagnosis)) + " cannot tell apart: " + setsText(diagnosis.answer.confounded) + "." +
             values + remarkText(diagnosis);
    case Verdict::partly:
      return withOwnValues(diagnosis, lacks + ", and something else") + "." + closes + values +
             " No effect of the list explains the rest.";
    default:
      return fmt::format(
          "No effect of the list explains the gap of {}{}{} (noise {}).{} Do not trust the model where that gap lies.",
          percent(gap.re_estimated), ofUnseenLogs(diagnosis), furtherText(diagnosis), percent(gap.noise_floor), values);
  }
}

}  // namespace

std::string sentence(const Diagnosis& diagnosis) {
  return judgementText(diagnosis) + withheldNote(diagnosis) + gainsNote(diagnosis) + linesNote(diagnosis) +
         oneSideNote(diagnosis);
}

std::string headline(const Diagnosis& diagnosis) {
  const Gap& gap = diagnosis.gaps.unseen;
  const std::string effects = enumerated(element::each(diagnosis.answer.effects, spoken));
  const ChangeTexts closed(gap.re_estimated, gap.augmented, gap.noise_floor);
  const std::string falls = fmt::format(": gap {} to {}{}.", closed.before, closed.after, furtherText(diagnosis));
  constexpr std::size_t kMost = 3;
  const std::vector<std::string> open =
      diagnosis.answer.effects.empty() ? std::vector<std::string>{} : openTexts(diagnosis, kMost);
  if (!open.empty()) {
    return "It remains open what the model lacks: " + fmt::format("{}", fmt::join(open, ", ")) + "; " + falls.substr(2);
  }
  switch (diagnosis.answer.verdict) {
    case Verdict::none:
      return agreement(diagnosis);
    case Verdict::parameter_error: {
      const ChangeTexts moved(gap.as_configured, gap.re_estimated, gap.noise_floor);
      return fmt::format("{}: other parameter values lower the gap from {} to {}{}, noise {}.",
                         diagnosis.parameters.guess ? "The data sheet is a guess" : "Values of the model are wrong",
                         moved.before, moved.after, furtherText(diagnosis), moved.noise);
    }
    case Verdict::named:
      return (headlineValue(diagnosis) == nullptr ? "The model lacks " : "Besides wrong values, the model lacks ") +
             effects + falls;
    case Verdict::confounded:
      return "Most probably the model lacks " + effects + falls;
    case Verdict::partly:
      return "The model lacks " + effects + " and something else" + falls;
    case Verdict::check_bench:
      return diagnosis.rig_findings.empty()
                 ? "Check the bench."
                 : fmt::format("Check the bench: {} in log {}.", spoken(diagnosis.rig_findings.front().finding),
                               diagnosis.rig_findings.front().log);
    case Verdict::defect:
      return "This report contradicts itself and gives no verdict.";
    default:
      return fmt::format("No effect of the list explains the gap of {}{}, noise {}.", percent(gap.re_estimated),
                         furtherText(diagnosis), percent(gap.noise_floor));
  }
}

std::string temperatureNote(const std::vector<std::string>& effects, const fit::Excitation& excitation) {
  const std::vector<std::string> doubtful =
      element::those(effects, [](const std::string& effect) { return effectNamed(effect).falls_like_warming; });
  if (excitation.has_temperature || doubtful.empty()) {
    return "";
  }
  return fmt::format(
      " Without a recorded temperature {} is not certain: rubber that was warmed from outside would look the same. "
      "Logs with the column temperature_degC would decide.",
      fmt::join(doubtful, " and "));
}

std::string restNote(const Surrogate& surrogate) {
  constexpr double kLeastPart = 0.01;  // share of the squared residual; a smaller share is not reported
  const std::string prediction = fmt::format(
      "a surrogate predicts {:.0f} % of the rest in parts of the logs that were not used in its fit (gap {:.1f} % "
      "without, {:.1f} % with the surrogate)",
      100.0 * surrogate.share, 100.0 * surrogate.unseen_before, 100.0 * surrogate.unseen_after);
  if (surrogate.function_of_the_motion) {
    return " The rest depends on the motion by a law that is not in the list: " + prediction + ".";
  }
  if (surrogate.beyond_chance && surrogate.share >= kLeastPart) {
    return " Only part of the rest depends on the motion: " + prediction +
           ". The other part needs other logs, or is not caused by the motion (hum, cross-talk, a loose plug).";
  }
  return " No surrogate predicts the rest in parts of the logs that were not used in its fit: these logs do not show "
         "whether the motion causes the rest.";
}

std::string factorNote(const std::vector<double>& factors) {
  const auto texts = element::each(factors, [](double factor) { return fmt::format("{:.2f}", factor); });
  return factors.empty() ? ""
                         : fmt::format(
                               " Friction differs between the logs: in the order of the logs, it is {} times the "
                               "friction of the component file. Pressure, current or tension changed between the logs.",
                               enumerated(texts));
}

std::string excludedNote(const Diagnosis& diagnosis) {
  constexpr double kWorthSaying = 0.02;
  std::string note;
  for (const bool by_file : {true, false}) {
    std::vector<std::string> texts;
    for (const ExcludedEffect& one : diagnosis.answer.excluded) {
      const auto& of_file = diagnosis.configured.excluded_effects;
      const bool in_file = std::find(of_file.begin(), of_file.end(), one.effect) != of_file.end();
      if (in_file == by_file && one.probability_otherwise >= kWorthSaying) {
        texts.push_back(
            fmt::format("the probability of {} would be {} %", one.effect, chance(one.probability_otherwise)));
      }
    }
    if (!texts.empty()) {
      note += fmt::format(" Effects excluded by {}: without this exclusion, {}.",
                          by_file ? "the component file" : "--exclude", enumerated(texts));
    }
  }
  return note;
}

std::string experimentText(const Diagnosis& d, const NextExperiment& next) {
  switch (next.proposal) {
    case Proposal::agrees:
      return "No further experiment is needed: the model agrees with the measurement as far as these logs can show.";
    case Proposal::sure:
      return fmt::format("No further experiment is needed: the verdict has a probability of {} %.",
                         chance(d.answer.probability));
    case Proposal::no_rival:
      return "No experiment is proposed: no second explanation was fitted.";
    case Proposal::same_effects:
      return fmt::format("No experiment is proposed: the explanations {} name the same effects.",
                         enumerated(next.names));
    case Proposal::no_motion:
      return "No experiment is proposed: every available motion exceeds the limits of stroke, speed, force and "
             "duration.";
    case Proposal::within_limits:
      return proposedText(d, next);
    default:
      return noneText(d, next);
  }
}

}  // namespace rubber_suspension::diagnosis::words
