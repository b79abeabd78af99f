// What an answer says of one of its numbers, words or groups of them.
#pragma once

#include <string_view>
#include <vector>

#include "io/quantity.h"

namespace flexslip {

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

}  // namespace flexslip
