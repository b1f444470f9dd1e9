# For programs that use the libraries by plain CMake, without ROS: rubber_suspension::core, ::io, ::diagnosis.
include(CMakeFindDependencyMacro)
find_dependency(Boost)
find_dependency(Eigen3)
find_dependency(fmt)
include("${CMAKE_CURRENT_LIST_DIR}/rubber_suspension_coreTargets.cmake")
