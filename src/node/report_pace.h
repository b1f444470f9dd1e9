// Limits the rate of log lines about a lasting fault. Independent of ROS.
#pragma once

namespace rubber_suspension::node {

/// Lines a second apart at first; twice as far apart with each line, up to a minute; a second again after it was right
/// for two minutes. A fault that lasts for ever then writes 1440 lines a day.
class ReportPace {
 public:
  static constexpr double kShortest = 1.0;     ///< [s]
  static constexpr double kLongest = 60.0;     ///< [s]
  static constexpr double kForgotten = 120.0;  ///< [s]

  /// Notes a fault at this time [s]; true if a line is due. Times must not decrease.
  bool isDue(double now) {
    if (now - last_fault_ > kForgotten) {
      interval_ = 0.0;
    }
    last_fault_ = now;
    if (now - last_line_ < interval_) {
      return false;
    }
    last_line_ = now;
    interval_ = interval_ == 0.0 ? kShortest : (2.0 * interval_ < kLongest ? 2.0 * interval_ : kLongest);
    return true;
  }

 private:
  double last_fault_ = -1e9;
  double last_line_ = -1e9;
  double interval_ = 0.0;
};

}  // namespace rubber_suspension::node
