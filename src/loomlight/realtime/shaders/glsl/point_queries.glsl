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
float saturate_0(float x_0)
{
    return clamp(x_0, 0.0, 1.0);
}

const float  PYRAMID_RADII_0[4] = float[](1.0, 2.0, 4.0, 8.0);
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
    quality_0.steps_per_thread_0 = 5.0;
    quality_0.steps_per_relief_0 = 8.0;
    quality_0.shadow_share_0 = 1.0;
    quality_0.refinements_0 = 2U;
    return quality_0;
}

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

vec3 to_face_frame_0(vec3 direction_0, bool back_2)
{
    vec2 _S3 = direction_0.xy;
    float _S4;
    if(back_2)
    {
        _S4 = - direction_0.z;
    }
    else
    {
        _S4 = direction_0.z;
    }
    return vec3(_S3, _S4);
}

vec2 turns_and_remainder_0(uint family_0, float index_0)
{
    float _S5 = floor(fma(index_0, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S5, fma(- _S5, families_0._data[uint(family_0)].count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S6 = floor(position_0 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S7 = fma(- _S6, families_0._data[uint(family_1)].size_0, position_0);
    cell_0.below_0 = _S7;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S7;
    cell_0.across_0 = _S7 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S6).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
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
    float _S8 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S9;
    if(_S8 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S9 = 1U;
    }
    else
    {
        _S9 = 0U;
    }
    uint _S10 = min(thread_1 + _S9, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S11 = families_0._data[uint(family_2)].place_table_0 + _S10 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S10;
    cell_1.below_0 = _S8 - table_number_0(_S11);
    cell_1.above_0 = table_number_0(_S11 + 1U) - _S8;
    cell_1.across_0 = _S8 - table_number_0(_S11 + 2U);
    cell_1.half_width_1 = table_number_0(_S11 + 3U);
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

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_3)
{
    bool _S12 = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    bool _S13 = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S14;
    if(_S12)
    {
        if(!_S13)
        {
            _S14 = true;
        }
        else
        {
            _S14 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S14 = false;
    }
    shown_0.is_warp_0 = _S14;
    if(!_S12)
    {
        _S14 = !_S13;
    }
    else
    {
        _S14 = false;
    }
    shown_0.hole_0 = _S14;
    uint _S15;
    if(shown_0.is_warp_0)
    {
        _S15 = crossing_0.warp_word_0;
    }
    else
    {
        _S15 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S15;
    shown_0.on_top_0 = ((_S15 & 1U) == 1U) != back_3;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_2;
    uint _S16;
    if(is_first_0)
    {
        _S16 = first_0.thread_0;
    }
    else
    {
        _S16 = second_0.thread_0;
    }
    cell_2.thread_0 = _S16;
    float _S17;
    if(is_first_0)
    {
        _S17 = first_0.across_0;
    }
    else
    {
        _S17 = second_0.across_0;
    }
    cell_2.across_0 = _S17;
    if(is_first_0)
    {
        _S17 = first_0.half_width_1;
    }
    else
    {
        _S17 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S17;
    if(is_first_0)
    {
        _S17 = first_0.below_0;
    }
    else
    {
        _S17 = second_0.below_0;
    }
    cell_2.below_0 = _S17;
    if(is_first_0)
    {
        _S17 = first_0.above_0;
    }
    else
    {
        _S17 = second_0.above_0;
    }
    cell_2.above_0 = _S17;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0)
{
    vec2 _S18 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    return fma(_S18.x, families_0._data[uint(family_4)].period_0, table_number_0(families_0._data[uint(family_4)].place_table_0 + uint(_S18.y) * 4U));
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
    uint _S19 = families_0._data[uint(family_6)].bend_table_0;
    uint _S20;
    if((families_0._data[uint(family_6)].is_alike_0) != 0U)
    {
        _S20 = 0U;
    }
    else
    {
        _S20 = thread_4 * 4U;
    }
    uint _S21 = _S19 + _S20;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S21);
    bend_0.half_tangent_0 = table_number_0(_S21 + 1U);
    bend_0.arc_0 = table_number_0(_S21 + 2U);
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
    int _S22 = int((word_1 >> 1) & 127U);
    int _S23 = int((word_1 >> 8) & 127U);
    int _S24 = int((word_1 >> 15) & 63U);
    int _S25 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S26 = - _S22;
    float _S27 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S26, 0);
    run_0.from_start_0 = _S27;
    int _S28 = _S23 + 1;
    float _S29 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, 1, _S28);
    run_0.to_end_0 = _S29;
    bool _S30 = _S27 < _S29;
    run_0.near_start_0 = _S30;
    int _S31;
    if(_S30)
    {
        _S31 = _S26 - _S24;
    }
    else
    {
        _S31 = _S28;
    }
    int _S32;
    if(run_0.near_start_0)
    {
        _S32 = _S26;
    }
    else
    {
        _S32 = _S28 + _S25;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    float _S33;
    if(run_0.straight_0)
    {
        _S33 = 1.0e+06;
    }
    else
    {
        _S33 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S33;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_0, crossed_0.thread_0, _S31, _S32), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S22 == 0;
    run_0.last_crossing_0 = _S23 == 0;
    return run_0;
}

float square_0(float x_1)
{
    return x_1 * x_1;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_3)
{
    float _S34 = cell_3.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S35 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S35;
    float _S36 = _S34 * _S34 - square_0(_S35);
    float _S37 = (inversesqrt((_S36)));
    section_0.drop_0 = _S34 - _S36 * _S37;
    section_0.slope_0 = - _S35 * _S37;
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
    bool _S38 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S39 = min(crossed_1.below_0, crossed_1.above_0);
    float _S40;
    if(_S38)
    {
        _S40 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S40 = crossed_1.above_0 + crossed_1.across_0;
    }
    float _S41 = _S40 - crossed_1.half_width_1;
    bool _S42;
    if(_S38)
    {
        _S42 = run_1.first_crossing_0;
    }
    else
    {
        _S42 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S40 = 0.0;
    }
    else
    {
        _S40 = families_0._data[uint(other_1)].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, 0);
    }
    float _S43;
    if((shown_1.on_top_0) != _S42)
    {
        _S43 = 0.0;
    }
    else
    {
        float _S44 = families_0._data[uint(other_1)].height_scale_0;
        int _S45;
        if(_S38)
        {
            _S45 = -1;
        }
        else
        {
            _S45 = 1;
        }
        _S43 = _S44 * edge_drop_0(other_1, crossed_1.thread_0, _S45);
    }
    float _S46 = 1.0 / max(2.0 * _S41, 9.999999960041972e-13);
    float _S47 = clamp((_S41 - _S39) * _S46, 0.0, 1.0);
    float _S48 = _S40 + (_S43 - _S40) * (_S47 * _S47 * (3.0 - 2.0 * _S47));
    float _S49 = (_S40 - _S43) * (6.0 * _S47 * (1.0 - _S47) * _S46);
    if(_S38)
    {
        _S40 = 1.0;
    }
    else
    {
        _S40 = -1.0;
    }
    return vec2(_S48, _S49 * _S40);
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
    float _S50 = direction_1.x;
    control_0.per_x_0 = 1.0 / max(abs(_S50), 9.99999971718068537e-10);
    float _S51 = direction_1.y;
    control_0.per_y_0 = 1.0 / max(abs(_S51), 9.99999971718068537e-10);
    control_0.right_0 = _S50 > 0.0;
    control_0.up_0 = _S51 > 0.0;
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
    float _S52;
    if(forwards_0)
    {
        _S52 = cell_4.across_0;
    }
    else
    {
        _S52 = - cell_4.across_0;
    }
    float _S53;
    if(forwards_0)
    {
        _S53 = cell_4.above_0;
    }
    else
    {
        _S53 = cell_4.below_0;
    }
    bool _S54;
    if(forwards_0)
    {
        _S54 = run_2.last_crossing_0;
    }
    else
    {
        _S54 = run_2.first_crossing_0;
    }
    bool _S55;
    if(forwards_0)
    {
        _S55 = run_2.first_crossing_0;
    }
    else
    {
        _S55 = run_2.last_crossing_0;
    }
    float _S56 = - cell_4.half_width_1;
    bool _S57 = _S52 < _S56;
    bool _S58 = _S52 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S54 = !_S54;
    }
    else
    {
        _S54 = false;
    }
    if(_S54)
    {
        _S54 = !shown_2.hole_0;
    }
    else
    {
        _S54 = false;
    }
    bool _S59;
    if(_S54)
    {
        _S59 = shown_2.on_top_0;
    }
    else
    {
        _S59 = false;
    }
    if(_S59)
    {
        if(_S55)
        {
            _S55 = _S57;
        }
        else
        {
            _S55 = false;
        }
        _S55 = !_S55;
    }
    else
    {
        _S55 = false;
    }
    if(shown_2.hole_0)
    {
        _S54 = true;
    }
    else
    {
        if(_S54)
        {
            _S54 = !shown_2.on_top_0;
        }
        else
        {
            _S54 = false;
        }
    }
    float _S60;
    if(_S57)
    {
        _S60 = _S56;
    }
    else
    {
        _S60 = cell_4.half_width_1;
    }
    float _S61 = _S60 - _S52;
    if(_S54)
    {
        _S52 = 2.0 * _S53 + _S52 - cell_4.half_width_1;
    }
    else
    {
        _S52 = _S53;
    }
    if(_S55)
    {
        if(forwards_0)
        {
            _S52 = run_2.to_end_0;
        }
        else
        {
            _S52 = run_2.from_start_0;
        }
        return _S52;
    }
    if(_S58)
    {
    }
    else
    {
        _S52 = _S61;
    }
    return _S52;
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
    float _S62 = previous_1.rate_0 * step_4;
    float _S63 = rate_1 * step_4;
    bool _S64;
    if(!previous_1.known_0)
    {
        _S64 = true;
    }
    else
    {
        _S64 = here_0.hole_1;
    }
    if(_S64)
    {
        _S64 = true;
    }
    else
    {
        _S64 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S64)
    {
        _S64 = true;
    }
    else
    {
        _S64 = (previous_1.rate_0) >= 0.0;
    }
    if(_S64)
    {
        _S64 = true;
    }
    else
    {
        _S64 = rate_1 <= 0.0;
    }
    if(_S64)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S62) >= 0.0)
    {
        _S64 = (3.0 * clearance_1 - _S63) >= 0.0;
    }
    else
    {
        _S64 = false;
    }
    if(_S64)
    {
        return -1.0;
    }
    float _S65 = clearance_1 - previous_1.clearance_0;
    float _S66 = 6.0 * _S65 - 4.0 * _S62 - 2.0 * _S63;
    float _S67 = -2.0 * _S62 / max(_S66 + sqrt(max(_S66 * _S66 - 4.0 * (3.0 * (_S62 + _S63 - 2.0 * _S65)) * _S62, 0.0)), 9.99999968265522539e-21);
    float _S68 = 1.0 - _S67;
    float _S69 = (previous_1.clearance_0 * (2.0 * _S67 + 1.0) + _S62 * _S67) * _S68 * _S68;
    float _S70 = (clearance_1 * (2.0 * _S68 + 1.0) - _S63 * _S68) * _S67 * _S67;
    if(_S67 > 0.01999999955296516)
    {
        _S64 = _S68 > 0.01999999955296516;
    }
    else
    {
        _S64 = false;
    }
    if(_S64)
    {
        _S64 = (_S69 + _S70) < 0.0;
    }
    else
    {
        _S64 = false;
    }
    float _S71;
    if(_S64)
    {
        _S71 = _S68 * step_4;
    }
    else
    {
        _S71 = -1.0;
    }
    return _S71;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S72;
    if(here_1.hole_1)
    {
        _S72 = 1.0e+09;
    }
    else
    {
        _S72 = clearance_2;
    }
    previous_2.clearance_0 = _S72;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S73;
    if(!here_1.hole_1)
    {
        _S73 = !is_cell_exit_0;
    }
    else
    {
        _S73 = false;
    }
    previous_2.known_0 = _S73;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S74 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S75;
    if(!here_2.hole_1)
    {
        _S75 = (rate_3 * _S74 + clearance_3) < 0.0;
    }
    else
    {
        _S75 = false;
    }
    if(_S75)
    {
        _S75 = _S74 > (2.0 * this_2.epsilon_0);
    }
    else
    {
        _S75 = false;
    }
    float _S76;
    if(_S75)
    {
        _S76 = _S74 - this_2.epsilon_0;
    }
    else
    {
        _S76 = max(_S74, 0.0) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S76);
}

struct ViewRay_0
{
    vec2 origin_0;
    vec2 slope_1;
};

vec2 ViewRay_at_0(ViewRay_0 this_3, float height_2)
{
    return this_3.origin_0 + this_3.slope_1 * height_2;
}

float ViewRay_rate_0(ViewRay_0 this_4, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S77 = end_0 - start_1;
    float _S78 = start_rate_0 + end_rate_0 - 2.0 * _S77;
    float _S79 = 3.0 * _S77 - 2.0 * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S77, 9.99999968265522539e-21);
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
        float _S80 = clamp(share_0 - (((_S78 * share_0 + _S79) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0 * _S78 * share_0 + 2.0 * _S79) * share_0 + start_rate_0, 0.10000000149011612 * _S77 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S81 = i_0 + 1;
        share_0 = _S80;
        i_0 = _S81;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

vec2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S82 = along_slope_0 * along_slope_0 + 1.0;
    float _S83 = (inversesqrt((_S82)));
    float _S84 = sine_1 * _S83 * (inversesqrt((_S82 + across_slope_0 * across_slope_0)));
    return vec2(- _S84 * _S82, _S84 * across_slope_0 * along_slope_0 + cosine_0 * _S83);
}

float arc_sine_0(float x_2)
{
    float _S85 = abs(x_2);
    bool _S86 = _S85 > 0.5;
    float _S87;
    if(_S86)
    {
        _S87 = 0.5 * (1.0 - _S85);
    }
    else
    {
        _S87 = _S85 * _S85;
    }
    float _S88;
    if(_S86)
    {
        _S88 = sqrt(max(_S87, 0.0));
    }
    else
    {
        _S88 = _S85;
    }
    float _S89 = ((((0.04216320067644119 * _S87 + 0.02418131195008755) * _S87 + 0.04547002539038658) * _S87 + 0.07495300471782684) * _S87 + 0.16666752099990845) * _S87 * _S88 + _S88;
    if(_S86)
    {
        _S87 = 1.57079637050628662 - 2.0 * _S89;
    }
    else
    {
        _S87 = _S89;
    }
    if(x_2 < 0.0)
    {
        _S87 = - _S87;
    }
    return _S87;
}

struct Hair_0
{
    float cover_0;
    vec3 normal_0;
    vec3 tangent_0;
};

Hair_0 Hair_x24init_0(float cover_1, vec3 normal_1, vec3 tangent_1)
{
    Hair_0 _S90;
    _S90.cover_0 = cover_1;
    _S90.normal_0 = normal_1;
    _S90.tangent_0 = tangent_1;
    return _S90;
}

float fade_0(float size_1, float period_1)
{
    return clamp((1.0 - size_1 / period_1) * 1.33333337306976318, 0.0, 1.0);
}

uint scramble_0(uint value_0)
{
    uint _S91 = value_0 * 747796405U + 2891336453U;
    uint _S92 = ((_S91 >> ((_S91 >> 28) + 4U)) ^ _S91) * 277803737U;
    return (_S92 >> 22) ^ _S92;
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

vec2 sine_cosine_0(float x_3)
{
    float _S93 = floor(x_3 * 0.63661974668502808 + 0.5);
    float _S94 = x_3 - _S93 * 1.5703125 - _S93 * 0.00048375129699707 - _S93 * 7.54979012640433211e-08;
    float _S95 = _S94 * _S94;
    float _S96 = ((-0.00019515295571182 * _S95 + 0.00833216123282909) * _S95 - 0.16666655242443085) * _S95 * _S94 + _S94;
    float _S97 = ((0.00002443315679557 * _S95 - 0.00138873164542019) * _S95 + 0.04166664555668831) * _S95 * _S95 - 0.5 * _S95 + 1.0;
    uint _S98 = uint(int(_S93)) & 3U;
    vec2 _S99;
    if((_S98 & 1U) != 0U)
    {
        _S99 = vec2(_S97, _S96);
    }
    else
    {
        _S99 = vec2(_S96, _S97);
    }
    float _S100;
    if((_S98 & 2U) != 0U)
    {
        _S100 = - _S99.x;
    }
    else
    {
        _S100 = _S99.x;
    }
    float _S101;
    if(((_S98 + 1U) & 2U) != 0U)
    {
        _S101 = - _S99.y;
    }
    else
    {
        _S101 = _S99.y;
    }
    return vec2(_S100, _S101);
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

vec3 fibre_cell_0(float across_2, float along_0, float width_1)
{
    float _S102 = floor(across_2 / width_1);
    return vec3(_S102, along_0 / (width_1 * 40.0) + 0.61799997091293335 * _S102, 2.0 * (across_2 / width_1 - _S102) - 1.0);
}

struct SurfacePoint_0
{
    bool hole_2;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_3;
    vec3 normal_2;
    vec3 tangent_2;
    float across_3;
    float fibre_across_0;
    float fibre_along_0;
};

float ply_offset_0(uint family_9, SurfacePoint_0 point_0, bool back_4)
{
    float _S103;
    if(back_4)
    {
        _S103 = - families_0._data[uint(family_9)].ply_sine_0;
    }
    else
    {
        _S103 = families_0._data[uint(family_9)].ply_sine_0;
    }
    float _S104 = (point_0.fibre_across_0 * families_0._data[uint(family_9)].ply_cosine_0 + point_0.fibre_along_0 * _S103) * families_0._data[uint(family_9)].plies_per_mm_0;
    return 2.0 * (_S104 - floor(_S104)) - 1.0;
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
    float _S105 = floor(position_3);
    float _S106 = position_3 - _S105;
    uint _S107 = uint(int(_S105));
    float _S108 = signed_noise_0(hash_bits_0(key_1, _S107));
    float _S109 = signed_noise_0(hash_bits_0(key_1, _S107 + 1U));
    return vec2(mix(_S108, _S109, smooth_share_0(_S106)), 6.0 * _S106 * (1.0 - _S106) * (_S109 - _S108));
}

vec2 cell_noise_0(uint key_2, vec3 cell_6)
{
    float _S110 = cell_6.y;
    float _S111 = floor(_S110);
    uint _S112 = uint(int(cell_6.x)) * 65536U + uint(int(_S111));
    uint _S113 = hash_bits_0(key_2, _S112);
    uint _S114 = hash_bits_0(key_2, _S112 + 1U);
    return mix(vec2(signed_noise_0(_S113), signed_noise_0(_S113 >> 16)), vec2(signed_noise_0(_S114), signed_noise_0(_S114 >> 16)), vec2(smooth_share_0(_S110 - _S111)));
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
    vec3 _S115 = room_0 / max(albedo_1, vec3(9.99999997475242708e-07));
    return min(gain_0, max(min(min(_S115.x, _S115.y), _S115.z), 0.0));
}

float flattened_0(float largest_0, vec3 albedo_2, vec3 room_1)
{
    vec3 _S116 = room_1 / max(albedo_2, vec3(9.99999997475242708e-07)) - 1.0;
    return min(max(min(min(_S116.x, _S116.y), _S116.z), 0.0) / max(largest_0, 9.99999997475242708e-07), 1.0);
}

float natural_logarithm_0(float x_4)
{
    uint _S117 = floatBitsToUint(x_4);
    float exponent_0 = float(int(_S117 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S117 & 8388607U) | 1056964608U);
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
    float _S118 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S118 - exponent_1 * 0.00021219444170129 - 0.5 * _S118) + exponent_1 * 0.693359375;
}

float fibre_gain_0(uint thread_11, uint cell_8, float amount_1, uint seed_3)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, seed_3 ^ 2654435769U)), 10.0) - 1.0) + 1.0;
}

