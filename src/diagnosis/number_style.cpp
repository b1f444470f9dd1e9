// The style of a component file that has each number as it was rounded.
#include "diagnosis/number_style.h"

#include <fmt/format.h>

#include <algorithm>

namespace rubber_suspension::diagnosis {

io::YamlStyle styleOf(const std::vector<SizedValue>& written) {
  io::YamlStyle style;
  style.number = [&](const std::string& place, double value) {
    const auto size = std::find_if(written.begin(), written.end(), [&](const auto& one) { return one.name == place; });
    return size == written.end() || size->text.empty() ? fmt::format("{}", value) : size->text;
  };
  return style;
}

}  // namespace rubber_suspension::diagnosis
