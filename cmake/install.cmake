# cmake --install build/release --prefix DIR
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS flexslip)
install(TARGETS flexslip_core
  EXPORT FlexSlipTargets
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/flexslip)

# The man page is the target `man`; completions are those found in the build folder.
install(FILES ${PROJECT_BINARY_DIR}/flexslip.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completions/flexslip.bash RENAME flexslip
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completions/_flexslip
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions OPTIONAL)
install(FILES ${PROJECT_BINARY_DIR}/completions/flexslip.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d OPTIONAL)

# For others: find_package(FlexSlip) and link FlexSlip::core.
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/FlexSlip)
install(EXPORT FlexSlipTargets NAMESPACE FlexSlip:: DESTINATION ${config_dir})
install(FILES ${PROJECT_SOURCE_DIR}/cmake/FlexSlipConfig.cmake DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/FlexSlipConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/FlexSlipConfigVersion.cmake DESTINATION ${config_dir})
