# Builds for Windows on x86_64 with Debian's mingw-w64. HEADERS is a folder with links to header-only libraries of this
# machine, whose /usr/include is not for Windows.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_CXX_FLAGS_INIT "-I${HEADERS}")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES HEADERS)
