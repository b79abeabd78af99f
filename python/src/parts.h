// The parts of the module. Each adds its classes and functions.
#pragma once

#include <pybind11/pybind11.h>

namespace flexslip::python {

void add_states(pybind11::module_& module);        // the elastica: universal functions of NumPy
void add_faults(pybind11::module_& module);        // bad input as exceptions of Python
void add_cases(pybind11::module_& module);         // case files and their keys
void add_descriptions(pybind11::module_& module);  // the fields of every answer
void add_fits(pybind11::module_& module);          // measured tests
void add_simulations(pybind11::module_& module);   // simulated tests
void add_designs(pybind11::module_& module);       // planned tests
void add_campaigns(pybind11::module_& module);     // many tests
void add_equilibria(pybind11::module_& module);    // loading curves, on any rig
void add_standards(pybind11::module_& module);     // the numbers of the bending standards
void add_sweeps(pybind11::module_& module);        // thousands of planned tests
void add_exports(pybind11::module_& module);       // exports of testing machines

}  // namespace flexslip::python
