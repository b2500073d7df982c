# Compiles the built viewer into the library. viewer/dist is part of the sources, so that building needs no Node.js;
# scripts/test_viewer.sh checks that it is what viewer/src builds to.
set(COUNTERPART_VIEWER_FILE ${CMAKE_CURRENT_SOURCE_DIR}/viewer/dist/viewer.html)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${COUNTERPART_VIEWER_FILE})
file(READ ${COUNTERPART_VIEWER_FILE} COUNTERPART_VIEWER_PAGE)
string(FIND "${COUNTERPART_VIEWER_PAGE}" "<!--counterpart-data-->" COUNTERPART_VIEWER_MARK)
if(COUNTERPART_VIEWER_MARK EQUAL -1)
  message(FATAL_ERROR "${COUNTERPART_VIEWER_FILE} has no place for the meshes: rebuild it, see docs/howto/view.md")
endif()
configure_file(cmake/page_template.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/generated/page_template.cpp @ONLY)
set(COUNTERPART_VIEWER_SOURCE ${CMAKE_CURRENT_BINARY_DIR}/generated/page_template.cpp)
