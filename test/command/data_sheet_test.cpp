// Data sheets as files: the component file is valid, and errors state the line.
#include "command/data_sheet.h"

#include "support/files.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

const std::string kSheet = R"(data_sheet:
  component: bush
  load: compression
  shore_a: 60
  loaded_area: 100 cm^2
  layer_thickness: 20 mm
  shape_factor: 1.25
  dynamic_to_static_ratio: 1.4
  nominal_frequency: 4 Hz
  loss_angle: 5.7 deg
)";

std::string refusal(const std::string& text) {
  return messageOf<std::invalid_argument>([&] { command::componentFileFromDataSheetText(text, "sheet.yaml"); });
}

TEST(DataSheetFile, BecomesAComponentFile) {
  const std::string file = command::componentFileFromDataSheetText(kSheet, "sheet.yaml");
  EXPECT_THAT(file, HasSubstr("# static_stiffness"));
  const auto components = io::parseComponentFile(file, "written");
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components[0].name, "bush");
  EXPECT_EQ(components[0].model(), estimation::Model::maxwell);
  EXPECT_NEAR(components[0].specification().at("static_stiffness"),
              estimation::modulusFromShoreA(60.0) * estimation::compressionFactor(1.25) * 0.5, 1.0);
  EXPECT_TRUE(components[0].makeComponent().linear());
}

TEST(DataSheetFile, RefusesInOneLine) {
  const std::pair<std::string, std::string> rows[] = {
      {refusal("data_sheet: ["), "not YAML"},
      {refusal("components: {}"), "data_sheet"},
      {refusal(replaced(kSheet, "component: bush", "component: 9 lives")), "9 lives"},
      {refusal(replaced(kSheet, "  component: bush\n", "")), "component"},
      {refusal(replaced(kSheet, "load: compression", "load: torsion")), "torsion"},
      {refusal(replaced(kSheet, "  load: compression\n", "")), "load"},
      {refusal(replaced(kSheet, "shore_a: 60", "shore_a: [60]")), "one number"},
      {refusal(replaced(kSheet, "shore_a: 60", "shore: 60")), "shore: unknown key"},
      {refusal(replaced(kSheet, "20 mm", "20 s")), "layer_thickness"},
      {refusal(replaced(kSheet, "nominal_frequency: 4 Hz", "model: rubber")), "rubber"},
      {refusal(kSheet + "  shore_a: 61\n"), "twice"},
  };
  for (const auto& [message, part] : rows) {
    EXPECT_THAT(message, HasSubstr(part));
    EXPECT_THAT(message, ::testing::Not(HasSubstr("\n")));
  }
  EXPECT_THROW(command::componentFileFromDataSheet("/nowhere/sheet.yaml"), std::runtime_error);
}

}  // namespace
}  // namespace rubber_suspension
