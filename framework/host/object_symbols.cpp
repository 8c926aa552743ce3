#include "host/object_symbols.h"

#include "host/elf_reader.h"

#include <algorithm>

namespace pathmark {

namespace {

void addTable(std::span<const std::byte> bytes, const Elf64_Shdr& table, const Elf64_Shdr& strings,
              ObjectSymbols& symbols) {
  const std::uint64_t count =
      std::min<std::uint64_t>(table.sh_size, bytes.size()) / sizeof(Elf64_Sym);
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto symbol = elf::at<Elf64_Sym>(bytes, table.sh_offset + k * sizeof(Elf64_Sym));
    if (!symbol || ELF64_ST_BIND(symbol->st_info) == STB_LOCAL) continue;
    const std::string_view name = elf::nameAt(bytes, strings, symbol->st_name);
    if (name.empty()) continue;
    (symbol->st_shndx == SHN_UNDEF ? symbols.used : symbols.offered).emplace_back(name);
  }
}

}  // namespace

ObjectSymbols symbolsOf(std::span<const std::byte> bytes) {
  ObjectSymbols symbols;
  const auto header = elf::at<Elf64_Ehdr>(bytes, 0);
  if (!header || !elf::isRelocatable(*header)) return symbols;
  const auto first = elf::sectionAt(bytes, *header, 0);
  if (!first) return symbols;
  // More sections than the header can count are announced in the first one.
  const std::uint64_t count = header->e_shnum != 0 ? header->e_shnum : first->sh_size;
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto table = elf::sectionAt(bytes, *header, k);
    if (!table) break;
    if (table->sh_type != SHT_SYMTAB) continue;
    if (const auto strings = elf::sectionAt(bytes, *header, table->sh_link))
      addTable(bytes, *table, *strings, symbols);
  }
  return symbols;
}

}  // namespace pathmark
