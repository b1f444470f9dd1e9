// Runs worker processes. A socket connects each of them with the supervisor and transmits jobs and results.
#include "campaign/worker_pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "element/each.h"
#include "element/refuse.h"

namespace rubber_suspension::campaign {
namespace {

// A message of a worker is one byte, a JobEnd or kException, followed by a reason.
constexpr char kException = 'e';
constexpr std::size_t kLongestMessage = 4096;  // bytes; the record of the job contains the whole error

void report(int socket, char end, const std::string& reason) {
  const std::string message = end + reason;
  send(socket, message.data(), std::min(message.size(), kLongestMessage), MSG_NOSIGNAL);
}

// Executes jobs in a worker process until the supervisor closes the connection or ends the process.
void serve(int socket, const PoolCallbacks& callbacks) {
  try {
    const auto work = callbacks.start_worker();
    for (std::size_t job = 0; recv(socket, &job, sizeof job, 0) == sizeof job;) {
      try {
        const std::string error = work(job);
        report(socket, static_cast<char>(error.empty() ? JobEnd::done : JobEnd::failed), error);
      } catch (const std::bad_alloc&) {
        report(socket, static_cast<char>(JobEnd::left), "there was not enough memory");
      }
    }
  } catch (const std::exception& error) {
    report(socket, kException, error.what());
  }
}

std::string describe(int status) {
  if (!WIFSIGNALED(status)) {
    return fmt::format("the process ended with status {}", WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  return fmt::format("the process was ended by signal {} ({}){}", signal, strsignal(signal),
                     signal == SIGKILL ? " twice: perhaps there is too little memory" : "");
}

struct Worker {
  pid_t pid;
  int socket;
  std::optional<std::size_t> job{};
  double seconds = 0.0;  // time for which the job has run [s]
};

// While a Pool exists, SIGINT, SIGTERM and SIGHUP are blocked, and run() polls for them.
class Pool {
 public:
  Pool(const std::vector<std::size_t>& jobs, const PoolCallbacks& callbacks, double longest)
      : waiting_(jobs.begin(), jobs.end()), callbacks_(callbacks), longest_(longest) {
    std::signal(SIGCHLD, SIG_DFL);  // a process that ignores SIGCHLD cannot wait for its children
    sigemptyset(&interruptions_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      sigaddset(&interruptions_, signal);
    }
    sigprocmask(SIG_BLOCK, &interruptions_, &signals_before_);
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    for (const Worker& worker : workers_) {
      kill(worker.pid, SIGTERM);
      close(worker.socket);
      waitpid(worker.pid, nullptr, 0);
    }
    sigprocmask(SIG_SETMASK, &signals_before_, nullptr);
  }

  bool run(std::size_t most_workers) {
    constexpr timespec kNow{0, 0};
    while (sigtimedwait(&interruptions_, nullptr, &kNow) <= 0) {
      while (workers_.size() < most_workers && workers_.size() < busy() + waiting_.size()) {
        start();
      }
      for (Worker& worker : workers_) {
        assign(worker);
      }
      if (busy() == 0) {
        return true;
      }
      look();
    }
    return false;
  }

 private:
  std::size_t busy() const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.job.has_value(); }));
  }

  void start() {
    std::array<int, 2> ends{};  // socket of the supervisor and socket of the worker
    const bool connected = socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0;
    const pid_t supervisor = getpid();
    std::fflush(nullptr);
    const pid_t child = connected ? fork() : -1;
    element::refuseIf<std::runtime_error>(child < 0, "a worker process cannot be started: {}", std::strerror(errno));
    if (child == 0) {
      sigprocmask(SIG_SETMASK, &signals_before_, nullptr);
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (getppid() == supervisor) {  // if false, the supervisor died before prctl()
        serve(ends[1], callbacks_);
      }
      std::fflush(nullptr);
      _exit(0);  // skips destructors and exit handlers, such as those of a test framework
    }
    close(ends[1]);  // only the worker keeps this socket open, so that its death closes the connection
    workers_.push_back({child, ends[0]});
  }

