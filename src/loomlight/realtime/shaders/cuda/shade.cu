#include <slang-cuda-prelude.h>
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
    StructuredBuffer<Family_0> families_0;
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

__device__ Vertex_0 slang_ldg_1(Vertex_0 * ptr_1)
{
    float _S32 = __ldg(&ptr_1->x_1);
    float _S33 = __ldg(&ptr_1->y_1);
    float _S34 = __ldg(&ptr_1->z_1);
    float _S35 = __ldg(&ptr_1->normal_x_0);
    float _S36 = __ldg(&ptr_1->normal_y_0);
    float _S37 = __ldg(&ptr_1->normal_z_0);
    float _S38 = __ldg(&ptr_1->u_0);
    float _S39 = __ldg(&ptr_1->v_0);
    Vertex_0 _S40 = { _S32, _S33, _S34, _S35, _S36, _S37, _S38, _S39 };
    return _S40;
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
    uint _S41 = value_0 * 747796405U + 2891336453U;
    uint _S42 = ((_S41 >> ((_S41 >> int(28)) + 4U)) ^ _S41) * 277803737U;
    return (_S42 >> int(22)) ^ _S42;
}

__device__ float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  footprint_sample_0(uint2  pixel_0, uint index_0)
{
    uint _S43 = pixel_0.x;
    uint _S44 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S43, _S44, 1U), uniform_hash_0(_S43, _S44, 2U)) + make_float2 (float(index_0 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f)) - make_float2 (0.5f);
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

__device__ SearchQuality_0 default_quality_0()
{
    SearchQuality_0 quality_0;
    (&quality_0)->steps_per_thread_0 = 5.0f;
    (&quality_0)->steps_per_relief_0 = 8.0f;
    (&quality_0)->shadow_share_0 = 1.0f;
    (&quality_0)->refinements_0 = 2U;
    return quality_0;
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
    float2  _S45 = float2 {direction_1.x, direction_1.y};
    float _S46;
    if(back_0)
    {
        _S46 = - direction_1.z;
    }
    else
    {
        _S46 = direction_1.z;
    }
    return make_float3 (_S45.x, _S45.y, _S46);
}

__device__ Family_0 slang_ldg_2(Family_0 * ptr_2)
{
    uint _S47 = __ldg(&ptr_2->is_alike_0);
    float _S48 = __ldg(&ptr_2->count_0);
    float _S49 = __ldg(&ptr_2->inverse_count_0);
    float _S50 = __ldg(&ptr_2->half_inverse_count_0);
    float _S51 = __ldg(&ptr_2->size_0);
    float _S52 = __ldg(&ptr_2->inverse_size_0);
    float _S53 = __ldg(&ptr_2->half_width_0);
    float _S54 = __ldg(&ptr_2->start_0);
    float _S55 = __ldg(&ptr_2->period_0);
    float _S56 = __ldg(&ptr_2->inverse_period_0);
    float _S57 = __ldg(&ptr_2->bins_0);
    uint _S58 = __ldg(&ptr_2->first_thread_table_0);
    uint _S59 = __ldg(&ptr_2->place_table_0);
    uint _S60 = __ldg(&ptr_2->bend_table_0);
    float _S61 = __ldg(&ptr_2->height_scale_0);
    float _S62 = __ldg(&ptr_2->twist_sine_0);
    float _S63 = __ldg(&ptr_2->twist_cosine_0);
    float _S64 = __ldg(&ptr_2->level_0);
    float _S65 = __ldg(&ptr_2->roughness_0);
    uint _S66 = __ldg(&ptr_2->albedo_table_0);
    uint _S67 = __ldg(&ptr_2->albedo_stride_0);
    uint _S68 = __ldg(&ptr_2->before_0);
    float _S69 = __ldg(&ptr_2->visible_total_0);
    float _S70 = __ldg(&ptr_2->smallest_box_0);
    uint _S71 = __ldg(&ptr_2->quantities_0);
    uint _S72 = __ldg(&ptr_2->colour_mean_0);
    uint _S73 = __ldg(&ptr_2->colour_axes_0);
    uint _S74 = __ldg(&ptr_2->colour_threads_0);
    uint _S75 = __ldg(&ptr_2->colour_areas_0);
    float _S76 = __ldg(&ptr_2->area_unit_0);
    float _S77 = __ldg(&ptr_2->crossing_area_0);
    Family_0 _S78 = { _S47, _S48, _S49, _S50, _S51, _S52, _S53, _S54, _S55, _S56, _S57, _S58, _S59, _S60, _S61, _S62, _S63, _S64, _S65, _S66, _S67, _S68, _S69, _S70, _S71, _S72, _S73, _S74, _S75, _S76, _S77 };
    return _S78;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_1)
{
    Family_0 _S79 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    Family_0 _S80 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    float _S81 = (F32_floor(((F32_fma((index_1), (_S79.inverse_count_0), (_S80.half_inverse_count_0))))));
    float _S82 = - _S81;
    Family_0 _S83 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S81, (F32_fma((_S82), (_S83.count_0), (index_1))));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_1)
{
    Family_0 _S84 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S85 = (F32_floor((position_1 * _S84.inverse_size_0)));
    Cell_0 cell_1;
    float _S86 = - _S85;
    Family_0 _S87 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S88 = (F32_fma((_S86), (_S87.size_0), (position_1)));
    (&cell_1)->below_0 = _S88;
    Family_0 _S89 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->above_0 = _S89.size_0 - _S88;
    Family_0 _S90 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->across_0 = _S88 - 0.5f * _S90.size_0;
    Family_0 _S91 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->half_width_1 = _S91.half_width_0;
    float _S92 = turns_and_remainder_0(family_1, _S85).y;
    Family_0 _S93 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->thread_1 = uint(clamp_0(_S92, 0.0f, _S93.count_0 - 1.0f));
    return cell_1;
}

