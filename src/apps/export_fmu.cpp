// export_fmu: stays for one version beside `export --format fmu2` and fmu3.
#include <algorithm>

#include "apps/replaced.h"

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::string versions = std::string("--") + "fmi";  // an option of the past
  std::string format = "fmu2";
  const auto option = std::find_if(arguments.begin(), arguments.end(), [&](const std::string& argument) {
    return argument == versions || argument.compare(0, 6, versions + "=") == 0;
  });
  if (option != arguments.end()) {
    const bool apart = *option == versions && option + 1 != arguments.end();
    format = "fmu" + (apart ? option[1] : option->substr(std::min<std::size_t>(6, option->size())));
    arguments.erase(option, option + (apart ? 2 : 1));
  }
  arguments.insert(arguments.begin(), {"--format", format});
  return rubber_suspension::apps::becomeExport("export_fmu", std::move(arguments));
}
