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

#include "element/each.h"
#include "element/refuse.h"
#include "log/column_name.h"
#include "log/csv_dialect.h"
#include "log/number_marks.h"
#include "log/sample_rules.h"
#include "log/text.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::command {
namespace {

constexpr std::size_t kLargestFile = 16 * 1024 * 1024;  // bytes
constexpr std::size_t kMostRows = 1000;                 // a fit takes seconds for each

// The quantities that a column of a table may hold, by the words that laboratories write in English and German.
struct TableQuantity {
  const char* name;
  const char* unit;  // SI
  double to_ours;    // times, to the quantity that the fit takes
  std::vector<std::string> words;
};

// Places of these.
enum : std::size_t {
  kFrequency,
  kOmega,
  kAmplitude,
  kPeakToPeak,
  kStiffness,
  kLossAngle,
  kTangent,
  kStorage,
  kLoss,
  kDamping,
  kPreload,
  kMean,
  kTemperature
};

const std::vector<TableQuantity>& tableQuantities() {
  static const std::vector<TableQuantity> table = {
      {"frequency", "Hz", 1.0, {"frequency", "freq", "freq.", "frequenz", "f"}},
      {"angular frequency", "rad/s", 0.5 / element::kPi, {"angular frequency", "omega", "kreisfrequenz", "\u03c9"}},
      {"amplitude",
       "m",
       1.0,
       {"amplitude", "disp amp", "displacement amplitude", "dynamic amplitude", "wegamplitude", "amp", "a"}},
      {"peak to peak",
       "m",
       0.5,
       {"peak to peak", "peak-to-peak", "p-p", "pk-pk", "double amplitude", "doppelamplitude"}},
      {"stiffness",
       "N/m",
       1.0,
       {"stiffness", "dynamic stiffness", "steifigkeit", "dynamische steifigkeit", "k*", "|k*|", "kdyn", "k_dyn"}},
      {"loss angle",
       "rad",
       1.0,
       {"loss angle", "phase", "phase angle", "delta", "verlustwinkel", "phasenwinkel", "phase lag", "\u03b4"}},
      {"tan delta",
       "1",
       1.0,
       {"tan delta", "tan d", "tandelta", "tan_delta", "tan \u03b4", "loss factor", "verlustfaktor"}},
      {"storage stiffness", "N/m", 1.0, {"storage stiffness", "k'", "speichersteifigkeit"}},
      {"loss stiffness", "N/m", 1.0, {"loss stiffness", "k''", "k\"", "verluststeifigkeit"}},
      {"damping", "N s/m", 1.0, {"damping", "damping constant", "damping coefficient", "d\u00e4mpfung"}},
      {"preload", "N", 1.0, {"preload", "mean load", "vorlast"}},
      {"mean displacement", "m", 1.0, {"mean displacement", "mittelweg"}},
      {"temperature", "degC", 1.0, {"temperature", "temperatur"}}};
  return table;
}

// A column that is used: which quantity, and how to make it SI.
struct TableColumn {
  std::size_t quantity;
  log::UnitConversion conversion;
};

// Of a material, which is a stiffness once the shape is known.
bool isOfMaterial(const std::string& word) {
  static const std::vector<std::string> words = {"e*",     "e'",      "e''",    "g*",       "g'",
                                                 "g''",    "|e*|",    "|g*|",   "modulus",  "modul",
                                                 "strain", "dehnung", "stress", "spannung", "strain amplitude"};
  const std::size_t blank = word.rfind(' ');
  const std::string last = blank == std::string::npos ? word : word.substr(blank + 1);
  return std::find(words.begin(), words.end(), word) != words.end() || last == "modulus" || last == "modul";
}

class TableReader {
 public:
  explicit TableReader(std::string source) : source_(std::move(source)) {}

  fit::MeasuredTable read(const std::string& text) {
    try {
      std::istringstream stream(log::toUtf8(text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? text.substr(3) : text));
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
      refuseIf(columns_.empty(),
               "no header; accepted: a line with the columns frequency, amplitude, stiffness, loss angle");
      marks_->requireClear(names_, false);
    } catch (const log::OtherDecimalMark&) {
      refuse(
          "marks that may be decimal or between thousands before one that is; accepted: one decimal mark throughout");
    } catch (const log::RowError& error) {
      line_ = error.row();
      refuse(error.what());
    }
    return table_;
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", source_, line_, reason));
  }

