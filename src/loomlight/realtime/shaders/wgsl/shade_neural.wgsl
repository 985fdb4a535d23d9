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

fn whole_parts_0( elements_0 : i32) -> i32
{
    return (elements_0 + i32(3)) / i32(4) * i32(4);
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

fn dense_part_0( weights_1 : FloatWeights_0,  first_1 : u32,  adds_0 : bool,  inputs_1 : ptr<function, array<f32, i32(64)>>,  outputs_0 : ptr<function, array<f32, i32(50)>>)
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
            (*outputs_0)[output_0] = Identity_apply_0(_S15[i32(0)] + _S16);
        }
        var _S17 : i32 = output_0 + i32(1);
        if(_S17 < i32(50))
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
        if(_S18 < i32(50))
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
        if(_S19 < i32(50))
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

fn tile_product_1( weights_2 : HalfWeights_0,  row_1 : u32,  inputs_2 : ptr<function, array<f32, i32(64)>>) -> vec4<f32>
{
    var sums_2 : vec4<f32> = vec4<f32>(0.0f);
    var column_1 : u32 = u32(0);
    for(;;)
    {
        if(column_1 < u32(8))
        {
        }
        else
        {
            break;
        }
        var low_2 : vec4<f32>;
        var high_2 : vec4<f32>;
        var _S20 : i32 = i32(u32(8) * column_1);
        low_2[i32(0)] = (*inputs_2)[_S20];
        high_2[i32(0)] = (*inputs_2)[_S20 + i32(4)];
        var _S21 : i32 = _S20 + i32(1);
        low_2[i32(1)] = (*inputs_2)[_S21];
        high_2[i32(1)] = (*inputs_2)[_S21 + i32(4)];
        var _S22 : i32 = _S20 + i32(2);
        low_2[i32(2)] = (*inputs_2)[_S22];
        high_2[i32(2)] = (*inputs_2)[_S22 + i32(4)];
        var _S23 : i32 = _S20 + i32(3);
        low_2[i32(3)] = (*inputs_2)[_S23];
        high_2[i32(3)] = (*inputs_2)[_S23 + i32(4)];
        var _S24 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        sums_2[i32(0)] = sums_2[i32(0)] + (dot(_S24.low_0, low_2) + dot(_S24.high_0, high_2));
        var _S25 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(8) + column_1);
        sums_2[i32(1)] = sums_2[i32(1)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        var _S26 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(16) + column_1);
        sums_2[i32(2)] = sums_2[i32(2)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        var _S27 : Eight_0 = HalfWeights_eight_0(weights_2, row_1 + u32(24) + column_1);
        sums_2[i32(3)] = sums_2[i32(3)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        column_1 = column_1 + u32(1);
    }
    return sums_2;
}

fn dense_part_1( weights_3 : HalfWeights_0,  first_3 : u32,  adds_1 : bool,  inputs_3 : ptr<function, array<f32, i32(64)>>,  outputs_1 : ptr<function, array<f32, i32(52)>>)
{
    var _S28 : u32 = first_3 + u32(whole_parts_0(i32(7)));
    var output_1 : i32 = i32(0);
    for(;;)
    {
        var _S29 : bool = output_1 < i32(52);
        if(_S29)
        {
        }
        else
        {
            break;
        }
        var _S30 : u32 = u32(output_1);
        var _S31 : Eight_0 = HalfWeights_eight_0(weights_3, first_3 + _S30 / u32(8));
        var _S32 : vec4<f32> = tile_product_1(weights_3, _S28 + _S30 * u32(8), &((*inputs_3)));
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
            (*outputs_1)[output_1] = Identity_apply_0(_S33[i32(0)] + _S34);
        }
        var _S35 : i32 = output_1 + i32(1);
        if(_S35 < i32(52))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S35];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S35] = Identity_apply_0(_S33[i32(1)] + _S34);
        }
        var _S36 : i32 = output_1 + i32(2);
        if(_S36 < i32(52))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S36];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S36] = Identity_apply_0(_S33[i32(2)] + _S34);
        }
        var _S37 : i32 = output_1 + i32(3);
        if(_S37 < i32(52))
        {
            if(adds_1)
            {
                _S34 = (*outputs_1)[_S37];
            }
            else
            {
                _S34 = 0.0f;
            }
            (*outputs_1)[_S37] = Identity_apply_0(_S33[i32(3)] + _S34);
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
        var _S38 : i32 = i32(u32(8) * column_2);
        low_3[i32(0)] = (*inputs_4)[min(_S38, i32(38))];
        high_3[i32(0)] = (*inputs_4)[min(_S38 + i32(4), i32(38))];
        var _S39 : i32 = _S38 + i32(1);
        low_3[i32(1)] = (*inputs_4)[min(_S39, i32(38))];
        high_3[i32(1)] = (*inputs_4)[min(_S39 + i32(4), i32(38))];
        var _S40 : i32 = _S38 + i32(2);
        low_3[i32(2)] = (*inputs_4)[min(_S40, i32(38))];
        high_3[i32(2)] = (*inputs_4)[min(_S40 + i32(4), i32(38))];
        var _S41 : i32 = _S38 + i32(3);
        low_3[i32(3)] = (*inputs_4)[min(_S41, i32(38))];
        high_3[i32(3)] = (*inputs_4)[min(_S41 + i32(4), i32(38))];
        var _S42 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        sums_3[i32(0)] = sums_3[i32(0)] + (dot(_S42.low_0, low_3) + dot(_S42.high_0, high_3));
        var _S43 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(5) + column_2);
        sums_3[i32(1)] = sums_3[i32(1)] + (dot(_S43.low_0, low_3) + dot(_S43.high_0, high_3));
        var _S44 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(10) + column_2);
        sums_3[i32(2)] = sums_3[i32(2)] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        var _S45 : Eight_0 = HalfWeights_eight_0(weights_4, row_2 + u32(15) + column_2);
        sums_3[i32(3)] = sums_3[i32(3)] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        column_2 = column_2 + u32(1);
    }
    return sums_3;
}

fn dense_part_2( weights_5 : HalfWeights_0,  first_4 : u32,  adds_2 : bool,  inputs_5 : ptr<function, array<f32, i32(39)>>,  outputs_2 : ptr<function, array<f32, i32(64)>>)
{
    var _S46 : u32 = first_4 + u32(whole_parts_0(i32(8)));
    var output_2 : i32 = i32(0);
    for(;;)
    {
        var _S47 : bool = output_2 < i32(64);
        if(_S47)
        {
        }
        else
        {
            break;
        }
        var _S48 : u32 = u32(output_2);
        var _S49 : Eight_0 = HalfWeights_eight_0(weights_5, first_4 + _S48 / u32(8));
        var _S50 : vec4<f32> = tile_product_2(weights_5, _S46 + _S48 * u32(5), &((*inputs_5)));
        var _S51 : vec4<f32> = _S50 + select_vector_0(((output_2 & (i32(4)))) != i32(0), _S49.high_0, _S49.low_0);
        var _S52 : f32;
        if(_S47)
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[output_2];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S51[i32(0)] + _S52);
        }
        var _S53 : i32 = output_2 + i32(1);
        if(_S53 < i32(64))
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[_S53];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[_S53] = Identity_apply_0(_S51[i32(1)] + _S52);
        }
        var _S54 : i32 = output_2 + i32(2);
        if(_S54 < i32(64))
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[_S54];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[_S54] = Identity_apply_0(_S51[i32(2)] + _S52);
        }
        var _S55 : i32 = output_2 + i32(3);
        if(_S55 < i32(64))
        {
            if(adds_2)
            {
                _S52 = (*outputs_2)[_S55];
            }
            else
            {
                _S52 = 0.0f;
            }
            (*outputs_2)[_S55] = Identity_apply_0(_S51[i32(3)] + _S52);
        }
        output_2 = output_2 + i32(4);
    }
    return;
}

fn tile_product_3( weights_6 : HalfWeights_0,  row_3 : u32,  inputs_6 : ptr<function, array<f32, i32(68)>>) -> vec4<f32>
{
    var sums_4 : vec4<f32> = vec4<f32>(0.0f);
    var column_3 : u32 = u32(0);
    for(;;)
    {
        if(column_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var low_4 : vec4<f32>;
        var high_4 : vec4<f32>;
        var _S56 : i32 = i32(u32(8) * column_3);
        low_4[i32(0)] = (*inputs_6)[min(_S56, i32(67))];
        high_4[i32(0)] = (*inputs_6)[min(_S56 + i32(4), i32(67))];
        var _S57 : i32 = _S56 + i32(1);
        low_4[i32(1)] = (*inputs_6)[min(_S57, i32(67))];
        high_4[i32(1)] = (*inputs_6)[min(_S57 + i32(4), i32(67))];
        var _S58 : i32 = _S56 + i32(2);
        low_4[i32(2)] = (*inputs_6)[min(_S58, i32(67))];
        high_4[i32(2)] = (*inputs_6)[min(_S58 + i32(4), i32(67))];
        var _S59 : i32 = _S56 + i32(3);
        low_4[i32(3)] = (*inputs_6)[min(_S59, i32(67))];
        high_4[i32(3)] = (*inputs_6)[min(_S59 + i32(4), i32(67))];
        var _S60 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        sums_4[i32(0)] = sums_4[i32(0)] + (dot(_S60.low_0, low_4) + dot(_S60.high_0, high_4));
        var _S61 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(9) + column_3);
        sums_4[i32(1)] = sums_4[i32(1)] + (dot(_S61.low_0, low_4) + dot(_S61.high_0, high_4));
        var _S62 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(18) + column_3);
        sums_4[i32(2)] = sums_4[i32(2)] + (dot(_S62.low_0, low_4) + dot(_S62.high_0, high_4));
        var _S63 : Eight_0 = HalfWeights_eight_0(weights_6, row_3 + u32(27) + column_3);
        sums_4[i32(3)] = sums_4[i32(3)] + (dot(_S63.low_0, low_4) + dot(_S63.high_0, high_4));
        column_3 = column_3 + u32(1);
    }
    return sums_4;
}

fn dense_part_3( weights_7 : HalfWeights_0,  first_5 : u32,  adds_3 : bool,  inputs_7 : ptr<function, array<f32, i32(68)>>,  outputs_3 : ptr<function, array<f32, i32(64)>>)
{
    var _S64 : u32 = first_5 + u32(whole_parts_0(i32(8)));
    var output_3 : i32 = i32(0);
    for(;;)
    {
        var _S65 : bool = output_3 < i32(64);
        if(_S65)
        {
        }
        else
        {
            break;
        }
        var _S66 : u32 = u32(output_3);
        var _S67 : Eight_0 = HalfWeights_eight_0(weights_7, first_5 + _S66 / u32(8));
        var _S68 : vec4<f32> = tile_product_3(weights_7, _S64 + _S66 * u32(9), &((*inputs_7)));
        var _S69 : vec4<f32> = _S68 + select_vector_0(((output_3 & (i32(4)))) != i32(0), _S67.high_0, _S67.low_0);
        var _S70 : f32;
        if(_S65)
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[output_3];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S69[i32(0)] + _S70);
        }
        var _S71 : i32 = output_3 + i32(1);
        if(_S71 < i32(64))
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[_S71];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[_S71] = Identity_apply_0(_S69[i32(1)] + _S70);
        }
        var _S72 : i32 = output_3 + i32(2);
        if(_S72 < i32(64))
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[_S72];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[_S72] = Identity_apply_0(_S69[i32(2)] + _S70);
        }
        var _S73 : i32 = output_3 + i32(3);
        if(_S73 < i32(64))
        {
            if(adds_3)
            {
                _S70 = (*outputs_3)[_S73];
            }
            else
            {
                _S70 = 0.0f;
            }
            (*outputs_3)[_S73] = Identity_apply_0(_S69[i32(3)] + _S70);
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
        var _S74 : i32 = i32(u32(8) * column_4);
        low_5[i32(0)] = (*inputs_8)[_S74];
        high_5[i32(0)] = (*inputs_8)[_S74 + i32(4)];
        var _S75 : i32 = _S74 + i32(1);
        low_5[i32(1)] = (*inputs_8)[_S75];
        high_5[i32(1)] = (*inputs_8)[_S75 + i32(4)];
        var _S76 : i32 = _S74 + i32(2);
        low_5[i32(2)] = (*inputs_8)[_S76];
        high_5[i32(2)] = (*inputs_8)[_S76 + i32(4)];
        var _S77 : i32 = _S74 + i32(3);
        low_5[i32(3)] = (*inputs_8)[_S77];
        high_5[i32(3)] = (*inputs_8)[_S77 + i32(4)];
        var _S78 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        sums_5[i32(0)] = sums_5[i32(0)] + (dot(_S78.low_0, low_5) + dot(_S78.high_0, high_5));
        var _S79 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(2) + column_4);
        sums_5[i32(1)] = sums_5[i32(1)] + (dot(_S79.low_0, low_5) + dot(_S79.high_0, high_5));
        var _S80 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(4) + column_4);
        sums_5[i32(2)] = sums_5[i32(2)] + (dot(_S80.low_0, low_5) + dot(_S80.high_0, high_5));
        var _S81 : Eight_0 = HalfWeights_eight_0(weights_8, row_4 + u32(6) + column_4);
        sums_5[i32(3)] = sums_5[i32(3)] + (dot(_S81.low_0, low_5) + dot(_S81.high_0, high_5));
        column_4 = column_4 + u32(1);
    }
    return sums_5;
}

fn dense_part_4( weights_9 : HalfWeights_0,  first_6 : u32,  adds_4 : bool,  inputs_9 : ptr<function, array<f32, i32(16)>>,  outputs_4 : ptr<function, array<f32, i32(1)>>)
{
    var _S82 : u32 = first_6 + u32(whole_parts_0(i32(1)));
    var output_4 : i32 = i32(0);
    for(;;)
    {
        var _S83 : bool = output_4 < i32(1);
        if(_S83)
        {
        }
        else
        {
            break;
        }
        var _S84 : u32 = u32(output_4);
        var _S85 : Eight_0 = HalfWeights_eight_0(weights_9, first_6 + _S84 / u32(8));
        var _S86 : vec4<f32> = tile_product_4(weights_9, _S82 + _S84 * u32(2), &((*inputs_9)));
        var _S87 : vec4<f32> = _S86 + select_vector_0(((output_4 & (i32(4)))) != i32(0), _S85.high_0, _S85.low_0);
        var _S88 : f32;
        if(_S83)
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[output_4];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S87[i32(0)] + _S88);
        }
        var _S89 : i32 = output_4 + i32(1);
        if(_S89 < i32(1))
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[_S89];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[_S89] = Identity_apply_0(_S87[i32(1)] + _S88);
        }
        var _S90 : i32 = output_4 + i32(2);
        if(_S90 < i32(1))
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[_S90];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[_S90] = Identity_apply_0(_S87[i32(2)] + _S88);
        }
        var _S91 : i32 = output_4 + i32(3);
        if(_S91 < i32(1))
        {
            if(adds_4)
            {
                _S88 = (*outputs_4)[_S91];
            }
            else
            {
                _S88 = 0.0f;
            }
            (*outputs_4)[_S91] = Identity_apply_0(_S87[i32(3)] + _S88);
        }
        output_4 = output_4 + i32(4);
    }
    return;
}

fn LeakyRelu_apply_0( x_1 : f32) -> f32
{
    return max(x_1, x_1 * 0.00999999977648258f);
}

fn dense_part_5( weights_10 : HalfWeights_0,  first_7 : u32,  adds_5 : bool,  inputs_10 : ptr<function, array<f32, i32(64)>>,  outputs_5 : ptr<function, array<f32, i32(64)>>)
{
    var _S92 : u32 = first_7 + u32(whole_parts_0(i32(8)));
    var output_5 : i32 = i32(0);
    for(;;)
    {
        var _S93 : bool = output_5 < i32(64);
        if(_S93)
        {
        }
        else
        {
            break;
        }
        var _S94 : u32 = u32(output_5);
        var _S95 : Eight_0 = HalfWeights_eight_0(weights_10, first_7 + _S94 / u32(8));
        var _S96 : vec4<f32> = tile_product_1(weights_10, _S92 + _S94 * u32(8), &((*inputs_10)));
        var _S97 : vec4<f32> = _S96 + select_vector_0(((output_5 & (i32(4)))) != i32(0), _S95.high_0, _S95.low_0);
        var _S98 : f32;
        if(_S93)
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[output_5];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S97[i32(0)] + _S98);
        }
        var _S99 : i32 = output_5 + i32(1);
        if(_S99 < i32(64))
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[_S99];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[_S99] = LeakyRelu_apply_0(_S97[i32(1)] + _S98);
        }
        var _S100 : i32 = output_5 + i32(2);
        if(_S100 < i32(64))
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[_S100];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[_S100] = LeakyRelu_apply_0(_S97[i32(2)] + _S98);
        }
        var _S101 : i32 = output_5 + i32(3);
        if(_S101 < i32(64))
        {
            if(adds_5)
            {
                _S98 = (*outputs_5)[_S101];
            }
            else
            {
                _S98 = 0.0f;
            }
            (*outputs_5)[_S101] = LeakyRelu_apply_0(_S97[i32(3)] + _S98);
        }
        output_5 = output_5 + i32(4);
    }
    return;
}

fn dense_part_6( weights_11 : HalfWeights_0,  first_8 : u32,  adds_6 : bool,  inputs_11 : ptr<function, array<f32, i32(68)>>,  outputs_6 : ptr<function, array<f32, i32(16)>>)
{
    var _S102 : u32 = first_8 + u32(whole_parts_0(i32(2)));
    var output_6 : i32 = i32(0);
    for(;;)
    {
        var _S103 : bool = output_6 < i32(16);
        if(_S103)
        {
        }
        else
        {
            break;
        }
        var _S104 : u32 = u32(output_6);
        var _S105 : Eight_0 = HalfWeights_eight_0(weights_11, first_8 + _S104 / u32(8));
        var _S106 : vec4<f32> = tile_product_3(weights_11, _S102 + _S104 * u32(9), &((*inputs_11)));
        var _S107 : vec4<f32> = _S106 + select_vector_0(((output_6 & (i32(4)))) != i32(0), _S105.high_0, _S105.low_0);
        var _S108 : f32;
        if(_S103)
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[output_6];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S107[i32(0)] + _S108);
        }
        var _S109 : i32 = output_6 + i32(1);
        if(_S109 < i32(16))
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[_S109];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[_S109] = LeakyRelu_apply_0(_S107[i32(1)] + _S108);
        }
        var _S110 : i32 = output_6 + i32(2);
        if(_S110 < i32(16))
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[_S110];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[_S110] = LeakyRelu_apply_0(_S107[i32(2)] + _S108);
        }
        var _S111 : i32 = output_6 + i32(3);
        if(_S111 < i32(16))
        {
            if(adds_6)
            {
                _S108 = (*outputs_6)[_S111];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_6)[_S111] = LeakyRelu_apply_0(_S107[i32(3)] + _S108);
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
        var _S112 : i32 = i32(u32(8) * column_5);
        low_6[i32(0)] = (*inputs_12)[_S112];
        high_6[i32(0)] = (*inputs_12)[_S112 + i32(4)];
        var _S113 : i32 = _S112 + i32(1);
        low_6[i32(1)] = (*inputs_12)[_S113];
        high_6[i32(1)] = (*inputs_12)[_S113 + i32(4)];
        var _S114 : i32 = _S112 + i32(2);
        low_6[i32(2)] = (*inputs_12)[_S114];
        high_6[i32(2)] = (*inputs_12)[_S114 + i32(4)];
        var _S115 : i32 = _S112 + i32(3);
        low_6[i32(3)] = (*inputs_12)[_S115];
        high_6[i32(3)] = (*inputs_12)[_S115 + i32(4)];
        var _S116 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        sums_6[i32(0)] = sums_6[i32(0)] + (dot(_S116.low_0, low_6) + dot(_S116.high_0, high_6));
        var _S117 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(11) + column_5);
        sums_6[i32(1)] = sums_6[i32(1)] + (dot(_S117.low_0, low_6) + dot(_S117.high_0, high_6));
        var _S118 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(22) + column_5);
        sums_6[i32(2)] = sums_6[i32(2)] + (dot(_S118.low_0, low_6) + dot(_S118.high_0, high_6));
        var _S119 : Eight_0 = HalfWeights_eight_0(weights_12, row_5 + u32(33) + column_5);
        sums_6[i32(3)] = sums_6[i32(3)] + (dot(_S119.low_0, low_6) + dot(_S119.high_0, high_6));
        column_5 = column_5 + u32(1);
    }
    return sums_6;
}

fn dense_part_7( weights_13 : HalfWeights_0,  first_9 : u32,  adds_7 : bool,  inputs_13 : ptr<function, array<f32, i32(88)>>,  outputs_7 : ptr<function, array<f32, i32(64)>>)
{
    var _S120 : u32 = first_9 + u32(whole_parts_0(i32(8)));
    var output_7 : i32 = i32(0);
    for(;;)
    {
        var _S121 : bool = output_7 < i32(64);
        if(_S121)
        {
        }
        else
        {
            break;
        }
        var _S122 : u32 = u32(output_7);
        var _S123 : Eight_0 = HalfWeights_eight_0(weights_13, first_9 + _S122 / u32(8));
        var _S124 : vec4<f32> = tile_product_5(weights_13, _S120 + _S122 * u32(11), &((*inputs_13)));
        var _S125 : vec4<f32> = _S124 + select_vector_0(((output_7 & (i32(4)))) != i32(0), _S123.high_0, _S123.low_0);
        var _S126 : f32;
        if(_S121)
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[output_7];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S125[i32(0)] + _S126);
        }
        var _S127 : i32 = output_7 + i32(1);
        if(_S127 < i32(64))
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[_S127];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[_S127] = LeakyRelu_apply_0(_S125[i32(1)] + _S126);
        }
        var _S128 : i32 = output_7 + i32(2);
        if(_S128 < i32(64))
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[_S128];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[_S128] = LeakyRelu_apply_0(_S125[i32(2)] + _S126);
        }
        var _S129 : i32 = output_7 + i32(3);
        if(_S129 < i32(64))
        {
            if(adds_7)
            {
                _S126 = (*outputs_7)[_S129];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_7)[_S129] = LeakyRelu_apply_0(_S125[i32(3)] + _S126);
        }
        output_7 = output_7 + i32(4);
    }
    return;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn rsqrt_0( x_2 : f32) -> f32
{
    return 1.0f / sqrt(x_2);
}

fn select_vector_2( condition_2 : bool,  yes_2 : vec3<f32>,  no_2 : vec3<f32>) -> vec3<f32>
{
    var chosen_2 : vec3<f32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    return chosen_2;
}

