#include "core/common/yaml.h"

#include <algorithm>
#include <cmath>

#include <yaml-cpp/yaml.h>

#include "core/common/csv.h"

namespace mirrorarm {

struct YamlNode::Body {
  YAML::Node node;
  std::string path;  ///< the key's full name, for the reason
};

struct YamlDocument {
  static YamlNode node(YAML::Node node, std::string path) {
    return YamlNode(std::make_shared<const YamlNode::Body>(YamlNode::Body{std::move(node), std::move(path)}));
  }
};

void YamlNode::refuse(const std::string& reason) const {
  throw YamlProblem{body_->node.Mark().line + 1, body_->path.empty() ? reason : body_->path + " " + reason};
}

bool YamlNode::has(std::string_view key) const {
  return body_->node.IsMap() && body_->node[std::string(key)].IsDefined();
}

YamlNode YamlNode::operator[](std::string_view key) const {
  const std::string path = body_->path.empty() ? std::string(key) : body_->path + "." + std::string(key);
  if (!body_->node.IsMap()) refuse("is not a map");
  const YAML::Node child = body_->node[std::string(key)];
  if (!child.IsDefined()) throw YamlProblem{body_->node.Mark().line + 1, path + " is missing"};
  return YamlDocument::node(child, path);
}

YamlNode YamlNode::operator[](std::size_t i) const {
  if (i >= size()) refuse("has too few items");
  return YamlDocument::node(body_->node[i], body_->path + "[" + std::to_string(i) + "]");
}

std::size_t YamlNode::size() const {
  if (!body_->node.IsSequence()) refuse("is not a list");
  return body_->node.size();
}

std::string YamlNode::text() const {
  if (!body_->node.IsScalar()) refuse("is not a single value");
  return body_->node.Scalar();
}

double YamlNode::number() const {
  double value = 0.0;
  if (!parseNumber(text(), value)) refuse("is not a finite number");
  return value;
}

long long YamlNode::integer() const {
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > 9e15) refuse("is not a whole number");
  return static_cast<long long>(value);
}

bool YamlNode::flag() const {
  const auto value = text();
  if (value != "true" && value != "false") refuse("is neither true nor false");
  return value == "true";
}

std::vector<double> YamlNode::numbers() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < size(); ++i) values.push_back((*this)[i].number());
  return values;
}

Eigen::Vector3d YamlNode::vector3() const {
  const auto values = numbers();
  if (values.size() != 3) refuse("does not hold three numbers");
  return {values[0], values[1], values[2]};
}

Eigen::Quaterniond YamlNode::quaternion() const {
  const auto values = numbers();
  if (values.size() != 4) refuse("does not hold four numbers");
  const Eigen::Quaterniond q(values[3], values[0], values[1], values[2]);
  if (std::abs(q.norm() - 1.0) > 0.01) refuse("is not a unit quaternion");
  return q.normalized();
}

void YamlNode::allowOnly(std::initializer_list<std::string_view> known) const {
  if (!body_->node.IsMap()) refuse("is not a map");
  for (const auto& entry : body_->node) {
    const auto key = entry.first.IsScalar() ? entry.first.Scalar() : std::string("?");
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw YamlProblem{entry.first.Mark().line + 1,
                        (body_->path.empty() ? key : body_->path + "." + key) + " is unknown"};
  }
}

FromFile<YamlNode> openYaml(const std::filesystem::path& file, std::string_view format) {
  try {
    const auto root = YamlDocument::node(YAML::LoadFile(file.string()), "");
    if (!format.empty()) {
      const auto found = root["format"].text();
      if (found != format)
        root["format"].refuse("is '" + found + "' where '" + std::string(format) + "' is read");
    }
    return root;
  } catch (const YAML::BadFile&) {
    return unexpected(FileError{file, 0, "cannot be read"});
  } catch (const YAML::Exception& problem) {
    return unexpected(FileError{file, problem.mark.line + 1, problem.msg});
  } catch (const YamlProblem& problem) {
    return unexpected(FileError{file, problem.line, problem.reason});
  }
}

}  // namespace mirrorarm
