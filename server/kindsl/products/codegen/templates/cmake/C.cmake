if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(@PREFIX@
  @SOURCES@)
add_library(@PREFIX@::@PREFIX@ ALIAS @PREFIX@)
set_target_properties(@PREFIX@ PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_include_directories(@PREFIX@ PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
if(UNIX)
  target_link_libraries(@PREFIX@ PUBLIC m)
endif()
option(@MACRO@_NATIVE "Use all instructions of the processor that compiles" OFF)
if(@MACRO@_NATIVE)
  target_compile_options(@PREFIX@ PRIVATE -march=native -ffp-contract=fast)
endif()

if(BUILD_TESTING)
  add_executable(@PREFIX@_test @PREFIX@_test.c)
  set_target_properties(@PREFIX@_test PROPERTIES C_STANDARD 11 C_EXTENSIONS OFF)
  target_link_libraries(@PREFIX@_test PRIVATE @PREFIX@)
  add_test(NAME @PREFIX@_test COMMAND @PREFIX@_test)
endif()
