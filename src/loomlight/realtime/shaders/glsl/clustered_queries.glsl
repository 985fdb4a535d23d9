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
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_1 {
    uint _data[];
} words_0;
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
const float  PYRAMID_RADII_0[4] = float[](1.0, 2.0, 4.0, 8.0);
float saturate_0(float x_0)
{
    return clamp(x_0, 0.0, 1.0);
}

vec3 saturate_1(vec3 x_1)
{
    return clamp(x_1, vec3(0.0), vec3(1.0));
}

struct Footprint_0
{
    vec2 centre_0;
    vec2 dx_0;
    vec2 dy_0;
};

Footprint_0 footprint_of_0(vec2 centre_1, vec2 dx_1, vec2 dy_1)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = centre_1;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    return footprint_0;
}

uint mixed_0(uint number_0)
{
    uint bits_0 = (number_0 ^ (number_0 >> 16)) * 2246822507U;
    uint bits_1 = (bits_0 ^ (bits_0 >> 13)) * 3266489909U;
    return bits_1 ^ (bits_1 >> 16);
}

uint with_number_0(uint hash_0, float number_1)
{
    uint _S1;
    if(number_1 == 0.0)
    {
        _S1 = 0U;
    }
    else
    {
        _S1 = floatBitsToUint(number_1);
    }
    return mixed_0(hash_0 ^ _S1);
}

uint hashed_0(Footprint_0 footprint_1, vec3 view_1, vec2 size_1)
{
    uint hash_1 = 2654435769U;
    uint axis_0 = 0U;
    for(;;)
    {
        if(axis_0 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S2 = footprint_1.centre_0[axis_0] / size_1[axis_0];
        uint _S3 = mixed_0(hash_1 ^ uint((_S2 - floor(_S2)) * 4096.0));
        uint _S4 = axis_0 + 1U;
        hash_1 = _S3;
        axis_0 = _S4;
    }
    axis_0 = 0U;
    for(;;)
    {
        if(axis_0 < 3U)
        {
        }
        else
        {
            break;
        }
        uint _S5 = with_number_0(hash_1, view_1[axis_0]);
        uint _S6 = axis_0 + 1U;
        hash_1 = _S5;
        axis_0 = _S6;
    }
    return with_number_0(with_number_0(with_number_0(with_number_0(hash_1, footprint_1.dx_0.x), footprint_1.dx_0.y), footprint_1.dy_0.x), footprint_1.dy_0.y);
}

float uniform_of_0(uint seed_2, uint dimension_0)
{
    return float((mixed_0(seed_2 + (dimension_0 + 1U) * 2654435769U)) >> 8) * 5.9604644775390625e-08;
}

vec3 to_face_frame_0(vec3 direction_0, bool back_2)
{
    vec2 _S7 = direction_0.xy;
    float _S8;
    if(back_2)
    {
        _S8 = - direction_0.z;
    }
    else
    {
        _S8 = direction_0.z;
    }
    return vec3(_S7, _S8);
}

float arc_tangent_quotient_0(float x_2, float y_0)
{
    return ((((((0.0 * x_2 + 0.00809729471802711) * x_2 + -0.0377517081797123) * x_2 + 0.08475969731807709) * x_2 + -0.13537675142288208) * x_2 + 0.19895026087760925) * x_2 + -0.33327975869178772) * x_2 + 0.99999970197677612;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0);
}

struct BinTaps_0
{
    uint corner_0;
    uint bins_1;
    vec4 weights_0;
};

BinTaps_0 bin_taps_0(vec3 direction_1, uint bins_2)
{
    float _S9 = sqrt(max(1.0 - direction_1.z, 0.0));
    float _S10 = direction_1.x;
    float _S11 = abs(_S10);
    float _S12 = direction_1.y;
    float _S13 = abs(_S12);
    float _S14 = arc_tangent_of_ratio_0(min(_S11, _S13) / max(max(_S11, _S13), 9.999999960041972e-13)) * 1.27323949337005615;
    bool _S15 = _S11 >= _S13;
    float _S16;
    if(_S10 < 0.0)
    {
        _S16 = -1.0;
    }
    else
    {
        _S16 = 1.0;
    }
    float _S17;
    if(_S15)
    {
        _S17 = _S9;
    }
    else
    {
        _S17 = _S9 * _S14;
    }
    float _S18 = _S16 * _S17;
    if(_S12 < 0.0)
    {
        _S16 = -1.0;
    }
    else
    {
        _S16 = 1.0;
    }
    if(_S15)
    {
        _S17 = _S9 * _S14;
    }
    else
    {
        _S17 = _S9;
    }
    float _S19 = float(bins_2);
    vec2 _S20 = clamp((vec2(_S18, _S16 * _S17) + 1.0) * (0.5 * _S19) - 0.5, vec2(0.0), vec2(_S19 - 1.0));
    float _S21 = _S20.x;
    uint _S22 = bins_2 - 2U;
    uint _S23 = min(uint(_S21), _S22);
    float _S24 = _S20.y;
    uint _S25 = min(uint(_S24), _S22);
    float _S26 = _S21 - float(_S23);
    float _S27 = _S24 - float(_S25);
    BinTaps_0 taps_0;
    taps_0.corner_0 = _S25 * bins_2 + _S23;
    taps_0.bins_1 = bins_2;
    float _S28 = 1.0 - _S26;
    float _S29 = 1.0 - _S27;
    taps_0.weights_0 = vec4(_S28 * _S29, _S26 * _S29, _S28 * _S27, _S26 * _S27);
    return taps_0;
}

float table_number_0(uint index_0)
{
    return uintBitsToFloat(words_0._data[uint(index_0)]);
}

float BinTaps_read_0(BinTaps_0 this_0, uint table_0, uint first_0, uint stride_0, uint offset_2)
{
    uint _S30 = table_0 + (first_0 + this_0.corner_0) * stride_0 + offset_2;
    return table_number_0(_S30) * this_0.weights_0.x + table_number_0(_S30 + stride_0) * this_0.weights_0.y + table_number_0(_S30 + this_0.bins_1 * stride_0) * this_0.weights_0.z + table_number_0(_S30 + (this_0.bins_1 + 1U) * stride_0) * this_0.weights_0.w;
}

struct TexelBox_0
{
    vec2 corner_1;
    vec2 size_2;
    uvec2 first_1;
    vec2 extent_0;
    uvec2 last_0;
    vec2 turns_0;
};

TexelBox_0 texel_box_0(Clustered_0 tables_0, Footprint_0 footprint_2, vec2 offset_3, float place_0)
{
    float _S31 = footprint_2.dx_0.x;
    float _S32 = footprint_2.dy_0.x;
    float _S33 = sqrt(_S31 * _S31 + _S32 * _S32);
    float _S34 = footprint_2.dx_0.y;
    float _S35 = footprint_2.dy_0.y;
    float _S36 = sqrt(_S34 * _S34 + _S35 * _S35);
    vec2 _S37 = vec2(_S33, _S36);
    float _S38 = (_S31 * _S34 + _S32 * _S35) / max(_S33 * _S36, 1.00000000317107685e-30);
    float _S39 = abs(_S38);
    float _S40 = place_0 * sqrt(min(_S39, 1.0));
    float _S41;
    if(_S38 < 0.0)
    {
        _S41 = - _S40;
    }
    else
    {
        _S41 = _S40;
    }
    vec2 _S42 = _S37 * vec2(_S40, _S41);
    vec2 _S43 = vec2(tables_0.texel_width_0, tables_0.texel_height_0);
    vec2 _S44 = vec2(float(tables_0.columns_0), float(tables_0.rows_0));
    TexelBox_0 box_0;
    vec2 _S45 = _S37 * sqrt(max(1.0 - _S39, 0.0));
    box_0.size_2 = _S45;
    vec2 _S46 = 0.5 * _S45;
    vec2 _S47 = footprint_2.centre_0 + _S42 - _S46;
    box_0.corner_1 = _S47;
    vec2 _S48 = max(round(_S45 / _S43), vec2(1.0));
    box_0.extent_0 = _S48;
    vec2 _S49 = round((_S47 + _S46 + offset_3) / _S43 - 0.5 * _S48);
    const vec2 _S50 = vec2(0.0);
    vec2 _S51 = max(_S49 - floor(_S49 / _S44) * _S44, _S50);
    uvec2 _S52 = uvec2(min(uint(_S51.x), tables_0.columns_0 - 1U), min(uint(_S51.y), tables_0.rows_0 - 1U));
    box_0.first_1 = _S52;
    vec2 _S53 = floor(_S48 / _S44);
    box_0.turns_0 = _S53;
    vec2 _S54 = max(_S48 - _S53 * _S44, _S50);
    uvec2 _S55 = _S52 + uvec2(uint(_S54.x), uint(_S54.y));
    box_0.last_0 = _S55;
    if((_S55.x) >= (tables_0.columns_0))
    {
        box_0.last_0[0] = box_0.last_0[0] - tables_0.columns_0;
        box_0.turns_0[0] = box_0.turns_0[0] + 1.0;
    }
    if((box_0.last_0.y) >= (tables_0.rows_0))
    {
        box_0.last_0[1] = box_0.last_0[1] - tables_0.rows_0;
        box_0.turns_0[1] = box_0.turns_0[1] + 1.0;
    }
    return box_0;
}

