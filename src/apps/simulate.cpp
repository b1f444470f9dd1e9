// The node `simulate`: forces of rubber components for the displacements on their topics.
#include <malloc.h>
#include <ros/ros.h>

#include "command_line/command.h"
#include "ros_interface/command_line.h"
#include "ros_interface/simulate_node.h"
#include "ros_interface/termination.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

// Give large blocks back when they are freed: by itself the allocator takes one large message for a habit, and keeps
// room for the next.
void giveLargeBlocksBack() {
  constexpr int kLarge = 256 * 1024;
  mallopt(M_MMAP_THRESHOLD, kLarge);
  mallopt(M_TRIM_THRESHOLD, 2 * kLarge);
}

int serve(ros_interface::RosCommandLine& line) {
  giveLargeBlocksBack();
  const ros_interface::Termination termination;
  line.initialise("simulate", ros::init_options::NoSigintHandler);
  ros::NodeHandle private_handle("~");
  {
    const ros_interface::SimulateNode node(ros::NodeHandle(), private_handle);
    ros::spin();
  }
  ros::shutdown();  // waits for the thread that has begun to
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand(
      line.argc(), line.argv(),
      {"simulate",
       "Publishes <component>/force for every sample on <component>/displacement.\n\nPrivate parameters:\n" +
           ros_interface::describeNodeSettings()},
      {}, [&] { return serve(line); });
}
