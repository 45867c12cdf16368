#pragma once

namespace dualarm {

/// Sine of an angle (rad), to 1 unit in the last place of what it is and at most 1e-25 of the angle more. The planner
/// takes some ten thousand of them for a plan, and the C library's spend two thirds of their time on setting the
/// processor's rounding mode; these expect it to be as it is everywhere, to nearest. Verification keeps to the
/// library's, which is also what these are tested against.
/// Method and coefficients: Sun's fdlibm, k_sin.c and k_cos.c.
double sine(double angle);

struct SineCosine {
  double sine = 0.0;
  double cosine = 1.0;
};
SineCosine sine_cosine(double angle);

}  // namespace dualarm
