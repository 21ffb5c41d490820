# One interface target carries the compiler settings, so that no target differs by accident.
# Never -ffast-math: sums have a fixed order and NaN must stay visible. Without errno, which nobody reads, square
# roots are one instruction; their results are the same.

add_library(shprt_settings INTERFACE)
target_compile_options(shprt_settings INTERFACE
  -fno-math-errno
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough
  # GCC 12 sees overlapping copies in std::string concatenation that are not there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${SHPRT_WERROR}>:-Werror>)
if(SHPRT_SANITIZE)
  target_compile_options(shprt_settings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(shprt_settings INTERFACE -fsanitize=address,undefined)
endif()

# For code that compiles slowly and never computes much: GCC takes 40% less time over it than with -O1 or -O3.
set(SHPRT_LIGHT_OPTIMISATION $<$<CXX_COMPILER_ID:GNU>:-Og>)
