#include "solver/parallel/blas_memory.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace dpcontact
{
  void require_blas_memory()
  {
    constexpr std::size_t buffer = (std::size_t(128) << 20) + (std::size_t(1) << 16);
    void *volatile room          = std::malloc(buffer); // address space alone: nothing is written
    if (room == nullptr)
      throw std::bad_alloc();
    std::free(room);
  }
} // namespace dpcontact
