// The list of candidate effects.
#include "rubber_suspension/diagnosis/candidate/catalogue.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::fit {

Excitation summarise(const std::vector<log::Record>& records) {
  Excitation result;
  double force_power = 0.0;
  double displacement_power = 0.0;
  for (const log::Record& record : records) {
    const auto count = static_cast<double>(record.size());
    const Eigen::ArrayXd centred = record.displacement.array() - record.displacement.mean();
    const Eigen::Index steps = record.size() - 1;
    const Eigen::ArrayXd rate = (record.displacement.tail(steps) - record.displacement.head(steps)).array() / record.dt;
    result.largest_displacement = std::max(result.largest_displacement, record.displacement.cwiseAbs().maxCoeff());
    result.highest_frequency = std::max(result.highest_frequency, record.highest_frequency);
    result.highest_rate = std::max(result.highest_rate, rate.abs().maxCoeff());
    result.longest_duration = std::max(result.longest_duration, record.duration());
    result.dt = std::max(result.dt, record.dt);
    result.power = std::max(result.power, (rate * record.force.tail(steps).array()).abs().mean());
    force_power += std::pow(record.force_deviation, 2) * count;
    displacement_power += centred.square().sum();
    result.force = std::max(result.force, record.force_deviation);
  }
  result.stiffness = std::sqrt(force_power / displacement_power);
  result.mass_bandwidth = diagnosis::massBandwidth(records, result.highest_frequency);
  return result;
}

Atom additiveAtom(const std::string& type, const std::string& scaled, double typical,
                  const element::ParameterValues& others) {
  Atom atom;
  atom.typical = typical;
  atom.at = [=](double scale) {
    element::ElementDescription description{type, others};
    description.values[scaled] = {scale};
    return description;
  };
  return atom;
}

std::vector<Candidate> candidates(const Excitation& excitation) {
  return {
      diagnosis::frictionCandidate(excitation),
      diagnosis::relaxationCandidate(excitation),
      diagnosis::creepCandidate(excitation),
      diagnosis::viscousDampingCandidate(excitation),
      diagnosis::progressiveStiffnessCandidate(excitation),
      diagnosis::asymmetricStiffnessCandidate(excitation),
      diagnosis::bumpStopCandidate(excitation),
      diagnosis::freePlayCandidate(excitation),
      diagnosis::stressSofteningCandidate(excitation),
      diagnosis::selfHeatingCandidate(excitation),
      diagnosis::seriesComplianceCandidate(excitation),
      diagnosis::inertiaCandidate(excitation),
      diagnosis::timeDelayCandidate(excitation),
      diagnosis::forceOffsetCandidate(excitation),
      diagnosis::forceDriftCandidate(excitation),
      diagnosis::rateAmplitudeCouplingCandidate(excitation),
  };
}

}  // namespace rubber_suspension::fit
