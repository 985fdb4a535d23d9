#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
uint firstbitlow_0(uint value_0)
{
    uint _S1;
    if(value_0 == 0U)
    {
        _S1 = 4294967295U;
    }
    else
    {
        uint _S2 = ctz(value_0);
        _S1 = _S2;
    }
    return _S1;
}

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

float3 position_of_0(const Vertex_0 thread* vertex_0)
{
    return float3(vertex_0->x_0, vertex_0->y_0, vertex_0->z_0);
}

float inverse_of_0(float component_0)
{
    float _S3;
    if((abs(component_0)) > 9.99999968265522539e-21f)
    {
        _S3 = component_0;
    }
    else
    {
        _S3 = 9.99999968265522539e-21f;
    }
    return 1.0f / _S3;
}

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

struct Layer_0
{
    uint face_0;
    float share_0;
};

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

struct KernelContext_0
{
    Frame_0 device* frames_0;
    Layer_0 device* layers_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
    uint device* scene_words_0;
    uint device* face_fabrics_0;
    Fabric_0 device* fabrics_0;
};

float scene_number_0(uint index_0, KernelContext_0 thread* kernelContext_0)
{
    return (as_type<float>((kernelContext_0->scene_words_0[index_0])));
}

bool meets_node_0(uint node_0, float3 origin_0, float3 inverse_0, float nearest_0, float farthest_0, KernelContext_0 thread* kernelContext_1)
{
    uint _S4 = 6U * (node_0 - 1U);
    float _S5 = scene_number_0(_S4, kernelContext_1);
    float _S6 = scene_number_0(_S4 + 1U, kernelContext_1);
    float _S7 = scene_number_0(_S4 + 2U, kernelContext_1);
    float3 _S8 = float3(_S5, _S6, _S7);
    float _S9 = scene_number_0(_S4 + 3U, kernelContext_1);
    float _S10 = scene_number_0(_S4 + 4U, kernelContext_1);
    float _S11 = scene_number_0(_S4 + 5U, kernelContext_1);
    float3 _S12 = (_S8 - origin_0) * inverse_0;
    float3 _S13 = (float3(_S9, _S10, _S11) - origin_0) * inverse_0;
    float3 _S14 = min(_S12, _S13);
    float3 _S15 = max(_S12, _S13) * float3(1.0000004768371582f) ;
    return (max(max(_S14.x, _S14.y), max(_S14.z, nearest_0))) <= (min(min(_S15.x, _S15.y), min(_S15.z, farthest_0)));
}

uint following_node_0(uint node_1)
{
    uint _S16 = node_1 + 1U;
    uint _S17 = _S16 >> (firstbitlow_0(_S16));
    uint _S18;
    if(_S17 == 1U)
    {
        _S18 = 0U;
    }
    else
    {
        _S18 = _S17;
    }
    return _S18;
}

struct Hit_0
{
    uint face_1;
    float distance_0;
    float weight_b_0;
    float weight_c_0;
};

Hit_0 meet_face_0(uint face_2, float3 origin_1, float3 direction_0, KernelContext_0 thread* kernelContext_2)
{
    uint _S19 = 3U * face_2;
    thread Vertex_0 _S20 = kernelContext_2->vertices_0[kernelContext_2->corners_0[_S19]];
    float3 _S21 = position_of_0(&_S20);
    thread Vertex_0 _S22 = kernelContext_2->vertices_0[kernelContext_2->corners_0[_S19 + 1U]];
    float3 _S23 = position_of_0(&_S22);
    float3 _S24 = _S23 - _S21;
    thread Vertex_0 _S25 = kernelContext_2->vertices_0[kernelContext_2->corners_0[_S19 + 2U]];
    float3 _S26 = position_of_0(&_S25);
    float3 _S27 = _S26 - _S21;
    float3 _S28 = cross(direction_0, _S27);
    float _S29 = dot(_S24, _S28);
    bool _S30 = (abs(_S29)) > 1.00000000317107685e-30f;
    float _S31;
    if(_S30)
    {
        _S31 = _S29;
    }
    else
    {
        _S31 = 1.00000000317107685e-30f;
    }
    float _S32 = 1.0f / _S31;
    float3 _S33 = origin_1 - _S21;
    float3 _S34 = cross(_S33, _S24);
    thread Hit_0 hit_0;
    float _S35 = dot(_S33, _S28) * _S32;
    (&hit_0)->weight_b_0 = _S35;
    (&hit_0)->weight_c_0 = dot(direction_0, _S34) * _S32;
    (&hit_0)->distance_0 = dot(_S27, _S34) * _S32;
    bool _S36;
    if(_S35 >= 0.0f)
    {
        _S36 = ((&hit_0)->weight_c_0) >= 0.0f;
    }
    else
    {
        _S36 = false;
    }
    if(_S36)
    {
        _S36 = ((&hit_0)->weight_b_0 + (&hit_0)->weight_c_0) <= 1.0f;
    }
    else
    {
        _S36 = false;
    }
    if(_S36)
    {
        _S36 = _S30;
    }
    else
    {
        _S36 = false;
    }
    uint _S37;
    if(_S36)
    {
        _S37 = face_2;
    }
    else
    {
        _S37 = 4294967295U;
    }
    (&hit_0)->face_1 = _S37;
    return hit_0;
}

