# Install rules: the headers, the target Spider::Spider, and the package config by which find_package(Spider) finds it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(spider_package_dir ${CMAKE_INSTALL_DATADIR}/cmake/Spider)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS Spider EXPORT SpiderTargets)
install(EXPORT SpiderTargets NAMESPACE Spider:: DESTINATION ${spider_package_dir})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SpiderConfig.cmake.in ${PROJECT_BINARY_DIR}/SpiderConfig.cmake
                              INSTALL_DESTINATION ${spider_package_dir} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may break what the last one promised.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SpiderConfigVersion.cmake COMPATIBILITY SameMinorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/Spider_dependencies.cmake ${PROJECT_BINARY_DIR}/SpiderConfig.cmake
              ${PROJECT_BINARY_DIR}/SpiderConfigVersion.cmake DESTINATION ${spider_package_dir})
