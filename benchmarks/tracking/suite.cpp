#include "benchmarks/tracking/suite.h"

namespace mirrorarm::benchmarks::tracking {

Suite suite() { return {"tracking", "Tracking, from points to poses", {}}; }

}  // namespace mirrorarm::benchmarks::tracking