float3 camera_origin_0(int _S38, KernelContext_0 thread* kernelContext_3)
{
    Frame_0 device* _S39 = kernelContext_3->frames_0+_S38;
    return float3(_S39->origin_x_0, _S39->origin_y_0, _S39->origin_z_0);
}

float3 camera_forward_0(int _S40, KernelContext_0 thread* kernelContext_4)
{
    Frame_0 device* _S41 = kernelContext_4->frames_0+_S40;
    return float3(_S41->forward_x_0, _S41->forward_y_0, _S41->forward_z_0);
}

float3 camera_right_0(int _S42, KernelContext_0 thread* kernelContext_5)
{
    Frame_0 device* _S43 = kernelContext_5->frames_0+_S42;
    return float3(_S43->right_x_0, _S43->right_y_0, _S43->right_z_0);
}

float3 camera_up_0(int _S44, KernelContext_0 thread* kernelContext_6)
{
    Frame_0 device* _S45 = kernelContext_6->frames_0+_S44;
    return float3(_S45->up_x_0, _S45->up_y_0, _S45->up_z_0);
}

float3 pixel_direction_0(int _S46, uint2 _S47, float2 _S48, KernelContext_0 thread* kernelContext_7)
{
    Frame_0 device* _S49 = kernelContext_7->frames_0+_S46;
    float _S50 = (float(_S47.x) + 0.5f + _S48.x) * 2.0f / float(_S49->width_0) - 1.0f;
    float _S51 = 1.0f - (float(_S47.y) + 0.5f + _S48.y) * 2.0f / float(_S49->height_0);
    float3 _S52 = camera_forward_0(_S46, kernelContext_7);
    float3 _S53 = camera_right_0(_S46, kernelContext_7);
    float3 _S54 = _S52 + float3(_S50)  * _S53;
    float3 _S55 = camera_up_0(_S46, kernelContext_7);
    return _S54 + float3(_S51)  * _S55;
}

