include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(Ceres)
include(${CMAKE_CURRENT_LIST_DIR}/FlexSlipTargets.cmake)