fn dense_0( weights_14 : FloatWeights_0,  first_10 : u32,  adds_8 : bool,  inputs_14 : ptr<function, array<f32, i32(64)>>,  outputs_8 : ptr<function, array<f32, i32(50)>>)
{
    dense_part_0(weights_14, first_10, adds_8, &((*inputs_14)), &((*outputs_8)));
    return;
}

fn dense_1( weights_15 : HalfWeights_0,  first_11 : u32,  adds_9 : bool,  inputs_15 : ptr<function, array<f32, i32(64)>>,  outputs_9 : ptr<function, array<f32, i32(52)>>)
{
    dense_part_1(weights_15, first_11, adds_9, &((*inputs_15)), &((*outputs_9)));
    return;
}

fn dense_2( weights_16 : HalfWeights_0,  first_12 : u32,  adds_10 : bool,  inputs_16 : ptr<function, array<f32, i32(64)>>,  outputs_10 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_5(weights_16, first_12, adds_10, &((*inputs_16)), &((*outputs_10)));
    return;
}

fn dense_3( weights_17 : HalfWeights_0,  first_13 : u32,  adds_11 : bool,  inputs_17 : ptr<function, array<f32, i32(39)>>,  outputs_11 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_2(weights_17, first_13, adds_11, &((*inputs_17)), &((*outputs_11)));
    return;
}

fn select_vector_3( condition_3 : bool,  yes_3 : vec4<u32>,  no_3 : vec4<u32>) -> vec4<u32>
{
    var chosen_3 : vec4<u32>;
    chosen_3[i32(0)] = select(no_3[i32(0)], yes_3[i32(0)], condition_3);
    chosen_3[i32(1)] = select(no_3[i32(1)], yes_3[i32(1)], condition_3);
    chosen_3[i32(2)] = select(no_3[i32(2)], yes_3[i32(2)], condition_3);
    chosen_3[i32(3)] = select(no_3[i32(3)], yes_3[i32(3)], condition_3);
    return chosen_3;
}

fn dense_4( weights_18 : HalfWeights_0,  first_14 : u32,  adds_12 : bool,  inputs_18 : ptr<function, array<f32, i32(68)>>,  outputs_12 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_3(weights_18, first_14, adds_12, &((*inputs_18)), &((*outputs_12)));
    return;
}

fn dense_5( weights_19 : HalfWeights_0,  first_15 : u32,  adds_13 : bool,  inputs_19 : ptr<function, array<f32, i32(16)>>,  outputs_13 : ptr<function, array<f32, i32(1)>>)
{
    dense_part_4(weights_19, first_15, adds_13, &((*inputs_19)), &((*outputs_13)));
    return;
}

fn dense_6( weights_20 : HalfWeights_0,  first_16 : u32,  adds_14 : bool,  inputs_20 : ptr<function, array<f32, i32(68)>>,  outputs_14 : ptr<function, array<f32, i32(16)>>)
{
    dense_part_6(weights_20, first_16, adds_14, &((*inputs_20)), &((*outputs_14)));
    return;
}

fn dense_part_8( weights_21 : HalfWeights_0,  first_17 : u32,  adds_15 : bool,  inputs_21 : ptr<function, array<f32, i32(64)>>,  outputs_15 : ptr<function, array<f32, i32(68)>>)
{
    var _S130 : u32 = first_17 + u32(whole_parts_0(i32(8)));
    var output_8 : i32 = i32(0);
    for(;;)
    {
        var _S131 : bool = output_8 < i32(64);
        if(_S131)
        {
        }
        else
        {
            break;
        }
        var _S132 : u32 = u32(output_8);
        var _S133 : Eight_0 = HalfWeights_eight_0(weights_21, first_17 + _S132 / u32(8));
        var _S134 : vec4<f32> = tile_product_1(weights_21, _S130 + _S132 * u32(8), &((*inputs_21)));
        var _S135 : vec4<f32> = _S134 + select_vector_0(((output_8 & (i32(4)))) != i32(0), _S133.high_0, _S133.low_0);
        var _S136 : f32;
        if(_S131)
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[output_8];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S135[i32(0)] + _S136);
        }
        var _S137 : i32 = output_8 + i32(1);
        if(_S137 < i32(64))
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[_S137];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[_S137] = LeakyRelu_apply_0(_S135[i32(1)] + _S136);
        }
        var _S138 : i32 = output_8 + i32(2);
        if(_S138 < i32(64))
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[_S138];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[_S138] = LeakyRelu_apply_0(_S135[i32(2)] + _S136);
        }
        var _S139 : i32 = output_8 + i32(3);
        if(_S139 < i32(64))
        {
            if(adds_15)
            {
                _S136 = (*outputs_15)[_S139];
            }
            else
            {
                _S136 = 0.0f;
            }
            (*outputs_15)[_S139] = LeakyRelu_apply_0(_S135[i32(3)] + _S136);
        }
        output_8 = output_8 + i32(4);
    }
    return;
}

fn dense_7( weights_22 : HalfWeights_0,  first_18 : u32,  adds_16 : bool,  inputs_22 : ptr<function, array<f32, i32(88)>>,  outputs_16 : ptr<function, array<f32, i32(64)>>)
{
    dense_part_7(weights_22, first_18, adds_16, &((*inputs_22)), &((*outputs_16)));
    return;
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn fabric_of_0( face_1 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_1];
}

struct Vertex_0
{
     x_3 : f32,
     y_0 : f32,
     z_0 : f32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     u_0 : f32,
     v_0 : f32,
};

fn scene_vertex_0( first_19 : u32) -> Vertex_0
{
    var record_0 : Vertex_0;
    record_0.x_3 = (bitcast<f32>((scene_words_0[first_19])));
    record_0.y_0 = (bitcast<f32>((scene_words_0[first_19 + u32(1)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_19 + u32(2)])));
    record_0.normal_x_0 = (bitcast<f32>((scene_words_0[first_19 + u32(3)])));
    record_0.normal_y_0 = (bitcast<f32>((scene_words_0[first_19 + u32(4)])));
    record_0.normal_z_0 = (bitcast<f32>((scene_words_0[first_19 + u32(5)])));
    record_0.u_0 = (bitcast<f32>((scene_words_0[first_19 + u32(6)])));
    record_0.v_0 = (bitcast<f32>((scene_words_0[first_19 + u32(7)])));
    return record_0;
}

fn vertex_at_0( corner_0 : u32) -> Vertex_0
{
    return scene_vertex_0(frame_record_0.vertices_0 + u32(8) * scene_words_0[frame_record_0.corners_0 + corner_0]);
}

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.x_3, vertex_0.y_0, vertex_0.z_0);
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
    var _S140 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S141 : u32 = ((((_S140 >> ((((_S140 >> (u32(28)))) + u32(4))))) ^ (_S140))) * u32(277803737);
    return (((_S141 >> (u32(22)))) ^ (_S141));
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
    var _S142 : vec2<f32> = floor(place_0);
    var _S143 : vec2<f32> = place_0 - _S142;
    var _S144 : vec2<f32> = _S143 * _S143 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S143);
    var _S145 : u32 = u32(i32(_S142.x)) * u32(65536) + u32(i32(_S142.y));
    var _S146 : f32 = _S144.x;
    return mix(mix(uneven_corner_0(key_2, _S145), uneven_corner_0(key_2, _S145 + u32(65536)), _S146), mix(uneven_corner_0(key_2, _S145 + u32(1)), uneven_corner_0(key_2, _S145 + u32(65537)), _S146), _S144.y);
}

fn square_1( x_4 : f32) -> f32
{
    return x_4 * x_4;
}

fn natural_logarithm_0( x_5 : f32) -> f32
{
    var _S147 : u32 = (bitcast<u32>((x_5)));
    var m_0 : f32 = (bitcast<f32>(((((_S147 & (u32(8388607)))) | (u32(1056964608))))));
    var _S148 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S147 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S148);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S148) - 1.0f;
    var _S149 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S149 - exponent_0 * 0.00021219444170129f - 0.5f * _S149) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_6 : f32) -> f32
{
    return natural_logarithm_0(x_6) * 1.4426950216293335f;
}

fn exponential_0( x_7 : f32) -> f32
{
    var _S150 : f32 = clamp(x_7, -87.0f, 88.0f);
    var _S151 : f32 = floor(_S150 * 1.4426950216293335f + 0.5f);
    var _S152 : f32 = _S150 - _S151 * 0.693359375f + _S151 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S152 + 0.00139819993637502f) * _S152 + 0.00833345204591751f) * _S152 + 0.04166579619050026f) * _S152 + 0.1666666567325592f) * _S152 + 0.5f) * _S152 * _S152 + _S152 + 1.0f) * (bitcast<f32>(((u32(i32(_S151) + i32(127)) << (u32(23)))))), 0.0f, x_7 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S153 : u32 = scene_words_0[index_0];
    var _S154 : vec3<f32> = vec3<f32>(f32((_S153 & (u32(1023)))), f32((((_S153 >> (u32(10)))) & (u32(1023)))), f32((_S153 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S154 * _S154;
}

fn map_level_0( first_20 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S155 : f32 = uv_0.x;
    var _S156 : f32 = f32(side_0);
    var _S157 : f32 = (_S155 - floor(_S155)) * _S156 - 0.5f;
    var _S158 : f32 = uv_0.y;
    var _S159 : f32 = (_S158 - floor(_S158)) * _S156 - 0.5f;
    var _S160 : f32 = floor(_S157);
    var _S161 : i32 = i32(side_0);
    var _S162 : u32 = side_0 - u32(1);
    var _S163 : u32 = (u32(i32(_S160) + _S161) & (_S162));
    var _S164 : f32 = floor(_S159);
    var _S165 : u32 = (u32(i32(_S164) + _S161) & (_S162));
    var _S166 : u32 = ((_S163 + u32(1)) & (_S162));
    var _S167 : u32 = first_20 + _S165 * side_0;
    var _S168 : vec3<f32> = vec3<f32>((_S157 - _S160));
    var _S169 : u32 = first_20 + (((_S165 + u32(1)) & (_S162))) * side_0;
    return mix(mix(map_texel_0(_S167 + _S163), map_texel_0(_S167 + _S166), _S168), mix(map_texel_0(_S169 + _S163), map_texel_0(_S169 + _S166), _S168), vec3<f32>((_S159 - _S164)));
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_2 : Footprint_0) -> f32
{
    var _S170 : vec2<f32> = this_2.dx_0;
    var _S171 : vec2<f32> = this_2.dy_0;
    return sqrt(0.5f * (dot(_S170, _S170) + dot(_S171, _S171)));
}

@id(0) override HAS_LAYERS_0 : bool = true;

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn moved_share_0( family_0 : u32,  size_2 : f32) -> f32
{
    return fade_0(size_2, families_0[family_0].period_0 / families_0[family_0].count_0);
}

fn turns_and_remainder_0( family_1 : u32,  index_1 : f32) -> vec2<f32>
{
    var _S172 : f32 = floor(fma(index_1, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S172, fma(- _S172, families_0[family_1].count_0, index_1));
}

struct Cell_0
{
     thread_1 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_2 : u32,  position_0 : f32) -> Cell_0
{
    var _S173 : f32 = floor(position_0 * families_0[family_2].inverse_size_0);
    var cell_2 : Cell_0;
    var _S174 : f32 = fma(- _S173, families_0[family_2].size_0, position_0);
    cell_2.below_0 = _S174;
    cell_2.above_0 = families_0[family_2].size_0 - _S174;
    cell_2.across_0 = _S174 - 0.5f * families_0[family_2].size_0;
    cell_2.half_width_1 = families_0[family_2].half_width_0;
    cell_2.thread_1 = u32(clamp(turns_and_remainder_0(family_2, _S173).y, 0.0f, families_0[family_2].count_0 - 1.0f));
    return cell_2;
}

fn table_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_2])));
}

fn locate_varied_0( family_3 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_3].start_0) * families_0[family_3].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S175 : f32 = turns_1 * families_0[family_3].period_0;
    var thread_2 : u32 = words_0[families_0[family_3].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_3].bins_0, 0.0f, families_0[family_3].bins_0 - 1.0f))];
    var _S176 : u32 = min(thread_2 + select(u32(0), u32(1), _S175 >= (table_number_0(families_0[family_3].place_table_0 + thread_2 * u32(4) + u32(1)))), u32(families_0[family_3].count_0) - u32(1));
    var _S177 : u32 = families_0[family_3].place_table_0 + _S176 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_1 = _S176;
    cell_3.below_0 = _S175 - table_number_0(_S177);
    cell_3.above_0 = table_number_0(_S177 + u32(1)) - _S175;
    cell_3.across_0 = _S175 - table_number_0(_S177 + u32(2));
    cell_3.half_width_1 = table_number_0(_S177 + u32(3));
    return cell_3;
}

fn locate_0( family_4 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_4].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_4, position_2);
    }
    return locate_varied_0(family_4, position_2);
}

fn irregular_thread_0( family_5 : u32,  position_3 : f32,  cell_4 : Cell_0) -> f32
{
    return floor((position_3 - cell_4.across_0) / families_0[family_5].period_0) * families_0[family_5].count_0 + f32(cell_4.thread_1);
}

fn irregular_entry_0( row_6 : u32,  column_6 : f32) -> vec4<u32>
{
    var _S178 : u32 = row_6 + u32(4) * ((u32(i32(column_6)) & (u32(1023))));
    return vec4<u32>(words_0[_S178], words_0[_S178 + u32(1)], words_0[_S178 + u32(2)], words_0[_S178 + u32(3)]);
}

fn irregular_integral_0( family_6 : u32,  threads_0 : u32,  begin_0 : f32,  steps_0 : f32) -> vec4<f32>
{
    var _S179 : u32 = families_0[family_6].irregular_table_0 + threads_0 * u32(4096);
    var _S180 : f32 = begin_0 + steps_0;
    var _S181 : f32 = floor(begin_0);
    var _S182 : vec4<u32> = irregular_entry_0(_S179, _S181);
    var _S183 : f32 = floor(_S180);
    var _S184 : vec4<u32> = irregular_entry_0(_S179, _S183);
    return vec4<f32>(vec4<i32>(_S184 - _S182)) + (vec4<f32>(vec4<i32>(irregular_entry_0(_S179, _S183 + 1.0f) - _S184)) * vec4<f32>((_S180 - _S183)) - vec4<f32>(vec4<i32>(irregular_entry_0(_S179, _S181 + 1.0f) - _S182)) * vec4<f32>((begin_0 - _S181)));
}

fn irregular_units_0( family_7 : u32) -> vec4<f32>
{
    return vec4<f32>(families_0[family_7].irregular_thickness_0, families_0[family_7].irregular_cover_0, families_0[family_7].irregular_tone_0, families_0[family_7].irregular_nep_0);
}

fn irregular_at_0( family_8 : u32,  key_3 : u32,  number_0 : f32,  along_0 : f32) -> vec4<f32>
{
    var _S185 : f32 = floor(number_0 / 64.0f);
    var _S186 : u32 = hash_bits_0(key_3, u32(i32(_S185)));
    var _S187 : u32 = ((_S186 & (u32(127)))) + u32(number_0 - 64.0f * _S185);
    var _S188 : f32 = along_0 / 2.0f - 0.5f + f32((_S186 >> (u32(22))));
    var sums_7 : vec4<f32> = vec4<f32>(0.0f);
    var side_1 : u32 = u32(0);
    for(;;)
    {
        if(side_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S189 : vec4<f32> = irregular_integral_0(family_8, _S187 + side_1, _S188, 1.0f) - sums_7;
        var _S190 : u32 = side_1 + u32(1);
        sums_7 = _S189;
        side_1 = _S190;
    }
    return sums_7 * irregular_units_0(family_8);
}

struct VisiblePoint_0
{
     position_4 : vec3<f32>,
     view_0 : vec3<f32>,
     axis_x_0 : vec3<f32>,
     axis_y_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     uv_1 : vec2<f32>,
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
    var _S191 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S191, - _S191, back_2));
}

fn row_of_taps_0( footprint_0 : Footprint_0) -> vec3<f32>
{
    var _S192 : f32 = footprint_0.dx_0.x;
    var _S193 : f32 = footprint_0.dy_0.x;
    var _S194 : f32 = _S192 * _S192 + _S193 * _S193;
    var _S195 : f32 = footprint_0.dx_0.y;
    var _S196 : f32 = footprint_0.dy_0.y;
    var _S197 : f32 = _S195 * _S195 + _S196 * _S196;
    var _S198 : f32 = _S192 * _S195 + _S193 * _S196;
    var _S199 : f32 = 0.5f * (_S194 - _S197);
    var _S200 : f32 = 0.5f * (_S194 + _S197);
    var _S201 : f32 = sqrt(_S199 * _S199 + _S198 * _S198);
    var _S202 : f32 = _S200 + _S201;
    var _S203 : f32 = max(_S202 - 1.5f * max(_S200 - _S201, 0.0f), 0.0f);
    var _S204 : f32 = square_1(4.0f);
    var _S205 : f32 = max(_S200 - 0.5f * _S203, _S202 / _S204);
    var _S206 : f32 = sqrt(max(min(_S203, _S202 - _S205), 0.0f) / (_S204 - 1.0f));
    var _S207 : f32 = _S199 / max(_S201, 1.00000000317107685e-30f);
    var _S208 : f32 = sqrt(max(0.5f * (1.0f - _S207), 0.0f));
    return vec3<f32>(sqrt(_S205), _S206 * sqrt(max(0.5f * (1.0f + _S207), 0.0f)), select(_S206 * _S208, - _S206 * _S208, _S198 < 0.0f));
}

struct AnisotropicTaps_0
{
     centre_1 : vec2<f32>,
     side_2 : f32,
     first_21 : vec2<f32>,
     second_0 : vec2<f32>,
};

fn AnisotropicTaps_size_0( this_3 : AnisotropicTaps_0) -> f32
{
    var _S209 : f32 = this_3.first_21.x;
    var _S210 : f32 = this_3.second_0.x;
    var _S211 : f32 = this_3.side_2;
    var _S212 : f32 = _S211 * _S211;
    var _S213 : f32 = this_3.first_21.y;
    var _S214 : f32 = this_3.second_0.y;
    var _S215 : f32 = 12.0f * (_S209 * _S213 + _S210 * _S214);
    return sqrt(sqrt(max((12.0f * (_S209 * _S209 + _S210 * _S210) + _S212) * (12.0f * (_S213 * _S213 + _S214 * _S214) + _S212) - _S215 * _S215, square_1(_S212))));
}

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn default_quality_0() -> SearchQuality_0
{
    var quality_0 : SearchQuality_0;
    quality_0.steps_per_thread_0 = 5.0f;
    quality_0.steps_per_relief_0 = 8.0f;
    quality_0.shadow_share_0 = 1.0f;
    quality_0.refinements_0 = u32(2);
    return quality_0;
}

struct Plane_0
{
     warp_1 : u32,
     weft_1 : u32,
     run_words_1 : u32,
     ends_2 : u32,
     end_numbers_0 : u32,
     pick_numbers_0 : u32,
     max_heights_1 : u32,
     max_height_columns_1 : u32,
     height_low_1 : f32,
     height_high_1 : f32,
     front_level_0 : f32,
     back_level_0 : f32,
     start_x_0 : f32,
     start_y_0 : f32,
     fine_x_0 : f32,
     fine_y_0 : f32,
};

fn plane_at_0( first_22 : u32) -> Plane_0
{
    var record_1 : Plane_0;
    record_1.warp_1 = words_0[first_22];
    record_1.weft_1 = words_0[first_22 + u32(1)];
    record_1.run_words_1 = words_0[first_22 + u32(2)];
    record_1.ends_2 = words_0[first_22 + u32(3)];
    record_1.end_numbers_0 = words_0[first_22 + u32(4)];
    record_1.pick_numbers_0 = words_0[first_22 + u32(5)];
    record_1.max_heights_1 = words_0[first_22 + u32(6)];
    record_1.max_height_columns_1 = words_0[first_22 + u32(7)];
    record_1.height_low_1 = (bitcast<f32>((words_0[first_22 + u32(8)])));
    record_1.height_high_1 = (bitcast<f32>((words_0[first_22 + u32(9)])));
    record_1.front_level_0 = (bitcast<f32>((words_0[first_22 + u32(10)])));
    record_1.back_level_0 = (bitcast<f32>((words_0[first_22 + u32(11)])));
    record_1.start_x_0 = (bitcast<f32>((words_0[first_22 + u32(12)])));
    record_1.start_y_0 = (bitcast<f32>((words_0[first_22 + u32(13)])));
    record_1.fine_x_0 = (bitcast<f32>((words_0[first_22 + u32(14)])));
    record_1.fine_y_0 = (bitcast<f32>((words_0[first_22 + u32(15)])));
    return record_1;
}

struct Crossing_0
{
     warp_2 : Cell_0,
     weft_2 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn crossing_at_0( plane_0 : Plane_0,  x_8 : f32,  y_1 : f32,  back_3 : bool) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.warp_2 = locate_0(plane_0.warp_1, x_8 - plane_0.start_x_0);
    crossing_0.weft_2 = locate_0(plane_0.weft_1, y_1 - plane_0.start_y_0);
    var _S216 : u32 = plane_0.run_words_1 + u32(2) * (crossing_0.weft_2.thread_1 * plane_0.ends_2 + crossing_0.warp_2.thread_1);
    var _S217 : u32 = words_0[_S216];
    crossing_0.warp_word_0 = _S217;
    crossing_0.weft_word_0 = words_0[_S216 + u32(1)];
    crossing_0.warp_above_0 = (((_S217 & (u32(1)))) == u32(1)) != back_3;
    return crossing_0;
}

fn cell_maximum_0( plane_1 : Plane_0,  crossing_1 : Crossing_0) -> f32
{
    var _S218 : u32 = select(plane_1.weft_1, plane_1.warp_1, crossing_1.warp_above_0);
    return f32((select(crossing_1.weft_word_0, crossing_1.warp_word_0, crossing_1.warp_above_0) >> (u32(28)))) * families_0[_S218].height_scale_0 * families_0[_S218].level_0;
}

fn bounds_in_0( plane_2 : Plane_0,  x_9 : f32,  y_2 : f32,  back_4 : bool,  right_0 : bool,  up_0 : bool) -> vec3<f32>
{
    var _S219 : Crossing_0 = crossing_at_0(plane_2, x_9, y_2, back_4);
    return vec3<f32>(cell_maximum_0(plane_2, _S219), select(_S219.warp_2.below_0, _S219.warp_2.above_0, right_0), select(_S219.weft_2.below_0, _S219.weft_2.above_0, up_0));
}

