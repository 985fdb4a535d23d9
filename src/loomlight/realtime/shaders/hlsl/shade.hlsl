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

Texture2D<uint > visible_faces_0 : register(t8);

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

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    uint run_words_0;
    uint ends_0;
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

float3 camera_right_0(Frame_0 frame_0)
{
    return float3(frame_0.right_x_0, frame_0.right_y_0, frame_0.right_z_0);
}

float3 camera_up_0(Frame_0 frame_1)
{
    return float3(frame_1.up_x_0, frame_1.up_y_0, frame_1.up_z_0);
}

float3 camera_forward_0(Frame_0 frame_2)
{
    return float3(frame_2.forward_x_0, frame_2.forward_y_0, frame_2.forward_z_0);
}

float3 camera_origin_0(Frame_0 frame_3)
{
    return float3(frame_3.origin_x_0, frame_3.origin_y_0, frame_3.origin_z_0);
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

float2 footprint_sample_0(uint2 pixel_0, uint index_0)
{
    uint _S3 = pixel_0.x;
    uint _S4 = pixel_0.y;
    return frac(float2(uniform_hash_0(_S3, _S4, 1U), uniform_hash_0(_S3, _S4, 2U)) + float(index_0 & 65535U) * float2(0.75487768650054932f, 0.56984031200408936f)) - 0.5f;
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
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(VisiblePoint_0 point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

float3 to_face_frame_0(float3 direction_1, bool back_0)
{
    float2 _S5 = direction_1.xy;
    float _S6;
    if(back_0)
    {
        _S6 = - direction_1.z;
    }
    else
    {
        _S6 = direction_1.z;
    }
    return float3(_S5, _S6);
}

float2 turns_and_remainder_0(uint family_0, float index_1)
{
    float _S7 = floor(mad(index_1, families_0.Load(family_0).inverse_count_0, families_0.Load(family_0).half_inverse_count_0));
    return float2(_S7, mad(- _S7, families_0.Load(family_0).count_0, index_1));
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
    float _S8 = floor(position_1 * families_0.Load(family_1).inverse_size_0);
    Cell_0 cell_1;
    float _S9 = mad(- _S8, families_0.Load(family_1).size_0, position_1);
    cell_1.below_0 = _S9;
    cell_1.above_0 = families_0.Load(family_1).size_0 - _S9;
    cell_1.across_0 = _S9 - 0.5f * families_0.Load(family_1).size_0;
    cell_1.half_width_1 = families_0.Load(family_1).half_width_0;
    cell_1.thread_1 = uint(clamp(turns_and_remainder_0(family_1, _S8).y, 0.0f, families_0.Load(family_1).count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_2)
{
    return asfloat(words_0.Load(index_2));
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0.Load(family_2).start_0) * families_0.Load(family_2).inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S10 = turns_1 * families_0.Load(family_2).period_0;
    uint thread_2 = words_0.Load(families_0.Load(family_2).first_thread_table_0 + uint(clamp(turns_1 * families_0.Load(family_2).bins_0, 0.0f, families_0.Load(family_2).bins_0 - 1.0f)));
    uint _S11;
    if(_S10 >= (table_number_0(families_0.Load(family_2).place_table_0 + thread_2 * 4U + 1U)))
    {
        _S11 = 1U;
    }
    else
    {
        _S11 = 0U;
    }
    uint _S12 = min(thread_2 + _S11, uint(families_0.Load(family_2).count_0) - 1U);
    uint _S13 = families_0.Load(family_2).place_table_0 + _S12 * 4U;
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
    float2 _S20 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0));
    return mad(_S20.x, families_0.Load(family_4).period_0, table_number_0(families_0.Load(family_4).place_table_0 + uint(_S20.y) * 4U));
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
    Family_0 _S21 = families_0.Load(family_6);
    uint _S22;
    if((families_0.Load(family_6).is_alike_0) != 0U)
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
    int _S24 = int((word_1 >> int(1)) & 127U);
    int _S25 = int((word_1 >> int(8)) & 127U);
    int _S26 = int((word_1 >> int(15)) & 63U);
    int _S27 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    int _S28 = - _S24;
    float _S29 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S28, int(0));
    run_0.from_start_0 = _S29;
    int _S30 = _S25 + int(1);
    float _S31 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, int(1), _S30);
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
        _S35 = 1.0e+06f;
    }
    else
    {
        _S35 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S35;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S33, _S34), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S24 == int(0);
    run_0.last_crossing_0 = _S25 == int(0);
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
    float _S36 = cell_4.half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S37 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S37;
    float _S38 = _S36 * _S36 - square_1(_S37);
    float _S39 = rsqrt(_S38);
    section_0.drop_0 = _S36 - _S38 * _S39;
    section_0.slope_0 = - _S37 * _S39;
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
        _S42 = 0.0f;
    }
    else
    {
        _S42 = families_0.Load(other_1).height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, int(0));
    }
    float _S45;
    if((shown_1.on_top_0) != _S44)
    {
        _S45 = 0.0f;
    }
    else
    {
        Family_0 _S46 = families_0.Load(other_1);
        int _S47;
        if(_S40)
        {
            _S47 = int(-1);
        }
        else
        {
            _S47 = int(1);
        }
        _S45 = _S46.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S47);
    }
    float _S48 = 1.0f / max(2.0f * _S43, 9.999999960041972e-13f);
    float _S49 = clamp((_S43 - _S41) * _S48, 0.0f, 1.0f);
    float _S50 = _S42 + (_S45 - _S42) * (_S49 * _S49 * (3.0f - 2.0f * _S49));
    float _S51 = (_S42 - _S45) * (6.0f * _S49 * (1.0f - _S49) * _S48);
    if(_S40)
    {
        _S42 = 1.0f;
    }
    else
    {
        _S42 = -1.0f;
    }
    return float2(_S50, _S51 * _S42);
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
    float _S52 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S52), 9.99999971718068537e-10f);
    float _S53 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S53), 9.99999971718068537e-10f);
    control_0.right_0 = _S52 > 0.0f;
    control_0.up_0 = _S53 > 0.0f;
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
        _S54 = 2.0f * _S55 + _S54 - cell_5.half_width_1;
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
        _S66 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S66)
    {
        _S66 = true;
    }
    else
    {
        _S66 = rate_1 <= 0.0f;
    }
    if(_S66)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S64) >= 0.0f)
    {
        _S66 = (3.0f * clearance_1 - _S65) >= 0.0f;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        return -1.0f;
    }
    float _S67 = clearance_1 - previous_1.clearance_0;
    float _S68 = 6.0f * _S67 - 4.0f * _S64 - 2.0f * _S65;
    float _S69 = -2.0f * _S64 / max(_S68 + sqrt(max(_S68 * _S68 - 4.0f * (3.0f * (_S64 + _S65 - 2.0f * _S67)) * _S64, 0.0f)), 9.99999968265522539e-21f);
    float _S70 = 1.0f - _S69;
    float _S71 = (previous_1.clearance_0 * (2.0f * _S69 + 1.0f) + _S64 * _S69) * _S70 * _S70;
    float _S72 = (clearance_1 * (2.0f * _S70 + 1.0f) - _S65 * _S70) * _S69 * _S69;
    if(_S69 > 0.01999999955296516f)
    {
        _S66 = _S70 > 0.01999999955296516f;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        _S66 = (_S71 + _S72) < 0.0f;
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
        _S73 = -1.0f;
    }
    return _S73;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S74;
    if(here_1.hole_1)
    {
        _S74 = 1.0e+09f;
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
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_1, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S76 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    bool _S77;
    if(!here_2.hole_1)
    {
        _S77 = (rate_3 * _S76 + clearance_3) < 0.0f;
    }
    else
    {
        _S77 = false;
    }
    if(_S77)
    {
        _S77 = _S76 > (2.0f * this_1.epsilon_0);
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
        _S78 = max(_S76, 0.0f) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S78);
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
    float _S79 = end_0 - start_1;
    float _S80 = start_rate_0 + end_rate_0 - 2.0f * _S79;
    float _S81 = 3.0f * _S79 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S79, 9.99999968265522539e-21f);
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
        float _S82 = clamp(share_0 - (((_S80 * share_0 + _S81) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S80 * share_0 + 2.0f * _S81) * share_0 + start_rate_0, 0.10000000149011612f * _S79 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S83 = i_0 + int(1);
        share_0 = _S82;
        i_0 = _S83;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S84 = along_slope_0 * along_slope_0 + 1.0f;
    float _S85 = rsqrt(_S84);
    float _S86 = sine_1 * _S85 * rsqrt(_S84 + across_slope_0 * across_slope_0);
    return float2(- _S86 * _S84, _S86 * across_slope_0 * along_slope_0 + cosine_0 * _S85);
}

float arc_sine_0(float x_3)
{
    float _S87 = abs(x_3);
    bool _S88 = _S87 > 0.5f;
    float _S89;
    if(_S88)
    {
        _S89 = 0.5f * (1.0f - _S87);
    }
    else
    {
        _S89 = _S87 * _S87;
    }
    float _S90;
    if(_S88)
    {
        _S90 = sqrt(max(_S89, 0.0f));
    }
    else
    {
        _S90 = _S87;
    }
    float _S91 = ((((0.04216320067644119f * _S89 + 0.02418131195008755f) * _S89 + 0.04547002539038658f) * _S89 + 0.07495300471782684f) * _S89 + 0.16666752099990845f) * _S89 * _S90 + _S90;
    if(_S88)
    {
        _S89 = 1.57079637050628662f - 2.0f * _S91;
    }
    else
    {
        _S89 = _S91;
    }
    if(x_3 < 0.0f)
    {
        _S89 = - _S89;
    }
    return _S89;
}

float3 table_colour_0(uint index_3)
{
    return float3(table_number_0(index_3), table_number_0(index_3 + 1U), table_number_0(index_3 + 2U));
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 albedos_of_0(uint family_8, uint thread_8)
{
    uint _S92 = families_0.Load(family_8).albedo_table_0 + families_0.Load(family_8).albedo_stride_0 * thread_8;
    Albedos_0 albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(_S92);
    albedos_0.diffuse_transmit_0 = table_colour_0(_S92 + 3U);
    albedos_0.specular_reflect_0 = table_colour_0(_S92 + 6U);
    albedos_0.specular_transmit_0 = table_colour_0(_S92 + 9U);
    return albedos_0;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S93 = room_0 / max(albedo_0, (float3)9.99999997475242708e-07f);
    return min(gain_1, max(min(min(_S93.x, _S93.y), _S93.z), 0.0f));
}

float natural_logarithm_0(float x_4)
{
    uint _S94 = asuint(x_4);
    float exponent_0 = float(int(_S94 >> int(23)) - int(126));
    float m_0 = asfloat((_S94 & 8388607U) | 1056964608U);
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
    float _S95 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S95 - exponent_1 * 0.00021219444170129f - 0.5f * _S95) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float3 towards_light_0(Light_0 light_0, float3 position_4, out float3 irradiance_1)
{
    irradiance_1 = float3(light_0.red_0, light_0.green_0, light_0.blue_0);
    float3 _S96 = float3(light_0.x_1, light_0.y_1, light_0.z_1);
    if((light_0.is_point_0) == 0U)
    {
        return _S96;
    }
    float3 _S97 = _S96 - position_4;
    irradiance_1 = irradiance_1 / max(square_0(_S97), 9.999999960041972e-13f);
    return normalize(_S97);
}

float diffuse_reflection_0(float3 light_1, float3 normal_1, float blend_0)
{
    float _S98 = light_1.z;
    if(_S98 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp(max(_S98, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_0);
}

float projected_area_1(float3 direction_3, float3 tangent_0, float roughness_1)
{
    float _S99 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S99 * _S99 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S100 = clamp(x_5, -87.0f, 88.0f);
    float _S101 = floor(_S100 * 1.4426950216293335f + 0.5f);
    float _S102 = _S100 - _S101 * 0.693359375f + _S101 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S102 + 0.00139819993637502f) * _S102 + 0.00833345204591751f) * _S102 + 0.04166579619050026f) * _S102 + 0.1666666567325592f) * _S102 + 0.5f;
    float _S103 = asfloat(uint(int(_S101) + int(127)) << int(23));
    float _S104;
    if(x_5 < -87.0f)
    {
        _S104 = 0.0f;
    }
    else
    {
        _S104 = (p_0 * _S102 * _S102 + _S102 + 1.0f) * _S103;
    }
    return _S104;
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
    float _S105 = roughness_2 * roughness_2;
    float _S106 = squared_along_0 * (1.0f - _S105) + _S105;
    return 0.31830987334251404f * _S105 * roughness_2 / (_S106 * _S106);
}

