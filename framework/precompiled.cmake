# Headers of libraries that most files of the host, the grader and the tests include, compiled once:
# reading them anew for each file takes a fifth of a build. What workers are made of does without.
set(PATHMARK_PRECOMPILED <fmt/format.h> <glm/glm.hpp> <algorithm> <array> <chrono> <cmath>
  <cstdint> <filesystem> <fstream> <functional> <future> <map> <memory> <mutex> <optional> <random>
  <set> <span> <sstream> <string> <string_view> <thread> <vector>)

# Such a set of headers needs a target with a source file that it is compiled for.
function(pathmark_add_precompiled target)
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/precompiled/${target}.cpp CONTENT "")
  add_library(${target} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${target}.cpp)
  target_link_libraries(${target} PRIVATE fmt::fmt glm::glm)
  target_precompile_headers(${target} PRIVATE ${PATHMARK_PRECOMPILED} ${ARGN})
endfunction()

# GCC 12 does not know of precompiled functions that they are a library's, and warns of what it
# guesses of std::string in them; without precompiled headers it warns of nothing.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(guesses -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
endif()

# Lets all targets of the folder and of those in it use them.
function(pathmark_precompile_in folder)
  set(without pathmark_wire pathmark_intersect pathmark_sampling pathmark_core pathmark_worker
    pathmark_path_recorder pathmark_standins pathmark_sandbox_canary coursework_student
    coursework_solutions pathmark_precompiled pathmark_precompiled_tests)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(target IN_LIST without OR NOT type MATCHES "STATIC_LIBRARY|OBJECT_LIBRARY|EXECUTABLE")
      continue()
    endif()
    get_target_property(libraries ${target} LINK_LIBRARIES)
    set(from pathmark_precompiled)
    if("${libraries}" MATCHES "GTest::")
      set(from pathmark_precompiled_tests)
    endif()
    target_link_libraries(${target} PRIVATE fmt::fmt)  # whose macros the headers were read with
    target_compile_options(${target} PRIVATE ${guesses})
    target_precompile_headers(${target} REUSE_FROM ${from})
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    pathmark_precompile_in(${inner})
  endforeach()
endfunction()

pathmark_add_precompiled(pathmark_precompiled)
if(PATHMARK_TESTS)
  pathmark_add_precompiled(pathmark_precompiled_tests <gtest/gtest.h>)
  target_link_libraries(pathmark_precompiled_tests PRIVATE GTest::gtest)
endif()
pathmark_precompile_in(${PROJECT_SOURCE_DIR})
