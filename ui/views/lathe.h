#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <vtkSmartPointer.h>

class vtkPolyData;

namespace mirrorarm::ui {

/// A point of an outline that turns about the z axis: how far up and how far out [m].
struct OutlinePoint {
  double z = 0.0;
  double radius = 0.0;
};

/// The closed surface that `outline`, from bottom to top, sweeps about z, with smooth normals. An oval cross
/// section has `flatness` below 1: the half axis along y over the one along x.
[[nodiscard]] vtkSmartPointer<vtkPolyData> lathe(std::span<const OutlinePoint> outline,
                                                 double flatness = 1.0);

/// Outline of a capsule of `length` between the centres of its round ends, from z = 0 to z = length.
[[nodiscard]] std::vector<OutlinePoint> capsuleOutline(double length, double radius);

/// Outline of a drum with rounded edges, centred at z = 0.
[[nodiscard]] std::vector<OutlinePoint> drumOutline(double height, double radius, double edge);

}  // namespace mirrorarm::ui
