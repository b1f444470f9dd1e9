# Builds the binary of an FMU from the sources in it: cmake -S sources -B build && cmake --build build
# Needs the headers of Boost, Eigen, fmt and nlohmann_json; `model_identifier` is set above.
cmake_minimum_required(VERSION 3.16)
project(${model_identifier} LANGUAGES CXX)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
find_package(Eigen3 REQUIRED)
file(GLOB_RECURSE sources ${CMAKE_CURRENT_SOURCE_DIR}/src/*.cpp)
# -DCMAKE_UNITY_BUILD=ON shortens the build to a fraction; kernels are excluded because they define the same names.
file(GLOB kernels ${CMAKE_CURRENT_SOURCE_DIR}/src/kernel/*.cpp)
set_source_files_properties(${kernels} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
add_library(${model_identifier} MODULE ${sources})
set_target_properties(${model_identifier} PROPERTIES PREFIX "" NO_SONAME ON)
target_compile_features(${model_identifier} PRIVATE cxx_std_17)
# Products and sums are not fused, so that the forces equal those of the package to the last bit.
target_compile_options(${model_identifier} PRIVATE -fvisibility=hidden -ffp-contract=off)
target_compile_definitions(${model_identifier} PRIVATE FMT_HEADER_ONLY)
if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/component_text.h)  # otherwise the exporter fills a block in the binary
  target_compile_definitions(${model_identifier} PRIVATE RUBBER_SUSPENSION_BUILT_IN)
endif()
target_include_directories(${model_identifier} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}
  ${CMAKE_CURRENT_SOURCE_DIR}/include ${CMAKE_CURRENT_SOURCE_DIR}/src)
target_precompile_headers(${model_identifier} PRIVATE <Eigen/Core> <fmt/format.h>)
target_link_libraries(${model_identifier} PRIVATE Eigen3::Eigen)
if(WIN32)  # mingw-w64: links all libraries statically and omits the time stamp
  target_link_options(${model_identifier} PRIVATE -static -s -Wl,--no-insert-timestamp)
else()
  target_link_options(${model_identifier} PRIVATE -static-libstdc++ -static-libgcc
    -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/src/fmi/runtime/exports.map)
endif()
