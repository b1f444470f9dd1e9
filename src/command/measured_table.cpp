// Parses measured tables of stiffness and loss angle.
#include "command/measured_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "element/each.h"
#include "log/column_name.h"
#include "log/csv_dialect.h"
#include "log/log_columns.h"
#include "log/number_marks.h"
#include "log/sample_rules.h"
#include "log/text.h"
#include "log/text_source.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::command {
namespace {

constexpr std::size_t kLargestFile = 16 * 1024 * 1024;  // bytes
constexpr std::size_t kMostRows = 1000;                 // a fit takes seconds for this number of rows

// The quantities that a column may contain, with the names that laboratories use in English and German.
struct TableQuantity {
  const char* name;
  const char* unit;  // SI unit
  double to_ours;    // factor that converts to the quantity of the fit
  std::vector<std::string> words;
};

// Indices into tableQuantities().
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
       {"amplitude", "disp amp", "displacement amplitude", "dynamic amplitude", "dyn amp", "wegamplitude", "amp",
        "ampl", "a"}},
      {"peak to peak",
       "m",
       0.5,
       {"peak to peak", "peak-to-peak", "p-p", "pk-pk", "double amplitude", "doppelamplitude"}},
      {"stiffness",
       "N/m",
       1.0,
       {"stiffness",
        "dynamic stiffness",
        "dyn. stiffness",
        "dyn stiffness",
        "steifigkeit",
        "dynamische steifigkeit",
        "dyn. steifigkeit",
        "dyn steifigkeit",
        "k*",
        "|k*|",
        "kdyn",
        "k_dyn",
        "c*",
        "|c*|",
        "cdyn",
        "c_dyn",
        "stiffness level",
        "dynamic stiffness level",
        "transfer stiffness level",
        "dynamic transfer stiffness level",
        "dynamic transfer stiffness"}},
      {"loss angle",
       "rad",
       1.0,
       {"loss angle", "phase", "phase angle", "delta", "verlustwinkel", "phasenwinkel", "phase lag", "\u03b4"}},
      {"tan delta",
       "1",
       1.0,
       {"tan delta", "tan d", "tandelta", "tan_delta", "tan \u03b4", "loss factor", "verlustfaktor"}},
      {"storage stiffness", "N/m", 1.0, {"storage stiffness", "k'", "c'", "speichersteifigkeit"}},
      {"loss stiffness", "N/m", 1.0, {"loss stiffness", "k''", "k\"", "c''", "c\"", "verluststeifigkeit"}},
      {"damping",
       "N s/m",
       1.0,
       {"damping", "damping constant", "damping coefficient", "d\u00e4mpfung", "d\u00e4mpfungskonstante"}},
      {"preload", "N", 1.0, {"preload", "mean load", "vorlast"}},
      {"mean displacement", "m", 1.0, {"mean displacement", "mittelweg"}},
      {"temperature", "degC", 1.0, {"temperature", "temperatur"}}};
  return table;
}

// A word that laboratories add to the name or unit of an amplitude, and the factor that converts to a sine's amplitude.
struct AmplitudeWord {
  const char* word;
  double factor;
};

constexpr AmplitudeWord kAmplitudeWords[] = {{"peak-to-peak", 0.5},
                                             {"peak to peak", 0.5},
                                             {"p-p", 0.5},
                                             {"pk-pk", 0.5},
                                             {"p2p", 0.5},
                                             {"pp", 0.5},
                                             {"rms", 1.4142135623730951},
                                             {"eff", 1.4142135623730951},
                                             {"0-p", 1.0},
                                             {"0-pk", 1.0},
                                             {"zero-peak", 1.0},
                                             {"peak", 1.0},
                                             {"pk", 1.0},
                                             {"\u00b1", 1.0},
                                             {"+/-", 1.0}};

