// Figures, drawn by scripts/plot_figures in a process of its own: the data goes there as JSON.
#include "rubber_suspension/io/figure.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "log/new_file.h"
#include "log/text.h"

extern char** environ;

namespace rubber_suspension::io {

using nlohmann::json;

// Found by the JSON library through the types, hence outside the unnamed namespace.
static void to_json(json& out, const Curve& curve) {
  out = {{"label", curve.label}, {"x", curve.x},           {"y", curve.y},
         {"style", curve.style}, {"colour", curve.colour}, {"width", curve.width}};
}

static void to_json(json& out, const HeatMap& map) {
  out = {{"x_edges", map.x_edges}, {"y_edges", map.y_edges}, {"values", map.values}, {"label", map.label}};
}

static void to_json(json& out, const Axes& axes) {
  out = {{"title", axes.title}, {"x_label", axes.x_label}, {"y_label", axes.y_label}, {"log_x", axes.log_x},
         {"log_y", axes.log_y}, {"rows", axes.rows},       {"curves", axes.curves},   {"maps", axes.maps}};
}

static void to_json(json& out, const Figure& figure) {
  out = {{"title", figure.title}, {"columns", figure.columns}, {"axes", figure.axes}};
}

namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

void checkSizes(const Figure& figure) {
  for (const Axes& axes : figure.axes) {
    for (const Curve& curve : axes.curves) {
      if (curve.x.size() != curve.y.size()) {
        throw FigureError(fmt::format("figure '{}', curve '{}': {} values of x and {} of y", figure.title, curve.label,
                                      curve.x.size(), curve.y.size()));
      }
    }
    for (const HeatMap& map : axes.maps) {
      const bool fits = map.x_edges.size() > 1 && map.y_edges.size() > 1 &&
                        map.values.size() == (map.x_edges.size() - 1) * (map.y_edges.size() - 1);
      if (!fits) {
        throw FigureError(fmt::format("figure '{}', map '{}': {} values do not fit {} x {} edges", figure.title,
                                      map.label, map.values.size(), map.x_edges.size(), map.y_edges.size()));
      }
    }
  }
}

// The script lies in the package's folder next to this library, in a devel space as in an install space.
std::string scriptPath() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&scriptPath), &info) == 0) {
    throw FigureError("the library's own place is unknown");
  }
  const std::string library = info.dli_fname;
  const std::size_t slash = library.find_last_of('/');
  return (slash == std::string::npos ? std::string(".") : library.substr(0, slash)) + "/rubber_suspension/plot_figures";
}

FilePointer temporaryFile() {
  FilePointer file(std::tmpfile(), std::fclose);
  if (!file) {
    throw FigureError(fmt::format("no temporary file can be made: {}", std::strerror(errno)));
  }
  return file;
}

std::string content(std::FILE* file) {
  std::string text;
  char buffer[65536];
  std::rewind(file);
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file)) {
    text.append(buffer, count);
  }
  return text;
}

std::string lastLine(std::string text) {
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  const std::size_t start = text.find_last_of('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

// Files in place of pipes: neither side ever waits for the other to read.
struct Streams {
  FilePointer input = temporaryFile();
  FilePointer output = temporaryFile();
  FilePointer errors = temporaryFile();
};

pid_t spawn(const std::string& script, const Streams& streams) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(streams.input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(streams.output.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(streams.errors.get()), STDERR_FILENO);
  std::string name = script;
  char* arguments[] = {name.data(), nullptr};
  pid_t process = 0;
  const int error = posix_spawn(&process, script.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw FigureError(fmt::format("{} cannot be started: {}", script, std::strerror(error)));
  }
  return process;
}

std::string runScript(const json& request) {
  Streams streams;
  const std::string text = request.dump(-1, ' ', false, json::error_handler_t::replace);
  if (std::fwrite(text.data(), 1, text.size(), streams.input.get()) != text.size() ||
      std::fflush(streams.input.get()) != 0) {
    throw FigureError(fmt::format("the data of a figure cannot be written: {}", std::strerror(errno)));
  }
  std::rewind(streams.input.get());
  const pid_t process = spawn(scriptPath(), streams);
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) {
      throw FigureError(fmt::format("the drawing process was lost: {}", std::strerror(errno)));
    }
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    const std::string reason = lastLine(content(streams.errors.get()));
    throw FigureError(fmt::format("no figure drawn: {}", reason.empty() ? "the drawing process was ended" : reason));
  }
  return content(streams.output.get());
}

json request(const std::vector<Figure>& figures, const json& path) {
  for (const Figure& figure : figures) {
    checkSizes(figure);
  }
  return {{"path", path}, {"figures", figures}};
}

}  // namespace

void addSpreads(Axes& axes, const std::string& label, const std::vector<Spread>& values, double offset, int colour) {
  Curve lines{"", {}, {}, "-", colour};
  Curve markers{label, {}, {}, "o", colour};
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double y = static_cast<double>(row) + offset;
    const double gap = std::numeric_limits<double>::quiet_NaN();  // between the lines of two rows
    lines.x.insert(lines.x.end(), {values[row].lower, values[row].upper, gap});
    lines.y.insert(lines.y.end(), {y, y, gap});
    markers.x.push_back(values[row].median);
    markers.y.push_back(y);
  }
  axes.curves.push_back(std::move(lines));
  axes.curves.push_back(std::move(markers));
}

bool isFigurePath(const std::string& path) { return log::endsWith(path, ".svg") || log::endsWith(path, ".png"); }

void drawFigure(const Figure& figure, const std::string& path) {
  if (!isFigurePath(path)) {
    throw FigureError(fmt::format("{}: accepted: a name that ends in .svg or .png", path));
  }
  try {
    log::NewFile file(path);
    runScript(request({figure}, file.writingPath()));
    file.commit();
  } catch (const FigureError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw FigureError(error.what());
  }
}

std::vector<std::string> drawSvg(const std::vector<Figure>& figures) {
  if (figures.empty()) {
    return {};
  }
  try {
    return json::parse(runScript(request(figures, nullptr))).get<std::vector<std::string>>();
  } catch (const json::exception& error) {
    throw FigureError(fmt::format("the drawing process gave no list of figures: {}", error.what()));
  }
}

}  // namespace rubber_suspension::io