float density_between_0(float3 light_2, float3 view_1, float3 tangent_1, float roughness_3)
{
    float3 _S107 = light_2 + view_1;
    float _S108 = dot(_S107, tangent_1);
    return flake_density_0(min(_S108 * _S108 / max(square_0(_S107), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_2, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S109 = dot(light_3, normal_2);
    bool _S110;
    if(_S109 <= 0.0f)
    {
        _S110 = true;
    }
    else
    {
        _S110 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S110)
    {
        return 0.0f;
    }
    float _S111 = max(_S109, 9.99999997475242708e-07f);
    float _S112 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    float _S113 = projected_area_1(light_3, tangent_2, roughness_4) * _S112 + projected_area_1(view_2, tangent_2, roughness_4) * _S111;
    float _S114 = optical_depth_1 * _S113 / (_S111 * _S112);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S114 * mean_attenuation_0(_S114)) * _S111 / _S113;
}

float transmission_0(float3 light_4, float3 view_3, float3 normal_3, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S115 = - dot(light_4, normal_3);
    float _S116 = dot(view_3, normal_3);
    bool _S117;
    if(_S115 <= 0.0f)
    {
        _S117 = true;
    }
    else
    {
        _S117 = _S116 <= 0.0f;
    }
    if(_S117)
    {
        return 0.0f;
    }
    float _S118 = 1.0f / max(_S116, 9.99999997475242708e-07f);
    float _S119 = projected_area_1(light_4, tangent_3, roughness_5) / max(_S115, 9.99999997475242708e-07f);
    float _S120 = projected_area_1(view_3, tangent_3, roughness_5) * _S118;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S119, _S120)) * mean_attenuation_0(optical_depth_2 * abs(_S119 - _S120)) * _S118;
}