fn hole_edge_0( cell_5 : Cell_0,  forwards_0 : bool) -> f32
{
    var _S220 : f32 = select(- cell_5.across_0, cell_5.across_0, forwards_0);
    var _S221 : f32 = - cell_5.half_width_1;
    return select(select(cell_5.half_width_1, _S221, _S220 < _S221) - _S220, 2.0f * select(cell_5.below_0, cell_5.above_0, forwards_0) + _S220 - cell_5.half_width_1, _S220 >= (cell_5.half_width_1));
}

struct Shown_0
{
     is_warp_0 : bool,
     hole_0 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

fn shown_at_0( crossing_2 : Crossing_0,  back_5 : bool) -> Shown_0
{
    var _S222 : bool = (abs(crossing_2.warp_2.across_0)) < (crossing_2.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S223 : bool = !((abs(crossing_2.weft_2.across_0)) < (crossing_2.weft_2.half_width_1));
    var _S224 : bool = (_S222 & (((_S223 | ((crossing_2.warp_above_0))))));
    shown_0.is_warp_0 = _S224;
    shown_0.hole_0 = ((!_S222) & (_S223));
    var _S225 : u32 = select(crossing_2.weft_word_0, crossing_2.warp_word_0, _S224);
    shown_0.word_0 = _S225;
    shown_0.on_top_0 = (((_S225 & (u32(1)))) == u32(1)) != back_5;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_23 : Cell_0,  second_1 : Cell_0) -> Cell_0
{
    var cell_6 : Cell_0;
    cell_6.thread_1 = select(second_1.thread_1, first_23.thread_1, is_first_0);
    cell_6.across_0 = select(second_1.across_0, first_23.across_0, is_first_0);
    cell_6.half_width_1 = select(second_1.half_width_1, first_23.half_width_1, is_first_0);
    cell_6.below_0 = select(second_1.below_0, first_23.below_0, is_first_0);
    cell_6.above_0 = select(second_1.above_0, first_23.above_0, is_first_0);
    return cell_6;
}

fn boundary_0( family_9 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S226 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_3) + step_0));
    return fma(_S226.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S226.y) * u32(4)));
}

fn span_0( family_10 : u32,  thread_4 : u32,  first_24 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_10].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_24) * families_0[family_10].size_0;
    }
    return boundary_0(family_10, thread_4, last_0) - boundary_0(family_10, thread_4, first_24);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_11 : u32,  thread_5 : u32) -> Bend_0
{
    var _S227 : u32 = families_0[family_11].bend_table_0 + select(thread_5 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S227);
    bend_0.half_tangent_0 = table_number_0(_S227 + u32(1));
    bend_0.arc_0 = table_number_0(_S227 + u32(2));
    return bend_0;
}

struct Run_0
{
     distance_0 : f32,
     near_start_0 : bool,
     from_start_0 : f32,
     to_end_0 : f32,
     reach_0 : f32,
     other_reach_0 : f32,
     bend_1 : Bend_0,
     straight_0 : bool,
     first_crossing_0 : bool,
     last_crossing_0 : bool,
};

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_6 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S228 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S229 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S230 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S231 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S232 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S232;
    var _S233 : i32 = - _S228;
    var _S234 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S233, i32(0));
    run_0.from_start_0 = _S234;
    var _S235 : i32 = _S229 + i32(1);
    var _S236 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S235);
    run_0.to_end_0 = _S236;
    var _S237 : bool = _S234 < _S236;
    run_0.near_start_0 = _S237;
    var _S238 : i32 = select(_S235, _S233 - _S230, _S237);
    var _S239 : i32 = select(_S235 + _S231, _S233, _S237);
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    run_0.distance_0 = select(min(_S234, _S236), 1.0e+06f, _S232);
    run_0.reach_0 = min(0.5f * (_S234 + _S236), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S238, _S239), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S228 == i32(0);
    run_0.last_crossing_0 = _S229 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_7 : Cell_0) -> Section_0
{
    var _S240 : f32 = cell_7.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S241 : f32 = clamp(cell_7.across_0, - cell_7.half_width_1, cell_7.half_width_1);
    section_0.across_1 = _S241;
    var _S242 : f32 = _S240 * _S240 - square_1(_S241);
    var _S243 : f32 = rsqrt_0(_S242);
    section_0.drop_0 = _S240 - _S242 * _S243;
    section_0.slope_0 = - _S241 * _S243;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_7) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S244 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S245 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S246 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S244) - crossed_1.half_width_1;
    var _S247 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S244);
    var _S248 : f32;
    if(shown_1.on_top_0)
    {
        _S248 = 0.0f;
    }
    else
    {
        _S248 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S249 : f32;
    if((shown_1.on_top_0) != _S247)
    {
        _S249 = 0.0f;
    }
    else
    {
        _S249 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, select(i32(1), i32(-1), _S244));
    }
    var _S250 : f32 = 2.0f * _S246;
    var _S251 : f32 = 1.0f / max(_S250, 9.999999960041972e-13f);
    var _S252 : f32 = clamp((_S246 - _S245) * _S251, 0.0f, 1.0f);
    var _S253 : f32 = clamp((0.44999998807907104f - _S250 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S248 + (_S249 - _S248) * (_S252 * _S252 * (3.0f - 2.0f * _S252)), (_S248 - _S249) * (6.0f * _S252 * (1.0f - _S252) * _S251) * select(-1.0f, 1.0f, _S244), _S253 * _S253 * (3.0f - 2.0f * _S253));
}

struct PlaneHere_0
{
     plane_3 : Plane_0,
     number_1 : u32,
     level_1 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
     bounds_0 : vec3<f32>,
};

struct Sample_0
{
     here_0 : PlaneHere_0,
     crossing_3 : Crossing_0,
     shown_2 : Shown_0,
     run_2 : Run_0,
     section_1 : Section_0,
     height_2 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn sample_in_0( here_1 : PlaneHere_0,  x_10 : f32,  y_3 : f32,  back_6 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    sample_0.here_0 = here_1;
    var _S254 : Crossing_0 = crossing_at_0(here_1.plane_3, x_10, y_3, back_6);
    sample_0.crossing_3 = _S254;
    var _S255 : Shown_0 = shown_at_0(_S254, back_6);
    sample_0.shown_2 = _S255;
    var _S256 : u32 = select(here_1.plane_3.weft_1, here_1.plane_3.warp_1, _S255.is_warp_0);
    var _S257 : u32 = select(here_1.plane_3.warp_1, here_1.plane_3.weft_1, _S255.is_warp_0);
    var _S258 : Cell_0 = select_cell_0(_S255.is_warp_0, sample_0.crossing_3.warp_2, sample_0.crossing_3.weft_2);
    var _S259 : Cell_0 = select_cell_0(_S255.is_warp_0, sample_0.crossing_3.weft_2, sample_0.crossing_3.warp_2);
    var _S260 : Run_0 = unpack_0(_S256, _S257, _S258.thread_1, _S259, _S255.word_0);
    var _S261 : Section_0 = section_at_0(_S258);
    var _S262 : bool = ((_S255.on_top_0) & (((_S260.distance_0) < (_S261.drop_0 * _S260.bend_1.sine_0))));
    var _S263 : f32 = select(-1.0f, 1.0f, ((_S255.on_top_0) & ((!_S262))));
    var _S264 : f32 = select(_S260.reach_0, _S260.other_reach_0, _S262);
    var _S265 : f32 = select(max(_S264 - _S260.distance_0, 0.0f), _S264 + _S260.distance_0, _S262);
    var _S266 : f32 = _S264 / _S260.bend_1.sine_0 - _S263 * _S261.drop_0;
    var _S267 : f32 = _S265 * _S265;
    var _S268 : f32 = max(_S266 * _S266 - _S267, 9.99999968265522539e-21f);
    var _S269 : f32 = rsqrt_0(_S268);
    var _S270 : f32 = _S267 / (_S268 * _S269 + _S266);
    var _S271 : bool = _S265 > 0.0f;
    var _S272 : f32 = select(-1.0f, 1.0f, _S255.on_top_0) * select(-1.0f, 1.0f, _S260.near_start_0);
    var _S273 : f32 = _S261.slope_0 * select(1.0f, _S266 * _S269, _S271);
    sample_0.slope_across_0 = _S273;
    var _S274 : f32 = select(0.0f, _S272 * _S265 * _S269, _S271);
    sample_0.slope_along_0 = _S274;
    var _S275 : vec3<f32> = dive_0(_S257, _S255, _S260, _S259);
    sample_0.dive_1 = _S275;
    sample_0.height_2 = select(families_0[_S256].height_scale_0 * _S263, 0.0f, _S260.straight_0) * (_S264 * _S260.bend_1.half_tangent_0 - _S270) - families_0[_S256].height_scale_0 * _S261.drop_0 - _S275.x + here_1.level_1;
    var _S276 : f32 = families_0[_S256].height_scale_0 * _S273;
    var _S277 : f32 = families_0[_S256].height_scale_0 * _S274 - _S275.y;
    sample_0.slope_x_0 = select(_S277, _S276, _S255.is_warp_0);
    sample_0.slope_y_0 = select(_S276, _S277, _S255.is_warp_0);
    sample_0.run_2 = _S260;
    sample_0.section_1 = _S261;
    return sample_0;
}

struct StepControl_0
{
     step_2 : f32,
     epsilon_0 : f32,
     per_x_0 : f32,
     per_y_0 : f32,
     right_1 : bool,
     up_1 : bool,
};

fn step_control_0( direction_2 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S278 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S278), 9.99999971718068537e-10f);
    var _S279 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S279), 9.99999971718068537e-10f);
    control_0.right_1 = _S278 > 0.0f;
    control_0.up_1 = _S279 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
     clearance_0 : f32,
     rate_0 : f32,
     yarn_0 : u32,
     known_0 : bool,
};

fn no_previous_sample_0() -> PreviousSample_0
{
    var previous_0 : PreviousSample_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_0 = u32(0);
    previous_0.known_0 = false;
    return previous_0;
}

fn outline_distance_0( cell_8 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_1 : bool) -> f32
{
    var _S280 : f32 = select(- cell_8.across_0, cell_8.across_0, forwards_1);
    var _S281 : f32 = select(cell_8.below_0, cell_8.above_0, forwards_1);
    var _S282 : f32 = - cell_8.half_width_1;
    var _S283 : bool = _S280 < _S282;
    var _S284 : bool = _S280 >= (cell_8.half_width_1);
    var _S285 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_1))))) & ((!shown_3.hole_0)));
    var _S286 : f32 = select(cell_8.half_width_1, _S282, _S283) - _S280;
    var _S287 : f32 = select(_S281, 2.0f * _S281 + _S280 - cell_8.half_width_1, ((shown_3.hole_0) | (((_S285 & ((!shown_3.on_top_0)))))));
    if((((_S285 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_1) & (_S283)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_1);
    }
    return select(_S286, _S287, _S284);
}

