#pragma pack_matrix(column_major)
#ifdef SLANG_HLSL_ENABLE_NVAPI
#include "nvHLSLExtns.h"
#endif

#ifndef __DXC_VERSION_MAJOR
// warning X3557: loop doesn't seem to do anything, forcing loop to unroll
#pragma warning(disable : 3557)
#endif

struct Frame_0
{
    uint width_0;
    uint height_0;
    uint lights_0;
    uint samples_0;
    uint pass_number_0;
    uint environment_samples_0;
    uint environment_columns_0;
    uint environment_rows_0;
    uint environment_table_0;
    float environment_total_0;
    float environment_sine_0;
    float environment_cosine_0;
    uint shows_environment_0;
    uint casts_shadows_0;
    uint leaves_0;
    uint leaf_faces_0;
    float ray_offset_0;
    float jitter_x_0;
    float jitter_y_0;
    float gain_0;
    float origin_x_0;
    float origin_y_0;
    float origin_z_0;
    float right_x_0;
    float right_y_0;
    float right_z_0;
    float up_x_0;
    float up_y_0;
    float up_z_0;
    float forward_x_0;
    float forward_y_0;
    float forward_z_0;
    float near_0;
    float background_red_0;
    float background_green_0;
    float background_blue_0;
};

StructuredBuffer<Frame_0 > frames_0 : register(t4);

struct Layer_0
{
    uint face_0;
    float share_0;
};

RWStructuredBuffer<Layer_0 > layers_0 : register(u2);

StructuredBuffer<uint > corners_0 : register(t6);

struct Vertex_0
{
    float x_0;
    float y_0;
    float z_0;
    float normal_x_0;
    float normal_y_0;
    float normal_z_0;
    float u_0;
    float v_0;
};

StructuredBuffer<Vertex_0 > vertices_0 : register(t5);

StructuredBuffer<uint > scene_words_0 : register(t9);

StructuredBuffer<uint > face_fabrics_0 : register(t7);

struct Lobes_0
{
    uint is_baked_0;
    float inverse_base_size_0;
    float last_level_0;
    uint levels_0;
    uint face_nodes_0;
    uint packs_0;
    uint front_warp_packs_0;
    uint back_warp_packs_0;
    uint coverage_0;
    uint coverage_holes_0;
    uint projected_area_0;
    uint light_visibility_0;
    uint irradiance_0;
    uint moments_0;
    float front_hole_weight_0;
    float back_hole_weight_0;
    float threads_per_mm_0;
    float unit_level_0;
};

struct Woven_0
{
    uint is_encoded_0;
    uint network_0;
    uint latents_0;
    uint texels_0;
    uint levels_1;
    uint top_level_0;
    float ends_0;
    float picks_0;
    float ends_per_mm_0;
    float picks_per_mm_0;
    float pitch_0;
    float warp_x_0;
    float warp_y_0;
    float warp_roughness_0;
    float weft_x_0;
    float weft_y_0;
    float weft_roughness_0;
    float warp_lobe_roughness_0;
    float weft_lobe_roughness_0;
    uint bundles_0;
    uint is_corrected_0;
    uint correction_0;
};

struct Neumip_0
{
    uint is_trained_0;
    uint decoder_0;
    uint has_offset_0;
    uint offset_0;
    uint offset_texels_0;
    uint features_0;
    uint texel_elements_0;
    uint levels_2;
    float last_level_1;
    uint face_texels_0;
    uint back_0;
    float repeats_per_x_0;
    float repeats_per_y_0;
    float texels_per_mm_0;
    float unit_x_0;
    float unit_y_0;
};

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Woven_0 woven_0;
    Neumip_0 neumip_0;
    uint run_words_0;
    uint ends_1;
    uint max_heights_0;
    uint max_height_columns_0;
    float height_low_0;
    float height_high_0;
    float lift_0;
    float threads_per_x_0;
    float threads_per_y_0;
    float per_relief_0;
    float diffuse_blend_0;
    float optical_depth_0;
    float sheen_strength_0;
    float sheen_roughness_0;
    float fibre_noise_0;
    float colour_noise_0;
    uint seed_0;
    float layer_bound_0;
    float fibre_size_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
};

StructuredBuffer<Fabric_0 > fabrics_0 : register(t0);

