#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
struct pixelOutput_0
{
    uint output_0 [[color(0)]];
};

struct pixelInput_0
{
    [[flat]] uint face_0 [[user(FACE)]];
};

[[fragment]] pixelOutput_0 raster_fragment(pixelInput_0 _S1 [[stage_in]], float4 position_0 [[position]])
{
    pixelOutput_0 _S2 = { _S1.face_0 + 1U };
    return _S2;
}

