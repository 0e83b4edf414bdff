# Installs the build into a fresh prefix, then configures, builds and runs a project that finds the package there.
set(prefix ${WORK}/prefix)
set(build ${WORK}/project)
file(REMOVE_RECURSE ${prefix} ${build})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message("${output}")
    message(FATAL_ERROR "ended with ${status}: ${command}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(generator -G ${GENERATOR})
if(PLATFORM)
  list(APPEND generator -A ${PLATFORM})
endif()
if(TOOLSET)
  list(APPEND generator -T ${TOOLSET})
endif()
if(MAKE_PROGRAM)
  list(APPEND generator -DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM})
endif()
string(REPLACE ";" "\\;" search "${prefix};${PREFIX_PATH}")

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --config ${CONFIG})
# The expression keeps generators of many configurations from adding a folder of their own.
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${build} ${generator} -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${COMPILER}
    "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_PREFIX_PATH=${search}" "-DCMAKE_RUNTIME_OUTPUT_DIRECTORY=$<1:${build}/bin>")
run(${CMAKE_COMMAND} --build ${build} --config ${CONFIG})

load_cache(${build} READ_WITH_PREFIX found_ scalebreak_DIR)
string(FIND "${found_scalebreak_DIR}" "${prefix}/" at)
if(NOT at EQUAL 0)
  message(FATAL_ERROR "the package was found in ${found_scalebreak_DIR}, not in ${prefix}")
endif()

run(${build}/bin/consumer${EXE})
if(NOT output STREQUAL "OK\n")
  message(FATAL_ERROR "the project printed: ${output}")
endif()

# The installed program knows the installed materials, wherever the prefix lies.
set(ENV{SCALEBREAK_DATA})
run(${prefix}/bin/scalebreak${EXE} collide --json --set material.name=latex)
execute_process(COMMAND ${prefix}/bin/scalebreak${EXE} collide --set material.name=none RESULT_VARIABLE status ERROR_VARIABLE output)
string(FIND "${output}" "a material of ${prefix}/share/scalebreak/materials: \"" at)
if(NOT status EQUAL 2 OR at EQUAL -1)
  message(FATAL_ERROR "the installed program does not look for materials in its own prefix: ${output}")
endif()
