// Parameters of a component's elements from measured displacement and force, with intervals.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::fit {

struct IdentificationOptions {
  int starts = 8;                 ///< first as given, the others spread over what the log can show
  std::vector<std::string> held;  ///< parameters to keep, as "maxwell.break_frequency"
  unsigned seed = 1;              ///< of the starts
  /// Columns over the samples of each log for errors of its rig besides the common offset, whose factors are fitted,
  /// too. Empty: none.
  std::vector<Eigen::MatrixXd> rig;
};

struct IdentifiedParameter {
  std::string element;
  int index = 0;  ///< of the element in Identification::elements
  std::string name;
  std::string unit;
  double value = 0.0;
  double lower = 0.0;  ///< 95 % interval
  double upper = 0.0;
  double given = 0.0;      ///< what the search began with
  bool determined = true;  ///< false: at a limit of the search, or an interval wider than a factor of 2 to either side
};

/// A combination of parameters that the log hardly determines: along it the force changes by less than the noise.
struct UndeterminedDirection {
  double standard_deviation = 0.0;  ///< of ln(parameter) along the direction; inf where nothing shows it
  std::vector<std::pair<std::string, double>> weights;  ///< relative changes of the parameters, largest is 1
};

struct Identification {
  std::vector<element::ElementDescription> elements;  ///< with the values found; an element of no force is left out
  std::vector<IdentifiedParameter> parameters;
  double force_offset = 0.0;  ///< constant force of the rig, found along with them [N]
  std::vector<UndeterminedDirection> undetermined;
  double residual = 0.0;             ///< RMS of measured minus simulated force [N]
  double relative_residual = 0.0;    ///< the same over the standard deviation of the measured force
  double independent_samples = 0.0;  ///< as many as the autocorrelated residuals are worth
  int starts = 0;
  int starts_at_best = 0;  ///< starts that ended at the same, best residual
  std::vector<std::string> notes;
};

/// Least squares over all logs at once: min sum of (measured - simulated - offset)^2. Each log is of a component that
/// was at rest before.
///
/// Parameters that scale a force (stiffnesses, damping, maximum forces) are eliminated by a linear least squares
/// problem with bounds (variable projection: Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413-432), so that the
/// search runs over break frequencies and displacements only; with effects in series (compliance, free play, delay,
/// softening, heating) it runs over all. Bounds follow from the tables of the elements and from what rate and length of
/// the logs can show. Whole numbers, switches, tables, dead bands and reference quantities are kept as given.
///
/// Intervals allow for autocorrelated residuals: an autoregressive model of the residuals, of the order that the
/// Bayesian information criterion chooses, gives their covariance O, and that of the parameters is
/// (J'J)^-1 J'OJ (J'J)^-1, with Student's distribution for the number of independent samples that the log is worth.
/// They hold if the model is right and the displacement exact; what the model cannot follow is not part of them.
///
/// Friction without dead band gets one of six standard deviations of the displacement's noise, said in the notes.
/// Throws std::invalid_argument for logs that are empty, too short, not finite, or do not move, and for names to hold
/// that are no parameters.
Identification identify(const std::vector<element::ElementDescription>& elements, const std::vector<log::Log>& logs,
                        const IdentificationOptions& options = {});

/// Standard deviation of white noise on a smooth signal, from its differences: those of a signal that is smooth at the
/// sampling rate fall with every order, scaled differences of noise stay, so the least over orders 1 to 10 is noise.
/// 0 where it is no more than what is negligible.
double noiseStandardDeviation(const std::vector<double>& signal, double negligible = 0.0);

}  // namespace rubber_suspension::fit
