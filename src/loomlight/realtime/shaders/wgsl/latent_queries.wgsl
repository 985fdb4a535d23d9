@binding(1) @group(1) var<storage, read> query_count_0 : array<u32>;

struct Query_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) centre_x_0 : f32,
    @align(4) centre_y_0 : f32,
    @align(4) dx_x_0 : f32,
    @align(4) dx_y_0 : f32,
    @align(4) dy_x_0 : f32,
    @align(4) dy_y_0 : f32,
    @align(4) light_x_0 : f32,
    @align(4) light_y_0 : f32,
    @align(4) light_z_0 : f32,
    @align(4) view_x_0 : f32,
    @align(4) view_y_0 : f32,
    @align(4) view_z_0 : f32,
    @align(4) seed_0 : u32,
};

@binding(0) @group(1) var<storage, read> queries_0 : array<Query_std430_0>;

@binding(2) @group(1) var<storage, read_write> answers_0 : array<vec4<f32>>;

struct Lobes_std430_0
{
    @align(4) is_baked_0 : u32,
    @align(4) inverse_base_size_0 : f32,
    @align(4) last_level_0 : f32,
    @align(4) levels_0 : u32,
    @align(4) face_nodes_0 : u32,
    @align(4) packs_0 : u32,
    @align(4) front_warp_packs_0 : u32,
    @align(4) back_warp_packs_0 : u32,
    @align(4) coverage_0 : u32,
    @align(4) coverage_holes_0 : u32,
    @align(4) projected_area_0 : u32,
    @align(4) light_visibility_0 : u32,
    @align(4) irradiance_0 : u32,
    @align(4) moments_0 : u32,
    @align(4) front_hole_weight_0 : f32,
    @align(4) back_hole_weight_0 : f32,
    @align(4) threads_per_mm_0 : f32,
    @align(4) unit_level_0 : f32,
};

struct Neural_std430_0
{
    @align(4) is_encoded_0 : u32,
    @align(4) network_0 : u32,
    @align(4) latents_0 : u32,
    @align(4) texels_0 : u32,
    @align(4) levels_1 : u32,
    @align(4) top_level_0 : u32,
    @align(4) ends_0 : f32,
    @align(4) picks_0 : f32,
    @align(4) ends_per_mm_0 : f32,
    @align(4) picks_per_mm_0 : f32,
    @align(4) pitch_0 : f32,
    @align(4) warp_x_0 : f32,
    @align(4) warp_y_0 : f32,
    @align(4) warp_roughness_0 : f32,
    @align(4) weft_x_0 : f32,
    @align(4) weft_y_0 : f32,
    @align(4) weft_roughness_0 : f32,
    @align(4) warp_lobe_roughness_0 : f32,
    @align(4) weft_lobe_roughness_0 : f32,
    @align(4) bundles_0 : u32,
    @align(4) is_corrected_0 : u32,
    @align(4) correction_0 : u32,
};

struct Neumip_std430_0
{
    @align(4) is_trained_0 : u32,
    @align(4) decoder_0 : u32,
    @align(4) has_offset_0 : u32,
    @align(4) offset_0 : u32,
    @align(4) offset_texels_0 : u32,
    @align(4) features_0 : u32,
    @align(4) texel_elements_0 : u32,
    @align(4) levels_2 : u32,
    @align(4) last_level_1 : f32,
    @align(4) face_texels_0 : u32,
    @align(4) back_0 : u32,
    @align(4) repeats_per_x_0 : f32,
    @align(4) repeats_per_y_0 : f32,
    @align(4) texels_per_mm_0 : f32,
    @align(4) unit_x_0 : f32,
    @align(4) unit_y_0 : f32,
    @align(4) transmits_0 : u32,
    @align(4) transmission_0 : u32,
    @align(4) has_holes_0 : u32,
    @align(4) opacity_0 : u32,
};

struct Latent_std430_0
{
    @align(4) is_trained_1 : u32,
    @align(4) decoder_1 : u32,
    @align(4) hidden_0 : u32,
    @align(4) frames_0 : u32,
    @align(4) sampler_0 : u32,
    @align(4) albedo_0 : u32,
    @align(4) texels_1 : u32,
    @align(4) texel_elements_1 : u32,
    @align(4) levels_3 : u32,
    @align(4) last_level_2 : f32,
    @align(4) face_texels_1 : u32,
    @align(4) back_1 : u32,
    @align(4) repeats_per_x_1 : f32,
    @align(4) repeats_per_y_1 : f32,
    @align(4) texels_per_mm_1 : f32,
    @align(4) width_0 : f32,
    @align(4) height_0 : f32,
    @align(4) is_trilinear_0 : u32,
};

struct Clustered_std430_0
{
    @align(4) is_baked_1 : u32,
    @align(4) clusters_0 : u32,
    @align(4) rank_0 : u32,
    @align(4) channels_0 : u32,
    @align(4) columns_0 : u32,
    @align(4) rows_0 : u32,
    @align(4) texel_width_0 : f32,
    @align(4) texel_height_0 : f32,
    @align(4) samples_0 : u32,
    @align(4) sums_0 : u32,
    @align(4) labels_0 : u32,
    @align(4) coefficients_0 : u32,
    @align(4) basis_0 : u32,
    @align(4) moments_1 : u32,
    @align(4) light_0 : u32,
    @align(4) view_0 : u32,
    @align(4) offset_1 : u32,
    @align(4) trust_0 : u32,
};

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) neural_0 : Neural_std430_0,
    @align(4) neumip_0 : Neumip_std430_0,
    @align(4) run_words_0 : u32,
    @align(4) ends_1 : u32,
    @align(4) max_heights_0 : u32,
    @align(4) max_height_columns_0 : u32,
    @align(4) height_low_0 : f32,
    @align(4) height_high_0 : f32,
    @align(4) lift_0 : f32,
    @align(4) threads_per_x_0 : f32,
    @align(4) threads_per_y_0 : f32,
    @align(4) per_relief_0 : f32,
    @align(4) diffuse_blend_0 : f32,
    @align(4) optical_depth_0 : f32,
    @align(4) sheen_strength_0 : f32,
    @align(4) sheen_roughness_0 : f32,
    @align(4) fibre_noise_0 : f32,
    @align(4) colour_noise_0 : f32,
    @align(4) seed_1 : u32,
    @align(4) layer_bound_0 : f32,
    @align(4) fibre_size_0 : f32,
    @align(4) has_detail_0 : u32,
    @align(4) uv_width_0 : f32,
    @align(4) uv_height_0 : f32,
    @align(4) is_open_0 : u32,
    @align(4) openness_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
    @align(4) has_yarns_0 : u32,
    @align(4) mean_hole_0 : f32,
    @align(4) latent_0 : Latent_std430_0,
    @align(4) clustered_0 : Clustered_std430_0,
};

@binding(0) @group(0) var<storage, read> fabrics_0 : array<Fabric_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(10) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;

struct FloatWeights_0
{
     first_0 : u32,
};

fn whole_parts_0( elements_0 : i32) -> i32
{
    return (elements_0 + i32(3)) / i32(4) * i32(4);
}

struct Eight_0
{
     low_0 : vec4<f32>,
     high_0 : vec4<f32>,
};

fn FloatWeights_eight_0( this_0 : FloatWeights_0,  element_0 : u32) -> Eight_0
{
    var numbers_0 : Eight_0;
    var _S1 : u32 = this_0.first_0 + u32(2) * element_0;
    numbers_0.low_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S1])));
    numbers_0.high_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S1 + u32(1)])));
    return numbers_0;
}