vec2 turns_and_remainder_0(uint family_0, float index_1)
{
    float _S56 = floor(fma(index_1, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S56, fma(- _S56, families_0._data[uint(family_0)].count_0, index_1));
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
    float _S57 = floor(position_0 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S58 = fma(- _S57, families_0._data[uint(family_1)].size_0, position_0);
    cell_0.below_0 = _S58;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S58;
    cell_0.across_0 = _S58 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S57).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float turns_1 = (position_1 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_2 = turns_1 - floor(turns_1);
    float _S59 = turns_2 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_2 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S60;
    if(_S59 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S60 = 1U;
    }
    else
    {
        _S60 = 0U;
    }
    uint _S61 = min(thread_1 + _S60, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S62 = families_0._data[uint(family_2)].place_table_0 + _S61 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S61;
    cell_1.below_0 = _S59 - table_number_0(_S62);
    cell_1.above_0 = table_number_0(_S62 + 1U) - _S59;
    cell_1.across_0 = _S59 - table_number_0(_S62 + 2U);
    cell_1.half_width_1 = table_number_0(_S62 + 3U);
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

struct Bound_0
{
    uint thread_2;
    float turns_3;
    float cell_2;
    float visible_0;
    float width_1;
    float gap_0;
};

Bound_0 bound_at_0(uint family_4, float position_3)
{
    Cell_0 _S63 = locate_0(family_4, position_3);
    float _S64 = table_number_0(families_0._data[uint(family_4)].before_0 + 2U * _S63.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_2 = _S63.thread_0;
    bound_0.turns_3 = round((position_3 - families_0._data[uint(family_4)].start_0 - _S64 - _S63.below_0) * families_0._data[uint(family_4)].inverse_period_0);
    bound_0.cell_2 = _S63.below_0;
    float _S65 = 2.0 * _S63.half_width_1;
    bound_0.width_1 = _S65;
    bound_0.visible_0 = clamp((_S63.across_0 + _S63.half_width_1) / _S65, 0.0, 1.0);
    bound_0.gap_0 = min(_S63.below_0, _S63.below_0 - _S63.across_0 - _S63.half_width_1) + max(_S63.across_0 - _S63.half_width_1, 0.0);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_3)
{
    float _S66 = centre_2 - floor((centre_2 - families_0._data[uint(family_5)].start_0) * families_0._data[uint(family_5)].inverse_period_0) * families_0._data[uint(family_5)].period_0;
    float _S67 = 0.5 * max(size_3, families_0._data[uint(family_5)].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_0 = bound_at_0(family_5, _S66 - _S67);
    stretch_0.high_0 = bound_at_0(family_5, _S66 + _S67);
    return stretch_0;
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

float Stretch_turns_0(Stretch_0 this_1)
{
    return this_1.high_0.turns_3 - this_1.low_0.turns_3;
}

vec3 lengths_0(uint family_6, Stretch_0 stretch_1)
{
    float _S68 = Stretch_turns_0(stretch_1);
    uint _S69 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.low_0.thread_2;
    uint _S70 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.high_0.thread_2;
    float _S71 = table_number_0(_S70) - table_number_0(_S69);
    float _S72 = table_number_0(_S70 + 1U) - table_number_0(_S69 + 1U);
    return vec3(_S71 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_1 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_1 + _S68 * families_0._data[uint(family_6)].visible_total_0, _S72 - _S71 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S68 * (families_0._data[uint(family_6)].period_0 - families_0._data[uint(family_6)].visible_total_0), _S72 + stretch_1.high_0.cell_2 - stretch_1.low_0.cell_2 + _S68 * families_0._data[uint(family_6)].period_0);
}

vec2 integrals_along_0(uint family_7, Stretch_0 stretch_2, uint quantity_0)
{
    uint _S73 = 3U * families_0._data[uint(family_7)].quantities_0;
    uint _S74 = families_0._data[uint(family_7)].colour_threads_0 + _S73 * stretch_2.low_0.thread_2 + quantity_0;
    uint _S75 = families_0._data[uint(family_7)].colour_threads_0 + _S73 * stretch_2.high_0.thread_2 + quantity_0;
    uint _S76 = families_0._data[uint(family_7)].colour_threads_0 + _S73 * uint(families_0._data[uint(family_7)].count_0) + quantity_0;
    float _S77 = table_number_0(_S74);
    float _S78 = table_number_0(_S75);
    float _S79 = Stretch_turns_0(stretch_2);
    uint _S80 = 2U * families_0._data[uint(family_7)].quantities_0;
    return vec2(table_number_0(_S75 + families_0._data[uint(family_7)].quantities_0) - table_number_0(_S74 + families_0._data[uint(family_7)].quantities_0) + _S78 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_1 - _S77 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_1 + _S79 * table_number_0(_S76 + families_0._data[uint(family_7)].quantities_0), table_number_0(_S75 + _S80) - table_number_0(_S74 + _S80) + _S78 * stretch_2.high_0.cell_2 - _S77 * stretch_2.low_0.cell_2 + _S79 * table_number_0(_S76 + _S80));
}

bool Stretch_wraps_0(Stretch_0 this_2)
{
    return (this_2.high_0.thread_2) < (this_2.low_0.thread_2);
}

uvec4 Stretch_differences_0(Stretch_0 this_3, uvec4 entries_0, uint whole_0)
{
    uint _S81 = entries_0.z;
    uint _S82 = entries_0.x;
    uint _S83 = _S81 - _S82;
    uint _S84;
    if(Stretch_wraps_0(this_3))
    {
        _S84 = whole_0;
    }
    else
    {
        _S84 = 0U;
    }
    return uvec4(_S83 + _S84, entries_0.w - _S81, entries_0.y - _S82, whole_0);
}

uvec4 row_differences_0(Stretch_0 across_1, uint row_1, uint count_1, uint quantities_1)
{
    uint _S85 = row_1 + across_1.low_0.thread_2 * quantities_1;
    uint _S86 = row_1 + across_1.high_0.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, uvec4(words_0._data[uint(_S85)], words_0._data[uint(_S85 + quantities_1)], words_0._data[uint(_S86)], words_0._data[uint(_S86 + quantities_1)]), words_0._data[uint(row_1 + count_1 * quantities_1)]);
}

vec4 Stretch_weights_0(Stretch_0 this_4)
{
    float _S87 = - this_4.low_0.visible_0;
    float _S88 = Stretch_turns_0(this_4);
    float _S89;
    if(Stretch_wraps_0(this_4))
    {
        _S89 = 1.0;
    }
    else
    {
        _S89 = 0.0;
    }
    return vec4(1.0, this_4.high_0.visible_0, _S87, _S88 - _S89);
}

float integral_on_top_0(uint family_8, Stretch_0 across_2, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S90 = uint(families_0._data[uint(family_8)].count_0);
    uint _S91 = (_S90 + 1U) * families_0._data[uint(family_8)].quantities_0;
    uint _S92 = families_0._data[uint(family_8)].colour_areas_0 + quantity_1;
    uvec4 _S93 = row_differences_0(across_2, _S92 + along_0.low_0.thread_2 * _S91, _S90, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S94 = row_differences_0(across_2, _S92 + (along_0.low_0.thread_2 + 1U) * _S91, _S90, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S95 = row_differences_0(across_2, _S92 + along_0.high_0.thread_2 * _S91, _S90, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S96 = row_differences_0(across_2, _S92 + (along_0.high_0.thread_2 + 1U) * _S91, _S90, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S97 = row_differences_0(across_2, _S92 + crossing_count_0 * _S91, _S90, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S98 = _S95 - _S93;
    uvec4 _S99;
    if(Stretch_wraps_0(along_0))
    {
        _S99 = _S97;
    }
    else
    {
        _S99 = uvec4(ivec4(0));
    }
    vec4 _S100 = Stretch_weights_0(across_2);
    return dot(vec4(dot(vec4(ivec4(_S98 + _S99)), _S100), dot(vec4(ivec4(_S96 - _S95)), _S100), dot(vec4(ivec4(_S94 - _S93)), _S100), dot(vec4(ivec4(_S97)), _S100)), Stretch_weights_0(along_0)) * families_0._data[uint(family_8)].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_0, uint row_2)
{
    Albedos_0 _S101 = table_albedos_0(row_2);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_0 * _S101.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_0 * _S101.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_0 * _S101.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_0 * _S101.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 own_0, Stretch_0 other_0, bool back_3)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0._data[uint(family_9)].colour_mean_0);
    if((families_0._data[uint(family_9)].quantities_0) == 1U)
    {
        return albedos_2;
    }
    vec3 _S102 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0._data[uint(family_9)].quantities_0))
        {
        }
        else
        {
            break;
        }
        vec2 _S103 = integrals_along_0(family_9, own_0, quantity_2);
        float _S104 = integral_on_top_0(family_9, own_0, other_0, uint(families_0._data[uint(crossing_0)].count_0), quantity_2);
        float _S105 = _S103.x;
        float _S106 = _S105 * _S102.x;
        float _S107;
        if(back_3)
        {
            _S107 = _S106 - _S104;
        }
        else
        {
            _S107 = _S104;
        }
        bool _S108 = quantity_2 == 0U;
        if(_S108)
        {
            is_exposed_0 = _S107 > (16.0 * families_0._data[uint(family_9)].area_unit_0 * min(_S106 / families_0._data[uint(family_9)].crossing_area_0, 1.0) + 0.00000999999974738 * _S106);
        }
        float _S109 = _S105 * _S102.y;
        float _S110;
        if(is_exposed_0)
        {
            _S110 = _S107;
        }
        else
        {
            _S110 = 0.0;
        }
        float _S111 = _S109 + _S110 + 0.000244140625 * _S102.z * _S103.y;
        if(_S108)
        {
            weight_1 = 1.0 / max(_S111, 9.99999968265522539e-21);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S111 * weight_1, families_0._data[uint(family_9)].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate_1(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate_1(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate_1(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate_1(albedos_2.specular_transmit_0);
    return albedos_2;
}

Albedos_0 tinted_0(Albedos_0 albedos_3, vec3 tint_0)
{
    Albedos_0 result_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
    vec3 warp_1;
    vec3 weft_1;
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
    vec3 _S112 = (1.0 - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    vec3 _S113 = sends_0.sky_warp_0 + _S112 * sends_0.crossing_warp_0;
    found_0.warp_1 = _S113;
    vec3 _S114 = sends_0.sky_weft_0 + _S112 * sends_0.crossing_weft_0;
    found_0.weft_1 = _S114;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S113 + sends_0.blocks_weft_0 * _S114;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(vec3 view_2, out float  terms_0[6])
{
    float _S115 = 1.0 - view_2.z;
    float _S116 = _S115 * _S115;
    terms_0[0] = 1.0;
    float _S117 = view_2.x;
    float _S118 = _S117 * _S117;
    float _S119 = view_2.y;
    float _S120 = _S119 * _S119;
    terms_0[1] = sqrt(max(_S118 + _S120, 9.999999960041972e-13));
    terms_0[2] = _S116;
    terms_0[3] = _S116 * _S116;
    terms_0[4] = _S118 - _S120;
    terms_0[5] = 0.0;
    return;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

Blocked_0 scaled_0(Blocked_0 blocked_0, float share_0)
{
    Blocked_0 result_1;
    result_1.by_warp_0 = share_0 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_0 * blocked_0.by_weft_0;
    result_1.far_0 = share_0 * blocked_0.far_0;
    return result_1;
}

struct Bounced_0
{
    vec3 reflected_0;
    vec3 transmitted_0;
};

struct Scattered_0
{
    vec3 back_4;
    vec3 through_0;
};

struct Interior_0
{
    vec3 warp_2;
    vec3 weft_2;
    vec3 leaked_1;
    vec3 far_1;
    vec3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_1, Scattered_0 yarn_0, Interior_0 interior_0)
{
    vec3 _S121 = (blocked_1.by_warp_0 + blocked_1.by_weft_0) * interior_0.leaked_1;
    vec3 _S122 = blocked_1.far_0 * yarn_0.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (blocked_1.by_warp_0 * interior_0.warp_2 + blocked_1.by_weft_0 * interior_0.weft_2) + _S122 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S122 * interior_0.far_1 + yarn_0.back_4 * _S121;
    return bounced_0;
}

Bounced_0 sum_of_0(Bounced_0 first_2, Bounced_0 second_0)
{
    Bounced_0 sum_1;
    sum_1.reflected_0 = first_2.reflected_0 + second_0.reflected_0;
    sum_1.transmitted_0 = first_2.transmitted_0 + second_0.transmitted_0;
    return sum_1;
}

int summed_0(Clustered_0 tables_1, uint first_3, uint column_0, uint row_3)
{
    return int(words_0._data[uint(first_3 + (row_3 * (tables_1.columns_0 + 1U) + column_0) * tables_1.channels_0)]);
}

float box_mean_0(Clustered_0 tables_2, TexelBox_0 box_1, uint face_0, uint channel_0)
{
    uint _S123 = tables_2.sums_0 + face_0 * (tables_2.columns_0 + 1U) * (tables_2.rows_0 + 1U) * tables_2.channels_0 + channel_0;
    uint _S124 = box_1.last_0.x;
    uint _S125 = box_1.first_1.y;
    uint _S126 = box_1.first_1.x;
    uint _S127 = box_1.last_0.y;
    float total_0 = float(summed_0(tables_2, _S123, _S124, _S127) - summed_0(tables_2, _S123, _S126, _S127) - (summed_0(tables_2, _S123, _S124, _S125) - summed_0(tables_2, _S123, _S126, _S125)));
    float _S128 = box_1.turns_0.x;
    bool _S129 = _S128 > 0.0;
    float total_1;
    if(_S129)
    {
        total_1 = total_0 + _S128 * float(summed_0(tables_2, _S123, tables_2.columns_0, _S127) - summed_0(tables_2, _S123, tables_2.columns_0, _S125));
    }
    else
    {
        total_1 = total_0;
    }
    float _S130 = box_1.turns_0.y;
    bool _S131 = _S130 > 0.0;
    if(_S131)
    {
        total_1 = total_1 + _S130 * float(summed_0(tables_2, _S123, _S124, tables_2.rows_0) - summed_0(tables_2, _S123, _S126, tables_2.rows_0));
    }
    bool _S132;
    if(_S129)
    {
        _S132 = _S131;
    }
    else
    {
        _S132 = false;
    }
    if(_S132)
    {
        total_1 = total_1 + _S128 * _S130 * float(summed_0(tables_2, _S123, tables_2.columns_0, tables_2.rows_0));
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

float square_0(vec3 v_0)
{
    return dot(v_0, v_0);
}

struct BaseTaps_0
{
    vec3 facing_0;
    bool transmits_1;
    BinTaps_0 around_0;
    uint first_4;
    BinTaps_0 half_vector_0;
};

struct ViewedBase_0
{
    vec3 view_3;
    bool back_5;
    uint face_1;
    BinTaps_0 around_1;
    TexelBox_0 box_2;
    vec2 trust_1;
};

BaseTaps_0 base_taps_0(ViewedBase_0 seen_0, vec3 light_1)
{
    BaseTaps_0 taps_1;
    vec3 _S133 = to_face_frame_0(light_1, seen_0.back_5);
    taps_1.facing_0 = _S133;
    float _S134 = _S133.z;
    bool _S135 = _S134 < 0.0;
    taps_1.transmits_1 = _S135;
    taps_1.around_0 = bin_taps_0(vec3(_S133.xy, abs(_S134)), 32U);
    uint _S136 = seen_0.face_1 * 2U;
    uint _S137;
    if(_S135)
    {
        _S137 = 1U;
    }
    else
    {
        _S137 = 0U;
    }
    taps_1.first_4 = (_S136 + _S137) * 1024U;
    vec3 _S138 = taps_1.facing_0 + seen_0.view_3;
    vec3 half_vector_1 = _S138 * (1.0 / sqrt(max(square_0(_S138), 9.999999960041972e-13)));
    vec3 half_vector_2;
    if((half_vector_1.z) < 0.0)
    {
        half_vector_2 = - half_vector_1;
    }
    else
    {
        half_vector_2 = half_vector_1;
    }
    taps_1.half_vector_0 = bin_taps_0(half_vector_2, 32U);
    return taps_1;
}

struct Components_0
{
    float diffuse_warp_0;
    float diffuse_weft_0;
    float specular_warp_0;
    float specular_weft_0;
    float light_visibility_1;
    float hole_0;
};

Components_0 no_components_0()
{
    Components_0 nothing_0;
    nothing_0.diffuse_warp_0 = 0.0;
    nothing_0.diffuse_weft_0 = 0.0;
    nothing_0.specular_warp_0 = 0.0;
    nothing_0.specular_weft_0 = 0.0;
    nothing_0.light_visibility_1 = 0.0;
    nothing_0.hole_0 = 0.0;
    return nothing_0;
}

float projected_area_1(vec3 direction_2, vec3 tangent_0, float roughness_1)
{
    float _S139 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0) * (roughness_1 - 1.0) * _S139 * _S139 + 1.0, roughness_1 * roughness_1));
}

float exponential_0(float x_3)
{
    float _S140 = clamp(x_3, -87.0, 88.0);
    float _S141 = floor(_S140 * 1.4426950216293335 + 0.5);
    float _S142 = _S140 - _S141 * 0.693359375 + _S141 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S142 + 0.00139819993637502) * _S142 + 0.00833345204591751) * _S142 + 0.04166579619050026) * _S142 + 0.1666666567325592) * _S142 + 0.5;
    float _S143 = uintBitsToFloat(uint(int(_S141) + 127) << 23);
    float _S144;
    if(x_3 < -87.0)
    {
        _S144 = 0.0;
    }
    else
    {
        _S144 = (p_0 * _S142 * _S142 + _S142 + 1.0) * _S143;
    }
    return _S144;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_3;
    Albedos_0 weft_3;
};

vec3 shaded_0(Components_0 components_0, FamilyAlbedos_0 albedos_4, bool transmits_2)
{
    if(transmits_2)
    {
        return albedos_4.warp_3.diffuse_transmit_0 * components_0.diffuse_warp_0 + albedos_4.weft_3.diffuse_transmit_0 * components_0.diffuse_weft_0 + albedos_4.warp_3.specular_transmit_0 * components_0.specular_warp_0 + albedos_4.weft_3.specular_transmit_0 * components_0.specular_weft_0;
    }
    return albedos_4.warp_3.diffuse_reflect_0 * components_0.diffuse_warp_0 + albedos_4.weft_3.diffuse_reflect_0 * components_0.diffuse_weft_0 + albedos_4.warp_3.specular_reflect_0 * components_0.specular_warp_0 + albedos_4.weft_3.specular_reflect_0 * components_0.specular_weft_0;
}

vec3 bounced_value_0(Bounced_0 bounced_1, vec3 light_2, vec3 view_4)
{
    float _S145 = light_2.z;
    vec3 _S146;
    if((_S145 * view_4.z) < 0.0)
    {
        _S146 = bounced_1.transmitted_0;
    }
    else
    {
        _S146 = bounced_1.reflected_0;
    }
    return _S146 * (abs(_S145) * 0.31830987334251404);
}

float sheen_scale_0(float x_4, float y_1)
{
    return (((((0.0 * x_4 + (((((-1.1402510404586792 * y_1 + 0.40672621130943298) * y_1 + 1.65398800373077393) * y_1 + -1.29730904102325439) * y_1 + 0.30570998787879944) * y_1 + -0.0220868494361639)) * x_4 + (((((-0.21142719686031342 * y_1 + 1.05947399139404297) * y_1 + -0.41116121411323547) * y_1 + -0.93859231472015381) * y_1 + 0.51606941223144531) * y_1 + 0.05409301072359085)) * x_4 + (((((1.22944498062133789 * y_1 + -0.45962560176849365) * y_1 + -1.63861405849456787) * y_1 + 1.33565104007720947) * y_1 + -0.45725581049919128) * y_1 + 0.08243165910243988)) * x_4 + (((((0.39779931306838989 * y_1 + -1.18879103660583496) * y_1 + 0.28251591324806213) * y_1 + 1.168984055519104) * y_1 + -0.76864629983901978) * y_1 + 0.0091691892594099)) * x_4 + (((((-0.26563560962677002 * y_1 + -0.19379159808158875) * y_1 + 0.2677634060382843) * y_1 + 0.00270519289188087) * y_1 + 0.14349560439586639) * y_1 + 0.10290180146694183)) * x_4 + (((((-0.20701569318771362 * y_1 + 0.24526430666446686) * y_1 + 0.19551840424537659) * y_1 + 0.07586126774549484) * y_1 + 0.38894739747047424) * y_1 + 0.15043120086193085);
}

float sheen_shear_0(float x_5, float y_2)
{
    return ((((0.0 * x_5 + (((((-0.10608240216970444 * y_2 + 1.99214303493499756) * y_2 + -1.42255294322967529) * y_2 + -1.09495604038238525) * y_2 + 0.59180057048797607) * y_2 + 0.06902855634689331)) * x_5 + (((((-0.46220690011978149 * y_2 + -0.29113379120826721) * y_2 + 1.39025199413299561) * y_2 + 0.35589990019798279) * y_2 + -1.17120099067687988) * y_2 + 0.15940259397029877)) * x_5 + (((((2.26068711280822754 * y_2 + -3.64728999137878418) * y_2 + -0.72173482179641724) * y_2 + 3.07659196853637695) * y_2 + -0.6827620267868042) * y_2 + -0.3039557933807373)) * x_5 + (((((0.81201767921447754 * y_2 + 0.36014080047607422) * y_2 + -1.72646903991699219) * y_2 + -0.22630110383033752) * y_2 + 0.89514690637588501) * y_2 + -0.10397960245609283)) * x_5 + (((((-0.37648698687553406 * y_2 + 1.10974001884460449) * y_2 + 0.17824520170688629) * y_2 + -1.04968702793121338) * y_2 + 0.1461234986782074) * y_2 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_6, float y_3)
{
    return ((((0.0 * x_6 + (((((12.95646953582763672 * y_3 + -21.38032913208007812) * y_3 + -7.37853097915649414) * y_3 + 34.55607986450195312) * y_3 + -23.61347007751464844) * y_3 + 5.00126314163208008)) * x_6 + (((((10.91487026214599609 * y_3 + -6.08202791213989258) * y_3 + -38.2036285400390625) * y_3 + 53.3440399169921875) * y_3 + -21.91996002197265625) * y_3 + 2.01606011390686035)) * x_6 + (((((-14.52206039428710938 * y_3 + 36.803619384765625) * y_3 + -22.94047927856445312) * y_3 + -10.07973003387451172) * y_3 + 15.77003955841064453) * y_3 + -4.92722177505493164)) * x_6 + (((((-7.62505722045898438 * y_3 + 1.27310299873352051) * y_3 + 31.19523048400878906) * y_3 + -44.39989852905273438) * y_3 + 26.44947052001953125) * y_3 + -8.73507976531982422)) * x_6 + (((((5.65633487701416016 * y_3 + -17.66820907592773438) * y_3 + 24.65356063842773438) * y_3 + -19.38941001892089844) * y_3 + 11.06159019470214844) * y_3 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_2)
{
    float _S147 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S148 = 2.0 * sqrt(_S147) - 1.0;
    float _S149 = 3.0 * sqrt(sqrt(clamp(roughness_2, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S148, _S149), 0.00999999977648258, 1.0), clamp((1.0 - _S147) * sheen_shear_0(_S148, _S149), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S148, _S149), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_3, vec3 view_5, float scale_0, float shear_0)
{
    float _S150 = light_3.z;
    bool _S151;
    if(_S150 <= 0.0)
    {
        _S151 = true;
    }
    else
    {
        _S151 = (view_5.z) <= 0.0;
    }
    if(_S151)
    {
        return 0.0;
    }
    vec2 _S152 = view_5.xy;
    float _S153 = dot(_S152, _S152);
    vec2 _S154;
    if(_S153 > 9.99999968265522539e-21)
    {
        _S154 = _S152 * (inversesqrt((_S153)));
    }
    else
    {
        _S154 = vec2(1.0, 0.0);
    }
    float _S155 = scale_0 * dot(light_3.xy, _S154) + shear_0 * _S150;
    float _S156 = scale_0 * (light_3.y * _S154.x - light_3.x * _S154.y);
    float _S157 = _S155 * _S155 + _S156 * _S156 + _S150 * _S150;
    return 0.31830987334251404 * scale_0 * scale_0 * _S150 / max(_S157 * _S157, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_4, vec3 view_6, float strength_0, float roughness_3)
{
    vec3 _S158 = sheen_lobe_0(view_6.z, roughness_3);
    float _S159 = strength_0 * _S158.z;
    return vec2(_S159 * transformed_cosine_0(light_4, view_6, _S158.x, _S158.y), 1.0 - _S159);
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
    quality_0.steps_per_thread_0 = 5.0;
    quality_0.steps_per_relief_0 = 8.0;
    quality_0.shadow_share_0 = 1.0;
    quality_0.refinements_0 = 2U;
    return quality_0;
}

struct Shown_0
{
    bool is_warp_0;
    bool hole_1;
    bool on_top_0;
    uint word_0;
};

struct Crossing_0
{
    Cell_0 warp_4;
    Cell_0 weft_4;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

Shown_0 shown_at_0(Crossing_0 crossing_1, bool back_6)
{
    bool _S160 = (abs(crossing_1.warp_4.across_0)) < (crossing_1.warp_4.half_width_1);
    bool _S161 = (abs(crossing_1.weft_4.across_0)) < (crossing_1.weft_4.half_width_1);
    Shown_0 shown_0;
    bool _S162;
    if(_S160)
    {
        if(!_S161)
        {
            _S162 = true;
        }
        else
        {
            _S162 = crossing_1.warp_above_0;
        }
    }
    else
    {
        _S162 = false;
    }
    shown_0.is_warp_0 = _S162;
    if(!_S160)
    {
        _S162 = !_S161;
    }
    else
    {
        _S162 = false;
    }
    shown_0.hole_1 = _S162;
    uint _S163;
    if(shown_0.is_warp_0)
    {
        _S163 = crossing_1.warp_word_0;
    }
    else
    {
        _S163 = crossing_1.weft_word_0;
    }
    shown_0.word_0 = _S163;
    shown_0.on_top_0 = ((_S163 & 1U) == 1U) != back_6;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_5, Cell_0 second_1)
{
    Cell_0 cell_3;
    uint _S164;
    if(is_first_0)
    {
        _S164 = first_5.thread_0;
    }
    else
    {
        _S164 = second_1.thread_0;
    }
    cell_3.thread_0 = _S164;
    float _S165;
    if(is_first_0)
    {
        _S165 = first_5.across_0;
    }
    else
    {
        _S165 = second_1.across_0;
    }
    cell_3.across_0 = _S165;
    if(is_first_0)
    {
        _S165 = first_5.half_width_1;
    }
    else
    {
        _S165 = second_1.half_width_1;
    }
    cell_3.half_width_1 = _S165;
    if(is_first_0)
    {
        _S165 = first_5.below_0;
    }
    else
    {
        _S165 = second_1.below_0;
    }
    cell_3.below_0 = _S165;
    if(is_first_0)
    {
        _S165 = first_5.above_0;
    }
    else
    {
        _S165 = second_1.above_0;
    }
    cell_3.above_0 = _S165;
    return cell_3;
}

float boundary_0(uint family_10, uint thread_3, int step_0)
{
    vec2 _S166 = turns_and_remainder_0(family_10, float(int(thread_3) + step_0));
    return fma(_S166.x, families_0._data[uint(family_10)].period_0, table_number_0(families_0._data[uint(family_10)].place_table_0 + uint(_S166.y) * 4U));
}

float span_0(uint family_11, uint thread_4, int first_6, int last_1)
{
    if((families_0._data[uint(family_11)].is_alike_0) != 0U)
    {
        return float(last_1 - first_6) * families_0._data[uint(family_11)].size_0;
    }
    return boundary_0(family_11, thread_4, last_1) - boundary_0(family_11, thread_4, first_6);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_12, uint thread_5)
{
    uint _S167 = families_0._data[uint(family_12)].bend_table_0;
    uint _S168;
    if((families_0._data[uint(family_12)].is_alike_0) != 0U)
    {
        _S168 = 0U;
    }
    else
    {
        _S168 = thread_5 * 4U;
    }
    uint _S169 = _S167 + _S168;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S169);
    bend_0.half_tangent_0 = table_number_0(_S169 + 1U);
    bend_0.arc_0 = table_number_0(_S169 + 2U);
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

Run_0 unpack_0(uint own_1, uint other_1, uint thread_6, Cell_0 crossed_0, uint word_1)
{
    int _S170 = int((word_1 >> 1) & 127U);
    int _S171 = int((word_1 >> 8) & 127U);
    int _S172 = int((word_1 >> 15) & 63U);
    int _S173 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S174 = - _S170;
    float _S175 = crossed_0.below_0 + span_0(other_1, crossed_0.thread_0, _S174, 0);
    run_0.from_start_0 = _S175;
    int _S176 = _S171 + 1;
    float _S177 = crossed_0.above_0 + span_0(other_1, crossed_0.thread_0, 1, _S176);
    run_0.to_end_0 = _S177;
    bool _S178 = _S175 < _S177;
    run_0.near_start_0 = _S178;
    int _S179;
    if(_S178)
    {
        _S179 = _S174 - _S172;
    }
    else
    {
        _S179 = _S176;
    }
    int _S180;
    if(run_0.near_start_0)
    {
        _S180 = _S174;
    }
    else
    {
        _S180 = _S176 + _S173;
    }
    run_0.bend_1 = bend_of_0(own_1, thread_6);
    float _S181;
    if(run_0.straight_0)
    {
        _S181 = 1.0e+06;
    }
    else
    {
        _S181 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S181;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_1, crossed_0.thread_0, _S179, _S180), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S170 == 0;
    run_0.last_crossing_0 = _S171 == 0;
    return run_0;
}

float square_1(float x_7)
{
    return x_7 * x_7;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_4)
{
    float _S182 = cell_4.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S183 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S183;
    float _S184 = _S182 * _S182 - square_1(_S183);
    float _S185 = (inversesqrt((_S184)));
    section_0.drop_0 = _S182 - _S184 * _S185;
    section_0.slope_0 = - _S183 * _S185;
    return section_0;
}

float edge_drop_0(uint family_13, uint thread_7, int step_1)
{
    if((families_0._data[uint(family_13)].is_alike_0) != 0U)
    {
        return table_number_0(families_0._data[uint(family_13)].bend_table_0 + 3U);
    }
    return table_number_0(families_0._data[uint(family_13)].bend_table_0 + uint(turns_and_remainder_0(family_13, float(int(thread_7) + step_1)).y) * 4U + 3U);
}

vec2 dive_0(uint other_2, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
{
    bool _S186 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S187 = min(crossed_1.below_0, crossed_1.above_0);
    float _S188;
    if(_S186)
    {
        _S188 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S188 = crossed_1.above_0 + crossed_1.across_0;
    }
    float _S189 = _S188 - crossed_1.half_width_1;
    bool _S190;
    if(_S186)
    {
        _S190 = run_1.first_crossing_0;
    }
    else
    {
        _S190 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S188 = 0.0;
    }
    else
    {
        _S188 = families_0._data[uint(other_2)].height_scale_0 * edge_drop_0(other_2, crossed_1.thread_0, 0);
    }
    float _S191;
    if((shown_1.on_top_0) != _S190)
    {
        _S191 = 0.0;
    }
    else
    {
        float _S192 = families_0._data[uint(other_2)].height_scale_0;
        int _S193;
        if(_S186)
        {
            _S193 = -1;
        }
        else
        {
            _S193 = 1;
        }
        _S191 = _S192 * edge_drop_0(other_2, crossed_1.thread_0, _S193);
    }
    float _S194 = 1.0 / max(2.0 * _S189, 9.999999960041972e-13);
    float _S195 = clamp((_S189 - _S187) * _S194, 0.0, 1.0);
    float _S196 = _S188 + (_S191 - _S188) * (_S195 * _S195 * (3.0 - 2.0 * _S195));
    float _S197 = (_S188 - _S191) * (6.0 * _S195 * (1.0 - _S195) * _S194);
    if(_S186)
    {
        _S188 = 1.0;
    }
    else
    {
        _S188 = -1.0;
    }
    return vec2(_S196, _S197 * _S188);
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

StepControl_0 step_control_0(vec2 direction_3, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129 * step_3;
    float _S198 = direction_3.x;
    control_0.per_x_0 = 1.0 / max(abs(_S198), 9.99999971718068537e-10);
    float _S199 = direction_3.y;
    control_0.per_y_0 = 1.0 / max(abs(_S199), 9.99999971718068537e-10);
    control_0.right_0 = _S198 > 0.0;
    control_0.up_0 = _S199 > 0.0;
    return control_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_1;
    bool known_0;
};

PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    previous_0.clearance_0 = 0.0;
    previous_0.rate_0 = 0.0;
    previous_0.yarn_1 = 0U;
    previous_0.known_0 = false;
    return previous_0;
}

float outline_distance_0(Cell_0 cell_5, Shown_0 shown_2, Run_0 run_2, bool lengthwise_0, bool forwards_0)
{
    float _S200;
    if(forwards_0)
    {
        _S200 = cell_5.across_0;
    }
    else
    {
        _S200 = - cell_5.across_0;
    }
    float _S201;
    if(forwards_0)
    {
        _S201 = cell_5.above_0;
    }
    else
    {
        _S201 = cell_5.below_0;
    }
    bool _S202;
    if(forwards_0)
    {
        _S202 = run_2.last_crossing_0;
    }
    else
    {
        _S202 = run_2.first_crossing_0;
    }
    bool _S203;
    if(forwards_0)
    {
        _S203 = run_2.first_crossing_0;
    }
    else
    {
        _S203 = run_2.last_crossing_0;
    }
    float _S204 = - cell_5.half_width_1;
    bool _S205 = _S200 < _S204;
    bool _S206 = _S200 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S202 = !_S202;
    }
    else
    {
        _S202 = false;
    }
    if(_S202)
    {
        _S202 = !shown_2.hole_1;
    }
    else
    {
        _S202 = false;
    }
    bool _S207;
    if(_S202)
    {
        _S207 = shown_2.on_top_0;
    }
    else
    {
        _S207 = false;
    }
    if(_S207)
    {
        if(_S203)
        {
            _S203 = _S205;
        }
        else
        {
            _S203 = false;
        }
        _S203 = !_S203;
    }
    else
    {
        _S203 = false;
    }
    if(shown_2.hole_1)
    {
        _S202 = true;
    }
    else
    {
        if(_S202)
        {
            _S202 = !shown_2.on_top_0;
        }
        else
        {
            _S202 = false;
        }
    }
    float _S208;
    if(_S205)
    {
        _S208 = _S204;
    }
    else
    {
        _S208 = cell_5.half_width_1;
    }
    float _S209 = _S208 - _S200;
    if(_S202)
    {
        _S200 = 2.0 * _S201 + _S200 - cell_5.half_width_1;
    }
    else
    {
        _S200 = _S201;
    }
    if(_S203)
    {
        if(forwards_0)
        {
            _S200 = run_2.to_end_0;
        }
        else
        {
            _S200 = run_2.from_start_0;
        }
        return _S200;
    }
    if(_S206)
    {
    }
    else
    {
        _S200 = _S209;
    }
    return _S200;
}

struct Probe_0
{
    float height_1;
    bool hole_2;
    float slope_x_0;
    float slope_y_0;
    uint yarn_2;
    float cell_max_0;
    float side_x_0;
    float side_y_0;
    float edge_x_0;
    float edge_y_0;
};

float way_back_to_dip_0(PreviousSample_0 previous_1, float clearance_1, float rate_1, float step_4, Probe_0 here_0)
{
    float _S210 = previous_1.rate_0 * step_4;
    float _S211 = rate_1 * step_4;
    bool _S212;
    if(!previous_1.known_0)
    {
        _S212 = true;
    }
    else
    {
        _S212 = here_0.hole_2;
    }
    if(_S212)
    {
        _S212 = true;
    }
    else
    {
        _S212 = (previous_1.yarn_1) != (here_0.yarn_2);
    }
    if(_S212)
    {
        _S212 = true;
    }
    else
    {
        _S212 = (previous_1.rate_0) >= 0.0;
    }
    if(_S212)
    {
        _S212 = true;
    }
    else
    {
        _S212 = rate_1 <= 0.0;
    }
    if(_S212)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S210) >= 0.0)
    {
        _S212 = (3.0 * clearance_1 - _S211) >= 0.0;
    }
    else
    {
        _S212 = false;
    }
    if(_S212)
    {
        return -1.0;
    }
    float _S213 = clearance_1 - previous_1.clearance_0;
    float _S214 = 6.0 * _S213 - 4.0 * _S210 - 2.0 * _S211;
    float _S215 = -2.0 * _S210 / max(_S214 + sqrt(max(_S214 * _S214 - 4.0 * (3.0 * (_S210 + _S211 - 2.0 * _S213)) * _S210, 0.0)), 9.99999968265522539e-21);
    float _S216 = 1.0 - _S215;
    float _S217 = (previous_1.clearance_0 * (2.0 * _S215 + 1.0) + _S210 * _S215) * _S216 * _S216;
    float _S218 = (clearance_1 * (2.0 * _S216 + 1.0) - _S211 * _S216) * _S215 * _S215;
    if(_S215 > 0.01999999955296516)
    {
        _S212 = _S216 > 0.01999999955296516;
    }
    else
    {
        _S212 = false;
    }
    if(_S212)
    {
        _S212 = (_S217 + _S218) < 0.0;
    }
    else
    {
        _S212 = false;
    }
    float _S219;
    if(_S212)
    {
        _S219 = _S216 * step_4;
    }
    else
    {
        _S219 = -1.0;
    }
    return _S219;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S220;
    if(here_1.hole_2)
    {
        _S220 = 1.0e+09;
    }
    else
    {
        _S220 = clearance_2;
    }
    previous_2.clearance_0 = _S220;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_1 = here_1.yarn_2;
    bool _S221;
    if(!here_1.hole_2)
    {
        _S221 = !is_cell_exit_0;
    }
    else
    {
        _S221 = false;
    }
    previous_2.known_0 = _S221;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_5, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_5.per_x_0, side_y_1 * this_5.per_y_0), 0.0) + this_5.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_6, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S222 = min(here_2.edge_x_0 * this_6.per_x_0, here_2.edge_y_0 * this_6.per_y_0);
    bool _S223;
    if(!here_2.hole_2)
    {
        _S223 = (rate_3 * _S222 + clearance_3) < 0.0;
    }
    else
    {
        _S223 = false;
    }
    if(_S223)
    {
        _S223 = _S222 > (2.0 * this_6.epsilon_0);
    }
    else
    {
        _S223 = false;
    }
    float _S224;
    if(_S223)
    {
        _S224 = _S222 - this_6.epsilon_0;
    }
    else
    {
        _S224 = max(_S222, 0.0) + this_6.epsilon_0;
    }
    return min(this_6.step_2, _S224);
}

struct ViewRay_0
{
    vec2 origin_0;
    vec2 slope_1;
};

vec2 ViewRay_at_0(ViewRay_0 this_7, float height_2)
{
    return this_7.origin_0 + this_7.slope_1 * height_2;
}

float ViewRay_rate_0(ViewRay_0 this_8, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_8.slope_1.x + here_3.slope_y_0 * this_8.slope_1.y - 1.0;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S225 = end_0 - start_1;
    float _S226 = start_rate_0 + end_rate_0 - 2.0 * _S225;
    float _S227 = 3.0 * _S225 - 2.0 * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S225, 9.99999968265522539e-21);
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
        float _S228 = clamp(share_1 - (((_S226 * share_1 + _S227) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0 * _S226 * share_1 + 2.0 * _S227) * share_1 + start_rate_0, 0.10000000149011612 * _S225 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S229 = i_0 + 1;
        share_1 = _S228;
        i_0 = _S229;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

vec2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S230 = along_slope_0 * along_slope_0 + 1.0;
    float _S231 = (inversesqrt((_S230)));
    float _S232 = sine_1 * _S231 * (inversesqrt((_S230 + across_slope_0 * across_slope_0)));
    return vec2(- _S232 * _S230, _S232 * across_slope_0 * along_slope_0 + cosine_0 * _S231);
}

float arc_sine_0(float x_8)
{
    float _S233 = abs(x_8);
    bool _S234 = _S233 > 0.5;
    float _S235;
    if(_S234)
    {
        _S235 = 0.5 * (1.0 - _S233);
    }
    else
    {
        _S235 = _S233 * _S233;
    }
    float _S236;
    if(_S234)
    {
        _S236 = sqrt(max(_S235, 0.0));
    }
    else
    {
        _S236 = _S233;
    }
    float _S237 = ((((0.04216320067644119 * _S235 + 0.02418131195008755) * _S235 + 0.04547002539038658) * _S235 + 0.07495300471782684) * _S235 + 0.16666752099990845) * _S235 * _S236 + _S236;
    if(_S234)
    {
        _S235 = 1.57079637050628662 - 2.0 * _S237;
    }
    else
    {
        _S235 = _S237;
    }
    if(x_8 < 0.0)
    {
        _S235 = - _S235;
    }
    return _S235;
}

struct Hair_0
{
    float cover_0;
    vec3 normal_0;
    vec3 tangent_1;
};

Hair_0 Hair_x24init_0(float cover_1, vec3 normal_1, vec3 tangent_2)
{
    Hair_0 _S238;
    _S238.cover_0 = cover_1;
    _S238.normal_0 = normal_1;
    _S238.tangent_1 = tangent_2;
    return _S238;
}

float fade_0(float size_4, float period_1)
{
    return clamp((1.0 - size_4 / period_1) * 1.33333337306976318, 0.0, 1.0);
}

uint scramble_0(uint value_0)
{
    uint _S239 = value_0 * 747796405U + 2891336453U;
    uint _S240 = ((_S239 >> ((_S239 >> 28) + 4U)) ^ _S239) * 277803737U;
    return (_S240 >> 22) ^ _S240;
}

uint hash_key_0(uint thread_8, uint stream_0)
{
    return scramble_0(thread_8 + scramble_0(stream_0));
}

uint hash_bits_0(uint key_0, uint cell_6)
{
    return scramble_0(cell_6 + key_0);
}

float share_of_0(uint bits_2)
{
    return (float(bits_2 & 1023U) + 0.5) * 0.0009765625;
}

vec2 sine_cosine_0(float x_9)
{
    float _S241 = floor(x_9 * 0.63661974668502808 + 0.5);
    float _S242 = x_9 - _S241 * 1.5703125 - _S241 * 0.00048375129699707 - _S241 * 7.54979012640433211e-08;
    float _S243 = _S242 * _S242;
    float _S244 = ((-0.00019515295571182 * _S243 + 0.00833216123282909) * _S243 - 0.16666655242443085) * _S243 * _S242 + _S242;
    float _S245 = ((0.00002443315679557 * _S243 - 0.00138873164542019) * _S243 + 0.04166664555668831) * _S243 * _S243 - 0.5 * _S243 + 1.0;
    uint _S246 = uint(int(_S241)) & 3U;
    vec2 _S247;
    if((_S246 & 1U) != 0U)
    {
        _S247 = vec2(_S245, _S244);
    }
    else
    {
        _S247 = vec2(_S244, _S245);
    }
    float _S248;
    if((_S246 & 2U) != 0U)
    {
        _S248 = - _S247.x;
    }
    else
    {
        _S248 = _S247.x;
    }
    float _S249;
    if(((_S246 + 1U) & 2U) != 0U)
    {
        _S249 = - _S247.y;
    }
    else
    {
        _S249 = _S247.y;
    }
    return vec2(_S248, _S249);
}

Albedos_0 albedos_of_0(uint family_14, uint thread_9)
{
    return table_albedos_0(families_0._data[uint(family_14)].albedo_table_0 + families_0._data[uint(family_14)].albedo_stride_0 * thread_9);
}

vec3 fibre_cell_0(float across_4, float along_1, float width_2)
{
    float _S250 = floor(across_4 / width_2);
    return vec3(_S250, along_1 / (width_2 * 40.0) + 0.61799997091293335 * _S250, 2.0 * (across_4 / width_2 - _S250) - 1.0);
}

struct SurfacePoint_0
{
    bool hole_3;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_3;
    vec3 normal_2;
    vec3 tangent_3;
    float across_5;
    float fibre_across_0;
    float fibre_along_0;
};

float ply_offset_0(uint family_15, SurfacePoint_0 point_0, bool back_7)
{
    float _S251;
    if(back_7)
    {
        _S251 = - families_0._data[uint(family_15)].ply_sine_0;
    }
    else
    {
        _S251 = families_0._data[uint(family_15)].ply_sine_0;
    }
    float _S252 = (point_0.fibre_across_0 * families_0._data[uint(family_15)].ply_cosine_0 + point_0.fibre_along_0 * _S251) * families_0._data[uint(family_15)].plies_per_mm_0;
    return 2.0 * (_S252 - floor(_S252)) - 1.0;
}

float signed_noise_0(uint bits_3)
{
    return (float(bits_3 & 65535U) + 0.5) * 0.000030517578125 - 1.0;
}

float smooth_share_0(float share_2)
{
    return share_2 * share_2 * (3.0 - 2.0 * share_2);
}

vec2 wave_noise_0(uint key_1, float position_4)
{
    float _S253 = floor(position_4);
    float _S254 = position_4 - _S253;
    uint _S255 = uint(int(_S253));
    float _S256 = signed_noise_0(hash_bits_0(key_1, _S255));
    float _S257 = signed_noise_0(hash_bits_0(key_1, _S255 + 1U));
    return vec2(mix(_S256, _S257, smooth_share_0(_S254)), 6.0 * _S254 * (1.0 - _S254) * (_S257 - _S256));
}

vec2 cell_noise_0(uint key_2, vec3 cell_7)
{
    float _S258 = cell_7.y;
    float _S259 = floor(_S258);
    uint _S260 = uint(int(cell_7.x)) * 65536U + uint(int(_S259));
    uint _S261 = hash_bits_0(key_2, _S260);
    uint _S262 = hash_bits_0(key_2, _S260 + 1U);
    return mix(vec2(signed_noise_0(_S261), signed_noise_0(_S261 >> 16)), vec2(signed_noise_0(_S262), signed_noise_0(_S262 >> 16)), vec2(smooth_share_0(_S258 - _S259)));
}

float uniform_hash_0(uint thread_10, uint cell_8, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_10, stream_1), cell_8)) >> 9) + 0.5) * 1.1920928955078125e-07;
}

float thread_gain_0(uint thread_11, float amount_0, uint seed_3)
{
    return amount_0 * (2.0 * uniform_hash_0(thread_11, 0U, seed_3 ^ 2135587861U) - 1.0) + 1.0;
}

float bounded_gain_0(float gain_0, vec3 albedo_1, vec3 room_0)
{
    vec3 _S263 = room_0 / max(albedo_1, vec3(9.99999997475242708e-07));
    return min(gain_0, max(min(min(_S263.x, _S263.y), _S263.z), 0.0));
}

float flattened_0(float largest_0, vec3 albedo_2, vec3 room_1)
{
    vec3 _S264 = room_1 / max(albedo_2, vec3(9.99999997475242708e-07)) - 1.0;
    return min(max(min(min(_S264.x, _S264.y), _S264.z), 0.0) / max(largest_0, 9.99999997475242708e-07), 1.0);
}

float natural_logarithm_0(float x_10)
{
    uint _S265 = floatBitsToUint(x_10);
    float exponent_0 = float(int(_S265 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S265 & 8388607U) | 1056964608U);
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
    float _S266 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S266 - exponent_1 * 0.00021219444170129 - 0.5 * _S266) + exponent_1 * 0.693359375;
}

float fibre_gain_0(uint thread_12, uint cell_9, float amount_1, uint seed_4)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_12, cell_9, seed_4 ^ 2654435769U)), 10.0) - 1.0) + 1.0;
}

