// Diagnoses a table: checks the bench, searches the hypotheses, judges them and describes the result.
#include "rubber_suspension/diagnosis/table_diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>

#include "diagnosis/effect.h"
#include "diagnosis/experiment/confusion.h"
#include "diagnosis/experiment/explanation.h"
#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/hypotheses/log_table.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/invariants.h"
#include "diagnosis/judge/evidence.h"
#include "diagnosis/prepare/bench_evidence.h"
#include "diagnosis/results/answered.h"
#include "diagnosis/results/simplest_law.h"
#include "diagnosis/results/sizes.h"
#include "diagnosis/results/written_law.h"
#include "diagnosis/table/measured_rows.h"
#include "diagnosis/words/sentence.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "estimation/models.h"
#include "fit/parallel.h"
#include "measurement/statistics.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/measurement/bench_check.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::diagnosis::table {
namespace {

constexpr int kSteps = 7;             // number of frequencies, and of amplitudes, in the menu of new rows
constexpr double kLeastFloors = 2.0;  // least difference between explanations / noise floor, in a proposed row
constexpr double kBeyond = 2.0;       // factor by which a proposed row may lie outside the measured range

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Returns true if the table has a row whose frequency and amplitude both differ by at most a tenth.
bool isMeasured(const std::vector<fit::TablePoint>& points, double frequency, double amplitude) {
  constexpr double kNear = 0.1;
  return std::any_of(points.begin(), points.end(), [&](const fit::TablePoint& point) {
    return std::abs(std::log(point.frequency / frequency)) < kNear &&
           std::abs(std::log(point.amplitude / amplitude)) < kNear;
  });
}

// Returns new rows, with placeholders for K*, within the range of a table that is widened by the factor `beyond`.
std::vector<fit::TablePoint> menuOf(const std::vector<fit::TablePoint>& points, double beyond) {
  Range frequency;
  Range amplitude;
  for (const fit::TablePoint& point : points) {
    frequency.include(point.frequency);
    amplitude.include(point.amplitude);
  }
  const auto spaced = [&](const Range& range) {
    const double low = range.low / beyond;
    const double high = range.high * beyond;
    return high > low ? response::logSpaced(low, high, kSteps) : std::vector<double>{low};
  };
  std::vector<fit::TablePoint> menu;
  for (const double f : spaced(frequency)) {
    for (const double a : spaced(amplitude)) {
      if (!isMeasured(points, f, a)) {
        menu.push_back({f, a, points.front().stiffness, 0.0, points.front().mean, points.front().temperature});
      }
    }
  }
  return menu;
}

// A row, the explanation that is nearest to the judged model there, and the relative difference of their K*.
struct Difference {
  fit::TablePoint row;
  std::size_t rival = 0;
  double size = 0.0;
};

Difference largestDifference(const std::vector<fit::TablePoint>& menu, const MeasuredRows& measured,
                             const std::vector<experiment::Explanation>& explanations) {
  const fit::TableLoops loops(menu);
  std::vector<std::vector<std::complex<double>>> stiffness;
  for (const experiment::Explanation& explanation : explanations) {
    const hypotheses::FittedHypothesis& fitted = *explanation.fitted;
    stiffness.push_back(
        loops.stiffnessOf(*fit::elementsOf(measured.model(), fitted.hypothesis, fitted.fit.parameters)));
  }
  Difference largest;
  for (std::size_t r = 0; r < menu.size(); ++r) {
    Difference nearest{menu[r], 0, std::numeric_limits<double>::infinity()};
    for (std::size_t e = 1; e < stiffness.size(); ++e) {
      const double size = std::abs(stiffness[e][r] - stiffness[0][r]) / std::abs(stiffness[0][r]);
      if (size < nearest.size) {
        nearest.rival = e;
        nearest.size = size;
      }
    }
    if (std::isfinite(nearest.size) && nearest.size > largest.size) {
      largest = nearest;
    }
  }
  return largest;
}

std::string recordALog() {
  const std::vector<std::string> names = element::each(neverShownByTables(), words::spoken);
  return "Record a log: a log also shows " + words::enumerated(names) + ", which no table shows.";
}

// Proposes to measure the row in which the explanations differ most. The row is within the range of the table or, if no
// row there distinguishes them, up to twice as far. Proposes a log if no such row distinguishes them either.
std::string nextRow(const MeasuredRows& measured, const Workings& workings) {
  const hypotheses::Search& search = workings.search;
  if (workings.answer.verdict == Verdict::none) {
    return "No further row is needed for the effects that a table can show. " + recordALog();
  }
  const std::vector<experiment::Explanation> explanations = experiment::explanationsOf(workings);
  if (explanations.size() < 2) {
    return recordALog();
  }
  const std::string names = experiment::nameOf(search, *explanations[0].fitted);
  for (const double beyond : {1.0, kBeyond}) {
    const std::vector<fit::TablePoint> menu = menuOf(measured.loops().points(), beyond);
    if (menu.size() < 2) {
      continue;
    }
    const Difference best = largestDifference(menu, measured, explanations);
    if (best.size >= kLeastFloors * search.noise.floor) {
      return fmt::format(
          "Measure a row at {:.3g} Hz and {}{}: {} and {} differ there by {} of K*, {:.1f} times the noise floor.",
          best.row.frequency, words::quantity(best.row.amplitude, "m"),
          beyond > 1.0 ? ", beyond the range of the table" : "", names,
          experiment::nameOf(search, *explanations[best.rival].fitted), words::percent(best.size),
          best.size / search.noise.floor);
    }
  }
  return fmt::format("No row up to twice the range of the table distinguishes {} from {}. {}", names,
                     experiment::nameOf(search, *explanations[1].fitted), recordALog());
}

using Complex = std::complex<double>;

CharacteristicErrors errorsOf(const std::vector<fit::TablePoint>& points, const std::vector<Complex>& model) {
  CharacteristicErrors sum{0.0, 0.0, 0.0};
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
                 const MeasuredRows& measured, std::shared_ptr<const Workings> workings,
                 const DiagnosisOptions& options)
      : component_(component),
        table_(table),
        measured_(measured),
        options_(options),
        workings_(std::move(workings)),
        search_(workings_->search),
        answer_(workings_->answer),
        judged_(search_.at(answer_.model)),
        re_estimated_(measured_.model().apply(search_.re_estimated.fit.parameters.model)),
        augmented_(hypotheses::augmentedDescription(measured_.model(), judged_)),
        rows_(rows()) {}

