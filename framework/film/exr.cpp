// OpenEXR files; the only source that knows the library.
#include "film/image_formats.h"
#include "film/image_limits.h"
#include "film/noise_rounding.h"
#include "film/printable.h"

#include <fmt/format.h>

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVersion.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <limits>
#include <new>

namespace pathmark {

namespace {

constexpr std::array<const char*, 3> kRadiance{"R", "G", "B"};
constexpr std::array<const char*, 3> kVariance{"variance.R", "variance.G", "variance.B"};
constexpr const char* kInvalid = "invalid";
constexpr const char* kStreamName = "memory";

// The library keeps a block of rows of all channels in memory.
constexpr int kMostChannels = 64;

class WritableMemory : public Imf::OStream {
 public:
  explicit WritableMemory(std::string& bytes) : OStream(kStreamName), bytes_(bytes) {}

  void write(const char* data, int size) override {
    const auto count = static_cast<std::size_t>(size);
    bytes_.resize(std::max(bytes_.size(), at_ + count));
    std::memcpy(bytes_.data() + at_, data, count);
    at_ += count;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }

 private:
  std::string& bytes_;
  std::size_t at_ = 0;
};

class ReadableMemory : public Imf::IStream {
 public:
  explicit ReadableMemory(std::string_view bytes) : IStream(kStreamName), bytes_(bytes) {}