__device__ float table_number_0(uint index_2)
{
    uint _S94 = __ldg((&(globalParams_0->words_0)[index_2]));
    return (U32_asfloat((_S94)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_2)
{
    Family_0 _S95 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S96 = position_2 - _S95.start_0;
    Family_0 _S97 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S96 * _S97.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S98 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S99 = turns_1 * _S98.period_0;
    Family_0 _S100 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S101 = turns_1 * _S100.bins_0;
    Family_0 _S102 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S103 = uint(clamp_0(_S101, 0.0f, _S102.bins_0 - 1.0f));
    Family_0 _S104 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S105 = __ldg((&(globalParams_0->words_0)[_S104.first_thread_table_0 + _S103]));
    Family_0 _S106 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S107;
    if(_S99 >= (table_number_0(_S106.place_table_0 + _S105 * 4U + 1U)))
    {
        _S107 = 1U;
    }
    else
    {
        _S107 = 0U;
    }
    uint _S108 = _S105 + _S107;
    Family_0 _S109 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S110 = (U32_min((_S108), (uint(_S109.count_0) - 1U)));
    Family_0 _S111 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S112 = _S111.place_table_0 + _S110 * 4U;
    Cell_0 cell_2;
    (&cell_2)->thread_1 = _S110;
    (&cell_2)->below_0 = _S99 - table_number_0(_S112);
    (&cell_2)->above_0 = table_number_0(_S112 + 1U) - _S99;
    (&cell_2)->across_0 = _S99 - table_number_0(_S112 + 2U);
    (&cell_2)->half_width_1 = table_number_0(_S112 + 3U);
    return cell_2;
}

__device__ Cell_0 locate_0(uint family_3, float position_3)
{
    Family_0 _S113 = slang_ldg_2((&(globalParams_0->families_0)[family_3]));
    if((_S113.is_alike_0) != 0U)
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

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_1)
{
    bool _S114 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S115 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S116;
    if(_S114)
    {
        if(!_S115)
        {
            _S116 = true;
        }
        else
        {
            _S116 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S116 = false;
    }
    (&shown_0)->is_warp_0 = _S116;
    if(!_S114)
    {
        _S116 = !_S115;
    }
    else
    {
        _S116 = false;
    }
    (&shown_0)->hole_0 = _S116;
    uint _S117;
    if((&shown_0)->is_warp_0)
    {
        _S117 = crossing_0->warp_word_0;
    }
    else
    {
        _S117 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S117;
    (&shown_0)->on_top_0 = ((_S117 & 1U) == 1U) != back_1;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_3;
    uint _S118;
    if(is_first_0)
    {
        _S118 = first_0->thread_1;
    }
    else
    {
        _S118 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S118;
    float _S119;
    if(is_first_0)
    {
        _S119 = first_0->across_0;
    }
    else
    {
        _S119 = second_0->across_0;
    }
    (&cell_3)->across_0 = _S119;
    if(is_first_0)
    {
        _S119 = first_0->half_width_1;
    }
    else
    {
        _S119 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S119;
    if(is_first_0)
    {
        _S119 = first_0->below_0;
    }
    else
    {
        _S119 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S119;
    if(is_first_0)
    {
        _S119 = first_0->above_0;
    }
    else
    {
        _S119 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S119;
    return cell_3;
}

__device__ float boundary_0(uint family_4, uint thread_2, int step_0)
{
    float2  _S120 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    float _S121 = _S120.x;
    Family_0 _S122 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    Family_0 _S123 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S121), (_S122.period_0), (table_number_0(_S123.place_table_0 + uint(_S120.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_3, int first_1, int last_0)
{
    Family_0 _S124 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    if((_S124.is_alike_0) != 0U)
    {
        float _S125 = float(last_0 - first_1);
        Family_0 _S126 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
        return _S125 * _S126.size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(uint family_6, uint thread_4)
{
    Family_0 _S127 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    Family_0 _S128 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    uint _S129;
    if((_S128.is_alike_0) != 0U)
    {
        _S129 = 0U;
    }
    else
    {
        _S129 = thread_4 * 4U;
    }
    uint _S130 = _S127.bend_table_0 + _S129;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S130);
    (&bend_0)->half_tangent_0 = table_number_0(_S130 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S130 + 2U);
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

__device__ Run_0 unpack_0(uint own_0, uint other_0, uint thread_5, Cell_0 * crossed_0, uint word_1)
{
    int _S131 = int((word_1 >> int(1)) & 127U);
    int _S132 = int((word_1 >> int(8)) & 127U);
    int _S133 = int((word_1 >> int(15)) & 63U);
    int _S134 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S135 = crossed_0->thread_1;
    int _S136 = - _S131;
    float _S137 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_1, _S136, int(0));
    (&run_0)->from_start_0 = _S137;
    int _S138 = _S132 + int(1);
    float _S139 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_1, int(1), _S138);
    (&run_0)->to_end_0 = _S139;
    bool _S140 = _S137 < _S139;
    (&run_0)->near_start_0 = _S140;
    int _S141;
    if(_S140)
    {
        _S141 = _S136 - _S133;
    }
    else
    {
        _S141 = _S138;
    }
    int _S142;
    if((&run_0)->near_start_0)
    {
        _S142 = _S136;
    }
    else
    {
        _S142 = _S138 + _S134;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_5);
    float _S143;
    if((&run_0)->straight_0)
    {
        _S143 = 1.0e+06f;
    }
    else
    {
        _S143 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S143;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S135, _S141, _S142)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S131 == int(0);
    (&run_0)->last_crossing_0 = _S132 == int(0);
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
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_4)
{
    float _S144 = cell_4->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S145 = clamp_0(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_1 = _S145;
    float _S146 = _S144 * _S144 - square_1(_S145);
    float _S147 = (F32_rsqrt((_S146)));
    (&section_0)->drop_0 = _S144 - _S146 * _S147;
    (&section_0)->slope_0 = - _S145 * _S147;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    Family_0 _S148 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    if((_S148.is_alike_0) != 0U)
    {
        Family_0 _S149 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S149.bend_table_0 + 3U);
    }
    Family_0 _S150 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S150.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S151 = crossed_1->below_0;
    float _S152 = crossed_1->above_0;
    bool _S153 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S154 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S155;
    if(_S153)
    {
        _S155 = _S151 - crossed_1->across_0;
    }
    else
    {
        _S155 = _S152 + crossed_1->across_0;
    }
    float _S156 = _S155 - crossed_1->half_width_1;
    bool _S157;
    if(_S153)
    {
        _S157 = run_1->first_crossing_0;
    }
    else
    {
        _S157 = run_1->last_crossing_0;
    }
    bool _S158 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S155 = 0.0f;
    }
    else
    {
        Family_0 _S159 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        _S155 = _S159.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_1, int(0));
    }
    float _S160;
    if(_S158 != _S157)
    {
        _S160 = 0.0f;
    }
    else
    {
        Family_0 _S161 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        uint _S162 = crossed_1->thread_1;
        int _S163;
        if(_S153)
        {
            _S163 = int(-1);
        }
        else
        {
            _S163 = int(1);
        }
        _S160 = _S161.height_scale_0 * edge_drop_0(other_1, _S162, _S163);
    }
    float _S164 = 1.0f / (F32_max((2.0f * _S156), (9.999999960041972e-13f)));
    float _S165 = clamp_0((_S156 - _S154) * _S164, 0.0f, 1.0f);
    float _S166 = _S155 + (_S160 - _S155) * (_S165 * _S165 * (3.0f - 2.0f * _S165));
    float _S167 = (_S155 - _S160) * (6.0f * _S165 * (1.0f - _S165) * _S164);
    if(_S153)
    {
        _S155 = 1.0f;
    }
    else
    {
        _S155 = -1.0f;
    }
    return make_float2 (_S166, _S167 * _S155);
}

struct StepControl_0
{
    float step_2;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_1;
    bool up_0;
};

__device__ StepControl_0 step_control_0(float2  direction_2, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S168 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S168)))), (9.99999971718068537e-10f)));
    float _S169 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S169)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S168 > 0.0f;
    (&control_0)->up_0 = _S169 > 0.0f;
    return control_0;
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

__device__ float outline_distance_0(Cell_0 * cell_5, Shown_0 * shown_2, Run_0 * run_2, bool lengthwise_0, bool forwards_0)
{
    float _S170;
    if(forwards_0)
    {
        _S170 = cell_5->across_0;
    }
    else
    {
        _S170 = - cell_5->across_0;
    }
    float _S171;
    if(forwards_0)
    {
        _S171 = cell_5->above_0;
    }
    else
    {
        _S171 = cell_5->below_0;
    }
    bool _S172;
    if(forwards_0)
    {
        _S172 = run_2->last_crossing_0;
    }
    else
    {
        _S172 = run_2->first_crossing_0;
    }
    bool _S173;
    if(forwards_0)
    {
        _S173 = run_2->first_crossing_0;
    }
    else
    {
        _S173 = run_2->last_crossing_0;
    }
    float _S174 = cell_5->half_width_1;
    float _S175 = - cell_5->half_width_1;
    bool _S176 = _S170 < _S175;
    bool _S177 = _S170 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S172 = !_S172;
    }
    else
    {
        _S172 = false;
    }
    if(_S172)
    {
        _S172 = !shown_2->hole_0;
    }
    else
    {
        _S172 = false;
    }
    bool _S178;
    if(_S172)
    {
        _S178 = shown_2->on_top_0;
    }
    else
    {
        _S178 = false;
    }
    if(_S178)
    {
        if(_S173)
        {
            _S173 = _S176;
        }
        else
        {
            _S173 = false;
        }
        _S173 = !_S173;
    }
    else
    {
        _S173 = false;
    }
    if(shown_2->hole_0)
    {
        _S172 = true;
    }
    else
    {
        if(_S172)
        {
            _S172 = !shown_2->on_top_0;
        }
        else
        {
            _S172 = false;
        }
    }
    float _S179;
    if(_S176)
    {
        _S179 = _S175;
    }
    else
    {
        _S179 = _S174;
    }
    float _S180 = _S179 - _S170;
    if(_S172)
    {
        _S170 = 2.0f * _S171 + _S170 - _S174;
    }
    else
    {
        _S170 = _S171;
    }
    if(_S173)
    {
        if(forwards_0)
        {
            _S170 = run_2->to_end_0;
        }
        else
        {
            _S170 = run_2->from_start_0;
        }
        return _S170;
    }
    if(_S177)
    {
    }
    else
    {
        _S170 = _S180;
    }
    return _S170;
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

__device__ float way_back_to_dip_0(PreviousSample_0 * previous_1, float clearance_1, float rate_1, float step_4, Probe_0 * here_0)
{
    float _S181 = previous_1->rate_0;
    float _S182 = previous_1->rate_0 * step_4;
    float _S183 = rate_1 * step_4;
    bool _S184;
    if(!previous_1->known_0)
    {
        _S184 = true;
    }
    else
    {
        _S184 = here_0->hole_1;
    }
    if(_S184)
    {
        _S184 = true;
    }
    else
    {
        _S184 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S184)
    {
        _S184 = true;
    }
    else
    {
        _S184 = _S181 >= 0.0f;
    }
    if(_S184)
    {
        _S184 = true;
    }
    else
    {
        _S184 = rate_1 <= 0.0f;
    }
    if(_S184)
    {
        return -1.0f;
    }
    float _S185 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S182) >= 0.0f)
    {
        _S184 = (3.0f * clearance_1 - _S183) >= 0.0f;
    }
    else
    {
        _S184 = false;
    }
    if(_S184)
    {
        return -1.0f;
    }
    float _S186 = clearance_1 - _S185;
    float _S187 = 6.0f * _S186 - 4.0f * _S182 - 2.0f * _S183;
    float _S188 = -2.0f * _S182 / (F32_max((_S187 + (F32_sqrt(((F32_max((_S187 * _S187 - 4.0f * (3.0f * (_S182 + _S183 - 2.0f * _S186)) * _S182), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S189 = 1.0f - _S188;
    float _S190 = (_S185 * (2.0f * _S188 + 1.0f) + _S182 * _S188) * _S189 * _S189;
    float _S191 = (clearance_1 * (2.0f * _S189 + 1.0f) - _S183 * _S189) * _S188 * _S188;
    if(_S188 > 0.01999999955296516f)
    {
        _S184 = _S189 > 0.01999999955296516f;
    }
    else
    {
        _S184 = false;
    }
    if(_S184)
    {
        _S184 = (_S190 + _S191) < 0.0f;
    }
    else
    {
        _S184 = false;
    }
    float _S192;
    if(_S184)
    {
        _S192 = _S189 * step_4;
    }
    else
    {
        _S192 = -1.0f;
    }
    return _S192;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S193 = here_1->hole_1;
    float _S194;
    if(here_1->hole_1)
    {
        _S194 = 1.0e+09f;
    }
    else
    {
        _S194 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S194;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S195;
    if(!_S193)
    {
        _S195 = !is_cell_exit_0;
    }
    else
    {
        _S195 = false;
    }
    (&previous_2)->known_0 = _S195;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_0, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_0->per_x_0), (side_y_1 * this_0->per_y_0)))), (0.0f))) + this_0->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_1, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S196 = (F32_min((here_2->edge_x_0 * this_1->per_x_0), (here_2->edge_y_0 * this_1->per_y_0)));
    bool _S197;
    if(!here_2->hole_1)
    {
        _S197 = (rate_3 * _S196 + clearance_3) < 0.0f;
    }
    else
    {
        _S197 = false;
    }
    if(_S197)
    {
        _S197 = _S196 > (2.0f * this_1->epsilon_0);
    }
    else
    {
        _S197 = false;
    }
    float _S198 = this_1->step_2;
    float _S199;
    if(_S197)
    {
        _S199 = _S196 - this_1->epsilon_0;
    }
    else
    {
        _S199 = (F32_max((_S196), (0.0f))) + this_1->epsilon_0;
    }
    return (F32_min((_S198), (_S199)));
}

struct ViewRay_0
{
    float2  origin_0;
    float2  slope_1;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_2, float height_2)
{
    return this_2->origin_0 + this_2->slope_1 * make_float2 (height_2);
}

__device__ float ViewRay_rate_0(ViewRay_0 * this_3, Probe_0 * here_3)
{
    return here_3->slope_x_0 * this_3->slope_1.x + here_3->slope_y_0 * this_3->slope_1.y - 1.0f;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S200 = end_0 - start_1;
    float _S201 = start_rate_0 + end_rate_0 - 2.0f * _S200;
    float _S202 = 3.0f * _S200 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / (F32_max((- _S200), (9.99999968265522539e-21f)));
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
        float _S203 = clamp_0(share_0 - (((_S201 * share_0 + _S202) * share_0 + start_rate_0) * share_0 + start_1) / (F32_min(((3.0f * _S201 * share_0 + 2.0f * _S202) * share_0 + start_rate_0), (0.10000000149011612f * _S200 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S204 = i_5 + int(1);
        share_0 = _S203;
        i_5 = _S204;
    }
    return share_0;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S205 = along_slope_0 * along_slope_0 + 1.0f;
    float _S206 = (F32_rsqrt((_S205)));
    float _S207 = sine_1 * _S206 * (F32_rsqrt((_S205 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S207 * _S205, _S207 * across_slope_0 * along_slope_0 + cosine_0 * _S206);
}

__device__ float arc_sine_0(float x_12)
{
    float _S208 = (F32_abs((x_12)));
    bool _S209 = _S208 > 0.5f;
    float _S210;
    if(_S209)
    {
        _S210 = 0.5f * (1.0f - _S208);
    }
    else
    {
        _S210 = _S208 * _S208;
    }
    float _S211;
    if(_S209)
    {
        _S211 = (F32_sqrt(((F32_max((_S210), (0.0f))))));
    }
    else
    {
        _S211 = _S208;
    }
    float _S212 = ((((0.04216320067644119f * _S210 + 0.02418131195008755f) * _S210 + 0.04547002539038658f) * _S210 + 0.07495300471782684f) * _S210 + 0.16666752099990845f) * _S210 * _S211 + _S211;
    if(_S209)
    {
        _S210 = 1.57079637050628662f - 2.0f * _S212;
    }
    else
    {
        _S210 = _S212;
    }
    if(x_12 < 0.0f)
    {
        _S210 = - _S210;
    }
    return _S210;
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

__device__ Albedos_0 albedos_of_0(uint family_8, uint thread_7)
{
    Family_0 _S213 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    Family_0 _S214 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint _S215 = _S213.albedo_table_0 + _S214.albedo_stride_0 * thread_7;
    Albedos_0 albedos_0;
    (&albedos_0)->diffuse_reflect_0 = table_colour_0(_S215);
    (&albedos_0)->diffuse_transmit_0 = table_colour_0(_S215 + 3U);
    (&albedos_0)->specular_reflect_0 = table_colour_0(_S215 + 6U);
    (&albedos_0)->specular_transmit_0 = table_colour_0(_S215 + 9U);
    return albedos_0;
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_0, float3  room_0)
{
    float3  _S216 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S216.x), (_S216.y)))), (_S216.z)))), (0.0f))))));
}

