// Finds the columns of a file and converts their numbers to SI.
#include "log/log_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "element/each.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

// Limit of 285 years, so that a time in nanoseconds fits into 64 bits.
constexpr double kMaximumTime = 9.0e9;  // [s]

const LogFormat::Channel& channelOf(const LogFormat& format, Quantity quantity) {
  return format.of[static_cast<std::size_t>(quantity)];
}

std::string unitOf(const LogFormat& format, Quantity quantity) {
  const bool displacement = quantity == Quantity::displacement;
  return format.turns && (displacement || quantity == Quantity::force) ? (displacement ? "rad" : "N m")
                                                                       : siUnit(quantity);
}

bool isWanted(Quantity quantity, const LogFormat& format) { return quantity != Quantity::time || !format.rate; }

std::string quotedName(const ColumnName& column) { return quoted(column.withUnit()); }

// Returns a list of the names in a header for an error, shortened if there are many.
std::string listed(const std::vector<ColumnName>& header) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> names = element::each(header, quotedName);
  names.resize(std::min(names.size(), kMost));
  return join(names) + (header.size() > kMost ? ", ..." : "");
}

using Places = std::vector<std::size_t>;

template <class Condition>
Places placesWhere(const std::vector<ColumnName>& header, Condition condition) {
  Places places;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (condition(header[i])) {
      places.push_back(i);
    }
  }
  return places;
}

// Returns the index of the column that --columns gives by its number, counted from 1; none for other text.
Places placeOfNumber(const std::string& text, std::size_t count) {
  const std::size_t number = wholeNumber(text);
  return number >= 1 && number <= count ? Places{number - 1} : Places{};
}

// Returns the indices of all columns that fit the user's name: the full name, the name without its unit, or the number.
Places placesOfOption(const std::vector<ColumnName>& header, const std::string& name) {
  Places places = placesWhere(header, [&](const ColumnName& column) {
    return column.text == name || column.withUnit() == name || (!column.second.empty() && column.second == name);
  });
  if (places.empty()) {
    places = placesWhere(header, [&](const ColumnName& column) { return column.bare == name; });
  }
  return places.empty() ? placeOfNumber(name, header.size()) : places;
}

// Finds columns by name, or else by unit. Columns that the user assigned by name or number are not considered.
class ColumnFinder {
 public:
  ColumnFinder(const std::vector<ColumnName>& header, const LogFormat& format) : header_(header) {
    for (const Quantity quantity : kQuantities) {
      const std::string& option = channelOf(format, quantity).column;
      const Places told = option.empty() ? Places() : placesOfOption(header, option);
      taken_.insert(taken_.end(), told.begin(), told.end());
    }
  }

  Places find(Quantity quantity) const {
    const auto is_free = [&](const ColumnName& column) {
      const auto place = static_cast<std::size_t>(&column - header_.data());
      return std::find(taken_.begin(), taken_.end(), place) == taken_.end();
    };
    Places exact = placesWhere(
        header_, [&](const ColumnName& column) { return is_free(column) && isCanonical(column.text, quantity); });
    if (!exact.empty()) {
      return exact;
    }
    Places named = placesWhere(
        header_, [&](const ColumnName& column) { return is_free(column) && quantityOfName(column.bare) == quantity; });
    if (!named.empty()) {
      return withKnownUnit(named);
    }
    Places measured = placesWhere(header_, [&](const ColumnName& column) {
      return is_free(column) && !column.unit.empty() && !quantityOfName(column.bare) &&
             quantityOfUnit(column.unit) == quantity;
    });
    return !measured.empty() ? measured : placesWhere(header_, [&](const ColumnName& column) {
      return is_free(column) && quantityOfOtherName(column.bare) == quantity;
    });
  }

 private:
  // Returns the columns with a known unit, such as "Force [N]" rather than "Force (set)". If there is none, returns
  // all, so that the unknown unit is refused later.
  Places withKnownUnit(const Places& places) const {
    const Places known = element::those(places, [&](std::size_t place) { return header_[place].unit_known; });
    return known.empty() ? places : known;
  }

