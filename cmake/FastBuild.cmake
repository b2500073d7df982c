# What makes building quicker where it is installed; a choice of one's own (a launcher, -fuse-ld) stays as it is.
# `cmake -DCOUNTERPART_FAST_BUILD=OFF` leaves it out.
option(COUNTERPART_FAST_BUILD "Use ccache, and mold or lld, where they are installed" ${PROJECT_IS_TOP_LEVEL})
if(NOT COUNTERPART_FAST_BUILD)
  return()
endif()

find_program(COUNTERPART_CCACHE ccache)
if(COUNTERPART_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT DEFINED ENV{CMAKE_CXX_COMPILER_LAUNCHER})
  # Without these two it does not trust precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${COUNTERPART_CCACHE})
endif()

# A wheel's module is rewritten by auditwheel: it is linked by the system's own.
include(CheckLinkerFlag)
if(NOT "${CMAKE_EXE_LINKER_FLAGS} ${CMAKE_CXX_FLAGS} $ENV{LDFLAGS}" MATCHES "-fuse-ld" AND NOT COUNTERPART_FUZZ AND NOT SKBUILD
   AND NOT CMAKE_CROSSCOMPILING)
  foreach(linker mold lld)
    check_linker_flag(CXX -fuse-ld=${linker} COUNTERPART_HAS_${linker})
    if(COUNTERPART_HAS_${linker})
      add_link_options(-fuse-ld=${linker})
      break()
    endif()
  endforeach()
endif()
