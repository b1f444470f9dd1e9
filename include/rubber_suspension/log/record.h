// A measured log prepared for diagnosis: even time steps, displacement without sensor noise, samples that count.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

constexpr std::size_t kFewestSamples = 100;  ///< of a record

/// The motion before the first sample of an excerpt. It is coarse, sets the memory of the component, and is not
/// compared with forces.
struct LeadIn {
  double dt = 0.0;                   ///< [s]
  std::vector<double> displacement;  ///< [m], at even steps; empty if the component was at rest before
  bool continues = false;            ///< begins where the preceding record ended, without a rest
};

/// One log, evenly sampled. All vectors that are not empty have the same length.
struct Record {
  std::string name;
  double dt = 0.0;                   ///< [s]
  Eigen::VectorXd displacement;      ///< [m], smoothed if the sensor's noise requires it
  Eigen::VectorXd raw_displacement;  ///< [m], as recorded
  Eigen::VectorXd force;             ///< measured [N]
  Eigen::VectorXd temperature;       ///< [degC]; empty if the log has none
  Eigen::VectorXd across;            ///< displacement perpendicular to this one, on the same radius [m]; likewise
  double force_deviation = 0.0;      ///< standard deviation of the measured force [N]
  double displacement_noise = 0.0;   ///< standard deviation of the sensor's white noise, estimated [m]
  double passed_frequency = 0.0;     ///< above this the displacement was smoothed [Hz]; 0 if it is as recorded
  double highest_frequency = 0.0;    ///< above this the displacement is noise [Hz]
  double lowest_frequency = 0.0;     ///< 2 % of the displacement's power lies below this [Hz]
  double mean_frequency = 0.0;       ///< RMS speed over RMS displacement about its mean, over 2 pi [Hz]
  UnitsAre units = UnitsAre::named;  ///< of displacement and force
  std::vector<std::string> notes;    ///< on time base, saturation and smoothing
  LeadIn lead_in;
  /// 1 for samples that count in residuals, 0 for those that a channel did not measure; empty: all count.
  Eigen::VectorXd counts;

  Eigen::Index size() const { return displacement.size(); }
  double duration() const { return dt * static_cast<double>(size()); }

  /// Returns the number of samples in [first, first + count) that count.
  double counted(Eigen::Index first, Eigen::Index count) const;
  double counted() const { return counted(0, size()); }
};

/// Checks a log and prepares it for diagnosis; `lead_in`: the motion before it. An uneven time base is resampled with a
/// note: at its median step, or at a longer one if there would be more than 20,000 samples and than twice those of the
/// log. Throws LogError if the log has no force, has fewer than 100 samples, does not move, or has a time gap: a step
/// longer than half a second and than 20 times the 90th percentile of the steps.
Record makeRecord(const Log& log, LeadIn lead_in = {});

/// Throws LogError if a log has no measured force.
void requireForce(const Log& log);

/// Resamples a log to even time steps, with the displacement as recorded and without noise and frequencies. Throws
/// LogError as makeRecord() does.
Record evenRecord(const Log& log, LeadIn lead_in = {});

/// Returns the same record, also for channels that do not change.
Record rawRecord(const Log& log, LeadIn lead_in = {});

/// Returns true if both channels change by more than rounding.
bool bothChange(const Record& record);

/// Returns the displacement with additional noise of its sensor's standard deviation [m], the same for the same draw.
Eigen::VectorXd withNoiseDrawn(const Record& record, unsigned draw);

/// Returns the one-sided power spectral density [unit^2/Hz] by Welch's method with Hann windows of `segment` samples,
/// half overlapped; entry i belongs to the frequency i/(segment dt).
Eigen::VectorXd powerSpectralDensity(const Eigen::VectorXd& signal, double dt, Eigen::Index segment);

/// Returns the standard deviation of white noise that has the median of the spectrum above a frequency [Hz]; 0 if fewer
/// than 8 spectral lines lie above it.
double whiteNoiseAbove(const Eigen::VectorXd& signal, double dt, double frequency);

}  // namespace rubber_suspension::log
