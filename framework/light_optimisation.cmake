# Tests, and files that only read a command's words, are compiled with -O1 in a release build: most
# of their time of compilation is the optimisation of what runs for a moment. What they call keeps
# its -O3.
function(pathmark_optimise_lightly_in folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(NOT type MATCHES "STATIC_LIBRARY|OBJECT_LIBRARY|EXECUTABLE")
      continue()
    endif()
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if("${libraries}" MATCHES "GTest::")
      target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
      continue()
    endif()
    get_target_property(commands ${target} SOURCES)
    list(FILTER commands INCLUDE REGEX "command_[a-z_]*\\.cpp$")
    get_target_property(source ${target} SOURCE_DIR)
    list(TRANSFORM commands PREPEND ${source}/)
    set_property(SOURCE ${commands} TARGET_DIRECTORY ${target}
      APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:Release>:-O1>)
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    pathmark_optimise_lightly_in(${inner})
  endforeach()
endfunction()

pathmark_optimise_lightly_in(${PROJECT_SOURCE_DIR})