  bool read(char* data, int size) override {
    if (size < 0 || at_ > bytes_.size() || static_cast<std::size_t>(size) > bytes_.size() - at_)
      throw ImageError("the file ends early.");
    std::memcpy(data, bytes_.data() + at_, static_cast<std::size_t>(size));
    at_ += static_cast<std::size_t>(size);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = at; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

Imf::IntAttribute countAttribute(std::uint32_t count) {
  constexpr std::uint32_t kLargest = std::numeric_limits<int>::max();
  return Imf::IntAttribute(static_cast<int>(std::min(count, kLargest)));
}

// EXR's whole numbers have 32 bits and a sign: the seed is text.
void storeOrigin(Imf::Header& header, const ImageOrigin& origin) {
  header.insert("pathmark.scene", Imf::StringAttribute(origin.scene));
  header.insert("pathmark.sceneHash", Imf::StringAttribute(origin.sceneHash));
  header.insert("pathmark.coursework", Imf::StringAttribute(origin.coursework));
  header.insert("pathmark.raysPerPixel", Imf::DoubleAttribute(origin.raysPerPixel));
  header.insert("pathmark.raysPerPass", countAttribute(origin.raysPerPass));
  header.insert("pathmark.replicates", countAttribute(origin.replicates));
  if (origin.pixelsPerBlock != 1)
    header.insert("pathmark.pixelsPerBlock", countAttribute(origin.pixelsPerBlock));
  header.insert("pathmark.seed", Imf::StringAttribute(fmt::format("{}", origin.seed)));
  if (!origin.sampler.empty())
    header.insert("pathmark.sampler", Imf::StringAttribute(origin.sampler));
  if (!origin.paths.empty()) header.insert("pathmark.paths", Imf::StringAttribute(origin.paths));
  header.insert("pathmark.seconds", Imf::DoubleAttribute(origin.seconds));
  if (origin.targetError > 0.0) {
    header.insert("pathmark.targetError", Imf::DoubleAttribute(origin.targetError));
    header.insert("pathmark.worstTileError", Imf::DoubleAttribute(origin.worstTileError));
  }
}

// Leaves `value` as it is where the attribute is not there.
template <typename Attribute, typename Value>
void find(const Imf::Header& header, const char* name, Value& value) {
  const auto* attribute = header.findTypedAttribute<Attribute>(name);
  if (attribute != nullptr) value = attribute->value();
}

std::uint32_t countFrom(const Imf::Header& header, const char* name, std::uint32_t otherwise) {
  int value = static_cast<int>(otherwise);
  find<Imf::IntAttribute>(header, name, value);
  if (value < 0) throw ImageError(fmt::format("its {} is {}, and a count is needed.", name, value));
  return static_cast<std::uint32_t>(value);
}

ImageOrigin originFrom(const Imf::Header& header) {
  ImageOrigin origin;
  std::string seed = "0";
  find<Imf::StringAttribute>(header, "pathmark.scene", origin.scene);
  find<Imf::StringAttribute>(header, "pathmark.sceneHash", origin.sceneHash);
  find<Imf::StringAttribute>(header, "pathmark.coursework", origin.coursework);
  find<Imf::StringAttribute>(header, "pathmark.seed", seed);
  find<Imf::StringAttribute>(header, "pathmark.sampler", origin.sampler);
  find<Imf::StringAttribute>(header, "pathmark.paths", origin.paths);
  find<Imf::DoubleAttribute>(header, "pathmark.raysPerPixel", origin.raysPerPixel);
  find<Imf::DoubleAttribute>(header, "pathmark.seconds", origin.seconds);
  find<Imf::DoubleAttribute>(header, "pathmark.targetError", origin.targetError);
  find<Imf::DoubleAttribute>(header, "pathmark.worstTileError", origin.worstTileError);
  origin.raysPerPass = countFrom(header, "pathmark.raysPerPass", origin.raysPerPass);
  origin.replicates = countFrom(header, "pathmark.replicates", origin.replicates);
  origin.pixelsPerBlock = countFrom(header, "pathmark.pixelsPerBlock", origin.pixelsPerBlock);
  const auto [end, error] = std::from_chars(seed.data(), seed.data() + seed.size(), origin.seed);
  if (error != std::errc{} || end != seed.data() + seed.size())
    throw ImageError(fmt::format(
        "its pathmark.seed is \"{}\", and a whole number below 2^64 is needed.", printable(seed)));
  return origin;
}

// Three channels of a frame buffer whose values lie side by side.
void addColour(Imf::FrameBuffer& buffer, const std::array<const char*, 3>& names,
               const float* values, const Imath::Box2i& window) {
  const auto width = static_cast<std::size_t>(std::int64_t{window.max.x} - window.min.x + 1);
  for (std::size_t c = 0; c < 3; ++c)
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, values + c, window, 3 * sizeof(float),
                                             3 * sizeof(float) * width));
}

bool hasAll(const Imf::ChannelList& channels, const std::array<const char*, 3>& names) {
  return std::all_of(names.begin(), names.end(), [&](const char* name) {
    const Imf::Channel* channel = channels.findChannel(name);
    return channel != nullptr && channel->xSampling == 1 && channel->ySampling == 1;
  });
}

// What the library says behind `Cannot read image file "memory". `, without the full stop.
std::string libraryReason(std::string_view message) {
  const std::string file = fmt::format("\"{}\". ", kStreamName);
  const std::size_t at = message.rfind(file);
  if (at != std::string_view::npos) message.remove_prefix(at + file.size());
  if (message.ends_with('.')) message.remove_suffix(1);
  return printable(message);
}

std::string namesOf(const Imf::ChannelList& channels) {
  std::string names;
  for (auto c = channels.begin(); c != channels.end(); ++c)
    names += (names.empty() ? "" : ", ") + std::string(c.name());
  return names.empty() ? "none" : names;
}

// The header is a list of name, type, size and value; an empty name ends it (OpenEXR File Layout,
// "Header"). The library allocates `size` bytes before it notices that the file has fewer.
void refuseLongAttributes(std::string_view bytes) {
  const auto skipText = [&bytes] {
    const std::size_t end = bytes.find('\0');
    if (end == std::string_view::npos) throw ImageError("the file ends within its header.");
    bytes.remove_prefix(end + 1);
    return end;
  };
  while (skipText() > 0) {
    skipText();
    std::int32_t size = 0;
    if (bytes.size() >= sizeof size) std::memcpy(&size, bytes.data(), sizeof size);
    if (bytes.size() < sizeof size || size < 0 ||
        static_cast<std::size_t>(size) > bytes.size() - sizeof size)
      throw ImageError("the file ends within its header.");
    bytes.remove_prefix(sizeof size + static_cast<std::size_t>(size));
  }
}

// By the header alone, since the library allocates for whatever the header claims.
void refuseHeader(std::string_view bytes) {
  if (!bytes.starts_with(std::string_view("\x76\x2f\x31\x01", 4)))
    throw ImageError("this is no EXR image: its first bytes are not those of the format.");
  ReadableMemory in(bytes);
  in.seekg(4);
  std::array<char, 4> version{};
  in.read(version.data(), 4);
  int flags = 0;
  std::memcpy(&flags, version.data(), 4);
  if (Imf::isMultiPart(flags) || Imf::isNonImage(flags))
    throw ImageError("this EXR image has several parts or deep pixels; one flat part is needed.");
  refuseLongAttributes(bytes.substr(8));
  Imf::Header header;
  header.readFrom(in, flags);
  const Imath::Box2i& window = header.dataWindow();
  requireImageSize(std::int64_t{window.max.x} - window.min.x + 1,
                   std::int64_t{window.max.y} - window.min.y + 1);
  if (header.hasTileDescription())
    requireImageSize(header.tileDescription().xSize, header.tileDescription().ySize);
  const Imf::ChannelList& channels = header.channels();
  int count = 0;
  for (auto c = channels.begin(); c != channels.end(); ++c) ++count;
  if (count > kMostChannels)
    throw ImageError(fmt::format("this EXR image has more than {} channels.", kMostChannels));
  if (!hasAll(channels, kRadiance))
    throw ImageError(
        fmt::format("the channels of this EXR image are {}; needed are R, G and B in every pixel.",
                    printable(namesOf(channels))));
}

ImageFile readPixels(Imf::InputFile& file) {
  const Imf::Header& header = file.header();
  const Imath::Box2i window = header.dataWindow();
  ImageFile result;
  Image& image = result.image;
  image.width = window.max.x - window.min.x + 1;
  image.height = window.max.y - window.min.y + 1;
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  Imf::FrameBuffer buffer;
  image.rgb.resize(3 * pixels);
  addColour(buffer, kRadiance, image.rgb.data(), window);
  if (hasAll(header.channels(), kVariance)) {
    image.variance.resize(3 * pixels);
    addColour(buffer, kVariance, image.variance.data(), window);
  }
  std::vector<std::uint32_t> invalid;
  const Imf::Channel* channel = header.channels().findChannel(kInvalid);
  if (channel != nullptr && channel->xSampling == 1 && channel->ySampling == 1) {
    invalid.resize(pixels);
    buffer.insert(kInvalid, Imf::Slice::Make(Imf::UINT, invalid.data(), window));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  for (const std::uint32_t mark : invalid) image.invalid.push_back(mark != 0 ? 1 : 0);
  result.origin = originFrom(header);
  return result;
}

}  // namespace

std::string encodeExr(const Image& full, const ImageOrigin& origin, ExrBits bits) {
  const Image image = bits == ExrBits::kAboveNoise ? roundedToNoise(full) : full;
  Imf::Header header(image.width, image.height);
  // PIZ packs noise more tightly, and takes longer.
  header.compression() = bits == ExrBits::kAboveNoise ? Imf::PIZ_COMPRESSION : Imf::ZIP_COMPRESSION;
  storeOrigin(header, origin);
  const Imath::Box2i window = header.dataWindow();
  Imf::FrameBuffer buffer;
  const auto add = [&](const std::array<const char*, 3>& names, const std::vector<float>& values) {
    for (const char* name : names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    addColour(buffer, names, values.data(), window);
  };
  add(kRadiance, image.rgb);
  if (!image.variance.empty()) add(kVariance, image.variance);
  const std::vector<std::uint32_t> invalid(image.invalid.begin(), image.invalid.end());
  if (!invalid.empty()) {
    header.channels().insert(kInvalid, Imf::Channel(Imf::UINT));
    buffer.insert(kInvalid, Imf::Slice::Make(Imf::UINT, invalid.data(), window));
  }
  std::string bytes;
  WritableMemory out(bytes);
  {
    // The table of rows is written when the file goes out of scope.
    Imf::OutputFile file(out, header, 0);
    file.setFrameBuffer(buffer);
    file.writePixels(image.height);
  }
  return bytes;
}

ImageFile decodeExr(std::string_view bytes) {
  try {
    refuseHeader(bytes);
    ReadableMemory in(bytes);
    Imf::InputFile file(in, 0);
    if (!file.isComplete()) throw ImageError("the file ends before its last pixel.");
    return readPixels(file);
  } catch (const ImageError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw ImageError(fmt::format("this EXR image is damaged: {}.", libraryReason(e.what())));
  }
}

}  // namespace pathmark
