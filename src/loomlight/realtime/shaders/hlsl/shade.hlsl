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

StructuredBuffer<Frame_0 > frames_0 : register(t3);

Texture2D<uint > visible_faces_0 : register(t7);

StructuredBuffer<uint > face_fabrics_0 : register(t6);

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
};

struct Fabric_0
{
    Family_0 warp_0;
    Family_0 weft_0;
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

StructuredBuffer<uint > corners_0 : register(t5);

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

StructuredBuffer<Vertex_0 > vertices_0 : register(t4);

StructuredBuffer<uint > words_0 : register(t1);

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

StructuredBuffer<Light_0 > lights_1 : register(t2);

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

struct StepControl_0
{
    float step_0;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_0;
    bool up_0;
};

StepControl_0 step_control_0(float2 direction_2, float step_1)
{
    StepControl_0 control_0;
    control_0.step_0 = step_1;
    control_0.epsilon_0 = 0.00499999988824129f * step_1;
    float _S7 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S7), 9.99999971718068537e-10f);
    float _S8 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S8), 9.99999971718068537e-10f);
    control_0.right_0 = _S7 > 0.0f;
    control_0.up_0 = _S8 > 0.0f;
    return control_0;
}

float2 turns_and_remainder_0(Family_0 family_0, float index_1)
{
    float _S9 = floor(mad(index_1, family_0.inverse_count_0, family_0.half_inverse_count_0));
    return float2(_S9, mad(- _S9, family_0.count_0, index_1));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(Family_0 family_1, float position_1)
{
    float _S10 = floor(position_1 * family_1.inverse_size_0);
    Cell_0 cell_1;
    float _S11 = mad(- _S10, family_1.size_0, position_1);
    cell_1.below_0 = _S11;
    cell_1.above_0 = family_1.size_0 - _S11;
    cell_1.across_0 = _S11 - 0.5f * family_1.size_0;
    cell_1.half_width_1 = family_1.half_width_0;
    cell_1.thread_1 = uint(clamp(turns_and_remainder_0(family_1, _S10).y, 0.0f, family_1.count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_2)
{
    return asfloat(words_0.Load(index_2));
}

Cell_0 locate_varied_0(Family_0 family_2, float position_2)
{
    float turns_0 = (position_2 - family_2.start_0) * family_2.inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S12 = turns_1 * family_2.period_0;
    uint thread_2 = words_0.Load(family_2.first_thread_table_0 + uint(clamp(turns_1 * family_2.bins_0, 0.0f, family_2.bins_0 - 1.0f)));
    uint _S13;
    if(_S12 >= (table_number_0(family_2.place_table_0 + thread_2 * 4U + 1U)))
    {
        _S13 = 1U;
    }
    else
    {
        _S13 = 0U;
    }
    uint _S14 = min(thread_2 + _S13, uint(family_2.count_0) - 1U);
    uint _S15 = family_2.place_table_0 + _S14 * 4U;
    Cell_0 cell_2;
    cell_2.thread_1 = _S14;
    cell_2.below_0 = _S12 - table_number_0(_S15);
    cell_2.above_0 = table_number_0(_S15 + 1U) - _S12;
    cell_2.across_0 = _S12 - table_number_0(_S15 + 2U);
    cell_2.half_width_1 = table_number_0(_S15 + 3U);
    return cell_2;
}

Cell_0 locate_0(Family_0 family_3, float position_3)
{
    if((family_3.is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_0;
};

float2 ViewRay_at_0(ViewRay_0 this_0, float height_1)
{
    return this_0.origin_0 + this_0.slope_0 * height_1;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_0, float side_y_0)
{
    return max(min(side_x_0 * this_1.per_x_0, side_y_0 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
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
    bool _S16 = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    bool _S17 = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S18;
    if(_S16)
    {
        if(!_S17)
        {
            _S18 = true;
        }
        else
        {
            _S18 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S18 = false;
    }
    shown_0.is_warp_0 = _S18;
    if(!_S16)
    {
        _S18 = !_S17;
    }
    else
    {
        _S18 = false;
    }
    shown_0.hole_0 = _S18;
    uint _S19;
    if(shown_0.is_warp_0)
    {
        _S19 = crossing_0.warp_word_0;
    }
    else
    {
        _S19 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S19;
    shown_0.on_top_0 = ((_S19 & 1U) == 1U) != back_1;
    return shown_0;
}

float boundary_0(Family_0 family_4, uint thread_3, int step_2)
{
    float2 _S20 = turns_and_remainder_0(family_4, float(int(thread_3) + step_2));
    return mad(_S20.x, family_4.period_0, table_number_0(family_4.place_table_0 + uint(_S20.y) * 4U));
}

float span_0(Family_0 family_5, uint thread_4, int first_0, int last_0)
{
    if((family_5.is_alike_0) != 0U)
    {
        return float(last_0 - first_0) * family_5.size_0;
    }
    return boundary_0(family_5, thread_4, last_0) - boundary_0(family_5, thread_4, first_0);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(Family_0 family_6, uint thread_5)
{
    uint _S21;
    if((family_6.is_alike_0) != 0U)
    {
        _S21 = 0U;
    }
    else
    {
        _S21 = thread_5 * 4U;
    }
    uint _S22 = family_6.bend_table_0 + _S21;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S22);
    bend_0.half_tangent_0 = table_number_0(_S22 + 1U);
    bend_0.arc_0 = table_number_0(_S22 + 2U);
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

Run_0 unpack_0(Family_0 own_0, Family_0 other_0, uint thread_6, Cell_0 crossed_0, uint word_1)
{
    int _S23 = int((word_1 >> int(1)) & 127U);
    int _S24 = int((word_1 >> int(8)) & 127U);
    int _S25 = int((word_1 >> int(15)) & 63U);
    int _S26 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    int _S27 = - _S23;
    float _S28 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S27, int(0));
    run_0.from_start_0 = _S28;
    int _S29 = _S24 + int(1);
    float _S30 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, int(1), _S29);
    run_0.to_end_0 = _S30;
    bool _S31 = _S28 < _S30;
    run_0.near_start_0 = _S31;
    int _S32;
    if(_S31)
    {
        _S32 = _S27 - _S25;
    }
    else
    {
        _S32 = _S29;
    }
    int _S33;
    if(run_0.near_start_0)
    {
        _S33 = _S27;
    }
    else
    {
        _S33 = _S29 + _S26;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    float _S34;
    if(run_0.straight_0)
    {
        _S34 = 1.0e+06f;
    }
    else
    {
        _S34 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S34;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S32, _S33), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S23 == int(0);
    run_0.last_crossing_0 = _S24 == int(0);
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
    float slope_1;
};

Section_0 section_at_0(Cell_0 cell_3)
{
    float _S35 = cell_3.half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S36 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S36;
    float _S37 = _S35 * _S35 - square_1(_S36);
    float _S38 = rsqrt(_S37);
    section_0.drop_0 = _S35 - _S37 * _S38;
    section_0.slope_1 = - _S36 * _S38;
    return section_0;
}

float edge_drop_0(Family_0 family_7, uint thread_7, int step_3)
{
    if((family_7.is_alike_0) != 0U)
    {
        return table_number_0(family_7.bend_table_0 + 3U);
    }
    return table_number_0(family_7.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_7) + step_3)).y) * 4U + 3U);
}

float2 dive_0(Family_0 other_1, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
{
    bool _S39 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S40 = min(crossed_1.below_0, crossed_1.above_0);
    float _S41;
    if(_S39)
    {
        _S41 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S41 = crossed_1.above_0 + crossed_1.across_0;
    }
    float _S42 = _S41 - crossed_1.half_width_1;
    bool _S43;
    if(_S39)
    {
        _S43 = run_1.first_crossing_0;
    }
    else
    {
        _S43 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S41 = 0.0f;
    }
    else
    {
        _S41 = other_1.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, int(0));
    }
    float _S44;
    if((shown_1.on_top_0) != _S43)
    {
        _S44 = 0.0f;
    }
    else
    {
        int _S45;
        if(_S39)
        {
            _S45 = int(-1);
        }
        else
        {
            _S45 = int(1);
        }
        _S44 = other_1.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S45);
    }
    float _S46 = 1.0f / max(2.0f * _S42, 9.999999960041972e-13f);
    float _S47 = clamp((_S42 - _S40) * _S46, 0.0f, 1.0f);
    float _S48 = _S41 + (_S44 - _S41) * (_S47 * _S47 * (3.0f - 2.0f * _S47));
    float _S49 = (_S41 - _S44) * (6.0f * _S47 * (1.0f - _S47) * _S46);
    if(_S39)
    {
        _S41 = 1.0f;
    }
    else
    {
        _S41 = -1.0f;
    }
    return float2(_S48, _S49 * _S41);
}

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_2;
    Run_0 run_2;
    Section_0 section_1;
    float height_2;
    float slope_across_0;
    float slope_along_0;
    float slope_x_0;
    float slope_y_0;
};

void shape_0(Family_0 own_1, Family_0 other_2, Cell_0 own_cell_0, Cell_0 crossed_2, inout Sample_0 sample_0)
{
    Shown_0 _S50 = sample_0.shown_2;
    Run_0 _S51 = unpack_0(own_1, other_2, own_cell_0.thread_1, crossed_2, sample_0.shown_2.word_0);
    Section_0 _S52 = section_at_0(own_cell_0);
    bool _S53;
    if(sample_0.shown_2.on_top_0)
    {
        _S53 = (_S51.distance_0) < (_S52.drop_0 * _S51.bend_1.sine_0);
    }
    else
    {
        _S53 = false;
    }
    bool _S54;
    if(_S50.on_top_0)
    {
        _S54 = !_S53;
    }
    else
    {
        _S54 = false;
    }
    float _S55;
    if(_S54)
    {
        _S55 = 1.0f;
    }
    else
    {
        _S55 = -1.0f;
    }
    float _S56;
    if(_S53)
    {
        _S56 = _S51.other_reach_0;
    }
    else
    {
        _S56 = _S51.reach_0;
    }
    float _S57;
    if(_S53)
    {
        _S57 = _S56 + _S51.distance_0;
    }
    else
    {
        _S57 = max(_S56 - _S51.distance_0, 0.0f);
    }
    float _S58 = _S56 / _S51.bend_1.sine_0 - _S55 * _S52.drop_0;
    float _S59 = _S57 * _S57;
    float _S60 = max(_S58 * _S58 - _S59, 9.99999968265522539e-21f);
    float _S61 = rsqrt(_S60);
    float _S62 = _S59 / (_S60 * _S61 + _S58);
    bool _S63 = _S57 > 0.0f;
    float _S64;
    if(_S50.on_top_0)
    {
        _S64 = 1.0f;
    }
    else
    {
        _S64 = -1.0f;
    }
    float _S65;
    if(_S51.near_start_0)
    {
        _S65 = 1.0f;
    }
    else
    {
        _S65 = -1.0f;
    }
    float _S66 = _S64 * _S65;
    if(_S63)
    {
        _S64 = _S58 * _S61;
    }
    else
    {
        _S64 = 1.0f;
    }
    sample_0.slope_across_0 = _S52.slope_1 * _S64;
    if(_S63)
    {
        _S57 = _S66 * _S57 * _S61;
    }
    else
    {
        _S57 = 0.0f;
    }
    sample_0.slope_along_0 = _S57;
    float2 _S67 = dive_0(other_2, _S50, _S51, crossed_2);
    if(_S51.straight_0)
    {
        _S55 = 0.0f;
    }
    else
    {
        _S55 = own_1.height_scale_0 * _S55;
    }
    sample_0.height_2 = _S55 * (_S56 * _S51.bend_1.half_tangent_0 - _S62) - own_1.height_scale_0 * _S52.drop_0 - _S67.x;
    float _S68 = own_1.height_scale_0 * sample_0.slope_across_0;
    float _S69 = own_1.height_scale_0 * sample_0.slope_along_0 - _S67.y;
    if(_S50.is_warp_0)
    {
        _S55 = _S68;
    }
    else
    {
        _S55 = _S69;
    }
    sample_0.slope_x_0 = _S55;
    if(_S50.is_warp_0)
    {
        _S55 = _S69;
    }
    else
    {
        _S55 = _S68;
    }
    sample_0.slope_y_0 = _S55;
    sample_0.run_2 = _S51;
    sample_0.section_1 = _S52;
    return;
}

float outline_distance_0(Cell_0 cell_4, Shown_0 shown_3, Run_0 run_3, bool lengthwise_0, bool forwards_0)
{
    float _S70;
    if(forwards_0)
    {
        _S70 = cell_4.across_0;
    }
    else
    {
        _S70 = - cell_4.across_0;
    }
    float _S71;
    if(forwards_0)
    {
        _S71 = cell_4.above_0;
    }
    else
    {
        _S71 = cell_4.below_0;
    }
    bool _S72;
    if(forwards_0)
    {
        _S72 = run_3.last_crossing_0;
    }
    else
    {
        _S72 = run_3.first_crossing_0;
    }
    bool _S73;
    if(forwards_0)
    {
        _S73 = run_3.first_crossing_0;
    }
    else
    {
        _S73 = run_3.last_crossing_0;
    }
    float _S74 = - cell_4.half_width_1;
    bool _S75 = _S70 < _S74;
    bool _S76 = _S70 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S72 = !_S72;
    }
    else
    {
        _S72 = false;
    }
    if(_S72)
    {
        _S72 = !shown_3.hole_0;
    }
    else
    {
        _S72 = false;
    }
    bool _S77;
    if(_S72)
    {
        _S77 = shown_3.on_top_0;
    }
    else
    {
        _S77 = false;
    }
    if(_S77)
    {
        if(_S73)
        {
            _S73 = _S75;
        }
        else
        {
            _S73 = false;
        }
        _S73 = !_S73;
    }
    else
    {
        _S73 = false;
    }
    if(shown_3.hole_0)
    {
        _S72 = true;
    }
    else
    {
        if(_S72)
        {
            _S72 = !shown_3.on_top_0;
        }
        else
        {
            _S72 = false;
        }
    }
    float _S78;
    if(_S75)
    {
        _S78 = _S74;
    }
    else
    {
        _S78 = cell_4.half_width_1;
    }
    float _S79 = _S78 - _S70;
    if(_S72)
    {
        _S70 = 2.0f * _S71 + _S70 - cell_4.half_width_1;
    }
    else
    {
        _S70 = _S71;
    }
    if(_S73)
    {
        if(forwards_0)
        {
            _S70 = run_3.to_end_0;
        }
        else
        {
            _S70 = run_3.from_start_0;
        }
        return _S70;
    }
    if(_S76)
    {
    }
    else
    {
        _S70 = _S79;
    }
    return _S70;
}

struct Probe_0
{
    float height_3;
    bool hole_1;
    float slope_x_1;
    float slope_y_1;
    uint yarn_1;
    float cell_max_0;
    float side_x_1;
    float side_y_1;
    float edge_x_0;
    float edge_y_0;
};

float ViewRay_rate_0(ViewRay_0 this_2, Probe_0 here_0)
{
    return here_0.slope_x_1 * this_2.slope_0.x + here_0.slope_y_1 * this_2.slope_0.y - 1.0f;
}

float way_back_to_dip_0(PreviousSample_0 previous_1, float clearance_1, float rate_1, float step_4, Probe_0 here_1)
{
    float _S80 = previous_1.rate_0 * step_4;
    float _S81 = rate_1 * step_4;
    bool _S82;
    if(!previous_1.known_0)
    {
        _S82 = true;
    }
    else
    {
        _S82 = here_1.hole_1;
    }
    if(_S82)
    {
        _S82 = true;
    }
    else
    {
        _S82 = (previous_1.yarn_0) != (here_1.yarn_1);
    }
    if(_S82)
    {
        _S82 = true;
    }
    else
    {
        _S82 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S82)
    {
        _S82 = true;
    }
    else
    {
        _S82 = rate_1 <= 0.0f;
    }
    if(_S82)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S80) >= 0.0f)
    {
        _S82 = (3.0f * clearance_1 - _S81) >= 0.0f;
    }
    else
    {
        _S82 = false;
    }
    if(_S82)
    {
        return -1.0f;
    }
    float _S83 = clearance_1 - previous_1.clearance_0;
    float _S84 = 6.0f * _S83 - 4.0f * _S80 - 2.0f * _S81;
    float _S85 = -2.0f * _S80 / max(_S84 + sqrt(max(_S84 * _S84 - 4.0f * (3.0f * (_S80 + _S81 - 2.0f * _S83)) * _S80, 0.0f)), 9.99999968265522539e-21f);
    float _S86 = 1.0f - _S85;
    float _S87 = (previous_1.clearance_0 * (2.0f * _S85 + 1.0f) + _S80 * _S85) * _S86 * _S86;
    float _S88 = (clearance_1 * (2.0f * _S86 + 1.0f) - _S81 * _S86) * _S85 * _S85;
    if(_S85 > 0.01999999955296516f)
    {
        _S82 = _S86 > 0.01999999955296516f;
    }
    else
    {
        _S82 = false;
    }
    if(_S82)
    {
        _S82 = (_S87 + _S88) < 0.0f;
    }
    else
    {
        _S82 = false;
    }
    float _S89;
    if(_S82)
    {
        _S89 = _S86 * step_4;
    }
    else
    {
        _S89 = -1.0f;
    }
    return _S89;
}

