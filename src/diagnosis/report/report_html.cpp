// The report for engineers: report.html, one page without scripts or network.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/augmented_yaml.h"
#include "diagnosis/report/compare.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/text.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {
namespace {

using words::escape;
using words::percent;
using words::Row;

// A part that is not printed.
std::string onScreen(const std::string& html) { return "<div class=screen>" + html + "</div>\n"; }

std::string heading(const std::string& title) { return "<h2>" + title + "</h2>\n"; }

std::string errorTable(const Diagnosis& d) {
  const auto row = [](const std::string& name, const CharacteristicErrors& e) -> Row {
    return {name, percent(e.stiffness), fmt::format("{:.2f}&deg;", e.loss_angle * 180.0 / element::kPi),
            percent(e.energy)};
  };
  return words::table({"model", "#stiffness off by", "#loss angle off by", "#energy per cycle off by"},
                      {row("re-estimated", d.where.re_estimated), row("augmented", d.where.augmented)});
}

std::string howFar(const Diagnosis& d) {
  return heading("How far") + errorTable(d) + "<p class=note>" +
         (d.table
              ? "A gap is the RMS over the rows of |K*_measured - K*_simulated|/|K*_measured|, each row left out of "
                "the fit in its turn: for a sine, the RMS of the force difference over the standard deviation of "
                "the measured force."
              : "A gap is the RMS of measured minus simulated force over the standard deviation of the measured "
                "force. It is that of data to which no number was fitted, but which helped to choose between the "
                "effects. What the rig did to a log is taken out before.") +
         " Noise floor: " + escape(d.gaps.noise_source) + ".</p>\n";
}

std::string whereTable(const Diagnosis& d) {
  constexpr std::size_t kMost = 6;
  const std::vector<gap::GapCell> largest(
      d.where.before.begin(),
      d.where.before.begin() + static_cast<std::ptrdiff_t>(std::min(kMost, d.where.before.size())));
  return words::table(
      {d.table ? "table" : "log", "#frequency [Hz]", words::inUnits(d, "#amplitude [mm]"), "what is wrong",
       "#share of squared gap", "#times the noise"},
      largest, [](const gap::GapCell& cell) -> Row {
        return {escape(cell.log),
                words::rangeText(cell.frequency, 1.0),
                words::rangeText(cell.amplitude, 1e3),
                gap::toString(cell.quantity),
                percent(cell.share),
                cell.noise_ratio > 0.0 ? fmt::format("{:.2g}", cell.noise_ratio) : ""};  // the mean has none
      });
}

// A figure of the page: one <svg> per panel.
struct DrawnFigure {
  report::ReportFigure figure;
  std::vector<std::string> panels;

  std::string numbers() const {
    return fmt::format(" <a class=screen href=\"{0}\">{0}</a>", report::figureDataFile(figure.name));
  }

