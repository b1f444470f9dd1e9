// The figures of the report.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::diagnosis {

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

/// Name of the file with the numbers of a figure.
std::string figureDataFile(const std::string& name);

/// Those of all figures.
std::vector<std::string> figureDataFiles();

}  // namespace rubber_suspension::diagnosis
