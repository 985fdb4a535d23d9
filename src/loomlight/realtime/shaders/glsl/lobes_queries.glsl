#version 450
layout(row_major) uniform;
layout(row_major) buffer;
layout(std430, binding = 1, set = 1) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} query_count_0;
struct Query_0
{
    uint fabric_0;
    float centre_x_0;
    float centre_y_0;
    float dx_x_0;
    float dx_y_0;
    float dy_x_0;
    float dy_y_0;
    float light_x_0;
    float light_y_0;
    float light_z_0;
    float view_x_0;
    float view_y_0;
    float view_z_0;
    uint seed_0;
};

layout(std430, binding = 0, set = 1) readonly buffer StructuredBuffer_Query_t_0 {
    Query_0 _data[];
} queries_0;
layout(std430, binding = 2, set = 1) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} answers_0;
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

struct Neural_0
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
    uint transmits_0;
    uint transmission_0;
    uint has_holes_0;
    uint opacity_0;
};

struct Latent_0
{
    uint is_trained_1;
    uint decoder_1;
    uint hidden_0;
    uint frames_0;
    uint sampler_0;
    uint albedo_0;
    uint texels_1;
    uint texel_elements_1;
    uint levels_3;
    float last_level_2;
    uint face_texels_1;
    uint back_1;
    float repeats_per_x_1;
    float repeats_per_y_1;
    float texels_per_mm_1;
    float width_0;
    float height_0;
    uint is_trilinear_0;
};

struct Clustered_0
{
    uint is_baked_1;
    uint clusters_0;
    uint rank_0;
    uint channels_0;
    uint columns_0;
    uint rows_0;
    float texel_width_0;
    float texel_height_0;
    uint samples_0;
    uint sums_0;
    uint labels_0;
    uint coefficients_0;
    uint basis_0;
    uint moments_1;
    uint light_0;
    uint view_0;
    uint offset_1;
    uint trust_0;
};

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Neural_0 neural_0;
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
    uint seed_1;
    float layer_bound_0;
    float fibre_size_0;
    uint has_detail_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint openness_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
    uint has_yarns_0;
    float mean_hole_0;
    Latent_0 latent_0;
    Clustered_0 clustered_0;
};

layout(std430, binding = 0) readonly buffer StructuredBuffer_Fabric_t_0 {
    Fabric_0 _data[];
} fabrics_0;
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
    float has_plies_0;
    float plies_per_mm_0;
    float ply_sine_0;
    float ply_cosine_0;
    float fibre_tilt_0;
    float fibre_tone_0;
    float slub_0;
    float slubs_per_mm_0;
    float per_half_width_0;
    float hairiness_0;
};

layout(std430, binding = 1) readonly buffer StructuredBuffer_Family_t_0 {
    Family_0 _data[];
} families_0;
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_1 {
    uint _data[];
} words_0;
vec3 saturate_0(vec3 x_0)
{
    return clamp(x_0, vec3(0.0), vec3(1.0));
}

const vec2  TAP_OFFSETS_0[9] = vec2[](vec2(-0.3333333432674408, -0.3333333432674408), vec2(-0.3333333432674408, 0.0), vec2(-0.3333333432674408, 0.3333333432674408), vec2(0.0, -0.3333333432674408), vec2(0.0, 0.0), vec2(0.0, 0.3333333432674408), vec2(0.3333333432674408, -0.3333333432674408), vec2(0.3333333432674408, 0.0), vec2(0.3333333432674408, 0.3333333432674408));
float saturate_1(float x_1)
{
    return clamp(x_1, 0.0, 1.0);
}

const float  PYRAMID_RADII_0[4] = float[](1.0, 2.0, 4.0, 8.0);
const vec2  POINT_OFFSETS_0[8] = vec2[](vec2(0.0, 0.0), vec2(-0.23010000586509705, 0.35670000314712524), vec2(0.36809998750686646, -0.22939999401569366), vec2(-0.28040000796318054, -0.34400001168251038), vec2(0.3465999960899353, 0.28859999775886536), vec2(-0.36349999904632568, 0.0511000007390976), vec2(0.09929999709129333, -0.35699999332427979), vec2(0.10710000246763229, 0.32879999279975891));
struct Footprint_0
{
    vec2 centre_0;
    vec2 dx_0;
    vec2 dy_0;
};

float Footprint_spread_side_0(Footprint_0 this_0)
{
    vec2 _S1 = this_0.dx_0;
    vec2 _S2 = this_0.dy_0;
    return sqrt(0.5 * (dot(_S1, _S1) + dot(_S2, _S2)));
}

float natural_logarithm_0(float x_2)
{
    uint _S3 = floatBitsToUint(x_2);
    float exponent_0 = float(int(_S3 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S3 & 8388607U) | 1056964608U);
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042)
    {
        float exponent_2 = exponent_0 - 1.0;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0;
    float _S4 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S4 - exponent_1 * 0.00021219444170129 - 0.5 * _S4) + exponent_1 * 0.693359375;
}

float binary_logarithm_0(float x_3)
{
    return natural_logarithm_0(x_3) * 1.4426950216293335;
}

vec3 to_face_frame_0(vec3 direction_0, bool back_2)
{
    vec2 _S5 = direction_0.xy;
    float _S6;
    if(back_2)
    {
        _S6 = - direction_0.z;
    }
    else
    {
        _S6 = direction_0.z;
    }
    return vec3(_S5, _S6);
}

struct SurfacePoint_0
{
    bool hole_0;
    bool is_warp_0;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_1;
    vec3 normal_0;
    vec3 tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_2, vec3 normal_1, vec3 tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S7;
    _S7.hole_0 = hole_1;
    _S7.is_warp_0 = is_warp_1;
    _S7.warp_thread_0 = warp_thread_1;
    _S7.weft_thread_0 = weft_thread_1;
    _S7.height_1 = height_2;
    _S7.normal_0 = normal_1;
    _S7.tangent_0 = tangent_1;
    _S7.across_0 = across_1;
    _S7.fibre_across_0 = fibre_across_1;
    _S7.fibre_along_0 = fibre_along_1;
    return _S7;
}

struct Components_0
{
    float diffuse_warp_0;
    float diffuse_weft_0;
    float specular_warp_0;
    float specular_weft_0;
    float light_visibility_1;
    float hole_2;
};

Components_0 no_components_0()
{
    Components_0 nothing_0;
    nothing_0.diffuse_warp_0 = 0.0;
    nothing_0.diffuse_weft_0 = 0.0;
    nothing_0.specular_warp_0 = 0.0;
    nothing_0.specular_weft_0 = 0.0;
    nothing_0.light_visibility_1 = 0.0;
    nothing_0.hole_2 = 0.0;
    return nothing_0;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

Blocked_0 no_blocked_0()
{
    Blocked_0 nothing_1;
    nothing_1.by_warp_0 = 0.0;
    nothing_1.by_weft_0 = 0.0;
    nothing_1.far_0 = 0.0;
    return nothing_1;
}

struct CloseUp_0
{
    float weight_0;
    Blocked_0 warp_1;
    Blocked_0 weft_1;
};

CloseUp_0 no_close_up_0()
{
    CloseUp_0 nothing_2;
    nothing_2.weight_0 = 0.0;
    Blocked_0 _S8 = no_blocked_0();
    nothing_2.warp_1 = _S8;
    nothing_2.weft_1 = _S8;
    return nothing_2;
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 quality_of_0(float threads_0)
{
    float _S9 = clamp((-3.0 - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10))) / 2.0, 0.0, 1.0);
    SearchQuality_0 quality_0;
    float _S10 = mix(2.5, 5.0, _S9);
    quality_0.steps_per_thread_0 = _S10;
    quality_0.steps_per_relief_0 = _S10;
    quality_0.shadow_share_0 = mix(1.60000002384185791, 1.0, _S9);
    quality_0.refinements_0 = uint(mix(1.0, 2.0, _S9) + 0.5);
    return quality_0;
}