float3 position_of_0(Vertex_0 vertex_0)
{
    return float3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float inverse_of_0(float component_0)
{
    float _S1;
    if((abs(component_0)) > 9.99999968265522539e-21f)
    {
        _S1 = component_0;
    }
    else
    {
        _S1 = 9.99999968265522539e-21f;
    }
    return 1.0f / _S1;
}

float scene_number_0(uint index_0)
{
    return asfloat(scene_words_0.Load(index_0));
}

bool meets_node_0(uint node_0, float3 origin_0, float3 inverse_0, float nearest_0, float farthest_0)
{
    uint _S2 = 6U * (node_0 - 1U);
    float3 _S3 = (float3(scene_number_0(_S2), scene_number_0(_S2 + 1U), scene_number_0(_S2 + 2U)) - origin_0) * inverse_0;
    float3 _S4 = (float3(scene_number_0(_S2 + 3U), scene_number_0(_S2 + 4U), scene_number_0(_S2 + 5U)) - origin_0) * inverse_0;
    float3 _S5 = min(_S3, _S4);
    float3 _S6 = max(_S3, _S4) * 1.0000004768371582f;
    return (max(max(_S5.x, _S5.y), max(_S5.z, nearest_0))) <= (min(min(_S6.x, _S6.y), min(_S6.z, farthest_0)));
}

uint following_node_0(uint node_1)
{
    uint _S7 = node_1 + 1U;
    uint _S8 = _S7 >> (firstbitlow(_S7));
    uint _S9;
    if(_S8 == 1U)
    {
        _S9 = 0U;
    }
    else
    {
        _S9 = _S8;
    }
    return _S9;
}

struct Hit_0
{
    uint face_1;
    float distance_0;
    float weight_b_0;
    float weight_c_0;
};

Hit_0 meet_face_0(uint face_2, float3 origin_1, float3 direction_0)
{
    uint _S10 = 3U * face_2;
    float3 _S11 = position_of_0(vertices_0.Load(corners_0.Load(_S10)));
    float3 _S12 = position_of_0(vertices_0.Load(corners_0.Load(_S10 + 1U))) - _S11;
    float3 _S13 = position_of_0(vertices_0.Load(corners_0.Load(_S10 + 2U))) - _S11;
    float3 _S14 = cross(direction_0, _S13);
    float _S15 = dot(_S12, _S14);
    bool _S16 = (abs(_S15)) > 1.00000000317107685e-30f;
    float _S17;
    if(_S16)
    {
        _S17 = _S15;
    }
    else
    {
        _S17 = 1.00000000317107685e-30f;
    }
    float _S18 = 1.0f / _S17;
    float3 _S19 = origin_1 - _S11;
    float3 _S20 = cross(_S19, _S12);
    Hit_0 hit_0;
    float _S21 = dot(_S19, _S14) * _S18;
    hit_0.weight_b_0 = _S21;
    hit_0.weight_c_0 = dot(direction_0, _S20) * _S18;
    hit_0.distance_0 = dot(_S13, _S20) * _S18;
    bool _S22;
    if(_S21 >= 0.0f)
    {
        _S22 = (hit_0.weight_c_0) >= 0.0f;
    }
    else
    {
        _S22 = false;
    }
    if(_S22)
    {
        _S22 = (hit_0.weight_b_0 + hit_0.weight_c_0) <= 1.0f;
    }
    else
    {
        _S22 = false;
    }
    if(_S22)
    {
        _S22 = _S16;
    }
    else
    {
        _S22 = false;
    }
    uint _S23;
    if(_S22)
    {
        _S23 = face_2;
    }
    else
    {
        _S23 = 4294967295U;
    }
    hit_0.face_1 = _S23;
    return hit_0;
}

float3 camera_origin_0(int _S24)
{
    return float3(frames_0[_S24].origin_x_0, frames_0[_S24].origin_y_0, frames_0[_S24].origin_z_0);
}

float3 camera_forward_0(int _S25)
{
    return float3(frames_0[_S25].forward_x_0, frames_0[_S25].forward_y_0, frames_0[_S25].forward_z_0);
}

float3 camera_right_0(int _S26)
{
    return float3(frames_0[_S26].right_x_0, frames_0[_S26].right_y_0, frames_0[_S26].right_z_0);
}

float3 camera_up_0(int _S27)
{
    return float3(frames_0[_S27].up_x_0, frames_0[_S27].up_y_0, frames_0[_S27].up_z_0);
}

float3 pixel_direction_0(int _S28, uint2 _S29, float2 _S30)
{
    return camera_forward_0(_S28) + ((float(_S29.x) + 0.5f + _S30.x) * 2.0f / float(frames_0[_S28].width_0) - 1.0f) * camera_right_0(_S28) + (1.0f - (float(_S29.y) + 0.5f + _S30.y) * 2.0f / float(frames_0[_S28].height_0)) * camera_up_0(_S28);
}

Hit_0 nearest_hit_0(int _S31, float3 _S32, float3 _S33, float _S34, float _S35, uint _S36, bool _S37)
{
    float3 _S38 = float3(inverse_of_0(_S33.x), inverse_of_0(_S33.y), inverse_of_0(_S33.z));
    Hit_0 found_0;
    found_0.face_1 = 4294967295U;
    found_0.distance_0 = _S35;
    found_0.weight_b_0 = 0.0f;
    found_0.weight_c_0 = 0.0f;
    uint node_2 = 1U;
    for(;;)
    {
        if(node_2 != 0U)
        {
        }
        else
        {
            break;
        }
        uint node_3;
        if(!meets_node_0(node_2, _S32, _S38, _S34, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            uint _S39 = frames_0[_S31].leaves_0;
            if(node_2 < (frames_0[_S31].leaves_0))
            {
                node_3 = node_2 * 2U;
            }
            else
            {
                uint _S40 = frames_0[_S31].leaf_faces_0 + 4U * (node_2 - _S39);
                uint _S41 = following_node_0(node_2);
                uint number_0 = 0U;
                node_3 = _S41;
                for(;;)
                {
                    if(number_0 < 4U)
                    {
                    }
                    else
                    {
                        break;
                    }
                    uint _S42 = scene_words_0.Load(_S40 + number_0);
                    bool _S43;
                    if(_S42 == 4294967295U)
                    {
                        _S43 = true;
                    }
                    else
                    {
                        _S43 = _S42 == _S36;
                    }
                    if(_S43)
                    {
                        number_0 = number_0 + 1U;
                        continue;
                    }
                    Hit_0 _S44 = meet_face_0(_S42, _S32, _S33);
                    bool _S45;
                    if((_S44.face_1) == 4294967295U)
                    {
                        _S45 = true;
                    }
                    else
                    {
                        _S45 = (_S44.distance_0) <= _S34;
                    }
                    bool _S46;
                    if(_S45)
                    {
                        _S46 = true;
                    }
                    else
                    {
                        _S46 = (_S44.distance_0) >= (found_0.distance_0);
                    }
                    if(_S46)
                    {
                        number_0 = number_0 + 1U;
                        continue;
                    }
                    found_0 = _S44;
                    bool _S47;
                    if(_S37)
                    {
                        _S47 = (fabrics_0[face_fabrics_0.Load(_S42)].is_open_0) == 0U;
                    }
                    else
                    {
                        _S47 = false;
                    }
                    uint node_4;
                    if(_S47)
                    {
                        node_4 = 0U;
                    }
                    else
                    {
                        node_4 = node_3;
                    }
                    node_3 = node_4;
                    number_0 = number_0 + 1U;
                }
            }
        }
        node_2 = node_3;
    }
    return found_0;
}

[numthreads(8, 8, 1)]
void next_layer(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S48 = frames_0[int(0)].width_0;
    bool _S49;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S49 = true;
    }
    else
    {
        _S49 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S49)
    {
        return;
    }
    uint _S50 = id_0.y * _S48 + id_0.x;
    Layer_0 _S51 = layers_0[_S50];
    if((layers_0[_S50].face_0) == 0U)
    {
        return;
    }
    uint following_0;
    if((_S51.share_0) > 0.00100000004749745f)
    {
        float3 _S52 = camera_origin_0(int(0));
        float3 _S53 = pixel_direction_0(int(0), id_0.xy, float2(frames_0[int(0)].jitter_x_0, frames_0[int(0)].jitter_y_0));
        uint _S54 = _S51.face_0 - 1U;
        uint _S55 = 3U * _S54;
        float3 _S56 = position_of_0(vertices_0.Load(corners_0.Load(_S55)));
        float3 _S57 = cross(position_of_0(vertices_0.Load(corners_0.Load(_S55 + 1U))) - _S56, position_of_0(vertices_0.Load(corners_0.Load(_S55 + 2U))) - _S56);
        float _S58 = dot(_S53, _S57);
        float _S59 = dot(_S56 - _S52, _S57);
        float _S60;
        if((abs(_S58)) > 1.00000000317107685e-30f)
        {
            _S60 = _S58;
        }
        else
        {
            _S60 = 1.00000000317107685e-30f;
        }
        Hit_0 _S61 = nearest_hit_0(int(0), _S52, _S53, _S59 / _S60 + frames_0[int(0)].ray_offset_0, 1.00000001504746622e+30f, _S54, false);
        if((_S61.face_1) == 4294967295U)
        {
            following_0 = 0U;
        }
        else
        {
            following_0 = _S61.face_1 + 1U;
        }
    }
    else
    {
        following_0 = 0U;
    }
    layers_0[_S50].face_0 = following_0;
    return;
}