  Diagnosis run() {
    Diagnosis result;
    result.component = component_.name;
    result.configured = component_;
    result.re_estimated = re_estimated_;
    result.law = law();
    result.table = DiagnosedTable{table_.name, rows_, neverShownByTables(), table_.notes};
    result.gap_as_recorded = {fit::gapOfTable(table_.points, of(&DiagnosedRow::as_configured)),
                              fit::gapOfTable(table_.points, of(&DiagnosedRow::re_estimated)),
                              fit::gapOfTable(table_.points, of(&DiagnosedRow::augmented)), 0.0};
    result.answer = results::answered(answer_, workings_->evidence);
    const results::Left left = leftOfRows();
    result.gaps = results::gapsOf(left, *workings_, options_);
    result.candidates = results::candidateResults(left, result.gaps, *workings_, options_);
    result.shares = results::sharesOf(
        result.answer.effects, result.gaps.unseen, [&](const auto& in) { return gapWith(in); }, options_.threads);
    result.where = {mapOf(&DiagnosedRow::as_configured), mapOf(&DiagnosedRow::augmented),
                    errorsOf(table_.points, of(&DiagnosedRow::re_estimated)),
                    errorsOf(table_.points, of(&DiagnosedRow::augmented))};
    result.parameters = results::ownParameters(measured_.model(), search_.re_estimated.fit.parameters.model,
                                               judged_.fit.parameters.model);
    result.next.text = nextRow(measured_, *workings_);
    result.sentence = words::sentence(result) + words::excludedNote(result);
    result.could_show = experiment::couldShow(search_);
    result.workings = workings_;
    return result;
  }

 private:
  std::vector<Complex> stiffnessOf(const io::ComponentDescription& description) const {
    return measured_.loops().stiffnessOf(description.allElements());
  }

  double gapOf(const io::ComponentDescription& description) const {
    return fit::gapOfTable(table_.points, stiffnessOf(description));
  }

  // Returns the gap of a model that has the re-estimated values if in[0] is true, and effect e if in[1 + e] is true.
  double gapWith(const std::vector<bool>& in) const {
    hypotheses::FittedHypothesis some = judged_;
    if (!in[0]) {
      some.fit.parameters.model.setZero();
    }
    for (std::size_t e = 0; e < answer_.effects.size(); ++e) {
      const std::vector<int>& members = judged_.hypothesis.members;
      const auto member = std::find(members.begin(), members.end(), answer_.effects[e]) - members.begin();
      if (!in[1 + e]) {
        some.fit.parameters = hypotheses::withoutMember(some, static_cast<std::size_t>(member));
      }
    }
    return gapOf(hypotheses::augmentedDescription(measured_.model(), some));
  }

