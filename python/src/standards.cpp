#include <string>
#include <vector>

#include <pybind11/numpy.h>
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

// The record that the numbers describe. Deflections are counted from the origin of strains, if there
// is one; the linear region is its first point and the one behind its last, or None.
py::dict curve_of(const ModulusStudy& study) {
  const Record& record = study.measurement.first_curve.record;
  const SmallDeflection& numbers = study.numbers;
  const bool ok = numbers.status == SmallDeflectionStatus::ok;
  std::vector<double> deflection = record.deflection;
  for (double& each : deflection) each -= ok ? numbers.origin : 0;
  const auto array = [](const std::vector<double>& values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  return py::dict(py::arg("deflection") = array(deflection), py::arg("force") = array(record.force),
                  py::arg("linear_region") = ok ? py::object(py::make_tuple(numbers.first, numbers.last)) : py::none());
}

py::dict modulus(const Test& input, const std::vector<std::string>& window, const std::vector<std::string>& friction) {
  const ModulusStudy study = interruptible(
      [&](const std::atomic<bool>&) { return study_modulus(input, window_of(window), friction_range_of(friction)); });
  const StandardTest test = standard_test(study);
  return py::dict(py::arg("answer") = plain(modulus_fields()(test, frame_of(test)), modulus_fields().descriptions()),
                  py::arg("words") = small_deflection_in_words(test), py::arg("curve") = curve_of(study));
}

}  // namespace

void add_standards(py::module_& module) { module.def("modulus", modulus); }

}  // namespace flexslip::python
