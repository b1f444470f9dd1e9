// Checks of logs before any diagnosis: reversed sign, wrong units, swapped columns, log of another component.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/log/record.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::measurement {

/// Compares the records of one bench with the configured component. Every finding is fatal; the text of a finding
/// states evidence and correction. The findings are:
/// - constant: a channel is constant in the whole log, or for at least a tenth of the log while the other channel
/// continues; or the force is less than 5 % of the simulated force and unrelated to the displacement;
/// - rectified: a channel follows the magnitude of the other channel;
/// - contact_side: the force fits the component only if its contact, or its compliance of one side, acts on the other
/// side;
/// - sign: the force falls while the displacement rises, and the loops create energy, which a mass in fast motion does
/// not do. For a spring without loss the falling force suffices, unless only the fastest logs are reversed;
/// - swapped_columns: the log fits the component after force and displacement are exchanged, but not as recorded;
/// - delay: the loops create energy because one channel is late by more than the effect time_delay explains;
/// - unit_factor: the stiffness is wrong by the factor of a wrong unit (1000, 9.81, 25.4, 4.448, ...). If units are
/// assumed (log::UnitsAre), the stiffness may miss the unit factor by a factor of 1.25, or of 2.5 for unit factors
/// above 90. If units are named, all logs have to agree, and miss it by at most 1.4 tolerances of the data sheet, or by
/// 1.5 above 90; or one of several logs is wrong by a unit factor above 90;
/// - other_component: the stiffness of all logs is wrong by one factor that neither a unit nor the tolerance of the
/// data sheet together with all effects of rubber explains;
/// - peak_to_peak: the force is twice or half the simulated force in all logs;
/// - too_short: fewer than 30 samples are in motion, or a cycle has fewer than 4 samples.
///
/// `tolerance`: standard deviation of the logarithm of the data sheet's stiffnesses (estimation::SheetTolerance).
/// Factors are not checked if the user accepts the units. If the force does not correlate with the displacement, as for
/// a damper or a seal, a factor is reported only above 90. Throws std::invalid_argument for invalid elements.
std::vector<RigFinding> checkBench(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<log::Record>& records,
                                   double tolerance = estimation::SheetTolerance::kUsual);

/// Compares measured and configured K* [N/m] of the rows of a table. Returns the finding `sign` if all loss angles are
/// negative, or else unit_factor, other_component or peak_to_peak; nullopt if effects may explain the ratio.
std::optional<RigFinding> checkTable(const std::string& table, const std::vector<std::complex<double>>& measured,
                                     const std::vector<std::complex<double>>& configured,
                                     double tolerance = estimation::SheetTolerance::kUsual);

/// Returns true if the finding states a factor of the stiffness above 90, which no effect explains.
bool isFarOff(const RigFinding& finding);

/// A record with the correction of a finding.
struct BenchCorrection {
  std::string text;  ///< what was done, such as "force times -1"
  log::Record record;
};

/// Returns the correction that a finding of checkBench() on this record proposes. Returns nullopt if the finding
/// proposes none, as for another component. A wrong unit is corrected in the force. Throws like checkBench().
std::optional<BenchCorrection> correctionOf(const RigFinding& finding,
                                            const std::vector<element::ElementDescription>& elements,
                                            const log::Record& record);

}  // namespace rubber_suspension::measurement
