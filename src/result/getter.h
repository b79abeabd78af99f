// What stands where a field of an answer is described: how its value is read off a row.
#pragma once

#include "result/field_list.h"

namespace flexslip {

// How something is read off a row: a function or member of const Row&, or a function of that and const Frame&. What it gives as
// std::optional or pointer may be missing: it is null then, as NaN is.
template <class Row>
struct Getter {
  Field::Read read;
  bool may_be_missing = false, is_several = false;  // as Description has them

  template <class Get>
  Getter(Get get)  // NOLINT(google-explicit-constructor): it stands where a function is written
      : read([get](const void* row, const Frame& frame, const Kind& as) {
          return read_off(get, *static_cast<const Row*>(row), frame, as);
        }),
        may_be_missing(MayBeMissing<Given<Get, Row>>),
        is_several(SeveralWords<Given<Get, Row>>) {}
};

}  // namespace flexslip
