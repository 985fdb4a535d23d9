#include <slang-cuda-prelude.h>
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

struct Light_0
{
    uint is_point_0;
    float x_0;
    float y_0;
    float z_0;
    float red_0;
    float green_0;
    float blue_0;
};

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

struct Vertex_0
{
    float x_1;
    float y_1;
    float z_1;
    float normal_x_0;
    float normal_y_0;
    float normal_z_0;
    float u_0;
    float v_0;
};

struct GlobalParams_0
{
    StructuredBuffer<Fabric_0> fabrics_0;
    StructuredBuffer<uint> words_0;
    StructuredBuffer<Light_0> lights_1;
    StructuredBuffer<Frame_0> frames_0;
    StructuredBuffer<Vertex_0> vertices_0;
    StructuredBuffer<uint> corners_0;
    StructuredBuffer<uint> face_fabrics_0;
    RWStructuredBuffer<float4 > radiance_0;
    RWStructuredBuffer<uint> pixels_0;
    CUtexObject visible_faces_0;
};

extern "C" __constant__ GlobalParams_0 SLANG_globalParams;
#define globalParams_0 (&SLANG_globalParams)
__device__ float dot_0(float3  x_2, float3  y_2)
{
    int i_0 = int(0);
    float result_0 = 0.0f;
    for(;;)
    {
        if(i_0 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_1 = result_0 + _slang_vector_get_element(x_2, i_0) * _slang_vector_get_element(y_2, i_0);
        i_0 = i_0 + int(1);
        result_0 = result_1;
    }
    return result_0;
}

__device__ float length_0(float3  x_3)
{
    return (F32_sqrt((dot_0(x_3, x_3))));
}

__device__ float dot_1(float2  x_4, float2  y_3)
{
    int i_1 = int(0);
    float result_2 = 0.0f;
    for(;;)
    {
        if(i_1 < int(2))
        {
        }
        else
        {
            break;
        }
        float result_3 = result_2 + _slang_vector_get_element(x_4, i_1) * _slang_vector_get_element(y_3, i_1);
        i_1 = i_1 + int(1);
        result_2 = result_3;
    }
    return result_2;
}

__device__ float clamp_0(float x_5, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_5), (minBound_0)))), (maxBound_0)));
}

__device__ float lerp_0(float x_6, float y_4, float s_0)
{
    return x_6 + (y_4 - x_6) * s_0;
}

__device__ float3  normalize_0(float3  x_7)
{
    return x_7 / make_float3 (length_0(x_7));
}

