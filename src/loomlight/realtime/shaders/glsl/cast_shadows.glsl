#version 450
layout(row_major) uniform;
layout(row_major) buffer;
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

layout(std430, binding = 4) readonly buffer StructuredBuffer_Frame_t_0 {
    Frame_0 _data[];
} frames_0;
struct Layer_0
{
    uint face_0;
    float share_0;
};

layout(std430, binding = 12) buffer StructuredBuffer_Layer_t_0 {
    Layer_0 _data[];
} layers_0;
layout(std430, binding = 7) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} face_fabrics_0;
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
layout(std430, binding = 6) readonly buffer StructuredBuffer_uint_t_1 {
    uint _data[];
} corners_0;
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

layout(std430, binding = 5) readonly buffer StructuredBuffer_Vertex_t_0 {
    Vertex_0 _data[];
} vertices_0;
layout(std430, binding = 13) buffer StructuredBuffer_float_t_0 {
    float _data[];
} visibilities_0;
layout(std430, binding = 11) readonly buffer StructuredBuffer_uint_t_2 {
    uint _data[];
} scene_words_0;
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

layout(std430, binding = 3) readonly buffer StructuredBuffer_Light_t_0 {
    Light_0 _data[];
} lights_1;
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
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_3 {
    uint _data[];
} words_0;
const vec2  TAP_OFFSETS_0[9] = vec2[](vec2(-0.3333333432674408, -0.3333333432674408), vec2(-0.3333333432674408, 0.0), vec2(-0.3333333432674408, 0.3333333432674408), vec2(0.0, -0.3333333432674408), vec2(0.0, 0.0), vec2(0.0, 0.3333333432674408), vec2(0.3333333432674408, -0.3333333432674408), vec2(0.3333333432674408, 0.0), vec2(0.3333333432674408, 0.3333333432674408));
const float  PYRAMID_RADII_0[4] = float[](1.0, 2.0, 4.0, 8.0);
float saturate_0(float x_2)
{
    return clamp(x_2, 0.0, 1.0);
}

vec3 position_of_0(Vertex_0 vertex_0)
{
    return vec3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(vec3 v_1)
{
    return dot(v_1, v_1);
}

vec3 normal_of_0(Vertex_0 vertex_1)
{
    return vec3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

uint scramble_0(uint value_0)
{
    uint _S1 = value_0 * 747796405U + 2891336453U;
    uint _S2 = ((_S1 >> ((_S1 >> 28) + 4U)) ^ _S1) * 277803737U;
    return (_S2 >> 22) ^ _S2;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> 9) + 0.5) * 1.1920928955078125e-07;
}

vec2 pixel_sequence_0(uvec2 pixel_0, uint index_0, uint stream_1)
{
    uint _S3 = pixel_0.x;
    uint _S4 = pixel_0.y;
    return fract(vec2(uniform_hash_0(_S3, _S4, stream_1), uniform_hash_0(_S3, _S4, stream_1 + 1U)) + float(index_0 & 65535U) * vec2(0.75487768650054932, 0.56984031200408936));
}

float scene_number_0(uint index_1)
{
    return uintBitsToFloat(scene_words_0._data[uint(index_1)]);
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
    choice_0.remainder_0 = saturate_0((number_0 - _S7) / max(_S8 - _S7, 9.999999960041972e-13));
    return choice_0;
}

float mean_0(vec3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0;
}

vec2 sine_cosine_0(float x_3)
{
    float _S9 = floor(x_3 * 0.63661974668502808 + 0.5);
    float _S10 = x_3 - _S9 * 1.5703125 - _S9 * 0.00048375129699707 - _S9 * 7.54979012640433211e-08;
    float _S11 = _S10 * _S10;
    float _S12 = ((-0.00019515295571182 * _S11 + 0.00833216123282909) * _S11 - 0.16666655242443085) * _S11 * _S10 + _S10;
    float _S13 = ((0.00002443315679557 * _S11 - 0.00138873164542019) * _S11 + 0.04166664555668831) * _S11 * _S11 - 0.5 * _S11 + 1.0;
    uint _S14 = uint(int(_S9)) & 3U;
    vec2 _S15;
    if((_S14 & 1U) != 0U)
    {
        _S15 = vec2(_S13, _S12);
    }
    else
    {
        _S15 = vec2(_S12, _S13);
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
    return vec2(_S16, _S17);
}

float inverse_of_0(float component_0)
{
    float _S18;
    if((abs(component_0)) > 9.99999968265522539e-21)
    {
        _S18 = component_0;
    }
    else
    {
        _S18 = 9.99999968265522539e-21;
    }
    return 1.0 / _S18;
}

bool meets_node_0(uint node_0, vec3 origin_0, vec3 inverse_0, float nearest_0, float farthest_0)
{
    uint _S19 = 6U * (node_0 - 1U);
    vec3 _S20 = (vec3(scene_number_0(_S19), scene_number_0(_S19 + 1U), scene_number_0(_S19 + 2U)) - origin_0) * inverse_0;
    vec3 _S21 = (vec3(scene_number_0(_S19 + 3U), scene_number_0(_S19 + 4U), scene_number_0(_S19 + 5U)) - origin_0) * inverse_0;
    vec3 _S22 = min(_S20, _S21);
    vec3 _S23 = max(_S20, _S21) * 1.0000004768371582;
    return (max(max(_S22.x, _S22.y), max(_S22.z, nearest_0))) <= (min(min(_S23.x, _S23.y), min(_S23.z, farthest_0)));
}

uint following_node_0(uint node_1)
{
    uint _S24 = node_1 + 1U;
    uint _S25 = _S24 >> (findLSB(_S24));
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

Hit_0 meet_face_0(uint face_2, vec3 origin_1, vec3 direction_0)
{
    uint _S27 = 3U * face_2;
    vec3 _S28 = position_of_0(vertices_0._data[uint(corners_0._data[uint(_S27)])]);
    vec3 _S29 = position_of_0(vertices_0._data[uint(corners_0._data[uint(_S27 + 1U)])]) - _S28;
    vec3 _S30 = position_of_0(vertices_0._data[uint(corners_0._data[uint(_S27 + 2U)])]) - _S28;
    vec3 _S31 = cross(direction_0, _S30);
    float _S32 = dot(_S29, _S31);
    bool _S33 = (abs(_S32)) > 1.00000000317107685e-30;
    float _S34;
    if(_S33)
    {
        _S34 = _S32;
    }
    else
    {
        _S34 = 1.00000000317107685e-30;
    }
    float _S35 = 1.0 / _S34;
    vec3 _S36 = origin_1 - _S28;
    vec3 _S37 = cross(_S36, _S29);
    Hit_0 hit_0;
    float _S38 = dot(_S36, _S31) * _S35;
    hit_0.weight_b_0 = _S38;
    hit_0.weight_c_0 = dot(direction_0, _S37) * _S35;
    hit_0.distance_0 = dot(_S30, _S37) * _S35;
    bool _S39;
    if(_S38 >= 0.0)
    {
        _S39 = (hit_0.weight_c_0) >= 0.0;
    }
    else
    {
        _S39 = false;
    }
    if(_S39)
    {
        _S39 = (hit_0.weight_b_0 + hit_0.weight_c_0) <= 1.0;
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
    vec3 position_0;
    vec3 view_0;
    vec3 axis_x_0;
    vec3 axis_y_0;
    vec3 normal_0;
    vec3 face_normal_0;
    vec2 uv_0;
    vec2 draft_per_uv_0;
    vec2 draft_0;
    vec2 draft_dx_0;
    vec2 draft_dy_0;
};

vec3 to_local_0(VisiblePoint_0 point_0, vec3 direction_1)
{
    return vec3(dot(direction_1, point_0.axis_x_0), dot(direction_1, point_0.axis_y_0), dot(direction_1, point_0.normal_0));
}

vec3 to_face_frame_0(vec3 direction_2, bool back_1)
{
    vec2 _S41 = direction_2.xy;
    float _S42;
    if(back_1)
    {
        _S42 = - direction_2.z;
    }
    else
    {
        _S42 = direction_2.z;
    }
    return vec3(_S41, _S42);
}

struct Footprint_0
{
    vec2 centre_0;
    vec2 dx_0;
    vec2 dy_0;
};

float Footprint_spread_side_0(Footprint_0 this_0)
{
    vec2 _S43 = this_0.dx_0;
    vec2 _S44 = this_0.dy_0;
    return sqrt(0.5 * (dot(_S43, _S43) + dot(_S44, _S44)));
}

float natural_logarithm_0(float x_4)
{
    uint _S45 = floatBitsToUint(x_4);
    float exponent_0 = float(int(_S45 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S45 & 8388607U) | 1056964608U);
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
    float _S46 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S46 - exponent_1 * 0.00021219444170129 - 0.5 * _S46) + exponent_1 * 0.693359375;
}

float binary_logarithm_0(float x_5)
{
    return natural_logarithm_0(x_5) * 1.4426950216293335;
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

vec2 turns_and_remainder_0(uint family_0, float index_3)
{
    float _S47 = floor(fma(index_3, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S47, fma(- _S47, families_0._data[uint(family_0)].count_0, index_3));
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
    float _S48 = floor(position_1 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_1;
    float _S49 = fma(- _S48, families_0._data[uint(family_1)].size_0, position_1);
    cell_1.below_0 = _S49;
    cell_1.above_0 = families_0._data[uint(family_1)].size_0 - _S49;
    cell_1.across_0 = _S49 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_1.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_1.thread_1 = uint(clamp(turns_and_remainder_0(family_1, _S48).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_1;
}

float table_number_0(uint index_4)
{
    return uintBitsToFloat(words_0._data[uint(index_4)]);
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S50 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_2 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S51;
    if(_S50 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_2 * 4U + 1U)))
    {
        _S51 = 1U;
    }
    else
    {
        _S51 = 0U;
    }
    uint _S52 = min(thread_2 + _S51, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S53 = families_0._data[uint(family_2)].place_table_0 + _S52 * 4U;
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
    if((families_0._data[uint(family_3)].is_alike_0) != 0U)
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
    vec2 _S60 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0));
    return fma(_S60.x, families_0._data[uint(family_4)].period_0, table_number_0(families_0._data[uint(family_4)].place_table_0 + uint(_S60.y) * 4U));
}

float span_0(uint family_5, uint thread_4, int first_1, int last_0)
{
    if((families_0._data[uint(family_5)].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * families_0._data[uint(family_5)].size_0;
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
    Family_0 _S61 = families_0._data[uint(family_6)];
    uint _S62;
    if((families_0._data[uint(family_6)].is_alike_0) != 0U)
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
    int _S64 = int((word_1 >> 1) & 127U);
    int _S65 = int((word_1 >> 8) & 127U);
    int _S66 = int((word_1 >> 15) & 63U);
    int _S67 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S68 = - _S64;
    float _S69 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S68, 0);
    run_0.from_start_0 = _S69;
    int _S70 = _S65 + 1;
    float _S71 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, 1, _S70);
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
        _S75 = 1.0e+06;
    }
    else
    {
        _S75 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_1 = _S75;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_0, crossed_0.thread_1, _S73, _S74), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S64 == 0;
    run_0.last_crossing_0 = _S65 == 0;
    return run_0;
}

float square_1(float x_6)
{
    return x_6 * x_6;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_4)
{
    float _S76 = cell_4.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S77 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S77;
    float _S78 = _S76 * _S76 - square_1(_S77);
    float _S79 = (inversesqrt((_S78)));
    section_0.drop_0 = _S76 - _S78 * _S79;
    section_0.slope_0 = - _S77 * _S79;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_7, int step_1)
{
    if((families_0._data[uint(family_7)].is_alike_0) != 0U)
    {
        return table_number_0(families_0._data[uint(family_7)].bend_table_0 + 3U);
    }
    return table_number_0(families_0._data[uint(family_7)].bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_7) + step_1)).y) * 4U + 3U);
}

