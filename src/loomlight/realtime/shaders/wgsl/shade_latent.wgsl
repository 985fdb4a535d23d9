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

fn select_vector_0( condition_0 : bool,  yes_0 : vec4<f32>,  no_0 : vec4<f32>) -> vec4<f32>
{
    var chosen_0 : vec4<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    chosen_0[i32(3)] = select(no_0[i32(3)], yes_0[i32(3)], condition_0);
    return chosen_0;
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
            (*outputs_0)[output_0] = Relu_apply_0(_S15[i32(0)] + _S16);
        }
        var _S17 : i32 = output_0 + i32(1);
        if(_S17 < i32(64))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S17];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S17] = Relu_apply_0(_S15[i32(1)] + _S16);
        }
        var _S18 : i32 = output_0 + i32(2);
        if(_S18 < i32(64))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S18];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S18] = Relu_apply_0(_S15[i32(2)] + _S16);
        }
        var _S19 : i32 = output_0 + i32(3);
        if(_S19 < i32(64))
        {
            if(adds_0)
            {
                _S16 = (*outputs_0)[_S19];
            }
            else
            {
                _S16 = 0.0f;
            }
            (*outputs_0)[_S19] = Relu_apply_0(_S15[i32(3)] + _S16);
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
    var _S20 : u32 = first_2 + u32(whole_parts_0(i32(1)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S21 : bool = output_1 < i32(3);
        if(_S21)
        {
        }
        else
        {
            break;
        }
        var _S22 : u32 = u32(output_1);
        var _S23 : Eight_0 = FloatWeights_eight_0(weights_2, first_2 + _S22 / u32(8));
        var _S24 : vec4<f32> = tile_product_0(weights_2, _S20 + _S22 * u32(8), &((*inputs_2)));
        var _S25 : vec4<f32> = _S24 + select_vector_0(((output_1 & (i32(4)))) != i32(0), _S23.high_0, _S23.low_0);
        var _S26 : f32;
        if(_S21)
        {
            if(adds_1)
            {
                _S26 = (*outputs_1)[output_1];
            }
            else
            {
                _S26 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S25[i32(0)] + _S26);
        }
        var _S27 : i32 = output_1 + i32(1);
        if(_S27 < i32(3))
        {
            if(adds_1)
            {
                _S26 = (*outputs_1)[_S27];
            }
            else
            {
                _S26 = 0.0f;
            }
            (*outputs_1)[_S27] = Identity_apply_0(_S25[i32(1)] + _S26);
        }
        var _S28 : i32 = output_1 + i32(2);
        if(_S28 < i32(3))
        {
            if(adds_1)
            {
                _S26 = (*outputs_1)[_S28];
            }
            else
            {
                _S26 = 0.0f;
            }
            (*outputs_1)[_S28] = Identity_apply_0(_S25[i32(2)] + _S26);
        }
        var _S29 : i32 = output_1 + i32(3);
        if(_S29 < i32(3))
        {
            if(adds_1)
            {
                _S26 = (*outputs_1)[_S29];
            }
            else
            {
                _S26 = 0.0f;
            }
            (*outputs_1)[_S29] = Identity_apply_0(_S25[i32(3)] + _S26);
        }
        output_1 = output_1 + i32(4);
    }
    return;
}

fn tile_product_1( weights_3 : FloatWeights_0,  row_1 : u32,  inputs_3 : ptr<function, array<f32, i32(24)>>) -> vec4<f32>
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
        var _S30 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_3)[_S30];
        high_2[i32(0)] = (*inputs_3)[_S30 + i32(4)];
        var _S31 : i32 = _S30 + i32(1);
        low_2[i32(1)] = (*inputs_3)[_S31];
        high_2[i32(1)] = (*inputs_3)[_S31 + i32(4)];
        var _S32 : i32 = _S30 + i32(2);
        low_2[i32(2)] = (*inputs_3)[_S32];
        high_2[i32(2)] = (*inputs_3)[_S32 + i32(4)];
        var _S33 : i32 = _S30 + i32(3);
        low_2[i32(3)] = (*inputs_3)[_S33];
        high_2[i32(3)] = (*inputs_3)[_S33 + i32(4)];
        var _S34 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + column_1);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S34.low_0, low_2) + dot(_S34.high_0, high_2));
        var _S35 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + u32(3) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S35.low_0, low_2) + dot(_S35.high_0, high_2));
        var _S36 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + u32(6) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S36.low_0, low_2) + dot(_S36.high_0, high_2));
        var _S37 : Eight_0 = FloatWeights_eight_0(weights_3, row_1 + u32(9) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S37.low_0, low_2) + dot(_S37.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn dense_part_2( weights_4 : FloatWeights_0,  first_3 : u32,  adds_2 : bool,  inputs_4 : ptr<function, array<f32, i32(24)>>,  outputs_2 : ptr<function, array<f32, i32(64)>>)
{
    var _S38 : u32 = first_3 + u32(whole_parts_0(i32(8)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S39 : bool = output_2 < i32(64);
        if(_S39)
        {
        }
        else
        {
            break;
        }
        var _S40 : u32 = u32(output_2);
        var _S41 : Eight_0 = FloatWeights_eight_0(weights_4, first_3 + _S40 / u32(8));
        var _S42 : vec4<f32> = tile_product_1(weights_4, _S38 + _S40 * u32(3), &((*inputs_4)));
        var _S43 : vec4<f32> = _S42 + select_vector_0(((output_2 & (i32(4)))) != i32(0), _S41.high_0, _S41.low_0);
        var _S44 : f32;
        if(_S39)
        {
            if(adds_2)
            {
                _S44 = (*outputs_2)[output_2];
            }
            else
            {
                _S44 = 0.0f;
            }
            (*outputs_2)[output_2] = Relu_apply_0(_S43[i32(0)] + _S44);
        }
        var _S45 : i32 = output_2 + i32(1);
        if(_S45 < i32(64))
        {
            if(adds_2)
            {
                _S44 = (*outputs_2)[_S45];
            }
            else
            {
                _S44 = 0.0f;
            }
            (*outputs_2)[_S45] = Relu_apply_0(_S43[i32(1)] + _S44);
        }
        var _S46 : i32 = output_2 + i32(2);
        if(_S46 < i32(64))
        {
            if(adds_2)
            {
                _S44 = (*outputs_2)[_S46];
            }
            else
            {
                _S44 = 0.0f;
            }
            (*outputs_2)[_S46] = Relu_apply_0(_S43[i32(2)] + _S44);
        }
        var _S47 : i32 = output_2 + i32(3);
        if(_S47 < i32(64))
        {
            if(adds_2)
            {
                _S44 = (*outputs_2)[_S47];
            }
            else
            {
                _S44 = 0.0f;
            }
            (*outputs_2)[_S47] = Relu_apply_0(_S43[i32(3)] + _S44);
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

fn dense_2( weights_7 : FloatWeights_0,  first_6 : u32,  adds_5 : bool,  inputs_7 : ptr<function, array<f32, i32(24)>>,  outputs_5 : ptr<function, array<f32, i32(64)>>)
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

fn MLP_evaluate_0( this_1 : MLP_0,  inputs_9 : ptr<function, array<f32, i32(24)>>,  outputs_7 : ptr<function, array<f32, i32(3)>>)
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
        var _S48 : i32 = layer_size_0(i32(64), i32(64));
        var _S49 : u32 = u32(layer_size_0(i32(24), i32(64)) + (layer_0 - i32(1)) * _S48);
        dense_0(this_1.weights_8, _S49, false, &(even_0), &(odd_0));
        if((layer_0 + i32(1)) < i32(3))
        {
            dense_0(this_1.weights_8, _S49 + u32(_S48), false, &(odd_0), &(even_0));
        }
        layer_0 = layer_0 + i32(2);
    }
    var _S50 : u32 = u32(layer_size_0(i32(24), i32(64)) + i32(2) * layer_size_0(i32(64), i32(64)));
    dense_1(this_1.weights_8, _S50, false, &(even_0), &((*outputs_7)));
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
        var _S51 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_10)[_S51];
        high_3[i32(0)] = (*inputs_10)[_S51 + i32(4)];
        var _S52 : i32 = _S51 + i32(1);
        low_3[i32(1)] = (*inputs_10)[_S52];
        high_3[i32(1)] = (*inputs_10)[_S52 + i32(4)];
        var _S53 : i32 = _S51 + i32(2);
        low_3[i32(2)] = (*inputs_10)[_S53];
        high_3[i32(2)] = (*inputs_10)[_S53 + i32(4)];
        var _S54 : i32 = _S51 + i32(3);
        low_3[i32(3)] = (*inputs_10)[_S54];
        high_3[i32(3)] = (*inputs_10)[_S54 + i32(4)];
        var _S55 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + column_2);
        sums_3[i32(0)] = sums_3[i32(0)] + (dot(_S55.low_0, low_3) + dot(_S55.high_0, high_3));
        var _S56 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + u32(4) + column_2);
        sums_3[i32(1)] = sums_3[i32(1)] + (dot(_S56.low_0, low_3) + dot(_S56.high_0, high_3));
        var _S57 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + u32(8) + column_2);
        sums_3[i32(2)] = sums_3[i32(2)] + (dot(_S57.low_0, low_3) + dot(_S57.high_0, high_3));
        var _S58 : Eight_0 = FloatWeights_eight_0(weights_9, row_2 + u32(12) + column_2);
        sums_3[i32(3)] = sums_3[i32(3)] + (dot(_S58.low_0, low_3) + dot(_S58.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_3;
}

fn dense_part_3( weights_10 : FloatWeights_0,  first_7 : u32,  adds_6 : bool,  inputs_11 : ptr<function, array<f32, i32(32)>>,  outputs_8 : ptr<function, array<f32, i32(32)>>)
{
    var _S59 : u32 = first_7 + u32(whole_parts_0(i32(4)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S60 : bool = output_3 < i32(32);
        if(_S60)
        {
        }
        else
        {
            break;
        }
        var _S61 : u32 = u32(output_3);
        var _S62 : Eight_0 = FloatWeights_eight_0(weights_10, first_7 + _S61 / u32(8));
        var _S63 : vec4<f32> = tile_product_2(weights_10, _S59 + _S61 * u32(4), &((*inputs_11)));
        var _S64 : vec4<f32> = _S63 + select_vector_0(((output_3 & (i32(4)))) != i32(0), _S62.high_0, _S62.low_0);
        var _S65 : f32;
        if(_S60)
        {
            if(adds_6)
            {
                _S65 = (*outputs_8)[output_3];
            }
            else
            {
                _S65 = 0.0f;
            }
            (*outputs_8)[output_3] = Relu_apply_0(_S64[i32(0)] + _S65);
        }
        var _S66 : i32 = output_3 + i32(1);
        if(_S66 < i32(32))
        {
            if(adds_6)
            {
                _S65 = (*outputs_8)[_S66];
            }
            else
            {
                _S65 = 0.0f;
            }
            (*outputs_8)[_S66] = Relu_apply_0(_S64[i32(1)] + _S65);
        }
        var _S67 : i32 = output_3 + i32(2);
        if(_S67 < i32(32))
        {
            if(adds_6)
            {
                _S65 = (*outputs_8)[_S67];
            }
            else
            {
                _S65 = 0.0f;
            }
            (*outputs_8)[_S67] = Relu_apply_0(_S64[i32(2)] + _S65);
        }
        var _S68 : i32 = output_3 + i32(3);
        if(_S68 < i32(32))
        {
            if(adds_6)
            {
                _S65 = (*outputs_8)[_S68];
            }
            else
            {
                _S65 = 0.0f;
            }
            (*outputs_8)[_S68] = Relu_apply_0(_S64[i32(3)] + _S65);
        }
        output_3 = output_3 + i32(4);
    }
    return;
}

fn dense_part_4( weights_11 : FloatWeights_0,  first_8 : u32,  adds_7 : bool,  inputs_12 : ptr<function, array<f32, i32(32)>>,  outputs_9 : ptr<function, array<f32, i32(3)>>)
{
    var _S69 : u32 = first_8 + u32(whole_parts_0(i32(1)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S70 : bool = output_4 < i32(3);
        if(_S70)
        {
        }
        else
        {
            break;
        }
        var _S71 : u32 = u32(output_4);
        var _S72 : Eight_0 = FloatWeights_eight_0(weights_11, first_8 + _S71 / u32(8));
        var _S73 : vec4<f32> = tile_product_2(weights_11, _S69 + _S71 * u32(4), &((*inputs_12)));
        var _S74 : vec4<f32> = _S73 + select_vector_0(((output_4 & (i32(4)))) != i32(0), _S72.high_0, _S72.low_0);
        var _S75 : f32;
        if(_S70)
        {
            if(adds_7)
            {
                _S75 = (*outputs_9)[output_4];
            }
            else
            {
                _S75 = 0.0f;
            }
            (*outputs_9)[output_4] = Identity_apply_0(_S74[i32(0)] + _S75);
        }
        var _S76 : i32 = output_4 + i32(1);
        if(_S76 < i32(3))
        {
            if(adds_7)
            {
                _S75 = (*outputs_9)[_S76];
            }
            else
            {
                _S75 = 0.0f;
            }
            (*outputs_9)[_S76] = Identity_apply_0(_S74[i32(1)] + _S75);
        }
        var _S77 : i32 = output_4 + i32(2);
        if(_S77 < i32(3))
        {
            if(adds_7)
            {
                _S75 = (*outputs_9)[_S77];
            }
            else
            {
                _S75 = 0.0f;
            }
            (*outputs_9)[_S77] = Identity_apply_0(_S74[i32(2)] + _S75);
        }
        var _S78 : i32 = output_4 + i32(3);
        if(_S78 < i32(3))
        {
            if(adds_7)
            {
                _S75 = (*outputs_9)[_S78];
            }
            else
            {
                _S75 = 0.0f;
            }
            (*outputs_9)[_S78] = Identity_apply_0(_S74[i32(3)] + _S75);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn dense_part_5( weights_12 : FloatWeights_0,  first_9 : u32,  adds_8 : bool,  inputs_13 : ptr<function, array<f32, i32(24)>>,  outputs_10 : ptr<function, array<f32, i32(32)>>)
{
    var _S79 : u32 = first_9 + u32(whole_parts_0(i32(4)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S80 : bool = output_5 < i32(32);
        if(_S80)
        {
        }
        else
        {
            break;
        }
        var _S81 : u32 = u32(output_5);
        var _S82 : Eight_0 = FloatWeights_eight_0(weights_12, first_9 + _S81 / u32(8));
        var _S83 : vec4<f32> = tile_product_1(weights_12, _S79 + _S81 * u32(3), &((*inputs_13)));
        var _S84 : vec4<f32> = _S83 + select_vector_0(((output_5 & (i32(4)))) != i32(0), _S82.high_0, _S82.low_0);
        var _S85 : f32;
        if(_S80)
        {
            if(adds_8)
            {
                _S85 = (*outputs_10)[output_5];
            }
            else
            {
                _S85 = 0.0f;
            }
            (*outputs_10)[output_5] = Relu_apply_0(_S84[i32(0)] + _S85);
        }
        var _S86 : i32 = output_5 + i32(1);
        if(_S86 < i32(32))
        {
            if(adds_8)
            {
                _S85 = (*outputs_10)[_S86];
            }
            else
            {
                _S85 = 0.0f;
            }
            (*outputs_10)[_S86] = Relu_apply_0(_S84[i32(1)] + _S85);
        }
        var _S87 : i32 = output_5 + i32(2);
        if(_S87 < i32(32))
        {
            if(adds_8)
            {
                _S85 = (*outputs_10)[_S87];
            }
            else
            {
                _S85 = 0.0f;
            }
            (*outputs_10)[_S87] = Relu_apply_0(_S84[i32(2)] + _S85);
        }
        var _S88 : i32 = output_5 + i32(3);
        if(_S88 < i32(32))
        {
            if(adds_8)
            {
                _S85 = (*outputs_10)[_S88];
            }
            else
            {
                _S85 = 0.0f;
            }
            (*outputs_10)[_S88] = Relu_apply_0(_S84[i32(3)] + _S85);
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

fn dense_5( weights_15 : FloatWeights_0,  first_12 : u32,  adds_11 : bool,  inputs_16 : ptr<function, array<f32, i32(24)>>,  outputs_13 : ptr<function, array<f32, i32(32)>>)
{
    dense_part_5(weights_15, first_12, adds_11, &((*inputs_16)), &((*outputs_13)));
    return;
}

fn MLP_evaluate_1( this_2 : MLP_0,  inputs_17 : ptr<function, array<f32, i32(24)>>,  outputs_14 : ptr<function, array<f32, i32(3)>>)
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
        var _S89 : i32 = layer_size_0(i32(32), i32(32));
        var _S90 : u32 = u32(layer_size_0(i32(24), i32(32)) + (layer_1 - i32(1)) * _S89);
        dense_3(this_2.weights_8, _S90, false, &(even_1), &(odd_1));
        if((layer_1 + i32(1)) < i32(2))
        {
            dense_3(this_2.weights_8, _S90 + u32(_S89), false, &(odd_1), &(even_1));
        }
        layer_1 = layer_1 + i32(2);
    }
    var _S91 : u32 = u32(layer_size_0(i32(24), i32(32)) + layer_size_0(i32(32), i32(32)));
    dense_4(this_2.weights_8, _S91, false, &(odd_1), &((*outputs_14)));
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
        var _S92 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_18)[_S92];
        high_4[i32(0)] = (*inputs_18)[_S92 + i32(4)];
        var _S93 : i32 = _S92 + i32(1);
        low_4[i32(1)] = (*inputs_18)[_S93];
        high_4[i32(1)] = (*inputs_18)[_S93 + i32(4)];
        var _S94 : i32 = _S92 + i32(2);
        low_4[i32(2)] = (*inputs_18)[_S94];
        high_4[i32(2)] = (*inputs_18)[_S94 + i32(4)];
        var _S95 : i32 = _S92 + i32(3);
        low_4[i32(3)] = (*inputs_18)[_S95];
        high_4[i32(3)] = (*inputs_18)[_S95 + i32(4)];
        var _S96 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S96.low_0, low_4) + dot(_S96.high_0, high_4));
        var _S97 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + u32(2) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S97.low_0, low_4) + dot(_S97.high_0, high_4));
        var _S98 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + u32(4) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S98.low_0, low_4) + dot(_S98.high_0, high_4));
        var _S99 : Eight_0 = FloatWeights_eight_0(weights_16, row_3 + u32(6) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S99.low_0, low_4) + dot(_S99.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_6( weights_17 : FloatWeights_0,  first_13 : u32,  adds_12 : bool,  inputs_19 : ptr<function, array<f32, i32(16)>>,  outputs_15 : ptr<function, array<f32, i32(16)>>)
{
    var _S100 : u32 = first_13 + u32(whole_parts_0(i32(2)));
    var output_6 : i32 = i32(0);
    for(;;)
    {
        var _S101 : bool = output_6 < i32(16);
        if(_S101)
        {
        }
        else
        {
            break;
        }
        var _S102 : u32 = u32(output_6);
        var _S103 : Eight_0 = FloatWeights_eight_0(weights_17, first_13 + _S102 / u32(8));
        var _S104 : vec4<f32> = tile_product_3(weights_17, _S100 + _S102 * u32(2), &((*inputs_19)));
        var _S105 : vec4<f32> = _S104 + select_vector_0(((output_6 & (i32(4)))) != i32(0), _S103.high_0, _S103.low_0);
        var _S106 : f32;
        if(_S101)
        {
            if(adds_12)
            {
                _S106 = (*outputs_15)[output_6];
            }
            else
            {
                _S106 = 0.0f;
            }
            (*outputs_15)[output_6] = Relu_apply_0(_S105[i32(0)] + _S106);
        }
        var _S107 : i32 = output_6 + i32(1);
        if(_S107 < i32(16))
        {
            if(adds_12)
            {
                _S106 = (*outputs_15)[_S107];
            }
            else
            {
                _S106 = 0.0f;
            }
            (*outputs_15)[_S107] = Relu_apply_0(_S105[i32(1)] + _S106);
        }
        var _S108 : i32 = output_6 + i32(2);
        if(_S108 < i32(16))
        {
            if(adds_12)
            {
                _S106 = (*outputs_15)[_S108];
            }
            else
            {
                _S106 = 0.0f;
            }
            (*outputs_15)[_S108] = Relu_apply_0(_S105[i32(2)] + _S106);
        }
        var _S109 : i32 = output_6 + i32(3);
        if(_S109 < i32(16))
        {
            if(adds_12)
            {
                _S106 = (*outputs_15)[_S109];
            }
            else
            {
                _S106 = 0.0f;
            }
            (*outputs_15)[_S109] = Relu_apply_0(_S105[i32(3)] + _S106);
        }
        output_6 = output_6 + i32(4);
    }
    return;
}

fn dense_part_7( weights_18 : FloatWeights_0,  first_14 : u32,  adds_13 : bool,  inputs_20 : ptr<function, array<f32, i32(16)>>,  outputs_16 : ptr<function, array<f32, i32(3)>>)
{
    var _S110 : u32 = first_14 + u32(whole_parts_0(i32(1)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S111 : bool = output_7 < i32(3);
        if(_S111)
        {
        }
        else
        {
            break;
        }
        var _S112 : u32 = u32(output_7);
        var _S113 : Eight_0 = FloatWeights_eight_0(weights_18, first_14 + _S112 / u32(8));
        var _S114 : vec4<f32> = tile_product_3(weights_18, _S110 + _S112 * u32(2), &((*inputs_20)));
        var _S115 : vec4<f32> = _S114 + select_vector_0(((output_7 & (i32(4)))) != i32(0), _S113.high_0, _S113.low_0);
        var _S116 : f32;
        if(_S111)
        {
            if(adds_13)
            {
                _S116 = (*outputs_16)[output_7];
            }
            else
            {
                _S116 = 0.0f;
            }
            (*outputs_16)[output_7] = Identity_apply_0(_S115[i32(0)] + _S116);
        }
        var _S117 : i32 = output_7 + i32(1);
        if(_S117 < i32(3))
        {
            if(adds_13)
            {
                _S116 = (*outputs_16)[_S117];
            }
            else
            {
                _S116 = 0.0f;
            }
            (*outputs_16)[_S117] = Identity_apply_0(_S115[i32(1)] + _S116);
        }
        var _S118 : i32 = output_7 + i32(2);
        if(_S118 < i32(3))
        {
            if(adds_13)
            {
                _S116 = (*outputs_16)[_S118];
            }
            else
            {
                _S116 = 0.0f;
            }
            (*outputs_16)[_S118] = Identity_apply_0(_S115[i32(2)] + _S116);
        }
        var _S119 : i32 = output_7 + i32(3);
        if(_S119 < i32(3))
        {
            if(adds_13)
            {
                _S116 = (*outputs_16)[_S119];
            }
            else
            {
                _S116 = 0.0f;
            }
            (*outputs_16)[_S119] = Identity_apply_0(_S115[i32(3)] + _S116);
        }
        output_7 = output_7 + i32(4);
    }
    return;
}

fn dense_part_8( weights_19 : FloatWeights_0,  first_15 : u32,  adds_14 : bool,  inputs_21 : ptr<function, array<f32, i32(24)>>,  outputs_17 : ptr<function, array<f32, i32(16)>>)
{
    var _S120 : u32 = first_15 + u32(whole_parts_0(i32(2)));
    var output_8 : i32 = i32(0);
    for(;;)
    {
        var _S121 : bool = output_8 < i32(16);
        if(_S121)
        {
        }
        else
        {
            break;
        }
        var _S122 : u32 = u32(output_8);
        var _S123 : Eight_0 = FloatWeights_eight_0(weights_19, first_15 + _S122 / u32(8));
        var _S124 : vec4<f32> = tile_product_1(weights_19, _S120 + _S122 * u32(3), &((*inputs_21)));
        var _S125 : vec4<f32> = _S124 + select_vector_0(((output_8 & (i32(4)))) != i32(0), _S123.high_0, _S123.low_0);
        var _S126 : f32;
        if(_S121)
        {
            if(adds_14)
            {
                _S126 = (*outputs_17)[output_8];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_17)[output_8] = Relu_apply_0(_S125[i32(0)] + _S126);
        }
        var _S127 : i32 = output_8 + i32(1);
        if(_S127 < i32(16))
        {
            if(adds_14)
            {
                _S126 = (*outputs_17)[_S127];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_17)[_S127] = Relu_apply_0(_S125[i32(1)] + _S126);
        }
        var _S128 : i32 = output_8 + i32(2);
        if(_S128 < i32(16))
        {
            if(adds_14)
            {
                _S126 = (*outputs_17)[_S128];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_17)[_S128] = Relu_apply_0(_S125[i32(2)] + _S126);
        }
        var _S129 : i32 = output_8 + i32(3);
        if(_S129 < i32(16))
        {
            if(adds_14)
            {
                _S126 = (*outputs_17)[_S129];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_17)[_S129] = Relu_apply_0(_S125[i32(3)] + _S126);
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

fn dense_8( weights_22 : FloatWeights_0,  first_18 : u32,  adds_17 : bool,  inputs_24 : ptr<function, array<f32, i32(24)>>,  outputs_20 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_8(weights_22, first_18, adds_17, &((*inputs_24)), &((*outputs_20)));
    return;
}

fn MLP_evaluate_2( this_3 : MLP_0,  inputs_25 : ptr<function, array<f32, i32(24)>>,  outputs_21 : ptr<function, array<f32, i32(3)>>)
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
        var _S130 : i32 = layer_size_0(i32(16), i32(16));
        var _S131 : u32 = u32(layer_size_0(i32(24), i32(16)) + (layer_2 - i32(1)) * _S130);
        dense_6(this_3.weights_8, _S131, false, &(even_2), &(odd_2));
        if((layer_2 + i32(1)) < i32(2))
        {
            dense_6(this_3.weights_8, _S131 + u32(_S130), false, &(odd_2), &(even_2));
        }
        layer_2 = layer_2 + i32(2);
    }
    var _S132 : u32 = u32(layer_size_0(i32(24), i32(16)) + layer_size_0(i32(16), i32(16)));
    dense_7(this_3.weights_8, _S132, false, &(odd_2), &((*outputs_21)));
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
        var _S133 : i32 = i32(u32(8) * column_4);
        low_5[i32(0)] = (*inputs_26)[_S133];
        high_5[i32(0)] = (*inputs_26)[_S133 + i32(4)];
        var _S134 : i32 = _S133 + i32(1);
        low_5[i32(1)] = (*inputs_26)[_S134];
        high_5[i32(1)] = (*inputs_26)[_S134 + i32(4)];
        var _S135 : i32 = _S133 + i32(2);
        low_5[i32(2)] = (*inputs_26)[_S135];
        high_5[i32(2)] = (*inputs_26)[_S135 + i32(4)];
        var _S136 : i32 = _S133 + i32(3);
        low_5[i32(3)] = (*inputs_26)[_S136];
        high_5[i32(3)] = (*inputs_26)[_S136 + i32(4)];
        var _S137 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + column_4);
        sums_5[i32(0)] = sums_5[i32(0)] + (dot(_S137.low_0, low_5) + dot(_S137.high_0, high_5));
        var _S138 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + u32(1) + column_4);
        sums_5[i32(1)] = sums_5[i32(1)] + (dot(_S138.low_0, low_5) + dot(_S138.high_0, high_5));
        var _S139 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + u32(2) + column_4);
        sums_5[i32(2)] = sums_5[i32(2)] + (dot(_S139.low_0, low_5) + dot(_S139.high_0, high_5));
        var _S140 : Eight_0 = FloatWeights_eight_0(weights_23, row_4 + u32(3) + column_4);
        sums_5[i32(3)] = sums_5[i32(3)] + (dot(_S140.low_0, low_5) + dot(_S140.high_0, high_5));
        column_4 = column_4 + u32(1);
    }
    return sums_5;
}

fn dense_part_9( weights_24 : FloatWeights_0,  first_19 : u32,  adds_18 : bool,  inputs_27 : ptr<function, array<f32, i32(8)>>,  outputs_22 : ptr<function, array<f32, i32(12)>>)
{
    var _S141 : u32 = first_19 + u32(whole_parts_0(i32(2)));
    var output_9 : i32 = i32(0);
    for(;;)
    {
        var _S142 : bool = output_9 < i32(12);
        if(_S142)
        {
        }
        else
        {
            break;
        }
        var _S143 : u32 = u32(output_9);
        var _S144 : Eight_0 = FloatWeights_eight_0(weights_24, first_19 + _S143 / u32(8));
        var _S145 : vec4<f32> = tile_product_4(weights_24, _S141 + _S143, &((*inputs_27)));
        var _S146 : vec4<f32> = _S145 + select_vector_0(((output_9 & (i32(4)))) != i32(0), _S144.high_0, _S144.low_0);
        var _S147 : f32;
        if(_S142)
        {
            if(adds_18)
            {
                _S147 = (*outputs_22)[output_9];
            }
            else
            {
                _S147 = 0.0f;
            }
            (*outputs_22)[output_9] = Identity_apply_0(_S146[i32(0)] + _S147);
        }
        var _S148 : i32 = output_9 + i32(1);
        if(_S148 < i32(12))
        {
            if(adds_18)
            {
                _S147 = (*outputs_22)[_S148];
            }
            else
            {
                _S147 = 0.0f;
            }
            (*outputs_22)[_S148] = Identity_apply_0(_S146[i32(1)] + _S147);
        }
        var _S149 : i32 = output_9 + i32(2);
        if(_S149 < i32(12))
        {
            if(adds_18)
            {
                _S147 = (*outputs_22)[_S149];
            }
            else
            {
                _S147 = 0.0f;
            }
            (*outputs_22)[_S149] = Identity_apply_0(_S146[i32(2)] + _S147);
        }
        var _S150 : i32 = output_9 + i32(3);
        if(_S150 < i32(12))
        {
            if(adds_18)
            {
                _S147 = (*outputs_22)[_S150];
            }
            else
            {
                _S147 = 0.0f;
            }
            (*outputs_22)[_S150] = Identity_apply_0(_S146[i32(3)] + _S147);
        }
        output_9 = output_9 + i32(4);
    }
    return;
}

fn decode_0( first_20 : u32,  inputs_28 : ptr<function, array<f32, i32(24)>>,  outputs_23 : ptr<function, array<f32, i32(3)>>)
{
    var network_1 : MLP_0;
    network_1.weights_8.first_0 = first_20;
    MLP_evaluate_0(network_1, &((*inputs_28)), &((*outputs_23)));
    return;
}

fn decode_1( first_21 : u32,  inputs_29 : ptr<function, array<f32, i32(24)>>,  outputs_24 : ptr<function, array<f32, i32(3)>>)
{
    var network_2 : MLP_0;
    network_2.weights_8.first_0 = first_21;
    MLP_evaluate_1(network_2, &((*inputs_29)), &((*outputs_24)));
    return;
}

fn decode_2( first_22 : u32,  inputs_30 : ptr<function, array<f32, i32(24)>>,  outputs_25 : ptr<function, array<f32, i32(3)>>)
{
    var network_3 : MLP_0;
    network_3.weights_8.first_0 = first_22;
    MLP_evaluate_2(network_3, &((*inputs_30)), &((*outputs_25)));
    return;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn dense_9( weights_25 : FloatWeights_0,  first_23 : u32,  adds_19 : bool,  inputs_31 : ptr<function, array<f32, i32(8)>>,  outputs_26 : ptr<function, array<f32, i32(12)>>)
{
    dense_part_9(weights_25, first_23, adds_19, &((*inputs_31)), &((*outputs_26)));
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

fn scene_vertex_0( first_24 : u32) -> Vertex_0
{
    var record_0 : Vertex_0;
    record_0.x_2 = (bitcast<f32>((scene_words_0[first_24])));
    record_0.y_0 = (bitcast<f32>((scene_words_0[first_24 + u32(1)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_24 + u32(2)])));
    record_0.normal_x_0 = (bitcast<f32>((scene_words_0[first_24 + u32(3)])));
    record_0.normal_y_0 = (bitcast<f32>((scene_words_0[first_24 + u32(4)])));
    record_0.normal_z_0 = (bitcast<f32>((scene_words_0[first_24 + u32(5)])));
    record_0.u_0 = (bitcast<f32>((scene_words_0[first_24 + u32(6)])));
    record_0.v_0 = (bitcast<f32>((scene_words_0[first_24 + u32(7)])));
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
    var _S151 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S152 : u32 = ((((_S151 >> ((((_S151 >> (u32(28)))) + u32(4))))) ^ (_S151))) * u32(277803737);
    return (((_S152 >> (u32(22)))) ^ (_S152));
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
    var _S153 : vec2<f32> = floor(place_0);
    var _S154 : vec2<f32> = place_0 - _S153;
    var _S155 : vec2<f32> = _S154 * _S154 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S154);
    var _S156 : u32 = u32(i32(_S153.x)) * u32(65536) + u32(i32(_S153.y));
    var _S157 : f32 = _S155.x;
    return mix(mix(uneven_corner_0(key_2, _S156), uneven_corner_0(key_2, _S156 + u32(65536)), _S157), mix(uneven_corner_0(key_2, _S156 + u32(1)), uneven_corner_0(key_2, _S156 + u32(65537)), _S157), _S155.y);
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

fn uniform_hash_0( thread_1 : u32,  cell_2 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_2)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_0 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S158 : u32 = pixel_0.x;
    var _S159 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S158, _S159, stream_2), uniform_hash_0(_S158, _S159, stream_2 + u32(1))) + vec2<f32>(f32((index_0 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S160 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S160, - _S160, back_2));
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S161 : u32 = (bitcast<u32>((x_3)));
    var m_0 : f32 = (bitcast<f32>(((((_S161 & (u32(8388607)))) | (u32(1056964608))))));
    var _S162 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S161 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S162);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S162) - 1.0f;
    var _S163 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S163 - exponent_0 * 0.00021219444170129f - 0.5f * _S163) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn no_numbers_0() -> Eight_0
{
    var numbers_1 : Eight_0;
    var _S164 : vec4<f32> = vec4<f32>(0.0f);
    numbers_1.low_0 = _S164;
    numbers_1.high_0 = _S164;
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

fn texel_numbers_0( first_25 : u32,  elements_1 : u32,  texel_0 : u32) -> Eight_0
{
    var _S165 : u32 = first_25 + texel_0 * elements_1;
    var _S166 : vec4<u32> = packed_numbers_0[_S165];
    if(elements_1 == u32(1))
    {
        return eight_halves_0(_S166);
    }
    var numbers_3 : Eight_0;
    numbers_3.low_0 = (bitcast<vec4<f32>>((_S166)));
    numbers_3.high_0 = (bitcast<vec4<f32>>((packed_numbers_0[_S165 + u32(1)])));
    return numbers_3;
}

fn add_bilinear_0( first_26 : u32,  elements_2 : u32,  start_1 : u32,  columns_1 : u32,  rows_1 : u32,  uv_2 : vec2<f32>,  weight_0 : f32,  sums_6 : ptr<function, Eight_0>)
{
    var _S167 : vec2<f32> = uv_2 * vec2<f32>(f32(columns_1), f32(rows_1)) - vec2<f32>(0.5f);
    var _S168 : vec2<f32> = floor(_S167);
    var _S169 : vec2<f32> = _S167 - _S168;
    var _S170 : i32 = i32(_S168.x);
    var _S171 : i32 = i32(_S168.y);
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
        var _S172 : u32 = (tap_0 & (u32(1)));
        var _S173 : u32 = (tap_0 >> (u32(1)));
        var _S174 : Eight_0 = texel_numbers_0(first_26, elements_2, start_1 + ((u32(_S171 + i32(_S173)) & ((rows_1 - u32(1))))) * columns_1 + ((u32(_S170 + i32(_S172)) & ((columns_1 - u32(1))))));
        var _S175 : f32 = _S169.y;
        var _S176 : f32 = _S169.x;
        var _S177 : vec4<f32> = vec4<f32>((select(1.0f - _S175, _S175, _S173 != u32(0)) * select(1.0f - _S176, _S176, _S172 != u32(0)) * weight_0));
        (*sums_6).low_0 = (*sums_6).low_0 + _S177 * _S174.low_0;
        (*sums_6).high_0 = (*sums_6).high_0 + _S177 * _S174.high_0;
        tap_0 = tap_0 + u32(1);
    }
    return;
}

