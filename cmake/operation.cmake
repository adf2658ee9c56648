# tedit_add_operation(NAME fill_hole SOURCES operation.cpp a.cpp [TESTS a_test.cpp] [LINK x] [CONFORMANCE --mesh m])
#
# Builds one operation plugin: a library tedit_op_<NAME>_code, which tests link, and of the same objects the loadable module
# lib/tedit/plugins/<NAME>.so. The conformance kit is a test of its own, conformance.<NAME>; CONFORMANCE gives it further
# options. Outside this tree: tedit_add_plugin.
function(tedit_add_operation)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;TESTS;LINK;CONFORMANCE" ${ARGN})
  add_library(tedit_op_${ARG_NAME}_code STATIC ${ARG_SOURCES})
  target_link_libraries(tedit_op_${ARG_NAME}_code PUBLIC tedit_sdk ${ARG_LINK})
  add_library(tedit_op_${ARG_NAME} MODULE $<TARGET_OBJECTS:tedit_op_${ARG_NAME}_code>)
  target_link_libraries(tedit_op_${ARG_NAME} PRIVATE tedit_sdk ${ARG_LINK})
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
    tedit_add_tests(NAME op_${ARG_NAME} SOURCES ${ARG_TESTS}
                    LINK tedit_op_${ARG_NAME}_code tedit_services GTest::gmock)
  endif()
endfunction()
