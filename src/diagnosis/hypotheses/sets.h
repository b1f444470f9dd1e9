// Sets of effects that are compared with a set: each a list of places of candidates, ascending.
#pragma once

#include <vector>

#include "fit/candidate.h"

namespace rubber_suspension::diagnosis {

using Sets = std::vector<std::vector<int>>;

/// For each effect the places of simpler ones that its law contains.
Sets containedIn(const std::vector<fit::Candidate>& candidates);

/// A set with a simpler law in the place of each that contains one: as many effects, fewer numbers.
Sets withSimplerLaws(const std::vector<int>& members, const Sets& contained);

/// A set with all the simpler laws in the place of one that contains several, none of which contains another: one
/// effect more, and each may be stronger than the one law allows.
Sets withLawsApart(const std::vector<int>& members, const Sets& contained);

/// A set without each of its members in turn.
Sets withoutOne(const std::vector<int>& members);

}  // namespace rubber_suspension::diagnosis
