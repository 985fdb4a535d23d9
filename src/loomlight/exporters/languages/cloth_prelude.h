// What the CUDA library needs beside CUDA: vectors with operators, buffers, and intrinsics by Slang's names.
//
// Without nvcc (`__CUDACC__` undefined) the same text compiles as C++ on a CPU, which tests and tools use.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#ifdef __CUDACC__
#include <cuda_fp16.h>
#define CLOTH_INLINE __device__ __forceinline__
#else
#define CLOTH_INLINE inline
#define __device__
#define __constant__
#define __global__
#ifndef CLOTH_OWN_LOADS
template <typename T> inline T __ldg(const T* address) { return *address; }
#endif
#ifndef CLOTH_REAL
#define CLOTH_REAL float
#endif
#define CLOTH_VECTOR(NAME, T)                                                                                          \
    struct NAME##2 { T x, y; };                                                                                        \
    struct NAME##3 { T x, y, z; };                                                                                     \
    struct NAME##4 { T x, y, z, w; };
typedef unsigned int uint;
CLOTH_VECTOR(float, CLOTH_REAL)
CLOTH_VECTOR(int, int)
CLOTH_VECTOR(uint, uint)
#define CLOTH_MAKE(NAME, T)                                                                                            \
    inline NAME##2 make_##NAME##2(T x, T y) { return {x, y}; }                                                         \
    inline NAME##3 make_##NAME##3(T x, T y, T z) { return {x, y, z}; }                                                 \
    inline NAME##4 make_##NAME##4(T x, T y, T z, T w) { return {x, y, z, w}; }
CLOTH_MAKE(float, CLOTH_REAL)
CLOTH_MAKE(int, int)
CLOTH_MAKE(uint, uint)
#endif
#ifndef CLOTH_REAL
#define CLOTH_REAL float
#endif
#ifdef __CUDACC__
typedef unsigned int uint;
#else
// Half-precision numbers by their bits, as cuda_fp16.h has them.
struct cloth_half { unsigned short bits; };
inline cloth_half __ushort_as_half(unsigned short bits) { return {bits}; }
inline CLOTH_REAL __half2float(cloth_half number)
{
    const uint exponent = (number.bits >> 10) & 31u, mantissa = number.bits & 1023u;
    const float size = exponent ? std::ldexp(float(1024u + mantissa), int(exponent) - 25) : std::ldexp(float(mantissa), -24);
    return CLOTH_REAL(number.bits & 0x8000u ? -size : size);
}
#endif

template <typename T> struct StructuredBuffer
{
    T* data;
    size_t count;
    CLOTH_INLINE T& operator[](size_t index) const { return data[index]; }
};

template <typename T, int N> struct FixedArray
{
    T items[N];
    CLOTH_INLINE const T& operator[](size_t index) const { return items[index]; }
    CLOTH_INLINE T& operator[](size_t index) { return items[index]; }
};

#define CLOTH_SPLAT(NAME, T)                                                                                           \
    CLOTH_INLINE NAME##2 make_##NAME##2(T a) { return make_##NAME##2(a, a); }                                          \
    CLOTH_INLINE NAME##3 make_##NAME##3(T a) { return make_##NAME##3(a, a, a); }                                       \
    CLOTH_INLINE NAME##4 make_##NAME##4(T a) { return make_##NAME##4(a, a, a, a); }
CLOTH_SPLAT(float, CLOTH_REAL)
CLOTH_SPLAT(int, int)
CLOTH_SPLAT(uint, uint)

#define CLOTH_OPERATOR(NAME, OP)                                                                                       \
    CLOTH_INLINE NAME##2 operator OP(NAME##2 a, NAME##2 b) { return make_##NAME##2(a.x OP b.x, a.y OP b.y); }          \
    CLOTH_INLINE NAME##3 operator OP(NAME##3 a, NAME##3 b)                                                             \
    {                                                                                                                  \
        return make_##NAME##3(a.x OP b.x, a.y OP b.y, a.z OP b.z);                                                     \
    }                                                                                                                  \
    CLOTH_INLINE NAME##4 operator OP(NAME##4 a, NAME##4 b)                                                             \
    {                                                                                                                  \
        return make_##NAME##4(a.x OP b.x, a.y OP b.y, a.z OP b.z, a.w OP b.w);                                         \
    }
#define CLOTH_OPERATORS(NAME) CLOTH_OPERATOR(NAME, +) CLOTH_OPERATOR(NAME, -) CLOTH_OPERATOR(NAME, *) CLOTH_OPERATOR(NAME, /)
CLOTH_OPERATORS(float)
CLOTH_OPERATORS(int)
CLOTH_OPERATORS(uint)
CLOTH_OPERATOR(uint, >>)
CLOTH_OPERATOR(uint, <<)
CLOTH_OPERATOR(uint, &)
CLOTH_OPERATOR(uint, |)
CLOTH_OPERATOR(int, >>)
CLOTH_OPERATOR(int, <<)
CLOTH_OPERATOR(int, &)
CLOTH_OPERATOR(int, |)
CLOTH_INLINE float2 operator-(float2 a) { return make_float2(-a.x, -a.y); }
CLOTH_INLINE float3 operator-(float3 a) { return make_float3(-a.x, -a.y, -a.z); }
CLOTH_INLINE float4 operator-(float4 a) { return make_float4(-a.x, -a.y, -a.z, -a.w); }

// Components of a vector lie one behind the other.
template <typename V> CLOTH_INLINE auto _slang_vector_get_element(const V& vector, int index)
{
    return (&vector.x)[index];
}
template <typename V> CLOTH_INLINE auto* _slang_vector_get_element_ptr(V* vector, int index) { return &vector->x + index; }

template <typename A, typename B> CLOTH_INLINE auto _slang_select(bool condition, A yes, B no) { return condition ? yes : no; }
CLOTH_INLINE uint U32_min(uint a, uint b) { return a < b ? a : b; }
CLOTH_INLINE uint U32_max(uint a, uint b) { return a > b ? a : b; }
CLOTH_INLINE int I32_min(int a, int b) { return a < b ? a : b; }
CLOTH_INLINE int I32_max(int a, int b) { return a > b ? a : b; }
#ifndef CLOTH_OWN_REALS
CLOTH_INLINE float F32_abs(float a) { return fabsf(a); }
CLOTH_INLINE float F32_floor(float a) { return floorf(a); }
CLOTH_INLINE float F32_ceil(float a) { return ceilf(a); }
CLOTH_INLINE float F32_frac(float a) { return a - floorf(a); }
CLOTH_INLINE float F32_round(float a) { return rintf(a); }
CLOTH_INLINE float F32_fma(float a, float b, float c) { return fmaf(a, b, c); }
CLOTH_INLINE float F32_max(float a, float b) { return fmaxf(a, b); }
CLOTH_INLINE float F32_min(float a, float b) { return fminf(a, b); }
CLOTH_INLINE float F32_sqrt(float a) { return sqrtf(a); }
CLOTH_INLINE float F32_rsqrt(float a) { return 1.0f / sqrtf(a); }
CLOTH_INLINE uint F32_asuint(float a)
{
    uint bits;
    memcpy(&bits, &a, 4);
    return bits;
}
CLOTH_INLINE float U32_asfloat(uint a)
{
    float number;
    memcpy(&number, &a, 4);
    return number;
}
#endif
