# How every target of the project is compiled: warnings, one rounding behaviour, kernels once per instruction set.

# Includes are written <isocast/volume/grid.h> in the tree and after installation alike.
set(isocast_include_dir ${CMAKE_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${isocast_include_dir}/isocast)
foreach(folder base isa math ray scene render)
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/src/${folder} ${isocast_include_dir}/isocast/${folder} SYMBOLIC)
endforeach()
foreach(folder volume implicit cuda data_gen apps)
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${folder} ${isocast_include_dir}/isocast/${folder} SYMBOLIC)
endforeach()

# Users of an installation compile the headers' inline functions too, and the linker keeps one copy of each: so they
# share what decides the bits, and the sanitizers' libraries, but no other option.
set(isocast_user_options -ffp-contract=off)
set(isocast_sanitizers)
if(ISOCAST_SANITIZE)
  set(isocast_sanitizers -fsanitize=address,undefined)
endif()
set(isocast_own_options -Wall -Wextra -Wno-psabi -fno-math-errno -fno-trapping-math
  $<$<BOOL:${ISOCAST_WARNINGS_AS_ERRORS}>:-Werror>
  $<$<BOOL:${ISOCAST_SANITIZE}>:${isocast_sanitizers};-fno-sanitize-recover=undefined;-fno-omit-frame-pointer>)

add_library(isocast_options INTERFACE)
target_compile_features(isocast_options INTERFACE cxx_std_20)
target_include_directories(isocast_options INTERFACE
  $<BUILD_INTERFACE:${isocast_include_dir}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_options(isocast_options INTERFACE ${isocast_user_options} "$<BUILD_INTERFACE:${isocast_own_options}>")
target_link_options(isocast_options INTERFACE ${isocast_sanitizers})
target_compile_definitions(isocast_options INTERFACE
  $<BUILD_INTERFACE:$<$<BOOL:${ISOCAST_SANITIZE}>:ISOCAST_SANITIZE>>)

# A static library of the project: isocast_add_library(NAME sources...), linked by name.
function(isocast_add_library target)
  add_library(${target} STATIC ${ARGN})
  target_link_libraries(${target} PUBLIC isocast_options)
endfunction()

# An optional part with heavy dependencies, opened at run time by open_module(NAME): isocast_add_module(NAME sources...).
# The build tree has the layout of an installation, so that a program finds its modules in both.
set(ISOCAST_MODULE_DIR ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/isocast)
function(isocast_add_module name)
  add_library(isocast_module_${name} MODULE ${ARGN})
  target_link_libraries(isocast_module_${name} PRIVATE isocast_options)
  set_target_properties(isocast_module_${name} PROPERTIES PREFIX "" OUTPUT_NAME isocast_${name}
    LIBRARY_OUTPUT_DIRECTORY ${ISOCAST_MODULE_DIR} CXX_VISIBILITY_PRESET hidden)
  install(TARGETS isocast_module_${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/isocast)
endfunction()

# Kernels: the same sources once per instruction set, always -O3, in a namespace of their own (ISO_ISA):
# isocast_add_kernels(TARGET [PART NAME] [BUILD NAME DEFINITIONS WORD] sources...). A build of a name has namespaces
# ISA_NAME; a part is one of several tables of kernels in a target.
set(isocast_isas scalar sse4 avx2 avx512)
set(isocast_isa_flags_scalar -fno-tree-vectorize)
set(isocast_isa_flags_sse4 -msse4.2)
set(isocast_isa_flags_avx2 -mavx2 -mf16c)
set(isocast_isa_flags_avx512 -mavx512f -mavx512dq -mavx512bw -mavx512vl -mavx2 -mf16c -mprefer-vector-width=512)
function(isocast_add_kernels target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PART;BUILD;DEFINITIONS" "")
  if(arg_PART)
    set(arg_PART _${arg_PART})
  endif()
  foreach(isa ${isocast_isas})
    set(space ${isa})
    if(arg_BUILD)
      set(space ${isa}_${arg_BUILD})
    endif()
    set(kernels ${target}${arg_PART}_kernels_${space})
    add_library(${kernels} OBJECT ${arg_UNPARSED_ARGUMENTS})
    target_link_libraries(${kernels} PRIVATE isocast_options)
    target_compile_definitions(${kernels} PRIVATE ISO_ISA=${space} ${arg_DEFINITIONS})
    target_compile_options(${kernels} PRIVATE ${isocast_isa_flags_${isa}} -O3)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernels}>)
  endforeach()
endfunction()

# Every public header compiles alone.
function(isocast_check_headers)
  file(GLOB_RECURSE headers RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS
    ${CMAKE_SOURCE_DIR}/src/*.h ${CMAKE_SOURCE_DIR}/volume/*.h ${CMAKE_SOURCE_DIR}/implicit/*.h
    ${CMAKE_SOURCE_DIR}/data_gen/*.h ${CMAKE_SOURCE_DIR}/apps/*.h)
  set(sources)
  foreach(header ${headers})
    string(REGEX REPLACE "^src/" "" include ${header})
    string(MAKE_C_IDENTIFIER ${include} name)
    set(source ${CMAKE_BINARY_DIR}/header_check/${name}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <isocast/${include}>\n")
    list(APPEND sources ${source})
  endforeach()
  add_library(isocast_header_check OBJECT ${sources})
  target_link_libraries(isocast_header_check PRIVATE isocast)
endfunction()
