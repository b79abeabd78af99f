# What the two libraries are made of, wherever they are built: src/CMakeLists.txt for a computer, studio/CMakeLists.txt for a page.

set(FLEXSLIP_CORE_ROOMS numerics fibre contact bending_test data inference)
if(WIN32)
  set(FLEXSLIP_SYSTEM platform/windows)
else()
  set(FLEXSLIP_SYSTEM platform/posix)
endif()
set(FLEXSLIP_EDGE_ROOMS platform ${FLEXSLIP_SYSTEM} io result instruments case finding design campaign answers report)

# Eigen cuts products of matrices to the caches of the processor, and sums of their parts round as they are cut: by its own sizes instead, the
# same bits come from every processor. Its vectors are as wide as an instruction set has them, and their sums round accordingly: without them
# the studio's WebAssembly, which has none, gives the same bits too.
set(FLEXSLIP_EIGEN EIGEN_NO_CPUID EIGEN_DONT_VECTORIZE
  EIGEN_DEFAULT_L1_CACHE_SIZE=32768 EIGEN_DEFAULT_L2_CACHE_SIZE=262144 EIGEN_DEFAULT_L3_CACHE_SIZE=2097152)

# Headers that cost most, read once.
set(FLEXSLIP_CORE_HEADERS <algorithm> <array> <cmath> <functional> <limits> <optional> <span> <stdexcept> <string> <variant> <vector> <Eigen/Cholesky> <Eigen/LU>)
set(FLEXSLIP_EDGE_HEADERS <algorithm> <functional> <optional> <string> <variant> <vector> <fmt/format.h> <nlohmann/json.hpp>)