struct YarnFrame_0
{
    vec3 normal_3;
    vec3 tangent_3;
    float loss_0;
};

YarnFrame_0 under_hair_0(YarnFrame_0 frame_0, Hair_0 hair_0)
{
    vec3 _S119;
    if((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0)
    {
        _S119 = - hair_0.tangent_0;
    }
    else
    {
        _S119 = hair_0.tangent_0;
    }
    YarnFrame_0 blended_0;
    vec3 _S120 = vec3(hair_0.cover_0);
    vec3 _S121 = normalize(mix(frame_0.normal_3, hair_0.normal_0, _S120));
    blended_0.normal_3 = _S121;
    vec3 _S122 = mix(frame_0.tangent_3, _S119, _S120);
    vec3 _S123 = _S122 - dot(_S122, _S121) * _S121;
    blended_0.tangent_3 = _S123 * (inversesqrt((max(dot(_S123, _S123), 9.999999960041972e-13))));
    blended_0.loss_0 = frame_0.loss_0 * (1.0 - hair_0.cover_0);
    return blended_0;
}

float diffuse_gain_0(YarnFrame_0 frame_1, float blend_0)
{
    return min(0.85000002384185791 * blend_0 * frame_1.loss_0 + 1.0, 1.0 / (0.5 * blend_0 * (frame_1.normal_3.z - 1.0) + 1.0));
}

struct FaceRadiance_0
{
    vec3 warp_2;
    vec3 weft_2;
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
    vec3 _S124 = (1.0 - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    vec3 _S125 = sends_0.sky_warp_0 + _S124 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S125;
    vec3 _S126 = sends_0.sky_weft_0 + _S124 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S126;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S125 + sends_0.blocks_weft_0 * _S126;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

struct Bounced_0
{
    vec3 reflected_0;
    vec3 transmitted_0;
};

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

struct Scattered_0
{
    vec3 back_5;
    vec3 through_0;
};

struct Interior_0
{
    vec3 warp_3;
    vec3 weft_3;
    vec3 leaked_1;
    vec3 far_1;
    vec3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_0, Scattered_0 yarn_2, Interior_0 interior_0)
{
    vec3 _S127 = (blocked_0.by_warp_0 + blocked_0.by_weft_0) * interior_0.leaked_1;
    vec3 _S128 = blocked_0.far_0 * yarn_2.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (blocked_0.by_warp_0 * interior_0.warp_3 + blocked_0.by_weft_0 * interior_0.weft_3) + _S128 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S128 * interior_0.far_1 + yarn_2.back_5 * _S127;
    return bounced_0;
}

float diffuse_reflection_0(vec3 light_1, vec3 normal_4, float blend_1)
{
    float _S129 = light_1.z;
    if(_S129 <= 0.0)
    {
        return 0.0;
    }
    return 0.31830987334251404 * mix(max(_S129, 0.0), max(dot(light_1, normal_4), 0.0), blend_1);
}

float projected_area_1(vec3 direction_2, vec3 tangent_4, float roughness_1)
{
    float _S130 = dot(direction_2, tangent_4);
    return sqrt(max((roughness_1 + 1.0) * (roughness_1 - 1.0) * _S130 * _S130 + 1.0, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S131 = clamp(x_5, -87.0, 88.0);
    float _S132 = floor(_S131 * 1.4426950216293335 + 0.5);
    float _S133 = _S131 - _S132 * 0.693359375 + _S132 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S133 + 0.00139819993637502) * _S133 + 0.00833345204591751) * _S133 + 0.04166579619050026) * _S133 + 0.1666666567325592) * _S133 + 0.5;
    float _S134 = uintBitsToFloat(uint(int(_S132) + 127) << 23);
    float _S135;
    if(x_5 < -87.0)
    {
        _S135 = 0.0;
    }
    else
    {
        _S135 = (p_0 * _S133 * _S133 + _S133 + 1.0) * _S134;
    }
    return _S135;
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
    float _S136 = roughness_2 * roughness_2;
    float _S137 = squared_along_0 * (1.0 - _S136) + _S136;
    return 0.31830987334251404 * _S136 * roughness_2 / (_S137 * _S137);
}

float density_between_0(vec3 light_2, vec3 view_1, vec3 tangent_5, float roughness_3)
{
    vec3 _S138 = light_2 + view_1;
    float _S139 = dot(_S138, tangent_5);
    return flake_density_0(min(_S139 * _S139 / max(square_1(_S138), 9.999999960041972e-13), 1.0), roughness_3);
}

float reflection_0(vec3 light_3, vec3 view_2, vec3 normal_5, vec3 tangent_6, float roughness_4, float optical_depth_1)
{
    float _S140 = dot(light_3, normal_5);
    bool _S141;
    if(_S140 <= 0.0)
    {
        _S141 = true;
    }
    else
    {
        _S141 = (dot(view_2, normal_5)) <= 0.0;
    }
    if(_S141)
    {
        return 0.0;
    }
    float _S142 = max(_S140, 9.99999997475242708e-07);
    float _S143 = max(dot(view_2, normal_5), 9.99999997475242708e-07);
    float _S144 = projected_area_1(light_3, tangent_6, roughness_4) * _S143 + projected_area_1(view_2, tangent_6, roughness_4) * _S142;
    float _S145 = optical_depth_1 * _S144 / (_S142 * _S143);
    return 0.25 * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S145 * mean_attenuation_0(_S145)) * _S142 / _S144;
}

