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
layout(std430, binding = 8) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} radiance_0;
const float  PYRAMID_RADII_0[4] = float[](1.0, 2.0, 4.0, 8.0);
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

vec2 footprint_sample_0(uvec2 pixel_0, uint index_0)
{
    uint _S3 = pixel_0.x;
    uint _S4 = pixel_0.y;
    return fract(vec2(uniform_hash_0(_S3, _S4, 1U), uniform_hash_0(_S3, _S4, 2U)) + float(index_0 & 65535U) * vec2(0.75487768650054932, 0.56984031200408936)) - 0.5;
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

vec3 to_face_frame_0(vec3 direction_1, bool back_0)
{
    vec2 _S5 = direction_1.xy;
    float _S6;
    if(back_0)
    {
        _S6 = - direction_1.z;
    }
    else
    {
        _S6 = direction_1.z;
    }
    return vec3(_S5, _S6);
}

vec2 turns_and_remainder_0(uint family_0, float index_1)
{
    float _S7 = floor(fma(index_1, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S7, fma(- _S7, families_0._data[uint(family_0)].count_0, index_1));
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
    float _S8 = floor(position_1 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_1;
    float _S9 = fma(- _S8, families_0._data[uint(family_1)].size_0, position_1);
    cell_1.below_0 = _S9;
    cell_1.above_0 = families_0._data[uint(family_1)].size_0 - _S9;
    cell_1.across_0 = _S9 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_1.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_1.thread_1 = uint(clamp(turns_and_remainder_0(family_1, _S8).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_1;
}

float table_number_0(uint index_2)
{
    return uintBitsToFloat(words_0._data[uint(index_2)]);
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S10 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_2 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S11;
    if(_S10 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_2 * 4U + 1U)))
    {
        _S11 = 1U;
    }
    else
    {
        _S11 = 0U;
    }
    uint _S12 = min(thread_2 + _S11, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S13 = families_0._data[uint(family_2)].place_table_0 + _S12 * 4U;
    Cell_0 cell_2;
    cell_2.thread_1 = _S12;
    cell_2.below_0 = _S10 - table_number_0(_S13);
    cell_2.above_0 = table_number_0(_S13 + 1U) - _S10;
    cell_2.across_0 = _S10 - table_number_0(_S13 + 2U);
    cell_2.half_width_1 = table_number_0(_S13 + 3U);
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

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_1)
{
    bool _S14 = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    bool _S15 = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S16;
    if(_S14)
    {
        if(!_S15)
        {
            _S16 = true;
        }
        else
        {
            _S16 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S16 = false;
    }
    shown_0.is_warp_0 = _S16;
    if(!_S14)
    {
        _S16 = !_S15;
    }
    else
    {
        _S16 = false;
    }
    shown_0.hole_0 = _S16;
    uint _S17;
    if(shown_0.is_warp_0)
    {
        _S17 = crossing_0.warp_word_0;
    }
    else
    {
        _S17 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S17;
    shown_0.on_top_0 = ((_S17 & 1U) == 1U) != back_1;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_0, Cell_0 second_0)
{
    Cell_0 cell_3;
    uint _S18;
    if(is_first_0)
    {
        _S18 = first_0.thread_1;
    }
    else
    {
        _S18 = second_0.thread_1;
    }
    cell_3.thread_1 = _S18;
    float _S19;
    if(is_first_0)
    {
        _S19 = first_0.across_0;
    }
    else
    {
        _S19 = second_0.across_0;
    }
    cell_3.across_0 = _S19;
    if(is_first_0)
    {
        _S19 = first_0.half_width_1;
    }
    else
    {
        _S19 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S19;
    if(is_first_0)
    {
        _S19 = first_0.below_0;
    }
    else
    {
        _S19 = second_0.below_0;
    }
    cell_3.below_0 = _S19;
    if(is_first_0)
    {
        _S19 = first_0.above_0;
    }
    else
    {
        _S19 = second_0.above_0;
    }
    cell_3.above_0 = _S19;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0)
{
    vec2 _S20 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0));
    return fma(_S20.x, families_0._data[uint(family_4)].period_0, table_number_0(families_0._data[uint(family_4)].place_table_0 + uint(_S20.y) * 4U));
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
    Family_0 _S21 = families_0._data[uint(family_6)];
    uint _S22;
    if((families_0._data[uint(family_6)].is_alike_0) != 0U)
    {
        _S22 = 0U;
    }
    else
    {
        _S22 = thread_5 * 4U;
    }
    uint _S23 = _S21.bend_table_0 + _S22;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S23);
    bend_0.half_tangent_0 = table_number_0(_S23 + 1U);
    bend_0.arc_0 = table_number_0(_S23 + 2U);
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
    int _S24 = int((word_1 >> 1) & 127U);
    int _S25 = int((word_1 >> 8) & 127U);
    int _S26 = int((word_1 >> 15) & 63U);
    int _S27 = int((word_1 >> 21) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> 27) & 1U) == 1U;
    int _S28 = - _S24;
    float _S29 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S28, 0);
    run_0.from_start_0 = _S29;
    int _S30 = _S25 + 1;
    float _S31 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, 1, _S30);
    run_0.to_end_0 = _S31;
    bool _S32 = _S29 < _S31;
    run_0.near_start_0 = _S32;
    int _S33;
    if(_S32)
    {
        _S33 = _S28 - _S26;
    }
    else
    {
        _S33 = _S30;
    }
    int _S34;
    if(run_0.near_start_0)
    {
        _S34 = _S28;
    }
    else
    {
        _S34 = _S30 + _S27;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    float _S35;
    if(run_0.straight_0)
    {
        _S35 = 1.0e+06;
    }
    else
    {
        _S35 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S35;
    run_0.reach_0 = min(0.5 * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5 * span_0(other_0, crossed_0.thread_1, _S33, _S34), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S24 == 0;
    run_0.last_crossing_0 = _S25 == 0;
    return run_0;
}

float square_1(float x_2)
{
    return x_2 * x_2;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_4)
{
    float _S36 = cell_4.half_width_1 * 1.0154266357421875;
    Section_0 section_0;
    float _S37 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S37;
    float _S38 = _S36 * _S36 - square_1(_S37);
    float _S39 = (inversesqrt((_S38)));
    section_0.drop_0 = _S36 - _S38 * _S39;
    section_0.slope_0 = - _S37 * _S39;
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
    bool _S40 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S41 = min(crossed_1.below_0, crossed_1.above_0);
    float _S42;
    if(_S40)
    {
        _S42 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S42 = crossed_1.above_0 + crossed_1.across_0;
    }
    float _S43 = _S42 - crossed_1.half_width_1;
    bool _S44;
    if(_S40)
    {
        _S44 = run_1.first_crossing_0;
    }
    else
    {
        _S44 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S42 = 0.0;
    }
    else
    {
        _S42 = families_0._data[uint(other_1)].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, 0);
    }
    float _S45;
    if((shown_1.on_top_0) != _S44)
    {
        _S45 = 0.0;
    }
    else
    {
        Family_0 _S46 = families_0._data[uint(other_1)];
        int _S47;
        if(_S40)
        {
            _S47 = -1;
        }
        else
        {
            _S47 = 1;
        }
        _S45 = _S46.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S47);
    }
    float _S48 = 1.0 / max(2.0 * _S43, 9.999999960041972e-13);
    float _S49 = clamp((_S43 - _S41) * _S48, 0.0, 1.0);
    float _S50 = _S42 + (_S45 - _S42) * (_S49 * _S49 * (3.0 - 2.0 * _S49));
    float _S51 = (_S42 - _S45) * (6.0 * _S49 * (1.0 - _S49) * _S48);
    if(_S40)
    {
        _S42 = 1.0;
    }
    else
    {
        _S42 = -1.0;
    }
    return vec2(_S50, _S51 * _S42);
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
    float _S52 = direction_2.x;
    control_0.per_x_0 = 1.0 / max(abs(_S52), 9.99999971718068537e-10);
    float _S53 = direction_2.y;
    control_0.per_y_0 = 1.0 / max(abs(_S53), 9.99999971718068537e-10);
    control_0.right_0 = _S52 > 0.0;
    control_0.up_0 = _S53 > 0.0;
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
    float _S54;
    if(forwards_0)
    {
        _S54 = cell_5.across_0;
    }
    else
    {
        _S54 = - cell_5.across_0;
    }
    float _S55;
    if(forwards_0)
    {
        _S55 = cell_5.above_0;
    }
    else
    {
        _S55 = cell_5.below_0;
    }
    bool _S56;
    if(forwards_0)
    {
        _S56 = run_2.last_crossing_0;
    }
    else
    {
        _S56 = run_2.first_crossing_0;
    }
    bool _S57;
    if(forwards_0)
    {
        _S57 = run_2.first_crossing_0;
    }
    else
    {
        _S57 = run_2.last_crossing_0;
    }
    float _S58 = - cell_5.half_width_1;
    bool _S59 = _S54 < _S58;
    bool _S60 = _S54 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S56 = !_S56;
    }
    else
    {
        _S56 = false;
    }
    if(_S56)
    {
        _S56 = !shown_2.hole_0;
    }
    else
    {
        _S56 = false;
    }
    bool _S61;
    if(_S56)
    {
        _S61 = shown_2.on_top_0;
    }
    else
    {
        _S61 = false;
    }
    if(_S61)
    {
        if(_S57)
        {
            _S57 = _S59;
        }
        else
        {
            _S57 = false;
        }
        _S57 = !_S57;
    }
    else
    {
        _S57 = false;
    }
    if(shown_2.hole_0)
    {
        _S56 = true;
    }
    else
    {
        if(_S56)
        {
            _S56 = !shown_2.on_top_0;
        }
        else
        {
            _S56 = false;
        }
    }
    float _S62;
    if(_S59)
    {
        _S62 = _S58;
    }
    else
    {
        _S62 = cell_5.half_width_1;
    }
    float _S63 = _S62 - _S54;
    if(_S56)
    {
        _S54 = 2.0 * _S55 + _S54 - cell_5.half_width_1;
    }
    else
    {
        _S54 = _S55;
    }
    if(_S57)
    {
        if(forwards_0)
        {
            _S54 = run_2.to_end_0;
        }
        else
        {
            _S54 = run_2.from_start_0;
        }
        return _S54;
    }
    if(_S60)
    {
    }
    else
    {
        _S54 = _S63;
    }
    return _S54;
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
    float _S64 = previous_1.rate_0 * step_4;
    float _S65 = rate_1 * step_4;
    bool _S66;
    if(!previous_1.known_0)
    {
        _S66 = true;
    }
    else
    {
        _S66 = here_0.hole_1;
    }
    if(_S66)
    {
        _S66 = true;
    }
    else
    {
        _S66 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S66)
    {
        _S66 = true;
    }
    else
    {
        _S66 = (previous_1.rate_0) >= 0.0;
    }
    if(_S66)
    {
        _S66 = true;
    }
    else
    {
        _S66 = rate_1 <= 0.0;
    }
    if(_S66)
    {
        return -1.0;
    }
    if((3.0 * previous_1.clearance_0 + _S64) >= 0.0)
    {
        _S66 = (3.0 * clearance_1 - _S65) >= 0.0;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        return -1.0;
    }
    float _S67 = clearance_1 - previous_1.clearance_0;
    float _S68 = 6.0 * _S67 - 4.0 * _S64 - 2.0 * _S65;
    float _S69 = -2.0 * _S64 / max(_S68 + sqrt(max(_S68 * _S68 - 4.0 * (3.0 * (_S64 + _S65 - 2.0 * _S67)) * _S64, 0.0)), 9.99999968265522539e-21);
    float _S70 = 1.0 - _S69;
    float _S71 = (previous_1.clearance_0 * (2.0 * _S69 + 1.0) + _S64 * _S69) * _S70 * _S70;
    float _S72 = (clearance_1 * (2.0 * _S70 + 1.0) - _S65 * _S70) * _S69 * _S69;
    if(_S69 > 0.01999999955296516)
    {
        _S66 = _S70 > 0.01999999955296516;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        _S66 = (_S71 + _S72) < 0.0;
    }
    else
    {
        _S66 = false;
    }
    float _S73;
    if(_S66)
    {
        _S73 = _S70 * step_4;
    }
    else
    {
        _S73 = -1.0;
    }
    return _S73;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S74;
    if(here_1.hole_1)
    {
        _S74 = 1.0e+09;
    }
    else
    {
        _S74 = clearance_2;
    }
    previous_2.clearance_0 = _S74;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S75;
    if(!here_1.hole_1)
    {
        _S75 = !is_cell_exit_0;
    }
    else
    {
        _S75 = false;
    }
    previous_2.known_0 = _S75;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_0, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0) + this_0.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_1, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S76 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    bool _S77;
    if(!here_2.hole_1)
    {
        _S77 = (rate_3 * _S76 + clearance_3) < 0.0;
    }
    else
    {
        _S77 = false;
    }
    if(_S77)
    {
        _S77 = _S76 > (2.0 * this_1.epsilon_0);
    }
    else
    {
        _S77 = false;
    }
    float _S78;
    if(_S77)
    {
        _S78 = _S76 - this_1.epsilon_0;
    }
    else
    {
        _S78 = max(_S76, 0.0) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S78);
}

