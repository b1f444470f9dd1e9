// Draws the figures of the paper that the models come from.
#include <memory>

#include "apps/command.h"
#include "apps/output_options.h"
#include "command/paper_figures.h"

namespace rubber_suspension::apps {
namespace {

struct Options {
  std::string folder;
  OutputOptions outputs;
};

void checkOutputs(const Options& options) {
  std::vector<io::OutputFile> outputs;
  for (const std::string& path : command::paperFigurePaths(options.folder)) {
    const bool is_figure = io::isFigurePath(path);
    outputs.push_back({"--output", path, is_figure ? io::FileKind::figure : io::FileKind::figure_csv});
  }
  options.outputs.check({}, outputs);
}

CommandBody define(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("--output", options->folder, "folder for the figures; made if missing")
      ->required()
      ->type_name("FOLDER");
  options->outputs.addTo(app);
  return [options] {
    checkOutputs(*options);
    for (const std::string& path : command::writePaperFigures(command::paperFigures(), options->folder)) {
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
      "2015), and writes their numbers as CSV. Surfaces are drawn as maps; the low frequency (Eq. 22) and the inputs "
      "of "
      "figure 8 are reconstructions.",
      rubber_suspension::apps::define);
}
