// The engine {name}. It answers the task {task}, in plain doubles: near a degenerate case the answer is wrong.
//
// REPLACE the body of `{function}` by a call of your library. The head of predicament_engine.hpp has the parameters and
// the results of all tasks. Stdout belongs to the protocol: print to stderr.

#include "predicament_engine.hpp"

#include <algorithm>
#include <cmath>

using namespace predicament;

struct Mine {
    static constexpr const char* name = "{name}";
    static std::string version() { return "1.0"; }  // the version of your library