struct ViewRay_0
{
    vec2 origin_0;
    vec2 slope_1;
};

vec2 ViewRay_at_0(ViewRay_0 this_2, float height_2)
{
    return this_2.origin_0 + this_2.slope_1 * height_2;
}

float ViewRay_rate_0(ViewRay_0 this_3, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_3.slope_1.x + here_3.slope_y_0 * this_3.slope_1.y - 1.0;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S79 = end_0 - start_1;
    float _S80 = start_rate_0 + end_rate_0 - 2.0 * _S79;
    float _S81 = 3.0 * _S79 - 2.0 * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S79, 9.99999968265522539e-21);
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
        float _S82 = clamp(share_0 - (((_S80 * share_0 + _S81) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0 * _S80 * share_0 + 2.0 * _S81) * share_0 + start_rate_0, 0.10000000149011612 * _S79 - 9.99999968265522539e-21), 0.0, 1.0);
        int _S83 = i_0 + 1;
        share_0 = _S82;
        i_0 = _S83;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21), 0.01999999955296516, 0.98000001907348633) * (under_0 - above_1) + above_1;
}

vec2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S84 = along_slope_0 * along_slope_0 + 1.0;
    float _S85 = (inversesqrt((_S84)));
    float _S86 = sine_1 * _S85 * (inversesqrt((_S84 + across_slope_0 * across_slope_0)));
    return vec2(- _S86 * _S84, _S86 * across_slope_0 * along_slope_0 + cosine_0 * _S85);
}

float arc_sine_0(float x_3)
{
    float _S87 = abs(x_3);
    bool _S88 = _S87 > 0.5;
    float _S89;
    if(_S88)
    {
        _S89 = 0.5 * (1.0 - _S87);
    }
    else
    {
        _S89 = _S87 * _S87;
    }
    float _S90;
    if(_S88)
    {
        _S90 = sqrt(max(_S89, 0.0));
    }
    else
    {
        _S90 = _S87;
    }
    float _S91 = ((((0.04216320067644119 * _S89 + 0.02418131195008755) * _S89 + 0.04547002539038658) * _S89 + 0.07495300471782684) * _S89 + 0.16666752099990845) * _S89 * _S90 + _S90;
    if(_S88)
    {
        _S89 = 1.57079637050628662 - 2.0 * _S91;
    }
    else
    {
        _S89 = _S91;
    }
    if(x_3 < 0.0)
    {
        _S89 = - _S89;
    }
    return _S89;
}

vec3 table_colour_0(uint index_3)
{
    return vec3(table_number_0(index_3), table_number_0(index_3 + 1U), table_number_0(index_3 + 2U));
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

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0 * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0) + 1.0;
}

float bounded_gain_0(float gain_1, vec3 albedo_0, vec3 room_0)
{
    vec3 _S92 = room_0 / max(albedo_0, vec3(9.99999997475242708e-07));
    return min(gain_1, max(min(min(_S92.x, _S92.y), _S92.z), 0.0));
}

float natural_logarithm_0(float x_4)
{
    uint _S93 = floatBitsToUint(x_4);
    float exponent_0 = float(int(_S93 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S93 & 8388607U) | 1056964608U);
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
    float _S94 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S94 - exponent_1 * 0.00021219444170129 - 0.5 * _S94) + exponent_1 * 0.693359375;
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0) - 1.0) + 1.0;
}

