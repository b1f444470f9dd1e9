// YAML as a tree of entries, and the texts of refusals.
#include "io/yaml_reader.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "io/component_words.h"
#include "io/yaml_bounds.h"
#include "log/text.h"

namespace rubber_suspension::io {
namespace {

constexpr const char* kMerge = "<<";

// Returns a hint if a key is a number, since in a flow map the digits after a decimal comma become a key.
std::string decimalCommaHint(const std::string& key) {
  const bool digits = !key.empty() && key.find_first_not_of("0123456789eE+-") == std::string::npos;
  return digits ? " (is there a decimal comma before it? use a decimal point)" : "";
}

// Returns the first line, at most `last`, that is indented with a tab, or -1. Lines are counted from 0.
int lineWithTab(const std::string& text, int last) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= last && std::getline(lines, line); ++i) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string::npos && line[first] != '#' && line.substr(0, first).find('\t') != std::string::npos) {
      return i;
    }
  }
  return -1;
}

}  // namespace

bool Entry::startsAsNumber() const {
  return isText() && !text().empty() && std::string("+-.0123456789").find(text()[0]) != std::string::npos;
}

Entry Entry::operator[](const std::string& key) const {
  const std::string shown = isBaseName(key) ? key : log::quoted(key);
  return {node[key], path.empty() ? shown : path + "." + shown};
}

Entry Entry::operator[](std::size_t i) const { return {node[i], fmt::format("{}[{}]", path, i)}; }

std::string kindOf(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return log::quoted(node.Scalar());
    case YAML::NodeType::Sequence:
      return node.size() == 0 ? "an empty list" : "a list";
    case YAML::NodeType::Map:
      return node.size() == 0 ? "an empty map" : "a map";
    default:
      return "nothing";
  }
}

std::string hintOf(const YAML::Node& node, const std::vector<std::string>& names) {
  return node.IsScalar() ? element::didYouMean(node.Scalar(), names) : "";
}

void YamlReader::refuseLine(int line, const std::string& path, const std::string& problem) const {
  const std::string place = place_ + (place_.empty() || path.empty() ? "" : ".") + path;
  throw ComponentFileError(fmt::format("{}:{}: {}{}{}{}", source_, line,
                                       component_.empty() ? "" : fmt::format("component '{}': ", component_), place,
                                       place.empty() ? "" : ": ", problem));
}

void YamlReader::refuse(const Entry& entry, const std::string& problem) const {
  const auto key_line = entry.node.IsNull() ? lines_of_nothing_.find(entry.node.Mark().pos) : lines_of_nothing_.end();
  const int line = key_line == lines_of_nothing_.end() ? entry.node.Mark().line : key_line->second;
  refuseLine(std::max(line + 1, 1), entry.path, problem);
}

void YamlReader::refuseContent(const Entry& entry, const std::string& accepted) const {
  refuse(entry, kindOf(entry.node) + "; accepted: " + accepted);
}

void YamlReader::requireMap(const Entry& entry, const std::string& accepted) const {
  if (!entry.node.IsMap()) {
    refuseContent(entry, accepted);
  }
}

void YamlReader::checkUnique(const Entry& map) {
  std::set<std::string> seen;
  for (const auto& entry : map.node) {
    if (entry.second.IsNull()) {
      lines_of_nothing_[entry.second.Mark().pos] = entry.first.Mark().line;
    }
    if (!entry.first.IsScalar()) {
      refuse({entry.first, map.path}, fmt::format("a key is {}; accepted: a name as key", kindOf(entry.first)));
    }
    if (!seen.insert(entry.first.Scalar()).second) {
      refuse(keyOf(map, entry.first), "is given twice; accepted: once");
    }
  }
  merge(map, 0);
}

void YamlReader::checkKeys(const Entry& map, const std::vector<std::string>& names) {
  checkUnique(map);
  for (const auto& entry : map.node) {
    const std::string& key = entry.first.Scalar();
    if (std::find(names.begin(), names.end(), key) == names.end()) {
      const std::string hint = element::didYouMean(key, names);
      attempt([&] {
        refuse(keyOf(map, entry.first), fmt::format("unknown key{}; accepted: {}",
                                                    hint.empty() ? decimalCommaHint(key) : hint, log::join(names)));
      });
    }
  }
}