struct TexelPyramid_0
{
     first_27 : u32,
     elements_3 : u32,
     levels_4 : u32,
     last_level_3 : f32,
     face_texels_2 : u32,
};

fn TexelPyramid_add_level_0( this_4 : TexelPyramid_0,  place_1 : vec2<f32>,  level_1 : u32,  face_2 : u32,  weight_1 : f32,  sums_7 : ptr<function, Eight_0>)
{
    var _S178 : u32 = this_4.levels_4 + u32(3) * level_1;
    add_bilinear_0(this_4.first_27, this_4.elements_3, face_2 * this_4.face_texels_2 + words_0[_S178], words_0[_S178 + u32(1)], words_0[_S178 + u32(2)], place_1, weight_1, &((*sums_7)));
    return;
}

fn TexelPyramid_between_levels_0( this_5 : TexelPyramid_0,  uv_3 : vec2<f32>,  level_2 : f32,  face_3 : u32) -> Eight_0
{
    var _S179 : f32 = clamp(level_2, 0.0f, this_5.last_level_3);
    var _S180 : f32 = clamp(floor(_S179), 0.0f, max(this_5.last_level_3 - 1.0f, 0.0f));
    var _S181 : f32 = _S179 - _S180;
    var _S182 : vec2<f32> = within_repeat_0(uv_3);
    var texel_1 : Eight_0 = no_numbers_0();
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
        var _S183 : f32 = select(_S181, 1.0f - _S181, offset_1 == u32(0));
        if(_S183 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S182, u32(_S180) + offset_1, face_3, _S183, &(texel_1));
        }
        offset_1 = offset_1 + u32(1);
    }
    return texel_1;
}

