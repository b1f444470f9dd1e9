// The figures of the report.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::diagnosis::report {

inline constexpr const char* kLoopsFigure = "loops";
inline constexpr const char* kWhere = "where";
inline constexpr const char* kResidual = "residual_over_displacement";
inline constexpr const char* kTime = "gap_over_time";
inline constexpr const char* kMissing = "missing_force";
inline constexpr const char* kBench = "bench";
inline constexpr const char* kStiffness = "stiffness";
inline constexpr const char* kLossAngle = "loss_angle";

/// A figure of the report; its numbers stand in figure_NAME.csv.
struct ReportFigure {
  std::string name;
  std::string caption;
  io::Figure figure;  ///< its title is short; without axes there is nothing to show
};

/// Returns loops, map of the gap, residual over displacement and gap over time, held-out logs first, then the others by
/// decreasing gap; with a surrogate, also the missing force. For the verdict check_bench, returns the loops of the logs
/// as recorded and with the proposed correction. Returns none if there is nothing to show.
std::vector<ReportFigure> reportFigures(const Diagnosis& diagnosis);

/// Returns the figures of a report on a table: stiffness, place of the gap, and loss angle, in this order.
std::vector<ReportFigure> tableFigures(const Diagnosis& diagnosis);

/// Returns the share of the squared gap in the cells between these edges [Hz, m]; each of `cells` counts where the
/// middle of its band lies. The figure has no axes if there is no cell.
io::Figure shareMap(const std::vector<gap::GapCell>& cells, const std::vector<double>& frequencies,
                    const std::vector<double>& amplitudes);

/// Returns the lowest and highest frequency that the logs excite [Hz]; 0 for both if they are not known.
std::array<double, 2> excitedBand(const Diagnosis& diagnosis);

/// Returns the values in ascending order, equal ones once.
std::vector<double> sortedApart(std::vector<double> values);

/// Returns the diagnosis on one page, as `diagnose --plot` draws it: the figures of the report, each for one log, which
/// is the first hold-out or, without hold-outs, that of the largest gap.
io::Figure overviewFigure(const Diagnosis& diagnosis);

/// Returns the curves of a figure as CSV, one point a row: curve, panel, and two values with the labels of their axes.
/// For a map: curve, panel, the edges of a cell and its value. Values that are not finite are omitted.
std::string figureCsv(const io::Figure& figure);

/// Returns the description of a figure without its numbers, which are in its file.
nlohmann::ordered_json figureJson(const ReportFigure& figure);

/// Returns the name of the file with the numbers of a figure.
std::string figureDataFile(const std::string& name);

/// Returns the names of the files of all figures.
std::vector<std::string> figureDataFiles();

}  // namespace rubber_suspension::diagnosis::report