fn tile_product_0( weights_0 : FloatWeights_0,  row_0 : u32,  inputs_0 : ptr<function, array<f32, i32(64)>>) -> vec4<f32>
{
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
    var column_0 : u32 = u32(0);
    for(;;)
    {
        if(column_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var low_1 : vec4<f32>;
        var high_1 : vec4<f32>;
        var _S2 : i32 = i32(u32(8) * column_0);
        low_1[i32(0)] = (*inputs_0)[_S2];
        high_1[i32(0)] = (*inputs_0)[_S2 + i32(4)];
        var _S3 : i32 = _S2 + i32(1);
        low_1[i32(1)] = (*inputs_0)[_S3];
        high_1[i32(1)] = (*inputs_0)[_S3 + i32(4)];
        var _S4 : i32 = _S2 + i32(2);
        low_1[i32(2)] = (*inputs_0)[_S4];
        high_1[i32(2)] = (*inputs_0)[_S4 + i32(4)];
        var _S5 : i32 = _S2 + i32(3);
        low_1[i32(3)] = (*inputs_0)[_S5];
        high_1[i32(3)] = (*inputs_0)[_S5 + i32(4)];
        var _S6 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_1[i32(0)] = sums_1[i32(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        var _S7 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(8) + column_0);
        sums_1[i32(1)] = sums_1[i32(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        var _S8 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(16) + column_0);
        sums_1[i32(2)] = sums_1[i32(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        var _S9 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(24) + column_0);
        sums_1[i32(3)] = sums_1[i32(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + u32(1);
    }
    return sums_1;
}

fn Relu_apply_0( x_0 : f32) -> f32
{
    return max(x_0, 0.0f);
}

fn dense_part_0( weights_1 : FloatWeights_0,  first_1 : u32,  adds_0 : bool,  inputs_1 : ptr<function, array<f32, i32(64)>>,  outputs_0 : ptr<function, array<f32, i32(64)>>)
{
    var _S10 : u32 = first_1 + u32(whole_parts_0(i32(8)));
    var output_0 : i32 = i32(0);
    for(;;)
    {
        var _S11 : bool = output_0 < i32(64);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        var _S12 : u32 = u32(output_0);
        var _S13 : Eight_0 = FloatWeights_eight_0(weights_1, first_1 + _S12 / u32(8));
        var _S14 : vec4<f32> = tile_product_0(weights_1, _S10 + _S12 * u32(8), &((*inputs_1)));
        var _S15 : vec4<f32>;
        if(((output_0 & (i32(4)))) != i32(0))
        {
            _S15 = _S13.high_0;
        }
        else
        {
            _S15 = _S13.low_0;
        }
        var _S16 : vec4<f32> = _S14 + _S15;
        var _S17 : f32;
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
            (*outputs_0)[output_0] = Relu_apply_0(_S16[i32(0)] + _S17);
        }
        var _S18 : i32 = output_0 + i32(1);
        if(_S18 < i32(64))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S18] = Relu_apply_0(_S16[i32(1)] + _S17);
        }
        var _S19 : i32 = output_0 + i32(2);
        if(_S19 < i32(64))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S19] = Relu_apply_0(_S16[i32(2)] + _S17);
        }
        var _S20 : i32 = output_0 + i32(3);
        if(_S20 < i32(64))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S20] = Relu_apply_0(_S16[i32(3)] + _S17);
        }
        output_0 = output_0 + i32(4);
    }
    return;
}

fn Identity_apply_0( x_1 : f32) -> f32
{
    return x_1;
}

