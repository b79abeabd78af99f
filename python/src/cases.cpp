#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/all_answers.h"
#include "case/case_file.h"
#include "case/case_keys.h"
#include "data/names.h"
#include "io/quantity.h"
#include "io/statistics_rows.h"
#include "parts.h"
#include "plain.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

// The unit of bare numbers of a key: SI; "" for plain numbers.
std::string unit_of_bare(const CaseKey& key) {
  if (!key.kind || key.kind->units.empty()) return "";
  if (key.kind->dimension == kind::time.dimension) return "s";
  return std::string(unit_of(*key.kind, false));
}

// The name in the enumeration: "quantity".
std::string_view name_of(Holds holds) {
  return name_in_order<Holds::tables>(
      holds, {"quantity", "share", "whole_number", "yes_no", "estimate", "word", "text", "title", "file",
              "name_or_number", "place", "lengths", "section", "axes", "tables"});
}

py::list keys() {
  py::list out;
  const Fields<CaseKey> fields = key_fields();
  for (const CaseKey& key : case_keys()) {
    auto described = plain(fields(key, {})).cast<py::dict>();
    described["unit"] = unit_of_bare(key);
    described["kind"] = key.kind ? std::string(key.kind->name) : "";
    described["words"] = words_of(key);
    described["is"] = name_of(key.holds);
    out.append(described);
  }
  return out;
}

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

// A case with a record in memory: columns in SI, in the order of TableColumns. Rows without a number (NaN) in a column
// are left out, as the reader of files does.
Test with_record(const Test& input, const std::vector<std::pair<std::string, Doubles>>& columns,
                 const std::string& name) {
  Test out = input;
  Table table{name, {}, {}};
  for (const auto& [title, values] : columns)
    table.columns.push_back({title, std::vector<double>(values.data(), values.data() + values.size())});
  table.lines.resize(table.rows());
  std::iota(table.lines.begin(), table.lines.end(), std::size_t{1});
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (std::any_of(table.columns.begin(), table.columns.end(),
                    [&](const Column& column) { return std::isnan(column.values[row]); }))
      table.missing_rows.push_back(row);
  for (Column& column : table.columns) column.values = without_rows(std::move(column.values), table.missing_rows);
  table.lines = without_rows(std::move(table.lines), table.missing_rows);
  out.record->file = name;
  out.record->given = std::make_shared<const Table>(std::move(table));
  return out;
}

// [SI] Converts values from a unit, with one rounding each.
Doubles in_si(const Doubles& values, const std::string& text, const std::string& of) {
  const Unit unit = parse_unit(text, of == "force" ? kind::force : kind::length);
  Doubles out(values.size());
  std::transform(values.data(), values.data() + values.size(), out.mutable_data(),
                 [&](double value) { return to_si(value, unit); });
  return out;
}

}  // namespace

void add_cases(py::module_& module) {
  py::class_<Test>(module, "Case")
      .def_readonly("source", &Test::source)
      .def_readonly("reduced", &Test::reduced)
      .def("toml", [](const Test& input) { return to_toml(input); })
      .def("has", [](const Test& input, const std::string& section) {
        return (section == "specimen" && input.specimen) || (section == "rig" && input.rig) ||
               (section == "friction" && input.friction) || (section == "stage" && input.stage) ||
               (section == "record" && input.record);
      });
  module.def(
      "read_case",
      [](const std::string& text, const std::string& source, const std::vector<std::string>& changes) {
        return read_case(text, source, changes);
      },
      py::call_guard<py::gil_scoped_release>());
  module.def("case_text", [](const std::string& path) { return py::bytes(case_text(path)); });
  module.def("keys", keys);
  module.def("with_record", with_record);
  module.def("in_si", in_si);
  module.def("length", [](const std::string& name, const std::string& text, bool may_be_zero) {
    return quantity_of_flag("--" + name, text, kind::length, may_be_zero ? Range::non_negative : Range::positive);
  });
}

}  // namespace flexslip::python
