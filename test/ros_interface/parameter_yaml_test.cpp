// Parameters as YAML text preserve every bit of a number and every character of a text.
#include "ros_interface/parameter_yaml.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

using XmlRpc::XmlRpcValue;

TEST(ParameterYaml, KeepsEveryBitOfANumber) {
  for (const double value : {0.1, 1.0 / 3.0, 3.0e6, -4.9e-324, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(std::strtod(ros_interface::toYamlText(XmlRpcValue(value)).c_str(), nullptr), value);
  }
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue(6000)), "6000");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue(true)), "true");
}

TEST(ParameterYaml, TextThatIsANumberBecomesOne) {
  // PyYAML loads the parameters, and reads 3.0e6 as text because its exponent has no sign.
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("3.0e6")), "3000000.0");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("1.e6")), "1000000.0");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("-1")), "-1");
}

TEST(ParameterYaml, OtherTextIsQuoted) {
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("3 kN/mm")), "\"3 kN/mm\"");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("")), "\"\"");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("nan")), "\"nan\"");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("0x10")), "\"0x10\"");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("1e999")), "\"1e999\"");
  EXPECT_EQ(ros_interface::toYamlText(XmlRpcValue("a\"b\\c\nd")), "\"a\\\"b\\\\c\\nd\"");
}

TEST(ParameterYaml, NestsMapsAndLists) {
  XmlRpcValue value;
  value["a"]["list"][0] = 1;
  value["a"]["list"][1] = 2.5;
  value["b"] = "x: {y}";
  EXPECT_EQ(ros_interface::toYamlText(value), R"({"a":{"list":[1,2.5]},"b":"x: {y}"})");
}

TEST(ParameterYaml, RefusesWhatNoComponentFileHolds) {
  EXPECT_THROW(ros_interface::toYamlText(XmlRpcValue()), std::invalid_argument);
  char bytes[4] = {};
  EXPECT_THROW(ros_interface::toYamlText(XmlRpcValue(bytes, 4)), std::invalid_argument);
}

TEST(ParameterYaml, RefusesDeepNesting) {
  XmlRpcValue value = 1.0;
  for (int i = 0; i < 100; ++i) {
    XmlRpcValue outer;
    outer[0] = value;
    value = outer;
  }
  EXPECT_THROW(ros_interface::toYamlText(value), std::invalid_argument);
}

}  // namespace
}  // namespace rubber_suspension