vec2 dive_0(uint other_1, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
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
        _S82 = 0.0;
    }
    else
    {
        _S82 = families_0._data[uint(other_1)].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, 0);
    }
    float _S85;
    if((shown_1.on_top_0) != _S84)
    {
        _S85 = 0.0;
    }
    else
    {
        Family_0 _S86 = families_0._data[uint(other_1)];
        int _S87;
        if(_S80)
        {
            _S87 = -1;
        }
        else
        {
            _S87 = 1;
        }
        _S85 = _S86.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S87);
    }
    float _S88 = 1.0 / max(2.0 * _S83, 9.999999960041972e-13);
    float _S89 = clamp((_S83 - _S81) * _S88, 0.0, 1.0);
    float _S90 = _S82 + (_S85 - _S82) * (_S89 * _S89 * (3.0 - 2.0 * _S89));
    float _S91 = (_S82 - _S85) * (6.0 * _S89 * (1.0 - _S89) * _S88);
    if(_S80)
    {
        _S82 = 1.0;
    }
    else
    {
        _S82 = -1.0;
    }
    return vec2(_S90, _S91 * _S82);
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
    float _S92 = direction_3.x;
    control_0.per_x_0 = 1.0 / max(abs(_S92), 9.99999971718068537e-10);
    float _S93 = direction_3.y;
    control_0.per_y_0 = 1.0 / max(abs(_S93), 9.99999971718068537e-10);
    control_0.right_0 = _S92 > 0.0;
    control_0.up_0 = _S93 > 0.0;
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
        _S94 = 2.0 * _S95 + _S94 - cell_5.half_width_1;
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
        _S106 = (previous_1.rate_0) >= 0.0;
    }
    if(_S106)
    {
        _S106 = true;
    }
    else
    {
        _S106 = rate_1 <= 0.0;
    }
    if(_S106)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S104) >= 0.0)
    {
        _S106 = (3.0 * clearance_1 - _S105) >= 0.0;
    }
    else
    {
        _S106 = false;
    }
    if(_S106)
    {
        return -1.0;
    }
    float _S107 = clearance_1 - previous_1.clearance_0;
    float _S108 = 6.0 * _S107 - 4.0 * _S104 - 2.0 * _S105;
    float _S109 = -2.0 * _S104 / max(_S108 + sqrt(max(_S108 * _S108 - 4.0 * (3.0 * (_S104 + _S105 - 2.0 * _S107)) * _S104, 0.0)), 9.99999968265522539e-21);
    float _S110 = 1.0 - _S109;
    float _S111 = (previous_1.clearance_0 * (2.0 * _S109 + 1.0) + _S104 * _S109) * _S110 * _S110;
    float _S112 = (clearance_1 * (2.0 * _S110 + 1.0) - _S105 * _S110) * _S109 * _S109;
    if(_S109 > 0.01999999955296516)
    {
        _S106 = _S110 > 0.01999999955296516;
    }
    else
    {
        _S106 = false;
    }
    if(_S106)
    {
        _S106 = (_S111 + _S112) < 0.0;
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
        _S113 = -1.0;
    }
    return _S113;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S114;
    if(here_1.hole_1)
    {
        _S114 = 1.0e+09;
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
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S116 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S117;
    if(!here_2.hole_1)
    {
        _S117 = (rate_3 * _S116 + clearance_3) < 0.0;
    }
    else
    {
        _S117 = false;
    }
    if(_S117)
    {
        _S117 = _S116 > (2.0 * this_2.epsilon_0);
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
        _S118 = max(_S116, 0.0) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S118);
}

struct ViewRay_0
{
    vec2 origin_2;
    vec2 slope_1;
};

vec2 ViewRay_at_0(ViewRay_0 this_3, float height_2)
{
    return this_3.origin_2 + this_3.slope_1 * height_2;
}

