// Scripts of the package, each of which runs in a separate process.
#include "io/script.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

extern char** environ;

namespace rubber_suspension::io {
namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Returns the path of a script. Scripts are installed in the package's folder beside this library. In a build tree,
// this folder contains a file with the path of the scripts instead.
std::string scriptPath(const std::string& name) {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&scriptPath), &info) == 0) {
    throw std::runtime_error("the folder of this library is unknown");
  }
  const std::filesystem::path folder = std::filesystem::path(info.dli_fname).parent_path() / "rubber_suspension";
  std::ifstream elsewhere(folder / "scripts_folder.txt");
  std::string scripts;
  return (std::getline(elsewhere, scripts) ? std::filesystem::path(scripts) : folder) / name;
}

FilePointer temporaryFile() {
  FilePointer file(std::tmpfile(), std::fclose);
  if (!file) {
    throw std::runtime_error(fmt::format("a temporary file cannot be created: {}", std::strerror(errno)));
  }
  return file;
}

std::string lastLine(std::FILE* file) {
  std::string text;
  char buffer[4096];
  std::rewind(file);
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file)) {
    text.append(buffer, count);
  }
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  const std::size_t start = text.find_last_of('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

// Streams of a script. They are files, because with pipes each process could wait for the other to read.
struct Streams {
  FilePointer input = temporaryFile();
  FilePointer errors = temporaryFile();
};

pid_t spawn(const std::string& script, std::vector<std::string> arguments, const Streams& streams) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(streams.input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(streams.errors.get()), STDERR_FILENO);
  arguments.insert(arguments.begin(), script);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  pid_t process = 0;
  const int error = posix_spawn(&process, script.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw std::runtime_error(fmt::format("{} cannot be started: {}", script, std::strerror(error)));
  }
  return process;
}

}  // namespace

ScriptResult runScript(const std::string& name, const std::vector<std::string>& arguments, const std::string& input) {
  const Streams streams;
  if (std::fwrite(input.data(), 1, input.size(), streams.input.get()) != input.size() ||
      std::fflush(streams.input.get()) != 0) {
    throw std::runtime_error(fmt::format("the input of {} cannot be written: {}", name, std::strerror(errno)));
  }
  std::rewind(streams.input.get());
  const pid_t process = spawn(scriptPath(name), arguments, streams);
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) {
      throw std::runtime_error(fmt::format("waiting for the process of {} failed: {}", name, std::strerror(errno)));
    }
  }
  const bool succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  const std::string error = lastLine(streams.errors.get());
  return {succeeded, error.empty() && !succeeded ? name + " was ended by a signal" : error};
}

}  // namespace rubber_suspension::io
