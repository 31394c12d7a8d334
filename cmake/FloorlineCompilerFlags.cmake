# Warnings, sanitizers and coverage for every target of the project; presets choose among them.
add_compile_options(-Wall -Wextra -Werror)
add_link_options(-fuse-ld=lld-19)

set(FLOORLINE_SANITIZE "" CACHE STRING "Value of -fsanitize=, for example address,undefined")
if(FLOORLINE_SANITIZE)
  add_compile_options(-fsanitize=${FLOORLINE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${FLOORLINE_SANITIZE})
endif()

option(FLOORLINE_COVERAGE "Instrument for llvm-cov" OFF)
if(FLOORLINE_COVERAGE)
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
endif()