fn TexelPyramid_of_level_0( this_6 : TexelPyramid_0,  uv_4 : vec2<f32>,  level_3 : u32,  face_4 : u32) -> Eight_0
{
    var texel_2 : Eight_0 = no_numbers_0();
    TexelPyramid_add_level_0(this_6, within_repeat_0(uv_4), level_3, face_4, 1.0f, &(texel_2));
    return texel_2;
}

fn channel_0( numbers_4 : Eight_0,  k_0 : i32) -> f32
{
    var _S184 : i32 = (k_0 & (i32(3)));
    return select(numbers_4.high_0[_S184], numbers_4.low_0[_S184], k_0 < i32(4));
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
    var _S185 : vec3<f32> = normalize(normal_2 + vec3<f32>(0.0f, 0.0f, 1.0f));
    result_0.normal_1 = _S185;
    var _S186 : vec3<f32> = normalize(tangent_1 + vec3<f32>(1.0f, 0.0f, 0.0f));
    result_0.tangent_0 = _S186;
    result_0.bitangent_0 = cross(_S185, _S186);
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

fn choose_0( table_0 : u32,  count_1 : u32,  number_0 : f32) -> Choice_0
{
    var high_6 : u32 = count_1;
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
        var _S187 : u32 = (low_6 + high_6) / u32(2);
        if((scene_number_0(table_0 + _S187)) <= number_0)
        {
            low_6 = _S187;
        }
        else
        {
            high_6 = _S187;
        }
    }
    var _S188 : u32 = table_0 + low_6;
    var _S189 : f32 = scene_number_0(_S188);
    var _S190 : f32 = scene_number_0(_S188 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_2 = low_6;
    choice_0.remainder_0 = saturate((number_0 - _S189) / max(_S190 - _S189, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_5 : f32) -> vec2<f32>
{
    var _S191 : f32 = floor(x_5 * 0.63661974668502808f + 0.5f);
    var _S192 : f32 = x_5 - _S191 * 1.5703125f - _S191 * 0.00048375129699707f - _S191 * 7.54979012640433211e-08f;
    var _S193 : f32 = _S192 * _S192;
    var _S194 : f32 = ((-0.00019515295571182f * _S193 + 0.00833216123282909f) * _S193 - 0.16666655242443085f) * _S193 * _S192 + _S192;
    var _S195 : f32 = ((0.00002443315679557f * _S193 - 0.00138873164542019f) * _S193 + 0.04166664555668831f) * _S193 * _S193 - 0.5f * _S193 + 1.0f;
    var _S196 : u32 = (u32(i32(_S191)) & (u32(3)));
    var _S197 : vec2<f32> = select_vector_1(((_S196 & (u32(1)))) != u32(0), vec2<f32>(_S195, _S194), vec2<f32>(_S194, _S195));
    var _S198 : f32 = _S197.x;
    var _S199 : f32 = _S197.y;
    return vec2<f32>(select(_S198, - _S198, ((_S196 & (u32(2)))) != u32(0)), select(_S199, - _S199, (((_S196 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_6 : f32,
     y_1 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_28 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_28];
    record_1.x_6 = (bitcast<f32>((scene_words_0[first_28 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_28 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_28 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_28 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_28 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_28 + u32(6)])));
    return record_1;
}

fn LatentFrame_coordinates_0( this_7 : LatentFrame_0,  direction_2 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_2, this_7.tangent_0), dot(direction_2, this_7.bitangent_0), dot(direction_2, this_7.normal_1));
}

fn half_vector_feature_0( view_1 : vec3<f32>,  light_1 : vec3<f32>) -> f32
{
    var _S200 : vec3<f32> = view_1 + light_1;
    var _S201 : f32 = max(_S200.z, 0.01999999955296516f);
    var _S202 : f32 = _S200.x;
    var _S203 : f32 = _S200.y;
    return 0.25f * natural_logarithm_0((_S202 * _S202 + _S203 * _S203) / (_S201 * _S201) + 0.00000999999974738f);
}

fn exponential_0( x_7 : f32) -> f32
{
    var _S204 : f32 = clamp(x_7, -87.0f, 88.0f);
    var _S205 : f32 = floor(_S204 * 1.4426950216293335f + 0.5f);
    var _S206 : f32 = _S204 - _S205 * 0.693359375f + _S205 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S206 + 0.00139819993637502f) * _S206 + 0.00833345204591751f) * _S206 + 0.04166579619050026f) * _S206 + 0.1666666567325592f) * _S206 + 0.5f) * _S206 * _S206 + _S206 + 1.0f) * (bitcast<f32>(((u32(i32(_S205) + i32(127)) << (u32(23)))))), 0.0f, x_7 < -87.0f);
}

