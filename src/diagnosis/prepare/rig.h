// The rig's part in the logs of a diagnosis: what is taken out before any effect is weighed, and what is told of it.
#pragma once

#include <optional>
#include <vector>

#include "fit/model_parameters.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis {

/// Free the nuisances of each record (Record::nuisances), the zero of the force among them. The model is re-estimated
/// for what a motion before a log left in the component, and for how much each log counts (weighByNoise()).
void freeNuisances(const fit::ModelParameters& model, const io::RigTolerances& tolerances,
                   std::vector<log::Record>& training, std::vector<log::Record>& held_out);

/// Mean of the zeros of the force that a model leaves [N], where they are a cause: beyond the rig's tolerance, and what
/// Berg's friction may start with, in all logs, those held out among them, or common to them, which zeros that nobody
/// set are not; and more than `least` as a gap.
std::optional<double> zeroWithCause(const std::vector<element::ElementDescription>& elements, double least,
                                    const io::RigTolerances& tolerances, const std::vector<log::Record>& training,
                                    const std::vector<log::Record>& held_out);

/// Let the zero of the force count: it is no nuisance any more. Of the zeros that a model leaves, what is not common to
/// all logs is the rig's, and taken out.
void countZeros(const std::vector<element::ElementDescription>& elements, double common,
                const io::RigTolerances& tolerances, std::vector<log::Record>& training,
                std::vector<log::Record>& held_out);

/// What a model leaves of records once both zeros of each log are free, in units of the force's standard deviation.
double leftWithoutZeros(const std::vector<element::ElementDescription>& elements, const io::RigTolerances& tolerances,
                        const std::vector<log::Record>& records);

/// What the rig did to the displacement of one record, by what a model leaves of its force.
struct RigPart {
  double displacement_zero = 0.0;  ///< by which it is too high, where that shows beyond chance [m]
  double delay = 0.0;              ///< of the force behind it [s]
  bool shows_delay = false;        ///< whether the delay is beyond chance, and within the rig's tolerance
  std::vector<measurement::RigFinding> findings;
};

std::vector<RigPart> rigParts(const std::vector<element::ElementDescription>& elements,
                              const io::RigTolerances& tolerances, const std::vector<log::Record>& records);

/// The delay that all logs have in common [s], 0 where they do not: it may be a cause, and is left to the effects.
double commonDelay(const std::vector<RigPart>& parts);

/// Take zeros, and what delays differ by from a common one, out of the displacements; true if there are any.
bool takeOut(const std::vector<RigPart>& parts, double common_delay, std::vector<log::Record>& records);

/// What the rig did to each record, by what a model leaves of it.
std::vector<measurement::RigFinding> rigFindings(const std::vector<element::ElementDescription>& elements,
                                                 const io::RigTolerances& tolerances,
                                                 const std::vector<log::Record>& records);

}  // namespace rubber_suspension::diagnosis
