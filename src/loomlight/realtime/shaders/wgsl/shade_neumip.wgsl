struct Frame_std140_0
{
    @align(16) width_0 : u32,
    @align(4) height_0 : u32,
    @align(8) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(16) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(8) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(16) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(8) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(16) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(8) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(16) corners_0 : u32,
    @align(4) face_fabrics_0 : u32,
    @align(8) vertices_0 : u32,
    @align(4) light_records_0 : u32,
    @align(16) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(8) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(16) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(8) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(16) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(8) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(16) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(8) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(16) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(8) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
    @align(16) ground_x_0 : f32,
    @align(4) ground_y_0 : f32,
    @align(8) ground_z_0 : f32,
    @align(4) ground_offset_0 : f32,
    @align(16) ground_lamp_0 : f32,
};

@binding(10) @group(0) var<uniform> frame_record_0 : Frame_std140_0;
struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(5) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(4) @group(0) var<storage, read> scene_words_0 : array<u32>;

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
    @align(4) joint_0 : u32,
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
    @align(4) auxiliary_0 : u32,
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
    @align(4) is_apart_0 : u32,
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
    @align(4) texels_2 : u32,
    @align(4) light_0 : u32,
    @align(4) heights_0 : u32,
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
    @align(4) grazing_gain_0 : f32,
    @align(4) grazing_loss_0 : f32,
    @align(4) sheen_strength_0 : f32,
    @align(4) sheen_roughness_0 : f32,
    @align(4) fibre_noise_0 : f32,
    @align(4) colour_noise_0 : f32,
    @align(4) seed_0 : u32,
    @align(4) layer_bound_0 : f32,
    @align(4) fibre_size_0 : f32,
    @align(4) is_irregular_0 : u32,
    @align(4) warp_on_top_0 : f32,
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
    @align(4) planes_0 : u32,
    @align(4) plane_records_0 : u32,
    @align(4) plane_axes_0 : u32,
    @align(4) stacks_0 : u32,
    @align(4) plane_orders_0 : u32,
    @align(4) regions_0 : u32,
    @align(4) plane_shares_0 : u32,
    @align(4) is_coloured_0 : u32,
};

@binding(0) @group(0) var<storage, read> fabrics_0 : array<Fabric_std430_0>;

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
    @align(4) layer_turned_0 : f32,
    @align(4) layer_through_0 : f32,
    @align(4) albedo_table_0 : u32,
    @align(4) albedo_stride_0 : u32,
    @align(4) before_0 : u32,
    @align(4) visible_total_0 : f32,
    @align(4) smallest_box_0 : f32,
    @align(4) quantities_0 : u32,
    @align(4) colour_mean_0 : u32,
    @align(4) cloth_mean_0 : u32,
    @align(4) colour_axes_0 : u32,
    @align(4) colour_threads_0 : u32,
    @align(4) colour_areas_0 : u32,
    @align(4) area_unit_0 : f32,
    @align(4) crossing_area_0 : f32,
    @align(4) irregular_table_0 : u32,
    @align(4) irregular_thickness_0 : f32,
    @align(4) irregular_cover_0 : f32,
    @align(4) irregular_tone_0 : f32,
    @align(4) irregular_nep_0 : f32,
    @align(4) cover_0 : f32,
    @align(4) nep_red_0 : f32,
    @align(4) nep_green_0 : f32,
    @align(4) nep_blue_0 : f32,
    @align(4) has_plies_0 : f32,
    @align(4) plies_per_mm_0 : f32,
    @align(4) ply_sine_0 : f32,
    @align(4) ply_cosine_0 : f32,
    @align(4) fibre_tilt_0 : f32,
    @align(4) fibre_tone_0 : f32,
    @align(4) slub_0 : f32,
    @align(4) slubs_per_mm_0 : f32,
    @align(4) hairiness_0 : f32,
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(3) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

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
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
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
        sums_1[i32(0)] = sums_1[i32(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        var _S7 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(4) + column_0);
        sums_1[i32(1)] = sums_1[i32(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        var _S8 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(8) + column_0);
        sums_1[i32(2)] = sums_1[i32(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        var _S9 : Eight_0 = FloatWeights_eight_0(weights_0, row_0 + u32(12) + column_0);
        sums_1[i32(3)] = sums_1[i32(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + u32(1);
    }
    return sums_1;
}

fn select_vector_0( condition_0 : bool,  yes_0 : vec4<f32>,  no_0 : vec4<f32>) -> vec4<f32>
{
    var chosen_0 : vec4<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    chosen_0[i32(3)] = select(no_0[i32(3)], yes_0[i32(3)], condition_0);
    return chosen_0;
}

fn Identity_apply_0( x_0 : f32) -> f32
{
    return x_0;
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
        var _S15 : vec4<f32> = _S14 + select_vector_0(((output_0 & (i32(4)))) != i32(0), _S13.high_0, _S13.low_0);
        var _S16 : f32;
        if(_S11)
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[output_0];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S15[i32(0)] + _S16);
        }
        var _S17 : i32 = output_0 + i32(1);
        if(_S17 < i32(3))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S17];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S17] = Identity_apply_0(_S15[i32(1)] + _S16);
        }
        var _S18 : i32 = output_0 + i32(2);
        if(_S18 < i32(3))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S18];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S18] = Identity_apply_0(_S15[i32(2)] + _S16);
        }
        var _S19 : i32 = output_0 + i32(3);
        if(_S19 < i32(3))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S19];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S19] = Identity_apply_0(_S15[i32(3)] + _S16);
        }
        output_0 = output_0 + i32(4);
    }
    return;
}

fn tile_product_1( weights_2 : FloatWeights_0,  row_1 : u32,  inputs_2 : ptr<function, array<f32, i32(11)>>) -> vec4<f32>
{
    var sums_2 : vec4<f32> = vec4<f32>(0.0f);
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
        var _S20 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_2)[min(_S20, i32(10))];
        high_2[i32(0)] = (*inputs_2)[min(_S20 + i32(4), i32(10))];
        var _S21 : i32 = _S20 + i32(1);
        low_2[i32(1)] = (*inputs_2)[min(_S21, i32(10))];
        high_2[i32(1)] = (*inputs_2)[min(_S21 + i32(4), i32(10))];
        var _S22 : i32 = _S20 + i32(2);
        low_2[i32(2)] = (*inputs_2)[min(_S22, i32(10))];
        high_2[i32(2)] = (*inputs_2)[min(_S22 + i32(4), i32(10))];
        var _S23 : i32 = _S20 + i32(3);
        low_2[i32(3)] = (*inputs_2)[min(_S23, i32(10))];
        high_2[i32(3)] = (*inputs_2)[min(_S23 + i32(4), i32(10))];
        var _S24 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + column_1);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S24.low_0, low_2) + dot(_S24.high_0, high_2));
        var _S25 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + u32(2) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        var _S26 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + u32(4) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        var _S27 : Eight_0 = FloatWeights_eight_0(weights_2, row_1 + u32(6) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn Relu_apply_0( x_1 : f32) -> f32
{
    return max(x_1, 0.0f);
}

fn dense_part_1( weights_3 : FloatWeights_0,  first_2 : u32,  adds_1 : bool,  inputs_3 : ptr<function, array<f32, i32(11)>>,  outputs_1 : ptr<function, array<f32, i32(25)>>)
{
    var _S28 : u32 = first_2 + u32(whole_parts_0(i32(4)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S29 : bool = output_1 < i32(25);
        if(_S29)
        {
        }
        else
        {
            break;
        }
        var _S30 : u32 = u32(output_1);
        var _S31 : Eight_0 = FloatWeights_eight_0(weights_3, first_2 + _S30 / u32(8));
        var _S32 : vec4<f32> = tile_product_1(weights_3, _S28 + _S30 * u32(2), &((*inputs_3)));
        var _S33 : vec4<f32> = _S32 + select_vector_0(((output_1 & (i32(4)))) != i32(0), _S31.high_0, _S31.low_0);
        var _S34 : f32;
        if(_S29)
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[output_1];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[output_1] = Relu_apply_0(_S33[i32(0)] + _S34);
        }
        var _S35 : i32 = output_1 + i32(1);
        if(_S35 < i32(25))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S35];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S35] = Relu_apply_0(_S33[i32(1)] + _S34);
        }
        var _S36 : i32 = output_1 + i32(2);
        if(_S36 < i32(25))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S36];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S36] = Relu_apply_0(_S33[i32(2)] + _S34);
        }
        var _S37 : i32 = output_1 + i32(3);
        if(_S37 < i32(25))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S37];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S37] = Relu_apply_0(_S33[i32(3)] + _S34);
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

