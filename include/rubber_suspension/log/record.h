// A measured log made ready for diagnosis: even time steps, displacement freed of sensor noise, weights.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

constexpr std::size_t kFewestSamples = 100;  ///< of a record

/// The motion that leads to the first sample of an excerpt: coarse, it is for what the component remembers, and
/// compared with nothing.
struct LeadIn {
  double dt = 0.0;                   ///< [s]
  std::vector<double> displacement;  ///< [m], at even steps; empty where the component rested before
  bool continues = false;            ///< begins where the record before this one ended, without a rest
};

/// One log as it was recorded, evenly sampled. All vectors have the same length.
struct Record {
  std::string name;
  double dt = 0.0;                   ///< [s]
  Eigen::VectorXd displacement;      ///< [m], smoothed where the sensor's noise asks for it
  Eigen::VectorXd raw_displacement;  ///< [m], as recorded
  Eigen::VectorXd force;             ///< measured [N]
  Eigen::VectorXd temperature;       ///< [degC]; empty if the log has none
  Eigen::VectorXd across;            ///< displacement that shares a radius with this one [m]; likewise
  double force_deviation = 0.0;      ///< standard deviation of the measured force [N]
  double displacement_noise = 0.0;   ///< standard deviation of the sensor's white noise, estimated [m]
  double passed_frequency = 0.0;     ///< above this the displacement was smoothed [Hz]; 0 if it is as recorded
  double highest_frequency = 0.0;    ///< above this the displacement is noise [Hz]
  double lowest_frequency = 0.0;     ///< 2 % of the displacement's power are below [Hz]
  double mean_frequency = 0.0;       ///< RMS speed over RMS displacement about its mean, by 2 pi [Hz]
  UnitsAre units = UnitsAre::named;  ///< of displacement and force
  std::vector<std::string> notes;    ///< what was found and done: time base, saturation, smoothing
  LeadIn lead_in;
  /// 1 for samples that count in residuals, 0 for those that a channel did not measure; empty: all count.
  Eigen::VectorXd counts;

  Eigen::Index size() const { return displacement.size(); }
  double duration() const { return dt * static_cast<double>(size()); }

  /// Number of the samples [first, first + count) that count.
  double counted(Eigen::Index first, Eigen::Index count) const;
  double counted() const { return counted(0, size()); }
};

/// Checks and prepares a log for diagnosis, to which a motion led. An uneven time base is resampled at its median step,
/// or in so many samples as twice those of the log, with a note. Throws LogError where the log has no force, is shorter
/// than 100 samples, does not move, or has a time gap: a step longer than half a second and than 20 times that of nine
/// in ten samples.
Record makeRecord(const Log& log, LeadIn lead_in = {});

/// Throws LogError where a log has no measured force.
void requireForce(const Log& log);

/// Even time steps and nothing else: the displacement as recorded, no noise nor frequencies known.
/// Throws LogError as makeRecord() does.
Record evenRecord(const Log& log, LeadIn lead_in = {});

/// Makes a record of channels that need not change.
Record rawRecord(const Log& log, LeadIn lead_in = {});

/// True where both channels change by more than numbers do.
bool bothChange(const Record& record);

/// The displacement with noise drawn as its sensor has it. The same numbers at every call with the same draw.
Eigen::VectorXd withNoiseDrawn(const Record& record, unsigned draw);

/// One-sided power spectral density [unit^2/Hz], Welch's method with Hann windows of `segment` samples, half
/// overlapped; entry i belongs to the frequency i/(segment dt).
Eigen::VectorXd powerSpectralDensity(const Eigen::VectorXd& signal, double dt, Eigen::Index segment);

/// Standard deviation of the white noise that fills the spectrum above a frequency, by the median of the spectrum
/// there. Zero where fewer than 8 spectral lines lie above it.
double whiteNoiseAbove(const Eigen::VectorXd& signal, double dt, double frequency);

}  // namespace rubber_suspension::log
