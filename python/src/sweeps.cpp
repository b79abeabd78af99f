#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "answers/design_fields.h"
#include "design/sweep.h"
#include "interruptible.h"
#include "io/input_error.h"
#include "parts.h"
#include "plain.h"

namespace flexslip::python {
namespace {

namespace py = pybind11;

// {"rows", "columns", "absent"} as in plain.h, and "units" by column.
py::dict sweep_table(const std::string& text, const std::string& source, const std::vector<std::string>& changes,
                     unsigned threads) {
  constexpr std::uint64_t max_designs = 10'000'000;  // they take 6 GB here
  const SweepPlan plan = read_sweep(text, source, changes);
  if (plan.rows > max_designs)
    throw wrong_value(plan.loading, "sweep",
                      fmt::format("The sweep has {} designs; memory holds at most {}", plan.rows, max_designs),
                      "take fewer points, or the command sweep, which writes a file");
  const std::vector<DesignPoint> points = interruptible([&](const std::atomic<bool>&) {
    return points_of(plan, {0, plan.rows}, threads);
  });
  const Fields<DesignPoint> fields = point_fields(plan.axes);
  const Frame frame{Scales(1, 1), plan.loading.reduced};
  py::dict table = columns_of_rows(fields, points, frame);
  py::dict units;
  for (const Description& column : fields.descriptions())
    if (column.shape == Shape::number)
      units[py::str(std::string(column.name))] = std::string(unit_of(column.kind, plan.loading.reduced));
  table["units"] = units;
  return table;
}

}  // namespace

void add_sweeps(py::module_& module) { module.def("sweep", sweep_table); }

}  // namespace flexslip::python