fn tile_product_2( weights_6 : FloatWeights_0,  row_2 : u32,  inputs_6 : ptr<function, array<f32, i32(16)>>) -> vec4<f32>
{
    var sums_3 : vec4<f32> = vec4<f32>(0.0f);
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
        var _S38 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_6)[_S38];
        high_3[i32(0)] = (*inputs_6)[_S38 + i32(4)];
        var _S39 : i32 = _S38 + i32(1);
        low_3[i32(1)] = (*inputs_6)[_S39];
        high_3[i32(1)] = (*inputs_6)[_S39 + i32(4)];
        var _S40 : i32 = _S38 + i32(2);
        low_3[i32(2)] = (*inputs_6)[_S40];
        high_3[i32(2)] = (*inputs_6)[_S40 + i32(4)];
        var _S41 : i32 = _S38 + i32(3);
        low_3[i32(3)] = (*inputs_6)[_S41];
        high_3[i32(3)] = (*inputs_6)[_S41 + i32(4)];
        var _S42 : Eight_0 = FloatWeights_eight_0(weights_6, row_2 + column_2);
        sums_3[i32(0)] = sums_3[i32(0)] + (dot(_S42.low_0, low_3) + dot(_S42.high_0, high_3));
        var _S43 : Eight_0 = FloatWeights_eight_0(weights_6, row_2 + u32(2) + column_2);
        sums_3[i32(1)] = sums_3[i32(1)] + (dot(_S43.low_0, low_3) + dot(_S43.high_0, high_3));
        var _S44 : Eight_0 = FloatWeights_eight_0(weights_6, row_2 + u32(4) + column_2);
        sums_3[i32(2)] = sums_3[i32(2)] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        var _S45 : Eight_0 = FloatWeights_eight_0(weights_6, row_2 + u32(6) + column_2);
        sums_3[i32(3)] = sums_3[i32(3)] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_3;
}