vec3 towards_light_0(Light_0 light_0, vec3 position_4, out vec3 irradiance_1)
{
    irradiance_1 = vec3(light_0.red_0, light_0.green_0, light_0.blue_0);
    vec3 _S95 = vec3(light_0.x_1, light_0.y_1, light_0.z_1);
    if((light_0.is_point_0) == 0U)
    {
        return _S95;
    }
    vec3 _S96 = _S95 - position_4;
    irradiance_1 = irradiance_1 / max(square_0(_S96), 9.999999960041972e-13);
    return normalize(_S96);
}

float diffuse_reflection_0(vec3 light_1, vec3 normal_1, float blend_0)
{
    float _S97 = light_1.z;
    if(_S97 <= 0.0)
    {
        return 0.0;
    }
    return 0.31830987334251404 * mix(max(_S97, 0.0), max(dot(light_1, normal_1), 0.0), blend_0);
}

float projected_area_1(vec3 direction_3, vec3 tangent_0, float roughness_1)
{
    float _S98 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0) * (roughness_1 - 1.0) * _S98 * _S98 + 1.0, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S99 = clamp(x_5, -87.0, 88.0);
    float _S100 = floor(_S99 * 1.4426950216293335 + 0.5);
    float _S101 = _S99 - _S100 * 0.693359375 + _S100 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S101 + 0.00139819993637502) * _S101 + 0.00833345204591751) * _S101 + 0.04166579619050026) * _S101 + 0.1666666567325592) * _S101 + 0.5;
    float _S102 = uintBitsToFloat(uint(int(_S100) + 127) << 23);
    float _S103;
    if(x_5 < -87.0)
    {
        _S103 = 0.0;
    }
    else
    {
        _S103 = (p_0 * _S101 * _S101 + _S101 + 1.0) * _S102;
    }
    return _S103;
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
    float _S104 = roughness_2 * roughness_2;
    float _S105 = squared_along_0 * (1.0 - _S104) + _S104;
    return 0.31830987334251404 * _S104 * roughness_2 / (_S105 * _S105);
}

float density_between_0(vec3 light_2, vec3 view_1, vec3 tangent_1, float roughness_3)
{
    vec3 _S106 = light_2 + view_1;
    float _S107 = dot(_S106, tangent_1);
    return flake_density_0(min(_S107 * _S107 / max(square_0(_S106), 9.999999960041972e-13), 1.0), roughness_3);
}

float reflection_0(vec3 light_3, vec3 view_2, vec3 normal_2, vec3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S108 = dot(light_3, normal_2);
    bool _S109;
    if(_S108 <= 0.0)
    {
        _S109 = true;
    }
    else
    {
        _S109 = (dot(view_2, normal_2)) <= 0.0;
    }
    if(_S109)
    {
        return 0.0;
    }
    float _S110 = max(_S108, 9.99999997475242708e-07);
    float _S111 = max(dot(view_2, normal_2), 9.99999997475242708e-07);
    float _S112 = projected_area_1(light_3, tangent_2, roughness_4) * _S111 + projected_area_1(view_2, tangent_2, roughness_4) * _S110;
    float _S113 = optical_depth_1 * _S112 / (_S110 * _S111);
    return 0.25 * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S113 * mean_attenuation_0(_S113)) * _S110 / _S112;
}

float transmission_0(vec3 light_4, vec3 view_3, vec3 normal_3, vec3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S114 = - dot(light_4, normal_3);
    float _S115 = dot(view_3, normal_3);
    bool _S116;
    if(_S114 <= 0.0)
    {
        _S116 = true;
    }
    else
    {
        _S116 = _S115 <= 0.0;
    }
    if(_S116)
    {
        return 0.0;
    }
    float _S117 = 1.0 / max(_S115, 9.99999997475242708e-07);
    float _S118 = projected_area_1(light_4, tangent_3, roughness_5) / max(_S114, 9.99999997475242708e-07);
    float _S119 = projected_area_1(view_3, tangent_3, roughness_5) * _S117;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25 * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S118, _S119)) * mean_attenuation_0(optical_depth_2 * abs(_S118 - _S119)) * _S117;
}

float sheen_scale_0(float x_6, float y_2)
{
    return (((((0.0 * x_6 + (((((-1.1402510404586792 * y_2 + 0.40672621130943298) * y_2 + 1.65398800373077393) * y_2 + -1.29730904102325439) * y_2 + 0.30570998787879944) * y_2 + -0.0220868494361639)) * x_6 + (((((-0.21142719686031342 * y_2 + 1.05947399139404297) * y_2 + -0.41116121411323547) * y_2 + -0.93859231472015381) * y_2 + 0.51606941223144531) * y_2 + 0.05409301072359085)) * x_6 + (((((1.22944498062133789 * y_2 + -0.45962560176849365) * y_2 + -1.63861405849456787) * y_2 + 1.33565104007720947) * y_2 + -0.45725581049919128) * y_2 + 0.08243165910243988)) * x_6 + (((((0.39779931306838989 * y_2 + -1.18879103660583496) * y_2 + 0.28251591324806213) * y_2 + 1.168984055519104) * y_2 + -0.76864629983901978) * y_2 + 0.0091691892594099)) * x_6 + (((((-0.26563560962677002 * y_2 + -0.19379159808158875) * y_2 + 0.2677634060382843) * y_2 + 0.00270519289188087) * y_2 + 0.14349560439586639) * y_2 + 0.10290180146694183)) * x_6 + (((((-0.20701569318771362 * y_2 + 0.24526430666446686) * y_2 + 0.19551840424537659) * y_2 + 0.07586126774549484) * y_2 + 0.38894739747047424) * y_2 + 0.15043120086193085);
}

