// How deep a YAML text may be nested.
#include "io/yaml_nesting.h"

#include <fmt/format.h>

namespace rubber_suspension::io {
namespace {

constexpr int kMaximumNesting = 50;  // a component file needs 6
constexpr int kMaximumIndentation = 200;

}  // namespace

std::optional<int> lineNestedTooDeep(const std::string& text) {
  int line = 1;
  int brackets = 0;
  int indentation = 0;
  bool leading = true;  // nothing on this line so far but blanks and the marks of nested lists and keys
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

std::string acceptedNesting() {
  return fmt::format("nested too deep; accepted: at most {} brackets and {} columns of indentation", kMaximumNesting,
                     kMaximumIndentation);
}

}  // namespace rubber_suspension::io
