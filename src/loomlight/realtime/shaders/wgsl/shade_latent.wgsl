struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(4) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(4) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(4) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(4) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(4) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(4) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(4) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(4) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(4) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(4) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(4) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(4) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(4) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(4) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(4) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
};

@binding(4) @group(0) var<storage, read> frames_0 : array<Frame_std430_0>;

struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(12) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(7) @group(0) var<storage, read> face_fabrics_0 : array<u32>;

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
    @align(4) frames_1 : u32,
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
    @align(4) width_1 : f32,
    @align(4) height_1 : f32,
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
    @align(4) samples_1 : u32,
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
    @align(4) seed_0 : u32,
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

@binding(6) @group(0) var<storage, read> corners_0 : array<u32>;

struct Vertex_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) z_0 : f32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) u_0 : f32,
    @align(4) v_0 : f32,
};

@binding(5) @group(0) var<storage, read> vertices_0 : array<Vertex_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(10) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;

@binding(13) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(11) @group(0) var<storage, read> scene_words_0 : array<u32>;

struct Light_std430_0
{
    @align(4) is_point_0 : u32,
    @align(4) x_1 : f32,
    @align(4) y_1 : f32,
    @align(4) z_1 : f32,
    @align(4) red_0 : f32,
    @align(4) green_0 : f32,
    @align(4) blue_0 : f32,
};

@binding(3) @group(0) var<storage, read> lights_1 : array<Light_std430_0>;

@binding(8) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

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

fn Relu_apply_0( x_2 : f32) -> f32
{
    return max(x_2, 0.0f);
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

fn Identity_apply_0( x_3 : f32) -> f32
{
    return x_3;
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

fn position_of_0( vertex_0 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_0).x_0, (*vertex_0).y_0, (*vertex_0).z_0);
}

fn position_of_1( vertex_1 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_1).x_0, (*vertex_1).y_0, (*vertex_1).z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_2 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_2).normal_x_0, (*vertex_2).normal_y_0, (*vertex_2).normal_z_0);
}

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
     view_1 : vec3<f32>,
     axis_x_0 : vec3<f32>,
     axis_y_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     uv_0 : vec2<f32>,
     draft_per_uv_0 : vec2<f32>,
     draft_0 : vec2<f32>,
     draft_dx_0 : vec2<f32>,
     draft_dy_0 : vec2<f32>,
};

fn to_local_0( point_0 : VisiblePoint_0,  direction_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S161 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S162 : u32 = ((((_S161 >> ((((_S161 >> (u32(28)))) + u32(4))))) ^ (_S161))) * u32(277803737);
    return (((_S162 >> (u32(22)))) ^ (_S162));
}

fn hash_key_0( thread_0 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_0 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_0 : u32) -> u32
{
    return scramble_0(cell_0 + key_0);
}

fn uniform_hash_0( thread_1 : u32,  cell_1 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_1)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_0 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S163 : u32 = pixel_0.x;
    var _S164 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S163, _S164, stream_2), uniform_hash_0(_S163, _S164, stream_2 + u32(1))) + vec2<f32>(f32((index_0 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S165 : vec2<f32> = direction_1.xy;
    var _S166 : f32;
    if(back_2)
    {
        _S166 = - direction_1.z;
    }
    else
    {
        _S166 = direction_1.z;
    }
    return vec3<f32>(_S165, _S166);
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S167 : u32 = (bitcast<u32>((x_4)));
    var exponent_0 : f32 = f32(i32((_S167 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S167 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S168 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S168 - exponent_1 * 0.00021219444170129f - 0.5f * _S168) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_5 : f32) -> f32
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
}

fn no_numbers_0() -> Eight_0
{
    var numbers_1 : Eight_0;
    var _S169 : vec4<f32> = vec4<f32>(0.0f);
    numbers_1.low_0 = _S169;
    numbers_1.high_0 = _S169;
    return numbers_1;
}

fn within_repeat_0( uv_1 : vec2<f32>) -> vec2<f32>
{
    return clamp(fract(uv_1), vec2<f32>(0.0f), vec2<f32>(1.0f));
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
    var _S170 : u32 = first_24 + texel_0 * elements_1;
    var _S171 : vec4<u32> = packed_numbers_0[_S170];
    if(elements_1 == u32(1))
    {
        return eight_halves_0(_S171);
    }
    var numbers_3 : Eight_0;
    numbers_3.low_0 = (bitcast<vec4<f32>>((_S171)));
    numbers_3.high_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S170 + u32(1)])));
    return numbers_3;
}

