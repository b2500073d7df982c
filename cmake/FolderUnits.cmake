# With CMAKE_UNITY_BUILD (see CMakePresets.json), the files of one folder are compiled as one: the headers are read and
# the templates instantiated once per folder, which makes the whole build two to three times faster. It asks for names
# that are unique within a folder, also in unnamed namespaces; the folders after EXCEPT are still compiled file by file.
function(counterpart_compile_by_folder target)
  cmake_parse_arguments(PARSE_ARGV 1 by_file "" "" "EXCEPT")
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    if(NOT folder IN_LIST by_file_EXCEPT)
      string(MAKE_C_IDENTIFIER ${folder} unit)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
