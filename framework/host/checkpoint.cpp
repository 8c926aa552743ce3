// The file: a header, the film, with several replicates their sums and moments, and the content
// hash of all that. Native byte order.
#include "host/checkpoint.h"

#include "film/atomic_file.h"
#include "host/content_hash.h"
#include "light_paths/expression.h"
#include "scene/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t kHashDigits = 32, kPathsText = PathExpression::kLongestText;
constexpr char kMagic[8] = {'P', 'M', 'c', 'h', 'e', 'c', 'k', '\n'};
constexpr std::uint32_t kVersion = 5;

struct Header {
  char magic[8];
  std::uint32_t version = kVersion;
  std::uint8_t estimator = 0, sampler = 0, zero[2] = {0, 0};
  PathSharing sharing;
  char scene[kHashDigits];
  char coursework[kHashDigits];
  char paths[kPathsText];  // then zeros
  std::uint32_t width = 0, height = 0, maxBounces = 0, replicates = 0;
  std::uint64_t raysPerPixel = 0, seed = 0;
  std::uint64_t replicate = 0, firstRay = 0, row = 0, raysTraced = 0;
  double seconds = 0.0;
  InvalidPixels invalid;
};
static_assert(sizeof(Header) == 32 + 2 * kHashDigits + kPathsText + 16 + 56 + sizeof(InvalidPixels),
              "no padding: its bytes would be random");

constexpr const char* kDamaged = "it is damaged";

template <class T>
std::string_view bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

template <class T>
std::string_view bytesOf(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

Header headerOf(const CheckpointIdentity& identity, const RenderState& state) {
  const RenderSettings& settings = identity.settings;
  Header header;
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  std::memset(header.scene, 0, kHashDigits);
  std::memset(header.coursework, 0, kHashDigits);
  std::memset(header.paths, 0, kPathsText);
  settings.paths.copy(header.paths, kPathsText);
  identity.scene.copy(header.scene, kHashDigits);
  identity.coursework.copy(header.coursework, kHashDigits);
  header.estimator = static_cast<std::uint8_t>(settings.estimator);
  header.sampler = static_cast<std::uint8_t>(settings.sampler);
  header.sharing = settings.sharing;
  header.width = static_cast<std::uint32_t>(settings.width);
  header.height = static_cast<std::uint32_t>(settings.height);
  header.maxBounces = identity.maxBounces;
  header.replicates = settings.replicates;
  header.raysPerPixel = settings.raysPerPixel;
  header.seed = settings.seed;
  header.replicate = state.replicate;
  header.firstRay = state.firstRay;
  header.row = state.row;
  header.raysTraced = state.raysTraced;
  header.seconds = state.seconds;
  header.invalid = state.invalid;
  return header;
}

std::size_t lengthOf(const char (&text)[kPathsText]) {
  return static_cast<std::size_t>(std::find(std::begin(text), std::end(text), '\0') - text);
}

Checkpoint checkpointOf(const Header& header) {
  Checkpoint checkpoint;
  CheckpointIdentity& identity = checkpoint.identity;
  identity.scene.assign(header.scene, kHashDigits);
  identity.coursework.assign(header.coursework, kHashDigits);
  identity.maxBounces = header.maxBounces;
  identity.settings.width = static_cast<int>(header.width);
  identity.settings.height = static_cast<int>(header.height);
  identity.settings.raysPerPixel = header.raysPerPixel;
  identity.settings.replicates = header.replicates;
  identity.settings.seed = header.seed;
  identity.settings.estimator = static_cast<Estimator>(header.estimator);
  identity.settings.sharing = header.sharing;
  identity.settings.sampler = static_cast<SamplerKind>(header.sampler);
  identity.settings.paths.assign(header.paths, lengthOf(header.paths));
  RenderState& state = checkpoint.state;
  state.replicate = header.replicate;
  state.firstRay = header.firstRay;
  state.row = header.row;
  state.raysTraced = header.raysTraced;
  state.seconds = header.seconds;
  state.invalid = header.invalid;
  return checkpoint;
}

// Text that is no expression could do anything to a terminal.
bool isPossible(const char (&paths)[kPathsText]) {
  const std::string_view text(paths, lengthOf(paths));
  const std::string_view rest(paths + text.size(), kPathsText - text.size());
  if (rest.find_first_not_of('\0') != std::string_view::npos) return false;
  if (text.empty()) return true;
  try {
    [[maybe_unused]] const PathExpression read(text);
    return true;
  } catch (const ExpressionError&) {
    return false;
  }
}

bool isPossible(const PathSharing& sharing) {
  const auto within = [](std::uint32_t value) { return value >= 1 && value <= PathSharing::kMost; };
  return within(sharing.pathsPerRay) && sharing.directLight <= 1 && within(sharing.pixels) &&
         std::has_single_bit(sharing.pixels) && within(sharing.directPaths);
}

// The numbers fit together, and none is so large that a calculation with it could overflow.
bool isPossible(const Header& header) {
  constexpr std::uint32_t kLargestSide = 1u << 26;
  constexpr std::uint64_t kMost = 1ull << 62;
  const auto within = [](std::uint64_t value, std::uint64_t low, std::uint64_t high) {
    return value >= low && value <= high;
  };
  if (!within(header.width, 1, kLargestSide) || !within(header.height, 1, kLargestSide) ||
      std::uint64_t{header.width} * header.height > kMostPixels ||
      !within(header.raysPerPixel, 1, kMostRaysPerPixel) ||
      !within(header.replicates, 1, header.raysPerPixel) ||
      header.raysPerPixel % header.replicates != 0 ||
      header.estimator > static_cast<std::uint8_t>(Estimator::kReuse) ||
      !isPossible(header.sharing) || header.sampler >= kSamplerNames.size() ||
      !isPossible(header.paths))
    return false;
  const RenderSettings settings = checkpointOf(header).identity.settings;
  const std::uint64_t each = settings.raysPerReplicate();
  const bool several = header.replicates > 1;
  const bool complete = header.replicate == header.replicates;
  return within(header.replicate, 0, several ? header.replicates : 0) &&
         within(header.firstRay, 0,
                complete  ? 0
                : several ? each - 1
                          : each) &&
         header.row < header.height &&
         (header.firstRay % settings.raysPerPass() == 0 || header.firstRay == each) &&
         (header.row == 0 || (!complete && header.firstRay < each)) && header.raysTraced < kMost &&
         std::isfinite(header.seconds) && header.seconds >= 0.0 && header.invalid.nan < kMost / 4 &&
         header.invalid.infinite < kMost / 4 && header.invalid.negative < kMost / 4;
}

bool isPossible(const PixelMoments& moments, double most) {
  bool possible = moments.count >= 0.0 && moments.count <= most;
  for (int c = 0; c < 3; ++c)
    possible = possible && std::isfinite(moments.mean[c]) && moments.deviations[c] >= 0.0 &&
               std::isfinite(moments.deviations[c]);
  return possible;
}

bool isPossible(const Checkpoint& checkpoint) {
  const RenderState& state = checkpoint.state;
  const auto each = static_cast<double>(checkpoint.identity.settings.raysPerReplicate());
  const auto replicates = static_cast<double>(state.replicate);
  bool possible = true;
  for (const FilmPixel& pixel : state.film) possible = possible && isPossible(pixel, each);
  for (const FilmPixel& pixel : state.replicates.film)
    possible = possible && isPossible(pixel, each * replicates);
  for (const PixelMoments& moments : state.replicates.moments)
    possible = possible && isPossible(moments, replicates);
  return possible;
}

class Reader {
 public:
  explicit Reader(const fs::path& file) {
    std::error_code error;
    // Reading from a pipe or a device could last for ever.
    if (!fs::is_regular_file(file, error)) throw CheckpointError("it is no file");
    size_ = fs::file_size(file, error);
    in_.open(file, std::ios::binary);
    if (error || !in_) throw CheckpointError("it cannot be read");
  }

  std::uintmax_t size() const { return size_; }

  void read(char* to, std::size_t bytes) {
    in_.read(to, static_cast<std::streamsize>(bytes));
    if (!in_) throw CheckpointError("it is cut short");
    hasher_.add({to, bytes});
  }

  template <class T>
  void read(std::vector<T>& values, std::size_t count) {
    values.resize(count);
    read(reinterpret_cast<char*>(values.data()), count * sizeof(T));
  }

  std::string hashOfAllRead() const { return hasher_.digits(); }

 private:
  std::ifstream in_;
  std::uintmax_t size_ = 0;
  ContentHasher hasher_;
};

Header readHeader(Reader& reader) {
  Header header;
  if (reader.size() < sizeof header) throw CheckpointError("it is cut short");
  reader.read(reinterpret_cast<char*>(&header), sizeof header);
  if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0)
    throw CheckpointError("it is no checkpoint of this program");
  if (header.version != kVersion)
    throw CheckpointError("another version of this program has written it");
  if (!isPossible(header)) throw CheckpointError(kDamaged);
  return header;
}

}  // namespace

