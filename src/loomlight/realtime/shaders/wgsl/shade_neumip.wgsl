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

struct Woven_std430_0
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
};

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) woven_0 : Woven_std430_0,
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
    @align(4) uv_width_0 : f32,
    @align(4) uv_height_0 : f32,
    @align(4) is_open_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
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

fn tile_product_0( weights_0 : FloatWeights_0,  row_0 : u32,  inputs_0 : ptr<function, array<f32, i32(25)>>) -> vec4<f32>
{
    var sums_0 : vec4<f32> = vec4<f32>(0.0f);
    var column_0 : u32 = u32(0);
    for(;;)
    {
        if(column_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var low_1 : vec4<f32>;
        var high_1 : vec4<f32>;
        var _S2 : i32 = i32(u32(8) * column_0);
        low_1[i32(0)] = (*inputs_0)[min(_S2, i32(24))];
        high_1[i32(0)] = (*inputs_0)[min(_S2 + i32(4), i32(24))];
        var _S3 : i32 = _S2 + i32(1);
        low_1[i32(1)] = (*inputs_0)[min(_S3, i32(24))];
        high_1[i32(1)] = (*inputs_0)[min(_S3 + i32(4), i32(24))];
        var _S4 : i32 = _S2 + i32(2);
        low_1[i32(2)] = (*inputs_0)[min(_S4, i32(24))];
        high_1[i32(2)] = (*inputs_0)[min(_S4 + i32(4), i32(24))];
        var _S5 : i32 = _S2 + i32(3);
        low_1[i32(3)] = (*inputs_0)[min(_S5, i32(24))];
        high_1[i32(3)] = (*inputs_0)[min(_S5 + i32(4), i32(24))];
        var _S6 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_0[i32(0)] = sums_0[i32(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        var _S7 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(4) + column_0);
        sums_0[i32(1)] = sums_0[i32(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        var _S8 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(8) + column_0);
        sums_0[i32(2)] = sums_0[i32(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        var _S9 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(12) + column_0);
        sums_0[i32(3)] = sums_0[i32(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + u32(1);
    }
    return sums_0;
}

fn Identity_apply_0( x_2 : f32) -> f32
{
    return x_2;
}

fn dense_part_0( weights_1 : FloatWeights_0,  first_1 : u32,  adds_0 : bool,  inputs_1 : ptr<function, array<f32, i32(25)>>,  outputs_0 : ptr<function, array<f32, i32(3)>>)
{
    var _S10 : u32 = first_1 + u32(whole_parts_0(i32(1)));
    var output_0 : i32 = i32(0);
    for(;;)
    {
        var _S11 : bool = output_0 < i32(3);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        var _S12 : u32 = u32(output_0);
        var _S13 : Eight_0 = FloatWeights_eight_0(weights_1, first_1 + _S12 / u32(8));
        var _S14 : vec4<f32> = tile_product_0(weights_1, _S10 + _S12 * u32(4), &((*inputs_1)));
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
        if(_S18 < i32(3))
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
        if(_S19 < i32(3))
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
        if(_S20 < i32(3))
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

fn tile_product_1( weights_2 : FloatWeights_0,  row_1 : u32,  inputs_2 : ptr<function, array<f32, i32(11)>>) -> vec4<f32>
{
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
    var column_1 : u32 = u32(0);
    for(;;)
    {
        if(column_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var low_2 : vec4<f32>;
        var high_2 : vec4<f32>;
        var _S21 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_2)[min(_S21, i32(10))];
        high_2[i32(0)] = (*inputs_2)[min(_S21 + i32(4), i32(10))];
        var _S22 : i32 = _S21 + i32(1);
        low_2[i32(1)] = (*inputs_2)[min(_S22, i32(10))];
        high_2[i32(1)] = (*inputs_2)[min(_S22 + i32(4), i32(10))];
        var _S23 : i32 = _S21 + i32(2);
        low_2[i32(2)] = (*inputs_2)[min(_S23, i32(10))];
        high_2[i32(2)] = (*inputs_2)[min(_S23 + i32(4), i32(10))];
        var _S24 : i32 = _S21 + i32(3);
        low_2[i32(3)] = (*inputs_2)[min(_S24, i32(10))];
        high_2[i32(3)] = (*inputs_2)[min(_S24 + i32(4), i32(10))];
        var _S25 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + column_1);
        sums_1[i32(0)] = sums_1[i32(0)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        var _S26 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + u32(2) + column_1);
        sums_1[i32(1)] = sums_1[i32(1)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        var _S27 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + u32(4) + column_1);
        sums_1[i32(2)] = sums_1[i32(2)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        var _S28 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + u32(6) + column_1);
        sums_1[i32(3)] = sums_1[i32(3)] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_1;
}

fn Relu_apply_0( x_3 : f32) -> f32
{
    return max(x_3, 0.0f);
}

fn dense_part_1( weights_3 : FloatWeights_0,  first_2 : u32,  adds_1 : bool,  inputs_3 : ptr<function, array<f32, i32(11)>>,  outputs_1 : ptr<function, array<f32, i32(25)>>)
{
    var _S29 : u32 = first_2 + u32(whole_parts_0(i32(4)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S30 : bool = output_1 < i32(25);
        if(_S30)
        {
        }
        else
        {
            break;
        }
        var _S31 : u32 = u32(output_1);
        var _S32 : Eight_0 = FloatWeights_eight_0(weights_3, first_2 + _S31 / u32(8));
        var _S33 : vec4<f32> = tile_product_1(weights_3, _S29 + _S31 * u32(2), &((*inputs_3)));
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
            (*outputs_1)[output_1] = Relu_apply_0(_S35[i32(0)] + _S36);
        }
        var _S37 : i32 = output_1 + i32(1);
        if(_S37 < i32(25))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S37];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S37] = Relu_apply_0(_S35[i32(1)] + _S36);
        }
        var _S38 : i32 = output_1 + i32(2);
        if(_S38 < i32(25))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S38];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S38] = Relu_apply_0(_S35[i32(2)] + _S36);
        }
        var _S39 : i32 = output_1 + i32(3);
        if(_S39 < i32(25))
        {
            if(adds_1)
            {
                _S36 = (*outputs_1)[_S39];
            }
            else
            {
                _S36 = 0.0f;
            }
            (*outputs_1)[_S39] = Relu_apply_0(_S35[i32(3)] + _S36);
        }
        output_1 = output_1 + i32(4);
    }
    return;
}

fn dense_0( weights_4 : FloatWeights_0,  first_3 : u32,  adds_2 : bool,  inputs_4 : ptr<function, array<f32, i32(25)>>,  outputs_2 : ptr<function, array<f32, i32(3)>>)
{
    dense_part_0(weights_4, first_3, adds_2, &((*inputs_4)), &((*outputs_2)));
    return;
}

fn dense_1( weights_5 : FloatWeights_0,  first_4 : u32,  adds_3 : bool,  inputs_5 : ptr<function, array<f32, i32(11)>>,  outputs_3 : ptr<function, array<f32, i32(25)>>)
{
    dense_part_1(weights_5, first_4, adds_3, &((*inputs_5)), &((*outputs_3)));
    return;
}

fn dense_part_2( weights_6 : FloatWeights_0,  first_5 : u32,  adds_4 : bool,  inputs_6 : ptr<function, array<f32, i32(25)>>,  outputs_4 : ptr<function, array<f32, i32(25)>>)
{
    var _S40 : u32 = first_5 + u32(whole_parts_0(i32(4)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S41 : bool = output_2 < i32(25);
        if(_S41)
        {
        }
        else
        {
            break;
        }
        var _S42 : u32 = u32(output_2);
        var _S43 : Eight_0 = FloatWeights_eight_0(weights_6, first_5 + _S42 / u32(8));
        var _S44 : vec4<f32> = tile_product_0(weights_6, _S40 + _S42 * u32(4), &((*inputs_6)));
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
            if(adds_4)
            {
                _S47 = (*outputs_4)[output_2];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[output_2] = Relu_apply_0(_S46[i32(0)] + _S47);
        }
        var _S48 : i32 = output_2 + i32(1);
        if(_S48 < i32(25))
        {
            if(adds_4)
            {
                _S47 = (*outputs_4)[_S48];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[_S48] = Relu_apply_0(_S46[i32(1)] + _S47);
        }
        var _S49 : i32 = output_2 + i32(2);
        if(_S49 < i32(25))
        {
            if(adds_4)
            {
                _S47 = (*outputs_4)[_S49];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[_S49] = Relu_apply_0(_S46[i32(2)] + _S47);
        }
        var _S50 : i32 = output_2 + i32(3);
        if(_S50 < i32(25))
        {
            if(adds_4)
            {
                _S47 = (*outputs_4)[_S50];
            }
            else
            {
                _S47 = 0.0f;
            }
            (*outputs_4)[_S50] = Relu_apply_0(_S46[i32(3)] + _S47);
        }
        output_2 = output_2 + i32(4);
    }
    return;
}

fn dense_part_3( weights_7 : FloatWeights_0,  first_6 : u32,  adds_5 : bool,  inputs_7 : ptr<function, array<f32, i32(25)>>,  outputs_5 : ptr<function, array<f32, i32(1)>>)
{
    var _S51 : u32 = first_6 + u32(whole_parts_0(i32(1)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S52 : bool = output_3 < i32(1);
        if(_S52)
        {
        }
        else
        {
            break;
        }
        var _S53 : u32 = u32(output_3);
        var _S54 : Eight_0 = FloatWeights_eight_0(weights_7, first_6 + _S53 / u32(8));
        var _S55 : vec4<f32> = tile_product_0(weights_7, _S51 + _S53 * u32(4), &((*inputs_7)));
        var _S56 : vec4<f32>;
        if(((output_3 & (i32(4)))) != i32(0))
        {
            _S56 = _S54.high_0;
        }
        else
        {
            _S56 = _S54.low_0;
        }
        var _S57 : vec4<f32> = _S55 + _S56;
        var _S58 : f32;
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
            (*outputs_5)[output_3] = Identity_apply_0(_S57[i32(0)] + _S58);
        }
        var _S59 : i32 = output_3 + i32(1);
        if(_S59 < i32(1))
        {
            if(adds_5)
            {
                _S58 = (*outputs_5)[_S59];
            }
            else
            {
                _S58 = 0.0f;
            }
            (*outputs_5)[_S59] = Identity_apply_0(_S57[i32(1)] + _S58);
        }
        var _S60 : i32 = output_3 + i32(2);
        if(_S60 < i32(1))
        {
            if(adds_5)
            {
                _S58 = (*outputs_5)[_S60];
            }
            else
            {
                _S58 = 0.0f;
            }
            (*outputs_5)[_S60] = Identity_apply_0(_S57[i32(2)] + _S58);
        }
        var _S61 : i32 = output_3 + i32(3);
        if(_S61 < i32(1))
        {
            if(adds_5)
            {
                _S58 = (*outputs_5)[_S61];
            }
            else
            {
                _S58 = 0.0f;
            }
            (*outputs_5)[_S61] = Identity_apply_0(_S57[i32(3)] + _S58);
        }
        output_3 = output_3 + i32(4);
    }
    return;
}

fn tile_product_2( weights_8 : FloatWeights_0,  row_2 : u32,  inputs_8 : ptr<function, array<f32, i32(9)>>) -> vec4<f32>
{
    var sums_2 : vec4<f32> = vec4<f32>(0.0f);
    var column_2 : u32 = u32(0);
    for(;;)
    {
        if(column_2 < u32(2))
        {
        }
        else
        {
            break;
        }
        var low_3 : vec4<f32>;
        var high_3 : vec4<f32>;
        var _S62 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_8)[min(_S62, i32(8))];
        high_3[i32(0)] = (*inputs_8)[min(_S62 + i32(4), i32(8))];
        var _S63 : i32 = _S62 + i32(1);
        low_3[i32(1)] = (*inputs_8)[min(_S63, i32(8))];
        high_3[i32(1)] = (*inputs_8)[min(_S63 + i32(4), i32(8))];
        var _S64 : i32 = _S62 + i32(2);
        low_3[i32(2)] = (*inputs_8)[min(_S64, i32(8))];
        high_3[i32(2)] = (*inputs_8)[min(_S64 + i32(4), i32(8))];
        var _S65 : i32 = _S62 + i32(3);
        low_3[i32(3)] = (*inputs_8)[min(_S65, i32(8))];
        high_3[i32(3)] = (*inputs_8)[min(_S65 + i32(4), i32(8))];
        var _S66 : Eight_0 = FloatWeights_eight_0(weights_8, row_2 + column_2);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S66.low_0, low_3) + dot(_S66.high_0, high_3));
        var _S67 : Eight_0 = FloatWeights_eight_0(weights_8, row_2 + u32(2) + column_2);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S67.low_0, low_3) + dot(_S67.high_0, high_3));
        var _S68 : Eight_0 = FloatWeights_eight_0(weights_8, row_2 + u32(4) + column_2);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S68.low_0, low_3) + dot(_S68.high_0, high_3));
        var _S69 : Eight_0 = FloatWeights_eight_0(weights_8, row_2 + u32(6) + column_2);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S69.low_0, low_3) + dot(_S69.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_2;
}

