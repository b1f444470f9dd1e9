// SHA-256 agrees with the examples of its standard.
#include "io/sha256.h"

#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

// These are examples of NIST for FIPS 180-4.
TEST(Sha256, OfTheExamplesOfItsStandard) {
  EXPECT_EQ(io::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(io::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(io::sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileIsThatOfItsContent) {
  const std::string text(1000000, 'a');  // longer than the read buffer
  const TemporaryFile file("file", text);
  const io::FileHash hash = io::hashFile(file.path());
  EXPECT_EQ(hash.sha256, io::sha256(text));
  EXPECT_EQ(hash.size, text.size());
}

TEST(Sha256, OfAFileThatIsNotThereIsRefused) {
  EXPECT_THAT([] { io::hashFile("/no/such/file"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("/no/such/file: cannot be read: No such file")));
}

}  // namespace
}  // namespace rubber_suspension
