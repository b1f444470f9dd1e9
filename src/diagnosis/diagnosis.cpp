// The diagnosis from logs to a report.
#include "rubber_suspension/diagnosis/diagnosis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>

#include "diagnosis/characteristics.h"
#include "rubber_suspension/diagnosis/excess.h"
#include "rubber_suspension/diagnosis/experiment.h"
#include "rubber_suspension/diagnosis/friction_noise.h"
#include "rubber_suspension/diagnosis/verdict.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/fit/bounded_least_squares.h"
#include "rubber_suspension/fit/parallel.h"

namespace rubber_suspension::diagnosis {
namespace {

// Squared error of a block of a log in units of its force's variance, and its share of all samples.
struct BlockError {
  double error;
  double weight;
};

using Forces = std::vector<Eigen::VectorXd>;

double rootMeanSquare(const std::vector<BlockError>& blocks) {
  double sum = 0.0;
  double weight = 0.0;
  for (const BlockError& block : blocks) {
    sum += block.weight * block.error;
    weight += block.weight;
  }
  return std::sqrt(sum / weight);
}

std::vector<BlockError> blocksOfFit(const fit::Fit& fit) {
  std::vector<BlockError> blocks;
  for (std::size_t b = 0; b < fit.block_errors.size(); ++b) {
    blocks.push_back({fit.block_errors[b], fit.block_weights[b]});
  }
  return blocks;
}

std::vector<BlockError> blocksOfReplay(const std::vector<log::Record>& records, const Forces& forces) {
  constexpr Eigen::Index kBlocks = 10;
  std::vector<BlockError> blocks;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const log::Record& record = records[r];
    for (Eigen::Index b = 0; b < kBlocks; ++b) {
      const Eigen::Index first = record.size() * b / kBlocks;
      const Eigen::Index count = record.size() * (b + 1) / kBlocks - first;
      const double squared = (record.force - forces[r]).segment(first, count).squaredNorm();
      const double share = static_cast<double>(count) / static_cast<double>(record.size());
      blocks.push_back({squared / (static_cast<double>(count) * std::pow(record.force_deviation, 2)), share});
    }
  }
  return blocks;
}

Eigen::VectorXd asRecorded(const log::Record& record) { return record.raw_displacement; }

// Each log on a new specimen at rest, from the displacement as recorded: what `replay` and the node compute.
Forces replayEach(const std::vector<element::ElementDescription>& elements, const std::vector<log::Record>& records) {
  Forces forces;
  for (const log::Record& record : records) {
    forces.push_back(fit::simulate(elements, {record}, asRecorded).front());
  }
  return forces;
}

// More than all is closed where the floor was taken for higher than it is.
constexpr double kMostClosed = 1.1;

double closedFraction(double re_estimated, double augmented, double floor) {
  const double closable = re_estimated - floor;
  return closable > 1e-12 ? std::clamp((re_estimated - augmented) / closable, -1.0, kMostClosed) : 0.0;
}

// Standard error of the logarithm of the noise floor: 95 of 100 estimates of virtual rigs lay between 0.74 and 2.2
// times their true floors.
constexpr double kFloorDoubt = 0.3;

std::array<double, 2> closedInterval(const std::vector<BlockError>& before, const std::vector<BlockError>& after,
                                     double floor, const DiagnosisOptions& options) {
  std::mt19937 generator(options.seed);
  std::uniform_int_distribution<std::size_t> pick(0, before.size() - 1);
  std::normal_distribution<double> doubt(0.0, kFloorDoubt);
  std::vector<double> fractions;
  for (int i = 0; i < options.resamplings; ++i) {
    std::vector<BlockError> a;
    std::vector<BlockError> b;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const std::size_t chosen = pick(generator);
      a.push_back(before[chosen]);
      b.push_back(after[chosen]);
    }
    fractions.push_back(closedFraction(rootMeanSquare(a), rootMeanSquare(b), floor * std::exp(doubt(generator))));
  }
  std::sort(fractions.begin(), fractions.end());
  const auto at = [&](double share) {
    return fractions[static_cast<std::size_t>(share * static_cast<double>(fractions.size() - 1))];
  };
  return {at(0.025), at(0.975)};
}

