# What "cpack --config build/release/CPackConfig.cmake" makes: two Debian packages. tedit has the programs, plugins,
# examples and manuals; tedit-dev what it takes to build a plugin (docs/plugins.md).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tedit)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "The TEdit maintainers <maintainers@tedit.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "change a meshed part, see its stress at once")
set(CPACK_PACKAGE_DESCRIPTION
    "TEdit edits parts that already have a tetrahedral mesh (or a STEP, IGES or BREP file), CAD surface ids and load cases (close a drill hole,
thin a plate, take off a rib) and shows the new stress field at once, without remeshing. A server with
worker processes, a command line, a desktop client, and operations as plugins.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL tedit dev)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TEDIT_PACKAGE_NAME tedit)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME tedit-dev)
# What is found at run time only: the Vulkan loader; a software device, and a display where there is none.
set(CPACK_DEBIAN_TEDIT_PACKAGE_DEPENDS "libvulkan1, fonts-dejavu-core")
set(CPACK_DEBIAN_TEDIT_PACKAGE_RECOMMENDS "mesa-vulkan-drivers, xvfb, qt6-translations-l10n")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "tedit (= ${PROJECT_VERSION}), g++, cmake (>= 3.25), libexpected-dev, libeigen3-dev, libcgal-dev, libpugixml-dev, zlib1g-dev, libgtest-dev, libprotobuf-dev, protobuf-compiler, libcaf-dev, libssl-dev, libspdlog-dev, libzstd-dev, pkg-config")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "libfreetype-dev, python3-numpy, python3-protobuf, python3-websockets")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers, libraries and CMake files to build plugins for TEdit, and programs that drive its server.")

include(CPack)