fn bounded_exponential_0( exponent_1 : f32) -> f32
{
    return exponential_0(min(exponent_1, 12.0f));
}

fn accumulate_0( index_3 : u32,  light_2 : vec4<f32>)
{
    var _S207 : f32 = layers_0[index_3].share_0;
    radiance_0[index_3] = radiance_0[index_3] + vec4<f32>(layers_0[index_3].share_0) * light_2;
    layers_0[index_3].share_0 = _S207 * (1.0f - light_2.w);
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

fn uneven_shift_0( _S208 : u32,  _S209 : u32,  _S210 : u32,  _S211 : vec2<f32>) -> f32
{
    var _S212 : f32 = families_0[_S210].period_0 / families_0[_S210].count_0;
    var _S213 : u32 = hash_key_0(_S209, ((fabrics_0[_S208].seed_0) ^ (u32(625341585))));
    var _S214 : vec2<f32> = vec2<f32>(_S211.x, _S211.y / 4.0f) / vec2<f32>(_S212);
    return 0.20000000298023224f * sqrt(families_0[_S210].slub_0) * _S212 * (uneven_octave_0(_S213, _S214) * 0.66666668653488159f + uneven_octave_0(_S213 + u32(1), vec2<f32>(2.0f) * _S214 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S215 : u32,  _S216 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S215].has_detail_0) == u32(0), _S216, _S216 + vec2<f32>(uneven_shift_0(_S215, u32(0), fabrics_0[_S215].warp_0, _S216), uneven_shift_0(_S215, u32(1), fabrics_0[_S215].weft_0, _S216.yx)));
}