  std::vector<DiagnosedRow> rows() const {
    const std::vector<Complex> configured = stiffnessOf(component_);
    const std::vector<Complex> re_estimated = stiffnessOf(re_estimated_);
    const std::vector<Complex> augmented = stiffnessOf(augmented_);
    std::vector<DiagnosedRow> rows;
    for (std::size_t r = 0; r < table_.points.size(); ++r) {
      rows.push_back({table_.points[r], configured[r], re_estimated[r], augmented[r]});
    }
    return rows;
  }

  std::vector<Complex> of(Complex DiagnosedRow::* model) const { return element::each(rows_, model); }

  // Returns the gaps on rows that took no part in the fit.
  results::Left leftOfRows() const {
    Gap gap = {search_.configured_gap, gap::gapOfParts(search_.re_estimated.fit.blocks),
               gap::gapOfParts(judged_.fit.blocks), search_.noise.floor};
    if (answer_.model == judge::Evidence::kAsConfigured) {
      gap.augmented = gap.as_configured;
    }
    const auto gapAlone = [](const hypotheses::FittedHypothesis& one) { return gap::gapOfParts(one.fit.blocks); };
    return {gap, gap.augmented, element::each(search_.singles, gapAlone), workings_->table};
  }

  // Returns a map of the errors of a model, with a cell for stiffness and a cell for loss for each row.
  std::vector<gap::GapCell> mapOf(Complex DiagnosedRow::* model) const {
    double sum = 0.0;
    std::vector<gap::GapCell> cells;
    for (const DiagnosedRow& row : rows_) {
      const Complex measured = row.measured.complexStiffness();
      const Complex rest = (measured - row.*model) / std::abs(measured);
      sum += std::norm(rest);
      const std::array<std::pair<gap::Quantity, double>, 2> parts = {
          {{gap::Quantity::stiffness, rest.real()}, {gap::Quantity::loss, rest.imag()}}};
      for (const auto& [quantity, size] : parts) {
        const double f = row.measured.frequency;
        const double a = row.measured.amplitude;
        const double noise = search_.noise.floor / std::sqrt(2.0);
        const double squared = size * size / static_cast<double>(table_.points.size());
        cells.push_back({table_.name, {f, f}, {a, a}, quantity, size * size, std::abs(size) / noise, squared});
      }
    }
    for (gap::GapCell& cell : cells) {
      cell.share = sum > 0.0 ? cell.share / sum : 0.0;
    }
    std::stable_sort(cells.begin(), cells.end(),
                     [](const gap::GapCell& x, const gap::GapCell& y) { return x.share > y.share; });
    return cells;
  }

  WrittenLaw law() const {
    results::Sizes sizes = results::sizesOf(measured_.fitter(), {{results::fullLaw(judged_)}}, {}, search_, options_);
    WrittenLaw law;
    law.augmented = law.full = augmented_;
    law.gap_of_full = leftOfRows().full_law;
    law.numbers = results::rounded(std::move(sizes.written), augmented_, 0);
    law.model_sizes = std::move(sizes.model);
    law.effect_sizes = std::move(sizes.effects);
    return law;
  }

  const io::ComponentDescription& component_;
  const fit::MeasuredTable& table_;
  const MeasuredRows& measured_;
  const DiagnosisOptions& options_;
  std::shared_ptr<const Workings> workings_;
  const hypotheses::Search& search_;
  const judge::Answer& answer_;
  const hypotheses::FittedHypothesis& judged_;
  const io::ComponentDescription re_estimated_;
  const io::ComponentDescription augmented_;
  const std::vector<DiagnosedRow> rows_;
};

}  // namespace
}  // namespace rubber_suspension::diagnosis::table

