// Figures of a report on a table.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/report/report_figures.h"

namespace rubber_suspension::diagnosis {

/// Stiffness, where the gap lies, and loss angle, in this order.
std::vector<ReportFigure> tableFigures(const Diagnosis& diagnosis);

/// Their names, but for that of the map, which reports on logs have as well.
std::vector<std::string> tableFigureNames();

}  // namespace rubber_suspension::diagnosis