fn dense_part_4( weights_9 : FloatWeights_0,  first_7 : u32,  adds_6 : bool,  inputs_9 : ptr<function, array<f32, i32(9)>>,  outputs_6 : ptr<function, array<f32, i32(25)>>)
{
    var _S70 : u32 = first_7 + u32(whole_parts_0(i32(4)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S71 : bool = output_4 < i32(25);
        if(_S71)
        {
        }
        else
        {
            break;
        }
        var _S72 : u32 = u32(output_4);
        var _S73 : Eight_0 = FloatWeights_eight_0(weights_9, first_7 + _S72 / u32(8));
        var _S74 : vec4<f32> = tile_product_2(weights_9, _S70 + _S72 * u32(2), &((*inputs_9)));
        var _S75 : vec4<f32>;
        if(((output_4 & (i32(4)))) != i32(0))
        {
            _S75 = _S73.high_0;
        }
        else
        {
            _S75 = _S73.low_0;
        }
        var _S76 : vec4<f32> = _S74 + _S75;
        var _S77 : f32;
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
            (*outputs_6)[output_4] = Relu_apply_0(_S76[i32(0)] + _S77);
        }
        var _S78 : i32 = output_4 + i32(1);
        if(_S78 < i32(25))
        {
            if(adds_6)
            {
                _S77 = (*outputs_6)[_S78];
            }
            else
            {
                _S77 = 0.0f;
            }
            (*outputs_6)[_S78] = Relu_apply_0(_S76[i32(1)] + _S77);
        }
        var _S79 : i32 = output_4 + i32(2);
        if(_S79 < i32(25))
        {
            if(adds_6)
            {
                _S77 = (*outputs_6)[_S79];
            }
            else
            {
                _S77 = 0.0f;
            }
            (*outputs_6)[_S79] = Relu_apply_0(_S76[i32(2)] + _S77);
        }
        var _S80 : i32 = output_4 + i32(3);
        if(_S80 < i32(25))
        {
            if(adds_6)
            {
                _S77 = (*outputs_6)[_S80];
            }
            else
            {
                _S77 = 0.0f;
            }
            (*outputs_6)[_S80] = Relu_apply_0(_S76[i32(3)] + _S77);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn dense_2( weights_10 : FloatWeights_0,  first_8 : u32,  adds_7 : bool,  inputs_10 : ptr<function, array<f32, i32(25)>>,  outputs_7 : ptr<function, array<f32, i32(25)>>)
{
    dense_part_2(weights_10, first_8, adds_7, &((*inputs_10)), &((*outputs_7)));
    return;
}

fn dense_3( weights_11 : FloatWeights_0,  first_9 : u32,  adds_8 : bool,  inputs_11 : ptr<function, array<f32, i32(25)>>,  outputs_8 : ptr<function, array<f32, i32(1)>>)
{
    dense_part_3(weights_11, first_9, adds_8, &((*inputs_11)), &((*outputs_8)));
    return;
}

fn dense_4( weights_12 : FloatWeights_0,  first_10 : u32,  adds_9 : bool,  inputs_12 : ptr<function, array<f32, i32(9)>>,  outputs_9 : ptr<function, array<f32, i32(25)>>)
{
    dense_part_4(weights_12, first_10, adds_9, &((*inputs_12)), &((*outputs_9)));
    return;
}

struct MLP_0
{
     weights_13 : FloatWeights_0,
};

fn layer_size_0( inputs_13 : i32,  outputs_10 : i32) -> i32
{
    return whole_parts_0((outputs_10 + i32(7)) / i32(8)) + whole_parts_0((inputs_13 + i32(7)) / i32(8) * ((outputs_10 + i32(4) - i32(1)) / i32(4) * i32(4)));
}

fn MLP_evaluate_0( this_1 : MLP_0,  inputs_14 : ptr<function, array<f32, i32(11)>>,  outputs_11 : ptr<function, array<f32, i32(3)>>)
{
    var odd_0 : array<f32, i32(25)>;
    var even_0 : array<f32, i32(25)>;
    dense_1(this_1.weights_13, u32(0), false, &((*inputs_14)), &(even_0));
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
        var _S81 : i32 = layer_size_0(i32(25), i32(25));
        var _S82 : u32 = u32(layer_size_0(i32(11), i32(25)) + (layer_0 - i32(1)) * _S81);
        dense_2(this_1.weights_13, _S82, false, &(even_0), &(odd_0));
        if((layer_0 + i32(1)) < i32(3))
        {
            dense_2(this_1.weights_13, _S82 + u32(_S81), false, &(odd_0), &(even_0));
        }
        layer_0 = layer_0 + i32(2);
    }
    var _S83 : u32 = u32(layer_size_0(i32(11), i32(25)) + i32(2) * layer_size_0(i32(25), i32(25)));
    dense_0(this_1.weights_13, _S83, false, &(even_0), &((*outputs_11)));
    return;
}

fn MLP_evaluate_1( this_2 : MLP_0,  inputs_15 : ptr<function, array<f32, i32(9)>>,  outputs_12 : ptr<function, array<f32, i32(1)>>)
{
    var odd_1 : array<f32, i32(25)>;
    var even_1 : array<f32, i32(25)>;
    dense_4(this_2.weights_13, u32(0), false, &((*inputs_15)), &(even_1));
    var layer_1 : i32 = i32(1);
    for(;;)
    {
        if(layer_1 < i32(3))
        {
        }
        else
        {
            break;
        }
        var _S84 : i32 = layer_size_0(i32(25), i32(25));
        var _S85 : u32 = u32(layer_size_0(i32(9), i32(25)) + (layer_1 - i32(1)) * _S84);
        dense_2(this_2.weights_13, _S85, false, &(even_1), &(odd_1));
        if((layer_1 + i32(1)) < i32(3))
        {
            dense_2(this_2.weights_13, _S85 + u32(_S84), false, &(odd_1), &(even_1));
        }
        layer_1 = layer_1 + i32(2);
    }
    var _S86 : u32 = u32(layer_size_0(i32(9), i32(25)) + i32(2) * layer_size_0(i32(25), i32(25)));
    dense_3(this_2.weights_13, _S86, false, &(even_1), &((*outputs_12)));
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
     view_0 : vec3<f32>,
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

fn to_face_frame_0( direction_1 : vec3<f32>,  back_1 : bool) -> vec3<f32>
{
    var _S87 : vec2<f32> = direction_1.xy;
    var _S88 : f32;
    if(back_1)
    {
        _S88 = - direction_1.z;
    }
    else
    {
        _S88 = direction_1.z;
    }
    return vec3<f32>(_S87, _S88);
}

fn no_numbers_0() -> Eight_0
{
    var numbers_1 : Eight_0;
    var _S89 : vec4<f32> = vec4<f32>(0.0f);
    numbers_1.low_0 = _S89;
    numbers_1.high_0 = _S89;
    return numbers_1;
}

fn eight_halves_0( packed_0 : vec4<u32>) -> Eight_0
{
    var numbers_2 : Eight_0;
    numbers_2.low_0 = vec4<f32>(unpack2x16float(packed_0.x), unpack2x16float(packed_0.y));
    numbers_2.high_0 = vec4<f32>(unpack2x16float(packed_0.z), unpack2x16float(packed_0.w));
    return numbers_2;
}

fn texel_numbers_0( first_11 : u32,  elements_1 : u32,  texel_0 : u32) -> Eight_0
{
    var _S90 : u32 = first_11 + texel_0 * elements_1;
    var _S91 : vec4<u32> = packed_numbers_0[_S90];
    if(elements_1 == u32(1))
    {
        return eight_halves_0(_S91);
    }
    var numbers_3 : Eight_0;
    numbers_3.low_0 = (bitcast<vec4<f32>>((_S91)));
    numbers_3.high_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S90 + u32(1)])));
    return numbers_3;
}

