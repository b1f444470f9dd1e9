// The reference page in docs/ is the one that the code prints.
#include "rubber_suspension/io/reference.h"

#include <gtest/gtest.h>

#include "support/reference_page.h"

namespace rubber_suspension {
namespace {

TEST(ParameterReference, IsThePageInDocs) {
  EXPECT_EQ(pageInDocs("parameters"), parameterReference())
      << "after a change of a table: rosrun rubber_suspension reference > docs/parameters.md";
}

}  // namespace
}  // namespace rubber_suspension