struct Probe_0
{
     height_3 : f32,
     hole_1 : bool,
     slope_x_1 : f32,
     slope_y_1 : f32,
     yarn_1 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_1 : f32,
     edge_y_1 : f32,
};

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_2 : Probe_0) -> f32
{
    var _S288 : f32 = previous_1.rate_0 * step_4;
    var _S289 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_2.hole_1)))) | (((previous_1.yarn_0) != (here_2.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S288) >= 0.0f) & (((3.0f * clearance_1 - _S289) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S290 : f32 = clearance_1 - previous_1.clearance_0;
    var _S291 : f32 = 6.0f * _S290 - 4.0f * _S288 - 2.0f * _S289;
    var _S292 : f32 = -2.0f * _S288 / max(_S291 + sqrt(max(_S291 * _S291 - 4.0f * (3.0f * (_S288 + _S289 - 2.0f * _S290)) * _S288, 0.0f)), 9.99999968265522539e-21f);
    var _S293 : f32 = 1.0f - _S292;
    return select(-1.0f, _S293 * step_4, ((((_S292 > 0.01999999955296516f) & ((_S293 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S292 + 1.0f) + _S288 * _S292) * _S293 * _S293 + (clearance_1 * (2.0f * _S293 + 1.0f) - _S289 * _S293) * _S292 * _S292) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_3 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_3.hole_1);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_3.yarn_1;
    previous_2.known_0 = ((!here_3.hole_1) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_4 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_4.per_x_0, side_y_1 * this_4.per_y_0), 0.0f) + this_4.epsilon_0;
}

fn StepControl_to_next_sample_0( this_5 : StepControl_0,  here_4 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S294 : f32 = min(here_4.edge_x_1 * this_5.per_x_0, here_4.edge_y_1 * this_5.per_y_0);
    return min(this_5.step_2, select(max(_S294, 0.0f) + this_5.epsilon_0, _S294 - this_5.epsilon_0, ((((!here_4.hole_1) & (((rate_3 * _S294 + clearance_3) < 0.0f)))) & ((_S294 > (2.0f * this_5.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_6 : ViewRay_0,  height_4 : f32) -> vec2<f32>
{
    return this_6.origin_0 + this_6.slope_1 * vec2<f32>(height_4);
}

fn ViewRay_rate_0( this_7 : ViewRay_0,  here_5 : Probe_0) -> f32
{
    return here_5.slope_x_1 * this_7.slope_1.x + here_5.slope_y_1 * this_7.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S295 : f32 = end_0 - start_1;
    var _S296 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S295;
    var _S297 : f32 = 3.0f * _S295 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S295, 9.99999968265522539e-21f);
    var i_0 : i32 = i32(0);
    for(;;)
    {
        if(u32(i_0) < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S298 : f32 = clamp(share_1 - (((_S296 * share_1 + _S297) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S296 * share_1 + 2.0f * _S297) * share_1 + start_rate_0, 0.10000000149011612f * _S295 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S299 : i32 = i_0 + i32(1);
        share_1 = _S298;
        i_0 = _S299;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn footprint_coordinates_0( taps_0 : AnisotropicTaps_0) -> vec3<f32>
{
    return vec3<f32>(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

fn wrapped_0( index_3 : f32,  count_1 : f32) -> f32
{
    return select(select(index_3, index_3 - count_1, index_3 >= count_1), index_3 + count_1, index_3 < 0.0f);
}

fn AnisotropicTaps_has_steps_0( this_8 : AnisotropicTaps_0) -> bool
{
    var _S300 : vec2<f32> = this_8.first_21;
    var _S301 : vec2<f32> = this_8.second_0;
    return (max(dot(_S300, _S300), dot(_S301, _S301))) > 0.0f;
}

fn AnisotropicTaps_place_0( this_9 : AnisotropicTaps_0,  number_2 : u32) -> vec2<f32>
{
    return this_9.centre_1 + vec2<f32>(select(-1.0f, 1.0f, number_2 >= u32(2))) * this_9.first_21 + vec2<f32>(select(-1.0f, 1.0f, ((number_2 & (u32(1)))) != u32(0))) * this_9.second_0;
}

fn bump_0( distance_1 : f32) -> f32
{
    var _S302 : f32 = max(1.0f - distance_1 * distance_1, 0.0f);
    return _S302 * _S302;
}

struct Yarns_0
{
     warp_3 : vec4<f32>,
     weft_3 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_4 : vec4<f32>,  weft_4 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S303 : Yarns_0;
    _S303.warp_3 = warp_4;
    _S303.weft_3 = weft_4;
    _S303.shares_0 = shares_1;
    return _S303;
}

fn irregular_over_0( family_13 : u32,  key_4 : u32,  place_1 : f32,  width_2 : f32,  along_1 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S304 : f32 = max(width_2, 0.0625f);
    var _S305 : f32 = min(_S304, 64.0f);
    var _S306 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S307 : f32 = along_1 / 2.0f - 0.5f * _S306;
    var _S308 : f32 = 0.5f * _S305;
    var _S309 : vec2<f32> = floor(vec2<f32>(place_1 - _S308, place_1 + _S308) / vec2<f32>(64.0f));
    var _S310 : vec4<f32> = vec4<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var sums_8 : vec4<f32> = _S310;
    for(;;)
    {
        if(number_3 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S311 : bool = number_3 >= u32(3);
        var _S312 : u32 = select(number_3, number_3 - u32(3), _S311);
        var _S313 : f32 = select(-1.0f, 1.0f, _S311);
        var _S314 : f32 = _S309.y;
        var _S315 : f32 = _S309.x;
        var _S316 : f32 = select(_S315, _S314, _S311);
        var _S317 : f32 = place_1 + _S313 * 0.5f * _S305 - 64.0f * _S316;
        var _S318 : f32 = clamp(floor(_S317), 0.0f, 63.0f);
        var _S319 : f32 = _S317 - _S318;
        var _S320 : f32 = select(select(64.0f, 0.0f, _S311), _S318 + f32(_S312), _S312 < u32(2));
        var _S321 : f32 = _S313 * select(select(select(0.0f, -1.0f, _S315 != _S314), _S319, _S312 == u32(1)), 1.0f - _S319, _S312 == u32(0));
        if(_S321 == 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S322 : u32 = hash_bits_0(key_4, u32(i32(_S316)));
        sums_8 = sums_8 + vec4<f32>(_S321) * irregular_integral_0(family_13, ((_S322 & (u32(127)))) + u32(_S320), _S307 + f32((_S322 >> (u32(22)))), _S306);
        number_3 = number_3 + u32(1);
    }
    return sums_8 * irregular_units_0(family_13) * vec4<f32>((sqrt(_S305 / _S304) / (_S305 * _S306)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S323 : f32 = covers_0.x;
    var _S324 : f32 = covers_0.y;
    return vec3<f32>(_S323 * (1.0f - _S324 * (1.0f - warp_on_top_1)), _S324 * (1.0f - _S323 * warp_on_top_1), (1.0f - _S323) * (1.0f - _S324));
}

fn correction_weight_of_0( coded_size_0 : f32) -> f32
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

struct NearestLayer_0
{
     number_4 : u32,
     weight_0 : f32,
};

fn NearestLayer_x24init_0( number_5 : u32,  weight_1 : f32) -> NearestLayer_0
{
    var _S325 : NearestLayer_0;
    _S325.number_4 = number_5;
    _S325.weight_0 = weight_1;
    return _S325;
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn Albedos_x24init_0( diffuse_reflect_1 : vec3<f32>,  diffuse_transmit_1 : vec3<f32>,  specular_reflect_1 : vec3<f32>,  specular_transmit_1 : vec3<f32>) -> Albedos_0
{
    var _S326 : Albedos_0;
    _S326.diffuse_reflect_0 = diffuse_reflect_1;
    _S326.diffuse_transmit_0 = diffuse_transmit_1;
    _S326.specular_reflect_0 = specular_reflect_1;
    _S326.specular_transmit_0 = specular_transmit_1;
    return _S326;
}

struct FamilyAlbedos_0
{
     warp_5 : Albedos_0,
     weft_5 : Albedos_0,
};

fn FamilyAlbedos_x24init_0( warp_6 : Albedos_0,  weft_6 : Albedos_0) -> FamilyAlbedos_0
{
    var _S327 : FamilyAlbedos_0;
    _S327.warp_5 = warp_6;
    _S327.weft_5 = weft_6;
    return _S327;
}

struct LayersBehind_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

fn LayersBehind_x24init_0( reflected_1 : vec3<f32>,  transmitted_1 : vec3<f32>) -> LayersBehind_0
{
    var _S328 : LayersBehind_0;
    _S328.reflected_0 = reflected_1;
    _S328.transmitted_0 = transmitted_1;
    return _S328;
}

struct LayeredAlbedos_0
{
     albedos_0 : FamilyAlbedos_0,
     means_0 : FamilyAlbedos_0,
     behind_0 : LayersBehind_0,
};

fn LayeredAlbedos_x24init_0( albedos_1 : FamilyAlbedos_0,  means_1 : FamilyAlbedos_0,  behind_1 : LayersBehind_0) -> LayeredAlbedos_0
{
    var _S329 : LayeredAlbedos_0;
    _S329.albedos_0 = albedos_1;
    _S329.means_0 = means_1;
    _S329.behind_0 = behind_1;
    return _S329;
}

struct LayerSums_0
{
     albedos_2 : Albedos_0,
     means_2 : Albedos_0,
     weight_2 : f32,
     lit_0 : f32,
     passed_0 : f32,
     behind_2 : LayersBehind_0,
};

fn LayerSums_x24init_0( albedos_3 : Albedos_0,  means_3 : Albedos_0,  weight_3 : f32,  lit_1 : f32,  passed_1 : f32,  behind_3 : LayersBehind_0) -> LayerSums_0
{
    var _S330 : LayerSums_0;
    _S330.albedos_2 = albedos_3;
    _S330.means_2 = means_3;
    _S330.weight_2 = weight_3;
    _S330.lit_0 = lit_1;
    _S330.passed_0 = passed_1;
    _S330.behind_2 = behind_3;
    return _S330;
}

struct Bound_0
{
     thread_8 : u32,
     turns_2 : f32,
     cell_9 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_14 : u32,  position_5 : f32) -> Bound_0
{
    var _S331 : Cell_0 = locate_0(family_14, position_5);
    var _S332 : f32 = table_number_0(families_0[family_14].before_0 + u32(2) * _S331.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_8 = _S331.thread_1;
    bound_0.turns_2 = round((position_5 - families_0[family_14].start_0 - _S332 - _S331.below_0) * families_0[family_14].inverse_period_0);
    bound_0.cell_9 = _S331.below_0;
    var _S333 : f32 = 2.0f * _S331.half_width_1;
    bound_0.width_3 = _S333;
    bound_0.visible_0 = clamp((_S331.across_0 + _S331.half_width_1) / _S333, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S331.below_0, _S331.below_0 - _S331.across_0 - _S331.half_width_1) + max(_S331.across_0 - _S331.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_7 : Bound_0,
     high_7 : Bound_0,
};

fn stretch_of_0( family_15 : u32,  centre_2 : f32,  size_3 : f32) -> Stretch_0
{
    var _S334 : f32 = centre_2 - floor((centre_2 - families_0[family_15].start_0) * families_0[family_15].inverse_period_0) * families_0[family_15].period_0;
    var _S335 : f32 = 0.5f * max(size_3, families_0[family_15].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_7 = bound_at_0(family_15, _S334 - _S335);
    stretch_0.high_7 = bound_at_0(family_15, _S334 + _S335);
    return stretch_0;
}

fn table_colour_0( index_4 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_4), table_number_0(index_4 + u32(1)), table_number_0(index_4 + u32(2)));
}

fn table_albedos_0( row_7 : u32) -> Albedos_0
{
    var albedos_4 : Albedos_0;
    albedos_4.diffuse_reflect_0 = table_colour_0(row_7);
    albedos_4.diffuse_transmit_0 = table_colour_0(row_7 + u32(3));
    albedos_4.specular_reflect_0 = table_colour_0(row_7 + u32(6));
    albedos_4.specular_transmit_0 = table_colour_0(row_7 + u32(9));
    return albedos_4;
}

fn Stretch_turns_0( this_10 : Stretch_0) -> f32
{
    return this_10.high_7.turns_2 - this_10.low_7.turns_2;
}

fn lengths_0( family_16 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S336 : f32 = Stretch_turns_0(stretch_1);
    var _S337 : u32 = families_0[family_16].before_0 + u32(2) * stretch_1.low_7.thread_8;
    var _S338 : u32 = families_0[family_16].before_0 + u32(2) * stretch_1.high_7.thread_8;
    var _S339 : f32 = table_number_0(_S338) - table_number_0(_S337);
    var _S340 : f32 = table_number_0(_S338 + u32(1)) - table_number_0(_S337 + u32(1));
    return vec3<f32>(_S339 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_3 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_3 + _S336 * families_0[family_16].visible_total_0, _S340 - _S339 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S336 * (families_0[family_16].period_0 - families_0[family_16].visible_total_0), _S340 + stretch_1.high_7.cell_9 - stretch_1.low_7.cell_9 + _S336 * families_0[family_16].period_0);
}

fn integrals_along_0( family_17 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S341 : u32 = u32(3) * families_0[family_17].quantities_0;
    var _S342 : u32 = families_0[family_17].colour_threads_0 + _S341 * stretch_2.low_7.thread_8 + quantity_0;
    var _S343 : u32 = families_0[family_17].colour_threads_0 + _S341 * stretch_2.high_7.thread_8 + quantity_0;
    var _S344 : u32 = families_0[family_17].colour_threads_0 + _S341 * u32(families_0[family_17].count_0) + quantity_0;
    var _S345 : f32 = table_number_0(_S342);
    var _S346 : f32 = table_number_0(_S343);
    var _S347 : f32 = Stretch_turns_0(stretch_2);
    var _S348 : u32 = u32(2) * families_0[family_17].quantities_0;
    return vec2<f32>(table_number_0(_S343 + families_0[family_17].quantities_0) - table_number_0(_S342 + families_0[family_17].quantities_0) + _S346 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_3 - _S345 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_3 + _S347 * table_number_0(_S344 + families_0[family_17].quantities_0), table_number_0(_S343 + _S348) - table_number_0(_S342 + _S348) + _S346 * stretch_2.high_7.cell_9 - _S345 * stretch_2.low_7.cell_9 + _S347 * table_number_0(_S344 + _S348));
}

fn Stretch_wraps_0( this_11 : Stretch_0) -> bool
{
    return (this_11.high_7.thread_8) < (this_11.low_7.thread_8);
}

fn Stretch_differences_0( this_12 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S349 : u32 = entries_0.z;
    var _S350 : u32 = entries_0.x;
    return vec4<u32>(_S349 - _S350 + select(u32(0), whole_0, Stretch_wraps_0(this_12)), entries_0.w - _S349, entries_0.y - _S350, whole_0);
}

fn row_differences_0( across_2 : Stretch_0,  row_8 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S351 : u32 = row_8 + across_2.low_7.thread_8 * quantities_1;
    var _S352 : u32 = row_8 + across_2.high_7.thread_8 * quantities_1;
    return Stretch_differences_0(across_2, vec4<u32>(words_0[_S351], words_0[_S351 + quantities_1], words_0[_S352], words_0[_S352 + quantities_1]), words_0[row_8 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_13 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_13.high_7.visible_0, - this_13.low_7.visible_0, Stretch_turns_0(this_13) - select(0.0f, 1.0f, Stretch_wraps_0(this_13)));
}

fn integral_on_top_0( family_18 : u32,  across_3 : Stretch_0,  along_2 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S353 : u32 = u32(families_0[family_18].count_0);
    var _S354 : u32 = (_S353 + u32(1)) * families_0[family_18].quantities_0;
    var _S355 : u32 = families_0[family_18].colour_areas_0 + quantity_1;
    var _S356 : vec4<u32> = row_differences_0(across_3, _S355 + along_2.low_7.thread_8 * _S354, _S353, families_0[family_18].quantities_0);
    var _S357 : vec4<u32> = row_differences_0(across_3, _S355 + along_2.high_7.thread_8 * _S354, _S353, families_0[family_18].quantities_0);
    var _S358 : vec4<u32> = row_differences_0(across_3, _S355 + crossing_count_0 * _S354, _S353, families_0[family_18].quantities_0);
    var _S359 : vec4<f32> = Stretch_weights_0(across_3);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S357 - _S356 + select_vector_3(Stretch_wraps_0(along_2), _S358, vec4<u32>(vec4<i32>(i32(0)))))), _S359), dot(vec4<f32>(vec4<i32>(row_differences_0(across_3, _S355 + (along_2.high_7.thread_8 + u32(1)) * _S354, _S353, families_0[family_18].quantities_0) - _S357)), _S359), dot(vec4<f32>(vec4<i32>(row_differences_0(across_3, _S355 + (along_2.low_7.thread_8 + u32(1)) * _S354, _S353, families_0[family_18].quantities_0) - _S356)), _S359), dot(vec4<f32>(vec4<i32>(_S358)), _S359)), Stretch_weights_0(along_2)) * families_0[family_18].area_unit_0;
}

fn with_added_albedos_0( albedos_5 : Albedos_0,  weight_4 : f32,  row_9 : u32) -> Albedos_0
{
    var _S360 : Albedos_0 = table_albedos_0(row_9);
    var sum_0 : Albedos_0;
    var _S361 : vec3<f32> = vec3<f32>(weight_4);
    sum_0.diffuse_reflect_0 = albedos_5.diffuse_reflect_0 + _S361 * _S360.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_5.diffuse_transmit_0 + _S361 * _S360.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_5.specular_reflect_0 + _S361 * _S360.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_5.specular_transmit_0 + _S361 * _S360.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_19 : u32,  crossing_4 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_7 : bool) -> Albedos_0
{
    var albedos_6 : Albedos_0 = table_albedos_0(families_0[family_19].colour_mean_0);
    if((families_0[family_19].quantities_0) == u32(1))
    {
        return albedos_6;
    }
    var _S362 : vec3<f32> = lengths_0(crossing_4, other_2);
    var is_exposed_0 : bool = false;
    var weight_5 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_19].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S363 : vec2<f32> = integrals_along_0(family_19, own_1, quantity_2);
        var _S364 : f32 = integral_on_top_0(family_19, own_1, other_2, u32(families_0[crossing_4].count_0), quantity_2);
        var _S365 : f32 = _S363.x;
        var _S366 : f32 = _S365 * _S362.x;
        var _S367 : f32 = select(_S364, _S366 - _S364, back_7);
        var _S368 : bool = quantity_2 == u32(0);
        if(_S368)
        {
            is_exposed_0 = _S367 > (16.0f * families_0[family_19].area_unit_0 * min(_S366 / families_0[family_19].crossing_area_0, 1.0f) + 0.00000999999974738f * _S366);
        }
        var _S369 : f32 = _S365 * _S362.y + select(0.0f, _S367, is_exposed_0) + 0.000244140625f * _S362.z * _S363.y;
        if(_S368)
        {
            weight_5 = 1.0f / max(_S369, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_6 = with_added_albedos_0(albedos_6, _S369 * weight_5, families_0[family_19].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_6.diffuse_reflect_0 = saturate(albedos_6.diffuse_reflect_0);
    albedos_6.diffuse_transmit_0 = saturate(albedos_6.diffuse_transmit_0);
    albedos_6.specular_reflect_0 = saturate(albedos_6.specular_reflect_0);
    albedos_6.specular_transmit_0 = saturate(albedos_6.specular_transmit_0);
    return albedos_6;
}

fn albedos_in_0( plane_4 : Plane_0,  centre_3 : vec2<f32>,  size_4 : vec2<f32>,  back_8 : bool) -> FamilyAlbedos_0
{
    var _S370 : Stretch_0 = stretch_of_0(plane_4.warp_1, centre_3.x - plane_4.start_x_0, size_4.x);
    var _S371 : Stretch_0 = stretch_of_0(plane_4.weft_1, centre_3.y - plane_4.start_y_0, size_4.y);
    var albedos_7 : FamilyAlbedos_0;
    albedos_7.warp_5 = mean_albedos_0(plane_4.warp_1, plane_4.weft_1, _S370, _S371, back_8);
    albedos_7.weft_5 = mean_albedos_0(plane_4.weft_1, plane_4.warp_1, _S371, _S370, back_8);
    return albedos_7;
}

fn rate_terms_0( direction_3 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(7)>>)
{
    var _S372 : f32 = 1.0f - direction_3.z;
    var _S373 : f32 = _S372 * _S372;
    var _S374 : f32 = direction_3.x;
    var _S375 : f32 = _S374 * _S374;
    var _S376 : f32 = direction_3.y;
    var _S377 : f32 = _S376 * _S376;
    var _S378 : f32 = _S375 - _S377;
    var _S379 : f32 = _S375 + _S377;
    (*terms_0)[i32(1)] = _S379;
    (*terms_0)[i32(0)] = sqrt(_S379);
    (*terms_0)[i32(2)] = _S373;
    (*terms_0)[i32(3)] = _S373 * _S373;
    (*terms_0)[i32(4)] = _S378;
    (*terms_0)[i32(5)] = _S374 * _S376;
    (*terms_0)[i32(6)] = _S378 * _S378;
    return;
}

fn rate_of_view_0( first_25 : u32,  terms_1 : array<f32, i32(7)>) -> f32
{
    var _S380 : f32 = table_number_0(first_25);
    var term_0 : u32 = u32(0);
    var total_0 : f32 = _S380;
    for(;;)
    {
        if(term_0 < u32(7))
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + table_number_0(first_25 + u32(1) + term_0) * terms_1[term_0];
        term_0 = term_0 + u32(1);
        total_0 = total_1;
    }
    return total_0;
}

fn rate_of_light_0( first_26 : u32,  terms_2 : array<f32, i32(7)>,  both_0 : f32) -> f32
{
    var _S381 : u32 = first_26 + u32(8);
    var _S382 : f32 = table_number_0(_S381 + u32(7)) * both_0;
    var term_1 : u32 = u32(0);
    var total_2 : f32 = _S382;
    for(;;)
    {
        if(term_1 < u32(7))
        {
        }
        else
        {
            break;
        }
        var total_3 : f32 = total_2 + table_number_0(_S381 + term_1) * terms_2[term_1];
        term_1 = term_1 + u32(1);
        total_2 = total_3;
    }
    return total_2;
}

fn rate_of_0( logarithm_0 : f32) -> f32
{
    return exponential_0(clamp(logarithm_0, -30.0f, 3.0f));
}

fn with_layer_0( sums_9 : Albedos_0,  albedos_8 : Albedos_0,  lit_2 : f32,  passed_2 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0;
    var _S383 : vec3<f32> = vec3<f32>(lit_2);
    result_0.diffuse_reflect_0 = sums_9.diffuse_reflect_0 + _S383 * albedos_8.diffuse_reflect_0;
    result_0.diffuse_transmit_0 = sums_9.diffuse_transmit_0 + passed_2 * albedos_8.diffuse_transmit_0;
    result_0.specular_reflect_0 = sums_9.specular_reflect_0 + _S383 * albedos_8.specular_reflect_0;
    result_0.specular_transmit_0 = sums_9.specular_transmit_0 + passed_2 * albedos_8.specular_transmit_0;
    return result_0;
}

fn with_seen_0( sums_10 : LayerSums_0,  albedos_9 : Albedos_0,  through_0 : f32,  first_27 : u32,  share_2 : f32,  alone_0 : f32,  light_1 : vec3<f32>,  view_1 : vec3<f32>) -> LayerSums_0
{
    var of_view_0 : array<f32, i32(7)>;
    rate_terms_0(view_1, &(of_view_0));
    var _S384 : f32 = light_1.x;
    var _S385 : f32 = light_1.y;
    var _S386 : f32 = light_1.z;
    var of_light_0 : array<f32, i32(7)>;
    rate_terms_0(vec3<f32>(_S384, _S385, abs(_S386)), &(of_light_0));
    var _S387 : f32 = _S384 * view_1.x + _S385 * view_1.y;
    var _S388 : bool = _S386 < 0.0f;
    var _S389 : u32 = first_27 + u32(16) * select(u32(0), u32(1), _S388);
    var _S390 : u32 = first_27 + u32(32);
    var _S391 : f32 = share_2 * alone_0;
    var _S392 : f32 = _S391 * rate_of_0(rate_of_view_0(_S389, of_view_0) + rate_of_light_0(_S389, of_light_0, _S387));
    var _S393 : f32 = _S391 * rate_of_0(rate_of_view_0(_S390, of_view_0) + rate_of_light_0(_S390, of_light_0, _S387));
    var _S394 : f32 = share_2 * rate_of_0(rate_of_view_0(first_27 + u32(48), of_view_0));
    var _S395 : u32 = first_27 + u32(64);
    var _S396 : vec3<f32> = vec3<f32>(table_number_0(_S395), table_number_0(_S395 + u32(1)), table_number_0(_S395 + u32(2)));
    var _S397 : vec3<f32> = vec3<f32>(table_number_0(_S395 + u32(3)), table_number_0(_S395 + u32(4)), table_number_0(_S395 + u32(5)));
    var _S398 : f32 = _S391 * rate_of_0(rate_of_view_0(first_27, of_view_0));
    var _S399 : f32 = _S391 * rate_of_0(rate_of_view_0(first_27 + u32(16), of_view_0));
    var _S400 : f32 = _S391 * rate_of_0(rate_of_view_0(_S390, of_view_0));
    var result_1 : LayerSums_0;
    result_1.means_2 = with_layer_0(sums_10.means_2, albedos_9, _S398, vec3<f32>(_S399) + vec3<f32>(_S400) * _S396);
    result_1.lit_0 = sums_10.lit_0 + _S398;
    result_1.passed_0 = sums_10.passed_0 + _S399 + _S400;
    result_1.albedos_2 = with_layer_0(sums_10.albedos_2, albedos_9, _S392, vec3<f32>(_S392));
    result_1.weight_2 = sums_10.weight_2 + _S392 + select(0.0f, _S393, _S388);
    var _S401 : vec3<f32> = vec3<f32>(_S394);
    result_1.behind_2.reflected_0 = sums_10.behind_2.reflected_0 + _S401 * _S397;
    result_1.behind_2.transmitted_0 = sums_10.behind_2.transmitted_0 + _S401 * _S396 * (albedos_9.diffuse_transmit_0 + vec3<f32>(through_0) * albedos_9.specular_transmit_0);
    return result_1;
}

fn divided_0( sums_11 : Albedos_0,  lit_3 : f32,  passed_3 : f32) -> Albedos_0
{
    var _S402 : f32 = 1.0f / max(passed_3, 9.99999971718068537e-10f);
    var result_2 : Albedos_0;
    var _S403 : vec3<f32> = vec3<f32>((1.0f / max(lit_3, 9.99999971718068537e-10f)));
    result_2.diffuse_reflect_0 = sums_11.diffuse_reflect_0 * _S403;
    var _S404 : vec3<f32> = vec3<f32>(_S402);
    result_2.diffuse_transmit_0 = sums_11.diffuse_transmit_0 * _S404;
    result_2.specular_reflect_0 = sums_11.specular_reflect_0 * _S403;
    result_2.specular_transmit_0 = sums_11.specular_transmit_0 * _S404;
    return result_2;
}

fn uniform_hash_0( thread_9 : u32,  cell_10 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_9, stream_1), cell_10)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_5 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S405 : u32 = pixel_0.x;
    var _S406 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S405, _S406, stream_2), uniform_hash_0(_S405, _S406, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_6 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_6])));
}

struct Choice_0
{
     index_7 : u32,
     remainder_0 : f32,
};

fn choose_0( table_0 : u32,  count_3 : u32,  number_6 : f32) -> Choice_0
{
    var high_8 : u32 = count_3;
    var low_8 : u32 = u32(0);
    for(;;)
    {
        if((high_8 - low_8) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S407 : u32 = (low_8 + high_8) / u32(2);
        if((scene_number_0(table_0 + _S407)) <= number_6)
        {
            low_8 = _S407;
        }
        else
        {
            high_8 = _S407;
        }
    }
    var _S408 : u32 = table_0 + low_8;
    var _S409 : f32 = scene_number_0(_S408);
    var _S410 : f32 = scene_number_0(_S408 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate((number_6 - _S409) / max(_S410 - _S409, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_11 : f32) -> vec2<f32>
{
    var _S411 : f32 = floor(x_11 * 0.63661974668502808f + 0.5f);
    var _S412 : f32 = x_11 - _S411 * 1.5703125f - _S411 * 0.00048375129699707f - _S411 * 7.54979012640433211e-08f;
    var _S413 : f32 = _S412 * _S412;
    var _S414 : f32 = ((-0.00019515295571182f * _S413 + 0.00833216123282909f) * _S413 - 0.16666655242443085f) * _S413 * _S412 + _S412;
    var _S415 : f32 = ((0.00002443315679557f * _S413 - 0.00138873164542019f) * _S413 + 0.04166664555668831f) * _S413 * _S413 - 0.5f * _S413 + 1.0f;
    var _S416 : u32 = (u32(i32(_S411)) & (u32(3)));
    var _S417 : vec2<f32> = select_vector_1(((_S416 & (u32(1)))) != u32(0), vec2<f32>(_S415, _S414), vec2<f32>(_S414, _S415));
    var _S418 : f32 = _S417.x;
    var _S419 : f32 = _S417.y;
    return vec2<f32>(select(_S418, - _S418, ((_S416 & (u32(2)))) != u32(0)), select(_S419, - _S419, (((_S416 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_12 : f32,
     y_4 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_28 : u32) -> Light_0
{
    var record_2 : Light_0;
    record_2.is_point_0 = scene_words_0[first_28];
    record_2.x_12 = (bitcast<f32>((scene_words_0[first_28 + u32(1)])));
    record_2.y_4 = (bitcast<f32>((scene_words_0[first_28 + u32(2)])));
    record_2.z_1 = (bitcast<f32>((scene_words_0[first_28 + u32(3)])));
    record_2.red_0 = (bitcast<f32>((scene_words_0[first_28 + u32(4)])));
    record_2.green_0 = (bitcast<f32>((scene_words_0[first_28 + u32(5)])));
    record_2.blue_0 = (bitcast<f32>((scene_words_0[first_28 + u32(6)])));
    return record_2;
}

fn unmapped_0( output_9 : f32,  scale_0 : f32) -> f32
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

fn mirrored_bundle_0( bundle_0 : u32) -> u32
{
    return select(bundle_0 / u32(3) * u32(3) + u32(3) - u32(1) - bundle_0 % u32(3), bundle_0, bundle_0 == u32(24));
}

fn light_visibility_of_0( diffuse_0 : f32,  light_2 : vec3<f32>,  view_2 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S420 : f32 = max(abs(light_2.z), 0.00100000004749745f);
    var _S421 : vec2<f32> = light_2.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S420, (0.59700000286102295f * _S420 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S421, view_2.xy) * rsqrt_0(max(dot(_S421, _S421), 9.99999997475242708e-07f))) + 1.0f), blend_0);
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
     weight_6 : f32,
     warp_7 : Blocked_0,
     weft_7 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_1 : CloseUp_0;
    nothing_1.weight_6 = 0.0f;
    var _S422 : Blocked_0 = no_blocked_0();
    nothing_1.warp_7 = _S422;
    nothing_1.weft_7 = _S422;
    return nothing_1;
}

fn tinted_0( albedos_10 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_3 : Albedos_0 = albedos_10;
    result_3.diffuse_reflect_0 = result_3.diffuse_reflect_0 * tint_0;
    result_3.diffuse_transmit_0 = result_3.diffuse_transmit_0 * tint_0;
    return result_3;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S423 : f32 = value_1 * value_1;
    return _S423 * _S423;
}

struct FaceRadiance_0
{
     warp_8 : vec3<f32>,
     weft_8 : vec3<f32>,
     mean_1 : vec3<f32>,
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

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_4 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S424 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_4;
    var found_0 : FaceRadiance_0;
    var _S425 : vec3<f32> = sends_0.sky_warp_0 + _S424 * sends_0.crossing_warp_0;
    found_0.warp_8 = _S425;
    var _S426 : vec3<f32> = sends_0.sky_weft_0 + _S424 * sends_0.crossing_weft_0;
    found_0.weft_8 = _S426;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S425 + vec3<f32>(sends_0.blocks_weft_0) * _S426;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_3 : vec3<f32>,  terms_3 : ptr<function, array<f32, i32(6)>>)
{
    var _S427 : f32 = 1.0f - view_3.z;
    var _S428 : f32 = _S427 * _S427;
    (*terms_3)[i32(0)] = 1.0f;
    var _S429 : f32 = view_3.x;
    var _S430 : f32 = _S429 * _S429;
    var _S431 : f32 = view_3.y;
    var _S432 : f32 = _S431 * _S431;
    (*terms_3)[i32(1)] = sqrt(max(_S430 + _S432, 9.999999960041972e-13f));
    (*terms_3)[i32(2)] = _S428;
    (*terms_3)[i32(3)] = _S428 * _S428;
    (*terms_3)[i32(4)] = _S430 - _S432;
    (*terms_3)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_4 : vec3<f32>,  terms_4 : ptr<function, array<f32, i32(6)>>)
{
    var _S433 : f32 = 1.0f - view_4.z;
    var _S434 : f32 = _S433 * _S433;
    (*terms_4)[i32(0)] = 1.0f;
    var _S435 : f32 = view_4.x;
    var _S436 : f32 = _S435 * _S435;
    var _S437 : f32 = view_4.y;
    var _S438 : f32 = _S437 * _S437;
    (*terms_4)[i32(1)] = sqrt(max(_S436 + _S438, 9.999999960041972e-13f));
    (*terms_4)[i32(2)] = _S434;
    (*terms_4)[i32(3)] = _S434 * _S434;
    (*terms_4)[i32(4)] = _S436 - _S438;
    (*terms_4)[i32(5)] = 0.0f;
    return;
}

fn scaled_0( blocked_0 : Blocked_0,  share_3 : f32) -> Blocked_0
{
    var result_4 : Blocked_0;
    result_4.by_warp_0 = share_3 * blocked_0.by_warp_0;
    result_4.by_weft_0 = share_3 * blocked_0.by_weft_0;
    result_4.far_0 = share_3 * blocked_0.far_0;
    return result_4;
}

struct Bounced_0
{
     reflected_2 : vec3<f32>,
     transmitted_2 : vec3<f32>,
     is_covered_0 : bool,
};

struct Scattered_0
{
     back_9 : vec3<f32>,
     through_1 : vec3<f32>,
};

struct Interior_0
{
     warp_9 : vec3<f32>,
     weft_9 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S439 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S440 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_1;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_2 = yarn_2.back_9 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_9 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_9) + _S440 * interior_0.far_leaked_0;
    bounced_0.transmitted_2 = _S440 * interior_0.far_1 + yarn_2.back_9 * _S439;
    bounced_0.is_covered_0 = false;
    return bounced_0;
}

fn sum_of_0( first_29 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_2 = first_29.reflected_2 + second_2.reflected_2;
    sum_1.transmitted_2 = first_29.transmitted_2 + second_2.transmitted_2;
    sum_1.is_covered_0 = false;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_3 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S441 : f32 = light_3.z;
    return select_vector_2((_S441 * view_5.z) < 0.0f, bounced_1.transmitted_2, bounced_1.reflected_2) * vec3<f32>((abs(_S441) * 0.31830987334251404f));
}

fn sheen_scale_0( x_13 : f32,  y_5 : f32) -> f32
{
    return (((((0.0f * x_13 + (((((-1.1402510404586792f * y_5 + 0.40672621130943298f) * y_5 + 1.65398800373077393f) * y_5 + -1.29730904102325439f) * y_5 + 0.30570998787879944f) * y_5 + -0.0220868494361639f)) * x_13 + (((((-0.21142719686031342f * y_5 + 1.05947399139404297f) * y_5 + -0.41116121411323547f) * y_5 + -0.93859231472015381f) * y_5 + 0.51606941223144531f) * y_5 + 0.05409301072359085f)) * x_13 + (((((1.22944498062133789f * y_5 + -0.45962560176849365f) * y_5 + -1.63861405849456787f) * y_5 + 1.33565104007720947f) * y_5 + -0.45725581049919128f) * y_5 + 0.08243165910243988f)) * x_13 + (((((0.39779931306838989f * y_5 + -1.18879103660583496f) * y_5 + 0.28251591324806213f) * y_5 + 1.168984055519104f) * y_5 + -0.76864629983901978f) * y_5 + 0.0091691892594099f)) * x_13 + (((((-0.26563560962677002f * y_5 + -0.19379159808158875f) * y_5 + 0.2677634060382843f) * y_5 + 0.00270519289188087f) * y_5 + 0.14349560439586639f) * y_5 + 0.10290180146694183f)) * x_13 + (((((-0.20701569318771362f * y_5 + 0.24526430666446686f) * y_5 + 0.19551840424537659f) * y_5 + 0.07586126774549484f) * y_5 + 0.38894739747047424f) * y_5 + 0.15043120086193085f);
}

fn sheen_shear_0( x_14 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_14 + (((((-0.10608240216970444f * y_6 + 1.99214303493499756f) * y_6 + -1.42255294322967529f) * y_6 + -1.09495604038238525f) * y_6 + 0.59180057048797607f) * y_6 + 0.06902855634689331f)) * x_14 + (((((-0.46220690011978149f * y_6 + -0.29113379120826721f) * y_6 + 1.39025199413299561f) * y_6 + 0.35589990019798279f) * y_6 + -1.17120099067687988f) * y_6 + 0.15940259397029877f)) * x_14 + (((((2.26068711280822754f * y_6 + -3.64728999137878418f) * y_6 + -0.72173482179641724f) * y_6 + 3.07659196853637695f) * y_6 + -0.6827620267868042f) * y_6 + -0.3039557933807373f)) * x_14 + (((((0.81201767921447754f * y_6 + 0.36014080047607422f) * y_6 + -1.72646903991699219f) * y_6 + -0.22630110383033752f) * y_6 + 0.89514690637588501f) * y_6 + -0.10397960245609283f)) * x_14 + (((((-0.37648698687553406f * y_6 + 1.10974001884460449f) * y_6 + 0.17824520170688629f) * y_6 + -1.04968702793121338f) * y_6 + 0.1461234986782074f) * y_6 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_15 : f32,  y_7 : f32) -> f32
{
    return ((((0.0f * x_15 + (((((12.95646953582763672f * y_7 + -21.38032913208007812f) * y_7 + -7.37853097915649414f) * y_7 + 34.55607986450195312f) * y_7 + -23.61347007751464844f) * y_7 + 5.00126314163208008f)) * x_15 + (((((10.91487026214599609f * y_7 + -6.08202791213989258f) * y_7 + -38.2036285400390625f) * y_7 + 53.3440399169921875f) * y_7 + -21.91996002197265625f) * y_7 + 2.01606011390686035f)) * x_15 + (((((-14.52206039428710938f * y_7 + 36.803619384765625f) * y_7 + -22.94047927856445312f) * y_7 + -10.07973003387451172f) * y_7 + 15.77003955841064453f) * y_7 + -4.92722177505493164f)) * x_15 + (((((-7.62505722045898438f * y_7 + 1.27310299873352051f) * y_7 + 31.19523048400878906f) * y_7 + -44.39989852905273438f) * y_7 + 26.44947052001953125f) * y_7 + -8.73507976531982422f)) * x_15 + (((((5.65633487701416016f * y_7 + -17.66820907592773438f) * y_7 + 24.65356063842773438f) * y_7 + -19.38941001892089844f) * y_7 + 11.06159019470214844f) * y_7 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_1 : f32) -> vec3<f32>
{
    var _S442 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S443 : f32 = 2.0f * sqrt(_S442) - 1.0f;
    var _S444 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S443, _S444), 0.00999999977648258f, 1.0f), clamp((1.0f - _S442) * sheen_shear_0(_S443, _S444), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S443, _S444), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  scale_1 : f32,  shear_0 : f32) -> f32
{
    var _S445 : f32 = light_4.z;
    if(((_S445 <= 0.0f) | (((view_6.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S446 : vec2<f32> = view_6.xy;
    var _S447 : f32 = dot(_S446, _S446);
    var _S448 : vec2<f32> = select_vector_1(_S447 > 9.99999968265522539e-21f, _S446 * vec2<f32>(rsqrt_0(max(_S447, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S449 : f32 = scale_1 * dot(light_4.xy, _S448) + shear_0 * _S445;
    var _S450 : f32 = scale_1 * (light_4.y * _S448.x - light_4.x * _S448.y);
    var _S451 : f32 = _S449 * _S449 + _S450 * _S450 + _S445 * _S445;
    return 0.31830987334251404f * scale_1 * scale_1 * _S445 / max(_S451 * _S451, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_5 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_2 : f32) -> vec2<f32>
{
    var _S452 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_2);
    var _S453 : f32 = strength_0 * _S452.z;
    return vec2<f32>(_S453 * transformed_cosine_0(light_5, view_7, _S452.x, _S452.y), 1.0f - _S453);
}

fn accumulate_0( index_8 : u32,  light_6 : vec4<f32>)
{
    var _S454 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_6;
    layers_0[index_8].share_0 = _S454 * (1.0f - light_6.w);
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

fn uneven_shift_0( _S455 : u32,  _S456 : u32,  _S457 : u32,  _S458 : vec2<f32>) -> f32
{
    var _S459 : f32 = families_0[_S457].period_0 / families_0[_S457].count_0;
    var _S460 : u32 = hash_key_0(_S456, ((fabrics_0[_S455].seed_0) ^ (u32(625341585))));
    var _S461 : vec2<f32> = vec2<f32>(_S458.x, _S458.y / 4.0f) / vec2<f32>(_S459);
    return 0.20000000298023224f * sqrt(families_0[_S457].slub_0) * _S459 * (uneven_octave_0(_S460, _S461) * 0.66666668653488159f + uneven_octave_0(_S460 + u32(1), vec2<f32>(2.0f) * _S461 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S462 : u32,  _S463 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S462].has_detail_0) == u32(0), _S463, _S463 + vec2<f32>(uneven_shift_0(_S462, u32(0), fabrics_0[_S462].warp_0, _S463), uneven_shift_0(_S462, u32(1), fabrics_0[_S462].weft_0, _S463.yx)));
}

fn face_point_0( _S464 : u32,  _S465 : u32,  _S466 : f32,  _S467 : f32) -> VisiblePoint_0
{
    var _S468 : u32 = u32(3) * _S465;
    var _S469 : Vertex_0 = vertex_at_0(_S468);
    var _S470 : Vertex_0 = vertex_at_0(_S468 + u32(1));
    var _S471 : Vertex_0 = vertex_at_0(_S468 + u32(2));
    var _S472 : vec3<f32> = position_of_0(_S469);
    var _S473 : vec3<f32> = position_of_0(_S470) - _S472;
    var _S474 : vec3<f32> = position_of_0(_S471) - _S472;
    var _S475 : f32 = _S470.u_0 - _S469.u_0;
    var _S476 : f32 = _S470.v_0 - _S469.v_0;
    var _S477 : vec2<f32> = vec2<f32>(_S475, _S476);
    var _S478 : f32 = _S471.u_0 - _S469.u_0;
    var _S479 : f32 = _S471.v_0 - _S469.v_0;
    var _S480 : vec2<f32> = vec2<f32>(_S478, _S479);
    var _S481 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S475 * _S479 - _S476 * _S478) < 0.0f));
    var _S482 : vec3<f32> = _S481 * (vec3<f32>(_S479) * _S473 - vec3<f32>(_S476) * _S474);
    var _S483 : vec3<f32> = _S481 * (vec3<f32>(_S475) * _S474 - vec3<f32>(_S478) * _S473);
    var point_1 : VisiblePoint_0;
    var _S484 : vec3<f32> = vec3<f32>(_S466);
    var _S485 : vec3<f32> = vec3<f32>(_S467);
    var _S486 : vec3<f32> = normalize(vec3<f32>((1.0f - _S466 - _S467)) * normal_of_0(_S469) + _S484 * normal_of_0(_S470) + _S485 * normal_of_0(_S471));
    point_1.normal_0 = _S486;
    var _S487 : vec3<f32> = normalize(_S482 - _S486 * vec3<f32>(dot(_S486, _S482)));
    point_1.axis_x_0 = _S487;
    point_1.axis_y_0 = cross(_S486, _S487);
    var _S488 : vec3<f32> = normalize(cross(_S473, _S474));
    point_1.face_normal_0 = select_vector_2((dot(_S488, _S486)) < 0.0f, (vec3<f32>(0) - _S488), _S488);
    point_1.position_4 = _S472 + _S484 * _S473 + _S485 * _S474;
    point_1.view_0 = _S486;
    var _S489 : vec2<f32> = vec2<f32>(_S469.u_0, _S469.v_0) + vec2<f32>(_S466) * _S477 + vec2<f32>(_S467) * _S480;
    point_1.uv_1 = _S489;
    var _S490 : bool = (dot(cross(_S482, _S483), _S486)) < 0.0f;
    var _S491 : vec2<f32> = vec2<f32>(fabrics_0[_S464].uv_width_0, select(fabrics_0[_S464].uv_height_0, - fabrics_0[_S464].uv_height_0, _S490));
    point_1.draft_per_uv_0 = _S491;
    point_1.draft_0 = uneven_place_0(_S464, _S489 * _S491 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S464].uv_height_0, _S490)));
    var _S492 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S492;
    point_1.draft_dy_0 = _S492;
    return point_1;
}

fn visible_point_0( _S493 : u32,  _S494 : u32,  _S495 : vec2<u32>) -> VisiblePoint_0
{
    var _S496 : u32 = u32(3) * _S494;
    var _S497 : Vertex_0 = vertex_at_0(_S496);
    var _S498 : Vertex_0 = vertex_at_0(_S496 + u32(1));
    var _S499 : Vertex_0 = vertex_at_0(_S496 + u32(2));
    var _S500 : vec3<f32> = position_of_0(_S497);
    var _S501 : vec3<f32> = position_of_0(_S498) - _S500;
    var _S502 : vec3<f32> = position_of_0(_S499) - _S500;
    var _S503 : vec3<f32> = cross(_S501, _S502);
    var _S504 : f32 = f32(frame_record_0.width_0);
    var _S505 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S504));
    var _S506 : f32 = f32(frame_record_0.height_0);
    var _S507 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S506));
    var _S508 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S495.x) + 0.5f - 0.5f * _S504)) * _S505 + vec3<f32>((f32(_S495.y) + 0.5f - 0.5f * _S506)) * _S507;
    var _S509 : f32 = dot(_S508, _S503);
    var _S510 : f32 = 1.0f / select(1.00000000317107685e-30f, _S509, (abs(_S509)) > 1.00000000317107685e-30f);
    var _S511 : vec3<f32> = _S500 - camera_origin_0();
    var _S512 : vec3<f32> = vec3<f32>((dot(_S511, _S503) * _S510));
    var _S513 : vec3<f32> = _S508 * _S512 - _S511;
    var _S514 : vec3<f32> = _S512 * (_S505 - _S508 * vec3<f32>((dot(_S505, _S503) * _S510)));
    var _S515 : vec3<f32> = _S512 * (_S507 - _S508 * vec3<f32>((dot(_S507, _S503) * _S510)));
    var _S516 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S503), 1.00000000317107685e-30f)));
    var _S517 : vec3<f32> = cross(_S502, _S503) * _S516;
    var _S518 : vec3<f32> = cross(_S503, _S501) * _S516;
    var _S519 : vec2<f32> = vec2<f32>(_S498.u_0 - _S497.u_0, _S498.v_0 - _S497.v_0);
    var _S520 : vec2<f32> = vec2<f32>(_S499.u_0 - _S497.u_0, _S499.v_0 - _S497.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S493, _S494, dot(_S513, _S517), dot(_S513, _S518));
    point_2.position_4 = _S500 + _S513;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S508));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S514, _S517)) * _S519 + vec2<f32>(dot(_S514, _S518)) * _S520) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S515, _S517)) * _S519 + vec2<f32>(dot(_S515, _S518)) * _S520) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S521 : u32,  _S522 : VisiblePoint_0) -> vec3<f32>
{
    var _S523 : u32 = fabrics_0[_S521].albedo_map_levels_0;
    if((fabrics_0[_S521].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S524 : vec2<f32> = vec2<f32>(fabrics_0[_S521].uv_width_0, fabrics_0[_S521].uv_height_0);
    var _S525 : vec2<f32> = _S522.draft_dx_0 / _S524;
    var _S526 : vec2<f32> = _S522.draft_dy_0 / _S524;
    var _S527 : u32 = _S523 - u32(1);
    var _S528 : u32 = (u32(1) << (_S527));
    var _S529 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S525.x * _S526.y - _S525.y * _S526.x), 9.99999968265522539e-21f) * (square_1(f32(_S528)) / 3.0f)), 0.0f, f32(_S523) - 1.0f);
    var _S530 : u32 = min(u32(_S529), max(_S523, u32(2)) - u32(2));
    var _S531 : u32 = min(_S530 + u32(1), _S527);
    var _S532 : u32 = (u32(1) << ((u32(2) * _S523)));
    return mix(map_level_0(fabrics_0[_S521].albedo_map_0 + (_S532 - ((_S532 >> ((u32(2) * _S530))))) / u32(3), (_S528 >> (_S530)), _S522.uv_1), map_level_0(fabrics_0[_S521].albedo_map_0 + (_S532 - ((_S532 >> ((u32(2) * _S531))))) / u32(3), (_S528 >> (_S531)), _S522.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S529 - f32(_S530))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S533 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S533].planes_0) != u32(0))));
}

