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
