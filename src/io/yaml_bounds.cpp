// Limits of the nesting and size of a YAML text.
#include "io/yaml_bounds.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <sstream>
#include <vector>

namespace rubber_suspension::io {
namespace {

constexpr int kMaximumNesting = 50;  // a component file needs a depth of 6
constexpr int kMaximumIndentation = 200;
// A component file of one mebibyte without aliases has at most this number of values, at two bytes per value.
constexpr std::size_t kMaximumValues = 524288;

struct ExpandedTooFar {
  int line;
};

// Counts values while they are parsed. An alias counts as many as the values of its anchor.
class ValueCounter : public YAML::EventHandler {
 public:
  int startOfDocument() const { return start_; }  // line, from 1

  void OnDocumentStart(const YAML::Mark& mark) override { start_ = mark.line + 1; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { leaf(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, const std::string&) override {
    leaf(mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override { count(mark, sizes_[anchor]); }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(mark, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(mark, anchor);
  }
  void OnMapEnd() override { end(); }

 private:
  struct Open {
    YAML::anchor_t anchor;
    std::size_t before;  // number of values before this one
  };

  void count(const YAML::Mark& mark, std::size_t values) {
    values_ += values;
    if (values_ > kMaximumValues) {
      throw ExpandedTooFar{mark.line + 1};
    }
  }

  void leaf(const YAML::Mark& mark, YAML::anchor_t anchor) {
    sizes_[anchor] = 1;
    count(mark, 1);
  }

  void begin(const YAML::Mark& mark, YAML::anchor_t anchor) {
    open_.push_back({anchor, values_});
    count(mark, 1);
  }

  void end() {
    sizes_[open_.back().anchor] = values_ - open_.back().before;
    open_.pop_back();
  }

  int start_ = 1;
  std::size_t values_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::size_t> sizes_;  // entry 0, for values without an anchor, is never read
};

// Returns the line at which a text is nested more deeply than any file of this package. In some versions the parser
// recurses without a limit. Brackets in quotes and comments count, but real files have few.
std::optional<int> lineNestedTooDeep(const std::string& text) {
  int line = 1;
  int brackets = 0;
  int indentation = 0;
  bool leading = true;  // true while the line contains only blanks and marks of nested lists and keys
  for (const char c : text) {
    brackets += (c == '[' || c == '{' ? 1 : 0) - (c == ']' || c == '}' ? 1 : 0);
    leading = c == '\n' || (leading && (c == ' ' || c == '-' || c == '?' || c == ':'));
    indentation = leading && c != '\n' ? indentation + 1 : (leading ? 0 : indentation);
    line += c == '\n' ? 1 : 0;
    if (brackets > kMaximumNesting || (leading && indentation > kMaximumIndentation)) {
      return line;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<YamlProblem> beyondYamlBounds(const std::string& text) {
  if (const auto line = lineNestedTooDeep(text)) {
    return YamlProblem{
        *line, fmt::format("the file is nested too deeply; accepted: at most {} brackets and {} columns of indentation",
                           kMaximumNesting, kMaximumIndentation)};
  }
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  ValueCounter counter;
  try {
    parser.HandleNextDocument(counter);
  } catch (const ExpandedTooFar& found) {
    return YamlProblem{found.line, fmt::format("the file has too many values; accepted: at most {}, where each alias "
                                               "(*name) counts with all values that it stands for",
                                               kMaximumValues)};
  }
  return std::nullopt;
}

// YAML::LoadAll is not used, because for a stray comma it never returns.
std::optional<int> lineOfSecondDocument(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  ValueCounter counter;
  bool second = true;
  try {
    second = parser.HandleNextDocument(counter) && parser.HandleNextDocument(counter);
  } catch (const ExpandedTooFar&) {  // the second document has begun
  }
  return second ? std::optional(counter.startOfDocument()) : std::nullopt;
}

}  // namespace rubber_suspension::io
