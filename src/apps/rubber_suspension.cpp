// The program rubber-suspension on PATH, whose subcommands are the programs in lib/rubber_suspension.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "element/suggestion.h"
#include "log/text.h"

namespace {

namespace fs = std::filesystem;

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

// Returns the folder of the programs relative to the file of this program, even if a symbolic link was called.
fs::path programsFolder() {
  return fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "lib" / "rubber_suspension";
}

// Returns the path of a program. A devel space has no copies of scripts, but a file that contains their folder.
fs::path programPath(const std::string& name) {
  fs::path program = programsFolder() / name;
  std::ifstream elsewhere(programsFolder() / "scripts_folder.txt");
  std::string folder;
  return !fs::exists(program) && std::getline(elsewhere, folder) ? fs::path(folder) / name : program;
}

int fail(int status, const std::string& message) {
  std::cerr << "rubber-suspension: " << rubber_suspension::log::oneLine(message) << '\n';
  return status;
}

// Adds the Python module of this space to PYTHONPATH, so that scripts find it without setup.sh.
void addPythonModule() {
  const char* others = std::getenv("PYTHONPATH");
  const std::string own = (programsFolder().parent_path() / "python3" / "dist-packages").string();
  setenv("PYTHONPATH", (others == nullptr ? own : own + ":" + others).c_str(), 1);
}

// Replaces this process by the program, so that the caller receives the exit status and signals of the program.
int become(const std::string& name, char** arguments) {
  addPythonModule();
  const std::string program = programPath(name).string();
  execv(program.c_str(), arguments);
  return fail(kFailed, program + ": " + std::strerror(errno));
}

int printHelp() {
  const fs::path path = programsFolder() / "commands.txt";
  std::ifstream list(path);
  if (!list) {
    return fail(kFailed, path.string() + ": cannot be read");
  }
  std::cout << "Runs a command of the package rubber_suspension: simulates rubber components of vehicle suspensions\n"
               "and diagnoses the gap to measured logs.\n"
               "Usage: rubber-suspension COMMAND [OPTIONS]\n\n"
               "Options:\n"
               "  -h,--help         Print this help message and exit; after a command: the help of the command\n"
               "  --version         Print the version and exit\n\n"
               "Scripts: generate_track, live_plot, render_report\n\n"
               "Commands:\n"
            << list.rdbuf();
  return 0;
}

std::vector<std::string> commandNames() {
  std::istringstream words(RUBBER_SUSPENSION_COMMANDS);
  return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
}

int run(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "--help" || command == "-h") {
    return printHelp();
  }
  if (command == "--version") {
    std::cout << "rubber-suspension " << RUBBER_SUSPENSION_VERSION << '\n';
    return 0;
  }
  const std::vector<std::string> names = commandNames();
  if (std::find(names.begin(), names.end(), command) != names.end()) {
    return become(command, argv + 1);
  }
  const std::string what = command.empty() ? "the command is missing"
                                           : "unknown command " + rubber_suspension::log::quoted(command) +
                                                 rubber_suspension::element::didYouMean(command, names);
  return fail(kWrongUsage, what + "; accepted: " + rubber_suspension::log::join(names) + ", --help, --version");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    return fail(kFailed, error.what());
  }
}
