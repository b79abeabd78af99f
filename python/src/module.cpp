// The compiled module of the package flexslip. python/flexslip is its public interface.
#include <pybind11/pybind11.h>

#include "parts.h"

PYBIND11_MODULE(_flexslip, module) {
  using namespace flexslip::python;
  module.doc() = "FlexSlip's library; use the package flexslip.";
  add_faults(module);
  add_states(module);
  add_cases(module);
  add_descriptions(module);
  add_fits(module);
  add_simulations(module);
  add_designs(module);
  add_campaigns(module);
  add_equilibria(module);
  add_standards(module);
  add_sweeps(module);
  add_exports(module);
}
