# Every package tremolo links, found through its own CMake package or pkg-config. Shared by the build and by
# find_package(tremolo).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)
find_library(FFTW_THREADS fftw3_threads REQUIRED) # has no pkg-config file
pkg_check_modules(GSL REQUIRED IMPORTED_TARGET gsl)
find_package(SUNDIALS REQUIRED)
pkg_check_modules(ZMQ REQUIRED IMPORTED_TARGET libzmq)
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial hdf5)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
