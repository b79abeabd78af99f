// The figures of a report as Python data, for other drawing programs.
#pragma once

#include <pybind11/pybind11.h>

#include "report/plot.h"

namespace flexslip::python {

// As json_of (report/plot.h), with "data": {table: {title: array}}. An empty row becomes a row of
// NaN.
pybind11::object plain(const Plot& plot);

}  // namespace flexslip::python
