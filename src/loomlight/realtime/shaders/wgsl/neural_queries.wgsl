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

@binding(10) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

struct Family_std430_0
{
    @align(4) is_alike_0 : u32,
    @align(4) count_0 : f32,
    @align(4) inverse_count_0 : f32,
    @align(4) half_inverse_count_0 : f32,
    @align(4) size_0 : f32,
    @align(4) inverse_size_0 : f32,
    @align(4) half_width_0 : f32,
    @align(4) start_0 : f32,
    @align(4) period_0 : f32,
    @align(4) inverse_period_0 : f32,
    @align(4) bins_0 : f32,
    @align(4) first_thread_table_0 : u32,
    @align(4) place_table_0 : u32,
    @align(4) bend_table_0 : u32,
    @align(4) height_scale_0 : f32,
    @align(4) twist_sine_0 : f32,
    @align(4) twist_cosine_0 : f32,
    @align(4) level_0 : f32,
    @align(4) roughness_0 : f32,
    @align(4) albedo_table_0 : u32,
    @align(4) albedo_stride_0 : u32,
    @align(4) before_0 : u32,
    @align(4) visible_total_0 : f32,
    @align(4) smallest_box_0 : f32,
    @align(4) quantities_0 : u32,
    @align(4) colour_mean_0 : u32,
    @align(4) colour_axes_0 : u32,
    @align(4) colour_threads_0 : u32,
    @align(4) colour_areas_0 : u32,
    @align(4) area_unit_0 : f32,
    @align(4) crossing_area_0 : f32,
    @align(4) has_plies_0 : f32,
    @align(4) plies_per_mm_0 : f32,
    @align(4) ply_sine_0 : f32,
    @align(4) ply_cosine_0 : f32,
    @align(4) fibre_tilt_0 : f32,
    @align(4) fibre_tone_0 : f32,
    @align(4) slub_0 : f32,
    @align(4) slubs_per_mm_0 : f32,
    @align(4) per_half_width_0 : f32,
    @align(4) hairiness_0 : f32,
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

struct FloatWeights_0
{
     first_0 : u32,
};

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

fn tile_product_0( weights_0 : FloatWeights_0,  row_0 : u32,  inputs_0 : ptr<function, array<f32, i32(96)>>) -> vec4<f32>
{
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
    var column_0 : u32 = u32(0);
    for(;;)
    {
        if(column_0 < u32(12))
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
        var _S7 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(12) + column_0);
        sums_1[i32(1)] = sums_1[i32(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        var _S8 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(24) + column_0);
        sums_1[i32(2)] = sums_1[i32(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        var _S9 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(36) + column_0);
        sums_1[i32(3)] = sums_1[i32(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + u32(1);
    }
    return sums_1;
}

fn whole_parts_0( elements_0 : i32) -> i32
{
    return (elements_0 + i32(3)) / i32(4) * i32(4);
}

fn Identity_apply_0( x_0 : f32) -> f32
{
    return x_0;
}

fn dense_part_0( weights_1 : FloatWeights_0,  first_1 : u32,  adds_0 : bool,  inputs_1 : ptr<function, array<f32, i32(96)>>,  outputs_0 : ptr<function, array<f32, i32(50)>>)
{
    var _S10 : u32 = first_1 + u32(whole_parts_0(i32(7)));
    var output_0 : i32 = i32(0);
    for(;;)
    {
        var _S11 : bool = output_0 < i32(50);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        var _S12 : u32 = u32(output_0);
        var _S13 : Eight_0 = FloatWeights_eight_0(weights_1, first_1 + _S12 / u32(8));
        var _S14 : vec4<f32> = tile_product_0(weights_1, _S10 + _S12 * u32(12), &((*inputs_1)));
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
            (*outputs_0)[output_0] = Identity_apply_0(_S16[i32(0)] + _S17);
        }
        var _S18 : i32 = output_0 + i32(1);
        if(_S18 < i32(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S18] = Identity_apply_0(_S16[i32(1)] + _S17);
        }
        var _S19 : i32 = output_0 + i32(2);
        if(_S19 < i32(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S19] = Identity_apply_0(_S16[i32(2)] + _S17);
        }
        var _S20 : i32 = output_0 + i32(3);
        if(_S20 < i32(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S20] = Identity_apply_0(_S16[i32(3)] + _S17);
        }
        output_0 = output_0 + i32(4);
    }
    return;
}

struct HalfWeights_0
{
     first_2 : u32,
};

fn eight_halves_0( packed_0 : vec4<u32>) -> Eight_0
{
    var numbers_1 : Eight_0;
    numbers_1.low_0 = vec4<f32>(unpack2x16float(packed_0.x), unpack2x16float(packed_0.y));
    numbers_1.high_0 = vec4<f32>(unpack2x16float(packed_0.z), unpack2x16float(packed_0.w));
    return numbers_1;
}

fn HalfWeights_eight_0( this_1 : HalfWeights_0,  element_1 : u32) -> Eight_0
{
    return eight_halves_0(packed_numbers_0[this_1.first_2 + element_1]);
}

fn tile_product_1( weights_2 : HalfWeights_0,  row_1 : u32,  inputs_2 : ptr<function, array<f32, i32(96)>>) -> vec4<f32>
{
    var sums_2 : vec4<f32> = vec4<f32>(0.0f);
    var column_1 : u32 = u32(0);
    for(;;)
    {
        if(column_1 < u32(12))
        {
        }
        else
        {
            break;
        }
        var low_2 : vec4<f32>;
        var high_2 : vec4<f32>;
        var _S21 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_2)[_S21];
        high_2[i32(0)] = (*inputs_2)[_S21 + i32(4)];
        var _S22 : i32 = _S21 + i32(1);
        low_2[i32(1)] = (*inputs_2)[_S22];
        high_2[i32(1)] = (*inputs_2)[_S22 + i32(4)];
        var _S23 : i32 = _S21 + i32(2);
        low_2[i32(2)] = (*inputs_2)[_S23];
        high_2[i32(2)] = (*inputs_2)[_S23 + i32(4)];
        var _S24 : i32 = _S21 + i32(3);
        low_2[i32(3)] = (*inputs_2)[_S24];
        high_2[i32(3)] = (*inputs_2)[_S24 + i32(4)];
        var _S25 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        var _S26 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(12) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        var _S27 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(24) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        var _S28 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(36) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn dense_part_1( weights_3 : HalfWeights_0,  first_3 : u32,  adds_1 : bool,  inputs_3 : ptr<function, array<f32, i32(96)>>,  outputs_1 : ptr<function, array<f32, i32(52)>>)
{
    var _S29 : u32 = first_3 + u32(whole_parts_0(i32(7)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S30 : bool = output_1 < i32(52);
        if(_S30)
        {
        }
        else
        {
            break;
        }
        var _S31 : u32 = u32(output_1);
        var _S32 : Eight_0 = HalfWeights_eight_0(weights_3, first_3 + _S31 / u32(8));
        var _S33 : vec4<f32> = tile_product_1(weights_3, _S29 + _S31 * u32(12), &((*inputs_3)));
        var _S34 : vec4<f32>;
        if(((output_1 & (i32(4)))) != i32(0))
        {
            _S34 = _S32.high_0;
        }
        else
        {
            _S34 = _S32.low_0;
        }
        var _S35 : vec4<f32> = _S33 + _S34;
        var _S36 : f32;
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
            (*outputs_1)[output_1] = Identity_apply_0(_S35[i32(0)] + _S36);
        }
        var _S37 : i32 = output_1 + i32(1);
        if(_S37 < i32(52))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S37];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S37] = Identity_apply_0(_S35[i32(1)] + _S36);
        }
        var _S38 : i32 = output_1 + i32(2);
        if(_S38 < i32(52))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S38];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S38] = Identity_apply_0(_S35[i32(2)] + _S36);
        }
        var _S39 : i32 = output_1 + i32(3);
        if(_S39 < i32(52))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S39];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S39] = Identity_apply_0(_S35[i32(3)] + _S36);
        }
        output_1 = output_1 + i32(4);
    }
    return;
}

fn tile_product_2( weights_4 : HalfWeights_0,  row_2 : u32,  inputs_4 : ptr<function, array<f32, i32(39)>>) -> vec4<f32>
{
    var sums_3 : vec4<f32> = vec4<f32>(0.0f);
    var column_2 : u32 = u32(0);
    for(;;)
    {
        if(column_2 < u32(5))
        {
        }
        else
        {
            break;
        }
        var low_3 : vec4<f32>;
        var high_3 : vec4<f32>;
        var _S40 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_4)[min(_S40, i32(38))];
        high_3[i32(0)] = (*inputs_4)[min(_S40 + i32(4), i32(38))];
        var _S41 : i32 = _S40 + i32(1);
        low_3[i32(1)] = (*inputs_4)[min(_S41, i32(38))];
        high_3[i32(1)] = (*inputs_4)[min(_S41 + i32(4), i32(38))];
        var _S42 : i32 = _S40 + i32(2);
        low_3[i32(2)] = (*inputs_4)[min(_S42, i32(38))];
        high_3[i32(2)] = (*inputs_4)[min(_S42 + i32(4), i32(38))];
        var _S43 : i32 = _S40 + i32(3);
        low_3[i32(3)] = (*inputs_4)[min(_S43, i32(38))];
        high_3[i32(3)] = (*inputs_4)[min(_S43 + i32(4), i32(38))];
        var _S44 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        sums_3[i32(0)] = sums_3[i32(0)] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        var _S45 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(5) + column_2);
        sums_3[i32(1)] = sums_3[i32(1)] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        var _S46 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(10) + column_2);
        sums_3[i32(2)] = sums_3[i32(2)] + (dot(_S46.low_0, low_3) + dot(_S46.high_0, high_3));
        var _S47 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(15) + column_2);
        sums_3[i32(3)] = sums_3[i32(3)] + (dot(_S47.low_0, low_3) + dot(_S47.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_3;
}

fn dense_part_2( weights_5 : HalfWeights_0,  first_4 : u32,  adds_2 : bool,  inputs_5 : ptr<function, array<f32, i32(39)>>,  outputs_2 : ptr<function, array<f32, i32(96)>>)
{
    var _S48 : u32 = first_4 + u32(whole_parts_0(i32(12)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S49 : bool = output_2 < i32(96);
        if(_S49)
        {
        }
        else
        {
            break;
        }
        var _S50 : u32 = u32(output_2);
        var _S51 : Eight_0 = HalfWeights_eight_0(weights_5, first_4 + _S50 / u32(8));
        var _S52 : vec4<f32> = tile_product_2(weights_5, _S48 + _S50 * u32(5), &((*inputs_5)));
        var _S53 : vec4<f32>;
        if(((output_2 & (i32(4)))) != i32(0))
        {
            _S53 = _S51.high_0;
        }
        else
        {
            _S53 = _S51.low_0;
        }
        var _S54 : vec4<f32> = _S52 + _S53;
        var _S55 : f32;
        if(_S49)
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[output_2];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S54[i32(0)] + _S55);
        }
        var _S56 : i32 = output_2 + i32(1);
        if(_S56 < i32(96))
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[_S56];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[_S56] = Identity_apply_0(_S54[i32(1)] + _S55);
        }
        var _S57 : i32 = output_2 + i32(2);
        if(_S57 < i32(96))
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[_S57];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[_S57] = Identity_apply_0(_S54[i32(2)] + _S55);
        }
        var _S58 : i32 = output_2 + i32(3);
        if(_S58 < i32(96))
        {
            if(adds_2)
            {
                _S55 = (*outputs_2)[_S58];
            }
            else
            {
                _S55 = 0.0f;
            }
            (*outputs_2)[_S58] = Identity_apply_0(_S54[i32(3)] + _S55);
        }
        output_2 = output_2 + i32(4);
    }
    return;
}

