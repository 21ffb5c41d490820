# Reads every #include of lib/ and tools/ and fails on an arrow that docs/architecture.md does not draw, on a third-party
# header outside its one door, and on anything that includes tools.
# Run: cmake -DSOURCE_DIR=... -P check_includes.cmake

cmake_minimum_required(VERSION 3.22)

set(base_may "")
set(sh_may "")
set(codegen_may sh)
set(sampling_may "")
set(image_may "")
set(mesh_may "")
set(scene_may mesh image)
set(coefficients_may sh)
set(transfer_may mesh scene sampling sh coefficients)
set(light_may image sampling sh coefficients)
set(relight_may coefficients light sh)
set(picture_may scene mesh image coefficients relight)
set(report_may image sh coefficients transfer light relight)
set(study_may sh sampling image mesh scene coefficients transfer light relight report)
set(tools_may base sh codegen sampling image mesh scene coefficients transfer light relight picture report study)

# third-party prefix -> the files that may include it
set(doors
  "OpenMesh/=lib/shprt/mesh/openmesh_import.cpp"
  "OpenImageIO/=lib/shprt/image/.*\\.cpp"
  "embree=lib/shprt/scene/.*\\.cpp"
  "OpenEXR/=lib/shprt/coefficients/.*"
  "Imath=lib/shprt/coefficients/.*\\.cpp"
  "Imf=lib/shprt/coefficients/.*\\.cpp"
  "nlohmann/=lib/shprt/.*\\.cpp|lib/shprt/base/json_input\\.h|tools/shprt/.*"
  "tbb/=lib/shprt/base/.*\\.cpp"
  "openssl/=lib/shprt/base/.*\\.cpp"
  "CLI/=tools/shprt/.*"
  "spdlog/=tools/shprt/.*")

set(problems 0)
set(arrows 0)
file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/lib/shprt/*.h ${SOURCE_DIR}/lib/shprt/*.cpp
     ${SOURCE_DIR}/tools/shprt/*.h ${SOURCE_DIR}/tools/shprt/*.cpp)
foreach(file ${files})
  if(file MATCHES "^lib/shprt/([a-z]+)/")
    set(room ${CMAKE_MATCH_1})
  else()
    set(room tools)
  endif()
  if(NOT DEFINED ${room}_may)
    message(SEND_ERROR "${file}: the room '${room}' is not in docs/architecture.md")
    math(EXPR problems "${problems}+1")
  endif()
  file(STRINGS ${SOURCE_DIR}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line ${lines})
    if(NOT line MATCHES "[<\"]([^>\"]+)[>\"]")
      continue()
    endif()
    set(included ${CMAKE_MATCH_1})
    if(included MATCHES "^tools/" AND NOT room STREQUAL "tools")
      message(SEND_ERROR "${file} includes ${included}: nothing includes tools")
      math(EXPR problems "${problems}+1")
    endif()
    if(included MATCHES "^shprt/([a-z]+)/")
      math(EXPR arrows "${arrows}+1")
      set(target ${CMAKE_MATCH_1})
      if(NOT target STREQUAL room AND NOT target STREQUAL "base" AND NOT target IN_LIST ${room}_may)
        message(SEND_ERROR "${file} includes ${included}: '${room}' may not use '${target}'")
        math(EXPR problems "${problems}+1")
      endif()
    endif()
    foreach(door ${doors})
      string(REGEX MATCH "^([^=]+)=(.*)$" unused "${door}")
      set(prefix ${CMAKE_MATCH_1})
      set(allowed ${CMAKE_MATCH_2})
      if(included MATCHES "^${prefix}" AND NOT file MATCHES "^(${allowed})$")
        message(SEND_ERROR "${file} includes ${included}: that header has one door, ${allowed}")
        math(EXPR problems "${problems}+1")
      endif()
    endforeach()
  endforeach()
endforeach()
if(arrows EQUAL 0)
  message(FATAL_ERROR "no include was read: is SOURCE_DIR right?")
endif()
if(problems)
  message(FATAL_ERROR "${problems} forbidden includes")
endif()
message(STATUS "${arrows} includes checked, all along the arrows")
