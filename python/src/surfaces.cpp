#include <memory>
#include <string>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/surface_fields.h"
#include "case/surface_study.h"
#include "figures.h"
#include "instruments/trace_file.h"
#include "interruptible.h"
#include "parts.h"
#include "plain.h"
#include "report/answer_documents.h"
#include "report/figures.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;
using Study = const SurfaceStudy&;

// Words by their names, as far as they are given.
class Given {
 public:
  explicit Given(const py::dict& given) : given_(given) {}
  template <class Value>
  void take(const char* name, Value& value) const {
    if (given_.contains(name)) value = given_[name].cast<Value>();
  }

 private:
  const py::dict& given_;
};

SurfaceChoice choice_of(const Given& given) {
  SurfaceChoice choice;
  given.take("cutoff", choice.cutoff);
  given.take("edge_radius", choice.edge_radius);
  given.take("friction", choice.friction);
  given.take("pixel", choice.pixel);
  given.take("amplitude", choice.amplitude);
  given.take("shortest", choice.shortest);
  given.take("longest", choice.longest);
  given.take("noise", choice.noise);
  given.take("wavelength", choice.wavelengths);
  given.take("level", choice.level);
  given.take("tapers", choice.tapers);
  return choice;
}

}  // namespace

void add_surfaces(py::module_& module) {
  py::class_<SurfaceStudy, std::shared_ptr<SurfaceStudy>>(module, "SurfaceStudy")
      .def("told", [](Study study) { return plain(surface_fields()(study, {}), surface_fields().descriptions()); })
      .def("trace_table", [](Study study) { return columns_of_rows(trace_fields(), points_of(study), {}); })
      .def("spectrum_table",
           [](Study study) { return columns_of_rows(spectrum_fields(), spectrum_points_of(study), {}); })
      .def("figures",
           [](Study study) {
             py::list out;
             out.append(plain(surface_figure(study)));
             return out;
           })
      .def("text", [](const SurfaceStudy& study) { return in_text(document_of(study)); })
      .def("in_short", surface_in_short);
  module.def("surface", [](const std::string& path, const py::dict& words) {
    const Given given(words);
    const SurfaceChoice choice = choice_of(given);
    const ReadingWords trace = reading_words(words);
    return interruptible([&](const std::atomic<bool>&) {
      const SurfaceOptions options = options_of(choice);
      return std::make_shared<SurfaceStudy>(study_surface(read_trace(path, trace_options_of(trace)), options));
    });
  });
  module.attr("most_degree") = max_degree;
  module.attr("least_tapers") = min_tapers;
  module.attr("most_tapers") = max_tapers;
}

}  // namespace flexslip::python
