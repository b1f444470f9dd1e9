// Compliances and contacts in series with the test piece, and the resulting displacement.
#include "rubber_suspension/component/series_balance.h"

#include <algorithm>
#include <cmath>

#include "component/series_root.h"

namespace rubber_suspension::component {
namespace {

// Adds a compliance to `sum`. An infinite compliance is a contact, which opens beyond its preload.
void addSide(double compliance, double preload, double& sum, double& opens) {
  const bool finite = std::isfinite(compliance);
  sum += finite ? compliance : 0.0;
  opens = finite ? opens : std::min(opens, preload);
}

}  // namespace

void SeriesBalance::add(const std::shared_ptr<const element::SeriesElement>& element) {
  empty_ = false;
  if (const auto compliance = element->compliance()) {
    addSide(compliance->tension, compliance->preload, sides_.tension, tension_opens_);
    addSide(compliance->compression, compliance->preload, sides_.compression, compression_opens_);
  } else {
    hardening_.push_back(element);
  }
}

double SeriesBalance::deflection(double force) const {
  double sum = sideCompliance(force) * force;
  for (const auto& element : hardening_) {
    sum += element->deflection(force);
  }
  return sum;
}

double SeriesBalance::search(const kernel::BasicLawsKernel& laws, const kernel::LinearForce& linear,
                             const element::Motion& path, double start, const double* memory) const {
  const double guess = start + path.increment;
  if (!hardening_.empty()) {
    return solveSeriesBalance(
        [&](double z) { return z + deflection(linear.at(z) + laws.frictionAt(z, memory)) - path.displacement; }, guess);
  }
  const Equation equation = equationOf(laws, linear, path, memory);
  return solveSeriesBalance(
      [&](double z) { return equation.slope * z + equation.offset + equation.compliance * laws.frictionAt(z, memory); },
      guess, equation.slope);
}

}  // namespace rubber_suspension::component