namespace rubber_suspension::diagnosis {
namespace {

using table::MeasuredRows;

using Stiffness = std::vector<std::complex<double>>;

std::vector<double> squaresOf(const std::vector<fit::TablePoint>& points, const Stiffness& one,
                              const Stiffness& other) {
  std::vector<double> squares;
  for (std::size_t r = 0; r < points.size(); ++r) {
    const double square = std::norm((one[r] - other[r]) / points[r].stiffness);
    squares.push_back(std::isfinite(square) ? square : std::numeric_limits<double>::infinity());
  }
  return squares;
}

std::vector<double> errorsAsConfigured(const MeasuredRows& measured, const hypotheses::FittedHypothesis& configured) {
  const std::vector<fit::TablePoint>& points = measured.loops().points();
  return squaresOf(points, element::each(points, &fit::TablePoint::complexStiffness),
                   *measured.fitter().stiffness(configured.hypothesis, configured.fit.parameters));
}

std::vector<std::vector<double>> sizesOf(const MeasuredRows& measured, const hypotheses::FittedHypothesis& fitted) {
  const Stiffness with = *measured.fitter().stiffness(fitted.hypothesis, fitted.fit.parameters);
  std::vector<std::vector<double>> sizes;
  for (std::size_t m = 0; m < fitted.hypothesis.members.size(); ++m) {
    const Stiffness without = *measured.fitter().stiffness(fitted.hypothesis, hypotheses::withoutMember(fitted, m));
    sizes.push_back(squaresOf(measured.loops().points(), with, without));
  }
  return sizes;
}

// Returns the evidence of a search on the rows of a table, each of which counts as a log with one sine. The errors and
// sizes of each hypothesis are squared differences of K*, divided by |K*|^2.
judge::Evidence evidenceOfRows(const MeasuredRows& measured, const hypotheses::Search& search, int threads) {
  judge::Evidence evidence = hypotheses::evidenceOf(search);
  evidence.logs.assign(measured.loops().points().size(), {search.noise.floor, 0.0, 1.0, false, 1});
  fit::parallelFor(evidence.hypotheses.size(), threads, [&](std::size_t h) {
    const hypotheses::FittedHypothesis& fitted = search.at(static_cast<int>(h));
    evidence.hypotheses[h].log_errors = h == judge::Evidence::kAsConfigured
                                            ? errorsAsConfigured(measured, fitted)
                                            : element::each(fitted.fit.blocks, &gap::PartError::error);
    evidence.hypotheses[h].sizes = sizesOf(measured, fitted);
  });
  return evidence;
}

void checkRows(const io::ComponentDescription& component, const fit::MeasuredTable& table) {
  if (table.points.size() < kFewestRows) {
    throw std::invalid_argument(fmt::format("{}: has only {} rows; accepted: at least {} over frequency and amplitude",
                                            table.name, table.points.size(), kFewestRows));
  }
  const component::Component built = component.makeComponent();
  for (const element::ElementDescription& element : built.elements()) {
    if (const std::string& reason = effectNamed(element.type).not_beside_tables; !reason.empty()) {
      throw std::invalid_argument(
          fmt::format("{}: has the element {}, {}; accepted: logs, or the component without this element",
                      component.name, element.type, reason));
    }
  }
  const auto has_temperature = [](const fit::TablePoint& point) { return point.temperature.has_value(); };
  const auto having = std::count_if(table.points.begin(), table.points.end(), has_temperature);
  if (built.shiftsWithTemperature() && having == 0) {
    throw std::invalid_argument(
        fmt::format("{}: shifts with temperature, but {} has no column temperature; accepted: a table with the column "
                    "'temperature [degC]'",
                    component.name, table.name));
  }
  for (const fit::TablePoint& point : table.points) {
    if (point.temperature && !built.temperatures().contains(*point.temperature)) {
      throw std::invalid_argument(fmt::format("{}: temperature {:g} degC is out of range; accepted: {}", table.name,
                                              *point.temperature, element::describe(built.temperatures()) + " degC"));
    }
  }
}

std::optional<measurement::RigFinding> benchFinding(const io::ComponentDescription& component,
                                                    const fit::MeasuredTable& table, const MeasuredRows& measured) {
  const Stiffness configured = measured.loops().stiffnessOf(component.allElements());
  const auto finding =
      measurement::checkTable(table.name, element::each(table.points, &fit::TablePoint::complexStiffness), configured,
                              estimation::largestTolerance(component.specification()));
  const bool doubted = finding && (!table.accept_units || finding->finding == measurement::finding::kSign);
  return doubted ? finding : std::nullopt;
}

}  // namespace

Diagnosis diagnoseTable(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                        const DiagnosisOptions& options) {
  checkRows(component, table);
  const MeasuredRows measured(component, table.points, table::scatterOf(table.points, table.uncertainty));
  if (const auto finding = benchFinding(component, table, measured)) {
    Diagnosis result = prepare::refused(component, {*finding});
    result.table = DiagnosedTable{table.name, {}, table::neverShownByTables(), table.notes};
    return result;
  }
  hypotheses::Search search =
      hypotheses::search(measured, hypotheses::excludedEffects(component, options), options.threads, options.progress);
  judge::Evidence evidence = evidenceOfRows(measured, search, options.threads);
  auto workings = std::make_shared<const Workings>(std::move(search), std::move(evidence), options.evidence);
  return heldToInvariants(table::TableDescriber(component, table, measured, std::move(workings), options).run());
}

}  // namespace rubber_suspension::diagnosis
