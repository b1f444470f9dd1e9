// The part of the report that a reader sees first.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/page.h"
#include "diagnosis/results/taken_out.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::report {
namespace {

using words::percent;
using words::wholePercent;

std::string meaningOf(Verdict verdict) {
  static const std::map<Verdict, std::string> meanings = {
      {Verdict::none, "no gap beyond the noise"},
      {Verdict::parameter_error, "the model's own values are off; nothing is missing"},
      {Verdict::named, "the model lacks what is named here"},
      {Verdict::partly, "the model lacks what is named here, and something else"},
      {Verdict::confounded, "several sets of effects cannot be told apart here"},
      {Verdict::unknown, "no effect of the list explains the gap"},
      {Verdict::check_bench, "a log cannot be what it says"},
      {Verdict::defect, "none is told"}};
  return meanings.at(verdict);
}

std::string fact(const std::string& title, const std::string& html) {
  return html.empty() ? "" : "<dt>" + title + "</dt><dd>" + html + "</dd>\n";
}

// A line of the page for each.
template <class List, class Function>
std::string lines(const List& list, const Function& html) {
  return element::joined(list, "<br>", html);
}

const CandidateResult* candidateOf(const Diagnosis& d, const std::string& effect) {
  const auto found = std::find_if(d.candidates.begin(), d.candidates.end(),
                                  [&](const CandidateResult& c) { return c.effect == effect; });
  return found == d.candidates.end() ? nullptr : &*found;
}

std::string effectsHtml(const Diagnosis& d) {
  const auto text = [&](const std::string& effect) {
    const CandidateResult* const candidate = candidateOf(d, effect);
    return "<b>" + words::escape(words::spoken(effect)) + "</b>" +
           (candidate == nullptr ? "" : " <span class=note>" + words::escape(candidate->documentation) + "</span>");
  };
  return d.effects.empty() && d.workings ? "none of the list is named" : lines(d.effects, text);
}

std::string sizesHtml(const Diagnosis& d) {
  std::vector<std::string> texts = element::each(d.effect_sizes, [&](const SizedValue& size) {
    return fmt::format("{}{} {}", d.effects.size() > 1 ? words::escape(words::spoken(size.owner)) + ": " : "",
                       words::escape(words::sizeName(size)), words::quantity(size));
  });
  for (const SizedValue* size : words::changedValues(d)) {
    texts.push_back(words::escape(d.effects.empty() ? words::offText(*size) : words::besideText(*size)) +
                    "; 95 %: " + words::intervalText(*size));
  }
  if (const std::string whole = words::escape(words::wholeText(d)); !whole.empty()) {
    texts.push_back(whole);
  }
  return fmt::format("{}", fmt::join(texts, "<br>"));
}

std::string sureHtml(const Diagnosis& d) {
  if (!d.workings) {
    return "";
  }
  if (d.verdict == Verdict::unknown) {
    return fmt::format("{} % that it is no effect of the list", words::chance(d.posterior.none_of_these));
  }
  if (d.effects.empty()) {
    const double above = d.gap.as_configured - d.gap.noise_floor;
    return d.verdict != Verdict::parameter_error || !(above > 0.0)
               ? ""
               : fmt::format("the values alone close {} % of the gap above the noise",
                             wholePercent(std::min(1.0, (d.gap.as_configured - d.gap.re_estimated) / above)));
  }
  std::string html;
  if (const CandidateResult* const first = candidateOf(d, d.effects.front()); first != nullptr) {
    html = fmt::format("{} % that {} is at work", words::chance(first->probability),
                       words::escape(words::spoken(first->effect)));
  }
  if (d.confounded.size() > 1) {
    const auto sets =
        element::each(d.confounded, [](const auto& set) { return fmt::format("{}", fmt::join(set, " + ")); });
    html += "<br>not to be told apart here: " + words::escape(words::enumerated(sets));
  }
  return html;
}

std::string leftHtml(const Diagnosis& d) {
  if (!d.workings) {
    return "";
  }
  std::string html = fmt::format("gap {} as configured, {} re-estimated, <b>{} after</b>; noise floor {}",
                                 percent(d.gap.as_configured), percent(d.gap.re_estimated), percent(d.gap.augmented),
                                 percent(d.gap.noise_floor));
  html += d.effects.empty() ? "" : fmt::format("; {} with the law as judged", percent(d.gap_of_full_law));
  if (!d.effects.empty()) {
    html += fmt::format(
        "<br>removes {} % (95 % on further logs: {} to {} %) of the error that other parameter values "
        "cannot remove",
        wholePercent(d.closed), wholePercent(std::min(1.0, d.closed_interval[0])),
        wholePercent(std::min(1.0, d.closed_interval[1])));
  }
  return html;
}

std::string takenOutHtml(const Diagnosis& d) { return lines(results::describeTakenOut(d.taken_out), words::escape); }

std::string whereHtml(const Diagnosis& d) {
  if (d.where.empty()) {
    return "";
  }
  const gap::GapCell& cell = d.where.front();
  const std::string band = cell.frequency[0] > 0.0 ? fmt::format(", {} Hz", words::rangeText(cell.frequency, 1.0)) : "";
  return fmt::format("largest in {}<b>{}</b>{}, {} mm: <b>{}</b>, {} % of the squared gap as configured",
                     d.table ? "table " : "", words::escape(cell.log), band, words::rangeText(cell.amplitude, 1e3),
                     gap::toString(cell.quantity), wholePercent(cell.share));
}

std::string benchHtml(const Diagnosis& d) {
  const auto fatal = element::those(d.rig_findings, &measurement::RigFinding::fatal);
  return lines(fatal, [](const measurement::RigFinding& finding) {
    const FindingAdvice& advice = adviceOn(finding.finding);
    return fmt::format("<b>{}</b>, log {}: {} <b>At the bench:</b> {}", words::escape(words::spoken(finding.finding)),
                       words::escape(finding.log), words::escape(advice.meaning), words::escape(advice.remedy));
  });
}

}  // namespace

std::string howToPlay(const Diagnosis& d) {
  if (d.proposed.displacement.empty()) {
    return "";
  }
  return fmt::format(
      "play <a href=\"next_experiment.csv\">next_experiment.csv</a> ({:.3g} s at {:.4g} Hz; from rest at 0 to rest at "
      "0; as a drive file of RPC III <a href=\"next_experiment.drv\">next_experiment.drv</a>)",
      static_cast<double>(d.proposed.displacement.size() - 1) * d.proposed.dt, 1.0 / d.proposed.dt);
}

std::string firstScreen(const Diagnosis& d, const std::string& loop) {
  const std::string play = howToPlay(d);
  const std::string facts =
      fact("Verdict", fmt::format("<b>{}</b>: {}", toString(d.verdict), meaningOf(d.verdict))) +
      fact("What is wrong", benchHtml(d)) + fact("Which", effectsHtml(d)) + fact("How large", sizesHtml(d)) +
      fact("How sure", sureHtml(d)) + fact("What is left", leftHtml(d)) +
      fact("Taken out before, in % of the force", takenOutHtml(d)) + fact("Where", whereHtml(d)) +
      fact("Next experiment", words::escape(d.next_experiment) + (play.empty() ? "" : " To do so, " + play + "."));
  return fmt::format("<p class=kicker>Gap report: {}{}</p>\n<h1>{}</h1>\n<div class=first>\n<dl>\n{}</dl>\n{}</div>\n",
                     words::escape(d.component), d.run.date.empty() ? "" : ", " + words::escape(d.run.date),
                     words::escape(d.sentence), facts, loop);
}

}  // namespace rubber_suspension::diagnosis::report
