// Checks of logs before any diagnosis: sign, unit factors, swapped columns, another component.
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

/// Compares the records of one bench with the configured component. Every finding is fatal and has evidence and
/// correction in its text:
/// - constant: a channel does not change, or stands still for a tenth of the log or more while the other continues, or
///   the force is less than 5 % of the component's and unrelated to the displacement;
/// - rectified: a channel follows the magnitude of the other;
/// - contact_side: the force fits the component with its contacts, or compliances of one side, on the other side;
/// - sign: the force falls where the displacement rises, and the loops create energy, which a mass in fast motion does
///   not. A spring without loss is reported unless only its fastest logs are reversed, as by a mass;
/// - swapped_columns: the loops create energy while the stiffness is positive, or the stiffness is that of the
///   component with force and displacement exchanged;
/// - delay: the loops create energy because one channel is late, by more than the effect time_delay explains;
/// - unit_factor: the stiffness is off by a factor of a wrong unit (1000, 9.81, 25.4, 4.448, 10, ...): within 1.25, or
///   2.5 for large factors, if units are assumed (log::UnitsAre); if they are named, within 1.4 tolerances of the data
///   sheet, or 1.5 for large factors, in all logs alike, or by a large factor in one of several logs;
/// - other_component: the stiffness of all logs is off by one other factor, more than this tolerance and all effects of
///   rubber explain together;
/// - peak_to_peak: the force is that of the component times 2, or 1/2, in all logs;
/// - too_short: fewer than 30 samples in motion, or fewer than 4 samples per cycle.
///
/// `tolerance`: standard deviation of the logarithm of the data sheet's stiffnesses (estimation::SheetTolerance),
/// within which deviations are no fault of the bench. Factors are not checked if the user accepts the units. If the
/// force does not correlate with the displacement, as for a damper or a seal, only large factors (above 90) are
/// reported. Throws std::invalid_argument for elements that make no component.
std::vector<RigFinding> checkBench(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<log::Record>& records,
                                   double tolerance = estimation::SheetTolerance::kUsual);

/// Compares measured and configured K* [N/m] of a table's rows. Returns a finding on the table: sign if all loss angles
/// are negative, unit_factor, other_component or peak_to_peak; nullopt if effects may explain the ratio.
std::optional<RigFinding> checkTable(const std::string& table, const std::vector<std::complex<double>>& measured,
                                     const std::vector<std::complex<double>>& configured,
                                     double tolerance = estimation::SheetTolerance::kUsual);

/// Returns true for a finding that the stiffness is off by a factor above 90, which no effect explains.
bool isFarOff(const RigFinding& finding);

/// A record with the correction of a finding.
struct BenchCorrection {
  std::string text;  ///< what was done, such as "force times -1"
  log::Record record;
};

/// Returns the correction that a finding of checkBench() on this record proposes; nullopt if it proposes none, as for
/// another component. A wrong unit is corrected in the force. Throws as checkBench().
std::optional<BenchCorrection> correctionOf(const RigFinding& finding,
                                            const std::vector<element::ElementDescription>& elements,
                                            const log::Record& record);

}  // namespace rubber_suspension::measurement
