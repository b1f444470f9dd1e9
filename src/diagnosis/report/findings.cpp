// States the meaning and the remedy of findings about the rig.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "diagnosis/report/report_parts.h"
#include "diagnosis/words/text.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::report {
namespace {

using measurement::RigFinding;

bool hasInterval(const RigFinding& finding) { return finding.interval_95[0] < finding.interval_95[1]; }

bool holdsZero(const RigFinding& finding) {
  return hasInterval(finding) && finding.interval_95[0] <= 0.0 && finding.interval_95[1] >= 0.0;
}

// Returns true for a fatal finding, and for a finding whose interval excludes 0. Gain, delay and clock error of a rig
// have the same sign in all logs, so that such a finding is not sure if another log shows the opposite sign.
bool isSure(const RigFinding& finding, const std::vector<RigFinding>& all) {
  const bool of_rig = finding.finding == measurement::finding::kDelay ||
                      finding.finding == measurement::finding::kSensorGain ||
                      finding.finding == measurement::finding::kClock;
  const bool contradicted =
      of_rig && std::any_of(all.begin(), all.end(), [&](const RigFinding& other) {
        return other.finding == finding.finding && !holdsZero(other) && other.value * finding.value < 0.0;
      });
  return finding.fatal || (!holdsZero(finding) && !contradicted);
}

std::string valueText(const RigFinding& finding) {
  const std::string value = words::quantity(finding.value, finding.unit);
  return hasInterval(finding)
             ? fmt::format("{} ({} to {})", value, words::quantity(finding.interval_95[0], finding.unit),
                           words::quantity(finding.interval_95[1], finding.unit))
             : value;
}

}  // namespace

std::vector<nlohmann::ordered_json> findingsJson(const std::vector<RigFinding>& findings) {
  return element::each(findings, [&](const RigFinding& finding) -> nlohmann::ordered_json {
    const FindingAdvice& advice = adviceOn(finding.finding);
    nlohmann::ordered_json json = {{"log", finding.log},        {"finding", finding.finding},
                                   {"value", finding.value},    {"interval_95", finding.interval_95},
                                   {"unit", finding.unit},      {"beyond_tolerance", finding.beyond_tolerance},
                                   {"text", finding.text},      {"value_text", valueText(finding)},
                                   {"fatal", finding.fatal},    {"sure", isSure(finding, findings)},
                                   {"meaning", advice.meaning}, {"remedy", advice.remedy}};
    if (finding.frequency > 0.0) {
      json["frequency_Hz"] = finding.frequency;
    }
    return json;
  });
}

const FindingAdvice& adviceOn(const std::string& finding) {
  namespace f = measurement::finding;
  static const std::map<std::string, FindingAdvice> table = {
      {f::kForceZero,
       {"The force does not read 0 while the component is unloaded.",
        "Zero the load cell with the component unclamped and warm; note the zero before and after each log."}},
      {f::kDisplacementZero,
       {"The displacement does not read 0 at the position from which the model starts.",
        "Zero the displacement sensor at the clamped rest position, before every log."}},
      {f::kRunningStart,
       {"The recording starts while the component still responds to earlier motion.",
        "Start the recording at rest, some relaxation times before the machine moves."}},
      {f::kSensorGain,
       {"All forces are too large or too small by the same factor.",
        "Calibrate the load cell and its amplifier in the range of this test; compare with a dead weight."}},
      {f::kDelay,
       {"One channel is delayed relative to the other.",
        "Use the same filter and the same converter for both channels, or correct by the filters' group delay."}},
      {f::kClock,
       {"The two channels run on clocks of different speed.",
        "Record both channels on one clock, or distribute a trigger to both recorders."}},
      {f::kSpikes,
       {"Single samples lie far outside the signal.",
        "Check plugs, shield and earth of the channel; look for switching drives beside its cable."}},
      {f::kHeldValues,
       {"The channel repeats its last value: samples were lost.",
        "Record at the rate that the channel delivers; check the bus load and the buffer of the recorder."}},
      {f::kSaturation,
       {"The channel is saturated: it stays at the end of its range.",
        "Choose a larger range of the amplifier or a larger load cell, and record again."}},
      {f::kColouredNoise,
       {"The noise of the force is not white: slow parts are larger than fast ones.",
        "Let the amplifier warm up; keep the load cell's temperature steady; check for vibration of the frame."}},
      {f::kDrift,
       {"The force drifts slowly, independently of the displacement.",
        "Let the amplifier and the component warm up before the log; note the zero before and after it."}},
      {f::kLine,
       {"The force oscillates at a frequency of the mains or of a machine, whatever the displacement does.",
        "Shield and earth the cable of the load cell, keep it away from drives, and mount pumps softly."}},
      {f::kSign,
       {"Force and displacement have opposite signs.",
        "Reverse the sign of one channel, for example with --columns force=-NAME: a positive displacement must need a "
        "positive force."}},
      {f::kUnitFactor,
       {"The values are wrong by a factor that converts one unit into another.",
        "Correct the unit in the column's name, or use an option such as --unit force=kN; if the units are correct, "
        "use --accept-units."}},
      {f::kPeakToPeak,
       {"The values are wrong by a factor of 2, like a peak-to-peak value taken as an amplitude.",
        "Halve the column, for example with --columns force=0.5*NAME; if it is correct, use --accept-units."}},
      {f::kRectified, {"A channel has lost its sign.", "Record it without a rectifier and not as a magnitude."}},
      {f::kContactSide,
       {"The contact in the component file is open while the log has a force.",
        "Reverse the sign of `side` in the element `lift_off`, or the signs of both displacement and force."}},
      {f::kConstant,
       {"A channel recorded no signal, in part of the log or throughout.",
        "Check its cable, its plugs and the clamps; record again, or remove this part of the log."}},
      {f::kSwappedColumns,
       {"The columns of displacement and force are swapped.", "Rename the columns, or use --columns."}},
      {f::kOtherComponent,
       {"The log's stiffness differs from that of the component file by more than any effect of rubber can explain.",
        "Check which component was clamped, how many were in parallel, and which entry of the component file applies; "
        "if the file is a guess, use --accept-units, or find its values with the command estimate."}},
      {f::kTooShort,
       {"The log is too short, or has too few samples per cycle, for a diagnosis.",
        "Record several cycles with at least twenty samples each."}},
  };
  static const FindingAdvice nothing;
  const auto found = table.find(finding);
  return found == table.end() ? nothing : found->second;
}

}  // namespace rubber_suspension::diagnosis::report