float transmission_1(vec3 light_4, vec3 view_3, vec3 normal_6, vec3 tangent_7, float roughness_5, float optical_depth_2)
{
    float _S146 = - dot(light_4, normal_6);
    float _S147 = dot(view_3, normal_6);
    bool _S148;
    if(_S146 <= 0.0)
    {
        _S148 = true;
    }
    else
    {
        _S148 = _S147 <= 0.0;
    }
    if(_S148)
    {
        return 0.0;
    }
    float _S149 = 1.0 / max(_S147, 9.99999997475242708e-07);
    float _S150 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S146, 9.99999997475242708e-07);
    float _S151 = projected_area_1(view_3, tangent_7, roughness_5) * _S149;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25 * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S150, _S151)) * mean_attenuation_0(optical_depth_2 * abs(_S150 - _S151)) * _S149;
}

float sheen_scale_0(float x_6, float y_0)
{
    return (((((0.0 * x_6 + (((((-1.1402510404586792 * y_0 + 0.40672621130943298) * y_0 + 1.65398800373077393) * y_0 + -1.29730904102325439) * y_0 + 0.30570998787879944) * y_0 + -0.0220868494361639)) * x_6 + (((((-0.21142719686031342 * y_0 + 1.05947399139404297) * y_0 + -0.41116121411323547) * y_0 + -0.93859231472015381) * y_0 + 0.51606941223144531) * y_0 + 0.05409301072359085)) * x_6 + (((((1.22944498062133789 * y_0 + -0.45962560176849365) * y_0 + -1.63861405849456787) * y_0 + 1.33565104007720947) * y_0 + -0.45725581049919128) * y_0 + 0.08243165910243988)) * x_6 + (((((0.39779931306838989 * y_0 + -1.18879103660583496) * y_0 + 0.28251591324806213) * y_0 + 1.168984055519104) * y_0 + -0.76864629983901978) * y_0 + 0.0091691892594099)) * x_6 + (((((-0.26563560962677002 * y_0 + -0.19379159808158875) * y_0 + 0.2677634060382843) * y_0 + 0.00270519289188087) * y_0 + 0.14349560439586639) * y_0 + 0.10290180146694183)) * x_6 + (((((-0.20701569318771362 * y_0 + 0.24526430666446686) * y_0 + 0.19551840424537659) * y_0 + 0.07586126774549484) * y_0 + 0.38894739747047424) * y_0 + 0.15043120086193085);
}