Hit_0 nearest_hit_0(int _S56, float3 _S57, float3 _S58, float _S59, float _S60, uint _S61, bool _S62, KernelContext_0 thread* kernelContext_8)
{
    Frame_0 device* _S63 = kernelContext_8->frames_0+_S56;
    float3 _S64 = float3(inverse_of_0(_S58.x), inverse_of_0(_S58.y), inverse_of_0(_S58.z));
    thread Hit_0 found_0;
    (&found_0)->face_1 = 4294967295U;
    (&found_0)->distance_0 = _S60;
    (&found_0)->weight_b_0 = 0.0f;
    (&found_0)->weight_c_0 = 0.0f;
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
        bool _S65 = meets_node_0(node_2, _S57, _S64, _S59, (&found_0)->distance_0, kernelContext_8);
        uint node_3;
        if(!_S65)
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            uint _S66 = _S63->leaves_0;
            if(node_2 < (_S63->leaves_0))
            {
                node_3 = node_2 * 2U;
            }
            else
            {
                uint _S67 = _S63->leaf_faces_0 + 4U * (node_2 - _S66);
                uint _S68 = following_node_0(node_2);
                uint number_0 = 0U;
                node_3 = _S68;
                for(;;)
                {
                    if(number_0 < 4U)
                    {
                    }
                    else
                    {
                        break;
                    }
                    uint _S69 = kernelContext_8->scene_words_0[_S67 + number_0];
                    bool _S70;
                    if(_S69 == 4294967295U)
                    {
                        _S70 = true;
                    }
                    else
                    {
                        _S70 = _S69 == _S61;
                    }
                    if(_S70)
                    {
                        number_0 = number_0 + 1U;
                        continue;
                    }
                    Hit_0 _S71 = meet_face_0(_S69, _S57, _S58, kernelContext_8);
                    bool _S72;
                    if((_S71.face_1) == 4294967295U)
                    {
                        _S72 = true;
                    }
                    else
                    {
                        _S72 = (_S71.distance_0) <= _S59;
                    }
                    bool _S73;
                    if(_S72)
                    {
                        _S73 = true;
                    }
                    else
                    {
                        _S73 = (_S71.distance_0) >= ((&found_0)->distance_0);
                    }
                    if(_S73)
                    {
                        number_0 = number_0 + 1U;
                        continue;
                    }
                    found_0 = _S71;
                    bool _S74;
                    if(_S62)
                    {
                        _S74 = ((kernelContext_8->fabrics_0+kernelContext_8->face_fabrics_0[_S69])->is_open_0) == 0U;
                    }
                    else
                    {
                        _S74 = false;
                    }
                    uint node_4;
                    if(_S74)
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

[[kernel]] void next_layer(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], uint device* scene_words_1 [[buffer(11)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]])
{
    thread KernelContext_0 kernelContext_9;
    (&kernelContext_9)->frames_0 = frames_1;
    (&kernelContext_9)->layers_0 = layers_1;
    (&kernelContext_9)->corners_0 = corners_1;
    (&kernelContext_9)->vertices_0 = vertices_1;
    (&kernelContext_9)->scene_words_0 = scene_words_1;
    (&kernelContext_9)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_9)->fabrics_0 = fabrics_1;
    Frame_0 device* _S75 = frames_1+int(0);
    uint _S76 = id_0.x;
    uint _S77 = _S75->width_0;
    bool _S78;
    if(_S76 >= (_S75->width_0))
    {
        _S78 = true;
    }
    else
    {
        _S78 = (id_0.y) >= (_S75->height_0);
    }
    if(_S78)
    {
        return;
    }
    uint _S79 = id_0.y * _S77 + _S76;
    Layer_0 device* _S80 = (&kernelContext_9)->layers_0+_S79;
    Layer_0 _S81 = *_S80;
    if(((*_S80).face_0) == 0U)
    {
        return;
    }
    uint following_0;
    if((_S81.share_0) > 0.00100000004749745f)
    {
        float3 _S82 = camera_origin_0(int(0), &kernelContext_9);
        float3 _S83 = pixel_direction_0(int(0), id_0.xy, float2(_S75->jitter_x_0, _S75->jitter_y_0), &kernelContext_9);
        uint _S84 = _S81.face_0 - 1U;
        uint _S85 = 3U * _S84;
        thread Vertex_0 _S86 = (&kernelContext_9)->vertices_0[(&kernelContext_9)->corners_0[_S85]];
        float3 _S87 = position_of_0(&_S86);
        thread Vertex_0 _S88 = (&kernelContext_9)->vertices_0[(&kernelContext_9)->corners_0[_S85 + 1U]];
        float3 _S89 = position_of_0(&_S88);
        thread Vertex_0 _S90 = (&kernelContext_9)->vertices_0[(&kernelContext_9)->corners_0[_S85 + 2U]];
        float3 _S91 = position_of_0(&_S90);
        float3 _S92 = cross(_S89 - _S87, _S91 - _S87);
        float _S93 = dot(_S83, _S92);
        float _S94 = dot(_S87 - _S82, _S92);
        float _S95;
        if((abs(_S93)) > 1.00000000317107685e-30f)
        {
            _S95 = _S93;
        }
        else
        {
            _S95 = 1.00000000317107685e-30f;
        }
        Hit_0 _S96 = nearest_hit_0(int(0), _S82, _S83, _S94 / _S95 + _S75->ray_offset_0, 1.00000001504746622e+30f, _S84, false, &kernelContext_9);
        if((_S96.face_1) == 4294967295U)
        {
            following_0 = 0U;
        }
        else
        {
            following_0 = _S96.face_1 + 1U;
        }
    }
    else
    {
        following_0 = 0U;
    }
    ((&kernelContext_9)->layers_0+_S79)->face_0 = following_0;
    return;
}