fn tile_product_3( weights_6 : HalfWeights_0,  row_3 : u32,  inputs_6 : ptr<function, array<f32, i32(100)>>) -> vec4<f32>
{
    var sums_4 : vec4<f32> = vec4<f32>(0.0f);
    var column_3 : u32 = u32(0);
    for(;;)
    {
        if(column_3 < u32(13))
        {
        }
        else
        {
            break;
        }
        var low_4 : vec4<f32>;
        var high_4 : vec4<f32>;
        var _S59 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_6)[min(_S59, i32(99))];
        high_4[i32(0)] = (*inputs_6)[min(_S59 + i32(4), i32(99))];
        var _S60 : i32 = _S59 + i32(1);
        low_4[i32(1)] = (*inputs_6)[min(_S60, i32(99))];
        high_4[i32(1)] = (*inputs_6)[min(_S60 + i32(4), i32(99))];
        var _S61 : i32 = _S59 + i32(2);
        low_4[i32(2)] = (*inputs_6)[min(_S61, i32(99))];
        high_4[i32(2)] = (*inputs_6)[min(_S61 + i32(4), i32(99))];
        var _S62 : i32 = _S59 + i32(3);
        low_4[i32(3)] = (*inputs_6)[min(_S62, i32(99))];
        high_4[i32(3)] = (*inputs_6)[min(_S62 + i32(4), i32(99))];
        var _S63 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S63.low_0, low_4) + dot(_S63.high_0, high_4));
        var _S64 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(13) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S64.low_0, low_4) + dot(_S64.high_0, high_4));
        var _S65 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(26) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S65.low_0, low_4) + dot(_S65.high_0, high_4));
        var _S66 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(39) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S66.low_0, low_4) + dot(_S66.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_3( weights_7 : HalfWeights_0,  first_5 : u32,  adds_3 : bool,  inputs_7 : ptr<function, array<f32, i32(100)>>,  outputs_3 : ptr<function, array<f32, i32(96)>>)
{
    var _S67 : u32 = first_5 + u32(whole_parts_0(i32(12)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S68 : bool = output_3 < i32(96);
        if(_S68)
        {
        }
        else
        {
            break;
        }
        var _S69 : u32 = u32(output_3);
        var _S70 : Eight_0 = HalfWeights_eight_0(weights_7, first_5 + _S69 / u32(8));
        var _S71 : vec4<f32> = tile_product_3(weights_7, _S67 + _S69 * u32(13), &((*inputs_7)));
        var _S72 : vec4<f32>;
        if(((output_3 & (i32(4)))) != i32(0))
        {
            _S72 = _S70.high_0;
        }
        else
        {
            _S72 = _S70.low_0;
        }
        var _S73 : vec4<f32> = _S71 + _S72;
        var _S74 : f32;
        if(_S68)
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[output_3];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S73[i32(0)] + _S74);
        }
        var _S75 : i32 = output_3 + i32(1);
        if(_S75 < i32(96))
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[_S75];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[_S75] = Identity_apply_0(_S73[i32(1)] + _S74);
        }
        var _S76 : i32 = output_3 + i32(2);
        if(_S76 < i32(96))
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[_S76];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[_S76] = Identity_apply_0(_S73[i32(2)] + _S74);
        }
        var _S77 : i32 = output_3 + i32(3);
        if(_S77 < i32(96))
        {
            if(adds_3)
            {
                _S74 = (*outputs_3)[_S77];
            }
            else
            {
                _S74 = 0.0f;
            }
            (*outputs_3)[_S77] = Identity_apply_0(_S73[i32(3)] + _S74);
        }
        output_3 = output_3 + i32(4);
    }
    return;
}

fn tile_product_4( weights_8 : HalfWeights_0,  row_4 : u32,  inputs_8 : ptr<function, array<f32, i32(16)>>) -> vec4<f32>
{
    var sums_5 : vec4<f32> = vec4<f32>(0.0f);
    var column_4 : u32 = u32(0);
    for(;;)
    {
        if(column_4 < u32(2))
        {
        }
        else
        {
            break;
        }
        var low_5 : vec4<f32>;
        var high_5 : vec4<f32>;
        var _S78 : i32 = i32(u32(8) * column_4);
        low_5[i32(0)] = (*inputs_8)[_S78];
        high_5[i32(0)] = (*inputs_8)[_S78 + i32(4)];
        var _S79 : i32 = _S78 + i32(1);
        low_5[i32(1)] = (*inputs_8)[_S79];
        high_5[i32(1)] = (*inputs_8)[_S79 + i32(4)];
        var _S80 : i32 = _S78 + i32(2);
        low_5[i32(2)] = (*inputs_8)[_S80];
        high_5[i32(2)] = (*inputs_8)[_S80 + i32(4)];
        var _S81 : i32 = _S78 + i32(3);
        low_5[i32(3)] = (*inputs_8)[_S81];
        high_5[i32(3)] = (*inputs_8)[_S81 + i32(4)];
        var _S82 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        sums_5[i32(0)] = sums_5[i32(0)] + (dot(_S82.low_0, low_5) + dot(_S82.high_0, high_5));
        var _S83 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(2) + column_4);
        sums_5[i32(1)] = sums_5[i32(1)] + (dot(_S83.low_0, low_5) + dot(_S83.high_0, high_5));
        var _S84 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(4) + column_4);
        sums_5[i32(2)] = sums_5[i32(2)] + (dot(_S84.low_0, low_5) + dot(_S84.high_0, high_5));
        var _S85 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(6) + column_4);
        sums_5[i32(3)] = sums_5[i32(3)] + (dot(_S85.low_0, low_5) + dot(_S85.high_0, high_5));
        column_4 = column_4 + u32(1);
    }
    return sums_5;
}

fn dense_part_4( weights_9 : HalfWeights_0,  first_6 : u32,  adds_4 : bool,  inputs_9 : ptr<function, array<f32, i32(16)>>,  outputs_4 : ptr<function, array<f32, i32(1)>>)
{
    var _S86 : u32 = first_6 + u32(whole_parts_0(i32(1)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S87 : bool = output_4 < i32(1);
        if(_S87)
        {
        }
        else
        {
            break;
        }
        var _S88 : u32 = u32(output_4);
        var _S89 : Eight_0 = HalfWeights_eight_0(weights_9, first_6 + _S88 / u32(8));
        var _S90 : vec4<f32> = tile_product_4(weights_9, _S86 + _S88 * u32(2), &((*inputs_9)));
        var _S91 : vec4<f32>;
        if(((output_4 & (i32(4)))) != i32(0))
        {
            _S91 = _S89.high_0;
        }
        else
        {
            _S91 = _S89.low_0;
        }
        var _S92 : vec4<f32> = _S90 + _S91;
        var _S93 : f32;
        if(_S87)
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[output_4];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S92[i32(0)] + _S93);
        }
        var _S94 : i32 = output_4 + i32(1);
        if(_S94 < i32(1))
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[_S94];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[_S94] = Identity_apply_0(_S92[i32(1)] + _S93);
        }
        var _S95 : i32 = output_4 + i32(2);
        if(_S95 < i32(1))
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[_S95];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[_S95] = Identity_apply_0(_S92[i32(2)] + _S93);
        }
        var _S96 : i32 = output_4 + i32(3);
        if(_S96 < i32(1))
        {
            if(adds_4)
            {
                _S93 = (*outputs_4)[_S96];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_4)[_S96] = Identity_apply_0(_S92[i32(3)] + _S93);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn LeakyRelu_apply_0( x_1 : f32) -> f32
{
    return max(x_1, x_1 * 0.00999999977648258f);
}

fn dense_part_5( weights_10 : HalfWeights_0,  first_7 : u32,  adds_5 : bool,  inputs_10 : ptr<function, array<f32, i32(96)>>,  outputs_5 : ptr<function, array<f32, i32(96)>>)
{
    var _S97 : u32 = first_7 + u32(whole_parts_0(i32(12)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S98 : bool = output_5 < i32(96);
        if(_S98)
        {
        }
        else
        {
            break;
        }
        var _S99 : u32 = u32(output_5);
        var _S100 : Eight_0 = HalfWeights_eight_0(weights_10, first_7 + _S99 / u32(8));
        var _S101 : vec4<f32> = tile_product_1(weights_10, _S97 + _S99 * u32(12), &((*inputs_10)));
        var _S102 : vec4<f32>;
        if(((output_5 & (i32(4)))) != i32(0))
        {
            _S102 = _S100.high_0;
        }
        else
        {
            _S102 = _S100.low_0;
        }
        var _S103 : vec4<f32> = _S101 + _S102;
        var _S104 : f32;
        if(_S98)
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[output_5];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S103[i32(0)] + _S104);
        }
        var _S105 : i32 = output_5 + i32(1);
        if(_S105 < i32(96))
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[_S105];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[_S105] = LeakyRelu_apply_0(_S103[i32(1)] + _S104);
        }
        var _S106 : i32 = output_5 + i32(2);
        if(_S106 < i32(96))
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[_S106];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[_S106] = LeakyRelu_apply_0(_S103[i32(2)] + _S104);
        }
        var _S107 : i32 = output_5 + i32(3);
        if(_S107 < i32(96))
        {
            if(adds_5)
            {
                _S104 = (*outputs_5)[_S107];
            }
            else
            {
                _S104 = 0.0f;
            }
            (*outputs_5)[_S107] = LeakyRelu_apply_0(_S103[i32(3)] + _S104);
        }
        output_5 = output_5 + i32(4);
    }
    return;
}

fn dense_part_6( weights_11 : HalfWeights_0,  first_8 : u32,  adds_6 : bool,  inputs_11 : ptr<function, array<f32, i32(100)>>,  outputs_6 : ptr<function, array<f32, i32(16)>>)
{
    var _S108 : u32 = first_8 + u32(whole_parts_0(i32(2)));
    var output_6 : i32 = i32(0);
    for(;;)
    {
        var _S109 : bool = output_6 < i32(16);
        if(_S109)
        {
        }
        else
        {
            break;
        }
        var _S110 : u32 = u32(output_6);
        var _S111 : Eight_0 = HalfWeights_eight_0(weights_11, first_8 + _S110 / u32(8));
        var _S112 : vec4<f32> = tile_product_3(weights_11, _S108 + _S110 * u32(13), &((*inputs_11)));
        var _S113 : vec4<f32>;
        if(((output_6 & (i32(4)))) != i32(0))
        {
            _S113 = _S111.high_0;
        }
        else
        {
            _S113 = _S111.low_0;
        }
        var _S114 : vec4<f32> = _S112 + _S113;
        var _S115 : f32;
        if(_S109)
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[output_6];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S114[i32(0)] + _S115);
        }
        var _S116 : i32 = output_6 + i32(1);
        if(_S116 < i32(16))
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[_S116];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[_S116] = LeakyRelu_apply_0(_S114[i32(1)] + _S115);
        }
        var _S117 : i32 = output_6 + i32(2);
        if(_S117 < i32(16))
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[_S117];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[_S117] = LeakyRelu_apply_0(_S114[i32(2)] + _S115);
        }
        var _S118 : i32 = output_6 + i32(3);
        if(_S118 < i32(16))
        {
            if(adds_6)
            {
                _S115 = (*outputs_6)[_S118];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_6)[_S118] = LeakyRelu_apply_0(_S114[i32(3)] + _S115);
        }
        output_6 = output_6 + i32(4);
    }
    return;
}