struct YarnFrame_0
{
    vec3 normal_3;
    vec3 tangent_4;
    float loss_0;
};

YarnFrame_0 under_hair_0(YarnFrame_0 frame_0, Hair_0 hair_0)
{
    vec3 _S267;
    if((dot(frame_0.tangent_4, hair_0.tangent_1)) < 0.0)
    {
        _S267 = - hair_0.tangent_1;
    }
    else
    {
        _S267 = hair_0.tangent_1;
    }
    YarnFrame_0 blended_0;
    vec3 _S268 = vec3(hair_0.cover_0);
    vec3 _S269 = normalize(mix(frame_0.normal_3, hair_0.normal_0, _S268));
    blended_0.normal_3 = _S269;
    vec3 _S270 = mix(frame_0.tangent_4, _S267, _S268);
    vec3 _S271 = _S270 - dot(_S270, _S269) * _S269;
    blended_0.tangent_4 = _S271 * (inversesqrt((max(dot(_S271, _S271), 9.999999960041972e-13))));
    blended_0.loss_0 = frame_0.loss_0 * (1.0 - hair_0.cover_0);
    return blended_0;
}

float diffuse_gain_0(YarnFrame_0 frame_1, float blend_0)
{
    return min(0.85000002384185791 * blend_0 * frame_1.loss_0 + 1.0, 1.0 / (0.5 * blend_0 * (frame_1.normal_3.z - 1.0) + 1.0));
}

