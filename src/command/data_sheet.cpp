// Reads data sheets in YAML.
#include "command/data_sheet.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "element/refuse.h"
#include "io/element_reader.h"
#include "log/text.h"
#include "rubber_suspension/estimation/notes.h"

namespace rubber_suspension::command {
namespace {

using io::Entry;
using io::into;
using io::Key;

constexpr const char* kNote = "# ";
constexpr std::size_t kMaximumSize = 64 * 1024;  // bytes; a data sheet has a few lines only

struct Sheet {
  std::string component;
  std::optional<estimation::Model> model;
  std::optional<estimation::LoadDirection> load;
  std::map<std::string, double> values;
};

class SheetReader : public io::ElementReader {
 public:
  explicit SheetReader(std::string source) : ElementReader(std::move(source), "a data sheet", "data_sheet") {}

  Sheet load(const std::string& text) {
    std::vector<Key<Sheet>> keys = {
        into(
            "component", &Sheet::component, [this](const Entry& entry) { return loadText(entry); }, "a name"),
        into("model", &Sheet::model, [this](const Entry& entry) { return loadModel(entry); }),
        into("load", &Sheet::load, [this](const Entry& entry) {
          return static_cast<estimation::LoadDirection>(loadWord(entry, {"compression", "shear"}));
        })};
    for (const auto* table : {&estimation::dataSheetParameters(), &estimation::specificationParameters()}) {
      for (const element::ParameterInfo& row : *table) {
        keys.push_back({row.name, [this, &row](const Entry& entry, Sheet& sheet) {
                          loadText(entry);
                          sheet.values[row.name] = loadNumber(entry, row);
                        }});
      }
    }
    const Entry root{parse(text), ""};
    checkMap(root, {"data_sheet"}, "a map with the key 'data_sheet'");
    Sheet sheet;
    read(require(root, "data_sheet", "a map"), keys, sheet);
    return sheet;
  }

 private:
  std::string loadText(const Entry& entry) const {
    if (!entry.isText()) {
      refuseContent(entry, "one number or text");
    }
    return entry.text();
  }

  estimation::Model loadModel(const Entry& entry) const {
    std::vector<std::string> names = io::modelNames();
    names.pop_back();  // a data sheet cannot result in a list of elements
    return static_cast<estimation::Model>(loadWord(entry, names, "a model"));
  }
};

std::string convert(const Sheet& sheet) {
  element::refuseIf(
      sheet.load.has_value() != (sheet.values.count("shore_a") != 0),
      "load and shore_a: only one of them is given; accepted: both (load: compression or shear) or neither");
  const estimation::DataSheetResult result = estimation::specificationFromDataSheet(
      sheet.model, sheet.load.value_or(estimation::LoadDirection::compression), sheet.values);
  const io::ComponentDescription description(sheet.component, result.model, result.specification);
  std::string file = "# Component file from a data sheet.\n";
  std::vector<std::string> notes = result.notes;
  if (!sheet.model) {
    notes.push_back(
        fmt::format("model {} is the simplest that uses all of these numbers; the key model selects another",
                    estimation::toString(result.model)));
  }
  const std::vector<std::string> of_estimation = estimation::estimationNotes(result.model, result.specification);
  notes.insert(notes.end(), of_estimation.begin(), of_estimation.end());
  for (const std::string& note : notes) {
    file += kNote + note + "\n";
  }
  file += io::toYaml({description});
  io::parseComponentFile(file, "component file");  // also checks that the node accepts the name
  return file;
}

}  // namespace

std::string componentFileFromDataSheetText(const std::string& text, const std::string& source) {
  try {
    const Sheet sheet = SheetReader(source).load(text);
    try {
      return convert(sheet);
    } catch (const std::exception& error) {
      throw std::runtime_error(source + ": " + error.what());
    }
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

std::string componentFileFromDataSheet(const std::string& path) {
  return componentFileFromDataSheetText(log::readInput(path, kMaximumSize), path);
}

}  // namespace rubber_suspension::command
