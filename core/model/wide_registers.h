#pragma once

namespace dualarm {

#if defined(__x86_64__)
/// The same function, compiled once more with all that it calls, for processors with AVX2.
template <typename Computation>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] void compute_with_avx2(const Computation& computation) {
  computation();
}
#endif

/// Computes something with the widest registers that the processor has. Numbers are the same with all of them: each
/// lane is rounded as it would be alone, and no product is fused with a sum. What is called must be small enough to be
/// compiled in; vectors wider than two numbers must not be passed by value to anything that is not always inlined.
template <typename Computation>
void with_wide_registers(const Computation& computation) {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx2) return compute_with_avx2(computation);
#endif
  computation();
}

}  // namespace dualarm