fn dense_part_1( weights_2 : FloatWeights_0,  first_2 : u32,  adds_1 : bool,  inputs_2 : ptr<function, array<f32, i32(64)>>,  outputs_1 : ptr<function, array<f32, i32(3)>>)
{
    var _S21 : u32 = first_2 + u32(whole_parts_0(i32(1)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S22 : bool = output_1 < i32(3);
        if(_S22)
        {
        }
        else
        {
            break;
        }
        var _S23 : u32 = u32(output_1);
        var _S24 : Eight_0 = FloatWeights_eight_0(weights_2, first_2 + _S23 / u32(8));
        var _S25 : vec4<f32> = tile_product_0(weights_2, _S21 + _S23 * u32(8), &((*inputs_2)));
        var _S26 : vec4<f32>;
        if(((output_1 & (i32(4)))) != i32(0))
        {
            _S26 = _S24.high_0;
        }
        else
        {
            _S26 = _S24.low_0;
        }
        var _S27 : vec4<f32> = _S25 + _S26;
        var _S28 : f32;
        if(_S22)
        {
            if(adds_1)
            {
                _S28 = (*outputs_1)[output_1];
            }
            else
            {
                _S28 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S27[i32(0)] + _S28);
        }
        var _S29 : i32 = output_1 + i32(1);
        if(_S29 < i32(3))
        {
            if(adds_1)
            {
                _S28 = (*outputs_1)[_S29];
            }
            else
            {
                _S28 = 0.0f;
            }
            (*outputs_1)[_S29] = Identity_apply_0(_S27[i32(1)] + _S28);
        }
        var _S30 : i32 = output_1 + i32(2);
        if(_S30 < i32(3))
        {
            if(adds_1)
            {
                _S28 = (*outputs_1)[_S30];
            }
            else
            {
                _S28 = 0.0f;
            }
            (*outputs_1)[_S30] = Identity_apply_0(_S27[i32(2)] + _S28);
        }
        var _S31 : i32 = output_1 + i32(3);
        if(_S31 < i32(3))
        {
            if(adds_1)
            {
                _S28 = (*outputs_1)[_S31];
            }
            else
            {
                _S28 = 0.0f;
            }
            (*outputs_1)[_S31] = Identity_apply_0(_S27[i32(3)] + _S28);
        }
        output_1 = output_1 + i32(4);
    }
    return;
}

fn tile_product_1( weights_3 : FloatWeights_0,  row_1 : u32,  inputs_3 : ptr<function, array<f32, i32(20)>>) -> vec4<f32>
{
    var sums_2 : vec4<f32> = vec4<f32>(0.0f);
    var column_1 : u32 = u32(0);
    for(;;)
    {
        if(column_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        var low_2 : vec4<f32>;
        var high_2 : vec4<f32>;
        var _S32 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_3)[min(_S32, i32(19))];
        high_2[i32(0)] = (*inputs_3)[min(_S32 + i32(4), i32(19))];
        var _S33 : i32 = _S32 + i32(1);
        low_2[i32(1)] = (*inputs_3)[min(_S33, i32(19))];
        high_2[i32(1)] = (*inputs_3)[min(_S33 + i32(4), i32(19))];
        var _S34 : i32 = _S32 + i32(2);
        low_2[i32(2)] = (*inputs_3)[min(_S34, i32(19))];
        high_2[i32(2)] = (*inputs_3)[min(_S34 + i32(4), i32(19))];
        var _S35 : i32 = _S32 + i32(3);
        low_2[i32(3)] = (*inputs_3)[min(_S35, i32(19))];
        high_2[i32(3)] = (*inputs_3)[min(_S35 + i32(4), i32(19))];
        var _S36 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + column_1);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S36.low_0, low_2) + dot(_S36.high_0, high_2));
        var _S37 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + u32(3) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S37.low_0, low_2) + dot(_S37.high_0, high_2));
        var _S38 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + u32(6) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S38.low_0, low_2) + dot(_S38.high_0, high_2));
        var _S39 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + u32(9) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S39.low_0, low_2) + dot(_S39.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn dense_part_2( weights_4 : FloatWeights_0,  first_3 : u32,  adds_2 : bool,  inputs_4 : ptr<function, array<f32, i32(20)>>,  outputs_2 : ptr<function, array<f32, i32(64)>>)
{
    var _S40 : u32 = first_3 + u32(whole_parts_0(i32(8)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S41 : bool = output_2 < i32(64);
        if(_S41)
        {
        }
        else
        {
            break;
        }
        var _S42 : u32 = u32(output_2);
        var _S43 : Eight_0 = FloatWeights_eight_0(weights_4, first_3 + _S42 / u32(8));
        var _S44 : vec4<f32> = tile_product_1(weights_4, _S40 + _S42 * u32(3), &((*inputs_4)));
        var _S45 : vec4<f32>;
        if(((output_2 & (i32(4)))) != i32(0))
        {
            _S45 = _S43.high_0;
        }
        else
        {
            _S45 = _S43.low_0;
        }
        var _S46 : vec4<f32> = _S44 + _S45;
        var _S47 : f32;
        if(_S41)
        {
            if(adds_2)
            {
                _S47 = (*outputs_2)[output_2];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_2)[output_2] = Relu_apply_0(_S46[i32(0)] + _S47);
        }
        var _S48 : i32 = output_2 + i32(1);
        if(_S48 < i32(64))
        {
            if(adds_2)
            {
                _S47 = (*outputs_2)[_S48];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_2)[_S48] = Relu_apply_0(_S46[i32(1)] + _S47);
        }
        var _S49 : i32 = output_2 + i32(2);
        if(_S49 < i32(64))
        {
            if(adds_2)
            {
                _S47 = (*outputs_2)[_S49];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_2)[_S49] = Relu_apply_0(_S46[i32(2)] + _S47);
        }
        var _S50 : i32 = output_2 + i32(3);
        if(_S50 < i32(64))
        {
            if(adds_2)
            {
                _S47 = (*outputs_2)[_S50];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_2)[_S50] = Relu_apply_0(_S46[i32(3)] + _S47);
        }
        output_2 = output_2 + i32(4);
    }
    return;
}

fn dense_0( weights_5 : FloatWeights_0,  first_4 : u32,  adds_3 : bool,  inputs_5 : ptr<function, array<f32, i32(64)>>,  outputs_3 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_0(weights_5, first_4, adds_3, &((*inputs_5)), &((*outputs_3)));
    return;
}

fn dense_1( weights_6 : FloatWeights_0,  first_5 : u32,  adds_4 : bool,  inputs_6 : ptr<function, array<f32, i32(64)>>,  outputs_4 : ptr<function, array<f32, i32(3)>>)
{
    dense_part_1(weights_6, first_5, adds_4, &((*inputs_6)), &((*outputs_4)));
    return;
}

fn dense_2( weights_7 : FloatWeights_0,  first_6 : u32,  adds_5 : bool,  inputs_7 : ptr<function, array<f32, i32(20)>>,  outputs_5 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_2(weights_7, first_6, adds_5, &((*inputs_7)), &((*outputs_5)));
    return;
}

struct MLP_0
{
     weights_8 : FloatWeights_0,
};

fn layer_size_0( inputs_8 : i32,  outputs_6 : i32) -> i32
{
    return whole_parts_0((outputs_6 + i32(7)) / i32(8)) + whole_parts_0((inputs_8 + i32(7)) / i32(8) * ((outputs_6 + i32(4) - i32(1)) / i32(4) * i32(4)));
}

fn MLP_evaluate_0( this_1 : MLP_0,  inputs_9 : ptr<function, array<f32, i32(20)>>,  outputs_7 : ptr<function, array<f32, i32(3)>>)
{
    var odd_0 : array<f32, i32(64)>;
    var even_0 : array<f32, i32(64)>;
    dense_2(this_1.weights_8, u32(0), false, &((*inputs_9)), &(even_0));
    var layer_0 : i32 = i32(1);
    for(;;)
    {
        if(layer_0 < i32(3))
        {
        }
        else
        {
            break;
        }
        var _S51 : i32 = layer_size_0(i32(64), i32(64));
        var _S52 : u32 = u32(layer_size_0(i32(20), i32(64)) + (layer_0 - i32(1)) * _S51);
        dense_0(this_1.weights_8, _S52, false, &(even_0), &(odd_0));
        if((layer_0 + i32(1)) < i32(3))
        {
            dense_0(this_1.weights_8, _S52 + u32(_S51), false, &(odd_0), &(even_0));
        }
        layer_0 = layer_0 + i32(2);
    }
    var _S53 : u32 = u32(layer_size_0(i32(20), i32(64)) + i32(2) * layer_size_0(i32(64), i32(64)));
    dense_1(this_1.weights_8, _S53, false, &(even_0), &((*outputs_7)));
    return;
}

fn tile_product_2( weights_9 : FloatWeights_0,  row_2 : u32,  inputs_10 : ptr<function, array<f32, i32(32)>>) -> vec4<f32>
{
    var sums_3 : vec4<f32> = vec4<f32>(0.0f);
    var column_2 : u32 = u32(0);
    for(;;)
    {
        if(column_2 < u32(4))
        {
        }
        else
        {
            break;
        }
        var low_3 : vec4<f32>;
        var high_3 : vec4<f32>;
        var _S54 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_10)[_S54];
        high_3[i32(0)] = (*inputs_10)[_S54 + i32(4)];
        var _S55 : i32 = _S54 + i32(1);
        low_3[i32(1)] = (*inputs_10)[_S55];
        high_3[i32(1)] = (*inputs_10)[_S55 + i32(4)];
        var _S56 : i32 = _S54 + i32(2);
        low_3[i32(2)] = (*inputs_10)[_S56];
        high_3[i32(2)] = (*inputs_10)[_S56 + i32(4)];
        var _S57 : i32 = _S54 + i32(3);
        low_3[i32(3)] = (*inputs_10)[_S57];
        high_3[i32(3)] = (*inputs_10)[_S57 + i32(4)];
        var _S58 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + column_2);
        sums_3[i32(0)] = sums_3[i32(0)] + (dot(_S58.low_0, low_3) + dot(_S58.high_0, high_3));
        var _S59 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + u32(4) + column_2);
        sums_3[i32(1)] = sums_3[i32(1)] + (dot(_S59.low_0, low_3) + dot(_S59.high_0, high_3));
        var _S60 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + u32(8) + column_2);
        sums_3[i32(2)] = sums_3[i32(2)] + (dot(_S60.low_0, low_3) + dot(_S60.high_0, high_3));
        var _S61 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + u32(12) + column_2);
        sums_3[i32(3)] = sums_3[i32(3)] + (dot(_S61.low_0, low_3) + dot(_S61.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_3;
}

fn dense_part_3( weights_10 : FloatWeights_0,  first_7 : u32,  adds_6 : bool,  inputs_11 : ptr<function, array<f32, i32(32)>>,  outputs_8 : ptr<function, array<f32, i32(32)>>)
{
    var _S62 : u32 = first_7 + u32(whole_parts_0(i32(4)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S63 : bool = output_3 < i32(32);
        if(_S63)
        {
        }
        else
        {
            break;
        }
        var _S64 : u32 = u32(output_3);
        var _S65 : Eight_0 = FloatWeights_eight_0(weights_10, first_7 + _S64 / u32(8));
        var _S66 : vec4<f32> = tile_product_2(weights_10, _S62 + _S64 * u32(4), &((*inputs_11)));
        var _S67 : vec4<f32>;
        if(((output_3 & (i32(4)))) != i32(0))
        {
            _S67 = _S65.high_0;
        }
        else
        {
            _S67 = _S65.low_0;
        }
        var _S68 : vec4<f32> = _S66 + _S67;
        var _S69 : f32;
        if(_S63)
        {
            if(adds_6)
            {
                _S69 = (*outputs_8)[output_3];
            }
            else
            {
                _S69 = 0.0f;
            }
            (*outputs_8)[output_3] = Relu_apply_0(_S68[i32(0)] + _S69);
        }
        var _S70 : i32 = output_3 + i32(1);
        if(_S70 < i32(32))
        {
            if(adds_6)
            {
                _S69 = (*outputs_8)[_S70];
            }
            else
            {
                _S69 = 0.0f;
            }
            (*outputs_8)[_S70] = Relu_apply_0(_S68[i32(1)] + _S69);
        }
        var _S71 : i32 = output_3 + i32(2);
        if(_S71 < i32(32))
        {
            if(adds_6)
            {
                _S69 = (*outputs_8)[_S71];
            }
            else
            {
                _S69 = 0.0f;
            }
            (*outputs_8)[_S71] = Relu_apply_0(_S68[i32(2)] + _S69);
        }
        var _S72 : i32 = output_3 + i32(3);
        if(_S72 < i32(32))
        {
            if(adds_6)
            {
                _S69 = (*outputs_8)[_S72];
            }
            else
            {
                _S69 = 0.0f;
            }
            (*outputs_8)[_S72] = Relu_apply_0(_S68[i32(3)] + _S69);
        }
        output_3 = output_3 + i32(4);
    }
    return;
}

fn dense_part_4( weights_11 : FloatWeights_0,  first_8 : u32,  adds_7 : bool,  inputs_12 : ptr<function, array<f32, i32(32)>>,  outputs_9 : ptr<function, array<f32, i32(3)>>)
{
    var _S73 : u32 = first_8 + u32(whole_parts_0(i32(1)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S74 : bool = output_4 < i32(3);
        if(_S74)
        {
        }
        else
        {
            break;
        }
        var _S75 : u32 = u32(output_4);
        var _S76 : Eight_0 = FloatWeights_eight_0(weights_11, first_8 + _S75 / u32(8));
        var _S77 : vec4<f32> = tile_product_2(weights_11, _S73 + _S75 * u32(4), &((*inputs_12)));
        var _S78 : vec4<f32>;
        if(((output_4 & (i32(4)))) != i32(0))
        {
            _S78 = _S76.high_0;
        }
        else
        {
            _S78 = _S76.low_0;
        }
        var _S79 : vec4<f32> = _S77 + _S78;
        var _S80 : f32;
        if(_S74)
        {
            if(adds_7)
            {
                _S80 = (*outputs_9)[output_4];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_9)[output_4] = Identity_apply_0(_S79[i32(0)] + _S80);
        }
        var _S81 : i32 = output_4 + i32(1);
        if(_S81 < i32(3))
        {
            if(adds_7)
            {
                _S80 = (*outputs_9)[_S81];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_9)[_S81] = Identity_apply_0(_S79[i32(1)] + _S80);
        }
        var _S82 : i32 = output_4 + i32(2);
        if(_S82 < i32(3))
        {
            if(adds_7)
            {
                _S80 = (*outputs_9)[_S82];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_9)[_S82] = Identity_apply_0(_S79[i32(2)] + _S80);
        }
        var _S83 : i32 = output_4 + i32(3);
        if(_S83 < i32(3))
        {
            if(adds_7)
            {
                _S80 = (*outputs_9)[_S83];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_9)[_S83] = Identity_apply_0(_S79[i32(3)] + _S80);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn dense_part_5( weights_12 : FloatWeights_0,  first_9 : u32,  adds_8 : bool,  inputs_13 : ptr<function, array<f32, i32(20)>>,  outputs_10 : ptr<function, array<f32, i32(32)>>)
{
    var _S84 : u32 = first_9 + u32(whole_parts_0(i32(4)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S85 : bool = output_5 < i32(32);
        if(_S85)
        {
        }
        else
        {
            break;
        }
        var _S86 : u32 = u32(output_5);
        var _S87 : Eight_0 = FloatWeights_eight_0(weights_12, first_9 + _S86 / u32(8));
        var _S88 : vec4<f32> = tile_product_1(weights_12, _S84 + _S86 * u32(3), &((*inputs_13)));
        var _S89 : vec4<f32>;
        if(((output_5 & (i32(4)))) != i32(0))
        {
            _S89 = _S87.high_0;
        }
        else
        {
            _S89 = _S87.low_0;
        }
        var _S90 : vec4<f32> = _S88 + _S89;
        var _S91 : f32;
        if(_S85)
        {
            if(adds_8)
            {
                _S91 = (*outputs_10)[output_5];
            }
            else
            {
                _S91 = 0.0f;
            }
            (*outputs_10)[output_5] = Relu_apply_0(_S90[i32(0)] + _S91);
        }
        var _S92 : i32 = output_5 + i32(1);
        if(_S92 < i32(32))
        {
            if(adds_8)
            {
                _S91 = (*outputs_10)[_S92];
            }
            else
            {
                _S91 = 0.0f;
            }
            (*outputs_10)[_S92] = Relu_apply_0(_S90[i32(1)] + _S91);
        }
        var _S93 : i32 = output_5 + i32(2);
        if(_S93 < i32(32))
        {
            if(adds_8)
            {
                _S91 = (*outputs_10)[_S93];
            }
            else
            {
                _S91 = 0.0f;
            }
            (*outputs_10)[_S93] = Relu_apply_0(_S90[i32(2)] + _S91);
        }
        var _S94 : i32 = output_5 + i32(3);
        if(_S94 < i32(32))
        {
            if(adds_8)
            {
                _S91 = (*outputs_10)[_S94];
            }
            else
            {
                _S91 = 0.0f;
            }
            (*outputs_10)[_S94] = Relu_apply_0(_S90[i32(3)] + _S91);
        }
        output_5 = output_5 + i32(4);
    }
    return;
}

fn dense_3( weights_13 : FloatWeights_0,  first_10 : u32,  adds_9 : bool,  inputs_14 : ptr<function, array<f32, i32(32)>>,  outputs_11 : ptr<function, array<f32, i32(32)>>)
{
    dense_part_3(weights_13, first_10, adds_9, &((*inputs_14)), &((*outputs_11)));
    return;
}

fn dense_4( weights_14 : FloatWeights_0,  first_11 : u32,  adds_10 : bool,  inputs_15 : ptr<function, array<f32, i32(32)>>,  outputs_12 : ptr<function, array<f32, i32(3)>>)
{
    dense_part_4(weights_14, first_11, adds_10, &((*inputs_15)), &((*outputs_12)));
    return;
}

fn dense_5( weights_15 : FloatWeights_0,  first_12 : u32,  adds_11 : bool,  inputs_16 : ptr<function, array<f32, i32(20)>>,  outputs_13 : ptr<function, array<f32, i32(32)>>)
{
    dense_part_5(weights_15, first_12, adds_11, &((*inputs_16)), &((*outputs_13)));
    return;
}

fn MLP_evaluate_1( this_2 : MLP_0,  inputs_17 : ptr<function, array<f32, i32(20)>>,  outputs_14 : ptr<function, array<f32, i32(3)>>)
{
    var odd_1 : array<f32, i32(32)>;
    var even_1 : array<f32, i32(32)>;
    dense_5(this_2.weights_8, u32(0), false, &((*inputs_17)), &(even_1));
    var layer_1 : i32 = i32(1);
    for(;;)
    {
        if(layer_1 < i32(2))
        {
        }
        else
        {
            break;
        }
        var _S95 : i32 = layer_size_0(i32(32), i32(32));
        var _S96 : u32 = u32(layer_size_0(i32(20), i32(32)) + (layer_1 - i32(1)) * _S95);
        dense_3(this_2.weights_8, _S96, false, &(even_1), &(odd_1));
        if((layer_1 + i32(1)) < i32(2))
        {
            dense_3(this_2.weights_8, _S96 + u32(_S95), false, &(odd_1), &(even_1));
        }
        layer_1 = layer_1 + i32(2);
    }
    var _S97 : u32 = u32(layer_size_0(i32(20), i32(32)) + layer_size_0(i32(32), i32(32)));
    dense_4(this_2.weights_8, _S97, false, &(odd_1), &((*outputs_14)));
    return;
}

fn tile_product_3( weights_16 : FloatWeights_0,  row_3 : u32,  inputs_18 : ptr<function, array<f32, i32(16)>>) -> vec4<f32>
{
    var sums_4 : vec4<f32> = vec4<f32>(0.0f);
    var column_3 : u32 = u32(0);
    for(;;)
    {
        if(column_3 < u32(2))
        {
        }
        else
        {
            break;
        }
        var low_4 : vec4<f32>;
        var high_4 : vec4<f32>;
        var _S98 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_18)[_S98];
        high_4[i32(0)] = (*inputs_18)[_S98 + i32(4)];
        var _S99 : i32 = _S98 + i32(1);
        low_4[i32(1)] = (*inputs_18)[_S99];
        high_4[i32(1)] = (*inputs_18)[_S99 + i32(4)];
        var _S100 : i32 = _S98 + i32(2);
        low_4[i32(2)] = (*inputs_18)[_S100];
        high_4[i32(2)] = (*inputs_18)[_S100 + i32(4)];
        var _S101 : i32 = _S98 + i32(3);
        low_4[i32(3)] = (*inputs_18)[_S101];
        high_4[i32(3)] = (*inputs_18)[_S101 + i32(4)];
        var _S102 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S102.low_0, low_4) + dot(_S102.high_0, high_4));
        var _S103 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + u32(2) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S103.low_0, low_4) + dot(_S103.high_0, high_4));
        var _S104 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + u32(4) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S104.low_0, low_4) + dot(_S104.high_0, high_4));
        var _S105 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + u32(6) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S105.low_0, low_4) + dot(_S105.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_6( weights_17 : FloatWeights_0,  first_13 : u32,  adds_12 : bool,  inputs_19 : ptr<function, array<f32, i32(16)>>,  outputs_15 : ptr<function, array<f32, i32(16)>>)
{
    var _S106 : u32 = first_13 + u32(whole_parts_0(i32(2)));
    var output_6 : i32 = i32(0);
    for(;;)
    {
        var _S107 : bool = output_6 < i32(16);
        if(_S107)
        {
        }
        else
        {
            break;
        }
        var _S108 : u32 = u32(output_6);
        var _S109 : Eight_0 = FloatWeights_eight_0(weights_17, first_13 + _S108 / u32(8));
        var _S110 : vec4<f32> = tile_product_3(weights_17, _S106 + _S108 * u32(2), &((*inputs_19)));
        var _S111 : vec4<f32>;
        if(((output_6 & (i32(4)))) != i32(0))
        {
            _S111 = _S109.high_0;
        }
        else
        {
            _S111 = _S109.low_0;
        }
        var _S112 : vec4<f32> = _S110 + _S111;
        var _S113 : f32;
        if(_S107)
        {
            if(adds_12)
            {
                _S113 = (*outputs_15)[output_6];
            }
            else
            {
                _S113 = 0.0f;
            }
            (*outputs_15)[output_6] = Relu_apply_0(_S112[i32(0)] + _S113);
        }
        var _S114 : i32 = output_6 + i32(1);
        if(_S114 < i32(16))
        {
            if(adds_12)
            {
                _S113 = (*outputs_15)[_S114];
            }
            else
            {
                _S113 = 0.0f;
            }
            (*outputs_15)[_S114] = Relu_apply_0(_S112[i32(1)] + _S113);
        }
        var _S115 : i32 = output_6 + i32(2);
        if(_S115 < i32(16))
        {
            if(adds_12)
            {
                _S113 = (*outputs_15)[_S115];
            }
            else
            {
                _S113 = 0.0f;
            }
            (*outputs_15)[_S115] = Relu_apply_0(_S112[i32(2)] + _S113);
        }
        var _S116 : i32 = output_6 + i32(3);
        if(_S116 < i32(16))
        {
            if(adds_12)
            {
                _S113 = (*outputs_15)[_S116];
            }
            else
            {
                _S113 = 0.0f;
            }
            (*outputs_15)[_S116] = Relu_apply_0(_S112[i32(3)] + _S113);
        }
        output_6 = output_6 + i32(4);
    }
    return;
}

fn dense_part_7( weights_18 : FloatWeights_0,  first_14 : u32,  adds_13 : bool,  inputs_20 : ptr<function, array<f32, i32(16)>>,  outputs_16 : ptr<function, array<f32, i32(3)>>)
{
    var _S117 : u32 = first_14 + u32(whole_parts_0(i32(1)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S118 : bool = output_7 < i32(3);
        if(_S118)
        {
        }
        else
        {
            break;
        }
        var _S119 : u32 = u32(output_7);
        var _S120 : Eight_0 = FloatWeights_eight_0(weights_18, first_14 + _S119 / u32(8));
        var _S121 : vec4<f32> = tile_product_3(weights_18, _S117 + _S119 * u32(2), &((*inputs_20)));
        var _S122 : vec4<f32>;
        if(((output_7 & (i32(4)))) != i32(0))
        {
            _S122 = _S120.high_0;
        }
        else
        {
            _S122 = _S120.low_0;
        }
        var _S123 : vec4<f32> = _S121 + _S122;
        var _S124 : f32;
        if(_S118)
        {
            if(adds_13)
            {
                _S124 = (*outputs_16)[output_7];
            }
            else
            {
                _S124 = 0.0f;
            }
            (*outputs_16)[output_7] = Identity_apply_0(_S123[i32(0)] + _S124);
        }
        var _S125 : i32 = output_7 + i32(1);
        if(_S125 < i32(3))
        {
            if(adds_13)
            {
                _S124 = (*outputs_16)[_S125];
            }
            else
            {
                _S124 = 0.0f;
            }
            (*outputs_16)[_S125] = Identity_apply_0(_S123[i32(1)] + _S124);
        }
        var _S126 : i32 = output_7 + i32(2);
        if(_S126 < i32(3))
        {
            if(adds_13)
            {
                _S124 = (*outputs_16)[_S126];
            }
            else
            {
                _S124 = 0.0f;
            }
            (*outputs_16)[_S126] = Identity_apply_0(_S123[i32(2)] + _S124);
        }
        var _S127 : i32 = output_7 + i32(3);
        if(_S127 < i32(3))
        {
            if(adds_13)
            {
                _S124 = (*outputs_16)[_S127];
            }
            else
            {
                _S124 = 0.0f;
            }
            (*outputs_16)[_S127] = Identity_apply_0(_S123[i32(3)] + _S124);
        }
        output_7 = output_7 + i32(4);
    }
    return;
}

fn dense_part_8( weights_19 : FloatWeights_0,  first_15 : u32,  adds_14 : bool,  inputs_21 : ptr<function, array<f32, i32(20)>>,  outputs_17 : ptr<function, array<f32, i32(16)>>)
{
    var _S128 : u32 = first_15 + u32(whole_parts_0(i32(2)));
    var output_8 : i32 = i32(0);
    for(;;)
    {
        var _S129 : bool = output_8 < i32(16);
        if(_S129)
        {
        }
        else
        {
            break;
        }
        var _S130 : u32 = u32(output_8);
        var _S131 : Eight_0 = FloatWeights_eight_0(weights_19, first_15 + _S130 / u32(8));
        var _S132 : vec4<f32> = tile_product_1(weights_19, _S128 + _S130 * u32(3), &((*inputs_21)));
        var _S133 : vec4<f32>;
        if(((output_8 & (i32(4)))) != i32(0))
        {
            _S133 = _S131.high_0;
        }
        else
        {
            _S133 = _S131.low_0;
        }
        var _S134 : vec4<f32> = _S132 + _S133;
        var _S135 : f32;
        if(_S129)
        {
            if(adds_14)
            {
                _S135 = (*outputs_17)[output_8];
            }
            else
            {
                _S135 = 0.0f;
            }
            (*outputs_17)[output_8] = Relu_apply_0(_S134[i32(0)] + _S135);
        }
        var _S136 : i32 = output_8 + i32(1);
        if(_S136 < i32(16))
        {
            if(adds_14)
            {
                _S135 = (*outputs_17)[_S136];
            }
            else
            {
                _S135 = 0.0f;
            }
            (*outputs_17)[_S136] = Relu_apply_0(_S134[i32(1)] + _S135);
        }
        var _S137 : i32 = output_8 + i32(2);
        if(_S137 < i32(16))
        {
            if(adds_14)
            {
                _S135 = (*outputs_17)[_S137];
            }
            else
            {
                _S135 = 0.0f;
            }
            (*outputs_17)[_S137] = Relu_apply_0(_S134[i32(2)] + _S135);
        }
        var _S138 : i32 = output_8 + i32(3);
        if(_S138 < i32(16))
        {
            if(adds_14)
            {
                _S135 = (*outputs_17)[_S138];
            }
            else
            {
                _S135 = 0.0f;
            }
            (*outputs_17)[_S138] = Relu_apply_0(_S134[i32(3)] + _S135);
        }
        output_8 = output_8 + i32(4);
    }
    return;
}

fn dense_6( weights_20 : FloatWeights_0,  first_16 : u32,  adds_15 : bool,  inputs_22 : ptr<function, array<f32, i32(16)>>,  outputs_18 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_6(weights_20, first_16, adds_15, &((*inputs_22)), &((*outputs_18)));
    return;
}

fn dense_7( weights_21 : FloatWeights_0,  first_17 : u32,  adds_16 : bool,  inputs_23 : ptr<function, array<f32, i32(16)>>,  outputs_19 : ptr<function, array<f32, i32(3)>>)
{
    dense_part_7(weights_21, first_17, adds_16, &((*inputs_23)), &((*outputs_19)));
    return;
}

fn dense_8( weights_22 : FloatWeights_0,  first_18 : u32,  adds_17 : bool,  inputs_24 : ptr<function, array<f32, i32(20)>>,  outputs_20 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_8(weights_22, first_18, adds_17, &((*inputs_24)), &((*outputs_20)));
    return;
}

fn MLP_evaluate_2( this_3 : MLP_0,  inputs_25 : ptr<function, array<f32, i32(20)>>,  outputs_21 : ptr<function, array<f32, i32(3)>>)
{
    var odd_2 : array<f32, i32(16)>;
    var even_2 : array<f32, i32(16)>;
    dense_8(this_3.weights_8, u32(0), false, &((*inputs_25)), &(even_2));
    var layer_2 : i32 = i32(1);
    for(;;)
    {
        if(layer_2 < i32(2))
        {
        }
        else
        {
            break;
        }
        var _S139 : i32 = layer_size_0(i32(16), i32(16));
        var _S140 : u32 = u32(layer_size_0(i32(20), i32(16)) + (layer_2 - i32(1)) * _S139);
        dense_6(this_3.weights_8, _S140, false, &(even_2), &(odd_2));
        if((layer_2 + i32(1)) < i32(2))
        {
            dense_6(this_3.weights_8, _S140 + u32(_S139), false, &(odd_2), &(even_2));
        }
        layer_2 = layer_2 + i32(2);
    }
    var _S141 : u32 = u32(layer_size_0(i32(20), i32(16)) + layer_size_0(i32(16), i32(16)));
    dense_7(this_3.weights_8, _S141, false, &(odd_2), &((*outputs_21)));
    return;
}

fn tile_product_4( weights_23 : FloatWeights_0,  row_4 : u32,  inputs_26 : ptr<function, array<f32, i32(8)>>) -> vec4<f32>
{
    var sums_5 : vec4<f32> = vec4<f32>(0.0f);
    var column_4 : u32 = u32(0);
    for(;;)
    {
        if(column_4 < u32(1))
        {
        }
        else
        {
            break;
        }
        var low_5 : vec4<f32>;
        var high_5 : vec4<f32>;
        var _S142 : i32 = i32(u32(8) * column_4);
        low_5[i32(0)] = (*inputs_26)[_S142];
        high_5[i32(0)] = (*inputs_26)[_S142 + i32(4)];
        var _S143 : i32 = _S142 + i32(1);
        low_5[i32(1)] = (*inputs_26)[_S143];
        high_5[i32(1)] = (*inputs_26)[_S143 + i32(4)];
        var _S144 : i32 = _S142 + i32(2);
        low_5[i32(2)] = (*inputs_26)[_S144];
        high_5[i32(2)] = (*inputs_26)[_S144 + i32(4)];
        var _S145 : i32 = _S142 + i32(3);
        low_5[i32(3)] = (*inputs_26)[_S145];
        high_5[i32(3)] = (*inputs_26)[_S145 + i32(4)];
        var _S146 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + column_4);
        sums_5[i32(0)] = sums_5[i32(0)] + (dot(_S146.low_0, low_5) + dot(_S146.high_0, high_5));
        var _S147 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + u32(1) + column_4);
        sums_5[i32(1)] = sums_5[i32(1)] + (dot(_S147.low_0, low_5) + dot(_S147.high_0, high_5));
        var _S148 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + u32(2) + column_4);
        sums_5[i32(2)] = sums_5[i32(2)] + (dot(_S148.low_0, low_5) + dot(_S148.high_0, high_5));
        var _S149 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + u32(3) + column_4);
        sums_5[i32(3)] = sums_5[i32(3)] + (dot(_S149.low_0, low_5) + dot(_S149.high_0, high_5));
        column_4 = column_4 + u32(1);
    }
    return sums_5;
}

