# tools/build-package: a package of Debian for each component of install.cmake, by CPack.
set(FLEXSLIP_MAINTAINER "The FlexSlip authors <maintainers@flexslip.invalid>" CACHE STRING "Whom the package names; there is no public address")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME flexslip)
set(CPACK_PACKAGE_VENDOR "The FlexSlip authors")
set(CPACK_PACKAGE_CONTACT ${FLEXSLIP_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program development)
if(TARGET _flexslip)  # python/
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME flexslip)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS libjs-sphinxdoc)  # the search of the site (tools/build-package)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "In three-point bending of fibres the force often drops again and again, as
the specimen slips over its supports. FlexSlip reads off a measured curve what
friction there was, where along the specimen, and with what certainty; whether
the drops can be slips or cracks; and how much of the work was friction. It
reads exports of testing machines and workbooks, writes reports with figures,
and tells before a test what a rig will show.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libflexslip-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libhwy-dev, libnlopt-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The mechanics and the inference of FlexSlip as a static library, with its
headers and what find_package(FlexSlip) looks for.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-flexslip)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(TARGET _flexslip)
  # The module is for one minor version of Python.
  find_package(Python COMPONENTS Interpreter QUIET)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy, python3-scipy")
  # ... and for one binary interface of NumPy.
  if(EXISTS /usr/share/numpy3/versions)
    file(STRINGS /usr/share/numpy3/versions abi REGEX "^abi ")
    string(REPLACE "abi " ", python3-numpy-abi" abi "${abi}")
    string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${abi}")
  endif()
endif()
# Compiled when it is installed, and what was compiled goes with it, as Debian's own modules do.
file(WRITE ${PROJECT_BINARY_DIR}/package/python/postinst
  "#!/bin/sh\nset -e\nif [ \"$1\" = configure ] && command -v py3compile > /dev/null; then\n  py3compile -p python3-flexslip\nfi\n")
file(WRITE ${PROJECT_BINARY_DIR}/package/python/prerm
  "#!/bin/sh\nset -e\nif command -v py3clean > /dev/null; then\n  py3clean -p python3-flexslip\nfi\n")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/package/python/postinst ${PROJECT_BINARY_DIR}/package/python/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-pandas")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "What the program flexslip computes, as a Python module with NumPy arrays in
and out, and results as objects.")

# What Debian asks of every package: the licence, and what changed, in a form of its own.
find_program(GZIP gzip)
if(GZIP)
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
  string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
  string(REGEX REPLACE "\n" "\n " licence "${licence}")
  string(STRIP "${licence}" licence)
  file(WRITE ${PROJECT_BINARY_DIR}/package/copyright
    "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: FlexSlip\n\nFiles: *\nCopyright: 2026 The FlexSlip authors\nLicense: BSD-3-Clause\n ${licence}\n")
  string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)
  foreach(package IN ITEMS flexslip libflexslip-dev python3-flexslip)
    file(WRITE ${PROJECT_BINARY_DIR}/package/${package}/changelog.Debian
      "flexslip (${PROJECT_VERSION}-1) unstable; urgency=medium\n\n  * Version ${PROJECT_VERSION}: see changelog.gz.\n\n -- ${FLEXSLIP_MAINTAINER}  ${today}\n")
    configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_BINARY_DIR}/package/${package}/changelog COPYONLY)
    execute_process(COMMAND ${GZIP} --best --no-name --force changelog changelog.Debian WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/package/${package})
  endforeach()
  foreach(pair IN ITEMS program/flexslip development/libflexslip-dev python/python3-flexslip)
    cmake_path(GET pair PARENT_PATH component)
    cmake_path(GET pair FILENAME package)
    set(of ${PROJECT_BINARY_DIR}/package)
    install(FILES ${of}/copyright ${of}/${package}/changelog.gz ${of}/${package}/changelog.Debian.gz
      DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
  endforeach()
endif()
include(CPack)
