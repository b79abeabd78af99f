# The reference values of tests/fibre/reference as initialisers, reference/NAME.inc in the folder of the build, for tests and benchmarks.
find_program(FLEXSLIP_PYTHON3 python3 HINTS /usr/bin REQUIRED)
set(reference ${PROJECT_SOURCE_DIR}/tests/fibre/reference)
file(GLOB tables CONFIGURE_DEPENDS ${reference}/*.csv)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${tables} ${reference}/initialisers.py)
execute_process(COMMAND ${FLEXSLIP_PYTHON3} ${reference}/initialisers.py ${PROJECT_BINARY_DIR}/reference COMMAND_ERROR_IS_FATAL ANY)
include_directories(${PROJECT_BINARY_DIR})
