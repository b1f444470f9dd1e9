// Computes the figures of the report.
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

/// A figure of the report. Its numbers are in the file figure_NAME.csv.
struct ReportFigure {
  std::string name;
  std::string caption;
  io::Figure figure;  ///< has a short title; a figure without axes shows nothing
};

/// Returns loops, the map of the gap, the residual over displacement and the gap over time, for the held-out logs first
/// and then for the others in descending order of their gap. With a surrogate, adds a map of the missing force. For the
/// verdict check_bench, returns the loops of the logs as recorded and as corrected. The list may be empty.
std::vector<ReportFigure> reportFigures(const Diagnosis& diagnosis);

/// Returns the figures of a report on a table: stiffness, where the gap lies, and loss angle.
std::vector<ReportFigure> tableFigures(const Diagnosis& diagnosis);

/// Returns a map of the squared gap with these edges of its cells [Hz, m]. A cell of `cells` is added to the cell of
/// the map that contains the middle of its bands. The figure has no axes if an axis has fewer than two edges.
io::Figure shareMap(const std::vector<gap::GapCell>& cells, const std::vector<double>& frequencies,
                    const std::vector<double>& amplitudes);

/// Returns the lowest and the highest frequency that the logs excite [Hz]. Both are 0 if they are not known.
std::array<double, 2> excitedBand(const Diagnosis& diagnosis);

/// Returns the values in ascending order without duplicates.
std::vector<double> sortedApart(std::vector<double> values);

/// Returns the diagnosis on one page, as `diagnose --plot` draws it. Each figure shows one log: the first hold-out, or
/// the log with the largest gap if there is no hold-out.
io::Figure overviewFigure(const Diagnosis& diagnosis);

/// Returns the curves of a figure as CSV with one point per row: curve, panel, and two values with the labels of their
/// axes. A row of a map has curve, panel, the edges of a cell and its value. Values that are not finite are omitted.
std::string figureCsv(const io::Figure& figure);

/// Returns a description of the figure. The numbers of the figure are in its file.
nlohmann::ordered_json figureJson(const ReportFigure& figure);

std::string figureDataFile(const std::string& name);

std::vector<std::string> figureDataFiles();

}  // namespace rubber_suspension::diagnosis::report
