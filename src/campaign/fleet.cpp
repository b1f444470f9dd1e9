// Computes the statistics of a fleet.
#include "campaign/fleet.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "element/each.h"
#include "numerics/quantile.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

constexpr double kTail = 0.025;           // probability on each side of a 95 % interval
constexpr std::size_t kMostListed = 500;  // components per type; table.csv lists all components

// Returns the share of each name with its interval. The most frequent name comes first.
ordered_json sharesOf(const std::vector<std::string>& names, std::size_t components) {
  constexpr double kJeffreys = 0.5;  // prior count of each of the two answers
  std::map<std::string, std::size_t> counts;
  for (const std::string& name : names) {
    ++counts[name];
  }
  std::vector<std::pair<std::string, std::size_t>> by_count(counts.begin(), counts.end());
  std::stable_sort(by_count.begin(), by_count.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  ordered_json shares = ordered_json::array();
  for (const auto& [name, count] : by_count) {
    const boost::math::beta_distribution<> beta(static_cast<double>(count) + kJeffreys,
                                                static_cast<double>(components - count) + kJeffreys);
    shares.push_back({{"name", name},
                      {"components", count},
                      {"share", static_cast<double>(count) / static_cast<double>(components)},
                      {"interval_95", {quantile(beta, kTail), quantile(beta, 1.0 - kTail)}}});
  }
  return shares;
}

// Returns the rank of the limits of the interval of the median, counted from either end; 0 for too few values.
std::size_t rankOfInterval(std::size_t count) {
  const boost::math::binomial below_median(static_cast<double>(count), 0.5);
  std::size_t rank = 0;
  while (cdf(below_median, static_cast<double>(rank)) <= kTail) {
    ++rank;
  }
  return rank;
}

ordered_json withDistribution(ordered_json head, const ordered_json& distribution) {
  head.update(distribution);
  return head;
}

bool isFarOut(double value, const ordered_json& distribution) {
  // Multiple of the interquartile range. For normal values, the limit is six standard deviations from the median.
  constexpr double kFar = 4.0;
  const auto [lower, upper] = distribution["quartiles"].get<std::array<double, 2>>();
  return distribution["components"] >= kFewestComponents &&
         std::max(lower - value, value - upper) > kFar * (upper - lower) &&
         std::abs(value - distribution["median"].get<double>()) > kWorthSaying;
}

}  // namespace

ordered_json distributionOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) { return numerics::quantileOf(values, share); };
  ordered_json result = {
      {"components", values.size()}, {"median", quantile(0.5)}, {"quartiles", {quantile(0.25), quantile(0.75)}}};
  if (const std::size_t rank = rankOfInterval(values.size()); rank > 0) {
    result["median_interval_95"] = {values[rank - 1], values[values.size() - rank]};
  }
  return result;
}

void Fleet::add(const Job& job, const Record& record) {
  if (!record.failed() && job.command != Command::replay) {
    const std::string name = job.test_piece == "." ? job.component : job.test_piece + " " + job.component;
    types_[job.type].push_back({job.id, name, reportPath(record), job.test_rig, record.findings});
  }
}

ordered_json Fleet::describe(const std::string& type, const std::vector<Component>& components) {
  std::vector<std::string> verdicts;
  std::vector<std::string> effects;
  std::map<std::string, std::vector<std::pair<const Component*, double>>> values;
  ordered_json listed = ordered_json::array();
  for (const Component& component : components) {
    const auto& [verdict, named, changes] = component.findings;
    const std::string answer = verdict ? toString(*verdict) : "";
    if (verdict) {
      verdicts.push_back(answer);
    }
    effects.insert(effects.end(), named.begin(), named.end());
    for (const auto& [parameter, change] : changes) {
      values[parameter].emplace_back(&component, change);
    }
    if (listed.size() < kMostListed) {
      listed.push_back(
          {{"component", component.name}, {"report", component.report}, {"verdict", answer}, {"effects", named}});
    }
  }
  ordered_json parameters = ordered_json::array();
  ordered_json far_out = ordered_json::array();
  for (const auto& [parameter, all] : values) {
    const ordered_json distribution = distributionOf(element::each(all, [](const auto& one) { return one.second; }));
    parameters.push_back(withDistribution({{"name", parameter}}, distribution));
    for (const auto& [component, value] : all) {
      if (isFarOut(value, distribution)) {
        far_out.push_back({{"component", component->name},
                           {"id", component->id},
                           {"report", component->report},
                           {"parameter", parameter},
                           {"value", value}});
      }
    }
  }
  return {{"name", type},
          {"components", components.size()},
          {"verdicts", sharesOf(verdicts, verdicts.size())},
          {"effects", sharesOf(effects, verdicts.size())},
          {"parameters", parameters},
          {"far_out", far_out},
          {"listed", listed}};
}

// Omits rigs that tested only one type of component, because nothing can be compared on them.
ordered_json Fleet::describeRigs() const {
  std::map<std::array<std::string, 3>, std::vector<double>> values;
  std::map<std::string, std::set<std::string>> types_of;
  for (const auto& [type, components] : types_) {
    for (const Component& component : components) {
      for (const auto& [name, change] : component.findings.changes) {
        values[{component.test_rig, type, name}].push_back(change);
        types_of[component.test_rig].insert(type);
      }
    }
  }
  ordered_json rigs = ordered_json::array();
  for (const auto& [key, of_components] : values) {
    const auto& [rig, type, parameter] = key;
    if (types_of[rig].size() > 1) {
      rigs.push_back(
          withDistribution({{"name", rig}, {"type", type}, {"parameter", parameter}}, distributionOf(of_components)));
    }
  }
  return rigs;
}

ordered_json Fleet::analyse() const {
  ordered_json types = ordered_json::array();
  for (const auto& [name, components] : types_) {
    types.push_back(describe(name, components));
  }
  return {{"types", types}, {"rigs", describeRigs()}};
}

std::string toJson(const Fleet& fleet, const CollectSummary& summary) {
  ordered_json json = {{"schema", "rubber_suspension/fleet/3"},
                       {"jobs", {{"done", summary.done}, {"failed", summary.failed}, {"missing", summary.missing}}}};
  json.update(fleet.analyse());
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rubber_suspension::campaign