vec2 turns_and_remainder_0(uint family_0, float index_0)
{
    float _S11 = floor(fma(index_0, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S11, fma(- _S11, families_0._data[uint(family_0)].count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S12 = floor(position_0 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S13 = fma(- _S12, families_0._data[uint(family_1)].size_0, position_0);
    cell_0.below_0 = _S13;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S13;
    cell_0.across_2 = _S13 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S12).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_0;
}

float table_number_0(uint index_1)
{
    return uintBitsToFloat(words_0._data[uint(index_1)]);
}

Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float turns_0 = (position_1 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S14 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S15;
    if(_S14 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S15 = 1U;
    }
    else
    {
        _S15 = 0U;
    }
    uint _S16 = min(thread_1 + _S15, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S17 = families_0._data[uint(family_2)].place_table_0 + _S16 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S16;
    cell_1.below_0 = _S14 - table_number_0(_S17);
    cell_1.above_0 = table_number_0(_S17 + 1U) - _S14;
    cell_1.across_2 = _S14 - table_number_0(_S17 + 2U);
    cell_1.half_width_1 = table_number_0(_S17 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2)
{
    if((families_0._data[uint(family_3)].is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Shown_0
{
    bool is_warp_2;
    bool hole_3;
    bool on_top_0;
    uint word_0;
};

struct Crossing_0
{
    Cell_0 warp_2;
    Cell_0 weft_2;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_3)
{
    bool _S18 = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    bool _S19 = (abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1);
    Shown_0 shown_0;
    bool _S20;
    if(_S18)
    {
        if(!_S19)
        {
            _S20 = true;
        }
        else
        {
            _S20 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S20 = false;
    }
    shown_0.is_warp_2 = _S20;
    if(!_S18)
    {
        _S20 = !_S19;
    }
    else
    {
        _S20 = false;
    }
    shown_0.hole_3 = _S20;
    uint _S21;
    if(shown_0.is_warp_2)
    {
        _S21 = crossing_0.warp_word_0;
    }
    else
    {
        _S21 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S21;
    shown_0.on_top_0 = ((_S21 & 1U) == 1U) != back_3;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_2;
    uint _S22;
    if(is_first_0)
    {
        _S22 = first_0.thread_0;
    }
    else
    {
        _S22 = second_0.thread_0;
    }
    cell_2.thread_0 = _S22;
    float _S23;
    if(is_first_0)
    {
        _S23 = first_0.across_2;
    }
    else
    {
        _S23 = second_0.across_2;
    }
    cell_2.across_2 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.half_width_1;
    }
    else
    {
        _S23 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.below_0;
    }
    else
    {
        _S23 = second_0.below_0;
    }
    cell_2.below_0 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.above_0;
    }
    else
    {
        _S23 = second_0.above_0;
    }
    cell_2.above_0 = _S23;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0)
{
    vec2 _S24 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    return fma(_S24.x, families_0._data[uint(family_4)].period_0, table_number_0(families_0._data[uint(family_4)].place_table_0 + uint(_S24.y) * 4U));
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0)
{
    if((families_0._data[uint(family_5)].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * families_0._data[uint(family_5)].size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_4)
{
    uint _S25 = families_0._data[uint(family_6)].bend_table_0;
    uint _S26;
    if((families_0._data[uint(family_6)].is_alike_0) != 0U)
    {
        _S26 = 0U;
    }
    else
    {
        _S26 = thread_4 * 4U;
    }
    uint _S27 = _S25 + _S26;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S27);
    bend_0.half_tangent_0 = table_number_0(_S27 + 1U);
    bend_0.arc_0 = table_number_0(_S27 + 2U);
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_5, Cell_0 crossed_0, uint word_1)
{
    int _S28 = int((word_1 >> 1) & 127U);
    int _S29 = int((word_1 >> 8) & 127U);
    int _S30 = int((word_1 >> 15) & 63U);
    int _S31 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S32 = - _S28;
    float _S33 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S32, 0);
    run_0.from_start_0 = _S33;
    int _S34 = _S29 + 1;
    float _S35 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, 1, _S34);
    run_0.to_end_0 = _S35;
    bool _S36 = _S33 < _S35;
    run_0.near_start_0 = _S36;
    int _S37;
    if(_S36)
    {
        _S37 = _S32 - _S30;
    }
    else
    {
        _S37 = _S34;
    }
    int _S38;
    if(run_0.near_start_0)
    {
        _S38 = _S32;
    }
    else
    {
        _S38 = _S34 + _S31;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    float _S39;
    if(run_0.straight_0)
    {
        _S39 = 1.0e+06;
    }
    else
    {
        _S39 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S39;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_0, crossed_0.thread_0, _S37, _S38), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S28 == 0;
    run_0.last_crossing_0 = _S29 == 0;
    return run_0;
}

float square_0(float x_4)
{
    return x_4 * x_4;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_3)
{
    float _S40 = cell_3.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S41 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S41;
    float _S42 = _S40 * _S40 - square_0(_S41);
    float _S43 = (inversesqrt((_S42)));
    section_0.drop_0 = _S40 - _S42 * _S43;
    section_0.slope_0 = - _S41 * _S43;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    if((families_0._data[uint(family_7)].is_alike_0) != 0U)
    {
        return table_number_0(families_0._data[uint(family_7)].bend_table_0 + 3U);
    }
    return table_number_0(families_0._data[uint(family_7)].bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

vec2 dive_0(uint other_1, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
{
    bool _S44 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S45 = min(crossed_1.below_0, crossed_1.above_0);
    float _S46;
    if(_S44)
    {
        _S46 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S46 = crossed_1.above_0 + crossed_1.across_2;
    }
    float _S47 = _S46 - crossed_1.half_width_1;
    bool _S48;
    if(_S44)
    {
        _S48 = run_1.first_crossing_0;
    }
    else
    {
        _S48 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S46 = 0.0;
    }
    else
    {
        _S46 = families_0._data[uint(other_1)].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, 0);
    }
    float _S49;
    if((shown_1.on_top_0) != _S48)
    {
        _S49 = 0.0;
    }
    else
    {
        float _S50 = families_0._data[uint(other_1)].height_scale_0;
        int _S51;
        if(_S44)
        {
            _S51 = -1;
        }
        else
        {
            _S51 = 1;
        }
        _S49 = _S50 * edge_drop_0(other_1, crossed_1.thread_0, _S51);
    }
    float _S52 = 1.0 / max(2.0 * _S47, 9.999999960041972e-13);
    float _S53 = clamp((_S47 - _S45) * _S52, 0.0, 1.0);
    float _S54 = _S46 + (_S49 - _S46) * (_S53 * _S53 * (3.0 - 2.0 * _S53));
    float _S55 = (_S46 - _S49) * (6.0 * _S53 * (1.0 - _S53) * _S52);
    if(_S44)
    {
        _S46 = 1.0;
    }
    else
    {
        _S46 = -1.0;
    }
    return vec2(_S54, _S55 * _S46);
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

StepControl_0 step_control_0(vec2 direction_1, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129 * step_3;
    float _S56 = direction_1.x;
    control_0.per_x_0 = 1.0 / max(abs(_S56), 9.99999971718068537e-10);
    float _S57 = direction_1.y;
    control_0.per_y_0 = 1.0 / max(abs(_S57), 9.99999971718068537e-10);
    control_0.right_0 = _S56 > 0.0;
    control_0.up_0 = _S57 > 0.0;
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
    previous_0.clearance_0 = 0.0;
    previous_0.rate_0 = 0.0;
    previous_0.yarn_0 = 0U;
    previous_0.known_0 = false;
    return previous_0;
}

float outline_distance_0(Cell_0 cell_4, Shown_0 shown_2, Run_0 run_2, bool lengthwise_0, bool forwards_0)
{
    float _S58;
    if(forwards_0)
    {
        _S58 = cell_4.across_2;
    }
    else
    {
        _S58 = - cell_4.across_2;
    }
    float _S59;
    if(forwards_0)
    {
        _S59 = cell_4.above_0;
    }
    else
    {
        _S59 = cell_4.below_0;
    }
    bool _S60;
    if(forwards_0)
    {
        _S60 = run_2.last_crossing_0;
    }
    else
    {
        _S60 = run_2.first_crossing_0;
    }
    bool _S61;
    if(forwards_0)
    {
        _S61 = run_2.first_crossing_0;
    }
    else
    {
        _S61 = run_2.last_crossing_0;
    }
    float _S62 = - cell_4.half_width_1;
    bool _S63 = _S58 < _S62;
    bool _S64 = _S58 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S60 = !_S60;
    }
    else
    {
        _S60 = false;
    }
    if(_S60)
    {
        _S60 = !shown_2.hole_3;
    }
    else
    {
        _S60 = false;
    }
    bool _S65;
    if(_S60)
    {
        _S65 = shown_2.on_top_0;
    }
    else
    {
        _S65 = false;
    }
    if(_S65)
    {
        if(_S61)
        {
            _S61 = _S63;
        }
        else
        {
            _S61 = false;
        }
        _S61 = !_S61;
    }
    else
    {
        _S61 = false;
    }
    if(shown_2.hole_3)
    {
        _S60 = true;
    }
    else
    {
        if(_S60)
        {
            _S60 = !shown_2.on_top_0;
        }
        else
        {
            _S60 = false;
        }
    }
    float _S66;
    if(_S63)
    {
        _S66 = _S62;
    }
    else
    {
        _S66 = cell_4.half_width_1;
    }
    float _S67 = _S66 - _S58;
    if(_S60)
    {
        _S58 = 2.0 * _S59 + _S58 - cell_4.half_width_1;
    }
    else
    {
        _S58 = _S59;
    }
    if(_S61)
    {
        if(forwards_0)
        {
            _S58 = run_2.to_end_0;
        }
        else
        {
            _S58 = run_2.from_start_0;
        }
        return _S58;
    }
    if(_S64)
    {
    }
    else
    {
        _S58 = _S67;
    }
    return _S58;
}

struct Probe_0
{
    float height_3;
    bool hole_4;
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
    float _S68 = previous_1.rate_0 * step_4;
    float _S69 = rate_1 * step_4;
    bool _S70;
    if(!previous_1.known_0)
    {
        _S70 = true;
    }
    else
    {
        _S70 = here_0.hole_4;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.rate_0) >= 0.0;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = rate_1 <= 0.0;
    }
    if(_S70)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S68) >= 0.0)
    {
        _S70 = (3.0 * clearance_1 - _S69) >= 0.0;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        return -1.0;
    }
    float _S71 = clearance_1 - previous_1.clearance_0;
    float _S72 = 6.0 * _S71 - 4.0 * _S68 - 2.0 * _S69;
    float _S73 = -2.0 * _S68 / max(_S72 + sqrt(max(_S72 * _S72 - 4.0 * (3.0 * (_S68 + _S69 - 2.0 * _S71)) * _S68, 0.0)), 9.99999968265522539e-21);
    float _S74 = 1.0 - _S73;
    float _S75 = (previous_1.clearance_0 * (2.0 * _S73 + 1.0) + _S68 * _S73) * _S74 * _S74;
    float _S76 = (clearance_1 * (2.0 * _S74 + 1.0) - _S69 * _S74) * _S73 * _S73;
    if(_S73 > 0.01999999955296516)
    {
        _S70 = _S74 > 0.01999999955296516;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        _S70 = (_S75 + _S76) < 0.0;
    }
    else
    {
        _S70 = false;
    }
    float _S77;
    if(_S70)
    {
        _S77 = _S74 * step_4;
    }
    else
    {
        _S77 = -1.0;
    }
    return _S77;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S78;
    if(here_1.hole_4)
    {
        _S78 = 1.0e+09;
    }
    else
    {
        _S78 = clearance_2;
    }
    previous_2.clearance_0 = _S78;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S79;
    if(!here_1.hole_4)
    {
        _S79 = !is_cell_exit_0;
    }
    else
    {
        _S79 = false;
    }
    previous_2.known_0 = _S79;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S80 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S81;
    if(!here_2.hole_4)
    {
        _S81 = (rate_3 * _S80 + clearance_3) < 0.0;
    }
    else
    {
        _S81 = false;
    }
    if(_S81)
    {
        _S81 = _S80 > (2.0 * this_2.epsilon_0);
    }
    else
    {
        _S81 = false;
    }
    float _S82;
    if(_S81)
    {
        _S82 = _S80 - this_2.epsilon_0;
    }
    else
    {
        _S82 = max(_S80, 0.0) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S82);
}

struct ViewRay_0
{
    vec2 origin_0;
    vec2 slope_1;
};

vec2 ViewRay_at_0(ViewRay_0 this_3, float height_4)
{
    return this_3.origin_0 + this_3.slope_1 * height_4;
}

float ViewRay_rate_0(ViewRay_0 this_4, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S83 = end_0 - start_1;
    float _S84 = start_rate_0 + end_rate_0 - 2.0 * _S83;
    float _S85 = 3.0 * _S83 - 2.0 * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S83, 9.99999968265522539e-21);
    int i_0 = 0;
    for(;;)
    {
        if(uint(i_0) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S86 = clamp(share_0 - (((_S84 * share_0 + _S85) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0 * _S84 * share_0 + 2.0 * _S85) * share_0 + start_rate_0, 0.10000000149011612 * _S83 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S87 = i_0 + 1;
        share_0 = _S86;
        i_0 = _S87;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

vec2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S88 = along_slope_0 * along_slope_0 + 1.0;
    float _S89 = (inversesqrt((_S88)));
    float _S90 = sine_1 * _S89 * (inversesqrt((_S88 + across_slope_0 * across_slope_0)));
    return vec2(- _S90 * _S88, _S90 * across_slope_0 * along_slope_0 + cosine_0 * _S89);
}

float arc_sine_0(float x_5)
{
    float _S91 = abs(x_5);
    bool _S92 = _S91 > 0.5;
    float _S93;
    if(_S92)
    {
        _S93 = 0.5 * (1.0 - _S91);
    }
    else
    {
        _S93 = _S91 * _S91;
    }
    float _S94;
    if(_S92)
    {
        _S94 = sqrt(max(_S93, 0.0));
    }
    else
    {
        _S94 = _S91;
    }
    float _S95 = ((((0.04216320067644119 * _S93 + 0.02418131195008755) * _S93 + 0.04547002539038658) * _S93 + 0.07495300471782684) * _S93 + 0.16666752099990845) * _S93 * _S94 + _S94;
    if(_S92)
    {
        _S93 = 1.57079637050628662 - 2.0 * _S95;
    }
    else
    {
        _S93 = _S95;
    }
    if(x_5 < 0.0)
    {
        _S93 = - _S93;
    }
    return _S93;
}

struct Hair_0
{
    float cover_0;
    vec3 normal_2;
    vec3 tangent_2;
};

Hair_0 Hair_x24init_0(float cover_1, vec3 normal_3, vec3 tangent_3)
{
    Hair_0 _S96;
    _S96.cover_0 = cover_1;
    _S96.normal_2 = normal_3;
    _S96.tangent_2 = tangent_3;
    return _S96;
}

float fade_0(float size_1, float period_1)
{
    return clamp((1.0 - size_1 / period_1) * 1.33333337306976318, 0.0, 1.0);
}

uint scramble_0(uint value_0)
{
    uint _S97 = value_0 * 747796405U + 2891336453U;
    uint _S98 = ((_S97 >> ((_S97 >> 28) + 4U)) ^ _S97) * 277803737U;
    return (_S98 >> 22) ^ _S98;
}

uint hash_key_0(uint thread_7, uint stream_0)
{
    return scramble_0(thread_7 + scramble_0(stream_0));
}

uint hash_bits_0(uint key_0, uint cell_5)
{
    return scramble_0(cell_5 + key_0);
}

float share_of_0(uint bits_0)
{
    return (float(bits_0 & 1023U) + 0.5) * 0.0009765625;
}

vec2 sine_cosine_0(float x_6)
{
    float _S99 = floor(x_6 * 0.63661974668502808 + 0.5);
    float _S100 = x_6 - _S99 * 1.5703125 - _S99 * 0.00048375129699707 - _S99 * 7.54979012640433211e-08;
    float _S101 = _S100 * _S100;
    float _S102 = ((-0.00019515295571182 * _S101 + 0.00833216123282909) * _S101 - 0.16666655242443085) * _S101 * _S100 + _S100;
    float _S103 = ((0.00002443315679557 * _S101 - 0.00138873164542019) * _S101 + 0.04166664555668831) * _S101 * _S101 - 0.5 * _S101 + 1.0;
    uint _S104 = uint(int(_S99)) & 3U;
    vec2 _S105;
    if((_S104 & 1U) != 0U)
    {
        _S105 = vec2(_S103, _S102);
    }
    else
    {
        _S105 = vec2(_S102, _S103);
    }
    float _S106;
    if((_S104 & 2U) != 0U)
    {
        _S106 = - _S105.x;
    }
    else
    {
        _S106 = _S105.x;
    }
    float _S107;
    if(((_S104 + 1U) & 2U) != 0U)
    {
        _S107 = - _S105.y;
    }
    else
    {
        _S107 = _S105.y;
    }
    return vec2(_S106, _S107);
}

vec3 table_colour_0(uint index_2)
{
    return vec3(table_number_0(index_2), table_number_0(index_2 + 1U), table_number_0(index_2 + 2U));
}

struct Albedos_0
{
    vec3 diffuse_reflect_0;
    vec3 diffuse_transmit_0;
    vec3 specular_reflect_0;
    vec3 specular_transmit_0;
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
    return table_albedos_0(families_0._data[uint(family_8)].albedo_table_0 + families_0._data[uint(family_8)].albedo_stride_0 * thread_8);
}

vec3 fibre_cell_0(float across_4, float along_0, float width_1)
{
    float _S108 = floor(across_4 / width_1);
    return vec3(_S108, along_0 / (width_1 * 40.0) + 0.61799997091293335 * _S108, 2.0 * (across_4 / width_1 - _S108) - 1.0);
}

float ply_offset_0(uint family_9, SurfacePoint_0 point_0, bool back_4)
{
    float _S109;
    if(back_4)
    {
        _S109 = - families_0._data[uint(family_9)].ply_sine_0;
    }
    else
    {
        _S109 = families_0._data[uint(family_9)].ply_sine_0;
    }
    float _S110 = (point_0.fibre_across_0 * families_0._data[uint(family_9)].ply_cosine_0 + point_0.fibre_along_0 * _S109) * families_0._data[uint(family_9)].plies_per_mm_0;
    return 2.0 * (_S110 - floor(_S110)) - 1.0;
}

float signed_noise_0(uint bits_1)
{
    return (float(bits_1 & 65535U) + 0.5) * 0.000030517578125 - 1.0;
}

float smooth_share_0(float share_1)
{
    return share_1 * share_1 * (3.0 - 2.0 * share_1);
}

vec2 wave_noise_0(uint key_1, float position_3)
{
    float _S111 = floor(position_3);
    float _S112 = position_3 - _S111;
    uint _S113 = uint(int(_S111));
    float _S114 = signed_noise_0(hash_bits_0(key_1, _S113));
    float _S115 = signed_noise_0(hash_bits_0(key_1, _S113 + 1U));
    return vec2(mix(_S114, _S115, smooth_share_0(_S112)), 6.0 * _S112 * (1.0 - _S112) * (_S115 - _S114));
}

vec2 cell_noise_0(uint key_2, vec3 cell_6)
{
    float _S116 = cell_6.y;
    float _S117 = floor(_S116);
    uint _S118 = uint(int(cell_6.x)) * 65536U + uint(int(_S117));
    uint _S119 = hash_bits_0(key_2, _S118);
    uint _S120 = hash_bits_0(key_2, _S118 + 1U);
    return mix(vec2(signed_noise_0(_S119), signed_noise_0(_S119 >> 16)), vec2(signed_noise_0(_S120), signed_noise_0(_S120 >> 16)), vec2(smooth_share_0(_S116 - _S117)));
}

float uniform_hash_0(uint thread_9, uint cell_7, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_9, stream_1), cell_7)) >> 9) + 0.5) * 1.1920928955078125e-07;
}

float thread_gain_0(uint thread_10, float amount_0, uint seed_2)
{
    return amount_0 * (2.0 * uniform_hash_0(thread_10, 0U, seed_2 ^ 2135587861U) - 1.0) + 1.0;
}

float bounded_gain_0(float gain_0, vec3 albedo_1, vec3 room_0)
{
    vec3 _S121 = room_0 / max(albedo_1, vec3(9.99999997475242708e-07));
    return min(gain_0, max(min(min(_S121.x, _S121.y), _S121.z), 0.0));
}

float flattened_0(float largest_0, vec3 albedo_2, vec3 room_1)
{
    vec3 _S122 = room_1 / max(albedo_2, vec3(9.99999997475242708e-07)) - 1.0;
    return min(max(min(min(_S122.x, _S122.y), _S122.z), 0.0) / max(largest_0, 9.99999997475242708e-07), 1.0);
}

float fibre_gain_0(uint thread_11, uint cell_8, float amount_1, uint seed_3)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, seed_3 ^ 2654435769U)), 10.0) - 1.0) + 1.0;
}

struct YarnFrame_0
{
    vec3 normal_4;
    vec3 tangent_4;
    float loss_0;
};

YarnFrame_0 under_hair_0(YarnFrame_0 frame_0, Hair_0 hair_0)
{
    vec3 _S123;
    if((dot(frame_0.tangent_4, hair_0.tangent_2)) < 0.0)
    {
        _S123 = - hair_0.tangent_2;
    }
    else
    {
        _S123 = hair_0.tangent_2;
    }
    YarnFrame_0 blended_0;
    vec3 _S124 = vec3(hair_0.cover_0);
    vec3 _S125 = normalize(mix(frame_0.normal_4, hair_0.normal_2, _S124));
    blended_0.normal_4 = _S125;
    vec3 _S126 = mix(frame_0.tangent_4, _S123, _S124);
    vec3 _S127 = _S126 - dot(_S126, _S125) * _S125;
    blended_0.tangent_4 = _S127 * (inversesqrt((max(dot(_S127, _S127), 9.999999960041972e-13))));
    blended_0.loss_0 = frame_0.loss_0 * (1.0 - hair_0.cover_0);
    return blended_0;
}

float diffuse_gain_0(YarnFrame_0 frame_1, float blend_0)
{
    return min(0.85000002384185791 * blend_0 * frame_1.loss_0 + 1.0, 1.0 / (0.5 * blend_0 * (frame_1.normal_4.z - 1.0) + 1.0));
}

float diffuse_reflection_0(vec3 light_1, vec3 normal_5, float blend_1)
{
    float _S128 = light_1.z;
    if(_S128 <= 0.0)
    {
        return 0.0;
    }
    return 0.31830987334251404 * mix(max(_S128, 0.0), max(dot(light_1, normal_5), 0.0), blend_1);
}

float projected_area_1(vec3 direction_2, vec3 tangent_5, float roughness_1)
{
    float _S129 = dot(direction_2, tangent_5);
    return sqrt(max((roughness_1 + 1.0) * (roughness_1 - 1.0) * _S129 * _S129 + 1.0, roughness_1 * roughness_1));
}

float exponential_0(float x_7)
{
    float _S130 = clamp(x_7, -87.0, 88.0);
    float _S131 = floor(_S130 * 1.4426950216293335 + 0.5);
    float _S132 = _S130 - _S131 * 0.693359375 + _S131 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S132 + 0.00139819993637502) * _S132 + 0.00833345204591751) * _S132 + 0.04166579619050026) * _S132 + 0.1666666567325592) * _S132 + 0.5;
    float _S133 = uintBitsToFloat(uint(int(_S131) + 127) << 23);
    float _S134;
    if(x_7 < -87.0)
    {
        _S134 = 0.0;
    }
    else
    {
        _S134 = (p_0 * _S132 * _S132 + _S132 + 1.0) * _S133;
    }
    return _S134;
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612)
    {
        return (((depth_0 / 120.0 - 0.0416666679084301) * depth_0 + 0.1666666716337204) * depth_0 - 0.5) * depth_0 + 1.0;
    }
    return (1.0 - exponential_0(- depth_0)) / depth_0;
}

float square_1(vec3 v_0)
{
    return dot(v_0, v_0);
}

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S135 = roughness_2 * roughness_2;
    float _S136 = squared_along_0 * (1.0 - _S135) + _S135;
    return 0.31830987334251404 * _S135 * roughness_2 / (_S136 * _S136);
}

float density_between_0(vec3 light_2, vec3 view_1, vec3 tangent_6, float roughness_3)
{
    vec3 _S137 = light_2 + view_1;
    float _S138 = dot(_S137, tangent_6);
    return flake_density_0(min(_S138 * _S138 / max(square_1(_S137), 9.999999960041972e-13), 1.0), roughness_3);
}

float transmission_1(vec3 light_3, vec3 view_2, vec3 normal_6, vec3 tangent_7, float roughness_4, float optical_depth_1)
{
    float _S139 = - dot(light_3, normal_6);
    float _S140 = dot(view_2, normal_6);
    bool _S141;
    if(_S139 <= 0.0)
    {
        _S141 = true;
    }
    else
    {
        _S141 = _S140 <= 0.0;
    }
    if(_S141)
    {
        return 0.0;
    }
    float _S142 = 1.0 / max(_S140, 9.99999997475242708e-07);
    float _S143 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S139, 9.99999997475242708e-07);
    float _S144 = projected_area_1(view_2, tangent_7, roughness_4) * _S142;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25 * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S143, _S144)) * mean_attenuation_0(optical_depth_1 * abs(_S143 - _S144)) * _S142;
}

float reflection_0(vec3 light_4, vec3 view_3, vec3 normal_7, vec3 tangent_8, float roughness_5, float optical_depth_2)
{
    float _S145 = dot(light_4, normal_7);
    bool _S146;
    if(_S145 <= 0.0)
    {
        _S146 = true;
    }
    else
    {
        _S146 = (dot(view_3, normal_7)) <= 0.0;
    }
    if(_S146)
    {
        return 0.0;
    }
    float _S147 = max(_S145, 9.99999997475242708e-07);
    float _S148 = max(dot(view_3, normal_7), 9.99999997475242708e-07);
    float _S149 = projected_area_1(light_4, tangent_8, roughness_5) * _S148 + projected_area_1(view_3, tangent_8, roughness_5) * _S147;
    float _S150 = optical_depth_2 * _S149 / (_S147 * _S148);
    return 0.25 * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S150 * mean_attenuation_0(_S150)) * _S147 / _S149;
}

Components_0 with_added_0(Components_0 sums_1, Components_0 more_0, float weight_1)
{
    Components_0 result_0;
    result_0.diffuse_warp_0 = sums_1.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_1.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_1.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_1.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_1.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_1.hole_2 + weight_1 * more_0.hole_2;
    return result_0;
}