fn add_bilinear_0( first_25 : u32,  elements_2 : u32,  start_0 : u32,  columns_1 : u32,  rows_1 : u32,  uv_2 : vec2<f32>,  weight_0 : f32,  sums_6 : ptr<function, Eight_0>)
{
    var _S172 : vec2<f32> = uv_2 * vec2<f32>(f32(columns_1), f32(rows_1)) - vec2<f32>(0.5f);
    var _S173 : vec2<f32> = floor(_S172);
    var _S174 : vec2<f32> = _S172 - _S173;
    var _S175 : i32 = i32(_S173.x);
    var _S176 : i32 = i32(_S173.y);
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
        var _S177 : u32 = (tap_0 & (u32(1)));
        var _S178 : u32 = (tap_0 >> (u32(1)));
        var _S179 : Eight_0 = texel_numbers_0(first_25, elements_2, start_0 + ((u32(_S176 + i32(_S178)) & ((rows_1 - u32(1))))) * columns_1 + ((u32(_S175 + i32(_S177)) & ((columns_1 - u32(1))))));
        var _S180 : f32;
        if(_S178 != u32(0))
        {
            _S180 = _S174.y;
        }
        else
        {
            _S180 = 1.0f - _S174.y;
        }
        var _S181 : f32;
        if(_S177 != u32(0))
        {
            _S181 = _S174.x;
        }
        else
        {
            _S181 = 1.0f - _S174.x;
        }
        var _S182 : vec4<f32> = vec4<f32>((_S180 * _S181 * weight_0));
        (*sums_6).low_0 = (*sums_6).low_0 + _S182 * _S179.low_0;
        (*sums_6).high_0 = (*sums_6).high_0 + _S182 * _S179.high_0;
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

fn TexelPyramid_add_level_0( this_4 : TexelPyramid_0,  place_0 : vec2<f32>,  level_0 : u32,  face_1 : u32,  weight_1 : f32,  sums_7 : ptr<function, Eight_0>)
{
    var _S183 : u32 = this_4.levels_4 + u32(3) * level_0;
    add_bilinear_0(this_4.first_26, this_4.elements_3, face_1 * this_4.face_texels_2 + words_0[_S183], words_0[_S183 + u32(1)], words_0[_S183 + u32(2)], place_0, weight_1, &((*sums_7)));
    return;
}

fn TexelPyramid_between_levels_0( this_5 : TexelPyramid_0,  uv_3 : vec2<f32>,  level_1 : f32,  face_2 : u32) -> Eight_0
{
    var _S184 : f32 = clamp(level_1, 0.0f, this_5.last_level_3);
    var _S185 : f32 = clamp(floor(_S184), 0.0f, max(this_5.last_level_3 - 1.0f, 0.0f));
    var _S186 : f32 = _S184 - _S185;
    var _S187 : vec2<f32> = within_repeat_0(uv_3);
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
        var _S188 : f32;
        if(offset_2 == u32(0))
        {
            _S188 = 1.0f - _S186;
        }
        else
        {
            _S188 = _S186;
        }
        if(_S188 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S187, u32(_S185) + offset_2, face_2, _S188, &(texel_1));
        }
        offset_2 = offset_2 + u32(1);
    }
    return texel_1;
}

fn TexelPyramid_of_level_0( this_6 : TexelPyramid_0,  uv_4 : vec2<f32>,  level_2 : u32,  face_3 : u32) -> Eight_0
{
    var texel_2 : Eight_0 = no_numbers_0();
    TexelPyramid_add_level_0(this_6, within_repeat_0(uv_4), level_2, face_3, 1.0f, &(texel_2));
    return texel_2;
}

fn channel_0( numbers_4 : Eight_0,  k_0 : i32) -> f32
{
    var _S189 : f32;
    if(k_0 < i32(4))
    {
        _S189 = numbers_4.low_0[k_0];
    }
    else
    {
        _S189 = numbers_4.high_0[k_0 - i32(4)];
    }
    return _S189;
}

