# camwright_fuzz(NAME fuzz_x SOURCES … LIBS …): a libFuzzer target; its corpus lies in tests/fuzz/corpus/<name>.
function(camwright_fuzz)
  cmake_parse_arguments(A "" "NAME" "SOURCES;LIBS" ${ARGN})
  add_executable(${A_NAME} ${A_SOURCES})
  target_link_libraries(${A_NAME} PRIVATE camwright_flags ${A_LIBS})
  target_compile_options(${A_NAME} PRIVATE -fsanitize=fuzzer)
  target_link_options(${A_NAME} PRIVATE -fsanitize=fuzzer)
  add_test(NAME ${A_NAME} COMMAND ${A_NAME} -runs=20000 -max_total_time=30 -timeout=10 -rss_limit_mb=2048
    ${CMAKE_BINARY_DIR}/fuzz-out/${A_NAME} ${CMAKE_SOURCE_DIR}/tests/fuzz/corpus/${A_NAME})
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/fuzz-out/${A_NAME})
endfunction()