Blocked_0 scaled_0(Blocked_0 blocked_0, float share_2)
{
    Blocked_0 result_1;
    result_1.by_warp_0 = share_2 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_2 * blocked_0.by_weft_0;
    result_1.far_0 = share_2 * blocked_0.far_0;
    return result_1;
}

float wrapped_cell_0(float position_4, float count_1)
{
    return min(floor((position_4 - floor(position_4)) * count_1), count_1 - 1.0);
}

float arc_tangent_quotient_0(float x_8, float y_0)
{
    return ((((((0.0 * x_8 + 0.00809729471802711) * x_8 + -0.0377517081797123) * x_8 + 0.08475969731807709) * x_8 + -0.13537675142288208) * x_8 + 0.19895026087760925) * x_8 + -0.33327975869178772) * x_8 + 0.99999970197677612;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0);
}

float arc_tangent_0(float y_1, float x_9)
{
    float _S151 = abs(x_9);
    float _S152 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S151, _S152) / max(max(_S151, _S152), 1.00000000317107685e-30));
    float angle_1;
    if(_S152 > _S151)
    {
        angle_1 = 1.57079637050628662 - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_9 < 0.0)
    {
        angle_1 = 3.14159274101257324 - angle_1;
    }
    if(y_1 < 0.0)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
    uvec4 nodes_0;
    uvec4 weights_0;
    float inverse_sum_0;
};

NodeTaps_0 node_taps_0(vec3 direction_3)
{
    float _S153 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461;
    float _S154 = floor(_S153);
    float _S155 = _S153 - _S154;
    float _S156 = sqrt(clamp((1.0 - abs(direction_3.z)) / 0.97000002861022949, 0.0, 1.0));
    float _S157 = 7.0 * _S156 * sqrt(_S156);
    float _S158 = min(floor(_S157), 6.0);
    float _S159 = _S157 - _S158;
    uint _S160 = uint(int(_S154) + 32) % 32U;
    uint _S161 = uint(_S158);
    uint _S162 = _S160 * 8U + _S161;
    uint _S163 = (_S160 + 1U) % 32U * 8U + _S161;
    NodeTaps_0 taps_0;
    taps_0.nodes_0 = uvec4(_S162, _S162 + 1U, _S163, _S163 + 1U);
    float _S164 = 1.0 - _S155;
    float _S165 = 1.0 - _S159;
    uvec4 _S166 = uvec4(vec4(_S164 * _S165, _S164 * _S159, _S155 * _S165, _S155 * _S159) * 252.0 + 0.5);
    taps_0.weights_0 = _S166;
    taps_0.inverse_sum_0 = 1.0 / float(_S166.x + _S166.y + _S166.z + _S166.w);
    return taps_0;
}

vec3 half_vector_0(vec3 light_5, vec3 view_4)
{
    vec3 _S167 = light_5 + view_4;
    return _S167 * (inversesqrt((max(square_1(_S167), 9.999999960041972e-13))));
}

vec3 shadow_correlation_0(vec3 light_6, vec3 view_5)
{
    vec2 _S168 = light_6.xy;
    vec2 _S169 = view_5.xy;
    float _S170 = dot(_S168, _S169) / max(sqrt(dot(_S168, _S168) * dot(_S169, _S169)), 9.99999997475242708e-07);
    if((light_6.z) < 0.0)
    {
        return vec3(vec2(-0.09000000357627869 + -0.07999999821186066 * _S170), 0.0);
    }
    return vec3(min(0.62000000476837158 + 0.62999999523162842 * _S170, 1.20000004768371582), 0.62000000476837158, 0.37000000476837158);
}

vec4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return vec4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16), float(odd_0 >> 16));
}

vec4 interpolate_0(NodeTaps_0 taps_1, uvec4 packs_1)
{
    uvec4 _S171 = (packs_1 & 16711935U) * taps_1.weights_0;
    uvec4 _S172 = ((packs_1 >> 8) & 16711935U) * taps_1.weights_0;
    return bytes_of_sums_0(_S171.x + _S171.y + _S171.z + _S171.w, _S172.x + _S172.y + _S172.z + _S172.w) * taps_1.inverse_sum_0;
}

vec4 interpolate_table_0(NodeTaps_0 taps_2, uint table_0, uint stride_0)
{
    uvec4 _S173 = table_0 + taps_2.nodes_0 * stride_0;
    return interpolate_0(taps_2, uvec4(words_0._data[uint(_S173.x)], words_0._data[uint(_S173.y)], words_0._data[uint(_S173.z)], words_0._data[uint(_S173.w)]));
}

