// Finds logs whose gain or offset differs from that of most logs.
#include "diagnosis/results/own_errors.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/hypotheses/fitted_component.h"
#include "element/each.h"
#include "gap/simulate.h"
#include "rubber_suspension/measurement/prepared_log.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::diagnosis::results {
namespace {

// Returns the gain of each record relative to the simulated force, without a tolerance on the gain.
std::vector<double> gainsBeside(const gap::Forces& simulated, std::vector<gap::PreparedRecord> records,
                                const io::RigTolerances& tolerances) {
  for (gap::PreparedRecord& record : records) {
    record.own.gain = true;
  }
  const measurement::RigModel rig(records, element::each(records, measurement::maskOf), tolerances);
  const std::vector<measurement::RigColumns> columns = rig.columns(simulated, {});
  std::vector<double> gains;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const measurement::RigFit fit = rig.fit(r, columns[r], 0);
    gains.push_back(fit.values[fit.column(measurement::Nuisance::gain)]);
  }
  return gains;
}

}  // namespace

std::vector<bool> unlikeMost(const std::vector<double>& values, double alike) {
  const auto likeOne = [&](double one) {
    return std::count_if(values.begin(), values.end(), [&](double value) { return std::abs(value - one) <= alike; });
  };
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted[(sorted.size() - 1) / 2];  // near the value that most logs have, if there is one
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const bool any = 2 * likeOne(middle) > count;
  const double limit = likeOne(middle) == count ? 0.0 : alike;
  return element::each(values, [&](double value) { return !any || std::abs(value - middle) > limit; });
}

std::vector<gap::OwnErrors> ownErrors(const hypotheses::PreparedCase& prepared,
                                      const hypotheses::FittedHypothesis& judged) {
  const fit::PerLogNuisances& free = judged.hypothesis.free_in_log;
  if (!free.gain && !free.offset) {
    return {};
  }
  std::vector<gap::PreparedRecord> records = prepared.training;
  records.insert(records.end(), prepared.held_out.begin(), prepared.held_out.end());
  std::vector<gap::OwnErrors> own = element::each(records, [&](const gap::PreparedRecord& record) -> gap::OwnErrors {
    return {record.own.gain, record.own.zero || free.offset};
  });
  if (free.gain) {
    const auto elements = hypotheses::augmentedDescription(prepared.model, judged).allElements();
    const io::RigTolerances tolerances = prepared.component.rig.value_or(io::RigTolerances{});
    gap::Forces forces = gap::simulate(elements, prepared.training);
    const gap::Forces unseen = gap::simulateEach(elements, prepared.held_out, {});
    forces.insert(forces.end(), unseen.begin(), unseen.end());
    const double alike = std::sqrt(2.0) * io::kTolerated *
                         tolerances.gain.value;  // largest difference of two gains that are within their tolerances
    const std::vector<bool> unlike = unlikeMost(gainsBeside(forces, records, tolerances), alike);
    for (std::size_t r = 0; r < own.size(); ++r) {
      own[r].gain = own[r].gain || unlike[r];
    }
  }
  const bool nothing_new =
      std::equal(own.begin(), own.end(), records.begin(), [](const auto& found, const auto& record) {
        return found.gain == record.own.gain && found.zero == record.own.zero;
      });
  return nothing_new ? std::vector<gap::OwnErrors>() : own;
}

}  // namespace rubber_suspension::diagnosis::results
