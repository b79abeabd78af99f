#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/design_fields.h"
#include "case/case_file.h"
#include "design/design_answer.h"
#include "design/design_result.h"
#include "design/reload_study.h"
#include "figures.h"
#include "interruptible.h"
#include "io/input_error.h"
#include "parts.h"
#include "plain.h"
#include "report/answer_documents.h"
#include "report/figures.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

using Words = std::vector<std::string>;

struct Map {
  PlannedCase planned;
  std::vector<DesignAxis> axes;
  std::vector<MapPoint> points;
};

py::object design_answer(const DesignAnswer& answer) {
  const Json json = design_fields()({answer, design_in_short(answer), changes_in_words(answer)},
                                    {answer.scales, answer.input.reduced});
  return plain(json, design_fields().descriptions());
}

py::object map_answer(const Map& map) {
  const auto fields = design_map_fields(map.axes);
  return plain(fields(map.points, {Scales(1, 1), map.planned.loading.reduced}), fields.descriptions());
}

// A loading as the text of a case; a step of 0 is one that is not stated.
std::string text_of_plan(Test loading) {
  if (loading.stage->step == 0.0) loading.stage->step.reset();
  return to_toml(std::move(loading));
}

template <class Type>
py::list one_figure(const Type& figure) {
  py::list out;
  out.append(plain(figure));
  return out;
}

}  // namespace

void add_designs(py::module_& module) {
  py::class_<DesignAnswer, std::shared_ptr<DesignAnswer>>(module, "DesignAnswer")
      .def("answer", design_answer)
      .def("figures",
           [](const DesignAnswer& answer) {
             if (answer.open) return one_figure(design_figure(answer));
             DesignAnswer with_phases = answer;
             with_phases.open = open_study(answer.input, {}, 1);
             return one_figure(design_figure(with_phases));
           })
      .def("toml", [](const DesignAnswer& answer) { return text_of_plan(answer.input); })
      .def("text", [](const DesignAnswer& answer) { return in_text(document_of(answer)); });
  py::class_<Map, std::shared_ptr<Map>>(module, "DesignMap")
      .def("answer", map_answer)
      .def("entries", [](const Map& map) { return plain(design_map_fields(map.axes).descriptions()); })
      .def("figures",
           [](const Map& map) { return one_figure(design_map_figure(map.planned.loading, map.axes, map.points)); })
      .def("toml", [](const Map& map) { return text_of_plan(map.planned.loading); })
      .def("values_taken", [](const Map& map) { return values_taken_for(map.planned, map.axes); });
  module.def("design", [](const std::string& text, const std::string& source, const Words& changes, unsigned threads) {
    return interruptible([&](const std::atomic<bool>&) {
      return std::make_shared<DesignAnswer>(answer_of(planned_case(text, source, changes), threads));
    });
  });
  module.def("design_with_reload", [](const std::string& text, const std::string& source, const Words& changes,
                                      const std::string& noise, unsigned threads) {
    return interruptible([&](const std::atomic<bool>&) {
      const PlannedCase planned = planned_case(text, source, changes);
      const Test& input = planned.loading;
      ReloadOptions options{.threads = threads};
      if (!noise.empty()) try {
          options.noise = parse_quantity(noise, input.reduced ? kind::number : kind::force, Range::positive);
        } catch (const InputError& error) {
          throw located(error, "", 0, "noise");
        }
      auto answer = std::make_shared<DesignAnswer>(answer_of(planned, threads));
      answer->reload = reload_study(input, options);
      return answer;
    });
  });
  module.def("design_map", [](const std::string& text, const std::string& source, const Words& changes,
                              const Words& over, unsigned threads) {
    return interruptible([&](const std::atomic<bool>&) {
      PlannedCase planned = planned_case(text, source, changes);
      auto axes = map_axes(planned.loading, over);
      auto points = design_map(planned.loading, axes, threads);
      return std::make_shared<Map>(Map{std::move(planned), std::move(axes), std::move(points)});
    });
  });
  module.attr("threads") = std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace flexslip::python