float ViewRay_rate_0(ViewRay_0 this_4, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S119 = end_0 - start_1;
    float _S120 = start_rate_0 + end_rate_0 - 2.0 * _S119;
    float _S121 = 3.0 * _S119 - 2.0 * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S119, 9.99999968265522539e-21);
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
        float _S122 = clamp(share_1 - (((_S120 * share_1 + _S121) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0 * _S120 * share_1 + 2.0 * _S121) * share_1 + start_rate_0, 0.10000000149011612 * _S119 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S123 = i_0 + 1;
        share_1 = _S122;
        i_0 = _S123;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

float arc_tangent_quotient_0(float x_7, float y_2)
{
    return ((((((0.0 * x_7 + 0.00809729471802711) * x_7 + -0.0377517081797123) * x_7 + 0.08475969731807709) * x_7 + -0.13537675142288208) * x_7 + 0.19895026087760925) * x_7 + -0.33327975869178772) * x_7 + 0.99999970197677612;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0);
}

float arc_tangent_0(float y_3, float x_8)
{
    float _S124 = abs(x_8);
    float _S125 = abs(y_3);
    float angle_0 = arc_tangent_of_ratio_0(min(_S124, _S125) / max(max(_S124, _S125), 1.00000000317107685e-30));
    float angle_1;
    if(_S125 > _S124)
    {
        angle_1 = 1.57079637050628662 - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_8 < 0.0)
    {
        angle_1 = 3.14159274101257324 - angle_1;
    }
    if(y_3 < 0.0)
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

NodeTaps_0 node_taps_0(vec3 direction_4)
{
    float _S126 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461;
    float _S127 = floor(_S126);
    float _S128 = _S126 - _S127;
    float _S129 = sqrt(clamp((1.0 - abs(direction_4.z)) / 0.97000002861022949, 0.0, 1.0));
    float _S130 = 7.0 * _S129 * sqrt(_S129);
    float _S131 = min(floor(_S130), 6.0);
    float _S132 = _S130 - _S131;
    uint _S133 = uint(int(_S127) + 32) % 32U;
    uint _S134 = uint(_S131);
    uint _S135 = _S133 * 8U + _S134;
    uint _S136 = (_S133 + 1U) % 32U * 8U + _S134;
    NodeTaps_0 taps_0;
    taps_0.nodes_0 = uvec4(_S135, _S135 + 1U, _S136, _S136 + 1U);
    float _S137 = 1.0 - _S128;
    float _S138 = 1.0 - _S132;
    uvec4 _S139 = uvec4(vec4(_S137 * _S138, _S137 * _S132, _S128 * _S138, _S128 * _S132) * 252.0 + 0.5);
    taps_0.weights_0 = _S139;
    taps_0.inverse_sum_0 = 1.0 / float(_S139.x + _S139.y + _S139.z + _S139.w);
    return taps_0;
}

float wrapped_cell_0(float position_4, float count_2)
{
    return min(floor((position_4 - floor(position_4)) * count_2), count_2 - 1.0);
}

vec4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return vec4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16), float(odd_0 >> 16));
}

vec4 interpolate_0(NodeTaps_0 taps_1, uvec4 packs_1)
{
    uvec4 _S140 = (packs_1 & 16711935U) * taps_1.weights_0;
    uvec4 _S141 = ((packs_1 >> 8) & 16711935U) * taps_1.weights_0;
    return bytes_of_sums_0(_S140.x + _S140.y + _S140.z + _S140.w, _S141.x + _S141.y + _S141.z + _S141.w) * taps_1.inverse_sum_0;
}

vec4 interpolate_table_0(NodeTaps_0 taps_2, uint table_1, uint stride_0)
{
    uvec4 _S142 = table_1 + taps_2.nodes_0 * stride_0;
    return interpolate_0(taps_2, uvec4(words_0._data[uint(_S142.x)], words_0._data[uint(_S142.y)], words_0._data[uint(_S142.z)], words_0._data[uint(_S142.w)]));
}

float sheen_scale_0(float x_9, float y_4)
{
    return (((((0.0 * x_9 + (((((-1.1402510404586792 * y_4 + 0.40672621130943298) * y_4 + 1.65398800373077393) * y_4 + -1.29730904102325439) * y_4 + 0.30570998787879944) * y_4 + -0.0220868494361639)) * x_9 + (((((-0.21142719686031342 * y_4 + 1.05947399139404297) * y_4 + -0.41116121411323547) * y_4 + -0.93859231472015381) * y_4 + 0.51606941223144531) * y_4 + 0.05409301072359085)) * x_9 + (((((1.22944498062133789 * y_4 + -0.45962560176849365) * y_4 + -1.63861405849456787) * y_4 + 1.33565104007720947) * y_4 + -0.45725581049919128) * y_4 + 0.08243165910243988)) * x_9 + (((((0.39779931306838989 * y_4 + -1.18879103660583496) * y_4 + 0.28251591324806213) * y_4 + 1.168984055519104) * y_4 + -0.76864629983901978) * y_4 + 0.0091691892594099)) * x_9 + (((((-0.26563560962677002 * y_4 + -0.19379159808158875) * y_4 + 0.2677634060382843) * y_4 + 0.00270519289188087) * y_4 + 0.14349560439586639) * y_4 + 0.10290180146694183)) * x_9 + (((((-0.20701569318771362 * y_4 + 0.24526430666446686) * y_4 + 0.19551840424537659) * y_4 + 0.07586126774549484) * y_4 + 0.38894739747047424) * y_4 + 0.15043120086193085);
}

float sheen_shear_0(float x_10, float y_5)
{
    return ((((0.0 * x_10 + (((((-0.10608240216970444 * y_5 + 1.99214303493499756) * y_5 + -1.42255294322967529) * y_5 + -1.09495604038238525) * y_5 + 0.59180057048797607) * y_5 + 0.06902855634689331)) * x_10 + (((((-0.46220690011978149 * y_5 + -0.29113379120826721) * y_5 + 1.39025199413299561) * y_5 + 0.35589990019798279) * y_5 + -1.17120099067687988) * y_5 + 0.15940259397029877)) * x_10 + (((((2.26068711280822754 * y_5 + -3.64728999137878418) * y_5 + -0.72173482179641724) * y_5 + 3.07659196853637695) * y_5 + -0.6827620267868042) * y_5 + -0.3039557933807373)) * x_10 + (((((0.81201767921447754 * y_5 + 0.36014080047607422) * y_5 + -1.72646903991699219) * y_5 + -0.22630110383033752) * y_5 + 0.89514690637588501) * y_5 + -0.10397960245609283)) * x_10 + (((((-0.37648698687553406 * y_5 + 1.10974001884460449) * y_5 + 0.17824520170688629) * y_5 + -1.04968702793121338) * y_5 + 0.1461234986782074) * y_5 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_11, float y_6)
{
    return ((((0.0 * x_11 + (((((12.95646953582763672 * y_6 + -21.38032913208007812) * y_6 + -7.37853097915649414) * y_6 + 34.55607986450195312) * y_6 + -23.61347007751464844) * y_6 + 5.00126314163208008)) * x_11 + (((((10.91487026214599609 * y_6 + -6.08202791213989258) * y_6 + -38.2036285400390625) * y_6 + 53.3440399169921875) * y_6 + -21.91996002197265625) * y_6 + 2.01606011390686035)) * x_11 + (((((-14.52206039428710938 * y_6 + 36.803619384765625) * y_6 + -22.94047927856445312) * y_6 + -10.07973003387451172) * y_6 + 15.77003955841064453) * y_6 + -4.92722177505493164)) * x_11 + (((((-7.62505722045898438 * y_6 + 1.27310299873352051) * y_6 + 31.19523048400878906) * y_6 + -44.39989852905273438) * y_6 + 26.44947052001953125) * y_6 + -8.73507976531982422)) * x_11 + (((((5.65633487701416016 * y_6 + -17.66820907592773438) * y_6 + 24.65356063842773438) * y_6 + -19.38941001892089844) * y_6 + 11.06159019470214844) * y_6 + -3.06573700904846191);
}

float exponential_0(float x_12)
{
    float _S143 = clamp(x_12, -87.0, 88.0);
    float _S144 = floor(_S143 * 1.4426950216293335 + 0.5);
    float _S145 = _S143 - _S144 * 0.693359375 + _S144 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S145 + 0.00139819993637502) * _S145 + 0.00833345204591751) * _S145 + 0.04166579619050026) * _S145 + 0.1666666567325592) * _S145 + 0.5;
    float _S146 = uintBitsToFloat(uint(int(_S144) + 127) << 23);
    float _S147;
    if(x_12 < -87.0)
    {
        _S147 = 0.0;
    }
    else
    {
        _S147 = (p_0 * _S145 * _S145 + _S145 + 1.0) * _S146;
    }
    return _S147;
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S148 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S149 = 2.0 * sqrt(_S148) - 1.0;
    float _S150 = 3.0 * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S149, _S150), 0.00999999977648258, 1.0), clamp((1.0 - _S148) * sheen_shear_0(_S149, _S150), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S149, _S150), -60.0, 60.0))));
}

vec3 camera_right_0(int _S151)
{
    return vec3(frames_0._data[uint(_S151)].right_x_0, frames_0._data[uint(_S151)].right_y_0, frames_0._data[uint(_S151)].right_z_0);
}

vec3 camera_up_0(int _S152)
{
    return vec3(frames_0._data[uint(_S152)].up_x_0, frames_0._data[uint(_S152)].up_y_0, frames_0._data[uint(_S152)].up_z_0);
}

vec3 camera_forward_0(int _S153)
{
    return vec3(frames_0._data[uint(_S153)].forward_x_0, frames_0._data[uint(_S153)].forward_y_0, frames_0._data[uint(_S153)].forward_z_0);
}