fn dense_part_2( weights_7 : FloatWeights_0,  first_5 : u32,  adds_4 : bool,  inputs_7 : ptr<function, array<f32, i32(16)>>,  outputs_4 : ptr<function, array<f32, i32(16)>>)
{
    var _S46 : u32 = first_5 + u32(whole_parts_0(i32(2)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S47 : bool = output_2 < i32(16);
        if(_S47)
        {
        }
        else
        {
            break;
        }
        var _S48 : u32 = u32(output_2);
        var _S49 : Eight_0 = FloatWeights_eight_0(weights_7, first_5 + _S48 / u32(8));
        var _S50 : vec4<f32> = tile_product_2(weights_7, _S46 + _S48 * u32(2), &((*inputs_7)));
        var _S51 : vec4<f32> = _S50 + select_vector_0(((output_2 & (i32(4)))) != i32(0), _S49.high_0, _S49.low_0);
        var _S52 : f32;
        if(_S47)
        {
            if(adds_4)
            {
                _S52 = (*outputs_4)[output_2];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_4)[output_2] = Relu_apply_0(_S51[i32(0)] + _S52);
        }
        var _S53 : i32 = output_2 + i32(1);
        if(_S53 < i32(16))
        {
            if(adds_4)
            {
                _S52 = (*outputs_4)[_S53];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_4)[_S53] = Relu_apply_0(_S51[i32(1)] + _S52);
        }
        var _S54 : i32 = output_2 + i32(2);
        if(_S54 < i32(16))
        {
            if(adds_4)
            {
                _S52 = (*outputs_4)[_S54];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_4)[_S54] = Relu_apply_0(_S51[i32(2)] + _S52);
        }
        var _S55 : i32 = output_2 + i32(3);
        if(_S55 < i32(16))
        {
            if(adds_4)
            {
                _S52 = (*outputs_4)[_S55];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_4)[_S55] = Relu_apply_0(_S51[i32(3)] + _S52);
        }
        output_2 = output_2 + i32(4);
    }
    return;
}

fn dense_part_3( weights_8 : FloatWeights_0,  first_6 : u32,  adds_5 : bool,  inputs_8 : ptr<function, array<f32, i32(16)>>,  outputs_5 : ptr<function, array<f32, i32(1)>>)
{
    var _S56 : u32 = first_6 + u32(whole_parts_0(i32(1)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S57 : bool = output_3 < i32(1);
        if(_S57)
        {
        }
        else
        {
            break;
        }
        var _S58 : u32 = u32(output_3);
        var _S59 : Eight_0 = FloatWeights_eight_0(weights_8, first_6 + _S58 / u32(8));
        var _S60 : vec4<f32> = tile_product_2(weights_8, _S56 + _S58 * u32(2), &((*inputs_8)));
        var _S61 : vec4<f32> = _S60 + select_vector_0(((output_3 & (i32(4)))) != i32(0), _S59.high_0, _S59.low_0);
        var _S62 : f32;
        if(_S57)
        {
            if(adds_5)
            {
                _S62 = (*outputs_5)[output_3];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_5)[output_3] = Identity_apply_0(_S61[i32(0)] + _S62);
        }
        var _S63 : i32 = output_3 + i32(1);
        if(_S63 < i32(1))
        {
            if(adds_5)
            {
                _S62 = (*outputs_5)[_S63];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_5)[_S63] = Identity_apply_0(_S61[i32(1)] + _S62);
        }
        var _S64 : i32 = output_3 + i32(2);
        if(_S64 < i32(1))
        {
            if(adds_5)
            {
                _S62 = (*outputs_5)[_S64];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_5)[_S64] = Identity_apply_0(_S61[i32(2)] + _S62);
        }
        var _S65 : i32 = output_3 + i32(3);
        if(_S65 < i32(1))
        {
            if(adds_5)
            {
                _S62 = (*outputs_5)[_S65];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_5)[_S65] = Identity_apply_0(_S61[i32(3)] + _S62);
        }
        output_3 = output_3 + i32(4);
    }
    return;
}

fn tile_product_3( weights_9 : FloatWeights_0,  row_3 : u32,  inputs_9 : ptr<function, array<f32, i32(9)>>) -> vec4<f32>
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
        var _S66 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_9)[min(_S66, i32(8))];
        high_4[i32(0)] = (*inputs_9)[min(_S66 + i32(4), i32(8))];
        var _S67 : i32 = _S66 + i32(1);
        low_4[i32(1)] = (*inputs_9)[min(_S67, i32(8))];
        high_4[i32(1)] = (*inputs_9)[min(_S67 + i32(4), i32(8))];
        var _S68 : i32 = _S66 + i32(2);
        low_4[i32(2)] = (*inputs_9)[min(_S68, i32(8))];
        high_4[i32(2)] = (*inputs_9)[min(_S68 + i32(4), i32(8))];
        var _S69 : i32 = _S66 + i32(3);
        low_4[i32(3)] = (*inputs_9)[min(_S69, i32(8))];
        high_4[i32(3)] = (*inputs_9)[min(_S69 + i32(4), i32(8))];
        var _S70 : Eight_0 = FloatWeights_eight_0(weights_9, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S70.low_0, low_4) + dot(_S70.high_0, high_4));
        var _S71 : Eight_0 = FloatWeights_eight_0(weights_9, row_3 + u32(2) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S71.low_0, low_4) + dot(_S71.high_0, high_4));
        var _S72 : Eight_0 = FloatWeights_eight_0(weights_9, row_3 + u32(4) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S72.low_0, low_4) + dot(_S72.high_0, high_4));
        var _S73 : Eight_0 = FloatWeights_eight_0(weights_9, row_3 + u32(6) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S73.low_0, low_4) + dot(_S73.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_4( weights_10 : FloatWeights_0,  first_7 : u32,  adds_6 : bool,  inputs_10 : ptr<function, array<f32, i32(9)>>,  outputs_6 : ptr<function, array<f32, i32(16)>>)
{
    var _S74 : u32 = first_7 + u32(whole_parts_0(i32(2)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S75 : bool = output_4 < i32(16);
        if(_S75)
        {
        }
        else
        {
            break;
        }
        var _S76 : u32 = u32(output_4);
        var _S77 : Eight_0 = FloatWeights_eight_0(weights_10, first_7 + _S76 / u32(8));
        var _S78 : vec4<f32> = tile_product_3(weights_10, _S74 + _S76 * u32(2), &((*inputs_10)));
        var _S79 : vec4<f32> = _S78 + select_vector_0(((output_4 & (i32(4)))) != i32(0), _S77.high_0, _S77.low_0);
        var _S80 : f32;
        if(_S75)
        {
            if(adds_6)
            {
                _S80 = (*outputs_6)[output_4];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_6)[output_4] = Relu_apply_0(_S79[i32(0)] + _S80);
        }
        var _S81 : i32 = output_4 + i32(1);
        if(_S81 < i32(16))
        {
            if(adds_6)
            {
                _S80 = (*outputs_6)[_S81];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_6)[_S81] = Relu_apply_0(_S79[i32(1)] + _S80);
        }
        var _S82 : i32 = output_4 + i32(2);
        if(_S82 < i32(16))
        {
            if(adds_6)
            {
                _S80 = (*outputs_6)[_S82];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_6)[_S82] = Relu_apply_0(_S79[i32(2)] + _S80);
        }
        var _S83 : i32 = output_4 + i32(3);
        if(_S83 < i32(16))
        {
            if(adds_6)
            {
                _S80 = (*outputs_6)[_S83];
            }
            else
            {
                _S80 = 0.0f;
            }
            (*outputs_6)[_S83] = Relu_apply_0(_S79[i32(3)] + _S80);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn dense_2( weights_11 : FloatWeights_0,  first_8 : u32,  adds_7 : bool,  inputs_11 : ptr<function, array<f32, i32(16)>>,  outputs_7 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_2(weights_11, first_8, adds_7, &((*inputs_11)), &((*outputs_7)));
    return;
}

fn dense_3( weights_12 : FloatWeights_0,  first_9 : u32,  adds_8 : bool,  inputs_12 : ptr<function, array<f32, i32(16)>>,  outputs_8 : ptr<function, array<f32, i32(1)>>)
{
    dense_part_3(weights_12, first_9, adds_8, &((*inputs_12)), &((*outputs_8)));
    return;
}

fn dense_4( weights_13 : FloatWeights_0,  first_10 : u32,  adds_9 : bool,  inputs_13 : ptr<function, array<f32, i32(9)>>,  outputs_9 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_4(weights_13, first_10, adds_9, &((*inputs_13)), &((*outputs_9)));
    return;
}

fn dense_part_5( weights_14 : FloatWeights_0,  first_11 : u32,  adds_10 : bool,  inputs_14 : ptr<function, array<f32, i32(25)>>,  outputs_10 : ptr<function, array<f32, i32(25)>>)
{
    var _S84 : u32 = first_11 + u32(whole_parts_0(i32(4)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S85 : bool = output_5 < i32(25);
        if(_S85)
        {
        }
        else
        {
            break;
        }
        var _S86 : u32 = u32(output_5);
        var _S87 : Eight_0 = FloatWeights_eight_0(weights_14, first_11 + _S86 / u32(8));
        var _S88 : vec4<f32> = tile_product_0(weights_14, _S84 + _S86 * u32(4), &((*inputs_14)));
        var _S89 : vec4<f32> = _S88 + select_vector_0(((output_5 & (i32(4)))) != i32(0), _S87.high_0, _S87.low_0);
        var _S90 : f32;
        if(_S85)
        {
            if(adds_10)
            {
                _S90 = (*outputs_10)[output_5];
            }
            else
            {
                _S90 = 0.0f;
            }
            (*outputs_10)[output_5] = Relu_apply_0(_S89[i32(0)] + _S90);
        }
        var _S91 : i32 = output_5 + i32(1);
        if(_S91 < i32(25))
        {
            if(adds_10)
            {
                _S90 = (*outputs_10)[_S91];
            }
            else
            {
                _S90 = 0.0f;
            }
            (*outputs_10)[_S91] = Relu_apply_0(_S89[i32(1)] + _S90);
        }
        var _S92 : i32 = output_5 + i32(2);
        if(_S92 < i32(25))
        {
            if(adds_10)
            {
                _S90 = (*outputs_10)[_S92];
            }
            else
            {
                _S90 = 0.0f;
            }
            (*outputs_10)[_S92] = Relu_apply_0(_S89[i32(2)] + _S90);
        }
        var _S93 : i32 = output_5 + i32(3);
        if(_S93 < i32(25))
        {
            if(adds_10)
            {
                _S90 = (*outputs_10)[_S93];
            }
            else
            {
                _S90 = 0.0f;
            }
            (*outputs_10)[_S93] = Relu_apply_0(_S89[i32(3)] + _S90);
        }
        output_5 = output_5 + i32(4);
    }
    return;
}

fn dense_part_6( weights_15 : FloatWeights_0,  first_12 : u32,  adds_11 : bool,  inputs_15 : ptr<function, array<f32, i32(25)>>,  outputs_11 : ptr<function, array<f32, i32(1)>>)
{
    var _S94 : u32 = first_12 + u32(whole_parts_0(i32(1)));
    var output_6 : i32 = i32(0);
    for(;;)
    {
        var _S95 : bool = output_6 < i32(1);
        if(_S95)
        {
        }
        else
        {
            break;
        }
        var _S96 : u32 = u32(output_6);
        var _S97 : Eight_0 = FloatWeights_eight_0(weights_15, first_12 + _S96 / u32(8));
        var _S98 : vec4<f32> = tile_product_0(weights_15, _S94 + _S96 * u32(4), &((*inputs_15)));
        var _S99 : vec4<f32> = _S98 + select_vector_0(((output_6 & (i32(4)))) != i32(0), _S97.high_0, _S97.low_0);
        var _S100 : f32;
        if(_S95)
        {
            if(adds_11)
            {
                _S100 = (*outputs_11)[output_6];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_11)[output_6] = Identity_apply_0(_S99[i32(0)] + _S100);
        }
        var _S101 : i32 = output_6 + i32(1);
        if(_S101 < i32(1))
        {
            if(adds_11)
            {
                _S100 = (*outputs_11)[_S101];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_11)[_S101] = Identity_apply_0(_S99[i32(1)] + _S100);
        }
        var _S102 : i32 = output_6 + i32(2);
        if(_S102 < i32(1))
        {
            if(adds_11)
            {
                _S100 = (*outputs_11)[_S102];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_11)[_S102] = Identity_apply_0(_S99[i32(2)] + _S100);
        }
        var _S103 : i32 = output_6 + i32(3);
        if(_S103 < i32(1))
        {
            if(adds_11)
            {
                _S100 = (*outputs_11)[_S103];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_11)[_S103] = Identity_apply_0(_S99[i32(3)] + _S100);
        }
        output_6 = output_6 + i32(4);
    }
    return;
}

fn dense_part_7( weights_16 : FloatWeights_0,  first_13 : u32,  adds_12 : bool,  inputs_16 : ptr<function, array<f32, i32(9)>>,  outputs_12 : ptr<function, array<f32, i32(25)>>)
{
    var _S104 : u32 = first_13 + u32(whole_parts_0(i32(4)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S105 : bool = output_7 < i32(25);
        if(_S105)
        {
        }
        else
        {
            break;
        }
        var _S106 : u32 = u32(output_7);
        var _S107 : Eight_0 = FloatWeights_eight_0(weights_16, first_13 + _S106 / u32(8));
        var _S108 : vec4<f32> = tile_product_3(weights_16, _S104 + _S106 * u32(2), &((*inputs_16)));
        var _S109 : vec4<f32> = _S108 + select_vector_0(((output_7 & (i32(4)))) != i32(0), _S107.high_0, _S107.low_0);
        var _S110 : f32;
        if(_S105)
        {
            if(adds_12)
            {
                _S110 = (*outputs_12)[output_7];
            }
            else
            {
                _S110 = 0.0f;
            }
            (*outputs_12)[output_7] = Relu_apply_0(_S109[i32(0)] + _S110);
        }
        var _S111 : i32 = output_7 + i32(1);
        if(_S111 < i32(25))
        {
            if(adds_12)
            {
                _S110 = (*outputs_12)[_S111];
            }
            else
            {
                _S110 = 0.0f;
            }
            (*outputs_12)[_S111] = Relu_apply_0(_S109[i32(1)] + _S110);
        }
        var _S112 : i32 = output_7 + i32(2);
        if(_S112 < i32(25))
        {
            if(adds_12)
            {
                _S110 = (*outputs_12)[_S112];
            }
            else
            {
                _S110 = 0.0f;
            }
            (*outputs_12)[_S112] = Relu_apply_0(_S109[i32(2)] + _S110);
        }
        var _S113 : i32 = output_7 + i32(3);
        if(_S113 < i32(25))
        {
            if(adds_12)
            {
                _S110 = (*outputs_12)[_S113];
            }
            else
            {
                _S110 = 0.0f;
            }
            (*outputs_12)[_S113] = Relu_apply_0(_S109[i32(3)] + _S110);
        }
        output_7 = output_7 + i32(4);
    }
    return;
}

fn dense_5( weights_17 : FloatWeights_0,  first_14 : u32,  adds_13 : bool,  inputs_17 : ptr<function, array<f32, i32(25)>>,  outputs_13 : ptr<function, array<f32, i32(25)>>)
{
    dense_part_5(weights_17, first_14, adds_13, &((*inputs_17)), &((*outputs_13)));
    return;
}

fn dense_6( weights_18 : FloatWeights_0,  first_15 : u32,  adds_14 : bool,  inputs_18 : ptr<function, array<f32, i32(25)>>,  outputs_14 : ptr<function, array<f32, i32(1)>>)
{
    dense_part_6(weights_18, first_15, adds_14, &((*inputs_18)), &((*outputs_14)));
    return;
}

fn dense_7( weights_19 : FloatWeights_0,  first_16 : u32,  adds_15 : bool,  inputs_19 : ptr<function, array<f32, i32(9)>>,  outputs_15 : ptr<function, array<f32, i32(25)>>)
{
    dense_part_7(weights_19, first_16, adds_15, &((*inputs_19)), &((*outputs_15)));
    return;
}

struct MLP_0
{
     weights_20 : FloatWeights_0,
};

fn layer_size_0( inputs_20 : i32,  outputs_16 : i32) -> i32
{
    return whole_parts_0((outputs_16 + i32(7)) / i32(8)) + whole_parts_0((inputs_20 + i32(7)) / i32(8) * ((outputs_16 + i32(4) - i32(1)) / i32(4) * i32(4)));
}

fn MLP_evaluate_0( this_1 : MLP_0,  inputs_21 : ptr<function, array<f32, i32(11)>>,  outputs_17 : ptr<function, array<f32, i32(3)>>)
{
    var odd_0 : array<f32, i32(25)>;
    var even_0 : array<f32, i32(25)>;
    dense_1(this_1.weights_20, u32(0), false, &((*inputs_21)), &(even_0));
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
        var _S114 : i32 = layer_size_0(i32(25), i32(25));
        var _S115 : u32 = u32(layer_size_0(i32(11), i32(25)) + (layer_0 - i32(1)) * _S114);
        dense_5(this_1.weights_20, _S115, false, &(even_0), &(odd_0));
        if((layer_0 + i32(1)) < i32(3))
        {
            dense_5(this_1.weights_20, _S115 + u32(_S114), false, &(odd_0), &(even_0));
        }
        layer_0 = layer_0 + i32(2);
    }
    var _S116 : u32 = u32(layer_size_0(i32(11), i32(25)) + i32(2) * layer_size_0(i32(25), i32(25)));
    dense_0(this_1.weights_20, _S116, false, &(even_0), &((*outputs_17)));
    return;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn MLP_evaluate_1( this_2 : MLP_0,  inputs_22 : ptr<function, array<f32, i32(9)>>,  outputs_18 : ptr<function, array<f32, i32(1)>>)
{
    var odd_1 : array<f32, i32(16)>;
    var even_1 : array<f32, i32(16)>;
    dense_4(this_2.weights_20, u32(0), false, &((*inputs_22)), &(even_1));
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
        var _S117 : i32 = layer_size_0(i32(16), i32(16));
        var _S118 : u32 = u32(layer_size_0(i32(9), i32(16)) + (layer_1 - i32(1)) * _S117);
        dense_2(this_2.weights_20, _S118, false, &(even_1), &(odd_1));
        if((layer_1 + i32(1)) < i32(2))
        {
            dense_2(this_2.weights_20, _S118 + u32(_S117), false, &(odd_1), &(even_1));
        }
        layer_1 = layer_1 + i32(2);
    }
    var _S119 : u32 = u32(layer_size_0(i32(9), i32(16)) + layer_size_0(i32(16), i32(16)));
    dense_3(this_2.weights_20, _S119, false, &(odd_1), &((*outputs_18)));
    return;
}

fn MLP_evaluate_2( this_3 : MLP_0,  inputs_23 : ptr<function, array<f32, i32(9)>>,  outputs_19 : ptr<function, array<f32, i32(1)>>)
{
    var odd_2 : array<f32, i32(25)>;
    var even_2 : array<f32, i32(25)>;
    dense_7(this_3.weights_20, u32(0), false, &((*inputs_23)), &(even_2));
    var layer_2 : i32 = i32(1);
    for(;;)
    {
        if(layer_2 < i32(3))
        {
        }
        else
        {
            break;
        }
        var _S120 : i32 = layer_size_0(i32(25), i32(25));
        var _S121 : u32 = u32(layer_size_0(i32(9), i32(25)) + (layer_2 - i32(1)) * _S120);
        dense_5(this_3.weights_20, _S121, false, &(even_2), &(odd_2));
        if((layer_2 + i32(1)) < i32(3))
        {
            dense_5(this_3.weights_20, _S121 + u32(_S120), false, &(odd_2), &(even_2));
        }
        layer_2 = layer_2 + i32(2);
    }
    var _S122 : u32 = u32(layer_size_0(i32(9), i32(25)) + i32(2) * layer_size_0(i32(25), i32(25)));
    dense_6(this_3.weights_20, _S122, false, &(even_2), &((*outputs_19)));
    return;
}

fn select_vector_2( condition_2 : bool,  yes_2 : vec3<f32>,  no_2 : vec3<f32>) -> vec3<f32>
{
    var chosen_2 : vec3<f32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    return chosen_2;
}

fn fabric_of_0( face_1 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_1];
}

struct Vertex_0
{
     x_2 : f32,
     y_0 : f32,
     z_0 : f32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     u_0 : f32,
     v_0 : f32,
};

fn scene_vertex_0( first_17 : u32) -> Vertex_0
{
    var record_0 : Vertex_0;
    record_0.x_2 = (bitcast<f32>((scene_words_0[first_17])));
    record_0.y_0 = (bitcast<f32>((scene_words_0[first_17 + u32(1)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_17 + u32(2)])));
    record_0.normal_x_0 = (bitcast<f32>((scene_words_0[first_17 + u32(3)])));
    record_0.normal_y_0 = (bitcast<f32>((scene_words_0[first_17 + u32(4)])));
    record_0.normal_z_0 = (bitcast<f32>((scene_words_0[first_17 + u32(5)])));
    record_0.u_0 = (bitcast<f32>((scene_words_0[first_17 + u32(6)])));
    record_0.v_0 = (bitcast<f32>((scene_words_0[first_17 + u32(7)])));
    return record_0;
}

fn vertex_at_0( corner_0 : u32) -> Vertex_0
{
    return scene_vertex_0(frame_record_0.vertices_0 + u32(8) * scene_words_0[frame_record_0.corners_0 + corner_0]);
}

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.x_2, vertex_0.y_0, vertex_0.z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_1 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S123 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S124 : u32 = ((((_S123 >> ((((_S123 >> (u32(28)))) + u32(4))))) ^ (_S123))) * u32(277803737);
    return (((_S124 >> (u32(22)))) ^ (_S124));
}

fn hash_key_0( thread_0 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_0 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_0 : u32) -> u32
{
    return scramble_0(cell_0 + key_0);
}

fn uneven_corner_0( key_1 : u32,  cell_1 : u32) -> f32
{
    return f32(((hash_bits_0(key_1, cell_1)) >> (u32(9)))) * 2.384185791015625e-07f - 1.0f;
}

fn uneven_octave_0( key_2 : u32,  place_0 : vec2<f32>) -> f32
{
    var _S125 : vec2<f32> = floor(place_0);
    var _S126 : vec2<f32> = place_0 - _S125;
    var _S127 : vec2<f32> = _S126 * _S126 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S126);
    var _S128 : u32 = u32(i32(_S125.x)) * u32(65536) + u32(i32(_S125.y));
    var _S129 : f32 = _S127.x;
    return mix(mix(uneven_corner_0(key_2, _S128), uneven_corner_0(key_2, _S128 + u32(65536)), _S129), mix(uneven_corner_0(key_2, _S128 + u32(1)), uneven_corner_0(key_2, _S128 + u32(65537)), _S129), _S127.y);
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

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S130 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S130, - _S130, back_2));
}

fn no_numbers_0() -> Eight_0
{
    var numbers_1 : Eight_0;
    var _S131 : vec4<f32> = vec4<f32>(0.0f);
    numbers_1.low_0 = _S131;
    numbers_1.high_0 = _S131;
    return numbers_1;
}

fn eight_halves_0( packed_0 : vec4<u32>) -> Eight_0
{
    var numbers_2 : Eight_0;
    numbers_2.low_0 = vec4<f32>(unpack2x16float(packed_0.x), unpack2x16float(packed_0.y));
    numbers_2.high_0 = vec4<f32>(unpack2x16float(packed_0.z), unpack2x16float(packed_0.w));
    return numbers_2;
}

fn texel_numbers_0( first_18 : u32,  elements_1 : u32,  texel_0 : u32) -> Eight_0
{
    var _S132 : u32 = first_18 + texel_0 * elements_1;
    var _S133 : vec4<u32> = packed_numbers_0[_S132];
    if(elements_1 == u32(1))
    {
        return eight_halves_0(_S133);
    }
    var numbers_3 : Eight_0;
    numbers_3.low_0 = (bitcast<vec4<f32>>((_S133)));
    numbers_3.high_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S132 + u32(1)])));
    return numbers_3;
}

