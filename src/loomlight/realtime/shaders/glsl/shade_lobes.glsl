#version 450
#extension GL_EXT_samplerless_texture_functions : require
layout(row_major) uniform;
layout(row_major) buffer;
struct Frame_0
{
    uint width_0;
    uint height_0;
    uint lights_0;
    uint samples_0;
    uint pass_number_0;
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
layout(binding = 11)
uniform utexture2D visible_faces_0;

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

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Woven_0 woven_0;
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
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_2 {
    uint _data[];
} words_0;
layout(std430, binding = 8) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} radiance_0;
vec3 saturate_0(vec3 x_2)
{
    return clamp(x_2, vec3(0.0), vec3(1.0));
}

const vec2  TAP_OFFSETS_0[9] = vec2[](vec2(-0.3333333432674408, -0.3333333432674408), vec2(-0.3333333432674408, 0.0), vec2(-0.3333333432674408, 0.3333333432674408), vec2(0.0, -0.3333333432674408), vec2(0.0, 0.0), vec2(0.0, 0.3333333432674408), vec2(0.3333333432674408, -0.3333333432674408), vec2(0.3333333432674408, 0.0), vec2(0.3333333432674408, 0.3333333432674408));
const float  PYRAMID_RADII_0[4] = float[](1.0, 2.0, 4.0, 8.0);
const vec2  POINT_OFFSETS_0[8] = vec2[](vec2(0.0, 0.0), vec2(-0.23010000586509705, 0.35670000314712524), vec2(0.36809998750686646, -0.22939999401569366), vec2(-0.28040000796318054, -0.34400001168251038), vec2(0.3465999960899353, 0.28859999775886536), vec2(-0.36349999904632568, 0.0511000007390976), vec2(0.09929999709129333, -0.35699999332427979), vec2(0.10710000246763229, 0.32879999279975891));
vec3 position_of_0(Vertex_0 vertex_0)
{
    return vec3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(vec3 v_1)
{
    return dot(v_1, v_1);
}

vec3 camera_right_0(Frame_0 frame_0)
{
    return vec3(frame_0.right_x_0, frame_0.right_y_0, frame_0.right_z_0);
}

vec3 camera_up_0(Frame_0 frame_1)
{
    return vec3(frame_1.up_x_0, frame_1.up_y_0, frame_1.up_z_0);
}

vec3 camera_forward_0(Frame_0 frame_2)
{
    return vec3(frame_2.forward_x_0, frame_2.forward_y_0, frame_2.forward_z_0);
}

vec3 camera_origin_0(Frame_0 frame_3)
{
    return vec3(frame_3.origin_x_0, frame_3.origin_y_0, frame_3.origin_z_0);
}

vec3 normal_of_0(Vertex_0 vertex_1)
{
    return vec3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

struct VisiblePoint_0
{
    vec3 position_0;
    vec3 view_0;
    vec3 axis_x_0;
    vec3 axis_y_0;
    vec3 normal_0;
    vec2 draft_0;
    vec2 draft_dx_0;
    vec2 draft_dy_0;
};

vec3 to_local_0(VisiblePoint_0 point_0, vec3 direction_0)
{
    return vec3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

vec3 towards_light_0(Light_0 light_0, vec3 position_1, out vec3 irradiance_1)
{
    irradiance_1 = vec3(light_0.red_0, light_0.green_0, light_0.blue_0);
    vec3 _S1 = vec3(light_0.x_1, light_0.y_1, light_0.z_1);
    if((light_0.is_point_0) == 0U)
    {
        return _S1;
    }
    vec3 _S2 = _S1 - position_1;
    irradiance_1 = irradiance_1 / max(square_0(_S2), 9.999999960041972e-13);
    return normalize(_S2);
}

struct Footprint_0
{
    vec2 centre_0;
    vec2 dx_0;
    vec2 dy_0;
};

float Footprint_spread_side_0(Footprint_0 this_0)
{
    vec2 _S3 = this_0.dx_0;
    vec2 _S4 = this_0.dy_0;
    return sqrt(0.5 * (dot(_S3, _S3) + dot(_S4, _S4)));
}

float natural_logarithm_0(float x_3)
{
    uint _S5 = floatBitsToUint(x_3);
    float exponent_0 = float(int(_S5 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S5 & 8388607U) | 1056964608U);
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
    float _S6 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S6 - exponent_1 * 0.00021219444170129 - 0.5 * _S6) + exponent_1 * 0.693359375;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335;
}

vec3 to_face_frame_0(vec3 direction_1, bool back_0)
{
    vec2 _S7 = direction_1.xy;
    float _S8;
    if(back_0)
    {
        _S8 = - direction_1.z;
    }
    else
    {
        _S8 = direction_1.z;
    }
    return vec3(_S7, _S8);
}

struct SurfacePoint_0
{
    bool hole_0;
    bool is_warp_0;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_1;
    vec3 normal_1;
    vec3 tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_2, vec3 normal_2, vec3 tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S9;
    _S9.hole_0 = hole_1;
    _S9.is_warp_0 = is_warp_1;
    _S9.warp_thread_0 = warp_thread_1;
    _S9.weft_thread_0 = weft_thread_1;
    _S9.height_1 = height_2;
    _S9.normal_1 = normal_2;
    _S9.tangent_0 = tangent_1;
    _S9.across_0 = across_1;
    _S9.fibre_across_0 = fibre_across_1;
    _S9.fibre_along_0 = fibre_along_1;
    return _S9;
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
    float _S10 = clamp((-3.0 - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10))) / 2.0, 0.0, 1.0);
    SearchQuality_0 quality_0;
    float _S11 = mix(2.5, 5.0, _S10);
    quality_0.steps_per_thread_0 = _S11;
    quality_0.steps_per_relief_0 = _S11;
    quality_0.shadow_share_0 = mix(1.60000002384185791, 1.0, _S10);
    quality_0.refinements_0 = uint(mix(1.0, 2.0, _S10) + 0.5);
    return quality_0;
}

