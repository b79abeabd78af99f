#include <exception>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/pybind11.h>

#include "data/names.h"
#include "io/call_files.h"
#include "io/input_error.h"
#include "parts.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

py::object text_or_none(std::string_view words) {
  if (words.empty()) return py::none();
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(words.data(), static_cast<py::ssize_t>(words.size()), "surrogateescape"));
}

// The Python package creates the exception, because it defines the exception classes.
py::object exception_of(const InputError& error) {
  const InputFault& fault = error.fault;
  const char* kind = name_in_order<FaultKind::too_much>(fault.kind, {"wrong", "missing", "unknown", "too_much"}).data();
  py::object line = py::none(), limit = py::none();
  if (fault.line > 0) line = py::int_(fault.line);
  if (fault.limit) limit = py::float_(*fault.limit);
  return py::module_::import("flexslip._errors")
      .attr("error_of")(text_or_none(fmt::format("{}", fmt::join(error.lines(), "\n"))),
                        py::arg("file") = text_or_none(fault.file), py::arg("line") = line,
                        py::arg("field") = text_or_none(fault.field), py::arg("problem") = text_or_none(fault.problem),
                        py::arg("remedy") = text_or_none(fault.remedy), py::arg("kind") = kind,
                        py::arg("key") = text_or_none(fault.key), py::arg("limit") = limit);
}

}  // namespace

void add_faults(py::module_& /*module*/) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      const py::object exception = exception_of(error);
      PyErr_SetObject(py::type::of(exception).ptr(), exception.ptr());
    } catch (const OutputClash& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}

}  // namespace flexslip::python
