#include <cstdint>
#include <memory>
#include <string>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/mechanics_fields.h"
#include "answers/profile_fields.h"
#include "case/simulated_test.h"
#include "case/studies.h"
#include "figures.h"
#include "interruptible.h"
#include "io/input_error.h"
#include "parts.h"
#include "plain.h"
#include "report/figures.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

// A simulation with its case, which the figure needs.
struct Simulated {
  Test input;
  SimulatedTest test;
};

std::shared_ptr<Simulated> run(const Test& input, int points, const std::string& noise, std::uint64_t seed) {
  SimulationOptions options{.points = points, .noise = 0, .seed = seed};
  if (!noise.empty()) try {
      options.noise = parse_quantity(noise, input.reduced ? kind::number : kind::force, Range::non_negative);
    } catch (const InputError& error) {
      throw located(error, "", 0, "noise");
    }
  return std::make_shared<Simulated>(Simulated{input, simulate(input, options)});
}

py::dict simulation_answer(const Simulated& simulated, bool energies) {
  const SimulatedTest& test = simulated.test;
  const Frame frame{test.scales, test.reduced};
  const PathColumns columns = columns_of(test.simulation, energies);
  const Fields<Simulation> fields = simulation_fields(columns);
  py::dict out;
  for (const Field& field : fields) {
    const py::str name(field.what.name.data(), field.what.name.size());
    if (field.what.name == "path")
      out[name] = columns_of_rows(path_fields(columns), test.simulation.path, frame);
    else
      out[name] = plain(fields.of(field, test.simulation, frame), field.what);
  }
  return out;
}

py::list figures_of_simulation(const Simulated& simulated) {
  py::list out;
  out.append(plain(simulated_figure(simulated.test, cracks_of(simulated.input, simulated.test.scales))));
  return out;
}

// Pointwise friction of a record without a fit.
py::dict profile(const Test& input) {
  const InvertedTest test = interruptible([&](const std::atomic<bool>&) { return invert_test(input); });
  const Fields<InvertedTest> fields = inverted_test_fields();
  return py::dict(py::arg("answer") = plain(fields(test, frame_of(test)), fields.descriptions()),
                  py::arg("remarks") = test.remarks, py::arg("why_no_answer") = test.why_no_answer);
}

}  // namespace

void add_simulations(py::module_& module) {
  py::class_<Simulated, std::shared_ptr<Simulated>>(module, "SimulatedTest")
      .def("answer", simulation_answer)
      .def("figures", figures_of_simulation)
      .def_property_readonly("remarks", [](const Simulated& simulated) { return simulated.test.remarks; })
      .def_property_readonly("why_it_ends", [](const Simulated& simulated) { return simulated.test.why_it_ends; });
  module.def("simulate", [](const Test& input, int points, const std::string& noise, std::uint64_t seed) {
    return interruptible([&](const std::atomic<bool>&) { return run(input, points, noise, seed); });
  });
  module.def("friction_profile", profile);
}

}  // namespace flexslip::python