fn face_point_0( _S217 : u32,  _S218 : u32,  _S219 : f32,  _S220 : f32) -> VisiblePoint_0
{
    var _S221 : u32 = u32(3) * _S218;
    var _S222 : Vertex_0 = vertex_at_0(_S221);
    var _S223 : Vertex_0 = vertex_at_0(_S221 + u32(1));
    var _S224 : Vertex_0 = vertex_at_0(_S221 + u32(2));
    var _S225 : vec3<f32> = position_of_0(_S222);
    var _S226 : vec3<f32> = position_of_0(_S223) - _S225;
    var _S227 : vec3<f32> = position_of_0(_S224) - _S225;
    var _S228 : f32 = _S223.u_0 - _S222.u_0;
    var _S229 : f32 = _S223.v_0 - _S222.v_0;
    var _S230 : vec2<f32> = vec2<f32>(_S228, _S229);
    var _S231 : f32 = _S224.u_0 - _S222.u_0;
    var _S232 : f32 = _S224.v_0 - _S222.v_0;
    var _S233 : vec2<f32> = vec2<f32>(_S231, _S232);
    var _S234 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S228 * _S232 - _S229 * _S231) < 0.0f));
    var _S235 : vec3<f32> = _S234 * (vec3<f32>(_S232) * _S226 - vec3<f32>(_S229) * _S227);
    var _S236 : vec3<f32> = _S234 * (vec3<f32>(_S228) * _S227 - vec3<f32>(_S231) * _S226);
    var point_1 : VisiblePoint_0;
    var _S237 : vec3<f32> = vec3<f32>(_S219);
    var _S238 : vec3<f32> = vec3<f32>(_S220);
    var _S239 : vec3<f32> = normalize(vec3<f32>((1.0f - _S219 - _S220)) * normal_of_0(_S222) + _S237 * normal_of_0(_S223) + _S238 * normal_of_0(_S224));
    point_1.normal_0 = _S239;
    var _S240 : vec3<f32> = normalize(_S235 - _S239 * vec3<f32>(dot(_S239, _S235)));
    point_1.axis_x_0 = _S240;
    point_1.axis_y_0 = cross(_S239, _S240);
    var _S241 : vec3<f32> = normalize(cross(_S226, _S227));
    point_1.face_normal_0 = select_vector_2((dot(_S241, _S239)) < 0.0f, (vec3<f32>(0) - _S241), _S241);
    point_1.position_0 = _S225 + _S237 * _S226 + _S238 * _S227;
    point_1.view_0 = _S239;
    var _S242 : vec2<f32> = vec2<f32>(_S222.u_0, _S222.v_0) + vec2<f32>(_S219) * _S230 + vec2<f32>(_S220) * _S233;
    point_1.uv_0 = _S242;
    var _S243 : bool = (dot(cross(_S235, _S236), _S239)) < 0.0f;
    var _S244 : vec2<f32> = vec2<f32>(fabrics_0[_S217].uv_width_0, select(fabrics_0[_S217].uv_height_0, - fabrics_0[_S217].uv_height_0, _S243));
    point_1.draft_per_uv_0 = _S244;
    point_1.draft_0 = uneven_place_0(_S217, _S242 * _S244 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S217].uv_height_0, _S243)));
    var _S245 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S245;
    point_1.draft_dy_0 = _S245;
    return point_1;
}

