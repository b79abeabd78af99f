// The figures of a report as data of Python: what is drawn where, for other hands to draw.
#pragma once

#include <pybind11/pybind11.h>

#include "report/figure.h"

namespace flexslip::python {

// {"name", "title", "description", "width", "height", "data": {name: {title: array}}, "script"}; an empty row is one of NaN.
pybind11::dict plain(const Figure& figure);

}  // namespace flexslip::python
