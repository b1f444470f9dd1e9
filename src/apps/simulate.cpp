// The node `simulate` publishes the forces of rubber components for the displacements on their topics.
#include "command_line/command.h"
#include "ros_interface/command_line.h"
#include "ros_interface/simulate_node.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand(
      line.argc(), line.argv(),
      {"simulate",
       "Publishes <component>/force for every sample on <component>/displacement. --help-all lists its private "
       "parameters.\n\nPrivate parameters:\n" +
           ros_interface::describeNodeSettings(),
       {{"The components of a file", "_config_file:=component.yaml"},
        {"With two threads and short time gaps", "_config_file:=component.yaml _threads:=2 _max_gap:=0.1"},
        {"Below a namespace", "__ns:=bench _config_file:=component.yaml"}}},
      {}, [&] {
        ros_interface::runSimulateNode(line);
        return kSuccess;
      });
}
