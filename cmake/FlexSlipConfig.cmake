include(${CMAKE_CURRENT_LIST_DIR}/FlexSlipTargets.cmake)