fn add_bilinear_0( first_19 : u32,  elements_2 : u32,  start_1 : u32,  columns_1 : u32,  rows_1 : u32,  uv_1 : vec2<f32>,  weight_0 : f32,  sums_5 : ptr<function, Eight_0>)
{
    var _S134 : vec2<f32> = uv_1 * vec2<f32>(f32(columns_1), f32(rows_1)) - vec2<f32>(0.5f);
    var _S135 : vec2<f32> = floor(_S134);
    var _S136 : vec2<f32> = _S134 - _S135;
    var _S137 : i32 = i32(_S135.x);
    var _S138 : i32 = i32(_S135.y);
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
        var _S139 : u32 = (tap_0 & (u32(1)));
        var _S140 : u32 = (tap_0 >> (u32(1)));
        var _S141 : Eight_0 = texel_numbers_0(first_19, elements_2, start_1 + ((u32(_S138 + i32(_S140)) & ((rows_1 - u32(1))))) * columns_1 + ((u32(_S137 + i32(_S139)) & ((columns_1 - u32(1))))));
        var _S142 : f32 = _S136.y;
        var _S143 : f32 = _S136.x;
        var _S144 : vec4<f32> = vec4<f32>((select(1.0f - _S142, _S142, _S140 != u32(0)) * select(1.0f - _S143, _S143, _S139 != u32(0)) * weight_0));
        (*sums_5).low_0 = (*sums_5).low_0 + _S144 * _S141.low_0;
        (*sums_5).high_0 = (*sums_5).high_0 + _S144 * _S141.high_0;
        tap_0 = tap_0 + u32(1);
    }
    return;
}