struct LatentFrame_0
{
     tangent_0 : vec3<f32>,
     bitangent_0 : vec3<f32>,
     normal_1 : vec3<f32>,
};

fn frame_of_0( normal_2 : vec3<f32>,  tangent_1 : vec3<f32>) -> LatentFrame_0
{
    var result_0 : LatentFrame_0;
    var _S190 : vec3<f32> = normalize(normal_2 + vec3<f32>(0.0f, 0.0f, 1.0f));
    result_0.normal_1 = _S190;
    var _S191 : vec3<f32> = normalize(tangent_1 + vec3<f32>(1.0f, 0.0f, 0.0f));
    result_0.tangent_0 = _S191;
    result_0.bitangent_0 = cross(_S190, _S191);
    return result_0;
}

fn scene_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_1])));
}

struct Choice_0
{
     index_2 : u32,
     remainder_0 : f32,
};

fn choose_0( table_0 : u32,  count_0 : u32,  number_0 : f32) -> Choice_0
{
    var high_6 : u32 = count_0;
    var low_6 : u32 = u32(0);
    for(;;)
    {
        if((high_6 - low_6) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S192 : u32 = (low_6 + high_6) / u32(2);
        if((scene_number_0(table_0 + _S192)) <= number_0)
        {
            low_6 = _S192;
        }
        else
        {
            high_6 = _S192;
        }
    }
    var _S193 : u32 = table_0 + low_6;
    var _S194 : f32 = scene_number_0(_S193);
    var _S195 : f32 = scene_number_0(_S193 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_2 = low_6;
    choice_0.remainder_0 = saturate((number_0 - _S194) / max(_S195 - _S194, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_6 : f32) -> vec2<f32>
{
    var _S196 : f32 = floor(x_6 * 0.63661974668502808f + 0.5f);
    var _S197 : f32 = x_6 - _S196 * 1.5703125f - _S196 * 0.00048375129699707f - _S196 * 7.54979012640433211e-08f;
    var _S198 : f32 = _S197 * _S197;
    var _S199 : f32 = ((-0.00019515295571182f * _S198 + 0.00833216123282909f) * _S198 - 0.16666655242443085f) * _S198 * _S197 + _S197;
    var _S200 : f32 = ((0.00002443315679557f * _S198 - 0.00138873164542019f) * _S198 + 0.04166664555668831f) * _S198 * _S198 - 0.5f * _S198 + 1.0f;
    var _S201 : u32 = (u32(i32(_S196)) & (u32(3)));
    var _S202 : vec2<f32>;
    if(((_S201 & (u32(1)))) != u32(0))
    {
        _S202 = vec2<f32>(_S200, _S199);
    }
    else
    {
        _S202 = vec2<f32>(_S199, _S200);
    }
    var _S203 : f32;
    if(((_S201 & (u32(2)))) != u32(0))
    {
        _S203 = - _S202.x;
    }
    else
    {
        _S203 = _S202.x;
    }
    var _S204 : f32;
    if((((_S201 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S204 = - _S202.y;
    }
    else
    {
        _S204 = _S202.y;
    }
    return vec2<f32>(_S203, _S204);
}

fn LatentFrame_coordinates_0( this_7 : LatentFrame_0,  direction_2 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_2, this_7.tangent_0), dot(direction_2, this_7.bitangent_0), dot(direction_2, this_7.normal_1));
}

fn exponential_0( x_7 : f32) -> f32
{
    var _S205 : f32 = clamp(x_7, -87.0f, 88.0f);
    var _S206 : f32 = floor(_S205 * 1.4426950216293335f + 0.5f);
    var _S207 : f32 = _S205 - _S206 * 0.693359375f + _S206 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S207 + 0.00139819993637502f) * _S207 + 0.00833345204591751f) * _S207 + 0.04166579619050026f) * _S207 + 0.1666666567325592f) * _S207 + 0.5f;
    var _S208 : f32 = (bitcast<f32>(((u32(i32(_S206) + i32(127)) << (u32(23))))));
    var _S209 : f32;
    if(x_7 < -87.0f)
    {
        _S209 = 0.0f;
    }
    else
    {
        _S209 = (p_0 * _S207 * _S207 + _S207 + 1.0f) * _S208;
    }
    return _S209;
}

fn bounded_exponential_0( exponent_3 : f32) -> f32
{
    return exponential_0(min(exponent_3, 12.0f));
}

fn accumulate_0( index_3 : u32,  light_1 : vec4<f32>)
{
    var _S210 : f32 = layers_0[index_3].share_0;
    radiance_0[index_3] = radiance_0[index_3] + vec4<f32>(layers_0[index_3].share_0) * light_1;
    layers_0[index_3].share_0 = _S210 * (1.0f - light_1.w);
    return;
}

fn camera_right_0( _S211 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S211].right_x_0, frames_0[_S211].right_y_0, frames_0[_S211].right_z_0);
}

