// The report of `estimate --from-log`: identified parameters, their intervals, and what remains undetermined.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::command {

/// Identifies the elements of a component, including those under `add`, from logs with measured forces. The break
/// frequencies of multi_maxwell are kept fixed: they are spread over the frequency range, and then the stiffnesses have
/// a unique best fit. Spikes and held values, force offsets that differ between logs, and starts in motion are
/// corrected and reported in the notes. Throws std::invalid_argument, and LogError for a log without force.
fit::Identification identifyFromLogs(const io::ComponentDescription& description, const std::vector<log::Log>& logs,
                                     fit::IdentificationOptions options);

/// Returns the component with the identified values, as a list of elements.
io::ComponentDescription identifiedComponent(const io::ComponentDescription& description,
                                             const fit::Identification& result);

std::string toText(const std::string& component, const fit::Identification& result);

/// Returns JSON {"schema": "rubber_suspension/identification/1", ...}. Infinite limits of intervals are null.
std::string toJson(const std::string& component, const fit::Identification& result);

/// Returns a figure that shows for each log the measured and the fitted loop, and the residual force over time.
io::Figure identificationFigure(const io::ComponentDescription& description, const fit::Identification& result,
                                const std::vector<log::Log>& logs);

}  // namespace rubber_suspension::command
