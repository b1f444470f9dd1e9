// export_bushing: stays for one version beside `export --format adams_bus` and altair_gbs.
#include <algorithm>

#include "apps/replaced.h"

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool altair = std::any_of(arguments.begin(), arguments.end(), [](const std::string& argument) {
    return std::filesystem::path(argument).extension() == ".gbs";
  });
  arguments.insert(arguments.begin(), {"--format", altair ? "altair_gbs" : "adams_bus"});
  return rubber_suspension::apps::becomeExport("export_bushing", std::move(arguments));
}
