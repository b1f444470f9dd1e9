// Long work shows its progress only if stderr is a terminal.
#include "io/progress.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>

#include "support/test.h"

namespace rubber_suspension {
namespace {

using testing::EndsWith;

void putInPlaceOfStderr(int descriptor) {
  std::fflush(stderr);
  dup2(descriptor, STDERR_FILENO);
}

// Returns what the work writes to stderr if stderr is a terminal.
std::string shownOnTerminal(const std::function<void()>& work) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) {
    return "no terminal";
  }
  const int screen = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  const int before = dup(STDERR_FILENO);
  putInPlaceOfStderr(screen);
  work();
  putInPlaceOfStderr(before);
  close(before);
  close(screen);  // after the last descriptor is closed, read() returns all output before it fails
  std::string shown;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(terminal, buffer.data(), buffer.size())) > 0;) {
    shown.append(buffer.data(), static_cast<std::size_t>(count));
  }
  close(terminal);
  return shown;
}

TEST(Activity, IsShownFromTheSecondSecondOnAndRemoved) {
  const std::string shown = shownOnTerminal([] {
    const io::Activity activity("reading a.csv");
    std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  });
  EXPECT_THAT(shown, HasSubstr("reading a.csv, 1 s"));
  EXPECT_THAT(shown, EndsWith("\r\x1b[K"));
}

TEST(Activity, SaysNothingOfWorkThatIsShort) {
  EXPECT_EQ(shownOnTerminal([] { const io::Activity activity("reading a.csv"); }), "");
}

TEST(Activity, SaysNothingToAFile) {
  testing::internal::CaptureStderr();
  {
    const io::Activity activity("reading a.csv");
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Progress, ShowsHowMuchIsDone) {
  EXPECT_THAT(shownOnTerminal([] {
                io::Progress progress("simulating", 4);
                progress.advance(2);
              }),
              HasSubstr("simulating  50 % [===================="));
}

}  // namespace
}  // namespace rubber_suspension