struct Group_0
{
    vec3 normal_8;
    float weight_2;
    vec3 tangent_9;
    vec3 variance_0;
    vec3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    group_0.normal_8 = vec3(table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    group_0.weight_2 = table_number_0(row_1 + 3U);
    vec3 _S174 = vec3(table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    group_0.tangent_9 = _S174;
    float _S175 = table_number_0(row_1 + 7U);
    float _S176 = table_number_0(row_1 + 8U);
    group_0.variance_0 = vec3(_S175, _S176, 1.0 - square_1(_S174) - _S175 - _S176);
    group_0.covariance_0 = vec3(table_number_0(row_1 + 9U), table_number_0(row_1 + 10U), table_number_0(row_1 + 11U));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

vec2 visibility_gain_0(vec3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * (1.0 / max(max(from_light_0, from_view_0), 0.00392156885936856) - 1.0) + vec2(1.0 - correlations_0.z * (1.0 - from_light_0), 1.0), vec2(0.0));
}

float Group_variance_along_0(Group_0 this_5, vec3 direction_4)
{
    float _S177 = direction_4.x;
    float _S178 = direction_4.y;
    float _S179 = direction_4.z;
    return max(dot(this_5.variance_0, direction_4 * direction_4) + 2.0 * dot(this_5.covariance_0, vec3(_S177 * _S178, _S177 * _S179, _S178 * _S179)), 0.0);
}

float mean_area_0(Group_0 group_1, vec3 direction_5)
{
    float _S180 = dot(direction_5, group_1.tangent_9);
    float _S181 = group_1.roughness_6;
    float _S182 = _S181 * _S181;
    return sqrt(max((_S182 - 1.0) * (_S180 * _S180 + Group_variance_along_0(group_1, direction_5)) + 1.0, _S182));
}

float mean_density_0(Group_0 group_2, vec3 half_0)
{
    float _S183 = group_2.roughness_6;
    float _S184 = max(sqrt(max(1.0 - _S183 * _S183, 0.0)) / group_2.roughness_6, 0.00100000004749745);
    float _S185 = max(sqrt(3.0 * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516 + 0.00009999999747379);
    float _S186 = dot(half_0, group_2.tangent_9);
    float _S187 = _S184 * (_S186 - _S185);
    float _S188 = _S184 * (_S186 + _S185);
    float _S189 = _S187 * _S188;
    float _S190 = 2.0 * _S185 * _S184;
    return 0.15915493667125702 / group_2.roughness_6 * ((1.0 - _S189) / ((_S187 * _S187 + 1.0) * (_S188 * _S188 + 1.0)) + arc_tangent_0(_S190, 1.0 + _S189) / _S190);
}

float layer_value_0(Group_0 group_3, vec3 half_1, vec3 light_7, vec3 view_6, float optical_depth_3)
{
    bool _S191 = (light_7.z) < 0.0;
    float _S192 = dot(light_7, group_3.normal_8);
    float _S193;
    if(_S191)
    {
        _S193 = - _S192;
    }
    else
    {
        _S193 = _S192;
    }
    float _S194 = max(dot(view_6, group_3.normal_8), 0.01999999955296516);
    float _S195 = mean_area_0(group_3, light_7) / max(_S193, 0.01999999955296516);
    float _S196 = mean_area_0(group_3, view_6) / _S194;
    if(_S191)
    {
        _S193 = abs(_S195 - _S196);
    }
    else
    {
        _S193 = _S195 + _S196;
    }
    float _S197 = optical_depth_3 * max(_S193, 0.00100000004749745);
    if(_S191)
    {
        _S193 = exponential_0(- optical_depth_3 * min(_S195, _S196));
    }
    else
    {
        _S193 = 1.0;
    }
    float _S198 = optical_depth_3 * _S193 * (1.0 - exponential_0(- _S197)) / _S197 / _S194;
    if(_S191)
    {
        _S193 = 1.0;
    }
    else
    {
        _S193 = 1.0 - 0.34999999403953552 * (1.0 - square_1(group_3.normal_8));
    }
    return 0.25 * mean_density_0(group_3, half_1) * _S193 * _S198;
}

struct Bound_0
{
    uint thread_12;
    float turns_2;
    float cell_9;
    float visible_0;
    float width_2;
    float gap_0;
};

Bound_0 bound_at_0(uint family_10, float position_5)
{
    Cell_0 _S199 = locate_0(family_10, position_5);
    float _S200 = table_number_0(families_0._data[uint(family_10)].before_0 + 2U * _S199.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_12 = _S199.thread_0;
    bound_0.turns_2 = round((position_5 - families_0._data[uint(family_10)].start_0 - _S200 - _S199.below_0) * families_0._data[uint(family_10)].inverse_period_0);
    bound_0.cell_9 = _S199.below_0;
    float _S201 = 2.0 * _S199.half_width_1;
    bound_0.width_2 = _S201;
    bound_0.visible_0 = clamp((_S199.across_2 + _S199.half_width_1) / _S201, 0.0, 1.0);
    bound_0.gap_0 = min(_S199.below_0, _S199.below_0 - _S199.across_2 - _S199.half_width_1) + max(_S199.across_2 - _S199.half_width_1, 0.0);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_11, float centre_1, float size_2)
{
    float _S202 = centre_1 - floor((centre_1 - families_0._data[uint(family_11)].start_0) * families_0._data[uint(family_11)].inverse_period_0) * families_0._data[uint(family_11)].period_0;
    float _S203 = 0.5 * max(size_2, families_0._data[uint(family_11)].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_0 = bound_at_0(family_11, _S202 - _S203);
    stretch_0.high_0 = bound_at_0(family_11, _S202 + _S203);
    return stretch_0;
}

float Stretch_turns_0(Stretch_0 this_6)
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

vec3 lengths_0(uint family_12, Stretch_0 stretch_1)
{
    float _S204 = Stretch_turns_0(stretch_1);
    uint _S205 = families_0._data[uint(family_12)].before_0 + 2U * stretch_1.low_0.thread_12;
    uint _S206 = families_0._data[uint(family_12)].before_0 + 2U * stretch_1.high_0.thread_12;
    float _S207 = table_number_0(_S206) - table_number_0(_S205);
    float _S208 = table_number_0(_S206 + 1U) - table_number_0(_S205 + 1U);
    return vec3(_S207 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_2 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_2 + _S204 * families_0._data[uint(family_12)].visible_total_0, _S208 - _S207 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S204 * (families_0._data[uint(family_12)].period_0 - families_0._data[uint(family_12)].visible_total_0), _S208 + stretch_1.high_0.cell_9 - stretch_1.low_0.cell_9 + _S204 * families_0._data[uint(family_12)].period_0);
}

vec2 integrals_along_0(uint family_13, Stretch_0 stretch_2, uint quantity_0)
{
    uint _S209 = 3U * families_0._data[uint(family_13)].quantities_0;
    uint _S210 = families_0._data[uint(family_13)].colour_threads_0 + _S209 * stretch_2.low_0.thread_12 + quantity_0;
    uint _S211 = families_0._data[uint(family_13)].colour_threads_0 + _S209 * stretch_2.high_0.thread_12 + quantity_0;
    uint _S212 = families_0._data[uint(family_13)].colour_threads_0 + _S209 * uint(families_0._data[uint(family_13)].count_0) + quantity_0;
    float _S213 = table_number_0(_S210);
    float _S214 = table_number_0(_S211);
    float _S215 = Stretch_turns_0(stretch_2);
    uint _S216 = 2U * families_0._data[uint(family_13)].quantities_0;
    return vec2(table_number_0(_S211 + families_0._data[uint(family_13)].quantities_0) - table_number_0(_S210 + families_0._data[uint(family_13)].quantities_0) + _S214 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_2 - _S213 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_2 + _S215 * table_number_0(_S212 + families_0._data[uint(family_13)].quantities_0), table_number_0(_S211 + _S216) - table_number_0(_S210 + _S216) + _S214 * stretch_2.high_0.cell_9 - _S213 * stretch_2.low_0.cell_9 + _S215 * table_number_0(_S212 + _S216));
}

bool Stretch_wraps_0(Stretch_0 this_7)
{
    return (this_7.high_0.thread_12) < (this_7.low_0.thread_12);
}

uvec4 Stretch_differences_0(Stretch_0 this_8, uvec4 entries_0, uint whole_0)
{
    uint _S217 = entries_0.z;
    uint _S218 = entries_0.x;
    uint _S219 = _S217 - _S218;
    uint _S220;
    if(Stretch_wraps_0(this_8))
    {
        _S220 = whole_0;
    }
    else
    {
        _S220 = 0U;
    }
    return uvec4(_S219 + _S220, entries_0.w - _S217, entries_0.y - _S218, whole_0);
}

uvec4 row_differences_0(Stretch_0 across_5, uint row_2, uint count_2, uint quantities_1)
{
    uint _S221 = row_2 + across_5.low_0.thread_12 * quantities_1;
    uint _S222 = row_2 + across_5.high_0.thread_12 * quantities_1;
    return Stretch_differences_0(across_5, uvec4(words_0._data[uint(_S221)], words_0._data[uint(_S221 + quantities_1)], words_0._data[uint(_S222)], words_0._data[uint(_S222 + quantities_1)]), words_0._data[uint(row_2 + count_2 * quantities_1)]);
}

vec4 Stretch_weights_0(Stretch_0 this_9)
{
    float _S223 = - this_9.low_0.visible_0;
    float _S224 = Stretch_turns_0(this_9);
    float _S225;
    if(Stretch_wraps_0(this_9))
    {
        _S225 = 1.0;
    }
    else
    {
        _S225 = 0.0;
    }
    return vec4(1.0, this_9.high_0.visible_0, _S223, _S224 - _S225);
}

float integral_on_top_0(uint family_14, Stretch_0 across_6, Stretch_0 along_1, uint crossing_count_0, uint quantity_1)
{
    uint _S226 = uint(families_0._data[uint(family_14)].count_0);
    uint _S227 = (_S226 + 1U) * families_0._data[uint(family_14)].quantities_0;
    uint _S228 = families_0._data[uint(family_14)].colour_areas_0 + quantity_1;
    uvec4 _S229 = row_differences_0(across_6, _S228 + along_1.low_0.thread_12 * _S227, _S226, families_0._data[uint(family_14)].quantities_0);
    uvec4 _S230 = row_differences_0(across_6, _S228 + (along_1.low_0.thread_12 + 1U) * _S227, _S226, families_0._data[uint(family_14)].quantities_0);
    uvec4 _S231 = row_differences_0(across_6, _S228 + along_1.high_0.thread_12 * _S227, _S226, families_0._data[uint(family_14)].quantities_0);
    uvec4 _S232 = row_differences_0(across_6, _S228 + (along_1.high_0.thread_12 + 1U) * _S227, _S226, families_0._data[uint(family_14)].quantities_0);
    uvec4 _S233 = row_differences_0(across_6, _S228 + crossing_count_0 * _S227, _S226, families_0._data[uint(family_14)].quantities_0);
    uvec4 _S234 = _S231 - _S229;
    uvec4 _S235;
    if(Stretch_wraps_0(along_1))
    {
        _S235 = _S233;
    }
    else
    {
        _S235 = uvec4(ivec4(0));
    }
    vec4 _S236 = Stretch_weights_0(across_6);
    return dot(vec4(dot(vec4(ivec4(_S234 + _S235)), _S236), dot(vec4(ivec4(_S232 - _S231)), _S236), dot(vec4(ivec4(_S230 - _S229)), _S236), dot(vec4(ivec4(_S233)), _S236)), Stretch_weights_0(along_1)) * families_0._data[uint(family_14)].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_3, uint row_3)
{
    Albedos_0 _S237 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_3 * _S237.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_3 * _S237.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_3 * _S237.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_3 * _S237.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_15, uint crossing_1, Stretch_0 own_1, Stretch_0 other_2, bool back_5)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0._data[uint(family_15)].colour_mean_0);
    if((families_0._data[uint(family_15)].quantities_0) == 1U)
    {
        return albedos_2;
    }
    vec3 _S238 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_4 = 0.0;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0._data[uint(family_15)].quantities_0))
        {
        }
        else
        {
            break;
        }
        vec2 _S239 = integrals_along_0(family_15, own_1, quantity_2);
        float _S240 = integral_on_top_0(family_15, own_1, other_2, uint(families_0._data[uint(crossing_1)].count_0), quantity_2);
        float _S241 = _S239.x;
        float _S242 = _S241 * _S238.x;
        float _S243;
        if(back_5)
        {
            _S243 = _S242 - _S240;
        }
        else
        {
            _S243 = _S240;
        }
        bool _S244 = quantity_2 == 0U;
        if(_S244)
        {
            is_exposed_0 = _S243 > (16.0 * families_0._data[uint(family_15)].area_unit_0 * min(_S242 / families_0._data[uint(family_15)].crossing_area_0, 1.0) + 0.00000999999974738 * _S242);
        }
        float _S245 = _S241 * _S238.y;
        float _S246;
        if(is_exposed_0)
        {
            _S246 = _S243;
        }
        else
        {
            _S246 = 0.0;
        }
        float _S247 = _S245 + _S246 + 0.000244140625 * _S238.z * _S239.y;
        if(_S244)
        {
            weight_4 = 1.0 / max(_S247, 9.99999968265522539e-21);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S247 * weight_4, families_0._data[uint(family_15)].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate_0(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate_0(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate_0(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate_0(albedos_2.specular_transmit_0);
    return albedos_2;
}

Albedos_0 lerp_albedos_0(Albedos_0 first_2, Albedos_0 second_1, float weight_5)
{
    Albedos_0 albedos_3;
    vec3 _S248 = vec3(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S248);
    albedos_3.diffuse_transmit_0 = mix(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S248);
    albedos_3.specular_reflect_0 = mix(first_2.specular_reflect_0, second_1.specular_reflect_0, _S248);
    albedos_3.specular_transmit_0 = mix(first_2.specular_transmit_0, second_1.specular_transmit_0, _S248);
    return albedos_3;
}

Albedos_0 tinted_0(Albedos_0 albedos_4, vec3 tint_0)
{
    Albedos_0 result_2 = albedos_4;
    result_2.diffuse_reflect_0 = result_2.diffuse_reflect_0 * tint_0;
    result_2.diffuse_transmit_0 = result_2.diffuse_transmit_0 * tint_0;
    return result_2;
}

struct FaceRadiance_0
{
    vec3 warp_3;
    vec3 weft_3;
    vec3 mean_0;
    vec3 leaked_0;
};

struct FaceSends_0
{
    vec3 sky_warp_0;
    vec3 sky_weft_0;
    vec3 crossing_warp_0;
    vec3 crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

FaceRadiance_0 face_radiance_0(FaceSends_0 sends_0, float open_of_other_0, vec3 passed_0, vec3 from_other_0)
{
    vec3 _S249 = (1.0 - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    vec3 _S250 = sends_0.sky_warp_0 + _S249 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S250;
    vec3 _S251 = sends_0.sky_weft_0 + _S249 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S251;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S250 + sends_0.blocks_weft_0 * _S251;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(vec3 view_7, out float  terms_0[6])
{
    float _S252 = 1.0 - view_7.z;
    float _S253 = _S252 * _S252;
    terms_0[0] = 1.0;
    float _S254 = view_7.x;
    float _S255 = _S254 * _S254;
    float _S256 = view_7.y;
    float _S257 = _S256 * _S256;
    terms_0[1] = sqrt(max(_S255 + _S257, 9.999999960041972e-13));
    terms_0[2] = _S253;
    terms_0[3] = _S253 * _S253;
    terms_0[4] = _S255 - _S257;
    terms_0[5] = 0.0;
    return;
}

struct Bounced_0
{
    vec3 reflected_0;
    vec3 transmitted_0;
};

struct Scattered_0
{
    vec3 back_6;
    vec3 through_0;
};

struct Interior_0
{
    vec3 warp_4;
    vec3 weft_4;
    vec3 leaked_1;
    vec3 far_1;
    vec3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_1, Scattered_0 yarn_2, Interior_0 interior_0)
{
    vec3 _S258 = (blocked_1.by_warp_0 + blocked_1.by_weft_0) * interior_0.leaked_1;
    vec3 _S259 = blocked_1.far_0 * yarn_2.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_2.back_6 * (blocked_1.by_warp_0 * interior_0.warp_4 + blocked_1.by_weft_0 * interior_0.weft_4) + _S259 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S259 * interior_0.far_1 + yarn_2.back_6 * _S258;
    return bounced_0;
}

Bounced_0 sum_of_0(Bounced_0 first_3, Bounced_0 second_2)
{
    Bounced_0 sum_1;
    sum_1.reflected_0 = first_3.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_3.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

vec3 bounced_value_0(Bounced_0 bounced_1, vec3 light_8, vec3 view_8)
{
    float _S260 = light_8.z;
    vec3 _S261;
    if((_S260 * view_8.z) < 0.0)
    {
        _S261 = bounced_1.transmitted_0;
    }
    else
    {
        _S261 = bounced_1.reflected_0;
    }
    return _S261 * (abs(_S260) * 0.31830987334251404);
}

float sheen_scale_0(float x_10, float y_2)
{
    return (((((0.0 * x_10 + (((((-1.1402510404586792 * y_2 + 0.40672621130943298) * y_2 + 1.65398800373077393) * y_2 + -1.29730904102325439) * y_2 + 0.30570998787879944) * y_2 + -0.0220868494361639)) * x_10 + (((((-0.21142719686031342 * y_2 + 1.05947399139404297) * y_2 + -0.41116121411323547) * y_2 + -0.93859231472015381) * y_2 + 0.51606941223144531) * y_2 + 0.05409301072359085)) * x_10 + (((((1.22944498062133789 * y_2 + -0.45962560176849365) * y_2 + -1.63861405849456787) * y_2 + 1.33565104007720947) * y_2 + -0.45725581049919128) * y_2 + 0.08243165910243988)) * x_10 + (((((0.39779931306838989 * y_2 + -1.18879103660583496) * y_2 + 0.28251591324806213) * y_2 + 1.168984055519104) * y_2 + -0.76864629983901978) * y_2 + 0.0091691892594099)) * x_10 + (((((-0.26563560962677002 * y_2 + -0.19379159808158875) * y_2 + 0.2677634060382843) * y_2 + 0.00270519289188087) * y_2 + 0.14349560439586639) * y_2 + 0.10290180146694183)) * x_10 + (((((-0.20701569318771362 * y_2 + 0.24526430666446686) * y_2 + 0.19551840424537659) * y_2 + 0.07586126774549484) * y_2 + 0.38894739747047424) * y_2 + 0.15043120086193085);
}

float sheen_shear_0(float x_11, float y_3)
{
    return ((((0.0 * x_11 + (((((-0.10608240216970444 * y_3 + 1.99214303493499756) * y_3 + -1.42255294322967529) * y_3 + -1.09495604038238525) * y_3 + 0.59180057048797607) * y_3 + 0.06902855634689331)) * x_11 + (((((-0.46220690011978149 * y_3 + -0.29113379120826721) * y_3 + 1.39025199413299561) * y_3 + 0.35589990019798279) * y_3 + -1.17120099067687988) * y_3 + 0.15940259397029877)) * x_11 + (((((2.26068711280822754 * y_3 + -3.64728999137878418) * y_3 + -0.72173482179641724) * y_3 + 3.07659196853637695) * y_3 + -0.6827620267868042) * y_3 + -0.3039557933807373)) * x_11 + (((((0.81201767921447754 * y_3 + 0.36014080047607422) * y_3 + -1.72646903991699219) * y_3 + -0.22630110383033752) * y_3 + 0.89514690637588501) * y_3 + -0.10397960245609283)) * x_11 + (((((-0.37648698687553406 * y_3 + 1.10974001884460449) * y_3 + 0.17824520170688629) * y_3 + -1.04968702793121338) * y_3 + 0.1461234986782074) * y_3 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_12, float y_4)
{
    return ((((0.0 * x_12 + (((((12.95646953582763672 * y_4 + -21.38032913208007812) * y_4 + -7.37853097915649414) * y_4 + 34.55607986450195312) * y_4 + -23.61347007751464844) * y_4 + 5.00126314163208008)) * x_12 + (((((10.91487026214599609 * y_4 + -6.08202791213989258) * y_4 + -38.2036285400390625) * y_4 + 53.3440399169921875) * y_4 + -21.91996002197265625) * y_4 + 2.01606011390686035)) * x_12 + (((((-14.52206039428710938 * y_4 + 36.803619384765625) * y_4 + -22.94047927856445312) * y_4 + -10.07973003387451172) * y_4 + 15.77003955841064453) * y_4 + -4.92722177505493164)) * x_12 + (((((-7.62505722045898438 * y_4 + 1.27310299873352051) * y_4 + 31.19523048400878906) * y_4 + -44.39989852905273438) * y_4 + 26.44947052001953125) * y_4 + -8.73507976531982422)) * x_12 + (((((5.65633487701416016 * y_4 + -17.66820907592773438) * y_4 + 24.65356063842773438) * y_4 + -19.38941001892089844) * y_4 + 11.06159019470214844) * y_4 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S262 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S263 = 2.0 * sqrt(_S262) - 1.0;
    float _S264 = 3.0 * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S263, _S264), 0.00999999977648258, 1.0), clamp((1.0 - _S262) * sheen_shear_0(_S263, _S264), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S263, _S264), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_9, vec3 view_9, float scale_0, float shear_0)
{
    float _S265 = light_9.z;
    bool _S266;
    if(_S265 <= 0.0)
    {
        _S266 = true;
    }
    else
    {
        _S266 = (view_9.z) <= 0.0;
    }
    if(_S266)
    {
        return 0.0;
    }
    vec2 _S267 = view_9.xy;
    float _S268 = dot(_S267, _S267);
    vec2 _S269;
    if(_S268 > 9.99999968265522539e-21)
    {
        _S269 = _S267 * (inversesqrt((_S268)));
    }
    else
    {
        _S269 = vec2(1.0, 0.0);
    }
    float _S270 = scale_0 * dot(light_9.xy, _S269) + shear_0 * _S265;
    float _S271 = scale_0 * (light_9.y * _S269.x - light_9.x * _S269.y);
    float _S272 = _S270 * _S270 + _S271 * _S271 + _S265 * _S265;
    return 0.31830987334251404 * scale_0 * scale_0 * _S265 / max(_S272 * _S272, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_10, vec3 view_10, float strength_0, float roughness_9)
{
    vec3 _S273 = sheen_lobe_0(view_10.z, roughness_9);
    float _S274 = strength_0 * _S273.z;
    return vec2(_S274 * transformed_cosine_0(light_10, view_10, _S273.x, _S273.y), 1.0 - _S274);
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_5;
    Albedos_0 weft_5;
};

struct Estimate_0
{
    Components_0 components_0;
    CloseUp_0 close_0;
    FamilyAlbedos_0 albedos_5;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_0;
};

Regime_0 regime_of_0(uint _S275, Footprint_0 _S276, float _S277)
{
    float _S278 = Footprint_spread_side_0(_S276);
    float _S279 = clamp((binary_logarithm_0(max(_S278, 9.99999971718068537e-10)) - fabrics_0._data[uint(_S275)].lobes_0.unit_level_0 - -0.7369655966758728) / 1.41503751277923584, 0.0, 1.0);
    Regime_0 regime_0;
    float _S280 = _S279 * _S279 * (3.0 - 2.0 * _S279);
    regime_0.prefiltered_0 = _S280;
    regime_0.threads_1 = _S278 * fabrics_0._data[uint(_S275)].lobes_0.threads_per_mm_0;
    float _S281 = mix(max(8.0 / _S277, 1.0), 1.0, _S280);
    float _S282;
    if(_S280 < 1.0)
    {
        _S282 = clamp(regime_0.threads_1 * 12.0, 1.0, _S281);
    }
    else
    {
        _S282 = 0.0;
    }
    regime_0.points_0 = _S282;
    return regime_0;
}

bool varies_at_0(uint _S283, float _S284)
{
    bool _S285;
    if((fabrics_0._data[uint(_S283)].fibre_noise_0) > 0.0)
    {
        _S285 = true;
    }
    else
    {
        _S285 = (fabrics_0._data[uint(_S283)].colour_noise_0) > 0.0;
    }
    if(_S285)
    {
        _S285 = true;
    }
    else
    {
        if((fabrics_0._data[uint(_S283)].has_detail_0) != 0U)
        {
            _S285 = _S284 >= 0.0;
        }
        else
        {
            _S285 = false;
        }
    }
    return _S285;
}

struct Hit_0
{
    float x_13;
    float y_5;
    bool hole_5;
    float height_5;
};

struct Sample_0
{
    Crossing_0 crossing_2;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_6;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S286, float _S287, float _S288, bool _S289)
{
    Crossing_0 crossing_3;
    crossing_3.warp_2 = locate_0(fabrics_0._data[uint(_S286)].warp_0, _S287);
    crossing_3.weft_2 = locate_0(fabrics_0._data[uint(_S286)].weft_0, _S288);
    uint _S290 = fabrics_0._data[uint(_S286)].run_words_0 + 2U * (crossing_3.weft_2.thread_0 * fabrics_0._data[uint(_S286)].ends_1 + crossing_3.warp_2.thread_0);
    uint _S291 = words_0._data[uint(_S290)];
    crossing_3.warp_word_0 = _S291;
    crossing_3.weft_word_0 = words_0._data[uint(_S290 + 1U)];
    crossing_3.warp_above_0 = ((_S291 & 1U) == 1U) != _S289;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S292, float _S293, float _S294, bool _S295)
{
    Sample_0 sample_0;
    Crossing_0 _S296 = crossing_at_0(_S292, _S293, _S294, _S295);
    sample_0.crossing_2 = _S296;
    Shown_0 _S297 = shown_at_0(_S296, _S295);
    sample_0.shown_3 = _S297;
    uint _S298;
    if(_S297.is_warp_2)
    {
        _S298 = fabrics_0._data[uint(_S292)].warp_0;
    }
    else
    {
        _S298 = fabrics_0._data[uint(_S292)].weft_0;
    }
    uint _S299;
    if(_S297.is_warp_2)
    {
        _S299 = fabrics_0._data[uint(_S292)].weft_0;
    }
    else
    {
        _S299 = fabrics_0._data[uint(_S292)].warp_0;
    }
    Cell_0 _S300 = select_cell_0(_S297.is_warp_2, sample_0.crossing_2.warp_2, sample_0.crossing_2.weft_2);
    Cell_0 _S301 = select_cell_0(_S297.is_warp_2, sample_0.crossing_2.weft_2, sample_0.crossing_2.warp_2);
    Run_0 _S302 = unpack_0(_S298, _S299, _S300.thread_0, _S301, _S297.word_0);
    Section_0 _S303 = section_at_0(_S300);
    bool _S304;
    if(_S297.on_top_0)
    {
        _S304 = (_S302.distance_0) < (_S303.drop_0 * _S302.bend_1.sine_0);
    }
    else
    {
        _S304 = false;
    }
    bool _S305;
    if(_S297.on_top_0)
    {
        _S305 = !_S304;
    }
    else
    {
        _S305 = false;
    }
    float _S306;
    if(_S305)
    {
        _S306 = 1.0;
    }
    else
    {
        _S306 = -1.0;
    }
    float _S307;
    if(_S304)
    {
        _S307 = _S302.other_reach_0;
    }
    else
    {
        _S307 = _S302.reach_0;
    }
    float _S308;
    if(_S304)
    {
        _S308 = _S307 + _S302.distance_0;
    }
    else
    {
        _S308 = max(_S307 - _S302.distance_0, 0.0);
    }
    float _S309 = _S307 / _S302.bend_1.sine_0 - _S306 * _S303.drop_0;
    float _S310 = _S308 * _S308;
    float _S311 = max(_S309 * _S309 - _S310, 9.99999968265522539e-21);
    float _S312 = (inversesqrt((_S311)));
    float _S313 = _S310 / (_S311 * _S312 + _S309);
    bool _S314 = _S308 > 0.0;
    float _S315;
    if(_S297.on_top_0)
    {
        _S315 = 1.0;
    }
    else
    {
        _S315 = -1.0;
    }
    float _S316;
    if(_S302.near_start_0)
    {
        _S316 = 1.0;
    }
    else
    {
        _S316 = -1.0;
    }
    float _S317 = _S315 * _S316;
    if(_S314)
    {
        _S315 = _S309 * _S312;
    }
    else
    {
        _S315 = 1.0;
    }
    sample_0.slope_across_0 = _S303.slope_0 * _S315;
    if(_S314)
    {
        _S308 = _S317 * _S308 * _S312;
    }
    else
    {
        _S308 = 0.0;
    }
    sample_0.slope_along_0 = _S308;
    float _S318 = families_0._data[uint(_S298)].height_scale_0;
    vec2 _S319 = dive_0(_S299, _S297, _S302, _S301);
    if(_S302.straight_0)
    {
        _S306 = 0.0;
    }
    else
    {
        _S306 = _S318 * _S306;
    }
    sample_0.height_6 = _S306 * (_S307 * _S302.bend_1.half_tangent_0 - _S313) - _S318 * _S303.drop_0 - _S319.x;
    float _S320 = _S318 * sample_0.slope_across_0;
    float _S321 = _S318 * sample_0.slope_along_0 - _S319.y;
    if(_S297.is_warp_2)
    {
        _S306 = _S320;
    }
    else
    {
        _S306 = _S321;
    }
    sample_0.slope_x_1 = _S306;
    if(_S297.is_warp_2)
    {
        _S306 = _S321;
    }
    else
    {
        _S306 = _S320;
    }
    sample_0.slope_y_1 = _S306;
    sample_0.run_3 = _S302;
    sample_0.section_1 = _S303;
    return sample_0;
}

float steps_per_length_0(uint _S322, SearchQuality_0 _S323, vec3 _S324)
{
    return max(max(abs(_S324.x) * fabrics_0._data[uint(_S322)].threads_per_x_0, abs(_S324.y) * fabrics_0._data[uint(_S322)].threads_per_y_0) * _S323.steps_per_thread_0, abs(_S324.z) * fabrics_0._data[uint(_S322)].per_relief_0 * _S323.steps_per_relief_0);
}

float cell_maximum_0(uint _S325, Crossing_0 _S326)
{
    uint _S327;
    if(_S326.warp_above_0)
    {
        _S327 = fabrics_0._data[uint(_S325)].warp_0;
    }
    else
    {
        _S327 = fabrics_0._data[uint(_S325)].weft_0;
    }
    uint _S328;
    if(_S326.warp_above_0)
    {
        _S328 = _S326.warp_word_0;
    }
    else
    {
        _S328 = _S326.weft_word_0;
    }
    return float(_S328 >> 28) * families_0._data[uint(_S327)].height_scale_0 * families_0._data[uint(_S327)].level_0;
}

Probe_0 probe_0(uint _S329, float _S330, float _S331, bool _S332, bool _S333, bool _S334)
{
    Sample_0 _S335 = sample_at_0(_S329, _S330, _S331, _S332);
    Probe_0 probe_1;
    probe_1.height_3 = _S335.height_6;
    probe_1.hole_4 = _S335.shown_3.hole_3;
    probe_1.slope_x_0 = _S335.slope_x_1;
    probe_1.slope_y_0 = _S335.slope_y_1;
    uint _S336;
    if(_S335.shown_3.is_warp_2)
    {
        _S336 = _S335.crossing_2.warp_2.thread_0 * 2U + 1U;
    }
    else
    {
        _S336 = _S335.crossing_2.weft_2.thread_0 * 2U;
    }
    probe_1.yarn_1 = _S336;
    probe_1.cell_max_0 = cell_maximum_0(_S329, _S335.crossing_2);
    float _S337;
    if(_S333)
    {
        _S337 = _S335.crossing_2.warp_2.above_0;
    }
    else
    {
        _S337 = _S335.crossing_2.warp_2.below_0;
    }
    probe_1.side_x_0 = _S337;
    if(_S334)
    {
        _S337 = _S335.crossing_2.weft_2.above_0;
    }
    else
    {
        _S337 = _S335.crossing_2.weft_2.below_0;
    }
    probe_1.side_y_0 = _S337;
    probe_1.edge_x_0 = outline_distance_0(_S335.crossing_2.warp_2, _S335.shown_3, _S335.run_3, !_S335.shown_3.is_warp_2, _S333);
    probe_1.edge_y_0 = outline_distance_0(_S335.crossing_2.weft_2, _S335.shown_3, _S335.run_3, _S335.shown_3.is_warp_2, _S334);
    return probe_1;
}

bool is_free_0(uint _S338, SearchQuality_0 _S339, vec3 _S340, vec3 _S341, bool _S342, float _S343)
{
    float _S344 = _S341.z;
    if(_S344 <= 0.0)
    {
        return false;
    }
    float _S345 = 1.0 / max(_S339.shadow_share_0 * steps_per_length_0(_S338, _S339, _S341), 9.99999971718068537e-10);
    StepControl_0 _S346 = step_control_0(_S341.xy, _S345);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S347;
        if(count_3 < 1024U)
        {
            _S347 = (_S340.z + _S344 * distance_1) < _S343;
        }
        else
        {
            _S347 = false;
        }
        if(_S347)
        {
        }
        else
        {
            break;
        }
        vec3 _S348 = _S340 + _S341 * distance_1;
        Probe_0 _S349 = probe_0(_S338, _S348.x, _S348.y, _S342, _S346.right_0, _S346.up_0);
        float _S350 = _S348.z;
        float _S351 = _S350 - _S349.height_3;
        float _S352 = _S344 - _S349.slope_x_0 * _S341.x - _S349.slope_y_0 * _S341.y;
        bool _S353;
        if(!_S349.hole_4)
        {
            _S353 = _S351 < 0.0;
        }
        else
        {
            _S353 = false;
        }
        if(_S353)
        {
            return false;
        }
        float _S354 = way_back_to_dip_0(previous_3, _S351, _S352, last_step_0, _S349);
        if(_S354 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S354;
            distance_1 = distance_1 - _S354;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S355 = _S350 > (_S349.cell_max_0);
        PreviousSample_0 _S356 = after_sample_0(_S351, _S352, _S349, _S355);
        float last_step_2;
        if(_S355)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S346, _S349.side_x_0, _S349.side_y_0), _S345);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S346, _S349, _S351, _S352);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S356;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S357, SearchQuality_0 _S358, float _S359, float _S360, vec3 _S361, bool _S362)
{
    if(!sample_at_0(_S357, _S359, _S360, _S362).shown_3.hole_3)
    {
        return false;
    }
    vec3 _S363 = vec3(_S359, _S360, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S364;
        if(side_0 < 2U)
        {
            _S364 = passes_0;
        }
        else
        {
            _S364 = false;
        }
        if(_S364)
        {
        }
        else
        {
            break;
        }
        vec3 _S365;
        if(side_0 == 0U)
        {
            _S365 = _S361;
        }
        else
        {
            _S365 = vec3(- _S361.x, - _S361.y, _S361.z);
        }
        bool _S366 = is_free_0(_S357, _S358, _S363, _S365, _S362 != (side_0 == 1U), fabrics_0._data[uint(_S357)].height_high_0);
        uint _S367 = side_0 + 1U;
        passes_0 = _S366;
        side_0 = _S367;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_7;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

float max_height_along_0(uint _S368, float _S369, float _S370, float _S371, vec3 _S372, bool _S373)
{
    uint _S374 = locate_0(fabrics_0._data[uint(_S368)].warp_0, _S369).thread_0 / 2U;
    uint _S375 = locate_0(fabrics_0._data[uint(_S368)].weft_0, _S370).thread_0 / 2U;
    float _S376 = _S372.x;
    uint _S377;
    if(_S376 > 0.0)
    {
        _S377 = 1U;
    }
    else
    {
        _S377 = 0U;
    }
    float _S378 = _S372.y;
    uint _S379;
    if(_S378 > 0.0)
    {
        _S379 = 2U;
    }
    else
    {
        _S379 = 0U;
    }
    uint _S380 = words_0._data[uint(fabrics_0._data[uint(_S368)].max_heights_0 + 4U * (_S375 * fabrics_0._data[uint(_S368)].max_height_columns_0 + _S374) + (_S377 + _S379))];
    int number_0;
    if(_S373)
    {
        number_0 = 4;
    }
    else
    {
        number_0 = 0;
    }
    uint _S381 = _S380 >> number_0;
    float _S382 = max(abs(_S376) * fabrics_0._data[uint(_S368)].threads_per_x_0, abs(_S378) * fabrics_0._data[uint(_S368)].threads_per_y_0) / _S372.z;
    float _S383 = fabrics_0._data[uint(_S368)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S368)].height_high_0;
    number_0 = 3;
    for(;;)
    {
        if(number_0 >= 0)
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S371) * _S382) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S381 >> uint(8 * number_0)) & 15U) * 0.06666667014360428 * _S383);
        }
        number_0 = number_0 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S384, float _S385, float _S386, bool _S387, bool _S388, bool _S389)
{
    Crossing_0 _S390 = crossing_at_0(_S384, _S385, _S386, _S387);
    float _S391 = cell_maximum_0(_S384, _S390);
    float _S392;
    if(_S388)
    {
        _S392 = _S390.warp_2.above_0;
    }
    else
    {
        _S392 = _S390.warp_2.below_0;
    }
    float _S393;
    if(_S389)
    {
        _S393 = _S390.weft_2.above_0;
    }
    else
    {
        _S393 = _S390.weft_2.below_0;
    }
    return vec3(_S391, _S392, _S393);
}

float first_sample_height_0(uint _S394, ViewRay_0 _S395, StepControl_0 _S396, bool _S397)
{
    float _S398 = max_height_along_0(_S394, _S395.origin_0.x, _S395.origin_0.y, 0.0, vec3(_S395.slope_1, 1.0), _S397);
    uint count_4 = 0U;
    float height_8 = _S398;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S399 = ViewRay_at_0(_S395, height_8);
        vec3 _S400 = cell_bounds_0(_S394, _S399.x, _S399.y, _S397, _S396.right_0, _S396.up_0);
        float _S401 = height_8 - _S400.x;
        float _S402 = StepControl_to_cell_exit_0(_S396, _S400.y, _S400.z);
        float height_9 = height_8 - clamp(_S401, 0.0, _S402);
        if(_S401 <= _S402)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S403, ViewRay_0 _S404, StepControl_0 _S405, bool _S406)
{
    float _S407 = fabrics_0._data[uint(_S403)].height_low_0 - (fabrics_0._data[uint(_S403)].height_high_0 - fabrics_0._data[uint(_S403)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_7 = first_sample_height_0(_S403, _S404, _S405, _S406);
    end_1.last_step_3 = _S405.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0;
    end_1.rate_4 = 0.0;
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
        vec2 _S408 = ViewRay_at_0(_S404, end_1.height_7);
        Probe_0 _S409 = probe_0(_S403, _S408.x, _S408.y, _S406, _S405.right_0, _S405.up_0);
        float _S410 = end_1.height_7 - _S409.height_3;
        float _S411 = ViewRay_rate_0(_S404, _S409);
        end_1.depth_1 = - _S410;
        end_1.rate_4 = _S411;
        bool _S412;
        if(end_1.previous_4.known_0)
        {
            _S412 = !_S409.hole_4;
        }
        else
        {
            _S412 = false;
        }
        bool _S413;
        if(_S412)
        {
            _S413 = (end_1.previous_4.yarn_0) == (_S409.yarn_1);
        }
        else
        {
            _S413 = false;
        }
        end_1.smooth_0 = _S413;
        bool _S414;
        if(!_S409.hole_4)
        {
            _S414 = _S410 <= 0.0;
        }
        else
        {
            _S414 = false;
        }
        bool _S415;
        if(_S414)
        {
            _S415 = true;
        }
        else
        {
            _S415 = (end_1.height_7) <= _S407;
        }
        if(_S415)
        {
            break;
        }
        float _S416 = way_back_to_dip_0(end_1.previous_4, _S410, _S411, end_1.last_step_3, _S409);
        if(_S416 >= 0.0)
        {
            end_1.height_7 = end_1.height_7 + _S416;
            end_1.last_step_3 = end_1.last_step_3 - _S416;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S417 = min(StepControl_to_cell_exit_0(_S405, _S409.side_x_0, _S409.side_y_0), end_1.height_7 - _S409.cell_max_0);
        float _S418 = StepControl_to_next_sample_0(_S405, _S409, _S410, _S411);
        end_1.previous_4 = after_sample_0(_S410, _S411, _S409, _S417 > _S418);
        float _S419 = max(_S417, _S418);
        end_1.last_step_3 = _S419;
        end_1.height_7 = end_1.height_7 - _S419;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S420, ViewRay_0 _S421, StepControl_0 _S422, bool _S423, ViewRayEnd_0 _S424, uint _S425)
{
    float _S426 = fabrics_0._data[uint(_S420)].height_high_0 - fabrics_0._data[uint(_S420)].height_low_0;
    float above_2 = _S424.height_7 + _S424.last_step_3;
    float above_gap_1 = clamp(_S424.previous_4.clearance_0, 0.0, _S426);
    float under_gap_1 = clamp(_S424.depth_1, 0.0, _S426);
    float _S427 = cubic_root_0(above_gap_1, - under_gap_1, _S424.previous_4.rate_0 * _S424.last_step_3, _S424.rate_4 * _S424.last_step_3);
    float middle_0;
    if(_S424.smooth_0)
    {
        middle_0 = above_2 - _S427 * _S424.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S424.height_7, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S424.height_7;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S425)
        {
        }
        else
        {
            break;
        }
        vec2 _S428 = ViewRay_at_0(_S421, middle_0);
        Probe_0 _S429 = probe_0(_S420, _S428.x, _S428.y, _S423, _S422.right_0, _S422.up_0);
        float _S430;
        if(_S429.hole_4)
        {
            _S430 = -1.0e+09;
        }
        else
        {
            _S430 = _S429.height_3;
        }
        float _S431 = clamp(middle_0 - _S430, - _S426, _S426);
        float _S432;
        if(_S431 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S432 = 0.5 * above_gap_2;
            }
            else
            {
                _S432 = above_gap_2;
            }
            float _S433 = - _S431;
            under_1 = middle_0;
            above_gap_2 = _S432;
            under_gap_2 = _S433;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S432 = 0.5 * under_gap_2;
            }
            else
            {
                _S432 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S431;
            under_gap_2 = _S432;
            side_1 = -1.0;
        }
        if(_S424.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S431 / min(ViewRay_rate_0(_S421, _S429), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S424.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S434, SearchQuality_0 _S435, float _S436, float _S437, vec3 _S438, bool _S439)
{
    float _S440 = max(_S438.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_0 = vec2(_S436, _S437);
    vec2 _S441 = _S438.xy / _S440;
    ray_0.slope_1 = _S441;
    StepControl_0 _S442 = step_control_0(- _S441, 1.0 / max(steps_per_length_0(_S434, _S435, _S438) / _S440, 9.99999971718068537e-10));
    ViewRayEnd_0 _S443 = search_down_0(_S434, ray_0, _S442, _S439);
    Hit_0 hit_0;
    hit_0.hole_5 = false;
    float _S444 = refined_height_0(_S434, ray_0, _S442, _S439, _S443, _S435.refinements_0);
    hit_0.height_5 = _S444;
    vec2 _S445 = ViewRay_at_0(ray_0, _S444);
    hit_0.x_13 = _S445.x;
    hit_0.y_5 = _S445.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S446, SearchQuality_0 _S447, float _S448, float _S449, vec3 _S450, bool _S451)
{
    if(!passes_through_0(_S446, _S447, _S448, _S449, _S450, _S451))
    {
        return first_hit_of_yarn_0(_S446, _S447, _S448, _S449, _S450, _S451);
    }
    Hit_0 hit_1;
    hit_1.x_13 = _S448;
    hit_1.y_5 = _S449;
    hit_1.height_5 = 0.0;
    hit_1.hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S452, float _S453, float _S454, bool _S455)
{
    Sample_0 _S456 = sample_at_0(_S452, _S453, _S454, _S455);
    float _S457;
    if(_S456.shown_3.is_warp_2)
    {
        _S457 = _S456.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S457 = _S456.crossing_2.weft_2.half_width_1;
    }
    uint _S458;
    if(_S456.shown_3.is_warp_2)
    {
        _S458 = fabrics_0._data[uint(_S452)].warp_0;
    }
    else
    {
        _S458 = fabrics_0._data[uint(_S452)].weft_0;
    }
    float _S459 = families_0._data[uint(_S458)].twist_sine_0;
    float _S460;
    if(_S455)
    {
        _S460 = -1.0;
    }
    else
    {
        _S460 = 1.0;
    }
    float _S461 = _S459 * _S460;
    float _S462 = families_0._data[uint(_S458)].twist_cosine_0;
    if(_S456.shown_3.is_warp_2)
    {
        _S460 = 1.0;
    }
    else
    {
        _S460 = -1.0;
    }
    vec2 _S463 = fibre_direction_0(_S456.slope_across_0, _S460 * _S456.slope_along_0, _S461, _S462);
    float _S464;
    if(_S456.shown_3.is_warp_2)
    {
        _S464 = _S456.slope_x_1;
    }
    else
    {
        _S464 = _S456.slope_y_1;
    }
    float _S465;
    if(_S456.shown_3.is_warp_2)
    {
        _S465 = _S456.slope_y_1;
    }
    else
    {
        _S465 = _S456.slope_x_1;
    }
    float _S466 = _S463.x;
    float _S467 = _S463.y;
    float _S468 = _S464 * _S466 + _S460 * _S465 * _S467;
    float _S469 = _S457 * 1.0154266357421875;
    float _S470 = _S469 * arc_sine_0(clamp(_S456.section_1.across_3 / _S469, -1.0, 1.0));
    if(_S456.shown_3.is_warp_2)
    {
        _S457 = _S454;
    }
    else
    {
        _S457 = - _S453;
    }
    SurfacePoint_0 point_1;
    point_1.hole_0 = _S456.shown_3.hole_3;
    point_1.is_warp_0 = _S456.shown_3.is_warp_2;
    point_1.warp_thread_0 = _S456.crossing_2.warp_2.thread_0;
    point_1.weft_thread_0 = _S456.crossing_2.weft_2.thread_0;
    point_1.height_1 = _S456.height_6;
    point_1.normal_0 = normalize(vec3(- _S456.slope_x_1, - _S456.slope_y_1, 1.0));
    vec3 _S471;
    if(_S456.shown_3.is_warp_2)
    {
        _S471 = vec3(_S466, _S467, _S468);
    }
    else
    {
        _S471 = vec3(- _S467, _S466, _S468);
    }
    point_1.tangent_0 = normalize(_S471);
    point_1.across_0 = _S456.section_1.across_3;
    point_1.fibre_across_0 = _S470 * _S462 + _S457 * _S461;
    point_1.fibre_along_0 = _S457 * _S462 - _S470 * _S461;
    return point_1;
}

struct YarnPoint_0
{
    bool back_7;
    bool hole_6;
    bool is_warp_3;
    float x_14;
    float y_6;
    float height_10;
    vec3 normal_9;
    vec3 tangent_10;
    vec3 surface_normal_0;
    float diffuse_gain_1;
    float roughness_10;
    Albedos_0 albedos_6;
};

bool has_hairs_0(uint _S472)
{
    bool _S473;
    if((families_0._data[uint(fabrics_0._data[uint(_S472)].warp_0)].hairiness_0) > 0.0)
    {
        _S473 = true;
    }
    else
    {
        _S473 = (families_0._data[uint(fabrics_0._data[uint(_S472)].weft_0)].hairiness_0) > 0.0;
    }
    return _S473;
}

Hair_0 hair_at_0(uint _S474, vec2 _S475, bool _S476, float _S477)
{
    float _S478 = fabrics_0._data[uint(_S474)].fibre_size_0;
    float _S479 = 17.0 * fabrics_0._data[uint(_S474)].fibre_size_0;
    float _S480 = fade_0(_S477, _S479);
    vec2 _S481 = _S475 / _S479;
    uint number_1;
    if(_S476)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S482 = hash_key_0(number_1, (fabrics_0._data[uint(_S474)].seed_1) ^ 1013904242U);
    float _S483 = 1.0 / max(_S477, 0.07999999821186066 * _S478);
    float _S484 = min(0.63999998569488525 * _S478 * _S483, 1.0);
    const vec2 _S485 = vec2(0.0, 1.0);
    float cover_2 = 0.0;
    float hair_away_0 = 0.0;
    vec2 hair_across_0 = _S485;
    number_1 = 0U;
    for(;;)
    {
        bool _S486;
        if(_S480 > 0.0)
        {
            _S486 = number_1 < 18U;
        }
        else
        {
            _S486 = false;
        }
        if(_S486)
        {
        }
        else
        {
            break;
        }
        uint _S487 = number_1 / 9U;
        uint _S488 = number_1 / 3U - 3U * _S487;
        vec2 _S489 = floor(_S481) + vec2(float(number_1 - 3U * _S488 - 9U * _S487), float(_S488)) - 1.0;
        uint _S490 = hash_bits_0(_S482 + _S487, uint(int(_S489.x)) * 65536U + uint(int(_S489.y)));
        uint _S491 = hash_bits_0(_S482, _S490);
        vec2 _S492 = _S481 - _S489 - vec2(share_of_0(_S490), share_of_0(_S490 >> 10));
        vec2 _S493 = sine_cosine_0(3.14159274101257324 * share_of_0(_S490 >> 20));
        float _S494 = mix(5.0, 16.0, share_of_0(_S491 >> 10)) / 17.0;
        float _S495 = _S492.x;
        float _S496 = _S493.y;
        float _S497 = _S492.y;
        float _S498 = _S493.x;
        float _S499 = (_S495 * _S496 + _S497 * _S498) / _S494;
        float _S500 = 0.69999998807907104 * (2.0 * share_of_0(_S491 >> 20) - 1.0);
        float _S501 = 2.0 * _S500 * _S499;
        float _S502 = (inversesqrt((_S501 * _S501 + 1.0)));
        float _S503 = (_S497 * _S496 - _S495 * _S498 - _S500 * _S494 * _S499 * _S499) * _S502 * 17.0;
        float _S504 = clamp((0.31999999284744263 - abs(_S503)) * _S478 * _S483 + 0.5, 0.0, _S484);
        uint _S505;
        if(((_S491 >> 30) & 1U) == 1U)
        {
            _S505 = fabrics_0._data[uint(_S474)].warp_0;
        }
        else
        {
            _S505 = fabrics_0._data[uint(_S474)].weft_0;
        }
        bool _S506;
        if((share_of_0(_S491)) < (families_0._data[uint(_S505)].hairiness_0))
        {
            _S506 = (abs(_S499)) < 1.0;
        }
        else
        {
            _S506 = false;
        }
        bool _S507;
        if(_S506)
        {
            _S507 = _S504 > cover_2;
        }
        else
        {
            _S507 = false;
        }
        if(_S507)
        {
            vec2 _S508 = vec2(- _S498 - _S501 * _S496, _S496 - _S501 * _S498) * _S502;
            cover_2 = _S504;
            hair_away_0 = _S503;
            hair_across_0 = _S508;
        }
        number_1 = number_1 + 1U;
    }
    float _S509 = clamp(hair_away_0 * 2.5, -0.80000001192092896, 0.80000001192092896);
    Hair_0 hair_1;
    hair_1.cover_0 = _S480 * cover_2;
    hair_1.normal_2 = vec3(_S509 * hair_across_0, sqrt(1.0 - _S509 * _S509));
    hair_1.tangent_2 = vec3(hair_across_0.y, - hair_across_0.x, 0.0);
    return hair_1;
}

uint thread_number_0(uint _S510, SurfacePoint_0 _S511, float _S512, float _S513)
{
    float _S514;
    if(_S511.is_warp_0)
    {
        _S514 = _S512;
    }
    else
    {
        _S514 = _S513;
    }
    float _S515 = _S514 - _S511.across_0;
    uint _S516;
    if(_S511.is_warp_0)
    {
        _S516 = fabrics_0._data[uint(_S510)].warp_0;
    }
    else
    {
        _S516 = fabrics_0._data[uint(_S510)].weft_0;
    }
    float _S517 = families_0._data[uint(_S516)].period_0;
    int _S518 = int(families_0._data[uint(_S516)].count_0);
    if(_S511.is_warp_0)
    {
        _S516 = _S511.warp_thread_0;
    }
    else
    {
        _S516 = _S511.weft_thread_0;
    }
    uint _S519 = uint(int(floor(_S515 / _S517)) * _S518 + int(_S516)) * 2U;
    if(_S511.is_warp_0)
    {
        _S516 = 1U;
    }
    else
    {
        _S516 = 0U;
    }
    return _S519 + _S516;
}

struct FibreNoise_0
{
    vec2 bundle_0;
    float bundle_weight_0;
    vec2 fibre_0;
    float fibre_weight_0;
    float offset_2;
    float slope_2;
};

FibreNoise_0 fibre_noise_at_0(uint _S520, uint _S521, SurfacePoint_0 _S522, uint _S523, float _S524)
{
    float _S525 = 5.0 * fabrics_0._data[uint(_S520)].fibre_size_0;
    vec2 _S526 = wave_noise_0(hash_key_0(_S523, (fabrics_0._data[uint(_S520)].seed_1) ^ 458671337U), _S522.fibre_along_0 / (25.0 * fabrics_0._data[uint(_S520)].fibre_size_0));
    float _S527 = _S522.fibre_across_0 + families_0._data[uint(_S521)].fibre_tilt_0 * 0.5 * 25.0 * fabrics_0._data[uint(_S520)].fibre_size_0 * _S526.x;
    vec3 _S528 = fibre_cell_0(_S527, _S522.fibre_along_0, fabrics_0._data[uint(_S520)].fibre_size_0);
    FibreNoise_0 noise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S523, (fabrics_0._data[uint(_S520)].seed_1) ^ 1757159915U), fibre_cell_0(_S527, _S522.fibre_along_0, _S525));
    noise_0.bundle_weight_0 = fade_0(_S524, _S525);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S523, (fabrics_0._data[uint(_S520)].seed_1) ^ 48610963U), _S528);
    noise_0.fibre_weight_0 = fade_0(_S524, fabrics_0._data[uint(_S520)].fibre_size_0);
    noise_0.offset_2 = _S528.z;
    noise_0.slope_2 = 0.5 * _S526.y;
    return noise_0;
}

vec2 detail_gain_0(uint _S529, uint _S530, SurfacePoint_0 _S531, vec2 _S532, bool _S533, uint _S534, float _S535)
{
    const vec2 _S536 = vec2(0.0);
    vec2 gain_1;
    if((families_0._data[uint(_S530)].has_plies_0) > 0.0)
    {
        gain_1 = 0.60000002384185791 * fade_0(_S535, 1.0 / families_0._data[uint(_S530)].plies_per_mm_0) * vec2(0.20000000298023224 - square_0(square_0(ply_offset_0(_S530, _S531, _S533))), 0.20000000298023224);
    }
    else
    {
        gain_1 = _S536;
    }
    if((families_0._data[uint(_S530)].fibre_tone_0) > 0.0)
    {
        FibreNoise_0 _S537 = fibre_noise_at_0(_S529, _S530, _S531, _S534, _S535);
        gain_1 = gain_1 + families_0._data[uint(_S530)].fibre_tone_0 * vec2(_S537.bundle_weight_0 * _S537.bundle_0.y + _S537.fibre_weight_0 * _S537.fibre_0.y, _S537.bundle_weight_0 + _S537.fibre_weight_0);
    }
    if((families_0._data[uint(_S530)].slub_0) > 0.0)
    {
        float _S538 = 0.25 * families_0._data[uint(_S530)].slub_0 * fade_0(_S535, 1.0 / families_0._data[uint(_S530)].slubs_per_mm_0);
        float _S539;
        if(_S531.is_warp_0)
        {
            _S539 = _S532.y;
        }
        else
        {
            _S539 = - _S532.x;
        }
        gain_1 = gain_1 + _S538 * vec2(wave_noise_0(hash_key_0(_S534, (fabrics_0._data[uint(_S529)].seed_1) ^ 1373058189U), _S539 * families_0._data[uint(_S530)].slubs_per_mm_0).x * mix(0.40000000596046448, 1.0, min(square_0(_S531.across_0 * families_0._data[uint(_S530)].per_half_width_0), 1.0)), 1.0);
    }
    return gain_1;
}

Albedos_0 vary_albedos_0(uint _S540, Albedos_0 _S541, uint _S542, uint _S543, vec2 _S544)
{
    vec3 _S545 = max(_S541.specular_reflect_0, _S541.specular_transmit_0);
    vec3 _S546 = _S541.diffuse_reflect_0 + _S541.diffuse_transmit_0;
    vec3 _S547 = 1.0 - fabrics_0._data[uint(_S540)].layer_bound_0 * _S545;
    float colour_0 = bounded_gain_0(thread_gain_0(_S542, fabrics_0._data[uint(_S540)].colour_noise_0, fabrics_0._data[uint(_S540)].seed_1), _S546, _S547);
    float colour_1 = colour_0 * (1.0 + flattened_0(_S544.y, colour_0 * _S546, _S547) * _S544.x);
    float _S548 = bounded_gain_0(fibre_gain_0(_S542, _S543, fabrics_0._data[uint(_S540)].fibre_noise_0, fabrics_0._data[uint(_S540)].seed_1), _S545, min((1.0 - colour_1 * _S546) / fabrics_0._data[uint(_S540)].layer_bound_0, vec3(1.0)));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = colour_1 * _S541.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = colour_1 * _S541.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S548 * _S541.specular_reflect_0;
    varied_0.specular_transmit_0 = _S548 * _S541.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S549, SurfacePoint_0 _S550, Albedos_0 _S551, float _S552, float _S553, bool _S554, float _S555, float _S556)
{
    uint _S557 = thread_number_0(_S549, _S550, _S552, _S553);
    vec3 _S558 = fibre_cell_0(_S550.fibre_across_0, _S550.fibre_along_0, fabrics_0._data[uint(_S549)].fibre_size_0);
    const vec2 _S559 = vec2(0.0);
    bool _S560;
    if((fabrics_0._data[uint(_S549)].has_detail_0) != 0U)
    {
        _S560 = _S555 >= 0.0;
    }
    else
    {
        _S560 = false;
    }
    vec2 gain_2;
    if(_S560)
    {
        uint _S561;
        if(_S550.is_warp_0)
        {
            _S561 = fabrics_0._data[uint(_S549)].warp_0;
        }
        else
        {
            _S561 = fabrics_0._data[uint(_S549)].weft_0;
        }
        gain_2 = detail_gain_0(_S549, _S561, _S550, vec2(_S552, _S553), _S554, _S557, _S555) * vec2(1.0 - _S556, 1.0);
    }
    else
    {
        gain_2 = _S559;
    }
    return vary_albedos_0(_S549, _S551, _S557, uint(int(_S558.x)) * 65536U + uint(int(floor(_S558.y))), gain_2);
}

YarnFrame_0 turned_frame_0(uint _S562, uint _S563, SurfacePoint_0 _S564, bool _S565, uint _S566, float _S567)
{
    YarnFrame_0 frame_2;
    frame_2.normal_4 = _S564.normal_0;
    frame_2.tangent_4 = _S564.tangent_0;
    frame_2.loss_0 = 0.0;
    if((families_0._data[uint(_S563)].has_plies_0) > 0.0)
    {
        float _S568 = fade_0(_S567, 1.0 / families_0._data[uint(_S563)].plies_per_mm_0);
        float _S569 = _S568 * 0.41999998688697815 * ply_offset_0(_S563, _S564, _S565);
        float _S570 = sqrt(1.0 - _S569 * _S569);
        float _S571;
        if(_S565)
        {
            _S571 = - families_0._data[uint(_S563)].ply_sine_0;
        }
        else
        {
            _S571 = families_0._data[uint(_S563)].ply_sine_0;
        }
        vec3 _S572 = cross(frame_2.tangent_4, frame_2.normal_4);
        vec3 _S573 = families_0._data[uint(_S563)].ply_cosine_0 * _S572 + _S571 * frame_2.tangent_4;
        frame_2.tangent_4 = families_0._data[uint(_S563)].ply_cosine_0 * (families_0._data[uint(_S563)].ply_cosine_0 * frame_2.tangent_4 - _S571 * _S572) + _S571 * (_S570 * _S573 - _S569 * frame_2.normal_4);
        frame_2.normal_4 = _S570 * frame_2.normal_4 + _S569 * _S573;
        frame_2.loss_0 = _S568 * _S568 * 0.41999998688697815 * 0.41999998688697815 / 6.0;
    }
    float _S574 = families_0._data[uint(_S563)].fibre_tilt_0;
    if((families_0._data[uint(_S563)].fibre_tilt_0) > 0.0)
    {
        FibreNoise_0 _S575 = fibre_noise_at_0(_S562, _S563, _S564, _S566, _S567);
        float _S576 = 1.09858846664428711 * _S574 * (_S575.bundle_weight_0 * _S575.bundle_0.x + _S575.fibre_weight_0 * (_S575.fibre_0.x + _S575.offset_2));
        float _S577 = _S574 * (1.42099642753601074 * (_S575.bundle_weight_0 * _S575.bundle_0.y + _S575.fibre_weight_0 * _S575.fibre_0.y) - _S575.bundle_weight_0 * _S575.slope_2);
        float _S578 = square_0(_S575.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5 * _S574 * _S574 * ((0.24761904776096344 * (square_0(_S575.bundle_weight_0) + _S578) + _S578 / 3.0) * 1.09858846664428711 * 1.09858846664428711);
        vec3 _S579 = cross(frame_2.tangent_4, frame_2.normal_4);
        vec2 _S580 = sine_cosine_0(_S576);
        vec2 _S581 = sine_cosine_0(_S577);
        float _S582 = _S580.y;
        float _S583 = _S580.x;
        vec3 _S584 = _S582 * _S579 - _S583 * frame_2.normal_4;
        frame_2.normal_4 = _S582 * frame_2.normal_4 + _S583 * _S579;
        frame_2.tangent_4 = _S581.y * frame_2.tangent_4 + _S581.x * _S584;
    }
    return frame_2;
}

YarnPoint_0 yarn_point_of_0(uint _S585, SurfacePoint_0 _S586, float _S587, float _S588, bool _S589, bool _S590, float _S591)
{
    uint _S592;
    if(_S586.is_warp_0)
    {
        _S592 = fabrics_0._data[uint(_S585)].warp_0;
    }
    else
    {
        _S592 = fabrics_0._data[uint(_S585)].weft_0;
    }
    bool _S593;
    if((fabrics_0._data[uint(_S585)].has_detail_0) != 0U)
    {
        _S593 = _S591 >= 0.0;
    }
    else
    {
        _S593 = false;
    }
    const vec3 _S594 = vec3(0.0);
    Hair_0 _S595 = Hair_x24init_0(0.0, _S594, _S594);
    bool _S596;
    if(_S593)
    {
        _S596 = has_hairs_0(_S585);
    }
    else
    {
        _S596 = false;
    }
    Hair_0 hair_2;
    if(_S596)
    {
        hair_2 = hair_at_0(_S585, vec2(_S587, _S588), _S589, _S591);
    }
    else
    {
        hair_2 = _S595;
    }
    uint _S597;
    if(_S586.is_warp_0)
    {
        _S597 = _S586.warp_thread_0;
    }
    else
    {
        _S597 = _S586.weft_thread_0;
    }
    Albedos_0 albedos_7 = albedos_of_0(_S592, _S597);
    Albedos_0 albedos_8;
    if(varies_at_0(_S585, _S591))
    {
        albedos_8 = varied_at_0(_S585, _S586, albedos_7, _S587, _S588, _S589, _S591, hair_2.cover_0);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    YarnPoint_0 point_2;
    point_2.back_7 = _S589;
    point_2.hole_6 = _S590;
    point_2.is_warp_3 = _S586.is_warp_0;
    point_2.x_14 = _S587;
    point_2.y_6 = _S588;
    point_2.height_10 = _S586.height_1;
    point_2.normal_9 = _S586.normal_0;
    point_2.tangent_10 = _S586.tangent_0;
    point_2.surface_normal_0 = _S586.normal_0;
    point_2.diffuse_gain_1 = 1.0;
    if(_S593)
    {
        YarnFrame_0 _S598 = turned_frame_0(_S585, _S592, _S586, _S589, thread_number_0(_S585, _S586, _S587, _S588), _S591);
        YarnFrame_0 frame_3;
        if(has_hairs_0(_S585))
        {
            frame_3 = under_hair_0(_S598, hair_2);
        }
        else
        {
            frame_3 = _S598;
        }
        point_2.normal_9 = frame_3.normal_4;
        point_2.tangent_10 = frame_3.tangent_4;
        point_2.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0._data[uint(_S585)].diffuse_blend_0);
    }
    point_2.roughness_10 = families_0._data[uint(_S592)].roughness_0;
    point_2.albedos_6 = albedos_8;
    return point_2;
}

bool unoccluded_0(uint _S599, SearchQuality_0 _S600, float _S601, float _S602, float _S603, vec3 _S604, bool _S605)
{
    if((_S604.z) <= 0.0)
    {
        return false;
    }
    return is_free_0(_S599, _S600, vec3(_S601, _S602, _S603 + fabrics_0._data[uint(_S599)].lift_0), _S604, _S605, max_height_along_0(_S599, _S601, _S602, _S603, _S604, _S605));
}

bool is_lit_0(uint _S606, SearchQuality_0 _S607, YarnPoint_0 _S608, vec3 _S609)
{
    if(_S608.hole_6)
    {
        return true;
    }
    vec3 _S610 = to_face_frame_0(_S609, _S608.back_7);
    float _S611 = _S610.z;
    bool _S612 = _S611 < 0.0;
    vec3 normal_10;
    float height_11;
    if(_S612)
    {
        SurfacePoint_0 _S613 = surface_at_0(_S606, _S608.x_14, _S608.y_6, !_S608.back_7);
        normal_10 = _S613.normal_0;
        height_11 = _S613.height_1;
    }
    else
    {
        normal_10 = _S608.surface_normal_0;
        height_11 = _S608.height_10;
    }
    vec3 _S614 = vec3(_S610.xy, abs(_S611));
    if((dot(normal_10, _S614)) <= 0.0)
    {
        return false;
    }
    return unoccluded_0(_S606, _S607, _S608.x_14, _S608.y_6, height_11, _S614, (_S608.back_7) != _S612);
}

Components_0 components_of_point_0(uint _S615, SearchQuality_0 _S616, YarnPoint_0 _S617, vec3 _S618, vec3 _S619)
{
    Components_0 result_3 = no_components_0();
    float _S620;
    if(_S617.hole_6)
    {
        _S620 = 1.0;
    }
    else
    {
        _S620 = 0.0;
    }
    result_3.hole_2 = _S620;
    bool _S621;
    if(_S617.hole_6)
    {
        _S621 = true;
    }
    else
    {
        _S621 = !is_lit_0(_S615, _S616, _S617, _S618);
    }
    if(_S621)
    {
        return result_3;
    }
    vec3 _S622 = to_face_frame_0(_S618, _S617.back_7);
    vec3 _S623 = to_face_frame_0(_S619, _S617.back_7);
    bool _S624 = (_S622.z) < 0.0;
    vec3 _S625;
    if(_S624)
    {
        _S625 = - _S622;
    }
    else
    {
        _S625 = _S622;
    }
    float _S626 = _S617.diffuse_gain_1 * diffuse_reflection_0(_S625, _S617.normal_9, fabrics_0._data[uint(_S615)].diffuse_blend_0);
    if(_S624)
    {
        _S620 = transmission_1(_S622, _S623, _S617.normal_9, _S617.tangent_10, _S617.roughness_10, fabrics_0._data[uint(_S615)].optical_depth_0);
    }
    else
    {
        _S620 = reflection_0(_S622, _S623, _S617.normal_9, _S617.tangent_10, _S617.roughness_10, fabrics_0._data[uint(_S615)].optical_depth_0);
    }
    float _S627;
    if(_S617.is_warp_3)
    {
        _S627 = _S626;
    }
    else
    {
        _S627 = 0.0;
    }
    result_3.diffuse_warp_0 = _S627;
    if(_S617.is_warp_3)
    {
        _S627 = 0.0;
    }
    else
    {
        _S627 = _S626;
    }
    result_3.diffuse_weft_0 = _S627;
    if(_S617.is_warp_3)
    {
        _S627 = _S620;
    }
    else
    {
        _S627 = 0.0;
    }
    result_3.specular_warp_0 = _S627;
    if(_S617.is_warp_3)
    {
        _S620 = 0.0;
    }
    result_3.specular_weft_0 = _S620;
    result_3.light_visibility_1 = 1.0;
    return result_3;
}

float openness_number_0(uint _S628, uint _S629)
{
    return table_number_0(fabrics_0._data[uint(_S628)].openness_0 + _S629);
}

Blocked_0 blocked_of_terms_0(uint _S630, uint _S631, float  _S632[6], uint _S633)
{
    float  shares_0[3];
    uint share_3 = 0U;
    for(;;)
    {
        if(share_3 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_3] = 0.0;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S633)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S630, _S631 + share_3 * _S633 + term_0) * _S632[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_3] = saturate_1(shares_0[share_3]);
        share_3 = share_3 + 1U;
    }
    Blocked_0 blocked_2;
    blocked_2.by_warp_0 = shares_0[0] * shares_0[2];
    blocked_2.by_weft_0 = shares_0[0] * (1.0 - shares_0[2]);
    blocked_2.far_0 = shares_0[1];
    return blocked_2;
}

Blocked_0 blocked_at_0(uint _S634, bool _S635, bool _S636, float _S637, float _S638)
{
    float _S639 = _S638 * openness_number_0(_S634, 158U);
    float  terms_1[6] = float[](1.0, _S637, _S639, _S637 * _S637, _S637 * _S639, _S639 * _S639);
    uint _S640;
    if(_S636)
    {
        _S640 = 2U;
    }
    else
    {
        _S640 = 0U;
    }
    uint _S641;
    if(_S635)
    {
        _S641 = 0U;
    }
    else
    {
        _S641 = 1U;
    }
    return blocked_of_terms_0(_S634, 60U + (_S640 + _S641) * 18U, terms_1, 6U);
}

Blocked_0 with_blocked_0(uint _S642, Blocked_0 _S643, YarnPoint_0 _S644, bool _S645, float _S646)
{
    bool _S647;
    if(_S644.hole_6)
    {
        _S647 = true;
    }
    else
    {
        _S647 = (_S644.is_warp_3) != _S645;
    }
    if(_S647)
    {
        return _S643;
    }
    Blocked_0 _S648 = blocked_at_0(_S642, _S645, _S644.back_7, _S644.normal_9.z, _S644.height_10);
    Blocked_0 result_4;
    result_4.by_warp_0 = _S643.by_warp_0 + _S646 * _S648.by_warp_0;
    result_4.by_weft_0 = _S643.by_weft_0 + _S646 * _S648.by_weft_0;
    result_4.far_0 = _S643.far_0 + _S646 * _S648.far_0;
    return result_4;
}

struct CoverageTaps_0
{
    uint  nodes_1[9];
};

vec3 pyramid_level_0(uint _S649, float _S650)
{
    uint _S651 = fabrics_0._data[uint(_S649)].lobes_0.levels_0 + 4U * uint(min(_S650, fabrics_0._data[uint(_S649)].lobes_0.last_level_0));
    return vec3(table_number_0(_S651), table_number_0(_S651 + 1U), table_number_0(_S651 + 2U));
}

CoverageTaps_0 coverage_taps_0(uint _S652, Footprint_0 _S653, bool _S654)
{
    Lobes_0 _S655 = fabrics_0._data[uint(_S652)].lobes_0;
    float _S656 = Footprint_spread_side_0(_S653) * fabrics_0._data[uint(_S652)].lobes_0.inverse_base_size_0;
    vec3 _S657 = pyramid_level_0(_S652, floor(binary_logarithm_0(max(0.68000000715255737 * _S656, 1.0))));
    float _S658 = 1.0 / max(_S656, 9.99999997475242708e-07);
    float _S659 = min(max(sqrt(clamp(1.29999995231628418 * (1.0 - _S658 * _S658), 0.0, 1.0)), 0.3333333432674408 * _S658), 1.0);
    vec2 _S660 = vec2(families_0._data[uint(fabrics_0._data[uint(_S652)].warp_0)].inverse_period_0, families_0._data[uint(fabrics_0._data[uint(_S652)].weft_0)].inverse_period_0);
    vec2 _S661 = _S653.centre_0 * _S660;
    vec2 _S662 = _S653.dx_0 * _S660 * _S659;
    vec2 _S663 = _S653.dy_0 * _S660 * _S659;
    CoverageTaps_0 taps_3;
    uint number_2 = 0U;
    for(;;)
    {
        if(number_2 < 9U)
        {
        }
        else
        {
            break;
        }
        vec2 _S664 = _S661 + TAP_OFFSETS_0[number_2].x * _S662 + TAP_OFFSETS_0[number_2].y * _S663;
        float _S665 = _S657.y;
        float _S666 = wrapped_cell_0(_S664.x, _S665);
        float _S667 = wrapped_cell_0(_S664.y, _S657.z);
        uint _S668;
        if(_S654)
        {
            _S668 = _S655.face_nodes_0;
        }
        else
        {
            _S668 = 0U;
        }
        taps_3.nodes_1[number_2] = _S668 + uint(_S667 * _S665 + _S666 + _S657.x);
        number_2 = number_2 + 1U;
    }
    return taps_3;
}

vec4 coverage_of_pack_0(uint _S669, CoverageTaps_0 _S670, uint _S671)
{
    uint number_3 = 0U;
    uint even_1 = 0U;
    uint odd_1 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        uint _S672 = words_0._data[uint(fabrics_0._data[uint(_S669)].lobes_0.coverage_0 + _S670.nodes_1[number_3] * fabrics_0._data[uint(_S669)].lobes_0.packs_0 + _S671)];
        uint even_2 = even_1 + (_S672 & 16711935U);
        uint odd_2 = odd_1 + ((_S672 >> 8) & 16711935U);
        number_3 = number_3 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / 9.0;
}

float coverage_of_holes_0(uint _S673, CoverageTaps_0 _S674)
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
        uint total_1 = total_0 + (((words_0._data[uint(fabrics_0._data[uint(_S673)].lobes_0.coverage_holes_0 + _S674.nodes_1[number_4] / 4U)]) >> (8U * (_S674.nodes_1[number_4] % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0;
}

float prefiltered_hole_0(uint _S675, CoverageTaps_0 _S676, NodeTaps_0 _S677, bool _S678)
{
    Lobes_0 _S679 = fabrics_0._data[uint(_S675)].lobes_0;
    float _S680 = interpolate_table_0(_S677, fabrics_0._data[uint(_S675)].lobes_0.projected_area_0 + fabrics_0._data[uint(_S675)].lobes_0.packs_0, fabrics_0._data[uint(_S675)].lobes_0.packs_0 + 1U).x;
    float _S681;
    if(_S678)
    {
        _S681 = _S679.back_hole_weight_0;
    }
    else
    {
        _S681 = _S679.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S675, _S676) * _S680 * _S680 * _S681, 1.0);
}

Components_0 prefiltered_components_0(uint _S682, Footprint_0 _S683, vec3 _S684, vec3 _S685, bool _S686)
{
    CoverageTaps_0 _S687 = coverage_taps_0(_S682, _S683, _S686);
    NodeTaps_0 _S688 = node_taps_0(_S685);
    NodeTaps_0 view_nodes_0 = _S688;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S684);
    NodeTaps_0 seen_nodes_0 = _S688;
    uint _S689;
    if(_S686)
    {
        _S689 = 1U;
    }
    else
    {
        _S689 = 0U;
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + _S689 * 256U;
    uint _S690 = 2U * _S689;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + _S690 * 256U;
    uint _S691;
    if((_S684.z) < 0.0)
    {
        _S691 = 1U;
    }
    else
    {
        _S691 = 0U;
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + (_S690 + _S691) * 256U;
    vec3 _S692 = half_vector_0(_S684, _S685);
    vec3 _S693 = shadow_correlation_0(_S684, _S685);
    if(_S686)
    {
        _S691 = fabrics_0._data[uint(_S682)].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S691 = fabrics_0._data[uint(_S682)].lobes_0.front_warp_packs_0;
    }
    Components_0 sums_2;
    sums_2.diffuse_warp_0 = 0.0;
    sums_2.diffuse_weft_0 = 0.0;
    sums_2.specular_warp_0 = 0.0;
    sums_2.specular_weft_0 = 0.0;
    sums_2.light_visibility_1 = 0.0;
    uint pack_0 = 0U;
    float total_2 = 0.0;
    for(;;)
    {
        Lobes_0 _S694 = fabrics_0._data[uint(_S682)].lobes_0;
        if(pack_0 < (fabrics_0._data[uint(_S682)].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        vec4 _S695 = coverage_of_pack_0(_S682, _S687, pack_0);
        vec4 _S696 = interpolate_table_0(view_nodes_0, _S694.projected_area_0 + pack_0, _S694.packs_0 + 1U);
        uint _S697 = _S694.light_visibility_0 + pack_0;
        vec4 _S698 = interpolate_table_0(seen_nodes_0, _S697, _S694.packs_0) / 255.0;
        vec4 _S699 = interpolate_table_0(light_nodes_0, _S697, _S694.packs_0) / 255.0;
        vec4 _S700 = interpolate_table_0(light_nodes_0, _S694.irradiance_0 + pack_0, _S694.packs_0) * 0.00124827399849892;
        bool _S701 = pack_0 < _S691;
        uint _S702;
        if(_S701)
        {
            _S702 = fabrics_0._data[uint(_S682)].warp_0;
        }
        else
        {
            _S702 = fabrics_0._data[uint(_S682)].weft_0;
        }
        float _S703 = families_0._data[uint(_S702)].roughness_0;
        uint number_5 = 0U;
        float diffuse_0 = 0.0;
        float specular_0 = 0.0;
        for(;;)
        {
            if(number_5 < 4U)
            {
            }
            else
            {
                break;
            }
            Group_0 _S704 = group_at_0(_S694.moments_0 + 12U * (4U * (_S689 * _S694.packs_0 + pack_0) + number_5), _S703);
            float _S705 = _S695[number_5] * _S696[number_5] * _S696[number_5] * _S704.weight_2;
            vec2 _S706 = visibility_gain_0(_S693, _S699[number_5], _S698[number_5]);
            float _S707 = _S706.x;
            float diffuse_1 = diffuse_0 + _S705 * _S700[number_5] * _S707;
            float specular_1 = specular_0 + _S705 * layer_value_0(_S704, _S692, _S684, _S685, fabrics_0._data[uint(_S682)].optical_depth_0) * _S699[number_5] * _S706.y;
            sums_2.light_visibility_1 = sums_2.light_visibility_1 + _S705 * _S699[number_5] * _S707;
            float total_3 = total_2 + _S705;
            number_5 = number_5 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S708;
        if(_S701)
        {
            _S708 = diffuse_0;
        }
        else
        {
            _S708 = 0.0;
        }
        sums_2.diffuse_warp_0 = sums_2.diffuse_warp_0 + _S708;
        float _S709;
        if(_S701)
        {
            _S709 = 0.0;
        }
        else
        {
            _S709 = diffuse_0;
        }
        sums_2.diffuse_weft_0 = sums_2.diffuse_weft_0 + _S709;
        float _S710;
        if(_S701)
        {
            _S710 = specular_0;
        }
        else
        {
            _S710 = 0.0;
        }
        sums_2.specular_warp_0 = sums_2.specular_warp_0 + _S710;
        float _S711;
        if(_S701)
        {
            _S711 = 0.0;
        }
        else
        {
            _S711 = specular_0;
        }
        sums_2.specular_weft_0 = sums_2.specular_weft_0 + _S711;
        pack_0 = pack_0 + 1U;
    }
    float _S712 = prefiltered_hole_0(_S682, _S687, view_nodes_0, _S686);
    sums_2.hole_2 = _S712;
    float _S713 = (1.0 - _S712) / max(total_2, 9.999999960041972e-13);
    sums_2.diffuse_warp_0 = sums_2.diffuse_warp_0 * _S713;
    sums_2.diffuse_weft_0 = sums_2.diffuse_weft_0 * _S713;
    sums_2.specular_warp_0 = sums_2.specular_warp_0 * _S713;
    sums_2.specular_weft_0 = sums_2.specular_weft_0 * _S713;
    sums_2.light_visibility_1 = sums_2.light_visibility_1 * _S713;
    return sums_2;
}

FamilyAlbedos_0 albedos_over_0(uint _S714, Footprint_0 _S715, bool _S716)
{
    vec2 _S717 = _S715.dx_0;
    vec2 _S718 = _S715.dy_0;
    vec2 _S719 = sqrt(_S717 * _S717 + _S718 * _S718);
    Stretch_0 _S720 = stretch_of_0(fabrics_0._data[uint(_S714)].warp_0, _S715.centre_0.x, _S719.x);
    Stretch_0 _S721 = stretch_of_0(fabrics_0._data[uint(_S714)].weft_0, _S715.centre_0.y, _S719.y);
    FamilyAlbedos_0 albedos_9;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0._data[uint(_S714)].warp_0, fabrics_0._data[uint(_S714)].weft_0, _S720, _S721, _S716);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0._data[uint(_S714)].weft_0, fabrics_0._data[uint(_S714)].warp_0, _S721, _S720, _S716);
    return albedos_9;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S722, Footprint_0 _S723, float _S724, vec2 _S725, vec3 _S726, vec3 _S727)
{
    float _S728;
    float _S729;
    Regime_0 _S730 = regime_of_0(_S722, _S723, _S724);
    bool _S731 = (_S727.z) < 0.0;
    vec3 _S732 = to_face_frame_0(_S727, _S731);
    float _S733 = Footprint_spread_side_0(_S723);
    bool _S734 = varies_at_0(_S722, _S733);
    bool _S735;
    if((families_0._data[uint(fabrics_0._data[uint(_S722)].warp_0)].quantities_0) > 1U)
    {
        _S735 = true;
    }
    else
    {
        _S735 = (families_0._data[uint(fabrics_0._data[uint(_S722)].weft_0)].quantities_0) > 1U;
    }
    float _S736 = 1.0 - _S730.prefiltered_0;
    if(_S736 > 0.0)
    {
        if(_S734)
        {
            _S735 = true;
        }
    }
    else
    {
        _S735 = false;
    }
    Footprint_0 box_0 = _S723;
    const vec3 _S737 = vec3(0.0);
    SurfacePoint_0 _S738 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0, _S737, _S737, 0.0, 0.0, 0.0);
    Components_0 _S739 = no_components_0();
    CloseUp_0 close_1 = no_close_up_0();
    int _S740;
    if(_S735)
    {
        _S740 = 0;
    }
    else
    {
        _S740 = 1;
    }
    uint _S741 = uint(_S740);
    Components_0 points_1 = _S739;
    float central_weight_0 = 0.0;
    SurfacePoint_0 central_0 = _S738;
    vec2 central_place_0 = _S723.centre_0;
    uint number_6 = _S741;
    for(;;)
    {
        float _S742 = float(number_6);
        _S728 = _S730.points_0;
        if(_S742 < (_S730.points_0 + 1.0))
        {
        }
        else
        {
            break;
        }
        bool _S743 = number_6 == 0U;
        uint _S744;
        if(_S743)
        {
            _S744 = 0U;
        }
        else
        {
            _S744 = number_6 - 1U;
        }
        vec2 _S745 = POINT_OFFSETS_0[_S744] + _S725;
        vec2 _S746;
        if(_S743)
        {
            _S746 = vec2(0.0);
        }
        else
        {
            _S746 = _S745 - round(_S745);
        }
        vec2 _S747 = _S723.centre_0 + _S746.x * _S723.dx_0 + _S746.y * _S723.dy_0;
        if(_S743)
        {
            _S729 = 0.0;
        }
        else
        {
            _S729 = _S730.threads_1;
        }
        SearchQuality_0 _S748 = quality_of_0(_S729);
        Hit_0 _S749 = first_hit_0(_S722, _S748, _S747.x, _S747.y, _S732, _S731);
        SurfacePoint_0 _S750 = surface_at_0(_S722, _S749.x_13, _S749.y_5, _S731);
        if(_S743)
        {
            float central_weight_1;
            if(_S749.hole_5)
            {
                central_weight_1 = 0.0;
            }
            else
            {
                central_weight_1 = _S736;
            }
            vec2 central_place_1 = vec2(_S749.x_13, _S749.y_5);
            box_0.centre_0 = mix(_S723.centre_0, central_place_1, vec2(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S750;
            central_place_0 = central_place_1;
            number_6 = number_6 + 1U;
            continue;
        }
        YarnPoint_0 _S751 = yarn_point_of_0(_S722, _S750, _S749.x_13, _S749.y_5, _S731, _S749.hole_5, _S733);
        float _S752 = min(_S730.points_0 - float(number_6 - 1U), 1.0);
        Components_0 _S753 = with_added_0(points_1, components_of_point_0(_S722, _S748, _S751, _S726, _S727), _S752);
        if((fabrics_0._data[uint(_S722)].openness_0) != 4294967295U)
        {
            close_1.warp_1 = with_blocked_0(_S722, close_1.warp_1, _S751, true, _S752);
            close_1.weft_1 = with_blocked_0(_S722, close_1.weft_1, _S751, false, _S752);
        }
        points_1 = _S753;
        number_6 = number_6 + 1U;
    }
    close_1.weight_0 = _S736;
    float _S754 = max(_S728, 1.0);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0 / _S754);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0 / _S754);
    Estimate_0 estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S739, points_1, _S736 / _S754);
    if((_S730.prefiltered_0) > 0.0)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S722, _S723, to_face_frame_0(_S726, _S731), _S732, _S731), _S730.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S722, box_0, _S731);
    if(_S734)
    {
        _S735 = central_weight_0 > 0.0;
    }
    else
    {
        _S735 = false;
    }
    if(_S735)
    {
        SurfacePoint_0 _S755 = central_0;
        Albedos_0 _S756;
        if(central_0.is_warp_0)
        {
            _S756 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S756 = estimate_0.albedos_5.weft_5;
        }
        if((fabrics_0._data[uint(_S722)].has_detail_0) != 0U)
        {
            _S735 = has_hairs_0(_S722);
        }
        else
        {
            _S735 = false;
        }
        if(_S735)
        {
            _S729 = hair_at_0(_S722, central_place_0, _S731, _S733).cover_0;
        }
        else
        {
            _S729 = 0.0;
        }
        Albedos_0 _S757 = lerp_albedos_0(_S756, varied_at_0(_S722, central_0, _S756, central_place_0.x, central_place_0.y, _S731, _S733, _S729), central_weight_0);
        if(_S755.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S757;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S757;
        }
    }
    return estimate_0;
}

Estimate_0 lobes_estimate_0(uint _S758, Footprint_0 _S759, float _S760, vec3 _S761, vec3 _S762)
{
    return lobes_estimate_of_pass_0(_S758, _S759, _S760, vec2(0.0), _S761, _S762);
}

Scattered_0 scattered_by_0(uint _S763, Albedos_0 _S764, uint _S765, vec3 _S766)
{
    uint _S767 = 159U + 2U * _S765;
    Scattered_0 yarn_3;
    yarn_3.back_6 = _S766 * _S764.diffuse_reflect_0 + openness_number_0(_S763, _S767) * _S764.specular_reflect_0;
    yarn_3.through_0 = _S766 * _S764.diffuse_transmit_0 + openness_number_0(_S763, _S767 + 1U) * _S764.specular_transmit_0;
    return yarn_3;
}

void sent_0(uint _S768, uint _S769, vec3 _S770, vec3 _S771, vec3 _S772, vec3 _S773, out vec3 _S774, out vec3 _S775)
{
    uint _S776 = 146U + 4U * _S769;
    float _S777 = openness_number_0(_S768, _S776 + 1U);
    float _S778 = openness_number_0(_S768, _S776 + 2U);
    vec3 _S779 = 1.0 - _S772 * openness_number_0(_S768, _S776);
    vec3 _S780 = 1.0 - _S773 * openness_number_0(_S768, _S776 + 3U);
    vec3 _S781 = 1.0 / (_S779 * _S780 - _S772 * _S773 * (_S777 * _S778));
    _S774 = (_S770 * _S780 + _S772 * _S777 * _S771) * _S781;
    _S775 = (_S771 * _S779 + _S773 * _S778 * _S770) * _S781;
    return;
}

FaceSends_0 face_sends_0(uint _S782, uint _S783, Scattered_0 _S784, Scattered_0 _S785)
{
    uint _S786 = 2U * _S783;
    uint _S787 = 142U + _S786;
    float _S788 = openness_number_0(_S782, _S787);
    float _S789 = openness_number_0(_S782, _S787 + 1U);
    vec3 _S790 = (1.0 - _S788) * _S784.back_6;
    vec3 _S791 = (1.0 - _S789) * _S785.back_6;
    FaceSends_0 sends_1;
    uint _S792 = 154U + _S786;
    float _S793 = openness_number_0(_S782, _S792);
    sends_1.blocks_warp_0 = _S793;
    float _S794 = openness_number_0(_S782, _S792 + 1U);
    sends_1.blocks_weft_0 = _S794;
    sends_1.open_0 = _S793 * _S788 + _S794 * _S789;
    sent_0(_S782, _S783, _S788 * _S784.back_6, _S789 * _S785.back_6, _S790, _S791, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S782, _S783, _S784.through_0, _S785.through_0, _S790, _S791, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S795, vec3 _S796, bool _S797)
{
    Scattered_0 _S798 = scattered_by_0(_S795, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S795)].warp_0)].colour_mean_0), 0U, _S796);
    Scattered_0 _S799 = scattered_by_0(_S795, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S795)].weft_0)].colour_mean_0), 1U, _S796);
    uint _S800;
    if(_S797)
    {
        _S800 = 1U;
    }
    else
    {
        _S800 = 0U;
    }
    FaceSends_0 _S801 = face_sends_0(_S795, _S800, _S798, _S799);
    if(_S797)
    {
        _S800 = 0U;
    }
    else
    {
        _S800 = 1U;
    }
    FaceSends_0 _S802 = face_sends_0(_S795, _S800, _S798, _S799);
    vec3 _S803 = _S801.blocks_warp_0 * _S801.crossing_warp_0 + _S801.blocks_weft_0 * _S801.crossing_weft_0;
    vec3 _S804 = _S802.blocks_warp_0 * _S802.crossing_warp_0 + _S802.blocks_weft_0 * _S802.crossing_weft_0;
    float _S805 = 1.0 - _S801.open_0;
    float _S806 = 1.0 - _S802.open_0;
    vec3 _S807 = 1.0 / (1.0 - _S803 * _S804 * (_S805 * _S806));
    vec3 _S808 = _S804 * (_S801.open_0 + _S805 * (_S801.blocks_warp_0 * _S801.sky_warp_0 + _S801.blocks_weft_0 * _S801.sky_weft_0)) * _S807;
    vec3 _S809 = _S803 * (_S802.open_0 + _S806 * (_S802.blocks_warp_0 * _S802.sky_warp_0 + _S802.blocks_weft_0 * _S802.sky_weft_0)) * _S807;
    FaceRadiance_0 _S810 = face_radiance_0(_S801, _S802.open_0, _S808, _S809);
    FaceRadiance_0 _S811 = face_radiance_0(_S802, _S801.open_0, _S809, _S808);
    Interior_0 interior_1;
    interior_1.warp_4 = _S810.warp_3;
    interior_1.weft_4 = _S810.weft_3;
    interior_1.leaked_1 = _S810.leaked_0;
    interior_1.far_1 = _S811.mean_0;
    interior_1.far_leaked_0 = _S811.leaked_0;
    return interior_1;
}

