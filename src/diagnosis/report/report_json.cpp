// Writes the report for programs, report.json.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/report/report_parts.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/words/candidates.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/sentence.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {
namespace {

using element::each;
using nlohmann::ordered_json;  // writes null for a number that is not finite

ordered_json entryJson(const element::ElementDescription& element) {
  ordered_json entry = {{"type", element.type}};
  for (const auto& [name, values] : element.values) {
    entry[name] = values.size() == 1 ? ordered_json(values[0]) : ordered_json(values);
  }
  return entry;
}

// Returns a probability in percent, formatted as in the sentence.
std::string chanceText(double probability) { return words::chance(probability) + " %"; }

ordered_json candidateJson(const Diagnosis& d, const CandidateResult& candidate) {
  return {{"effect", candidate.effect},
          {"documentation", candidate.documentation},
          {"probability", candidate.probability},
          {"probability_text", chanceText(candidate.probability)},
          {"gap", candidate.gap},
          {"closed", candidate.closed},
          {"interval_95", candidate.interval},
          {"testable", candidate.testable},
          {"visible_share", candidate.visible_share},
          {"on_rig", candidate.on_rig},
          {"parameters", candidate.parameters},
          {"parameters_text", words::numbersText(d, candidate)},
          {"why_out", words::whyOut(d, candidate)},
          {"law", candidate.written ? "written" : "full"},
          {"add", each(candidate.add, entryJson)}};
}

ordered_json leftJson(const LeftOfLog& log) {
  return {{"log", log.log}, {"as_configured", log.configured}, {"written", log.written}, {"allowed", log.allowed}};
}

ordered_json withheldJson(const Withheld& one) {
  return {{"effect", one.effect}, {"log", one.log}, {"before", one.before}, {"after", one.after}};
}

ordered_json cellJson(const gap::GapCell& cell) {
  return {{"log", cell.log},
          {"frequency_hz", {cell.frequency[0], cell.frequency[1]}},
          {"amplitude_m", {cell.amplitude[0], cell.amplitude[1]}},
          {"quantity", gap::toString(cell.quantity)},
          {"share", cell.share},
          {"squared_gap", cell.squared},
          {"noise_ratio", cell.noise_ratio}};
}

ordered_json ratingJson(const gap::Iso18571& rating) {
  return {{"corridor", rating.corridor}, {"phase", rating.phase}, {"magnitude", rating.magnitude},
          {"slope", rating.slope},       {"total", rating.total}, {"grade", gap::iso18571Grade(rating.total)}};
}

ordered_json admissionJson(const Admission& log) {
  ordered_json entry = {{"log", log.log},
                        {"hold_out", log.hold_out},
                        {"duration_s", log.duration},
                        {"step_s", log.dt},
                        {"largest_displacement_m", log.largest_displacement},
                        {"highest_frequency_hz", log.highest_frequency},
                        {"noise_floor", log.noise},
                        {"repeats", log.repeats},
                        {"gap_as_recorded", log.recorded},
                        {"gap", log.left},
                        {"notes", log.notes}};
  if (log.rating) {
    entry["iso18571"] = {{"as_configured", ratingJson(log.rating->as_configured)},
                         {"augmented", ratingJson(log.rating->augmented)},
                         {"repeats", log.rating->augmented.repeats}};
  }
  return entry;
}

ordered_json takenOutJson(const TakenOut& part) {
  return {{"log", part.log}, {"kind", part.kind}, {"share_of_force", part.share}};
}

ordered_json errorsJson(const CharacteristicErrors& errors) {
  return {{"stiffness", errors.stiffness}, {"loss_angle_rad", errors.loss_angle}, {"energy_per_cycle", errors.energy}};
}

ordered_json surrogateJson(const Surrogate& surrogate) {
  return {{"file", "surrogate.yaml"},
          {"gap", surrogate.gap},
          {"function_of_the_motion", surrogate.function_of_the_motion},
          {"share_of_the_rest", surrogate.share},
          {"gap_unseen", {{"before", surrogate.unseen_before}, {"after", surrogate.unseen_after}}},
          {"chance", surrogate.chance},
          {"missing_force", "missing_force.csv"}};
}

ordered_json stiffnessJson(std::complex<double> stiffness) {
  return {{"stiffness_N_per_m", std::abs(stiffness)}, {"loss_angle_rad", std::arg(stiffness)}};
}

ordered_json rowJson(const DiagnosedRow& row) {
  ordered_json json = {{"frequency_hz", row.measured.frequency},
                       {"amplitude_m", row.measured.amplitude},
                       {"mean_displacement_m", row.measured.mean}};
  if (row.measured.temperature) {
    json["temperature_degC"] = *row.measured.temperature;
  }
  json["measured"] = stiffnessJson(row.measured.complexStiffness());
  json["as_configured"] = stiffnessJson(row.as_configured);
  json["re_estimated"] = stiffnessJson(row.re_estimated);
  json["augmented"] = stiffnessJson(row.augmented);
  return json;
}

ordered_json hypothesesJson(const hypotheses::Search& search) {
  ordered_json result = ordered_json::array();
  const auto add = [&](const hypotheses::FittedHypothesis& fitted) {
    const auto effect = [&](int member) { return search.candidates[static_cast<std::size_t>(member)].effect; };
    result.push_back({{"effects", each(fitted.hypothesis.members, effect)},
                      {"held_out", fitted.fit.held_out},
                      {"in_sample", fitted.fit.gap},
                      {"own_moved_by", std::exp(fitted.fit.parameters.largestChange())},
                      {"chi_squared", fitted.fit.chi_squared}});
  };
  add(search.re_estimated);
  for (const hypotheses::FittedHypothesis* fitted : search.withEffects()) {
    add(*fitted);
  }
  return result;
}

ordered_json ratiosJson(const ParameterRatios& ratios) {
  ordered_json result = ordered_json::object();
  for (const auto& [name, ratio] : ratios) {
    result[name] = ratio;
  }
  return result;
}

ordered_json sharesJson(const std::vector<GapShare>& shares) {
  ordered_json result = ordered_json::object();
  for (const GapShare& share : shares) {
    result[share.by] = share.share;
  }
  return result;
}

ordered_json squaresJson(const std::vector<GapShare>& shares) {
  ordered_json result = ordered_json::object();
  for (const GapShare& share : shares) {
    if (std::isfinite(share.squares_at_least)) {
      result[share.by] = share.squares_at_least;
    }
  }
  return result;
}

ordered_json deviationJson(const SheetDeviation& number) {
  return {{"name", number.name}, {"tolerances", number.tolerances}};
}

ordered_json alternativeJson(const Alternative& other) {
  return {{"verdict", toString(other.verdict)},
          {"effects", other.effects},
          {"probability", other.probability},
          {"probability_text", chanceText(other.probability)}};
}

ordered_json excludedJson(const ExcludedEffect& one) {
  return {{"effect", one.effect}, {"probability_otherwise", one.probability_otherwise}};
}

ordered_json sizeJson(const SizedValue& size) {
  return {{"owner", size.owner},           {"name", size.name},   {"unit", size.unit},
          {"configured", size.configured}, {"value", size.value}, {"interval_95", size.interval_95},
          {"at_bound", size.at_bound}};
}

ordered_json wholeJson(const Diagnosis& d) {
  const WholeStiffness& whole = *d.whole;
  const auto at = [&](std::size_t i) {
    return ordered_json{{"stiffness", whole.stiffness[i]}, {"loss_angle_rad", whole.loss_angle[i]}};
  };
  return {{"frequency_hz", whole.frequency},
          {"amplitude_m", whole.amplitude},
          {"amplitude_from", whole.nominal_amplitude ? "nominal_amplitude" : "median of the logs"},
          {"before", at(0)},
          {"after", at(1)},
          {"sentence", words::wholeText(d)}};
}

ordered_json fileJson(const InputFile& file) {
  return {{"option", file.option}, {"name", file.name}, {"sha256", file.sha256}};
}

ordered_json changeJson(const ReportChange& change) {
  return {{"what", change.what}, {"before", change.before}, {"after", change.after}, {"differs", change.differs}};
}

// Returns instructions for the proposed log, and the command with which the node plays it.
ordered_json experimentJson(const Diagnosis& d) {
  const ProposedExperiment& experiment = d.next.proposed;
  const double duration = static_cast<double>(experiment.displacement.size() - 1) * experiment.dt;
  return {{"motion", experiment.description},
          {"duration_s", duration},
          {"sampling_rate_hz", 1.0 / experiment.dt},
          {"decides", experiment.decides},
          {"against", experiment.against},
          {"expected_difference_N", experiment.difference},
          {"open_before_bit", experiment.open_before},
          {"open_after_bit", experiment.open_after},
          {"confidence", experiment.probability},
          {"how_to_play", fmt::format("play next_experiment.csv ({:.3g} s at {:.4g} Hz; starts and ends at rest at 0), "
                                      "or next_experiment.drv, an RPC III drive file of the same motion",
                                      duration, 1.0 / experiment.dt)},
          {"command", fmt::format("roslaunch rubber_suspension bench.launch config:=$PWD/augmented.yaml "
                                  "component:={} log:=$PWD/next_experiment.csv output:=$PWD/next_run",
                                  d.component)}};
}

std::string meaningOf(Verdict verdict) {
  static const std::map<Verdict, std::string> meanings = {
      {Verdict::none, "no gap beyond the noise"},
      {Verdict::parameter_error, "the model's parameter values are wrong; no effect is missing"},
      {Verdict::named, "the model lacks the effects named here"},
      {Verdict::partly, "the model lacks the effects named here and something else"},
      {Verdict::confounded, "several sets of effects explain the logs about equally well"},
      {Verdict::unknown, "no listed effect explains the gap"},
      {Verdict::check_bench, "a log cannot be right: check the bench"},
      {Verdict::defect, "the report contradicts itself; there is no verdict"}};
  return meanings.at(verdict);
}

// Returns the numbers of the law, then the values of the model that differ from the configured ones.
ordered_json lawInWords(const Diagnosis& d) {
  ordered_json rows = each(d.law.effect_sizes, [&](const SizedValue& size) -> ordered_json {
    return {{"number", (d.answer.effects.size() > 1 ? words::spoken(size.owner) + ", " : "") + words::sizeName(size)},
            {"value", words::signedQuantity(d, size)},
            {"interval_95", words::intervalText(size)}};
  });
  for (const SizedValue* size : words::changedValues(d)) {
    rows.push_back({{"number", words::valueName(*size) + " of the model"},
                    {"value", fmt::format("{}, not {}", words::quantity(size->value, size->unit),
                                          words::quantity(size->configured, size->unit))},
                    {"interval_95", words::intervalText(*size)}});
  }
  return rows;
}

ordered_json changedInWords(const Diagnosis& d) {
  const auto changed =
      element::those(d.law.model_sizes, [](const SizedValue& size) { return size.value != size.configured; });
  return each(changed, [](const SizedValue& size) -> ordered_json {
    return {{"value", words::valueName(size)},
            {"before", words::quantity(size.configured, size.unit)},
            {"after", words::quantity(size.value, size.unit)},
            {"interval_95", words::intervalText(size)},
            {"change", fmt::format("{:+.1f} %", 100.0 * (size.value / size.configured - 1.0))}};
  });
}

ordered_json figuresJson(const Diagnosis& d) {
  ordered_json figures = ordered_json::array();
  for (const report::ReportFigure& figure : report::reportFigures(d)) {
    if (!figure.figure.axes.empty()) {
      figures.push_back(report::figureJson(figure));
    }
  }
  return figures;
}

// Returns numbers and sentences as the terminal prints them, so that the page need not format them.
ordered_json inWords(const Diagnosis& d) {
  const Gap& gap = d.gaps.unseen;
  const Posterior& posterior = d.answer.posterior;
  const auto share = [](const GapShare& one) -> ordered_json {
    return {{"by", one.by}, {"share", words::wholePercent(one.share) + " %"}};
  };
  return {{"headline", words::headline(d)},
          {"verdict", meaningOf(d.answer.verdict)},
          {"probability", chanceText(d.answer.probability)},
          {"gap",
           {{"as_configured", words::percent(gap.as_configured)},
            {"re_estimated", words::percent(gap.re_estimated)},
            {"augmented", words::percent(gap.augmented)},
            {"noise_floor", words::percent(gap.noise_floor)}}},
          {"closed",
           {words::wholePercent(d.gaps.closed), words::wholePercent(std::min(1.0, d.gaps.closed_interval[0])),
            words::wholePercent(std::min(1.0, d.gaps.closed_interval[1]))}},
          {"shares", each(d.shares, share)},
          {"posterior",
           {{"none", chanceText(posterior.none)},
            {"parameter_error", chanceText(posterior.parameter_error)},
            {"none_of_these", chanceText(posterior.none_of_these)}}},
          {"not_testable", words::notTestableText(d)},
          {"law", lawInWords(d)},
          {"changed", changedInWords(d)},
          {"added", words::addedTexts(d)},
          {"taken_out", words::describeTakenOut(d.logs.taken_out)}};
}

}  // namespace

