// Checkpoints: a render goes on from one to the same bits, and nothing else is taken for one.
#include "host/checkpoint.h"

#include "host/checkpoint_keeper.h"
#include "host/content_hash.h"
#include "host/render_loop.h"
#include "support/background_program.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>

#include <sys/stat.h>

namespace pathmark::test {
namespace {

bool goOn(const RenderStatus&) { return true; }

CheckpointIdentity identityOf(const RenderSettings& settings) {
  return {std::string(32, 's'), std::string(32, 'c'), 8, settings};
}

class CheckpointTest : public testing::Test {
 protected:
  // Of 3x2 pixels with 2 of 4 replicates, and half of the third.
  CheckpointTest() {
    settings_.width = 3;
    settings_.height = 2;
    settings_.raysPerPixel = 512;
    settings_.replicates = 4;
    settings_.seed = 7;
    settings_.sampler = SamplerKind::kStratified;
    settings_.paths = "LS+DE";
    state_.film.assign(6, FilmPixel{{1.5, 2.5, 3.5}, 64.0});
    for (int k = 0; k < 2; ++k)
      addReplicate(state_.replicates, std::vector<FilmPixel>(6, {{3.0 + k, 4.0, 5.0}, 128.0}));
    state_.replicate = 2;
    state_.firstRay = 64;
    state_.raysTraced = 12345;
    state_.seconds = 6.5;
    state_.invalid.nan = 3;
    state_.invalid.firstPixel = 4;
  }

