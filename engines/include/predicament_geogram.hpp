// geogram as an engine uses it: quiet, and with the parameters that its algorithms look up.

#pragma once

#include <geogram/basic/command_line.h>
#include <geogram/basic/command_line_args.h>
#include <geogram/basic/common.h>
#include <geogram/basic/environment.h>
#include <geogram/basic/logger.h>

#include <exception>

// The wheel's library was compiled by GCC 13, whose runtime has this function; earlier runtimes lack it.
extern "C" [[gnu::weak]] void __cxa_call_terminate(void*) noexcept { std::terminate(); }

namespace predicament {

/// The version of geogram, which is ready for use then.
inline std::string start_geogram() {
    GEO::initialize(GEO::GEOGRAM_INSTALL_NONE);
    GEO::Logger::instance()->set_quiet(true);
    GEO::CmdLine::import_arg_group("standard");
    GEO::CmdLine::import_arg_group("algo");
    return GEO::Environment::instance()->get_value("version");
}

}  // namespace predicament
