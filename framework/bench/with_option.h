// --with, as the subcommands of bench have it.
#pragma once

#include "host/session.h"

#include <CLI/CLI.hpp>

#include <string>

namespace pathmark::bench {

inline void addWithOption(CLI::App& command, std::string& with) {
  command.add_option("--with", with, "Coursework: " + courseworkChoices(solvedCoursework()))
      ->type_name("DIR");
}

}  // namespace pathmark::bench
