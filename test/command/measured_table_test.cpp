// Reading measured tables.
#include "command/measured_table.h"

#include <zlib.h>

#include "command/characteristic_table.h"
#include "command/table_fit_text.h"
#include "rubber_suspension/element/constants.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension::command {
namespace {

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

// All tables have one point of 2 Hz, 0.5 mm, 3 kN/mm and 0.1 rad, as many laboratories write it.
TEST(MeasuredTable, ReadsTheQuantitiesThatLaboratoriesWrite) {
  const double storage = 3000.0 * std::cos(0.1);
  const double loss = 3000.0 * std::sin(0.1);
  const auto row = [](auto... values) { return fmt::format("{}\n", fmt::join(std::vector<double>{values...}, ";")); };
  const std::vector<std::string> tables = {
      "Freq (Hz);Disp Amp (mm);Dynamic Stiffness (N/mm);Phase (rad)\n" + row(2.0, 0.5, 3000.0, 0.1),
      "omega [rad/s];amplitude [mm];stiffness [N/mm];tan delta\n" + row(4.0 * element::kPi, 0.5, 3000.0, std::tan(0.1)),
      "Frequenz [Hz];Doppelamplitude [mm];Steifigkeit [N/mm];Verlustwinkel [\u00b0]\n" +
          row(2.0, 1.0, 3000.0, 18.0 / element::kPi),
      "Frequency [Hz];Peak to peak [mm];K' [N/mm];K'' [N/mm]\n" + row(2.0, 1.0, storage, loss),
      "Frequency [Hz];Amplitude [mm];Stiffness [N/mm];Damping [N s/mm]\n" +
          row(2.0, 0.5, storage, loss / (4.0 * element::kPi)),
      "Frequency [Hz];Amplitude [mm];K' [N/mm];loss angle [mrad]\n" + row(2.0, 0.5, storage, 100.0),
      "Freq (Hz);Dyn Amp (mm p-p);Mean Load (N);K* (N/mm);Tan Delta;Damping C (N-s/mm)\n" +
          row(2.0, 1.0, 0.0, 3000.0, std::tan(0.1), loss / (4.0 * element::kPi)),
      "Frequency [Hz];Amplitude RMS [mm];Stiffness [N/mm];Loss angle [rad]\n" +
          row(2.0, 0.5 / std::sqrt(2.0), 3000.0, 0.1),
      "Frequency [Hz];Amplitude (\u00b1mm);Stiffness [N/mm];Loss angle [rad]\n" + row(2.0, 0.5, 3000.0, 0.1),
      "Frequency [Hz];Amplitude [mm];Stiffness level [dB re 1 N/m];Loss factor [-]\n" +
          row(2.0, 0.5, 20.0 * std::log10(3e6), std::tan(0.1)),
      "Frequency;Amplitude;Stiffness;Loss angle\nHz;mm;N/mm;rad\n" + row(2.0, 0.5, 3000.0, 0.1),
      "Material: NR 60 ShA\nTemp: 23 C\n\nFreq;Amp pp;C*;C';C\";Verlustwinkel \u03b4;tan \u03b4\n"
      "[Hz];[mm];[N/mm];[N/mm];[N/mm];[\u00b0];[-]\n" +
          row(2.0, 1.0, 3000.0, storage, loss, 18.0 / element::kPi, std::tan(0.1)),
      "Frequenz [Hz];Amplitude [mm];dyn. Steifigkeit [N/mm];Verlustwinkel [rad]\n" + row(2.0, 0.5, 3000.0, 0.1),
      "Frequency [Hz];Amplitude [mm];Stiffness K [N/mm];Damping C [Ns/mm]\n" +
          row(2.0, 0.5, storage, loss / (4.0 * element::kPi)),
      "Frequency [Hz];Amplitude [mm];Stiffness K [N/mm];Damping C [kNs/m]\n" +
          row(2.0, 0.5, storage, loss / (4.0 * element::kPi)),
      "Frequency [Hz];Amplitude [mm];Stiffness K [N/mm];Damping C [Ns/m];\n" +
          fmt::format("2;0.5;{};{};\n", storage, 1000.0 * loss / (4.0 * element::kPi))};
  for (const std::string& text : tables) {
    SCOPED_TRACE(text);
    const fit::MeasuredTable table = parseTable(text, "lab.csv");
    ASSERT_EQ(table.points.size(), 1U);
    EXPECT_NEAR(table.points[0].frequency, 2.0, 1e-12);
    EXPECT_NEAR(table.points[0].amplitude, 5e-4, 1e-15);
    EXPECT_NEAR(table.points[0].stiffness, 3e6, 1e-5);
    EXPECT_NEAR(table.points[0].loss_angle, 0.1, 1e-12);
  }
  const fit::MeasuredTable comma =
      parseTable("frequency [Hz];amplitude [mm];stiffness [N/mm];loss angle [deg]\n0,5;0,1;1.352,75;3,79\n", "lab.csv");
  EXPECT_DOUBLE_EQ(comma.points.at(0).stiffness, 1352.75e3);
}

// A table is refused before the fit if no component can have its values, or if this one has them in another unit.
TEST(MeasuredTable, IsHeldAgainstTheComponent) {
  const io::ComponentDescription bush{"bush",
                                      {{"spring", {{"stiffness", {1.2e6}}}}, {"dashpot", {{"damping", {2e4}}}}}};
  const auto tableOf = [](double stiffness, double angle) {
    return parseTable(fmt::format("frequency [Hz],amplitude [mm],stiffness [N/m],loss angle [deg]\n1,0.1,{0},{1}\n"
                                  "5,0.1,{0},{1}\n",
                                  stiffness, angle),
                      "lab.csv");
  };
  const auto refusal = [&](const fit::MeasuredTable& table) {
    return messageOf<std::runtime_error>([&] { checkBenchOfTable(bush, table, "lab.csv"); });
  };
  EXPECT_THAT(checkBenchOfTable(bush, tableOf(1.3e6, 9.0), "lab.csv"), IsEmpty());
  EXPECT_THAT(refusal(tableOf(1.3e6, -9.0)), HasSubstr("lab.csv: all loss angles are negative"));
  fit::MeasuredTable small = tableOf(1.3e3, 9.0);
  EXPECT_THAT(refusal(small), HasSubstr("close to the factor 0.001 of a wrong unit (N and kN, or mm and m)"));
  small.accept_units = true;
  EXPECT_THAT(checkBenchOfTable(bush, small, "lab.csv"), IsEmpty());
  EXPECT_THAT(checkBenchOfTable(bush, tableOf(1.2e7, 9.0), "lab.csv"), testing::SizeIs(1));
}

TEST(MeasuredTable, NamesWhatAMaterialLacks) {
  EXPECT_THAT([] { parseTable("Frequency [Hz],Strain [%],E* [MPa],delta [deg]\n1,0.1,3.5,4\n", "lab.csv"); },
              testing::ThrowsMessage<std::runtime_error>(testing::AllOf(
                  HasSubstr("'Strain [%]', 'E* [MPa]': a quantity of the material"), HasSubstr("shape"))));
}

TEST(MeasuredTable, NamesColumnsThatItDoesNotUnderstand) {
  const auto refusal = [](const std::string& text) {
    return messageOf<std::runtime_error>([&] { parseTable(text, "lab.csv"); });
  };
  EXPECT_THAT(refusal("Frequency [Hz],Way [mm],Stiffness [N/mm],Phase [deg]\n1,0.1,200,1\n"),
              testing::AllOf(HasSubstr("amplitude: missing"), HasSubstr("not understood: 'Way [mm]'")));
  EXPECT_THAT(refusal("Frequency [Hz],Amplitude [mm],Stiffness [foo],Phase [deg]\n1,0.1,200,1\n"),
              HasSubstr("column 'Stiffness [foo]': unit 'foo' is unknown"));
  EXPECT_THAT(refusal("Dynamic stiffness [N/mm];0,1 mm;0,5 mm\n1 Hz;200;200\n"),
              HasSubstr("a matrix, which lacks the loss angle"));
}

TEST(MeasuredTable, IsReadWhateverHoldsItsText) {
  const std::string text = "Frequency [Hz];Amplitude [mm];Stiffness [N/mm];Phase [deg]\n1;0,1;200,5;1,5\n";
  const TemporaryFile plain("lab.csv", text);
  const TemporaryFile zipped("lab.csv.gz", "");
  gzFile file = gzopen(zipped.path().c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  for (const std::string& path : {plain.path(), zipped.path()}) {
    EXPECT_DOUBLE_EQ(readTable(path).points.at(0).stiffness, 200500.0);
    EXPECT_EQ(readTable(path).name, "lab");
  }
  const TemporaryFile array("lab.npy", "\x93NUMPY");
  EXPECT_THAT([&] { readTable(array.path()); },
              ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("a NumPy array: this format cannot be read"),
                                                      HasSubstr("'time_s,displacement_UNIT,force_UNIT'"),
                                                      HasSubstr("UNIT stands for the units of the array"))));
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
  EXPECT_NEAR(table.points[0].temperature.value(), 20.0, 1e-9);  // the offset of 273.15 is rounded
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
              testing::ThrowsMessage<std::runtime_error>(
                  HasSubstr("lab.csv: column temperature: bush has an element that shifts with temperature")));
}

