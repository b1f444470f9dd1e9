# Copies the sources of the binary of an FMU. Given: ROOT of the package, FILES, FOLDER to write.
file(REMOVE_RECURSE ${FOLDER})
foreach(path ${FILES})
  file(RELATIVE_PATH relative ${ROOT} ${path})
  get_filename_component(folder ${relative} DIRECTORY)
  file(COPY ${path} DESTINATION ${FOLDER}/${folder})
endforeach()
file(COPY ${ROOT}/LICENSE DESTINATION ${FOLDER})
configure_file(${ROOT}/cmake/fmu_sources.cmake ${FOLDER}/CMakeLists.txt COPYONLY)
