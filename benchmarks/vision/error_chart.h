#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mirrorarm::benchmarks::vision {

/// Curves of positive numbers over positive numbers, both axes logarithmic, drawn into a picture.
class Chart {
 public:
  struct Point {
    double x = 0.0, y = 0.0;
  };

  Chart(std::string title, std::string x_title, std::string y_title)
      : title_(std::move(title)), x_title_(std::move(x_title)), y_title_(std::move(y_title)) {}

  /// A further point of the curve of that name; what is no positive number is left out.
  void add(const std::string& curve, const Point& point);
  /// Throws std::runtime_error when the picture cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  struct Curve {
    std::string name;
    std::vector<Point> points;
  };

  std::string title_;
  std::string x_title_;
  std::string y_title_;
  std::vector<Curve> curves_;
};

}  // namespace mirrorarm::benchmarks::vision
