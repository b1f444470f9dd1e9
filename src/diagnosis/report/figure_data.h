// The numbers behind a figure of the report.
#pragma once

#include <string>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::diagnosis {

/// CSV of all curves of a figure, one point a row: curve, panel, and the two values under their axes' labels. Of a map:
/// curve, panel, the edges of the cell and its value. What a figure leaves blank is left out.
std::string figureCsv(const io::Figure& figure);

}  // namespace rubber_suspension::diagnosis
