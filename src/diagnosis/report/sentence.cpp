// Sentences of the report.
#include "diagnosis/report/sentence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/criteria.h"
#include "diagnosis/report/text.h"
#include "diagnosis/results/model_values.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

std::string setsText(const std::vector<std::vector<std::string>>& sets) {
  std::string text;
  for (const auto& set : sets) {
    if (set.size() > 1) {
      text += (text.empty() ? "" : "; ") + fmt::format("{}", fmt::join(set, ", "));
    }
  }
  return text;
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

// One factor on the force, which all values of the model may be off by as well.
std::string gainSentence(const Diagnosis& diagnosis, double gain) {
  return fmt::format(
      "The force channel reads {:.1f} % too {}, or all stiffnesses and damping of the model are off by as much: {} "
      "cannot tell apart sensor_gain and parameter_error. Either reduces the gap from {} to {} (noise floor {}).",
      100.0 * std::abs(gain), gain > 0.0 ? "much" : "little", sourceOf(diagnosis), gapText(diagnosis.gap.as_configured),
      gapText(diagnosis.gap.augmented), gapText(diagnosis.gap.noise_floor));
}

std::string unknownSentence(const Judgement& judgement, const Gap& gap) {
  if (judgement.only_unseen_logs_differ) {
    return fmt::format(
        "The logs of the fit confirm the model, the unseen ones do not (gap {}, noise floor {}): they show something "
        "that the logs of the fit do not. Fit logs that cover the same range.",
        gapText(gap.augmented), gapText(gap.noise_floor));
  }
  return fmt::format(
      "The gap of {} is real (noise floor {}) and no effect of the list explains it: see where it lies before you "
      "trust the model there.",
      gapText(gap.re_estimated), gapText(gap.noise_floor));
}

const CandidateResult* gainOf(const Diagnosis& diagnosis) {
  const auto found =
      std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                   [](const CandidateResult& candidate) { return candidate.parameters.count("gain") != 0; });
  return found == diagnosis.candidates.end() ? nullptr : &*found;
}

// Where one factor on all forces does as well as wrong values, and who reads may know the load cell better.
std::string gainWouldDo(const Diagnosis& diagnosis) {
  constexpr double kAsWell = 1.05;  // of what they leave, which is known to some percent
  const CandidateResult* gain = gainOf(diagnosis);
  return gain != nullptr && gain->gap <= kAsWell * diagnosis.gap.re_estimated
             ? fmt::format(
                   " So would a force channel that reads {:.1f} % too {}, which is less likely: its calibration tells.",
                   100.0 * std::abs(gain->parameters.at("gain")), gain->parameters.at("gain") > 0.0 ? "much" : "little")
             : "";
}

// What of a gap without a cause is told: at the floor, or above it and small enough to be accepted.
std::string agreementSentence(const Gap& gap) {
  constexpr double kAt = 1.3;  // times the floor, which is known to this factor (docs/accuracy.md)
  const double above = gap::residualAboveFloor(gap.as_configured, gap.noise_floor);
  if (gap.as_configured <= kAt * gap.noise_floor) {
    return fmt::format("The model agrees with the measurement: the gap of {} is at the noise floor of {}.",
                       gapText(gap.as_configured), gapText(gap.noise_floor));
  }
  return fmt::format(
      "The model agrees with the measurement within what is accepted: of the gap of {}, {} of the force are above the "
      "noise floor of {}; up to {} count as none where no effect explains them.",
      gapText(gap.as_configured), gapText(above), gapText(gap.noise_floor),
      gapText(Criteria{}.beyondNoise(gap.noise_floor)));
}

}  // namespace

std::string sentence(const Judgement& judgement, const Diagnosis& diagnosis) {
  const Gap& gap = diagnosis.gap;
  const std::string lacks = "the model lacks " + effectsText(diagnosis);
  const std::string closes =
      fmt::format("adding {} closes {} % of what re-estimation leaves (gap {} to {}, noise floor {})",
                  diagnosis.effects.size() == 1 ? "it" : "them", wholePercent(diagnosis.closed),
                  gapText(gap.re_estimated), gapText(gap.augmented), gapText(gap.noise_floor));
  switch (judgement.verdict) {
    case Verdict::none:
      return agreementSentence(gap);
    case Verdict::parameter_error:
      return fmt::format("{}: re-estimating reduces the gap from {} to {} (noise floor {}).{}",
                         ownValuesText(diagnosis), gapText(gap.as_configured), gapText(gap.re_estimated),
                         gapText(gap.noise_floor), gainWouldDo(diagnosis));
    case Verdict::named:
      return withOwnValues(diagnosis, fmt::format("{}: {}", lacks, closes)) + ".";
    case Verdict::confounded:
      if (const CandidateResult* gain = gainOf(diagnosis);
          gain != nullptr && gain->effect == diagnosis.effects.front()) {
        return gainSentence(diagnosis, gain->parameters.at("gain"));
      }
      return withOwnValues(diagnosis, fmt::format("most probably {}: {}", lacks, closes)) + ". " +
             capitalised(sourceOf(diagnosis)) + " cannot tell apart: " + setsText(diagnosis.confounded) + ".";
    case Verdict::partly:
      return withOwnValues(diagnosis, fmt::format("{}, and something else: {}; a significant part of the gap remains "
                                                  "unexplained",
                                                  lacks, closes)) +
             ".";
    default:
      return unknownSentence(judgement, gap);
  }
}

}  // namespace rubber_suspension::diagnosis