  template <class... Arguments>
  void refuseIf(bool wrong, fmt::format_string<Arguments...> text, Arguments&&... arguments) const {
    if (wrong) {
      refuse(fmt::format(text, std::forward<Arguments>(arguments)...));
    }
  }

  void readHeader(const std::string& line) {
    separator_ = log::separatorOf(line);
    std::vector<log::Field> fields;
    log::splitFields(line, separator_, fields);
    names_ = element::each(fields, [](const log::Field& field) { return std::string(field.text); });
    columns_ = element::each(names_, [&](const std::string& name) { return columnOf(name); });
    for (std::size_t i = 0; i < tableQuantities().size(); ++i) {
      refuseIf(countOf(i) > 1, "{}: stands twice; accepted: one column", tableQuantities()[i].name);
    }
    require(has(kFrequency) || has(kOmega), kFrequency, "");
    require(has(kAmplitude) || has(kPeakToPeak), kAmplitude, "");
    require(has(kStiffness) || has(kStorage), kStiffness, "");
    require(has(kLossAngle) || has(kTangent) || (has(kStorage) && has(kLoss)) || has(kDamping), kLossAngle,
            ", or tan delta, a loss stiffness K'' beside K', or a damping");
    marks_.emplace('\0', '\0', std::vector<char>(columns_.size(), '\0'));
    if (const auto ignored = element::those(names_, [&](const auto& name) { return !columnOf(name); });
        !ignored.empty()) {
      table_.notes.push_back("columns ignored: " + element::joined(ignored, ", ", log::quoted));
    }
  }

  std::ptrdiff_t countOf(std::size_t quantity) const {
    return std::count_if(columns_.begin(), columns_.end(),
                         [&](const auto& column) { return column && column->quantity == quantity; });
  }

  bool has(std::size_t quantity) const { return countOf(quantity) > 0; }

  void require(bool there, std::size_t quantity, const std::string& others) const {
    const TableQuantity& row = tableQuantities()[quantity];
    const auto of_material = element::those(names_, [](const auto& name) { return isOfMaterial(bareOf(name)); });
    refuseIf(!there, "{}: missing; accepted: one column, with a unit such as '{} [{}]'{}{}", row.name, row.name,
             row.unit, others,
             of_material.empty() ? ""
                                 : element::joined(of_material, ", ", log::quoted).insert(0, "; ") +
                                       ": of a material, which is a stiffness and a displacement once the shape (area, "
                                       "height) is known");
  }

  static std::string bareOf(const std::string& name) { return log::lowerCase(log::parseColumnName(name).bare); }

  // "Loss angle [deg]", "stiffness_N_per_m", "tan delta"; nothing for another column.
  std::optional<TableColumn> columnOf(const std::string& text) const {
    const log::ColumnName name = log::parseColumnName(text);
    for (std::size_t i = 0; i < tableQuantities().size(); ++i) {
      for (const std::string& word : tableQuantities()[i].words) {
        const std::string unit = unitBehind(text, name, word);
        if (!unit.empty()) {
          return TableColumn{i, conversionOf(text, unit, tableQuantities()[i].unit)};
        }
      }
    }
    return std::nullopt;
  }

  log::UnitConversion conversionOf(const std::string& text, const std::string& unit, const std::string& si) const {
    try {
      return {log::spelledUnit(unit, si), si};
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("column {}: {}", log::quoted(text), error.what()));
    }
  }

  // "" where the name is another word. Ratios need no unit.
  static std::string unitBehind(const std::string& text, const log::ColumnName& name, const std::string& word) {
    std::string lower = log::lowerCase(text);
    std::string joined = word;
    std::replace(joined.begin(), joined.end(), ' ', '_');
    std::string ratio = word.compare(0, 3, "tan") == 0 || word == "loss factor" || word == "verlustfaktor" ? "1" : "";
    if (log::lowerCase(name.bare) == word) {
      return name.unit.empty() ? ratio : name.unit;
    }
    if (lower == joined || lower == word + " [-]") {
      return ratio;
    }
    if (joined.size() < 3) {
      return "";
    }
    const std::string start = joined + "_";
    std::string unit = lower.compare(0, start.size(), start) == 0 ? text.substr(start.size()) : "";
    const std::size_t per = unit.find("_per_");
    return per == std::string::npos ? unit : unit.replace(per, 5, "/");
  }

