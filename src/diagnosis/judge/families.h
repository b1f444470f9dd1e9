// Laws that contain a simpler one: the larger one has to earn its numbers.
#pragma once

#include "diagnosis/judge/criteria.h"
#include "diagnosis/judge/evidence.h"

namespace rubber_suspension::diagnosis {

/// Where a hypothesis has an effect whose law contains a simpler effect (Evidence::contains), and the same hypothesis
/// with the simpler one in its place leaves about as much, the larger one counts as leaving a little more; likewise one
/// with a trend for each log after all of as many effects without that leave about as much, and one with an effect that
/// can look like several others (HypothesisEvidence::last_resort) after all without, however many effects they have.
/// About as much: it does not err less by more than one standard error (Weighing::errsLess).
void settleFamilies(Evidence& evidence, const Criteria& criteria);

}  // namespace rubber_suspension::diagnosis