  const std::vector<ColumnName>& header_;
  Places taken_;  // columns that the user assigned
};

std::string accepted(Quantity quantity) {
  const std::string name = toString(quantity);
  return fmt::format("{}_{}, or --columns {}=NAME{}", name,
                     quantity == Quantity::displacement ? "<m|mm|um>"
                     : quantity == Quantity::force      ? "<N|kN|MN>"
                                                        : siUnit(quantity),
                     name, quantity == Quantity::time ? ", or --sampling-rate" : "");
}

void refuseAmbiguity(const std::vector<ColumnName>& header, const Places& places, const std::string& what,
                     Quantity quantity) {
  const auto name = [&](std::size_t place) { return quotedName(header[place]); };
  element::refuseIf<std::runtime_error>(places.size() > 1,
                                        "each of the columns {} may be the {}; accepted: one of them, selected with "
                                        "--columns {}=NAME or its number from 1",
                                        element::joined(places, ", ", name), what, toString(quantity));
}

// Returns the largest plausible unit [SI]. A larger one is a misspelling: "Mm" means a thousand kilometres.
double largestUnit(Quantity quantity) {
  return quantity == Quantity::displacement ? 1e3 : quantity == Quantity::time ? 7.0 * 86400.0 : HUGE_VAL;
}

void setUnit(Column& column, const std::string& unit, const LogFormat& format, Quantity quantity) {
  const std::string si = unitOf(format, quantity);
  try {
    column.conversion = UnitConversion(spelledUnit(unit, si), si);
    const double size = column.conversion(1.0);
    const std::string lower = lowerCase(unit);
    element::refuseIf(size > largestUnit(quantity), "unit {} is {:g} {}{}", quoted(unit), size, si,
                      lower != unit && isUnit(lower) ? " (did you mean '" + lower + "'?)" : "");
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(fmt::format("column {}: {}; accepted: a unit of {}, in the header or with --unit {}=UNIT",
                                         quoted(column.label), error.what(), toString(quantity), toString(quantity)));
  }
}

// Returns the column at an index. Its unit is that of --unit, or else `own`, or else SI and then noted as `assumed`.
Column columnAt(const std::vector<ColumnName>& header, std::size_t place, const LogFormat& format, Quantity quantity,
                const std::string& own, const std::string& assumed) {
  const LogFormat::Channel& channel = channelOf(format, quantity);
  const std::string& unit = channel.unit.empty() ? own : channel.unit;
  element::refuseIf<std::runtime_error>(
      channel.unit.empty() && !header[place].other.empty(),
      "column {}: the row of units states {}, but the column's name states {}; accepted: --unit {}=UNIT",
      quoted(header[place].text), quoted(header[place].other), quoted(header[place].unit), toString(quantity));
  Column column;
  column.index = place;
  column.name = header[place].text;
  column.label = header[place].withUnit();
  column.factor = channel.factor;
  column.tells_unit = !unit.empty();
  column.assumed_unit = unit.empty() ? assumed : "";
  setUnit(column, unit.empty() ? unitOf(format, quantity) : unit, format, quantity);
  return column;
}

std::string nameHint(const std::vector<ColumnName>& header, const std::string& name) {
  std::vector<std::string> names;
  for (const ColumnName& column : header) {
    names.push_back(column.text);
    names.push_back(column.bare);
  }
  return oneLine(element::didYouMean(name, names));
}

// Returns the unit of a column that the user named. It stands behind the name, or is the name itself, as in "mm,kN".
std::string ownUnit(const ColumnName& column, Quantity quantity) {
  if (!column.unit.empty()) {
    return column.unit_known ? column.unit : "";
  }
  return quantityOfUnit(column.text) == quantity ? column.text : "";
}

