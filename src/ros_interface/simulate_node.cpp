// The node `simulate`.
#include "ros_interface/simulate_node.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <malloc.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/param.h>
#include <sys/resource.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <algorithm>
#include <boost/thread/exceptions.hpp>
#include <filesystem>
#include <iterator>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>

#include "io/cancellation.h"
#include "ros_interface/master.h"
#include "ros_interface/process_fixes.h"
#include "ros_interface/termination.h"

namespace rubber_suspension::ros_interface {

namespace {

// Claims a component, given by its resolved name, for a node of this process. The claim lasts as long as the returned
// pointer exists. Throws std::invalid_argument, which names the other node, if one has already claimed the component.
std::shared_ptr<const std::string> claim(const std::string& component, const std::string& node) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<const std::string>> claims;
  const std::lock_guard<std::mutex> lock(mutex);
  if (const auto first = claims[component].lock()) {
    throw std::invalid_argument(
        fmt::format("component {} is already served by {} in the same process; accepted: another namespace or name",
                    component, *first));
  }
  auto claimed = std::make_shared<const std::string>(node);
  claims[component] = claimed;
  return claimed;
}

// Loads and starts the diagnosis. Its library is never unloaded, because its code may run until the process ends.
std::unique_ptr<LiveDiagnoser> loadLiveDiagnoser(ros::NodeHandle& handle, const node::ChannelGroup& group,
                                                 const LiveDiagnoserSettings& settings) {
  constexpr const char* kLibrary = "librubber_suspension_live.so";
  void* const library = dlopen(kLibrary, RTLD_NOW);
  void* const maker = library == nullptr ? nullptr : dlsym(library, kLiveDiagnoserMaker);
  if (maker == nullptr) {
    throw std::runtime_error(fmt::format(
        "the parameter ~diagnose is true, but the diagnosis cannot be loaded: {}; accepted: an installation with {}",
        dlerror(), kLibrary));
  }
  return std::unique_ptr<LiveDiagnoser>(
      reinterpret_cast<MakeLiveDiagnoser*>(maker)(handle, group.channels(false), settings));
}

// Logs the reason of a refusal or, if there is none, the success.
void tell(const std::string& refusal, const std::string& success) {
  if (!refusal.empty()) {
    ROS_WARN("%s", refusal.c_str());
  } else if (!success.empty()) {
    ROS_INFO("%s", success.c_str());
  }
}

// Unregisters this process in one call. If that worked or the master is gone, roscpp's own calls are skipped.
void leave(RosCommandLine& line) {
  constexpr double kMasterLimit = 0.5;  // [s]
  constexpr double kLeaveLimit = 3.0;   // [s]
  if (ros::isShuttingDown()) {
    return;  // a thread of roscpp unregisters already
  }
  const bool answers = masterAnswers(kMasterLimit);
  if (answers) {
    line.takeOffParameters();
  }
  if (!answers || leaveMaster(kLeaveLimit)) {
    giveUpMaster();
  }
}

// Raises the limit of open files for one more node. The node needs two connections for each component (displacements
// and forces), two for bundles, and some files for other purposes, such as the master and services. Throws
// std::runtime_error if the hard limit is too low.
void requireOpenFiles(std::size_t components) {
  constexpr std::size_t kBeside = 24;
  std::error_code unknown;
  const std::filesystem::directory_iterator open("/proc/self/fd", unknown);
  const std::size_t needed =
      static_cast<std::size_t>(std::distance(begin(open), end(open))) + 2 * (components + 1) + kBeside;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) {
    return;
  }
  if (limit.rlim_max < needed) {
    const std::string each = components == 0 ? "each component" : fmt::format("each of {} components", components);
    throw std::runtime_error(
        fmt::format("{} open files are needed, two for {} and {} others; accepted: ulimit -n {}, or LimitNOFILE; the "
                    "present limit is {}",
                    needed, each, needed - 2 * components, needed, limit.rlim_max));
  }
  constexpr rlim_t kTimes = 4;  // peers keep the connections of their requests open
  limit.rlim_cur = std::max(limit.rlim_cur, std::min(kTimes * needed, limit.rlim_max));
  setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace

void runSimulateNode(RosCommandLine& line) {
  // Return large blocks to the system when they are freed. By default, the allocator raises its thresholds after one
  // large message and keeps the memory.
  constexpr int kLarge = 256 * 1024;
  mallopt(M_MMAP_THRESHOLD, kLarge);
  mallopt(M_TRIM_THRESHOLD, 2 * kLarge);
  const Termination termination;
  requireOpenFiles(0);  // roscpp would wait forever if it could open no files
  if (!line.initialise("simulate", ros::init_options::NoSigintHandler)) {
    return;
  }
  // Unregister before anything is destroyed, because each object would call the master separately.
  bool left = false;
  const auto ends_and_leaves = [&] {
    if (isEnding() && !std::exchange(left, true)) {
      leave(line);
    }
    return isEnding();
  };
  try {
    SimulateNode node(ros::NodeHandle(), ros::NodeHandle("~"), ends_and_leaves);
    while (!isEnding()) {  // ros::spin() would not end on isEnding()
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    }
    node.stopRegistering();
    leave(line);
  } catch (const io::Cancelled&) {
    ROS_INFO("the node ended before it began to serve");
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("out of memory; accepted: a larger limit (ulimit -v, MemoryMax) or fewer components");
  } catch (const boost::thread_resource_error& error) {
    throw std::runtime_error(fmt::format(
        "a thread cannot be started: {}; accepted: larger limits of memory and threads (ulimit -v, ulimit -u)",
        error.what()));
  }
  ros::shutdown();  // waits for another thread that has begun the shutdown
}

SimulateNode::SimulateNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                           const std::function<bool()>& is_ending)
    : handle_(handle), private_handle_(private_handle) {
  const io::Cancellable cancellable(is_ending);
  try {
    loggers_ = takeOverLoggerService();  // before all else, because roscpp's own service can crash the process
    // The first line of log requests this parameter without a time limit and with all parameters locked. It is cached
    // now, while the master is known to answer.
    bool unused = false;
    ros::param::getCached("/rosout_disable_topics_generation", unused);
    settings_ = readNodeSettings(private_handle_);
    makeChannels();
    requireOpenFiles(channels_.size());
    if (settings_.diagnose) {
      live_ = loadLiveDiagnoser(handle_, *group_, settings_.live);
    }
    tell(keepSlaveApiToLoopback(), "");
    if (settings_.lock_memory) {
      tell(lockMemory(), "the memory is locked");
    }
    startServing();
    advertiseServices();
  } catch (const XmlRpc::XmlRpcException& error) {
    throw std::runtime_error(fmt::format("invalid reply from the ROS master: {}", error.getMessage()));
  }
}