  void readRow(const std::string& line) {
    std::vector<log::Field> fields;
    log::splitFields(line, separator_, fields);
    refuseIf(fields.size() != columns_.size(), "{} fields; accepted: {}, as in the header", fields.size(),
             columns_.size());
    std::map<std::size_t, double> values;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (columns_[i]) {
        const std::size_t quantity = columns_[i]->quantity;
        const auto number = log::parseNumber(normalised(fields[i], i));
        refuseIf(!number, "{}: {} is no number", tableQuantities()[quantity].name,
                 log::quoted(std::string(fields[i].text)));
        marks_->see(*number, i);
        values[quantity] = tableQuantities()[quantity].to_ours * columns_[i]->conversion(*number);
      }
    }
    checkPreload(values);
    addPoint(values);
  }

  std::string normalised(const log::Field& field, std::size_t column) {
    try {
      return marks_->normalised(field.text, column, names_[column], line_);
    } catch (const std::runtime_error& error) {
      refuse(error.what());
    }
  }

  // The sine swings about a displacement: what a preload does to it, the table has to say.
  void checkPreload(std::map<std::size_t, double>& values) const {
    refuseIf(values[kPreload] != 0.0 && values.count(kMean) == 0,
             "preload: {:g} N; accepted: 0, or with a column 'mean displacement [m]' that says where the preload holds "
             "the component",
             values[kPreload]);
  }

  static fit::TablePoint pointOf(std::map<std::size_t, double>& values) {
    fit::TablePoint point;
    point.frequency = values.count(kFrequency) > 0 ? values[kFrequency] : values[kOmega];
    point.amplitude = values.count(kAmplitude) > 0 ? values[kAmplitude] : values[kPeakToPeak];
    point.mean = values[kMean];
    const auto has = [&](std::size_t quantity) { return values.count(quantity) > 0; };
    const bool whole_loop = has(kStiffness) && (has(kLossAngle) || has(kTangent));
    if (!whole_loop && (has(kLoss) || has(kDamping))) {
      const bool by_damping = !has(kLoss);
      // A damping stands beside the elastic part of the stiffness.
      const double storage = has(kStorage) ? values[kStorage] : values[kStiffness];
      const double loss = by_damping ? 2.0 * element::kPi * point.frequency * values[kDamping] : values[kLoss];
      point.stiffness = std::hypot(storage, loss);
      point.loss_angle = std::atan2(loss, storage);
    } else {
      point.loss_angle = has(kLossAngle) ? values[kLossAngle] : std::atan(values[kTangent]);
      point.stiffness = has(kStiffness) ? values[kStiffness] : values[kStorage] / std::cos(point.loss_angle);
    }
    if (values.count(kTemperature) > 0) {
      point.temperature = values[kTemperature];
    }
    return point;
  }

  void addPoint(std::map<std::size_t, double>& values) {
    const fit::TablePoint point = pointOf(values);
    const bool positive = point.frequency > 0.0 && point.amplitude > 0.0 && point.stiffness > 0.0;
    const bool finite = std::isfinite(point.frequency + point.amplitude + point.stiffness);
    refuseIf(!positive || !finite || !(std::abs(point.loss_angle) <= 0.5 * element::kPi),
             "{:g} Hz, {:g} m, {:g} N/m, {:g} rad; accepted: the first three greater than 0, the angle at most 90 "
             "degrees",
             point.frequency, point.amplitude, point.stiffness, point.loss_angle);
    refuseIf(!std::isfinite(point.mean + point.temperature.value_or(0.0)),
             "mean displacement or temperature: not finite; accepted: numbers");
    refuseIf(table_.points.size() == kMostRows, "more than {} rows; accepted: that many at most", kMostRows);
    table_.points.push_back(point);
  }

  std::string source_;
  std::size_t line_ = 0;
  log::Separator separator_ = log::Separator::comma;
  std::vector<std::string> names_;
  std::vector<std::optional<TableColumn>> columns_;
  std::optional<log::NumberMarks> marks_;
  fit::MeasuredTable table_;
};

}  // namespace

fit::MeasuredTable parseTable(const std::string& text, const std::string& source) {
  return TableReader(source).read(text);
}

fit::MeasuredTable readTable(const std::string& path) {
  try {
    fit::MeasuredTable table = parseTable(log::readFile(path, kLargestFile), path);
    table.name = log::oneLine(std::filesystem::path(path).stem().string());
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
  element::refuseIf<std::runtime_error>(temperatures && component.makeComponent().shiftsWithTemperature(),
                                        "{}: temperature: {} shifts with it, which a fit to a table does not follow; "
                                        "accepted: a table without the column, or diagnose --from-table",
                                        source, component.name);
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
