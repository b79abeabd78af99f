#include <memory>
#include <string>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "instruments/export.h"
#include "instruments/export_fields.h"
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
                        py::arg("role") = std::string(words_for(column.role).name), py::arg("values") = values));
  }
  return out;
}

// [SI] The values of a role that only one column has.
py::array_t<double> role_in_si(const Export& file, std::size_t chosen, const std::string& role) {
  const ExportedSpecimen& specimen = file.specimens.at(chosen);
  for (const ColumnRole known :
       {ColumnRole::time, ColumnRole::displacement, ColumnRole::crosshead, ColumnRole::deflection, ColumnRole::force}) {
    const RoleWords& words = words_for(known);
    if (words.name != role) continue;
    const std::vector<double> values = in_si(file, column_with(file, specimen, known), *words.kind);
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
  }
  throw InputError(
      {.field = "role",
       .problem = fmt::format("{} is not time, displacement, crosshead, deflection or force", in_quotes(role))});
}

}  // namespace

void add_exports(py::module_& module) {
  py::class_<Export, std::shared_ptr<Export>>(module, "Export")
      .def_property_readonly("specimens", [](const Export& file) { return file.specimens.size(); })
      .def("answer",
           [](const Export& file, std::size_t chosen) {
             return plain(export_fields()({file, chosen}, {}), export_fields().descriptions());
           })
      .def("columns", columns)
      .def("in_si", role_in_si)
      .def("write", [](const Export& file, std::size_t chosen, const std::string& path) {
        write_canonical(path, file, file.specimens.at(chosen));
      });
  module.def("read", [](const std::string& path, const py::dict& given) {
    const ReadingWords words = reading_words(given);
    return interruptible(
        [&](const std::atomic<bool>&) { return std::make_shared<Export>(read_export(path, options_of(words))); });
  });
}

}  // namespace flexslip::python
