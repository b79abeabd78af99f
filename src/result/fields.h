// Answers that describe themselves: each number, word or group of them has its name, its quantity and its meaning where it is read off.
//
// JSON, tables and the page docs/results.md are made of these descriptions; nothing is named twice.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "result/description.h"
#include "result/frame.h"
#include "result/read_off.h"

namespace flexslip {

// What can be read off a row, in the order in which it is written. All getters take const Row&, and const Frame& after it if they like. What
// they give as std::optional or pointer may be missing: it is null then, as NaN is.
template <class Row>
class Fields {
 public:
  using Read = std::function<Json(const Row&, const Frame&)>;
  struct Field {
    Description what;
    Read of;        // numbers in the unit of the test
    bool left_out;  // where it is missing, instead of null
  };

  // Numbers in the library's reduced variables, and ("own") in the unit of the test already.
  template <class Get>
  Fields& number(std::string_view name, const Kind& kind, std::string_view meaning, Get get) {
    return leaf({name, Shape::number, kind, meaning}, get, true);
  }
  template <class Get>
  Fields& own(std::string_view name, const Kind& kind, std::string_view meaning, Get get) {
    return leaf({name, Shape::number, kind, meaning}, get);
  }
  template <class Get>
  Fields& number(std::string_view name, std::string_view meaning, Get get) {
    return own(name, kind::number, meaning, get);
  }
  template <class Get>
  Fields& numbers(std::string_view name, const Kind& kind, std::string_view meaning, Get get) {
    return leaf({name, Shape::numbers, kind, meaning}, get, true);
  }
  template <class Get>
  Fields& own_numbers(std::string_view name, const Kind& kind, std::string_view meaning, Get get) {
    return leaf({name, Shape::numbers, kind, meaning}, get);
  }

  // The same with its unit beside it.
  template <class Get>
  Fields& own_quantity(std::string_view name, const Kind& kind, std::string_view meaning, Get get) {
    return add({name, Shape::quantity, kind, meaning}, [get, kind](const Row& row, const Frame& frame) {
      const Json value = read_off(get, row, frame);
      return value.is_null() ? value : Json{{"value", value}, {"unit", unit_of(kind, frame.reduced)}};
    });
  }

  template <class Get>
  Fields& count(std::string_view name, std::string_view meaning, Get get) {
    return leaf({name, Shape::count, kind::number, meaning}, get);
  }
  // Row of the file of a point of the record.
  template <class Get>
  Fields& row(std::string_view name, std::string_view meaning, Get get) {
    return count(name, meaning, [get](const Row& row, const Frame& frame) { return frame.row(std::invoke(get, row)); });
  }
  template <class Get>
  Fields& yes_no(std::string_view name, std::string_view meaning, Get get) {
    return leaf({name, Shape::yes_no, kind::number, meaning}, get);
  }
  template <class Get>
  Fields& words(std::string_view name, std::string_view meaning, Get get) {
    return leaf({name, Shape::words, kind::number, meaning}, get);
  }
  // Words, each under its name: pairs of both.
  template <class Get>
  Fields& words_by_name(std::string_view name, std::string_view meaning, Get get) {
    return add({name, Shape::words_by_name, kind::number, meaning}, [get](const Row& row, const Frame& frame) {
      Json out = Json::object();
      for (const auto& [key, words] : call(get, row, frame)) out[key] = words;
      return out;
    });
  }
  // Numbers or words, as they come.
  template <class Get>
  Fields& any(std::string_view name, std::string_view meaning, Get get) {
    return leaf({name, Shape::any, kind::number, meaning}, get);
  }

  // Estimates, likewise; beside their numbers, more.
  template <class Get>
  Fields& estimate(std::string_view name, const Kind& kind, std::string_view meaning, Get get,
                   const Fields& more = {}) {
    return estimate_with({name, Shape::estimate, kind, meaning}, get, true, unit_in(kind), more);
  }
  template <class Get>
  Fields& own_estimate(std::string_view name, const Kind& kind, std::string_view meaning, Get get,
                       const Fields& more = {}) {
    return estimate_with({name, Shape::estimate, kind, meaning}, get, false, unit_in(kind), more);
  }
  // One whose unit is that of the row.
  template <class Get, class GetUnit>
  Fields& estimate_in(std::string_view name, std::string_view meaning, Get get, GetUnit unit, const Fields& more = {}) {
    return estimate_with({name, Shape::estimate, kind::number, meaning}, get, false, unit, more);
  }