fn dense_part_9( weights_24 : FloatWeights_0,  first_19 : u32,  adds_18 : bool,  inputs_27 : ptr<function, array<f32, i32(8)>>,  outputs_22 : ptr<function, array<f32, i32(12)>>)
{
    var _S150 : u32 = first_19 + u32(whole_parts_0(i32(2)));
    var output_9 : i32 = i32(0);
    for(;;)
    {
        var _S151 : bool = output_9 < i32(12);
        if(_S151)
        {
        }
        else
        {
            break;
        }
        var _S152 : u32 = u32(output_9);
        var _S153 : Eight_0 = FloatWeights_eight_0(weights_24, first_19 + _S152 / u32(8));
        var _S154 : vec4<f32> = tile_product_4(weights_24, _S150 + _S152, &((*inputs_27)));
        var _S155 : vec4<f32>;
        if(((output_9 & (i32(4)))) != i32(0))
        {
            _S155 = _S153.high_0;
        }
        else
        {
            _S155 = _S153.low_0;
        }
        var _S156 : vec4<f32> = _S154 + _S155;
        var _S157 : f32;
        if(_S151)
        {
            if(adds_18)
            {
                _S157 = (*outputs_22)[output_9];
            }
            else
            {
                _S157 = 0.0f;
            }
            (*outputs_22)[output_9] = Identity_apply_0(_S156[i32(0)] + _S157);
        }
        var _S158 : i32 = output_9 + i32(1);
        if(_S158 < i32(12))
        {
            if(adds_18)
            {
                _S157 = (*outputs_22)[_S158];
            }
            else
            {
                _S157 = 0.0f;
            }
            (*outputs_22)[_S158] = Identity_apply_0(_S156[i32(1)] + _S157);
        }
        var _S159 : i32 = output_9 + i32(2);
        if(_S159 < i32(12))
        {
            if(adds_18)
            {
                _S157 = (*outputs_22)[_S159];
            }
            else
            {
                _S157 = 0.0f;
            }
            (*outputs_22)[_S159] = Identity_apply_0(_S156[i32(2)] + _S157);
        }
        var _S160 : i32 = output_9 + i32(3);
        if(_S160 < i32(12))
        {
            if(adds_18)
            {
                _S157 = (*outputs_22)[_S160];
            }
            else
            {
                _S157 = 0.0f;
            }
            (*outputs_22)[_S160] = Identity_apply_0(_S156[i32(3)] + _S157);
        }
        output_9 = output_9 + i32(4);
    }
    return;
}

