# cmake --install build/release --prefix DIR
#
# Three components: program (with its man page, completions and examples), development (what
# find_package(FlexSlip) finds), and python, if it is built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
set(FLEXSLIP_ZSH_FOLDER site-functions CACHE STRING "Where zsh looks below share/zsh: vendor-completions for a package of Debian")

install(TARGETS flexslip COMPONENT program)
function(flexslip_name_if_missing file target)
  install(CODE "if(NOT EXISTS ${PROJECT_BINARY_DIR}/${file})
    message(WARNING \"Not installed: ${file}, which is not built. Build the target ${target} first.\")
  endif()" COMPONENT program)
endfunction()
flexslip_name_if_missing(man/flexslip.1 man)
flexslip_name_if_missing(completions/flexslip.bash completions)
install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completions/flexslip.bash RENAME flexslip
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completions/_flexslip
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${FLEXSLIP_ZSH_FOLDER} COMPONENT program OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completions/flexslip.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program OPTIONAL)

install(FILES ${PROJECT_SOURCE_DIR}/build/studio/flexslip-studio.html DESTINATION ${CMAKE_INSTALL_DATADIR}/flexslip COMPONENT program OPTIONAL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/flexslip/examples COMPONENT program)
# README.md and what it links to.
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CITATION.cff
  ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/flexslip COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/flexslip COMPONENT program)
install(DIRECTORY ${PROJECT_BINARY_DIR}/licences/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/flexslip COMPONENT program OPTIONAL)

# For others: find_package(FlexSlip) and link FlexSlip::FlexSlip. The shared library loads those of the distribution.
if(NOT FLEXSLIP_SOURCES)
  install(TARGETS flexslip_library
    EXPORT FlexSlipTargets
    LIBRARY COMPONENT development
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/FlexSlip)
  install(EXPORT FlexSlipTargets NAMESPACE FlexSlip:: DESTINATION ${config_dir} COMPONENT development)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/FlexSlipConfig.cmake DESTINATION ${config_dir} COMPONENT development)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/FlexSlipConfigVersion.cmake COMPATIBILITY SameMajorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/FlexSlipConfigVersion.cmake DESTINATION ${config_dir} COMPONENT development)
endif()