fn camera_up_0( _S212 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S212].up_x_0, frames_0[_S212].up_y_0, frames_0[_S212].up_z_0);
}

fn camera_forward_0( _S213 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S213].forward_x_0, frames_0[_S213].forward_y_0, frames_0[_S213].forward_z_0);
}

fn camera_origin_0( _S214 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S214].origin_x_0, frames_0[_S214].origin_y_0, frames_0[_S214].origin_z_0);
}

fn face_point_0( _S215 : u32,  _S216 : u32,  _S217 : f32,  _S218 : f32) -> VisiblePoint_0
{
    var _S219 : u32 = u32(3) * _S216;
    var _S220 : Vertex_std430_0 = vertices_0[corners_0[_S219]];
    var _S221 : Vertex_std430_0 = vertices_0[corners_0[_S219 + u32(1)]];
    var _S222 : Vertex_std430_0 = vertices_0[corners_0[_S219 + u32(2)]];
    var _S223 : vec3<f32> = position_of_0(&(_S221));
    var _S224 : vec3<f32> = position_of_0(&(_S220));
    var _S225 : vec3<f32> = _S223 - _S224;
    var _S226 : vec3<f32> = position_of_0(&(_S222));
    var _S227 : vec3<f32> = _S226 - _S224;
    var _S228 : f32 = _S220.u_0;
    var _S229 : f32 = _S221.u_0 - _S220.u_0;
    var _S230 : f32 = _S220.v_0;
    var _S231 : f32 = _S221.v_0 - _S220.v_0;
    var _S232 : vec2<f32> = vec2<f32>(_S229, _S231);
    var _S233 : f32 = _S222.u_0 - _S220.u_0;
    var _S234 : f32 = _S222.v_0 - _S220.v_0;
    var _S235 : vec2<f32> = vec2<f32>(_S233, _S234);
    var _S236 : f32;
    if((_S229 * _S234 - _S231 * _S233) < 0.0f)
    {
        _S236 = -1.0f;
    }
    else
    {
        _S236 = 1.0f;
    }
    var _S237 : vec3<f32> = vec3<f32>(_S236) * (vec3<f32>(_S234) * _S225 - vec3<f32>(_S231) * _S227);
    var _S238 : vec3<f32> = vec3<f32>(_S236) * (vec3<f32>(_S229) * _S227 - vec3<f32>(_S233) * _S225);
    var point_1 : VisiblePoint_0;
    var _S239 : f32 = 1.0f - _S217 - _S218;
    var _S240 : vec3<f32> = normal_of_0(&(_S220));
    var _S241 : vec3<f32> = vec3<f32>(_S239) * _S240;
    var _S242 : vec3<f32> = normal_of_0(&(_S221));
    var _S243 : vec3<f32> = vec3<f32>(_S217);
    var _S244 : vec3<f32> = _S241 + _S243 * _S242;
    var _S245 : vec3<f32> = normal_of_0(&(_S222));
    var _S246 : vec3<f32> = vec3<f32>(_S218);
    var _S247 : vec3<f32> = normalize(_S244 + _S246 * _S245);
    point_1.normal_0 = _S247;
    var _S248 : vec3<f32> = normalize(_S237 - _S247 * vec3<f32>(dot(_S247, _S237)));
    point_1.axis_x_0 = _S248;
    point_1.axis_y_0 = cross(_S247, _S248);
    var _S249 : vec3<f32> = normalize(cross(_S225, _S227));
    var _S250 : vec3<f32>;
    if((dot(_S249, _S247)) < 0.0f)
    {
        _S250 = (vec3<f32>(0) - _S249);
    }
    else
    {
        _S250 = _S249;
    }
    point_1.face_normal_0 = _S250;
    point_1.position_0 = _S224 + _S243 * _S225 + _S246 * _S227;
    point_1.view_1 = point_1.normal_0;
    point_1.uv_0 = vec2<f32>(_S228, _S230) + vec2<f32>(_S217) * _S232 + vec2<f32>(_S218) * _S235;
    var _S251 : bool = (dot(cross(_S237, _S238), point_1.normal_0)) < 0.0f;
    var _S252 : f32 = fabrics_0[_S215].uv_width_0;
    if(_S251)
    {
        _S236 = - fabrics_0[_S215].uv_height_0;
    }
    else
    {
        _S236 = fabrics_0[_S215].uv_height_0;
    }
    var _S253 : vec2<f32> = vec2<f32>(_S252, _S236);
    point_1.draft_per_uv_0 = _S253;
    var _S254 : vec2<f32> = point_1.uv_0 * _S253;
    if(_S251)
    {
        _S236 = fabrics_0[_S215].uv_height_0;
    }
    else
    {
        _S236 = 0.0f;
    }
    point_1.draft_0 = _S254 + vec2<f32>(0.0f, _S236);
    var _S255 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S255;
    point_1.draft_dy_0 = _S255;
    return point_1;
}

