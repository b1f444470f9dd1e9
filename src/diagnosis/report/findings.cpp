// Findings about the rig: their meaning and remedy.
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

// A finding is sure if it is fatal, or if its interval excludes 0 and, for errors that a rig makes in all logs alike,
// no other log shows the opposite sign.
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
       {"The force does not read 0 where the component is free of load.",
        "Zero the load cell with the component unclamped and warm; note the zero before and after each log."}},
      {f::kDisplacementZero,
       {"The displacement does not read 0 at the position that the model starts from.",
        "Zero the displacement sensor at the clamped rest position, before every log."}},
      {f::kRunningStart,
       {"The recording starts while the component still answers to motion before it.",
        "Start the recording at rest, some relaxation times before the machine moves."}},
      {f::kSensorGain,
       {"The force is larger or smaller than it should be by one factor.",
        "Calibrate the load cell and its amplifier in the range of this test; compare with a dead weight."}},
      {f::kDelay,
       {"One channel arrives later than the other.",
        "Use the same filter and the same converter for both channels, or correct by the filters' group delay."}},
      {f::kClock,
       {"The two channels run on clocks of different speed.",
        "Record both channels on one clock, or distribute a trigger to both recorders."}},
      {f::kSpikes,
       {"Single samples stand far out of the signal.",
        "Check plugs, shield and earth of the channel; look for switching drives beside its cable."}},
      {f::kHeldValues,
       {"The channel repeats its last value: samples were lost.",
        "Record at the rate that the channel delivers; check the bus load and the buffer of the recorder."}},
      {f::kSaturation,
       {"The channel stands at the end of its range.",
        "Choose a larger range of the amplifier or a larger load cell, and record again."}},
      {f::kColouredNoise,
       {"The noise of the force is not white: slow parts are larger than fast ones.",
        "Let the amplifier warm up; keep the load cell's temperature steady; check for vibration of the frame."}},
      {f::kDrift,
       {"The force goes off slowly, without the displacement.",
        "Let the amplifier and the component warm up before the log; note the zero before and after it."}},
      {f::kLine,
       {"The force oscillates at a frequency of the mains or of a machine, whatever the displacement does.",
        "Shield and earth the cable of the load cell, keep it away from drives, and mount pumps softly."}},
      {f::kSign,
       {"Force and displacement have opposite signs.",
        "Swap the sign of one channel, as by --columns force=-NAME: a positive displacement has to need a positive "
        "force."}},
      {f::kUnitFactor,
       {"The numbers are off by the factor between two units.",
        "Write the right unit into the column's name, or give it, as by --unit force=kN; if the units are right, "
        "--accept-units."}},
      {f::kPeakToPeak,
       {"The numbers are off by 2, as an amplitude is from what lies from peak to peak.",
        "Halve the column, as by --columns force=0.5*NAME; if it is right, --accept-units."}},
      {f::kRectified, {"A channel has lost its sign.", "Record it without a rectifier and without taking magnitudes."}},
      {f::kContactSide,
       {"The contact of the component file is open where the log has a force.",
        "Turn the sign of `side` of its `lift_off`, or those of displacement and force together."}},
      {f::kConstant,
       {"A channel measured nothing, in a part of the log or all along.",
        "Check its cable, its plugs and the clamps; record again, or cut the part out."}},
      {f::kSwappedColumns,
       {"Displacement and force stand in each other's columns.", "Name the columns, or give them with --columns."}},
      {f::kOtherComponent,
       {"The log's stiffness is not that of this component file, by more than any effect of rubber.",
        "Check which component was clamped, how many in parallel, and which entry of the component file is meant; "
        "where "
        "the file holds a guess, --accept-units, or find its values with the command estimate."}},
      {f::kTooShort,
       {"The log is too short, or has too few samples in a cycle, to say anything.",
        "Record several cycles with at least some twenty samples in each."}},
  };
  static const FindingAdvice nothing;
  const auto found = table.find(finding);
  return found == table.end() ? nothing : found->second;
}

}  // namespace rubber_suspension::diagnosis::report
