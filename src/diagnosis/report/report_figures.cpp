// Computes the figures of the report.
#include "diagnosis/report/report_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/prepare/bench_evidence.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "log/text.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::report {
namespace {

using nlohmann::ordered_json;

constexpr double kCyclesOfLoop = 3.0;       // number of cycles in a loop; more would merge into an area
constexpr Eigen::Index kMostPoints = 1500;  // largest number of points in a curve
constexpr std::size_t kMostLoops = 4;

std::vector<double> take(const Eigen::VectorXd& values, Eigen::Index first, Eigen::Index count, double factor) {
  const Eigen::Index stride = std::max<Eigen::Index>(1, count / kMostPoints);
  std::vector<double> result;
  for (Eigen::Index i = 0; i < count; i += stride) {
    result.push_back(factor * values[first + i]);
  }
  return result;
}

// Returns the residual of a component on a record [N], without possible errors of the rig, as for gaps.
Eigen::VectorXd leftOf(const Workings& workings, std::size_t r, const gap::Forces& simulated) {
  const gap::PreparedRecord& record = workings.simulated.records[r];
  return record.withoutRig(record.force - simulated[r]);
}

// Returns at most kMostLoops records: hold-outs in their order, then the others in descending order of their gap.
std::vector<std::size_t> worstRecords(const Diagnosis& diagnosis) {
  std::vector<std::size_t> order(diagnosis.workings->simulated.records.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (diagnosis.workings->simulated.training < order.size()) {
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(diagnosis.workings->simulated.training),
                order.end());
  }
  const auto gap = [&](std::size_t r) {
    const log::Record& record = diagnosis.workings->simulated.records[r];
    return gap::gapOfResidual(leftOf(*diagnosis.workings, r, diagnosis.workings->simulated.re_estimated),
                              record.force_deviation);
  };
  const auto first = order.begin() + static_cast<std::ptrdiff_t>(order.size() - diagnosis.workings->simulated.training);
  std::sort(first, order.end(), [&](std::size_t a, std::size_t b) { return gap(a) > gap(b); });
  order.resize(std::min(order.size(), kMostLoops));
  return order;
}

// Returns the number of samples in this many cycles of the mean frequency.
Eigen::Index cyclesOf(const log::Record& record, double cycles) {
  const double length = record.mean_frequency > 0.0 ? cycles / record.mean_frequency : record.duration();
  return std::clamp<Eigen::Index>(static_cast<Eigen::Index>(length / record.dt),
                                  std::min<Eigen::Index>(2, record.size()), record.size());
}

// Returns the start of a stretch in which the displacement has nearly its widest range. The last such stretch is
// chosen, because most transients have decayed there.
Eigen::Index widestStretch(const log::Record& record, Eigen::Index count) {
  constexpr double kAsWide = 0.98;
  Eigen::Index best = 0;
  double widest = -1.0;
  for (Eigen::Index first = 0; first + count <= record.size(); first += std::max<Eigen::Index>(1, count / 3)) {
    const auto part = record.displacement.segment(first, count);
    const double range = part.maxCoeff() - part.minCoeff();
    if (range >= kAsWide * widest) {
      widest = std::max(widest, range);
      best = first;
    }
  }
  return best;
}

// Where the curves coincide, both remain visible: the simulated curve is thin and lies above the broad measured one.
constexpr double kBroad = 3.0;
constexpr double kThin = 1.0;

void addForces(io::Axes& axes, const std::vector<double>& x, const std::vector<double>& measured,
               const std::vector<double>& before, const std::vector<double>& after) {
  axes.curves.push_back({"measured", x, measured, "-", 0, kBroad});
  axes.curves.push_back({"before: as configured", x, before, "--", 1, kThin});
  axes.curves.push_back({"after: augmented", x, after, "-", io::kInk, kThin});
}

io::Figure loops(const Diagnosis& diagnosis) {
  const Workings& w = *diagnosis.workings;
  io::Figure figure{"Force over displacement"};
  for (const std::size_t r : worstRecords(diagnosis)) {
    const log::Record& record = w.simulated.records[r];
    const Eigen::Index count = cyclesOf(record, kCyclesOfLoop);
    const Eigen::Index first = widestStretch(record, count);
    io::Axes axes{fmt::format("{}{}, {:.4g} to {:.4g} s", record.name, r >= w.simulated.training ? " (held out)" : "",
                              static_cast<double>(first) * record.dt, static_cast<double>(first + count) * record.dt),
                  "displacement [mm]", "force [kN]"};
    // The measured force is drawn without errors of the rig, as the force of the augmented component plus its residual.
    // Each other simulated force then differs from the measured force by its own residual.
    const Eigen::VectorXd& after = w.simulated.augmented[r];
    const Eigen::VectorXd measured = after + leftOf(w, r, w.simulated.augmented);
    const Eigen::VectorXd before = measured - leftOf(w, r, w.simulated.configured);
    addForces(axes, take(record.raw_displacement, first, count, 1e3), take(measured, first, count, 1e-3),
              take(before, first, count, 1e-3), take(after, first, count, 1e-3));
    figure.axes.push_back(std::move(axes));
  }
  return figure;
}

io::Axes comparedAxes(const prepare::ComparedLog& log, const std::string& as) {
  const Eigen::Index count = cyclesOf(log.record, kCyclesOfLoop);
  const Eigen::Index first = widestStretch(log.record, count);
  io::Axes axes{log.record.name + ", " + as, "displacement [mm]", "force [kN]"};
  const std::vector<double> x = take(log.record.raw_displacement, first, count, 1e3);
  axes.curves.push_back({"measured", x, take(log.record.force, first, count, 1e-3), "-", 0, kBroad});
  axes.curves.push_back({"simulated", x, take(log.simulated, first, count, 1e-3), "-", io::kInk, kThin});
  return axes;
}

// Returns two panels for each log: as recorded, and with the correction.
io::Figure benchFigure(const Diagnosis& diagnosis) {
  io::Figure figure{"Measured and simulated"};
  for (const prepare::CheckedLog& log : diagnosis.bench_evidence->logs) {
    figure.axes.push_back(comparedAxes(log.as_recorded, "as it is"));
    if (log.corrected) {
      figure.axes.push_back(comparedAxes(*log.corrected, log.correction));
    }
  }
  return figure;
}

// Returns the cells at frequencies that the logs excite (all, if these are not known), without mean and drift.
std::vector<gap::GapCell> mappedCells(const Diagnosis& diagnosis) {
  const std::array<double, 2> band = excitedBand(diagnosis);
  return element::those(diagnosis.where.before, [&](const gap::GapCell& cell) {
    const auto [low, high] = cell.frequency;
    return low > 0.0 && (!(band[1] > 0.0) || (high > band[0] && low < band[1]));
  });
}

io::Figure gapMapFigure(const Diagnosis& diagnosis) {
  const std::vector<gap::GapCell> cells = mappedCells(diagnosis);
  std::vector<double> frequencies;
  std::vector<double> amplitudes;
  for (const gap::GapCell& cell : cells) {
    frequencies.insert(frequencies.end(), cell.frequency.begin(), cell.frequency.end());
    amplitudes.insert(amplitudes.end(), cell.amplitude.begin(), cell.amplitude.end());
  }
  return shareMap(cells, sortedApart(frequencies), sortedApart(amplitudes));
}

// Returns the mean residual over displacement, for loading or for unloading.
io::Curve meanOver(const log::Record& record, const Eigen::VectorXd& residual, double direction,
                   const std::string& label, const std::string& style, int colour) {
  constexpr int kBins = 48;
  const double low = record.displacement.minCoeff();
  const double width = (record.displacement.maxCoeff() - low) / kBins;
  std::vector<double> sum(kBins, 0.0);
  std::vector<double> count(kBins, 0.0);
  for (Eigen::Index i = 1; i < record.size(); ++i) {
    if ((record.displacement[i] - record.displacement[i - 1]) * direction > 0.0) {
      const int bin = std::clamp(static_cast<int>((record.displacement[i] - low) / width), 0, kBins - 1);
      sum[static_cast<std::size_t>(bin)] += residual[i];
      count[static_cast<std::size_t>(bin)] += 1.0;
    }
  }
  io::Curve curve{label, {}, {}, style, colour};
  for (std::size_t b = 0; b < kBins; ++b) {
    if (count[b] >= 5.0) {
      curve.x.push_back(1e3 * (low + (static_cast<double>(b) + 0.5) * width));
      curve.y.push_back(1e-3 * sum[b] / count[b]);
    }
  }
  return curve;
}

io::Figure residualOverDisplacement(const Diagnosis& diagnosis) {
  io::Figure figure{"Mean residual over displacement"};
  for (const std::size_t r : worstRecords(diagnosis)) {
    const log::Record& record = diagnosis.workings->simulated.records[r];
    io::Axes axes{record.name, "displacement [mm]", "measured minus simulated [kN]"};
    for (const bool after : {false, true}) {
      const auto& simulated =
          after ? diagnosis.workings->simulated.augmented : diagnosis.workings->simulated.configured;
      const Eigen::VectorXd residual = leftOf(*diagnosis.workings, r, simulated);
      const std::string name = after ? "after, " : "before, ";
      axes.curves.push_back(meanOver(record, residual, 1.0, name + "rising", "-", after ? 2 : 1));
      axes.curves.push_back(meanOver(record, residual, -1.0, name + "falling", "--", after ? 2 : 1));
    }
    figure.axes.push_back(std::move(axes));
  }
  return figure;
}

// Returns the gap of successive stretches of all logs. A stretch is at least a cycle.
io::Curve levelOverTime(const Diagnosis& diagnosis, const std::vector<Eigen::VectorXd>& simulated,
                        const std::string& label, const std::string& style, int colour) {
  constexpr Eigen::Index kMostStretches = 60;  // largest number of stretches in a log
  io::Curve curve{label, {}, {}, style, colour};
  double start = 0.0;
  for (std::size_t r = 0; r < diagnosis.workings->simulated.records.size(); ++r) {
    const log::Record& record = diagnosis.workings->simulated.records[r];
    const Eigen::Index step = std::max(cyclesOf(record, 1.0), record.size() / kMostStretches);
    const Eigen::VectorXd left = leftOf(*diagnosis.workings, r, simulated);
    for (Eigen::Index first = 0; first + step <= record.size(); first += step) {
      const double gap = gap::gapOfResidual(left.segment(first, step), record.force_deviation);
      curve.x.push_back(start + (static_cast<double>(first) + 0.5 * static_cast<double>(step)) * record.dt);
      curve.y.push_back(std::max(1e-5, gap));
    }
    start += record.duration();
    curve.x.push_back(start);  // interrupts the line between two logs
    curve.y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  return curve;
}

io::Figure residualOverTime(const Diagnosis& diagnosis) {
  io::Figure figure{"Gap over time", {}, 1};
  io::Axes axes{"", "time [s]", "gap [-]", false, true};
  axes.curves.push_back(levelOverTime(diagnosis, diagnosis.workings->simulated.configured, "as configured", "-", 1));
  axes.curves.push_back(levelOverTime(diagnosis, diagnosis.workings->simulated.re_estimated, "re-estimated", "--", 3));
  axes.curves.push_back(levelOverTime(diagnosis, diagnosis.workings->simulated.augmented, "augmented", "-", 2));
  double end = 0.0;
  for (const log::Record& record : diagnosis.workings->simulated.records) {
    end += record.duration();
  }
  axes.curves.push_back(
      {"noise floor", {0.0, end}, {diagnosis.gaps.unseen.noise_floor, diagnosis.gaps.unseen.noise_floor}, ":", 7});
  figure.axes.push_back(std::move(axes));
  return figure;
}

io::Axes missingAxes(const MissingForce& map, const std::vector<double>& force, const std::string& title) {
  io::Axes axes;
  axes.title = title;
  axes.x_label = "displacement [mm]";
  axes.y_label = "velocity [mm/s]";
  io::HeatMap heat;
  heat.label = "force [kN]";
  const auto scaled = [](const std::vector<double>& values, double factor) {
    return element::each(values, [&](double value) { return factor * value; });
  };
  heat.x_edges = scaled(map.displacement, 1e3);
  heat.y_edges = scaled(map.velocity, 1e3);
  heat.values = scaled(force, 1e-3);
  axes.maps.push_back(std::move(heat));
  return axes;
}

io::Figure missingForceFigure(const MissingForce& map) {
  io::Figure figure;
  figure.title = "Force that the model lacks, over displacement and velocity";
  figure.axes.push_back(missingAxes(map, map.measured, "measured minus augmented"));
  figure.axes.push_back(missingAxes(map, map.surrogate, "force of the surrogate"));
  return figure;
}

// Returns figures in the units of a displacement.
std::vector<ReportFigure> figuresOf(const Diagnosis& diagnosis) {
  if (diagnosis.bench_evidence) {
    return {{kBench, "Force over displacement: measured, and simulated as configured.", benchFigure(diagnosis)}};
  }
  if (!diagnosis.workings || !diagnosis.defect.empty()) {
    return {};
  }
  if (diagnosis.table) {
    return tableFigures(diagnosis);
  }
  std::vector<ReportFigure> figures = {
      {kLoopsFigure, "Force over displacement: about three cycles where the stroke is largest.", loops(diagnosis)},
      {kWhere, "Where the squared gap lies, over the frequencies that the logs excite.", gapMapFigure(diagnosis)},
      {kResidual, "Mean of measured minus simulated force, separately for rising and falling displacement.",
       residualOverDisplacement(diagnosis)},
      {kTime, "Gap over time, one log after the other.", residualOverTime(diagnosis)}};
  if (diagnosis.surrogate) {
    figures.push_back({kMissing,
                       "Force that the model lacks, over displacement and velocity, and the force of a surrogate.",
                       missingForceFigure(diagnosis.surrogate->missing)});
  }
  return figures;
}

// Returns a curve with the positions at which it is interrupted because a value is missing.
ordered_json curveJson(const io::Curve& curve) {
  std::vector<double> breaks;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.y[i])) {
      breaks.push_back(curve.x[i]);
    }
  }
  return {{"label", curve.label},
          {"style", curve.style},
          {"colour", curve.colour},
          {"width", curve.width},
          {"breaks", breaks}};
}