uint texel_along_0(float share_3, uint first_7, float extent_1, uint count_2)
{
    float _S272 = min(floor(share_3 * extent_1), extent_1 - 1.0);
    float _S273 = float(count_2);
    uint _S274 = first_7 + min(uint(max(_S272 - floor(_S272 / _S273) * _S273, 0.0)), count_2 - 1U);
    uint _S275;
    if(_S274 >= count_2)
    {
        _S275 = _S274 - count_2;
    }
    else
    {
        _S275 = _S274;
    }
    return _S275;
}

uint texel_of_0(Clustered_0 tables_3, TexelBox_0 box_3, vec2 share_4)
{
    return texel_along_0(share_4.y, box_3.first_1.y, box_3.extent_0.y, tables_3.rows_0) * tables_3.columns_0 + texel_along_0(share_4.x, box_3.first_1.x, box_3.extent_0.x, tables_3.columns_0);
}

uint table_byte_0(uint table_1, uint index_3)
{
    return ((words_0._data[uint(table_1 + index_3 / 4U)]) >> (8U * (index_3 & 3U))) & 255U;
}

float diffuse_reflection_0(vec3 light_5, vec3 normal_4, float blend_1)
{
    float _S276 = light_5.z;
    if(_S276 <= 0.0)
    {
        return 0.0;
    }
    return 0.31830987334251404 * mix(max(_S276, 0.0), max(dot(light_5, normal_4), 0.0), blend_1);
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612)
    {
        return (((depth_0 / 120.0 - 0.0416666679084301) * depth_0 + 0.1666666716337204) * depth_0 - 0.5) * depth_0 + 1.0;
    }
    return (1.0 - exponential_0(- depth_0)) / depth_0;
}

float flake_density_0(float squared_along_0, float roughness_4)
{
    float _S277 = roughness_4 * roughness_4;
    float _S278 = squared_along_0 * (1.0 - _S277) + _S277;
    return 0.31830987334251404 * _S277 * roughness_4 / (_S278 * _S278);
}

float density_between_0(vec3 light_6, vec3 view_7, vec3 tangent_5, float roughness_5)
{
    vec3 _S279 = light_6 + view_7;
    float _S280 = dot(_S279, tangent_5);
    return flake_density_0(min(_S280 * _S280 / max(square_0(_S279), 9.999999960041972e-13), 1.0), roughness_5);
}

float transmission_1(vec3 light_7, vec3 view_8, vec3 normal_5, vec3 tangent_6, float roughness_6, float optical_depth_1)
{
    float _S281 = - dot(light_7, normal_5);
    float _S282 = dot(view_8, normal_5);
    bool _S283;
    if(_S281 <= 0.0)
    {
        _S283 = true;
    }
    else
    {
        _S283 = _S282 <= 0.0;
    }
    if(_S283)
    {
        return 0.0;
    }
    float _S284 = 1.0 / max(_S282, 9.99999997475242708e-07);
    float _S285 = projected_area_1(light_7, tangent_6, roughness_6) / max(_S281, 9.99999997475242708e-07);
    float _S286 = projected_area_1(view_8, tangent_6, roughness_6) * _S284;
    return density_between_0(light_7, view_8, tangent_6, roughness_6) * 0.25 * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S285, _S286)) * mean_attenuation_0(optical_depth_1 * abs(_S285 - _S286)) * _S284;
}

float reflection_0(vec3 light_8, vec3 view_9, vec3 normal_6, vec3 tangent_7, float roughness_7, float optical_depth_2)
{
    float _S287 = dot(light_8, normal_6);
    bool _S288;
    if(_S287 <= 0.0)
    {
        _S288 = true;
    }
    else
    {
        _S288 = (dot(view_9, normal_6)) <= 0.0;
    }
    if(_S288)
    {
        return 0.0;
    }
    float _S289 = max(_S287, 9.99999997475242708e-07);
    float _S290 = max(dot(view_9, normal_6), 9.99999997475242708e-07);
    float _S291 = projected_area_1(light_8, tangent_7, roughness_7) * _S290 + projected_area_1(view_9, tangent_7, roughness_7) * _S289;
    float _S292 = optical_depth_2 * _S291 / (_S289 * _S290);
    return 0.25 * density_between_0(light_8, view_9, tangent_7, roughness_7) * (_S292 * mean_attenuation_0(_S292)) * _S289 / _S291;
}

struct ClusteredView_0
{
    ViewedBase_0 base_0;
    FamilyAlbedos_0 albedos_5;
    Bounced_0 bounced_2;
    vec3 view_10;
    bool is_alone_0;
};

ViewedBase_0 viewed_base_0(uint _S293, Footprint_0 _S294, vec3 _S295, float _S296, bool _S297)
{
    ViewedBase_0 seen_1;
    bool _S298 = (_S295.z) < 0.0;
    seen_1.back_5 = _S298;
    seen_1.view_3 = to_face_frame_0(_S295, _S298);
    uint _S299;
    if(_S298)
    {
        _S299 = 1U;
    }
    else
    {
        _S299 = 0U;
    }
    seen_1.face_1 = _S299;
    BinTaps_0 _S300 = bin_taps_0(seen_1.view_3, 16U);
    seen_1.around_1 = _S300;
    uint _S301 = _S299 * 256U;
    Clustered_0 _S302 = fabrics_0._data[uint(_S293)].clustered_0;
    seen_1.box_2 = texel_box_0(fabrics_0._data[uint(_S293)].clustered_0, _S294, vec2(BinTaps_read_0(_S300, fabrics_0._data[uint(_S293)].clustered_0.offset_1, _S301, 2U, 0U), BinTaps_read_0(_S300, fabrics_0._data[uint(_S293)].clustered_0.offset_1, _S301, 2U, 1U)), _S296 - 0.5);
    seen_1.trust_1 = vec2(1.0);
    if(!_S297)
    {
        seen_1.trust_1 = vec2(BinTaps_read_0(seen_1.around_1, _S302.trust_0, _S301, 2U, 0U), BinTaps_read_0(seen_1.around_1, _S302.trust_0, _S301, 2U, 1U));
    }
    return seen_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S303, Footprint_0 _S304, bool _S305)
{
    vec2 _S306 = _S304.dx_0;
    vec2 _S307 = _S304.dy_0;
    vec2 _S308 = sqrt(_S306 * _S306 + _S307 * _S307);
    Stretch_0 _S309 = stretch_of_0(fabrics_0._data[uint(_S303)].warp_0, _S304.centre_0.x, _S308.x);
    Stretch_0 _S310 = stretch_of_0(fabrics_0._data[uint(_S303)].weft_0, _S304.centre_0.y, _S308.y);
    FamilyAlbedos_0 albedos_6;
    albedos_6.warp_3 = mean_albedos_0(fabrics_0._data[uint(_S303)].warp_0, fabrics_0._data[uint(_S303)].weft_0, _S309, _S310, _S305);
    albedos_6.weft_3 = mean_albedos_0(fabrics_0._data[uint(_S303)].weft_0, fabrics_0._data[uint(_S303)].warp_0, _S310, _S309, _S305);
    return albedos_6;
}

float openness_number_0(uint _S311, uint _S312)
{
    return table_number_0(fabrics_0._data[uint(_S311)].openness_0 + _S312);
}

Scattered_0 scattered_by_0(uint _S313, Albedos_0 _S314, uint _S315, vec3 _S316)
{
    uint _S317 = 159U + 2U * _S315;
    Scattered_0 yarn_3;
    yarn_3.back_4 = _S316 * _S314.diffuse_reflect_0 + openness_number_0(_S313, _S317) * _S314.specular_reflect_0;
    yarn_3.through_0 = _S316 * _S314.diffuse_transmit_0 + openness_number_0(_S313, _S317 + 1U) * _S314.specular_transmit_0;
    return yarn_3;
}

void sent_0(uint _S318, uint _S319, vec3 _S320, vec3 _S321, vec3 _S322, vec3 _S323, out vec3 _S324, out vec3 _S325)
{
    uint _S326 = 146U + 4U * _S319;
    float _S327 = openness_number_0(_S318, _S326 + 1U);
    float _S328 = openness_number_0(_S318, _S326 + 2U);
    vec3 _S329 = 1.0 - _S322 * openness_number_0(_S318, _S326);
    vec3 _S330 = 1.0 - _S323 * openness_number_0(_S318, _S326 + 3U);
    vec3 _S331 = 1.0 / (_S329 * _S330 - _S322 * _S323 * (_S327 * _S328));
    _S324 = (_S320 * _S330 + _S322 * _S327 * _S321) * _S331;
    _S325 = (_S321 * _S329 + _S323 * _S328 * _S320) * _S331;
    return;
}

