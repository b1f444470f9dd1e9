// Command lines of ROS nodes.
#include "ros_interface/command_line.h"

#include <fmt/format.h>
#include <ros/duration.h>
#include <ros/init.h>
#include <ros/network.h>
#include <ros/this_node.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"
#include "log/text.h"
#include "ros_interface/master.h"
#include "ros_interface/termination.h"

namespace rubber_suspension::ros_interface {
namespace {

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size());
  for (std::string& text : texts) {
    pointers.push_back(text.data());
  }
  return pointers;
}

// Returns the arguments of the process, or an empty list in a nodelet, where they are unknown.
std::vector<std::string>& processArguments() {
  static std::vector<std::string> arguments;
  return arguments;
}

// Returns the name of the private parameter that an argument sets, or an empty text for any other argument.
std::string privateParameterOf(const std::string& argument) {
  const std::size_t end = argument.find(":=");
  const bool is_private = end != std::string::npos && argument[0] == '_' && argument.compare(0, 2, "__") != 0;
  return is_private ? argument.substr(1, end - 1) : "";
}

// Returns the address of the master as roscpp does, but throws if it is malformed, where roscpp would end the process.
std::string masterUri(const std::vector<std::string>& arguments) {
  const std::string option = "__master:=";
  const char* const from_environment = std::getenv("ROS_MASTER_URI");
  std::string uri = from_environment == nullptr ? "" : from_environment;
  for (const std::string& argument : arguments) {
    uri = argument.compare(0, option.size(), option) == 0 ? argument.substr(option.size()) : uri;
  }
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) {
    throw std::runtime_error(fmt::format("ROS_MASTER_URI: {} is not an address; accepted: http://HOST:PORT",
                                         uri.empty() ? "not set" : log::quoted(uri)));
  }
  return uri;
}

}  // namespace

RosCommandLine::RosCommandLine(int argc, char** argv) : all_(argv, argv + argc) {
  processArguments() = all_;
  ros::removeROSArgs(argc, argv, own_);
  pointers_ = pointersTo(own_);
}

void RosCommandLine::takeOffParameters() {
  constexpr double kLimit = 0.5;  // [s]
  bool answers = std::exchange(initialised_, false);
  for (const std::string& argument : all_) {
    const std::string name = privateParameterOf(argument);
    if (answers && !name.empty()) {
      answers =
          call(kLimit, ros::master::getURI(), "deleteParam", callArguments({ros::this_node::getName() + "/" + name}))
              .has_value();
    }
  }
}

std::string originOfParameter(const std::string& name) {
  const std::vector<std::string>& arguments = processArguments();
  const auto any = [&](const auto& matches) { return std::any_of(arguments.begin(), arguments.end(), matches); };
  if (any([&](const std::string& argument) { return privateParameterOf(argument) == name; })) {
    return "the argument _" + name;
  }
  const bool launched = any([](const std::string& argument) { return argument.compare(0, 7, "__log:=") == 0; });
  return fmt::format("the private parameter ~{}{}", name,
                     launched ? " of a launch file" : ", which is set at the ROS master");
}

namespace {

void requestEnd(int /*signal*/) { ros::requestShutdown(); }

// Handles SIGTERM of service managers and SIGHUP of closed terminals, since roscpp handles only SIGINT. If SIGHUP is
// ignored, as under nohup, it remains ignored.
void endLikeAtInterrupt() {
  for (const int number : {SIGTERM, SIGHUP}) {
    if (std::signal(number, requestEnd) == SIG_IGN) {
      std::signal(number, SIG_IGN);
    }
  }
}

}  // namespace

// Waits until the master answers, a time limit passes or a signal comes. roscpp alone would wait for ever.
bool RosCommandLine::waitForMaster(double timeout) const {
  constexpr double kTurn = 1.0;      // [s]
  constexpr double kPatience = 2.0;  // time until a message is printed [s]
  const std::string uri = masterUri(all_);
  const auto begin = std::chrono::steady_clock::now();
  for (bool said = false; !isEnding();) {
    const double waited = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    element::refuseIf<std::runtime_error>(waited >= timeout, "no master answers at {} within {:g} s", uri, timeout);
    if (masterAnswers(std::min(kTurn, timeout - waited), uri)) {
      return true;
    }
    if (waited > kPatience && !std::exchange(said, true)) {
      fmt::print(stderr, "waiting for the master at {}\n", uri);
    }
    ros::WallDuration(0.05).sleep();
  }
  return false;
}

bool RosCommandLine::initialise(const std::string& node_name, std::uint32_t options, double timeout) {
  if (!waitForMaster(timeout)) {
    return false;
  }
  std::vector<char*> pointers = pointersTo(all_);
  int count = static_cast<int>(pointers.size());
  ros::init(count, pointers.data(), node_name, options);
  if ((options & ros::init_options::NoSigintHandler) == 0) {
    endLikeAtInterrupt();
  }
  initialised_ = true;
  return true;
}

}  // namespace rubber_suspension::ros_interface
