// export_table: stays for one version beside `export --format table`.
#include "apps/replaced.h"

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  arguments.insert(arguments.begin(), {"--format", "table"});
  return rubber_suspension::apps::becomeExport("export_table", std::move(arguments));
}
