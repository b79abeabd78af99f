// The one exception of the library.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace flexslip::v1 {

// What is wrong, where, and what to do. what() holds all of it on one line. Parts that do not apply are empty.
// Every function of the library throws it for bad input, for a file that cannot be read, and where a number does not
// exist. It also lets std::bad_alloc pass.
struct Error : std::runtime_error {
  Error(const std::string& words, std::string what_is_wrong, std::string what_to_do);
  ~Error() override;

  std::string problem;   // a sentence without its full stop
  std::string remedy;    // another sentence; may be empty
  std::string key{};     // of a case file: "rig.span", also for members of Setup, Friction and Programme
  std::string file{};    // the name that the caller gave
  std::size_t line = 0;  // of the file, from 1; 0 without a line
};

}  // namespace flexslip::v1
