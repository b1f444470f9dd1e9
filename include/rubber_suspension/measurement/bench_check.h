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
/// - constant: a channel does not change, stands still for a tenth of the log or more while the other continues, or is
///   noise alone of next to nothing;
/// - rectified: a channel follows the magnitude of the other;
/// - contact_side: the force is that of the component whose contact, or compliance of one side, has the other sign;
/// - sign: the force falls where the displacement rises, and the loops give energy, which no mass in fast motion does;
///   of a spring without loss, unless it is faster than all logs of the right sign, as a mass turns it;
/// - swapped_columns: the loops give energy while the stiffness is positive, or the stiffness is that of force and
///   displacement exchanged;
/// - delay: the loops give energy because the force is late by an eighth of a period or more;
/// - unit_factor: the stiffness is off by a factor that a wrong unit makes (1000, 9.81, 25.4, 4.448, 10, ...): about,
///   where units are assumed (log::UnitsAre); where they are named within 1.4 tolerances of the data sheet, by hundreds
///   50 %, in all logs alike, or in one log among others by hundreds;
/// - other_component: the stiffness of all logs is off by one other factor, more than this tolerance and all effects of
///   rubber can explain together;
/// - peak_to_peak: the force is that of the component times 2, or 1/2, in all logs;
/// - too_short: fewer than 30 samples in motion, or fewer than 4 samples per cycle.
///
/// `tolerance`: standard deviation of the logarithm of the data sheet's stiffnesses (estimation::SheetTolerance); what
/// a sheet may be off by is no fault of the bench. The factors are not doubted where the user accepts the units.
/// Stiffness is judged only where the measured force goes with the displacement; a damper or a seal, whose component
/// has hardly any spring, is left to the diagnosis. Throws std::invalid_argument for elements that make no component.
std::vector<RigFinding> checkBench(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<log::Record>& records,
                                   double tolerance = estimation::SheetTolerance::kUsual);

/// Checks a table, whose name the finding has, by measured and configured K* [N/m] of its rows: sign if all loss angles
/// are negative, unit_factor, other_component or peak_to_peak; nullopt if effects may explain their ratio.
std::optional<RigFinding> checkTable(const std::string& table, const std::vector<std::complex<double>>& measured,
                                     const std::vector<std::complex<double>>& configured,
                                     double tolerance = estimation::SheetTolerance::kUsual);

/// True for a finding about the scale of the stiffness that no effect explains: off by hundreds.
bool isFarOff(const RigFinding& finding);

/// A record as it would be with the correction of a finding.
struct BenchCorrection {
  std::string text;  ///< what was done, such as "force times -1"
  log::Record record;
};

/// The correction that a finding of checkBench() on this record proposes; nothing where it proposes none, as for
/// another component. A wrong unit is corrected in the force. Throws as checkBench().
std::optional<BenchCorrection> correctionOf(const RigFinding& finding,
                                            const std::vector<element::ElementDescription>& elements,
                                            const log::Record& record);

}  // namespace rubber_suspension::measurement
