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

/// Loops, map of the gap, residual over displacement and gap over time; the log with the largest gap comes first. None
/// where there is nothing to show. Where the logs cannot be what they say, their loops as they are and with the
/// correction that is proposed.
std::vector<ReportFigure> reportFigures(const Diagnosis& diagnosis);

/// Figures of a report on a table: stiffness, place of the gap, and loss angle, in this order.
std::vector<ReportFigure> tableFigures(const Diagnosis& diagnosis);

/// Share of the squared gap over cells between these edges [Hz, m]: each is where the middle of its band lies. Without
/// axes where the edges have nothing between them.
io::Figure shareMap(const std::vector<gap::GapCell>& cells, const std::vector<double>& frequencies,
                    const std::vector<double>& amplitudes);

/// Lowest and highest frequency that the logs excite [Hz]; both 0 where that is not known.
std::array<double, 2> excitedBand(const Diagnosis& diagnosis);

/// Values in their order, those once that are the same.
std::vector<double> sortedApart(std::vector<double> values);

/// The diagnosis on one page, as `diagnose --plot` draws it: the report's figures, each for one log, which is the first
/// hold-out or, without hold-outs, that of the largest gap.
io::Figure overviewFigure(const Diagnosis& diagnosis);

/// CSV of all curves of a figure, one point a row: curve, panel, and the two values under their axes' labels. Of a map:
/// curve, panel, the edges of the cell and its value. What a figure leaves blank is left out.
std::string figureCsv(const io::Figure& figure);

/// Returns the description of a figure without its numbers, which are in its file.
nlohmann::ordered_json figureJson(const ReportFigure& figure);

/// Name of the file with the numbers of a figure.
std::string figureDataFile(const std::string& name);

/// Names of the files of all figures.
std::vector<std::string> figureDataFiles();

}  // namespace rubber_suspension::diagnosis::report