fn tile_product_5( weights_12 : HalfWeights_0,  row_5 : u32,  inputs_12 : ptr<function, array<f32, i32(88)>>) -> vec4<f32>
{
    var sums_6 : vec4<f32> = vec4<f32>(0.0f);
    var column_5 : u32 = u32(0);
    for(;;)
    {
        if(column_5 < u32(11))
        {
        }
        else
        {
            break;
        }
        var low_6 : vec4<f32>;
        var high_6 : vec4<f32>;
        var _S119 : i32 = i32(u32(8) * column_5);
        low_6[i32(0)] = (*inputs_12)[_S119];
        high_6[i32(0)] = (*inputs_12)[_S119 + i32(4)];
        var _S120 : i32 = _S119 + i32(1);
        low_6[i32(1)] = (*inputs_12)[_S120];
        high_6[i32(1)] = (*inputs_12)[_S120 + i32(4)];
        var _S121 : i32 = _S119 + i32(2);
        low_6[i32(2)] = (*inputs_12)[_S121];
        high_6[i32(2)] = (*inputs_12)[_S121 + i32(4)];
        var _S122 : i32 = _S119 + i32(3);
        low_6[i32(3)] = (*inputs_12)[_S122];
        high_6[i32(3)] = (*inputs_12)[_S122 + i32(4)];
        var _S123 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        sums_6[i32(0)] = sums_6[i32(0)] + (dot(_S123.low_0, low_6) + dot(_S123.high_0, high_6));
        var _S124 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(11) + column_5);
        sums_6[i32(1)] = sums_6[i32(1)] + (dot(_S124.low_0, low_6) + dot(_S124.high_0, high_6));
        var _S125 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(22) + column_5);
        sums_6[i32(2)] = sums_6[i32(2)] + (dot(_S125.low_0, low_6) + dot(_S125.high_0, high_6));
        var _S126 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(33) + column_5);
        sums_6[i32(3)] = sums_6[i32(3)] + (dot(_S126.low_0, low_6) + dot(_S126.high_0, high_6));
        column_5 = column_5 + u32(1);
    }
    return sums_6;
}

fn dense_part_7( weights_13 : HalfWeights_0,  first_9 : u32,  adds_7 : bool,  inputs_13 : ptr<function, array<f32, i32(88)>>,  outputs_7 : ptr<function, array<f32, i32(96)>>)
{
    var _S127 : u32 = first_9 + u32(whole_parts_0(i32(12)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S128 : bool = output_7 < i32(96);
        if(_S128)
        {
        }
        else
        {
            break;
        }
        var _S129 : u32 = u32(output_7);
        var _S130 : Eight_0 = HalfWeights_eight_0(weights_13, first_9 + _S129 / u32(8));
        var _S131 : vec4<f32> = tile_product_5(weights_13, _S127 + _S129 * u32(11), &((*inputs_13)));
        var _S132 : vec4<f32>;
        if(((output_7 & (i32(4)))) != i32(0))
        {
            _S132 = _S130.high_0;
        }
        else
        {
            _S132 = _S130.low_0;
        }
        var _S133 : vec4<f32> = _S131 + _S132;
        var _S134 : f32;
        if(_S128)
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[output_7];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S133[i32(0)] + _S134);
        }
        var _S135 : i32 = output_7 + i32(1);
        if(_S135 < i32(96))
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[_S135];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[_S135] = LeakyRelu_apply_0(_S133[i32(1)] + _S134);
        }
        var _S136 : i32 = output_7 + i32(2);
        if(_S136 < i32(96))
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[_S136];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[_S136] = LeakyRelu_apply_0(_S133[i32(2)] + _S134);
        }
        var _S137 : i32 = output_7 + i32(3);
        if(_S137 < i32(96))
        {
            if(adds_7)
            {
                _S134 = (*outputs_7)[_S137];
            }
            else
            {
                _S134 = 0.0f;
            }
            (*outputs_7)[_S137] = LeakyRelu_apply_0(_S133[i32(3)] + _S134);
        }
        output_7 = output_7 + i32(4);
    }
    return;
}

fn rsqrt_0( x_2 : f32) -> f32
{
    return 1.0f / sqrt(x_2);
}

fn dense_0( weights_14 : FloatWeights_0,  first_10 : u32,  adds_8 : bool,  inputs_14 : ptr<function, array<f32, i32(96)>>,  outputs_8 : ptr<function, array<f32, i32(50)>>)
{
    dense_part_0(weights_14, first_10, adds_8, &((*inputs_14)), &((*outputs_8)));
    return;
}

fn dense_1( weights_15 : HalfWeights_0,  first_11 : u32,  adds_9 : bool,  inputs_15 : ptr<function, array<f32, i32(96)>>,  outputs_9 : ptr<function, array<f32, i32(52)>>)
{
    dense_part_1(weights_15, first_11, adds_9, &((*inputs_15)), &((*outputs_9)));
    return;
}

fn dense_2( weights_16 : HalfWeights_0,  first_12 : u32,  adds_10 : bool,  inputs_16 : ptr<function, array<f32, i32(96)>>,  outputs_10 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_5(weights_16, first_12, adds_10, &((*inputs_16)), &((*outputs_10)));
    return;
}

fn dense_3( weights_17 : HalfWeights_0,  first_13 : u32,  adds_11 : bool,  inputs_17 : ptr<function, array<f32, i32(39)>>,  outputs_11 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_2(weights_17, first_13, adds_11, &((*inputs_17)), &((*outputs_11)));
    return;
}

fn dense_4( weights_18 : HalfWeights_0,  first_14 : u32,  adds_12 : bool,  inputs_18 : ptr<function, array<f32, i32(100)>>,  outputs_12 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_3(weights_18, first_14, adds_12, &((*inputs_18)), &((*outputs_12)));
    return;
}

fn dense_5( weights_19 : HalfWeights_0,  first_15 : u32,  adds_13 : bool,  inputs_19 : ptr<function, array<f32, i32(16)>>,  outputs_13 : ptr<function, array<f32, i32(1)>>)
{
    dense_part_4(weights_19, first_15, adds_13, &((*inputs_19)), &((*outputs_13)));
    return;
}

fn dense_6( weights_20 : HalfWeights_0,  first_16 : u32,  adds_14 : bool,  inputs_20 : ptr<function, array<f32, i32(100)>>,  outputs_14 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_6(weights_20, first_16, adds_14, &((*inputs_20)), &((*outputs_14)));
    return;
}

fn dense_part_8( weights_21 : HalfWeights_0,  first_17 : u32,  adds_15 : bool,  inputs_21 : ptr<function, array<f32, i32(96)>>,  outputs_15 : ptr<function, array<f32, i32(100)>>)
{
    var _S138 : u32 = first_17 + u32(whole_parts_0(i32(12)));
    var output_8 : i32 = i32(0);
    for(;;)
    {
        var _S139 : bool = output_8 < i32(96);
        if(_S139)
        {
        }
        else
        {
            break;
        }
        var _S140 : u32 = u32(output_8);
        var _S141 : Eight_0 = HalfWeights_eight_0(weights_21, first_17 + _S140 / u32(8));
        var _S142 : vec4<f32> = tile_product_1(weights_21, _S138 + _S140 * u32(12), &((*inputs_21)));
        var _S143 : vec4<f32>;
        if(((output_8 & (i32(4)))) != i32(0))
        {
            _S143 = _S141.high_0;
        }
        else
        {
            _S143 = _S141.low_0;
        }
        var _S144 : vec4<f32> = _S142 + _S143;
        var _S145 : f32;
        if(_S139)
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[output_8];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S144[i32(0)] + _S145);
        }
        var _S146 : i32 = output_8 + i32(1);
        if(_S146 < i32(96))
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[_S146];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[_S146] = LeakyRelu_apply_0(_S144[i32(1)] + _S145);
        }
        var _S147 : i32 = output_8 + i32(2);
        if(_S147 < i32(96))
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[_S147];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[_S147] = LeakyRelu_apply_0(_S144[i32(2)] + _S145);
        }
        var _S148 : i32 = output_8 + i32(3);
        if(_S148 < i32(96))
        {
            if(adds_15)
            {
                _S145 = (*outputs_15)[_S148];
            }
            else
            {
                _S145 = 0.0f;
            }
            (*outputs_15)[_S148] = LeakyRelu_apply_0(_S144[i32(3)] + _S145);
        }
        output_8 = output_8 + i32(4);
    }
    return;
}

fn dense_7( weights_22 : HalfWeights_0,  first_18 : u32,  adds_16 : bool,  inputs_22 : ptr<function, array<f32, i32(88)>>,  outputs_16 : ptr<function, array<f32, i32(96)>>)
{
    dense_part_7(weights_22, first_18, adds_16, &((*inputs_22)), &((*outputs_16)));
    return;
}

fn square_0( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn row_of_taps_0( footprint_0 : Footprint_0) -> vec3<f32>
{
    var _S149 : f32 = footprint_0.dx_0.x;
    var _S150 : f32 = footprint_0.dy_0.x;
    var _S151 : f32 = _S149 * _S149 + _S150 * _S150;
    var _S152 : f32 = footprint_0.dx_0.y;
    var _S153 : f32 = footprint_0.dy_0.y;
    var _S154 : f32 = _S152 * _S152 + _S153 * _S153;
    var _S155 : f32 = _S149 * _S152 + _S150 * _S153;
    var _S156 : f32 = 0.5f * (_S151 - _S154);
    var _S157 : f32 = 0.5f * (_S151 + _S154);
    var _S158 : f32 = sqrt(_S156 * _S156 + _S155 * _S155);
    var _S159 : f32 = _S157 + _S158;
    var _S160 : f32 = max(_S159 - 1.5f * max(_S157 - _S158, 0.0f), 0.0f);
    var _S161 : f32 = square_0(4.0f);
    var _S162 : f32 = max(_S157 - 0.5f * _S160, _S159 / _S161);
    var _S163 : f32 = sqrt(max(min(_S160, _S159 - _S162), 0.0f) / (_S161 - 1.0f));
    var _S164 : f32 = _S156 / max(_S158, 1.00000000317107685e-30f);
    var _S165 : f32 = sqrt(max(0.5f * (1.0f - _S164), 0.0f));
    var _S166 : f32 = sqrt(_S162);
    var _S167 : f32 = _S163 * sqrt(max(0.5f * (1.0f + _S164), 0.0f));
    var _S168 : f32;
    if(_S155 < 0.0f)
    {
        _S168 = - _S163 * _S165;
    }
    else
    {
        _S168 = _S163 * _S165;
    }
    return vec3<f32>(_S166, _S167, _S168);
}

struct AnisotropicTaps_0
{
     centre_1 : vec2<f32>,
     side_0 : f32,
     first_19 : vec2<f32>,
     second_0 : vec2<f32>,
};

fn AnisotropicTaps_size_0( this_2 : AnisotropicTaps_0) -> f32
{
    var _S169 : f32 = this_2.first_19.x;
    var _S170 : f32 = this_2.second_0.x;
    var _S171 : f32 = this_2.side_0;
    var _S172 : f32 = _S171 * _S171;
    var _S173 : f32 = this_2.first_19.y;
    var _S174 : f32 = this_2.second_0.y;
    var _S175 : f32 = 12.0f * (_S169 * _S173 + _S170 * _S174);
    return sqrt(sqrt(max((12.0f * (_S169 * _S169 + _S170 * _S170) + _S172) * (12.0f * (_S173 * _S173 + _S174 * _S174) + _S172) - _S175 * _S175, square_0(_S172))));
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S176 : u32 = (bitcast<u32>((x_4)));
    var exponent_0 : f32 = f32(i32((_S176 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S176 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S177 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S177 - exponent_1 * 0.00021219444170129f - 0.5f * _S177) + exponent_1 * 0.693359375f;
}

fn footprint_coordinates_0( taps_0 : AnisotropicTaps_0) -> vec3<f32>
{
    return vec3<f32>(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S178 : vec2<f32> = direction_0.xy;
    var _S179 : f32;
    if(back_2)
    {
        _S179 = - direction_0.z;
    }
    else
    {
        _S179 = direction_0.z;
    }
    return vec3<f32>(_S178, _S179);
}

fn table_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_0])));
}

