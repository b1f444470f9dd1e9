// The options of a command as data.
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

Option& Option::required() {
  is_required = true;
  return *this;
}

Option& Option::hidden() {
  is_hidden = true;
  return *this;
}

Option& Option::within(double lowest, double highest) {
  bounds = {lowest, highest};
  return *this;
}

Option& Option::oneOf(std::vector<std::string> all) {
  words = std::move(all);
  return *this;
}

Option& Option::values(int least, int most) {
  least_values = least;
  most_values = most;
  return *this;
}

Option& Option::defaultText(std::string text) {
  default_text = std::move(text);
  return *this;
}

Option& Option::checkedBy(std::function<std::string(const std::string&)> check) {
  problem = std::move(check);
  return *this;
}

OptionTable::OptionTable(std::initializer_list<OptionTable> parts) {
  for (const OptionTable& part : parts) {
    options_.insert(options_.end(), part.options_.begin(), part.options_.end());
    rules_.insert(rules_.end(), part.rules_.begin(), part.rules_.end());
  }
}

OptionTable& OptionTable::needs(std::vector<std::string> options, std::vector<std::string> conditions) {
  rules_.push_back({Rule::Kind::needs, std::move(options), std::move(conditions)});
  return *this;
}

OptionTable& OptionTable::excludes(std::vector<std::string> options, std::vector<std::string> conditions) {
  rules_.push_back({Rule::Kind::excludes, std::move(options), std::move(conditions)});
  return *this;
}

OptionTable& OptionTable::oneOf(std::vector<std::string> options) {
  rules_.push_back({Rule::Kind::one_of, std::move(options), {}});
  return *this;
}

}  // namespace rubber_suspension::command_line
