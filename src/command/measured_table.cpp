// Measured tables as text.
#include "command/measured_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "log/column_name.h"
#include "log/text.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::command {
namespace {

constexpr std::size_t kLargestFile = 16 * 1024 * 1024;  // bytes

struct Quantity {
  std::vector<std::string> names;  // lower case; the first is that of errors
  const char* unit;                // SI
  bool needed;
};

// As laboratories write them, in English and in German.
const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> table = {
      {{"frequency", "frequenz", "f"}, "Hz", true},
      {{"amplitude"}, "m", true},
      {{"stiffness", "dynamic stiffness", "steifigkeit", "dynamische steifigkeit", "k"}, "N/m", false},
      {{"loss angle", "verlustwinkel", "delta"}, "rad", false},
      {{"tan delta", "loss factor", "verlustfaktor", "tan d"}, "1", false},
      {{"storage stiffness", "speichersteifigkeit", "k'"}, "N/m", false},
      {{"loss stiffness", "verluststeifigkeit", "k''"}, "N/m", false},
      {{"preload", "vorlast"}, "N", false},
      {{"mean displacement", "mittelweg", "mittlerer weg"}, "m", false},
      {{"temperature", "temperatur"}, "degC", false}};
  return table;
}

// Places of these.
enum : std::size_t {
  kFrequency,
  kAmplitude,
  kStiffness,
  kLossAngle,
  kLossFactor,
  kStorage,
  kLoss,
  kPreload,
  kMean,
  kTemperature
};

// A column that is used: which quantity, and how to make it SI.
struct Column {
  std::size_t quantity;
  log::UnitConversion conversion;
};

class TableReader {
 public:
  explicit TableReader(std::string source) : source_(std::move(source)) {}

  fit::MeasuredTable read(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      if (!line.empty() && line.back() == '\r') {
        line.pop_back();
      }
      if (log::trimmed(line).empty() || line[0] == '#') {
        continue;
      }
      columns_.empty() ? readHeader(line) : readRow(line);
    }
    if (columns_.empty()) {
      refuse(
          "no header; accepted: a line with the columns frequency, amplitude, stiffness, loss angle, in English or "
          "German");
    }
    return table_;
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", source_, line_, reason));
  }

  std::vector<std::string> fieldsOf(const std::string& line) const {
    std::vector<std::string> fields(1);
    for (const char c : line) {
      if (c == separator_) {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    std::transform(fields.begin(), fields.end(), fields.begin(), log::trimmed);
    return fields;
  }

  void readHeader(const std::string& line) {
    const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
    separator_ = *std::max_element(kSeparators.begin(), kSeparators.end(),
                                   [&](char one, char other) { return count(one) < count(other); });
    std::vector<std::string> ignored;
    for (const std::string& field : fieldsOf(line)) {
      columns_.push_back(columnOf(field));
      if (!columns_.back()) {
        ignored.push_back(log::quoted(field));
      }
    }
    for (std::size_t i = 0; i < quantities().size(); ++i) {
      const auto times = std::count_if(columns_.begin(), columns_.end(),
                                       [&](const auto& column) { return column && column->quantity == i; });
      if (times > 1 || (times == 0 && isNeeded(i))) {
        const std::string& name = quantities()[i].names.front();
        refuse(fmt::format("{}: {}; accepted: one column, with a unit such as '{} [{}]'{}", name,
                           times == 0 ? "missing" : "stands twice", name, quantities()[i].unit,
                           quantities()[i].needed ? "" : ", or tan delta, or storage and loss stiffness"));
      }
    }
    if (!ignored.empty()) {
      table_.notes.push_back("columns ignored: " + log::join(ignored));
    }
  }

  bool has(std::size_t quantity) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const auto& column) { return column && column->quantity == quantity; });
  }

  // K and delta may be given as K' and K'', or tan delta.
  bool isNeeded(std::size_t quantity) const {
    const bool parts = has(kStorage) && has(kLoss);
    const bool factor = has(kLossFactor);
    return quantities()[quantity].needed || (quantity == kStiffness && !parts && !(has(kStorage) && factor)) ||
           (quantity == kLossAngle && !parts && !factor);
  }

  // "loss_angle_rad", "loss angle [deg]", "stiffness_N_per_m"; nothing for another column.
  std::optional<Column> columnOf(const std::string& field) const {
    for (std::size_t i = 0; i < quantities().size(); ++i) {
      const Quantity& quantity = quantities()[i];
      std::string unit;
      for (const std::string& name : quantity.names) {
        unit = unit.empty() ? unitBehind(field, name) : unit;
      }
      if (i == kLossFactor && (unit == "-" || isNamed(field, quantity))) {
        unit = "1";
      }
      const std::size_t per = unit.find("_per_");
      if (per != std::string::npos) {
        unit.replace(per, 5, "/");
      }
      if (unit.empty()) {
        continue;
      }
      try {
        return Column{i, log::UnitConversion(unit, quantity.unit)};
      } catch (const std::invalid_argument& error) {
        refuse(fmt::format("column {}: {}", log::quoted(field), error.what()));
      }
    }
    return std::nullopt;
  }

  // A column without a unit.
  static bool isNamed(const std::string& field, const Quantity& quantity) {
    std::string lower = log::lowerCase(log::trimmed(field));
    std::replace(lower.begin(), lower.end(), '_', ' ');
    return std::find(quantity.names.begin(), quantity.names.end(), lower) != quantity.names.end();
  }

  // A decimal comma, where commas do not separate.
  std::string pointed(std::string field) const {
    if (separator_ != ',' && field.find('.') == std::string::npos) {
      std::replace(field.begin(), field.end(), ',', '.');
    }
    return field;
  }

  // The unit of a column of this name, "" where it is another column.
  static std::string unitBehind(const std::string& field, std::string name) {
    const std::string lower = log::lowerCase(field);
    for (const char blank : {' ', '_'}) {
      std::replace(name.begin(), name.end(), ' ', blank);
      if (lower.compare(0, name.size(), name) == 0) {
        std::string unit = log::trimmed(field.substr(name.size()));
        const bool marked = unit.size() > 1 && (unit[0] == '_' || unit[0] == '[' || unit[0] == '(');
        if (marked) {
          const char last = unit.back();
          return unit.substr(1, unit.size() - (last == ']' || last == ')' ? 2 : 1));
        }
      }
    }
    return "";
  }

  void readRow(const std::string& line) {
    const std::vector<std::string> fields = fieldsOf(line);
    if (fields.size() != columns_.size()) {
      refuse(fmt::format("{} fields; accepted: {}, as in the header", fields.size(), columns_.size()));
    }
    std::map<std::size_t, double> values;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (columns_[i]) {
        const auto number = log::parseNumber(pointed(fields[i]));
        if (!number) {
          refuse(fmt::format("{}: {} is no number", quantities()[columns_[i]->quantity].names.front(),
                             log::quoted(fields[i])));
        }
        values[columns_[i]->quantity] = columns_[i]->conversion(*number);
      }
    }
    checkPreload(values);
    fit::TablePoint point;
    point.frequency = values[kFrequency];
    point.amplitude = values[kAmplitude];
    point.loss_angle = has(kLossAngle)    ? values[kLossAngle]
                       : has(kLossFactor) ? std::atan(values[kLossFactor])
                                          : std::atan2(values[kLoss], values[kStorage]);
    point.stiffness = has(kStiffness) ? values[kStiffness]
                      : has(kLoss)    ? std::hypot(values[kStorage], values[kLoss])
                                      : values[kStorage] / std::cos(point.loss_angle);
    point.mean = values[kMean];
    if (values.count(kTemperature) > 0) {
      point.temperature = values[kTemperature];
    }
    addPoint(point);
  }

  // The sine swings about a displacement: what a preload does to it, the table has to say.
  void checkPreload(std::map<std::size_t, double>& values) const {
    if (values[kPreload] != 0.0 && values.count(kMean) == 0) {
      refuse(
          fmt::format("preload: {:g} N; accepted: 0, or with a column 'mean displacement [m]' that says where the "
                      "preload holds the component",
                      values[kPreload]));
    }
  }

  void addPoint(const fit::TablePoint& point) {
    const bool positive = point.frequency > 0.0 && point.amplitude > 0.0 && point.stiffness > 0.0;
    const bool finite = std::isfinite(point.frequency + point.amplitude + point.stiffness);
    if (!positive || !finite || !(std::abs(point.loss_angle) <= 0.5 * element::kPi)) {
      refuse(
          fmt::format("{:g} Hz, {:g} m, {:g} N/m, {:g} rad; accepted: the first three greater than 0, the angle at "
                      "most 90 degrees",
                      point.frequency, point.amplitude, point.stiffness, point.loss_angle));
    }
    if (!std::isfinite(point.mean + point.temperature.value_or(0.0))) {
      refuse("mean displacement or temperature: not finite; accepted: numbers");
    }
    table_.points.push_back(point);
  }

  static constexpr std::string_view kSeparators = ",;\t";

  std::string source_;
  std::size_t line_ = 0;
  char separator_ = ',';
  std::vector<std::optional<Column>> columns_;
  fit::MeasuredTable table_;
};

}  // namespace

