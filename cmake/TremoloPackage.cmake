# `cpack --config build/release/CPackConfig.cmake` makes a package for Debian 12 of what `cmake --install` installs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tremolo)
set(CPACK_PACKAGE_CONTACT "The tremolo developers <tremolo@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, python3-numpy, python3-h5py, python3-matplotlib, python3-jinja2, python3-plotly")
# Only free fields written in Python, and ranks, need them.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-zmq, openmpi-bin")
include(CPack)
