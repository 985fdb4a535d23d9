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

float natural_logarithm_0(float x_1)
{
    uint _S3 = floatBitsToUint(x_1);
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

float binary_logarithm_0(float x_2)
{
    return natural_logarithm_0(x_2) * 1.4426950216293335;
}

vec3 to_face_frame_0(vec3 direction_0, bool back_1)
{
    vec2 _S5 = direction_0.xy;
    float _S6;
    if(back_1)
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
    float height_0;
    vec3 normal_0;
    vec3 tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_1, vec3 normal_1, vec3 tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S7;
    _S7.hole_0 = hole_1;
    _S7.is_warp_0 = is_warp_1;
    _S7.warp_thread_0 = warp_thread_1;
    _S7.weft_thread_0 = weft_thread_1;
    _S7.height_0 = height_1;
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

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 quality_of_0(float threads_0)
{
    float _S8 = clamp((-3.0 - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10))) / 2.0, 0.0, 1.0);
    SearchQuality_0 quality_0;
    float _S9 = mix(2.5, 5.0, _S8);
    quality_0.steps_per_thread_0 = _S9;
    quality_0.steps_per_relief_0 = _S9;
    quality_0.shadow_share_0 = mix(1.60000002384185791, 1.0, _S8);
    quality_0.refinements_0 = uint(mix(1.0, 2.0, _S8) + 0.5);
    return quality_0;
}

vec2 turns_and_remainder_0(uint family_0, float index_0)
{
    float _S10 = floor(fma(index_0, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S10, fma(- _S10, families_0._data[uint(family_0)].count_0, index_0));
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
    float _S11 = floor(position_0 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S12 = fma(- _S11, families_0._data[uint(family_1)].size_0, position_0);
    cell_0.below_0 = _S12;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S12;
    cell_0.across_2 = _S12 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S11).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
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
    float _S13 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S14;
    if(_S13 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S14 = 1U;
    }
    else
    {
        _S14 = 0U;
    }
    uint _S15 = min(thread_1 + _S14, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S16 = families_0._data[uint(family_2)].place_table_0 + _S15 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S15;
    cell_1.below_0 = _S13 - table_number_0(_S16);
    cell_1.above_0 = table_number_0(_S16 + 1U) - _S13;
    cell_1.across_2 = _S13 - table_number_0(_S16 + 2U);
    cell_1.half_width_1 = table_number_0(_S16 + 3U);
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
    Cell_0 warp_1;
    Cell_0 weft_1;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_2)
{
    bool _S17 = (abs(crossing_0.warp_1.across_2)) < (crossing_0.warp_1.half_width_1);
    bool _S18 = (abs(crossing_0.weft_1.across_2)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S19;
    if(_S17)
    {
        if(!_S18)
        {
            _S19 = true;
        }
        else
        {
            _S19 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S19 = false;
    }
    shown_0.is_warp_2 = _S19;
    if(!_S17)
    {
        _S19 = !_S18;
    }
    else
    {
        _S19 = false;
    }
    shown_0.hole_3 = _S19;
    uint _S20;
    if(shown_0.is_warp_2)
    {
        _S20 = crossing_0.warp_word_0;
    }
    else
    {
        _S20 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S20;
    shown_0.on_top_0 = ((_S20 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_2;
    uint _S21;
    if(is_first_0)
    {
        _S21 = first_0.thread_0;
    }
    else
    {
        _S21 = second_0.thread_0;
    }
    cell_2.thread_0 = _S21;
    float _S22;
    if(is_first_0)
    {
        _S22 = first_0.across_2;
    }
    else
    {
        _S22 = second_0.across_2;
    }
    cell_2.across_2 = _S22;
    if(is_first_0)
    {
        _S22 = first_0.half_width_1;
    }
    else
    {
        _S22 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S22;
    if(is_first_0)
    {
        _S22 = first_0.below_0;
    }
    else
    {
        _S22 = second_0.below_0;
    }
    cell_2.below_0 = _S22;
    if(is_first_0)
    {
        _S22 = first_0.above_0;
    }
    else
    {
        _S22 = second_0.above_0;
    }
    cell_2.above_0 = _S22;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0)
{
    vec2 _S23 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    return fma(_S23.x, families_0._data[uint(family_4)].period_0, table_number_0(families_0._data[uint(family_4)].place_table_0 + uint(_S23.y) * 4U));
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
    Family_0 _S24 = families_0._data[uint(family_6)];
    uint _S25;
    if((families_0._data[uint(family_6)].is_alike_0) != 0U)
    {
        _S25 = 0U;
    }
    else
    {
        _S25 = thread_4 * 4U;
    }
    uint _S26 = _S24.bend_table_0 + _S25;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S26);
    bend_0.half_tangent_0 = table_number_0(_S26 + 1U);
    bend_0.arc_0 = table_number_0(_S26 + 2U);
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
    int _S27 = int((word_1 >> 1) & 127U);
    int _S28 = int((word_1 >> 8) & 127U);
    int _S29 = int((word_1 >> 15) & 63U);
    int _S30 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S31 = - _S27;
    float _S32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S31, 0);
    run_0.from_start_0 = _S32;
    int _S33 = _S28 + 1;
    float _S34 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, 1, _S33);
    run_0.to_end_0 = _S34;
    bool _S35 = _S32 < _S34;
    run_0.near_start_0 = _S35;
    int _S36;
    if(_S35)
    {
        _S36 = _S31 - _S29;
    }
    else
    {
        _S36 = _S33;
    }
    int _S37;
    if(run_0.near_start_0)
    {
        _S37 = _S31;
    }
    else
    {
        _S37 = _S33 + _S30;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    float _S38;
    if(run_0.straight_0)
    {
        _S38 = 1.0e+06;
    }
    else
    {
        _S38 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S38;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_0, crossed_0.thread_0, _S36, _S37), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S27 == 0;
    run_0.last_crossing_0 = _S28 == 0;
    return run_0;
}

float square_0(float x_3)
{
    return x_3 * x_3;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_3)
{
    float _S39 = cell_3.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S40 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S40;
    float _S41 = _S39 * _S39 - square_0(_S40);
    float _S42 = (inversesqrt((_S41)));
    section_0.drop_0 = _S39 - _S41 * _S42;
    section_0.slope_0 = - _S40 * _S42;
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
    bool _S43 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S44 = min(crossed_1.below_0, crossed_1.above_0);
    float _S45;
    if(_S43)
    {
        _S45 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S45 = crossed_1.above_0 + crossed_1.across_2;
    }
    float _S46 = _S45 - crossed_1.half_width_1;
    bool _S47;
    if(_S43)
    {
        _S47 = run_1.first_crossing_0;
    }
    else
    {
        _S47 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S45 = 0.0;
    }
    else
    {
        _S45 = families_0._data[uint(other_1)].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, 0);
    }
    float _S48;
    if((shown_1.on_top_0) != _S47)
    {
        _S48 = 0.0;
    }
    else
    {
        Family_0 _S49 = families_0._data[uint(other_1)];
        int _S50;
        if(_S43)
        {
            _S50 = -1;
        }
        else
        {
            _S50 = 1;
        }
        _S48 = _S49.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S50);
    }
    float _S51 = 1.0 / max(2.0 * _S46, 9.999999960041972e-13);
    float _S52 = clamp((_S46 - _S44) * _S51, 0.0, 1.0);
    float _S53 = _S45 + (_S48 - _S45) * (_S52 * _S52 * (3.0 - 2.0 * _S52));
    float _S54 = (_S45 - _S48) * (6.0 * _S52 * (1.0 - _S52) * _S51);
    if(_S43)
    {
        _S45 = 1.0;
    }
    else
    {
        _S45 = -1.0;
    }
    return vec2(_S53, _S54 * _S45);
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
    float _S55 = direction_1.x;
    control_0.per_x_0 = 1.0 / max(abs(_S55), 9.99999971718068537e-10);
    float _S56 = direction_1.y;
    control_0.per_y_0 = 1.0 / max(abs(_S56), 9.99999971718068537e-10);
    control_0.right_0 = _S55 > 0.0;
    control_0.up_0 = _S56 > 0.0;
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
    float _S57;
    if(forwards_0)
    {
        _S57 = cell_4.across_2;
    }
    else
    {
        _S57 = - cell_4.across_2;
    }
    float _S58;
    if(forwards_0)
    {
        _S58 = cell_4.above_0;
    }
    else
    {
        _S58 = cell_4.below_0;
    }
    bool _S59;
    if(forwards_0)
    {
        _S59 = run_2.last_crossing_0;
    }
    else
    {
        _S59 = run_2.first_crossing_0;
    }
    bool _S60;
    if(forwards_0)
    {
        _S60 = run_2.first_crossing_0;
    }
    else
    {
        _S60 = run_2.last_crossing_0;
    }
    float _S61 = - cell_4.half_width_1;
    bool _S62 = _S57 < _S61;
    bool _S63 = _S57 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S59 = !_S59;
    }
    else
    {
        _S59 = false;
    }
    if(_S59)
    {
        _S59 = !shown_2.hole_3;
    }
    else
    {
        _S59 = false;
    }
    bool _S64;
    if(_S59)
    {
        _S64 = shown_2.on_top_0;
    }
    else
    {
        _S64 = false;
    }
    if(_S64)
    {
        if(_S60)
        {
            _S60 = _S62;
        }
        else
        {
            _S60 = false;
        }
        _S60 = !_S60;
    }
    else
    {
        _S60 = false;
    }
    if(shown_2.hole_3)
    {
        _S59 = true;
    }
    else
    {
        if(_S59)
        {
            _S59 = !shown_2.on_top_0;
        }
        else
        {
            _S59 = false;
        }
    }
    float _S65;
    if(_S62)
    {
        _S65 = _S61;
    }
    else
    {
        _S65 = cell_4.half_width_1;
    }
    float _S66 = _S65 - _S57;
    if(_S59)
    {
        _S57 = 2.0 * _S58 + _S57 - cell_4.half_width_1;
    }
    else
    {
        _S57 = _S58;
    }
    if(_S60)
    {
        if(forwards_0)
        {
            _S57 = run_2.to_end_0;
        }
        else
        {
            _S57 = run_2.from_start_0;
        }
        return _S57;
    }
    if(_S63)
    {
    }
    else
    {
        _S57 = _S66;
    }
    return _S57;
}

struct Probe_0
{
    float height_2;
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
    float _S67 = previous_1.rate_0 * step_4;
    float _S68 = rate_1 * step_4;
    bool _S69;
    if(!previous_1.known_0)
    {
        _S69 = true;
    }
    else
    {
        _S69 = here_0.hole_4;
    }
    if(_S69)
    {
        _S69 = true;
    }
    else
    {
        _S69 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S69)
    {
        _S69 = true;
    }
    else
    {
        _S69 = (previous_1.rate_0) >= 0.0;
    }
    if(_S69)
    {
        _S69 = true;
    }
    else
    {
        _S69 = rate_1 <= 0.0;
    }
    if(_S69)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S67) >= 0.0)
    {
        _S69 = (3.0 * clearance_1 - _S68) >= 0.0;
    }
    else
    {
        _S69 = false;
    }
    if(_S69)
    {
        return -1.0;
    }
    float _S70 = clearance_1 - previous_1.clearance_0;
    float _S71 = 6.0 * _S70 - 4.0 * _S67 - 2.0 * _S68;
    float _S72 = -2.0 * _S67 / max(_S71 + sqrt(max(_S71 * _S71 - 4.0 * (3.0 * (_S67 + _S68 - 2.0 * _S70)) * _S67, 0.0)), 9.99999968265522539e-21);
    float _S73 = 1.0 - _S72;
    float _S74 = (previous_1.clearance_0 * (2.0 * _S72 + 1.0) + _S67 * _S72) * _S73 * _S73;
    float _S75 = (clearance_1 * (2.0 * _S73 + 1.0) - _S68 * _S73) * _S72 * _S72;
    if(_S72 > 0.01999999955296516)
    {
        _S69 = _S73 > 0.01999999955296516;
    }
    else
    {
        _S69 = false;
    }
    if(_S69)
    {
        _S69 = (_S74 + _S75) < 0.0;
    }
    else
    {
        _S69 = false;
    }
    float _S76;
    if(_S69)
    {
        _S76 = _S73 * step_4;
    }
    else
    {
        _S76 = -1.0;
    }
    return _S76;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S77;
    if(here_1.hole_4)
    {
        _S77 = 1.0e+09;
    }
    else
    {
        _S77 = clearance_2;
    }
    previous_2.clearance_0 = _S77;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S78;
    if(!here_1.hole_4)
    {
        _S78 = !is_cell_exit_0;
    }
    else
    {
        _S78 = false;
    }
    previous_2.known_0 = _S78;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S79 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S80;
    if(!here_2.hole_4)
    {
        _S80 = (rate_3 * _S79 + clearance_3) < 0.0;
    }
    else
    {
        _S80 = false;
    }
    if(_S80)
    {
        _S80 = _S79 > (2.0 * this_2.epsilon_0);
    }
    else
    {
        _S80 = false;
    }
    float _S81;
    if(_S80)
    {
        _S81 = _S79 - this_2.epsilon_0;
    }
    else
    {
        _S81 = max(_S79, 0.0) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S81);
}

struct ViewRay_0
{
    vec2 origin_0;
    vec2 slope_1;
};

vec2 ViewRay_at_0(ViewRay_0 this_3, float height_3)
{
    return this_3.origin_0 + this_3.slope_1 * height_3;
}

float ViewRay_rate_0(ViewRay_0 this_4, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S82 = end_0 - start_1;
    float _S83 = start_rate_0 + end_rate_0 - 2.0 * _S82;
    float _S84 = 3.0 * _S82 - 2.0 * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S82, 9.99999968265522539e-21);
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
        float _S85 = clamp(share_0 - (((_S83 * share_0 + _S84) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0 * _S83 * share_0 + 2.0 * _S84) * share_0 + start_rate_0, 0.10000000149011612 * _S82 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S86 = i_0 + 1;
        share_0 = _S85;
        i_0 = _S86;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

vec2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S87 = along_slope_0 * along_slope_0 + 1.0;
    float _S88 = (inversesqrt((_S87)));
    float _S89 = sine_1 * _S88 * (inversesqrt((_S87 + across_slope_0 * across_slope_0)));
    return vec2(- _S89 * _S87, _S89 * across_slope_0 * along_slope_0 + cosine_0 * _S88);
}

float arc_sine_0(float x_4)
{
    float _S90 = abs(x_4);
    bool _S91 = _S90 > 0.5;
    float _S92;
    if(_S91)
    {
        _S92 = 0.5 * (1.0 - _S90);
    }
    else
    {
        _S92 = _S90 * _S90;
    }
    float _S93;
    if(_S91)
    {
        _S93 = sqrt(max(_S92, 0.0));
    }
    else
    {
        _S93 = _S90;
    }
    float _S94 = ((((0.04216320067644119 * _S92 + 0.02418131195008755) * _S92 + 0.04547002539038658) * _S92 + 0.07495300471782684) * _S92 + 0.16666752099990845) * _S92 * _S93 + _S93;
    if(_S91)
    {
        _S92 = 1.57079637050628662 - 2.0 * _S94;
    }
    else
    {
        _S92 = _S94;
    }
    if(x_4 < 0.0)
    {
        _S92 = - _S92;
    }
    return _S92;
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

Albedos_0 albedos_of_0(uint family_8, uint thread_7)
{
    return table_albedos_0(families_0._data[uint(family_8)].albedo_table_0 + families_0._data[uint(family_8)].albedo_stride_0 * thread_7);
}

uint scramble_0(uint value_0)
{
    uint _S95 = value_0 * 747796405U + 2891336453U;
    uint _S96 = ((_S95 >> ((_S95 >> 28) + 4U)) ^ _S95) * 277803737U;
    return (_S96 >> 22) ^ _S96;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> 9) + 0.5) * 1.1920928955078125e-07;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0 * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0) + 1.0;
}

