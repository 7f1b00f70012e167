#include "FailingMemory.h"

#include <cstdlib>
#include <new>

namespace lodsmith::test {

std::atomic<long> allocationsLeft{-1};

} // namespace lodsmith::test

void* operator new(std::size_t size)
{
    std::atomic<long>& left = lodsmith::test::allocationsLeft;
    if (left.load() >= 0 && left.fetch_sub(1) == 0)
        throw std::bad_alloc();
    if (void* memory = std::malloc(size != 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