float sheen_shear_0(float x_7, float y_1)
{
    return ((((0.0 * x_7 + (((((-0.10608240216970444 * y_1 + 1.99214303493499756) * y_1 + -1.42255294322967529) * y_1 + -1.09495604038238525) * y_1 + 0.59180057048797607) * y_1 + 0.06902855634689331)) * x_7 + (((((-0.46220690011978149 * y_1 + -0.29113379120826721) * y_1 + 1.39025199413299561) * y_1 + 0.35589990019798279) * y_1 + -1.17120099067687988) * y_1 + 0.15940259397029877)) * x_7 + (((((2.26068711280822754 * y_1 + -3.64728999137878418) * y_1 + -0.72173482179641724) * y_1 + 3.07659196853637695) * y_1 + -0.6827620267868042) * y_1 + -0.3039557933807373)) * x_7 + (((((0.81201767921447754 * y_1 + 0.36014080047607422) * y_1 + -1.72646903991699219) * y_1 + -0.22630110383033752) * y_1 + 0.89514690637588501) * y_1 + -0.10397960245609283)) * x_7 + (((((-0.37648698687553406 * y_1 + 1.10974001884460449) * y_1 + 0.17824520170688629) * y_1 + -1.04968702793121338) * y_1 + 0.1461234986782074) * y_1 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_8, float y_2)
{
    return ((((0.0 * x_8 + (((((12.95646953582763672 * y_2 + -21.38032913208007812) * y_2 + -7.37853097915649414) * y_2 + 34.55607986450195312) * y_2 + -23.61347007751464844) * y_2 + 5.00126314163208008)) * x_8 + (((((10.91487026214599609 * y_2 + -6.08202791213989258) * y_2 + -38.2036285400390625) * y_2 + 53.3440399169921875) * y_2 + -21.91996002197265625) * y_2 + 2.01606011390686035)) * x_8 + (((((-14.52206039428710938 * y_2 + 36.803619384765625) * y_2 + -22.94047927856445312) * y_2 + -10.07973003387451172) * y_2 + 15.77003955841064453) * y_2 + -4.92722177505493164)) * x_8 + (((((-7.62505722045898438 * y_2 + 1.27310299873352051) * y_2 + 31.19523048400878906) * y_2 + -44.39989852905273438) * y_2 + 26.44947052001953125) * y_2 + -8.73507976531982422)) * x_8 + (((((5.65633487701416016 * y_2 + -17.66820907592773438) * y_2 + 24.65356063842773438) * y_2 + -19.38941001892089844) * y_2 + 11.06159019470214844) * y_2 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S152 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S153 = 2.0 * sqrt(_S152) - 1.0;
    float _S154 = 3.0 * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S153, _S154), 0.00999999977648258, 1.0), clamp((1.0 - _S152) * sheen_shear_0(_S153, _S154), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S153, _S154), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_5, vec3 view_4, float scale_0, float shear_0)
{
    float _S155 = light_5.z;
    bool _S156;
    if(_S155 <= 0.0)
    {
        _S156 = true;
    }
    else
    {
        _S156 = (view_4.z) <= 0.0;
    }
    if(_S156)
    {
        return 0.0;
    }
    vec2 _S157 = view_4.xy;
    float _S158 = dot(_S157, _S157);
    vec2 _S159;
    if(_S158 > 9.99999968265522539e-21)
    {
        _S159 = _S157 * (inversesqrt((_S158)));
    }
    else
    {
        _S159 = vec2(1.0, 0.0);
    }
    float _S160 = scale_0 * dot(light_5.xy, _S159) + shear_0 * _S155;
    float _S161 = scale_0 * (light_5.y * _S159.x - light_5.x * _S159.y);
    float _S162 = _S160 * _S160 + _S161 * _S161 + _S155 * _S155;
    return 0.31830987334251404 * scale_0 * scale_0 * _S155 / max(_S162 * _S162, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_6, vec3 view_5, float strength_0, float roughness_7)
{
    vec3 _S163 = sheen_lobe_0(view_5.z, roughness_7);
    float _S164 = strength_0 * _S163.z;
    return vec2(_S164 * transformed_cosine_0(light_6, view_5, _S163.x, _S163.y), 1.0 - _S164);
}

vec3 bounced_value_0(Bounced_0 bounced_1, vec3 light_7, vec3 view_6)
{
    float _S165 = light_7.z;
    vec3 _S166;
    if((_S165 * view_6.z) < 0.0)
    {
        _S166 = bounced_1.transmitted_0;
    }
    else
    {
        _S166 = bounced_1.reflected_0;
    }
    return _S166 * (abs(_S165) * 0.31830987334251404);
}

struct YarnPoint_0
{
    bool back_6;
    bool hole_3;
    bool is_warp_2;
    float x_9;
    float y_3;
    float height_4;
    vec3 normal_7;
    vec3 tangent_8;
    vec3 surface_normal_0;
    float diffuse_gain_1;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_10;
    float y_4;
    bool hole_4;
    float height_5;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_6;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S167, float _S168, float _S169, bool _S170)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0._data[uint(_S167)].warp_0, _S168);
    crossing_2.weft_1 = locate_0(fabrics_0._data[uint(_S167)].weft_0, _S169);
    uint _S171 = fabrics_0._data[uint(_S167)].run_words_0 + 2U * (crossing_2.weft_1.thread_0 * fabrics_0._data[uint(_S167)].ends_1 + crossing_2.warp_1.thread_0);
    uint _S172 = words_0._data[uint(_S171)];
    crossing_2.warp_word_0 = _S172;
    crossing_2.weft_word_0 = words_0._data[uint(_S171 + 1U)];
    crossing_2.warp_above_0 = ((_S172 & 1U) == 1U) != _S170;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S173, float _S174, float _S175, bool _S176)
{
    Sample_0 sample_0;
    Crossing_0 _S177 = crossing_at_0(_S173, _S174, _S175, _S176);
    sample_0.crossing_1 = _S177;
    Shown_0 _S178 = shown_at_0(_S177, _S176);
    sample_0.shown_3 = _S178;
    uint _S179;
    if(_S178.is_warp_0)
    {
        _S179 = fabrics_0._data[uint(_S173)].warp_0;
    }
    else
    {
        _S179 = fabrics_0._data[uint(_S173)].weft_0;
    }
    uint _S180;
    if(_S178.is_warp_0)
    {
        _S180 = fabrics_0._data[uint(_S173)].weft_0;
    }
    else
    {
        _S180 = fabrics_0._data[uint(_S173)].warp_0;
    }
    Cell_0 _S181 = select_cell_0(_S178.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    Cell_0 _S182 = select_cell_0(_S178.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    Run_0 _S183 = unpack_0(_S179, _S180, _S181.thread_0, _S182, _S178.word_0);
    Section_0 _S184 = section_at_0(_S181);
    bool _S185;
    if(_S178.on_top_0)
    {
        _S185 = (_S183.distance_0) < (_S184.drop_0 * _S183.bend_1.sine_0);
    }
    else
    {
        _S185 = false;
    }
    bool _S186;
    if(_S178.on_top_0)
    {
        _S186 = !_S185;
    }
    else
    {
        _S186 = false;
    }
    float _S187;
    if(_S186)
    {
        _S187 = 1.0;
    }
    else
    {
        _S187 = -1.0;
    }
    float _S188;
    if(_S185)
    {
        _S188 = _S183.other_reach_0;
    }
    else
    {
        _S188 = _S183.reach_0;
    }
    float _S189;
    if(_S185)
    {
        _S189 = _S188 + _S183.distance_0;
    }
    else
    {
        _S189 = max(_S188 - _S183.distance_0, 0.0);
    }
    float _S190 = _S188 / _S183.bend_1.sine_0 - _S187 * _S184.drop_0;
    float _S191 = _S189 * _S189;
    float _S192 = max(_S190 * _S190 - _S191, 9.99999968265522539e-21);
    float _S193 = (inversesqrt((_S192)));
    float _S194 = _S191 / (_S192 * _S193 + _S190);
    bool _S195 = _S189 > 0.0;
    float _S196;
    if(_S178.on_top_0)
    {
        _S196 = 1.0;
    }
    else
    {
        _S196 = -1.0;
    }
    float _S197;
    if(_S183.near_start_0)
    {
        _S197 = 1.0;
    }
    else
    {
        _S197 = -1.0;
    }
    float _S198 = _S196 * _S197;
    if(_S195)
    {
        _S196 = _S190 * _S193;
    }
    else
    {
        _S196 = 1.0;
    }
    sample_0.slope_across_0 = _S184.slope_0 * _S196;
    if(_S195)
    {
        _S189 = _S198 * _S189 * _S193;
    }
    else
    {
        _S189 = 0.0;
    }
    sample_0.slope_along_0 = _S189;
    float _S199 = families_0._data[uint(_S179)].height_scale_0;
    vec2 _S200 = dive_0(_S180, _S178, _S183, _S182);
    if(_S183.straight_0)
    {
        _S187 = 0.0;
    }
    else
    {
        _S187 = _S199 * _S187;
    }
    sample_0.height_6 = _S187 * (_S188 * _S183.bend_1.half_tangent_0 - _S194) - _S199 * _S184.drop_0 - _S200.x;
    float _S201 = _S199 * sample_0.slope_across_0;
    float _S202 = _S199 * sample_0.slope_along_0 - _S200.y;
    if(_S178.is_warp_0)
    {
        _S187 = _S201;
    }
    else
    {
        _S187 = _S202;
    }
    sample_0.slope_x_1 = _S187;
    if(_S178.is_warp_0)
    {
        _S187 = _S202;
    }
    else
    {
        _S187 = _S201;
    }
    sample_0.slope_y_1 = _S187;
    sample_0.run_3 = _S183;
    sample_0.section_1 = _S184;
    return sample_0;
}

float steps_per_length_0(uint _S203, SearchQuality_0 _S204, vec3 _S205)
{
    return max(max(abs(_S205.x) * fabrics_0._data[uint(_S203)].threads_per_x_0, abs(_S205.y) * fabrics_0._data[uint(_S203)].threads_per_y_0) * _S204.steps_per_thread_0, abs(_S205.z) * fabrics_0._data[uint(_S203)].per_relief_0 * _S204.steps_per_relief_0);
}

float cell_maximum_0(uint _S206, Crossing_0 _S207)
{
    uint _S208;
    if(_S207.warp_above_0)
    {
        _S208 = fabrics_0._data[uint(_S206)].warp_0;
    }
    else
    {
        _S208 = fabrics_0._data[uint(_S206)].weft_0;
    }
    uint _S209;
    if(_S207.warp_above_0)
    {
        _S209 = _S207.warp_word_0;
    }
    else
    {
        _S209 = _S207.weft_word_0;
    }
    return float(_S209 >> 28) * families_0._data[uint(_S208)].height_scale_0 * families_0._data[uint(_S208)].level_0;
}

Probe_0 probe_0(uint _S210, float _S211, float _S212, bool _S213, bool _S214, bool _S215)
{
    Sample_0 _S216 = sample_at_0(_S210, _S211, _S212, _S213);
    Probe_0 probe_1;
    probe_1.height_1 = _S216.height_6;
    probe_1.hole_1 = _S216.shown_3.hole_0;
    probe_1.slope_x_0 = _S216.slope_x_1;
    probe_1.slope_y_0 = _S216.slope_y_1;
    uint _S217;
    if(_S216.shown_3.is_warp_0)
    {
        _S217 = _S216.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S217 = _S216.crossing_1.weft_1.thread_0 * 2U;
    }
    probe_1.yarn_1 = _S217;
    probe_1.cell_max_0 = cell_maximum_0(_S210, _S216.crossing_1);
    float _S218;
    if(_S214)
    {
        _S218 = _S216.crossing_1.warp_1.above_0;
    }
    else
    {
        _S218 = _S216.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S218;
    if(_S215)
    {
        _S218 = _S216.crossing_1.weft_1.above_0;
    }
    else
    {
        _S218 = _S216.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S218;
    probe_1.edge_x_0 = outline_distance_0(_S216.crossing_1.warp_1, _S216.shown_3, _S216.run_3, !_S216.shown_3.is_warp_0, _S214);
    probe_1.edge_y_0 = outline_distance_0(_S216.crossing_1.weft_1, _S216.shown_3, _S216.run_3, _S216.shown_3.is_warp_0, _S215);
    return probe_1;
}

bool is_free_0(uint _S219, SearchQuality_0 _S220, vec3 _S221, vec3 _S222, bool _S223, float _S224)
{
    float _S225 = _S222.z;
    if(_S225 <= 0.0)
    {
        return false;
    }
    float _S226 = 1.0 / max(_S220.shadow_share_0 * steps_per_length_0(_S219, _S220, _S222), 9.99999971718068537e-10);
    StepControl_0 _S227 = step_control_0(_S222.xy, _S226);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S228;
        if(count_1 < 1024U)
        {
            _S228 = (_S221.z + _S225 * distance_1) < _S224;
        }
        else
        {
            _S228 = false;
        }
        if(_S228)
        {
        }
        else
        {
            break;
        }
        vec3 _S229 = _S221 + _S222 * distance_1;
        Probe_0 _S230 = probe_0(_S219, _S229.x, _S229.y, _S223, _S227.right_0, _S227.up_0);
        float _S231 = _S229.z;
        float _S232 = _S231 - _S230.height_1;
        float _S233 = _S225 - _S230.slope_x_0 * _S222.x - _S230.slope_y_0 * _S222.y;
        bool _S234;
        if(!_S230.hole_1)
        {
            _S234 = _S232 < 0.0;
        }
        else
        {
            _S234 = false;
        }
        if(_S234)
        {
            return false;
        }
        float _S235 = way_back_to_dip_0(previous_3, _S232, _S233, last_step_0, _S230);
        if(_S235 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S235;
            distance_1 = distance_1 - _S235;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S236 = _S231 > (_S230.cell_max_0);
        PreviousSample_0 _S237 = after_sample_0(_S232, _S233, _S230, _S236);
        float last_step_2;
        if(_S236)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S227, _S230.side_x_0, _S230.side_y_0), _S226);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S227, _S230, _S232, _S233);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S237;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S238, SearchQuality_0 _S239, float _S240, float _S241, vec3 _S242, bool _S243)
{
    if(!sample_at_0(_S238, _S240, _S241, _S243).shown_3.hole_0)
    {
        return false;
    }
    vec3 _S244 = vec3(_S240, _S241, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S245;
        if(side_0 < 2U)
        {
            _S245 = passes_0;
        }
        else
        {
            _S245 = false;
        }
        if(_S245)
        {
        }
        else
        {
            break;
        }
        vec3 _S246;
        if(side_0 == 0U)
        {
            _S246 = _S242;
        }
        else
        {
            _S246 = vec3(- _S242.x, - _S242.y, _S242.z);
        }
        bool _S247 = is_free_0(_S238, _S239, _S244, _S246, _S243 != (side_0 == 1U), fabrics_0._data[uint(_S238)].height_high_0);
        uint _S248 = side_0 + 1U;
        passes_0 = _S247;
        side_0 = _S248;
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

float max_height_along_0(uint _S249, float _S250, float _S251, float _S252, vec3 _S253, bool _S254)
{
    uint _S255 = locate_0(fabrics_0._data[uint(_S249)].warp_0, _S250).thread_0 / 2U;
    uint _S256 = locate_0(fabrics_0._data[uint(_S249)].weft_0, _S251).thread_0 / 2U;
    float _S257 = _S253.x;
    uint _S258;
    if(_S257 > 0.0)
    {
        _S258 = 1U;
    }
    else
    {
        _S258 = 0U;
    }
    float _S259 = _S253.y;
    uint _S260;
    if(_S259 > 0.0)
    {
        _S260 = 2U;
    }
    else
    {
        _S260 = 0U;
    }
    uint _S261 = words_0._data[uint(fabrics_0._data[uint(_S249)].max_heights_0 + 4U * (_S256 * fabrics_0._data[uint(_S249)].max_height_columns_0 + _S255) + (_S258 + _S260))];
    int number_0;
    if(_S254)
    {
        number_0 = 4;
    }
    else
    {
        number_0 = 0;
    }
    uint _S262 = _S261 >> number_0;
    float _S263 = max(abs(_S257) * fabrics_0._data[uint(_S249)].threads_per_x_0, abs(_S259) * fabrics_0._data[uint(_S249)].threads_per_y_0) / _S253.z;
    float _S264 = fabrics_0._data[uint(_S249)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S249)].height_high_0;
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
        if(((max_height_0 - _S252) * _S263) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S262 >> uint(8 * number_0)) & 15U) * 0.06666667014360428 * _S264);
        }
        number_0 = number_0 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S265, float _S266, float _S267, bool _S268, bool _S269, bool _S270)
{
    Crossing_0 _S271 = crossing_at_0(_S265, _S266, _S267, _S268);
    float _S272 = cell_maximum_0(_S265, _S271);
    float _S273;
    if(_S269)
    {
        _S273 = _S271.warp_1.above_0;
    }
    else
    {
        _S273 = _S271.warp_1.below_0;
    }
    float _S274;
    if(_S270)
    {
        _S274 = _S271.weft_1.above_0;
    }
    else
    {
        _S274 = _S271.weft_1.below_0;
    }
    return vec3(_S272, _S273, _S274);
}