Blocked_0 blocked_from_0(uint _S812, vec3 _S813, bool _S814, bool _S815)
{
    float  terms_2[6];
    view_terms_0(_S813, terms_2);
    uint _S816;
    if(_S815)
    {
        _S816 = 2U;
    }
    else
    {
        _S816 = 0U;
    }
    uint _S817;
    if(_S814)
    {
        _S817 = 0U;
    }
    else
    {
        _S817 = 1U;
    }
    return blocked_of_terms_0(_S812, (_S816 + _S817) * 15U, terms_2, 5U);
}

float warp_seen_from_0(uint _S818, vec3 _S819, bool _S820)
{
    float  terms_3[6];
    view_terms_0(_S819, terms_3);
    uint term_1 = 0U;
    float share_4 = 0.0;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S821;
        if(_S820)
        {
            _S821 = 5U;
        }
        else
        {
            _S821 = 0U;
        }
        float share_5 = share_4 + openness_number_0(_S818, 132U + _S821 + term_1) * terms_3[term_1];
        term_1 = term_1 + 1U;
        share_4 = share_5;
    }
    return saturate_1(share_4);
}

Bounced_0 bounced_of_families_0(uint _S822, FamilyAlbedos_0 _S823, vec3 _S824, Interior_0 _S825, Blocked_0 _S826, Blocked_0 _S827)
{
    return sum_of_0(bounced_by_0(_S826, scattered_by_0(_S822, _S823.warp_5, 0U, _S824), _S825), bounced_by_0(_S827, scattered_by_0(_S822, _S823.weft_5, 1U, _S824), _S825));
}