vec2 turns_and_remainder_0(uint family_0, float index_0)
{
    float _S12 = floor(fma(index_0, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S12, fma(- _S12, families_0._data[uint(family_0)].count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_2)
{
    float _S13 = floor(position_2 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S14 = fma(- _S13, families_0._data[uint(family_1)].size_0, position_2);
    cell_0.below_0 = _S14;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S14;
    cell_0.across_2 = _S14 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S13).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_0;
}

float table_number_0(uint index_1)
{
    return uintBitsToFloat(words_0._data[uint(index_1)]);
}

Cell_0 locate_varied_0(uint family_2, float position_3)
{
    float turns_0 = (position_3 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S15 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S16;
    if(_S15 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S16 = 1U;
    }
    else
    {
        _S16 = 0U;
    }
    uint _S17 = min(thread_1 + _S16, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S18 = families_0._data[uint(family_2)].place_table_0 + _S17 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S17;
    cell_1.below_0 = _S15 - table_number_0(_S18);
    cell_1.above_0 = table_number_0(_S18 + 1U) - _S15;
    cell_1.across_2 = _S15 - table_number_0(_S18 + 2U);
    cell_1.half_width_1 = table_number_0(_S18 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_4)
{
    if((families_0._data[uint(family_3)].is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_4);
    }
    return locate_varied_0(family_3, position_4);
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

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_1)
{
    bool _S19 = (abs(crossing_0.warp_1.across_2)) < (crossing_0.warp_1.half_width_1);
    bool _S20 = (abs(crossing_0.weft_1.across_2)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S21;
    if(_S19)
    {
        if(!_S20)
        {
            _S21 = true;
        }
        else
        {
            _S21 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S21 = false;
    }
    shown_0.is_warp_2 = _S21;
    if(!_S19)
    {
        _S21 = !_S20;
    }
    else
    {
        _S21 = false;
    }
    shown_0.hole_3 = _S21;
    uint _S22;
    if(shown_0.is_warp_2)
    {
        _S22 = crossing_0.warp_word_0;
    }
    else
    {
        _S22 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S22;
    shown_0.on_top_0 = ((_S22 & 1U) == 1U) != back_1;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_2;
    uint _S23;
    if(is_first_0)
    {
        _S23 = first_0.thread_0;
    }
    else
    {
        _S23 = second_0.thread_0;
    }
    cell_2.thread_0 = _S23;
    float _S24;
    if(is_first_0)
    {
        _S24 = first_0.across_2;
    }
    else
    {
        _S24 = second_0.across_2;
    }
    cell_2.across_2 = _S24;
    if(is_first_0)
    {
        _S24 = first_0.half_width_1;
    }
    else
    {
        _S24 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S24;
    if(is_first_0)
    {
        _S24 = first_0.below_0;
    }
    else
    {
        _S24 = second_0.below_0;
    }
    cell_2.below_0 = _S24;
    if(is_first_0)
    {
        _S24 = first_0.above_0;
    }
    else
    {
        _S24 = second_0.above_0;
    }
    cell_2.above_0 = _S24;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0)
{
    vec2 _S25 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    return fma(_S25.x, families_0._data[uint(family_4)].period_0, table_number_0(families_0._data[uint(family_4)].place_table_0 + uint(_S25.y) * 4U));
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
    Family_0 _S26 = families_0._data[uint(family_6)];
    uint _S27;
    if((families_0._data[uint(family_6)].is_alike_0) != 0U)
    {
        _S27 = 0U;
    }
    else
    {
        _S27 = thread_4 * 4U;
    }
    uint _S28 = _S26.bend_table_0 + _S27;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S28);
    bend_0.half_tangent_0 = table_number_0(_S28 + 1U);
    bend_0.arc_0 = table_number_0(_S28 + 2U);
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
    int _S29 = int((word_1 >> 1) & 127U);
    int _S30 = int((word_1 >> 8) & 127U);
    int _S31 = int((word_1 >> 15) & 63U);
    int _S32 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S33 = - _S29;
    float _S34 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S33, 0);
    run_0.from_start_0 = _S34;
    int _S35 = _S30 + 1;
    float _S36 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, 1, _S35);
    run_0.to_end_0 = _S36;
    bool _S37 = _S34 < _S36;
    run_0.near_start_0 = _S37;
    int _S38;
    if(_S37)
    {
        _S38 = _S33 - _S31;
    }
    else
    {
        _S38 = _S35;
    }
    int _S39;
    if(run_0.near_start_0)
    {
        _S39 = _S33;
    }
    else
    {
        _S39 = _S35 + _S32;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    float _S40;
    if(run_0.straight_0)
    {
        _S40 = 1.0e+06;
    }
    else
    {
        _S40 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S40;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_0, crossed_0.thread_0, _S38, _S39), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S29 == 0;
    run_0.last_crossing_0 = _S30 == 0;
    return run_0;
}

float square_1(float x_5)
{
    return x_5 * x_5;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_3)
{
    float _S41 = cell_3.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S42 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S42;
    float _S43 = _S41 * _S41 - square_1(_S42);
    float _S44 = (inversesqrt((_S43)));
    section_0.drop_0 = _S41 - _S43 * _S44;
    section_0.slope_0 = - _S42 * _S44;
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
    bool _S45 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S46 = min(crossed_1.below_0, crossed_1.above_0);
    float _S47;
    if(_S45)
    {
        _S47 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S47 = crossed_1.above_0 + crossed_1.across_2;
    }
    float _S48 = _S47 - crossed_1.half_width_1;
    bool _S49;
    if(_S45)
    {
        _S49 = run_1.first_crossing_0;
    }
    else
    {
        _S49 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S47 = 0.0;
    }
    else
    {
        _S47 = families_0._data[uint(other_1)].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, 0);
    }
    float _S50;
    if((shown_1.on_top_0) != _S49)
    {
        _S50 = 0.0;
    }
    else
    {
        Family_0 _S51 = families_0._data[uint(other_1)];
        int _S52;
        if(_S45)
        {
            _S52 = -1;
        }
        else
        {
            _S52 = 1;
        }
        _S50 = _S51.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S52);
    }
    float _S53 = 1.0 / max(2.0 * _S48, 9.999999960041972e-13);
    float _S54 = clamp((_S48 - _S46) * _S53, 0.0, 1.0);
    float _S55 = _S47 + (_S50 - _S47) * (_S54 * _S54 * (3.0 - 2.0 * _S54));
    float _S56 = (_S47 - _S50) * (6.0 * _S54 * (1.0 - _S54) * _S53);
    if(_S45)
    {
        _S47 = 1.0;
    }
    else
    {
        _S47 = -1.0;
    }
    return vec2(_S55, _S56 * _S47);
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

StepControl_0 step_control_0(vec2 direction_2, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129 * step_3;
    float _S57 = direction_2.x;
    control_0.per_x_0 = 1.0 / max(abs(_S57), 9.99999971718068537e-10);
    float _S58 = direction_2.y;
    control_0.per_y_0 = 1.0 / max(abs(_S58), 9.99999971718068537e-10);
    control_0.right_0 = _S57 > 0.0;
    control_0.up_0 = _S58 > 0.0;
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
    float _S59;
    if(forwards_0)
    {
        _S59 = cell_4.across_2;
    }
    else
    {
        _S59 = - cell_4.across_2;
    }
    float _S60;
    if(forwards_0)
    {
        _S60 = cell_4.above_0;
    }
    else
    {
        _S60 = cell_4.below_0;
    }
    bool _S61;
    if(forwards_0)
    {
        _S61 = run_2.last_crossing_0;
    }
    else
    {
        _S61 = run_2.first_crossing_0;
    }
    bool _S62;
    if(forwards_0)
    {
        _S62 = run_2.first_crossing_0;
    }
    else
    {
        _S62 = run_2.last_crossing_0;
    }
    float _S63 = - cell_4.half_width_1;
    bool _S64 = _S59 < _S63;
    bool _S65 = _S59 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S61 = !_S61;
    }
    else
    {
        _S61 = false;
    }
    if(_S61)
    {
        _S61 = !shown_2.hole_3;
    }
    else
    {
        _S61 = false;
    }
    bool _S66;
    if(_S61)
    {
        _S66 = shown_2.on_top_0;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        if(_S62)
        {
            _S62 = _S64;
        }
        else
        {
            _S62 = false;
        }
        _S62 = !_S62;
    }
    else
    {
        _S62 = false;
    }
    if(shown_2.hole_3)
    {
        _S61 = true;
    }
    else
    {
        if(_S61)
        {
            _S61 = !shown_2.on_top_0;
        }
        else
        {
            _S61 = false;
        }
    }
    float _S67;
    if(_S64)
    {
        _S67 = _S63;
    }
    else
    {
        _S67 = cell_4.half_width_1;
    }
    float _S68 = _S67 - _S59;
    if(_S61)
    {
        _S59 = 2.0 * _S60 + _S59 - cell_4.half_width_1;
    }
    else
    {
        _S59 = _S60;
    }
    if(_S62)
    {
        if(forwards_0)
        {
            _S59 = run_2.to_end_0;
        }
        else
        {
            _S59 = run_2.from_start_0;
        }
        return _S59;
    }
    if(_S65)
    {
    }
    else
    {
        _S59 = _S68;
    }
    return _S59;
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
    float _S69 = previous_1.rate_0 * step_4;
    float _S70 = rate_1 * step_4;
    bool _S71;
    if(!previous_1.known_0)
    {
        _S71 = true;
    }
    else
    {
        _S71 = here_0.hole_4;
    }
    if(_S71)
    {
        _S71 = true;
    }
    else
    {
        _S71 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S71)
    {
        _S71 = true;
    }
    else
    {
        _S71 = (previous_1.rate_0) >= 0.0;
    }
    if(_S71)
    {
        _S71 = true;
    }
    else
    {
        _S71 = rate_1 <= 0.0;
    }
    if(_S71)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S69) >= 0.0)
    {
        _S71 = (3.0 * clearance_1 - _S70) >= 0.0;
    }
    else
    {
        _S71 = false;
    }
    if(_S71)
    {
        return -1.0;
    }
    float _S72 = clearance_1 - previous_1.clearance_0;
    float _S73 = 6.0 * _S72 - 4.0 * _S69 - 2.0 * _S70;
    float _S74 = -2.0 * _S69 / max(_S73 + sqrt(max(_S73 * _S73 - 4.0 * (3.0 * (_S69 + _S70 - 2.0 * _S72)) * _S69, 0.0)), 9.99999968265522539e-21);
    float _S75 = 1.0 - _S74;
    float _S76 = (previous_1.clearance_0 * (2.0 * _S74 + 1.0) + _S69 * _S74) * _S75 * _S75;
    float _S77 = (clearance_1 * (2.0 * _S75 + 1.0) - _S70 * _S75) * _S74 * _S74;
    if(_S74 > 0.01999999955296516)
    {
        _S71 = _S75 > 0.01999999955296516;
    }
    else
    {
        _S71 = false;
    }
    if(_S71)
    {
        _S71 = (_S76 + _S77) < 0.0;
    }
    else
    {
        _S71 = false;
    }
    float _S78;
    if(_S71)
    {
        _S78 = _S75 * step_4;
    }
    else
    {
        _S78 = -1.0;
    }
    return _S78;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S79;
    if(here_1.hole_4)
    {
        _S79 = 1.0e+09;
    }
    else
    {
        _S79 = clearance_2;
    }
    previous_2.clearance_0 = _S79;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S80;
    if(!here_1.hole_4)
    {
        _S80 = !is_cell_exit_0;
    }
    else
    {
        _S80 = false;
    }
    previous_2.known_0 = _S80;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S81 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S82;
    if(!here_2.hole_4)
    {
        _S82 = (rate_3 * _S81 + clearance_3) < 0.0;
    }
    else
    {
        _S82 = false;
    }
    if(_S82)
    {
        _S82 = _S81 > (2.0 * this_2.epsilon_0);
    }
    else
    {
        _S82 = false;
    }
    float _S83;
    if(_S82)
    {
        _S83 = _S81 - this_2.epsilon_0;
    }
    else
    {
        _S83 = max(_S81, 0.0) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S83);
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
    float _S84 = end_0 - start_1;
    float _S85 = start_rate_0 + end_rate_0 - 2.0 * _S84;
    float _S86 = 3.0 * _S84 - 2.0 * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S84, 9.99999968265522539e-21);
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
        float _S87 = clamp(share_0 - (((_S85 * share_0 + _S86) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0 * _S85 * share_0 + 2.0 * _S86) * share_0 + start_rate_0, 0.10000000149011612 * _S84 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S88 = i_0 + 1;
        share_0 = _S87;
        i_0 = _S88;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

vec2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S89 = along_slope_0 * along_slope_0 + 1.0;
    float _S90 = (inversesqrt((_S89)));
    float _S91 = sine_1 * _S90 * (inversesqrt((_S89 + across_slope_0 * across_slope_0)));
    return vec2(- _S91 * _S89, _S91 * across_slope_0 * along_slope_0 + cosine_0 * _S90);
}

float arc_sine_0(float x_6)
{
    float _S92 = abs(x_6);
    bool _S93 = _S92 > 0.5;
    float _S94;
    if(_S93)
    {
        _S94 = 0.5 * (1.0 - _S92);
    }
    else
    {
        _S94 = _S92 * _S92;
    }
    float _S95;
    if(_S93)
    {
        _S95 = sqrt(max(_S94, 0.0));
    }
    else
    {
        _S95 = _S92;
    }
    float _S96 = ((((0.04216320067644119 * _S94 + 0.02418131195008755) * _S94 + 0.04547002539038658) * _S94 + 0.07495300471782684) * _S94 + 0.16666752099990845) * _S94 * _S95 + _S95;
    if(_S93)
    {
        _S94 = 1.57079637050628662 - 2.0 * _S96;
    }
    else
    {
        _S94 = _S96;
    }
    if(x_6 < 0.0)
    {
        _S94 = - _S94;
    }
    return _S94;
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
    uint _S97 = value_0 * 747796405U + 2891336453U;
    uint _S98 = ((_S97 >> ((_S97 >> 28) + 4U)) ^ _S97) * 277803737U;
    return (_S98 >> 22) ^ _S98;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> 9) + 0.5) * 1.1920928955078125e-07;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0 * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0) + 1.0;
}

float bounded_gain_0(float gain_1, vec3 albedo_0, vec3 room_0)
{
    vec3 _S99 = room_0 / max(albedo_0, vec3(9.99999997475242708e-07));
    return min(gain_1, max(min(min(_S99.x, _S99.y), _S99.z), 0.0));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0) - 1.0) + 1.0;
}

float diffuse_reflection_0(vec3 light_1, vec3 normal_3, float blend_0)
{
    float _S100 = light_1.z;
    if(_S100 <= 0.0)
    {
        return 0.0;
    }
    return 0.31830987334251404 * mix(max(_S100, 0.0), max(dot(light_1, normal_3), 0.0), blend_0);
}

float projected_area_1(vec3 direction_3, vec3 tangent_2, float roughness_1)
{
    float _S101 = dot(direction_3, tangent_2);
    return sqrt(max((roughness_1 + 1.0) * (roughness_1 - 1.0) * _S101 * _S101 + 1.0, roughness_1 * roughness_1));
}

float exponential_0(float x_7)
{
    float _S102 = clamp(x_7, -87.0, 88.0);
    float _S103 = floor(_S102 * 1.4426950216293335 + 0.5);
    float _S104 = _S102 - _S103 * 0.693359375 + _S103 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S104 + 0.00139819993637502) * _S104 + 0.00833345204591751) * _S104 + 0.04166579619050026) * _S104 + 0.1666666567325592) * _S104 + 0.5;
    float _S105 = uintBitsToFloat(uint(int(_S103) + 127) << 23);
    float _S106;
    if(x_7 < -87.0)
    {
        _S106 = 0.0;
    }
    else
    {
        _S106 = (p_0 * _S104 * _S104 + _S104 + 1.0) * _S105;
    }
    return _S106;
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612)
    {
        return (((depth_0 / 120.0 - 0.0416666679084301) * depth_0 + 0.1666666716337204) * depth_0 - 0.5) * depth_0 + 1.0;
    }
    return (1.0 - exponential_0(- depth_0)) / depth_0;
}

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S107 = roughness_2 * roughness_2;
    float _S108 = squared_along_0 * (1.0 - _S107) + _S107;
    return 0.31830987334251404 * _S107 * roughness_2 / (_S108 * _S108);
}

float density_between_0(vec3 light_2, vec3 view_1, vec3 tangent_3, float roughness_3)
{
    vec3 _S109 = light_2 + view_1;
    float _S110 = dot(_S109, tangent_3);
    return flake_density_0(min(_S110 * _S110 / max(square_0(_S109), 9.999999960041972e-13), 1.0), roughness_3);
}

float transmission_0(vec3 light_3, vec3 view_2, vec3 normal_4, vec3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S111 = - dot(light_3, normal_4);
    float _S112 = dot(view_2, normal_4);
    bool _S113;
    if(_S111 <= 0.0)
    {
        _S113 = true;
    }
    else
    {
        _S113 = _S112 <= 0.0;
    }
    if(_S113)
    {
        return 0.0;
    }
    float _S114 = 1.0 / max(_S112, 9.99999997475242708e-07);
    float _S115 = projected_area_1(light_3, tangent_4, roughness_4) / max(_S111, 9.99999997475242708e-07);
    float _S116 = projected_area_1(view_2, tangent_4, roughness_4) * _S114;
    return density_between_0(light_3, view_2, tangent_4, roughness_4) * 0.25 * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S115, _S116)) * mean_attenuation_0(optical_depth_1 * abs(_S115 - _S116)) * _S114;
}

float reflection_0(vec3 light_4, vec3 view_3, vec3 normal_5, vec3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S117 = dot(light_4, normal_5);
    bool _S118;
    if(_S117 <= 0.0)
    {
        _S118 = true;
    }
    else
    {
        _S118 = (dot(view_3, normal_5)) <= 0.0;
    }
    if(_S118)
    {
        return 0.0;
    }
    float _S119 = max(_S117, 9.99999997475242708e-07);
    float _S120 = max(dot(view_3, normal_5), 9.99999997475242708e-07);
    float _S121 = projected_area_1(light_4, tangent_5, roughness_5) * _S120 + projected_area_1(view_3, tangent_5, roughness_5) * _S119;
    float _S122 = optical_depth_2 * _S121 / (_S119 * _S120);
    return 0.25 * density_between_0(light_4, view_3, tangent_5, roughness_5) * (_S122 * mean_attenuation_0(_S122)) * _S119 / _S121;
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

float wrapped_cell_0(float position_5, float count_1)
{
    return min(floor((position_5 - floor(position_5)) * count_1), count_1 - 1.0);
}

float arc_tangent_quotient_0(float x_8, float y_2)
{
    return ((((((0.0 * x_8 + 0.00809729471802711) * x_8 + -0.0377517081797123) * x_8 + 0.08475969731807709) * x_8 + -0.13537675142288208) * x_8 + 0.19895026087760925) * x_8 + -0.33327975869178772) * x_8 + 0.99999970197677612;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0);
}

