// Draws the figures of the paper that the models come from.
#include <memory>

#include "apps/command.h"
#include "command/paper_figures.h"

namespace rubber_suspension::apps {
namespace {

CommandBody define(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  app.add_option("--output", *folder, "folder for the figures; made if missing")->required()->type_name("FOLDER");
  return [folder] {
    for (const std::string& path : command::writePaperFigures(command::paperFigures(), *folder)) {
      std::cout << path << '\n';
    }
    return kSuccess;
  };
}

}  // namespace
}  // namespace rubber_suspension::apps

int main(int argc, char** argv) {
  return rubber_suspension::apps::runCommand(
      argc, argv, "reproduce_paper",
      "Draws figures 3, 4, 5, 6 and 8 of O. Polach, Modelling of rubber components using estimated parameters (IAVSD "
      "2015), and writes their numbers as CSV. Curves and axes follow the text of the paper; the low frequency (Eq. "
      "22) "
      "and the inputs of figure 8 are reconstructions.",
      rubber_suspension::apps::define);
}