void writeCheckpoint(const fs::path& file, const CheckpointIdentity& identity,
                     const RenderState& state) {
  const Header header = headerOf(identity, state);
  std::vector<std::string_view> pieces{bytesOf(header), bytesOf(state.film),
                                       bytesOf(state.replicates.film),
                                       bytesOf(state.replicates.moments)};
  ContentHasher hasher;
  for (const std::string_view piece : pieces) hasher.add(piece);
  const std::string hash = hasher.digits();
  pieces.push_back(hash);
  writeFileAtomically(file, pieces);
}

Checkpoint readCheckpoint(const fs::path& file) {
  Reader reader(file);
  const Header header = readHeader(reader);
  Checkpoint checkpoint = checkpointOf(header);
  const std::size_t pixels = checkpoint.identity.settings.pixels();
  const std::size_t sums = header.replicate > 0 ? pixels : 0;
  const std::uintmax_t due = sizeof header + pixels * sizeof(FilmPixel) +
                             sums * (sizeof(FilmPixel) + sizeof(PixelMoments)) + kHashDigits;
  // Before memory is taken for what the header says.
  if (reader.size() != due)
    throw CheckpointError(fmt::format("it has {} bytes where {} belong", reader.size(), due));
  reader.read(checkpoint.state.film, pixels);
  reader.read(checkpoint.state.replicates.film, sums);
  reader.read(checkpoint.state.replicates.moments, sums);
  const std::string hash = reader.hashOfAllRead();
  std::array<char, kHashDigits> stored{};
  reader.read(stored.data(), stored.size());
  if (hash != std::string_view(stored.data(), stored.size()) || !isPossible(checkpoint))
    throw CheckpointError(kDamaged);
  return checkpoint;
}

Checkpoint readCheckpointHeader(const fs::path& file) {
  Reader reader(file);
  return checkpointOf(readHeader(reader));
}

}  // namespace pathmark
