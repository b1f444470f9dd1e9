// The motion of a long log in little memory: what excerpts are chosen by.
#pragma once

#include <cstddef>
#include <vector>

namespace rubber_suspension::diagnosis::prepare {

/// Moments and extremes of the displacement over stretches of equal length, which grows with the log: there are never
/// more than 65,536 of them.
class MotionSurvey {
 public:
  void add(const std::vector<double>& displacement);

  std::size_t samples() const { return samples_; }

  /// Samples of a stretch, but of the last, which may have fewer.
  std::size_t stretch() const { return length_; }

  /// Standard deviation over the samples from `first` up to `last`, both on ends of stretches [m].
  double deviation(std::size_t first, std::size_t last) const;

  /// The first sample of the first stretch that holds the largest displacement, to whatever side.
  std::size_t largest() const;

  /// Samples of a cycle, by how often the displacement goes from one side of its mean to the other; not fewer than a
  /// stretch, within which two crossings are seen at most.
  double samplesPerCycle() const;

 private:
  struct Stretch {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;  // about the mean
    double low = 0.0;
    double high = 0.0;
    bool low_first = false;
  };

  static Stretch joined(const Stretch& a, const Stretch& b);
  static void extend(Stretch& stretch, double z);
  void halve();
  Stretch moments(std::size_t first, std::size_t last) const;

  std::size_t samples_ = 0;
  std::size_t length_ = 1;
  std::vector<Stretch> stretches_;
};

}  // namespace rubber_suspension::diagnosis::prepare
