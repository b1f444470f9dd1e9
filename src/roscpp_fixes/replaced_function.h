// Puts a function of ours in the place of one of a shared library, for all libraries of the process.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::roscpp_fixes {

/// A function that other libraries call across their boundary, or that stands in a table of virtual functions.
struct ReplacedFunction {
  const char* symbol;  ///< its mangled name
  void* replacement;   ///< of the same type, `this` first where it is a member
  void** original;     ///< the function itself is put there, to be called by the replacement
};

/// From now on all libraries that are loaded call the replacements. Works where the process was not linked by us, as in
/// a nodelet's manager, which an interposed symbol does not. Returns the names of those that were found nowhere.
std::vector<std::string> replaceFunctions(const std::vector<ReplacedFunction>& functions);

}  // namespace rubber_suspension::roscpp_fixes
