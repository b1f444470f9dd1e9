// Surrogate of a component for the rest that no effect explains.
#include "diagnosis/results/surrogate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagnosis/judge/paired_losses.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kChanceOfGain = 0.05;  // of a gain on unseen blocks without there being any
constexpr std::size_t kFewestLogs = 3;  // whose scatter from log to log can be told

// Tenths of logs that took no part in any fit, as further logs.
void addHeldOut(const io::ComponentDescription& component, const io::ComponentDescription& with_surrogate,
                const std::vector<log::Record>& held_out, int first, std::vector<fit::UnseenBlock>& unseen) {
  for (std::size_t r = 0; r < held_out.size(); ++r) {
    const std::vector<log::Record> one = {held_out[r]};
    const auto before = gap::partErrors(one, gap::simulateEach(component.allElements(), one));
    const auto after = gap::partErrors(one, gap::simulateEach(with_surrogate.allElements(), one));
    for (std::size_t p = 0; p < before.size(); ++p) {
      unseen.push_back({first + static_cast<int>(r), before[p].weight, before[p].error, after[p].error});
    }
  }
}

Losses lossesOf(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs) {
  Losses losses;
  const auto count = static_cast<Eigen::Index>(unseen.size());
  Eigen::MatrixXd errors(2, count);
  losses.weight.resize(count);
  for (Eigen::Index b = 0; b < count; ++b) {
    const fit::UnseenBlock& block = unseen[static_cast<std::size_t>(b)];
    errors.col(b) << block.after, block.before;
    losses.weight[b] = block.weight;
    losses.cluster.push_back(count_logs ? block.record : static_cast<int>(b));
  }
  losses.loss = logarithmicLoss(errors, std::pow(noise_floor, 2));
  return losses;
}

}  // namespace

bool needsSurrogate(Verdict verdict) { return verdict == Verdict::unknown || verdict == Verdict::partly; }

void judgeRest(const std::vector<fit::UnseenBlock>& unseen, double noise_floor, bool count_logs, Surrogate& surrogate) {
  double weight = 0.0;
  double before = 0.0;
  double after = 0.0;
  for (const fit::UnseenBlock& block : unseen) {
    weight += block.weight;
    before += block.weight * block.before;
    after += block.weight * block.after;
  }
  surrogate.unseen_before = std::sqrt(before / weight);
  surrogate.unseen_after = std::sqrt(after / weight);
  // What is left where nothing was fitted is no less than the noise: a floor above it is not known.
  const double floor = noise_floor < surrogate.unseen_after ? noise_floor : 0.0;
  const double rest = gap::residualAboveFloor(surrogate.unseen_before, floor);
  const double left = gap::residualAboveFloor(surrogate.unseen_after, floor);
  surrogate.share = rest > 0.0 ? std::clamp(1.0 - std::pow(left / rest, 2), 0.0, 1.0) : 0.0;
  surrogate.chance = compare(lossesOf(unseen, noise_floor, count_logs), 0, 1).pValueOfNoGain();
  surrogate.function_of_the_motion = surrogate.chance < kChanceOfGain && surrogate.share > Criteria().larger_part;
}

FittedSurrogate fitSurrogate(const io::ComponentDescription& component, const SurrogateLogs& logs, int threads) {
  const fit::SurrogateFit fit = fit::fitSurrogate(logs.training, logs.force, threads);
  FittedSurrogate fitted;
  fitted.component = component;
  fitted.component.add.push_back(fit.element);
  std::copy_if(fit.unseen.begin(), fit.unseen.end(), std::back_inserter(fitted.of_logs),
               [](const fit::UnseenBlock& block) { return block.weight > 0.0; });
  const double share = static_cast<double>(logs.training.size());
  for (fit::UnseenBlock& block : fitted.of_logs) {  // each log counts 1, as those held out do
    block.weight *= share;
    block.after = fit.predicts ? block.after : block.before;
  }
  addHeldOut(component, fitted.component, logs.held_out, static_cast<int>(logs.training.size()), fitted.of_held_out);
  fitted.count_logs = logs.training.size() + logs.held_out.size() >= kFewestLogs;
  return fitted;
}

Surrogate judgeSurrogate(FittedSurrogate fitted, double noise_floor) {
  std::vector<fit::UnseenBlock> unseen = std::move(fitted.of_logs);
  unseen.insert(unseen.end(), fitted.of_held_out.begin(), fitted.of_held_out.end());
  Surrogate surrogate;
  surrogate.component = std::move(fitted.component);
  judgeRest(unseen, noise_floor, fitted.count_logs, surrogate);
  return surrogate;
}

double shareOfMotion(const FittedSurrogate& fitted, double noise_floor) {
  Surrogate of_logs;
  judgeRest(fitted.of_logs, noise_floor, fitted.count_logs, of_logs);
  return std::max(of_logs.share, judgeSurrogate(fitted, noise_floor).share);
}

std::string describeRest(const Surrogate& surrogate) {
  const std::string prediction =
      fmt::format("a surrogate predicts {:.0f} % of it where it was not fitted (gap {:.1f} to {:.1f} %)",
                  100.0 * surrogate.share, 100.0 * surrogate.unseen_before, 100.0 * surrogate.unseen_after);
  if (surrogate.function_of_the_motion) {
    return "The rest is a function of the motion that is not in the list: " + prediction + ".";
  }
  if (surrogate.chance < kChanceOfGain && surrogate.share > 0.0) {
    return "Only part of the rest is a function of the motion: " + prediction +
           "; most of it the motion does not cause (hum, cross-talk, a connector), or it needs other logs to be "
           "learned.";
  }
  return "The rest is not seen to be a function of the motion, since no surrogate predicts it where it was not fitted: "
         "look for what the motion does not cause (hum, cross-talk, a connector).";
}

}  // namespace rubber_suspension::diagnosis
