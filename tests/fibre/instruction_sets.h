// Runs code on each instruction set of this processor that batches are compiled for, the scalar one included.
#pragma once

#include <cstdint>

#include <doctest/doctest.h>
#include <hwy/targets.h>

namespace flexslip {

template <class Function>
void on_each_instruction_set(Function f) {
  int tried = 0;
  for (const std::int64_t target : {HWY_AVX3, HWY_AVX2, HWY_SSE4, HWY_NEON, HWY_SCALAR}) {
    if (target != HWY_SCALAR && (hwy::SupportedTargets() & target) == 0) continue;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
    CAPTURE(hwy::TargetName(target));
    f();
    ++tried;
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().DeInit();
  }
  CHECK(tried >= 2);
}

}  // namespace flexslip
