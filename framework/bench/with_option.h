// --with, as the subcommands of bench have it.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace pathmark::bench {

inline void addWithOption(CLI::App& command, std::string& with) {
  command
      .add_option("--with", with,
                  "Coursework: solutions (default where there are any), student, or a folder of "
                  "part*.cpp files")
      ->type_name("DIR");
}

}  // namespace pathmark::bench
