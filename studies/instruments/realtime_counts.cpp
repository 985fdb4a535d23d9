// Executed operations of an exported CUDA library, counted on a CPU by numbers that count; `studies/speed/realtime.py` builds it.
#include <set>

struct Counts { unsigned long long simple, divisions, roots, loads; std::set<unsigned long> sectors; };
static Counts counts;

struct Counted
{
    float v;
    Counted() = default;
    template <typename T> Counted(T value) : v(static_cast<float>(value)) {}
    explicit operator int() const { return static_cast<int>(v); }
    explicit operator unsigned int() const { return static_cast<unsigned int>(v); }
};
static inline Counted counted(float v, unsigned long long& kind)
{
    kind++;
    return Counted(v);
}
#define BINARY(OP, KIND)                                                                                               \
    static inline Counted operator OP(Counted a, Counted b) { return counted(a.v OP b.v, counts.KIND); }
BINARY(+, simple)
BINARY(-, simple)
BINARY(*, simple)
BINARY(/, divisions)
#define COMPARE(OP)                                                                                                    \
    static inline bool operator OP(Counted a, Counted b)                                                               \
    {                                                                                                                  \
        counts.simple++;                                                                                               \
        return a.v OP b.v;                                                                                             \
    }
COMPARE(<)
COMPARE(>)
COMPARE(<=)
COMPARE(>=)
COMPARE(==)
COMPARE(!=)
static inline Counted operator-(Counted a) { return Counted(-a.v); }

#define CLOTH_REAL Counted
#define CLOTH_OWN_REALS
#define CLOTH_OWN_LOADS
// Words of tables, and elements of networks and their texels: four words each.
static const char *words_begin, *words_end, *numbers_begin, *numbers_end;
template <typename T> static inline T __ldg(const T* address)
{
    // Records of fabrics and families are the same for all pixels: they stay in registers or caches.
    const char* place = reinterpret_cast<const char*>(address);
    if ((place >= words_begin && place < words_end) || (place >= numbers_begin && place < numbers_end))
    {
        counts.loads += sizeof(T) / 4;
        counts.sectors.insert(reinterpret_cast<unsigned long>(address) / 32);
    }
    return *address;
}
#include "cloth_prelude.h"
static inline Counted F32_abs(Counted a) { return counted(fabsf(a.v), counts.simple); }
static inline Counted F32_floor(Counted a) { return counted(floorf(a.v), counts.simple); }
static inline Counted F32_ceil(Counted a) { return counted(ceilf(a.v), counts.simple); }
static inline Counted F32_frac(Counted a)
{
    counts.simple++; // floor and difference
    return counted(a.v - floorf(a.v), counts.simple);
}
static inline Counted F32_round(Counted a) { return counted(rintf(a.v), counts.simple); }
static inline Counted F32_max(Counted a, Counted b) { return counted(fmaxf(a.v, b.v), counts.simple); }
static inline Counted F32_min(Counted a, Counted b) { return counted(fminf(a.v, b.v), counts.simple); }
static inline Counted F32_sqrt(Counted a) { return counted(sqrtf(a.v), counts.roots); }
static inline Counted F32_rsqrt(Counted a) { return counted(1.0f / sqrtf(a.v), counts.roots); }
static inline Counted F32_fma(Counted a, Counted b, Counted c)
{
    counts.simple++; // and one more: a fused multiply-add is two operations
    return counted(fmaf(a.v, b.v, c.v), counts.simple);
}
static inline unsigned int F32_asuint(Counted a)
{
    unsigned int bits;
    memcpy(&bits, &a.v, 4);
    return bits;
}
static inline Counted U32_asfloat(unsigned int a)
{
    float number;
    memcpy(&number, &a, 4);
    return Counted(number);
}
#define float Counted
#include "cloth.cu"
#undef float

// Of a library with `cloth_estimate` either function is counted.
#ifdef CLOTH_ESTIMATE
#define CLOTH_FUNCTION cloth_estimate
#define CLOTH_SEED , queries[14 * i + 13]
#else
#define CLOTH_FUNCTION cloth_value
#define CLOTH_SEED
#endif

/// Answers [count, 4] to queries [count, 14], and totals: simple operations, divisions, roots, loads of words, and 32-byte
/// sectors of words, each once for 64 queries one behind the other.
extern "C" void run(void* fabrics, void* families, unsigned int* words, unsigned long word_count, unsigned int* numbers,
                    unsigned long number_count, const unsigned int* queries, unsigned int count, float* answers,
                    unsigned long long* totals)
{
    cloth_buffers.fabrics.data = static_cast<Fabric_0*>(fabrics);
    cloth_buffers.families.data = static_cast<Family_0*>(families);
    cloth_buffers.words.data = words;
    cloth_buffers.packed_numbers.data = reinterpret_cast<uint4*>(numbers);
    words_begin = reinterpret_cast<const char*>(words);
    words_end = reinterpret_cast<const char*>(words + word_count);
    numbers_begin = reinterpret_cast<const char*>(numbers);
    numbers_end = reinterpret_cast<const char*>(numbers + number_count);
    counts.simple = counts.divisions = counts.roots = counts.loads = 0;
    unsigned long long sectors = 0;
    for (unsigned int i = 0; i < count; i++)
    {
        float q[14];
        memcpy(q, queries + 14 * i, sizeof q);
        // Workgroups of 64 pixels share what they fetch.
        if (i % 64 == 0)
        {
            sectors += counts.sectors.size();
            counts.sectors.clear();
        }
        float4 a = CLOTH_FUNCTION(queries[14 * i], make_float2(q[1], q[2]), make_float2(q[3], q[4]), make_float2(q[5], q[6]),
                               make_float3(q[7], q[8], q[9]), make_float3(q[10], q[11], q[12]) CLOTH_SEED);
        answers[4 * i] = a.x.v;
        answers[4 * i + 1] = a.y.v;
        answers[4 * i + 2] = a.z.v;
        answers[4 * i + 3] = a.w.v;
    }
    sectors += counts.sectors.size();
    const unsigned long long all[5] = {counts.simple, counts.divisions, counts.roots, counts.loads, sectors};
    memcpy(totals, all, sizeof all);
}
