# NLopt, Expat, zlib with minizip, and libxlsxwriter, compiled from the sources in FLEXSLIP_SOURCES
# (tools/fetch-sources): for WebAssembly, and for a program and a Python module that need no shared
# library. Of NLopt, only the Nelder-Mead simplex is linked, so no LGPL code is.
enable_language(C)
set(BUILD_SHARED_LIBS OFF)
set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)  # options of the subdirectories are those set here
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

foreach(part IN ITEMS CXX PYTHON OCTAVE MATLAB GUILE SWIG TESTS)
  set(NLOPT_${part} OFF)
endforeach()
file(GLOB nlopt ${FLEXSLIP_SOURCES}/nlopt-*/CMakeLists.txt)
if(NOT nlopt)
  message(FATAL_ERROR "FLEXSLIP_SOURCES=${FLEXSLIP_SOURCES} has no sources: tools/fetch-sources fetches them")
endif()
cmake_path(GET nlopt PARENT_PATH nlopt)
set(WITH_THREADLOCAL OFF)  # WebAssembly has one thread; NLopt uses it for an algorithm that is not linked
add_subdirectory(${nlopt} nlopt EXCLUDE_FROM_ALL)
get_target_property(nlopt_folders nlopt INCLUDE_DIRECTORIES)
# This library defines nlopt_optimize, so the linker does not take NLopt's own with all its algorithms.
add_library(nelder_mead STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/nelder_mead.c)
target_include_directories(nelder_mead SYSTEM PRIVATE ${nlopt_folders})
target_include_directories(nelder_mead SYSTEM INTERFACE $<TARGET_PROPERTY:nlopt,INTERFACE_INCLUDE_DIRECTORIES>)
target_link_libraries(nelder_mead PUBLIC nlopt)

foreach(part IN ITEMS BUILD_TOOLS BUILD_EXAMPLES BUILD_TESTS BUILD_DOCS BUILD_PKGCONFIG SHARED_LIBS ENABLE_INSTALL)
  set(EXPAT_${part} OFF)
endforeach()
set(EXPAT_MIN_SIZE ON)
file(GLOB expat ${FLEXSLIP_SOURCES}/libexpat-*/expat/CMakeLists.txt)
cmake_path(GET expat PARENT_PATH expat)
add_subdirectory(${expat} expat EXCLUDE_FROM_ALL)

# Only the files that read and write a workbook.
foreach(part IN ITEMS adler32 crc32 deflate trees inflate inftrees inffast zutil contrib/minizip/ioapi contrib/minizip/zip contrib/minizip/unzip)
  file(GLOB source ${FLEXSLIP_SOURCES}/zlib-*/${part}.c)
  list(APPEND zlib_sources ${source})
endforeach()
file(GLOB zlib_folder ${FLEXSLIP_SOURCES}/zlib-*)
add_library(minizip STATIC EXCLUDE_FROM_ALL ${zlib_sources})
target_include_directories(minizip SYSTEM PUBLIC ${zlib_folder} ${zlib_folder}/contrib)

file(GLOB xlsxwriter_folder ${FLEXSLIP_SOURCES}/libxlsxwriter-*)
file(GLOB xlsxwriter_sources ${xlsxwriter_folder}/src/*.c)
set(third_party ${xlsxwriter_folder}/third_party)
add_library(xlsxwriter STATIC EXCLUDE_FROM_ALL ${xlsxwriter_sources} ${third_party}/tmpfileplus/tmpfileplus.c ${third_party}/md5/md5.c)
target_compile_definitions(xlsxwriter PRIVATE USE_SYSTEM_MINIZIP)
target_include_directories(xlsxwriter SYSTEM PUBLIC ${xlsxwriter_folder}/include)
target_link_libraries(xlsxwriter PRIVATE minizip)

foreach(library IN ITEMS nlopt nelder_mead expat minizip xlsxwriter)
  target_compile_options(${library} PRIVATE -w)
endforeach()