fn visible_point_0( _S256 : i32,  _S257 : u32,  _S258 : u32,  _S259 : vec2<u32>) -> VisiblePoint_0
{
    var _S260 : u32 = u32(3) * _S258;
    var _S261 : Vertex_std430_0 = vertices_0[corners_0[_S260]];
    var _S262 : Vertex_std430_0 = vertices_0[corners_0[_S260 + u32(1)]];
    var _S263 : Vertex_std430_0 = vertices_0[corners_0[_S260 + u32(2)]];
    var _S264 : vec3<f32> = position_of_1(&(_S262));
    var _S265 : vec3<f32> = position_of_1(&(_S261));
    var _S266 : vec3<f32> = _S264 - _S265;
    var _S267 : vec3<f32> = position_of_1(&(_S263));
    var _S268 : vec3<f32> = _S267 - _S265;
    var _S269 : vec3<f32> = cross(_S266, _S268);
    var _S270 : f32 = 1.0f / max(square_0(_S269), 1.00000000317107685e-30f);
    var _S271 : f32 = f32(frames_0[_S256].width_0);
    var _S272 : vec3<f32> = camera_right_0(_S256) * vec3<f32>((2.0f / _S271));
    var _S273 : f32 = f32(frames_0[_S256].height_0);
    var _S274 : vec3<f32> = camera_up_0(_S256) * vec3<f32>((-2.0f / _S273));
    var _S275 : vec3<f32> = camera_forward_0(_S256) + vec3<f32>((f32(_S259.x) + 0.5f - 0.5f * _S271)) * _S272 + vec3<f32>((f32(_S259.y) + 0.5f - 0.5f * _S273)) * _S274;
    var _S276 : f32 = dot(_S275, _S269);
    var _S277 : f32;
    if((abs(_S276)) > 1.00000000317107685e-30f)
    {
        _S277 = _S276;
    }
    else
    {
        _S277 = 1.00000000317107685e-30f;
    }
    var _S278 : f32 = 1.0f / _S277;
    var _S279 : vec3<f32> = _S265 - camera_origin_0(_S256);
    var _S280 : vec3<f32> = vec3<f32>((dot(_S279, _S269) * _S278));
    var _S281 : vec3<f32> = _S275 * _S280 - _S279;
    var _S282 : vec3<f32> = _S280 * (_S272 - _S275 * vec3<f32>((dot(_S272, _S269) * _S278)));
    var _S283 : vec3<f32> = _S280 * (_S274 - _S275 * vec3<f32>((dot(_S274, _S269) * _S278)));
    var _S284 : vec3<f32> = vec3<f32>(_S270);
    var _S285 : vec3<f32> = cross(_S268, _S269) * _S284;
    var _S286 : vec3<f32> = cross(_S269, _S266) * _S284;
    var _S287 : vec2<f32> = vec2<f32>(_S262.u_0 - _S261.u_0, _S262.v_0 - _S261.v_0);
    var _S288 : vec2<f32> = vec2<f32>(_S263.u_0 - _S261.u_0, _S263.v_0 - _S261.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S257, _S258, dot(_S281, _S285), dot(_S281, _S286));
    point_2.position_0 = _S265 + _S281;
    point_2.view_1 = (vec3<f32>(0) - normalize(_S275));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S282, _S285)) * _S287 + vec2<f32>(dot(_S282, _S286)) * _S288) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S283, _S285)) * _S287 + vec2<f32>(dot(_S283, _S286)) * _S288) * point_2.draft_per_uv_0;
    return point_2;
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

