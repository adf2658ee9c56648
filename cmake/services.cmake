# Units for systemd and the user that they run as, for the prefix that is installed to.
file(READ "${CMAKE_SOURCE_DIR}/config/systemd/hardening.conf" hardening)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/config/systemd/hardening.conf")
foreach(unit IN ITEMS tedit.service tedit-worker@.service)
  # The prefix is known when it is installed: "@bin@" goes through as it is.
  set(bin "@bin@")
  configure_file("config/systemd/${unit}.in" "${CMAKE_BINARY_DIR}/systemd/${unit}.in" @ONLY)
  # In a folder of its own: several installations may be made at once, each with its prefix.
  install(CODE "set(bin \"\${CMAKE_INSTALL_PREFIX}/bin\")
    string(RANDOM LENGTH 16 own)
    set(own \"${CMAKE_BINARY_DIR}/systemd/\${own}\")
    configure_file(\"${CMAKE_BINARY_DIR}/systemd/${unit}.in\" \"\${own}/${unit}\" @ONLY)
    file(INSTALL DESTINATION \"\${CMAKE_INSTALL_PREFIX}/lib/systemd/system\" TYPE FILE FILES \"\${own}/${unit}\")
    file(REMOVE_RECURSE \"\${own}\")")
endforeach()
install(FILES config/systemd/tedit.sysusers DESTINATION lib/sysusers.d RENAME tedit.conf)
