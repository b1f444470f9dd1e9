// Sentences of the report.
#include "diagnosis/report/sentence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "diagnosis/report/text.h"
#include "diagnosis/results/model_values.h"

namespace rubber_suspension::diagnosis {
namespace {

std::string setText(const std::vector<std::string>& set) { return fmt::format("{}", fmt::join(set, " + ")); }

// "friction; friction + creep": sets that cannot be told apart.
std::string setsText(const std::vector<std::vector<std::string>>& sets) {
  std::vector<std::string> texts;
  std::transform(sets.begin(), sets.end(), std::back_inserter(texts), setText);
  return fmt::format("{}", fmt::join(texts, "; "));
}

// What else may be right, where there is anything.
std::string otherwise(const Diagnosis& diagnosis) {
  std::vector<std::string> texts;
  for (const Alternative& other : diagnosis.alternatives) {
    const std::string what = other.verdict == Verdict::none              ? "no gap"
                             : other.verdict == Verdict::parameter_error ? "wrong values of the model alone"
                             : other.verdict == Verdict::unknown         ? "something that is not in the list"
                                                                         : setText(other.effects);
    texts.push_back(fmt::format("{} ({} %)", what, chance(other.probability)));
  }
  return texts.empty() ? "" : " It may also be " + enumerated(texts) + ".";
}

std::string gapText(double gap) { return fmt::format("{:.1f} %", 100.0 * gap); }

// "friction (maximum force 199 N)" and the like, each with its first number.
std::string effectsText(const Diagnosis& diagnosis) {
  std::vector<std::string> texts;
  for (const std::string& effect : diagnosis.effects) {
    const auto size = std::find_if(diagnosis.effect_sizes.begin(), diagnosis.effect_sizes.end(),
                                   [&](const SizedValue& value) { return value.owner == effect; });
    texts.push_back(size == diagnosis.effect_sizes.end()
                        ? effect
                        : fmt::format("{} ({} {})", effect, spoken(size->name), quantity(size->value, size->unit)));
  }
  return enumerated(texts);
}

std::string ownValuesText(const Diagnosis& diagnosis) {
  const auto changed = changedValues(diagnosis);
  return changed.empty() ? "The model's parameters are off" : offText(*changed.front());
}

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

// The largest fact first: the model's own values, where these alone close most of the squared gap that is closed and
// more than the effects alone do; else the effects. Otherwise they only make room for the effects.
std::string withOwnValues(const Diagnosis& diagnosis, const std::string& effects) {
  const auto changed = changedValues(diagnosis);
  if (changed.empty()) {
    return capitalised(effects);
  }
  const auto closes = [&](double gap) { return std::pow(diagnosis.gap.as_configured, 2) - std::pow(gap, 2); };
  const bool values_first = closes(diagnosis.gap_of_values) > 0.5 * closes(diagnosis.gap.augmented) &&
                            closes(diagnosis.gap_of_values) > closes(diagnosis.gap_of_effects);
  return values_first ? offText(*changed.front()) + "; besides, " + effects
                      : capitalised(effects) + "; with that, " + besideText(*changed.front());
}

// The gain of the force channel, where that is named: values of the model may be off by as much.
std::string gainText(const Diagnosis& diagnosis) {
  for (const CandidateResult& candidate : diagnosis.candidates) {
    const auto gain = candidate.parameters.find("gain");
    if (gain != candidate.parameters.end() && candidate.effect == diagnosis.effects.front()) {
      return fmt::format(
          " The force channel reads {:.1f} % too {}, or all stiffnesses and damping of the model are off by as much: a "
          "known weight on the load cell tells.",
          100.0 * std::abs(gain->second), gain->second > 0.0 ? "much" : "little");
    }
  }
  return "";
}

std::string agreement(const Gap& gap) {
  return fmt::format("The model agrees with the measurement: gap {}, noise floor {}.", gapText(gap.as_configured),
                     gapText(gap.noise_floor));
}

}  // namespace

std::string sentence(const Diagnosis& diagnosis) {
  const Gap& gap = diagnosis.gap;
  const std::string lacks = "the model lacks " + effectsText(diagnosis);
  const std::string closes =
      fmt::format("adding {} closes {} % of what re-estimation leaves (gap {} to {}, noise floor {})",
                  diagnosis.effects.size() == 1 ? "it" : "them", wholePercent(diagnosis.closed),
                  gapText(gap.re_estimated), gapText(gap.augmented), gapText(gap.noise_floor));
  switch (diagnosis.verdict) {
    case Verdict::none:
      return agreement(gap);
    case Verdict::parameter_error:
      return fmt::format("{}: re-estimating reduces the gap from {} to {} (noise floor {}).{}",
                         ownValuesText(diagnosis), gapText(gap.as_configured), gapText(gap.re_estimated),
                         gapText(gap.noise_floor), otherwise(diagnosis));
    case Verdict::named:
      return withOwnValues(diagnosis, fmt::format("{}: {}", lacks, closes)) + "." + gainText(diagnosis);
    case Verdict::confounded:
      return withOwnValues(diagnosis, fmt::format("most probably {}: {}", lacks, closes)) + ". " +
             capitalised(sourceOf(diagnosis)) + " cannot tell apart: " + setsText(diagnosis.confounded) + "." +
             gainText(diagnosis);
    case Verdict::partly:
      return withOwnValues(diagnosis, fmt::format("{}, and something else: {}; a significant part of the gap remains "
                                                  "unexplained",
                                                  lacks, closes)) +
             ".";
    default:
      return fmt::format(
          "The gap of {} is real (noise floor {}) and no effect of the list explains it: see where it lies before you "
          "trust the model there.",
          gapText(gap.re_estimated), gapText(gap.noise_floor));
  }
}

}  // namespace rubber_suspension::diagnosis
