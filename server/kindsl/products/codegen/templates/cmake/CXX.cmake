find_package(Eigen3 REQUIRED NO_MODULE)
set(@PREFIX@_NEEDS "include(CMakeFindDependencyMacro)\nfind_dependency(Eigen3 NO_MODULE)\n")
add_library(@PREFIX@ INTERFACE)
add_library(@PREFIX@::@PREFIX@ ALIAS @PREFIX@)
target_compile_features(@PREFIX@ INTERFACE cxx_std_14)
target_link_libraries(@PREFIX@ INTERFACE Eigen3::Eigen)
target_include_directories(@PREFIX@ INTERFACE
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

if(BUILD_TESTING)
  add_executable(@PREFIX@_test @PREFIX@_test.cpp)
  target_link_libraries(@PREFIX@_test PRIVATE @PREFIX@)
  add_test(NAME @PREFIX@_test COMMAND @PREFIX@_test)
endif()