// What mounts of either side have in common as one mount, and one for the rest of the softer side.
void writeCommonPartOfMounts(std::vector<element::ElementDescription>& entries) {
  const auto mountOf = [&](double side) {
    return std::find_if(entries.begin(), entries.end(), [&](const element::ElementDescription& entry) {
      return entry.type == "series_compliance" && entry.values.count("side") != 0 && entry.value("side") == side;
    });
  };
  auto stiff = mountOf(1.0);
  auto soft = mountOf(-1.0);
  if (stiff == entries.end() || soft == entries.end()) {
    return;
  }
  if (stiff->value("stiffness") < soft->value("stiffness")) {
    std::swap(stiff, soft);
  }
  const double rest = 1.0 / soft->value("stiffness") - 1.0 / stiff->value("stiffness");
  stiff->values.erase("side");
  if (rest > 0.0) {
    soft->values["stiffness"] = {1.0 / rest};
  } else {
    entries.erase(soft);
  }
}

// The entries of a fitted trial as a user would write them: sliders of one friction in one table.
std::vector<element::ElementDescription> entriesOf(const Trial& trial) {
  std::vector<element::ElementDescription> entries;
  element::ElementDescription sliders{"iwan_table", {{"yield_displacement", {}}, {"stiffness", {}}}};
  for (std::size_t a = 0; a < trial.atoms.size(); ++a) {
    const double scale = trial.fit.point.scales[static_cast<Eigen::Index>(a)];
    if (scale == 0.0) {
      continue;
    }
    const element::ElementDescription entry = trial.atoms[a].at(scale);
    if (entry.type == sliders.type) {
      for (auto& [name, values] : sliders.values) {
        values.push_back(entry.value(name));
      }
    } else {
      entries.push_back(entry);
    }
  }
  if (!sliders.values["stiffness"].empty()) {
    entries.insert(entries.begin(), sliders);
  }
  writeCommonPartOfMounts(entries);
  return entries;
}

// Headline numbers of an effect for the report; all of them are in `add`.
std::map<std::string, double> parametersOf(const std::vector<element::ElementDescription>& entries) {
  std::map<std::string, double> result;
  for (const element::ElementDescription& entry : entries) {
    if (entry.type == "iwan_table") {
      double force = 0.0;
      for (std::size_t i = 0; i < entry.list("stiffness").size(); ++i) {
        force += entry.list("stiffness")[i] * entry.list("yield_displacement")[i];
      }
      result["maximum_force"] = force;
      continue;
    }
    for (const auto& [name, values] : entry.values) {
      std::string key = name;
      for (int i = 2; result.count(key) != 0; ++i) {
        key = fmt::format("{}_{}", name, i);
      }
      result[key] = values.at(0);
    }
  }
  return result;
}

double meanFrequency(const log::Record& record) {
  const Eigen::Index steps = record.size() - 1;
  const double rate = std::sqrt((record.displacement.tail(steps) - record.displacement.head(steps)).squaredNorm() /
                                static_cast<double>(steps)) /
                      record.dt;
  const double deviation = std::sqrt((record.displacement.array() - record.displacement.mean()).square().mean());
  return rate / (2.0 * element::kPi * deviation);
}