SimulateNode::~SimulateNode() {
  registration_.reset();
  if (live_) {
    live_->stop();  // it is destroyed later, since services and diagnostics may still use it
  }
  for (auto& server : servers_) {
    server->shutdown();
  }
  for (auto& bundle : bundles_) {
    bundle->shutdown();
  }
  for (auto& thread : threads_) {
    thread->stop();
  }
}

void SimulateNode::makeChannels() {
  const std::size_t kept =
      settings_.diagnose ? static_cast<std::size_t>(settings_.live.memory) : node::GapMonitor::kCapacity;
  for (const io::ComponentDescription& description : readComponents(private_handle_, settings_)) {
    io::checkCancelled();
    claims_.push_back(claim(handle_.resolveName(description.name), private_handle_.getNamespace()));
    channels_.push_back(
        std::make_unique<node::ComponentChannel>(description, settings_.max_gap, settings_.promotion, kept));
  }
  std::vector<node::ComponentChannel*> pointers;
  for (const auto& channel : channels_) {
    pointers.push_back(channel.get());
  }
  group_ = std::make_unique<node::ChannelGroup>(pointers);
  if (settings_.load_state &&
      std::filesystem::symlink_status(settings_.state_file).type() != std::filesystem::file_type::not_found) {
    loadStates(settings_.state_file, *group_);
    ROS_INFO("continuing from the state in %s", settings_.state_file.c_str());
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
  bundles_.push_back(std::make_unique<BundleServer>(first_group, *group_, settings_.queue_size, false));
  if (!group_->channels(true).empty()) {
    bundles_.push_back(std::make_unique<BundleServer>(first_group, *group_, settings_.queue_size, true));
  }
  std::string refusal;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    refusal = threads_[i]->start(fmt::format("serving {}", i + 1), settings_.realtime_priority);
  }
  const int priority = settings_.realtime_priority;
  tell(refusal, priority > 0 ? fmt::format("serving at SCHED_FIFO priority {}", priority) : "");
}

void SimulateNode::advertiseServices() {
  diagnostics_ = std::make_unique<NodeDiagnostics>(handle_, private_handle_, settings_.gap);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    io::checkCancelled();
    diagnostics_->watch(*channels_[i], *servers_[i]);
    if (live_ && !channels_[i]->hasSixDirections()) {
      diagnostics_->watch(*live_, channels_[i]->name());
    }
  }
  for (std::size_t i = 0; i < bundles_.size(); ++i) {
    diagnostics_->watch(*bundles_[i], i == 0 ? "bundled topics" : "bundled poses");
  }
  for (const auto& thread : threads_) {
    diagnostics_->watch(*thread);
  }
  services_ = std::make_unique<NodeServices>(handle_, private_handle_, settings_, *group_, live_.get());
  registration_ = std::make_unique<RegistrationKeeper>([this] { return services_->names(); }, isEnding);
}

}  // namespace rubber_suspension::ros_interface
