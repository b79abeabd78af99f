// SHA-256 (FIPS 180-4), which identifies the bytes that a result was computed from.
#pragma once

#include <istream>
#include <string>
#include <string_view>

namespace flexslip {

struct Digest {
  std::string sha256;   // 64 hexadecimal digits
  unsigned long bytes;  // number of bytes read
};

// The digest of the rest of a stream.
// Cost:       5 ns a byte.
Digest digest_of(std::istream& in);

// The 64 digits for bytes in memory.
std::string sha256_of(std::string_view bytes);

}  // namespace flexslip
