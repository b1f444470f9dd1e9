// The force taken out of each log before a model was held against it, accounted for by kind.
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
inline constexpr const char* kFriction = "friction_factor";  ///< of the log's own
inline constexpr const char* kDelay = "delay";
}  // namespace taken_out

/// The account of one log, opened with what a model leaves of it as recorded: a mean square over the force's variance.
/// Whoever takes something out says what is left then.
class LogAccount {
 public:
  LogAccount(std::string log, double recorded) : log_(std::move(log)), recorded_(recorded), left_(recorded) {}

  void takeOut(const std::string& kind, double left);

  /// `left` is of the logs as recorded less all shares: in squares they add up.
  double recorded() const { return recorded_; }
  double left() const { return left_; }

  /// One entry a kind, in the order of their taking.
  std::vector<TakenOut> entries() const;

 private:
  std::string log_;
  double recorded_;
  double left_;
  std::vector<std::pair<std::string, double>> squares_;
};

/// The accounts of records against elements, those of the fit first, which were recorded on one component; each other
/// was on a new one. `free`: what the judged hypothesis frees in each log.
std::vector<LogAccount> accountsOf(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<gap::PreparedRecord>& of_the_fit,
                                   const std::vector<gap::PreparedRecord>& held_out,
                                   const std::vector<prepare::RawChannels>& raw, fit::PerLogNuisances free);

}  // namespace rubber_suspension::diagnosis::results