Column mappedColumn(const std::vector<ColumnName>& header, const LogFormat& format, Quantity quantity) {
  const std::string& name = channelOf(format, quantity).column;
  const Places places = placesOfOption(header, name);
  element::refuseIf<std::runtime_error>(
      places.empty(),
      "no column {}{}, the header has {}; accepted: a name of the header, or a number "
      "from 1 to {}",
      quoted(name), nameHint(header, name), listed(header), header.size());
  element::refuseIf<std::runtime_error>(
      places.size() > 1, "column {} occurs {} times in the header; accepted: --columns {}=NUMBER, counted from 1",
      quoted(name), places.size(), toString(quantity));
  return columnAt(header, places[0], format, quantity, ownUnit(header[places[0]], quantity), unitOf(format, quantity));
}

[[noreturn]] void refuseNoUnit(const Column& column, Quantity quantity) {
  throw std::runtime_error(fmt::format("column {} has no unit; accepted: --unit {}=UNIT, or '{} [UNIT]', or {}",
                                       quoted(column.name), toString(quantity), column.name, accepted(quantity)));
}

// Returns the column that was found by name or unit. Throws if the column has no unit and is not the time.
Column foundColumn(const std::vector<ColumnName>& header, std::size_t place, const LogFormat& format,
                   Quantity quantity) {
  Column column = columnAt(header, place, format, quantity, header[place].unit, definedUnit(header[place].bare));
  if (!column.tells_unit && quantity != Quantity::time) {
    refuseNoUnit(column, quantity);
  }
  return column;
}

// If several groups of a file have a time, returns the time in the group of the displacement.
Places besideDisplacement(const ColumnFinder& finder, const std::vector<ColumnName>& header, const Places& times) {
  const Places displacement = finder.find(Quantity::displacement);
  if (times.size() < 2 || displacement.size() != 1) {
    return times;
  }
  const std::string group = groupOf(header[displacement[0]].text);
  const Places beside = element::those(times, [&](std::size_t place) { return groupOf(header[place].text) == group; });
  return beside.size() == 1 && !group.empty() ? beside : times;
}

Column findColumn(const ColumnFinder& finder, const std::vector<ColumnName>& header, const LogFormat& format,
                  Quantity quantity) {
  if (!channelOf(format, quantity).column.empty()) {
    return mappedColumn(header, format, quantity);
  }
  Places places = finder.find(quantity);
  if (quantity == Quantity::time) {
    places = besideDisplacement(finder, header, places);
  }
  if (quantity == Quantity::temperature && (places.size() != 1 || header[places[0]].unit.empty())) {
    return {};  // the temperature is optional
  }
  refuseAmbiguity(header, places, toString(quantity), quantity);
  return places.empty() ? Column() : foundColumn(header, places[0], format, quantity);
}

// Returns a hint for the error if the header contains stress or strain in place of force or displacement.
std::string hintOfMaterial(const std::vector<ColumnName>& header, Quantity quantity) {
  const auto of_material = element::those(
      header, [](const ColumnName& name) { return isOfMaterial(lowerCase(name.bare)) && !quantityOfUnit(name.unit); });
  return materialHint(quantity == Quantity::displacement ? element::each(of_material, quotedName)
                                                         : std::vector<std::string>());
}

void requireColumn(const Column& column, const std::vector<ColumnName>& header, Quantity quantity) {
  const auto unnamed =
      std::find_if(header.begin(), header.end(), [](const ColumnName& name) { return name.text.empty(); });
  element::refuseIf<std::runtime_error>(
      !column.found(), "there is no column of {}; the header has {}{}; accepted: {}{}", toString(quantity),
      listed(header), hintOfMaterial(header, quantity), accepted(quantity),
      quantity == Quantity::time && unnamed != header.end()
          ? fmt::format("; select the column without a name with --columns time={} --unit time=s",
                        unnamed - header.begin() + 1)
          : "");
}

void refuseTwoOfOne(const Columns& columns, const std::vector<ColumnName>& header) {
  for (const Column* one : columns.all()) {
    for (const Column* other : columns.all()) {
      if (one != other && other->isAt(one->index)) {
        throw std::runtime_error(
            fmt::format("column {} is given for two quantities; accepted: a separate column for each",
                        quoted(header[one->index].withUnit())));
      }
    }
  }
}

