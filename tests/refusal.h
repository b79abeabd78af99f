// What a function says when a call breaks its contract.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace flexslip {

// Empty if the call is not refused.
inline std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

}  // namespace flexslip