fn add_bilinear_1( first_20 : u32,  elements_3 : u32,  start_2 : u32,  columns_2 : u32,  rows_2 : u32,  uv_2 : vec2<f32>,  weight_1 : f32,  sums_6 : ptr<function, Eight_0>)
{
    var _S145 : vec2<f32> = uv_2 * vec2<f32>(f32(columns_2), f32(rows_2)) - vec2<f32>(0.5f);
    var _S146 : vec2<f32> = floor(_S145);
    var _S147 : vec2<f32> = _S145 - _S146;
    var _S148 : i32 = i32(_S146.x);
    var _S149 : i32 = i32(_S146.y);
    var tap_1 : u32 = u32(0);
    for(;;)
    {
        if(tap_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S150 : u32 = (tap_1 & (u32(1)));
        var _S151 : u32 = (tap_1 >> (u32(1)));
        var _S152 : Eight_0 = texel_numbers_0(first_20, elements_3, start_2 + ((u32(_S149 + i32(_S151)) & ((rows_2 - u32(1))))) * columns_2 + ((u32(_S148 + i32(_S150)) & ((columns_2 - u32(1))))));
        var _S153 : f32 = _S147.y;
        var _S154 : f32 = _S147.x;
        var _S155 : vec4<f32> = vec4<f32>((select(1.0f - _S153, _S153, _S151 != u32(0)) * select(1.0f - _S154, _S154, _S150 != u32(0)) * weight_1));
        (*sums_6).low_0 = (*sums_6).low_0 + _S155 * _S152.low_0;
        (*sums_6).high_0 = (*sums_6).high_0 + _S155 * _S152.high_0;
        tap_1 = tap_1 + u32(1);
    }
    return;
}

fn channel_0( numbers_4 : Eight_0,  k_0 : i32) -> f32
{
    var _S156 : i32 = (k_0 & (i32(3)));
    return select(numbers_4.high_0[_S156], numbers_4.low_0[_S156], k_0 < i32(4));
}

fn neumip_depth_0( model_0 : ptr<function, Neumip_std430_0>,  uv_3 : vec2<f32>,  view_1 : vec2<f32>,  face_2 : u32) -> f32
{
    var _S157 : u32 = words_0[(*model_0).levels_2 + u32(1)];
    var _S158 : u32 = words_0[(*model_0).levels_2 + u32(2)];
    var texel_1 : Eight_0 = no_numbers_0();
    add_bilinear_0((*model_0).offset_texels_0, (*model_0).texel_elements_0, face_2 * _S157 * _S158, _S157, _S158, fract(uv_3), 1.0f, &(texel_1));
    var inputs_24 : array<f32, i32(9)>;
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
        inputs_24[k_1] = channel_0(texel_1, k_1);
        k_1 = k_1 + i32(1);
    }
    inputs_24[i32(7)] = view_1.x;
    inputs_24[i32(8)] = view_1.y;
    var network_1 : MLP_0;
    network_1.weights_20.first_0 = (*model_0).offset_0;
    var depth_0 : array<f32, i32(1)>;
    MLP_evaluate_2(network_1, &(inputs_24), &(depth_0));
    return depth_0[i32(0)];
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S159 : u32 = (bitcast<u32>((x_3)));
    var m_0 : f32 = (bitcast<f32>(((((_S159 & (u32(8388607)))) | (u32(1056964608))))));
    var _S160 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S159 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S160);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S160) - 1.0f;
    var _S161 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S161 - exponent_0 * 0.00021219444170129f - 0.5f * _S161) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn within_repeat_0( uv_4 : vec2<f32>) -> vec2<f32>
{
    return clamp(fract(uv_4), vec2<f32>(0.0f), vec2<f32>(1.0f));
}

