// Reading of measured tables.
#include "command/measured_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command/characteristic_table.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::command {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(MeasuredTable, ReadsUnitsSeparatorsAndComments) {
  const fit::MeasuredTable table = parseTable(
      "# laboratory\r\n\r\nFrequency [Hz];Amplitude [mm];Stiffness [kN/mm];Loss angle [deg];Operator\r\n"
      "4;0.5;3.2;9;AB\r\n8;0.25;3.4;-1.5;CD\r\n",
      "lab.csv");
  ASSERT_EQ(table.points.size(), 2U);
  EXPECT_DOUBLE_EQ(table.points[0].frequency, 4.0);
  EXPECT_DOUBLE_EQ(table.points[0].amplitude, 5e-4);
  EXPECT_DOUBLE_EQ(table.points[0].stiffness, 3.2e6);
  EXPECT_DOUBLE_EQ(table.points[0].loss_angle, 9.0 * element::kPi / 180.0);
  EXPECT_LT(table.points[1].loss_angle, 0.0);
  ASSERT_EQ(table.notes.size(), 1U);
  EXPECT_THAT(table.notes[0], HasSubstr("Operator"));
}

TEST(MeasuredTable, ReadsWhatExportTableWrites) {
  const component::Component component({{"spring", {{"stiffness", {3e6}}}}, {"dashpot", {{"damping", {2e4}}}}});
  const auto exported = makeTable("bush", component, {{1.0, 7.0}, {1e-3 / 3.0}});
  const fit::MeasuredTable table = parseTable(toCsv(exported), "table.csv");
  ASSERT_EQ(table.points.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(table.points[i].frequency, exported.rows[i].point.frequency);
    EXPECT_EQ(table.points[i].amplitude, exported.rows[i].point.amplitude);
    EXPECT_EQ(table.points[i].stiffness, exported.rows[i].point.characteristics.stiffness);
    EXPECT_EQ(table.points[i].loss_angle, exported.rows[i].point.characteristics.loss_angle);
  }
}

TEST(MeasuredTable, ReadsWhereAPreloadHoldsTheComponentAndTheTemperature) {
  const fit::MeasuredTable table = parseTable(
      "frequency [Hz],amplitude [mm],stiffness [N/mm],loss angle [deg],preload [kN],mean displacement [mm],"
      "temperature [K]\n2,0.1,900,5,4,-3.5,293.15\n",
      "lab.csv");
  ASSERT_EQ(table.points.size(), 1U);
  EXPECT_DOUBLE_EQ(table.points[0].mean, -3.5e-3);
  EXPECT_NEAR(table.points[0].temperature.value(), 20.0, 1e-9);  // rounding of the offset of 273.15
  EXPECT_THAT(table.notes, IsEmpty());
}

TEST(MeasuredTable, OfTemperaturesIsNotFittedToWhatShiftsWithThem) {
  const std::string columns = "frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad";
  const fit::MeasuredTable with = parseTable(columns + ",temperature_degC\n1,1e-3,3e6,0.1,20\n", "lab.csv");
  const fit::MeasuredTable without = parseTable(columns + "\n1,1e-3,3e6,0.1\n", "lab.csv");
  const io::ComponentDescription plain{"bush", {{"spring", {{"stiffness", {3e6}}}}}};
  const io::ComponentDescription shifting{"bush",
                                          {{"maxwell", {{"stiffness", {3e6}}, {"break_frequency", {1.0}}}},
                                           {"arrhenius_shift", {{"activation_energy", {5e4}}, {"reference", {20.0}}}}}};
  EXPECT_NO_THROW(requireNoShift(plain, with, "lab.csv"));
  EXPECT_NO_THROW(requireNoShift(shifting, without, "lab.csv"));
  EXPECT_THAT([&] { requireNoShift(shifting, with, "lab.csv"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("lab.csv: temperature: bush shifts")));
}

TEST(MeasuredTable, RefusesWithLineAndReason) {
  const std::string header = "frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad,preload_N\n";
  const auto refuses = [](const std::string& text, const std::string& reason) {
    EXPECT_THAT([&] { parseTable(text, "lab.csv"); }, testing::ThrowsMessage<std::runtime_error>(HasSubstr(reason)))
        << text;
  };
  refuses("", "no header");
  refuses("frequency_Hz,amplitude_m,stiffness_N_per_m\n", "lab.csv:1: loss angle: missing");
  refuses("frequency_Hz,frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad\n", "stands twice");
  refuses("frequency_m,amplitude_m,stiffness_N_per_m,loss_angle_rad\n", "frequency_m");
  refuses(header + "1,1e-3,3e6,0.1\n", "lab.csv:2: 4 fields; accepted: 5");
  refuses(header + "1,1e-3,stiff,0.1,0\n", "'stiff' is no number");
  refuses(header + "0,1e-3,3e6,0.1,0\n", "accepted: the first three");
  refuses(header + "1,1e-3,3e6,2,0\n", "90 degrees");
  refuses(header + "1,1e-3,nan,0.1,0\n", "accepted: the first three");
  refuses(header + "1,1e-3,inf,0.1,0\n", "accepted: the first three");
  refuses(header + "1,1e-3,3e6,0.1,500\n",
          "lab.csv:2: preload: 500 N; accepted: 0, or with a column 'mean displacement");
  refuses("frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad,temperature_degC\n1,1e-3,3e6,0.1,nan\n",
          "temperature");
  EXPECT_THAT(parseTable(header, "lab.csv").points, IsEmpty());
  EXPECT_THAT([] { readTable("/nowhere.csv"); }, testing::ThrowsMessage<std::runtime_error>(HasSubstr("/nowhere.csv")));
}

}  // namespace
}  // namespace rubber_suspension::command
