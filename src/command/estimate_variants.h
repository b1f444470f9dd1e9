// Variants of a component for `estimate`: other models of the same specification, inputs a little off.
#pragma once

#include <string>
#include <vector>

#include "command/estimate.h"

namespace rubber_suspension::command {

/// The component's specification in each of these models: M1 to M6, the names of a component file, or a whole number of
/// Maxwell elements. A model takes from the specification the numbers that it asks for, of alternatives the first that
/// is there. A loss angle, break frequency or high frequency that is missing follows from the component, which `notes`
/// say. Throws std::invalid_argument for another name, and where a number is missing or there is no solution.
std::vector<io::ComponentDescription> inModels(const io::ComponentDescription& description,
                                               const std::vector<std::string>& models, std::vector<std::string>& notes);

/// Add to a report what a change of each input by this share [-] does to stiffness and loss angle over frequency.
void addSensitivity(EstimateReport& report, double share);

/// CSV of all sweeps in SI units: f, A, K, loss angle, K' = K cos(delta), K'' = K sin(delta), K_e = K' and
/// C_e = K''/omega of Polach (IAVSD 2015) Eq. 12, settled or not, sweep, component. `estimate --from-table` reads it.
std::string toCsv(const std::vector<EstimateReport>& reports);

}  // namespace rubber_suspension::command