  void write() const { writeCheckpoint(file_, identityOf(settings_), state_); }
  void write(const std::string& bytes) const {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
  }
  // Bytes whose hash is right.
  void writeWithHash(std::string bytes) const {
    bytes.resize(bytes.size() - 32);
    write(bytes + contentHash(bytes));
  }
  // The sentence with which the file is refused; empty if it is not.
  std::string refusal() const {
    try {
      readCheckpoint(file_);
    } catch (const CheckpointError& e) {
      return e.what();
    }
    return {};
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "a.checkpoint";
  RenderSettings settings_;
  RenderState state_;
};

template <class T>
std::string bytes(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

TEST_F(CheckpointTest, HoldsEveryBit) {
  write();
  const Checkpoint read = readCheckpoint(file_);
  EXPECT_EQ(whyNotContinued(read, identityOf(settings_)), "");
  EXPECT_EQ(bytes(read.state.film), bytes(state_.film));
  EXPECT_EQ(bytes(read.state.replicates.film), bytes(state_.replicates.film));
  EXPECT_EQ(bytes(read.state.replicates.moments), bytes(state_.replicates.moments));
  EXPECT_EQ(read.state.replicate, 2u);
  EXPECT_EQ(read.state.firstRay, 64u);
  EXPECT_EQ(read.state.raysTraced, 12345u);
  EXPECT_EQ(read.state.seconds, 6.5);
  EXPECT_EQ(read.state.invalid.nan, 3u);
  EXPECT_EQ(read.state.invalid.firstPixel, 4u);
}

// 320 of 512 rays per pixel are in whole steps.
TEST_F(CheckpointTest, AnInterruptSaysWhatTheCheckpointHolds) {
  const std::filesystem::path picture = folder_ / "a.exr";
  const std::string start = "To go on from " + picture.string() + ".checkpoint, which has 320 of ";
  CheckpointKeeper keeper(picture, identityOf(settings_), {});
  EXPECT_EQ(keeper.onInterrupt(state_, 321.0),
            start + "512 rays per pixel: the same command with --resume.\n");
  EXPECT_EQ(keeper.onInterrupt(state_, 383.5),
            start +
                "512 rays per pixel, fewer than the picture, since it keeps whole steps only: "
                "the same command with --resume.\n");
}

TEST_F(CheckpointTest, EqualContentIsEqualBytes) {
  write();
  const std::string first = textOf(file_);
  write();
  EXPECT_EQ(textOf(file_), first);
}

TEST_F(CheckpointTest, CutShortOrLongerItIsRefused) {
  write();
  const std::string whole = textOf(file_);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(whole.substr(0, length));
    ASSERT_NE(refusal(), "") << length;
  }
  write(whole + "x");
  EXPECT_NE(refusal(), "");
  write(whole);
  EXPECT_EQ(refusal(), "");
}

// Every bit of the header and of the hash, and one of every byte between.
TEST_F(CheckpointTest, ABitThatIsFlippedIsNoticed) {
  write();
  const std::string whole = textOf(file_);
  constexpr std::size_t kHeader = 392, kHash = 32;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const bool all = i < kHeader || i + kHash >= whole.size();
    for (int bit = all ? 0 : static_cast<int>(i % 8); bit < 8; bit += all ? 1 : 8) {
      std::string damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      write(damaged);
      ASSERT_NE(refusal(), "") << i << " " << bit;
    }
  }
}

// Somebody may compute the hash as well: no number is believed.
TEST_F(CheckpointTest, ImpossibleNumbersAreRefusedWithARightHash) {
  write();
  const std::string whole = textOf(file_);
  // Of any eight bytes, also where two numbers of four bytes are, or digits of a hash.
  const std::uint64_t numbers[] = {0,
                                   1,
                                   1ull << 31,
                                   1ull << 40,
                                   ~0ull,
                                   0x7ff8000000000000,
                                   0x7ff0000000000000,
                                   0xbff0000000000000};
  for (std::size_t at = 8; at + 40 <= whole.size(); at += 8)
    for (const std::uint64_t number : numbers) {
      std::string hostile = whole;
      std::memcpy(hostile.data() + at, &number, sizeof number);
      writeWithHash(hostile);
      if (!refusal().empty()) continue;
      // What is believed does no harm: it is another render's, or goes on to its end.
      RenderState state = readCheckpoint(file_).state;
      const CheckpointIdentity identity = readCheckpoint(file_).identity;
      if (!whyNotContinued(readCheckpoint(file_), identityOf(settings_)).empty()) continue;
      ASSERT_EQ(state.film.size(), identity.settings.pixels());
      for (int step = 0; !finished(settings_, state); ++step) {
        ASSERT_LT(step, 100) << at << " " << number;
        advance(settings_, nextJob(settings_, state, 1.0), state);
      }
    }
}

TEST_F(CheckpointTest, TextThatIsNoExpressionIsRefusedWithARightHash) {
  write();
  const std::string whole = textOf(file_);
  const std::size_t at = whole.find(settings_.paths);
  ASSERT_NE(at, std::string::npos);
  const auto with = [&](std::string_view paths) {
    std::string hostile = whole;
    hostile.replace(at, paths.size(), paths);
    writeWithHash(hostile);
    return refusal();
  };
  EXPECT_EQ(with("LD+SE"), "");
  EXPECT_EQ(with("LS+D*"), "it is damaged");
  EXPECT_EQ(with("\033[2JE"), "it is damaged");
  EXPECT_EQ(with(std::string_view("LDE\0E", 5)), "it is damaged");
}

TEST_F(CheckpointTest, NothingButFilesIsRead) {
  EXPECT_EQ(refusal(), "it is no file");
  std::filesystem::create_directory(file_);
  EXPECT_EQ(refusal(), "it is no file");
  std::filesystem::remove(file_);
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_EQ(refusal(), "it is no file");
  std::filesystem::remove(file_);
  std::filesystem::create_symlink("/dev/zero", file_);
  EXPECT_EQ(refusal(), "it is no file");
}

TEST_F(CheckpointTest, WhatAnotherVersionHasWrittenIsNotGuessedAt) {
  write();
  std::string other = textOf(file_);
  ++other[8];
  writeWithHash(other);
  EXPECT_EQ(refusal(), "another version of this program has written it");
}

TEST_F(CheckpointTest, SaysWhatDiffers) {
  const Checkpoint checkpoint{identityOf(settings_), state_};
  const auto says = [&](const auto& change, const std::string& words) {
    CheckpointIdentity other = identityOf(settings_);
    change(other);
    const std::string why = whyNotContinued(checkpoint, other);
    EXPECT_NE(why.find(words), std::string::npos) << words << ": " << why;
  };
  says([](auto& i) { i.scene[3] = 'x'; }, "another scene");
  says([](auto& i) { i.coursework[3] = 'x'; }, "other coursework");
  says([](auto& i) { i.maxBounces = 9; }, "up to 8 bounces, not 9");
  says([](auto& i) { i.settings.seed = 8; }, "seed is 7, not 8");
  says([](auto& i) { i.settings.sampler = SamplerKind::kSobol; },
       "sampler is stratified, not sobol");
  says([](auto& i) { i.settings.paths = "LDE"; }, "light paths are LS+DE, not LDE");
  says([](auto& i) { i.settings.paths.clear(); }, "light paths are LS+DE, not of all light");
  says([](auto& i) { i.settings.width = 4; }, "size is 3x2, not 4x2");
  says([](auto& i) { i.settings.estimator = Estimator::kWarmUp; }, "--warm-up");
  says(
      [](auto& i) {
        i.settings.estimator = Estimator::kSplit;
        i.settings.sharing.pathsPerRay = 4;
        i.settings.sharing.directLight = 1;
      },
      "by tracePath, not with --split 4 --share-direct");
  says(
      [](auto& i) {
        i.settings.estimator = Estimator::kReuse;
        i.settings.sharing.pixels = 16;
      },
      "by tracePath, not with --reuse 16 --direct-paths 1");
  says([](auto& i) { i.settings.replicates = 2; },
       "4 of 128 rays per pixel, not 2 of 256; with --rays-per-pixel 512 --replicates 4 it could");
  says([](auto& i) { i.settings.replicates = 1; },
       "not 1 of 512; with --rays-per-pixel 512 --repl");
  says([](auto& i) { i.settings.raysPerPixel = 1024; }, "not 4 of 256; with ");
  says([](auto& i) { i.settings.replicates = 8; },
       "not 8 of 64; with --rays-per-pixel 1024 --replicates 8 it could go on");
  says(
      [](auto& i) {
        i.settings.raysPerPixel = 256;
        i.settings.replicates = 2;
      },
      "has 320 rays per pixel already, and 256 are wanted; with --rays-per-pixel 512 --repl");
}

TEST_F(CheckpointTest, ThreadsDoNotMatter) {
  CheckpointIdentity other = identityOf(settings_);
  other.settings.threads = 99;
  EXPECT_EQ(whyNotContinued({identityOf(settings_), state_}, other), "");
}

TEST_F(CheckpointTest, MoreReplicatesOfTheSameRaysGoOn) {
  CheckpointIdentity more = identityOf(settings_);
  more.settings.replicates = 6;
  more.settings.raysPerPixel = 768;
  EXPECT_EQ(whyNotContinued({identityOf(settings_), state_}, more), "");
}

// `made`: rays of each pixel.
std::string whyNotRefined(std::uint64_t rays, std::uint64_t made, std::uint64_t row,
                          std::uint64_t wanted) {
  RenderSettings settings;
  settings.width = settings.height = 32;
  settings.raysPerPixel = rays;
  RenderState state;
  state.firstRay = made;
  state.row = row;
  CheckpointIdentity identity = identityOf(settings);
  const Checkpoint checkpoint{identity, state};
  identity.settings.raysPerPixel = wanted;
  return whyNotContinued(checkpoint, identity);
}

TEST(CheckpointRays, OnlyPassesOfTheWantedImageAreGoneOnFrom) {
  EXPECT_EQ(whyNotRefined(128, 128, 0, 1000), "");
  EXPECT_EQ(whyNotRefined(1000, 128, 16, 192), "");
  EXPECT_EQ(whyNotRefined(1000, 128, 0, 128), "");
  EXPECT_EQ(whyNotRefined(100, 100, 0, 100), "");
  EXPECT_EQ(whyNotRefined(100, 64, 0, 1000), "");
  EXPECT_EQ(whyNotRefined(100, 64, 16, 100), "");
  EXPECT_NE(whyNotRefined(100, 64, 16, 1000), "") << "36 rays of a row are no pass of 64";
  EXPECT_NE(whyNotRefined(100, 100, 0, 1000), "");
  EXPECT_NE(whyNotRefined(1000, 128, 16, 150), "");
  EXPECT_NE(whyNotRefined(1000, 128, 0, 64), "");
  EXPECT_NE(whyNotRefined(5, 5, 0, 10), "") << "passes of 5 and of 10";
}

// The render that a finished picture's sentence, or a refusal, names after this word.
RenderSettings namedAfter(const std::string& word, const std::string& sentence) {
  const std::string rays = word + "--rays-per-pixel ", replicates = " --replicates ";
  const std::size_t at = sentence.find(rays);
  EXPECT_NE(at, std::string::npos) << sentence;
  RenderSettings named;
  if (at == std::string::npos) return named;
  std::size_t end = 0;
  const std::string rest = sentence.substr(at + rays.size());
  named.raysPerPixel = std::stoull(rest, &end);
  if (rest.compare(end, replicates.size(), replicates) == 0)
    named.replicates = static_cast<std::uint32_t>(std::stoul(rest.substr(end + replicates.size())));
  return named;
}

RenderSettings settingsOf(std::uint64_t rays, std::uint32_t replicates) {
  RenderSettings settings;
  settings.raysPerPixel = rays;
  settings.replicates = replicates;
  return settings;
}

Checkpoint finishedCheckpoint(const RenderSettings& settings) {
  RenderState state;
  if (settings.replicates > 1)
    state.replicate = settings.replicates;
  else
    state.firstRay = settings.raysPerPixel;
  return {identityOf(settings), state};
}

TEST(CheckpointRays, WhatIsNamedToRefineAPictureIsGoneOnTo) {
  for (const auto& [rays, replicates] :
       {std::pair{64u, 1u}, {640u, 1u}, {128u, 4u}, {300u, 3u}, {100u, 2u}, {1000u, 1000u}}) {
    const RenderSettings made = settingsOf(rays, replicates);
    const std::string sentence = howToRefine(made);
    const RenderSettings named = namedAfter("such as ", sentence);
    EXPECT_GT(named.raysPerPixel, rays) << sentence;
    EXPECT_EQ(whyNotContinued(finishedCheckpoint(made), identityOf(named)), "") << sentence;
  }
  EXPECT_EQ(howToRefine(settingsOf(128, 4)),
            "To refine the picture: --resume with more replicates of 32 rays per pixel, such as "
            "--rays-per-pixel 256 --replicates 8.");
}

TEST(CheckpointRays, APictureThatCannotBeRefinedSaysSo) {
  for (const std::uint64_t rays : {1u, 32u, 63u, 65u, 100u}) {
    const RenderSettings made = settingsOf(rays, 1);
    EXPECT_NE(whyNotContinued(finishedCheckpoint(made), identityOf(settingsOf(1024, 1))), "");
    const std::string sentence = howToRefine(made);
    EXPECT_TRUE(sentence.starts_with("The picture cannot be refined: ")) << sentence;
    const RenderSettings named = namedAfter("with ", sentence);
    EXPECT_TRUE(howToRefine(named).starts_with("To refine ")) << sentence;
  }
  EXPECT_TRUE(howToRefine(settingsOf(1024, 1024)).starts_with("The picture cannot be refined: "));
}

TEST(CheckpointRays, ARefusalNamesWhatIsGoneOnTo) {
  const RenderSettings pictures[] = {settingsOf(32, 1), settingsOf(128, 1), settingsOf(1000, 1),
                                     settingsOf(128, 4), settingsOf(1024, 1024)};
  for (const RenderSettings& made : pictures)
    for (const bool complete : {true, false})
      for (const RenderSettings& wanted :
           {settingsOf(16, 1), settingsOf(128, 1), settingsOf(300, 3), settingsOf(4096, 16)}) {
        Checkpoint checkpoint = finishedCheckpoint(made);
        if (!complete) checkpoint.state = RenderState{};
        const std::string why = whyNotContinued(checkpoint, identityOf(wanted));
        if (why.empty()) continue;
        if (why.ends_with("; it is complete, and cannot be refined")) {
          EXPECT_TRUE(complete) << why;
          EXPECT_TRUE(howToRefine(made).starts_with("The picture cannot be refined: ")) << why;
          continue;
        }
        const RenderSettings named = namedAfter("; with ", why);
        EXPECT_EQ(whyNotContinued(checkpoint, identityOf(named)), "") << why;
        EXPECT_TRUE(!complete || named.raysPerPixel > made.raysPerPixel) << why;
      }
  EXPECT_TRUE(
      whyNotContinued(finishedCheckpoint(settingsOf(100, 1)), identityOf(settingsOf(300, 1)))
          .ends_with("belongs to a picture of 100 only; one of a multiple of 64 rays per "
                     "pixel, such as 128, could be refined"));
}

void expectSame(const RenderedImage& a, const RenderedImage& b) {
  EXPECT_EQ(a.image.rgb, b.image.rgb);
  EXPECT_EQ(a.image.invalid, b.image.invalid);
  EXPECT_EQ(a.image.variance, b.image.variance);
  EXPECT_EQ(a.invalid.nan, b.invalid.nan);
  EXPECT_EQ(a.invalid.firstPixel, b.invalid.firstPixel);
  EXPECT_EQ(a.raysTraced, b.raysTraced);
}

// Every step is made in a new worker from what the last one has left in a file, and every second
// one is ended in its middle first.
void expectSameBitsInPieces(const RenderSettings& settings) {
  TestCoursework coursework;
  coursework.setTracePath(
      "(void)ray; const vec2 u = sampler.next2D();\n"
      "return u.x < 1e-4f ? Colour(0.0f / (u.x - u.x)) : Colour(u.x, u.y, u.x * u.y);");
  const FlatScene scene = emptyScene(settings.width, settings.height);
  const TemporaryFolder folder;
  const auto worker = coursework.start();
  worker->loadScene(scene);
  const RenderedImage whole = renderImage(*worker, settings, goOn);
  EXPECT_GT(whole.invalid.nan, 0u);
  RenderState state;
  RenderedImage last;
  for (int piece = 0; !finished(settings, state); ++piece) {
    RenderSettings some = settings;
    some.threads = 1 + static_cast<std::uint32_t>(piece) % 5;
    ImageRender render(*worker, some, std::move(state));
    if (piece % 2 == 1) render.step([](const RenderStatus&) { return false; });
    if (piece % 4 != 1) {
      render.step(goOn);
      last = render.image();
    }
    writeCheckpoint(folder / "a", identityOf(some), render.state());
    state = readCheckpoint(folder / "a").state;
  }
  EXPECT_TRUE(last.complete);
  expectSame(last, whole);
}

TEST(CheckpointRender, ManyPiecesHaveTheBitsOfOne) {
  RenderSettings settings;
  settings.width = 60;
  settings.height = 70;
  settings.raysPerPixel = 150;
  expectSameBitsInPieces(settings);
}

TEST(CheckpointRender, ManyPiecesHaveTheBitsOfOneWithReplicates) {
  RenderSettings settings;
  settings.width = 60;
  settings.height = 40;
  settings.raysPerPixel = 300;
  settings.replicates = 3;
  expectSameBitsInPieces(settings);
}

}  // namespace
}  // namespace pathmark::test