struct LatentView_0
{
     latent_1 : array<f32, i32(8)>,
     first_27 : LatentFrame_0,
     second_0 : LatentFrame_0,
     view_2 : vec3<f32>,
     back_3 : bool,
};

fn latent_view_0( _S289 : u32,  _S290 : Footprint_0,  _S291 : vec3<f32>,  _S292 : f32,  _S293 : ptr<function, LatentView_0>)
{
    var _S294 : Latent_std430_0 = fabrics_0[_S289].latent_0;
    var _S295 : bool = (_S291.z) < 0.0f;
    (*_S293).back_3 = _S295;
    (*_S293).view_2 = to_face_frame_0(_S291, _S295);
    var _S296 : u32;
    if(_S295)
    {
        _S296 = _S294.back_1;
    }
    else
    {
        _S296 = u32(0);
    }
    var _S297 : vec2<f32> = _S290.centre_0 * vec2<f32>(_S294.repeats_per_x_1, _S294.repeats_per_y_1);
    var _S298 : f32 = clamp(binary_logarithm_0(max(sqrt(abs(_S290.dx_0.x * _S290.dy_0.y - _S290.dx_0.y * _S290.dy_0.x)) * _S294.texels_per_mm_1, 9.99999971718068537e-10f)), 0.0f, _S294.last_level_2);
    var pyramid_0 : TexelPyramid_0;
    pyramid_0.first_26 = _S294.texels_1;
    pyramid_0.elements_3 = _S294.texel_elements_1;
    pyramid_0.levels_4 = _S294.levels_3;
    pyramid_0.last_level_3 = _S294.last_level_2;
    pyramid_0.face_texels_2 = _S294.face_texels_1;
    var texel_3 : Eight_0;
    if((_S294.is_trilinear_0) != u32(0))
    {
        texel_3 = TexelPyramid_between_levels_0(pyramid_0, _S297, _S298, _S296);
    }
    else
    {
        var _S299 : TexelPyramid_0 = pyramid_0;
        var _S300 : u32 = u32(_S298);
        var _S301 : u32;
        if(_S292 < (_S298 - floor(_S298)))
        {
            _S301 = u32(1);
        }
        else
        {
            _S301 = u32(0);
        }
        texel_3 = TexelPyramid_of_level_0(_S299, _S297, _S300 + _S301, _S296);
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
        (*_S293).latent_1[k_1] = channel_0(texel_3, k_1);
        k_1 = k_1 + i32(1);
    }
    var weights_26 : FloatWeights_0;
    weights_26.first_0 = _S294.frames_1;
    var _S302 : array<f32, i32(8)> = (*_S293).latent_1;
    var sums_8 : array<f32, i32(12)>;
    dense_9(weights_26, u32(0), false, &(_S302), &(sums_8));
    (*_S293).latent_1 = _S302;
    (*_S293).first_27 = frame_of_0(vec3<f32>(sums_8[i32(0)], sums_8[i32(1)], sums_8[i32(2)]), vec3<f32>(sums_8[i32(3)], sums_8[i32(4)], sums_8[i32(5)]));
    (*_S293).second_0 = frame_of_0(vec3<f32>(sums_8[i32(6)], sums_8[i32(7)], sums_8[i32(8)]), vec3<f32>(sums_8[i32(9)], sums_8[i32(10)], sums_8[i32(11)]));
    return;
}

fn light_sample_count_0( _S303 : i32) -> u32
{
    return frames_0[_S303].lights_0 + frames_0[_S303].environment_samples_0;
}

