#include "kit/small_project.h"

#include "kit/project_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace pathmark::test {

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = PATHMARK_ROOT;

constexpr const char* kContents = R"(# What the kit of a small project is made of.
text pathmark
text student/part*.cpp
text student/scenes/my_scene.json
text handouts/*.md
image handouts/figures/*.png
image scenes/references/*.exr
text framework/include/pathmark/*
text grader/kit/student_readme.md as README.md

answers solutions/part*.cpp
answers grader/variants/*/*.patch
)";

constexpr const char* kFolders[] = {"solutions", "solutions/scenes", "student", "student/scenes",
                                    "framework/include/pathmark"};

constexpr const char* kFiles[] = {
    "pathmark",
    "README.md",
    "handouts/part3_lambertian.md",
    "handouts/figures/scenes.png",
    "scenes/references/furnace.exr",
    "grader/kit/student_readme.md",
    "grader/tests/part4_phong_test.cpp",
    "grader/tests/support/test_scene.cpp",
    "grader/variants/wrong/part4_half_vector.patch",
};

}  // namespace

SmallProject::SmallProject() {
  for (const char* name : kFolders) {
    fs::create_directories(path() / name);
    for (const auto& entry : fs::directory_iterator(kRoot / name))
      if (entry.is_regular_file())
        fs::copy_file(entry.path(), path() / name / entry.path().filename());
  }
  for (const char* name : kFiles) {
    fs::create_directories((path() / name).parent_path());
    fs::copy_file(kRoot / name, path() / name);
  }
  write("grader/kit/contents.txt", kContents);
}

void SmallProject::write(const std::string& name, const std::string& content) const {
  fs::create_directories((path() / name).parent_path());
  std::ofstream(path() / name, std::ios::binary) << content;
}

void SmallProject::append(const std::string& name, const std::string& content) const {
  std::ofstream(path() / name, std::ios::binary | std::ios::app) << content;
}

void SmallProject::copy(const std::string& from, const std::string& to) const {
  write(to, read(from));
}

std::string SmallProject::read(const std::string& name) const {
  return kit::readFile(path() / name);
}

kit::WrittenKit SmallProject::makeKit(int releasedThrough) const {
  return kit::writeKit(kit::planKit(path(), releasedThrough), destination());
}

void SmallProject::expectRefused(const std::string& words) const {
  const kit::WrittenKit written = makeKit();
  EXPECT_EQ(written.outcome, kit::KitOutcome::kRefused);
  const std::vector<std::string>& findings = written.inspection.findings;
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(),
                          [&](const std::string& f) { return f.find(words) != f.npos; }))
      << "looked for: " << words << "\nfound: " << testing::PrintToString(findings);
  EXPECT_TRUE(fs::is_empty(outside_.path()));
}

}  // namespace pathmark::test
