// Tests the real-time settings: they are used if permitted, or reported as missing. Samples are answered in both cases.
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "bench.h"
#include "node_process.h"
#include "ros_interface/child_process.h"

namespace rubber_suspension {
namespace {

constexpr int kPriority = 7;
constexpr const char* kNode = "/timely";

// Returns true if the system permits an operation that the node requests. A child process tries it.
bool permitted(const std::function<bool()>& attempt) {
  const pid_t child = fork();
  if (child == 0) {
    _exit(attempt() ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool mayBeTimely() {
  return permitted([] {
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    return sched_setscheduler(0, SCHED_FIFO, &parameters) == 0;
  });
}

// Returns true if the node may lock its memory, of which it maps more than an unprivileged process may lock by default.
bool mayLockMemory() {
  return permitted([] { return mlockall(MCL_CURRENT | MCL_FUTURE) == 0; });
}

// Starts the node with two serving threads as a user would, and stores its output. It ends by itself after 60 s.
class TimelyNode {
 public:
  explicit TimelyNode(const std::string& prefix) {
    const std::string command = prefix + "timeout 60 " + ros_interface::siblingProgram("simulate") +
                                " __name:=" + (kNode + 1) +
                                " _threads:=2 _lock_memory:=true _realtime_priority:=" + std::to_string(kPriority) +
                                " _config_file:=" + TEST_DIR + "/rostest/config/two_components.yaml 2>&1";
    output_ = popen(command.c_str(), "r");
  }
  ~TimelyNode() { end(); }
  TimelyNode(const TimelyNode&) = delete;
  TimelyNode& operator=(const TimelyNode&) = delete;

  // Ends the node, and makes its output and exit status available.
  void end() {
    if (output_ == nullptr) {
      return;
    }
    const pid_t process = processOf(kNode);
    if (process > 0) {
      kill(process, SIGINT);
    }
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), buffer.size(), output_) != nullptr) {
      text_ += buffer.data();
    }
    status_ = pclose(output_);
    output_ = nullptr;
  }

  bool hasSaid(const std::string& words) const { return text_.find(words) != std::string::npos; }
  const std::string& text() const { return text_; }
  int exitStatus() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

 private:
  FILE* output_ = nullptr;
  std::string text_;
  int status_ = -1;
};

// Returns the number of threads of a process that have the requested priority.
int timelyThreads(pid_t process) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
    const int thread = std::stoi(entry.path().filename());
    sched_param parameters{};
    sched_getparam(thread, &parameters);
    count += sched_getscheduler(thread) == SCHED_FIFO && parameters.sched_priority == kPriority ? 1 : 0;
  }
  return count;
}

// Returns the locked memory of a process [kB].
long lockedMemory(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  std::string word;
  long locked = -1;
  while (file >> word && word != "VmLck:") {
  }
  file >> locked;
  return locked;
}

void expectService() {
  Bench bench("left_secondary");
  ASSERT_TRUE(bench.connect());
  for (int i = 0; i < 100; ++i) {
    bench.ask(kStart + i * kMillisecond, 1e-5 * i);
  }
  EXPECT_EQ(bench.forces.size(), 100U);
}

TEST(RealTime, UsedWherePermittedAndSaidSo) {
  const bool timely = mayBeTimely();
  const bool locks = mayLockMemory();
  TimelyNode node("");
  expectService();
  const pid_t process = processOf(kNode);
  ASSERT_GT(process, 0);
  // The other threads have normal priority, so that the serving threads do not prevent the system from stopping them.
  EXPECT_EQ(timelyThreads(process), timely ? 2 : 0);
  EXPECT_EQ(lockedMemory(process) > 0, locks);
  node.end();
  EXPECT_EQ(node.hasSaid("the memory is locked"), locks) << node.text();
  EXPECT_EQ(node.hasSaid("serving at SCHED_FIFO priority 7"), timely) << node.text();
  EXPECT_EQ(node.exitStatus(), 0);
}

// The node lacks the capabilities and limits for real time, even if root runs this test.
TEST(RealTime, SaysSoWhereNotPermittedAndServes) {
  std::string prefix = "prlimit --rtprio=0:0 --memlock=65536:65536 ";
  if (geteuid() == 0) {
    prefix += "setpriv --bounding-set=-sys_nice,-ipc_lock --inh-caps=-sys_nice,-ipc_lock ";
  }
  TimelyNode node(prefix);
  expectService();
  const pid_t process = processOf(kNode);
  ASSERT_GT(process, 0);
  EXPECT_EQ(timelyThreads(process), 0);
  EXPECT_EQ(lockedMemory(process), 0);
  node.end();
  EXPECT_TRUE(node.hasSaid("the memory cannot be locked")) << node.text();
  EXPECT_TRUE(node.hasSaid("serves at normal priority")) << node.text();
  EXPECT_EQ(node.exitStatus(), 0);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "real_time"); }