fn visibility_at_0( _S304 : i32,  _S305 : u32,  _S306 : vec2<u32>) -> f32
{
    if((frames_0[_S304].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S305 * frames_0[_S304].height_0 + _S306.y) * frames_0[_S304].width_0 + _S306.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_0 : f32,
};

fn environment_texel_0( _S307 : i32,  _S308 : u32,  _S309 : u32) -> vec3<f32>
{
    var _S310 : u32 = frames_0[_S307].environment_table_0 + frames_0[_S307].environment_rows_0 + u32(1) + frames_0[_S307].environment_rows_0 * (frames_0[_S307].environment_columns_0 + u32(1)) + u32(3) * (_S308 * frames_0[_S307].environment_columns_0 + _S309);
    return vec3<f32>(scene_number_0(_S310), scene_number_0(_S310 + u32(1)), scene_number_0(_S310 + u32(2)));
}

fn sample_environment_0( _S311 : i32,  _S312 : vec2<f32>,  _S313 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S314 : u32 = frames_0[_S311].environment_rows_0;
    var _S315 : Choice_0 = choose_0(frames_0[_S311].environment_table_0, frames_0[_S311].environment_rows_0, _S312.y);
    var _S316 : u32 = frames_0[_S311].environment_columns_0;
    var _S317 : Choice_0 = choose_0(frames_0[_S311].environment_table_0 + frames_0[_S311].environment_rows_0 + u32(1) + _S315.index_2 * (frames_0[_S311].environment_columns_0 + u32(1)), frames_0[_S311].environment_columns_0, _S312.x);
    var _S318 : vec3<f32> = environment_texel_0(_S311, _S315.index_2, _S317.index_2);
    (*_S313) = _S318 * vec3<f32>((frames_0[_S311].environment_total_0 / max(mean_0(_S318), 9.99999968265522539e-21f)));
    var _S319 : f32 = 3.14159274101257324f / f32(_S314);
    var _S320 : f32 = mix(sine_cosine_0(f32(_S315.index_2) * _S319).y, sine_cosine_0(f32(_S315.index_2 + u32(1)) * _S319).y, _S315.remainder_0);
    var _S321 : f32 = sqrt(max(1.0f - _S320 * _S320, 0.0f));
    var _S322 : vec2<f32> = sine_cosine_0((f32(_S317.index_2) + _S317.remainder_0) * (6.28318548202514648f / f32(_S316)));
    var _S323 : f32 = _S321 * _S322.x;
    var _S324 : f32 = - _S321 * _S322.y;
    return vec3<f32>(frames_0[_S311].environment_cosine_0 * _S323 + frames_0[_S311].environment_sine_0 * _S324, _S320, frames_0[_S311].environment_cosine_0 * _S324 - frames_0[_S311].environment_sine_0 * _S323);
}

fn light_sample_0( _S325 : i32,  _S326 : u32,  _S327 : vec2<u32>,  _S328 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    var _S329 : u32 = frames_0[_S325].lights_0;
    if(_S326 >= (frames_0[_S325].lights_0))
    {
        var weight_2 : vec3<f32>;
        var _S330 : vec3<f32> = sample_environment_0(_S325, pixel_sequence_0(_S327, frames_0[_S325].pass_number_0 * frames_0[_S325].environment_samples_0 + (_S326 - _S329), u32(3)), &(weight_2));
        sample_0.towards_0 = _S330;
        sample_0.irradiance_1 = weight_2 / vec3<f32>(f32(frames_0[_S325].environment_samples_0));
        return sample_0;
    }
    var _S331 : Light_std430_0 = lights_1[_S326];
    sample_0.irradiance_1 = vec3<f32>(_S331.red_0, _S331.green_0, _S331.blue_0);
    sample_0.towards_0 = vec3<f32>(_S331.x_1, _S331.y_1, _S331.z_1);
    if((_S331.is_point_0) != u32(0))
    {
        var _S332 : vec3<f32> = sample_0.towards_0 - _S328;
        var _S333 : f32 = max(square_0(_S332), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S333);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S333);
        sample_0.towards_0 = normalize(_S332);
    }
    return sample_0;
}

