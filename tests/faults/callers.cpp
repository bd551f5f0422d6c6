// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/callers.h"

#include <link.h>
#include <unwind.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace foldless::test {
namespace {

/// Where the code of something lies.
struct Code {
  std::uintptr_t begin = 0, end = 0;

  bool has(std::uintptr_t address) const { return begin <= address && address < end; }
};

Code code_of(const dl_phdr_info& object) {
  Code code{UINTPTR_MAX, 0};
  for (int i = 0; i < object.dlpi_phnum; ++i) {
    const auto& segment = object.dlpi_phdr[i];
    if (segment.p_type != PT_LOAD) continue;
    const std::uintptr_t begin = object.dlpi_addr + segment.p_vaddr;
    code.begin = std::min(code.begin, begin);
    code.end = std::max(code.end, begin + segment.p_memsz);
  }
  return code;
}

/// What there is before the program begins: itself and the libraries that it is linked to.
struct Objects {
  Code standard_library, here;
  std::array<Code, 64> others;
  std::size_t count = 0;

  Objects() {
    dl_iterate_phdr(
        [](dl_phdr_info* object, size_t, void* result) {
          auto& objects = *static_cast<Objects*>(result);
          const Code code = code_of(*object);
          if (code.has(reinterpret_cast<std::uintptr_t>(&code_of)))
            objects.here = code;
          else if (std::string_view(object->dlpi_name).find("/libstdc++.so") !=
                   std::string_view::npos)
            objects.standard_library = code;
          else if (objects.count < objects.others.size())
            objects.others[objects.count++] = code;
          return 0;
        },
        this);
  }
};

const Objects& objects() {
  static const Objects the_objects;
  return the_objects;
}

/// Of the calls that led here; the outermost of a deep recursion are left out. Never 0.
std::uint64_t hash_of_callers() {
  struct Callers {
    std::uint64_t hash = 1;
    int left = 40;
  } callers;
  _Unwind_Backtrace(
      [](_Unwind_Context* frame, void* result) {
        auto& known = *static_cast<Callers*>(result);
        known.hash = (known.hash ^ _Unwind_GetIP(frame)) * 0x100000001b3;
        return --known.left > 0 ? _URC_NO_REASON : _URC_END_OF_STACK;
      },
      &callers);
  return callers.hash | 1;
}

}  // namespace

void find_objects() { objects(); }

bool is_asked_by_program() {
  bool is = false;
  _Unwind_Backtrace(
      [](_Unwind_Context* frame, void* result) {
        const std::uintptr_t address = _Unwind_GetIP(frame);
        const Objects& all = objects();
        if (all.here.has(address) || all.standard_library.has(address)) return _URC_NO_REASON;
        *static_cast<bool*>(result) =
            std::any_of(all.others.begin(), all.others.begin() + all.count,
                        [=](const Code& code) { return code.has(address); });
        return _URC_END_OF_STACK;
      },
      &is);
  return is;
}

bool is_new_place() {
  static std::array<std::atomic<std::uint64_t>, 1 << 18> places;
  const std::uint64_t place = hash_of_callers();
  for (std::uint64_t i = place >> 32;; ++i) {
    std::uint64_t known = 0;
    if (places[i % places.size()].compare_exchange_strong(known, place)) return true;
    if (known == place) return false;
  }
}

}  // namespace foldless::test
