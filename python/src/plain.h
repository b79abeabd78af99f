// Answers, described once (result/fields.h), as plain data of Python: dict, list, str, int, float, bool, None, and NumPy arrays of numbers.
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "answers/all_answers.h"
#include "instruments/export.h"
#include "result/fields.h"
#include "result/table.h"

namespace flexslip::python {

// JSON as what stands for it in Python; a list is a list, and null is None.
pybind11::object plain(const Json& json);

// The same of what is described. Lists of numbers are arrays, lists of groups are columns: {"rows": n, "columns": {name: array or list},
// "absent": {name: rows that do not have it}}.
pybind11::object plain(const Json& json, const std::vector<Description>& entries);

// A value of one of them.
pybind11::object plain(const Json& value, const Description& entry);

// The way back from plain(json): JSON as the program writes it, with an indent of two.
std::string dumped(const pybind11::handle& data);

// Text and whole numbers by their names, which are those of flags: {"force_unit": "N"} is {"force-unit", "N"}.
ReadingWords reading_words(const pybind11::dict& given);

// A table as columns, as above.
pybind11::dict plain(const ResultTable& table);

// What describes them: a list of {"name", "title", "shape", "unit", "reduced_unit", "meaning", "entries", "may_be_missing",
// "is_several"}.
pybind11::list plain(const std::vector<Description>& entries);

// Columns read off rows one by one, without a copy as JSON: for paths of millions of points. Domain: no groups among them.
template <class Row, class Rows>
pybind11::dict columns_of_rows(const Fields<Row>& fields, const Rows& rows, const Frame& frame);

}  // namespace flexslip::python

#include "columns-inl.h"
