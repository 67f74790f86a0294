#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/common/expected.h"
#include "core/therapy/session_measures.h"

namespace mirrorarm::records {

/// A person in therapy. The code is what exports show; the name never leaves the store.
struct Patient {
  std::int64_t id = 0;
  std::string code;  ///< unique, for example "P-0001"
  std::string name;
  int birth_year = 0;         ///< 0 unknown
  std::string impaired_side;  ///< "left", "right" or empty
};

/// One session, as it is listed.
struct Session {
  std::int64_t id = 0;
  std::int64_t patient_id = 0;
  std::string started_at;  ///< ISO 8601 UTC, as are all calendar times here
  std::string ended_at;    ///< empty while it runs or when it was cut off
  std::string exercise;
  std::string mapping;     ///< "follow" or "mirror"
  std::string end_reason;  ///< "finished", or a stop reason's id
  std::string software;    ///< version that recorded it
  bool simulated = false;
  therapy::SessionMeasures measures;  ///< zero until it is finished
};

/// Why the store refused or failed: one line for an engineer.
struct StoreError {
  std::string reason;
};
template <class T>
using FromStore = Expected<T, StoreError>;

/// Patients, sessions and samples in one database, SQLite here (SOCI inside). Every call is one transaction:
/// what it returned is on the disc. One thread at a time.
class Store {
 public:
  /// Opens or makes the database at `file`. Refused: a file that is no database of ours or of a newer
  /// version.
  [[nodiscard]] static FromStore<std::unique_ptr<Store>> open(const std::filesystem::path& file);
  /// The same, but refuses a file that does not exist.
  [[nodiscard]] static FromStore<std::unique_ptr<Store>> openExisting(const std::filesystem::path& file);
  ~Store();

  [[nodiscard]] FromStore<std::int64_t> addPatient(const Patient& patient);
  [[nodiscard]] FromStore<std::vector<Patient>> patients();
  [[nodiscard]] FromStore<Patient> patient(std::int64_t id);

  /// Begins a session and gives its id; `session.id`, the end and the measures are ignored. An empty
  /// `started_at` becomes now.
  [[nodiscard]] FromStore<std::int64_t> beginSession(const Session& session);
  /// All or none of them; refused when a number is not finite or the session is finished. Poses that a sample
  /// does not have (target when lost, goal outside training) come back as identity.
  [[nodiscard]] FromStore<void> addSamples(std::int64_t session, std::span<const therapy::Sample> samples);
  /// A line of the session's log: time since its start, what happened ("stop.operator", ...). Refused when
  /// the session is finished.
  [[nodiscard]] FromStore<void> addEvent(std::int64_t session, double time_s, const std::string& event);
  /// Ends the session now, once; nothing can be added afterwards.
  [[nodiscard]] FromStore<void> finishSession(std::int64_t session, const std::string& end_reason,
                                              const therapy::SessionMeasures& measures);

  [[nodiscard]] FromStore<std::vector<Session>> sessions();
  [[nodiscard]] FromStore<Session> session(std::int64_t id);
  [[nodiscard]] FromStore<std::vector<therapy::Sample>> samples(std::int64_t session);
  struct Event {
    double time_s = 0.0;
    std::string event;
  };
  [[nodiscard]] FromStore<std::vector<Event>> events(std::int64_t session);

 private:
  struct Body;
  explicit Store(std::unique_ptr<Body> body);
  std::unique_ptr<Body> body_;
};

}  // namespace mirrorarm::records