vec3 camera_origin_0(int _S154)
{
    return vec3(frames_0._data[uint(_S154)].origin_x_0, frames_0._data[uint(_S154)].origin_y_0, frames_0._data[uint(_S154)].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S155, uint _S156, float _S157, float _S158)
{
    uint _S159 = 3U * _S156;
    Vertex_0 _S160 = vertices_0._data[uint(corners_0._data[uint(_S159)])];
    Vertex_0 _S161 = vertices_0._data[uint(corners_0._data[uint(_S159 + 1U)])];
    Vertex_0 _S162 = vertices_0._data[uint(corners_0._data[uint(_S159 + 2U)])];
    vec3 _S163 = position_of_0(_S160);
    vec3 _S164 = position_of_0(_S161) - _S163;
    vec3 _S165 = position_of_0(_S162) - _S163;
    float _S166 = _S161.u_0 - _S160.u_0;
    float _S167 = _S161.v_0 - _S160.v_0;
    vec2 _S168 = vec2(_S166, _S167);
    float _S169 = _S162.u_0 - _S160.u_0;
    float _S170 = _S162.v_0 - _S160.v_0;
    vec2 _S171 = vec2(_S169, _S170);
    float _S172;
    if((_S166 * _S170 - _S167 * _S169) < 0.0)
    {
        _S172 = -1.0;
    }
    else
    {
        _S172 = 1.0;
    }
    vec3 _S173 = _S172 * (_S170 * _S164 - _S167 * _S165);
    vec3 _S174 = _S172 * (_S166 * _S165 - _S169 * _S164);
    VisiblePoint_0 point_1;
    vec3 _S175 = normalize((1.0 - _S157 - _S158) * normal_of_0(_S160) + _S157 * normal_of_0(_S161) + _S158 * normal_of_0(_S162));
    point_1.normal_0 = _S175;
    vec3 _S176 = normalize(_S173 - _S175 * dot(_S175, _S173));
    point_1.axis_x_0 = _S176;
    point_1.axis_y_0 = cross(_S175, _S176);
    vec3 _S177 = normalize(cross(_S164, _S165));
    vec3 _S178;
    if((dot(_S177, _S175)) < 0.0)
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
    point_1.uv_0 = vec2(_S160.u_0, _S160.v_0) + _S157 * _S168 + _S158 * _S171;
    bool _S179 = (dot(cross(_S173, _S174), point_1.normal_0)) < 0.0;
    float _S180 = fabrics_0._data[uint(_S155)].uv_width_0;
    if(_S179)
    {
        _S172 = - fabrics_0._data[uint(_S155)].uv_height_0;
    }
    else
    {
        _S172 = fabrics_0._data[uint(_S155)].uv_height_0;
    }
    vec2 _S181 = vec2(_S180, _S172);
    point_1.draft_per_uv_0 = _S181;
    vec2 _S182 = point_1.uv_0 * _S181;
    if(_S179)
    {
        _S172 = fabrics_0._data[uint(_S155)].uv_height_0;
    }
    else
    {
        _S172 = 0.0;
    }
    point_1.draft_0 = _S182 + vec2(0.0, _S172);
    const vec2 _S183 = vec2(0.0);
    point_1.draft_dx_0 = _S183;
    point_1.draft_dy_0 = _S183;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S184, uint _S185, uint _S186, uvec2 _S187)
{
    uint _S188 = 3U * _S186;
    Vertex_0 _S189 = vertices_0._data[uint(corners_0._data[uint(_S188)])];
    Vertex_0 _S190 = vertices_0._data[uint(corners_0._data[uint(_S188 + 1U)])];
    Vertex_0 _S191 = vertices_0._data[uint(corners_0._data[uint(_S188 + 2U)])];
    vec3 _S192 = position_of_0(_S189);
    vec3 _S193 = position_of_0(_S190) - _S192;
    vec3 _S194 = position_of_0(_S191) - _S192;
    vec3 _S195 = cross(_S193, _S194);
    float _S196 = 1.0 / max(square_0(_S195), 1.00000000317107685e-30);
    float _S197 = float(frames_0._data[uint(_S184)].width_0);
    vec3 _S198 = camera_right_0(_S184) * (2.0 / _S197);
    float _S199 = float(frames_0._data[uint(_S184)].height_0);
    vec3 _S200 = camera_up_0(_S184) * (-2.0 / _S199);
    vec3 _S201 = camera_forward_0(_S184) + (float(_S187.x) + 0.5 - 0.5 * _S197) * _S198 + (float(_S187.y) + 0.5 - 0.5 * _S199) * _S200;
    float _S202 = dot(_S201, _S195);
    float _S203;
    if((abs(_S202)) > 1.00000000317107685e-30)
    {
        _S203 = _S202;
    }
    else
    {
        _S203 = 1.00000000317107685e-30;
    }
    float _S204 = 1.0 / _S203;
    vec3 _S205 = _S192 - camera_origin_0(_S184);
    float _S206 = dot(_S205, _S195) * _S204;
    vec3 _S207 = _S201 * _S206 - _S205;
    vec3 _S208 = _S206 * (_S198 - _S201 * (dot(_S198, _S195) * _S204));
    vec3 _S209 = _S206 * (_S200 - _S201 * (dot(_S200, _S195) * _S204));
    vec3 _S210 = cross(_S194, _S195) * _S196;
    vec3 _S211 = cross(_S195, _S193) * _S196;
    vec2 _S212 = vec2(_S190.u_0 - _S189.u_0, _S190.v_0 - _S189.v_0);
    vec2 _S213 = vec2(_S191.u_0 - _S189.u_0, _S191.v_0 - _S189.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S185, _S186, dot(_S207, _S210), dot(_S207, _S211));
    point_2.position_0 = _S192 + _S207;
    point_2.view_0 = - normalize(_S201);
    point_2.draft_dx_0 = (dot(_S208, _S210) * _S212 + dot(_S208, _S211) * _S213) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S209, _S210) * _S212 + dot(_S209, _S211) * _S213) * point_2.draft_per_uv_0;
    return point_2;
}

uint light_sample_count_0(int _S214)
{
    return frames_0._data[uint(_S214)].lights_0 + frames_0._data[uint(_S214)].environment_samples_0;
}

struct LightSample_0
{
    vec3 towards_0;
    vec3 irradiance_1;
    float distance_2;
};

vec3 environment_texel_0(int _S215, uint _S216, uint _S217)
{
    uint _S218 = frames_0._data[uint(_S215)].environment_table_0 + frames_0._data[uint(_S215)].environment_rows_0 + 1U + frames_0._data[uint(_S215)].environment_rows_0 * (frames_0._data[uint(_S215)].environment_columns_0 + 1U) + 3U * (_S216 * frames_0._data[uint(_S215)].environment_columns_0 + _S217);
    return vec3(scene_number_0(_S218), scene_number_0(_S218 + 1U), scene_number_0(_S218 + 2U));
}

vec3 sample_environment_0(int _S219, vec2 _S220, out vec3 _S221)
{
    uint _S222 = frames_0._data[uint(_S219)].environment_rows_0;
    Choice_0 _S223 = choose_0(frames_0._data[uint(_S219)].environment_table_0, frames_0._data[uint(_S219)].environment_rows_0, _S220.y);
    uint _S224 = frames_0._data[uint(_S219)].environment_columns_0;
    Choice_0 _S225 = choose_0(frames_0._data[uint(_S219)].environment_table_0 + frames_0._data[uint(_S219)].environment_rows_0 + 1U + _S223.index_2 * (frames_0._data[uint(_S219)].environment_columns_0 + 1U), frames_0._data[uint(_S219)].environment_columns_0, _S220.x);
    vec3 _S226 = environment_texel_0(_S219, _S223.index_2, _S225.index_2);
    _S221 = _S226 * (frames_0._data[uint(_S219)].environment_total_0 / max(mean_0(_S226), 9.99999968265522539e-21));
    float _S227 = 3.14159274101257324 / float(_S222);
    float _S228 = mix(sine_cosine_0(float(_S223.index_2) * _S227).y, sine_cosine_0(float(_S223.index_2 + 1U) * _S227).y, _S223.remainder_0);
    float _S229 = sqrt(max(1.0 - _S228 * _S228, 0.0));
    vec2 _S230 = sine_cosine_0((float(_S225.index_2) + _S225.remainder_0) * (6.28318548202514648 / float(_S224)));
    float _S231 = _S229 * _S230.x;
    float _S232 = - _S229 * _S230.y;
    return vec3(frames_0._data[uint(_S219)].environment_cosine_0 * _S231 + frames_0._data[uint(_S219)].environment_sine_0 * _S232, _S228, frames_0._data[uint(_S219)].environment_cosine_0 * _S232 - frames_0._data[uint(_S219)].environment_sine_0 * _S231);
}