  // All panels from `first` on, each with its kind below.
  std::string from(std::size_t first) const {
    std::string html;
    for (std::size_t p = first; p < panels.size(); ++p) {
      html += "<figure>" + panels[p] + "<figcaption>" + escape(figure.figure.title) + "</figcaption></figure>\n";
    }
    return html;
  }
};

struct DrawnFigures {
  std::vector<DrawnFigure> figures;
  std::string problem;  // why nothing is drawn, HTML
};

DrawnFigures drawFigures(const std::vector<report::ReportFigure>& figures) {
  DrawnFigures drawn;
  std::vector<io::Figure> panels;
  for (const report::ReportFigure& figure : figures) {
    drawn.figures.push_back({figure, {}});
    for (const io::Axes& axes : figure.figure.axes) {
      panels.push_back({"", {axes}, 1});
    }
  }
  try {
    auto drawing = io::drawSvg(panels);
    auto next = drawing.begin();
    for (DrawnFigure& figure : drawn.figures) {
      const auto end = next + static_cast<std::ptrdiff_t>(figure.figure.figure.axes.size());
      figure.panels.assign(next, end);
      next = end;
    }
  } catch (const io::FigureError& error) {
    drawn.problem = "<p class=note>No figures: " + escape(error.what()) + "</p>\n";
  }
  return drawn;
}

std::string where(const Diagnosis& d) { return heading("Where, by log and quantity") + whereTable(d); }

// The map of the gap is a picture of the first screen.
std::string furtherFigures(const DrawnFigures& drawn) {
  std::string panels;
  std::string captions;
  for (const DrawnFigure& figure : drawn.figures) {
    if (figure.figure.name != report::kWhere) {
      panels += figure.from(0);
      captions += (captions.empty() ? "" : " ") + escape(figure.figure.caption) + figure.numbers();
    }
  }
  return panels.empty()
             ? drawn.problem
             : heading("Figures") + "<div class=figures>" + panels + "</div>\n<p class=note>" + captions + "</p>\n";
}

std::string componentFile(const Diagnosis& d) {
  return heading("Component file before and after") + words::componentChanges(d) +
         "<p class=screen>Node and <code>replay</code> run <a href=\"augmented.yaml\">augmented.yaml</a> as it is: the "
         "simplest law of each effect, rounded to what is known of it. All digits are in report.json.</p>\n" +
         words::folded("augmented.yaml", "<pre>" + escape(report::augmentedYaml(d)) + "</pre>\n");
}

std::string findingText(const measurement::RigFinding& finding) {
  std::string text = fmt::format("{}: {}", finding.log, words::quantity(finding.value, finding.unit));
  if (finding.interval_95[0] < finding.interval_95[1]) {
    text += fmt::format(" ({} to {})", words::quantity(finding.interval_95[0], finding.unit),
                        words::quantity(finding.interval_95[1], finding.unit));
  }
  return "<span class=\"value\">" + escape(text) + "</span>" +
         (finding.beyond_tolerance && !finding.fatal ? " <b>beyond the rig's tolerance</b>" : "");
}

// Whether it is sure: not where the interval holds 0, nor what a rig does to all logs alike where logs contradict each
// other in its sign.
bool isSure(const measurement::RigFinding& finding, const std::vector<measurement::RigFinding>& all) {
  const auto holdsZero = [](const measurement::RigFinding& one) {
    return one.interval_95[0] < one.interval_95[1] && one.interval_95[0] <= 0.0 && one.interval_95[1] >= 0.0;
  };
  const bool of_rig = finding.finding == measurement::finding::kDelay ||
                      finding.finding == measurement::finding::kSensorGain ||
                      finding.finding == measurement::finding::kClock;
  const bool contradicted =
      of_rig && std::any_of(all.begin(), all.end(), [&](const measurement::RigFinding& other) {
        return other.finding == finding.finding && !holdsZero(other) && other.value * finding.value < 0.0;
      });
  return finding.fatal || (!holdsZero(finding) && !contradicted);
}

// One row per kind of finding: what it means and how to mend it is the same for all logs.
std::string findings(const Diagnosis& d) {
  std::vector<std::string> kinds;
  std::vector<Row> rows;
  for (const measurement::RigFinding& finding : d.rig_findings) {
    if (!isSure(finding, d.rig_findings)) {
      continue;
    }
    const report::FindingAdvice& advice = report::adviceOn(finding.finding);
    const auto kind = std::find(kinds.begin(), kinds.end(), finding.finding);
    const auto r = static_cast<std::size_t>(kind - kinds.begin());
    if (kind == kinds.end()) {
      kinds.push_back(finding.finding);
      rows.push_back({escape(words::spoken(finding.finding)), findingText(finding), escape(advice.meaning),
                      escape(advice.remedy)});
    } else {
      rows[r][1] += "<br>" + findingText(finding);
    }
    if (finding.fatal || advice.meaning.empty()) {
      rows[r][2] += (rows[r][2].empty() ? "" : " ") + escape(finding.text) + ".";
    }
  }
  return heading("What the rig did to the logs") +
         (rows.empty() ? "<p>Nothing that is sure.</p>\n"
                       : words::table({"finding", "log: value (95 %)", "what it means", "at the bench"}, rows));
}

// One row per log, so that what was taken out can be added up.
std::string takenOut(const Diagnosis& d) {
  constexpr double kShown = 5e-4;
  const auto row = [&](const Admission& log) -> Row {
    std::string parts;
    for (const TakenOut& part : d.logs.taken_out) {
      if (part.log == log.log && std::abs(part.share) > kShown) {
        parts +=
            fmt::format("{}{} {:.2g}", parts.empty() ? "" : ", ", escape(words::spoken(part.kind)), 100.0 * part.share);
      }
    }
    return {escape(log.log), percent(log.recorded), parts.empty() ? "nothing" : parts, percent(log.left)};
  };
  return "<p>What the rig did is taken out of each log before it is compared with the model. Squares add up: the gap "
         "as "
         "recorded less what is taken out is the gap. A negative number made the gap larger.</p>\n" +
         words::table({"log", "#gap as recorded", "taken out, in % of the force", "#gap"}, d.logs.admission, row);
}

std::string excerptsTaken(const Diagnosis& d) {
  if (d.samples.searched == d.samples.recorded) {
    return "";
  }
  return fmt::format(
      "<p>The search took {} of {} samples (<code>--most-samples</code>): excerpts, each a log below, with its seconds "
      "in "
      "its name. What lies between them moved the component, and was compared with nothing. The gap of the whole logs "
      "as they were recorded: {} as configured, {} after.</p>\n",
      d.samples.searched, d.samples.recorded, percent(d.gap_as_recorded.as_configured),
      percent(d.gap_as_recorded.augmented));
}

std::string ratingTable(const Diagnosis& d) {
  std::vector<Row> rows;
  bool any_repeats = false;
  for (const Admission& log : d.logs.admission) {
    if (!log.rating) {
      continue;
    }
    const gap::Iso18571& after = log.rating->augmented;
    any_repeats = any_repeats || after.repeats;
    rows.push_back({escape(log.log) + (after.repeats ? " *" : ""),
                    fmt::format("{:.3f}", log.rating->as_configured.total), fmt::format("{:.3f}", after.total),
                    gap::iso18571Grade(after.total), fmt::format("{:.3f}", after.corridor),
                    fmt::format("{:.3f}", after.phase), fmt::format("{:.3f}", after.magnitude),
                    fmt::format("{:.3f}", after.slope)});
  }
  if (rows.empty()) {
    return "";
  }
  return heading("Rating by ISO/TS 18571") +
         words::table({"log", "#as configured", "#augmented", "grade", "#corridor", "#phase", "#magnitude", "#slope"},
                      rows) +
         (any_repeats
              ? "<p class=note>* The measured force repeats itself. The rating is meant for signals that are not "
                "periodic: its shift may lead to another cycle.</p>\n"
              : "");
}

std::string admission(const Diagnosis& d) {
  return heading("The logs") + excerptsTaken(d) +
         words::table({"log", "#length [s]", "#rate [Hz]", words::inUnits(d, "#largest |z| [mm]"),
                       "#excited up to [Hz]", "#noise floor", "#repeats", "notes"},
                      d.logs.admission, [](const Admission& log) -> Row {
                        return {escape(log.log) + (log.hold_out ? " (held out)" : ""),
                                fmt::format("{:.1f}", log.duration),
                                fmt::format("{:.4g}", 1.0 / log.dt),
                                fmt::format("{:.3g}", 1e3 * log.largest_displacement),
                                fmt::format("{:.3g}", log.highest_frequency),
                                percent(log.noise),
                                words::wholePercent(log.repeats) + " %",
                                escape(words::enumerated(log.notes))};
                      });
}

std::string runRecord(const Diagnosis& d) {
  if (d.run.version.empty()) {
    return "";
  }
  return heading("Record of this run") +
         fmt::format("<p>rubber_suspension {}, {}. Again by:</p>\n<pre>{}</pre>\n", escape(d.run.version),
                     escape(d.run.date), escape(d.run.command_line)) +
         words::table({"option", "file", "SHA-256"}, d.run.files, [](const InputFile& file) -> Row {
           return {escape(file.option), escape(file.name), "<code>" + escape(file.sha256) + "</code>"};
         });
}

std::string nextExperiment(const Diagnosis& d) {
  if (d.next.proposed.displacement.empty()) {
    return "";
  }
  return heading("Next experiment") + "<p>" + escape(d.next.text) + "</p>\n<p class=note>It stays within the " +
         "limits given, and where none is, within the strokes, speeds, forces and duration of the logs of the fit. "
         "To " +
         report::howToPlay(d) + " on the bench, or through the node:</p>\n<pre>" +
         escape(fmt::format("roslaunch rubber_suspension bench.launch config:=$PWD/augmented.yaml component:={} "
                            "log:=$PWD/next_experiment.csv output:=$PWD/next_run",
                            d.component)) +
         "</pre>\n";
}

std::string couldShow(const Diagnosis& d) {
  return d.could_show.implanted.empty()
             ? ""
             : heading("Could " + words::sourceOf(d) + " have shown it?") + report::couldShowHtml(d.could_show);
}

// Each log that cannot be what it says: as it is, and with the correction.
std::string benchLoops(const DrawnFigures& drawn) {
  const std::string loops = drawn.figures.empty() ? "" : drawn.figures[0].from(0);
  return loops.empty() ? drawn.problem
                       : "<div>" + loops + "<p class=note>Broad: measured. Thin: simulated as configured." +
                             drawn.figures[0].numbers() + "</p></div>\n";
}

// Of logs that cannot be what they say.
std::string benchBody(const Diagnosis& d, const DrawnFigures& drawn) {
  return report::firstScreen(d, benchLoops(drawn)) + report::comparisonSection(d.comparison) +
         (d.table ? "" : findings(d)) +
         "<p>No effect is named and no component file is written: physics would be fitted to a fault of the "
         "bench.</p>\n";
}

// No claim.
std::string defectBody(const Diagnosis& d) {
  return report::firstScreen(d) + "<p>No effect is named and no component file is written.</p>\n" +
         (d.table ? "" : admission(d));
}

std::string body(const Diagnosis& d, const DrawnFigures& drawn) {
  return report::firstScreen(d) + report::comparisonSection(d.comparison) + furtherFigures(drawn) + howFar(d) +
         heading("Which") + report::candidateSection(d) + onScreen(where(d)) + componentFile(d) +
         onScreen(nextExperiment(d) + couldShow(d)) +
         (d.table ? report::tableSection(d) : findings(d) + takenOut(d) + ratingTable(d) + onScreen(admission(d)));
}

}  // namespace

std::string report::reportPage(const Diagnosis& d, const std::vector<ReportFigure>& figures) {
  const std::string text = !d.workings        ? benchBody(d, drawFigures(figures))
                           : d.defect.empty() ? body(d, drawFigures(figures))
                                              : defectBody(d);
  return page("Gap report: " + d.component, text + runRecord(d));
}

std::string toHtml(const Diagnosis& d) { return report::reportPage(d, report::reportFigures(d)); }

}  // namespace rubber_suspension::diagnosis