// What each log alone would make of the model's own parameters, by one Gauss-Newton step from the joint fit. Directions
// that a log hardly determines stay near the joint fit: a prior of 10 % keeps them there.
std::vector<ParameterByLog> parametersByLog(const fit::Fitter& fitter, const fit::Fit& joint) {
  constexpr double kPrior = 0.1;
  std::vector<ParameterByLog> result;
  const fit::BlockGrams blocks = fitter.linearise(joint.point, {}, false);
  const Eigen::Index own = fitter.own().size();
  for (std::size_t r = 0; r < fitter.records().size(); ++r) {
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(own + 1, own + 1);
    for (std::size_t b = 0; b < blocks.gram.size(); ++b) {
      if (blocks.record[b] == static_cast<int>(r)) {
        gram += static_cast<double>(fitter.records().size()) * blocks.gram[b];
      }
    }
    const double variance = std::max(gram(own, own), 1e-12);
    Eigen::MatrixXd normal = gram.topLeftCorner(own, own);
    normal.diagonal().array() += variance / (kPrior * kPrior) / 100.0;
    const Eigen::VectorXd infinite = Eigen::VectorXd::Constant(own, 2.0);
    const Eigen::VectorXd step = fit::boundedLeastSquares(normal, gram.col(own).head(own), -infinite, infinite);
    const log::Record& record = fitter.records()[r];
    ParameterByLog row;
    row.log = record.name;
    row.amplitude = std::sqrt(2.0 * (record.displacement.array() - record.displacement.mean()).square().mean());
    row.frequency = meanFrequency(record);
    row.ratios = fitter.own().ratios(joint.point.own + step);
    result.push_back(std::move(row));
  }
  return result;
}

std::vector<log::Record> makeRecords(const std::vector<log::Log>& logs, int threads) {
  std::vector<log::Record> records(logs.size());
  fit::parallelFor(logs.size(), threads, [&](std::size_t i) { records[i] = log::makeRecord(logs[i]); });
  return records;
}

io::ComponentDescription augmentedDescription(const fit::OwnParameters& own, const Trial& trial) {
  io::ComponentDescription result = own.apply(trial.fit.point.own);
  const auto entries = entriesOf(trial);
  result.add.insert(result.add.end(), entries.begin(), entries.end());
  return result;
}

// Share of a log whose displacement repeats what it did one period before, the period being where the displacement
// resembles itself best; repeats let noise be told from error without a model.
double repeatsOf(const log::Record& record) {
  constexpr double kSame = 0.05;  // difference over deviation that counts as a repeat
  constexpr Eigen::Index kCoarse = 1024;
  const Eigen::Index stride = std::max<Eigen::Index>(1, record.size() / kCoarse);
  const Eigen::Index count = record.size() / stride;
  Eigen::VectorXd z(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    z[i] = record.displacement[i * stride];
  }
  z.array() -= z.mean();
  const double deviation = std::sqrt(z.squaredNorm() / static_cast<double>(count));
  double best = 0.0;
  for (Eigen::Index lag = 4; lag < count / 2; ++lag) {
    const Eigen::Index rest = count - lag;
    const Eigen::ArrayXd difference = (z.tail(rest) - z.head(rest)).array().abs();
    const auto same = (difference < kSame * deviation).count();
    best = std::max(best, static_cast<double>(same) / static_cast<double>(count));
  }
  return best;
}

Admission admit(const log::Record& record, bool hold_out, double noise) {
  Admission admission;
  admission.log = record.name;
  admission.hold_out = hold_out;
  admission.duration = record.duration();
  admission.dt = record.dt;
  admission.largest_displacement = record.displacement.cwiseAbs().maxCoeff();
  admission.highest_frequency = record.highest_frequency;
  admission.noise = noise;
  admission.repeats = repeatsOf(record);
  admission.notes = record.notes;
  return admission;
}

class Diagnoser {
 public:
  Diagnoser(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
            const std::vector<log::Log>& hold_out, const DiagnosisOptions& options)
      : options_(options),
        component_(component),
        training_(makeRecords(logs, options.threads)),
        held_out_(makeRecords(hold_out, options.threads)),
        own_(component, fit::Level::specification),
        own_elements_(component, fit::Level::elements),
        fitter_(training_, own_),
        element_fitter_(training_, own_elements_) {}

  Diagnosis run() {
    result_.component = component_.name;
    result_.search = search(fitter_, element_fitter_, options_.threads, options_.progress);
    result_.re_estimated = own_.apply(result_.search.re_estimated.fit.point.own);
    for (std::size_t most = 3;; --most) {
      verdict_ = decide(result_.search, most);
      preferWhatForeseesUnseenLogs(most);
      result_.augmented = augmentedDescription(own_, verdict_.model);
      simulateAll();
      measureGap();
      if (most == 0 || holdsOnUnseenLogs()) {
        break;
      }
      most = std::min(most, verdict_.effects.size());  // fewer effects than were named in vain
    }
    forgiveWhatUnseenLogsDoNotShow();
    doubtWhereUnseenLogsDiffer();
    describeCandidates();
    describeOwnParameters();
    describeVerdict();
    return std::move(result_);
  }