fn visible_point_0( _S246 : u32,  _S247 : u32,  _S248 : vec2<u32>) -> VisiblePoint_0
{
    var _S249 : u32 = u32(3) * _S247;
    var _S250 : Vertex_0 = vertex_at_0(_S249);
    var _S251 : Vertex_0 = vertex_at_0(_S249 + u32(1));
    var _S252 : Vertex_0 = vertex_at_0(_S249 + u32(2));
    var _S253 : vec3<f32> = position_of_0(_S250);
    var _S254 : vec3<f32> = position_of_0(_S251) - _S253;
    var _S255 : vec3<f32> = position_of_0(_S252) - _S253;
    var _S256 : vec3<f32> = cross(_S254, _S255);
    var _S257 : f32 = f32(frame_record_0.width_0);
    var _S258 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S257));
    var _S259 : f32 = f32(frame_record_0.height_0);
    var _S260 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S259));
    var _S261 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S248.x) + 0.5f - 0.5f * _S257)) * _S258 + vec3<f32>((f32(_S248.y) + 0.5f - 0.5f * _S259)) * _S260;
    var _S262 : f32 = dot(_S261, _S256);
    var _S263 : f32 = 1.0f / select(1.00000000317107685e-30f, _S262, (abs(_S262)) > 1.00000000317107685e-30f);
    var _S264 : vec3<f32> = _S253 - camera_origin_0();
    var _S265 : vec3<f32> = vec3<f32>((dot(_S264, _S256) * _S263));
    var _S266 : vec3<f32> = _S261 * _S265 - _S264;
    var _S267 : vec3<f32> = _S265 * (_S258 - _S261 * vec3<f32>((dot(_S258, _S256) * _S263)));
    var _S268 : vec3<f32> = _S265 * (_S260 - _S261 * vec3<f32>((dot(_S260, _S256) * _S263)));
    var _S269 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S256), 1.00000000317107685e-30f)));
    var _S270 : vec3<f32> = cross(_S255, _S256) * _S269;
    var _S271 : vec3<f32> = cross(_S256, _S254) * _S269;
    var _S272 : vec2<f32> = vec2<f32>(_S251.u_0 - _S250.u_0, _S251.v_0 - _S250.v_0);
    var _S273 : vec2<f32> = vec2<f32>(_S252.u_0 - _S250.u_0, _S252.v_0 - _S250.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S246, _S247, dot(_S266, _S270), dot(_S266, _S271));
    point_2.position_0 = _S253 + _S266;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S261));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S267, _S270)) * _S272 + vec2<f32>(dot(_S267, _S271)) * _S273) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S268, _S270)) * _S272 + vec2<f32>(dot(_S268, _S271)) * _S273) * point_2.draft_per_uv_0;
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
     first_29 : LatentFrame_0,
     second_0 : LatentFrame_0,
     view_2 : vec3<f32>,
     back_3 : bool,
};

