// The longer functions of Fields: part of result/fields.h.

namespace flexslip {

template <class Row>
Fields<Row>& Fields<Row>::own_quantity(Name name, const Kind& kind, Meaning meaning, Get get) {
  list_.add(described({name, Shape::quantity, kind, meaning}, get),
            [read = std::move(get.read), kind](const void* row, const Frame& frame, const Kind& as) {
              return with_unit(read(row, frame, as), unit_of(kind, frame.reduced));
            });
  return *this;
}

template <class Row>
template <class GetPoint>
Fields<Row>& Fields<Row>::row(Name name, Meaning meaning, GetPoint get) {
  return count(name, meaning, [get](const Row& row, const Frame& frame) { return frame.row(std::invoke(get, row)); });
}

template <class Row>
template <class GetPairs>
Fields<Row>& Fields<Row>::words_by_name(Name name, Meaning meaning, GetPairs get) {
  return plain(name, Shape::words_by_name, meaning,
               [get](const Row& row, const Frame& frame) { return object_of(call(get, row, frame)); });
}

template <class Row>
Fields<Row>& Fields<Row>::estimate(Name name, const Kind& kind, Meaning meaning, Get get, const Fields& more) {
  list_.add_estimate(described({name, Shape::estimate, kind, meaning}, get), std::move(get.read), kind, unit_in(kind),
                     more.list_);
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::own_estimate(Name name, const Kind& kind, Meaning meaning, Get get, const Fields& more) {
  list_.add_estimate(described({name, Shape::estimate, kind, meaning}, get), std::move(get.read), kind::number,
                     unit_in(kind), more.list_);
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::own_estimate(const Named& what, Get get, const Fields& more) {
  return own_estimate(what.name, what.kind, what.meaning, std::move(get), more);
}

template <class Row>
Fields<Row>& Fields<Row>::estimate_in(Name name, Meaning meaning, Get get, Get unit, const Fields& more) {
  list_.add_estimate(described({name, Shape::estimate, kind::number, meaning}, get), std::move(get.read), kind::number,
                     std::move(unit.read), more.list_);
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::group(Name name, Meaning meaning, const Fields& below) {
  return group(name, meaning, below, [](const Row& row) -> const Row& { return row; });
}

template <class Row>
template <class Part, class GetPart>
Fields<Row>& Fields<Row>::group(Name name, Meaning meaning, const Fields<Part>& below, GetPart get) {
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

template <class Row>
template <class Part, class GetParts>
Fields<Row>& Fields<Row>::list(Name name, Meaning meaning, const Fields<Part>& below, GetParts get) {
  return add({name, Shape::list, kind::number, meaning, below.descriptions()},
             [get, below](const Row& row, const Frame& frame) {
               Json out = Json::array();
               for (const Part& part : call(get, row, frame)) append(out, below(part, frame));
               return out;
             });
}

template <class Row>
template <class Part, class GetPairs>
Fields<Row>& Fields<Row>::by_name(Name name, Meaning meaning, const Fields<Part>& below, GetPairs get) {
  return add({name, Shape::by_name, kind::number, meaning, below.descriptions()},
             [get, below](const Row& row, const Frame& frame) {
               Json out = Json::object();
               for (const auto& [key, part] : call(get, row, frame)) put(out, key, below(part, frame));
               return out;
             });
}

template <class Row>
template <class Part, class GetPart>
Fields<Row>& Fields<Row>::all_of(const Fields<Part>& fields, GetPart get) {
  list_.add_all(fields.untyped(), MayBeMissing<Given<GetPart, Row>>,
                [get](const void* row, const Frame& frame, const Kind& as, const Field::Read& read) {
                  return if_there(call(get, *static_cast<const Row*>(row), frame),
                                  [&](const Part& part) { return read(&part, frame, as); });
                });
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::all_of(const Fields& fields) {
  return all_of(fields, [](const Row& row) -> const Row& { return row; });
}

template <class Row>
template <class Holds>
Fields<Row>& Fields<Row>::only_where(Holds holds) {
  list_.only_where(
      [holds](const void* row) { return static_cast<bool>(std::invoke(holds, *static_cast<const Row*>(row))); });
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::anywhere() {
  list_.only_where(nullptr);
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::left_out_where_missing() {
  list_.left_out_where_missing();
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::in_frame(std::function<Frame(const Row&)> frame) {
  list_.in_frame([frame = std::move(frame)](const void* row) { return frame(*static_cast<const Row*>(row)); });
  return *this;
}

template <class Row>
Fields<Row>& Fields<Row>::titled(std::string_view title) {
  list_.titled(title);
  return *this;
}

}  // namespace flexslip
