# Uses the library from a project of its own. WAY:
#   find_package     installs BUILD; builds, links and runs a program with all components
#   core, io, render the same with one component, where packages that only others need are hidden
#   whole_archive    the same with everything in the static libraries: no name is defined twice
#   add_subdirectory configures SOURCE within the project and compiles against it (the library is not built once more)
set(folder ${BUILD}/consumer/${WAY})
file(REMOVE_RECURSE ${folder})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(configure ${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/tests/consumer -B ${folder}/build -DCMAKE_BUILD_TYPE=${CONFIG})
if(WAY STREQUAL "add_subdirectory")
  run(${configure} -DCOUNTERPART_SOURCE=${SOURCE})
  run(${CMAKE_COMMAND} --build ${folder}/build --target CMakeFiles/consumer.dir/main.cpp.o)
  return()
endif()

if(WAY MATCHES "^(core|io|render)$")
  list(APPEND configure -DCOUNTERPART_COMPONENT=${WAY})
endif()
if(WAY MATCHES "^(core|io)$")
  list(APPEND configure -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON)
elseif(WAY STREQUAL "whole_archive")
  list(APPEND configure -DCOUNTERPART_WHOLE_ARCHIVE=ON)
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/prefix)
run(${configure} -DCMAKE_PREFIX_PATH=${folder}/prefix)
run(${CMAKE_COMMAND} --build ${folder}/build)
run(${CMAKE_COMMAND} -E chdir ${folder} ${folder}/build/consumer)
run(${folder}/prefix/bin/counterpart --version)
