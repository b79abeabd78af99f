#include <string>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/standard_fields.h"
#include "case/studies.h"
#include "interruptible.h"
#include "parts.h"
#include "plain.h"
#include "report/answer_documents.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

py::dict modulus(const Test& input, const std::vector<std::string>& window, const std::vector<std::string>& friction) {
  const ModulusStudy study = interruptible(
      [&](const std::atomic<bool>&) { return study_modulus(input, window_of(window), friction_range_of(friction)); });
  const StandardTest test = standard_test(study);
  return py::dict(py::arg("answer") = plain(modulus_fields()(test, frame_of(test)), modulus_fields().descriptions()),
                  py::arg("words") = small_deflection_in_words(test));
}

}  // namespace

void add_standards(py::module_& module) { module.def("modulus", modulus); }

}  // namespace flexslip::python
