// What a fleet says that a single component cannot.
#include "campaign/fleet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <iterator>
#include <set>

#include "campaign/manifest.h"
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
constexpr const char* kCommonCompliance = "series_compliance of the rig";
constexpr double kChance = 0.05;  // that a value right for the type is called wrong, over all parameters of a type

const std::array kStiffnesses = {"static_stiffness", "dynamic_stiffness", "maximum_stiffness"};

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
    const ordered_json configured = evidence.value("configured", ordered_json::object());
    change.configured =
        configured.contains(name) && configured.at(name).is_number() ? configured.at(name).get<double>() : 0.0;
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
                                                          (*upper - *lower) / (2.0 * kHalfInterval), 0.0};
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
  component.without_effects = reEstimated(evidence);
  if (component.effects.empty() || mayBe(component, kWrongValues)) {
    component.parameters = component.without_effects;
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
  // `rigs` by name: those of which something can be said.
  Analysis(const std::string& name, const std::vector<FleetComponent>& components,
           const std::map<std::string, FleetRig>& rigs)
      : rigs_(rigs) {
    type_.name = name;
    type_.components = components;
  }

  FleetType run() {
    for (const FleetComponent& component : type_.components) {
      if (component.verdict) {
        ++type_.verdicts[toString(*component.verdict)];
      }
    }
    giveBackCompliance();
    compareParameters();
    countEffects();
    decideConfounded();
    explainCompliance();
    explainParameterErrors();
    return std::move(type_);
  }

 private:
  bool isDecided(const FleetComponent& component, RigCause cause) const {
    const auto rig = rigs_.find(component.test_rig);
    return rig != rigs_.end() && rig->second.decided == cause;
  }

  bool isOnSoftRig(const FleetComponent& component) const { return isDecided(component, RigCause::compliance); }

  // Whether all types on the rig are off by one factor, or not: either way a gain is no open question any more.
  bool factorIsDecided(const FleetComponent& component) const {
    const auto rig = rigs_.find(component.test_rig);
    return rig != rigs_.end() && std::abs(rig->second.judgement.probability(RigCause::factor) - 0.5) >= kDecided - 0.5;
  }

  const RigJudgement& rigOf(const FleetComponent& component) const { return rigs_.at(component.test_rig).judgement; }

  // Stiffnesses as they would be on a rig that does not give way. What else it bends, such as break frequencies,
  // follows no formula as simple and is left out.
  void giveBackCompliance() {
    for (FleetComponent& component : type_.components) {
      if (!isOnSoftRig(component) || component.without_effects.empty()) {
        continue;
      }
      component.parameters.clear();
      for (const char* name : kStiffnesses) {
        const auto found = component.without_effects.find(name);
        if (found == component.without_effects.end()) {
          continue;
        }
        const auto alone =
            withoutCompliance(found->second.logarithm, found->second.configured, rigOf(component).compliance);
        if (alone) {
          component.parameters[name] = found->second;
          component.parameters[name].logarithm = *alone;
        }
      }
    }
  }

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
    parameter.model = fitRandomEffects(parameter.observations, commonError(parameter));
    for (std::size_t i = 0; parameter.model && i < parameter.components.size(); ++i) {
      const double distance = std::abs(parameter.observations[i].value - parameter.model->median);
      if (std::abs(parameter.model->robust_z[i]) > parameter.model->z_limit && distance > kWorthSaying) {
        type_.stand_outs.push_back(
            {parameter.components[i], name, std::exp(parameter.observations[i].value), parameter.model->robust_z[i]});
      }
    }
    type_.parameters.push_back(std::move(parameter));
  }

  // Of gain and, where it was given back, compliance of the rig.
  double commonError(const FleetParameter& parameter) const {
    double of_compliance = 0.0;
    for (const std::size_t place : parameter.components) {
      const FleetComponent& component = type_.components[place];
      if (isOnSoftRig(component)) {
        const ParameterChange& change = component.parameters.at(parameter.name);
        of_compliance += change.configured * std::exp(change.logarithm) * rigOf(component).compliance_error /
                         static_cast<double>(parameter.components.size());
      }
    }
    return std::hypot(kGainError, of_compliance);
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
      const bool open = component.explanations.size() > 1 && component.verdict != Verdict::unknown;
      if (open && !(isOnSoftRig(component) && leavesLikeValuesAlone(component))) {
        decide(i, component.explanations);
      }
    }
  }

  // Only within the set: what its own logs exclude, the fleet does not bring back.
  void decide(std::size_t place, const std::vector<OwnExplanation>& set) {
    const FleetComponent& component = type_.components[place];
    if (mayBe(component, kWrongValues) && (mayBe(component, kCompliance) || mayBe(component, kGain))) {
      return;  // re-estimation does the same: only other types on the same rig, or other pieces of the type, can tell
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

  // On a rig that gives way: what its compliance explains.
  void explainCompliance() {
    for (std::size_t i = 0; i < type_.components.size(); ++i) {
      const FleetComponent& component = type_.components[i];
      const bool off = component.verdict == Verdict::parameter_error || !component.effects.empty();
      if (!isOnSoftRig(component) || component.without_effects.empty() || !off) {
        continue;
      }
      const RigJudgement& rig = rigOf(component);
      std::string rest;
      for (const FleetParameter& parameter : type_.parameters) {
        if (parameter.wrong_for_all) {
          rest +=
              fmt::format("{}{} {}", rest.empty() ? "; beyond it the specification is off for all components: " : ", ",
                          parameter.name, percentOfLogarithm(parameter.model->mean));
        }
      }
      type_.changed.push_back(
          {i, verdictOf(component),
           standsOut(i) ? std::string(kCommonCompliance) + " and wrong values" : kCommonCompliance,
           fmt::format(
               "types of different stiffness on this rig are softer by one compliance, {:.3g} m/N (95 % interval "
               "{:.3g} to {:.3g}): {:.0f} % against wrong values of each type, a factor common to all, and "
               "nothing{}",
               rig.compliance, rig.compliance_interval[0], rig.compliance_interval[1],
               100.0 * rig.probability(RigCause::compliance), rest)});
    }
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

  // A gain that one rig has would be the same for all on it: scatter speaks against it, and other types may.
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
      if ((component.verdict != Verdict::parameter_error && !gain) || standsOut(i) || isOnSoftRig(component) ||
          isChanged(i) || (gain && !common.empty() && !factorIsDecided(component))) {
        continue;
      }
      if (isDecided(component, RigCause::factor)) {
        type_.changed.push_back(
            {i, verdictOf(component), "one factor common to the types on this rig",
             fmt::format("all types on this rig are off by the same factor: {:.0f} % against wrong "
                         "values of each type and a rig that gives way; look at its gains and units",
                         100.0 * rigOf(component).probability(RigCause::factor))});
      } else if (common.empty()) {
        type_.changed.push_back({i, verdictOf(component), "scatter between test pieces",
                                 "the configured values hold for the type, and this component lies within the scatter "
                                 "of the others: standard deviation " +
                                     scatter});
      } else {
        type_.changed.push_back({i, verdictOf(component), "wrong values common to the type",
                                 "the specification is off for all components: " + common});
      }
    }
  }

  const std::map<std::string, FleetRig>& rigs_;
  FleetType type_;
  std::size_t sure_ = 0;  // components that are sure of their cause
};

