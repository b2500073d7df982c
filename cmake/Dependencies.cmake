# Every dependency of the library, in one place. All are Debian 12 packages; scripts/packages.txt lists them.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(embree REQUIRED CONFIG)  # 3 (Debian 12) or 4
find_package(PNG REQUIRED)

# Header-only, looked up by header: their package configs pull in more than is needed, or are not shipped.
find_path(NANOFLANN_INCLUDE_DIR nanoflann.hpp REQUIRED)
find_path(SPECTRA_INCLUDE_DIR Spectra/SymEigsShiftSolver.h REQUIRED)
find_path(NLOHMANN_JSON_INCLUDE_DIR nlohmann/json.hpp REQUIRED)

add_library(counterpart_backends INTERFACE)
target_include_directories(counterpart_backends SYSTEM INTERFACE
  ${NANOFLANN_INCLUDE_DIR} ${SPECTRA_INCLUDE_DIR} ${NLOHMANN_JSON_INCLUDE_DIR})
target_link_libraries(counterpart_backends INTERFACE TBB::tbb fmt::fmt embree PNG::PNG Threads::Threads)

# Implementation details of the library: compiled in, never seen by its users' compiler.
set(COUNTERPART_PRIVATE_LIBRARIES $<BUILD_INTERFACE:counterpart_backends>
    $<LINK_ONLY:TBB::tbb> $<LINK_ONLY:fmt::fmt> $<LINK_ONLY:embree> $<LINK_ONLY:PNG::PNG>)