fn add_bilinear_0( first_12 : u32,  elements_2 : u32,  start_0 : u32,  columns_0 : u32,  rows_0 : u32,  uv_1 : vec2<f32>,  weight_0 : f32,  sums_3 : ptr<function, Eight_0>)
{
    var _S92 : vec2<f32> = uv_1 * vec2<f32>(f32(columns_0), f32(rows_0)) - vec2<f32>(0.5f);
    var _S93 : vec2<f32> = floor(_S92);
    var _S94 : vec2<f32> = _S92 - _S93;
    var _S95 : i32 = i32(_S93.x);
    var _S96 : i32 = i32(_S93.y);
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
        var _S97 : u32 = (tap_0 & (u32(1)));
        var _S98 : u32 = (tap_0 >> (u32(1)));
        var _S99 : Eight_0 = texel_numbers_0(first_12, elements_2, start_0 + ((u32(_S96 + i32(_S98)) & ((rows_0 - u32(1))))) * columns_0 + ((u32(_S95 + i32(_S97)) & ((columns_0 - u32(1))))));
        var _S100 : f32;
        if(_S98 != u32(0))
        {
            _S100 = _S94.y;
        }
        else
        {
            _S100 = 1.0f - _S94.y;
        }
        var _S101 : f32;
        if(_S97 != u32(0))
        {
            _S101 = _S94.x;
        }
        else
        {
            _S101 = 1.0f - _S94.x;
        }
        var _S102 : vec4<f32> = vec4<f32>((_S100 * _S101 * weight_0));
        (*sums_3).low_0 = (*sums_3).low_0 + _S102 * _S99.low_0;
        (*sums_3).high_0 = (*sums_3).high_0 + _S102 * _S99.high_0;
        tap_0 = tap_0 + u32(1);
    }
    return;
}

