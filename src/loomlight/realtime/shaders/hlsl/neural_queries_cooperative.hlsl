#pragma pack_matrix(column_major)
#ifdef SLANG_HLSL_ENABLE_NVAPI
#include "nvHLSLExtns.h"
#endif

#ifndef __DXC_VERSION_MAJOR
// warning X3557: loop doesn't seem to do anything, forcing loop to unroll
#pragma warning(disable : 3557)
#endif

#include "dx/linalg.h"

template<
    typename OutElTy,
    dx::linalg::DataType MatDT,
    uint MatM,
    uint MatK,
    dx::linalg::MatrixLayout MatML,
    bool MatTranspose,
    dx::linalg::DataType InputDT,
    uint InputVecDim,
    typename BufTy,
    typename InElTy,
    bool OutputIsUnsigned,
    bool InputIsUnsigned>
vector<OutElTy, MatM> __slang_linalg_Mul(
    BufTy matBuf,
    uint matOff,
    uint matStr,
    vector<InElTy, InputVecDim> input)
{
    vector<OutElTy, MatM> __slang_r = (vector<OutElTy, MatM>)0;
    __builtin_MatVecMul(__slang_r, OutputIsUnsigned, input, InputIsUnsigned, InputDT, matBuf, matOff,
        MatDT, MatM, MatK, MatML, MatTranspose, matStr);
    return __slang_r;
}

template<
    typename OutElTy,
    dx::linalg::DataType MatDT,
    uint MatM,
    uint MatK,
    dx::linalg::MatrixLayout MatML,
    bool MatTranspose,
    dx::linalg::DataType InputDT,
    uint InputVecDim,
    dx::linalg::DataType BiasDT,
    typename MatBufTy,
    typename BiasBufTy,
    typename InElTy,
    bool OutputIsUnsigned,
    bool InputIsUnsigned>
vector<OutElTy, MatM> __slang_linalg_MulAdd(
    MatBufTy matBuf,
    uint matOff,
    uint matStr,
    BiasBufTy biasBuf,
    uint biasOff,
    vector<InElTy, InputVecDim> input)
{
    vector<OutElTy, MatM> __slang_r = (vector<OutElTy, MatM>)0;
    __builtin_MatVecMulAdd(__slang_r, OutputIsUnsigned, input, InputIsUnsigned, InputDT, matBuf,
        matOff, MatDT, MatM, MatK, MatML, MatTranspose, matStr, biasBuf, biasOff, BiasDT);
    return __slang_r;
}

template<typename ElTy, dx::linalg::DataType MatDT, uint MatM, uint MatN, dx::linalg::MatrixLayout MatML, typename BufTy>
void __slang_linalg_OuterProductAccumulate(
    vector<ElTy, MatM> a,
    vector<ElTy, MatN> b,
    BufTy matBuf,
    uint matOff,
    uint matStr)
{
    __builtin_OuterProductAccumulate(a, b, matBuf, matOff, MatDT, MatML, matStr);
}

template<typename ElTy, uint N, typename BufTy>
void __slang_linalg_VectorAccumulate(vector<ElTy, N> inputVec, BufTy buffer, uint offset)
{
    __builtin_VectorAccumulate(inputVec, buffer, offset);
}

StructuredBuffer<uint > query_count_0 : register(t15);

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

StructuredBuffer<Query_0 > queries_0 : register(t14);

RWStructuredBuffer<float4 > answers_0 : register(u10);

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

StructuredBuffer<Fabric_0 > fabrics_0 : register(t0);

StructuredBuffer<uint4 > packed_numbers_0 : register(t8);

StructuredBuffer<uint > words_0 : register(t2);

ByteAddressBuffer packed_bytes_0 : register(t16);

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

StructuredBuffer<Family_0 > families_0 : register(t1);

struct FloatWeights_0
{
    uint first_0;
};

struct Eight_0
{
    float4 low_0;
    float4 high_0;
};

Eight_0 FloatWeights_eight_0(FloatWeights_0 this_0, uint element_0)
{
    Eight_0 numbers_0;
    uint _S1 = this_0.first_0 + 2U * element_0;
    numbers_0.low_0 = asfloat(packed_numbers_0.Load(_S1));
    numbers_0.high_0 = asfloat(packed_numbers_0.Load(_S1 + 1U));
    return numbers_0;
}

