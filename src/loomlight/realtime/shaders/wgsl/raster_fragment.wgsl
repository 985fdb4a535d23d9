struct pixelOutput_0
{
    @location(0) output_0 : u32,
};

struct pixelInput_0
{
    @interpolate(flat) @location(0) face_0 : u32,
};

@fragment
fn raster_fragment( _S1 : pixelInput_0, @builtin(position) position_0 : vec4<f32>) -> pixelOutput_0
{
    var _S2 : pixelOutput_0 = pixelOutput_0( _S1.face_0 + u32(1) );
    return _S2;
}

