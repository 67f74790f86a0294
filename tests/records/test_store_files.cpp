#include <fstream>
#include <iterator>
#include <random>
#include <sys/wait.h>

#include <gtest/gtest.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "tests/records/recorded.h"

namespace mirrorarm::records {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// A small store, closed, so that all of it lies in one file.
void makeSmallStore(const std::filesystem::path& file) {
  const auto store = std::move(*Store::open(file));
  const auto patient = *store->addPatient({0, "P-0001", "", 0, ""});
  const auto session = *store->beginSession(anySession(patient));
  ASSERT_TRUE(store->addSamples(session, anySamples(40)));
  ASSERT_TRUE(store->addEvent(session, 1.0, "start"));
  ASSERT_TRUE(store->finishSession(session, "finished", anyMeasures()));
}

/// Asks a store for all that it has; what comes back does not matter, that it comes back does.
void readEverything(Store& store) {
  (void)store.patients();
  const auto sessions = store.sessions();
  if (!sessions) return;
  for (const auto& session : *sessions) {
    (void)store.samples(session.id);
    (void)store.events(session.id);
  }
}

TEST(StoreFiles, AreMadeWithTheirFoldersAndFoundAgain) {
  const Folder folder;
  const auto file = folder.path / "new folder" / "store.sqlite";
  ASSERT_TRUE(Store::open(file));
  ASSERT_TRUE(Store::open(file));
  EXPECT_TRUE(Store::openExisting(file));
}

TEST(StoreFiles, AMissingOneIsNotMadeByReading) {
  const Folder folder;
  const auto store = Store::openExisting(folder.store());
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().reason, folder.store().string() + ": is missing or empty");
  EXPECT_FALSE(std::filesystem::exists(folder.store()));
}

