// Answers (result/fields.h) as plain Python data: dict, list, str, int, float, bool, None and NumPy
// arrays.
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "answers/all_answers.h"
#include "instruments/export.h"
#include "result/fields.h"
#include "result/table.h"

namespace flexslip::python {

// JSON as Python data; a list stays a list, and null becomes None.
pybind11::object plain(const Json& json);

// JSON with its description. Lists of numbers become arrays. Lists of groups become columns:
// {"rows": n, "columns": {name: array or list}, "absent": {name: rows without a value}}.
pybind11::object plain(const Json& json, const std::vector<Description>& entries);

// The value of one entry.
pybind11::object plain(const Json& value, const Description& entry);

// The inverse of plain(json): JSON with an indent of two.
std::string dumped(const pybind11::handle& data);

// Text and whole numbers under the names of options: {"force_unit": "N"} becomes {"force-unit",
// "N"}.
ReadingWords reading_words(const pybind11::dict& given);

// A table as columns, in the same form.
pybind11::dict plain(const ResultTable& table);

// Descriptions as a list of {"name", "title", "shape", "unit", "reduced_unit", "meaning",
// "entries", "may_be_missing", "is_several"}.
pybind11::list plain(const std::vector<Description>& entries);

// Rows as columns, without a copy as JSON, for paths of millions of points. Domain: no groups.
template <class Row, class Rows>
pybind11::dict columns_of_rows(const Fields<Row>& fields, const Rows& rows, const Frame& frame);

}  // namespace flexslip::python

#include "columns-inl.h"
