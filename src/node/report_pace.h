// Limits the rate of log lines about a lasting fault. Independent of ROS.
#pragma once

namespace rubber_suspension::node {

/// Permits lines 1 s apart at first, and doubles the interval with each line up to 60 s. After 120 s without a fault,
/// the interval is 1 s again. So a permanent fault causes about 1440 lines per day.
class ReportPace {
 public:
  static constexpr double kShortest = 1.0;     ///< [s]
  static constexpr double kLongest = 60.0;     ///< [s]
  static constexpr double kForgotten = 120.0;  ///< [s]

  /// Records a fault at a time [s] and returns true if a line is due. Times must not decrease.
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