fn decode_0( first_20 : u32,  inputs_28 : ptr<function, array<f32, i32(20)>>,  outputs_23 : ptr<function, array<f32, i32(3)>>)
{
    var network_1 : MLP_0;
    network_1.weights_8.first_0 = first_20;
    MLP_evaluate_0(network_1, &((*inputs_28)), &((*outputs_23)));
    return;
}

fn decode_1( first_21 : u32,  inputs_29 : ptr<function, array<f32, i32(20)>>,  outputs_24 : ptr<function, array<f32, i32(3)>>)
{
    var network_2 : MLP_0;
    network_2.weights_8.first_0 = first_21;
    MLP_evaluate_1(network_2, &((*inputs_29)), &((*outputs_24)));
    return;
}

fn decode_2( first_22 : u32,  inputs_30 : ptr<function, array<f32, i32(20)>>,  outputs_25 : ptr<function, array<f32, i32(3)>>)
{
    var network_3 : MLP_0;
    network_3.weights_8.first_0 = first_22;
    MLP_evaluate_2(network_3, &((*inputs_30)), &((*outputs_25)));
    return;
}

fn dense_9( weights_25 : FloatWeights_0,  first_23 : u32,  adds_19 : bool,  inputs_31 : ptr<function, array<f32, i32(8)>>,  outputs_26 : ptr<function, array<f32, i32(12)>>)
{
    dense_part_9(weights_25, first_23, adds_19, &((*inputs_31)), &((*outputs_26)));
    return;
}

