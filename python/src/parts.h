// The parts of the module, each of which adds what it has.
#pragma once

#include <pybind11/pybind11.h>

namespace flexslip::python {

void add_states(pybind11::module_& module);        // the elastica: universal functions of NumPy
void add_faults(pybind11::module_& module);        // bad input as exceptions of Python
void add_cases(pybind11::module_& module);         // case files and their keys
void add_descriptions(pybind11::module_& module);  // every answer by what it holds
void add_fits(pybind11::module_& module);          // measured tests
void add_simulations(pybind11::module_& module);   // tests computed forward
void add_designs(pybind11::module_& module);       // planned tests
void add_campaigns(pybind11::module_& module);     // many tests
void add_equilibria(pybind11::module_& module);    // of a specimen, whatever the rig
void add_standards(pybind11::module_& module);     // the numbers of the bending standards
void add_sweeps(pybind11::module_& module);        // thousands of planned tests
void add_exports(pybind11::module_& module);       // exports of testing machines

}  // namespace flexslip::python
