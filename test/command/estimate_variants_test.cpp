// Further outputs of `estimate`: several models, sensitivities, CSV, and the linear part as matrices.
#include <unistd.h>

#include <Eigen/Dense>

#include "command/estimate.h"
#include "command/linear_part.h"
#include "command/measured_table.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"
#include "support/scratch_folder.h"

namespace rubber_suspension::command {
namespace {

io::ComponentDescription load(const std::string& content) {
  return componentOf("components:\n  bush:\n" + content, "file.yaml");
}

io::ComponentDescription berg() {
  return load(
      "    model: berg\n    specification: {static_stiffness: 3e6, dynamic_stiffness: 4.2e6, nominal_frequency: 4, "
      "nominal_amplitude: 2 mm, relative_damping: 5 %, break_frequency: 1.2}\n");
}

io::ComponentDescription maxwell() {
  return load(
      "    model: maxwell\n    specification: {static_stiffness: 3e6, dynamic_stiffness: 4.2e6, nominal_frequency: 4, "
      "break_frequency: 1.43}\n");
}

TEST(InModels, TakesTheNumbersThatEachModelAsksFor) {
  std::vector<std::string> notes;
  const auto models = inModels(berg(), {"M1", "M2", "maxwell_dashpot", "M4", "M5", "M6"}, notes);
  EXPECT_THAT(notes, IsEmpty());
  ASSERT_EQ(models.size(), 6u);
  EXPECT_EQ(models[0].name, "M1 kelvin_voigt");
  EXPECT_EQ(models[1].specification().at("break_frequency"), 1.2);
  EXPECT_EQ(models[5].specification().values(), berg().specification().values());
  EXPECT_THROW(inModels(berg(), {"M7"}, notes), std::invalid_argument);
}

TEST(InModels, CompletesWhatTheSpecificationLacks) {
  std::vector<std::string> notes;
  const auto five = inModels(berg(), {"5"}, notes);
  EXPECT_NEAR(std::arg(*five[0].makeComponent().complexStiffness(4.0)), std::atan(0.1), 1e-6);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("high_frequency 40 Hz")));
  const auto multi = load(
      "    model: multi_maxwell\n    specification: {static_stiffness: 3e6, dynamic_stiffness: 4.2e6, "
      "nominal_frequency: 4, nominal_amplitude: 2 mm, maximum_stiffness: 4.9e6, high_frequency: 25}\n");
  notes.clear();
  const auto models = inModels(multi, {"M1,M2", "M3", "M4", "M5", "M6,3", "5"}, notes);
  ASSERT_EQ(models.size(), 8u);
  // The loss angle of the model with five elements is stated in theory.md.
  const double angle = models[5].specification().at("loss_angle");
  EXPECT_NEAR(angle * 180.0 / element::kPi, 5.98, 5e-3);
  EXPECT_NEAR(models[5].specification().at("break_frequency"),
              4.0 * 4.2 * std::sin(angle) / (4.2 * std::cos(angle) - 3.0), 1e-9);
  EXPECT_EQ(notes.size(), 5u) << "of M1 and M3 to M6";
  EXPECT_THROW(inModels(maxwell(), {"M4"}, notes), std::invalid_argument) << "no amplitude";
}

TEST(InModels, TakesNumbersOfMaxwellElements) {
  const auto multi = load(
      "    model: multi_maxwell\n    specification: {static_stiffness: 3e6, dynamic_stiffness: 4.2e6, "
      "nominal_frequency: 4, maximum_stiffness: 4.9e6, high_frequency: 25}\n");
  std::vector<std::string> notes;
  const auto models = inModels(multi, {"1", "3", "5"}, notes);
  ASSERT_EQ(models.size(), 3u);
  EXPECT_EQ(models[0].model(), estimation::Model::maxwell);
  EXPECT_EQ(models[1].elements().size(), 4u);
  EXPECT_EQ(models[2].elements().size(), 6u);
  for (const auto& model : models) {
    EXPECT_NEAR(std::abs(*model.makeComponent().complexStiffness(4.0)), 4.2e6, 1.0);
  }
}

