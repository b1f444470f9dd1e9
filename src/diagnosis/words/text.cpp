// Formats numbers and text for reports.
#include "diagnosis/words/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <utility>

#include "diagnosis/effect.h"
#include "io/rotational_unit.h"

namespace rubber_suspension::diagnosis::words {
namespace {

// A unit for display. It equals `factor` SI units and is used for values from `least` on.
struct Display {
  double least;
  double factor;
  const char* name;
};

const Display& displayOf(const std::string& unit, double size) {
  static const std::map<std::string, std::vector<Display>> table = {
      {"N", {{1e3, 1e3, "kN"}, {0.0, 1.0, "N"}}},
      {"m", {{1.0, 1.0, "m"}, {1e-5, 1e-3, "mm"}, {0.0, 1e-6, "µm"}}},
      {"N/m", {{1e5, 1e6, "kN/mm"}, {0.0, 1e3, "N/mm"}}},
      {"s", {{0.1, 1.0, "s"}, {0.0, 1e-3, "ms"}}},
      {"N s/m", {{1e3, 1e3, "kN s/m"}, {0.0, 1.0, "N s/m"}}},
      {"1/K", {{0.0, 0.01, "%/K"}}},
      {"rad", {{1.0, 1.0, "rad"}, {1e-5, 1e-3, "mrad"}, {0.0, 1e-6, "µrad"}}},
      {"N m", {{1e3, 1e3, "kN m"}, {0.0, 1.0, "N m"}}},
      {"N m/rad", {{1e5, 1e6, "kN m/mrad"}, {0.0, 1e3, "N m/mrad"}}},
      {"N m s/rad", {{1e3, 1e3, "kN m s/rad"}, {0.0, 1.0, "N m s/rad"}}},
      {"J", {{1e3, 1e3, "kJ"}, {0.0, 1.0, "J"}}},
  };
  static const Display as_it_is{0.0, 1.0, ""};
  const auto found = table.find(unit);
  if (found == table.end()) {
    return as_it_is;
  }
  return *std::find_if(found->second.begin(), found->second.end(),
                       [&](const Display& display) { return size >= display.least || display.least == 0.0; });
}

std::string unitText(const Display& display, const std::string& unit) {
  if (*display.name != '\0') {
    return std::string(" ") + display.name;
  }
  return unit == "1" ? "" : " " + unit;
}

}  // namespace

std::string sourceOf(const Diagnosis& diagnosis) { return diagnosis.table ? "this table" : "these logs"; }

std::string percent(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f} %", 100.0 * value, decimals) : "-";
}

std::string wholePercent(double value) { return fmt::format("{:.0f}", std::round(100.0 * value) + 0.0); }

std::string chance(double probability) {
  return probability < 0.01 ? "below 1" : probability > 0.99 ? "more than 99" : wholePercent(probability);
}

std::string inRotationUnits(const std::string& text) {
  static const std::vector<std::pair<std::regex, std::string>> units = [] {
    std::vector<std::pair<std::regex, std::string>> list;
    for (const auto& [unit, angular] :
         {std::pair("(k?)N/(m?)m", "$2N m/$3rad"), std::pair("(k?)N s/m", "$2N m s/rad"), std::pair("(k?)N", "$2N m"),
          std::pair("(m|µ|)m/s", "$2rad/s"), std::pair("(m|µ|)m", "$2rad")}) {
      // Matches a unit behind a number or in brackets, unless the text continues as another unit.
      list.emplace_back(std::regex(std::string("([0-9] |\\[)") + unit + "(?![A-Za-z/]| m| s)"),
                        std::string("$1") + angular);
    }
    return list;
  }();
  std::string result = text;
  for (const auto& [unit, angular] : units) {
    result = std::regex_replace(result, unit, angular);
  }
  return result;
}

std::string inUnits(const Diagnosis& diagnosis, const std::string& text) {
  return diagnosis.turns ? inRotationUnits(text) : text;
}

std::string unitOf(const Diagnosis& diagnosis, const std::string& si) {
  return diagnosis.turns ? io::rotationalUnit(si) : si;
}

std::string rangeText(const std::array<double, 2>& band, double factor) {
  return band[0] == band[1] ? fmt::format("{:.3g}", factor * band[0])
                            : fmt::format("{:.3g} to {:.3g}", factor * band[0], factor * band[1]);
}

std::string enumerated(const std::vector<std::string>& parts) {
  std::string result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return result;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string quantity(double value, const std::string& unit) {
  const Display& display = displayOf(unit, std::abs(value));
  return fmt::format("{:.3g}{}", value / display.factor, unitText(display, unit));
}

std::string intervalText(const SizedValue& size, const std::string& least, const std::string& most,
                         const std::string& unit) {
  if (size.at_bound[1] && size.value >= size.interval_95[1]) {
    return least + unit + " or more (the fit ended at a bound)";
  }
  if (size.at_bound[0] && size.value <= size.interval_95[0]) {
    return most + unit + " or less (the fit ended at a bound)";
  }
  const char* const ends[] = {"", " (lower end: a bound of the fit)", " (upper end: a bound of the fit)",
                              " (both ends: bounds of the fit)"};
  return least + " to " + most + unit + ends[(size.at_bound[0] ? 1 : 0) + (size.at_bound[1] ? 2 : 0)];
}

std::string intervalText(const SizedValue& size) {
  const Display& display = displayOf(size.unit, std::abs(size.value));
  const auto [least, most] = size.interval_95;
  const auto text = [&](double value, int digits) { return fmt::format("{:.{}g}", value / display.factor, digits); };
  int digits = 3;  // three digits, or as many as distinguish the limits
  while (digits < 6 && least < most && text(least, digits) == text(most, digits)) {
    ++digits;
  }
  return intervalText(size, text(least, digits), text(most, digits), unitText(display, size.unit));
}

std::string quantity(const SizedValue& size) {
  return quantity(size.value, size.unit) + " (" + intervalText(size) + ")";
}

std::string spoken(const std::string& name) {
  std::string result = name;
  std::replace(result.begin(), result.end(), '_', ' ');
  return result;
}

std::string labelOf(const std::string& name) {
  return spoken(name) + (name.find("_in_") == std::string::npos ? "" : ":");
}

std::string sizeName(const SizedValue& size) {
  const auto& labels = effectNamed(size.owner).labels;
  const auto label = labels.find(size.name);
  return label == labels.end() ? labelOf(size.name) : label->second;
}

std::string symbolOf(const std::string& name) {
  static const std::map<std::string, std::string> symbols = {
      {"static_stiffness", "K_st"}, {"dynamic_stiffness", "K_n"}, {"maximum_stiffness", "K_max"},
      {"nominal_frequency", "f_n"}, {"high_frequency", "f_h"},    {"low_frequency", "f_l"},
      {"nominal_amplitude", "A_n"}, {"break_frequency", "f_b"}};
  const auto found = symbols.find(name);
  return found == symbols.end() ? spoken(name) : found->second;
}

std::vector<std::string> describeTakenOut(const std::vector<TakenOut>& taken_out) {
  constexpr double kTold = 0.01;  // share of the force; less is not reported
  std::vector<std::string> phrases;
  std::string log;
  for (const TakenOut& one : taken_out) {
    if (std::abs(one.share) < kTold) {
      continue;
    }
    const std::string share = fmt::format("{} {:.2g} %", spoken(one.kind), 100.0 * one.share);
    if (one.log == log) {
      phrases.back() += ", " + share;
    } else {
      phrases.push_back(one.log + ": " + share);
      log = one.log;
    }
  }
  return phrases;
}

}  // namespace rubber_suspension::diagnosis::words
