// Bandwidth of the inertia element for noisy displacements.
#include "fit/mass_bandwidth.h"

#include "gap/simulate.h"

namespace rubber_suspension::fit {
namespace {

// The error of the node, from the displacement as recorded and without samples to come: sum of mean squares per mass,
// in units of the logs' forces. The start of a log, where the motion sets in with a jerk, does not count.
double errorInTime(const std::vector<log::Record>& records, double bandwidth) {
  const auto in_time =
      gap::simulate({{"inertia", {{"mass", {1.0}}, {"bandwidth", {bandwidth}}}}}, records, gap::asRecorded);
  double sum = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::Index settled = records[r].size() - records[r].size() / 20;
    const Eigen::VectorXd error = (in_time[r] - acceleration(records[r])).tail(settled) / records[r].force_deviation;
    sum += error.squaredNorm() / static_cast<double>(settled);
  }
  return sum;
}

}  // namespace

Eigen::VectorXd acceleration(const log::Record& record) {
  const Eigen::Index inner = record.size() - 2;
  const Eigen::VectorXd& z = record.displacement;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(record.size());
  result.segment(1, inner) = (z.head(inner) - 2.0 * z.segment(1, inner) + z.tail(inner)) / (record.dt * record.dt);
  return result;
}

double massBandwidth(const std::vector<log::Record>& records, double highest_frequency) {
  double best = 0.0;
  double least = errorInTime(records, best);
  for (const double multiple : {1.0, 1.5, 2.2, 3.3, 5.0, 7.5, 11.0, 16.0}) {
    const double bandwidth = multiple * highest_frequency;
    const double error = errorInTime(records, bandwidth);
    if (error < least) {
      least = error;
      best = bandwidth;
    }
  }
  return best;
}

}  // namespace rubber_suspension::fit
