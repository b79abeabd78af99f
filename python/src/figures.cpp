#include "figures.h"

#include <algorithm>

#include <pybind11/numpy.h>

#include "plain.h"
#include "report/plot.h"

namespace flexslip::python {

namespace py = pybind11;

py::object plain(const Plot& plot) {
  py::dict data;
  for (const PlotTable& table : plot.data) {
    py::dict columns;
    for (std::size_t column = 0; column < table.titles.size(); ++column) {
      py::array_t<double> values(static_cast<py::ssize_t>(table.rows.size()));
      std::transform(table.rows.begin(), table.rows.end(), values.mutable_data(),
                     [column](const std::vector<double>& row) { return column < row.size() ? row[column] : NAN; });
      columns[py::str(table.titles[column])] = values;
    }
    data[py::str(table.name)] = columns;
  }
  py::object out = plain(json_of(laid_out(plot)));
  out["data"] = data;
  return out;
}

}  // namespace flexslip::python
