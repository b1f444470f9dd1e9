// Puts a function of ours in the place of one of a shared library.
#include "roscpp_fixes/replaced_function.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <utility>

namespace rubber_suspension::roscpp_fixes {
namespace {

template <class Thing>
Thing* pointerTo(std::uintptr_t address) {
  return reinterpret_cast<Thing*>(address);  // NOLINT(performance-no-int-to-ptr): the linker tells numbers
}

// The relocations of a library: the places where the dynamic linker has put addresses of functions.
class Library {
 public:
  explicit Library(const dl_phdr_info& info) : base_(info.dlpi_addr) {
    for (const ElfW(Phdr)* header = info.dlpi_phdr; header != info.dlpi_phdr + info.dlpi_phnum; ++header) {
      if (header->p_type == PT_DYNAMIC) {
        readDynamic(pointerTo<const ElfW(Dyn)>(base_ + header->p_vaddr));
      } else if (header->p_type == PT_GNU_RELRO) {
        sealed_begin_ = base_ + header->p_vaddr;
        sealed_end_ = sealed_begin_ + header->p_memsz;
      }
    }
  }

  // True where a place was found.
  bool replace(const ReplacedFunction& function) const {
    bool found = false;
    // A call that was not made yet may still lead to the linker: its name alone tells.
    for (const auto& [table, by_name] : {std::pair(data_, false), std::pair(calls_, true)}) {
      for (const ElfW(Rela)* entry = table.begin; entry != nullptr && entry < table.end; ++entry) {
        auto** const place = pointerTo<void*>(base_ + entry->r_offset);
        const bool is_it = isNamed(*entry, function.symbol) && (by_name || *place == *function.original);
        found = (is_it && write(place, function.replacement)) || found;
      }
    }
    return found;
  }

 private:
  struct Table {
    const ElfW(Rela) * begin = nullptr;
    const ElfW(Rela) * end = nullptr;
  };

  void readDynamic(const ElfW(Dyn) * entry) {
    std::size_t data_size = 0;
    std::size_t calls_size = 0;
    for (; entry->d_tag != DT_NULL; ++entry) {
      switch (entry->d_tag) {
        case DT_SYMTAB:
          symbols_ = at<ElfW(Sym)>(entry->d_un.d_ptr);
          break;
        case DT_STRTAB:
          names_ = at<char>(entry->d_un.d_ptr);
          break;
        case DT_RELA:
          data_.begin = at<ElfW(Rela)>(entry->d_un.d_ptr);
          break;
        case DT_RELASZ:
          data_size = entry->d_un.d_val;
          break;
        case DT_JMPREL:
          calls_.begin = at<ElfW(Rela)>(entry->d_un.d_ptr);
          break;
        case DT_PLTRELSZ:
          calls_size = entry->d_un.d_val;
          break;
        case DT_PLTREL:
          has_addends_ = entry->d_un.d_val == DT_RELA;
          break;
        default:
          break;
      }
    }
    data_.end = data_.begin == nullptr ? nullptr : data_.begin + data_size / sizeof(ElfW(Rela));
    calls_.begin = has_addends_ ? calls_.begin : nullptr;
    calls_.end = calls_.begin == nullptr ? nullptr : calls_.begin + calls_size / sizeof(ElfW(Rela));
  }

  // glibc has made absolute most of what stands there.
  template <class Entry>
  const Entry* at(ElfW(Addr) address) const {
    return pointerTo<const Entry>(address < base_ ? base_ + address : address);
  }

  bool isNamed(const ElfW(Rela) & entry, const char* name) const {
    const std::size_t symbol = sizeof(void*) == 8 ? entry.r_info >> 32U : entry.r_info >> 8U;
    return symbol != 0 && symbols_ != nullptr && names_ != nullptr &&
           std::strcmp(names_ + symbols_[symbol].st_name, name) == 0;
  }

  // Most places are sealed once the library is loaded, and are again after this.
  bool write(void** place, void* value) const {
    const auto address = reinterpret_cast<std::uintptr_t>(place);
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    auto* const start = pointerTo<void>(address / page * page);
    if (mprotect(start, page, PROT_READ | PROT_WRITE) != 0) {
      return false;
    }
    __atomic_store_n(place, value, __ATOMIC_RELEASE);
    const bool sealed = address >= sealed_begin_ && address < sealed_end_ / page * page;
    return !sealed || mprotect(start, page, PROT_READ) == 0;
  }

  const std::uintptr_t base_;
  std::uintptr_t sealed_begin_ = 0;
  std::uintptr_t sealed_end_ = 0;
  bool has_addends_ = true;
  const ElfW(Sym) * symbols_ = nullptr;
  const char* names_ = nullptr;
  Table data_;   // among them the tables of virtual functions
  Table calls_;  // one for each function of others that is called
};

}  // namespace

std::vector<std::string> replaceFunctions(const std::vector<ReplacedFunction>& functions) {
  struct Search {
    std::vector<ReplacedFunction> functions;
    std::vector<bool> found;
  } search{functions, std::vector<bool>(functions.size(), false)};
  for (const ReplacedFunction& function : functions) {
    *function.original = dlsym(RTLD_DEFAULT, function.symbol);
  }
  const auto visit = [](dl_phdr_info* info, std::size_t /*size*/, void* data) {
    auto& all = *static_cast<Search*>(data);
    const Library library(*info);
    for (std::size_t i = 0; i < all.functions.size(); ++i) {
      all.found[i] = (*all.functions[i].original != nullptr && library.replace(all.functions[i])) || all.found[i];
    }
    return 0;
  };
  dl_iterate_phdr(visit, &search);
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (!search.found[i]) {
      missing.emplace_back(functions[i].symbol);
    }
  }
  return missing;
}

}  // namespace rubber_suspension::roscpp_fixes
