#include "io/sha256.h"

#include <sstream>
#include <string>

#include <doctest/doctest.h>

using namespace flexslip;

namespace {

Digest digest(const std::string& text) {
  std::istringstream in(text);
  return digest_of(in);
}

}  // namespace

TEST_CASE("table: the examples of FIPS 180-4 and of NIST's test vectors") {
  CHECK(digest("").sha256 == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_of("abc") == digest("abc").sha256);
  CHECK(digest("abc").sha256 == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq").sha256 ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  const auto million = digest(std::string(1000000, 'a'));
  CHECK(million.sha256 == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  CHECK(million.bytes == 1000000);
}

TEST_CASE("table: lengths around the end of a block, against sha256sum of coreutils") {
  CHECK(digest(std::string(55, 'x')).sha256 == "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072");
  CHECK(digest(std::string(56, 'x')).sha256 == "04c26261370ee7541549d16dee320c723e3fd14671e66a099afe0a377c16888e");
  CHECK(digest(std::string(63, 'x')).sha256 == "75220b47218278e656f2013bb8f0c455a25eaf01e86c64924e9d48d89776d6f2");
  CHECK(digest(std::string(64, 'x')).sha256 == "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
  CHECK(digest(std::string(119, 'x')).sha256 == "000b48d4edf0fa7bee3c6236ecd2785baa5db4eeb8bb54341b029e0d9fa5fb0c");
}