float bounded_gain_0(float gain_0, vec3 albedo_0, vec3 room_0)
{
    vec3 _S97 = room_0 / max(albedo_0, vec3(9.99999997475242708e-07));
    return min(gain_0, max(min(min(_S97.x, _S97.y), _S97.z), 0.0));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0) - 1.0) + 1.0;
}

float diffuse_reflection_0(vec3 light_0, vec3 normal_2, float blend_0)
{
    float _S98 = light_0.z;
    if(_S98 <= 0.0)
    {
        return 0.0;
    }
    return 0.31830987334251404 * mix(max(_S98, 0.0), max(dot(light_0, normal_2), 0.0), blend_0);
}

float projected_area_1(vec3 direction_2, vec3 tangent_2, float roughness_1)
{
    float _S99 = dot(direction_2, tangent_2);
    return sqrt(max((roughness_1 + 1.0) * (roughness_1 - 1.0) * _S99 * _S99 + 1.0, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S100 = clamp(x_5, -87.0, 88.0);
    float _S101 = floor(_S100 * 1.4426950216293335 + 0.5);
    float _S102 = _S100 - _S101 * 0.693359375 + _S101 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S102 + 0.00139819993637502) * _S102 + 0.00833345204591751) * _S102 + 0.04166579619050026) * _S102 + 0.1666666567325592) * _S102 + 0.5;
    float _S103 = uintBitsToFloat(uint(int(_S101) + 127) << 23);
    float _S104;
    if(x_5 < -87.0)
    {
        _S104 = 0.0;
    }
    else
    {
        _S104 = (p_0 * _S102 * _S102 + _S102 + 1.0) * _S103;
    }
    return _S104;
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
    float _S105 = roughness_2 * roughness_2;
    float _S106 = squared_along_0 * (1.0 - _S105) + _S105;
    return 0.31830987334251404 * _S105 * roughness_2 / (_S106 * _S106);
}

float density_between_0(vec3 light_1, vec3 view_0, vec3 tangent_3, float roughness_3)
{
    vec3 _S107 = light_1 + view_0;
    float _S108 = dot(_S107, tangent_3);
    return flake_density_0(min(_S108 * _S108 / max(square_1(_S107), 9.999999960041972e-13), 1.0), roughness_3);
}

float transmission_0(vec3 light_2, vec3 view_1, vec3 normal_3, vec3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S109 = - dot(light_2, normal_3);
    float _S110 = dot(view_1, normal_3);
    bool _S111;
    if(_S109 <= 0.0)
    {
        _S111 = true;
    }
    else
    {
        _S111 = _S110 <= 0.0;
    }
    if(_S111)
    {
        return 0.0;
    }
    float _S112 = 1.0 / max(_S110, 9.99999997475242708e-07);
    float _S113 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S109, 9.99999997475242708e-07);
    float _S114 = projected_area_1(view_1, tangent_4, roughness_4) * _S112;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25 * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S113, _S114)) * mean_attenuation_0(optical_depth_1 * abs(_S113 - _S114)) * _S112;
}

float reflection_0(vec3 light_3, vec3 view_2, vec3 normal_4, vec3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S115 = dot(light_3, normal_4);
    bool _S116;
    if(_S115 <= 0.0)
    {
        _S116 = true;
    }
    else
    {
        _S116 = (dot(view_2, normal_4)) <= 0.0;
    }
    if(_S116)
    {
        return 0.0;
    }
    float _S117 = max(_S115, 9.99999997475242708e-07);
    float _S118 = max(dot(view_2, normal_4), 9.99999997475242708e-07);
    float _S119 = projected_area_1(light_3, tangent_5, roughness_5) * _S118 + projected_area_1(view_2, tangent_5, roughness_5) * _S117;
    float _S120 = optical_depth_2 * _S119 / (_S117 * _S118);
    return 0.25 * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S120 * mean_attenuation_0(_S120)) * _S117 / _S119;
}

Components_0 with_added_0(Components_0 sums_0, Components_0 more_0, float weight_0)
{
    Components_0 result_0;
    result_0.diffuse_warp_0 = sums_0.diffuse_warp_0 + weight_0 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_0.diffuse_weft_0 + weight_0 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_0.specular_warp_0 + weight_0 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_0.specular_weft_0 + weight_0 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_0.light_visibility_1 + weight_0 * more_0.light_visibility_1;
    result_0.hole_2 = sums_0.hole_2 + weight_0 * more_0.hole_2;
    return result_0;
}

float wrapped_cell_0(float position_3, float count_1)
{
    return min(floor((position_3 - floor(position_3)) * count_1), count_1 - 1.0);
}

float arc_tangent_quotient_0(float x_6, float y_0)
{
    return ((((((0.0 * x_6 + 0.00809729471802711) * x_6 + -0.0377517081797123) * x_6 + 0.08475969731807709) * x_6 + -0.13537675142288208) * x_6 + 0.19895026087760925) * x_6 + -0.33327975869178772) * x_6 + 0.99999970197677612;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0);
}

float arc_tangent_0(float y_1, float x_7)
{
    float _S121 = abs(x_7);
    float _S122 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S121, _S122) / max(max(_S121, _S122), 1.00000000317107685e-30));
    float angle_1;
    if(_S122 > _S121)
    {
        angle_1 = 1.57079637050628662 - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_7 < 0.0)
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
    float _S123 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461;
    float _S124 = floor(_S123);
    float _S125 = _S123 - _S124;
    float _S126 = sqrt(clamp((1.0 - abs(direction_3.z)) / 0.97000002861022949, 0.0, 1.0));
    float _S127 = 7.0 * _S126 * sqrt(_S126);
    float _S128 = min(floor(_S127), 6.0);
    float _S129 = _S127 - _S128;
    uint _S130 = uint(int(_S124) + 32) % 32U;
    uint _S131 = uint(_S128);
    uint _S132 = _S130 * 8U + _S131;
    uint _S133 = (_S130 + 1U) % 32U * 8U + _S131;
    NodeTaps_0 taps_0;
    taps_0.nodes_0 = uvec4(_S132, _S132 + 1U, _S133, _S133 + 1U);
    float _S134 = 1.0 - _S125;
    float _S135 = 1.0 - _S129;
    uvec4 _S136 = uvec4(vec4(_S134 * _S135, _S134 * _S129, _S125 * _S135, _S125 * _S129) * 252.0 + 0.5);
    taps_0.weights_0 = _S136;
    taps_0.inverse_sum_0 = 1.0 / float(_S136.x + _S136.y + _S136.z + _S136.w);
    return taps_0;
}

vec3 half_vector_0(vec3 light_4, vec3 view_3)
{
    vec3 _S137 = light_4 + view_3;
    return _S137 * (inversesqrt((max(square_1(_S137), 9.999999960041972e-13))));
}

vec3 shadow_correlation_0(vec3 light_5, vec3 view_4)
{
    vec2 _S138 = light_5.xy;
    vec2 _S139 = view_4.xy;
    float _S140 = dot(_S138, _S139) / max(sqrt(dot(_S138, _S138) * dot(_S139, _S139)), 9.99999997475242708e-07);
    if((light_5.z) < 0.0)
    {
        return vec3(vec2(-0.09000000357627869 + -0.07999999821186066 * _S140), 0.0);
    }
    return vec3(min(0.62000000476837158 + 0.62999999523162842 * _S140, 1.20000004768371582), 0.62000000476837158, 0.37000000476837158);
}