// A column that is read: its quantity and the conversion of its numbers to SI units.
struct TableColumn {
  std::size_t quantity;
  log::UnitConversion conversion;
  double factor = 1.0;
  double level = 0.0;  // reference value of a level in dB [SI]; 0 if the column is not a level

  double toSi(double number) const {
    return level > 0.0 ? level * std::pow(10.0, number / 20.0) : factor * conversion(number);
  }
};

class TableReader {
 public:
  explicit TableReader(std::string source) : source_(std::move(source)) {}

  fit::MeasuredTable read(const std::string& text) {
    try {
      const std::vector<log::TextLine> lines = linesOf(text);
      line_ = lines.empty() ? 0 : lines.front().number;
      const log::CsvHeader header = headerOf(lines);
      line_ = header.line;
      readHeader(header);
      for (const log::TextLine& line : lines) {
        if (line.number >= header.next_line && line.text[0] != '#') {
          line_ = line.number;
          readRow(line.text);
        }
      }
      marks_->requireClear(names_, false);
    } catch (const log::OtherDecimalMark&) {
      refuse(
          "a decimal mark follows marks that may be decimal marks or thousands separators; accepted: one decimal mark "
          "throughout");
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

  static std::vector<log::TextLine> linesOf(const std::string& text) {
    std::vector<log::TextLine> lines;
    std::istringstream stream(log::toUtf8(text));
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      if (!line.empty() && line.back() == '\r') {
        line.pop_back();
      }
      if (!log::trimmed(line).empty()) {
        lines.push_back({number, line});
      }
    }
    return lines;
  }

  // Finds the header. As in logs, it may follow a preamble and precede a row of units.
  log::CsvHeader headerOf(const std::vector<log::TextLine>& lines) const {
    log::HeaderFinder finder([this](const auto& names) { return knownOf(names) >= 2; },
                             "the columns frequency, amplitude, stiffness, loss angle");
    try {
      for (const log::TextLine& line : lines) {
        if (const auto header = finder.add(line)) {
          return *header;
        }
      }
      return finder.finish();
    } catch (const std::runtime_error& error) {
      refuse(error.what());
    }
  }

  std::ptrdiff_t knownOf(const std::vector<log::ColumnName>& names) const {
    return std::count_if(names.begin(), names.end(), [&](const log::ColumnName& name) {
      try {
        return columnOf(textOf(name)).has_value();
      } catch (const std::runtime_error&) {  // a wrong unit is refused when the header is read
        return true;
      }
    });
  }

  // Returns the name with the unit in the row below, even if UDUNITS does not know it, such as "dB re 1 N/m".
  static std::string textOf(const log::ColumnName& name) {
    return name.unit.empty() && !name.second.empty() ? name.text + " [" + name.second + "]" : name.withUnit();
  }

  void readHeader(const log::CsvHeader& header) {
    separator_ = header.separator;
    for (const log::ColumnName& name : header.names) {
      refuseIf(!name.other.empty(), "column {}: the row of units has {}; accepted: one unit", log::quoted(name.text),
               log::quoted(name.other));
      names_.push_back(textOf(name));
    }
    refuseMatrix();
    columns_ = element::each(names_, [&](const std::string& name) { return columnOf(name); });
    for (std::size_t i = 0; i < tableQuantities().size(); ++i) {
      refuseIf(countOf(i) > 1, "{}: given in two columns; accepted: one column", tableQuantities()[i].name);
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

  // Throws for a matrix of stiffness whose rows are frequencies and whose columns are amplitudes.
  void refuseMatrix() const {
    const auto is_amplitude = [](const std::string& name) {
      std::string point = name;
      std::replace(point.begin(), point.end(), ',', '.');
      try {
        return !log::parseNumber(point) && log::parseQuantity(point, "m") > 0.0;
      } catch (const std::invalid_argument&) {
        return false;
      }
    };
    if (names_.size() > 2 && std::all_of(names_.begin() + 1, names_.end(), is_amplitude)) {
      refuse(
          fmt::format("{} over amplitudes {} to {}: the table is a matrix, which lacks the loss angle; accepted: a row "
                      "for each frequency and amplitude, with the columns frequency, amplitude, stiffness, loss angle",
                      log::quoted(names_.front()), log::quoted(names_[1]), log::quoted(names_.back())));
    }
  }

  std::ptrdiff_t countOf(std::size_t quantity) const {
    return std::count_if(columns_.begin(), columns_.end(),
                         [&](const auto& column) { return column && column->quantity == quantity; });
  }

  bool has(std::size_t quantity) const { return countOf(quantity) > 0; }

  void require(bool there, std::size_t quantity, const std::string& others) const {
    const TableQuantity& row = tableQuantities()[quantity];
    const auto of_material = element::those(names_, [](const auto& name) { return log::isOfMaterial(bareOf(name)); });
    const auto others_there =
        element::those(names_, [&](const auto& name) { return !columnOf(name) && !log::isOfMaterial(bareOf(name)); });
    refuseIf(!there, "{}: missing; accepted: one column, with a unit such as '{} [{}]'{}{}{}", row.name, row.name,
             row.unit, others,
             others_there.empty() ? "" : "; not understood: " + element::joined(others_there, ", ", log::quoted),
             log::materialHint(element::each(of_material, log::quoted)));
  }

  static std::string bareOf(const std::string& name) { return log::lowerCase(log::parseColumnName(name).bare); }

  // Parses names such as "Loss angle [deg]", "stiffness_N_per_m" and "tan delta". Returns nullopt for any other name.
  std::optional<TableColumn> columnOf(const std::string& text) const {
    const log::ColumnName name = withUnitOfPairs(log::parseColumnName(text));
    if (auto amplitude = amplitudeOf(text, name)) {
      return amplitude;
    }
    if (auto column = quantityOf(text, name)) {
      return column;
    }
    const log::ColumnName plain = withoutSymbol(name);
    return plain.bare == name.bare ? std::nullopt : quantityOf(plain.withUnit(), plain);
  }

  // Removes the symbol behind the name of a quantity, as in "Stiffness K" and "Verlustwinkel \u03b4".
  static log::ColumnName withoutSymbol(log::ColumnName name) {
    static const std::vector<std::string> symbols = {"k", "k*", "kdyn", "c",  "c*",     "cdyn",
                                                     "f", "a",  "d",    "s0", "\u03b4", "\u03c9"};
    const std::size_t blank = name.bare.rfind(' ');
    const std::string last = blank == std::string::npos ? "" : log::lowerCase(name.bare.substr(blank + 1));
    if (std::find(symbols.begin(), symbols.end(), last) != symbols.end()) {
      name.bare = name.text = log::trimmed(name.bare.substr(0, blank));
      name.names_unit = false;
    }
    return name;
  }

  std::optional<TableColumn> quantityOf(const std::string& text, const log::ColumnName& name) const {
    for (std::size_t i = 0; i < tableQuantities().size(); ++i) {
      const TableQuantity& quantity = tableQuantities()[i];
      for (const std::string& word : quantity.words) {
        const std::string unit = unitBehind(text, name, word);
        if (!unit.empty()) {
          return log::startsWith(log::lowerCase(unit), "db re ")
                     ? TableColumn{i, {quantity.unit, quantity.unit}, 1.0, levelOf(text, unit, quantity)}
                     : TableColumn{i, conversionOf(text, unit, quantity.unit)};
        }
      }
    }
    return std::nullopt;
  }

  // Parses names such as "Amplitude RMS [mm]", "Dyn Amp (mm p-p)" and "Amplitude (\u00b1mm)".
  std::optional<TableColumn> amplitudeOf(const std::string& text, log::ColumnName name) const {
    if (name.unit.empty() && name.text.find_first_of("([") != std::string::npos) {
      const std::size_t open = name.text.find_last_of("([");
      name.bare = log::trimmed(name.text.substr(0, open));
      name.unit = log::trimmed(name.text.substr(open + 1, name.text.find_last_of(")]") - open - 1));
    }
    for (const AmplitudeWord& word : kAmplitudeWords) {
      std::string bare = log::lowerCase(name.bare);
      std::string unit = name.unit;
      if (!takeWord(bare, word.word) && !takeWord(unit, word.word)) {
        continue;
      }
      const auto& words = tableQuantities()[kAmplitude].words;
      if (std::find(words.begin(), words.end(), bare) != words.end() && !unit.empty()) {
        return TableColumn{kAmplitude, conversionOf(text, unit, "m"), word.factor};
      }
    }
    return std::nullopt;
  }

  // Removes a word from the end or the beginning of a text. Returns false if the word is at neither.
  static bool takeWord(std::string& text, const std::string& word) {
    const std::string lower = log::lowerCase(text);
    const bool behind = log::endsWith(lower, word);
    if (!behind && !log::startsWith(lower, word)) {
      return false;
    }
    const std::string rest = behind ? text.substr(0, text.size() - word.size()) : text.substr(word.size());
    constexpr const char* kBetween = " _-,";
    const std::size_t first = rest.find_first_not_of(kBetween);
    text = first == std::string::npos ? "" : rest.substr(first, rest.find_last_not_of(kBetween) - first + 1);
    return true;
  }

  // Changes "N-s/mm" to "N s/mm".
  static log::ColumnName withUnitOfPairs(log::ColumnName name) {
    const std::size_t open = name.text.find_last_of("([");
    const std::size_t dash = name.text.find("-s/", open == std::string::npos ? 0 : open);
    if (open == std::string::npos || dash == std::string::npos) {
      return name;
    }
    std::string text = name.text;
    return log::parseColumnName(text.replace(dash, 1, " "));
  }

  double levelOf(const std::string& text, const std::string& unit, const TableQuantity& quantity) const {
    constexpr std::size_t kBefore = 6;  // length of "dB re "
    try {
      return log::parseQuantity(unit.substr(kBefore), quantity.unit);
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("column {}: {}; accepted: a level such as dB re 1 {}", log::quoted(text), error.what(),
                         quantity.unit));
    }
  }

  log::UnitConversion conversionOf(const std::string& text, const std::string& unit, const std::string& si) const {
    try {
      return {log::spelledUnit(unit, si), si};
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("column {}: {}", log::quoted(text), error.what()));
    }
  }

  // Returns the unit if a name consists of `word` and a unit, "1" if it is a ratio without a unit, otherwise "".
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
    const std::size_t open = lower.find_last_of("([");  // the brackets may contain a unit that UDUNITS does not know
    if (open != std::string::npos && log::trimmed(lower.substr(0, open)) == word) {
      return log::trimmed(text.substr(open + 1, text.find_last_of(")]") - open - 1));
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
    while (fields.size() > columns_.size() && fields.back().text.empty()) {
      fields.pop_back();  // the line ends in a separator
    }
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
        values[quantity] = tableQuantities()[quantity].to_ours * columns_[i]->toSi(*number);
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

  // The model needs the mean displacement of the sine, which the preload alone does not determine.
  void checkPreload(std::map<std::size_t, double>& values) const {
    refuseIf(values[kPreload] != 0.0 && values.count(kMean) == 0,
             "preload: {:g} N; accepted: 0, or a table with a column 'mean displacement [m]', the displacement under "
             "the preload",
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
      // If a damping constant is given, the stiffness is taken as the real part of K*.
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
    refuseIf(table_.points.size() == kMostRows, "more than {0} rows; accepted: at most {0}", kMostRows);
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
    fit::MeasuredTable table = parseTable(log::readText(path, kLargestFile), path);
    table.name = log::logName(path);
    return table;
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what();
    throw std::runtime_error(reason.compare(0, path.size(), path) == 0 ? reason : path + ": " + reason);
  }
}

}  // namespace rubber_suspension::command