float first_sample_height_0(uint _S275, ViewRay_0 _S276, StepControl_0 _S277, bool _S278)
{
    float _S279 = max_height_along_0(_S275, _S276.origin_0.x, _S276.origin_0.y, 0.0, vec3(_S276.slope_1, 1.0), _S278);
    uint count_2 = 0U;
    float height_8 = _S279;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S280 = ViewRay_at_0(_S276, height_8);
        vec3 _S281 = cell_bounds_0(_S275, _S280.x, _S280.y, _S278, _S277.right_0, _S277.up_0);
        float _S282 = height_8 - _S281.x;
        float _S283 = StepControl_to_cell_exit_0(_S277, _S281.y, _S281.z);
        float height_9 = height_8 - clamp(_S282, 0.0, _S283);
        if(_S282 <= _S283)
        {
            height_8 = height_9;
            break;
        }
        count_2 = count_2 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S284, ViewRay_0 _S285, StepControl_0 _S286, bool _S287)
{
    float _S288 = fabrics_0._data[uint(_S284)].height_low_0 - (fabrics_0._data[uint(_S284)].height_high_0 - fabrics_0._data[uint(_S284)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_7 = first_sample_height_0(_S284, _S285, _S286, _S287);
    end_1.last_step_3 = _S286.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0;
    end_1.rate_4 = 0.0;
    end_1.smooth_0 = false;
    uint count_3 = 0U;
    for(;;)
    {
        if(count_3 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S289 = ViewRay_at_0(_S285, end_1.height_7);
        Probe_0 _S290 = probe_0(_S284, _S289.x, _S289.y, _S287, _S286.right_0, _S286.up_0);
        float _S291 = end_1.height_7 - _S290.height_1;
        float _S292 = ViewRay_rate_0(_S285, _S290);
        end_1.depth_1 = - _S291;
        end_1.rate_4 = _S292;
        bool _S293;
        if(end_1.previous_4.known_0)
        {
            _S293 = !_S290.hole_1;
        }
        else
        {
            _S293 = false;
        }
        bool _S294;
        if(_S293)
        {
            _S294 = (end_1.previous_4.yarn_0) == (_S290.yarn_1);
        }
        else
        {
            _S294 = false;
        }
        end_1.smooth_0 = _S294;
        bool _S295;
        if(!_S290.hole_1)
        {
            _S295 = _S291 <= 0.0;
        }
        else
        {
            _S295 = false;
        }
        bool _S296;
        if(_S295)
        {
            _S296 = true;
        }
        else
        {
            _S296 = (end_1.height_7) <= _S288;
        }
        if(_S296)
        {
            break;
        }
        float _S297 = way_back_to_dip_0(end_1.previous_4, _S291, _S292, end_1.last_step_3, _S290);
        if(_S297 >= 0.0)
        {
            end_1.height_7 = end_1.height_7 + _S297;
            end_1.last_step_3 = end_1.last_step_3 - _S297;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S298 = min(StepControl_to_cell_exit_0(_S286, _S290.side_x_0, _S290.side_y_0), end_1.height_7 - _S290.cell_max_0);
        float _S299 = StepControl_to_next_sample_0(_S286, _S290, _S291, _S292);
        end_1.previous_4 = after_sample_0(_S291, _S292, _S290, _S298 > _S299);
        float _S300 = max(_S298, _S299);
        end_1.last_step_3 = _S300;
        end_1.height_7 = end_1.height_7 - _S300;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S301, ViewRay_0 _S302, StepControl_0 _S303, bool _S304, ViewRayEnd_0 _S305, uint _S306)
{
    float _S307 = fabrics_0._data[uint(_S301)].height_high_0 - fabrics_0._data[uint(_S301)].height_low_0;
    float above_2 = _S305.height_7 + _S305.last_step_3;
    float above_gap_1 = clamp(_S305.previous_4.clearance_0, 0.0, _S307);
    float under_gap_1 = clamp(_S305.depth_1, 0.0, _S307);
    float _S308 = cubic_root_0(above_gap_1, - under_gap_1, _S305.previous_4.rate_0 * _S305.last_step_3, _S305.rate_4 * _S305.last_step_3);
    float middle_0;
    if(_S305.smooth_0)
    {
        middle_0 = above_2 - _S308 * _S305.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S305.height_7, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S305.height_7;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S306)
        {
        }
        else
        {
            break;
        }
        vec2 _S309 = ViewRay_at_0(_S302, middle_0);
        Probe_0 _S310 = probe_0(_S301, _S309.x, _S309.y, _S304, _S303.right_0, _S303.up_0);
        float _S311;
        if(_S310.hole_1)
        {
            _S311 = -1.0e+09;
        }
        else
        {
            _S311 = _S310.height_1;
        }
        float _S312 = clamp(middle_0 - _S311, - _S307, _S307);
        float _S313;
        if(_S312 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S313 = 0.5 * above_gap_2;
            }
            else
            {
                _S313 = above_gap_2;
            }
            float _S314 = - _S312;
            under_1 = middle_0;
            above_gap_2 = _S313;
            under_gap_2 = _S314;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S313 = 0.5 * under_gap_2;
            }
            else
            {
                _S313 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S312;
            under_gap_2 = _S313;
            side_1 = -1.0;
        }
        if(_S305.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S312 / min(ViewRay_rate_0(_S302, _S310), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S305.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S315, SearchQuality_0 _S316, float _S317, float _S318, vec3 _S319, bool _S320)
{
    float _S321 = max(_S319.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_0 = vec2(_S317, _S318);
    vec2 _S322 = _S319.xy / _S321;
    ray_0.slope_1 = _S322;
    StepControl_0 _S323 = step_control_0(- _S322, 1.0 / max(steps_per_length_0(_S315, _S316, _S319) / _S321, 9.99999971718068537e-10));
    ViewRayEnd_0 _S324 = search_down_0(_S315, ray_0, _S323, _S320);
    Hit_0 hit_0;
    hit_0.hole_4 = false;
    float _S325 = refined_height_0(_S315, ray_0, _S323, _S320, _S324, _S316.refinements_0);
    hit_0.height_5 = _S325;
    vec2 _S326 = ViewRay_at_0(ray_0, _S325);
    hit_0.x_10 = _S326.x;
    hit_0.y_4 = _S326.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S327, SearchQuality_0 _S328, float _S329, float _S330, vec3 _S331, bool _S332)
{
    if(!passes_through_0(_S327, _S328, _S329, _S330, _S331, _S332))
    {
        return first_hit_of_yarn_0(_S327, _S328, _S329, _S330, _S331, _S332);
    }
    Hit_0 hit_1;
    hit_1.x_10 = _S329;
    hit_1.y_4 = _S330;
    hit_1.height_5 = 0.0;
    hit_1.hole_4 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S333, float _S334, float _S335, bool _S336)
{
    Sample_0 _S337 = sample_at_0(_S333, _S334, _S335, _S336);
    float _S338;
    if(_S337.shown_3.is_warp_0)
    {
        _S338 = _S337.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S338 = _S337.crossing_1.weft_1.half_width_1;
    }
    uint _S339;
    if(_S337.shown_3.is_warp_0)
    {
        _S339 = fabrics_0._data[uint(_S333)].warp_0;
    }
    else
    {
        _S339 = fabrics_0._data[uint(_S333)].weft_0;
    }
    float _S340 = families_0._data[uint(_S339)].twist_sine_0;
    float _S341;
    if(_S336)
    {
        _S341 = -1.0;
    }
    else
    {
        _S341 = 1.0;
    }
    float _S342 = _S340 * _S341;
    float _S343 = families_0._data[uint(_S339)].twist_cosine_0;
    if(_S337.shown_3.is_warp_0)
    {
        _S341 = 1.0;
    }
    else
    {
        _S341 = -1.0;
    }
    vec2 _S344 = fibre_direction_0(_S337.slope_across_0, _S341 * _S337.slope_along_0, _S342, _S343);
    float _S345;
    if(_S337.shown_3.is_warp_0)
    {
        _S345 = _S337.slope_x_1;
    }
    else
    {
        _S345 = _S337.slope_y_1;
    }
    float _S346;
    if(_S337.shown_3.is_warp_0)
    {
        _S346 = _S337.slope_y_1;
    }
    else
    {
        _S346 = _S337.slope_x_1;
    }
    float _S347 = _S344.x;
    float _S348 = _S344.y;
    float _S349 = _S345 * _S347 + _S341 * _S346 * _S348;
    float _S350 = _S338 * 1.0154266357421875;
    float _S351 = _S350 * arc_sine_0(clamp(_S337.section_1.across_1 / _S350, -1.0, 1.0));
    if(_S337.shown_3.is_warp_0)
    {
        _S338 = _S335;
    }
    else
    {
        _S338 = - _S334;
    }
    SurfacePoint_0 point_1;
    point_1.hole_2 = _S337.shown_3.hole_0;
    point_1.is_warp_1 = _S337.shown_3.is_warp_0;
    point_1.warp_thread_0 = _S337.crossing_1.warp_1.thread_0;
    point_1.weft_thread_0 = _S337.crossing_1.weft_1.thread_0;
    point_1.height_3 = _S337.height_6;
    point_1.normal_2 = normalize(vec3(- _S337.slope_x_1, - _S337.slope_y_1, 1.0));
    vec3 _S352;
    if(_S337.shown_3.is_warp_0)
    {
        _S352 = vec3(_S347, _S348, _S349);
    }
    else
    {
        _S352 = vec3(- _S348, _S347, _S349);
    }
    point_1.tangent_2 = normalize(_S352);
    point_1.across_3 = _S337.section_1.across_1;
    point_1.fibre_across_0 = _S351 * _S343 + _S338 * _S342;
    point_1.fibre_along_0 = _S338 * _S343 - _S351 * _S342;
    return point_1;
}

bool has_hairs_0(uint _S353)
{
    bool _S354;
    if((families_0._data[uint(fabrics_0._data[uint(_S353)].warp_0)].hairiness_0) > 0.0)
    {
        _S354 = true;
    }
    else
    {
        _S354 = (families_0._data[uint(fabrics_0._data[uint(_S353)].weft_0)].hairiness_0) > 0.0;
    }
    return _S354;
}

Hair_0 hair_at_0(uint _S355, vec2 _S356, bool _S357, float _S358)
{
    float _S359 = fabrics_0._data[uint(_S355)].fibre_size_0;
    float _S360 = 17.0 * fabrics_0._data[uint(_S355)].fibre_size_0;
    float _S361 = fade_0(_S358, _S360);
    vec2 _S362 = _S356 / _S360;
    uint number_1;
    if(_S357)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S363 = hash_key_0(number_1, (fabrics_0._data[uint(_S355)].seed_1) ^ 1013904242U);
    float _S364 = 1.0 / max(_S358, 0.07999999821186066 * _S359);
    float _S365 = min(0.63999998569488525 * _S359 * _S364, 1.0);
    const vec2 _S366 = vec2(0.0, 1.0);
    float cover_2 = 0.0;
    float hair_away_0 = 0.0;
    vec2 hair_across_0 = _S366;
    number_1 = 0U;
    for(;;)
    {
        bool _S367;
        if(_S361 > 0.0)
        {
            _S367 = number_1 < 18U;
        }
        else
        {
            _S367 = false;
        }
        if(_S367)
        {
        }
        else
        {
            break;
        }
        uint _S368 = number_1 / 9U;
        uint _S369 = number_1 / 3U - 3U * _S368;
        vec2 _S370 = floor(_S362) + vec2(float(number_1 - 3U * _S369 - 9U * _S368), float(_S369)) - 1.0;
        uint _S371 = hash_bits_0(_S363 + _S368, uint(int(_S370.x)) * 65536U + uint(int(_S370.y)));
        uint _S372 = hash_bits_0(_S363, _S371);
        vec2 _S373 = _S362 - _S370 - vec2(share_of_0(_S371), share_of_0(_S371 >> 10));
        vec2 _S374 = sine_cosine_0(3.14159274101257324 * share_of_0(_S371 >> 20));
        float _S375 = mix(5.0, 16.0, share_of_0(_S372 >> 10)) / 17.0;
        float _S376 = _S373.x;
        float _S377 = _S374.y;
        float _S378 = _S373.y;
        float _S379 = _S374.x;
        float _S380 = (_S376 * _S377 + _S378 * _S379) / _S375;
        float _S381 = 0.69999998807907104 * (2.0 * share_of_0(_S372 >> 20) - 1.0);
        float _S382 = 2.0 * _S381 * _S380;
        float _S383 = (inversesqrt((_S382 * _S382 + 1.0)));
        float _S384 = (_S378 * _S377 - _S376 * _S379 - _S381 * _S375 * _S380 * _S380) * _S383 * 17.0;
        float _S385 = clamp((0.31999999284744263 - abs(_S384)) * _S359 * _S364 + 0.5, 0.0, _S365);
        uint _S386;
        if(((_S372 >> 30) & 1U) == 1U)
        {
            _S386 = fabrics_0._data[uint(_S355)].warp_0;
        }
        else
        {
            _S386 = fabrics_0._data[uint(_S355)].weft_0;
        }
        bool _S387;
        if((share_of_0(_S372)) < (families_0._data[uint(_S386)].hairiness_0))
        {
            _S387 = (abs(_S380)) < 1.0;
        }
        else
        {
            _S387 = false;
        }
        bool _S388;
        if(_S387)
        {
            _S388 = _S385 > cover_2;
        }
        else
        {
            _S388 = false;
        }
        if(_S388)
        {
            vec2 _S389 = vec2(- _S379 - _S382 * _S377, _S377 - _S382 * _S379) * _S383;
            cover_2 = _S385;
            hair_away_0 = _S384;
            hair_across_0 = _S389;
        }
        number_1 = number_1 + 1U;
    }
    float _S390 = clamp(hair_away_0 * 2.5, -0.80000001192092896, 0.80000001192092896);
    Hair_0 hair_1;
    hair_1.cover_0 = _S361 * cover_2;
    hair_1.normal_0 = vec3(_S390 * hair_across_0, sqrt(1.0 - _S390 * _S390));
    hair_1.tangent_0 = vec3(hair_across_0.y, - hair_across_0.x, 0.0);
    return hair_1;
}

bool varies_at_0(uint _S391, float _S392)
{
    bool _S393;
    if((fabrics_0._data[uint(_S391)].fibre_noise_0) > 0.0)
    {
        _S393 = true;
    }
    else
    {
        _S393 = (fabrics_0._data[uint(_S391)].colour_noise_0) > 0.0;
    }
    if(_S393)
    {
        _S393 = true;
    }
    else
    {
        if((fabrics_0._data[uint(_S391)].has_detail_0) != 0U)
        {
            _S393 = _S392 >= 0.0;
        }
        else
        {
            _S393 = false;
        }
    }
    return _S393;
}

uint thread_number_0(uint _S394, SurfacePoint_0 _S395, float _S396, float _S397)
{
    float _S398;
    if(_S395.is_warp_1)
    {
        _S398 = _S396;
    }
    else
    {
        _S398 = _S397;
    }
    float _S399 = _S398 - _S395.across_3;
    uint _S400;
    if(_S395.is_warp_1)
    {
        _S400 = fabrics_0._data[uint(_S394)].warp_0;
    }
    else
    {
        _S400 = fabrics_0._data[uint(_S394)].weft_0;
    }
    float _S401 = families_0._data[uint(_S400)].period_0;
    int _S402 = int(families_0._data[uint(_S400)].count_0);
    if(_S395.is_warp_1)
    {
        _S400 = _S395.warp_thread_0;
    }
    else
    {
        _S400 = _S395.weft_thread_0;
    }
    uint _S403 = uint(int(floor(_S399 / _S401)) * _S402 + int(_S400)) * 2U;
    if(_S395.is_warp_1)
    {
        _S400 = 1U;
    }
    else
    {
        _S400 = 0U;
    }
    return _S403 + _S400;
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

FibreNoise_0 fibre_noise_at_0(uint _S404, uint _S405, SurfacePoint_0 _S406, uint _S407, float _S408)
{
    float _S409 = 5.0 * fabrics_0._data[uint(_S404)].fibre_size_0;
    vec2 _S410 = wave_noise_0(hash_key_0(_S407, (fabrics_0._data[uint(_S404)].seed_1) ^ 458671337U), _S406.fibre_along_0 / (25.0 * fabrics_0._data[uint(_S404)].fibre_size_0));
    float _S411 = _S406.fibre_across_0 + families_0._data[uint(_S405)].fibre_tilt_0 * 0.5 * 25.0 * fabrics_0._data[uint(_S404)].fibre_size_0 * _S410.x;
    vec3 _S412 = fibre_cell_0(_S411, _S406.fibre_along_0, fabrics_0._data[uint(_S404)].fibre_size_0);
    FibreNoise_0 noise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S407, (fabrics_0._data[uint(_S404)].seed_1) ^ 1757159915U), fibre_cell_0(_S411, _S406.fibre_along_0, _S409));
    noise_0.bundle_weight_0 = fade_0(_S408, _S409);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S407, (fabrics_0._data[uint(_S404)].seed_1) ^ 48610963U), _S412);
    noise_0.fibre_weight_0 = fade_0(_S408, fabrics_0._data[uint(_S404)].fibre_size_0);
    noise_0.offset_2 = _S412.z;
    noise_0.slope_2 = 0.5 * _S410.y;
    return noise_0;
}

vec2 detail_gain_0(uint _S413, uint _S414, SurfacePoint_0 _S415, vec2 _S416, bool _S417, uint _S418, float _S419)
{
    const vec2 _S420 = vec2(0.0);
    vec2 gain_1;
    if((families_0._data[uint(_S414)].has_plies_0) > 0.0)
    {
        gain_1 = 0.60000002384185791 * fade_0(_S419, 1.0 / families_0._data[uint(_S414)].plies_per_mm_0) * vec2(0.20000000298023224 - square_0(square_0(ply_offset_0(_S414, _S415, _S417))), 0.20000000298023224);
    }
    else
    {
        gain_1 = _S420;
    }
    if((families_0._data[uint(_S414)].fibre_tone_0) > 0.0)
    {
        FibreNoise_0 _S421 = fibre_noise_at_0(_S413, _S414, _S415, _S418, _S419);
        gain_1 = gain_1 + families_0._data[uint(_S414)].fibre_tone_0 * vec2(_S421.bundle_weight_0 * _S421.bundle_0.y + _S421.fibre_weight_0 * _S421.fibre_0.y, _S421.bundle_weight_0 + _S421.fibre_weight_0);
    }
    if((families_0._data[uint(_S414)].slub_0) > 0.0)
    {
        float _S422 = 0.25 * families_0._data[uint(_S414)].slub_0 * fade_0(_S419, 1.0 / families_0._data[uint(_S414)].slubs_per_mm_0);
        float _S423;
        if(_S415.is_warp_1)
        {
            _S423 = _S416.y;
        }
        else
        {
            _S423 = - _S416.x;
        }
        gain_1 = gain_1 + _S422 * vec2(wave_noise_0(hash_key_0(_S418, (fabrics_0._data[uint(_S413)].seed_1) ^ 1373058189U), _S423 * families_0._data[uint(_S414)].slubs_per_mm_0).x * mix(0.40000000596046448, 1.0, min(square_0(_S415.across_3 * families_0._data[uint(_S414)].per_half_width_0), 1.0)), 1.0);
    }
    return gain_1;
}

Albedos_0 vary_albedos_0(uint _S424, Albedos_0 _S425, uint _S426, uint _S427, vec2 _S428)
{
    vec3 _S429 = max(_S425.specular_reflect_0, _S425.specular_transmit_0);
    vec3 _S430 = _S425.diffuse_reflect_0 + _S425.diffuse_transmit_0;
    vec3 _S431 = 1.0 - fabrics_0._data[uint(_S424)].layer_bound_0 * _S429;
    float colour_0 = bounded_gain_0(thread_gain_0(_S426, fabrics_0._data[uint(_S424)].colour_noise_0, fabrics_0._data[uint(_S424)].seed_1), _S430, _S431);
    float colour_1 = colour_0 * (1.0 + flattened_0(_S428.y, colour_0 * _S430, _S431) * _S428.x);
    float _S432 = bounded_gain_0(fibre_gain_0(_S426, _S427, fabrics_0._data[uint(_S424)].fibre_noise_0, fabrics_0._data[uint(_S424)].seed_1), _S429, min((1.0 - colour_1 * _S430) / fabrics_0._data[uint(_S424)].layer_bound_0, vec3(1.0)));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = colour_1 * _S425.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = colour_1 * _S425.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S432 * _S425.specular_reflect_0;
    varied_0.specular_transmit_0 = _S432 * _S425.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S433, SurfacePoint_0 _S434, Albedos_0 _S435, float _S436, float _S437, bool _S438, float _S439, float _S440)
{
    uint _S441 = thread_number_0(_S433, _S434, _S436, _S437);
    vec3 _S442 = fibre_cell_0(_S434.fibre_across_0, _S434.fibre_along_0, fabrics_0._data[uint(_S433)].fibre_size_0);
    const vec2 _S443 = vec2(0.0);
    bool _S444;
    if((fabrics_0._data[uint(_S433)].has_detail_0) != 0U)
    {
        _S444 = _S439 >= 0.0;
    }
    else
    {
        _S444 = false;
    }
    vec2 gain_2;
    if(_S444)
    {
        uint _S445;
        if(_S434.is_warp_1)
        {
            _S445 = fabrics_0._data[uint(_S433)].warp_0;
        }
        else
        {
            _S445 = fabrics_0._data[uint(_S433)].weft_0;
        }
        gain_2 = detail_gain_0(_S433, _S445, _S434, vec2(_S436, _S437), _S438, _S441, _S439) * vec2(1.0 - _S440, 1.0);
    }
    else
    {
        gain_2 = _S443;
    }
    return vary_albedos_0(_S433, _S435, _S441, uint(int(_S442.x)) * 65536U + uint(int(floor(_S442.y))), gain_2);
}

YarnFrame_0 turned_frame_0(uint _S446, uint _S447, SurfacePoint_0 _S448, bool _S449, uint _S450, float _S451)
{
    YarnFrame_0 frame_2;
    frame_2.normal_3 = _S448.normal_2;
    frame_2.tangent_3 = _S448.tangent_2;
    frame_2.loss_0 = 0.0;
    if((families_0._data[uint(_S447)].has_plies_0) > 0.0)
    {
        float _S452 = fade_0(_S451, 1.0 / families_0._data[uint(_S447)].plies_per_mm_0);
        float _S453 = _S452 * 0.41999998688697815 * ply_offset_0(_S447, _S448, _S449);
        float _S454 = sqrt(1.0 - _S453 * _S453);
        float _S455;
        if(_S449)
        {
            _S455 = - families_0._data[uint(_S447)].ply_sine_0;
        }
        else
        {
            _S455 = families_0._data[uint(_S447)].ply_sine_0;
        }
        vec3 _S456 = cross(frame_2.tangent_3, frame_2.normal_3);
        vec3 _S457 = families_0._data[uint(_S447)].ply_cosine_0 * _S456 + _S455 * frame_2.tangent_3;
        frame_2.tangent_3 = families_0._data[uint(_S447)].ply_cosine_0 * (families_0._data[uint(_S447)].ply_cosine_0 * frame_2.tangent_3 - _S455 * _S456) + _S455 * (_S454 * _S457 - _S453 * frame_2.normal_3);
        frame_2.normal_3 = _S454 * frame_2.normal_3 + _S453 * _S457;
        frame_2.loss_0 = _S452 * _S452 * 0.41999998688697815 * 0.41999998688697815 / 6.0;
    }
    float _S458 = families_0._data[uint(_S447)].fibre_tilt_0;
    if((families_0._data[uint(_S447)].fibre_tilt_0) > 0.0)
    {
        FibreNoise_0 _S459 = fibre_noise_at_0(_S446, _S447, _S448, _S450, _S451);
        float _S460 = 1.09858846664428711 * _S458 * (_S459.bundle_weight_0 * _S459.bundle_0.x + _S459.fibre_weight_0 * (_S459.fibre_0.x + _S459.offset_2));
        float _S461 = _S458 * (1.42099642753601074 * (_S459.bundle_weight_0 * _S459.bundle_0.y + _S459.fibre_weight_0 * _S459.fibre_0.y) - _S459.bundle_weight_0 * _S459.slope_2);
        float _S462 = square_0(_S459.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5 * _S458 * _S458 * ((0.24761904776096344 * (square_0(_S459.bundle_weight_0) + _S462) + _S462 / 3.0) * 1.09858846664428711 * 1.09858846664428711);
        vec3 _S463 = cross(frame_2.tangent_3, frame_2.normal_3);
        vec2 _S464 = sine_cosine_0(_S460);
        vec2 _S465 = sine_cosine_0(_S461);
        float _S466 = _S464.y;
        float _S467 = _S464.x;
        vec3 _S468 = _S466 * _S463 - _S467 * frame_2.normal_3;
        frame_2.normal_3 = _S466 * frame_2.normal_3 + _S467 * _S463;
        frame_2.tangent_3 = _S465.y * frame_2.tangent_3 + _S465.x * _S468;
    }
    return frame_2;
}

YarnPoint_0 yarn_point_of_0(uint _S469, SurfacePoint_0 _S470, float _S471, float _S472, bool _S473, bool _S474, float _S475)
{
    uint _S476;
    if(_S470.is_warp_1)
    {
        _S476 = fabrics_0._data[uint(_S469)].warp_0;
    }
    else
    {
        _S476 = fabrics_0._data[uint(_S469)].weft_0;
    }
    bool _S477;
    if((fabrics_0._data[uint(_S469)].has_detail_0) != 0U)
    {
        _S477 = _S475 >= 0.0;
    }
    else
    {
        _S477 = false;
    }
    const vec3 _S478 = vec3(0.0);
    Hair_0 _S479 = Hair_x24init_0(0.0, _S478, _S478);
    bool _S480;
    if(_S477)
    {
        _S480 = has_hairs_0(_S469);
    }
    else
    {
        _S480 = false;
    }
    Hair_0 hair_2;
    if(_S480)
    {
        hair_2 = hair_at_0(_S469, vec2(_S471, _S472), _S473, _S475);
    }
    else
    {
        hair_2 = _S479;
    }
    uint _S481;
    if(_S470.is_warp_1)
    {
        _S481 = _S470.warp_thread_0;
    }
    else
    {
        _S481 = _S470.weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S476, _S481);
    Albedos_0 albedos_3;
    if(varies_at_0(_S469, _S475))
    {
        albedos_3 = varied_at_0(_S469, _S470, albedos_2, _S471, _S472, _S473, _S475, hair_2.cover_0);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_2;
    point_2.back_6 = _S473;
    point_2.hole_3 = _S474;
    point_2.is_warp_2 = _S470.is_warp_1;
    point_2.x_9 = _S471;
    point_2.y_3 = _S472;
    point_2.height_4 = _S470.height_3;
    point_2.normal_7 = _S470.normal_2;
    point_2.tangent_8 = _S470.tangent_2;
    point_2.surface_normal_0 = _S470.normal_2;
    point_2.diffuse_gain_1 = 1.0;
    if(_S477)
    {
        YarnFrame_0 _S482 = turned_frame_0(_S469, _S476, _S470, _S473, thread_number_0(_S469, _S470, _S471, _S472), _S475);
        YarnFrame_0 frame_3;
        if(has_hairs_0(_S469))
        {
            frame_3 = under_hair_0(_S482, hair_2);
        }
        else
        {
            frame_3 = _S482;
        }
        point_2.normal_7 = frame_3.normal_3;
        point_2.tangent_8 = frame_3.tangent_3;
        point_2.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0._data[uint(_S469)].diffuse_blend_0);
    }
    point_2.roughness_8 = families_0._data[uint(_S476)].roughness_0;
    point_2.albedos_1 = albedos_3;
    return point_2;
}

YarnPoint_0 locate_yarn_0(uint _S483, SearchQuality_0 _S484, float _S485, float _S486, vec3 _S487, float _S488)
{
    bool _S489 = (_S487.z) < 0.0;
    Hit_0 _S490 = first_hit_0(_S483, _S484, _S485, _S486, to_face_frame_0(_S487, _S489), _S489);
    return yarn_point_of_0(_S483, surface_at_0(_S483, _S490.x_10, _S490.y_4, _S489), _S490.x_10, _S490.y_4, _S489, _S490.hole_4, _S488);
}

float openness_number_0(uint _S491, uint _S492)
{
    return table_number_0(fabrics_0._data[uint(_S491)].openness_0 + _S492);
}

Blocked_0 blocked_of_terms_0(uint _S493, uint _S494, float  _S495[6], uint _S496)
{
    float  shares_0[3];
    uint share_2 = 0U;
    for(;;)
    {
        if(share_2 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_2] = 0.0;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S496)
            {
            }
            else
            {
                break;
            }
            shares_0[share_2] = shares_0[share_2] + openness_number_0(_S493, _S494 + share_2 * _S496 + term_0) * _S495[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_2] = saturate_0(shares_0[share_2]);
        share_2 = share_2 + 1U;
    }
    Blocked_0 blocked_1;
    blocked_1.by_warp_0 = shares_0[0] * shares_0[2];
    blocked_1.by_weft_0 = shares_0[0] * (1.0 - shares_0[2]);
    blocked_1.far_0 = shares_0[1];
    return blocked_1;
}

Blocked_0 blocked_at_0(uint _S497, bool _S498, bool _S499, float _S500, float _S501)
{
    float _S502 = _S501 * openness_number_0(_S497, 158U);
    float  terms_0[6] = float[](1.0, _S500, _S502, _S500 * _S500, _S500 * _S502, _S502 * _S502);
    uint _S503;
    if(_S499)
    {
        _S503 = 2U;
    }
    else
    {
        _S503 = 0U;
    }
    uint _S504;
    if(_S498)
    {
        _S504 = 0U;
    }
    else
    {
        _S504 = 1U;
    }
    return blocked_of_terms_0(_S497, 60U + (_S503 + _S504) * 18U, terms_0, 6U);
}

Scattered_0 scattered_by_0(uint _S505, Albedos_0 _S506, uint _S507, vec3 _S508)
{
    uint _S509 = 159U + 2U * _S507;
    Scattered_0 yarn_3;
    yarn_3.back_5 = _S508 * _S506.diffuse_reflect_0 + openness_number_0(_S505, _S509) * _S506.specular_reflect_0;
    yarn_3.through_0 = _S508 * _S506.diffuse_transmit_0 + openness_number_0(_S505, _S509 + 1U) * _S506.specular_transmit_0;
    return yarn_3;
}

void sent_0(uint _S510, uint _S511, vec3 _S512, vec3 _S513, vec3 _S514, vec3 _S515, out vec3 _S516, out vec3 _S517)
{
    uint _S518 = 146U + 4U * _S511;
    float _S519 = openness_number_0(_S510, _S518 + 1U);
    float _S520 = openness_number_0(_S510, _S518 + 2U);
    vec3 _S521 = 1.0 - _S514 * openness_number_0(_S510, _S518);
    vec3 _S522 = 1.0 - _S515 * openness_number_0(_S510, _S518 + 3U);
    vec3 _S523 = 1.0 / (_S521 * _S522 - _S514 * _S515 * (_S519 * _S520));
    _S516 = (_S512 * _S522 + _S514 * _S519 * _S513) * _S523;
    _S517 = (_S513 * _S521 + _S515 * _S520 * _S512) * _S523;
    return;
}

FaceSends_0 face_sends_0(uint _S524, uint _S525, Scattered_0 _S526, Scattered_0 _S527)
{
    uint _S528 = 2U * _S525;
    uint _S529 = 142U + _S528;
    float _S530 = openness_number_0(_S524, _S529);
    float _S531 = openness_number_0(_S524, _S529 + 1U);
    vec3 _S532 = (1.0 - _S530) * _S526.back_5;
    vec3 _S533 = (1.0 - _S531) * _S527.back_5;
    FaceSends_0 sends_1;
    uint _S534 = 154U + _S528;
    float _S535 = openness_number_0(_S524, _S534);
    sends_1.blocks_warp_0 = _S535;
    float _S536 = openness_number_0(_S524, _S534 + 1U);
    sends_1.blocks_weft_0 = _S536;
    sends_1.open_0 = _S535 * _S530 + _S536 * _S531;
    sent_0(_S524, _S525, _S530 * _S526.back_5, _S531 * _S527.back_5, _S532, _S533, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S524, _S525, _S526.through_0, _S527.through_0, _S532, _S533, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S537, vec3 _S538, bool _S539)
{
    Scattered_0 _S540 = scattered_by_0(_S537, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S537)].warp_0)].colour_mean_0), 0U, _S538);
    Scattered_0 _S541 = scattered_by_0(_S537, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S537)].weft_0)].colour_mean_0), 1U, _S538);
    uint _S542;
    if(_S539)
    {
        _S542 = 1U;
    }
    else
    {
        _S542 = 0U;
    }
    FaceSends_0 _S543 = face_sends_0(_S537, _S542, _S540, _S541);
    if(_S539)
    {
        _S542 = 0U;
    }
    else
    {
        _S542 = 1U;
    }
    FaceSends_0 _S544 = face_sends_0(_S537, _S542, _S540, _S541);
    vec3 _S545 = _S543.blocks_warp_0 * _S543.crossing_warp_0 + _S543.blocks_weft_0 * _S543.crossing_weft_0;
    vec3 _S546 = _S544.blocks_warp_0 * _S544.crossing_warp_0 + _S544.blocks_weft_0 * _S544.crossing_weft_0;
    float _S547 = 1.0 - _S543.open_0;
    float _S548 = 1.0 - _S544.open_0;
    vec3 _S549 = 1.0 / (1.0 - _S545 * _S546 * (_S547 * _S548));
    vec3 _S550 = _S546 * (_S543.open_0 + _S547 * (_S543.blocks_warp_0 * _S543.sky_warp_0 + _S543.blocks_weft_0 * _S543.sky_weft_0)) * _S549;
    vec3 _S551 = _S545 * (_S544.open_0 + _S548 * (_S544.blocks_warp_0 * _S544.sky_warp_0 + _S544.blocks_weft_0 * _S544.sky_weft_0)) * _S549;
    FaceRadiance_0 _S552 = face_radiance_0(_S543, _S544.open_0, _S550, _S551);
    FaceRadiance_0 _S553 = face_radiance_0(_S544, _S543.open_0, _S551, _S550);
    Interior_0 interior_1;
    interior_1.warp_3 = _S552.warp_2;
    interior_1.weft_3 = _S552.weft_2;
    interior_1.leaked_1 = _S552.leaked_0;
    interior_1.far_1 = _S553.mean_0;
    interior_1.far_leaked_0 = _S553.leaked_0;
    return interior_1;
}

