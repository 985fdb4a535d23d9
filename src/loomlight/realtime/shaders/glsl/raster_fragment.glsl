#version 450
layout(row_major) uniform;
layout(row_major) buffer;
layout(location = 0)
out uint entryPointParam_raster_fragment_0;

flat layout(location = 0)
in uint input_face_0;

void main()
{
    entryPointParam_raster_fragment_0 = input_face_0 + 1U;
    return;
}

