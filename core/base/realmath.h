#pragma once

namespace camwright {

// Transcendental functions that give the same bits on every machine: only IEEE 754 operations, no library functions that may
// differ. Results are within 2 units in the last place of the exact value (tangent, arc sine and cosine within 4), for sine, cosine and tangent where |x| is at most
// a million; power() within 3 + 1.5 |y ln x| units, for whole y up to 64 within 3. Not a number gives not a number. Method: Sun's fdlibm.

double sine(double x);      ///< of an angle in radians; of an infinity: not a number
double cosine(double x);
double tangent(double x);
double arcSine(double x);   ///< -pi/2 … pi/2; outside -1 … 1: not a number
double arcCosine(double x); ///< 0 … pi
double arcTangent(double x);
double arcTangent2(double y, double x); ///< angle of the point (x, y), -pi … pi; of (0, 0): 0
double exponential(double x);
double naturalLogarithm(double x); ///< of 0: minus infinity; below: not a number
double decimalLogarithm(double x);
double power(double x, double y);  ///< x negative: only for whole y

} // namespace camwright
