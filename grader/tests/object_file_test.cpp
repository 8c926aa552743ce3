// What a confined compiler hands over is an object of plain machine code, or refused.
#include "host/object_file.h"
#include "host/build_config.h"
#include "host/subprocess.h"
#include "support/test_coursework_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include <sys/stat.h>

namespace pathmark::test {
namespace {

class ObjectFile : public testing::Test {
 protected:
  std::filesystem::path compile(const std::string& code) {
    std::ofstream(folder_ / "a.cpp") << code;
    const std::filesystem::path object = folder_ / "a.o";
    const ProcessResult result = runProcess(
        {{std::string(build::kCompiler), "-c", (folder_ / "a.cpp").string(), "-o", object.string()},
         {},
         {}});
    EXPECT_EQ(result.exitCode, 0) << result.output;
    return object;
  }

  TemporaryFolder folder_;
};

TEST_F(ObjectFile, PlainCodeIsTaken) {
  EXPECT_EQ(objectComplaint(compile("int f() { return 1; }\nint x = f();\n")), std::nullopt);
}

TEST_F(ObjectFile, ALinkerScriptIsRefused) {
  std::ofstream(folder_ / "a.o") << "INPUT(/etc/passwd)\n";
  EXPECT_NE(objectComplaint(folder_ / "a.o"), std::nullopt);
  std::ofstream(folder_ / "a.o") << "!<arch>\n";
  EXPECT_NE(objectComplaint(folder_ / "a.o"), std::nullopt);
}

TEST_F(ObjectFile, CodeForTheLinkersPluginIsRefused) {
  EXPECT_NE(objectComplaint(compile("asm(\".section .gnu.lto_main,\\\"e\\\"\\n.byte 1\\n\");\n")),
            std::nullopt);
}

TEST_F(ObjectFile, AnotherLoaderIsRefused) {
  EXPECT_NE(objectComplaint(compile("asm(\".section .interp,\\\"a\\\"\\n.asciz \\\"/x\\\"\");\n")),
            std::nullopt);
}

TEST_F(ObjectFile, FunctionsThatRunBeforeTheProgramAreRefused) {
  EXPECT_NE(objectComplaint(
                compile("void f() {}\n"
                        "[[gnu::section(\".preinit_array\"), gnu::used]] void (*early)() = f;\n")),
            std::nullopt);
  EXPECT_NE(objectComplaint(compile("extern \"C\" { int g() { return 1; }\n"
                                    "static int (*choose())() { return g; }\n"
                                    "[[gnu::ifunc(\"choose\")]] int h(); }\n"
                                    "int k() { return h(); }\n")),
            std::nullopt);
}

TEST_F(ObjectFile, ConstructorsThatRunBeforeTheWorkersOwnAreRefused) {
  if (build::kSanitized) GTEST_SKIP() << "sanitizers have such constructors";
  for (const char* early :
       {"[[gnu::constructor(1)]] void f() {}", "[[gnu::constructor(101)]] void f() {}",
        "struct S { S(); }; [[gnu::init_priority(101)]] S s;"})
    EXPECT_NE(objectComplaint(compile(early)), std::nullopt) << early;
  for (const char* late :
       {"[[gnu::constructor]] void f() {}", "[[gnu::constructor(102)]] void f() {}",
        "struct S { S(); }; [[gnu::init_priority(65535)]] S s;",
        "[[gnu::destructor(1)]] void f() {}"})
    EXPECT_EQ(objectComplaint(compile(late)), std::nullopt) << late;
  for (const char* section :
       {R"(.init,"ax")", R"(.init_array.1,"aw")", R"(.init_array.00101,"aw",@init_array)",
        R"(.init_array.-1,"aw")", R"(.init_array.99999999999,"aw")", R"(.init_array.,"aw")",
        R"(.ctors.65535,"aw")", R"(.other,"aw",@init_array)"})
    EXPECT_NE(objectComplaint(compile(fmt::format("asm(R\"(.section {}\n.quad 0\n)\");", section))),
              std::nullopt)
        << section;
}

TEST_F(ObjectFile, LargeObjectsAreRefusedInASentence) {
  EXPECT_EQ(objectComplaint(compile("int a[1 << 24];\nchar b[3 << 20] = {1};\n")), std::nullopt);
  EXPECT_EQ(objectComplaint(compile("char a[5 << 20] = {1};\n")).value_or("").substr(0, 58),
            "the object file has 6 MiB, and at most 4 are allowed; an a");
}

TEST_F(ObjectFile, AFileThatIsCutShortAnywhereIsRefusedOrHarmless) {
  std::ifstream in(compile("int f() { return 1; }\n"), std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  ASSERT_FALSE(bytes.empty());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(objectComplaint(std::as_bytes(std::span(bytes.data(), size))), std::nullopt) << size;
}

TEST_F(ObjectFile, NeitherLinksNorFoldersNorLargeFilesAreTaken) {
  const std::filesystem::path to = folder_ / "to", from = folder_ / "from";
  std::ofstream(folder_ / "secret") << "secret";
  std::filesystem::create_symlink(folder_ / "secret", from);
  EXPECT_FALSE(takeFile(from, to, 100));
  std::filesystem::remove(from);
  std::filesystem::create_directory(from);
  EXPECT_FALSE(takeFile(from, to, 100));
  std::filesystem::remove(from);
  ASSERT_EQ(mkfifo(from.c_str(), 0600), 0);
  EXPECT_FALSE(takeFile(from, to, 100));
  EXPECT_FALSE(takeFile(folder_ / "secret", to, 5));
  EXPECT_FALSE(std::filesystem::exists(to));
  EXPECT_TRUE(takeFile(folder_ / "secret", to, 6));
  EXPECT_EQ(std::filesystem::file_size(to), 6u);
}

}  // namespace
}  // namespace pathmark::test