__device__ float natural_logarithm_0(float x_13)
{
    uint _S217 = (F32_asuint((x_13)));
    float exponent_0 = float(int(_S217 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S217 & 8388607U) | 1056964608U)));
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
    float _S218 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S218 - exponent_1 * 0.00021219444170129f - 0.5f * _S218) + exponent_1 * 0.693359375f;
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ Light_0 slang_ldg_3(Light_0 * ptr_3)
{
    uint _S219 = __ldg(&ptr_3->is_point_0);
    float _S220 = __ldg(&ptr_3->x_0);
    float _S221 = __ldg(&ptr_3->y_0);
    float _S222 = __ldg(&ptr_3->z_0);
    float _S223 = __ldg(&ptr_3->red_0);
    float _S224 = __ldg(&ptr_3->green_0);
    float _S225 = __ldg(&ptr_3->blue_0);
    Light_0 _S226 = { _S219, _S220, _S221, _S222, _S223, _S224, _S225 };
    return _S226;
}

__device__ float3  towards_light_0(Light_0 * light_0, float3  position_4, float3  * irradiance_1)
{
    *irradiance_1 = make_float3 (light_0->red_0, light_0->green_0, light_0->blue_0);
    float3  _S227 = make_float3 (light_0->x_0, light_0->y_0, light_0->z_0);
    if((light_0->is_point_0) == 0U)
    {
        return _S227;
    }
    float3  _S228 = _S227 - position_4;
    *irradiance_1 = *irradiance_1 / make_float3 ((F32_max((square_0(_S228)), (9.999999960041972e-13f))));
    return normalize_0(_S228);
}

__device__ float diffuse_reflection_0(float3  light_1, float3  normal_1, float blend_0)
{
    float _S229 = light_1.z;
    if(_S229 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S229), (0.0f))), (F32_max((dot_0(light_1, normal_1)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_3, float3  tangent_0, float roughness_1)
{
    float _S230 = dot_0(direction_3, tangent_0);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S230 * _S230 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_14)
{
    float _S231 = clamp_0(x_14, -87.0f, 88.0f);
    float _S232 = (F32_floor((_S231 * 1.4426950216293335f + 0.5f)));
    float _S233 = _S231 - _S232 * 0.693359375f + _S232 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S233 + 0.00139819993637502f) * _S233 + 0.00833345204591751f) * _S233 + 0.04166579619050026f) * _S233 + 0.1666666567325592f) * _S233 + 0.5f;
    float _S234 = (U32_asfloat((uint(int(_S232) + int(127)) << int(23))));
    float _S235;
    if(x_14 < -87.0f)
    {
        _S235 = 0.0f;
    }
    else
    {
        _S235 = (p_0 * _S233 * _S233 + _S233 + 1.0f) * _S234;
    }
    return _S235;
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
    float _S236 = roughness_2 * roughness_2;
    float _S237 = squared_along_0 * (1.0f - _S236) + _S236;
    return 0.31830987334251404f * _S236 * roughness_2 / (_S237 * _S237);
}

