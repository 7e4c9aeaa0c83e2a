# Installs a build into WORK/prefix, builds the examples against it, runs them and compares their pictures.
# The numbers are SHA-256 of PPM files: softgl draws the same bytes on every machine.
set(triangle_picture da9983551212189b75689e03b191aa39b956ca3797f807b1c2295b4e7e33a610)
set(phong_sphere_picture 2c50473a45c46983fa19752ca4a7039c509e8207884b668ce0212d0f20fa7e75)
set(prefix ${WORK}/prefix)
set(libraries ${prefix}/${LIBDIR})

# Runs a command in WORK; its output is in `output`.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}: ${result}\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

function(expect what expected found)
  if(NOT expected STREQUAL found)
    message(FATAL_ERROR "${what} is ${found} and not ${expected}")
  endif()
endfunction()

function(expect_picture file expected)
  file(SHA256 ${WORK}/${file} found)
  expect(${file} "${expected}" ${found})
  file(REMOVE ${WORK}/${file})
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

# find_package(softgl)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/with_cmake -B cmake -G ${GENERATOR} -D CMAKE_C_COMPILER=${C_COMPILER}
    -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build cmake)
run(cmake/triangle)
expect("what triangle prints" "1.5 softgl ${VERSION}\n" "${output}")
expect_picture(triangle.ppm "${triangle_picture}")
run(cmake/phong_sphere)
expect_picture(phong_sphere.ppm "${phong_sphere_picture}")
run(cmake/threads)
set(of_cmake "${output}")

# softgl.pc and osmesa.pc
set(ENV{PKG_CONFIG_PATH} ${libraries}/pkgconfig:${libraries}/softgl/pkgconfig)
set(ENV{CC} ${C_COMPILER})
run(sh ${CMAKE_CURRENT_LIST_DIR}/with_pkg_config/build pkg_config)
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries} pkg_config/threads)
expect("what threads prints" "${of_cmake}" "${output}")
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries}/softgl pkg_config/triangle)
expect("what triangle prints" "1.5 softgl ${VERSION}\n" "${output}")
expect_picture(triangle.ppm "${triangle_picture}")

# The same program with the system's OSMesa: the same picture.
run(${CMAKE_COMMAND} -E env GALLIUM_OVERRIDE_CPU_CAPS=sse4.1 LD_LIBRARY_PATH= pkg_config/triangle)
if(output MATCHES softgl)
  message(FATAL_ERROR "the system's OSMesa is softgl: ${output}")
endif()
expect_picture(triangle.ppm "${triangle_picture}")
