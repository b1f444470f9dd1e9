// The candidate effects, one file each in src/diagnosis/candidate.
#pragma once

#include "rubber_suspension/fit/candidate.h"

namespace rubber_suspension::diagnosis {

fit::Candidate frictionCandidate(const fit::Excitation& excitation);
fit::Candidate relaxationCandidate(const fit::Excitation& excitation);
fit::Candidate creepCandidate(const fit::Excitation& excitation);
fit::Candidate viscousDampingCandidate(const fit::Excitation& excitation);
fit::Candidate progressiveStiffnessCandidate(const fit::Excitation& excitation);
fit::Candidate asymmetricStiffnessCandidate(const fit::Excitation& excitation);
fit::Candidate bumpStopCandidate(const fit::Excitation& excitation);
fit::Candidate freePlayCandidate(const fit::Excitation& excitation);
fit::Candidate stressSofteningCandidate(const fit::Excitation& excitation);
fit::Candidate selfHeatingCandidate(const fit::Excitation& excitation);
fit::Candidate seriesComplianceCandidate(const fit::Excitation& excitation);
fit::Candidate inertiaCandidate(const fit::Excitation& excitation);
fit::Candidate timeDelayCandidate(const fit::Excitation& excitation);
fit::Candidate forceOffsetCandidate(const fit::Excitation& excitation);
fit::Candidate forceDriftCandidate(const fit::Excitation& excitation);
fit::Candidate rateAmplitudeCouplingCandidate(const fit::Excitation& excitation);

/// Bandwidth [Hz] with which an inertia that is driven by the displacement as recorded errs least; 0: none is needed.
double massBandwidth(const std::vector<log::Record>& records, double highest_frequency);

}  // namespace rubber_suspension::diagnosis