Bounced_0 bounced_at_0(uint _S554, YarnPoint_0 _S555, vec3 _S556)
{
    Bounced_0 nothing_0;
    const vec3 _S557 = vec3(0.0);
    nothing_0.reflected_0 = _S557;
    nothing_0.transmitted_0 = _S557;
    bool _S558;
    if((fabrics_0._data[uint(_S554)].openness_0) == 4294967295U)
    {
        _S558 = true;
    }
    else
    {
        _S558 = _S555.hole_3;
    }
    if(_S558)
    {
        return nothing_0;
    }
    Blocked_0 _S559 = blocked_at_0(_S554, _S555.is_warp_2, _S555.back_6, _S555.surface_normal_0.z, _S555.height_4);
    uint _S560;
    if(_S555.is_warp_2)
    {
        _S560 = 0U;
    }
    else
    {
        _S560 = 1U;
    }
    return bounced_by_0(_S559, scattered_by_0(_S554, _S555.albedos_1, _S560, _S556), interior_of_0(_S554, _S556, _S555.back_6));
}

vec3 scattered_0(uint _S561, YarnPoint_0 _S562, vec3 _S563, vec3 _S564)
{
    const vec3 _S565 = vec3(0.0);
    bool _S566 = !_S562.hole_3;
    bool _S567;
    if(_S566)
    {
        _S567 = (_S563.z) > 0.0;
    }
    else
    {
        _S567 = false;
    }
    vec3 value_1;
    if(_S567)
    {
        value_1 = _S562.albedos_1.diffuse_reflect_0 * _S562.diffuse_gain_1 * diffuse_reflection_0(_S563, _S562.normal_7, fabrics_0._data[uint(_S561)].diffuse_blend_0) + _S562.albedos_1.specular_reflect_0 * reflection_0(_S563, _S564, _S562.normal_7, _S562.tangent_8, _S562.roughness_8, fabrics_0._data[uint(_S561)].optical_depth_0);
    }
    else
    {
        if(_S566)
        {
            _S567 = (_S563.z) < 0.0;
        }
        else
        {
            _S567 = false;
        }
        if(_S567)
        {
            value_1 = _S562.albedos_1.diffuse_transmit_0 * _S562.diffuse_gain_1 * diffuse_reflection_0(- _S563, _S562.normal_7, fabrics_0._data[uint(_S561)].diffuse_blend_0) + _S562.albedos_1.specular_transmit_0 * transmission_1(_S563, _S564, _S562.normal_7, _S562.tangent_8, _S562.roughness_8, fabrics_0._data[uint(_S561)].optical_depth_0);
        }
        else
        {
            value_1 = _S565;
        }
    }
    float _S568 = fabrics_0._data[uint(_S561)].sheen_strength_0;
    if((fabrics_0._data[uint(_S561)].sheen_strength_0) <= 0.0)
    {
        return value_1;
    }
    vec2 _S569 = sheen_with_transmittance_0(_S563, _S564, _S568, fabrics_0._data[uint(_S561)].sheen_roughness_0);
    return _S569.y * value_1 + _S569.x;
}