fn channel_0( numbers_4 : Eight_0,  k_0 : i32) -> f32
{
    var _S103 : f32;
    if(k_0 < i32(4))
    {
        _S103 = numbers_4.low_0[k_0];
    }
    else
    {
        _S103 = numbers_4.high_0[k_0 - i32(4)];
    }
    return _S103;
}

fn neumip_depth_0( model_0 : ptr<function, Neumip_std430_0>,  uv_2 : vec2<f32>,  view_1 : vec2<f32>,  face_1 : u32) -> f32
{
    var _S104 : u32 = words_0[(*model_0).levels_2 + u32(1)];
    var _S105 : u32 = words_0[(*model_0).levels_2 + u32(2)];
    var texel_1 : Eight_0 = no_numbers_0();
    add_bilinear_0((*model_0).offset_texels_0, (*model_0).texel_elements_0, face_1 * _S104 * _S105, _S104, _S105, fract(uv_2), 1.0f, &(texel_1));
    var inputs_16 : array<f32, i32(9)>;
    var k_1 : i32 = i32(0);
    for(;;)
    {
        if(k_1 < i32(7))
        {
        }
        else
        {
            break;
        }
        inputs_16[k_1] = channel_0(texel_1, k_1);
        k_1 = k_1 + i32(1);
    }
    inputs_16[i32(7)] = view_1.x;
    inputs_16[i32(8)] = view_1.y;
    var network_1 : MLP_0;
    network_1.weights_13.first_0 = (*model_0).offset_0;
    var depth_0 : array<f32, i32(1)>;
    MLP_evaluate_1(network_1, &(inputs_16), &(depth_0));
    return depth_0[i32(0)];
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S106 : u32 = (bitcast<u32>((x_4)));
    var exponent_0 : f32 = f32(i32((_S106 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S106 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S107 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S107 - exponent_1 * 0.00021219444170129f - 0.5f * _S107) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_5 : f32) -> f32
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
}

fn neumip_texel_0( model_1 : ptr<function, Neumip_std430_0>,  uv_3 : vec2<f32>,  level_0 : f32,  face_2 : u32) -> Eight_0
{
    var _S108 : f32 = clamp(level_0, 0.0f, (*model_1).last_level_1);
    var _S109 : f32 = clamp(floor(_S108), 0.0f, max((*model_1).last_level_1 - 1.0f, 0.0f));
    var _S110 : f32 = _S108 - _S109;
    var _S111 : vec2<f32> = clamp(fract(uv_3), vec2<f32>(0.0f), vec2<f32>(1.0f));
    var texel_2 : Eight_0 = no_numbers_0();
    var offset_1 : u32 = u32(0);
    for(;;)
    {
        if(offset_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S112 : f32;
        if(offset_1 == u32(0))
        {
            _S112 = 1.0f - _S110;
        }
        else
        {
            _S112 = _S110;
        }
        if(_S112 <= 0.0f)
        {
            offset_1 = offset_1 + u32(1);
            continue;
        }
        var _S113 : u32 = (*model_1).levels_2 + u32(3) * (u32(_S109) + offset_1);
        add_bilinear_0((*model_1).features_0, (*model_1).texel_elements_0, face_2 * (*model_1).face_texels_0 + words_0[_S113], words_0[_S113 + u32(1)], words_0[_S113 + u32(2)], _S111, _S112, &(texel_2));
        offset_1 = offset_1 + u32(1);
    }
    return texel_2;
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S114 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S115 : u32 = ((((_S114 >> ((((_S114 >> (u32(28)))) + u32(4))))) ^ (_S114))) * u32(277803737);
    return (((_S115 >> (u32(22)))) ^ (_S115));
}

fn uniform_hash_0( thread_0 : u32,  cell_0 : u32,  stream_0 : u32) -> f32
{
    return (f32(((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_0 : u32,  stream_1 : u32) -> vec2<f32>
{
    var _S116 : u32 = pixel_0.x;
    var _S117 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S116, _S117, stream_1), uniform_hash_0(_S116, _S117, stream_1 + u32(1))) + vec2<f32>(f32((index_0 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
    var high_4 : u32 = count_0;
    var low_4 : u32 = u32(0);
    for(;;)
    {
        if((high_4 - low_4) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S118 : u32 = (low_4 + high_4) / u32(2);
        if((scene_number_0(table_0 + _S118)) <= number_0)
        {
            low_4 = _S118;
        }
        else
        {
            high_4 = _S118;
        }
    }
    var _S119 : u32 = table_0 + low_4;
    var _S120 : f32 = scene_number_0(_S119);
    var _S121 : f32 = scene_number_0(_S119 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_2 = low_4;
    choice_0.remainder_0 = saturate((number_0 - _S120) / max(_S121 - _S120, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_6 : f32) -> vec2<f32>
{
    var _S122 : f32 = floor(x_6 * 0.63661974668502808f + 0.5f);
    var _S123 : f32 = x_6 - _S122 * 1.5703125f - _S122 * 0.00048375129699707f - _S122 * 7.54979012640433211e-08f;
    var _S124 : f32 = _S123 * _S123;
    var _S125 : f32 = ((-0.00019515295571182f * _S124 + 0.00833216123282909f) * _S124 - 0.16666655242443085f) * _S124 * _S123 + _S123;
    var _S126 : f32 = ((0.00002443315679557f * _S124 - 0.00138873164542019f) * _S124 + 0.04166664555668831f) * _S124 * _S124 - 0.5f * _S124 + 1.0f;
    var _S127 : u32 = (u32(i32(_S122)) & (u32(3)));
    var _S128 : vec2<f32>;
    if(((_S127 & (u32(1)))) != u32(0))
    {
        _S128 = vec2<f32>(_S126, _S125);
    }
    else
    {
        _S128 = vec2<f32>(_S125, _S126);
    }
    var _S129 : f32;
    if(((_S127 & (u32(2)))) != u32(0))
    {
        _S129 = - _S128.x;
    }
    else
    {
        _S129 = _S128.x;
    }
    var _S130 : f32;
    if((((_S127 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S130 = - _S128.y;
    }
    else
    {
        _S130 = _S128.y;
    }
    return vec2<f32>(_S129, _S130);
}

fn accumulate_0( index_3 : u32,  light_0 : vec4<f32>)
{
    var _S131 : f32 = layers_0[index_3].share_0;
    radiance_0[index_3] = radiance_0[index_3] + vec4<f32>(layers_0[index_3].share_0) * light_0;
    layers_0[index_3].share_0 = _S131 * (1.0f - light_0.w);
    return;
}

fn camera_right_0( _S132 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S132].right_x_0, frames_0[_S132].right_y_0, frames_0[_S132].right_z_0);
}

fn camera_up_0( _S133 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S133].up_x_0, frames_0[_S133].up_y_0, frames_0[_S133].up_z_0);
}

fn camera_forward_0( _S134 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S134].forward_x_0, frames_0[_S134].forward_y_0, frames_0[_S134].forward_z_0);
}

fn camera_origin_0( _S135 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S135].origin_x_0, frames_0[_S135].origin_y_0, frames_0[_S135].origin_z_0);
}

fn face_point_0( _S136 : u32,  _S137 : u32,  _S138 : f32,  _S139 : f32) -> VisiblePoint_0
{
    var _S140 : u32 = u32(3) * _S137;
    var _S141 : Vertex_std430_0 = vertices_0[corners_0[_S140]];
    var _S142 : Vertex_std430_0 = vertices_0[corners_0[_S140 + u32(1)]];
    var _S143 : Vertex_std430_0 = vertices_0[corners_0[_S140 + u32(2)]];
    var _S144 : vec3<f32> = position_of_0(&(_S142));
    var _S145 : vec3<f32> = position_of_0(&(_S141));
    var _S146 : vec3<f32> = _S144 - _S145;
    var _S147 : vec3<f32> = position_of_0(&(_S143));
    var _S148 : vec3<f32> = _S147 - _S145;
    var _S149 : f32 = _S141.u_0;
    var _S150 : f32 = _S142.u_0 - _S141.u_0;
    var _S151 : f32 = _S141.v_0;
    var _S152 : f32 = _S142.v_0 - _S141.v_0;
    var _S153 : vec2<f32> = vec2<f32>(_S150, _S152);
    var _S154 : f32 = _S143.u_0 - _S141.u_0;
    var _S155 : f32 = _S143.v_0 - _S141.v_0;
    var _S156 : vec2<f32> = vec2<f32>(_S154, _S155);
    var _S157 : f32;
    if((_S150 * _S155 - _S152 * _S154) < 0.0f)
    {
        _S157 = -1.0f;
    }
    else
    {
        _S157 = 1.0f;
    }
    var _S158 : vec3<f32> = vec3<f32>(_S157) * (vec3<f32>(_S155) * _S146 - vec3<f32>(_S152) * _S148);
    var _S159 : vec3<f32> = vec3<f32>(_S157) * (vec3<f32>(_S150) * _S148 - vec3<f32>(_S154) * _S146);
    var point_1 : VisiblePoint_0;
    var _S160 : f32 = 1.0f - _S138 - _S139;
    var _S161 : vec3<f32> = normal_of_0(&(_S141));
    var _S162 : vec3<f32> = vec3<f32>(_S160) * _S161;
    var _S163 : vec3<f32> = normal_of_0(&(_S142));
    var _S164 : vec3<f32> = vec3<f32>(_S138);
    var _S165 : vec3<f32> = _S162 + _S164 * _S163;
    var _S166 : vec3<f32> = normal_of_0(&(_S143));
    var _S167 : vec3<f32> = vec3<f32>(_S139);
    var _S168 : vec3<f32> = normalize(_S165 + _S167 * _S166);
    point_1.normal_0 = _S168;
    var _S169 : vec3<f32> = normalize(_S158 - _S168 * vec3<f32>(dot(_S168, _S158)));
    point_1.axis_x_0 = _S169;
    point_1.axis_y_0 = cross(_S168, _S169);
    var _S170 : vec3<f32> = normalize(cross(_S146, _S148));
    var _S171 : vec3<f32>;
    if((dot(_S170, _S168)) < 0.0f)
    {
        _S171 = (vec3<f32>(0) - _S170);
    }
    else
    {
        _S171 = _S170;
    }
    point_1.face_normal_0 = _S171;
    point_1.position_0 = _S145 + _S164 * _S146 + _S167 * _S148;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_0 = vec2<f32>(_S149, _S151) + vec2<f32>(_S138) * _S153 + vec2<f32>(_S139) * _S156;
    var _S172 : bool = (dot(cross(_S158, _S159), point_1.normal_0)) < 0.0f;
    var _S173 : f32 = fabrics_0[_S136].uv_width_0;
    if(_S172)
    {
        _S157 = - fabrics_0[_S136].uv_height_0;
    }
    else
    {
        _S157 = fabrics_0[_S136].uv_height_0;
    }
    var _S174 : vec2<f32> = vec2<f32>(_S173, _S157);
    point_1.draft_per_uv_0 = _S174;
    var _S175 : vec2<f32> = point_1.uv_0 * _S174;
    if(_S172)
    {
        _S157 = fabrics_0[_S136].uv_height_0;
    }
    else
    {
        _S157 = 0.0f;
    }
    point_1.draft_0 = _S175 + vec2<f32>(0.0f, _S157);
    var _S176 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S176;
    point_1.draft_dy_0 = _S176;
    return point_1;
}

fn visible_point_0( _S177 : i32,  _S178 : u32,  _S179 : u32,  _S180 : vec2<u32>) -> VisiblePoint_0
{
    var _S181 : u32 = u32(3) * _S179;
    var _S182 : Vertex_std430_0 = vertices_0[corners_0[_S181]];
    var _S183 : Vertex_std430_0 = vertices_0[corners_0[_S181 + u32(1)]];
    var _S184 : Vertex_std430_0 = vertices_0[corners_0[_S181 + u32(2)]];
    var _S185 : vec3<f32> = position_of_1(&(_S183));
    var _S186 : vec3<f32> = position_of_1(&(_S182));
    var _S187 : vec3<f32> = _S185 - _S186;
    var _S188 : vec3<f32> = position_of_1(&(_S184));
    var _S189 : vec3<f32> = _S188 - _S186;
    var _S190 : vec3<f32> = cross(_S187, _S189);
    var _S191 : f32 = 1.0f / max(square_0(_S190), 1.00000000317107685e-30f);
    var _S192 : f32 = f32(frames_0[_S177].width_0);
    var _S193 : vec3<f32> = camera_right_0(_S177) * vec3<f32>((2.0f / _S192));
    var _S194 : f32 = f32(frames_0[_S177].height_0);
    var _S195 : vec3<f32> = camera_up_0(_S177) * vec3<f32>((-2.0f / _S194));
    var _S196 : vec3<f32> = camera_forward_0(_S177) + vec3<f32>((f32(_S180.x) + 0.5f - 0.5f * _S192)) * _S193 + vec3<f32>((f32(_S180.y) + 0.5f - 0.5f * _S194)) * _S195;
    var _S197 : f32 = dot(_S196, _S190);
    var _S198 : f32;
    if((abs(_S197)) > 1.00000000317107685e-30f)
    {
        _S198 = _S197;
    }
    else
    {
        _S198 = 1.00000000317107685e-30f;
    }
    var _S199 : f32 = 1.0f / _S198;
    var _S200 : vec3<f32> = _S186 - camera_origin_0(_S177);
    var _S201 : vec3<f32> = vec3<f32>((dot(_S200, _S190) * _S199));
    var _S202 : vec3<f32> = _S196 * _S201 - _S200;
    var _S203 : vec3<f32> = _S201 * (_S193 - _S196 * vec3<f32>((dot(_S193, _S190) * _S199)));
    var _S204 : vec3<f32> = _S201 * (_S195 - _S196 * vec3<f32>((dot(_S195, _S190) * _S199)));
    var _S205 : vec3<f32> = vec3<f32>(_S191);
    var _S206 : vec3<f32> = cross(_S189, _S190) * _S205;
    var _S207 : vec3<f32> = cross(_S190, _S187) * _S205;
    var _S208 : vec2<f32> = vec2<f32>(_S183.u_0 - _S182.u_0, _S183.v_0 - _S182.v_0);
    var _S209 : vec2<f32> = vec2<f32>(_S184.u_0 - _S182.u_0, _S184.v_0 - _S182.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S178, _S179, dot(_S202, _S206), dot(_S202, _S207));
    point_2.position_0 = _S186 + _S202;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S196));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S203, _S206)) * _S208 + vec2<f32>(dot(_S203, _S207)) * _S209) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S204, _S206)) * _S208 + vec2<f32>(dot(_S204, _S207)) * _S209) * point_2.draft_per_uv_0;
    return point_2;
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