fn latent_value_0( _S334 : u32,  _S335 : ptr<function, LatentView_0>,  _S336 : vec3<f32>) -> vec3<f32>
{
    var _S337 : vec3<f32> = to_face_frame_0(_S336, (*_S335).back_3);
    if((_S337.z) <= 0.0f)
    {
        return vec3<f32>(0.0f);
    }
    var inputs_32 : array<f32, i32(20)>;
    var _S338 : vec3<f32> = LatentFrame_coordinates_0((*_S335).first_27, (*_S335).view_2);
    var _S339 : vec3<f32> = LatentFrame_coordinates_0((*_S335).first_27, _S337);
    var _S340 : vec3<f32> = LatentFrame_coordinates_0((*_S335).second_0, (*_S335).view_2);
    var _S341 : vec3<f32> = LatentFrame_coordinates_0((*_S335).second_0, _S337);
    var axis_0 : i32 = i32(0);
    for(;;)
    {
        if(axis_0 < i32(3))
        {
        }
        else
        {
            break;
        }
        inputs_32[axis_0] = _S338[axis_0];
        inputs_32[i32(3) + axis_0] = _S339[axis_0];
        inputs_32[i32(6) + axis_0] = _S340[axis_0];
        inputs_32[i32(9) + axis_0] = _S341[axis_0];
        axis_0 = axis_0 + i32(1);
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
        inputs_32[i32(12) + k_2] = (*_S335).latent_1[k_2];
        k_2 = k_2 + i32(1);
    }
    var outputs_27 : array<f32, i32(3)>;
    var _S342 : Latent_std430_0 = fabrics_0[_S334].latent_0;
    if((fabrics_0[_S334].latent_0.hidden_0) == u32(16))
    {
        decode_2(_S342.decoder_1, &(inputs_32), &(outputs_27));
    }
    else
    {
        if((_S342.hidden_0) == u32(32))
        {
            decode_1(_S342.decoder_1, &(inputs_32), &(outputs_27));
        }
        else
        {
            decode_0(_S342.decoder_1, &(inputs_32), &(outputs_27));
        }
    }
    return vec3<f32>(bounded_exponential_0(outputs_27[i32(0)] - 3.0f), bounded_exponential_0(outputs_27[i32(1)] - 3.0f), bounded_exponential_0(outputs_27[i32(2)] - 3.0f));
}

fn light_of_latent_0( _S343 : i32,  _S344 : u32,  _S345 : VisiblePoint_0,  _S346 : vec2<u32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S345.draft_0;
    footprint_0.dx_0 = _S345.draft_dx_0;
    footprint_0.dy_0 = _S345.draft_dy_0;
    var seen_0 : LatentView_0;
    latent_view_0(_S344, footprint_0, to_local_0(_S345, _S345.view_1), pixel_sequence_0(_S346, frames_0[_S343].pass_number_0, u32(1)).x, &(seen_0));
    var _S347 : vec3<f32> = vec3<f32>(0.0f);
    var number_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S347;
    for(;;)
    {
        if(number_1 < (light_sample_count_0(_S343)))
        {
        }
        else
        {
            break;
        }
        var _S348 : f32 = visibility_at_0(_S343, number_1, _S346);
        if(_S348 <= 0.0f)
        {
            number_1 = number_1 + u32(1);
            continue;
        }
        var _S349 : LightSample_0 = light_sample_0(_S343, number_1, _S346, _S345.position_0);
        var _S350 : vec3<f32> = vec3<f32>(_S348) * _S349.irradiance_1;
        var _S351 : vec3<f32> = latent_value_0(_S344, &(seen_0), to_local_0(_S345, _S349.towards_0));
        radiance_1 = radiance_1 + _S350 * _S351;
        number_1 = number_1 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_latent(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S352 : u32 = id_0.x;
    var _S353 : u32 = frames_0[i32(0)].width_0;
    var _S354 : bool;
    if(_S352 >= (frames_0[i32(0)].width_0))
    {
        _S354 = true;
    }
    else
    {
        _S354 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S354)
    {
        return;
    }
    var _S355 : u32 = id_0.y * _S353 + _S352;
    var _S356 : u32 = layers_0[_S355].face_0;
    if((layers_0[_S355].face_0) == u32(0))
    {
        return;
    }
    var _S357 : u32 = _S356 - u32(1);
    var _S358 : u32 = face_fabrics_0[_S357];
    var _S359 : vec2<u32> = id_0.xy;
    accumulate_0(_S355, light_of_latent_0(i32(0), _S358, visible_point_0(i32(0), _S358, _S357, _S359), _S359));
    return;
}

