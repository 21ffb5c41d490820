# A room is a folder of lib/shprt with one subject. Each compiles by itself into an object library, and
# shprt::shprt is all of them together; tests/architecture holds the include arrows between them.

# shprt_room(NAME [LINK third-party targets...])
function(shprt_room name)
  cmake_parse_arguments(ROOM "" "" "LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_library(shprt_${name} OBJECT ${sources})
  target_include_directories(shprt_${name} PUBLIC ${PROJECT_SOURCE_DIR}/lib ${PROJECT_BINARY_DIR}/lib)
  target_link_libraries(shprt_${name} PUBLIC ${ROOM_LINK} PRIVATE $<BUILD_INTERFACE:shprt_settings>)
  set_target_properties(shprt_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  shprt_precompile_from(shprt_${name} shprt_room_headers)
  set_property(GLOBAL APPEND PROPERTY SHPRT_ROOMS ${name})
endfunction()

# shprt_room_test(NAME ROOMS rooms...): the GoogleTest program of one room, linked with just what that room may use.
# Checks compile slowly and seldom compute, so they are hardly optimised; what they check is built as it is shipped.
function(shprt_room_test name)
  cmake_parse_arguments(TEST "" "" "ROOMS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  set(rooms "")
  foreach(room ${TEST_ROOMS})
    if(TARGET shprt_${room})
      list(APPEND rooms shprt_${room})
    endif()
  endforeach()
  add_executable(test_${name} ${sources})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(test_${name} PRIVATE
    SHPRT_SHARED_DIR="${SHPRT_SHARED_DIR}" SHPRT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    SHPRT_TEST_OUTPUT_DIR="${CMAKE_CURRENT_BINARY_DIR}/output/${name}")
  target_link_libraries(test_${name} PRIVATE ${rooms} shprt_settings nlohmann_json::nlohmann_json GTest::gtest GTest::gtest_main)
  target_compile_options(test_${name} PRIVATE ${SHPRT_LIGHT_OPTIMISATION})
  shprt_precompile_from(test_${name} shprt_test_headers)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/output/${name})
  if(SHPRT_TEST_PER_PROGRAM)
    add_test(NAME ${name} COMMAND test_${name})
    set_tests_properties(${name} PROPERTIES COST 200)  # the longest start first, so that no core idles at the end
  else()
    gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 120
      PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
  endif()
endfunction()
