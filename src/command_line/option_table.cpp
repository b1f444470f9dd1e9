// Represents the options of a command as data.
#include "command_line/option_table.h"

namespace rubber_suspension::command_line {
namespace {

bool takesSeveral(const Target& target) {
  if (const Quantity* quantity = std::get_if<Quantity>(&target)) {
    return std::holds_alternative<std::vector<double>*>(quantity->value);
  }
  return std::holds_alternative<std::vector<std::string>*>(target) || std::holds_alternative<std::vector<int>*>(target);
}

}  // namespace

Option::Option(std::string name_, bool& given, std::string help_)
    : Option(std::move(name_), Target(&given), "", std::move(help_)) {}

Option::Option(std::string name_, Target target_, std::string placeholder_, std::string help_)
    : name(std::move(name_)),
      target(std::move(target_)),
      placeholder(std::move(placeholder_)),
      help(std::move(help_)),
      most_values(takesSeveral(target) ? kAny : 1) {}

OptionTable::OptionTable(std::initializer_list<OptionTable> parts) {
  for (const OptionTable& part : parts) {
    options_.insert(options_.end(), part.options_.begin(), part.options_.end());
    rules_.insert(rules_.end(), part.rules_.begin(), part.rules_.end());
  }
}

OptionTable& OptionTable::add(Rule rule) {
  rules_.push_back(std::move(rule));
  return *this;
}

}  // namespace rubber_suspension::command_line
