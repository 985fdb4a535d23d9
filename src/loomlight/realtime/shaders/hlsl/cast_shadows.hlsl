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

RWStructuredBuffer<float > visibilities_0 : register(u3);

StructuredBuffer<uint > scene_words_0 : register(t9);

struct Light_0
{
    uint is_point_0;
    float x_1;
    float y_1;
    float z_1;
    float red_0;
    float green_0;
    float blue_0;
};

StructuredBuffer<Light_0 > lights_1 : register(t3);

struct Family_0
{
    uint is_alike_0;
    float count_0;
    float inverse_count_0;
    float half_inverse_count_0;
    float size_0;
    float inverse_size_0;
    float half_width_0;
    float start_0;
    float period_0;
    float inverse_period_0;
    float bins_0;
    uint first_thread_table_0;
    uint place_table_0;
    uint bend_table_0;
    float height_scale_0;
    float twist_sine_0;
    float twist_cosine_0;
    float level_0;
    float roughness_0;
    uint albedo_table_0;
    uint albedo_stride_0;
    uint before_0;
    float visible_total_0;
    float smallest_box_0;
    uint quantities_0;
    uint colour_mean_0;
    uint colour_axes_0;
    uint colour_threads_0;
    uint colour_areas_0;
    float area_unit_0;
    float crossing_area_0;
};

StructuredBuffer<Family_0 > families_0 : register(t1);

StructuredBuffer<uint > words_0 : register(t2);

