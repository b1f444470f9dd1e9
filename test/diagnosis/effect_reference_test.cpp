// The page docs/effects.md equals what the code prints.
#include "diagnosis/report/effect_reference.h"

#include "support/files.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(EffectReference, IsThePageInDocs) {
  EXPECT_EQ(pageInDocs("effects"), diagnosis::report::effectReference())
      << "after a change of a candidate: rosrun rubber_suspension reference effects > docs/effects.md";
}

}  // namespace
}  // namespace rubber_suspension
