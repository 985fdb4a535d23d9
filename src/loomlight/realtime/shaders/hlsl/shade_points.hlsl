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

StructuredBuffer<uint > scene_words_0 : register(t9);

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

RWStructuredBuffer<float > visibilities_0 : register(u3);

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

RWStructuredBuffer<float4 > radiance_0 : register(u0);

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

float square_1(float x_2)
{
    return x_2 * x_2;
}

float natural_logarithm_0(float x_3)
{
    uint _S1 = asuint(x_3);
    float exponent_0 = float(int(_S1 >> int(23)) - int(126));
    float m_0 = asfloat((_S1 & 8388607U) | 1056964608U);
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
    float _S2 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S2 - exponent_1 * 0.00021219444170129f - 0.5f * _S2) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

float exponential_0(float x_5)
{
    float _S3 = clamp(x_5, -87.0f, 88.0f);
    float _S4 = floor(_S3 * 1.4426950216293335f + 0.5f);
    float _S5 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f;
    float _S6 = asfloat(uint(int(_S4) + int(127)) << int(23));
    float _S7;
    if(x_5 < -87.0f)
    {
        _S7 = 0.0f;
    }
    else
    {
        _S7 = (p_0 * _S5 * _S5 + _S5 + 1.0f) * _S6;
    }
    return _S7;
}

float3 map_texel_0(uint index_0)
{
    uint _S8 = scene_words_0.Load(index_0);
    float3 _S9 = float3(float(_S8 & 1023U), float((_S8 >> int(10)) & 1023U), float(_S8 >> int(20))) / 1023.0f;
    return _S9 * _S9;
}

float3 map_level_0(uint first_0, uint side_0, float2 uv_0)
{
    float _S10 = uv_0.x;
    float _S11 = float(side_0);
    float _S12 = (_S10 - floor(_S10)) * _S11 - 0.5f;
    float _S13 = uv_0.y;
    float _S14 = (_S13 - floor(_S13)) * _S11 - 0.5f;
    float _S15 = floor(_S12);
    int _S16 = int(side_0);
    uint _S17 = side_0 - 1U;
    uint _S18 = uint(int(_S15) + _S16) & _S17;
    float _S19 = floor(_S14);
    uint _S20 = uint(int(_S19) + _S16) & _S17;
    uint _S21 = (_S18 + 1U) & _S17;
    uint _S22 = first_0 + _S20 * side_0;
    float3 _S23 = (float3)(_S12 - _S15);
    uint _S24 = first_0 + ((_S20 + 1U) & _S17) * side_0;
    return lerp(lerp(map_texel_0(_S22 + _S18), map_texel_0(_S22 + _S21), _S23), lerp(map_texel_0(_S24 + _S18), map_texel_0(_S24 + _S21), _S23), (float3)(_S14 - _S19));
}