fn mixed_0( number_0 : u32) -> u32
{
    var bits_0 : u32 = ((number_0 ^ (((number_0 >> (u32(16))))))) * u32(2246822507);
    var bits_1 : u32 = ((bits_0 ^ (((bits_0 >> (u32(13))))))) * u32(3266489909);
    return (bits_1 ^ (((bits_1 >> (u32(16))))));
}

fn with_number_0( hash_0 : u32,  number_1 : f32) -> u32
{
    var _S161 : u32;
    if(number_1 == 0.0f)
    {
        _S161 = u32(0);
    }
    else
    {
        _S161 = (bitcast<u32>((number_1)));
    }
    return mixed_0((hash_0 ^ (_S161)));
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn hashed_0( footprint_0 : Footprint_0,  view_1 : vec3<f32>,  size_0 : vec2<f32>) -> u32
{
    var hash_1 : u32 = u32(2654435769);
    var axis_0 : u32 = u32(0);
    for(;;)
    {
        if(axis_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S162 : f32 = footprint_0.centre_0[axis_0] / size_0[axis_0];
        var _S163 : u32 = mixed_0((hash_1 ^ (u32((_S162 - floor(_S162)) * 4096.0f))));
        var _S164 : u32 = axis_0 + u32(1);
        hash_1 = _S163;
        axis_0 = _S164;
    }
    axis_0 = u32(0);
    for(;;)
    {
        if(axis_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S165 : u32 = with_number_0(hash_1, view_1[axis_0]);
        var _S166 : u32 = axis_0 + u32(1);
        hash_1 = _S165;
        axis_0 = _S166;
    }
    return with_number_0(with_number_0(with_number_0(with_number_0(hash_1, footprint_0.dx_0.x), footprint_0.dx_0.y), footprint_0.dy_0.x), footprint_0.dy_0.y);
}

fn uniform_of_0( seed_2 : u32,  dimension_0 : u32) -> f32
{
    return f32(((mixed_0(seed_2 + (dimension_0 + u32(1)) * u32(2654435769))) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S167 : vec2<f32> = direction_0.xy;
    var _S168 : f32;
    if(back_2)
    {
        _S168 = - direction_0.z;
    }
    else
    {
        _S168 = direction_0.z;
    }
    return vec3<f32>(_S167, _S168);
}

fn natural_logarithm_0( x_2 : f32) -> f32
{
    var _S169 : u32 = (bitcast<u32>((x_2)));
    var exponent_0 : f32 = f32(i32((_S169 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S169 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var exponent_1 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var exponent_2 : f32 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var _S170 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S170 - exponent_1 * 0.00021219444170129f - 0.5f * _S170) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_3 : f32) -> f32
{
    return natural_logarithm_0(x_3) * 1.4426950216293335f;
}

fn no_numbers_0() -> Eight_0
{
    var numbers_1 : Eight_0;
    var _S171 : vec4<f32> = vec4<f32>(0.0f);
    numbers_1.low_0 = _S171;
    numbers_1.high_0 = _S171;
    return numbers_1;
}

fn within_repeat_0( uv_0 : vec2<f32>) -> vec2<f32>
{
    return clamp(fract(uv_0), vec2<f32>(0.0f), vec2<f32>(1.0f));
}

fn eight_halves_0( packed_0 : vec4<u32>) -> Eight_0
{
    var numbers_2 : Eight_0;
    numbers_2.low_0 = vec4<f32>(unpack2x16float(packed_0.x), unpack2x16float(packed_0.y));
    numbers_2.high_0 = vec4<f32>(unpack2x16float(packed_0.z), unpack2x16float(packed_0.w));
    return numbers_2;
}

fn texel_numbers_0( first_24 : u32,  elements_1 : u32,  texel_0 : u32) -> Eight_0
{
    var _S172 : u32 = first_24 + texel_0 * elements_1;
    var _S173 : vec4<u32> = packed_numbers_0[_S172];
    if(elements_1 == u32(1))
    {
        return eight_halves_0(_S173);
    }
    var numbers_3 : Eight_0;
    numbers_3.low_0 = (bitcast<vec4<f32>>((_S173)));
    numbers_3.high_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S172 + u32(1)])));
    return numbers_3;
}

fn add_bilinear_0( first_25 : u32,  elements_2 : u32,  start_0 : u32,  columns_1 : u32,  rows_1 : u32,  uv_1 : vec2<f32>,  weight_0 : f32,  sums_6 : ptr<function, Eight_0>)
{
    var _S174 : vec2<f32> = uv_1 * vec2<f32>(f32(columns_1), f32(rows_1)) - vec2<f32>(0.5f);
    var _S175 : vec2<f32> = floor(_S174);
    var _S176 : vec2<f32> = _S174 - _S175;
    var _S177 : i32 = i32(_S175.x);
    var _S178 : i32 = i32(_S175.y);
    var tap_0 : u32 = u32(0);
    for(;;)
    {
        if(tap_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S179 : u32 = (tap_0 & (u32(1)));
        var _S180 : u32 = (tap_0 >> (u32(1)));
        var _S181 : Eight_0 = texel_numbers_0(first_25, elements_2, start_0 + ((u32(_S178 + i32(_S180)) & ((rows_1 - u32(1))))) * columns_1 + ((u32(_S177 + i32(_S179)) & ((columns_1 - u32(1))))));
        var _S182 : f32;
        if(_S180 != u32(0))
        {
            _S182 = _S176.y;
        }
        else
        {
            _S182 = 1.0f - _S176.y;
        }
        var _S183 : f32;
        if(_S179 != u32(0))
        {
            _S183 = _S176.x;
        }
        else
        {
            _S183 = 1.0f - _S176.x;
        }
        var _S184 : vec4<f32> = vec4<f32>((_S182 * _S183 * weight_0));
        (*sums_6).low_0 = (*sums_6).low_0 + _S184 * _S181.low_0;
        (*sums_6).high_0 = (*sums_6).high_0 + _S184 * _S181.high_0;
        tap_0 = tap_0 + u32(1);
    }
    return;
}

struct TexelPyramid_0
{
     first_26 : u32,
     elements_3 : u32,
     levels_4 : u32,
     last_level_3 : f32,
     face_texels_2 : u32,
};

fn TexelPyramid_add_level_0( this_4 : TexelPyramid_0,  place_0 : vec2<f32>,  level_0 : u32,  face_0 : u32,  weight_1 : f32,  sums_7 : ptr<function, Eight_0>)
{
    var _S185 : u32 = this_4.levels_4 + u32(3) * level_0;
    add_bilinear_0(this_4.first_26, this_4.elements_3, face_0 * this_4.face_texels_2 + words_0[_S185], words_0[_S185 + u32(1)], words_0[_S185 + u32(2)], place_0, weight_1, &((*sums_7)));
    return;
}

fn TexelPyramid_between_levels_0( this_5 : TexelPyramid_0,  uv_2 : vec2<f32>,  level_1 : f32,  face_1 : u32) -> Eight_0
{
    var _S186 : f32 = clamp(level_1, 0.0f, this_5.last_level_3);
    var _S187 : f32 = clamp(floor(_S186), 0.0f, max(this_5.last_level_3 - 1.0f, 0.0f));
    var _S188 : f32 = _S186 - _S187;
    var _S189 : vec2<f32> = within_repeat_0(uv_2);
    var texel_1 : Eight_0 = no_numbers_0();
    var offset_2 : u32 = u32(0);
    for(;;)
    {
        if(offset_2 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S190 : f32;
        if(offset_2 == u32(0))
        {
            _S190 = 1.0f - _S188;
        }
        else
        {
            _S190 = _S188;
        }
        if(_S190 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S189, u32(_S187) + offset_2, face_1, _S190, &(texel_1));
        }
        offset_2 = offset_2 + u32(1);
    }
    return texel_1;
}

fn TexelPyramid_of_level_0( this_6 : TexelPyramid_0,  uv_3 : vec2<f32>,  level_2 : u32,  face_2 : u32) -> Eight_0
{
    var texel_2 : Eight_0 = no_numbers_0();
    TexelPyramid_add_level_0(this_6, within_repeat_0(uv_3), level_2, face_2, 1.0f, &(texel_2));
    return texel_2;
}

fn channel_0( numbers_4 : Eight_0,  k_0 : i32) -> f32
{
    var _S191 : f32;
    if(k_0 < i32(4))
    {
        _S191 = numbers_4.low_0[k_0];
    }
    else
    {
        _S191 = numbers_4.high_0[k_0 - i32(4)];
    }
    return _S191;
}

struct LatentFrame_0
{
     tangent_0 : vec3<f32>,
     bitangent_0 : vec3<f32>,
     normal_0 : vec3<f32>,
};

fn frame_of_0( normal_1 : vec3<f32>,  tangent_1 : vec3<f32>) -> LatentFrame_0
{
    var result_0 : LatentFrame_0;
    var _S192 : vec3<f32> = normalize(normal_1 + vec3<f32>(0.0f, 0.0f, 1.0f));
    result_0.normal_0 = _S192;
    var _S193 : vec3<f32> = normalize(tangent_1 + vec3<f32>(1.0f, 0.0f, 0.0f));
    result_0.tangent_0 = _S193;
    result_0.bitangent_0 = cross(_S192, _S193);
    return result_0;
}

fn LatentFrame_coordinates_0( this_7 : LatentFrame_0,  direction_1 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_1, this_7.tangent_0), dot(direction_1, this_7.bitangent_0), dot(direction_1, this_7.normal_0));
}

fn exponential_0( x_4 : f32) -> f32
{
    var _S194 : f32 = clamp(x_4, -87.0f, 88.0f);
    var _S195 : f32 = floor(_S194 * 1.4426950216293335f + 0.5f);
    var _S196 : f32 = _S194 - _S195 * 0.693359375f + _S195 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S196 + 0.00139819993637502f) * _S196 + 0.00833345204591751f) * _S196 + 0.04166579619050026f) * _S196 + 0.1666666567325592f) * _S196 + 0.5f;
    var _S197 : f32 = (bitcast<f32>(((u32(i32(_S195) + i32(127)) << (u32(23))))));
    var _S198 : f32;
    if(x_4 < -87.0f)
    {
        _S198 = 0.0f;
    }
    else
    {
        _S198 = (p_0 * _S196 * _S196 + _S196 + 1.0f) * _S197;
    }
    return _S198;
}

