// What libc++ 13, with which Emscripten comes, has not yet of <memory>.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

#ifndef __cpp_lib_smart_ptr_for_overwrite
namespace std {  // NOLINT(cert-dcl58-cpp): the name that its next edition gives it
template <class Array>
unique_ptr<Array> make_unique_for_overwrite(size_t n) {
  return unique_ptr<Array>(new remove_extent_t<Array>[n]);
}
}  // namespace std
#endif
