#pragma pack_matrix(column_major)
#ifdef SLANG_HLSL_ENABLE_NVAPI
#include "nvHLSLExtns.h"
#endif

#ifndef __DXC_VERSION_MAJOR
// warning X3557: loop doesn't seem to do anything, forcing loop to unroll
#pragma warning(disable : 3557)
#endif

struct RasterOutput_0
{
    float4 position_0 : SV_Position;
    nointerpolation uint face_0 : FACE;
};

uint raster_fragment(RasterOutput_0 input_0) : SV_TARGET
{
    return input_0.face_0 + 1U;
}