LightSample_0 light_sample_0(int _S233, uint _S234, uvec2 _S235, vec3 _S236)
{
    LightSample_0 sample_0;
    sample_0.distance_2 = 1.00000001504746622e+30;
    uint _S237 = frames_0._data[uint(_S233)].lights_0;
    if(_S234 >= (frames_0._data[uint(_S233)].lights_0))
    {
        vec3 weight_0;
        vec3 _S238 = sample_environment_0(_S233, pixel_sequence_0(_S235, frames_0._data[uint(_S233)].pass_number_0 * frames_0._data[uint(_S233)].environment_samples_0 + (_S234 - _S237), 3U), weight_0);
        sample_0.towards_0 = _S238;
        sample_0.irradiance_1 = weight_0 / float(frames_0._data[uint(_S233)].environment_samples_0);
        return sample_0;
    }
    Light_0 _S239 = lights_1._data[uint(_S234)];
    sample_0.irradiance_1 = vec3(_S239.red_0, _S239.green_0, _S239.blue_0);
    sample_0.towards_0 = vec3(_S239.x_1, _S239.y_1, _S239.z_1);
    if((_S239.is_point_0) != 0U)
    {
        vec3 _S240 = sample_0.towards_0 - _S236;
        float _S241 = max(square_0(_S240), 9.999999960041972e-13);
        sample_0.distance_2 = sqrt(_S241);
        sample_0.irradiance_1 = sample_0.irradiance_1 / _S241;
        sample_0.towards_0 = normalize(_S240);
    }
    return sample_0;
}

