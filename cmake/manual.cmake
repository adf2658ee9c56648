# The HTML manual: share/doc/tedit/html, in the build as it is installed.
find_program(TEDIT_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)  # Debian's: the one that has its packages.
if(TEDIT_PYTHON)
  execute_process(COMMAND "${TEDIT_PYTHON}" -c "import markdown" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
endif()
if(NOT TEDIT_PYTHON OR failed)
  message(STATUS "The HTML manual is left out: python3-markdown is not there")
  return()
endif()

set(folder "${CMAKE_BINARY_DIR}/share/doc/tedit/html")
file(GLOB documents CONFIGURE_DEPENDS docs/*.md docs/*.png docs/*.svg docs/pictures/* ops/*/README.md clients/*/README.md)
add_custom_command(
  OUTPUT "${folder}/index.html"
  COMMAND "${TEDIT_PYTHON}" "${CMAKE_SOURCE_DIR}/scripts/manual.py" "${folder}"
  DEPENDS ${documents} scripts/manual.py
  WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}"
  VERBATIM)
add_custom_target(manual ALL DEPENDS "${folder}/index.html")
install(DIRECTORY "${folder}" DESTINATION share/doc/tedit OPTIONAL)
tedit_say_left_out("${folder}/index.html" "The HTML manual" manual)
if(TEDIT_TESTS)
  add_test(NAME manual.links COMMAND "${TEDIT_PYTHON}" "${CMAKE_SOURCE_DIR}/tests/scripts/manual_test.py" "${folder}")
endif()
