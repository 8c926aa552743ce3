#include "host/framework_names.h"

#include "host/build_files.h"
#include "host/object_symbols.h"

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <system_error>

#include <cxxabi.h>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

std::string readObject(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::system_error(errno, std::generic_category(), file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

// All that the framework's objects offer one another, less what coursework is given.
std::set<std::string> readHiddenNames() {
  std::set<std::string> names;
  for (const std::string& object : readLines(kBuildFolder / "worker_objects.txt")) {
    const std::string bytes = readObject(object);
    for (std::string& name : symbolsOf(std::as_bytes(std::span(bytes))).offered)
      if (name.find("8pathmark") != std::string::npos) names.insert(std::move(name));
  }
  for (const char* given : {"public.symbols", "contract.symbols"})
    for (const std::string& name : readLines(kProjectFolder / "framework/worker" / given))
      names.erase(name);
  return names;
}

std::string asPeopleWriteIt(const std::string& name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> plain(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), std::free);
  return status == 0 ? plain.get() : name;
}

}  // namespace

std::optional<std::string> hiddenNameUsedBy(std::span<const std::byte> object) {
  static const std::set<std::string> hidden = readHiddenNames();
  for (const std::string& name : symbolsOf(object).used)
    if (hidden.contains(name)) return asPeopleWriteIt(name);
  return std::nullopt;
}

}  // namespace pathmark
