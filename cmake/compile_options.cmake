# What every target of ours is compiled with, and nothing that is not ours: both are linked PRIVATE.

add_library(flexslip_warnings INTERFACE)
target_compile_options(flexslip_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)

# The same input must give the same bits from every compiler and on every processor. Contraction would let a compiler
# fuse a*b + c into one rounding wherever the processor can, and the error bounds in our headers are proved and
# measured without it. For the same reason no preset says -march=native or -ffast-math.
add_library(flexslip_arithmetic INTERFACE)
target_compile_options(flexslip_arithmetic INTERFACE -ffp-contract=off)

add_library(flexslip_options INTERFACE)
target_link_libraries(flexslip_options INTERFACE flexslip_warnings flexslip_arithmetic)
# GCC collects its garbage whenever its heap has doubled since it last did, from 128 MB on, which the precompiled headers reach at once: a tenth of
# all compiling or more. From 512 MB on hardly any source does, at 1.2 GB of memory for the largest.
target_compile_options(flexslip_options INTERFACE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=524288>")

# Several files of a target as one. A name may hide that of another file: so that is no warning here; dev and clang, which compile each file alone,
# warn of it.
function(flexslip_several_as_one name)
  if(FLEXSLIP_UNITY)
    set_target_properties(${name} PROPERTIES
      UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8
      UNITY_BUILD_CODE_BEFORE_INCLUDE "#pragma GCC diagnostic ignored \"-Wshadow\"
#pragma GCC diagnostic ignored \"-Wsubobject-linkage\"")
  endif()
endfunction()
