// Computes errors of components that are driven by the displacement as recorded.
#include "diagnosis/results/replayed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnosis/hypotheses/unseen_logs.h"
#include "fit/parallel.h"
#include "gap/log_driver.h"
#include "gap/simulate.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {
namespace {

std::vector<gap::PartError> heldOutErrors(const fit::Hypothesis& hypothesis, const Entries& elements,
                                          const std::vector<gap::PreparedRecord>& held_out) {
  return hypotheses::unseenErrors(hypothesis, elements, gap::simulateEach(elements, held_out), held_out);
}

// Returns the errors of a replay plus, for each block, the increase of the error if the fit omits the block. Summed
// over a log, the result is never less than the error of the replay, even if the held-out error of a short log happens
// to be smaller than the error of the fit.
std::vector<gap::PartError> errorsOfTheFit(const fit::Fitter& fitter, const FittedLaw& fitted,
                                           const Entries& elements) {
  const std::vector<gap::PreparedRecord>& records = fitter.records();
  const fit::Hypothesis hypothesis = fitted.law.hypothesis();
  // Unlike partErrorsOf(), unseenErrors() computes the effect of displacement offsets on the force of these elements.
  const std::vector<double> none(records.size(), 0.0);
  const std::vector<double> replay = hypotheses::errorsByLog(
      hypotheses::unseenErrors(hypothesis, elements, gap::simulate(elements, records, gap::asRecorded), records), none);
  const gap::Forces fit = *fitter.forces().at(hypothesis, fitted.fit.parameters);
  const std::vector<double> of_fit = hypotheses::errorsByLog(hypotheses::partErrorsOf(hypothesis, records, fit), none);
  std::vector<gap::PartError> blocks = fitted.fit.blocks;
  const std::vector<double> unseen = hypotheses::errorsByLog(blocks, none);
  for (gap::PartError& block : blocks) {
    const auto log = static_cast<std::size_t>(block.log);
    const double error = block.error + replay[log] - std::min(of_fit[log], unseen[log]);
    block.error = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(0.0, error);
  }
  return blocks;
}

using Piece = log::EvenBlocks::Piece;

bool isCounted(const Piece& piece, std::size_t i) { return piece.counts == nullptr || piece.counts[i] > 0.0; }

// Computes the sum of the squared deviations of a force from its mean, piece by piece. The first force is subtracted
// from all forces to avoid rounding errors.
class Deviation {
 public:
  void add(const Piece& piece) {
    for (std::size_t i = 0; i < piece.samples; ++i) {
      if (!isCounted(piece, i)) {
        continue;
      }
      offset_ = count_ == 0.0 ? piece.force[i] : offset_;
      const double force = piece.force[i] - offset_;
      sum_ += force;
      squares_ += force * force;
      count_ += 1.0;
    }
  }

  double sumOfSquares() const { return squares_ - sum_ * sum_ / count_; }

 private:
  double offset_ = 0.0;
  double sum_ = 0.0;
  double squares_ = 0.0;
  double count_ = 0.0;
};

// A component that several logs drive in turn, and its sum of squared residuals on the current log.
struct ReplayedModel {
  explicit ReplayedModel(const Entries& elements) : driver(elements) {}

  void add(const Piece& piece, double dt) {
    force.resize(piece.samples);
    driver.drive(piece, dt, force.data());
    for (std::size_t i = 0; i < piece.samples; ++i) {
      squares += isCounted(piece, i) ? (piece.force[i] - force[i]) * (piece.force[i] - force[i]) : 0.0;
    }
  }

  gap::LogDriver driver;
  double squares = 0.0;
  std::vector<double> force = {};
};

}  // namespace

Entries elementsOf(const fit::ModelParameters& model, const FittedLaw& fitted) {
  Entries elements = *model.elements(fitted.fit.parameters.model);
  for (const Entries& entries : fitted.law.at(fitted.fit.parameters.scales)) {
    elements.insert(elements.end(), entries.begin(), entries.end());
  }
  return elements;
}

Replayed replayed(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                  const std::vector<gap::PreparedRecord>& held_out) {
  return {errorsOfTheFit(fitter, fitted, elements), held_out.empty()
                                                        ? std::vector<gap::PartError>()
                                                        : heldOutErrors(fitted.law.hypothesis(), elements, held_out)};
}

std::vector<gap::PartError> unseenErrors(const fit::Fitter& fitter, const FittedLaw& fitted, const Entries& elements,
                                         const std::vector<gap::PreparedRecord>& held_out) {
  return held_out.empty() ? errorsOfTheFit(fitter, fitted, elements)
                          : heldOutErrors(fitted.law.hypothesis(), elements, held_out);
}

std::vector<double> recordedGaps(const std::vector<std::vector<element::ElementDescription>>& models,
                                 const std::vector<prepare::LogSurvey>& logs, Recorded recorded, int threads) {
  std::vector<ReplayedModel> replayed(models.begin(), models.end());
  std::vector<double> squared_gaps(models.size(), 0.0);
  for (std::size_t l = 0; l < logs.size(); ++l) {
    const log::EvenSteps steps = logs[l].steps.evenSteps();
    log::EvenBlocks even(steps);
    Deviation deviation;
    const bool as_new = l == 0 || recorded == Recorded::each_on_a_new_one;
    for (ReplayedModel& model : replayed) {
      model.driver.begin(as_new ? gap::Before::nothing : gap::Before::another_log);
      model.squares = 0.0;
    }
    const auto add = [&](const Piece& piece) {
      deviation.add(piece);
      fit::parallelFor(replayed.size(), threads, [&](std::size_t m) { replayed[m].add(piece, steps.dt); });
    };
    prepare::readAgain(logs[l], [&](const log::Log& block, std::size_t) {
      log::requireForce(block);
      even.add(block, add);
      return true;
    });
    even.finish(add);
    for (std::size_t m = 0; m < models.size(); ++m) {
      squared_gaps[m] += replayed[m].squares / deviation.sumOfSquares() / static_cast<double>(logs.size());
    }
  }
  for (double& gap : squared_gaps) {
    gap = std::sqrt(gap);
  }
  return squared_gaps;
}

}  // namespace rubber_suspension::diagnosis::results
