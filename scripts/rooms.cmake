# A room is a library whose headers are seen only by the targets that link it: `#include "hw/..."` from
# ref/ does not compile.  Each room gets an include folder of its own that holds one link, to the room.
function(artu_room name)
  set(root ${CMAKE_BINARY_DIR}/rooms/${name})
  file(MAKE_DIRECTORY ${root})
  if(NOT EXISTS ${root}/${name})
    file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${name} ${root}/${name} SYMBOLIC)
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  add_library(artu_${name} STATIC ${sources})
  target_include_directories(artu_${name} PUBLIC ${root})
endfunction()