 private:
  void simulateAll() {
    result_.records = training_;
    result_.records.insert(result_.records.end(), held_out_.begin(), held_out_.end());
    result_.training = training_.size();
    const auto all = [&](const io::ComponentDescription& description) {
      const auto elements = description.allElements();
      Forces forces = fit::simulate(elements, training_, asRecorded);
      const Forces unseen = replayEach(elements, held_out_);
      forces.insert(forces.end(), unseen.begin(), unseen.end());
      return forces;
    };
    const std::array<std::pair<const io::ComponentDescription*, Forces*>, 3> models = {
        {{&component_, &result_.force_configured},
         {&result_.re_estimated, &result_.force_re_estimated},
         {&result_.augmented, &result_.force_augmented}}};
    fit::parallelFor(models.size(), options_.threads,
                     [&](std::size_t i) { *models[i].second = all(*models[i].first); });
  }

  // A trend follows whatever is slow, creep for one, but foresees nothing: where effects without a trend close half of
  // the gap of unseen logs, and clearly more than with it, these are named.
  void preferWhatForeseesUnseenLogs(std::size_t most) {
    constexpr double kHalf = 0.5;
    constexpr double kClearly = 0.15;
    if (held_out_.empty() || !hasTrends(result_.search.candidates, verdict_.effects)) {
      return;
    }
    Verdict other = decide(result_.search, most, false);
    if (other.effects.empty()) {
      return;
    }
    const double before = unseenGap(result_.search.re_estimated);
    const double after = unseenGap(other.model);
    if (after < (1.0 - kHalf) * before && after < unseenGap(verdict_.model) - kClearly * before) {
      verdict_ = std::move(other);
    }
  }

  // Effects are named only if they gain at least 5 % on logs that took no part in the fit, or lose little where own
  // parameters far from their configuration would do as well; a drift, which cannot be foreseen, only has to lose
  // little. The displacement is smoothed as for the fits: a mass or a dashpot may be there, and yet make more noise of
  // a sensor's noise than it explains.
  bool holdsOnUnseenLogs() const {
    constexpr double kLeastGain = 0.05;
    constexpr double kLittle = 1.2;
    constexpr double kShowsNothing = 1.1;  // times the floor: such logs speak neither for an effect nor against it
    if (held_out_.empty() || verdict_.effects.empty()) {
      return true;
    }
    const double before = unseenGap(result_.search.re_estimated);
    const double after = unseenGap(verdict_.model);
    if (before < kShowsNothing * result_.gap.noise_floor) {
      return true;
    }
    return closedFraction(before, after, result_.gap.noise_floor) >= kLeastGain ||
           ((isDriftAlone() || closedByOwnParameters(result_.search)) &&
            after < kLittle * before + result_.gap.noise_floor);
  }

  bool isDriftAlone() const {
    return verdict_.effects.size() == 1 && hasTrends(result_.search.candidates, verdict_.effects);
  }

  // What a gap on unseen logs is beyond their floor.
  double unseenExcess(double gap) const {
    return std::sqrt(std::max(0.0, gap * gap - std::pow(result_.gap.noise_floor, 2)));
  }

  // What no effect or a drift in part explains, and unseen logs do not show, is noise in the band of the motion, unless
  // it is large.
  void forgiveWhatUnseenLogsDoNotShow() {
    constexpr double kLarge = 2.5;  // times the floor, on the logs of the fit
    const Search& s = result_.search;
    const Trial& re_estimated = s.re_estimated;
    const bool unexplained =
        verdict_.kind == VerdictKind::unknown || (verdict_.kind == VerdictKind::partly && isDriftAlone());
    if (held_out_.empty() || !unexplained || excess(s, re_estimated.fit.held_out) > kLarge * s.noise) {
      return;
    }
    if (unseenExcess(result_.gap.as_configured) < insignificant(s)) {
      unname(VerdictKind::none);
      verdict_.model.fit.point.own.setZero();
      result_.augmented = component_;
    } else if (unseenExcess(result_.gap.re_estimated) < insignificant(s)) {
      unname(VerdictKind::parameter_error);
      result_.augmented = result_.re_estimated;
    } else {
      return;
    }
    simulateAll();
    measureGap();
  }

