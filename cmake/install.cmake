# What `make install` leaves behind: the program, the libraries with their headers, and a package for
# find_package(limpet), which gives limpet::model, limpet::survey and the others. Only the exact build of geometry/ is
# installed, so limpet::model brings it along.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/limpet)

set(folders audit geometry_exact geometry_headers model io survey kinematics following simulation evaluation drawing)
foreach(folder ${folders})
  set_target_properties(limpet_${folder} PROPERTIES EXPORT_NAME ${folder})
  install(TARGETS limpet_${folder} EXPORT limpet ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endforeach()
set_target_properties(limpet_geometry_exact PROPERTIES EXPORT_NAME geometry)

foreach(folder audit geometry model io survey kinematics following simulation evaluation drawing)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/limpet/${folder}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*_internal.hpp" EXCLUDE)
endforeach()

install(TARGETS limpet RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/docs/native_format.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT limpet NAMESPACE limpet:: FILE limpet-targets.cmake DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/limpet-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/limpet-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/limpet-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/limpet-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/limpet-config-version.cmake DESTINATION ${package_dir})
