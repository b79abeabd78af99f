#include <pybind11/pybind11.h>

#include "answers/all_answers.h"
#include "io/quantity.h"
#include "parts.h"
#include "plain.h"

namespace flexslip::python {

namespace py = pybind11;

void add_descriptions(py::module_& module) {
  module.def("answers", [] {
    py::dict out;
    for (const AnswerDescription& answer : all_answers())
      out[py::str(std::string(answer.command))] =
          py::dict(py::arg("what") = std::string(answer.what), py::arg("is_table") = answer.is_table,
                   py::arg("entries") = plain(answer.entries));
    return out;
  });
  module.def("dumped", [](const py::object& data) { return dumped(data); });
  module.def("readable", [](double value, const std::string& unit) {
    for (const Kind* kind : {&kind::length, &kind::inverse_length, &kind::force, &kind::stiffness, &kind::compliance,
                             &kind::pressure, &kind::bending_stiffness, &kind::energy, &kind::time})
      if (parse_unit(unit).dimension == kind->dimension) return readable(value, *kind);
    return readable(value, kind::number);
  });
  module.attr("version") = FLEXSLIP_VERSION;
}

}  // namespace flexslip::python