fn irregular_key_0( _S534 : u32,  _S535 : u32) -> u32
{
    return hash_key_0(_S535, ((fabrics_0[_S534].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S536 : u32,  _S537 : vec2<f32>,  _S538 : f32) -> vec2<f32>
{
    var _S539 : u32 = fabrics_0[_S536].warp_0;
    var _S540 : u32 = fabrics_0[_S536].weft_0;
    var _S541 : bool = (((((fabrics_0[_S536].is_irregular_0) != u32(0)) & ((!is_layered_0(_S536))))) & (((max(moved_share_0(fabrics_0[_S536].warp_0, _S538), moved_share_0(fabrics_0[_S536].weft_0, _S538))) > 0.0f)));
    var number_7 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S537;
    for(;;)
    {
        if(number_7 < select(u32(0), u32(2), _S541))
        {
        }
        else
        {
            break;
        }
        var _S542 : bool = number_7 == u32(0);
        var _S543 : u32 = select(_S540, _S539, _S542);
        var _S544 : vec2<f32> = select_vector_1(_S542, _S537, _S537.yx);
        var _S545 : u32 = irregular_key_0(_S536, number_7);
        var _S546 : f32 = _S544.x;
        var _S547 : Cell_0 = locate_0(_S543, _S546);
        var _S548 : f32 = irregular_thread_0(_S543, _S546, _S547);
        var _S549 : f32 = select(1.0f, -1.0f, (_S547.across_0) < 0.0f);
        var _S550 : vec2<f32> = vec2<f32>(0.0f);
        var other_3 : vec2<f32> = _S550;
        var own_2 : vec2<f32> = _S550;
        var neighbour_0 : u32 = u32(0);
        for(;;)
        {
            if(neighbour_0 < u32(2))
            {
            }
            else
            {
                break;
            }
            var _S551 : vec2<f32> = irregular_at_0(_S543, _S545, _S548 + _S549 * f32(neighbour_0), _S544.y).xy;
            var _S552 : u32 = neighbour_0 + u32(1);
            own_2 = other_3;
            other_3 = _S551;
            neighbour_0 = _S552;
        }
        var _S553 : f32 = _S547.below_0 + _S547.above_0;
        var _S554 : f32 = min(_S547.half_width_1 / _S553, 0.5f);
        var _S555 : f32 = min(_S554 * (2.0f + own_2.y + other_3.y), 1.0f);
        var _S556 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_2.x, other_3.x), vec2<f32>(0.25f)));
        var _S557 : f32 = _S556.x;
        var _S558 : f32 = _S555 * _S557 / (_S557 + _S556.y);
        var _S559 : f32 = abs(_S547.across_0) / _S553;
        var _S560 : f32 = 1.0f - _S555;
        var _S561 : f32 = _S559 - _S558;
        var _S562 : f32 = moved_share_0(_S543, _S538) * _S549 * _S553 * (select(select((_S561 - _S560) / max(_S555 - _S558, 9.99999997475242708e-07f) * _S554 + (1.0f - _S554), _S561 / max(_S560, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S554) + _S554, _S561 < _S560), _S559 * _S554 / _S558, _S561 < 0.0f) - _S559);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S542, vec2<f32>(_S562, 0.0f), vec2<f32>(0.0f, _S562));
        number_7 = number_7 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct NeuralView_0
{
     sums_12 : array<f32, i32(64)>,
     even_hole_0 : f32,
     hole_2 : f32,
     yarns_0 : Yarns_0,
     correction_weight_0 : f32,
     view_8 : vec3<f32>,
     back_10 : bool,
};

fn anisotropic_taps_0( _S563 : u32,  _S564 : Footprint_0) -> AnisotropicTaps_0
{
    var _S565 : vec3<f32> = row_of_taps_0(_S564);
    var _S566 : vec2<f32> = _S564.dx_0;
    var _S567 : vec2<f32> = _S564.dy_0;
    var _S568 : f32 = dot(_S566, _S566) + dot(_S567, _S567);
    var _S569 : f32 = _S564.dx_0.x * _S564.dy_0.y - _S564.dx_0.y * _S564.dy_0.x;
    var _S570 : f32 = 0.5f * (_S568 + sqrt(max(_S568 * _S568 - 4.0f * _S569 * _S569, 0.0f)));
    var _S571 : bool = ((_S570 < (5.5f * (_S568 - _S570))) & ((_S568 > (8.0f * fabrics_0[_S563].neural_0.pitch_0 * fabrics_0[_S563].neural_0.pitch_0))));
    var _S572 : vec2<f32> = vec2<f32>(fabrics_0[_S563].neural_0.ends_per_mm_0, fabrics_0[_S563].neural_0.picks_per_mm_0);
    var taps_1 : AnisotropicTaps_0;
    taps_1.centre_1 = _S564.centre_0 * _S572;
    taps_1.side_2 = select(_S565.x, sqrt(0.125f * _S568), _S571) / fabrics_0[_S563].neural_0.pitch_0;
    var _S573 : vec2<f32> = vec2<f32>(0.25f);
    var _S574 : vec2<f32> = _S565.yz;
    taps_1.first_21 = select_vector_1(_S571, _S573 * _S564.dx_0, _S574) * _S572;
    taps_1.second_0 = select_vector_1(_S571, _S573 * _S564.dy_0, vec2<f32>(0.5f) * _S574) * _S572;
    return taps_1;
}

struct Hit_0
{
     x_16 : f32,
     y_8 : f32,
     hole_3 : bool,
     height_5 : f32,
};

fn whole_plane_0( _S575 : u32) -> Plane_0
{
    var plane_5 : Plane_0;
    plane_5.warp_1 = fabrics_0[_S575].warp_0;
    plane_5.weft_1 = fabrics_0[_S575].weft_0;
    plane_5.run_words_1 = fabrics_0[_S575].run_words_0;
    plane_5.ends_2 = fabrics_0[_S575].ends_1;
    plane_5.end_numbers_0 = u32(0);
    plane_5.pick_numbers_0 = u32(0);
    plane_5.max_heights_1 = fabrics_0[_S575].max_heights_0;
    plane_5.max_height_columns_1 = fabrics_0[_S575].max_height_columns_0;
    plane_5.height_low_1 = fabrics_0[_S575].height_low_0;
    plane_5.height_high_1 = fabrics_0[_S575].height_high_0;
    plane_5.front_level_0 = 0.0f;
    plane_5.back_level_0 = 0.0f;
    plane_5.start_x_0 = 0.0f;
    plane_5.start_y_0 = 0.0f;
    plane_5.fine_x_0 = 0.0f;
    plane_5.fine_y_0 = 0.0f;
    return plane_5;
}

fn plane_order_0( _S576 : u32,  _S577 : f32,  _S578 : f32,  _S579 : bool) -> u32
{
    var _S580 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S576].plane_axes_0 + u32(1), _S578).thread_1 * fabrics_0[_S576].ends_1 + locate_varied_0(fabrics_0[_S576].plane_axes_0, _S577).thread_1, (fabrics_0[_S576].stacks_0) > u32(1));
    return fabrics_0[_S576].plane_orders_0 + u32(2) * fabrics_0[_S576].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S576].regions_0 + _S580 / u32(4)] >> ((u32(8) * (_S580 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S579));
}

