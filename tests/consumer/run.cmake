# Uses the library from a project of its own. WAY: find_package installs BUILD and builds, links and runs the consumer;
# add_subdirectory configures SOURCE within it and compiles against it (the library itself is not built once more).
set(folder ${BUILD}/consumer/${WAY})
file(REMOVE_RECURSE ${folder})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(configure ${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/tests/consumer -B ${folder}/build -DCMAKE_BUILD_TYPE=${CONFIG})
if(WAY STREQUAL "find_package")
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/prefix)
  run(${configure} -DCMAKE_PREFIX_PATH=${folder}/prefix)
  run(${CMAKE_COMMAND} --build ${folder}/build)
  run(${folder}/build/consumer)
  run(${folder}/prefix/bin/counterpart --version)
else()
  run(${configure} -DCOUNTERPART_SOURCE=${SOURCE})
  run(${CMAKE_COMMAND} --build ${folder}/build --target CMakeFiles/consumer.dir/main.cpp.o)
endif()
