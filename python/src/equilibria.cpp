#include <memory>
#include <string>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/state_fields.h"
#include "case/studies.h"
#include "figures.h"
#include "interruptible.h"
#include "parts.h"
#include "plain.h"
#include "report/figures.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

py::dict study_answer(const EquilibriumStudy& study) {
  const Frame frame{study.scales, study.reduced};
  const EquilibriumColumns columns = columns_of(study);
  const Fields<EquilibriumStudy> fields = equilibria_fields(columns);
  py::dict out;
  for (const Field& field : fields) {
    const py::str name(field.what.name.data(), field.what.name.size());
    if (field.what.shape == Shape::list) {
      const auto points = interruptible([&](const std::atomic<bool>&) { return points_of(study); });
      out[name] = columns_of_rows(equilibrium_fields(columns), points, frame);
    } else {
      out[name] = plain(fields.of(field, study, frame), field.what);
    }
  }
  return out;
}

}  // namespace

void add_equilibria(py::module_& module) {
  py::class_<EquilibriumStudy, std::shared_ptr<EquilibriumStudy>>(module, "EquilibriumStudy")
      .def("answer", study_answer)
      .def("figures", [](const EquilibriumStudy& study) {
        py::list out;
        out.append(plain(equilibrium_figure(study)));
        return out;
      });
  module.def("equilibrium", [](const Test& input, bool region, int points, int levels, const std::string& longest) {
    return interruptible([&](const std::atomic<bool>&) {
      return std::make_shared<EquilibriumStudy>(
          study_equilibria(input, {.region = region, .points = points, .levels = levels, .longest = longest}));
    });
  });
  module.attr("most_equilibria") = max_equilibria;
  module.attr("most_levels") = max_levels;
}

}  // namespace flexslip::python
