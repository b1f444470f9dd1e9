// The figures of the report.
#include "diagnosis/report/report_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "diagnosis/workings.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kLoopLength = 4.0;         // [s]
constexpr Eigen::Index kMostPoints = 1500;  // of a curve: more only makes the page heavy
constexpr std::size_t kMostLoops = 4;

std::vector<double> take(const Eigen::VectorXd& values, Eigen::Index first, Eigen::Index count, double factor) {
  const Eigen::Index stride = std::max<Eigen::Index>(1, count / kMostPoints);
  std::vector<double> result;
  for (Eigen::Index i = 0; i < count; i += stride) {
    result.push_back(factor * values[first + i]);
  }
  return result;
}

// The records where the re-estimated model is worst, hold-outs first where there are any.
std::vector<std::size_t> worstRecords(const Diagnosis& diagnosis) {
  std::vector<std::size_t> order(diagnosis.workings->records.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (diagnosis.workings->training < order.size()) {
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(diagnosis.workings->training), order.end());
  }
  const auto gap = [&](std::size_t r) {
    const log::Record& record = diagnosis.workings->records[r];
    return gap::gapOfResidual(record.force - diagnosis.workings->force_re_estimated[r], record.force_deviation);
  };
  const auto first = order.begin() + static_cast<std::ptrdiff_t>(order.size() - diagnosis.workings->training);
  std::sort(first == order.begin() ? order.begin() : first, order.end(),
            [&](std::size_t a, std::size_t b) { return gap(a) > gap(b); });
  order.resize(std::min(order.size(), kMostLoops));
  return order;
}

// Start of the stretch where the displacement has its widest range.
Eigen::Index widestStretch(const log::Record& record, Eigen::Index count) {
  Eigen::Index best = 0;
  double widest = -1.0;
  for (Eigen::Index first = 0; first + count <= record.size(); first += std::max<Eigen::Index>(1, count / 2)) {
    const auto part = record.displacement.segment(first, count);
    const double range = part.maxCoeff() - part.minCoeff();
    if (range > widest) {
      widest = range;
      best = first;
    }
  }
  return best;
}

io::Figure loops(const Diagnosis& diagnosis) {
  io::Figure figure;
  figure.title = "Force over displacement, measured and simulated";
  for (const std::size_t r : worstRecords(diagnosis)) {
    const log::Record& record = diagnosis.workings->records[r];
    const auto count = std::min(record.size(), static_cast<Eigen::Index>(kLoopLength / record.dt));
    const Eigen::Index first = widestStretch(record, count);
    const std::vector<double> z = take(record.raw_displacement, first, count, 1e3);
    io::Axes axes;
    axes.title =
        fmt::format("{}{}, {:.1f} to {:.1f} s", record.name, r >= diagnosis.workings->training ? " (held out)" : "",
                    static_cast<double>(first) * record.dt, static_cast<double>(first + count) * record.dt);
    axes.x_label = "displacement [mm]";
    axes.y_label = "force [kN]";
    axes.curves.push_back({"measured", z, take(record.force, first, count, 1e-3), "-", 0});
    axes.curves.push_back(
        {"model, re-estimated", z, take(diagnosis.workings->force_re_estimated[r], first, count, 1e-3), "--", 1});
    axes.curves.push_back({"augmented", z, take(diagnosis.workings->force_augmented[r], first, count, 1e-3), ":", 2});
    figure.axes.push_back(std::move(axes));
  }
  return figure;
}