float sheen_shear_0(float x_7, float y_3)
{
    return ((((0.0 * x_7 + (((((-0.10608240216970444 * y_3 + 1.99214303493499756) * y_3 + -1.42255294322967529) * y_3 + -1.09495604038238525) * y_3 + 0.59180057048797607) * y_3 + 0.06902855634689331)) * x_7 + (((((-0.46220690011978149 * y_3 + -0.29113379120826721) * y_3 + 1.39025199413299561) * y_3 + 0.35589990019798279) * y_3 + -1.17120099067687988) * y_3 + 0.15940259397029877)) * x_7 + (((((2.26068711280822754 * y_3 + -3.64728999137878418) * y_3 + -0.72173482179641724) * y_3 + 3.07659196853637695) * y_3 + -0.6827620267868042) * y_3 + -0.3039557933807373)) * x_7 + (((((0.81201767921447754 * y_3 + 0.36014080047607422) * y_3 + -1.72646903991699219) * y_3 + -0.22630110383033752) * y_3 + 0.89514690637588501) * y_3 + -0.10397960245609283)) * x_7 + (((((-0.37648698687553406 * y_3 + 1.10974001884460449) * y_3 + 0.17824520170688629) * y_3 + -1.04968702793121338) * y_3 + 0.1461234986782074) * y_3 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_8, float y_4)
{
    return ((((0.0 * x_8 + (((((12.95646953582763672 * y_4 + -21.38032913208007812) * y_4 + -7.37853097915649414) * y_4 + 34.55607986450195312) * y_4 + -23.61347007751464844) * y_4 + 5.00126314163208008)) * x_8 + (((((10.91487026214599609 * y_4 + -6.08202791213989258) * y_4 + -38.2036285400390625) * y_4 + 53.3440399169921875) * y_4 + -21.91996002197265625) * y_4 + 2.01606011390686035)) * x_8 + (((((-14.52206039428710938 * y_4 + 36.803619384765625) * y_4 + -22.94047927856445312) * y_4 + -10.07973003387451172) * y_4 + 15.77003955841064453) * y_4 + -4.92722177505493164)) * x_8 + (((((-7.62505722045898438 * y_4 + 1.27310299873352051) * y_4 + 31.19523048400878906) * y_4 + -44.39989852905273438) * y_4 + 26.44947052001953125) * y_4 + -8.73507976531982422)) * x_8 + (((((5.65633487701416016 * y_4 + -17.66820907592773438) * y_4 + 24.65356063842773438) * y_4 + -19.38941001892089844) * y_4 + 11.06159019470214844) * y_4 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S120 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S121 = 2.0 * sqrt(_S120) - 1.0;
    float _S122 = 3.0 * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S121, _S122), 0.00999999977648258, 1.0), clamp((1.0 - _S120) * sheen_shear_0(_S121, _S122), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S121, _S122), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_5, vec3 view_4, float scale_0, float shear_0)
{
    float _S123 = light_5.z;
    bool _S124;
    if(_S123 <= 0.0)
    {
        _S124 = true;
    }
    else
    {
        _S124 = (view_4.z) <= 0.0;
    }
    if(_S124)
    {
        return 0.0;
    }
    vec2 _S125 = view_4.xy;
    float _S126 = dot(_S125, _S125);
    vec2 _S127;
    if(_S126 > 9.99999968265522539e-21)
    {
        _S127 = _S125 * (inversesqrt((_S126)));
    }
    else
    {
        _S127 = vec2(1.0, 0.0);
    }
    float _S128 = scale_0 * dot(light_5.xy, _S127) + shear_0 * _S123;
    float _S129 = scale_0 * (light_5.y * _S127.x - light_5.x * _S127.y);
    float _S130 = _S128 * _S128 + _S129 * _S129 + _S123 * _S123;
    return 0.31830987334251404 * scale_0 * scale_0 * _S123 / max(_S130 * _S130, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_6, vec3 view_5, float strength_0, float roughness_7)
{
    vec3 _S131 = sheen_lobe_0(view_5.z, roughness_7);
    float _S132 = strength_0 * _S131.z;
    return vec2(_S132 * transformed_cosine_0(light_6, view_5, _S131.x, _S131.y), 1.0 - _S132);
}

void accumulate_0(Frame_0 frame_4, uvec2 pixel_1, vec4 light_7)
{
    uint _S133 = pixel_1.y * frame_4.width_0 + pixel_1.x;
    float _S134 = light_7.w;
    vec4 _S135 = vec4(light_7.xyz + (1.0 - _S134) * vec3(frame_4.background_red_0, frame_4.background_green_0, frame_4.background_blue_0), _S134);
    vec4 _S136;
    if((frame_4.pass_number_0) == 0U)
    {
        _S136 = _S135;
    }
    else
    {
        _S136 = radiance_0._data[uint(_S133)] + _S135;
    }
    radiance_0._data[uint(_S133)] = _S136;
    return;
}

VisiblePoint_0 visible_point_0(Frame_0 _S137, uint _S138, uint _S139, uvec2 _S140)
{
    uint _S141 = 3U * _S139;
    Vertex_0 _S142 = vertices_0._data[uint(corners_0._data[uint(_S141)])];
    Vertex_0 _S143 = vertices_0._data[uint(corners_0._data[uint(_S141 + 1U)])];
    Vertex_0 _S144 = vertices_0._data[uint(corners_0._data[uint(_S141 + 2U)])];
    vec3 _S145 = position_of_0(_S142);
    vec3 _S146 = position_of_0(_S143) - _S145;
    vec3 _S147 = position_of_0(_S144) - _S145;
    vec3 _S148 = cross(_S146, _S147);
    float _S149 = 1.0 / max(square_0(_S148), 1.00000000317107685e-30);
    float _S150 = float(_S137.width_0);
    vec3 _S151 = camera_right_0(_S137) * (2.0 / _S150);
    float _S152 = float(_S137.height_0);
    vec3 _S153 = camera_up_0(_S137) * (-2.0 / _S152);
    vec3 _S154 = camera_forward_0(_S137) + (float(_S140.x) + 0.5 - 0.5 * _S150) * _S151 + (float(_S140.y) + 0.5 - 0.5 * _S152) * _S153;
    float _S155 = dot(_S154, _S148);
    float _S156;
    if((abs(_S155)) > 1.00000000317107685e-30)
    {
        _S156 = _S155;
    }
    else
    {
        _S156 = 1.00000000317107685e-30;
    }
    float _S157 = 1.0 / _S156;
    vec3 _S158 = _S145 - camera_origin_0(_S137);
    float _S159 = dot(_S158, _S148) * _S157;
    vec3 _S160 = _S154 * _S159 - _S158;
    vec3 _S161 = _S159 * (_S151 - _S154 * (dot(_S151, _S148) * _S157));
    vec3 _S162 = _S159 * (_S153 - _S154 * (dot(_S153, _S148) * _S157));
    vec3 _S163 = cross(_S147, _S148) * _S149;
    vec3 _S164 = cross(_S148, _S146) * _S149;
    float _S165 = dot(_S160, _S163);
    float _S166 = dot(_S160, _S164);
    float _S167 = _S143.u_0 - _S142.u_0;
    float _S168 = _S143.v_0 - _S142.v_0;
    vec2 _S169 = vec2(_S167, _S168);
    float _S170 = _S144.u_0 - _S142.u_0;
    float _S171 = _S144.v_0 - _S142.v_0;
    vec2 _S172 = vec2(_S170, _S171);
    vec2 _S173 = vec2(_S142.u_0, _S142.v_0) + _S165 * _S169 + _S166 * _S172;
    vec2 _S174 = dot(_S161, _S163) * _S169 + dot(_S161, _S164) * _S172;
    vec2 _S175 = dot(_S162, _S163) * _S169 + dot(_S162, _S164) * _S172;
    if((_S167 * _S171 - _S168 * _S170) < 0.0)
    {
        _S156 = -1.0;
    }
    else
    {
        _S156 = 1.0;
    }
    vec3 _S176 = _S156 * (_S171 * _S146 - _S168 * _S147);
    vec3 _S177 = _S156 * (_S167 * _S147 - _S170 * _S146);
    VisiblePoint_0 point_1;
    vec3 _S178 = normalize((1.0 - _S165 - _S166) * normal_of_0(_S142) + _S165 * normal_of_0(_S143) + _S166 * normal_of_0(_S144));
    point_1.normal_0 = _S178;
    vec3 _S179 = normalize(_S176 - _S178 * dot(_S178, _S176));
    point_1.axis_x_0 = _S179;
    point_1.axis_y_0 = cross(_S178, _S179);
    point_1.position_0 = _S145 + _S160;
    point_1.view_0 = - normalize(_S154);
    bool _S180 = (dot(cross(_S176, _S177), _S178)) < 0.0;
    float _S181 = fabrics_0._data[uint(_S138)].uv_width_0;
    if(_S180)
    {
        _S156 = - fabrics_0._data[uint(_S138)].uv_height_0;
    }
    else
    {
        _S156 = fabrics_0._data[uint(_S138)].uv_height_0;
    }
    vec2 _S182 = vec2(_S181, _S156);
    vec2 _S183 = _S173 * _S182;
    if(_S180)
    {
        _S156 = fabrics_0._data[uint(_S138)].uv_height_0;
    }
    else
    {
        _S156 = 0.0;
    }
    point_1.draft_0 = _S183 + vec2(0.0, _S156);
    point_1.draft_dx_0 = _S174 * _S182;
    point_1.draft_dy_0 = _S175 * _S182;
    return point_1;
}

struct YarnPoint_0
{
    bool back_2;
    bool hole_2;
    bool is_warp_1;
    float x_9;
    float y_5;
    float height_3;
    vec3 normal_4;
    vec3 tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_10;
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

Crossing_0 crossing_at_0(uint _S184, float _S185, float _S186, bool _S187)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0._data[uint(_S184)].warp_0, _S185);
    crossing_2.weft_1 = locate_0(fabrics_0._data[uint(_S184)].weft_0, _S186);
    uint _S188 = fabrics_0._data[uint(_S184)].run_words_0 + 2U * (crossing_2.weft_1.thread_1 * fabrics_0._data[uint(_S184)].ends_1 + crossing_2.warp_1.thread_1);
    uint _S189 = words_0._data[uint(_S188)];
    crossing_2.warp_word_0 = _S189;
    crossing_2.weft_word_0 = words_0._data[uint(_S188 + 1U)];
    crossing_2.warp_above_0 = ((_S189 & 1U) == 1U) != _S187;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S190, float _S191, float _S192, bool _S193)
{
    Sample_0 sample_0;
    Crossing_0 _S194 = crossing_at_0(_S190, _S191, _S192, _S193);
    sample_0.crossing_1 = _S194;
    Shown_0 _S195 = shown_at_0(_S194, _S193);
    sample_0.shown_3 = _S195;
    uint _S196;
    if(_S195.is_warp_0)
    {
        _S196 = fabrics_0._data[uint(_S190)].warp_0;
    }
    else
    {
        _S196 = fabrics_0._data[uint(_S190)].weft_0;
    }
    uint _S197;
    if(_S195.is_warp_0)
    {
        _S197 = fabrics_0._data[uint(_S190)].weft_0;
    }
    else
    {
        _S197 = fabrics_0._data[uint(_S190)].warp_0;
    }
    Cell_0 _S198 = select_cell_0(_S195.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    Cell_0 _S199 = select_cell_0(_S195.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    Run_0 _S200 = unpack_0(_S196, _S197, _S198.thread_1, _S199, _S195.word_0);
    Section_0 _S201 = section_at_0(_S198);
    bool _S202;
    if(_S195.on_top_0)
    {
        _S202 = (_S200.distance_0) < (_S201.drop_0 * _S200.bend_1.sine_0);
    }
    else
    {
        _S202 = false;
    }
    bool _S203;
    if(_S195.on_top_0)
    {
        _S203 = !_S202;
    }
    else
    {
        _S203 = false;
    }
    float _S204;
    if(_S203)
    {
        _S204 = 1.0;
    }
    else
    {
        _S204 = -1.0;
    }
    float _S205;
    if(_S202)
    {
        _S205 = _S200.other_reach_0;
    }
    else
    {
        _S205 = _S200.reach_0;
    }
    float _S206;
    if(_S202)
    {
        _S206 = _S205 + _S200.distance_0;
    }
    else
    {
        _S206 = max(_S205 - _S200.distance_0, 0.0);
    }
    float _S207 = _S205 / _S200.bend_1.sine_0 - _S204 * _S201.drop_0;
    float _S208 = _S206 * _S206;
    float _S209 = max(_S207 * _S207 - _S208, 9.99999968265522539e-21);
    float _S210 = (inversesqrt((_S209)));
    float _S211 = _S208 / (_S209 * _S210 + _S207);
    bool _S212 = _S206 > 0.0;
    float _S213;
    if(_S195.on_top_0)
    {
        _S213 = 1.0;
    }
    else
    {
        _S213 = -1.0;
    }
    float _S214;
    if(_S200.near_start_0)
    {
        _S214 = 1.0;
    }
    else
    {
        _S214 = -1.0;
    }
    float _S215 = _S213 * _S214;
    if(_S212)
    {
        _S213 = _S207 * _S210;
    }
    else
    {
        _S213 = 1.0;
    }
    sample_0.slope_across_0 = _S201.slope_0 * _S213;
    if(_S212)
    {
        _S206 = _S215 * _S206 * _S210;
    }
    else
    {
        _S206 = 0.0;
    }
    sample_0.slope_along_0 = _S206;
    Family_0 _S216 = families_0._data[uint(_S196)];
    vec2 _S217 = dive_0(_S197, _S195, _S200, _S199);
    if(_S200.straight_0)
    {
        _S204 = 0.0;
    }
    else
    {
        _S204 = _S216.height_scale_0 * _S204;
    }
    sample_0.height_5 = _S204 * (_S205 * _S200.bend_1.half_tangent_0 - _S211) - _S216.height_scale_0 * _S201.drop_0 - _S217.x;
    float _S218 = _S216.height_scale_0 * sample_0.slope_across_0;
    float _S219 = _S216.height_scale_0 * sample_0.slope_along_0 - _S217.y;
    if(_S195.is_warp_0)
    {
        _S204 = _S218;
    }
    else
    {
        _S204 = _S219;
    }
    sample_0.slope_x_1 = _S204;
    if(_S195.is_warp_0)
    {
        _S204 = _S219;
    }
    else
    {
        _S204 = _S218;
    }
    sample_0.slope_y_1 = _S204;
    sample_0.run_3 = _S200;
    sample_0.section_1 = _S201;
    return sample_0;
}

float steps_per_length_0(uint _S220, SearchQuality_0 _S221, vec3 _S222)
{
    return max(max(abs(_S222.x) * fabrics_0._data[uint(_S220)].threads_per_x_0, abs(_S222.y) * fabrics_0._data[uint(_S220)].threads_per_y_0) * _S221.steps_per_thread_0, abs(_S222.z) * fabrics_0._data[uint(_S220)].per_relief_0 * _S221.steps_per_relief_0);
}

float cell_maximum_0(uint _S223, Crossing_0 _S224)
{
    uint _S225;
    if(_S224.warp_above_0)
    {
        _S225 = fabrics_0._data[uint(_S223)].warp_0;
    }
    else
    {
        _S225 = fabrics_0._data[uint(_S223)].weft_0;
    }
    uint _S226;
    if(_S224.warp_above_0)
    {
        _S226 = _S224.warp_word_0;
    }
    else
    {
        _S226 = _S224.weft_word_0;
    }
    return float(_S226 >> 28) * families_0._data[uint(_S225)].height_scale_0 * families_0._data[uint(_S225)].level_0;
}

Probe_0 probe_0(uint _S227, float _S228, float _S229, bool _S230, bool _S231, bool _S232)
{
    Sample_0 _S233 = sample_at_0(_S227, _S228, _S229, _S230);
    Probe_0 probe_1;
    probe_1.height_1 = _S233.height_5;
    probe_1.hole_1 = _S233.shown_3.hole_0;
    probe_1.slope_x_0 = _S233.slope_x_1;
    probe_1.slope_y_0 = _S233.slope_y_1;
    uint _S234;
    if(_S233.shown_3.is_warp_0)
    {
        _S234 = _S233.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S234 = _S233.crossing_1.weft_1.thread_1 * 2U;
    }
    probe_1.yarn_1 = _S234;
    probe_1.cell_max_0 = cell_maximum_0(_S227, _S233.crossing_1);
    float _S235;
    if(_S231)
    {
        _S235 = _S233.crossing_1.warp_1.above_0;
    }
    else
    {
        _S235 = _S233.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S235;
    if(_S232)
    {
        _S235 = _S233.crossing_1.weft_1.above_0;
    }
    else
    {
        _S235 = _S233.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S235;
    probe_1.edge_x_0 = outline_distance_0(_S233.crossing_1.warp_1, _S233.shown_3, _S233.run_3, !_S233.shown_3.is_warp_0, _S231);
    probe_1.edge_y_0 = outline_distance_0(_S233.crossing_1.weft_1, _S233.shown_3, _S233.run_3, _S233.shown_3.is_warp_0, _S232);
    return probe_1;
}

bool is_free_0(uint _S236, SearchQuality_0 _S237, vec3 _S238, vec3 _S239, bool _S240, float _S241)
{
    float _S242 = _S239.z;
    if(_S242 <= 0.0)
    {
        return false;
    }
    float _S243 = 1.0 / max(_S237.shadow_share_0 * steps_per_length_0(_S236, _S237, _S239), 9.99999971718068537e-10);
    StepControl_0 _S244 = step_control_0(_S239.xy, _S243);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0;
    float last_step_0 = 0.0;
    for(;;)
    {
        bool _S245;
        if(count_1 < 1024U)
        {
            _S245 = (_S238.z + _S242 * distance_1) < _S241;
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
        vec3 _S246 = _S238 + _S239 * distance_1;
        Probe_0 _S247 = probe_0(_S236, _S246.x, _S246.y, _S240, _S244.right_0, _S244.up_0);
        float _S248 = _S246.z;
        float _S249 = _S248 - _S247.height_1;
        float _S250 = _S242 - _S247.slope_x_0 * _S239.x - _S247.slope_y_0 * _S239.y;
        bool _S251;
        if(!_S247.hole_1)
        {
            _S251 = _S249 < 0.0;
        }
        else
        {
            _S251 = false;
        }
        if(_S251)
        {
            return false;
        }
        float _S252 = way_back_to_dip_0(previous_3, _S249, _S250, last_step_0, _S247);
        if(_S252 >= 0.0)
        {
            float last_step_1 = last_step_0 - _S252;
            distance_1 = distance_1 - _S252;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S253 = _S248 > (_S247.cell_max_0);
        PreviousSample_0 _S254 = after_sample_0(_S249, _S250, _S247, _S253);
        float last_step_2;
        if(_S253)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S244, _S247.side_x_0, _S247.side_y_0), _S243);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S244, _S247, _S249, _S250);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S254;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S255, SearchQuality_0 _S256, float _S257, float _S258, vec3 _S259, bool _S260)
{
    if(!sample_at_0(_S255, _S257, _S258, _S260).shown_3.hole_0)
    {
        return false;
    }
    vec3 _S261 = vec3(_S257, _S258, 0.0);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S262;
        if(side_0 < 2U)
        {
            _S262 = passes_0;
        }
        else
        {
            _S262 = false;
        }
        if(_S262)
        {
        }
        else
        {
            break;
        }
        vec3 _S263;
        if(side_0 == 0U)
        {
            _S263 = _S259;
        }
        else
        {
            _S263 = vec3(- _S259.x, - _S259.y, _S259.z);
        }
        bool _S264 = is_free_0(_S255, _S256, _S261, _S263, _S260 != (side_0 == 1U), fabrics_0._data[uint(_S255)].height_high_0);
        uint _S265 = side_0 + 1U;
        passes_0 = _S264;
        side_0 = _S265;
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

float max_height_along_0(uint _S266, float _S267, float _S268, float _S269, vec3 _S270, bool _S271)
{
    uint _S272 = locate_0(fabrics_0._data[uint(_S266)].warp_0, _S267).thread_1 / 2U;
    uint _S273 = locate_0(fabrics_0._data[uint(_S266)].weft_0, _S268).thread_1 / 2U;
    float _S274 = _S270.x;
    uint _S275;
    if(_S274 > 0.0)
    {
        _S275 = 1U;
    }
    else
    {
        _S275 = 0U;
    }
    float _S276 = _S270.y;
    uint _S277;
    if(_S276 > 0.0)
    {
        _S277 = 2U;
    }
    else
    {
        _S277 = 0U;
    }
    uint _S278 = words_0._data[uint(fabrics_0._data[uint(_S266)].max_heights_0 + 4U * (_S273 * fabrics_0._data[uint(_S266)].max_height_columns_0 + _S272) + (_S275 + _S277))];
    int number_0;
    if(_S271)
    {
        number_0 = 4;
    }
    else
    {
        number_0 = 0;
    }
    uint _S279 = _S278 >> number_0;
    float _S280 = max(abs(_S274) * fabrics_0._data[uint(_S266)].threads_per_x_0, abs(_S276) * fabrics_0._data[uint(_S266)].threads_per_y_0) / _S270.z;
    float _S281 = fabrics_0._data[uint(_S266)].height_high_0;
    float max_height_0 = fabrics_0._data[uint(_S266)].height_high_0;
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
        if(((max_height_0 - _S269) * _S280) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S279 >> uint(8 * number_0)) & 15U) * 0.06666667014360428 * _S281);
        }
        number_0 = number_0 - 1;
    }
    return max_height_0;
}

vec3 cell_bounds_0(uint _S282, float _S283, float _S284, bool _S285, bool _S286, bool _S287)
{
    Crossing_0 _S288 = crossing_at_0(_S282, _S283, _S284, _S285);
    float _S289 = cell_maximum_0(_S282, _S288);
    float _S290;
    if(_S286)
    {
        _S290 = _S288.warp_1.above_0;
    }
    else
    {
        _S290 = _S288.warp_1.below_0;
    }
    float _S291;
    if(_S287)
    {
        _S291 = _S288.weft_1.above_0;
    }
    else
    {
        _S291 = _S288.weft_1.below_0;
    }
    return vec3(_S289, _S290, _S291);
}

float first_sample_height_0(uint _S292, ViewRay_0 _S293, StepControl_0 _S294, bool _S295)
{
    float _S296 = max_height_along_0(_S292, _S293.origin_0.x, _S293.origin_0.y, 0.0, vec3(_S293.slope_1, 1.0), _S295);
    uint count_2 = 0U;
    float height_7 = _S296;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        vec2 _S297 = ViewRay_at_0(_S293, height_7);
        vec3 _S298 = cell_bounds_0(_S292, _S297.x, _S297.y, _S295, _S294.right_0, _S294.up_0);
        float _S299 = height_7 - _S298.x;
        float _S300 = StepControl_to_cell_exit_0(_S294, _S298.y, _S298.z);
        float height_8 = height_7 - clamp(_S299, 0.0, _S300);
        if(_S299 <= _S300)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S301, ViewRay_0 _S302, StepControl_0 _S303, bool _S304)
{
    float _S305 = fabrics_0._data[uint(_S301)].height_low_0 - (fabrics_0._data[uint(_S301)].height_high_0 - fabrics_0._data[uint(_S301)].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_6 = first_sample_height_0(_S301, _S302, _S303, _S304);
    end_1.last_step_3 = _S303.epsilon_0;
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
        vec2 _S306 = ViewRay_at_0(_S302, end_1.height_6);
        Probe_0 _S307 = probe_0(_S301, _S306.x, _S306.y, _S304, _S303.right_0, _S303.up_0);
        float _S308 = end_1.height_6 - _S307.height_1;
        float _S309 = ViewRay_rate_0(_S302, _S307);
        end_1.depth_1 = - _S308;
        end_1.rate_4 = _S309;
        bool _S310;
        if(end_1.previous_4.known_0)
        {
            _S310 = !_S307.hole_1;
        }
        else
        {
            _S310 = false;
        }
        bool _S311;
        if(_S310)
        {
            _S311 = (end_1.previous_4.yarn_0) == (_S307.yarn_1);
        }
        else
        {
            _S311 = false;
        }
        end_1.smooth_0 = _S311;
        bool _S312;
        if(!_S307.hole_1)
        {
            _S312 = _S308 <= 0.0;
        }
        else
        {
            _S312 = false;
        }
        bool _S313;
        if(_S312)
        {
            _S313 = true;
        }
        else
        {
            _S313 = (end_1.height_6) <= _S305;
        }
        if(_S313)
        {
            break;
        }
        float _S314 = way_back_to_dip_0(end_1.previous_4, _S308, _S309, end_1.last_step_3, _S307);
        if(_S314 >= 0.0)
        {
            end_1.height_6 = end_1.height_6 + _S314;
            end_1.last_step_3 = end_1.last_step_3 - _S314;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S315 = min(StepControl_to_cell_exit_0(_S303, _S307.side_x_0, _S307.side_y_0), end_1.height_6 - _S307.cell_max_0);
        float _S316 = StepControl_to_next_sample_0(_S303, _S307, _S308, _S309);
        end_1.previous_4 = after_sample_0(_S308, _S309, _S307, _S315 > _S316);
        float _S317 = max(_S315, _S316);
        end_1.last_step_3 = _S317;
        end_1.height_6 = end_1.height_6 - _S317;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S318, ViewRay_0 _S319, StepControl_0 _S320, bool _S321, ViewRayEnd_0 _S322, uint _S323)
{
    float _S324 = fabrics_0._data[uint(_S318)].height_high_0 - fabrics_0._data[uint(_S318)].height_low_0;
    float above_2 = _S322.height_6 + _S322.last_step_3;
    float above_gap_1 = clamp(_S322.previous_4.clearance_0, 0.0, _S324);
    float under_gap_1 = clamp(_S322.depth_1, 0.0, _S324);
    float _S325 = cubic_root_0(above_gap_1, - under_gap_1, _S322.previous_4.rate_0 * _S322.last_step_3, _S322.rate_4 * _S322.last_step_3);
    float middle_0;
    if(_S322.smooth_0)
    {
        middle_0 = above_2 - _S325 * _S322.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S322.height_6, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S322.height_6;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S323)
        {
        }
        else
        {
            break;
        }
        vec2 _S326 = ViewRay_at_0(_S319, middle_0);
        Probe_0 _S327 = probe_0(_S318, _S326.x, _S326.y, _S321, _S320.right_0, _S320.up_0);
        float _S328;
        if(_S327.hole_1)
        {
            _S328 = -1.0e+09;
        }
        else
        {
            _S328 = _S327.height_1;
        }
        float _S329 = clamp(middle_0 - _S328, - _S324, _S324);
        float _S330;
        if(_S329 <= 0.0)
        {
            if(side_1 > 0.0)
            {
                _S330 = 0.5 * above_gap_2;
            }
            else
            {
                _S330 = above_gap_2;
            }
            float _S331 = - _S329;
            under_1 = middle_0;
            above_gap_2 = _S330;
            under_gap_2 = _S331;
            side_1 = 1.0;
        }
        else
        {
            if(side_1 < 0.0)
            {
                _S330 = 0.5 * under_gap_2;
            }
            else
            {
                _S330 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S329;
            under_gap_2 = _S330;
            side_1 = -1.0;
        }
        if(_S322.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S329 / min(ViewRay_rate_0(_S319, _S327), -9.99999997475242708e-07), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S322.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S332, SearchQuality_0 _S333, float _S334, float _S335, vec3 _S336, bool _S337)
{
    float _S338 = max(_S336.z, 0.00009999999747379);
    ViewRay_0 ray_0;
    ray_0.origin_0 = vec2(_S334, _S335);
    vec2 _S339 = _S336.xy / _S338;
    ray_0.slope_1 = _S339;
    StepControl_0 _S340 = step_control_0(- _S339, 1.0 / max(steps_per_length_0(_S332, _S333, _S336) / _S338, 9.99999971718068537e-10));
    ViewRayEnd_0 _S341 = search_down_0(_S332, ray_0, _S340, _S337);
    Hit_0 hit_0;
    hit_0.hole_3 = false;
    float _S342 = refined_height_0(_S332, ray_0, _S340, _S337, _S341, _S333.refinements_0);
    hit_0.height_4 = _S342;
    vec2 _S343 = ViewRay_at_0(ray_0, _S342);
    hit_0.x_10 = _S343.x;
    hit_0.y_6 = _S343.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S344, SearchQuality_0 _S345, float _S346, float _S347, vec3 _S348, bool _S349)
{
    if(!passes_through_0(_S344, _S345, _S346, _S347, _S348, _S349))
    {
        return first_hit_of_yarn_0(_S344, _S345, _S346, _S347, _S348, _S349);
    }
    Hit_0 hit_1;
    hit_1.x_10 = _S346;
    hit_1.y_6 = _S347;
    hit_1.height_4 = 0.0;
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
    vec3 normal_5;
    vec3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S350, float _S351, float _S352, bool _S353)
{
    Sample_0 _S354 = sample_at_0(_S350, _S351, _S352, _S353);
    float _S355;
    if(_S354.shown_3.is_warp_0)
    {
        _S355 = _S354.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S355 = _S354.crossing_1.weft_1.half_width_1;
    }
    uint _S356;
    if(_S354.shown_3.is_warp_0)
    {
        _S356 = fabrics_0._data[uint(_S350)].warp_0;
    }
    else
    {
        _S356 = fabrics_0._data[uint(_S350)].weft_0;
    }
    Family_0 _S357 = families_0._data[uint(_S356)];
    float _S358;
    if(_S353)
    {
        _S358 = -1.0;
    }
    else
    {
        _S358 = 1.0;
    }
    float _S359 = _S357.twist_sine_0 * _S358;
    Family_0 _S360 = families_0._data[uint(_S356)];
    if(_S354.shown_3.is_warp_0)
    {
        _S358 = 1.0;
    }
    else
    {
        _S358 = -1.0;
    }
    vec2 _S361 = fibre_direction_0(_S354.slope_across_0, _S358 * _S354.slope_along_0, _S359, _S360.twist_cosine_0);
    float _S362;
    if(_S354.shown_3.is_warp_0)
    {
        _S362 = _S354.slope_x_1;
    }
    else
    {
        _S362 = _S354.slope_y_1;
    }
    float _S363;
    if(_S354.shown_3.is_warp_0)
    {
        _S363 = _S354.slope_y_1;
    }
    else
    {
        _S363 = _S354.slope_x_1;
    }
    float _S364 = _S361.x;
    float _S365 = _S361.y;
    float _S366 = _S362 * _S364 + _S358 * _S363 * _S365;
    float _S367 = _S355 * 1.0154266357421875;
    float _S368 = _S367 * arc_sine_0(clamp(_S354.section_1.across_1 / _S367, -1.0, 1.0));
    if(_S354.shown_3.is_warp_0)
    {
        _S355 = _S352;
    }
    else
    {
        _S355 = - _S351;
    }
    SurfacePoint_0 point_2;
    point_2.hole_4 = _S354.shown_3.hole_0;
    point_2.is_warp_2 = _S354.shown_3.is_warp_0;
    point_2.warp_thread_0 = _S354.crossing_1.warp_1.thread_1;
    point_2.weft_thread_0 = _S354.crossing_1.weft_1.thread_1;
    point_2.height_9 = _S354.height_5;
    point_2.normal_5 = normalize(vec3(- _S354.slope_x_1, - _S354.slope_y_1, 1.0));
    vec3 _S369;
    if(_S354.shown_3.is_warp_0)
    {
        _S369 = vec3(_S364, _S365, _S366);
    }
    else
    {
        _S369 = vec3(- _S365, _S364, _S366);
    }
    point_2.tangent_5 = normalize(_S369);
    point_2.across_2 = _S354.section_1.across_1;
    point_2.fibre_across_0 = _S368 * _S360.twist_cosine_0 + _S355 * _S359;
    point_2.fibre_along_0 = _S355 * _S360.twist_cosine_0 - _S368 * _S359;
    return point_2;
}

Albedos_0 vary_albedos_0(uint _S370, Albedos_0 _S371, uint _S372, uint _S373)
{
    vec3 _S374 = max(_S371.specular_reflect_0, _S371.specular_transmit_0);
    vec3 _S375 = _S371.diffuse_reflect_0 + _S371.diffuse_transmit_0;
    float _S376 = bounded_gain_0(thread_gain_0(_S372, fabrics_0._data[uint(_S370)].colour_noise_0, fabrics_0._data[uint(_S370)].seed_0), _S375, 1.0 - fabrics_0._data[uint(_S370)].layer_bound_0 * _S374);
    float _S377 = bounded_gain_0(fibre_gain_0(_S372, _S373, fabrics_0._data[uint(_S370)].fibre_noise_0, fabrics_0._data[uint(_S370)].seed_0), _S374, min((1.0 - _S376 * _S375) / fabrics_0._data[uint(_S370)].layer_bound_0, vec3(1.0)));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S376 * _S371.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S376 * _S371.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S377 * _S371.specular_reflect_0;
    varied_0.specular_transmit_0 = _S377 * _S371.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S378, SurfacePoint_0 _S379, Albedos_0 _S380, float _S381, float _S382)
{
    float _S383;
    if(_S379.is_warp_2)
    {
        _S383 = _S381;
    }
    else
    {
        _S383 = _S382;
    }
    float _S384 = _S383 - _S379.across_2;
    uint _S385;
    if(_S379.is_warp_2)
    {
        _S385 = fabrics_0._data[uint(_S378)].warp_0;
    }
    else
    {
        _S385 = fabrics_0._data[uint(_S378)].weft_0;
    }
    Family_0 _S386 = families_0._data[uint(_S385)];
    int _S387 = int(families_0._data[uint(_S385)].count_0);
    if(_S379.is_warp_2)
    {
        _S385 = _S379.warp_thread_0;
    }
    else
    {
        _S385 = _S379.weft_thread_0;
    }
    uint _S388 = uint(int(floor(_S384 / _S386.period_0)) * _S387 + int(_S385)) * 2U;
    if(_S379.is_warp_2)
    {
        _S385 = 1U;
    }
    else
    {
        _S385 = 0U;
    }
    float _S389 = floor(_S379.fibre_across_0 / fabrics_0._data[uint(_S378)].fibre_size_0);
    return vary_albedos_0(_S378, _S380, _S388 + _S385, uint(int(_S389)) * 65536U + uint(int(floor(_S379.fibre_along_0 / (fabrics_0._data[uint(_S378)].fibre_size_0 * 40.0) + 0.61799997091293335 * _S389))));
}

YarnPoint_0 yarn_point_of_0(uint _S390, SurfacePoint_0 _S391, float _S392, float _S393, bool _S394, bool _S395)
{
    uint _S396;
    if(_S391.is_warp_2)
    {
        _S396 = fabrics_0._data[uint(_S390)].warp_0;
    }
    else
    {
        _S396 = fabrics_0._data[uint(_S390)].weft_0;
    }
    uint _S397;
    if(_S391.is_warp_2)
    {
        _S397 = _S391.warp_thread_0;
    }
    else
    {
        _S397 = _S391.weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S396, _S397);
    bool _S398;
    if((fabrics_0._data[uint(_S390)].fibre_noise_0) > 0.0)
    {
        _S398 = true;
    }
    else
    {
        _S398 = (fabrics_0._data[uint(_S390)].colour_noise_0) > 0.0;
    }
    Albedos_0 albedos_3;
    if(_S398)
    {
        albedos_3 = varied_at_0(_S390, _S391, albedos_2, _S392, _S393);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_3;
    point_3.back_2 = _S394;
    point_3.hole_2 = _S395;
    point_3.is_warp_1 = _S391.is_warp_2;
    point_3.x_9 = _S392;
    point_3.y_5 = _S393;
    point_3.height_3 = _S391.height_9;
    point_3.normal_4 = _S391.normal_5;
    point_3.tangent_4 = _S391.tangent_5;
    point_3.roughness_8 = families_0._data[uint(_S396)].roughness_0;
    point_3.albedos_1 = albedos_3;
    return point_3;
}

YarnPoint_0 locate_yarn_0(uint _S399, SearchQuality_0 _S400, float _S401, float _S402, vec3 _S403)
{
    bool _S404 = (_S403.z) < 0.0;
    Hit_0 _S405 = first_hit_0(_S399, _S400, _S401, _S402, to_face_frame_0(_S403, _S404), _S404);
    return yarn_point_of_0(_S399, surface_at_0(_S399, _S405.x_10, _S405.y_6, _S404), _S405.x_10, _S405.y_6, _S404, _S405.hole_3);
}

vec3 scattered_0(uint _S406, YarnPoint_0 _S407, vec3 _S408, vec3 _S409)
{
    const vec3 _S410 = vec3(0.0);
    bool _S411 = !_S407.hole_2;
    bool _S412;
    if(_S411)
    {
        _S412 = (_S408.z) > 0.0;
    }
    else
    {
        _S412 = false;
    }
    vec3 value_1;
    if(_S412)
    {
        value_1 = _S407.albedos_1.diffuse_reflect_0 * diffuse_reflection_0(_S408, _S407.normal_4, fabrics_0._data[uint(_S406)].diffuse_blend_0) + _S407.albedos_1.specular_reflect_0 * reflection_0(_S408, _S409, _S407.normal_4, _S407.tangent_4, _S407.roughness_8, fabrics_0._data[uint(_S406)].optical_depth_0);
    }
    else
    {
        if(_S411)
        {
            _S412 = (_S408.z) < 0.0;
        }
        else
        {
            _S412 = false;
        }
        if(_S412)
        {
            value_1 = _S407.albedos_1.diffuse_transmit_0 * diffuse_reflection_0(- _S408, _S407.normal_4, fabrics_0._data[uint(_S406)].diffuse_blend_0) + _S407.albedos_1.specular_transmit_0 * transmission_0(_S408, _S409, _S407.normal_4, _S407.tangent_4, _S407.roughness_8, fabrics_0._data[uint(_S406)].optical_depth_0);
        }
        else
        {
            value_1 = _S410;
        }
    }
    float _S413 = fabrics_0._data[uint(_S406)].sheen_strength_0;
    if((fabrics_0._data[uint(_S406)].sheen_strength_0) <= 0.0)
    {
        return value_1;
    }
    vec2 _S414 = sheen_with_transmittance_0(_S408, _S409, _S413, fabrics_0._data[uint(_S406)].sheen_roughness_0);
    return _S414.y * value_1 + _S414.x;
}

bool unoccluded_0(uint _S415, SearchQuality_0 _S416, float _S417, float _S418, float _S419, vec3 _S420, bool _S421)
{
    if((_S420.z) <= 0.0)
    {
        return false;
    }
    return is_free_0(_S415, _S416, vec3(_S417, _S418, _S419 + fabrics_0._data[uint(_S415)].lift_0), _S420, _S421, max_height_along_0(_S415, _S417, _S418, _S419, _S420, _S421));
}

bool is_lit_0(uint _S422, SearchQuality_0 _S423, YarnPoint_0 _S424, vec3 _S425)
{
    if(_S424.hole_2)
    {
        return true;
    }
    vec3 _S426 = to_face_frame_0(_S425, _S424.back_2);
    float _S427 = _S426.z;
    bool _S428 = _S427 < 0.0;
    vec3 normal_6;
    float height_10;
    if(_S428)
    {
        SurfacePoint_0 _S429 = surface_at_0(_S422, _S424.x_9, _S424.y_5, !_S424.back_2);
        normal_6 = _S429.normal_5;
        height_10 = _S429.height_9;
    }
    else
    {
        normal_6 = _S424.normal_4;
        height_10 = _S424.height_3;
    }
    vec3 _S430 = vec3(_S426.xy, abs(_S427));
    if((dot(normal_6, _S430)) <= 0.0)
    {
        return false;
    }
    return unoccluded_0(_S422, _S423, _S424.x_9, _S424.y_5, height_10, _S430, (_S424.back_2) != _S428);
}

vec3 evaluate_0(uint _S431, SearchQuality_0 _S432, YarnPoint_0 _S433, vec3 _S434, vec3 _S435)
{
    vec3 _S436 = scattered_0(_S431, _S433, to_face_frame_0(_S434, _S433.back_2), to_face_frame_0(_S435, _S433.back_2));
    bool _S437;
    if((max(_S436.x, max(_S436.y, _S436.z))) <= 0.0)
    {
        _S437 = true;
    }
    else
    {
        _S437 = !is_lit_0(_S431, _S432, _S433, _S434);
    }
    if(_S437)
    {
        return vec3(0.0);
    }
    return _S436;
}

float straight_through_0(uint _S438, YarnPoint_0 _S439, vec3 _S440)
{
    if(!_S439.hole_2)
    {
        return 0.0;
    }
    float _S441 = fabrics_0._data[uint(_S438)].sheen_strength_0;
    if((fabrics_0._data[uint(_S438)].sheen_strength_0) <= 0.0)
    {
        return 1.0;
    }
    return 1.0 - _S441 * sheen_lobe_0(abs(_S440.z), fabrics_0._data[uint(_S438)].sheen_roughness_0).z;
}

vec4 light_of_point_0(Frame_0 _S442, uint _S443, VisiblePoint_0 _S444, vec2 _S445)
{
    SearchQuality_0 _S446 = default_quality_0();
    vec3 _S447 = to_local_0(_S444, _S444.view_0);
    YarnPoint_0 _S448 = locate_yarn_0(_S443, _S446, _S445.x, _S445.y, _S447);
    const vec3 _S449 = vec3(0.0);
    uint number_1 = 0U;
    vec3 radiance_1 = _S449;
    for(;;)
    {
        if(number_1 < (_S442.lights_0))
        {
        }
        else
        {
            break;
        }
        vec3 irradiance_2;
        vec3 _S450 = towards_light_0(lights_1._data[uint(number_1)], _S444.position_0, irradiance_2);
        vec3 radiance_2 = radiance_1 + irradiance_2 * evaluate_0(_S443, _S446, _S448, to_local_0(_S444, _S450), _S447);
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    return vec4(radiance_1, 1.0 - straight_through_0(_S443, _S448, _S447));
}

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
void main()
{
    uint _S451;
    Frame_0 _S452 = frames_0._data[uint(0)];
    bool _S453;
    if((gl_GlobalInvocationID.x) >= (_S452.width_0))
    {
        _S453 = true;
    }
    else
    {
        _S453 = (gl_GlobalInvocationID.y) >= (_S452.height_0);
    }
    if(_S453)
    {
        return;
    }
    uvec2 _S454 = gl_GlobalInvocationID.xy;
    ivec3 _S455 = ivec3(ivec2(_S454), 0);
    uint _S456 = (texelFetch((visible_faces_0), ((_S455)).xy, ((_S455)).z).x);
    const vec4 _S457 = vec4(0.0);
    vec4 sum_0;
    if(_S456 > 0U)
    {
        uint _S458 = _S456 - 1U;
        uint _S459 = face_fabrics_0._data[uint(_S458)];
        VisiblePoint_0 _S460 = visible_point_0(_S452, _S459, _S458, _S454);
        uint k_0 = 0U;
        sum_0 = _S457;
        for(;;)
        {
            _S451 = _S452.samples_0;
            if(k_0 < (_S452.samples_0))
            {
            }
            else
            {
                break;
            }
            vec2 _S461 = footprint_sample_0(_S454, _S452.pass_number_0 * _S452.samples_0 + k_0);
            vec4 sum_1 = sum_0 + light_of_point_0(_S452, _S459, _S460, _S460.draft_0 + _S461.x * _S460.draft_dx_0 + _S461.y * _S460.draft_dy_0);
            k_0 = k_0 + 1U;
            sum_0 = sum_1;
        }
        sum_0 = sum_0 / float(_S451);
    }
    else
    {
        sum_0 = _S457;
    }
    accumulate_0(_S452, _S454, sum_0);
    return;
}

