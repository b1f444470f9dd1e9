// Functions that make a list or a text from the entries of another list.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace rubber_suspension::element {

/// Returns the value of a function or of a data member for each entry of a list.
template <class List, class Function>
auto each(const List& list, const Function& of) {
  std::vector<std::decay_t<decltype(std::invoke(of, *std::begin(list)))>> result;
  for (const auto& entry : list) {
    result.push_back(std::invoke(of, entry));
  }
  return result;
}

template <class Entry, class Condition>
std::vector<Entry> those(const std::vector<Entry>& list, const Condition& holds) {
  std::vector<Entry> result;
  for (const Entry& entry : list) {
    if (std::invoke(holds, entry)) {
      result.push_back(entry);
    }
  }
  return result;
}

/// Returns the texts that a function or a data member gives for the entries of a list, joined by a separator.
template <class List, class Function>
std::string joined(const List& list, const std::string& separator, const Function& of) {
  return fmt::format("{}", fmt::join(each(list, of), separator));
}

}  // namespace rubber_suspension::element