fn latent_view_0( _S274 : u32,  _S275 : Footprint_0,  _S276 : vec3<f32>,  _S277 : f32,  _S278 : ptr<function, LatentView_0>)
{
    var _S279 : Latent_std430_0 = fabrics_0[_S274].latent_0;
    var _S280 : bool = (_S276.z) < 0.0f;
    (*_S278).back_3 = _S280;
    (*_S278).view_2 = to_face_frame_0(_S276, _S280);
    var _S281 : u32 = select(u32(0), _S279.back_1, _S280);
    var _S282 : vec2<f32> = _S275.centre_0 * vec2<f32>(_S279.repeats_per_x_1, _S279.repeats_per_y_1);
    var _S283 : vec2<f32> = vec2<f32>(f32(words_0[_S279.levels_3 + u32(1)]), f32(words_0[_S279.levels_3 + u32(2)]));
    var _S284 : vec2<f32> = select_vector_1((_S279.is_apart_0) != u32(0), (floor(_S282 * _S283) + vec2<f32>(0.5f)) / _S283, _S282);
    var _S285 : f32 = clamp(binary_logarithm_0(max(sqrt(abs(_S275.dx_0.x * _S275.dy_0.y - _S275.dx_0.y * _S275.dy_0.x)) * _S279.texels_per_mm_1, 9.99999971718068537e-10f)), 0.0f, _S279.last_level_2);
    var pyramid_0 : TexelPyramid_0;
    pyramid_0.first_27 = _S279.texels_1;
    pyramid_0.elements_3 = _S279.texel_elements_1;
    pyramid_0.levels_4 = _S279.levels_3;
    pyramid_0.last_level_3 = _S279.last_level_2;
    pyramid_0.face_texels_2 = _S279.face_texels_1;
    var texel_3 : Eight_0;
    if((_S279.is_trilinear_0) != u32(0))
    {
        texel_3 = TexelPyramid_between_levels_0(pyramid_0, _S284, _S285, _S281);
    }
    else
    {
        texel_3 = TexelPyramid_of_level_0(pyramid_0, _S284, u32(_S285) + select(u32(0), u32(1), _S277 < (_S285 - floor(_S285))), _S281);
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
        (*_S278).latent_1[k_1] = channel_0(texel_3, k_1);
        k_1 = k_1 + i32(1);
    }
    var weights_26 : FloatWeights_0;
    weights_26.first_0 = _S279.frames_0;
    var _S286 : array<f32, i32(8)> = (*_S278).latent_1;
    var sums_8 : array<f32, i32(12)>;
    dense_9(weights_26, u32(0), false, &(_S286), &(sums_8));
    (*_S278).latent_1 = _S286;
    (*_S278).first_29 = frame_of_0(vec3<f32>(sums_8[i32(0)], sums_8[i32(1)], sums_8[i32(2)]), vec3<f32>(sums_8[i32(3)], sums_8[i32(4)], sums_8[i32(5)]));
    (*_S278).second_0 = frame_of_0(vec3<f32>(sums_8[i32(6)], sums_8[i32(7)], sums_8[i32(8)]), vec3<f32>(sums_8[i32(9)], sums_8[i32(10)], sums_8[i32(11)]));
    return;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S287 : u32,  _S288 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S287 * frame_record_0.height_0 + _S288.y) * frame_record_0.width_0 + _S288.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_0 : f32,
};

