# Headers of others that most files include, compiled once instead of once per file: a third of what a test costs.
#
# Precompiled headers hide missing #include lines. The optimised build therefore precompiles only GoogleTest, which
# every file of tests includes anyway, and compiles the library as it is written; the sanitizer build, which sees the same sources a second time, precompiles the standard library too. A
# compiler cache does better by itself and understands precompiled headers badly, so they are not used together.

set(SHPRT_PRECOMPILE "third-party" CACHE STRING "Precompiled headers: none, third-party, or all (hides missing includes)")
set_property(CACHE SHPRT_PRECOMPILE PROPERTY STRINGS none third-party all)
set(shprt_precompile ${SHPRT_PRECOMPILE})
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(shprt_precompile none)
endif()

set(shprt_standard_headers <algorithm> <array> <cassert> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits>
  <map> <memory> <numbers> <optional> <random> <span> <string> <string_view> <utility> <vector>)

# shprt_precompiled_headers(NAME LINK targets... HEADERS third-party headers...): headers that other targets, compiled
# with the same options, take by shprt_precompile_from(TARGET NAME).
function(shprt_precompiled_headers name)
  cmake_parse_arguments(SET "" "" "LINK;HEADERS" ${ARGN})
  set(headers ${SET_HEADERS})
  if(shprt_precompile STREQUAL "none")
    return()
  elseif(shprt_precompile STREQUAL "all")
    list(PREPEND headers ${shprt_standard_headers})
  endif()
  if(NOT headers)
    return()
  endif()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "// Carries precompiled headers.\n")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_link_libraries(${name} PRIVATE shprt_settings ${SET_LINK})
  target_precompile_headers(${name} PRIVATE ${headers})
endfunction()

function(shprt_precompile_from target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
    # Where the options differ after all, the file is compiled the slow way and says so; the same code comes out.
    target_compile_options(${target} PRIVATE -Wno-error=invalid-pch)
  endif()
endfunction()
