# Every dependency of the library, in one place. All are packages of Debian 12 and 13; scripts/packages.txt lists them.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
set(threads Threads::Threads)
if(COUNTERPART_THREADS STREQUAL "tbb")
  find_package(TBB 2021 REQUIRED)
  list(PREPEND threads TBB::tbb)
endif()
find_package(fmt 9 REQUIRED)
set(pictures)
if(COUNTERPART_PICTURES)
  find_package(PNG REQUIRED)
  set(pictures PNG::PNG)
endif()
find_package(ZLIB REQUIRED)
find_package(pugixml REQUIRED CONFIG)

# Header-only, looked up by header: their package configs pull in more than is needed, or are not shipped.
find_path(NANOFLANN_INCLUDE_DIR nanoflann.hpp REQUIRED)
find_path(SPECTRA_INCLUDE_DIR Spectra/SymEigsShiftSolver.h REQUIRED)
find_path(NLOHMANN_JSON_INCLUDE_DIR nlohmann/json.hpp REQUIRED)
file(STRINGS ${NANOFLANN_INCLUDE_DIR}/nanoflann.hpp version REGEX "define NANOFLANN_VERSION ")
string(REGEX MATCH "0x[0-9A-Fa-f]+" version "${version}")
if(NOT version OR version LESS 0x142)
  message(FATAL_ERROR "counterpart needs nanoflann 1.4.2 or newer, "
    "${NANOFLANN_INCLUDE_DIR}/nanoflann.hpp has NANOFLANN_VERSION ${version}")
endif()

# What some standard libraries lack of C++20, decimals above all: cmake/libcxx adds it, by fast_float and {fmt}.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_FLAGS -std=c++20)
check_cxx_source_compiles("
#include <bit>
#include <charconv>
int main() {
    double value = 0;
    char text[32] = {};
    std::to_chars(text, text + 32, value);
    return std::from_chars(text, text + 32, value).ptr == text || std::bit_cast<long long>(value) != 0;
}" COUNTERPART_HAS_WHOLE_LIBRARY)
unset(CMAKE_REQUIRED_FLAGS)
if(NOT COUNTERPART_HAS_WHOLE_LIBRARY)
  find_path(FAST_FLOAT_INCLUDE_DIR fast_float/fast_float.h REQUIRED)
endif()

# Implementation details: compiled in, never seen by the compiler of the library's users, only by their linker.
# counterpart_hidden_libraries(VARIABLE INCLUDE_DIRS... LIBRARIES targets...)
function(counterpart_hidden_libraries variable)
  cmake_parse_arguments(PARSE_ARGV 1 hidden "" "" "INCLUDES;LIBRARIES")
  string(TOLOWER ${variable} backends)
  add_library(${backends} INTERFACE)
  target_include_directories(${backends} SYSTEM INTERFACE ${hidden_INCLUDES})
  target_link_libraries(${backends} INTERFACE ${hidden_LIBRARIES})
  list(TRANSFORM hidden_LIBRARIES REPLACE "(.+)" "$<LINK_ONLY:\\1>")
  set(${variable} $<BUILD_INTERFACE:${backends}> ${hidden_LIBRARIES} PARENT_SCOPE)
endfunction()
counterpart_hidden_libraries(COUNTERPART_CORE_LIBRARIES
  INCLUDES ${NANOFLANN_INCLUDE_DIR} ${SPECTRA_INCLUDE_DIR} LIBRARIES fmt::fmt ${threads})
counterpart_hidden_libraries(COUNTERPART_IO_LIBRARIES
  INCLUDES ${NLOHMANN_JSON_INCLUDE_DIR} LIBRARIES fmt::fmt ${threads} ZLIB::ZLIB pugixml::pugixml)
counterpart_hidden_libraries(COUNTERPART_RENDER_LIBRARIES
  INCLUDES ${NLOHMANN_JSON_INCLUDE_DIR} LIBRARIES fmt::fmt ${threads} ${pictures})

# All of them, for the project's own programs and tests.
add_library(counterpart_backends INTERFACE)
target_link_libraries(counterpart_backends INTERFACE
  counterpart_core_libraries counterpart_io_libraries counterpart_render_libraries)