ordered_json axesJson(const io::Axes& axes) {
  return {{"title", axes.title},
          {"x_label", axes.x_label},
          {"y_label", axes.y_label},
          {"log_x", axes.log_x},
          {"log_y", axes.log_y},
          {"curves", element::each(axes.curves, curveJson)},
          {"maps", element::each(axes.maps, &io::HeatMap::label)}};
}

}  // namespace

std::vector<double> sortedApart(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto same = [](double a, double b) { return std::abs(a / b - 1.0) < 1e-6; };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
  return values;
}

io::Figure shareMap(const std::vector<gap::GapCell>& cells, const std::vector<double>& frequencies,
                    const std::vector<double>& amplitudes) {
  io::Figure figure{"Where the squared gap lies", {}, 1};
  if (frequencies.size() < 2 || amplitudes.size() < 2) {
    return figure;
  }
  const auto placeIn = [](const std::vector<double>& edges, const std::array<double, 2>& band) {
    const double middle = std::sqrt(band[0] * band[1]);
    return static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), middle) - edges.begin()) - 1;
  };
  const std::size_t width = frequencies.size() - 1;
  std::vector<double> shares(width * (amplitudes.size() - 1), std::numeric_limits<double>::quiet_NaN());
  for (const gap::GapCell& cell : cells) {
    double& share = shares[placeIn(amplitudes, cell.amplitude) * width + placeIn(frequencies, cell.frequency)];
    share = (std::isnan(share) ? 0.0 : share) + 100.0 * cell.share;
  }
  const auto millimetres = element::each(amplitudes, [](double amplitude) { return 1e3 * amplitude; });
  io::Axes axes{"", "frequency [Hz]", "amplitude [mm]", true, true};
  axes.maps.push_back({frequencies, millimetres, shares, "share of the squared gap [%]"});
  figure.axes.push_back(std::move(axes));
  return figure;
}

