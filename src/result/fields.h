// Answers that describe themselves: each field has its name, kind and meaning next to the function
// that reads it. JSON, tables and docs/results.md are generated from these descriptions.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "result/field_list.h"

namespace flexslip {

// A function or member that reads a value from const Row&, or from const Row& and const Frame&. A
// missing std::optional or pointer becomes null, as does NaN.
template <class Row>
struct Getter {
  Field::Read read;
  bool may_be_missing = false, is_several = false;  // as Description has them

  template <class Get>
  Getter(Get get)  // NOLINT(google-explicit-constructor): written as a plain function
      : read(read_by(std::move(get),
                     [](const void* kept, const void* row, const Frame& frame, const Kind& as) {
                       return json_value(*static_cast<const Get*>(kept), *static_cast<const Row*>(row), frame, as);
                     })),
        may_be_missing(MayBeMissing<Given<Get, Row>>),
        is_several(SeveralWords<Given<Get, Row>>) {}
};

// The fields of a row, in the order in which they are written.
template <class Row>
class Fields {
  using Name = std::string_view;
  using Meaning = std::string_view;
  using Get = Getter<Row>;

 public:
  // Numbers in reduced variables; `own`: numbers already in the unit of the test. A quantity is
  // written with its unit.
  Fields& number(Name name, const Kind& kind, Meaning meaning, Get get) {
    return add({name, Shape::number, kind, meaning}, std::move(get), kind);
  }
  Fields& numbers(Name name, const Kind& kind, Meaning meaning, Get get) {
    return add({name, Shape::numbers, kind, meaning}, std::move(get), kind);
  }
  Fields& own(Name name, const Kind& kind, Meaning meaning, Get get) {
    return add({name, Shape::number, kind, meaning}, std::move(get));
  }
  Fields& own_numbers(Name name, const Kind& kind, Meaning meaning, Get get) {
    return add({name, Shape::numbers, kind, meaning}, std::move(get));
  }
  Fields& own_quantity(Name name, const Kind& kind, Meaning meaning, Get get) {
    list_.add(described({name, Shape::quantity, kind, meaning}, get),
              [read = std::move(get.read), kind](const void* row, const Frame& frame, const Kind& as) {
                return with_unit(read(row, frame, as), unit_of(kind, frame.reduced));
              });
    return *this;
  }
  Fields& number(Name name, Meaning meaning, Get get) { return plain(name, Shape::number, meaning, std::move(get)); }

  // Fields without a unit. `any`: numbers or words.
  Fields& count(Name name, Meaning meaning, Get get) { return plain(name, Shape::count, meaning, std::move(get)); }
  Fields& yes_no(Name name, Meaning meaning, Get get) { return plain(name, Shape::yes_no, meaning, std::move(get)); }
  Fields& words(Name name, Meaning meaning, Get get) { return plain(name, Shape::words, meaning, std::move(get)); }
  Fields& any(Name name, Meaning meaning, Get get) { return plain(name, Shape::any, meaning, std::move(get)); }
  // The row of the file that belongs to a point of the record.
  template <class GetPoint>
  Fields& row(Name name, Meaning meaning, GetPoint get) {
    return count(name, meaning, [get](const Row& row, const Frame& frame) { return frame.row(std::invoke(get, row)); });
  }
  // Words under names. `get` returns pairs of name and words.
  template <class GetPairs>
  Fields& words_by_name(Name name, Meaning meaning, GetPairs get) {
    return plain(name, Shape::words_by_name, meaning,
                 [get](const Row& row, const Frame& frame) { return object_of(call(get, row, frame)); });
  }

  // Estimates, with additional entries in `more`. estimate_in reads its unit from the row.
  Fields& estimate(Name name, const Kind& kind, Meaning meaning, Get get, const Fields& more = {}) {
    return estimated({name, Shape::estimate, kind, meaning}, std::move(get), kind, unit_in(kind), more);
  }
  Fields& own_estimate(Name name, const Kind& kind, Meaning meaning, Get get, const Fields& more = {}) {
    return estimated({name, Shape::estimate, kind, meaning}, std::move(get), kind::number, unit_in(kind), more);
  }
  Fields& estimate(const Named& what, Get get) { return estimate(what.name, what.kind, what.meaning, std::move(get)); }
  Fields& own_estimate(const Named& what, Get get, const Fields& more = {}) {
    return own_estimate(what.name, what.kind, what.meaning, std::move(get), more);
  }
  Fields& estimate_in(Name name, Meaning meaning, Get get, Get unit, const Fields& more = {}) {
    return estimated({name, Shape::estimate, kind::number, meaning}, std::move(get), kind::number, std::move(unit.read),
                     more);
  }