fn wrapped_0( index_1 : f32,  count_1 : f32) -> f32
{
    var _S180 : f32;
    if(index_1 < 0.0f)
    {
        _S180 = index_1 + count_1;
    }
    else
    {
        if(index_1 >= count_1)
        {
            _S180 = index_1 - count_1;
        }
        else
        {
            _S180 = index_1;
        }
    }
    return _S180;
}

fn binary_logarithm_0( x_5 : f32) -> f32
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
}

fn AnisotropicTaps_has_steps_0( this_3 : AnisotropicTaps_0) -> bool
{
    var _S181 : vec2<f32> = this_3.first_19;
    var _S182 : vec2<f32> = this_3.second_0;
    return (max(dot(_S181, _S181), dot(_S182, _S182))) > 0.0f;
}

fn AnisotropicTaps_place_0( this_4 : AnisotropicTaps_0,  number_0 : u32) -> vec2<f32>
{
    var _S183 : f32;
    if(number_0 >= u32(2))
    {
        _S183 = 1.0f;
    }
    else
    {
        _S183 = -1.0f;
    }
    var _S184 : f32;
    if(((number_0 & (u32(1)))) != u32(0))
    {
        _S184 = 1.0f;
    }
    else
    {
        _S184 = -1.0f;
    }
    return this_4.centre_1 + vec2<f32>(_S183) * this_4.first_19 + vec2<f32>(_S184) * this_4.second_0;
}

fn bump_0( distance_0 : f32) -> f32
{
    var _S185 : f32 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S185 * _S185;
}

fn correction_weight_of_0( coded_size_0 : f32) -> f32
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

fn exponential_0( x_6 : f32) -> f32
{
    var _S186 : f32 = clamp(x_6, -87.0f, 88.0f);
    var _S187 : f32 = floor(_S186 * 1.4426950216293335f + 0.5f);
    var _S188 : f32 = _S186 - _S187 * 0.693359375f + _S187 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S188 + 0.00139819993637502f) * _S188 + 0.00833345204591751f) * _S188 + 0.04166579619050026f) * _S188 + 0.1666666567325592f) * _S188 + 0.5f;
    var _S189 : f32 = (bitcast<f32>(((u32(i32(_S187) + i32(127)) << (u32(23))))));
    var _S190 : f32;
    if(x_6 < -87.0f)
    {
        _S190 = 0.0f;
    }
    else
    {
        _S190 = (p_0 * _S188 * _S188 + _S188 + 1.0f) * _S189;
    }
    return _S190;
}

fn unmapped_0( output_9 : f32,  scale_0 : f32) -> f32
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

