#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
struct FloatWeights_0
{
    uint first_0;
};

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

struct Layer_0
{
    uint face_0;
    float share_0;
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

struct KernelContext_0
{
    Frame_0 device* frames_0;
    Layer_0 device* layers_0;
    uint device* face_fabrics_0;
    Fabric_0 device* fabrics_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
    uint device* words_0;
    packed_uint4 device* packed_numbers_0;
    float device* visibilities_0;
    uint device* scene_words_0;
    Light_0 device* lights_1;
    packed_float4 device* radiance_0;
};

int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

struct Eight_0
{
    float4 low_0;
    float4 high_0;
};

Eight_0 FloatWeights_eight_0(const FloatWeights_0 thread* this_0, uint element_0, KernelContext_0 thread* kernelContext_0)
{
    thread Eight_0 numbers_0;
    uint _S1 = this_0->first_0 + 2U * element_0;
    (&numbers_0)->low_0 = (as_type<float4>((uint4(*(kernelContext_0->packed_numbers_0+_S1)) )));
    (&numbers_0)->high_0 = (as_type<float4>((uint4(*(kernelContext_0->packed_numbers_0+(_S1 + 1U))) )));
    return numbers_0;
}

float4 tile_product_0(const FloatWeights_0 thread* weights_0, uint row_0, array<float, int(25)> thread* inputs_0, KernelContext_0 thread* kernelContext_1)
{
    thread float4 sums_0 = float4(0.0f) ;
    uint column_0 = 0U;
    for(;;)
    {
        if(column_0 < 4U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_1;
        thread float4 high_1;
        int _S2 = int(8U * column_0);
        low_1.x = (*inputs_0)[min(_S2, int(24))];
        high_1.x = (*inputs_0)[min(_S2 + int(4), int(24))];
        int _S3 = _S2 + int(1);
        low_1.y = (*inputs_0)[min(_S3, int(24))];
        high_1.y = (*inputs_0)[min(_S3 + int(4), int(24))];
        int _S4 = _S2 + int(2);
        low_1.z = (*inputs_0)[min(_S4, int(24))];
        high_1.z = (*inputs_0)[min(_S4 + int(4), int(24))];
        int _S5 = _S2 + int(3);
        low_1.w = (*inputs_0)[min(_S5, int(24))];
        high_1.w = (*inputs_0)[min(_S5 + int(4), int(24))];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0, kernelContext_1);
        sums_0.x = sums_0.x + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 4U + column_0, kernelContext_1);
        sums_0.y = sums_0.y + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0, kernelContext_1);
        sums_0.z = sums_0.z + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0, kernelContext_1);
        sums_0.w = sums_0.w + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

float Identity_apply_0(float x_2)
{
    return x_2;
}

void dense_part_0(const FloatWeights_0 thread* weights_1, uint first_1, bool adds_0, array<float, int(25)> thread* inputs_1, array<float, int(3)> thread* outputs_0, KernelContext_0 thread* kernelContext_2)
{
    uint _S10 = first_1 + uint(whole_parts_0(int(1)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S11 = output_0 < int(3);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U, kernelContext_2);
        float4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 4U, inputs_1, kernelContext_2);
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
                _S17 = (*outputs_0)[output_0];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S16[int(0)] + _S17);
        }
        int _S18 = output_0 + int(1);
        if(_S18 < int(3))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S18] = Identity_apply_0(_S16[int(1)] + _S17);
        }
        int _S19 = output_0 + int(2);
        if(_S19 < int(3))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S19] = Identity_apply_0(_S16[int(2)] + _S17);
        }
        int _S20 = output_0 + int(3);
        if(_S20 < int(3))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S20] = Identity_apply_0(_S16[int(3)] + _S17);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

float4 tile_product_1(const FloatWeights_0 thread* weights_2, uint row_1, array<float, int(11)> thread* inputs_2, KernelContext_0 thread* kernelContext_3)
{
    thread float4 sums_1 = float4(0.0f) ;
    uint column_1 = 0U;
    for(;;)
    {
        if(column_1 < 2U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_2;
        thread float4 high_2;
        int _S21 = int(8U * column_1);
        low_2.x = (*inputs_2)[min(_S21, int(10))];
        high_2.x = (*inputs_2)[min(_S21 + int(4), int(10))];
        int _S22 = _S21 + int(1);
        low_2.y = (*inputs_2)[min(_S22, int(10))];
        high_2.y = (*inputs_2)[min(_S22 + int(4), int(10))];
        int _S23 = _S21 + int(2);
        low_2.z = (*inputs_2)[min(_S23, int(10))];
        high_2.z = (*inputs_2)[min(_S23 + int(4), int(10))];
        int _S24 = _S21 + int(3);
        low_2.w = (*inputs_2)[min(_S24, int(10))];
        high_2.w = (*inputs_2)[min(_S24 + int(4), int(10))];
        Eight_0 _S25 = FloatWeights_eight_0(weights_2, row_1 + column_1, kernelContext_3);
        sums_1.x = sums_1.x + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        Eight_0 _S26 = FloatWeights_eight_0(weights_2, row_1 + 2U + column_1, kernelContext_3);
        sums_1.y = sums_1.y + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        Eight_0 _S27 = FloatWeights_eight_0(weights_2, row_1 + 4U + column_1, kernelContext_3);
        sums_1.z = sums_1.z + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        Eight_0 _S28 = FloatWeights_eight_0(weights_2, row_1 + 6U + column_1, kernelContext_3);
        sums_1.w = sums_1.w + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
}

float Relu_apply_0(float x_3)
{
    return max(x_3, 0.0f);
}

void dense_part_1(const FloatWeights_0 thread* weights_3, uint first_2, bool adds_1, array<float, int(11)> thread* inputs_3, array<float, int(25)> thread* outputs_1, KernelContext_0 thread* kernelContext_4)
{
    uint _S29 = first_2 + uint(whole_parts_0(int(4)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S30 = output_1 < int(25);
        if(_S30)
        {
        }
        else
        {
            break;
        }
        uint _S31 = uint(output_1);
        Eight_0 _S32 = FloatWeights_eight_0(weights_3, first_2 + _S31 / 8U, kernelContext_4);
        float4 _S33 = tile_product_1(weights_3, _S29 + _S31 * 2U, inputs_3, kernelContext_4);
        float4 _S34;
        if((output_1 & int(4)) != int(0))
        {
            _S34 = _S32.high_0;
        }
        else
        {
            _S34 = _S32.low_0;
        }
        float4 _S35 = _S33 + _S34;
        float _S36;
        if(_S30)
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[output_1];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[output_1] = Relu_apply_0(_S35[int(0)] + _S36);
        }
        int _S37 = output_1 + int(1);
        if(_S37 < int(25))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S37];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S37] = Relu_apply_0(_S35[int(1)] + _S36);
        }
        int _S38 = output_1 + int(2);
        if(_S38 < int(25))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S38];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S38] = Relu_apply_0(_S35[int(2)] + _S36);
        }
        int _S39 = output_1 + int(3);
        if(_S39 < int(25))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S39];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S39] = Relu_apply_0(_S35[int(3)] + _S36);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

