// Strict reading of YAML. Every refusal states file, line, place, value and accepted values.
#pragma once

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "element/suggestion.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::io {

/// A node of the file and its path in the component, such as "specification.loss_angle" or "add[0].type".
struct Entry {
  YAML::Node node;
  std::string path;

  explicit operator bool() const { return node.IsDefined(); }
  bool isText() const { return node.IsScalar(); }
  const std::string& text() const { return node.Scalar(); }
  bool startsAsNumber() const;

  Entry operator[](const std::string& key) const;  ///< entry of a map; undefined if the key is missing
  Entry operator[](std::size_t i) const;           ///< entry of a list
};

/// Returns a description of a node for an error: its text in quotes, or words such as "a list" or "nothing".
std::string kindOf(const YAML::Node& node);

/// Returns ", did you mean ...?" if the text is similar to one of the names, otherwise an empty text.
std::string hintOf(const YAML::Node& node, const std::vector<std::string>& names);

/// A key of a map and the function that stores its value in the target. A key without a function is read elsewhere.
template <class Target>
struct Key {
  std::string name;
  std::function<void(const Entry&, Target&)> read = {};
  std::string needed = {};  ///< accepted values of a required key; empty: the key is optional
};

/// Returns a key whose value is read by `load` and stored in a data member of the target.
template <class Target, class Value, class Load>
Key<Target> into(std::string name, Value Target::* member, Load load, std::string needed = {}) {
  return {std::move(name), [=](const Entry& entry, Target& target) { target.*member = load(entry); },
          std::move(needed)};
}

/// Reads one YAML file strictly: a component file, a data sheet or a jobs file. Throws ComponentFileError at the first
/// problem. If `problems_` is set, reading continues instead, and `problems_` receives every problem.
class YamlReader {
 protected:
  /// `kind` describes the expected file, such as "a component file". `key` is its required key.
  YamlReader(std::string source, std::string kind, std::string key)
      : source_(std::move(source)), kind_(std::move(kind)), key_(std::move(key)) {}

  /// Runs one step of reading. If problems are collected, a refusal ends this step alone.
  template <class Action>
  void attempt(const Action& action) {
    try {
      action();
    } catch (const ComponentFileError& error) {
      if (problems_ == nullptr) {
        throw;
      }
      problems_->emplace_back(error.what());
    }
  }

  YAML::Node parse(const std::string& text) const;

  [[noreturn]] void refuse(const Entry& entry, const std::string& problem) const;

  [[noreturn]] void refuseAt(const YAML::Node& node, const std::string& problem) const { refuse({node, ""}, problem); }

  [[noreturn]] void refuseContent(const Entry& entry, const std::string& accepted) const;

  void requireMap(const Entry& entry, const std::string& accepted = "a map") const;
  Entry require(const Entry& map, const std::string& key, const std::string& what) const;

  /// Refuses repeated keys, and merges the maps that `<<` names.
  void checkUnique(const Entry& map);
  void checkKeys(const Entry& map, const std::vector<std::string>& names);
  void checkMap(const Entry& map, const std::vector<std::string>& names, const std::string& accepted = "a map");

  static Entry keyOf(const Entry& map, const YAML::Node& key) { return {key, map[key.Scalar()].path}; }

  template <class Target>
  void read(const Entry& map, const std::vector<Key<Target>>& keys, Target& target, const char* accepted = "a map") {
    checkMap(map, element::namesOf(keys), accepted);
    for (const Key<Target>& key : keys) {
      attempt([&] {
        const Entry value = key.needed.empty() ? map[key.name] : require(map, key.name, key.needed);
        if (value && key.read) {
          key.read(value, target);
        }
      });
    }
  }

  template <class Value, class Load>
  std::vector<Value> loadMaps(const Entry& list, Load load) {
    if (!list.node.IsSequence() || list.node.size() == 0 || list.node.size() > kMaximumElements) {
      refuseContent(list, fmt::format("a list of 1 to {} maps", kMaximumElements));
    }
    std::vector<Value> values;
    for (std::size_t i = 0; i < list.node.size(); ++i) {
      requireMap(list[i]);
      values.push_back(load(list[i]));
    }
    return values;
  }

  /// Returns the index of a word in `words`. Errors state what is `wanted`, such as "a model".
  std::size_t loadWord(const Entry& entry, const std::vector<std::string>& words, const std::string& wanted = "") const;
  bool loadFlag(const Entry& entry) const { return loadWord(entry, {"false", "true"}) == 1; }

  RigTolerances loadRig(const Entry& entry);

  std::string component_;                         ///< name of the component being read, for errors
  std::string place_;                             ///< direction being read of a component of six directions
  std::vector<std::string>* problems_ = nullptr;  ///< receives all problems; nullptr: the first problem is thrown

 private:
  [[noreturn]] void refuseLine(int line, const std::string& path, const std::string& problem) const;
  void merge(const Entry& map, int depth) const;

  std::string source_;
  std::string kind_;
  std::string key_;
  // Lines of keys without a value, by the positions of their null nodes. yaml-cpp places such a node at the next token,
  // which may be some lines below.
  std::map<int, int> lines_of_nothing_;
};

}  // namespace rubber_suspension::io