  void unname(VerdictKind kind) {
    verdict_.kind = kind;
    verdict_.effects.clear();
    verdict_.confounded.clear();
    verdict_.model = result_.search.re_estimated;
  }

  // A model that the logs of the fit bear out, and unseen logs do not, lacks what only these show.
  void doubtWhereUnseenLogsDiffer() {
    constexpr double kClearly =
        0.05;  // of the force: a sensor's noise through the model made up to 0.035 of virtual rigs
    constexpr double kOverFloor = 5.0;
    const bool none = verdict_.kind == VerdictKind::none;
    if (held_out_.empty() || !(none || verdict_.kind == VerdictKind::parameter_error)) {
      return;
    }
    const double left = unseenExcess(none ? result_.gap.as_configured : result_.gap.re_estimated);
    if (left > std::max(kClearly, kOverFloor * result_.gap.noise_floor)) {
      verdict_.kind = VerdictKind::unknown;
      only_unseen_logs_differ_ = true;
    }
  }

  double unseenGap(const Trial& trial) const {
    Forces forces;
    for (const log::Record& record : held_out_) {
      std::vector<fit::Atom> atoms = trial.atoms;
      for (fit::Atom& atom : atoms) {
        atom.unit_effect = atom.exact ? std::make_shared<const Forces>(Forces{atom.exact(record)}) : nullptr;
      }
      forces.push_back(fit::Fitter({record}, own_).forces(trial.fit.point, atoms)->front());
    }
    return rootMeanSquare(blocksOfReplay(held_out_, forces));
  }

  Forces unseen(const Forces& forces) const {
    return Forces(forces.begin() + static_cast<std::ptrdiff_t>(training_.size()), forces.end());
  }

  void measureGap() {
    const Search& s = result_.search;
    result_.noise_source = s.noise_source;
    std::vector<double> noise = s.record_noise;
    if (held_out_.empty()) {
      before_ = blocksOfFit(s.re_estimated.fit);
      after_ = blocksOfFit(verdict_.model.fit);
      result_.gap = {s.configured_gap, rootMeanSquare(before_), rootMeanSquare(after_), s.noise};
    } else {
      before_ = blocksOfReplay(held_out_, unseen(result_.force_re_estimated));
      after_ = blocksOfReplay(held_out_, unseen(result_.force_augmented));
      const std::vector<double> floors = unseenNoise();
      noise.insert(noise.end(), floors.begin(), floors.end());
      const double squares = std::inner_product(floors.begin(), floors.end(), floors.begin(), 0.0);
      result_.gap = {rootMeanSquare(blocksOfReplay(held_out_, unseen(result_.force_configured))),
                     rootMeanSquare(before_), rootMeanSquare(after_),
                     std::sqrt(squares / static_cast<double>(floors.size()))};
    }
    result_.closed =
        std::min(1.0, closedFraction(result_.gap.re_estimated, result_.gap.augmented, result_.gap.noise_floor));
    result_.closed_interval = closedInterval(before_, after_, result_.gap.noise_floor, options_);
    result_.admission.resize(noise.size());
    fit::parallelFor(noise.size(), options_.threads, [&](std::size_t r) {
      result_.admission[r] = admit(result_.records[r], r >= training_.size(), noise[r]);
    });
    mapGap();
  }

  // Noise floors of the unseen logs.
  std::vector<double> unseenNoise() const {
    std::vector<double> floors = frictionNoise(result_.augmented.allElements(), held_out_);
    for (std::size_t r = 0; r < held_out_.size(); ++r) {
      const Eigen::VectorXd left = held_out_[r].force - result_.force_augmented[training_.size() + r];
      floors[r] = std::max(log::whiteNoiseFloor(held_out_[r], left), floors[r]);
    }
    return floors;
  }

