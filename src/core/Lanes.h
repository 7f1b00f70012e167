#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lodsmith {

/// One number in each of four poses. Plain loops: compilers make one instruction of each.
struct Lanes {
    static constexpr std::size_t kCount = 4;

    float v[kCount];

    template <class Operation>
    static Lanes of(Operation operation)
    {
        Lanes result;
        for (std::size_t i = 0; i < kCount; ++i)
            result.v[i] = operation(i);
        return result;
    }
    static Lanes all(float value)
    {
        return of([value](std::size_t) { return value; });
    }

    Lanes operator+(const Lanes& o) const
    {
        return of([&](std::size_t i) { return v[i] + o.v[i]; });
    }
    Lanes operator-(const Lanes& o) const
    {
        return of([&](std::size_t i) { return v[i] - o.v[i]; });
    }
    Lanes operator*(const Lanes& o) const
    {
        return of([&](std::size_t i) { return v[i] * o.v[i]; });
    }
    Lanes operator*(float factor) const
    {
        return of([&](std::size_t i) { return v[i] * factor; });
    }

    float& operator[](std::size_t i) { return v[i]; }
    float operator[](std::size_t i) const { return v[i]; }

    float sum() const { return (v[0] + v[1]) + (v[2] + v[3]); }
};

inline Lanes sqrt(const Lanes& a)
{
    return Lanes::of([&](std::size_t i) { return std::sqrt(a.v[i]); });
}

/// A direction in each of four poses.
struct Lanes3 {
    Lanes x, y, z;

    Lanes3 operator+(const Lanes3& o) const { return {x + o.x, y + o.y, z + o.z}; }
    Lanes3 operator-(const Lanes3& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Lanes3 operator*(const Lanes& s) const { return {x * s, y * s, z * s}; }
};

inline Lanes dot(const Lanes3& a, const Lanes3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Lanes3 cross(const Lanes3& a, const Lanes3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace lodsmith