// Components of one type on one rig by these stiffnesses, without those that stand out.
TypeOnRig typeOnRig(const std::vector<const FleetComponent*>& components, const std::vector<std::string>& stiffnesses) {
  TypeOnRig type;
  std::vector<bool> out(components.size(), false);
  for (const std::string& name : stiffnesses) {
    type.stiffness.push_back(components.front()->without_effects.at(name).configured);
    std::vector<Observation> observations;
    for (const FleetComponent* component : components) {
      observations.push_back({component->without_effects.at(name).logarithm, 0.0});
    }
    const auto model = fitRandomEffects(observations);
    for (std::size_t i = 0; model && i < components.size(); ++i) {
      out[i] = out[i] || std::abs(model->robust_z[i]) > model->z_limit;
    }
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (out[i]) {
      continue;
    }
    std::vector<double> row;
    for (const std::string& name : stiffnesses) {
      row.push_back(components[i]->without_effects.at(name).logarithm);
    }
    type.logarithms.push_back(row);
  }
  return type;
}

bool has(const FleetComponent& component, const std::string& stiffness) {
  const auto found = component.without_effects.find(stiffness);
  return found != component.without_effects.end() && found->second.configured > 0.0;
}

// Of a rig, the components of each type that can say something.
using RigComponents = std::map<std::string, std::vector<const FleetComponent*>>;

std::optional<FleetRig> judgeOne(const std::string& name, const RigComponents& types) {
  std::vector<std::string> stiffnesses;  // that every one of them has
  for (const char* stiffness : kStiffnesses) {
    if (std::all_of(types.begin(), types.end(), [&](const auto& type) {
          return std::all_of(type.second.begin(), type.second.end(),
                             [&](const FleetComponent* component) { return has(*component, stiffness); });
        })) {
      stiffnesses.emplace_back(stiffness);
    }
  }
  if (stiffnesses.empty()) {
    return std::nullopt;
  }
  FleetRig rig;
  rig.name = name;
  std::vector<TypeOnRig> compared;
  for (const auto& [type, components] : types) {
    compared.push_back(typeOnRig(components, stiffnesses));
    if (compared.back().logarithms.size() >= kFewestComponents) {
      rig.types.push_back(type);
    }
  }
  const auto judgement = judgeRig(compared);
  if (!judgement) {
    return std::nullopt;
  }
  rig.judgement = *judgement;
  for (const RigCause cause : {RigCause::none, RigCause::factor, RigCause::own, RigCause::compliance}) {
    if (judgement->probability(cause) >= kDecided) {
      rig.decided = cause;
    }
  }
  return rig;
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
  for (const char* name : {"report.html", "report.json", "identification.json"}) {
    if (component.report.empty() && record.files.count(name) != 0) {
      component.report = reportFolder(job.id) + "/" + name;
    }
  }
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
  std::map<std::string, RigComponents> rigs;
  for (const auto& [type, components] : components_) {
    for (const FleetComponent& component : components) {
      if (has(component, kStiffnesses.front())) {
        rigs[component.test_rig][type].push_back(&component);
      }
    }
  }
  FleetFindings findings;
  std::map<std::string, FleetRig> decided;
  for (const auto& [name, types] : rigs) {
    if (const auto rig = judgeOne(name, types)) {
      findings.rigs.push_back(*rig);
      decided[name] = *rig;
    }
  }
  for (const auto& [name, components] : components_) {
    findings.types.push_back(Analysis(name, components, decided).run());
  }
  return findings;
}

}  // namespace rubber_suspension::campaign