struct TexelPyramid_0
{
     first_21 : u32,
     elements_4 : u32,
     levels_4 : u32,
     last_level_3 : f32,
     face_texels_2 : u32,
};

fn TexelPyramid_add_level_0( this_4 : TexelPyramid_0,  place_1 : vec2<f32>,  level_1 : u32,  face_3 : u32,  weight_2 : f32,  sums_7 : ptr<function, Eight_0>)
{
    var _S162 : u32 = this_4.levels_4 + u32(3) * level_1;
    add_bilinear_1(this_4.first_21, this_4.elements_4, face_3 * this_4.face_texels_2 + words_0[_S162], words_0[_S162 + u32(1)], words_0[_S162 + u32(2)], place_1, weight_2, &((*sums_7)));
    return;
}

fn TexelPyramid_between_levels_0( this_5 : TexelPyramid_0,  uv_5 : vec2<f32>,  level_2 : f32,  face_4 : u32) -> Eight_0
{
    var _S163 : f32 = clamp(level_2, 0.0f, this_5.last_level_3);
    var _S164 : f32 = clamp(floor(_S163), 0.0f, max(this_5.last_level_3 - 1.0f, 0.0f));
    var _S165 : f32 = _S163 - _S164;
    var _S166 : vec2<f32> = within_repeat_0(uv_5);
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
        var _S167 : f32 = select(_S165, 1.0f - _S165, offset_1 == u32(0));
        if(_S167 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S166, u32(_S164) + offset_1, face_4, _S167, &(texel_2));
        }
        offset_1 = offset_1 + u32(1);
    }
    return texel_2;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S168 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S169 : f32 = floor(_S168 * 1.4426950216293335f + 0.5f);
    var _S170 : f32 = _S168 - _S169 * 0.693359375f + _S169 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S170 + 0.00139819993637502f) * _S170 + 0.00833345204591751f) * _S170 + 0.04166579619050026f) * _S170 + 0.1666666567325592f) * _S170 + 0.5f) * _S170 * _S170 + _S170 + 1.0f) * (bitcast<f32>(((u32(i32(_S169) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn neumip_hole_0( model_1 : ptr<function, Neumip_std430_0>,  texel_3 : Eight_0,  view_2 : vec2<f32>) -> f32
{
    var inputs_25 : array<f32, i32(9)>;
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
        inputs_25[k_2] = channel_0(texel_3, k_2);
        k_2 = k_2 + i32(1);
    }
    inputs_25[i32(7)] = view_2.x;
    inputs_25[i32(8)] = view_2.y;
    var network_2 : MLP_0;
    network_2.weights_20.first_0 = (*model_1).opacity_0;
    var opening_0 : array<f32, i32(1)>;
    MLP_evaluate_1(network_2, &(inputs_25), &(opening_0));
    return 1.0f / (1.0f + exponential_0(- clamp(opening_0[i32(0)], -30.0f, 30.0f)));
}

fn uniform_hash_0( thread_1 : u32,  cell_2 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_2)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_0 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S171 : u32 = pixel_0.x;
    var _S172 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S171, _S172, stream_2), uniform_hash_0(_S171, _S172, stream_2 + u32(1))) + vec2<f32>(f32((index_0 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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

fn choose_0( table_0 : u32,  count_1 : u32,  number_0 : f32) -> Choice_0
{
    var high_5 : u32 = count_1;
    var low_5 : u32 = u32(0);
    for(;;)
    {
        if((high_5 - low_5) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S173 : u32 = (low_5 + high_5) / u32(2);
        if((scene_number_0(table_0 + _S173)) <= number_0)
        {
            low_5 = _S173;
        }
        else
        {
            high_5 = _S173;
        }
    }
    var _S174 : u32 = table_0 + low_5;
    var _S175 : f32 = scene_number_0(_S174);
    var _S176 : f32 = scene_number_0(_S174 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_2 = low_5;
    choice_0.remainder_0 = saturate((number_0 - _S175) / max(_S176 - _S175, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_6 : f32) -> vec2<f32>
{
    var _S177 : f32 = floor(x_6 * 0.63661974668502808f + 0.5f);
    var _S178 : f32 = x_6 - _S177 * 1.5703125f - _S177 * 0.00048375129699707f - _S177 * 7.54979012640433211e-08f;
    var _S179 : f32 = _S178 * _S178;
    var _S180 : f32 = ((-0.00019515295571182f * _S179 + 0.00833216123282909f) * _S179 - 0.16666655242443085f) * _S179 * _S178 + _S178;
    var _S181 : f32 = ((0.00002443315679557f * _S179 - 0.00138873164542019f) * _S179 + 0.04166664555668831f) * _S179 * _S179 - 0.5f * _S179 + 1.0f;
    var _S182 : u32 = (u32(i32(_S177)) & (u32(3)));
    var _S183 : vec2<f32> = select_vector_1(((_S182 & (u32(1)))) != u32(0), vec2<f32>(_S181, _S180), vec2<f32>(_S180, _S181));
    var _S184 : f32 = _S183.x;
    var _S185 : f32 = _S183.y;
    return vec2<f32>(select(_S184, - _S184, ((_S182 & (u32(2)))) != u32(0)), select(_S185, - _S185, (((_S182 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_7 : f32,
     y_1 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_22 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_22];
    record_1.x_7 = (bitcast<f32>((scene_words_0[first_22 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_22 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_22 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_22 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_22 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_22 + u32(6)])));
    return record_1;
}

fn accumulate_0( index_3 : u32,  light_1 : vec4<f32>)
{
    var _S186 : f32 = layers_0[index_3].share_0;
    radiance_0[index_3] = radiance_0[index_3] + vec4<f32>(layers_0[index_3].share_0) * light_1;
    layers_0[index_3].share_0 = _S186 * (1.0f - light_1.w);
    return;
}

fn camera_right_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.right_x_0, frame_record_0.right_y_0, frame_record_0.right_z_0);
}

fn camera_up_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.up_x_0, frame_record_0.up_y_0, frame_record_0.up_z_0);
}

fn camera_forward_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.forward_x_0, frame_record_0.forward_y_0, frame_record_0.forward_z_0);
}

fn camera_origin_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.origin_x_0, frame_record_0.origin_y_0, frame_record_0.origin_z_0);
}

fn uneven_shift_0( _S187 : u32,  _S188 : u32,  _S189 : u32,  _S190 : vec2<f32>) -> f32
{
    var _S191 : f32 = families_0[_S189].period_0 / families_0[_S189].count_0;
    var _S192 : u32 = hash_key_0(_S188, ((fabrics_0[_S187].seed_0) ^ (u32(625341585))));
    var _S193 : vec2<f32> = vec2<f32>(_S190.x, _S190.y / 4.0f) / vec2<f32>(_S191);
    return 0.20000000298023224f * sqrt(families_0[_S189].slub_0) * _S191 * (uneven_octave_0(_S192, _S193) * 0.66666668653488159f + uneven_octave_0(_S192 + u32(1), vec2<f32>(2.0f) * _S193 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S194 : u32,  _S195 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S194].has_detail_0) == u32(0), _S195, _S195 + vec2<f32>(uneven_shift_0(_S194, u32(0), fabrics_0[_S194].warp_0, _S195), uneven_shift_0(_S194, u32(1), fabrics_0[_S194].weft_0, _S195.yx)));
}

fn face_point_0( _S196 : u32,  _S197 : u32,  _S198 : f32,  _S199 : f32) -> VisiblePoint_0
{
    var _S200 : u32 = u32(3) * _S197;
    var _S201 : Vertex_0 = vertex_at_0(_S200);
    var _S202 : Vertex_0 = vertex_at_0(_S200 + u32(1));
    var _S203 : Vertex_0 = vertex_at_0(_S200 + u32(2));
    var _S204 : vec3<f32> = position_of_0(_S201);
    var _S205 : vec3<f32> = position_of_0(_S202) - _S204;
    var _S206 : vec3<f32> = position_of_0(_S203) - _S204;
    var _S207 : f32 = _S202.u_0 - _S201.u_0;
    var _S208 : f32 = _S202.v_0 - _S201.v_0;
    var _S209 : vec2<f32> = vec2<f32>(_S207, _S208);
    var _S210 : f32 = _S203.u_0 - _S201.u_0;
    var _S211 : f32 = _S203.v_0 - _S201.v_0;
    var _S212 : vec2<f32> = vec2<f32>(_S210, _S211);
    var _S213 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S207 * _S211 - _S208 * _S210) < 0.0f));
    var _S214 : vec3<f32> = _S213 * (vec3<f32>(_S211) * _S205 - vec3<f32>(_S208) * _S206);
    var _S215 : vec3<f32> = _S213 * (vec3<f32>(_S207) * _S206 - vec3<f32>(_S210) * _S205);
    var point_1 : VisiblePoint_0;
    var _S216 : vec3<f32> = vec3<f32>(_S198);
    var _S217 : vec3<f32> = vec3<f32>(_S199);
    var _S218 : vec3<f32> = normalize(vec3<f32>((1.0f - _S198 - _S199)) * normal_of_0(_S201) + _S216 * normal_of_0(_S202) + _S217 * normal_of_0(_S203));
    point_1.normal_0 = _S218;
    var _S219 : vec3<f32> = normalize(_S214 - _S218 * vec3<f32>(dot(_S218, _S214)));
    point_1.axis_x_0 = _S219;
    point_1.axis_y_0 = cross(_S218, _S219);
    var _S220 : vec3<f32> = normalize(cross(_S205, _S206));
    point_1.face_normal_0 = select_vector_2((dot(_S220, _S218)) < 0.0f, (vec3<f32>(0) - _S220), _S220);
    point_1.position_0 = _S204 + _S216 * _S205 + _S217 * _S206;
    point_1.view_0 = _S218;
    var _S221 : vec2<f32> = vec2<f32>(_S201.u_0, _S201.v_0) + vec2<f32>(_S198) * _S209 + vec2<f32>(_S199) * _S212;
    point_1.uv_0 = _S221;
    var _S222 : bool = (dot(cross(_S214, _S215), _S218)) < 0.0f;
    var _S223 : vec2<f32> = vec2<f32>(fabrics_0[_S196].uv_width_0, select(fabrics_0[_S196].uv_height_0, - fabrics_0[_S196].uv_height_0, _S222));
    point_1.draft_per_uv_0 = _S223;
    point_1.draft_0 = uneven_place_0(_S196, _S221 * _S223 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S196].uv_height_0, _S222)));
    var _S224 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S224;
    point_1.draft_dy_0 = _S224;
    return point_1;
}