/// Records in a process of its own that ends as in a crash: nothing is closed, the log is left beside the
/// file.
bool crashAfter(const std::filesystem::path& file, std::span<const therapy::Sample> samples) {
  const auto child = ::fork();
  if (child == 0) {
    const auto store = std::move(*Store::open(file));
    const auto session = *store->beginSession(anySession(*store->addPatient({0, "P-0001", "", 0, ""})));
    ::_exit(store->addSamples(session, samples) ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  return status == 0;
}

TEST(StoreFiles, ASessionCutOffStaysReadable) {
  const Folder folder;
  const auto samples = anySamples(48);
  ASSERT_TRUE(crashAfter(folder.store(), samples));
  const auto store = Store::openExisting(folder.store());
  ASSERT_TRUE(store) << store.error().reason;
  ASSERT_EQ((*store)->sessions()->size(), 1u);
  EXPECT_TRUE((*store)->session(1)->ended_at.empty());
  EXPECT_EQ((*store)->samples(1)->size(), samples.size());
}

TEST(StoreFiles, AReaderSeesWhatAWriterHasAddedSoFar) {
  const Folder folder;
  const auto writer = std::move(*Store::open(folder.store()));
  const auto session = *writer->beginSession(anySession(*writer->addPatient({0, "P-0001", "", 0, ""})));
  const auto reader = std::move(*Store::openExisting(folder.store()));
  for (std::size_t batches = 1; batches <= 3; ++batches) {
    ASSERT_TRUE(writer->addSamples(session, anySamples(24)));
    EXPECT_EQ(reader->samples(session)->size(), 24 * batches);
  }
  EXPECT_TRUE(reader->addPatient({0, "P-0002", "", 0, ""}));
  EXPECT_EQ(writer->patients()->size(), 2u);
}

TEST(StoreFiles, ForeignOnesAreRefusedAndLeftUntouched) {
  const Folder folder;
  const std::string other_database = std::string("SQLite format 3\0", 16) + std::string(4080, '\1');
  for (const std::string& bytes :
       {std::string("x"), std::string(5000, '?'), std::string("%PDF-1.4 of somebody\n"),
        std::string("SQLite format 3\0", 16), other_database}) {
    writeBytes(folder.store(), bytes);
    for (const auto& store : {Store::open(folder.store()), Store::openExisting(folder.store())}) {
      ASSERT_FALSE(store);
      EXPECT_EQ(store.error().reason.rfind(folder.store().string(), 0), 0u);
    }
    EXPECT_EQ(bytesOf(folder.store()), bytes);
  }
  EXPECT_FALSE(Store::open(folder.path));
}

TEST(StoreFiles, ANewerVersionIsRefused) {
  const Folder folder;
  makeSmallStore(folder.store());
  soci::session(soci::sqlite3, "dbname=\"" + folder.store().string() + "\"")
      << "update store set version = 3";
  const auto store = Store::open(folder.store());
  ASSERT_FALSE(store);
  EXPECT_NE(store.error().reason.find("is of version 3, this program knows version 2"), std::string::npos);
}

/// Takes away what version 2 brought.
void makeItVersion1(const std::filesystem::path& file) {
  soci::session sql(soci::sqlite3, "dbname=\"" + file.string() + "\"");
  for (const char* column : {"force_share", "help_level", "help_adapting_share"})
    sql << std::string("alter table session_measures drop column ") + column;
  for (const char* column : {"force_share", "help_level", "help_adapts"})
    sql << std::string("alter table sample drop column ") + column;
  sql << "update store set version = 1";
}

TEST(StoreFiles, AnOlderVersionIsBroughtUpAndNothingIsLost) {
  const Folder folder;
  makeSmallStore(folder.store());
  makeItVersion1(folder.store());
  for (int opening = 0; opening < 2; ++opening) {
    const auto opened = Store::openExisting(folder.store());
    ASSERT_TRUE(opened) << opened.error().reason;
    Store& store = **opened;
    const auto measures = store.session(1)->measures;
    EXPECT_EQ(measures.lag_ms, anyMeasures().lag_ms);
    EXPECT_FALSE(measures.force_share || measures.help_level || measures.help_adapting_share);
    const auto samples = store.samples(1);
    ASSERT_EQ(samples->size(), 40u);
    EXPECT_FALSE(samples->back().force_share || samples->back().help_level || samples->back().help_adapts);
    EXPECT_EQ(samples->back().rms_m, anySamples(40).back().rms_m);
    const auto next = store.beginSession(anySession(1));
    EXPECT_TRUE(store.addSamples(*next, anySamples(7)));
    EXPECT_EQ(store.samples(*next)->at(1).force_share, anySamples(2)[1].force_share);
    EXPECT_TRUE(store.finishSession(*next, "finished", anyMeasures()));
    EXPECT_EQ(store.session(*next)->measures.help_level, anyMeasures().help_level);
  }
}

TEST(StoreFiles, DamagedOnesNeverCrash) {
  const Folder folder;
  makeSmallStore(folder.store());
  const auto good = bytesOf(folder.store());
  std::mt19937 random(9);
  for (int round = 0; round < 300; ++round) {
    auto bytes = good;
    if (round % 4 == 0) bytes.resize(random() % bytes.size());
    for (int hits = 1 + static_cast<int>(random() % 40); hits > 0 && !bytes.empty(); --hits)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    for (const char* rest : {"-wal", "-shm", "-journal"})
      std::filesystem::remove(folder.store().string() + rest);
    writeBytes(folder.store(), bytes);
    if (const auto store = Store::openExisting(folder.store())) readEverything(**store);
  }
}

TEST(StoreFiles, ADamagedLogNeverCrashes) {
  const Folder folder;
  ASSERT_TRUE(crashAfter(folder.store(), anySamples(48)));
  const std::filesystem::path log = folder.store().string() + "-wal";
  const auto good = bytesOf(folder.store()), good_log = bytesOf(log);
  ASSERT_FALSE(good_log.empty());
  std::mt19937 random(13);
  for (int round = 0; round < 100; ++round) {
    auto bytes = good_log;
    if (round % 4 == 0) bytes.resize(random() % bytes.size());
    for (int hits = 1 + static_cast<int>(random() % 10); hits > 0 && !bytes.empty(); --hits)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    std::filesystem::remove(folder.store().string() + "-shm");
    writeBytes(folder.store(), good);
    writeBytes(log, bytes);
    if (const auto store = Store::openExisting(folder.store())) readEverything(**store);
  }
}

}  // namespace
}  // namespace mirrorarm::records
