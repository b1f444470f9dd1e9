// What a fleet says that a single component cannot.
#include "campaign/fleet.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <set>

#include "campaign/manifest.h"
#include "log/text.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

constexpr double kJeffreys = 0.5;                        // prior count of each cause
constexpr const char* kWrongValues = "parameter_error";  // among the effects of a set

// Nothing for null, which stands for a value that is not finite, and for what has no logarithm.
std::optional<double> logarithm(const ordered_json& value) {
  if (!value.is_number() || !(value.get<double>() > 0.0)) {
    return std::nullopt;
  }
  return std::log(value.get<double>());
}

std::map<std::string, ParameterChange> changesOfDiagnosis(const ordered_json& evidence) {
  std::map<std::string, ParameterChange> changes;
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
std::map<std::string, ParameterChange> changesOfEstimate(const ordered_json& evidence) {
  constexpr double kHalfInterval = 1.96;  // standard errors of a normal distribution in half of a 95 % interval
  std::map<std::string, ParameterChange> changes;
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
  if (component.verdict == "none" || component.verdict == "parameter_error") {
    return "";
  }
  const bool one = component.verdict == "named" && !component.confounded.empty() && !component.effects.empty() &&
                   component.confounded.front().size() == 1;
  return one ? std::optional<std::string>(component.effects.front()) : std::nullopt;
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

std::string percent(double logarithm) { return fmt::format("{:.1f} %", 100.0 * std::expm1(logarithm)); }

class Analysis {
 public:
  Analysis(const std::string& name, const std::vector<FleetComponent>& components) {
    type_.name = name;
    type_.components = components;
  }

  FleetType run() {
    for (const FleetComponent& component : type_.components) {
      if (!component.verdict.empty()) {
        ++type_.verdicts[component.verdict];
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
    parameter.model = fitRandomEffects(parameter.observations);
    for (std::size_t i = 0; parameter.model && i < parameter.components.size(); ++i) {
      if (std::abs(parameter.model->robust_z[i]) > parameter.model->z_limit) {
        type_.stand_outs.push_back(
            {parameter.components[i], name, std::exp(parameter.observations[i].value), parameter.model->robust_z[i]});
      }
    }
    type_.parameters.push_back(std::move(parameter));
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
      if (component.confounded.empty() || component.confounded.front().size() < 2) {
        continue;
      }
      decide(i, component.confounded.front());
    }
  }

  // Only within the set: what its own logs exclude, the fleet does not bring back.
  void decide(std::size_t place, const std::vector<std::string>& set) {
    const FleetComponent& component = type_.components[place];
    std::vector<double> alone;
    std::vector<double> weights;
    double sum_alone = 0.0;
    double sum = 0.0;
    for (const std::string& effect : set) {
      const auto own = component.probabilities.find(effect);
      alone.push_back(own == component.probabilities.end() ? 0.0 : own->second);
      weights.push_back(alone.back() * (static_cast<double>(sureOf(effect)) + kJeffreys));
      sum_alone += alone.back();
      sum += weights.back();
    }
    if (sure_ < kFewestComponents || !(sum > 0.0)) {
      return;
    }
    const auto best = static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[best] / sum < kDecided) {
      return;
    }
    std::string others;
    for (std::size_t i = 0; i < set.size(); ++i) {
      others += i == best ? "" : fmt::format("{}{} in {}", others.empty() ? "" : ", ", set[i], sureOf(set[i]));
    }
    type_.changed.push_back(
        {place, fmt::format("{}: {}", component.verdict, log::join(set)),
         set[best] == kWrongValues ? set[best] : "named: " + set[best],
         fmt::format("of {} components of this type whose own logs leave one cause, {} is it in {}, {}: {:.0f} % "
                     "within the set, by its own logs {:.0f} %",
                     sure_, set[best], sureOf(set[best]), others, 100.0 * weights[best] / sum,
                     100.0 * alone[best] / sum_alone)});
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
      if (parameter.isWrongForAll()) {
        common += fmt::format("{}{} {} (95 % interval {} to {})", common.empty() ? "" : ", ", parameter.name,
                              percent(model.mean), percent(model.mean_interval[0]), percent(model.mean_interval[1]));
      }
      scatter += fmt::format("{}{} {}", scatter.empty() ? "" : ", ", parameter.name, percent(model.scatter));
    }
    for (std::size_t i = 0; modelled && i < type_.components.size(); ++i) {
      const bool out = std::any_of(type_.stand_outs.begin(), type_.stand_outs.end(),
                                   [&](const StandOut& one) { return one.component == i; });
      if (type_.components[i].verdict != "parameter_error" || out) {
        continue;
      }
      if (common.empty()) {
        type_.changed.push_back({i, "parameter_error", "scatter between test pieces",
                                 "the configured values hold for the type, and this component lies within the scatter "
                                 "of the others: standard deviation " +
                                     scatter});
      } else {
        type_.changed.push_back({i, "parameter_error", "wrong values common to the type",
                                 "the specification is off for all components: " + common});
      }
    }
  }

  FleetType type_;
  std::size_t sure_ = 0;  // components that are sure of their cause
};

}  // namespace

bool FleetParameter::isWrongForAll() const {
  return model && (model->mean_interval[0] > 0.0 || model->mean_interval[1] < 0.0);
}

void Fleet::add(const Job& job, const Record& record) {
  if (record.failed() || job.command == Command::replay) {
    return;
  }
  FleetComponent component;
  component.id = job.id;
  component.name = job.test_piece == "." ? job.component : job.test_piece + " " + job.component;
  for (const char* name : {"report.html", "report.json", "identification.json"}) {
    if (component.report.empty() && record.files.count(name) != 0) {
      component.report = reportFolder(job.id) + "/" + name;
    }
  }
  if (job.command == Command::estimate) {
    component.parameters = changesOfEstimate(record.evidence);
  } else {
    component.verdict = record.evidence.at("verdict").get<std::string>();
    component.effects = record.evidence.at("effects").get<std::vector<std::string>>();
    component.confounded = record.evidence.at("confounded").get<std::vector<std::vector<std::string>>>();
    for (const auto& [effect, probability] : record.evidence.at("probabilities").items()) {
      component.probabilities[effect] = probability.is_number() ? probability.get<double>() : 0.0;
    }
    if (component.verdict != "check_bench") {  // of logs that cannot be what they say nothing is known
      component.parameters = changesOfDiagnosis(record.evidence);
    }
  }
  components_[job.type].push_back(std::move(component));
}

std::vector<FleetType> Fleet::analyse() const {
  std::vector<FleetType> types;
  for (const auto& [name, components] : components_) {
    types.push_back(Analysis(name, components).run());
  }
  return types;
}

}  // namespace rubber_suspension::campaign
