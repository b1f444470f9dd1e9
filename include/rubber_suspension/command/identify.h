// What `estimate --from-log` shows: parameters found from measured logs, their intervals, what the logs do not tell.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/estimation/identification.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/io/log.h"

namespace rubber_suspension {

/// Identify the elements of a component, estimated ones and those added, from logs that all have a measured force.
/// The break frequencies of multi_maxwell are kept: they spread the elements over the range, and with them kept the
/// stiffnesses have a unique best fit. Throws std::invalid_argument, LogError for a log without force.
Identification identifyFromLogs(const ComponentDescription& description, const std::vector<Log>& logs,
                                IdentificationOptions options);

/// The component with the values found, as a list of elements.
ComponentDescription identifiedComponent(const ComponentDescription& description, const Identification& result);

std::string toText(const std::string& component, const Identification& result);

/// {"schema": "rubber_suspension/identification/1", ...}; a limit that is infinite is null.
std::string toJson(const std::string& component, const Identification& result);

/// Measured and fitted loop, and the residual over time, of every log.
Figure identificationFigure(const ComponentDescription& description, const Identification& result,
                            const std::vector<Log>& logs);

}  // namespace rubber_suspension
