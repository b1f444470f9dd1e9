// Accounts for the errors that are removed from each log before it is compared with a model.
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

/// Kinds of errors, spelled as in reports.
namespace taken_out {
inline constexpr const char* kSpikes = "spikes";  ///< samples that a channel did not measure
inline constexpr const char* kLine = "line";      ///< force that mains or a pump add
inline constexpr const char* kZero = "zero";      ///< offset of the force
inline constexpr const char* kDisplacement = "displacement_zero";
inline constexpr const char* kInitialState = "initial_state";
inline constexpr const char* kDrift = "drift";
inline constexpr const char* kGain = "gain";
inline constexpr const char* kFriction = "friction_factor";  ///< factor on the friction of the component in the log
inline constexpr const char* kDelay = "delay";
}  // namespace taken_out

/// Account of one log. It starts with the mean squared residual of a model on the log as recorded, divided by the
/// variance of the force. Each call of takeOut() sets the value that remains after a kind of error has been removed.
class LogAccount {
 public:
  LogAccount(std::string log, double recorded) : log_(std::move(log)), recorded_(recorded), left_(recorded) {}

  void takeOut(const std::string& kind, double left);

  /// Return the initial and the current value. The squares of entries(), with their signs, add up to the difference.
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

/// Returns the accounts of records for a model. The records of the fit come first and were recorded on one component;
/// then come the held-out records, each of a new component. `free` are the per-log parameters of the judged hypothesis.
std::vector<LogAccount> accountsOf(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<gap::PreparedRecord>& of_the_fit,
                                   const std::vector<gap::PreparedRecord>& held_out,
                                   const std::vector<prepare::RawChannels>& raw, fit::PerLogNuisances free);

}  // namespace rubber_suspension::diagnosis::results
