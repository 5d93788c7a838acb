# One place for the flags every target shares, and for the libraries that come from outside.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CAMWRIGHT_CCACHE ccache)
if(CAMWRIGHT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env
      CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${CAMWRIGHT_CCACHE})
endif()

# Bytes must be equal on every x86-64 machine: no fused multiply-add, no -march, no fast-math.
add_library(camwright_flags INTERFACE)
target_include_directories(camwright_flags INTERFACE ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated)
target_compile_options(camwright_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -Wundef -Werror
  -ffp-contract=off
  $<$<CONFIG:Debug>:-g1>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Known false alarms of GCC 12 at -O2 inside std::variant and std::string.
  target_compile_options(camwright_flags INTERFACE -Wno-maybe-uninitialized -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -Wno-dangling-pointer)
else()
  target_compile_options(camwright_flags INTERFACE -Xclang -fno-pch-timestamp)
endif()
if(CAMWRIGHT_SANITIZE)
  target_compile_options(camwright_flags INTERFACE -fsanitize=${CAMWRIGHT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(camwright_flags INTERFACE -fsanitize=${CAMWRIGHT_SANITIZE})
endif()
if(CAMWRIGHT_FUZZ) # coverage of the libraries, without which a fuzzer is blind
  target_compile_options(camwright_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
find_program(CAMWRIGHT_LLD NAMES ld.lld-19 ld.lld)
if(CAMWRIGHT_LLD AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  target_link_options(camwright_flags INTERFACE --ld-path=${CAMWRIGHT_LLD})
endif()

find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(sodium REQUIRED IMPORTED_TARGET libsodium)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$") # Debian's package brings no configuration of its own
  find_path(CAMWRIGHT_ASMJIT_INCLUDE asmjit/x86.h REQUIRED)
  find_library(CAMWRIGHT_ASMJIT_LIBRARY asmjit REQUIRED)
  add_library(asmjit INTERFACE IMPORTED)
  target_include_directories(asmjit SYSTEM INTERFACE ${CAMWRIGHT_ASMJIT_INCLUDE})
  target_link_libraries(asmjit INTERFACE ${CAMWRIGHT_ASMJIT_LIBRARY} rt)
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
find_package(Qt6 6.4 REQUIRED COMPONENTS Core Network)
if(CAMWRIGHT_GUI)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Gui Widgets Svg PrintSupport DBus)
  find_package(QCustomPlotQt6 REQUIRED)
  find_path(CAMWRIGHT_QSCI_INCLUDE Qsci/qsciscintilla.h PATH_SUFFIXES qt6 x86_64-linux-gnu/qt6 REQUIRED)
  find_library(CAMWRIGHT_QSCI_LIBRARY qscintilla2_qt6 REQUIRED)
  add_library(qscintilla INTERFACE IMPORTED)
  target_include_directories(qscintilla SYSTEM INTERFACE ${CAMWRIGHT_QSCI_INCLUDE})
  target_link_libraries(qscintilla INTERFACE ${CAMWRIGHT_QSCI_LIBRARY} Qt6::Widgets Qt6::PrintSupport)
endif()
find_package(Qt6 6.4 QUIET COMPONENTS LinguistTools Test)

# What each foreign name of the layer table stands for.
set(CAMWRIGHT_FOREIGN_toml "^PkgConfig::tomlplusplus$")
set(CAMWRIGHT_FOREIGN_fmt "^fmt::fmt(-header-only)?$")
set(CAMWRIGHT_FOREIGN_json "^nlohmann_json(::nlohmann_json)?$")
set(CAMWRIGHT_FOREIGN_sodium "^PkgConfig::sodium$")
set(CAMWRIGHT_FOREIGN_asmjit "^asmjit$")
set(CAMWRIGHT_FOREIGN_threads "^Threads::Threads$")
set(CAMWRIGHT_FOREIGN_qtcore "^Qt6?::(Core|Platform|GlobalConfig|CorePrivate|PlatformCommonInternal|PlatformModuleInternal)")
set(CAMWRIGHT_FOREIGN_qtdbus "^Qt6?::DBus$")
set(CAMWRIGHT_FOREIGN_qtnetwork "^Qt6?::Network$")
set(CAMWRIGHT_FOREIGN_qtgui "^Qt6?::(Gui|Svg)$")
set(CAMWRIGHT_FOREIGN_qtwidgets "^Qt6?::(Widgets|PrintSupport|SvgWidgets)$")
set(CAMWRIGHT_FOREIGN_qscintilla "^qscintilla$")
set(CAMWRIGHT_FOREIGN_qcustomplot "^QCustomPlotQt6::QCustomPlotQt6$")
