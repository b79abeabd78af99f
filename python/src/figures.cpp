#include "figures.h"

#include <algorithm>
#include <cmath>

#include <pybind11/numpy.h>

namespace flexslip::python {

namespace py = pybind11;

py::dict plain(const Figure& figure) {
  py::dict data;
  for (const FigureData& each : figure.data) {
    py::dict columns;
    for (std::size_t column = 0; column < each.titles.size(); ++column) {
      py::array_t<double> values(static_cast<py::ssize_t>(each.rows.size()));
      std::transform(each.rows.begin(), each.rows.end(), values.mutable_data(),
                     [column](const std::vector<double>& row) { return column < row.size() ? row[column] : NAN; });
      columns[py::str(each.titles[column])] = values;
    }
    data[py::str(each.name)] = columns;
  }
  return py::dict(py::arg("name") = figure.name, py::arg("title") = figure.title,
                  py::arg("description") = figure.description, py::arg("width") = figure.width,
                  py::arg("height") = figure.height, py::arg("data") = data, py::arg("script") = figure.script);
}

}  // namespace flexslip::python
