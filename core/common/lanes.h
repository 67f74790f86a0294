#pragma once

#include <cstdint>
#include <cstring>

/// Short vectors for the few loops that must run at the speed of the machine. They are the compiler's own
/// (GCC and Clang): eight floats are one AVX2 register, two of SSE2 or NEON. A function marked
/// MIRRORARM_VECTOR_CODE is compiled twice on x86-64, for every processor and for those with AVX2 and FMA,
/// and the loader picks; elsewhere it is compiled once. Everything that it calls must be inlined.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define MIRRORARM_VECTOR_CODE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define MIRRORARM_VECTOR_CODE
#endif
#define MIRRORARM_INLINE inline __attribute__((always_inline))

namespace mirrorarm::lanes {

inline constexpr int kCount = 8;
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));
using Bytes = std::uint8_t __attribute__((vector_size(32)));
using Longs = std::uint64_t __attribute__((vector_size(32)));
using FewBytes = std::uint8_t __attribute__((vector_size(8)));

MIRRORARM_INLINE Floats all(float value) { return Floats{} + value; }
MIRRORARM_INLINE Floats counting() { return Floats{0, 1, 2, 3, 4, 5, 6, 7}; }

/// Eight bytes as floats; `bytes` needs no alignment.
MIRRORARM_INLINE Floats floatsOf(const std::uint8_t* bytes) {
  std::int32_t whole[kCount];
  for (int i = 0; i < kCount; ++i) whole[i] = bytes[i];
  Ints ints;
  std::memcpy(&ints, whole, sizeof ints);
  return __builtin_convertvector(ints, Floats);
}

template <class To, class From>
MIRRORARM_INLINE To sameBits(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

/// Of each eight bytes side by side the largest, and their sum, as 64-bit numbers.
MIRRORARM_INLINE Longs largestOfEights(Bytes bytes) {
  for (int bits = 32; bits >= 8; bits /= 2) {
    const auto shifted = sameBits<Bytes>(sameBits<Longs>(bytes) >> bits);
    bytes = shifted > bytes ? shifted : bytes;
  }
  return sameBits<Longs>(bytes) & 0xff;
}

MIRRORARM_INLINE Longs sumsOfEights(const Bytes& bytes) {
  Longs sums = sameBits<Longs>(bytes);
  sums = (sums & 0x00ff00ff00ff00ff) + ((sums >> 8) & 0x00ff00ff00ff00ff);
  sums = (sums & 0x0000ffff0000ffff) + ((sums >> 16) & 0x0000ffff0000ffff);
  return (sums + (sums >> 32)) & 0xffff;
}

MIRRORARM_INLINE void store(float* to, const Floats& values) { std::memcpy(to, &values, sizeof values); }

MIRRORARM_INLINE float sum(const Floats& values) {
  return ((values[0] + values[4]) + (values[1] + values[5])) +
         ((values[2] + values[6]) + (values[3] + values[7]));
}

MIRRORARM_INLINE Floats least(const Floats& a, const Floats& b) { return a < b ? a : b; }
MIRRORARM_INLINE Floats most(const Floats& a, const Floats& b) { return a > b ? a : b; }

/// 1 / sqrt(x) for x > 0, to 5e-6 relative: a guess from the exponent, two steps of Newton's.
MIRRORARM_INLINE Floats inverseRoot(const Floats& x) {
  Ints bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = 0x5f3759df - (bits >> 1);
  Floats y;
  std::memcpy(&y, &bits, sizeof y);
  const Floats half = 0.5F * x;
  for (int step = 0; step < 2; ++step) y *= 1.5F - half * y * y;
  return y;
}

/// exp(x) for -80 <= x <= 0, to 2e-7 relative: a power of two times a polynomial on half an octave.
MIRRORARM_INLINE Floats exponential(const Floats& x) {
  const Floats octaves = x * 1.44269504F - 0.5F;
  const Ints whole = __builtin_convertvector(octaves, Ints);  // towards zero: the nearest, as octaves < 0
  const Floats f = (x - __builtin_convertvector(whole, Floats) * 0.693359375F) +
                   __builtin_convertvector(whole, Floats) * 2.12194440e-4F;
  Floats p = 1.9875691500e-4F * f + 1.3981999507e-3F;
  p = p * f + 8.3334519073e-3F;
  p = p * f + 4.1665795894e-2F;
  p = p * f + 1.6666665459e-1F;
  p = p * f + 5.0000001201e-1F;
  p = p * f * f + f + 1.0F;
  const Ints power = (whole + 127) << 23;
  Floats scale;
  std::memcpy(&scale, &power, sizeof scale);
  return p * scale;
}

}  // namespace mirrorarm::lanes
