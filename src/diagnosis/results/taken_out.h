// Errors removed from each log before it is compared with a model, accounted for by kind.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagnosis/prepare/excerpts.h"
#include "fit/free_in_log.h"
#include "gap/simulate.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::results {

/// Kinds, as reports write them.
namespace taken_out {
inline constexpr const char* kSpikes = "spikes";  ///< samples that a channel did not measure
inline constexpr const char* kLine = "line";      ///< of mains or a pump
inline constexpr const char* kZero = "zero";      ///< of the force
inline constexpr const char* kDisplacement = "displacement_zero";
inline constexpr const char* kInitialState = "initial_state";
inline constexpr const char* kDrift = "drift";
inline constexpr const char* kGain = "gain";
inline constexpr const char* kFriction = "friction_factor";  ///< factor on the friction of the log
inline constexpr const char* kDelay = "delay";
}  // namespace taken_out

/// Account of one log. It begins with the mean squared residual of a model on the log as recorded, over the variance of
/// the force; each takeOut() states the value that remains.
class LogAccount {
 public:
  LogAccount(std::string log, double recorded) : log_(std::move(log)), recorded_(recorded), left_(recorded) {}

  void takeOut(const std::string& kind, double left);

  /// Return the value at the beginning and now. They differ by the sum of the squares of entries(), each with its sign.
  double recorded() const { return recorded_; }
  double left() const { return left_; }

  /// Returns one entry per kind, in the order of removal.
  std::vector<TakenOut> entries() const;

 private:
  std::string log_;
  double recorded_;
  double left_;
  std::vector<std::pair<std::string, double>> squares_;
};

/// Returns the accounts of records against elements: first of those of the fit, which were recorded on one component,
/// then of the held-out ones, each on a new component. `free`: unknowns of the judged hypothesis in each log.
std::vector<LogAccount> accountsOf(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<gap::PreparedRecord>& of_the_fit,
                                   const std::vector<gap::PreparedRecord>& held_out,
                                   const std::vector<prepare::RawChannels>& raw, fit::PerLogNuisances free);

}  // namespace rubber_suspension::diagnosis::results
