// The inputs of the public functions as the case that the inner rooms read, and their errors as the public one.
#pragma once

#include <exception>
#include <new>

#include "case/test.h"
#include "flexslip/error.h"
#include "flexslip/estimate.h"
#include "flexslip/simulate.h"
#include "flexslip/test.h"
#include "io/input_error.h"
#include "result/frame.h"

namespace flexslip::library {

// A test with specimen and rig; and the same with one more section.
Test described(const v1::Setup& setup);
Test with(Test test, const v1::Friction& friction);
Test with(Test test, const v1::Programme& programme);
Test with(Test test, const v1::Record& record);

// The test as the reader of case files takes it.
// Fails:      InputError that names the key.
Test checked(const Test& test);

// JSON as numbers: null is v1::not_known. A field that is missing is null.
Json field(const Json& group, const char* name);
double number(const Json& value);
v1::Estimate estimate(const Json& value);

v1::Error error_of(InputFault fault);

// The result of `work`, whose exceptions become the public one.
template <class Work>
auto guarded(const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw error_of(error.fault);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw error_of({.problem = error.what()});
  }
}

}  // namespace flexslip::library
