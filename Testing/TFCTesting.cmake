# SPDX-License-Identifier: BSD-3-Clause
# Helpers to declare tests. ctest labels in use:
#   kernels filters model volume charts plugin python gui mpi data lint

# tfc_add_gtest(NAME SOURCES files LABELS labels [LIBRARIES targets])
# A GoogleTest executable, one ctest entry per TEST(), named NAME.<suite>.<test>.
function (tfc_add_gtest name)
  cmake_parse_arguments(arg "" "" "SOURCES;LABELS;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest_main)
  target_include_directories(${name} PRIVATE "${CMAKE_SOURCE_DIR}" "${CMAKE_SOURCE_DIR}/Testing")
  # Not gtest_discover_tests at build time: ParaView's libraries take a second to load, once per
  # executable is enough and at test time it does not slow the build.
  gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS "${arg_LABELS}" TIMEOUT 300)
endfunction ()

find_program(TFC_PVPYTHON pvpython DOC "ParaView's Python, for the tests labelled 'python'")
find_program(TFC_PVBATCH pvbatch DOC "ParaView's batch program, for the tests labelled 'mpi'")
find_program(TFC_MPIRUN mpirun DOC "Open MPI's launcher, for the tests labelled 'mpi'")

# Properties that all tests of scripts share. A script exits with 77 to be reported as skipped, and
# finds the plugin, the real volumes and the Python package through its environment. Processes that
# wait for each other give way, and Mesa's software renderer takes one thread: tests run side by side.
function (_tfc_script_properties name labels)
  set_tests_properties(${name} PROPERTIES
    LABELS "${labels}"
    TIMEOUT 300
    SKIP_RETURN_CODE 77
    ENVIRONMENT "TFC_PLUGIN=$<TARGET_FILE:TransferFunctionCombinations>;TFC_DATA_ROOT=${TFC_DATA_ROOT};PYTHONPATH=${CMAKE_BINARY_DIR}/${TFC_PYTHON_DESTINATION}:${CMAKE_SOURCE_DIR}/Testing;OMPI_MCA_mpi_yield_when_idle=1;LP_NUM_THREADS=1")
endfunction ()

# tfc_add_pvpython_test(NAME SCRIPT LABELS labels [ARGS arguments])
# A script for pvpython; the label 'python' is added.
function (tfc_add_pvpython_test name script)
  cmake_parse_arguments(arg "" "" "LABELS;ARGS" ${ARGN})
  if (NOT TFC_PVPYTHON)
    message(STATUS "pvpython was not found: no test ${name}")
    return ()
  endif ()
  add_test(NAME ${name}
    COMMAND "${TFC_PVPYTHON}" "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${arg_ARGS})
  _tfc_script_properties(${name} "${arg_LABELS};python")
endfunction ()

# tfc_add_pvbatch_mpi_test(NAME RANKS SCRIPT LABELS labels [PVBATCH_ARGS arguments] [ARGS arguments])
# A script for pvbatch on RANKS processes; the label 'mpi' is added. PVBATCH_ARGS --sym makes every
# process run the script.
function (tfc_add_pvbatch_mpi_test name ranks script)
  cmake_parse_arguments(arg "" "" "LABELS;PVBATCH_ARGS;ARGS" ${ARGN})
  if (NOT TFC_PVBATCH OR NOT TFC_MPIRUN)
    message(STATUS "pvbatch or mpirun was not found: no test ${name}")
    return ()
  endif ()
  add_test(NAME ${name}
    COMMAND "${TFC_MPIRUN}" --allow-run-as-root --oversubscribe -np ${ranks}
      "${TFC_PVBATCH}" ${arg_PVBATCH_ARGS} "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${arg_ARGS})
  _tfc_script_properties(${name} "${arg_LABELS};mpi")
  set_tests_properties(${name} PROPERTIES PROCESSORS ${ranks})
endfunction ()
