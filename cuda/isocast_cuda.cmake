# The module: found are nvcc (12.2 or newer, of the toolkit that also has cuda.h and nvrtc.h) and bin2c.
option(ISOCAST_CUDA "Build the kernels for GPUs" ON)
set(ISOCAST_CUDA_ARCHITECTURES 75 90 CACHE STRING
  "Compute capabilities with machine code in the program; PTX of the first is added, which drivers translate for others")
find_program(NVCC nvcc PATHS /usr/local/cuda/bin)
set(isocast_cuda_module OFF)
if(NOT ISOCAST_CUDA)
  message(STATUS "CUDA was switched off: no --isa cuda")
elseif(NOT NVCC)
  message(STATUS "nvcc was not found: no --isa cuda")
else()
  execute_process(COMMAND ${NVCC} --version OUTPUT_VARIABLE version ERROR_QUIET)
  string(REGEX MATCH "release ([0-9]+)\\.([0-9]+)" version "${version}")
  set(nvcc_major ${CMAKE_MATCH_1})
  set(nvcc_version ${CMAKE_MATCH_1}.${CMAKE_MATCH_2})
  get_filename_component(nvcc_folder ${NVCC} REALPATH)
  get_filename_component(nvcc_folder ${nvcc_folder} DIRECTORY)
  find_program(BIN2C bin2c HINTS ${nvcc_folder})
  find_path(CUDA_INCLUDE_DIR cuda.h HINTS ${nvcc_folder}/../include ${nvcc_folder}/../targets/x86_64-linux/include)
  find_path(NVRTC_INCLUDE_DIR nvrtc.h HINTS ${CUDA_INCLUDE_DIR})
  if(nvcc_version VERSION_LESS 12.2)
    message(STATUS "nvcc ${nvcc_version} was found and 12.2 is needed: no --isa cuda")
  elseif(NOT BIN2C OR NOT CUDA_INCLUDE_DIR OR NOT NVRTC_INCLUDE_DIR)
    message(STATUS "nvcc was found, but not bin2c, cuda.h and nvrtc.h with it: no --isa cuda")
  else()
    set(isocast_cuda_module ON)
  endif()
endif()

# Some kernels of volume_kernels.cu as a C array of their fat binary; what the compiler says of their registers and stacks
# is kept in NAME.log, for the test of budgets.
function(isocast_add_fatbin name precision grids)
  set(gencode)
  foreach(architecture ${ISOCAST_CUDA_ARCHITECTURES})
    list(APPEND gencode -gencode arch=compute_${architecture},code=sm_${architecture})
  endforeach()
  list(GET ISOCAST_CUDA_ARCHITECTURES 0 first)
  list(APPEND gencode -gencode arch=compute_${first},code=compute_${first})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${name})
  add_custom_command(OUTPUT ${out}.fatbin ${out}.log
    COMMAND ${NVCC} -std=c++20 -O3 -fmad=false --expt-relaxed-constexpr -fatbin -Xptxas -v -Werror all-warnings
      ${gencode} -DISO_PRECISION=${precision} -DISO_EACH_GRID_OF=ISO_EACH_${grids}_GRID
      -I ${isocast_include_dir} -MD -MF ${out}.d -o ${out}.fatbin
      ${CMAKE_CURRENT_SOURCE_DIR}/volume_kernels.cu > ${out}.log 2>&1 || ${CMAKE_COMMAND} -E cat ${out}.log && test -s ${out}.fatbin
    DEPENDS volume_kernels.cu DEPFILE ${out}.d VERBATIM COMMENT "GPU kernels ${name}")
  add_custom_command(OUTPUT ${out}.c
    COMMAND ${BIN2C} --type longlong --name isocast_${name} ${out}.fatbin > ${out}.c
    DEPENDS ${out}.fatbin VERBATIM)
endfunction()