TEST(MeasuredTable, RefusesWithLineAndReason) {
  const std::string header = "frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad,preload_N\n";
  const auto refuses = [](const std::string& text, const std::string& reason) {
    EXPECT_THAT([&] { parseTable(text, "lab.csv"); }, testing::ThrowsMessage<std::runtime_error>(HasSubstr(reason)))
        << text;
  };
  refuses("", "no header");
  refuses("frequency_Hz,amplitude_m,stiffness_N_per_m\n", "lab.csv:1: loss angle: missing");
  refuses("frequency_Hz,frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad\n", "given in two columns");
  refuses("frequency_m,amplitude_m,stiffness_N_per_m,loss_angle_rad\n", "frequency_m");
  refuses(header + "1,1e-3,3e6,0.1\n", "lab.csv:2: 4 fields; accepted: 5");
  refuses(header + "1,1e-3,stiff,0.1,0\n", "'stiff' is no number");
  refuses("Frequency,Amplitude,Stiffness [N/m],Loss angle\nHz,mm,kN/m,deg\n1,1,1,1\n",
          "column 'Stiffness [N/m]': the row of units has 'kN/m'");
  refuses(header + "0,1e-3,3e6,0.1,0\n", "accepted: the first three");
  refuses(header + "1,1e-3,3e6,2,0\n", "90 degrees");
  refuses(header + "1,1e-3,nan,0.1,0\n", "accepted: the first three");
  refuses(header + "1,1e-3,inf,0.1,0\n", "accepted: the first three");
  refuses(header + "1,1e-3,3e6,0.1,500\n",
          "lab.csv:2: preload: 500 N; accepted: 0, or a table with a column 'mean displacement");
  refuses("frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad,temperature_degC\n1,1e-3,3e6,0.1,nan\n",
          "temperature");
  EXPECT_THAT(parseTable(header, "lab.csv").points, IsEmpty());
  EXPECT_THAT([] { readTable("/nowhere.csv"); }, testing::ThrowsMessage<std::runtime_error>(HasSubstr("/nowhere.csv")));
}

}  // namespace
}  // namespace rubber_suspension::command