uint scramble_0(uint value_0)
{
    uint _S25 = value_0 * 747796405U + 2891336453U;
    uint _S26 = ((_S25 >> ((_S25 >> int(28)) + 4U)) ^ _S25) * 277803737U;
    return (_S26 >> int(22)) ^ _S26;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_1, uint stream_1)
{
    uint _S27 = pixel_0.x;
    uint _S28 = pixel_0.y;
    return frac(float2(uniform_hash_0(_S27, _S28, stream_1), uniform_hash_0(_S27, _S28, stream_1 + 1U)) + float(index_1 & 65535U) * float2(0.75487768650054932f, 0.56984031200408936f));
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

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_1;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(VisiblePoint_0 point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S29 = direction_1.xy;
    float _S30;
    if(back_1)
    {
        _S30 = - direction_1.z;
    }
    else
    {
        _S30 = direction_1.z;
    }
    return float3(_S29, _S30);
}

float2 turns_and_remainder_0(uint family_0, float index_2)
{
    float _S31 = floor(mad(index_2, families_0.Load(family_0).inverse_count_0, families_0.Load(family_0).half_inverse_count_0));
    return float2(_S31, mad(- _S31, families_0.Load(family_0).count_0, index_2));
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
    float _S32 = floor(position_1 * families_0.Load(family_1).inverse_size_0);
    Cell_0 cell_1;
    float _S33 = mad(- _S32, families_0.Load(family_1).size_0, position_1);
    cell_1.below_0 = _S33;
    cell_1.above_0 = families_0.Load(family_1).size_0 - _S33;
    cell_1.across_0 = _S33 - 0.5f * families_0.Load(family_1).size_0;
    cell_1.half_width_1 = families_0.Load(family_1).half_width_0;
    cell_1.thread_1 = uint(clamp(turns_and_remainder_0(family_1, _S32).y, 0.0f, families_0.Load(family_1).count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_3)
{
    return asfloat(words_0.Load(index_3));
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0.Load(family_2).start_0) * families_0.Load(family_2).inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S34 = turns_1 * families_0.Load(family_2).period_0;
    uint thread_2 = words_0.Load(families_0.Load(family_2).first_thread_table_0 + uint(clamp(turns_1 * families_0.Load(family_2).bins_0, 0.0f, families_0.Load(family_2).bins_0 - 1.0f)));
    uint _S35;
    if(_S34 >= (table_number_0(families_0.Load(family_2).place_table_0 + thread_2 * 4U + 1U)))
    {
        _S35 = 1U;
    }
    else
    {
        _S35 = 0U;
    }
    uint _S36 = min(thread_2 + _S35, uint(families_0.Load(family_2).count_0) - 1U);
    uint _S37 = families_0.Load(family_2).place_table_0 + _S36 * 4U;
    Cell_0 cell_2;
    cell_2.thread_1 = _S36;
    cell_2.below_0 = _S34 - table_number_0(_S37);
    cell_2.above_0 = table_number_0(_S37 + 1U) - _S34;
    cell_2.across_0 = _S34 - table_number_0(_S37 + 2U);
    cell_2.half_width_1 = table_number_0(_S37 + 3U);
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
    bool _S38 = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    bool _S39 = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S40;
    if(_S38)
    {
        if(!_S39)
        {
            _S40 = true;
        }
        else
        {
            _S40 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S40 = false;
    }
    shown_0.is_warp_0 = _S40;
    if(!_S38)
    {
        _S40 = !_S39;
    }
    else
    {
        _S40 = false;
    }
    shown_0.hole_0 = _S40;
    uint _S41;
    if(shown_0.is_warp_0)
    {
        _S41 = crossing_0.warp_word_0;
    }
    else
    {
        _S41 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S41;
    shown_0.on_top_0 = ((_S41 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_1, Cell_0 second_0)
{
    Cell_0 cell_3;
    uint _S42;
    if(is_first_0)
    {
        _S42 = first_1.thread_1;
    }
    else
    {
        _S42 = second_0.thread_1;
    }
    cell_3.thread_1 = _S42;
    float _S43;
    if(is_first_0)
    {
        _S43 = first_1.across_0;
    }
    else
    {
        _S43 = second_0.across_0;
    }
    cell_3.across_0 = _S43;
    if(is_first_0)
    {
        _S43 = first_1.half_width_1;
    }
    else
    {
        _S43 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S43;
    if(is_first_0)
    {
        _S43 = first_1.below_0;
    }
    else
    {
        _S43 = second_0.below_0;
    }
    cell_3.below_0 = _S43;
    if(is_first_0)
    {
        _S43 = first_1.above_0;
    }
    else
    {
        _S43 = second_0.above_0;
    }
    cell_3.above_0 = _S43;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0)
{
    float2 _S44 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0));
    return mad(_S44.x, families_0.Load(family_4).period_0, table_number_0(families_0.Load(family_4).place_table_0 + uint(_S44.y) * 4U));
}

float span_0(uint family_5, uint thread_4, int first_2, int last_0)
{
    if((families_0.Load(family_5).is_alike_0) != 0U)
    {
        return float(last_0 - first_2) * families_0.Load(family_5).size_0;
    }
    return boundary_0(family_5, thread_4, last_0) - boundary_0(family_5, thread_4, first_2);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_5)
{
    Family_0 _S45 = families_0.Load(family_6);
    uint _S46;
    if((families_0.Load(family_6).is_alike_0) != 0U)
    {
        _S46 = 0U;
    }
    else
    {
        _S46 = thread_5 * 4U;
    }
    uint _S47 = _S45.bend_table_0 + _S46;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S47);
    bend_0.half_tangent_0 = table_number_0(_S47 + 1U);
    bend_0.arc_0 = table_number_0(_S47 + 2U);
    return bend_0;
}

struct Run_0
{
    float distance_0;
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
    int _S48 = int((word_1 >> int(1)) & 127U);
    int _S49 = int((word_1 >> int(8)) & 127U);
    int _S50 = int((word_1 >> int(15)) & 63U);
    int _S51 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    int _S52 = - _S48;
    float _S53 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S52, int(0));
    run_0.from_start_0 = _S53;
    int _S54 = _S49 + int(1);
    float _S55 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, int(1), _S54);
    run_0.to_end_0 = _S55;
    bool _S56 = _S53 < _S55;
    run_0.near_start_0 = _S56;
    int _S57;
    if(_S56)
    {
        _S57 = _S52 - _S50;
    }
    else
    {
        _S57 = _S54;
    }
    int _S58;
    if(run_0.near_start_0)
    {
        _S58 = _S52;
    }
    else
    {
        _S58 = _S54 + _S51;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    float _S59;
    if(run_0.straight_0)
    {
        _S59 = 1.0e+06f;
    }
    else
    {
        _S59 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S59;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S57, _S58), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S48 == int(0);
    run_0.last_crossing_0 = _S49 == int(0);
    return run_0;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_4)
{
    float _S60 = cell_4.half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S61 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S61;
    float _S62 = _S60 * _S60 - square_1(_S61);
    float _S63 = rsqrt(_S62);
    section_0.drop_0 = _S60 - _S62 * _S63;
    section_0.slope_0 = - _S61 * _S63;
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
    bool _S64 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S65 = min(crossed_1.below_0, crossed_1.above_0);
    float _S66;
    if(_S64)
    {
        _S66 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S66 = crossed_1.above_0 + crossed_1.across_0;
    }
    float _S67 = _S66 - crossed_1.half_width_1;
    bool _S68;
    if(_S64)
    {
        _S68 = run_1.first_crossing_0;
    }
    else
    {
        _S68 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S66 = 0.0f;
    }
    else
    {
        _S66 = families_0.Load(other_1).height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, int(0));
    }
    float _S69;
    if((shown_1.on_top_0) != _S68)
    {
        _S69 = 0.0f;
    }
    else
    {
        Family_0 _S70 = families_0.Load(other_1);
        int _S71;
        if(_S64)
        {
            _S71 = int(-1);
        }
        else
        {
            _S71 = int(1);
        }
        _S69 = _S70.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S71);
    }
    float _S72 = 1.0f / max(2.0f * _S67, 9.999999960041972e-13f);
    float _S73 = clamp((_S67 - _S65) * _S72, 0.0f, 1.0f);
    float _S74 = _S66 + (_S69 - _S66) * (_S73 * _S73 * (3.0f - 2.0f * _S73));
    float _S75 = (_S66 - _S69) * (6.0f * _S73 * (1.0f - _S73) * _S72);
    if(_S64)
    {
        _S66 = 1.0f;
    }
    else
    {
        _S66 = -1.0f;
    }
    return float2(_S74, _S75 * _S66);
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

StepControl_0 step_control_0(float2 direction_2, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    float _S76 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S76), 9.99999971718068537e-10f);
    float _S77 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S77), 9.99999971718068537e-10f);
    control_0.right_0 = _S76 > 0.0f;
    control_0.up_0 = _S77 > 0.0f;
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
    float _S78;
    if(forwards_0)
    {
        _S78 = cell_5.across_0;
    }
    else
    {
        _S78 = - cell_5.across_0;
    }
    float _S79;
    if(forwards_0)
    {
        _S79 = cell_5.above_0;
    }
    else
    {
        _S79 = cell_5.below_0;
    }
    bool _S80;
    if(forwards_0)
    {
        _S80 = run_2.last_crossing_0;
    }
    else
    {
        _S80 = run_2.first_crossing_0;
    }
    bool _S81;
    if(forwards_0)
    {
        _S81 = run_2.first_crossing_0;
    }
    else
    {
        _S81 = run_2.last_crossing_0;
    }
    float _S82 = - cell_5.half_width_1;
    bool _S83 = _S78 < _S82;
    bool _S84 = _S78 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S80 = !_S80;
    }
    else
    {
        _S80 = false;
    }
    if(_S80)
    {
        _S80 = !shown_2.hole_0;
    }
    else
    {
        _S80 = false;
    }
    bool _S85;
    if(_S80)
    {
        _S85 = shown_2.on_top_0;
    }
    else
    {
        _S85 = false;
    }
    if(_S85)
    {
        if(_S81)
        {
            _S81 = _S83;
        }
        else
        {
            _S81 = false;
        }
        _S81 = !_S81;
    }
    else
    {
        _S81 = false;
    }
    if(shown_2.hole_0)
    {
        _S80 = true;
    }
    else
    {
        if(_S80)
        {
            _S80 = !shown_2.on_top_0;
        }
        else
        {
            _S80 = false;
        }
    }
    float _S86;
    if(_S83)
    {
        _S86 = _S82;
    }
    else
    {
        _S86 = cell_5.half_width_1;
    }
    float _S87 = _S86 - _S78;
    if(_S80)
    {
        _S78 = 2.0f * _S79 + _S78 - cell_5.half_width_1;
    }
    else
    {
        _S78 = _S79;
    }
    if(_S81)
    {
        if(forwards_0)
        {
            _S78 = run_2.to_end_0;
        }
        else
        {
            _S78 = run_2.from_start_0;
        }
        return _S78;
    }
    if(_S84)
    {
    }
    else
    {
        _S78 = _S87;
    }
    return _S78;
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
    float _S88 = previous_1.rate_0 * step_4;
    float _S89 = rate_1 * step_4;
    bool _S90;
    if(!previous_1.known_0)
    {
        _S90 = true;
    }
    else
    {
        _S90 = here_0.hole_1;
    }
    if(_S90)
    {
        _S90 = true;
    }
    else
    {
        _S90 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S90)
    {
        _S90 = true;
    }
    else
    {
        _S90 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S90)
    {
        _S90 = true;
    }
    else
    {
        _S90 = rate_1 <= 0.0f;
    }
    if(_S90)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S88) >= 0.0f)
    {
        _S90 = (3.0f * clearance_1 - _S89) >= 0.0f;
    }
    else
    {
        _S90 = false;
    }
    if(_S90)
    {
        return -1.0f;
    }
    float _S91 = clearance_1 - previous_1.clearance_0;
    float _S92 = 6.0f * _S91 - 4.0f * _S88 - 2.0f * _S89;
    float _S93 = -2.0f * _S88 / max(_S92 + sqrt(max(_S92 * _S92 - 4.0f * (3.0f * (_S88 + _S89 - 2.0f * _S91)) * _S88, 0.0f)), 9.99999968265522539e-21f);
    float _S94 = 1.0f - _S93;
    float _S95 = (previous_1.clearance_0 * (2.0f * _S93 + 1.0f) + _S88 * _S93) * _S94 * _S94;
    float _S96 = (clearance_1 * (2.0f * _S94 + 1.0f) - _S89 * _S94) * _S93 * _S93;
    if(_S93 > 0.01999999955296516f)
    {
        _S90 = _S94 > 0.01999999955296516f;
    }
    else
    {
        _S90 = false;
    }
    if(_S90)
    {
        _S90 = (_S95 + _S96) < 0.0f;
    }
    else
    {
        _S90 = false;
    }
    float _S97;
    if(_S90)
    {
        _S97 = _S94 * step_4;
    }
    else
    {
        _S97 = -1.0f;
    }
    return _S97;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S98;
    if(here_1.hole_1)
    {
        _S98 = 1.0e+09f;
    }
    else
    {
        _S98 = clearance_2;
    }
    previous_2.clearance_0 = _S98;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S99;
    if(!here_1.hole_1)
    {
        _S99 = !is_cell_exit_0;
    }
    else
    {
        _S99 = false;
    }
    previous_2.known_0 = _S99;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_0, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_1, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S100 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    bool _S101;
    if(!here_2.hole_1)
    {
        _S101 = (rate_3 * _S100 + clearance_3) < 0.0f;
    }
    else
    {
        _S101 = false;
    }
    if(_S101)
    {
        _S101 = _S100 > (2.0f * this_1.epsilon_0);
    }
    else
    {
        _S101 = false;
    }
    float _S102;
    if(_S101)
    {
        _S102 = _S100 - this_1.epsilon_0;
    }
    else
    {
        _S102 = max(_S100, 0.0f) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S102);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(ViewRay_0 this_2, float height_2)
{
    return this_2.origin_0 + this_2.slope_1 * height_2;
}

