// The reference page in docs/ equals the output of the code, and the theory describes every element on that page.
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

// The theory describes the law of every element that a component file may contain.
TEST(Theory, KnowsEveryElement) {
  const std::string pages = pageInDocs("elements") + pageInDocs("theory");
  for (const element::ElementType& type : element::elementTypes()) {
    EXPECT_NE(pages.find("`" + type.name + "`"), std::string::npos) << type.name;
  }
}

}  // namespace
}  // namespace rubber_suspension
