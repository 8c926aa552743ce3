#include "grading/build_record.h"

#include "host/build_config.h"
#include "host/content_hash.h"
#include "host/coursework_builder.h"
#include "host/subprocess.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

namespace pathmark::grading {

namespace {

namespace fs = std::filesystem;

void addFile(ContentHasher& hasher, const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  hasher.add(std::string(std::istreambuf_iterator<char>(in), {}));
}

std::string programHash() {
  ContentHasher hasher;
  addFile(hasher, "/proc/self/exe");
  const fs::path build(build::kBuildFolder);
  for (const char* list : {"worker_objects.txt", "standin_objects.txt"}) {
    std::ifstream in(build / list);
    for (std::string object; std::getline(in, object);)
      if (!object.empty()) addFile(hasher, object);
  }
  std::vector<fs::path> sources;
  for (const auto& entry : fs::directory_iterator(courseworkFolder("solutions")))
    if (entry.path().extension() == ".cpp") sources.push_back(entry.path());
  std::sort(sources.begin(), sources.end());
  for (const fs::path& source : sources) addFile(hasher, source);
  return hasher.digits();
}

std::string compilerVersion() {
  ProcessRequest request;
  request.arguments = {std::string(build::kCompiler), "--version"};
  const std::string text = runProcess(request).output;
  return text.substr(0, text.find('\n'));
}

std::string instructionSet() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return "x86-64, AVX-512";
  if (__builtin_cpu_supports("avx2")) return "x86-64, AVX2";
  return "x86-64";
#elif defined(__aarch64__)
  return "AArch64";
#else
  return "unknown";
#endif
}

}  // namespace

record::BuildRecord thisBuild(const std::string& sandbox) {
  return {programHash(), compilerVersion(),
          fmt::format("{}", fmt::join(build::kCourseworkFlags, " ")), instructionSet(), sandbox};
}

}  // namespace pathmark::grading