  // Errors over frequency, amplitude and time, on the logs that the gap is of; where the configured model is wrong.
  void mapGap() {
    const std::vector<log::Record>& records = held_out_.empty() ? training_ : held_out_;
    const auto of = [&](const Forces& forces) { return held_out_.empty() ? forces : unseen(forces); };
    const std::array<std::function<void()>, 3> tasks = {
        [&] { result_.errors_before = characteristicErrors(records, of(result_.force_re_estimated)); },
        [&] { result_.errors_after = characteristicErrors(records, of(result_.force_augmented)); },
        [&] {
          Forces residual;
          for (std::size_t r = 0; r < training_.size(); ++r) {
            residual.push_back(training_[r].force - result_.force_configured[r]);
          }
          result_.where = gap::gapMap(training_, residual, result_.search.record_noise);
        }};
    fit::parallelFor(tasks.size(), options_.threads, [&](std::size_t i) { tasks[i](); });
  }

  void describeCandidates() {
    result_.candidates.resize(result_.search.candidates.size());
    fit::parallelFor(result_.candidates.size(), options_.threads,
                     [&](std::size_t c) { result_.candidates[c] = describeCandidate(c); });
    std::stable_sort(result_.candidates.begin(), result_.candidates.end(),
                     [](const CandidateResult& a, const CandidateResult& b) {
                       return a.probability != b.probability ? a.probability > b.probability : a.closed > b.closed;
                     });
  }

  CandidateResult describeCandidate(std::size_t c) const {
    const Search& s = result_.search;
    const Trial& trial = s.singles[c];
    const std::vector<BlockError> errors =
        held_out_.empty()
            ? blocksOfFit(trial.fit)
            : blocksOfReplay(held_out_, replayEach(augmentedDescription(own_, trial).allElements(), held_out_));
    CandidateResult candidate;
    candidate.effect = s.candidates[c].effect;
    candidate.documentation = s.candidates[c].documentation;
    candidate.on_rig = s.candidates[c].on_rig;
    candidate.probability = verdict_.probabilities[c];
    candidate.gap = rootMeanSquare(errors);
    candidate.closed = std::min(1.0, closedFraction(result_.gap.re_estimated, candidate.gap, result_.gap.noise_floor));
    candidate.interval = closedInterval(before_, errors, result_.gap.noise_floor, options_);
    candidate.visible_share = s.visible_share[c];
    const auto& named = verdict_.effects;
    candidate.testable =
        shows(s, static_cast<int>(c)) || std::find(named.begin(), named.end(), static_cast<int>(c)) != named.end();
    candidate.add = entriesOf(trial);
    candidate.parameters = parametersOf(candidate.add);
    return candidate;
  }

  void describeOwnParameters() {
    const fit::Fit& joint = result_.search.re_estimated.fit;
    result_.own_ratios = own_.ratios(joint.point.own);
    result_.by_log = parametersByLog(fitter_, joint);
  }

  void describeVerdict() {
    result_.verdict = toString(verdict_.kind);
    result_.probability_none = verdict_.probability_none_of_these;
    for (const int effect : verdict_.effects) {
      result_.effects.push_back(name(effect));
    }
    for (const auto& set : verdict_.confounded) {
      result_.confounded.emplace_back();
      for (const int effect : set) {
        result_.confounded.back().push_back(name(effect));
      }
    }
    result_.next_experiment = nextExperiment();
    result_.sentence = sentence();
  }

  const std::string& name(int candidate) const {
    return result_.search.candidates[static_cast<std::size_t>(candidate)].effect;
  }