fn first_bounds_0( _S581 : u32,  _S582 : u32,  _S583 : f32,  _S584 : f32,  _S585 : bool,  _S586 : bool,  _S587 : bool) -> vec3<f32>
{
    var _S588 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S581].plane_records_0 + words_0[_S582] * u32(16)), _S583, _S584, _S585, _S586, _S587);
    var _S589 : Cell_0 = locate_varied_0(fabrics_0[_S581].plane_axes_0, _S583);
    var _S590 : Cell_0 = locate_varied_0(fabrics_0[_S581].plane_axes_0 + u32(1), _S584);
    var _S591 : bool = (fabrics_0[_S581].stacks_0) == u32(1);
    return vec3<f32>(_S588.x + table_number_0(_S582 + u32(1)), min(_S588.y, select(select(_S589.below_0, _S589.above_0, _S586), 1.0e+06f, _S591)), min(_S588.z, select(select(_S590.below_0, _S590.above_0, _S587), 1.0e+06f, _S591)));
}

fn plane_shown_0( _S592 : u32,  _S593 : f32,  _S594 : f32,  _S595 : bool,  _S596 : bool,  _S597 : bool) -> PlaneHere_0
{
    var here_6 : PlaneHere_0;
    here_6.plane_3 = whole_plane_0(_S592);
    here_6.number_1 = u32(0);
    here_6.level_1 = 0.0f;
    here_6.edge_x_0 = 1.0e+06f;
    here_6.edge_y_0 = 1.0e+06f;
    here_6.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S592))
    {
        return here_6;
    }
    var _S598 : u32 = plane_order_0(_S592, _S593, _S594, _S595);
    var _S599 : vec3<f32> = first_bounds_0(_S592, _S598, _S593, _S594, _S595, _S596, _S597);
    here_6.bounds_0 = _S599;
    var _S600 : bool = (fabrics_0[_S592].stacks_0) == u32(1);
    here_6.edge_x_0 = select(_S599.y, 1.0e+06f, _S600);
    here_6.edge_y_0 = select(_S599.z, 1.0e+06f, _S600);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S592].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S601 : u32 = _S598 + u32(2) * rank_1;
        var _S602 : u32 = words_0[_S601];
        here_6.number_1 = _S602;
        here_6.level_1 = table_number_0(_S601 + u32(1));
        here_6.plane_3 = plane_at_0(fabrics_0[_S592].plane_records_0 + _S602 * u32(16));
        var _S603 : Cell_0 = locate_varied_0(here_6.plane_3.warp_1, _S593 - here_6.plane_3.start_x_0);
        var _S604 : Cell_0 = locate_varied_0(here_6.plane_3.weft_1, _S594 - here_6.plane_3.start_y_0);
        var is_hole_1 : bool = !((((abs(_S603.across_0)) < (_S603.half_width_1)) | (((abs(_S604.across_0)) < (_S604.half_width_1)))));
        here_6.edge_x_0 = min(here_6.edge_x_0, select(1.0e+06f, hole_edge_0(_S603, _S596), is_hole_1));
        here_6.edge_y_0 = min(here_6.edge_y_0, select(1.0e+06f, hole_edge_0(_S604, _S597), is_hole_1));
        var _S605 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S605;
    }
    return here_6;
}

fn sample_at_0( _S606 : u32,  _S607 : f32,  _S608 : f32,  _S609 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S606, _S607, _S608, _S609, true, true), _S607, _S608, _S609);
}

fn steps_per_length_0( _S610 : u32,  _S611 : SearchQuality_0,  _S612 : vec3<f32>) -> f32
{
    return max(max(abs(_S612.x) * fabrics_0[_S610].threads_per_x_0, abs(_S612.y) * fabrics_0[_S610].threads_per_y_0) * _S611.steps_per_thread_0, abs(_S612.z) * fabrics_0[_S610].per_relief_0 * _S611.steps_per_relief_0);
}

fn plane_count_0( _S613 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S613].planes_0, is_layered_0(_S613));
}

fn probe_0( _S614 : u32,  _S615 : f32,  _S616 : f32,  _S617 : bool,  _S618 : bool,  _S619 : bool) -> Probe_0
{
    var _S620 : PlaneHere_0 = plane_shown_0(_S614, _S615, _S616, _S617, _S618, _S619);
    var _S621 : Sample_0 = sample_in_0(_S620, _S615, _S616, _S617);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S621.height_2;
    probe_1.hole_1 = _S621.shown_2.hole_0;
    probe_1.slope_x_1 = _S621.slope_x_0;
    probe_1.slope_y_1 = _S621.slope_y_0;
    var _S622 : bool = !is_layered_0(_S614);
    probe_1.yarn_1 = select(_S621.crossing_3.weft_2.thread_1 * u32(2), _S621.crossing_3.warp_2.thread_1 * u32(2) + u32(1), _S621.shown_2.is_warp_0) * plane_count_0(_S614) + _S620.number_1;
    probe_1.cell_max_0 = select(_S620.bounds_0.x, cell_maximum_0(_S620.plane_3, _S621.crossing_3), _S622);
    probe_1.side_x_0 = select(_S620.bounds_0.y, select(_S621.crossing_3.warp_2.below_0, _S621.crossing_3.warp_2.above_0, _S618), _S622);
    probe_1.side_y_0 = select(_S620.bounds_0.z, select(_S621.crossing_3.weft_2.below_0, _S621.crossing_3.weft_2.above_0, _S619), _S622);
    probe_1.edge_x_1 = min(_S620.edge_x_0, outline_distance_0(_S621.crossing_3.warp_2, _S621.shown_2, _S621.run_2, !_S621.shown_2.is_warp_0, _S618));
    probe_1.edge_y_1 = min(_S620.edge_y_0, outline_distance_0(_S621.crossing_3.weft_2, _S621.shown_2, _S621.run_2, _S621.shown_2.is_warp_0, _S619));
    return probe_1;
}

fn is_free_0( _S623 : u32,  _S624 : SearchQuality_0,  _S625 : vec3<f32>,  _S626 : vec3<f32>,  _S627 : bool,  _S628 : f32) -> bool
{
    var _S629 : f32 = _S626.z;
    if(_S629 <= 0.0f)
    {
        return false;
    }
    var _S630 : f32 = 1.0f / max(_S624.shadow_share_0 * steps_per_length_0(_S623, _S624, _S626), 9.99999971718068537e-10f);
    var _S631 : StepControl_0 = step_control_0(_S626.xy, _S630);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S625.z + _S629 * distance_2) < _S628))))
        {
        }
        else
        {
            break;
        }
        var _S632 : vec3<f32> = _S625 + _S626 * vec3<f32>(distance_2);
        var _S633 : Probe_0 = probe_0(_S623, _S632.x, _S632.y, _S627, _S631.right_1, _S631.up_1);
        var _S634 : f32 = _S632.z;
        var _S635 : f32 = _S634 - _S633.height_3;
        var _S636 : f32 = _S629 - _S633.slope_x_1 * _S626.x - _S633.slope_y_1 * _S626.y;
        if(((!_S633.hole_1) & ((_S635 < 0.0f))))
        {
            return false;
        }
        var _S637 : f32 = way_back_to_dip_0(previous_3, _S635, _S636, last_step_0, _S633);
        if(_S637 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S637;
            distance_2 = distance_2 - _S637;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S638 : bool = _S634 > (_S633.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S631, _S633, _S635, _S636), max(StepControl_to_cell_exit_0(_S631, _S633.side_x_0, _S633.side_y_0), _S630), _S638);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S635, _S636, _S633, _S638);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S639 : u32,  _S640 : SearchQuality_0,  _S641 : f32,  _S642 : f32,  _S643 : vec3<f32>,  _S644 : bool) -> bool
{
    if(!sample_at_0(_S639, _S641, _S642, _S644).shown_2.hole_0)
    {
        return false;
    }
    var _S645 : vec3<f32> = vec3<f32>(_S641, _S642, 0.0f);
    var passes_0 : bool = true;
    var side_3 : u32 = u32(0);
    for(;;)
    {
        if(((side_3 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S646 : bool = is_free_0(_S639, _S640, _S645, select_vector_2(side_3 == u32(0), _S643, vec3<f32>(- _S643.x, - _S643.y, _S643.z)), _S644 != (side_3 == u32(1)), fabrics_0[_S639].height_high_0);
        var _S647 : u32 = side_3 + u32(1);
        passes_0 = _S646;
        side_3 = _S647;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_6 : f32,
     last_step_3 : f32,
     depth_0 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn plane_of_0( _S648 : u32,  _S649 : u32) -> Plane_0
{
    if(!is_layered_0(_S648))
    {
        return whole_plane_0(_S648);
    }
    return plane_at_0(fabrics_0[_S648].plane_records_0 + _S649 * u32(16));
}

fn max_height_along_0( _S650 : u32,  _S651 : f32,  _S652 : f32,  _S653 : f32,  _S654 : vec3<f32>,  _S655 : bool) -> f32
{
    var _S656 : f32 = _S654.x;
    var _S657 : f32 = _S654.y;
    var _S658 : u32 = select(u32(0), u32(1), _S656 > 0.0f) + select(u32(0), u32(2), _S657 > 0.0f);
    var _S659 : f32 = max(abs(_S656) * fabrics_0[_S650].threads_per_x_0, abs(_S657) * fabrics_0[_S650].threads_per_y_0) / _S654.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_8 : u32 = u32(0);
    for(;;)
    {
        if(number_8 < (plane_count_0(_S650)))
        {
        }
        else
        {
            break;
        }
        var _S660 : Plane_0 = plane_of_0(_S650, number_8);
        var _S661 : u32 = (words_0[_S660.max_heights_1 + u32(4) * (locate_0(_S660.weft_1, _S652 - _S660.start_y_0).thread_1 / u32(2) * _S660.max_height_columns_1 + locate_0(_S660.warp_1, _S651 - _S660.start_x_0).thread_1 / u32(2)) + _S658] >> (u32(select(i32(0), i32(4), _S655))));
        var _S662 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S661 & (u32(15)))), f32((((_S661 >> (u32(8)))) & (u32(15)))), f32((((_S661 >> (u32(16)))) & (u32(15)))), f32((((_S661 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S660.height_high_1) + vec4<f32>(select(_S660.front_level_0, _S660.back_level_0, _S655)));
        var _S663 : u32 = number_8 + u32(1);
        levels_4 = _S662;
        number_8 = _S663;
    }
    var max_height_0 : f32 = fabrics_0[_S650].height_high_0;
    var number_9 : i32 = i32(3);
    for(;;)
    {
        if(number_9 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S653) * _S659) <= (PYRAMID_RADII_0[number_9]))
        {
            max_height_0 = min(max_height_0, levels_4[number_9]);
        }
        number_9 = number_9 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S664 : u32,  _S665 : f32,  _S666 : f32,  _S667 : bool,  _S668 : bool,  _S669 : bool) -> vec3<f32>
{
    if(is_layered_0(_S664))
    {
        return first_bounds_0(_S664, plane_order_0(_S664, _S665, _S666, _S667), _S665, _S666, _S667, _S668, _S669);
    }
    return bounds_in_0(whole_plane_0(_S664), _S665, _S666, _S667, _S668, _S669);
}

fn first_sample_height_0( _S670 : u32,  _S671 : ViewRay_0,  _S672 : StepControl_0,  _S673 : bool) -> f32
{
    var _S674 : f32 = max_height_along_0(_S670, _S671.origin_0.x, _S671.origin_0.y, 0.0f, vec3<f32>(_S671.slope_1, 1.0f), _S673);
    var count_5 : u32 = u32(0);
    var height_7 : f32 = _S674;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S675 : vec2<f32> = ViewRay_at_0(_S671, height_7);
        var _S676 : vec3<f32> = cell_bounds_0(_S670, _S675.x, _S675.y, _S673, _S672.right_1, _S672.up_1);
        var _S677 : f32 = height_7 - _S676.x;
        var _S678 : f32 = StepControl_to_cell_exit_0(_S672, _S676.y, _S676.z);
        var height_8 : f32 = height_7 - clamp(_S677, 0.0f, _S678);
        if(_S677 <= _S678)
        {
            height_7 = height_8;
            break;
        }
        count_5 = count_5 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S679 : u32,  _S680 : ViewRay_0,  _S681 : StepControl_0,  _S682 : bool) -> ViewRayEnd_0
{
    var _S683 : f32 = fabrics_0[_S679].height_low_0 - (fabrics_0[_S679].height_high_0 - fabrics_0[_S679].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S679, _S680, _S681, _S682);
    end_1.last_step_3 = _S681.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_0 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_6 : u32 = u32(0);
    for(;;)
    {
        if(count_6 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S684 : vec2<f32> = ViewRay_at_0(_S680, end_1.height_6);
        var _S685 : Probe_0 = probe_0(_S679, _S684.x, _S684.y, _S682, _S681.right_1, _S681.up_1);
        var _S686 : f32 = end_1.height_6 - _S685.height_3;
        var _S687 : f32 = ViewRay_rate_0(_S680, _S685);
        end_1.depth_0 = - _S686;
        end_1.rate_4 = _S687;
        var _S688 : bool = !_S685.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S688))) & (((end_1.previous_4.yarn_0) == (_S685.yarn_1))));
        if((((_S688 & ((_S686 <= 0.0f)))) | (((end_1.height_6) <= _S683))))
        {
            break;
        }
        var _S689 : f32 = way_back_to_dip_0(end_1.previous_4, _S686, _S687, end_1.last_step_3, _S685);
        if(_S689 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S689;
            end_1.last_step_3 = end_1.last_step_3 - _S689;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S690 : f32 = min(StepControl_to_cell_exit_0(_S681, _S685.side_x_0, _S685.side_y_0), end_1.height_6 - _S685.cell_max_0);
        var _S691 : f32 = StepControl_to_next_sample_0(_S681, _S685, _S686, _S687);
        end_1.previous_4 = after_sample_0(_S686, _S687, _S685, _S690 > _S691);
        var _S692 : f32 = max(_S690, _S691);
        end_1.last_step_3 = _S692;
        end_1.height_6 = end_1.height_6 - _S692;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S693 : u32,  _S694 : ViewRay_0,  _S695 : StepControl_0,  _S696 : bool,  _S697 : ViewRayEnd_0,  _S698 : u32) -> f32
{
    var _S699 : f32 = fabrics_0[_S693].height_high_0 - fabrics_0[_S693].height_low_0;
    var above_2 : f32 = _S697.height_6 + _S697.last_step_3;
    var above_gap_1 : f32 = clamp(_S697.previous_4.clearance_0, 0.0f, _S699);
    var under_gap_1 : f32 = clamp(_S697.depth_0, 0.0f, _S699);
    var middle_0 : f32 = select(between_0(above_2, _S697.height_6, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S697.previous_4.rate_0 * _S697.last_step_3, _S697.rate_4 * _S697.last_step_3) * _S697.last_step_3, _S697.smooth_0);
    var side_4 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S697.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S698)
        {
        }
        else
        {
            break;
        }
        var _S700 : vec2<f32> = ViewRay_at_0(_S694, middle_0);
        var _S701 : Probe_0 = probe_0(_S693, _S700.x, _S700.y, _S696, _S695.right_1, _S695.up_1);
        var _S702 : f32 = clamp(middle_0 - select(_S701.height_3, -1.0e+09f, _S701.hole_1), - _S699, _S699);
        if(_S702 <= 0.0f)
        {
            var _S703 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_4 > 0.0f);
            var _S704 : f32 = - _S702;
            under_1 = middle_0;
            above_gap_2 = _S703;
            under_gap_2 = _S704;
            side_4 = 1.0f;
        }
        else
        {
            var _S705 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_4 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S702;
            under_gap_2 = _S705;
            side_4 = -1.0f;
        }
        var _S706 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S702 / min(ViewRay_rate_0(_S694, _S701), -9.99999997475242708e-07f), under_1, above_3), _S697.smooth_0);
        var _S707 : u32 = i_1 + u32(1);
        middle_0 = _S706;
        i_1 = _S707;
    }
    return select(under_1, middle_0, _S697.smooth_0);
}

fn first_hit_of_yarn_0( _S708 : u32,  _S709 : SearchQuality_0,  _S710 : f32,  _S711 : f32,  _S712 : vec3<f32>,  _S713 : bool) -> Hit_0
{
    var _S714 : f32 = max(_S712.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S710, _S711);
    var _S715 : vec2<f32> = _S712.xy / vec2<f32>(_S714);
    ray_0.slope_1 = _S715;
    var _S716 : StepControl_0 = step_control_0((vec2<f32>(0) - _S715), 1.0f / max(steps_per_length_0(_S708, _S709, _S712) / _S714, 9.99999971718068537e-10f));
    var _S717 : ViewRayEnd_0 = search_down_0(_S708, ray_0, _S716, _S713);
    var hit_0 : Hit_0;
    hit_0.hole_3 = false;
    var _S718 : f32 = refined_height_0(_S708, ray_0, _S716, _S713, _S717, _S709.refinements_0);
    hit_0.height_5 = _S718;
    var _S719 : vec2<f32> = ViewRay_at_0(ray_0, _S718);
    hit_0.x_16 = _S719.x;
    hit_0.y_8 = _S719.y;
    return hit_0;
}

fn first_hit_0( _S720 : u32,  _S721 : SearchQuality_0,  _S722 : f32,  _S723 : f32,  _S724 : vec3<f32>,  _S725 : bool) -> Hit_0
{
    if(!passes_through_0(_S720, _S721, _S722, _S723, _S724, _S725))
    {
        return first_hit_of_yarn_0(_S720, _S721, _S722, _S723, _S724, _S725);
    }
    var hit_1 : Hit_0;
    hit_1.x_16 = _S722;
    hit_1.y_8 = _S723;
    hit_1.height_5 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

fn taps_at_yarns_0( _S726 : u32,  _S727 : Footprint_0,  _S728 : AnisotropicTaps_0,  _S729 : vec3<f32>,  _S730 : bool) -> AnisotropicTaps_0
{
    var _S731 : f32 = 1.0f - clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(_S728), 9.99999997475242708e-07f) / 0.25f) * 0.48089835047721863f, 0.0f, 1.0f);
    if(_S731 <= 0.0f)
    {
        return _S728;
    }
    var _S732 : Hit_0 = first_hit_0(_S726, default_quality_0(), _S727.centre_0.x, _S727.centre_0.y, _S729, _S730);
    if(_S732.hole_3)
    {
        return _S728;
    }
    var moved_2 : AnisotropicTaps_0 = _S728;
    moved_2.centre_1 = moved_2.centre_1 + vec2<f32>(_S731) * vec2<f32>(fabrics_0[_S726].neural_0.ends_per_mm_0, fabrics_0[_S726].neural_0.picks_per_mm_0) * (vec2<f32>(_S732.x_16, _S732.y_8) - _S727.centre_0);
    return moved_2;
}

fn add_texel_0( _S733 : u32,  _S734 : u32,  _S735 : f32,  _S736 : ptr<function, array<f32, i32(88)>>)
{
    var _S737 : u32 = fabrics_0[_S733].neural_0.latents_0 + _S734 * u32(8);
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
        var _S738 : Eight_0 = eight_halves_0(packed_numbers_0[_S737 + part_0]);
        var _S739 : i32 = i32(u32(8) * part_0);
        (*_S736)[_S739] = (*_S736)[_S739] + _S735 * _S738.low_0[i32(0)];
        (*_S736)[_S739 + i32(4)] = (*_S736)[_S739 + i32(4)] + _S735 * _S738.high_0[i32(0)];
        var _S740 : i32 = _S739 + i32(1);
        (*_S736)[_S740] = (*_S736)[_S740] + _S735 * _S738.low_0[i32(1)];
        (*_S736)[_S740 + i32(4)] = (*_S736)[_S740 + i32(4)] + _S735 * _S738.high_0[i32(1)];
        var _S741 : i32 = _S739 + i32(2);
        (*_S736)[_S741] = (*_S736)[_S741] + _S735 * _S738.low_0[i32(2)];
        (*_S736)[_S741 + i32(4)] = (*_S736)[_S741 + i32(4)] + _S735 * _S738.high_0[i32(2)];
        var _S742 : i32 = _S739 + i32(3);
        (*_S736)[_S742] = (*_S736)[_S742] + _S735 * _S738.low_0[i32(3)];
        (*_S736)[_S742 + i32(4)] = (*_S736)[_S742 + i32(4)] + _S735 * _S738.high_0[i32(3)];
        part_0 = part_0 + u32(1);
    }
    return;
}

