// reference: prints the reference page of the component file.
#include "rubber_suspension/io/reference.h"

#include "command.h"

int main(int argc, char** argv) {
  using namespace rubber_suspension;
  return runCommand(argc, argv, "reference", "Prints all models, keys and elements of the component file as Markdown.",
                    [](CLI::App&) -> CommandBody {
                      return [] {
                        std::cout << parameterReference();
                        return kSuccess;
                      };
                    });
}
