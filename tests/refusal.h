// What a function says when a call breaks its contract, or its input is bad.
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
  } catch (const std::runtime_error& refused) {  // InputError is one
    return refused.what();
  }
  return "";
}

}  // namespace flexslip