fn environment_texel_0( _S289 : u32,  _S290 : u32) -> vec3<f32>
{
    var _S291 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S289 * frame_record_0.environment_columns_0 + _S290);
    return vec3<f32>(scene_number_0(_S291), scene_number_0(_S291 + u32(1)), scene_number_0(_S291 + u32(2)));
}

fn sample_environment_0( _S292 : vec2<f32>,  _S293 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S294 : u32 = frame_record_0.environment_rows_0;
    var _S295 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S292.y);
    var _S296 : u32 = frame_record_0.environment_columns_0;
    var _S297 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S295.index_2 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S292.x);
    var _S298 : vec3<f32> = environment_texel_0(_S295.index_2, _S297.index_2);
    (*_S293) = _S298 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S298), 9.99999968265522539e-21f)));
    var _S299 : f32 = 3.14159274101257324f / f32(_S294);
    var _S300 : f32 = mix(sine_cosine_0(f32(_S295.index_2) * _S299).y, sine_cosine_0(f32(_S295.index_2 + u32(1)) * _S299).y, _S295.remainder_0);
    var _S301 : f32 = sqrt(max(1.0f - _S300 * _S300, 0.0f));
    var _S302 : vec2<f32> = sine_cosine_0((f32(_S297.index_2) + _S297.remainder_0) * (6.28318548202514648f / f32(_S296)));
    var _S303 : f32 = _S301 * _S302.x;
    var _S304 : f32 = - _S301 * _S302.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S303 + frame_record_0.environment_sine_0 * _S304, _S300, frame_record_0.environment_cosine_0 * _S304 - frame_record_0.environment_sine_0 * _S303);
}

fn light_sample_0( _S305 : u32,  _S306 : vec2<u32>,  _S307 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    var _S308 : u32 = frame_record_0.lights_0;
    if(_S305 >= (frame_record_0.lights_0))
    {
        var weight_2 : vec3<f32>;
        var _S309 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S306, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S305 - _S308), u32(3)), &(weight_2));
        sample_0.towards_0 = _S309;
        sample_0.irradiance_1 = weight_2 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S310 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S305);
    sample_0.irradiance_1 = vec3<f32>(_S310.red_0, _S310.green_0, _S310.blue_0);
    sample_0.towards_0 = vec3<f32>(_S310.x_6, _S310.y_1, _S310.z_1);
    if((_S310.is_point_0) != u32(0))
    {
        var _S311 : vec3<f32> = sample_0.towards_0 - _S307;
        var _S312 : f32 = max(square_0(_S311), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S312);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S312);
        sample_0.towards_0 = normalize(_S311);
    }
    return sample_0;
}

fn latent_value_0( _S313 : u32,  _S314 : ptr<function, LatentView_0>,  _S315 : vec3<f32>) -> vec3<f32>
{
    var _S316 : vec3<f32> = to_face_frame_0(_S315, (*_S314).back_3);
    var _S317 : f32 = _S316.z;
    if(_S317 <= 0.0f)
    {
        return vec3<f32>(0.0f);
    }
    var inputs_32 : array<f32, i32(24)>;
    var _S318 : vec3<f32> = LatentFrame_coordinates_0((*_S314).first_29, (*_S314).view_2);
    var _S319 : vec3<f32> = LatentFrame_coordinates_0((*_S314).first_29, _S316);
    var _S320 : vec3<f32> = LatentFrame_coordinates_0((*_S314).second_0, (*_S314).view_2);
    var _S321 : vec3<f32> = LatentFrame_coordinates_0((*_S314).second_0, _S316);
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
        inputs_32[axis_0] = _S318[axis_0];
        inputs_32[i32(3) + axis_0] = _S319[axis_0];
        inputs_32[i32(6) + axis_0] = _S320[axis_0];
        inputs_32[i32(9) + axis_0] = _S321[axis_0];
        axis_0 = axis_0 + i32(1);
    }
    inputs_32[i32(12)] = half_vector_feature_0(_S318, _S319);
    inputs_32[i32(13)] = half_vector_feature_0(_S320, _S321);
    var _S322 : f32 = 1.0f - sqrt(max(0.25f * square_0((*_S314).view_2 + _S316), 9.99999993922529029e-09f));
    inputs_32[i32(14)] = _S322 * (_S322 * _S322 * _S322 * _S322);
    inputs_32[i32(15)] = natural_logarithm_0(max(_S317, 0.00999999977648258f));
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
        inputs_32[i32(16) + k_2] = (*_S314).latent_1[k_2];
        k_2 = k_2 + i32(1);
    }
    var outputs_27 : array<f32, i32(3)>;
    var _S323 : Latent_std430_0 = fabrics_0[_S313].latent_0;
    if((fabrics_0[_S313].latent_0.hidden_0) == u32(16))
    {
        decode_2(_S323.decoder_1, &(inputs_32), &(outputs_27));
    }
    else
    {
        if((_S323.hidden_0) == u32(32))
        {
            decode_1(_S323.decoder_1, &(inputs_32), &(outputs_27));
        }
        else
        {
            decode_0(_S323.decoder_1, &(inputs_32), &(outputs_27));
        }
    }
    return vec3<f32>(bounded_exponential_0(outputs_27[i32(0)] - 3.0f), bounded_exponential_0(outputs_27[i32(1)] - 3.0f), bounded_exponential_0(outputs_27[i32(2)] - 3.0f));
}

fn light_of_latent_0( _S324 : u32,  _S325 : VisiblePoint_0,  _S326 : vec2<u32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S325.draft_0;
    footprint_0.dx_0 = _S325.draft_dx_0;
    footprint_0.dy_0 = _S325.draft_dy_0;
    var seen_0 : LatentView_0;
    latent_view_0(_S324, footprint_0, to_local_0(_S325, _S325.view_0), pixel_sequence_0(_S326, frame_record_0.pass_number_0, u32(1)).x, &(seen_0));
    var _S327 : vec3<f32> = vec3<f32>(0.0f);
    var number_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S327;
    for(;;)
    {
        if(number_1 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S328 : f32 = visibility_at_0(number_1, _S326);
        if(_S328 <= 0.0f)
        {
            number_1 = number_1 + u32(1);
            continue;
        }
        var _S329 : LightSample_0 = light_sample_0(number_1, _S326, _S325.position_0);
        var _S330 : vec3<f32> = vec3<f32>(_S328) * _S329.irradiance_1;
        var _S331 : vec3<f32> = latent_value_0(_S324, &(seen_0), to_local_0(_S325, _S329.towards_0));
        radiance_1 = radiance_1 + _S330 * _S331;
        number_1 = number_1 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_latent(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S332 : u32 = id_0.x;
    var _S333 : bool;
    if(_S332 >= (frame_record_0.width_0))
    {
        _S333 = true;
    }
    else
    {
        _S333 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S333)
    {
        return;
    }
    var _S334 : u32 = id_0.y * frame_record_0.width_0 + _S332;
    var _S335 : u32 = layers_0[_S334].face_0;
    if((layers_0[_S334].face_0) == u32(0))
    {
        return;
    }
    var _S336 : u32 = _S335 - u32(1);
    var _S337 : u32 = fabric_of_0(_S336);
    var _S338 : vec2<u32> = id_0.xy;
    accumulate_0(_S334, light_of_latent_0(_S337, visible_point_0(_S337, _S336, _S338), _S338));
    return;
}

