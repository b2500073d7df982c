# counterpart_add_component(NAME SOURCES...): the library counterpart_NAME, for users counterpart::NAME.
function(counterpart_add_component name)
  set(target counterpart_${name})
  add_library(${target} ${ARGN})
  add_library(counterpart::${name} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE src)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  if(NOT EMSCRIPTEN)  # which links all into one module
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  counterpart_configure_target(${target})
  counterpart_compile_by_folder(${target})
  if(NOT COUNTERPART_PRECOMPILED_HEADERS)
    return()
  elseif(name STREQUAL "core")
    target_precompile_headers(${target} PRIVATE
      <Eigen/Core> <Eigen/Geometry> <Eigen/LU> <Eigen/SparseCore> <algorithm> <array> <cmath> <filesystem> <functional> <memory>
      <numeric> <optional> <string> <utility> <vector> <fmt/format.h>)
    if(COUNTERPART_THREADS STREQUAL "tbb")
      target_precompile_headers(${target} PRIVATE <tbb/parallel_for.h> <tbb/parallel_invoke.h> <tbb/task_arena.h>)
    endif()
  else()
    target_precompile_headers(${target} REUSE_FROM counterpart_core)
  endif()
endfunction()
