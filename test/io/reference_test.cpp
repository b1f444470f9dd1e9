// The reference page in docs/ is the one that the code prints.
#include "rubber_suspension/io/reference.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace rubber_suspension {
namespace {

TEST(ParameterReference, IsThePageInDocs) {
  std::ostringstream page;
  page << std::ifstream(TEST_DIR "/../docs/parameters.md").rdbuf();
  EXPECT_EQ(page.str(), parameterReference())
      << "after a change of a table: rosrun rubber_suspension reference > docs/parameters.md";
}

}  // namespace
}  // namespace rubber_suspension
