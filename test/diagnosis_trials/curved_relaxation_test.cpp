// Ramps and holds of nonlinear relaxation, and of linear relaxation beside a cubic spring.
#include "diagnosis/checked_diagnosis.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

constexpr double kFilmReach = 2e-3;  // [m]
constexpr double kFilmSpring = 1e6;  // [N/m]
constexpr double kFilmNoise = 1.5;   // standard deviation, about 0.4 % of the force [N]

using Slope = std::function<double(double)>;  // stiffness as a function of displacement divided by the reach [N/m]

struct Film {
  double cubic = 0.0;  // force of the cubic spring at the reach [N]
  Slope relaxing;      // stiffness of the branch of 4 s, twice that of the branch of 0.8 s [N/m]
};

Film linearBesideCubic() {
  return {1200.0, [](double) { return 4e5; }};
}

// This law has another form than the candidate's element.
Film alongCurve() {
  return {0.0, [](double x) { return 1.5e5 * (1.0 + 4.0 * x * x); }};
}

// Records ramps of 2 s to each level, each with a hold of 18 s, every 0.05 s. The branches take 20 steps per sample.
log::Log runFilm(const Film& film, const std::string& name, unsigned seed, const std::vector<double>& levels) {
  constexpr double kStep = 0.05;
  constexpr int kRamp = 40;
  constexpr int kOfLevel = 400;
  constexpr int kFiner = 20;
  log::Log log;
  log.name = name;
  double slow = 0.0;
  double fast = 0.0;
  double z = 0.0;
  double from = 0.0;
  for (std::size_t i = 0; i < levels.size() * kOfLevel; ++i) {
    const double level = levels[i / kOfLevel] * kFilmReach;
    const auto within = static_cast<double>(i % kOfLevel + 1);
    const double next = from + (level - from) * std::min(1.0, within / kRamp);
    from = i % kOfLevel + 1 == kOfLevel ? level : from;
    for (int j = 0; j < kFiner; ++j) {
      const double stiffness = film.relaxing((z + (next - z) * (j + 0.5) / kFiner) / kFilmReach);
      slow = slow * std::exp(-kStep / kFiner / 4.0) + stiffness * (next - z) / kFiner;
      fast = fast * std::exp(-kStep / kFiner / 0.8) + 0.5 * stiffness * (next - z) / kFiner;
    }
    z = next;
    log.stamp.push_back(static_cast<std::int64_t>(i) * std::llround(kStep * 1e9));
    log.displacement.push_back(z);
    log.force.push_back(kFilmSpring * z + film.cubic * std::pow(z / kFilmReach, 3) + slow + fast);
  }
  addNoise(log.force, kFilmNoise, seed);
  return log;
}

diagnosis::Diagnosis diagnoseFilm(const Film& film, double lesser) {
  return checkedDiagnosis({"film", {spring(kFilmSpring)}},
                          {runFilm(film, "one", 1, {lesser, 0.0, -lesser, 1.0, 0.0, -1.0, 0.25 * lesser, 0.0}),
                           runFilm(film, "two", 2, {1.0, lesser, -1.0, 0.0, -lesser, lesser, 0.0})},
                          {});
}

bool hasTypeAdded(const io::ComponentDescription& component, const std::string& type) {
  return std::any_of(component.add.begin(), component.add.end(),
                     [&](const element::ElementDescription& entry) { return entry.type == type; });
}

TEST(CurvedRelaxation, IsRelaxationWhereHoldsAtTwoAmplitudesShowIt) {
  const diagnosis::Diagnosis found = diagnoseFilm(alongCurve(), 0.5);
  EXPECT_EQ(found.answer.effects, std::vector<std::string>{"relaxation"}) << found.sentence;
  EXPECT_TRUE(hasTypeAdded(found.law.augmented, "maxwell_along_curve")) << io::toYaml({found.law.augmented});
}

TEST(CurvedRelaxation, StaysLinearBesideACubicSpring) {
  const diagnosis::Diagnosis found = diagnoseFilm(linearBesideCubic(), 0.5);
  EXPECT_THAT(found.answer.effects, testing::UnorderedElementsAre("progressive_stiffness", "relaxation"))
      << found.sentence;
  EXPECT_FALSE(hasTypeAdded(found.law.full, "maxwell_along_curve")) << io::toYaml({found.law.full});
}

}  // namespace
}  // namespace rubber_suspension