fn visible_point_0( _S225 : u32,  _S226 : u32,  _S227 : vec2<u32>) -> VisiblePoint_0
{
    var _S228 : u32 = u32(3) * _S226;
    var _S229 : Vertex_0 = vertex_at_0(_S228);
    var _S230 : Vertex_0 = vertex_at_0(_S228 + u32(1));
    var _S231 : Vertex_0 = vertex_at_0(_S228 + u32(2));
    var _S232 : vec3<f32> = position_of_0(_S229);
    var _S233 : vec3<f32> = position_of_0(_S230) - _S232;
    var _S234 : vec3<f32> = position_of_0(_S231) - _S232;
    var _S235 : vec3<f32> = cross(_S233, _S234);
    var _S236 : f32 = f32(frame_record_0.width_0);
    var _S237 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S236));
    var _S238 : f32 = f32(frame_record_0.height_0);
    var _S239 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S238));
    var _S240 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S227.x) + 0.5f - 0.5f * _S236)) * _S237 + vec3<f32>((f32(_S227.y) + 0.5f - 0.5f * _S238)) * _S239;
    var _S241 : f32 = dot(_S240, _S235);
    var _S242 : f32 = 1.0f / select(1.00000000317107685e-30f, _S241, (abs(_S241)) > 1.00000000317107685e-30f);
    var _S243 : vec3<f32> = _S232 - camera_origin_0();
    var _S244 : vec3<f32> = vec3<f32>((dot(_S243, _S235) * _S242));
    var _S245 : vec3<f32> = _S240 * _S244 - _S243;
    var _S246 : vec3<f32> = _S244 * (_S237 - _S240 * vec3<f32>((dot(_S237, _S235) * _S242)));
    var _S247 : vec3<f32> = _S244 * (_S239 - _S240 * vec3<f32>((dot(_S239, _S235) * _S242)));
    var _S248 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S235), 1.00000000317107685e-30f)));
    var _S249 : vec3<f32> = cross(_S234, _S235) * _S248;
    var _S250 : vec3<f32> = cross(_S235, _S233) * _S248;
    var _S251 : vec2<f32> = vec2<f32>(_S230.u_0 - _S229.u_0, _S230.v_0 - _S229.v_0);
    var _S252 : vec2<f32> = vec2<f32>(_S231.u_0 - _S229.u_0, _S231.v_0 - _S229.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S225, _S226, dot(_S245, _S249), dot(_S245, _S250));
    point_2.position_0 = _S232 + _S245;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S240));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S246, _S249)) * _S251 + vec2<f32>(dot(_S246, _S250)) * _S252) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S247, _S249)) * _S251 + vec2<f32>(dot(_S247, _S250)) * _S252) * point_2.draft_per_uv_0;
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
     latent_1 : array<f32, i32(7)>,
     view_3 : vec2<f32>,
     back_3 : bool,
     hole_0 : f32,
};

