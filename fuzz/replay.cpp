// Gives a fuzz target each file of a folder: what once crashed it must not do so again.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

// The name is libFuzzer's. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  std::size_t inputs = 0;
  for (int i = 1; i < argc; ++i) {
    for (const auto& file : std::filesystem::directory_iterator(argv[i])) {
      std::cout << file.path().string() << std::endl;  // before it is read: the last one named is the one that crashed
      std::ifstream in(file.path(), std::ios::binary);
      const std::vector<char> read(std::istreambuf_iterator<char>(in), {});
      const std::vector<std::uint8_t> bytes(
          read.begin(), read.end());  // not one byte more, so that a sanitizer sees what is read beyond
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
      ++inputs;
    }
  }
  std::cout << inputs << " inputs" << std::endl;
  return inputs == 0 ? 1 : 0;
}
