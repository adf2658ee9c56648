# tedit_add_operation(NAME fill_hole SOURCES operation.cpp a.cpp [TESTS a_test.cpp] [LINK x] [CONFORMANCE --mesh m])
#
# Builds one operation plugin: a library tedit_op_<NAME>_code, which tests link, and the loadable module
# lib/tedit/plugins/<NAME>.so. The first source holds TEDIT_PLUGIN and is the module's alone: each plugin has one. The conformance kit is
# a test of its own, conformance.<NAME>; CONFORMANCE gives it further options. Outside this tree: tedit_add_plugin.
function(tedit_add_operation)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;TESTS;LINK;CONFORMANCE" ${ARGN})
  list(POP_FRONT ARG_SOURCES entry)
  if(ARG_SOURCES)
    add_library(tedit_op_${ARG_NAME}_code STATIC ${ARG_SOURCES})
    target_link_libraries(tedit_op_${ARG_NAME}_code PUBLIC tedit_sdk ${ARG_LINK})
  else()
    add_library(tedit_op_${ARG_NAME}_code INTERFACE)
    target_link_libraries(tedit_op_${ARG_NAME}_code INTERFACE tedit_sdk ${ARG_LINK})
  endif()
  add_library(tedit_op_${ARG_NAME} MODULE ${entry})
  target_link_libraries(tedit_op_${ARG_NAME} PRIVATE tedit_op_${ARG_NAME}_code)
  set_target_properties(
    tedit_op_${ARG_NAME}
    PROPERTIES PREFIX ""
               OUTPUT_NAME ${ARG_NAME}
               LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib/tedit/plugins")
  install(TARGETS tedit_op_${ARG_NAME} LIBRARY DESTINATION lib/tedit/plugins)
  if(TEDIT_TESTS)
    add_test(NAME conformance.${ARG_NAME} COMMAND tedit plugin test $<TARGET_FILE:tedit_op_${ARG_NAME}>
                                                  ${ARG_CONFORMANCE})
    set_tests_properties(conformance.${ARG_NAME} PROPERTIES LABELS "conformance;op_${ARG_NAME}" TIMEOUT 600)
  endif()
  if(TEDIT_TESTS AND ARG_TESTS)
    find_package(GTest REQUIRED)
    if(NOT ARG_SOURCES)
      list(APPEND ARG_TESTS ${entry}) # All of its code: the tests come in by the entry.
    endif()
    tedit_add_tests(NAME op_${ARG_NAME} SOURCES ${ARG_TESTS}
                    LINK tedit_op_${ARG_NAME}_code tedit_services GTest::gmock)
  endif()
endfunction()
