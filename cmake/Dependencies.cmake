# Every dependency of the library, in one place. All are Debian 12 packages; scripts/packages.txt lists them.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)

# Header-only: CGAL (LGPL parts only), nanoflann, Spectra. Looked up by header, because their package configs pull in
# far more than these headers need.
find_path(CGAL_INCLUDE_DIR CGAL/IO/polygon_soup_io.h REQUIRED)
find_path(NANOFLANN_INCLUDE_DIR nanoflann.hpp REQUIRED)
find_path(SPECTRA_INCLUDE_DIR Spectra/SymEigsShiftSolver.h REQUIRED)
find_path(NLOHMANN_JSON_INCLUDE_DIR nlohmann/json.hpp REQUIRED)

add_library(counterpart_backends INTERFACE)
target_include_directories(counterpart_backends SYSTEM INTERFACE
  ${CGAL_INCLUDE_DIR} ${NANOFLANN_INCLUDE_DIR} ${SPECTRA_INCLUDE_DIR} ${NLOHMANN_JSON_INCLUDE_DIR})
target_link_libraries(counterpart_backends INTERFACE TBB::tbb fmt::fmt Threads::Threads)

# Implementation details of the library: compiled in, never seen by its users' compiler.
set(COUNTERPART_PRIVATE_LIBRARIES $<BUILD_INTERFACE:counterpart_backends> $<LINK_ONLY:TBB::tbb> $<LINK_ONLY:fmt::fmt>)
