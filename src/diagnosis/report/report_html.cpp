// The report for engineers: report.html, one page without scripts or network.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "diagnosis/prepare/bench_evidence.h"
#include "diagnosis/report/compare.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/report/text.h"
#include "diagnosis/results/model_values.h"
#include "diagnosis/results/rounding.h"
#include "diagnosis/results/workings.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {
namespace {

std::string heading(const std::string& title) { return "<h2>" + title + "</h2>\n"; }

std::string gapTable(const Diagnosis& d) {
  const double widest = std::max({d.gap.as_configured, d.gap.re_estimated, d.gap.augmented, 1e-12});
  Table table({"model", "#gap", "", "what it is"});
  const auto row = [&](const std::string& name, double value, const std::string& meaning) {
    table.add({name, percent(value),
               fmt::format("<span class=track><span class=bar style=\"width:{:.0f}%\"></span></span>",
                           std::min(100.0, 100.0 * value / widest)),
               meaning});
  };
  row("as configured", d.gap.as_configured, "the component file as it is");
  row("re-estimated", d.gap.re_estimated, "model parameters fitted to " + sourceOf(d));
  row("augmented", d.gap.augmented, "with the named effects added");
  row("noise floor", d.gap.noise_floor, escape(d.noise_source));
  return table.html();
}

std::string errorTable(const Diagnosis& d) {
  Table table({"model", "#stiffness off by", "#loss angle off by", "#energy per cycle off by"});
  const auto row = [&](const std::string& name, const CharacteristicErrors& e) {
    table.add({name, percent(e.stiffness), fmt::format("{:.2f}&deg;", e.loss_angle * 180.0 / element::kPi),
               percent(e.energy)});
  };
  row("re-estimated", d.errors_re_estimated);
  row("augmented", d.errors_augmented);
  return table.html();
}

std::string howFar(const Diagnosis& d) {
  return heading("How far") + "<div class=pair><div>" + gapTable(d) + "</div><div>" + errorTable(d) + "</div></div>\n" +
         "<p class=note>" +
         (d.table
              ? "A gap is the RMS over the rows of |K*_measured - K*_simulated|/|K*_measured|, each row left out of "
                "the fit in its turn: for a sine, the RMS of the force difference over the standard deviation of "
                "the measured force."
              : "A gap is the RMS of measured minus simulated force over the standard deviation of the measured "
                "force. It is that of data to which no number was fitted, but which helped to choose between the "
                "effects. What the rig did to a log is taken out before.") +
         "</p>\n";
}

std::string whereTable(const Diagnosis& d) {
  constexpr std::size_t kMost = 6;
  Table table({d.table ? "table" : "log", "#frequency [Hz]", "#amplitude [mm]", "what is wrong",
               "#share of squared gap", "#times the noise"});
  for (std::size_t i = 0; i < std::min(kMost, d.where.size()); ++i) {
    const gap::GapCell& cell = d.where[i];
    table.add({escape(cell.log), rangeText(cell.frequency, 1.0), rangeText(cell.amplitude, 1e3),
               gap::toString(cell.quantity), percent(cell.share),
               cell.noise_ratio > 0.0 ? fmt::format("{:.2g}", cell.noise_ratio) : ""});  // the mean has no noise
  }
  return table.html();
}

// The figures of the page by their names: one <svg> per panel.
class DrawnFigures {
 public:
  explicit DrawnFigures(const Diagnosis& d) : figures_(reportFigures(d)) {
    std::vector<io::Figure> panels;
    for (const ReportFigure& figure : figures_) {
      for (const io::Axes& axes : figure.figure.axes) {
        panels.push_back({"", {axes}, 1});
      }
    }
    try {
      drawings_ = io::drawSvg(panels);
    } catch (const io::FigureError& error) {
      problem_ = error.what();
    }
  }

  /// Without a caption, for a place that has one.
  std::string panel(std::size_t figure, std::size_t panel) const {
    const std::size_t i = indexOf(figure) + panel;
    return i < drawings_.size() && panel < figures_[figure].figure.axes.size() ? drawings_[i] : "";
  }

