// Data sheets: modulus from hardness, shape factor, stiffness ratio, second loss angle, and refusals.
#include "rubber_suspension/estimation/data_sheet.h"

#include "estimation/values.h"
#include "rubber_suspension/component/component.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

const Values kBlock = {{"shore_a", 60.0},
                       {"loaded_area", 0.01},
                       {"layer_thickness", 0.02},
                       {"shape_factor", 1.25},
                       {"dynamic_to_static_ratio", 1.4},
                       {"nominal_frequency", 4.0},
                       {"relative_damping", 0.05}};

std::string refusal(std::optional<estimation::Model> model, estimation::LoadDirection direction, const Values& values) {
  return messageOf<std::invalid_argument>([&] { estimation::specificationFromDataSheet(model, direction, values); });
}

TEST(ShoreHardness, GivesGentsModulus) {
  // The formula is 0.0981 (56 + 7.62336 60)/(0.137505 (254 - 2.54 60)), evaluated by hand.
  EXPECT_NEAR(estimation::modulusFromShoreA(60.0), 50.3647e6 / 13.97051, 1e3);
  EXPECT_NEAR(estimation::modulusFromShoreA(40.0) * 1e-6, 1.70, 0.02);
  EXPECT_THROW(estimation::modulusFromShoreA(19.0), std::invalid_argument);
  EXPECT_THROW(estimation::modulusFromShoreA(90.0), std::invalid_argument);
  EXPECT_THROW(estimation::modulusFromShoreA(NAN), std::invalid_argument);
}

TEST(ShapeFactor, StiffensCompression) {
  EXPECT_DOUBLE_EQ(estimation::compressionFactor(1.0), 3.0);
  EXPECT_THROW(estimation::compressionFactor(0.1), std::invalid_argument);
  EXPECT_THROW(estimation::compressionFactor(5.0), std::invalid_argument);
}

TEST(DataSheet, StaticStiffnessFromHardness) {
  const double modulus = estimation::modulusFromShoreA(60.0);
  const auto compressed =
      estimation::specificationFromDataSheet(std::nullopt, estimation::LoadDirection::compression, kBlock);
  EXPECT_NEAR(compressed.specification.at("static_stiffness"), modulus * (1.0 + 2.0 * 1.25 * 1.25) * 0.5, 1.0);
  EXPECT_NEAR(compressed.specification.at("dynamic_stiffness") / compressed.specification.at("static_stiffness"), 1.4,
              1e-12);
  EXPECT_EQ(compressed.model, estimation::Model::maxwell);
  EXPECT_EQ(compressed.notes.size(), 2u);
  const auto sheared = estimation::specificationFromDataSheet(std::nullopt, estimation::LoadDirection::shear,
                                                              with(kBlock, "layers", 2.0));
  EXPECT_NEAR(sheared.specification.at("static_stiffness"), modulus / 3.0 * 0.25, 1.0);
}

TEST(DataSheet, SecondLossAngleGivesTheBreakFrequency) {
  const Values values = {{"static_stiffness", 3e6}, {"dynamic_to_static_ratio", 1.4}, {"nominal_frequency", 4.0},
                         {"loss_angle", 0.1},       {"second_frequency", 12.0},       {"second_loss_angle", 0.12}};
  const auto result =
      estimation::specificationFromDataSheet(std::nullopt, estimation::LoadDirection::compression, values);
  EXPECT_EQ(result.model, estimation::Model::maxwell_dashpot);
  const component::Component component(estimation::estimate(result.model, result.specification));
  EXPECT_NEAR(std::abs(component.complexStiffness(4.0).value()) / 4.2e6, 1.0, 1e-9);
  EXPECT_NEAR(std::arg(component.complexStiffness(4.0).value()), 0.1, 1e-9);
  EXPECT_NEAR(std::arg(component.complexStiffness(12.0).value()), 0.12, 1e-9);
}

TEST(DataSheet, ChoosesTheSimplestModelThatTakesAllInputs) {
  const Values base = {{"static_stiffness", 3e6}, {"dynamic_stiffness", 4.2e6}, {"nominal_frequency", 4.0}};
  const auto modelOf = [&](Values values) {
    values.insert(base.begin(), base.end());
    return estimation::specificationFromDataSheet(std::nullopt, estimation::LoadDirection::compression, values).model;
  };
  EXPECT_EQ(modelOf({{"loss_angle", 0.1}}), estimation::Model::maxwell);
  EXPECT_EQ(modelOf({{"loss_angle", 0.1}, {"break_frequency", 0.5}}), estimation::Model::maxwell_dashpot);
  EXPECT_EQ(modelOf({{"maximum_stiffness", 4.9e6}, {"high_frequency", 25.0}}), estimation::Model::multi_maxwell);
  EXPECT_EQ(modelOf({{"loss_angle", 0.1}, {"nominal_amplitude", 2e-3}}), estimation::Model::friction);
  EXPECT_EQ(modelOf({{"loss_angle", 0.1}, {"nominal_amplitude", 2e-3}, {"break_frequency", 1.45}}),
            estimation::Model::berg);
}

TEST(DataSheet, RefusesWhatIsNotWellFounded) {
  const auto compression = estimation::LoadDirection::compression;
  EXPECT_EQ(refusal(std::nullopt, compression, kBlock), "");
  EXPECT_THAT(refusal(std::nullopt, compression, without(kBlock, "dynamic_to_static_ratio")), HasSubstr("filler"));
  EXPECT_THAT(refusal(std::nullopt, compression, without(kBlock, "shape_factor")), HasSubstr("shape_factor"));
  EXPECT_THAT(refusal(std::nullopt, compression, without(kBlock, "shore_a")), HasSubstr("shore_a"));
  EXPECT_THAT(refusal(std::nullopt, compression, with(kBlock, "shore_a", 95.0)), HasSubstr("shore_a"));
  EXPECT_THAT(refusal(std::nullopt, compression, with(kBlock, "shape_factor", 8.0)), HasSubstr("compressibility"));
  EXPECT_THAT(refusal(std::nullopt, estimation::LoadDirection::shear, with(kBlock, "shape_factor", 0.5)),
              HasSubstr("bends"));
  EXPECT_THAT(refusal(std::nullopt, compression, with(kBlock, "static_stiffness", 3e6)), HasSubstr("static_stiffness"));
  EXPECT_THAT(refusal(std::nullopt, compression, with(kBlock, "dynamic_to_static_ratio", 0.7)),
              HasSubstr("dynamic_to_static_ratio"));
  EXPECT_THAT(refusal(std::nullopt, compression, without(kBlock, "relative_damping")), HasSubstr("relative_damping"));
  EXPECT_THAT(refusal(std::nullopt, compression, with(kBlock, "colour", 1.0)), HasSubstr("colour"));
  const Values second = with(with(kBlock, "second_frequency", 12.0), "second_loss_angle", 0.12);
  EXPECT_EQ(refusal(std::nullopt, compression, second), "");
  EXPECT_THAT(refusal(estimation::Model::maxwell, compression, second), HasSubstr("maxwell_dashpot"));
  EXPECT_THAT(refusal(std::nullopt, compression, with(second, "second_loss_angle", 1.2)), HasSubstr("accepted: in ("));
  EXPECT_THAT(refusal(std::nullopt, compression, with(second, "second_frequency", 4.0)), HasSubstr("second_frequency"));
  EXPECT_THAT(refusal(std::nullopt, compression, without(second, "second_frequency")), HasSubstr("second_frequency"));
}

}  // namespace
}  // namespace rubber_suspension
