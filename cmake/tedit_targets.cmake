# The few functions that every room's CMakeLists.txt uses.
include(CheckCXXCompilerFlag)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# One interface target carries include path, warnings and sanitizers to every target of ours.
add_library(tedit_options INTERFACE)
target_compile_features(tedit_options INTERFACE cxx_std_20)
target_include_directories(
  tedit_options INTERFACE "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>" "$<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/generated>"
                          "$<INSTALL_INTERFACE:include/tedit>")
# Warnings are for targets of this tree, not for those of who builds a plugin against it: the property says which.
set(TEDIT_OWN_TARGET ON)
define_property(TARGET PROPERTY TEDIT_OWN_TARGET INITIALIZE_FROM_VARIABLE TEDIT_OWN_TARGET
                BRIEF_DOCS "Whether a target is built in TEdit's own tree")
# Vectors of 32 bytes do not cross a function's border (fem/wide.hpp): what GCC notes about passing them is moot.
set(tedit_warnings -Wno-psabi -Wall -Wextra -Wno-missing-field-initializers)
set(own "$<BOOL:$<TARGET_PROPERTY:TEDIT_OWN_TARGET>>")
if(TEDIT_UNITY)
  # Several sources are compiled as one: names local to a file stand beside those of its neighbours, so that a local
  # variable may well be called as another file's function. The dev preset compiles each alone, with all warnings.
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 25)
  list(APPEND tedit_warnings -Wshadow=local -Wno-subobject-linkage)
else()
  list(APPEND tedit_warnings -Wshadow)
endif()
target_compile_options(tedit_options INTERFACE "$<BUILD_INTERFACE:$<${own}:${tedit_warnings}>>" -fvisibility=hidden)
# Nobody asks errno about a square root: without it one is an instruction and no call. Results stay the same to the bit.
target_compile_options(tedit_options INTERFACE "$<BUILD_INTERFACE:$<${own}:-fno-math-errno>>")
if(TEDIT_WERROR)
  # GCC 12 sees joined strings overrun where none does (its bugs 105329 and 105651): those stay warnings.
  target_compile_options(
    tedit_options INTERFACE "$<BUILD_INTERFACE:$<${own}:-Werror;-Wno-error=array-bounds;-Wno-error=restrict>>")
endif()
if(TEDIT_SANITIZE)
  target_compile_options(tedit_options INTERFACE -fsanitize=${TEDIT_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=all)
  target_link_options(tedit_options INTERFACE -fsanitize=${TEDIT_SANITIZE})
  if(TEDIT_SANITIZE MATCHES thread)
    # ThreadSanitizer knows no fences, and GCC warns of each. Asio's only double what its mutexes order already.
    target_compile_definitions(tedit_options INTERFACE BOOST_ASIO_DISABLE_FENCED_BLOCK)
  endif()
endif()

# Debian's binutils bring gold, which links these programs two to four times as fast as the linker that is the default.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold TEDIT_HAS_GOLD)
if(TEDIT_HAS_GOLD AND NOT TEDIT_SANITIZE)
  target_link_options(tedit_options INTERFACE "$<BUILD_INTERFACE:$<${own}:-fuse-ld=gold>>")
endif()

# GCC looks for memory to free again and again while it compiles: without that it takes a sixth less time, and two fifths more
# memory (docs/decisions/log/0026.md).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-expand=400 --param=ggc-min-heapsize=1000000)
endif()
# As many compilers at a time as there are processors, fewer where there is not 2 GB of memory for each (Ninja's own is two
# more than processors).
cmake_host_system_information(RESULT compilers QUERY NUMBER_OF_LOGICAL_CORES)
cmake_host_system_information(RESULT memory_mb QUERY TOTAL_PHYSICAL_MEMORY)
math(EXPR most_compilers "${memory_mb} / 2000")
if(most_compilers LESS compilers)
  set(compilers ${most_compilers})
endif()
if(compilers LESS 1)
  set(compilers 1)
endif()
set_property(GLOBAL APPEND PROPERTY JOB_POOLS tedit_compilers=${compilers})
set(CMAKE_JOB_POOL_COMPILE tedit_compilers)

# For a room whose code runs once for a message, a click or a command, and calls others for what takes time: all of it is
# compiled with -O1, which takes a third less time (docs/decisions/log/0026.md). After this no target of mesh, fem or ops.
macro(tedit_compile_quickly)
  add_compile_options("$<$<CONFIG:Release>:-O1>")
endmacro()

# For a source with std::regex, of which GCC 12 warns when AddressSanitizer is in (GCC bug 105616).
function(tedit_regex_in source)
  if(TEDIT_SANITIZE MATCHES address)
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -Wno-maybe-uninitialized)
  endif()
endfunction()

# tedit_add_library(NAME mesh SOURCES a.cpp b.cpp LINK tedit_base Eigen3::Eigen [PRIVATE_LINK x])
# makes the static library tedit_<NAME>.
function(tedit_add_library)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(tedit_${ARG_NAME} STATIC ${ARG_SOURCES})
  target_link_libraries(tedit_${ARG_NAME} PUBLIC tedit_options ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
endfunction()

# tedit_add_tests(NAME mesh SOURCES a_test.cpp LINK tedit_mesh [LABELS gpu] [TIMEOUT 120])
# makes one GoogleTest program <NAME>_tests and registers each test with ctest. ENDS_ACTORS_EARLY: its tests end actor
# systems while messages are under way, as only the end of a process does; CAF's actors then hold each other, which is no
# leak of ours, and are not looked for.
function(tedit_add_tests)
  cmake_parse_arguments(ARG "ENDS_ACTORS_EARLY" "NAME;TIMEOUT" "SOURCES;LINK;LABELS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 60)
  endif()
  if(TEDIT_SANITIZE)
    math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 10")
  endif()
  add_executable(${ARG_NAME}_tests ${ARG_SOURCES})
  target_link_libraries(${ARG_NAME}_tests PRIVATE tedit_options ${ARG_LINK} GTest::gtest GTest::gtest_main)
  target_compile_definitions(${ARG_NAME}_tests PRIVATE TEDIT_TEST_DATA="${CMAKE_SOURCE_DIR}/tests/data"
                                                       TEDIT_EXAMPLES="${CMAKE_SOURCE_DIR}/examples"
                                                       TEDIT_BIN="${CMAKE_BINARY_DIR}/bin")
  # A test is compiled more often than it runs.
  target_compile_options(${ARG_NAME}_tests PRIVATE "$<$<CONFIG:Release>:-Og>")
  include(GoogleTest)
  set(environment)
  if(ARG_ENDS_ACTORS_EARLY AND TEDIT_SANITIZE MATCHES "address")
    set(environment ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0")
  endif()
  gtest_discover_tests(${ARG_NAME}_tests DISCOVERY_MODE PRE_TEST
                       PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_NAME};${ARG_LABELS}" ${environment})
endfunction()
