// What a fleet says that a single component cannot.
#include "campaign/fleet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <iterator>
#include <set>

#include "campaign/record.h"
#include "log/text.h"

namespace rubber_suspension::campaign {
namespace {

using diagnosis::Verdict;
using nlohmann::ordered_json;

constexpr double kJeffreys = 0.5;                        // prior count of each cause
constexpr const char* kWrongValues = "parameter_error";  // among the effects of a set
constexpr const char* kCompliance = "series_compliance";
constexpr const char* kGain = "sensor_gain";
constexpr double kChance = 0.05;  // that a value right for the type is called wrong, over all parameters of a type

// Standard deviation of the logarithm of a rig's gain, which all components on it share: the usual tolerance of 0.5 %
// (io::RigTolerances) as two of them.
constexpr double kGainError = 0.0025;

// Nothing for null, which stands for a value that is not finite, and for what has no logarithm.
std::optional<double> logarithm(const ordered_json& value) {
  if (!value.is_number() || !(value.get<double>() > 0.0)) {
    return std::nullopt;
  }
  return std::log(value.get<double>());
}

constexpr double kHalfInterval = 1.96;  // standard errors of a normal distribution in half of a 95 % interval

// By re-estimation alone.
ParameterChanges reEstimated(const ordered_json& evidence) {
  ParameterChanges changes;
  for (const auto& [name, ratio] : evidence.at("ratios").items()) {
    const auto value = logarithm(ratio);
    if (!value) {
      continue;
    }
    ParameterChange change;
    change.logarithm = *value;
    double mean = 0.0;
    for (const ordered_json& log : evidence.at("ratios_by_log")) {
      const auto alone = log.contains(name) ? logarithm(log.at(name)) : std::nullopt;
      if (alone) {  // running mean and sum of squares (Welford)
        ++change.logs;
        const double distance = *alone - mean;
        mean += distance / static_cast<double>(change.logs);
        change.squares += distance * (*alone - mean);
      }
    }
    changes[name] = change;
  }
  return changes;
}

// Of parameters that the logs determine.
ParameterChanges changesOfEstimate(const ordered_json& evidence) {
  ParameterChanges changes;
  for (const ordered_json& parameter : evidence.at("parameters")) {
    const auto value = logarithm(parameter.at("value"));
    const auto given = logarithm(parameter.at("given"));
    const auto lower = logarithm(parameter.at("lower"));
    const auto upper = logarithm(parameter.at("upper"));
    if (value && given && lower && upper && parameter.at("determined").get<bool>()) {
      changes[parameter.at("name").get<std::string>()] = {*value - *given, 0.0, 1,
                                                          (*upper - *lower) / (2.0 * kHalfInterval)};
    }
  }
  return changes;
}

// The cause of which a component's own logs leave no doubt: an effect, "" for none; nothing where they do.
std::optional<std::string> sureCause(const FleetComponent& component) {
  const bool tells = component.verdict == Verdict::none || component.verdict == Verdict::parameter_error ||
                     component.verdict == Verdict::named;
  if (!tells || component.explanations.size() != 1) {
    return std::nullopt;
  }
  return component.effects.empty() ? "" : component.explanations.front().cause;
}

bool mayBe(const FleetComponent& component, const char* cause) {
  return std::any_of(component.explanations.begin(), component.explanations.end(),
                     [&](const OwnExplanation& own) { return own.cause == cause; });
}

// True where these logs name nothing but what of a rig is like wrong values.
bool leavesLikeValuesAlone(const FleetComponent& component) {
  return std::all_of(component.effects.begin(), component.effects.end(),
                     [](const std::string& name) { return name == kCompliance || name == kGain; });
}

// No gap and wrong values are one cause: none of the effects.
void addExplanation(const std::vector<std::string>& effects, const ordered_json& probability,
                    FleetComponent& component) {
  const std::string cause = effects.empty() ? kWrongValues : fmt::format("{}", fmt::join(effects, " + "));
  const double own = probability.is_number() ? probability.get<double>() : 0.0;
  const auto found = std::find_if(component.explanations.begin(), component.explanations.end(),
                                  [&](const OwnExplanation& other) { return other.cause == cause; });
  if (found == component.explanations.end()) {
    component.explanations.push_back({cause, own});
  } else {
    found->probability += own;
  }
}

void setParameters(FleetComponent& component, const ordered_json& evidence) {
  // Of logs that cannot be what they say nothing is known, and what no model explains bends its values.
  if (component.verdict == Verdict::check_bench || component.verdict == Verdict::unknown ||
      !leavesLikeValuesAlone(component)) {
    return;
  }
  if (component.effects.empty() || mayBe(component, kWrongValues)) {
    component.parameters = reEstimated(evidence);
  }
}

double errorOf(const ParameterChange& change, double deviation_of_logs) {
  return change.standard_error > 0.0
             ? change.standard_error
             : deviation_of_logs / std::sqrt(static_cast<double>(std::max<std::size_t>(change.logs, 1)));
}

// Standard deviation between logs of one component, pooled over all of them.
double deviationOfLogs(const std::vector<FleetComponent>& components, const std::string& name) {
  double squares = 0.0;
  double degrees = 0.0;
  for (const FleetComponent& component : components) {
    const auto found = component.parameters.find(name);
    if (found != component.parameters.end() && found->second.logs > 1) {
      squares += found->second.squares;
      degrees += static_cast<double>(found->second.logs - 1);
    }
  }
  return degrees > 0.0 ? std::sqrt(squares / degrees) : 0.0;
}

std::string percentOfLogarithm(double logarithm) { return fmt::format("{:.1f} %", 100.0 * std::expm1(logarithm)); }

class Analysis {
 public:
  Analysis(const std::string& name, const std::vector<FleetComponent>& components) {
    type_.name = name;
    type_.components = components;
  }

