#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/common/file_error.h"

namespace mirrorarm {

/// One row of a CSV file, cells without surrounding blanks. `line` counts from 1 in the file.
struct CsvRow {
  int line = 0;
  std::vector<std::string> cells;
};

/// A CSV file with a header line. Refused: missing file, no header, a row with another number of cells.
class CsvTable {
 public:
  /// Reads all of `file`. Empty lines are skipped.
  [[nodiscard]] static FromFile<CsvTable> read(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] std::span<const std::string> header() const { return header_; }
  [[nodiscard]] std::span<const CsvRow> rows() const { return rows_; }

  /// Column of `name`, or -1.
  [[nodiscard]] int column(std::string_view name) const;
  /// Columns of `names` in their order; refused with the first name that is missing.
  [[nodiscard]] FromFile<std::vector<int>> columns(std::span<const std::string_view> names) const;

  /// The finite number in a cell; refused with file, line and column.
  [[nodiscard]] FromFile<double> number(const CsvRow& row, int column) const;
  /// The whole number in a cell; refused with file, line and column.
  [[nodiscard]] FromFile<long long> integer(const CsvRow& row, int column) const;

 private:
  std::filesystem::path file_;
  std::vector<std::string> header_;
  std::vector<CsvRow> rows_;
};

/// `text` cut at `separator`, cells without surrounding blanks and carriage returns.
[[nodiscard]] std::vector<std::string> splitCells(std::string_view text, char separator);

/// The finite number that `text` is, whole and alone, '.' as the decimal sign; nothing otherwise.
[[nodiscard]] bool parseNumber(std::string_view text, double& number);

}  // namespace mirrorarm