__device__ float3  min_0(float3  x_8, float3  y_5)
{
    float3  result_4;
    int i_2 = int(0);
    for(;;)
    {
        if(i_2 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_4, i_2) = (F32_min((_slang_vector_get_element(x_8, i_2)), (_slang_vector_get_element(y_5, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_4;
}

__device__ float3  max_0(float3  x_9, float3  y_6)
{
    float3  result_5;
    int i_3 = int(0);
    for(;;)
    {
        if(i_3 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_5, i_3) = (F32_max((_slang_vector_get_element(x_9, i_3)), (_slang_vector_get_element(y_6, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_5;
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float2  frac_0(float2  x_10)
{
    float2  result_6;
    int i_4 = int(0);
    for(;;)
    {
        if(i_4 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_6, i_4) = (F32_frac((_slang_vector_get_element(x_10, i_4))));
        i_4 = i_4 + int(1);
    }
    return result_6;
}

__device__ float3  cross_0(float3  left_0, float3  right_0)
{
    float _S1 = left_0.y;
    float _S2 = right_0.z;
    float _S3 = left_0.z;
    float _S4 = right_0.y;
    float _S5 = right_0.x;
    float _S6 = left_0.x;
    return make_float3 (_S1 * _S2 - _S3 * _S4, _S3 * _S5 - _S6 * _S2, _S6 * _S4 - _S1 * _S5);
}

__device__ Frame_0 slang_ldg_0(Frame_0 * ptr_0)
{
    uint _S7 = __ldg(&ptr_0->width_0);
    uint _S8 = __ldg(&ptr_0->height_0);
    uint _S9 = __ldg(&ptr_0->lights_0);
    uint _S10 = __ldg(&ptr_0->samples_0);
    uint _S11 = __ldg(&ptr_0->pass_number_0);
    float _S12 = __ldg(&ptr_0->jitter_x_0);
    float _S13 = __ldg(&ptr_0->jitter_y_0);
    float _S14 = __ldg(&ptr_0->gain_0);
    float _S15 = __ldg(&ptr_0->origin_x_0);
    float _S16 = __ldg(&ptr_0->origin_y_0);
    float _S17 = __ldg(&ptr_0->origin_z_0);
    float _S18 = __ldg(&ptr_0->right_x_0);
    float _S19 = __ldg(&ptr_0->right_y_0);
    float _S20 = __ldg(&ptr_0->right_z_0);
    float _S21 = __ldg(&ptr_0->up_x_0);
    float _S22 = __ldg(&ptr_0->up_y_0);
    float _S23 = __ldg(&ptr_0->up_z_0);
    float _S24 = __ldg(&ptr_0->forward_x_0);
    float _S25 = __ldg(&ptr_0->forward_y_0);
    float _S26 = __ldg(&ptr_0->forward_z_0);
    float _S27 = __ldg(&ptr_0->near_0);
    float _S28 = __ldg(&ptr_0->background_red_0);
    float _S29 = __ldg(&ptr_0->background_green_0);
    float _S30 = __ldg(&ptr_0->background_blue_0);
    Frame_0 _S31 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30 };
    return _S31;
}

__device__ Family_0 slang_ldg_1(Family_0 * ptr_1)
{
    uint _S32 = __ldg(&ptr_1->is_alike_0);
    float _S33 = __ldg(&ptr_1->count_0);
    float _S34 = __ldg(&ptr_1->inverse_count_0);
    float _S35 = __ldg(&ptr_1->half_inverse_count_0);
    float _S36 = __ldg(&ptr_1->size_0);
    float _S37 = __ldg(&ptr_1->inverse_size_0);
    float _S38 = __ldg(&ptr_1->half_width_0);
    float _S39 = __ldg(&ptr_1->start_0);
    float _S40 = __ldg(&ptr_1->period_0);
    float _S41 = __ldg(&ptr_1->inverse_period_0);
    float _S42 = __ldg(&ptr_1->bins_0);
    uint _S43 = __ldg(&ptr_1->first_thread_table_0);
    uint _S44 = __ldg(&ptr_1->place_table_0);
    uint _S45 = __ldg(&ptr_1->bend_table_0);
    float _S46 = __ldg(&ptr_1->height_scale_0);
    float _S47 = __ldg(&ptr_1->twist_sine_0);
    float _S48 = __ldg(&ptr_1->twist_cosine_0);
    float _S49 = __ldg(&ptr_1->level_0);
    float _S50 = __ldg(&ptr_1->roughness_0);
    uint _S51 = __ldg(&ptr_1->albedo_table_0);
    uint _S52 = __ldg(&ptr_1->albedo_stride_0);
    Family_0 _S53 = { _S32, _S33, _S34, _S35, _S36, _S37, _S38, _S39, _S40, _S41, _S42, _S43, _S44, _S45, _S46, _S47, _S48, _S49, _S50, _S51, _S52 };
    return _S53;
}

__device__ Vertex_0 slang_ldg_2(Vertex_0 * ptr_2)
{
    float _S54 = __ldg(&ptr_2->x_1);
    float _S55 = __ldg(&ptr_2->y_1);
    float _S56 = __ldg(&ptr_2->z_1);
    float _S57 = __ldg(&ptr_2->normal_x_0);
    float _S58 = __ldg(&ptr_2->normal_y_0);
    float _S59 = __ldg(&ptr_2->normal_z_0);
    float _S60 = __ldg(&ptr_2->u_0);
    float _S61 = __ldg(&ptr_2->v_0);
    Vertex_0 _S62 = { _S54, _S55, _S56, _S57, _S58, _S59, _S60, _S61 };
    return _S62;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_0(v_1, v_1);
}

__device__ float3  camera_right_0(Frame_0 * frame_0)
{
    return make_float3 (frame_0->right_x_0, frame_0->right_y_0, frame_0->right_z_0);
}

__device__ float3  camera_up_0(Frame_0 * frame_1)
{
    return make_float3 (frame_1->up_x_0, frame_1->up_y_0, frame_1->up_z_0);
}

__device__ float3  camera_forward_0(Frame_0 * frame_2)
{
    return make_float3 (frame_2->forward_x_0, frame_2->forward_y_0, frame_2->forward_z_0);
}

__device__ float3  camera_origin_0(Frame_0 * frame_3)
{
    return make_float3 (frame_3->origin_x_0, frame_3->origin_y_0, frame_3->origin_z_0);
}

__device__ float3  normal_of_0(Vertex_0 * vertex_1)
{
    return make_float3 (vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S63 = value_0 * 747796405U + 2891336453U;
    uint _S64 = ((_S63 >> ((_S63 >> int(28)) + 4U)) ^ _S63) * 277803737U;
    return (_S64 >> int(22)) ^ _S64;
}

__device__ float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  footprint_sample_0(uint2  pixel_0, uint index_0)
{
    uint _S65 = pixel_0.x;
    uint _S66 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S65, _S66, 1U), uniform_hash_0(_S65, _S66, 2U)) + make_float2 (float(index_0 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f)) - make_float2 (0.5f);
}

struct VisiblePoint_0
{
    float3  position_0;
    float3  view_0;
    float3  axis_x_0;
    float3  axis_y_0;
    float3  normal_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_0)
{
    return make_float3 (dot_0(direction_0, point_0->axis_x_0), dot_0(direction_0, point_0->axis_y_0), dot_0(direction_0, point_0->normal_0));
}

__device__ float3  to_face_frame_0(float3  direction_1, bool back_0)
{
    float2  _S67 = float2 {direction_1.x, direction_1.y};
    float _S68;
    if(back_0)
    {
        _S68 = - direction_1.z;
    }
    else
    {
        _S68 = direction_1.z;
    }
    return make_float3 (_S67.x, _S67.y, _S68);
}

struct StepControl_0
{
    float step_0;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_1;
    bool up_0;
};

__device__ StepControl_0 step_control_0(float2  direction_2, float step_1)
{
    StepControl_0 control_0;
    (&control_0)->step_0 = step_1;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_1;
    float _S69 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S69)))), (9.99999971718068537e-10f)));
    float _S70 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S70)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S69 > 0.0f;
    (&control_0)->up_0 = _S70 > 0.0f;
    return control_0;
}

__device__ float2  turns_and_remainder_0(Family_0 * family_0, float index_1)
{
    float _S71 = (F32_floor(((F32_fma((index_1), (family_0->inverse_count_0), (family_0->half_inverse_count_0))))));
    return make_float2 (_S71, (F32_fma((- _S71), (family_0->count_0), (index_1))));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(Family_0 * family_1, float position_1)
{
    float _S72 = (F32_floor((position_1 * family_1->inverse_size_0)));
    Cell_0 cell_1;
    float _S73 = (F32_fma((- _S72), (family_1->size_0), (position_1)));
    (&cell_1)->below_0 = _S73;
    (&cell_1)->above_0 = family_1->size_0 - _S73;
    (&cell_1)->across_0 = _S73 - 0.5f * family_1->size_0;
    (&cell_1)->half_width_1 = family_1->half_width_0;
    float2  _S74 = turns_and_remainder_0(family_1, _S72);
    (&cell_1)->thread_1 = uint(clamp_0(_S74.y, 0.0f, family_1->count_0 - 1.0f));
    return cell_1;
}

__device__ float table_number_0(uint index_2)
{
    uint _S75 = __ldg((&(globalParams_0->words_0)[index_2]));
    return (U32_asfloat((_S75)));
}

__device__ Cell_0 locate_varied_0(Family_0 * family_2, float position_2)
{
    float turns_0 = (position_2 - family_2->start_0) * family_2->inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    float _S76 = turns_1 * family_2->period_0;
    uint _S77 = __ldg((&(globalParams_0->words_0)[family_2->first_thread_table_0 + uint(clamp_0(turns_1 * family_2->bins_0, 0.0f, family_2->bins_0 - 1.0f))]));
    uint _S78 = family_2->place_table_0;
    uint _S79;
    if(_S76 >= (table_number_0(family_2->place_table_0 + _S77 * 4U + 1U)))
    {
        _S79 = 1U;
    }
    else
    {
        _S79 = 0U;
    }
    uint _S80 = (U32_min((_S77 + _S79), (uint(family_2->count_0) - 1U)));
    uint _S81 = _S78 + _S80 * 4U;
    Cell_0 cell_2;
    (&cell_2)->thread_1 = _S80;
    (&cell_2)->below_0 = _S76 - table_number_0(_S81);
    (&cell_2)->above_0 = table_number_0(_S81 + 1U) - _S76;
    (&cell_2)->across_0 = _S76 - table_number_0(_S81 + 2U);
    (&cell_2)->half_width_1 = table_number_0(_S81 + 3U);
    return cell_2;
}

__device__ Cell_0 locate_0(Family_0 * family_3, float position_3)
{
    if((family_3->is_alike_0) != 0U)
    {
        Cell_0 _S82 = locate_alike_0(family_3, position_3);
        return _S82;
    }
    Cell_0 _S83 = locate_varied_0(family_3, position_3);
    return _S83;
}

struct ViewRay_0
{
    float2  origin_0;
    float2  slope_0;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_0, float height_1)
{
    return this_0->origin_0 + this_0->slope_0 * make_float2 (height_1);
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_0, float side_y_0)
{
    return (F32_max(((F32_min((side_x_0 * this_1->per_x_0), (side_y_0 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_0;
    bool known_0;
};

__device__ PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    (&previous_0)->clearance_0 = 0.0f;
    (&previous_0)->rate_0 = 0.0f;
    (&previous_0)->yarn_0 = 0U;
    (&previous_0)->known_0 = false;
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

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_1)
{
    bool _S84 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S85 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S86;
    if(_S84)
    {
        if(!_S85)
        {
            _S86 = true;
        }
        else
        {
            _S86 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S86 = false;
    }
    (&shown_0)->is_warp_0 = _S86;
    if(!_S84)
    {
        _S86 = !_S85;
    }
    else
    {
        _S86 = false;
    }
    (&shown_0)->hole_0 = _S86;
    uint _S87;
    if((&shown_0)->is_warp_0)
    {
        _S87 = crossing_0->warp_word_0;
    }
    else
    {
        _S87 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S87;
    (&shown_0)->on_top_0 = ((_S87 & 1U) == 1U) != back_1;
    return shown_0;
}

__device__ float boundary_0(Family_0 * family_4, uint thread_2, int step_2)
{
    float2  _S88 = turns_and_remainder_0(family_4, float(int(thread_2) + step_2));
    return (F32_fma((_S88.x), (family_4->period_0), (table_number_0(family_4->place_table_0 + uint(_S88.y) * 4U))));
}

__device__ float span_0(Family_0 * family_5, uint thread_3, int first_0, int last_0)
{
    if((family_5->is_alike_0) != 0U)
    {
        return float(last_0 - first_0) * family_5->size_0;
    }
    float _S89 = boundary_0(family_5, thread_3, last_0);
    float _S90 = boundary_0(family_5, thread_3, first_0);
    return _S89 - _S90;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(Family_0 * family_6, uint thread_4)
{
    uint _S91 = family_6->bend_table_0;
    uint _S92;
    if((family_6->is_alike_0) != 0U)
    {
        _S92 = 0U;
    }
    else
    {
        _S92 = thread_4 * 4U;
    }
    uint _S93 = _S91 + _S92;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S93);
    (&bend_0)->half_tangent_0 = table_number_0(_S93 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S93 + 2U);
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

__device__ Run_0 unpack_0(Family_0 * own_0, Family_0 * other_0, uint thread_5, Cell_0 * crossed_0, uint word_1)
{
    int _S94 = int((word_1 >> int(1)) & 127U);
    int _S95 = int((word_1 >> int(8)) & 127U);
    int _S96 = int((word_1 >> int(15)) & 63U);
    int _S97 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    float _S98 = crossed_0->below_0;
    uint _S99 = crossed_0->thread_1;
    int _S100 = - _S94;
    float _S101 = span_0(other_0, crossed_0->thread_1, _S100, int(0));
    float _S102 = _S98 + _S101;
    (&run_0)->from_start_0 = _S102;
    float _S103 = crossed_0->above_0;
    int _S104 = _S95 + int(1);
    float _S105 = span_0(other_0, _S99, int(1), _S104);
    float _S106 = _S103 + _S105;
    (&run_0)->to_end_0 = _S106;
    bool _S107 = _S102 < _S106;
    (&run_0)->near_start_0 = _S107;
    int _S108;
    if(_S107)
    {
        _S108 = _S100 - _S96;
    }
    else
    {
        _S108 = _S104;
    }
    int _S109;
    if((&run_0)->near_start_0)
    {
        _S109 = _S100;
    }
    else
    {
        _S109 = _S104 + _S97;
    }
    Bend_0 _S110 = bend_of_0(own_0, thread_5);
    (&run_0)->bend_1 = _S110;
    float _S111;
    if((&run_0)->straight_0)
    {
        _S111 = 1.0e+06f;
    }
    else
    {
        _S111 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S111;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    float _S112 = span_0(other_0, _S99, _S108, _S109);
    (&run_0)->other_reach_0 = (F32_min((0.5f * _S112), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S94 == int(0);
    (&run_0)->last_crossing_0 = _S95 == int(0);
    return run_0;
}

__device__ float square_1(float x_11)
{
    return x_11 * x_11;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_1;
};

__device__ Section_0 section_at_0(Cell_0 * cell_3)
{
    float _S113 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S114 = clamp_0(cell_3->across_0, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_1 = _S114;
    float _S115 = _S113 * _S113 - square_1(_S114);
    float _S116 = (F32_rsqrt((_S115)));
    (&section_0)->drop_0 = _S113 - _S115 * _S116;
    (&section_0)->slope_1 = - _S114 * _S116;
    return section_0;
}

__device__ float edge_drop_0(Family_0 * family_7, uint thread_6, int step_3)
{
    if((family_7->is_alike_0) != 0U)
    {
        return table_number_0(family_7->bend_table_0 + 3U);
    }
    uint _S117 = family_7->bend_table_0;
    float2  _S118 = turns_and_remainder_0(family_7, float(int(thread_6) + step_3));
    return table_number_0(_S117 + uint(_S118.y) * 4U + 3U);
}

__device__ float2  dive_0(Family_0 * other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S119 = crossed_1->below_0;
    float _S120 = crossed_1->above_0;
    bool _S121 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S122 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S123;
    if(_S121)
    {
        _S123 = _S119 - crossed_1->across_0;
    }
    else
    {
        _S123 = _S120 + crossed_1->across_0;
    }
    float _S124 = _S123 - crossed_1->half_width_1;
    bool _S125;
    if(_S121)
    {
        _S125 = run_1->first_crossing_0;
    }
    else
    {
        _S125 = run_1->last_crossing_0;
    }
    bool _S126 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S123 = 0.0f;
    }
    else
    {
        float _S127 = other_1->height_scale_0;
        float _S128 = edge_drop_0(other_1, crossed_1->thread_1, int(0));
        _S123 = _S127 * _S128;
    }
    float _S129;
    if(_S126 != _S125)
    {
        _S129 = 0.0f;
    }
    else
    {
        float _S130 = other_1->height_scale_0;
        uint _S131 = crossed_1->thread_1;
        int _S132;
        if(_S121)
        {
            _S132 = int(-1);
        }
        else
        {
            _S132 = int(1);
        }
        float _S133 = edge_drop_0(other_1, _S131, _S132);
        _S129 = _S130 * _S133;
    }
    float _S134 = 1.0f / (F32_max((2.0f * _S124), (9.999999960041972e-13f)));
    float _S135 = clamp_0((_S124 - _S122) * _S134, 0.0f, 1.0f);
    float _S136 = _S123 + (_S129 - _S123) * (_S135 * _S135 * (3.0f - 2.0f * _S135));
    float _S137 = (_S123 - _S129) * (6.0f * _S135 * (1.0f - _S135) * _S134);
    if(_S121)
    {
        _S123 = 1.0f;
    }
    else
    {
        _S123 = -1.0f;
    }
    return make_float2 (_S136, _S137 * _S123);
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

__device__ void shape_0(Family_0 * own_1, Family_0 * other_2, Cell_0 * own_cell_0, Cell_0 * crossed_2, Sample_0 * sample_0)
{
    Shown_0 _S138 = sample_0->shown_2;
    Run_0 _S139 = unpack_0(own_1, other_2, own_cell_0->thread_1, crossed_2, sample_0->shown_2.word_0);
    Section_0 _S140 = section_at_0(own_cell_0);
    bool _S141;
    if(_S138.on_top_0)
    {
        _S141 = (_S139.distance_0) < (_S140.drop_0 * _S139.bend_1.sine_0);
    }
    else
    {
        _S141 = false;
    }
    bool _S142;
    if(_S138.on_top_0)
    {
        _S142 = !_S141;
    }
    else
    {
        _S142 = false;
    }
    float _S143;
    if(_S142)
    {
        _S143 = 1.0f;
    }
    else
    {
        _S143 = -1.0f;
    }
    float _S144;
    if(_S141)
    {
        _S144 = _S139.other_reach_0;
    }
    else
    {
        _S144 = _S139.reach_0;
    }
    float _S145;
    if(_S141)
    {
        _S145 = _S144 + _S139.distance_0;
    }
    else
    {
        _S145 = (F32_max((_S144 - _S139.distance_0), (0.0f)));
    }
    float _S146 = _S144 / _S139.bend_1.sine_0 - _S143 * _S140.drop_0;
    float _S147 = _S145 * _S145;
    float _S148 = (F32_max((_S146 * _S146 - _S147), (9.99999968265522539e-21f)));
    float _S149 = (F32_rsqrt((_S148)));
    float _S150 = _S147 / (_S148 * _S149 + _S146);
    bool _S151 = _S145 > 0.0f;
    float _S152;
    if(_S138.on_top_0)
    {
        _S152 = 1.0f;
    }
    else
    {
        _S152 = -1.0f;
    }
    float _S153;
    if(_S139.near_start_0)
    {
        _S153 = 1.0f;
    }
    else
    {
        _S153 = -1.0f;
    }
    float _S154 = _S152 * _S153;
    if(_S151)
    {
        _S152 = _S146 * _S149;
    }
    else
    {
        _S152 = 1.0f;
    }
    sample_0->slope_across_0 = _S140.slope_1 * _S152;
    if(_S151)
    {
        _S145 = _S154 * _S145 * _S149;
    }
    else
    {
        _S145 = 0.0f;
    }
    sample_0->slope_along_0 = _S145;
    float _S155 = own_1->height_scale_0;
    Shown_0 _S156 = _S138;
    Run_0 _S157 = _S139;
    float2  _S158 = dive_0(other_2, &_S156, &_S157, crossed_2);
    if(_S139.straight_0)
    {
        _S143 = 0.0f;
    }
    else
    {
        _S143 = _S155 * _S143;
    }
    sample_0->height_2 = _S143 * (_S144 * _S139.bend_1.half_tangent_0 - _S150) - _S155 * _S140.drop_0 - _S158.x;
    float _S159 = _S155 * sample_0->slope_across_0;
    float _S160 = _S155 * sample_0->slope_along_0 - _S158.y;
    if(_S138.is_warp_0)
    {
        _S143 = _S159;
    }
    else
    {
        _S143 = _S160;
    }
    sample_0->slope_x_0 = _S143;
    if(_S138.is_warp_0)
    {
        _S143 = _S160;
    }
    else
    {
        _S143 = _S159;
    }
    sample_0->slope_y_0 = _S143;
    sample_0->run_2 = _S139;
    sample_0->section_1 = _S140;
    return;
}

__device__ float outline_distance_0(Cell_0 * cell_4, Shown_0 * shown_3, Run_0 * run_3, bool lengthwise_0, bool forwards_0)
{
    float _S161;
    if(forwards_0)
    {
        _S161 = cell_4->across_0;
    }
    else
    {
        _S161 = - cell_4->across_0;
    }
    float _S162;
    if(forwards_0)
    {
        _S162 = cell_4->above_0;
    }
    else
    {
        _S162 = cell_4->below_0;
    }
    bool _S163;
    if(forwards_0)
    {
        _S163 = run_3->last_crossing_0;
    }
    else
    {
        _S163 = run_3->first_crossing_0;
    }
    bool _S164;
    if(forwards_0)
    {
        _S164 = run_3->first_crossing_0;
    }
    else
    {
        _S164 = run_3->last_crossing_0;
    }
    float _S165 = cell_4->half_width_1;
    float _S166 = - cell_4->half_width_1;
    bool _S167 = _S161 < _S166;
    bool _S168 = _S161 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S163 = !_S163;
    }
    else
    {
        _S163 = false;
    }
    if(_S163)
    {
        _S163 = !shown_3->hole_0;
    }
    else
    {
        _S163 = false;
    }
    bool _S169;
    if(_S163)
    {
        _S169 = shown_3->on_top_0;
    }
    else
    {
        _S169 = false;
    }
    if(_S169)
    {
        if(_S164)
        {
            _S164 = _S167;
        }
        else
        {
            _S164 = false;
        }
        _S164 = !_S164;
    }
    else
    {
        _S164 = false;
    }
    if(shown_3->hole_0)
    {
        _S163 = true;
    }
    else
    {
        if(_S163)
        {
            _S163 = !shown_3->on_top_0;
        }
        else
        {
            _S163 = false;
        }
    }
    float _S170;
    if(_S167)
    {
        _S170 = _S166;
    }
    else
    {
        _S170 = _S165;
    }
    float _S171 = _S170 - _S161;
    if(_S163)
    {
        _S161 = 2.0f * _S162 + _S161 - _S165;
    }
    else
    {
        _S161 = _S162;
    }
    if(_S164)
    {
        if(forwards_0)
        {
            _S161 = run_3->to_end_0;
        }
        else
        {
            _S161 = run_3->from_start_0;
        }
        return _S161;
    }
    if(_S168)
    {
    }
    else
    {
        _S161 = _S171;
    }
    return _S161;
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

__device__ float ViewRay_rate_0(ViewRay_0 * this_2, Probe_0 * here_0)
{
    return here_0->slope_x_1 * this_2->slope_0.x + here_0->slope_y_1 * this_2->slope_0.y - 1.0f;
}

__device__ float way_back_to_dip_0(PreviousSample_0 * previous_1, float clearance_1, float rate_1, float step_4, Probe_0 * here_1)
{
    float _S172 = previous_1->rate_0;
    float _S173 = previous_1->rate_0 * step_4;
    float _S174 = rate_1 * step_4;
    bool _S175;
    if(!previous_1->known_0)
    {
        _S175 = true;
    }
    else
    {
        _S175 = here_1->hole_1;
    }
    if(_S175)
    {
        _S175 = true;
    }
    else
    {
        _S175 = (previous_1->yarn_0) != (here_1->yarn_1);
    }
    if(_S175)
    {
        _S175 = true;
    }
    else
    {
        _S175 = _S172 >= 0.0f;
    }
    if(_S175)
    {
        _S175 = true;
    }
    else
    {
        _S175 = rate_1 <= 0.0f;
    }
    if(_S175)
    {
        return -1.0f;
    }
    float _S176 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S173) >= 0.0f)
    {
        _S175 = (3.0f * clearance_1 - _S174) >= 0.0f;
    }
    else
    {
        _S175 = false;
    }
    if(_S175)
    {
        return -1.0f;
    }
    float _S177 = clearance_1 - _S176;
    float _S178 = 6.0f * _S177 - 4.0f * _S173 - 2.0f * _S174;
    float _S179 = -2.0f * _S173 / (F32_max((_S178 + (F32_sqrt(((F32_max((_S178 * _S178 - 4.0f * (3.0f * (_S173 + _S174 - 2.0f * _S177)) * _S173), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S180 = 1.0f - _S179;
    float _S181 = (_S176 * (2.0f * _S179 + 1.0f) + _S173 * _S179) * _S180 * _S180;
    float _S182 = (clearance_1 * (2.0f * _S180 + 1.0f) - _S174 * _S180) * _S179 * _S179;
    if(_S179 > 0.01999999955296516f)
    {
        _S175 = _S180 > 0.01999999955296516f;
    }
    else
    {
        _S175 = false;
    }
    if(_S175)
    {
        _S175 = (_S181 + _S182) < 0.0f;
    }
    else
    {
        _S175 = false;
    }
    float _S183;
    if(_S175)
    {
        _S183 = _S180 * step_4;
    }
    else
    {
        _S183 = -1.0f;
    }
    return _S183;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_3, Probe_0 * here_2, float clearance_2, float rate_2)
{
    float _S184 = (F32_min((here_2->edge_x_0 * this_3->per_x_0), (here_2->edge_y_0 * this_3->per_y_0)));
    bool _S185;
    if(!here_2->hole_1)
    {
        _S185 = (rate_2 * _S184 + clearance_2) < 0.0f;
    }
    else
    {
        _S185 = false;
    }
    if(_S185)
    {
        _S185 = _S184 > (2.0f * this_3->epsilon_0);
    }
    else
    {
        _S185 = false;
    }
    float _S186 = this_3->step_0;
    float _S187;
    if(_S185)
    {
        _S187 = _S184 - this_3->epsilon_0;
    }
    else
    {
        _S187 = (F32_max((_S184), (0.0f))) + this_3->epsilon_0;
    }
    return (F32_min((_S186), (_S187)));
}

__device__ PreviousSample_0 after_sample_0(float clearance_3, float rate_3, Probe_0 * here_3, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S188 = here_3->hole_1;
    float _S189;
    if(here_3->hole_1)
    {
        _S189 = 1.0e+09f;
    }
    else
    {
        _S189 = clearance_3;
    }
    (&previous_2)->clearance_0 = _S189;
    (&previous_2)->rate_0 = rate_3;
    (&previous_2)->yarn_0 = here_3->yarn_1;
    bool _S190;
    if(!_S188)
    {
        _S190 = !is_cell_exit_0;
    }
    else
    {
        _S190 = false;
    }
    (&previous_2)->known_0 = _S190;
    return previous_2;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S191 = end_0 - start_1;
    float _S192 = start_rate_0 + end_rate_0 - 2.0f * _S191;
    float _S193 = 3.0f * _S191 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / (F32_max((- _S191), (9.99999968265522539e-21f)));
    int i_5 = int(0);
    for(;;)
    {
        if(uint(i_5) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S194 = clamp_0(share_0 - (((_S192 * share_0 + _S193) * share_0 + start_rate_0) * share_0 + start_1) / (F32_min(((3.0f * _S192 * share_0 + 2.0f * _S193) * share_0 + start_rate_0), (0.10000000149011612f * _S191 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S195 = i_5 + int(1);
        share_0 = _S194;
        i_5 = _S195;
    }
    return share_0;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S196 = along_slope_0 * along_slope_0 + 1.0f;
    float _S197 = (F32_rsqrt((_S196)));
    float _S198 = sine_1 * _S197 * (F32_rsqrt((_S196 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S198 * _S196, _S198 * across_slope_0 * along_slope_0 + cosine_0 * _S197);
}

__device__ float arc_sine_0(float x_12)
{
    float _S199 = (F32_abs((x_12)));
    bool _S200 = _S199 > 0.5f;
    float _S201;
    if(_S200)
    {
        _S201 = 0.5f * (1.0f - _S199);
    }
    else
    {
        _S201 = _S199 * _S199;
    }
    float _S202;
    if(_S200)
    {
        _S202 = (F32_sqrt(((F32_max((_S201), (0.0f))))));
    }
    else
    {
        _S202 = _S199;
    }
    float _S203 = ((((0.04216320067644119f * _S201 + 0.02418131195008755f) * _S201 + 0.04547002539038658f) * _S201 + 0.07495300471782684f) * _S201 + 0.16666752099990845f) * _S201 * _S202 + _S202;
    if(_S200)
    {
        _S201 = 1.57079637050628662f - 2.0f * _S203;
    }
    else
    {
        _S201 = _S203;
    }
    if(x_12 < 0.0f)
    {
        _S201 = - _S201;
    }
    return _S201;
}

__device__ float3  table_colour_0(uint index_3)
{
    return make_float3 (table_number_0(index_3), table_number_0(index_3 + 1U), table_number_0(index_3 + 2U));
}

struct Albedos_0
{
    float3  diffuse_reflect_0;
    float3  diffuse_transmit_0;
    float3  specular_reflect_0;
    float3  specular_transmit_0;
};

__device__ Albedos_0 albedos_of_0(Family_0 * family_8, uint thread_7)
{
    uint _S204 = family_8->albedo_table_0 + family_8->albedo_stride_0 * thread_7;
    Albedos_0 albedos_0;
    (&albedos_0)->diffuse_reflect_0 = table_colour_0(_S204);
    (&albedos_0)->diffuse_transmit_0 = table_colour_0(_S204 + 3U);
    (&albedos_0)->specular_reflect_0 = table_colour_0(_S204 + 6U);
    (&albedos_0)->specular_transmit_0 = table_colour_0(_S204 + 9U);
    return albedos_0;
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_0, float3  room_0)
{
    float3  _S205 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S205.x), (_S205.y)))), (_S205.z)))), (0.0f))))));
}

__device__ float natural_logarithm_0(float x_13)
{
    uint _S206 = (F32_asuint((x_13)));
    float exponent_0 = float(int(_S206 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S206 & 8388607U) | 1056964608U)));
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
    float _S207 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S207 - exponent_1 * 0.00021219444170129f - 0.5f * _S207) + exponent_1 * 0.693359375f;
}

__device__ float fibre_gain_0(uint thread_9, uint cell_5, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_5, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ Light_0 slang_ldg_3(Light_0 * ptr_3)
{
    uint _S208 = __ldg(&ptr_3->is_point_0);
    float _S209 = __ldg(&ptr_3->x_0);
    float _S210 = __ldg(&ptr_3->y_0);
    float _S211 = __ldg(&ptr_3->z_0);
    float _S212 = __ldg(&ptr_3->red_0);
    float _S213 = __ldg(&ptr_3->green_0);
    float _S214 = __ldg(&ptr_3->blue_0);
    Light_0 _S215 = { _S208, _S209, _S210, _S211, _S212, _S213, _S214 };
    return _S215;
}

__device__ float3  towards_light_0(Light_0 * light_0, float3  position_4, float3  * irradiance_0)
{
    *irradiance_0 = make_float3 (light_0->red_0, light_0->green_0, light_0->blue_0);
    float3  _S216 = make_float3 (light_0->x_0, light_0->y_0, light_0->z_0);
    if((light_0->is_point_0) == 0U)
    {
        return _S216;
    }
    float3  _S217 = _S216 - position_4;
    *irradiance_0 = *irradiance_0 / make_float3 ((F32_max((square_0(_S217)), (9.999999960041972e-13f))));
    return normalize_0(_S217);
}

__device__ float diffuse_reflection_0(float3  light_1, float3  normal_1, float blend_0)
{
    float _S218 = light_1.z;
    if(_S218 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S218), (0.0f))), (F32_max((dot_0(light_1, normal_1)), (0.0f))), blend_0);
}

__device__ float projected_area_0(float3  direction_3, float3  tangent_0, float roughness_1)
{
    float _S219 = dot_0(direction_3, tangent_0);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S219 * _S219 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_14)
{
    float _S220 = clamp_0(x_14, -87.0f, 88.0f);
    float _S221 = (F32_floor((_S220 * 1.4426950216293335f + 0.5f)));
    float _S222 = _S220 - _S221 * 0.693359375f + _S221 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S222 + 0.00139819993637502f) * _S222 + 0.00833345204591751f) * _S222 + 0.04166579619050026f) * _S222 + 0.1666666567325592f) * _S222 + 0.5f;
    float _S223 = (U32_asfloat((uint(int(_S221) + int(127)) << int(23))));
    float _S224;
    if(x_14 < -87.0f)
    {
        _S224 = 0.0f;
    }
    else
    {
        _S224 = (p_0 * _S222 * _S222 + _S222 + 1.0f) * _S223;
    }
    return _S224;
}

__device__ float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

__device__ float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S225 = roughness_2 * roughness_2;
    float _S226 = squared_along_0 * (1.0f - _S225) + _S225;
    return 0.31830987334251404f * _S225 * roughness_2 / (_S226 * _S226);
}

__device__ float density_between_0(float3  light_2, float3  view_1, float3  tangent_1, float roughness_3)
{
    float3  _S227 = light_2 + view_1;
    float _S228 = dot_0(_S227, tangent_1);
    return flake_density_0((F32_min((_S228 * _S228 / (F32_max((square_0(_S227)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_3, float3  view_2, float3  normal_2, float3  tangent_2, float roughness_4, float optical_depth_1)
{
    float _S229 = dot_0(light_3, normal_2);
    bool _S230;
    if(_S229 <= 0.0f)
    {
        _S230 = true;
    }
    else
    {
        _S230 = (dot_0(view_2, normal_2)) <= 0.0f;
    }
    if(_S230)
    {
        return 0.0f;
    }
    float _S231 = (F32_max((_S229), (9.99999997475242708e-07f)));
    float _S232 = (F32_max((dot_0(view_2, normal_2)), (9.99999997475242708e-07f)));
    float _S233 = projected_area_0(light_3, tangent_2, roughness_4) * _S232 + projected_area_0(view_2, tangent_2, roughness_4) * _S231;
    float _S234 = optical_depth_1 * _S233 / (_S231 * _S232);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S234 * mean_attenuation_0(_S234)) * _S231 / _S233;
}

__device__ float transmission_0(float3  light_4, float3  view_3, float3  normal_3, float3  tangent_3, float roughness_5, float optical_depth_2)
{
    float _S235 = - dot_0(light_4, normal_3);
    float _S236 = dot_0(view_3, normal_3);
    bool _S237;
    if(_S235 <= 0.0f)
    {
        _S237 = true;
    }
    else
    {
        _S237 = _S236 <= 0.0f;
    }
    if(_S237)
    {
        return 0.0f;
    }
    float _S238 = 1.0f / (F32_max((_S236), (9.99999997475242708e-07f)));
    float _S239 = projected_area_0(light_4, tangent_3, roughness_5) / (F32_max((_S235), (9.99999997475242708e-07f)));
    float _S240 = projected_area_0(view_3, tangent_3, roughness_5) * _S238;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S239), (_S240)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S239 - _S240)))) * _S238;
}

__device__ float sheen_scale_0(float x_15, float y_7)
{
    return (((((0.0f * x_15 + (((((-1.1402510404586792f * y_7 + 0.40672621130943298f) * y_7 + 1.65398800373077393f) * y_7 + -1.29730904102325439f) * y_7 + 0.30570998787879944f) * y_7 + -0.0220868494361639f)) * x_15 + (((((-0.21142719686031342f * y_7 + 1.05947399139404297f) * y_7 + -0.41116121411323547f) * y_7 + -0.93859231472015381f) * y_7 + 0.51606941223144531f) * y_7 + 0.05409301072359085f)) * x_15 + (((((1.22944498062133789f * y_7 + -0.45962560176849365f) * y_7 + -1.63861405849456787f) * y_7 + 1.33565104007720947f) * y_7 + -0.45725581049919128f) * y_7 + 0.08243165910243988f)) * x_15 + (((((0.39779931306838989f * y_7 + -1.18879103660583496f) * y_7 + 0.28251591324806213f) * y_7 + 1.168984055519104f) * y_7 + -0.76864629983901978f) * y_7 + 0.0091691892594099f)) * x_15 + (((((-0.26563560962677002f * y_7 + -0.19379159808158875f) * y_7 + 0.2677634060382843f) * y_7 + 0.00270519289188087f) * y_7 + 0.14349560439586639f) * y_7 + 0.10290180146694183f)) * x_15 + (((((-0.20701569318771362f * y_7 + 0.24526430666446686f) * y_7 + 0.19551840424537659f) * y_7 + 0.07586126774549484f) * y_7 + 0.38894739747047424f) * y_7 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_16, float y_8)
{
    return ((((0.0f * x_16 + (((((-0.10608240216970444f * y_8 + 1.99214303493499756f) * y_8 + -1.42255294322967529f) * y_8 + -1.09495604038238525f) * y_8 + 0.59180057048797607f) * y_8 + 0.06902855634689331f)) * x_16 + (((((-0.46220690011978149f * y_8 + -0.29113379120826721f) * y_8 + 1.39025199413299561f) * y_8 + 0.35589990019798279f) * y_8 + -1.17120099067687988f) * y_8 + 0.15940259397029877f)) * x_16 + (((((2.26068711280822754f * y_8 + -3.64728999137878418f) * y_8 + -0.72173482179641724f) * y_8 + 3.07659196853637695f) * y_8 + -0.6827620267868042f) * y_8 + -0.3039557933807373f)) * x_16 + (((((0.81201767921447754f * y_8 + 0.36014080047607422f) * y_8 + -1.72646903991699219f) * y_8 + -0.22630110383033752f) * y_8 + 0.89514690637588501f) * y_8 + -0.10397960245609283f)) * x_16 + (((((-0.37648698687553406f * y_8 + 1.10974001884460449f) * y_8 + 0.17824520170688629f) * y_8 + -1.04968702793121338f) * y_8 + 0.1461234986782074f) * y_8 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_17, float y_9)
{
    return ((((0.0f * x_17 + (((((12.95646953582763672f * y_9 + -21.38032913208007812f) * y_9 + -7.37853097915649414f) * y_9 + 34.55607986450195312f) * y_9 + -23.61347007751464844f) * y_9 + 5.00126314163208008f)) * x_17 + (((((10.91487026214599609f * y_9 + -6.08202791213989258f) * y_9 + -38.2036285400390625f) * y_9 + 53.3440399169921875f) * y_9 + -21.91996002197265625f) * y_9 + 2.01606011390686035f)) * x_17 + (((((-14.52206039428710938f * y_9 + 36.803619384765625f) * y_9 + -22.94047927856445312f) * y_9 + -10.07973003387451172f) * y_9 + 15.77003955841064453f) * y_9 + -4.92722177505493164f)) * x_17 + (((((-7.62505722045898438f * y_9 + 1.27310299873352051f) * y_9 + 31.19523048400878906f) * y_9 + -44.39989852905273438f) * y_9 + 26.44947052001953125f) * y_9 + -8.73507976531982422f)) * x_17 + (((((5.65633487701416016f * y_9 + -17.66820907592773438f) * y_9 + 24.65356063842773438f) * y_9 + -19.38941001892089844f) * y_9 + 11.06159019470214844f) * y_9 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S241 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S242 = 2.0f * (F32_sqrt((_S241))) - 1.0f;
    float _S243 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S242, _S243), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S241) * sheen_shear_0(_S242, _S243), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S242, _S243), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_5, float3  view_4, float scale_0, float shear_0)
{
    float _S244 = light_5.z;
    bool _S245;
    if(_S244 <= 0.0f)
    {
        _S245 = true;
    }
    else
    {
        _S245 = (view_4.z) <= 0.0f;
    }
    if(_S245)
    {
        return 0.0f;
    }
    float2  _S246 = float2 {view_4.x, view_4.y};
    float _S247 = dot_1(_S246, _S246);
    float2  _S248;
    if(_S247 > 9.99999968265522539e-21f)
    {
        _S248 = _S246 * make_float2 ((F32_rsqrt((_S247))));
    }
    else
    {
        _S248 = make_float2 (1.0f, 0.0f);
    }
    float _S249 = scale_0 * dot_1(float2 {light_5.x, light_5.y}, _S248) + shear_0 * _S244;
    float _S250 = scale_0 * (light_5.y * _S248.x - light_5.x * _S248.y);
    float _S251 = _S249 * _S249 + _S250 * _S250 + _S244 * _S244;
    return 0.31830987334251404f * scale_0 * scale_0 * _S244 / (F32_max((_S251 * _S251), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_6, float3  view_5, float strength_0, float roughness_7)
{
    float3  _S252 = sheen_lobe_0(view_5.z, roughness_7);
    float _S253 = strength_0 * _S252.z;
    return make_float2 (_S253 * transformed_cosine_0(light_6, view_5, _S252.x, _S252.y), 1.0f - _S253);
}

__device__ VisiblePoint_0 visible_point_0(Frame_0 * _S254, uint _S255, uint _S256, uint2  _S257)
{
    Fabric_0 * _S258 = (&(globalParams_0->fabrics_0)[_S255]);
    uint _S259 = 3U * _S256;
    uint _S260 = __ldg((&(globalParams_0->corners_0)[_S259]));
    Vertex_0 _S261 = slang_ldg_2((&(globalParams_0->vertices_0)[_S260]));
    uint _S262 = __ldg((&(globalParams_0->corners_0)[_S259 + 1U]));
    Vertex_0 _S263 = slang_ldg_2((&(globalParams_0->vertices_0)[_S262]));
    uint _S264 = __ldg((&(globalParams_0->corners_0)[_S259 + 2U]));
    Vertex_0 _S265 = slang_ldg_2((&(globalParams_0->vertices_0)[_S264]));
    Vertex_0 _S266 = _S263;
    float3  _S267 = position_of_0(&_S266);
    Vertex_0 _S268 = _S261;
    float3  _S269 = position_of_0(&_S268);
    float3  _S270 = _S267 - _S269;
    Vertex_0 _S271 = _S265;
    float3  _S272 = position_of_0(&_S271);
    float3  _S273 = _S272 - _S269;
    float3  _S274 = cross_0(_S270, _S273);
    float _S275 = 1.0f / (F32_max((square_0(_S274)), (1.00000000317107685e-30f)));
    float3  _S276 = camera_right_0(_S254);
    float _S277 = float(_S254->width_0);
    float3  _S278 = _S276 * make_float3 (2.0f / _S277);
    float3  _S279 = camera_up_0(_S254);
    float _S280 = float(_S254->height_0);
    float3  _S281 = _S279 * make_float3 (-2.0f / _S280);
    float _S282 = float(_S257.x) + 0.5f - 0.5f * _S277;
    float _S283 = float(_S257.y) + 0.5f - 0.5f * _S280;
    float3  _S284 = camera_forward_0(_S254);
    float3  _S285 = _S284 + make_float3 (_S282) * _S278 + make_float3 (_S283) * _S281;
    float _S286 = dot_0(_S285, _S274);
    float _S287;
    if((F32_abs((_S286))) > 1.00000000317107685e-30f)
    {
        _S287 = _S286;
    }
    else
    {
        _S287 = 1.00000000317107685e-30f;
    }
    float _S288 = 1.0f / _S287;
    float3  _S289 = camera_origin_0(_S254);
    float3  _S290 = _S269 - _S289;
    float _S291 = dot_0(_S290, _S274) * _S288;
    float3  _S292 = _S285 * make_float3 (_S291) - _S290;
    float3  _S293 = make_float3 (_S291) * (_S278 - _S285 * make_float3 (dot_0(_S278, _S274) * _S288));
    float3  _S294 = make_float3 (_S291) * (_S281 - _S285 * make_float3 (dot_0(_S281, _S274) * _S288));
    float3  _S295 = cross_0(_S273, _S274) * make_float3 (_S275);
    float3  _S296 = cross_0(_S274, _S270) * make_float3 (_S275);
    float _S297 = dot_0(_S292, _S295);
    float _S298 = dot_0(_S292, _S296);
    float _S299 = _S263.u_0 - _S261.u_0;
    float _S300 = _S263.v_0 - _S261.v_0;
    float2  _S301 = make_float2 (_S299, _S300);
    float _S302 = _S265.u_0 - _S261.u_0;
    float _S303 = _S265.v_0 - _S261.v_0;
    float2  _S304 = make_float2 (_S302, _S303);
    float2  _S305 = make_float2 (_S261.u_0, _S261.v_0) + make_float2 (_S297) * _S301 + make_float2 (_S298) * _S304;
    float2  _S306 = make_float2 (dot_0(_S293, _S295)) * _S301 + make_float2 (dot_0(_S293, _S296)) * _S304;
    float2  _S307 = make_float2 (dot_0(_S294, _S295)) * _S301 + make_float2 (dot_0(_S294, _S296)) * _S304;
    if((_S299 * _S303 - _S300 * _S302) < 0.0f)
    {
        _S287 = -1.0f;
    }
    else
    {
        _S287 = 1.0f;
    }
    float3  _S308 = make_float3 (_S287) * (make_float3 (_S303) * _S270 - make_float3 (_S300) * _S273);
    float3  _S309 = make_float3 (_S287) * (make_float3 (_S299) * _S273 - make_float3 (_S302) * _S270);
    VisiblePoint_0 point_1;
    float _S310 = 1.0f - _S297 - _S298;
    Vertex_0 _S311 = _S261;
    float3  _S312 = normal_of_0(&_S311);
    float3  _S313 = make_float3 (_S310) * _S312;
    Vertex_0 _S314 = _S263;
    float3  _S315 = normal_of_0(&_S314);
    float3  _S316 = _S313 + make_float3 (_S297) * _S315;
    Vertex_0 _S317 = _S265;
    float3  _S318 = normal_of_0(&_S317);
    float3  _S319 = normalize_0(_S316 + make_float3 (_S298) * _S318);
    (&point_1)->normal_0 = _S319;
    float3  _S320 = normalize_0(_S308 - _S319 * make_float3 (dot_0(_S319, _S308)));
    (&point_1)->axis_x_0 = _S320;
    (&point_1)->axis_y_0 = cross_0(_S319, _S320);
    (&point_1)->position_0 = _S269 + _S292;
    (&point_1)->view_0 = - normalize_0(_S285);
    bool _S321 = (dot_0(cross_0(_S308, _S309), _S319)) < 0.0f;
    float _S322 = __ldg(&_S258->uv_width_0);
    if(_S321)
    {
        float _S323 = __ldg(&_S258->uv_height_0);
        _S287 = - _S323;
    }
    else
    {
        float _S324 = __ldg(&_S258->uv_height_0);
        _S287 = _S324;
    }
    float2  _S325 = make_float2 (_S322, _S287);
    float2  _S326 = _S305 * _S325;
    if(_S321)
    {
        float _S327 = __ldg(&_S258->uv_height_0);
        _S287 = _S327;
    }
    else
    {
        _S287 = 0.0f;
    }
    (&point_1)->draft_0 = _S326 + make_float2 (0.0f, _S287);
    (&point_1)->draft_dx_0 = _S306 * _S325;
    (&point_1)->draft_dy_0 = _S307 * _S325;
    return point_1;
}

struct YarnPoint_0
{
    bool back_2;
    bool hole_2;
    float x_18;
    float y_10;
    float height_4;
    float3  normal_4;
    float3  tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_19;
    float y_11;
    bool hole_3;
    float height_5;
};

__device__ float steps_per_length_0(uint _S328, float3  _S329)
{
    Fabric_0 * _S330 = (&(globalParams_0->fabrics_0)[_S328]);
    float _S331 = (F32_abs((_S329.x)));
    float _S332 = __ldg(&_S330->threads_per_x_0);
    float _S333 = _S331 * _S332;
    float _S334 = (F32_abs((_S329.y)));
    float _S335 = __ldg(&_S330->threads_per_y_0);
    float _S336 = (F32_max((_S333), (_S334 * _S335))) * 5.0f;
    float _S337 = (F32_abs((_S329.z)));
    float _S338 = __ldg(&_S330->per_relief_0);
    return (F32_max((_S336), (_S337 * _S338 * 8.0f)));
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

__device__ float max_height_along_0(uint _S339, float _S340, float _S341, float _S342, float3  _S343, bool _S344)
{
    Fabric_0 * _S345 = (&(globalParams_0->fabrics_0)[_S339]);
    Family_0 _S346 = slang_ldg_1(&_S345->warp_0);
    Family_0 _S347 = _S346;
    Cell_0 _S348 = locate_0(&_S347, _S340);
    uint _S349 = _S348.thread_1 / 2U;
    Family_0 _S350 = slang_ldg_1(&_S345->weft_0);
    Family_0 _S351 = _S350;
    Cell_0 _S352 = locate_0(&_S351, _S341);
    uint _S353 = _S352.thread_1 / 2U;
    float _S354 = _S343.x;
    uint _S355;
    if(_S354 > 0.0f)
    {
        _S355 = 1U;
    }
    else
    {
        _S355 = 0U;
    }
    float _S356 = _S343.y;
    uint _S357;
    if(_S356 > 0.0f)
    {
        _S357 = 2U;
    }
    else
    {
        _S357 = 0U;
    }
    uint _S358 = _S355 + _S357;
    uint _S359 = __ldg(&_S345->max_heights_0);
    uint _S360 = __ldg(&_S345->max_height_columns_0);
    uint _S361 = __ldg((&(globalParams_0->words_0)[_S359 + 4U * (_S353 * _S360 + _S349) + _S358]));
    int number_0;
    if(_S344)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S362 = _S361 >> number_0;
    float _S363 = (F32_abs((_S354)));
    float _S364 = __ldg(&_S345->threads_per_x_0);
    float _S365 = _S363 * _S364;
    float _S366 = (F32_abs((_S356)));
    float _S367 = __ldg(&_S345->threads_per_y_0);
    float _S368 = (F32_max((_S365), (_S366 * _S367))) / _S343.z;
    float _S369 = __ldg(&_S345->height_high_0);
    float max_height_0 = _S369;
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
        if(((max_height_0 - _S342) * _S368) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S362 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S369)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ Crossing_0 crossing_at_0(uint _S370, float _S371, float _S372, bool _S373)
{
    Fabric_0 * _S374 = (&(globalParams_0->fabrics_0)[_S370]);
    Crossing_0 crossing_2;
    Family_0 _S375 = slang_ldg_1(&_S374->warp_0);
    Family_0 _S376 = _S375;
    Cell_0 _S377 = locate_0(&_S376, _S371);
    (&crossing_2)->warp_1 = _S377;
    Family_0 _S378 = slang_ldg_1(&_S374->weft_0);
    Family_0 _S379 = _S378;
    Cell_0 _S380 = locate_0(&_S379, _S372);
    (&crossing_2)->weft_1 = _S380;
    uint _S381 = __ldg(&_S374->run_words_0);
    uint _S382 = (&(&crossing_2)->weft_1)->thread_1;
    uint _S383 = __ldg(&_S374->ends_0);
    uint _S384 = _S381 + 2U * (_S382 * _S383 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S385 = __ldg((&(globalParams_0->words_0)[_S384]));
    (&crossing_2)->warp_word_0 = _S385;
    uint _S386 = __ldg((&(globalParams_0->words_0)[_S384 + 1U]));
    (&crossing_2)->weft_word_0 = _S386;
    (&crossing_2)->warp_above_0 = ((_S385 & 1U) == 1U) != _S373;
    return crossing_2;
}

__device__ float cell_maximum_0(uint _S387, Crossing_0 * _S388)
{
    Fabric_0 * _S389 = (&(globalParams_0->fabrics_0)[_S387]);
    if(_S388->warp_above_0)
    {
        float _S390 = float((_S388->warp_word_0) >> int(28));
        Family_0 _S391 = slang_ldg_1(&_S389->warp_0);
        return _S390 * _S391.height_scale_0 * _S391.level_0;
    }
    float _S392 = float((_S388->weft_word_0) >> int(28));
    Family_0 _S393 = slang_ldg_1(&_S389->weft_0);
    return _S392 * _S393.height_scale_0 * _S393.level_0;
}

__device__ float3  cell_bounds_0(uint _S394, float _S395, float _S396, bool _S397, bool _S398, bool _S399)
{
    Crossing_0 _S400 = crossing_at_0(_S394, _S395, _S396, _S397);
    Crossing_0 _S401 = _S400;
    float _S402 = cell_maximum_0(_S394, &_S401);
    float _S403;
    if(_S398)
    {
        _S403 = _S400.warp_1.above_0;
    }
    else
    {
        _S403 = _S400.warp_1.below_0;
    }
    float _S404;
    if(_S399)
    {
        _S404 = _S400.weft_1.above_0;
    }
    else
    {
        _S404 = _S400.weft_1.below_0;
    }
    return make_float3 (_S402, _S403, _S404);
}

__device__ float first_sample_height_0(uint _S405, ViewRay_0 * _S406, StepControl_0 * _S407, bool _S408)
{
    float _S409 = max_height_along_0(_S405, _S406->origin_0.x, _S406->origin_0.y, 0.0f, make_float3 (_S406->slope_0.x, _S406->slope_0.y, 1.0f), _S408);
    uint count_1 = 0U;
    float height_7 = _S409;
    for(;;)
    {
        if(count_1 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S410 = ViewRay_at_0(_S406, height_7);
        float3  _S411 = cell_bounds_0(_S405, _S410.x, _S410.y, _S408, _S407->right_1, _S407->up_0);
        float _S412 = height_7 - _S411.x;
        float _S413 = StepControl_to_cell_exit_0(_S407, _S411.y, _S411.z);
        float height_8 = height_7 - clamp_0(_S412, 0.0f, _S413);
        if(_S412 <= _S413)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

__device__ Sample_0 sample_at_0(uint _S414, float _S415, float _S416, bool _S417)
{
    Fabric_0 * _S418 = (&(globalParams_0->fabrics_0)[_S414]);
    Sample_0 sample_1;
    Crossing_0 _S419 = crossing_at_0(_S414, _S415, _S416, _S417);
    (&sample_1)->crossing_1 = _S419;
    Crossing_0 _S420 = _S419;
    Shown_0 _S421 = shown_at_0(&_S420, _S417);
    (&sample_1)->shown_2 = _S421;
    if((&(&sample_1)->shown_2)->is_warp_0)
    {
        Family_0 _S422 = slang_ldg_1(&_S418->warp_0);
        Family_0 _S423 = slang_ldg_1(&_S418->weft_0);
        Family_0 _S424 = _S422;
        Family_0 _S425 = _S423;
        Cell_0 _S426 = (&(&sample_1)->crossing_1)->warp_1;
        Cell_0 _S427 = (&(&sample_1)->crossing_1)->weft_1;
        shape_0(&_S424, &_S425, &_S426, &_S427, &sample_1);
    }
    else
    {
        Family_0 _S428 = slang_ldg_1(&_S418->weft_0);
        Family_0 _S429 = slang_ldg_1(&_S418->warp_0);
        Family_0 _S430 = _S428;
        Family_0 _S431 = _S429;
        Cell_0 _S432 = (&(&sample_1)->crossing_1)->weft_1;
        Cell_0 _S433 = (&(&sample_1)->crossing_1)->warp_1;
        shape_0(&_S430, &_S431, &_S432, &_S433, &sample_1);
    }
    return sample_1;
}

__device__ Probe_0 probe_0(uint _S434, float _S435, float _S436, bool _S437, bool _S438, bool _S439)
{
    Sample_0 _S440 = sample_at_0(_S434, _S435, _S436, _S437);
    Probe_0 probe_1;
    (&probe_1)->height_3 = _S440.height_2;
    (&probe_1)->hole_1 = _S440.shown_2.hole_0;
    (&probe_1)->slope_x_1 = _S440.slope_x_0;
    (&probe_1)->slope_y_1 = _S440.slope_y_0;
    uint _S441;
    if(_S440.shown_2.is_warp_0)
    {
        _S441 = _S440.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S441 = _S440.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S441;
    Crossing_0 _S442 = _S440.crossing_1;
    float _S443 = cell_maximum_0(_S434, &_S442);
    (&probe_1)->cell_max_0 = _S443;
    float _S444;
    if(_S438)
    {
        _S444 = _S440.crossing_1.warp_1.above_0;
    }
    else
    {
        _S444 = _S440.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_1 = _S444;
    if(_S439)
    {
        _S444 = _S440.crossing_1.weft_1.above_0;
    }
    else
    {
        _S444 = _S440.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_1 = _S444;
    bool _S445 = !_S440.shown_2.is_warp_0;
    Cell_0 _S446 = _S440.crossing_1.warp_1;
    Shown_0 _S447 = _S440.shown_2;
    Run_0 _S448 = _S440.run_2;
    float _S449 = outline_distance_0(&_S446, &_S447, &_S448, _S445, _S438);
    (&probe_1)->edge_x_0 = _S449;
    Cell_0 _S450 = _S440.crossing_1.weft_1;
    Shown_0 _S451 = _S440.shown_2;
    Run_0 _S452 = _S440.run_2;
    float _S453 = outline_distance_0(&_S450, &_S451, &_S452, _S440.shown_2.is_warp_0, _S439);
    (&probe_1)->edge_y_0 = _S453;
    return probe_1;
}

__device__ ViewRayEnd_0 search_down_0(uint _S454, ViewRay_0 * _S455, StepControl_0 * _S456, bool _S457)
{
    Fabric_0 * _S458 = (&(globalParams_0->fabrics_0)[_S454]);
    float _S459 = __ldg(&_S458->height_low_0);
    float _S460 = __ldg(&_S458->height_high_0);
    float _S461 = _S459 - (_S460 - _S459);
    ViewRayEnd_0 end_1;
    float _S462 = first_sample_height_0(_S454, _S455, _S456, _S457);
    (&end_1)->height_6 = _S462;
    (&end_1)->last_step_0 = _S456->epsilon_0;
    (&end_1)->previous_3 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
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
        float2  _S463 = ViewRay_at_0(_S455, (&end_1)->height_6);
        Probe_0 _S464 = probe_0(_S454, _S463.x, _S463.y, _S457, _S456->right_1, _S456->up_0);
        float _S465 = (&end_1)->height_6 - _S464.height_3;
        Probe_0 _S466 = _S464;
        float _S467 = ViewRay_rate_0(_S455, &_S466);
        (&end_1)->depth_1 = - _S465;
        (&end_1)->rate_4 = _S467;
        bool _S468;
        if((&(&end_1)->previous_3)->known_0)
        {
            _S468 = !_S464.hole_1;
        }
        else
        {
            _S468 = false;
        }
        bool _S469;
        if(_S468)
        {
            _S469 = ((&(&end_1)->previous_3)->yarn_0) == (_S464.yarn_1);
        }
        else
        {
            _S469 = false;
        }
        (&end_1)->smooth_0 = _S469;
        bool _S470;
        if(!_S464.hole_1)
        {
            _S470 = _S465 <= 0.0f;
        }
        else
        {
            _S470 = false;
        }
        bool _S471;
        if(_S470)
        {
            _S471 = true;
        }
        else
        {
            _S471 = ((&end_1)->height_6) <= _S461;
        }
        if(_S471)
        {
            break;
        }
        PreviousSample_0 _S472 = (&end_1)->previous_3;
        Probe_0 _S473 = _S464;
        float _S474 = way_back_to_dip_0(&_S472, _S465, _S467, (&end_1)->last_step_0, &_S473);
        if(_S474 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S474;
            (&end_1)->last_step_0 = (&end_1)->last_step_0 - _S474;
            count_2 = count_2 + 1U;
            continue;
        }
        float _S475 = StepControl_to_cell_exit_0(_S456, _S464.side_x_1, _S464.side_y_1);
        float _S476 = (F32_min((_S475), ((&end_1)->height_6 - _S464.cell_max_0)));
        Probe_0 _S477 = _S464;
        float _S478 = StepControl_to_next_sample_0(_S456, &_S477, _S465, _S467);
        bool _S479 = _S476 > _S478;
        Probe_0 _S480 = _S464;
        PreviousSample_0 _S481 = after_sample_0(_S465, _S467, &_S480, _S479);
        (&end_1)->previous_3 = _S481;
        float _S482 = (F32_max((_S476), (_S478)));
        (&end_1)->last_step_0 = _S482;
        (&end_1)->height_6 = (&end_1)->height_6 - _S482;
        count_2 = count_2 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S483, ViewRay_0 * _S484, StepControl_0 * _S485, bool _S486, ViewRayEnd_0 * _S487)
{
    Fabric_0 * _S488 = (&(globalParams_0->fabrics_0)[_S483]);
    float _S489 = __ldg(&_S488->height_high_0);
    float _S490 = __ldg(&_S488->height_low_0);
    float _S491 = _S489 - _S490;
    float _S492 = _S487->height_6;
    float _S493 = _S487->last_step_0;
    float above_2 = _S487->height_6 + _S487->last_step_0;
    float above_gap_1 = clamp_0((&_S487->previous_3)->clearance_0, 0.0f, _S491);
    float under_gap_1 = clamp_0(_S487->depth_1, 0.0f, _S491);
    float _S494 = cubic_root_0(above_gap_1, - under_gap_1, (&_S487->previous_3)->rate_0 * _S487->last_step_0, _S487->rate_4 * _S487->last_step_0);
    bool _S495 = _S487->smooth_0;
    float middle_0;
    if(_S487->smooth_0)
    {
        middle_0 = above_2 - _S494 * _S493;
    }
    else
    {
        middle_0 = between_0(above_2, _S492, above_gap_1, under_gap_1);
    }
    float side_0 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S492;
    float above_3 = above_2;
    uint i_6 = 0U;
    for(;;)
    {
        if(i_6 < 2U)
        {
        }
        else
        {
            break;
        }
        float2  _S496 = ViewRay_at_0(_S484, middle_0);
        Probe_0 _S497 = probe_0(_S483, _S496.x, _S496.y, _S486, _S485->right_1, _S485->up_0);
        float _S498;
        if(_S497.hole_1)
        {
            _S498 = -1.0e+09f;
        }
        else
        {
            _S498 = _S497.height_3;
        }
        float _S499 = clamp_0(middle_0 - _S498, - _S491, _S491);
        float _S500;
        if(_S499 <= 0.0f)
        {
            if(side_0 > 0.0f)
            {
                _S500 = 0.5f * above_gap_2;
            }
            else
            {
                _S500 = above_gap_2;
            }
            float _S501 = - _S499;
            under_1 = middle_0;
            above_gap_2 = _S500;
            under_gap_2 = _S501;
            side_0 = 1.0f;
        }
        else
        {
            if(side_0 < 0.0f)
            {
                _S500 = 0.5f * under_gap_2;
            }
            else
            {
                _S500 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S499;
            under_gap_2 = _S500;
            side_0 = -1.0f;
        }
        if(_S495)
        {
            Probe_0 _S502 = _S497;
            float _S503 = ViewRay_rate_0(_S484, &_S502);
            middle_0 = clamp_0(middle_0 + _S499 / (F32_min((_S503), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_6 = i_6 + 1U;
    }
    if(_S495)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ bool is_free_0(uint _S504, float3  _S505, float3  _S506, bool _S507, float _S508)
{
    float _S509 = _S506.z;
    if(_S509 <= 0.0f)
    {
        return false;
    }
    float _S510 = steps_per_length_0(_S504, _S506);
    float _S511 = 1.0f / (F32_max((_S510), (9.99999971718068537e-10f)));
    StepControl_0 _S512 = step_control_0(float2 {_S506.x, _S506.y}, _S511);
    PreviousSample_0 previous_4 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_1 = 0.0f;
    for(;;)
    {
        bool _S513;
        if(count_3 < 1024U)
        {
            _S513 = (_S505.z + _S509 * distance_1) < _S508;
        }
        else
        {
            _S513 = false;
        }
        if(_S513)
        {
        }
        else
        {
            break;
        }
        float3  _S514 = _S505 + _S506 * make_float3 (distance_1);
        Probe_0 _S515 = probe_0(_S504, _S514.x, _S514.y, _S507, _S512.right_1, _S512.up_0);
        float _S516 = _S514.z;
        float _S517 = _S516 - _S515.height_3;
        float _S518 = _S509 - _S515.slope_x_1 * _S506.x - _S515.slope_y_1 * _S506.y;
        bool _S519;
        if(!_S515.hole_1)
        {
            _S519 = _S517 < 0.0f;
        }
        else
        {
            _S519 = false;
        }
        if(_S519)
        {
            return false;
        }
        PreviousSample_0 _S520 = previous_4;
        Probe_0 _S521 = _S515;
        float _S522 = way_back_to_dip_0(&_S520, _S517, _S518, last_step_1, &_S521);
        if(_S522 >= 0.0f)
        {
            float last_step_2 = last_step_1 - _S522;
            distance_1 = distance_1 - _S522;
            last_step_1 = last_step_2;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S523 = _S516 > (_S515.cell_max_0);
        Probe_0 _S524 = _S515;
        PreviousSample_0 _S525 = after_sample_0(_S517, _S518, &_S524, _S523);
        float last_step_3;
        if(_S523)
        {
            StepControl_0 _S526 = _S512;
            float _S527 = StepControl_to_cell_exit_0(&_S526, _S515.side_x_1, _S515.side_y_1);
            last_step_3 = (F32_max((_S527), (_S511)));
        }
        else
        {
            StepControl_0 _S528 = _S512;
            Probe_0 _S529 = _S515;
            float _S530 = StepControl_to_next_sample_0(&_S528, &_S529, _S517, _S518);
            last_step_3 = _S530;
        }
        float distance_2 = distance_1 + last_step_3;
        previous_4 = _S525;
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S531, float _S532, float _S533, float3  _S534, bool _S535)
{
    Fabric_0 * _S536 = (&(globalParams_0->fabrics_0)[_S531]);
    Sample_0 _S537 = sample_at_0(_S531, _S532, _S533, _S535);
    if(!_S537.shown_2.hole_0)
    {
        return false;
    }
    float3  _S538 = make_float3 (_S532, _S533, 0.0f);
    float _S539 = __ldg(&_S536->height_high_0);
    bool _S540 = is_free_0(_S531, _S538, _S534, _S535, _S539);
    if(!_S540)
    {
        return false;
    }
    bool _S541 = is_free_0(_S531, _S538, make_float3 (- _S534.x, - _S534.y, _S534.z), !_S535, _S539);
    return _S541;
}

__device__ Hit_0 first_hit_0(uint _S542, float _S543, float _S544, float3  _S545, bool _S546)
{
    float _S547 = (F32_max((_S545.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S543, _S544);
    float2  _S548 = float2 {_S545.x, _S545.y} / make_float2 (_S547);
    (&ray_0)->slope_0 = _S548;
    float2  _S549 = - _S548;
    float _S550 = steps_per_length_0(_S542, _S545);
    StepControl_0 _S551 = step_control_0(_S549, 1.0f / (F32_max((_S550 / _S547), (9.99999971718068537e-10f))));
    ViewRay_0 _S552 = ray_0;
    StepControl_0 _S553 = _S551;
    ViewRayEnd_0 _S554 = search_down_0(_S542, &_S552, &_S553, _S546);
    Hit_0 hit_0;
    ViewRay_0 _S555 = ray_0;
    StepControl_0 _S556 = _S551;
    ViewRayEnd_0 _S557 = _S554;
    float _S558 = refined_height_0(_S542, &_S555, &_S556, _S546, &_S557);
    (&hit_0)->height_5 = _S558;
    ViewRay_0 _S559 = ray_0;
    float2  _S560 = ViewRay_at_0(&_S559, _S558);
    (&hit_0)->x_19 = _S560.x;
    (&hit_0)->y_11 = _S560.y;
    bool _S561;
    if(_S558 <= 0.0f)
    {
        bool _S562 = passes_through_0(_S542, _S543, _S544, _S545, _S546);
        _S561 = _S562;
    }
    else
    {
        _S561 = false;
    }
    (&hit_0)->hole_3 = _S561;
    return hit_0;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_9;
    float3  normal_5;
    float3  tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 surface_at_0(uint _S563, float _S564, float _S565, bool _S566)
{
    Fabric_0 * _S567 = (&(globalParams_0->fabrics_0)[_S563]);
    Sample_0 _S568 = sample_at_0(_S563, _S564, _S565, _S566);
    float _S569;
    if(_S568.shown_2.is_warp_0)
    {
        _S569 = _S568.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S569 = _S568.crossing_1.weft_1.half_width_1;
    }
    float _S570;
    if(_S568.shown_2.is_warp_0)
    {
        Family_0 _S571 = slang_ldg_1(&_S567->warp_0);
        _S570 = _S571.twist_sine_0;
    }
    else
    {
        Family_0 _S572 = slang_ldg_1(&_S567->weft_0);
        _S570 = _S572.twist_sine_0;
    }
    float _S573;
    if(_S566)
    {
        _S573 = -1.0f;
    }
    else
    {
        _S573 = 1.0f;
    }
    float _S574 = _S570 * _S573;
    if(_S568.shown_2.is_warp_0)
    {
        Family_0 _S575 = slang_ldg_1(&_S567->warp_0);
        _S570 = _S575.twist_cosine_0;
    }
    else
    {
        Family_0 _S576 = slang_ldg_1(&_S567->weft_0);
        _S570 = _S576.twist_cosine_0;
    }
    if(_S568.shown_2.is_warp_0)
    {
        _S573 = 1.0f;
    }
    else
    {
        _S573 = -1.0f;
    }
    float2  _S577 = fibre_direction_0(_S568.slope_across_0, _S573 * _S568.slope_along_0, _S574, _S570);
    float _S578;
    if(_S568.shown_2.is_warp_0)
    {
        _S578 = _S568.slope_x_0;
    }
    else
    {
        _S578 = _S568.slope_y_0;
    }
    float _S579;
    if(_S568.shown_2.is_warp_0)
    {
        _S579 = _S568.slope_y_0;
    }
    else
    {
        _S579 = _S568.slope_x_0;
    }
    float _S580 = _S577.x;
    float _S581 = _S577.y;
    float _S582 = _S578 * _S580 + _S573 * _S579 * _S581;
    float _S583 = _S569 * 1.0154266357421875f;
    float _S584 = _S583 * arc_sine_0(clamp_0(_S568.section_1.across_1 / _S583, -1.0f, 1.0f));
    if(_S568.shown_2.is_warp_0)
    {
        _S569 = _S565;
    }
    else
    {
        _S569 = - _S564;
    }
    SurfacePoint_0 point_2;
    (&point_2)->hole_4 = _S568.shown_2.hole_0;
    (&point_2)->is_warp_1 = _S568.shown_2.is_warp_0;
    (&point_2)->warp_thread_0 = _S568.crossing_1.warp_1.thread_1;
    (&point_2)->weft_thread_0 = _S568.crossing_1.weft_1.thread_1;
    (&point_2)->height_9 = _S568.height_2;
    (&point_2)->normal_5 = normalize_0(make_float3 (- _S568.slope_x_0, - _S568.slope_y_0, 1.0f));
    float3  _S585;
    if(_S568.shown_2.is_warp_0)
    {
        _S585 = make_float3 (_S580, _S581, _S582);
    }
    else
    {
        _S585 = make_float3 (- _S581, _S580, _S582);
    }
    (&point_2)->tangent_5 = normalize_0(_S585);
    (&point_2)->across_2 = _S568.section_1.across_1;
    (&point_2)->fibre_across_0 = _S584 * _S570 + _S569 * _S574;
    (&point_2)->fibre_along_0 = _S569 * _S570 - _S584 * _S574;
    return point_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S586, Albedos_0 * _S587, uint _S588, uint _S589)
{
    Fabric_0 * _S590 = (&(globalParams_0->fabrics_0)[_S586]);
    float3  _S591 = _S587->specular_reflect_0;
    float3  _S592 = _S587->specular_transmit_0;
    float3  _S593 = max_0(_S587->specular_reflect_0, _S587->specular_transmit_0);
    float3  _S594 = _S587->diffuse_reflect_0;
    float3  _S595 = _S587->diffuse_transmit_0;
    float3  _S596 = _S587->diffuse_reflect_0 + _S587->diffuse_transmit_0;
    float _S597 = __ldg(&_S590->colour_noise_0);
    uint _S598 = __ldg(&_S590->seed_0);
    float _S599 = thread_gain_0(_S588, _S597, _S598);
    float _S600 = __ldg(&_S590->layer_bound_0);
    float _S601 = bounded_gain_0(_S599, _S596, make_float3 (1.0f) - make_float3 (_S600) * _S593);
    float3  _S602 = min_0((make_float3 (1.0f) - make_float3 (_S601) * _S596) / make_float3 (_S600), make_float3 (1.0f));
    float _S603 = __ldg(&_S590->fibre_noise_0);
    float _S604 = bounded_gain_0(fibre_gain_0(_S588, _S589, _S603, _S598), _S593, _S602);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S601) * _S594;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S601) * _S595;
    (&varied_0)->specular_reflect_0 = make_float3 (_S604) * _S591;
    (&varied_0)->specular_transmit_0 = make_float3 (_S604) * _S592;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S605, SurfacePoint_0 * _S606, Albedos_0 * _S607, float _S608, float _S609)
{
    Fabric_0 * _S610 = (&(globalParams_0->fabrics_0)[_S605]);
    bool _S611 = _S606->is_warp_1;
    float _S612;
    if(_S606->is_warp_1)
    {
        _S612 = _S608;
    }
    else
    {
        _S612 = _S609;
    }
    float _S613 = _S612 - _S606->across_2;
    if(_S611)
    {
        Family_0 _S614 = slang_ldg_1(&_S610->warp_0);
        _S612 = _S614.period_0;
    }
    else
    {
        Family_0 _S615 = slang_ldg_1(&_S610->weft_0);
        _S612 = _S615.period_0;
    }
    float _S616;
    if(_S611)
    {
        Family_0 _S617 = slang_ldg_1(&_S610->warp_0);
        _S616 = _S617.count_0;
    }
    else
    {
        Family_0 _S618 = slang_ldg_1(&_S610->weft_0);
        _S616 = _S618.count_0;
    }
    int _S619 = int(_S616);
    uint _S620;
    if(_S611)
    {
        _S620 = _S606->warp_thread_0;
    }
    else
    {
        _S620 = _S606->weft_thread_0;
    }
    uint _S621 = uint(int((F32_floor((_S613 / _S612)))) * _S619 + int(_S620)) * 2U;
    if(_S611)
    {
        _S620 = 1U;
    }
    else
    {
        _S620 = 0U;
    }
    uint _S622 = _S621 + _S620;
    float _S623 = _S606->fibre_across_0;
    float _S624 = __ldg(&_S610->fibre_size_0);
    float _S625 = (F32_floor((_S623 / _S624)));
    Albedos_0 _S626 = vary_albedos_0(_S605, _S607, _S622, uint(int(_S625)) * 65536U + uint(int((F32_floor((_S606->fibre_along_0 / (_S624 * 40.0f) + 0.61799997091293335f * _S625))))));
    return _S626;
}

__device__ YarnPoint_0 yarn_point_at_0(uint _S627, float _S628, float _S629, bool _S630, bool _S631)
{
    Fabric_0 * _S632 = (&(globalParams_0->fabrics_0)[_S627]);
    SurfacePoint_0 _S633 = surface_at_0(_S627, _S628, _S629, _S630);
    Albedos_0 albedos_2;
    if(_S633.is_warp_1)
    {
        Family_0 _S634 = slang_ldg_1(&_S632->warp_0);
        Family_0 _S635 = _S634;
        Albedos_0 _S636 = albedos_of_0(&_S635, _S633.warp_thread_0);
        albedos_2 = _S636;
    }
    else
    {
        Family_0 _S637 = slang_ldg_1(&_S632->weft_0);
        Family_0 _S638 = _S637;
        Albedos_0 _S639 = albedos_of_0(&_S638, _S633.weft_thread_0);
        albedos_2 = _S639;
    }
    float _S640 = __ldg(&_S632->fibre_noise_0);
    bool _S641;
    if(_S640 > 0.0f)
    {
        _S641 = true;
    }
    else
    {
        float _S642 = __ldg(&_S632->colour_noise_0);
        _S641 = _S642 > 0.0f;
    }
    if(_S641)
    {
        SurfacePoint_0 _S643 = _S633;
        Albedos_0 _S644 = albedos_2;
        Albedos_0 _S645 = varied_at_0(_S627, &_S643, &_S644, _S628, _S629);
        albedos_2 = _S645;
    }
    YarnPoint_0 point_3;
    (&point_3)->back_2 = _S630;
    (&point_3)->hole_2 = _S631;
    (&point_3)->x_18 = _S628;
    (&point_3)->y_10 = _S629;
    (&point_3)->height_4 = _S633.height_9;
    (&point_3)->normal_4 = _S633.normal_5;
    (&point_3)->tangent_4 = _S633.tangent_5;
    float _S646;
    if(_S633.is_warp_1)
    {
        Family_0 _S647 = slang_ldg_1(&_S632->warp_0);
        _S646 = _S647.roughness_0;
    }
    else
    {
        Family_0 _S648 = slang_ldg_1(&_S632->weft_0);
        _S646 = _S648.roughness_0;
    }
    (&point_3)->roughness_8 = _S646;
    (&point_3)->albedos_1 = albedos_2;
    return point_3;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S649, float _S650, float _S651, float3  _S652)
{
    bool _S653 = (_S652.z) < 0.0f;
    Hit_0 _S654 = first_hit_0(_S649, _S650, _S651, to_face_frame_0(_S652, _S653), _S653);
    YarnPoint_0 _S655 = yarn_point_at_0(_S649, _S654.x_19, _S654.y_11, _S653, _S654.hole_3);
    return _S655;
}

__device__ float3  scattered_0(uint _S656, YarnPoint_0 * _S657, float3  _S658, float3  _S659)
{
    Fabric_0 * _S660 = (&(globalParams_0->fabrics_0)[_S656]);
    float3  _S661 = make_float3 (0.0f);
    bool _S662 = !_S657->hole_2;
    bool _S663;
    if(_S662)
    {
        _S663 = (_S658.z) > 0.0f;
    }
    else
    {
        _S663 = false;
    }
    float3  value_1;
    if(_S663)
    {
        float3  _S664 = (&_S657->albedos_1)->diffuse_reflect_0;
        float3  _S665 = _S657->normal_4;
        float _S666 = __ldg(&_S660->diffuse_blend_0);
        float3  _S667 = _S664 * make_float3 (diffuse_reflection_0(_S658, _S665, _S666));
        float3  _S668 = (&_S657->albedos_1)->specular_reflect_0;
        float3  _S669 = _S657->tangent_4;
        float _S670 = _S657->roughness_8;
        float _S671 = __ldg(&_S660->optical_depth_0);
        value_1 = _S667 + _S668 * make_float3 (reflection_0(_S658, _S659, _S665, _S669, _S670, _S671));
    }
    else
    {
        if(_S662)
        {
            _S663 = (_S658.z) < 0.0f;
        }
        else
        {
            _S663 = false;
        }
        if(_S663)
        {
            float3  _S672 = (&_S657->albedos_1)->diffuse_transmit_0;
            float3  _S673 = - _S658;
            float3  _S674 = _S657->normal_4;
            float _S675 = __ldg(&_S660->diffuse_blend_0);
            float3  _S676 = _S672 * make_float3 (diffuse_reflection_0(_S673, _S674, _S675));
            float3  _S677 = (&_S657->albedos_1)->specular_transmit_0;
            float3  _S678 = _S657->tangent_4;
            float _S679 = _S657->roughness_8;
            float _S680 = __ldg(&_S660->optical_depth_0);
            value_1 = _S676 + _S677 * make_float3 (transmission_0(_S658, _S659, _S674, _S678, _S679, _S680));
        }
        else
        {
            value_1 = _S661;
        }
    }
    float _S681 = __ldg(&_S660->sheen_strength_0);
    if(_S681 <= 0.0f)
    {
        return value_1;
    }
    float _S682 = __ldg(&_S660->sheen_roughness_0);
    float2  _S683 = sheen_with_transmittance_0(_S658, _S659, _S681, _S682);
    return make_float3 (_S683.y) * value_1 + make_float3 (_S683.x);
}

__device__ bool unoccluded_0(uint _S684, float _S685, float _S686, float _S687, float3  _S688, bool _S689)
{
    Fabric_0 * _S690 = (&(globalParams_0->fabrics_0)[_S684]);
    if((_S688.z) <= 0.0f)
    {
        return false;
    }
    float _S691 = max_height_along_0(_S684, _S685, _S686, _S687, _S688, _S689);
    float _S692 = __ldg(&_S690->lift_0);
    bool _S693 = is_free_0(_S684, make_float3 (_S685, _S686, _S687 + _S692), _S688, _S689, _S691);
    return _S693;
}

__device__ bool is_lit_0(uint _S694, YarnPoint_0 * _S695, float3  _S696)
{
    if(_S695->hole_2)
    {
        return true;
    }
    bool _S697 = _S695->back_2;
    float3  _S698 = to_face_frame_0(_S696, _S695->back_2);
    float _S699 = _S698.z;
    bool _S700 = _S699 < 0.0f;
    float3  _S701 = _S695->normal_4;
    float _S702 = _S695->height_4;
    float3  normal_6;
    float height_10;
    if(_S700)
    {
        SurfacePoint_0 _S703 = surface_at_0(_S694, _S695->x_18, _S695->y_10, !_S697);
        normal_6 = _S703.normal_5;
        height_10 = _S703.height_9;
    }
    else
    {
        normal_6 = _S701;
        height_10 = _S702;
    }
    float3  _S704 = make_float3 (float2 {_S698.x, _S698.y}.x, float2 {_S698.x, _S698.y}.y, (F32_abs((_S699))));
    if((dot_0(normal_6, _S704)) <= 0.0f)
    {
        return false;
    }
    bool _S705 = unoccluded_0(_S694, _S695->x_18, _S695->y_10, height_10, _S704, _S697 != _S700);
    return _S705;
}

__device__ float3  evaluate_0(uint _S706, YarnPoint_0 * _S707, float3  _S708, float3  _S709)
{
    float3  _S710 = scattered_0(_S706, _S707, to_face_frame_0(_S708, _S707->back_2), to_face_frame_0(_S709, _S707->back_2));
    bool _S711;
    if((F32_max((_S710.x), ((F32_max((_S710.y), (_S710.z)))))) <= 0.0f)
    {
        _S711 = true;
    }
    else
    {
        bool _S712 = is_lit_0(_S706, _S707, _S708);
        _S711 = !_S712;
    }
    if(_S711)
    {
        return make_float3 (0.0f);
    }
    return _S710;
}

__device__ float straight_through_0(uint _S713, YarnPoint_0 * _S714, float3  _S715)
{
    Fabric_0 * _S716 = (&(globalParams_0->fabrics_0)[_S713]);
    if(!_S714->hole_2)
    {
        return 0.0f;
    }
    float _S717 = __ldg(&_S716->sheen_strength_0);
    if(_S717 <= 0.0f)
    {
        return 1.0f;
    }
    float _S718 = (F32_abs((_S715.z)));
    float _S719 = __ldg(&_S716->sheen_roughness_0);
    return 1.0f - _S717 * sheen_lobe_0(_S718, _S719).z;
}

__device__ float4  direct_light_0(Frame_0 * _S720, uint _S721, VisiblePoint_0 * _S722, float2  _S723)
{
    float3  _S724 = to_local_0(_S722, _S722->view_0);
    YarnPoint_0 _S725 = locate_yarn_0(_S721, _S723.x, _S723.y, _S724);
    float3  _S726 = make_float3 (0.0f);
    uint number_1 = 0U;
    float3  radiance_1 = _S726;
    for(;;)
    {
        if(number_1 < (_S720->lights_0))
        {
        }
        else
        {
            break;
        }
        Light_0 _S727 = slang_ldg_3((&(globalParams_0->lights_1)[number_1]));
        Light_0 _S728 = _S727;
        float3  irradiance_1;
        float3  _S729 = towards_light_0(&_S728, _S722->position_0, &irradiance_1);
        float3  _S730 = to_local_0(_S722, _S729);
        YarnPoint_0 _S731 = _S725;
        float3  _S732 = evaluate_0(_S721, &_S731, _S730, _S724);
        float3  radiance_2 = radiance_1 + irradiance_1 * _S732;
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    YarnPoint_0 _S733 = _S725;
    float _S734 = straight_through_0(_S721, &_S733, _S724);
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - _S734);
}

extern "C" __global__ void shade()
{
    uint _S735;
    uint3  _S736 = blockIdx * blockDim + threadIdx;
    Frame_0 _S737 = slang_ldg_0((&(globalParams_0->frames_0)[int(0)]));
    bool _S738;
    if((_S736.x) >= (_S737.width_0))
    {
        _S738 = true;
    }
    else
    {
        _S738 = (_S736.y) >= (_S737.height_0);
    }
    if(_S738)
    {
        return;
    }
    uint2  _S739 = uint2 {_S736.x, _S736.y};
    uint _S740 = _S739.y * _S737.width_0 + _S739.x;
    int2  _S741 = make_int2 ((int)_S739.x, (int)_S739.y);
    int3  _S742 = make_int3 (_S741.x, _S741.y, int(0));
    uint _S743 = (tex2Dfetch_int<uint>((globalParams_0->visible_faces_0), ((_S742)).x, ((_S742)).y, ((_S742)).z));
    float4  sum_0 = make_float4 (0.0f);
    if(_S743 > 0U)
    {
        uint _S744 = _S743 - 1U;
        uint _S745 = __ldg((&(globalParams_0->face_fabrics_0)[_S744]));
        Frame_0 _S746 = _S737;
        VisiblePoint_0 _S747 = visible_point_0(&_S746, _S745, _S744, _S739);
        uint k_0 = 0U;
        for(;;)
        {
            _S735 = _S737.samples_0;
            if(k_0 < (_S737.samples_0))
            {
            }
            else
            {
                break;
            }
            float2  _S748 = footprint_sample_0(_S739, _S737.pass_number_0 * _S737.samples_0 + k_0);
            float2  _S749 = _S747.draft_0 + make_float2 (_S748.x) * _S747.draft_dx_0 + make_float2 (_S748.y) * _S747.draft_dy_0;
            Frame_0 _S750 = _S737;
            VisiblePoint_0 _S751 = _S747;
            float4  _S752 = direct_light_0(&_S750, _S745, &_S751, _S749);
            sum_0 = sum_0 + _S752;
            k_0 = k_0 + 1U;
        }
        sum_0 = sum_0 / make_float4 (float(_S735));
    }
    float4  _S753 = sum_0;
    float3  _S754 = float3 {_S753.x, _S753.y, _S753.z} + make_float3 (1.0f - sum_0.w) * make_float3 (_S737.background_red_0, _S737.background_green_0, _S737.background_blue_0);
    sum_0.x = _S754.x;
    sum_0.y = _S754.y;
    sum_0.z = _S754.z;
    float4  * _S755 = (&(globalParams_0->radiance_0)[_S740]);
    float4  _S756;
    if((_S737.pass_number_0) == 0U)
    {
        _S756 = sum_0;
    }
    else
    {
        _S756 = *(&(globalParams_0->radiance_0)[_S740]) + sum_0;
    }
    *_S755 = _S756;
    return;
}