  FleetType run() {
    for (const FleetComponent& component : type_.components) {
      if (component.verdict) {
        ++type_.verdicts[toString(*component.verdict)];
      }
    }
    compareParameters();
    countEffects();
    decideConfounded();
    explainParameterErrors();
    return std::move(type_);
  }

 private:
  void compareParameters() {
    std::set<std::string> names;
    for (const FleetComponent& component : type_.components) {
      for (const auto& [name, change] : component.parameters) {
        names.insert(name);
      }
    }
    for (const std::string& name : names) {
      addParameter(name);
    }
    markWrongForAll();
    std::stable_sort(type_.stand_outs.begin(), type_.stand_outs.end(),
                     [](const StandOut& a, const StandOut& b) { return std::abs(a.robust_z) > std::abs(b.robust_z); });
  }

  void addParameter(const std::string& name) {
    const double deviation = deviationOfLogs(type_.components, name);
    FleetParameter parameter;
    parameter.name = name;
    for (std::size_t i = 0; i < type_.components.size(); ++i) {
      const auto found = type_.components[i].parameters.find(name);
      if (found != type_.components[i].parameters.end()) {
        parameter.components.push_back(i);
        parameter.observations.push_back({found->second.logarithm, errorOf(found->second, deviation)});
      }
    }
    parameter.model = fitRandomEffects(parameter.observations, kGainError);
    for (std::size_t i = 0; parameter.model && i < parameter.components.size(); ++i) {
      const double distance = std::abs(parameter.observations[i].value - parameter.model->median);
      if (std::abs(parameter.model->robust_z[i]) > parameter.model->z_limit && distance > kWorthSaying) {
        type_.stand_outs.push_back(
            {parameter.components[i], name, std::exp(parameter.observations[i].value), parameter.model->robust_z[i]});
      }
    }
    type_.parameters.push_back(std::move(parameter));
  }

  void markWrongForAll() {
    const auto tried =
        static_cast<double>(std::count_if(type_.parameters.begin(), type_.parameters.end(),
                                          [](const FleetParameter& parameter) { return parameter.model.has_value(); }));
    for (FleetParameter& parameter : type_.parameters) {
      parameter.wrong_for_all = parameter.model && parameter.model->mean_chance < kChance / tried &&
                                std::abs(parameter.model->mean) > kWorthSaying;
    }
  }

