# What "cmake --install" puts under a prefix: programs, plugins, and what it takes to build a plugin outside this tree
# (docs/plugins.md). bin/ finds lib/tedit/plugins beside itself, so the prefix may be moved. The build tree offers the
# same package in lib/cmake/TEdit.
include(CMakePackageConfigHelpers)

install(TARGETS tedit tedit-probe tedit-tetgen RUNTIME DESTINATION bin)
if(TARGET tedit-render)
  install(TARGETS tedit-render RUNTIME DESTINATION bin)
endif()
if(TARGET tedit-qt)
  include(client-qt/install.cmake)
endif()
install(FILES config/tedit.toml config/materials.json DESTINATION share/tedit)
install(DIRECTORY examples DESTINATION share/tedit)

foreach(name IN ITEMS options base mesh io sdk services)
  set_target_properties(tedit_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS tedit_${name} EXPORT TEditTargets ARCHIVE DESTINATION lib/tedit COMPONENT dev)
endforeach()
install(DIRECTORY base mesh DESTINATION include/tedit COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ops/sdk ops/services DESTINATION include/tedit/ops COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY tests/support DESTINATION include/tedit/tests COMPONENT dev FILES_MATCHING PATTERN "*.hpp")

set(package "${CMAKE_BINARY_DIR}/lib/cmake/TEdit")
configure_file(cmake/TEditConfig.cmake.in "${package}/TEditConfig.cmake" @ONLY)
configure_file(cmake/TEditPlugin.cmake "${package}/TEditPlugin.cmake" COPYONLY)
write_basic_package_version_file("${package}/TEditConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${package}/TEditConfig.cmake" "${package}/TEditConfigVersion.cmake" "${package}/TEditPlugin.cmake"
        DESTINATION lib/cmake/TEdit COMPONENT dev)
install(EXPORT TEditTargets NAMESPACE TEdit:: DESTINATION lib/cmake/TEdit COMPONENT dev)
export(EXPORT TEditTargets NAMESPACE TEdit:: FILE "${package}/TEditTargets.cmake")
install(FILES docs/man/tedit.1 DESTINATION share/man/man1)
install(FILES LICENSE NOTICE README.md CHANGELOG.md DESTINATION share/doc/tedit)
