#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
constant array<float, int(4)> PYRAMID_RADII_0 = { 1.0f, 2.0f, 4.0f, 8.0f };
struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

Footprint_0 footprint_of_0(float2 centre_1, float2 dx_1, float2 dy_1)
{
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_1;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    return footprint_0;
}

uint mixed_0(uint number_0)
{
    uint bits_0 = (number_0 ^ (number_0 >> 16U)) * 2246822507U;
    uint bits_1 = (bits_0 ^ (bits_0 >> 13U)) * 3266489909U;
    return bits_1 ^ (bits_1 >> 16U);
}

uint with_number_0(uint hash_0, float number_1)
{
    uint _S1;
    if(number_1 == 0.0f)
    {
        _S1 = 0U;
    }
    else
    {
        _S1 = (as_type<uint>((number_1)));
    }
    return mixed_0(hash_0 ^ _S1);
}

uint hashed_0(const Footprint_0 thread* footprint_1, float3 view_0, float2 size_0)
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
        float _S2 = footprint_1->centre_0[axis_0] / size_0[axis_0];
        uint _S3 = mixed_0(hash_1 ^ uint((_S2 - floor(_S2)) * 4096.0f));
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
        uint _S5 = with_number_0(hash_1, view_0[axis_0]);
        uint _S6 = axis_0 + 1U;
        hash_1 = _S5;
        axis_0 = _S6;
    }
    return with_number_0(with_number_0(with_number_0(with_number_0(hash_1, footprint_1->dx_0.x), footprint_1->dx_0.y), footprint_1->dy_0.x), footprint_1->dy_0.y);
}

float uniform_of_0(uint seed_0, uint dimension_0)
{
    return float((mixed_0(seed_0 + (dimension_0 + 1U) * 2654435769U)) >> 8U) * 5.9604644775390625e-08f;
}

float3 to_face_frame_0(float3 direction_0, bool back_0)
{
    float2 _S7 = direction_0.xy;
    float _S8;
    if(back_0)
    {
        _S8 = - direction_0.z;
    }
    else
    {
        _S8 = direction_0.z;
    }
    return float3(_S7, _S8);
}