Bounced_0 bounced_far_0(uint _S828, FamilyAlbedos_0 _S829, vec3 _S830, Interior_0 _S831, vec3 _S832, bool _S833, float _S834, float _S835, float _S836)
{
    Blocked_0 _S837 = blocked_from_0(_S828, _S832, true, _S833);
    Blocked_0 _S838 = blocked_from_0(_S828, _S832, false, _S833);
    float _S839 = _S834 / max(1.0 - _S837.by_warp_0 - _S837.by_weft_0, 0.10000000149011612);
    float _S840 = (0.0020000000949949 * warp_seen_from_0(_S828, _S832, _S833) + _S839) / (_S839 + _S835 / max(1.0 - _S838.by_warp_0 - _S838.by_weft_0, 0.10000000149011612) + 0.0020000000949949);
    float _S841 = 1.0 - _S836;
    return bounced_of_families_0(_S828, _S829, _S830, _S831, scaled_0(_S837, _S840 * _S841), scaled_0(_S838, (1.0 - _S840) * _S841));
}

Bounced_0 bounced_over_0(uint _S842, Components_0 _S843, CloseUp_0 _S844, FamilyAlbedos_0 _S845, vec3 _S846, vec3 _S847)
{
    bool _S848 = (_S847.z) < 0.0;
    Interior_0 _S849 = interior_of_0(_S842, _S846, _S848);
    Bounced_0 bounced_2 = bounced_far_0(_S842, _S845, _S846, _S849, to_face_frame_0(_S847, _S848), _S848, _S843.diffuse_warp_0, _S843.diffuse_weft_0, _S843.hole_2);
    if((_S844.weight_0) > 0.0)
    {
        Bounced_0 _S850 = bounced_of_families_0(_S842, _S845, _S846, _S849, _S844.warp_1, _S844.weft_1);
        vec3 _S851 = vec3(_S844.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S850.reflected_0, _S851);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S850.transmitted_0, _S851);
    }
    return bounced_2;
}

