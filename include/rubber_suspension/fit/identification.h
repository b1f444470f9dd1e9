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
  int starts = 8;                 ///< the first as given, the others random within the range that the logs can show
  std::vector<std::string> held;  ///< parameters that are kept as given, such as "maxwell.break_frequency"
  unsigned seed = 1;              ///< of the random starts
  /// Forms of errors of each log's rig besides the common offset, one column each over the samples of the log. Their
  /// factors are fitted, too. Empty: there are none.
  std::vector<Eigen::MatrixXd> rig;
};

struct IdentifiedParameter {
  std::string element;
  int index = 0;  ///< of its element in Identification::elements; -1 if that was removed
  std::string name;
  std::string unit;
  double value = 0.0;
  double lower = 0.0;  ///< 95 % interval
  double upper = 0.0;
  double given = 0.0;      ///< value at which the search began
  bool determined = true;  ///< false: 0, at a limit of the search, or uncertain by more than a factor of 2
};

/// A combination of parameters that the logs hardly determine: its interval is wider than a factor of 2.
struct UndeterminedDirection {
  double standard_deviation = 0.0;  ///< of ln(parameter) along the direction; infinite if no log shows it
  std::vector<std::pair<std::string, double>> weights;  ///< relative changes of the parameters, largest is 1
};

struct Identification {
  std::vector<element::ElementDescription> elements;  ///< with the fitted values; elements without force are removed
  std::vector<IdentifiedParameter> parameters;
  double force_offset = 0.0;  ///< constant force of the rig, fitted together with the parameters [N]
  std::vector<UndeterminedDirection> undetermined;
  double residual = 0.0;             ///< RMS of measured minus simulated force [N]
  double relative_residual = 0.0;    ///< `residual` over the standard deviation of the measured force
  double independent_samples = 0.0;  ///< effective number of samples, given the autocorrelation of the residuals
  int starts = 0;
  int starts_at_best = 0;  ///< starts that ended at the same, best residual
  std::vector<std::string> notes;
};

/// Fits parameters by least squares over all logs at once: min sum of (measured - simulated - offset)^2. The component
/// is assumed to be at rest before each log.
///
/// Parameters that scale a force (stiffnesses, damping, maximum forces) are eliminated by a linear least squares
/// problem with bounds (variable projection: Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413-432), so that the
/// search runs over break frequencies and displacements only; with effects in series (compliance, free play, delay,
/// softening, heating) it runs over all. Bounds follow from the tables of the elements and from what rate and length of
/// the logs can show. Whole numbers, switches, tables, dead bands and reference quantities are kept as given.
///
/// Intervals allow for autocorrelated residuals: an autoregressive model of the residuals, of the order that the
/// Bayesian information criterion chooses, gives their covariance O, and that of the parameters is
/// (J'J)^-1 J'OJ (J'J)^-1, with Student's distribution for the effective number of samples. The intervals are valid if
/// the model is right and the displacement exact; errors of the model are not included.
///
/// Friction without dead band gets one of six standard deviations of the displacement's noise; a note states it. Throws
/// std::invalid_argument for logs that are empty, too short, not finite or constant, if `held` has a name that is no
/// parameter or has all parameters, and for columns of the rig that do not fit the logs.
Identification identify(const std::vector<element::ElementDescription>& elements, const std::vector<log::Log>& logs,
                        const IdentificationOptions& options = {});

/// Returns the standard deviation of white noise on a smooth signal. Differences of a smooth signal decrease with their
/// order, scaled differences of noise do not, so the smallest over orders 1 to 10 is that of the noise. Returns 0 if it
/// does not exceed `negligible`.
double noiseStandardDeviation(const std::vector<double>& signal, double negligible = 0.0);

}  // namespace rubber_suspension::fit