static const float2  TAP_OFFSETS_0[int(9)] = { float2(-0.3333333432674408f, -0.3333333432674408f), float2(-0.3333333432674408f, 0.0f), float2(-0.3333333432674408f, 0.3333333432674408f), float2(0.0f, -0.3333333432674408f), float2(0.0f, 0.0f), float2(0.0f, 0.3333333432674408f), float2(0.3333333432674408f, -0.3333333432674408f), float2(0.3333333432674408f, 0.0f), float2(0.3333333432674408f, 0.3333333432674408f) };
static const float  PYRAMID_RADII_0[int(4)] = { 1.0f, 2.0f, 4.0f, 8.0f };
float3 position_of_0(Vertex_0 vertex_0)
{
    return float3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

float3 normal_of_0(Vertex_0 vertex_1)
{
    return float3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

uint scramble_0(uint value_0)
{
    uint _S1 = value_0 * 747796405U + 2891336453U;
    uint _S2 = ((_S1 >> ((_S1 >> int(28)) + 4U)) ^ _S1) * 277803737U;
    return (_S2 >> int(22)) ^ _S2;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_0, uint stream_1)
{
    uint _S3 = pixel_0.x;
    uint _S4 = pixel_0.y;
    return frac(float2(uniform_hash_0(_S3, _S4, stream_1), uniform_hash_0(_S3, _S4, stream_1 + 1U)) + float(index_0 & 65535U) * float2(0.75487768650054932f, 0.56984031200408936f));
}

float scene_number_0(uint index_1)
{
    return asfloat(scene_words_0.Load(index_1));
}

struct Choice_0
{
    uint index_2;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_1, float number_0)
{
    uint high_0 = count_1;
    uint low_0 = 0U;
    for(;;)
    {
        if((high_0 - low_0) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S5 = (low_0 + high_0) / 2U;
        if((scene_number_0(table_0 + _S5)) <= number_0)
        {
            low_0 = _S5;
        }
        else
        {
            high_0 = _S5;
        }
    }
    uint _S6 = table_0 + low_0;
    float _S7 = scene_number_0(_S6);
    float _S8 = scene_number_0(_S6 + 1U);
    Choice_0 choice_0;
    choice_0.index_2 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S7) / max(_S8 - _S7, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_2)
{
    float _S9 = floor(x_2 * 0.63661974668502808f + 0.5f);
    float _S10 = x_2 - _S9 * 1.5703125f - _S9 * 0.00048375129699707f - _S9 * 7.54979012640433211e-08f;
    float _S11 = _S10 * _S10;
    float _S12 = ((-0.00019515295571182f * _S11 + 0.00833216123282909f) * _S11 - 0.16666655242443085f) * _S11 * _S10 + _S10;
    float _S13 = ((0.00002443315679557f * _S11 - 0.00138873164542019f) * _S11 + 0.04166664555668831f) * _S11 * _S11 - 0.5f * _S11 + 1.0f;
    uint _S14 = uint(int(_S9)) & 3U;
    float2 _S15;
    if((_S14 & 1U) != 0U)
    {
        _S15 = float2(_S13, _S12);
    }
    else
    {
        _S15 = float2(_S12, _S13);
    }
    float _S16;
    if((_S14 & 2U) != 0U)
    {
        _S16 = - _S15.x;
    }
    else
    {
        _S16 = _S15.x;
    }
    float _S17;
    if(((_S14 + 1U) & 2U) != 0U)
    {
        _S17 = - _S15.y;
    }
    else
    {
        _S17 = _S15.y;
    }
    return float2(_S16, _S17);
}

float inverse_of_0(float component_0)
{
    float _S18;
    if((abs(component_0)) > 9.99999968265522539e-21f)
    {
        _S18 = component_0;
    }
    else
    {
        _S18 = 9.99999968265522539e-21f;
    }
    return 1.0f / _S18;
}

bool meets_node_0(uint node_0, float3 origin_0, float3 inverse_0, float nearest_0, float farthest_0)
{
    uint _S19 = 6U * (node_0 - 1U);
    float3 _S20 = (float3(scene_number_0(_S19), scene_number_0(_S19 + 1U), scene_number_0(_S19 + 2U)) - origin_0) * inverse_0;
    float3 _S21 = (float3(scene_number_0(_S19 + 3U), scene_number_0(_S19 + 4U), scene_number_0(_S19 + 5U)) - origin_0) * inverse_0;
    float3 _S22 = min(_S20, _S21);
    float3 _S23 = max(_S20, _S21) * 1.0000004768371582f;
    return (max(max(_S22.x, _S22.y), max(_S22.z, nearest_0))) <= (min(min(_S23.x, _S23.y), min(_S23.z, farthest_0)));
}

uint following_node_0(uint node_1)
{
    uint _S24 = node_1 + 1U;
    uint _S25 = _S24 >> (firstbitlow(_S24));
    uint _S26;
    if(_S25 == 1U)
    {
        _S26 = 0U;
    }
    else
    {
        _S26 = _S25;
    }
    return _S26;
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
    uint _S27 = 3U * face_2;
    float3 _S28 = position_of_0(vertices_0.Load(corners_0.Load(_S27)));
    float3 _S29 = position_of_0(vertices_0.Load(corners_0.Load(_S27 + 1U))) - _S28;
    float3 _S30 = position_of_0(vertices_0.Load(corners_0.Load(_S27 + 2U))) - _S28;
    float3 _S31 = cross(direction_0, _S30);
    float _S32 = dot(_S29, _S31);
    bool _S33 = (abs(_S32)) > 1.00000000317107685e-30f;
    float _S34;
    if(_S33)
    {
        _S34 = _S32;
    }
    else
    {
        _S34 = 1.00000000317107685e-30f;
    }
    float _S35 = 1.0f / _S34;
    float3 _S36 = origin_1 - _S28;
    float3 _S37 = cross(_S36, _S29);
    Hit_0 hit_0;
    float _S38 = dot(_S36, _S31) * _S35;
    hit_0.weight_b_0 = _S38;
    hit_0.weight_c_0 = dot(direction_0, _S37) * _S35;
    hit_0.distance_0 = dot(_S30, _S37) * _S35;
    bool _S39;
    if(_S38 >= 0.0f)
    {
        _S39 = (hit_0.weight_c_0) >= 0.0f;
    }
    else
    {
        _S39 = false;
    }
    if(_S39)
    {
        _S39 = (hit_0.weight_b_0 + hit_0.weight_c_0) <= 1.0f;
    }
    else
    {
        _S39 = false;
    }
    if(_S39)
    {
        _S39 = _S33;
    }
    else
    {
        _S39 = false;
    }
    uint _S40;
    if(_S39)
    {
        _S40 = face_2;
    }
    else
    {
        _S40 = 4294967295U;
    }
    hit_0.face_1 = _S40;
    return hit_0;
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_0;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(VisiblePoint_0 point_0, float3 direction_1)
{
    return float3(dot(direction_1, point_0.axis_x_0), dot(direction_1, point_0.axis_y_0), dot(direction_1, point_0.normal_0));
}

float3 to_face_frame_0(float3 direction_2, bool back_1)
{
    float2 _S41 = direction_2.xy;
    float _S42;
    if(back_1)
    {
        _S42 = - direction_2.z;
    }
    else
    {
        _S42 = direction_2.z;
    }
    return float3(_S41, _S42);
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float Footprint_spread_side_0(Footprint_0 this_0)
{
    float2 _S43 = this_0.dx_0;
    float2 _S44 = this_0.dy_0;
    return sqrt(0.5f * (dot(_S43, _S43) + dot(_S44, _S44)));
}

float natural_logarithm_0(float x_3)
{
    uint _S45 = asuint(x_3);
    float exponent_0 = float(int(_S45 >> int(23)) - int(126));
    float m_0 = asfloat((_S45 & 8388607U) | 1056964608U);
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042f)
    {
        float exponent_2 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0f;
    float _S46 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S46 - exponent_1 * 0.00021219444170129f - 0.5f * _S46) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 default_quality_0()
{
    SearchQuality_0 quality_0;
    quality_0.steps_per_thread_0 = 5.0f;
    quality_0.steps_per_relief_0 = 8.0f;
    quality_0.shadow_share_0 = 1.0f;
    quality_0.refinements_0 = 2U;
    return quality_0;
}

float2 turns_and_remainder_0(uint family_0, float index_3)
{
    float _S47 = floor(mad(index_3, families_0.Load(family_0).inverse_count_0, families_0.Load(family_0).half_inverse_count_0));
    return float2(_S47, mad(- _S47, families_0.Load(family_0).count_0, index_3));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1)
{
    float _S48 = floor(position_1 * families_0.Load(family_1).inverse_size_0);
    Cell_0 cell_1;
    float _S49 = mad(- _S48, families_0.Load(family_1).size_0, position_1);
    cell_1.below_0 = _S49;
    cell_1.above_0 = families_0.Load(family_1).size_0 - _S49;
    cell_1.across_0 = _S49 - 0.5f * families_0.Load(family_1).size_0;
    cell_1.half_width_1 = families_0.Load(family_1).half_width_0;
    cell_1.thread_1 = uint(clamp(turns_and_remainder_0(family_1, _S48).y, 0.0f, families_0.Load(family_1).count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_4)
{
    return asfloat(words_0.Load(index_4));
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0.Load(family_2).start_0) * families_0.Load(family_2).inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S50 = turns_1 * families_0.Load(family_2).period_0;
    uint thread_2 = words_0.Load(families_0.Load(family_2).first_thread_table_0 + uint(clamp(turns_1 * families_0.Load(family_2).bins_0, 0.0f, families_0.Load(family_2).bins_0 - 1.0f)));
    uint _S51;
    if(_S50 >= (table_number_0(families_0.Load(family_2).place_table_0 + thread_2 * 4U + 1U)))
    {
        _S51 = 1U;
    }
    else
    {
        _S51 = 0U;
    }
    uint _S52 = min(thread_2 + _S51, uint(families_0.Load(family_2).count_0) - 1U);
    uint _S53 = families_0.Load(family_2).place_table_0 + _S52 * 4U;
    Cell_0 cell_2;
    cell_2.thread_1 = _S52;
    cell_2.below_0 = _S50 - table_number_0(_S53);
    cell_2.above_0 = table_number_0(_S53 + 1U) - _S50;
    cell_2.across_0 = _S50 - table_number_0(_S53 + 2U);
    cell_2.half_width_1 = table_number_0(_S53 + 3U);
    return cell_2;
}

Cell_0 locate_0(uint family_3, float position_3)
{
    if((families_0.Load(family_3).is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Shown_0
{
    bool is_warp_0;
    bool hole_0;
    bool on_top_0;
    uint word_0;
};

struct Crossing_0
{
    Cell_0 warp_1;
    Cell_0 weft_1;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_2)
{
    bool _S54 = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    bool _S55 = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S56;
    if(_S54)
    {
        if(!_S55)
        {
            _S56 = true;
        }
        else
        {
            _S56 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S56 = false;
    }
    shown_0.is_warp_0 = _S56;
    if(!_S54)
    {
        _S56 = !_S55;
    }
    else
    {
        _S56 = false;
    }
    shown_0.hole_0 = _S56;
    uint _S57;
    if(shown_0.is_warp_0)
    {
        _S57 = crossing_0.warp_word_0;
    }
    else
    {
        _S57 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S57;
    shown_0.on_top_0 = ((_S57 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_3;
    uint _S58;
    if(is_first_0)
    {
        _S58 = first_0.thread_1;
    }
    else
    {
        _S58 = second_0.thread_1;
    }
    cell_3.thread_1 = _S58;
    float _S59;
    if(is_first_0)
    {
        _S59 = first_0.across_0;
    }
    else
    {
        _S59 = second_0.across_0;
    }
    cell_3.across_0 = _S59;
    if(is_first_0)
    {
        _S59 = first_0.half_width_1;
    }
    else
    {
        _S59 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S59;
    if(is_first_0)
    {
        _S59 = first_0.below_0;
    }
    else
    {
        _S59 = second_0.below_0;
    }
    cell_3.below_0 = _S59;
    if(is_first_0)
    {
        _S59 = first_0.above_0;
    }
    else
    {
        _S59 = second_0.above_0;
    }
    cell_3.above_0 = _S59;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0)
{
    float2 _S60 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0));
    return mad(_S60.x, families_0.Load(family_4).period_0, table_number_0(families_0.Load(family_4).place_table_0 + uint(_S60.y) * 4U));
}

float span_0(uint family_5, uint thread_4, int first_1, int last_0)
{
    if((families_0.Load(family_5).is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * families_0.Load(family_5).size_0;
    }
    return boundary_0(family_5, thread_4, last_0) - boundary_0(family_5, thread_4, first_1);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_5)
{
    Family_0 _S61 = families_0.Load(family_6);
    uint _S62;
    if((families_0.Load(family_6).is_alike_0) != 0U)
    {
        _S62 = 0U;
    }
    else
    {
        _S62 = thread_5 * 4U;
    }
    uint _S63 = _S61.bend_table_0 + _S62;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S63);
    bend_0.half_tangent_0 = table_number_0(_S63 + 1U);
    bend_0.arc_0 = table_number_0(_S63 + 2U);
    return bend_0;
}

struct Run_0
{
    float distance_1;
    bool near_start_0;
    float from_start_0;
    float to_end_0;
    float reach_0;
    float other_reach_0;
    Bend_0 bend_1;
    bool straight_0;
    bool first_crossing_0;
    bool last_crossing_0;
};

Run_0 unpack_0(uint own_0, uint other_0, uint thread_6, Cell_0 crossed_0, uint word_1)
{
    int _S64 = int((word_1 >> int(1)) & 127U);
    int _S65 = int((word_1 >> int(8)) & 127U);
    int _S66 = int((word_1 >> int(15)) & 63U);
    int _S67 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    int _S68 = - _S64;
    float _S69 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S68, int(0));
    run_0.from_start_0 = _S69;
    int _S70 = _S65 + int(1);
    float _S71 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, int(1), _S70);
    run_0.to_end_0 = _S71;
    bool _S72 = _S69 < _S71;
    run_0.near_start_0 = _S72;
    int _S73;
    if(_S72)
    {
        _S73 = _S68 - _S66;
    }
    else
    {
        _S73 = _S70;
    }
    int _S74;
    if(run_0.near_start_0)
    {
        _S74 = _S68;
    }
    else
    {
        _S74 = _S70 + _S67;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    float _S75;
    if(run_0.straight_0)
    {
        _S75 = 1.0e+06f;
    }
    else
    {
        _S75 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_1 = _S75;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S73, _S74), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S64 == int(0);
    run_0.last_crossing_0 = _S65 == int(0);
    return run_0;
}

float square_1(float x_5)
{
    return x_5 * x_5;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_4)
{
    float _S76 = cell_4.half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S77 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S77;
    float _S78 = _S76 * _S76 - square_1(_S77);
    float _S79 = rsqrt(_S78);
    section_0.drop_0 = _S76 - _S78 * _S79;
    section_0.slope_0 = - _S77 * _S79;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_7, int step_1)
{
    if((families_0.Load(family_7).is_alike_0) != 0U)
    {
        return table_number_0(families_0.Load(family_7).bend_table_0 + 3U);
    }
    return table_number_0(families_0.Load(family_7).bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_7) + step_1)).y) * 4U + 3U);
}

float2 dive_0(uint other_1, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
{
    bool _S80 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S81 = min(crossed_1.below_0, crossed_1.above_0);
    float _S82;
    if(_S80)
    {
        _S82 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S82 = crossed_1.above_0 + crossed_1.across_0;
    }
    float _S83 = _S82 - crossed_1.half_width_1;
    bool _S84;
    if(_S80)
    {
        _S84 = run_1.first_crossing_0;
    }
    else
    {
        _S84 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S82 = 0.0f;
    }
    else
    {
        _S82 = families_0.Load(other_1).height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, int(0));
    }
    float _S85;
    if((shown_1.on_top_0) != _S84)
    {
        _S85 = 0.0f;
    }
    else
    {
        Family_0 _S86 = families_0.Load(other_1);
        int _S87;
        if(_S80)
        {
            _S87 = int(-1);
        }
        else
        {
            _S87 = int(1);
        }
        _S85 = _S86.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S87);
    }
    float _S88 = 1.0f / max(2.0f * _S83, 9.999999960041972e-13f);
    float _S89 = clamp((_S83 - _S81) * _S88, 0.0f, 1.0f);
    float _S90 = _S82 + (_S85 - _S82) * (_S89 * _S89 * (3.0f - 2.0f * _S89));
    float _S91 = (_S82 - _S85) * (6.0f * _S89 * (1.0f - _S89) * _S88);
    if(_S80)
    {
        _S82 = 1.0f;
    }
    else
    {
        _S82 = -1.0f;
    }
    return float2(_S90, _S91 * _S82);
}

struct StepControl_0
{
    float step_2;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_0;
    bool up_0;
};

StepControl_0 step_control_0(float2 direction_3, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    float _S92 = direction_3.x;
    control_0.per_x_0 = 1.0f / max(abs(_S92), 9.99999971718068537e-10f);
    float _S93 = direction_3.y;
    control_0.per_y_0 = 1.0f / max(abs(_S93), 9.99999971718068537e-10f);
    control_0.right_0 = _S92 > 0.0f;
    control_0.up_0 = _S93 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_0;
    bool known_0;
};

PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_0 = 0U;
    previous_0.known_0 = false;
    return previous_0;
}

float outline_distance_0(Cell_0 cell_5, Shown_0 shown_2, Run_0 run_2, bool lengthwise_0, bool forwards_0)
{
    float _S94;
    if(forwards_0)
    {
        _S94 = cell_5.across_0;
    }
    else
    {
        _S94 = - cell_5.across_0;
    }
    float _S95;
    if(forwards_0)
    {
        _S95 = cell_5.above_0;
    }
    else
    {
        _S95 = cell_5.below_0;
    }
    bool _S96;
    if(forwards_0)
    {
        _S96 = run_2.last_crossing_0;
    }
    else
    {
        _S96 = run_2.first_crossing_0;
    }
    bool _S97;
    if(forwards_0)
    {
        _S97 = run_2.first_crossing_0;
    }
    else
    {
        _S97 = run_2.last_crossing_0;
    }
    float _S98 = - cell_5.half_width_1;
    bool _S99 = _S94 < _S98;
    bool _S100 = _S94 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S96 = !_S96;
    }
    else
    {
        _S96 = false;
    }
    if(_S96)
    {
        _S96 = !shown_2.hole_0;
    }
    else
    {
        _S96 = false;
    }
    bool _S101;
    if(_S96)
    {
        _S101 = shown_2.on_top_0;
    }
    else
    {
        _S101 = false;
    }
    if(_S101)
    {
        if(_S97)
        {
            _S97 = _S99;
        }
        else
        {
            _S97 = false;
        }
        _S97 = !_S97;
    }
    else
    {
        _S97 = false;
    }
    if(shown_2.hole_0)
    {
        _S96 = true;
    }
    else
    {
        if(_S96)
        {
            _S96 = !shown_2.on_top_0;
        }
        else
        {
            _S96 = false;
        }
    }
    float _S102;
    if(_S99)
    {
        _S102 = _S98;
    }
    else
    {
        _S102 = cell_5.half_width_1;
    }
    float _S103 = _S102 - _S94;
    if(_S96)
    {
        _S94 = 2.0f * _S95 + _S94 - cell_5.half_width_1;
    }
    else
    {
        _S94 = _S95;
    }
    if(_S97)
    {
        if(forwards_0)
        {
            _S94 = run_2.to_end_0;
        }
        else
        {
            _S94 = run_2.from_start_0;
        }
        return _S94;
    }
    if(_S100)
    {
    }
    else
    {
        _S94 = _S103;
    }
    return _S94;
}

struct Probe_0
{
    float height_1;
    bool hole_1;
    float slope_x_0;
    float slope_y_0;
    uint yarn_1;
    float cell_max_0;
    float side_x_0;
    float side_y_0;
    float edge_x_0;
    float edge_y_0;
};

float way_back_to_dip_0(PreviousSample_0 previous_1, float clearance_1, float rate_1, float step_4, Probe_0 here_0)
{
    float _S104 = previous_1.rate_0 * step_4;
    float _S105 = rate_1 * step_4;
    bool _S106;
    if(!previous_1.known_0)
    {
        _S106 = true;
    }
    else
    {
        _S106 = here_0.hole_1;
    }
    if(_S106)
    {
        _S106 = true;
    }
    else
    {
        _S106 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S106)
    {
        _S106 = true;
    }
    else
    {
        _S106 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S106)
    {
        _S106 = true;
    }
    else
    {
        _S106 = rate_1 <= 0.0f;
    }
    if(_S106)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S104) >= 0.0f)
    {
        _S106 = (3.0f * clearance_1 - _S105) >= 0.0f;
    }
    else
    {
        _S106 = false;
    }
    if(_S106)
    {
        return -1.0f;
    }
    float _S107 = clearance_1 - previous_1.clearance_0;
    float _S108 = 6.0f * _S107 - 4.0f * _S104 - 2.0f * _S105;
    float _S109 = -2.0f * _S104 / max(_S108 + sqrt(max(_S108 * _S108 - 4.0f * (3.0f * (_S104 + _S105 - 2.0f * _S107)) * _S104, 0.0f)), 9.99999968265522539e-21f);
    float _S110 = 1.0f - _S109;
    float _S111 = (previous_1.clearance_0 * (2.0f * _S109 + 1.0f) + _S104 * _S109) * _S110 * _S110;
    float _S112 = (clearance_1 * (2.0f * _S110 + 1.0f) - _S105 * _S110) * _S109 * _S109;
    if(_S109 > 0.01999999955296516f)
    {
        _S106 = _S110 > 0.01999999955296516f;
    }
    else
    {
        _S106 = false;
    }
    if(_S106)
    {
        _S106 = (_S111 + _S112) < 0.0f;
    }
    else
    {
        _S106 = false;
    }
    float _S113;
    if(_S106)
    {
        _S113 = _S110 * step_4;
    }
    else
    {
        _S113 = -1.0f;
    }
    return _S113;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S114;
    if(here_1.hole_1)
    {
        _S114 = 1.0e+09f;
    }
    else
    {
        _S114 = clearance_2;
    }
    previous_2.clearance_0 = _S114;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S115;
    if(!here_1.hole_1)
    {
        _S115 = !is_cell_exit_0;
    }
    else
    {
        _S115 = false;
    }
    previous_2.known_0 = _S115;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S116 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S117;
    if(!here_2.hole_1)
    {
        _S117 = (rate_3 * _S116 + clearance_3) < 0.0f;
    }
    else
    {
        _S117 = false;
    }
    if(_S117)
    {
        _S117 = _S116 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S117 = false;
    }
    float _S118;
    if(_S117)
    {
        _S118 = _S116 - this_2.epsilon_0;
    }
    else
    {
        _S118 = max(_S116, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S118);
}

struct ViewRay_0
{
    float2 origin_2;
    float2 slope_1;
};

float2 ViewRay_at_0(ViewRay_0 this_3, float height_2)
{
    return this_3.origin_2 + this_3.slope_1 * height_2;
}

float ViewRay_rate_0(ViewRay_0 this_4, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S119 = end_0 - start_1;
    float _S120 = start_rate_0 + end_rate_0 - 2.0f * _S119;
    float _S121 = 3.0f * _S119 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S119, 9.99999968265522539e-21f);
    int i_0 = int(0);
    for(;;)
    {
        if(uint(i_0) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S122 = clamp(share_1 - (((_S120 * share_1 + _S121) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S120 * share_1 + 2.0f * _S121) * share_1 + start_rate_0, 0.10000000149011612f * _S119 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S123 = i_0 + int(1);
        share_1 = _S122;
        i_0 = _S123;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float arc_tangent_quotient_0(float x_6, float y_2)
{
    return ((((((0.0f * x_6 + 0.00809729471802711f) * x_6 + -0.0377517081797123f) * x_6 + 0.08475969731807709f) * x_6 + -0.13537675142288208f) * x_6 + 0.19895026087760925f) * x_6 + -0.33327975869178772f) * x_6 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_3, float x_7)
{
    float _S124 = abs(x_7);
    float _S125 = abs(y_3);
    float angle_0 = arc_tangent_of_ratio_0(min(_S124, _S125) / max(max(_S124, _S125), 1.00000000317107685e-30f));
    float angle_1;
    if(_S125 > _S124)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_7 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_3 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
    uint4 nodes_0;
    uint4 weights_0;
    float inverse_sum_0;
};

NodeTaps_0 node_taps_0(float3 direction_4)
{
    float _S126 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S127 = floor(_S126);
    float _S128 = _S126 - _S127;
    float _S129 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S130 = 7.0f * _S129 * sqrt(_S129);
    float _S131 = min(floor(_S130), 6.0f);
    float _S132 = _S130 - _S131;
    uint _S133 = uint(int(_S127) + int(32)) % 32U;
    uint _S134 = uint(_S131);
    uint _S135 = _S133 * 8U + _S134;
    uint _S136 = (_S133 + 1U) % 32U * 8U + _S134;
    NodeTaps_0 taps_0;
    taps_0.nodes_0 = uint4(_S135, _S135 + 1U, _S136, _S136 + 1U);
    float _S137 = 1.0f - _S128;
    float _S138 = 1.0f - _S132;
    uint4 _S139 = uint4(float4(_S137 * _S138, _S137 * _S132, _S128 * _S138, _S128 * _S132) * 252.0f + 0.5f);
    taps_0.weights_0 = _S139;
    taps_0.inverse_sum_0 = 1.0f / float(_S139.x + _S139.y + _S139.z + _S139.w);
    return taps_0;
}

float wrapped_cell_0(float position_4, float count_2)
{
    return min(floor((position_4 - floor(position_4)) * count_2), count_2 - 1.0f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

float4 interpolate_0(NodeTaps_0 taps_1, uint4 packs_1)
{
    uint4 _S140 = (packs_1 & 16711935U) * taps_1.weights_0;
    uint4 _S141 = ((packs_1 >> int(8)) & 16711935U) * taps_1.weights_0;
    return bytes_of_sums_0(_S140.x + _S140.y + _S140.z + _S140.w, _S141.x + _S141.y + _S141.z + _S141.w) * taps_1.inverse_sum_0;
}

float4 interpolate_table_0(NodeTaps_0 taps_2, uint table_1, uint stride_0)
{
    uint4 _S142 = table_1 + taps_2.nodes_0 * stride_0;
    return interpolate_0(taps_2, uint4(words_0.Load(_S142.x), words_0.Load(_S142.y), words_0.Load(_S142.z), words_0.Load(_S142.w)));
}

float sheen_scale_0(float x_8, float y_4)
{
    return (((((0.0f * x_8 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_8 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_8 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_8 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_8 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_8 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

float sheen_shear_0(float x_9, float y_5)
{
    return ((((0.0f * x_9 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_9 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_9 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_9 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_9 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_10, float y_6)
{
    return ((((0.0f * x_10 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_10 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_10 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_10 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_10 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

float exponential_0(float x_11)
{
    float _S143 = clamp(x_11, -87.0f, 88.0f);
    float _S144 = floor(_S143 * 1.4426950216293335f + 0.5f);
    float _S145 = _S143 - _S144 * 0.693359375f + _S144 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S145 + 0.00139819993637502f) * _S145 + 0.00833345204591751f) * _S145 + 0.04166579619050026f) * _S145 + 0.1666666567325592f) * _S145 + 0.5f;
    float _S146 = asfloat(uint(int(_S144) + int(127)) << int(23));
    float _S147;
    if(x_11 < -87.0f)
    {
        _S147 = 0.0f;
    }
    else
    {
        _S147 = (p_0 * _S145 * _S145 + _S145 + 1.0f) * _S146;
    }
    return _S147;
}

float3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S148 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S149 = 2.0f * sqrt(_S148) - 1.0f;
    float _S150 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S149, _S150), 0.00999999977648258f, 1.0f), clamp((1.0f - _S148) * sheen_shear_0(_S149, _S150), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S149, _S150), -60.0f, 60.0f))));
}

float3 camera_right_0(int _S151)
{
    return float3(frames_0[_S151].right_x_0, frames_0[_S151].right_y_0, frames_0[_S151].right_z_0);
}

float3 camera_up_0(int _S152)
{
    return float3(frames_0[_S152].up_x_0, frames_0[_S152].up_y_0, frames_0[_S152].up_z_0);
}

float3 camera_forward_0(int _S153)
{
    return float3(frames_0[_S153].forward_x_0, frames_0[_S153].forward_y_0, frames_0[_S153].forward_z_0);
}

float3 camera_origin_0(int _S154)
{
    return float3(frames_0[_S154].origin_x_0, frames_0[_S154].origin_y_0, frames_0[_S154].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S155, uint _S156, float _S157, float _S158)
{
    uint _S159 = 3U * _S156;
    Vertex_0 _S160 = vertices_0.Load(corners_0.Load(_S159));
    Vertex_0 _S161 = vertices_0.Load(corners_0.Load(_S159 + 1U));
    Vertex_0 _S162 = vertices_0.Load(corners_0.Load(_S159 + 2U));
    float3 _S163 = position_of_0(_S160);
    float3 _S164 = position_of_0(_S161) - _S163;
    float3 _S165 = position_of_0(_S162) - _S163;
    float _S166 = _S161.u_0 - _S160.u_0;
    float _S167 = _S161.v_0 - _S160.v_0;
    float2 _S168 = float2(_S166, _S167);
    float _S169 = _S162.u_0 - _S160.u_0;
    float _S170 = _S162.v_0 - _S160.v_0;
    float2 _S171 = float2(_S169, _S170);
    float _S172;
    if((_S166 * _S170 - _S167 * _S169) < 0.0f)
    {
        _S172 = -1.0f;
    }
    else
    {
        _S172 = 1.0f;
    }
    float3 _S173 = _S172 * (_S170 * _S164 - _S167 * _S165);
    float3 _S174 = _S172 * (_S166 * _S165 - _S169 * _S164);
    VisiblePoint_0 point_1;
    float3 _S175 = normalize((1.0f - _S157 - _S158) * normal_of_0(_S160) + _S157 * normal_of_0(_S161) + _S158 * normal_of_0(_S162));
    point_1.normal_0 = _S175;
    float3 _S176 = normalize(_S173 - _S175 * dot(_S175, _S173));
    point_1.axis_x_0 = _S176;
    point_1.axis_y_0 = cross(_S175, _S176);
    float3 _S177 = normalize(cross(_S164, _S165));
    float3 _S178;
    if((dot(_S177, _S175)) < 0.0f)
    {
        _S178 = - _S177;
    }
    else
    {
        _S178 = _S177;
    }
    point_1.face_normal_0 = _S178;
    point_1.position_0 = _S163 + _S157 * _S164 + _S158 * _S165;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_0 = float2(_S160.u_0, _S160.v_0) + _S157 * _S168 + _S158 * _S171;
    bool _S179 = (dot(cross(_S173, _S174), point_1.normal_0)) < 0.0f;
    float _S180 = fabrics_0[_S155].uv_width_0;
    if(_S179)
    {
        _S172 = - fabrics_0[_S155].uv_height_0;
    }
    else
    {
        _S172 = fabrics_0[_S155].uv_height_0;
    }
    float2 _S181 = float2(_S180, _S172);
    point_1.draft_per_uv_0 = _S181;
    float2 _S182 = point_1.uv_0 * _S181;
    if(_S179)
    {
        _S172 = fabrics_0[_S155].uv_height_0;
    }
    else
    {
        _S172 = 0.0f;
    }
    point_1.draft_0 = _S182 + float2(0.0f, _S172);
    float2 _S183 = (float2)0.0f;
    point_1.draft_dx_0 = _S183;
    point_1.draft_dy_0 = _S183;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S184, uint _S185, uint _S186, uint2 _S187)
{
    uint _S188 = 3U * _S186;
    Vertex_0 _S189 = vertices_0.Load(corners_0.Load(_S188));
    Vertex_0 _S190 = vertices_0.Load(corners_0.Load(_S188 + 1U));
    Vertex_0 _S191 = vertices_0.Load(corners_0.Load(_S188 + 2U));
    float3 _S192 = position_of_0(_S189);
    float3 _S193 = position_of_0(_S190) - _S192;
    float3 _S194 = position_of_0(_S191) - _S192;
    float3 _S195 = cross(_S193, _S194);
    float _S196 = 1.0f / max(square_0(_S195), 1.00000000317107685e-30f);
    float _S197 = float(frames_0[_S184].width_0);
    float3 _S198 = camera_right_0(_S184) * (2.0f / _S197);
    float _S199 = float(frames_0[_S184].height_0);
    float3 _S200 = camera_up_0(_S184) * (-2.0f / _S199);
    float3 _S201 = camera_forward_0(_S184) + (float(_S187.x) + 0.5f - 0.5f * _S197) * _S198 + (float(_S187.y) + 0.5f - 0.5f * _S199) * _S200;
    float _S202 = dot(_S201, _S195);
    float _S203;
    if((abs(_S202)) > 1.00000000317107685e-30f)
    {
        _S203 = _S202;
    }
    else
    {
        _S203 = 1.00000000317107685e-30f;
    }
    float _S204 = 1.0f / _S203;
    float3 _S205 = _S192 - camera_origin_0(_S184);
    float _S206 = dot(_S205, _S195) * _S204;
    float3 _S207 = _S201 * _S206 - _S205;
    float3 _S208 = _S206 * (_S198 - _S201 * (dot(_S198, _S195) * _S204));
    float3 _S209 = _S206 * (_S200 - _S201 * (dot(_S200, _S195) * _S204));
    float3 _S210 = cross(_S194, _S195) * _S196;
    float3 _S211 = cross(_S195, _S193) * _S196;
    float2 _S212 = float2(_S190.u_0 - _S189.u_0, _S190.v_0 - _S189.v_0);
    float2 _S213 = float2(_S191.u_0 - _S189.u_0, _S191.v_0 - _S189.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S185, _S186, dot(_S207, _S210), dot(_S207, _S211));
    point_2.position_0 = _S192 + _S207;
    point_2.view_0 = - normalize(_S201);
    point_2.draft_dx_0 = (dot(_S208, _S210) * _S212 + dot(_S208, _S211) * _S213) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S209, _S210) * _S212 + dot(_S209, _S211) * _S213) * point_2.draft_per_uv_0;
    return point_2;
}

uint light_sample_count_0(int _S214)
{
    return frames_0[_S214].lights_0 + frames_0[_S214].environment_samples_0;
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_2;
};

float3 environment_texel_0(int _S215, uint _S216, uint _S217)
{
    uint _S218 = frames_0[_S215].environment_table_0 + frames_0[_S215].environment_rows_0 + 1U + frames_0[_S215].environment_rows_0 * (frames_0[_S215].environment_columns_0 + 1U) + 3U * (_S216 * frames_0[_S215].environment_columns_0 + _S217);
    return float3(scene_number_0(_S218), scene_number_0(_S218 + 1U), scene_number_0(_S218 + 2U));
}

float3 sample_environment_0(int _S219, float2 _S220, out float3 _S221)
{
    uint _S222 = frames_0[_S219].environment_rows_0;
    Choice_0 _S223 = choose_0(frames_0[_S219].environment_table_0, frames_0[_S219].environment_rows_0, _S220.y);
    uint _S224 = frames_0[_S219].environment_columns_0;
    Choice_0 _S225 = choose_0(frames_0[_S219].environment_table_0 + frames_0[_S219].environment_rows_0 + 1U + _S223.index_2 * (frames_0[_S219].environment_columns_0 + 1U), frames_0[_S219].environment_columns_0, _S220.x);
    float3 _S226 = environment_texel_0(_S219, _S223.index_2, _S225.index_2);
    _S221 = _S226 * (frames_0[_S219].environment_total_0 / max(mean_0(_S226), 9.99999968265522539e-21f));
    float _S227 = 3.14159274101257324f / float(_S222);
    float _S228 = lerp(sine_cosine_0(float(_S223.index_2) * _S227).y, sine_cosine_0(float(_S223.index_2 + 1U) * _S227).y, _S223.remainder_0);
    float _S229 = sqrt(max(1.0f - _S228 * _S228, 0.0f));
    float2 _S230 = sine_cosine_0((float(_S225.index_2) + _S225.remainder_0) * (6.28318548202514648f / float(_S224)));
    float _S231 = _S229 * _S230.x;
    float _S232 = - _S229 * _S230.y;
    return float3(frames_0[_S219].environment_cosine_0 * _S231 + frames_0[_S219].environment_sine_0 * _S232, _S228, frames_0[_S219].environment_cosine_0 * _S232 - frames_0[_S219].environment_sine_0 * _S231);
}

LightSample_0 light_sample_0(int _S233, uint _S234, uint2 _S235, float3 _S236)
{
    LightSample_0 sample_0;
    sample_0.distance_2 = 1.00000001504746622e+30f;
    uint _S237 = frames_0[_S233].lights_0;
    if(_S234 >= (frames_0[_S233].lights_0))
    {
        float3 weight_0;
        float3 _S238 = sample_environment_0(_S233, pixel_sequence_0(_S235, frames_0[_S233].pass_number_0 * frames_0[_S233].environment_samples_0 + (_S234 - _S237), 3U), weight_0);
        sample_0.towards_0 = _S238;
        sample_0.irradiance_1 = weight_0 / float(frames_0[_S233].environment_samples_0);
        return sample_0;
    }
    Light_0 _S239 = lights_1.Load(_S234);
    sample_0.irradiance_1 = float3(_S239.red_0, _S239.green_0, _S239.blue_0);
    sample_0.towards_0 = float3(_S239.x_1, _S239.y_1, _S239.z_1);
    if((_S239.is_point_0) != 0U)
    {
        float3 _S240 = sample_0.towards_0 - _S236;
        float _S241 = max(square_0(_S240), 9.999999960041972e-13f);
        sample_0.distance_2 = sqrt(_S241);
        sample_0.irradiance_1 = sample_0.irradiance_1 / _S241;
        sample_0.towards_0 = normalize(_S240);
    }
    return sample_0;
}

float3 seen_position_0(int _S242, uint _S243, uint2 _S244)
{
    uint _S245 = 3U * _S243;
    float3 _S246 = position_of_0(vertices_0.Load(corners_0.Load(_S245)));
    float3 _S247 = position_of_0(vertices_0.Load(corners_0.Load(_S245 + 1U))) - _S246;
    float3 _S248 = position_of_0(vertices_0.Load(corners_0.Load(_S245 + 2U))) - _S246;
    float3 _S249 = cross(_S247, _S248);
    float _S250 = 1.0f / max(square_0(_S249), 1.00000000317107685e-30f);
    float _S251 = float(frames_0[_S242].width_0);
    float _S252 = float(frames_0[_S242].height_0);
    float3 _S253 = camera_forward_0(_S242) + camera_right_0(_S242) * (2.0f * (float(_S244.x) + 0.5f + frames_0[_S242].jitter_x_0 - 0.5f * _S251) / _S251) - camera_up_0(_S242) * (2.0f * (float(_S244.y) + 0.5f + frames_0[_S242].jitter_y_0 - 0.5f * _S252) / _S252);
    float _S254 = dot(_S253, _S249);
    float3 _S255 = _S246 - camera_origin_0(_S242);
    float _S256 = dot(_S255, _S249);
    float _S257;
    if((abs(_S254)) > 1.00000000317107685e-30f)
    {
        _S257 = _S254;
    }
    else
    {
        _S257 = 1.00000000317107685e-30f;
    }
    float3 _S258 = _S253 * (_S256 / _S257) - _S255;
    float _S259 = clamp(dot(_S258, cross(_S248, _S249)) * _S250, 0.0f, 1.0f);
    return _S246 + _S259 * _S247 + clamp(dot(_S258, cross(_S249, _S247)) * _S250, 0.0f, 1.0f - _S259) * _S248;
}

Hit_0 nearest_hit_0(int _S260, float3 _S261, float3 _S262, float _S263, float _S264, uint _S265, bool _S266)
{
    float3 _S267 = float3(inverse_of_0(_S262.x), inverse_of_0(_S262.y), inverse_of_0(_S262.z));
    Hit_0 found_0;
    found_0.face_1 = 4294967295U;
    found_0.distance_0 = _S264;
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
        if(!meets_node_0(node_2, _S261, _S267, _S263, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            uint _S268 = frames_0[_S260].leaves_0;
            if(node_2 < (frames_0[_S260].leaves_0))
            {
                node_3 = node_2 * 2U;
            }
            else
            {
                uint _S269 = frames_0[_S260].leaf_faces_0 + 4U * (node_2 - _S268);
                uint _S270 = following_node_0(node_2);
                uint number_1 = 0U;
                node_3 = _S270;
                for(;;)
                {
                    if(number_1 < 4U)
                    {
                    }
                    else
                    {
                        break;
                    }
                    uint _S271 = scene_words_0.Load(_S269 + number_1);
                    bool _S272;
                    if(_S271 == 4294967295U)
                    {
                        _S272 = true;
                    }
                    else
                    {
                        _S272 = _S271 == _S265;
                    }
                    if(_S272)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    Hit_0 _S273 = meet_face_0(_S271, _S261, _S262);
                    bool _S274;
                    if((_S273.face_1) == 4294967295U)
                    {
                        _S274 = true;
                    }
                    else
                    {
                        _S274 = (_S273.distance_0) <= _S263;
                    }
                    bool _S275;
                    if(_S274)
                    {
                        _S275 = true;
                    }
                    else
                    {
                        _S275 = (_S273.distance_0) >= (found_0.distance_0);
                    }
                    if(_S275)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    found_0 = _S273;
                    bool _S276;
                    if(_S266)
                    {
                        _S276 = (fabrics_0[face_fabrics_0.Load(_S271)].is_open_0) == 0U;
                    }
                    else
                    {
                        _S276 = false;
                    }
                    uint node_4;
                    if(_S276)
                    {
                        node_4 = 0U;
                    }
                    else
                    {
                        node_4 = node_3;
                    }
                    node_3 = node_4;
                    number_1 = number_1 + 1U;
                }
            }
        }
        node_2 = node_3;
    }
    return found_0;
}

struct Regime_0
{
    float prefiltered_0;
    float threads_0;
    float points_0;
};

Regime_0 regime_of_0(uint _S277, Footprint_0 _S278, float _S279)
{
    float _S280 = Footprint_spread_side_0(_S278);
    float _S281 = clamp((binary_logarithm_0(max(_S280, 9.99999971718068537e-10f)) - fabrics_0[_S277].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S282 = _S281 * _S281 * (3.0f - 2.0f * _S281);
    regime_0.prefiltered_0 = _S282;
    regime_0.threads_0 = _S280 * fabrics_0[_S277].lobes_0.threads_per_mm_0;
    float _S283 = lerp(max(8.0f / _S279, 1.0f), 1.0f, _S282);
    float _S284;
    if(_S282 < 1.0f)
    {
        _S284 = clamp(regime_0.threads_0 * 12.0f, 1.0f, _S283);
    }
    else
    {
        _S284 = 0.0f;
    }
    regime_0.points_0 = _S284;
    return regime_0;
}

struct Hit_1
{
    float x_12;
    float y_7;
    bool hole_2;
    float height_3;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_4;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S285, float _S286, float _S287, bool _S288)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0[_S285].warp_0, _S286);
    crossing_2.weft_1 = locate_0(fabrics_0[_S285].weft_0, _S287);
    uint _S289 = fabrics_0[_S285].run_words_0 + 2U * (crossing_2.weft_1.thread_1 * fabrics_0[_S285].ends_1 + crossing_2.warp_1.thread_1);
    uint _S290 = words_0.Load(_S289);
    crossing_2.warp_word_0 = _S290;
    crossing_2.weft_word_0 = words_0.Load(_S289 + 1U);
    crossing_2.warp_above_0 = ((_S290 & 1U) == 1U) != _S288;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S291, float _S292, float _S293, bool _S294)
{
    Sample_0 sample_1;
    Crossing_0 _S295 = crossing_at_0(_S291, _S292, _S293, _S294);
    sample_1.crossing_1 = _S295;
    Shown_0 _S296 = shown_at_0(_S295, _S294);
    sample_1.shown_3 = _S296;
    uint _S297;
    if(_S296.is_warp_0)
    {
        _S297 = fabrics_0[_S291].warp_0;
    }
    else
    {
        _S297 = fabrics_0[_S291].weft_0;
    }
    uint _S298;
    if(_S296.is_warp_0)
    {
        _S298 = fabrics_0[_S291].weft_0;
    }
    else
    {
        _S298 = fabrics_0[_S291].warp_0;
    }
    Cell_0 _S299 = select_cell_0(_S296.is_warp_0, sample_1.crossing_1.warp_1, sample_1.crossing_1.weft_1);
    Cell_0 _S300 = select_cell_0(_S296.is_warp_0, sample_1.crossing_1.weft_1, sample_1.crossing_1.warp_1);
    Run_0 _S301 = unpack_0(_S297, _S298, _S299.thread_1, _S300, _S296.word_0);
    Section_0 _S302 = section_at_0(_S299);
    bool _S303;
    if(_S296.on_top_0)
    {
        _S303 = (_S301.distance_1) < (_S302.drop_0 * _S301.bend_1.sine_0);
    }
    else
    {
        _S303 = false;
    }
    bool _S304;
    if(_S296.on_top_0)
    {
        _S304 = !_S303;
    }
    else
    {
        _S304 = false;
    }
    float _S305;
    if(_S304)
    {
        _S305 = 1.0f;
    }
    else
    {
        _S305 = -1.0f;
    }
    float _S306;
    if(_S303)
    {
        _S306 = _S301.other_reach_0;
    }
    else
    {
        _S306 = _S301.reach_0;
    }
    float _S307;
    if(_S303)
    {
        _S307 = _S306 + _S301.distance_1;
    }
    else
    {
        _S307 = max(_S306 - _S301.distance_1, 0.0f);
    }
    float _S308 = _S306 / _S301.bend_1.sine_0 - _S305 * _S302.drop_0;
    float _S309 = _S307 * _S307;
    float _S310 = max(_S308 * _S308 - _S309, 9.99999968265522539e-21f);
    float _S311 = rsqrt(_S310);
    float _S312 = _S309 / (_S310 * _S311 + _S308);
    bool _S313 = _S307 > 0.0f;
    float _S314;
    if(_S296.on_top_0)
    {
        _S314 = 1.0f;
    }
    else
    {
        _S314 = -1.0f;
    }
    float _S315;
    if(_S301.near_start_0)
    {
        _S315 = 1.0f;
    }
    else
    {
        _S315 = -1.0f;
    }
    float _S316 = _S314 * _S315;
    if(_S313)
    {
        _S314 = _S308 * _S311;
    }
    else
    {
        _S314 = 1.0f;
    }
    sample_1.slope_across_0 = _S302.slope_0 * _S314;
    if(_S313)
    {
        _S307 = _S316 * _S307 * _S311;
    }
    else
    {
        _S307 = 0.0f;
    }
    sample_1.slope_along_0 = _S307;
    Family_0 _S317 = families_0.Load(_S297);
    float2 _S318 = dive_0(_S298, _S296, _S301, _S300);
    if(_S301.straight_0)
    {
        _S305 = 0.0f;
    }
    else
    {
        _S305 = _S317.height_scale_0 * _S305;
    }
    sample_1.height_4 = _S305 * (_S306 * _S301.bend_1.half_tangent_0 - _S312) - _S317.height_scale_0 * _S302.drop_0 - _S318.x;
    float _S319 = _S317.height_scale_0 * sample_1.slope_across_0;
    float _S320 = _S317.height_scale_0 * sample_1.slope_along_0 - _S318.y;
    if(_S296.is_warp_0)
    {
        _S305 = _S319;
    }
    else
    {
        _S305 = _S320;
    }
    sample_1.slope_x_1 = _S305;
    if(_S296.is_warp_0)
    {
        _S305 = _S320;
    }
    else
    {
        _S305 = _S319;
    }
    sample_1.slope_y_1 = _S305;
    sample_1.run_3 = _S301;
    sample_1.section_1 = _S302;
    return sample_1;
}

float steps_per_length_0(uint _S321, SearchQuality_0 _S322, float3 _S323)
{
    return max(max(abs(_S323.x) * fabrics_0[_S321].threads_per_x_0, abs(_S323.y) * fabrics_0[_S321].threads_per_y_0) * _S322.steps_per_thread_0, abs(_S323.z) * fabrics_0[_S321].per_relief_0 * _S322.steps_per_relief_0);
}

float cell_maximum_0(uint _S324, Crossing_0 _S325)
{
    uint _S326;
    if(_S325.warp_above_0)
    {
        _S326 = fabrics_0[_S324].warp_0;
    }
    else
    {
        _S326 = fabrics_0[_S324].weft_0;
    }
    uint _S327;
    if(_S325.warp_above_0)
    {
        _S327 = _S325.warp_word_0;
    }
    else
    {
        _S327 = _S325.weft_word_0;
    }
    return float(_S327 >> int(28)) * families_0.Load(_S326).height_scale_0 * families_0.Load(_S326).level_0;
}

Probe_0 probe_0(uint _S328, float _S329, float _S330, bool _S331, bool _S332, bool _S333)
{
    Sample_0 _S334 = sample_at_0(_S328, _S329, _S330, _S331);
    Probe_0 probe_1;
    probe_1.height_1 = _S334.height_4;
    probe_1.hole_1 = _S334.shown_3.hole_0;
    probe_1.slope_x_0 = _S334.slope_x_1;
    probe_1.slope_y_0 = _S334.slope_y_1;
    uint _S335;
    if(_S334.shown_3.is_warp_0)
    {
        _S335 = _S334.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S335 = _S334.crossing_1.weft_1.thread_1 * 2U;
    }
    probe_1.yarn_1 = _S335;
    probe_1.cell_max_0 = cell_maximum_0(_S328, _S334.crossing_1);
    float _S336;
    if(_S332)
    {
        _S336 = _S334.crossing_1.warp_1.above_0;
    }
    else
    {
        _S336 = _S334.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S336;
    if(_S333)
    {
        _S336 = _S334.crossing_1.weft_1.above_0;
    }
    else
    {
        _S336 = _S334.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S336;
    probe_1.edge_x_0 = outline_distance_0(_S334.crossing_1.warp_1, _S334.shown_3, _S334.run_3, !_S334.shown_3.is_warp_0, _S332);
    probe_1.edge_y_0 = outline_distance_0(_S334.crossing_1.weft_1, _S334.shown_3, _S334.run_3, _S334.shown_3.is_warp_0, _S333);
    return probe_1;
}

bool is_free_0(uint _S337, SearchQuality_0 _S338, float3 _S339, float3 _S340, bool _S341, float _S342)
{
    float _S343 = _S340.z;
    if(_S343 <= 0.0f)
    {
        return false;
    }
    float _S344 = 1.0f / max(_S338.shadow_share_0 * steps_per_length_0(_S337, _S338, _S340), 9.99999971718068537e-10f);
    StepControl_0 _S345 = step_control_0(_S340.xy, _S344);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_3 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S346;
        if(count_3 < 1024U)
        {
            _S346 = (_S339.z + _S343 * distance_3) < _S342;
        }
        else
        {
            _S346 = false;
        }
        if(_S346)
        {
        }
        else
        {
            break;
        }
        float3 _S347 = _S339 + _S340 * distance_3;
        Probe_0 _S348 = probe_0(_S337, _S347.x, _S347.y, _S341, _S345.right_0, _S345.up_0);
        float _S349 = _S347.z;
        float _S350 = _S349 - _S348.height_1;
        float _S351 = _S343 - _S348.slope_x_0 * _S340.x - _S348.slope_y_0 * _S340.y;
        bool _S352;
        if(!_S348.hole_1)
        {
            _S352 = _S350 < 0.0f;
        }
        else
        {
            _S352 = false;
        }
        if(_S352)
        {
            return false;
        }
        float _S353 = way_back_to_dip_0(previous_3, _S350, _S351, last_step_0, _S348);
        if(_S353 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S353;
            distance_3 = distance_3 - _S353;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S354 = _S349 > (_S348.cell_max_0);
        PreviousSample_0 _S355 = after_sample_0(_S350, _S351, _S348, _S354);
        float last_step_2;
        if(_S354)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S345, _S348.side_x_0, _S348.side_y_0), _S344);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S345, _S348, _S350, _S351);
        }
        float distance_4 = distance_3 + last_step_2;
        previous_3 = _S355;
        distance_3 = distance_4;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S356, SearchQuality_0 _S357, float _S358, float _S359, float3 _S360, bool _S361)
{
    if(!sample_at_0(_S356, _S358, _S359, _S361).shown_3.hole_0)
    {
        return false;
    }
    float3 _S362 = float3(_S358, _S359, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S363;
        if(side_0 < 2U)
        {
            _S363 = passes_0;
        }
        else
        {
            _S363 = false;
        }
        if(_S363)
        {
        }
        else
        {
            break;
        }
        float3 _S364;
        if(side_0 == 0U)
        {
            _S364 = _S360;
        }
        else
        {
            _S364 = float3(- _S360.x, - _S360.y, _S360.z);
        }
        bool _S365 = is_free_0(_S356, _S357, _S362, _S364, _S361 != (side_0 == 1U), fabrics_0[_S356].height_high_0);
        uint _S366 = side_0 + 1U;
        passes_0 = _S365;
        side_0 = _S366;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_5;
    float last_step_3;
    float depth_0;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

float max_height_along_0(uint _S367, float _S368, float _S369, float _S370, float3 _S371, bool _S372)
{
    uint _S373 = locate_0(fabrics_0[_S367].warp_0, _S368).thread_1 / 2U;
    uint _S374 = locate_0(fabrics_0[_S367].weft_0, _S369).thread_1 / 2U;
    float _S375 = _S371.x;
    uint _S376;
    if(_S375 > 0.0f)
    {
        _S376 = 1U;
    }
    else
    {
        _S376 = 0U;
    }
    float _S377 = _S371.y;
    uint _S378;
    if(_S377 > 0.0f)
    {
        _S378 = 2U;
    }
    else
    {
        _S378 = 0U;
    }
    uint _S379 = words_0.Load(fabrics_0[_S367].max_heights_0 + 4U * (_S374 * fabrics_0[_S367].max_height_columns_0 + _S373) + (_S376 + _S378));
    int number_2;
    if(_S372)
    {
        number_2 = int(4);
    }
    else
    {
        number_2 = int(0);
    }
    uint _S380 = _S379 >> number_2;
    float _S381 = max(abs(_S375) * fabrics_0[_S367].threads_per_x_0, abs(_S377) * fabrics_0[_S367].threads_per_y_0) / _S371.z;
    float _S382 = fabrics_0[_S367].height_high_0;
    float max_height_0 = fabrics_0[_S367].height_high_0;
    number_2 = int(3);
    for(;;)
    {
        if(number_2 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S370) * _S381) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, float((_S380 >> uint(int(8) * number_2)) & 15U) * 0.06666667014360428f * _S382);
        }
        number_2 = number_2 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S383, float _S384, float _S385, bool _S386, bool _S387, bool _S388)
{
    Crossing_0 _S389 = crossing_at_0(_S383, _S384, _S385, _S386);
    float _S390 = cell_maximum_0(_S383, _S389);
    float _S391;
    if(_S387)
    {
        _S391 = _S389.warp_1.above_0;
    }
    else
    {
        _S391 = _S389.warp_1.below_0;
    }
    float _S392;
    if(_S388)
    {
        _S392 = _S389.weft_1.above_0;
    }
    else
    {
        _S392 = _S389.weft_1.below_0;
    }
    return float3(_S390, _S391, _S392);
}

float first_sample_height_0(uint _S393, ViewRay_0 _S394, StepControl_0 _S395, bool _S396)
{
    float _S397 = max_height_along_0(_S393, _S394.origin_2.x, _S394.origin_2.y, 0.0f, float3(_S394.slope_1, 1.0f), _S396);
    uint count_4 = 0U;
    float height_6 = _S397;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S398 = ViewRay_at_0(_S394, height_6);
        float3 _S399 = cell_bounds_0(_S393, _S398.x, _S398.y, _S396, _S395.right_0, _S395.up_0);
        float _S400 = height_6 - _S399.x;
        float _S401 = StepControl_to_cell_exit_0(_S395, _S399.y, _S399.z);
        float height_7 = height_6 - clamp(_S400, 0.0f, _S401);
        if(_S400 <= _S401)
        {
            height_6 = height_7;
            break;
        }
        count_4 = count_4 + 1U;
        height_6 = height_7;
    }
    return height_6;
}

ViewRayEnd_0 search_down_0(uint _S402, ViewRay_0 _S403, StepControl_0 _S404, bool _S405)
{
    float _S406 = fabrics_0[_S402].height_low_0 - (fabrics_0[_S402].height_high_0 - fabrics_0[_S402].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_5 = first_sample_height_0(_S402, _S403, _S404, _S405);
    end_1.last_step_3 = _S404.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_0 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    uint count_5 = 0U;
    for(;;)
    {
        if(count_5 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S407 = ViewRay_at_0(_S403, end_1.height_5);
        Probe_0 _S408 = probe_0(_S402, _S407.x, _S407.y, _S405, _S404.right_0, _S404.up_0);
        float _S409 = end_1.height_5 - _S408.height_1;
        float _S410 = ViewRay_rate_0(_S403, _S408);
        end_1.depth_0 = - _S409;
        end_1.rate_4 = _S410;
        bool _S411;
        if(end_1.previous_4.known_0)
        {
            _S411 = !_S408.hole_1;
        }
        else
        {
            _S411 = false;
        }
        bool _S412;
        if(_S411)
        {
            _S412 = (end_1.previous_4.yarn_0) == (_S408.yarn_1);
        }
        else
        {
            _S412 = false;
        }
        end_1.smooth_0 = _S412;
        bool _S413;
        if(!_S408.hole_1)
        {
            _S413 = _S409 <= 0.0f;
        }
        else
        {
            _S413 = false;
        }
        bool _S414;
        if(_S413)
        {
            _S414 = true;
        }
        else
        {
            _S414 = (end_1.height_5) <= _S406;
        }
        if(_S414)
        {
            break;
        }
        float _S415 = way_back_to_dip_0(end_1.previous_4, _S409, _S410, end_1.last_step_3, _S408);
        if(_S415 >= 0.0f)
        {
            end_1.height_5 = end_1.height_5 + _S415;
            end_1.last_step_3 = end_1.last_step_3 - _S415;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S416 = min(StepControl_to_cell_exit_0(_S404, _S408.side_x_0, _S408.side_y_0), end_1.height_5 - _S408.cell_max_0);
        float _S417 = StepControl_to_next_sample_0(_S404, _S408, _S409, _S410);
        end_1.previous_4 = after_sample_0(_S409, _S410, _S408, _S416 > _S417);
        float _S418 = max(_S416, _S417);
        end_1.last_step_3 = _S418;
        end_1.height_5 = end_1.height_5 - _S418;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S419, ViewRay_0 _S420, StepControl_0 _S421, bool _S422, ViewRayEnd_0 _S423, uint _S424)
{
    float _S425 = fabrics_0[_S419].height_high_0 - fabrics_0[_S419].height_low_0;
    float above_2 = _S423.height_5 + _S423.last_step_3;
    float above_gap_1 = clamp(_S423.previous_4.clearance_0, 0.0f, _S425);
    float under_gap_1 = clamp(_S423.depth_0, 0.0f, _S425);
    float _S426 = cubic_root_0(above_gap_1, - under_gap_1, _S423.previous_4.rate_0 * _S423.last_step_3, _S423.rate_4 * _S423.last_step_3);
    float middle_0;
    if(_S423.smooth_0)
    {
        middle_0 = above_2 - _S426 * _S423.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S423.height_5, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S423.height_5;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S424)
        {
        }
        else
        {
            break;
        }
        float2 _S427 = ViewRay_at_0(_S420, middle_0);
        Probe_0 _S428 = probe_0(_S419, _S427.x, _S427.y, _S422, _S421.right_0, _S421.up_0);
        float _S429;
        if(_S428.hole_1)
        {
            _S429 = -1.0e+09f;
        }
        else
        {
            _S429 = _S428.height_1;
        }
        float _S430 = clamp(middle_0 - _S429, - _S425, _S425);
        float _S431;
        if(_S430 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S431 = 0.5f * above_gap_2;
            }
            else
            {
                _S431 = above_gap_2;
            }
            float _S432 = - _S430;
            under_1 = middle_0;
            above_gap_2 = _S431;
            under_gap_2 = _S432;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S431 = 0.5f * under_gap_2;
            }
            else
            {
                _S431 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S430;
            under_gap_2 = _S431;
            side_1 = -1.0f;
        }
        if(_S423.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S430 / min(ViewRay_rate_0(_S420, _S428), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S423.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_1 first_hit_of_yarn_0(uint _S433, SearchQuality_0 _S434, float _S435, float _S436, float3 _S437, bool _S438)
{
    float _S439 = max(_S437.z, 0.00009999999747379f);
    ViewRay_0 ray_0;
    ray_0.origin_2 = float2(_S435, _S436);
    float2 _S440 = _S437.xy / _S439;
    ray_0.slope_1 = _S440;
    StepControl_0 _S441 = step_control_0(- _S440, 1.0f / max(steps_per_length_0(_S433, _S434, _S437) / _S439, 9.99999971718068537e-10f));
    ViewRayEnd_0 _S442 = search_down_0(_S433, ray_0, _S441, _S438);
    Hit_1 hit_1;
    hit_1.hole_2 = false;
    float _S443 = refined_height_0(_S433, ray_0, _S441, _S438, _S442, _S434.refinements_0);
    hit_1.height_3 = _S443;
    float2 _S444 = ViewRay_at_0(ray_0, _S443);
    hit_1.x_12 = _S444.x;
    hit_1.y_7 = _S444.y;
    return hit_1;
}

Hit_1 first_hit_0(uint _S445, SearchQuality_0 _S446, float _S447, float _S448, float3 _S449, bool _S450)
{
    if(!passes_through_0(_S445, _S446, _S447, _S448, _S449, _S450))
    {
        return first_hit_of_yarn_0(_S445, _S446, _S447, _S448, _S449, _S450);
    }
    Hit_1 hit_2;
    hit_2.x_12 = _S447;
    hit_2.y_7 = _S448;
    hit_2.height_3 = 0.0f;
    hit_2.hole_2 = true;
    return hit_2;
}

struct CoverageTaps_0
{
    uint  nodes_1[int(9)];
};

float3 pyramid_level_0(uint _S451, float _S452)
{
    uint _S453 = fabrics_0[_S451].lobes_0.levels_0 + 4U * uint(min(_S452, fabrics_0[_S451].lobes_0.last_level_0));
    return float3(table_number_0(_S453), table_number_0(_S453 + 1U), table_number_0(_S453 + 2U));
}

CoverageTaps_0 coverage_taps_0(uint _S454, Footprint_0 _S455, bool _S456)
{
    Lobes_0 _S457 = fabrics_0[_S454].lobes_0;
    float _S458 = Footprint_spread_side_0(_S455) * fabrics_0[_S454].lobes_0.inverse_base_size_0;
    float3 _S459 = pyramid_level_0(_S454, floor(binary_logarithm_0(max(0.68000000715255737f * _S458, 1.0f))));
    float _S460 = 1.0f / max(_S458, 9.99999997475242708e-07f);
    float _S461 = min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S460 * _S460), 0.0f, 1.0f)), 0.3333333432674408f * _S460), 1.0f);
    float2 _S462 = float2(families_0.Load(fabrics_0[_S454].warp_0).inverse_period_0, families_0.Load(fabrics_0[_S454].weft_0).inverse_period_0);
    float2 _S463 = _S455.centre_0 * _S462;
    float2 _S464 = _S455.dx_0 * _S462 * _S461;
    float2 _S465 = _S455.dy_0 * _S462 * _S461;
    CoverageTaps_0 taps_3;
    uint number_3 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        float2 _S466 = _S463 + TAP_OFFSETS_0[number_3].x * _S464 + TAP_OFFSETS_0[number_3].y * _S465;
        float _S467 = _S459.y;
        float _S468 = wrapped_cell_0(_S466.x, _S467);
        float _S469 = wrapped_cell_0(_S466.y, _S459.z);
        uint _S470;
        if(_S456)
        {
            _S470 = _S457.face_nodes_0;
        }
        else
        {
            _S470 = 0U;
        }
        taps_3.nodes_1[number_3] = _S470 + uint(_S469 * _S467 + _S468 + _S459.x);
        number_3 = number_3 + 1U;
    }
    return taps_3;
}

float coverage_of_holes_0(uint _S471, CoverageTaps_0 _S472)
{
    uint number_4 = 0U;
    uint total_0 = 0U;
    for(;;)
    {
        if(number_4 < 9U)
        {
        }
        else
        {
            break;
        }
        uint total_1 = total_0 + ((words_0.Load(fabrics_0[_S471].lobes_0.coverage_holes_0 + _S472.nodes_1[number_4] / 4U) >> (8U * (_S472.nodes_1[number_4] % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S473, CoverageTaps_0 _S474, NodeTaps_0 _S475, bool _S476)
{
    Lobes_0 _S477 = fabrics_0[_S473].lobes_0;
    float _S478 = interpolate_table_0(_S475, fabrics_0[_S473].lobes_0.projected_area_0 + fabrics_0[_S473].lobes_0.packs_0, fabrics_0[_S473].lobes_0.packs_0 + 1U).x;
    float _S479;
    if(_S476)
    {
        _S479 = _S477.back_hole_weight_0;
    }
    else
    {
        _S479 = _S477.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S473, _S474) * _S478 * _S478 * _S479, 1.0f);
}

float passed_share_0(uint _S480, VisiblePoint_0 _S481, float3 _S482, float _S483, float2 _S484)
{
    float3 _S485 = to_local_0(_S481, _S482);
    bool _S486 = (_S485.z) < 0.0f;
    float3 _S487 = to_face_frame_0(_S485, _S486);
    Footprint_0 footprint_0;
    footprint_0.centre_0 = _S481.draft_0;
    footprint_0.dx_0 = float2(_S483, 0.0f);
    footprint_0.dy_0 = float2(0.0f, _S483);
    float _S488;
    if((fabrics_0[_S480].lobes_0.is_baked_0) != 0U)
    {
        _S488 = regime_of_0(_S480, footprint_0, 1.0f).prefiltered_0;
    }
    else
    {
        _S488 = 0.0f;
    }
    float share_2;
    if(_S488 < 1.0f)
    {
        float2 _S489 = footprint_0.centre_0 + (_S484 - 0.5f) * _S483;
        if(first_hit_0(_S480, default_quality_0(), _S489.x, _S489.y, _S487, _S486).hole_2)
        {
            share_2 = 1.0f - _S488;
        }
        else
        {
            share_2 = 0.0f;
        }
    }
    else
    {
        share_2 = 0.0f;
    }
    if(_S488 > 0.0f)
    {
        NodeTaps_0 nodes_2 = node_taps_0(_S487);
        uint _S490;
        if(_S486)
        {
            _S490 = 1U;
        }
        else
        {
            _S490 = 0U;
        }
        nodes_2.nodes_0 = nodes_2.nodes_0 + _S490 * 256U;
        share_2 = share_2 + _S488 * prefiltered_hole_0(_S480, coverage_taps_0(_S480, footprint_0, _S486), nodes_2, _S486);
    }
    float _S491 = fabrics_0[_S480].sheen_strength_0;
    if((fabrics_0[_S480].sheen_strength_0) > 0.0f)
    {
        share_2 = share_2 * (1.0f - _S491 * sheen_lobe_0(_S487.z, fabrics_0[_S480].sheen_roughness_0).z);
    }
    return share_2;
}

float visibility_of_0(int _S492, VisiblePoint_0 _S493, uint _S494, uint2 _S495, uint _S496)
{
    LightSample_0 _S497 = light_sample_0(_S492, _S496, _S495, _S493.position_0);
    float nearest_1;
    if((dot(_S497.towards_0, _S493.face_normal_0)) < 0.0f)
    {
        nearest_1 = -1.0f;
    }
    else
    {
        nearest_1 = 1.0f;
    }
    float3 _S498 = seen_position_0(_S492, _S494, _S495) + nearest_1 * frames_0[_S492].ray_offset_0 * _S493.face_normal_0;
    float2 _S499 = _S493.draft_dx_0;
    float2 _S500 = _S493.draft_dy_0;
    float _S501 = sqrt(0.5f * (dot(_S499, _S499) + dot(_S500, _S500)));
    nearest_1 = 0.0f;
    uint without_0 = _S494;
    uint layer_0 = 0U;
    float visibility_0 = 1.0f;
    for(;;)
    {
        bool _S502;
        if(layer_0 < 8U)
        {
            _S502 = visibility_0 > 0.00100000004749745f;
        }
        else
        {
            _S502 = false;
        }
        if(_S502)
        {
        }
        else
        {
            break;
        }
        Hit_0 _S503 = nearest_hit_0(_S492, _S498, _S497.towards_0, nearest_1, _S497.distance_2, without_0, true);
        if((_S503.face_1) == 4294967295U)
        {
            break;
        }
        uint _S504 = face_fabrics_0.Load(_S503.face_1);
        VisiblePoint_0 _S505 = face_point_0(_S504, _S503.face_1, _S503.weight_b_0, _S503.weight_c_0);
        float2 _S506 = pixel_sequence_0(_S495, frames_0[_S492].pass_number_0, 5U + 2U * (8U * _S496 + layer_0));
        float _S507;
        if((fabrics_0[_S504].is_open_0) != 0U)
        {
            _S507 = passed_share_0(_S504, _S505, - _S497.towards_0, _S501, _S506);
        }
        else
        {
            _S507 = 0.0f;
        }
        float visibility_1 = visibility_0 * _S507;
        uint _S508 = layer_0 + 1U;
        nearest_1 = _S503.distance_0;
        without_0 = _S503.face_1;
        layer_0 = _S508;
        visibility_0 = visibility_1;
    }
    if(visibility_0 > 0.00100000004749745f)
    {
        nearest_1 = visibility_0;
    }
    else
    {
        nearest_1 = 0.0f;
    }
    return nearest_1;
}

[numthreads(8, 8, 1)]
void cast_shadows(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S509 = frames_0[int(0)].width_0;
    bool _S510;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S510 = true;
    }
    else
    {
        _S510 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S510)
    {
        return;
    }
    uint _S511 = id_0.y * _S509 + id_0.x;
    uint _S512 = layers_0[_S511].face_0;
    if((layers_0[_S511].face_0) == 0U)
    {
        return;
    }
    uint _S513 = _S512 - 1U;
    VisiblePoint_0 _S514 = visible_point_0(int(0), face_fabrics_0.Load(_S513), _S513, id_0.xy);
    uint number_5 = 0U;
    for(;;)
    {
        if(number_5 < (light_sample_count_0(int(0))))
        {
        }
        else
        {
            break;
        }
        visibilities_0[number_5 * _S509 * frames_0[int(0)].height_0 + _S511] = visibility_of_0(int(0), _S514, _S513, id_0.xy, number_5);
        number_5 = number_5 + 1U;
    }
    return;
}