Hit_0 nearest_hit_0(int _S242, vec3 _S243, vec3 _S244, float _S245, float _S246, uint _S247, bool _S248)
{
    vec3 _S249 = vec3(inverse_of_0(_S244.x), inverse_of_0(_S244.y), inverse_of_0(_S244.z));
    Hit_0 found_0;
    found_0.face_1 = 4294967295U;
    found_0.distance_0 = _S246;
    found_0.weight_b_0 = 0.0;
    found_0.weight_c_0 = 0.0;
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
        if(!meets_node_0(node_2, _S243, _S249, _S245, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            uint _S250 = frames_0._data[uint(_S242)].leaves_0;
            if(node_2 < (frames_0._data[uint(_S242)].leaves_0))
            {
                node_3 = node_2 * 2U;
            }
            else
            {
                uint _S251 = frames_0._data[uint(_S242)].leaf_faces_0 + 4U * (node_2 - _S250);
                uint _S252 = following_node_0(node_2);
                uint number_1 = 0U;
                node_3 = _S252;
                for(;;)
                {
                    if(number_1 < 4U)
                    {
                    }
                    else
                    {
                        break;
                    }
                    uint _S253 = scene_words_0._data[uint(_S251 + number_1)];
                    bool _S254;
                    if(_S253 == 4294967295U)
                    {
                        _S254 = true;
                    }
                    else
                    {
                        _S254 = _S253 == _S247;
                    }
                    if(_S254)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    Hit_0 _S255 = meet_face_0(_S253, _S243, _S244);
                    bool _S256;
                    if((_S255.face_1) == 4294967295U)
                    {
                        _S256 = true;
                    }
                    else
                    {
                        _S256 = (_S255.distance_0) <= _S245;
                    }
                    bool _S257;
                    if(_S256)
                    {
                        _S257 = true;
                    }
                    else
                    {
                        _S257 = (_S255.distance_0) >= (found_0.distance_0);
                    }
                    if(_S257)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    found_0 = _S255;
                    bool _S258;
                    if(_S248)
                    {
                        _S258 = (fabrics_0._data[uint(face_fabrics_0._data[uint(_S253)])].is_open_0) == 0U;
                    }
                    else
                    {
                        _S258 = false;
                    }
                    uint node_4;
                    if(_S258)
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

Regime_0 regime_of_0(uint _S259, Footprint_0 _S260, float _S261)
{
    float _S262 = Footprint_spread_side_0(_S260);
    float _S263 = clamp((binary_logarithm_0(max(_S262, 9.99999971718068537e-10)) - fabrics_0._data[uint(_S259)].lobes_0.unit_level_0 - -0.7369655966758728) / 1.41503751277923584, 0.0, 1.0);
    Regime_0 regime_0;
    float _S264 = _S263 * _S263 * (3.0 - 2.0 * _S263);
    regime_0.prefiltered_0 = _S264;
    regime_0.threads_0 = _S262 * fabrics_0._data[uint(_S259)].lobes_0.threads_per_mm_0;
    float _S265 = mix(max(8.0 / _S261, 1.0), 1.0, _S264);
    float _S266;
    if(_S264 < 1.0)
    {
        _S266 = clamp(regime_0.threads_0 * 12.0, 1.0, _S265);
    }
    else
    {
        _S266 = 0.0;
    }
    regime_0.points_0 = _S266;
    return regime_0;
}

struct Hit_1
{
    float x_13;
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

Crossing_0 crossing_at_0(uint _S267, float _S268, float _S269, bool _S270)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0._data[uint(_S267)].warp_0, _S268);
    crossing_2.weft_1 = locate_0(fabrics_0._data[uint(_S267)].weft_0, _S269);
    uint _S271 = fabrics_0._data[uint(_S267)].run_words_0 + 2U * (crossing_2.weft_1.thread_1 * fabrics_0._data[uint(_S267)].ends_1 + crossing_2.warp_1.thread_1);
    uint _S272 = words_0._data[uint(_S271)];
    crossing_2.warp_word_0 = _S272;
    crossing_2.weft_word_0 = words_0._data[uint(_S271 + 1U)];
    crossing_2.warp_above_0 = ((_S272 & 1U) == 1U) != _S270;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S273, float _S274, float _S275, bool _S276)
{
    Sample_0 sample_1;
    Crossing_0 _S277 = crossing_at_0(_S273, _S274, _S275, _S276);
    sample_1.crossing_1 = _S277;
    Shown_0 _S278 = shown_at_0(_S277, _S276);
    sample_1.shown_3 = _S278;
    uint _S279;
    if(_S278.is_warp_0)
    {
        _S279 = fabrics_0._data[uint(_S273)].warp_0;
    }
    else
    {
        _S279 = fabrics_0._data[uint(_S273)].weft_0;
    }
    uint _S280;
    if(_S278.is_warp_0)
    {
        _S280 = fabrics_0._data[uint(_S273)].weft_0;
    }
    else
    {
        _S280 = fabrics_0._data[uint(_S273)].warp_0;
    }
    Cell_0 _S281 = select_cell_0(_S278.is_warp_0, sample_1.crossing_1.warp_1, sample_1.crossing_1.weft_1);
    Cell_0 _S282 = select_cell_0(_S278.is_warp_0, sample_1.crossing_1.weft_1, sample_1.crossing_1.warp_1);
    Run_0 _S283 = unpack_0(_S279, _S280, _S281.thread_1, _S282, _S278.word_0);
    Section_0 _S284 = section_at_0(_S281);
    bool _S285;
    if(_S278.on_top_0)
    {
        _S285 = (_S283.distance_1) < (_S284.drop_0 * _S283.bend_1.sine_0);
    }
    else
    {
        _S285 = false;
    }
    bool _S286;
    if(_S278.on_top_0)
    {
        _S286 = !_S285;
    }
    else
    {
        _S286 = false;
    }
    float _S287;
    if(_S286)
    {
        _S287 = 1.0;
    }
    else
    {
        _S287 = -1.0;
    }
    float _S288;
    if(_S285)
    {
        _S288 = _S283.other_reach_0;
    }
    else
    {
        _S288 = _S283.reach_0;
    }
    float _S289;
    if(_S285)
    {
        _S289 = _S288 + _S283.distance_1;
    }
    else
    {
        _S289 = max(_S288 - _S283.distance_1, 0.0);
    }
    float _S290 = _S288 / _S283.bend_1.sine_0 - _S287 * _S284.drop_0;
    float _S291 = _S289 * _S289;
    float _S292 = max(_S290 * _S290 - _S291, 9.99999968265522539e-21);
    float _S293 = (inversesqrt((_S292)));
    float _S294 = _S291 / (_S292 * _S293 + _S290);
    bool _S295 = _S289 > 0.0;
    float _S296;
    if(_S278.on_top_0)
    {
        _S296 = 1.0;
    }
    else
    {
        _S296 = -1.0;
    }
    float _S297;
    if(_S283.near_start_0)
    {
        _S297 = 1.0;
    }
    else
    {
        _S297 = -1.0;
    }
    float _S298 = _S296 * _S297;
    if(_S295)
    {
        _S296 = _S290 * _S293;
    }
    else
    {
        _S296 = 1.0;
    }
    sample_1.slope_across_0 = _S284.slope_0 * _S296;
    if(_S295)
    {
        _S289 = _S298 * _S289 * _S293;
    }
    else
    {
        _S289 = 0.0;
    }
    sample_1.slope_along_0 = _S289;
    Family_0 _S299 = families_0._data[uint(_S279)];
    vec2 _S300 = dive_0(_S280, _S278, _S283, _S282);
    if(_S283.straight_0)
    {
        _S287 = 0.0;
    }
    else
    {
        _S287 = _S299.height_scale_0 * _S287;
    }
    sample_1.height_4 = _S287 * (_S288 * _S283.bend_1.half_tangent_0 - _S294) - _S299.height_scale_0 * _S284.drop_0 - _S300.x;
    float _S301 = _S299.height_scale_0 * sample_1.slope_across_0;
    float _S302 = _S299.height_scale_0 * sample_1.slope_along_0 - _S300.y;
    if(_S278.is_warp_0)
    {
        _S287 = _S301;
    }
    else
    {
        _S287 = _S302;
    }
    sample_1.slope_x_1 = _S287;
    if(_S278.is_warp_0)
    {
        _S287 = _S302;
    }
    else
    {
        _S287 = _S301;
    }
    sample_1.slope_y_1 = _S287;
    sample_1.run_3 = _S283;
    sample_1.section_1 = _S284;
    return sample_1;
}

float steps_per_length_0(uint _S303, SearchQuality_0 _S304, vec3 _S305)
{
    return max(max(abs(_S305.x) * fabrics_0._data[uint(_S303)].threads_per_x_0, abs(_S305.y) * fabrics_0._data[uint(_S303)].threads_per_y_0) * _S304.steps_per_thread_0, abs(_S305.z) * fabrics_0._data[uint(_S303)].per_relief_0 * _S304.steps_per_relief_0);
}

float cell_maximum_0(uint _S306, Crossing_0 _S307)
{
    uint _S308;
    if(_S307.warp_above_0)
    {
        _S308 = fabrics_0._data[uint(_S306)].warp_0;
    }
    else
    {
        _S308 = fabrics_0._data[uint(_S306)].weft_0;
    }
    uint _S309;
    if(_S307.warp_above_0)
    {
        _S309 = _S307.warp_word_0;
    }
    else
    {
        _S309 = _S307.weft_word_0;
    }
    return float(_S309 >> 28) * families_0._data[uint(_S308)].height_scale_0 * families_0._data[uint(_S308)].level_0;
}

Probe_0 probe_0(uint _S310, float _S311, float _S312, bool _S313, bool _S314, bool _S315)
{
    Sample_0 _S316 = sample_at_0(_S310, _S311, _S312, _S313);
    Probe_0 probe_1;
    probe_1.height_1 = _S316.height_4;
    probe_1.hole_1 = _S316.shown_3.hole_0;
    probe_1.slope_x_0 = _S316.slope_x_1;
    probe_1.slope_y_0 = _S316.slope_y_1;
    uint _S317;
    if(_S316.shown_3.is_warp_0)
    {
        _S317 = _S316.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S317 = _S316.crossing_1.weft_1.thread_1 * 2U;
    }
    probe_1.yarn_1 = _S317;
    probe_1.cell_max_0 = cell_maximum_0(_S310, _S316.crossing_1);
    float _S318;
    if(_S314)
    {
        _S318 = _S316.crossing_1.warp_1.above_0;
    }
    else
    {
        _S318 = _S316.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S318;
    if(_S315)
    {
        _S318 = _S316.crossing_1.weft_1.above_0;
    }
    else
    {
        _S318 = _S316.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S318;
    probe_1.edge_x_0 = outline_distance_0(_S316.crossing_1.warp_1, _S316.shown_3, _S316.run_3, !_S316.shown_3.is_warp_0, _S314);
    probe_1.edge_y_0 = outline_distance_0(_S316.crossing_1.weft_1, _S316.shown_3, _S316.run_3, _S316.shown_3.is_warp_0, _S315);
    return probe_1;
}

bool is_free_0(uint _S319, SearchQuality_0 _S320, vec3 _S321, vec3 _S322, bool _S323, float _S324)
{
    float _S325 = _S322.z;
    if(_S325 <= 0.0)
    {
        return false;
    }
    float _S326 = 1.0 / max(_S320.shadow_share_0 * steps_per_length_0(_S319, _S320, _S322), 9.99999971718068537e-10);
    StepControl_0 _S327 = step_control_0(_S322.xy, _S326);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_3 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S328;
        if(count_3 < 1024U)
        {
            _S328 = (_S321.z + _S325 * distance_3) < _S324;
        }
        else
        {
            _S328 = false;
        }
        if(_S328)
        {
        }
        else
        {
            break;
        }
        vec3 _S329 = _S321 + _S322 * distance_3;
        Probe_0 _S330 = probe_0(_S319, _S329.x, _S329.y, _S323, _S327.right_0, _S327.up_0);
        float _S331 = _S329.z;
        float _S332 = _S331 - _S330.height_1;
        float _S333 = _S325 - _S330.slope_x_0 * _S322.x - _S330.slope_y_0 * _S322.y;
        bool _S334;
        if(!_S330.hole_1)
        {
            _S334 = _S332 < 0.0;
        }
        else
        {
            _S334 = false;
        }
        if(_S334)
        {
            return false;
        }
        float _S335 = way_back_to_dip_0(previous_3, _S332, _S333, last_step_0, _S330);
        if(_S335 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S335;
            distance_3 = distance_3 - _S335;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S336 = _S331 > (_S330.cell_max_0);
        PreviousSample_0 _S337 = after_sample_0(_S332, _S333, _S330, _S336);
        float last_step_2;
        if(_S336)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S327, _S330.side_x_0, _S330.side_y_0), _S326);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S327, _S330, _S332, _S333);
        }
        float distance_4 = distance_3 + last_step_2;
        previous_3 = _S337;
        distance_3 = distance_4;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S338, SearchQuality_0 _S339, float _S340, float _S341, vec3 _S342, bool _S343)
{
    if(!sample_at_0(_S338, _S340, _S341, _S343).shown_3.hole_0)
    {
        return false;
    }
    vec3 _S344 = vec3(_S340, _S341, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S345;
        if(side_0 < 2U)
        {
            _S345 = passes_0;
        }
        else
        {
            _S345 = false;
        }
        if(_S345)
        {
        }
        else
        {
            break;
        }
        vec3 _S346;
        if(side_0 == 0U)
        {
            _S346 = _S342;
        }
        else
        {
            _S346 = vec3(- _S342.x, - _S342.y, _S342.z);
        }
        bool _S347 = is_free_0(_S338, _S339, _S344, _S346, _S343 != (side_0 == 1U), fabrics_0._data[uint(_S338)].height_high_0);
        uint _S348 = side_0 + 1U;
        passes_0 = _S347;
        side_0 = _S348;
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

float max_height_along_0(uint _S349, float _S350, float _S351, float _S352, vec3 _S353, bool _S354)
{
    uint _S355 = locate_0(fabrics_0._data[uint(_S349)].warp_0, _S350).thread_1 / 2U;
    uint _S356 = locate_0(fabrics_0._data[uint(_S349)].weft_0, _S351).thread_1 / 2U;
    float _S357 = _S353.x;
    uint _S358;
    if(_S357 > 0.0)
    {
        _S358 = 1U;
    }
    else
    {
        _S358 = 0U;
    }
    float _S359 = _S353.y;
    uint _S360;
    if(_S359 > 0.0)
    {
        _S360 = 2U;
    }
    else
    {
        _S360 = 0U;
    }
    uint _S361 = words_0._data[uint(fabrics_0._data[uint(_S349)].max_heights_0 + 4U * (_S356 * fabrics_0._data[uint(_S349)].max_height_columns_0 + _S355) + (_S358 + _S360))];
    int number_2;
    if(_S354)
    {
        number_2 = 4;
    }
    else
    {
        number_2 = 0;
    }
    uint _S362 = _S361 >> number_2;
    float _S363 = max(abs(_S357) * fabrics_0._data[uint(_S349)].threads_per_x_0, abs(_S359) * fabrics_0._data[uint(_S349)].threads_per_y_0) / _S353.z;
    float _S364 = fabrics_0._data[uint(_S349)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S349)].height_high_0;
    number_2 = 3;
    for(;;)
    {
        if(number_2 >= 0)
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S352) * _S363) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, float((_S362 >> uint(8 * number_2)) & 15U) * 0.06666667014360428 * _S364);
        }
        number_2 = number_2 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S365, float _S366, float _S367, bool _S368, bool _S369, bool _S370)
{
    Crossing_0 _S371 = crossing_at_0(_S365, _S366, _S367, _S368);
    float _S372 = cell_maximum_0(_S365, _S371);
    float _S373;
    if(_S369)
    {
        _S373 = _S371.warp_1.above_0;
    }
    else
    {
        _S373 = _S371.warp_1.below_0;
    }
    float _S374;
    if(_S370)
    {
        _S374 = _S371.weft_1.above_0;
    }
    else
    {
        _S374 = _S371.weft_1.below_0;
    }
    return vec3(_S372, _S373, _S374);
}

float first_sample_height_0(uint _S375, ViewRay_0 _S376, StepControl_0 _S377, bool _S378)
{
    float _S379 = max_height_along_0(_S375, _S376.origin_2.x, _S376.origin_2.y, 0.0, vec3(_S376.slope_1, 1.0), _S378);
    uint count_4 = 0U;
    float height_6 = _S379;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S380 = ViewRay_at_0(_S376, height_6);
        vec3 _S381 = cell_bounds_0(_S375, _S380.x, _S380.y, _S378, _S377.right_0, _S377.up_0);
        float _S382 = height_6 - _S381.x;
        float _S383 = StepControl_to_cell_exit_0(_S377, _S381.y, _S381.z);
        float height_7 = height_6 - clamp(_S382, 0.0, _S383);
        if(_S382 <= _S383)
        {
            height_6 = height_7;
            break;
        }
        count_4 = count_4 + 1U;
        height_6 = height_7;
    }
    return height_6;
}