  /// All panels from `first` on, each with its kind below.
  std::string panels(std::size_t figure, std::size_t first) const {
    std::string html;
    for (std::size_t p = first; p < figures_[figure].figure.axes.size() && !drawings_.empty(); ++p) {
      html += "<figure>" + panel(figure, p) + "<figcaption>" + escape(figures_[figure].figure.title) +
              "</figcaption></figure>\n";
    }
    return html;
  }

  std::string caption(std::size_t figure) const { return escape(figures_[figure].caption) + numbers(figure); }

  std::string numbers(std::size_t figure) const {
    return fmt::format(" <a class=screen href=\"{0}\">{0}</a>", figureDataFile(figures_[figure].name));
  }

  std::size_t size() const { return figures_.size(); }

  /// Why nothing is drawn, HTML; empty where it is.
  std::string problem() const {
    return problem_.empty() ? "" : "<p class=note>No figures: " + escape(problem_) + "</p>\n";
  }

 private:
  std::size_t indexOf(std::size_t figure) const {
    std::size_t index = 0;
    for (std::size_t i = 0; i < figure; ++i) {
      index += figures_[i].figure.axes.size();
    }
    return index;
  }

  std::vector<ReportFigure> figures_;
  std::vector<std::string> drawings_;
  std::string problem_;
};

constexpr std::size_t kLoops = 0;  // of reportFigures()
constexpr std::size_t kMap = 1;

std::string firstLoop(const DrawnFigures& figures) {
  const std::string loop = figures.size() > kLoops ? figures.panel(kLoops, 0) : "";
  return loop.empty() ? figures.problem()
                      : "<figure>" + loop +
                            "<figcaption>Where the gap is largest: measured (broad), and simulated before and after." +
                            figures.numbers(kLoops) + "</figcaption></figure>\n";
}

std::string where(const Diagnosis& d, const DrawnFigures& figures) {
  const std::string map = figures.panel(kMap, 0);
  return heading("Where") + "<div class=pair><div>" + whereTable(d) + "</div>" +
         (map.empty() ? ""
                      : "<figure>" + map + "<figcaption>Over frequency and amplitude." + figures.numbers(kMap) +
                            "</figcaption></figure>") +
         "</div>\n";
}

std::string furtherFigures(const DrawnFigures& figures) {
  std::string panels = figures.panels(kLoops, 1);
  std::string captions = figures.caption(kLoops);
  for (std::size_t i = kMap + 1; i < figures.size(); ++i) {
    panels += figures.panels(i, 0);
    captions += " " + figures.caption(i);
  }
  return panels.empty()
             ? ""
             : heading("Figures") + "<div class=figures>" + panels + "</div>\n<p class=note>" + captions + "</p>\n";
}

std::string ratiosText(const ParameterRatios& ratios) {
  std::string text;
  for (const auto& [name, ratio] : ratios) {
    text += fmt::format("{}{} &times; {:.3f}", text.empty() ? "" : ", ", escape(symbolOf(name)), ratio);
  }
  return text;
}

std::string parameterTable(const Diagnosis& d) {
  Table table({"log", "#amplitude [mm]", "#mean frequency [Hz]", "best value over configured value"});
  table.add({"<b>all logs</b>", "", "", ratiosText(d.parameter_ratios)});
  for (const ParameterByLog& row : d.by_log) {
    table.add({escape(row.log), fmt::format("{:.3g}", 1e3 * row.amplitude), fmt::format("{:.3g}", row.frequency),
               ratiosText(row.ratios)});
  }
  return table.html();
}

std::string componentFile(const Diagnosis& d) {
  return heading("Component file before and after") + componentChanges(d) +
         "<p class=screen>Node and <code>replay</code> run <a href=\"augmented.yaml\">augmented.yaml</a> as it is: the "
         "simplest law of each effect, rounded to what is known of it. All digits are in report.json.</p>\n" +
         folded("augmented.yaml", "<pre>" + escape(augmentedYaml(d)) + "</pre>\n") +
         (d.by_log.empty() ? "" : folded("Which value each log alone would want", parameterTable(d)));
}

std::string findingText(const measurement::RigFinding& finding) {
  std::string text = fmt::format("{}: {}", finding.log, quantity(finding.value, finding.unit));
  if (finding.interval_95[0] < finding.interval_95[1]) {
    text += fmt::format(" ({} to {})", quantity(finding.interval_95[0], finding.unit),
                        quantity(finding.interval_95[1], finding.unit));
  }
  return "<span class=\"value\">" + escape(text) + "</span>" +
         (finding.beyond_tolerance && !finding.fatal ? " <b>beyond the rig's tolerance</b>" : "");
}

// Those that are sure: not where the interval holds 0, nor what a rig does to all logs alike where logs contradict each
// other in its sign.
std::vector<measurement::RigFinding> sureFindings(const Diagnosis& d) {
  const auto holdsZero = [](const measurement::RigFinding& finding) {
    return finding.interval_95[0] < finding.interval_95[1] && finding.interval_95[0] <= 0.0 &&
           finding.interval_95[1] >= 0.0;
  };
  const auto contradicted = [&](const measurement::RigFinding& finding) {
    const bool of_rig = finding.finding == measurement::finding::kDelay ||
                        finding.finding == measurement::finding::kSensorGain ||
                        finding.finding == measurement::finding::kClock;
    return of_rig && std::any_of(d.rig_findings.begin(), d.rig_findings.end(), [&](const auto& other) {
             return other.finding == finding.finding && !holdsZero(other) && other.value * finding.value < 0.0;
           });
  };
  std::vector<measurement::RigFinding> sure;
  std::copy_if(d.rig_findings.begin(), d.rig_findings.end(), std::back_inserter(sure),
               [&](const auto& finding) { return finding.fatal || (!holdsZero(finding) && !contradicted(finding)); });
  return sure;
}

// One row per kind of finding: what it means and how to mend it is the same for all logs.
std::string findings(const Diagnosis& d) {
  std::string html = heading("What the rig did to the logs");
  const std::vector<measurement::RigFinding> found = sureFindings(d);
  if (found.empty()) {
    return html + "<p>Nothing that is sure.</p>\n";
  }
  std::vector<std::string> kinds;
  std::map<std::string, std::string> values;
  std::map<std::string, std::string> texts;
  for (const measurement::RigFinding& finding : found) {
    std::string& value = values[finding.finding];
    if (value.empty()) {
      kinds.push_back(finding.finding);
    }
    value += (value.empty() ? "" : "<br>") + findingText(finding);
    const FindingAdvice& advice = adviceOn(finding.finding);
    std::string& text = texts[finding.finding];
    if (finding.fatal || advice.meaning.empty()) {
      text += (text.empty() ? "" : " ") + escape(finding.text) + ".";
    }
  }
  Table table({"finding", "log: value (95 %)", "what it means", "at the bench"});
  for (const std::string& kind : kinds) {
    const FindingAdvice& advice = adviceOn(kind);
    table.add({escape(spoken(kind)), values[kind],
               escape(advice.meaning) + (advice.meaning.empty() || texts[kind].empty() ? "" : " ") + texts[kind],
               escape(advice.remedy)});
  }
  return html + table.html();
}

// One row per log, so that what was taken out can be added up.
std::string takenOut(const Diagnosis& d) {
  Table table({"log", "#gap as recorded", "taken out, in % of the force", "#gap"});
  for (const Admission& log : d.admission) {
    std::string parts;
    for (const TakenOut& part : d.taken_out) {
      constexpr double kShown = 5e-4;
      if (part.log == log.log && std::abs(part.share) > kShown) {
        parts += fmt::format("{}{} {:.2g}", parts.empty() ? "" : ", ", escape(spoken(part.kind)), 100.0 * part.share);
      }
    }
    table.add({escape(log.log), percent(log.recorded), parts.empty() ? "nothing" : parts, percent(log.left)});
  }
  return "<p>What the rig did is taken out of each log before it is compared with the model. Squares add up: the gap as "
         "recorded less what is taken out is the gap. A negative number made the gap larger.</p>\n" +
         table.html();
}

std::string excerptsTaken(const Diagnosis& d) {
  if (d.samples == d.recorded_samples) {
    return "";
  }
  return fmt::format(
      "<p>The search took {} of {} samples (<code>--most-samples</code>): excerpts, each a log below, with its seconds "
      "in "
      "its name. What lies between them moved the component, and was compared with nothing. The gap of the whole logs "
      "as they were recorded: {} as configured, {} after.</p>\n",
      d.samples, d.recorded_samples, percent(d.gap_as_recorded.as_configured), percent(d.gap_as_recorded.augmented));
}

std::string admission(const Diagnosis& d) {
  Table table({"log", "#length [s]", "#rate [Hz]", "#largest |z| [mm]", "#excited up to [Hz]", "#noise floor",
               "#repeats", "notes"});
  for (const Admission& log : d.admission) {
    table.add({escape(log.log) + (log.hold_out ? " (held out)" : ""), fmt::format("{:.1f}", log.duration),
               fmt::format("{:.4g}", 1.0 / log.dt), fmt::format("{:.3g}", 1e3 * log.largest_displacement),
               fmt::format("{:.3g}", log.highest_frequency), percent(log.noise), wholePercent(log.repeats) + " %",
               escape(enumerated(log.notes))});
  }
  return heading("The logs") + excerptsTaken(d) + table.html();
}

std::string runRecord(const Diagnosis& d) {
  if (d.run.version.empty()) {
    return "";
  }
  Table table({"option", "file", "SHA-256"});
  for (const InputFile& file : d.run.files) {
    table.add({escape(file.option), escape(file.name), "<code>" + escape(file.sha256) + "</code>"});
  }
  return heading("Record of this run") +
         fmt::format("<p>rubber_suspension {}, {}. Again by:</p>\n<pre>{}</pre>\n", escape(d.run.version),
                     escape(d.run.date), escape(d.run.command_line)) +
         table.html();
}

std::string nextExperiment(const Diagnosis& d) {
  if (d.proposed.displacement.empty()) {
    return "";
  }
  return heading("Next experiment") + "<p>" + escape(d.next_experiment) + "</p>\n<p class=note>It stays within the " +
         "limits given, and where none is, within the strokes, speeds, forces and duration of the logs of the fit. "
         "To " +
         howToPlay(d) + " on the bench, or through the node:</p>\n<pre>" +
         escape(fmt::format("roslaunch rubber_suspension bench.launch config:=$PWD/augmented.yaml component:={} "
                            "log:=$PWD/next_experiment.csv output:=$PWD/next_run",
                            d.component)) +
         "</pre>\n";
}

std::string couldShow(const Diagnosis& d) {
  return d.could_show.implanted.empty()
             ? ""
             : heading("Could " + sourceOf(d) + " have shown it?") + couldShowHtml(d.could_show);
}

std::string titleOf(const Diagnosis& d) { return "Gap report: " + d.component; }

// Each log that cannot be what it says: as it is, and with the correction.
std::string benchLoops(const Diagnosis& d, const DrawnFigures& figures) {
  if (figures.size() == 0 || d.bench_evidence->logs.empty()) {
    return "";
  }
  const std::string loops = figures.panels(0, 0);
  return loops.empty() ? figures.problem()
                       : "<div>" + loops + "<p class=note>Broad: measured. Thin: simulated as configured." +
                             figures.numbers(0) + "</p></div>\n";
}

// Of logs that cannot be what they say.
std::string benchPage(const Diagnosis& d) {
  const DrawnFigures figures(d);
  return page(titleOf(d),
              firstScreen(d, benchLoops(d, figures)) + comparisonSection(d.comparison) + (d.table ? "" : findings(d)) +
                  "<p>No effect is named and no component file is written: physics would be fitted to a fault of the "
                  "bench.</p>\n" +
                  runRecord(d));
}

}  // namespace

std::string toHtml(const Diagnosis& d) {
  if (!d.workings) {
    return d.turns ? inRotationUnits(benchPage(d)) : benchPage(d);
  }
  const DrawnFigures figures(d);
  const std::string html =
      page(titleOf(d), firstScreen(d, firstLoop(figures)) + comparisonSection(d.comparison) + howFar(d) +
                           heading("Which") + candidateSection(d) + where(d, figures) + furtherFigures(figures) +
                           componentFile(d) + nextExperiment(d) + couldShow(d) +
                           (d.table ? tableSection(d) : findings(d) + takenOut(d) + admission(d)) + runRecord(d));
  return d.turns ? inRotationUnits(html) : html;
}

}  // namespace rubber_suspension::diagnosis