struct NeumipView_0
{
     latent_0 : array<f32, i32(7)>,
     view_2 : vec2<f32>,
     back_2 : bool,
};

fn neumip_view_0( _S210 : u32,  _S211 : Footprint_0,  _S212 : vec3<f32>,  _S213 : ptr<function, NeumipView_0>)
{
    var _S214 : Neumip_std430_0 = fabrics_0[_S210].neumip_0;
    var _S215 : bool = (_S212.z) < 0.0f;
    var _S216 : u32;
    if(_S215)
    {
        _S216 = _S214.back_0;
    }
    else
    {
        _S216 = u32(0);
    }
    var _S217 : vec3<f32> = to_face_frame_0(_S212, _S215);
    var uv_4 : vec2<f32> = _S211.centre_0 * vec2<f32>(_S214.repeats_per_x_0, _S214.repeats_per_y_0);
    var uv_5 : vec2<f32>;
    if((_S214.has_offset_0) != u32(0))
    {
        var _S218 : vec2<f32> = _S217.xy;
        var _S219 : f32 = neumip_depth_0(&(_S214), uv_4, _S218, _S216);
        uv_5 = uv_4 + vec2<f32>((_S219 / max(_S217.z, 0.60000002384185791f))) * _S218 * vec2<f32>(_S214.unit_x_0, _S214.unit_y_0);
    }
    else
    {
        uv_5 = uv_4;
    }
    var _S220 : Eight_0 = neumip_texel_0(&(_S214), uv_5, binary_logarithm_0(max(sqrt(abs(_S211.dx_0.x * _S211.dy_0.y - _S211.dx_0.y * _S211.dy_0.x)) * _S214.texels_per_mm_0, 9.99999971718068537e-10f)), _S216);
    var k_2 : i32 = i32(0);
    for(;;)
    {
        if(k_2 < i32(7))
        {
        }
        else
        {
            break;
        }
        (*_S213).latent_0[k_2] = channel_0(_S220, k_2);
        k_2 = k_2 + i32(1);
    }
    (*_S213).view_2 = _S217.xy;
    (*_S213).back_2 = _S215;
    return;
}

