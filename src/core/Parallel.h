#pragma once

#include <cstddef>
#include <functional>

namespace lodsmith {

/// Calls work(i) once for every i below `count`, on up to `threads` threads, of which the caller's is one. In which order and on
/// which thread is left open. What is thrown first comes out here, when all threads have stopped; the rest is then not begun.
/// Where the system has no further thread to give, fewer do it all.
void inParallel(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& work);

} // namespace lodsmith
