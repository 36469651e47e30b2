# What nearly every file includes is compiled once (LIMPET_PCH): Eigen takes longer than most of what uses it. That a
# file includes what it needs is judged by `make lint` and the tests of the public headers, which do without.
option(LIMPET_PCH "Precompile the headers that are included everywhere" ON)

set(LIMPET_PCH_HEADERS <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <cstdint> <cstdio> <functional> <map>
  <memory> <optional> <set> <span> <sstream> <string> <string_view> <unordered_map> <utility> <vector>)

# The targets of the current folder, or a list of them, take the headers from `source`.
function(limpet_precompiled source)
  foreach(target IN LISTS ARGN)
    get_target_property(type ${target} TYPE)
    if(LIMPET_PCH AND type MATCHES "EXECUTABLE|STATIC_LIBRARY")
      target_precompile_headers(${target} REUSE_FROM ${source})
    endif()
  endforeach()
endfunction()

function(limpet_add_precompiled name)
  if(LIMPET_PCH)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE limpet_warnings Eigen3::Eigen ${ARGN})
    target_precompile_headers(${name} PRIVATE ${LIMPET_PCH_HEADERS})
  endif()
endfunction()