float StepControl_to_next_sample_0(StepControl_0 this_3, Probe_0 here_2, float clearance_2, float rate_2)
{
    float _S90 = min(here_2.edge_x_0 * this_3.per_x_0, here_2.edge_y_0 * this_3.per_y_0);
    bool _S91;
    if(!here_2.hole_1)
    {
        _S91 = (rate_2 * _S90 + clearance_2) < 0.0f;
    }
    else
    {
        _S91 = false;
    }
    if(_S91)
    {
        _S91 = _S90 > (2.0f * this_3.epsilon_0);
    }
    else
    {
        _S91 = false;
    }
    float _S92;
    if(_S91)
    {
        _S92 = _S90 - this_3.epsilon_0;
    }
    else
    {
        _S92 = max(_S90, 0.0f) + this_3.epsilon_0;
    }
    return min(this_3.step_0, _S92);
}

PreviousSample_0 after_sample_0(float clearance_3, float rate_3, Probe_0 here_3, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S93;
    if(here_3.hole_1)
    {
        _S93 = 1.0e+09f;
    }
    else
    {
        _S93 = clearance_3;
    }
    previous_2.clearance_0 = _S93;
    previous_2.rate_0 = rate_3;
    previous_2.yarn_0 = here_3.yarn_1;
    bool _S94;
    if(!here_3.hole_1)
    {
        _S94 = !is_cell_exit_0;
    }
    else
    {
        _S94 = false;
    }
    previous_2.known_0 = _S94;
    return previous_2;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S95 = end_0 - start_1;
    float _S96 = start_rate_0 + end_rate_0 - 2.0f * _S95;
    float _S97 = 3.0f * _S95 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S95, 9.99999968265522539e-21f);
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
        float _S98 = clamp(share_0 - (((_S96 * share_0 + _S97) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S96 * share_0 + 2.0f * _S97) * share_0 + start_rate_0, 0.10000000149011612f * _S95 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S99 = i_0 + int(1);
        share_0 = _S98;
        i_0 = _S99;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S100 = along_slope_0 * along_slope_0 + 1.0f;
    float _S101 = rsqrt(_S100);
    float _S102 = sine_1 * _S101 * rsqrt(_S100 + across_slope_0 * across_slope_0);
    return float2(- _S102 * _S100, _S102 * across_slope_0 * along_slope_0 + cosine_0 * _S101);
}

float arc_sine_0(float x_3)
{
    float _S103 = abs(x_3);
    bool _S104 = _S103 > 0.5f;
    float _S105;
    if(_S104)
    {
        _S105 = 0.5f * (1.0f - _S103);
    }
    else
    {
        _S105 = _S103 * _S103;
    }
    float _S106;
    if(_S104)
    {
        _S106 = sqrt(max(_S105, 0.0f));
    }
    else
    {
        _S106 = _S103;
    }
    float _S107 = ((((0.04216320067644119f * _S105 + 0.02418131195008755f) * _S105 + 0.04547002539038658f) * _S105 + 0.07495300471782684f) * _S105 + 0.16666752099990845f) * _S105 * _S106 + _S106;
    if(_S104)
    {
        _S105 = 1.57079637050628662f - 2.0f * _S107;
    }
    else
    {
        _S105 = _S107;
    }
    if(x_3 < 0.0f)
    {
        _S105 = - _S105;
    }
    return _S105;
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

Albedos_0 albedos_of_0(Family_0 family_8, uint thread_8)
{
    uint _S108 = family_8.albedo_table_0 + family_8.albedo_stride_0 * thread_8;
    Albedos_0 albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(_S108);
    albedos_0.diffuse_transmit_0 = table_colour_0(_S108 + 3U);
    albedos_0.specular_reflect_0 = table_colour_0(_S108 + 6U);
    albedos_0.specular_transmit_0 = table_colour_0(_S108 + 9U);
    return albedos_0;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S109 = room_0 / max(albedo_0, (float3)9.99999997475242708e-07f);
    return min(gain_1, max(min(min(_S109.x, _S109.y), _S109.z), 0.0f));
}

float natural_logarithm_0(float x_4)
{
    uint _S110 = asuint(x_4);
    float exponent_0 = float(int(_S110 >> int(23)) - int(126));
    float m_0 = asfloat((_S110 & 8388607U) | 1056964608U);
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
    float _S111 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S111 - exponent_1 * 0.00021219444170129f - 0.5f * _S111) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_10, uint cell_5, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_5, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float3 towards_light_0(Light_0 light_0, float3 position_4, out float3 irradiance_0)
{
    irradiance_0 = float3(light_0.red_0, light_0.green_0, light_0.blue_0);
    float3 _S112 = float3(light_0.x_1, light_0.y_1, light_0.z_1);
    if((light_0.is_point_0) == 0U)
    {
        return _S112;
    }
    float3 _S113 = _S112 - position_4;
    irradiance_0 = irradiance_0 / max(square_0(_S113), 9.999999960041972e-13f);
    return normalize(_S113);
}

float diffuse_reflection_0(float3 light_1, float3 normal_1, float blend_0)
{
    float _S114 = light_1.z;
    if(_S114 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp(max(_S114, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_0);
}

float projected_area_0(float3 direction_3, float3 tangent_0, float roughness_1)
{
    float _S115 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S115 * _S115 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S116 = clamp(x_5, -87.0f, 88.0f);
    float _S117 = floor(_S116 * 1.4426950216293335f + 0.5f);
    float _S118 = _S116 - _S117 * 0.693359375f + _S117 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S118 + 0.00139819993637502f) * _S118 + 0.00833345204591751f) * _S118 + 0.04166579619050026f) * _S118 + 0.1666666567325592f) * _S118 + 0.5f;
    float _S119 = asfloat(uint(int(_S117) + int(127)) << int(23));
    float _S120;
    if(x_5 < -87.0f)
    {
        _S120 = 0.0f;
    }
    else
    {
        _S120 = (p_0 * _S118 * _S118 + _S118 + 1.0f) * _S119;
    }
    return _S120;
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
    float _S121 = roughness_2 * roughness_2;
    float _S122 = squared_along_0 * (1.0f - _S121) + _S121;
    return 0.31830987334251404f * _S121 * roughness_2 / (_S122 * _S122);
}