// At f_n, K depends on K_n only. K scales with all stiffnesses, so its elasticities add up to 1 at any frequency.
TEST(Sensitivity, OfOneMaxwellElement) {
  SweepOptions options;
  options.lowest_frequency = 0.4;
  options.highest_frequency = 40.0;
  EstimateReport report = makeEstimateReport(maxwell(), options);
  addSensitivity(report, 0.01);
  ASSERT_TRUE(report.sensitivity);
  double at_nominal[2] = {};
  double sum[3] = {};
  for (const SensitivityRow& row : report.sensitivity->rows) {
    const bool stiffness = row.input == "static_stiffness" || row.input == "dynamic_stiffness";
    for (std::size_t i = 0; i < 3 && stiffness; ++i) {
      sum[i] += row.stiffness.at(i);
    }
    if (stiffness) {
      at_nominal[row.input == "dynamic_stiffness" ? 1 : 0] = row.stiffness.at(1);  // at 4 Hz
    }
  }
  EXPECT_NEAR(at_nominal[0], 0.0, 1e-9);
  EXPECT_NEAR(at_nominal[1], 1.0, 1e-9);
  for (const double one : sum) {
    EXPECT_NEAR(one, 1.0, 1e-3);  // each input changes by 1 %
  }
  EXPECT_THAT(toText(report), HasSubstr("sensitivity to each input, changed by 1 %"));
  for (std::size_t i = 0; i < report.over_frequency.size(); ++i) {
    const double stiffness = report.over_frequency[i].characteristics.stiffness;
    EXPECT_LE(report.sensitivity->low[i].characteristics.stiffness, stiffness);
    EXPECT_GE(report.sensitivity->high[i].characteristics.stiffness, stiffness);
  }
}

// --from-table reads the table back to the last digit.
TEST(EstimateCsv, IsReadBackAsATable) {
  const EstimateReport report = makeEstimateReport(maxwell(), {});
  const std::string text = toCsv({report});
  const fit::MeasuredTable table = parseTable(text, "estimate.csv");
  ASSERT_EQ(table.points.size(), 3u * report.over_frequency.size());
  for (std::size_t i = 0; i < report.over_frequency.size(); ++i) {
    EXPECT_EQ(table.points[i].stiffness, report.over_frequency[i].characteristics.stiffness);
    EXPECT_EQ(table.points[i].loss_angle, report.over_frequency[i].characteristics.loss_angle);
  }
  EXPECT_THAT(text, HasSubstr("equivalent_damping_Ns_per_m"));
}

std::complex<double> stiffnessOf(const LinearPart& part, double frequency) {
  const std::complex<double> s(0.0, 2.0 * element::kPi * frequency);
  const Eigen::MatrixXcd resolvent =
      s * Eigen::MatrixXcd::Identity(part.a.rows(), part.a.cols()) - part.a.cast<std::complex<double>>();
  const Eigen::Vector2cd input(1.0, s);
  const Eigen::VectorXcd states = resolvent.partialPivLu().solve(part.b.cast<std::complex<double>>() * input);
  return (part.c.cast<std::complex<double>>() * states)(0) + (part.d.cast<std::complex<double>>() * input)(0);
}

// For every linear law, C (s I - A)^-1 B + D at s = i omega equals K* of the component.
TEST(LinearPartOf, HasTheComplexStiffness) {
  const auto component = load(R"(    model: elements
    elements:
      - {type: spring, stiffness: 3e6}
      - {type: dashpot, damping: 2e3}
      - {type: dashpot, damping: 1e3, order: 2}
      - {type: maxwell, stiffness: 1e6, break_frequency: 2}
      - {type: springpot, stiffness: 1e6, order: 0.3, low_frequency: 0.1, high_frequency: 50}
      - {type: creep, stiffness_per_decade: 2e5, shortest_time: 0.05, longest_time: 5}
      - {type: inertia_track, mass: 100, damping: 3e3, stiffness: 4e5}
)");
  const LinearPart part = linearPartOf(component);
  EXPECT_TRUE(part.left_out.empty());
  for (const double frequency : {0.3, 4.0, 60.0}) {
    const std::complex<double> expected = *component.makeComponent().complexStiffness(frequency);
    EXPECT_LE(std::abs(stiffnessOf(part, frequency) - expected), 1e-10 * std::abs(expected)) << frequency;
  }
}

