#ifndef DPCONTACT_SOLVER_PARALLEL_BLAS_MEMORY_H
#define DPCONTACT_SOLVER_PARALLEL_BLAS_MEMORY_H

namespace dpcontact
{
  /// OpenBLAS takes a buffer of 128 MiB when it is first called, and where it gets none it asks
  /// again for ever. So whoever is about to call BLAS sees first that there is room for the buffer.
  /// @throws std::bad_alloc where there is not.
  void require_blas_memory();
} // namespace dpcontact

#endif