void YamlReader::checkMap(const Entry& map, const std::vector<std::string>& names, const std::string& accepted) {
  requireMap(map, accepted);
  checkKeys(map, names);
}

Entry YamlReader::require(const Entry& map, const std::string& key, const std::string& what) const {
  Entry entry = map[key];
  if (!entry) {
    refuseAt(map.node, fmt::format("{}{} missing; accepted: {}", entry.path, problems_ == nullptr ? " is" : ":", what));
  }
  return entry;
}

std::size_t YamlReader::loadWord(const Entry& entry, const std::vector<std::string>& words,
                                 const std::string& wanted) const {
  const auto found = entry.isText() ? std::find(words.begin(), words.end(), entry.text()) : words.end();
  if (found == words.end()) {
    refuse(entry, fmt::format("{}{}{}; accepted: {}", kindOf(entry.node), wanted.empty() ? "" : " is not " + wanted,
                              hintOf(entry.node, words), fmt::join(words, wanted.empty() ? " or " : ", ")));
  }
  return static_cast<std::size_t>(found - words.begin());
}

RigTolerances YamlReader::loadRig(const Entry& entry) {
  std::vector<Key<RigTolerances>> keys;
  for (const RigToleranceInfo& row : rigToleranceTable()) {
    keys.push_back(into(row.name, row.member, [this, &row, &entry](const Entry& value) {
      if (!value.isText()) {
        refuse(value, fmt::format("{} is not a number; accepted: a number or text", kindOf(value.node)));
      }
      try {
        return parseRigTolerance(row.name, value.text());
      } catch (const std::invalid_argument& error) {  // the message begins with the key
        refuseAt(value.node, fmt::format("{}.{}", entry.path, error.what()));
      }
    }));
  }
  RigTolerances tolerances;
  read(entry, keys, tolerances);
  return tolerances;
}

YAML::Node YamlReader::parse(const std::string& text) const {
  if (text.size() > kMaximumComponentFileSize) {
    refuseLine(1, "",
               fmt::format("the file has {} bytes; accepted: at most {}", text.size(), kMaximumComponentFileSize));
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos) {
    refuseLine(1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n')),
               "", "the file contains a 0 byte; accepted: text in UTF-8");
  }
  try {
    if (const auto problem = beyondYamlBounds(text)) {
      refuseLine(problem->line, "", problem->text);
    }
    const YAML::Node document = YAML::Load(text);
    if (document.IsNull()) {
      refuseLine(1, "", fmt::format("the file is empty; accepted: a map with the key '{}'", key_));
    }
    if (const auto line = lineOfSecondDocument(text)) {
      refuseLine(*line, "", "the file has a second YAML document; accepted: one");
    }
    return document;
  } catch (const YAML::Exception& error) {
    if (const int line = lineWithTab(text, error.mark.line); line >= 0) {
      refuseLine(line + 1, "", "not YAML: the line is indented with a tab; accepted: indentation with blanks only");
    }
    refuseLine(std::max(error.mark.line + 1, 1), "", fmt::format("not YAML: {}; accepted: {}", error.msg, kind_));
  }
}

void YamlReader::merge(const Entry& map, int depth) const {
  constexpr int kDeepest = 10;
  const Entry sources = map[kMerge];
  if (!sources) {
    return;
  }
  YAML::Node merged = map.node;
  const bool list = sources.node.IsSequence();
  for (std::size_t i = 0; i < (list ? sources.node.size() : 1); ++i) {
    const Entry source{list ? sources.node[i] : sources.node, sources.path};
    if (!source.node.IsMap() || source.node.is(merged) || depth == kDeepest) {
      refuseContent(source, "an anchor of another map, or a list of such anchors");
    }
    merge({source.node, map.path}, depth + 1);
    for (const auto& entry : source.node) {
      if (entry.first.IsScalar() && !map[entry.first.Scalar()]) {
        merged[entry.first.Scalar()] = entry.second;
      }
    }
  }
  merged.remove(kMerge);
}
}  // namespace rubber_suspension::io