// Returns the column of time, whose stamps the sampling rate replaces; none if the column is ambiguous or invalid.
Column timeBesideRate(const ColumnFinder& finder, const std::vector<ColumnName>& header, const LogFormat& format) {
  try {
    return findColumn(finder, header, format, Quantity::time);
  } catch (const std::runtime_error&) {
    return {};
  }
}

struct FoundColumns {
  bool options_fit = true;  // true if the header contains all columns that the user named
  int found = 0;
  int missing = 0;  // number of columns that a log needs and the header lacks
};

FoundColumns countColumns(const std::vector<ColumnName>& header, const LogFormat& format) {
  const ColumnFinder finder(header, format);
  FoundColumns columns;
  for (const Quantity quantity : kQuantities) {
    const std::string& option = channelOf(format, quantity).column;
    columns.options_fit = columns.options_fit && (option.empty() || !placesOfOption(header, option).empty());
    const bool there = !option.empty() || (isWanted(quantity, format) && !finder.find(quantity).empty());
    const bool needed = quantity == Quantity::displacement || (quantity == Quantity::time && !format.rate);
    columns.found += there ? 1 : 0;
    columns.missing += needed && !there ? 1 : 0;
  }
  return columns;
}

}  // namespace

Columns findColumns(const std::vector<ColumnName>& header, const LogFormat& format) {
  const ColumnFinder finder(header, format);
  Columns columns;
  columns.count = header.size();
  if (isWanted(Quantity::time, format)) {
    columns.time = findColumn(finder, header, format, Quantity::time);
    requireColumn(columns.time, header, Quantity::time);
  } else {
    columns.time = timeBesideRate(finder, header, format);
  }
  columns.displacement = findColumn(finder, header, format, Quantity::displacement);
  requireColumn(columns.displacement, header, Quantity::displacement);
  columns.force = findColumn(finder, header, format, Quantity::force);
  columns.temperature = findColumn(finder, header, format, Quantity::temperature);
  refuseTwoOfOne(columns, header);
  for (const Quantity quantity : kQuantities) {
    const std::string& unit = channelOf(format, quantity).unit;
    element::refuseIf<std::runtime_error>(
        !unit.empty() && !columns.of(quantity).found() && isWanted(quantity, format),
        "--unit {0}={1}: there is no column of {0}; the header has {2}; accepted: together with --columns {0}=NAME",
        toString(quantity), unit, listed(header));
  }
  return columns;
}

Column timeAt(const std::vector<ColumnName>& header, std::size_t place, const LogFormat& format) {
  return columnAt(header, place, format, Quantity::time, header[place].unit, definedUnit(header[place].bare));
}

void requireTimeUnit(Columns& columns, const LogFormat& format) {
  if (columns.time.found() && !columns.time.tells_unit && columns.time.assumed_unit.empty()) {
    if (!format.rate) {
      refuseNoUnit(columns.time, Quantity::time);
    }
    columns.time = Column();
  }
}

bool looksLikeHeader(const std::vector<ColumnName>& header, const LogFormat& format) {
  const FoundColumns columns = countColumns(header, format);
  return columns.options_fit && (columns.missing == 0 || columns.found >= 2);
}

bool holdsLog(const std::vector<ColumnName>& header, const LogFormat& format) {
  const FoundColumns columns = countColumns(header, format);
  return columns.options_fit && columns.missing == 0;
}

UnitsAre unitsOf(const Columns& columns, const LogFormat& format) {
  const bool assumed = !columns.displacement.assumed_unit.empty() || !columns.force.assumed_unit.empty();
  return format.accept_units ? UnitsAre::accepted : assumed ? UnitsAre::assumed : UnitsAre::named;
}