fn add_level_0( _S743 : u32,  _S744 : u32,  _S745 : bool,  _S746 : vec2<f32>,  _S747 : f32,  _S748 : ptr<function, array<f32, i32(88)>>)
{
    var _S749 : Neural_std430_0 = fabrics_0[_S743].neural_0;
    var _S750 : u32 = fabrics_0[_S743].neural_0.levels_1 + u32(4) * _S744;
    var _S751 : f32 = table_number_0(_S750);
    var _S752 : f32 = table_number_0(_S750 + u32(1));
    var _S753 : f32 = table_number_0(_S750 + u32(2));
    var _S754 : vec2<f32> = _S746 * vec2<f32>(table_number_0(_S750 + u32(3))) - vec2<f32>(select(0.5f, 1.0f, ((_S744 > u32(3)) & ((_S744 < (fabrics_0[_S743].neural_0.top_level_0))))));
    var _S755 : vec2<f32> = floor(_S754);
    var _S756 : vec2<f32> = _S754 - _S755;
    var corner_1 : u32 = u32(0);
    for(;;)
    {
        if(corner_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S757 : f32 = f32((corner_1 & (u32(1))));
        var _S758 : f32 = f32((corner_1 >> (u32(1))));
        var _S759 : vec2<f32> = mix(vec2<f32>(1.0f) - _S756, _S756, vec2<f32>(_S757, _S758));
        add_texel_0(_S743, u32(_S751 + wrapped_0(_S755.y + _S758, _S753) * _S752 + wrapped_0(_S755.x + _S757, _S752)) + select(u32(0), _S749.texels_0, _S745), _S747 * _S759.x * _S759.y, &((*_S748)));
        corner_1 = corner_1 + u32(1);
    }
    return;
}

fn code_footprint_0( _S760 : u32,  _S761 : AnisotropicTaps_0,  _S762 : vec3<f32>,  _S763 : bool,  _S764 : ptr<function, array<f32, i32(88)>>)
{
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
        (*_S764)[k_0] = 0.0f;
        k_0 = k_0 + i32(1);
    }
    var _S765 : vec2<f32> = vec2<f32>(fabrics_0[_S760].neural_0.ends_0, fabrics_0[_S760].neural_0.picks_0);
    var _S766 : f32 = f32(fabrics_0[_S760].neural_0.top_level_0);
    var _S767 : f32 = clamp(binary_logarithm_0(max(_S761.side_2, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S766);
    var _S768 : f32 = min(floor(_S767), _S766 - 1.0f);
    var _S769 : u32 = select(u32(1), u32(4), AnisotropicTaps_has_steps_0(_S761));
    var number_10 : u32 = u32(0);
    for(;;)
    {
        if(number_10 < (u32(2) * _S769))
        {
        }
        else
        {
            break;
        }
        var _S770 : vec2<f32> = AnisotropicTaps_place_0(_S761, (number_10 >> (u32(1))));
        var _S771 : bool = ((number_10 & (u32(1)))) != u32(0);
        var _S772 : f32 = _S767 - _S768;
        add_level_0(_S760, u32(_S768) + select(u32(0), u32(1), _S771), _S763, clamp(_S770 - _S765 * floor(_S770 / _S765), vec2<f32>(0.0f), _S765), select(1.0f - _S772, _S772, _S771) / f32(_S769), &((*_S764)));
        number_10 = number_10 + u32(1);
    }
    var number_11 : i32 = i32(0);
    for(;;)
    {
        if(number_11 < i32(3))
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
            var offset_1 : f32 = _S762[number_11] - (f32(bin_0) + 0.5f) / 8.0f;
            var offset_2 : f32;
            if(number_11 < i32(2))
            {
                offset_2 = offset_1 - round(offset_1);
            }
            else
            {
                offset_2 = offset_1;
            }
            (*_S764)[i32(64) + number_11 * i32(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + i32(1);
        }
        number_11 = number_11 + i32(1);
    }
    return;
}

fn crown_fibres_0( _S773 : u32,  _S774 : bool,  _S775 : bool) -> vec3<f32>
{
    if(_S774)
    {
        return vec3<f32>(select(1.0f, -1.0f, _S775) * fabrics_0[_S773].neural_0.warp_x_0, fabrics_0[_S773].neural_0.warp_y_0, fabrics_0[_S773].neural_0.warp_roughness_0);
    }
    return vec3<f32>(fabrics_0[_S773].neural_0.weft_x_0, select(1.0f, -1.0f, _S775) * fabrics_0[_S773].neural_0.weft_y_0, fabrics_0[_S773].neural_0.weft_roughness_0);
}

fn yarns_over_0( _S776 : u32,  _S777 : Footprint_0,  _S778 : bool) -> Yarns_0
{
    var _S779 : vec2<f32> = _S777.dx_0;
    var _S780 : vec2<f32> = _S777.dy_0;
    var _S781 : vec2<f32> = sqrt(_S779 * _S779 + _S780 * _S780);
    var _S782 : f32 = Footprint_spread_side_0(_S777);
    var _S783 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_1 : Yarns_0 = Yarns_x24init_0(_S783, _S783, vec3<f32>(0.0f));
    var _S784 : bool = (fabrics_0[_S776].is_irregular_0) != u32(0);
    var number_12 : u32 = u32(0);
    for(;;)
    {
        if(number_12 < select(u32(0), u32(2), _S784))
        {
        }
        else
        {
            break;
        }
        var _S785 : bool = number_12 == u32(0);
        var _S786 : u32 = select(fabrics_0[_S776].weft_0, fabrics_0[_S776].warp_0, _S785);
        var _S787 : vec2<f32> = select_vector_1(_S785, _S777.centre_0, _S777.centre_0.yx);
        var _S788 : vec2<f32> = select_vector_1(_S785, _S781, _S781.yx);
        var _S789 : f32 = _S787.x;
        var _S790 : Cell_0 = locate_0(_S786, _S789);
        var yarn_3 : vec4<f32> = irregular_over_0(_S786, irregular_key_0(_S776, number_12), irregular_thread_0(_S786, _S789, _S790) + _S790.below_0 / (_S790.below_0 + _S790.above_0), _S788.x * (families_0[_S786].count_0 / families_0[_S786].period_0), _S787.y, _S788.y);
        yarn_3[i32(1)] = yarn_3[i32(1)] * (1.0f - moved_share_0(_S786, _S782));
        yarns_1.warp_3 = yarns_1.weft_3;
        yarns_1.weft_3 = yarn_3;
        number_12 = number_12 + u32(1);
    }
    var _S791 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S776].warp_0].cover_0, families_0[fabrics_0[_S776].weft_0].cover_0);
    var _S792 : f32 = select(fabrics_0[_S776].warp_on_top_0, 1.0f - fabrics_0[_S776].warp_on_top_0, _S778);
    var _S793 : vec3<f32> = shown_of_covers_0(_S791, _S792);
    var _S794 : vec3<f32> = select_vector_2(_S784, shown_of_covers_0(saturate(_S791 + _S791 * vec2<f32>(yarns_1.warp_3.y, yarns_1.weft_3.y)), _S792) / max(_S793, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_1.shares_0 = _S794;
    yarns_1.shares_0[i32(2)] = select(1.0f, _S794.z, (_S793.z) > 0.00009999999747379f);
    return yarns_1;
}

fn neural_view_0( _S795 : u32,  _S796 : Footprint_0,  _S797 : vec3<f32>,  _S798 : ptr<function, NeuralView_0>)
{
    var _S799 : bool = (_S797.z) < 0.0f;
    var _S800 : vec3<f32> = to_face_frame_0(_S797, _S799);
    var _S801 : AnisotropicTaps_0 = taps_at_yarns_0(_S795, _S796, anisotropic_taps_0(_S795, _S796), _S800, _S799);
    var _S802 : vec3<f32> = footprint_coordinates_0(_S801);
    var weights_23 : HalfWeights_0;
    weights_23.first_2 = fabrics_0[_S795].neural_0.network_0;
    var inputs_23 : array<f32, i32(88)>;
    code_footprint_0(_S795, _S801, _S802, _S799, &(inputs_23));
    var hidden_1 : array<f32, i32(64)>;
    dense_7(weights_23, u32(0), false, &(inputs_23), &(hidden_1));
    var fused_0 : array<f32, i32(68)>;
    dense_part_8(weights_23, u32(712), false, &(hidden_1), &(fused_0));
    fused_0[i32(64)] = _S800.x;
    fused_0[i32(65)] = _S800.y;
    var _S803 : vec2<f32> = _S800.xy;
    fused_0[i32(66)] = dot(crown_fibres_0(_S795, true, _S799).xy, _S803);
    fused_0[i32(67)] = dot(crown_fibres_0(_S795, false, _S799).xy, _S803);
    var of_hole_0 : array<f32, i32(16)>;
    dense_6(weights_23, u32(1232), false, &(fused_0), &(of_hole_0));
    var hole_4 : array<f32, i32(1)>;
    dense_5(weights_23, u32(1380), false, &(of_hole_0), &(hole_4));
    var _S804 : array<f32, i32(64)> = (*_S798).sums_12;
    dense_4(weights_23, u32(1392), false, &(fused_0), &(_S804));
    (*_S798).sums_12 = _S804;
    var _S805 : f32 = clamp(hole_4[i32(0)], 0.0f, 1.0f);
    (*_S798).even_hole_0 = _S805;
    (*_S798).yarns_0 = yarns_over_0(_S795, _S796, _S799);
    (*_S798).hole_2 = min(_S805 * (*_S798).yarns_0.shares_0.z, 1.0f);
    (*_S798).correction_weight_0 = correction_weight_of_0(_S802.z);
    (*_S798).view_8 = _S800;
    (*_S798).back_10 = _S799;
    return;
}

fn stack_share_0( _S806 : u32,  _S807 : vec2<f32>,  _S808 : vec2<f32>,  _S809 : u32) -> f32
{
    if((fabrics_0[_S806].stacks_0) == u32(1))
    {
        return 1.0f;
    }
    var _S810 : u32 = fabrics_0[_S806].plane_axes_0 + u32(1);
    var _S811 : Stretch_0 = stretch_of_0(fabrics_0[_S806].plane_axes_0, _S807.x, _S808.x);
    var _S812 : Stretch_0 = stretch_of_0(_S810, _S807.y, _S808.y);
    return clamp(integral_on_top_0(fabrics_0[_S806].plane_axes_0, _S811, _S812, u32(families_0[_S810].count_0), _S809) / (lengths_0(fabrics_0[_S806].plane_axes_0, _S811).x * lengths_0(_S810, _S812).x), 0.0f, 1.0f);
}

fn layered_albedos_0( _S813 : u32,  _S814 : Footprint_0,  _S815 : NearestLayer_0,  _S816 : bool,  _S817 : vec3<f32>,  _S818 : vec3<f32>) -> LayeredAlbedos_0
{
    var _S819 : vec2<f32> = _S814.dx_0;
    var _S820 : vec2<f32> = _S814.dy_0;
    var _S821 : vec2<f32> = sqrt(_S819 * _S819 + _S820 * _S820);
    var _S822 : vec3<f32> = vec3<f32>(0.0f);
    var _S823 : Albedos_0 = Albedos_x24init_0(_S822, _S822, _S822, _S822);
    var _S824 : FamilyAlbedos_0 = FamilyAlbedos_x24init_0(_S823, _S823);
    var _S825 : LayersBehind_0 = LayersBehind_x24init_0(_S822, _S822);
    var found_1 : LayeredAlbedos_0 = LayeredAlbedos_x24init_0(_S824, _S824, _S825);
    var _S826 : LayerSums_0 = LayerSums_x24init_0(_S823, _S823, 0.0f, 0.0f, 0.0f, _S825);
    var warp_10 : LayerSums_0 = _S826;
    var weft_10 : LayerSums_0 = _S826;
    var number_13 : u32 = u32(0);
    for(;;)
    {
        if(number_13 < (plane_count_0(_S813)))
        {
        }
        else
        {
            break;
        }
        var _S827 : FamilyAlbedos_0 = albedos_in_0(plane_of_0(_S813, number_13), _S814.centre_0, _S821, _S816);
        if(!is_layered_0(_S813))
        {
            found_1.albedos_0 = _S827;
            found_1.means_0 = _S827;
            return found_1;
        }
        var _S828 : f32 = select(1.0f - _S815.weight_0, 1.0f, number_13 == (_S815.number_4));
        var stack_0 : u32 = u32(0);
        for(;;)
        {
            if(stack_0 < (fabrics_0[_S813].stacks_0))
            {
            }
            else
            {
                break;
            }
            var _S829 : f32 = stack_share_0(_S813, _S814.centre_0, _S821, stack_0);
            var _S830 : u32 = fabrics_0[_S813].plane_shares_0 + u32(144) * (u32(2) * (stack_0 * fabrics_0[_S813].planes_0 + number_13) + select(u32(0), u32(1), _S816));
            var _S831 : LayerSums_0 = with_seen_0(warp_10, _S827.warp_5, families_0[fabrics_0[_S813].warp_0].layer_through_0, _S830, _S829, _S828, _S817, _S818);
            var _S832 : LayerSums_0 = with_seen_0(weft_10, _S827.weft_5, families_0[fabrics_0[_S813].weft_0].layer_through_0, _S830 + u32(72), _S829, _S828, _S817, _S818);
            var _S833 : u32 = stack_0 + u32(1);
            warp_10 = _S831;
            weft_10 = _S832;
            stack_0 = _S833;
        }
        number_13 = number_13 + u32(1);
    }
    var _S834 : f32 = warp_10.weight_2;
    found_1.albedos_0.warp_5 = divided_0(warp_10.albedos_2, _S834, _S834);
    var _S835 : f32 = weft_10.weight_2;
    found_1.albedos_0.weft_5 = divided_0(weft_10.albedos_2, _S835, _S835);
    found_1.means_0.warp_5 = divided_0(warp_10.means_2, warp_10.lit_0, warp_10.passed_0);
    found_1.means_0.weft_5 = divided_0(weft_10.means_2, weft_10.lit_0, weft_10.passed_0);
    found_1.behind_0.reflected_0 = warp_10.behind_2.reflected_0 + weft_10.behind_2.reflected_0;
    found_1.behind_0.transmitted_0 = warp_10.behind_2.transmitted_0 + weft_10.behind_2.transmitted_0;
    return found_1;
}

fn albedos_over_0( _S836 : u32,  _S837 : Footprint_0,  _S838 : bool) -> FamilyAlbedos_0
{
    const _S839 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 1.0f);
    return layered_albedos_0(_S836, _S837, NearestLayer_x24init_0(u32(0), 0.0f), _S838, _S839, _S839).means_0;
}

fn toned_0( _S840 : u32,  _S841 : u32,  _S842 : Albedos_0,  _S843 : vec4<f32>) -> Albedos_0
{
    var _S844 : vec3<f32> = _S842.diffuse_reflect_0 + _S842.diffuse_transmit_0;
    var _S845 : vec3<f32> = vec3<f32>(1.0f);
    var _S846 : vec3<f32> = _S845 - vec3<f32>(fabrics_0[_S840].layer_bound_0) * max(_S842.specular_reflect_0, _S842.specular_transmit_0);
    var _S847 : vec3<f32> = vec3<f32>(0.0f);
    var _S848 : vec3<f32> = max(_S845 - _S844, _S847) / (_S845 + _S844);
    var _S849 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S850 : vec3<f32> = (_S846 / max(_S844, _S849) - _S845) / max(vec3<f32>(0.89999997615814209f) * _S848, _S849);
    var _S851 : vec3<f32> = _S845 - vec3<f32>((saturate(min(min(_S850.x, _S850.y), _S850.z)) * _S843.z)) * _S848;
    var _S852 : vec3<f32> = min(vec3<f32>(families_0[_S841].nep_red_0, families_0[_S841].nep_green_0, families_0[_S841].nep_blue_0), _S846);
    var found_2 : Albedos_0 = _S842;
    var _S853 : f32 = _S843.w;
    var _S854 : vec3<f32> = _S851 * _S842.diffuse_transmit_0 * vec3<f32>((1.0f - _S853));
    found_2.diffuse_transmit_0 = _S854;
    found_2.diffuse_reflect_0 = clamp(mix(_S851 * _S842.diffuse_reflect_0, _S852, vec3<f32>(_S853)), _S847, max(_S846 - _S854, _S847));
    return found_2;
}

fn with_tones_0( _S855 : u32,  _S856 : FamilyAlbedos_0,  _S857 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S855].is_irregular_0) == u32(0))
    {
        return _S856;
    }
    var result_5 : FamilyAlbedos_0;
    result_5.warp_5 = toned_0(_S855, fabrics_0[_S855].warp_0, _S856.warp_5, _S857.warp_3);
    result_5.weft_5 = toned_0(_S855, fabrics_0[_S855].weft_0, _S856.weft_5, _S857.weft_3);
    return result_5;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S858 : u32,  _S859 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S858 * frame_record_0.height_0 + _S859.y) * frame_record_0.width_0 + _S859.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_4 : f32,
};

fn environment_texel_0( _S860 : u32,  _S861 : u32) -> vec3<f32>
{
    var _S862 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S860 * frame_record_0.environment_columns_0 + _S861);
    return vec3<f32>(scene_number_0(_S862), scene_number_0(_S862 + u32(1)), scene_number_0(_S862 + u32(2)));
}

fn sample_environment_0( _S863 : vec2<f32>,  _S864 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S865 : u32 = frame_record_0.environment_rows_0;
    var _S866 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S863.y);
    var _S867 : u32 = frame_record_0.environment_columns_0;
    var _S868 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S866.index_7 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S863.x);
    var _S869 : vec3<f32> = environment_texel_0(_S866.index_7, _S868.index_7);
    (*_S864) = _S869 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S869), 9.99999968265522539e-21f)));
    var _S870 : f32 = 3.14159274101257324f / f32(_S865);
    var _S871 : f32 = mix(sine_cosine_0(f32(_S866.index_7) * _S870).y, sine_cosine_0(f32(_S866.index_7 + u32(1)) * _S870).y, _S866.remainder_0);
    var _S872 : f32 = sqrt(max(1.0f - _S871 * _S871, 0.0f));
    var _S873 : vec2<f32> = sine_cosine_0((f32(_S868.index_7) + _S868.remainder_0) * (6.28318548202514648f / f32(_S867)));
    var _S874 : f32 = _S872 * _S873.x;
    var _S875 : f32 = - _S872 * _S873.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S874 + frame_record_0.environment_sine_0 * _S875, _S871, frame_record_0.environment_cosine_0 * _S875 - frame_record_0.environment_sine_0 * _S874);
}

fn light_sample_0( _S876 : u32,  _S877 : vec2<u32>,  _S878 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_4 = 1.00000001504746622e+30f;
    var _S879 : u32 = frame_record_0.lights_0;
    if(_S876 >= (frame_record_0.lights_0))
    {
        var weight_7 : vec3<f32>;
        var _S880 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S877, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S876 - _S879), u32(3)), &(weight_7));
        sample_1.towards_0 = _S880;
        sample_1.irradiance_1 = weight_7 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S881 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S876);
    sample_1.irradiance_1 = vec3<f32>(_S881.red_0, _S881.green_0, _S881.blue_0);
    sample_1.towards_0 = vec3<f32>(_S881.x_12, _S881.y_4, _S881.z_1);
    if((_S881.is_point_0) != u32(0))
    {
        var _S882 : vec3<f32> = sample_1.towards_0 - _S878;
        var _S883 : f32 = max(square_0(_S882), 9.999999960041972e-13f);
        sample_1.distance_4 = sqrt(_S883);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S883);
        sample_1.towards_0 = normalize(_S882);
    }
    return sample_1;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_5 : f32,
};

fn code_light_0( _S884 : u32,  _S885 : vec3<f32>,  _S886 : vec3<f32>,  _S887 : bool,  _S888 : ptr<function, array<f32, i32(39)>>)
{
    (*_S888)[i32(0)] = _S885.x;
    (*_S888)[i32(1)] = _S885.y;
    (*_S888)[i32(2)] = _S885.z;
    var _S889 : vec3<f32> = _S885 + _S886;
    var _S890 : f32 = _S889.z;
    var _S891 : f32 = _S890 * _S890 + 0.00009999999747379f;
    var _S892 : vec2<f32> = _S889.xy;
    var _S893 : f32 = 1.0f / (dot(_S892, _S892) + _S891);
    var family_20 : i32 = i32(0);
    for(;;)
    {
        if(family_20 < i32(2))
        {
        }
        else
        {
            break;
        }
        var _S894 : vec3<f32> = crown_fibres_0(_S884, family_20 == i32(0), _S887);
        var _S895 : vec2<f32> = _S894.xy;
        (*_S888)[i32(3) + family_20] = dot(_S895, _S885.xy);
        var _S896 : f32 = dot(_S895, _S892);
        var _S897 : f32 = _S896 * _S896;
        var _S898 : f32 = (0.75f * _S896 / (0.5f * sqrt(_S897 + _S891) + abs(_S896)) + 0.5f) * 8.0f;
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
            (*_S888)[i32(5) + family_20 * i32(16) + bin_1] = bump_0(_S898 - (f32(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + i32(1);
        }
        var _S899 : f32 = _S894.z;
        var _S900 : f32 = _S899 * _S899;
        var _S901 : f32 = _S897 * _S893 * (1.0f - _S900) + _S900;
        (*_S888)[i32(37) + family_20] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S900 * _S899 / (_S901 * _S901));
        family_20 = family_20 + i32(1);
    }
    return;
}

fn mixed_bundles_0( _S902 : u32,  _S903 : u32,  _S904 : u32,  _S905 : vec3<f32>,  _S906 : vec3<f32>,  _S907 : bool,  _S908 : ptr<function, array<f32, i32(52)>>) -> f32
{
    var _S909 : vec3<f32> = _S905 + _S906;
    var _S910 : f32 = 1.0f / (square_0(_S909) + 0.00009999999747379f);
    var _S911 : f32 = _S909.x;
    var _S912 : f32 = select(_S911, - _S911, ((_S903 == u32(0)) & (_S907)));
    var _S913 : f32 = _S909.y;
    var _S914 : f32 = select(_S913, - _S913, ((_S903 == u32(1)) & (_S907)));
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
        var _S915 : u32 = _S903 * u32(25);
        var _S916 : u32 = fabrics_0[_S902].neural_0.bundles_0 + u32(4) * (_S915 + bundle_1);
        var _S917 : f32 = dot(vec3<f32>(table_number_0(_S916), table_number_0(_S916 + u32(1)), table_number_0(_S916 + u32(2))), vec3<f32>(_S912, _S914, _S909.z));
        var _S918 : f32 = _S917 * _S917 * _S910 + table_number_0(_S916 + u32(3));
        var sum_3 : f32 = sum_2 + max((*_S908)[_S904 + _S915 + select(bundle_1, mirrored_bundle_0(bundle_1), _S907)], (*_S908)[_S904 + _S915 + select(bundle_1, mirrored_bundle_0(bundle_1), _S907)] * 0.00999999977648258f) / (_S918 * _S918);
        bundle_1 = bundle_1 + u32(1);
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

fn with_shares_0( _S919 : u32,  _S920 : Components_0,  _S921 : Yarns_0) -> Components_0
{
    var result_6 : Components_0;
    var _S922 : f32 = min(_S920.hole_5 * _S921.shares_0.z, 1.0f);
    result_6.hole_5 = _S922;
    var _S923 : f32 = _S921.shares_0.x;
    result_6.diffuse_warp_0 = _S920.diffuse_warp_0 * _S923;
    var _S924 : f32 = _S921.shares_0.y;
    result_6.diffuse_weft_0 = _S920.diffuse_weft_0 * _S924;
    result_6.specular_warp_0 = _S920.specular_warp_0 * _S923;
    result_6.specular_weft_0 = _S920.specular_weft_0 * _S924;
    result_6.light_visibility_1 = _S920.light_visibility_1 * select(1.0f, (1.0f - _S922) / max(1.0f - _S920.hole_5, 9.99999997475242708e-07f), (fabrics_0[_S919].is_irregular_0) != u32(0));
    return result_6;
}

fn neural_components_0( _S925 : u32,  _S926 : ptr<function, NeuralView_0>,  _S927 : vec3<f32>) -> Components_0
{
    var _S928 : bool = (*_S926).back_10;
    var _S929 : vec3<f32> = to_face_frame_0(_S927, (*_S926).back_10);
    var _S930 : vec3<f32> = (*_S926).view_8;
    var weights_24 : HalfWeights_0;
    var _S931 : Neural_std430_0 = fabrics_0[_S925].neural_0;
    weights_24.first_2 = fabrics_0[_S925].neural_0.network_0;
    var directions_0 : array<f32, i32(39)>;
    code_light_0(_S925, _S929, (*_S926).view_8, (*_S926).back_10, &(directions_0));
    var skip_0 : array<f32, i32(64)>;
    var k_1 : i32 = i32(0);
    for(;;)
    {
        if(k_1 < i32(64))
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = (*_S926).sums_12[k_1];
        k_1 = k_1 + i32(1);
    }
    dense_3(weights_24, u32(1976), true, &(directions_0), &(skip_0));
    var hidden_2 : array<f32, i32(64)>;
    var next_0 : array<f32, i32(64)>;
    k_1 = i32(0);
    for(;;)
    {
        if(k_1 < i32(64))
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
            if(k_1 < i32(64))
            {
            }
            else
            {
                break;
            }
            next_0[k_1] = select(0.0f, skip_0[k_1], layer_0 == u32(1));
            k_1 = k_1 + i32(1);
        }
        dense_2(weights_24, u32(2304) + layer_0 * u32(520), true, &(hidden_2), &(next_0));
        var k_2 : i32 = i32(0);
        for(;;)
        {
            if(k_2 < i32(64))
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
    dense_1(weights_24, u32(3864), false, &(hidden_2), &(outputs_17));
    var _S932 : bool;
    if((_S931.is_corrected_0) != u32(0))
    {
        _S932 = (_S929.z) > 0.0f;
    }
    else
    {
        _S932 = false;
    }
    if(_S932)
    {
        _S932 = ((*_S926).correction_weight_0) > 0.0f;
    }
    else
    {
        _S932 = false;
    }
    if(_S932)
    {
        var fitted_0 : FloatWeights_0;
        fitted_0.first_0 = _S931.correction_0;
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
            outputs_17[k_1 + i32(2)] = outputs_17[k_1 + i32(2)] + (*_S926).correction_weight_0 * change_0[k_1];
            k_1 = k_1 + i32(1);
        }
    }
    var _S933 : f32 = select(0.00100000004749745f, 0.00999999977648258f, (_S929.z) > 0.0f);
    var result_7 : Components_0;
    var _S934 : f32 = unmapped_0(outputs_17[i32(0)], _S933);
    result_7.diffuse_warp_0 = _S934;
    var _S935 : f32 = unmapped_0(outputs_17[i32(1)], _S933);
    result_7.diffuse_weft_0 = _S935;
    var _S936 : f32 = 2979.9580078125f * _S933;
    var _S937 : f32 = mixed_bundles_0(_S925, u32(0), u32(2), _S929, _S930, _S928, &(outputs_17));
    result_7.specular_warp_0 = clamp(_S937, 0.0f, _S936);
    var _S938 : f32 = mixed_bundles_0(_S925, u32(1), u32(2), _S929, _S930, _S928, &(outputs_17));
    result_7.specular_weft_0 = clamp(_S938, 0.0f, _S936);
    result_7.hole_5 = (*_S926).even_hole_0;
    result_7.light_visibility_1 = min(light_visibility_of_0(_S934 + _S935, _S929, _S930, fabrics_0[_S925].diffuse_blend_0), 1.0f - (*_S926).even_hole_0);
    return with_shares_0(_S925, result_7, (*_S926).yarns_0);
}

fn diffuse_kept_0( _S939 : u32,  _S940 : vec3<f32>,  _S941 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S939].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S940.z), 0.0f))) * (1.0f - fabrics_0[_S939].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S941.z), 0.0f)));
}

