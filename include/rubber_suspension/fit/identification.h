// Identification of the parameters of a component from measured displacement and force, with intervals.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::fit {

struct IdentificationOptions {
  int starts = 8;                 ///< first start as given, others random within the range that the logs can show
  std::vector<std::string> held;  ///< parameters that keep their given value, such as "maxwell.break_frequency"
  unsigned seed = 1;              ///< seed of the random starts
  /// For each log, errors of its rig besides the common offset: a matrix with a row for each sample and a column for
  /// each form of error. The factors of the columns are fitted. Empty without such errors.
  std::vector<Eigen::MatrixXd> rig;
};

struct IdentifiedParameter {
  std::string element;
  int index = 0;  ///< index of the parameter's element in Identification::elements; -1 if the element was removed
  std::string name;
  std::string unit;
  double value = 0.0;
  double lower = 0.0;  ///< lower limit of the 95 % interval
  double upper = 0.0;
  double given = 0.0;      ///< value at which the search began
  bool determined = true;  ///< false if the value is 0, at a search limit, or uncertain by more than a factor of 2
};

/// A combination of parameters that the logs hardly determine: its interval extends beyond a factor of 2.
struct UndeterminedDirection {
  double standard_deviation = 0.0;  ///< standard deviation of ln(parameter) along the direction; may be infinite
  std::vector<std::pair<std::string, double>> weights;  ///< relative changes of the parameters; the largest is 1
};

struct Identification {
  std::vector<element::ElementDescription> elements;  ///< with the fitted values; those without force are omitted
  std::vector<IdentifiedParameter> parameters;
  double force_offset = 0.0;  ///< constant force of the rig, which is also fitted [N]
  std::vector<UndeterminedDirection> undetermined;
  double residual = 0.0;             ///< RMS of measured minus simulated force [N]
  double relative_residual = 0.0;    ///< `residual` over the standard deviation of the measured force
  double independent_samples = 0.0;  ///< effective number of samples, given the autocorrelation of the residuals
  int starts = 0;
  int starts_at_best = 0;  ///< number of starts that ended at the best residual
  std::vector<std::string> notes;
};

/// Fits parameters by least squares over all logs at once: min sum of (measured - simulated - offset)^2. The component
/// is assumed to be at rest before each log.
///
/// Parameters that scale a force (stiffnesses, damping, maximum forces) are eliminated by a linear least squares
/// problem with bounds (variable projection: Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413-432). The search
/// then varies only break frequencies and displacements. If effects act in series (compliance, free play, delay,
/// softening, heating), the search varies all parameters. Bounds follow from the tables of the elements and from rate
/// and length of the logs. Whole numbers, switches, tables, dead bands and reference quantities are kept as given.
///
/// Intervals allow for autocorrelated residuals. An autoregressive model, of the order with the lowest Bayesian
/// information criterion, gives the covariance O of the residuals. With the Jacobian J, the covariance of the
/// parameters is (J'J)^-1 J'OJ (J'J)^-1, used with Student's distribution for the effective number of samples. The
/// intervals are valid if the model is right and the displacement has no error.
///
/// Friction without a dead band is given one of six standard deviations of the displacement's noise, and a note states
/// this. Throws std::invalid_argument if a log is empty, too short, not finite or constant, if `held` contains a name
/// that is no parameter or contains all parameters, and if columns of the rig do not fit the logs.
Identification identify(const std::vector<element::ElementDescription>& elements, const std::vector<log::Log>& logs,
                        const IdentificationOptions& options = {});

/// Returns the standard deviation of white noise on a smooth signal, or 0 if it does not exceed `negligible`.
/// Differences of a smooth signal decrease with their order, whereas scaled differences of noise do not. The result is
/// therefore the smallest deviation over orders 1 to 10.
double noiseStandardDeviation(const std::vector<double>& signal, double negligible = 0.0);

}  // namespace rubber_suspension::fit
