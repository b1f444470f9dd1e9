// The report for programs: report.json.
#include <cmath>
#include <complex>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/report/page.h"
#include "diagnosis/report/run_record.h"
#include "element/each.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {
namespace {

using element::each;
using nlohmann::ordered_json;  // which writes null for what is not finite

ordered_json entryJson(const element::ElementDescription& element) {
  ordered_json entry = {{"type", element.type}};
  for (const auto& [name, values] : element.values) {
    entry[name] = values.size() == 1 ? ordered_json(values[0]) : ordered_json(values);
  }
  return entry;
}

ordered_json candidateJson(const CandidateResult& candidate) {
  return {{"effect", candidate.effect},
          {"probability", candidate.probability},
          {"gap", candidate.gap},
          {"closed", candidate.closed},
          {"interval_95", candidate.interval},
          {"testable", candidate.testable},
          {"visible_share", candidate.visible_share},
          {"on_rig", candidate.on_rig},
          {"parameters", candidate.parameters},
          {"add", each(candidate.add, entryJson)}};
}

ordered_json cellJson(const gap::GapCell& cell) {
  return {{"log", cell.log},
          {"frequency_hz", {cell.frequency[0], cell.frequency[1]}},
          {"amplitude_m", {cell.amplitude[0], cell.amplitude[1]}},
          {"quantity", gap::toString(cell.quantity)},
          {"share", cell.share},
          {"noise_ratio", cell.noise_ratio}};
}

ordered_json ratingJson(const gap::Iso18571& rating) {
  return {{"corridor", rating.corridor},
          {"phase", rating.phase},
          {"magnitude", rating.magnitude},
          {"slope", rating.slope},
          {"total", rating.total}};
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

ordered_json findingJson(const measurement::RigFinding& finding) {
  return {{"log", finding.log},     {"finding", finding.finding},
          {"value", finding.value}, {"interval_95", finding.interval_95},
          {"unit", finding.unit},   {"beyond_tolerance", finding.beyond_tolerance},
          {"text", finding.text}};
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

// Every hypothesis that was fitted, with its held-out error.
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

ordered_json deviationJson(const SheetDeviation& number) {
  return {{"name", number.name}, {"tolerances", number.tolerances}};
}

ordered_json alternativeJson(const Alternative& other) {
  return {{"verdict", toString(other.verdict)}, {"effects", other.effects}, {"probability", other.probability}};
}

ordered_json excludedJson(const ExcludedEffect& one) {
  return {{"effect", one.effect}, {"probability_otherwise", one.probability_otherwise}};
}

ordered_json sizeJson(const SizedValue& size) {
  return {{"owner", size.owner},           {"name", size.name},   {"unit", size.unit},
          {"configured", size.configured}, {"value", size.value}, {"interval_95", size.interval_95},
          {"at_bound", size.at_bound}};
}

ordered_json wholeJson(const WholeStiffness& whole) {
  const auto at = [&](std::size_t i) {
    return ordered_json{{"stiffness", whole.stiffness[i]}, {"loss_angle_rad", whole.loss_angle[i]}};
  };
  return {{"frequency_hz", whole.frequency},
          {"amplitude_m", whole.amplitude},
          {"amplitude_from", whole.nominal_amplitude ? "nominal_amplitude" : "median of the logs"},
          {"before", at(0)},
          {"after", at(1)}};
}

ordered_json fileJson(const InputFile& file) {
  return {{"option", file.option}, {"name", file.name}, {"sha256", file.sha256}};
}

ordered_json changeJson(const ReportChange& change) {
  return {{"what", change.what}, {"before", change.before}, {"after", change.after}, {"differs", change.differs}};
}

ordered_json experimentJson(const ProposedExperiment& experiment) {
  return {{"motion", experiment.description},
          {"duration_s", static_cast<double>(experiment.displacement.size() - 1) * experiment.dt},
          {"sampling_rate_hz", 1.0 / experiment.dt},
          {"decides", experiment.decides},
          {"against", experiment.against},
          {"expected_difference_N", experiment.difference},
          {"open_before_bit", experiment.open_before},
          {"open_after_bit", experiment.open_after},
          {"confidence", experiment.probability}};
}

}  // namespace

std::string toJson(const Diagnosis& diagnosis) {
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
      {"share_of_configured_gap", sharesJson(diagnosis.shares)},
      {"rig_findings", each(diagnosis.rig_findings, findingJson)},
      {"taken_out", each(diagnosis.logs.taken_out, takenOutJson)},
      {"closed", {{"fraction", diagnosis.gaps.closed}, {"interval_95", diagnosis.gaps.closed_interval}}},
      {"confounded", diagnosis.answer.confounded},
      {"alternatives", each(diagnosis.answer.alternatives, alternativeJson)},
      {"excluded", each(diagnosis.answer.excluded, excludedJson)},
      {"candidates", each(diagnosis.candidates, candidateJson)},
      {"probability_none_of_these", diagnosis.answer.posterior.none_of_these},
      {"posterior",
       {{"none", diagnosis.answer.posterior.none},
        {"parameter_error", diagnosis.answer.posterior.parameter_error},
        {"effects", diagnosis.answer.posterior.effects},
        {"none_of_these", diagnosis.answer.posterior.none_of_these}}},
      {"where", each(diagnosis.where.before, cellJson)},
      {"next_experiment", diagnosis.next.text},
      {"model_sizes", each(diagnosis.law.model_sizes, sizeJson)},
      {"effect_sizes", each(diagnosis.law.effect_sizes, sizeJson)},
      {"written", each(diagnosis.law.numbers, sizeJson)},
      {"whole_component", diagnosis.whole ? wholeJson(*diagnosis.whole) : ordered_json(nullptr)},
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
      {"admission", each(diagnosis.logs.admission, admissionJson)}};
  if (!diagnosis.defect.empty()) {
    report["defect"] = diagnosis.defect;
  }
  if (diagnosis.turns) {
    report["units"] = {{"m", "rad"}, {"N", "N m"}};
  }
  if (!diagnosis.next.proposed.displacement.empty()) {
    report["next_experiment_log"] = "next_experiment.csv";
    report["experiment"] = experimentJson(diagnosis.next.proposed);
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
