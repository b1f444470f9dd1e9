// A measured log prepared for diagnosis: with even time steps and a displacement without sensor noise.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

constexpr std::size_t kFewestSamples = 100;  ///< smallest number of samples of a record

/// The motion before the first sample of an excerpt. It sets the initial state of the component. Forces are ignored.
struct LeadIn {
  double dt = 0.0;                   ///< [s]
  std::vector<double> displacement;  ///< [m], at even steps; empty if the component was at rest before the record
  bool continues = false;            ///< true if the motion begins where the preceding record ended, without a rest
};

/// One log at even time steps. All vectors that are not empty have the same length.
struct Record {
  std::string name;
  double dt = 0.0;                   ///< [s]
  Eigen::VectorXd displacement;      ///< [m], smoothed if the noise of the sensor requires that
  Eigen::VectorXd raw_displacement;  ///< [m], as recorded
  Eigen::VectorXd force;             ///< measured force [N]
  Eigen::VectorXd temperature;       ///< temperature [degC]; empty if the log has no temperature
  Eigen::VectorXd across;            ///< displacement in the perpendicular radial direction [m]; empty if unknown
  double force_deviation = 0.0;      ///< standard deviation of the measured force [N]
  double displacement_noise = 0.0;   ///< estimated standard deviation of the white noise of the displacement sensor [m]
  double passed_frequency = 0.0;     ///< limit of the displacement's low-pass filter [Hz]; 0 if it was not filtered
  double highest_frequency = 0.0;    ///< the displacement above this frequency is only noise [Hz]
  double lowest_frequency = 0.0;     ///< 2 % of the displacement's power lies below this frequency [Hz]
  double mean_frequency = 0.0;       ///< RMS speed, divided by 2 pi and the displacement's standard deviation [Hz]
  UnitsAre units = UnitsAre::named;  ///< of displacement and force
  std::vector<std::string> notes;    ///< on the time base, saturation and smoothing
  LeadIn lead_in;
  /// 1 for samples whose residual is evaluated, 0 for samples without a measured force. Empty: 1 for all samples.
  Eigen::VectorXd counts;

  Eigen::Index size() const { return displacement.size(); }
  double duration() const { return dt * static_cast<double>(size()); }

  /// Returns how many of the samples [first, first + count) have a residual that is evaluated.
  double counted(Eigen::Index first, Eigen::Index count) const;
  double counted() const { return counted(0, size()); }
};

/// Checks a log and prepares it for diagnosis. `lead_in` is the motion before the log. An uneven time base is
/// resampled, with a note, at the median step of the log. The step is longer if the record would otherwise have more
/// than 20,000 samples and more than twice as many as the log. Throws LogError if the log has no force, has fewer than
/// 100 samples, does not move, or has a time gap, which is a step longer than both 0.5 s and 20 times the 90th
/// percentile.
Record makeRecord(const Log& log, LeadIn lead_in = {});

/// Throws LogError if the log has no measured force.
void requireForce(const Log& log);

/// Resamples a log to even time steps without smoothing. Noise and frequencies remain 0. Throws as makeRecord() does.
Record evenRecord(const Log& log, LeadIn lead_in = {});

/// Returns the result of evenRecord(), but also accepts a log in which displacement or force does not change.
Record rawRecord(const Log& log, LeadIn lead_in = {});

/// Returns true if displacement and force both change by more than rounding errors.
bool bothChange(const Record& record);

/// Returns the displacement [m] plus random noise with the standard deviation of the sensor's noise. Each value of
/// `draw` selects one sequence of random numbers.
Eigen::VectorXd withNoiseDrawn(const Record& record, unsigned draw);

/// Returns the one-sided power spectral density [unit^2/Hz] by Welch's method, with Hann windows of `segment` samples
/// that overlap by half. Entry i belongs to the frequency i/(segment dt).
Eigen::VectorXd powerSpectralDensity(const Eigen::VectorXd& signal, double dt, Eigen::Index segment);

/// Estimates white noise from the spectrum above `frequency` [Hz]. Returns the standard deviation of the white noise
/// whose density has the same median; 0 if fewer than 8 spectral lines lie above the frequency.
double whiteNoiseAbove(const Eigen::VectorXd& signal, double dt, double frequency);

}  // namespace rubber_suspension::log
