// The report for engineers: report.html, one page without scripts or network.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "diagnosis/report/report_figures.h"
#include "diagnosis/workings.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {
namespace {

const char* const kStyle = R"(
:root { color-scheme: light dark; --bar: #2a78b8; --line: #8884; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
.verdict { font-size: 1.2rem; border-left: .4rem solid var(--bar); padding: .4rem 1rem; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; }
th, td { text-align: left; padding: .25rem .6rem; border-bottom: 1px solid var(--line); vertical-align: top; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
td.n { white-space: nowrap; }
.bar { display: inline-block; height: .7rem; background: var(--bar); vertical-align: middle; }
.note { opacity: .75; font-size: .92rem; }
figure { margin: 1.5rem 0; break-inside: avoid; }
svg { max-width: 100%; height: auto; }
pre { overflow-x: auto; background: #8882; padding: .8rem; font-size: .85rem; }
)";

std::string escape(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string join(const std::vector<std::string>& parts) {
  std::string result;
  for (const std::string& part : parts) {
    result += (result.empty() ? "" : ", ") + part;
  }
  return result;
}

std::string percent(double value) { return fmt::format("{:.1f} %", 100.0 * value); }

// In whole per cent, without a minus before 0.
std::string wholePercent(double value) { return fmt::format("{:.0f}", std::round(100.0 * value) + 0.0); }

std::string gapTable(const Diagnosis& d) {
  const double widest = std::max({d.gap.as_configured, d.gap.re_estimated, d.gap.augmented, 1e-12});
  std::string rows;
  const auto row = [&](const std::string& name, double value, const std::string& meaning) {
    rows += fmt::format(
        "<tr><td>{}</td><td class=n>{}</td><td><span class=bar "
        "style=\"width:{:.1f}rem\"></span></td><td>{}</td></tr>\n",
        name, percent(value), 14.0 * value / widest, meaning);
  };
  row("as configured", d.gap.as_configured, "the component file as it is");
  row("re-estimated", d.gap.re_estimated, "model parameters fitted to the logs");
  row("augmented", d.gap.augmented, "with the named effects added");
  row("noise floor", d.gap.noise_floor, escape(d.noise_source));
  return "<table><tr><th>model</th><th class=n>gap</th><th></th><th></th></tr>\n" + rows + "</table>\n";
}

std::string parametersText(const CandidateResult& candidate) {
  std::string text;
  for (const auto& [name, value] : candidate.parameters) {
    text += fmt::format("{}{} = {:.4g}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

std::string candidateTable(const Diagnosis& d) {
  std::string rows;
  for (const CandidateResult& c : d.candidates) {
    rows += fmt::format(
        "<tr><td><b>{}</b><br><span class=note>{}</span></td><td class=n>{:.0f} %</td><td class=n>{}</td>"
        "<td class=n>{} % [{}, {}]</td><td>{}</td><td class=note>{}</td></tr>\n",
        c.effect, escape(c.documentation), 100.0 * c.probability, percent(c.gap), wholePercent(c.closed),
        wholePercent(c.interval[0]), wholePercent(c.interval[1]),
        c.testable ? "yes" : fmt::format("no: {:.0f} % visible", 100.0 * c.visible_share), parametersText(c));
  }
  return "<table><tr><th>effect</th><th class=n>probability</th><th class=n>gap with it alone</th>"
         "<th class=n>closes [95 %]</th><th>testable here</th><th>parameters [SI]</th></tr>\n" +
         rows + "</table>\n";
}

std::string whereTable(const Diagnosis& d) {
  constexpr std::size_t kMost = 12;
  std::string rows;
  for (std::size_t i = 0; i < std::min(kMost, d.where.size()); ++i) {
    const gap::GapCell& cell = d.where[i];
    rows += fmt::format(
        "<tr><td>{}</td><td class=n>{:.3g} to {:.3g}</td><td class=n>{:.3g} to {:.3g}</td><td>{}</td><td "
        "class=n>{:.1f} %</td>"
        "<td class=n>{}</td></tr>\n",
        escape(cell.log), cell.frequency[0], cell.frequency[1], 1e3 * cell.amplitude[0], 1e3 * cell.amplitude[1],
        gap::toString(cell.quantity), 100.0 * cell.share,
        cell.noise_ratio > 0.0 ? fmt::format("{:.1f}", cell.noise_ratio) : "");  // the mean has no noise of its own
  }
  return "<table><tr><th>log</th><th class=n>frequency [Hz]</th><th class=n>amplitude [mm]</th><th>what is wrong</th>"
         "<th class=n>share of squared gap</th><th class=n>over noise</th></tr>\n" +
         rows + "</table>\n";
}

std::string ratiosText(const ParameterRatios& ratios) {
  std::string text;
  for (const auto& [name, ratio] : ratios) {
    text += fmt::format("{}{} &times; {:.3f}", text.empty() ? "" : ", ", escape(name), ratio);
  }
  return text;
}

std::string parameterTable(const Diagnosis& d) {
  std::string rows =
      fmt::format("<tr><td><b>all logs</b></td><td></td><td></td><td>{}</td></tr>\n", ratiosText(d.parameter_ratios));
  for (const ParameterByLog& row : d.by_log) {
    rows += fmt::format("<tr><td>{}</td><td class=n>{:.3g}</td><td class=n>{:.3g}</td><td>{}</td></tr>\n",
                        escape(row.log), 1e3 * row.amplitude, row.frequency, ratiosText(row.ratios));
  }
  return "<table><tr><th>log</th><th class=n>amplitude [mm]</th><th class=n>mean frequency [Hz]</th>"
         "<th>best value over configured value</th></tr>\n" +
         rows + "</table>\n";
}

std::string errorTable(const Diagnosis& d) {
  const auto row = [](const std::string& name, const CharacteristicErrors& e) {
    return fmt::format("<tr><td>{}</td><td class=n>{}</td><td class=n>{:.2f}&deg;</td><td class=n>{}</td></tr>\n", name,
                       percent(e.stiffness), e.loss_angle * 57.29577951308232, percent(e.energy));
  };
  return "<table><tr><th>model</th><th class=n>stiffness</th><th class=n>loss angle</th><th class=n>energy per "
         "cycle</th></tr>\n" +
         row("re-estimated", d.errors_re_estimated) + row("augmented", d.errors_augmented) + "</table>\n";
}

std::string admissionTable(const Diagnosis& d) {
  std::string rows;
  for (const Admission& log : d.admission) {
    rows += fmt::format(
        "<tr><td>{}{}</td><td class=n>{:.1f}</td><td class=n>{:.4g}</td><td class=n>{:.3g}</td><td class=n>{:.3g}</td>"
        "<td class=n>{}</td><td class=n>{:.0f} %</td><td class=note>{}</td></tr>\n",
        escape(log.log), log.hold_out ? " (held out)" : "", log.duration, 1.0 / log.dt, 1e3 * log.largest_displacement,
        log.highest_frequency, percent(log.noise), 100.0 * log.repeats, escape(join(log.notes)));
  }
  return "<table><tr><th>log</th><th class=n>length [s]</th><th class=n>rate [Hz]</th><th class=n>largest |z| [mm]</th>"
         "<th class=n>excited up to [Hz]</th><th class=n>noise floor</th><th "
         "class=n>repeats</th><th>notes</th></tr>\n" +
         rows + "</table>\n";
}

std::string figuresHtml(const Diagnosis& d) {
  std::vector<io::Figure> figures = reportFigures(d);
  figures.erase(std::remove_if(figures.begin(), figures.end(), [](const io::Figure& f) { return f.axes.empty(); }),
                figures.end());
  std::string html;
  try {
    for (const std::string& svg : io::drawSvg(figures)) {
      html += "<figure>" + svg + "</figure>\n";
    }
  } catch (const io::FigureError& error) {
    html = "<p class=note>No figures: " + escape(error.what()) + "</p>\n";
  }
  return html;
}

std::string findingsTable(const Diagnosis& d) {
  if (d.rig_findings.empty()) {
    return "<p>Nothing beyond chance.</p>\n";
  }
  std::string rows;
  for (const measurement::RigFinding& finding : d.rig_findings) {
    const std::string unit = finding.unit == "1" ? "" : " " + finding.unit;
    rows += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=n>{:.4g}{}</td><td class=n>{:.4g} to {:.4g}{}</td>"
        "<td class=note>{}{}</td></tr>\n",
        escape(finding.log), escape(finding.finding), finding.value, escape(unit), finding.interval_95[0],
        finding.interval_95[1], escape(unit), escape(finding.text),
        finding.beyond_tolerance ? "; beyond the rig's tolerance" : "");
  }
  return "<table><tr><th>log</th><th>finding</th><th class=n>value</th><th class=n>95 % interval</th><th>what it "
         "means</th></tr>\n" +
         rows + "</table>\n";
}

std::string notTestable(const Diagnosis& d) {
  std::vector<std::string> names;
  for (const CandidateResult& c : d.candidates) {
    if (!c.testable) {
      names.push_back(c.effect);
    }
  }
  return names.empty() ? "Every candidate would show in these logs."
                       : "These logs would not show a typical " + join(names) + ": not absent, but not testable.";
}

}  // namespace

namespace {

std::string beginningOf(const Diagnosis& d) {
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport "
             "content=\"width=device-width\"><title>Gap report: {0}</title><style>{1}</style></head><body>\n<h1>Gap "
             "between simulation and measurement: {0}</h1>\n",
             escape(d.component), kStyle) +
         "<p class=verdict>" + escape(d.sentence) + "</p>\n";
}

// Of logs that cannot be what they say.
std::string benchHtml(const Diagnosis& d) {
  return beginningOf(d) + "<h2>What the rig did to the logs</h2>\n" + findingsTable(d) +
         "<h2>Next experiment</h2>\n<p>" + escape(d.next_experiment) +
         "</p>\n<p>No effect is named and no component file is written: physics would be fitted to a fault of the "
         "bench.</p>\n</body></html>\n";
}

}  // namespace

std::string toHtml(const Diagnosis& d) {
  if (!d.workings) {
    return benchHtml(d);
  }
  std::string sets;
  for (const auto& set : d.confounded) {
    if (set.size() > 1) {
      sets += "<li>" + join(set) + "</li>\n";
    }
  }
  std::string html = beginningOf(d);
  html +=
      "<h2>How far</h2>\n<p class=note>A gap is the RMS of measured minus simulated force over the standard deviation "
      "of "
      "the measured force, on data that took no part in the fit, after what the rig did to that very log is taken "
      "out.</p>\n" +
      gapTable(d);
  html += fmt::format("<p>Closed: {} % of the closable gap, 95 % interval {} to {} %.</p>\n", wholePercent(d.closed),
                      wholePercent(d.closed_interval[0]), wholePercent(d.closed_interval[1]));
  html += "<p class=note>Errors of the characteristics on the same data:</p>\n" + errorTable(d);
  html += "<h2>Which</h2>\n" + candidateTable(d) +
          fmt::format(
              "<p>Probability that it is none of these: {:.0f} %. All candidates at once, as a flexible fit without "
              "claim to a cause, would leave a gap of {} on blocks of these logs held out.</p>\n",
              100.0 * d.probability_none, percent(d.workings->search.surrogate_gap));
  if (!sets.empty()) {
    html += "<p>These logs cannot tell apart:</p><ul>\n" + sets + "</ul>\n";
  }
  html += "<p>" + notTestable(d) + "</p>\n<h2>Next experiment</h2>\n<p>" + escape(d.next_experiment) + "</p>\n";
  html += "<h2>Where</h2>\n" + whereTable(d) + "<h2>Figures</h2>\n" + figuresHtml(d);
  html += "<h2>Which parameter would have to change</h2>\n" + parameterTable(d);
  html += "<h2>What the rig did to the logs</h2>\n" + findingsTable(d);
  html += "<h2>The logs</h2>\n" + admissionTable(d);
  html += "<h2>Component file with the effects found</h2>\n<pre>" + escape(io::toYaml({d.augmented})) +
          "</pre>\n</body></html>\n";
  return html;
}

}  // namespace rubber_suspension::diagnosis