FaceSends_0 face_sends_0(uint _S332, uint _S333, Scattered_0 _S334, Scattered_0 _S335)
{
    uint _S336 = 2U * _S333;
    uint _S337 = 142U + _S336;
    float _S338 = openness_number_0(_S332, _S337);
    float _S339 = openness_number_0(_S332, _S337 + 1U);
    vec3 _S340 = (1.0 - _S338) * _S334.back_4;
    vec3 _S341 = (1.0 - _S339) * _S335.back_4;
    FaceSends_0 sends_1;
    uint _S342 = 154U + _S336;
    float _S343 = openness_number_0(_S332, _S342);
    sends_1.blocks_warp_0 = _S343;
    float _S344 = openness_number_0(_S332, _S342 + 1U);
    sends_1.blocks_weft_0 = _S344;
    sends_1.open_0 = _S343 * _S338 + _S344 * _S339;
    sent_0(_S332, _S333, _S338 * _S334.back_4, _S339 * _S335.back_4, _S340, _S341, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S332, _S333, _S334.through_0, _S335.through_0, _S340, _S341, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S345, vec3 _S346, bool _S347)
{
    Scattered_0 _S348 = scattered_by_0(_S345, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S345)].warp_0)].colour_mean_0), 0U, _S346);
    Scattered_0 _S349 = scattered_by_0(_S345, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S345)].weft_0)].colour_mean_0), 1U, _S346);
    uint _S350;
    if(_S347)
    {
        _S350 = 1U;
    }
    else
    {
        _S350 = 0U;
    }
    FaceSends_0 _S351 = face_sends_0(_S345, _S350, _S348, _S349);
    if(_S347)
    {
        _S350 = 0U;
    }
    else
    {
        _S350 = 1U;
    }
    FaceSends_0 _S352 = face_sends_0(_S345, _S350, _S348, _S349);
    vec3 _S353 = _S351.blocks_warp_0 * _S351.crossing_warp_0 + _S351.blocks_weft_0 * _S351.crossing_weft_0;
    vec3 _S354 = _S352.blocks_warp_0 * _S352.crossing_warp_0 + _S352.blocks_weft_0 * _S352.crossing_weft_0;
    float _S355 = 1.0 - _S351.open_0;
    float _S356 = 1.0 - _S352.open_0;
    vec3 _S357 = 1.0 / (1.0 - _S353 * _S354 * (_S355 * _S356));
    vec3 _S358 = _S354 * (_S351.open_0 + _S355 * (_S351.blocks_warp_0 * _S351.sky_warp_0 + _S351.blocks_weft_0 * _S351.sky_weft_0)) * _S357;
    vec3 _S359 = _S353 * (_S352.open_0 + _S356 * (_S352.blocks_warp_0 * _S352.sky_warp_0 + _S352.blocks_weft_0 * _S352.sky_weft_0)) * _S357;
    FaceRadiance_0 _S360 = face_radiance_0(_S351, _S352.open_0, _S358, _S359);
    FaceRadiance_0 _S361 = face_radiance_0(_S352, _S351.open_0, _S359, _S358);
    Interior_0 interior_1;
    interior_1.warp_2 = _S360.warp_1;
    interior_1.weft_2 = _S360.weft_1;
    interior_1.leaked_1 = _S360.leaked_0;
    interior_1.far_1 = _S361.mean_0;
    interior_1.far_leaked_0 = _S361.leaked_0;
    return interior_1;
}

Blocked_0 blocked_of_terms_0(uint _S362, uint _S363, float  _S364[6], uint _S365)
{
    float  shares_0[3];
    uint share_5 = 0U;
    for(;;)
    {
        if(share_5 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_5] = 0.0;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S365)
            {
            }
            else
            {
                break;
            }
            shares_0[share_5] = shares_0[share_5] + openness_number_0(_S362, _S363 + share_5 * _S365 + term_0) * _S364[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_5] = saturate_0(shares_0[share_5]);
        share_5 = share_5 + 1U;
    }
    Blocked_0 blocked_2;
    blocked_2.by_warp_0 = shares_0[0] * shares_0[2];
    blocked_2.by_weft_0 = shares_0[0] * (1.0 - shares_0[2]);
    blocked_2.far_0 = shares_0[1];
    return blocked_2;
}

Blocked_0 blocked_from_0(uint _S366, vec3 _S367, bool _S368, bool _S369)
{
    float  terms_1[6];
    view_terms_0(_S367, terms_1);
    uint _S370;
    if(_S369)
    {
        _S370 = 2U;
    }
    else
    {
        _S370 = 0U;
    }
    uint _S371;
    if(_S368)
    {
        _S371 = 0U;
    }
    else
    {
        _S371 = 1U;
    }
    return blocked_of_terms_0(_S366, (_S370 + _S371) * 15U, terms_1, 5U);
}

float warp_seen_from_0(uint _S372, vec3 _S373, bool _S374)
{
    float  terms_2[6];
    view_terms_0(_S373, terms_2);
    uint term_1 = 0U;
    float share_6 = 0.0;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S375;
        if(_S374)
        {
            _S375 = 5U;
        }
        else
        {
            _S375 = 0U;
        }
        float share_7 = share_6 + openness_number_0(_S372, 132U + _S375 + term_1) * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_6 = share_7;
    }
    return saturate_0(share_6);
}

Bounced_0 bounced_of_families_0(uint _S376, FamilyAlbedos_0 _S377, vec3 _S378, Interior_0 _S379, Blocked_0 _S380, Blocked_0 _S381)
{
    return sum_of_0(bounced_by_0(_S380, scattered_by_0(_S376, _S377.warp_3, 0U, _S378), _S379), bounced_by_0(_S381, scattered_by_0(_S376, _S377.weft_3, 1U, _S378), _S379));
}

Bounced_0 bounced_far_0(uint _S382, FamilyAlbedos_0 _S383, vec3 _S384, Interior_0 _S385, vec3 _S386, bool _S387, float _S388, float _S389, float _S390)
{
    Blocked_0 _S391 = blocked_from_0(_S382, _S386, true, _S387);
    Blocked_0 _S392 = blocked_from_0(_S382, _S386, false, _S387);
    float _S393 = _S388 / max(1.0 - _S391.by_warp_0 - _S391.by_weft_0, 0.10000000149011612);
    float _S394 = (0.0020000000949949 * warp_seen_from_0(_S382, _S386, _S387) + _S393) / (_S393 + _S389 / max(1.0 - _S392.by_warp_0 - _S392.by_weft_0, 0.10000000149011612) + 0.0020000000949949);
    float _S395 = 1.0 - _S390;
    return bounced_of_families_0(_S382, _S383, _S384, _S385, scaled_0(_S391, _S394 * _S395), scaled_0(_S392, (1.0 - _S394) * _S395));
}

ClusteredView_0 clustered_view_0(uint _S396, Footprint_0 _S397, vec3 _S398, vec3 _S399, uint _S400, bool _S401)
{
    ClusteredView_0 seen_2;
    seen_2.base_0 = viewed_base_0(_S396, _S397, _S398, uniform_of_0(_S400, 0U), _S401);
    seen_2.view_10 = _S398;
    seen_2.is_alone_0 = _S401;
    FamilyAlbedos_0 _S402 = albedos_over_0(_S396, _S397, seen_2.base_0.back_5);
    seen_2.albedos_5.warp_3 = tinted_0(_S402.warp_3, _S399);
    seen_2.albedos_5.weft_3 = tinted_0(_S402.weft_3, _S399);
    const vec3 _S403 = vec3(0.0);
    seen_2.bounced_2.reflected_0 = _S403;
    seen_2.bounced_2.transmitted_0 = _S403;
    if((fabrics_0._data[uint(_S396)].openness_0) != 4294967295U)
    {
        seen_2.bounced_2 = bounced_far_0(_S396, _S402, _S399, interior_of_0(_S396, _S399, seen_2.base_0.back_5), seen_2.base_0.view_3, seen_2.base_0.back_5, 0.0, 0.0, 0.0);
    }
    return seen_2;
}

float clustered_hole_0(uint _S404, ViewedBase_0 _S405)
{
    uint cluster_0 = 0U;
    float covered_0 = 0.0;
    for(;;)
    {
        Clustered_0 _S406 = fabrics_0._data[uint(_S404)].clustered_0;
        if(cluster_0 < (fabrics_0._data[uint(_S404)].clustered_0.clusters_0))
        {
        }
        else
        {
            break;
        }
        float covered_1 = covered_0 + box_mean_0(_S406, _S405.box_2, _S405.face_1, cluster_0);
        cluster_0 = cluster_0 + 1U;
        covered_0 = covered_1;
    }
    return clamp(1.0 - covered_0, 0.0, 1.0);
}

float cluster_density_0(uint _S407, ViewedBase_0 _S408, BaseTaps_0 _S409, uint _S410, uint _S411)
{
    return BinTaps_read_0(_S409.half_vector_0, fabrics_0._data[uint(_S407)].clustered_0.basis_0, _S408.face_1 * 1024U, fabrics_0._data[uint(_S407)].clustered_0.clusters_0 * (1U + fabrics_0._data[uint(_S407)].clustered_0.rank_0), _S411 * fabrics_0._data[uint(_S407)].clustered_0.clusters_0 + _S410);
}

struct ClusterTerms_0
{
    float diffuse_0;
    float specular_0;
    float lit_0;
};

float cluster_attenuation_0(uint _S412, ViewedBase_0 _S413, BaseTaps_0 _S414, uint _S415)
{
    uint _S416 = fabrics_0._data[uint(_S412)].clustered_0.moments_1 + (_S413.face_1 * fabrics_0._data[uint(_S412)].clustered_0.clusters_0 + _S415) * 8U;
    vec3 _S417 = vec3(table_number_0(_S416), table_number_0(_S416 + 1U), table_number_0(_S416 + 2U));
    vec3 _S418 = vec3(table_number_0(_S416 + 3U), table_number_0(_S416 + 4U), table_number_0(_S416 + 5U));
    float _S419 = table_number_0(_S416 + 7U);
    float _S420 = fabrics_0._data[uint(_S412)].optical_depth_0;
    float _S421 = dot(_S414.facing_0, _S417);
    float _S422;
    if(_S414.transmits_1)
    {
        _S422 = - _S421;
    }
    else
    {
        _S422 = _S421;
    }
    float _S423 = max(dot(_S413.view_3, _S417), 0.10000000149011612);
    float _S424 = projected_area_1(_S414.facing_0, _S418, _S419) / max(_S422, 0.10000000149011612);
    float _S425 = projected_area_1(_S413.view_3, _S418, _S419) / _S423;
    if(!_S414.transmits_1)
    {
        float _S426 = _S424 + _S425;
        return 0.25 * (1.0 - exponential_0(- _S420 * _S426)) / (_S426 * _S423);
    }
    float _S427 = max(_S420 * abs(_S424 - _S425), 0.00100000004749745);
    return 0.25 * _S420 * exponential_0(- _S420 * min(_S424, _S425)) * (1.0 - exponential_0(- _S427)) / (_S427 * _S423);
}

ClusterTerms_0 cluster_terms_0(uint _S428, ViewedBase_0 _S429, BaseTaps_0 _S430, uint _S431)
{
    uint _S432 = 2U * fabrics_0._data[uint(_S428)].clustered_0.clusters_0;
    float _S433 = BinTaps_read_0(_S430.around_0, fabrics_0._data[uint(_S428)].clustered_0.light_0, _S430.first_4, _S432, _S431);
    float _S434 = BinTaps_read_0(_S429.around_1, fabrics_0._data[uint(_S428)].clustered_0.view_0, _S429.face_1 * 256U, fabrics_0._data[uint(_S428)].clustered_0.clusters_0, _S431);
    ClusterTerms_0 terms_3;
    float _S435 = _S429.trust_1.x * _S434;
    terms_3.diffuse_0 = _S435 * 0.31830987334251404 * ((1.0 - fabrics_0._data[uint(_S428)].diffuse_blend_0) * abs(_S430.facing_0.z) * _S433 + fabrics_0._data[uint(_S428)].diffuse_blend_0 * BinTaps_read_0(_S430.around_0, fabrics_0._data[uint(_S428)].clustered_0.light_0, _S430.first_4, _S432, fabrics_0._data[uint(_S428)].clustered_0.clusters_0 + _S431));
    terms_3.specular_0 = _S429.trust_1.y * _S434 * _S433 * cluster_attenuation_0(_S428, _S429, _S430, _S431);
    terms_3.lit_0 = _S435 * _S433;
    return terms_3;
}

Components_0 with_cluster_0(uint _S436, Components_0 _S437, ClusterTerms_0 _S438, uint _S439, float _S440, float _S441)
{
    bool _S442 = _S439 < (fabrics_0._data[uint(_S436)].clustered_0.clusters_0 / 2U);
    Components_0 result_2 = _S437;
    float _S443;
    if(_S442)
    {
        _S443 = _S440 * _S438.diffuse_0;
    }
    else
    {
        _S443 = 0.0;
    }
    result_2.diffuse_warp_0 = result_2.diffuse_warp_0 + _S443;
    if(_S442)
    {
        _S443 = 0.0;
    }
    else
    {
        _S443 = _S440 * _S438.diffuse_0;
    }
    result_2.diffuse_weft_0 = result_2.diffuse_weft_0 + _S443;
    if(_S442)
    {
        _S443 = _S438.specular_0 * _S441;
    }
    else
    {
        _S443 = 0.0;
    }
    result_2.specular_warp_0 = result_2.specular_warp_0 + _S443;
    if(_S442)
    {
        _S443 = 0.0;
    }
    else
    {
        _S443 = _S438.specular_0 * _S441;
    }
    result_2.specular_weft_0 = result_2.specular_weft_0 + _S443;
    result_2.light_visibility_1 = result_2.light_visibility_1 + _S440 * _S438.lit_0;
    return result_2;
}

Components_0 clustered_base_0(uint _S444, ViewedBase_0 _S445, BaseTaps_0 _S446)
{
    Clustered_0 _S447 = fabrics_0._data[uint(_S444)].clustered_0;
    Components_0 base_1 = no_components_0();
    uint cluster_1 = 0U;
    for(;;)
    {
        if(cluster_1 < (_S447.clusters_0))
        {
        }
        else
        {
            break;
        }
        float _S448 = box_mean_0(_S447, _S445.box_2, _S445.face_1, cluster_1);
        if(_S448 <= 0.0)
        {
            cluster_1 = cluster_1 + 1U;
            continue;
        }
        float _S449 = _S448 * cluster_density_0(_S444, _S445, _S446, cluster_1, 0U);
        uint number_2 = 1U;
        float density_0 = _S449;
        for(;;)
        {
            if(number_2 <= (_S447.rank_0))
            {
            }
            else
            {
                break;
            }
            float density_1 = density_0 + box_mean_0(_S447, _S445.box_2, _S445.face_1, number_2 * _S447.clusters_0 + cluster_1) * cluster_density_0(_S444, _S445, _S446, cluster_1, number_2);
            number_2 = number_2 + 1U;
            density_0 = density_1;
        }
        base_1 = with_cluster_0(_S444, base_1, cluster_terms_0(_S444, _S445, _S446, cluster_1), cluster_1, _S448, density_0);
        cluster_1 = cluster_1 + 1U;
    }
    return base_1;
}

vec3 under_sheen_0(uint _S450, ClusteredView_0 _S451, vec3 _S452, float _S453, vec3 _S454)
{
    float _S455 = fabrics_0._data[uint(_S450)].sheen_strength_0;
    if((fabrics_0._data[uint(_S450)].sheen_strength_0) <= 0.0)
    {
        return _S452;
    }
    vec2 _S456 = sheen_with_transmittance_0(to_face_frame_0(_S454, _S451.base_0.back_5), _S451.base_0.view_3, _S455, fabrics_0._data[uint(_S450)].sheen_roughness_0);
    return _S456.y * _S452 + _S453 * _S456.x;
}

vec3 clustered_base_value_0(uint _S457, ClusteredView_0 _S458, float _S459, vec3 _S460)
{
    BaseTaps_0 _S461 = base_taps_0(_S458.base_0, _S460);
    Components_0 _S462 = clustered_base_0(_S457, _S458.base_0, _S461);
    return under_sheen_0(_S457, _S458, shaded_0(_S462, _S458.albedos_5, _S461.transmits_1) + (1.0 - _S459) * bounced_value_0(_S458.bounced_2, _S460, _S458.view_10), _S462.light_visibility_1 + _S459, _S460);
}

struct YarnPoint_0
{
    bool back_8;
    bool hole_4;
    bool is_warp_2;
    float x_11;
    float y_4;
    float height_4;
    vec3 normal_7;
    vec3 tangent_8;
    vec3 surface_normal_0;
    float diffuse_gain_1;
    float roughness_8;
    Albedos_0 albedos_7;
};

struct ResidualPoint_0
{
    YarnPoint_0 point_1;
    uint texel_0;
};

