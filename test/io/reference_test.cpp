// The reference page in docs/ is the output of the code, and the pages of theory describe every element on it.
#include "io/reference.h"

#include "rubber_suspension/element/catalogue.h"
#include "support/files.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(ParameterReference, IsThePageInDocs) {
  EXPECT_EQ(pageInDocs("parameters"), io::parameterReference())
      << "after a change of a table: rosrun rubber_suspension reference > docs/parameters.md";
}

// A page of theory describes the law of every element that a file may name.
TEST(Theory, KnowsEveryElement) {
  const std::string pages = pageInDocs("elements") + pageInDocs("theory");
  for (const element::ElementType& type : element::elementTypes()) {
    EXPECT_NE(pages.find("`" + type.name + "`"), std::string::npos) << type.name;
  }
}

}  // namespace
}  // namespace rubber_suspension
