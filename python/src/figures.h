// The figures of a report as data of Python, for other hands to draw.
#pragma once

#include <pybind11/pybind11.h>

#include "report/plot.h"

namespace flexslip::python {

// As json_of (report/plot.h), with "data": {table: {title: array}}; an empty row is one of NaN.
pybind11::object plain(const Plot& plot);

}  // namespace flexslip::python