vec3 composed_0(uint _S852, Components_0 _S853, CloseUp_0 _S854, FamilyAlbedos_0 _S855, vec3 _S856, vec3 _S857, vec3 _S858)
{
    Albedos_0 _S859 = tinted_0(_S855.warp_5, _S856);
    Albedos_0 _S860 = tinted_0(_S855.weft_5, _S856);
    vec3 _S861 = _S859.diffuse_reflect_0 * _S853.diffuse_warp_0 + _S860.diffuse_reflect_0 * _S853.diffuse_weft_0 + _S859.specular_reflect_0 * _S853.specular_warp_0 + _S860.specular_reflect_0 * _S853.specular_weft_0;
    float _S862 = _S858.z;
    vec3 body_0;
    if((_S857.z * _S862) < 0.0)
    {
        body_0 = _S859.diffuse_transmit_0 * _S853.diffuse_warp_0 + _S860.diffuse_transmit_0 * _S853.diffuse_weft_0 + _S859.specular_transmit_0 * _S853.specular_warp_0 + _S860.specular_transmit_0 * _S853.specular_weft_0;
    }
    else
    {
        body_0 = _S861;
    }
    if((fabrics_0._data[uint(_S852)].openness_0) != 4294967295U)
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S852, _S853, _S854, _S855, _S856, _S858), _S857, _S858);
    }
    float _S863 = fabrics_0._data[uint(_S852)].sheen_strength_0;
    if((fabrics_0._data[uint(_S852)].sheen_strength_0) <= 0.0)
    {
        return body_0;
    }
    bool _S864 = _S862 < 0.0;
    vec2 _S865 = sheen_with_transmittance_0(to_face_frame_0(_S857, _S864), to_face_frame_0(_S858, _S864), _S863, fabrics_0._data[uint(_S852)].sheen_roughness_0);
    return _S865.y * body_0 + (_S853.light_visibility_1 + _S853.hole_2) * _S865.x;
}

