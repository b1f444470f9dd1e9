// Specifications drawn within their tolerances, for a Monte Carlo study.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "campaign/jobs_file.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::campaign {

/// The drawn numbers of each run, by name [SI]. The same seed gives the same draws on every machine, and more runs
/// begin with those of fewer: 53 bits of a Mersenne Twister per number, in the order of the names; a normal one by the
/// inverse of its distribution. Throws std::invalid_argument for a tolerance of a number that is not specified.
std::vector<std::map<std::string, double>> drawSpecifications(const estimation::Specification& nominal,
                                                              const MonteCarlo& study);

}  // namespace rubber_suspension::campaign
