# Warnings, sanitizers and build-wide code generation settings for our own targets.
function(counterpart_configure_target target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wshadow -Wnon-virtual-dtor
    # Eigen's expression templates trigger GCC 12's false positives of these two at -O3.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-array-bounds>
    # So do strings that are moved into a vector, of these two (its bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overread>
    # A private type of a file that is compiled with others of its folder (FolderUnits.cmake) looks like one of a header.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
    # The viewer's page is one literal.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-overlength-strings>
    # The same bytes out on every x86-64 machine: no contraction into fused multiply-adds.
    -ffp-contract=off)
  if(NOT COUNTERPART_HAS_WHOLE_LIBRARY)
    target_include_directories(${target} SYSTEM BEFORE PRIVATE ${PROJECT_SOURCE_DIR}/cmake/libcxx ${FAST_FLOAT_INCLUDE_DIR})
  endif()
  if(EMSCRIPTEN)
    target_compile_options(${target} PRIVATE -pthread)  # linked with threads and without
  endif()
  if(WIN32)
    target_compile_definitions(${target} PRIVATE NOMINMAX WIN32_LEAN_AND_MEAN UNICODE)
  endif()
  if(COUNTERPART_THREADS STREQUAL "plain")
    target_compile_definitions(${target} PRIVATE COUNTERPART_PLAIN_THREADS)
  endif()
  if(COUNTERPART_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(COUNTERPART_SANITIZER)
    target_compile_options(${target} PUBLIC
      -fsanitize=${COUNTERPART_SANITIZER} -fno-sanitize-recover=all -fno-omit-frame-pointer
      # What the address sanitizer or the hardware catches as well, at a third of the compile time.
      -fno-sanitize=null,alignment,object-size,vptr)
    target_link_options(${target} PUBLIC -fsanitize=${COUNTERPART_SANITIZER})
  endif()
endfunction()
