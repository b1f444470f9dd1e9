// The output of `estimate --from-log`: parameters found from measured logs, their intervals, what the logs do not tell.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::command {

/// Identify the elements of a component, estimated ones and those added, from logs that all have a measured force. The
/// break frequencies of multi_maxwell are kept: they spread the elements over the range, and with them kept the
/// stiffnesses have a unique best fit. Errors of the rig are found as well and reported in the notes: spikes and held
/// values, force offsets that differ between logs, starts in motion. Throws std::invalid_argument, LogError for a log
/// without force.
fit::Identification identifyFromLogs(const io::ComponentDescription& description, const std::vector<log::Log>& logs,
                                     fit::IdentificationOptions options);

/// The component with the values found, as a list of elements.
io::ComponentDescription identifiedComponent(const io::ComponentDescription& description,
                                             const fit::Identification& result);

std::string toText(const std::string& component, const fit::Identification& result);

/// {"schema": "rubber_suspension/identification/1", ...}; a limit that is infinite is null.
std::string toJson(const std::string& component, const fit::Identification& result);

/// Measured and fitted loop, and the residual over time, of every log.
io::Figure identificationFigure(const io::ComponentDescription& description, const fit::Identification& result,
                                const std::vector<log::Log>& logs);

}  // namespace rubber_suspension::command
