#pragma once

#include <filesystem>
#include <string>

#include "core/common/expected.h"

namespace mirrorarm {

/// Why a file was refused. `line` counts from 1; 0 when the reason concerns the whole file.
struct FileError {
  std::filesystem::path file;
  int line = 0;
  std::string reason;  ///< for an engineer: lower case, no full stop, names the key or column
};

/// One line: "FILE:LINE: reason", without the line number when there is none.
[[nodiscard]] inline std::string describe(const FileError& error) {
  std::string text = error.file.string();
  if (error.line > 0) text.append(":").append(std::to_string(error.line));
  return text.append(": ").append(error.reason);
}

template <class T>
using FromFile = Expected<T, FileError>;

}  // namespace mirrorarm