  void countEffects() {
    std::map<std::string, EffectShare> shares;
    for (const FleetComponent& component : type_.components) {
      for (const std::string& effect : component.effects) {
        ++shares[effect].named;
      }
      const auto cause = sureCause(component);
      if (cause) {
        ++shares[*cause].sure;
        ++sure_;
      }
    }
    for (auto& [effect, share] : shares) {
      share.effect = effect;
      const double others = static_cast<double>(sure_ - share.sure) + kJeffreys;
      const boost::math::beta_distribution<> beta(static_cast<double>(share.sure) + kJeffreys, others);
      share.share = mean(beta);
      share.interval = {quantile(beta, 0.025), quantile(beta, 0.975)};
      type_.effects.push_back(share);
    }
    std::stable_sort(type_.effects.begin(), type_.effects.end(),
                     [](const EffectShare& a, const EffectShare& b) { return a.sure > b.sure; });
  }

  // Wrong values count as no effect, as in sureCause().
  std::size_t sureOf(const std::string& effect) const {
    for (const EffectShare& share : type_.effects) {
      if (share.effect == (effect == kWrongValues ? std::string() : effect)) {
        return share.sure;
      }
    }
    return 0;
  }

  void decideConfounded() {
    for (std::size_t i = 0; i < type_.components.size(); ++i) {
      const FleetComponent& component = type_.components[i];
      if (component.explanations.size() > 1 && component.verdict != Verdict::unknown) {
        decide(i, component.explanations);
      }
    }
  }

  // Only within the set: what its own logs exclude, the fleet does not bring back.
  void decide(std::size_t place, const std::vector<OwnExplanation>& set) {
    const FleetComponent& component = type_.components[place];
    if (mayBe(component, kWrongValues) && (mayBe(component, kCompliance) || mayBe(component, kGain))) {
      return;  // re-estimation does the same
    }
    std::vector<double> weights;
    double sum_alone = 0.0;
    double sum = 0.0;
    for (const OwnExplanation& own : set) {
      weights.push_back(own.probability * (static_cast<double>(sureOf(own.cause)) + kJeffreys));
      sum_alone += own.probability;
      sum += weights.back();
    }
    if (sure_ < kFewestComponents || !(sum > 0.0)) {
      return;
    }
    const auto best = static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    const bool is_said = best == 0 && component.verdict != Verdict::confounded;
    if (weights[best] / sum < kDecided || is_said) {
      return;
    }
    std::string others;
    for (std::size_t i = 0; i < set.size(); ++i) {
      others +=
          i == best ? "" : fmt::format("{}{} in {}", others.empty() ? "" : ", ", set[i].cause, sureOf(set[i].cause));
    }
    type_.changed.push_back(
        {place, verdictOf(component), set[best].cause == kWrongValues ? kWrongValues : "named: " + set[best].cause,
         fmt::format("of {} components of this type whose own logs leave one cause, {} is it in {}, {}: {:.0f} % "
                     "within the set, by its own logs {:.0f} %",
                     sure_, set[best].cause, sureOf(set[best].cause), others, 100.0 * weights[best] / sum,
                     100.0 * set[best].probability / sum_alone)});
  }

  static std::string verdictOf(const FleetComponent& component) {
    std::vector<std::string> causes;
    std::transform(component.explanations.begin(), component.explanations.end(), std::back_inserter(causes),
                   [](const OwnExplanation& own) { return own.cause; });
    const std::string verdict = component.verdict ? toString(*component.verdict) : "";
    return causes.size() < 2 && component.effects.empty() ? verdict : verdict + ": " + log::join(causes);
  }

  bool standsOut(std::size_t component) const {
    return std::any_of(type_.stand_outs.begin(), type_.stand_outs.end(),
                       [&](const StandOut& one) { return one.component == component; });
  }

  bool isChanged(std::size_t component) const {
    return std::any_of(type_.changed.begin(), type_.changed.end(),
                       [&](const ChangedVerdict& one) { return one.component == component; });
  }