fn light_sample_count_0( _S221 : i32) -> u32
{
    return frames_0[_S221].lights_0 + frames_0[_S221].environment_samples_0;
}

fn visibility_at_0( _S222 : i32,  _S223 : u32,  _S224 : vec2<u32>) -> f32
{
    if((frames_0[_S222].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S223 * frames_0[_S222].height_0 + _S224.y) * frames_0[_S222].width_0 + _S224.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_0 : f32,
};

fn environment_texel_0( _S225 : i32,  _S226 : u32,  _S227 : u32) -> vec3<f32>
{
    var _S228 : u32 = frames_0[_S225].environment_table_0 + frames_0[_S225].environment_rows_0 + u32(1) + frames_0[_S225].environment_rows_0 * (frames_0[_S225].environment_columns_0 + u32(1)) + u32(3) * (_S226 * frames_0[_S225].environment_columns_0 + _S227);
    return vec3<f32>(scene_number_0(_S228), scene_number_0(_S228 + u32(1)), scene_number_0(_S228 + u32(2)));
}

fn sample_environment_0( _S229 : i32,  _S230 : vec2<f32>,  _S231 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S232 : u32 = frames_0[_S229].environment_rows_0;
    var _S233 : Choice_0 = choose_0(frames_0[_S229].environment_table_0, frames_0[_S229].environment_rows_0, _S230.y);
    var _S234 : u32 = frames_0[_S229].environment_columns_0;
    var _S235 : Choice_0 = choose_0(frames_0[_S229].environment_table_0 + frames_0[_S229].environment_rows_0 + u32(1) + _S233.index_2 * (frames_0[_S229].environment_columns_0 + u32(1)), frames_0[_S229].environment_columns_0, _S230.x);
    var _S236 : vec3<f32> = environment_texel_0(_S229, _S233.index_2, _S235.index_2);
    (*_S231) = _S236 * vec3<f32>((frames_0[_S229].environment_total_0 / max(mean_0(_S236), 9.99999968265522539e-21f)));
    var _S237 : f32 = 3.14159274101257324f / f32(_S232);
    var _S238 : f32 = mix(sine_cosine_0(f32(_S233.index_2) * _S237).y, sine_cosine_0(f32(_S233.index_2 + u32(1)) * _S237).y, _S233.remainder_0);
    var _S239 : f32 = sqrt(max(1.0f - _S238 * _S238, 0.0f));
    var _S240 : vec2<f32> = sine_cosine_0((f32(_S235.index_2) + _S235.remainder_0) * (6.28318548202514648f / f32(_S234)));
    var _S241 : f32 = _S239 * _S240.x;
    var _S242 : f32 = - _S239 * _S240.y;
    return vec3<f32>(frames_0[_S229].environment_cosine_0 * _S241 + frames_0[_S229].environment_sine_0 * _S242, _S238, frames_0[_S229].environment_cosine_0 * _S242 - frames_0[_S229].environment_sine_0 * _S241);
}

fn light_sample_0( _S243 : i32,  _S244 : u32,  _S245 : vec2<u32>,  _S246 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    var _S247 : u32 = frames_0[_S243].lights_0;
    if(_S244 >= (frames_0[_S243].lights_0))
    {
        var weight_1 : vec3<f32>;
        var _S248 : vec3<f32> = sample_environment_0(_S243, pixel_sequence_0(_S245, frames_0[_S243].pass_number_0 * frames_0[_S243].environment_samples_0 + (_S244 - _S247), u32(3)), &(weight_1));
        sample_0.towards_0 = _S248;
        sample_0.irradiance_1 = weight_1 / vec3<f32>(f32(frames_0[_S243].environment_samples_0));
        return sample_0;
    }
    var _S249 : Light_std430_0 = lights_1[_S244];
    sample_0.irradiance_1 = vec3<f32>(_S249.red_0, _S249.green_0, _S249.blue_0);
    sample_0.towards_0 = vec3<f32>(_S249.x_1, _S249.y_1, _S249.z_1);
    if((_S249.is_point_0) != u32(0))
    {
        var _S250 : vec3<f32> = sample_0.towards_0 - _S246;
        var _S251 : f32 = max(square_0(_S250), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S251);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S251);
        sample_0.towards_0 = normalize(_S250);
    }
    return sample_0;
}

