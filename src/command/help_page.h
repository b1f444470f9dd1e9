// The text that a command prints with --help-all, taken apart again: the one table behind man pages, completion and the
// list of commands.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::command {

struct HelpOption {
  std::vector<std::string> names;  ///< "-h", "--help"; one word without dashes for an argument
  std::string placeholder;         ///< "FILE"; empty for a flag
  std::string text;                ///< on one line
};

struct HelpPage {
  std::string command;
  std::vector<std::string> description;  ///< its lines; those that begin with blanks are laid out
  std::string usage;                     ///< behind the command's name
  std::vector<HelpOption> options;       ///< arguments first
  std::vector<std::string> examples;     ///< their lines, laid out

  /// The first sentence of the description.
  std::string firstSentence() const;
};

/// Take apart what a command prints with --help-all (command_line/help.h).
HelpPage parseHelp(const std::string& command, const std::string& text);

/// The commands with their first sentences, for a terminal.
std::string commandList(const std::vector<HelpPage>& pages);

/// The page rubber-suspension-COMMAND(1), in roff; without a date, so that two builds give the same.
std::string manPage(const HelpPage& page, const std::string& version);

/// The page rubber-suspension(1): the command that has all others as subcommands.
std::string manPageOfAll(const std::vector<HelpPage>& pages, const std::string& version);

/// Completion of rubber-suspension for bash, and of rosrun for this package: commands, their options, files, folders,
/// and components of the file given.
std::string bashCompletion(const std::vector<HelpPage>& pages);

}  // namespace rubber_suspension::command
