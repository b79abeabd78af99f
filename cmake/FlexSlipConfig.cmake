include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(hwy)
include(${CMAKE_CURRENT_LIST_DIR}/FlexSlipTargets.cmake)
