// Draws the figures of the paper that the models come from.
#include "command/paper_figures.h"
#include "command_line/command.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string folder;

  OptionTable table() {
    return Option("--output", folder, "FOLDER", "folder for the figures; made if missing").required().standsFor([this] {
      return figures();
    });
  }

  Files figures() const {
    Files files;
    for (const std::string& path : command::paperFigurePaths(folder)) {
      const bool is_figure = io::isFigurePath(path);
      files.outputs.push_back({"--output", path, is_figure ? io::FileKind::figure : io::FileKind::figure_csv});
    }
    return files;
  }
};

int draw(const Options& options) {
  for (const std::string& path : command::writePaperFigures(command::paperFigures(), options.folder)) {
    std::cout << path << '\n';
  }
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"reproduce_paper",
       "Draws figures 3, 4, 5, 6 and 8 of O. Polach, Modelling of rubber components using estimated parameters (IAVSD "
       "2015), and writes their numbers as CSV. Surfaces are drawn as maps; the low frequency (Eq. 22) and the inputs "
       "of figure 8 are reconstructions.",
       {{"Into a folder", "--output figures"},
        {"Over files of other kinds, too", "--output figures --force"},
        {"And look at one of them", "--output figures && xdg-open figures/figure_3.svg"}}},
      draw);
}
