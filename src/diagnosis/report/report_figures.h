// The figures of the report.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::diagnosis {

/// Loops, map of the gap, residual over displacement and over time; each of them one figure.
std::vector<io::Figure> reportFigures(const Diagnosis& diagnosis);

}  // namespace rubber_suspension::diagnosis
