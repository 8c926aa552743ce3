#include "support/made_archive.h"

#include <archive.h>
#include <archive_entry.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace pathmark::test {

namespace {

struct Close {
  void operator()(archive* a) const { archive_write_free(a); }
  void operator()(archive_entry* e) const { archive_entry_free(e); }
};

void require(archive* a, int result) {
  if (result < ARCHIVE_WARN) throw std::runtime_error(archive_error_string(a));
}

void chooseFormat(archive* a, ArchiveKind kind) {
  if (kind == ArchiveKind::kZip || kind == ArchiveKind::kEncryptedZip) {
    require(a, archive_write_set_format_zip(a));
    if (kind == ArchiveKind::kZip) return;
    require(a, archive_write_set_options(a, "zip:encryption=zipcrypt"));
    require(a, archive_write_set_passphrase(a, "secret"));
    return;
  }
  require(a, archive_write_set_format_pax_restricted(a));
  if (kind == ArchiveKind::kTarGz) require(a, archive_write_add_filter_gzip(a));
  if (kind == ArchiveKind::kTarXz) require(a, archive_write_add_filter_xz(a));
  if (kind == ArchiveKind::kTarZst) require(a, archive_write_add_filter_zstd(a));
  if (kind == ArchiveKind::kTarBz2) require(a, archive_write_add_filter_bzip2(a));
}

}  // namespace

MadeArchive& MadeArchive::add(std::string name, unsigned type, std::string bytes,
                              std::string target, bool isHardLink) {
  entries_.push_back(
      {std::move(name), std::move(bytes), std::move(target), type, isHardLink, time_});
  return *this;
}

MadeArchive& MadeArchive::file(std::string name, std::string bytes) {
  return add(std::move(name), AE_IFREG, std::move(bytes));
}
MadeArchive& MadeArchive::folder(std::string name) { return add(std::move(name), AE_IFDIR); }
MadeArchive& MadeArchive::symbolicLink(std::string name, std::string target) {
  return add(std::move(name), AE_IFLNK, {}, std::move(target));
}
MadeArchive& MadeArchive::hardLink(std::string name, std::string target) {
  return add(std::move(name), AE_IFREG, {}, std::move(target), true);
}
MadeArchive& MadeArchive::fifo(std::string name) { return add(std::move(name), AE_IFIFO); }
MadeArchive& MadeArchive::device(std::string name) { return add(std::move(name), AE_IFCHR); }
MadeArchive& MadeArchive::time(long seconds) {
  time_ = seconds;
  return *this;
}

void MadeArchive::write(ArchiveKind kind, const std::filesystem::path& file) const {
  const std::unique_ptr<archive, Close> made(archive_write_new());
  archive* const a = made.get();
  chooseFormat(a, kind);
  require(a, archive_write_open_filename(a, file.c_str()));
  for (const Entry& entry : entries_) {
    const std::unique_ptr<archive_entry, Close> header(archive_entry_new());
    archive_entry_set_pathname(header.get(), entry.name.c_str());
    archive_entry_set_filetype(header.get(), entry.type);
    archive_entry_set_perm(header.get(), 0644);
    archive_entry_set_mtime(header.get(), entry.time, 0);
    archive_entry_set_size(header.get(), static_cast<la_int64_t>(entry.bytes.size()));
    if (entry.isHardLink) {
      archive_entry_set_hardlink(header.get(), entry.target.c_str());
    } else if (!entry.target.empty()) {
      archive_entry_set_symlink(header.get(), entry.target.c_str());
    }
    require(a, archive_write_header(a, header.get()));
    if (archive_write_data(a, entry.bytes.data(), entry.bytes.size()) < 0)
      throw std::runtime_error(archive_error_string(a));
  }
  require(a, archive_write_close(a));
}

std::string readBytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

void writeBytes(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace pathmark::test
