# A policy is a file of a folder, and its name is the file's: adding one touches nothing else.
#
# artu_policies(FOLDER ROOM): writes policies.inc, one line ARTU_POLICY(name) a policy, which the room's registry
# includes.  Named references and not objects that register themselves, which a static library would drop.  The
# default's line is the first.
function(artu_policies folder room)
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  set(names)
  foreach(file ${files})
    get_filename_component(name ${file} NAME_WE)
    if(NOT name MATCHES "^[a-z][a-z0-9_]*$")
      message(FATAL_ERROR "${file}: a policy's name has a-z, 0-9 and _, the first of them a letter")
    endif()
    list(APPEND names ${name})
  endforeach()
  list(SORT names)
  list(REMOVE_ITEM names attention)
  list(PREPEND names attention)
  list(TRANSFORM names REPLACE "(.+)" "ARTU_POLICY(\\1)")
  list(JOIN names "\n" lines)
  set(generated ${CMAKE_BINARY_DIR}/generated/${room})
  file(CONFIGURE OUTPUT ${generated}/policies.inc CONTENT "${lines}\n" @ONLY)
  target_include_directories(artu_${room} PRIVATE ${generated})
endfunction()