fn neumip_value_0( _S252 : u32,  _S253 : ptr<function, NeumipView_0>,  _S254 : vec3<f32>) -> vec3<f32>
{
    var _S255 : vec3<f32> = to_face_frame_0(_S254, (*_S253).back_2);
    if((_S255.z) <= 0.0f)
    {
        return vec3<f32>(0.0f);
    }
    var inputs_17 : array<f32, i32(11)>;
    var k_3 : i32 = i32(0);
    for(;;)
    {
        if(k_3 < i32(7))
        {
        }
        else
        {
            break;
        }
        inputs_17[k_3] = (*_S253).latent_0[k_3];
        k_3 = k_3 + i32(1);
    }
    inputs_17[i32(7)] = _S255.x;
    inputs_17[i32(8)] = _S255.y;
    inputs_17[i32(9)] = (*_S253).view_2.x;
    inputs_17[i32(10)] = (*_S253).view_2.y;
    var network_2 : MLP_0;
    network_2.weights_13.first_0 = fabrics_0[_S252].neumip_0.decoder_0;
    var outputs_13 : array<f32, i32(3)>;
    MLP_evaluate_0(network_2, &(inputs_17), &(outputs_13));
    return max(vec3<f32>(outputs_13[i32(0)], outputs_13[i32(1)], outputs_13[i32(2)]), vec3<f32>(0.0f)) * vec3<f32>(0.31830987334251404f);
}

