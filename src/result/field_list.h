// What can be read off the rows of some type: the part of Fields<Row> that does not know the type.
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

// What an answer says of one of its numbers, words or groups of them.

enum class Shape {
  number,
  count,
  yes_no,
  words,
  quantity,       // value and unit
  numbers,        // a list of numbers
  estimate,       // value, standard_error, interval95 and unit
  group,          // entries below it
  list,           // of groups
  by_name,        // groups, each under a name of its own
  words_by_name,  // words, likewise
  any,            // a number or words
};

// What several answers call alike.
struct Named {
  std::string_view name;
  const Kind& kind;
  std::string_view meaning;
};

struct Description {
  std::string_view name;
  Shape shape;
  Kind kind;  // of numbers and estimates; a plain number otherwise
  std::string_view meaning;
  std::vector<Description> entries = {};  // of groups; of an estimate what else stands beside its numbers
  std::string_view title = {};            // of a column in a table, where that is not the name
  bool may_be_missing = false;            // null then
  bool is_several = false;                // of words: a list of them
};

// One of them. All reads are of a row of the type for which they were made.
struct Field {
  using Read = std::function<Json(const void* row, const Frame& frame, const Kind& reduced)>;

  Description what;
  Read read;
  Kind reduced;   // as which its numbers are reduced; kind::number if they are not
  bool left_out;  // where it is missing, instead of null

  // With numbers in the unit of the test.
  Json of(const void* row, const Frame& frame) const { return read(row, frame, reduced); }
};

// A read by a function that is given something kept for it. What takes a few bytes, as nearly all does, is kept in one type: compilers take longer
// over a std::function of each.
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

// Reads the unit of a kind.
Field::Read unit_in(const Kind& kind);

class FieldList {
 public:
  void add(Description what, Field::Read read, const Kind& reduced = kind::number);
  void add_estimate(Description what, Field::Read read, const Kind& reduced, Field::Read unit, const FieldList& more);
  // Those of others; each read goes through `part`, which hands the row's part on, and may be missing.
  using Through =
      std::function<Json(const void* row, const Frame& frame, const Kind& reduced, const Field::Read& read)>;
  void add_all(const FieldList& fields, bool may_be_missing, const Through& part);

  // As Fields says.
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
