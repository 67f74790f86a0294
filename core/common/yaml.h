#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/common/file_error.h"

namespace mirrorarm {

/// One place in a YAML file, read strictly: what is missing, unknown or of the wrong kind throws YamlProblem
/// with its line. For the readers of our own formats; they catch it at their rim with `readYaml`.
class YamlNode {
 public:
  /// A key that must be there.
  [[nodiscard]] YamlNode operator[](std::string_view key) const;
  /// True when the map holds the key.
  [[nodiscard]] bool has(std::string_view key) const;
  /// Item `i` of a list.
  [[nodiscard]] YamlNode operator[](std::size_t i) const;
  [[nodiscard]] std::size_t size() const;

  [[nodiscard]] double number() const;  ///< finite
  [[nodiscard]] long long integer() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool flag() const;
  [[nodiscard]] std::vector<double> numbers() const;    ///< a list of finite numbers
  [[nodiscard]] Eigen::Vector3d vector3() const;        ///< a list of three
  [[nodiscard]] Eigen::Quaterniond quaternion() const;  ///< a list x, y, z, w; unit to 1 %, then normalised

  /// Refuses keys that are not among `known`, so that a misspelt key is not silently ignored.
  void allowOnly(std::initializer_list<std::string_view> known) const;

  /// Throws the refusal for this place.
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  friend struct YamlDocument;
  struct Body;
  explicit YamlNode(std::shared_ptr<const Body> body) : body_(std::move(body)) {}
  std::shared_ptr<const Body> body_;
};

/// Thrown by YamlNode, caught by readYaml alone.
struct YamlProblem {
  int line = 0;
  std::string reason;
};

/// Opens a YAML file; `format` is the tag that its key `format` must carry, empty for none.
[[nodiscard]] FromFile<YamlNode> openYaml(const std::filesystem::path& file, std::string_view format);

/// Opens `file` and lets `read` (YamlNode -> T) make the value; every refusal becomes a FileError.
template <class Read>
[[nodiscard]] auto readYaml(const std::filesystem::path& file, std::string_view format, Read read)
    -> FromFile<decltype(read(std::declval<const YamlNode&>()))> {
  const auto root = openYaml(file, format);
  if (!root) return unexpected(root.error());
  try {
    return read(*root);
  } catch (const YamlProblem& problem) {
    return unexpected(FileError{file, problem.line, problem.reason});
  }
}

}  // namespace mirrorarm
