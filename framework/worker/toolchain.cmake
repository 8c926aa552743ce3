# How coursework is compiled and linked, by the host and not by CMake: the same command at home
# and when marks are given.

# The coursework header, precompiled: a coursework file then compiles in a tenth of a second. GCC
# finds it by its place in front of the header itself in the search path.
string(TOUPPER ${CMAKE_BUILD_TYPE} configuration)
separate_arguments(build_type_flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${configuration}}")
# Assertions hold in coursework.
list(REMOVE_ITEM build_type_flags -DNDEBUG)
set(coursework_flags -std=c++20 ${build_type_flags} ${PATHMARK_FLAGS} -Wall -Wextra
    -Werror=return-type)
get_target_property(glm_include glm::glm INTERFACE_INCLUDE_DIRECTORIES)
if(glm_include AND NOT glm_include STREQUAL "/usr/include")
  list(APPEND coursework_flags "-I${glm_include}")
endif()
set(pch_folder ${CMAKE_BINARY_DIR}/precompiled)
set(coursework_header ${PROJECT_SOURCE_DIR}/framework/include/pathmark/coursework.h)
set(api_headers brdf camera coursework frame lit_scene sampler shapes types unimplemented warmup)
list(TRANSFORM api_headers PREPEND ${PROJECT_SOURCE_DIR}/framework/include/pathmark/)
list(TRANSFORM api_headers APPEND .h)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_custom_command(
    OUTPUT ${pch_folder}/pathmark/coursework.h.gch
    COMMAND ${CMAKE_COMMAND} -E make_directory ${pch_folder}/pathmark
    COMMAND ${CMAKE_CXX_COMPILER} ${coursework_flags} -I${PROJECT_SOURCE_DIR}/framework/include
            -w -x c++-header ${coursework_header} -o ${pch_folder}/pathmark/coursework.h.gch
    DEPENDS ${api_headers}
    COMMENT "Precompiling pathmark/coursework.h"
    VERBATIM)
  add_custom_target(pathmark_precompiled_header
    DEPENDS ${pch_folder}/pathmark/coursework.h.gch)
endif()

# For host/build_config.h.in: the flags as lines of a C++ array.
list(TRANSFORM coursework_flags REPLACE "(.+)" "    \"\\1\"," OUTPUT_VARIABLE PATHMARK_COURSEWORK_FLAGS)
list(JOIN PATHMARK_COURSEWORK_FLAGS "\n" PATHMARK_COURSEWORK_FLAGS)
set(PATHMARK_LINKER_FLAG "")
find_program(PATHMARK_LLD ld.lld)
if(PATHMARK_LLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(PATHMARK_LINKER_FLAG "-fuse-ld=lld")
endif()
find_program(PATHMARK_LD NAMES ld.bfd ld REQUIRED)
find_program(PATHMARK_OBJCOPY NAMES objcopy REQUIRED)
find_program(PATHMARK_ADDR2LINE NAMES addr2line REQUIRED)