struct Hit_0
{
    float x_12;
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

Crossing_0 crossing_at_0(uint _S463, float _S464, float _S465, bool _S466)
{
    Crossing_0 crossing_3;
    crossing_3.warp_4 = locate_0(fabrics_0._data[uint(_S463)].warp_0, _S464);
    crossing_3.weft_4 = locate_0(fabrics_0._data[uint(_S463)].weft_0, _S465);
    uint _S467 = fabrics_0._data[uint(_S463)].run_words_0 + 2U * (crossing_3.weft_4.thread_0 * fabrics_0._data[uint(_S463)].ends_1 + crossing_3.warp_4.thread_0);
    uint _S468 = words_0._data[uint(_S467)];
    crossing_3.warp_word_0 = _S468;
    crossing_3.weft_word_0 = words_0._data[uint(_S467 + 1U)];
    crossing_3.warp_above_0 = ((_S468 & 1U) == 1U) != _S466;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S469, float _S470, float _S471, bool _S472)
{
    Sample_0 sample_0;
    Crossing_0 _S473 = crossing_at_0(_S469, _S470, _S471, _S472);
    sample_0.crossing_2 = _S473;
    Shown_0 _S474 = shown_at_0(_S473, _S472);
    sample_0.shown_3 = _S474;
    uint _S475;
    if(_S474.is_warp_0)
    {
        _S475 = fabrics_0._data[uint(_S469)].warp_0;
    }
    else
    {
        _S475 = fabrics_0._data[uint(_S469)].weft_0;
    }
    uint _S476;
    if(_S474.is_warp_0)
    {
        _S476 = fabrics_0._data[uint(_S469)].weft_0;
    }
    else
    {
        _S476 = fabrics_0._data[uint(_S469)].warp_0;
    }
    Cell_0 _S477 = select_cell_0(_S474.is_warp_0, sample_0.crossing_2.warp_4, sample_0.crossing_2.weft_4);
    Cell_0 _S478 = select_cell_0(_S474.is_warp_0, sample_0.crossing_2.weft_4, sample_0.crossing_2.warp_4);
    Run_0 _S479 = unpack_0(_S475, _S476, _S477.thread_0, _S478, _S474.word_0);
    Section_0 _S480 = section_at_0(_S477);
    bool _S481;
    if(_S474.on_top_0)
    {
        _S481 = (_S479.distance_0) < (_S480.drop_0 * _S479.bend_1.sine_0);
    }
    else
    {
        _S481 = false;
    }
    bool _S482;
    if(_S474.on_top_0)
    {
        _S482 = !_S481;
    }
    else
    {
        _S482 = false;
    }
    float _S483;
    if(_S482)
    {
        _S483 = 1.0;
    }
    else
    {
        _S483 = -1.0;
    }
    float _S484;
    if(_S481)
    {
        _S484 = _S479.other_reach_0;
    }
    else
    {
        _S484 = _S479.reach_0;
    }
    float _S485;
    if(_S481)
    {
        _S485 = _S484 + _S479.distance_0;
    }
    else
    {
        _S485 = max(_S484 - _S479.distance_0, 0.0);
    }
    float _S486 = _S484 / _S479.bend_1.sine_0 - _S483 * _S480.drop_0;
    float _S487 = _S485 * _S485;
    float _S488 = max(_S486 * _S486 - _S487, 9.99999968265522539e-21);
    float _S489 = (inversesqrt((_S488)));
    float _S490 = _S487 / (_S488 * _S489 + _S486);
    bool _S491 = _S485 > 0.0;
    float _S492;
    if(_S474.on_top_0)
    {
        _S492 = 1.0;
    }
    else
    {
        _S492 = -1.0;
    }
    float _S493;
    if(_S479.near_start_0)
    {
        _S493 = 1.0;
    }
    else
    {
        _S493 = -1.0;
    }
    float _S494 = _S492 * _S493;
    if(_S491)
    {
        _S492 = _S486 * _S489;
    }
    else
    {
        _S492 = 1.0;
    }
    sample_0.slope_across_0 = _S480.slope_0 * _S492;
    if(_S491)
    {
        _S485 = _S494 * _S485 * _S489;
    }
    else
    {
        _S485 = 0.0;
    }
    sample_0.slope_along_0 = _S485;
    float _S495 = families_0._data[uint(_S475)].height_scale_0;
    vec2 _S496 = dive_0(_S476, _S474, _S479, _S478);
    if(_S479.straight_0)
    {
        _S483 = 0.0;
    }
    else
    {
        _S483 = _S495 * _S483;
    }
    sample_0.height_6 = _S483 * (_S484 * _S479.bend_1.half_tangent_0 - _S490) - _S495 * _S480.drop_0 - _S496.x;
    float _S497 = _S495 * sample_0.slope_across_0;
    float _S498 = _S495 * sample_0.slope_along_0 - _S496.y;
    if(_S474.is_warp_0)
    {
        _S483 = _S497;
    }
    else
    {
        _S483 = _S498;
    }
    sample_0.slope_x_1 = _S483;
    if(_S474.is_warp_0)
    {
        _S483 = _S498;
    }
    else
    {
        _S483 = _S497;
    }
    sample_0.slope_y_1 = _S483;
    sample_0.run_3 = _S479;
    sample_0.section_1 = _S480;
    return sample_0;
}

float steps_per_length_0(uint _S499, SearchQuality_0 _S500, vec3 _S501)
{
    return max(max(abs(_S501.x) * fabrics_0._data[uint(_S499)].threads_per_x_0, abs(_S501.y) * fabrics_0._data[uint(_S499)].threads_per_y_0) * _S500.steps_per_thread_0, abs(_S501.z) * fabrics_0._data[uint(_S499)].per_relief_0 * _S500.steps_per_relief_0);
}

float cell_maximum_0(uint _S502, Crossing_0 _S503)
{
    uint _S504;
    if(_S503.warp_above_0)
    {
        _S504 = fabrics_0._data[uint(_S502)].warp_0;
    }
    else
    {
        _S504 = fabrics_0._data[uint(_S502)].weft_0;
    }
    uint _S505;
    if(_S503.warp_above_0)
    {
        _S505 = _S503.warp_word_0;
    }
    else
    {
        _S505 = _S503.weft_word_0;
    }
    return float(_S505 >> 28) * families_0._data[uint(_S504)].height_scale_0 * families_0._data[uint(_S504)].level_0;
}

Probe_0 probe_0(uint _S506, float _S507, float _S508, bool _S509, bool _S510, bool _S511)
{
    Sample_0 _S512 = sample_at_0(_S506, _S507, _S508, _S509);
    Probe_0 probe_1;
    probe_1.height_1 = _S512.height_6;
    probe_1.hole_2 = _S512.shown_3.hole_1;
    probe_1.slope_x_0 = _S512.slope_x_1;
    probe_1.slope_y_0 = _S512.slope_y_1;
    uint _S513;
    if(_S512.shown_3.is_warp_0)
    {
        _S513 = _S512.crossing_2.warp_4.thread_0 * 2U + 1U;
    }
    else
    {
        _S513 = _S512.crossing_2.weft_4.thread_0 * 2U;
    }
    probe_1.yarn_2 = _S513;
    probe_1.cell_max_0 = cell_maximum_0(_S506, _S512.crossing_2);
    float _S514;
    if(_S510)
    {
        _S514 = _S512.crossing_2.warp_4.above_0;
    }
    else
    {
        _S514 = _S512.crossing_2.warp_4.below_0;
    }
    probe_1.side_x_0 = _S514;
    if(_S511)
    {
        _S514 = _S512.crossing_2.weft_4.above_0;
    }
    else
    {
        _S514 = _S512.crossing_2.weft_4.below_0;
    }
    probe_1.side_y_0 = _S514;
    probe_1.edge_x_0 = outline_distance_0(_S512.crossing_2.warp_4, _S512.shown_3, _S512.run_3, !_S512.shown_3.is_warp_0, _S510);
    probe_1.edge_y_0 = outline_distance_0(_S512.crossing_2.weft_4, _S512.shown_3, _S512.run_3, _S512.shown_3.is_warp_0, _S511);
    return probe_1;
}

bool is_free_0(uint _S515, SearchQuality_0 _S516, vec3 _S517, vec3 _S518, bool _S519, float _S520)
{
    float _S521 = _S518.z;
    if(_S521 <= 0.0)
    {
        return false;
    }
    float _S522 = 1.0 / max(_S516.shadow_share_0 * steps_per_length_0(_S515, _S516, _S518), 9.99999971718068537e-10);
    StepControl_0 _S523 = step_control_0(_S518.xy, _S522);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S524;
        if(count_3 < 1024U)
        {
            _S524 = (_S517.z + _S521 * distance_1) < _S520;
        }
        else
        {
            _S524 = false;
        }
        if(_S524)
        {
        }
        else
        {
            break;
        }
        vec3 _S525 = _S517 + _S518 * distance_1;
        Probe_0 _S526 = probe_0(_S515, _S525.x, _S525.y, _S519, _S523.right_0, _S523.up_0);
        float _S527 = _S525.z;
        float _S528 = _S527 - _S526.height_1;
        float _S529 = _S521 - _S526.slope_x_0 * _S518.x - _S526.slope_y_0 * _S518.y;
        bool _S530;
        if(!_S526.hole_2)
        {
            _S530 = _S528 < 0.0;
        }
        else
        {
            _S530 = false;
        }
        if(_S530)
        {
            return false;
        }
        float _S531 = way_back_to_dip_0(previous_3, _S528, _S529, last_step_0, _S526);
        if(_S531 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S531;
            distance_1 = distance_1 - _S531;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S532 = _S527 > (_S526.cell_max_0);
        PreviousSample_0 _S533 = after_sample_0(_S528, _S529, _S526, _S532);
        float last_step_2;
        if(_S532)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S523, _S526.side_x_0, _S526.side_y_0), _S522);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S523, _S526, _S528, _S529);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S533;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S534, SearchQuality_0 _S535, float _S536, float _S537, vec3 _S538, bool _S539)
{
    if(!sample_at_0(_S534, _S536, _S537, _S539).shown_3.hole_1)
    {
        return false;
    }
    vec3 _S540 = vec3(_S536, _S537, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S541;
        if(side_0 < 2U)
        {
            _S541 = passes_0;
        }
        else
        {
            _S541 = false;
        }
        if(_S541)
        {
        }
        else
        {
            break;
        }
        vec3 _S542;
        if(side_0 == 0U)
        {
            _S542 = _S538;
        }
        else
        {
            _S542 = vec3(- _S538.x, - _S538.y, _S538.z);
        }
        bool _S543 = is_free_0(_S534, _S535, _S540, _S542, _S539 != (side_0 == 1U), fabrics_0._data[uint(_S534)].height_high_0);
        uint _S544 = side_0 + 1U;
        passes_0 = _S543;
        side_0 = _S544;
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

float max_height_along_0(uint _S545, float _S546, float _S547, float _S548, vec3 _S549, bool _S550)
{
    uint _S551 = locate_0(fabrics_0._data[uint(_S545)].warp_0, _S546).thread_0 / 2U;
    uint _S552 = locate_0(fabrics_0._data[uint(_S545)].weft_0, _S547).thread_0 / 2U;
    float _S553 = _S549.x;
    uint _S554;
    if(_S553 > 0.0)
    {
        _S554 = 1U;
    }
    else
    {
        _S554 = 0U;
    }
    float _S555 = _S549.y;
    uint _S556;
    if(_S555 > 0.0)
    {
        _S556 = 2U;
    }
    else
    {
        _S556 = 0U;
    }
    uint _S557 = words_0._data[uint(fabrics_0._data[uint(_S545)].max_heights_0 + 4U * (_S552 * fabrics_0._data[uint(_S545)].max_height_columns_0 + _S551) + (_S554 + _S556))];
    int number_3;
    if(_S550)
    {
        number_3 = 4;
    }
    else
    {
        number_3 = 0;
    }
    uint _S558 = _S557 >> number_3;
    float _S559 = max(abs(_S553) * fabrics_0._data[uint(_S545)].threads_per_x_0, abs(_S555) * fabrics_0._data[uint(_S545)].threads_per_y_0) / _S549.z;
    float _S560 = fabrics_0._data[uint(_S545)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S545)].height_high_0;
    number_3 = 3;
    for(;;)
    {
        if(number_3 >= 0)
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S548) * _S559) <= (PYRAMID_RADII_0[number_3]))
        {
            max_height_0 = min(max_height_0, float((_S558 >> uint(8 * number_3)) & 15U) * 0.06666667014360428 * _S560);
        }
        number_3 = number_3 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S561, float _S562, float _S563, bool _S564, bool _S565, bool _S566)
{
    Crossing_0 _S567 = crossing_at_0(_S561, _S562, _S563, _S564);
    float _S568 = cell_maximum_0(_S561, _S567);
    float _S569;
    if(_S565)
    {
        _S569 = _S567.warp_4.above_0;
    }
    else
    {
        _S569 = _S567.warp_4.below_0;
    }
    float _S570;
    if(_S566)
    {
        _S570 = _S567.weft_4.above_0;
    }
    else
    {
        _S570 = _S567.weft_4.below_0;
    }
    return vec3(_S568, _S569, _S570);
}