float sheen_scale_0(float x_6, float y_2)
{
    return (((((0.0f * x_6 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_6 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_6 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_6 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_6 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_6 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_7, float y_3)
{
    return ((((0.0f * x_7 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_7 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_7 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_7 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_7 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_8, float y_4)
{
    return ((((0.0f * x_8 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_8 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_8 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_8 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_8 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S121 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S122 = 2.0f * sqrt(_S121) - 1.0f;
    float _S123 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S122, _S123), 0.00999999977648258f, 1.0f), clamp((1.0f - _S121) * sheen_shear_0(_S122, _S123), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S122, _S123), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_5, float3 view_4, float scale_0, float shear_0)
{
    float _S124 = light_5.z;
    bool _S125;
    if(_S124 <= 0.0f)
    {
        _S125 = true;
    }
    else
    {
        _S125 = (view_4.z) <= 0.0f;
    }
    if(_S125)
    {
        return 0.0f;
    }
    float2 _S126 = view_4.xy;
    float _S127 = dot(_S126, _S126);
    float2 _S128;
    if(_S127 > 9.99999968265522539e-21f)
    {
        _S128 = _S126 * rsqrt(_S127);
    }
    else
    {
        _S128 = float2(1.0f, 0.0f);
    }
    float _S129 = scale_0 * dot(light_5.xy, _S128) + shear_0 * _S124;
    float _S130 = scale_0 * (light_5.y * _S128.x - light_5.x * _S128.y);
    float _S131 = _S129 * _S129 + _S130 * _S130 + _S124 * _S124;
    return 0.31830987334251404f * scale_0 * scale_0 * _S124 / max(_S131 * _S131, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_6, float3 view_5, float strength_0, float roughness_7)
{
    float3 _S132 = sheen_lobe_0(view_5.z, roughness_7);
    float _S133 = strength_0 * _S132.z;
    return float2(_S133 * transformed_cosine_0(light_6, view_5, _S132.x, _S132.y), 1.0f - _S133);
}

VisiblePoint_0 visible_point_0(Frame_0 _S134, uint _S135, uint _S136, uint2 _S137)
{
    uint _S138 = 3U * _S136;
    Vertex_0 _S139 = vertices_0.Load(corners_0.Load(_S138));
    Vertex_0 _S140 = vertices_0.Load(corners_0.Load(_S138 + 1U));
    Vertex_0 _S141 = vertices_0.Load(corners_0.Load(_S138 + 2U));
    float3 _S142 = position_of_0(_S139);
    float3 _S143 = position_of_0(_S140) - _S142;
    float3 _S144 = position_of_0(_S141) - _S142;
    float3 _S145 = cross(_S143, _S144);
    float _S146 = 1.0f / max(square_0(_S145), 1.00000000317107685e-30f);
    float _S147 = float(_S134.width_0);
    float3 _S148 = camera_right_0(_S134) * (2.0f / _S147);
    float _S149 = float(_S134.height_0);
    float3 _S150 = camera_up_0(_S134) * (-2.0f / _S149);
    float3 _S151 = camera_forward_0(_S134) + (float(_S137.x) + 0.5f - 0.5f * _S147) * _S148 + (float(_S137.y) + 0.5f - 0.5f * _S149) * _S150;
    float _S152 = dot(_S151, _S145);
    float _S153;
    if((abs(_S152)) > 1.00000000317107685e-30f)
    {
        _S153 = _S152;
    }
    else
    {
        _S153 = 1.00000000317107685e-30f;
    }
    float _S154 = 1.0f / _S153;
    float3 _S155 = _S142 - camera_origin_0(_S134);
    float _S156 = dot(_S155, _S145) * _S154;
    float3 _S157 = _S151 * _S156 - _S155;
    float3 _S158 = _S156 * (_S148 - _S151 * (dot(_S148, _S145) * _S154));
    float3 _S159 = _S156 * (_S150 - _S151 * (dot(_S150, _S145) * _S154));
    float3 _S160 = cross(_S144, _S145) * _S146;
    float3 _S161 = cross(_S145, _S143) * _S146;
    float _S162 = dot(_S157, _S160);
    float _S163 = dot(_S157, _S161);
    float _S164 = _S140.u_0 - _S139.u_0;
    float _S165 = _S140.v_0 - _S139.v_0;
    float2 _S166 = float2(_S164, _S165);
    float _S167 = _S141.u_0 - _S139.u_0;
    float _S168 = _S141.v_0 - _S139.v_0;
    float2 _S169 = float2(_S167, _S168);
    float2 _S170 = float2(_S139.u_0, _S139.v_0) + _S162 * _S166 + _S163 * _S169;
    float2 _S171 = dot(_S158, _S160) * _S166 + dot(_S158, _S161) * _S169;
    float2 _S172 = dot(_S159, _S160) * _S166 + dot(_S159, _S161) * _S169;
    if((_S164 * _S168 - _S165 * _S167) < 0.0f)
    {
        _S153 = -1.0f;
    }
    else
    {
        _S153 = 1.0f;
    }
    float3 _S173 = _S153 * (_S168 * _S143 - _S165 * _S144);
    float3 _S174 = _S153 * (_S164 * _S144 - _S167 * _S143);
    VisiblePoint_0 point_1;
    float3 _S175 = normalize((1.0f - _S162 - _S163) * normal_of_0(_S139) + _S162 * normal_of_0(_S140) + _S163 * normal_of_0(_S141));
    point_1.normal_0 = _S175;
    float3 _S176 = normalize(_S173 - _S175 * dot(_S175, _S173));
    point_1.axis_x_0 = _S176;
    point_1.axis_y_0 = cross(_S175, _S176);
    point_1.position_0 = _S142 + _S157;
    point_1.view_0 = - normalize(_S151);
    bool _S177 = (dot(cross(_S173, _S174), _S175)) < 0.0f;
    float _S178 = fabrics_0[_S135].uv_width_0;
    if(_S177)
    {
        _S153 = - fabrics_0[_S135].uv_height_0;
    }
    else
    {
        _S153 = fabrics_0[_S135].uv_height_0;
    }
    float2 _S179 = float2(_S178, _S153);
    float2 _S180 = _S170 * _S179;
    if(_S177)
    {
        _S153 = fabrics_0[_S135].uv_height_0;
    }
    else
    {
        _S153 = 0.0f;
    }
    point_1.draft_0 = _S180 + float2(0.0f, _S153);
    point_1.draft_dx_0 = _S171 * _S179;
    point_1.draft_dy_0 = _S172 * _S179;
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
    float3 normal_4;
    float3 tangent_4;
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

Crossing_0 crossing_at_0(uint _S181, float _S182, float _S183, bool _S184)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0[_S181].warp_0, _S182);
    crossing_2.weft_1 = locate_0(fabrics_0[_S181].weft_0, _S183);
    uint _S185 = fabrics_0[_S181].run_words_0 + 2U * (crossing_2.weft_1.thread_1 * fabrics_0[_S181].ends_0 + crossing_2.warp_1.thread_1);
    uint _S186 = words_0.Load(_S185);
    crossing_2.warp_word_0 = _S186;
    crossing_2.weft_word_0 = words_0.Load(_S185 + 1U);
    crossing_2.warp_above_0 = ((_S186 & 1U) == 1U) != _S184;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S187, float _S188, float _S189, bool _S190)
{
    Sample_0 sample_0;
    Crossing_0 _S191 = crossing_at_0(_S187, _S188, _S189, _S190);
    sample_0.crossing_1 = _S191;
    Shown_0 _S192 = shown_at_0(_S191, _S190);
    sample_0.shown_3 = _S192;
    uint _S193;
    if(_S192.is_warp_0)
    {
        _S193 = fabrics_0[_S187].warp_0;
    }
    else
    {
        _S193 = fabrics_0[_S187].weft_0;
    }
    uint _S194;
    if(_S192.is_warp_0)
    {
        _S194 = fabrics_0[_S187].weft_0;
    }
    else
    {
        _S194 = fabrics_0[_S187].warp_0;
    }
    Cell_0 _S195 = select_cell_0(_S192.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    Cell_0 _S196 = select_cell_0(_S192.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    Run_0 _S197 = unpack_0(_S193, _S194, _S195.thread_1, _S196, _S192.word_0);
    Section_0 _S198 = section_at_0(_S195);
    bool _S199;
    if(_S192.on_top_0)
    {
        _S199 = (_S197.distance_0) < (_S198.drop_0 * _S197.bend_1.sine_0);
    }
    else
    {
        _S199 = false;
    }
    bool _S200;
    if(_S192.on_top_0)
    {
        _S200 = !_S199;
    }
    else
    {
        _S200 = false;
    }
    float _S201;
    if(_S200)
    {
        _S201 = 1.0f;
    }
    else
    {
        _S201 = -1.0f;
    }
    float _S202;
    if(_S199)
    {
        _S202 = _S197.other_reach_0;
    }
    else
    {
        _S202 = _S197.reach_0;
    }
    float _S203;
    if(_S199)
    {
        _S203 = _S202 + _S197.distance_0;
    }
    else
    {
        _S203 = max(_S202 - _S197.distance_0, 0.0f);
    }
    float _S204 = _S202 / _S197.bend_1.sine_0 - _S201 * _S198.drop_0;
    float _S205 = _S203 * _S203;
    float _S206 = max(_S204 * _S204 - _S205, 9.99999968265522539e-21f);
    float _S207 = rsqrt(_S206);
    float _S208 = _S205 / (_S206 * _S207 + _S204);
    bool _S209 = _S203 > 0.0f;
    float _S210;
    if(_S192.on_top_0)
    {
        _S210 = 1.0f;
    }
    else
    {
        _S210 = -1.0f;
    }
    float _S211;
    if(_S197.near_start_0)
    {
        _S211 = 1.0f;
    }
    else
    {
        _S211 = -1.0f;
    }
    float _S212 = _S210 * _S211;
    if(_S209)
    {
        _S210 = _S204 * _S207;
    }
    else
    {
        _S210 = 1.0f;
    }
    sample_0.slope_across_0 = _S198.slope_0 * _S210;
    if(_S209)
    {
        _S203 = _S212 * _S203 * _S207;
    }
    else
    {
        _S203 = 0.0f;
    }
    sample_0.slope_along_0 = _S203;
    Family_0 _S213 = families_0.Load(_S193);
    float2 _S214 = dive_0(_S194, _S192, _S197, _S196);
    if(_S197.straight_0)
    {
        _S201 = 0.0f;
    }
    else
    {
        _S201 = _S213.height_scale_0 * _S201;
    }
    sample_0.height_5 = _S201 * (_S202 * _S197.bend_1.half_tangent_0 - _S208) - _S213.height_scale_0 * _S198.drop_0 - _S214.x;
    float _S215 = _S213.height_scale_0 * sample_0.slope_across_0;
    float _S216 = _S213.height_scale_0 * sample_0.slope_along_0 - _S214.y;
    if(_S192.is_warp_0)
    {
        _S201 = _S215;
    }
    else
    {
        _S201 = _S216;
    }
    sample_0.slope_x_1 = _S201;
    if(_S192.is_warp_0)
    {
        _S201 = _S216;
    }
    else
    {
        _S201 = _S215;
    }
    sample_0.slope_y_1 = _S201;
    sample_0.run_3 = _S197;
    sample_0.section_1 = _S198;
    return sample_0;
}

float steps_per_length_0(uint _S217, SearchQuality_0 _S218, float3 _S219)
{
    return max(max(abs(_S219.x) * fabrics_0[_S217].threads_per_x_0, abs(_S219.y) * fabrics_0[_S217].threads_per_y_0) * _S218.steps_per_thread_0, abs(_S219.z) * fabrics_0[_S217].per_relief_0 * _S218.steps_per_relief_0);
}

float cell_maximum_0(uint _S220, Crossing_0 _S221)
{
    uint _S222;
    if(_S221.warp_above_0)
    {
        _S222 = fabrics_0[_S220].warp_0;
    }
    else
    {
        _S222 = fabrics_0[_S220].weft_0;
    }
    uint _S223;
    if(_S221.warp_above_0)
    {
        _S223 = _S221.warp_word_0;
    }
    else
    {
        _S223 = _S221.weft_word_0;
    }
    return float(_S223 >> int(28)) * families_0.Load(_S222).height_scale_0 * families_0.Load(_S222).level_0;
}

Probe_0 probe_0(uint _S224, float _S225, float _S226, bool _S227, bool _S228, bool _S229)
{
    Sample_0 _S230 = sample_at_0(_S224, _S225, _S226, _S227);
    Probe_0 probe_1;
    probe_1.height_1 = _S230.height_5;
    probe_1.hole_1 = _S230.shown_3.hole_0;
    probe_1.slope_x_0 = _S230.slope_x_1;
    probe_1.slope_y_0 = _S230.slope_y_1;
    uint _S231;
    if(_S230.shown_3.is_warp_0)
    {
        _S231 = _S230.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S231 = _S230.crossing_1.weft_1.thread_1 * 2U;
    }
    probe_1.yarn_1 = _S231;
    probe_1.cell_max_0 = cell_maximum_0(_S224, _S230.crossing_1);
    float _S232;
    if(_S228)
    {
        _S232 = _S230.crossing_1.warp_1.above_0;
    }
    else
    {
        _S232 = _S230.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S232;
    if(_S229)
    {
        _S232 = _S230.crossing_1.weft_1.above_0;
    }
    else
    {
        _S232 = _S230.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S232;
    probe_1.edge_x_0 = outline_distance_0(_S230.crossing_1.warp_1, _S230.shown_3, _S230.run_3, !_S230.shown_3.is_warp_0, _S228);
    probe_1.edge_y_0 = outline_distance_0(_S230.crossing_1.weft_1, _S230.shown_3, _S230.run_3, _S230.shown_3.is_warp_0, _S229);
    return probe_1;
}

bool is_free_0(uint _S233, SearchQuality_0 _S234, float3 _S235, float3 _S236, bool _S237, float _S238)
{
    float _S239 = _S236.z;
    if(_S239 <= 0.0f)
    {
        return false;
    }
    float _S240 = 1.0f / max(_S234.shadow_share_0 * steps_per_length_0(_S233, _S234, _S236), 9.99999971718068537e-10f);
    StepControl_0 _S241 = step_control_0(_S236.xy, _S240);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S242;
        if(count_1 < 1024U)
        {
            _S242 = (_S235.z + _S239 * distance_1) < _S238;
        }
        else
        {
            _S242 = false;
        }
        if(_S242)
        {
        }
        else
        {
            break;
        }
        float3 _S243 = _S235 + _S236 * distance_1;
        Probe_0 _S244 = probe_0(_S233, _S243.x, _S243.y, _S237, _S241.right_0, _S241.up_0);
        float _S245 = _S243.z;
        float _S246 = _S245 - _S244.height_1;
        float _S247 = _S239 - _S244.slope_x_0 * _S236.x - _S244.slope_y_0 * _S236.y;
        bool _S248;
        if(!_S244.hole_1)
        {
            _S248 = _S246 < 0.0f;
        }
        else
        {
            _S248 = false;
        }
        if(_S248)
        {
            return false;
        }
        float _S249 = way_back_to_dip_0(previous_3, _S246, _S247, last_step_0, _S244);
        if(_S249 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S249;
            distance_1 = distance_1 - _S249;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S250 = _S245 > (_S244.cell_max_0);
        PreviousSample_0 _S251 = after_sample_0(_S246, _S247, _S244, _S250);
        float last_step_2;
        if(_S250)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S241, _S244.side_x_0, _S244.side_y_0), _S240);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S241, _S244, _S246, _S247);
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S251;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S252, SearchQuality_0 _S253, float _S254, float _S255, float3 _S256, bool _S257)
{
    if(!sample_at_0(_S252, _S254, _S255, _S257).shown_3.hole_0)
    {
        return false;
    }
    float3 _S258 = float3(_S254, _S255, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S259;
        if(side_0 < 2U)
        {
            _S259 = passes_0;
        }
        else
        {
            _S259 = false;
        }
        if(_S259)
        {
        }
        else
        {
            break;
        }
        float3 _S260;
        if(side_0 == 0U)
        {
            _S260 = _S256;
        }
        else
        {
            _S260 = float3(- _S256.x, - _S256.y, _S256.z);
        }
        bool _S261 = is_free_0(_S252, _S253, _S258, _S260, _S257 != (side_0 == 1U), fabrics_0[_S252].height_high_0);
        uint _S262 = side_0 + 1U;
        passes_0 = _S261;
        side_0 = _S262;
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

float max_height_along_0(uint _S263, float _S264, float _S265, float _S266, float3 _S267, bool _S268)
{
    uint _S269 = locate_0(fabrics_0[_S263].warp_0, _S264).thread_1 / 2U;
    uint _S270 = locate_0(fabrics_0[_S263].weft_0, _S265).thread_1 / 2U;
    float _S271 = _S267.x;
    uint _S272;
    if(_S271 > 0.0f)
    {
        _S272 = 1U;
    }
    else
    {
        _S272 = 0U;
    }
    float _S273 = _S267.y;
    uint _S274;
    if(_S273 > 0.0f)
    {
        _S274 = 2U;
    }
    else
    {
        _S274 = 0U;
    }
    uint _S275 = words_0.Load(fabrics_0[_S263].max_heights_0 + 4U * (_S270 * fabrics_0[_S263].max_height_columns_0 + _S269) + (_S272 + _S274));
    int number_0;
    if(_S268)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S276 = _S275 >> number_0;
    float _S277 = max(abs(_S271) * fabrics_0[_S263].threads_per_x_0, abs(_S273) * fabrics_0[_S263].threads_per_y_0) / _S267.z;
    float _S278 = fabrics_0[_S263].height_high_0;
    float max_height_0 = fabrics_0[_S263].height_high_0;
    number_0 = int(3);
    for(;;)
    {
        if(number_0 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S266) * _S277) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S276 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S278);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S279, float _S280, float _S281, bool _S282, bool _S283, bool _S284)
{
    Crossing_0 _S285 = crossing_at_0(_S279, _S280, _S281, _S282);
    float _S286 = cell_maximum_0(_S279, _S285);
    float _S287;
    if(_S283)
    {
        _S287 = _S285.warp_1.above_0;
    }
    else
    {
        _S287 = _S285.warp_1.below_0;
    }
    float _S288;
    if(_S284)
    {
        _S288 = _S285.weft_1.above_0;
    }
    else
    {
        _S288 = _S285.weft_1.below_0;
    }
    return float3(_S286, _S287, _S288);
}

float first_sample_height_0(uint _S289, ViewRay_0 _S290, StepControl_0 _S291, bool _S292)
{
    float _S293 = max_height_along_0(_S289, _S290.origin_0.x, _S290.origin_0.y, 0.0f, float3(_S290.slope_1, 1.0f), _S292);
    uint count_2 = 0U;
    float height_7 = _S293;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S294 = ViewRay_at_0(_S290, height_7);
        float3 _S295 = cell_bounds_0(_S289, _S294.x, _S294.y, _S292, _S291.right_0, _S291.up_0);
        float _S296 = height_7 - _S295.x;
        float _S297 = StepControl_to_cell_exit_0(_S291, _S295.y, _S295.z);
        float height_8 = height_7 - clamp(_S296, 0.0f, _S297);
        if(_S296 <= _S297)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S298, ViewRay_0 _S299, StepControl_0 _S300, bool _S301)
{
    float _S302 = fabrics_0[_S298].height_low_0 - (fabrics_0[_S298].height_high_0 - fabrics_0[_S298].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_6 = first_sample_height_0(_S298, _S299, _S300, _S301);
    end_1.last_step_3 = _S300.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
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
        float2 _S303 = ViewRay_at_0(_S299, end_1.height_6);
        Probe_0 _S304 = probe_0(_S298, _S303.x, _S303.y, _S301, _S300.right_0, _S300.up_0);
        float _S305 = end_1.height_6 - _S304.height_1;
        float _S306 = ViewRay_rate_0(_S299, _S304);
        end_1.depth_1 = - _S305;
        end_1.rate_4 = _S306;
        bool _S307;
        if(end_1.previous_4.known_0)
        {
            _S307 = !_S304.hole_1;
        }
        else
        {
            _S307 = false;
        }
        bool _S308;
        if(_S307)
        {
            _S308 = (end_1.previous_4.yarn_0) == (_S304.yarn_1);
        }
        else
        {
            _S308 = false;
        }
        end_1.smooth_0 = _S308;
        bool _S309;
        if(!_S304.hole_1)
        {
            _S309 = _S305 <= 0.0f;
        }
        else
        {
            _S309 = false;
        }
        bool _S310;
        if(_S309)
        {
            _S310 = true;
        }
        else
        {
            _S310 = (end_1.height_6) <= _S302;
        }
        if(_S310)
        {
            break;
        }
        float _S311 = way_back_to_dip_0(end_1.previous_4, _S305, _S306, end_1.last_step_3, _S304);
        if(_S311 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S311;
            end_1.last_step_3 = end_1.last_step_3 - _S311;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S312 = min(StepControl_to_cell_exit_0(_S300, _S304.side_x_0, _S304.side_y_0), end_1.height_6 - _S304.cell_max_0);
        float _S313 = StepControl_to_next_sample_0(_S300, _S304, _S305, _S306);
        end_1.previous_4 = after_sample_0(_S305, _S306, _S304, _S312 > _S313);
        float _S314 = max(_S312, _S313);
        end_1.last_step_3 = _S314;
        end_1.height_6 = end_1.height_6 - _S314;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S315, ViewRay_0 _S316, StepControl_0 _S317, bool _S318, ViewRayEnd_0 _S319, uint _S320)
{
    float _S321 = fabrics_0[_S315].height_high_0 - fabrics_0[_S315].height_low_0;
    float above_2 = _S319.height_6 + _S319.last_step_3;
    float above_gap_1 = clamp(_S319.previous_4.clearance_0, 0.0f, _S321);
    float under_gap_1 = clamp(_S319.depth_1, 0.0f, _S321);
    float _S322 = cubic_root_0(above_gap_1, - under_gap_1, _S319.previous_4.rate_0 * _S319.last_step_3, _S319.rate_4 * _S319.last_step_3);
    float middle_0;
    if(_S319.smooth_0)
    {
        middle_0 = above_2 - _S322 * _S319.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S319.height_6, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S319.height_6;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S320)
        {
        }
        else
        {
            break;
        }
        float2 _S323 = ViewRay_at_0(_S316, middle_0);
        Probe_0 _S324 = probe_0(_S315, _S323.x, _S323.y, _S318, _S317.right_0, _S317.up_0);
        float _S325;
        if(_S324.hole_1)
        {
            _S325 = -1.0e+09f;
        }
        else
        {
            _S325 = _S324.height_1;
        }
        float _S326 = clamp(middle_0 - _S325, - _S321, _S321);
        float _S327;
        if(_S326 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S327 = 0.5f * above_gap_2;
            }
            else
            {
                _S327 = above_gap_2;
            }
            float _S328 = - _S326;
            under_1 = middle_0;
            above_gap_2 = _S327;
            under_gap_2 = _S328;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S327 = 0.5f * under_gap_2;
            }
            else
            {
                _S327 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S326;
            under_gap_2 = _S327;
            side_1 = -1.0f;
        }
        if(_S319.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S326 / min(ViewRay_rate_0(_S316, _S324), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S319.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_0(uint _S329, SearchQuality_0 _S330, float _S331, float _S332, float3 _S333, bool _S334)
{
    Hit_0 hit_0;
    hit_0.x_10 = _S331;
    hit_0.y_6 = _S332;
    hit_0.height_4 = 0.0f;
    bool _S335 = passes_through_0(_S329, _S330, _S331, _S332, _S333, _S334);
    hit_0.hole_3 = _S335;
    if(_S335)
    {
        return hit_0;
    }
    float _S336 = max(_S333.z, 0.00009999999747379f);
    ViewRay_0 ray_0;
    ray_0.origin_0 = float2(_S331, _S332);
    float2 _S337 = _S333.xy / _S336;
    ray_0.slope_1 = _S337;
    StepControl_0 _S338 = step_control_0(- _S337, 1.0f / max(steps_per_length_0(_S329, _S330, _S333) / _S336, 9.99999971718068537e-10f));
    float _S339 = refined_height_0(_S329, ray_0, _S338, _S334, search_down_0(_S329, ray_0, _S338, _S334), _S330.refinements_0);
    hit_0.height_4 = _S339;
    float2 _S340 = ViewRay_at_0(ray_0, _S339);
    hit_0.x_10 = _S340.x;
    hit_0.y_6 = _S340.y;
    return hit_0;
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

SurfacePoint_0 surface_at_0(uint _S341, float _S342, float _S343, bool _S344)
{
    Sample_0 _S345 = sample_at_0(_S341, _S342, _S343, _S344);
    float _S346;
    if(_S345.shown_3.is_warp_0)
    {
        _S346 = _S345.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S346 = _S345.crossing_1.weft_1.half_width_1;
    }
    uint _S347;
    if(_S345.shown_3.is_warp_0)
    {
        _S347 = fabrics_0[_S341].warp_0;
    }
    else
    {
        _S347 = fabrics_0[_S341].weft_0;
    }
    Family_0 _S348 = families_0.Load(_S347);
    float _S349;
    if(_S344)
    {
        _S349 = -1.0f;
    }
    else
    {
        _S349 = 1.0f;
    }
    float _S350 = _S348.twist_sine_0 * _S349;
    Family_0 _S351 = families_0.Load(_S347);
    if(_S345.shown_3.is_warp_0)
    {
        _S349 = 1.0f;
    }
    else
    {
        _S349 = -1.0f;
    }
    float2 _S352 = fibre_direction_0(_S345.slope_across_0, _S349 * _S345.slope_along_0, _S350, _S351.twist_cosine_0);
    float _S353;
    if(_S345.shown_3.is_warp_0)
    {
        _S353 = _S345.slope_x_1;
    }
    else
    {
        _S353 = _S345.slope_y_1;
    }
    float _S354;
    if(_S345.shown_3.is_warp_0)
    {
        _S354 = _S345.slope_y_1;
    }
    else
    {
        _S354 = _S345.slope_x_1;
    }
    float _S355 = _S352.x;
    float _S356 = _S352.y;
    float _S357 = _S353 * _S355 + _S349 * _S354 * _S356;
    float _S358 = _S346 * 1.0154266357421875f;
    float _S359 = _S358 * arc_sine_0(clamp(_S345.section_1.across_1 / _S358, -1.0f, 1.0f));
    if(_S345.shown_3.is_warp_0)
    {
        _S346 = _S343;
    }
    else
    {
        _S346 = - _S342;
    }
    SurfacePoint_0 point_2;
    point_2.hole_4 = _S345.shown_3.hole_0;
    point_2.is_warp_2 = _S345.shown_3.is_warp_0;
    point_2.warp_thread_0 = _S345.crossing_1.warp_1.thread_1;
    point_2.weft_thread_0 = _S345.crossing_1.weft_1.thread_1;
    point_2.height_9 = _S345.height_5;
    point_2.normal_5 = normalize(float3(- _S345.slope_x_1, - _S345.slope_y_1, 1.0f));
    float3 _S360;
    if(_S345.shown_3.is_warp_0)
    {
        _S360 = float3(_S355, _S356, _S357);
    }
    else
    {
        _S360 = float3(- _S356, _S355, _S357);
    }
    point_2.tangent_5 = normalize(_S360);
    point_2.across_2 = _S345.section_1.across_1;
    point_2.fibre_across_0 = _S359 * _S351.twist_cosine_0 + _S346 * _S350;
    point_2.fibre_along_0 = _S346 * _S351.twist_cosine_0 - _S359 * _S350;
    return point_2;
}

Albedos_0 vary_albedos_0(uint _S361, Albedos_0 _S362, uint _S363, uint _S364)
{
    float3 _S365 = max(_S362.specular_reflect_0, _S362.specular_transmit_0);
    float3 _S366 = _S362.diffuse_reflect_0 + _S362.diffuse_transmit_0;
    float _S367 = bounded_gain_0(thread_gain_0(_S363, fabrics_0[_S361].colour_noise_0, fabrics_0[_S361].seed_0), _S366, 1.0f - fabrics_0[_S361].layer_bound_0 * _S365);
    float _S368 = bounded_gain_0(fibre_gain_0(_S363, _S364, fabrics_0[_S361].fibre_noise_0, fabrics_0[_S361].seed_0), _S365, min((1.0f - _S367 * _S366) / fabrics_0[_S361].layer_bound_0, (float3)1.0f));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S367 * _S362.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S367 * _S362.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S368 * _S362.specular_reflect_0;
    varied_0.specular_transmit_0 = _S368 * _S362.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S369, SurfacePoint_0 _S370, Albedos_0 _S371, float _S372, float _S373)
{
    float _S374;
    if(_S370.is_warp_2)
    {
        _S374 = _S372;
    }
    else
    {
        _S374 = _S373;
    }
    float _S375 = _S374 - _S370.across_2;
    uint _S376;
    if(_S370.is_warp_2)
    {
        _S376 = fabrics_0[_S369].warp_0;
    }
    else
    {
        _S376 = fabrics_0[_S369].weft_0;
    }
    Family_0 _S377 = families_0.Load(_S376);
    int _S378 = int(families_0.Load(_S376).count_0);
    if(_S370.is_warp_2)
    {
        _S376 = _S370.warp_thread_0;
    }
    else
    {
        _S376 = _S370.weft_thread_0;
    }
    uint _S379 = uint(int(floor(_S375 / _S377.period_0)) * _S378 + int(_S376)) * 2U;
    if(_S370.is_warp_2)
    {
        _S376 = 1U;
    }
    else
    {
        _S376 = 0U;
    }
    float _S380 = floor(_S370.fibre_across_0 / fabrics_0[_S369].fibre_size_0);
    return vary_albedos_0(_S369, _S371, _S379 + _S376, uint(int(_S380)) * 65536U + uint(int(floor(_S370.fibre_along_0 / (fabrics_0[_S369].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S380))));
}

YarnPoint_0 yarn_point_at_0(uint _S381, float _S382, float _S383, bool _S384, bool _S385)
{
    SurfacePoint_0 _S386 = surface_at_0(_S381, _S382, _S383, _S384);
    uint _S387;
    if(_S386.is_warp_2)
    {
        _S387 = fabrics_0[_S381].warp_0;
    }
    else
    {
        _S387 = fabrics_0[_S381].weft_0;
    }
    uint _S388;
    if(_S386.is_warp_2)
    {
        _S388 = _S386.warp_thread_0;
    }
    else
    {
        _S388 = _S386.weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S387, _S388);
    bool _S389;
    if((fabrics_0[_S381].fibre_noise_0) > 0.0f)
    {
        _S389 = true;
    }
    else
    {
        _S389 = (fabrics_0[_S381].colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_3;
    if(_S389)
    {
        albedos_3 = varied_at_0(_S381, _S386, albedos_2, _S382, _S383);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_3;
    point_3.back_2 = _S384;
    point_3.hole_2 = _S385;
    point_3.is_warp_1 = _S386.is_warp_2;
    point_3.x_9 = _S382;
    point_3.y_5 = _S383;
    point_3.height_3 = _S386.height_9;
    point_3.normal_4 = _S386.normal_5;
    point_3.tangent_4 = _S386.tangent_5;
    point_3.roughness_8 = families_0.Load(_S387).roughness_0;
    point_3.albedos_1 = albedos_3;
    return point_3;
}

YarnPoint_0 locate_yarn_0(uint _S390, SearchQuality_0 _S391, float _S392, float _S393, float3 _S394)
{
    bool _S395 = (_S394.z) < 0.0f;
    Hit_0 _S396 = first_hit_0(_S390, _S391, _S392, _S393, to_face_frame_0(_S394, _S395), _S395);
    return yarn_point_at_0(_S390, _S396.x_10, _S396.y_6, _S395, _S396.hole_3);
}

float3 scattered_0(uint _S397, YarnPoint_0 _S398, float3 _S399, float3 _S400)
{
    float3 _S401 = (float3)0.0f;
    bool _S402 = !_S398.hole_2;
    bool _S403;
    if(_S402)
    {
        _S403 = (_S399.z) > 0.0f;
    }
    else
    {
        _S403 = false;
    }
    float3 value_1;
    if(_S403)
    {
        value_1 = _S398.albedos_1.diffuse_reflect_0 * diffuse_reflection_0(_S399, _S398.normal_4, fabrics_0[_S397].diffuse_blend_0) + _S398.albedos_1.specular_reflect_0 * reflection_0(_S399, _S400, _S398.normal_4, _S398.tangent_4, _S398.roughness_8, fabrics_0[_S397].optical_depth_0);
    }
    else
    {
        if(_S402)
        {
            _S403 = (_S399.z) < 0.0f;
        }
        else
        {
            _S403 = false;
        }
        if(_S403)
        {
            value_1 = _S398.albedos_1.diffuse_transmit_0 * diffuse_reflection_0(- _S399, _S398.normal_4, fabrics_0[_S397].diffuse_blend_0) + _S398.albedos_1.specular_transmit_0 * transmission_0(_S399, _S400, _S398.normal_4, _S398.tangent_4, _S398.roughness_8, fabrics_0[_S397].optical_depth_0);
        }
        else
        {
            value_1 = _S401;
        }
    }
    float _S404 = fabrics_0[_S397].sheen_strength_0;
    if((fabrics_0[_S397].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S405 = sheen_with_transmittance_0(_S399, _S400, _S404, fabrics_0[_S397].sheen_roughness_0);
    return _S405.y * value_1 + _S405.x;
}

bool unoccluded_0(uint _S406, SearchQuality_0 _S407, float _S408, float _S409, float _S410, float3 _S411, bool _S412)
{
    if((_S411.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S406, _S407, float3(_S408, _S409, _S410 + fabrics_0[_S406].lift_0), _S411, _S412, max_height_along_0(_S406, _S408, _S409, _S410, _S411, _S412));
}

bool is_lit_0(uint _S413, SearchQuality_0 _S414, YarnPoint_0 _S415, float3 _S416)
{
    if(_S415.hole_2)
    {
        return true;
    }
    float3 _S417 = to_face_frame_0(_S416, _S415.back_2);
    float _S418 = _S417.z;
    bool _S419 = _S418 < 0.0f;
    float3 normal_6;
    float height_10;
    if(_S419)
    {
        SurfacePoint_0 _S420 = surface_at_0(_S413, _S415.x_9, _S415.y_5, !_S415.back_2);
        normal_6 = _S420.normal_5;
        height_10 = _S420.height_9;
    }
    else
    {
        normal_6 = _S415.normal_4;
        height_10 = _S415.height_3;
    }
    float3 _S421 = float3(_S417.xy, abs(_S418));
    if((dot(normal_6, _S421)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S413, _S414, _S415.x_9, _S415.y_5, height_10, _S421, (_S415.back_2) != _S419);
}

float3 evaluate_0(uint _S422, SearchQuality_0 _S423, YarnPoint_0 _S424, float3 _S425, float3 _S426)
{
    float3 _S427 = scattered_0(_S422, _S424, to_face_frame_0(_S425, _S424.back_2), to_face_frame_0(_S426, _S424.back_2));
    bool _S428;
    if((max(_S427.x, max(_S427.y, _S427.z))) <= 0.0f)
    {
        _S428 = true;
    }
    else
    {
        _S428 = !is_lit_0(_S422, _S423, _S424, _S425);
    }
    if(_S428)
    {
        return (float3)0.0f;
    }
    return _S427;
}

float straight_through_0(uint _S429, YarnPoint_0 _S430, float3 _S431)
{
    if(!_S430.hole_2)
    {
        return 0.0f;
    }
    float _S432 = fabrics_0[_S429].sheen_strength_0;
    if((fabrics_0[_S429].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S432 * sheen_lobe_0(abs(_S431.z), fabrics_0[_S429].sheen_roughness_0).z;
}

float4 direct_light_0(Frame_0 _S433, uint _S434, VisiblePoint_0 _S435, float2 _S436)
{
    SearchQuality_0 _S437 = default_quality_0();
    float3 _S438 = to_local_0(_S435, _S435.view_0);
    YarnPoint_0 _S439 = locate_yarn_0(_S434, _S437, _S436.x, _S436.y, _S438);
    float3 _S440 = (float3)0.0f;
    uint number_1 = 0U;
    float3 radiance_1 = _S440;
    for(;;)
    {
        if(number_1 < (_S433.lights_0))
        {
        }
        else
        {
            break;
        }
        float3 irradiance_2;
        float3 _S441 = towards_light_0(lights_1.Load(number_1), _S435.position_0, irradiance_2);
        float3 radiance_2 = radiance_1 + irradiance_2 * evaluate_0(_S434, _S437, _S439, to_local_0(_S435, _S441), _S438);
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    return float4(radiance_1, 1.0f - straight_through_0(_S434, _S439, _S438));
}

[numthreads(8, 8, 1)]
void shade(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S442;
    Frame_0 _S443 = frames_0.Load(int(0));
    bool _S444;
    if((id_0.x) >= (_S443.width_0))
    {
        _S444 = true;
    }
    else
    {
        _S444 = (id_0.y) >= (_S443.height_0);
    }
    if(_S444)
    {
        return;
    }
    uint2 _S445 = id_0.xy;
    uint _S446 = _S445.y * _S443.width_0 + _S445.x;
    uint _S447 = visible_faces_0.Load(int3(int2(_S445), int(0)));
    float4 sum_0 = (float4)0.0f;
    if(_S447 > 0U)
    {
        uint _S448 = _S447 - 1U;
        uint _S449 = face_fabrics_0.Load(_S448);
        VisiblePoint_0 _S450 = visible_point_0(_S443, _S449, _S448, _S445);
        uint k_0 = 0U;
        for(;;)
        {
            _S442 = _S443.samples_0;
            if(k_0 < (_S443.samples_0))
            {
            }
            else
            {
                break;
            }
            float2 _S451 = footprint_sample_0(_S445, _S443.pass_number_0 * _S443.samples_0 + k_0);
            sum_0 = sum_0 + direct_light_0(_S443, _S449, _S450, _S450.draft_0 + _S451.x * _S450.draft_dx_0 + _S451.y * _S450.draft_dy_0);
            k_0 = k_0 + 1U;
        }
        sum_0 = sum_0 / float(_S442);
    }
    sum_0.xyz = sum_0.xyz + (1.0f - sum_0.w) * float3(_S443.background_red_0, _S443.background_green_0, _S443.background_blue_0);
    float4 _S452;
    if((_S443.pass_number_0) == 0U)
    {
        _S452 = sum_0;
    }
    else
    {
        _S452 = radiance_0[_S446] + sum_0;
    }
    radiance_0[_S446] = _S452;
    return;
}

