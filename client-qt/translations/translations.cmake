# Translations of the window: tedit_LANGUAGE.ts become share/tedit/translations/tedit_LANGUAGE.qm, in the build as it is
# installed. "cmake --build BUILD --target update_translations" takes new words of the sources into the .ts files.
find_program(TEDIT_LRELEASE NAMES lrelease lrelease-qt6 PATHS /usr/lib/qt6/bin NO_DEFAULT_PATH)
find_program(TEDIT_LUPDATE NAMES lupdate lupdate-qt6 PATHS /usr/lib/qt6/bin NO_DEFAULT_PATH)
if(NOT TEDIT_LRELEASE)
  message(STATUS "The window speaks English only: qt6-l10n-tools, which makes the translations, is not there")
  return()
endif()

set(folder "${CMAKE_BINARY_DIR}/share/tedit/translations")
file(MAKE_DIRECTORY "${folder}")
file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/tedit_*.ts")
foreach(source IN LISTS sources)
  cmake_path(GET source STEM name)
  add_custom_command(
    OUTPUT "${folder}/${name}.qm"
    COMMAND "${TEDIT_LRELEASE}" -silent "${source}" -qm "${folder}/${name}.qm"
    DEPENDS "${source}"
    VERBATIM)
  list(APPEND translations "${folder}/${name}.qm")
endforeach()
add_custom_target(translations ALL DEPENDS ${translations})
add_dependencies(tedit-qt translations)
install(FILES ${translations} DESTINATION share/tedit/translations OPTIONAL)

if(TEDIT_LUPDATE)
  add_custom_target(
    update_translations
    COMMAND "${CMAKE_SOURCE_DIR}/scripts/translations.py" --lupdate "${TEDIT_LUPDATE}" --update
    VERBATIM)
endif()
