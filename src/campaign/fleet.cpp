// Findings of a fleet that a single component cannot show.
#include "campaign/fleet.h"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <iterator>
#include <set>

#include "element/each.h"
#include "numerics/quantile.h"

namespace rubber_suspension::campaign {
namespace {

constexpr double kTail = 0.025;  // of a 95 % interval

// How often each of these names occurs, most frequent first.
std::vector<Share> sharesOf(const std::vector<std::string>& names, std::size_t components) {
  constexpr double kJeffreys = 0.5;  // prior count of either answer
  std::vector<Share> shares;
  for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
    const auto count = static_cast<std::size_t>(std::count(names.begin(), names.end(), name));
    const boost::math::beta_distribution<> beta(static_cast<double>(count) + kJeffreys,
                                                static_cast<double>(components - count) + kJeffreys);
    const double share = static_cast<double>(count) / static_cast<double>(components);
    shares.push_back({name, count, share, {quantile(beta, kTail), quantile(beta, 1.0 - kTail)}});
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.components > b.components; });
  return shares;
}

void countVerdicts(FleetType& type) {
  std::vector<std::string> verdicts;
  std::vector<std::string> effects;
  for (const auto& [verdict, named, changes] : element::each(type.components, &FleetComponent::findings)) {
    if (verdict) {
      verdicts.push_back(toString(*verdict));
    }
    effects.insert(effects.end(), named.begin(), named.end());
  }
  type.verdicts = sharesOf(verdicts, verdicts.size());
  type.effects = sharesOf(effects, verdicts.size());
}

// Of the value, from 1, at either end of the interval of the median; 0 where there are too few.
std::size_t rankOfInterval(std::size_t count) {
  const boost::math::binomial below_median(static_cast<double>(count), 0.5);
  std::size_t rank = 0;
  while (cdf(below_median, static_cast<double>(rank)) <= kTail) {
    ++rank;
  }
  return rank;
}

bool isFarOut(double value, const Distribution& distribution) {
  constexpr double kFar = 4.0;  // distances of the quartiles: of normal values six standard deviations from the median
  const auto& [lower, upper] = distribution.quartiles;
  return distribution.components >= kFewestComponents &&
         std::max(lower - value, value - upper) > kFar * (upper - lower) &&
         std::abs(value - distribution.median) > kWorthSaying;
}

void describeParameters(FleetType& type) {
  std::map<std::string, std::vector<ComponentValue>> values;
  for (std::size_t i = 0; i < type.components.size(); ++i) {
    for (const auto& [name, change] : type.components[i].findings.changes) {
      values[name].push_back({i, name, change});
    }
  }
  for (const auto& [name, all] : values) {
    const Distribution distribution = distributionOf(element::each(all, &ComponentValue::value));
    type.parameters.push_back({"", type.name, name, distribution});
    std::copy_if(all.begin(), all.end(), std::back_inserter(type.far_out),
                 [&](const ComponentValue& one) { return isFarOut(one.value, distribution); });
  }
}

// Of rigs that had one type alone there is nothing to compare.
std::vector<FleetParameter> rigsOf(const std::map<std::string, std::vector<FleetComponent>>& types) {
  std::map<std::array<std::string, 3>, std::vector<double>> values;
  std::map<std::string, std::set<std::string>> types_of;
  for (const auto& [type, components] : types) {
    for (const FleetComponent& component : components) {
      for (const auto& [name, change] : component.findings.changes) {
        values[{component.test_rig, type, name}].push_back(change);
        types_of[component.test_rig].insert(type);
      }
    }
  }
  std::vector<FleetParameter> rigs;
  for (const auto& [key, of_components] : values) {
    const auto& [rig, type, parameter] = key;
    if (types_of[rig].size() > 1) {
      rigs.push_back({rig, type, parameter, distributionOf(of_components)});
    }
  }
  return rigs;
}

}  // namespace

Distribution distributionOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) { return numerics::quantileOf(values, share); };
  Distribution result{values.size(), quantile(0.5), {quantile(0.25), quantile(0.75)}, {}};
  if (const std::size_t rank = rankOfInterval(values.size()); rank > 0) {
    result.median_interval = {values[rank - 1], values[values.size() - rank]};
  }
  return result;
}

void Fleet::add(const Job& job, const Record& record) {
  if (!record.failed() && job.command != Command::replay) {
    const std::string name = job.test_piece == "." ? job.component : job.test_piece + " " + job.component;
    types_[job.type].push_back({job.id, name, reportPath(record), job.test_rig, record.findings});
  }
}

FleetFindings Fleet::analyse() const {
  FleetFindings findings;
  for (const auto& [name, components] : types_) {
    FleetType type{name, components, {}, {}, {}, {}};
    countVerdicts(type);
    describeParameters(type);
    findings.types.push_back(std::move(type));
  }
  findings.rigs = rigsOf(types_);
  return findings;
}

}  // namespace rubber_suspension::campaign
