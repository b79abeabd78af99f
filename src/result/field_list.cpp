#include "result/field_list.h"

#include <utility>

namespace flexslip {

Field::Read unit_in(const Kind& kind) {
  return [kind](const void* /*row*/, const Frame& frame, const Kind& /*as*/) {
    return Json(unit_of(kind, frame.reduced));
  };
}

void FieldList::add(Description what, Field::Read read, const Kind& reduced) {
  if (only_where_) {
    what.may_be_missing = true;
    read = [read = std::move(read), holds = only_where_](const void* row, const Frame& frame, const Kind& as) {
      return holds(row) ? read(row, frame, as) : Json();
    };
  }
  fields_.push_back({std::move(what), std::move(read), reduced, left_out_});
}

void FieldList::add_estimate(Description what, Field::Read read, const Kind& reduced, Field::Read unit,
                             const FieldList& more) {
  what.entries = more.descriptions();
  add(
      std::move(what),
      [read = std::move(read), unit = std::move(unit), more](const void* row, const Frame& frame, const Kind& as) {
        Json out = read(row, frame, as);
        if (out.is_null()) return out;
        out["unit"] = unit(row, frame, as);
        out.update(more(row, frame));
        return out;
      },
      reduced);
}

void FieldList::add_all(const FieldList& fields, bool may_be_missing, const Through& part) {
  for (const Field& field : fields.fields_) {
    Description what = field.what;
    what.may_be_missing |= may_be_missing;
    add(
        std::move(what),
        [part, read = field.read](const void* row, const Frame& frame, const Kind& as) {
          return part(row, frame, as, read);
        },
        field.reduced);
  }
}

std::vector<Description> FieldList::descriptions() const {
  std::vector<Description> all;
  for (const Field& field : fields_) all.push_back(field.what);
  return all;
}

Json FieldList::operator()(const void* row, const Frame& outer) const {
  const Frame frame = frame_ ? frame_(row) : outer;
  Json out = Json::object();
  for (const Field& field : fields_) {
    Json value = field.of(row, frame);
    if (!field.left_out || !value.is_null()) out[std::string(field.what.name)] = std::move(value);
  }
  return out;
}

}  // namespace flexslip
