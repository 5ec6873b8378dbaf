# What `cmake --install` gives besides the program and its modules: headers, libraries, and the files by which CMake and
# pkg-config find them. None of these names the folder that it is installed in, so that the whole can be moved.
include(CMakePackageConfigHelpers)

install(DIRECTORY src/ volume implicit data_gen DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/isocast
  FILES_MATCHING PATTERN "*.h")
install(FILES cuda/cuda_module.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/isocast/cuda)
install(DIRECTORY apps/scene_build DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/isocast/apps FILES_MATCHING PATTERN "*.h")

# The libraries, each before those that it uses: isocast::isocast, isocast::data_gen ... isocast::src.
set(isocast_libraries isocast isocast_data_gen isocast_implicit isocast_volume_io isocast_volume isocast_src)
foreach(library ${isocast_libraries} isocast_options)
  string(REGEX REPLACE "^isocast_" "" name ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS ${isocast_libraries} isocast_options EXPORT isocast)

# find_package(isocast CONFIG COMPONENTS ...)
set(cmake_files ${CMAKE_INSTALL_LIBDIR}/cmake/isocast)
configure_package_config_file(cmake/isocastConfig.cmake.in isocastConfig.cmake INSTALL_DESTINATION ${cmake_files}
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(isocastConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/isocastConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/isocastConfigVersion.cmake
  cmake/FindSLEEF.cmake DESTINATION ${cmake_files})
install(EXPORT isocast NAMESPACE isocast:: FILE isocastTargets.cmake DESTINATION ${cmake_files})

# pkg-config isocast
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
  OUTPUT_VARIABLE prefix_from_pc)
list(TRANSFORM isocast_libraries PREPEND -l OUTPUT_VARIABLE isocast_link_options)
list(JOIN isocast_link_options " " isocast_link_options)
configure_file(cmake/isocast.pc.in isocast.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/isocast.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