fn highlight_rise_0( _S942 : u32,  _S943 : vec3<f32>,  _S944 : vec3<f32>) -> f32
{
    var _S945 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S943, _S944) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S942].grazing_gain_0 * fourth_power_0(_S945) * _S945;
}

fn towards_grazing_0( _S946 : u32,  _S947 : Albedos_0,  _S948 : vec3<f32>,  _S949 : vec3<f32>) -> Albedos_0
{
    var _S950 : f32 = diffuse_kept_0(_S946, _S948, _S949);
    var result_8 : Albedos_0 = _S947;
    var _S951 : vec3<f32> = vec3<f32>(_S950);
    result_8.diffuse_reflect_0 = result_8.diffuse_reflect_0 * _S951;
    result_8.diffuse_transmit_0 = result_8.diffuse_transmit_0 * _S951;
    result_8.specular_reflect_0 = result_8.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S946, _S948, _S949));
    return result_8;
}

fn openness_number_0( _S952 : u32,  _S953 : u32) -> f32
{
    return table_number_0(fabrics_0[_S952].openness_0 + _S953);
}

fn scattered_by_0( _S954 : u32,  _S955 : Albedos_0,  _S956 : u32,  _S957 : vec3<f32>) -> Scattered_0
{
    var _S958 : u32 = u32(159) + u32(2) * _S956;
    var yarn_4 : Scattered_0;
    yarn_4.back_9 = _S957 * _S955.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S954, _S958)) * _S955.specular_reflect_0;
    yarn_4.through_1 = _S957 * _S955.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S954, _S958 + u32(1))) * _S955.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S959 : u32,  _S960 : u32,  _S961 : vec3<f32>,  _S962 : vec3<f32>,  _S963 : vec3<f32>,  _S964 : vec3<f32>,  _S965 : ptr<function, vec3<f32>>,  _S966 : ptr<function, vec3<f32>>)
{
    var _S967 : u32 = u32(146) + u32(4) * _S960;
    var _S968 : f32 = openness_number_0(_S959, _S967 + u32(1));
    var _S969 : f32 = openness_number_0(_S959, _S967 + u32(2));
    var _S970 : vec3<f32> = vec3<f32>(1.0f);
    var _S971 : vec3<f32> = _S970 - _S963 * vec3<f32>(openness_number_0(_S959, _S967));
    var _S972 : vec3<f32> = _S970 - _S964 * vec3<f32>(openness_number_0(_S959, _S967 + u32(3)));
    var _S973 : vec3<f32> = _S970 / (_S971 * _S972 - _S963 * _S964 * vec3<f32>((_S968 * _S969)));
    (*_S965) = (_S961 * _S972 + _S963 * vec3<f32>(_S968) * _S962) * _S973;
    (*_S966) = (_S962 * _S971 + _S964 * vec3<f32>(_S969) * _S961) * _S973;
    return;
}

fn face_sends_0( _S974 : u32,  _S975 : u32,  _S976 : Scattered_0,  _S977 : Scattered_0) -> FaceSends_0
{
    var _S978 : u32 = u32(2) * _S975;
    var _S979 : u32 = u32(142) + _S978;
    var _S980 : f32 = openness_number_0(_S974, _S979);
    var _S981 : f32 = openness_number_0(_S974, _S979 + u32(1));
    var _S982 : vec3<f32> = vec3<f32>((1.0f - _S980)) * _S976.back_9;
    var _S983 : vec3<f32> = vec3<f32>((1.0f - _S981)) * _S977.back_9;
    var sends_1 : FaceSends_0;
    var _S984 : u32 = u32(154) + _S978;
    var _S985 : f32 = openness_number_0(_S974, _S984);
    sends_1.blocks_warp_0 = _S985;
    var _S986 : f32 = openness_number_0(_S974, _S984 + u32(1));
    sends_1.blocks_weft_0 = _S986;
    sends_1.open_0 = _S985 * _S980 + _S986 * _S981;
    var _S987 : vec3<f32> = vec3<f32>(_S980) * _S976.back_9;
    var _S988 : vec3<f32> = vec3<f32>(_S981) * _S977.back_9;
    var _S989 : vec3<f32> = sends_1.sky_warp_0;
    var _S990 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S974, _S975, _S987, _S988, _S982, _S983, &(_S989), &(_S990));
    sends_1.sky_warp_0 = _S989;
    sends_1.sky_weft_0 = _S990;
    var _S991 : vec3<f32> = sends_1.crossing_warp_0;
    var _S992 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S974, _S975, _S976.through_1, _S977.through_1, _S982, _S983, &(_S991), &(_S992));
    sends_1.crossing_warp_0 = _S991;
    sends_1.crossing_weft_0 = _S992;
    return sends_1;
}

fn interior_between_0( _S993 : u32,  _S994 : u32,  _S995 : u32,  _S996 : vec3<f32>,  _S997 : bool) -> Interior_0
{
    var _S998 : Scattered_0 = scattered_by_0(_S993, table_albedos_0(_S994), u32(0), _S996);
    var _S999 : Scattered_0 = scattered_by_0(_S993, table_albedos_0(_S995), u32(1), _S996);
    var _S1000 : FaceSends_0 = face_sends_0(_S993, select(u32(0), u32(1), _S997), _S998, _S999);
    var _S1001 : FaceSends_0 = face_sends_0(_S993, select(u32(1), u32(0), _S997), _S998, _S999);
    var _S1002 : vec3<f32> = vec3<f32>(_S1000.blocks_warp_0);
    var _S1003 : vec3<f32> = vec3<f32>(_S1000.blocks_weft_0);
    var _S1004 : vec3<f32> = _S1002 * _S1000.crossing_warp_0 + _S1003 * _S1000.crossing_weft_0;
    var _S1005 : vec3<f32> = vec3<f32>(_S1001.blocks_warp_0);
    var _S1006 : vec3<f32> = vec3<f32>(_S1001.blocks_weft_0);
    var _S1007 : vec3<f32> = _S1005 * _S1001.crossing_warp_0 + _S1006 * _S1001.crossing_weft_0;
    var _S1008 : f32 = 1.0f - _S1000.open_0;
    var _S1009 : f32 = 1.0f - _S1001.open_0;
    var _S1010 : vec3<f32> = vec3<f32>(1.0f);
    var _S1011 : vec3<f32> = _S1010 / (_S1010 - _S1004 * _S1007 * vec3<f32>((_S1008 * _S1009)));
    var _S1012 : vec3<f32> = _S1007 * (vec3<f32>(_S1000.open_0) + vec3<f32>(_S1008) * (_S1002 * _S1000.sky_warp_0 + _S1003 * _S1000.sky_weft_0)) * _S1011;
    var _S1013 : vec3<f32> = _S1004 * (vec3<f32>(_S1001.open_0) + vec3<f32>(_S1009) * (_S1005 * _S1001.sky_warp_0 + _S1006 * _S1001.sky_weft_0)) * _S1011;
    var _S1014 : FaceRadiance_0 = face_radiance_0(_S1000, _S1001.open_0, _S1012, _S1013);
    var _S1015 : FaceRadiance_0 = face_radiance_0(_S1001, _S1000.open_0, _S1013, _S1012);
    var interior_1 : Interior_0;
    interior_1.warp_9 = _S1014.warp_8;
    interior_1.weft_9 = _S1014.weft_8;
    interior_1.leaked_1 = _S1014.leaked_0;
    interior_1.far_1 = _S1015.mean_1;
    interior_1.far_leaked_0 = _S1015.leaked_0;
    return interior_1;
}

fn interior_of_0( _S1016 : u32,  _S1017 : vec3<f32>,  _S1018 : bool) -> Interior_0
{
    return interior_between_0(_S1016, families_0[fabrics_0[_S1016].warp_0].cloth_mean_0, families_0[fabrics_0[_S1016].weft_0].cloth_mean_0, _S1017, _S1018);
}

fn blocked_of_terms_0( _S1019 : u32,  _S1020 : u32,  _S1021 : array<f32, i32(6)>,  _S1022 : u32) -> Blocked_0
{
    var shares_2 : array<f32, i32(3)>;
    var share_4 : u32 = u32(0);
    for(;;)
    {
        if(share_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_2[share_4] = 0.0f;
        var term_2 : u32 = u32(0);
        for(;;)
        {
            if(term_2 < _S1022)
            {
            }
            else
            {
                break;
            }
            shares_2[share_4] = shares_2[share_4] + openness_number_0(_S1019, _S1020 + share_4 * _S1022 + term_2) * _S1021[term_2];
            term_2 = term_2 + u32(1);
        }
        shares_2[share_4] = saturate(shares_2[share_4]);
        share_4 = share_4 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_2[i32(0)] * shares_2[i32(2)];
    blocked_2.by_weft_0 = shares_2[i32(0)] * (1.0f - shares_2[i32(2)]);
    blocked_2.far_0 = shares_2[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S1023 : u32,  _S1024 : vec3<f32>,  _S1025 : bool,  _S1026 : bool) -> Blocked_0
{
    var terms_5 : array<f32, i32(6)>;
    view_terms_0(_S1024, &(terms_5));
    return blocked_of_terms_0(_S1023, (select(u32(0), u32(2), _S1026) + select(u32(1), u32(0), _S1025)) * u32(15), terms_5, u32(5));
}

fn warp_seen_from_0( _S1027 : u32,  _S1028 : vec3<f32>,  _S1029 : bool) -> f32
{
    var terms_6 : array<f32, i32(6)>;
    view_terms_1(_S1028, &(terms_6));
    var term_3 : u32 = u32(0);
    var share_5 : f32 = 0.0f;
    for(;;)
    {
        if(term_3 < u32(5))
        {
        }
        else
        {
            break;
        }
        var share_6 : f32 = share_5 + openness_number_0(_S1027, u32(132) + select(u32(0), u32(5), _S1029) + term_3) * terms_6[term_3];
        term_3 = term_3 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S1030 : u32,  _S1031 : FamilyAlbedos_0,  _S1032 : vec3<f32>,  _S1033 : Interior_0,  _S1034 : Blocked_0,  _S1035 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S1034, scattered_by_0(_S1030, _S1031.warp_5, u32(0), _S1032), _S1033), bounced_by_0(_S1035, scattered_by_0(_S1030, _S1031.weft_5, u32(1), _S1032), _S1033));
}

fn bounced_far_0( _S1036 : u32,  _S1037 : FamilyAlbedos_0,  _S1038 : vec3<f32>,  _S1039 : Interior_0,  _S1040 : vec3<f32>,  _S1041 : bool,  _S1042 : f32,  _S1043 : f32,  _S1044 : f32) -> Bounced_0
{
    var _S1045 : Blocked_0 = blocked_from_0(_S1036, _S1040, true, _S1041);
    var _S1046 : Blocked_0 = blocked_from_0(_S1036, _S1040, false, _S1041);
    var _S1047 : f32 = _S1042 / max(1.0f - _S1045.by_warp_0 - _S1045.by_weft_0, 0.10000000149011612f);
    var _S1048 : f32 = (0.0020000000949949f * warp_seen_from_0(_S1036, _S1040, _S1041) + _S1047) / (_S1047 + _S1043 / max(1.0f - _S1046.by_warp_0 - _S1046.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S1049 : f32 = 1.0f - _S1044;
    return bounced_of_families_0(_S1036, _S1037, _S1038, _S1039, scaled_0(_S1045, _S1048 * _S1049), scaled_0(_S1046, (1.0f - _S1048) * _S1049));
}

fn bounced_over_0( _S1050 : u32,  _S1051 : Components_0,  _S1052 : CloseUp_0,  _S1053 : FamilyAlbedos_0,  _S1054 : vec3<f32>,  _S1055 : vec3<f32>) -> Bounced_0
{
    var _S1056 : bool = (_S1055.z) < 0.0f;
    var _S1057 : Interior_0 = interior_of_0(_S1050, _S1054, _S1056);
    var bounced_2 : Bounced_0 = bounced_far_0(_S1050, _S1053, _S1054, _S1057, to_face_frame_0(_S1055, _S1056), _S1056, _S1051.diffuse_warp_0, _S1051.diffuse_weft_0, _S1051.hole_5);
    if((_S1052.weight_6) > 0.0f)
    {
        var _S1058 : Bounced_0 = bounced_of_families_0(_S1050, _S1053, _S1054, _S1057, _S1052.warp_7, _S1052.weft_7);
        var _S1059 : vec3<f32> = vec3<f32>(_S1052.weight_6);
        bounced_2.reflected_2 = mix(bounced_2.reflected_2, _S1058.reflected_2, _S1059);
        bounced_2.transmitted_2 = mix(bounced_2.transmitted_2, _S1058.transmitted_2, _S1059);
    }
    return bounced_2;
}

fn composed_before_0( _S1060 : u32,  _S1061 : Components_0,  _S1062 : CloseUp_0,  _S1063 : FamilyAlbedos_0,  _S1064 : FamilyAlbedos_0,  _S1065 : LayersBehind_0,  _S1066 : vec3<f32>,  _S1067 : vec3<f32>,  _S1068 : vec3<f32>) -> vec3<f32>
{
    var _S1069 : Albedos_0 = towards_grazing_0(_S1060, tinted_0(_S1063.warp_5, _S1066), _S1067, _S1068);
    var _S1070 : Albedos_0 = towards_grazing_0(_S1060, tinted_0(_S1063.weft_5, _S1066), _S1067, _S1068);
    var _S1071 : vec3<f32> = vec3<f32>(_S1061.diffuse_warp_0);
    var _S1072 : vec3<f32> = vec3<f32>(_S1061.diffuse_weft_0);
    var _S1073 : vec3<f32> = vec3<f32>(_S1061.specular_warp_0);
    var _S1074 : vec3<f32> = vec3<f32>(_S1061.specular_weft_0);
    var _S1075 : vec3<f32> = _S1069.diffuse_reflect_0 * _S1071 + _S1070.diffuse_reflect_0 * _S1072 + _S1069.specular_reflect_0 * _S1073 + _S1070.specular_reflect_0 * _S1074;
    var _S1076 : f32 = _S1067.z;
    var _S1077 : f32 = _S1068.z;
    var _S1078 : bool = (_S1076 * _S1077) < 0.0f;
    var body_0 : vec3<f32>;
    if(_S1078)
    {
        body_0 = _S1069.diffuse_transmit_0 * _S1071 + _S1070.diffuse_transmit_0 * _S1072 + _S1069.specular_transmit_0 * _S1073 + _S1070.specular_transmit_0 * _S1074;
    }
    else
    {
        body_0 = _S1075;
    }
    if((fabrics_0[_S1060].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S1060, _S1061, _S1062, _S1064, _S1066, _S1068), _S1067, _S1068) * vec3<f32>(diffuse_kept_0(_S1060, _S1067, _S1068));
    }
    if(is_layered_0(_S1060))
    {
        body_0 = body_0 + _S1066 * select_vector_2(_S1078, _S1065.transmitted_0, _S1065.reflected_0) * vec3<f32>((abs(_S1076) * 0.31830987334251404f)) * vec3<f32>(diffuse_kept_0(_S1060, _S1067, _S1068));
    }
    var _S1079 : f32 = fabrics_0[_S1060].sheen_strength_0;
    if((fabrics_0[_S1060].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1080 : bool = _S1077 < 0.0f;
    var _S1081 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1067, _S1080), to_face_frame_0(_S1068, _S1080), _S1079, fabrics_0[_S1060].sheen_roughness_0);
    return vec3<f32>(_S1081.y) * body_0 + vec3<f32>(((_S1061.light_visibility_1 + _S1061.hole_5) * _S1081.x));
}

fn composed_0( _S1082 : u32,  _S1083 : Components_0,  _S1084 : CloseUp_0,  _S1085 : FamilyAlbedos_0,  _S1086 : vec3<f32>,  _S1087 : vec3<f32>,  _S1088 : vec3<f32>) -> vec3<f32>
{
    var _S1089 : vec3<f32> = vec3<f32>(0.0f);
    return composed_before_0(_S1082, _S1083, _S1084, _S1085, _S1085, LayersBehind_x24init_0(_S1089, _S1089), _S1086, _S1087, _S1088);
}

fn light_of_neural_0( _S1090 : u32,  _S1091 : VisiblePoint_0,  _S1092 : vec2<u32>,  _S1093 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.dx_0 = _S1091.draft_dx_0;
    footprint_1.dy_0 = _S1091.draft_dy_0;
    footprint_1.centre_0 = irregular_place_0(_S1090, _S1091.draft_0, Footprint_spread_side_0(footprint_1));
    var _S1094 : vec3<f32> = to_local_0(_S1091, _S1091.view_0);
    var activations_0 : NeuralView_0;
    neural_view_0(_S1090, footprint_1, _S1094, &(activations_0));
    var _S1095 : f32 = _S1094.z;
    var _S1096 : FamilyAlbedos_0 = with_tones_0(_S1090, albedos_over_0(_S1090, footprint_1, _S1095 < 0.0f), activations_0.yarns_0);
    var _S1097 : vec3<f32> = vec3<f32>(0.0f);
    var number_14 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1097;
    for(;;)
    {
        if(number_14 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S1098 : f32 = visibility_at_0(number_14, _S1092);
        if(_S1098 <= 0.0f)
        {
            number_14 = number_14 + u32(1);
            continue;
        }
        var _S1099 : LightSample_0 = light_sample_0(number_14, _S1092, _S1091.position_4);
        var _S1100 : vec3<f32> = to_local_0(_S1091, _S1099.towards_0);
        var _S1101 : Components_0 = neural_components_0(_S1090, &(activations_0), _S1100);
        radiance_1 = radiance_1 + vec3<f32>(_S1098) * _S1099.irradiance_1 * composed_0(_S1090, _S1101, no_close_up_0(), _S1096, _S1093, _S1100, _S1094);
        number_14 = number_14 + u32(1);
    }
    var hole_6 : f32 = activations_0.hole_2;
    var _S1102 : f32 = fabrics_0[_S1090].sheen_strength_0;
    var hole_7 : f32;
    if((fabrics_0[_S1090].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_6 * (1.0f - _S1102 * sheen_lobe_0(abs(_S1095), fabrics_0[_S1090].sheen_roughness_0).z);
    }
    else
    {
        hole_7 = hole_6;
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_neural(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1103 : u32 = id_0.x;
    var _S1104 : bool;
    if(_S1103 >= (frame_record_0.width_0))
    {
        _S1104 = true;
    }
    else
    {
        _S1104 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S1104)
    {
        return;
    }
    var _S1105 : u32 = id_0.y * frame_record_0.width_0 + _S1103;
    var _S1106 : u32 = layers_0[_S1105].face_0;
    if((layers_0[_S1105].face_0) == u32(0))
    {
        return;
    }
    var _S1107 : u32 = _S1106 - u32(1);
    var _S1108 : u32 = fabric_of_0(_S1107);
    var _S1109 : vec2<u32> = id_0.xy;
    var _S1110 : VisiblePoint_0 = visible_point_0(_S1108, _S1107, _S1109);
    accumulate_0(_S1105, light_of_neural_0(_S1108, _S1110, _S1109, filtered_albedo_0(_S1108, _S1110)));
    return;
}

