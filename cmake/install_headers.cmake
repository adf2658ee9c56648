# Installs the headers that others compile against: those given, and what they include, found anew at each installation.
# Runs from cmake/install.cmake with: tree, prefix_folder, headers.
cmake_policy(VERSION 3.25) # An installation script has none.
set(found)
set(left ${headers})
while(left)
  list(POP_FRONT left header)
  if(header IN_LIST found OR NOT EXISTS "${tree}/${header}")
    continue() # Generated and third-party headers come with their own targets.
  endif()
  list(APPEND found "${header}")
  file(STRINGS "${tree}/${header}" includes REGEX "^#include \"")
  list(TRANSFORM includes REPLACE "^#include \"([^\"]+)\".*" "\\1")
  list(APPEND left ${includes})
endwhile()

list(SORT found)
foreach(header IN LISTS found)
  get_filename_component(folder "${header}" DIRECTORY)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/${prefix_folder}/${folder}" TYPE FILE FILES "${tree}/${header}")
endforeach()