  // A gain that one rig has would be the same for all on it: scatter speaks against it.
  static bool hasGainBesideValues(const FleetComponent& component) {
    return component.explanations.size() == 2 && mayBe(component, kGain) && mayBe(component, kWrongValues);
  }

  void explainParameterErrors() {
    std::string common;
    std::string scatter;
    bool modelled = false;
    for (const FleetParameter& parameter : type_.parameters) {
      if (!parameter.model) {
        continue;
      }
      modelled = true;
      const RandomEffects& model = *parameter.model;
      if (parameter.wrong_for_all) {
        common += fmt::format("{}{} {} (95 % interval {} to {})", common.empty() ? "" : ", ", parameter.name,
                              percentOfLogarithm(model.mean), percentOfLogarithm(model.mean_interval[0]),
                              percentOfLogarithm(model.mean_interval[1]));
      }
      scatter += fmt::format("{}{} {}", scatter.empty() ? "" : ", ", parameter.name, percentOfLogarithm(model.scatter));
    }
    for (std::size_t i = 0; modelled && i < type_.components.size(); ++i) {
      const FleetComponent& component = type_.components[i];
      const bool gain = hasGainBesideValues(component);
      if ((component.verdict != Verdict::parameter_error && !gain) || standsOut(i) || isChanged(i) ||
          (gain && !common.empty())) {
        continue;
      }
      if (common.empty()) {
        type_.changed.push_back({i, verdictOf(component), "scatter between test pieces",
                                 "the configured values hold for the type, and this component lies within the scatter "
                                 "of the others: standard deviation " +
                                     scatter});
      } else {
        type_.changed.push_back({i, verdictOf(component), "wrong values common to the type",
                                 "the specification, or the rig, is off for all components: " + common});
      }
    }
  }

  FleetType type_;
  std::size_t sure_ = 0;  // components that are sure of their cause
};

// Sums by rig, type and parameter; of rigs that had one type alone there is nothing to compare.
std::vector<RigMean> meansOfRigs(const std::map<std::string, std::vector<FleetComponent>>& types) {
  std::map<std::array<std::string, 3>, RigMean> sums;
  std::map<std::string, std::set<std::string>> types_of;
  for (const auto& [type, components] : types) {
    for (const FleetComponent& component : components) {
      for (const auto& [name, change] : component.parameters) {
        RigMean& sum = sums[{component.test_rig, type, name}];
        sum = {component.test_rig, type, name, sum.components + 1, sum.mean + change.logarithm};
        types_of[component.test_rig].insert(type);
      }
    }
  }
  std::vector<RigMean> means;
  for (auto& [key, sum] : sums) {
    sum.mean /= static_cast<double>(sum.components);
    if (types_of[sum.rig].size() > 1) {
      means.push_back(sum);
    }
  }
  return means;
}

}  // namespace

void Fleet::add(const Job& job, const Record& record) {
  if (record.failed() || job.command == Command::replay) {
    return;
  }
  FleetComponent component;
  component.test_rig = job.test_rig;
  component.id = job.id;
  component.name = job.test_piece == "." ? job.component : job.test_piece + " " + job.component;
  component.report = reportPath(record);
  if (job.command == Command::estimate) {
    component.parameters = changesOfEstimate(record.evidence);
  } else {
    component.verdict = diagnosis::verdictOf(record.evidence.at("verdict").get<std::string>());
    component.effects = record.evidence.at("effects").get<std::vector<std::string>>();
    for (const ordered_json& own : record.evidence.at("explanations")) {
      addExplanation(own.at("effects").get<std::vector<std::string>>(), own.at("probability"), component);
    }
    setParameters(component, record.evidence);
  }
  components_[job.type].push_back(std::move(component));
}

FleetFindings Fleet::analyse() const {
  FleetFindings findings;
  findings.rigs = meansOfRigs(components_);
  for (const auto& [name, components] : components_) {
    findings.types.push_back(Analysis(name, components).run());
  }
  return findings;
}

}  // namespace rubber_suspension::campaign