float first_sample_height_0(uint _S571, ViewRay_0 _S572, StepControl_0 _S573, bool _S574)
{
    float _S575 = max_height_along_0(_S571, _S572.origin_0.x, _S572.origin_0.y, 0.0, vec3(_S572.slope_1, 1.0), _S574);
    uint count_4 = 0U;
    float height_8 = _S575;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S576 = ViewRay_at_0(_S572, height_8);
        vec3 _S577 = cell_bounds_0(_S571, _S576.x, _S576.y, _S574, _S573.right_0, _S573.up_0);
        float _S578 = height_8 - _S577.x;
        float _S579 = StepControl_to_cell_exit_0(_S573, _S577.y, _S577.z);
        float height_9 = height_8 - clamp(_S578, 0.0, _S579);
        if(_S578 <= _S579)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S580, ViewRay_0 _S581, StepControl_0 _S582, bool _S583)
{
    float _S584 = fabrics_0._data[uint(_S580)].height_low_0 - (fabrics_0._data[uint(_S580)].height_high_0 - fabrics_0._data[uint(_S580)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_7 = first_sample_height_0(_S580, _S581, _S582, _S583);
    end_1.last_step_3 = _S582.epsilon_0;
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
        vec2 _S585 = ViewRay_at_0(_S581, end_1.height_7);
        Probe_0 _S586 = probe_0(_S580, _S585.x, _S585.y, _S583, _S582.right_0, _S582.up_0);
        float _S587 = end_1.height_7 - _S586.height_1;
        float _S588 = ViewRay_rate_0(_S581, _S586);
        end_1.depth_1 = - _S587;
        end_1.rate_4 = _S588;
        bool _S589;
        if(end_1.previous_4.known_0)
        {
            _S589 = !_S586.hole_2;
        }
        else
        {
            _S589 = false;
        }
        bool _S590;
        if(_S589)
        {
            _S590 = (end_1.previous_4.yarn_1) == (_S586.yarn_2);
        }
        else
        {
            _S590 = false;
        }
        end_1.smooth_0 = _S590;
        bool _S591;
        if(!_S586.hole_2)
        {
            _S591 = _S587 <= 0.0;
        }
        else
        {
            _S591 = false;
        }
        bool _S592;
        if(_S591)
        {
            _S592 = true;
        }
        else
        {
            _S592 = (end_1.height_7) <= _S584;
        }
        if(_S592)
        {
            break;
        }
        float _S593 = way_back_to_dip_0(end_1.previous_4, _S587, _S588, end_1.last_step_3, _S586);
        if(_S593 >= 0.0)
        {
            end_1.height_7 = end_1.height_7 + _S593;
            end_1.last_step_3 = end_1.last_step_3 - _S593;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S594 = min(StepControl_to_cell_exit_0(_S582, _S586.side_x_0, _S586.side_y_0), end_1.height_7 - _S586.cell_max_0);
        float _S595 = StepControl_to_next_sample_0(_S582, _S586, _S587, _S588);
        end_1.previous_4 = after_sample_0(_S587, _S588, _S586, _S594 > _S595);
        float _S596 = max(_S594, _S595);
        end_1.last_step_3 = _S596;
        end_1.height_7 = end_1.height_7 - _S596;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S597, ViewRay_0 _S598, StepControl_0 _S599, bool _S600, ViewRayEnd_0 _S601, uint _S602)
{
    float _S603 = fabrics_0._data[uint(_S597)].height_high_0 - fabrics_0._data[uint(_S597)].height_low_0;
    float above_2 = _S601.height_7 + _S601.last_step_3;
    float above_gap_1 = clamp(_S601.previous_4.clearance_0, 0.0, _S603);
    float under_gap_1 = clamp(_S601.depth_1, 0.0, _S603);
    float _S604 = cubic_root_0(above_gap_1, - under_gap_1, _S601.previous_4.rate_0 * _S601.last_step_3, _S601.rate_4 * _S601.last_step_3);
    float middle_0;
    if(_S601.smooth_0)
    {
        middle_0 = above_2 - _S604 * _S601.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S601.height_7, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S601.height_7;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S602)
        {
        }
        else
        {
            break;
        }
        vec2 _S605 = ViewRay_at_0(_S598, middle_0);
        Probe_0 _S606 = probe_0(_S597, _S605.x, _S605.y, _S600, _S599.right_0, _S599.up_0);
        float _S607;
        if(_S606.hole_2)
        {
            _S607 = -1.0e+09;
        }
        else
        {
            _S607 = _S606.height_1;
        }
        float _S608 = clamp(middle_0 - _S607, - _S603, _S603);
        float _S609;
        if(_S608 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S609 = 0.5 * above_gap_2;
            }
            else
            {
                _S609 = above_gap_2;
            }
            float _S610 = - _S608;
            under_1 = middle_0;
            above_gap_2 = _S609;
            under_gap_2 = _S610;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S609 = 0.5 * under_gap_2;
            }
            else
            {
                _S609 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S608;
            under_gap_2 = _S609;
            side_1 = -1.0;
        }
        if(_S601.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S608 / min(ViewRay_rate_0(_S598, _S606), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S601.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S611, SearchQuality_0 _S612, float _S613, float _S614, vec3 _S615, bool _S616)
{
    float _S617 = max(_S615.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_0 = vec2(_S613, _S614);
    vec2 _S618 = _S615.xy / _S617;
    ray_0.slope_1 = _S618;
    StepControl_0 _S619 = step_control_0(- _S618, 1.0 / max(steps_per_length_0(_S611, _S612, _S615) / _S617, 9.99999971718068537e-10));
    ViewRayEnd_0 _S620 = search_down_0(_S611, ray_0, _S619, _S616);
    Hit_0 hit_0;
    hit_0.hole_5 = false;
    float _S621 = refined_height_0(_S611, ray_0, _S619, _S616, _S620, _S612.refinements_0);
    hit_0.height_5 = _S621;
    vec2 _S622 = ViewRay_at_0(ray_0, _S621);
    hit_0.x_12 = _S622.x;
    hit_0.y_5 = _S622.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S623, SearchQuality_0 _S624, float _S625, float _S626, vec3 _S627, bool _S628)
{
    if(!passes_through_0(_S623, _S624, _S625, _S626, _S627, _S628))
    {
        return first_hit_of_yarn_0(_S623, _S624, _S625, _S626, _S627, _S628);
    }
    Hit_0 hit_1;
    hit_1.x_12 = _S625;
    hit_1.y_5 = _S626;
    hit_1.height_5 = 0.0;
    hit_1.hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S629, float _S630, float _S631, bool _S632)
{
    Sample_0 _S633 = sample_at_0(_S629, _S630, _S631, _S632);
    float _S634;
    if(_S633.shown_3.is_warp_0)
    {
        _S634 = _S633.crossing_2.warp_4.half_width_1;
    }
    else
    {
        _S634 = _S633.crossing_2.weft_4.half_width_1;
    }
    uint _S635;
    if(_S633.shown_3.is_warp_0)
    {
        _S635 = fabrics_0._data[uint(_S629)].warp_0;
    }
    else
    {
        _S635 = fabrics_0._data[uint(_S629)].weft_0;
    }
    float _S636 = families_0._data[uint(_S635)].twist_sine_0;
    float _S637;
    if(_S632)
    {
        _S637 = -1.0;
    }
    else
    {
        _S637 = 1.0;
    }
    float _S638 = _S636 * _S637;
    float _S639 = families_0._data[uint(_S635)].twist_cosine_0;
    if(_S633.shown_3.is_warp_0)
    {
        _S637 = 1.0;
    }
    else
    {
        _S637 = -1.0;
    }
    vec2 _S640 = fibre_direction_0(_S633.slope_across_0, _S637 * _S633.slope_along_0, _S638, _S639);
    float _S641;
    if(_S633.shown_3.is_warp_0)
    {
        _S641 = _S633.slope_x_1;
    }
    else
    {
        _S641 = _S633.slope_y_1;
    }
    float _S642;
    if(_S633.shown_3.is_warp_0)
    {
        _S642 = _S633.slope_y_1;
    }
    else
    {
        _S642 = _S633.slope_x_1;
    }
    float _S643 = _S640.x;
    float _S644 = _S640.y;
    float _S645 = _S641 * _S643 + _S637 * _S642 * _S644;
    float _S646 = _S634 * 1.0154266357421875;
    float _S647 = _S646 * arc_sine_0(clamp(_S633.section_1.across_3 / _S646, -1.0, 1.0));
    if(_S633.shown_3.is_warp_0)
    {
        _S634 = _S631;
    }
    else
    {
        _S634 = - _S630;
    }
    SurfacePoint_0 point_2;
    point_2.hole_3 = _S633.shown_3.hole_1;
    point_2.is_warp_1 = _S633.shown_3.is_warp_0;
    point_2.warp_thread_0 = _S633.crossing_2.warp_4.thread_0;
    point_2.weft_thread_0 = _S633.crossing_2.weft_4.thread_0;
    point_2.height_3 = _S633.height_6;
    point_2.normal_2 = normalize(vec3(- _S633.slope_x_1, - _S633.slope_y_1, 1.0));
    vec3 _S648;
    if(_S633.shown_3.is_warp_0)
    {
        _S648 = vec3(_S643, _S644, _S645);
    }
    else
    {
        _S648 = vec3(- _S644, _S643, _S645);
    }
    point_2.tangent_3 = normalize(_S648);
    point_2.across_5 = _S633.section_1.across_3;
    point_2.fibre_across_0 = _S647 * _S639 + _S634 * _S638;
    point_2.fibre_along_0 = _S634 * _S639 - _S647 * _S638;
    return point_2;
}

bool has_hairs_0(uint _S649)
{
    bool _S650;
    if((families_0._data[uint(fabrics_0._data[uint(_S649)].warp_0)].hairiness_0) > 0.0)
    {
        _S650 = true;
    }
    else
    {
        _S650 = (families_0._data[uint(fabrics_0._data[uint(_S649)].weft_0)].hairiness_0) > 0.0;
    }
    return _S650;
}

Hair_0 hair_at_0(uint _S651, vec2 _S652, bool _S653, float _S654)
{
    float _S655 = fabrics_0._data[uint(_S651)].fibre_size_0;
    float _S656 = 17.0 * fabrics_0._data[uint(_S651)].fibre_size_0;
    float _S657 = fade_0(_S654, _S656);
    vec2 _S658 = _S652 / _S656;
    uint number_4;
    if(_S653)
    {
        number_4 = 1U;
    }
    else
    {
        number_4 = 0U;
    }
    uint _S659 = hash_key_0(number_4, (fabrics_0._data[uint(_S651)].seed_1) ^ 1013904242U);
    float _S660 = 1.0 / max(_S654, 0.07999999821186066 * _S655);
    float _S661 = min(0.63999998569488525 * _S655 * _S660, 1.0);
    const vec2 _S662 = vec2(0.0, 1.0);
    float cover_2 = 0.0;
    float hair_away_0 = 0.0;
    vec2 hair_across_0 = _S662;
    number_4 = 0U;
    for(;;)
    {
        bool _S663;
        if(_S657 > 0.0)
        {
            _S663 = number_4 < 18U;
        }
        else
        {
            _S663 = false;
        }
        if(_S663)
        {
        }
        else
        {
            break;
        }
        uint _S664 = number_4 / 9U;
        uint _S665 = number_4 / 3U - 3U * _S664;
        vec2 _S666 = floor(_S658) + vec2(float(number_4 - 3U * _S665 - 9U * _S664), float(_S665)) - 1.0;
        uint _S667 = hash_bits_0(_S659 + _S664, uint(int(_S666.x)) * 65536U + uint(int(_S666.y)));
        uint _S668 = hash_bits_0(_S659, _S667);
        vec2 _S669 = _S658 - _S666 - vec2(share_of_0(_S667), share_of_0(_S667 >> 10));
        vec2 _S670 = sine_cosine_0(3.14159274101257324 * share_of_0(_S667 >> 20));
        float _S671 = mix(5.0, 16.0, share_of_0(_S668 >> 10)) / 17.0;
        float _S672 = _S669.x;
        float _S673 = _S670.y;
        float _S674 = _S669.y;
        float _S675 = _S670.x;
        float _S676 = (_S672 * _S673 + _S674 * _S675) / _S671;
        float _S677 = 0.69999998807907104 * (2.0 * share_of_0(_S668 >> 20) - 1.0);
        float _S678 = 2.0 * _S677 * _S676;
        float _S679 = (inversesqrt((_S678 * _S678 + 1.0)));
        float _S680 = (_S674 * _S673 - _S672 * _S675 - _S677 * _S671 * _S676 * _S676) * _S679 * 17.0;
        float _S681 = clamp((0.31999999284744263 - abs(_S680)) * _S655 * _S660 + 0.5, 0.0, _S661);
        uint _S682;
        if(((_S668 >> 30) & 1U) == 1U)
        {
            _S682 = fabrics_0._data[uint(_S651)].warp_0;
        }
        else
        {
            _S682 = fabrics_0._data[uint(_S651)].weft_0;
        }
        bool _S683;
        if((share_of_0(_S668)) < (families_0._data[uint(_S682)].hairiness_0))
        {
            _S683 = (abs(_S676)) < 1.0;
        }
        else
        {
            _S683 = false;
        }
        bool _S684;
        if(_S683)
        {
            _S684 = _S681 > cover_2;
        }
        else
        {
            _S684 = false;
        }
        if(_S684)
        {
            vec2 _S685 = vec2(- _S675 - _S678 * _S673, _S673 - _S678 * _S675) * _S679;
            cover_2 = _S681;
            hair_away_0 = _S680;
            hair_across_0 = _S685;
        }
        number_4 = number_4 + 1U;
    }
    float _S686 = clamp(hair_away_0 * 2.5, -0.80000001192092896, 0.80000001192092896);
    Hair_0 hair_1;
    hair_1.cover_0 = _S657 * cover_2;
    hair_1.normal_0 = vec3(_S686 * hair_across_0, sqrt(1.0 - _S686 * _S686));
    hair_1.tangent_1 = vec3(hair_across_0.y, - hair_across_0.x, 0.0);
    return hair_1;
}

bool varies_at_0(uint _S687, float _S688)
{
    bool _S689;
    if((fabrics_0._data[uint(_S687)].fibre_noise_0) > 0.0)
    {
        _S689 = true;
    }
    else
    {
        _S689 = (fabrics_0._data[uint(_S687)].colour_noise_0) > 0.0;
    }
    if(_S689)
    {
        _S689 = true;
    }
    else
    {
        if((fabrics_0._data[uint(_S687)].has_detail_0) != 0U)
        {
            _S689 = _S688 >= 0.0;
        }
        else
        {
            _S689 = false;
        }
    }
    return _S689;
}

uint thread_number_0(uint _S690, SurfacePoint_0 _S691, float _S692, float _S693)
{
    float _S694;
    if(_S691.is_warp_1)
    {
        _S694 = _S692;
    }
    else
    {
        _S694 = _S693;
    }
    float _S695 = _S694 - _S691.across_5;
    uint _S696;
    if(_S691.is_warp_1)
    {
        _S696 = fabrics_0._data[uint(_S690)].warp_0;
    }
    else
    {
        _S696 = fabrics_0._data[uint(_S690)].weft_0;
    }
    float _S697 = families_0._data[uint(_S696)].period_0;
    int _S698 = int(families_0._data[uint(_S696)].count_0);
    if(_S691.is_warp_1)
    {
        _S696 = _S691.warp_thread_0;
    }
    else
    {
        _S696 = _S691.weft_thread_0;
    }
    uint _S699 = uint(int(floor(_S695 / _S697)) * _S698 + int(_S696)) * 2U;
    if(_S691.is_warp_1)
    {
        _S696 = 1U;
    }
    else
    {
        _S696 = 0U;
    }
    return _S699 + _S696;
}

struct FibreNoise_0
{
    vec2 bundle_0;
    float bundle_weight_0;
    vec2 fibre_0;
    float fibre_weight_0;
    float offset_4;
    float slope_2;
};

FibreNoise_0 fibre_noise_at_0(uint _S700, uint _S701, SurfacePoint_0 _S702, uint _S703, float _S704)
{
    float _S705 = 5.0 * fabrics_0._data[uint(_S700)].fibre_size_0;
    vec2 _S706 = wave_noise_0(hash_key_0(_S703, (fabrics_0._data[uint(_S700)].seed_1) ^ 458671337U), _S702.fibre_along_0 / (25.0 * fabrics_0._data[uint(_S700)].fibre_size_0));
    float _S707 = _S702.fibre_across_0 + families_0._data[uint(_S701)].fibre_tilt_0 * 0.5 * 25.0 * fabrics_0._data[uint(_S700)].fibre_size_0 * _S706.x;
    vec3 _S708 = fibre_cell_0(_S707, _S702.fibre_along_0, fabrics_0._data[uint(_S700)].fibre_size_0);
    FibreNoise_0 noise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S703, (fabrics_0._data[uint(_S700)].seed_1) ^ 1757159915U), fibre_cell_0(_S707, _S702.fibre_along_0, _S705));
    noise_0.bundle_weight_0 = fade_0(_S704, _S705);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S703, (fabrics_0._data[uint(_S700)].seed_1) ^ 48610963U), _S708);
    noise_0.fibre_weight_0 = fade_0(_S704, fabrics_0._data[uint(_S700)].fibre_size_0);
    noise_0.offset_4 = _S708.z;
    noise_0.slope_2 = 0.5 * _S706.y;
    return noise_0;
}

vec2 detail_gain_0(uint _S709, uint _S710, SurfacePoint_0 _S711, vec2 _S712, bool _S713, uint _S714, float _S715)
{
    const vec2 _S716 = vec2(0.0);
    vec2 gain_1;
    if((families_0._data[uint(_S710)].has_plies_0) > 0.0)
    {
        gain_1 = 0.60000002384185791 * fade_0(_S715, 1.0 / families_0._data[uint(_S710)].plies_per_mm_0) * vec2(0.20000000298023224 - square_1(square_1(ply_offset_0(_S710, _S711, _S713))), 0.20000000298023224);
    }
    else
    {
        gain_1 = _S716;
    }
    if((families_0._data[uint(_S710)].fibre_tone_0) > 0.0)
    {
        FibreNoise_0 _S717 = fibre_noise_at_0(_S709, _S710, _S711, _S714, _S715);
        gain_1 = gain_1 + families_0._data[uint(_S710)].fibre_tone_0 * vec2(_S717.bundle_weight_0 * _S717.bundle_0.y + _S717.fibre_weight_0 * _S717.fibre_0.y, _S717.bundle_weight_0 + _S717.fibre_weight_0);
    }
    if((families_0._data[uint(_S710)].slub_0) > 0.0)
    {
        float _S718 = 0.25 * families_0._data[uint(_S710)].slub_0 * fade_0(_S715, 1.0 / families_0._data[uint(_S710)].slubs_per_mm_0);
        float _S719;
        if(_S711.is_warp_1)
        {
            _S719 = _S712.y;
        }
        else
        {
            _S719 = - _S712.x;
        }
        gain_1 = gain_1 + _S718 * vec2(wave_noise_0(hash_key_0(_S714, (fabrics_0._data[uint(_S709)].seed_1) ^ 1373058189U), _S719 * families_0._data[uint(_S710)].slubs_per_mm_0).x * mix(0.40000000596046448, 1.0, min(square_1(_S711.across_5 * families_0._data[uint(_S710)].per_half_width_0), 1.0)), 1.0);
    }
    return gain_1;
}

Albedos_0 vary_albedos_0(uint _S720, Albedos_0 _S721, uint _S722, uint _S723, vec2 _S724)
{
    vec3 _S725 = max(_S721.specular_reflect_0, _S721.specular_transmit_0);
    vec3 _S726 = _S721.diffuse_reflect_0 + _S721.diffuse_transmit_0;
    vec3 _S727 = 1.0 - fabrics_0._data[uint(_S720)].layer_bound_0 * _S725;
    float colour_0 = bounded_gain_0(thread_gain_0(_S722, fabrics_0._data[uint(_S720)].colour_noise_0, fabrics_0._data[uint(_S720)].seed_1), _S726, _S727);
    float colour_1 = colour_0 * (1.0 + flattened_0(_S724.y, colour_0 * _S726, _S727) * _S724.x);
    float _S728 = bounded_gain_0(fibre_gain_0(_S722, _S723, fabrics_0._data[uint(_S720)].fibre_noise_0, fabrics_0._data[uint(_S720)].seed_1), _S725, min((1.0 - colour_1 * _S726) / fabrics_0._data[uint(_S720)].layer_bound_0, vec3(1.0)));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = colour_1 * _S721.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = colour_1 * _S721.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S728 * _S721.specular_reflect_0;
    varied_0.specular_transmit_0 = _S728 * _S721.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S729, SurfacePoint_0 _S730, Albedos_0 _S731, float _S732, float _S733, bool _S734, float _S735, float _S736)
{
    uint _S737 = thread_number_0(_S729, _S730, _S732, _S733);
    vec3 _S738 = fibre_cell_0(_S730.fibre_across_0, _S730.fibre_along_0, fabrics_0._data[uint(_S729)].fibre_size_0);
    const vec2 _S739 = vec2(0.0);
    bool _S740;
    if((fabrics_0._data[uint(_S729)].has_detail_0) != 0U)
    {
        _S740 = _S735 >= 0.0;
    }
    else
    {
        _S740 = false;
    }
    vec2 gain_2;
    if(_S740)
    {
        uint _S741;
        if(_S730.is_warp_1)
        {
            _S741 = fabrics_0._data[uint(_S729)].warp_0;
        }
        else
        {
            _S741 = fabrics_0._data[uint(_S729)].weft_0;
        }
        gain_2 = detail_gain_0(_S729, _S741, _S730, vec2(_S732, _S733), _S734, _S737, _S735) * vec2(1.0 - _S736, 1.0);
    }
    else
    {
        gain_2 = _S739;
    }
    return vary_albedos_0(_S729, _S731, _S737, uint(int(_S738.x)) * 65536U + uint(int(floor(_S738.y))), gain_2);
}

YarnFrame_0 turned_frame_0(uint _S742, uint _S743, SurfacePoint_0 _S744, bool _S745, uint _S746, float _S747)
{
    YarnFrame_0 frame_2;
    frame_2.normal_3 = _S744.normal_2;
    frame_2.tangent_4 = _S744.tangent_3;
    frame_2.loss_0 = 0.0;
    if((families_0._data[uint(_S743)].has_plies_0) > 0.0)
    {
        float _S748 = fade_0(_S747, 1.0 / families_0._data[uint(_S743)].plies_per_mm_0);
        float _S749 = _S748 * 0.41999998688697815 * ply_offset_0(_S743, _S744, _S745);
        float _S750 = sqrt(1.0 - _S749 * _S749);
        float _S751;
        if(_S745)
        {
            _S751 = - families_0._data[uint(_S743)].ply_sine_0;
        }
        else
        {
            _S751 = families_0._data[uint(_S743)].ply_sine_0;
        }
        vec3 _S752 = cross(frame_2.tangent_4, frame_2.normal_3);
        vec3 _S753 = families_0._data[uint(_S743)].ply_cosine_0 * _S752 + _S751 * frame_2.tangent_4;
        frame_2.tangent_4 = families_0._data[uint(_S743)].ply_cosine_0 * (families_0._data[uint(_S743)].ply_cosine_0 * frame_2.tangent_4 - _S751 * _S752) + _S751 * (_S750 * _S753 - _S749 * frame_2.normal_3);
        frame_2.normal_3 = _S750 * frame_2.normal_3 + _S749 * _S753;
        frame_2.loss_0 = _S748 * _S748 * 0.41999998688697815 * 0.41999998688697815 / 6.0;
    }
    float _S754 = families_0._data[uint(_S743)].fibre_tilt_0;
    if((families_0._data[uint(_S743)].fibre_tilt_0) > 0.0)
    {
        FibreNoise_0 _S755 = fibre_noise_at_0(_S742, _S743, _S744, _S746, _S747);
        float _S756 = 1.09858846664428711 * _S754 * (_S755.bundle_weight_0 * _S755.bundle_0.x + _S755.fibre_weight_0 * (_S755.fibre_0.x + _S755.offset_4));
        float _S757 = _S754 * (1.42099642753601074 * (_S755.bundle_weight_0 * _S755.bundle_0.y + _S755.fibre_weight_0 * _S755.fibre_0.y) - _S755.bundle_weight_0 * _S755.slope_2);
        float _S758 = square_1(_S755.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5 * _S754 * _S754 * ((0.24761904776096344 * (square_1(_S755.bundle_weight_0) + _S758) + _S758 / 3.0) * 1.09858846664428711 * 1.09858846664428711);
        vec3 _S759 = cross(frame_2.tangent_4, frame_2.normal_3);
        vec2 _S760 = sine_cosine_0(_S756);
        vec2 _S761 = sine_cosine_0(_S757);
        float _S762 = _S760.y;
        float _S763 = _S760.x;
        vec3 _S764 = _S762 * _S759 - _S763 * frame_2.normal_3;
        frame_2.normal_3 = _S762 * frame_2.normal_3 + _S763 * _S759;
        frame_2.tangent_4 = _S761.y * frame_2.tangent_4 + _S761.x * _S764;
    }
    return frame_2;
}

YarnPoint_0 yarn_point_of_0(uint _S765, SurfacePoint_0 _S766, float _S767, float _S768, bool _S769, bool _S770, float _S771)
{
    uint _S772;
    if(_S766.is_warp_1)
    {
        _S772 = fabrics_0._data[uint(_S765)].warp_0;
    }
    else
    {
        _S772 = fabrics_0._data[uint(_S765)].weft_0;
    }
    bool _S773;
    if((fabrics_0._data[uint(_S765)].has_detail_0) != 0U)
    {
        _S773 = _S771 >= 0.0;
    }
    else
    {
        _S773 = false;
    }
    const vec3 _S774 = vec3(0.0);
    Hair_0 _S775 = Hair_x24init_0(0.0, _S774, _S774);
    bool _S776;
    if(_S773)
    {
        _S776 = has_hairs_0(_S765);
    }
    else
    {
        _S776 = false;
    }
    Hair_0 hair_2;
    if(_S776)
    {
        hair_2 = hair_at_0(_S765, vec2(_S767, _S768), _S769, _S771);
    }
    else
    {
        hair_2 = _S775;
    }
    uint _S777;
    if(_S766.is_warp_1)
    {
        _S777 = _S766.warp_thread_0;
    }
    else
    {
        _S777 = _S766.weft_thread_0;
    }
    Albedos_0 albedos_8 = albedos_of_0(_S772, _S777);
    Albedos_0 albedos_9;
    if(varies_at_0(_S765, _S771))
    {
        albedos_9 = varied_at_0(_S765, _S766, albedos_8, _S767, _S768, _S769, _S771, hair_2.cover_0);
    }
    else
    {
        albedos_9 = albedos_8;
    }
    YarnPoint_0 point_3;
    point_3.back_8 = _S769;
    point_3.hole_4 = _S770;
    point_3.is_warp_2 = _S766.is_warp_1;
    point_3.x_11 = _S767;
    point_3.y_4 = _S768;
    point_3.height_4 = _S766.height_3;
    point_3.normal_7 = _S766.normal_2;
    point_3.tangent_8 = _S766.tangent_3;
    point_3.surface_normal_0 = _S766.normal_2;
    point_3.diffuse_gain_1 = 1.0;
    if(_S773)
    {
        YarnFrame_0 _S778 = turned_frame_0(_S765, _S772, _S766, _S769, thread_number_0(_S765, _S766, _S767, _S768), _S771);
        YarnFrame_0 frame_3;
        if(has_hairs_0(_S765))
        {
            frame_3 = under_hair_0(_S778, hair_2);
        }
        else
        {
            frame_3 = _S778;
        }
        point_3.normal_7 = frame_3.normal_3;
        point_3.tangent_8 = frame_3.tangent_4;
        point_3.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0._data[uint(_S765)].diffuse_blend_0);
    }
    point_3.roughness_8 = families_0._data[uint(_S772)].roughness_0;
    point_3.albedos_7 = albedos_9;
    return point_3;
}

YarnPoint_0 locate_yarn_0(uint _S779, SearchQuality_0 _S780, float _S781, float _S782, vec3 _S783, float _S784)
{
    bool _S785 = (_S783.z) < 0.0;
    Hit_0 _S786 = first_hit_0(_S779, _S780, _S781, _S782, to_face_frame_0(_S783, _S785), _S785);
    return yarn_point_of_0(_S779, surface_at_0(_S779, _S786.x_12, _S786.y_5, _S785), _S786.x_12, _S786.y_5, _S785, _S786.hole_5, _S784);
}

YarnPoint_0 locate_yarn_1(uint _S787, SearchQuality_0 _S788, float _S789, float _S790, vec3 _S791)
{
    return locate_yarn_0(_S787, _S788, _S789, _S790, _S791, -1.0);
}

ResidualPoint_0 residual_point_0(uint _S792, ViewedBase_0 _S793, vec3 _S794, uint _S795, uint _S796)
{
    uint _S797 = _S795 + _S796 * 1663821227U;
    vec2 _S798 = vec2(uniform_of_0(_S797, 1U), uniform_of_0(_S797, 2U));
    vec2 _S799 = _S793.box_2.corner_1 + _S798 * _S793.box_2.size_2;
    ResidualPoint_0 result_3;
    result_3.point_1 = locate_yarn_1(_S792, default_quality_0(), _S799.x, _S799.y, _S794);
    result_3.texel_0 = texel_of_0(fabrics_0._data[uint(_S792)].clustered_0, _S793.box_2, _S798);
    return result_3;
}

Components_0 clustered_at_texel_0(uint _S800, ViewedBase_0 _S801, uint _S802, BaseTaps_0 _S803)
{
    Clustered_0 _S804 = fabrics_0._data[uint(_S800)].clustered_0;
    uint _S805 = _S801.face_1 * fabrics_0._data[uint(_S800)].clustered_0.columns_0 * fabrics_0._data[uint(_S800)].clustered_0.rows_0 + _S802;
    uint _S806 = table_byte_0(fabrics_0._data[uint(_S800)].clustered_0.labels_0, _S805);
    Components_0 base_2 = no_components_0();
    if(_S806 >= (fabrics_0._data[uint(_S800)].clustered_0.clusters_0))
    {
        return base_2;
    }
    float _S807 = cluster_density_0(_S800, _S801, _S803, _S806, 0U);
    uint number_5 = 1U;
    float density_2 = _S807;
    for(;;)
    {
        if(number_5 <= (_S804.rank_0))
        {
        }
        else
        {
            break;
        }
        int _S808 = int(table_byte_0(_S804.coefficients_0, _S805 * _S804.rank_0 + number_5 - 1U));
        int _S809;
        if(_S808 > 127)
        {
            _S809 = _S808 - 256;
        }
        else
        {
            _S809 = _S808;
        }
        float density_3 = density_2 + float(_S809) * cluster_density_0(_S800, _S801, _S803, _S806, number_5);
        number_5 = number_5 + 1U;
        density_2 = density_3;
    }
    return with_cluster_0(_S800, base_2, cluster_terms_0(_S800, _S801, _S803, _S806), _S806, 1.0, density_2);
}

bool unoccluded_0(uint _S810, SearchQuality_0 _S811, float _S812, float _S813, float _S814, vec3 _S815, bool _S816)
{
    if((_S815.z) <= 0.0)
    {
        return false;
    }
    return is_free_0(_S810, _S811, vec3(_S812, _S813, _S814 + fabrics_0._data[uint(_S810)].lift_0), _S815, _S816, max_height_along_0(_S810, _S812, _S813, _S814, _S815, _S816));
}

bool is_lit_0(uint _S817, SearchQuality_0 _S818, YarnPoint_0 _S819, vec3 _S820)
{
    if(_S819.hole_4)
    {
        return true;
    }
    vec3 _S821 = to_face_frame_0(_S820, _S819.back_8);
    float _S822 = _S821.z;
    bool _S823 = _S822 < 0.0;
    vec3 normal_8;
    float height_10;
    if(_S823)
    {
        SurfacePoint_0 _S824 = surface_at_0(_S817, _S819.x_11, _S819.y_4, !_S819.back_8);
        normal_8 = _S824.normal_2;
        height_10 = _S824.height_3;
    }
    else
    {
        normal_8 = _S819.surface_normal_0;
        height_10 = _S819.height_4;
    }
    vec3 _S825 = vec3(_S821.xy, abs(_S822));
    if((dot(normal_8, _S825)) <= 0.0)
    {
        return false;
    }
    return unoccluded_0(_S817, _S818, _S819.x_11, _S819.y_4, height_10, _S825, (_S819.back_8) != _S823);
}

Components_0 components_of_point_0(uint _S826, SearchQuality_0 _S827, YarnPoint_0 _S828, vec3 _S829, vec3 _S830)
{
    Components_0 result_4 = no_components_0();
    float _S831;
    if(_S828.hole_4)
    {
        _S831 = 1.0;
    }
    else
    {
        _S831 = 0.0;
    }
    result_4.hole_0 = _S831;
    bool _S832;
    if(_S828.hole_4)
    {
        _S832 = true;
    }
    else
    {
        _S832 = !is_lit_0(_S826, _S827, _S828, _S829);
    }
    if(_S832)
    {
        return result_4;
    }
    vec3 _S833 = to_face_frame_0(_S829, _S828.back_8);
    vec3 _S834 = to_face_frame_0(_S830, _S828.back_8);
    bool _S835 = (_S833.z) < 0.0;
    vec3 _S836;
    if(_S835)
    {
        _S836 = - _S833;
    }
    else
    {
        _S836 = _S833;
    }
    float _S837 = _S828.diffuse_gain_1 * diffuse_reflection_0(_S836, _S828.normal_7, fabrics_0._data[uint(_S826)].diffuse_blend_0);
    if(_S835)
    {
        _S831 = transmission_1(_S833, _S834, _S828.normal_7, _S828.tangent_8, _S828.roughness_8, fabrics_0._data[uint(_S826)].optical_depth_0);
    }
    else
    {
        _S831 = reflection_0(_S833, _S834, _S828.normal_7, _S828.tangent_8, _S828.roughness_8, fabrics_0._data[uint(_S826)].optical_depth_0);
    }
    float _S838;
    if(_S828.is_warp_2)
    {
        _S838 = _S837;
    }
    else
    {
        _S838 = 0.0;
    }
    result_4.diffuse_warp_0 = _S838;
    if(_S828.is_warp_2)
    {
        _S838 = 0.0;
    }
    else
    {
        _S838 = _S837;
    }
    result_4.diffuse_weft_0 = _S838;
    if(_S828.is_warp_2)
    {
        _S838 = _S831;
    }
    else
    {
        _S838 = 0.0;
    }
    result_4.specular_warp_0 = _S838;
    if(_S828.is_warp_2)
    {
        _S831 = 0.0;
    }
    result_4.specular_weft_0 = _S831;
    result_4.light_visibility_1 = 1.0;
    return result_4;
}

vec3 clustered_residual_0(uint _S839, ClusteredView_0 _S840, ResidualPoint_0 _S841, vec3 _S842, vec3 _S843)
{
    BaseTaps_0 _S844 = base_taps_0(_S840.base_0, _S843);
    Components_0 _S845 = clustered_at_texel_0(_S839, _S840.base_0, _S841.texel_0, _S844);
    Components_0 _S846 = components_of_point_0(_S839, default_quality_0(), _S841.point_1, _S843, _S840.view_10);
    FamilyAlbedos_0 own_2;
    Albedos_0 _S847 = tinted_0(_S841.point_1.albedos_7, _S842);
    own_2.warp_3 = _S847;
    own_2.weft_3 = _S847;
    return under_sheen_0(_S839, _S840, shaded_0(_S846, own_2, _S844.transmits_1) - shaded_0(_S845, _S840.albedos_5, _S844.transmits_1) - _S846.hole_0 * bounced_value_0(_S840.bounced_2, _S843, _S840.view_10), _S846.light_visibility_1 + _S846.hole_0 - _S845.light_visibility_1, _S843);
}

float passed_by_sheen_0(uint _S848, float _S849, vec3 _S850)
{
    float _S851 = fabrics_0._data[uint(_S848)].sheen_strength_0;
    if((fabrics_0._data[uint(_S848)].sheen_strength_0) <= 0.0)
    {
        return _S849;
    }
    return _S849 * (1.0 - _S851 * sheen_lobe_0(abs(_S850.z), fabrics_0._data[uint(_S848)].sheen_roughness_0).z);
}

vec4 clustered_value_0(uint _S852, Footprint_0 _S853, vec3 _S854, vec3 _S855, uint _S856, uint _S857)
{
    const vec3 _S858 = vec3(1.0);
    bool _S859 = _S857 == 0U;
    ClusteredView_0 _S860 = clustered_view_0(_S852, _S853, _S855, _S858, _S856, _S859);
    float hole_6;
    if(_S859)
    {
        hole_6 = clustered_hole_0(_S852, _S860.base_0);
    }
    else
    {
        hole_6 = 0.0;
    }
    vec3 _S861 = clustered_base_value_0(_S852, _S860, hole_6, _S854);
    uint number_6 = 0U;
    vec3 value_1 = _S861;
    for(;;)
    {
        if(number_6 < _S857)
        {
        }
        else
        {
            break;
        }
        ResidualPoint_0 _S862 = residual_point_0(_S852, _S860.base_0, _S855, _S856, number_6);
        float _S863 = float(_S857);
        vec3 value_2 = value_1 + clustered_residual_0(_S852, _S860, _S862, _S858, _S854) / _S863;
        float _S864;
        if(_S862.point_1.hole_4)
        {
            _S864 = 1.0;
        }
        else
        {
            _S864 = 0.0;
        }
        float hole_7 = hole_6 + _S864 / _S863;
        number_6 = number_6 + 1U;
        value_1 = value_2;
        hole_6 = hole_7;
    }
    return vec4(value_1, passed_by_sheen_0(_S852, hole_6, _S855));
}

vec4 cloth_value_0(uint fabric_1, vec2 centre_3, vec2 dx_2, vec2 dy_2, vec3 light_9, vec3 view_11)
{
    Footprint_0 _S865 = footprint_of_0(centre_3, dx_2, dy_2);
    return clustered_value_0(fabric_1, _S865, light_9, view_11, hashed_0(_S865, view_11, vec2(fabrics_0._data[uint(fabric_1)].clustered_0.texel_width_0 * float(fabrics_0._data[uint(fabric_1)].clustered_0.columns_0), fabrics_0._data[uint(fabric_1)].clustered_0.texel_height_0 * float(fabrics_0._data[uint(fabric_1)].clustered_0.rows_0))), 0U);
}

vec4 cloth_estimate_0(uint fabric_2, vec2 centre_4, vec2 dx_3, vec2 dy_3, vec3 light_10, vec3 view_12, uint seed_5)
{
    return clustered_value_0(fabric_2, footprint_of_0(centre_4, dx_3, dy_3), light_10, view_12, mixed_0(seed_5), max(fabrics_0._data[uint(fabric_2)].clustered_0.samples_0, 1U));
}

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
void main()
{
    if((gl_GlobalInvocationID.x) >= (query_count_0._data[uint(0)]))
    {
        return;
    }
    Query_0 _S866 = queries_0._data[uint(gl_GlobalInvocationID.x)];
    vec2 _S867 = vec2(_S866.centre_x_0, _S866.centre_y_0);
    vec2 _S868 = vec2(_S866.dx_x_0, _S866.dx_y_0);
    vec2 _S869 = vec2(_S866.dy_x_0, _S866.dy_y_0);
    vec3 _S870 = vec3(_S866.light_x_0, _S866.light_y_0, _S866.light_z_0);
    vec3 _S871 = vec3(_S866.view_x_0, _S866.view_y_0, _S866.view_z_0);
    if((_S866.seed_0) == 0U)
    {
        answers_0._data[uint(gl_GlobalInvocationID.x)] = cloth_value_0(_S866.fabric_0, _S867, _S868, _S869, _S870, _S871);
    }
    else
    {
        answers_0._data[uint(gl_GlobalInvocationID.x)] = cloth_estimate_0(_S866.fabric_0, _S867, _S868, _S869, _S870, _S871, _S866.seed_0);
    }
    return;
}