  // The two explanations that the next experiment should tell apart: the one named and the best that is not in it.
  std::string nextExperiment() const {
    const Search& s = result_.search;
    const Trial* rival = nullptr;
    for (const auto* trials : {&s.singles, &s.pairs}) {
      for (const Trial& trial : *trials) {
        const bool other = !verdict_.model.members.empty() && trial.members.size() == verdict_.model.members.size() &&
                           trial.members != verdict_.model.members;
        const bool first = verdict_.model.members.empty() && trial.members.size() == 1;
        if ((other || first) && (rival == nullptr || trial.fit.held_out < rival->fit.held_out)) {
          rival = &trial;
        }
      }
    }
    if (rival == nullptr) {
      return "None of the menu: no second explanation was fitted.";
    }
    const auto menu = experimentMenu(s.excitation);
    const double noise = std::max(s.noise, 1e-4) * s.excitation.force;
    const auto best =
        mostTelling(menu, result_.augmented.allElements(), augmentedDescription(own_, *rival).allElements(), noise);
    if (best.experiment == nullptr) {
      return "None of the menu would tell the explanations apart.";
    }
    return fmt::format("{}: there {} and {} differ by {:.1f} times the noise floor.", best.experiment->description,
                       membersText(verdict_.model), membersText(*rival), best.difference);
  }

  std::string membersText(const Trial& trial) const {
    std::string text;
    for (const int member : trial.members) {
      text += (text.empty() ? "" : " + ") + name(member);
    }
    return text.empty() ? "the model as it is" : text;
  }

  std::string namesText() const {
    std::string text;
    for (const std::string& effect : result_.effects) {
      text += (text.empty() ? "" : " and ") + effect;
    }
    return text;
  }

  std::string setsText() const {
    std::string text;
    for (const auto& set : result_.confounded) {
      if (set.size() > 1) {
        text += (text.empty() ? "" : "; ") + fmt::format("{}", fmt::join(set, ", "));
      }
    }
    return text;
  }

  std::string sentence() const {
    const Gap& gap = result_.gap;
    const std::string closes = fmt::format(
        "adding {} closes {:.0f} % of what re-estimation leaves (gap {:.1f} % to {:.1f} %, noise floor {:.1f} %)",
        namesText(), 100.0 * result_.closed, 100.0 * gap.re_estimated, 100.0 * gap.augmented, 100.0 * gap.noise_floor);
    switch (verdict_.kind) {
      case VerdictKind::none:
        return fmt::format(
            "The model agrees with the measurement: the gap of {:.1f} % is at the noise floor of {:.1f} %.",
            100.0 * gap.as_configured, 100.0 * gap.noise_floor);
      case VerdictKind::parameter_error:
        return fmt::format(
            "The model's parameters are off: re-estimating them reduces the gap from {:.1f} % to {:.1f} %.",
            100.0 * gap.as_configured, 100.0 * gap.re_estimated);
      case VerdictKind::named:
        return fmt::format("The model lacks {}: {}.", namesText(), closes);
      case VerdictKind::confounded:
        return fmt::format("The model most probably lacks {}: {}. These logs cannot tell apart: {}.", namesText(),
                           closes, setsText());
      case VerdictKind::partly:
        return fmt::format(
            "The model lacks {}, and something else: {}; a significant part of the gap remains unexplained.",
            namesText(), closes);
      default:
        if (only_unseen_logs_differ_) {
          return fmt::format(
              "The logs of the fit confirm the model, the unseen ones do not (gap {:.1f} %, noise floor {:.1f} %): "
              "they show "
              "something that the logs of the fit do not. Fit logs that cover the same range.",
              100.0 * gap.augmented, 100.0 * gap.noise_floor);
        }
        return fmt::format(
            "The gap of {:.1f} % is real (noise floor {:.1f} %) and no effect of the list explains it: {}",
            100.0 * gap.re_estimated, 100.0 * gap.noise_floor, "see where it lies before you trust the model there.");
    }
  }

  const DiagnosisOptions& options_;
  const io::ComponentDescription& component_;
  std::vector<log::Record> training_;
  std::vector<log::Record> held_out_;
  fit::OwnParameters own_;
  fit::OwnParameters own_elements_;
  fit::Fitter fitter_;
  fit::Fitter element_fitter_;
  Verdict verdict_;
  std::vector<BlockError> before_;
  std::vector<BlockError> after_;
  bool only_unseen_logs_differ_ = false;
  Diagnosis result_;
};

}  // namespace

Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options) {
  if (logs.empty()) {
    throw log::LogError("no log: a diagnosis needs at least one");
  }
  return Diagnoser(component, logs, hold_out, options).run();
}

}  // namespace rubber_suspension::diagnosis