float arc_tangent_0(float y_3, float x_9)
{
    float _S123 = abs(x_9);
    float _S124 = abs(y_3);
    float angle_0 = arc_tangent_of_ratio_0(min(_S123, _S124) / max(max(_S123, _S124), 1.00000000317107685e-30));
    float angle_1;
    if(_S124 > _S123)
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
    float _S125 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461;
    float _S126 = floor(_S125);
    float _S127 = _S125 - _S126;
    float _S128 = sqrt(clamp((1.0 - abs(direction_4.z)) / 0.97000002861022949, 0.0, 1.0));
    float _S129 = 7.0 * _S128 * sqrt(_S128);
    float _S130 = min(floor(_S129), 6.0);
    float _S131 = _S129 - _S130;
    uint _S132 = uint(int(_S126) + 32) % 32U;
    uint _S133 = uint(_S130);
    uint _S134 = _S132 * 8U + _S133;
    uint _S135 = (_S132 + 1U) % 32U * 8U + _S133;
    NodeTaps_0 taps_0;
    taps_0.nodes_0 = uvec4(_S134, _S134 + 1U, _S135, _S135 + 1U);
    float _S136 = 1.0 - _S127;
    float _S137 = 1.0 - _S131;
    uvec4 _S138 = uvec4(vec4(_S136 * _S137, _S136 * _S131, _S127 * _S137, _S127 * _S131) * 252.0 + 0.5);
    taps_0.weights_0 = _S138;
    taps_0.inverse_sum_0 = 1.0 / float(_S138.x + _S138.y + _S138.z + _S138.w);
    return taps_0;
}

vec3 half_vector_0(vec3 light_5, vec3 view_4)
{
    vec3 _S139 = light_5 + view_4;
    return _S139 * (inversesqrt((max(square_0(_S139), 9.999999960041972e-13))));
}

vec3 shadow_correlation_0(vec3 light_6, vec3 view_5)
{
    vec2 _S140 = light_6.xy;
    vec2 _S141 = view_5.xy;
    float _S142 = dot(_S140, _S141) / max(sqrt(dot(_S140, _S140) * dot(_S141, _S141)), 9.99999997475242708e-07);
    if((light_6.z) < 0.0)
    {
        return vec3(vec2(-0.09000000357627869 + -0.07999999821186066 * _S142), 0.0);
    }
    return vec3(min(0.62000000476837158 + 0.62999999523162842 * _S142, 1.20000004768371582), 0.62000000476837158, 0.37000000476837158);
}

vec4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return vec4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16), float(odd_0 >> 16));
}

vec4 interpolate_0(NodeTaps_0 taps_1, uvec4 packs_1)
{
    uvec4 _S143 = (packs_1 & 16711935U) * taps_1.weights_0;
    uvec4 _S144 = ((packs_1 >> 8) & 16711935U) * taps_1.weights_0;
    return bytes_of_sums_0(_S143.x + _S143.y + _S143.z + _S143.w, _S144.x + _S144.y + _S144.z + _S144.w) * taps_1.inverse_sum_0;
}

vec4 interpolate_table_0(NodeTaps_0 taps_2, uint table_0, uint stride_0)
{
    uvec4 _S145 = table_0 + taps_2.nodes_0 * stride_0;
    return interpolate_0(taps_2, uvec4(words_0._data[uint(_S145.x)], words_0._data[uint(_S145.y)], words_0._data[uint(_S145.z)], words_0._data[uint(_S145.w)]));
}

