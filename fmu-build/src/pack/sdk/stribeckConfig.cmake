# Stribeck @VERSION@ for C and C++, for find_package(stribeck): the targets stribeck::stribeck, the shared library, and
# stribeck::static. The folder may be anywhere.
cmake_minimum_required(VERSION 3.15)

get_filename_component(stribeck_folder "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

foreach(stribeck_file IN ITEMS "include/stribeck.h" "@SHARED@" "lib/libstribeck.a")
  if(NOT EXISTS "${stribeck_folder}/${stribeck_file}")
    set(stribeck_FOUND FALSE)
    set(stribeck_NOT_FOUND_MESSAGE "${stribeck_folder} has no ${stribeck_file}")
    return()
  endif()
endforeach()

if(NOT TARGET stribeck::stribeck)
  add_library(stribeck::stribeck SHARED IMPORTED)
  set_target_properties(stribeck::stribeck PROPERTIES
    IMPORTED_LOCATION "${stribeck_folder}/@SHARED@"@IMPORT@
    INTERFACE_INCLUDE_DIRECTORIES "${stribeck_folder}/include")
  add_library(stribeck::static STATIC IMPORTED)
  set_target_properties(stribeck::static PROPERTIES
    IMPORTED_LOCATION "${stribeck_folder}/lib/libstribeck.a"
    IMPORTED_LINK_INTERFACE_LANGUAGES C
    INTERFACE_LINK_LIBRARIES "@NEEDS@"
    INTERFACE_INCLUDE_DIRECTORIES "${stribeck_folder}/include")
endif()

unset(stribeck_file)
unset(stribeck_folder)