fn light_of_neumip_0( _S256 : i32,  _S257 : u32,  _S258 : VisiblePoint_0,  _S259 : vec2<u32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S258.draft_0;
    footprint_0.dx_0 = _S258.draft_dx_0;
    footprint_0.dy_0 = _S258.draft_dy_0;
    var seen_0 : NeumipView_0;
    neumip_view_0(_S257, footprint_0, to_local_0(_S258, _S258.view_0), &(seen_0));
    var _S260 : vec3<f32> = vec3<f32>(0.0f);
    var number_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S260;
    for(;;)
    {
        if(number_1 < (light_sample_count_0(_S256)))
        {
        }
        else
        {
            break;
        }
        var _S261 : f32 = visibility_at_0(_S256, number_1, _S259);
        if(_S261 <= 0.0f)
        {
            number_1 = number_1 + u32(1);
            continue;
        }
        var _S262 : LightSample_0 = light_sample_0(_S256, number_1, _S259, _S258.position_0);
        var _S263 : vec3<f32> = vec3<f32>(_S261) * _S262.irradiance_1;
        var _S264 : vec3<f32> = neumip_value_0(_S257, &(seen_0), to_local_0(_S258, _S262.towards_0));
        radiance_1 = radiance_1 + _S263 * _S264;
        number_1 = number_1 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_neumip(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S265 : u32 = id_0.x;
    var _S266 : u32 = frames_0[i32(0)].width_0;
    var _S267 : bool;
    if(_S265 >= (frames_0[i32(0)].width_0))
    {
        _S267 = true;
    }
    else
    {
        _S267 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S267)
    {
        return;
    }
    var _S268 : u32 = id_0.y * _S266 + _S265;
    var _S269 : u32 = layers_0[_S268].face_0;
    if((layers_0[_S268].face_0) == u32(0))
    {
        return;
    }
    var _S270 : u32 = _S269 - u32(1);
    var _S271 : u32 = face_fabrics_0[_S270];
    var _S272 : vec2<u32> = id_0.xy;
    accumulate_0(_S268, light_of_neumip_0(i32(0), _S271, visible_point_0(i32(0), _S271, _S270, _S272), _S272));
    return;
}

