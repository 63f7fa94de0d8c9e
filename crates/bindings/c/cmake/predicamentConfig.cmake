# find_package(predicament) defines these targets:
#   predicament::shared       the shared library, if it is installed
#   predicament::static       the static library, if it is installed
#   predicament::predicament  the shared library, or the static one if BUILD_SHARED_LIBS is OFF or the other is missing
#
# The file is in PREFIX/lib/cmake/predicament or in PREFIX/share/cmake/predicament. It can be moved with the prefix.

get_filename_component(_predicament_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

find_path(predicament_INCLUDE_DIR predicament.h HINTS "${_predicament_prefix}/include" NO_DEFAULT_PATH)
find_library(predicament_SHARED_LIBRARY
    NAMES "${CMAKE_SHARED_LIBRARY_PREFIX}predicament${CMAKE_SHARED_LIBRARY_SUFFIX}"
    HINTS "${_predicament_prefix}" PATH_SUFFIXES lib lib64 "lib/${CMAKE_LIBRARY_ARCHITECTURE}" NO_DEFAULT_PATH)
find_library(predicament_STATIC_LIBRARY
    NAMES "${CMAKE_STATIC_LIBRARY_PREFIX}predicament${CMAKE_STATIC_LIBRARY_SUFFIX}"
    HINTS "${_predicament_prefix}" PATH_SUFFIXES lib lib64 "lib/${CMAKE_LIBRARY_ARCHITECTURE}" NO_DEFAULT_PATH)
mark_as_advanced(predicament_INCLUDE_DIR predicament_SHARED_LIBRARY predicament_STATIC_LIBRARY)

if(NOT predicament_INCLUDE_DIR OR NOT (predicament_SHARED_LIBRARY OR predicament_STATIC_LIBRARY))
    set(predicament_FOUND FALSE)
    set(predicament_NOT_FOUND_MESSAGE "predicament.h or the library is missing in ${_predicament_prefix}")
    return()
endif()

if(predicament_SHARED_LIBRARY AND NOT TARGET predicament::shared)
    add_library(predicament::shared SHARED IMPORTED)
    set_target_properties(predicament::shared PROPERTIES
        IMPORTED_LOCATION "${predicament_SHARED_LIBRARY}"
        IMPORTED_NO_SONAME TRUE
        INTERFACE_INCLUDE_DIRECTORIES "${predicament_INCLUDE_DIR}")
endif()

if(predicament_STATIC_LIBRARY AND NOT TARGET predicament::static)
    add_library(predicament::static STATIC IMPORTED)
    find_package(Threads REQUIRED)
    set_target_properties(predicament::static PROPERTIES
        IMPORTED_LOCATION "${predicament_STATIC_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${predicament_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "Threads::Threads;${CMAKE_DL_LIBS};m")
endif()

if(NOT TARGET predicament::predicament)
    add_library(predicament::predicament INTERFACE IMPORTED)
    if(TARGET predicament::static AND (NOT TARGET predicament::shared OR (DEFINED BUILD_SHARED_LIBS AND NOT BUILD_SHARED_LIBS)))
        set_target_properties(predicament::predicament PROPERTIES INTERFACE_LINK_LIBRARIES predicament::static)
    else()
        set_target_properties(predicament::predicament PROPERTIES INTERFACE_LINK_LIBRARIES predicament::shared)
    endif()
endif()
