# limpet_folder(NAME SOURCES... [LINKS ...] [PRIVATE_LINKS ...])
#
# One library per folder. Its headers are seen as <limpet/NAME/...> through an include directory that
# holds this folder alone, so a folder can include only from folders it links to: the build itself
# refuses an upward include.
function(limpet_export_headers target folder)
  set(root ${CMAKE_BINARY_DIR}/include/${folder})
  file(MAKE_DIRECTORY ${root}/limpet)
  file(CREATE_LINK ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../${folder} ${root}/limpet/${folder} SYMBOLIC)
  target_include_directories(${target} INTERFACE
    $<BUILD_INTERFACE:${root}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # What the headers need of whoever includes them: the language, and that a*b + c stays two rounded operations in
  # their inline functions, without which the same input would not give the same bytes.
  target_compile_features(${target} INTERFACE cxx_std_20)
  target_compile_options(${target} INTERFACE -ffp-contract=off)
endfunction()

function(limpet_folder name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(limpet_${name} STATIC ${ARG_SOURCES})
  limpet_export_headers(limpet_${name} ${name})
  target_include_directories(limpet_${name} PRIVATE ${CMAKE_BINARY_DIR}/include/${name})
  target_link_libraries(limpet_${name} PUBLIC ${ARG_LINKS}
    PRIVATE ${ARG_PRIVATE_LINKS} $<BUILD_INTERFACE:limpet_warnings>)
endfunction()
