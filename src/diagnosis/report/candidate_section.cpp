// Which effects were weighed.
#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/page.h"
#include "diagnosis/words/headline.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kLikely = 0.01;  // less probable ones are folded

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool isNamed(const Diagnosis& d, const CandidateResult& candidate) { return contains(d.effects, candidate.effect); }

std::string parametersText(const CandidateResult& candidate) {
  return element::joined(headlineValuesOf(candidate.add), ", ", [](const HeadlineValue& value) {
    return spoken(value.name) + " " + quantity(value.value, value.unit);
  });
}

std::string closedText(const CandidateResult& c) {
  return fmt::format("{} % ({} to {} %)", wholePercent(c.closed), wholePercent(std::min(1.0, c.interval[0])),
                     wholePercent(std::min(1.0, c.interval[1])));
}

Row rowOf(const Diagnosis& d, const CandidateResult& c) {
  return {fmt::format("<b>{}</b><br><span class=note>{}{}</span>", escape(c.effect), escape(c.documentation),
                      c.on_rig ? " (on the rig, not in the rubber)" : ""),
          chance(c.probability) + " %", percent(c.gap), closedText(c),
          escape(isNamed(d, c) ? parametersText(c) : whyOut(d, c))};
}

std::string notTestable(const Diagnosis& d) {
  const auto hidden = element::those(d.candidates, [](const CandidateResult& c) { return !c.testable; });
  const auto names = element::each(hidden, [](const CandidateResult& c) { return spoken(c.effect); });
  return names.empty() ? "Every candidate would show in " + sourceOf(d) + "."
                       : "A typical " + enumerated(names) + " would not show in " + sourceOf(d) +
                             ", so whether it is there stays open.";
}

const char* const kProbability =
    "The probability of an effect is the sum over all sets of effects that contain it. It rests on cases of known "
    "cause; docs/accuracy.md says how often a stated probability is right.";

}  // namespace

std::string whyOut(const Diagnosis& d, const CandidateResult& c) {
  if (isNamed(d, c)) {
    return "";
  }
  if (d.table && contains(d.table->never_shown, c.effect)) {
    return "no table of settled loops shows it: record a log";
  }
  if (!c.testable) {
    return fmt::format("not testable with {}: other parameter values leave {} % of a typical one, too little to see",
                       sourceOf(d), wholePercent(c.visible_share));
  }
  if (c.interval[0] <= 0.0) {
    return "on further logs it may remove nothing";
  }
  if (d.effects.empty()) {
    return fmt::format("leaves {} of the {} that re-estimation leaves", percent(c.gap), percent(d.gap.re_estimated));
  }
  return c.gap > d.gap.augmented
             ? fmt::format("leaves {}, where what is named leaves {}", percent(c.gap), percent(d.gap.augmented))
             : fmt::format("leaves {}, no more than what is named, and is less probable", percent(c.gap));
}

std::string candidateSection(const Diagnosis& d) {
  const Row titles = {"effect", "#probability", "#gap with it alone", "#removes (95 %)", "parameters, or why out"};
  std::vector<Row> shown;
  std::vector<Row> rest;
  for (const CandidateResult& c : d.candidates) {
    (c.probability >= kLikely || isNamed(d, c) ? shown : rest).push_back(rowOf(d, c));
  }
  std::string html = shown.empty() ? "<p>No candidate reaches a probability of 1 %.</p>\n" : table(titles, shown);
  html += fmt::format(
      "<p>No gap: {} %. Wrong values of the model alone: {} %. None of these: {} %. All candidates at once, as a "
      "flexible fit without claim to a cause, "
      "would leave a gap of {} on parts of {} held out.</p>\n",
      chance(d.posterior.none), chance(d.posterior.parameter_error), chance(d.posterior.none_of_these),
      percent(d.workings->search.surrogate_gap), sourceOf(d));
  html += fmt::format("<p class=note>{}</p>\n<p>{}</p>\n", kProbability, escape(notTestable(d)));
  const std::string title = fmt::format("{} candidates below 1 %, and why they are out", rest.size());
  return rest.empty() ? html : html + folded(title, table(titles, rest));
}

}  // namespace rubber_suspension::diagnosis
