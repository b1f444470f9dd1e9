// The output of `estimate --from-log`: identified parameters, their intervals, and directions that remain undetermined.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::command {

/// Identifies the elements of a component, estimated and added ones, from logs with measured forces. The break
/// frequencies of multi_maxwell are held: they are spread over the range, and for fixed break frequencies the
/// stiffnesses have a unique best fit. Errors of the rig are corrected and reported in the notes: spikes and held
/// values, force offsets that differ between logs, starts in motion. Throws std::invalid_argument, and LogError for a
/// log without force.
fit::Identification identifyFromLogs(const io::ComponentDescription& description, const std::vector<log::Log>& logs,
                                     fit::IdentificationOptions options);

/// Returns the component with the identified values, as a list of elements.
io::ComponentDescription identifiedComponent(const io::ComponentDescription& description,
                                             const fit::Identification& result);

std::string toText(const std::string& component, const fit::Identification& result);

/// Returns {"schema": "rubber_suspension/identification/1", ...}; infinite limits are null.
std::string toJson(const std::string& component, const fit::Identification& result);

/// Returns a figure of the measured and fitted loop, and of the residual over time, of every log.
io::Figure identificationFigure(const io::ComponentDescription& description, const fit::Identification& result,
                                const std::vector<log::Log>& logs);

}  // namespace rubber_suspension::command
