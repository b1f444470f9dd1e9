// The node, put together.
#include "ros_interface/simulate_node.h"

#include <fmt/format.h>
#include <malloc.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/param.h>
#include <sys/stat.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "io/cancellation.h"
#include "ros_interface/termination.h"
#include "roscpp_fixes/logger_service.h"
#include "roscpp_fixes/loopback.h"
#include "roscpp_fixes/master_call.h"

namespace rubber_suspension::ros_interface {

namespace {

// The first line of log asks the master for this parameter, without a time limit and with all parameters locked: ask
// now, while the master is known to answer.
void prepareLog() {
  bool unused = false;
  ros::param::getCached("/rosout_disable_topics_generation", unused);
}

bool exists(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0;
}

// Who serves which component.
struct Claims {
  std::mutex mutex;
  std::map<std::string, std::string> nodes;
};

Claims& claims() {
  static Claims all;
  return all;
}

// Give large blocks back when they are freed: by itself the allocator takes one large message for a habit, and keeps
// room for the next.
void giveLargeBlocksBack() {
  constexpr int kLarge = 256 * 1024;
  mallopt(M_MMAP_THRESHOLD, kLarge);
  mallopt(M_TRIM_THRESHOLD, 2 * kLarge);
}

// Services, timers and diagnostics, until the end. ros::spin() would leave that to ROS, which ends from within.
void spinUntilEnd(SimulateNode& node) {
  while (!isEnding()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
  }
  constexpr double kMasterLimit = 0.5;  // [s]
  constexpr double kLeaveLimit = 3.0;   // [s]
  const std::vector<std::string> services = node.registerNoMore();
  if (ros::isShuttingDown()) {
    return;  // a thread of roscpp's is at it
  }
  // Where the master has heard it all, or nothing, roscpp's own words are not needed.
  if (!roscpp_fixes::masterAnswers(kMasterLimit) || roscpp_fixes::leaveMaster(kLeaveLimit, services)) {
    roscpp_fixes::giveUpMaster();
  }
}

}  // namespace

ClaimedComponents::~ClaimedComponents() {
  const std::lock_guard<std::mutex> lock(claims().mutex);
  for (const std::string& component : components_) {
    claims().nodes.erase(component);
  }
}

void ClaimedComponents::claim(const std::string& component, const std::string& node) {
  const std::lock_guard<std::mutex> lock(claims().mutex);
  const auto [claimed, is_new] = claims().nodes.emplace(component, node);
  if (!is_new) {
    throw std::invalid_argument(
        fmt::format("component {} is served by {} of the same process already; accepted: another "
                    "namespace or name",
                    component, claimed->second));
  }
  components_.push_back(component);
}

void runSimulateNode(RosCommandLine& line) {
  giveLargeBlocksBack();
  const Termination termination;
  if (!line.initialise("simulate", ros::init_options::NoSigintHandler)) {
    return;
  }
  try {
    SimulateNode node(ros::NodeHandle(), ros::NodeHandle("~"));
    spinUntilEnd(node);
  } catch (const io::Cancelled&) {
    ROS_INFO("ended before it served");
  }
  ros::shutdown();  // waits for the thread that has begun to
}

SimulateNode::SimulateNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle)
    : handle_(handle), private_handle_(private_handle) {
  try {
    start();
  } catch (const XmlRpc::XmlRpcException& error) {
    throw std::runtime_error(fmt::format("the master answers what no master should: {}", error.getMessage()));
  }
}

void SimulateNode::start() {
  const io::Cancellable cancellable(isEnding);
  loggers_ = roscpp_fixes::takeOverLoggerService();  // first, as whoever calls roscpp's own ends the process
  prepareLog();
  settings_ = readNodeSettings(private_handle_);
  makeChannels();
  keepToLoopback();
  setUpRealTime();
  startServing();
  advertiseServices();
}

std::vector<std::string> SimulateNode::registerNoMore() {
  registration_.reset();
  return services();
}

std::vector<std::string> SimulateNode::services() const {
  std::vector<std::string> names = services_->names();
  for (const std::string& name : roscpp_fixes::loggerServices()) {
    names.push_back(name);
  }
  return names;
}