fn neumip_view_0( _S253 : u32,  _S254 : Footprint_0,  _S255 : vec3<f32>,  _S256 : ptr<function, NeumipView_0>)
{
    var _S257 : Neumip_std430_0 = fabrics_0[_S253].neumip_0;
    var _S258 : bool = (_S255.z) < 0.0f;
    var _S259 : u32 = select(u32(0), _S257.back_0, _S258);
    var _S260 : vec3<f32> = to_face_frame_0(_S255, _S258);
    var uv_6 : vec2<f32> = _S254.centre_0 * vec2<f32>(_S257.repeats_per_x_0, _S257.repeats_per_y_0);
    var uv_7 : vec2<f32>;
    if((_S257.has_offset_0) != u32(0))
    {
        var _S261 : vec2<f32> = _S260.xy;
        var _S262 : f32 = neumip_depth_0(&(_S257), uv_6, _S261, _S259);
        uv_7 = uv_6 + vec2<f32>((_S262 / max(_S260.z, 0.60000002384185791f))) * _S261 * vec2<f32>(_S257.unit_x_0, _S257.unit_y_0);
    }
    else
    {
        uv_7 = uv_6;
    }
    var _S263 : f32 = sqrt(abs(_S254.dx_0.x * _S254.dy_0.y - _S254.dx_0.y * _S254.dy_0.x)) * _S257.texels_per_mm_0;
    var pyramid_0 : TexelPyramid_0;
    pyramid_0.first_21 = _S257.features_0;
    pyramid_0.elements_4 = _S257.texel_elements_0;
    pyramid_0.levels_4 = _S257.levels_2;
    pyramid_0.last_level_3 = _S257.last_level_1;
    pyramid_0.face_texels_2 = _S257.face_texels_0;
    var _S264 : Eight_0 = TexelPyramid_between_levels_0(pyramid_0, uv_7, binary_logarithm_0(max(_S263, 9.99999971718068537e-10f)), _S259);
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
        (*_S256).latent_1[k_3] = channel_0(_S264, k_3);
        k_3 = k_3 + i32(1);
    }
    var _S265 : vec2<f32> = _S260.xy;
    (*_S256).view_3 = _S265;
    (*_S256).back_3 = _S258;
    var _S266 : f32;
    if((_S257.has_holes_0) != u32(0))
    {
        var _S267 : f32 = neumip_hole_0(&(_S257), _S264, _S265);
        _S266 = _S267;
    }
    else
    {
        _S266 = 0.0f;
    }
    (*_S256).hole_0 = _S266;
    return;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S268 : u32,  _S269 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S268 * frame_record_0.height_0 + _S269.y) * frame_record_0.width_0 + _S269.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_0 : f32,
};

fn environment_texel_0( _S270 : u32,  _S271 : u32) -> vec3<f32>
{
    var _S272 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S270 * frame_record_0.environment_columns_0 + _S271);
    return vec3<f32>(scene_number_0(_S272), scene_number_0(_S272 + u32(1)), scene_number_0(_S272 + u32(2)));
}

fn sample_environment_0( _S273 : vec2<f32>,  _S274 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S275 : u32 = frame_record_0.environment_rows_0;
    var _S276 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S273.y);
    var _S277 : u32 = frame_record_0.environment_columns_0;
    var _S278 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S276.index_2 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S273.x);
    var _S279 : vec3<f32> = environment_texel_0(_S276.index_2, _S278.index_2);
    (*_S274) = _S279 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S279), 9.99999968265522539e-21f)));
    var _S280 : f32 = 3.14159274101257324f / f32(_S275);
    var _S281 : f32 = mix(sine_cosine_0(f32(_S276.index_2) * _S280).y, sine_cosine_0(f32(_S276.index_2 + u32(1)) * _S280).y, _S276.remainder_0);
    var _S282 : f32 = sqrt(max(1.0f - _S281 * _S281, 0.0f));
    var _S283 : vec2<f32> = sine_cosine_0((f32(_S278.index_2) + _S278.remainder_0) * (6.28318548202514648f / f32(_S277)));
    var _S284 : f32 = _S282 * _S283.x;
    var _S285 : f32 = - _S282 * _S283.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S284 + frame_record_0.environment_sine_0 * _S285, _S281, frame_record_0.environment_cosine_0 * _S285 - frame_record_0.environment_sine_0 * _S284);
}

fn light_sample_0( _S286 : u32,  _S287 : vec2<u32>,  _S288 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    var _S289 : u32 = frame_record_0.lights_0;
    if(_S286 >= (frame_record_0.lights_0))
    {
        var weight_3 : vec3<f32>;
        var _S290 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S287, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S286 - _S289), u32(3)), &(weight_3));
        sample_0.towards_0 = _S290;
        sample_0.irradiance_1 = weight_3 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S291 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S286);
    sample_0.irradiance_1 = vec3<f32>(_S291.red_0, _S291.green_0, _S291.blue_0);
    sample_0.towards_0 = vec3<f32>(_S291.x_7, _S291.y_1, _S291.z_1);
    if((_S291.is_point_0) != u32(0))
    {
        var _S292 : vec3<f32> = sample_0.towards_0 - _S288;
        var _S293 : f32 = max(square_0(_S292), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S293);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S293);
        sample_0.towards_0 = normalize(_S292);
    }
    return sample_0;
}

fn neumip_value_0( _S294 : u32,  _S295 : ptr<function, NeumipView_0>,  _S296 : vec3<f32>) -> vec3<f32>
{
    var _S297 : vec3<f32> = to_face_frame_0(_S296, (*_S295).back_3);
    var _S298 : f32 = _S297.z;
    var _S299 : Neumip_std430_0 = fabrics_0[_S294].neumip_0;
    var _S300 : bool = ((_S298 < 0.0f) & (((fabrics_0[_S294].neumip_0.transmits_0) != u32(0))));
    if(((_S298 <= 0.0f) & ((!_S300))))
    {
        return vec3<f32>(0.0f);
    }
    var inputs_26 : array<f32, i32(11)>;
    var k_4 : i32 = i32(0);
    for(;;)
    {
        if(k_4 < i32(7))
        {
        }
        else
        {
            break;
        }
        inputs_26[k_4] = (*_S295).latent_1[k_4];
        k_4 = k_4 + i32(1);
    }
    inputs_26[i32(7)] = _S297.x;
    inputs_26[i32(8)] = _S297.y;
    inputs_26[i32(9)] = (*_S295).view_3.x;
    inputs_26[i32(10)] = (*_S295).view_3.y;
    var network_3 : MLP_0;
    network_3.weights_20.first_0 = select(_S299.decoder_0, _S299.transmission_0, _S300);
    var outputs_20 : array<f32, i32(3)>;
    MLP_evaluate_0(network_3, &(inputs_26), &(outputs_20));
    return max(vec3<f32>(outputs_20[i32(0)], outputs_20[i32(1)], outputs_20[i32(2)]), vec3<f32>(0.0f)) * vec3<f32>(0.31830987334251404f);
}

fn light_of_neumip_0( _S301 : u32,  _S302 : VisiblePoint_0,  _S303 : vec2<u32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S302.draft_0;
    footprint_0.dx_0 = _S302.draft_dx_0;
    footprint_0.dy_0 = _S302.draft_dy_0;
    var seen_0 : NeumipView_0;
    neumip_view_0(_S301, footprint_0, to_local_0(_S302, _S302.view_0), &(seen_0));
    var _S304 : vec3<f32> = vec3<f32>(0.0f);
    var number_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S304;
    for(;;)
    {
        if(number_1 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S305 : f32 = visibility_at_0(number_1, _S303);
        if(_S305 <= 0.0f)
        {
            number_1 = number_1 + u32(1);
            continue;
        }
        var _S306 : LightSample_0 = light_sample_0(number_1, _S303, _S302.position_0);
        var _S307 : vec3<f32> = vec3<f32>(_S305) * _S306.irradiance_1;
        var _S308 : vec3<f32> = neumip_value_0(_S301, &(seen_0), to_local_0(_S302, _S306.towards_0));
        radiance_1 = radiance_1 + _S307 * _S308;
        number_1 = number_1 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - seen_0.hole_0);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_neumip(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S309 : u32 = id_0.x;
    var _S310 : bool;
    if(_S309 >= (frame_record_0.width_0))
    {
        _S310 = true;
    }
    else
    {
        _S310 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S310)
    {
        return;
    }
    var _S311 : u32 = id_0.y * frame_record_0.width_0 + _S309;
    var _S312 : u32 = layers_0[_S311].face_0;
    if((layers_0[_S311].face_0) == u32(0))
    {
        return;
    }
    var _S313 : u32 = _S312 - u32(1);
    var _S314 : u32 = fabric_of_0(_S313);
    var _S315 : vec2<u32> = id_0.xy;
    accumulate_0(_S311, light_of_neumip_0(_S314, visible_point_0(_S314, _S313, _S315), _S315));
    return;
}