vec4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return vec4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16), float(odd_0 >> 16));
}

vec4 interpolate_0(NodeTaps_0 taps_1, uvec4 packs_1)
{
    uvec4 _S141 = (packs_1 & 16711935U) * taps_1.weights_0;
    uvec4 _S142 = ((packs_1 >> 8) & 16711935U) * taps_1.weights_0;
    return bytes_of_sums_0(_S141.x + _S141.y + _S141.z + _S141.w, _S142.x + _S142.y + _S142.z + _S142.w) * taps_1.inverse_sum_0;
}

vec4 interpolate_table_0(NodeTaps_0 taps_2, uint table_0, uint stride_0)
{
    uvec4 _S143 = table_0 + taps_2.nodes_0 * stride_0;
    return interpolate_0(taps_2, uvec4(words_0._data[uint(_S143.x)], words_0._data[uint(_S143.y)], words_0._data[uint(_S143.z)], words_0._data[uint(_S143.w)]));
}

struct Group_0
{
    vec3 normal_5;
    float weight_1;
    vec3 tangent_6;
    vec3 variance_0;
    vec3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    group_0.normal_5 = vec3(table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    group_0.weight_1 = table_number_0(row_1 + 3U);
    vec3 _S144 = vec3(table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    group_0.tangent_6 = _S144;
    float _S145 = table_number_0(row_1 + 7U);
    float _S146 = table_number_0(row_1 + 8U);
    group_0.variance_0 = vec3(_S145, _S146, 1.0 - square_1(_S144) - _S145 - _S146);
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
    float _S147 = direction_4.x;
    float _S148 = direction_4.y;
    float _S149 = direction_4.z;
    return max(dot(this_5.variance_0, direction_4 * direction_4) + 2.0 * dot(this_5.covariance_0, vec3(_S147 * _S148, _S147 * _S149, _S148 * _S149)), 0.0);
}

float mean_area_0(Group_0 group_1, vec3 direction_5)
{
    float _S150 = dot(direction_5, group_1.tangent_6);
    float _S151 = group_1.roughness_6;
    float _S152 = _S151 * _S151;
    return sqrt(max((_S152 - 1.0) * (_S150 * _S150 + Group_variance_along_0(group_1, direction_5)) + 1.0, _S152));
}

float mean_density_0(Group_0 group_2, vec3 half_0)
{
    float _S153 = group_2.roughness_6;
    float _S154 = max(sqrt(max(1.0 - _S153 * _S153, 0.0)) / group_2.roughness_6, 0.00100000004749745);
    float _S155 = max(sqrt(3.0 * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516 + 0.00009999999747379);
    float _S156 = dot(half_0, group_2.tangent_6);
    float _S157 = _S154 * (_S156 - _S155);
    float _S158 = _S154 * (_S156 + _S155);
    float _S159 = _S157 * _S158;
    float _S160 = 2.0 * _S155 * _S154;
    return 0.15915493667125702 / group_2.roughness_6 * ((1.0 - _S159) / ((_S157 * _S157 + 1.0) * (_S158 * _S158 + 1.0)) + arc_tangent_0(_S160, 1.0 + _S159) / _S160);
}

float layer_value_0(Group_0 group_3, vec3 half_1, vec3 light_6, vec3 view_5, float optical_depth_3)
{
    bool _S161 = (light_6.z) < 0.0;
    float _S162 = dot(light_6, group_3.normal_5);
    float _S163;
    if(_S161)
    {
        _S163 = - _S162;
    }
    else
    {
        _S163 = _S162;
    }
    float _S164 = max(dot(view_5, group_3.normal_5), 0.01999999955296516);
    float _S165 = mean_area_0(group_3, light_6) / max(_S163, 0.01999999955296516);
    float _S166 = mean_area_0(group_3, view_5) / _S164;
    if(_S161)
    {
        _S163 = abs(_S165 - _S166);
    }
    else
    {
        _S163 = _S165 + _S166;
    }
    float _S167 = optical_depth_3 * max(_S163, 0.00100000004749745);
    if(_S161)
    {
        _S163 = exponential_0(- optical_depth_3 * min(_S165, _S166));
    }
    else
    {
        _S163 = 1.0;
    }
    float _S168 = optical_depth_3 * _S163 * (1.0 - exponential_0(- _S167)) / _S167 / _S164;
    if(_S161)
    {
        _S163 = 1.0;
    }
    else
    {
        _S163 = 1.0 - 0.34999999403953552 * (1.0 - square_1(group_3.normal_5));
    }
    return 0.25 * mean_density_0(group_3, half_1) * _S163 * _S168;
}

struct Bound_0
{
    uint thread_11;
    float turns_2;
    float cell_7;
    float visible_0;
    float width_0;
    float gap_0;
};

Bound_0 bound_at_0(uint family_9, float position_4)
{
    Cell_0 _S169 = locate_0(family_9, position_4);
    float _S170 = table_number_0(families_0._data[uint(family_9)].before_0 + 2U * _S169.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_11 = _S169.thread_0;
    bound_0.turns_2 = round((position_4 - families_0._data[uint(family_9)].start_0 - _S170 - _S169.below_0) * families_0._data[uint(family_9)].inverse_period_0);
    bound_0.cell_7 = _S169.below_0;
    float _S171 = 2.0 * _S169.half_width_1;
    bound_0.width_0 = _S171;
    bound_0.visible_0 = clamp((_S169.across_2 + _S169.half_width_1) / _S171, 0.0, 1.0);
    bound_0.gap_0 = min(_S169.below_0, _S169.below_0 - _S169.across_2 - _S169.half_width_1) + max(_S169.across_2 - _S169.half_width_1, 0.0);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    float _S172 = centre_1 - floor((centre_1 - families_0._data[uint(family_10)].start_0) * families_0._data[uint(family_10)].inverse_period_0) * families_0._data[uint(family_10)].period_0;
    float _S173 = 0.5 * max(size_1, families_0._data[uint(family_10)].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_0 = bound_at_0(family_10, _S172 - _S173);
    stretch_0.high_0 = bound_at_0(family_10, _S172 + _S173);
    return stretch_0;
}

float Stretch_turns_0(Stretch_0 this_6)
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

vec3 lengths_0(uint family_11, Stretch_0 stretch_1)
{
    float _S174 = Stretch_turns_0(stretch_1);
    uint _S175 = families_0._data[uint(family_11)].before_0 + 2U * stretch_1.low_0.thread_11;
    uint _S176 = families_0._data[uint(family_11)].before_0 + 2U * stretch_1.high_0.thread_11;
    float _S177 = table_number_0(_S176) - table_number_0(_S175);
    float _S178 = table_number_0(_S176 + 1U) - table_number_0(_S175 + 1U);
    return vec3(_S177 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_0 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_0 + _S174 * families_0._data[uint(family_11)].visible_total_0, _S178 - _S177 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S174 * (families_0._data[uint(family_11)].period_0 - families_0._data[uint(family_11)].visible_total_0), _S178 + stretch_1.high_0.cell_7 - stretch_1.low_0.cell_7 + _S174 * families_0._data[uint(family_11)].period_0);
}

vec2 integrals_along_0(uint family_12, Stretch_0 stretch_2, uint quantity_0)
{
    Family_0 _S179 = families_0._data[uint(family_12)];
    uint _S180 = 3U * _S179.quantities_0;
    uint _S181 = families_0._data[uint(family_12)].colour_threads_0 + _S180 * stretch_2.low_0.thread_11 + quantity_0;
    uint _S182 = families_0._data[uint(family_12)].colour_threads_0 + _S180 * stretch_2.high_0.thread_11 + quantity_0;
    uint _S183 = families_0._data[uint(family_12)].colour_threads_0 + _S180 * uint(families_0._data[uint(family_12)].count_0) + quantity_0;
    float _S184 = table_number_0(_S181);
    float _S185 = table_number_0(_S182);
    float _S186 = Stretch_turns_0(stretch_2);
    uint _S187 = 2U * _S179.quantities_0;
    return vec2(table_number_0(_S182 + _S179.quantities_0) - table_number_0(_S181 + _S179.quantities_0) + _S185 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_0 - _S184 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_0 + _S186 * table_number_0(_S183 + _S179.quantities_0), table_number_0(_S182 + _S187) - table_number_0(_S181 + _S187) + _S185 * stretch_2.high_0.cell_7 - _S184 * stretch_2.low_0.cell_7 + _S186 * table_number_0(_S183 + _S187));
}

bool Stretch_wraps_0(Stretch_0 this_7)
{
    return (this_7.high_0.thread_11) < (this_7.low_0.thread_11);
}

uvec4 Stretch_differences_0(Stretch_0 this_8, uvec4 entries_0, uint whole_0)
{
    uint _S188 = entries_0.z;
    uint _S189 = entries_0.x;
    uint _S190 = _S188 - _S189;
    uint _S191;
    if(Stretch_wraps_0(this_8))
    {
        _S191 = whole_0;
    }
    else
    {
        _S191 = 0U;
    }
    return uvec4(_S190 + _S191, entries_0.w - _S188, entries_0.y - _S189, whole_0);
}

uvec4 row_differences_0(Stretch_0 across_4, uint row_2, uint count_2, uint quantities_1)
{
    uint _S192 = row_2 + across_4.low_0.thread_11 * quantities_1;
    uint _S193 = row_2 + across_4.high_0.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, uvec4(words_0._data[uint(_S192)], words_0._data[uint(_S192 + quantities_1)], words_0._data[uint(_S193)], words_0._data[uint(_S193 + quantities_1)]), words_0._data[uint(row_2 + count_2 * quantities_1)]);
}

vec4 Stretch_weights_0(Stretch_0 this_9)
{
    float _S194 = - this_9.low_0.visible_0;
    float _S195 = Stretch_turns_0(this_9);
    float _S196;
    if(Stretch_wraps_0(this_9))
    {
        _S196 = 1.0;
    }
    else
    {
        _S196 = 0.0;
    }
    return vec4(1.0, this_9.high_0.visible_0, _S194, _S195 - _S196);
}

float integral_on_top_0(uint family_13, Stretch_0 across_5, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S197 = uint(families_0._data[uint(family_13)].count_0);
    uint _S198 = (_S197 + 1U) * families_0._data[uint(family_13)].quantities_0;
    uint _S199 = families_0._data[uint(family_13)].colour_areas_0 + quantity_1;
    uvec4 _S200 = row_differences_0(across_5, _S199 + along_0.low_0.thread_11 * _S198, _S197, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S201 = row_differences_0(across_5, _S199 + (along_0.low_0.thread_11 + 1U) * _S198, _S197, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S202 = row_differences_0(across_5, _S199 + along_0.high_0.thread_11 * _S198, _S197, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S203 = row_differences_0(across_5, _S199 + (along_0.high_0.thread_11 + 1U) * _S198, _S197, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S204 = row_differences_0(across_5, _S199 + crossing_count_0 * _S198, _S197, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S205 = _S202 - _S200;
    uvec4 _S206;
    if(Stretch_wraps_0(along_0))
    {
        _S206 = _S204;
    }
    else
    {
        _S206 = uvec4(ivec4(0));
    }
    vec4 _S207 = Stretch_weights_0(across_5);
    return dot(vec4(dot(vec4(ivec4(_S205 + _S206)), _S207), dot(vec4(ivec4(_S203 - _S202)), _S207), dot(vec4(ivec4(_S201 - _S200)), _S207), dot(vec4(ivec4(_S204)), _S207)), Stretch_weights_0(along_0)) * families_0._data[uint(family_13)].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_2, uint row_3)
{
    Albedos_0 _S208 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_2 * _S208.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_2 * _S208.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_2 * _S208.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_2 * _S208.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 own_1, Stretch_0 other_2, bool back_3)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0._data[uint(family_14)].colour_mean_0);
    if((families_0._data[uint(family_14)].quantities_0) == 1U)
    {
        return albedos_2;
    }
    vec3 _S209 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_3 = 0.0;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0._data[uint(family_14)].quantities_0))
        {
        }
        else
        {
            break;
        }
        vec2 _S210 = integrals_along_0(family_14, own_1, quantity_2);
        float _S211 = integral_on_top_0(family_14, own_1, other_2, uint(families_0._data[uint(crossing_1)].count_0), quantity_2);
        float _S212 = _S210.x;
        float _S213 = _S212 * _S209.x;
        float _S214;
        if(back_3)
        {
            _S214 = _S213 - _S211;
        }
        else
        {
            _S214 = _S211;
        }
        bool _S215 = quantity_2 == 0U;
        if(_S215)
        {
            is_exposed_0 = _S214 > (16.0 * families_0._data[uint(family_14)].area_unit_0 * min(_S213 / families_0._data[uint(family_14)].crossing_area_0, 1.0) + 0.00000999999974738 * _S213);
        }
        float _S216 = _S212 * _S209.y;
        float _S217;
        if(is_exposed_0)
        {
            _S217 = _S214;
        }
        else
        {
            _S217 = 0.0;
        }
        float _S218 = _S216 + _S217 + 0.000244140625 * _S209.z * _S210.y;
        if(_S215)
        {
            weight_3 = 1.0 / max(_S218, 9.99999968265522539e-21);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S218 * weight_3, families_0._data[uint(family_14)].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate_0(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate_0(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate_0(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate_0(albedos_2.specular_transmit_0);
    return albedos_2;
}

Albedos_0 lerp_albedos_0(Albedos_0 first_2, Albedos_0 second_1, float weight_4)
{
    Albedos_0 albedos_3;
    vec3 _S219 = vec3(weight_4);
    albedos_3.diffuse_reflect_0 = mix(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S219);
    albedos_3.diffuse_transmit_0 = mix(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S219);
    albedos_3.specular_reflect_0 = mix(first_2.specular_reflect_0, second_1.specular_reflect_0, _S219);
    albedos_3.specular_transmit_0 = mix(first_2.specular_transmit_0, second_1.specular_transmit_0, _S219);
    return albedos_3;
}

float sheen_scale_0(float x_8, float y_2)
{
    return (((((0.0 * x_8 + (((((-1.1402510404586792 * y_2 + 0.40672621130943298) * y_2 + 1.65398800373077393) * y_2 + -1.29730904102325439) * y_2 + 0.30570998787879944) * y_2 + -0.0220868494361639)) * x_8 + (((((-0.21142719686031342 * y_2 + 1.05947399139404297) * y_2 + -0.41116121411323547) * y_2 + -0.93859231472015381) * y_2 + 0.51606941223144531) * y_2 + 0.05409301072359085)) * x_8 + (((((1.22944498062133789 * y_2 + -0.45962560176849365) * y_2 + -1.63861405849456787) * y_2 + 1.33565104007720947) * y_2 + -0.45725581049919128) * y_2 + 0.08243165910243988)) * x_8 + (((((0.39779931306838989 * y_2 + -1.18879103660583496) * y_2 + 0.28251591324806213) * y_2 + 1.168984055519104) * y_2 + -0.76864629983901978) * y_2 + 0.0091691892594099)) * x_8 + (((((-0.26563560962677002 * y_2 + -0.19379159808158875) * y_2 + 0.2677634060382843) * y_2 + 0.00270519289188087) * y_2 + 0.14349560439586639) * y_2 + 0.10290180146694183)) * x_8 + (((((-0.20701569318771362 * y_2 + 0.24526430666446686) * y_2 + 0.19551840424537659) * y_2 + 0.07586126774549484) * y_2 + 0.38894739747047424) * y_2 + 0.15043120086193085);
}

float sheen_shear_0(float x_9, float y_3)
{
    return ((((0.0 * x_9 + (((((-0.10608240216970444 * y_3 + 1.99214303493499756) * y_3 + -1.42255294322967529) * y_3 + -1.09495604038238525) * y_3 + 0.59180057048797607) * y_3 + 0.06902855634689331)) * x_9 + (((((-0.46220690011978149 * y_3 + -0.29113379120826721) * y_3 + 1.39025199413299561) * y_3 + 0.35589990019798279) * y_3 + -1.17120099067687988) * y_3 + 0.15940259397029877)) * x_9 + (((((2.26068711280822754 * y_3 + -3.64728999137878418) * y_3 + -0.72173482179641724) * y_3 + 3.07659196853637695) * y_3 + -0.6827620267868042) * y_3 + -0.3039557933807373)) * x_9 + (((((0.81201767921447754 * y_3 + 0.36014080047607422) * y_3 + -1.72646903991699219) * y_3 + -0.22630110383033752) * y_3 + 0.89514690637588501) * y_3 + -0.10397960245609283)) * x_9 + (((((-0.37648698687553406 * y_3 + 1.10974001884460449) * y_3 + 0.17824520170688629) * y_3 + -1.04968702793121338) * y_3 + 0.1461234986782074) * y_3 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_10, float y_4)
{
    return ((((0.0 * x_10 + (((((12.95646953582763672 * y_4 + -21.38032913208007812) * y_4 + -7.37853097915649414) * y_4 + 34.55607986450195312) * y_4 + -23.61347007751464844) * y_4 + 5.00126314163208008)) * x_10 + (((((10.91487026214599609 * y_4 + -6.08202791213989258) * y_4 + -38.2036285400390625) * y_4 + 53.3440399169921875) * y_4 + -21.91996002197265625) * y_4 + 2.01606011390686035)) * x_10 + (((((-14.52206039428710938 * y_4 + 36.803619384765625) * y_4 + -22.94047927856445312) * y_4 + -10.07973003387451172) * y_4 + 15.77003955841064453) * y_4 + -4.92722177505493164)) * x_10 + (((((-7.62505722045898438 * y_4 + 1.27310299873352051) * y_4 + 31.19523048400878906) * y_4 + -44.39989852905273438) * y_4 + 26.44947052001953125) * y_4 + -8.73507976531982422)) * x_10 + (((((5.65633487701416016 * y_4 + -17.66820907592773438) * y_4 + 24.65356063842773438) * y_4 + -19.38941001892089844) * y_4 + 11.06159019470214844) * y_4 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S220 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S221 = 2.0 * sqrt(_S220) - 1.0;
    float _S222 = 3.0 * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S221, _S222), 0.00999999977648258, 1.0), clamp((1.0 - _S220) * sheen_shear_0(_S221, _S222), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S221, _S222), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_7, vec3 view_6, float scale_0, float shear_0)
{
    float _S223 = light_7.z;
    bool _S224;
    if(_S223 <= 0.0)
    {
        _S224 = true;
    }
    else
    {
        _S224 = (view_6.z) <= 0.0;
    }
    if(_S224)
    {
        return 0.0;
    }
    vec2 _S225 = view_6.xy;
    float _S226 = dot(_S225, _S225);
    vec2 _S227;
    if(_S226 > 9.99999968265522539e-21)
    {
        _S227 = _S225 * (inversesqrt((_S226)));
    }
    else
    {
        _S227 = vec2(1.0, 0.0);
    }
    float _S228 = scale_0 * dot(light_7.xy, _S227) + shear_0 * _S223;
    float _S229 = scale_0 * (light_7.y * _S227.x - light_7.x * _S227.y);
    float _S230 = _S228 * _S228 + _S229 * _S229 + _S223 * _S223;
    return 0.31830987334251404 * scale_0 * scale_0 * _S223 / max(_S230 * _S230, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_8, vec3 view_7, float strength_0, float roughness_9)
{
    vec3 _S231 = sheen_lobe_0(view_7.z, roughness_9);
    float _S232 = strength_0 * _S231.z;
    return vec2(_S232 * transformed_cosine_0(light_8, view_7, _S231.x, _S231.y), 1.0 - _S232);
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_2;
    Albedos_0 weft_2;
};

struct Estimate_0
{
    Components_0 components_0;
    FamilyAlbedos_0 albedos_4;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_0;
};

Regime_0 regime_of_0(uint _S233, Footprint_0 _S234, float _S235)
{
    float _S236 = Footprint_spread_side_0(_S234);
    float _S237 = clamp((binary_logarithm_0(max(_S236, 9.99999971718068537e-10)) - fabrics_0._data[uint(_S233)].lobes_0.unit_level_0 - -0.7369655966758728) / 1.41503751277923584, 0.0, 1.0);
    Regime_0 regime_0;
    float _S238 = _S237 * _S237 * (3.0 - 2.0 * _S237);
    regime_0.prefiltered_0 = _S238;
    regime_0.threads_1 = _S236 * fabrics_0._data[uint(_S233)].lobes_0.threads_per_mm_0;
    float _S239 = mix(max(8.0 / _S235, 1.0), 1.0, _S238);
    float _S240;
    if(_S238 < 1.0)
    {
        _S240 = clamp(regime_0.threads_1 * 12.0, 1.0, _S239);
    }
    else
    {
        _S240 = 0.0;
    }
    regime_0.points_0 = _S240;
    return regime_0;
}

struct Hit_0
{
    float x_11;
    float y_5;
    bool hole_5;
    float height_4;
};

struct Sample_0
{
    Crossing_0 crossing_2;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_5;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S241, float _S242, float _S243, bool _S244)
{
    Crossing_0 crossing_3;
    crossing_3.warp_1 = locate_0(fabrics_0._data[uint(_S241)].warp_0, _S242);
    crossing_3.weft_1 = locate_0(fabrics_0._data[uint(_S241)].weft_0, _S243);
    uint _S245 = fabrics_0._data[uint(_S241)].run_words_0 + 2U * (crossing_3.weft_1.thread_0 * fabrics_0._data[uint(_S241)].ends_1 + crossing_3.warp_1.thread_0);
    uint _S246 = words_0._data[uint(_S245)];
    crossing_3.warp_word_0 = _S246;
    crossing_3.weft_word_0 = words_0._data[uint(_S245 + 1U)];
    crossing_3.warp_above_0 = ((_S246 & 1U) == 1U) != _S244;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S247, float _S248, float _S249, bool _S250)
{
    Sample_0 sample_0;
    Crossing_0 _S251 = crossing_at_0(_S247, _S248, _S249, _S250);
    sample_0.crossing_2 = _S251;
    Shown_0 _S252 = shown_at_0(_S251, _S250);
    sample_0.shown_3 = _S252;
    uint _S253;
    if(_S252.is_warp_2)
    {
        _S253 = fabrics_0._data[uint(_S247)].warp_0;
    }
    else
    {
        _S253 = fabrics_0._data[uint(_S247)].weft_0;
    }
    uint _S254;
    if(_S252.is_warp_2)
    {
        _S254 = fabrics_0._data[uint(_S247)].weft_0;
    }
    else
    {
        _S254 = fabrics_0._data[uint(_S247)].warp_0;
    }
    Cell_0 _S255 = select_cell_0(_S252.is_warp_2, sample_0.crossing_2.warp_1, sample_0.crossing_2.weft_1);
    Cell_0 _S256 = select_cell_0(_S252.is_warp_2, sample_0.crossing_2.weft_1, sample_0.crossing_2.warp_1);
    Run_0 _S257 = unpack_0(_S253, _S254, _S255.thread_0, _S256, _S252.word_0);
    Section_0 _S258 = section_at_0(_S255);
    bool _S259;
    if(_S252.on_top_0)
    {
        _S259 = (_S257.distance_0) < (_S258.drop_0 * _S257.bend_1.sine_0);
    }
    else
    {
        _S259 = false;
    }
    bool _S260;
    if(_S252.on_top_0)
    {
        _S260 = !_S259;
    }
    else
    {
        _S260 = false;
    }
    float _S261;
    if(_S260)
    {
        _S261 = 1.0;
    }
    else
    {
        _S261 = -1.0;
    }
    float _S262;
    if(_S259)
    {
        _S262 = _S257.other_reach_0;
    }
    else
    {
        _S262 = _S257.reach_0;
    }
    float _S263;
    if(_S259)
    {
        _S263 = _S262 + _S257.distance_0;
    }
    else
    {
        _S263 = max(_S262 - _S257.distance_0, 0.0);
    }
    float _S264 = _S262 / _S257.bend_1.sine_0 - _S261 * _S258.drop_0;
    float _S265 = _S263 * _S263;
    float _S266 = max(_S264 * _S264 - _S265, 9.99999968265522539e-21);
    float _S267 = (inversesqrt((_S266)));
    float _S268 = _S265 / (_S266 * _S267 + _S264);
    bool _S269 = _S263 > 0.0;
    float _S270;
    if(_S252.on_top_0)
    {
        _S270 = 1.0;
    }
    else
    {
        _S270 = -1.0;
    }
    float _S271;
    if(_S257.near_start_0)
    {
        _S271 = 1.0;
    }
    else
    {
        _S271 = -1.0;
    }
    float _S272 = _S270 * _S271;
    if(_S269)
    {
        _S270 = _S264 * _S267;
    }
    else
    {
        _S270 = 1.0;
    }
    sample_0.slope_across_0 = _S258.slope_0 * _S270;
    if(_S269)
    {
        _S263 = _S272 * _S263 * _S267;
    }
    else
    {
        _S263 = 0.0;
    }
    sample_0.slope_along_0 = _S263;
    Family_0 _S273 = families_0._data[uint(_S253)];
    vec2 _S274 = dive_0(_S254, _S252, _S257, _S256);
    if(_S257.straight_0)
    {
        _S261 = 0.0;
    }
    else
    {
        _S261 = _S273.height_scale_0 * _S261;
    }
    sample_0.height_5 = _S261 * (_S262 * _S257.bend_1.half_tangent_0 - _S268) - _S273.height_scale_0 * _S258.drop_0 - _S274.x;
    float _S275 = _S273.height_scale_0 * sample_0.slope_across_0;
    float _S276 = _S273.height_scale_0 * sample_0.slope_along_0 - _S274.y;
    if(_S252.is_warp_2)
    {
        _S261 = _S275;
    }
    else
    {
        _S261 = _S276;
    }
    sample_0.slope_x_1 = _S261;
    if(_S252.is_warp_2)
    {
        _S261 = _S276;
    }
    else
    {
        _S261 = _S275;
    }
    sample_0.slope_y_1 = _S261;
    sample_0.run_3 = _S257;
    sample_0.section_1 = _S258;
    return sample_0;
}

float steps_per_length_0(uint _S277, SearchQuality_0 _S278, vec3 _S279)
{
    return max(max(abs(_S279.x) * fabrics_0._data[uint(_S277)].threads_per_x_0, abs(_S279.y) * fabrics_0._data[uint(_S277)].threads_per_y_0) * _S278.steps_per_thread_0, abs(_S279.z) * fabrics_0._data[uint(_S277)].per_relief_0 * _S278.steps_per_relief_0);
}

float cell_maximum_0(uint _S280, Crossing_0 _S281)
{
    uint _S282;
    if(_S281.warp_above_0)
    {
        _S282 = fabrics_0._data[uint(_S280)].warp_0;
    }
    else
    {
        _S282 = fabrics_0._data[uint(_S280)].weft_0;
    }
    uint _S283;
    if(_S281.warp_above_0)
    {
        _S283 = _S281.warp_word_0;
    }
    else
    {
        _S283 = _S281.weft_word_0;
    }
    return float(_S283 >> 28) * families_0._data[uint(_S282)].height_scale_0 * families_0._data[uint(_S282)].level_0;
}

Probe_0 probe_0(uint _S284, float _S285, float _S286, bool _S287, bool _S288, bool _S289)
{
    Sample_0 _S290 = sample_at_0(_S284, _S285, _S286, _S287);
    Probe_0 probe_1;
    probe_1.height_2 = _S290.height_5;
    probe_1.hole_4 = _S290.shown_3.hole_3;
    probe_1.slope_x_0 = _S290.slope_x_1;
    probe_1.slope_y_0 = _S290.slope_y_1;
    uint _S291;
    if(_S290.shown_3.is_warp_2)
    {
        _S291 = _S290.crossing_2.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S291 = _S290.crossing_2.weft_1.thread_0 * 2U;
    }
    probe_1.yarn_1 = _S291;
    probe_1.cell_max_0 = cell_maximum_0(_S284, _S290.crossing_2);
    float _S292;
    if(_S288)
    {
        _S292 = _S290.crossing_2.warp_1.above_0;
    }
    else
    {
        _S292 = _S290.crossing_2.warp_1.below_0;
    }
    probe_1.side_x_0 = _S292;
    if(_S289)
    {
        _S292 = _S290.crossing_2.weft_1.above_0;
    }
    else
    {
        _S292 = _S290.crossing_2.weft_1.below_0;
    }
    probe_1.side_y_0 = _S292;
    probe_1.edge_x_0 = outline_distance_0(_S290.crossing_2.warp_1, _S290.shown_3, _S290.run_3, !_S290.shown_3.is_warp_2, _S288);
    probe_1.edge_y_0 = outline_distance_0(_S290.crossing_2.weft_1, _S290.shown_3, _S290.run_3, _S290.shown_3.is_warp_2, _S289);
    return probe_1;
}

bool is_free_0(uint _S293, SearchQuality_0 _S294, vec3 _S295, vec3 _S296, bool _S297, float _S298)
{
    float _S299 = _S296.z;
    if(_S299 <= 0.0)
    {
        return false;
    }
    float _S300 = 1.0 / max(_S294.shadow_share_0 * steps_per_length_0(_S293, _S294, _S296), 9.99999971718068537e-10);
    StepControl_0 _S301 = step_control_0(_S296.xy, _S300);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S302;
        if(count_3 < 1024U)
        {
            _S302 = (_S295.z + _S299 * distance_1) < _S298;
        }
        else
        {
            _S302 = false;
        }
        if(_S302)
        {
        }
        else
        {
            break;
        }
        vec3 _S303 = _S295 + _S296 * distance_1;
        Probe_0 _S304 = probe_0(_S293, _S303.x, _S303.y, _S297, _S301.right_0, _S301.up_0);
        float _S305 = _S303.z;
        float _S306 = _S305 - _S304.height_2;
        float _S307 = _S299 - _S304.slope_x_0 * _S296.x - _S304.slope_y_0 * _S296.y;
        bool _S308;
        if(!_S304.hole_4)
        {
            _S308 = _S306 < 0.0;
        }
        else
        {
            _S308 = false;
        }
        if(_S308)
        {
            return false;
        }
        float _S309 = way_back_to_dip_0(previous_3, _S306, _S307, last_step_0, _S304);
        if(_S309 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S309;
            distance_1 = distance_1 - _S309;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S310 = _S305 > (_S304.cell_max_0);
        PreviousSample_0 _S311 = after_sample_0(_S306, _S307, _S304, _S310);
        float last_step_2;
        if(_S310)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S301, _S304.side_x_0, _S304.side_y_0), _S300);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S301, _S304, _S306, _S307);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S311;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S312, SearchQuality_0 _S313, float _S314, float _S315, vec3 _S316, bool _S317)
{
    if(!sample_at_0(_S312, _S314, _S315, _S317).shown_3.hole_3)
    {
        return false;
    }
    vec3 _S318 = vec3(_S314, _S315, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S319;
        if(side_0 < 2U)
        {
            _S319 = passes_0;
        }
        else
        {
            _S319 = false;
        }
        if(_S319)
        {
        }
        else
        {
            break;
        }
        vec3 _S320;
        if(side_0 == 0U)
        {
            _S320 = _S316;
        }
        else
        {
            _S320 = vec3(- _S316.x, - _S316.y, _S316.z);
        }
        bool _S321 = is_free_0(_S312, _S313, _S318, _S320, _S317 != (side_0 == 1U), fabrics_0._data[uint(_S312)].height_high_0);
        uint _S322 = side_0 + 1U;
        passes_0 = _S321;
        side_0 = _S322;
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

float max_height_along_0(uint _S323, float _S324, float _S325, float _S326, vec3 _S327, bool _S328)
{
    uint _S329 = locate_0(fabrics_0._data[uint(_S323)].warp_0, _S324).thread_0 / 2U;
    uint _S330 = locate_0(fabrics_0._data[uint(_S323)].weft_0, _S325).thread_0 / 2U;
    float _S331 = _S327.x;
    uint _S332;
    if(_S331 > 0.0)
    {
        _S332 = 1U;
    }
    else
    {
        _S332 = 0U;
    }
    float _S333 = _S327.y;
    uint _S334;
    if(_S333 > 0.0)
    {
        _S334 = 2U;
    }
    else
    {
        _S334 = 0U;
    }
    uint _S335 = words_0._data[uint(fabrics_0._data[uint(_S323)].max_heights_0 + 4U * (_S330 * fabrics_0._data[uint(_S323)].max_height_columns_0 + _S329) + (_S332 + _S334))];
    int number_0;
    if(_S328)
    {
        number_0 = 4;
    }
    else
    {
        number_0 = 0;
    }
    uint _S336 = _S335 >> number_0;
    float _S337 = max(abs(_S331) * fabrics_0._data[uint(_S323)].threads_per_x_0, abs(_S333) * fabrics_0._data[uint(_S323)].threads_per_y_0) / _S327.z;
    float _S338 = fabrics_0._data[uint(_S323)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S323)].height_high_0;
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
        if(((max_height_0 - _S326) * _S337) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S336 >> uint(8 * number_0)) & 15U) * 0.06666667014360428 * _S338);
        }
        number_0 = number_0 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S339, float _S340, float _S341, bool _S342, bool _S343, bool _S344)
{
    Crossing_0 _S345 = crossing_at_0(_S339, _S340, _S341, _S342);
    float _S346 = cell_maximum_0(_S339, _S345);
    float _S347;
    if(_S343)
    {
        _S347 = _S345.warp_1.above_0;
    }
    else
    {
        _S347 = _S345.warp_1.below_0;
    }
    float _S348;
    if(_S344)
    {
        _S348 = _S345.weft_1.above_0;
    }
    else
    {
        _S348 = _S345.weft_1.below_0;
    }
    return vec3(_S346, _S347, _S348);
}

float first_sample_height_0(uint _S349, ViewRay_0 _S350, StepControl_0 _S351, bool _S352)
{
    float _S353 = max_height_along_0(_S349, _S350.origin_0.x, _S350.origin_0.y, 0.0, vec3(_S350.slope_1, 1.0), _S352);
    uint count_4 = 0U;
    float height_7 = _S353;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S354 = ViewRay_at_0(_S350, height_7);
        vec3 _S355 = cell_bounds_0(_S349, _S354.x, _S354.y, _S352, _S351.right_0, _S351.up_0);
        float _S356 = height_7 - _S355.x;
        float _S357 = StepControl_to_cell_exit_0(_S351, _S355.y, _S355.z);
        float height_8 = height_7 - clamp(_S356, 0.0, _S357);
        if(_S356 <= _S357)
        {
            height_7 = height_8;
            break;
        }
        count_4 = count_4 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S358, ViewRay_0 _S359, StepControl_0 _S360, bool _S361)
{
    float _S362 = fabrics_0._data[uint(_S358)].height_low_0 - (fabrics_0._data[uint(_S358)].height_high_0 - fabrics_0._data[uint(_S358)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_6 = first_sample_height_0(_S358, _S359, _S360, _S361);
    end_1.last_step_3 = _S360.epsilon_0;
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
        vec2 _S363 = ViewRay_at_0(_S359, end_1.height_6);
        Probe_0 _S364 = probe_0(_S358, _S363.x, _S363.y, _S361, _S360.right_0, _S360.up_0);
        float _S365 = end_1.height_6 - _S364.height_2;
        float _S366 = ViewRay_rate_0(_S359, _S364);
        end_1.depth_1 = - _S365;
        end_1.rate_4 = _S366;
        bool _S367;
        if(end_1.previous_4.known_0)
        {
            _S367 = !_S364.hole_4;
        }
        else
        {
            _S367 = false;
        }
        bool _S368;
        if(_S367)
        {
            _S368 = (end_1.previous_4.yarn_0) == (_S364.yarn_1);
        }
        else
        {
            _S368 = false;
        }
        end_1.smooth_0 = _S368;
        bool _S369;
        if(!_S364.hole_4)
        {
            _S369 = _S365 <= 0.0;
        }
        else
        {
            _S369 = false;
        }
        bool _S370;
        if(_S369)
        {
            _S370 = true;
        }
        else
        {
            _S370 = (end_1.height_6) <= _S362;
        }
        if(_S370)
        {
            break;
        }
        float _S371 = way_back_to_dip_0(end_1.previous_4, _S365, _S366, end_1.last_step_3, _S364);
        if(_S371 >= 0.0)
        {
            end_1.height_6 = end_1.height_6 + _S371;
            end_1.last_step_3 = end_1.last_step_3 - _S371;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S372 = min(StepControl_to_cell_exit_0(_S360, _S364.side_x_0, _S364.side_y_0), end_1.height_6 - _S364.cell_max_0);
        float _S373 = StepControl_to_next_sample_0(_S360, _S364, _S365, _S366);
        end_1.previous_4 = after_sample_0(_S365, _S366, _S364, _S372 > _S373);
        float _S374 = max(_S372, _S373);
        end_1.last_step_3 = _S374;
        end_1.height_6 = end_1.height_6 - _S374;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S375, ViewRay_0 _S376, StepControl_0 _S377, bool _S378, ViewRayEnd_0 _S379, uint _S380)
{
    float _S381 = fabrics_0._data[uint(_S375)].height_high_0 - fabrics_0._data[uint(_S375)].height_low_0;
    float above_2 = _S379.height_6 + _S379.last_step_3;
    float above_gap_1 = clamp(_S379.previous_4.clearance_0, 0.0, _S381);
    float under_gap_1 = clamp(_S379.depth_1, 0.0, _S381);
    float _S382 = cubic_root_0(above_gap_1, - under_gap_1, _S379.previous_4.rate_0 * _S379.last_step_3, _S379.rate_4 * _S379.last_step_3);
    float middle_0;
    if(_S379.smooth_0)
    {
        middle_0 = above_2 - _S382 * _S379.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S379.height_6, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S379.height_6;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S380)
        {
        }
        else
        {
            break;
        }
        vec2 _S383 = ViewRay_at_0(_S376, middle_0);
        Probe_0 _S384 = probe_0(_S375, _S383.x, _S383.y, _S378, _S377.right_0, _S377.up_0);
        float _S385;
        if(_S384.hole_4)
        {
            _S385 = -1.0e+09;
        }
        else
        {
            _S385 = _S384.height_2;
        }
        float _S386 = clamp(middle_0 - _S385, - _S381, _S381);
        float _S387;
        if(_S386 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S387 = 0.5 * above_gap_2;
            }
            else
            {
                _S387 = above_gap_2;
            }
            float _S388 = - _S386;
            under_1 = middle_0;
            above_gap_2 = _S387;
            under_gap_2 = _S388;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S387 = 0.5 * under_gap_2;
            }
            else
            {
                _S387 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S386;
            under_gap_2 = _S387;
            side_1 = -1.0;
        }
        if(_S379.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S386 / min(ViewRay_rate_0(_S376, _S384), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S379.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S389, SearchQuality_0 _S390, float _S391, float _S392, vec3 _S393, bool _S394)
{
    float _S395 = max(_S393.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_0 = vec2(_S391, _S392);
    vec2 _S396 = _S393.xy / _S395;
    ray_0.slope_1 = _S396;
    StepControl_0 _S397 = step_control_0(- _S396, 1.0 / max(steps_per_length_0(_S389, _S390, _S393) / _S395, 9.99999971718068537e-10));
    ViewRayEnd_0 _S398 = search_down_0(_S389, ray_0, _S397, _S394);
    Hit_0 hit_0;
    hit_0.hole_5 = false;
    float _S399 = refined_height_0(_S389, ray_0, _S397, _S394, _S398, _S390.refinements_0);
    hit_0.height_4 = _S399;
    vec2 _S400 = ViewRay_at_0(ray_0, _S399);
    hit_0.x_11 = _S400.x;
    hit_0.y_5 = _S400.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S401, SearchQuality_0 _S402, float _S403, float _S404, vec3 _S405, bool _S406)
{
    if(!passes_through_0(_S401, _S402, _S403, _S404, _S405, _S406))
    {
        return first_hit_of_yarn_0(_S401, _S402, _S403, _S404, _S405, _S406);
    }
    Hit_0 hit_1;
    hit_1.x_11 = _S403;
    hit_1.y_5 = _S404;
    hit_1.height_4 = 0.0;
    hit_1.hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S407, float _S408, float _S409, bool _S410)
{
    Sample_0 _S411 = sample_at_0(_S407, _S408, _S409, _S410);
    float _S412;
    if(_S411.shown_3.is_warp_2)
    {
        _S412 = _S411.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S412 = _S411.crossing_2.weft_1.half_width_1;
    }
    uint _S413;
    if(_S411.shown_3.is_warp_2)
    {
        _S413 = fabrics_0._data[uint(_S407)].warp_0;
    }
    else
    {
        _S413 = fabrics_0._data[uint(_S407)].weft_0;
    }
    Family_0 _S414 = families_0._data[uint(_S413)];
    float _S415;
    if(_S410)
    {
        _S415 = -1.0;
    }
    else
    {
        _S415 = 1.0;
    }
    float _S416 = _S414.twist_sine_0 * _S415;
    Family_0 _S417 = families_0._data[uint(_S413)];
    if(_S411.shown_3.is_warp_2)
    {
        _S415 = 1.0;
    }
    else
    {
        _S415 = -1.0;
    }
    vec2 _S418 = fibre_direction_0(_S411.slope_across_0, _S415 * _S411.slope_along_0, _S416, _S417.twist_cosine_0);
    float _S419;
    if(_S411.shown_3.is_warp_2)
    {
        _S419 = _S411.slope_x_1;
    }
    else
    {
        _S419 = _S411.slope_y_1;
    }
    float _S420;
    if(_S411.shown_3.is_warp_2)
    {
        _S420 = _S411.slope_y_1;
    }
    else
    {
        _S420 = _S411.slope_x_1;
    }
    float _S421 = _S418.x;
    float _S422 = _S418.y;
    float _S423 = _S419 * _S421 + _S415 * _S420 * _S422;
    float _S424 = _S412 * 1.0154266357421875;
    float _S425 = _S424 * arc_sine_0(clamp(_S411.section_1.across_3 / _S424, -1.0, 1.0));
    if(_S411.shown_3.is_warp_2)
    {
        _S412 = _S409;
    }
    else
    {
        _S412 = - _S408;
    }
    SurfacePoint_0 point_0;
    point_0.hole_0 = _S411.shown_3.hole_3;
    point_0.is_warp_0 = _S411.shown_3.is_warp_2;
    point_0.warp_thread_0 = _S411.crossing_2.warp_1.thread_0;
    point_0.weft_thread_0 = _S411.crossing_2.weft_1.thread_0;
    point_0.height_0 = _S411.height_5;
    point_0.normal_0 = normalize(vec3(- _S411.slope_x_1, - _S411.slope_y_1, 1.0));
    vec3 _S426;
    if(_S411.shown_3.is_warp_2)
    {
        _S426 = vec3(_S421, _S422, _S423);
    }
    else
    {
        _S426 = vec3(- _S422, _S421, _S423);
    }
    point_0.tangent_0 = normalize(_S426);
    point_0.across_0 = _S411.section_1.across_3;
    point_0.fibre_across_0 = _S425 * _S417.twist_cosine_0 + _S412 * _S416;
    point_0.fibre_along_0 = _S412 * _S417.twist_cosine_0 - _S425 * _S416;
    return point_0;
}

struct YarnPoint_0
{
    bool back_4;
    bool hole_6;
    bool is_warp_3;
    float x_12;
    float y_6;
    float height_9;
    vec3 normal_6;
    vec3 tangent_7;
    float roughness_10;
    Albedos_0 albedos_5;
};

Albedos_0 vary_albedos_0(uint _S427, Albedos_0 _S428, uint _S429, uint _S430)
{
    vec3 _S431 = max(_S428.specular_reflect_0, _S428.specular_transmit_0);
    vec3 _S432 = _S428.diffuse_reflect_0 + _S428.diffuse_transmit_0;
    float _S433 = bounded_gain_0(thread_gain_0(_S429, fabrics_0._data[uint(_S427)].colour_noise_0, fabrics_0._data[uint(_S427)].seed_0), _S432, 1.0 - fabrics_0._data[uint(_S427)].layer_bound_0 * _S431);
    float _S434 = bounded_gain_0(fibre_gain_0(_S429, _S430, fabrics_0._data[uint(_S427)].fibre_noise_0, fabrics_0._data[uint(_S427)].seed_0), _S431, min((1.0 - _S433 * _S432) / fabrics_0._data[uint(_S427)].layer_bound_0, vec3(1.0)));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S433 * _S428.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S433 * _S428.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S434 * _S428.specular_reflect_0;
    varied_0.specular_transmit_0 = _S434 * _S428.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S435, SurfacePoint_0 _S436, Albedos_0 _S437, float _S438, float _S439)
{
    float _S440;
    if(_S436.is_warp_0)
    {
        _S440 = _S438;
    }
    else
    {
        _S440 = _S439;
    }
    float _S441 = _S440 - _S436.across_0;
    uint _S442;
    if(_S436.is_warp_0)
    {
        _S442 = fabrics_0._data[uint(_S435)].warp_0;
    }
    else
    {
        _S442 = fabrics_0._data[uint(_S435)].weft_0;
    }
    Family_0 _S443 = families_0._data[uint(_S442)];
    int _S444 = int(families_0._data[uint(_S442)].count_0);
    if(_S436.is_warp_0)
    {
        _S442 = _S436.warp_thread_0;
    }
    else
    {
        _S442 = _S436.weft_thread_0;
    }
    uint _S445 = uint(int(floor(_S441 / _S443.period_0)) * _S444 + int(_S442)) * 2U;
    if(_S436.is_warp_0)
    {
        _S442 = 1U;
    }
    else
    {
        _S442 = 0U;
    }
    float _S446 = floor(_S436.fibre_across_0 / fabrics_0._data[uint(_S435)].fibre_size_0);
    return vary_albedos_0(_S435, _S437, _S445 + _S442, uint(int(_S446)) * 65536U + uint(int(floor(_S436.fibre_along_0 / (fabrics_0._data[uint(_S435)].fibre_size_0 * 40.0) + 0.61799997091293335 * _S446))));
}

YarnPoint_0 yarn_point_of_0(uint _S447, SurfacePoint_0 _S448, float _S449, float _S450, bool _S451, bool _S452)
{
    uint _S453;
    if(_S448.is_warp_0)
    {
        _S453 = fabrics_0._data[uint(_S447)].warp_0;
    }
    else
    {
        _S453 = fabrics_0._data[uint(_S447)].weft_0;
    }
    uint _S454;
    if(_S448.is_warp_0)
    {
        _S454 = _S448.warp_thread_0;
    }
    else
    {
        _S454 = _S448.weft_thread_0;
    }
    Albedos_0 albedos_6 = albedos_of_0(_S453, _S454);
    bool _S455;
    if((fabrics_0._data[uint(_S447)].fibre_noise_0) > 0.0)
    {
        _S455 = true;
    }
    else
    {
        _S455 = (fabrics_0._data[uint(_S447)].colour_noise_0) > 0.0;
    }
    Albedos_0 albedos_7;
    if(_S455)
    {
        albedos_7 = varied_at_0(_S447, _S448, albedos_6, _S449, _S450);
    }
    else
    {
        albedos_7 = albedos_6;
    }
    YarnPoint_0 point_1;
    point_1.back_4 = _S451;
    point_1.hole_6 = _S452;
    point_1.is_warp_3 = _S448.is_warp_0;
    point_1.x_12 = _S449;
    point_1.y_6 = _S450;
    point_1.height_9 = _S448.height_0;
    point_1.normal_6 = _S448.normal_0;
    point_1.tangent_7 = _S448.tangent_0;
    point_1.roughness_10 = families_0._data[uint(_S453)].roughness_0;
    point_1.albedos_5 = albedos_7;
    return point_1;
}

bool unoccluded_0(uint _S456, SearchQuality_0 _S457, float _S458, float _S459, float _S460, vec3 _S461, bool _S462)
{
    if((_S461.z) <= 0.0)
    {
        return false;
    }
    return is_free_0(_S456, _S457, vec3(_S458, _S459, _S460 + fabrics_0._data[uint(_S456)].lift_0), _S461, _S462, max_height_along_0(_S456, _S458, _S459, _S460, _S461, _S462));
}

bool is_lit_0(uint _S463, SearchQuality_0 _S464, YarnPoint_0 _S465, vec3 _S466)
{
    if(_S465.hole_6)
    {
        return true;
    }
    vec3 _S467 = to_face_frame_0(_S466, _S465.back_4);
    float _S468 = _S467.z;
    bool _S469 = _S468 < 0.0;
    vec3 normal_7;
    float height_10;
    if(_S469)
    {
        SurfacePoint_0 _S470 = surface_at_0(_S463, _S465.x_12, _S465.y_6, !_S465.back_4);
        normal_7 = _S470.normal_0;
        height_10 = _S470.height_0;
    }
    else
    {
        normal_7 = _S465.normal_6;
        height_10 = _S465.height_9;
    }
    vec3 _S471 = vec3(_S467.xy, abs(_S468));
    if((dot(normal_7, _S471)) <= 0.0)
    {
        return false;
    }
    return unoccluded_0(_S463, _S464, _S465.x_12, _S465.y_6, height_10, _S471, (_S465.back_4) != _S469);
}

Components_0 components_of_point_0(uint _S472, SearchQuality_0 _S473, YarnPoint_0 _S474, vec3 _S475, vec3 _S476)
{
    Components_0 result_1 = no_components_0();
    float _S477;
    if(_S474.hole_6)
    {
        _S477 = 1.0;
    }
    else
    {
        _S477 = 0.0;
    }
    result_1.hole_2 = _S477;
    bool _S478;
    if(_S474.hole_6)
    {
        _S478 = true;
    }
    else
    {
        _S478 = !is_lit_0(_S472, _S473, _S474, _S475);
    }
    if(_S478)
    {
        return result_1;
    }
    vec3 _S479 = to_face_frame_0(_S475, _S474.back_4);
    vec3 _S480 = to_face_frame_0(_S476, _S474.back_4);
    bool _S481 = (_S479.z) < 0.0;
    vec3 _S482;
    if(_S481)
    {
        _S482 = - _S479;
    }
    else
    {
        _S482 = _S479;
    }
    float _S483 = diffuse_reflection_0(_S482, _S474.normal_6, fabrics_0._data[uint(_S472)].diffuse_blend_0);
    if(_S481)
    {
        _S477 = transmission_0(_S479, _S480, _S474.normal_6, _S474.tangent_7, _S474.roughness_10, fabrics_0._data[uint(_S472)].optical_depth_0);
    }
    else
    {
        _S477 = reflection_0(_S479, _S480, _S474.normal_6, _S474.tangent_7, _S474.roughness_10, fabrics_0._data[uint(_S472)].optical_depth_0);
    }
    float _S484;
    if(_S474.is_warp_3)
    {
        _S484 = _S483;
    }
    else
    {
        _S484 = 0.0;
    }
    result_1.diffuse_warp_0 = _S484;
    if(_S474.is_warp_3)
    {
        _S484 = 0.0;
    }
    else
    {
        _S484 = _S483;
    }
    result_1.diffuse_weft_0 = _S484;
    if(_S474.is_warp_3)
    {
        _S484 = _S477;
    }
    else
    {
        _S484 = 0.0;
    }
    result_1.specular_warp_0 = _S484;
    if(_S474.is_warp_3)
    {
        _S477 = 0.0;
    }
    result_1.specular_weft_0 = _S477;
    result_1.light_visibility_1 = 1.0;
    return result_1;
}

struct CoverageTaps_0
{
    uint  nodes_1[9];
};

vec3 pyramid_level_0(uint _S485, float _S486)
{
    uint _S487 = fabrics_0._data[uint(_S485)].lobes_0.levels_0 + 4U * uint(min(_S486, fabrics_0._data[uint(_S485)].lobes_0.last_level_0));
    return vec3(table_number_0(_S487), table_number_0(_S487 + 1U), table_number_0(_S487 + 2U));
}

CoverageTaps_0 coverage_taps_0(uint _S488, Footprint_0 _S489, bool _S490)
{
    Lobes_0 _S491 = fabrics_0._data[uint(_S488)].lobes_0;
    float _S492 = Footprint_spread_side_0(_S489) * fabrics_0._data[uint(_S488)].lobes_0.inverse_base_size_0;
    vec3 _S493 = pyramid_level_0(_S488, floor(binary_logarithm_0(max(0.68000000715255737 * _S492, 1.0))));
    float _S494 = 1.0 / max(_S492, 9.99999997475242708e-07);
    float _S495 = min(max(sqrt(clamp(1.29999995231628418 * (1.0 - _S494 * _S494), 0.0, 1.0)), 0.3333333432674408 * _S494), 1.0);
    vec2 _S496 = vec2(families_0._data[uint(fabrics_0._data[uint(_S488)].warp_0)].inverse_period_0, families_0._data[uint(fabrics_0._data[uint(_S488)].weft_0)].inverse_period_0);
    vec2 _S497 = _S489.centre_0 * _S496;
    vec2 _S498 = _S489.dx_0 * _S496 * _S495;
    vec2 _S499 = _S489.dy_0 * _S496 * _S495;
    CoverageTaps_0 taps_3;
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < 9U)
        {
        }
        else
        {
            break;
        }
        vec2 _S500 = _S497 + TAP_OFFSETS_0[number_1].x * _S498 + TAP_OFFSETS_0[number_1].y * _S499;
        float _S501 = _S493.y;
        float _S502 = wrapped_cell_0(_S500.x, _S501);
        float _S503 = wrapped_cell_0(_S500.y, _S493.z);
        uint _S504;
        if(_S490)
        {
            _S504 = _S491.face_nodes_0;
        }
        else
        {
            _S504 = 0U;
        }
        taps_3.nodes_1[number_1] = _S504 + uint(_S503 * _S501 + _S502 + _S493.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

vec4 coverage_of_pack_0(uint _S505, CoverageTaps_0 _S506, uint _S507)
{
    uint number_2 = 0U;
    uint even_1 = 0U;
    uint odd_1 = 0U;
    for(;;)
    {
        if(number_2 < 9U)
        {
        }
        else
        {
            break;
        }
        uint _S508 = words_0._data[uint(fabrics_0._data[uint(_S505)].lobes_0.coverage_0 + _S506.nodes_1[number_2] * fabrics_0._data[uint(_S505)].lobes_0.packs_0 + _S507)];
        uint even_2 = even_1 + (_S508 & 16711935U);
        uint odd_2 = odd_1 + ((_S508 >> 8) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / 9.0;
}

float coverage_of_holes_0(uint _S509, CoverageTaps_0 _S510)
{
    uint number_3 = 0U;
    uint total_0 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        uint total_1 = total_0 + (((words_0._data[uint(fabrics_0._data[uint(_S509)].lobes_0.coverage_holes_0 + _S510.nodes_1[number_3] / 4U)]) >> (8U * (_S510.nodes_1[number_3] % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0;
}

float prefiltered_hole_0(uint _S511, CoverageTaps_0 _S512, NodeTaps_0 _S513, bool _S514)
{
    Lobes_0 _S515 = fabrics_0._data[uint(_S511)].lobes_0;
    float _S516 = interpolate_table_0(_S513, fabrics_0._data[uint(_S511)].lobes_0.projected_area_0 + fabrics_0._data[uint(_S511)].lobes_0.packs_0, fabrics_0._data[uint(_S511)].lobes_0.packs_0 + 1U).x;
    float _S517;
    if(_S514)
    {
        _S517 = _S515.back_hole_weight_0;
    }
    else
    {
        _S517 = _S515.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S511, _S512) * _S516 * _S516 * _S517, 1.0);
}

Components_0 prefiltered_components_0(uint _S518, Footprint_0 _S519, vec3 _S520, vec3 _S521, bool _S522)
{
    CoverageTaps_0 _S523 = coverage_taps_0(_S518, _S519, _S522);
    NodeTaps_0 _S524 = node_taps_0(_S521);
    NodeTaps_0 view_nodes_0 = _S524;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S520);
    NodeTaps_0 seen_nodes_0 = _S524;
    uint _S525;
    if(_S522)
    {
        _S525 = 1U;
    }
    else
    {
        _S525 = 0U;
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + _S525 * 256U;
    uint _S526 = 2U * _S525;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + _S526 * 256U;
    uint _S527;
    if((_S520.z) < 0.0)
    {
        _S527 = 1U;
    }
    else
    {
        _S527 = 0U;
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + (_S526 + _S527) * 256U;
    vec3 _S528 = half_vector_0(_S520, _S521);
    vec3 _S529 = shadow_correlation_0(_S520, _S521);
    if(_S522)
    {
        _S527 = fabrics_0._data[uint(_S518)].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S527 = fabrics_0._data[uint(_S518)].lobes_0.front_warp_packs_0;
    }
    Components_0 sums_1;
    sums_1.diffuse_warp_0 = 0.0;
    sums_1.diffuse_weft_0 = 0.0;
    sums_1.specular_warp_0 = 0.0;
    sums_1.specular_weft_0 = 0.0;
    sums_1.light_visibility_1 = 0.0;
    uint pack_0 = 0U;
    float total_2 = 0.0;
    for(;;)
    {
        Lobes_0 _S530 = fabrics_0._data[uint(_S518)].lobes_0;
        if(pack_0 < (fabrics_0._data[uint(_S518)].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        vec4 _S531 = coverage_of_pack_0(_S518, _S523, pack_0);
        vec4 _S532 = interpolate_table_0(view_nodes_0, _S530.projected_area_0 + pack_0, _S530.packs_0 + 1U);
        uint _S533 = _S530.light_visibility_0 + pack_0;
        vec4 _S534 = interpolate_table_0(seen_nodes_0, _S533, _S530.packs_0) / 255.0;
        vec4 _S535 = interpolate_table_0(light_nodes_0, _S533, _S530.packs_0) / 255.0;
        vec4 _S536 = interpolate_table_0(light_nodes_0, _S530.irradiance_0 + pack_0, _S530.packs_0) * 0.00124827399849892;
        bool _S537 = pack_0 < _S527;
        uint _S538;
        if(_S537)
        {
            _S538 = fabrics_0._data[uint(_S518)].warp_0;
        }
        else
        {
            _S538 = fabrics_0._data[uint(_S518)].weft_0;
        }
        Family_0 _S539 = families_0._data[uint(_S538)];
        uint number_4 = 0U;
        float diffuse_0 = 0.0;
        float specular_0 = 0.0;
        for(;;)
        {
            if(number_4 < 4U)
            {
            }
            else
            {
                break;
            }
            Group_0 _S540 = group_at_0(_S530.moments_0 + 12U * (4U * (_S525 * _S530.packs_0 + pack_0) + number_4), _S539.roughness_0);
            float _S541 = _S531[number_4] * _S532[number_4] * _S532[number_4] * _S540.weight_1;
            vec2 _S542 = visibility_gain_0(_S529, _S535[number_4], _S534[number_4]);
            float _S543 = _S542.x;
            float diffuse_1 = diffuse_0 + _S541 * _S536[number_4] * _S543;
            float specular_1 = specular_0 + _S541 * layer_value_0(_S540, _S528, _S520, _S521, fabrics_0._data[uint(_S518)].optical_depth_0) * _S535[number_4] * _S542.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S541 * _S535[number_4] * _S543;
            float total_3 = total_2 + _S541;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S544;
        if(_S537)
        {
            _S544 = diffuse_0;
        }
        else
        {
            _S544 = 0.0;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S544;
        float _S545;
        if(_S537)
        {
            _S545 = 0.0;
        }
        else
        {
            _S545 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S545;
        float _S546;
        if(_S537)
        {
            _S546 = specular_0;
        }
        else
        {
            _S546 = 0.0;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S546;
        float _S547;
        if(_S537)
        {
            _S547 = 0.0;
        }
        else
        {
            _S547 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S547;
        pack_0 = pack_0 + 1U;
    }
    float _S548 = prefiltered_hole_0(_S518, _S523, view_nodes_0, _S522);
    sums_1.hole_2 = _S548;
    float _S549 = (1.0 - _S548) / max(total_2, 9.999999960041972e-13);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S549;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S549;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S549;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S549;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S549;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S550, Footprint_0 _S551, bool _S552)
{
    vec2 _S553 = _S551.dx_0;
    vec2 _S554 = _S551.dy_0;
    vec2 _S555 = sqrt(_S553 * _S553 + _S554 * _S554);
    Stretch_0 _S556 = stretch_of_0(fabrics_0._data[uint(_S550)].warp_0, _S551.centre_0.x, _S555.x);
    Stretch_0 _S557 = stretch_of_0(fabrics_0._data[uint(_S550)].weft_0, _S551.centre_0.y, _S555.y);
    FamilyAlbedos_0 albedos_8;
    albedos_8.warp_2 = mean_albedos_0(fabrics_0._data[uint(_S550)].warp_0, fabrics_0._data[uint(_S550)].weft_0, _S556, _S557, _S552);
    albedos_8.weft_2 = mean_albedos_0(fabrics_0._data[uint(_S550)].weft_0, fabrics_0._data[uint(_S550)].warp_0, _S557, _S556, _S552);
    return albedos_8;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S558, Footprint_0 _S559, float _S560, vec2 _S561, vec3 _S562, vec3 _S563)
{
    float _S564;
    Regime_0 _S565 = regime_of_0(_S558, _S559, _S560);
    bool _S566 = (_S563.z) < 0.0;
    vec3 _S567 = to_face_frame_0(_S563, _S566);
    bool _S568;
    if((fabrics_0._data[uint(_S558)].fibre_noise_0) > 0.0)
    {
        _S568 = true;
    }
    else
    {
        _S568 = (fabrics_0._data[uint(_S558)].colour_noise_0) > 0.0;
    }
    bool _S569;
    if((families_0._data[uint(fabrics_0._data[uint(_S558)].warp_0)].quantities_0) > 1U)
    {
        _S569 = true;
    }
    else
    {
        _S569 = (families_0._data[uint(fabrics_0._data[uint(_S558)].weft_0)].quantities_0) > 1U;
    }
    float _S570 = 1.0 - _S565.prefiltered_0;
    if(_S570 > 0.0)
    {
        if(_S568)
        {
            _S569 = true;
        }
    }
    else
    {
        _S569 = false;
    }
    Footprint_0 box_0 = _S559;
    const vec3 _S571 = vec3(0.0);
    SurfacePoint_0 _S572 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0, _S571, _S571, 0.0, 0.0, 0.0);
    Components_0 _S573 = no_components_0();
    int _S574;
    if(_S569)
    {
        _S574 = 0;
    }
    else
    {
        _S574 = 1;
    }
    uint _S575 = uint(_S574);
    Components_0 points_1 = _S573;
    float central_weight_0 = 0.0;
    SurfacePoint_0 central_0 = _S572;
    vec2 central_place_0 = _S559.centre_0;
    uint number_5 = _S575;
    for(;;)
    {
        float _S576 = float(number_5);
        _S564 = _S565.points_0;
        if(_S576 < (_S565.points_0 + 1.0))
        {
        }
        else
        {
            break;
        }
        bool _S577 = number_5 == 0U;
        uint _S578;
        if(_S577)
        {
            _S578 = 0U;
        }
        else
        {
            _S578 = number_5 - 1U;
        }
        vec2 _S579 = POINT_OFFSETS_0[_S578] + _S561;
        vec2 _S580;
        if(_S577)
        {
            _S580 = vec2(0.0);
        }
        else
        {
            _S580 = _S579 - round(_S579);
        }
        vec2 _S581 = _S559.centre_0 + _S580.x * _S559.dx_0 + _S580.y * _S559.dy_0;
        float _S582;
        if(_S577)
        {
            _S582 = 0.0;
        }
        else
        {
            _S582 = _S565.threads_1;
        }
        SearchQuality_0 _S583 = quality_of_0(_S582);
        Hit_0 _S584 = first_hit_0(_S558, _S583, _S581.x, _S581.y, _S567, _S566);
        SurfacePoint_0 _S585 = surface_at_0(_S558, _S584.x_11, _S584.y_5, _S566);
        if(_S577)
        {
            float central_weight_1;
            if(_S584.hole_5)
            {
                central_weight_1 = 0.0;
            }
            else
            {
                central_weight_1 = _S570;
            }
            vec2 central_place_1 = vec2(_S584.x_11, _S584.y_5);
            box_0.centre_0 = mix(_S559.centre_0, central_place_1, vec2(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S585;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        points_1 = with_added_0(points_1, components_of_point_0(_S558, _S583, yarn_point_of_0(_S558, _S585, _S584.x_11, _S584.y_5, _S566, _S584.hole_5), _S562, _S563), min(_S565.points_0 - float(number_5 - 1U), 1.0));
        number_5 = number_5 + 1U;
    }
    Estimate_0 estimate_0;
    estimate_0.components_0 = with_added_0(_S573, points_1, _S570 / max(_S564, 1.0));
    if((_S565.prefiltered_0) > 0.0)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S558, _S559, to_face_frame_0(_S562, _S566), _S567, _S566), _S565.prefiltered_0);
    }
    estimate_0.albedos_4 = albedos_over_0(_S558, box_0, _S566);
    if(_S568)
    {
        _S568 = central_weight_0 > 0.0;
    }
    else
    {
        _S568 = false;
    }
    if(_S568)
    {
        SurfacePoint_0 _S586 = central_0;
        Albedos_0 _S587;
        if(central_0.is_warp_0)
        {
            _S587 = estimate_0.albedos_4.warp_2;
        }
        else
        {
            _S587 = estimate_0.albedos_4.weft_2;
        }
        Albedos_0 _S588 = lerp_albedos_0(_S587, varied_at_0(_S558, central_0, _S587, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S586.is_warp_0)
        {
            estimate_0.albedos_4.warp_2 = _S588;
        }
        else
        {
            estimate_0.albedos_4.weft_2 = _S588;
        }
    }
    return estimate_0;
}

Estimate_0 lobes_estimate_0(uint _S589, Footprint_0 _S590, float _S591, vec3 _S592, vec3 _S593)
{
    return lobes_estimate_of_pass_0(_S589, _S590, _S591, vec2(0.0), _S592, _S593);
}

vec3 composed_0(uint _S594, Components_0 _S595, FamilyAlbedos_0 _S596, vec3 _S597, vec3 _S598)
{
    vec3 _S599 = _S596.warp_2.diffuse_reflect_0 * _S595.diffuse_warp_0 + _S596.weft_2.diffuse_reflect_0 * _S595.diffuse_weft_0 + _S596.warp_2.specular_reflect_0 * _S595.specular_warp_0 + _S596.weft_2.specular_reflect_0 * _S595.specular_weft_0;
    float _S600 = _S598.z;
    vec3 body_0;
    if((_S597.z * _S600) < 0.0)
    {
        body_0 = _S596.warp_2.diffuse_transmit_0 * _S595.diffuse_warp_0 + _S596.weft_2.diffuse_transmit_0 * _S595.diffuse_weft_0 + _S596.warp_2.specular_transmit_0 * _S595.specular_warp_0 + _S596.weft_2.specular_transmit_0 * _S595.specular_weft_0;
    }
    else
    {
        body_0 = _S599;
    }
    float _S601 = fabrics_0._data[uint(_S594)].sheen_strength_0;
    if((fabrics_0._data[uint(_S594)].sheen_strength_0) <= 0.0)
    {
        return body_0;
    }
    bool _S602 = _S600 < 0.0;
    vec2 _S603 = sheen_with_transmittance_0(to_face_frame_0(_S597, _S602), to_face_frame_0(_S598, _S602), _S601, fabrics_0._data[uint(_S594)].sheen_roughness_0);
    return _S603.y * body_0 + (_S595.light_visibility_1 + _S595.hole_2) * _S603.x;
}

vec4 cloth_value_0(uint fabric_1, vec2 centre_2, vec2 dx_1, vec2 dy_1, vec3 light_9, vec3 view_8)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = centre_2;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    Estimate_0 _S604 = lobes_estimate_0(fabric_1, footprint_0, 1.0, light_9, view_8);
    vec3 _S605 = composed_0(fabric_1, _S604.components_0, _S604.albedos_4, light_9, view_8);
    float through_0;
    if((fabrics_0._data[uint(fabric_1)].sheen_strength_0) > 0.0)
    {
        through_0 = _S604.components_0.hole_2 * (1.0 - fabrics_0._data[uint(fabric_1)].sheen_strength_0 * sheen_lobe_0(abs(view_8.z), fabrics_0._data[uint(fabric_1)].sheen_roughness_0).z);
    }
    else
    {
        through_0 = _S604.components_0.hole_2;
    }
    return vec4(_S605, through_0);
}

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
void main()
{
    if((gl_GlobalInvocationID.x) >= (query_count_0._data[uint(0)]))
    {
        return;
    }
    Query_0 _S606 = queries_0._data[uint(gl_GlobalInvocationID.x)];
    answers_0._data[uint(gl_GlobalInvocationID.x)] = cloth_value_0(_S606.fabric_0, vec2(_S606.centre_x_0, _S606.centre_y_0), vec2(_S606.dx_x_0, _S606.dx_y_0), vec2(_S606.dy_x_0, _S606.dy_y_0), vec3(_S606.light_x_0, _S606.light_y_0, _S606.light_z_0), vec3(_S606.view_x_0, _S606.view_y_0, _S606.view_z_0));
    return;
}