float density_between_0(float3 light_2, float3 view_1, float3 tangent_1, float roughness_3)
{
    float3 _S123 = light_2 + view_1;
    float _S124 = dot(_S123, tangent_1);
    return flake_density_0(min(_S124 * _S124 / max(square_0(_S123), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_2, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S125 = dot(light_3, normal_2);
    bool _S126;
    if(_S125 <= 0.0f)
    {
        _S126 = true;
    }
    else
    {
        _S126 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S126)
    {
        return 0.0f;
    }
    float _S127 = max(_S125, 9.99999997475242708e-07f);
    float _S128 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    float _S129 = projected_area_0(light_3, tangent_2, roughness_4) * _S128 + projected_area_0(view_2, tangent_2, roughness_4) * _S127;
    float _S130 = optical_depth_1 * _S129 / (_S127 * _S128);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S130 * mean_attenuation_0(_S130)) * _S127 / _S129;
}

float transmission_0(float3 light_4, float3 view_3, float3 normal_3, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S131 = - dot(light_4, normal_3);
    float _S132 = dot(view_3, normal_3);
    bool _S133;
    if(_S131 <= 0.0f)
    {
        _S133 = true;
    }
    else
    {
        _S133 = _S132 <= 0.0f;
    }
    if(_S133)
    {
        return 0.0f;
    }
    float _S134 = 1.0f / max(_S132, 9.99999997475242708e-07f);
    float _S135 = projected_area_0(light_4, tangent_3, roughness_5) / max(_S131, 9.99999997475242708e-07f);
    float _S136 = projected_area_0(view_3, tangent_3, roughness_5) * _S134;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S135, _S136)) * mean_attenuation_0(optical_depth_2 * abs(_S135 - _S136)) * _S134;
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
    float _S137 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S138 = 2.0f * sqrt(_S137) - 1.0f;
    float _S139 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S138, _S139), 0.00999999977648258f, 1.0f), clamp((1.0f - _S137) * sheen_shear_0(_S138, _S139), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S138, _S139), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_5, float3 view_4, float scale_0, float shear_0)
{
    float _S140 = light_5.z;
    bool _S141;
    if(_S140 <= 0.0f)
    {
        _S141 = true;
    }
    else
    {
        _S141 = (view_4.z) <= 0.0f;
    }
    if(_S141)
    {
        return 0.0f;
    }
    float2 _S142 = view_4.xy;
    float _S143 = dot(_S142, _S142);
    float2 _S144;
    if(_S143 > 9.99999968265522539e-21f)
    {
        _S144 = _S142 * rsqrt(_S143);
    }
    else
    {
        _S144 = float2(1.0f, 0.0f);
    }
    float _S145 = scale_0 * dot(light_5.xy, _S144) + shear_0 * _S140;
    float _S146 = scale_0 * (light_5.y * _S144.x - light_5.x * _S144.y);
    float _S147 = _S145 * _S145 + _S146 * _S146 + _S140 * _S140;
    return 0.31830987334251404f * scale_0 * scale_0 * _S140 / max(_S147 * _S147, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_6, float3 view_5, float strength_0, float roughness_7)
{
    float3 _S148 = sheen_lobe_0(view_5.z, roughness_7);
    float _S149 = strength_0 * _S148.z;
    return float2(_S149 * transformed_cosine_0(light_6, view_5, _S148.x, _S148.y), 1.0f - _S149);
}

VisiblePoint_0 visible_point_0(Frame_0 _S150, uint _S151, uint _S152, uint2 _S153)
{
    uint _S154 = 3U * _S152;
    Vertex_0 _S155 = vertices_0.Load(corners_0.Load(_S154));
    Vertex_0 _S156 = vertices_0.Load(corners_0.Load(_S154 + 1U));
    Vertex_0 _S157 = vertices_0.Load(corners_0.Load(_S154 + 2U));
    float3 _S158 = position_of_0(_S155);
    float3 _S159 = position_of_0(_S156) - _S158;
    float3 _S160 = position_of_0(_S157) - _S158;
    float3 _S161 = cross(_S159, _S160);
    float _S162 = 1.0f / max(square_0(_S161), 1.00000000317107685e-30f);
    float _S163 = float(_S150.width_0);
    float3 _S164 = camera_right_0(_S150) * (2.0f / _S163);
    float _S165 = float(_S150.height_0);
    float3 _S166 = camera_up_0(_S150) * (-2.0f / _S165);
    float3 _S167 = camera_forward_0(_S150) + (float(_S153.x) + 0.5f - 0.5f * _S163) * _S164 + (float(_S153.y) + 0.5f - 0.5f * _S165) * _S166;
    float _S168 = dot(_S167, _S161);
    float _S169;
    if((abs(_S168)) > 1.00000000317107685e-30f)
    {
        _S169 = _S168;
    }
    else
    {
        _S169 = 1.00000000317107685e-30f;
    }
    float _S170 = 1.0f / _S169;
    float3 _S171 = _S158 - camera_origin_0(_S150);
    float _S172 = dot(_S171, _S161) * _S170;
    float3 _S173 = _S167 * _S172 - _S171;
    float3 _S174 = _S172 * (_S164 - _S167 * (dot(_S164, _S161) * _S170));
    float3 _S175 = _S172 * (_S166 - _S167 * (dot(_S166, _S161) * _S170));
    float3 _S176 = cross(_S160, _S161) * _S162;
    float3 _S177 = cross(_S161, _S159) * _S162;
    float _S178 = dot(_S173, _S176);
    float _S179 = dot(_S173, _S177);
    float _S180 = _S156.u_0 - _S155.u_0;
    float _S181 = _S156.v_0 - _S155.v_0;
    float2 _S182 = float2(_S180, _S181);
    float _S183 = _S157.u_0 - _S155.u_0;
    float _S184 = _S157.v_0 - _S155.v_0;
    float2 _S185 = float2(_S183, _S184);
    float2 _S186 = float2(_S155.u_0, _S155.v_0) + _S178 * _S182 + _S179 * _S185;
    float2 _S187 = dot(_S174, _S176) * _S182 + dot(_S174, _S177) * _S185;
    float2 _S188 = dot(_S175, _S176) * _S182 + dot(_S175, _S177) * _S185;
    if((_S180 * _S184 - _S181 * _S183) < 0.0f)
    {
        _S169 = -1.0f;
    }
    else
    {
        _S169 = 1.0f;
    }
    float3 _S189 = _S169 * (_S184 * _S159 - _S181 * _S160);
    float3 _S190 = _S169 * (_S180 * _S160 - _S183 * _S159);
    VisiblePoint_0 point_1;
    float3 _S191 = normalize((1.0f - _S178 - _S179) * normal_of_0(_S155) + _S178 * normal_of_0(_S156) + _S179 * normal_of_0(_S157));
    point_1.normal_0 = _S191;
    float3 _S192 = normalize(_S189 - _S191 * dot(_S191, _S189));
    point_1.axis_x_0 = _S192;
    point_1.axis_y_0 = cross(_S191, _S192);
    point_1.position_0 = _S158 + _S173;
    point_1.view_0 = - normalize(_S167);
    bool _S193 = (dot(cross(_S189, _S190), _S191)) < 0.0f;
    float _S194 = fabrics_0[_S151].uv_width_0;
    if(_S193)
    {
        _S169 = - fabrics_0[_S151].uv_height_0;
    }
    else
    {
        _S169 = fabrics_0[_S151].uv_height_0;
    }
    float2 _S195 = float2(_S194, _S169);
    float2 _S196 = _S186 * _S195;
    if(_S193)
    {
        _S169 = fabrics_0[_S151].uv_height_0;
    }
    else
    {
        _S169 = 0.0f;
    }
    point_1.draft_0 = _S196 + float2(0.0f, _S169);
    point_1.draft_dx_0 = _S187 * _S195;
    point_1.draft_dy_0 = _S188 * _S195;
    return point_1;
}

struct YarnPoint_0
{
    bool back_2;
    bool hole_2;
    float x_9;
    float y_5;
    float height_4;
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
    float height_5;
};

float steps_per_length_0(uint _S197, float3 _S198)
{
    return max(max(abs(_S198.x) * fabrics_0[_S197].threads_per_x_0, abs(_S198.y) * fabrics_0[_S197].threads_per_y_0) * 5.0f, abs(_S198.z) * fabrics_0[_S197].per_relief_0 * 8.0f);
}

struct ViewRayEnd_0
{
    float height_6;
    float last_step_0;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_3;
};

float max_height_along_0(uint _S199, float _S200, float _S201, float _S202, float3 _S203, bool _S204)
{
    uint _S205 = locate_0(fabrics_0[_S199].warp_0, _S200).thread_1 / 2U;
    uint _S206 = locate_0(fabrics_0[_S199].weft_0, _S201).thread_1 / 2U;
    float _S207 = _S203.x;
    uint _S208;
    if(_S207 > 0.0f)
    {
        _S208 = 1U;
    }
    else
    {
        _S208 = 0U;
    }
    float _S209 = _S203.y;
    uint _S210;
    if(_S209 > 0.0f)
    {
        _S210 = 2U;
    }
    else
    {
        _S210 = 0U;
    }
    uint _S211 = words_0.Load(fabrics_0[_S199].max_heights_0 + 4U * (_S206 * fabrics_0[_S199].max_height_columns_0 + _S205) + (_S208 + _S210));
    int number_0;
    if(_S204)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S212 = _S211 >> number_0;
    float _S213 = max(abs(_S207) * fabrics_0[_S199].threads_per_x_0, abs(_S209) * fabrics_0[_S199].threads_per_y_0) / _S203.z;
    float _S214 = fabrics_0[_S199].height_high_0;
    float max_height_0 = fabrics_0[_S199].height_high_0;
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
        if(((max_height_0 - _S202) * _S213) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S212 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S214);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

Crossing_0 crossing_at_0(uint _S215, float _S216, float _S217, bool _S218)
{
    Crossing_0 crossing_2;
    crossing_2.warp_1 = locate_0(fabrics_0[_S215].warp_0, _S216);
    crossing_2.weft_1 = locate_0(fabrics_0[_S215].weft_0, _S217);
    uint _S219 = fabrics_0[_S215].run_words_0 + 2U * (crossing_2.weft_1.thread_1 * fabrics_0[_S215].ends_0 + crossing_2.warp_1.thread_1);
    uint _S220 = words_0.Load(_S219);
    crossing_2.warp_word_0 = _S220;
    crossing_2.weft_word_0 = words_0.Load(_S219 + 1U);
    crossing_2.warp_above_0 = ((_S220 & 1U) == 1U) != _S218;
    return crossing_2;
}

float cell_maximum_0(uint _S221, Crossing_0 _S222)
{
    if(_S222.warp_above_0)
    {
        return float((_S222.warp_word_0) >> int(28)) * fabrics_0[_S221].warp_0.height_scale_0 * fabrics_0[_S221].warp_0.level_0;
    }
    return float((_S222.weft_word_0) >> int(28)) * fabrics_0[_S221].weft_0.height_scale_0 * fabrics_0[_S221].weft_0.level_0;
}

float3 cell_bounds_0(uint _S223, float _S224, float _S225, bool _S226, bool _S227, bool _S228)
{
    Crossing_0 _S229 = crossing_at_0(_S223, _S224, _S225, _S226);
    float _S230 = cell_maximum_0(_S223, _S229);
    float _S231;
    if(_S227)
    {
        _S231 = _S229.warp_1.above_0;
    }
    else
    {
        _S231 = _S229.warp_1.below_0;
    }
    float _S232;
    if(_S228)
    {
        _S232 = _S229.weft_1.above_0;
    }
    else
    {
        _S232 = _S229.weft_1.below_0;
    }
    return float3(_S230, _S231, _S232);
}

float first_sample_height_0(uint _S233, ViewRay_0 _S234, StepControl_0 _S235, bool _S236)
{
    float _S237 = max_height_along_0(_S233, _S234.origin_0.x, _S234.origin_0.y, 0.0f, float3(_S234.slope_0, 1.0f), _S236);
    uint count_1 = 0U;
    float height_7 = _S237;
    for(;;)
    {
        if(count_1 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S238 = ViewRay_at_0(_S234, height_7);
        float3 _S239 = cell_bounds_0(_S233, _S238.x, _S238.y, _S236, _S235.right_0, _S235.up_0);
        float _S240 = height_7 - _S239.x;
        float _S241 = StepControl_to_cell_exit_0(_S235, _S239.y, _S239.z);
        float height_8 = height_7 - clamp(_S240, 0.0f, _S241);
        if(_S240 <= _S241)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

Sample_0 sample_at_0(uint _S242, float _S243, float _S244, bool _S245)
{
    Sample_0 sample_1;
    Crossing_0 _S246 = crossing_at_0(_S242, _S243, _S244, _S245);
    sample_1.crossing_1 = _S246;
    sample_1.shown_2 = shown_at_0(_S246, _S245);
    if(sample_1.shown_2.is_warp_0)
    {
        shape_0(fabrics_0[_S242].warp_0, fabrics_0[_S242].weft_0, sample_1.crossing_1.warp_1, sample_1.crossing_1.weft_1, sample_1);
    }
    else
    {
        shape_0(fabrics_0[_S242].weft_0, fabrics_0[_S242].warp_0, sample_1.crossing_1.weft_1, sample_1.crossing_1.warp_1, sample_1);
    }
    return sample_1;
}

Probe_0 probe_0(uint _S247, float _S248, float _S249, bool _S250, bool _S251, bool _S252)
{
    Sample_0 _S253 = sample_at_0(_S247, _S248, _S249, _S250);
    Probe_0 probe_1;
    probe_1.height_3 = _S253.height_2;
    probe_1.hole_1 = _S253.shown_2.hole_0;
    probe_1.slope_x_1 = _S253.slope_x_0;
    probe_1.slope_y_1 = _S253.slope_y_0;
    uint _S254;
    if(_S253.shown_2.is_warp_0)
    {
        _S254 = _S253.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S254 = _S253.crossing_1.weft_1.thread_1 * 2U;
    }
    probe_1.yarn_1 = _S254;
    probe_1.cell_max_0 = cell_maximum_0(_S247, _S253.crossing_1);
    float _S255;
    if(_S251)
    {
        _S255 = _S253.crossing_1.warp_1.above_0;
    }
    else
    {
        _S255 = _S253.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_1 = _S255;
    if(_S252)
    {
        _S255 = _S253.crossing_1.weft_1.above_0;
    }
    else
    {
        _S255 = _S253.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_1 = _S255;
    probe_1.edge_x_0 = outline_distance_0(_S253.crossing_1.warp_1, _S253.shown_2, _S253.run_2, !_S253.shown_2.is_warp_0, _S251);
    probe_1.edge_y_0 = outline_distance_0(_S253.crossing_1.weft_1, _S253.shown_2, _S253.run_2, _S253.shown_2.is_warp_0, _S252);
    return probe_1;
}

ViewRayEnd_0 search_down_0(uint _S256, ViewRay_0 _S257, StepControl_0 _S258, bool _S259)
{
    float _S260 = fabrics_0[_S256].height_low_0 - (fabrics_0[_S256].height_high_0 - fabrics_0[_S256].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_6 = first_sample_height_0(_S256, _S257, _S258, _S259);
    end_1.last_step_0 = _S258.epsilon_0;
    end_1.previous_3 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    uint count_2 = 0U;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S261 = ViewRay_at_0(_S257, end_1.height_6);
        Probe_0 _S262 = probe_0(_S256, _S261.x, _S261.y, _S259, _S258.right_0, _S258.up_0);
        float _S263 = end_1.height_6 - _S262.height_3;
        float _S264 = ViewRay_rate_0(_S257, _S262);
        end_1.depth_1 = - _S263;
        end_1.rate_4 = _S264;
        bool _S265;
        if(end_1.previous_3.known_0)
        {
            _S265 = !_S262.hole_1;
        }
        else
        {
            _S265 = false;
        }
        bool _S266;
        if(_S265)
        {
            _S266 = (end_1.previous_3.yarn_0) == (_S262.yarn_1);
        }
        else
        {
            _S266 = false;
        }
        end_1.smooth_0 = _S266;
        bool _S267;
        if(!_S262.hole_1)
        {
            _S267 = _S263 <= 0.0f;
        }
        else
        {
            _S267 = false;
        }
        bool _S268;
        if(_S267)
        {
            _S268 = true;
        }
        else
        {
            _S268 = (end_1.height_6) <= _S260;
        }
        if(_S268)
        {
            break;
        }
        float _S269 = way_back_to_dip_0(end_1.previous_3, _S263, _S264, end_1.last_step_0, _S262);
        if(_S269 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S269;
            end_1.last_step_0 = end_1.last_step_0 - _S269;
            count_2 = count_2 + 1U;
            continue;
        }
        float _S270 = min(StepControl_to_cell_exit_0(_S258, _S262.side_x_1, _S262.side_y_1), end_1.height_6 - _S262.cell_max_0);
        float _S271 = StepControl_to_next_sample_0(_S258, _S262, _S263, _S264);
        end_1.previous_3 = after_sample_0(_S263, _S264, _S262, _S270 > _S271);
        float _S272 = max(_S270, _S271);
        end_1.last_step_0 = _S272;
        end_1.height_6 = end_1.height_6 - _S272;
        count_2 = count_2 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S273, ViewRay_0 _S274, StepControl_0 _S275, bool _S276, ViewRayEnd_0 _S277)
{
    float _S278 = fabrics_0[_S273].height_high_0 - fabrics_0[_S273].height_low_0;
    float above_2 = _S277.height_6 + _S277.last_step_0;
    float above_gap_1 = clamp(_S277.previous_3.clearance_0, 0.0f, _S278);
    float under_gap_1 = clamp(_S277.depth_1, 0.0f, _S278);
    float _S279 = cubic_root_0(above_gap_1, - under_gap_1, _S277.previous_3.rate_0 * _S277.last_step_0, _S277.rate_4 * _S277.last_step_0);
    float middle_0;
    if(_S277.smooth_0)
    {
        middle_0 = above_2 - _S279 * _S277.last_step_0;
    }
    else
    {
        middle_0 = between_0(above_2, _S277.height_6, above_gap_1, under_gap_1);
    }
    float side_0 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S277.height_6;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < 2U)
        {
        }
        else
        {
            break;
        }
        float2 _S280 = ViewRay_at_0(_S274, middle_0);
        Probe_0 _S281 = probe_0(_S273, _S280.x, _S280.y, _S276, _S275.right_0, _S275.up_0);
        float _S282;
        if(_S281.hole_1)
        {
            _S282 = -1.0e+09f;
        }
        else
        {
            _S282 = _S281.height_3;
        }
        float _S283 = clamp(middle_0 - _S282, - _S278, _S278);
        float _S284;
        if(_S283 <= 0.0f)
        {
            if(side_0 > 0.0f)
            {
                _S284 = 0.5f * above_gap_2;
            }
            else
            {
                _S284 = above_gap_2;
            }
            float _S285 = - _S283;
            under_1 = middle_0;
            above_gap_2 = _S284;
            under_gap_2 = _S285;
            side_0 = 1.0f;
        }
        else
        {
            if(side_0 < 0.0f)
            {
                _S284 = 0.5f * under_gap_2;
            }
            else
            {
                _S284 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S283;
            under_gap_2 = _S284;
            side_0 = -1.0f;
        }
        if(_S277.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S283 / min(ViewRay_rate_0(_S274, _S281), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S277.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

bool is_free_0(uint _S286, float3 _S287, float3 _S288, bool _S289, float _S290)
{
    float _S291 = _S288.z;
    if(_S291 <= 0.0f)
    {
        return false;
    }
    float _S292 = 1.0f / max(steps_per_length_0(_S286, _S288), 9.99999971718068537e-10f);
    StepControl_0 _S293 = step_control_0(_S288.xy, _S292);
    PreviousSample_0 previous_4 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_1 = 0.0f;
    for(;;)
    {
        bool _S294;
        if(count_3 < 1024U)
        {
            _S294 = (_S287.z + _S291 * distance_1) < _S290;
        }
        else
        {
            _S294 = false;
        }
        if(_S294)
        {
        }
        else
        {
            break;
        }
        float3 _S295 = _S287 + _S288 * distance_1;
        Probe_0 _S296 = probe_0(_S286, _S295.x, _S295.y, _S289, _S293.right_0, _S293.up_0);
        float _S297 = _S295.z;
        float _S298 = _S297 - _S296.height_3;
        float _S299 = _S291 - _S296.slope_x_1 * _S288.x - _S296.slope_y_1 * _S288.y;
        bool _S300;
        if(!_S296.hole_1)
        {
            _S300 = _S298 < 0.0f;
        }
        else
        {
            _S300 = false;
        }
        if(_S300)
        {
            return false;
        }
        float _S301 = way_back_to_dip_0(previous_4, _S298, _S299, last_step_1, _S296);
        if(_S301 >= 0.0f)
        {
            float last_step_2 = last_step_1 - _S301;
            distance_1 = distance_1 - _S301;
            last_step_1 = last_step_2;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S302 = _S297 > (_S296.cell_max_0);
        PreviousSample_0 _S303 = after_sample_0(_S298, _S299, _S296, _S302);
        float last_step_3;
        if(_S302)
        {
            last_step_3 = max(StepControl_to_cell_exit_0(_S293, _S296.side_x_1, _S296.side_y_1), _S292);
        }
        else
        {
            last_step_3 = StepControl_to_next_sample_0(_S293, _S296, _S298, _S299);
        }
        float distance_2 = distance_1 + last_step_3;
        previous_4 = _S303;
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S304, float _S305, float _S306, float3 _S307, bool _S308)
{
    if(!sample_at_0(_S304, _S305, _S306, _S308).shown_2.hole_0)
    {
        return false;
    }
    float3 _S309 = float3(_S305, _S306, 0.0f);
    float _S310 = fabrics_0[_S304].height_high_0;
    if(!is_free_0(_S304, _S309, _S307, _S308, fabrics_0[_S304].height_high_0))
    {
        return false;
    }
    return is_free_0(_S304, _S309, float3(- _S307.x, - _S307.y, _S307.z), !_S308, _S310);
}

Hit_0 first_hit_0(uint _S311, float _S312, float _S313, float3 _S314, bool _S315)
{
    float _S316 = max(_S314.z, 0.00009999999747379f);
    ViewRay_0 ray_0;
    ray_0.origin_0 = float2(_S312, _S313);
    float2 _S317 = _S314.xy / _S316;
    ray_0.slope_0 = _S317;
    StepControl_0 _S318 = step_control_0(- _S317, 1.0f / max(steps_per_length_0(_S311, _S314) / _S316, 9.99999971718068537e-10f));
    Hit_0 hit_0;
    float _S319 = refined_height_0(_S311, ray_0, _S318, _S315, search_down_0(_S311, ray_0, _S318, _S315));
    hit_0.height_5 = _S319;
    float2 _S320 = ViewRay_at_0(ray_0, _S319);
    hit_0.x_10 = _S320.x;
    hit_0.y_6 = _S320.y;
    bool _S321;
    if(_S319 <= 0.0f)
    {
        _S321 = passes_through_0(_S311, _S312, _S313, _S314, _S315);
    }
    else
    {
        _S321 = false;
    }
    hit_0.hole_3 = _S321;
    return hit_0;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_9;
    float3 normal_5;
    float3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S322, float _S323, float _S324, bool _S325)
{
    Sample_0 _S326 = sample_at_0(_S322, _S323, _S324, _S325);
    float _S327;
    if(_S326.shown_2.is_warp_0)
    {
        _S327 = _S326.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S327 = _S326.crossing_1.weft_1.half_width_1;
    }
    float _S328;
    if(_S326.shown_2.is_warp_0)
    {
        _S328 = fabrics_0[_S322].warp_0.twist_sine_0;
    }
    else
    {
        _S328 = fabrics_0[_S322].weft_0.twist_sine_0;
    }
    float _S329;
    if(_S325)
    {
        _S329 = -1.0f;
    }
    else
    {
        _S329 = 1.0f;
    }
    float _S330 = _S328 * _S329;
    if(_S326.shown_2.is_warp_0)
    {
        _S328 = fabrics_0[_S322].warp_0.twist_cosine_0;
    }
    else
    {
        _S328 = fabrics_0[_S322].weft_0.twist_cosine_0;
    }
    if(_S326.shown_2.is_warp_0)
    {
        _S329 = 1.0f;
    }
    else
    {
        _S329 = -1.0f;
    }
    float2 _S331 = fibre_direction_0(_S326.slope_across_0, _S329 * _S326.slope_along_0, _S330, _S328);
    float _S332;
    if(_S326.shown_2.is_warp_0)
    {
        _S332 = _S326.slope_x_0;
    }
    else
    {
        _S332 = _S326.slope_y_0;
    }
    float _S333;
    if(_S326.shown_2.is_warp_0)
    {
        _S333 = _S326.slope_y_0;
    }
    else
    {
        _S333 = _S326.slope_x_0;
    }
    float _S334 = _S331.x;
    float _S335 = _S331.y;
    float _S336 = _S332 * _S334 + _S329 * _S333 * _S335;
    float _S337 = _S327 * 1.0154266357421875f;
    float _S338 = _S337 * arc_sine_0(clamp(_S326.section_1.across_1 / _S337, -1.0f, 1.0f));
    if(_S326.shown_2.is_warp_0)
    {
        _S327 = _S324;
    }
    else
    {
        _S327 = - _S323;
    }
    SurfacePoint_0 point_2;
    point_2.hole_4 = _S326.shown_2.hole_0;
    point_2.is_warp_1 = _S326.shown_2.is_warp_0;
    point_2.warp_thread_0 = _S326.crossing_1.warp_1.thread_1;
    point_2.weft_thread_0 = _S326.crossing_1.weft_1.thread_1;
    point_2.height_9 = _S326.height_2;
    point_2.normal_5 = normalize(float3(- _S326.slope_x_0, - _S326.slope_y_0, 1.0f));
    float3 _S339;
    if(_S326.shown_2.is_warp_0)
    {
        _S339 = float3(_S334, _S335, _S336);
    }
    else
    {
        _S339 = float3(- _S335, _S334, _S336);
    }
    point_2.tangent_5 = normalize(_S339);
    point_2.across_2 = _S326.section_1.across_1;
    point_2.fibre_across_0 = _S338 * _S328 + _S327 * _S330;
    point_2.fibre_along_0 = _S327 * _S328 - _S338 * _S330;
    return point_2;
}

Albedos_0 vary_albedos_0(uint _S340, Albedos_0 _S341, uint _S342, uint _S343)
{
    float3 _S344 = max(_S341.specular_reflect_0, _S341.specular_transmit_0);
    float3 _S345 = _S341.diffuse_reflect_0 + _S341.diffuse_transmit_0;
    float _S346 = bounded_gain_0(thread_gain_0(_S342, fabrics_0[_S340].colour_noise_0, fabrics_0[_S340].seed_0), _S345, 1.0f - fabrics_0[_S340].layer_bound_0 * _S344);
    float _S347 = bounded_gain_0(fibre_gain_0(_S342, _S343, fabrics_0[_S340].fibre_noise_0, fabrics_0[_S340].seed_0), _S344, min((1.0f - _S346 * _S345) / fabrics_0[_S340].layer_bound_0, (float3)1.0f));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S346 * _S341.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S346 * _S341.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S347 * _S341.specular_reflect_0;
    varied_0.specular_transmit_0 = _S347 * _S341.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S348, SurfacePoint_0 _S349, Albedos_0 _S350, float _S351, float _S352)
{
    float _S353;
    if(_S349.is_warp_1)
    {
        _S353 = _S351;
    }
    else
    {
        _S353 = _S352;
    }
    float _S354 = _S353 - _S349.across_2;
    if(_S349.is_warp_1)
    {
        _S353 = fabrics_0[_S348].warp_0.period_0;
    }
    else
    {
        _S353 = fabrics_0[_S348].weft_0.period_0;
    }
    float _S355;
    if(_S349.is_warp_1)
    {
        _S355 = fabrics_0[_S348].warp_0.count_0;
    }
    else
    {
        _S355 = fabrics_0[_S348].weft_0.count_0;
    }
    int _S356 = int(_S355);
    uint _S357;
    if(_S349.is_warp_1)
    {
        _S357 = _S349.warp_thread_0;
    }
    else
    {
        _S357 = _S349.weft_thread_0;
    }
    uint _S358 = uint(int(floor(_S354 / _S353)) * _S356 + int(_S357)) * 2U;
    if(_S349.is_warp_1)
    {
        _S357 = 1U;
    }
    else
    {
        _S357 = 0U;
    }
    float _S359 = floor(_S349.fibre_across_0 / fabrics_0[_S348].fibre_size_0);
    return vary_albedos_0(_S348, _S350, _S358 + _S357, uint(int(_S359)) * 65536U + uint(int(floor(_S349.fibre_along_0 / (fabrics_0[_S348].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S359))));
}

YarnPoint_0 yarn_point_at_0(uint _S360, float _S361, float _S362, bool _S363, bool _S364)
{
    SurfacePoint_0 _S365 = surface_at_0(_S360, _S361, _S362, _S363);
    Albedos_0 albedos_2;
    if(_S365.is_warp_1)
    {
        albedos_2 = albedos_of_0(fabrics_0[_S360].warp_0, _S365.warp_thread_0);
    }
    else
    {
        albedos_2 = albedos_of_0(fabrics_0[_S360].weft_0, _S365.weft_thread_0);
    }
    bool _S366;
    if((fabrics_0[_S360].fibre_noise_0) > 0.0f)
    {
        _S366 = true;
    }
    else
    {
        _S366 = (fabrics_0[_S360].colour_noise_0) > 0.0f;
    }
    if(_S366)
    {
        albedos_2 = varied_at_0(_S360, _S365, albedos_2, _S361, _S362);
    }
    YarnPoint_0 point_3;
    point_3.back_2 = _S363;
    point_3.hole_2 = _S364;
    point_3.x_9 = _S361;
    point_3.y_5 = _S362;
    point_3.height_4 = _S365.height_9;
    point_3.normal_4 = _S365.normal_5;
    point_3.tangent_4 = _S365.tangent_5;
    float _S367;
    if(_S365.is_warp_1)
    {
        _S367 = fabrics_0[_S360].warp_0.roughness_0;
    }
    else
    {
        _S367 = fabrics_0[_S360].weft_0.roughness_0;
    }
    point_3.roughness_8 = _S367;
    point_3.albedos_1 = albedos_2;
    return point_3;
}

YarnPoint_0 locate_yarn_0(uint _S368, float _S369, float _S370, float3 _S371)
{
    bool _S372 = (_S371.z) < 0.0f;
    Hit_0 _S373 = first_hit_0(_S368, _S369, _S370, to_face_frame_0(_S371, _S372), _S372);
    return yarn_point_at_0(_S368, _S373.x_10, _S373.y_6, _S372, _S373.hole_3);
}

float3 scattered_0(uint _S374, YarnPoint_0 _S375, float3 _S376, float3 _S377)
{
    float3 _S378 = (float3)0.0f;
    bool _S379 = !_S375.hole_2;
    bool _S380;
    if(_S379)
    {
        _S380 = (_S376.z) > 0.0f;
    }
    else
    {
        _S380 = false;
    }
    float3 value_1;
    if(_S380)
    {
        value_1 = _S375.albedos_1.diffuse_reflect_0 * diffuse_reflection_0(_S376, _S375.normal_4, fabrics_0[_S374].diffuse_blend_0) + _S375.albedos_1.specular_reflect_0 * reflection_0(_S376, _S377, _S375.normal_4, _S375.tangent_4, _S375.roughness_8, fabrics_0[_S374].optical_depth_0);
    }
    else
    {
        if(_S379)
        {
            _S380 = (_S376.z) < 0.0f;
        }
        else
        {
            _S380 = false;
        }
        if(_S380)
        {
            value_1 = _S375.albedos_1.diffuse_transmit_0 * diffuse_reflection_0(- _S376, _S375.normal_4, fabrics_0[_S374].diffuse_blend_0) + _S375.albedos_1.specular_transmit_0 * transmission_0(_S376, _S377, _S375.normal_4, _S375.tangent_4, _S375.roughness_8, fabrics_0[_S374].optical_depth_0);
        }
        else
        {
            value_1 = _S378;
        }
    }
    float _S381 = fabrics_0[_S374].sheen_strength_0;
    if((fabrics_0[_S374].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S382 = sheen_with_transmittance_0(_S376, _S377, _S381, fabrics_0[_S374].sheen_roughness_0);
    return _S382.y * value_1 + _S382.x;
}

bool unoccluded_0(uint _S383, float _S384, float _S385, float _S386, float3 _S387, bool _S388)
{
    if((_S387.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S383, float3(_S384, _S385, _S386 + fabrics_0[_S383].lift_0), _S387, _S388, max_height_along_0(_S383, _S384, _S385, _S386, _S387, _S388));
}

bool is_lit_0(uint _S389, YarnPoint_0 _S390, float3 _S391)
{
    if(_S390.hole_2)
    {
        return true;
    }
    float3 _S392 = to_face_frame_0(_S391, _S390.back_2);
    float _S393 = _S392.z;
    bool _S394 = _S393 < 0.0f;
    float3 normal_6;
    float height_10;
    if(_S394)
    {
        SurfacePoint_0 _S395 = surface_at_0(_S389, _S390.x_9, _S390.y_5, !_S390.back_2);
        normal_6 = _S395.normal_5;
        height_10 = _S395.height_9;
    }
    else
    {
        normal_6 = _S390.normal_4;
        height_10 = _S390.height_4;
    }
    float3 _S396 = float3(_S392.xy, abs(_S393));
    if((dot(normal_6, _S396)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S389, _S390.x_9, _S390.y_5, height_10, _S396, (_S390.back_2) != _S394);
}

float3 evaluate_0(uint _S397, YarnPoint_0 _S398, float3 _S399, float3 _S400)
{
    float3 _S401 = scattered_0(_S397, _S398, to_face_frame_0(_S399, _S398.back_2), to_face_frame_0(_S400, _S398.back_2));
    bool _S402;
    if((max(_S401.x, max(_S401.y, _S401.z))) <= 0.0f)
    {
        _S402 = true;
    }
    else
    {
        _S402 = !is_lit_0(_S397, _S398, _S399);
    }
    if(_S402)
    {
        return (float3)0.0f;
    }
    return _S401;
}

float straight_through_0(uint _S403, YarnPoint_0 _S404, float3 _S405)
{
    if(!_S404.hole_2)
    {
        return 0.0f;
    }
    float _S406 = fabrics_0[_S403].sheen_strength_0;
    if((fabrics_0[_S403].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S406 * sheen_lobe_0(abs(_S405.z), fabrics_0[_S403].sheen_roughness_0).z;
}

float4 direct_light_0(Frame_0 _S407, uint _S408, VisiblePoint_0 _S409, float2 _S410)
{
    float3 _S411 = to_local_0(_S409, _S409.view_0);
    YarnPoint_0 _S412 = locate_yarn_0(_S408, _S410.x, _S410.y, _S411);
    float3 _S413 = (float3)0.0f;
    uint number_1 = 0U;
    float3 radiance_1 = _S413;
    for(;;)
    {
        if(number_1 < (_S407.lights_0))
        {
        }
        else
        {
            break;
        }
        float3 irradiance_1;
        float3 _S414 = towards_light_0(lights_1.Load(number_1), _S409.position_0, irradiance_1);
        float3 radiance_2 = radiance_1 + irradiance_1 * evaluate_0(_S408, _S412, to_local_0(_S409, _S414), _S411);
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    return float4(radiance_1, 1.0f - straight_through_0(_S408, _S412, _S411));
}

[numthreads(8, 8, 1)]
void shade(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S415;
    Frame_0 _S416 = frames_0.Load(int(0));
    bool _S417;
    if((id_0.x) >= (_S416.width_0))
    {
        _S417 = true;
    }
    else
    {
        _S417 = (id_0.y) >= (_S416.height_0);
    }
    if(_S417)
    {
        return;
    }
    uint2 _S418 = id_0.xy;
    uint _S419 = _S418.y * _S416.width_0 + _S418.x;
    uint _S420 = visible_faces_0.Load(int3(int2(_S418), int(0)));
    float4 sum_0 = (float4)0.0f;
    if(_S420 > 0U)
    {
        uint _S421 = _S420 - 1U;
        uint _S422 = face_fabrics_0.Load(_S421);
        VisiblePoint_0 _S423 = visible_point_0(_S416, _S422, _S421, _S418);
        uint k_0 = 0U;
        for(;;)
        {
            _S415 = _S416.samples_0;
            if(k_0 < (_S416.samples_0))
            {
            }
            else
            {
                break;
            }
            float2 _S424 = footprint_sample_0(_S418, _S416.pass_number_0 * _S416.samples_0 + k_0);
            sum_0 = sum_0 + direct_light_0(_S416, _S422, _S423, _S423.draft_0 + _S424.x * _S423.draft_dx_0 + _S424.y * _S423.draft_dy_0);
            k_0 = k_0 + 1U;
        }
        sum_0 = sum_0 / float(_S415);
    }
    sum_0.xyz = sum_0.xyz + (1.0f - sum_0.w) * float3(_S416.background_red_0, _S416.background_green_0, _S416.background_blue_0);
    float4 _S425;
    if((_S416.pass_number_0) == 0U)
    {
        _S425 = sum_0;
    }
    else
    {
        _S425 = radiance_0[_S419] + sum_0;
    }
    radiance_0[_S419] = _S425;
    return;
}