io::Figure gapMapFigure(const Diagnosis& diagnosis) {
  std::map<double, std::map<double, double>> share;  // by lower edge of amplitude, then of frequency
  std::vector<double> x_edges;
  std::vector<double> y_edges;
  for (const gap::GapCell& cell : diagnosis.where) {
    if (cell.frequency[0] <= 0.0) {
      continue;  // mean and drift belong to no frequency
    }
    share[cell.amplitude[0]][cell.frequency[0]] += 100.0 * cell.share;
    x_edges.insert(x_edges.end(), cell.frequency.begin(), cell.frequency.end());
    y_edges.insert(y_edges.end(), cell.amplitude.begin(), cell.amplitude.end());
  }
  const auto unique = [](std::vector<double>& edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(
        std::unique(edges.begin(), edges.end(), [](double a, double b) { return std::abs(a / b - 1.0) < 1e-9; }),
        edges.end());
  };
  unique(x_edges);
  unique(y_edges);
  io::Figure figure;
  figure.title = "Where the squared gap lies";
  figure.columns = 1;
  if (x_edges.size() < 2 || y_edges.size() < 2) {
    return figure;
  }
  io::HeatMap map;
  map.label = "share of the squared gap [%]";
  const auto at = [&](double amplitude, double frequency) {
    for (const auto& [a, row] : share) {
      for (const auto& [f, value] : row) {
        if (std::abs(a / amplitude - 1.0) < 1e-9 && std::abs(f / frequency - 1.0) < 1e-9) {
          return value;
        }
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  };
  for (std::size_t y = 0; y + 1 < y_edges.size(); ++y) {
    for (std::size_t x = 0; x + 1 < x_edges.size(); ++x) {
      map.values.push_back(at(y_edges[y], x_edges[x]));
    }
  }
  map.x_edges = x_edges;
  for (const double edge : y_edges) {
    map.y_edges.push_back(1e3 * edge);
  }
  io::Axes axes;
  axes.x_label = "frequency [Hz]";
  axes.y_label = "amplitude [mm]";
  axes.log_x = axes.log_y = true;
  axes.maps.push_back(std::move(map));
  figure.axes.push_back(std::move(axes));
  return figure;
}

// Mean residual in bins of displacement, apart for loading and unloading.
io::Curve meanOver(const log::Record& record, const Eigen::VectorXd& residual, double direction,
                   const std::string& label, const std::string& style, int colour) {
  constexpr int kBins = 24;
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
  io::Curve curve;
  curve.label = label;
  curve.style = style;
  curve.colour = colour;
  for (std::size_t b = 0; b < kBins; ++b) {
    if (count[b] >= 5.0) {
      curve.x.push_back(1e3 * (low + (static_cast<double>(b) + 0.5) * width));
      curve.y.push_back(1e-3 * sum[b] / count[b]);
    }
  }
  return curve;
}

io::Figure residualOverDisplacement(const Diagnosis& diagnosis) {
  io::Figure figure;
  figure.title = "Mean residual (measured less simulated) over displacement";
  for (const std::size_t r : worstRecords(diagnosis)) {
    const log::Record& record = diagnosis.workings->records[r];
    const Eigen::VectorXd before = record.force - diagnosis.workings->force_re_estimated[r];
    const Eigen::VectorXd after = record.force - diagnosis.workings->force_augmented[r];
    io::Axes axes;
    axes.title = record.name;
    axes.x_label = "displacement [mm]";
    axes.y_label = "residual [kN]";
    axes.curves.push_back(meanOver(record, before, 1.0, "re-estimated, rising", "-", 1));
    axes.curves.push_back(meanOver(record, before, -1.0, "re-estimated, falling", "--", 1));
    axes.curves.push_back(meanOver(record, after, 1.0, "augmented, rising", "-", 2));
    axes.curves.push_back(meanOver(record, after, -1.0, "augmented, falling", "--", 2));
    figure.axes.push_back(std::move(axes));
  }
  return figure;
}

// The gap of each second; the logs one after the other.
io::Curve levelOverTime(const Diagnosis& diagnosis, const std::vector<Eigen::VectorXd>& simulated,
                        const std::string& label, int colour) {
  io::Curve curve;
  curve.label = label;
  curve.colour = colour;
  double start = 0.0;
  for (std::size_t r = 0; r < diagnosis.workings->records.size(); ++r) {
    const log::Record& record = diagnosis.workings->records[r];
    const auto step = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(1.0 / record.dt));
    for (Eigen::Index first = 0; first + step <= record.size(); first += step) {
      const double gap = gap::gapOfResidual((record.force - simulated[r]).segment(first, step), record.force_deviation);
      curve.x.push_back(start + static_cast<double>(first) * record.dt);
      curve.y.push_back(std::max(1e-5, gap));
    }
    start += record.duration();
  }
  return curve;
}

io::Figure residualOverTime(const Diagnosis& diagnosis) {
  io::Figure figure;
  figure.title = "Gap in each second, the logs one after the other";
  figure.columns = 1;
  io::Axes axes;
  axes.x_label = "time [s]";
  axes.y_label = "gap [-]";
  axes.log_y = true;
  axes.curves.push_back(levelOverTime(diagnosis, diagnosis.workings->force_configured, "as configured", 0));
  axes.curves.push_back(levelOverTime(diagnosis, diagnosis.workings->force_re_estimated, "re-estimated", 1));
  axes.curves.push_back(levelOverTime(diagnosis, diagnosis.workings->force_augmented, "augmented", 2));
  double end = 0.0;
  for (const log::Record& record : diagnosis.workings->records) {
    end += record.duration();
  }
  axes.curves.push_back({"noise floor", {0.0, end}, {diagnosis.gap.noise_floor, diagnosis.gap.noise_floor}, "--", 3});
  figure.axes.push_back(std::move(axes));
  return figure;
}

}  // namespace

std::vector<io::Figure> reportFigures(const Diagnosis& diagnosis) {
  return {loops(diagnosis), gapMapFigure(diagnosis), residualOverDisplacement(diagnosis), residualOverTime(diagnosis)};
}

}  // namespace rubber_suspension::diagnosis