__device__ float density_between_0(float3  light_2, float3  view_1, float3  tangent_1, float roughness_3)
{
    float3  _S238 = light_2 + view_1;
    float _S239 = dot_0(_S238, tangent_1);
    return flake_density_0((F32_min((_S239 * _S239 / (F32_max((square_0(_S238)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_3, float3  view_2, float3  normal_2, float3  tangent_2, float roughness_4, float optical_depth_1)
{
    float _S240 = dot_0(light_3, normal_2);
    bool _S241;
    if(_S240 <= 0.0f)
    {
        _S241 = true;
    }
    else
    {
        _S241 = (dot_0(view_2, normal_2)) <= 0.0f;
    }
    if(_S241)
    {
        return 0.0f;
    }
    float _S242 = (F32_max((_S240), (9.99999997475242708e-07f)));
    float _S243 = (F32_max((dot_0(view_2, normal_2)), (9.99999997475242708e-07f)));
    float _S244 = projected_area_1(light_3, tangent_2, roughness_4) * _S243 + projected_area_1(view_2, tangent_2, roughness_4) * _S242;
    float _S245 = optical_depth_1 * _S244 / (_S242 * _S243);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S245 * mean_attenuation_0(_S245)) * _S242 / _S244;
}

__device__ float transmission_0(float3  light_4, float3  view_3, float3  normal_3, float3  tangent_3, float roughness_5, float optical_depth_2)
{
    float _S246 = - dot_0(light_4, normal_3);
    float _S247 = dot_0(view_3, normal_3);
    bool _S248;
    if(_S246 <= 0.0f)
    {
        _S248 = true;
    }
    else
    {
        _S248 = _S247 <= 0.0f;
    }
    if(_S248)
    {
        return 0.0f;
    }
    float _S249 = 1.0f / (F32_max((_S247), (9.99999997475242708e-07f)));
    float _S250 = projected_area_1(light_4, tangent_3, roughness_5) / (F32_max((_S246), (9.99999997475242708e-07f)));
    float _S251 = projected_area_1(view_3, tangent_3, roughness_5) * _S249;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S250), (_S251)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S250 - _S251)))) * _S249;
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
    float _S252 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S253 = 2.0f * (F32_sqrt((_S252))) - 1.0f;
    float _S254 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S253, _S254), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S252) * sheen_shear_0(_S253, _S254), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S253, _S254), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_5, float3  view_4, float scale_0, float shear_0)
{
    float _S255 = light_5.z;
    bool _S256;
    if(_S255 <= 0.0f)
    {
        _S256 = true;
    }
    else
    {
        _S256 = (view_4.z) <= 0.0f;
    }
    if(_S256)
    {
        return 0.0f;
    }
    float2  _S257 = float2 {view_4.x, view_4.y};
    float _S258 = dot_1(_S257, _S257);
    float2  _S259;
    if(_S258 > 9.99999968265522539e-21f)
    {
        _S259 = _S257 * make_float2 ((F32_rsqrt((_S258))));
    }
    else
    {
        _S259 = make_float2 (1.0f, 0.0f);
    }
    float _S260 = scale_0 * dot_1(float2 {light_5.x, light_5.y}, _S259) + shear_0 * _S255;
    float _S261 = scale_0 * (light_5.y * _S259.x - light_5.x * _S259.y);
    float _S262 = _S260 * _S260 + _S261 * _S261 + _S255 * _S255;
    return 0.31830987334251404f * scale_0 * scale_0 * _S255 / (F32_max((_S262 * _S262), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_6, float3  view_5, float strength_0, float roughness_7)
{
    float3  _S263 = sheen_lobe_0(view_5.z, roughness_7);
    float _S264 = strength_0 * _S263.z;
    return make_float2 (_S264 * transformed_cosine_0(light_6, view_5, _S263.x, _S263.y), 1.0f - _S264);
}

__device__ VisiblePoint_0 visible_point_0(Frame_0 * _S265, uint _S266, uint _S267, uint2  _S268)
{
    Fabric_0 * _S269 = (&(globalParams_0->fabrics_0)[_S266]);
    uint _S270 = 3U * _S267;
    uint _S271 = __ldg((&(globalParams_0->corners_0)[_S270]));
    Vertex_0 _S272 = slang_ldg_1((&(globalParams_0->vertices_0)[_S271]));
    uint _S273 = __ldg((&(globalParams_0->corners_0)[_S270 + 1U]));
    Vertex_0 _S274 = slang_ldg_1((&(globalParams_0->vertices_0)[_S273]));
    uint _S275 = __ldg((&(globalParams_0->corners_0)[_S270 + 2U]));
    Vertex_0 _S276 = slang_ldg_1((&(globalParams_0->vertices_0)[_S275]));
    Vertex_0 _S277 = _S274;
    float3  _S278 = position_of_0(&_S277);
    Vertex_0 _S279 = _S272;
    float3  _S280 = position_of_0(&_S279);
    float3  _S281 = _S278 - _S280;
    Vertex_0 _S282 = _S276;
    float3  _S283 = position_of_0(&_S282);
    float3  _S284 = _S283 - _S280;
    float3  _S285 = cross_0(_S281, _S284);
    float _S286 = 1.0f / (F32_max((square_0(_S285)), (1.00000000317107685e-30f)));
    float3  _S287 = camera_right_0(_S265);
    float _S288 = float(_S265->width_0);
    float3  _S289 = _S287 * make_float3 (2.0f / _S288);
    float3  _S290 = camera_up_0(_S265);
    float _S291 = float(_S265->height_0);
    float3  _S292 = _S290 * make_float3 (-2.0f / _S291);
    float _S293 = float(_S268.x) + 0.5f - 0.5f * _S288;
    float _S294 = float(_S268.y) + 0.5f - 0.5f * _S291;
    float3  _S295 = camera_forward_0(_S265);
    float3  _S296 = _S295 + make_float3 (_S293) * _S289 + make_float3 (_S294) * _S292;
    float _S297 = dot_0(_S296, _S285);
    float _S298;
    if((F32_abs((_S297))) > 1.00000000317107685e-30f)
    {
        _S298 = _S297;
    }
    else
    {
        _S298 = 1.00000000317107685e-30f;
    }
    float _S299 = 1.0f / _S298;
    float3  _S300 = camera_origin_0(_S265);
    float3  _S301 = _S280 - _S300;
    float _S302 = dot_0(_S301, _S285) * _S299;
    float3  _S303 = _S296 * make_float3 (_S302) - _S301;
    float3  _S304 = make_float3 (_S302) * (_S289 - _S296 * make_float3 (dot_0(_S289, _S285) * _S299));
    float3  _S305 = make_float3 (_S302) * (_S292 - _S296 * make_float3 (dot_0(_S292, _S285) * _S299));
    float3  _S306 = cross_0(_S284, _S285) * make_float3 (_S286);
    float3  _S307 = cross_0(_S285, _S281) * make_float3 (_S286);
    float _S308 = dot_0(_S303, _S306);
    float _S309 = dot_0(_S303, _S307);
    float _S310 = _S274.u_0 - _S272.u_0;
    float _S311 = _S274.v_0 - _S272.v_0;
    float2  _S312 = make_float2 (_S310, _S311);
    float _S313 = _S276.u_0 - _S272.u_0;
    float _S314 = _S276.v_0 - _S272.v_0;
    float2  _S315 = make_float2 (_S313, _S314);
    float2  _S316 = make_float2 (_S272.u_0, _S272.v_0) + make_float2 (_S308) * _S312 + make_float2 (_S309) * _S315;
    float2  _S317 = make_float2 (dot_0(_S304, _S306)) * _S312 + make_float2 (dot_0(_S304, _S307)) * _S315;
    float2  _S318 = make_float2 (dot_0(_S305, _S306)) * _S312 + make_float2 (dot_0(_S305, _S307)) * _S315;
    if((_S310 * _S314 - _S311 * _S313) < 0.0f)
    {
        _S298 = -1.0f;
    }
    else
    {
        _S298 = 1.0f;
    }
    float3  _S319 = make_float3 (_S298) * (make_float3 (_S314) * _S281 - make_float3 (_S311) * _S284);
    float3  _S320 = make_float3 (_S298) * (make_float3 (_S310) * _S284 - make_float3 (_S313) * _S281);
    VisiblePoint_0 point_1;
    float _S321 = 1.0f - _S308 - _S309;
    Vertex_0 _S322 = _S272;
    float3  _S323 = normal_of_0(&_S322);
    float3  _S324 = make_float3 (_S321) * _S323;
    Vertex_0 _S325 = _S274;
    float3  _S326 = normal_of_0(&_S325);
    float3  _S327 = _S324 + make_float3 (_S308) * _S326;
    Vertex_0 _S328 = _S276;
    float3  _S329 = normal_of_0(&_S328);
    float3  _S330 = normalize_0(_S327 + make_float3 (_S309) * _S329);
    (&point_1)->normal_0 = _S330;
    float3  _S331 = normalize_0(_S319 - _S330 * make_float3 (dot_0(_S330, _S319)));
    (&point_1)->axis_x_0 = _S331;
    (&point_1)->axis_y_0 = cross_0(_S330, _S331);
    (&point_1)->position_0 = _S280 + _S303;
    (&point_1)->view_0 = - normalize_0(_S296);
    bool _S332 = (dot_0(cross_0(_S319, _S320), _S330)) < 0.0f;
    float _S333 = __ldg(&_S269->uv_width_0);
    if(_S332)
    {
        float _S334 = __ldg(&_S269->uv_height_0);
        _S298 = - _S334;
    }
    else
    {
        float _S335 = __ldg(&_S269->uv_height_0);
        _S298 = _S335;
    }
    float2  _S336 = make_float2 (_S333, _S298);
    float2  _S337 = _S316 * _S336;
    if(_S332)
    {
        float _S338 = __ldg(&_S269->uv_height_0);
        _S298 = _S338;
    }
    else
    {
        _S298 = 0.0f;
    }
    (&point_1)->draft_0 = _S337 + make_float2 (0.0f, _S298);
    (&point_1)->draft_dx_0 = _S317 * _S336;
    (&point_1)->draft_dy_0 = _S318 * _S336;
    return point_1;
}

struct YarnPoint_0
{
    bool back_2;
    bool hole_2;
    bool is_warp_1;
    float x_18;
    float y_10;
    float height_3;
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

__device__ Crossing_0 crossing_at_0(uint _S339, float _S340, float _S341, bool _S342)
{
    Fabric_0 * _S343 = (&(globalParams_0->fabrics_0)[_S339]);
    Crossing_0 crossing_2;
    uint _S344 = __ldg(&_S343->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S344, _S340);
    uint _S345 = __ldg(&_S343->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S345, _S341);
    uint _S346 = __ldg(&_S343->run_words_0);
    uint _S347 = (&(&crossing_2)->weft_1)->thread_1;
    uint _S348 = __ldg(&_S343->ends_0);
    uint _S349 = _S346 + 2U * (_S347 * _S348 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S350 = __ldg((&(globalParams_0->words_0)[_S349]));
    (&crossing_2)->warp_word_0 = _S350;
    uint _S351 = __ldg((&(globalParams_0->words_0)[_S349 + 1U]));
    (&crossing_2)->weft_word_0 = _S351;
    (&crossing_2)->warp_above_0 = ((_S350 & 1U) == 1U) != _S342;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S352, float _S353, float _S354, bool _S355)
{
    Fabric_0 * _S356 = (&(globalParams_0->fabrics_0)[_S352]);
    Sample_0 sample_0;
    Crossing_0 _S357 = crossing_at_0(_S352, _S353, _S354, _S355);
    (&sample_0)->crossing_1 = _S357;
    Crossing_0 _S358 = _S357;
    Shown_0 _S359 = shown_at_0(&_S358, _S355);
    (&sample_0)->shown_3 = _S359;
    uint _S360;
    if(_S359.is_warp_0)
    {
        uint _S361 = __ldg(&_S356->warp_0);
        _S360 = _S361;
    }
    else
    {
        uint _S362 = __ldg(&_S356->weft_0);
        _S360 = _S362;
    }
    uint _S363;
    if(_S359.is_warp_0)
    {
        uint _S364 = __ldg(&_S356->weft_0);
        _S363 = _S364;
    }
    else
    {
        uint _S365 = __ldg(&_S356->warp_0);
        _S363 = _S365;
    }
    Cell_0 _S366 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S367 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S368 = select_cell_0(_S359.is_warp_0, &_S366, &_S367);
    Cell_0 _S369 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S370 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S371 = select_cell_0(_S359.is_warp_0, &_S369, &_S370);
    Cell_0 _S372 = _S371;
    Run_0 _S373 = unpack_0(_S360, _S363, _S368.thread_1, &_S372, _S359.word_0);
    Cell_0 _S374 = _S368;
    Section_0 _S375 = section_at_0(&_S374);
    bool _S376;
    if(_S359.on_top_0)
    {
        _S376 = (_S373.distance_0) < (_S375.drop_0 * _S373.bend_1.sine_0);
    }
    else
    {
        _S376 = false;
    }
    bool _S377;
    if(_S359.on_top_0)
    {
        _S377 = !_S376;
    }
    else
    {
        _S377 = false;
    }
    float _S378;
    if(_S377)
    {
        _S378 = 1.0f;
    }
    else
    {
        _S378 = -1.0f;
    }
    float _S379;
    if(_S376)
    {
        _S379 = _S373.other_reach_0;
    }
    else
    {
        _S379 = _S373.reach_0;
    }
    float _S380;
    if(_S376)
    {
        _S380 = _S379 + _S373.distance_0;
    }
    else
    {
        _S380 = (F32_max((_S379 - _S373.distance_0), (0.0f)));
    }
    float _S381 = _S379 / _S373.bend_1.sine_0 - _S378 * _S375.drop_0;
    float _S382 = _S380 * _S380;
    float _S383 = (F32_max((_S381 * _S381 - _S382), (9.99999968265522539e-21f)));
    float _S384 = (F32_rsqrt((_S383)));
    float _S385 = _S382 / (_S383 * _S384 + _S381);
    bool _S386 = _S380 > 0.0f;
    float _S387;
    if(_S359.on_top_0)
    {
        _S387 = 1.0f;
    }
    else
    {
        _S387 = -1.0f;
    }
    float _S388;
    if(_S373.near_start_0)
    {
        _S388 = 1.0f;
    }
    else
    {
        _S388 = -1.0f;
    }
    float _S389 = _S387 * _S388;
    if(_S386)
    {
        _S387 = _S381 * _S384;
    }
    else
    {
        _S387 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S375.slope_0 * _S387;
    if(_S386)
    {
        _S380 = _S389 * _S380 * _S384;
    }
    else
    {
        _S380 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S380;
    Family_0 _S390 = slang_ldg_2((&(globalParams_0->families_0)[_S360]));
    Shown_0 _S391 = _S359;
    Run_0 _S392 = _S373;
    Cell_0 _S393 = _S371;
    float2  _S394 = dive_0(_S363, &_S391, &_S392, &_S393);
    if(_S373.straight_0)
    {
        _S378 = 0.0f;
    }
    else
    {
        _S378 = _S390.height_scale_0 * _S378;
    }
    (&sample_0)->height_5 = _S378 * (_S379 * _S373.bend_1.half_tangent_0 - _S385) - _S390.height_scale_0 * _S375.drop_0 - _S394.x;
    float _S395 = _S390.height_scale_0 * (&sample_0)->slope_across_0;
    float _S396 = _S390.height_scale_0 * (&sample_0)->slope_along_0 - _S394.y;
    if(_S359.is_warp_0)
    {
        _S378 = _S395;
    }
    else
    {
        _S378 = _S396;
    }
    (&sample_0)->slope_x_1 = _S378;
    if(_S359.is_warp_0)
    {
        _S378 = _S396;
    }
    else
    {
        _S378 = _S395;
    }
    (&sample_0)->slope_y_1 = _S378;
    (&sample_0)->run_3 = _S373;
    (&sample_0)->section_1 = _S375;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S397, SearchQuality_0 * _S398, float3  _S399)
{
    Fabric_0 * _S400 = (&(globalParams_0->fabrics_0)[_S397]);
    float _S401 = (F32_abs((_S399.x)));
    float _S402 = __ldg(&_S400->threads_per_x_0);
    float _S403 = _S401 * _S402;
    float _S404 = (F32_abs((_S399.y)));
    float _S405 = __ldg(&_S400->threads_per_y_0);
    float _S406 = (F32_max((_S403), (_S404 * _S405))) * _S398->steps_per_thread_0;
    float _S407 = (F32_abs((_S399.z)));
    float _S408 = __ldg(&_S400->per_relief_0);
    return (F32_max((_S406), (_S407 * _S408 * _S398->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S409, Crossing_0 * _S410)
{
    Fabric_0 * _S411 = (&(globalParams_0->fabrics_0)[_S409]);
    bool _S412 = _S410->warp_above_0;
    uint _S413;
    if(_S410->warp_above_0)
    {
        uint _S414 = __ldg(&_S411->warp_0);
        _S413 = _S414;
    }
    else
    {
        uint _S415 = __ldg(&_S411->weft_0);
        _S413 = _S415;
    }
    uint _S416;
    if(_S412)
    {
        _S416 = _S410->warp_word_0;
    }
    else
    {
        _S416 = _S410->weft_word_0;
    }
    float _S417 = float(_S416 >> int(28));
    Family_0 _S418 = slang_ldg_2((&(globalParams_0->families_0)[_S413]));
    float _S419 = _S417 * _S418.height_scale_0;
    Family_0 _S420 = slang_ldg_2((&(globalParams_0->families_0)[_S413]));
    return _S419 * _S420.level_0;
}

__device__ Probe_0 probe_0(uint _S421, float _S422, float _S423, bool _S424, bool _S425, bool _S426)
{
    Sample_0 _S427 = sample_at_0(_S421, _S422, _S423, _S424);
    Probe_0 probe_1;
    (&probe_1)->height_1 = _S427.height_5;
    (&probe_1)->hole_1 = _S427.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S427.slope_x_1;
    (&probe_1)->slope_y_0 = _S427.slope_y_1;
    uint _S428;
    if(_S427.shown_3.is_warp_0)
    {
        _S428 = _S427.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S428 = _S427.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S428;
    Crossing_0 _S429 = _S427.crossing_1;
    float _S430 = cell_maximum_0(_S421, &_S429);
    (&probe_1)->cell_max_0 = _S430;
    float _S431;
    if(_S425)
    {
        _S431 = _S427.crossing_1.warp_1.above_0;
    }
    else
    {
        _S431 = _S427.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S431;
    if(_S426)
    {
        _S431 = _S427.crossing_1.weft_1.above_0;
    }
    else
    {
        _S431 = _S427.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S431;
    bool _S432 = !_S427.shown_3.is_warp_0;
    Cell_0 _S433 = _S427.crossing_1.warp_1;
    Shown_0 _S434 = _S427.shown_3;
    Run_0 _S435 = _S427.run_3;
    float _S436 = outline_distance_0(&_S433, &_S434, &_S435, _S432, _S425);
    (&probe_1)->edge_x_0 = _S436;
    Cell_0 _S437 = _S427.crossing_1.weft_1;
    Shown_0 _S438 = _S427.shown_3;
    Run_0 _S439 = _S427.run_3;
    float _S440 = outline_distance_0(&_S437, &_S438, &_S439, _S427.shown_3.is_warp_0, _S426);
    (&probe_1)->edge_y_0 = _S440;
    return probe_1;
}

__device__ bool is_free_0(uint _S441, SearchQuality_0 * _S442, float3  _S443, float3  _S444, bool _S445, float _S446)
{
    float _S447 = _S444.z;
    if(_S447 <= 0.0f)
    {
        return false;
    }
    float _S448 = _S442->shadow_share_0;
    float _S449 = steps_per_length_0(_S441, _S442, _S444);
    float _S450 = 1.0f / (F32_max((_S448 * _S449), (9.99999971718068537e-10f)));
    StepControl_0 _S451 = step_control_0(float2 {_S444.x, _S444.y}, _S450);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S452;
        if(count_1 < 1024U)
        {
            _S452 = (_S443.z + _S447 * distance_1) < _S446;
        }
        else
        {
            _S452 = false;
        }
        if(_S452)
        {
        }
        else
        {
            break;
        }
        float3  _S453 = _S443 + _S444 * make_float3 (distance_1);
        Probe_0 _S454 = probe_0(_S441, _S453.x, _S453.y, _S445, _S451.right_1, _S451.up_0);
        float _S455 = _S453.z;
        float _S456 = _S455 - _S454.height_1;
        float _S457 = _S447 - _S454.slope_x_0 * _S444.x - _S454.slope_y_0 * _S444.y;
        bool _S458;
        if(!_S454.hole_1)
        {
            _S458 = _S456 < 0.0f;
        }
        else
        {
            _S458 = false;
        }
        if(_S458)
        {
            return false;
        }
        PreviousSample_0 _S459 = previous_3;
        Probe_0 _S460 = _S454;
        float _S461 = way_back_to_dip_0(&_S459, _S456, _S457, last_step_0, &_S460);
        if(_S461 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S461;
            distance_1 = distance_1 - _S461;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S462 = _S455 > (_S454.cell_max_0);
        Probe_0 _S463 = _S454;
        PreviousSample_0 _S464 = after_sample_0(_S456, _S457, &_S463, _S462);
        float last_step_2;
        if(_S462)
        {
            StepControl_0 _S465 = _S451;
            float _S466 = StepControl_to_cell_exit_0(&_S465, _S454.side_x_0, _S454.side_y_0);
            last_step_2 = (F32_max((_S466), (_S450)));
        }
        else
        {
            StepControl_0 _S467 = _S451;
            Probe_0 _S468 = _S454;
            float _S469 = StepControl_to_next_sample_0(&_S467, &_S468, _S456, _S457);
            last_step_2 = _S469;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S464;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S470, SearchQuality_0 * _S471, float _S472, float _S473, float3  _S474, bool _S475)
{
    Fabric_0 * _S476 = (&(globalParams_0->fabrics_0)[_S470]);
    Sample_0 _S477 = sample_at_0(_S470, _S472, _S473, _S475);
    if(!_S477.shown_3.hole_0)
    {
        return false;
    }
    float3  _S478 = make_float3 (_S472, _S473, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S479;
        if(side_0 < 2U)
        {
            _S479 = passes_0;
        }
        else
        {
            _S479 = false;
        }
        if(_S479)
        {
        }
        else
        {
            break;
        }
        float3  _S480;
        if(side_0 == 0U)
        {
            _S480 = _S474;
        }
        else
        {
            _S480 = make_float3 (- _S474.x, - _S474.y, _S474.z);
        }
        bool _S481 = _S475 != (side_0 == 1U);
        float _S482 = __ldg(&_S476->height_high_0);
        bool _S483 = is_free_0(_S470, _S471, _S478, _S480, _S481, _S482);
        uint _S484 = side_0 + 1U;
        passes_0 = _S483;
        side_0 = _S484;
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

__device__ float max_height_along_0(uint _S485, float _S486, float _S487, float _S488, float3  _S489, bool _S490)
{
    Fabric_0 * _S491 = (&(globalParams_0->fabrics_0)[_S485]);
    uint _S492 = __ldg(&_S491->warp_0);
    uint _S493 = locate_0(_S492, _S486).thread_1 / 2U;
    uint _S494 = __ldg(&_S491->weft_0);
    uint _S495 = locate_0(_S494, _S487).thread_1 / 2U;
    float _S496 = _S489.x;
    uint _S497;
    if(_S496 > 0.0f)
    {
        _S497 = 1U;
    }
    else
    {
        _S497 = 0U;
    }
    float _S498 = _S489.y;
    uint _S499;
    if(_S498 > 0.0f)
    {
        _S499 = 2U;
    }
    else
    {
        _S499 = 0U;
    }
    uint _S500 = _S497 + _S499;
    uint _S501 = __ldg(&_S491->max_heights_0);
    uint _S502 = __ldg(&_S491->max_height_columns_0);
    uint _S503 = __ldg((&(globalParams_0->words_0)[_S501 + 4U * (_S495 * _S502 + _S493) + _S500]));
    int number_0;
    if(_S490)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S504 = _S503 >> number_0;
    float _S505 = (F32_abs((_S496)));
    float _S506 = __ldg(&_S491->threads_per_x_0);
    float _S507 = _S505 * _S506;
    float _S508 = (F32_abs((_S498)));
    float _S509 = __ldg(&_S491->threads_per_y_0);
    float _S510 = (F32_max((_S507), (_S508 * _S509))) / _S489.z;
    float _S511 = __ldg(&_S491->height_high_0);
    float max_height_0 = _S511;
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
        if(((max_height_0 - _S488) * _S510) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S504 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S511)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S512, float _S513, float _S514, bool _S515, bool _S516, bool _S517)
{
    Crossing_0 _S518 = crossing_at_0(_S512, _S513, _S514, _S515);
    Crossing_0 _S519 = _S518;
    float _S520 = cell_maximum_0(_S512, &_S519);
    float _S521;
    if(_S516)
    {
        _S521 = _S518.warp_1.above_0;
    }
    else
    {
        _S521 = _S518.warp_1.below_0;
    }
    float _S522;
    if(_S517)
    {
        _S522 = _S518.weft_1.above_0;
    }
    else
    {
        _S522 = _S518.weft_1.below_0;
    }
    return make_float3 (_S520, _S521, _S522);
}

__device__ float first_sample_height_0(uint _S523, ViewRay_0 * _S524, StepControl_0 * _S525, bool _S526)
{
    float _S527 = max_height_along_0(_S523, _S524->origin_0.x, _S524->origin_0.y, 0.0f, make_float3 (_S524->slope_1.x, _S524->slope_1.y, 1.0f), _S526);
    uint count_2 = 0U;
    float height_7 = _S527;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S528 = ViewRay_at_0(_S524, height_7);
        float3  _S529 = cell_bounds_0(_S523, _S528.x, _S528.y, _S526, _S525->right_1, _S525->up_0);
        float _S530 = height_7 - _S529.x;
        float _S531 = StepControl_to_cell_exit_0(_S525, _S529.y, _S529.z);
        float height_8 = height_7 - clamp_0(_S530, 0.0f, _S531);
        if(_S530 <= _S531)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

__device__ ViewRayEnd_0 search_down_0(uint _S532, ViewRay_0 * _S533, StepControl_0 * _S534, bool _S535)
{
    Fabric_0 * _S536 = (&(globalParams_0->fabrics_0)[_S532]);
    float _S537 = __ldg(&_S536->height_low_0);
    float _S538 = __ldg(&_S536->height_high_0);
    float _S539 = _S537 - (_S538 - _S537);
    ViewRayEnd_0 end_1;
    float _S540 = first_sample_height_0(_S532, _S533, _S534, _S535);
    (&end_1)->height_6 = _S540;
    (&end_1)->last_step_3 = _S534->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
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
        float2  _S541 = ViewRay_at_0(_S533, (&end_1)->height_6);
        Probe_0 _S542 = probe_0(_S532, _S541.x, _S541.y, _S535, _S534->right_1, _S534->up_0);
        float _S543 = (&end_1)->height_6 - _S542.height_1;
        Probe_0 _S544 = _S542;
        float _S545 = ViewRay_rate_0(_S533, &_S544);
        (&end_1)->depth_1 = - _S543;
        (&end_1)->rate_4 = _S545;
        bool _S546;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S546 = !_S542.hole_1;
        }
        else
        {
            _S546 = false;
        }
        bool _S547;
        if(_S546)
        {
            _S547 = ((&(&end_1)->previous_4)->yarn_0) == (_S542.yarn_1);
        }
        else
        {
            _S547 = false;
        }
        (&end_1)->smooth_0 = _S547;
        bool _S548;
        if(!_S542.hole_1)
        {
            _S548 = _S543 <= 0.0f;
        }
        else
        {
            _S548 = false;
        }
        bool _S549;
        if(_S548)
        {
            _S549 = true;
        }
        else
        {
            _S549 = ((&end_1)->height_6) <= _S539;
        }
        if(_S549)
        {
            break;
        }
        PreviousSample_0 _S550 = (&end_1)->previous_4;
        Probe_0 _S551 = _S542;
        float _S552 = way_back_to_dip_0(&_S550, _S543, _S545, (&end_1)->last_step_3, &_S551);
        if(_S552 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S552;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S552;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S553 = StepControl_to_cell_exit_0(_S534, _S542.side_x_0, _S542.side_y_0);
        float _S554 = (F32_min((_S553), ((&end_1)->height_6 - _S542.cell_max_0)));
        Probe_0 _S555 = _S542;
        float _S556 = StepControl_to_next_sample_0(_S534, &_S555, _S543, _S545);
        bool _S557 = _S554 > _S556;
        Probe_0 _S558 = _S542;
        PreviousSample_0 _S559 = after_sample_0(_S543, _S545, &_S558, _S557);
        (&end_1)->previous_4 = _S559;
        float _S560 = (F32_max((_S554), (_S556)));
        (&end_1)->last_step_3 = _S560;
        (&end_1)->height_6 = (&end_1)->height_6 - _S560;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S561, ViewRay_0 * _S562, StepControl_0 * _S563, bool _S564, ViewRayEnd_0 * _S565, uint _S566)
{
    Fabric_0 * _S567 = (&(globalParams_0->fabrics_0)[_S561]);
    float _S568 = __ldg(&_S567->height_high_0);
    float _S569 = __ldg(&_S567->height_low_0);
    float _S570 = _S568 - _S569;
    float _S571 = _S565->height_6;
    float _S572 = _S565->last_step_3;
    float above_2 = _S565->height_6 + _S565->last_step_3;
    float above_gap_1 = clamp_0((&_S565->previous_4)->clearance_0, 0.0f, _S570);
    float under_gap_1 = clamp_0(_S565->depth_1, 0.0f, _S570);
    float _S573 = cubic_root_0(above_gap_1, - under_gap_1, (&_S565->previous_4)->rate_0 * _S565->last_step_3, _S565->rate_4 * _S565->last_step_3);
    bool _S574 = _S565->smooth_0;
    float middle_0;
    if(_S565->smooth_0)
    {
        middle_0 = above_2 - _S573 * _S572;
    }
    else
    {
        middle_0 = between_0(above_2, _S571, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S571;
    float above_3 = above_2;
    uint i_6 = 0U;
    for(;;)
    {
        if(i_6 < _S566)
        {
        }
        else
        {
            break;
        }
        float2  _S575 = ViewRay_at_0(_S562, middle_0);
        Probe_0 _S576 = probe_0(_S561, _S575.x, _S575.y, _S564, _S563->right_1, _S563->up_0);
        float _S577;
        if(_S576.hole_1)
        {
            _S577 = -1.0e+09f;
        }
        else
        {
            _S577 = _S576.height_1;
        }
        float _S578 = clamp_0(middle_0 - _S577, - _S570, _S570);
        float _S579;
        if(_S578 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S579 = 0.5f * above_gap_2;
            }
            else
            {
                _S579 = above_gap_2;
            }
            float _S580 = - _S578;
            under_1 = middle_0;
            above_gap_2 = _S579;
            under_gap_2 = _S580;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S579 = 0.5f * under_gap_2;
            }
            else
            {
                _S579 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S578;
            under_gap_2 = _S579;
            side_1 = -1.0f;
        }
        if(_S574)
        {
            Probe_0 _S581 = _S576;
            float _S582 = ViewRay_rate_0(_S562, &_S581);
            middle_0 = clamp_0(middle_0 + _S578 / (F32_min((_S582), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_6 = i_6 + 1U;
    }
    if(_S574)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_0(uint _S583, SearchQuality_0 * _S584, float _S585, float _S586, float3  _S587, bool _S588)
{
    Hit_0 hit_0;
    (&hit_0)->x_19 = _S585;
    (&hit_0)->y_11 = _S586;
    (&hit_0)->height_4 = 0.0f;
    bool _S589 = passes_through_0(_S583, _S584, _S585, _S586, _S587, _S588);
    (&hit_0)->hole_3 = _S589;
    if(_S589)
    {
        return hit_0;
    }
    float _S590 = (F32_max((_S587.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S585, _S586);
    float2  _S591 = float2 {_S587.x, _S587.y} / make_float2 (_S590);
    (&ray_0)->slope_1 = _S591;
    float2  _S592 = - _S591;
    float _S593 = steps_per_length_0(_S583, _S584, _S587);
    StepControl_0 _S594 = step_control_0(_S592, 1.0f / (F32_max((_S593 / _S590), (9.99999971718068537e-10f))));
    ViewRay_0 _S595 = ray_0;
    StepControl_0 _S596 = _S594;
    ViewRayEnd_0 _S597 = search_down_0(_S583, &_S595, &_S596, _S588);
    ViewRay_0 _S598 = ray_0;
    StepControl_0 _S599 = _S594;
    ViewRayEnd_0 _S600 = _S597;
    float _S601 = refined_height_0(_S583, &_S598, &_S599, _S588, &_S600, _S584->refinements_0);
    (&hit_0)->height_4 = _S601;
    ViewRay_0 _S602 = ray_0;
    float2  _S603 = ViewRay_at_0(&_S602, _S601);
    (&hit_0)->x_19 = _S603.x;
    (&hit_0)->y_11 = _S603.y;
    return hit_0;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_2;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_9;
    float3  normal_5;
    float3  tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 surface_at_0(uint _S604, float _S605, float _S606, bool _S607)
{
    Fabric_0 * _S608 = (&(globalParams_0->fabrics_0)[_S604]);
    Sample_0 _S609 = sample_at_0(_S604, _S605, _S606, _S607);
    float _S610;
    if(_S609.shown_3.is_warp_0)
    {
        _S610 = _S609.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S610 = _S609.crossing_1.weft_1.half_width_1;
    }
    uint _S611;
    if(_S609.shown_3.is_warp_0)
    {
        uint _S612 = __ldg(&_S608->warp_0);
        _S611 = _S612;
    }
    else
    {
        uint _S613 = __ldg(&_S608->weft_0);
        _S611 = _S613;
    }
    Family_0 _S614 = slang_ldg_2((&(globalParams_0->families_0)[_S611]));
    float _S615;
    if(_S607)
    {
        _S615 = -1.0f;
    }
    else
    {
        _S615 = 1.0f;
    }
    float _S616 = _S614.twist_sine_0 * _S615;
    Family_0 _S617 = slang_ldg_2((&(globalParams_0->families_0)[_S611]));
    if(_S609.shown_3.is_warp_0)
    {
        _S615 = 1.0f;
    }
    else
    {
        _S615 = -1.0f;
    }
    float2  _S618 = fibre_direction_0(_S609.slope_across_0, _S615 * _S609.slope_along_0, _S616, _S617.twist_cosine_0);
    float _S619;
    if(_S609.shown_3.is_warp_0)
    {
        _S619 = _S609.slope_x_1;
    }
    else
    {
        _S619 = _S609.slope_y_1;
    }
    float _S620;
    if(_S609.shown_3.is_warp_0)
    {
        _S620 = _S609.slope_y_1;
    }
    else
    {
        _S620 = _S609.slope_x_1;
    }
    float _S621 = _S618.x;
    float _S622 = _S618.y;
    float _S623 = _S619 * _S621 + _S615 * _S620 * _S622;
    float _S624 = _S610 * 1.0154266357421875f;
    float _S625 = _S624 * arc_sine_0(clamp_0(_S609.section_1.across_1 / _S624, -1.0f, 1.0f));
    if(_S609.shown_3.is_warp_0)
    {
        _S610 = _S606;
    }
    else
    {
        _S610 = - _S605;
    }
    SurfacePoint_0 point_2;
    (&point_2)->hole_4 = _S609.shown_3.hole_0;
    (&point_2)->is_warp_2 = _S609.shown_3.is_warp_0;
    (&point_2)->warp_thread_0 = _S609.crossing_1.warp_1.thread_1;
    (&point_2)->weft_thread_0 = _S609.crossing_1.weft_1.thread_1;
    (&point_2)->height_9 = _S609.height_5;
    (&point_2)->normal_5 = normalize_0(make_float3 (- _S609.slope_x_1, - _S609.slope_y_1, 1.0f));
    float3  _S626;
    if(_S609.shown_3.is_warp_0)
    {
        _S626 = make_float3 (_S621, _S622, _S623);
    }
    else
    {
        _S626 = make_float3 (- _S622, _S621, _S623);
    }
    (&point_2)->tangent_5 = normalize_0(_S626);
    (&point_2)->across_2 = _S609.section_1.across_1;
    (&point_2)->fibre_across_0 = _S625 * _S617.twist_cosine_0 + _S610 * _S616;
    (&point_2)->fibre_along_0 = _S610 * _S617.twist_cosine_0 - _S625 * _S616;
    return point_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S627, Albedos_0 * _S628, uint _S629, uint _S630)
{
    Fabric_0 * _S631 = (&(globalParams_0->fabrics_0)[_S627]);
    float3  _S632 = _S628->specular_reflect_0;
    float3  _S633 = _S628->specular_transmit_0;
    float3  _S634 = max_0(_S628->specular_reflect_0, _S628->specular_transmit_0);
    float3  _S635 = _S628->diffuse_reflect_0;
    float3  _S636 = _S628->diffuse_transmit_0;
    float3  _S637 = _S628->diffuse_reflect_0 + _S628->diffuse_transmit_0;
    float _S638 = __ldg(&_S631->colour_noise_0);
    uint _S639 = __ldg(&_S631->seed_0);
    float _S640 = thread_gain_0(_S629, _S638, _S639);
    float _S641 = __ldg(&_S631->layer_bound_0);
    float _S642 = bounded_gain_0(_S640, _S637, make_float3 (1.0f) - make_float3 (_S641) * _S634);
    float3  _S643 = min_0((make_float3 (1.0f) - make_float3 (_S642) * _S637) / make_float3 (_S641), make_float3 (1.0f));
    float _S644 = __ldg(&_S631->fibre_noise_0);
    float _S645 = bounded_gain_0(fibre_gain_0(_S629, _S630, _S644, _S639), _S634, _S643);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S642) * _S635;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S642) * _S636;
    (&varied_0)->specular_reflect_0 = make_float3 (_S645) * _S632;
    (&varied_0)->specular_transmit_0 = make_float3 (_S645) * _S633;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S646, SurfacePoint_0 * _S647, Albedos_0 * _S648, float _S649, float _S650)
{
    Fabric_0 * _S651 = (&(globalParams_0->fabrics_0)[_S646]);
    bool _S652 = _S647->is_warp_2;
    float _S653;
    if(_S647->is_warp_2)
    {
        _S653 = _S649;
    }
    else
    {
        _S653 = _S650;
    }
    float _S654 = _S653 - _S647->across_2;
    uint _S655;
    if(_S652)
    {
        uint _S656 = __ldg(&_S651->warp_0);
        _S655 = _S656;
    }
    else
    {
        uint _S657 = __ldg(&_S651->weft_0);
        _S655 = _S657;
    }
    Family_0 _S658 = slang_ldg_2((&(globalParams_0->families_0)[_S655]));
    Family_0 _S659 = slang_ldg_2((&(globalParams_0->families_0)[_S655]));
    int _S660 = int(_S659.count_0);
    if(_S652)
    {
        _S655 = _S647->warp_thread_0;
    }
    else
    {
        _S655 = _S647->weft_thread_0;
    }
    uint _S661 = uint(int((F32_floor((_S654 / _S658.period_0)))) * _S660 + int(_S655)) * 2U;
    if(_S652)
    {
        _S655 = 1U;
    }
    else
    {
        _S655 = 0U;
    }
    uint _S662 = _S661 + _S655;
    float _S663 = _S647->fibre_across_0;
    float _S664 = __ldg(&_S651->fibre_size_0);
    float _S665 = (F32_floor((_S663 / _S664)));
    Albedos_0 _S666 = vary_albedos_0(_S646, _S648, _S662, uint(int(_S665)) * 65536U + uint(int((F32_floor((_S647->fibre_along_0 / (_S664 * 40.0f) + 0.61799997091293335f * _S665))))));
    return _S666;
}

__device__ YarnPoint_0 yarn_point_at_0(uint _S667, float _S668, float _S669, bool _S670, bool _S671)
{
    Fabric_0 * _S672 = (&(globalParams_0->fabrics_0)[_S667]);
    SurfacePoint_0 _S673 = surface_at_0(_S667, _S668, _S669, _S670);
    uint _S674;
    if(_S673.is_warp_2)
    {
        uint _S675 = __ldg(&_S672->warp_0);
        _S674 = _S675;
    }
    else
    {
        uint _S676 = __ldg(&_S672->weft_0);
        _S674 = _S676;
    }
    uint _S677;
    if(_S673.is_warp_2)
    {
        _S677 = _S673.warp_thread_0;
    }
    else
    {
        _S677 = _S673.weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S674, _S677);
    float _S678 = __ldg(&_S672->fibre_noise_0);
    bool _S679;
    if(_S678 > 0.0f)
    {
        _S679 = true;
    }
    else
    {
        float _S680 = __ldg(&_S672->colour_noise_0);
        _S679 = _S680 > 0.0f;
    }
    Albedos_0 albedos_3;
    if(_S679)
    {
        SurfacePoint_0 _S681 = _S673;
        Albedos_0 _S682 = albedos_2;
        Albedos_0 _S683 = varied_at_0(_S667, &_S681, &_S682, _S668, _S669);
        albedos_3 = _S683;
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_3;
    (&point_3)->back_2 = _S670;
    (&point_3)->hole_2 = _S671;
    (&point_3)->is_warp_1 = _S673.is_warp_2;
    (&point_3)->x_18 = _S668;
    (&point_3)->y_10 = _S669;
    (&point_3)->height_3 = _S673.height_9;
    (&point_3)->normal_4 = _S673.normal_5;
    (&point_3)->tangent_4 = _S673.tangent_5;
    Family_0 _S684 = slang_ldg_2((&(globalParams_0->families_0)[_S674]));
    (&point_3)->roughness_8 = _S684.roughness_0;
    (&point_3)->albedos_1 = albedos_3;
    return point_3;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S685, SearchQuality_0 * _S686, float _S687, float _S688, float3  _S689)
{
    bool _S690 = (_S689.z) < 0.0f;
    Hit_0 _S691 = first_hit_0(_S685, _S686, _S687, _S688, to_face_frame_0(_S689, _S690), _S690);
    YarnPoint_0 _S692 = yarn_point_at_0(_S685, _S691.x_19, _S691.y_11, _S690, _S691.hole_3);
    return _S692;
}

__device__ float3  scattered_0(uint _S693, YarnPoint_0 * _S694, float3  _S695, float3  _S696)
{
    Fabric_0 * _S697 = (&(globalParams_0->fabrics_0)[_S693]);
    float3  _S698 = make_float3 (0.0f);
    bool _S699 = !_S694->hole_2;
    bool _S700;
    if(_S699)
    {
        _S700 = (_S695.z) > 0.0f;
    }
    else
    {
        _S700 = false;
    }
    float3  value_1;
    if(_S700)
    {
        float3  _S701 = (&_S694->albedos_1)->diffuse_reflect_0;
        float3  _S702 = _S694->normal_4;
        float _S703 = __ldg(&_S697->diffuse_blend_0);
        float3  _S704 = _S701 * make_float3 (diffuse_reflection_0(_S695, _S702, _S703));
        float3  _S705 = (&_S694->albedos_1)->specular_reflect_0;
        float3  _S706 = _S694->tangent_4;
        float _S707 = _S694->roughness_8;
        float _S708 = __ldg(&_S697->optical_depth_0);
        value_1 = _S704 + _S705 * make_float3 (reflection_0(_S695, _S696, _S702, _S706, _S707, _S708));
    }
    else
    {
        if(_S699)
        {
            _S700 = (_S695.z) < 0.0f;
        }
        else
        {
            _S700 = false;
        }
        if(_S700)
        {
            float3  _S709 = (&_S694->albedos_1)->diffuse_transmit_0;
            float3  _S710 = - _S695;
            float3  _S711 = _S694->normal_4;
            float _S712 = __ldg(&_S697->diffuse_blend_0);
            float3  _S713 = _S709 * make_float3 (diffuse_reflection_0(_S710, _S711, _S712));
            float3  _S714 = (&_S694->albedos_1)->specular_transmit_0;
            float3  _S715 = _S694->tangent_4;
            float _S716 = _S694->roughness_8;
            float _S717 = __ldg(&_S697->optical_depth_0);
            value_1 = _S713 + _S714 * make_float3 (transmission_0(_S695, _S696, _S711, _S715, _S716, _S717));
        }
        else
        {
            value_1 = _S698;
        }
    }
    float _S718 = __ldg(&_S697->sheen_strength_0);
    if(_S718 <= 0.0f)
    {
        return value_1;
    }
    float _S719 = __ldg(&_S697->sheen_roughness_0);
    float2  _S720 = sheen_with_transmittance_0(_S695, _S696, _S718, _S719);
    return make_float3 (_S720.y) * value_1 + make_float3 (_S720.x);
}

__device__ bool unoccluded_0(uint _S721, SearchQuality_0 * _S722, float _S723, float _S724, float _S725, float3  _S726, bool _S727)
{
    Fabric_0 * _S728 = (&(globalParams_0->fabrics_0)[_S721]);
    if((_S726.z) <= 0.0f)
    {
        return false;
    }
    float _S729 = max_height_along_0(_S721, _S723, _S724, _S725, _S726, _S727);
    float _S730 = __ldg(&_S728->lift_0);
    bool _S731 = is_free_0(_S721, _S722, make_float3 (_S723, _S724, _S725 + _S730), _S726, _S727, _S729);
    return _S731;
}

__device__ bool is_lit_0(uint _S732, SearchQuality_0 * _S733, YarnPoint_0 * _S734, float3  _S735)
{
    if(_S734->hole_2)
    {
        return true;
    }
    bool _S736 = _S734->back_2;
    float3  _S737 = to_face_frame_0(_S735, _S734->back_2);
    float _S738 = _S737.z;
    bool _S739 = _S738 < 0.0f;
    float3  _S740 = _S734->normal_4;
    float _S741 = _S734->height_3;
    float3  normal_6;
    float height_10;
    if(_S739)
    {
        SurfacePoint_0 _S742 = surface_at_0(_S732, _S734->x_18, _S734->y_10, !_S736);
        normal_6 = _S742.normal_5;
        height_10 = _S742.height_9;
    }
    else
    {
        normal_6 = _S740;
        height_10 = _S741;
    }
    float3  _S743 = make_float3 (float2 {_S737.x, _S737.y}.x, float2 {_S737.x, _S737.y}.y, (F32_abs((_S738))));
    if((dot_0(normal_6, _S743)) <= 0.0f)
    {
        return false;
    }
    bool _S744 = unoccluded_0(_S732, _S733, _S734->x_18, _S734->y_10, height_10, _S743, _S736 != _S739);
    return _S744;
}

__device__ float3  evaluate_0(uint _S745, SearchQuality_0 * _S746, YarnPoint_0 * _S747, float3  _S748, float3  _S749)
{
    float3  _S750 = scattered_0(_S745, _S747, to_face_frame_0(_S748, _S747->back_2), to_face_frame_0(_S749, _S747->back_2));
    bool _S751;
    if((F32_max((_S750.x), ((F32_max((_S750.y), (_S750.z)))))) <= 0.0f)
    {
        _S751 = true;
    }
    else
    {
        bool _S752 = is_lit_0(_S745, _S746, _S747, _S748);
        _S751 = !_S752;
    }
    if(_S751)
    {
        return make_float3 (0.0f);
    }
    return _S750;
}

__device__ float straight_through_0(uint _S753, YarnPoint_0 * _S754, float3  _S755)
{
    Fabric_0 * _S756 = (&(globalParams_0->fabrics_0)[_S753]);
    if(!_S754->hole_2)
    {
        return 0.0f;
    }
    float _S757 = __ldg(&_S756->sheen_strength_0);
    if(_S757 <= 0.0f)
    {
        return 1.0f;
    }
    float _S758 = (F32_abs((_S755.z)));
    float _S759 = __ldg(&_S756->sheen_roughness_0);
    return 1.0f - _S757 * sheen_lobe_0(_S758, _S759).z;
}

__device__ float4  direct_light_0(Frame_0 * _S760, uint _S761, VisiblePoint_0 * _S762, float2  _S763)
{
    SearchQuality_0 _S764 = default_quality_0();
    float3  _S765 = to_local_0(_S762, _S762->view_0);
    float _S766 = _S763.x;
    float _S767 = _S763.y;
    SearchQuality_0 _S768 = _S764;
    YarnPoint_0 _S769 = locate_yarn_0(_S761, &_S768, _S766, _S767, _S765);
    float3  _S770 = make_float3 (0.0f);
    uint number_1 = 0U;
    float3  radiance_1 = _S770;
    for(;;)
    {
        if(number_1 < (_S760->lights_0))
        {
        }
        else
        {
            break;
        }
        Light_0 _S771 = slang_ldg_3((&(globalParams_0->lights_1)[number_1]));
        Light_0 _S772 = _S771;
        float3  irradiance_2;
        float3  _S773 = towards_light_0(&_S772, _S762->position_0, &irradiance_2);
        float3  _S774 = to_local_0(_S762, _S773);
        SearchQuality_0 _S775 = _S764;
        YarnPoint_0 _S776 = _S769;
        float3  _S777 = evaluate_0(_S761, &_S775, &_S776, _S774, _S765);
        float3  radiance_2 = radiance_1 + irradiance_2 * _S777;
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    YarnPoint_0 _S778 = _S769;
    float _S779 = straight_through_0(_S761, &_S778, _S765);
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - _S779);
}

extern "C" __global__ void shade()
{
    uint _S780;
    uint3  _S781 = blockIdx * blockDim + threadIdx;
    Frame_0 _S782 = slang_ldg_0((&(globalParams_0->frames_0)[int(0)]));
    bool _S783;
    if((_S781.x) >= (_S782.width_0))
    {
        _S783 = true;
    }
    else
    {
        _S783 = (_S781.y) >= (_S782.height_0);
    }
    if(_S783)
    {
        return;
    }
    uint2  _S784 = uint2 {_S781.x, _S781.y};
    uint _S785 = _S784.y * _S782.width_0 + _S784.x;
    int2  _S786 = make_int2 ((int)_S784.x, (int)_S784.y);
    int3  _S787 = make_int3 (_S786.x, _S786.y, int(0));
    uint _S788 = (tex2Dfetch_int<uint>((globalParams_0->visible_faces_0), ((_S787)).x, ((_S787)).y, ((_S787)).z));
    float4  sum_0 = make_float4 (0.0f);
    if(_S788 > 0U)
    {
        uint _S789 = _S788 - 1U;
        uint _S790 = __ldg((&(globalParams_0->face_fabrics_0)[_S789]));
        Frame_0 _S791 = _S782;
        VisiblePoint_0 _S792 = visible_point_0(&_S791, _S790, _S789, _S784);
        uint k_0 = 0U;
        for(;;)
        {
            _S780 = _S782.samples_0;
            if(k_0 < (_S782.samples_0))
            {
            }
            else
            {
                break;
            }
            float2  _S793 = footprint_sample_0(_S784, _S782.pass_number_0 * _S782.samples_0 + k_0);
            float2  _S794 = _S792.draft_0 + make_float2 (_S793.x) * _S792.draft_dx_0 + make_float2 (_S793.y) * _S792.draft_dy_0;
            Frame_0 _S795 = _S782;
            VisiblePoint_0 _S796 = _S792;
            float4  _S797 = direct_light_0(&_S795, _S790, &_S796, _S794);
            sum_0 = sum_0 + _S797;
            k_0 = k_0 + 1U;
        }
        sum_0 = sum_0 / make_float4 (float(_S780));
    }
    float4  _S798 = sum_0;
    float3  _S799 = float3 {_S798.x, _S798.y, _S798.z} + make_float3 (1.0f - sum_0.w) * make_float3 (_S782.background_red_0, _S782.background_green_0, _S782.background_blue_0);
    sum_0.x = _S799.x;
    sum_0.y = _S799.y;
    sum_0.z = _S799.z;
    float4  * _S800 = (&(globalParams_0->radiance_0)[_S785]);
    float4  _S801;
    if((_S782.pass_number_0) == 0U)
    {
        _S801 = sum_0;
    }
    else
    {
        _S801 = *(&(globalParams_0->radiance_0)[_S785]) + sum_0;
    }
    *_S800 = _S801;
    return;
}

