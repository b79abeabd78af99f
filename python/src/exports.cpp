#include <memory>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "instruments/canonical.h"
#include "instruments/column_flags.h"
#include "instruments/export.h"
#include "instruments/export_fields.h"
#include "instruments/export_words.h"
#include "interruptible.h"
#include "io/input_error.h"
#include "parts.h"
#include "plain.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

py::list columns(const Export& file, std::size_t chosen) {
  py::list out;
  for (const ExportColumn& column : file.specimens.at(chosen).columns) {
    py::object values = py::cast(column.words);
    if (column.words.empty())
      values = py::array_t<double>(static_cast<py::ssize_t>(column.values.size()), column.values.data());
    out.append(py::dict(py::arg("name") = column.name, py::arg("unit") = column.unit,
                        py::arg("role") = std::string(name_of(column.role)), py::arg("values") = values));
  }
  return out;
}

// In SI, of a role that one column alone has.
py::array_t<double> role_in_si(const Export& file, std::size_t chosen, const std::string& role) {
  const ExportedSpecimen& specimen = file.specimens.at(chosen);
  for (const ColumnRole known :
       {ColumnRole::time, ColumnRole::displacement, ColumnRole::crosshead, ColumnRole::deflection, ColumnRole::force}) {
    if (name_of(known) != role) continue;
    const Kind& kind = known == ColumnRole::time ? kind::time : known == ColumnRole::force ? kind::force : kind::length;
    const std::vector<double> values = in_si(file, specimen, column_with(file, specimen, known), kind);
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
  }
  throw InputError(
      {.field = "role", .expected = "time, displacement, crosshead, deflection or force", .found = in_quotes(role)});
}

ExportWords words_of(const py::dict& given) {
  ExportWords words;
  const auto take = [&](const char* name, std::string& word) {
    if (given.contains(name)) word = given[name].cast<std::string>();
  };
  take("sheet", words.sheet);
  if (given.contains("sheet_number")) words.sheet_number = given["sheet_number"].cast<std::size_t>();
  take("encoding", words.encoding);
  take("separator", words.separator);
  take("decimal", words.decimal);
  take("thousands", words.thousands);
  take("time", words.time);
  take("crosshead", words.crosshead);
  take("deflection", words.deflection);
  take("force", words.force);
  take("displacement", words.displacement);
  take("time_unit", words.time_unit);
  take("displacement_unit", words.displacement_unit);
  take("force_unit", words.force_unit);
  take("calibration", words.calibration);
  return words;
}

}  // namespace

void add_exports(py::module_& module) {
  py::class_<Export, std::shared_ptr<Export>>(module, "Export")
      .def_property_readonly("specimens", [](const Export& file) { return file.specimens.size(); })
      .def("told",
           [](const Export& file, std::size_t chosen) {
             return plain(export_fields()({file, chosen}, {}), export_fields().descriptions());
           })
      .def("columns", columns)
      .def("in_si", role_in_si)
      .def("write", [](const Export& file, std::size_t chosen, const std::string& path) {
        write_canonical(path, file, file.specimens.at(chosen));
      });
  module.def("read", [](const std::string& path, const py::dict& given) {
    const ExportWords words = words_of(given);
    return interruptible(
        [&](const std::atomic<bool>&) { return std::make_shared<Export>(read_export(path, options_of(words))); });
  });
}

}  // namespace flexslip::python
