# Language level, sanitizers, hardening and warnings. Nothing here is global except what every object of one
# program has to share (language level, sanitizer); warnings belong to dualarm's own targets only.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Precompiled headers and ccache agree only when time macros and the header's own stamp are set aside.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${CCACHE_PROGRAM})
endif()

if(DUALARM_SANITIZER)
  add_compile_options(-fsanitize=${DUALARM_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${DUALARM_SANITIZER})
endif()

# Hardening of every object, for whoever sends the bytes that are parsed (SECURITY.md); tests/server/hardening_test reads
# the programs for it. Sanitizers bring checks of their own, and FORTIFY needs an optimising compiler.
add_link_options(-Wl,-z,relro,-z,now,-z,noexecstack)
if(NOT DUALARM_SANITIZER)
  add_compile_options(-fstack-protector-strong -fstack-clash-protection -fcf-protection)
  if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    add_compile_options(-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
  endif()
endif()
include(CheckPIESupported)
check_pie_supported()

add_library(dualarm_warnings INTERFACE)
target_compile_options(dualarm_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                                  -Wnon-virtual-dtor -Woverloaded-virtual)
if(DUALARM_SANITIZER)
  # gcc 12 sees uninitialised values in its own <regex> once sanitizers instrument it (gcc bug 105562).
  target_compile_options(dualarm_warnings INTERFACE -Wno-maybe-uninitialized)
endif()
if(DUALARM_WARNINGS_AS_ERRORS)
  target_compile_options(dualarm_warnings INTERFACE -Werror)
endif()

# dualarm_library(NAME SOURCES a.cc ... HEADERS a.h ... LINKS targets...): one folder, one library, included from the
# project's root ("geometry/lens.h").
function(dualarm_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(dualarm_${name} STATIC ${ARG_SOURCES})
  add_library(dualarm::${name} ALIAS dualarm_${name})
  target_sources(dualarm_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_HEADERS})
  target_link_libraries(dualarm_${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS} dualarm_warnings)
endfunction()

# dualarm_room(LIBRARY SOURCES a.cc ... HEADERS a.h ...): one folder more of a library whose folders know each other.
function(dualarm_room library)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS" ${ARGN})
  target_sources(dualarm_${library} PRIVATE ${ARG_SOURCES}
                 PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARG_HEADERS})
endfunction()