fit::MeasuredTable parseTable(const std::string& text, const std::string& source) {
  return TableReader(source).read(text);
}

fit::MeasuredTable readTable(const std::string& path) {
  try {
    fit::MeasuredTable table = parseTable(log::readFile(path, kLargestFile), path);
    table.name = std::filesystem::path(path).stem().string();
    return table;
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what();
    throw std::runtime_error(reason.compare(0, path.size(), path) == 0 ? reason : path + ": " + reason);
  }
}

void requireNoShift(const io::ComponentDescription& component, const fit::MeasuredTable& table,
                    const std::string& source) {
  const bool temperatures = std::any_of(table.points.begin(), table.points.end(),
                                        [](const fit::TablePoint& point) { return point.temperature.has_value(); });
  if (temperatures && component.makeComponent().shiftsWithTemperature()) {
    throw std::runtime_error(
        fmt::format("{}: temperature: {} shifts with it, which a fit to a table does not follow; "
                    "accepted: a table without the column, or diagnose --from-table",
                    source, component.name));
  }
}

std::string toText(const fit::TableFit& fit, const fit::MeasuredTable& table) {
  std::string text = fmt::format("component {}, parameters from a table of {} points\n  {:<44} {:>14} {:>14}\n",
                                 fit.component.name, table.points.size(), "parameter", "given", "found");
  for (const fit::FittedParameter& parameter : fit.parameters) {
    text += fmt::format(
        "  {:<44} {:>14.6g} {:>14.6g}{}\n", parameter.name, parameter.given, parameter.value,
        parameter.determined ? fmt::format("  +- {:.2g} %", 196.0 * parameter.deviation) : "  not determined");
  }
  text += fmt::format("  mean difference of K*: {:.3g} % as given, {:.3g} % as found\n", 100.0 * fit.misfit_before,
                      100.0 * fit.misfit);
  text +=
      "  note: settled loops under single sines show no softening, no heating on the way, no offset, no drift; a delay "
      "of the force looks like loss\n";
  for (const std::string& note : table.notes) {
    text += "  note: " + note + "\n";
  }
  return text;
}

}  // namespace rubber_suspension::command
