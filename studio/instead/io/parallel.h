// Independent work on one thread: a page from a file has no memory that threads could share.
#pragma once

#include <cstddef>

namespace flexslip {

// As in src/io/parallel.h.
template <class Work>
void for_each_index(std::size_t count, [[maybe_unused]] unsigned threads, const Work& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

}  // namespace flexslip