fn bounded_exponential_0( exponent_3 : f32) -> f32
{
    return exponential_0(min(exponent_3, 12.0f));
}

struct LatentView_0
{
     latent_1 : array<f32, i32(8)>,
     first_27 : LatentFrame_0,
     second_0 : LatentFrame_0,
     view_2 : vec3<f32>,
     back_3 : bool,
};

fn latent_view_0( _S199 : u32,  _S200 : Footprint_0,  _S201 : vec3<f32>,  _S202 : f32,  _S203 : ptr<function, LatentView_0>)
{
    var _S204 : Latent_std430_0 = fabrics_0[_S199].latent_0;
    var _S205 : bool = (_S201.z) < 0.0f;
    (*_S203).back_3 = _S205;
    (*_S203).view_2 = to_face_frame_0(_S201, _S205);
    var _S206 : u32;
    if(_S205)
    {
        _S206 = _S204.back_1;
    }
    else
    {
        _S206 = u32(0);
    }
    var _S207 : vec2<f32> = _S200.centre_0 * vec2<f32>(_S204.repeats_per_x_1, _S204.repeats_per_y_1);
    var _S208 : f32 = clamp(binary_logarithm_0(max(sqrt(abs(_S200.dx_0.x * _S200.dy_0.y - _S200.dx_0.y * _S200.dy_0.x)) * _S204.texels_per_mm_1, 9.99999971718068537e-10f)), 0.0f, _S204.last_level_2);
    var pyramid_0 : TexelPyramid_0;
    pyramid_0.first_26 = _S204.texels_1;
    pyramid_0.elements_3 = _S204.texel_elements_1;
    pyramid_0.levels_4 = _S204.levels_3;
    pyramid_0.last_level_3 = _S204.last_level_2;
    pyramid_0.face_texels_2 = _S204.face_texels_1;
    var texel_3 : Eight_0;
    if((_S204.is_trilinear_0) != u32(0))
    {
        texel_3 = TexelPyramid_between_levels_0(pyramid_0, _S207, _S208, _S206);
    }
    else
    {
        var _S209 : TexelPyramid_0 = pyramid_0;
        var _S210 : u32 = u32(_S208);
        var _S211 : u32;
        if(_S202 < (_S208 - floor(_S208)))
        {
            _S211 = u32(1);
        }
        else
        {
            _S211 = u32(0);
        }
        texel_3 = TexelPyramid_of_level_0(_S209, _S207, _S210 + _S211, _S206);
    }
    var k_1 : i32 = i32(0);
    for(;;)
    {
        if(k_1 < i32(8))
        {
        }
        else
        {
            break;
        }
        (*_S203).latent_1[k_1] = channel_0(texel_3, k_1);
        k_1 = k_1 + i32(1);
    }
    var weights_26 : FloatWeights_0;
    weights_26.first_0 = _S204.frames_0;
    var _S212 : array<f32, i32(8)> = (*_S203).latent_1;
    var sums_8 : array<f32, i32(12)>;
    dense_9(weights_26, u32(0), false, &(_S212), &(sums_8));
    (*_S203).latent_1 = _S212;
    (*_S203).first_27 = frame_of_0(vec3<f32>(sums_8[i32(0)], sums_8[i32(1)], sums_8[i32(2)]), vec3<f32>(sums_8[i32(3)], sums_8[i32(4)], sums_8[i32(5)]));
    (*_S203).second_0 = frame_of_0(vec3<f32>(sums_8[i32(6)], sums_8[i32(7)], sums_8[i32(8)]), vec3<f32>(sums_8[i32(9)], sums_8[i32(10)], sums_8[i32(11)]));
    return;
}

