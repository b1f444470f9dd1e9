// A hierarchical model of one number over the components of a type: what they share, how they scatter, who stands out.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace rubber_suspension::campaign {

/// What was estimated of one component.
struct Observation {
  double value = 0.0;
  double standard_error = 0.0;  ///< of the estimate, that is, without the scatter between components
};

/// y_j = mean + u_j + e_j, u_j ~ N(0, scatter^2) between test pieces, e_j ~ N(0, standard_error_j^2) of the estimate.
struct RandomEffects {
  double mean = 0.0;
  std::array<double, 2> mean_interval{};     ///< 95 %
  double mean_chance = 1.0;                  ///< that a mean of 0 would be found as far away, or farther
  double scatter = 0.0;                      ///< standard deviation between components
  std::array<double, 2> scatter_interval{};  ///< 95 %
  double median = 0.0;
  double robust_scatter = 0.0;   ///< of most components, whatever the others do
  std::vector<double> robust_z;  ///< of each component: its distance from the median in its own standard deviations
  double z_limit = 0.0;          ///< beyond it, one stands out: by chance in one fleet of twenty
};

/// Fewer components say nothing of their scatter.
constexpr std::size_t kFewestComponents = 5;

/// Restricted maximum likelihood for the scatter (Patterson and Thompson, Biometrika 58 (1971) 545-554), its interval
/// by the Q-profile (Viechtbauer, Statist. Med. 26 (2007) 37-52), that of the mean by Hartung and Knapp (Statist. Med.
/// 20 (2001) 3875-3889), wider by an error that all components share (its standard deviation `common_error`). Who
/// stands out is judged by median and median absolute deviation, which outliers do not move. Nothing for fewer than
/// kFewestComponents.
std::optional<RandomEffects> fitRandomEffects(const std::vector<Observation>& observations, double common_error = 0.0);

}  // namespace rubber_suspension::campaign
