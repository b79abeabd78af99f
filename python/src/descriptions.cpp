#include <pybind11/pybind11.h>

#include "answers/all_answers.h"
#include "io/quantity.h"
#include "parts.h"
#include "plain.h"

namespace flexslip::python {

namespace py = pybind11;

namespace {

// The kind with this unit; kind::number without a unit.
const Kind& kind_of(const std::string& unit) {
  if (!unit.empty())
    for (const Kind* kind : {&kind::length, &kind::inverse_length, &kind::force, &kind::stiffness, &kind::pressure,
                             &kind::bending_stiffness, &kind::energy, &kind::time})
      if (parse_unit(unit).dimension == kind->dimension) return *kind;
  return kind::number;
}

}  // namespace

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
  module.def("readable", [](double value, const std::string& unit) { return readable(value, kind_of(unit)); });
  module.def("readable_estimate",
             [](double value, double error, const std::string& unit) { return readable(value, error, kind_of(unit)); });
  module.attr("version") = FLEXSLIP_VERSION;
}

}  // namespace flexslip::python
