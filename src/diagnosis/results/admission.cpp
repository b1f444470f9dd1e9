// Description of the logs.
#include "diagnosis/results/admission.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::diagnosis::results {
namespace {

// Share of a log whose displacement repeats what it did one period before, the period being where the displacement
// resembles itself best; repeats let noise be told from error without a model.
double repeatsOf(const log::Record& record) {
  constexpr double kSame = 0.05;  // difference over standard deviation that counts as a repeat
  constexpr Eigen::Index kCoarse = 1024;
  const Eigen::Index stride = std::max<Eigen::Index>(1, record.size() / kCoarse);
  const Eigen::Index count = record.size() / stride;
  Eigen::VectorXd z(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    z[i] = record.displacement[i * stride];
  }
  z.array() -= z.mean();
  const double standard_deviation = std::sqrt(z.squaredNorm() / static_cast<double>(count));
  double best = 0.0;
  for (Eigen::Index lag = 4; lag < count / 2; ++lag) {
    const Eigen::Index rest = count - lag;
    const Eigen::ArrayXd difference = (z.tail(rest) - z.head(rest)).array().abs();
    const auto same = (difference < kSame * standard_deviation).count();
    best = std::max(best, static_cast<double>(same) / static_cast<double>(count));
  }
  return best;
}

}  // namespace

Admission admit(const log::Record& record, bool hold_out, double noise, const LogAccount& account) {
  Admission admission;
  admission.log = record.name;
  admission.hold_out = hold_out;
  admission.duration = record.duration();
  admission.dt = record.dt;
  admission.largest_displacement = record.displacement.cwiseAbs().maxCoeff();
  admission.highest_frequency = record.highest_frequency;
  admission.noise = noise;
  admission.repeats = repeatsOf(record);
  admission.recorded = std::sqrt(account.recorded());
  admission.left = std::sqrt(account.left());
  admission.notes = record.notes;
  return admission;
}

}  // namespace rubber_suspension::diagnosis::results
