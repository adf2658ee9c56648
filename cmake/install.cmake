# What "cmake --install" puts under a prefix: programs, plugins, and what it takes to build a plugin (docs/plugins.md)
# or a client (docs/integrate.md) outside this tree. bin/ finds lib/tedit/plugins beside itself, so the prefix may be moved. The build tree offers the
# same package in lib/cmake/TEdit.
include(CMakePackageConfigHelpers)

# What a build may leave out ("scripts/run.sh" builds the program without window and manual) is left out of the
# installation, too, and said. Packages hold all: cpack builds before it packs.
function(tedit_say_left_out file what target)
  install(CODE "if(NOT EXISTS \"${file}\")
    message(STATUS \"${what} is left out: it was not built (cmake --build ${CMAKE_BINARY_DIR} --target ${target})\")
  endif()")
endfunction()

# tedit_install_along(PROGRAM DESTINATION file [RENAME name]): a file that makes sense only with a program.
function(tedit_install_along program destination file)
  cmake_parse_arguments(ARG "" "RENAME" "" ${ARGN})
  set(rename)
  if(ARG_RENAME)
    set(rename "RENAME \"${ARG_RENAME}\"")
  endif()
  install(CODE "if(EXISTS \"$<TARGET_FILE:${program}>\")
    file(INSTALL DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${destination}\" TYPE FILE ${rename} FILES \"${CMAKE_SOURCE_DIR}/${file}\")
  endif()")
endfunction()

install(TARGETS tedit tedit-probe tedit-mesher RUNTIME DESTINATION bin)
if(TARGET tedit-cad-reader)
  install(TARGETS tedit-cad-reader tedit-cad-mesher tedit-cad-editor tedit-cad-writer RUNTIME DESTINATION bin)
endif()
if(TARGET tedit-med)
  install(TARGETS tedit-med RUNTIME DESTINATION bin)
endif()
if(TARGET tedit-scan-reader)
  install(TARGETS tedit-scan-reader tedit-scan-mesher RUNTIME DESTINATION bin)
endif()
if(TARGET tedit-render)
  install(TARGETS tedit-render RUNTIME DESTINATION bin)
endif()
if(TARGET tedit-qt)
  include(client-qt/install.cmake)
endif()
install(FILES config/tedit.toml config/materials.json DESTINATION share/tedit)
install(DIRECTORY examples DESTINATION share/tedit USE_SOURCE_PERMISSIONS)

foreach(name IN ITEMS options base mesh io sdk tools text_tools file_tools mesher boolean services)
  set_target_properties(tedit_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS tedit_${name} EXPORT TEditTargets ARCHIVE DESTINATION lib/tedit COMPONENT dev)
endforeach()
# What an integrator links: a set of its own, so that plugins need no protobuf.
foreach(name IN ITEMS fem_receipt messages protocol certs tls client)
  set_target_properties(tedit_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS tedit_${name} EXPORT TEditClientTargets ARCHIVE DESTINATION lib/tedit COMPONENT dev)
endforeach()
# What a program links that is a node of a server.
foreach(name IN ITEMS links logging fem_core network node)
  set_target_properties(tedit_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS tedit_${name} EXPORT TEditNodeTargets ARCHIVE DESTINATION lib/tedit COMPONENT dev)
endforeach()
# Headers: what docs/plugins.md, docs/protocol.md and docs/integrate.md tell of, and what these include. Nothing else of base/ and mesh/ is
# for others, nor what the operations of this tree share (ops/shapes).
set(plugin_headers
    ops/sdk/operation.hpp ops/tools/files/surface_file.hpp ops/tools/sweep.hpp ops/tools/text/text_outlines.hpp ops/tools/tools.hpp
    # Documented beside it.
    base/attachment.hpp base/parallel.hpp mesh/checks.hpp mesh/features/hole.hpp mesh/features/rims.hpp mesh/quality.hpp
    # For tests of plugins.
    mesh/finish_edit.hpp mesh/io/import.hpp ops/services/host_services.hpp tests/support/meshes.hpp)
set(node_headers node/node.hpp fem/calculix_deck.hpp)
file(GLOB client_headers CONFIGURE_DEPENDS RELATIVE "${CMAKE_SOURCE_DIR}" client/*.hpp protocol/*.hpp)
install(
  CODE "set(tree \"${CMAKE_SOURCE_DIR}\")
  set(prefix_folder include/tedit)
  set(headers ${plugin_headers} ${client_headers} ${node_headers})
  include(\"${CMAKE_SOURCE_DIR}/cmake/install_headers.cmake\")"
  COMPONENT dev)
install(DIRECTORY protocol/tedit DESTINATION share/tedit/protocol FILES_MATCHING PATTERN "*.proto")
# The packages for other languages.
set(python_package "${CMAKE_BINARY_DIR}/clients/python/tedit")
install(DIRECTORY "${python_package}" DESTINATION lib/python3/dist-packages COMPONENT dev OPTIONAL PATTERN "__pycache__" EXCLUDE)
tedit_say_left_out("${python_package}/__init__.py" "The Python client" python_client)
set(npm_package "${CMAKE_BINARY_DIR}/clients/typescript/tedit-client.tgz")
install(FILES "${npm_package}" DESTINATION share/tedit COMPONENT dev OPTIONAL)
tedit_say_left_out("${npm_package}" "The TypeScript client" typescript_client)

set(package "${CMAKE_BINARY_DIR}/lib/cmake/TEdit")
configure_file(cmake/TEditConfig.cmake.in "${package}/TEditConfig.cmake" @ONLY)
configure_file(cmake/TEditPlugin.cmake "${package}/TEditPlugin.cmake" COPYONLY)
configure_file(cmake/FindCAF.cmake "${package}/FindCAF.cmake" COPYONLY)
write_basic_package_version_file("${package}/TEditConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${package}/TEditConfig.cmake" "${package}/TEditConfigVersion.cmake" "${package}/TEditPlugin.cmake" "${package}/FindCAF.cmake"
        DESTINATION lib/cmake/TEdit COMPONENT dev)
foreach(set IN ITEMS TEditTargets TEditClientTargets TEditNodeTargets)
  install(EXPORT ${set} NAMESPACE TEdit:: DESTINATION lib/cmake/TEdit COMPONENT dev)
  export(EXPORT ${set} NAMESPACE TEdit:: FILE "${package}/${set}.cmake")
endforeach()
install(FILES docs/man/tedit.1 DESTINATION share/man/man1)
install(FILES cli/completion.bash DESTINATION share/bash-completion/completions RENAME tedit)
install(FILES LICENSE NOTICE README.md CHANGELOG.md DESTINATION share/doc/tedit)