float ViewRay_rate_0(ViewRay_0 this_3, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_3.slope_1.x + here_3.slope_y_0 * this_3.slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S103 = end_0 - start_1;
    float _S104 = start_rate_0 + end_rate_0 - 2.0f * _S103;
    float _S105 = 3.0f * _S103 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S103, 9.99999968265522539e-21f);
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
        float _S106 = clamp(share_1 - (((_S104 * share_1 + _S105) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S104 * share_1 + 2.0f * _S105) * share_1 + start_rate_0, 0.10000000149011612f * _S103 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S107 = i_0 + int(1);
        share_1 = _S106;
        i_0 = _S107;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S108 = along_slope_0 * along_slope_0 + 1.0f;
    float _S109 = rsqrt(_S108);
    float _S110 = sine_1 * _S109 * rsqrt(_S108 + across_slope_0 * across_slope_0);
    return float2(- _S110 * _S108, _S110 * across_slope_0 * along_slope_0 + cosine_0 * _S109);
}

float arc_sine_0(float x_6)
{
    float _S111 = abs(x_6);
    bool _S112 = _S111 > 0.5f;
    float _S113;
    if(_S112)
    {
        _S113 = 0.5f * (1.0f - _S111);
    }
    else
    {
        _S113 = _S111 * _S111;
    }
    float _S114;
    if(_S112)
    {
        _S114 = sqrt(max(_S113, 0.0f));
    }
    else
    {
        _S114 = _S111;
    }
    float _S115 = ((((0.04216320067644119f * _S113 + 0.02418131195008755f) * _S113 + 0.04547002539038658f) * _S113 + 0.07495300471782684f) * _S113 + 0.16666752099990845f) * _S113 * _S114 + _S114;
    if(_S112)
    {
        _S113 = 1.57079637050628662f - 2.0f * _S115;
    }
    else
    {
        _S113 = _S115;
    }
    if(x_6 < 0.0f)
    {
        _S113 = - _S113;
    }
    return _S113;
}

float3 table_colour_0(uint index_4)
{
    return float3(table_number_0(index_4), table_number_0(index_4 + 1U), table_number_0(index_4 + 2U));
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0)
{
    Albedos_0 albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_0);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_0 + 3U);
    albedos_0.specular_reflect_0 = table_colour_0(row_0 + 6U);
    albedos_0.specular_transmit_0 = table_colour_0(row_0 + 9U);
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_8)
{
    return table_albedos_0(families_0.Load(family_8).albedo_table_0 + families_0.Load(family_8).albedo_stride_0 * thread_8);
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S116 = room_0 / max(albedo_0, (float3)9.99999997475242708e-07f);
    return min(gain_1, max(min(min(_S116.x, _S116.y), _S116.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

Albedos_0 tinted_0(Albedos_0 albedos_1, float3 tint_0)
{
    Albedos_0 result_0 = albedos_1;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

float scene_number_0(uint index_5)
{
    return asfloat(scene_words_0.Load(index_5));
}

struct Choice_0
{
    uint index_6;
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
        uint _S117 = (low_0 + high_0) / 2U;
        if((scene_number_0(table_0 + _S117)) <= number_0)
        {
            low_0 = _S117;
        }
        else
        {
            high_0 = _S117;
        }
    }
    uint _S118 = table_0 + low_0;
    float _S119 = scene_number_0(_S118);
    float _S120 = scene_number_0(_S118 + 1U);
    Choice_0 choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S119) / max(_S120 - _S119, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_7)
{
    float _S121 = floor(x_7 * 0.63661974668502808f + 0.5f);
    float _S122 = x_7 - _S121 * 1.5703125f - _S121 * 0.00048375129699707f - _S121 * 7.54979012640433211e-08f;
    float _S123 = _S122 * _S122;
    float _S124 = ((-0.00019515295571182f * _S123 + 0.00833216123282909f) * _S123 - 0.16666655242443085f) * _S123 * _S122 + _S122;
    float _S125 = ((0.00002443315679557f * _S123 - 0.00138873164542019f) * _S123 + 0.04166664555668831f) * _S123 * _S123 - 0.5f * _S123 + 1.0f;
    uint _S126 = uint(int(_S121)) & 3U;
    float2 _S127;
    if((_S126 & 1U) != 0U)
    {
        _S127 = float2(_S125, _S124);
    }
    else
    {
        _S127 = float2(_S124, _S125);
    }
    float _S128;
    if((_S126 & 2U) != 0U)
    {
        _S128 = - _S127.x;
    }
    else
    {
        _S128 = _S127.x;
    }
    float _S129;
    if(((_S126 + 1U) & 2U) != 0U)
    {
        _S129 = - _S127.y;
    }
    else
    {
        _S129 = _S127.y;
    }
    return float2(_S128, _S129);
}

float diffuse_reflection_0(float3 light_0, float3 normal_1, float blend_0)
{
    float _S130 = light_0.z;
    if(_S130 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp(max(_S130, 0.0f), max(dot(light_0, normal_1), 0.0f), blend_0);
}

float projected_area_1(float3 direction_3, float3 tangent_0, float roughness_1)
{
    float _S131 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S131 * _S131 + 1.0f, roughness_1 * roughness_1));
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S132 = roughness_2 * roughness_2;
    float _S133 = squared_along_0 * (1.0f - _S132) + _S132;
    return 0.31830987334251404f * _S132 * roughness_2 / (_S133 * _S133);
}

float density_between_0(float3 light_1, float3 view_1, float3 tangent_1, float roughness_3)
{
    float3 _S134 = light_1 + view_1;
    float _S135 = dot(_S134, tangent_1);
    return flake_density_0(min(_S135 * _S135 / max(square_0(_S134), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_2, float3 view_2, float3 normal_2, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S136 = dot(light_2, normal_2);
    bool _S137;
    if(_S136 <= 0.0f)
    {
        _S137 = true;
    }
    else
    {
        _S137 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S137)
    {
        return 0.0f;
    }
    float _S138 = max(_S136, 9.99999997475242708e-07f);
    float _S139 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    float _S140 = projected_area_1(light_2, tangent_2, roughness_4) * _S139 + projected_area_1(view_2, tangent_2, roughness_4) * _S138;
    float _S141 = optical_depth_1 * _S140 / (_S138 * _S139);
    return 0.25f * density_between_0(light_2, view_2, tangent_2, roughness_4) * (_S141 * mean_attenuation_0(_S141)) * _S138 / _S140;
}

float transmission_0(float3 light_3, float3 view_3, float3 normal_3, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S142 = - dot(light_3, normal_3);
    float _S143 = dot(view_3, normal_3);
    bool _S144;
    if(_S142 <= 0.0f)
    {
        _S144 = true;
    }
    else
    {
        _S144 = _S143 <= 0.0f;
    }
    if(_S144)
    {
        return 0.0f;
    }
    float _S145 = 1.0f / max(_S143, 9.99999997475242708e-07f);
    float _S146 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S142, 9.99999997475242708e-07f);
    float _S147 = projected_area_1(view_3, tangent_3, roughness_5) * _S145;
    return density_between_0(light_3, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S146, _S147)) * mean_attenuation_0(optical_depth_2 * abs(_S146 - _S147)) * _S145;
}

float sheen_scale_0(float x_8, float y_2)
{
    return (((((0.0f * x_8 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_8 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_8 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_8 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_8 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_8 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_9, float y_3)
{
    return ((((0.0f * x_9 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_9 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_9 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_9 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_9 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_10, float y_4)
{
    return ((((0.0f * x_10 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_10 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_10 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_10 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_10 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S148 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S149 = 2.0f * sqrt(_S148) - 1.0f;
    float _S150 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S149, _S150), 0.00999999977648258f, 1.0f), clamp((1.0f - _S148) * sheen_shear_0(_S149, _S150), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S149, _S150), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_4, float3 view_4, float scale_0, float shear_0)
{
    float _S151 = light_4.z;
    bool _S152;
    if(_S151 <= 0.0f)
    {
        _S152 = true;
    }
    else
    {
        _S152 = (view_4.z) <= 0.0f;
    }
    if(_S152)
    {
        return 0.0f;
    }
    float2 _S153 = view_4.xy;
    float _S154 = dot(_S153, _S153);
    float2 _S155;
    if(_S154 > 9.99999968265522539e-21f)
    {
        _S155 = _S153 * rsqrt(_S154);
    }
    else
    {
        _S155 = float2(1.0f, 0.0f);
    }
    float _S156 = scale_0 * dot(light_4.xy, _S155) + shear_0 * _S151;
    float _S157 = scale_0 * (light_4.y * _S155.x - light_4.x * _S155.y);
    float _S158 = _S156 * _S156 + _S157 * _S157 + _S151 * _S151;
    return 0.31830987334251404f * scale_0 * scale_0 * _S151 / max(_S158 * _S158, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_5, float3 view_5, float strength_0, float roughness_7)
{
    float3 _S159 = sheen_lobe_0(view_5.z, roughness_7);
    float _S160 = strength_0 * _S159.z;
    return float2(_S160 * transformed_cosine_0(light_5, view_5, _S159.x, _S159.y), 1.0f - _S160);
}

void accumulate_0(uint index_7, float4 light_6)
{
    float _S161 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + layers_0[index_7].share_0 * light_6;
    layers_0[index_7].share_0 = _S161 * (1.0f - light_6.w);
    return;
}

float3 camera_right_0(int _S162)
{
    return float3(frames_0[_S162].right_x_0, frames_0[_S162].right_y_0, frames_0[_S162].right_z_0);
}

float3 camera_up_0(int _S163)
{
    return float3(frames_0[_S163].up_x_0, frames_0[_S163].up_y_0, frames_0[_S163].up_z_0);
}

float3 camera_forward_0(int _S164)
{
    return float3(frames_0[_S164].forward_x_0, frames_0[_S164].forward_y_0, frames_0[_S164].forward_z_0);
}

float3 camera_origin_0(int _S165)
{
    return float3(frames_0[_S165].origin_x_0, frames_0[_S165].origin_y_0, frames_0[_S165].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S166, uint _S167, float _S168, float _S169)
{
    uint _S170 = 3U * _S167;
    Vertex_0 _S171 = vertices_0.Load(corners_0.Load(_S170));
    Vertex_0 _S172 = vertices_0.Load(corners_0.Load(_S170 + 1U));
    Vertex_0 _S173 = vertices_0.Load(corners_0.Load(_S170 + 2U));
    float3 _S174 = position_of_0(_S171);
    float3 _S175 = position_of_0(_S172) - _S174;
    float3 _S176 = position_of_0(_S173) - _S174;
    float _S177 = _S172.u_0 - _S171.u_0;
    float _S178 = _S172.v_0 - _S171.v_0;
    float2 _S179 = float2(_S177, _S178);
    float _S180 = _S173.u_0 - _S171.u_0;
    float _S181 = _S173.v_0 - _S171.v_0;
    float2 _S182 = float2(_S180, _S181);
    float _S183;
    if((_S177 * _S181 - _S178 * _S180) < 0.0f)
    {
        _S183 = -1.0f;
    }
    else
    {
        _S183 = 1.0f;
    }
    float3 _S184 = _S183 * (_S181 * _S175 - _S178 * _S176);
    float3 _S185 = _S183 * (_S177 * _S176 - _S180 * _S175);
    VisiblePoint_0 point_1;
    float3 _S186 = normalize((1.0f - _S168 - _S169) * normal_of_0(_S171) + _S168 * normal_of_0(_S172) + _S169 * normal_of_0(_S173));
    point_1.normal_0 = _S186;
    float3 _S187 = normalize(_S184 - _S186 * dot(_S186, _S184));
    point_1.axis_x_0 = _S187;
    point_1.axis_y_0 = cross(_S186, _S187);
    float3 _S188 = normalize(cross(_S175, _S176));
    float3 _S189;
    if((dot(_S188, _S186)) < 0.0f)
    {
        _S189 = - _S188;
    }
    else
    {
        _S189 = _S188;
    }
    point_1.face_normal_0 = _S189;
    point_1.position_0 = _S174 + _S168 * _S175 + _S169 * _S176;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_1 = float2(_S171.u_0, _S171.v_0) + _S168 * _S179 + _S169 * _S182;
    bool _S190 = (dot(cross(_S184, _S185), point_1.normal_0)) < 0.0f;
    float _S191 = fabrics_0[_S166].uv_width_0;
    if(_S190)
    {
        _S183 = - fabrics_0[_S166].uv_height_0;
    }
    else
    {
        _S183 = fabrics_0[_S166].uv_height_0;
    }
    float2 _S192 = float2(_S191, _S183);
    point_1.draft_per_uv_0 = _S192;
    float2 _S193 = point_1.uv_1 * _S192;
    if(_S190)
    {
        _S183 = fabrics_0[_S166].uv_height_0;
    }
    else
    {
        _S183 = 0.0f;
    }
    point_1.draft_0 = _S193 + float2(0.0f, _S183);
    float2 _S194 = (float2)0.0f;
    point_1.draft_dx_0 = _S194;
    point_1.draft_dy_0 = _S194;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S195, uint _S196, uint _S197, uint2 _S198)
{
    uint _S199 = 3U * _S197;
    Vertex_0 _S200 = vertices_0.Load(corners_0.Load(_S199));
    Vertex_0 _S201 = vertices_0.Load(corners_0.Load(_S199 + 1U));
    Vertex_0 _S202 = vertices_0.Load(corners_0.Load(_S199 + 2U));
    float3 _S203 = position_of_0(_S200);
    float3 _S204 = position_of_0(_S201) - _S203;
    float3 _S205 = position_of_0(_S202) - _S203;
    float3 _S206 = cross(_S204, _S205);
    float _S207 = 1.0f / max(square_0(_S206), 1.00000000317107685e-30f);
    float _S208 = float(frames_0[_S195].width_0);
    float3 _S209 = camera_right_0(_S195) * (2.0f / _S208);
    float _S210 = float(frames_0[_S195].height_0);
    float3 _S211 = camera_up_0(_S195) * (-2.0f / _S210);
    float3 _S212 = camera_forward_0(_S195) + (float(_S198.x) + 0.5f - 0.5f * _S208) * _S209 + (float(_S198.y) + 0.5f - 0.5f * _S210) * _S211;
    float _S213 = dot(_S212, _S206);
    float _S214;
    if((abs(_S213)) > 1.00000000317107685e-30f)
    {
        _S214 = _S213;
    }
    else
    {
        _S214 = 1.00000000317107685e-30f;
    }
    float _S215 = 1.0f / _S214;
    float3 _S216 = _S203 - camera_origin_0(_S195);
    float _S217 = dot(_S216, _S206) * _S215;
    float3 _S218 = _S212 * _S217 - _S216;
    float3 _S219 = _S217 * (_S209 - _S212 * (dot(_S209, _S206) * _S215));
    float3 _S220 = _S217 * (_S211 - _S212 * (dot(_S211, _S206) * _S215));
    float3 _S221 = cross(_S205, _S206) * _S207;
    float3 _S222 = cross(_S206, _S204) * _S207;
    float2 _S223 = float2(_S201.u_0 - _S200.u_0, _S201.v_0 - _S200.v_0);
    float2 _S224 = float2(_S202.u_0 - _S200.u_0, _S202.v_0 - _S200.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S196, _S197, dot(_S218, _S221), dot(_S218, _S222));
    point_2.position_0 = _S203 + _S218;
    point_2.view_0 = - normalize(_S212);
    point_2.draft_dx_0 = (dot(_S219, _S221) * _S223 + dot(_S219, _S222) * _S224) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S220, _S221) * _S223 + dot(_S220, _S222) * _S224) * point_2.draft_per_uv_0;
    return point_2;
}

float3 filtered_albedo_0(uint _S225, VisiblePoint_0 _S226)
{
    uint _S227 = fabrics_0[_S225].albedo_map_levels_0;
    if((fabrics_0[_S225].albedo_map_levels_0) == 0U)
    {
        return (float3)1.0f;
    }
    float2 _S228 = float2(fabrics_0[_S225].uv_width_0, fabrics_0[_S225].uv_height_0);
    float2 _S229 = _S226.draft_dx_0 / _S228;
    float2 _S230 = _S226.draft_dy_0 / _S228;
    uint _S231 = _S227 - 1U;
    uint _S232 = 1U << _S231;
    float _S233 = clamp(0.5f * binary_logarithm_0(max(abs(_S229.x * _S230.y - _S229.y * _S230.x), 9.99999968265522539e-21f) * (square_1(float(_S232)) / 3.0f)), 0.0f, float(_S227) - 1.0f);
    uint _S234 = min(uint(_S233), max(_S227, 2U) - 2U);
    uint _S235 = min(_S234 + 1U, _S231);
    uint _S236 = 1U << (2U * _S227);
    return lerp(map_level_0(fabrics_0[_S225].albedo_map_0 + (_S236 - (_S236 >> (2U * _S234))) / 3U, _S232 >> _S234, _S226.uv_1), map_level_0(fabrics_0[_S225].albedo_map_0 + (_S236 - (_S236 >> (2U * _S235))) / 3U, _S232 >> _S235, _S226.uv_1), (float3)((exponential_0(1.38629436492919922f * (_S233 - float(_S234))) - 1.0f) / 3.0f));
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_2;
    bool is_warp_1;
    float x_11;
    float y_5;
    float height_3;
    float3 normal_4;
    float3 tangent_4;
    float roughness_8;
    Albedos_0 albedos_2;
};

struct Hit_0
{
    float x_12;
    float y_6;
    bool hole_3;
    float height_4;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_5;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S237, float _S238, float _S239, bool _S240)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0[_S237].warp_0, _S238);
    crossing_2.weft_1 = locate_0(fabrics_0[_S237].weft_0, _S239);
    uint _S241 = fabrics_0[_S237].run_words_0 + 2U * (crossing_2.weft_1.thread_1 * fabrics_0[_S237].ends_1 + crossing_2.warp_1.thread_1);
    uint _S242 = words_0.Load(_S241);
    crossing_2.warp_word_0 = _S242;
    crossing_2.weft_word_0 = words_0.Load(_S241 + 1U);
    crossing_2.warp_above_0 = ((_S242 & 1U) == 1U) != _S240;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S243, float _S244, float _S245, bool _S246)
{
    Sample_0 sample_0;
    Crossing_0 _S247 = crossing_at_0(_S243, _S244, _S245, _S246);
    sample_0.crossing_1 = _S247;
    Shown_0 _S248 = shown_at_0(_S247, _S246);
    sample_0.shown_3 = _S248;
    uint _S249;
    if(_S248.is_warp_0)
    {
        _S249 = fabrics_0[_S243].warp_0;
    }
    else
    {
        _S249 = fabrics_0[_S243].weft_0;
    }
    uint _S250;
    if(_S248.is_warp_0)
    {
        _S250 = fabrics_0[_S243].weft_0;
    }
    else
    {
        _S250 = fabrics_0[_S243].warp_0;
    }
    Cell_0 _S251 = select_cell_0(_S248.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    Cell_0 _S252 = select_cell_0(_S248.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    Run_0 _S253 = unpack_0(_S249, _S250, _S251.thread_1, _S252, _S248.word_0);
    Section_0 _S254 = section_at_0(_S251);
    bool _S255;
    if(_S248.on_top_0)
    {
        _S255 = (_S253.distance_0) < (_S254.drop_0 * _S253.bend_1.sine_0);
    }
    else
    {
        _S255 = false;
    }
    bool _S256;
    if(_S248.on_top_0)
    {
        _S256 = !_S255;
    }
    else
    {
        _S256 = false;
    }
    float _S257;
    if(_S256)
    {
        _S257 = 1.0f;
    }
    else
    {
        _S257 = -1.0f;
    }
    float _S258;
    if(_S255)
    {
        _S258 = _S253.other_reach_0;
    }
    else
    {
        _S258 = _S253.reach_0;
    }
    float _S259;
    if(_S255)
    {
        _S259 = _S258 + _S253.distance_0;
    }
    else
    {
        _S259 = max(_S258 - _S253.distance_0, 0.0f);
    }
    float _S260 = _S258 / _S253.bend_1.sine_0 - _S257 * _S254.drop_0;
    float _S261 = _S259 * _S259;
    float _S262 = max(_S260 * _S260 - _S261, 9.99999968265522539e-21f);
    float _S263 = rsqrt(_S262);
    float _S264 = _S261 / (_S262 * _S263 + _S260);
    bool _S265 = _S259 > 0.0f;
    float _S266;
    if(_S248.on_top_0)
    {
        _S266 = 1.0f;
    }
    else
    {
        _S266 = -1.0f;
    }
    float _S267;
    if(_S253.near_start_0)
    {
        _S267 = 1.0f;
    }
    else
    {
        _S267 = -1.0f;
    }
    float _S268 = _S266 * _S267;
    if(_S265)
    {
        _S266 = _S260 * _S263;
    }
    else
    {
        _S266 = 1.0f;
    }
    sample_0.slope_across_0 = _S254.slope_0 * _S266;
    if(_S265)
    {
        _S259 = _S268 * _S259 * _S263;
    }
    else
    {
        _S259 = 0.0f;
    }
    sample_0.slope_along_0 = _S259;
    Family_0 _S269 = families_0.Load(_S249);
    float2 _S270 = dive_0(_S250, _S248, _S253, _S252);
    if(_S253.straight_0)
    {
        _S257 = 0.0f;
    }
    else
    {
        _S257 = _S269.height_scale_0 * _S257;
    }
    sample_0.height_5 = _S257 * (_S258 * _S253.bend_1.half_tangent_0 - _S264) - _S269.height_scale_0 * _S254.drop_0 - _S270.x;
    float _S271 = _S269.height_scale_0 * sample_0.slope_across_0;
    float _S272 = _S269.height_scale_0 * sample_0.slope_along_0 - _S270.y;
    if(_S248.is_warp_0)
    {
        _S257 = _S271;
    }
    else
    {
        _S257 = _S272;
    }
    sample_0.slope_x_1 = _S257;
    if(_S248.is_warp_0)
    {
        _S257 = _S272;
    }
    else
    {
        _S257 = _S271;
    }
    sample_0.slope_y_1 = _S257;
    sample_0.run_3 = _S253;
    sample_0.section_1 = _S254;
    return sample_0;
}

float steps_per_length_0(uint _S273, SearchQuality_0 _S274, float3 _S275)
{
    return max(max(abs(_S275.x) * fabrics_0[_S273].threads_per_x_0, abs(_S275.y) * fabrics_0[_S273].threads_per_y_0) * _S274.steps_per_thread_0, abs(_S275.z) * fabrics_0[_S273].per_relief_0 * _S274.steps_per_relief_0);
}

float cell_maximum_0(uint _S276, Crossing_0 _S277)
{
    uint _S278;
    if(_S277.warp_above_0)
    {
        _S278 = fabrics_0[_S276].warp_0;
    }
    else
    {
        _S278 = fabrics_0[_S276].weft_0;
    }
    uint _S279;
    if(_S277.warp_above_0)
    {
        _S279 = _S277.warp_word_0;
    }
    else
    {
        _S279 = _S277.weft_word_0;
    }
    return float(_S279 >> int(28)) * families_0.Load(_S278).height_scale_0 * families_0.Load(_S278).level_0;
}

Probe_0 probe_0(uint _S280, float _S281, float _S282, bool _S283, bool _S284, bool _S285)
{
    Sample_0 _S286 = sample_at_0(_S280, _S281, _S282, _S283);
    Probe_0 probe_1;
    probe_1.height_1 = _S286.height_5;
    probe_1.hole_1 = _S286.shown_3.hole_0;
    probe_1.slope_x_0 = _S286.slope_x_1;
    probe_1.slope_y_0 = _S286.slope_y_1;
    uint _S287;
    if(_S286.shown_3.is_warp_0)
    {
        _S287 = _S286.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S287 = _S286.crossing_1.weft_1.thread_1 * 2U;
    }
    probe_1.yarn_1 = _S287;
    probe_1.cell_max_0 = cell_maximum_0(_S280, _S286.crossing_1);
    float _S288;
    if(_S284)
    {
        _S288 = _S286.crossing_1.warp_1.above_0;
    }
    else
    {
        _S288 = _S286.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S288;
    if(_S285)
    {
        _S288 = _S286.crossing_1.weft_1.above_0;
    }
    else
    {
        _S288 = _S286.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S288;
    probe_1.edge_x_0 = outline_distance_0(_S286.crossing_1.warp_1, _S286.shown_3, _S286.run_3, !_S286.shown_3.is_warp_0, _S284);
    probe_1.edge_y_0 = outline_distance_0(_S286.crossing_1.weft_1, _S286.shown_3, _S286.run_3, _S286.shown_3.is_warp_0, _S285);
    return probe_1;
}

bool is_free_0(uint _S289, SearchQuality_0 _S290, float3 _S291, float3 _S292, bool _S293, float _S294)
{
    float _S295 = _S292.z;
    if(_S295 <= 0.0f)
    {
        return false;
    }
    float _S296 = 1.0f / max(_S290.shadow_share_0 * steps_per_length_0(_S289, _S290, _S292), 9.99999971718068537e-10f);
    StepControl_0 _S297 = step_control_0(_S292.xy, _S296);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_2 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S298;
        if(count_2 < 1024U)
        {
            _S298 = (_S291.z + _S295 * distance_1) < _S294;
        }
        else
        {
            _S298 = false;
        }
        if(_S298)
        {
        }
        else
        {
            break;
        }
        float3 _S299 = _S291 + _S292 * distance_1;
        Probe_0 _S300 = probe_0(_S289, _S299.x, _S299.y, _S293, _S297.right_0, _S297.up_0);
        float _S301 = _S299.z;
        float _S302 = _S301 - _S300.height_1;
        float _S303 = _S295 - _S300.slope_x_0 * _S292.x - _S300.slope_y_0 * _S292.y;
        bool _S304;
        if(!_S300.hole_1)
        {
            _S304 = _S302 < 0.0f;
        }
        else
        {
            _S304 = false;
        }
        if(_S304)
        {
            return false;
        }
        float _S305 = way_back_to_dip_0(previous_3, _S302, _S303, last_step_0, _S300);
        if(_S305 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S305;
            distance_1 = distance_1 - _S305;
            last_step_0 = last_step_1;
            count_2 = count_2 + 1U;
            continue;
        }
        bool _S306 = _S301 > (_S300.cell_max_0);
        PreviousSample_0 _S307 = after_sample_0(_S302, _S303, _S300, _S306);
        float last_step_2;
        if(_S306)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S297, _S300.side_x_0, _S300.side_y_0), _S296);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S297, _S300, _S302, _S303);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S307;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S308, SearchQuality_0 _S309, float _S310, float _S311, float3 _S312, bool _S313)
{
    if(!sample_at_0(_S308, _S310, _S311, _S313).shown_3.hole_0)
    {
        return false;
    }
    float3 _S314 = float3(_S310, _S311, 0.0f);
    bool passes_0 = true;
    uint side_1 = 0U;
    for(;;)
    {
        bool _S315;
        if(side_1 < 2U)
        {
            _S315 = passes_0;
        }
        else
        {
            _S315 = false;
        }
        if(_S315)
        {
        }
        else
        {
            break;
        }
        float3 _S316;
        if(side_1 == 0U)
        {
            _S316 = _S312;
        }
        else
        {
            _S316 = float3(- _S312.x, - _S312.y, _S312.z);
        }
        bool _S317 = is_free_0(_S308, _S309, _S314, _S316, _S313 != (side_1 == 1U), fabrics_0[_S308].height_high_0);
        uint _S318 = side_1 + 1U;
        passes_0 = _S317;
        side_1 = _S318;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_6;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

float max_height_along_0(uint _S319, float _S320, float _S321, float _S322, float3 _S323, bool _S324)
{
    uint _S325 = locate_0(fabrics_0[_S319].warp_0, _S320).thread_1 / 2U;
    uint _S326 = locate_0(fabrics_0[_S319].weft_0, _S321).thread_1 / 2U;
    float _S327 = _S323.x;
    uint _S328;
    if(_S327 > 0.0f)
    {
        _S328 = 1U;
    }
    else
    {
        _S328 = 0U;
    }
    float _S329 = _S323.y;
    uint _S330;
    if(_S329 > 0.0f)
    {
        _S330 = 2U;
    }
    else
    {
        _S330 = 0U;
    }
    uint _S331 = words_0.Load(fabrics_0[_S319].max_heights_0 + 4U * (_S326 * fabrics_0[_S319].max_height_columns_0 + _S325) + (_S328 + _S330));
    int number_1;
    if(_S324)
    {
        number_1 = int(4);
    }
    else
    {
        number_1 = int(0);
    }
    uint _S332 = _S331 >> number_1;
    float _S333 = max(abs(_S327) * fabrics_0[_S319].threads_per_x_0, abs(_S329) * fabrics_0[_S319].threads_per_y_0) / _S323.z;
    float _S334 = fabrics_0[_S319].height_high_0;
    float max_height_0 = fabrics_0[_S319].height_high_0;
    number_1 = int(3);
    for(;;)
    {
        if(number_1 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S322) * _S333) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, float((_S332 >> uint(int(8) * number_1)) & 15U) * 0.06666667014360428f * _S334);
        }
        number_1 = number_1 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S335, float _S336, float _S337, bool _S338, bool _S339, bool _S340)
{
    Crossing_0 _S341 = crossing_at_0(_S335, _S336, _S337, _S338);
    float _S342 = cell_maximum_0(_S335, _S341);
    float _S343;
    if(_S339)
    {
        _S343 = _S341.warp_1.above_0;
    }
    else
    {
        _S343 = _S341.warp_1.below_0;
    }
    float _S344;
    if(_S340)
    {
        _S344 = _S341.weft_1.above_0;
    }
    else
    {
        _S344 = _S341.weft_1.below_0;
    }
    return float3(_S342, _S343, _S344);
}

float first_sample_height_0(uint _S345, ViewRay_0 _S346, StepControl_0 _S347, bool _S348)
{
    float _S349 = max_height_along_0(_S345, _S346.origin_0.x, _S346.origin_0.y, 0.0f, float3(_S346.slope_1, 1.0f), _S348);
    uint count_3 = 0U;
    float height_7 = _S349;
    for(;;)
    {
        if(count_3 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S350 = ViewRay_at_0(_S346, height_7);
        float3 _S351 = cell_bounds_0(_S345, _S350.x, _S350.y, _S348, _S347.right_0, _S347.up_0);
        float _S352 = height_7 - _S351.x;
        float _S353 = StepControl_to_cell_exit_0(_S347, _S351.y, _S351.z);
        float height_8 = height_7 - clamp(_S352, 0.0f, _S353);
        if(_S352 <= _S353)
        {
            height_7 = height_8;
            break;
        }
        count_3 = count_3 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S354, ViewRay_0 _S355, StepControl_0 _S356, bool _S357)
{
    float _S358 = fabrics_0[_S354].height_low_0 - (fabrics_0[_S354].height_high_0 - fabrics_0[_S354].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_6 = first_sample_height_0(_S354, _S355, _S356, _S357);
    end_1.last_step_3 = _S356.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    uint count_4 = 0U;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S359 = ViewRay_at_0(_S355, end_1.height_6);
        Probe_0 _S360 = probe_0(_S354, _S359.x, _S359.y, _S357, _S356.right_0, _S356.up_0);
        float _S361 = end_1.height_6 - _S360.height_1;
        float _S362 = ViewRay_rate_0(_S355, _S360);
        end_1.depth_1 = - _S361;
        end_1.rate_4 = _S362;
        bool _S363;
        if(end_1.previous_4.known_0)
        {
            _S363 = !_S360.hole_1;
        }
        else
        {
            _S363 = false;
        }
        bool _S364;
        if(_S363)
        {
            _S364 = (end_1.previous_4.yarn_0) == (_S360.yarn_1);
        }
        else
        {
            _S364 = false;
        }
        end_1.smooth_0 = _S364;
        bool _S365;
        if(!_S360.hole_1)
        {
            _S365 = _S361 <= 0.0f;
        }
        else
        {
            _S365 = false;
        }
        bool _S366;
        if(_S365)
        {
            _S366 = true;
        }
        else
        {
            _S366 = (end_1.height_6) <= _S358;
        }
        if(_S366)
        {
            break;
        }
        float _S367 = way_back_to_dip_0(end_1.previous_4, _S361, _S362, end_1.last_step_3, _S360);
        if(_S367 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S367;
            end_1.last_step_3 = end_1.last_step_3 - _S367;
            count_4 = count_4 + 1U;
            continue;
        }
        float _S368 = min(StepControl_to_cell_exit_0(_S356, _S360.side_x_0, _S360.side_y_0), end_1.height_6 - _S360.cell_max_0);
        float _S369 = StepControl_to_next_sample_0(_S356, _S360, _S361, _S362);
        end_1.previous_4 = after_sample_0(_S361, _S362, _S360, _S368 > _S369);
        float _S370 = max(_S368, _S369);
        end_1.last_step_3 = _S370;
        end_1.height_6 = end_1.height_6 - _S370;
        count_4 = count_4 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S371, ViewRay_0 _S372, StepControl_0 _S373, bool _S374, ViewRayEnd_0 _S375, uint _S376)
{
    float _S377 = fabrics_0[_S371].height_high_0 - fabrics_0[_S371].height_low_0;
    float above_2 = _S375.height_6 + _S375.last_step_3;
    float above_gap_1 = clamp(_S375.previous_4.clearance_0, 0.0f, _S377);
    float under_gap_1 = clamp(_S375.depth_1, 0.0f, _S377);
    float _S378 = cubic_root_0(above_gap_1, - under_gap_1, _S375.previous_4.rate_0 * _S375.last_step_3, _S375.rate_4 * _S375.last_step_3);
    float middle_0;
    if(_S375.smooth_0)
    {
        middle_0 = above_2 - _S378 * _S375.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S375.height_6, above_gap_1, under_gap_1);
    }
    float side_2 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S375.height_6;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S376)
        {
        }
        else
        {
            break;
        }
        float2 _S379 = ViewRay_at_0(_S372, middle_0);
        Probe_0 _S380 = probe_0(_S371, _S379.x, _S379.y, _S374, _S373.right_0, _S373.up_0);
        float _S381;
        if(_S380.hole_1)
        {
            _S381 = -1.0e+09f;
        }
        else
        {
            _S381 = _S380.height_1;
        }
        float _S382 = clamp(middle_0 - _S381, - _S377, _S377);
        float _S383;
        if(_S382 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S383 = 0.5f * above_gap_2;
            }
            else
            {
                _S383 = above_gap_2;
            }
            float _S384 = - _S382;
            under_1 = middle_0;
            above_gap_2 = _S383;
            under_gap_2 = _S384;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S383 = 0.5f * under_gap_2;
            }
            else
            {
                _S383 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S382;
            under_gap_2 = _S383;
            side_2 = -1.0f;
        }
        if(_S375.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S382 / min(ViewRay_rate_0(_S372, _S380), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S375.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S385, SearchQuality_0 _S386, float _S387, float _S388, float3 _S389, bool _S390)
{
    float _S391 = max(_S389.z, 0.00009999999747379f);
    ViewRay_0 ray_0;
    ray_0.origin_0 = float2(_S387, _S388);
    float2 _S392 = _S389.xy / _S391;
    ray_0.slope_1 = _S392;
    StepControl_0 _S393 = step_control_0(- _S392, 1.0f / max(steps_per_length_0(_S385, _S386, _S389) / _S391, 9.99999971718068537e-10f));
    ViewRayEnd_0 _S394 = search_down_0(_S385, ray_0, _S393, _S390);
    Hit_0 hit_0;
    hit_0.hole_3 = false;
    float _S395 = refined_height_0(_S385, ray_0, _S393, _S390, _S394, _S386.refinements_0);
    hit_0.height_4 = _S395;
    float2 _S396 = ViewRay_at_0(ray_0, _S395);
    hit_0.x_12 = _S396.x;
    hit_0.y_6 = _S396.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S397, SearchQuality_0 _S398, float _S399, float _S400, float3 _S401, bool _S402)
{
    if(!passes_through_0(_S397, _S398, _S399, _S400, _S401, _S402))
    {
        return first_hit_of_yarn_0(_S397, _S398, _S399, _S400, _S401, _S402);
    }
    Hit_0 hit_1;
    hit_1.x_12 = _S399;
    hit_1.y_6 = _S400;
    hit_1.height_4 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_2;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_9;
    float3 normal_5;
    float3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S403, float _S404, float _S405, bool _S406)
{
    Sample_0 _S407 = sample_at_0(_S403, _S404, _S405, _S406);
    float _S408;
    if(_S407.shown_3.is_warp_0)
    {
        _S408 = _S407.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S408 = _S407.crossing_1.weft_1.half_width_1;
    }
    uint _S409;
    if(_S407.shown_3.is_warp_0)
    {
        _S409 = fabrics_0[_S403].warp_0;
    }
    else
    {
        _S409 = fabrics_0[_S403].weft_0;
    }
    Family_0 _S410 = families_0.Load(_S409);
    float _S411;
    if(_S406)
    {
        _S411 = -1.0f;
    }
    else
    {
        _S411 = 1.0f;
    }
    float _S412 = _S410.twist_sine_0 * _S411;
    Family_0 _S413 = families_0.Load(_S409);
    if(_S407.shown_3.is_warp_0)
    {
        _S411 = 1.0f;
    }
    else
    {
        _S411 = -1.0f;
    }
    float2 _S414 = fibre_direction_0(_S407.slope_across_0, _S411 * _S407.slope_along_0, _S412, _S413.twist_cosine_0);
    float _S415;
    if(_S407.shown_3.is_warp_0)
    {
        _S415 = _S407.slope_x_1;
    }
    else
    {
        _S415 = _S407.slope_y_1;
    }
    float _S416;
    if(_S407.shown_3.is_warp_0)
    {
        _S416 = _S407.slope_y_1;
    }
    else
    {
        _S416 = _S407.slope_x_1;
    }
    float _S417 = _S414.x;
    float _S418 = _S414.y;
    float _S419 = _S415 * _S417 + _S411 * _S416 * _S418;
    float _S420 = _S408 * 1.0154266357421875f;
    float _S421 = _S420 * arc_sine_0(clamp(_S407.section_1.across_1 / _S420, -1.0f, 1.0f));
    if(_S407.shown_3.is_warp_0)
    {
        _S408 = _S405;
    }
    else
    {
        _S408 = - _S404;
    }
    SurfacePoint_0 point_3;
    point_3.hole_4 = _S407.shown_3.hole_0;
    point_3.is_warp_2 = _S407.shown_3.is_warp_0;
    point_3.warp_thread_0 = _S407.crossing_1.warp_1.thread_1;
    point_3.weft_thread_0 = _S407.crossing_1.weft_1.thread_1;
    point_3.height_9 = _S407.height_5;
    point_3.normal_5 = normalize(float3(- _S407.slope_x_1, - _S407.slope_y_1, 1.0f));
    float3 _S422;
    if(_S407.shown_3.is_warp_0)
    {
        _S422 = float3(_S417, _S418, _S419);
    }
    else
    {
        _S422 = float3(- _S418, _S417, _S419);
    }
    point_3.tangent_5 = normalize(_S422);
    point_3.across_2 = _S407.section_1.across_1;
    point_3.fibre_across_0 = _S421 * _S413.twist_cosine_0 + _S408 * _S412;
    point_3.fibre_along_0 = _S408 * _S413.twist_cosine_0 - _S421 * _S412;
    return point_3;
}

Albedos_0 vary_albedos_0(uint _S423, Albedos_0 _S424, uint _S425, uint _S426)
{
    float3 _S427 = max(_S424.specular_reflect_0, _S424.specular_transmit_0);
    float3 _S428 = _S424.diffuse_reflect_0 + _S424.diffuse_transmit_0;
    float _S429 = bounded_gain_0(thread_gain_0(_S425, fabrics_0[_S423].colour_noise_0, fabrics_0[_S423].seed_0), _S428, 1.0f - fabrics_0[_S423].layer_bound_0 * _S427);
    float _S430 = bounded_gain_0(fibre_gain_0(_S425, _S426, fabrics_0[_S423].fibre_noise_0, fabrics_0[_S423].seed_0), _S427, min((1.0f - _S429 * _S428) / fabrics_0[_S423].layer_bound_0, (float3)1.0f));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S429 * _S424.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S429 * _S424.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S430 * _S424.specular_reflect_0;
    varied_0.specular_transmit_0 = _S430 * _S424.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S431, SurfacePoint_0 _S432, Albedos_0 _S433, float _S434, float _S435)
{
    float _S436;
    if(_S432.is_warp_2)
    {
        _S436 = _S434;
    }
    else
    {
        _S436 = _S435;
    }
    float _S437 = _S436 - _S432.across_2;
    uint _S438;
    if(_S432.is_warp_2)
    {
        _S438 = fabrics_0[_S431].warp_0;
    }
    else
    {
        _S438 = fabrics_0[_S431].weft_0;
    }
    Family_0 _S439 = families_0.Load(_S438);
    int _S440 = int(families_0.Load(_S438).count_0);
    if(_S432.is_warp_2)
    {
        _S438 = _S432.warp_thread_0;
    }
    else
    {
        _S438 = _S432.weft_thread_0;
    }
    uint _S441 = uint(int(floor(_S437 / _S439.period_0)) * _S440 + int(_S438)) * 2U;
    if(_S432.is_warp_2)
    {
        _S438 = 1U;
    }
    else
    {
        _S438 = 0U;
    }
    float _S442 = floor(_S432.fibre_across_0 / fabrics_0[_S431].fibre_size_0);
    return vary_albedos_0(_S431, _S433, _S441 + _S438, uint(int(_S442)) * 65536U + uint(int(floor(_S432.fibre_along_0 / (fabrics_0[_S431].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S442))));
}

YarnPoint_0 yarn_point_of_0(uint _S443, SurfacePoint_0 _S444, float _S445, float _S446, bool _S447, bool _S448)
{
    uint _S449;
    if(_S444.is_warp_2)
    {
        _S449 = fabrics_0[_S443].warp_0;
    }
    else
    {
        _S449 = fabrics_0[_S443].weft_0;
    }
    uint _S450;
    if(_S444.is_warp_2)
    {
        _S450 = _S444.warp_thread_0;
    }
    else
    {
        _S450 = _S444.weft_thread_0;
    }
    Albedos_0 albedos_3 = albedos_of_0(_S449, _S450);
    bool _S451;
    if((fabrics_0[_S443].fibre_noise_0) > 0.0f)
    {
        _S451 = true;
    }
    else
    {
        _S451 = (fabrics_0[_S443].colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_4;
    if(_S451)
    {
        albedos_4 = varied_at_0(_S443, _S444, albedos_3, _S445, _S446);
    }
    else
    {
        albedos_4 = albedos_3;
    }
    YarnPoint_0 point_4;
    point_4.back_3 = _S447;
    point_4.hole_2 = _S448;
    point_4.is_warp_1 = _S444.is_warp_2;
    point_4.x_11 = _S445;
    point_4.y_5 = _S446;
    point_4.height_3 = _S444.height_9;
    point_4.normal_4 = _S444.normal_5;
    point_4.tangent_4 = _S444.tangent_5;
    point_4.roughness_8 = families_0.Load(_S449).roughness_0;
    point_4.albedos_2 = albedos_4;
    return point_4;
}

YarnPoint_0 locate_yarn_0(uint _S452, SearchQuality_0 _S453, float _S454, float _S455, float3 _S456)
{
    bool _S457 = (_S456.z) < 0.0f;
    Hit_0 _S458 = first_hit_0(_S452, _S453, _S454, _S455, to_face_frame_0(_S456, _S457), _S457);
    return yarn_point_of_0(_S452, surface_at_0(_S452, _S458.x_12, _S458.y_6, _S457), _S458.x_12, _S458.y_6, _S457, _S458.hole_3);
}

uint light_sample_count_0(int _S459)
{
    return frames_0[_S459].lights_0 + frames_0[_S459].environment_samples_0;
}

float visibility_at_0(int _S460, uint _S461, uint2 _S462)
{
    if((frames_0[_S460].casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return visibilities_0[(_S461 * frames_0[_S460].height_0 + _S462.y) * frames_0[_S460].width_0 + _S462.x];
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_3;
};

float3 environment_texel_0(int _S463, uint _S464, uint _S465)
{
    uint _S466 = frames_0[_S463].environment_table_0 + frames_0[_S463].environment_rows_0 + 1U + frames_0[_S463].environment_rows_0 * (frames_0[_S463].environment_columns_0 + 1U) + 3U * (_S464 * frames_0[_S463].environment_columns_0 + _S465);
    return float3(scene_number_0(_S466), scene_number_0(_S466 + 1U), scene_number_0(_S466 + 2U));
}

float3 sample_environment_0(int _S467, float2 _S468, out float3 _S469)
{
    uint _S470 = frames_0[_S467].environment_rows_0;
    Choice_0 _S471 = choose_0(frames_0[_S467].environment_table_0, frames_0[_S467].environment_rows_0, _S468.y);
    uint _S472 = frames_0[_S467].environment_columns_0;
    Choice_0 _S473 = choose_0(frames_0[_S467].environment_table_0 + frames_0[_S467].environment_rows_0 + 1U + _S471.index_6 * (frames_0[_S467].environment_columns_0 + 1U), frames_0[_S467].environment_columns_0, _S468.x);
    float3 _S474 = environment_texel_0(_S467, _S471.index_6, _S473.index_6);
    _S469 = _S474 * (frames_0[_S467].environment_total_0 / max(mean_0(_S474), 9.99999968265522539e-21f));
    float _S475 = 3.14159274101257324f / float(_S470);
    float _S476 = lerp(sine_cosine_0(float(_S471.index_6) * _S475).y, sine_cosine_0(float(_S471.index_6 + 1U) * _S475).y, _S471.remainder_0);
    float _S477 = sqrt(max(1.0f - _S476 * _S476, 0.0f));
    float2 _S478 = sine_cosine_0((float(_S473.index_6) + _S473.remainder_0) * (6.28318548202514648f / float(_S472)));
    float _S479 = _S477 * _S478.x;
    float _S480 = - _S477 * _S478.y;
    return float3(frames_0[_S467].environment_cosine_0 * _S479 + frames_0[_S467].environment_sine_0 * _S480, _S476, frames_0[_S467].environment_cosine_0 * _S480 - frames_0[_S467].environment_sine_0 * _S479);
}

LightSample_0 light_sample_0(int _S481, uint _S482, uint2 _S483, float3 _S484)
{
    LightSample_0 sample_1;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    uint _S485 = frames_0[_S481].lights_0;
    if(_S482 >= (frames_0[_S481].lights_0))
    {
        float3 weight_0;
        float3 _S486 = sample_environment_0(_S481, pixel_sequence_0(_S483, frames_0[_S481].pass_number_0 * frames_0[_S481].environment_samples_0 + (_S482 - _S485), 3U), weight_0);
        sample_1.towards_0 = _S486;
        sample_1.irradiance_1 = weight_0 / float(frames_0[_S481].environment_samples_0);
        return sample_1;
    }
    Light_0 _S487 = lights_1.Load(_S482);
    sample_1.irradiance_1 = float3(_S487.red_0, _S487.green_0, _S487.blue_0);
    sample_1.towards_0 = float3(_S487.x_1, _S487.y_1, _S487.z_1);
    if((_S487.is_point_0) != 0U)
    {
        float3 _S488 = sample_1.towards_0 - _S484;
        float _S489 = max(square_0(_S488), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S489);
        sample_1.irradiance_1 = sample_1.irradiance_1 / _S489;
        sample_1.towards_0 = normalize(_S488);
    }
    return sample_1;
}

float3 scattered_0(uint _S490, YarnPoint_0 _S491, float3 _S492, float3 _S493)
{
    float3 _S494 = (float3)0.0f;
    bool _S495 = !_S491.hole_2;
    bool _S496;
    if(_S495)
    {
        _S496 = (_S492.z) > 0.0f;
    }
    else
    {
        _S496 = false;
    }
    float3 value_1;
    if(_S496)
    {
        value_1 = _S491.albedos_2.diffuse_reflect_0 * diffuse_reflection_0(_S492, _S491.normal_4, fabrics_0[_S490].diffuse_blend_0) + _S491.albedos_2.specular_reflect_0 * reflection_0(_S492, _S493, _S491.normal_4, _S491.tangent_4, _S491.roughness_8, fabrics_0[_S490].optical_depth_0);
    }
    else
    {
        if(_S495)
        {
            _S496 = (_S492.z) < 0.0f;
        }
        else
        {
            _S496 = false;
        }
        if(_S496)
        {
            value_1 = _S491.albedos_2.diffuse_transmit_0 * diffuse_reflection_0(- _S492, _S491.normal_4, fabrics_0[_S490].diffuse_blend_0) + _S491.albedos_2.specular_transmit_0 * transmission_0(_S492, _S493, _S491.normal_4, _S491.tangent_4, _S491.roughness_8, fabrics_0[_S490].optical_depth_0);
        }
        else
        {
            value_1 = _S494;
        }
    }
    float _S497 = fabrics_0[_S490].sheen_strength_0;
    if((fabrics_0[_S490].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S498 = sheen_with_transmittance_0(_S492, _S493, _S497, fabrics_0[_S490].sheen_roughness_0);
    return _S498.y * value_1 + _S498.x;
}

bool unoccluded_0(uint _S499, SearchQuality_0 _S500, float _S501, float _S502, float _S503, float3 _S504, bool _S505)
{
    if((_S504.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S499, _S500, float3(_S501, _S502, _S503 + fabrics_0[_S499].lift_0), _S504, _S505, max_height_along_0(_S499, _S501, _S502, _S503, _S504, _S505));
}

bool is_lit_0(uint _S506, SearchQuality_0 _S507, YarnPoint_0 _S508, float3 _S509)
{
    if(_S508.hole_2)
    {
        return true;
    }
    float3 _S510 = to_face_frame_0(_S509, _S508.back_3);
    float _S511 = _S510.z;
    bool _S512 = _S511 < 0.0f;
    float3 normal_6;
    float height_10;
    if(_S512)
    {
        SurfacePoint_0 _S513 = surface_at_0(_S506, _S508.x_11, _S508.y_5, !_S508.back_3);
        normal_6 = _S513.normal_5;
        height_10 = _S513.height_9;
    }
    else
    {
        normal_6 = _S508.normal_4;
        height_10 = _S508.height_3;
    }
    float3 _S514 = float3(_S510.xy, abs(_S511));
    if((dot(normal_6, _S514)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S506, _S507, _S508.x_11, _S508.y_5, height_10, _S514, (_S508.back_3) != _S512);
}

float3 evaluate_0(uint _S515, SearchQuality_0 _S516, YarnPoint_0 _S517, float3 _S518, float3 _S519)
{
    float3 _S520 = scattered_0(_S515, _S517, to_face_frame_0(_S518, _S517.back_3), to_face_frame_0(_S519, _S517.back_3));
    bool _S521;
    if((max(_S520.x, max(_S520.y, _S520.z))) <= 0.0f)
    {
        _S521 = true;
    }
    else
    {
        _S521 = !is_lit_0(_S515, _S516, _S517, _S518);
    }
    if(_S521)
    {
        return (float3)0.0f;
    }
    return _S520;
}

float straight_through_0(uint _S522, YarnPoint_0 _S523, float3 _S524)
{
    if(!_S523.hole_2)
    {
        return 0.0f;
    }
    float _S525 = fabrics_0[_S522].sheen_strength_0;
    if((fabrics_0[_S522].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S525 * sheen_lobe_0(abs(_S524.z), fabrics_0[_S522].sheen_roughness_0).z;
}

float4 light_of_point_0(int _S526, uint _S527, VisiblePoint_0 _S528, uint2 _S529, float3 _S530, float2 _S531)
{
    SearchQuality_0 _S532 = default_quality_0();
    float3 _S533 = to_local_0(_S528, _S528.view_0);
    YarnPoint_0 point_5 = locate_yarn_0(_S527, _S532, _S531.x, _S531.y, _S533);
    point_5.albedos_2 = tinted_0(point_5.albedos_2, _S530);
    float3 _S534 = (float3)0.0f;
    uint number_2 = 0U;
    float3 radiance_1 = _S534;
    for(;;)
    {
        if(number_2 < (light_sample_count_0(_S526)))
        {
        }
        else
        {
            break;
        }
        float _S535 = visibility_at_0(_S526, number_2, _S529);
        if(_S535 <= 0.0f)
        {
            number_2 = number_2 + 1U;
            continue;
        }
        LightSample_0 _S536 = light_sample_0(_S526, number_2, _S529, _S528.position_0);
        radiance_1 = radiance_1 + _S535 * _S536.irradiance_1 * evaluate_0(_S527, _S532, point_5, to_local_0(_S528, _S536.towards_0), _S533);
        number_2 = number_2 + 1U;
    }
    return float4(radiance_1, 1.0f - straight_through_0(_S527, point_5, _S533));
}

[numthreads(8, 8, 1)]
void shade_points(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S537;
    uint _S538 = frames_0[int(0)].width_0;
    bool _S539;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S539 = true;
    }
    else
    {
        _S539 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S539)
    {
        return;
    }
    uint2 _S540 = id_0.xy;
    uint _S541 = id_0.y * _S538 + id_0.x;
    uint _S542 = layers_0[_S541].face_0;
    if((layers_0[_S541].face_0) == 0U)
    {
        return;
    }
    uint _S543 = _S542 - 1U;
    uint _S544 = face_fabrics_0.Load(_S543);
    VisiblePoint_0 _S545 = visible_point_0(int(0), _S544, _S543, _S540);
    float3 _S546 = filtered_albedo_0(_S544, _S545);
    float4 _S547 = (float4)0.0f;
    uint k_0 = 0U;
    float4 sum_0 = _S547;
    for(;;)
    {
        uint _S548 = frames_0[int(0)].samples_0;
        _S537 = frames_0[int(0)].samples_0;
        if(k_0 < (frames_0[int(0)].samples_0))
        {
        }
        else
        {
            break;
        }
        float2 _S549 = pixel_sequence_0(_S540, frames_0[int(0)].pass_number_0 * _S548 + k_0, 1U) - 0.5f;
        float4 sum_1 = sum_0 + light_of_point_0(int(0), _S544, _S545, _S540, _S546, _S545.draft_0 + _S549.x * _S545.draft_dx_0 + _S549.y * _S545.draft_dy_0);
        k_0 = k_0 + 1U;
        sum_0 = sum_1;
    }
    accumulate_0(_S541, sum_0 / float(_S537));
    return;
}