fn latent_value_0( _S213 : u32,  _S214 : ptr<function, LatentView_0>,  _S215 : vec3<f32>) -> vec3<f32>
{
    var _S216 : vec3<f32> = to_face_frame_0(_S215, (*_S214).back_3);
    if((_S216.z) <= 0.0f)
    {
        return vec3<f32>(0.0f);
    }
    var inputs_32 : array<f32, i32(20)>;
    var _S217 : vec3<f32> = LatentFrame_coordinates_0((*_S214).first_27, (*_S214).view_2);
    var _S218 : vec3<f32> = LatentFrame_coordinates_0((*_S214).first_27, _S216);
    var _S219 : vec3<f32> = LatentFrame_coordinates_0((*_S214).second_0, (*_S214).view_2);
    var _S220 : vec3<f32> = LatentFrame_coordinates_0((*_S214).second_0, _S216);
    var axis_1 : i32 = i32(0);
    for(;;)
    {
        if(axis_1 < i32(3))
        {
        }
        else
        {
            break;
        }
        inputs_32[axis_1] = _S217[axis_1];
        inputs_32[i32(3) + axis_1] = _S218[axis_1];
        inputs_32[i32(6) + axis_1] = _S219[axis_1];
        inputs_32[i32(9) + axis_1] = _S220[axis_1];
        axis_1 = axis_1 + i32(1);
    }
    var k_2 : i32 = i32(0);
    for(;;)
    {
        if(k_2 < i32(8))
        {
        }
        else
        {
            break;
        }
        inputs_32[i32(12) + k_2] = (*_S214).latent_1[k_2];
        k_2 = k_2 + i32(1);
    }
    var outputs_27 : array<f32, i32(3)>;
    var _S221 : Latent_std430_0 = fabrics_0[_S213].latent_0;
    if((fabrics_0[_S213].latent_0.hidden_0) == u32(16))
    {
        decode_2(_S221.decoder_1, &(inputs_32), &(outputs_27));
    }
    else
    {
        if((_S221.hidden_0) == u32(32))
        {
            decode_1(_S221.decoder_1, &(inputs_32), &(outputs_27));
        }
        else
        {
            decode_0(_S221.decoder_1, &(inputs_32), &(outputs_27));
        }
    }
    return vec3<f32>(bounded_exponential_0(outputs_27[i32(0)] - 3.0f), bounded_exponential_0(outputs_27[i32(1)] - 3.0f), bounded_exponential_0(outputs_27[i32(2)] - 3.0f));
}

fn cloth_value_0( fabric_1 : u32,  centre_1 : vec2<f32>,  dx_1 : vec2<f32>,  dy_1 : vec2<f32>,  light_1 : vec3<f32>,  view_3 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = centre_1;
    footprint_1.dx_0 = dx_1;
    footprint_1.dy_0 = dy_1;
    var seen_0 : LatentView_0;
    latent_view_0(fabric_1, footprint_1, view_3, uniform_of_0(hashed_0(footprint_1, view_3, vec2<f32>(fabrics_0[fabric_1].latent_0.width_0, fabrics_0[fabric_1].latent_0.height_0)), u32(0)), &(seen_0));
    var _S222 : vec3<f32> = latent_value_0(fabric_1, &(seen_0), light_1);
    return vec4<f32>(_S222, 0.0f);
}

@compute
@workgroup_size(64, 1, 1)
fn latent_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S223 : u32 = id_0.x;
    if(_S223 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S224 : Query_std430_0 = queries_0[_S223];
    answers_0[_S223] = cloth_value_0(_S224.fabric_0, vec2<f32>(_S224.centre_x_0, _S224.centre_y_0), vec2<f32>(_S224.dx_x_0, _S224.dx_y_0), vec2<f32>(_S224.dy_x_0, _S224.dy_y_0), vec3<f32>(_S224.light_x_0, _S224.light_y_0, _S224.light_z_0), vec3<f32>(_S224.view_x_0, _S224.view_y_0, _S224.view_z_0));
    return;
}

