#Peers : other libraries measured beside ours, \
    from the packages that packages - peers.txt names.Each is a file here that
#includes that library alone; what is not installed is not built, and the page says so.
option(FULCRUM_PEERS
       "measure ODE, Bullet, MuJoCo, OpenVDB and FCL beside ours where they are installed" OFF)
    set(peer_sources "") set(peer_libraries "") set(missing_peers "")

#fulcrum_peer_library( \
    NAME HEADER LIBRARY...) : the target peer_NAME where header and libraries are there.
        function(fulcrum_peer_library name header) find_path(peer_${name} _header ${
            header}) set(found ${peer_${name} _header}) set(libraries
                                                            "") foreach (library IN LISTS ARGN)
            find_library(peer_${library} _library NAMES ${library} ${library} - 3_1) list(
                APPEND libraries ${peer_${library} _library}) if (NOT peer_${library} _library)
                set(found FALSE) endif() endforeach() if (found) add_library(peer_${
                    name} INTERFACE IMPORTED GLOBAL) target_link_libraries(peer_${name} INTERFACE ${
                    libraries}) endif() endfunction()

#fulcrum_peer(NAME TARGET file...) : builds the adapter when the target is there.
                    function(fulcrum_peer name target) set(missing ${missing_peers}) if (
                        FULCRUM_PEERS AND TARGET ${target}) foreach (source IN LISTS ARGN)
                        list(APPEND peer_sources ${CMAKE_CURRENT_FUNCTION_LIST_DIR} /
                             ${source}) endforeach() list(APPEND peer_libraries ${
                            target}) else() list(APPEND missing ${name}) endif() set(peer_sources ${
                            peer_sources} PARENT_SCOPE) set(peer_libraries ${
                            peer_libraries} PARENT_SCOPE) set(missing_peers ${
                            missing} PARENT_SCOPE) endfunction()

                            if (FULCRUM_PEERS) pkg_check_modules(ode QUIET IMPORTED_TARGET ode)
                                pkg_check_modules(bullet QUIET IMPORTED_TARGET bullet -
                                                  float64) find_package(fcl QUIET)
#MuJoCo 's and OpenVDB' s own CMake files name folders and modules of packages that \
    they do not ask for.
                                    fulcrum_peer_library(mujoco mujoco / mujoco.h mujoco)
                                        fulcrum_peer_library(openvdb openvdb /
                                                             openvdb.h openvdb tbb Imath) endif()
                                            fulcrum_peer(ODE PkgConfig::ode ode_body.cpp)
                                                fulcrum_peer(
                                                    Bullet PkgConfig::bullet bullet_body.cpp)
                                                    fulcrum_peer(MuJoCo peer_mujoco mujoco_body.cpp)
                                                        list(JOIN missing_peers ", " missing_peers)
