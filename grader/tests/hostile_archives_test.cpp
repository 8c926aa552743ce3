// Archives that want to break out, to exhaust, or to confuse: each is refused with a sentence.
#include "support/collecting.h"

#include <cstdint>
#include <random>

namespace pathmark::submission {
namespace {

using test::ArchiveKind;
using test::MadeArchive;
using test::readBytes;

using Names = std::vector<std::string>;

constexpr const char* kPart3 = "part3_lambertian.cpp";
constexpr const char* kPart4 = "part4_phong.cpp";

// The bytes of an archive with one text for another of the same length, wherever it stands.
std::string replaced(std::string bytes, std::string_view from, std::string_view to) {
  EXPECT_EQ(from.size(), to.size());
  std::size_t count = 0;
  for (std::size_t at = 0; (at = bytes.find(from, at)) != std::string::npos; at += to.size()) {
    bytes.replace(at, from.size(), to);
    ++count;
  }
  EXPECT_GT(count, 0u) << from;
  return bytes;
}

class HostileArchives : public Collecting {
 protected:
  std::string bytesOf(const MadeArchive& made, ArchiveKind kind) {
    made.write(kind, folder_ / "bytes");
    return readBytes(folder_ / "bytes");
  }
};

TEST_F(HostileArchives, NamesThatLeadElsewhereAreRefused) {
  const std::vector<std::pair<std::string, std::string>> tricks{
      {"../part3_lambertian.cpp", "leads out of the submission"},
      {"a/../../part3_lambertian.cpp", "leads out of the submission"},
      {"/etc/part3_lambertian.cpp", "has an absolute name"},
      {"C:/part3_lambertian.cpp", "has a drive letter"},
      {"c:part3_lambertian.cpp", "has a drive letter"},
      {"a\\part3_lambertian.cpp", "has a backslash"},
      {"..\\part3_lambertian.cpp", "has a backslash"},
      {"a\n/part3_lambertian.cpp", "has a control character"},
      {"\x1b[2J/part3_lambertian.cpp", "has a control character"},
      {"\xff\xfe/part3_lambertian.cpp", "not UTF-8"},
      {"\xc0\xae\xc0\xae/part3_lambertian.cpp", "not UTF-8"},  // an overlong ".."
      {"a/b/c/d/e/f/g/h/i/j/k/l/m/n/o/p/q/part3_lambertian.cpp", "folders deep"},
      {std::string(600, 'a') + "/part3_lambertian.cpp", "has a name of 621 bytes"},
  };
  for (const auto& [name, words] : tricks) {
    const Collected archive = collected(MadeArchive().file(kPart4).file(name, "evil"));
    EXPECT_EQ(names(archive), Names{kPart4}) << name;
    expectRemark(archive, words);
    // A sentence is shown on terminals.
    for (const std::string& remark : archive.remarks)
      for (const char c : remark) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
  }
}

TEST_F(HostileArchives, TheSameNamesAreRefusedInAZip) {
  const std::string zip =
      bytesOf(MadeArchive().file(kPart4).file("aa/part3_lambertian.cpp"), ArchiveKind::kZip);
  for (const char* folder : {"..", "/a", "\xff\xff", "a\n", "C:"}) {
    const Collected archive =
        collectedFile(replaced(zip, "aa/part3", std::string(folder) + "/part3"));
    EXPECT_EQ(names(archive), Names{kPart4}) << folder << allRemarks(archive);
  }
}

TEST_F(HostileArchives, ANameEndsWhereItsTextEnds) {
  const std::string zip =
      bytesOf(MadeArchive().file("part3_lambertian.cpp.exe", "3"), ArchiveKind::kZip);
  const Collected archive =
      collectedFile(replaced(zip, "part3_lambertian.cpp.exe", {"part3_lambertian.cpp\0exe", 24}));
  for (const auto& [name, bytes] : archive.files) EXPECT_EQ(name, kPart3);
}

// The bit that says that a zip's names are UTF-8 (APPNOTE.TXT, 4.4.4), in all of its headers.
std::string withUtf8Bit(std::string zip) {
  for (const auto& [header, at] : {std::pair("PK\3\4", 7), std::pair("PK\1\2", 9)})
    for (std::size_t i = 0; (i = zip.find(header, i)) != std::string::npos; i += 4)
      zip[i + static_cast<std::size_t>(at)] |= 8;
  return zip;
}

TEST_F(HostileArchives, LettersOfOtherLanguagesAreNoTrick) {
  const MadeArchive made = MadeArchive().file(
      "\xc3\x9c"
      "bung \xe2\x98\x83/part3_lambertian.cpp",
      "3");
  const std::string zip = bytesOf(made, ArchiveKind::kZip);
  for (const std::string& bytes : {zip, withUtf8Bit(zip), bytesOf(made, ArchiveKind::kTar)}) {
    const Collected archive = collectedFile(bytes);
    EXPECT_EQ(names(archive), Names{kPart3}) << allRemarks(archive);
  }
}

TEST_F(HostileArchives, LinksPipesAndDevicesAreRefused) {
  const Collected archive = collected(MadeArchive()
                                          .file(kPart4)
                                          .symbolicLink("part0_warmup.cpp", "/etc/passwd")
                                          .hardLink("part1_stratified.cpp", "part4_phong.cpp")
                                          .fifo("part2_lights.cpp")
                                          .device("part3_lambertian.cpp")
                                          .folder("part5_path.cpp")
                                          .symbolicLink("other", "/")
                                          .symbolicLink("scenes/a.json", "/etc/passwd"));
  EXPECT_EQ(names(archive), Names{kPart4});
  for (const char* words :
       {"part0_warmup.cpp was refused: it is a link",
        "part1_stratified.cpp was refused: it is a link",
        "part2_lights.cpp was refused: it is a pipe or a device",
        "part3_lambertian.cpp was refused: it is a pipe or a device",
        "part5_path.cpp was refused: it is a folder", "other was refused: it is a link",
        "scenes/a.json was refused: it is a link"})
    expectRemark(archive, words);
}

TEST_F(HostileArchives, AFileBehindALinkIsOnlyAName) {
  const Collected archive =
      collected(MadeArchive().symbolicLink("work", "/tmp").file("work/part3_lambertian.cpp", "3"));
  EXPECT_EQ(archive.files.at(kPart3), "3");
  expectRemark(archive, "work was refused: it is a link");
}

TEST_F(HostileArchives, LaterEntriesReplaceNothing) {
  for (const ArchiveKind kind : {ArchiveKind::kZip, ArchiveKind::kTar}) {
    const Collected archive =
        collected(MadeArchive().file(kPart4).file(kPart3, "1").file(kPart3, "2"), kind);
    EXPECT_EQ(names(archive), Names{kPart4});
    expectRemark(archive, "handed in 2 times with different contents");
  }
}

TEST_F(HostileArchives, ArchivesWithinAreNotOpened) {
  const std::string inner = bytesOf(MadeArchive().file(kPart3), ArchiveKind::kZip);
  const Collected archive =
      collected(MadeArchive().file(kPart4).file("work.zip", inner).file("x.tar.gz").file("y.7z"));
  EXPECT_EQ(names(archive), Names{kPart4});
  expectRemark(archive, "work.zip was not opened: it is an archive within the submission.");
  expectRemark(archive, "y.7z was not opened");
}

TEST_F(HostileArchives, OneThatHoldsOnlyAnArchiveSaysSoFirst) {
  const std::string inner = bytesOf(MadeArchive().file(kPart3), ArchiveKind::kZip);
  for (const bool reversed : {false, true}) {
    MadeArchive made;
    made.file(reversed ? "z.rar" : "inner.zip", inner);
    made.file(reversed ? "inner.zip" : "z.rar", inner);
    const Collected archive = collected(made, ArchiveKind::kZip);
    EXPECT_TRUE(archive.files.empty());
    EXPECT_TRUE(archive.failure.starts_with(
        "inner.zip was not opened: it is an archive within the submission. Nothing was taken: "))
        << archive.failure;
  }
}

TEST_F(HostileArchives, WhatIsEmptyIsSaidToBe) {
  // The record at the end, without entries and with a comment that is empty.
  const std::string zip = "PK\5\6" + std::string(18, '\0');
  EXPECT_EQ(collectedFile(zip).failure, "Nothing was taken: the archive is empty.");
  EXPECT_EQ(collectedFile("").failure, "Nothing was taken: the file is empty.");
  for (const ArchiveKind kind : {ArchiveKind::kZip, ArchiveKind::kTar, ArchiveKind::kTarGz})
    EXPECT_EQ(collected(MadeArchive(), kind).failure, "Nothing was taken: the archive is empty.");
  // That record alone, of a zip that had entries.
  EXPECT_NE(collectedFile("PK\5\6" + std::string(4, '\0') + "\1" + std::string(13, '\0')).failure,
            "Nothing was taken: the archive is empty.");
}

TEST_F(HostileArchives, WhatOtherSystemsLeaveBehindIsIgnoredWithoutAWord) {
  const Collected archive = collected(MadeArchive()
                                          .file(kPart3, "3")
                                          .file("__MACOSX/part3_lambertian.cpp", "resource")
                                          .file("._part3_lambertian.cpp", "resource")
                                          .file(".DS_Store"));
  EXPECT_EQ(archive.files.at(kPart3), "3");
  EXPECT_EQ(allRemarks(archive).find("ignored"), std::string::npos) << allRemarks(archive);
}

TEST_F(HostileArchives, EncryptedFilesAreRefused) {
  const Collected archive =
      collected(MadeArchive().file(kPart3).file(kPart4), ArchiveKind::kEncryptedZip);
  EXPECT_TRUE(archive.files.empty());
  expectRemark(archive, "part3_lambertian.cpp was refused: it is encrypted.");
}

TEST_F(HostileArchives, BombsAreRefused) {
  const Limits limits{.unpackedBytes = std::uint64_t{8} << 20};
  const std::string zeros(std::size_t{9} << 20, '\0');
  for (const ArchiveKind kind :
       {ArchiveKind::kZip, ArchiveKind::kTarGz, ArchiveKind::kTarXz, ArchiveKind::kTarZst}) {
    // Read or skipped, large or many.
    for (const char* name : {kPart4, "picture.exr"}) {
      const Collected archive =
          collected(MadeArchive().file(kPart3).file(name, zeros), kind, limits);
      EXPECT_TRUE(archive.files.empty());
      expectRemark(archive, "it has more than 8 MiB when unpacked");
    }
    MadeArchive many;
    for (int i = 0; i < 9; ++i)
      many.file("file" + std::to_string(i), zeros.substr(0, std::size_t{1} << 20));
    EXPECT_TRUE(collected(many.file(kPart3), kind, limits).files.empty());
  }
}

TEST_F(HostileArchives, AnEntryThatUnderstatesItsSizeIsReadNoFurther) {
  // A zip's sizes stand twice in it: 300,000 as little-endian bytes becomes 2.
  const std::string zip = bytesOf(
      MadeArchive().file(kPart4).file(kPart3, std::string(300'000, 'x')), ArchiveKind::kZip);
  std::string understated = zip;
  for (std::size_t at = 0;
       (at = understated.find(std::string_view("\xe0\x93\x04\0", 4), at)) != std::string::npos;)
    understated.replace(at, 4, std::string_view("\2\0\0\0", 4));
  const Collected archive = collectedFile(understated, {.codeBytes = 1000});
  EXPECT_FALSE(archive.files.contains(kPart3)) << allRemarks(archive);
}

TEST_F(HostileArchives, ArchivesCompressedTwiceAreRefused) {
  test::writeBytes(folder_ / "inner", bytesOf(MadeArchive().file(kPart3), ArchiveKind::kTarGz));
  // gzip of a gzip: stored, as RFC 1951, section 3.2.4, says; the checksums come too late.
  const std::string inner = readBytes(folder_ / "inner");
  std::string outer("\x1f\x8b\x08\0\0\0\0\0\0\3\1", 11);
  const auto size = static_cast<std::uint16_t>(inner.size());
  for (const unsigned word : {unsigned{size}, 0xffffu - size}) {
    outer += static_cast<char>(word & 0xff);
    outer += static_cast<char>(word >> 8);
  }
  const Collected archive = collectedFile(outer + inner + std::string(8, '\0'));
  EXPECT_TRUE(archive.files.empty());
  expectRemark(archive, "it is compressed more than once");
}

TEST_F(HostileArchives, TooManyEntriesAreRefused) {
  MadeArchive made;
  made.file(kPart3);
  for (int i = 0; i < 100; ++i) made.folder("folder" + std::to_string(i));
  EXPECT_TRUE(collected(made, ArchiveKind::kTar, {.entries = 100}).files.empty());
  EXPECT_EQ(names(collected(made, ArchiveKind::kTar, {.entries = 101})), Names{kPart3});
}

TEST_F(HostileArchives, TooMuchCourseworkIsRefused) {
  MadeArchive made;
  for (int i = 0; i < 10; ++i)
    made.file("scenes/" + std::to_string(i) + ".json", std::string(1000, 'x'));
  const Collected archive = collected(made.file(kPart3), ArchiveKind::kTar, {.keptBytes = 5000});
  EXPECT_TRUE(archive.files.empty());
  expectRemark(archive, "its coursework files have more than");
}

TEST_F(HostileArchives, TakingTooLongIsRefused) {
  expectRemark(collected(MadeArchive().file(kPart3), ArchiveKind::kZip, {.seconds = 0.0}),
               "it could not be read within 0 s");
}

TEST_F(HostileArchives, AFileLargerThanAllowedIsNotOpened) {
  expectRemark(collected(MadeArchive().file(kPart3), ArchiveKind::kTar, {.archiveBytes = 100}),
               "but at most");
}

TEST_F(HostileArchives, WhatIsNoArchiveIsRefused) {
  for (const std::string_view bytes :
       {std::string_view(""), std::string_view("hello"), std::string_view("PK\3\4garbage"),
        std::string_view("\x1f\x8b garbage"), std::string_view("Rar!\x1a\7\0 garbage")}) {
    const Collected archive = collectedFile(bytes);
    EXPECT_TRUE(archive.files.empty());
    EXPECT_FALSE(archive.failure.empty());
  }
}

TEST_F(HostileArchives, NothingIsTakenFromWhatIsCutOff) {
  for (const ArchiveKind kind : {ArchiveKind::kZip, ArchiveKind::kTarGz, ArchiveKind::kTarXz}) {
    const std::string whole =
        bytesOf(MadeArchive().file(kPart3, "three").file(kPart4, "four"), kind);
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 40) {
      const Collected archive = collectedFile(whole.substr(0, size));
      EXPECT_TRUE(archive.files.empty()) << size << " of " << whole.size();
      EXPECT_FALSE(archive.failure.empty());
    }
  }
}

// Whatever an archive has become: no crash, no hang, and only files of the coursework.
TEST_F(HostileArchives, DamageNeverDoesMoreThanLoseFiles) {
  const MadeArchive made = MadeArchive()
                               .folder("work")
                               .file("work/part3_lambertian.cpp", std::string(2000, '3'))
                               .file("work/part4_phong.cpp", "four")
                               .symbolicLink("work/part5_path.cpp", "part4_phong.cpp")
                               .file("work/scenes/my_scene.json", "{}")
                               .file("work/notes.txt", "notes");
  std::mt19937 random(20260101);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (const ArchiveKind kind : {ArchiveKind::kZip, ArchiveKind::kTar, ArchiveKind::kTarGz,
                                 ArchiveKind::kTarXz, ArchiveKind::kTarZst}) {
    const std::string whole = bytesOf(made, kind);
    for (int round = 0; round < 200; ++round) {
      std::string bytes = whole;
      for (std::size_t change = below(8) + 1; change > 0; --change) {
        const std::size_t at = below(bytes.size()), length = 1 + below(40);
        switch (below(4)) {
          case 0:
            bytes[at] = static_cast<char>(below(256));
            break;
          case 1:
            bytes.erase(at, length);
            break;
          case 2:
            bytes.insert(at, bytes, below(bytes.size()), length);
            break;
          default:
            bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1u << below(8)));
        }
        if (bytes.empty()) bytes.push_back(0);
      }
      const Collected archive =
          collectedFile(bytes, {.unpackedBytes = std::uint64_t{16} << 20, .seconds = 20.0});
      EXPECT_NE(archive.files.empty(), archive.failure.empty());
      for (const auto& [name, unused] : archive.files) {
        EXPECT_TRUE(name.starts_with("part") || name.starts_with("scenes/")) << name;
        EXPECT_EQ(name.find(".."), std::string::npos) << name;
      }
    }
  }
}

}  // namespace
}  // namespace pathmark::submission