std::vector<std::string> notesOnIgnored(const std::vector<ColumnName>& header, const Columns& columns,
                                        const LogFormat& format) {
  constexpr std::size_t kMostNamed = 12;
  std::vector<std::string> notes;
  const auto all = columns.all();
  std::size_t ignored = 0;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool read = std::any_of(all.begin(), all.end(), [i](const Column* column) { return column->isAt(i); });
    if (!read && !header[i].text.empty() && ++ignored <= kMostNamed) {
      const bool as_force = !columns.force.found() && looksLikeForce(header[i].text);
      notes.push_back(fmt::format("column {} is ignored", quoted(header[i].withUnit())) +
                      (as_force ? "; if it is the measured force, use --columns force=" + std::to_string(i + 1) +
                                      " --unit force=UNIT"
                                : ""));
    }
  }
  if (ignored > kMostNamed) {
    notes.push_back(fmt::format("{} more columns are ignored", ignored - kMostNamed));
  }
  for (const Column* column : all) {
    if (!column->assumed_unit.empty()) {
      notes.push_back(fmt::format("column {} is read in {}; --unit selects another unit", quoted(column->name),
                                  column->assumed_unit));
    }
  }
  for (const Quantity quantity : kQuantities) {
    const Column& column = columns.of(quantity);
    const std::string& unit = channelOf(format, quantity).unit;
    const std::string own = column.found() ? header[column.index].unit : "";
    if (!unit.empty() && !own.empty() && own != unit) {
      notes.push_back(fmt::format("column {} is read in {}, as set with --unit", quoted(column.label), quoted(unit)));
    }
  }
  return notes;
}

bool areCanonical(const Columns& columns) {
  return std::all_of(kQuantities.begin(), kQuantities.end(), [&](Quantity quantity) {
    const Column& column = columns.of(quantity);
    return !column.found() || (isCanonical(column.name, quantity) && column.factor == 1.0);
  });
}

std::string describeColumns(const Columns& columns, const LogExtent& extent) {
  std::vector<std::string> parts;
  for (const Quantity quantity : kQuantities) {
    if (const Column& column = columns.of(quantity); column.found()) {
      const std::string factor = column.factor == 1.0 ? "" : fmt::format("{:g} times ", column.factor);
      parts.push_back(fmt::format("{} from {}{}", toString(quantity), factor, quoted(column.label)));
    }
  }
  if (extent.samples > 1) {
    const double duration = 1e-9 * static_cast<double>(extent.last_stamp - extent.first_stamp);
    parts.push_back(fmt::format("{:.6g} Hz", static_cast<double>(extent.samples - 1) / duration));
  }
  return join(parts);
}

std::int64_t toStamp(long double time, const Column& column) {
  const long double seconds_per_unit = column.toSi(1.0);
  const long double units_per_second = std::round(1.0L / seconds_per_unit);
  // Divides if the unit is a whole part of a second: 1 ms is 1/1000 s, but 0.001 has no exact binary representation.
  const bool whole = seconds_per_unit < 1.0L && std::abs(units_per_second * seconds_per_unit - 1.0L) < 1e-15L;
  const long double seconds = whole ? time / units_per_second : time * seconds_per_unit;
  element::refuseIf<std::runtime_error>(!(std::abs(seconds) <= kMaximumTime),
                                        "{}: {:g} s is out of range; accepted: at most {:g} s", column.name,
                                        static_cast<double>(seconds), kMaximumTime);
  return std::llroundl(seconds * 1e9L);
}

std::int64_t stampAtRate(std::size_t sample, double rate) {
  return std::llround(static_cast<double>(sample) * 1e9 / rate);
}

std::string formatStamp(std::int64_t stamp) {
  const std::int64_t magnitude = std::abs(stamp);
  return fmt::format("{}{}.{:09d}", stamp < 0 ? "-" : "", magnitude / 1000000000, magnitude % 1000000000);
}

std::size_t wholeNumber(const std::string& text, std::size_t most) {
  const bool digits = !text.empty() && text.size() <= most && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? std::stoul(text) : 0;
}

std::string logName(const std::string& path) {
  std::string file = path.substr(path.find_last_of('/') + 1);
  if (file.size() > 3 && endsWith(file, ".gz")) {
    file.resize(file.size() - 3);
  }
  return oneLine(file.substr(0, file.find_last_of('.')));
}

}  // namespace rubber_suspension::log
