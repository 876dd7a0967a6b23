# Other simulators on our chart, from Debian's packages. Nothing of it is looked for without -DBENCH_PEERS=ON.
function(missing_peer package)
  message(FATAL_ERROR "BENCH_PEERS: ${package} is missing; `scripts/install-dependencies peers` installs all of them")
endfunction()

# pkg-config module -> target PkgConfig::NAME
function(find_peer name module package)
  pkg_check_modules(${name} QUIET IMPORTED_TARGET GLOBAL ${module})
  if(NOT ${name}_FOUND)
    missing_peer(${package})
  endif()
endfunction()

find_peer(BULLET bullet-float64 libbullet-dev)
find_peer(ODE ode libode-dev)
find_peer(DART dart libdart-dev)
find_peer(SIMBODY simbody libsimbody-dev)
# By hand: the CMake files of libmujoco-dev 2.2.2 want headers of other packages that it does not depend on.
find_library(MUJOCO_LIBRARY mujoco)
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
if(NOT MUJOCO_LIBRARY OR NOT MUJOCO_INCLUDE_DIR)
  missing_peer(libmujoco-dev)
endif()

# Some of their .pc files ask for C++11: take the rest, and leave the standard to us.
set(peer_targets PkgConfig::BULLET PkgConfig::ODE PkgConfig::DART PkgConfig::SIMBODY)
foreach(peer ${peer_targets})
  get_target_property(flags ${peer} INTERFACE_COMPILE_OPTIONS)
  if(flags)
    list(FILTER flags EXCLUDE REGEX "^-std=")
    set_target_properties(${peer} PROPERTIES INTERFACE_COMPILE_OPTIONS "${flags}")
  endif()
endforeach()

add_library(${PROJECT_NAME}_peers STATIC
  bench/peers/peers.cpp
  bench/peers/stepped_engine.cpp
  bench/peers/bullet.cpp
  bench/peers/ode.cpp
  bench/peers/dart.cpp
  bench/peers/mujoco.cpp
  bench/peers/simbody.cpp
  bench/peers/simbody_located.cpp
)
target_link_libraries(${PROJECT_NAME}_peers
  PUBLIC ${PROJECT_NAME}_core
  PRIVATE ${PROJECT_NAME}_options ${peer_targets} ${MUJOCO_LIBRARY})
target_include_directories(${PROJECT_NAME}_peers PUBLIC bench src/core)
target_include_directories(${PROJECT_NAME}_peers SYSTEM PRIVATE ${MUJOCO_INCLUDE_DIR})

add_executable(${PROJECT_NAME}_peers_check bench/peers/check.cpp)
set_target_properties(${PROJECT_NAME}_peers_check PROPERTIES OUTPUT_NAME peers_check)
target_link_libraries(${PROJECT_NAME}_peers_check PRIVATE ${PROJECT_NAME}_peers ${PROJECT_NAME}_command_line ${PROJECT_NAME}_options)
if(CORE_ONLY)
  add_test(NAME peers_check COMMAND ${PROJECT_NAME}_peers_check)
endif()