std::array<double, 2> excitedBand(const Diagnosis& diagnosis) {
  if (!diagnosis.workings || diagnosis.workings->simulated.records.empty()) {
    return {};
  }
  std::array<double, 2> band = {std::numeric_limits<double>::infinity(), 0.0};
  for (const log::Record& record : diagnosis.workings->simulated.records) {
    band[0] = std::min(band[0], record.lowest_frequency);
    band[1] = std::max(band[1], record.highest_frequency);
  }
  return band;
}

std::vector<ReportFigure> reportFigures(const Diagnosis& diagnosis) {
  std::vector<ReportFigure> figures = figuresOf(diagnosis);
  for (ReportFigure& figure : figures) {
    for (io::Axes& axes : figure.figure.axes) {
      for (std::string* label : {&axes.x_label, &axes.y_label}) {
        *label = words::inUnits(diagnosis, *label);
      }
      for (io::HeatMap& map : axes.maps) {
        map.label = words::inUnits(diagnosis, map.label);
      }
    }
  }
  return figures;
}

io::Figure overviewFigure(const Diagnosis& diagnosis) {
  io::Figure overview{diagnosis.component + ": " + toString(diagnosis.answer.verdict) +
                      (diagnosis.answer.effects.empty() ? "" : ": " + log::join(diagnosis.answer.effects))};
  for (const ReportFigure& part : reportFigures(diagnosis)) {
    if (!part.figure.axes.empty()) {
      overview.axes.push_back(part.figure.axes.front());
      io::Axes& axes = overview.axes.back();
      axes.title = part.figure.title + (axes.title.empty() ? "" : "\n" + axes.title);
    }
  }
  return overview;
}

ordered_json figureJson(const ReportFigure& figure) {
  return {{"name", figure.name},
          {"file", figureDataFile(figure.name)},
          {"title", figure.figure.title},
          {"caption", figure.caption},
          {"axes", element::each(figure.figure.axes, axesJson)}};
}

std::string figureDataFile(const std::string& name) { return "figure_" + name + ".csv"; }

std::vector<std::string> figureDataFiles() {
  return element::each(std::array{kLoopsFigure, kWhere, kResidual, kTime, kMissing, kBench, kStiffness, kLossAngle},
                       figureDataFile);
}

}  // namespace rubber_suspension::diagnosis::report
