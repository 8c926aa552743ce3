// Image files that are damaged, or no images at all: one sentence with the file's name, and never
// a crash.
#include "film/image_file.h"
#include "film/image_formats.h"
#include "support/test_coursework_files.h"
#include "support/test_images.h"
#include "tests/support/uniforms.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <sys/stat.h>

namespace pathmark::test {
namespace {

using testing::Uniforms;

const std::vector<std::string> kEndings{".exr", ".hdr", ".pfm", ".png"};

class DamagedImage : public ::testing::TestWithParam<std::string> {
 protected:
  std::filesystem::path file() const { return folder_ / ("a" + GetParam()); }

  // Of a whole image in this format.
  std::string wholeFile(int width = 20, int height = 12) const {
    Image image = gradientImage(width, height, 0.01f);
    image.invalid.assign(image.rgb.size() / 3, 0);
    writeImage(file(), image, 1.0, {.scene = "scene", .coursework = "student"});
    return readText(file());
  }

  // One sentence that begins with the name; empty if the file is read.
  std::string complaint() const {
    try {
      readImage(file());
    } catch (const ImageError& e) {
      std::string sentence = e.what();
      EXPECT_TRUE(sentence.starts_with(file().string() + ": ")) << sentence;
      EXPECT_TRUE(sentence.ends_with(".")) << sentence;
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
      return sentence;
    }
    return {};
  }
  void expectComplaint(const std::string& words) const {
    EXPECT_NE(complaint().find(words), std::string::npos) << "\"" << complaint() << "\"";
  }

  TemporaryFolder folder_;
};

TEST_P(DamagedImage, MissingFilesFoldersAndDevicesAreSentences) {
  expectComplaint("there is no such file");
  writeText(file(), "");
  expectComplaint("the file is empty");
  std::filesystem::remove(file());
  std::filesystem::create_directory(file());
  expectComplaint("this is a folder");
  std::filesystem::remove(file());
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  expectComplaint("a pipe or a device");
  std::filesystem::remove(file());
  std::filesystem::create_symlink("/dev/zero", file());
  expectComplaint("a pipe or a device");
  std::filesystem::remove(file());
  std::filesystem::create_symlink(file(), file());
  expectComplaint("cannot be opened");
}

TEST_P(DamagedImage, FilesOfAnotherKindAreSentences) {
  for (const std::string& ending : kEndings) {
    if (ending == GetParam()) continue;
    writeImage(folder_ / ("b" + ending), gradientImage(9, 9), 1.0);
    std::filesystem::copy_file(folder_ / ("b" + ending), file(),
                               std::filesystem::copy_options::overwrite_existing);
    expectComplaint("this is no ");
  }
  for (const char* text : {"x", "hello, world\n", "\n\n\n\n", "{}"}) {
    writeText(file(), text);
    expectComplaint("this is no ");
  }
}

// From here on in memory: thousands of files would keep the disk busy.
void decode(const std::string& ending, std::string_view bytes) {
  if (ending == ".exr") decodeExr(bytes);
  if (ending == ".hdr") decodeHdr(bytes);
  if (ending == ".pfm") decodePfm(bytes);
  if (ending == ".png") decodePng(bytes);
}

TEST_P(DamagedImage, FilesCutOffAnywhereAreSentences) {
  const std::string whole = wholeFile();
  // PNG ends with 12 bytes that hold nothing.
  const std::size_t end = whole.size() - (GetParam() == ".png" ? 12 : 0);
  for (std::size_t size = 0; size < end; ++size)
    EXPECT_THROW(decode(GetParam(), whole.substr(0, size)), ImageError)
        << size << " of " << whole.size() << " bytes";
}

TEST_P(DamagedImage, ChangedBytesNeverCrash) {
  constexpr int kRuns = 20000;
  constexpr std::size_t kHeader = 700;
  const std::string whole = wholeFile();
  Uniforms random(7);
  for (int run = 0; run < kRuns; ++run) {
    std::string damaged = whole;
    const std::uint64_t changes = 1 + random.bits() % 4;
    // The first bytes decide how the others are read.
    const std::size_t range = run % 2 == 0 ? damaged.size() : std::min(kHeader, damaged.size());
    for (std::uint64_t i = 0; i < changes; ++i)
      damaged[random.bits() % range] =
          static_cast<char>(random.bits() % 3 == 0 ? 0xff : random.bits());
    try {
      decode(GetParam(), damaged);
    } catch (const ImageError& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
    }
  }
}

TEST_P(DamagedImage, HugeSizesAreRefusedBeforeAnythingIsAllocated) {
  const auto replace = [](std::string text, std::string_view old, std::string_view by) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, old.size(), by);
  };
  using namespace std::string_literals;
  const std::string whole = wholeFile(20, 12);
  const auto sized = [&](std::int32_t width, std::int32_t height) {
    const auto little = [](std::int32_t v) {
      return std::string(reinterpret_cast<const char*>(&v), 4);
    };
    const auto big = [&](std::int32_t v) {
      const std::string l = little(v);
      return std::string(l.rbegin(), l.rend());
    };
    if (GetParam() == ".pfm") return replace(whole, "20 12", fmt::format("{} {}", width, height));
    if (GetParam() == ".hdr")
      return replace(whole, "-Y 12 +X 20", fmt::format("-Y {} +X {}", height, width));
    // Not the CRC of the PNG's header, which stb_image does not read.
    if (GetParam() == ".png") return replace(whole, big(20) + big(12), big(width) + big(height));
    return replace(
        whole, "dataWindow\0box2i\0\x10\0\0\0"s + little(0) + little(0) + little(19) + little(11),
        "dataWindow\0box2i\0\x10\0\0\0"s + little(0) + little(0) + little(width - 1) +
            little(height - 1));
  };
  writeText(file(), sized(20, 12));
  EXPECT_EQ(complaint(), "");
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{
           {65537, 12}, {65536, 65536}, {20, 2000000000}, {2147483647, 2147483647}, {0, 12}}) {
    writeText(file(), sized(width, height));
    EXPECT_NE(complaint(), "") << width << "x" << height;
    if (width > 0 && width < 100000) expectComplaint("from 1 to 65536 pixels a side");
  }
  // An allowed size that the file does not have.
  writeText(file(), sized(8192, 8192));
  EXPECT_NE(complaint(), "");
}

TEST_P(DamagedImage, FilesOfManyGigabytesAreRefusedUnread) {
  writeText(file(), "x");
  std::filesystem::resize_file(file(), std::uintmax_t{1} << 40);
  expectComplaint("1048576 MB");
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedImage, ::testing::ValuesIn(kEndings),
                         [](const auto& format) { return format.param.substr(1); });

TEST(DamagedExr, WithoutColourNamesItsChannels) {
  Image image = gradientImage(4, 4);
  std::string bytes = encodeExr(image, {});
  // The channel list is sorted: "B", "G", "R", each ended by 0.
  const std::size_t at = bytes.find(std::string("R\0\x02\0\0\0", 6));
  ASSERT_NE(at, std::string::npos);
  bytes[at] = '\n';
  EXPECT_NE(sentenceOf([&] { decodeExr(bytes); }).find("are ?, B, G; needed are R, G and B"),
            std::string::npos);
}

}  // namespace
}  // namespace pathmark::test
