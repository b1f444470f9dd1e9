// The output of the command `estimate` on a component: parameters, stiffness and loss angle over frequency and
// amplitude, also for other models of the same specification and for changed inputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

/// Ranges of the sweeps; values that are not given follow from the specification.
struct SweepOptions {
  std::optional<double> lowest_frequency;   ///< [Hz]; nominal_frequency/10, or 0.1
  std::optional<double> highest_frequency;  ///< [Hz]; high_frequency or 10 nominal_frequency, or 50
  std::optional<double> lowest_amplitude;   ///< [m]; amplitude/10
  std::optional<double> highest_amplitude;  ///< [m]; 5 amplitude
  std::optional<double> frequency;          ///< of the sweep over amplitude [Hz]; nominal_frequency, or 1
  std::optional<double> amplitude;          ///< of the sweep over frequency [m]; nominal_amplitude, or 1 mm
  std::optional<double> product;            ///< P = A f [m Hz]; amplitude times frequency
  int points = 13;                          ///< of each sweep
};

/// The effect of a change of one input at the lowest, a middle and the highest frequency of the sweep.
struct SensitivityRow {
  std::string input;
  std::vector<double> frequencies;  ///< [Hz]
  std::vector<double> stiffness;    ///< relative change of K over that of the input [-]; empty without a solution
  std::vector<double> loss_angle;   ///< change over that of the input [rad]
};

struct Sensitivity {
  double share;  ///< relative change of each input, up and down [-]
  std::vector<SensitivityRow> rows;
  std::vector<response::SweepPoint> low;  ///< the least stiffness and loss angle at each frequency over all changes
  std::vector<response::SweepPoint> high;
};

struct EstimateReport {
  io::ComponentDescription description;
  std::vector<element::ElementDescription> elements;  ///< estimated or listed, then those added
  std::vector<std::string> notes;
  bool linear = false;
  response::SweepPoint working_point;
  double product = 0.0;  ///< constant product A f of over_product [m Hz]
  std::vector<response::SweepPoint> over_frequency;
  std::vector<response::SweepPoint> over_amplitude;
  std::vector<response::SweepPoint> over_product;
  std::optional<Sensitivity> sensitivity;
};

/// Estimates the component and computes all sweeps, with a progress bar on a terminal. Throws std::invalid_argument for
/// invalid ranges.
EstimateReport makeEstimateReport(const io::ComponentDescription& description, const SweepOptions& options);

std::string toText(const EstimateReport& report);

/// Returns {"schema": "rubber_suspension/estimate/1", "components": [...]} in SI units, with units in the keys.
std::string toJson(const std::vector<EstimateReport>& reports);

enum class Legends { in_all_axes, one };

/// Returns a figure of stiffness and loss angle over frequency, over amplitude, and at constant product.
io::Figure toFigure(const std::vector<EstimateReport>& reports, Legends legends = Legends::in_all_axes);

/// Returns the component in each of these models: M1 to M6, the names of a component file, or a whole number of Maxwell
/// elements. A model uses the numbers of the specification that it needs, of alternatives the first one given. A
/// missing loss angle, break frequency or high frequency is derived from the component and listed in `notes`. Throws
/// std::invalid_argument for an unknown model, a missing number, or a specification without solution.
std::vector<io::ComponentDescription> inModels(const io::ComponentDescription& description,
                                               const std::vector<std::string>& models, std::vector<std::string>& notes);

/// Adds the effect of a change of each input by this share [-] on stiffness and loss angle over frequency.
void addSensitivity(EstimateReport& report, double share);

/// Returns CSV of all sweeps in SI units: f, A, K, loss angle, K' = K cos(delta), K'' = K sin(delta), K_e = K',
/// C_e = K''/omega (Polach, IAVSD 2015, Eq. 12), settled, sweep, component. `estimate --from-table` reads this file.
std::string toCsv(const std::vector<EstimateReport>& reports);

}  // namespace rubber_suspension::command