void dense_0(const FloatWeights_0 thread* weights_4, uint first_3, bool adds_2, array<float, int(25)> thread* inputs_4, array<float, int(3)> thread* outputs_2, KernelContext_0 thread* kernelContext_5)
{
    dense_part_0(weights_4, first_3, adds_2, inputs_4, outputs_2, kernelContext_5);
    return;
}

void dense_1(const FloatWeights_0 thread* weights_5, uint first_4, bool adds_3, array<float, int(11)> thread* inputs_5, array<float, int(25)> thread* outputs_3, KernelContext_0 thread* kernelContext_6)
{
    dense_part_1(weights_5, first_4, adds_3, inputs_5, outputs_3, kernelContext_6);
    return;
}

void dense_part_2(const FloatWeights_0 thread* weights_6, uint first_5, bool adds_4, array<float, int(25)> thread* inputs_6, array<float, int(25)> thread* outputs_4, KernelContext_0 thread* kernelContext_7)
{
    uint _S40 = first_5 + uint(whole_parts_0(int(4)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S41 = output_2 < int(25);
        if(_S41)
        {
        }
        else
        {
            break;
        }
        uint _S42 = uint(output_2);
        Eight_0 _S43 = FloatWeights_eight_0(weights_6, first_5 + _S42 / 8U, kernelContext_7);
        float4 _S44 = tile_product_0(weights_6, _S40 + _S42 * 4U, inputs_6, kernelContext_7);
        float4 _S45;
        if((output_2 & int(4)) != int(0))
        {
            _S45 = _S43.high_0;
        }
        else
        {
            _S45 = _S43.low_0;
        }
        float4 _S46 = _S44 + _S45;
        float _S47;
        if(_S41)
        {
            if(adds_4)
            {
                _S47 = (*outputs_4)[output_2];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[output_2] = Relu_apply_0(_S46[int(0)] + _S47);
        }
        int _S48 = output_2 + int(1);
        if(_S48 < int(25))
        {
            if(adds_4)
            {
                _S47 = (*outputs_4)[_S48];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[_S48] = Relu_apply_0(_S46[int(1)] + _S47);
        }
        int _S49 = output_2 + int(2);
        if(_S49 < int(25))
        {
            if(adds_4)
            {
                _S47 = (*outputs_4)[_S49];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[_S49] = Relu_apply_0(_S46[int(2)] + _S47);
        }
        int _S50 = output_2 + int(3);
        if(_S50 < int(25))
        {
            if(adds_4)
            {
                _S47 = (*outputs_4)[_S50];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[_S50] = Relu_apply_0(_S46[int(3)] + _S47);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

void dense_part_3(const FloatWeights_0 thread* weights_7, uint first_6, bool adds_5, array<float, int(25)> thread* inputs_7, array<float, int(1)> thread* outputs_5, KernelContext_0 thread* kernelContext_8)
{
    uint _S51 = first_6 + uint(whole_parts_0(int(1)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S52 = output_3 < int(1);
        if(_S52)
        {
        }
        else
        {
            break;
        }
        uint _S53 = uint(output_3);
        Eight_0 _S54 = FloatWeights_eight_0(weights_7, first_6 + _S53 / 8U, kernelContext_8);
        float4 _S55 = tile_product_0(weights_7, _S51 + _S53 * 4U, inputs_7, kernelContext_8);
        float4 _S56;
        if((output_3 & int(4)) != int(0))
        {
            _S56 = _S54.high_0;
        }
        else
        {
            _S56 = _S54.low_0;
        }
        float4 _S57 = _S55 + _S56;
        float _S58;
        if(_S52)
        {
            if(adds_5)
            {
                _S58 = (*outputs_5)[output_3];
            }
            else
            {
                _S58 = 0.0f;
            }
            (*outputs_5)[output_3] = Identity_apply_0(_S57[int(0)] + _S58);
        }
        int _S59 = output_3 + int(1);
        if(_S59 < int(1))
        {
            if(adds_5)
            {
                _S58 = (*outputs_5)[_S59];
            }
            else
            {
                _S58 = 0.0f;
            }
            (*outputs_5)[_S59] = Identity_apply_0(_S57[int(1)] + _S58);
        }
        int _S60 = output_3 + int(2);
        if(_S60 < int(1))
        {
            if(adds_5)
            {
                _S58 = (*outputs_5)[_S60];
            }
            else
            {
                _S58 = 0.0f;
            }
            (*outputs_5)[_S60] = Identity_apply_0(_S57[int(2)] + _S58);
        }
        int _S61 = output_3 + int(3);
        if(_S61 < int(1))
        {
            if(adds_5)
            {
                _S58 = (*outputs_5)[_S61];
            }
            else
            {
                _S58 = 0.0f;
            }
            (*outputs_5)[_S61] = Identity_apply_0(_S57[int(3)] + _S58);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

float4 tile_product_2(const FloatWeights_0 thread* weights_8, uint row_2, array<float, int(9)> thread* inputs_8, KernelContext_0 thread* kernelContext_9)
{
    thread float4 sums_2 = float4(0.0f) ;
    uint column_2 = 0U;
    for(;;)
    {
        if(column_2 < 2U)
        {
        }
        else
        {
            break;
        }
        thread float4 low_3;
        thread float4 high_3;
        int _S62 = int(8U * column_2);
        low_3.x = (*inputs_8)[min(_S62, int(8))];
        high_3.x = (*inputs_8)[min(_S62 + int(4), int(8))];
        int _S63 = _S62 + int(1);
        low_3.y = (*inputs_8)[min(_S63, int(8))];
        high_3.y = (*inputs_8)[min(_S63 + int(4), int(8))];
        int _S64 = _S62 + int(2);
        low_3.z = (*inputs_8)[min(_S64, int(8))];
        high_3.z = (*inputs_8)[min(_S64 + int(4), int(8))];
        int _S65 = _S62 + int(3);
        low_3.w = (*inputs_8)[min(_S65, int(8))];
        high_3.w = (*inputs_8)[min(_S65 + int(4), int(8))];
        Eight_0 _S66 = FloatWeights_eight_0(weights_8, row_2 + column_2, kernelContext_9);
        sums_2.x = sums_2.x + (dot(_S66.low_0, low_3) + dot(_S66.high_0, high_3));
        Eight_0 _S67 = FloatWeights_eight_0(weights_8, row_2 + 2U + column_2, kernelContext_9);
        sums_2.y = sums_2.y + (dot(_S67.low_0, low_3) + dot(_S67.high_0, high_3));
        Eight_0 _S68 = FloatWeights_eight_0(weights_8, row_2 + 4U + column_2, kernelContext_9);
        sums_2.z = sums_2.z + (dot(_S68.low_0, low_3) + dot(_S68.high_0, high_3));
        Eight_0 _S69 = FloatWeights_eight_0(weights_8, row_2 + 6U + column_2, kernelContext_9);
        sums_2.w = sums_2.w + (dot(_S69.low_0, low_3) + dot(_S69.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
}

void dense_part_4(const FloatWeights_0 thread* weights_9, uint first_7, bool adds_6, array<float, int(9)> thread* inputs_9, array<float, int(25)> thread* outputs_6, KernelContext_0 thread* kernelContext_10)
{
    uint _S70 = first_7 + uint(whole_parts_0(int(4)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S71 = output_4 < int(25);
        if(_S71)
        {
        }
        else
        {
            break;
        }
        uint _S72 = uint(output_4);
        Eight_0 _S73 = FloatWeights_eight_0(weights_9, first_7 + _S72 / 8U, kernelContext_10);
        float4 _S74 = tile_product_2(weights_9, _S70 + _S72 * 2U, inputs_9, kernelContext_10);
        float4 _S75;
        if((output_4 & int(4)) != int(0))
        {
            _S75 = _S73.high_0;
        }
        else
        {
            _S75 = _S73.low_0;
        }
        float4 _S76 = _S74 + _S75;
        float _S77;
        if(_S71)
        {
            if(adds_6)
            {
                _S77 = (*outputs_6)[output_4];
            }
            else
            {
                _S77 = 0.0f;
            }
            (*outputs_6)[output_4] = Relu_apply_0(_S76[int(0)] + _S77);
        }
        int _S78 = output_4 + int(1);
        if(_S78 < int(25))
        {
            if(adds_6)
            {
                _S77 = (*outputs_6)[_S78];
            }
            else
            {
                _S77 = 0.0f;
            }
            (*outputs_6)[_S78] = Relu_apply_0(_S76[int(1)] + _S77);
        }
        int _S79 = output_4 + int(2);
        if(_S79 < int(25))
        {
            if(adds_6)
            {
                _S77 = (*outputs_6)[_S79];
            }
            else
            {
                _S77 = 0.0f;
            }
            (*outputs_6)[_S79] = Relu_apply_0(_S76[int(2)] + _S77);
        }
        int _S80 = output_4 + int(3);
        if(_S80 < int(25))
        {
            if(adds_6)
            {
                _S77 = (*outputs_6)[_S80];
            }
            else
            {
                _S77 = 0.0f;
            }
            (*outputs_6)[_S80] = Relu_apply_0(_S76[int(3)] + _S77);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

void dense_2(const FloatWeights_0 thread* weights_10, uint first_8, bool adds_7, array<float, int(25)> thread* inputs_10, array<float, int(25)> thread* outputs_7, KernelContext_0 thread* kernelContext_11)
{
    dense_part_2(weights_10, first_8, adds_7, inputs_10, outputs_7, kernelContext_11);
    return;
}

void dense_3(const FloatWeights_0 thread* weights_11, uint first_9, bool adds_8, array<float, int(25)> thread* inputs_11, array<float, int(1)> thread* outputs_8, KernelContext_0 thread* kernelContext_12)
{
    dense_part_3(weights_11, first_9, adds_8, inputs_11, outputs_8, kernelContext_12);
    return;
}

void dense_4(const FloatWeights_0 thread* weights_12, uint first_10, bool adds_9, array<float, int(9)> thread* inputs_12, array<float, int(25)> thread* outputs_9, KernelContext_0 thread* kernelContext_13)
{
    dense_part_4(weights_12, first_10, adds_9, inputs_12, outputs_9, kernelContext_13);
    return;
}

struct MLP_0
{
    FloatWeights_0 weights_13;
};

int layer_size_0(int inputs_13, int outputs_10)
{
    return whole_parts_0((outputs_10 + int(7)) / int(8)) + whole_parts_0((inputs_13 + int(7)) / int(8) * ((outputs_10 + int(4) - int(1)) / int(4) * int(4)));
}

void MLP_evaluate_0(const MLP_0 thread* this_1, array<float, int(11)> thread* inputs_14, array<float, int(3)> thread* outputs_11, KernelContext_0 thread* kernelContext_14)
{
    thread array<float, int(25)> odd_0;
    thread array<float, int(25)> even_0;
    dense_1(&this_1->weights_13, 0U, false, inputs_14, &even_0, kernelContext_14);
    int layer_0 = int(1);
    for(;;)
    {
        if(layer_0 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S81 = layer_size_0(int(25), int(25));
        uint _S82 = uint(layer_size_0(int(11), int(25)) + (layer_0 - int(1)) * _S81);
        dense_2(&this_1->weights_13, _S82, false, &even_0, &odd_0, kernelContext_14);
        if((layer_0 + int(1)) < int(3))
        {
            dense_2(&this_1->weights_13, _S82 + uint(_S81), false, &odd_0, &even_0, kernelContext_14);
        }
        layer_0 = layer_0 + int(2);
    }
    uint _S83 = uint(layer_size_0(int(11), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_0(&this_1->weights_13, _S83, false, &even_0, outputs_11, kernelContext_14);
    return;
}

void MLP_evaluate_1(const MLP_0 thread* this_2, array<float, int(9)> thread* inputs_15, array<float, int(1)> thread* outputs_12, KernelContext_0 thread* kernelContext_15)
{
    thread array<float, int(25)> odd_1;
    thread array<float, int(25)> even_1;
    dense_4(&this_2->weights_13, 0U, false, inputs_15, &even_1, kernelContext_15);
    int layer_1 = int(1);
    for(;;)
    {
        if(layer_1 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S84 = layer_size_0(int(25), int(25));
        uint _S85 = uint(layer_size_0(int(9), int(25)) + (layer_1 - int(1)) * _S84);
        dense_2(&this_2->weights_13, _S85, false, &even_1, &odd_1, kernelContext_15);
        if((layer_1 + int(1)) < int(3))
        {
            dense_2(&this_2->weights_13, _S85 + uint(_S84), false, &odd_1, &even_1, kernelContext_15);
        }
        layer_1 = layer_1 + int(2);
    }
    uint _S86 = uint(layer_size_0(int(9), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_3(&this_2->weights_13, _S86, false, &even_1, outputs_12, kernelContext_15);
    return;
}

float2 f16tof32_0(uint2 value_0)
{
    thread float2 result_0;
    int i_0 = int(0);
    for(;;)
    {
        if(i_0 < int(2))
        {
        }
        else
        {
            break;
        }
        result_0[i_0] = (as_type<half>((ushort)((value_0[i_0]))));
        i_0 = i_0 + int(1);
    }
    return result_0;
}

float3 position_of_0(const Vertex_0 thread* vertex_0)
{
    return float3(vertex_0->x_0, vertex_0->y_0, vertex_0->z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

float3 normal_of_0(const Vertex_0 thread* vertex_1)
{
    return float3(vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_0;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(const VisiblePoint_0 thread* point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0->axis_x_0), dot(direction_0, point_0->axis_y_0), dot(direction_0, point_0->normal_0));
}

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S87 = direction_1.xy;
    float _S88;
    if(back_1)
    {
        _S88 = - direction_1.z;
    }
    else
    {
        _S88 = direction_1.z;
    }
    return float3(_S87, _S88);
}

Eight_0 no_numbers_0()
{
    thread Eight_0 numbers_1;
    float4 _S89 = float4(0.0f) ;
    (&numbers_1)->low_0 = _S89;
    (&numbers_1)->high_0 = _S89;
    return numbers_1;
}

Eight_0 eight_halves_0(uint4 packed_0)
{
    thread Eight_0 numbers_2;
    uint _S90 = packed_0.x;
    uint _S91 = packed_0.y;
    (&numbers_2)->low_0 = float4(f16tof32_0(uint2(_S90 & 65535U, _S90 >> 16U)), f16tof32_0(uint2(_S91 & 65535U, _S91 >> 16U)));
    uint _S92 = packed_0.z;
    uint _S93 = packed_0.w;
    (&numbers_2)->high_0 = float4(f16tof32_0(uint2(_S92 & 65535U, _S92 >> 16U)), f16tof32_0(uint2(_S93 & 65535U, _S93 >> 16U)));
    return numbers_2;
}

Eight_0 texel_numbers_0(uint first_11, uint elements_1, uint texel_0, KernelContext_0 thread* kernelContext_16)
{
    uint _S94 = first_11 + texel_0 * elements_1;
    uint4 _S95 = uint4(*(kernelContext_16->packed_numbers_0+_S94)) ;
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S95);
    }
    thread Eight_0 numbers_3;
    (&numbers_3)->low_0 = (as_type<float4>((_S95)));
    (&numbers_3)->high_0 = (as_type<float4>((uint4(*(kernelContext_16->packed_numbers_0+(_S94 + 1U))) )));
    return numbers_3;
}

void add_bilinear_0(uint first_12, uint elements_2, uint start_0, uint columns_0, uint rows_0, float2 uv_1, float weight_0, Eight_0 thread* sums_3, KernelContext_0 thread* kernelContext_17)
{
    float2 _S96 = uv_1 * float2(float(columns_0), float(rows_0)) - float2(0.5f) ;
    float2 _S97 = floor(_S96);
    float2 _S98 = _S96 - _S97;
    int _S99 = int(_S97.x);
    int _S100 = int(_S97.y);
    uint tap_0 = 0U;
    for(;;)
    {
        if(tap_0 < 4U)
        {
        }
        else
        {
            break;
        }
        uint _S101 = tap_0 & 1U;
        uint _S102 = tap_0 >> 1U;
        Eight_0 _S103 = texel_numbers_0(first_12, elements_2, start_0 + (uint(_S100 + int(_S102)) & (rows_0 - 1U)) * columns_0 + (uint(_S99 + int(_S101)) & (columns_0 - 1U)), kernelContext_17);
        float _S104;
        if(_S102 != 0U)
        {
            _S104 = _S98.y;
        }
        else
        {
            _S104 = 1.0f - _S98.y;
        }
        float _S105;
        if(_S101 != 0U)
        {
            _S105 = _S98.x;
        }
        else
        {
            _S105 = 1.0f - _S98.x;
        }
        float4 _S106 = float4((_S104 * _S105 * weight_0)) ;
        sums_3->low_0 = sums_3->low_0 + _S106 * _S103.low_0;
        sums_3->high_0 = sums_3->high_0 + _S106 * _S103.high_0;
        tap_0 = tap_0 + 1U;
    }
    return;
}

float channel_0(const Eight_0 thread* numbers_4, int k_0)
{
    float _S107;
    if(k_0 < int(4))
    {
        _S107 = numbers_4->low_0[k_0];
    }
    else
    {
        _S107 = numbers_4->high_0[k_0 - int(4)];
    }
    return _S107;
}

float neumip_depth_0(const Neumip_0 thread* model_0, float2 uv_2, float2 view_1, uint face_1, KernelContext_0 thread* kernelContext_18)
{
    uint _S108 = kernelContext_18->words_0[model_0->levels_2 + 1U];
    uint _S109 = kernelContext_18->words_0[model_0->levels_2 + 2U];
    thread Eight_0 texel_1 = no_numbers_0();
    add_bilinear_0(model_0->offset_texels_0, model_0->texel_elements_0, face_1 * _S108 * _S109, _S108, _S109, fract(uv_2), 1.0f, &texel_1, kernelContext_18);
    thread array<float, int(9)> inputs_16;
    int k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(7))
        {
        }
        else
        {
            break;
        }
        thread Eight_0 _S110 = texel_1;
        float _S111 = channel_0(&_S110, k_1);
        inputs_16[k_1] = _S111;
        k_1 = k_1 + int(1);
    }
    inputs_16[int(7)] = view_1.x;
    inputs_16[int(8)] = view_1.y;
    thread MLP_0 network_1;
    (&(&network_1)->weights_13)->first_0 = model_0->offset_0;
    thread MLP_0 _S112 = network_1;
    thread array<float, int(1)> depth_0;
    MLP_evaluate_1(&_S112, &inputs_16, &depth_0, kernelContext_18);
    return depth_0[int(0)];
}

float natural_logarithm_0(float x_4)
{
    uint _S113 = (as_type<uint>((x_4)));
    float exponent_0 = float(int(_S113 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S113 & 8388607U) | 1056964608U)));
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
    float _S114 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S114 - exponent_1 * 0.00021219444170129f - 0.5f * _S114) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_5)
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
}

Eight_0 neumip_texel_0(const Neumip_0 thread* model_1, float2 uv_3, float level_0, uint face_2, KernelContext_0 thread* kernelContext_19)
{
    float _S115 = clamp(level_0, 0.0f, model_1->last_level_1);
    float _S116 = clamp(floor(_S115), 0.0f, max(model_1->last_level_1 - 1.0f, 0.0f));
    float _S117 = _S115 - _S116;
    float2 _S118 = clamp(fract(uv_3), float2(0.0f) , float2(1.0f) );
    thread Eight_0 texel_2 = no_numbers_0();
    uint offset_1 = 0U;
    for(;;)
    {
        if(offset_1 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S119;
        if(offset_1 == 0U)
        {
            _S119 = 1.0f - _S117;
        }
        else
        {
            _S119 = _S117;
        }
        if(_S119 <= 0.0f)
        {
            offset_1 = offset_1 + 1U;
            continue;
        }
        uint _S120 = model_1->levels_2 + 3U * (uint(_S116) + offset_1);
        add_bilinear_0(model_1->features_0, model_1->texel_elements_0, face_2 * model_1->face_texels_0 + kernelContext_19->words_0[_S120], kernelContext_19->words_0[_S120 + 1U], kernelContext_19->words_0[_S120 + 2U], _S118, _S119, &texel_2, kernelContext_19);
        offset_1 = offset_1 + 1U;
    }
    return texel_2;
}

uint scramble_0(uint value_1)
{
    uint _S121 = value_1 * 747796405U + 2891336453U;
    uint _S122 = ((_S121 >> ((_S121 >> 28U) + 4U)) ^ _S121) * 277803737U;
    return (_S122 >> 22U) ^ _S122;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_0, uint stream_1)
{
    uint _S123 = pixel_0.x;
    uint _S124 = pixel_0.y;
    return fract(float2(uniform_hash_0(_S123, _S124, stream_1), uniform_hash_0(_S123, _S124, stream_1 + 1U)) + float2(float(index_0 & 65535U))  * float2(0.75487768650054932f, 0.56984031200408936f));
}

float scene_number_0(uint index_1, KernelContext_0 thread* kernelContext_20)
{
    return (as_type<float>((kernelContext_20->scene_words_0[index_1])));
}

struct Choice_0
{
    uint index_2;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_0, float number_0, KernelContext_0 thread* kernelContext_21)
{
    uint high_4 = count_0;
    uint low_4 = 0U;
    for(;;)
    {
        if((high_4 - low_4) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S125 = (low_4 + high_4) / 2U;
        float _S126 = scene_number_0(table_0 + _S125, kernelContext_21);
        if(_S126 <= number_0)
        {
            low_4 = _S125;
        }
        else
        {
            high_4 = _S125;
        }
    }
    uint _S127 = table_0 + low_4;
    float _S128 = scene_number_0(_S127, kernelContext_21);
    float _S129 = scene_number_0(_S127 + 1U, kernelContext_21);
    thread Choice_0 choice_0;
    (&choice_0)->index_2 = low_4;
    (&choice_0)->remainder_0 = saturate((number_0 - _S128) / max(_S129 - _S128, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_6)
{
    float _S130 = floor(x_6 * 0.63661974668502808f + 0.5f);
    float _S131 = x_6 - _S130 * 1.5703125f - _S130 * 0.00048375129699707f - _S130 * 7.54979012640433211e-08f;
    float _S132 = _S131 * _S131;
    float _S133 = ((-0.00019515295571182f * _S132 + 0.00833216123282909f) * _S132 - 0.16666655242443085f) * _S132 * _S131 + _S131;
    float _S134 = ((0.00002443315679557f * _S132 - 0.00138873164542019f) * _S132 + 0.04166664555668831f) * _S132 * _S132 - 0.5f * _S132 + 1.0f;
    uint _S135 = uint(int(_S130)) & 3U;
    float2 _S136;
    if((_S135 & 1U) != 0U)
    {
        _S136 = float2(_S134, _S133);
    }
    else
    {
        _S136 = float2(_S133, _S134);
    }
    float _S137;
    if((_S135 & 2U) != 0U)
    {
        _S137 = - _S136.x;
    }
    else
    {
        _S137 = _S136.x;
    }
    float _S138;
    if(((_S135 + 1U) & 2U) != 0U)
    {
        _S138 = - _S136.y;
    }
    else
    {
        _S138 = _S136.y;
    }
    return float2(_S137, _S138);
}

void accumulate_0(uint index_3, float4 light_0, KernelContext_0 thread* kernelContext_22)
{
    float _S139 = (kernelContext_22->layers_0+index_3)->share_0;
    packed_float4 device* _S140 = kernelContext_22->radiance_0+index_3;
    *_S140 = packed_float4((float4(*_S140)  + float4((kernelContext_22->layers_0+index_3)->share_0)  * light_0)) ;
    (kernelContext_22->layers_0+index_3)->share_0 = _S139 * (1.0f - light_0.w);
    return;
}

float3 camera_right_0(int _S141, KernelContext_0 thread* kernelContext_23)
{
    Frame_0 device* _S142 = kernelContext_23->frames_0+_S141;
    return float3(_S142->right_x_0, _S142->right_y_0, _S142->right_z_0);
}

float3 camera_up_0(int _S143, KernelContext_0 thread* kernelContext_24)
{
    Frame_0 device* _S144 = kernelContext_24->frames_0+_S143;
    return float3(_S144->up_x_0, _S144->up_y_0, _S144->up_z_0);
}

float3 camera_forward_0(int _S145, KernelContext_0 thread* kernelContext_25)
{
    Frame_0 device* _S146 = kernelContext_25->frames_0+_S145;
    return float3(_S146->forward_x_0, _S146->forward_y_0, _S146->forward_z_0);
}

float3 camera_origin_0(int _S147, KernelContext_0 thread* kernelContext_26)
{
    Frame_0 device* _S148 = kernelContext_26->frames_0+_S147;
    return float3(_S148->origin_x_0, _S148->origin_y_0, _S148->origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S149, uint _S150, float _S151, float _S152, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S153 = kernelContext_27->fabrics_0+_S149;
    uint _S154 = 3U * _S150;
    Vertex_0 _S155 = kernelContext_27->vertices_0[kernelContext_27->corners_0[_S154]];
    Vertex_0 _S156 = kernelContext_27->vertices_0[kernelContext_27->corners_0[_S154 + 1U]];
    Vertex_0 _S157 = kernelContext_27->vertices_0[kernelContext_27->corners_0[_S154 + 2U]];
    thread Vertex_0 _S158 = _S156;
    float3 _S159 = position_of_0(&_S158);
    thread Vertex_0 _S160 = _S155;
    float3 _S161 = position_of_0(&_S160);
    float3 _S162 = _S159 - _S161;
    thread Vertex_0 _S163 = _S157;
    float3 _S164 = position_of_0(&_S163);
    float3 _S165 = _S164 - _S161;
    float _S166 = _S156.u_0 - _S155.u_0;
    float _S167 = _S156.v_0 - _S155.v_0;
    float2 _S168 = float2(_S166, _S167);
    float _S169 = _S157.u_0 - _S155.u_0;
    float _S170 = _S157.v_0 - _S155.v_0;
    float2 _S171 = float2(_S169, _S170);
    float _S172;
    if((_S166 * _S170 - _S167 * _S169) < 0.0f)
    {
        _S172 = -1.0f;
    }
    else
    {
        _S172 = 1.0f;
    }
    float3 _S173 = float3(_S172)  * (float3(_S170)  * _S162 - float3(_S167)  * _S165);
    float3 _S174 = float3(_S172)  * (float3(_S166)  * _S165 - float3(_S169)  * _S162);
    thread VisiblePoint_0 point_1;
    float _S175 = 1.0f - _S151 - _S152;
    thread Vertex_0 _S176 = _S155;
    float3 _S177 = normal_of_0(&_S176);
    float3 _S178 = float3(_S175)  * _S177;
    thread Vertex_0 _S179 = _S156;
    float3 _S180 = normal_of_0(&_S179);
    float3 _S181 = float3(_S151) ;
    float3 _S182 = _S178 + _S181 * _S180;
    thread Vertex_0 _S183 = _S157;
    float3 _S184 = normal_of_0(&_S183);
    float3 _S185 = float3(_S152) ;
    float3 _S186 = normalize(_S182 + _S185 * _S184);
    (&point_1)->normal_0 = _S186;
    float3 _S187 = normalize(_S173 - _S186 * float3(dot(_S186, _S173)) );
    (&point_1)->axis_x_0 = _S187;
    (&point_1)->axis_y_0 = cross(_S186, _S187);
    float3 _S188 = normalize(cross(_S162, _S165));
    float3 _S189;
    if((dot(_S188, _S186)) < 0.0f)
    {
        _S189 = - _S188;
    }
    else
    {
        _S189 = _S188;
    }
    (&point_1)->face_normal_0 = _S189;
    (&point_1)->position_0 = _S161 + _S181 * _S162 + _S185 * _S165;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_0 = float2(_S155.u_0, _S155.v_0) + float2(_S151)  * _S168 + float2(_S152)  * _S171;
    bool _S190 = (dot(cross(_S173, _S174), (&point_1)->normal_0)) < 0.0f;
    float _S191 = _S153->uv_width_0;
    if(_S190)
    {
        _S172 = - _S153->uv_height_0;
    }
    else
    {
        _S172 = _S153->uv_height_0;
    }
    float2 _S192 = float2(_S191, _S172);
    (&point_1)->draft_per_uv_0 = _S192;
    float2 _S193 = (&point_1)->uv_0 * _S192;
    if(_S190)
    {
        _S172 = _S153->uv_height_0;
    }
    else
    {
        _S172 = 0.0f;
    }
    (&point_1)->draft_0 = _S193 + float2(0.0f, _S172);
    float2 _S194 = float2(0.0f) ;
    (&point_1)->draft_dx_0 = _S194;
    (&point_1)->draft_dy_0 = _S194;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S195, uint _S196, uint _S197, uint2 _S198, KernelContext_0 thread* kernelContext_28)
{
    Frame_0 device* _S199 = kernelContext_28->frames_0+_S195;
    uint _S200 = 3U * _S197;
    Vertex_0 _S201 = kernelContext_28->vertices_0[kernelContext_28->corners_0[_S200]];
    Vertex_0 _S202 = kernelContext_28->vertices_0[kernelContext_28->corners_0[_S200 + 1U]];
    Vertex_0 _S203 = kernelContext_28->vertices_0[kernelContext_28->corners_0[_S200 + 2U]];
    thread Vertex_0 _S204 = _S202;
    float3 _S205 = position_of_0(&_S204);
    thread Vertex_0 _S206 = _S201;
    float3 _S207 = position_of_0(&_S206);
    float3 _S208 = _S205 - _S207;
    thread Vertex_0 _S209 = _S203;
    float3 _S210 = position_of_0(&_S209);
    float3 _S211 = _S210 - _S207;
    float3 _S212 = cross(_S208, _S211);
    float _S213 = 1.0f / max(square_0(_S212), 1.00000000317107685e-30f);
    float3 _S214 = camera_right_0(_S195, kernelContext_28);
    float _S215 = float(_S199->width_0);
    float3 _S216 = _S214 * float3((2.0f / _S215)) ;
    float3 _S217 = camera_up_0(_S195, kernelContext_28);
    float _S218 = float(_S199->height_0);
    float3 _S219 = _S217 * float3((-2.0f / _S218)) ;
    float _S220 = float(_S198.x) + 0.5f - 0.5f * _S215;
    float _S221 = float(_S198.y) + 0.5f - 0.5f * _S218;
    float3 _S222 = camera_forward_0(_S195, kernelContext_28);
    float3 _S223 = _S222 + float3(_S220)  * _S216 + float3(_S221)  * _S219;
    float _S224 = dot(_S223, _S212);
    float _S225;
    if((abs(_S224)) > 1.00000000317107685e-30f)
    {
        _S225 = _S224;
    }
    else
    {
        _S225 = 1.00000000317107685e-30f;
    }
    float _S226 = 1.0f / _S225;
    float3 _S227 = camera_origin_0(_S195, kernelContext_28);
    float3 _S228 = _S207 - _S227;
    float3 _S229 = float3((dot(_S228, _S212) * _S226)) ;
    float3 _S230 = _S223 * _S229 - _S228;
    float3 _S231 = _S229 * (_S216 - _S223 * float3((dot(_S216, _S212) * _S226)) );
    float3 _S232 = _S229 * (_S219 - _S223 * float3((dot(_S219, _S212) * _S226)) );
    float3 _S233 = float3(_S213) ;
    float3 _S234 = cross(_S211, _S212) * _S233;
    float3 _S235 = cross(_S212, _S208) * _S233;
    float2 _S236 = float2(_S202.u_0 - _S201.u_0, _S202.v_0 - _S201.v_0);
    float2 _S237 = float2(_S203.u_0 - _S201.u_0, _S203.v_0 - _S201.v_0);
    VisiblePoint_0 _S238 = face_point_0(_S196, _S197, dot(_S230, _S234), dot(_S230, _S235), kernelContext_28);
    thread VisiblePoint_0 point_2 = _S238;
    (&point_2)->position_0 = _S207 + _S230;
    (&point_2)->view_0 = - normalize(_S223);
    (&point_2)->draft_dx_0 = (float2(dot(_S231, _S234))  * _S236 + float2(dot(_S231, _S235))  * _S237) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (float2(dot(_S232, _S234))  * _S236 + float2(dot(_S232, _S235))  * _S237) * (&point_2)->draft_per_uv_0;
    return point_2;
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

struct NeumipView_0
{
    array<float, int(7)> latent_0;
    float2 view_2;
    bool back_2;
};

void neumip_view_0(uint _S239, const Footprint_0 thread* _S240, float3 _S241, NeumipView_0 thread* _S242, KernelContext_0 thread* kernelContext_29)
{
    Neumip_0 _S243 = (kernelContext_29->fabrics_0+_S239)->neumip_0;
    bool _S244 = (_S241.z) < 0.0f;
    uint _S245;
    if(_S244)
    {
        _S245 = _S243.back_0;
    }
    else
    {
        _S245 = 0U;
    }
    float3 _S246 = to_face_frame_0(_S241, _S244);
    float2 uv_4 = _S240->centre_0 * float2(_S243.repeats_per_x_0, _S243.repeats_per_y_0);
    float2 uv_5;
    if((_S243.has_offset_0) != 0U)
    {
        float2 _S247 = _S246.xy;
        thread Neumip_0 _S248 = _S243;
        float _S249 = neumip_depth_0(&_S248, uv_4, _S247, _S245, kernelContext_29);
        uv_5 = uv_4 + float2((_S249 / max(_S246.z, 0.60000002384185791f)))  * _S247 * float2(_S243.unit_x_0, _S243.unit_y_0);
    }
    else
    {
        uv_5 = uv_4;
    }
    float _S250 = binary_logarithm_0(max(sqrt(abs(_S240->dx_0.x * _S240->dy_0.y - _S240->dx_0.y * _S240->dy_0.x)) * _S243.texels_per_mm_0, 9.99999971718068537e-10f));
    thread Neumip_0 _S251 = _S243;
    Eight_0 _S252 = neumip_texel_0(&_S251, uv_5, _S250, _S245, kernelContext_29);
    int k_2 = int(0);
    for(;;)
    {
        if(k_2 < int(7))
        {
        }
        else
        {
            break;
        }
        thread Eight_0 _S253 = _S252;
        float _S254 = channel_0(&_S253, k_2);
        _S242->latent_0[k_2] = _S254;
        k_2 = k_2 + int(1);
    }
    _S242->view_2 = _S246.xy;
    _S242->back_2 = _S244;
    return;
}

uint light_sample_count_0(int _S255, KernelContext_0 thread* kernelContext_30)
{
    Frame_0 device* _S256 = kernelContext_30->frames_0+_S255;
    return _S256->lights_0 + _S256->environment_samples_0;
}

float visibility_at_0(int _S257, uint _S258, uint2 _S259, KernelContext_0 thread* kernelContext_31)
{
    Frame_0 device* _S260 = kernelContext_31->frames_0+_S257;
    if((_S260->casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return *(kernelContext_31->visibilities_0+((_S258 * _S260->height_0 + _S259.y) * _S260->width_0 + _S259.x));
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_0;
};

float3 environment_texel_0(int _S261, uint _S262, uint _S263, KernelContext_0 thread* kernelContext_32)
{
    Frame_0 device* _S264 = kernelContext_32->frames_0+_S261;
    uint _S265 = _S264->environment_table_0 + _S264->environment_rows_0 + 1U + _S264->environment_rows_0 * (_S264->environment_columns_0 + 1U) + 3U * (_S262 * _S264->environment_columns_0 + _S263);
    float _S266 = scene_number_0(_S265, kernelContext_32);
    float _S267 = scene_number_0(_S265 + 1U, kernelContext_32);
    float _S268 = scene_number_0(_S265 + 2U, kernelContext_32);
    return float3(_S266, _S267, _S268);
}

float3 sample_environment_0(int _S269, float2 _S270, float3 thread* _S271, KernelContext_0 thread* kernelContext_33)
{
    Frame_0 device* _S272 = kernelContext_33->frames_0+_S269;
    uint _S273 = _S272->environment_table_0;
    uint _S274 = _S272->environment_rows_0;
    Choice_0 _S275 = choose_0(_S272->environment_table_0, _S272->environment_rows_0, _S270.y, kernelContext_33);
    uint _S276 = _S272->environment_columns_0;
    Choice_0 _S277 = choose_0(_S273 + _S274 + 1U + _S275.index_2 * (_S272->environment_columns_0 + 1U), _S272->environment_columns_0, _S270.x, kernelContext_33);
    float3 _S278 = environment_texel_0(_S269, _S275.index_2, _S277.index_2, kernelContext_33);
    *_S271 = _S278 * float3((_S272->environment_total_0 / max(mean_0(_S278), 9.99999968265522539e-21f))) ;
    float _S279 = 3.14159274101257324f / float(_S274);
    float _S280 = mix(sine_cosine_0(float(_S275.index_2) * _S279).y, sine_cosine_0(float(_S275.index_2 + 1U) * _S279).y, _S275.remainder_0);
    float _S281 = sqrt(max(1.0f - _S280 * _S280, 0.0f));
    float2 _S282 = sine_cosine_0((float(_S277.index_2) + _S277.remainder_0) * (6.28318548202514648f / float(_S276)));
    float _S283 = _S281 * _S282.x;
    float _S284 = - _S281 * _S282.y;
    return float3(_S272->environment_cosine_0 * _S283 + _S272->environment_sine_0 * _S284, _S280, _S272->environment_cosine_0 * _S284 - _S272->environment_sine_0 * _S283);
}

LightSample_0 light_sample_0(int _S285, uint _S286, uint2 _S287, float3 _S288, KernelContext_0 thread* kernelContext_34)
{
    Frame_0 device* _S289 = kernelContext_34->frames_0+_S285;
    thread LightSample_0 sample_0;
    (&sample_0)->distance_0 = 1.00000001504746622e+30f;
    uint _S290 = _S289->lights_0;
    if(_S286 >= (_S289->lights_0))
    {
        uint _S291 = _S289->environment_samples_0;
        thread float3 weight_1;
        float3 _S292 = sample_environment_0(_S285, pixel_sequence_0(_S287, _S289->pass_number_0 * _S289->environment_samples_0 + (_S286 - _S290), 3U), &weight_1, kernelContext_34);
        (&sample_0)->towards_0 = _S292;
        (&sample_0)->irradiance_1 = weight_1 / float3(float(_S291)) ;
        return sample_0;
    }
    Light_0 _S293 = kernelContext_34->lights_1[_S286];
    (&sample_0)->irradiance_1 = float3(_S293.red_0, _S293.green_0, _S293.blue_0);
    (&sample_0)->towards_0 = float3(_S293.x_1, _S293.y_1, _S293.z_1);
    if((_S293.is_point_0) != 0U)
    {
        float3 _S294 = (&sample_0)->towards_0 - _S288;
        float _S295 = max(square_0(_S294), 9.999999960041972e-13f);
        (&sample_0)->distance_0 = sqrt(_S295);
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / float3(_S295) ;
        (&sample_0)->towards_0 = normalize(_S294);
    }
    return sample_0;
}

float3 neumip_value_0(uint _S296, NeumipView_0 thread* _S297, float3 _S298, KernelContext_0 thread* kernelContext_35)
{
    Fabric_0 device* _S299 = kernelContext_35->fabrics_0+_S296;
    float3 _S300 = to_face_frame_0(_S298, _S297->back_2);
    if((_S300.z) <= 0.0f)
    {
        return float3(0.0f) ;
    }
    thread array<float, int(11)> inputs_17;
    int k_3 = int(0);
    for(;;)
    {
        if(k_3 < int(7))
        {
        }
        else
        {
            break;
        }
        inputs_17[k_3] = _S297->latent_0[k_3];
        k_3 = k_3 + int(1);
    }
    inputs_17[int(7)] = _S300.x;
    inputs_17[int(8)] = _S300.y;
    inputs_17[int(9)] = _S297->view_2.x;
    inputs_17[int(10)] = _S297->view_2.y;
    thread MLP_0 network_2;
    (&(&network_2)->weights_13)->first_0 = _S299->neumip_0.decoder_0;
    thread MLP_0 _S301 = network_2;
    thread array<float, int(3)> outputs_13;
    MLP_evaluate_0(&_S301, &inputs_17, &outputs_13, kernelContext_35);
    return max(float3(outputs_13[int(0)], outputs_13[int(1)], outputs_13[int(2)]), float3(0.0f) ) * float3(0.31830987334251404f) ;
}

float4 light_of_neumip_0(int _S302, uint _S303, const VisiblePoint_0 thread* _S304, uint2 _S305, KernelContext_0 thread* kernelContext_36)
{
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S304->draft_0;
    (&footprint_0)->dx_0 = _S304->draft_dx_0;
    (&footprint_0)->dy_0 = _S304->draft_dy_0;
    float3 _S306 = to_local_0(_S304, _S304->view_0);
    thread Footprint_0 _S307 = footprint_0;
    thread NeumipView_0 seen_0;
    neumip_view_0(_S303, &_S307, _S306, &seen_0, kernelContext_36);
    float3 _S308 = float3(0.0f) ;
    uint number_1 = 0U;
    float3 radiance_1 = _S308;
    for(;;)
    {
        uint _S309 = light_sample_count_0(_S302, kernelContext_36);
        if(number_1 < _S309)
        {
        }
        else
        {
            break;
        }
        float _S310 = visibility_at_0(_S302, number_1, _S305, kernelContext_36);
        if(_S310 <= 0.0f)
        {
            number_1 = number_1 + 1U;
            continue;
        }
        LightSample_0 _S311 = light_sample_0(_S302, number_1, _S305, _S304->position_0, kernelContext_36);
        float3 _S312 = float3(_S310)  * _S311.irradiance_1;
        float3 _S313 = to_local_0(_S304, _S311.towards_0);
        float3 _S314 = neumip_value_0(_S303, &seen_0, _S313, kernelContext_36);
        radiance_1 = radiance_1 + _S312 * _S314;
        number_1 = number_1 + 1U;
    }
    return float4(radiance_1, 1.0f);
}

[[kernel]] void shade_neumip(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], uint device* words_1 [[buffer(2)]], packed_uint4 device* packed_numbers_1 [[buffer(10)]], float device* visibilities_1 [[buffer(13)]], uint device* scene_words_1 [[buffer(11)]], Light_0 device* lights_2 [[buffer(3)]], packed_float4 device* radiance_2 [[buffer(8)]])
{
    thread KernelContext_0 kernelContext_37;
    (&kernelContext_37)->frames_0 = frames_1;
    (&kernelContext_37)->layers_0 = layers_1;
    (&kernelContext_37)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_37)->fabrics_0 = fabrics_1;
    (&kernelContext_37)->corners_0 = corners_1;
    (&kernelContext_37)->vertices_0 = vertices_1;
    (&kernelContext_37)->words_0 = words_1;
    (&kernelContext_37)->packed_numbers_0 = packed_numbers_1;
    (&kernelContext_37)->visibilities_0 = visibilities_1;
    (&kernelContext_37)->scene_words_0 = scene_words_1;
    (&kernelContext_37)->lights_1 = lights_2;
    (&kernelContext_37)->radiance_0 = radiance_2;
    Frame_0 device* _S315 = frames_1+int(0);
    uint _S316 = id_0.x;
    uint _S317 = _S315->width_0;
    bool _S318;
    if(_S316 >= (_S315->width_0))
    {
        _S318 = true;
    }
    else
    {
        _S318 = (id_0.y) >= (_S315->height_0);
    }
    if(_S318)
    {
        return;
    }
    uint _S319 = id_0.y * _S317 + _S316;
    uint _S320 = ((&kernelContext_37)->layers_0+_S319)->face_0;
    if((((&kernelContext_37)->layers_0+_S319)->face_0) == 0U)
    {
        return;
    }
    uint _S321 = _S320 - 1U;
    uint _S322 = (&kernelContext_37)->face_fabrics_0[_S321];
    uint2 _S323 = id_0.xy;
    VisiblePoint_0 _S324 = visible_point_0(int(0), _S322, _S321, _S323, &kernelContext_37);
    thread VisiblePoint_0 _S325 = _S324;
    float4 _S326 = light_of_neumip_0(int(0), _S322, &_S325, _S323, &kernelContext_37);
    accumulate_0(_S319, _S326, &kernelContext_37);
    return;
}

