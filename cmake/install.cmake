# `cmake --install` installs the header, both libraries, and the files that find_package(EnergyWave) and pkg-config read.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/EnergyWave)

install(FILES ${PROJECT_SOURCE_DIR}/src/energywave.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS energywave energywave_static EXPORT EnergyWave)
# The targets need no other package, so their file is the whole configuration.
install(EXPORT EnergyWave NAMESPACE EnergyWave:: FILE EnergyWaveConfig.cmake DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/EnergyWaveConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/EnergyWaveConfigVersion.cmake DESTINATION ${package_dir})

# energywave.pc finds its prefix by a relative path, so that an installation can be moved.
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" prefix_from_pc ${prefix_from_pc})
configure_file(${CMAKE_CURRENT_LIST_DIR}/energywave.pc.in ${PROJECT_BINARY_DIR}/energywave.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/energywave.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