bool unoccluded_0(uint _S570, SearchQuality_0 _S571, float _S572, float _S573, float _S574, vec3 _S575, bool _S576)
{
    if((_S575.z) <= 0.0)
    {
        return false;
    }
    return is_free_0(_S570, _S571, vec3(_S572, _S573, _S574 + fabrics_0._data[uint(_S570)].lift_0), _S575, _S576, max_height_along_0(_S570, _S572, _S573, _S574, _S575, _S576));
}

bool is_lit_0(uint _S577, SearchQuality_0 _S578, YarnPoint_0 _S579, vec3 _S580)
{
    if(_S579.hole_3)
    {
        return true;
    }
    vec3 _S581 = to_face_frame_0(_S580, _S579.back_6);
    float _S582 = _S581.z;
    bool _S583 = _S582 < 0.0;
    vec3 normal_8;
    float height_10;
    if(_S583)
    {
        SurfacePoint_0 _S584 = surface_at_0(_S577, _S579.x_9, _S579.y_3, !_S579.back_6);
        normal_8 = _S584.normal_2;
        height_10 = _S584.height_3;
    }
    else
    {
        normal_8 = _S579.surface_normal_0;
        height_10 = _S579.height_4;
    }
    vec3 _S585 = vec3(_S581.xy, abs(_S582));
    if((dot(normal_8, _S585)) <= 0.0)
    {
        return false;
    }
    return unoccluded_0(_S577, _S578, _S579.x_9, _S579.y_3, height_10, _S585, (_S579.back_6) != _S583);
}

