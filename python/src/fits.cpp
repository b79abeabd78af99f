#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/fit_fields.h"
#include "answers/profile_fields.h"
#include "case/fitted.h"
#include "figures.h"
#include "finding/answer.h"
#include "interruptible.h"
#include "parts.h"
#include "plain.h"
#include "report/answer_documents.h"
#include "report/report.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;
using Fitted = const FittedTest&;

// The whole answer, composed without the interpreter's lock and then converted to Python.
py::object fit_answer(Fitted test) {
  const Json json = [&] {
    const py::gil_scoped_release unlocked;
    return fit_json(test);
  }();
  return plain(json, fit_fields().descriptions());
}

py::dict curves(Fitted test) {
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < test.analysis.record.force.size(); ++i) points.push_back({test, i, nullptr});
  for (const ProfilePoint& point : profile_of(test).points) points[point.index].read = &point;
  return columns_of_rows(curve_fields(), points, frame_of(test));
}

py::list figures_of_fit(Fitted test) {
  py::list all;
  for (const Chapter& chapter : document_of(test))
    for (const Block& block : chapter.blocks)
      if (const auto* pictures = std::get_if<Pictures>(&block))
        for (const Plot& plot : pictures->plots(two_columns)) all.append(plain(plot));
  return all;
}

std::shared_ptr<FittedTest> fit(const Test& input, const std::string& model, double false_alarms,
                                double suspect_limit) {
  AnalysisChoice choice{.model = model};
  choice.options.drops.false_alarms_per_test = false_alarms;
  choice.options.suspect_limit = suspect_limit;
  return interruptible([&](const std::atomic<bool>&) {
    return std::make_shared<FittedTest>(fit_test(input, options_for(input, choice)));
  });
}

}  // namespace

void add_fits(py::module_& module) {
  const AnalysisChoice usual;
  py::class_<FittedTest, std::shared_ptr<FittedTest>>(module, "FittedTest")
      .def("answer", fit_answer)
      .def("curves", curves)
      .def("draws", [](Fitted test) { return plain(draw_table(test)); })
      .def("figures", figures_of_fit)
      .def("why_no_answer", why_no_answer)
      .def("screen", [](Fitted test) { return fit_screen(test.name, answer_of(test)); })
      .def("text", fit_text)
      .def("write_report", [](Fitted test, const std::string& folder) {
        return interruptible([&](const std::atomic<bool>&) { return write_report(folder, test).is_done(); });
      });
  module.def("fit", fit, py::arg("case"), py::arg("model"), py::arg("false_alarms"), py::arg("suspect_limit"));
  module.attr("model_names") = model_names();
  module.attr("false_alarms") = usual.options.drops.false_alarms_per_test;
  module.attr("suspect_limit") = usual.options.suspect_limit;
}

}  // namespace flexslip::python
