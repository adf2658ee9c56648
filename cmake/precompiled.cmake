# Headers of other projects that most sources of a kind read, parsed once instead of once a file (half of a cold build
# was parsing). Headers of ours are not among them: touching one must not build everything anew. Every source still
# includes what it uses: builds with sanitizers have none of this and would miss it.
option(TEDIT_PRECOMPILED "Parse common headers of other projects once" ON)
if(TEDIT_SANITIZE)
  set(TEDIT_PRECOMPILED OFF)
endif()

set(tedit_std_headers <algorithm> <array> <chrono> <cmath> <cstdint> <functional> <map> <memory> <optional>
                      <set> <span> <string> <string_view> <unordered_map> <unordered_set> <utility> <variant> <vector>)

# tedit_precompile(TARGET [header...]) gives a target headers of its own beside the standard library's.
function(tedit_precompile target)
  if(TEDIT_PRECOMPILED)
    target_precompile_headers(${target} PRIVATE ${tedit_std_headers} ${ARGN})
  endif()
endfunction()

# tedit_precompile_as(TARGET KIND [header...]) does that where headers are given; else the target uses those of
# tedit_precompiled_<KIND>, unless it has too few sources to be worth it.
function(tedit_precompile_as target kind)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  if(ARGN)
    tedit_precompile(${target} ${ARGN})
  elseif(TEDIT_PRECOMPILED AND count GREATER 2)
    target_precompile_headers(${target} REUSE_FROM tedit_precompiled_${kind})
  endif()
endfunction()

if(TEDIT_PRECOMPILED)
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/generated/precompiled/library.cpp" CONTENT "" @ONLY)
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/generated/precompiled/program.cpp" CONTENT "int main() {}\n" @ONLY)
  add_library(tedit_precompiled_library OBJECT "${CMAKE_BINARY_DIR}/generated/precompiled/library.cpp")
  target_link_libraries(tedit_precompiled_library PRIVATE tedit_options)
  tedit_precompile(tedit_precompiled_library)
  if(TEDIT_TESTS)
    add_executable(tedit_precompiled_tests "${CMAKE_BINARY_DIR}/generated/precompiled/program.cpp")
    target_link_libraries(tedit_precompiled_tests PRIVATE tedit_options GTest::gtest GTest::gmock)
    tedit_precompile(tedit_precompiled_tests <fstream> <gmock/gmock.h> <gtest/gtest.h> <nlohmann/json.hpp>)
  endif()
endif()