vec4 cloth_value_0(uint fabric_1, vec2 centre_2, vec2 dx_1, vec2 dy_1, vec3 light_11, vec3 view_11)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = centre_2;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    Estimate_0 _S866 = lobes_estimate_0(fabric_1, footprint_0, 1.0, light_11, view_11);
    vec3 _S867 = composed_0(fabric_1, _S866.components_0, _S866.close_0, _S866.albedos_5, vec3(1.0), light_11, view_11);
    float through_1;
    if((fabrics_0._data[uint(fabric_1)].sheen_strength_0) > 0.0)
    {
        through_1 = _S866.components_0.hole_2 * (1.0 - fabrics_0._data[uint(fabric_1)].sheen_strength_0 * sheen_lobe_0(abs(view_11.z), fabrics_0._data[uint(fabric_1)].sheen_roughness_0).z);
    }
    else
    {
        through_1 = _S866.components_0.hole_2;
    }
    return vec4(_S867, through_1);
}

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
void main()
{
    if((gl_GlobalInvocationID.x) >= (query_count_0._data[uint(0)]))
    {
        return;
    }
    Query_0 _S868 = queries_0._data[uint(gl_GlobalInvocationID.x)];
    answers_0._data[uint(gl_GlobalInvocationID.x)] = cloth_value_0(_S868.fabric_0, vec2(_S868.centre_x_0, _S868.centre_y_0), vec2(_S868.dx_x_0, _S868.dx_y_0), vec2(_S868.dy_x_0, _S868.dy_y_0), vec3(_S868.light_x_0, _S868.light_y_0, _S868.light_z_0), vec3(_S868.view_x_0, _S868.view_y_0, _S868.view_z_0));
    return;
}

