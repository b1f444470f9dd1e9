// The report of the command `estimate` on a component: its parameters, and stiffness and loss angle as functions of
// frequency and amplitude, also for other models of the same specification and for changed inputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

/// Ranges of the sweeps. If several defaults are named, the first one that the specification provides applies.
struct SweepOptions {
  std::optional<double> lowest_frequency;   ///< [Hz]; default: nominal_frequency/10, or 0.1
  std::optional<double> highest_frequency;  ///< [Hz]; default: high_frequency, or 10 nominal_frequency, or 50
  std::optional<double> lowest_amplitude;   ///< [m]; default: amplitude/10
  std::optional<double> highest_amplitude;  ///< [m]; default: 5 amplitude
  std::optional<double> frequency;          ///< of the sweep over amplitude [Hz]; default: nominal_frequency, or 1
  std::optional<double> amplitude;          ///< of the sweep over frequency [m]; default: nominal_amplitude, or 1 mm
  std::optional<double> product;            ///< P = A f [m Hz]; default: the product of `amplitude` and `frequency`
  int points = 13;                          ///< number of points of each sweep
};

/// The effect of a change of one input, at the lowest, a middle and the highest frequency of the sweep.
struct SensitivityRow {
  std::string input;
  std::vector<double> frequencies;  ///< [Hz]
  std::vector<double> stiffness;    ///< relative change of K per relative change of the input [-]; empty: no solution
  std::vector<double> loss_angle;   ///< change of the loss angle per relative change of the input [rad]
};

struct Sensitivity {
  double share;  ///< relative change of each input, in both directions [-]
  std::vector<SensitivityRow> rows;
  std::vector<response::SweepPoint> low;  ///< least stiffness and loss angle at each frequency under all changes
  std::vector<response::SweepPoint> high;
};

struct EstimateReport {
  io::ComponentDescription description;
  std::vector<element::ElementDescription> elements;  ///< the estimated or listed elements, then the elements under
                                                      ///< `add`
  std::vector<std::string> notes;
  bool linear = false;
  response::SweepPoint working_point;
  double product = 0.0;  ///< constant product A f in over_product [m Hz]
  std::vector<response::SweepPoint> over_frequency;
  std::vector<response::SweepPoint> over_amplitude;
  std::vector<response::SweepPoint> over_product;
  std::optional<Sensitivity> sensitivity;
};

/// Estimates the component and computes all sweeps. Throws std::invalid_argument for invalid ranges.
EstimateReport makeEstimateReport(const io::ComponentDescription& description, const SweepOptions& options);

std::string toText(const EstimateReport& report);

/// Returns JSON {"schema": "rubber_suspension/estimate/1", "components": [...]} with the SI units in the keys.
std::string toJson(const std::vector<EstimateReport>& reports);

enum class Legends { in_all_axes, one };

/// Returns a figure of stiffness and loss angle over frequency, over amplitude, and at constant product of both.
io::Figure toFigure(const std::vector<EstimateReport>& reports, Legends legends = Legends::in_all_axes);

/// Returns the component in each of these models. A model is M1 to M6, a name as in component files, or a number of
/// Maxwell elements. It uses the numbers of the specification that it needs; if alternatives are specified, it uses the
/// first. A missing loss angle, break frequency or high frequency is derived from the component and listed in `notes`.
/// Throws std::invalid_argument for an unknown model, a missing number, or a specification without solution.
std::vector<io::ComponentDescription> inModels(const io::ComponentDescription& description,
                                               const std::vector<std::string>& models, std::vector<std::string>& notes);

/// Adds to the report how stiffness and loss angle change with frequency if each input is changed by this share [-].
void addSensitivity(EstimateReport& report, double share);

/// Returns CSV of all sweeps in SI units. The columns are frequency f, amplitude A, stiffness K, loss angle delta, K' =
/// K cos(delta), K'' = K sin(delta), K_e = K', C_e = K''/omega (Polach, IAVSD 2015, Eq. 12), settled, sweep and
/// component. `estimate --from-table` reads this file.
std::string toCsv(const std::vector<EstimateReport>& reports);

}  // namespace rubber_suspension::command