std::string toJson(const Diagnosis& diagnosis) {
  const auto candidate_json = [&](const CandidateResult& candidate) { return candidateJson(diagnosis, candidate); };
  ordered_json report = {
      {"schema", "rubber_suspension/gap_report/1"},
      {"component", diagnosis.component},
      {"verdict", toString(diagnosis.answer.verdict)},
      {"probability", diagnosis.answer.probability},
      {"sentence", diagnosis.sentence},
      {"effects", diagnosis.answer.effects},
      {"gap",
       {{"as_configured", diagnosis.gaps.unseen.as_configured},
        {"re_estimated", diagnosis.gaps.unseen.re_estimated},
        {"augmented", diagnosis.gaps.unseen.augmented},
        {"full_law", diagnosis.law.gap_of_full},
        {"noise_floor", diagnosis.gaps.unseen.noise_floor},
        {"noise_source", diagnosis.gaps.noise_source}}},
      {"gap_as_recorded",
       {{"as_configured", diagnosis.gap_as_recorded.as_configured},
        {"re_estimated", diagnosis.gap_as_recorded.re_estimated},
        {"augmented", diagnosis.gap_as_recorded.augmented}}},
      {"gap_further_log", diagnosis.gaps.further_log},
      {"share_of_configured_gap", sharesJson(diagnosis.shares)},
      {"squares_removed_at_least", squaresJson(diagnosis.shares)},
      {"withheld", each(diagnosis.law.withheld, withheldJson)},
      {"left_of_logs", each(diagnosis.law.left_of_logs, leftJson)},
      {"rig_findings", report::findingsJson(diagnosis.rig_findings)},
      {"taken_out", each(diagnosis.logs.taken_out, takenOutJson)},
      {"closed", {{"fraction", diagnosis.gaps.closed}, {"interval_95", diagnosis.gaps.closed_interval}}},
      {"confounded", diagnosis.answer.confounded},
      {"alternatives", each(diagnosis.answer.alternatives, alternativeJson)},
      {"excluded", each(diagnosis.answer.excluded, excludedJson)},
      {"candidates", each(diagnosis.candidates, candidate_json)},
      {"probability_none_of_these", diagnosis.answer.posterior.none_of_these},
      {"posterior",
       {{"none", diagnosis.answer.posterior.none},
        {"parameter_error", diagnosis.answer.posterior.parameter_error},
        {"effects", diagnosis.answer.posterior.effects},
        {"none_of_these", diagnosis.answer.posterior.none_of_these}}},
      {"where", each(diagnosis.where.before, cellJson)},
      {"where_after", each(diagnosis.where.after, cellJson)},
      {"next_experiment", diagnosis.next.text},
      {"model_sizes", each(diagnosis.law.model_sizes, sizeJson)},
      {"effect_sizes", each(diagnosis.law.effect_sizes, sizeJson)},
      {"written", each(diagnosis.law.numbers, sizeJson)},
      {"whole_component", diagnosis.whole ? wholeJson(diagnosis) : ordered_json(nullptr)},
      {"augmented_full_add", each(diagnosis.law.full.add, entryJson)},
      {"errors",
       {{"re_estimated", errorsJson(diagnosis.where.re_estimated)},
        {"augmented", errorsJson(diagnosis.where.augmented)}}},
      {"own_parameters",
       {{"ratio_to_configured", ratiosJson(diagnosis.parameters.ratios)},
        {"guess", diagnosis.parameters.guess},
        {"sheet_deviations", each(diagnosis.parameters.sheet_deviations, deviationJson)},
        {"at_bounds", diagnosis.parameters.at_bounds}}},
      {"samples", {{"searched", diagnosis.samples.searched}, {"recorded", diagnosis.samples.recorded}}},
      {"admission", each(diagnosis.logs.admission, admissionJson)},
      {"in_words", inWords(diagnosis)},
      {"excited_hz", report::excitedBand(diagnosis)},
      {"figures", figuresJson(diagnosis)}};
  if (!diagnosis.defect.empty()) {
    report["defect"] = diagnosis.defect;
  }
  if (diagnosis.turns) {
    report["units"] = {{"m", "rad"}, {"N", "N m"}};
  }
  if (!diagnosis.next.proposed.displacement.empty()) {
    report["next_experiment_log"] = "next_experiment.csv";
    report["experiment"] = experimentJson(diagnosis);
  }
  if (!diagnosis.could_show.implanted.empty()) {
    report["could_show"] = report::toJson(diagnosis.could_show);
  }
  if (!diagnosis.run.version.empty()) {
    report["meta"] = report::metaJson(diagnosis.run);
    report["meta"]["files"] = each(diagnosis.run.files, fileJson);
  }
  if (!diagnosis.comparison.with.empty()) {
    report["comparison"] = {{"with", diagnosis.comparison.with},
                            {"date", diagnosis.comparison.date},
                            {"changes", each(diagnosis.comparison.changes, changeJson)}};
  }
  if (diagnosis.workings && diagnosis.defect.empty()) {
    report["trials"] = hypothesesJson(diagnosis.workings->search);
    report["surrogate_gap"] = diagnosis.workings->search.surrogate_gap;
  }
  if (diagnosis.table) {
    report["table"] = {{"name", diagnosis.table->name},
                       {"never_shown", diagnosis.table->never_shown},
                       {"notes", diagnosis.table->notes},
                       {"rows", each(diagnosis.table->rows, rowJson)}};
  }
  if (diagnosis.surrogate) {
    report["surrogate"] = surrogateJson(*diagnosis.surrogate);
  }
  return report.dump(2) + "\n";
}

}  // namespace rubber_suspension::diagnosis