fn square_1( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

fn mirrored_bundle_0( bundle_0 : u32) -> u32
{
    var _S191 : u32 = bundle_0 / u32(3);
    var _S192 : u32 = bundle_0 % u32(3);
    var _S193 : u32;
    if(bundle_0 == u32(24))
    {
        _S193 = bundle_0;
    }
    else
    {
        _S193 = _S191 * u32(3) + u32(3) - u32(1) - _S192;
    }
    return _S193;
}

fn light_visibility_of_0( diffuse_0 : f32,  light_1 : vec3<f32>,  view_1 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S194 : f32 = max(abs(light_1.z), 0.00100000004749745f);
    var _S195 : vec2<f32> = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S194, (0.59700000286102295f * _S194 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S195, view_1.xy) * rsqrt_0(max(dot(_S195, _S195), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S196 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S196, fma(- _S196, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_0 : f32) -> Cell_0
{
    var _S197 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S198 : f32 = fma(- _S197, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S198;
    cell_0.above_0 = families_0[family_1].size_0 - _S198;
    cell_0.across_0 = _S198 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S197).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn locate_varied_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S199 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S200 : u32;
    if(_S199 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S200 = u32(1);
    }
    else
    {
        _S200 = u32(0);
    }
    var _S201 : u32 = min(thread_1 + _S200, u32(families_0[family_2].count_0) - u32(1));
    var _S202 : u32 = families_0[family_2].place_table_0 + _S201 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S201;
    cell_1.below_0 = _S199 - table_number_0(_S202);
    cell_1.above_0 = table_number_0(_S202 + u32(1)) - _S199;
    cell_1.across_0 = _S199 - table_number_0(_S202 + u32(2));
    cell_1.half_width_1 = table_number_0(_S202 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Bound_0
{
     thread_2 : u32,
     turns_2 : f32,
     cell_2 : f32,
     visible_0 : f32,
     width_1 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_4 : u32,  position_3 : f32) -> Bound_0
{
    var _S203 : Cell_0 = locate_0(family_4, position_3);
    var _S204 : f32 = table_number_0(families_0[family_4].before_0 + u32(2) * _S203.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_2 = _S203.thread_0;
    bound_0.turns_2 = round((position_3 - families_0[family_4].start_0 - _S204 - _S203.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S203.below_0;
    var _S205 : f32 = 2.0f * _S203.half_width_1;
    bound_0.width_1 = _S205;
    bound_0.visible_0 = clamp((_S203.across_0 + _S203.half_width_1) / _S205, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S203.below_0, _S203.below_0 - _S203.across_0 - _S203.half_width_1) + max(_S203.across_0 - _S203.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_7 : Bound_0,
     high_7 : Bound_0,
};

fn stretch_of_0( family_5 : u32,  centre_2 : f32,  size_1 : f32) -> Stretch_0
{
    var _S206 : f32 = centre_2 - floor((centre_2 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    var _S207 : f32 = 0.5f * max(size_1, families_0[family_5].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S206 - _S207);
    stretch_0.high_7 = bound_at_0(family_5, _S206 + _S207);
    return stretch_0;
}

fn table_colour_0( index_3 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_3), table_number_0(index_3 + u32(1)), table_number_0(index_3 + u32(2)));
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn table_albedos_0( row_6 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_6);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_6 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_6 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_6 + u32(9));
    return albedos_0;
}

fn Stretch_turns_0( this_5 : Stretch_0) -> f32
{
    return this_5.high_7.turns_2 - this_5.low_7.turns_2;
}

fn lengths_0( family_6 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S208 : f32 = Stretch_turns_0(stretch_1);
    var _S209 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.low_7.thread_2;
    var _S210 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.high_7.thread_2;
    var _S211 : f32 = table_number_0(_S210) - table_number_0(_S209);
    var _S212 : f32 = table_number_0(_S210 + u32(1)) - table_number_0(_S209 + u32(1));
    return vec3<f32>(_S211 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_1 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_1 + _S208 * families_0[family_6].visible_total_0, _S212 - _S211 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S208 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S212 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S208 * families_0[family_6].period_0);
}

fn integrals_along_0( family_7 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S213 : u32 = u32(3) * families_0[family_7].quantities_0;
    var _S214 : u32 = families_0[family_7].colour_threads_0 + _S213 * stretch_2.low_7.thread_2 + quantity_0;
    var _S215 : u32 = families_0[family_7].colour_threads_0 + _S213 * stretch_2.high_7.thread_2 + quantity_0;
    var _S216 : u32 = families_0[family_7].colour_threads_0 + _S213 * u32(families_0[family_7].count_0) + quantity_0;
    var _S217 : f32 = table_number_0(_S214);
    var _S218 : f32 = table_number_0(_S215);
    var _S219 : f32 = Stretch_turns_0(stretch_2);
    var _S220 : u32 = u32(2) * families_0[family_7].quantities_0;
    return vec2<f32>(table_number_0(_S215 + families_0[family_7].quantities_0) - table_number_0(_S214 + families_0[family_7].quantities_0) + _S218 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_1 - _S217 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_1 + _S219 * table_number_0(_S216 + families_0[family_7].quantities_0), table_number_0(_S215 + _S220) - table_number_0(_S214 + _S220) + _S218 * stretch_2.high_7.cell_2 - _S217 * stretch_2.low_7.cell_2 + _S219 * table_number_0(_S216 + _S220));
}

fn Stretch_wraps_0( this_6 : Stretch_0) -> bool
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

fn Stretch_differences_0( this_7 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S221 : u32 = entries_0.z;
    var _S222 : u32 = entries_0.x;
    var _S223 : u32 = _S221 - _S222;
    var _S224 : u32;
    if(Stretch_wraps_0(this_7))
    {
        _S224 = whole_0;
    }
    else
    {
        _S224 = u32(0);
    }
    return vec4<u32>(_S223 + _S224, entries_0.w - _S221, entries_0.y - _S222, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_7 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S225 : u32 = row_7 + across_1.low_7.thread_2 * quantities_1;
    var _S226 : u32 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S225], words_0[_S225 + quantities_1], words_0[_S226], words_0[_S226 + quantities_1]), words_0[row_7 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_8 : Stretch_0) -> vec4<f32>
{
    var _S227 : f32 = - this_8.low_7.visible_0;
    var _S228 : f32 = Stretch_turns_0(this_8);
    var _S229 : f32;
    if(Stretch_wraps_0(this_8))
    {
        _S229 = 1.0f;
    }
    else
    {
        _S229 = 0.0f;
    }
    return vec4<f32>(1.0f, this_8.high_7.visible_0, _S227, _S228 - _S229);
}

fn integral_on_top_0( family_8 : u32,  across_2 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S230 : u32 = u32(families_0[family_8].count_0);
    var _S231 : u32 = (_S230 + u32(1)) * families_0[family_8].quantities_0;
    var _S232 : u32 = families_0[family_8].colour_areas_0 + quantity_1;
    var _S233 : vec4<u32> = row_differences_0(across_2, _S232 + along_0.low_7.thread_2 * _S231, _S230, families_0[family_8].quantities_0);
    var _S234 : vec4<u32> = row_differences_0(across_2, _S232 + (along_0.low_7.thread_2 + u32(1)) * _S231, _S230, families_0[family_8].quantities_0);
    var _S235 : vec4<u32> = row_differences_0(across_2, _S232 + along_0.high_7.thread_2 * _S231, _S230, families_0[family_8].quantities_0);
    var _S236 : vec4<u32> = row_differences_0(across_2, _S232 + (along_0.high_7.thread_2 + u32(1)) * _S231, _S230, families_0[family_8].quantities_0);
    var _S237 : vec4<u32> = row_differences_0(across_2, _S232 + crossing_count_0 * _S231, _S230, families_0[family_8].quantities_0);
    var _S238 : vec4<u32> = _S235 - _S233;
    var _S239 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S239 = _S237;
    }
    else
    {
        _S239 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S240 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S238 + _S239)), _S240), dot(vec4<f32>(vec4<i32>(_S236 - _S235)), _S240), dot(vec4<f32>(vec4<i32>(_S234 - _S233)), _S240), dot(vec4<f32>(vec4<i32>(_S237)), _S240)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_8 : u32) -> Albedos_0
{
    var _S241 : Albedos_0 = table_albedos_0(row_8);
    var sum_0 : Albedos_0;
    var _S242 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S242 * _S241.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S242 * _S241.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S242 * _S241.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S242 * _S241.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_9 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S243 : vec3<f32> = lengths_0(crossing_0, other_0);
    var is_exposed_0 : bool = false;
    var weight_1 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S244 : vec2<f32> = integrals_along_0(family_9, own_0, quantity_2);
        var _S245 : f32 = integral_on_top_0(family_9, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S246 : f32 = _S244.x;
        var _S247 : f32 = _S246 * _S243.x;
        var _S248 : f32;
        if(back_3)
        {
            _S248 = _S247 - _S245;
        }
        else
        {
            _S248 = _S245;
        }
        var _S249 : bool = quantity_2 == u32(0);
        if(_S249)
        {
            is_exposed_0 = _S248 > (16.0f * families_0[family_9].area_unit_0 * min(_S247 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S247);
        }
        var _S250 : f32 = _S246 * _S243.y;
        var _S251 : f32;
        if(is_exposed_0)
        {
            _S251 = _S248;
        }
        else
        {
            _S251 = 0.0f;
        }
        var _S252 : f32 = _S250 + _S251 + 0.000244140625f * _S243.z * _S244.y;
        if(_S249)
        {
            weight_1 = 1.0f / max(_S252, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S252 * weight_1, families_0[family_9].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

fn no_blocked_0() -> Blocked_0
{
    var nothing_0 : Blocked_0;
    nothing_0.by_warp_0 = 0.0f;
    nothing_0.by_weft_0 = 0.0f;
    nothing_0.far_0 = 0.0f;
    return nothing_0;
}

struct CloseUp_0
{
     weight_2 : f32,
     warp_1 : Blocked_0,
     weft_1 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_1 : CloseUp_0;
    nothing_1.weight_2 = 0.0f;
    var _S253 : Blocked_0 = no_blocked_0();
    nothing_1.warp_1 = _S253;
    nothing_1.weft_1 = _S253;
    return nothing_1;
}

fn tinted_0( albedos_3 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     mean_0 : vec3<f32>,
     leaked_0 : vec3<f32>,
};

struct FaceSends_0
{
     sky_warp_0 : vec3<f32>,
     sky_weft_0 : vec3<f32>,
     crossing_warp_0 : vec3<f32>,
     crossing_weft_0 : vec3<f32>,
     open_0 : f32,
     blocks_warp_0 : f32,
     blocks_weft_0 : f32,
};

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_0 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S254 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S255 : vec3<f32> = sends_0.sky_warp_0 + _S254 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S255;
    var _S256 : vec3<f32> = sends_0.sky_weft_0 + _S254 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S256;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S255 + vec3<f32>(sends_0.blocks_weft_0) * _S256;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S257 : f32 = 1.0f - view_2.z;
    var _S258 : f32 = _S257 * _S257;
    (*terms_0)[i32(0)] = 1.0f;
    var _S259 : f32 = view_2.x;
    var _S260 : f32 = _S259 * _S259;
    var _S261 : f32 = view_2.y;
    var _S262 : f32 = _S261 * _S261;
    (*terms_0)[i32(1)] = sqrt(max(_S260 + _S262, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S258;
    (*terms_0)[i32(3)] = _S258 * _S258;
    (*terms_0)[i32(4)] = _S260 - _S262;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_3 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S263 : f32 = 1.0f - view_3.z;
    var _S264 : f32 = _S263 * _S263;
    (*terms_1)[i32(0)] = 1.0f;
    var _S265 : f32 = view_3.x;
    var _S266 : f32 = _S265 * _S265;
    var _S267 : f32 = view_3.y;
    var _S268 : f32 = _S267 * _S267;
    (*terms_1)[i32(1)] = sqrt(max(_S266 + _S268, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S264;
    (*terms_1)[i32(3)] = _S264 * _S264;
    (*terms_1)[i32(4)] = _S266 - _S268;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

fn scaled_0( blocked_0 : Blocked_0,  share_0 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_0 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_0 * blocked_0.by_weft_0;
    result_1.far_0 = share_0 * blocked_0.far_0;
    return result_1;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Scattered_0
{
     back_4 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_3 : vec3<f32>,
     weft_3 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S269 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S270 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_3) + _S270 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S270 * interior_0.far_1 + yarn_0.back_4 * _S269;
    return bounced_0;
}

fn sum_of_0( first_20 : Bounced_0,  second_1 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_20.reflected_0 + second_1.reflected_0;
    sum_1.transmitted_0 = first_20.transmitted_0 + second_1.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S271 : f32 = light_2.z;
    var _S272 : vec3<f32>;
    if((_S271 * view_4.z) < 0.0f)
    {
        _S272 = bounced_1.transmitted_0;
    }
    else
    {
        _S272 = bounced_1.reflected_0;
    }
    return _S272 * vec3<f32>((abs(_S271) * 0.31830987334251404f));
}

fn sheen_scale_0( x_7 : f32,  y_0 : f32) -> f32
{
    return (((((0.0f * x_7 + (((((-1.1402510404586792f * y_0 + 0.40672621130943298f) * y_0 + 1.65398800373077393f) * y_0 + -1.29730904102325439f) * y_0 + 0.30570998787879944f) * y_0 + -0.0220868494361639f)) * x_7 + (((((-0.21142719686031342f * y_0 + 1.05947399139404297f) * y_0 + -0.41116121411323547f) * y_0 + -0.93859231472015381f) * y_0 + 0.51606941223144531f) * y_0 + 0.05409301072359085f)) * x_7 + (((((1.22944498062133789f * y_0 + -0.45962560176849365f) * y_0 + -1.63861405849456787f) * y_0 + 1.33565104007720947f) * y_0 + -0.45725581049919128f) * y_0 + 0.08243165910243988f)) * x_7 + (((((0.39779931306838989f * y_0 + -1.18879103660583496f) * y_0 + 0.28251591324806213f) * y_0 + 1.168984055519104f) * y_0 + -0.76864629983901978f) * y_0 + 0.0091691892594099f)) * x_7 + (((((-0.26563560962677002f * y_0 + -0.19379159808158875f) * y_0 + 0.2677634060382843f) * y_0 + 0.00270519289188087f) * y_0 + 0.14349560439586639f) * y_0 + 0.10290180146694183f)) * x_7 + (((((-0.20701569318771362f * y_0 + 0.24526430666446686f) * y_0 + 0.19551840424537659f) * y_0 + 0.07586126774549484f) * y_0 + 0.38894739747047424f) * y_0 + 0.15043120086193085f);
}

fn sheen_shear_0( x_8 : f32,  y_1 : f32) -> f32
{
    return ((((0.0f * x_8 + (((((-0.10608240216970444f * y_1 + 1.99214303493499756f) * y_1 + -1.42255294322967529f) * y_1 + -1.09495604038238525f) * y_1 + 0.59180057048797607f) * y_1 + 0.06902855634689331f)) * x_8 + (((((-0.46220690011978149f * y_1 + -0.29113379120826721f) * y_1 + 1.39025199413299561f) * y_1 + 0.35589990019798279f) * y_1 + -1.17120099067687988f) * y_1 + 0.15940259397029877f)) * x_8 + (((((2.26068711280822754f * y_1 + -3.64728999137878418f) * y_1 + -0.72173482179641724f) * y_1 + 3.07659196853637695f) * y_1 + -0.6827620267868042f) * y_1 + -0.3039557933807373f)) * x_8 + (((((0.81201767921447754f * y_1 + 0.36014080047607422f) * y_1 + -1.72646903991699219f) * y_1 + -0.22630110383033752f) * y_1 + 0.89514690637588501f) * y_1 + -0.10397960245609283f)) * x_8 + (((((-0.37648698687553406f * y_1 + 1.10974001884460449f) * y_1 + 0.17824520170688629f) * y_1 + -1.04968702793121338f) * y_1 + 0.1461234986782074f) * y_1 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_9 : f32,  y_2 : f32) -> f32
{
    return ((((0.0f * x_9 + (((((12.95646953582763672f * y_2 + -21.38032913208007812f) * y_2 + -7.37853097915649414f) * y_2 + 34.55607986450195312f) * y_2 + -23.61347007751464844f) * y_2 + 5.00126314163208008f)) * x_9 + (((((10.91487026214599609f * y_2 + -6.08202791213989258f) * y_2 + -38.2036285400390625f) * y_2 + 53.3440399169921875f) * y_2 + -21.91996002197265625f) * y_2 + 2.01606011390686035f)) * x_9 + (((((-14.52206039428710938f * y_2 + 36.803619384765625f) * y_2 + -22.94047927856445312f) * y_2 + -10.07973003387451172f) * y_2 + 15.77003955841064453f) * y_2 + -4.92722177505493164f)) * x_9 + (((((-7.62505722045898438f * y_2 + 1.27310299873352051f) * y_2 + 31.19523048400878906f) * y_2 + -44.39989852905273438f) * y_2 + 26.44947052001953125f) * y_2 + -8.73507976531982422f)) * x_9 + (((((5.65633487701416016f * y_2 + -17.66820907592773438f) * y_2 + 24.65356063842773438f) * y_2 + -19.38941001892089844f) * y_2 + 11.06159019470214844f) * y_2 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_1 : f32) -> vec3<f32>
{
    var _S273 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S274 : f32 = 2.0f * sqrt(_S273) - 1.0f;
    var _S275 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S274, _S275), 0.00999999977648258f, 1.0f), clamp((1.0f - _S273) * sheen_shear_0(_S274, _S275), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S274, _S275), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_5 : vec3<f32>,  scale_1 : f32,  shear_0 : f32) -> f32
{
    var _S276 : f32 = light_3.z;
    var _S277 : bool;
    if(_S276 <= 0.0f)
    {
        _S277 = true;
    }
    else
    {
        _S277 = (view_5.z) <= 0.0f;
    }
    if(_S277)
    {
        return 0.0f;
    }
    var _S278 : vec2<f32> = view_5.xy;
    var _S279 : f32 = dot(_S278, _S278);
    var _S280 : vec2<f32>;
    if(_S279 > 9.99999968265522539e-21f)
    {
        _S280 = _S278 * vec2<f32>(rsqrt_0(_S279));
    }
    else
    {
        _S280 = vec2<f32>(1.0f, 0.0f);
    }
    var _S281 : f32 = scale_1 * dot(light_3.xy, _S280) + shear_0 * _S276;
    var _S282 : f32 = scale_1 * (light_3.y * _S280.x - light_3.x * _S280.y);
    var _S283 : f32 = _S281 * _S281 + _S282 * _S282 + _S276 * _S276;
    return 0.31830987334251404f * scale_1 * scale_1 * _S276 / max(_S283 * _S283, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  strength_0 : f32,  roughness_2 : f32) -> vec2<f32>
{
    var _S284 : vec3<f32> = sheen_lobe_0(view_6.z, roughness_2);
    var _S285 : f32 = strength_0 * _S284.z;
    return vec2<f32>(_S285 * transformed_cosine_0(light_4, view_6, _S284.x, _S284.y), 1.0f - _S285);
}

struct NeuralView_0
{
     sums_7 : array<f32, i32(96)>,
     hole_0 : f32,
     correction_weight_0 : f32,
     view_7 : vec3<f32>,
     back_5 : bool,
};

fn anisotropic_taps_0( _S286 : u32,  _S287 : Footprint_0) -> AnisotropicTaps_0
{
    var _S288 : vec3<f32> = row_of_taps_0(_S287);
    var _S289 : vec2<f32> = _S287.dx_0;
    var _S290 : vec2<f32> = _S287.dy_0;
    var _S291 : f32 = dot(_S289, _S289) + dot(_S290, _S290);
    var _S292 : f32 = _S287.dx_0.x * _S287.dy_0.y - _S287.dx_0.y * _S287.dy_0.x;
    var _S293 : f32 = 0.5f * (_S291 + sqrt(max(_S291 * _S291 - 4.0f * _S292 * _S292, 0.0f)));
    var _S294 : Neural_std430_0 = fabrics_0[_S286].neural_0;
    var _S295 : bool;
    if(_S293 < (5.5f * (_S291 - _S293)))
    {
        _S295 = _S291 > (8.0f * _S294.pitch_0 * _S294.pitch_0);
    }
    else
    {
        _S295 = false;
    }
    var _S296 : vec2<f32> = vec2<f32>(_S294.ends_per_mm_0, _S294.picks_per_mm_0);
    var taps_1 : AnisotropicTaps_0;
    taps_1.centre_1 = _S287.centre_0 * _S296;
    var _S297 : f32;
    if(_S295)
    {
        _S297 = sqrt(0.125f * _S291);
    }
    else
    {
        _S297 = _S288.x;
    }
    taps_1.side_0 = _S297 / _S294.pitch_0;
    var _S298 : vec2<f32>;
    if(_S295)
    {
        _S298 = vec2<f32>(0.25f) * _S287.dx_0;
    }
    else
    {
        _S298 = _S288.yz;
    }
    taps_1.first_19 = _S298 * _S296;
    if(_S295)
    {
        _S298 = vec2<f32>(0.25f) * _S287.dy_0;
    }
    else
    {
        _S298 = vec2<f32>(0.5f) * _S288.yz;
    }
    taps_1.second_0 = _S298 * _S296;
    return taps_1;
}

fn add_texel_0( _S299 : u32,  _S300 : u32,  _S301 : f32,  _S302 : ptr<function, array<f32, i32(88)>>)
{
    var _S303 : u32 = fabrics_0[_S299].neural_0.latents_0 + _S300 * u32(8);
    var part_0 : u32 = u32(0);
    for(;;)
    {
        if(part_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S304 : Eight_0 = eight_halves_0(packed_numbers_0[_S303 + part_0]);
        var _S305 : i32 = i32(u32(8) * part_0);
        (*_S302)[_S305] = (*_S302)[_S305] + _S301 * _S304.low_0[i32(0)];
        (*_S302)[_S305 + i32(4)] = (*_S302)[_S305 + i32(4)] + _S301 * _S304.high_0[i32(0)];
        var _S306 : i32 = _S305 + i32(1);
        (*_S302)[_S306] = (*_S302)[_S306] + _S301 * _S304.low_0[i32(1)];
        (*_S302)[_S306 + i32(4)] = (*_S302)[_S306 + i32(4)] + _S301 * _S304.high_0[i32(1)];
        var _S307 : i32 = _S305 + i32(2);
        (*_S302)[_S307] = (*_S302)[_S307] + _S301 * _S304.low_0[i32(2)];
        (*_S302)[_S307 + i32(4)] = (*_S302)[_S307 + i32(4)] + _S301 * _S304.high_0[i32(2)];
        var _S308 : i32 = _S305 + i32(3);
        (*_S302)[_S308] = (*_S302)[_S308] + _S301 * _S304.low_0[i32(3)];
        (*_S302)[_S308 + i32(4)] = (*_S302)[_S308 + i32(4)] + _S301 * _S304.high_0[i32(3)];
        part_0 = part_0 + u32(1);
    }
    return;
}

fn add_level_0( _S309 : u32,  _S310 : u32,  _S311 : bool,  _S312 : vec2<f32>,  _S313 : f32,  _S314 : ptr<function, array<f32, i32(88)>>)
{
    var _S315 : Neural_std430_0 = fabrics_0[_S309].neural_0;
    var _S316 : u32 = fabrics_0[_S309].neural_0.levels_1 + u32(4) * _S310;
    var _S317 : f32 = table_number_0(_S316);
    var _S318 : f32 = table_number_0(_S316 + u32(1));
    var _S319 : f32 = table_number_0(_S316 + u32(2));
    var _S320 : bool;
    if(_S310 > u32(3))
    {
        _S320 = _S310 < (_S315.top_level_0);
    }
    else
    {
        _S320 = false;
    }
    var _S321 : vec2<f32> = _S312 * vec2<f32>(table_number_0(_S316 + u32(3)));
    var _S322 : f32;
    if(_S320)
    {
        _S322 = 1.0f;
    }
    else
    {
        _S322 = 0.5f;
    }
    var _S323 : vec2<f32> = _S321 - vec2<f32>(_S322);
    var _S324 : vec2<f32> = floor(_S323);
    var _S325 : vec2<f32> = _S323 - _S324;
    var corner_0 : u32 = u32(0);
    for(;;)
    {
        if(corner_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S326 : f32 = f32((corner_0 & (u32(1))));
        var _S327 : f32 = f32((corner_0 >> (u32(1))));
        var _S328 : vec2<f32> = mix(vec2<f32>(1.0f) - _S325, _S325, vec2<f32>(_S326, _S327));
        var _S329 : u32 = u32(_S317 + wrapped_0(_S324.y + _S327, _S319) * _S318 + wrapped_0(_S324.x + _S326, _S318));
        var _S330 : u32;
        if(_S311)
        {
            _S330 = _S315.texels_0;
        }
        else
        {
            _S330 = u32(0);
        }
        add_texel_0(_S309, _S329 + _S330, _S313 * _S328.x * _S328.y, &((*_S314)));
        corner_0 = corner_0 + u32(1);
    }
    return;
}

fn code_footprint_0( _S331 : u32,  _S332 : AnisotropicTaps_0,  _S333 : vec3<f32>,  _S334 : bool,  _S335 : ptr<function, array<f32, i32(88)>>)
{
    var offset_2 : f32;
    var k_0 : i32 = i32(0);
    for(;;)
    {
        if(k_0 < i32(64))
        {
        }
        else
        {
            break;
        }
        (*_S335)[k_0] = 0.0f;
        k_0 = k_0 + i32(1);
    }
    var _S336 : vec2<f32> = vec2<f32>(fabrics_0[_S331].neural_0.ends_0, fabrics_0[_S331].neural_0.picks_0);
    var _S337 : f32 = f32(fabrics_0[_S331].neural_0.top_level_0);
    var _S338 : f32 = clamp(binary_logarithm_0(max(_S332.side_0, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S337);
    var _S339 : f32 = min(floor(_S338), _S337 - 1.0f);
    var _S340 : u32;
    if(AnisotropicTaps_has_steps_0(_S332))
    {
        _S340 = u32(4);
    }
    else
    {
        _S340 = u32(1);
    }
    var number_1 : u32 = u32(0);
    for(;;)
    {
        if(number_1 < (u32(2) * _S340))
        {
        }
        else
        {
            break;
        }
        var _S341 : vec2<f32> = AnisotropicTaps_place_0(_S332, (number_1 >> (u32(1))));
        var _S342 : vec2<f32> = clamp(_S341 - _S336 * floor(_S341 / _S336), vec2<f32>(0.0f), _S336);
        var _S343 : bool = ((number_1 & (u32(1)))) != u32(0);
        if(_S343)
        {
            offset_2 = _S338 - _S339;
        }
        else
        {
            offset_2 = 1.0f - (_S338 - _S339);
        }
        var _S344 : f32 = offset_2 / f32(_S340);
        var _S345 : u32 = u32(_S339);
        var _S346 : u32;
        if(_S343)
        {
            _S346 = u32(1);
        }
        else
        {
            _S346 = u32(0);
        }
        add_level_0(_S331, _S345 + _S346, _S334, _S342, _S344, &((*_S335)));
        number_1 = number_1 + u32(1);
    }
    var number_2 : i32 = i32(0);
    for(;;)
    {
        if(number_2 < i32(3))
        {
        }
        else
        {
            break;
        }
        var bin_0 : i32 = i32(0);
        for(;;)
        {
            if(bin_0 < i32(8))
            {
            }
            else
            {
                break;
            }
            var offset_3 : f32 = _S333[number_2] - (f32(bin_0) + 0.5f) / 8.0f;
            if(number_2 < i32(2))
            {
                offset_2 = offset_3 - round(offset_3);
            }
            else
            {
                offset_2 = offset_3;
            }
            (*_S335)[i32(64) + number_2 * i32(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + i32(1);
        }
        number_2 = number_2 + i32(1);
    }
    return;
}

fn crown_fibres_0( _S347 : u32,  _S348 : bool,  _S349 : bool) -> vec3<f32>
{
    var _S350 : f32;
    if(_S348)
    {
        if(_S349)
        {
            _S350 = - fabrics_0[_S347].neural_0.warp_x_0;
        }
        else
        {
            _S350 = fabrics_0[_S347].neural_0.warp_x_0;
        }
        return vec3<f32>(_S350, fabrics_0[_S347].neural_0.warp_y_0, fabrics_0[_S347].neural_0.warp_roughness_0);
    }
    var _S351 : Neural_std430_0 = fabrics_0[_S347].neural_0;
    if(_S349)
    {
        _S350 = - _S351.weft_y_0;
    }
    else
    {
        _S350 = _S351.weft_y_0;
    }
    return vec3<f32>(_S351.weft_x_0, _S350, _S351.weft_roughness_0);
}

fn neural_view_0( _S352 : u32,  _S353 : Footprint_0,  _S354 : vec3<f32>,  _S355 : ptr<function, NeuralView_0>)
{
    var _S356 : bool = (_S354.z) < 0.0f;
    var _S357 : AnisotropicTaps_0 = anisotropic_taps_0(_S352, _S353);
    var _S358 : vec3<f32> = footprint_coordinates_0(_S357);
    var _S359 : vec3<f32> = to_face_frame_0(_S354, _S356);
    var weights_23 : HalfWeights_0;
    weights_23.first_2 = fabrics_0[_S352].neural_0.network_0;
    var inputs_23 : array<f32, i32(88)>;
    code_footprint_0(_S352, _S357, _S358, _S356, &(inputs_23));
    var hidden_1 : array<f32, i32(96)>;
    dense_7(weights_23, u32(0), false, &(inputs_23), &(hidden_1));
    var fused_0 : array<f32, i32(100)>;
    dense_part_8(weights_23, u32(1068), false, &(hidden_1), &(fused_0));
    fused_0[i32(96)] = _S359.x;
    fused_0[i32(97)] = _S359.y;
    var _S360 : vec2<f32> = _S359.xy;
    fused_0[i32(98)] = dot(crown_fibres_0(_S352, true, _S356).xy, _S360);
    fused_0[i32(99)] = dot(crown_fibres_0(_S352, false, _S356).xy, _S360);
    var of_hole_0 : array<f32, i32(16)>;
    dense_6(weights_23, u32(2232), false, &(fused_0), &(of_hole_0));
    var hole_1 : array<f32, i32(1)>;
    dense_5(weights_23, u32(2444), false, &(of_hole_0), &(hole_1));
    var _S361 : array<f32, i32(96)> = (*_S355).sums_7;
    dense_4(weights_23, u32(2456), false, &(fused_0), &(_S361));
    (*_S355).sums_7 = _S361;
    (*_S355).hole_0 = clamp(hole_1[i32(0)], 0.0f, 1.0f);
    (*_S355).correction_weight_0 = correction_weight_of_0(_S358.z);
    (*_S355).view_7 = _S359;
    (*_S355).back_5 = _S356;
    return;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_2 : f32,
};

fn code_light_0( _S362 : u32,  _S363 : vec3<f32>,  _S364 : vec3<f32>,  _S365 : bool,  _S366 : ptr<function, array<f32, i32(39)>>)
{
    (*_S366)[i32(0)] = _S363.x;
    (*_S366)[i32(1)] = _S363.y;
    (*_S366)[i32(2)] = _S363.z;
    var _S367 : vec3<f32> = _S363 + _S364;
    var _S368 : f32 = _S367.z;
    var _S369 : f32 = _S368 * _S368 + 0.00009999999747379f;
    var _S370 : vec2<f32> = _S367.xy;
    var _S371 : f32 = 1.0f / (dot(_S370, _S370) + _S369);
    var family_10 : i32 = i32(0);
    for(;;)
    {
        if(family_10 < i32(2))
        {
        }
        else
        {
            break;
        }
        var _S372 : vec3<f32> = crown_fibres_0(_S362, family_10 == i32(0), _S365);
        var _S373 : vec2<f32> = _S372.xy;
        (*_S366)[i32(3) + family_10] = dot(_S373, _S363.xy);
        var _S374 : f32 = dot(_S373, _S370);
        var _S375 : f32 = _S374 * _S374;
        var _S376 : f32 = (0.75f * _S374 / (0.5f * sqrt(_S375 + _S369) + abs(_S374)) + 0.5f) * 8.0f;
        var bin_1 : i32 = i32(0);
        for(;;)
        {
            if(bin_1 < i32(16))
            {
            }
            else
            {
                break;
            }
            (*_S366)[i32(5) + family_10 * i32(16) + bin_1] = bump_0(_S376 - (f32(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + i32(1);
        }
        var _S377 : f32 = _S372.z;
        var _S378 : f32 = _S377 * _S377;
        var _S379 : f32 = _S375 * _S371 * (1.0f - _S378) + _S378;
        (*_S366)[i32(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S378 * _S377 / (_S379 * _S379));
        family_10 = family_10 + i32(1);
    }
    return;
}

fn mixed_bundles_0( _S380 : u32,  _S381 : u32,  _S382 : u32,  _S383 : vec3<f32>,  _S384 : vec3<f32>,  _S385 : bool,  _S386 : ptr<function, array<f32, i32(52)>>) -> f32
{
    var _S387 : vec3<f32> = _S383 + _S384;
    var _S388 : f32 = 1.0f / (square_1(_S387) + 0.00009999999747379f);
    var _S389 : bool;
    if(_S381 == u32(0))
    {
        _S389 = _S385;
    }
    else
    {
        _S389 = false;
    }
    var _S390 : f32;
    if(_S389)
    {
        _S390 = - _S387.x;
    }
    else
    {
        _S390 = _S387.x;
    }
    if(_S381 == u32(1))
    {
        _S389 = _S385;
    }
    else
    {
        _S389 = false;
    }
    var _S391 : f32;
    if(_S389)
    {
        _S391 = - _S387.y;
    }
    else
    {
        _S391 = _S387.y;
    }
    var bundle_1 : u32 = u32(0);
    var sum_2 : f32 = 0.0f;
    for(;;)
    {
        if(bundle_1 < u32(25))
        {
        }
        else
        {
            break;
        }
        var _S392 : u32 = _S381 * u32(25);
        var _S393 : u32 = fabrics_0[_S380].neural_0.bundles_0 + u32(4) * (_S392 + bundle_1);
        var _S394 : f32 = dot(vec3<f32>(table_number_0(_S393), table_number_0(_S393 + u32(1)), table_number_0(_S393 + u32(2))), vec3<f32>(_S390, _S391, _S387.z));
        var _S395 : f32 = _S394 * _S394 * _S388 + table_number_0(_S393 + u32(3));
        var _S396 : u32 = _S382 + _S392;
        var _S397 : u32;
        if(_S385)
        {
            _S397 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S397 = bundle_1;
        }
        var sum_3 : f32 = sum_2 + max((*_S386)[_S396 + _S397], (*_S386)[_S396 + _S397] * 0.00999999977648258f) / (_S395 * _S395);
        bundle_1 = bundle_1 + u32(1);
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

fn neural_components_0( _S398 : u32,  _S399 : ptr<function, NeuralView_0>,  _S400 : vec3<f32>) -> Components_0
{
    var _S401 : f32;
    var _S402 : bool = (*_S399).back_5;
    var _S403 : vec3<f32> = to_face_frame_0(_S400, (*_S399).back_5);
    var _S404 : vec3<f32> = (*_S399).view_7;
    var weights_24 : HalfWeights_0;
    var _S405 : Neural_std430_0 = fabrics_0[_S398].neural_0;
    weights_24.first_2 = fabrics_0[_S398].neural_0.network_0;
    var directions_0 : array<f32, i32(39)>;
    code_light_0(_S398, _S403, (*_S399).view_7, (*_S399).back_5, &(directions_0));
    var skip_0 : array<f32, i32(96)>;
    var k_1 : i32 = i32(0);
    for(;;)
    {
        if(k_1 < i32(96))
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = (*_S399).sums_7[k_1];
        k_1 = k_1 + i32(1);
    }
    dense_3(weights_24, u32(3716), true, &(directions_0), &(skip_0));
    var hidden_2 : array<f32, i32(96)>;
    var next_0 : array<f32, i32(96)>;
    k_1 = i32(0);
    for(;;)
    {
        if(k_1 < i32(96))
        {
        }
        else
        {
            break;
        }
        hidden_2[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
        k_1 = k_1 + i32(1);
    }
    var layer_0 : u32 = u32(0);
    for(;;)
    {
        if(layer_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        k_1 = i32(0);
        for(;;)
        {
            if(k_1 < i32(96))
            {
            }
            else
            {
                break;
            }
            if(layer_0 == u32(1))
            {
                _S401 = skip_0[k_1];
            }
            else
            {
                _S401 = 0.0f;
            }
            next_0[k_1] = _S401;
            k_1 = k_1 + i32(1);
        }
        dense_2(weights_24, u32(4208) + layer_0 * u32(1164), true, &(hidden_2), &(next_0));
        var k_2 : i32 = i32(0);
        for(;;)
        {
            if(k_2 < i32(96))
            {
            }
            else
            {
                break;
            }
            hidden_2[k_2] = next_0[k_2];
            k_2 = k_2 + i32(1);
        }
        layer_0 = layer_0 + u32(1);
    }
    var outputs_17 : array<f32, i32(52)>;
    dense_1(weights_24, u32(7700), false, &(hidden_2), &(outputs_17));
    var _S406 : bool;
    if((_S405.is_corrected_0) != u32(0))
    {
        _S406 = (_S403.z) > 0.0f;
    }
    else
    {
        _S406 = false;
    }
    if(_S406)
    {
        _S406 = ((*_S399).correction_weight_0) > 0.0f;
    }
    else
    {
        _S406 = false;
    }
    if(_S406)
    {
        var fitted_0 : FloatWeights_0;
        fitted_0.first_0 = _S405.correction_0;
        var change_0 : array<f32, i32(50)>;
        dense_0(fitted_0, u32(0), false, &(hidden_2), &(change_0));
        k_1 = i32(0);
        for(;;)
        {
            if(k_1 < i32(50))
            {
            }
            else
            {
                break;
            }
            outputs_17[k_1 + i32(2)] = outputs_17[k_1 + i32(2)] + (*_S399).correction_weight_0 * change_0[k_1];
            k_1 = k_1 + i32(1);
        }
    }
    if((_S403.z) > 0.0f)
    {
        _S401 = 0.00999999977648258f;
    }
    else
    {
        _S401 = 0.00100000004749745f;
    }
    var result_2 : Components_0;
    var _S407 : f32 = unmapped_0(outputs_17[i32(0)], _S401);
    result_2.diffuse_warp_0 = _S407;
    var _S408 : f32 = unmapped_0(outputs_17[i32(1)], _S401);
    result_2.diffuse_weft_0 = _S408;
    var _S409 : f32 = 2979.9580078125f * _S401;
    var _S410 : f32 = mixed_bundles_0(_S398, u32(0), u32(2), _S403, _S404, _S402, &(outputs_17));
    result_2.specular_warp_0 = clamp(_S410, 0.0f, _S409);
    var _S411 : f32 = mixed_bundles_0(_S398, u32(1), u32(2), _S403, _S404, _S402, &(outputs_17));
    result_2.specular_weft_0 = clamp(_S411, 0.0f, _S409);
    result_2.hole_2 = (*_S399).hole_0;
    result_2.light_visibility_1 = min(light_visibility_of_0(_S407 + _S408, _S403, _S404, fabrics_0[_S398].diffuse_blend_0), 1.0f - (*_S399).hole_0);
    return result_2;
}

struct FamilyAlbedos_0
{
     warp_4 : Albedos_0,
     weft_4 : Albedos_0,
};

fn albedos_over_0( _S412 : u32,  _S413 : Footprint_0,  _S414 : bool) -> FamilyAlbedos_0
{
    var _S415 : vec2<f32> = _S413.dx_0;
    var _S416 : vec2<f32> = _S413.dy_0;
    var _S417 : vec2<f32> = sqrt(_S415 * _S415 + _S416 * _S416);
    var _S418 : Stretch_0 = stretch_of_0(fabrics_0[_S412].warp_0, _S413.centre_0.x, _S417.x);
    var _S419 : Stretch_0 = stretch_of_0(fabrics_0[_S412].weft_0, _S413.centre_0.y, _S417.y);
    var albedos_4 : FamilyAlbedos_0;
    albedos_4.warp_4 = mean_albedos_0(fabrics_0[_S412].warp_0, fabrics_0[_S412].weft_0, _S418, _S419, _S414);
    albedos_4.weft_4 = mean_albedos_0(fabrics_0[_S412].weft_0, fabrics_0[_S412].warp_0, _S419, _S418, _S414);
    return albedos_4;
}

fn openness_number_0( _S420 : u32,  _S421 : u32) -> f32
{
    return table_number_0(fabrics_0[_S420].openness_0 + _S421);
}

fn scattered_by_0( _S422 : u32,  _S423 : Albedos_0,  _S424 : u32,  _S425 : vec3<f32>) -> Scattered_0
{
    var _S426 : u32 = u32(159) + u32(2) * _S424;
    var yarn_1 : Scattered_0;
    yarn_1.back_4 = _S425 * _S423.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S422, _S426)) * _S423.specular_reflect_0;
    yarn_1.through_0 = _S425 * _S423.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S422, _S426 + u32(1))) * _S423.specular_transmit_0;
    return yarn_1;
}

fn sent_0( _S427 : u32,  _S428 : u32,  _S429 : vec3<f32>,  _S430 : vec3<f32>,  _S431 : vec3<f32>,  _S432 : vec3<f32>,  _S433 : ptr<function, vec3<f32>>,  _S434 : ptr<function, vec3<f32>>)
{
    var _S435 : u32 = u32(146) + u32(4) * _S428;
    var _S436 : f32 = openness_number_0(_S427, _S435 + u32(1));
    var _S437 : f32 = openness_number_0(_S427, _S435 + u32(2));
    var _S438 : vec3<f32> = vec3<f32>(1.0f);
    var _S439 : vec3<f32> = _S438 - _S431 * vec3<f32>(openness_number_0(_S427, _S435));
    var _S440 : vec3<f32> = _S438 - _S432 * vec3<f32>(openness_number_0(_S427, _S435 + u32(3)));
    var _S441 : vec3<f32> = _S438 / (_S439 * _S440 - _S431 * _S432 * vec3<f32>((_S436 * _S437)));
    (*_S433) = (_S429 * _S440 + _S431 * vec3<f32>(_S436) * _S430) * _S441;
    (*_S434) = (_S430 * _S439 + _S432 * vec3<f32>(_S437) * _S429) * _S441;
    return;
}

fn face_sends_0( _S442 : u32,  _S443 : u32,  _S444 : Scattered_0,  _S445 : Scattered_0) -> FaceSends_0
{
    var _S446 : u32 = u32(2) * _S443;
    var _S447 : u32 = u32(142) + _S446;
    var _S448 : f32 = openness_number_0(_S442, _S447);
    var _S449 : f32 = openness_number_0(_S442, _S447 + u32(1));
    var _S450 : vec3<f32> = vec3<f32>((1.0f - _S448)) * _S444.back_4;
    var _S451 : vec3<f32> = vec3<f32>((1.0f - _S449)) * _S445.back_4;
    var sends_1 : FaceSends_0;
    var _S452 : u32 = u32(154) + _S446;
    var _S453 : f32 = openness_number_0(_S442, _S452);
    sends_1.blocks_warp_0 = _S453;
    var _S454 : f32 = openness_number_0(_S442, _S452 + u32(1));
    sends_1.blocks_weft_0 = _S454;
    sends_1.open_0 = _S453 * _S448 + _S454 * _S449;
    var _S455 : vec3<f32> = vec3<f32>(_S448) * _S444.back_4;
    var _S456 : vec3<f32> = vec3<f32>(_S449) * _S445.back_4;
    var _S457 : vec3<f32> = sends_1.sky_warp_0;
    var _S458 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S442, _S443, _S455, _S456, _S450, _S451, &(_S457), &(_S458));
    sends_1.sky_warp_0 = _S457;
    sends_1.sky_weft_0 = _S458;
    var _S459 : vec3<f32> = sends_1.crossing_warp_0;
    var _S460 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S442, _S443, _S444.through_0, _S445.through_0, _S450, _S451, &(_S459), &(_S460));
    sends_1.crossing_warp_0 = _S459;
    sends_1.crossing_weft_0 = _S460;
    return sends_1;
}

fn interior_of_0( _S461 : u32,  _S462 : vec3<f32>,  _S463 : bool) -> Interior_0
{
    var _S464 : Scattered_0 = scattered_by_0(_S461, table_albedos_0(families_0[fabrics_0[_S461].warp_0].colour_mean_0), u32(0), _S462);
    var _S465 : Scattered_0 = scattered_by_0(_S461, table_albedos_0(families_0[fabrics_0[_S461].weft_0].colour_mean_0), u32(1), _S462);
    var _S466 : u32;
    if(_S463)
    {
        _S466 = u32(1);
    }
    else
    {
        _S466 = u32(0);
    }
    var _S467 : FaceSends_0 = face_sends_0(_S461, _S466, _S464, _S465);
    if(_S463)
    {
        _S466 = u32(0);
    }
    else
    {
        _S466 = u32(1);
    }
    var _S468 : FaceSends_0 = face_sends_0(_S461, _S466, _S464, _S465);
    var _S469 : vec3<f32> = vec3<f32>(_S467.blocks_warp_0);
    var _S470 : vec3<f32> = vec3<f32>(_S467.blocks_weft_0);
    var _S471 : vec3<f32> = _S469 * _S467.crossing_warp_0 + _S470 * _S467.crossing_weft_0;
    var _S472 : vec3<f32> = vec3<f32>(_S468.blocks_warp_0);
    var _S473 : vec3<f32> = vec3<f32>(_S468.blocks_weft_0);
    var _S474 : vec3<f32> = _S472 * _S468.crossing_warp_0 + _S473 * _S468.crossing_weft_0;
    var _S475 : f32 = 1.0f - _S467.open_0;
    var _S476 : f32 = 1.0f - _S468.open_0;
    var _S477 : vec3<f32> = vec3<f32>(1.0f);
    var _S478 : vec3<f32> = _S477 / (_S477 - _S471 * _S474 * vec3<f32>((_S475 * _S476)));
    var _S479 : vec3<f32> = _S474 * (vec3<f32>(_S467.open_0) + vec3<f32>(_S475) * (_S469 * _S467.sky_warp_0 + _S470 * _S467.sky_weft_0)) * _S478;
    var _S480 : vec3<f32> = _S471 * (vec3<f32>(_S468.open_0) + vec3<f32>(_S476) * (_S472 * _S468.sky_warp_0 + _S473 * _S468.sky_weft_0)) * _S478;
    var _S481 : FaceRadiance_0 = face_radiance_0(_S467, _S468.open_0, _S479, _S480);
    var _S482 : FaceRadiance_0 = face_radiance_0(_S468, _S467.open_0, _S480, _S479);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S481.warp_2;
    interior_1.weft_3 = _S481.weft_2;
    interior_1.leaked_1 = _S481.leaked_0;
    interior_1.far_1 = _S482.mean_0;
    interior_1.far_leaked_0 = _S482.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S483 : u32,  _S484 : u32,  _S485 : array<f32, i32(6)>,  _S486 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_1 : u32 = u32(0);
    for(;;)
    {
        if(share_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_1] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S486)
            {
            }
            else
            {
                break;
            }
            shares_0[share_1] = shares_0[share_1] + openness_number_0(_S483, _S484 + share_1 * _S486 + term_0) * _S485[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_1] = saturate(shares_0[share_1]);
        share_1 = share_1 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S487 : u32,  _S488 : vec3<f32>,  _S489 : bool,  _S490 : bool) -> Blocked_0
{
    var terms_2 : array<f32, i32(6)>;
    view_terms_0(_S488, &(terms_2));
    var _S491 : u32;
    if(_S490)
    {
        _S491 = u32(2);
    }
    else
    {
        _S491 = u32(0);
    }
    var _S492 : u32;
    if(_S489)
    {
        _S492 = u32(0);
    }
    else
    {
        _S492 = u32(1);
    }
    return blocked_of_terms_0(_S487, (_S491 + _S492) * u32(15), terms_2, u32(5));
}

fn warp_seen_from_0( _S493 : u32,  _S494 : vec3<f32>,  _S495 : bool) -> f32
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_1(_S494, &(terms_3));
    var term_1 : u32 = u32(0);
    var share_2 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var _S496 : u32;
        if(_S495)
        {
            _S496 = u32(5);
        }
        else
        {
            _S496 = u32(0);
        }
        var share_3 : f32 = share_2 + openness_number_0(_S493, u32(132) + _S496 + term_1) * terms_3[term_1];
        term_1 = term_1 + u32(1);
        share_2 = share_3;
    }
    return saturate(share_2);
}

fn bounced_of_families_0( _S497 : u32,  _S498 : FamilyAlbedos_0,  _S499 : vec3<f32>,  _S500 : Interior_0,  _S501 : Blocked_0,  _S502 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S501, scattered_by_0(_S497, _S498.warp_4, u32(0), _S499), _S500), bounced_by_0(_S502, scattered_by_0(_S497, _S498.weft_4, u32(1), _S499), _S500));
}

fn bounced_far_0( _S503 : u32,  _S504 : FamilyAlbedos_0,  _S505 : vec3<f32>,  _S506 : Interior_0,  _S507 : vec3<f32>,  _S508 : bool,  _S509 : f32,  _S510 : f32,  _S511 : f32) -> Bounced_0
{
    var _S512 : Blocked_0 = blocked_from_0(_S503, _S507, true, _S508);
    var _S513 : Blocked_0 = blocked_from_0(_S503, _S507, false, _S508);
    var _S514 : f32 = _S509 / max(1.0f - _S512.by_warp_0 - _S512.by_weft_0, 0.10000000149011612f);
    var _S515 : f32 = (0.0020000000949949f * warp_seen_from_0(_S503, _S507, _S508) + _S514) / (_S514 + _S510 / max(1.0f - _S513.by_warp_0 - _S513.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S516 : f32 = 1.0f - _S511;
    return bounced_of_families_0(_S503, _S504, _S505, _S506, scaled_0(_S512, _S515 * _S516), scaled_0(_S513, (1.0f - _S515) * _S516));
}

fn bounced_over_0( _S517 : u32,  _S518 : Components_0,  _S519 : CloseUp_0,  _S520 : FamilyAlbedos_0,  _S521 : vec3<f32>,  _S522 : vec3<f32>) -> Bounced_0
{
    var _S523 : bool = (_S522.z) < 0.0f;
    var _S524 : Interior_0 = interior_of_0(_S517, _S521, _S523);
    var bounced_2 : Bounced_0 = bounced_far_0(_S517, _S520, _S521, _S524, to_face_frame_0(_S522, _S523), _S523, _S518.diffuse_warp_0, _S518.diffuse_weft_0, _S518.hole_2);
    if((_S519.weight_2) > 0.0f)
    {
        var _S525 : Bounced_0 = bounced_of_families_0(_S517, _S520, _S521, _S524, _S519.warp_1, _S519.weft_1);
        var _S526 : vec3<f32> = vec3<f32>(_S519.weight_2);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S525.reflected_0, _S526);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S525.transmitted_0, _S526);
    }
    return bounced_2;
}

fn composed_0( _S527 : u32,  _S528 : Components_0,  _S529 : CloseUp_0,  _S530 : FamilyAlbedos_0,  _S531 : vec3<f32>,  _S532 : vec3<f32>,  _S533 : vec3<f32>) -> vec3<f32>
{
    var _S534 : Albedos_0 = tinted_0(_S530.warp_4, _S531);
    var _S535 : Albedos_0 = tinted_0(_S530.weft_4, _S531);
    var _S536 : vec3<f32> = vec3<f32>(_S528.diffuse_warp_0);
    var _S537 : vec3<f32> = vec3<f32>(_S528.diffuse_weft_0);
    var _S538 : vec3<f32> = vec3<f32>(_S528.specular_warp_0);
    var _S539 : vec3<f32> = vec3<f32>(_S528.specular_weft_0);
    var _S540 : vec3<f32> = _S534.diffuse_reflect_0 * _S536 + _S535.diffuse_reflect_0 * _S537 + _S534.specular_reflect_0 * _S538 + _S535.specular_reflect_0 * _S539;
    var _S541 : f32 = _S533.z;
    var body_0 : vec3<f32>;
    if((_S532.z * _S541) < 0.0f)
    {
        body_0 = _S534.diffuse_transmit_0 * _S536 + _S535.diffuse_transmit_0 * _S537 + _S534.specular_transmit_0 * _S538 + _S535.specular_transmit_0 * _S539;
    }
    else
    {
        body_0 = _S540;
    }
    if((fabrics_0[_S527].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S527, _S528, _S529, _S530, _S531, _S533), _S532, _S533);
    }
    var _S542 : f32 = fabrics_0[_S527].sheen_strength_0;
    if((fabrics_0[_S527].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S543 : bool = _S541 < 0.0f;
    var _S544 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S532, _S543), to_face_frame_0(_S533, _S543), _S542, fabrics_0[_S527].sheen_roughness_0);
    return vec3<f32>(_S544.y) * body_0 + vec3<f32>(((_S528.light_visibility_1 + _S528.hole_2) * _S544.x));
}

fn cloth_value_0( fabric_1 : u32,  centre_3 : vec2<f32>,  dx_1 : vec2<f32>,  dy_1 : vec2<f32>,  light_5 : vec3<f32>,  view_8 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = centre_3;
    footprint_1.dx_0 = dx_1;
    footprint_1.dy_0 = dy_1;
    var activations_0 : NeuralView_0;
    neural_view_0(fabric_1, footprint_1, view_8, &(activations_0));
    var _S545 : Components_0 = neural_components_0(fabric_1, &(activations_0), light_5);
    var _S546 : f32 = view_8.z;
    var _S547 : vec3<f32> = composed_0(fabric_1, _S545, no_close_up_0(), albedos_over_0(fabric_1, footprint_1, _S546 < 0.0f), vec3<f32>(1.0f), light_5, view_8);
    var through_1 : f32 = activations_0.hole_0;
    var through_2 : f32;
    if((fabrics_0[fabric_1].sheen_strength_0) > 0.0f)
    {
        through_2 = through_1 * (1.0f - fabrics_0[fabric_1].sheen_strength_0 * sheen_lobe_0(abs(_S546), fabrics_0[fabric_1].sheen_roughness_0).z);
    }
    else
    {
        through_2 = through_1;
    }
    return vec4<f32>(_S547, through_2);
}

@compute
@workgroup_size(64, 1, 1)
fn neural_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S548 : u32 = id_0.x;
    if(_S548 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S549 : Query_std430_0 = queries_0[_S548];
    answers_0[_S548] = cloth_value_0(_S549.fabric_0, vec2<f32>(_S549.centre_x_0, _S549.centre_y_0), vec2<f32>(_S549.dx_x_0, _S549.dx_y_0), vec2<f32>(_S549.dy_x_0, _S549.dy_y_0), vec3<f32>(_S549.light_x_0, _S549.light_y_0, _S549.light_z_0), vec3<f32>(_S549.view_x_0, _S549.view_y_0, _S549.view_z_0));
    return;
}

