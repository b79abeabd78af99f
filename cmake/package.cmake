# The package of Debian that tools/build-release makes of the static program, by CPack. It needs no
# other package, so it installs on Debian 11 to 13 and on Ubuntu.
if(NOT FLEXSLIP_SOURCES)
  return()
endif()
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
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME flexslip)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot")  # draws the figures of a report
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "In three-point bending of fibres and bars the force often drops again and
again, because the specimen slips over its supports. FlexSlip finds from a
measured curve whether the drops can be slips or cracks, how large the friction
was, and how much of the work was friction. It reads exports of testing machines
and workbooks, writes reports with figures, and predicts before a test what a
rig will show.")
include(CPack)
