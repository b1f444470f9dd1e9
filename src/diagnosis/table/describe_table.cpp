// Description of a judged search over a table.
#include "diagnosis/table/describe_table.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/experiment/confusion.h"
#include "diagnosis/report/sentence.h"
#include "diagnosis/results/answered.h"
#include "diagnosis/results/augmented.h"
#include "diagnosis/results/simplest_law.h"
#include "diagnosis/results/sizes.h"
#include "diagnosis/table/next_row.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

using Complex = std::complex<double>;

CharacteristicErrors errorsOf(const std::vector<fit::TablePoint>& points, const std::vector<Complex>& model) {
  CharacteristicErrors sum;
  const auto rows = static_cast<double>(points.size());
  for (std::size_t r = 0; r < points.size(); ++r) {
    const Complex measured = points[r].complexStiffness();
    sum.stiffness += std::pow(std::abs(model[r]) / std::abs(measured) - 1.0, 2) / rows;
    sum.loss_angle += std::pow(std::arg(model[r] / measured), 2) / rows;
    if (measured.imag() != 0.0) {
      sum.energy += std::pow(model[r].imag() / measured.imag() - 1.0, 2) / rows;
    }
  }
  return {std::sqrt(sum.stiffness), std::sqrt(sum.loss_angle), std::sqrt(sum.energy)};
}

class TableDescriber {
 public:
  TableDescriber(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                 const MeasuredRows& measured, std::shared_ptr<Workings> workings, const DiagnosisOptions& options)
      : component_(component),
        table_(table),
        measured_(measured),
        options_(options),
        workings_(std::move(workings)),
        search_(workings_->search),
        answer_(workings_->answer),
        judged_(search_.at(answer_.model)) {}

  Diagnosis run() {
    result_.component = component_.name;
    result_.configured = component_;
    result_.re_estimated = measured_.model().apply(search_.re_estimated.fit.parameters.model);
    result_.augmented = augmentedDescription(measured_.model(), judged_);
    result_.augmented_full = result_.augmented;
    describeRows();
    measureGap();
    result_.gap_of_full_law = result_.gap.augmented;
    mapGap();
    describeCandidates();
    describeParameters();
    describeAnswer();
    result_.workings = std::move(workings_);
    return std::move(result_);
  }

 private:
  std::vector<Complex> stiffnessOf(const io::ComponentDescription& description) const {
    return measured_.loops().stiffnessOf(description.allElements());
  }

  double gapOf(const io::ComponentDescription& description) const {
    return fit::gapOfTable(table_.points, stiffnessOf(description));
  }

  void describeRows() {
    DiagnosedTable table;
    table.name = table_.name;
    table.notes = table_.notes;
    table.never_shown = neverShownByTables();
    const std::vector<Complex> configured = stiffnessOf(component_);
    const std::vector<Complex> re_estimated = stiffnessOf(result_.re_estimated);
    const std::vector<Complex> augmented = stiffnessOf(result_.augmented);
    for (std::size_t r = 0; r < table_.points.size(); ++r) {
      table.rows.push_back({table_.points[r], configured[r], re_estimated[r], augmented[r]});
    }
    result_.gap_as_recorded = {fit::gapOfTable(table_.points, configured), fit::gapOfTable(table_.points, re_estimated),
                               fit::gapOfTable(table_.points, augmented), 0.0};
    result_.errors_re_estimated = errorsOf(table_.points, re_estimated);
    result_.errors_augmented = errorsOf(table_.points, augmented);
    result_.table = std::move(table);
  }

  // On rows that took no part in the fit. Noise is no more than what any model leaves.
  void measureGap() {
    Gap& gap = result_.gap;
    gap = {search_.configured_gap, gap::gapOfParts(search_.re_estimated.fit.blocks),
           gap::gapOfParts(judged_.fit.blocks), search_.noise};
    if (answer_.model == Evidence::kAsConfigured) {
      gap.augmented = gap.as_configured;
    }
    gap.noise_floor = std::min({gap.noise_floor, gap.as_configured, gap.re_estimated, gap.augmented});
    for (const FittedHypothesis& single : search_.singles) {
      gap.noise_floor = std::min(gap.noise_floor, gap::gapOfParts(single.fit.blocks));
    }
    result_.noise_source = search_.noise_source;
    addClosed(*workings_, options_, result_);
    io::ComponentDescription values = result_.augmented;
    values.add = component_.add;
    io::ComponentDescription effects = component_;
    effects.add = result_.augmented.add;
    result_.gap_of_values = gapOf(values);
    result_.gap_of_effects = gapOf(effects);
  }

  // Where the configured model is wrong: two cells for each row.
  void mapGap() {
    double sum = 0.0;
    for (const DiagnosedRow& row : result_.table->rows) {
      const Complex measured = row.measured.complexStiffness();
      const Complex rest = (measured - row.as_configured) / std::abs(measured);
      sum += std::norm(rest);
      const std::array<std::pair<gap::Quantity, double>, 2> parts = {
          {{gap::Quantity::stiffness, rest.real()}, {gap::Quantity::loss, rest.imag()}}};
      for (const auto& [quantity, size] : parts) {
        const double f = row.measured.frequency;
        const double a = row.measured.amplitude;
        const double noise = search_.noise / std::sqrt(2.0);
        result_.where.push_back({table_.name, {f, f}, {a, a}, quantity, size * size, std::abs(size) / noise});
      }
    }
    for (gap::GapCell& cell : result_.where) {
      cell.share = sum > 0.0 ? cell.share / sum : 0.0;
    }
    std::stable_sort(result_.where.begin(), result_.where.end(),
                     [](const gap::GapCell& x, const gap::GapCell& y) { return x.share > y.share; });
  }

  void describeCandidates() {
    for (std::size_t c = 0; c < search_.candidates.size(); ++c) {
      result_.candidates.push_back(
          candidateResult(*workings_, options_, result_, c, gap::gapOfParts(search_.singles[c].fit.blocks)));
    }
    sortByProbability(result_.candidates);
  }

  void describeParameters() {
    result_.parameter_ratios = measured_.model().ratios(search_.re_estimated.fit.parameters.model);
    const FittedLaw law = fullLaw(judged_, search_.candidates);
    Sizes sizes = sizesOf(measured_.fitter(), law, {}, effectsOf(law.law, search_.candidates), options_);
    result_.model_sizes = std::move(sizes.model);
    result_.effect_sizes = std::move(sizes.effects);
    result_.written = std::move(sizes.written);
  }

  void describeAnswer() {
    addAnswer(answer_, workings_->evidence, result_);
    result_.next_experiment = nextRow(measured_, *workings_);
    result_.sentence = sentence(result_);
    result_.could_show = couldShow(search_);
  }

  const io::ComponentDescription& component_;
  const fit::MeasuredTable& table_;
  const MeasuredRows& measured_;
  const DiagnosisOptions& options_;
  std::shared_ptr<Workings> workings_;
  const Search& search_;
  const Answer& answer_;
  const FittedHypothesis& judged_;
  Diagnosis result_;
};

}  // namespace

Diagnosis describeTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const MeasuredRows& measured, std::shared_ptr<Workings> workings,
                        const DiagnosisOptions& options) {
  return TableDescriber(component, table, measured, std::move(workings), options).run();
}

}  // namespace rubber_suspension::diagnosis