TEST(LinearPartOf, NamesWhatItLeavesOut) {
  const LinearPart part = linearPartOf(berg());
  EXPECT_THAT(part.left_out, ElementsAre("friction"));
  EXPECT_EQ(part.a.rows(), 1);
  const auto progressive = load(
      "    model: elements\n    elements: [{type: spring, stiffness: 1e6}, {type: bump_stop, stiffness: 2e7, gap: "
      "1e-3}, {type: inertia, mass: 10}]\n");
  EXPECT_THAT(linearPartOf(progressive).tangents, ElementsAre("bump_stop"));
  EXPECT_THAT(linearPartOf(progressive).left_out, ElementsAre("inertia"));
}

TEST(WriteLinearParts, AsJsonAndAsMatlabFile) {
  const ScratchFolder folder;
  const LinearPart part = linearPartOf(maxwell());
  writeLinearParts({part}, folder.path("part.json"));
  EXPECT_THAT(folder.read("part.json"), HasSubstr("rubber_suspension/state_space/1"));
  writeLinearParts({part}, folder.path("part.mat"));
  const std::string content = folder.read("part.mat");
  // Four matrices of doubles follow the header of 128 bytes. One of the doubles is the stiffness 3e6.
  EXPECT_GT(content.size(), 128u + 4u * 48u);
  const double stiffness = part.d(0);
  EXPECT_NE(content.find(std::string(reinterpret_cast<const char*>(&stiffness), sizeof stiffness)), std::string::npos);
  EXPECT_THROW(writeLinearParts({part}, folder.path("part.txt")), std::invalid_argument);
  EXPECT_THROW(writeLinearParts({part, part}, folder.path("two.mat")), std::invalid_argument);
}

// The tables of a German laboratory have a decimal comma and German names, with tan delta or K' and K''.
TEST(MeasuredTable, ReadsGermanTables) {
  const fit::MeasuredTable factor = parseTable(
      "Frequenz [Hz];Amplitude [mm];Dynamische Steifigkeit [N/mm];tan delta\n4;0,5;3200,5;0,1\n", "labor.csv");
  ASSERT_EQ(factor.points.size(), 1u);
  EXPECT_DOUBLE_EQ(factor.points[0].amplitude, 5e-4);
  EXPECT_DOUBLE_EQ(factor.points[0].stiffness, 3.2005e6);
  EXPECT_DOUBLE_EQ(factor.points[0].loss_angle, std::atan(0.1));
  const fit::MeasuredTable parts =
      parseTable("f [Hz]\tAmplitude [mm]\tK' [kN/mm]\tK'' [kN/mm]\n4\t0,5\t3,0\t0,4\n", "labor.csv");
  EXPECT_DOUBLE_EQ(parts.points[0].stiffness, 1e6 * std::hypot(3.0, 0.4));
  EXPECT_DOUBLE_EQ(parts.points[0].loss_angle, std::atan2(0.4, 3.0));
  const fit::MeasuredTable storage = parseTable(
      "Frequenz [Hz];Amplitude [mm];Speichersteifigkeit [kN/mm];Verlustfaktor [-]\n4;0,5;3,0;0,2\n", "labor.csv");
  EXPECT_DOUBLE_EQ(storage.points[0].stiffness, 3e6 / std::cos(std::atan(0.2)));
  const fit::MeasuredTable angle =
      parseTable("f [Hz];A [mm];K* [kN/mm];Verlustwinkel [Grad]\n4;0,5;3,0;6,0\n", "labor.csv");
  EXPECT_NEAR(angle.points[0].loss_angle, 0.10471975511965977, 1e-12);
  EXPECT_THROW(parseTable("Frequenz [Hz];Amplitude [mm];K' [kN/mm]\n4;0,5;3,0\n", "labor.csv"), std::runtime_error);
}

}  // namespace
}  // namespace rubber_suspension::command