vec3 evaluate_with_0(uint _S586, SearchQuality_0 _S587, YarnPoint_0 _S588, Bounced_0 _S589, vec3 _S590, vec3 _S591)
{
    vec3 _S592 = to_face_frame_0(_S591, _S588.back_6);
    vec3 _S593 = scattered_0(_S586, _S588, to_face_frame_0(_S590, _S588.back_6), _S592);
    bool _S594;
    if((max(_S593.x, max(_S593.y, _S593.z))) <= 0.0)
    {
        _S594 = true;
    }
    else
    {
        _S594 = !is_lit_0(_S586, _S587, _S588, _S590);
    }
    vec3 value_2;
    if(_S594)
    {
        value_2 = vec3(0.0);
    }
    else
    {
        value_2 = _S593;
    }
    vec3 between_1 = bounced_value_0(_S589, _S590, _S591);
    float _S595 = fabrics_0._data[uint(_S586)].sheen_strength_0;
    vec3 between_2;
    if((fabrics_0._data[uint(_S586)].sheen_strength_0) > 0.0)
    {
        between_2 = between_1 * (1.0 - _S595 * sheen_lobe_0(abs(_S592.z), fabrics_0._data[uint(_S586)].sheen_roughness_0).z);
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

vec3 evaluate_0(uint _S596, SearchQuality_0 _S597, YarnPoint_0 _S598, vec3 _S599, vec3 _S600)
{
    return evaluate_with_0(_S596, _S597, _S598, bounced_at_0(_S596, _S598, vec3(1.0)), _S599, _S600);
}

float straight_through_0(uint _S601, YarnPoint_0 _S602, vec3 _S603)
{
    if(!_S602.hole_3)
    {
        return 0.0;
    }
    float _S604 = fabrics_0._data[uint(_S601)].sheen_strength_0;
    if((fabrics_0._data[uint(_S601)].sheen_strength_0) <= 0.0)
    {
        return 1.0;
    }
    return 1.0 - _S604 * sheen_lobe_0(abs(_S603.z), fabrics_0._data[uint(_S601)].sheen_roughness_0).z;
}

vec4 cloth_value_0(uint fabric_1, vec2 centre_1, vec2 dx_1, vec2 dy_1, vec3 light_8, vec3 view_7)
{
    SearchQuality_0 _S605 = default_quality_0();
    Footprint_0 footprint_0;
    footprint_0.centre_0 = centre_1;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    YarnPoint_0 _S606 = locate_yarn_0(fabric_1, _S605, centre_1.x, centre_1.y, view_7, Footprint_spread_side_0(footprint_0));
    return vec4(evaluate_0(fabric_1, _S605, _S606, light_8, view_7), straight_through_0(fabric_1, _S606, view_7));
}

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
void main()
{
    if((gl_GlobalInvocationID.x) >= (query_count_0._data[uint(0)]))
    {
        return;
    }
    Query_0 _S607 = queries_0._data[uint(gl_GlobalInvocationID.x)];
    answers_0._data[uint(gl_GlobalInvocationID.x)] = cloth_value_0(_S607.fabric_0, vec2(_S607.centre_x_0, _S607.centre_y_0), vec2(_S607.dx_x_0, _S607.dx_y_0), vec2(_S607.dy_x_0, _S607.dy_y_0), vec3(_S607.light_x_0, _S607.light_y_0, _S607.light_z_0), vec3(_S607.view_x_0, _S607.view_y_0, _S607.view_z_0));
    return;
}