  void assign(Worker& worker) {
    if (!worker.job && !waiting_.empty()) {
      worker.job = waiting_.front();
      worker.seconds = 0.0;
      waiting_.pop_front();
      send(worker.socket, &*worker.job, sizeof *worker.job, MSG_NOSIGNAL);  // look() notices a dead worker
    }
  }

  // Waits a moment for messages, and kills workers that exceed the time limit. A killed worker is removed when it has
  // ended, which may take long if it waits for a file system.
  void look() {
    constexpr int kMoment = 100;               // [ms]
    constexpr double kMostBetweenLooks = 2.0;  // a longer time means that this process was suspended [s]
    std::vector<pollfd> sockets =
        element::each(workers_, [](const Worker& worker) { return pollfd{worker.socket, POLLIN, 0}; });
    poll(sockets.data(), sockets.size(), kMoment);
    const auto now = std::chrono::steady_clock::now();
    const double passed = std::min(std::chrono::duration<double>(now - last_look_).count(), kMostBetweenLooks);
    last_look_ = now;
    std::vector<std::size_t> running;
    for (std::size_t i = workers_.size(); i-- > 0;) {  // begins with the last one, because a dead one is erased
      Worker& worker = workers_[i];
      worker.seconds += passed;
      if (sockets[i].revents != 0) {
        hear(worker);
      } else if (worker.job) {
        running.push_back(*worker.job);
        if (isOverdue(worker)) {
          kill(worker.pid, SIGKILL);
        }
      }
    }
    callbacks_.tick(running);
  }

  bool isOverdue(const Worker& worker) const { return longest_ > 0.0 && worker.seconds > longest_; }

  void hear(Worker& worker) {
    std::array<char, kLongestMessage> message{};
    const ssize_t size = recv(worker.socket, message.data(), message.size(), 0);
    if (size <= 0) {
      bury(worker);
      return;
    }
    const std::string reason(message.data() + 1, static_cast<std::size_t>(size - 1));
    element::refuseIf<std::runtime_error>(message[0] == kException, "{}", reason);
    callbacks_.ended(std::exchange(worker.job, {}).value(), static_cast<JobEnd>(message[0]), reason);
  }

  void bury(const Worker& dead) {
    const Worker worker = dead;
    workers_.erase(workers_.begin() + (&dead - workers_.data()));
    int status = 0;
    close(worker.socket);
    waitpid(worker.pid, &status, 0);
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    const bool from_outside = signal == SIGKILL || (signal != 0 && sigismember(&interruptions_, signal) == 1);
    if (!worker.job) {
      return;
    }
    if (isOverdue(worker)) {
      // The text states the limit rather than the time taken, so that equal campaigns have equal tables.
      callbacks_.ended(*worker.job, JobEnd::died,
                       fmt::format("the job took longer than the limit of {:.6g} min and was stopped; accepted: "
                                   "`campaign run --retry-failed` with a larger --job-minutes",
                                   longest_ / 60.0));
    } else if (from_outside && killed_.insert(*worker.job).second) {
      waiting_.push_front(*worker.job);
    } else {
      callbacks_.ended(*worker.job, from_outside ? JobEnd::left : JobEnd::died, describe(status));
    }
  }

  std::deque<std::size_t> waiting_;
  const PoolCallbacks& callbacks_;
  double longest_;  // time limit [s]; 0 for no limit
  sigset_t interruptions_{};
  sigset_t signals_before_{};
  std::chrono::steady_clock::time_point last_look_ = std::chrono::steady_clock::now();
  std::vector<Worker> workers_;
  std::set<std::size_t> killed_;  // jobs whose worker was killed from outside once
};

}  // namespace

bool workOff(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest) {
  return Pool(jobs, callbacks, longest).run(static_cast<std::size_t>(workers));
}

}  // namespace rubber_suspension::campaign
