// The section of a report on the table that it was made from.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// HTML: what no table shows, and every row, measured and simulated.
std::string tableSection(const Diagnosis& diagnosis);

/// The same for report.json.
nlohmann::ordered_json tableJson(const DiagnosedTable& table);

}  // namespace rubber_suspension::diagnosis
