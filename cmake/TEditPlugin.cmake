# tedit_add_plugin(NAME offset SOURCES operation.cpp a.cpp [TESTS a_test.cpp] [LINK x] [CONFORMANCE --mesh part.msh])
#
# Builds a plugin outside TEdit's tree: the loadable module <NAME>.so; the first source holds TEDIT_PLUGIN. TESTS makes
# the GoogleTest program <NAME>_tests. The conformance kit is the test conformance.<NAME>; CONFORMANCE gives it further
# options. "cmake --install build --prefix ~/.local" puts the plugin where every tedit of the user finds it.
enable_testing() # Here, because inside a function it would end with the function.

function(tedit_add_plugin)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;TESTS;LINK;CONFORMANCE" ${ARGN})
  if(NOT ARG_NAME OR NOT ARG_SOURCES)
    message(FATAL_ERROR "tedit_add_plugin needs NAME and SOURCES")
  endif()
  list(GET ARG_SOURCES 0 entry)
  add_library(${ARG_NAME}_code STATIC ${ARG_SOURCES})
  target_compile_features(${ARG_NAME}_code PUBLIC cxx_std_20)
  target_link_libraries(${ARG_NAME}_code PUBLIC TEdit::sdk ${ARG_LINK})
  add_library(${ARG_NAME} MODULE ${entry})
  target_link_libraries(${ARG_NAME} PRIVATE ${ARG_NAME}_code)
  set_target_properties(${ARG_NAME}_code PROPERTIES POSITION_INDEPENDENT_CODE ON)
  set_target_properties(${ARG_NAME} PROPERTIES PREFIX "")
  install(TARGETS ${ARG_NAME} LIBRARY DESTINATION share/tedit/plugins)

  if(ARG_TESTS)
    find_package(GTest REQUIRED)
    include(GoogleTest)
    add_executable(${ARG_NAME}_tests ${ARG_TESTS})
    target_link_libraries(${ARG_NAME}_tests PRIVATE ${ARG_NAME}_code TEdit::services TEdit::io GTest::gmock
                                                    GTest::gtest_main)
    gtest_discover_tests(${ARG_NAME}_tests DISCOVERY_MODE PRE_TEST)
  endif()
  add_test(NAME conformance.${ARG_NAME} COMMAND TEdit::tedit plugin test $<TARGET_FILE:${ARG_NAME}> ${ARG_CONFORMANCE})
endfunction()