SimulateNode::~SimulateNode() {
  registration_.reset();
  if (live_) {
    live_->stop();  // services and diagnostics may ask it until they end
  }
  for (auto& server : servers_) {
    server->shutdown();
  }
  bundle_->shutdown();
  for (auto& thread : threads_) {
    thread->stop();
  }
}

void SimulateNode::makeChannels() {
  const std::size_t kept =
      settings_.diagnose ? static_cast<std::size_t>(settings_.live.memory) : node::GapMonitor::kCapacity;
  for (const io::ComponentDescription& description : readComponents(private_handle_)) {
    claimed_.claim(handle_.resolveName(description.name), private_handle_.getNamespace());
    channels_.push_back(
        std::make_unique<node::ComponentChannel>(description, settings_.max_gap, settings_.promotion, kept));
  }
  std::vector<node::ComponentChannel*> pointers;
  for (const auto& channel : channels_) {
    pointers.push_back(channel.get());
  }
  group_ = std::make_unique<node::ChannelGroup>(pointers);
  if (settings_.load_state && exists(settings_.state_file)) {
    loadStates(settings_.state_file, *group_);
    ROS_INFO("going on from %s", settings_.state_file.c_str());
  }
}

void SimulateNode::keepToLoopback() {
  const std::string refusal = roscpp_fixes::keepSlaveApiToLoopback();
  if (!refusal.empty()) {
    ROS_WARN("%s", refusal.c_str());
  }
}

void SimulateNode::setUpRealTime() {
  if (settings_.lock_memory) {
    const std::string refusal = lockMemory();
    if (refusal.empty()) {
      ROS_INFO("memory locked");
    } else {
      ROS_WARN("%s", refusal.c_str());
    }
  }
}

void SimulateNode::startServing() {
  const std::size_t count = std::min<std::size_t>(static_cast<std::size_t>(settings_.threads), channels_.size());
  for (std::size_t i = 0; i < count; ++i) {
    threads_.push_back(std::make_unique<ServingThread>());
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    io::checkCancelled();
    ros::NodeHandle group(handle_);
    group.setCallbackQueue(&threads_[i % count]->queue());
    servers_.push_back(std::make_unique<SampleServer>(group, *channels_[i], settings_.queue_size));
  }
  ros::NodeHandle first_group(handle_);
  first_group.setCallbackQueue(&threads_.front()->queue());
  bundle_ = std::make_unique<BundleServer>(first_group, *group_, settings_.queue_size);
  startThreads();
}

void SimulateNode::startThreads() {
  std::string refusal;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    refusal = threads_[i]->start(fmt::format("serving {}", i + 1), settings_.realtime_priority);
  }
  if (!refusal.empty()) {
    ROS_WARN("%s; serving at normal priority", refusal.c_str());
  } else if (settings_.realtime_priority > 0) {
    ROS_INFO("serving at SCHED_FIFO priority %d", settings_.realtime_priority);
  }
}

io::ComponentDescription SimulateNode::foundModel(const std::string& component) const {
  if (!live_) {
    throw std::invalid_argument(
        fmt::format("{}: nothing to promote: neither the parameter ~promote_file nor ~diagnose is set", component));
  }
  return live_->found(component);
}

void SimulateNode::advertiseServices() {
  diagnostics_ = std::make_unique<NodeDiagnostics>(handle_, private_handle_, settings_.gap);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    diagnostics_->watch(*channels_[i], *servers_[i]);
  }
  if (settings_.diagnose) {
    live_ = loadLiveDiagnoser(handle_, group_->channels(), settings_.live);
    for (const auto& channel : channels_) {
      diagnostics_->watch(*live_, channel->name());
    }
  }
  diagnostics_->watch(*bundle_);
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    diagnostics_->watch(*threads_[i]);
  }
  services_ = std::make_unique<NodeServices>(handle_, private_handle_, settings_, *group_,
                                             [this](const std::string& component) { return foundModel(component); });
  registration_ = std::make_unique<roscpp_fixes::RegistrationKeeper>([this] { return services(); }, isEnding);
}

}  // namespace rubber_suspension::ros_interface
