// The candidate effects, one file each in src/diagnosis/candidate.
#pragma once

#include "rubber_suspension/diagnosis/candidate.h"

namespace rubber_suspension {

Candidate frictionCandidate(const Excitation& excitation);
Candidate relaxationCandidate(const Excitation& excitation);
Candidate creepCandidate(const Excitation& excitation);
Candidate viscousDampingCandidate(const Excitation& excitation);
Candidate progressiveStiffnessCandidate(const Excitation& excitation);
Candidate asymmetricStiffnessCandidate(const Excitation& excitation);
Candidate bumpStopCandidate(const Excitation& excitation);
Candidate freePlayCandidate(const Excitation& excitation);
Candidate stressSofteningCandidate(const Excitation& excitation);
Candidate selfHeatingCandidate(const Excitation& excitation);
Candidate seriesComplianceCandidate(const Excitation& excitation);
Candidate inertiaCandidate(const Excitation& excitation);
Candidate timeDelayCandidate(const Excitation& excitation);
Candidate forceOffsetCandidate(const Excitation& excitation);
Candidate forceDriftCandidate(const Excitation& excitation);
Candidate rateAmplitudeCouplingCandidate(const Excitation& excitation);

/// Bandwidth [Hz] with which an inertia that is driven by the displacement as recorded errs least; 0: none is needed.
double massBandwidth(const std::vector<Record>& records, double highest_frequency);

}  // namespace rubber_suspension
