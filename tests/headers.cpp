// Nothing but the headers that all tests share, which CMake precompiles for this file.
