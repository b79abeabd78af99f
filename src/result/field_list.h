// The fields of an answer without the type of their row: the untyped part of Fields<Row>.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/quantity.h"
#include "result/frame.h"

namespace flexslip {

// The form of a field in an answer.

enum class Shape {
  number,
  count,
  yes_no,
  words,
  quantity,       // value and unit
  numbers,        // a list
  estimate,       // value, standard_error, interval95 and unit
  group,          // an object with entries
  list,           // a list of groups
  by_name,        // an object of groups, each under its own name
  words_by_name,  // an object of words, each under its own name
  any,            // numbers or words
};

// The description of a quantity that several answers share.
struct Named {
  std::string_view name;
  const Kind& kind;
  std::string_view meaning;
};

struct Description {
  std::string_view name;
  Shape shape;
  Kind kind;  // of numbers and estimates; otherwise kind::number
  std::string_view meaning;
  std::vector<Description> entries = {};  // of a group; of an estimate, its additional entries
  std::string_view title = {};            // of the column in tables; default: the name
  bool may_be_missing = false;            // null if missing
  bool is_several = false;                // of words: a list of them
};

// One field. `read` expects a row of the type for which it was made.
struct Field {
  using Read = std::function<Json(const void* row, const Frame& frame, const Kind& reduced)>;

  Description what;
  Read read;
  // the kind by which numbers are converted from reduced variables; kind::number: no conversion
  Kind reduced;
  bool left_out;  // omitted if missing, instead of null

  // The value, with numbers in the unit of the test.
  Json of(const void* row, const Frame& frame) const { return read(row, frame, reduced); }
};

// A read by a plain function with its stored argument. Almost every argument takes a few bytes and
// fits SmallRead. A std::function type for each would take longer to compile.
using ReadKept = Json (*)(const void* kept, const void* row, const Frame& frame, const Kind& reduced);

struct SmallRead {
  alignas(void*) std::array<std::byte, 4 * sizeof(void*)> kept;
  ReadKept function;

  Json operator()(const void* row, const Frame& frame, const Kind& reduced) const {
    return function(kept.data(), row, frame, reduced);
  }
};

template <class Kept>
Field::Read read_by(Kept kept, ReadKept function) {
  if constexpr (std::is_trivially_copyable_v<Kept> && sizeof kept <= sizeof SmallRead::kept) {
    SmallRead read{{}, function};
    std::memcpy(read.kept.data(), &kept, sizeof kept);
    return read;
  } else {
    return [kept = std::move(kept), function](const void* row, const Frame& frame, const Kind& reduced) {
      return function(&kept, row, frame, reduced);
    };
  }
}

// Returns the unit of a kind.
Field::Read unit_in(const Kind& kind);

class FieldList {
 public:
  void add(Description what, Field::Read read, const Kind& reduced = kind::number);
  void add_estimate(Description what, Field::Read read, const Kind& reduced, Field::Read unit, const FieldList& more);
  // Adds the fields of a part of the row. `part` calls the given read with that part, which may be
  // missing.
  using Through =
      std::function<Json(const void* row, const Frame& frame, const Kind& reduced, const Field::Read& read)>;
  void add_all(const FieldList& fields, bool may_be_missing, const Through& part);

  // As in Fields.
  void only_where(std::function<bool(const void* row)> holds) { only_where_ = std::move(holds); }
  void left_out_where_missing() { left_out_ = true; }
  void in_frame(std::function<Frame(const void* row)> frame) { frame_ = std::move(frame); }
  void titled(std::string_view title) { fields_.back().what.title = title; }

  const std::vector<Field>& fields() const { return fields_; }
  std::vector<Description> descriptions() const;
  Json operator()(const void* row, const Frame& outer) const;

 private:
  std::vector<Field> fields_;
  bool left_out_ = false;
  std::function<Frame(const void*)> frame_;
  std::function<bool(const void*)> only_where_;
};

}  // namespace flexslip
