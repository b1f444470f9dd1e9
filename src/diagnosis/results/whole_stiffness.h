// Stiffness and loss angle of the whole component where its specification says them, before and after.
#pragma once

#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::results {

/// Of the rubber, without what belongs to the rig. At the nominal frequency and amplitude of `before`. Without such a
/// frequency it is the median of the mean frequencies of the logs; without such an amplitude the median amplitude of
/// the logs within an octave of the frequency, or of all where there is none. The loop is that of cycle 20, or an
/// earlier one on which it has settled.
std::optional<WholeStiffness> wholeStiffness(const io::ComponentDescription& before,
                                             const io::ComponentDescription& after,
                                             const std::vector<log::Record>& logs);

}  // namespace rubber_suspension::diagnosis::results
