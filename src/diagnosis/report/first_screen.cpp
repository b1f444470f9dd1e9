// The part of the report that a reader sees first.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/page.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/sentence.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::report {
namespace {

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

// A number with its sign and side in words: "falls by 0.6 %/K", "31 N in compression".
std::string valueInWords(const Diagnosis& d, const SizedValue& size) {
  if (size.name.rfind("change_of_", 0) == 0) {
    return (size.value < 0.0 ? "falls by " : "rises by ") + words::quantity(std::abs(size.value), size.unit);
  }
  if (size.value < 0.0 && (size.unit == words::unitOf(d, "N") || size.unit == words::unitOf(d, "m"))) {
    return words::quantity(-size.value, size.unit) + " in compression";
  }
  return (size.value < 0.0 ? "minus " : "") + words::quantity(std::abs(size.value), size.unit);
}

// The numbers of the law, then those of the model that differ.
std::string lawTable(const Diagnosis& d) {
  std::vector<words::Row> rows = element::each(d.law.effect_sizes, [&](const SizedValue& size) -> words::Row {
    return {
        words::escape((d.answer.effects.size() > 1 ? words::spoken(size.owner) + ", " : "") + words::sizeName(size)),
        words::escape(valueInWords(d, size)), words::escape(words::intervalText(size))};
  });
  for (const SizedValue* size : words::changedValues(d)) {
    rows.push_back({words::escape(words::valueName(*size) + " of the model"),
                    words::escape(fmt::format("{}, not {}", words::quantity(size->value, size->unit),
                                              words::quantity(size->configured, size->unit))),
                    words::escape(words::intervalText(*size))});
  }
  constexpr std::size_t kMost = 10;
  const std::size_t more = rows.size() - std::min(rows.size(), kMost);
  rows.resize(rows.size() - more);
  const std::string whole = words::escape(words::wholeText(d));
  return (rows.empty() ? "" : words::table({"number", "value", "95 %"}, rows)) +
         (more == 0 ? "" : fmt::format("<p class=note>{} more are in the component file below.</p>\n", more)) +
         (whole.empty() ? "" : "<p class=note>" + whole + "</p>\n");
}

std::string takenOutHtml(const Diagnosis& d) { return lines(words::describeTakenOut(d.logs.taken_out), words::escape); }

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
  if (d.next.proposed.displacement.empty()) {
    return "";
  }
  return fmt::format(
      "play <a href=\"next_experiment.csv\">next_experiment.csv</a> ({:.3g} s at {:.4g} Hz; from rest at 0 to rest at "
      "0; as a drive file of RPC III <a href=\"next_experiment.drv\">next_experiment.drv</a>)",
      static_cast<double>(d.next.proposed.displacement.size() - 1) * d.next.proposed.dt, 1.0 / d.next.proposed.dt);
}

std::string firstScreen(const Diagnosis& d, const std::string& figures) {
  const std::string play = howToPlay(d);
  const std::string facts =
      fact("Verdict", fmt::format("<b>{}</b>: {}", toString(d.answer.verdict), meaningOf(d.answer.verdict))) +
      fact("What is wrong", benchHtml(d)) + fact("Taken out before, in % of the force", takenOutHtml(d)) +
      fact("Next experiment", words::escape(d.next.text) + (play.empty() ? "" : " To do so, " + play + "."));
  const std::string dl = "<dl>\n" + facts + "</dl>\n";
  const std::string pictures = d.workings && d.defect.empty() ? "<div>" + whereMaps(d) + lawTable(d) + "</div>\n<div>" +
                                                                    gapBars(d) + probabilityBars(d) + dl + "</div>\n"
                                                              : dl + figures;
  return fmt::format(
      "<p class=kicker>Gap report: {}{}</p>\n<h1>{}</h1>\n<p class=words>{}</p>\n<div class=first>\n{}"
      "</div>\n",
      words::escape(d.component), d.run.date.empty() ? "" : ", " + words::escape(d.run.date),
      words::escape(words::headline(d)), words::escape(d.sentence), pictures);
}

}  // namespace rubber_suspension::diagnosis::report