struct Group_0
{
    vec3 normal_6;
    float weight_1;
    vec3 tangent_6;
    vec3 variance_0;
    vec3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    group_0.normal_6 = vec3(table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    group_0.weight_1 = table_number_0(row_1 + 3U);
    vec3 _S146 = vec3(table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    group_0.tangent_6 = _S146;
    float _S147 = table_number_0(row_1 + 7U);
    float _S148 = table_number_0(row_1 + 8U);
    group_0.variance_0 = vec3(_S147, _S148, 1.0 - square_0(_S146) - _S147 - _S148);
    group_0.covariance_0 = vec3(table_number_0(row_1 + 9U), table_number_0(row_1 + 10U), table_number_0(row_1 + 11U));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

vec2 visibility_gain_0(vec3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * (1.0 / max(max(from_light_0, from_view_0), 0.00392156885936856) - 1.0) + vec2(1.0 - correlations_0.z * (1.0 - from_light_0), 1.0), vec2(0.0));
}

float Group_variance_along_0(Group_0 this_5, vec3 direction_5)
{
    float _S149 = direction_5.x;
    float _S150 = direction_5.y;
    float _S151 = direction_5.z;
    return max(dot(this_5.variance_0, direction_5 * direction_5) + 2.0 * dot(this_5.covariance_0, vec3(_S149 * _S150, _S149 * _S151, _S150 * _S151)), 0.0);
}

float mean_area_0(Group_0 group_1, vec3 direction_6)
{
    float _S152 = dot(direction_6, group_1.tangent_6);
    float _S153 = group_1.roughness_6;
    float _S154 = _S153 * _S153;
    return sqrt(max((_S154 - 1.0) * (_S152 * _S152 + Group_variance_along_0(group_1, direction_6)) + 1.0, _S154));
}

float mean_density_0(Group_0 group_2, vec3 half_0)
{
    float _S155 = group_2.roughness_6;
    float _S156 = max(sqrt(max(1.0 - _S155 * _S155, 0.0)) / group_2.roughness_6, 0.00100000004749745);
    float _S157 = max(sqrt(3.0 * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516 + 0.00009999999747379);
    float _S158 = dot(half_0, group_2.tangent_6);
    float _S159 = _S156 * (_S158 - _S157);
    float _S160 = _S156 * (_S158 + _S157);
    float _S161 = _S159 * _S160;
    float _S162 = 2.0 * _S157 * _S156;
    return 0.15915493667125702 / group_2.roughness_6 * ((1.0 - _S161) / ((_S159 * _S159 + 1.0) * (_S160 * _S160 + 1.0)) + arc_tangent_0(_S162, 1.0 + _S161) / _S162);
}

float layer_value_0(Group_0 group_3, vec3 half_1, vec3 light_7, vec3 view_6, float optical_depth_3)
{
    bool _S163 = (light_7.z) < 0.0;
    float _S164 = dot(light_7, group_3.normal_6);
    float _S165;
    if(_S163)
    {
        _S165 = - _S164;
    }
    else
    {
        _S165 = _S164;
    }
    float _S166 = max(dot(view_6, group_3.normal_6), 0.01999999955296516);
    float _S167 = mean_area_0(group_3, light_7) / max(_S165, 0.01999999955296516);
    float _S168 = mean_area_0(group_3, view_6) / _S166;
    if(_S163)
    {
        _S165 = abs(_S167 - _S168);
    }
    else
    {
        _S165 = _S167 + _S168;
    }
    float _S169 = optical_depth_3 * max(_S165, 0.00100000004749745);
    if(_S163)
    {
        _S165 = exponential_0(- optical_depth_3 * min(_S167, _S168));
    }
    else
    {
        _S165 = 1.0;
    }
    float _S170 = optical_depth_3 * _S165 * (1.0 - exponential_0(- _S169)) / _S169 / _S166;
    if(_S163)
    {
        _S165 = 1.0;
    }
    else
    {
        _S165 = 1.0 - 0.34999999403953552 * (1.0 - square_0(group_3.normal_6));
    }
    return 0.25 * mean_density_0(group_3, half_1) * _S165 * _S170;
}

struct Bound_0
{
    uint thread_11;
    float turns_2;
    float cell_7;
    float visible_0;
    float width_1;
    float gap_0;
};

Bound_0 bound_at_0(uint family_9, float position_6)
{
    Cell_0 _S171 = locate_0(family_9, position_6);
    float _S172 = table_number_0(families_0._data[uint(family_9)].before_0 + 2U * _S171.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_11 = _S171.thread_0;
    bound_0.turns_2 = round((position_6 - families_0._data[uint(family_9)].start_0 - _S172 - _S171.below_0) * families_0._data[uint(family_9)].inverse_period_0);
    bound_0.cell_7 = _S171.below_0;
    float _S173 = 2.0 * _S171.half_width_1;
    bound_0.width_1 = _S173;
    bound_0.visible_0 = clamp((_S171.across_2 + _S171.half_width_1) / _S173, 0.0, 1.0);
    bound_0.gap_0 = min(_S171.below_0, _S171.below_0 - _S171.across_2 - _S171.half_width_1) + max(_S171.across_2 - _S171.half_width_1, 0.0);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    float _S174 = centre_1 - floor((centre_1 - families_0._data[uint(family_10)].start_0) * families_0._data[uint(family_10)].inverse_period_0) * families_0._data[uint(family_10)].period_0;
    float _S175 = 0.5 * max(size_1, families_0._data[uint(family_10)].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_0 = bound_at_0(family_10, _S174 - _S175);
    stretch_0.high_0 = bound_at_0(family_10, _S174 + _S175);
    return stretch_0;
}

float Stretch_turns_0(Stretch_0 this_6)
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

vec3 lengths_0(uint family_11, Stretch_0 stretch_1)
{
    float _S176 = Stretch_turns_0(stretch_1);
    uint _S177 = families_0._data[uint(family_11)].before_0 + 2U * stretch_1.low_0.thread_11;
    uint _S178 = families_0._data[uint(family_11)].before_0 + 2U * stretch_1.high_0.thread_11;
    float _S179 = table_number_0(_S178) - table_number_0(_S177);
    float _S180 = table_number_0(_S178 + 1U) - table_number_0(_S177 + 1U);
    return vec3(_S179 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_1 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_1 + _S176 * families_0._data[uint(family_11)].visible_total_0, _S180 - _S179 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S176 * (families_0._data[uint(family_11)].period_0 - families_0._data[uint(family_11)].visible_total_0), _S180 + stretch_1.high_0.cell_7 - stretch_1.low_0.cell_7 + _S176 * families_0._data[uint(family_11)].period_0);
}

vec2 integrals_along_0(uint family_12, Stretch_0 stretch_2, uint quantity_0)
{
    Family_0 _S181 = families_0._data[uint(family_12)];
    uint _S182 = 3U * _S181.quantities_0;
    uint _S183 = families_0._data[uint(family_12)].colour_threads_0 + _S182 * stretch_2.low_0.thread_11 + quantity_0;
    uint _S184 = families_0._data[uint(family_12)].colour_threads_0 + _S182 * stretch_2.high_0.thread_11 + quantity_0;
    uint _S185 = families_0._data[uint(family_12)].colour_threads_0 + _S182 * uint(families_0._data[uint(family_12)].count_0) + quantity_0;
    float _S186 = table_number_0(_S183);
    float _S187 = table_number_0(_S184);
    float _S188 = Stretch_turns_0(stretch_2);
    uint _S189 = 2U * _S181.quantities_0;
    return vec2(table_number_0(_S184 + _S181.quantities_0) - table_number_0(_S183 + _S181.quantities_0) + _S187 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_1 - _S186 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_1 + _S188 * table_number_0(_S185 + _S181.quantities_0), table_number_0(_S184 + _S189) - table_number_0(_S183 + _S189) + _S187 * stretch_2.high_0.cell_7 - _S186 * stretch_2.low_0.cell_7 + _S188 * table_number_0(_S185 + _S189));
}

bool Stretch_wraps_0(Stretch_0 this_7)
{
    return (this_7.high_0.thread_11) < (this_7.low_0.thread_11);
}

uvec4 Stretch_differences_0(Stretch_0 this_8, uvec4 entries_0, uint whole_0)
{
    uint _S190 = entries_0.z;
    uint _S191 = entries_0.x;
    uint _S192 = _S190 - _S191;
    uint _S193;
    if(Stretch_wraps_0(this_8))
    {
        _S193 = whole_0;
    }
    else
    {
        _S193 = 0U;
    }
    return uvec4(_S192 + _S193, entries_0.w - _S190, entries_0.y - _S191, whole_0);
}

uvec4 row_differences_0(Stretch_0 across_4, uint row_2, uint count_2, uint quantities_1)
{
    uint _S194 = row_2 + across_4.low_0.thread_11 * quantities_1;
    uint _S195 = row_2 + across_4.high_0.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, uvec4(words_0._data[uint(_S194)], words_0._data[uint(_S194 + quantities_1)], words_0._data[uint(_S195)], words_0._data[uint(_S195 + quantities_1)]), words_0._data[uint(row_2 + count_2 * quantities_1)]);
}

vec4 Stretch_weights_0(Stretch_0 this_9)
{
    float _S196 = - this_9.low_0.visible_0;
    float _S197 = Stretch_turns_0(this_9);
    float _S198;
    if(Stretch_wraps_0(this_9))
    {
        _S198 = 1.0;
    }
    else
    {
        _S198 = 0.0;
    }
    return vec4(1.0, this_9.high_0.visible_0, _S196, _S197 - _S198);
}

float integral_on_top_0(uint family_13, Stretch_0 across_5, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S199 = uint(families_0._data[uint(family_13)].count_0);
    uint _S200 = (_S199 + 1U) * families_0._data[uint(family_13)].quantities_0;
    uint _S201 = families_0._data[uint(family_13)].colour_areas_0 + quantity_1;
    uvec4 _S202 = row_differences_0(across_5, _S201 + along_0.low_0.thread_11 * _S200, _S199, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S203 = row_differences_0(across_5, _S201 + (along_0.low_0.thread_11 + 1U) * _S200, _S199, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S204 = row_differences_0(across_5, _S201 + along_0.high_0.thread_11 * _S200, _S199, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S205 = row_differences_0(across_5, _S201 + (along_0.high_0.thread_11 + 1U) * _S200, _S199, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S206 = row_differences_0(across_5, _S201 + crossing_count_0 * _S200, _S199, families_0._data[uint(family_13)].quantities_0);
    uvec4 _S207 = _S204 - _S202;
    uvec4 _S208;
    if(Stretch_wraps_0(along_0))
    {
        _S208 = _S206;
    }
    else
    {
        _S208 = uvec4(ivec4(0));
    }
    vec4 _S209 = Stretch_weights_0(across_5);
    return dot(vec4(dot(vec4(ivec4(_S207 + _S208)), _S209), dot(vec4(ivec4(_S205 - _S204)), _S209), dot(vec4(ivec4(_S203 - _S202)), _S209), dot(vec4(ivec4(_S206)), _S209)), Stretch_weights_0(along_0)) * families_0._data[uint(family_13)].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_2, uint row_3)
{
    Albedos_0 _S210 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_2 * _S210.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_2 * _S210.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_2 * _S210.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_2 * _S210.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 own_1, Stretch_0 other_2, bool back_2)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0._data[uint(family_14)].colour_mean_0);
    if((families_0._data[uint(family_14)].quantities_0) == 1U)
    {
        return albedos_2;
    }
    vec3 _S211 = lengths_0(crossing_1, other_2);
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
        vec2 _S212 = integrals_along_0(family_14, own_1, quantity_2);
        float _S213 = integral_on_top_0(family_14, own_1, other_2, uint(families_0._data[uint(crossing_1)].count_0), quantity_2);
        float _S214 = _S212.x;
        float _S215 = _S214 * _S211.x;
        float _S216;
        if(back_2)
        {
            _S216 = _S215 - _S213;
        }
        else
        {
            _S216 = _S213;
        }
        bool _S217 = quantity_2 == 0U;
        if(_S217)
        {
            is_exposed_0 = _S216 > (16.0 * families_0._data[uint(family_14)].area_unit_0 * min(_S215 / families_0._data[uint(family_14)].crossing_area_0, 1.0) + 0.00000999999974738 * _S215);
        }
        float _S218 = _S214 * _S211.y;
        float _S219;
        if(is_exposed_0)
        {
            _S219 = _S216;
        }
        else
        {
            _S219 = 0.0;
        }
        float _S220 = _S218 + _S219 + 0.000244140625 * _S211.z * _S212.y;
        if(_S217)
        {
            weight_3 = 1.0 / max(_S220, 9.99999968265522539e-21);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S220 * weight_3, families_0._data[uint(family_14)].colour_axes_0 + 12U * (quantity_2 - 1U));
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
    vec3 _S221 = vec3(weight_4);
    albedos_3.diffuse_reflect_0 = mix(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S221);
    albedos_3.diffuse_transmit_0 = mix(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S221);
    albedos_3.specular_reflect_0 = mix(first_2.specular_reflect_0, second_1.specular_reflect_0, _S221);
    albedos_3.specular_transmit_0 = mix(first_2.specular_transmit_0, second_1.specular_transmit_0, _S221);
    return albedos_3;
}

float sheen_scale_0(float x_10, float y_4)
{
    return (((((0.0 * x_10 + (((((-1.1402510404586792 * y_4 + 0.40672621130943298) * y_4 + 1.65398800373077393) * y_4 + -1.29730904102325439) * y_4 + 0.30570998787879944) * y_4 + -0.0220868494361639)) * x_10 + (((((-0.21142719686031342 * y_4 + 1.05947399139404297) * y_4 + -0.41116121411323547) * y_4 + -0.93859231472015381) * y_4 + 0.51606941223144531) * y_4 + 0.05409301072359085)) * x_10 + (((((1.22944498062133789 * y_4 + -0.45962560176849365) * y_4 + -1.63861405849456787) * y_4 + 1.33565104007720947) * y_4 + -0.45725581049919128) * y_4 + 0.08243165910243988)) * x_10 + (((((0.39779931306838989 * y_4 + -1.18879103660583496) * y_4 + 0.28251591324806213) * y_4 + 1.168984055519104) * y_4 + -0.76864629983901978) * y_4 + 0.0091691892594099)) * x_10 + (((((-0.26563560962677002 * y_4 + -0.19379159808158875) * y_4 + 0.2677634060382843) * y_4 + 0.00270519289188087) * y_4 + 0.14349560439586639) * y_4 + 0.10290180146694183)) * x_10 + (((((-0.20701569318771362 * y_4 + 0.24526430666446686) * y_4 + 0.19551840424537659) * y_4 + 0.07586126774549484) * y_4 + 0.38894739747047424) * y_4 + 0.15043120086193085);
}

float sheen_shear_0(float x_11, float y_5)
{
    return ((((0.0 * x_11 + (((((-0.10608240216970444 * y_5 + 1.99214303493499756) * y_5 + -1.42255294322967529) * y_5 + -1.09495604038238525) * y_5 + 0.59180057048797607) * y_5 + 0.06902855634689331)) * x_11 + (((((-0.46220690011978149 * y_5 + -0.29113379120826721) * y_5 + 1.39025199413299561) * y_5 + 0.35589990019798279) * y_5 + -1.17120099067687988) * y_5 + 0.15940259397029877)) * x_11 + (((((2.26068711280822754 * y_5 + -3.64728999137878418) * y_5 + -0.72173482179641724) * y_5 + 3.07659196853637695) * y_5 + -0.6827620267868042) * y_5 + -0.3039557933807373)) * x_11 + (((((0.81201767921447754 * y_5 + 0.36014080047607422) * y_5 + -1.72646903991699219) * y_5 + -0.22630110383033752) * y_5 + 0.89514690637588501) * y_5 + -0.10397960245609283)) * x_11 + (((((-0.37648698687553406 * y_5 + 1.10974001884460449) * y_5 + 0.17824520170688629) * y_5 + -1.04968702793121338) * y_5 + 0.1461234986782074) * y_5 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_12, float y_6)
{
    return ((((0.0 * x_12 + (((((12.95646953582763672 * y_6 + -21.38032913208007812) * y_6 + -7.37853097915649414) * y_6 + 34.55607986450195312) * y_6 + -23.61347007751464844) * y_6 + 5.00126314163208008)) * x_12 + (((((10.91487026214599609 * y_6 + -6.08202791213989258) * y_6 + -38.2036285400390625) * y_6 + 53.3440399169921875) * y_6 + -21.91996002197265625) * y_6 + 2.01606011390686035)) * x_12 + (((((-14.52206039428710938 * y_6 + 36.803619384765625) * y_6 + -22.94047927856445312) * y_6 + -10.07973003387451172) * y_6 + 15.77003955841064453) * y_6 + -4.92722177505493164)) * x_12 + (((((-7.62505722045898438 * y_6 + 1.27310299873352051) * y_6 + 31.19523048400878906) * y_6 + -44.39989852905273438) * y_6 + 26.44947052001953125) * y_6 + -8.73507976531982422)) * x_12 + (((((5.65633487701416016 * y_6 + -17.66820907592773438) * y_6 + 24.65356063842773438) * y_6 + -19.38941001892089844) * y_6 + 11.06159019470214844) * y_6 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S222 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S223 = 2.0 * sqrt(_S222) - 1.0;
    float _S224 = 3.0 * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S223, _S224), 0.00999999977648258, 1.0), clamp((1.0 - _S222) * sheen_shear_0(_S223, _S224), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S223, _S224), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_8, vec3 view_7, float scale_0, float shear_0)
{
    float _S225 = light_8.z;
    bool _S226;
    if(_S225 <= 0.0)
    {
        _S226 = true;
    }
    else
    {
        _S226 = (view_7.z) <= 0.0;
    }
    if(_S226)
    {
        return 0.0;
    }
    vec2 _S227 = view_7.xy;
    float _S228 = dot(_S227, _S227);
    vec2 _S229;
    if(_S228 > 9.99999968265522539e-21)
    {
        _S229 = _S227 * (inversesqrt((_S228)));
    }
    else
    {
        _S229 = vec2(1.0, 0.0);
    }
    float _S230 = scale_0 * dot(light_8.xy, _S229) + shear_0 * _S225;
    float _S231 = scale_0 * (light_8.y * _S229.x - light_8.x * _S229.y);
    float _S232 = _S230 * _S230 + _S231 * _S231 + _S225 * _S225;
    return 0.31830987334251404 * scale_0 * scale_0 * _S225 / max(_S232 * _S232, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_9, vec3 view_8, float strength_0, float roughness_9)
{
    vec3 _S233 = sheen_lobe_0(view_8.z, roughness_9);
    float _S234 = strength_0 * _S233.z;
    return vec2(_S234 * transformed_cosine_0(light_9, view_8, _S233.x, _S233.y), 1.0 - _S234);
}

void accumulate_0(Frame_0 frame_4, uvec2 pixel_0, vec4 light_10)
{
    uint _S235 = pixel_0.y * frame_4.width_0 + pixel_0.x;
    float _S236 = light_10.w;
    vec4 _S237 = vec4(light_10.xyz + (1.0 - _S236) * vec3(frame_4.background_red_0, frame_4.background_green_0, frame_4.background_blue_0), _S236);
    vec4 _S238;
    if((frame_4.pass_number_0) == 0U)
    {
        _S238 = _S237;
    }
    else
    {
        _S238 = radiance_0._data[uint(_S235)] + _S237;
    }
    radiance_0._data[uint(_S235)] = _S238;
    return;
}

VisiblePoint_0 visible_point_0(Frame_0 _S239, uint _S240, uint _S241, uvec2 _S242)
{
    uint _S243 = 3U * _S241;
    Vertex_0 _S244 = vertices_0._data[uint(corners_0._data[uint(_S243)])];
    Vertex_0 _S245 = vertices_0._data[uint(corners_0._data[uint(_S243 + 1U)])];
    Vertex_0 _S246 = vertices_0._data[uint(corners_0._data[uint(_S243 + 2U)])];
    vec3 _S247 = position_of_0(_S244);
    vec3 _S248 = position_of_0(_S245) - _S247;
    vec3 _S249 = position_of_0(_S246) - _S247;
    vec3 _S250 = cross(_S248, _S249);
    float _S251 = 1.0 / max(square_0(_S250), 1.00000000317107685e-30);
    float _S252 = float(_S239.width_0);
    vec3 _S253 = camera_right_0(_S239) * (2.0 / _S252);
    float _S254 = float(_S239.height_0);
    vec3 _S255 = camera_up_0(_S239) * (-2.0 / _S254);
    vec3 _S256 = camera_forward_0(_S239) + (float(_S242.x) + 0.5 - 0.5 * _S252) * _S253 + (float(_S242.y) + 0.5 - 0.5 * _S254) * _S255;
    float _S257 = dot(_S256, _S250);
    float _S258;
    if((abs(_S257)) > 1.00000000317107685e-30)
    {
        _S258 = _S257;
    }
    else
    {
        _S258 = 1.00000000317107685e-30;
    }
    float _S259 = 1.0 / _S258;
    vec3 _S260 = _S247 - camera_origin_0(_S239);
    float _S261 = dot(_S260, _S250) * _S259;
    vec3 _S262 = _S256 * _S261 - _S260;
    vec3 _S263 = _S261 * (_S253 - _S256 * (dot(_S253, _S250) * _S259));
    vec3 _S264 = _S261 * (_S255 - _S256 * (dot(_S255, _S250) * _S259));
    vec3 _S265 = cross(_S249, _S250) * _S251;
    vec3 _S266 = cross(_S250, _S248) * _S251;
    float _S267 = dot(_S262, _S265);
    float _S268 = dot(_S262, _S266);
    float _S269 = _S245.u_0 - _S244.u_0;
    float _S270 = _S245.v_0 - _S244.v_0;
    vec2 _S271 = vec2(_S269, _S270);
    float _S272 = _S246.u_0 - _S244.u_0;
    float _S273 = _S246.v_0 - _S244.v_0;
    vec2 _S274 = vec2(_S272, _S273);
    vec2 _S275 = vec2(_S244.u_0, _S244.v_0) + _S267 * _S271 + _S268 * _S274;
    vec2 _S276 = dot(_S263, _S265) * _S271 + dot(_S263, _S266) * _S274;
    vec2 _S277 = dot(_S264, _S265) * _S271 + dot(_S264, _S266) * _S274;
    if((_S269 * _S273 - _S270 * _S272) < 0.0)
    {
        _S258 = -1.0;
    }
    else
    {
        _S258 = 1.0;
    }
    vec3 _S278 = _S258 * (_S273 * _S248 - _S270 * _S249);
    vec3 _S279 = _S258 * (_S269 * _S249 - _S272 * _S248);
    VisiblePoint_0 point_1;
    vec3 _S280 = normalize((1.0 - _S267 - _S268) * normal_of_0(_S244) + _S267 * normal_of_0(_S245) + _S268 * normal_of_0(_S246));
    point_1.normal_0 = _S280;
    vec3 _S281 = normalize(_S278 - _S280 * dot(_S280, _S278));
    point_1.axis_x_0 = _S281;
    point_1.axis_y_0 = cross(_S280, _S281);
    point_1.position_0 = _S247 + _S262;
    point_1.view_0 = - normalize(_S256);
    bool _S282 = (dot(cross(_S278, _S279), _S280)) < 0.0;
    float _S283 = fabrics_0._data[uint(_S240)].uv_width_0;
    if(_S282)
    {
        _S258 = - fabrics_0._data[uint(_S240)].uv_height_0;
    }
    else
    {
        _S258 = fabrics_0._data[uint(_S240)].uv_height_0;
    }
    vec2 _S284 = vec2(_S283, _S258);
    vec2 _S285 = _S275 * _S284;
    if(_S282)
    {
        _S258 = fabrics_0._data[uint(_S240)].uv_height_0;
    }
    else
    {
        _S258 = 0.0;
    }
    point_1.draft_0 = _S285 + vec2(0.0, _S258);
    point_1.draft_dx_0 = _S276 * _S284;
    point_1.draft_dy_0 = _S277 * _S284;
    return point_1;
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

Regime_0 regime_of_0(uint _S286, Footprint_0 _S287, float _S288)
{
    float _S289 = Footprint_spread_side_0(_S287);
    float _S290 = clamp((binary_logarithm_0(max(_S289, 9.99999971718068537e-10)) - fabrics_0._data[uint(_S286)].lobes_0.unit_level_0 - -0.7369655966758728) / 1.41503751277923584, 0.0, 1.0);
    Regime_0 regime_0;
    float _S291 = _S290 * _S290 * (3.0 - 2.0 * _S290);
    regime_0.prefiltered_0 = _S291;
    regime_0.threads_1 = _S289 * fabrics_0._data[uint(_S286)].lobes_0.threads_per_mm_0;
    float _S292 = mix(max(8.0 / _S288, 1.0), 1.0, _S291);
    float _S293;
    if(_S291 < 1.0)
    {
        _S293 = clamp(regime_0.threads_1 * 12.0, 1.0, _S292);
    }
    else
    {
        _S293 = 0.0;
    }
    regime_0.points_0 = _S293;
    return regime_0;
}

struct Hit_0
{
    float x_13;
    float y_7;
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

Crossing_0 crossing_at_0(uint _S294, float _S295, float _S296, bool _S297)
{
    Crossing_0 crossing_3;
    crossing_3.warp_1 = locate_0(fabrics_0._data[uint(_S294)].warp_0, _S295);
    crossing_3.weft_1 = locate_0(fabrics_0._data[uint(_S294)].weft_0, _S296);
    uint _S298 = fabrics_0._data[uint(_S294)].run_words_0 + 2U * (crossing_3.weft_1.thread_0 * fabrics_0._data[uint(_S294)].ends_1 + crossing_3.warp_1.thread_0);
    uint _S299 = words_0._data[uint(_S298)];
    crossing_3.warp_word_0 = _S299;
    crossing_3.weft_word_0 = words_0._data[uint(_S298 + 1U)];
    crossing_3.warp_above_0 = ((_S299 & 1U) == 1U) != _S297;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S300, float _S301, float _S302, bool _S303)
{
    Sample_0 sample_0;
    Crossing_0 _S304 = crossing_at_0(_S300, _S301, _S302, _S303);
    sample_0.crossing_2 = _S304;
    Shown_0 _S305 = shown_at_0(_S304, _S303);
    sample_0.shown_3 = _S305;
    uint _S306;
    if(_S305.is_warp_2)
    {
        _S306 = fabrics_0._data[uint(_S300)].warp_0;
    }
    else
    {
        _S306 = fabrics_0._data[uint(_S300)].weft_0;
    }
    uint _S307;
    if(_S305.is_warp_2)
    {
        _S307 = fabrics_0._data[uint(_S300)].weft_0;
    }
    else
    {
        _S307 = fabrics_0._data[uint(_S300)].warp_0;
    }
    Cell_0 _S308 = select_cell_0(_S305.is_warp_2, sample_0.crossing_2.warp_1, sample_0.crossing_2.weft_1);
    Cell_0 _S309 = select_cell_0(_S305.is_warp_2, sample_0.crossing_2.weft_1, sample_0.crossing_2.warp_1);
    Run_0 _S310 = unpack_0(_S306, _S307, _S308.thread_0, _S309, _S305.word_0);
    Section_0 _S311 = section_at_0(_S308);
    bool _S312;
    if(_S305.on_top_0)
    {
        _S312 = (_S310.distance_0) < (_S311.drop_0 * _S310.bend_1.sine_0);
    }
    else
    {
        _S312 = false;
    }
    bool _S313;
    if(_S305.on_top_0)
    {
        _S313 = !_S312;
    }
    else
    {
        _S313 = false;
    }
    float _S314;
    if(_S313)
    {
        _S314 = 1.0;
    }
    else
    {
        _S314 = -1.0;
    }
    float _S315;
    if(_S312)
    {
        _S315 = _S310.other_reach_0;
    }
    else
    {
        _S315 = _S310.reach_0;
    }
    float _S316;
    if(_S312)
    {
        _S316 = _S315 + _S310.distance_0;
    }
    else
    {
        _S316 = max(_S315 - _S310.distance_0, 0.0);
    }
    float _S317 = _S315 / _S310.bend_1.sine_0 - _S314 * _S311.drop_0;
    float _S318 = _S316 * _S316;
    float _S319 = max(_S317 * _S317 - _S318, 9.99999968265522539e-21);
    float _S320 = (inversesqrt((_S319)));
    float _S321 = _S318 / (_S319 * _S320 + _S317);
    bool _S322 = _S316 > 0.0;
    float _S323;
    if(_S305.on_top_0)
    {
        _S323 = 1.0;
    }
    else
    {
        _S323 = -1.0;
    }
    float _S324;
    if(_S310.near_start_0)
    {
        _S324 = 1.0;
    }
    else
    {
        _S324 = -1.0;
    }
    float _S325 = _S323 * _S324;
    if(_S322)
    {
        _S323 = _S317 * _S320;
    }
    else
    {
        _S323 = 1.0;
    }
    sample_0.slope_across_0 = _S311.slope_0 * _S323;
    if(_S322)
    {
        _S316 = _S325 * _S316 * _S320;
    }
    else
    {
        _S316 = 0.0;
    }
    sample_0.slope_along_0 = _S316;
    Family_0 _S326 = families_0._data[uint(_S306)];
    vec2 _S327 = dive_0(_S307, _S305, _S310, _S309);
    if(_S310.straight_0)
    {
        _S314 = 0.0;
    }
    else
    {
        _S314 = _S326.height_scale_0 * _S314;
    }
    sample_0.height_6 = _S314 * (_S315 * _S310.bend_1.half_tangent_0 - _S321) - _S326.height_scale_0 * _S311.drop_0 - _S327.x;
    float _S328 = _S326.height_scale_0 * sample_0.slope_across_0;
    float _S329 = _S326.height_scale_0 * sample_0.slope_along_0 - _S327.y;
    if(_S305.is_warp_2)
    {
        _S314 = _S328;
    }
    else
    {
        _S314 = _S329;
    }
    sample_0.slope_x_1 = _S314;
    if(_S305.is_warp_2)
    {
        _S314 = _S329;
    }
    else
    {
        _S314 = _S328;
    }
    sample_0.slope_y_1 = _S314;
    sample_0.run_3 = _S310;
    sample_0.section_1 = _S311;
    return sample_0;
}

float steps_per_length_0(uint _S330, SearchQuality_0 _S331, vec3 _S332)
{
    return max(max(abs(_S332.x) * fabrics_0._data[uint(_S330)].threads_per_x_0, abs(_S332.y) * fabrics_0._data[uint(_S330)].threads_per_y_0) * _S331.steps_per_thread_0, abs(_S332.z) * fabrics_0._data[uint(_S330)].per_relief_0 * _S331.steps_per_relief_0);
}

float cell_maximum_0(uint _S333, Crossing_0 _S334)
{
    uint _S335;
    if(_S334.warp_above_0)
    {
        _S335 = fabrics_0._data[uint(_S333)].warp_0;
    }
    else
    {
        _S335 = fabrics_0._data[uint(_S333)].weft_0;
    }
    uint _S336;
    if(_S334.warp_above_0)
    {
        _S336 = _S334.warp_word_0;
    }
    else
    {
        _S336 = _S334.weft_word_0;
    }
    return float(_S336 >> 28) * families_0._data[uint(_S335)].height_scale_0 * families_0._data[uint(_S335)].level_0;
}

Probe_0 probe_0(uint _S337, float _S338, float _S339, bool _S340, bool _S341, bool _S342)
{
    Sample_0 _S343 = sample_at_0(_S337, _S338, _S339, _S340);
    Probe_0 probe_1;
    probe_1.height_3 = _S343.height_6;
    probe_1.hole_4 = _S343.shown_3.hole_3;
    probe_1.slope_x_0 = _S343.slope_x_1;
    probe_1.slope_y_0 = _S343.slope_y_1;
    uint _S344;
    if(_S343.shown_3.is_warp_2)
    {
        _S344 = _S343.crossing_2.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S344 = _S343.crossing_2.weft_1.thread_0 * 2U;
    }
    probe_1.yarn_1 = _S344;
    probe_1.cell_max_0 = cell_maximum_0(_S337, _S343.crossing_2);
    float _S345;
    if(_S341)
    {
        _S345 = _S343.crossing_2.warp_1.above_0;
    }
    else
    {
        _S345 = _S343.crossing_2.warp_1.below_0;
    }
    probe_1.side_x_0 = _S345;
    if(_S342)
    {
        _S345 = _S343.crossing_2.weft_1.above_0;
    }
    else
    {
        _S345 = _S343.crossing_2.weft_1.below_0;
    }
    probe_1.side_y_0 = _S345;
    probe_1.edge_x_0 = outline_distance_0(_S343.crossing_2.warp_1, _S343.shown_3, _S343.run_3, !_S343.shown_3.is_warp_2, _S341);
    probe_1.edge_y_0 = outline_distance_0(_S343.crossing_2.weft_1, _S343.shown_3, _S343.run_3, _S343.shown_3.is_warp_2, _S342);
    return probe_1;
}

bool is_free_0(uint _S346, SearchQuality_0 _S347, vec3 _S348, vec3 _S349, bool _S350, float _S351)
{
    float _S352 = _S349.z;
    if(_S352 <= 0.0)
    {
        return false;
    }
    float _S353 = 1.0 / max(_S347.shadow_share_0 * steps_per_length_0(_S346, _S347, _S349), 9.99999971718068537e-10);
    StepControl_0 _S354 = step_control_0(_S349.xy, _S353);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S355;
        if(count_3 < 1024U)
        {
            _S355 = (_S348.z + _S352 * distance_1) < _S351;
        }
        else
        {
            _S355 = false;
        }
        if(_S355)
        {
        }
        else
        {
            break;
        }
        vec3 _S356 = _S348 + _S349 * distance_1;
        Probe_0 _S357 = probe_0(_S346, _S356.x, _S356.y, _S350, _S354.right_0, _S354.up_0);
        float _S358 = _S356.z;
        float _S359 = _S358 - _S357.height_3;
        float _S360 = _S352 - _S357.slope_x_0 * _S349.x - _S357.slope_y_0 * _S349.y;
        bool _S361;
        if(!_S357.hole_4)
        {
            _S361 = _S359 < 0.0;
        }
        else
        {
            _S361 = false;
        }
        if(_S361)
        {
            return false;
        }
        float _S362 = way_back_to_dip_0(previous_3, _S359, _S360, last_step_0, _S357);
        if(_S362 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S362;
            distance_1 = distance_1 - _S362;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S363 = _S358 > (_S357.cell_max_0);
        PreviousSample_0 _S364 = after_sample_0(_S359, _S360, _S357, _S363);
        float last_step_2;
        if(_S363)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S354, _S357.side_x_0, _S357.side_y_0), _S353);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S354, _S357, _S359, _S360);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S364;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S365, SearchQuality_0 _S366, float _S367, float _S368, vec3 _S369, bool _S370)
{
    if(!sample_at_0(_S365, _S367, _S368, _S370).shown_3.hole_3)
    {
        return false;
    }
    vec3 _S371 = vec3(_S367, _S368, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S372;
        if(side_0 < 2U)
        {
            _S372 = passes_0;
        }
        else
        {
            _S372 = false;
        }
        if(_S372)
        {
        }
        else
        {
            break;
        }
        vec3 _S373;
        if(side_0 == 0U)
        {
            _S373 = _S369;
        }
        else
        {
            _S373 = vec3(- _S369.x, - _S369.y, _S369.z);
        }
        bool _S374 = is_free_0(_S365, _S366, _S371, _S373, _S370 != (side_0 == 1U), fabrics_0._data[uint(_S365)].height_high_0);
        uint _S375 = side_0 + 1U;
        passes_0 = _S374;
        side_0 = _S375;
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

float max_height_along_0(uint _S376, float _S377, float _S378, float _S379, vec3 _S380, bool _S381)
{
    uint _S382 = locate_0(fabrics_0._data[uint(_S376)].warp_0, _S377).thread_0 / 2U;
    uint _S383 = locate_0(fabrics_0._data[uint(_S376)].weft_0, _S378).thread_0 / 2U;
    float _S384 = _S380.x;
    uint _S385;
    if(_S384 > 0.0)
    {
        _S385 = 1U;
    }
    else
    {
        _S385 = 0U;
    }
    float _S386 = _S380.y;
    uint _S387;
    if(_S386 > 0.0)
    {
        _S387 = 2U;
    }
    else
    {
        _S387 = 0U;
    }
    uint _S388 = words_0._data[uint(fabrics_0._data[uint(_S376)].max_heights_0 + 4U * (_S383 * fabrics_0._data[uint(_S376)].max_height_columns_0 + _S382) + (_S385 + _S387))];
    int number_0;
    if(_S381)
    {
        number_0 = 4;
    }
    else
    {
        number_0 = 0;
    }
    uint _S389 = _S388 >> number_0;
    float _S390 = max(abs(_S384) * fabrics_0._data[uint(_S376)].threads_per_x_0, abs(_S386) * fabrics_0._data[uint(_S376)].threads_per_y_0) / _S380.z;
    float _S391 = fabrics_0._data[uint(_S376)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S376)].height_high_0;
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
        if(((max_height_0 - _S379) * _S390) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S389 >> uint(8 * number_0)) & 15U) * 0.06666667014360428 * _S391);
        }
        number_0 = number_0 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S392, float _S393, float _S394, bool _S395, bool _S396, bool _S397)
{
    Crossing_0 _S398 = crossing_at_0(_S392, _S393, _S394, _S395);
    float _S399 = cell_maximum_0(_S392, _S398);
    float _S400;
    if(_S396)
    {
        _S400 = _S398.warp_1.above_0;
    }
    else
    {
        _S400 = _S398.warp_1.below_0;
    }
    float _S401;
    if(_S397)
    {
        _S401 = _S398.weft_1.above_0;
    }
    else
    {
        _S401 = _S398.weft_1.below_0;
    }
    return vec3(_S399, _S400, _S401);
}

float first_sample_height_0(uint _S402, ViewRay_0 _S403, StepControl_0 _S404, bool _S405)
{
    float _S406 = max_height_along_0(_S402, _S403.origin_0.x, _S403.origin_0.y, 0.0, vec3(_S403.slope_1, 1.0), _S405);
    uint count_4 = 0U;
    float height_8 = _S406;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S407 = ViewRay_at_0(_S403, height_8);
        vec3 _S408 = cell_bounds_0(_S402, _S407.x, _S407.y, _S405, _S404.right_0, _S404.up_0);
        float _S409 = height_8 - _S408.x;
        float _S410 = StepControl_to_cell_exit_0(_S404, _S408.y, _S408.z);
        float height_9 = height_8 - clamp(_S409, 0.0, _S410);
        if(_S409 <= _S410)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S411, ViewRay_0 _S412, StepControl_0 _S413, bool _S414)
{
    float _S415 = fabrics_0._data[uint(_S411)].height_low_0 - (fabrics_0._data[uint(_S411)].height_high_0 - fabrics_0._data[uint(_S411)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_7 = first_sample_height_0(_S411, _S412, _S413, _S414);
    end_1.last_step_3 = _S413.epsilon_0;
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
        vec2 _S416 = ViewRay_at_0(_S412, end_1.height_7);
        Probe_0 _S417 = probe_0(_S411, _S416.x, _S416.y, _S414, _S413.right_0, _S413.up_0);
        float _S418 = end_1.height_7 - _S417.height_3;
        float _S419 = ViewRay_rate_0(_S412, _S417);
        end_1.depth_1 = - _S418;
        end_1.rate_4 = _S419;
        bool _S420;
        if(end_1.previous_4.known_0)
        {
            _S420 = !_S417.hole_4;
        }
        else
        {
            _S420 = false;
        }
        bool _S421;
        if(_S420)
        {
            _S421 = (end_1.previous_4.yarn_0) == (_S417.yarn_1);
        }
        else
        {
            _S421 = false;
        }
        end_1.smooth_0 = _S421;
        bool _S422;
        if(!_S417.hole_4)
        {
            _S422 = _S418 <= 0.0;
        }
        else
        {
            _S422 = false;
        }
        bool _S423;
        if(_S422)
        {
            _S423 = true;
        }
        else
        {
            _S423 = (end_1.height_7) <= _S415;
        }
        if(_S423)
        {
            break;
        }
        float _S424 = way_back_to_dip_0(end_1.previous_4, _S418, _S419, end_1.last_step_3, _S417);
        if(_S424 >= 0.0)
        {
            end_1.height_7 = end_1.height_7 + _S424;
            end_1.last_step_3 = end_1.last_step_3 - _S424;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S425 = min(StepControl_to_cell_exit_0(_S413, _S417.side_x_0, _S417.side_y_0), end_1.height_7 - _S417.cell_max_0);
        float _S426 = StepControl_to_next_sample_0(_S413, _S417, _S418, _S419);
        end_1.previous_4 = after_sample_0(_S418, _S419, _S417, _S425 > _S426);
        float _S427 = max(_S425, _S426);
        end_1.last_step_3 = _S427;
        end_1.height_7 = end_1.height_7 - _S427;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S428, ViewRay_0 _S429, StepControl_0 _S430, bool _S431, ViewRayEnd_0 _S432, uint _S433)
{
    float _S434 = fabrics_0._data[uint(_S428)].height_high_0 - fabrics_0._data[uint(_S428)].height_low_0;
    float above_2 = _S432.height_7 + _S432.last_step_3;
    float above_gap_1 = clamp(_S432.previous_4.clearance_0, 0.0, _S434);
    float under_gap_1 = clamp(_S432.depth_1, 0.0, _S434);
    float _S435 = cubic_root_0(above_gap_1, - under_gap_1, _S432.previous_4.rate_0 * _S432.last_step_3, _S432.rate_4 * _S432.last_step_3);
    float middle_0;
    if(_S432.smooth_0)
    {
        middle_0 = above_2 - _S435 * _S432.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S432.height_7, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S432.height_7;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S433)
        {
        }
        else
        {
            break;
        }
        vec2 _S436 = ViewRay_at_0(_S429, middle_0);
        Probe_0 _S437 = probe_0(_S428, _S436.x, _S436.y, _S431, _S430.right_0, _S430.up_0);
        float _S438;
        if(_S437.hole_4)
        {
            _S438 = -1.0e+09;
        }
        else
        {
            _S438 = _S437.height_3;
        }
        float _S439 = clamp(middle_0 - _S438, - _S434, _S434);
        float _S440;
        if(_S439 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S440 = 0.5 * above_gap_2;
            }
            else
            {
                _S440 = above_gap_2;
            }
            float _S441 = - _S439;
            under_1 = middle_0;
            above_gap_2 = _S440;
            under_gap_2 = _S441;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S440 = 0.5 * under_gap_2;
            }
            else
            {
                _S440 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S439;
            under_gap_2 = _S440;
            side_1 = -1.0;
        }
        if(_S432.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S439 / min(ViewRay_rate_0(_S429, _S437), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S432.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S442, SearchQuality_0 _S443, float _S444, float _S445, vec3 _S446, bool _S447)
{
    float _S448 = max(_S446.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_0 = vec2(_S444, _S445);
    vec2 _S449 = _S446.xy / _S448;
    ray_0.slope_1 = _S449;
    StepControl_0 _S450 = step_control_0(- _S449, 1.0 / max(steps_per_length_0(_S442, _S443, _S446) / _S448, 9.99999971718068537e-10));
    ViewRayEnd_0 _S451 = search_down_0(_S442, ray_0, _S450, _S447);
    Hit_0 hit_0;
    hit_0.hole_5 = false;
    float _S452 = refined_height_0(_S442, ray_0, _S450, _S447, _S451, _S443.refinements_0);
    hit_0.height_5 = _S452;
    vec2 _S453 = ViewRay_at_0(ray_0, _S452);
    hit_0.x_13 = _S453.x;
    hit_0.y_7 = _S453.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S454, SearchQuality_0 _S455, float _S456, float _S457, vec3 _S458, bool _S459)
{
    if(!passes_through_0(_S454, _S455, _S456, _S457, _S458, _S459))
    {
        return first_hit_of_yarn_0(_S454, _S455, _S456, _S457, _S458, _S459);
    }
    Hit_0 hit_1;
    hit_1.x_13 = _S456;
    hit_1.y_7 = _S457;
    hit_1.height_5 = 0.0;
    hit_1.hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S460, float _S461, float _S462, bool _S463)
{
    Sample_0 _S464 = sample_at_0(_S460, _S461, _S462, _S463);
    float _S465;
    if(_S464.shown_3.is_warp_2)
    {
        _S465 = _S464.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S465 = _S464.crossing_2.weft_1.half_width_1;
    }
    uint _S466;
    if(_S464.shown_3.is_warp_2)
    {
        _S466 = fabrics_0._data[uint(_S460)].warp_0;
    }
    else
    {
        _S466 = fabrics_0._data[uint(_S460)].weft_0;
    }
    Family_0 _S467 = families_0._data[uint(_S466)];
    float _S468;
    if(_S463)
    {
        _S468 = -1.0;
    }
    else
    {
        _S468 = 1.0;
    }
    float _S469 = _S467.twist_sine_0 * _S468;
    Family_0 _S470 = families_0._data[uint(_S466)];
    if(_S464.shown_3.is_warp_2)
    {
        _S468 = 1.0;
    }
    else
    {
        _S468 = -1.0;
    }
    vec2 _S471 = fibre_direction_0(_S464.slope_across_0, _S468 * _S464.slope_along_0, _S469, _S470.twist_cosine_0);
    float _S472;
    if(_S464.shown_3.is_warp_2)
    {
        _S472 = _S464.slope_x_1;
    }
    else
    {
        _S472 = _S464.slope_y_1;
    }
    float _S473;
    if(_S464.shown_3.is_warp_2)
    {
        _S473 = _S464.slope_y_1;
    }
    else
    {
        _S473 = _S464.slope_x_1;
    }
    float _S474 = _S471.x;
    float _S475 = _S471.y;
    float _S476 = _S472 * _S474 + _S468 * _S473 * _S475;
    float _S477 = _S465 * 1.0154266357421875;
    float _S478 = _S477 * arc_sine_0(clamp(_S464.section_1.across_3 / _S477, -1.0, 1.0));
    if(_S464.shown_3.is_warp_2)
    {
        _S465 = _S462;
    }
    else
    {
        _S465 = - _S461;
    }
    SurfacePoint_0 point_2;
    point_2.hole_0 = _S464.shown_3.hole_3;
    point_2.is_warp_0 = _S464.shown_3.is_warp_2;
    point_2.warp_thread_0 = _S464.crossing_2.warp_1.thread_0;
    point_2.weft_thread_0 = _S464.crossing_2.weft_1.thread_0;
    point_2.height_1 = _S464.height_6;
    point_2.normal_1 = normalize(vec3(- _S464.slope_x_1, - _S464.slope_y_1, 1.0));
    vec3 _S479;
    if(_S464.shown_3.is_warp_2)
    {
        _S479 = vec3(_S474, _S475, _S476);
    }
    else
    {
        _S479 = vec3(- _S475, _S474, _S476);
    }
    point_2.tangent_0 = normalize(_S479);
    point_2.across_0 = _S464.section_1.across_3;
    point_2.fibre_across_0 = _S478 * _S470.twist_cosine_0 + _S465 * _S469;
    point_2.fibre_along_0 = _S465 * _S470.twist_cosine_0 - _S478 * _S469;
    return point_2;
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_6;
    bool is_warp_3;
    float x_14;
    float y_8;
    float height_10;
    vec3 normal_7;
    vec3 tangent_7;
    float roughness_10;
    Albedos_0 albedos_5;
};

Albedos_0 vary_albedos_0(uint _S480, Albedos_0 _S481, uint _S482, uint _S483)
{
    vec3 _S484 = max(_S481.specular_reflect_0, _S481.specular_transmit_0);
    vec3 _S485 = _S481.diffuse_reflect_0 + _S481.diffuse_transmit_0;
    float _S486 = bounded_gain_0(thread_gain_0(_S482, fabrics_0._data[uint(_S480)].colour_noise_0, fabrics_0._data[uint(_S480)].seed_0), _S485, 1.0 - fabrics_0._data[uint(_S480)].layer_bound_0 * _S484);
    float _S487 = bounded_gain_0(fibre_gain_0(_S482, _S483, fabrics_0._data[uint(_S480)].fibre_noise_0, fabrics_0._data[uint(_S480)].seed_0), _S484, min((1.0 - _S486 * _S485) / fabrics_0._data[uint(_S480)].layer_bound_0, vec3(1.0)));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S486 * _S481.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S486 * _S481.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S487 * _S481.specular_reflect_0;
    varied_0.specular_transmit_0 = _S487 * _S481.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S488, SurfacePoint_0 _S489, Albedos_0 _S490, float _S491, float _S492)
{
    float _S493;
    if(_S489.is_warp_0)
    {
        _S493 = _S491;
    }
    else
    {
        _S493 = _S492;
    }
    float _S494 = _S493 - _S489.across_0;
    uint _S495;
    if(_S489.is_warp_0)
    {
        _S495 = fabrics_0._data[uint(_S488)].warp_0;
    }
    else
    {
        _S495 = fabrics_0._data[uint(_S488)].weft_0;
    }
    Family_0 _S496 = families_0._data[uint(_S495)];
    int _S497 = int(families_0._data[uint(_S495)].count_0);
    if(_S489.is_warp_0)
    {
        _S495 = _S489.warp_thread_0;
    }
    else
    {
        _S495 = _S489.weft_thread_0;
    }
    uint _S498 = uint(int(floor(_S494 / _S496.period_0)) * _S497 + int(_S495)) * 2U;
    if(_S489.is_warp_0)
    {
        _S495 = 1U;
    }
    else
    {
        _S495 = 0U;
    }
    float _S499 = floor(_S489.fibre_across_0 / fabrics_0._data[uint(_S488)].fibre_size_0);
    return vary_albedos_0(_S488, _S490, _S498 + _S495, uint(int(_S499)) * 65536U + uint(int(floor(_S489.fibre_along_0 / (fabrics_0._data[uint(_S488)].fibre_size_0 * 40.0) + 0.61799997091293335 * _S499))));
}

YarnPoint_0 yarn_point_of_0(uint _S500, SurfacePoint_0 _S501, float _S502, float _S503, bool _S504, bool _S505)
{
    uint _S506;
    if(_S501.is_warp_0)
    {
        _S506 = fabrics_0._data[uint(_S500)].warp_0;
    }
    else
    {
        _S506 = fabrics_0._data[uint(_S500)].weft_0;
    }
    uint _S507;
    if(_S501.is_warp_0)
    {
        _S507 = _S501.warp_thread_0;
    }
    else
    {
        _S507 = _S501.weft_thread_0;
    }
    Albedos_0 albedos_6 = albedos_of_0(_S506, _S507);
    bool _S508;
    if((fabrics_0._data[uint(_S500)].fibre_noise_0) > 0.0)
    {
        _S508 = true;
    }
    else
    {
        _S508 = (fabrics_0._data[uint(_S500)].colour_noise_0) > 0.0;
    }
    Albedos_0 albedos_7;
    if(_S508)
    {
        albedos_7 = varied_at_0(_S500, _S501, albedos_6, _S502, _S503);
    }
    else
    {
        albedos_7 = albedos_6;
    }
    YarnPoint_0 point_3;
    point_3.back_3 = _S504;
    point_3.hole_6 = _S505;
    point_3.is_warp_3 = _S501.is_warp_0;
    point_3.x_14 = _S502;
    point_3.y_8 = _S503;
    point_3.height_10 = _S501.height_1;
    point_3.normal_7 = _S501.normal_1;
    point_3.tangent_7 = _S501.tangent_0;
    point_3.roughness_10 = families_0._data[uint(_S506)].roughness_0;
    point_3.albedos_5 = albedos_7;
    return point_3;
}

bool unoccluded_0(uint _S509, SearchQuality_0 _S510, float _S511, float _S512, float _S513, vec3 _S514, bool _S515)
{
    if((_S514.z) <= 0.0)
    {
        return false;
    }
    return is_free_0(_S509, _S510, vec3(_S511, _S512, _S513 + fabrics_0._data[uint(_S509)].lift_0), _S514, _S515, max_height_along_0(_S509, _S511, _S512, _S513, _S514, _S515));
}

bool is_lit_0(uint _S516, SearchQuality_0 _S517, YarnPoint_0 _S518, vec3 _S519)
{
    if(_S518.hole_6)
    {
        return true;
    }
    vec3 _S520 = to_face_frame_0(_S519, _S518.back_3);
    float _S521 = _S520.z;
    bool _S522 = _S521 < 0.0;
    vec3 normal_8;
    float height_11;
    if(_S522)
    {
        SurfacePoint_0 _S523 = surface_at_0(_S516, _S518.x_14, _S518.y_8, !_S518.back_3);
        normal_8 = _S523.normal_1;
        height_11 = _S523.height_1;
    }
    else
    {
        normal_8 = _S518.normal_7;
        height_11 = _S518.height_10;
    }
    vec3 _S524 = vec3(_S520.xy, abs(_S521));
    if((dot(normal_8, _S524)) <= 0.0)
    {
        return false;
    }
    return unoccluded_0(_S516, _S517, _S518.x_14, _S518.y_8, height_11, _S524, (_S518.back_3) != _S522);
}

Components_0 components_of_point_0(uint _S525, SearchQuality_0 _S526, YarnPoint_0 _S527, vec3 _S528, vec3 _S529)
{
    Components_0 result_1 = no_components_0();
    float _S530;
    if(_S527.hole_6)
    {
        _S530 = 1.0;
    }
    else
    {
        _S530 = 0.0;
    }
    result_1.hole_2 = _S530;
    bool _S531;
    if(_S527.hole_6)
    {
        _S531 = true;
    }
    else
    {
        _S531 = !is_lit_0(_S525, _S526, _S527, _S528);
    }
    if(_S531)
    {
        return result_1;
    }
    vec3 _S532 = to_face_frame_0(_S528, _S527.back_3);
    vec3 _S533 = to_face_frame_0(_S529, _S527.back_3);
    bool _S534 = (_S532.z) < 0.0;
    vec3 _S535;
    if(_S534)
    {
        _S535 = - _S532;
    }
    else
    {
        _S535 = _S532;
    }
    float _S536 = diffuse_reflection_0(_S535, _S527.normal_7, fabrics_0._data[uint(_S525)].diffuse_blend_0);
    if(_S534)
    {
        _S530 = transmission_0(_S532, _S533, _S527.normal_7, _S527.tangent_7, _S527.roughness_10, fabrics_0._data[uint(_S525)].optical_depth_0);
    }
    else
    {
        _S530 = reflection_0(_S532, _S533, _S527.normal_7, _S527.tangent_7, _S527.roughness_10, fabrics_0._data[uint(_S525)].optical_depth_0);
    }
    float _S537;
    if(_S527.is_warp_3)
    {
        _S537 = _S536;
    }
    else
    {
        _S537 = 0.0;
    }
    result_1.diffuse_warp_0 = _S537;
    if(_S527.is_warp_3)
    {
        _S537 = 0.0;
    }
    else
    {
        _S537 = _S536;
    }
    result_1.diffuse_weft_0 = _S537;
    if(_S527.is_warp_3)
    {
        _S537 = _S530;
    }
    else
    {
        _S537 = 0.0;
    }
    result_1.specular_warp_0 = _S537;
    if(_S527.is_warp_3)
    {
        _S530 = 0.0;
    }
    result_1.specular_weft_0 = _S530;
    result_1.light_visibility_1 = 1.0;
    return result_1;
}

struct CoverageTaps_0
{
    uint  nodes_1[9];
};

vec3 pyramid_level_0(uint _S538, float _S539)
{
    uint _S540 = fabrics_0._data[uint(_S538)].lobes_0.levels_0 + 4U * uint(min(_S539, fabrics_0._data[uint(_S538)].lobes_0.last_level_0));
    return vec3(table_number_0(_S540), table_number_0(_S540 + 1U), table_number_0(_S540 + 2U));
}

CoverageTaps_0 coverage_taps_0(uint _S541, Footprint_0 _S542, bool _S543)
{
    Lobes_0 _S544 = fabrics_0._data[uint(_S541)].lobes_0;
    float _S545 = Footprint_spread_side_0(_S542) * fabrics_0._data[uint(_S541)].lobes_0.inverse_base_size_0;
    vec3 _S546 = pyramid_level_0(_S541, floor(binary_logarithm_0(max(0.68000000715255737 * _S545, 1.0))));
    float _S547 = 1.0 / max(_S545, 9.99999997475242708e-07);
    float _S548 = min(max(sqrt(clamp(1.29999995231628418 * (1.0 - _S547 * _S547), 0.0, 1.0)), 0.3333333432674408 * _S547), 1.0);
    vec2 _S549 = vec2(families_0._data[uint(fabrics_0._data[uint(_S541)].warp_0)].inverse_period_0, families_0._data[uint(fabrics_0._data[uint(_S541)].weft_0)].inverse_period_0);
    vec2 _S550 = _S542.centre_0 * _S549;
    vec2 _S551 = _S542.dx_0 * _S549 * _S548;
    vec2 _S552 = _S542.dy_0 * _S549 * _S548;
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
        vec2 _S553 = _S550 + TAP_OFFSETS_0[number_1].x * _S551 + TAP_OFFSETS_0[number_1].y * _S552;
        float _S554 = _S546.y;
        float _S555 = wrapped_cell_0(_S553.x, _S554);
        float _S556 = wrapped_cell_0(_S553.y, _S546.z);
        uint _S557;
        if(_S543)
        {
            _S557 = _S544.face_nodes_0;
        }
        else
        {
            _S557 = 0U;
        }
        taps_3.nodes_1[number_1] = _S557 + uint(_S556 * _S554 + _S555 + _S546.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

vec4 coverage_of_pack_0(uint _S558, CoverageTaps_0 _S559, uint _S560)
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
        uint _S561 = words_0._data[uint(fabrics_0._data[uint(_S558)].lobes_0.coverage_0 + _S559.nodes_1[number_2] * fabrics_0._data[uint(_S558)].lobes_0.packs_0 + _S560)];
        uint even_2 = even_1 + (_S561 & 16711935U);
        uint odd_2 = odd_1 + ((_S561 >> 8) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / 9.0;
}

float coverage_of_holes_0(uint _S562, CoverageTaps_0 _S563)
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
        uint total_1 = total_0 + (((words_0._data[uint(fabrics_0._data[uint(_S562)].lobes_0.coverage_holes_0 + _S563.nodes_1[number_3] / 4U)]) >> (8U * (_S563.nodes_1[number_3] % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0;
}

float prefiltered_hole_0(uint _S564, CoverageTaps_0 _S565, NodeTaps_0 _S566, bool _S567)
{
    Lobes_0 _S568 = fabrics_0._data[uint(_S564)].lobes_0;
    float _S569 = interpolate_table_0(_S566, fabrics_0._data[uint(_S564)].lobes_0.projected_area_0 + fabrics_0._data[uint(_S564)].lobes_0.packs_0, fabrics_0._data[uint(_S564)].lobes_0.packs_0 + 1U).x;
    float _S570;
    if(_S567)
    {
        _S570 = _S568.back_hole_weight_0;
    }
    else
    {
        _S570 = _S568.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S564, _S565) * _S569 * _S569 * _S570, 1.0);
}

Components_0 prefiltered_components_0(uint _S571, Footprint_0 _S572, vec3 _S573, vec3 _S574, bool _S575)
{
    CoverageTaps_0 _S576 = coverage_taps_0(_S571, _S572, _S575);
    NodeTaps_0 _S577 = node_taps_0(_S574);
    NodeTaps_0 view_nodes_0 = _S577;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S573);
    NodeTaps_0 seen_nodes_0 = _S577;
    uint _S578;
    if(_S575)
    {
        _S578 = 1U;
    }
    else
    {
        _S578 = 0U;
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + _S578 * 256U;
    uint _S579 = 2U * _S578;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + _S579 * 256U;
    uint _S580;
    if((_S573.z) < 0.0)
    {
        _S580 = 1U;
    }
    else
    {
        _S580 = 0U;
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + (_S579 + _S580) * 256U;
    vec3 _S581 = half_vector_0(_S573, _S574);
    vec3 _S582 = shadow_correlation_0(_S573, _S574);
    if(_S575)
    {
        _S580 = fabrics_0._data[uint(_S571)].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S580 = fabrics_0._data[uint(_S571)].lobes_0.front_warp_packs_0;
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
        Lobes_0 _S583 = fabrics_0._data[uint(_S571)].lobes_0;
        if(pack_0 < (fabrics_0._data[uint(_S571)].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        vec4 _S584 = coverage_of_pack_0(_S571, _S576, pack_0);
        vec4 _S585 = interpolate_table_0(view_nodes_0, _S583.projected_area_0 + pack_0, _S583.packs_0 + 1U);
        uint _S586 = _S583.light_visibility_0 + pack_0;
        vec4 _S587 = interpolate_table_0(seen_nodes_0, _S586, _S583.packs_0) / 255.0;
        vec4 _S588 = interpolate_table_0(light_nodes_0, _S586, _S583.packs_0) / 255.0;
        vec4 _S589 = interpolate_table_0(light_nodes_0, _S583.irradiance_0 + pack_0, _S583.packs_0) * 0.00124827399849892;
        bool _S590 = pack_0 < _S580;
        uint _S591;
        if(_S590)
        {
            _S591 = fabrics_0._data[uint(_S571)].warp_0;
        }
        else
        {
            _S591 = fabrics_0._data[uint(_S571)].weft_0;
        }
        Family_0 _S592 = families_0._data[uint(_S591)];
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
            Group_0 _S593 = group_at_0(_S583.moments_0 + 12U * (4U * (_S578 * _S583.packs_0 + pack_0) + number_4), _S592.roughness_0);
            float _S594 = _S584[number_4] * _S585[number_4] * _S585[number_4] * _S593.weight_1;
            vec2 _S595 = visibility_gain_0(_S582, _S588[number_4], _S587[number_4]);
            float _S596 = _S595.x;
            float diffuse_1 = diffuse_0 + _S594 * _S589[number_4] * _S596;
            float specular_1 = specular_0 + _S594 * layer_value_0(_S593, _S581, _S573, _S574, fabrics_0._data[uint(_S571)].optical_depth_0) * _S588[number_4] * _S595.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S594 * _S588[number_4] * _S596;
            float total_3 = total_2 + _S594;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S597;
        if(_S590)
        {
            _S597 = diffuse_0;
        }
        else
        {
            _S597 = 0.0;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S597;
        float _S598;
        if(_S590)
        {
            _S598 = 0.0;
        }
        else
        {
            _S598 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S598;
        float _S599;
        if(_S590)
        {
            _S599 = specular_0;
        }
        else
        {
            _S599 = 0.0;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S599;
        float _S600;
        if(_S590)
        {
            _S600 = 0.0;
        }
        else
        {
            _S600 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S600;
        pack_0 = pack_0 + 1U;
    }
    float _S601 = prefiltered_hole_0(_S571, _S576, view_nodes_0, _S575);
    sums_1.hole_2 = _S601;
    float _S602 = (1.0 - _S601) / max(total_2, 9.999999960041972e-13);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S602;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S602;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S602;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S602;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S602;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S603, Footprint_0 _S604, bool _S605)
{
    vec2 _S606 = _S604.dx_0;
    vec2 _S607 = _S604.dy_0;
    vec2 _S608 = sqrt(_S606 * _S606 + _S607 * _S607);
    Stretch_0 _S609 = stretch_of_0(fabrics_0._data[uint(_S603)].warp_0, _S604.centre_0.x, _S608.x);
    Stretch_0 _S610 = stretch_of_0(fabrics_0._data[uint(_S603)].weft_0, _S604.centre_0.y, _S608.y);
    FamilyAlbedos_0 albedos_8;
    albedos_8.warp_2 = mean_albedos_0(fabrics_0._data[uint(_S603)].warp_0, fabrics_0._data[uint(_S603)].weft_0, _S609, _S610, _S605);
    albedos_8.weft_2 = mean_albedos_0(fabrics_0._data[uint(_S603)].weft_0, fabrics_0._data[uint(_S603)].warp_0, _S610, _S609, _S605);
    return albedos_8;
}

Estimate_0 lobes_estimate_0(uint _S611, Footprint_0 _S612, float _S613, vec3 _S614, vec3 _S615)
{
    float _S616;
    Regime_0 _S617 = regime_of_0(_S611, _S612, _S613);
    bool _S618 = (_S615.z) < 0.0;
    vec3 _S619 = to_face_frame_0(_S615, _S618);
    bool _S620;
    if((fabrics_0._data[uint(_S611)].fibre_noise_0) > 0.0)
    {
        _S620 = true;
    }
    else
    {
        _S620 = (fabrics_0._data[uint(_S611)].colour_noise_0) > 0.0;
    }
    bool _S621;
    if((families_0._data[uint(fabrics_0._data[uint(_S611)].warp_0)].quantities_0) > 1U)
    {
        _S621 = true;
    }
    else
    {
        _S621 = (families_0._data[uint(fabrics_0._data[uint(_S611)].weft_0)].quantities_0) > 1U;
    }
    float _S622 = 1.0 - _S617.prefiltered_0;
    if(_S622 > 0.0)
    {
        if(_S620)
        {
            _S621 = true;
        }
    }
    else
    {
        _S621 = false;
    }
    Footprint_0 box_0 = _S612;
    const vec3 _S623 = vec3(0.0);
    SurfacePoint_0 _S624 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0, _S623, _S623, 0.0, 0.0, 0.0);
    Components_0 _S625 = no_components_0();
    int _S626;
    if(_S621)
    {
        _S626 = 0;
    }
    else
    {
        _S626 = 1;
    }
    uint _S627 = uint(_S626);
    Components_0 points_1 = _S625;
    float central_weight_0 = 0.0;
    SurfacePoint_0 central_0 = _S624;
    vec2 central_place_0 = _S612.centre_0;
    uint number_5 = _S627;
    for(;;)
    {
        float _S628 = float(number_5);
        _S616 = _S617.points_0;
        if(_S628 < (_S617.points_0 + 1.0))
        {
        }
        else
        {
            break;
        }
        bool _S629 = number_5 == 0U;
        vec2 _S630;
        if(_S629)
        {
            _S630 = vec2(0.0);
        }
        else
        {
            _S630 = POINT_OFFSETS_0[number_5 - 1U];
        }
        vec2 _S631 = _S612.centre_0 + _S630.x * _S612.dx_0 + _S630.y * _S612.dy_0;
        float _S632;
        if(_S629)
        {
            _S632 = 0.0;
        }
        else
        {
            _S632 = _S617.threads_1;
        }
        SearchQuality_0 _S633 = quality_of_0(_S632);
        Hit_0 _S634 = first_hit_0(_S611, _S633, _S631.x, _S631.y, _S619, _S618);
        SurfacePoint_0 _S635 = surface_at_0(_S611, _S634.x_13, _S634.y_7, _S618);
        if(_S629)
        {
            float central_weight_1;
            if(_S634.hole_5)
            {
                central_weight_1 = 0.0;
            }
            else
            {
                central_weight_1 = _S622;
            }
            vec2 central_place_1 = vec2(_S634.x_13, _S634.y_7);
            box_0.centre_0 = mix(_S612.centre_0, central_place_1, vec2(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S635;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        points_1 = with_added_0(points_1, components_of_point_0(_S611, _S633, yarn_point_of_0(_S611, _S635, _S634.x_13, _S634.y_7, _S618, _S634.hole_5), _S614, _S615), min(_S617.points_0 - float(number_5 - 1U), 1.0));
        number_5 = number_5 + 1U;
    }
    Estimate_0 estimate_0;
    estimate_0.components_0 = with_added_0(_S625, points_1, _S622 / max(_S616, 1.0));
    if((_S617.prefiltered_0) > 0.0)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S611, _S612, to_face_frame_0(_S614, _S618), _S619, _S618), _S617.prefiltered_0);
    }
    estimate_0.albedos_4 = albedos_over_0(_S611, box_0, _S618);
    if(_S620)
    {
        _S620 = central_weight_0 > 0.0;
    }
    else
    {
        _S620 = false;
    }
    if(_S620)
    {
        SurfacePoint_0 _S636 = central_0;
        Albedos_0 _S637;
        if(central_0.is_warp_0)
        {
            _S637 = estimate_0.albedos_4.warp_2;
        }
        else
        {
            _S637 = estimate_0.albedos_4.weft_2;
        }
        Albedos_0 _S638 = lerp_albedos_0(_S637, varied_at_0(_S611, central_0, _S637, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S636.is_warp_0)
        {
            estimate_0.albedos_4.warp_2 = _S638;
        }
        else
        {
            estimate_0.albedos_4.weft_2 = _S638;
        }
    }
    return estimate_0;
}

vec3 composed_0(uint _S639, Components_0 _S640, FamilyAlbedos_0 _S641, vec3 _S642, vec3 _S643)
{
    vec3 _S644 = _S641.warp_2.diffuse_reflect_0 * _S640.diffuse_warp_0 + _S641.weft_2.diffuse_reflect_0 * _S640.diffuse_weft_0 + _S641.warp_2.specular_reflect_0 * _S640.specular_warp_0 + _S641.weft_2.specular_reflect_0 * _S640.specular_weft_0;
    float _S645 = _S643.z;
    vec3 body_0;
    if((_S642.z * _S645) < 0.0)
    {
        body_0 = _S641.warp_2.diffuse_transmit_0 * _S640.diffuse_warp_0 + _S641.weft_2.diffuse_transmit_0 * _S640.diffuse_weft_0 + _S641.warp_2.specular_transmit_0 * _S640.specular_warp_0 + _S641.weft_2.specular_transmit_0 * _S640.specular_weft_0;
    }
    else
    {
        body_0 = _S644;
    }
    float _S646 = fabrics_0._data[uint(_S639)].sheen_strength_0;
    if((fabrics_0._data[uint(_S639)].sheen_strength_0) <= 0.0)
    {
        return body_0;
    }
    bool _S647 = _S645 < 0.0;
    vec2 _S648 = sheen_with_transmittance_0(to_face_frame_0(_S642, _S647), to_face_frame_0(_S643, _S647), _S646, fabrics_0._data[uint(_S639)].sheen_roughness_0);
    return _S648.y * body_0 + (_S640.light_visibility_1 + _S640.hole_2) * _S648.x;
}

vec4 light_of_footprint_0(Frame_0 _S649, uint _S650, VisiblePoint_0 _S651)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = _S651.draft_0;
    footprint_0.dx_0 = _S651.draft_dx_0;
    footprint_0.dy_0 = _S651.draft_dy_0;
    vec3 _S652 = to_local_0(_S651, _S651.view_0);
    const vec3 _S653 = vec3(0.0);
    uint number_6 = 0U;
    vec3 radiance_1 = _S653;
    float hole_7 = 0.0;
    for(;;)
    {
        if(number_6 < (max(_S649.lights_0, 1U)))
        {
        }
        else
        {
            break;
        }
        vec3 irradiance_2;
        vec3 _S654 = towards_light_0(lights_1._data[uint(number_6)], _S651.position_0, irradiance_2);
        vec3 _S655 = to_local_0(_S651, _S654);
        Estimate_0 _S656 = lobes_estimate_0(_S650, footprint_0, 1.0, _S655, _S652);
        if(number_6 < (_S649.lights_0))
        {
            radiance_1 = radiance_1 + irradiance_2 * composed_0(_S650, _S656.components_0, _S656.albedos_4, _S655, _S652);
        }
        number_6 = number_6 + 1U;
        hole_7 = _S656.components_0.hole_2;
    }
    float _S657 = fabrics_0._data[uint(_S650)].sheen_strength_0;
    if((fabrics_0._data[uint(_S650)].sheen_strength_0) > 0.0)
    {
        hole_7 = hole_7 * (1.0 - _S657 * sheen_lobe_0(abs(_S652.z), fabrics_0._data[uint(_S650)].sheen_roughness_0).z);
    }
    return vec4(radiance_1, 1.0 - hole_7);
}

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
void main()
{
    Frame_0 _S658 = frames_0._data[uint(0)];
    bool _S659;
    if((gl_GlobalInvocationID.x) >= (_S658.width_0))
    {
        _S659 = true;
    }
    else
    {
        _S659 = (gl_GlobalInvocationID.y) >= (_S658.height_0);
    }
    if(_S659)
    {
        return;
    }
    uvec2 _S660 = gl_GlobalInvocationID.xy;
    ivec3 _S661 = ivec3(ivec2(_S660), 0);
    uint _S662 = (texelFetch((visible_faces_0), ((_S661)).xy, ((_S661)).z).x);
    const vec4 _S663 = vec4(0.0);
    vec4 sum_1;
    if(_S662 > 0U)
    {
        uint _S664 = _S662 - 1U;
        uint _S665 = face_fabrics_0._data[uint(_S664)];
        sum_1 = light_of_footprint_0(_S658, _S665, visible_point_0(_S658, _S665, _S664, _S660));
    }
    else
    {
        sum_1 = _S663;
    }
    accumulate_0(_S658, _S660, sum_1);
    return;
}