ViewRayEnd_0 search_down_0(uint _S384, ViewRay_0 _S385, StepControl_0 _S386, bool _S387)
{
    float _S388 = fabrics_0._data[uint(_S384)].height_low_0 - (fabrics_0._data[uint(_S384)].height_high_0 - fabrics_0._data[uint(_S384)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_5 = first_sample_height_0(_S384, _S385, _S386, _S387);
    end_1.last_step_3 = _S386.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_0 = 0.0;
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
        vec2 _S389 = ViewRay_at_0(_S385, end_1.height_5);
        Probe_0 _S390 = probe_0(_S384, _S389.x, _S389.y, _S387, _S386.right_0, _S386.up_0);
        float _S391 = end_1.height_5 - _S390.height_1;
        float _S392 = ViewRay_rate_0(_S385, _S390);
        end_1.depth_0 = - _S391;
        end_1.rate_4 = _S392;
        bool _S393;
        if(end_1.previous_4.known_0)
        {
            _S393 = !_S390.hole_1;
        }
        else
        {
            _S393 = false;
        }
        bool _S394;
        if(_S393)
        {
            _S394 = (end_1.previous_4.yarn_0) == (_S390.yarn_1);
        }
        else
        {
            _S394 = false;
        }
        end_1.smooth_0 = _S394;
        bool _S395;
        if(!_S390.hole_1)
        {
            _S395 = _S391 <= 0.0;
        }
        else
        {
            _S395 = false;
        }
        bool _S396;
        if(_S395)
        {
            _S396 = true;
        }
        else
        {
            _S396 = (end_1.height_5) <= _S388;
        }
        if(_S396)
        {
            break;
        }
        float _S397 = way_back_to_dip_0(end_1.previous_4, _S391, _S392, end_1.last_step_3, _S390);
        if(_S397 >= 0.0)
        {
            end_1.height_5 = end_1.height_5 + _S397;
            end_1.last_step_3 = end_1.last_step_3 - _S397;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S398 = min(StepControl_to_cell_exit_0(_S386, _S390.side_x_0, _S390.side_y_0), end_1.height_5 - _S390.cell_max_0);
        float _S399 = StepControl_to_next_sample_0(_S386, _S390, _S391, _S392);
        end_1.previous_4 = after_sample_0(_S391, _S392, _S390, _S398 > _S399);
        float _S400 = max(_S398, _S399);
        end_1.last_step_3 = _S400;
        end_1.height_5 = end_1.height_5 - _S400;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S401, ViewRay_0 _S402, StepControl_0 _S403, bool _S404, ViewRayEnd_0 _S405, uint _S406)
{
    float _S407 = fabrics_0._data[uint(_S401)].height_high_0 - fabrics_0._data[uint(_S401)].height_low_0;
    float above_2 = _S405.height_5 + _S405.last_step_3;
    float above_gap_1 = clamp(_S405.previous_4.clearance_0, 0.0, _S407);
    float under_gap_1 = clamp(_S405.depth_0, 0.0, _S407);
    float _S408 = cubic_root_0(above_gap_1, - under_gap_1, _S405.previous_4.rate_0 * _S405.last_step_3, _S405.rate_4 * _S405.last_step_3);
    float middle_0;
    if(_S405.smooth_0)
    {
        middle_0 = above_2 - _S408 * _S405.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S405.height_5, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S405.height_5;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S406)
        {
        }
        else
        {
            break;
        }
        vec2 _S409 = ViewRay_at_0(_S402, middle_0);
        Probe_0 _S410 = probe_0(_S401, _S409.x, _S409.y, _S404, _S403.right_0, _S403.up_0);
        float _S411;
        if(_S410.hole_1)
        {
            _S411 = -1.0e+09;
        }
        else
        {
            _S411 = _S410.height_1;
        }
        float _S412 = clamp(middle_0 - _S411, - _S407, _S407);
        float _S413;
        if(_S412 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S413 = 0.5 * above_gap_2;
            }
            else
            {
                _S413 = above_gap_2;
            }
            float _S414 = - _S412;
            under_1 = middle_0;
            above_gap_2 = _S413;
            under_gap_2 = _S414;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S413 = 0.5 * under_gap_2;
            }
            else
            {
                _S413 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S412;
            under_gap_2 = _S413;
            side_1 = -1.0;
        }
        if(_S405.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S412 / min(ViewRay_rate_0(_S402, _S410), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S405.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_1 first_hit_of_yarn_0(uint _S415, SearchQuality_0 _S416, float _S417, float _S418, vec3 _S419, bool _S420)
{
    float _S421 = max(_S419.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_2 = vec2(_S417, _S418);
    vec2 _S422 = _S419.xy / _S421;
    ray_0.slope_1 = _S422;
    StepControl_0 _S423 = step_control_0(- _S422, 1.0 / max(steps_per_length_0(_S415, _S416, _S419) / _S421, 9.99999971718068537e-10));
    ViewRayEnd_0 _S424 = search_down_0(_S415, ray_0, _S423, _S420);
    Hit_1 hit_1;
    hit_1.hole_2 = false;
    float _S425 = refined_height_0(_S415, ray_0, _S423, _S420, _S424, _S416.refinements_0);
    hit_1.height_3 = _S425;
    vec2 _S426 = ViewRay_at_0(ray_0, _S425);
    hit_1.x_13 = _S426.x;
    hit_1.y_7 = _S426.y;
    return hit_1;
}

Hit_1 first_hit_0(uint _S427, SearchQuality_0 _S428, float _S429, float _S430, vec3 _S431, bool _S432)
{
    if(!passes_through_0(_S427, _S428, _S429, _S430, _S431, _S432))
    {
        return first_hit_of_yarn_0(_S427, _S428, _S429, _S430, _S431, _S432);
    }
    Hit_1 hit_2;
    hit_2.x_13 = _S429;
    hit_2.y_7 = _S430;
    hit_2.height_3 = 0.0;
    hit_2.hole_2 = true;
    return hit_2;
}

struct CoverageTaps_0
{
    uint  nodes_1[9];
};

vec3 pyramid_level_0(uint _S433, float _S434)
{
    uint _S435 = fabrics_0._data[uint(_S433)].lobes_0.levels_0 + 4U * uint(min(_S434, fabrics_0._data[uint(_S433)].lobes_0.last_level_0));
    return vec3(table_number_0(_S435), table_number_0(_S435 + 1U), table_number_0(_S435 + 2U));
}

CoverageTaps_0 coverage_taps_0(uint _S436, Footprint_0 _S437, bool _S438)
{
    Lobes_0 _S439 = fabrics_0._data[uint(_S436)].lobes_0;
    float _S440 = Footprint_spread_side_0(_S437) * fabrics_0._data[uint(_S436)].lobes_0.inverse_base_size_0;
    vec3 _S441 = pyramid_level_0(_S436, floor(binary_logarithm_0(max(0.68000000715255737 * _S440, 1.0))));
    float _S442 = 1.0 / max(_S440, 9.99999997475242708e-07);
    float _S443 = min(max(sqrt(clamp(1.29999995231628418 * (1.0 - _S442 * _S442), 0.0, 1.0)), 0.3333333432674408 * _S442), 1.0);
    vec2 _S444 = vec2(families_0._data[uint(fabrics_0._data[uint(_S436)].warp_0)].inverse_period_0, families_0._data[uint(fabrics_0._data[uint(_S436)].weft_0)].inverse_period_0);
    vec2 _S445 = _S437.centre_0 * _S444;
    vec2 _S446 = _S437.dx_0 * _S444 * _S443;
    vec2 _S447 = _S437.dy_0 * _S444 * _S443;
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
        vec2 _S448 = _S445 + TAP_OFFSETS_0[number_3].x * _S446 + TAP_OFFSETS_0[number_3].y * _S447;
        float _S449 = _S441.y;
        float _S450 = wrapped_cell_0(_S448.x, _S449);
        float _S451 = wrapped_cell_0(_S448.y, _S441.z);
        uint _S452;
        if(_S438)
        {
            _S452 = _S439.face_nodes_0;
        }
        else
        {
            _S452 = 0U;
        }
        taps_3.nodes_1[number_3] = _S452 + uint(_S451 * _S449 + _S450 + _S441.x);
        number_3 = number_3 + 1U;
    }
    return taps_3;
}

float coverage_of_holes_0(uint _S453, CoverageTaps_0 _S454)
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
        uint total_1 = total_0 + (((words_0._data[uint(fabrics_0._data[uint(_S453)].lobes_0.coverage_holes_0 + _S454.nodes_1[number_4] / 4U)]) >> (8U * (_S454.nodes_1[number_4] % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0;
}

float prefiltered_hole_0(uint _S455, CoverageTaps_0 _S456, NodeTaps_0 _S457, bool _S458)
{
    Lobes_0 _S459 = fabrics_0._data[uint(_S455)].lobes_0;
    float _S460 = interpolate_table_0(_S457, fabrics_0._data[uint(_S455)].lobes_0.projected_area_0 + fabrics_0._data[uint(_S455)].lobes_0.packs_0, fabrics_0._data[uint(_S455)].lobes_0.packs_0 + 1U).x;
    float _S461;
    if(_S458)
    {
        _S461 = _S459.back_hole_weight_0;
    }
    else
    {
        _S461 = _S459.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S455, _S456) * _S460 * _S460 * _S461, 1.0);
}

float passed_share_0(uint _S462, VisiblePoint_0 _S463, vec3 _S464, float _S465, vec2 _S466)
{
    vec3 _S467 = to_local_0(_S463, _S464);
    bool _S468 = (_S467.z) < 0.0;
    vec3 _S469 = to_face_frame_0(_S467, _S468);
    Footprint_0 footprint_0;
    footprint_0.centre_0 = _S463.draft_0;
    footprint_0.dx_0 = vec2(_S465, 0.0);
    footprint_0.dy_0 = vec2(0.0, _S465);
    float _S470;
    if((fabrics_0._data[uint(_S462)].lobes_0.is_baked_0) != 0U)
    {
        _S470 = regime_of_0(_S462, footprint_0, 1.0).prefiltered_0;
    }
    else
    {
        _S470 = 0.0;
    }
    float share_2;
    if(_S470 < 1.0)
    {
        vec2 _S471 = footprint_0.centre_0 + (_S466 - 0.5) * _S465;
        if(first_hit_0(_S462, default_quality_0(), _S471.x, _S471.y, _S469, _S468).hole_2)
        {
            share_2 = 1.0 - _S470;
        }
        else
        {
            share_2 = 0.0;
        }
    }
    else
    {
        share_2 = 0.0;
    }
    if(_S470 > 0.0)
    {
        NodeTaps_0 nodes_2 = node_taps_0(_S469);
        uint _S472;
        if(_S468)
        {
            _S472 = 1U;
        }
        else
        {
            _S472 = 0U;
        }
        nodes_2.nodes_0 = nodes_2.nodes_0 + _S472 * 256U;
        share_2 = share_2 + _S470 * prefiltered_hole_0(_S462, coverage_taps_0(_S462, footprint_0, _S468), nodes_2, _S468);
    }
    float _S473 = fabrics_0._data[uint(_S462)].sheen_strength_0;
    if((fabrics_0._data[uint(_S462)].sheen_strength_0) > 0.0)
    {
        share_2 = share_2 * (1.0 - _S473 * sheen_lobe_0(_S469.z, fabrics_0._data[uint(_S462)].sheen_roughness_0).z);
    }
    return share_2;
}

float visibility_of_0(int _S474, VisiblePoint_0 _S475, uint _S476, uvec2 _S477, uint _S478)
{
    LightSample_0 _S479 = light_sample_0(_S474, _S478, _S477, _S475.position_0);
    float nearest_1;
    if((dot(_S479.towards_0, _S475.face_normal_0)) < 0.0)
    {
        nearest_1 = -1.0;
    }
    else
    {
        nearest_1 = 1.0;
    }
    vec3 _S480 = _S475.position_0 + nearest_1 * frames_0._data[uint(_S474)].ray_offset_0 * _S475.face_normal_0;
    vec2 _S481 = _S475.draft_dx_0;
    vec2 _S482 = _S475.draft_dy_0;
    float _S483 = sqrt(0.5 * (dot(_S481, _S481) + dot(_S482, _S482)));
    nearest_1 = 0.0;
    uint without_0 = _S476;
    uint layer_0 = 0U;
    float visibility_0 = 1.0;
    for(;;)
    {
        bool _S484;
        if(layer_0 < 8U)
        {
            _S484 = visibility_0 > 0.00100000004749745;
        }
        else
        {
            _S484 = false;
        }
        if(_S484)
        {
        }
        else
        {
            break;
        }
        Hit_0 _S485 = nearest_hit_0(_S474, _S480, _S479.towards_0, nearest_1, _S479.distance_2, without_0, true);
        if((_S485.face_1) == 4294967295U)
        {
            break;
        }
        uint _S486 = face_fabrics_0._data[uint(_S485.face_1)];
        VisiblePoint_0 _S487 = face_point_0(_S486, _S485.face_1, _S485.weight_b_0, _S485.weight_c_0);
        vec2 _S488 = pixel_sequence_0(_S477, frames_0._data[uint(_S474)].pass_number_0, 5U + 2U * (8U * _S478 + layer_0));
        float _S489;
        if((fabrics_0._data[uint(_S486)].is_open_0) != 0U)
        {
            _S489 = passed_share_0(_S486, _S487, - _S479.towards_0, _S483, _S488);
        }
        else
        {
            _S489 = 0.0;
        }
        float visibility_1 = visibility_0 * _S489;
        uint _S490 = layer_0 + 1U;
        nearest_1 = _S485.distance_0;
        without_0 = _S485.face_1;
        layer_0 = _S490;
        visibility_0 = visibility_1;
    }
    if(visibility_0 > 0.00100000004749745)
    {
        nearest_1 = visibility_0;
    }
    else
    {
        nearest_1 = 0.0;
    }
    return nearest_1;
}

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
void main()
{
    uint _S491 = frames_0._data[uint(0)].width_0;
    bool _S492;
    if((gl_GlobalInvocationID.x) >= (frames_0._data[uint(0)].width_0))
    {
        _S492 = true;
    }
    else
    {
        _S492 = (gl_GlobalInvocationID.y) >= (frames_0._data[uint(0)].height_0);
    }
    if(_S492)
    {
        return;
    }
    uint _S493 = gl_GlobalInvocationID.y * _S491 + gl_GlobalInvocationID.x;
    uint _S494 = layers_0._data[uint(_S493)].face_0;
    if((layers_0._data[uint(_S493)].face_0) == 0U)
    {
        return;
    }
    uint _S495 = _S494 - 1U;
    VisiblePoint_0 _S496 = visible_point_0(0, face_fabrics_0._data[uint(_S495)], _S495, gl_GlobalInvocationID.xy);
    uint number_5 = 0U;
    for(;;)
    {
        if(number_5 < (light_sample_count_0(0)))
        {
        }
        else
        {
            break;
        }
        visibilities_0._data[uint(number_5 * _S491 * frames_0._data[uint(0)].height_0 + _S493)] = visibility_of_0(0, _S496, _S495, gl_GlobalInvocationID.xy, number_5);
        number_5 = number_5 + 1U;
    }
    return;
}

