// The yardstick of search and verdict: what a hypothesis leaves beyond the noise floor. All in units of the force's
// standard deviation.
#pragma once

#include "rubber_suspension/diagnosis/search.h"

namespace rubber_suspension::diagnosis {

/// What an error (RMS) is beyond the noise floor.
double excess(const Search& search, double error);

/// What a fitted hypothesis leaves beyond the noise floor, the price of moved own parameters included.
double excess(const Search& search, const Trial& trial);

/// An excess below this cannot be told from noise and discretisation.
double insignificant(const Search& search);

/// An excess below this calls for no further effect.
double enough(const Search& search);

/// The single effect of the least excess, among those without a free trend if `trends` is false; none where there is
/// none.
const Trial* bestSingle(const Search& search, bool trends = true);

/// True if the fits to these logs may be relied on to show an effect: a typical size of it would stand out, or what was
/// fitted does.
bool shows(const Search& search, int candidate);

/// True if re-estimated own parameters leave next to nothing of the gap.
bool closedByOwnParameters(const Search& search);

/// The effect that re-estimation may hide, if any: one number more explains as much, with own parameters close to the
/// configured ones, as re-estimation does that has to move several far. Effects of more numbers are no simpler.
const Trial* hiddenEffect(const Search& search);

}  // namespace rubber_suspension::diagnosis