  // Entries below a name. list: one group per part; by_name: one per pair of name and part.
  Fields& group(Name name, Meaning meaning, const Fields& below) {
    return group(name, meaning, below, [](const Row& row) -> const Row& { return row; });
  }
  template <class Part, class GetPart>
  Fields& group(Name name, Meaning meaning, const Fields<Part>& below, GetPart get) {
    return add({.name = name,
                .shape = Shape::group,
                .kind = kind::number,
                .meaning = meaning,
                .entries = below.descriptions(),
                .may_be_missing = MayBeMissing<Given<GetPart, Row>>},
               [get, below](const Row& row, const Frame& frame) {
                 return if_there(call(get, row, frame), [&](const Part& part) { return below(part, frame); });
               });
  }
  template <class Part, class GetParts>
  Fields& list(Name name, Meaning meaning, const Fields<Part>& below, GetParts get) {
    return add({name, Shape::list, kind::number, meaning, below.descriptions()},
               [get, below](const Row& row, const Frame& frame) {
                 Json out = Json::array();
                 for (const Part& part : call(get, row, frame)) append(out, below(part, frame));
                 return out;
               });
  }
  template <class Part, class GetPairs>
  Fields& by_name(Name name, Meaning meaning, const Fields<Part>& below, GetPairs get) {
    return add({name, Shape::by_name, kind::number, meaning, below.descriptions()},
               [get, below](const Row& row, const Frame& frame) {
                 Json out = Json::object();
                 for (const auto& [key, part] : call(get, row, frame)) put(out, key, below(part, frame));
                 return out;
               });
  }
  // The fields of a part of the row, without a name of their own.
  template <class Part, class GetPart>
  Fields& all_of(const Fields<Part>& fields, GetPart get) {
    list_.add_all(fields.untyped(), MayBeMissing<Given<GetPart, Row>>,
                  [get](const void* row, const Frame& frame, const Kind& as, const Field::Read& read) {
                    return if_there(call(get, *static_cast<const Row*>(row), frame),
                                    [&](const Part& part) { return read(&part, frame, as); });
                  });
    return *this;
  }
  Fields& all_of(const Fields& fields) {
    return all_of(fields, [](const Row& row) -> const Row& { return row; });
  }

  // Fields added after only_where are null unless `holds`; anywhere() ends this.
  // left_out_where_missing() omits all missing fields instead of writing null.
  template <class Holds>
  Fields& only_where(Holds holds) {
    list_.only_where(
        [holds](const void* row) { return static_cast<bool>(std::invoke(holds, *static_cast<const Row*>(row))); });
    return *this;
  }
  Fields& anywhere() {
    list_.only_where(nullptr);
    return *this;
  }
  Fields& left_out_where_missing() {
    list_.left_out_where_missing();
    return *this;
  }
  // Uses this frame for all fields.
  Fields& in_frame(std::function<Frame(const Row&)> frame) {
    list_.in_frame([frame = std::move(frame)](const void* row) { return frame(*static_cast<const Row*>(row)); });
    return *this;
  }
  // Sets the column title of the last field.
  Fields& titled(std::string_view title) {
    list_.titled(title);
    return *this;
  }

  auto begin() const { return list_.fields().begin(); }
  auto end() const { return list_.fields().end(); }
  std::vector<Description> descriptions() const { return list_.descriptions(); }
  const FieldList& untyped() const { return list_; }

  // One field, and the whole row, as JSON.
  Json of(const Field& field, const Row& row, const Frame& frame) const { return field.of(&row, frame); }
  Json operator()(const Row& row, const Frame& frame) const { return list_(&row, frame); }

 private:
  Fields& estimated(Description what, Get get, const Kind& reduced, Field::Read unit, const Fields& more) {
    list_.add_estimate(described(std::move(what), get), std::move(get.read), reduced, std::move(unit), more.list_);
    return *this;
  }
  Fields& add(Description what, Get get, const Kind& reduced = kind::number) {
    list_.add(described(std::move(what), get), std::move(get.read), reduced);
    return *this;
  }
  static Description described(Description what, const Get& get) {
    what.may_be_missing |= get.may_be_missing;
    what.is_several = get.is_several;
    return what;
  }
  Fields& plain(Name name, Shape shape, Meaning meaning, Get get) {
    return add({name, shape, kind::number, meaning}, std::move(get));
  }

  FieldList list_;
};

}  // namespace flexslip
