#include "core/records/database.h"

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "core/records/schema.h"

namespace mirrorarm::records {
namespace {

/// Empty counts as missing: nothing in it can be lost.
bool isMissing(const std::filesystem::path& file) {
  std::error_code none;
  return !std::filesystem::exists(file) ||
         (std::filesystem::is_regular_file(file) && std::filesystem::is_empty(file, none));
}

/// SQLite's file header: the magic text, and the application's id at byte 68, big-endian.
void requireOurs(const std::filesystem::path& file) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  std::array<char, 72> header{};
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw std::runtime_error("cannot be read");
  in.read(header.data(), header.size());
  if (!in || std::string_view(header.data(), kMagic.size()) != kMagic)
    throw std::runtime_error("is no database");
  std::uint32_t application = 0;
  for (std::size_t i = 68; i < 72; ++i)
    application = application << 8 | static_cast<unsigned char>(header[i]);
  if (application != kApplicationId) throw std::runtime_error("is a database of another program");
}

std::unique_ptr<soci::session> connected(const std::filesystem::path& file) {
  if (file.string().find('"') != std::string::npos)
    throw std::runtime_error("has a quotation mark in its path");
  auto sql = std::make_unique<soci::session>(soci::sqlite3, "dbname=\"" + file.string() + "\" timeout=5");
  // Not in the connection's text: SOCI would leak the connection where a damaged file refuses it there.
  *sql << "pragma synchronous = full";
  *sql << "pragma foreign_keys = on";
  // A damaged or forged file is read with SQLite's extra checks.
  *sql << "pragma trusted_schema = off";
  *sql << "pragma cell_size_check = on";
  return sql;
}

void requireKnownVersion(soci::session& sql) {
  const int version = schemaVersion(sql);
  if (version == kSchemaVersion) return;
  throw std::runtime_error("is of version " + std::to_string(version) + ", this program knows version " +
                           std::to_string(kSchemaVersion));
}

// After the tables, so that the header that requireOurs() reads is never in the log alone.
void useWriteAheadLog(soci::session& sql) {
  std::string mode;
  sql << "pragma journal_mode = wal", soci::into(mode);
  if (mode != "wal") throw std::runtime_error("does not take a write-ahead log");
}

}  // namespace

std::unique_ptr<soci::session> openDatabase(const std::filesystem::path& file, WhenMissing missing) {
  const bool is_new = isMissing(file);
  if (is_new && missing == WhenMissing::kRefuse) throw std::runtime_error("is missing or empty");
  if (!is_new) requireOurs(file);
  if (is_new && file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  auto sql = connected(file);
  if (is_new) makeSchema(*sql);
  migrateSchema(*sql);
  requireKnownVersion(*sql);
  useWriteAheadLog(*sql);
  return sql;
}

}  // namespace mirrorarm::records
