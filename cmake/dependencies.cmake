# Every third-party package in one place, found as the distribution ships it.

find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(Imath REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(OpenImageIO REQUIRED)
find_package(OpenMesh REQUIRED)

# Debian 12 ships Embree 3.13, newer systems Embree 4; scene/ray_caster.cpp compiles with both.
find_package(embree 4 QUIET CONFIG)
if(NOT embree_FOUND)
  find_package(embree 3.13 REQUIRED CONFIG)
endif()
message(STATUS "Embree ${embree_VERSION}")

# Debian's OpenImageIO target names include folders of optional packages that it does not depend on; CMake refuses those.
get_target_property(include_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(existing_folders "")
foreach(folder ${include_folders})
  if(EXISTS ${folder})
    list(APPEND existing_folders ${folder})
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${existing_folders}")