float4 tile_product_0(FloatWeights_0 weights_0, uint row_0, inout float  inputs_0[int(96)])
{
    float4 sums_1 = (float4)0.0f;
    uint column_0 = 0U;
    for(;;)
    {
        if(column_0 < 12U)
        {
        }
        else
        {
            break;
        }
        float4 low_1;
        float4 high_1;
        int _S2 = int(8U * column_0);
        low_1[int(0)] = inputs_0[_S2];
        high_1[int(0)] = inputs_0[_S2 + int(4)];
        int _S3 = _S2 + int(1);
        low_1[int(1)] = inputs_0[_S3];
        high_1[int(1)] = inputs_0[_S3 + int(4)];
        int _S4 = _S2 + int(2);
        low_1[int(2)] = inputs_0[_S4];
        high_1[int(2)] = inputs_0[_S4 + int(4)];
        int _S5 = _S2 + int(3);
        low_1[int(3)] = inputs_0[_S5];
        high_1[int(3)] = inputs_0[_S5 + int(4)];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_1[int(0)] = sums_1[int(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_1[int(1)] = sums_1[int(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        sums_1[int(2)] = sums_1[int(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        sums_1[int(3)] = sums_1[int(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
}

int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

float Identity_apply_0(float x_0)
{
    return x_0;
}

void dense_part_0(FloatWeights_0 weights_1, uint first_1, bool adds_0, inout float  inputs_1[int(96)], inout float  outputs_0[int(50)])
{
    uint _S10 = first_1 + uint(whole_parts_0(int(7)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S11 = output_0 < int(50);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U);
        float4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 12U, inputs_1);
        float4 _S15;
        if((output_0 & int(4)) != int(0))
        {
            _S15 = _S13.high_0;
        }
        else
        {
            _S15 = _S13.low_0;
        }
        float4 _S16 = _S14 + _S15;
        float _S17;
        if(_S11)
        {
            if(adds_0)
            {
                _S17 = outputs_0[output_0];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[output_0] = Identity_apply_0(_S16[int(0)] + _S17);
        }
        int _S18 = output_0 + int(1);
        if(_S18 < int(50))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S18] = Identity_apply_0(_S16[int(1)] + _S17);
        }
        int _S19 = output_0 + int(2);
        if(_S19 < int(50))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S19] = Identity_apply_0(_S16[int(2)] + _S17);
        }
        int _S20 = output_0 + int(3);
        if(_S20 < int(50))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S20] = Identity_apply_0(_S16[int(3)] + _S17);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

struct HalfWeights_0
{
    uint first_2;
};

uint HalfWeights_byte_of_0(HalfWeights_0 this_1, uint element_1)
{
    return 16U * (this_1.first_2 + element_1);
}

void cooperative_part_0(HalfWeights_0 weights_2, uint first_3, bool adds_1, inout float  inputs_2[int(96)], inout float  outputs_1[int(52)])
{
    vector<half,96> _S21;
    (_S21) = (0.0);
    vector<half,96> vector_0;
    vector_0 = (_S21);
    vector_0[int(0)] = half(inputs_2[int(0)]);
    vector_0[int(1)] = half(inputs_2[int(1)]);
    vector_0[int(2)] = half(inputs_2[int(2)]);
    vector_0[int(3)] = half(inputs_2[int(3)]);
    vector_0[int(4)] = half(inputs_2[int(4)]);
    vector_0[int(5)] = half(inputs_2[int(5)]);
    vector_0[int(6)] = half(inputs_2[int(6)]);
    vector_0[int(7)] = half(inputs_2[int(7)]);
    vector_0[int(8)] = half(inputs_2[int(8)]);
    vector_0[int(9)] = half(inputs_2[int(9)]);
    vector_0[int(10)] = half(inputs_2[int(10)]);
    vector_0[int(11)] = half(inputs_2[int(11)]);
    vector_0[int(12)] = half(inputs_2[int(12)]);
    vector_0[int(13)] = half(inputs_2[int(13)]);
    vector_0[int(14)] = half(inputs_2[int(14)]);
    vector_0[int(15)] = half(inputs_2[int(15)]);
    vector_0[int(16)] = half(inputs_2[int(16)]);
    vector_0[int(17)] = half(inputs_2[int(17)]);
    vector_0[int(18)] = half(inputs_2[int(18)]);
    vector_0[int(19)] = half(inputs_2[int(19)]);
    vector_0[int(20)] = half(inputs_2[int(20)]);
    vector_0[int(21)] = half(inputs_2[int(21)]);
    vector_0[int(22)] = half(inputs_2[int(22)]);
    vector_0[int(23)] = half(inputs_2[int(23)]);
    vector_0[int(24)] = half(inputs_2[int(24)]);
    vector_0[int(25)] = half(inputs_2[int(25)]);
    vector_0[int(26)] = half(inputs_2[int(26)]);
    vector_0[int(27)] = half(inputs_2[int(27)]);
    vector_0[int(28)] = half(inputs_2[int(28)]);
    vector_0[int(29)] = half(inputs_2[int(29)]);
    vector_0[int(30)] = half(inputs_2[int(30)]);
    vector_0[int(31)] = half(inputs_2[int(31)]);
    vector_0[int(32)] = half(inputs_2[int(32)]);
    vector_0[int(33)] = half(inputs_2[int(33)]);
    vector_0[int(34)] = half(inputs_2[int(34)]);
    vector_0[int(35)] = half(inputs_2[int(35)]);
    vector_0[int(36)] = half(inputs_2[int(36)]);
    vector_0[int(37)] = half(inputs_2[int(37)]);
    vector_0[int(38)] = half(inputs_2[int(38)]);
    vector_0[int(39)] = half(inputs_2[int(39)]);
    vector_0[int(40)] = half(inputs_2[int(40)]);
    vector_0[int(41)] = half(inputs_2[int(41)]);
    vector_0[int(42)] = half(inputs_2[int(42)]);
    vector_0[int(43)] = half(inputs_2[int(43)]);
    vector_0[int(44)] = half(inputs_2[int(44)]);
    vector_0[int(45)] = half(inputs_2[int(45)]);
    vector_0[int(46)] = half(inputs_2[int(46)]);
    vector_0[int(47)] = half(inputs_2[int(47)]);
    vector_0[int(48)] = half(inputs_2[int(48)]);
    vector_0[int(49)] = half(inputs_2[int(49)]);
    vector_0[int(50)] = half(inputs_2[int(50)]);
    vector_0[int(51)] = half(inputs_2[int(51)]);
    vector_0[int(52)] = half(inputs_2[int(52)]);
    vector_0[int(53)] = half(inputs_2[int(53)]);
    vector_0[int(54)] = half(inputs_2[int(54)]);
    vector_0[int(55)] = half(inputs_2[int(55)]);
    vector_0[int(56)] = half(inputs_2[int(56)]);
    vector_0[int(57)] = half(inputs_2[int(57)]);
    vector_0[int(58)] = half(inputs_2[int(58)]);
    vector_0[int(59)] = half(inputs_2[int(59)]);
    vector_0[int(60)] = half(inputs_2[int(60)]);
    vector_0[int(61)] = half(inputs_2[int(61)]);
    vector_0[int(62)] = half(inputs_2[int(62)]);
    vector_0[int(63)] = half(inputs_2[int(63)]);
    vector_0[int(64)] = half(inputs_2[int(64)]);
    vector_0[int(65)] = half(inputs_2[int(65)]);
    vector_0[int(66)] = half(inputs_2[int(66)]);
    vector_0[int(67)] = half(inputs_2[int(67)]);
    vector_0[int(68)] = half(inputs_2[int(68)]);
    vector_0[int(69)] = half(inputs_2[int(69)]);
    vector_0[int(70)] = half(inputs_2[int(70)]);
    vector_0[int(71)] = half(inputs_2[int(71)]);
    vector_0[int(72)] = half(inputs_2[int(72)]);
    vector_0[int(73)] = half(inputs_2[int(73)]);
    vector_0[int(74)] = half(inputs_2[int(74)]);
    vector_0[int(75)] = half(inputs_2[int(75)]);
    vector_0[int(76)] = half(inputs_2[int(76)]);
    vector_0[int(77)] = half(inputs_2[int(77)]);
    vector_0[int(78)] = half(inputs_2[int(78)]);
    vector_0[int(79)] = half(inputs_2[int(79)]);
    vector_0[int(80)] = half(inputs_2[int(80)]);
    vector_0[int(81)] = half(inputs_2[int(81)]);
    vector_0[int(82)] = half(inputs_2[int(82)]);
    vector_0[int(83)] = half(inputs_2[int(83)]);
    vector_0[int(84)] = half(inputs_2[int(84)]);
    vector_0[int(85)] = half(inputs_2[int(85)]);
    vector_0[int(86)] = half(inputs_2[int(86)]);
    vector_0[int(87)] = half(inputs_2[int(87)]);
    vector_0[int(88)] = half(inputs_2[int(88)]);
    vector_0[int(89)] = half(inputs_2[int(89)]);
    vector_0[int(90)] = half(inputs_2[int(90)]);
    vector_0[int(91)] = half(inputs_2[int(91)]);
    vector_0[int(92)] = half(inputs_2[int(92)]);
    vector_0[int(93)] = half(inputs_2[int(93)]);
    vector_0[int(94)] = half(inputs_2[int(94)]);
    vector_0[int(95)] = half(inputs_2[int(95)]);
    vector<half,52> _S22 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(52), int(96), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(96), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_2, first_3 + uint(whole_parts_0(int(7))))), 192U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_2, first_3)), vector_0);
    float _S23 = float(_S22[int(0)]);
    float _S24;
    if(adds_1)
    {
        _S24 = outputs_1[int(0)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(0)] = Identity_apply_0(_S23 + _S24);
    float _S25 = float(_S22[int(1)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(1)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(1)] = Identity_apply_0(_S25 + _S24);
    float _S26 = float(_S22[int(2)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(2)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(2)] = Identity_apply_0(_S26 + _S24);
    float _S27 = float(_S22[int(3)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(3)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(3)] = Identity_apply_0(_S27 + _S24);
    float _S28 = float(_S22[int(4)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(4)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(4)] = Identity_apply_0(_S28 + _S24);
    float _S29 = float(_S22[int(5)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(5)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(5)] = Identity_apply_0(_S29 + _S24);
    float _S30 = float(_S22[int(6)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(6)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(6)] = Identity_apply_0(_S30 + _S24);
    float _S31 = float(_S22[int(7)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(7)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(7)] = Identity_apply_0(_S31 + _S24);
    float _S32 = float(_S22[int(8)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(8)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(8)] = Identity_apply_0(_S32 + _S24);
    float _S33 = float(_S22[int(9)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(9)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(9)] = Identity_apply_0(_S33 + _S24);
    float _S34 = float(_S22[int(10)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(10)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(10)] = Identity_apply_0(_S34 + _S24);
    float _S35 = float(_S22[int(11)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(11)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(11)] = Identity_apply_0(_S35 + _S24);
    float _S36 = float(_S22[int(12)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(12)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(12)] = Identity_apply_0(_S36 + _S24);
    float _S37 = float(_S22[int(13)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(13)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(13)] = Identity_apply_0(_S37 + _S24);
    float _S38 = float(_S22[int(14)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(14)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(14)] = Identity_apply_0(_S38 + _S24);
    float _S39 = float(_S22[int(15)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(15)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(15)] = Identity_apply_0(_S39 + _S24);
    float _S40 = float(_S22[int(16)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(16)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(16)] = Identity_apply_0(_S40 + _S24);
    float _S41 = float(_S22[int(17)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(17)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(17)] = Identity_apply_0(_S41 + _S24);
    float _S42 = float(_S22[int(18)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(18)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(18)] = Identity_apply_0(_S42 + _S24);
    float _S43 = float(_S22[int(19)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(19)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(19)] = Identity_apply_0(_S43 + _S24);
    float _S44 = float(_S22[int(20)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(20)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(20)] = Identity_apply_0(_S44 + _S24);
    float _S45 = float(_S22[int(21)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(21)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(21)] = Identity_apply_0(_S45 + _S24);
    float _S46 = float(_S22[int(22)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(22)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(22)] = Identity_apply_0(_S46 + _S24);
    float _S47 = float(_S22[int(23)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(23)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(23)] = Identity_apply_0(_S47 + _S24);
    float _S48 = float(_S22[int(24)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(24)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(24)] = Identity_apply_0(_S48 + _S24);
    float _S49 = float(_S22[int(25)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(25)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(25)] = Identity_apply_0(_S49 + _S24);
    float _S50 = float(_S22[int(26)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(26)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(26)] = Identity_apply_0(_S50 + _S24);
    float _S51 = float(_S22[int(27)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(27)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(27)] = Identity_apply_0(_S51 + _S24);
    float _S52 = float(_S22[int(28)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(28)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(28)] = Identity_apply_0(_S52 + _S24);
    float _S53 = float(_S22[int(29)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(29)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(29)] = Identity_apply_0(_S53 + _S24);
    float _S54 = float(_S22[int(30)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(30)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(30)] = Identity_apply_0(_S54 + _S24);
    float _S55 = float(_S22[int(31)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(31)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(31)] = Identity_apply_0(_S55 + _S24);
    float _S56 = float(_S22[int(32)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(32)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(32)] = Identity_apply_0(_S56 + _S24);
    float _S57 = float(_S22[int(33)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(33)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(33)] = Identity_apply_0(_S57 + _S24);
    float _S58 = float(_S22[int(34)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(34)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(34)] = Identity_apply_0(_S58 + _S24);
    float _S59 = float(_S22[int(35)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(35)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(35)] = Identity_apply_0(_S59 + _S24);
    float _S60 = float(_S22[int(36)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(36)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(36)] = Identity_apply_0(_S60 + _S24);
    float _S61 = float(_S22[int(37)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(37)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(37)] = Identity_apply_0(_S61 + _S24);
    float _S62 = float(_S22[int(38)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(38)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(38)] = Identity_apply_0(_S62 + _S24);
    float _S63 = float(_S22[int(39)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(39)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(39)] = Identity_apply_0(_S63 + _S24);
    float _S64 = float(_S22[int(40)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(40)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(40)] = Identity_apply_0(_S64 + _S24);
    float _S65 = float(_S22[int(41)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(41)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(41)] = Identity_apply_0(_S65 + _S24);
    float _S66 = float(_S22[int(42)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(42)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(42)] = Identity_apply_0(_S66 + _S24);
    float _S67 = float(_S22[int(43)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(43)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(43)] = Identity_apply_0(_S67 + _S24);
    float _S68 = float(_S22[int(44)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(44)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(44)] = Identity_apply_0(_S68 + _S24);
    float _S69 = float(_S22[int(45)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(45)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(45)] = Identity_apply_0(_S69 + _S24);
    float _S70 = float(_S22[int(46)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(46)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(46)] = Identity_apply_0(_S70 + _S24);
    float _S71 = float(_S22[int(47)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(47)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(47)] = Identity_apply_0(_S71 + _S24);
    float _S72 = float(_S22[int(48)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(48)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(48)] = Identity_apply_0(_S72 + _S24);
    float _S73 = float(_S22[int(49)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(49)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(49)] = Identity_apply_0(_S73 + _S24);
    float _S74 = float(_S22[int(50)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(50)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(50)] = Identity_apply_0(_S74 + _S24);
    float _S75 = float(_S22[int(51)]);
    if(adds_1)
    {
        _S24 = outputs_1[int(51)];
    }
    else
    {
        _S24 = 0.0f;
    }
    outputs_1[int(51)] = Identity_apply_0(_S75 + _S24);
    return;
}

void dense_part_1(HalfWeights_0 weights_3, uint first_4, bool adds_2, inout float  inputs_3[int(96)], inout float  outputs_2[int(52)])
{
    cooperative_part_0(weights_3, first_4, adds_2, inputs_3, outputs_2);
    return;
}

void cooperative_part_1(HalfWeights_0 weights_4, uint first_5, bool adds_3, inout float  inputs_4[int(39)], inout float  outputs_3[int(96)])
{
    vector<half,39> _S76;
    (_S76) = (0.0);
    vector<half,39> vector_1;
    vector_1 = (_S76);
    vector_1[int(0)] = half(inputs_4[int(0)]);
    vector_1[int(1)] = half(inputs_4[int(1)]);
    vector_1[int(2)] = half(inputs_4[int(2)]);
    vector_1[int(3)] = half(inputs_4[int(3)]);
    vector_1[int(4)] = half(inputs_4[int(4)]);
    vector_1[int(5)] = half(inputs_4[int(5)]);
    vector_1[int(6)] = half(inputs_4[int(6)]);
    vector_1[int(7)] = half(inputs_4[int(7)]);
    vector_1[int(8)] = half(inputs_4[int(8)]);
    vector_1[int(9)] = half(inputs_4[int(9)]);
    vector_1[int(10)] = half(inputs_4[int(10)]);
    vector_1[int(11)] = half(inputs_4[int(11)]);
    vector_1[int(12)] = half(inputs_4[int(12)]);
    vector_1[int(13)] = half(inputs_4[int(13)]);
    vector_1[int(14)] = half(inputs_4[int(14)]);
    vector_1[int(15)] = half(inputs_4[int(15)]);
    vector_1[int(16)] = half(inputs_4[int(16)]);
    vector_1[int(17)] = half(inputs_4[int(17)]);
    vector_1[int(18)] = half(inputs_4[int(18)]);
    vector_1[int(19)] = half(inputs_4[int(19)]);
    vector_1[int(20)] = half(inputs_4[int(20)]);
    vector_1[int(21)] = half(inputs_4[int(21)]);
    vector_1[int(22)] = half(inputs_4[int(22)]);
    vector_1[int(23)] = half(inputs_4[int(23)]);
    vector_1[int(24)] = half(inputs_4[int(24)]);
    vector_1[int(25)] = half(inputs_4[int(25)]);
    vector_1[int(26)] = half(inputs_4[int(26)]);
    vector_1[int(27)] = half(inputs_4[int(27)]);
    vector_1[int(28)] = half(inputs_4[int(28)]);
    vector_1[int(29)] = half(inputs_4[int(29)]);
    vector_1[int(30)] = half(inputs_4[int(30)]);
    vector_1[int(31)] = half(inputs_4[int(31)]);
    vector_1[int(32)] = half(inputs_4[int(32)]);
    vector_1[int(33)] = half(inputs_4[int(33)]);
    vector_1[int(34)] = half(inputs_4[int(34)]);
    vector_1[int(35)] = half(inputs_4[int(35)]);
    vector_1[int(36)] = half(inputs_4[int(36)]);
    vector_1[int(37)] = half(inputs_4[int(37)]);
    vector_1[int(38)] = half(inputs_4[int(38)]);
    vector<half,96> _S77 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(96), int(39), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(39), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_4, first_5 + uint(whole_parts_0(int(12))))), 80U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_4, first_5)), vector_1);
    float _S78 = float(_S77[int(0)]);
    float _S79;
    if(adds_3)
    {
        _S79 = outputs_3[int(0)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(0)] = Identity_apply_0(_S78 + _S79);
    float _S80 = float(_S77[int(1)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(1)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(1)] = Identity_apply_0(_S80 + _S79);
    float _S81 = float(_S77[int(2)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(2)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(2)] = Identity_apply_0(_S81 + _S79);
    float _S82 = float(_S77[int(3)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(3)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(3)] = Identity_apply_0(_S82 + _S79);
    float _S83 = float(_S77[int(4)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(4)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(4)] = Identity_apply_0(_S83 + _S79);
    float _S84 = float(_S77[int(5)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(5)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(5)] = Identity_apply_0(_S84 + _S79);
    float _S85 = float(_S77[int(6)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(6)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(6)] = Identity_apply_0(_S85 + _S79);
    float _S86 = float(_S77[int(7)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(7)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(7)] = Identity_apply_0(_S86 + _S79);
    float _S87 = float(_S77[int(8)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(8)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(8)] = Identity_apply_0(_S87 + _S79);
    float _S88 = float(_S77[int(9)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(9)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(9)] = Identity_apply_0(_S88 + _S79);
    float _S89 = float(_S77[int(10)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(10)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(10)] = Identity_apply_0(_S89 + _S79);
    float _S90 = float(_S77[int(11)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(11)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(11)] = Identity_apply_0(_S90 + _S79);
    float _S91 = float(_S77[int(12)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(12)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(12)] = Identity_apply_0(_S91 + _S79);
    float _S92 = float(_S77[int(13)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(13)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(13)] = Identity_apply_0(_S92 + _S79);
    float _S93 = float(_S77[int(14)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(14)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(14)] = Identity_apply_0(_S93 + _S79);
    float _S94 = float(_S77[int(15)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(15)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(15)] = Identity_apply_0(_S94 + _S79);
    float _S95 = float(_S77[int(16)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(16)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(16)] = Identity_apply_0(_S95 + _S79);
    float _S96 = float(_S77[int(17)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(17)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(17)] = Identity_apply_0(_S96 + _S79);
    float _S97 = float(_S77[int(18)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(18)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(18)] = Identity_apply_0(_S97 + _S79);
    float _S98 = float(_S77[int(19)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(19)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(19)] = Identity_apply_0(_S98 + _S79);
    float _S99 = float(_S77[int(20)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(20)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(20)] = Identity_apply_0(_S99 + _S79);
    float _S100 = float(_S77[int(21)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(21)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(21)] = Identity_apply_0(_S100 + _S79);
    float _S101 = float(_S77[int(22)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(22)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(22)] = Identity_apply_0(_S101 + _S79);
    float _S102 = float(_S77[int(23)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(23)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(23)] = Identity_apply_0(_S102 + _S79);
    float _S103 = float(_S77[int(24)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(24)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(24)] = Identity_apply_0(_S103 + _S79);
    float _S104 = float(_S77[int(25)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(25)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(25)] = Identity_apply_0(_S104 + _S79);
    float _S105 = float(_S77[int(26)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(26)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(26)] = Identity_apply_0(_S105 + _S79);
    float _S106 = float(_S77[int(27)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(27)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(27)] = Identity_apply_0(_S106 + _S79);
    float _S107 = float(_S77[int(28)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(28)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(28)] = Identity_apply_0(_S107 + _S79);
    float _S108 = float(_S77[int(29)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(29)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(29)] = Identity_apply_0(_S108 + _S79);
    float _S109 = float(_S77[int(30)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(30)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(30)] = Identity_apply_0(_S109 + _S79);
    float _S110 = float(_S77[int(31)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(31)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(31)] = Identity_apply_0(_S110 + _S79);
    float _S111 = float(_S77[int(32)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(32)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(32)] = Identity_apply_0(_S111 + _S79);
    float _S112 = float(_S77[int(33)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(33)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(33)] = Identity_apply_0(_S112 + _S79);
    float _S113 = float(_S77[int(34)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(34)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(34)] = Identity_apply_0(_S113 + _S79);
    float _S114 = float(_S77[int(35)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(35)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(35)] = Identity_apply_0(_S114 + _S79);
    float _S115 = float(_S77[int(36)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(36)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(36)] = Identity_apply_0(_S115 + _S79);
    float _S116 = float(_S77[int(37)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(37)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(37)] = Identity_apply_0(_S116 + _S79);
    float _S117 = float(_S77[int(38)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(38)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(38)] = Identity_apply_0(_S117 + _S79);
    float _S118 = float(_S77[int(39)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(39)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(39)] = Identity_apply_0(_S118 + _S79);
    float _S119 = float(_S77[int(40)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(40)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(40)] = Identity_apply_0(_S119 + _S79);
    float _S120 = float(_S77[int(41)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(41)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(41)] = Identity_apply_0(_S120 + _S79);
    float _S121 = float(_S77[int(42)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(42)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(42)] = Identity_apply_0(_S121 + _S79);
    float _S122 = float(_S77[int(43)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(43)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(43)] = Identity_apply_0(_S122 + _S79);
    float _S123 = float(_S77[int(44)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(44)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(44)] = Identity_apply_0(_S123 + _S79);
    float _S124 = float(_S77[int(45)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(45)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(45)] = Identity_apply_0(_S124 + _S79);
    float _S125 = float(_S77[int(46)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(46)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(46)] = Identity_apply_0(_S125 + _S79);
    float _S126 = float(_S77[int(47)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(47)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(47)] = Identity_apply_0(_S126 + _S79);
    float _S127 = float(_S77[int(48)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(48)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(48)] = Identity_apply_0(_S127 + _S79);
    float _S128 = float(_S77[int(49)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(49)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(49)] = Identity_apply_0(_S128 + _S79);
    float _S129 = float(_S77[int(50)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(50)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(50)] = Identity_apply_0(_S129 + _S79);
    float _S130 = float(_S77[int(51)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(51)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(51)] = Identity_apply_0(_S130 + _S79);
    float _S131 = float(_S77[int(52)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(52)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(52)] = Identity_apply_0(_S131 + _S79);
    float _S132 = float(_S77[int(53)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(53)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(53)] = Identity_apply_0(_S132 + _S79);
    float _S133 = float(_S77[int(54)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(54)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(54)] = Identity_apply_0(_S133 + _S79);
    float _S134 = float(_S77[int(55)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(55)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(55)] = Identity_apply_0(_S134 + _S79);
    float _S135 = float(_S77[int(56)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(56)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(56)] = Identity_apply_0(_S135 + _S79);
    float _S136 = float(_S77[int(57)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(57)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(57)] = Identity_apply_0(_S136 + _S79);
    float _S137 = float(_S77[int(58)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(58)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(58)] = Identity_apply_0(_S137 + _S79);
    float _S138 = float(_S77[int(59)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(59)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(59)] = Identity_apply_0(_S138 + _S79);
    float _S139 = float(_S77[int(60)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(60)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(60)] = Identity_apply_0(_S139 + _S79);
    float _S140 = float(_S77[int(61)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(61)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(61)] = Identity_apply_0(_S140 + _S79);
    float _S141 = float(_S77[int(62)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(62)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(62)] = Identity_apply_0(_S141 + _S79);
    float _S142 = float(_S77[int(63)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(63)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(63)] = Identity_apply_0(_S142 + _S79);
    float _S143 = float(_S77[int(64)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(64)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(64)] = Identity_apply_0(_S143 + _S79);
    float _S144 = float(_S77[int(65)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(65)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(65)] = Identity_apply_0(_S144 + _S79);
    float _S145 = float(_S77[int(66)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(66)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(66)] = Identity_apply_0(_S145 + _S79);
    float _S146 = float(_S77[int(67)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(67)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(67)] = Identity_apply_0(_S146 + _S79);
    float _S147 = float(_S77[int(68)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(68)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(68)] = Identity_apply_0(_S147 + _S79);
    float _S148 = float(_S77[int(69)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(69)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(69)] = Identity_apply_0(_S148 + _S79);
    float _S149 = float(_S77[int(70)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(70)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(70)] = Identity_apply_0(_S149 + _S79);
    float _S150 = float(_S77[int(71)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(71)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(71)] = Identity_apply_0(_S150 + _S79);
    float _S151 = float(_S77[int(72)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(72)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(72)] = Identity_apply_0(_S151 + _S79);
    float _S152 = float(_S77[int(73)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(73)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(73)] = Identity_apply_0(_S152 + _S79);
    float _S153 = float(_S77[int(74)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(74)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(74)] = Identity_apply_0(_S153 + _S79);
    float _S154 = float(_S77[int(75)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(75)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(75)] = Identity_apply_0(_S154 + _S79);
    float _S155 = float(_S77[int(76)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(76)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(76)] = Identity_apply_0(_S155 + _S79);
    float _S156 = float(_S77[int(77)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(77)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(77)] = Identity_apply_0(_S156 + _S79);
    float _S157 = float(_S77[int(78)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(78)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(78)] = Identity_apply_0(_S157 + _S79);
    float _S158 = float(_S77[int(79)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(79)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(79)] = Identity_apply_0(_S158 + _S79);
    float _S159 = float(_S77[int(80)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(80)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(80)] = Identity_apply_0(_S159 + _S79);
    float _S160 = float(_S77[int(81)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(81)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(81)] = Identity_apply_0(_S160 + _S79);
    float _S161 = float(_S77[int(82)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(82)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(82)] = Identity_apply_0(_S161 + _S79);
    float _S162 = float(_S77[int(83)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(83)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(83)] = Identity_apply_0(_S162 + _S79);
    float _S163 = float(_S77[int(84)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(84)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(84)] = Identity_apply_0(_S163 + _S79);
    float _S164 = float(_S77[int(85)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(85)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(85)] = Identity_apply_0(_S164 + _S79);
    float _S165 = float(_S77[int(86)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(86)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(86)] = Identity_apply_0(_S165 + _S79);
    float _S166 = float(_S77[int(87)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(87)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(87)] = Identity_apply_0(_S166 + _S79);
    float _S167 = float(_S77[int(88)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(88)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(88)] = Identity_apply_0(_S167 + _S79);
    float _S168 = float(_S77[int(89)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(89)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(89)] = Identity_apply_0(_S168 + _S79);
    float _S169 = float(_S77[int(90)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(90)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(90)] = Identity_apply_0(_S169 + _S79);
    float _S170 = float(_S77[int(91)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(91)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(91)] = Identity_apply_0(_S170 + _S79);
    float _S171 = float(_S77[int(92)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(92)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(92)] = Identity_apply_0(_S171 + _S79);
    float _S172 = float(_S77[int(93)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(93)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(93)] = Identity_apply_0(_S172 + _S79);
    float _S173 = float(_S77[int(94)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(94)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(94)] = Identity_apply_0(_S173 + _S79);
    float _S174 = float(_S77[int(95)]);
    if(adds_3)
    {
        _S79 = outputs_3[int(95)];
    }
    else
    {
        _S79 = 0.0f;
    }
    outputs_3[int(95)] = Identity_apply_0(_S174 + _S79);
    return;
}

void dense_part_2(HalfWeights_0 weights_5, uint first_6, bool adds_4, inout float  inputs_5[int(39)], inout float  outputs_4[int(96)])
{
    cooperative_part_1(weights_5, first_6, adds_4, inputs_5, outputs_4);
    return;
}

void cooperative_part_2(HalfWeights_0 weights_6, uint first_7, bool adds_5, inout float  inputs_6[int(100)], inout float  outputs_5[int(96)])
{
    vector<half,100> _S175;
    (_S175) = (0.0);
    vector<half,100> vector_2;
    vector_2 = (_S175);
    vector_2[int(0)] = half(inputs_6[int(0)]);
    vector_2[int(1)] = half(inputs_6[int(1)]);
    vector_2[int(2)] = half(inputs_6[int(2)]);
    vector_2[int(3)] = half(inputs_6[int(3)]);
    vector_2[int(4)] = half(inputs_6[int(4)]);
    vector_2[int(5)] = half(inputs_6[int(5)]);
    vector_2[int(6)] = half(inputs_6[int(6)]);
    vector_2[int(7)] = half(inputs_6[int(7)]);
    vector_2[int(8)] = half(inputs_6[int(8)]);
    vector_2[int(9)] = half(inputs_6[int(9)]);
    vector_2[int(10)] = half(inputs_6[int(10)]);
    vector_2[int(11)] = half(inputs_6[int(11)]);
    vector_2[int(12)] = half(inputs_6[int(12)]);
    vector_2[int(13)] = half(inputs_6[int(13)]);
    vector_2[int(14)] = half(inputs_6[int(14)]);
    vector_2[int(15)] = half(inputs_6[int(15)]);
    vector_2[int(16)] = half(inputs_6[int(16)]);
    vector_2[int(17)] = half(inputs_6[int(17)]);
    vector_2[int(18)] = half(inputs_6[int(18)]);
    vector_2[int(19)] = half(inputs_6[int(19)]);
    vector_2[int(20)] = half(inputs_6[int(20)]);
    vector_2[int(21)] = half(inputs_6[int(21)]);
    vector_2[int(22)] = half(inputs_6[int(22)]);
    vector_2[int(23)] = half(inputs_6[int(23)]);
    vector_2[int(24)] = half(inputs_6[int(24)]);
    vector_2[int(25)] = half(inputs_6[int(25)]);
    vector_2[int(26)] = half(inputs_6[int(26)]);
    vector_2[int(27)] = half(inputs_6[int(27)]);
    vector_2[int(28)] = half(inputs_6[int(28)]);
    vector_2[int(29)] = half(inputs_6[int(29)]);
    vector_2[int(30)] = half(inputs_6[int(30)]);
    vector_2[int(31)] = half(inputs_6[int(31)]);
    vector_2[int(32)] = half(inputs_6[int(32)]);
    vector_2[int(33)] = half(inputs_6[int(33)]);
    vector_2[int(34)] = half(inputs_6[int(34)]);
    vector_2[int(35)] = half(inputs_6[int(35)]);
    vector_2[int(36)] = half(inputs_6[int(36)]);
    vector_2[int(37)] = half(inputs_6[int(37)]);
    vector_2[int(38)] = half(inputs_6[int(38)]);
    vector_2[int(39)] = half(inputs_6[int(39)]);
    vector_2[int(40)] = half(inputs_6[int(40)]);
    vector_2[int(41)] = half(inputs_6[int(41)]);
    vector_2[int(42)] = half(inputs_6[int(42)]);
    vector_2[int(43)] = half(inputs_6[int(43)]);
    vector_2[int(44)] = half(inputs_6[int(44)]);
    vector_2[int(45)] = half(inputs_6[int(45)]);
    vector_2[int(46)] = half(inputs_6[int(46)]);
    vector_2[int(47)] = half(inputs_6[int(47)]);
    vector_2[int(48)] = half(inputs_6[int(48)]);
    vector_2[int(49)] = half(inputs_6[int(49)]);
    vector_2[int(50)] = half(inputs_6[int(50)]);
    vector_2[int(51)] = half(inputs_6[int(51)]);
    vector_2[int(52)] = half(inputs_6[int(52)]);
    vector_2[int(53)] = half(inputs_6[int(53)]);
    vector_2[int(54)] = half(inputs_6[int(54)]);
    vector_2[int(55)] = half(inputs_6[int(55)]);
    vector_2[int(56)] = half(inputs_6[int(56)]);
    vector_2[int(57)] = half(inputs_6[int(57)]);
    vector_2[int(58)] = half(inputs_6[int(58)]);
    vector_2[int(59)] = half(inputs_6[int(59)]);
    vector_2[int(60)] = half(inputs_6[int(60)]);
    vector_2[int(61)] = half(inputs_6[int(61)]);
    vector_2[int(62)] = half(inputs_6[int(62)]);
    vector_2[int(63)] = half(inputs_6[int(63)]);
    vector_2[int(64)] = half(inputs_6[int(64)]);
    vector_2[int(65)] = half(inputs_6[int(65)]);
    vector_2[int(66)] = half(inputs_6[int(66)]);
    vector_2[int(67)] = half(inputs_6[int(67)]);
    vector_2[int(68)] = half(inputs_6[int(68)]);
    vector_2[int(69)] = half(inputs_6[int(69)]);
    vector_2[int(70)] = half(inputs_6[int(70)]);
    vector_2[int(71)] = half(inputs_6[int(71)]);
    vector_2[int(72)] = half(inputs_6[int(72)]);
    vector_2[int(73)] = half(inputs_6[int(73)]);
    vector_2[int(74)] = half(inputs_6[int(74)]);
    vector_2[int(75)] = half(inputs_6[int(75)]);
    vector_2[int(76)] = half(inputs_6[int(76)]);
    vector_2[int(77)] = half(inputs_6[int(77)]);
    vector_2[int(78)] = half(inputs_6[int(78)]);
    vector_2[int(79)] = half(inputs_6[int(79)]);
    vector_2[int(80)] = half(inputs_6[int(80)]);
    vector_2[int(81)] = half(inputs_6[int(81)]);
    vector_2[int(82)] = half(inputs_6[int(82)]);
    vector_2[int(83)] = half(inputs_6[int(83)]);
    vector_2[int(84)] = half(inputs_6[int(84)]);
    vector_2[int(85)] = half(inputs_6[int(85)]);
    vector_2[int(86)] = half(inputs_6[int(86)]);
    vector_2[int(87)] = half(inputs_6[int(87)]);
    vector_2[int(88)] = half(inputs_6[int(88)]);
    vector_2[int(89)] = half(inputs_6[int(89)]);
    vector_2[int(90)] = half(inputs_6[int(90)]);
    vector_2[int(91)] = half(inputs_6[int(91)]);
    vector_2[int(92)] = half(inputs_6[int(92)]);
    vector_2[int(93)] = half(inputs_6[int(93)]);
    vector_2[int(94)] = half(inputs_6[int(94)]);
    vector_2[int(95)] = half(inputs_6[int(95)]);
    vector_2[int(96)] = half(inputs_6[int(96)]);
    vector_2[int(97)] = half(inputs_6[int(97)]);
    vector_2[int(98)] = half(inputs_6[int(98)]);
    vector_2[int(99)] = half(inputs_6[int(99)]);
    vector<half,96> _S176 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(96), int(100), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(100), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_6, first_7 + uint(whole_parts_0(int(12))))), 208U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_6, first_7)), vector_2);
    float _S177 = float(_S176[int(0)]);
    float _S178;
    if(adds_5)
    {
        _S178 = outputs_5[int(0)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(0)] = Identity_apply_0(_S177 + _S178);
    float _S179 = float(_S176[int(1)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(1)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(1)] = Identity_apply_0(_S179 + _S178);
    float _S180 = float(_S176[int(2)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(2)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(2)] = Identity_apply_0(_S180 + _S178);
    float _S181 = float(_S176[int(3)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(3)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(3)] = Identity_apply_0(_S181 + _S178);
    float _S182 = float(_S176[int(4)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(4)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(4)] = Identity_apply_0(_S182 + _S178);
    float _S183 = float(_S176[int(5)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(5)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(5)] = Identity_apply_0(_S183 + _S178);
    float _S184 = float(_S176[int(6)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(6)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(6)] = Identity_apply_0(_S184 + _S178);
    float _S185 = float(_S176[int(7)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(7)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(7)] = Identity_apply_0(_S185 + _S178);
    float _S186 = float(_S176[int(8)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(8)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(8)] = Identity_apply_0(_S186 + _S178);
    float _S187 = float(_S176[int(9)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(9)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(9)] = Identity_apply_0(_S187 + _S178);
    float _S188 = float(_S176[int(10)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(10)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(10)] = Identity_apply_0(_S188 + _S178);
    float _S189 = float(_S176[int(11)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(11)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(11)] = Identity_apply_0(_S189 + _S178);
    float _S190 = float(_S176[int(12)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(12)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(12)] = Identity_apply_0(_S190 + _S178);
    float _S191 = float(_S176[int(13)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(13)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(13)] = Identity_apply_0(_S191 + _S178);
    float _S192 = float(_S176[int(14)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(14)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(14)] = Identity_apply_0(_S192 + _S178);
    float _S193 = float(_S176[int(15)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(15)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(15)] = Identity_apply_0(_S193 + _S178);
    float _S194 = float(_S176[int(16)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(16)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(16)] = Identity_apply_0(_S194 + _S178);
    float _S195 = float(_S176[int(17)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(17)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(17)] = Identity_apply_0(_S195 + _S178);
    float _S196 = float(_S176[int(18)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(18)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(18)] = Identity_apply_0(_S196 + _S178);
    float _S197 = float(_S176[int(19)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(19)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(19)] = Identity_apply_0(_S197 + _S178);
    float _S198 = float(_S176[int(20)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(20)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(20)] = Identity_apply_0(_S198 + _S178);
    float _S199 = float(_S176[int(21)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(21)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(21)] = Identity_apply_0(_S199 + _S178);
    float _S200 = float(_S176[int(22)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(22)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(22)] = Identity_apply_0(_S200 + _S178);
    float _S201 = float(_S176[int(23)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(23)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(23)] = Identity_apply_0(_S201 + _S178);
    float _S202 = float(_S176[int(24)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(24)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(24)] = Identity_apply_0(_S202 + _S178);
    float _S203 = float(_S176[int(25)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(25)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(25)] = Identity_apply_0(_S203 + _S178);
    float _S204 = float(_S176[int(26)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(26)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(26)] = Identity_apply_0(_S204 + _S178);
    float _S205 = float(_S176[int(27)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(27)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(27)] = Identity_apply_0(_S205 + _S178);
    float _S206 = float(_S176[int(28)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(28)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(28)] = Identity_apply_0(_S206 + _S178);
    float _S207 = float(_S176[int(29)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(29)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(29)] = Identity_apply_0(_S207 + _S178);
    float _S208 = float(_S176[int(30)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(30)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(30)] = Identity_apply_0(_S208 + _S178);
    float _S209 = float(_S176[int(31)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(31)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(31)] = Identity_apply_0(_S209 + _S178);
    float _S210 = float(_S176[int(32)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(32)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(32)] = Identity_apply_0(_S210 + _S178);
    float _S211 = float(_S176[int(33)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(33)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(33)] = Identity_apply_0(_S211 + _S178);
    float _S212 = float(_S176[int(34)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(34)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(34)] = Identity_apply_0(_S212 + _S178);
    float _S213 = float(_S176[int(35)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(35)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(35)] = Identity_apply_0(_S213 + _S178);
    float _S214 = float(_S176[int(36)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(36)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(36)] = Identity_apply_0(_S214 + _S178);
    float _S215 = float(_S176[int(37)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(37)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(37)] = Identity_apply_0(_S215 + _S178);
    float _S216 = float(_S176[int(38)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(38)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(38)] = Identity_apply_0(_S216 + _S178);
    float _S217 = float(_S176[int(39)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(39)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(39)] = Identity_apply_0(_S217 + _S178);
    float _S218 = float(_S176[int(40)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(40)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(40)] = Identity_apply_0(_S218 + _S178);
    float _S219 = float(_S176[int(41)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(41)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(41)] = Identity_apply_0(_S219 + _S178);
    float _S220 = float(_S176[int(42)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(42)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(42)] = Identity_apply_0(_S220 + _S178);
    float _S221 = float(_S176[int(43)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(43)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(43)] = Identity_apply_0(_S221 + _S178);
    float _S222 = float(_S176[int(44)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(44)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(44)] = Identity_apply_0(_S222 + _S178);
    float _S223 = float(_S176[int(45)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(45)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(45)] = Identity_apply_0(_S223 + _S178);
    float _S224 = float(_S176[int(46)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(46)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(46)] = Identity_apply_0(_S224 + _S178);
    float _S225 = float(_S176[int(47)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(47)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(47)] = Identity_apply_0(_S225 + _S178);
    float _S226 = float(_S176[int(48)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(48)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(48)] = Identity_apply_0(_S226 + _S178);
    float _S227 = float(_S176[int(49)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(49)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(49)] = Identity_apply_0(_S227 + _S178);
    float _S228 = float(_S176[int(50)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(50)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(50)] = Identity_apply_0(_S228 + _S178);
    float _S229 = float(_S176[int(51)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(51)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(51)] = Identity_apply_0(_S229 + _S178);
    float _S230 = float(_S176[int(52)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(52)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(52)] = Identity_apply_0(_S230 + _S178);
    float _S231 = float(_S176[int(53)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(53)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(53)] = Identity_apply_0(_S231 + _S178);
    float _S232 = float(_S176[int(54)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(54)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(54)] = Identity_apply_0(_S232 + _S178);
    float _S233 = float(_S176[int(55)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(55)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(55)] = Identity_apply_0(_S233 + _S178);
    float _S234 = float(_S176[int(56)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(56)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(56)] = Identity_apply_0(_S234 + _S178);
    float _S235 = float(_S176[int(57)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(57)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(57)] = Identity_apply_0(_S235 + _S178);
    float _S236 = float(_S176[int(58)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(58)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(58)] = Identity_apply_0(_S236 + _S178);
    float _S237 = float(_S176[int(59)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(59)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(59)] = Identity_apply_0(_S237 + _S178);
    float _S238 = float(_S176[int(60)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(60)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(60)] = Identity_apply_0(_S238 + _S178);
    float _S239 = float(_S176[int(61)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(61)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(61)] = Identity_apply_0(_S239 + _S178);
    float _S240 = float(_S176[int(62)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(62)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(62)] = Identity_apply_0(_S240 + _S178);
    float _S241 = float(_S176[int(63)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(63)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(63)] = Identity_apply_0(_S241 + _S178);
    float _S242 = float(_S176[int(64)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(64)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(64)] = Identity_apply_0(_S242 + _S178);
    float _S243 = float(_S176[int(65)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(65)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(65)] = Identity_apply_0(_S243 + _S178);
    float _S244 = float(_S176[int(66)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(66)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(66)] = Identity_apply_0(_S244 + _S178);
    float _S245 = float(_S176[int(67)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(67)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(67)] = Identity_apply_0(_S245 + _S178);
    float _S246 = float(_S176[int(68)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(68)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(68)] = Identity_apply_0(_S246 + _S178);
    float _S247 = float(_S176[int(69)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(69)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(69)] = Identity_apply_0(_S247 + _S178);
    float _S248 = float(_S176[int(70)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(70)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(70)] = Identity_apply_0(_S248 + _S178);
    float _S249 = float(_S176[int(71)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(71)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(71)] = Identity_apply_0(_S249 + _S178);
    float _S250 = float(_S176[int(72)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(72)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(72)] = Identity_apply_0(_S250 + _S178);
    float _S251 = float(_S176[int(73)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(73)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(73)] = Identity_apply_0(_S251 + _S178);
    float _S252 = float(_S176[int(74)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(74)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(74)] = Identity_apply_0(_S252 + _S178);
    float _S253 = float(_S176[int(75)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(75)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(75)] = Identity_apply_0(_S253 + _S178);
    float _S254 = float(_S176[int(76)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(76)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(76)] = Identity_apply_0(_S254 + _S178);
    float _S255 = float(_S176[int(77)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(77)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(77)] = Identity_apply_0(_S255 + _S178);
    float _S256 = float(_S176[int(78)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(78)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(78)] = Identity_apply_0(_S256 + _S178);
    float _S257 = float(_S176[int(79)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(79)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(79)] = Identity_apply_0(_S257 + _S178);
    float _S258 = float(_S176[int(80)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(80)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(80)] = Identity_apply_0(_S258 + _S178);
    float _S259 = float(_S176[int(81)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(81)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(81)] = Identity_apply_0(_S259 + _S178);
    float _S260 = float(_S176[int(82)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(82)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(82)] = Identity_apply_0(_S260 + _S178);
    float _S261 = float(_S176[int(83)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(83)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(83)] = Identity_apply_0(_S261 + _S178);
    float _S262 = float(_S176[int(84)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(84)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(84)] = Identity_apply_0(_S262 + _S178);
    float _S263 = float(_S176[int(85)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(85)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(85)] = Identity_apply_0(_S263 + _S178);
    float _S264 = float(_S176[int(86)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(86)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(86)] = Identity_apply_0(_S264 + _S178);
    float _S265 = float(_S176[int(87)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(87)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(87)] = Identity_apply_0(_S265 + _S178);
    float _S266 = float(_S176[int(88)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(88)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(88)] = Identity_apply_0(_S266 + _S178);
    float _S267 = float(_S176[int(89)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(89)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(89)] = Identity_apply_0(_S267 + _S178);
    float _S268 = float(_S176[int(90)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(90)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(90)] = Identity_apply_0(_S268 + _S178);
    float _S269 = float(_S176[int(91)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(91)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(91)] = Identity_apply_0(_S269 + _S178);
    float _S270 = float(_S176[int(92)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(92)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(92)] = Identity_apply_0(_S270 + _S178);
    float _S271 = float(_S176[int(93)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(93)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(93)] = Identity_apply_0(_S271 + _S178);
    float _S272 = float(_S176[int(94)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(94)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(94)] = Identity_apply_0(_S272 + _S178);
    float _S273 = float(_S176[int(95)]);
    if(adds_5)
    {
        _S178 = outputs_5[int(95)];
    }
    else
    {
        _S178 = 0.0f;
    }
    outputs_5[int(95)] = Identity_apply_0(_S273 + _S178);
    return;
}

void dense_part_3(HalfWeights_0 weights_7, uint first_8, bool adds_6, inout float  inputs_7[int(100)], inout float  outputs_6[int(96)])
{
    cooperative_part_2(weights_7, first_8, adds_6, inputs_7, outputs_6);
    return;
}

void cooperative_part_3(HalfWeights_0 weights_8, uint first_9, bool adds_7, inout float  inputs_8[int(16)], inout float  outputs_7[int(1)])
{
    vector<half,16> _S274;
    (_S274) = (0.0);
    vector<half,16> vector_3;
    vector_3 = (_S274);
    vector_3[int(0)] = half(inputs_8[int(0)]);
    vector_3[int(1)] = half(inputs_8[int(1)]);
    vector_3[int(2)] = half(inputs_8[int(2)]);
    vector_3[int(3)] = half(inputs_8[int(3)]);
    vector_3[int(4)] = half(inputs_8[int(4)]);
    vector_3[int(5)] = half(inputs_8[int(5)]);
    vector_3[int(6)] = half(inputs_8[int(6)]);
    vector_3[int(7)] = half(inputs_8[int(7)]);
    vector_3[int(8)] = half(inputs_8[int(8)]);
    vector_3[int(9)] = half(inputs_8[int(9)]);
    vector_3[int(10)] = half(inputs_8[int(10)]);
    vector_3[int(11)] = half(inputs_8[int(11)]);
    vector_3[int(12)] = half(inputs_8[int(12)]);
    vector_3[int(13)] = half(inputs_8[int(13)]);
    vector_3[int(14)] = half(inputs_8[int(14)]);
    vector_3[int(15)] = half(inputs_8[int(15)]);
    vector<half,1> _S275 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(1), int(16), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(16), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_8, first_9 + uint(whole_parts_0(int(1))))), 32U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_8, first_9)), vector_3);
    float _S276 = float(_S275[int(0)]);
    float _S277;
    if(adds_7)
    {
        _S277 = outputs_7[int(0)];
    }
    else
    {
        _S277 = 0.0f;
    }
    outputs_7[int(0)] = Identity_apply_0(_S276 + _S277);
    return;
}

void dense_part_4(HalfWeights_0 weights_9, uint first_10, bool adds_8, inout float  inputs_9[int(16)], inout float  outputs_8[int(1)])
{
    cooperative_part_3(weights_9, first_10, adds_8, inputs_9, outputs_8);
    return;
}

float LeakyRelu_apply_0(float x_1)
{
    return max(x_1, x_1 * 0.00999999977648258f);
}

void cooperative_part_4(HalfWeights_0 weights_10, uint first_11, bool adds_9, inout float  inputs_10[int(96)], inout float  outputs_9[int(96)])
{
    vector<half,96> _S278;
    (_S278) = (0.0);
    vector<half,96> vector_4;
    vector_4 = (_S278);
    vector_4[int(0)] = half(inputs_10[int(0)]);
    vector_4[int(1)] = half(inputs_10[int(1)]);
    vector_4[int(2)] = half(inputs_10[int(2)]);
    vector_4[int(3)] = half(inputs_10[int(3)]);
    vector_4[int(4)] = half(inputs_10[int(4)]);
    vector_4[int(5)] = half(inputs_10[int(5)]);
    vector_4[int(6)] = half(inputs_10[int(6)]);
    vector_4[int(7)] = half(inputs_10[int(7)]);
    vector_4[int(8)] = half(inputs_10[int(8)]);
    vector_4[int(9)] = half(inputs_10[int(9)]);
    vector_4[int(10)] = half(inputs_10[int(10)]);
    vector_4[int(11)] = half(inputs_10[int(11)]);
    vector_4[int(12)] = half(inputs_10[int(12)]);
    vector_4[int(13)] = half(inputs_10[int(13)]);
    vector_4[int(14)] = half(inputs_10[int(14)]);
    vector_4[int(15)] = half(inputs_10[int(15)]);
    vector_4[int(16)] = half(inputs_10[int(16)]);
    vector_4[int(17)] = half(inputs_10[int(17)]);
    vector_4[int(18)] = half(inputs_10[int(18)]);
    vector_4[int(19)] = half(inputs_10[int(19)]);
    vector_4[int(20)] = half(inputs_10[int(20)]);
    vector_4[int(21)] = half(inputs_10[int(21)]);
    vector_4[int(22)] = half(inputs_10[int(22)]);
    vector_4[int(23)] = half(inputs_10[int(23)]);
    vector_4[int(24)] = half(inputs_10[int(24)]);
    vector_4[int(25)] = half(inputs_10[int(25)]);
    vector_4[int(26)] = half(inputs_10[int(26)]);
    vector_4[int(27)] = half(inputs_10[int(27)]);
    vector_4[int(28)] = half(inputs_10[int(28)]);
    vector_4[int(29)] = half(inputs_10[int(29)]);
    vector_4[int(30)] = half(inputs_10[int(30)]);
    vector_4[int(31)] = half(inputs_10[int(31)]);
    vector_4[int(32)] = half(inputs_10[int(32)]);
    vector_4[int(33)] = half(inputs_10[int(33)]);
    vector_4[int(34)] = half(inputs_10[int(34)]);
    vector_4[int(35)] = half(inputs_10[int(35)]);
    vector_4[int(36)] = half(inputs_10[int(36)]);
    vector_4[int(37)] = half(inputs_10[int(37)]);
    vector_4[int(38)] = half(inputs_10[int(38)]);
    vector_4[int(39)] = half(inputs_10[int(39)]);
    vector_4[int(40)] = half(inputs_10[int(40)]);
    vector_4[int(41)] = half(inputs_10[int(41)]);
    vector_4[int(42)] = half(inputs_10[int(42)]);
    vector_4[int(43)] = half(inputs_10[int(43)]);
    vector_4[int(44)] = half(inputs_10[int(44)]);
    vector_4[int(45)] = half(inputs_10[int(45)]);
    vector_4[int(46)] = half(inputs_10[int(46)]);
    vector_4[int(47)] = half(inputs_10[int(47)]);
    vector_4[int(48)] = half(inputs_10[int(48)]);
    vector_4[int(49)] = half(inputs_10[int(49)]);
    vector_4[int(50)] = half(inputs_10[int(50)]);
    vector_4[int(51)] = half(inputs_10[int(51)]);
    vector_4[int(52)] = half(inputs_10[int(52)]);
    vector_4[int(53)] = half(inputs_10[int(53)]);
    vector_4[int(54)] = half(inputs_10[int(54)]);
    vector_4[int(55)] = half(inputs_10[int(55)]);
    vector_4[int(56)] = half(inputs_10[int(56)]);
    vector_4[int(57)] = half(inputs_10[int(57)]);
    vector_4[int(58)] = half(inputs_10[int(58)]);
    vector_4[int(59)] = half(inputs_10[int(59)]);
    vector_4[int(60)] = half(inputs_10[int(60)]);
    vector_4[int(61)] = half(inputs_10[int(61)]);
    vector_4[int(62)] = half(inputs_10[int(62)]);
    vector_4[int(63)] = half(inputs_10[int(63)]);
    vector_4[int(64)] = half(inputs_10[int(64)]);
    vector_4[int(65)] = half(inputs_10[int(65)]);
    vector_4[int(66)] = half(inputs_10[int(66)]);
    vector_4[int(67)] = half(inputs_10[int(67)]);
    vector_4[int(68)] = half(inputs_10[int(68)]);
    vector_4[int(69)] = half(inputs_10[int(69)]);
    vector_4[int(70)] = half(inputs_10[int(70)]);
    vector_4[int(71)] = half(inputs_10[int(71)]);
    vector_4[int(72)] = half(inputs_10[int(72)]);
    vector_4[int(73)] = half(inputs_10[int(73)]);
    vector_4[int(74)] = half(inputs_10[int(74)]);
    vector_4[int(75)] = half(inputs_10[int(75)]);
    vector_4[int(76)] = half(inputs_10[int(76)]);
    vector_4[int(77)] = half(inputs_10[int(77)]);
    vector_4[int(78)] = half(inputs_10[int(78)]);
    vector_4[int(79)] = half(inputs_10[int(79)]);
    vector_4[int(80)] = half(inputs_10[int(80)]);
    vector_4[int(81)] = half(inputs_10[int(81)]);
    vector_4[int(82)] = half(inputs_10[int(82)]);
    vector_4[int(83)] = half(inputs_10[int(83)]);
    vector_4[int(84)] = half(inputs_10[int(84)]);
    vector_4[int(85)] = half(inputs_10[int(85)]);
    vector_4[int(86)] = half(inputs_10[int(86)]);
    vector_4[int(87)] = half(inputs_10[int(87)]);
    vector_4[int(88)] = half(inputs_10[int(88)]);
    vector_4[int(89)] = half(inputs_10[int(89)]);
    vector_4[int(90)] = half(inputs_10[int(90)]);
    vector_4[int(91)] = half(inputs_10[int(91)]);
    vector_4[int(92)] = half(inputs_10[int(92)]);
    vector_4[int(93)] = half(inputs_10[int(93)]);
    vector_4[int(94)] = half(inputs_10[int(94)]);
    vector_4[int(95)] = half(inputs_10[int(95)]);
    vector<half,96> _S279 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(96), int(96), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(96), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_10, first_11 + uint(whole_parts_0(int(12))))), 192U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_10, first_11)), vector_4);
    float _S280 = float(_S279[int(0)]);
    float _S281;
    if(adds_9)
    {
        _S281 = outputs_9[int(0)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(0)] = LeakyRelu_apply_0(_S280 + _S281);
    float _S282 = float(_S279[int(1)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(1)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(1)] = LeakyRelu_apply_0(_S282 + _S281);
    float _S283 = float(_S279[int(2)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(2)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(2)] = LeakyRelu_apply_0(_S283 + _S281);
    float _S284 = float(_S279[int(3)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(3)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(3)] = LeakyRelu_apply_0(_S284 + _S281);
    float _S285 = float(_S279[int(4)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(4)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(4)] = LeakyRelu_apply_0(_S285 + _S281);
    float _S286 = float(_S279[int(5)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(5)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(5)] = LeakyRelu_apply_0(_S286 + _S281);
    float _S287 = float(_S279[int(6)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(6)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(6)] = LeakyRelu_apply_0(_S287 + _S281);
    float _S288 = float(_S279[int(7)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(7)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(7)] = LeakyRelu_apply_0(_S288 + _S281);
    float _S289 = float(_S279[int(8)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(8)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(8)] = LeakyRelu_apply_0(_S289 + _S281);
    float _S290 = float(_S279[int(9)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(9)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(9)] = LeakyRelu_apply_0(_S290 + _S281);
    float _S291 = float(_S279[int(10)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(10)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(10)] = LeakyRelu_apply_0(_S291 + _S281);
    float _S292 = float(_S279[int(11)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(11)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(11)] = LeakyRelu_apply_0(_S292 + _S281);
    float _S293 = float(_S279[int(12)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(12)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(12)] = LeakyRelu_apply_0(_S293 + _S281);
    float _S294 = float(_S279[int(13)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(13)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(13)] = LeakyRelu_apply_0(_S294 + _S281);
    float _S295 = float(_S279[int(14)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(14)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(14)] = LeakyRelu_apply_0(_S295 + _S281);
    float _S296 = float(_S279[int(15)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(15)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(15)] = LeakyRelu_apply_0(_S296 + _S281);
    float _S297 = float(_S279[int(16)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(16)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(16)] = LeakyRelu_apply_0(_S297 + _S281);
    float _S298 = float(_S279[int(17)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(17)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(17)] = LeakyRelu_apply_0(_S298 + _S281);
    float _S299 = float(_S279[int(18)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(18)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(18)] = LeakyRelu_apply_0(_S299 + _S281);
    float _S300 = float(_S279[int(19)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(19)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(19)] = LeakyRelu_apply_0(_S300 + _S281);
    float _S301 = float(_S279[int(20)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(20)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(20)] = LeakyRelu_apply_0(_S301 + _S281);
    float _S302 = float(_S279[int(21)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(21)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(21)] = LeakyRelu_apply_0(_S302 + _S281);
    float _S303 = float(_S279[int(22)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(22)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(22)] = LeakyRelu_apply_0(_S303 + _S281);
    float _S304 = float(_S279[int(23)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(23)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(23)] = LeakyRelu_apply_0(_S304 + _S281);
    float _S305 = float(_S279[int(24)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(24)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(24)] = LeakyRelu_apply_0(_S305 + _S281);
    float _S306 = float(_S279[int(25)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(25)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(25)] = LeakyRelu_apply_0(_S306 + _S281);
    float _S307 = float(_S279[int(26)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(26)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(26)] = LeakyRelu_apply_0(_S307 + _S281);
    float _S308 = float(_S279[int(27)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(27)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(27)] = LeakyRelu_apply_0(_S308 + _S281);
    float _S309 = float(_S279[int(28)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(28)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(28)] = LeakyRelu_apply_0(_S309 + _S281);
    float _S310 = float(_S279[int(29)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(29)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(29)] = LeakyRelu_apply_0(_S310 + _S281);
    float _S311 = float(_S279[int(30)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(30)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(30)] = LeakyRelu_apply_0(_S311 + _S281);
    float _S312 = float(_S279[int(31)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(31)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(31)] = LeakyRelu_apply_0(_S312 + _S281);
    float _S313 = float(_S279[int(32)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(32)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(32)] = LeakyRelu_apply_0(_S313 + _S281);
    float _S314 = float(_S279[int(33)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(33)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(33)] = LeakyRelu_apply_0(_S314 + _S281);
    float _S315 = float(_S279[int(34)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(34)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(34)] = LeakyRelu_apply_0(_S315 + _S281);
    float _S316 = float(_S279[int(35)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(35)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(35)] = LeakyRelu_apply_0(_S316 + _S281);
    float _S317 = float(_S279[int(36)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(36)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(36)] = LeakyRelu_apply_0(_S317 + _S281);
    float _S318 = float(_S279[int(37)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(37)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(37)] = LeakyRelu_apply_0(_S318 + _S281);
    float _S319 = float(_S279[int(38)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(38)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(38)] = LeakyRelu_apply_0(_S319 + _S281);
    float _S320 = float(_S279[int(39)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(39)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(39)] = LeakyRelu_apply_0(_S320 + _S281);
    float _S321 = float(_S279[int(40)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(40)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(40)] = LeakyRelu_apply_0(_S321 + _S281);
    float _S322 = float(_S279[int(41)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(41)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(41)] = LeakyRelu_apply_0(_S322 + _S281);
    float _S323 = float(_S279[int(42)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(42)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(42)] = LeakyRelu_apply_0(_S323 + _S281);
    float _S324 = float(_S279[int(43)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(43)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(43)] = LeakyRelu_apply_0(_S324 + _S281);
    float _S325 = float(_S279[int(44)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(44)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(44)] = LeakyRelu_apply_0(_S325 + _S281);
    float _S326 = float(_S279[int(45)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(45)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(45)] = LeakyRelu_apply_0(_S326 + _S281);
    float _S327 = float(_S279[int(46)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(46)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(46)] = LeakyRelu_apply_0(_S327 + _S281);
    float _S328 = float(_S279[int(47)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(47)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(47)] = LeakyRelu_apply_0(_S328 + _S281);
    float _S329 = float(_S279[int(48)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(48)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(48)] = LeakyRelu_apply_0(_S329 + _S281);
    float _S330 = float(_S279[int(49)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(49)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(49)] = LeakyRelu_apply_0(_S330 + _S281);
    float _S331 = float(_S279[int(50)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(50)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(50)] = LeakyRelu_apply_0(_S331 + _S281);
    float _S332 = float(_S279[int(51)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(51)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(51)] = LeakyRelu_apply_0(_S332 + _S281);
    float _S333 = float(_S279[int(52)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(52)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(52)] = LeakyRelu_apply_0(_S333 + _S281);
    float _S334 = float(_S279[int(53)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(53)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(53)] = LeakyRelu_apply_0(_S334 + _S281);
    float _S335 = float(_S279[int(54)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(54)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(54)] = LeakyRelu_apply_0(_S335 + _S281);
    float _S336 = float(_S279[int(55)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(55)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(55)] = LeakyRelu_apply_0(_S336 + _S281);
    float _S337 = float(_S279[int(56)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(56)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(56)] = LeakyRelu_apply_0(_S337 + _S281);
    float _S338 = float(_S279[int(57)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(57)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(57)] = LeakyRelu_apply_0(_S338 + _S281);
    float _S339 = float(_S279[int(58)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(58)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(58)] = LeakyRelu_apply_0(_S339 + _S281);
    float _S340 = float(_S279[int(59)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(59)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(59)] = LeakyRelu_apply_0(_S340 + _S281);
    float _S341 = float(_S279[int(60)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(60)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(60)] = LeakyRelu_apply_0(_S341 + _S281);
    float _S342 = float(_S279[int(61)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(61)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(61)] = LeakyRelu_apply_0(_S342 + _S281);
    float _S343 = float(_S279[int(62)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(62)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(62)] = LeakyRelu_apply_0(_S343 + _S281);
    float _S344 = float(_S279[int(63)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(63)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(63)] = LeakyRelu_apply_0(_S344 + _S281);
    float _S345 = float(_S279[int(64)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(64)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(64)] = LeakyRelu_apply_0(_S345 + _S281);
    float _S346 = float(_S279[int(65)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(65)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(65)] = LeakyRelu_apply_0(_S346 + _S281);
    float _S347 = float(_S279[int(66)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(66)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(66)] = LeakyRelu_apply_0(_S347 + _S281);
    float _S348 = float(_S279[int(67)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(67)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(67)] = LeakyRelu_apply_0(_S348 + _S281);
    float _S349 = float(_S279[int(68)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(68)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(68)] = LeakyRelu_apply_0(_S349 + _S281);
    float _S350 = float(_S279[int(69)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(69)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(69)] = LeakyRelu_apply_0(_S350 + _S281);
    float _S351 = float(_S279[int(70)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(70)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(70)] = LeakyRelu_apply_0(_S351 + _S281);
    float _S352 = float(_S279[int(71)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(71)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(71)] = LeakyRelu_apply_0(_S352 + _S281);
    float _S353 = float(_S279[int(72)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(72)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(72)] = LeakyRelu_apply_0(_S353 + _S281);
    float _S354 = float(_S279[int(73)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(73)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(73)] = LeakyRelu_apply_0(_S354 + _S281);
    float _S355 = float(_S279[int(74)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(74)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(74)] = LeakyRelu_apply_0(_S355 + _S281);
    float _S356 = float(_S279[int(75)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(75)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(75)] = LeakyRelu_apply_0(_S356 + _S281);
    float _S357 = float(_S279[int(76)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(76)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(76)] = LeakyRelu_apply_0(_S357 + _S281);
    float _S358 = float(_S279[int(77)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(77)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(77)] = LeakyRelu_apply_0(_S358 + _S281);
    float _S359 = float(_S279[int(78)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(78)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(78)] = LeakyRelu_apply_0(_S359 + _S281);
    float _S360 = float(_S279[int(79)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(79)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(79)] = LeakyRelu_apply_0(_S360 + _S281);
    float _S361 = float(_S279[int(80)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(80)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(80)] = LeakyRelu_apply_0(_S361 + _S281);
    float _S362 = float(_S279[int(81)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(81)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(81)] = LeakyRelu_apply_0(_S362 + _S281);
    float _S363 = float(_S279[int(82)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(82)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(82)] = LeakyRelu_apply_0(_S363 + _S281);
    float _S364 = float(_S279[int(83)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(83)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(83)] = LeakyRelu_apply_0(_S364 + _S281);
    float _S365 = float(_S279[int(84)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(84)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(84)] = LeakyRelu_apply_0(_S365 + _S281);
    float _S366 = float(_S279[int(85)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(85)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(85)] = LeakyRelu_apply_0(_S366 + _S281);
    float _S367 = float(_S279[int(86)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(86)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(86)] = LeakyRelu_apply_0(_S367 + _S281);
    float _S368 = float(_S279[int(87)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(87)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(87)] = LeakyRelu_apply_0(_S368 + _S281);
    float _S369 = float(_S279[int(88)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(88)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(88)] = LeakyRelu_apply_0(_S369 + _S281);
    float _S370 = float(_S279[int(89)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(89)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(89)] = LeakyRelu_apply_0(_S370 + _S281);
    float _S371 = float(_S279[int(90)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(90)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(90)] = LeakyRelu_apply_0(_S371 + _S281);
    float _S372 = float(_S279[int(91)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(91)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(91)] = LeakyRelu_apply_0(_S372 + _S281);
    float _S373 = float(_S279[int(92)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(92)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(92)] = LeakyRelu_apply_0(_S373 + _S281);
    float _S374 = float(_S279[int(93)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(93)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(93)] = LeakyRelu_apply_0(_S374 + _S281);
    float _S375 = float(_S279[int(94)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(94)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(94)] = LeakyRelu_apply_0(_S375 + _S281);
    float _S376 = float(_S279[int(95)]);
    if(adds_9)
    {
        _S281 = outputs_9[int(95)];
    }
    else
    {
        _S281 = 0.0f;
    }
    outputs_9[int(95)] = LeakyRelu_apply_0(_S376 + _S281);
    return;
}

void dense_part_5(HalfWeights_0 weights_11, uint first_12, bool adds_10, inout float  inputs_11[int(96)], inout float  outputs_10[int(96)])
{
    cooperative_part_4(weights_11, first_12, adds_10, inputs_11, outputs_10);
    return;
}

void cooperative_part_5(HalfWeights_0 weights_12, uint first_13, bool adds_11, inout float  inputs_12[int(100)], inout float  outputs_11[int(16)])
{
    vector<half,100> _S377;
    (_S377) = (0.0);
    vector<half,100> vector_5;
    vector_5 = (_S377);
    vector_5[int(0)] = half(inputs_12[int(0)]);
    vector_5[int(1)] = half(inputs_12[int(1)]);
    vector_5[int(2)] = half(inputs_12[int(2)]);
    vector_5[int(3)] = half(inputs_12[int(3)]);
    vector_5[int(4)] = half(inputs_12[int(4)]);
    vector_5[int(5)] = half(inputs_12[int(5)]);
    vector_5[int(6)] = half(inputs_12[int(6)]);
    vector_5[int(7)] = half(inputs_12[int(7)]);
    vector_5[int(8)] = half(inputs_12[int(8)]);
    vector_5[int(9)] = half(inputs_12[int(9)]);
    vector_5[int(10)] = half(inputs_12[int(10)]);
    vector_5[int(11)] = half(inputs_12[int(11)]);
    vector_5[int(12)] = half(inputs_12[int(12)]);
    vector_5[int(13)] = half(inputs_12[int(13)]);
    vector_5[int(14)] = half(inputs_12[int(14)]);
    vector_5[int(15)] = half(inputs_12[int(15)]);
    vector_5[int(16)] = half(inputs_12[int(16)]);
    vector_5[int(17)] = half(inputs_12[int(17)]);
    vector_5[int(18)] = half(inputs_12[int(18)]);
    vector_5[int(19)] = half(inputs_12[int(19)]);
    vector_5[int(20)] = half(inputs_12[int(20)]);
    vector_5[int(21)] = half(inputs_12[int(21)]);
    vector_5[int(22)] = half(inputs_12[int(22)]);
    vector_5[int(23)] = half(inputs_12[int(23)]);
    vector_5[int(24)] = half(inputs_12[int(24)]);
    vector_5[int(25)] = half(inputs_12[int(25)]);
    vector_5[int(26)] = half(inputs_12[int(26)]);
    vector_5[int(27)] = half(inputs_12[int(27)]);
    vector_5[int(28)] = half(inputs_12[int(28)]);
    vector_5[int(29)] = half(inputs_12[int(29)]);
    vector_5[int(30)] = half(inputs_12[int(30)]);
    vector_5[int(31)] = half(inputs_12[int(31)]);
    vector_5[int(32)] = half(inputs_12[int(32)]);
    vector_5[int(33)] = half(inputs_12[int(33)]);
    vector_5[int(34)] = half(inputs_12[int(34)]);
    vector_5[int(35)] = half(inputs_12[int(35)]);
    vector_5[int(36)] = half(inputs_12[int(36)]);
    vector_5[int(37)] = half(inputs_12[int(37)]);
    vector_5[int(38)] = half(inputs_12[int(38)]);
    vector_5[int(39)] = half(inputs_12[int(39)]);
    vector_5[int(40)] = half(inputs_12[int(40)]);
    vector_5[int(41)] = half(inputs_12[int(41)]);
    vector_5[int(42)] = half(inputs_12[int(42)]);
    vector_5[int(43)] = half(inputs_12[int(43)]);
    vector_5[int(44)] = half(inputs_12[int(44)]);
    vector_5[int(45)] = half(inputs_12[int(45)]);
    vector_5[int(46)] = half(inputs_12[int(46)]);
    vector_5[int(47)] = half(inputs_12[int(47)]);
    vector_5[int(48)] = half(inputs_12[int(48)]);
    vector_5[int(49)] = half(inputs_12[int(49)]);
    vector_5[int(50)] = half(inputs_12[int(50)]);
    vector_5[int(51)] = half(inputs_12[int(51)]);
    vector_5[int(52)] = half(inputs_12[int(52)]);
    vector_5[int(53)] = half(inputs_12[int(53)]);
    vector_5[int(54)] = half(inputs_12[int(54)]);
    vector_5[int(55)] = half(inputs_12[int(55)]);
    vector_5[int(56)] = half(inputs_12[int(56)]);
    vector_5[int(57)] = half(inputs_12[int(57)]);
    vector_5[int(58)] = half(inputs_12[int(58)]);
    vector_5[int(59)] = half(inputs_12[int(59)]);
    vector_5[int(60)] = half(inputs_12[int(60)]);
    vector_5[int(61)] = half(inputs_12[int(61)]);
    vector_5[int(62)] = half(inputs_12[int(62)]);
    vector_5[int(63)] = half(inputs_12[int(63)]);
    vector_5[int(64)] = half(inputs_12[int(64)]);
    vector_5[int(65)] = half(inputs_12[int(65)]);
    vector_5[int(66)] = half(inputs_12[int(66)]);
    vector_5[int(67)] = half(inputs_12[int(67)]);
    vector_5[int(68)] = half(inputs_12[int(68)]);
    vector_5[int(69)] = half(inputs_12[int(69)]);
    vector_5[int(70)] = half(inputs_12[int(70)]);
    vector_5[int(71)] = half(inputs_12[int(71)]);
    vector_5[int(72)] = half(inputs_12[int(72)]);
    vector_5[int(73)] = half(inputs_12[int(73)]);
    vector_5[int(74)] = half(inputs_12[int(74)]);
    vector_5[int(75)] = half(inputs_12[int(75)]);
    vector_5[int(76)] = half(inputs_12[int(76)]);
    vector_5[int(77)] = half(inputs_12[int(77)]);
    vector_5[int(78)] = half(inputs_12[int(78)]);
    vector_5[int(79)] = half(inputs_12[int(79)]);
    vector_5[int(80)] = half(inputs_12[int(80)]);
    vector_5[int(81)] = half(inputs_12[int(81)]);
    vector_5[int(82)] = half(inputs_12[int(82)]);
    vector_5[int(83)] = half(inputs_12[int(83)]);
    vector_5[int(84)] = half(inputs_12[int(84)]);
    vector_5[int(85)] = half(inputs_12[int(85)]);
    vector_5[int(86)] = half(inputs_12[int(86)]);
    vector_5[int(87)] = half(inputs_12[int(87)]);
    vector_5[int(88)] = half(inputs_12[int(88)]);
    vector_5[int(89)] = half(inputs_12[int(89)]);
    vector_5[int(90)] = half(inputs_12[int(90)]);
    vector_5[int(91)] = half(inputs_12[int(91)]);
    vector_5[int(92)] = half(inputs_12[int(92)]);
    vector_5[int(93)] = half(inputs_12[int(93)]);
    vector_5[int(94)] = half(inputs_12[int(94)]);
    vector_5[int(95)] = half(inputs_12[int(95)]);
    vector_5[int(96)] = half(inputs_12[int(96)]);
    vector_5[int(97)] = half(inputs_12[int(97)]);
    vector_5[int(98)] = half(inputs_12[int(98)]);
    vector_5[int(99)] = half(inputs_12[int(99)]);
    vector<half,16> _S378 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(16), int(100), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(100), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_12, first_13 + uint(whole_parts_0(int(2))))), 208U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_12, first_13)), vector_5);
    float _S379 = float(_S378[int(0)]);
    float _S380;
    if(adds_11)
    {
        _S380 = outputs_11[int(0)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(0)] = LeakyRelu_apply_0(_S379 + _S380);
    float _S381 = float(_S378[int(1)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(1)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(1)] = LeakyRelu_apply_0(_S381 + _S380);
    float _S382 = float(_S378[int(2)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(2)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(2)] = LeakyRelu_apply_0(_S382 + _S380);
    float _S383 = float(_S378[int(3)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(3)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(3)] = LeakyRelu_apply_0(_S383 + _S380);
    float _S384 = float(_S378[int(4)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(4)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(4)] = LeakyRelu_apply_0(_S384 + _S380);
    float _S385 = float(_S378[int(5)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(5)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(5)] = LeakyRelu_apply_0(_S385 + _S380);
    float _S386 = float(_S378[int(6)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(6)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(6)] = LeakyRelu_apply_0(_S386 + _S380);
    float _S387 = float(_S378[int(7)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(7)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(7)] = LeakyRelu_apply_0(_S387 + _S380);
    float _S388 = float(_S378[int(8)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(8)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(8)] = LeakyRelu_apply_0(_S388 + _S380);
    float _S389 = float(_S378[int(9)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(9)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(9)] = LeakyRelu_apply_0(_S389 + _S380);
    float _S390 = float(_S378[int(10)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(10)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(10)] = LeakyRelu_apply_0(_S390 + _S380);
    float _S391 = float(_S378[int(11)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(11)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(11)] = LeakyRelu_apply_0(_S391 + _S380);
    float _S392 = float(_S378[int(12)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(12)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(12)] = LeakyRelu_apply_0(_S392 + _S380);
    float _S393 = float(_S378[int(13)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(13)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(13)] = LeakyRelu_apply_0(_S393 + _S380);
    float _S394 = float(_S378[int(14)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(14)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(14)] = LeakyRelu_apply_0(_S394 + _S380);
    float _S395 = float(_S378[int(15)]);
    if(adds_11)
    {
        _S380 = outputs_11[int(15)];
    }
    else
    {
        _S380 = 0.0f;
    }
    outputs_11[int(15)] = LeakyRelu_apply_0(_S395 + _S380);
    return;
}

void dense_part_6(HalfWeights_0 weights_13, uint first_14, bool adds_12, inout float  inputs_13[int(100)], inout float  outputs_12[int(16)])
{
    cooperative_part_5(weights_13, first_14, adds_12, inputs_13, outputs_12);
    return;
}

void cooperative_part_6(HalfWeights_0 weights_14, uint first_15, bool adds_13, inout float  inputs_14[int(96)], inout float  outputs_13[int(100)])
{
    vector<half,96> _S396;
    (_S396) = (0.0);
    vector<half,96> vector_6;
    vector_6 = (_S396);
    vector_6[int(0)] = half(inputs_14[int(0)]);
    vector_6[int(1)] = half(inputs_14[int(1)]);
    vector_6[int(2)] = half(inputs_14[int(2)]);
    vector_6[int(3)] = half(inputs_14[int(3)]);
    vector_6[int(4)] = half(inputs_14[int(4)]);
    vector_6[int(5)] = half(inputs_14[int(5)]);
    vector_6[int(6)] = half(inputs_14[int(6)]);
    vector_6[int(7)] = half(inputs_14[int(7)]);
    vector_6[int(8)] = half(inputs_14[int(8)]);
    vector_6[int(9)] = half(inputs_14[int(9)]);
    vector_6[int(10)] = half(inputs_14[int(10)]);
    vector_6[int(11)] = half(inputs_14[int(11)]);
    vector_6[int(12)] = half(inputs_14[int(12)]);
    vector_6[int(13)] = half(inputs_14[int(13)]);
    vector_6[int(14)] = half(inputs_14[int(14)]);
    vector_6[int(15)] = half(inputs_14[int(15)]);
    vector_6[int(16)] = half(inputs_14[int(16)]);
    vector_6[int(17)] = half(inputs_14[int(17)]);
    vector_6[int(18)] = half(inputs_14[int(18)]);
    vector_6[int(19)] = half(inputs_14[int(19)]);
    vector_6[int(20)] = half(inputs_14[int(20)]);
    vector_6[int(21)] = half(inputs_14[int(21)]);
    vector_6[int(22)] = half(inputs_14[int(22)]);
    vector_6[int(23)] = half(inputs_14[int(23)]);
    vector_6[int(24)] = half(inputs_14[int(24)]);
    vector_6[int(25)] = half(inputs_14[int(25)]);
    vector_6[int(26)] = half(inputs_14[int(26)]);
    vector_6[int(27)] = half(inputs_14[int(27)]);
    vector_6[int(28)] = half(inputs_14[int(28)]);
    vector_6[int(29)] = half(inputs_14[int(29)]);
    vector_6[int(30)] = half(inputs_14[int(30)]);
    vector_6[int(31)] = half(inputs_14[int(31)]);
    vector_6[int(32)] = half(inputs_14[int(32)]);
    vector_6[int(33)] = half(inputs_14[int(33)]);
    vector_6[int(34)] = half(inputs_14[int(34)]);
    vector_6[int(35)] = half(inputs_14[int(35)]);
    vector_6[int(36)] = half(inputs_14[int(36)]);
    vector_6[int(37)] = half(inputs_14[int(37)]);
    vector_6[int(38)] = half(inputs_14[int(38)]);
    vector_6[int(39)] = half(inputs_14[int(39)]);
    vector_6[int(40)] = half(inputs_14[int(40)]);
    vector_6[int(41)] = half(inputs_14[int(41)]);
    vector_6[int(42)] = half(inputs_14[int(42)]);
    vector_6[int(43)] = half(inputs_14[int(43)]);
    vector_6[int(44)] = half(inputs_14[int(44)]);
    vector_6[int(45)] = half(inputs_14[int(45)]);
    vector_6[int(46)] = half(inputs_14[int(46)]);
    vector_6[int(47)] = half(inputs_14[int(47)]);
    vector_6[int(48)] = half(inputs_14[int(48)]);
    vector_6[int(49)] = half(inputs_14[int(49)]);
    vector_6[int(50)] = half(inputs_14[int(50)]);
    vector_6[int(51)] = half(inputs_14[int(51)]);
    vector_6[int(52)] = half(inputs_14[int(52)]);
    vector_6[int(53)] = half(inputs_14[int(53)]);
    vector_6[int(54)] = half(inputs_14[int(54)]);
    vector_6[int(55)] = half(inputs_14[int(55)]);
    vector_6[int(56)] = half(inputs_14[int(56)]);
    vector_6[int(57)] = half(inputs_14[int(57)]);
    vector_6[int(58)] = half(inputs_14[int(58)]);
    vector_6[int(59)] = half(inputs_14[int(59)]);
    vector_6[int(60)] = half(inputs_14[int(60)]);
    vector_6[int(61)] = half(inputs_14[int(61)]);
    vector_6[int(62)] = half(inputs_14[int(62)]);
    vector_6[int(63)] = half(inputs_14[int(63)]);
    vector_6[int(64)] = half(inputs_14[int(64)]);
    vector_6[int(65)] = half(inputs_14[int(65)]);
    vector_6[int(66)] = half(inputs_14[int(66)]);
    vector_6[int(67)] = half(inputs_14[int(67)]);
    vector_6[int(68)] = half(inputs_14[int(68)]);
    vector_6[int(69)] = half(inputs_14[int(69)]);
    vector_6[int(70)] = half(inputs_14[int(70)]);
    vector_6[int(71)] = half(inputs_14[int(71)]);
    vector_6[int(72)] = half(inputs_14[int(72)]);
    vector_6[int(73)] = half(inputs_14[int(73)]);
    vector_6[int(74)] = half(inputs_14[int(74)]);
    vector_6[int(75)] = half(inputs_14[int(75)]);
    vector_6[int(76)] = half(inputs_14[int(76)]);
    vector_6[int(77)] = half(inputs_14[int(77)]);
    vector_6[int(78)] = half(inputs_14[int(78)]);
    vector_6[int(79)] = half(inputs_14[int(79)]);
    vector_6[int(80)] = half(inputs_14[int(80)]);
    vector_6[int(81)] = half(inputs_14[int(81)]);
    vector_6[int(82)] = half(inputs_14[int(82)]);
    vector_6[int(83)] = half(inputs_14[int(83)]);
    vector_6[int(84)] = half(inputs_14[int(84)]);
    vector_6[int(85)] = half(inputs_14[int(85)]);
    vector_6[int(86)] = half(inputs_14[int(86)]);
    vector_6[int(87)] = half(inputs_14[int(87)]);
    vector_6[int(88)] = half(inputs_14[int(88)]);
    vector_6[int(89)] = half(inputs_14[int(89)]);
    vector_6[int(90)] = half(inputs_14[int(90)]);
    vector_6[int(91)] = half(inputs_14[int(91)]);
    vector_6[int(92)] = half(inputs_14[int(92)]);
    vector_6[int(93)] = half(inputs_14[int(93)]);
    vector_6[int(94)] = half(inputs_14[int(94)]);
    vector_6[int(95)] = half(inputs_14[int(95)]);
    vector<half,96> _S397 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(96), int(96), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(96), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_14, first_15 + uint(whole_parts_0(int(12))))), 192U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_14, first_15)), vector_6);
    float _S398 = float(_S397[int(0)]);
    float _S399;
    if(adds_13)
    {
        _S399 = outputs_13[int(0)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(0)] = LeakyRelu_apply_0(_S398 + _S399);
    float _S400 = float(_S397[int(1)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(1)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(1)] = LeakyRelu_apply_0(_S400 + _S399);
    float _S401 = float(_S397[int(2)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(2)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(2)] = LeakyRelu_apply_0(_S401 + _S399);
    float _S402 = float(_S397[int(3)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(3)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(3)] = LeakyRelu_apply_0(_S402 + _S399);
    float _S403 = float(_S397[int(4)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(4)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(4)] = LeakyRelu_apply_0(_S403 + _S399);
    float _S404 = float(_S397[int(5)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(5)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(5)] = LeakyRelu_apply_0(_S404 + _S399);
    float _S405 = float(_S397[int(6)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(6)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(6)] = LeakyRelu_apply_0(_S405 + _S399);
    float _S406 = float(_S397[int(7)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(7)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(7)] = LeakyRelu_apply_0(_S406 + _S399);
    float _S407 = float(_S397[int(8)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(8)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(8)] = LeakyRelu_apply_0(_S407 + _S399);
    float _S408 = float(_S397[int(9)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(9)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(9)] = LeakyRelu_apply_0(_S408 + _S399);
    float _S409 = float(_S397[int(10)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(10)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(10)] = LeakyRelu_apply_0(_S409 + _S399);
    float _S410 = float(_S397[int(11)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(11)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(11)] = LeakyRelu_apply_0(_S410 + _S399);
    float _S411 = float(_S397[int(12)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(12)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(12)] = LeakyRelu_apply_0(_S411 + _S399);
    float _S412 = float(_S397[int(13)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(13)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(13)] = LeakyRelu_apply_0(_S412 + _S399);
    float _S413 = float(_S397[int(14)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(14)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(14)] = LeakyRelu_apply_0(_S413 + _S399);
    float _S414 = float(_S397[int(15)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(15)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(15)] = LeakyRelu_apply_0(_S414 + _S399);
    float _S415 = float(_S397[int(16)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(16)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(16)] = LeakyRelu_apply_0(_S415 + _S399);
    float _S416 = float(_S397[int(17)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(17)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(17)] = LeakyRelu_apply_0(_S416 + _S399);
    float _S417 = float(_S397[int(18)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(18)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(18)] = LeakyRelu_apply_0(_S417 + _S399);
    float _S418 = float(_S397[int(19)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(19)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(19)] = LeakyRelu_apply_0(_S418 + _S399);
    float _S419 = float(_S397[int(20)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(20)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(20)] = LeakyRelu_apply_0(_S419 + _S399);
    float _S420 = float(_S397[int(21)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(21)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(21)] = LeakyRelu_apply_0(_S420 + _S399);
    float _S421 = float(_S397[int(22)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(22)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(22)] = LeakyRelu_apply_0(_S421 + _S399);
    float _S422 = float(_S397[int(23)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(23)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(23)] = LeakyRelu_apply_0(_S422 + _S399);
    float _S423 = float(_S397[int(24)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(24)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(24)] = LeakyRelu_apply_0(_S423 + _S399);
    float _S424 = float(_S397[int(25)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(25)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(25)] = LeakyRelu_apply_0(_S424 + _S399);
    float _S425 = float(_S397[int(26)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(26)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(26)] = LeakyRelu_apply_0(_S425 + _S399);
    float _S426 = float(_S397[int(27)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(27)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(27)] = LeakyRelu_apply_0(_S426 + _S399);
    float _S427 = float(_S397[int(28)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(28)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(28)] = LeakyRelu_apply_0(_S427 + _S399);
    float _S428 = float(_S397[int(29)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(29)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(29)] = LeakyRelu_apply_0(_S428 + _S399);
    float _S429 = float(_S397[int(30)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(30)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(30)] = LeakyRelu_apply_0(_S429 + _S399);
    float _S430 = float(_S397[int(31)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(31)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(31)] = LeakyRelu_apply_0(_S430 + _S399);
    float _S431 = float(_S397[int(32)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(32)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(32)] = LeakyRelu_apply_0(_S431 + _S399);
    float _S432 = float(_S397[int(33)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(33)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(33)] = LeakyRelu_apply_0(_S432 + _S399);
    float _S433 = float(_S397[int(34)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(34)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(34)] = LeakyRelu_apply_0(_S433 + _S399);
    float _S434 = float(_S397[int(35)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(35)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(35)] = LeakyRelu_apply_0(_S434 + _S399);
    float _S435 = float(_S397[int(36)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(36)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(36)] = LeakyRelu_apply_0(_S435 + _S399);
    float _S436 = float(_S397[int(37)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(37)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(37)] = LeakyRelu_apply_0(_S436 + _S399);
    float _S437 = float(_S397[int(38)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(38)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(38)] = LeakyRelu_apply_0(_S437 + _S399);
    float _S438 = float(_S397[int(39)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(39)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(39)] = LeakyRelu_apply_0(_S438 + _S399);
    float _S439 = float(_S397[int(40)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(40)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(40)] = LeakyRelu_apply_0(_S439 + _S399);
    float _S440 = float(_S397[int(41)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(41)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(41)] = LeakyRelu_apply_0(_S440 + _S399);
    float _S441 = float(_S397[int(42)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(42)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(42)] = LeakyRelu_apply_0(_S441 + _S399);
    float _S442 = float(_S397[int(43)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(43)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(43)] = LeakyRelu_apply_0(_S442 + _S399);
    float _S443 = float(_S397[int(44)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(44)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(44)] = LeakyRelu_apply_0(_S443 + _S399);
    float _S444 = float(_S397[int(45)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(45)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(45)] = LeakyRelu_apply_0(_S444 + _S399);
    float _S445 = float(_S397[int(46)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(46)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(46)] = LeakyRelu_apply_0(_S445 + _S399);
    float _S446 = float(_S397[int(47)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(47)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(47)] = LeakyRelu_apply_0(_S446 + _S399);
    float _S447 = float(_S397[int(48)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(48)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(48)] = LeakyRelu_apply_0(_S447 + _S399);
    float _S448 = float(_S397[int(49)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(49)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(49)] = LeakyRelu_apply_0(_S448 + _S399);
    float _S449 = float(_S397[int(50)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(50)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(50)] = LeakyRelu_apply_0(_S449 + _S399);
    float _S450 = float(_S397[int(51)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(51)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(51)] = LeakyRelu_apply_0(_S450 + _S399);
    float _S451 = float(_S397[int(52)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(52)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(52)] = LeakyRelu_apply_0(_S451 + _S399);
    float _S452 = float(_S397[int(53)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(53)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(53)] = LeakyRelu_apply_0(_S452 + _S399);
    float _S453 = float(_S397[int(54)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(54)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(54)] = LeakyRelu_apply_0(_S453 + _S399);
    float _S454 = float(_S397[int(55)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(55)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(55)] = LeakyRelu_apply_0(_S454 + _S399);
    float _S455 = float(_S397[int(56)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(56)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(56)] = LeakyRelu_apply_0(_S455 + _S399);
    float _S456 = float(_S397[int(57)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(57)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(57)] = LeakyRelu_apply_0(_S456 + _S399);
    float _S457 = float(_S397[int(58)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(58)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(58)] = LeakyRelu_apply_0(_S457 + _S399);
    float _S458 = float(_S397[int(59)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(59)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(59)] = LeakyRelu_apply_0(_S458 + _S399);
    float _S459 = float(_S397[int(60)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(60)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(60)] = LeakyRelu_apply_0(_S459 + _S399);
    float _S460 = float(_S397[int(61)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(61)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(61)] = LeakyRelu_apply_0(_S460 + _S399);
    float _S461 = float(_S397[int(62)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(62)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(62)] = LeakyRelu_apply_0(_S461 + _S399);
    float _S462 = float(_S397[int(63)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(63)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(63)] = LeakyRelu_apply_0(_S462 + _S399);
    float _S463 = float(_S397[int(64)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(64)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(64)] = LeakyRelu_apply_0(_S463 + _S399);
    float _S464 = float(_S397[int(65)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(65)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(65)] = LeakyRelu_apply_0(_S464 + _S399);
    float _S465 = float(_S397[int(66)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(66)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(66)] = LeakyRelu_apply_0(_S465 + _S399);
    float _S466 = float(_S397[int(67)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(67)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(67)] = LeakyRelu_apply_0(_S466 + _S399);
    float _S467 = float(_S397[int(68)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(68)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(68)] = LeakyRelu_apply_0(_S467 + _S399);
    float _S468 = float(_S397[int(69)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(69)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(69)] = LeakyRelu_apply_0(_S468 + _S399);
    float _S469 = float(_S397[int(70)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(70)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(70)] = LeakyRelu_apply_0(_S469 + _S399);
    float _S470 = float(_S397[int(71)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(71)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(71)] = LeakyRelu_apply_0(_S470 + _S399);
    float _S471 = float(_S397[int(72)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(72)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(72)] = LeakyRelu_apply_0(_S471 + _S399);
    float _S472 = float(_S397[int(73)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(73)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(73)] = LeakyRelu_apply_0(_S472 + _S399);
    float _S473 = float(_S397[int(74)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(74)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(74)] = LeakyRelu_apply_0(_S473 + _S399);
    float _S474 = float(_S397[int(75)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(75)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(75)] = LeakyRelu_apply_0(_S474 + _S399);
    float _S475 = float(_S397[int(76)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(76)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(76)] = LeakyRelu_apply_0(_S475 + _S399);
    float _S476 = float(_S397[int(77)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(77)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(77)] = LeakyRelu_apply_0(_S476 + _S399);
    float _S477 = float(_S397[int(78)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(78)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(78)] = LeakyRelu_apply_0(_S477 + _S399);
    float _S478 = float(_S397[int(79)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(79)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(79)] = LeakyRelu_apply_0(_S478 + _S399);
    float _S479 = float(_S397[int(80)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(80)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(80)] = LeakyRelu_apply_0(_S479 + _S399);
    float _S480 = float(_S397[int(81)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(81)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(81)] = LeakyRelu_apply_0(_S480 + _S399);
    float _S481 = float(_S397[int(82)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(82)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(82)] = LeakyRelu_apply_0(_S481 + _S399);
    float _S482 = float(_S397[int(83)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(83)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(83)] = LeakyRelu_apply_0(_S482 + _S399);
    float _S483 = float(_S397[int(84)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(84)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(84)] = LeakyRelu_apply_0(_S483 + _S399);
    float _S484 = float(_S397[int(85)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(85)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(85)] = LeakyRelu_apply_0(_S484 + _S399);
    float _S485 = float(_S397[int(86)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(86)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(86)] = LeakyRelu_apply_0(_S485 + _S399);
    float _S486 = float(_S397[int(87)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(87)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(87)] = LeakyRelu_apply_0(_S486 + _S399);
    float _S487 = float(_S397[int(88)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(88)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(88)] = LeakyRelu_apply_0(_S487 + _S399);
    float _S488 = float(_S397[int(89)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(89)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(89)] = LeakyRelu_apply_0(_S488 + _S399);
    float _S489 = float(_S397[int(90)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(90)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(90)] = LeakyRelu_apply_0(_S489 + _S399);
    float _S490 = float(_S397[int(91)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(91)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(91)] = LeakyRelu_apply_0(_S490 + _S399);
    float _S491 = float(_S397[int(92)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(92)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(92)] = LeakyRelu_apply_0(_S491 + _S399);
    float _S492 = float(_S397[int(93)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(93)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(93)] = LeakyRelu_apply_0(_S492 + _S399);
    float _S493 = float(_S397[int(94)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(94)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(94)] = LeakyRelu_apply_0(_S493 + _S399);
    float _S494 = float(_S397[int(95)]);
    if(adds_13)
    {
        _S399 = outputs_13[int(95)];
    }
    else
    {
        _S399 = 0.0f;
    }
    outputs_13[int(95)] = LeakyRelu_apply_0(_S494 + _S399);
    return;
}

void cooperative_part_7(HalfWeights_0 weights_15, uint first_16, bool adds_14, inout float  inputs_15[int(88)], inout float  outputs_14[int(96)])
{
    vector<half,88> _S495;
    (_S495) = (0.0);
    vector<half,88> vector_7;
    vector_7 = (_S495);
    vector_7[int(0)] = half(inputs_15[int(0)]);
    vector_7[int(1)] = half(inputs_15[int(1)]);
    vector_7[int(2)] = half(inputs_15[int(2)]);
    vector_7[int(3)] = half(inputs_15[int(3)]);
    vector_7[int(4)] = half(inputs_15[int(4)]);
    vector_7[int(5)] = half(inputs_15[int(5)]);
    vector_7[int(6)] = half(inputs_15[int(6)]);
    vector_7[int(7)] = half(inputs_15[int(7)]);
    vector_7[int(8)] = half(inputs_15[int(8)]);
    vector_7[int(9)] = half(inputs_15[int(9)]);
    vector_7[int(10)] = half(inputs_15[int(10)]);
    vector_7[int(11)] = half(inputs_15[int(11)]);
    vector_7[int(12)] = half(inputs_15[int(12)]);
    vector_7[int(13)] = half(inputs_15[int(13)]);
    vector_7[int(14)] = half(inputs_15[int(14)]);
    vector_7[int(15)] = half(inputs_15[int(15)]);
    vector_7[int(16)] = half(inputs_15[int(16)]);
    vector_7[int(17)] = half(inputs_15[int(17)]);
    vector_7[int(18)] = half(inputs_15[int(18)]);
    vector_7[int(19)] = half(inputs_15[int(19)]);
    vector_7[int(20)] = half(inputs_15[int(20)]);
    vector_7[int(21)] = half(inputs_15[int(21)]);
    vector_7[int(22)] = half(inputs_15[int(22)]);
    vector_7[int(23)] = half(inputs_15[int(23)]);
    vector_7[int(24)] = half(inputs_15[int(24)]);
    vector_7[int(25)] = half(inputs_15[int(25)]);
    vector_7[int(26)] = half(inputs_15[int(26)]);
    vector_7[int(27)] = half(inputs_15[int(27)]);
    vector_7[int(28)] = half(inputs_15[int(28)]);
    vector_7[int(29)] = half(inputs_15[int(29)]);
    vector_7[int(30)] = half(inputs_15[int(30)]);
    vector_7[int(31)] = half(inputs_15[int(31)]);
    vector_7[int(32)] = half(inputs_15[int(32)]);
    vector_7[int(33)] = half(inputs_15[int(33)]);
    vector_7[int(34)] = half(inputs_15[int(34)]);
    vector_7[int(35)] = half(inputs_15[int(35)]);
    vector_7[int(36)] = half(inputs_15[int(36)]);
    vector_7[int(37)] = half(inputs_15[int(37)]);
    vector_7[int(38)] = half(inputs_15[int(38)]);
    vector_7[int(39)] = half(inputs_15[int(39)]);
    vector_7[int(40)] = half(inputs_15[int(40)]);
    vector_7[int(41)] = half(inputs_15[int(41)]);
    vector_7[int(42)] = half(inputs_15[int(42)]);
    vector_7[int(43)] = half(inputs_15[int(43)]);
    vector_7[int(44)] = half(inputs_15[int(44)]);
    vector_7[int(45)] = half(inputs_15[int(45)]);
    vector_7[int(46)] = half(inputs_15[int(46)]);
    vector_7[int(47)] = half(inputs_15[int(47)]);
    vector_7[int(48)] = half(inputs_15[int(48)]);
    vector_7[int(49)] = half(inputs_15[int(49)]);
    vector_7[int(50)] = half(inputs_15[int(50)]);
    vector_7[int(51)] = half(inputs_15[int(51)]);
    vector_7[int(52)] = half(inputs_15[int(52)]);
    vector_7[int(53)] = half(inputs_15[int(53)]);
    vector_7[int(54)] = half(inputs_15[int(54)]);
    vector_7[int(55)] = half(inputs_15[int(55)]);
    vector_7[int(56)] = half(inputs_15[int(56)]);
    vector_7[int(57)] = half(inputs_15[int(57)]);
    vector_7[int(58)] = half(inputs_15[int(58)]);
    vector_7[int(59)] = half(inputs_15[int(59)]);
    vector_7[int(60)] = half(inputs_15[int(60)]);
    vector_7[int(61)] = half(inputs_15[int(61)]);
    vector_7[int(62)] = half(inputs_15[int(62)]);
    vector_7[int(63)] = half(inputs_15[int(63)]);
    vector_7[int(64)] = half(inputs_15[int(64)]);
    vector_7[int(65)] = half(inputs_15[int(65)]);
    vector_7[int(66)] = half(inputs_15[int(66)]);
    vector_7[int(67)] = half(inputs_15[int(67)]);
    vector_7[int(68)] = half(inputs_15[int(68)]);
    vector_7[int(69)] = half(inputs_15[int(69)]);
    vector_7[int(70)] = half(inputs_15[int(70)]);
    vector_7[int(71)] = half(inputs_15[int(71)]);
    vector_7[int(72)] = half(inputs_15[int(72)]);
    vector_7[int(73)] = half(inputs_15[int(73)]);
    vector_7[int(74)] = half(inputs_15[int(74)]);
    vector_7[int(75)] = half(inputs_15[int(75)]);
    vector_7[int(76)] = half(inputs_15[int(76)]);
    vector_7[int(77)] = half(inputs_15[int(77)]);
    vector_7[int(78)] = half(inputs_15[int(78)]);
    vector_7[int(79)] = half(inputs_15[int(79)]);
    vector_7[int(80)] = half(inputs_15[int(80)]);
    vector_7[int(81)] = half(inputs_15[int(81)]);
    vector_7[int(82)] = half(inputs_15[int(82)]);
    vector_7[int(83)] = half(inputs_15[int(83)]);
    vector_7[int(84)] = half(inputs_15[int(84)]);
    vector_7[int(85)] = half(inputs_15[int(85)]);
    vector_7[int(86)] = half(inputs_15[int(86)]);
    vector_7[int(87)] = half(inputs_15[int(87)]);
    vector<half,96> _S496 = __slang_linalg_MulAdd<half, dx::linalg::DATA_TYPE_FLOAT16, int(96), int(88), dx::linalg::MATRIX_LAYOUT_ROW_MAJOR, false, dx::linalg::DATA_TYPE_FLOAT16, int(88), dx::linalg::DATA_TYPE_FLOAT16, ByteAddressBuffer, ByteAddressBuffer, half, false, false>(packed_bytes_0, int(HalfWeights_byte_of_0(weights_15, first_16 + uint(whole_parts_0(int(12))))), 176U, packed_bytes_0, int(HalfWeights_byte_of_0(weights_15, first_16)), vector_7);
    float _S497 = float(_S496[int(0)]);
    float _S498;
    if(adds_14)
    {
        _S498 = outputs_14[int(0)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(0)] = LeakyRelu_apply_0(_S497 + _S498);
    float _S499 = float(_S496[int(1)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(1)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(1)] = LeakyRelu_apply_0(_S499 + _S498);
    float _S500 = float(_S496[int(2)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(2)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(2)] = LeakyRelu_apply_0(_S500 + _S498);
    float _S501 = float(_S496[int(3)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(3)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(3)] = LeakyRelu_apply_0(_S501 + _S498);
    float _S502 = float(_S496[int(4)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(4)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(4)] = LeakyRelu_apply_0(_S502 + _S498);
    float _S503 = float(_S496[int(5)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(5)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(5)] = LeakyRelu_apply_0(_S503 + _S498);
    float _S504 = float(_S496[int(6)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(6)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(6)] = LeakyRelu_apply_0(_S504 + _S498);
    float _S505 = float(_S496[int(7)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(7)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(7)] = LeakyRelu_apply_0(_S505 + _S498);
    float _S506 = float(_S496[int(8)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(8)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(8)] = LeakyRelu_apply_0(_S506 + _S498);
    float _S507 = float(_S496[int(9)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(9)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(9)] = LeakyRelu_apply_0(_S507 + _S498);
    float _S508 = float(_S496[int(10)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(10)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(10)] = LeakyRelu_apply_0(_S508 + _S498);
    float _S509 = float(_S496[int(11)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(11)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(11)] = LeakyRelu_apply_0(_S509 + _S498);
    float _S510 = float(_S496[int(12)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(12)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(12)] = LeakyRelu_apply_0(_S510 + _S498);
    float _S511 = float(_S496[int(13)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(13)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(13)] = LeakyRelu_apply_0(_S511 + _S498);
    float _S512 = float(_S496[int(14)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(14)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(14)] = LeakyRelu_apply_0(_S512 + _S498);
    float _S513 = float(_S496[int(15)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(15)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(15)] = LeakyRelu_apply_0(_S513 + _S498);
    float _S514 = float(_S496[int(16)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(16)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(16)] = LeakyRelu_apply_0(_S514 + _S498);
    float _S515 = float(_S496[int(17)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(17)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(17)] = LeakyRelu_apply_0(_S515 + _S498);
    float _S516 = float(_S496[int(18)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(18)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(18)] = LeakyRelu_apply_0(_S516 + _S498);
    float _S517 = float(_S496[int(19)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(19)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(19)] = LeakyRelu_apply_0(_S517 + _S498);
    float _S518 = float(_S496[int(20)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(20)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(20)] = LeakyRelu_apply_0(_S518 + _S498);
    float _S519 = float(_S496[int(21)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(21)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(21)] = LeakyRelu_apply_0(_S519 + _S498);
    float _S520 = float(_S496[int(22)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(22)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(22)] = LeakyRelu_apply_0(_S520 + _S498);
    float _S521 = float(_S496[int(23)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(23)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(23)] = LeakyRelu_apply_0(_S521 + _S498);
    float _S522 = float(_S496[int(24)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(24)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(24)] = LeakyRelu_apply_0(_S522 + _S498);
    float _S523 = float(_S496[int(25)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(25)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(25)] = LeakyRelu_apply_0(_S523 + _S498);
    float _S524 = float(_S496[int(26)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(26)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(26)] = LeakyRelu_apply_0(_S524 + _S498);
    float _S525 = float(_S496[int(27)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(27)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(27)] = LeakyRelu_apply_0(_S525 + _S498);
    float _S526 = float(_S496[int(28)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(28)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(28)] = LeakyRelu_apply_0(_S526 + _S498);
    float _S527 = float(_S496[int(29)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(29)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(29)] = LeakyRelu_apply_0(_S527 + _S498);
    float _S528 = float(_S496[int(30)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(30)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(30)] = LeakyRelu_apply_0(_S528 + _S498);
    float _S529 = float(_S496[int(31)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(31)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(31)] = LeakyRelu_apply_0(_S529 + _S498);
    float _S530 = float(_S496[int(32)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(32)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(32)] = LeakyRelu_apply_0(_S530 + _S498);
    float _S531 = float(_S496[int(33)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(33)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(33)] = LeakyRelu_apply_0(_S531 + _S498);
    float _S532 = float(_S496[int(34)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(34)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(34)] = LeakyRelu_apply_0(_S532 + _S498);
    float _S533 = float(_S496[int(35)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(35)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(35)] = LeakyRelu_apply_0(_S533 + _S498);
    float _S534 = float(_S496[int(36)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(36)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(36)] = LeakyRelu_apply_0(_S534 + _S498);
    float _S535 = float(_S496[int(37)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(37)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(37)] = LeakyRelu_apply_0(_S535 + _S498);
    float _S536 = float(_S496[int(38)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(38)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(38)] = LeakyRelu_apply_0(_S536 + _S498);
    float _S537 = float(_S496[int(39)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(39)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(39)] = LeakyRelu_apply_0(_S537 + _S498);
    float _S538 = float(_S496[int(40)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(40)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(40)] = LeakyRelu_apply_0(_S538 + _S498);
    float _S539 = float(_S496[int(41)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(41)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(41)] = LeakyRelu_apply_0(_S539 + _S498);
    float _S540 = float(_S496[int(42)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(42)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(42)] = LeakyRelu_apply_0(_S540 + _S498);
    float _S541 = float(_S496[int(43)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(43)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(43)] = LeakyRelu_apply_0(_S541 + _S498);
    float _S542 = float(_S496[int(44)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(44)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(44)] = LeakyRelu_apply_0(_S542 + _S498);
    float _S543 = float(_S496[int(45)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(45)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(45)] = LeakyRelu_apply_0(_S543 + _S498);
    float _S544 = float(_S496[int(46)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(46)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(46)] = LeakyRelu_apply_0(_S544 + _S498);
    float _S545 = float(_S496[int(47)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(47)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(47)] = LeakyRelu_apply_0(_S545 + _S498);
    float _S546 = float(_S496[int(48)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(48)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(48)] = LeakyRelu_apply_0(_S546 + _S498);
    float _S547 = float(_S496[int(49)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(49)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(49)] = LeakyRelu_apply_0(_S547 + _S498);
    float _S548 = float(_S496[int(50)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(50)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(50)] = LeakyRelu_apply_0(_S548 + _S498);
    float _S549 = float(_S496[int(51)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(51)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(51)] = LeakyRelu_apply_0(_S549 + _S498);
    float _S550 = float(_S496[int(52)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(52)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(52)] = LeakyRelu_apply_0(_S550 + _S498);
    float _S551 = float(_S496[int(53)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(53)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(53)] = LeakyRelu_apply_0(_S551 + _S498);
    float _S552 = float(_S496[int(54)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(54)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(54)] = LeakyRelu_apply_0(_S552 + _S498);
    float _S553 = float(_S496[int(55)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(55)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(55)] = LeakyRelu_apply_0(_S553 + _S498);
    float _S554 = float(_S496[int(56)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(56)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(56)] = LeakyRelu_apply_0(_S554 + _S498);
    float _S555 = float(_S496[int(57)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(57)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(57)] = LeakyRelu_apply_0(_S555 + _S498);
    float _S556 = float(_S496[int(58)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(58)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(58)] = LeakyRelu_apply_0(_S556 + _S498);
    float _S557 = float(_S496[int(59)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(59)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(59)] = LeakyRelu_apply_0(_S557 + _S498);
    float _S558 = float(_S496[int(60)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(60)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(60)] = LeakyRelu_apply_0(_S558 + _S498);
    float _S559 = float(_S496[int(61)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(61)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(61)] = LeakyRelu_apply_0(_S559 + _S498);
    float _S560 = float(_S496[int(62)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(62)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(62)] = LeakyRelu_apply_0(_S560 + _S498);
    float _S561 = float(_S496[int(63)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(63)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(63)] = LeakyRelu_apply_0(_S561 + _S498);
    float _S562 = float(_S496[int(64)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(64)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(64)] = LeakyRelu_apply_0(_S562 + _S498);
    float _S563 = float(_S496[int(65)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(65)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(65)] = LeakyRelu_apply_0(_S563 + _S498);
    float _S564 = float(_S496[int(66)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(66)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(66)] = LeakyRelu_apply_0(_S564 + _S498);
    float _S565 = float(_S496[int(67)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(67)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(67)] = LeakyRelu_apply_0(_S565 + _S498);
    float _S566 = float(_S496[int(68)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(68)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(68)] = LeakyRelu_apply_0(_S566 + _S498);
    float _S567 = float(_S496[int(69)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(69)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(69)] = LeakyRelu_apply_0(_S567 + _S498);
    float _S568 = float(_S496[int(70)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(70)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(70)] = LeakyRelu_apply_0(_S568 + _S498);
    float _S569 = float(_S496[int(71)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(71)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(71)] = LeakyRelu_apply_0(_S569 + _S498);
    float _S570 = float(_S496[int(72)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(72)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(72)] = LeakyRelu_apply_0(_S570 + _S498);
    float _S571 = float(_S496[int(73)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(73)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(73)] = LeakyRelu_apply_0(_S571 + _S498);
    float _S572 = float(_S496[int(74)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(74)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(74)] = LeakyRelu_apply_0(_S572 + _S498);
    float _S573 = float(_S496[int(75)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(75)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(75)] = LeakyRelu_apply_0(_S573 + _S498);
    float _S574 = float(_S496[int(76)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(76)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(76)] = LeakyRelu_apply_0(_S574 + _S498);
    float _S575 = float(_S496[int(77)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(77)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(77)] = LeakyRelu_apply_0(_S575 + _S498);
    float _S576 = float(_S496[int(78)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(78)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(78)] = LeakyRelu_apply_0(_S576 + _S498);
    float _S577 = float(_S496[int(79)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(79)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(79)] = LeakyRelu_apply_0(_S577 + _S498);
    float _S578 = float(_S496[int(80)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(80)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(80)] = LeakyRelu_apply_0(_S578 + _S498);
    float _S579 = float(_S496[int(81)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(81)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(81)] = LeakyRelu_apply_0(_S579 + _S498);
    float _S580 = float(_S496[int(82)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(82)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(82)] = LeakyRelu_apply_0(_S580 + _S498);
    float _S581 = float(_S496[int(83)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(83)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(83)] = LeakyRelu_apply_0(_S581 + _S498);
    float _S582 = float(_S496[int(84)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(84)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(84)] = LeakyRelu_apply_0(_S582 + _S498);
    float _S583 = float(_S496[int(85)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(85)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(85)] = LeakyRelu_apply_0(_S583 + _S498);
    float _S584 = float(_S496[int(86)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(86)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(86)] = LeakyRelu_apply_0(_S584 + _S498);
    float _S585 = float(_S496[int(87)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(87)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(87)] = LeakyRelu_apply_0(_S585 + _S498);
    float _S586 = float(_S496[int(88)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(88)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(88)] = LeakyRelu_apply_0(_S586 + _S498);
    float _S587 = float(_S496[int(89)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(89)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(89)] = LeakyRelu_apply_0(_S587 + _S498);
    float _S588 = float(_S496[int(90)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(90)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(90)] = LeakyRelu_apply_0(_S588 + _S498);
    float _S589 = float(_S496[int(91)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(91)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(91)] = LeakyRelu_apply_0(_S589 + _S498);
    float _S590 = float(_S496[int(92)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(92)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(92)] = LeakyRelu_apply_0(_S590 + _S498);
    float _S591 = float(_S496[int(93)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(93)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(93)] = LeakyRelu_apply_0(_S591 + _S498);
    float _S592 = float(_S496[int(94)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(94)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(94)] = LeakyRelu_apply_0(_S592 + _S498);
    float _S593 = float(_S496[int(95)]);
    if(adds_14)
    {
        _S498 = outputs_14[int(95)];
    }
    else
    {
        _S498 = 0.0f;
    }
    outputs_14[int(95)] = LeakyRelu_apply_0(_S593 + _S498);
    return;
}

void dense_part_7(HalfWeights_0 weights_16, uint first_17, bool adds_15, inout float  inputs_16[int(88)], inout float  outputs_15[int(96)])
{
    cooperative_part_7(weights_16, first_17, adds_15, inputs_16, outputs_15);
    return;
}

void dense_0(FloatWeights_0 weights_17, uint first_18, bool adds_16, inout float  inputs_17[int(96)], inout float  outputs_16[int(50)])
{
    dense_part_0(weights_17, first_18, adds_16, inputs_17, outputs_16);
    return;
}

void dense_1(HalfWeights_0 weights_18, uint first_19, bool adds_17, inout float  inputs_18[int(96)], inout float  outputs_17[int(52)])
{
    dense_part_1(weights_18, first_19, adds_17, inputs_18, outputs_17);
    return;
}

void dense_2(HalfWeights_0 weights_19, uint first_20, bool adds_18, inout float  inputs_19[int(96)], inout float  outputs_18[int(96)])
{
    dense_part_5(weights_19, first_20, adds_18, inputs_19, outputs_18);
    return;
}

void dense_3(HalfWeights_0 weights_20, uint first_21, bool adds_19, inout float  inputs_20[int(39)], inout float  outputs_19[int(96)])
{
    dense_part_2(weights_20, first_21, adds_19, inputs_20, outputs_19);
    return;
}

void dense_4(HalfWeights_0 weights_21, uint first_22, bool adds_20, inout float  inputs_21[int(100)], inout float  outputs_20[int(96)])
{
    dense_part_3(weights_21, first_22, adds_20, inputs_21, outputs_20);
    return;
}

void dense_5(HalfWeights_0 weights_22, uint first_23, bool adds_21, inout float  inputs_22[int(16)], inout float  outputs_21[int(1)])
{
    dense_part_4(weights_22, first_23, adds_21, inputs_22, outputs_21);
    return;
}

void dense_6(HalfWeights_0 weights_23, uint first_24, bool adds_22, inout float  inputs_23[int(100)], inout float  outputs_22[int(16)])
{
    dense_part_6(weights_23, first_24, adds_22, inputs_23, outputs_22);
    return;
}

void dense_part_8(HalfWeights_0 weights_24, uint first_25, bool adds_23, inout float  inputs_24[int(96)], inout float  outputs_23[int(100)])
{
    cooperative_part_6(weights_24, first_25, adds_23, inputs_24, outputs_23);
    return;
}

void dense_7(HalfWeights_0 weights_25, uint first_26, bool adds_24, inout float  inputs_25[int(88)], inout float  outputs_24[int(96)])
{
    dense_part_7(weights_25, first_26, adds_24, inputs_25, outputs_24);
    return;
}

float square_0(float x_2)
{
    return x_2 * x_2;
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float3 row_of_taps_0(Footprint_0 footprint_0)
{
    float _S594 = footprint_0.dx_0.x;
    float _S595 = footprint_0.dy_0.x;
    float _S596 = _S594 * _S594 + _S595 * _S595;
    float _S597 = footprint_0.dx_0.y;
    float _S598 = footprint_0.dy_0.y;
    float _S599 = _S597 * _S597 + _S598 * _S598;
    float _S600 = _S594 * _S597 + _S595 * _S598;
    float _S601 = 0.5f * (_S596 - _S599);
    float _S602 = 0.5f * (_S596 + _S599);
    float _S603 = sqrt(_S601 * _S601 + _S600 * _S600);
    float _S604 = _S602 + _S603;
    float _S605 = max(_S604 - 1.5f * max(_S602 - _S603, 0.0f), 0.0f);
    float _S606 = square_0(4.0f);
    float _S607 = max(_S602 - 0.5f * _S605, _S604 / _S606);
    float _S608 = sqrt(max(min(_S605, _S604 - _S607), 0.0f) / (_S606 - 1.0f));
    float _S609 = _S601 / max(_S603, 1.00000000317107685e-30f);
    float _S610 = sqrt(max(0.5f * (1.0f - _S609), 0.0f));
    float _S611 = sqrt(_S607);
    float _S612 = _S608 * sqrt(max(0.5f * (1.0f + _S609), 0.0f));
    float _S613;
    if(_S600 < 0.0f)
    {
        _S613 = - _S608 * _S610;
    }
    else
    {
        _S613 = _S608 * _S610;
    }
    return float3(_S611, _S612, _S613);
}

struct AnisotropicTaps_0
{
    float2 centre_1;
    float side_0;
    float2 first_27;
    float2 second_0;
};

float AnisotropicTaps_size_0(AnisotropicTaps_0 this_2)
{
    float _S614 = this_2.first_27.x;
    float _S615 = this_2.second_0.x;
    float _S616 = this_2.side_0;
    float _S617 = _S616 * _S616;
    float _S618 = this_2.first_27.y;
    float _S619 = this_2.second_0.y;
    float _S620 = 12.0f * (_S614 * _S618 + _S615 * _S619);
    return sqrt(sqrt(max((12.0f * (_S614 * _S614 + _S615 * _S615) + _S617) * (12.0f * (_S618 * _S618 + _S619 * _S619) + _S617) - _S620 * _S620, square_0(_S617))));
}

float natural_logarithm_0(float x_3)
{
    uint _S621 = asuint(x_3);
    float exponent_0 = float(int(_S621 >> int(23)) - int(126));
    float m_0 = asfloat((_S621 & 8388607U) | 1056964608U);
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
    float _S622 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S622 - exponent_1 * 0.00021219444170129f - 0.5f * _S622) + exponent_1 * 0.693359375f;
}

float3 footprint_coordinates_0(AnisotropicTaps_0 taps_0)
{
    return float3(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

float3 to_face_frame_0(float3 direction_0, bool back_2)
{
    float2 _S623 = direction_0.xy;
    float _S624;
    if(back_2)
    {
        _S624 = - direction_0.z;
    }
    else
    {
        _S624 = direction_0.z;
    }
    return float3(_S623, _S624);
}

Eight_0 eight_halves_0(uint4 packed_0)
{
    Eight_0 numbers_1;
    uint _S625 = packed_0.x;
    uint _S626 = packed_0.y;
    numbers_1.low_0 = float4(f16tof32(uint2(_S625 & 65535U, _S625 >> 16U)), f16tof32(uint2(_S626 & 65535U, _S626 >> 16U)));
    uint _S627 = packed_0.z;
    uint _S628 = packed_0.w;
    numbers_1.high_0 = float4(f16tof32(uint2(_S627 & 65535U, _S627 >> 16U)), f16tof32(uint2(_S628 & 65535U, _S628 >> 16U)));
    return numbers_1;
}

float table_number_0(uint index_0)
{
    return asfloat(words_0.Load(index_0));
}

float wrapped_0(float index_1, float count_1)
{
    float _S629;
    if(index_1 < 0.0f)
    {
        _S629 = index_1 + count_1;
    }
    else
    {
        if(index_1 >= count_1)
        {
            _S629 = index_1 - count_1;
        }
        else
        {
            _S629 = index_1;
        }
    }
    return _S629;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 this_3)
{
    float2 _S630 = this_3.first_27;
    float2 _S631 = this_3.second_0;
    return (max(dot(_S630, _S630), dot(_S631, _S631))) > 0.0f;
}

float2 AnisotropicTaps_place_0(AnisotropicTaps_0 this_4, uint number_0)
{
    float _S632;
    if(number_0 >= 2U)
    {
        _S632 = 1.0f;
    }
    else
    {
        _S632 = -1.0f;
    }
    float _S633;
    if((number_0 & 1U) != 0U)
    {
        _S633 = 1.0f;
    }
    else
    {
        _S633 = -1.0f;
    }
    return this_4.centre_1 + _S632 * this_4.first_27 + _S633 * this_4.second_0;
}

float bump_0(float distance_0)
{
    float _S634 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S634 * _S634;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

float exponential_0(float x_5)
{
    float _S635 = clamp(x_5, -87.0f, 88.0f);
    float _S636 = floor(_S635 * 1.4426950216293335f + 0.5f);
    float _S637 = _S635 - _S636 * 0.693359375f + _S636 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S637 + 0.00139819993637502f) * _S637 + 0.00833345204591751f) * _S637 + 0.04166579619050026f) * _S637 + 0.1666666567325592f) * _S637 + 0.5f;
    float _S638 = asfloat(uint(int(_S636) + int(127)) << int(23));
    float _S639;
    if(x_5 < -87.0f)
    {
        _S639 = 0.0f;
    }
    else
    {
        _S639 = (p_0 * _S637 * _S637 + _S637 + 1.0f) * _S638;
    }
    return _S639;
}

float unmapped_0(float output_1, float scale_0)
{
    return (exponential_0(clamp(output_1, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

float square_1(float3 v_0)
{
    return dot(v_0, v_0);
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S640 = bundle_0 / 3U;
    uint _S641 = bundle_0 % 3U;
    uint _S642;
    if(bundle_0 == 24U)
    {
        _S642 = bundle_0;
    }
    else
    {
        _S642 = _S640 * 3U + 3U - 1U - _S641;
    }
    return _S642;
}

float light_visibility_of_0(float diffuse_0, float3 light_1, float3 view_1, float blend_0)
{
    float _S643 = max(abs(light_1.z), 0.00100000004749745f);
    float2 _S644 = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / lerp(_S643, (0.59700000286102295f * _S643 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S644, view_1.xy) * rsqrt(max(dot(_S644, _S644), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

float2 turns_and_remainder_0(uint family_0, float index_2)
{
    float _S645 = floor(mad(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return float2(_S645, mad(- _S645, families_0[family_0].count_0, index_2));
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
    float _S646 = floor(position_0 * families_0[family_1].inverse_size_0);
    Cell_0 cell_0;
    float _S647 = mad(- _S646, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S647;
    cell_0.above_0 = families_0[family_1].size_0 - _S647;
    cell_0.across_0 = _S647 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S646).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float turns_0 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S648 = turns_1 * families_0[family_2].period_0;
    uint thread_1 = words_0.Load(families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f)));
    uint _S649;
    if(_S648 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S649 = 1U;
    }
    else
    {
        _S649 = 0U;
    }
    uint _S650 = min(thread_1 + _S649, uint(families_0[family_2].count_0) - 1U);
    uint _S651 = families_0[family_2].place_table_0 + _S650 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S650;
    cell_1.below_0 = _S648 - table_number_0(_S651);
    cell_1.above_0 = table_number_0(_S651 + 1U) - _S648;
    cell_1.across_0 = _S648 - table_number_0(_S651 + 2U);
    cell_1.half_width_1 = table_number_0(_S651 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2)
{
    if((families_0[family_3].is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Bound_0
{
    uint thread_2;
    float turns_2;
    float cell_2;
    float visible_0;
    float width_1;
    float gap_0;
};

Bound_0 bound_at_0(uint family_4, float position_3)
{
    Cell_0 _S652 = locate_0(family_4, position_3);
    float _S653 = table_number_0(families_0[family_4].before_0 + 2U * _S652.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_2 = _S652.thread_0;
    bound_0.turns_2 = round((position_3 - families_0[family_4].start_0 - _S653 - _S652.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S652.below_0;
    float _S654 = 2.0f * _S652.half_width_1;
    bound_0.width_1 = _S654;
    bound_0.visible_0 = clamp((_S652.across_0 + _S652.half_width_1) / _S654, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S652.below_0, _S652.below_0 - _S652.across_0 - _S652.half_width_1) + max(_S652.across_0 - _S652.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_2;
    Bound_0 high_2;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S655 = centre_2 - floor((centre_2 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    float _S656 = 0.5f * max(size_1, families_0[family_5].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_2 = bound_at_0(family_5, _S655 - _S656);
    stretch_0.high_2 = bound_at_0(family_5, _S655 + _S656);
    return stretch_0;
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

Albedos_0 table_albedos_0(uint row_1)
{
    Albedos_0 albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_1);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_1 + 3U);
    albedos_0.specular_reflect_0 = table_colour_0(row_1 + 6U);
    albedos_0.specular_transmit_0 = table_colour_0(row_1 + 9U);
    return albedos_0;
}

float Stretch_turns_0(Stretch_0 this_5)
{
    return this_5.high_2.turns_2 - this_5.low_2.turns_2;
}

float3 lengths_0(uint family_6, Stretch_0 stretch_1)
{
    float _S657 = Stretch_turns_0(stretch_1);
    uint _S658 = families_0[family_6].before_0 + 2U * stretch_1.low_2.thread_2;
    uint _S659 = families_0[family_6].before_0 + 2U * stretch_1.high_2.thread_2;
    float _S660 = table_number_0(_S659) - table_number_0(_S658);
    float _S661 = table_number_0(_S659 + 1U) - table_number_0(_S658 + 1U);
    return float3(_S660 + stretch_1.high_2.visible_0 * stretch_1.high_2.width_1 - stretch_1.low_2.visible_0 * stretch_1.low_2.width_1 + _S657 * families_0[family_6].visible_total_0, _S661 - _S660 + stretch_1.high_2.gap_0 - stretch_1.low_2.gap_0 + _S657 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S661 + stretch_1.high_2.cell_2 - stretch_1.low_2.cell_2 + _S657 * families_0[family_6].period_0);
}

float2 integrals_along_0(uint family_7, Stretch_0 stretch_2, uint quantity_0)
{
    uint _S662 = 3U * families_0[family_7].quantities_0;
    uint _S663 = families_0[family_7].colour_threads_0 + _S662 * stretch_2.low_2.thread_2 + quantity_0;
    uint _S664 = families_0[family_7].colour_threads_0 + _S662 * stretch_2.high_2.thread_2 + quantity_0;
    uint _S665 = families_0[family_7].colour_threads_0 + _S662 * uint(families_0[family_7].count_0) + quantity_0;
    float _S666 = table_number_0(_S663);
    float _S667 = table_number_0(_S664);
    float _S668 = Stretch_turns_0(stretch_2);
    uint _S669 = 2U * families_0[family_7].quantities_0;
    return float2(table_number_0(_S664 + families_0[family_7].quantities_0) - table_number_0(_S663 + families_0[family_7].quantities_0) + _S667 * stretch_2.high_2.visible_0 * stretch_2.high_2.width_1 - _S666 * stretch_2.low_2.visible_0 * stretch_2.low_2.width_1 + _S668 * table_number_0(_S665 + families_0[family_7].quantities_0), table_number_0(_S664 + _S669) - table_number_0(_S663 + _S669) + _S667 * stretch_2.high_2.cell_2 - _S666 * stretch_2.low_2.cell_2 + _S668 * table_number_0(_S665 + _S669));
}

bool Stretch_wraps_0(Stretch_0 this_6)
{
    return (this_6.high_2.thread_2) < (this_6.low_2.thread_2);
}

uint4 Stretch_differences_0(Stretch_0 this_7, uint4 entries_0, uint whole_0)
{
    uint _S670 = entries_0.z;
    uint _S671 = entries_0.x;
    uint _S672 = _S670 - _S671;
    uint _S673;
    if(Stretch_wraps_0(this_7))
    {
        _S673 = whole_0;
    }
    else
    {
        _S673 = 0U;
    }
    return uint4(_S672 + _S673, entries_0.w - _S670, entries_0.y - _S671, whole_0);
}

uint4 row_differences_0(Stretch_0 across_1, uint row_2, uint count_2, uint quantities_1)
{
    uint _S674 = row_2 + across_1.low_2.thread_2 * quantities_1;
    uint _S675 = row_2 + across_1.high_2.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, uint4(words_0.Load(_S674), words_0.Load(_S674 + quantities_1), words_0.Load(_S675), words_0.Load(_S675 + quantities_1)), words_0.Load(row_2 + count_2 * quantities_1));
}

float4 Stretch_weights_0(Stretch_0 this_8)
{
    float _S676 = - this_8.low_2.visible_0;
    float _S677 = Stretch_turns_0(this_8);
    float _S678;
    if(Stretch_wraps_0(this_8))
    {
        _S678 = 1.0f;
    }
    else
    {
        _S678 = 0.0f;
    }
    return float4(1.0f, this_8.high_2.visible_0, _S676, _S677 - _S678);
}

float integral_on_top_0(uint family_8, Stretch_0 across_2, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S679 = uint(families_0[family_8].count_0);
    uint _S680 = (_S679 + 1U) * families_0[family_8].quantities_0;
    uint _S681 = families_0[family_8].colour_areas_0 + quantity_1;
    uint4 _S682 = row_differences_0(across_2, _S681 + along_0.low_2.thread_2 * _S680, _S679, families_0[family_8].quantities_0);
    uint4 _S683 = row_differences_0(across_2, _S681 + (along_0.low_2.thread_2 + 1U) * _S680, _S679, families_0[family_8].quantities_0);
    uint4 _S684 = row_differences_0(across_2, _S681 + along_0.high_2.thread_2 * _S680, _S679, families_0[family_8].quantities_0);
    uint4 _S685 = row_differences_0(across_2, _S681 + (along_0.high_2.thread_2 + 1U) * _S680, _S679, families_0[family_8].quantities_0);
    uint4 _S686 = row_differences_0(across_2, _S681 + crossing_count_0 * _S680, _S679, families_0[family_8].quantities_0);
    uint4 _S687 = _S684 - _S682;
    uint4 _S688;
    if(Stretch_wraps_0(along_0))
    {
        _S688 = _S686;
    }
    else
    {
        _S688 = uint4((int4)int(0));
    }
    float4 _S689 = Stretch_weights_0(across_2);
    return dot(float4(dot(float4(int4(_S687 + _S688)), _S689), dot(float4(int4(_S685 - _S684)), _S689), dot(float4(int4(_S683 - _S682)), _S689), dot(float4(int4(_S686)), _S689)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_0, uint row_3)
{
    Albedos_0 _S690 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_0 * _S690.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_0 * _S690.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_0 * _S690.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_0 * _S690.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 own_0, Stretch_0 other_0, bool back_3)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S691 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S692 = integrals_along_0(family_9, own_0, quantity_2);
        float _S693 = integral_on_top_0(family_9, own_0, other_0, uint(families_0[crossing_0].count_0), quantity_2);
        float _S694 = _S692.x;
        float _S695 = _S694 * _S691.x;
        float _S696;
        if(back_3)
        {
            _S696 = _S695 - _S693;
        }
        else
        {
            _S696 = _S693;
        }
        bool _S697 = quantity_2 == 0U;
        if(_S697)
        {
            is_exposed_0 = _S696 > (16.0f * families_0[family_9].area_unit_0 * min(_S695 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S695);
        }
        float _S698 = _S694 * _S691.y;
        float _S699;
        if(is_exposed_0)
        {
            _S699 = _S696;
        }
        else
        {
            _S699 = 0.0f;
        }
        float _S700 = _S698 + _S699 + 0.000244140625f * _S691.z * _S692.y;
        if(_S697)
        {
            weight_1 = 1.0f / max(_S700, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S700 * weight_1, families_0[family_9].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

Blocked_0 no_blocked_0()
{
    Blocked_0 nothing_0;
    nothing_0.by_warp_0 = 0.0f;
    nothing_0.by_weft_0 = 0.0f;
    nothing_0.far_0 = 0.0f;
    return nothing_0;
}

struct CloseUp_0
{
    float weight_2;
    Blocked_0 warp_1;
    Blocked_0 weft_1;
};

CloseUp_0 no_close_up_0()
{
    CloseUp_0 nothing_1;
    nothing_1.weight_2 = 0.0f;
    Blocked_0 _S701 = no_blocked_0();
    nothing_1.warp_1 = _S701;
    nothing_1.weft_1 = _S701;
    return nothing_1;
}

Albedos_0 tinted_0(Albedos_0 albedos_3, float3 tint_0)
{
    Albedos_0 result_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
    float3 warp_2;
    float3 weft_2;
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

FaceRadiance_0 face_radiance_0(FaceSends_0 sends_0, float open_of_other_0, float3 passed_0, float3 from_other_0)
{
    float3 _S702 = (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3 _S703 = sends_0.sky_warp_0 + _S702 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S703;
    float3 _S704 = sends_0.sky_weft_0 + _S702 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S704;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S703 + sends_0.blocks_weft_0 * _S704;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(float3 view_2, out float  terms_0[int(6)])
{
    float _S705 = 1.0f - view_2.z;
    float _S706 = _S705 * _S705;
    terms_0[int(0)] = 1.0f;
    float _S707 = view_2.x;
    float _S708 = _S707 * _S707;
    float _S709 = view_2.y;
    float _S710 = _S709 * _S709;
    terms_0[int(1)] = sqrt(max(_S708 + _S710, 9.999999960041972e-13f));
    terms_0[int(2)] = _S706;
    terms_0[int(3)] = _S706 * _S706;
    terms_0[int(4)] = _S708 - _S710;
    terms_0[int(5)] = 0.0f;
    return;
}

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
    float3 warp_3;
    float3 weft_3;
    float3 leaked_1;
    float3 far_1;
    float3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_1, Scattered_0 yarn_0, Interior_0 interior_0)
{
    float3 _S711 = (blocked_1.by_warp_0 + blocked_1.by_weft_0) * interior_0.leaked_1;
    float3 _S712 = blocked_1.far_0 * yarn_0.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (blocked_1.by_warp_0 * interior_0.warp_3 + blocked_1.by_weft_0 * interior_0.weft_3) + _S712 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S712 * interior_0.far_1 + yarn_0.back_4 * _S711;
    return bounced_0;
}

Bounced_0 sum_of_0(Bounced_0 first_28, Bounced_0 second_1)
{
    Bounced_0 sum_1;
    sum_1.reflected_0 = first_28.reflected_0 + second_1.reflected_0;
    sum_1.transmitted_0 = first_28.transmitted_0 + second_1.transmitted_0;
    return sum_1;
}

float3 bounced_value_0(Bounced_0 bounced_1, float3 light_2, float3 view_3)
{
    float _S713 = light_2.z;
    float3 _S714;
    if((_S713 * view_3.z) < 0.0f)
    {
        _S714 = bounced_1.transmitted_0;
    }
    else
    {
        _S714 = bounced_1.reflected_0;
    }
    return _S714 * (abs(_S713) * 0.31830987334251404f);
}

float sheen_scale_0(float x_6, float y_0)
{
    return (((((0.0f * x_6 + (((((-1.1402510404586792f * y_0 + 0.40672621130943298f) * y_0 + 1.65398800373077393f) * y_0 + -1.29730904102325439f) * y_0 + 0.30570998787879944f) * y_0 + -0.0220868494361639f)) * x_6 + (((((-0.21142719686031342f * y_0 + 1.05947399139404297f) * y_0 + -0.41116121411323547f) * y_0 + -0.93859231472015381f) * y_0 + 0.51606941223144531f) * y_0 + 0.05409301072359085f)) * x_6 + (((((1.22944498062133789f * y_0 + -0.45962560176849365f) * y_0 + -1.63861405849456787f) * y_0 + 1.33565104007720947f) * y_0 + -0.45725581049919128f) * y_0 + 0.08243165910243988f)) * x_6 + (((((0.39779931306838989f * y_0 + -1.18879103660583496f) * y_0 + 0.28251591324806213f) * y_0 + 1.168984055519104f) * y_0 + -0.76864629983901978f) * y_0 + 0.0091691892594099f)) * x_6 + (((((-0.26563560962677002f * y_0 + -0.19379159808158875f) * y_0 + 0.2677634060382843f) * y_0 + 0.00270519289188087f) * y_0 + 0.14349560439586639f) * y_0 + 0.10290180146694183f)) * x_6 + (((((-0.20701569318771362f * y_0 + 0.24526430666446686f) * y_0 + 0.19551840424537659f) * y_0 + 0.07586126774549484f) * y_0 + 0.38894739747047424f) * y_0 + 0.15043120086193085f);
}

float sheen_shear_0(float x_7, float y_1)
{
    return ((((0.0f * x_7 + (((((-0.10608240216970444f * y_1 + 1.99214303493499756f) * y_1 + -1.42255294322967529f) * y_1 + -1.09495604038238525f) * y_1 + 0.59180057048797607f) * y_1 + 0.06902855634689331f)) * x_7 + (((((-0.46220690011978149f * y_1 + -0.29113379120826721f) * y_1 + 1.39025199413299561f) * y_1 + 0.35589990019798279f) * y_1 + -1.17120099067687988f) * y_1 + 0.15940259397029877f)) * x_7 + (((((2.26068711280822754f * y_1 + -3.64728999137878418f) * y_1 + -0.72173482179641724f) * y_1 + 3.07659196853637695f) * y_1 + -0.6827620267868042f) * y_1 + -0.3039557933807373f)) * x_7 + (((((0.81201767921447754f * y_1 + 0.36014080047607422f) * y_1 + -1.72646903991699219f) * y_1 + -0.22630110383033752f) * y_1 + 0.89514690637588501f) * y_1 + -0.10397960245609283f)) * x_7 + (((((-0.37648698687553406f * y_1 + 1.10974001884460449f) * y_1 + 0.17824520170688629f) * y_1 + -1.04968702793121338f) * y_1 + 0.1461234986782074f) * y_1 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_8, float y_2)
{
    return ((((0.0f * x_8 + (((((12.95646953582763672f * y_2 + -21.38032913208007812f) * y_2 + -7.37853097915649414f) * y_2 + 34.55607986450195312f) * y_2 + -23.61347007751464844f) * y_2 + 5.00126314163208008f)) * x_8 + (((((10.91487026214599609f * y_2 + -6.08202791213989258f) * y_2 + -38.2036285400390625f) * y_2 + 53.3440399169921875f) * y_2 + -21.91996002197265625f) * y_2 + 2.01606011390686035f)) * x_8 + (((((-14.52206039428710938f * y_2 + 36.803619384765625f) * y_2 + -22.94047927856445312f) * y_2 + -10.07973003387451172f) * y_2 + 15.77003955841064453f) * y_2 + -4.92722177505493164f)) * x_8 + (((((-7.62505722045898438f * y_2 + 1.27310299873352051f) * y_2 + 31.19523048400878906f) * y_2 + -44.39989852905273438f) * y_2 + 26.44947052001953125f) * y_2 + -8.73507976531982422f)) * x_8 + (((((5.65633487701416016f * y_2 + -17.66820907592773438f) * y_2 + 24.65356063842773438f) * y_2 + -19.38941001892089844f) * y_2 + 11.06159019470214844f) * y_2 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S715 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S716 = 2.0f * sqrt(_S715) - 1.0f;
    float _S717 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S716, _S717), 0.00999999977648258f, 1.0f), clamp((1.0f - _S715) * sheen_shear_0(_S716, _S717), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S716, _S717), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_3, float3 view_4, float scale_1, float shear_0)
{
    float _S718 = light_3.z;
    bool _S719;
    if(_S718 <= 0.0f)
    {
        _S719 = true;
    }
    else
    {
        _S719 = (view_4.z) <= 0.0f;
    }
    if(_S719)
    {
        return 0.0f;
    }
    float2 _S720 = view_4.xy;
    float _S721 = dot(_S720, _S720);
    float2 _S722;
    if(_S721 > 9.99999968265522539e-21f)
    {
        _S722 = _S720 * rsqrt(_S721);
    }
    else
    {
        _S722 = float2(1.0f, 0.0f);
    }
    float _S723 = scale_1 * dot(light_3.xy, _S722) + shear_0 * _S718;
    float _S724 = scale_1 * (light_3.y * _S722.x - light_3.x * _S722.y);
    float _S725 = _S723 * _S723 + _S724 * _S724 + _S718 * _S718;
    return 0.31830987334251404f * scale_1 * scale_1 * _S718 / max(_S725 * _S725, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_4, float3 view_5, float strength_0, float roughness_2)
{
    float3 _S726 = sheen_lobe_0(view_5.z, roughness_2);
    float _S727 = strength_0 * _S726.z;
    return float2(_S727 * transformed_cosine_0(light_4, view_5, _S726.x, _S726.y), 1.0f - _S727);
}

struct NeuralView_0
{
    float  sums_2[int(96)];
    float hole_0;
    float correction_weight_0;
    float3 view_6;
    bool back_5;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S728, Footprint_0 _S729)
{
    float3 _S730 = row_of_taps_0(_S729);
    float2 _S731 = _S729.dx_0;
    float2 _S732 = _S729.dy_0;
    float _S733 = dot(_S731, _S731) + dot(_S732, _S732);
    float _S734 = _S729.dx_0.x * _S729.dy_0.y - _S729.dx_0.y * _S729.dy_0.x;
    float _S735 = 0.5f * (_S733 + sqrt(max(_S733 * _S733 - 4.0f * _S734 * _S734, 0.0f)));
    Neural_0 _S736 = fabrics_0[_S728].neural_0;
    bool _S737;
    if(_S735 < (5.5f * (_S733 - _S735)))
    {
        _S737 = _S733 > (8.0f * _S736.pitch_0 * _S736.pitch_0);
    }
    else
    {
        _S737 = false;
    }
    float2 _S738 = float2(_S736.ends_per_mm_0, _S736.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    taps_1.centre_1 = _S729.centre_0 * _S738;
    float _S739;
    if(_S737)
    {
        _S739 = sqrt(0.125f * _S733);
    }
    else
    {
        _S739 = _S730.x;
    }
    taps_1.side_0 = _S739 / _S736.pitch_0;
    float2 _S740;
    if(_S737)
    {
        _S740 = 0.25f * _S729.dx_0;
    }
    else
    {
        _S740 = _S730.yz;
    }
    taps_1.first_27 = _S740 * _S738;
    if(_S737)
    {
        _S740 = 0.25f * _S729.dy_0;
    }
    else
    {
        _S740 = 0.5f * _S730.yz;
    }
    taps_1.second_0 = _S740 * _S738;
    return taps_1;
}

void add_texel_0(uint _S741, uint _S742, float _S743, inout float  _S744[int(88)])
{
    uint _S745 = fabrics_0[_S741].neural_0.latents_0 + _S742 * 8U;
    uint part_0 = 0U;
    for(;;)
    {
        if(part_0 < 8U)
        {
        }
        else
        {
            break;
        }
        Eight_0 _S746 = eight_halves_0(packed_numbers_0.Load(_S745 + part_0));
        int _S747 = int(8U * part_0);
        _S744[_S747] = _S744[_S747] + _S743 * _S746.low_0[int(0)];
        _S744[_S747 + int(4)] = _S744[_S747 + int(4)] + _S743 * _S746.high_0[int(0)];
        int _S748 = _S747 + int(1);
        _S744[_S748] = _S744[_S748] + _S743 * _S746.low_0[int(1)];
        _S744[_S748 + int(4)] = _S744[_S748 + int(4)] + _S743 * _S746.high_0[int(1)];
        int _S749 = _S747 + int(2);
        _S744[_S749] = _S744[_S749] + _S743 * _S746.low_0[int(2)];
        _S744[_S749 + int(4)] = _S744[_S749 + int(4)] + _S743 * _S746.high_0[int(2)];
        int _S750 = _S747 + int(3);
        _S744[_S750] = _S744[_S750] + _S743 * _S746.low_0[int(3)];
        _S744[_S750 + int(4)] = _S744[_S750 + int(4)] + _S743 * _S746.high_0[int(3)];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S751, uint _S752, bool _S753, float2 _S754, float _S755, inout float  _S756[int(88)])
{
    Neural_0 _S757 = fabrics_0[_S751].neural_0;
    uint _S758 = fabrics_0[_S751].neural_0.levels_1 + 4U * _S752;
    float _S759 = table_number_0(_S758);
    float _S760 = table_number_0(_S758 + 1U);
    float _S761 = table_number_0(_S758 + 2U);
    bool _S762;
    if(_S752 > 3U)
    {
        _S762 = _S752 < (_S757.top_level_0);
    }
    else
    {
        _S762 = false;
    }
    float2 _S763 = _S754 * table_number_0(_S758 + 3U);
    float _S764;
    if(_S762)
    {
        _S764 = 1.0f;
    }
    else
    {
        _S764 = 0.5f;
    }
    float2 _S765 = _S763 - _S764;
    float2 _S766 = floor(_S765);
    float2 _S767 = _S765 - _S766;
    uint corner_0 = 0U;
    for(;;)
    {
        if(corner_0 < 4U)
        {
        }
        else
        {
            break;
        }
        float _S768 = float(corner_0 & 1U);
        float _S769 = float(corner_0 >> int(1));
        float2 _S770 = lerp(1.0f - _S767, _S767, float2(_S768, _S769));
        uint _S771 = uint(_S759 + wrapped_0(_S766.y + _S769, _S761) * _S760 + wrapped_0(_S766.x + _S768, _S760));
        uint _S772;
        if(_S753)
        {
            _S772 = _S757.texels_0;
        }
        else
        {
            _S772 = 0U;
        }
        add_texel_0(_S751, _S771 + _S772, _S755 * _S770.x * _S770.y, _S756);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S773, AnisotropicTaps_0 _S774, float3 _S775, bool _S776, inout float  _S777[int(88)])
{
    float offset_2;
    int k_0 = int(0);
    for(;;)
    {
        if(k_0 < int(64))
        {
        }
        else
        {
            break;
        }
        _S777[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    float2 _S778 = float2(fabrics_0[_S773].neural_0.ends_0, fabrics_0[_S773].neural_0.picks_0);
    float _S779 = float(fabrics_0[_S773].neural_0.top_level_0);
    float _S780 = clamp(binary_logarithm_0(max(_S774.side_0, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S779);
    float _S781 = min(floor(_S780), _S779 - 1.0f);
    uint _S782;
    if(AnisotropicTaps_has_steps_0(_S774))
    {
        _S782 = 4U;
    }
    else
    {
        _S782 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S782))
        {
        }
        else
        {
            break;
        }
        float2 _S783 = AnisotropicTaps_place_0(_S774, number_1 >> int(1));
        float2 _S784 = clamp(_S783 - _S778 * floor(_S783 / _S778), (float2)0.0f, _S778);
        bool _S785 = (number_1 & 1U) != 0U;
        if(_S785)
        {
            offset_2 = _S780 - _S781;
        }
        else
        {
            offset_2 = 1.0f - (_S780 - _S781);
        }
        float _S786 = offset_2 / float(_S782);
        uint _S787 = uint(_S781);
        uint _S788;
        if(_S785)
        {
            _S788 = 1U;
        }
        else
        {
            _S788 = 0U;
        }
        add_level_0(_S773, _S787 + _S788, _S776, _S784, _S786, _S777);
        number_1 = number_1 + 1U;
    }
    int number_2 = int(0);
    for(;;)
    {
        if(number_2 < int(3))
        {
        }
        else
        {
            break;
        }
        int bin_0 = int(0);
        for(;;)
        {
            if(bin_0 < int(8))
            {
            }
            else
            {
                break;
            }
            float offset_3 = _S775[number_2] - (float(bin_0) + 0.5f) / 8.0f;
            if(number_2 < int(2))
            {
                offset_2 = offset_3 - round(offset_3);
            }
            else
            {
                offset_2 = offset_3;
            }
            _S777[int(64) + number_2 * int(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_2 = number_2 + int(1);
    }
    return;
}

float3 crown_fibres_0(uint _S789, bool _S790, bool _S791)
{
    float _S792;
    if(_S790)
    {
        if(_S791)
        {
            _S792 = - fabrics_0[_S789].neural_0.warp_x_0;
        }
        else
        {
            _S792 = fabrics_0[_S789].neural_0.warp_x_0;
        }
        return float3(_S792, fabrics_0[_S789].neural_0.warp_y_0, fabrics_0[_S789].neural_0.warp_roughness_0);
    }
    Neural_0 _S793 = fabrics_0[_S789].neural_0;
    if(_S791)
    {
        _S792 = - _S793.weft_y_0;
    }
    else
    {
        _S792 = _S793.weft_y_0;
    }
    return float3(_S793.weft_x_0, _S792, _S793.weft_roughness_0);
}

void neural_view_0(uint _S794, Footprint_0 _S795, float3 _S796, inout NeuralView_0 _S797)
{
    bool _S798 = (_S796.z) < 0.0f;
    AnisotropicTaps_0 _S799 = anisotropic_taps_0(_S794, _S795);
    float3 _S800 = footprint_coordinates_0(_S799);
    float3 _S801 = to_face_frame_0(_S796, _S798);
    HalfWeights_0 weights_26;
    weights_26.first_2 = fabrics_0[_S794].neural_0.network_0;
    float  inputs_26[int(88)];
    code_footprint_0(_S794, _S799, _S800, _S798, inputs_26);
    float  hidden_1[int(96)];
    dense_7(weights_26, 0U, false, inputs_26, hidden_1);
    float  fused_0[int(100)];
    dense_part_8(weights_26, 1068U, false, hidden_1, fused_0);
    fused_0[int(96)] = _S801.x;
    fused_0[int(97)] = _S801.y;
    float2 _S802 = _S801.xy;
    fused_0[int(98)] = dot(crown_fibres_0(_S794, true, _S798).xy, _S802);
    fused_0[int(99)] = dot(crown_fibres_0(_S794, false, _S798).xy, _S802);
    float  of_hole_0[int(16)];
    dense_6(weights_26, 2232U, false, fused_0, of_hole_0);
    float  hole_1[int(1)];
    dense_5(weights_26, 2444U, false, of_hole_0, hole_1);
    dense_4(weights_26, 2456U, false, fused_0, _S797.sums_2);
    _S797.hole_0 = clamp(hole_1[int(0)], 0.0f, 1.0f);
    _S797.correction_weight_0 = correction_weight_of_0(_S800.z);
    _S797.view_6 = _S801;
    _S797.back_5 = _S798;
    return;
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

void code_light_0(uint _S803, float3 _S804, float3 _S805, bool _S806, inout float  _S807[int(39)])
{
    _S807[int(0)] = _S804.x;
    _S807[int(1)] = _S804.y;
    _S807[int(2)] = _S804.z;
    float3 _S808 = _S804 + _S805;
    float _S809 = _S808.z;
    float _S810 = _S809 * _S809 + 0.00009999999747379f;
    float2 _S811 = _S808.xy;
    float _S812 = 1.0f / (dot(_S811, _S811) + _S810);
    int family_10 = int(0);
    for(;;)
    {
        if(family_10 < int(2))
        {
        }
        else
        {
            break;
        }
        float3 _S813 = crown_fibres_0(_S803, family_10 == int(0), _S806);
        float2 _S814 = _S813.xy;
        _S807[int(3) + family_10] = dot(_S814, _S804.xy);
        float _S815 = dot(_S814, _S811);
        float _S816 = _S815 * _S815;
        float _S817 = (0.75f * _S815 / (0.5f * sqrt(_S816 + _S810) + abs(_S815)) + 0.5f) * 8.0f;
        int bin_1 = int(0);
        for(;;)
        {
            if(bin_1 < int(16))
            {
            }
            else
            {
                break;
            }
            _S807[int(5) + family_10 * int(16) + bin_1] = bump_0(_S817 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S818 = _S813.z;
        float _S819 = _S818 * _S818;
        float _S820 = _S816 * _S812 * (1.0f - _S819) + _S819;
        _S807[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S819 * _S818 / (_S820 * _S820));
        family_10 = family_10 + int(1);
    }
    return;
}

float mixed_bundles_0(uint _S821, uint _S822, uint _S823, float3 _S824, float3 _S825, bool _S826, inout float  _S827[int(52)])
{
    float3 _S828 = _S824 + _S825;
    float _S829 = 1.0f / (square_1(_S828) + 0.00009999999747379f);
    bool _S830;
    if(_S822 == 0U)
    {
        _S830 = _S826;
    }
    else
    {
        _S830 = false;
    }
    float _S831;
    if(_S830)
    {
        _S831 = - _S828.x;
    }
    else
    {
        _S831 = _S828.x;
    }
    if(_S822 == 1U)
    {
        _S830 = _S826;
    }
    else
    {
        _S830 = false;
    }
    float _S832;
    if(_S830)
    {
        _S832 = - _S828.y;
    }
    else
    {
        _S832 = _S828.y;
    }
    uint bundle_1 = 0U;
    float sum_2 = 0.0f;
    for(;;)
    {
        if(bundle_1 < 25U)
        {
        }
        else
        {
            break;
        }
        uint _S833 = _S822 * 25U;
        uint _S834 = fabrics_0[_S821].neural_0.bundles_0 + 4U * (_S833 + bundle_1);
        float _S835 = dot(float3(table_number_0(_S834), table_number_0(_S834 + 1U), table_number_0(_S834 + 2U)), float3(_S831, _S832, _S828.z));
        float _S836 = _S835 * _S835 * _S829 + table_number_0(_S834 + 3U);
        uint _S837 = _S823 + _S833;
        uint _S838;
        if(_S826)
        {
            _S838 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S838 = bundle_1;
        }
        float sum_3 = sum_2 + max(_S827[_S837 + _S838], _S827[_S837 + _S838] * 0.00999999977648258f) / (_S836 * _S836);
        bundle_1 = bundle_1 + 1U;
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

Components_0 neural_components_0(uint _S839, inout NeuralView_0 _S840, float3 _S841)
{
    float _S842;
    bool _S843 = _S840.back_5;
    float3 _S844 = to_face_frame_0(_S841, _S840.back_5);
    float3 _S845 = _S840.view_6;
    HalfWeights_0 weights_27;
    Neural_0 _S846 = fabrics_0[_S839].neural_0;
    weights_27.first_2 = fabrics_0[_S839].neural_0.network_0;
    float  directions_0[int(39)];
    code_light_0(_S839, _S844, _S840.view_6, _S840.back_5, directions_0);
    float  skip_0[int(96)];
    int k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(96))
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = _S840.sums_2[k_1];
        k_1 = k_1 + int(1);
    }
    dense_3(weights_27, 3716U, true, directions_0, skip_0);
    float  hidden_2[int(96)];
    float  next_0[int(96)];
    k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(96))
        {
        }
        else
        {
            break;
        }
        hidden_2[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
        k_1 = k_1 + int(1);
    }
    uint layer_0 = 0U;
    for(;;)
    {
        if(layer_0 < 3U)
        {
        }
        else
        {
            break;
        }
        k_1 = int(0);
        for(;;)
        {
            if(k_1 < int(96))
            {
            }
            else
            {
                break;
            }
            if(layer_0 == 1U)
            {
                _S842 = skip_0[k_1];
            }
            else
            {
                _S842 = 0.0f;
            }
            next_0[k_1] = _S842;
            k_1 = k_1 + int(1);
        }
        dense_2(weights_27, 4208U + layer_0 * 1164U, true, hidden_2, next_0);
        int k_2 = int(0);
        for(;;)
        {
            if(k_2 < int(96))
            {
            }
            else
            {
                break;
            }
            hidden_2[k_2] = next_0[k_2];
            k_2 = k_2 + int(1);
        }
        layer_0 = layer_0 + 1U;
    }
    float  outputs_25[int(52)];
    dense_1(weights_27, 7700U, false, hidden_2, outputs_25);
    bool _S847;
    if((_S846.is_corrected_0) != 0U)
    {
        _S847 = (_S844.z) > 0.0f;
    }
    else
    {
        _S847 = false;
    }
    if(_S847)
    {
        _S847 = (_S840.correction_weight_0) > 0.0f;
    }
    else
    {
        _S847 = false;
    }
    if(_S847)
    {
        FloatWeights_0 fitted_0;
        fitted_0.first_0 = _S846.correction_0;
        float  change_0[int(50)];
        dense_0(fitted_0, 0U, false, hidden_2, change_0);
        k_1 = int(0);
        for(;;)
        {
            if(k_1 < int(50))
            {
            }
            else
            {
                break;
            }
            outputs_25[k_1 + int(2)] = outputs_25[k_1 + int(2)] + _S840.correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S844.z) > 0.0f)
    {
        _S842 = 0.00999999977648258f;
    }
    else
    {
        _S842 = 0.00100000004749745f;
    }
    Components_0 result_2;
    float _S848 = unmapped_0(outputs_25[int(0)], _S842);
    result_2.diffuse_warp_0 = _S848;
    float _S849 = unmapped_0(outputs_25[int(1)], _S842);
    result_2.diffuse_weft_0 = _S849;
    float _S850 = 2979.9580078125f * _S842;
    float _S851 = mixed_bundles_0(_S839, 0U, 2U, _S844, _S845, _S843, outputs_25);
    result_2.specular_warp_0 = clamp(_S851, 0.0f, _S850);
    float _S852 = mixed_bundles_0(_S839, 1U, 2U, _S844, _S845, _S843, outputs_25);
    result_2.specular_weft_0 = clamp(_S852, 0.0f, _S850);
    result_2.hole_2 = _S840.hole_0;
    result_2.light_visibility_1 = min(light_visibility_of_0(_S848 + _S849, _S844, _S845, fabrics_0[_S839].diffuse_blend_0), 1.0f - _S840.hole_0);
    return result_2;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_4;
    Albedos_0 weft_4;
};

FamilyAlbedos_0 albedos_over_0(uint _S853, Footprint_0 _S854, bool _S855)
{
    float2 _S856 = _S854.dx_0;
    float2 _S857 = _S854.dy_0;
    float2 _S858 = sqrt(_S856 * _S856 + _S857 * _S857);
    Stretch_0 _S859 = stretch_of_0(fabrics_0[_S853].warp_0, _S854.centre_0.x, _S858.x);
    Stretch_0 _S860 = stretch_of_0(fabrics_0[_S853].weft_0, _S854.centre_0.y, _S858.y);
    FamilyAlbedos_0 albedos_4;
    albedos_4.warp_4 = mean_albedos_0(fabrics_0[_S853].warp_0, fabrics_0[_S853].weft_0, _S859, _S860, _S855);
    albedos_4.weft_4 = mean_albedos_0(fabrics_0[_S853].weft_0, fabrics_0[_S853].warp_0, _S860, _S859, _S855);
    return albedos_4;
}

float openness_number_0(uint _S861, uint _S862)
{
    return table_number_0(fabrics_0[_S861].openness_0 + _S862);
}

Scattered_0 scattered_by_0(uint _S863, Albedos_0 _S864, uint _S865, float3 _S866)
{
    uint _S867 = 159U + 2U * _S865;
    Scattered_0 yarn_1;
    yarn_1.back_4 = _S866 * _S864.diffuse_reflect_0 + openness_number_0(_S863, _S867) * _S864.specular_reflect_0;
    yarn_1.through_0 = _S866 * _S864.diffuse_transmit_0 + openness_number_0(_S863, _S867 + 1U) * _S864.specular_transmit_0;
    return yarn_1;
}

void sent_0(uint _S868, uint _S869, float3 _S870, float3 _S871, float3 _S872, float3 _S873, out float3 _S874, out float3 _S875)
{
    uint _S876 = 146U + 4U * _S869;
    float _S877 = openness_number_0(_S868, _S876 + 1U);
    float _S878 = openness_number_0(_S868, _S876 + 2U);
    float3 _S879 = 1.0f - _S872 * openness_number_0(_S868, _S876);
    float3 _S880 = 1.0f - _S873 * openness_number_0(_S868, _S876 + 3U);
    float3 _S881 = 1.0f / (_S879 * _S880 - _S872 * _S873 * (_S877 * _S878));
    _S874 = (_S870 * _S880 + _S872 * _S877 * _S871) * _S881;
    _S875 = (_S871 * _S879 + _S873 * _S878 * _S870) * _S881;
    return;
}

FaceSends_0 face_sends_0(uint _S882, uint _S883, Scattered_0 _S884, Scattered_0 _S885)
{
    uint _S886 = 2U * _S883;
    uint _S887 = 142U + _S886;
    float _S888 = openness_number_0(_S882, _S887);
    float _S889 = openness_number_0(_S882, _S887 + 1U);
    float3 _S890 = (1.0f - _S888) * _S884.back_4;
    float3 _S891 = (1.0f - _S889) * _S885.back_4;
    FaceSends_0 sends_1;
    uint _S892 = 154U + _S886;
    float _S893 = openness_number_0(_S882, _S892);
    sends_1.blocks_warp_0 = _S893;
    float _S894 = openness_number_0(_S882, _S892 + 1U);
    sends_1.blocks_weft_0 = _S894;
    sends_1.open_0 = _S893 * _S888 + _S894 * _S889;
    sent_0(_S882, _S883, _S888 * _S884.back_4, _S889 * _S885.back_4, _S890, _S891, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S882, _S883, _S884.through_0, _S885.through_0, _S890, _S891, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S895, float3 _S896, bool _S897)
{
    Scattered_0 _S898 = scattered_by_0(_S895, table_albedos_0(families_0[fabrics_0[_S895].warp_0].colour_mean_0), 0U, _S896);
    Scattered_0 _S899 = scattered_by_0(_S895, table_albedos_0(families_0[fabrics_0[_S895].weft_0].colour_mean_0), 1U, _S896);
    uint _S900;
    if(_S897)
    {
        _S900 = 1U;
    }
    else
    {
        _S900 = 0U;
    }
    FaceSends_0 _S901 = face_sends_0(_S895, _S900, _S898, _S899);
    if(_S897)
    {
        _S900 = 0U;
    }
    else
    {
        _S900 = 1U;
    }
    FaceSends_0 _S902 = face_sends_0(_S895, _S900, _S898, _S899);
    float3 _S903 = _S901.blocks_warp_0 * _S901.crossing_warp_0 + _S901.blocks_weft_0 * _S901.crossing_weft_0;
    float3 _S904 = _S902.blocks_warp_0 * _S902.crossing_warp_0 + _S902.blocks_weft_0 * _S902.crossing_weft_0;
    float _S905 = 1.0f - _S901.open_0;
    float _S906 = 1.0f - _S902.open_0;
    float3 _S907 = 1.0f / (1.0f - _S903 * _S904 * (_S905 * _S906));
    float3 _S908 = _S904 * (_S901.open_0 + _S905 * (_S901.blocks_warp_0 * _S901.sky_warp_0 + _S901.blocks_weft_0 * _S901.sky_weft_0)) * _S907;
    float3 _S909 = _S903 * (_S902.open_0 + _S906 * (_S902.blocks_warp_0 * _S902.sky_warp_0 + _S902.blocks_weft_0 * _S902.sky_weft_0)) * _S907;
    FaceRadiance_0 _S910 = face_radiance_0(_S901, _S902.open_0, _S908, _S909);
    FaceRadiance_0 _S911 = face_radiance_0(_S902, _S901.open_0, _S909, _S908);
    Interior_0 interior_1;
    interior_1.warp_3 = _S910.warp_2;
    interior_1.weft_3 = _S910.weft_2;
    interior_1.leaked_1 = _S910.leaked_0;
    interior_1.far_1 = _S911.mean_0;
    interior_1.far_leaked_0 = _S911.leaked_0;
    return interior_1;
}

Blocked_0 blocked_of_terms_0(uint _S912, uint _S913, float  _S914[int(6)], uint _S915)
{
    float  shares_0[int(3)];
    uint share_1 = 0U;
    for(;;)
    {
        if(share_1 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_1] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S915)
            {
            }
            else
            {
                break;
            }
            shares_0[share_1] = shares_0[share_1] + openness_number_0(_S912, _S913 + share_1 * _S915 + term_0) * _S914[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_1] = saturate(shares_0[share_1]);
        share_1 = share_1 + 1U;
    }
    Blocked_0 blocked_2;
    blocked_2.by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    blocked_2.by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    blocked_2.far_0 = shares_0[int(1)];
    return blocked_2;
}

Blocked_0 blocked_from_0(uint _S916, float3 _S917, bool _S918, bool _S919)
{
    float  terms_1[int(6)];
    view_terms_0(_S917, terms_1);
    uint _S920;
    if(_S919)
    {
        _S920 = 2U;
    }
    else
    {
        _S920 = 0U;
    }
    uint _S921;
    if(_S918)
    {
        _S921 = 0U;
    }
    else
    {
        _S921 = 1U;
    }
    return blocked_of_terms_0(_S916, (_S920 + _S921) * 15U, terms_1, 5U);
}

float warp_seen_from_0(uint _S922, float3 _S923, bool _S924)
{
    float  terms_2[int(6)];
    view_terms_0(_S923, terms_2);
    uint term_1 = 0U;
    float share_2 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S925;
        if(_S924)
        {
            _S925 = 5U;
        }
        else
        {
            _S925 = 0U;
        }
        float share_3 = share_2 + openness_number_0(_S922, 132U + _S925 + term_1) * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_2 = share_3;
    }
    return saturate(share_2);
}

Bounced_0 bounced_of_families_0(uint _S926, FamilyAlbedos_0 _S927, float3 _S928, Interior_0 _S929, Blocked_0 _S930, Blocked_0 _S931)
{
    return sum_of_0(bounced_by_0(_S930, scattered_by_0(_S926, _S927.warp_4, 0U, _S928), _S929), bounced_by_0(_S931, scattered_by_0(_S926, _S927.weft_4, 1U, _S928), _S929));
}

Bounced_0 bounced_far_0(uint _S932, FamilyAlbedos_0 _S933, float3 _S934, Interior_0 _S935, float3 _S936, bool _S937, float _S938, float _S939, float _S940)
{
    Blocked_0 _S941 = blocked_from_0(_S932, _S936, true, _S937);
    Blocked_0 _S942 = blocked_from_0(_S932, _S936, false, _S937);
    float _S943 = _S938 / max(1.0f - _S941.by_warp_0 - _S941.by_weft_0, 0.10000000149011612f);
    float _S944 = (0.0020000000949949f * warp_seen_from_0(_S932, _S936, _S937) + _S943) / (_S943 + _S939 / max(1.0f - _S942.by_warp_0 - _S942.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    float _S945 = 1.0f - _S940;
    return bounced_of_families_0(_S932, _S933, _S934, _S935, scaled_0(_S941, _S944 * _S945), scaled_0(_S942, (1.0f - _S944) * _S945));
}

Bounced_0 bounced_over_0(uint _S946, Components_0 _S947, CloseUp_0 _S948, FamilyAlbedos_0 _S949, float3 _S950, float3 _S951)
{
    bool _S952 = (_S951.z) < 0.0f;
    Interior_0 _S953 = interior_of_0(_S946, _S950, _S952);
    Bounced_0 bounced_2 = bounced_far_0(_S946, _S949, _S950, _S953, to_face_frame_0(_S951, _S952), _S952, _S947.diffuse_warp_0, _S947.diffuse_weft_0, _S947.hole_2);
    if((_S948.weight_2) > 0.0f)
    {
        Bounced_0 _S954 = bounced_of_families_0(_S946, _S949, _S950, _S953, _S948.warp_1, _S948.weft_1);
        float3 _S955 = (float3)_S948.weight_2;
        bounced_2.reflected_0 = lerp(bounced_2.reflected_0, _S954.reflected_0, _S955);
        bounced_2.transmitted_0 = lerp(bounced_2.transmitted_0, _S954.transmitted_0, _S955);
    }
    return bounced_2;
}

float3 composed_0(uint _S956, Components_0 _S957, CloseUp_0 _S958, FamilyAlbedos_0 _S959, float3 _S960, float3 _S961, float3 _S962)
{
    Albedos_0 _S963 = tinted_0(_S959.warp_4, _S960);
    Albedos_0 _S964 = tinted_0(_S959.weft_4, _S960);
    float3 _S965 = _S963.diffuse_reflect_0 * _S957.diffuse_warp_0 + _S964.diffuse_reflect_0 * _S957.diffuse_weft_0 + _S963.specular_reflect_0 * _S957.specular_warp_0 + _S964.specular_reflect_0 * _S957.specular_weft_0;
    float _S966 = _S962.z;
    float3 body_0;
    if((_S961.z * _S966) < 0.0f)
    {
        body_0 = _S963.diffuse_transmit_0 * _S957.diffuse_warp_0 + _S964.diffuse_transmit_0 * _S957.diffuse_weft_0 + _S963.specular_transmit_0 * _S957.specular_warp_0 + _S964.specular_transmit_0 * _S957.specular_weft_0;
    }
    else
    {
        body_0 = _S965;
    }
    if((fabrics_0[_S956].openness_0) != 4294967295U)
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S956, _S957, _S958, _S959, _S960, _S962), _S961, _S962);
    }
    float _S967 = fabrics_0[_S956].sheen_strength_0;
    if((fabrics_0[_S956].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S968 = _S966 < 0.0f;
    float2 _S969 = sheen_with_transmittance_0(to_face_frame_0(_S961, _S968), to_face_frame_0(_S962, _S968), _S967, fabrics_0[_S956].sheen_roughness_0);
    return _S969.y * body_0 + (_S957.light_visibility_1 + _S957.hole_2) * _S969.x;
}

float4 cloth_value_0(uint fabric_1, float2 centre_3, float2 dx_1, float2 dy_1, float3 light_5, float3 view_7)
{
    Footprint_0 footprint_1;
    footprint_1.centre_0 = centre_3;
    footprint_1.dx_0 = dx_1;
    footprint_1.dy_0 = dy_1;
    NeuralView_0 activations_0;
    neural_view_0(fabric_1, footprint_1, view_7, activations_0);
    Components_0 _S970 = neural_components_0(fabric_1, activations_0, light_5);
    float _S971 = view_7.z;
    float3 _S972 = composed_0(fabric_1, _S970, no_close_up_0(), albedos_over_0(fabric_1, footprint_1, _S971 < 0.0f), (float3)1.0f, light_5, view_7);
    float through_1 = activations_0.hole_0;
    float through_2;
    if((fabrics_0[fabric_1].sheen_strength_0) > 0.0f)
    {
        through_2 = through_1 * (1.0f - fabrics_0[fabric_1].sheen_strength_0 * sheen_lobe_0(abs(_S971), fabrics_0[fabric_1].sheen_roughness_0).z);
    }
    else
    {
        through_2 = through_1;
    }
    return float4(_S972, through_2);
}

[shader("compute")][numthreads(64, 1, 1)]
void neural_queries(uint3 id_0 : SV_DispatchThreadID)
{
    if((id_0.x) >= query_count_0.Load(int(0)))
    {
        return;
    }
    Query_0 _S973 = queries_0.Load(id_0.x);
    float4 _S974 = cloth_value_0(_S973.fabric_0, float2(_S973.centre_x_0, _S973.centre_y_0), float2(_S973.dx_x_0, _S973.dx_y_0), float2(_S973.dy_x_0, _S973.dy_y_0), float3(_S973.light_x_0, _S973.light_y_0, _S973.light_z_0), float3(_S973.view_x_0, _S973.view_y_0, _S973.view_z_0));
    answers_0[id_0.x] = _S974;
    return;
}