  // Entries below a name; read off the same row, or off a part of it.
  Fields& group(std::string_view name, std::string_view meaning, const Fields& below) {
    return group(name, meaning, below, [](const Row& row) { return &row; });
  }
  template <class Part, class Get>
  Fields& group(std::string_view name, std::string_view meaning, const Fields<Part>& below, Get get) {
    return add({name, Shape::group, kind::number, meaning, below.descriptions()},
               [get, below](const Row& row, const Frame& frame) {
                 return if_there(call(get, row, frame), [&](const Part& part) { return below(part, frame); });
               });
  }
  // One group after the other; each under its name, of pairs of name and part.
  template <class Part, class Get>
  Fields& list(std::string_view name, std::string_view meaning, const Fields<Part>& below, Get get) {
    return add({name, Shape::list, kind::number, meaning, below.descriptions()},
               [get, below](const Row& row, const Frame& frame) {
                 Json out = Json::array();
                 for (const Part& part : call(get, row, frame)) out.push_back(below(part, frame));
                 return out;
               });
  }
  template <class Part, class Get>
  Fields& by_name(std::string_view name, std::string_view meaning, const Fields<Part>& below, Get get) {
    return add({name, Shape::by_name, kind::number, meaning, below.descriptions()},
               [get, below](const Row& row, const Frame& frame) {
                 Json out = Json::object();
                 for (const auto& [key, part] : call(get, row, frame)) out[key] = below(part, frame);
                 return out;
               });
  }
  // Those of a part of the row, among its own.
  template <class Part, class Get>
  Fields& all_of(const Fields<Part>& fields, Get get) {
    for (const auto& field : fields)
      add(field.what, [get, of = field.of](const Row& row, const Frame& frame) {
        return if_there(call(get, row, frame), [&](const Part& part) { return of(part, frame); });
      });
    return *this;
  }
  Fields& all_of(const Fields& fields) {
    return all_of(fields, [](const Row& row) { return &row; });
  }

  // Those added after it are there only where this holds, and null otherwise; anywhere; left out where they are missing.
  template <class Holds>
  Fields& only_where(Holds holds) {
    only_where_ = [holds](const Row& row) { return static_cast<bool>(std::invoke(holds, row)); };
    return *this;
  }
  Fields& anywhere() {
    only_where_ = nullptr;
    return *this;
  }
  Fields& left_out_where_missing() {
    left_out_ = true;
    return *this;
  }
  // All of them in a frame of their own.
  Fields& in_frame(std::function<Frame(const Row&)> frame) {
    frame_ = std::move(frame);
    return *this;
  }
  // The last in a table has this title.
  Fields& titled(std::string_view title) {
    fields_.back().what.title = title;
    return *this;
  }

  auto begin() const { return fields_.begin(); }
  auto end() const { return fields_.end(); }
  std::vector<Description> descriptions() const {
    std::vector<Description> all;
    for (const Field& field : fields_) all.push_back(field.what);
    return all;
  }

  // The row as JSON.
  Json operator()(const Row& row, const Frame& outer) const {
    const Frame frame = frame_ ? frame_(row) : outer;
    Json out = Json::object();
    for (const Field& field : fields_) {
      Json value = field.of(row, frame);
      if (!field.left_out || !value.is_null()) out[std::string(field.what.name)] = std::move(value);
    }
    return out;
  }

 private:
  static auto unit_in(const Kind& kind) {
    return [kind](const Row& /*row*/, const Frame& frame) { return unit_of(kind, frame.reduced); };
  }

  Fields& add(Description what, Read of) {
    if (only_where_)
      of = [of = std::move(of), holds = only_where_](const Row& row, const Frame& frame) {
        return holds(row) ? of(row, frame) : Json();
      };
    fields_.push_back({std::move(what), std::move(of), left_out_});
    return *this;
  }

  template <class Get>
  Fields& leaf(const Description& what, Get get, bool is_reduced = false) {
    return add(what, [get, kind = is_reduced ? what.kind : kind::number](const Row& row, const Frame& frame) {
      return read_off(get, row, frame, kind);
    });
  }

  template <class Get, class GetUnit>
  Fields& estimate_with(Description what, Get get, bool is_reduced, GetUnit unit, const Fields& more) {
    what.entries = more.descriptions();
    return add(what,
               [get, unit, more, kind = is_reduced ? what.kind : kind::number](const Row& row, const Frame& frame) {
                 Json out = read_off(get, row, frame, kind);
                 if (out.is_null()) return out;
                 out["unit"] = call(unit, row, frame);
                 out.update(more(row, frame));
                 return out;
               });
  }

  std::vector<Field> fields_;
  bool left_out_ = false;
  std::function<Frame(const Row&)> frame_;
  std::function<bool(const Row&)> only_where_;
};

}  // namespace flexslip
