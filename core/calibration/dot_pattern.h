#pragma once

namespace mirrorarm::calibration {

/// Which dots of a dot plate are large. The plate of C columns and R rows is the cut of columns 0..C-1 and
/// rows 0..R-1 of one endless pattern, so that every dot of every plate has the same size wherever the plate
/// ends: what a camera sees tells where on the pattern it lies, also beyond the edge of the plate asked for.
///
/// The pattern is a pseudo-random array: the recurrence of period 65535 given by a primitive polynomial of
/// degree 16, laid along the diagonal of 255 columns by 257 rows, after which it repeats. No two of its
/// windows of 4 by 4 dots are equal, and within 9 by 7 dots any two of them, turned by quarters or mirrored
/// in any way, differ in 3 dots and more. Source: MacWilliams, Sloane, Pseudo-random sequences and arrays,
/// Proc. IEEE 64(12), 1976.
[[nodiscard]] bool isLargeDot(int column, int row);

/// Diameters of the discs as shares of the step from centre to centre.
inline constexpr double kSmallDotShare = 0.4;
inline constexpr double kLargeDotShare = 0.6;

}  // namespace mirrorarm::calibration