float arc_tangent_quotient_0(float x_0, float y_0)
{
    return ((((((0.0f * x_0 + 0.00809729471802711f) * x_0 + -0.0377517081797123f) * x_0 + 0.08475969731807709f) * x_0 + -0.13537675142288208f) * x_0 + 0.19895026087760925f) * x_0 + -0.33327975869178772f) * x_0 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

struct BinTaps_0
{
    uint corner_0;
    uint bins_0;
    float4 weights_0;
};

BinTaps_0 bin_taps_0(float3 direction_1, uint bins_1)
{
    float _S9 = sqrt(max(1.0f - direction_1.z, 0.0f));
    float _S10 = direction_1.x;
    float _S11 = abs(_S10);
    float _S12 = direction_1.y;
    float _S13 = abs(_S12);
    float _S14 = arc_tangent_of_ratio_0(min(_S11, _S13) / max(max(_S11, _S13), 9.999999960041972e-13f)) * 1.27323949337005615f;
    bool _S15 = _S11 >= _S13;
    float _S16;
    if(_S10 < 0.0f)
    {
        _S16 = -1.0f;
    }
    else
    {
        _S16 = 1.0f;
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
    if(_S12 < 0.0f)
    {
        _S16 = -1.0f;
    }
    else
    {
        _S16 = 1.0f;
    }
    if(_S15)
    {
        _S17 = _S9 * _S14;
    }
    else
    {
        _S17 = _S9;
    }
    float _S19 = float(bins_1);
    float2 _S20 = clamp((float2(_S18, _S16 * _S17) + float2(1.0f) ) * float2((0.5f * _S19))  - float2(0.5f) , float2(0.0f) , float2((_S19 - 1.0f)) );
    float _S21 = _S20.x;
    uint _S22 = bins_1 - 2U;
    uint _S23 = min(uint(_S21), _S22);
    float _S24 = _S20.y;
    uint _S25 = min(uint(_S24), _S22);
    float _S26 = _S21 - float(_S23);
    float _S27 = _S24 - float(_S25);
    thread BinTaps_0 taps_0;
    (&taps_0)->corner_0 = _S25 * bins_1 + _S23;
    (&taps_0)->bins_0 = bins_1;
    float _S28 = 1.0f - _S26;
    float _S29 = 1.0f - _S27;
    (&taps_0)->weights_0 = float4(_S28 * _S29, _S26 * _S29, _S28 * _S27, _S26 * _S27);
    return taps_0;
}

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
    uint seed_1;
};

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
    uint back_1;
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
    uint back_2;
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
    uint view_1;
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
    uint seed_2;
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

struct Family_0
{
    uint is_alike_0;
    float count_0;
    float inverse_count_0;
    float half_inverse_count_0;
    float size_1;
    float inverse_size_0;
    float half_width_0;
    float start_0;
    float period_0;
    float inverse_period_0;
    float bins_2;
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

struct KernelContext_0
{
    uint device* query_count_0;
    Query_0 device* queries_0;
    packed_float4 device* answers_0;
    Fabric_0 device* fabrics_0;
    uint device* words_0;
    Family_0 device* families_0;
};

float table_number_0(uint index_0, KernelContext_0 thread* kernelContext_0)
{
    return (as_type<float>((kernelContext_0->words_0[index_0])));
}

float table_number_1(uint index_1, KernelContext_0 thread* kernelContext_1)
{
    return (as_type<float>((kernelContext_1->words_0[index_1])));
}

float BinTaps_read_0(const BinTaps_0 thread* this_0, uint table_0, uint first_0, uint stride_0, uint offset_2, KernelContext_0 thread* kernelContext_2)
{
    uint _S30 = table_0 + (first_0 + this_0->corner_0) * stride_0 + offset_2;
    float _S31 = table_number_0(_S30, kernelContext_2);
    float4 _S32 = this_0->weights_0;
    float _S33 = _S31 * this_0->weights_0.x;
    float _S34 = table_number_0(_S30 + stride_0, kernelContext_2);
    float _S35 = _S33 + _S34 * _S32.y;
    uint _S36 = this_0->bins_0;
    float _S37 = table_number_0(_S30 + this_0->bins_0 * stride_0, kernelContext_2);
    float _S38 = _S35 + _S37 * _S32.z;
    float _S39 = table_number_0(_S30 + (_S36 + 1U) * stride_0, kernelContext_2);
    return _S38 + _S39 * _S32.w;
}

struct TexelBox_0
{
    float2 corner_1;
    float2 size_2;
    uint2 first_1;
    float2 extent_0;
    uint2 last_0;
    float2 turns_0;
};

TexelBox_0 texel_box_0(const Clustered_0 thread* tables_0, const Footprint_0 thread* footprint_2, float2 offset_3, float place_0)
{
    float _S40 = footprint_2->dx_0.x;
    float _S41 = footprint_2->dy_0.x;
    float _S42 = sqrt(_S40 * _S40 + _S41 * _S41);
    float _S43 = footprint_2->dx_0.y;
    float _S44 = footprint_2->dy_0.y;
    float _S45 = sqrt(_S43 * _S43 + _S44 * _S44);
    float2 _S46 = float2(_S42, _S45);
    float _S47 = (_S40 * _S43 + _S41 * _S44) / max(_S42 * _S45, 1.00000000317107685e-30f);
    float _S48 = abs(_S47);
    float _S49 = place_0 * sqrt(min(_S48, 1.0f));
    float _S50;
    if(_S47 < 0.0f)
    {
        _S50 = - _S49;
    }
    else
    {
        _S50 = _S49;
    }
    float2 _S51 = _S46 * float2(_S49, _S50);
    float2 _S52 = float2(tables_0->texel_width_0, tables_0->texel_height_0);
    uint _S53 = tables_0->columns_0;
    uint _S54 = tables_0->rows_0;
    float2 _S55 = float2(float(tables_0->columns_0), float(tables_0->rows_0));
    thread TexelBox_0 box_0;
    float2 _S56 = _S46 * float2(sqrt(max(1.0f - _S48, 0.0f))) ;
    (&box_0)->size_2 = _S56;
    float2 _S57 = float2(0.5f) ;
    float2 _S58 = _S57 * _S56;
    float2 _S59 = footprint_2->centre_0 + _S51 - _S58;
    (&box_0)->corner_1 = _S59;
    float2 _S60 = max(round(_S56 / _S52), float2(1.0f) );
    (&box_0)->extent_0 = _S60;
    float2 _S61 = round((_S59 + _S58 + offset_3) / _S52 - _S57 * _S60);
    float2 _S62 = float2(0.0f) ;
    float2 _S63 = max(_S61 - floor(_S61 / _S55) * _S55, _S62);
    uint2 _S64 = uint2(min(uint(_S63.x), tables_0->columns_0 - 1U), min(uint(_S63.y), tables_0->rows_0 - 1U));
    (&box_0)->first_1 = _S64;
    float2 _S65 = floor(_S60 / _S55);
    (&box_0)->turns_0 = _S65;
    float2 _S66 = max(_S60 - _S65 * _S55, _S62);
    uint2 _S67 = _S64 + uint2(uint(_S66.x), uint(_S66.y));
    (&box_0)->last_0 = _S67;
    if((_S67.x) >= (tables_0->columns_0))
    {
        (&box_0)->last_0.x = (&box_0)->last_0.x - _S53;
        (&box_0)->turns_0.x = (&box_0)->turns_0.x + 1.0f;
    }
    if(((&box_0)->last_0.y) >= _S54)
    {
        (&box_0)->last_0.y = (&box_0)->last_0.y - _S54;
        (&box_0)->turns_0.y = (&box_0)->turns_0.y + 1.0f;
    }
    return box_0;
}

float2 turns_and_remainder_0(uint family_0, float index_2, KernelContext_0 thread* kernelContext_3)
{
    float _S68 = floor(fma(index_2, (kernelContext_3->families_0+family_0)->inverse_count_0, (kernelContext_3->families_0+family_0)->half_inverse_count_0));
    return float2(_S68, fma(- _S68, (kernelContext_3->families_0+family_0)->count_0, index_2));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0, KernelContext_0 thread* kernelContext_4)
{
    float _S69 = floor(position_0 * (kernelContext_4->families_0+family_1)->inverse_size_0);
    thread Cell_0 cell_0;
    float _S70 = fma(- _S69, (kernelContext_4->families_0+family_1)->size_1, position_0);
    (&cell_0)->below_0 = _S70;
    (&cell_0)->above_0 = (kernelContext_4->families_0+family_1)->size_1 - _S70;
    (&cell_0)->across_0 = _S70 - 0.5f * (kernelContext_4->families_0+family_1)->size_1;
    (&cell_0)->half_width_1 = (kernelContext_4->families_0+family_1)->half_width_0;
    float2 _S71 = turns_and_remainder_0(family_1, _S69, kernelContext_4);
    (&cell_0)->thread_0 = uint(clamp(_S71.y, 0.0f, (kernelContext_4->families_0+family_1)->count_0 - 1.0f));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_1, KernelContext_0 thread* kernelContext_5)
{
    float turns_1 = (position_1 - (kernelContext_5->families_0+family_2)->start_0) * (kernelContext_5->families_0+family_2)->inverse_period_0;
    float turns_2 = turns_1 - floor(turns_1);
    float _S72 = turns_2 * (kernelContext_5->families_0+family_2)->period_0;
    uint thread_1 = kernelContext_5->words_0[(kernelContext_5->families_0+family_2)->first_thread_table_0 + uint(clamp(turns_2 * (kernelContext_5->families_0+family_2)->bins_2, 0.0f, (kernelContext_5->families_0+family_2)->bins_2 - 1.0f))];
    float _S73 = table_number_0((kernelContext_5->families_0+family_2)->place_table_0 + thread_1 * 4U + 1U, kernelContext_5);
    uint _S74;
    if(_S72 >= _S73)
    {
        _S74 = 1U;
    }
    else
    {
        _S74 = 0U;
    }
    uint _S75 = min(thread_1 + _S74, uint((kernelContext_5->families_0+family_2)->count_0) - 1U);
    uint _S76 = (kernelContext_5->families_0+family_2)->place_table_0 + _S75 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S75;
    float _S77 = table_number_0(_S76, kernelContext_5);
    (&cell_1)->below_0 = _S72 - _S77;
    float _S78 = table_number_0(_S76 + 1U, kernelContext_5);
    (&cell_1)->above_0 = _S78 - _S72;
    float _S79 = table_number_0(_S76 + 2U, kernelContext_5);
    (&cell_1)->across_0 = _S72 - _S79;
    float _S80 = table_number_0(_S76 + 3U, kernelContext_5);
    (&cell_1)->half_width_1 = _S80;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2, KernelContext_0 thread* kernelContext_6)
{
    if(((kernelContext_6->families_0+family_3)->is_alike_0) != 0U)
    {
        Cell_0 _S81 = locate_alike_0(family_3, position_2, kernelContext_6);
        return _S81;
    }
    Cell_0 _S82 = locate_varied_0(family_3, position_2, kernelContext_6);
    return _S82;
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

Bound_0 bound_at_0(uint family_4, float position_3, KernelContext_0 thread* kernelContext_7)
{
    Cell_0 _S83 = locate_0(family_4, position_3, kernelContext_7);
    float _S84 = table_number_0((kernelContext_7->families_0+family_4)->before_0 + 2U * _S83.thread_0 + 1U, kernelContext_7);
    thread Bound_0 bound_0;
    (&bound_0)->thread_2 = _S83.thread_0;
    (&bound_0)->turns_3 = round((position_3 - (kernelContext_7->families_0+family_4)->start_0 - _S84 - _S83.below_0) * (kernelContext_7->families_0+family_4)->inverse_period_0);
    (&bound_0)->cell_2 = _S83.below_0;
    float _S85 = 2.0f * _S83.half_width_1;
    (&bound_0)->width_1 = _S85;
    (&bound_0)->visible_0 = clamp((_S83.across_0 + _S83.half_width_1) / _S85, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S83.below_0, _S83.below_0 - _S83.across_0 - _S83.half_width_1) + max(_S83.across_0 - _S83.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_3, KernelContext_0 thread* kernelContext_8)
{
    float _S86 = centre_2 - floor((centre_2 - (kernelContext_8->families_0+family_5)->start_0) * (kernelContext_8->families_0+family_5)->inverse_period_0) * (kernelContext_8->families_0+family_5)->period_0;
    float _S87 = 0.5f * max(size_3, (kernelContext_8->families_0+family_5)->smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S88 = bound_at_0(family_5, _S86 - _S87, kernelContext_8);
    (&stretch_0)->low_0 = _S88;
    Bound_0 _S89 = bound_at_0(family_5, _S86 + _S87, kernelContext_8);
    (&stretch_0)->high_0 = _S89;
    return stretch_0;
}

float3 table_colour_0(uint index_3, KernelContext_0 thread* kernelContext_9)
{
    float _S90 = table_number_1(index_3, kernelContext_9);
    float _S91 = table_number_1(index_3 + 1U, kernelContext_9);
    float _S92 = table_number_1(index_3 + 2U, kernelContext_9);
    return float3(_S90, _S91, _S92);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0, KernelContext_0 thread* kernelContext_10)
{
    thread Albedos_0 albedos_0;
    float3 _S93 = table_colour_0(row_0, kernelContext_10);
    (&albedos_0)->diffuse_reflect_0 = _S93;
    float3 _S94 = table_colour_0(row_0 + 3U, kernelContext_10);
    (&albedos_0)->diffuse_transmit_0 = _S94;
    float3 _S95 = table_colour_0(row_0 + 6U, kernelContext_10);
    (&albedos_0)->specular_reflect_0 = _S95;
    float3 _S96 = table_colour_0(row_0 + 9U, kernelContext_10);
    (&albedos_0)->specular_transmit_0 = _S96;
    return albedos_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_1)
{
    return (&this_1->high_0)->turns_3 - (&this_1->low_0)->turns_3;
}

float3 lengths_0(uint family_6, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_11)
{
    float _S97 = Stretch_turns_0(stretch_1);
    uint _S98 = (kernelContext_11->families_0+family_6)->before_0 + 2U * (&stretch_1->low_0)->thread_2;
    uint _S99 = (kernelContext_11->families_0+family_6)->before_0 + 2U * (&stretch_1->high_0)->thread_2;
    float _S100 = table_number_0(_S99, kernelContext_11);
    float _S101 = table_number_0(_S98, kernelContext_11);
    float _S102 = _S100 - _S101;
    float _S103 = table_number_0(_S99 + 1U, kernelContext_11);
    float _S104 = table_number_0(_S98 + 1U, kernelContext_11);
    float _S105 = _S103 - _S104;
    return float3(_S102 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_1 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_1 + _S97 * (kernelContext_11->families_0+family_6)->visible_total_0, _S105 - _S102 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0 + _S97 * ((kernelContext_11->families_0+family_6)->period_0 - (kernelContext_11->families_0+family_6)->visible_total_0), _S105 + (&stretch_1->high_0)->cell_2 - (&stretch_1->low_0)->cell_2 + _S97 * (kernelContext_11->families_0+family_6)->period_0);
}

float2 integrals_along_0(uint family_7, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_12)
{
    uint _S106 = (kernelContext_12->families_0+family_7)->quantities_0;
    uint _S107 = 3U * (kernelContext_12->families_0+family_7)->quantities_0;
    uint _S108 = (kernelContext_12->families_0+family_7)->colour_threads_0 + _S107 * (&stretch_2->low_0)->thread_2 + quantity_0;
    uint _S109 = (kernelContext_12->families_0+family_7)->colour_threads_0 + _S107 * (&stretch_2->high_0)->thread_2 + quantity_0;
    uint _S110 = (kernelContext_12->families_0+family_7)->colour_threads_0 + _S107 * uint((kernelContext_12->families_0+family_7)->count_0) + quantity_0;
    float _S111 = table_number_0(_S108, kernelContext_12);
    float _S112 = table_number_0(_S109, kernelContext_12);
    float _S113 = Stretch_turns_0(stretch_2);
    float _S114 = table_number_0(_S109 + _S106, kernelContext_12);
    float _S115 = table_number_0(_S108 + _S106, kernelContext_12);
    float _S116 = _S114 - _S115 + _S112 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_1 - _S111 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_1;
    float _S117 = table_number_0(_S110 + _S106, kernelContext_12);
    float _S118 = _S116 + _S113 * _S117;
    uint _S119 = 2U * _S106;
    float _S120 = table_number_0(_S109 + _S119, kernelContext_12);
    float _S121 = table_number_0(_S108 + _S119, kernelContext_12);
    float _S122 = _S120 - _S121 + _S112 * (&stretch_2->high_0)->cell_2 - _S111 * (&stretch_2->low_0)->cell_2;
    float _S123 = table_number_0(_S110 + _S119, kernelContext_12);
    return float2(_S118, _S122 + _S113 * _S123);
}

bool Stretch_wraps_0(const Stretch_0 thread* this_2)
{
    return ((&this_2->high_0)->thread_2) < ((&this_2->low_0)->thread_2);
}

bool Stretch_wraps_1(const Stretch_0 thread* this_3)
{
    return ((&this_3->high_0)->thread_2) < ((&this_3->low_0)->thread_2);
}

uint4 Stretch_differences_0(const Stretch_0 thread* this_4, uint4 entries_0, uint whole_0)
{
    uint _S124 = entries_0.z;
    uint _S125 = entries_0.x;
    uint _S126 = _S124 - _S125;
    bool _S127 = Stretch_wraps_1(this_4);
    uint _S128;
    if(_S127)
    {
        _S128 = whole_0;
    }
    else
    {
        _S128 = 0U;
    }
    return uint4(_S126 + _S128, entries_0.w - _S124, entries_0.y - _S125, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_1, uint row_1, uint count_1, uint quantities_1, KernelContext_0 thread* kernelContext_13)
{
    uint _S129 = row_1 + (&across_1->low_0)->thread_2 * quantities_1;
    uint _S130 = row_1 + (&across_1->high_0)->thread_2 * quantities_1;
    uint4 _S131 = Stretch_differences_0(across_1, uint4(kernelContext_13->words_0[_S129], kernelContext_13->words_0[_S129 + quantities_1], kernelContext_13->words_0[_S130], kernelContext_13->words_0[_S130 + quantities_1]), kernelContext_13->words_0[row_1 + count_1 * quantities_1]);
    return _S131;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_5)
{
    float _S132 = (&this_5->high_0)->visible_0;
    float _S133 = - (&this_5->low_0)->visible_0;
    float _S134 = Stretch_turns_0(this_5);
    bool _S135 = Stretch_wraps_0(this_5);
    float _S136;
    if(_S135)
    {
        _S136 = 1.0f;
    }
    else
    {
        _S136 = 0.0f;
    }
    return float4(1.0f, _S132, _S133, _S134 - _S136);
}

float integral_on_top_0(uint family_8, const Stretch_0 thread* across_2, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_14)
{
    uint _S137 = uint((kernelContext_14->families_0+family_8)->count_0);
    uint _S138 = (_S137 + 1U) * (kernelContext_14->families_0+family_8)->quantities_0;
    uint _S139 = (kernelContext_14->families_0+family_8)->colour_areas_0 + quantity_1;
    uint _S140 = (&along_0->low_0)->thread_2;
    uint4 _S141 = row_differences_0(across_2, _S139 + (&along_0->low_0)->thread_2 * _S138, _S137, (kernelContext_14->families_0+family_8)->quantities_0, kernelContext_14);
    uint4 _S142 = row_differences_0(across_2, _S139 + (_S140 + 1U) * _S138, _S137, (kernelContext_14->families_0+family_8)->quantities_0, kernelContext_14);
    uint _S143 = (&along_0->high_0)->thread_2;
    uint4 _S144 = row_differences_0(across_2, _S139 + (&along_0->high_0)->thread_2 * _S138, _S137, (kernelContext_14->families_0+family_8)->quantities_0, kernelContext_14);
    uint4 _S145 = row_differences_0(across_2, _S139 + (_S143 + 1U) * _S138, _S137, (kernelContext_14->families_0+family_8)->quantities_0, kernelContext_14);
    uint4 _S146 = row_differences_0(across_2, _S139 + crossing_count_0 * _S138, _S137, (kernelContext_14->families_0+family_8)->quantities_0, kernelContext_14);
    uint4 _S147 = _S144 - _S141;
    bool _S148 = Stretch_wraps_0(along_0);
    uint4 _S149;
    if(_S148)
    {
        _S149 = _S146;
    }
    else
    {
        _S149 = uint4(int4(int(0)) );
    }
    uint4 _S150 = _S147 + _S149;
    float4 _S151 = Stretch_weights_0(across_2);
    float4 _S152 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S150)), _S151), dot(float4(int4(_S145 - _S144)), _S151), dot(float4(int4(_S142 - _S141)), _S151), dot(float4(int4(_S146)), _S151)), _S152) * (kernelContext_14->families_0+family_8)->area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_0, uint row_2, KernelContext_0 thread* kernelContext_15)
{
    Albedos_0 _S153 = table_albedos_0(row_2, kernelContext_15);
    thread Albedos_0 sum_0;
    float3 _S154 = float3(weight_0) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S154 * _S153.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S154 * _S153.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S154 * _S153.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S154 * _S153.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, const Stretch_0 thread* own_0, const Stretch_0 thread* other_0, bool back_3, KernelContext_0 thread* kernelContext_16)
{
    Albedos_0 _S155 = table_albedos_0((kernelContext_16->families_0+family_9)->colour_mean_0, kernelContext_16);
    thread Albedos_0 albedos_2 = _S155;
    if(((kernelContext_16->families_0+family_9)->quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S156 = lengths_0(crossing_0, other_0, kernelContext_16);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < ((kernelContext_16->families_0+family_9)->quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S157 = integrals_along_0(family_9, own_0, quantity_2, kernelContext_16);
        float _S158 = integral_on_top_0(family_9, own_0, other_0, uint((kernelContext_16->families_0+crossing_0)->count_0), quantity_2, kernelContext_16);
        float _S159 = _S157.x;
        float _S160 = _S159 * _S156.x;
        float _S161;
        if(back_3)
        {
            _S161 = _S160 - _S158;
        }
        else
        {
            _S161 = _S158;
        }
        bool _S162 = quantity_2 == 0U;
        if(_S162)
        {
            is_exposed_0 = _S161 > (16.0f * (kernelContext_16->families_0+family_9)->area_unit_0 * min(_S160 / (kernelContext_16->families_0+family_9)->crossing_area_0, 1.0f) + 0.00000999999974738f * _S160);
        }
        float _S163 = _S159 * _S156.y;
        float _S164;
        if(is_exposed_0)
        {
            _S164 = _S161;
        }
        else
        {
            _S164 = 0.0f;
        }
        float _S165 = _S163 + _S164 + 0.000244140625f * _S156.z * _S157.y;
        if(_S162)
        {
            weight_1 = 1.0f / max(_S165, 9.99999968265522539e-21f);
        }
        else
        {
            float _S166 = _S165 * weight_1;
            uint _S167 = (kernelContext_16->families_0+family_9)->colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S168 = albedos_2;
            Albedos_0 _S169 = with_added_albedos_0(&_S168, _S166, _S167, kernelContext_16);
            albedos_2 = _S169;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

Albedos_0 tinted_0(const Albedos_0 thread* albedos_3, float3 tint_0)
{
    thread Albedos_0 result_0 = *albedos_3;
    (&result_0)->diffuse_reflect_0 = (&result_0)->diffuse_reflect_0 * tint_0;
    (&result_0)->diffuse_transmit_0 = (&result_0)->diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
    float3 warp_1;
    float3 weft_1;
    float3 mean_0;
    float3 leaked_0;
};

struct FaceSends_0
{
    float3 sky_warp_0;
    float3 sky_weft_0;
    float3 crossing_warp_0;
    float3 crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

FaceRadiance_0 face_radiance_0(const FaceSends_0 thread* sends_0, float open_of_other_0, float3 passed_0, float3 from_other_0)
{
    float3 _S170 = float3((1.0f - open_of_other_0))  * passed_0;
    thread FaceRadiance_0 found_0;
    float3 _S171 = sends_0->sky_warp_0 + _S170 * sends_0->crossing_warp_0;
    (&found_0)->warp_1 = _S171;
    float3 _S172 = sends_0->sky_weft_0 + _S170 * sends_0->crossing_weft_0;
    (&found_0)->weft_1 = _S172;
    (&found_0)->mean_0 = float3(sends_0->blocks_warp_0)  * _S171 + float3(sends_0->blocks_weft_0)  * _S172;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(float3 view_2, array<float, int(6)> thread* terms_0)
{
    float _S173 = 1.0f - view_2.z;
    float _S174 = _S173 * _S173;
    (*terms_0)[int(0)] = 1.0f;
    float _S175 = view_2.x;
    float _S176 = _S175 * _S175;
    float _S177 = view_2.y;
    float _S178 = _S177 * _S177;
    (*terms_0)[int(1)] = sqrt(max(_S176 + _S178, 9.999999960041972e-13f));
    (*terms_0)[int(2)] = _S174;
    (*terms_0)[int(3)] = _S174 * _S174;
    (*terms_0)[int(4)] = _S176 - _S178;
    (*terms_0)[int(5)] = 0.0f;
    return;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

Blocked_0 scaled_0(const Blocked_0 thread* blocked_0, float share_0)
{
    thread Blocked_0 result_1;
    (&result_1)->by_warp_0 = share_0 * blocked_0->by_warp_0;
    (&result_1)->by_weft_0 = share_0 * blocked_0->by_weft_0;
    (&result_1)->far_0 = share_0 * blocked_0->far_0;
    return result_1;
}

struct Bounced_0
{
    float3 reflected_0;
    float3 transmitted_0;
};

struct Scattered_0
{
    float3 back_4;
    float3 through_0;
};

struct Interior_0
{
    float3 warp_2;
    float3 weft_2;
    float3 leaked_1;
    float3 far_1;
    float3 far_leaked_0;
};

Bounced_0 bounced_by_0(const Blocked_0 thread* blocked_1, const Scattered_0 thread* yarn_0, const Interior_0 thread* interior_0)
{
    float3 _S179 = float3((blocked_1->by_warp_0 + blocked_1->by_weft_0))  * interior_0->leaked_1;
    float3 _S180 = float3(blocked_1->far_0)  * yarn_0->through_0;
    thread Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_0->back_4 * (float3(blocked_1->by_warp_0)  * interior_0->warp_2 + float3(blocked_1->by_weft_0)  * interior_0->weft_2) + _S180 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S180 * interior_0->far_1 + yarn_0->back_4 * _S179;
    return bounced_0;
}

Bounced_0 sum_of_0(const Bounced_0 thread* first_2, const Bounced_0 thread* second_0)
{
    thread Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_2->reflected_0 + second_0->reflected_0;
    (&sum_1)->transmitted_0 = first_2->transmitted_0 + second_0->transmitted_0;
    return sum_1;
}

int summed_0(const Clustered_0 thread* tables_1, uint first_3, uint column_0, uint row_3, KernelContext_0 thread* kernelContext_17)
{
    return int(kernelContext_17->words_0[first_3 + (row_3 * (tables_1->columns_0 + 1U) + column_0) * tables_1->channels_0]);
}

float box_mean_0(const Clustered_0 thread* tables_2, const TexelBox_0 thread* box_1, uint face_0, uint channel_0, KernelContext_0 thread* kernelContext_18)
{
    uint _S181 = tables_2->columns_0;
    uint _S182 = tables_2->rows_0;
    uint _S183 = tables_2->sums_0 + face_0 * (tables_2->columns_0 + 1U) * (tables_2->rows_0 + 1U) * tables_2->channels_0 + channel_0;
    uint2 _S184 = box_1->last_0;
    uint _S185 = box_1->last_0.x;
    uint2 _S186 = box_1->first_1;
    uint _S187 = box_1->first_1.y;
    int _S188 = summed_0(tables_2, _S183, _S185, _S187, kernelContext_18);
    uint _S189 = _S186.x;
    int _S190 = summed_0(tables_2, _S183, _S189, _S187, kernelContext_18);
    int _S191 = _S188 - _S190;
    uint _S192 = _S184.y;
    int _S193 = summed_0(tables_2, _S183, _S185, _S192, kernelContext_18);
    int _S194 = summed_0(tables_2, _S183, _S189, _S192, kernelContext_18);
    float total_0 = float(_S193 - _S194 - _S191);
    float2 _S195 = box_1->turns_0;
    float _S196 = box_1->turns_0.x;
    bool _S197 = _S196 > 0.0f;
    float total_1;
    if(_S197)
    {
        int _S198 = summed_0(tables_2, _S183, _S181, _S192, kernelContext_18);
        int _S199 = summed_0(tables_2, _S183, _S181, _S187, kernelContext_18);
        total_1 = total_0 + _S196 * float(_S198 - _S199);
    }
    else
    {
        total_1 = total_0;
    }
    float _S200 = _S195.y;
    bool _S201 = _S200 > 0.0f;
    if(_S201)
    {
        int _S202 = summed_0(tables_2, _S183, _S185, _S182, kernelContext_18);
        int _S203 = summed_0(tables_2, _S183, _S189, _S182, kernelContext_18);
        total_1 = total_1 + _S200 * float(_S202 - _S203);
    }
    bool _S204;
    if(_S197)
    {
        _S204 = _S201;
    }
    else
    {
        _S204 = false;
    }
    if(_S204)
    {
        float _S205 = _S196 * _S200;
        int _S206 = summed_0(tables_2, _S183, _S181, _S182, kernelContext_18);
        total_1 = total_1 + _S205 * float(_S206);
    }
    return total_1 / (box_1->extent_0.x * box_1->extent_0.y);
}

float square_0(float3 v_0)
{
    return dot(v_0, v_0);
}

struct BaseTaps_0
{
    float3 facing_0;
    bool transmits_1;
    BinTaps_0 around_0;
    uint first_4;
    BinTaps_0 half_vector_0;
};

struct ViewedBase_0
{
    float3 view_3;
    bool back_5;
    uint face_1;
    BinTaps_0 around_1;
    TexelBox_0 box_2;
    float2 trust_1;
};

BaseTaps_0 base_taps_0(const ViewedBase_0 thread* seen_0, float3 light_1)
{
    thread BaseTaps_0 taps_1;
    float3 _S207 = to_face_frame_0(light_1, seen_0->back_5);
    (&taps_1)->facing_0 = _S207;
    float _S208 = _S207.z;
    bool _S209 = _S208 < 0.0f;
    (&taps_1)->transmits_1 = _S209;
    (&taps_1)->around_0 = bin_taps_0(float3(_S207.xy, abs(_S208)), 32U);
    uint _S210 = seen_0->face_1 * 2U;
    uint _S211;
    if(_S209)
    {
        _S211 = 1U;
    }
    else
    {
        _S211 = 0U;
    }
    (&taps_1)->first_4 = (_S210 + _S211) * 1024U;
    float3 _S212 = (&taps_1)->facing_0 + seen_0->view_3;
    float3 half_vector_1 = _S212 * float3((1.0f / sqrt(max(square_0(_S212), 9.999999960041972e-13f)))) ;
    float3 half_vector_2;
    if((half_vector_1.z) < 0.0f)
    {
        half_vector_2 = - half_vector_1;
    }
    else
    {
        half_vector_2 = half_vector_1;
    }
    (&taps_1)->half_vector_0 = bin_taps_0(half_vector_2, 32U);
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
    thread Components_0 nothing_0;
    (&nothing_0)->diffuse_warp_0 = 0.0f;
    (&nothing_0)->diffuse_weft_0 = 0.0f;
    (&nothing_0)->specular_warp_0 = 0.0f;
    (&nothing_0)->specular_weft_0 = 0.0f;
    (&nothing_0)->light_visibility_1 = 0.0f;
    (&nothing_0)->hole_0 = 0.0f;
    return nothing_0;
}

float projected_area_1(float3 direction_2, float3 tangent_0, float roughness_1)
{
    float _S213 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S213 * _S213 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_1)
{
    float _S214 = clamp(x_1, -87.0f, 88.0f);
    float _S215 = floor(_S214 * 1.4426950216293335f + 0.5f);
    float _S216 = _S214 - _S215 * 0.693359375f + _S215 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S216 + 0.00139819993637502f) * _S216 + 0.00833345204591751f) * _S216 + 0.04166579619050026f) * _S216 + 0.1666666567325592f) * _S216 + 0.5f;
    float _S217 = (as_type<float>((uint(int(_S215) + int(127)) << 23U)));
    float _S218;
    if(x_1 < -87.0f)
    {
        _S218 = 0.0f;
    }
    else
    {
        _S218 = (p_0 * _S216 * _S216 + _S216 + 1.0f) * _S217;
    }
    return _S218;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_3;
    Albedos_0 weft_3;
};

float3 shaded_0(const Components_0 thread* components_0, const FamilyAlbedos_0 thread* albedos_4, bool transmits_2)
{
    if(transmits_2)
    {
        return (&albedos_4->warp_3)->diffuse_transmit_0 * float3(components_0->diffuse_warp_0)  + (&albedos_4->weft_3)->diffuse_transmit_0 * float3(components_0->diffuse_weft_0)  + (&albedos_4->warp_3)->specular_transmit_0 * float3(components_0->specular_warp_0)  + (&albedos_4->weft_3)->specular_transmit_0 * float3(components_0->specular_weft_0) ;
    }
    return (&albedos_4->warp_3)->diffuse_reflect_0 * float3(components_0->diffuse_warp_0)  + (&albedos_4->weft_3)->diffuse_reflect_0 * float3(components_0->diffuse_weft_0)  + (&albedos_4->warp_3)->specular_reflect_0 * float3(components_0->specular_warp_0)  + (&albedos_4->weft_3)->specular_reflect_0 * float3(components_0->specular_weft_0) ;
}

float3 bounced_value_0(const Bounced_0 thread* bounced_1, float3 light_2, float3 view_4)
{
    float _S219 = light_2.z;
    float3 _S220;
    if((_S219 * view_4.z) < 0.0f)
    {
        _S220 = bounced_1->transmitted_0;
    }
    else
    {
        _S220 = bounced_1->reflected_0;
    }
    return _S220 * float3((abs(_S219) * 0.31830987334251404f)) ;
}

float sheen_scale_0(float x_2, float y_1)
{
    return (((((0.0f * x_2 + (((((-1.1402510404586792f * y_1 + 0.40672621130943298f) * y_1 + 1.65398800373077393f) * y_1 + -1.29730904102325439f) * y_1 + 0.30570998787879944f) * y_1 + -0.0220868494361639f)) * x_2 + (((((-0.21142719686031342f * y_1 + 1.05947399139404297f) * y_1 + -0.41116121411323547f) * y_1 + -0.93859231472015381f) * y_1 + 0.51606941223144531f) * y_1 + 0.05409301072359085f)) * x_2 + (((((1.22944498062133789f * y_1 + -0.45962560176849365f) * y_1 + -1.63861405849456787f) * y_1 + 1.33565104007720947f) * y_1 + -0.45725581049919128f) * y_1 + 0.08243165910243988f)) * x_2 + (((((0.39779931306838989f * y_1 + -1.18879103660583496f) * y_1 + 0.28251591324806213f) * y_1 + 1.168984055519104f) * y_1 + -0.76864629983901978f) * y_1 + 0.0091691892594099f)) * x_2 + (((((-0.26563560962677002f * y_1 + -0.19379159808158875f) * y_1 + 0.2677634060382843f) * y_1 + 0.00270519289188087f) * y_1 + 0.14349560439586639f) * y_1 + 0.10290180146694183f)) * x_2 + (((((-0.20701569318771362f * y_1 + 0.24526430666446686f) * y_1 + 0.19551840424537659f) * y_1 + 0.07586126774549484f) * y_1 + 0.38894739747047424f) * y_1 + 0.15043120086193085f);
}

float sheen_shear_0(float x_3, float y_2)
{
    return ((((0.0f * x_3 + (((((-0.10608240216970444f * y_2 + 1.99214303493499756f) * y_2 + -1.42255294322967529f) * y_2 + -1.09495604038238525f) * y_2 + 0.59180057048797607f) * y_2 + 0.06902855634689331f)) * x_3 + (((((-0.46220690011978149f * y_2 + -0.29113379120826721f) * y_2 + 1.39025199413299561f) * y_2 + 0.35589990019798279f) * y_2 + -1.17120099067687988f) * y_2 + 0.15940259397029877f)) * x_3 + (((((2.26068711280822754f * y_2 + -3.64728999137878418f) * y_2 + -0.72173482179641724f) * y_2 + 3.07659196853637695f) * y_2 + -0.6827620267868042f) * y_2 + -0.3039557933807373f)) * x_3 + (((((0.81201767921447754f * y_2 + 0.36014080047607422f) * y_2 + -1.72646903991699219f) * y_2 + -0.22630110383033752f) * y_2 + 0.89514690637588501f) * y_2 + -0.10397960245609283f)) * x_3 + (((((-0.37648698687553406f * y_2 + 1.10974001884460449f) * y_2 + 0.17824520170688629f) * y_2 + -1.04968702793121338f) * y_2 + 0.1461234986782074f) * y_2 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_4, float y_3)
{
    return ((((0.0f * x_4 + (((((12.95646953582763672f * y_3 + -21.38032913208007812f) * y_3 + -7.37853097915649414f) * y_3 + 34.55607986450195312f) * y_3 + -23.61347007751464844f) * y_3 + 5.00126314163208008f)) * x_4 + (((((10.91487026214599609f * y_3 + -6.08202791213989258f) * y_3 + -38.2036285400390625f) * y_3 + 53.3440399169921875f) * y_3 + -21.91996002197265625f) * y_3 + 2.01606011390686035f)) * x_4 + (((((-14.52206039428710938f * y_3 + 36.803619384765625f) * y_3 + -22.94047927856445312f) * y_3 + -10.07973003387451172f) * y_3 + 15.77003955841064453f) * y_3 + -4.92722177505493164f)) * x_4 + (((((-7.62505722045898438f * y_3 + 1.27310299873352051f) * y_3 + 31.19523048400878906f) * y_3 + -44.39989852905273438f) * y_3 + 26.44947052001953125f) * y_3 + -8.73507976531982422f)) * x_4 + (((((5.65633487701416016f * y_3 + -17.66820907592773438f) * y_3 + 24.65356063842773438f) * y_3 + -19.38941001892089844f) * y_3 + 11.06159019470214844f) * y_3 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_2)
{
    float _S221 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S222 = 2.0f * sqrt(_S221) - 1.0f;
    float _S223 = 3.0f * sqrt(sqrt(clamp(roughness_2, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S222, _S223), 0.00999999977648258f, 1.0f), clamp((1.0f - _S221) * sheen_shear_0(_S222, _S223), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S222, _S223), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_3, float3 view_5, float scale_0, float shear_0)
{
    float _S224 = light_3.z;
    bool _S225;
    if(_S224 <= 0.0f)
    {
        _S225 = true;
    }
    else
    {
        _S225 = (view_5.z) <= 0.0f;
    }
    if(_S225)
    {
        return 0.0f;
    }
    float2 _S226 = view_5.xy;
    float _S227 = dot(_S226, _S226);
    float2 _S228;
    if(_S227 > 9.99999968265522539e-21f)
    {
        _S228 = _S226 * float2(rsqrt(_S227)) ;
    }
    else
    {
        _S228 = float2(1.0f, 0.0f);
    }
    float _S229 = scale_0 * dot(light_3.xy, _S228) + shear_0 * _S224;
    float _S230 = scale_0 * (light_3.y * _S228.x - light_3.x * _S228.y);
    float _S231 = _S229 * _S229 + _S230 * _S230 + _S224 * _S224;
    return 0.31830987334251404f * scale_0 * scale_0 * _S224 / max(_S231 * _S231, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_4, float3 view_6, float strength_0, float roughness_3)
{
    float3 _S232 = sheen_lobe_0(view_6.z, roughness_3);
    float _S233 = strength_0 * _S232.z;
    return float2(_S233 * transformed_cosine_0(light_4, view_6, _S232.x, _S232.y), 1.0f - _S233);
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
    thread SearchQuality_0 quality_0;
    (&quality_0)->steps_per_thread_0 = 5.0f;
    (&quality_0)->steps_per_relief_0 = 8.0f;
    (&quality_0)->shadow_share_0 = 1.0f;
    (&quality_0)->refinements_0 = 2U;
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

Shown_0 shown_at_0(const Crossing_0 thread* crossing_1, bool back_6)
{
    bool _S234 = (abs((&crossing_1->warp_4)->across_0)) < ((&crossing_1->warp_4)->half_width_1);
    bool _S235 = (abs((&crossing_1->weft_4)->across_0)) < ((&crossing_1->weft_4)->half_width_1);
    thread Shown_0 shown_0;
    bool _S236;
    if(_S234)
    {
        if(!_S235)
        {
            _S236 = true;
        }
        else
        {
            _S236 = crossing_1->warp_above_0;
        }
    }
    else
    {
        _S236 = false;
    }
    (&shown_0)->is_warp_0 = _S236;
    if(!_S234)
    {
        _S236 = !_S235;
    }
    else
    {
        _S236 = false;
    }
    (&shown_0)->hole_1 = _S236;
    uint _S237;
    if((&shown_0)->is_warp_0)
    {
        _S237 = crossing_1->warp_word_0;
    }
    else
    {
        _S237 = crossing_1->weft_word_0;
    }
    (&shown_0)->word_0 = _S237;
    (&shown_0)->on_top_0 = ((_S237 & 1U) == 1U) != back_6;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_5, const Cell_0 thread* second_1)
{
    thread Cell_0 cell_3;
    uint _S238;
    if(is_first_0)
    {
        _S238 = first_5->thread_0;
    }
    else
    {
        _S238 = second_1->thread_0;
    }
    (&cell_3)->thread_0 = _S238;
    float _S239;
    if(is_first_0)
    {
        _S239 = first_5->across_0;
    }
    else
    {
        _S239 = second_1->across_0;
    }
    (&cell_3)->across_0 = _S239;
    if(is_first_0)
    {
        _S239 = first_5->half_width_1;
    }
    else
    {
        _S239 = second_1->half_width_1;
    }
    (&cell_3)->half_width_1 = _S239;
    if(is_first_0)
    {
        _S239 = first_5->below_0;
    }
    else
    {
        _S239 = second_1->below_0;
    }
    (&cell_3)->below_0 = _S239;
    if(is_first_0)
    {
        _S239 = first_5->above_0;
    }
    else
    {
        _S239 = second_1->above_0;
    }
    (&cell_3)->above_0 = _S239;
    return cell_3;
}

float boundary_0(uint family_10, uint thread_3, int step_0, KernelContext_0 thread* kernelContext_19)
{
    float2 _S240 = turns_and_remainder_0(family_10, float(int(thread_3) + step_0), kernelContext_19);
    float _S241 = _S240.x;
    float _S242 = (kernelContext_19->families_0+family_10)->period_0;
    float _S243 = table_number_0((kernelContext_19->families_0+family_10)->place_table_0 + uint(_S240.y) * 4U, kernelContext_19);
    return fma(_S241, _S242, _S243);
}

float span_0(uint family_11, uint thread_4, int first_6, int last_1, KernelContext_0 thread* kernelContext_20)
{
    if(((kernelContext_20->families_0+family_11)->is_alike_0) != 0U)
    {
        return float(last_1 - first_6) * (kernelContext_20->families_0+family_11)->size_1;
    }
    float _S244 = boundary_0(family_11, thread_4, last_1, kernelContext_20);
    float _S245 = boundary_0(family_11, thread_4, first_6, kernelContext_20);
    return _S244 - _S245;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_12, uint thread_5, KernelContext_0 thread* kernelContext_21)
{
    uint _S246 = (kernelContext_21->families_0+family_12)->bend_table_0;
    uint _S247;
    if(((kernelContext_21->families_0+family_12)->is_alike_0) != 0U)
    {
        _S247 = 0U;
    }
    else
    {
        _S247 = thread_5 * 4U;
    }
    uint _S248 = _S246 + _S247;
    thread Bend_0 bend_0;
    float _S249 = table_number_0(_S248, kernelContext_21);
    (&bend_0)->sine_0 = _S249;
    float _S250 = table_number_0(_S248 + 1U, kernelContext_21);
    (&bend_0)->half_tangent_0 = _S250;
    float _S251 = table_number_0(_S248 + 2U, kernelContext_21);
    (&bend_0)->arc_0 = _S251;
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

Run_0 unpack_0(uint own_1, uint other_1, uint thread_6, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_22)
{
    int _S252 = int((word_1 >> 1U) & 127U);
    int _S253 = int((word_1 >> 8U) & 127U);
    int _S254 = int((word_1 >> 15U) & 63U);
    int _S255 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S256 = crossed_0->below_0;
    uint _S257 = crossed_0->thread_0;
    int _S258 = - _S252;
    float _S259 = span_0(other_1, crossed_0->thread_0, _S258, int(0), kernelContext_22);
    float _S260 = _S256 + _S259;
    (&run_0)->from_start_0 = _S260;
    float _S261 = crossed_0->above_0;
    int _S262 = _S253 + int(1);
    float _S263 = span_0(other_1, _S257, int(1), _S262, kernelContext_22);
    float _S264 = _S261 + _S263;
    (&run_0)->to_end_0 = _S264;
    bool _S265 = _S260 < _S264;
    (&run_0)->near_start_0 = _S265;
    int _S266;
    if(_S265)
    {
        _S266 = _S258 - _S254;
    }
    else
    {
        _S266 = _S262;
    }
    int _S267;
    if((&run_0)->near_start_0)
    {
        _S267 = _S258;
    }
    else
    {
        _S267 = _S262 + _S255;
    }
    Bend_0 _S268 = bend_of_0(own_1, thread_6, kernelContext_22);
    (&run_0)->bend_1 = _S268;
    float _S269;
    if((&run_0)->straight_0)
    {
        _S269 = 1.0e+06f;
    }
    else
    {
        _S269 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S269;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S270 = span_0(other_1, _S257, _S266, _S267, kernelContext_22);
    (&run_0)->other_reach_0 = min(0.5f * _S270, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S252 == int(0);
    (&run_0)->last_crossing_0 = _S253 == int(0);
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

Section_0 section_at_0(const Cell_0 thread* cell_4)
{
    float _S271 = cell_4->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S272 = clamp(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_3 = _S272;
    float _S273 = _S271 * _S271 - square_1(_S272);
    float _S274 = rsqrt(_S273);
    (&section_0)->drop_0 = _S271 - _S273 * _S274;
    (&section_0)->slope_0 = - _S272 * _S274;
    return section_0;
}

float edge_drop_0(uint family_13, uint thread_7, int step_1, KernelContext_0 thread* kernelContext_23)
{
    if(((kernelContext_23->families_0+family_13)->is_alike_0) != 0U)
    {
        float _S275 = table_number_0((kernelContext_23->families_0+family_13)->bend_table_0 + 3U, kernelContext_23);
        return _S275;
    }
    uint _S276 = (kernelContext_23->families_0+family_13)->bend_table_0;
    float2 _S277 = turns_and_remainder_0(family_13, float(int(thread_7) + step_1), kernelContext_23);
    float _S278 = table_number_0(_S276 + uint(_S277.y) * 4U + 3U, kernelContext_23);
    return _S278;
}

float2 dive_0(uint other_2, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_24)
{
    float _S279 = crossed_1->below_0;
    float _S280 = crossed_1->above_0;
    bool _S281 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S282 = min(crossed_1->below_0, crossed_1->above_0);
    float _S283;
    if(_S281)
    {
        _S283 = _S279 - crossed_1->across_0;
    }
    else
    {
        _S283 = _S280 + crossed_1->across_0;
    }
    float _S284 = _S283 - crossed_1->half_width_1;
    bool _S285;
    if(_S281)
    {
        _S285 = run_1->first_crossing_0;
    }
    else
    {
        _S285 = run_1->last_crossing_0;
    }
    bool _S286 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S283 = 0.0f;
    }
    else
    {
        float _S287 = (kernelContext_24->families_0+other_2)->height_scale_0;
        float _S288 = edge_drop_0(other_2, crossed_1->thread_0, int(0), kernelContext_24);
        _S283 = _S287 * _S288;
    }
    float _S289;
    if(_S286 != _S285)
    {
        _S289 = 0.0f;
    }
    else
    {
        float _S290 = (kernelContext_24->families_0+other_2)->height_scale_0;
        uint _S291 = crossed_1->thread_0;
        int _S292;
        if(_S281)
        {
            _S292 = int(-1);
        }
        else
        {
            _S292 = int(1);
        }
        float _S293 = edge_drop_0(other_2, _S291, _S292, kernelContext_24);
        _S289 = _S290 * _S293;
    }
    float _S294 = 1.0f / max(2.0f * _S284, 9.999999960041972e-13f);
    float _S295 = clamp((_S284 - _S282) * _S294, 0.0f, 1.0f);
    float _S296 = _S283 + (_S289 - _S283) * (_S295 * _S295 * (3.0f - 2.0f * _S295));
    float _S297 = (_S283 - _S289) * (6.0f * _S295 * (1.0f - _S295) * _S294);
    if(_S281)
    {
        _S283 = 1.0f;
    }
    else
    {
        _S283 = -1.0f;
    }
    return float2(_S296, _S297 * _S283);
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

StepControl_0 step_control_0(float2 direction_3, float step_3)
{
    thread StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S298 = direction_3.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S298), 9.99999971718068537e-10f);
    float _S299 = direction_3.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S299), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S298 > 0.0f;
    (&control_0)->up_0 = _S299 > 0.0f;
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
    thread PreviousSample_0 previous_0;
    (&previous_0)->clearance_0 = 0.0f;
    (&previous_0)->rate_0 = 0.0f;
    (&previous_0)->yarn_1 = 0U;
    (&previous_0)->known_0 = false;
    return previous_0;
}

float outline_distance_0(const Cell_0 thread* cell_5, const Shown_0 thread* shown_2, const Run_0 thread* run_2, bool lengthwise_0, bool forwards_0)
{
    float _S300;
    if(forwards_0)
    {
        _S300 = cell_5->across_0;
    }
    else
    {
        _S300 = - cell_5->across_0;
    }
    float _S301;
    if(forwards_0)
    {
        _S301 = cell_5->above_0;
    }
    else
    {
        _S301 = cell_5->below_0;
    }
    bool _S302;
    if(forwards_0)
    {
        _S302 = run_2->last_crossing_0;
    }
    else
    {
        _S302 = run_2->first_crossing_0;
    }
    bool _S303;
    if(forwards_0)
    {
        _S303 = run_2->first_crossing_0;
    }
    else
    {
        _S303 = run_2->last_crossing_0;
    }
    float _S304 = cell_5->half_width_1;
    float _S305 = - cell_5->half_width_1;
    bool _S306 = _S300 < _S305;
    bool _S307 = _S300 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S302 = !_S302;
    }
    else
    {
        _S302 = false;
    }
    if(_S302)
    {
        _S302 = !shown_2->hole_1;
    }
    else
    {
        _S302 = false;
    }
    bool _S308;
    if(_S302)
    {
        _S308 = shown_2->on_top_0;
    }
    else
    {
        _S308 = false;
    }
    if(_S308)
    {
        if(_S303)
        {
            _S303 = _S306;
        }
        else
        {
            _S303 = false;
        }
        _S303 = !_S303;
    }
    else
    {
        _S303 = false;
    }
    if(shown_2->hole_1)
    {
        _S302 = true;
    }
    else
    {
        if(_S302)
        {
            _S302 = !shown_2->on_top_0;
        }
        else
        {
            _S302 = false;
        }
    }
    float _S309;
    if(_S306)
    {
        _S309 = _S305;
    }
    else
    {
        _S309 = _S304;
    }
    float _S310 = _S309 - _S300;
    if(_S302)
    {
        _S300 = 2.0f * _S301 + _S300 - _S304;
    }
    else
    {
        _S300 = _S301;
    }
    if(_S303)
    {
        if(forwards_0)
        {
            _S300 = run_2->to_end_0;
        }
        else
        {
            _S300 = run_2->from_start_0;
        }
        return _S300;
    }
    if(_S307)
    {
    }
    else
    {
        _S300 = _S310;
    }
    return _S300;
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

float way_back_to_dip_0(const PreviousSample_0 thread* previous_1, float clearance_1, float rate_1, float step_4, const Probe_0 thread* here_0)
{
    float _S311 = previous_1->rate_0;
    float _S312 = previous_1->rate_0 * step_4;
    float _S313 = rate_1 * step_4;
    bool _S314;
    if(!previous_1->known_0)
    {
        _S314 = true;
    }
    else
    {
        _S314 = here_0->hole_2;
    }
    if(_S314)
    {
        _S314 = true;
    }
    else
    {
        _S314 = (previous_1->yarn_1) != (here_0->yarn_2);
    }
    if(_S314)
    {
        _S314 = true;
    }
    else
    {
        _S314 = _S311 >= 0.0f;
    }
    if(_S314)
    {
        _S314 = true;
    }
    else
    {
        _S314 = rate_1 <= 0.0f;
    }
    if(_S314)
    {
        return -1.0f;
    }
    float _S315 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S312) >= 0.0f)
    {
        _S314 = (3.0f * clearance_1 - _S313) >= 0.0f;
    }
    else
    {
        _S314 = false;
    }
    if(_S314)
    {
        return -1.0f;
    }
    float _S316 = clearance_1 - _S315;
    float _S317 = 6.0f * _S316 - 4.0f * _S312 - 2.0f * _S313;
    float _S318 = -2.0f * _S312 / max(_S317 + sqrt(max(_S317 * _S317 - 4.0f * (3.0f * (_S312 + _S313 - 2.0f * _S316)) * _S312, 0.0f)), 9.99999968265522539e-21f);
    float _S319 = 1.0f - _S318;
    float _S320 = (_S315 * (2.0f * _S318 + 1.0f) + _S312 * _S318) * _S319 * _S319;
    float _S321 = (clearance_1 * (2.0f * _S319 + 1.0f) - _S313 * _S319) * _S318 * _S318;
    if(_S318 > 0.01999999955296516f)
    {
        _S314 = _S319 > 0.01999999955296516f;
    }
    else
    {
        _S314 = false;
    }
    if(_S314)
    {
        _S314 = (_S320 + _S321) < 0.0f;
    }
    else
    {
        _S314 = false;
    }
    float _S322;
    if(_S314)
    {
        _S322 = _S319 * step_4;
    }
    else
    {
        _S322 = -1.0f;
    }
    return _S322;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S323 = here_1->hole_2;
    float _S324;
    if(here_1->hole_2)
    {
        _S324 = 1.0e+09f;
    }
    else
    {
        _S324 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S324;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_1 = here_1->yarn_2;
    bool _S325;
    if(!_S323)
    {
        _S325 = !is_cell_exit_0;
    }
    else
    {
        _S325 = false;
    }
    (&previous_2)->known_0 = _S325;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_6, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_6->per_x_0, side_y_1 * this_6->per_y_0), 0.0f) + this_6->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_7, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S326 = min(here_2->edge_x_0 * this_7->per_x_0, here_2->edge_y_0 * this_7->per_y_0);
    bool _S327;
    if(!here_2->hole_2)
    {
        _S327 = (rate_3 * _S326 + clearance_3) < 0.0f;
    }
    else
    {
        _S327 = false;
    }
    if(_S327)
    {
        _S327 = _S326 > (2.0f * this_7->epsilon_0);
    }
    else
    {
        _S327 = false;
    }
    float _S328 = this_7->step_2;
    float _S329;
    if(_S327)
    {
        _S329 = _S326 - this_7->epsilon_0;
    }
    else
    {
        _S329 = max(_S326, 0.0f) + this_7->epsilon_0;
    }
    return min(_S328, _S329);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_8, float height_2)
{
    return this_8->origin_0 + this_8->slope_1 * float2(height_2) ;
}

float ViewRay_rate_0(const ViewRay_0 thread* this_9, const Probe_0 thread* here_3)
{
    return here_3->slope_x_0 * this_9->slope_1.x + here_3->slope_y_0 * this_9->slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S330 = end_0 - start_1;
    float _S331 = start_rate_0 + end_rate_0 - 2.0f * _S330;
    float _S332 = 3.0f * _S330 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S330, 9.99999968265522539e-21f);
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
        float _S333 = clamp(share_1 - (((_S331 * share_1 + _S332) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S331 * share_1 + 2.0f * _S332) * share_1 + start_rate_0, 0.10000000149011612f * _S330 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S334 = i_0 + int(1);
        share_1 = _S333;
        i_0 = _S334;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S335 = along_slope_0 * along_slope_0 + 1.0f;
    float _S336 = rsqrt(_S335);
    float _S337 = sine_1 * _S336 * rsqrt(_S335 + across_slope_0 * across_slope_0);
    return float2(- _S337 * _S335, _S337 * across_slope_0 * along_slope_0 + cosine_0 * _S336);
}

float arc_sine_0(float x_6)
{
    float _S338 = abs(x_6);
    bool _S339 = _S338 > 0.5f;
    float _S340;
    if(_S339)
    {
        _S340 = 0.5f * (1.0f - _S338);
    }
    else
    {
        _S340 = _S338 * _S338;
    }
    float _S341;
    if(_S339)
    {
        _S341 = sqrt(max(_S340, 0.0f));
    }
    else
    {
        _S341 = _S338;
    }
    float _S342 = ((((0.04216320067644119f * _S340 + 0.02418131195008755f) * _S340 + 0.04547002539038658f) * _S340 + 0.07495300471782684f) * _S340 + 0.16666752099990845f) * _S340 * _S341 + _S341;
    if(_S339)
    {
        _S340 = 1.57079637050628662f - 2.0f * _S342;
    }
    else
    {
        _S340 = _S342;
    }
    if(x_6 < 0.0f)
    {
        _S340 = - _S340;
    }
    return _S340;
}

struct Hair_0
{
    float cover_0;
    float3 normal_0;
    float3 tangent_1;
};

Hair_0 Hair_x24init_0(float cover_1, float3 normal_1, float3 tangent_2)
{
    thread Hair_0 _S343;
    (&_S343)->cover_0 = cover_1;
    (&_S343)->normal_0 = normal_1;
    (&_S343)->tangent_1 = tangent_2;
    return _S343;
}

float fade_0(float size_4, float period_1)
{
    return clamp((1.0f - size_4 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

uint scramble_0(uint value_0)
{
    uint _S344 = value_0 * 747796405U + 2891336453U;
    uint _S345 = ((_S344 >> ((_S344 >> 28U) + 4U)) ^ _S344) * 277803737U;
    return (_S345 >> 22U) ^ _S345;
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
    return (float(bits_2 & 1023U) + 0.5f) * 0.0009765625f;
}

float2 sine_cosine_0(float x_7)
{
    float _S346 = floor(x_7 * 0.63661974668502808f + 0.5f);
    float _S347 = x_7 - _S346 * 1.5703125f - _S346 * 0.00048375129699707f - _S346 * 7.54979012640433211e-08f;
    float _S348 = _S347 * _S347;
    float _S349 = ((-0.00019515295571182f * _S348 + 0.00833216123282909f) * _S348 - 0.16666655242443085f) * _S348 * _S347 + _S347;
    float _S350 = ((0.00002443315679557f * _S348 - 0.00138873164542019f) * _S348 + 0.04166664555668831f) * _S348 * _S348 - 0.5f * _S348 + 1.0f;
    uint _S351 = uint(int(_S346)) & 3U;
    float2 _S352;
    if((_S351 & 1U) != 0U)
    {
        _S352 = float2(_S350, _S349);
    }
    else
    {
        _S352 = float2(_S349, _S350);
    }
    float _S353;
    if((_S351 & 2U) != 0U)
    {
        _S353 = - _S352.x;
    }
    else
    {
        _S353 = _S352.x;
    }
    float _S354;
    if(((_S351 + 1U) & 2U) != 0U)
    {
        _S354 = - _S352.y;
    }
    else
    {
        _S354 = _S352.y;
    }
    return float2(_S353, _S354);
}

Albedos_0 albedos_of_0(uint family_14, uint thread_9, KernelContext_0 thread* kernelContext_25)
{
    Albedos_0 _S355 = table_albedos_0((kernelContext_25->families_0+family_14)->albedo_table_0 + (kernelContext_25->families_0+family_14)->albedo_stride_0 * thread_9, kernelContext_25);
    return _S355;
}

float3 fibre_cell_0(float across_4, float along_1, float width_2)
{
    float _S356 = floor(across_4 / width_2);
    return float3(_S356, along_1 / (width_2 * 40.0f) + 0.61799997091293335f * _S356, 2.0f * (across_4 / width_2 - _S356) - 1.0f);
}

struct SurfacePoint_0
{
    bool hole_3;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_3;
    float3 normal_2;
    float3 tangent_3;
    float across_5;
    float fibre_across_0;
    float fibre_along_0;
};

float ply_offset_0(uint family_15, const SurfacePoint_0 thread* point_0, bool back_7, KernelContext_0 thread* kernelContext_26)
{
    float _S357;
    if(back_7)
    {
        _S357 = - (kernelContext_26->families_0+family_15)->ply_sine_0;
    }
    else
    {
        _S357 = (kernelContext_26->families_0+family_15)->ply_sine_0;
    }
    float _S358 = (point_0->fibre_across_0 * (kernelContext_26->families_0+family_15)->ply_cosine_0 + point_0->fibre_along_0 * _S357) * (kernelContext_26->families_0+family_15)->plies_per_mm_0;
    return 2.0f * (_S358 - floor(_S358)) - 1.0f;
}

float signed_noise_0(uint bits_3)
{
    return (float(bits_3 & 65535U) + 0.5f) * 0.000030517578125f - 1.0f;
}

float smooth_share_0(float share_2)
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

float2 wave_noise_0(uint key_1, float position_4)
{
    float _S359 = floor(position_4);
    float _S360 = position_4 - _S359;
    uint _S361 = uint(int(_S359));
    float _S362 = signed_noise_0(hash_bits_0(key_1, _S361));
    float _S363 = signed_noise_0(hash_bits_0(key_1, _S361 + 1U));
    return float2(mix(_S362, _S363, smooth_share_0(_S360)), 6.0f * _S360 * (1.0f - _S360) * (_S363 - _S362));
}

float2 cell_noise_0(uint key_2, float3 cell_7)
{
    float _S364 = cell_7.y;
    float _S365 = floor(_S364);
    uint _S366 = uint(int(cell_7.x)) * 65536U + uint(int(_S365));
    uint _S367 = hash_bits_0(key_2, _S366);
    uint _S368 = hash_bits_0(key_2, _S366 + 1U);
    return mix(float2(signed_noise_0(_S367), signed_noise_0(_S367 >> 16U)), float2(signed_noise_0(_S368), signed_noise_0(_S368 >> 16U)), float2(smooth_share_0(_S364 - _S365)) );
}

float uniform_hash_0(uint thread_10, uint cell_8, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_10, stream_1), cell_8)) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_11, float amount_0, uint seed_3)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_11, 0U, seed_3 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_0, float3 albedo_1, float3 room_0)
{
    float3 _S369 = room_0 / max(albedo_1, float3(9.99999997475242708e-07f) );
    return min(gain_0, max(min(min(_S369.x, _S369.y), _S369.z), 0.0f));
}

float flattened_0(float largest_0, float3 albedo_2, float3 room_1)
{
    float3 _S370 = room_1 / max(albedo_2, float3(9.99999997475242708e-07f) ) - float3(1.0f) ;
    return min(max(min(min(_S370.x, _S370.y), _S370.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

float natural_logarithm_0(float x_8)
{
    uint _S371 = (as_type<uint>((x_8)));
    float exponent_0 = float(int(_S371 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S371 & 8388607U) | 1056964608U)));
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
    float _S372 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S372 - exponent_1 * 0.00021219444170129f - 0.5f * _S372) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_12, uint cell_9, float amount_1, uint seed_4)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_12, cell_9, seed_4 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3 normal_3;
    float3 tangent_4;
    float loss_0;
};

YarnFrame_0 under_hair_0(const YarnFrame_0 thread* frame_0, const Hair_0 thread* hair_0)
{
    float3 _S373 = frame_0->tangent_4;
    float3 _S374 = hair_0->tangent_1;
    float3 _S375;
    if((dot(frame_0->tangent_4, hair_0->tangent_1)) < 0.0f)
    {
        _S375 = - _S374;
    }
    else
    {
        _S375 = _S374;
    }
    thread YarnFrame_0 blended_0;
    float3 _S376 = float3(hair_0->cover_0) ;
    float3 _S377 = normalize(mix(frame_0->normal_3, hair_0->normal_0, _S376));
    (&blended_0)->normal_3 = _S377;
    float3 _S378 = mix(_S373, _S375, _S376);
    float3 _S379 = _S378 - float3(dot(_S378, _S377))  * _S377;
    (&blended_0)->tangent_4 = _S379 * float3(rsqrt(max(dot(_S379, _S379), 9.999999960041972e-13f))) ;
    (&blended_0)->loss_0 = frame_0->loss_0 * (1.0f - hair_0->cover_0);
    return blended_0;
}

float diffuse_gain_0(const YarnFrame_0 thread* frame_1, float blend_0)
{
    return min(0.85000002384185791f * blend_0 * frame_1->loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1->normal_3.z - 1.0f) + 1.0f));
}

uint texel_along_0(float share_3, uint first_7, float extent_1, uint count_2)
{
    float _S380 = min(floor(share_3 * extent_1), extent_1 - 1.0f);
    float _S381 = float(count_2);
    uint _S382 = first_7 + min(uint(max(_S380 - floor(_S380 / _S381) * _S381, 0.0f)), count_2 - 1U);
    uint _S383;
    if(_S382 >= count_2)
    {
        _S383 = _S382 - count_2;
    }
    else
    {
        _S383 = _S382;
    }
    return _S383;
}

uint texel_of_0(const Clustered_0 thread* tables_3, const TexelBox_0 thread* box_3, float2 share_4)
{
    return texel_along_0(share_4.y, box_3->first_1.y, box_3->extent_0.y, tables_3->rows_0) * tables_3->columns_0 + texel_along_0(share_4.x, box_3->first_1.x, box_3->extent_0.x, tables_3->columns_0);
}

uint table_byte_0(uint table_1, uint index_4, KernelContext_0 thread* kernelContext_27)
{
    return (kernelContext_27->words_0[table_1 + index_4 / 4U] >> (8U * (index_4 & 3U))) & 255U;
}

float diffuse_reflection_0(float3 light_5, float3 normal_4, float blend_1)
{
    float _S384 = light_5.z;
    if(_S384 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S384, 0.0f), max(dot(light_5, normal_4), 0.0f), blend_1);
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

float flake_density_0(float squared_along_0, float roughness_4)
{
    float _S385 = roughness_4 * roughness_4;
    float _S386 = squared_along_0 * (1.0f - _S385) + _S385;
    return 0.31830987334251404f * _S385 * roughness_4 / (_S386 * _S386);
}

float density_between_0(float3 light_6, float3 view_7, float3 tangent_5, float roughness_5)
{
    float3 _S387 = light_6 + view_7;
    float _S388 = dot(_S387, tangent_5);
    return flake_density_0(min(_S388 * _S388 / max(square_0(_S387), 9.999999960041972e-13f), 1.0f), roughness_5);
}

float transmission_1(float3 light_7, float3 view_8, float3 normal_5, float3 tangent_6, float roughness_6, float optical_depth_1)
{
    float _S389 = - dot(light_7, normal_5);
    float _S390 = dot(view_8, normal_5);
    bool _S391;
    if(_S389 <= 0.0f)
    {
        _S391 = true;
    }
    else
    {
        _S391 = _S390 <= 0.0f;
    }
    if(_S391)
    {
        return 0.0f;
    }
    float _S392 = 1.0f / max(_S390, 9.99999997475242708e-07f);
    float _S393 = projected_area_1(light_7, tangent_6, roughness_6) / max(_S389, 9.99999997475242708e-07f);
    float _S394 = projected_area_1(view_8, tangent_6, roughness_6) * _S392;
    return density_between_0(light_7, view_8, tangent_6, roughness_6) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S393, _S394)) * mean_attenuation_0(optical_depth_1 * abs(_S393 - _S394)) * _S392;
}

float reflection_0(float3 light_8, float3 view_9, float3 normal_6, float3 tangent_7, float roughness_7, float optical_depth_2)
{
    float _S395 = dot(light_8, normal_6);
    bool _S396;
    if(_S395 <= 0.0f)
    {
        _S396 = true;
    }
    else
    {
        _S396 = (dot(view_9, normal_6)) <= 0.0f;
    }
    if(_S396)
    {
        return 0.0f;
    }
    float _S397 = max(_S395, 9.99999997475242708e-07f);
    float _S398 = max(dot(view_9, normal_6), 9.99999997475242708e-07f);
    float _S399 = projected_area_1(light_8, tangent_7, roughness_7) * _S398 + projected_area_1(view_9, tangent_7, roughness_7) * _S397;
    float _S400 = optical_depth_2 * _S399 / (_S397 * _S398);
    return 0.25f * density_between_0(light_8, view_9, tangent_7, roughness_7) * (_S400 * mean_attenuation_0(_S400)) * _S397 / _S399;
}

struct ClusteredView_0
{
    ViewedBase_0 base_0;
    FamilyAlbedos_0 albedos_5;
    Bounced_0 bounced_2;
    float3 view_10;
    bool is_alone_0;
};

ViewedBase_0 viewed_base_0(uint _S401, const Footprint_0 thread* _S402, float3 _S403, float _S404, bool _S405, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S406 = kernelContext_28->fabrics_0+_S401;
    thread ViewedBase_0 seen_1;
    bool _S407 = (_S403.z) < 0.0f;
    (&seen_1)->back_5 = _S407;
    (&seen_1)->view_3 = to_face_frame_0(_S403, _S407);
    uint _S408;
    if(_S407)
    {
        _S408 = 1U;
    }
    else
    {
        _S408 = 0U;
    }
    (&seen_1)->face_1 = _S408;
    BinTaps_0 _S409 = bin_taps_0((&seen_1)->view_3, 16U);
    (&seen_1)->around_1 = _S409;
    uint _S410 = _S408 * 256U;
    Clustered_0 _S411 = _S406->clustered_0;
    thread BinTaps_0 _S412 = _S409;
    float _S413 = BinTaps_read_0(&_S412, _S406->clustered_0.offset_1, _S410, 2U, 0U, kernelContext_28);
    thread BinTaps_0 _S414 = _S409;
    float _S415 = BinTaps_read_0(&_S414, _S411.offset_1, _S410, 2U, 1U, kernelContext_28);
    float2 _S416 = float2(_S413, _S415);
    float _S417 = _S404 - 0.5f;
    thread Clustered_0 _S418 = _S411;
    TexelBox_0 _S419 = texel_box_0(&_S418, _S402, _S416, _S417);
    (&seen_1)->box_2 = _S419;
    (&seen_1)->trust_1 = float2(1.0f) ;
    if(!_S405)
    {
        thread BinTaps_0 _S420 = (&seen_1)->around_1;
        float _S421 = BinTaps_read_0(&_S420, _S411.trust_0, _S410, 2U, 0U, kernelContext_28);
        thread BinTaps_0 _S422 = (&seen_1)->around_1;
        float _S423 = BinTaps_read_0(&_S422, _S411.trust_0, _S410, 2U, 1U, kernelContext_28);
        (&seen_1)->trust_1 = float2(_S421, _S423);
    }
    return seen_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S424, const Footprint_0 thread* _S425, bool _S426, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S427 = kernelContext_29->fabrics_0+_S424;
    float2 _S428 = sqrt(_S425->dx_0 * _S425->dx_0 + _S425->dy_0 * _S425->dy_0);
    uint _S429 = _S427->warp_0;
    float2 _S430 = _S425->centre_0;
    Stretch_0 _S431 = stretch_of_0(_S427->warp_0, _S425->centre_0.x, _S428.x, kernelContext_29);
    uint _S432 = _S427->weft_0;
    Stretch_0 _S433 = stretch_of_0(_S427->weft_0, _S430.y, _S428.y, kernelContext_29);
    thread FamilyAlbedos_0 albedos_6;
    thread Stretch_0 _S434 = _S431;
    thread Stretch_0 _S435 = _S433;
    Albedos_0 _S436 = mean_albedos_0(_S429, _S432, &_S434, &_S435, _S426, kernelContext_29);
    (&albedos_6)->warp_3 = _S436;
    thread Stretch_0 _S437 = _S433;
    thread Stretch_0 _S438 = _S431;
    Albedos_0 _S439 = mean_albedos_0(_S432, _S429, &_S437, &_S438, _S426, kernelContext_29);
    (&albedos_6)->weft_3 = _S439;
    return albedos_6;
}

float openness_number_0(uint _S440, uint _S441, KernelContext_0 thread* kernelContext_30)
{
    float _S442 = table_number_0((kernelContext_30->fabrics_0+_S440)->openness_0 + _S441, kernelContext_30);
    return _S442;
}

Scattered_0 scattered_by_0(uint _S443, const Albedos_0 thread* _S444, uint _S445, float3 _S446, KernelContext_0 thread* kernelContext_31)
{
    uint _S447 = 159U + 2U * _S445;
    thread Scattered_0 yarn_3;
    float3 _S448 = _S446 * _S444->diffuse_reflect_0;
    float _S449 = openness_number_0(_S443, _S447, kernelContext_31);
    (&yarn_3)->back_4 = _S448 + float3(_S449)  * _S444->specular_reflect_0;
    float3 _S450 = _S446 * _S444->diffuse_transmit_0;
    float _S451 = openness_number_0(_S443, _S447 + 1U, kernelContext_31);
    (&yarn_3)->through_0 = _S450 + float3(_S451)  * _S444->specular_transmit_0;
    return yarn_3;
}

float openness_number_1(uint _S452, uint _S453, KernelContext_0 thread* kernelContext_32)
{
    float _S454 = table_number_0((kernelContext_32->fabrics_0+_S452)->openness_0 + _S453, kernelContext_32);
    return _S454;
}

void sent_0(uint _S455, uint _S456, float3 _S457, float3 _S458, float3 _S459, float3 _S460, float3 thread* _S461, float3 thread* _S462, KernelContext_0 thread* kernelContext_33)
{
    uint _S463 = 146U + 4U * _S456;
    float _S464 = openness_number_1(_S455, _S463, kernelContext_33);
    float _S465 = openness_number_1(_S455, _S463 + 1U, kernelContext_33);
    float _S466 = openness_number_1(_S455, _S463 + 2U, kernelContext_33);
    float _S467 = openness_number_1(_S455, _S463 + 3U, kernelContext_33);
    float3 _S468 = float3(1.0f) ;
    float3 _S469 = _S468 - _S459 * float3(_S464) ;
    float3 _S470 = _S468 - _S460 * float3(_S467) ;
    float3 _S471 = _S468 / (_S469 * _S470 - _S459 * _S460 * float3((_S465 * _S466)) );
    *_S461 = (_S457 * _S470 + _S459 * float3(_S465)  * _S458) * _S471;
    *_S462 = (_S458 * _S469 + _S460 * float3(_S466)  * _S457) * _S471;
    return;
}

FaceSends_0 face_sends_0(uint _S472, uint _S473, const Scattered_0 thread* _S474, const Scattered_0 thread* _S475, KernelContext_0 thread* kernelContext_34)
{
    uint _S476 = 2U * _S473;
    uint _S477 = 142U + _S476;
    float _S478 = openness_number_0(_S472, _S477, kernelContext_34);
    float _S479 = openness_number_0(_S472, _S477 + 1U, kernelContext_34);
    float3 _S480 = _S474->back_4;
    float3 _S481 = float3((1.0f - _S478))  * _S474->back_4;
    float3 _S482 = _S475->back_4;
    float3 _S483 = float3((1.0f - _S479))  * _S475->back_4;
    thread FaceSends_0 sends_1;
    uint _S484 = 154U + _S476;
    float _S485 = openness_number_0(_S472, _S484, kernelContext_34);
    (&sends_1)->blocks_warp_0 = _S485;
    float _S486 = openness_number_0(_S472, _S484 + 1U, kernelContext_34);
    (&sends_1)->blocks_weft_0 = _S486;
    (&sends_1)->open_0 = _S485 * _S478 + _S486 * _S479;
    sent_0(_S472, _S473, float3(_S478)  * _S480, float3(_S479)  * _S482, _S481, _S483, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0, kernelContext_34);
    sent_0(_S472, _S473, _S474->through_0, _S475->through_0, _S481, _S483, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0, kernelContext_34);
    return sends_1;
}

Interior_0 interior_of_0(uint _S487, float3 _S488, bool _S489, KernelContext_0 thread* kernelContext_35)
{
    Fabric_0 device* _S490 = kernelContext_35->fabrics_0+_S487;
    Albedos_0 _S491 = table_albedos_0((kernelContext_35->families_0+_S490->warp_0)->colour_mean_0, kernelContext_35);
    thread Albedos_0 _S492 = _S491;
    Scattered_0 _S493 = scattered_by_0(_S487, &_S492, 0U, _S488, kernelContext_35);
    Albedos_0 _S494 = table_albedos_0((kernelContext_35->families_0+_S490->weft_0)->colour_mean_0, kernelContext_35);
    thread Albedos_0 _S495 = _S494;
    Scattered_0 _S496 = scattered_by_0(_S487, &_S495, 1U, _S488, kernelContext_35);
    uint _S497;
    if(_S489)
    {
        _S497 = 1U;
    }
    else
    {
        _S497 = 0U;
    }
    thread Scattered_0 _S498 = _S493;
    thread Scattered_0 _S499 = _S496;
    FaceSends_0 _S500 = face_sends_0(_S487, _S497, &_S498, &_S499, kernelContext_35);
    if(_S489)
    {
        _S497 = 0U;
    }
    else
    {
        _S497 = 1U;
    }
    thread Scattered_0 _S501 = _S493;
    thread Scattered_0 _S502 = _S496;
    FaceSends_0 _S503 = face_sends_0(_S487, _S497, &_S501, &_S502, kernelContext_35);
    float3 _S504 = float3(_S500.blocks_warp_0) ;
    float3 _S505 = float3(_S500.blocks_weft_0) ;
    float3 _S506 = _S504 * _S500.crossing_warp_0 + _S505 * _S500.crossing_weft_0;
    float3 _S507 = float3(_S503.blocks_warp_0) ;
    float3 _S508 = float3(_S503.blocks_weft_0) ;
    float3 _S509 = _S507 * _S503.crossing_warp_0 + _S508 * _S503.crossing_weft_0;
    float _S510 = 1.0f - _S500.open_0;
    float _S511 = 1.0f - _S503.open_0;
    float3 _S512 = float3(1.0f) ;
    float3 _S513 = _S512 / (_S512 - _S506 * _S509 * float3((_S510 * _S511)) );
    float3 _S514 = _S509 * (float3(_S500.open_0)  + float3(_S510)  * (_S504 * _S500.sky_warp_0 + _S505 * _S500.sky_weft_0)) * _S513;
    float3 _S515 = _S506 * (float3(_S503.open_0)  + float3(_S511)  * (_S507 * _S503.sky_warp_0 + _S508 * _S503.sky_weft_0)) * _S513;
    thread FaceSends_0 _S516 = _S500;
    FaceRadiance_0 _S517 = face_radiance_0(&_S516, _S503.open_0, _S514, _S515);
    thread FaceSends_0 _S518 = _S503;
    FaceRadiance_0 _S519 = face_radiance_0(&_S518, _S500.open_0, _S515, _S514);
    thread Interior_0 interior_1;
    (&interior_1)->warp_2 = _S517.warp_1;
    (&interior_1)->weft_2 = _S517.weft_1;
    (&interior_1)->leaked_1 = _S517.leaked_0;
    (&interior_1)->far_1 = _S519.mean_0;
    (&interior_1)->far_leaked_0 = _S519.leaked_0;
    return interior_1;
}

Blocked_0 blocked_of_terms_0(uint _S520, uint _S521, const array<float, int(6)> thread* _S522, uint _S523, KernelContext_0 thread* kernelContext_36)
{
    thread array<float, int(3)> shares_0;
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
        shares_0[share_5] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S523)
            {
            }
            else
            {
                break;
            }
            float _S524 = openness_number_0(_S520, _S521 + share_5 * _S523 + term_0, kernelContext_36);
            shares_0[share_5] = shares_0[share_5] + _S524 * (*_S522)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_5] = saturate(shares_0[share_5]);
        share_5 = share_5 + 1U;
    }
    thread Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

Blocked_0 blocked_from_0(uint _S525, float3 _S526, bool _S527, bool _S528, KernelContext_0 thread* kernelContext_37)
{
    thread array<float, int(6)> terms_1;
    view_terms_0(_S526, &terms_1);
    uint _S529;
    if(_S528)
    {
        _S529 = 2U;
    }
    else
    {
        _S529 = 0U;
    }
    uint _S530;
    if(_S527)
    {
        _S530 = 0U;
    }
    else
    {
        _S530 = 1U;
    }
    uint _S531 = (_S529 + _S530) * 15U;
    thread array<float, int(6)> _S532 = terms_1;
    Blocked_0 _S533 = blocked_of_terms_0(_S525, _S531, &_S532, 5U, kernelContext_37);
    return _S533;
}

float warp_seen_from_0(uint _S534, float3 _S535, bool _S536, KernelContext_0 thread* kernelContext_38)
{
    thread array<float, int(6)> terms_2;
    view_terms_0(_S535, &terms_2);
    uint term_1 = 0U;
    float share_6 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S537;
        if(_S536)
        {
            _S537 = 5U;
        }
        else
        {
            _S537 = 0U;
        }
        float _S538 = openness_number_0(_S534, 132U + _S537 + term_1, kernelContext_38);
        float share_7 = share_6 + _S538 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_6 = share_7;
    }
    return saturate(share_6);
}

Bounced_0 bounced_of_families_0(uint _S539, const FamilyAlbedos_0 thread* _S540, float3 _S541, const Interior_0 thread* _S542, const Blocked_0 thread* _S543, const Blocked_0 thread* _S544, KernelContext_0 thread* kernelContext_39)
{
    Scattered_0 _S545 = scattered_by_0(_S539, &_S540->warp_3, 0U, _S541, kernelContext_39);
    thread Scattered_0 _S546 = _S545;
    Bounced_0 _S547 = bounced_by_0(_S543, &_S546, _S542);
    Scattered_0 _S548 = scattered_by_0(_S539, &_S540->weft_3, 1U, _S541, kernelContext_39);
    thread Scattered_0 _S549 = _S548;
    Bounced_0 _S550 = bounced_by_0(_S544, &_S549, _S542);
    thread Bounced_0 _S551 = _S547;
    thread Bounced_0 _S552 = _S550;
    Bounced_0 _S553 = sum_of_0(&_S551, &_S552);
    return _S553;
}

Bounced_0 bounced_far_0(uint _S554, const FamilyAlbedos_0 thread* _S555, float3 _S556, const Interior_0 thread* _S557, float3 _S558, bool _S559, float _S560, float _S561, float _S562, KernelContext_0 thread* kernelContext_40)
{
    Blocked_0 _S563 = blocked_from_0(_S554, _S558, true, _S559, kernelContext_40);
    Blocked_0 _S564 = blocked_from_0(_S554, _S558, false, _S559, kernelContext_40);
    float _S565 = _S560 / max(1.0f - _S563.by_warp_0 - _S563.by_weft_0, 0.10000000149011612f);
    float _S566 = _S561 / max(1.0f - _S564.by_warp_0 - _S564.by_weft_0, 0.10000000149011612f);
    float _S567 = warp_seen_from_0(_S554, _S558, _S559, kernelContext_40);
    float _S568 = (0.0020000000949949f * _S567 + _S565) / (_S565 + _S566 + 0.0020000000949949f);
    float _S569 = 1.0f - _S562;
    float _S570 = _S568 * _S569;
    thread Blocked_0 _S571 = _S563;
    Blocked_0 _S572 = scaled_0(&_S571, _S570);
    float _S573 = (1.0f - _S568) * _S569;
    thread Blocked_0 _S574 = _S564;
    Blocked_0 _S575 = scaled_0(&_S574, _S573);
    thread Blocked_0 _S576 = _S572;
    thread Blocked_0 _S577 = _S575;
    Bounced_0 _S578 = bounced_of_families_0(_S554, _S555, _S556, _S557, &_S576, &_S577, kernelContext_40);
    return _S578;
}

ClusteredView_0 clustered_view_0(uint _S579, const Footprint_0 thread* _S580, float3 _S581, float3 _S582, uint _S583, bool _S584, KernelContext_0 thread* kernelContext_41)
{
    Fabric_0 device* _S585 = kernelContext_41->fabrics_0+_S579;
    thread ClusteredView_0 seen_2;
    ViewedBase_0 _S586 = viewed_base_0(_S579, _S580, _S581, uniform_of_0(_S583, 0U), _S584, kernelContext_41);
    (&seen_2)->base_0 = _S586;
    (&seen_2)->view_10 = _S581;
    (&seen_2)->is_alone_0 = _S584;
    FamilyAlbedos_0 _S587 = albedos_over_0(_S579, _S580, (&(&seen_2)->base_0)->back_5, kernelContext_41);
    thread Albedos_0 _S588 = _S587.warp_3;
    Albedos_0 _S589 = tinted_0(&_S588, _S582);
    (&(&seen_2)->albedos_5)->warp_3 = _S589;
    thread Albedos_0 _S590 = _S587.weft_3;
    Albedos_0 _S591 = tinted_0(&_S590, _S582);
    (&(&seen_2)->albedos_5)->weft_3 = _S591;
    float3 _S592 = float3(0.0f) ;
    (&(&seen_2)->bounced_2)->reflected_0 = _S592;
    (&(&seen_2)->bounced_2)->transmitted_0 = _S592;
    if((_S585->openness_0) != 4294967295U)
    {
        Interior_0 _S593 = interior_of_0(_S579, _S582, (&(&seen_2)->base_0)->back_5, kernelContext_41);
        thread FamilyAlbedos_0 _S594 = _S587;
        thread Interior_0 _S595 = _S593;
        Bounced_0 _S596 = bounced_far_0(_S579, &_S594, _S582, &_S595, (&(&seen_2)->base_0)->view_3, (&(&seen_2)->base_0)->back_5, 0.0f, 0.0f, 0.0f, kernelContext_41);
        (&seen_2)->bounced_2 = _S596;
    }
    return seen_2;
}

float clustered_hole_0(uint _S597, const ViewedBase_0 thread* _S598, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S599 = kernelContext_42->fabrics_0+_S597;
    uint cluster_0 = 0U;
    float covered_0 = 0.0f;
    for(;;)
    {
        Clustered_0 _S600 = _S599->clustered_0;
        if(cluster_0 < (_S599->clustered_0.clusters_0))
        {
        }
        else
        {
            break;
        }
        thread Clustered_0 _S601 = _S600;
        float _S602 = box_mean_0(&_S601, &_S598->box_2, _S598->face_1, cluster_0, kernelContext_42);
        float covered_1 = covered_0 + _S602;
        cluster_0 = cluster_0 + 1U;
        covered_0 = covered_1;
    }
    return clamp(1.0f - covered_0, 0.0f, 1.0f);
}

float cluster_density_0(uint _S603, const ViewedBase_0 thread* _S604, const BaseTaps_0 thread* _S605, uint _S606, uint _S607, KernelContext_0 thread* kernelContext_43)
{
    float _S608 = BinTaps_read_0(&_S605->half_vector_0, (kernelContext_43->fabrics_0+_S603)->clustered_0.basis_0, _S604->face_1 * 1024U, (kernelContext_43->fabrics_0+_S603)->clustered_0.clusters_0 * (1U + (kernelContext_43->fabrics_0+_S603)->clustered_0.rank_0), _S607 * (kernelContext_43->fabrics_0+_S603)->clustered_0.clusters_0 + _S606, kernelContext_43);
    return _S608;
}

struct ClusterTerms_0
{
    float diffuse_0;
    float specular_0;
    float lit_0;
};

float cluster_attenuation_0(uint _S609, const ViewedBase_0 thread* _S610, const BaseTaps_0 thread* _S611, uint _S612, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S613 = kernelContext_44->fabrics_0+_S609;
    uint _S614 = _S613->clustered_0.moments_1 + (_S610->face_1 * _S613->clustered_0.clusters_0 + _S612) * 8U;
    float _S615 = table_number_0(_S614, kernelContext_44);
    float _S616 = table_number_0(_S614 + 1U, kernelContext_44);
    float _S617 = table_number_0(_S614 + 2U, kernelContext_44);
    float3 _S618 = float3(_S615, _S616, _S617);
    float _S619 = table_number_0(_S614 + 3U, kernelContext_44);
    float _S620 = table_number_0(_S614 + 4U, kernelContext_44);
    float _S621 = table_number_0(_S614 + 5U, kernelContext_44);
    float3 _S622 = float3(_S619, _S620, _S621);
    float _S623 = table_number_0(_S614 + 7U, kernelContext_44);
    float _S624 = _S613->optical_depth_0;
    float3 _S625 = _S611->facing_0;
    float _S626 = dot(_S611->facing_0, _S618);
    bool _S627 = _S611->transmits_1;
    float _S628;
    if(_S611->transmits_1)
    {
        _S628 = - _S626;
    }
    else
    {
        _S628 = _S626;
    }
    float _S629 = max(dot(_S610->view_3, _S618), 0.10000000149011612f);
    float _S630 = projected_area_1(_S625, _S622, _S623) / max(_S628, 0.10000000149011612f);
    float _S631 = projected_area_1(_S610->view_3, _S622, _S623) / _S629;
    if(!_S627)
    {
        float _S632 = _S630 + _S631;
        return 0.25f * (1.0f - exponential_0(- _S624 * _S632)) / (_S632 * _S629);
    }
    float _S633 = max(_S624 * abs(_S630 - _S631), 0.00100000004749745f);
    return 0.25f * _S624 * exponential_0(- _S624 * min(_S630, _S631)) * (1.0f - exponential_0(- _S633)) / (_S633 * _S629);
}

ClusterTerms_0 cluster_terms_0(uint _S634, const ViewedBase_0 thread* _S635, const BaseTaps_0 thread* _S636, uint _S637, KernelContext_0 thread* kernelContext_45)
{
    Fabric_0 device* _S638 = kernelContext_45->fabrics_0+_S634;
    Clustered_0 _S639 = _S638->clustered_0;
    uint _S640 = _S636->first_4;
    uint _S641 = 2U * _S638->clustered_0.clusters_0;
    float _S642 = BinTaps_read_0(&_S636->around_0, _S638->clustered_0.light_0, _S636->first_4, _S641, _S637, kernelContext_45);
    float _S643 = BinTaps_read_0(&_S636->around_0, _S639.light_0, _S640, _S641, _S639.clusters_0 + _S637, kernelContext_45);
    float _S644 = BinTaps_read_0(&_S635->around_1, _S639.view_1, _S635->face_1 * 256U, _S639.clusters_0, _S637, kernelContext_45);
    thread ClusterTerms_0 terms_3;
    float _S645 = _S635->trust_1.x * _S644;
    (&terms_3)->diffuse_0 = _S645 * 0.31830987334251404f * ((1.0f - _S638->diffuse_blend_0) * abs(_S636->facing_0.z) * _S642 + _S638->diffuse_blend_0 * _S643);
    float _S646 = _S635->trust_1.y * _S644 * _S642;
    float _S647 = cluster_attenuation_0(_S634, _S635, _S636, _S637, kernelContext_45);
    (&terms_3)->specular_0 = _S646 * _S647;
    (&terms_3)->lit_0 = _S645 * _S642;
    return terms_3;
}

Components_0 with_cluster_0(uint _S648, const Components_0 thread* _S649, const ClusterTerms_0 thread* _S650, uint _S651, float _S652, float _S653, KernelContext_0 thread* kernelContext_46)
{
    bool _S654 = _S651 < ((kernelContext_46->fabrics_0+_S648)->clustered_0.clusters_0 / 2U);
    thread Components_0 result_2 = *_S649;
    float _S655;
    if(_S654)
    {
        _S655 = _S652 * _S650->diffuse_0;
    }
    else
    {
        _S655 = 0.0f;
    }
    (&result_2)->diffuse_warp_0 = (&result_2)->diffuse_warp_0 + _S655;
    if(_S654)
    {
        _S655 = 0.0f;
    }
    else
    {
        _S655 = _S652 * _S650->diffuse_0;
    }
    (&result_2)->diffuse_weft_0 = (&result_2)->diffuse_weft_0 + _S655;
    if(_S654)
    {
        _S655 = _S650->specular_0 * _S653;
    }
    else
    {
        _S655 = 0.0f;
    }
    (&result_2)->specular_warp_0 = (&result_2)->specular_warp_0 + _S655;
    if(_S654)
    {
        _S655 = 0.0f;
    }
    else
    {
        _S655 = _S650->specular_0 * _S653;
    }
    (&result_2)->specular_weft_0 = (&result_2)->specular_weft_0 + _S655;
    (&result_2)->light_visibility_1 = (&result_2)->light_visibility_1 + _S652 * _S650->lit_0;
    return result_2;
}

Components_0 clustered_base_0(uint _S656, const ViewedBase_0 thread* _S657, const BaseTaps_0 thread* _S658, KernelContext_0 thread* kernelContext_47)
{
    Clustered_0 _S659 = (kernelContext_47->fabrics_0+_S656)->clustered_0;
    Components_0 base_1 = no_components_0();
    uint cluster_1 = 0U;
    for(;;)
    {
        if(cluster_1 < (_S659.clusters_0))
        {
        }
        else
        {
            break;
        }
        uint _S660 = _S657->face_1;
        thread Clustered_0 _S661 = _S659;
        float _S662 = box_mean_0(&_S661, &_S657->box_2, _S657->face_1, cluster_1, kernelContext_47);
        if(_S662 <= 0.0f)
        {
            cluster_1 = cluster_1 + 1U;
            continue;
        }
        float _S663 = cluster_density_0(_S656, _S657, _S658, cluster_1, 0U, kernelContext_47);
        float _S664 = _S662 * _S663;
        uint number_2 = 1U;
        float density_0 = _S664;
        for(;;)
        {
            if(number_2 <= (_S659.rank_0))
            {
            }
            else
            {
                break;
            }
            uint _S665 = number_2 * _S659.clusters_0 + cluster_1;
            thread Clustered_0 _S666 = _S659;
            float _S667 = box_mean_0(&_S666, &_S657->box_2, _S660, _S665, kernelContext_47);
            float _S668 = cluster_density_0(_S656, _S657, _S658, cluster_1, number_2, kernelContext_47);
            float density_1 = density_0 + _S667 * _S668;
            number_2 = number_2 + 1U;
            density_0 = density_1;
        }
        ClusterTerms_0 _S669 = cluster_terms_0(_S656, _S657, _S658, cluster_1, kernelContext_47);
        thread Components_0 _S670 = base_1;
        thread ClusterTerms_0 _S671 = _S669;
        Components_0 _S672 = with_cluster_0(_S656, &_S670, &_S671, cluster_1, _S662, density_0, kernelContext_47);
        base_1 = _S672;
        cluster_1 = cluster_1 + 1U;
    }
    return base_1;
}

float3 under_sheen_0(uint _S673, const ClusteredView_0 thread* _S674, float3 _S675, float _S676, float3 _S677, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S678 = kernelContext_48->fabrics_0+_S673;
    float _S679 = _S678->sheen_strength_0;
    if((_S678->sheen_strength_0) <= 0.0f)
    {
        return _S675;
    }
    float2 _S680 = sheen_with_transmittance_0(to_face_frame_0(_S677, (&_S674->base_0)->back_5), (&_S674->base_0)->view_3, _S679, _S678->sheen_roughness_0);
    return float3(_S680.y)  * _S675 + float3((_S676 * _S680.x)) ;
}

float3 clustered_base_value_0(uint _S681, const ClusteredView_0 thread* _S682, float _S683, float3 _S684, KernelContext_0 thread* kernelContext_49)
{
    BaseTaps_0 _S685 = base_taps_0(&_S682->base_0, _S684);
    thread BaseTaps_0 _S686 = _S685;
    Components_0 _S687 = clustered_base_0(_S681, &_S682->base_0, &_S686, kernelContext_49);
    thread Components_0 _S688 = _S687;
    float3 _S689 = shaded_0(&_S688, &_S682->albedos_5, _S685.transmits_1);
    float _S690 = 1.0f - _S683;
    float3 _S691 = bounced_value_0(&_S682->bounced_2, _S684, _S682->view_10);
    float3 _S692 = under_sheen_0(_S681, _S682, _S689 + float3(_S690)  * _S691, _S687.light_visibility_1 + _S683, _S684, kernelContext_49);
    return _S692;
}

struct YarnPoint_0
{
    bool back_8;
    bool hole_4;
    bool is_warp_2;
    float x_9;
    float y_4;
    float height_4;
    float3 normal_7;
    float3 tangent_8;
    float3 surface_normal_0;
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
    float x_10;
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

Crossing_0 crossing_at_0(uint _S693, float _S694, float _S695, bool _S696, KernelContext_0 thread* kernelContext_50)
{
    Fabric_0 device* _S697 = kernelContext_50->fabrics_0+_S693;
    thread Crossing_0 crossing_3;
    Cell_0 _S698 = locate_0(_S697->warp_0, _S694, kernelContext_50);
    (&crossing_3)->warp_4 = _S698;
    Cell_0 _S699 = locate_0(_S697->weft_0, _S695, kernelContext_50);
    (&crossing_3)->weft_4 = _S699;
    uint _S700 = _S697->run_words_0 + 2U * ((&(&crossing_3)->weft_4)->thread_0 * _S697->ends_1 + (&(&crossing_3)->warp_4)->thread_0);
    uint _S701 = kernelContext_50->words_0[_S700];
    (&crossing_3)->warp_word_0 = _S701;
    (&crossing_3)->weft_word_0 = kernelContext_50->words_0[_S700 + 1U];
    (&crossing_3)->warp_above_0 = ((_S701 & 1U) == 1U) != _S696;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S702, float _S703, float _S704, bool _S705, KernelContext_0 thread* kernelContext_51)
{
    Fabric_0 device* _S706 = kernelContext_51->fabrics_0+_S702;
    thread Sample_0 sample_0;
    Crossing_0 _S707 = crossing_at_0(_S702, _S703, _S704, _S705, kernelContext_51);
    (&sample_0)->crossing_2 = _S707;
    thread Crossing_0 _S708 = _S707;
    Shown_0 _S709 = shown_at_0(&_S708, _S705);
    (&sample_0)->shown_3 = _S709;
    uint _S710;
    if(_S709.is_warp_0)
    {
        _S710 = _S706->warp_0;
    }
    else
    {
        _S710 = _S706->weft_0;
    }
    uint _S711;
    if(_S709.is_warp_0)
    {
        _S711 = _S706->weft_0;
    }
    else
    {
        _S711 = _S706->warp_0;
    }
    thread Cell_0 _S712 = (&(&sample_0)->crossing_2)->warp_4;
    thread Cell_0 _S713 = (&(&sample_0)->crossing_2)->weft_4;
    Cell_0 _S714 = select_cell_0(_S709.is_warp_0, &_S712, &_S713);
    thread Cell_0 _S715 = (&(&sample_0)->crossing_2)->weft_4;
    thread Cell_0 _S716 = (&(&sample_0)->crossing_2)->warp_4;
    Cell_0 _S717 = select_cell_0(_S709.is_warp_0, &_S715, &_S716);
    thread Cell_0 _S718 = _S717;
    Run_0 _S719 = unpack_0(_S710, _S711, _S714.thread_0, &_S718, _S709.word_0, kernelContext_51);
    thread Cell_0 _S720 = _S714;
    Section_0 _S721 = section_at_0(&_S720);
    bool _S722;
    if(_S709.on_top_0)
    {
        _S722 = (_S719.distance_0) < (_S721.drop_0 * _S719.bend_1.sine_0);
    }
    else
    {
        _S722 = false;
    }
    bool _S723;
    if(_S709.on_top_0)
    {
        _S723 = !_S722;
    }
    else
    {
        _S723 = false;
    }
    float _S724;
    if(_S723)
    {
        _S724 = 1.0f;
    }
    else
    {
        _S724 = -1.0f;
    }
    float _S725;
    if(_S722)
    {
        _S725 = _S719.other_reach_0;
    }
    else
    {
        _S725 = _S719.reach_0;
    }
    float _S726;
    if(_S722)
    {
        _S726 = _S725 + _S719.distance_0;
    }
    else
    {
        _S726 = max(_S725 - _S719.distance_0, 0.0f);
    }
    float _S727 = _S725 / _S719.bend_1.sine_0 - _S724 * _S721.drop_0;
    float _S728 = _S726 * _S726;
    float _S729 = max(_S727 * _S727 - _S728, 9.99999968265522539e-21f);
    float _S730 = rsqrt(_S729);
    float _S731 = _S728 / (_S729 * _S730 + _S727);
    bool _S732 = _S726 > 0.0f;
    float _S733;
    if(_S709.on_top_0)
    {
        _S733 = 1.0f;
    }
    else
    {
        _S733 = -1.0f;
    }
    float _S734;
    if(_S719.near_start_0)
    {
        _S734 = 1.0f;
    }
    else
    {
        _S734 = -1.0f;
    }
    float _S735 = _S733 * _S734;
    if(_S732)
    {
        _S733 = _S727 * _S730;
    }
    else
    {
        _S733 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S721.slope_0 * _S733;
    if(_S732)
    {
        _S726 = _S735 * _S726 * _S730;
    }
    else
    {
        _S726 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S726;
    float _S736 = (kernelContext_51->families_0+_S710)->height_scale_0;
    thread Shown_0 _S737 = _S709;
    thread Run_0 _S738 = _S719;
    thread Cell_0 _S739 = _S717;
    float2 _S740 = dive_0(_S711, &_S737, &_S738, &_S739, kernelContext_51);
    if(_S719.straight_0)
    {
        _S724 = 0.0f;
    }
    else
    {
        _S724 = _S736 * _S724;
    }
    (&sample_0)->height_6 = _S724 * (_S725 * _S719.bend_1.half_tangent_0 - _S731) - _S736 * _S721.drop_0 - _S740.x;
    float _S741 = _S736 * (&sample_0)->slope_across_0;
    float _S742 = _S736 * (&sample_0)->slope_along_0 - _S740.y;
    if(_S709.is_warp_0)
    {
        _S724 = _S741;
    }
    else
    {
        _S724 = _S742;
    }
    (&sample_0)->slope_x_1 = _S724;
    if(_S709.is_warp_0)
    {
        _S724 = _S742;
    }
    else
    {
        _S724 = _S741;
    }
    (&sample_0)->slope_y_1 = _S724;
    (&sample_0)->run_3 = _S719;
    (&sample_0)->section_1 = _S721;
    return sample_0;
}

float steps_per_length_0(uint _S743, const SearchQuality_0 thread* _S744, float3 _S745, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S746 = kernelContext_52->fabrics_0+_S743;
    return max(max(abs(_S745.x) * _S746->threads_per_x_0, abs(_S745.y) * _S746->threads_per_y_0) * _S744->steps_per_thread_0, abs(_S745.z) * _S746->per_relief_0 * _S744->steps_per_relief_0);
}

float cell_maximum_0(uint _S747, const Crossing_0 thread* _S748, KernelContext_0 thread* kernelContext_53)
{
    Fabric_0 device* _S749 = kernelContext_53->fabrics_0+_S747;
    bool _S750 = _S748->warp_above_0;
    uint _S751;
    if(_S748->warp_above_0)
    {
        _S751 = _S749->warp_0;
    }
    else
    {
        _S751 = _S749->weft_0;
    }
    uint _S752;
    if(_S750)
    {
        _S752 = _S748->warp_word_0;
    }
    else
    {
        _S752 = _S748->weft_word_0;
    }
    return float(_S752 >> 28U) * (kernelContext_53->families_0+_S751)->height_scale_0 * (kernelContext_53->families_0+_S751)->level_0;
}

Probe_0 probe_0(uint _S753, float _S754, float _S755, bool _S756, bool _S757, bool _S758, KernelContext_0 thread* kernelContext_54)
{
    Sample_0 _S759 = sample_at_0(_S753, _S754, _S755, _S756, kernelContext_54);
    thread Probe_0 probe_1;
    (&probe_1)->height_1 = _S759.height_6;
    (&probe_1)->hole_2 = _S759.shown_3.hole_1;
    (&probe_1)->slope_x_0 = _S759.slope_x_1;
    (&probe_1)->slope_y_0 = _S759.slope_y_1;
    uint _S760;
    if(_S759.shown_3.is_warp_0)
    {
        _S760 = _S759.crossing_2.warp_4.thread_0 * 2U + 1U;
    }
    else
    {
        _S760 = _S759.crossing_2.weft_4.thread_0 * 2U;
    }
    (&probe_1)->yarn_2 = _S760;
    thread Crossing_0 _S761 = _S759.crossing_2;
    float _S762 = cell_maximum_0(_S753, &_S761, kernelContext_54);
    (&probe_1)->cell_max_0 = _S762;
    float _S763;
    if(_S757)
    {
        _S763 = _S759.crossing_2.warp_4.above_0;
    }
    else
    {
        _S763 = _S759.crossing_2.warp_4.below_0;
    }
    (&probe_1)->side_x_0 = _S763;
    if(_S758)
    {
        _S763 = _S759.crossing_2.weft_4.above_0;
    }
    else
    {
        _S763 = _S759.crossing_2.weft_4.below_0;
    }
    (&probe_1)->side_y_0 = _S763;
    bool _S764 = !_S759.shown_3.is_warp_0;
    thread Cell_0 _S765 = _S759.crossing_2.warp_4;
    thread Shown_0 _S766 = _S759.shown_3;
    thread Run_0 _S767 = _S759.run_3;
    float _S768 = outline_distance_0(&_S765, &_S766, &_S767, _S764, _S757);
    (&probe_1)->edge_x_0 = _S768;
    thread Cell_0 _S769 = _S759.crossing_2.weft_4;
    thread Shown_0 _S770 = _S759.shown_3;
    thread Run_0 _S771 = _S759.run_3;
    float _S772 = outline_distance_0(&_S769, &_S770, &_S771, _S759.shown_3.is_warp_0, _S758);
    (&probe_1)->edge_y_0 = _S772;
    return probe_1;
}

bool is_free_0(uint _S773, const SearchQuality_0 thread* _S774, float3 _S775, float3 _S776, bool _S777, float _S778, KernelContext_0 thread* kernelContext_55)
{
    float _S779 = _S776.z;
    if(_S779 <= 0.0f)
    {
        return false;
    }
    float _S780 = _S774->shadow_share_0;
    float _S781 = steps_per_length_0(_S773, _S774, _S776, kernelContext_55);
    float _S782 = 1.0f / max(_S780 * _S781, 9.99999971718068537e-10f);
    StepControl_0 _S783 = step_control_0(_S776.xy, _S782);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S784;
        if(count_3 < 1024U)
        {
            _S784 = (_S775.z + _S779 * distance_1) < _S778;
        }
        else
        {
            _S784 = false;
        }
        if(_S784)
        {
        }
        else
        {
            break;
        }
        float3 _S785 = _S775 + _S776 * float3(distance_1) ;
        Probe_0 _S786 = probe_0(_S773, _S785.x, _S785.y, _S777, _S783.right_0, _S783.up_0, kernelContext_55);
        float _S787 = _S785.z;
        float _S788 = _S787 - _S786.height_1;
        float _S789 = _S779 - _S786.slope_x_0 * _S776.x - _S786.slope_y_0 * _S776.y;
        bool _S790;
        if(!_S786.hole_2)
        {
            _S790 = _S788 < 0.0f;
        }
        else
        {
            _S790 = false;
        }
        if(_S790)
        {
            return false;
        }
        thread PreviousSample_0 _S791 = previous_3;
        thread Probe_0 _S792 = _S786;
        float _S793 = way_back_to_dip_0(&_S791, _S788, _S789, last_step_0, &_S792);
        if(_S793 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S793;
            distance_1 = distance_1 - _S793;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S794 = _S787 > (_S786.cell_max_0);
        thread Probe_0 _S795 = _S786;
        PreviousSample_0 _S796 = after_sample_0(_S788, _S789, &_S795, _S794);
        float last_step_2;
        if(_S794)
        {
            thread StepControl_0 _S797 = _S783;
            float _S798 = StepControl_to_cell_exit_0(&_S797, _S786.side_x_0, _S786.side_y_0);
            last_step_2 = max(_S798, _S782);
        }
        else
        {
            thread StepControl_0 _S799 = _S783;
            thread Probe_0 _S800 = _S786;
            float _S801 = StepControl_to_next_sample_0(&_S799, &_S800, _S788, _S789);
            last_step_2 = _S801;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S796;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S802, const SearchQuality_0 thread* _S803, float _S804, float _S805, float3 _S806, bool _S807, KernelContext_0 thread* kernelContext_56)
{
    Fabric_0 device* _S808 = kernelContext_56->fabrics_0+_S802;
    Sample_0 _S809 = sample_at_0(_S802, _S804, _S805, _S807, kernelContext_56);
    if(!_S809.shown_3.hole_1)
    {
        return false;
    }
    float3 _S810 = float3(_S804, _S805, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S811;
        if(side_0 < 2U)
        {
            _S811 = passes_0;
        }
        else
        {
            _S811 = false;
        }
        if(_S811)
        {
        }
        else
        {
            break;
        }
        float3 _S812;
        if(side_0 == 0U)
        {
            _S812 = _S806;
        }
        else
        {
            _S812 = float3(- _S806.x, - _S806.y, _S806.z);
        }
        bool _S813 = is_free_0(_S802, _S803, _S810, _S812, _S807 != (side_0 == 1U), _S808->height_high_0, kernelContext_56);
        uint _S814 = side_0 + 1U;
        passes_0 = _S813;
        side_0 = _S814;
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

float max_height_along_0(uint _S815, float _S816, float _S817, float _S818, float3 _S819, bool _S820, KernelContext_0 thread* kernelContext_57)
{
    Fabric_0 device* _S821 = kernelContext_57->fabrics_0+_S815;
    Cell_0 _S822 = locate_0(_S821->warp_0, _S816, kernelContext_57);
    uint _S823 = _S822.thread_0 / 2U;
    Cell_0 _S824 = locate_0(_S821->weft_0, _S817, kernelContext_57);
    uint _S825 = _S824.thread_0 / 2U;
    float _S826 = _S819.x;
    uint _S827;
    if(_S826 > 0.0f)
    {
        _S827 = 1U;
    }
    else
    {
        _S827 = 0U;
    }
    float _S828 = _S819.y;
    uint _S829;
    if(_S828 > 0.0f)
    {
        _S829 = 2U;
    }
    else
    {
        _S829 = 0U;
    }
    uint _S830 = kernelContext_57->words_0[_S821->max_heights_0 + 4U * (_S825 * _S821->max_height_columns_0 + _S823) + (_S827 + _S829)];
    int number_3;
    if(_S820)
    {
        number_3 = int(4);
    }
    else
    {
        number_3 = int(0);
    }
    uint _S831 = _S830 >> uint(number_3);
    float _S832 = max(abs(_S826) * _S821->threads_per_x_0, abs(_S828) * _S821->threads_per_y_0) / _S819.z;
    float _S833 = _S821->height_high_0;
    float max_height_0 = _S821->height_high_0;
    number_3 = int(3);
    for(;;)
    {
        if(number_3 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S818) * _S832) <= (PYRAMID_RADII_0[number_3]))
        {
            max_height_0 = min(max_height_0, float((_S831 >> uint(int(8) * number_3)) & 15U) * 0.06666667014360428f * _S833);
        }
        number_3 = number_3 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S834, float _S835, float _S836, bool _S837, bool _S838, bool _S839, KernelContext_0 thread* kernelContext_58)
{
    Crossing_0 _S840 = crossing_at_0(_S834, _S835, _S836, _S837, kernelContext_58);
    thread Crossing_0 _S841 = _S840;
    float _S842 = cell_maximum_0(_S834, &_S841, kernelContext_58);
    float _S843;
    if(_S838)
    {
        _S843 = _S840.warp_4.above_0;
    }
    else
    {
        _S843 = _S840.warp_4.below_0;
    }
    float _S844;
    if(_S839)
    {
        _S844 = _S840.weft_4.above_0;
    }
    else
    {
        _S844 = _S840.weft_4.below_0;
    }
    return float3(_S842, _S843, _S844);
}

float first_sample_height_0(uint _S845, const ViewRay_0 thread* _S846, const StepControl_0 thread* _S847, bool _S848, KernelContext_0 thread* kernelContext_59)
{
    float _S849 = max_height_along_0(_S845, _S846->origin_0.x, _S846->origin_0.y, 0.0f, float3(_S846->slope_1, 1.0f), _S848, kernelContext_59);
    uint count_4 = 0U;
    float height_8 = _S849;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S850 = ViewRay_at_0(_S846, height_8);
        float3 _S851 = cell_bounds_0(_S845, _S850.x, _S850.y, _S848, _S847->right_0, _S847->up_0, kernelContext_59);
        float _S852 = height_8 - _S851.x;
        float _S853 = StepControl_to_cell_exit_0(_S847, _S851.y, _S851.z);
        float height_9 = height_8 - clamp(_S852, 0.0f, _S853);
        if(_S852 <= _S853)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S854, const ViewRay_0 thread* _S855, const StepControl_0 thread* _S856, bool _S857, KernelContext_0 thread* kernelContext_60)
{
    Fabric_0 device* _S858 = kernelContext_60->fabrics_0+_S854;
    float _S859 = _S858->height_low_0 - (_S858->height_high_0 - _S858->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S860 = first_sample_height_0(_S854, _S855, _S856, _S857, kernelContext_60);
    (&end_1)->height_7 = _S860;
    (&end_1)->last_step_3 = _S856->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
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
        float2 _S861 = ViewRay_at_0(_S855, (&end_1)->height_7);
        Probe_0 _S862 = probe_0(_S854, _S861.x, _S861.y, _S857, _S856->right_0, _S856->up_0, kernelContext_60);
        float _S863 = (&end_1)->height_7 - _S862.height_1;
        thread Probe_0 _S864 = _S862;
        float _S865 = ViewRay_rate_0(_S855, &_S864);
        (&end_1)->depth_1 = - _S863;
        (&end_1)->rate_4 = _S865;
        bool _S866;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S866 = !_S862.hole_2;
        }
        else
        {
            _S866 = false;
        }
        bool _S867;
        if(_S866)
        {
            _S867 = ((&(&end_1)->previous_4)->yarn_1) == (_S862.yarn_2);
        }
        else
        {
            _S867 = false;
        }
        (&end_1)->smooth_0 = _S867;
        bool _S868;
        if(!_S862.hole_2)
        {
            _S868 = _S863 <= 0.0f;
        }
        else
        {
            _S868 = false;
        }
        bool _S869;
        if(_S868)
        {
            _S869 = true;
        }
        else
        {
            _S869 = ((&end_1)->height_7) <= _S859;
        }
        if(_S869)
        {
            break;
        }
        thread PreviousSample_0 _S870 = (&end_1)->previous_4;
        thread Probe_0 _S871 = _S862;
        float _S872 = way_back_to_dip_0(&_S870, _S863, _S865, (&end_1)->last_step_3, &_S871);
        if(_S872 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S872;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S872;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S873 = StepControl_to_cell_exit_0(_S856, _S862.side_x_0, _S862.side_y_0);
        float _S874 = min(_S873, (&end_1)->height_7 - _S862.cell_max_0);
        thread Probe_0 _S875 = _S862;
        float _S876 = StepControl_to_next_sample_0(_S856, &_S875, _S863, _S865);
        bool _S877 = _S874 > _S876;
        thread Probe_0 _S878 = _S862;
        PreviousSample_0 _S879 = after_sample_0(_S863, _S865, &_S878, _S877);
        (&end_1)->previous_4 = _S879;
        float _S880 = max(_S874, _S876);
        (&end_1)->last_step_3 = _S880;
        (&end_1)->height_7 = (&end_1)->height_7 - _S880;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S881, const ViewRay_0 thread* _S882, const StepControl_0 thread* _S883, bool _S884, const ViewRayEnd_0 thread* _S885, uint _S886, KernelContext_0 thread* kernelContext_61)
{
    Fabric_0 device* _S887 = kernelContext_61->fabrics_0+_S881;
    float _S888 = _S887->height_high_0 - _S887->height_low_0;
    float _S889 = _S885->height_7;
    float _S890 = _S885->last_step_3;
    float above_2 = _S885->height_7 + _S885->last_step_3;
    float above_gap_1 = clamp((&_S885->previous_4)->clearance_0, 0.0f, _S888);
    float under_gap_1 = clamp(_S885->depth_1, 0.0f, _S888);
    float _S891 = cubic_root_0(above_gap_1, - under_gap_1, (&_S885->previous_4)->rate_0 * _S885->last_step_3, _S885->rate_4 * _S885->last_step_3);
    bool _S892 = _S885->smooth_0;
    float middle_0;
    if(_S885->smooth_0)
    {
        middle_0 = above_2 - _S891 * _S890;
    }
    else
    {
        middle_0 = between_0(above_2, _S889, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S889;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S886)
        {
        }
        else
        {
            break;
        }
        float2 _S893 = ViewRay_at_0(_S882, middle_0);
        Probe_0 _S894 = probe_0(_S881, _S893.x, _S893.y, _S884, _S883->right_0, _S883->up_0, kernelContext_61);
        float _S895;
        if(_S894.hole_2)
        {
            _S895 = -1.0e+09f;
        }
        else
        {
            _S895 = _S894.height_1;
        }
        float _S896 = clamp(middle_0 - _S895, - _S888, _S888);
        float _S897;
        if(_S896 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S897 = 0.5f * above_gap_2;
            }
            else
            {
                _S897 = above_gap_2;
            }
            float _S898 = - _S896;
            under_1 = middle_0;
            above_gap_2 = _S897;
            under_gap_2 = _S898;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S897 = 0.5f * under_gap_2;
            }
            else
            {
                _S897 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S896;
            under_gap_2 = _S897;
            side_1 = -1.0f;
        }
        if(_S892)
        {
            thread Probe_0 _S899 = _S894;
            float _S900 = ViewRay_rate_0(_S882, &_S899);
            middle_0 = clamp(middle_0 + _S896 / min(_S900, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S892)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S901, const SearchQuality_0 thread* _S902, float _S903, float _S904, float3 _S905, bool _S906, KernelContext_0 thread* kernelContext_62)
{
    float _S907 = max(_S905.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S903, _S904);
    float2 _S908 = _S905.xy / float2(_S907) ;
    (&ray_0)->slope_1 = _S908;
    float2 _S909 = - _S908;
    float _S910 = steps_per_length_0(_S901, _S902, _S905, kernelContext_62);
    StepControl_0 _S911 = step_control_0(_S909, 1.0f / max(_S910 / _S907, 9.99999971718068537e-10f));
    thread ViewRay_0 _S912 = ray_0;
    thread StepControl_0 _S913 = _S911;
    ViewRayEnd_0 _S914 = search_down_0(_S901, &_S912, &_S913, _S906, kernelContext_62);
    thread Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    thread ViewRay_0 _S915 = ray_0;
    thread StepControl_0 _S916 = _S911;
    thread ViewRayEnd_0 _S917 = _S914;
    float _S918 = refined_height_0(_S901, &_S915, &_S916, _S906, &_S917, _S902->refinements_0, kernelContext_62);
    (&hit_0)->height_5 = _S918;
    thread ViewRay_0 _S919 = ray_0;
    float2 _S920 = ViewRay_at_0(&_S919, _S918);
    (&hit_0)->x_10 = _S920.x;
    (&hit_0)->y_5 = _S920.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S921, const SearchQuality_0 thread* _S922, float _S923, float _S924, float3 _S925, bool _S926, KernelContext_0 thread* kernelContext_63)
{
    bool _S927 = passes_through_0(_S921, _S922, _S923, _S924, _S925, _S926, kernelContext_63);
    if(!_S927)
    {
        Hit_0 _S928 = first_hit_of_yarn_0(_S921, _S922, _S923, _S924, _S925, _S926, kernelContext_63);
        return _S928;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_10 = _S923;
    (&hit_1)->y_5 = _S924;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S929, float _S930, float _S931, bool _S932, KernelContext_0 thread* kernelContext_64)
{
    Fabric_0 device* _S933 = kernelContext_64->fabrics_0+_S929;
    Sample_0 _S934 = sample_at_0(_S929, _S930, _S931, _S932, kernelContext_64);
    float _S935;
    if(_S934.shown_3.is_warp_0)
    {
        _S935 = _S934.crossing_2.warp_4.half_width_1;
    }
    else
    {
        _S935 = _S934.crossing_2.weft_4.half_width_1;
    }
    uint _S936;
    if(_S934.shown_3.is_warp_0)
    {
        _S936 = _S933->warp_0;
    }
    else
    {
        _S936 = _S933->weft_0;
    }
    float _S937 = (kernelContext_64->families_0+_S936)->twist_sine_0;
    float _S938;
    if(_S932)
    {
        _S938 = -1.0f;
    }
    else
    {
        _S938 = 1.0f;
    }
    float _S939 = _S937 * _S938;
    float _S940 = (kernelContext_64->families_0+_S936)->twist_cosine_0;
    if(_S934.shown_3.is_warp_0)
    {
        _S938 = 1.0f;
    }
    else
    {
        _S938 = -1.0f;
    }
    float2 _S941 = fibre_direction_0(_S934.slope_across_0, _S938 * _S934.slope_along_0, _S939, _S940);
    float _S942;
    if(_S934.shown_3.is_warp_0)
    {
        _S942 = _S934.slope_x_1;
    }
    else
    {
        _S942 = _S934.slope_y_1;
    }
    float _S943;
    if(_S934.shown_3.is_warp_0)
    {
        _S943 = _S934.slope_y_1;
    }
    else
    {
        _S943 = _S934.slope_x_1;
    }
    float _S944 = _S941.x;
    float _S945 = _S941.y;
    float _S946 = _S942 * _S944 + _S938 * _S943 * _S945;
    float _S947 = _S935 * 1.0154266357421875f;
    float _S948 = _S947 * arc_sine_0(clamp(_S934.section_1.across_3 / _S947, -1.0f, 1.0f));
    if(_S934.shown_3.is_warp_0)
    {
        _S935 = _S931;
    }
    else
    {
        _S935 = - _S930;
    }
    thread SurfacePoint_0 point_2;
    (&point_2)->hole_3 = _S934.shown_3.hole_1;
    (&point_2)->is_warp_1 = _S934.shown_3.is_warp_0;
    (&point_2)->warp_thread_0 = _S934.crossing_2.warp_4.thread_0;
    (&point_2)->weft_thread_0 = _S934.crossing_2.weft_4.thread_0;
    (&point_2)->height_3 = _S934.height_6;
    (&point_2)->normal_2 = normalize(float3(- _S934.slope_x_1, - _S934.slope_y_1, 1.0f));
    float3 _S949;
    if(_S934.shown_3.is_warp_0)
    {
        _S949 = float3(_S944, _S945, _S946);
    }
    else
    {
        _S949 = float3(- _S945, _S944, _S946);
    }
    (&point_2)->tangent_3 = normalize(_S949);
    (&point_2)->across_5 = _S934.section_1.across_3;
    (&point_2)->fibre_across_0 = _S948 * _S940 + _S935 * _S939;
    (&point_2)->fibre_along_0 = _S935 * _S940 - _S948 * _S939;
    return point_2;
}

bool has_hairs_0(uint _S950, KernelContext_0 thread* kernelContext_65)
{
    Fabric_0 device* _S951 = kernelContext_65->fabrics_0+_S950;
    bool _S952;
    if(((kernelContext_65->families_0+_S951->warp_0)->hairiness_0) > 0.0f)
    {
        _S952 = true;
    }
    else
    {
        _S952 = ((kernelContext_65->families_0+_S951->weft_0)->hairiness_0) > 0.0f;
    }
    return _S952;
}

Hair_0 hair_at_0(uint _S953, float2 _S954, bool _S955, float _S956, KernelContext_0 thread* kernelContext_66)
{
    Fabric_0 device* _S957 = kernelContext_66->fabrics_0+_S953;
    float _S958 = _S957->fibre_size_0;
    float _S959 = 17.0f * _S957->fibre_size_0;
    float _S960 = fade_0(_S956, _S959);
    float2 _S961 = _S954 / float2(_S959) ;
    uint number_4;
    if(_S955)
    {
        number_4 = 1U;
    }
    else
    {
        number_4 = 0U;
    }
    uint _S962 = hash_key_0(number_4, (_S957->seed_2) ^ 1013904242U);
    float _S963 = 1.0f / max(_S956, 0.07999999821186066f * _S958);
    float _S964 = min(0.63999998569488525f * _S958 * _S963, 1.0f);
    float2 _S965 = float2(0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2 hair_across_0 = _S965;
    number_4 = 0U;
    for(;;)
    {
        bool _S966;
        if(_S960 > 0.0f)
        {
            _S966 = number_4 < 18U;
        }
        else
        {
            _S966 = false;
        }
        if(_S966)
        {
        }
        else
        {
            break;
        }
        uint _S967 = number_4 / 9U;
        uint _S968 = number_4 / 3U - 3U * _S967;
        float2 _S969 = floor(_S961) + float2(float(number_4 - 3U * _S968 - 9U * _S967), float(_S968)) - float2(1.0f) ;
        uint _S970 = hash_bits_0(_S962 + _S967, uint(int(_S969.x)) * 65536U + uint(int(_S969.y)));
        uint _S971 = hash_bits_0(_S962, _S970);
        float2 _S972 = _S961 - _S969 - float2(share_of_0(_S970), share_of_0(_S970 >> 10U));
        float2 _S973 = sine_cosine_0(3.14159274101257324f * share_of_0(_S970 >> 20U));
        float _S974 = mix(5.0f, 16.0f, share_of_0(_S971 >> 10U)) / 17.0f;
        float _S975 = _S972.x;
        float _S976 = _S973.y;
        float _S977 = _S972.y;
        float _S978 = _S973.x;
        float _S979 = (_S975 * _S976 + _S977 * _S978) / _S974;
        float _S980 = 0.69999998807907104f * (2.0f * share_of_0(_S971 >> 20U) - 1.0f);
        float _S981 = 2.0f * _S980 * _S979;
        float _S982 = rsqrt(_S981 * _S981 + 1.0f);
        float _S983 = (_S977 * _S976 - _S975 * _S978 - _S980 * _S974 * _S979 * _S979) * _S982 * 17.0f;
        float _S984 = clamp((0.31999999284744263f - abs(_S983)) * _S958 * _S963 + 0.5f, 0.0f, _S964);
        uint _S985;
        if(((_S971 >> 30U) & 1U) == 1U)
        {
            _S985 = _S957->warp_0;
        }
        else
        {
            _S985 = _S957->weft_0;
        }
        bool _S986;
        if((share_of_0(_S971)) < ((kernelContext_66->families_0+_S985)->hairiness_0))
        {
            _S986 = (abs(_S979)) < 1.0f;
        }
        else
        {
            _S986 = false;
        }
        bool _S987;
        if(_S986)
        {
            _S987 = _S984 > cover_2;
        }
        else
        {
            _S987 = false;
        }
        if(_S987)
        {
            float2 _S988 = float2(- _S978 - _S981 * _S976, _S976 - _S981 * _S978) * float2(_S982) ;
            cover_2 = _S984;
            hair_away_0 = _S983;
            hair_across_0 = _S988;
        }
        number_4 = number_4 + 1U;
    }
    float _S989 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    thread Hair_0 hair_1;
    (&hair_1)->cover_0 = _S960 * cover_2;
    (&hair_1)->normal_0 = float3(float2(_S989)  * hair_across_0, sqrt(1.0f - _S989 * _S989));
    (&hair_1)->tangent_1 = float3(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

bool varies_at_0(uint _S990, float _S991, KernelContext_0 thread* kernelContext_67)
{
    Fabric_0 device* _S992 = kernelContext_67->fabrics_0+_S990;
    bool _S993;
    if((_S992->fibre_noise_0) > 0.0f)
    {
        _S993 = true;
    }
    else
    {
        _S993 = (_S992->colour_noise_0) > 0.0f;
    }
    if(_S993)
    {
        _S993 = true;
    }
    else
    {
        if((_S992->has_detail_0) != 0U)
        {
            _S993 = _S991 >= 0.0f;
        }
        else
        {
            _S993 = false;
        }
    }
    return _S993;
}

uint thread_number_0(uint _S994, const SurfacePoint_0 thread* _S995, float _S996, float _S997, KernelContext_0 thread* kernelContext_68)
{
    Fabric_0 device* _S998 = kernelContext_68->fabrics_0+_S994;
    bool _S999 = _S995->is_warp_1;
    float _S1000;
    if(_S995->is_warp_1)
    {
        _S1000 = _S996;
    }
    else
    {
        _S1000 = _S997;
    }
    float _S1001 = _S1000 - _S995->across_5;
    uint _S1002;
    if(_S999)
    {
        _S1002 = _S998->warp_0;
    }
    else
    {
        _S1002 = _S998->weft_0;
    }
    float _S1003 = (kernelContext_68->families_0+_S1002)->period_0;
    int _S1004 = int((kernelContext_68->families_0+_S1002)->count_0);
    if(_S999)
    {
        _S1002 = _S995->warp_thread_0;
    }
    else
    {
        _S1002 = _S995->weft_thread_0;
    }
    uint _S1005 = uint(int(floor(_S1001 / _S1003)) * _S1004 + int(_S1002)) * 2U;
    if(_S999)
    {
        _S1002 = 1U;
    }
    else
    {
        _S1002 = 0U;
    }
    return _S1005 + _S1002;
}

struct FibreNoise_0
{
    float2 bundle_0;
    float bundle_weight_0;
    float2 fibre_0;
    float fibre_weight_0;
    float offset_4;
    float slope_2;
};

FibreNoise_0 fibre_noise_at_0(uint _S1006, uint _S1007, const SurfacePoint_0 thread* _S1008, uint _S1009, float _S1010, KernelContext_0 thread* kernelContext_69)
{
    Fabric_0 device* _S1011 = kernelContext_69->fabrics_0+_S1006;
    float _S1012 = 5.0f * _S1011->fibre_size_0;
    float2 _S1013 = wave_noise_0(hash_key_0(_S1009, (_S1011->seed_2) ^ 458671337U), _S1008->fibre_along_0 / (25.0f * _S1011->fibre_size_0));
    float _S1014 = _S1008->fibre_across_0 + (kernelContext_69->families_0+_S1007)->fibre_tilt_0 * 0.5f * 25.0f * _S1011->fibre_size_0 * _S1013.x;
    float3 _S1015 = fibre_cell_0(_S1014, _S1008->fibre_along_0, _S1011->fibre_size_0);
    thread FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S1009, (_S1011->seed_2) ^ 1757159915U), fibre_cell_0(_S1014, _S1008->fibre_along_0, _S1012));
    (&noise_0)->bundle_weight_0 = fade_0(_S1010, _S1012);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S1009, (_S1011->seed_2) ^ 48610963U), _S1015);
    (&noise_0)->fibre_weight_0 = fade_0(_S1010, _S1011->fibre_size_0);
    (&noise_0)->offset_4 = _S1015.z;
    (&noise_0)->slope_2 = 0.5f * _S1013.y;
    return noise_0;
}

float2 detail_gain_0(uint _S1016, uint _S1017, const SurfacePoint_0 thread* _S1018, float2 _S1019, bool _S1020, uint _S1021, float _S1022, KernelContext_0 thread* kernelContext_70)
{
    Fabric_0 device* _S1023 = kernelContext_70->fabrics_0+_S1016;
    float2 _S1024 = float2(0.0f) ;
    float2 gain_1;
    if(((kernelContext_70->families_0+_S1017)->has_plies_0) > 0.0f)
    {
        float _S1025 = 0.60000002384185791f * fade_0(_S1022, 1.0f / (kernelContext_70->families_0+_S1017)->plies_per_mm_0);
        float _S1026 = ply_offset_0(_S1017, _S1018, _S1020, kernelContext_70);
        gain_1 = float2(_S1025)  * float2(0.20000000298023224f - square_1(square_1(_S1026)), 0.20000000298023224f);
    }
    else
    {
        gain_1 = _S1024;
    }
    if(((kernelContext_70->families_0+_S1017)->fibre_tone_0) > 0.0f)
    {
        FibreNoise_0 _S1027 = fibre_noise_at_0(_S1016, _S1017, _S1018, _S1021, _S1022, kernelContext_70);
        gain_1 = gain_1 + float2((kernelContext_70->families_0+_S1017)->fibre_tone_0)  * float2(_S1027.bundle_weight_0 * _S1027.bundle_0.y + _S1027.fibre_weight_0 * _S1027.fibre_0.y, _S1027.bundle_weight_0 + _S1027.fibre_weight_0);
    }
    if(((kernelContext_70->families_0+_S1017)->slub_0) > 0.0f)
    {
        float _S1028 = 0.25f * (kernelContext_70->families_0+_S1017)->slub_0 * fade_0(_S1022, 1.0f / (kernelContext_70->families_0+_S1017)->slubs_per_mm_0);
        float _S1029;
        if(_S1018->is_warp_1)
        {
            _S1029 = _S1019.y;
        }
        else
        {
            _S1029 = - _S1019.x;
        }
        gain_1 = gain_1 + float2(_S1028)  * float2(wave_noise_0(hash_key_0(_S1021, (_S1023->seed_2) ^ 1373058189U), _S1029 * (kernelContext_70->families_0+_S1017)->slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S1018->across_5 * (kernelContext_70->families_0+_S1017)->per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_1;
}

Albedos_0 vary_albedos_0(uint _S1030, const Albedos_0 thread* _S1031, uint _S1032, uint _S1033, float2 _S1034, KernelContext_0 thread* kernelContext_71)
{
    Fabric_0 device* _S1035 = kernelContext_71->fabrics_0+_S1030;
    float3 _S1036 = max(_S1031->specular_reflect_0, _S1031->specular_transmit_0);
    float3 _S1037 = _S1031->diffuse_reflect_0 + _S1031->diffuse_transmit_0;
    float3 _S1038 = float3(_S1035->layer_bound_0) ;
    float3 _S1039 = float3(1.0f) ;
    float3 _S1040 = _S1039 - _S1038 * _S1036;
    float colour_0 = bounded_gain_0(thread_gain_0(_S1032, _S1035->colour_noise_0, _S1035->seed_2), _S1037, _S1040);
    float3 _S1041 = float3((colour_0 * (1.0f + flattened_0(_S1034.y, float3(colour_0)  * _S1037, _S1040) * _S1034.x))) ;
    float _S1042 = bounded_gain_0(fibre_gain_0(_S1032, _S1033, _S1035->fibre_noise_0, _S1035->seed_2), _S1036, min((_S1039 - _S1041 * _S1037) / _S1038, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S1041 * _S1031->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S1041 * _S1031->diffuse_transmit_0;
    float3 _S1043 = float3(_S1042) ;
    (&varied_0)->specular_reflect_0 = _S1043 * _S1031->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S1043 * _S1031->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S1044, const SurfacePoint_0 thread* _S1045, const Albedos_0 thread* _S1046, float _S1047, float _S1048, bool _S1049, float _S1050, float _S1051, KernelContext_0 thread* kernelContext_72)
{
    Fabric_0 device* _S1052 = kernelContext_72->fabrics_0+_S1044;
    uint _S1053 = thread_number_0(_S1044, _S1045, _S1047, _S1048, kernelContext_72);
    float3 _S1054 = fibre_cell_0(_S1045->fibre_across_0, _S1045->fibre_along_0, _S1052->fibre_size_0);
    float2 _S1055 = float2(0.0f) ;
    bool _S1056;
    if((_S1052->has_detail_0) != 0U)
    {
        _S1056 = _S1050 >= 0.0f;
    }
    else
    {
        _S1056 = false;
    }
    float2 gain_2;
    if(_S1056)
    {
        uint _S1057;
        if(_S1045->is_warp_1)
        {
            _S1057 = _S1052->warp_0;
        }
        else
        {
            _S1057 = _S1052->weft_0;
        }
        float2 _S1058 = detail_gain_0(_S1044, _S1057, _S1045, float2(_S1047, _S1048), _S1049, _S1053, _S1050, kernelContext_72);
        gain_2 = _S1058 * float2(1.0f - _S1051, 1.0f);
    }
    else
    {
        gain_2 = _S1055;
    }
    Albedos_0 _S1059 = vary_albedos_0(_S1044, _S1046, _S1053, uint(int(_S1054.x)) * 65536U + uint(int(floor(_S1054.y))), gain_2, kernelContext_72);
    return _S1059;
}

YarnFrame_0 turned_frame_0(uint _S1060, uint _S1061, const SurfacePoint_0 thread* _S1062, bool _S1063, uint _S1064, float _S1065, KernelContext_0 thread* kernelContext_73)
{
    thread YarnFrame_0 frame_2;
    (&frame_2)->normal_3 = _S1062->normal_2;
    (&frame_2)->tangent_4 = _S1062->tangent_3;
    (&frame_2)->loss_0 = 0.0f;
    if(((kernelContext_73->families_0+_S1061)->has_plies_0) > 0.0f)
    {
        float _S1066 = fade_0(_S1065, 1.0f / (kernelContext_73->families_0+_S1061)->plies_per_mm_0);
        float _S1067 = _S1066 * 0.41999998688697815f;
        float _S1068 = ply_offset_0(_S1061, _S1062, _S1063, kernelContext_73);
        float _S1069 = _S1067 * _S1068;
        float _S1070 = sqrt(1.0f - _S1069 * _S1069);
        float _S1071;
        if(_S1063)
        {
            _S1071 = - (kernelContext_73->families_0+_S1061)->ply_sine_0;
        }
        else
        {
            _S1071 = (kernelContext_73->families_0+_S1061)->ply_sine_0;
        }
        float3 _S1072 = cross((&frame_2)->tangent_4, (&frame_2)->normal_3);
        float3 _S1073 = float3((kernelContext_73->families_0+_S1061)->ply_cosine_0) ;
        float3 _S1074 = _S1073 * _S1072 + float3(_S1071)  * (&frame_2)->tangent_4;
        float3 _S1075 = float3(_S1070) ;
        float3 _S1076 = float3(_S1069) ;
        (&frame_2)->tangent_4 = _S1073 * (_S1073 * (&frame_2)->tangent_4 - float3(_S1071)  * _S1072) + float3(_S1071)  * (_S1075 * _S1074 - _S1076 * (&frame_2)->normal_3);
        (&frame_2)->normal_3 = _S1075 * (&frame_2)->normal_3 + _S1076 * _S1074;
        (&frame_2)->loss_0 = _S1066 * _S1066 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S1077 = (kernelContext_73->families_0+_S1061)->fibre_tilt_0;
    if(((kernelContext_73->families_0+_S1061)->fibre_tilt_0) > 0.0f)
    {
        FibreNoise_0 _S1078 = fibre_noise_at_0(_S1060, _S1061, _S1062, _S1064, _S1065, kernelContext_73);
        float _S1079 = 1.09858846664428711f * _S1077 * (_S1078.bundle_weight_0 * _S1078.bundle_0.x + _S1078.fibre_weight_0 * (_S1078.fibre_0.x + _S1078.offset_4));
        float _S1080 = _S1077 * (1.42099642753601074f * (_S1078.bundle_weight_0 * _S1078.bundle_0.y + _S1078.fibre_weight_0 * _S1078.fibre_0.y) - _S1078.bundle_weight_0 * _S1078.slope_2);
        float _S1081 = square_1(_S1078.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S1077 * _S1077 * ((0.24761904776096344f * (square_1(_S1078.bundle_weight_0) + _S1081) + _S1081 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3 _S1082 = cross((&frame_2)->tangent_4, (&frame_2)->normal_3);
        float2 _S1083 = sine_cosine_0(_S1079);
        float2 _S1084 = sine_cosine_0(_S1080);
        float3 _S1085 = float3(_S1083.y) ;
        float3 _S1086 = float3(_S1083.x) ;
        float3 _S1087 = _S1085 * _S1082 - _S1086 * (&frame_2)->normal_3;
        (&frame_2)->normal_3 = _S1085 * (&frame_2)->normal_3 + _S1086 * _S1082;
        (&frame_2)->tangent_4 = float3(_S1084.y)  * (&frame_2)->tangent_4 + float3(_S1084.x)  * _S1087;
    }
    return frame_2;
}

YarnPoint_0 yarn_point_of_0(uint _S1088, const SurfacePoint_0 thread* _S1089, float _S1090, float _S1091, bool _S1092, bool _S1093, float _S1094, KernelContext_0 thread* kernelContext_74)
{
    Fabric_0 device* _S1095 = kernelContext_74->fabrics_0+_S1088;
    bool _S1096 = _S1089->is_warp_1;
    uint _S1097;
    if(_S1089->is_warp_1)
    {
        _S1097 = _S1095->warp_0;
    }
    else
    {
        _S1097 = _S1095->weft_0;
    }
    bool _S1098;
    if((_S1095->has_detail_0) != 0U)
    {
        _S1098 = _S1094 >= 0.0f;
    }
    else
    {
        _S1098 = false;
    }
    float3 _S1099 = float3(0.0f) ;
    Hair_0 _S1100 = Hair_x24init_0(0.0f, _S1099, _S1099);
    bool _S1101;
    if(_S1098)
    {
        bool _S1102 = has_hairs_0(_S1088, kernelContext_74);
        _S1101 = _S1102;
    }
    else
    {
        _S1101 = false;
    }
    Hair_0 hair_2;
    if(_S1101)
    {
        Hair_0 _S1103 = hair_at_0(_S1088, float2(_S1090, _S1091), _S1092, _S1094, kernelContext_74);
        hair_2 = _S1103;
    }
    else
    {
        hair_2 = _S1100;
    }
    uint _S1104;
    if(_S1096)
    {
        _S1104 = _S1089->warp_thread_0;
    }
    else
    {
        _S1104 = _S1089->weft_thread_0;
    }
    Albedos_0 _S1105 = albedos_of_0(_S1097, _S1104, kernelContext_74);
    bool _S1106 = varies_at_0(_S1088, _S1094, kernelContext_74);
    Albedos_0 albedos_8;
    if(_S1106)
    {
        thread Albedos_0 _S1107 = _S1105;
        Albedos_0 _S1108 = varied_at_0(_S1088, _S1089, &_S1107, _S1090, _S1091, _S1092, _S1094, hair_2.cover_0, kernelContext_74);
        albedos_8 = _S1108;
    }
    else
    {
        albedos_8 = _S1105;
    }
    thread YarnPoint_0 point_3;
    (&point_3)->back_8 = _S1092;
    (&point_3)->hole_4 = _S1093;
    (&point_3)->is_warp_2 = _S1096;
    (&point_3)->x_9 = _S1090;
    (&point_3)->y_4 = _S1091;
    (&point_3)->height_4 = _S1089->height_3;
    (&point_3)->normal_7 = _S1089->normal_2;
    (&point_3)->tangent_8 = _S1089->tangent_3;
    (&point_3)->surface_normal_0 = _S1089->normal_2;
    (&point_3)->diffuse_gain_1 = 1.0f;
    if(_S1098)
    {
        uint _S1109 = thread_number_0(_S1088, _S1089, _S1090, _S1091, kernelContext_74);
        YarnFrame_0 _S1110 = turned_frame_0(_S1088, _S1097, _S1089, _S1092, _S1109, _S1094, kernelContext_74);
        bool _S1111 = has_hairs_0(_S1088, kernelContext_74);
        YarnFrame_0 frame_3;
        if(_S1111)
        {
            thread YarnFrame_0 _S1112 = _S1110;
            thread Hair_0 _S1113 = hair_2;
            YarnFrame_0 _S1114 = under_hair_0(&_S1112, &_S1113);
            frame_3 = _S1114;
        }
        else
        {
            frame_3 = _S1110;
        }
        (&point_3)->normal_7 = frame_3.normal_3;
        (&point_3)->tangent_8 = frame_3.tangent_4;
        thread YarnFrame_0 _S1115 = frame_3;
        float _S1116 = diffuse_gain_0(&_S1115, _S1095->diffuse_blend_0);
        (&point_3)->diffuse_gain_1 = _S1116;
    }
    (&point_3)->roughness_8 = (kernelContext_74->families_0+_S1097)->roughness_0;
    (&point_3)->albedos_7 = albedos_8;
    return point_3;
}

YarnPoint_0 locate_yarn_0(uint _S1117, const SearchQuality_0 thread* _S1118, float _S1119, float _S1120, float3 _S1121, float _S1122, KernelContext_0 thread* kernelContext_75)
{
    bool _S1123 = (_S1121.z) < 0.0f;
    Hit_0 _S1124 = first_hit_0(_S1117, _S1118, _S1119, _S1120, to_face_frame_0(_S1121, _S1123), _S1123, kernelContext_75);
    SurfacePoint_0 _S1125 = surface_at_0(_S1117, _S1124.x_10, _S1124.y_5, _S1123, kernelContext_75);
    thread SurfacePoint_0 _S1126 = _S1125;
    YarnPoint_0 _S1127 = yarn_point_of_0(_S1117, &_S1126, _S1124.x_10, _S1124.y_5, _S1123, _S1124.hole_5, _S1122, kernelContext_75);
    return _S1127;
}

YarnPoint_0 locate_yarn_1(uint _S1128, const SearchQuality_0 thread* _S1129, float _S1130, float _S1131, float3 _S1132, KernelContext_0 thread* kernelContext_76)
{
    YarnPoint_0 _S1133 = locate_yarn_0(_S1128, _S1129, _S1130, _S1131, _S1132, -1.0f, kernelContext_76);
    return _S1133;
}

ResidualPoint_0 residual_point_0(uint _S1134, const ViewedBase_0 thread* _S1135, float3 _S1136, uint _S1137, uint _S1138, KernelContext_0 thread* kernelContext_77)
{
    Fabric_0 device* _S1139 = kernelContext_77->fabrics_0+_S1134;
    uint _S1140 = _S1137 + _S1138 * 1663821227U;
    float2 _S1141 = float2(uniform_of_0(_S1140, 1U), uniform_of_0(_S1140, 2U));
    float2 _S1142 = (&_S1135->box_2)->corner_1 + _S1141 * (&_S1135->box_2)->size_2;
    thread ResidualPoint_0 result_3;
    float _S1143 = _S1142.x;
    float _S1144 = _S1142.y;
    thread SearchQuality_0 _S1145 = default_quality_0();
    YarnPoint_0 _S1146 = locate_yarn_1(_S1134, &_S1145, _S1143, _S1144, _S1136, kernelContext_77);
    (&result_3)->point_1 = _S1146;
    thread Clustered_0 _S1147 = _S1139->clustered_0;
    uint _S1148 = texel_of_0(&_S1147, &_S1135->box_2, _S1141);
    (&result_3)->texel_0 = _S1148;
    return result_3;
}

Components_0 clustered_at_texel_0(uint _S1149, const ViewedBase_0 thread* _S1150, uint _S1151, const BaseTaps_0 thread* _S1152, KernelContext_0 thread* kernelContext_78)
{
    Clustered_0 _S1153 = (kernelContext_78->fabrics_0+_S1149)->clustered_0;
    uint _S1154 = _S1150->face_1 * (kernelContext_78->fabrics_0+_S1149)->clustered_0.columns_0 * (kernelContext_78->fabrics_0+_S1149)->clustered_0.rows_0 + _S1151;
    uint _S1155 = table_byte_0((kernelContext_78->fabrics_0+_S1149)->clustered_0.labels_0, _S1154, kernelContext_78);
    Components_0 base_2 = no_components_0();
    if(_S1155 >= (_S1153.clusters_0))
    {
        return base_2;
    }
    float _S1156 = cluster_density_0(_S1149, _S1150, _S1152, _S1155, 0U, kernelContext_78);
    uint number_5 = 1U;
    float density_2 = _S1156;
    for(;;)
    {
        if(number_5 <= (_S1153.rank_0))
        {
        }
        else
        {
            break;
        }
        uint _S1157 = table_byte_0(_S1153.coefficients_0, _S1154 * _S1153.rank_0 + number_5 - 1U, kernelContext_78);
        int _S1158 = int(_S1157);
        int _S1159;
        if(_S1158 > int(127))
        {
            _S1159 = _S1158 - int(256);
        }
        else
        {
            _S1159 = _S1158;
        }
        float _S1160 = float(_S1159);
        float _S1161 = cluster_density_0(_S1149, _S1150, _S1152, _S1155, number_5, kernelContext_78);
        float density_3 = density_2 + _S1160 * _S1161;
        number_5 = number_5 + 1U;
        density_2 = density_3;
    }
    ClusterTerms_0 _S1162 = cluster_terms_0(_S1149, _S1150, _S1152, _S1155, kernelContext_78);
    thread Components_0 _S1163 = base_2;
    thread ClusterTerms_0 _S1164 = _S1162;
    Components_0 _S1165 = with_cluster_0(_S1149, &_S1163, &_S1164, _S1155, 1.0f, density_2, kernelContext_78);
    return _S1165;
}

bool unoccluded_0(uint _S1166, const SearchQuality_0 thread* _S1167, float _S1168, float _S1169, float _S1170, float3 _S1171, bool _S1172, KernelContext_0 thread* kernelContext_79)
{
    Fabric_0 device* _S1173 = kernelContext_79->fabrics_0+_S1166;
    if((_S1171.z) <= 0.0f)
    {
        return false;
    }
    float _S1174 = max_height_along_0(_S1166, _S1168, _S1169, _S1170, _S1171, _S1172, kernelContext_79);
    bool _S1175 = is_free_0(_S1166, _S1167, float3(_S1168, _S1169, _S1170 + _S1173->lift_0), _S1171, _S1172, _S1174, kernelContext_79);
    return _S1175;
}

bool is_lit_0(uint _S1176, const SearchQuality_0 thread* _S1177, const YarnPoint_0 thread* _S1178, float3 _S1179, KernelContext_0 thread* kernelContext_80)
{
    if(_S1178->hole_4)
    {
        return true;
    }
    bool _S1180 = _S1178->back_8;
    float3 _S1181 = to_face_frame_0(_S1179, _S1178->back_8);
    float _S1182 = _S1181.z;
    bool _S1183 = _S1182 < 0.0f;
    float3 _S1184 = _S1178->surface_normal_0;
    float _S1185 = _S1178->height_4;
    float3 normal_8;
    float height_10;
    if(_S1183)
    {
        SurfacePoint_0 _S1186 = surface_at_0(_S1176, _S1178->x_9, _S1178->y_4, !_S1180, kernelContext_80);
        normal_8 = _S1186.normal_2;
        height_10 = _S1186.height_3;
    }
    else
    {
        normal_8 = _S1184;
        height_10 = _S1185;
    }
    float3 _S1187 = float3(_S1181.xy, abs(_S1182));
    if((dot(normal_8, _S1187)) <= 0.0f)
    {
        return false;
    }
    bool _S1188 = unoccluded_0(_S1176, _S1177, _S1178->x_9, _S1178->y_4, height_10, _S1187, _S1180 != _S1183, kernelContext_80);
    return _S1188;
}

Components_0 components_of_point_0(uint _S1189, const SearchQuality_0 thread* _S1190, const YarnPoint_0 thread* _S1191, float3 _S1192, float3 _S1193, KernelContext_0 thread* kernelContext_81)
{
    Fabric_0 device* _S1194 = kernelContext_81->fabrics_0+_S1189;
    thread Components_0 result_4 = no_components_0();
    bool _S1195 = _S1191->hole_4;
    float _S1196;
    if(_S1191->hole_4)
    {
        _S1196 = 1.0f;
    }
    else
    {
        _S1196 = 0.0f;
    }
    (&result_4)->hole_0 = _S1196;
    bool _S1197;
    if(_S1195)
    {
        _S1197 = true;
    }
    else
    {
        bool _S1198 = is_lit_0(_S1189, _S1190, _S1191, _S1192, kernelContext_81);
        _S1197 = !_S1198;
    }
    if(_S1197)
    {
        return result_4;
    }
    float3 _S1199 = to_face_frame_0(_S1192, _S1191->back_8);
    float3 _S1200 = to_face_frame_0(_S1193, _S1191->back_8);
    float _S1201 = _S1191->diffuse_gain_1;
    bool _S1202 = (_S1199.z) < 0.0f;
    float3 _S1203;
    if(_S1202)
    {
        _S1203 = - _S1199;
    }
    else
    {
        _S1203 = _S1199;
    }
    float3 _S1204 = _S1191->normal_7;
    float _S1205 = _S1201 * diffuse_reflection_0(_S1203, _S1191->normal_7, _S1194->diffuse_blend_0);
    if(_S1202)
    {
        _S1196 = transmission_1(_S1199, _S1200, _S1204, _S1191->tangent_8, _S1191->roughness_8, _S1194->optical_depth_0);
    }
    else
    {
        _S1196 = reflection_0(_S1199, _S1200, _S1204, _S1191->tangent_8, _S1191->roughness_8, _S1194->optical_depth_0);
    }
    bool _S1206 = _S1191->is_warp_2;
    float _S1207;
    if(_S1191->is_warp_2)
    {
        _S1207 = _S1205;
    }
    else
    {
        _S1207 = 0.0f;
    }
    (&result_4)->diffuse_warp_0 = _S1207;
    if(_S1206)
    {
        _S1207 = 0.0f;
    }
    else
    {
        _S1207 = _S1205;
    }
    (&result_4)->diffuse_weft_0 = _S1207;
    if(_S1206)
    {
        _S1207 = _S1196;
    }
    else
    {
        _S1207 = 0.0f;
    }
    (&result_4)->specular_warp_0 = _S1207;
    if(_S1206)
    {
        _S1196 = 0.0f;
    }
    (&result_4)->specular_weft_0 = _S1196;
    (&result_4)->light_visibility_1 = 1.0f;
    return result_4;
}

float3 clustered_residual_0(uint _S1208, const ClusteredView_0 thread* _S1209, const ResidualPoint_0 thread* _S1210, float3 _S1211, float3 _S1212, KernelContext_0 thread* kernelContext_82)
{
    BaseTaps_0 _S1213 = base_taps_0(&_S1209->base_0, _S1212);
    thread BaseTaps_0 _S1214 = _S1213;
    Components_0 _S1215 = clustered_at_texel_0(_S1208, &_S1209->base_0, _S1210->texel_0, &_S1214, kernelContext_82);
    float3 _S1216 = _S1209->view_10;
    thread SearchQuality_0 _S1217 = default_quality_0();
    Components_0 _S1218 = components_of_point_0(_S1208, &_S1217, &_S1210->point_1, _S1212, _S1209->view_10, kernelContext_82);
    thread FamilyAlbedos_0 own_2;
    Albedos_0 _S1219 = tinted_0(&(&_S1210->point_1)->albedos_7, _S1211);
    (&own_2)->warp_3 = _S1219;
    (&own_2)->weft_3 = _S1219;
    thread Components_0 _S1220 = _S1218;
    thread FamilyAlbedos_0 _S1221 = own_2;
    float3 _S1222 = shaded_0(&_S1220, &_S1221, _S1213.transmits_1);
    thread Components_0 _S1223 = _S1215;
    float3 _S1224 = shaded_0(&_S1223, &_S1209->albedos_5, _S1213.transmits_1);
    float3 _S1225 = _S1222 - _S1224;
    float3 _S1226 = bounced_value_0(&_S1209->bounced_2, _S1212, _S1216);
    float3 _S1227 = under_sheen_0(_S1208, _S1209, _S1225 - float3(_S1218.hole_0)  * _S1226, _S1218.light_visibility_1 + _S1218.hole_0 - _S1215.light_visibility_1, _S1212, kernelContext_82);
    return _S1227;
}

float passed_by_sheen_0(uint _S1228, float _S1229, float3 _S1230, KernelContext_0 thread* kernelContext_83)
{
    Fabric_0 device* _S1231 = kernelContext_83->fabrics_0+_S1228;
    float _S1232 = _S1231->sheen_strength_0;
    if((_S1231->sheen_strength_0) <= 0.0f)
    {
        return _S1229;
    }
    return _S1229 * (1.0f - _S1232 * sheen_lobe_0(abs(_S1230.z), _S1231->sheen_roughness_0).z);
}

float4 clustered_value_0(uint _S1233, const Footprint_0 thread* _S1234, float3 _S1235, float3 _S1236, uint _S1237, uint _S1238, KernelContext_0 thread* kernelContext_84)
{
    float3 _S1239 = float3(1.0f) ;
    bool _S1240 = _S1238 == 0U;
    ClusteredView_0 _S1241 = clustered_view_0(_S1233, _S1234, _S1236, _S1239, _S1237, _S1240, kernelContext_84);
    float hole_6;
    if(_S1240)
    {
        thread ViewedBase_0 _S1242 = _S1241.base_0;
        float _S1243 = clustered_hole_0(_S1233, &_S1242, kernelContext_84);
        hole_6 = _S1243;
    }
    else
    {
        hole_6 = 0.0f;
    }
    thread ClusteredView_0 _S1244 = _S1241;
    float3 _S1245 = clustered_base_value_0(_S1233, &_S1244, hole_6, _S1235, kernelContext_84);
    uint number_6 = 0U;
    float3 value_1 = _S1245;
    for(;;)
    {
        if(number_6 < _S1238)
        {
        }
        else
        {
            break;
        }
        thread ViewedBase_0 _S1246 = _S1241.base_0;
        ResidualPoint_0 _S1247 = residual_point_0(_S1233, &_S1246, _S1236, _S1237, number_6, kernelContext_84);
        thread ClusteredView_0 _S1248 = _S1241;
        thread ResidualPoint_0 _S1249 = _S1247;
        float3 _S1250 = clustered_residual_0(_S1233, &_S1248, &_S1249, _S1239, _S1235, kernelContext_84);
        float _S1251 = float(_S1238);
        float3 value_2 = value_1 + _S1250 / float3(_S1251) ;
        float _S1252;
        if(_S1247.point_1.hole_4)
        {
            _S1252 = 1.0f;
        }
        else
        {
            _S1252 = 0.0f;
        }
        float hole_7 = hole_6 + _S1252 / _S1251;
        number_6 = number_6 + 1U;
        value_1 = value_2;
        hole_6 = hole_7;
    }
    float _S1253 = passed_by_sheen_0(_S1233, hole_6, _S1236, kernelContext_84);
    return float4(value_1, _S1253);
}

float4 cloth_value_0(uint fabric_1, float2 centre_3, float2 dx_2, float2 dy_2, float3 light_9, float3 view_11, KernelContext_0 thread* kernelContext_85)
{
    Footprint_0 _S1254 = footprint_of_0(centre_3, dx_2, dy_2);
    float2 _S1255 = float2((kernelContext_85->fabrics_0+fabric_1)->clustered_0.texel_width_0 * float((kernelContext_85->fabrics_0+fabric_1)->clustered_0.columns_0), (kernelContext_85->fabrics_0+fabric_1)->clustered_0.texel_height_0 * float((kernelContext_85->fabrics_0+fabric_1)->clustered_0.rows_0));
    thread Footprint_0 _S1256 = _S1254;
    uint _S1257 = hashed_0(&_S1256, view_11, _S1255);
    thread Footprint_0 _S1258 = _S1254;
    float4 _S1259 = clustered_value_0(fabric_1, &_S1258, light_9, view_11, _S1257, 0U, kernelContext_85);
    return _S1259;
}

float4 cloth_estimate_0(uint fabric_2, float2 centre_4, float2 dx_3, float2 dy_3, float3 light_10, float3 view_12, uint seed_5, KernelContext_0 thread* kernelContext_86)
{
    uint _S1260 = max((kernelContext_86->fabrics_0+fabric_2)->clustered_0.samples_0, 1U);
    uint _S1261 = mixed_0(seed_5);
    thread Footprint_0 _S1262 = footprint_of_0(centre_4, dx_3, dy_3);
    float4 _S1263 = clustered_value_0(fabric_2, &_S1262, light_10, view_12, _S1261, _S1260, kernelContext_86);
    return _S1263;
}

[[kernel]] void clustered_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* words_1 [[buffer(2)]], Family_0 device* families_1 [[buffer(1)]])
{
    thread KernelContext_0 kernelContext_87;
    (&kernelContext_87)->query_count_0 = query_count_1;
    (&kernelContext_87)->queries_0 = queries_1;
    (&kernelContext_87)->answers_0 = answers_1;
    (&kernelContext_87)->fabrics_0 = fabrics_1;
    (&kernelContext_87)->words_0 = words_1;
    (&kernelContext_87)->families_0 = families_1;
    uint _S1264 = id_0.x;
    if(_S1264 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S1265 = (&kernelContext_87)->queries_0[_S1264];
    float2 _S1266 = float2(_S1265.centre_x_0, _S1265.centre_y_0);
    float2 _S1267 = float2(_S1265.dx_x_0, _S1265.dx_y_0);
    float2 _S1268 = float2(_S1265.dy_x_0, _S1265.dy_y_0);
    float3 _S1269 = float3(_S1265.light_x_0, _S1265.light_y_0, _S1265.light_z_0);
    float3 _S1270 = float3(_S1265.view_x_0, _S1265.view_y_0, _S1265.view_z_0);
    if((_S1265.seed_1) == 0U)
    {
        packed_float4 device* _S1271 = (&kernelContext_87)->answers_0+_S1264;
        float4 _S1272 = cloth_value_0(_S1265.fabric_0, _S1266, _S1267, _S1268, _S1269, _S1270, &kernelContext_87);
        *_S1271 = packed_float4(_S1272) ;
    }
    else
    {
        packed_float4 device* _S1273 = (&kernelContext_87)->answers_0+_S1264;
        float4 _S1274 = cloth_estimate_0(_S1265.fabric_0, _S1266, _S1267, _S1268, _S1269, _S1270, _S1265.seed_1, &kernelContext_87);
        *_S1273 = packed_float4(_S1274) ;
    }
    return;
}

