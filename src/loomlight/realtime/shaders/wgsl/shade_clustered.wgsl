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

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec4<f32>,  no_0 : vec4<f32>) -> vec4<f32>
{
    var chosen_0 : vec4<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    chosen_0[i32(3)] = select(no_0[i32(3)], yes_0[i32(3)], condition_0);
    return chosen_0;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

fn select_vector_2( condition_2 : bool,  yes_2 : vec3<f32>,  no_2 : vec3<f32>) -> vec3<f32>
{
    var chosen_2 : vec3<f32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    return chosen_2;
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

fn fabric_of_0( face_1 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_1];
}

struct Vertex_0
{
     x_1 : f32,
     y_0 : f32,
     z_0 : f32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     u_0 : f32,
     v_0 : f32,
};

fn scene_vertex_0( first_0 : u32) -> Vertex_0
{
    var record_0 : Vertex_0;
    record_0.x_1 = (bitcast<f32>((scene_words_0[first_0])));
    record_0.y_0 = (bitcast<f32>((scene_words_0[first_0 + u32(1)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_0 + u32(2)])));
    record_0.normal_x_0 = (bitcast<f32>((scene_words_0[first_0 + u32(3)])));
    record_0.normal_y_0 = (bitcast<f32>((scene_words_0[first_0 + u32(4)])));
    record_0.normal_z_0 = (bitcast<f32>((scene_words_0[first_0 + u32(5)])));
    record_0.u_0 = (bitcast<f32>((scene_words_0[first_0 + u32(6)])));
    record_0.v_0 = (bitcast<f32>((scene_words_0[first_0 + u32(7)])));
    return record_0;
}

fn vertex_at_0( corner_0 : u32) -> Vertex_0
{
    return scene_vertex_0(frame_record_0.vertices_0 + u32(8) * scene_words_0[frame_record_0.corners_0 + corner_0]);
}

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.x_1, vertex_0.y_0, vertex_0.z_0);
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
    var _S1 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S2 : u32 = ((((_S1 >> ((((_S1 >> (u32(28)))) + u32(4))))) ^ (_S1))) * u32(277803737);
    return (((_S2 >> (u32(22)))) ^ (_S2));
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
    var _S3 : vec2<f32> = floor(place_0);
    var _S4 : vec2<f32> = place_0 - _S3;
    var _S5 : vec2<f32> = _S4 * _S4 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S4);
    var _S6 : u32 = u32(i32(_S3.x)) * u32(65536) + u32(i32(_S3.y));
    var _S7 : f32 = _S5.x;
    return mix(mix(uneven_corner_0(key_2, _S6), uneven_corner_0(key_2, _S6 + u32(65536)), _S7), mix(uneven_corner_0(key_2, _S6 + u32(1)), uneven_corner_0(key_2, _S6 + u32(65537)), _S7), _S5.y);
}

fn square_1( x_2 : f32) -> f32
{
    return x_2 * x_2;
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S8 : u32 = (bitcast<u32>((x_3)));
    var m_0 : f32 = (bitcast<f32>(((((_S8 & (u32(8388607)))) | (u32(1056964608))))));
    var _S9 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S8 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S9);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S9) - 1.0f;
    var _S10 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S10 - exponent_0 * 0.00021219444170129f - 0.5f * _S10) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S11 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S12 : f32 = floor(_S11 * 1.4426950216293335f + 0.5f);
    var _S13 : f32 = _S11 - _S12 * 0.693359375f + _S12 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S13 + 0.00139819993637502f) * _S13 + 0.00833345204591751f) * _S13 + 0.04166579619050026f) * _S13 + 0.1666666567325592f) * _S13 + 0.5f) * _S13 * _S13 + _S13 + 1.0f) * (bitcast<f32>(((u32(i32(_S12) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S14 : u32 = scene_words_0[index_0];
    var _S15 : vec3<f32> = vec3<f32>(f32((_S14 & (u32(1023)))), f32((((_S14 >> (u32(10)))) & (u32(1023)))), f32((_S14 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S15 * _S15;
}

fn map_level_0( first_1 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S16 : f32 = uv_0.x;
    var _S17 : f32 = f32(side_0);
    var _S18 : f32 = (_S16 - floor(_S16)) * _S17 - 0.5f;
    var _S19 : f32 = uv_0.y;
    var _S20 : f32 = (_S19 - floor(_S19)) * _S17 - 0.5f;
    var _S21 : f32 = floor(_S18);
    var _S22 : i32 = i32(side_0);
    var _S23 : u32 = side_0 - u32(1);
    var _S24 : u32 = (u32(i32(_S21) + _S22) & (_S23));
    var _S25 : f32 = floor(_S20);
    var _S26 : u32 = (u32(i32(_S25) + _S22) & (_S23));
    var _S27 : u32 = ((_S24 + u32(1)) & (_S23));
    var _S28 : u32 = first_1 + _S26 * side_0;
    var _S29 : vec3<f32> = vec3<f32>((_S18 - _S21));
    var _S30 : u32 = first_1 + (((_S26 + u32(1)) & (_S23))) * side_0;
    return mix(mix(map_texel_0(_S28 + _S24), map_texel_0(_S28 + _S27), _S29), mix(map_texel_0(_S30 + _S24), map_texel_0(_S30 + _S27), _S29), vec3<f32>((_S20 - _S25)));
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S31 : vec2<f32> = this_0.dx_0;
    var _S32 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S31, _S31) + dot(_S32, _S32)));
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
    var _S33 : f32 = floor(fma(index_1, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S33, fma(- _S33, families_0[family_1].count_0, index_1));
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
    var _S34 : f32 = floor(position_0 * families_0[family_2].inverse_size_0);
    var cell_2 : Cell_0;
    var _S35 : f32 = fma(- _S34, families_0[family_2].size_0, position_0);
    cell_2.below_0 = _S35;
    cell_2.above_0 = families_0[family_2].size_0 - _S35;
    cell_2.across_0 = _S35 - 0.5f * families_0[family_2].size_0;
    cell_2.half_width_1 = families_0[family_2].half_width_0;
    cell_2.thread_1 = u32(clamp(turns_and_remainder_0(family_2, _S34).y, 0.0f, families_0[family_2].count_0 - 1.0f));
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
    var _S36 : f32 = turns_1 * families_0[family_3].period_0;
    var thread_2 : u32 = words_0[families_0[family_3].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_3].bins_0, 0.0f, families_0[family_3].bins_0 - 1.0f))];
    var _S37 : u32 = min(thread_2 + select(u32(0), u32(1), _S36 >= (table_number_0(families_0[family_3].place_table_0 + thread_2 * u32(4) + u32(1)))), u32(families_0[family_3].count_0) - u32(1));
    var _S38 : u32 = families_0[family_3].place_table_0 + _S37 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_1 = _S37;
    cell_3.below_0 = _S36 - table_number_0(_S38);
    cell_3.above_0 = table_number_0(_S38 + u32(1)) - _S36;
    cell_3.across_0 = _S36 - table_number_0(_S38 + u32(2));
    cell_3.half_width_1 = table_number_0(_S38 + u32(3));
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

fn irregular_entry_0( row_0 : u32,  column_0 : f32) -> vec4<u32>
{
    var _S39 : u32 = row_0 + u32(4) * ((u32(i32(column_0)) & (u32(1023))));
    return vec4<u32>(words_0[_S39], words_0[_S39 + u32(1)], words_0[_S39 + u32(2)], words_0[_S39 + u32(3)]);
}

fn irregular_integral_0( family_6 : u32,  threads_0 : u32,  begin_0 : f32,  steps_0 : f32) -> vec4<f32>
{
    var _S40 : u32 = families_0[family_6].irregular_table_0 + threads_0 * u32(4096);
    var _S41 : f32 = begin_0 + steps_0;
    var _S42 : f32 = floor(begin_0);
    var _S43 : vec4<u32> = irregular_entry_0(_S40, _S42);
    var _S44 : f32 = floor(_S41);
    var _S45 : vec4<u32> = irregular_entry_0(_S40, _S44);
    return vec4<f32>(vec4<i32>(_S45 - _S43)) + (vec4<f32>(vec4<i32>(irregular_entry_0(_S40, _S44 + 1.0f) - _S45)) * vec4<f32>((_S41 - _S44)) - vec4<f32>(vec4<i32>(irregular_entry_0(_S40, _S42 + 1.0f) - _S43)) * vec4<f32>((begin_0 - _S42)));
}

fn irregular_units_0( family_7 : u32) -> vec4<f32>
{
    return vec4<f32>(families_0[family_7].irregular_thickness_0, families_0[family_7].irregular_cover_0, families_0[family_7].irregular_tone_0, families_0[family_7].irregular_nep_0);
}

fn irregular_at_0( family_8 : u32,  key_3 : u32,  number_0 : f32,  along_0 : f32) -> vec4<f32>
{
    var _S46 : f32 = floor(number_0 / 64.0f);
    var _S47 : u32 = hash_bits_0(key_3, u32(i32(_S46)));
    var _S48 : u32 = ((_S47 & (u32(127)))) + u32(number_0 - 64.0f * _S46);
    var _S49 : f32 = along_0 / 2.0f - 0.5f + f32((_S47 >> (u32(22))));
    var sums_1 : vec4<f32> = vec4<f32>(0.0f);
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
        var _S50 : vec4<f32> = irregular_integral_0(family_8, _S48 + side_1, _S49, 1.0f) - sums_1;
        var _S51 : u32 = side_1 + u32(1);
        sums_1 = _S50;
        side_1 = _S51;
    }
    return sums_1 * irregular_units_0(family_8);
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

fn mixed_0( number_1 : u32) -> u32
{
    var bits_0 : u32 = ((number_1 ^ (((number_1 >> (u32(16))))))) * u32(2246822507);
    var bits_1 : u32 = ((bits_0 ^ (((bits_0 >> (u32(13))))))) * u32(3266489909);
    return (bits_1 ^ (((bits_1 >> (u32(16))))));
}

fn uniform_of_0( seed_1 : u32,  dimension_0 : u32) -> f32
{
    return f32(((mixed_0(seed_1 + (dimension_0 + u32(1)) * u32(2654435769))) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S52 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S52, - _S52, back_2));
}

struct TexelBox_0
{
     corner_1 : vec2<f32>,
     size_3 : vec2<f32>,
     first_2 : vec2<u32>,
     extent_0 : vec2<f32>,
     last_0 : vec2<u32>,
     turns_2 : vec2<f32>,
};

fn texel_box_0( tables_0 : ptr<function, Clustered_std430_0>,  footprint_0 : Footprint_0,  offset_1 : vec2<f32>,  place_1 : f32) -> TexelBox_0
{
    var _S53 : f32 = footprint_0.dx_0.x;
    var _S54 : f32 = footprint_0.dy_0.x;
    var _S55 : f32 = sqrt(_S53 * _S53 + _S54 * _S54);
    var _S56 : f32 = footprint_0.dx_0.y;
    var _S57 : f32 = footprint_0.dy_0.y;
    var _S58 : f32 = sqrt(_S56 * _S56 + _S57 * _S57);
    var _S59 : vec2<f32> = vec2<f32>(_S55, _S58);
    var _S60 : f32 = (_S53 * _S56 + _S54 * _S57) / max(_S55 * _S58, 1.00000000317107685e-30f);
    var _S61 : f32 = abs(_S60);
    var _S62 : f32 = place_1 * sqrt(min(_S61, 1.0f));
    var _S63 : vec2<f32> = _S59 * vec2<f32>(_S62, select(_S62, - _S62, _S60 < 0.0f));
    var _S64 : vec2<f32> = vec2<f32>((*tables_0).texel_width_0, (*tables_0).texel_height_0);
    var _S65 : u32 = (*tables_0).columns_0;
    var _S66 : u32 = (*tables_0).rows_0;
    var _S67 : vec2<f32> = vec2<f32>(f32((*tables_0).columns_0), f32((*tables_0).rows_0));
    var box_0 : TexelBox_0;
    var _S68 : vec2<f32> = _S59 * vec2<f32>(sqrt(max(1.0f - _S61, 0.0f)));
    box_0.size_3 = _S68;
    var _S69 : vec2<f32> = vec2<f32>(0.5f);
    var _S70 : vec2<f32> = _S69 * _S68;
    var _S71 : vec2<f32> = footprint_0.centre_0 + _S63 - _S70;
    box_0.corner_1 = _S71;
    var _S72 : vec2<f32> = max(round(_S68 / _S64), vec2<f32>(1.0f));
    box_0.extent_0 = _S72;
    var _S73 : vec2<f32> = round((_S71 + _S70 + offset_1) / _S64 - _S69 * _S72);
    var _S74 : vec2<f32> = vec2<f32>(0.0f);
    var _S75 : vec2<f32> = max(_S73 - floor(_S73 / _S67) * _S67, _S74);
    var _S76 : vec2<u32> = vec2<u32>(min(u32(_S75.x), (*tables_0).columns_0 - u32(1)), min(u32(_S75.y), (*tables_0).rows_0 - u32(1)));
    box_0.first_2 = _S76;
    var _S77 : vec2<f32> = floor(_S72 / _S67);
    box_0.turns_2 = _S77;
    var _S78 : vec2<f32> = max(_S72 - _S77 * _S67, _S74);
    var _S79 : vec2<u32> = _S76 + vec2<u32>(u32(_S78.x), u32(_S78.y));
    box_0.last_0 = _S79;
    if((_S79.x) >= ((*tables_0).columns_0))
    {
        box_0.last_0[i32(0)] = box_0.last_0[i32(0)] - _S65;
        box_0.turns_2[i32(0)] = box_0.turns_2[i32(0)] + 1.0f;
    }
    if((box_0.last_0.y) >= _S66)
    {
        box_0.last_0[i32(1)] = box_0.last_0[i32(1)] - _S66;
        box_0.turns_2[i32(1)] = box_0.turns_2[i32(1)] + 1.0f;
    }
    return box_0;
}

fn arc_tangent_quotient_0( x_6 : f32,  y_1 : f32) -> f32
{
    return ((((((0.0f * x_6 + 0.00809729471802711f) * x_6 + -0.0377517081797123f) * x_6 + 0.08475969731807709f) * x_6 + -0.13537675142288208f) * x_6 + 0.19895026087760925f) * x_6 + -0.33327975869178772f) * x_6 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

struct BinTaps_0
{
     corner_2 : u32,
     bins_1 : u32,
     weights_0 : vec4<f32>,
};

fn bin_taps_0( direction_2 : vec3<f32>,  bins_2 : u32) -> BinTaps_0
{
    var _S80 : f32 = sqrt(max(1.0f - direction_2.z, 0.0f));
    var _S81 : f32 = direction_2.x;
    var _S82 : f32 = abs(_S81);
    var _S83 : f32 = direction_2.y;
    var _S84 : f32 = abs(_S83);
    var _S85 : bool = _S82 >= _S84;
    var _S86 : f32 = _S80 * (arc_tangent_of_ratio_0(min(_S82, _S84) / max(max(_S82, _S84), 9.999999960041972e-13f)) * 1.27323949337005615f);
    var _S87 : f32 = f32(bins_2);
    var _S88 : vec2<f32> = clamp((vec2<f32>(select(1.0f, -1.0f, _S81 < 0.0f) * select(_S86, _S80, _S85), select(1.0f, -1.0f, _S83 < 0.0f) * select(_S80, _S86, _S85)) + vec2<f32>(1.0f)) * vec2<f32>((0.5f * _S87)) - vec2<f32>(0.5f), vec2<f32>(0.0f), vec2<f32>((_S87 - 1.0f)));
    var _S89 : f32 = _S88.x;
    var _S90 : u32 = bins_2 - u32(2);
    var _S91 : u32 = min(u32(_S89), _S90);
    var _S92 : f32 = _S88.y;
    var _S93 : u32 = min(u32(_S92), _S90);
    var _S94 : f32 = _S89 - f32(_S91);
    var _S95 : f32 = _S92 - f32(_S93);
    var taps_0 : BinTaps_0;
    taps_0.corner_2 = _S93 * bins_2 + _S91;
    taps_0.bins_1 = bins_2;
    var _S96 : f32 = 1.0f - _S94;
    var _S97 : f32 = 1.0f - _S95;
    taps_0.weights_0 = vec4<f32>(_S96 * _S97, _S94 * _S97, _S96 * _S95, _S94 * _S95);
    return taps_0;
}

fn BinTaps_read_0( this_1 : BinTaps_0,  table_0 : u32,  first_3 : u32,  stride_0 : u32,  offset_2 : u32) -> f32
{
    var _S98 : u32 = table_0 + (first_3 + this_1.corner_2) * stride_0 + offset_2;
    return table_number_0(_S98) * this_1.weights_0.x + table_number_0(_S98 + stride_0) * this_1.weights_0.y + table_number_0(_S98 + this_1.bins_1 * stride_0) * this_1.weights_0.z + table_number_0(_S98 + (this_1.bins_1 + u32(1)) * stride_0) * this_1.weights_0.w;
}

fn summed_0( tables_1 : ptr<function, Clustered_std430_0>,  first_4 : u32,  column_1 : u32,  row_1 : u32) -> i32
{
    return i32(words_0[first_4 + (row_1 * ((*tables_1).columns_0 + u32(1)) + column_1) * (*tables_1).channels_0]);
}

fn box_mean_0( tables_2 : ptr<function, Clustered_std430_0>,  box_1 : TexelBox_0,  face_2 : u32,  channel_0 : u32) -> f32
{
    var _S99 : u32 = (*tables_2).columns_0;
    var _S100 : u32 = (*tables_2).rows_0;
    var _S101 : u32 = (*tables_2).sums_0 + face_2 * ((*tables_2).columns_0 + u32(1)) * ((*tables_2).rows_0 + u32(1)) * (*tables_2).channels_0 + channel_0;
    var _S102 : u32 = box_1.last_0.x;
    var _S103 : u32 = box_1.first_2.y;
    var _S104 : i32 = summed_0(&((*tables_2)), _S101, _S102, _S103);
    var _S105 : u32 = box_1.first_2.x;
    var _S106 : i32 = summed_0(&((*tables_2)), _S101, _S105, _S103);
    var _S107 : i32 = _S104 - _S106;
    var _S108 : u32 = box_1.last_0.y;
    var _S109 : i32 = summed_0(&((*tables_2)), _S101, _S102, _S108);
    var _S110 : i32 = summed_0(&((*tables_2)), _S101, _S105, _S108);
    var total_0 : f32 = f32(_S109 - _S110 - _S107);
    var _S111 : f32 = box_1.turns_2.x;
    var _S112 : bool = _S111 > 0.0f;
    var total_1 : f32;
    if(_S112)
    {
        var _S113 : i32 = summed_0(&((*tables_2)), _S101, _S99, _S108);
        var _S114 : i32 = summed_0(&((*tables_2)), _S101, _S99, _S103);
        total_1 = total_0 + _S111 * f32(_S113 - _S114);
    }
    else
    {
        total_1 = total_0;
    }
    var _S115 : f32 = box_1.turns_2.y;
    var _S116 : bool = _S115 > 0.0f;
    if(_S116)
    {
        var _S117 : i32 = summed_0(&((*tables_2)), _S101, _S102, _S100);
        var _S118 : i32 = summed_0(&((*tables_2)), _S101, _S105, _S100);
        total_1 = total_1 + _S115 * f32(_S117 - _S118);
    }
    if((_S112 & (_S116)))
    {
        var _S119 : f32 = _S111 * _S115;
        var _S120 : i32 = summed_0(&((*tables_2)), _S101, _S99, _S100);
        total_1 = total_1 + _S119 * f32(_S120);
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

fn box_mean_1( tables_3 : ptr<function, Clustered_std430_0>,  box_2 : TexelBox_0,  face_3 : u32,  channel_1 : u32) -> f32
{
    var _S121 : u32 = (*tables_3).columns_0;
    var _S122 : u32 = (*tables_3).rows_0;
    var _S123 : u32 = (*tables_3).sums_0 + face_3 * ((*tables_3).columns_0 + u32(1)) * ((*tables_3).rows_0 + u32(1)) * (*tables_3).channels_0 + channel_1;
    var _S124 : u32 = box_2.last_0.x;
    var _S125 : u32 = box_2.first_2.y;
    var _S126 : i32 = summed_0(&((*tables_3)), _S123, _S124, _S125);
    var _S127 : u32 = box_2.first_2.x;
    var _S128 : i32 = summed_0(&((*tables_3)), _S123, _S127, _S125);
    var _S129 : i32 = _S126 - _S128;
    var _S130 : u32 = box_2.last_0.y;
    var _S131 : i32 = summed_0(&((*tables_3)), _S123, _S124, _S130);
    var _S132 : i32 = summed_0(&((*tables_3)), _S123, _S127, _S130);
    var total_2 : f32 = f32(_S131 - _S132 - _S129);
    var _S133 : f32 = box_2.turns_2.x;
    var _S134 : bool = _S133 > 0.0f;
    var total_3 : f32;
    if(_S134)
    {
        var _S135 : i32 = summed_0(&((*tables_3)), _S123, _S121, _S130);
        var _S136 : i32 = summed_0(&((*tables_3)), _S123, _S121, _S125);
        total_3 = total_2 + _S133 * f32(_S135 - _S136);
    }
    else
    {
        total_3 = total_2;
    }
    var _S137 : f32 = box_2.turns_2.y;
    var _S138 : bool = _S137 > 0.0f;
    if(_S138)
    {
        var _S139 : i32 = summed_0(&((*tables_3)), _S123, _S124, _S122);
        var _S140 : i32 = summed_0(&((*tables_3)), _S123, _S127, _S122);
        total_3 = total_3 + _S137 * f32(_S139 - _S140);
    }
    if((_S134 & (_S138)))
    {
        var _S141 : f32 = _S133 * _S137;
        var _S142 : i32 = summed_0(&((*tables_3)), _S123, _S121, _S122);
        total_3 = total_3 + _S141 * f32(_S142);
    }
    return total_3 / (box_2.extent_0.x * box_2.extent_0.y);
}

fn box_mean_2( tables_4 : ptr<function, Clustered_std430_0>,  box_3 : TexelBox_0,  face_4 : u32,  channel_2 : u32) -> f32
{
    var _S143 : u32 = (*tables_4).columns_0;
    var _S144 : u32 = (*tables_4).rows_0;
    var _S145 : u32 = (*tables_4).sums_0 + face_4 * ((*tables_4).columns_0 + u32(1)) * ((*tables_4).rows_0 + u32(1)) * (*tables_4).channels_0 + channel_2;
    var _S146 : u32 = box_3.last_0.x;
    var _S147 : u32 = box_3.first_2.y;
    var _S148 : i32 = summed_0(&((*tables_4)), _S145, _S146, _S147);
    var _S149 : u32 = box_3.first_2.x;
    var _S150 : i32 = summed_0(&((*tables_4)), _S145, _S149, _S147);
    var _S151 : i32 = _S148 - _S150;
    var _S152 : u32 = box_3.last_0.y;
    var _S153 : i32 = summed_0(&((*tables_4)), _S145, _S146, _S152);
    var _S154 : i32 = summed_0(&((*tables_4)), _S145, _S149, _S152);
    var total_4 : f32 = f32(_S153 - _S154 - _S151);
    var _S155 : f32 = box_3.turns_2.x;
    var _S156 : bool = _S155 > 0.0f;
    var total_5 : f32;
    if(_S156)
    {
        var _S157 : i32 = summed_0(&((*tables_4)), _S145, _S143, _S152);
        var _S158 : i32 = summed_0(&((*tables_4)), _S145, _S143, _S147);
        total_5 = total_4 + _S155 * f32(_S157 - _S158);
    }
    else
    {
        total_5 = total_4;
    }
    var _S159 : f32 = box_3.turns_2.y;
    var _S160 : bool = _S159 > 0.0f;
    if(_S160)
    {
        var _S161 : i32 = summed_0(&((*tables_4)), _S145, _S146, _S144);
        var _S162 : i32 = summed_0(&((*tables_4)), _S145, _S149, _S144);
        total_5 = total_5 + _S159 * f32(_S161 - _S162);
    }
    if((_S156 & (_S160)))
    {
        var _S163 : f32 = _S155 * _S159;
        var _S164 : i32 = summed_0(&((*tables_4)), _S145, _S143, _S144);
        total_5 = total_5 + _S163 * f32(_S164);
    }
    return total_5 / (box_3.extent_0.x * box_3.extent_0.y);
}

fn parallax_offset_0( tables_5 : ptr<function, Clustered_std430_0>,  below_1 : TexelBox_0,  face_5 : u32,  view_1 : vec3<f32>) -> vec2<f32>
{
    var _S165 : f32 = view_1.z;
    var _S166 : f32 = max(1.0f - _S165 * _S165, 9.999999960041972e-13f);
    var _S167 : f32 = max(_S165, 0.60000002384185791f);
    var _S168 : f32 = sqrt((1.0f - _S167 * _S167) / _S166) / _S167;
    var _S169 : f32 = (_S167 - 0.60000002384185791f) * 2.5000002384185791f;
    var _S170 : vec2<f32> = view_1.xy;
    var _S171 : BinTaps_0 = bin_taps_0(vec3<f32>(_S170 * vec2<f32>(sqrt(max(1.0f - _S169 * _S169, 0.0f) / _S166)), _S169), u32(16));
    var _S172 : u32 = face_5 * u32(256);
    var _S173 : u32 = (*tables_5).channels_0 - u32(4);
    var _S174 : u32 = (*tables_5).heights_0;
    var _S175 : f32 = BinTaps_read_0(_S171, (*tables_5).heights_0, _S172, u32(5), u32(0));
    var number_2 : u32 = u32(0);
    var height_2 : f32 = _S175;
    for(;;)
    {
        if(number_2 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S176 : f32 = box_mean_2(&((*tables_5)), below_1, face_5, _S173 + number_2);
        var height_3 : f32 = height_2 + _S176 * BinTaps_read_0(_S171, _S174, _S172, u32(5), u32(1) + number_2);
        number_2 = number_2 + u32(1);
        height_2 = height_3;
    }
    return _S170 * vec2<f32>((_S168 * height_2));
}

struct Yarns_0
{
     warp_1 : vec4<f32>,
     weft_1 : vec4<f32>,
     shares_0 : vec3<f32>,
};

fn Yarns_x24init_0( warp_2 : vec4<f32>,  weft_2 : vec4<f32>,  shares_1 : vec3<f32>) -> Yarns_0
{
    var _S177 : Yarns_0;
    _S177.warp_1 = warp_2;
    _S177.weft_1 = weft_2;
    _S177.shares_0 = shares_1;
    return _S177;
}

fn irregular_over_0( family_9 : u32,  key_4 : u32,  place_2 : f32,  width_2 : f32,  along_1 : f32,  length_0 : f32) -> vec4<f32>
{
    var _S178 : f32 = max(width_2, 0.0625f);
    var _S179 : f32 = min(_S178, 64.0f);
    var _S180 : f32 = max(length_0 / 2.0f, 1.0f);
    var _S181 : f32 = along_1 / 2.0f - 0.5f * _S180;
    var _S182 : f32 = 0.5f * _S179;
    var _S183 : vec2<f32> = floor(vec2<f32>(place_2 - _S182, place_2 + _S182) / vec2<f32>(64.0f));
    var _S184 : vec4<f32> = vec4<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var sums_2 : vec4<f32> = _S184;
    for(;;)
    {
        if(number_3 < u32(6))
        {
        }
        else
        {
            break;
        }
        var _S185 : bool = number_3 >= u32(3);
        var _S186 : u32 = select(number_3, number_3 - u32(3), _S185);
        var _S187 : f32 = select(-1.0f, 1.0f, _S185);
        var _S188 : f32 = _S183.y;
        var _S189 : f32 = _S183.x;
        var _S190 : f32 = select(_S189, _S188, _S185);
        var _S191 : f32 = place_2 + _S187 * 0.5f * _S179 - 64.0f * _S190;
        var _S192 : f32 = clamp(floor(_S191), 0.0f, 63.0f);
        var _S193 : f32 = _S191 - _S192;
        var _S194 : f32 = select(select(64.0f, 0.0f, _S185), _S192 + f32(_S186), _S186 < u32(2));
        var _S195 : f32 = _S187 * select(select(select(0.0f, -1.0f, _S189 != _S188), _S193, _S186 == u32(1)), 1.0f - _S193, _S186 == u32(0));
        if(_S195 == 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S196 : u32 = hash_bits_0(key_4, u32(i32(_S190)));
        sums_2 = sums_2 + vec4<f32>(_S195) * irregular_integral_0(family_9, ((_S196 & (u32(127)))) + u32(_S194), _S181 + f32((_S196 >> (u32(22)))), _S180);
        number_3 = number_3 + u32(1);
    }
    return sums_2 * irregular_units_0(family_9) * vec4<f32>((sqrt(_S179 / _S178) / (_S179 * _S180)));
}

fn shown_of_covers_0( covers_0 : vec2<f32>,  warp_on_top_1 : f32) -> vec3<f32>
{
    var _S197 : f32 = covers_0.x;
    var _S198 : f32 = covers_0.y;
    return vec3<f32>(_S197 * (1.0f - _S198 * (1.0f - warp_on_top_1)), _S198 * (1.0f - _S197 * warp_on_top_1), (1.0f - _S197) * (1.0f - _S198));
}

struct NearestLayer_0
{
     number_4 : u32,
     weight_0 : f32,
};

fn NearestLayer_x24init_0( number_5 : u32,  weight_1 : f32) -> NearestLayer_0
{
    var _S199 : NearestLayer_0;
    _S199.number_4 = number_5;
    _S199.weight_0 = weight_1;
    return _S199;
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
    var _S200 : Albedos_0;
    _S200.diffuse_reflect_0 = diffuse_reflect_1;
    _S200.diffuse_transmit_0 = diffuse_transmit_1;
    _S200.specular_reflect_0 = specular_reflect_1;
    _S200.specular_transmit_0 = specular_transmit_1;
    return _S200;
}

struct FamilyAlbedos_0
{
     warp_3 : Albedos_0,
     weft_3 : Albedos_0,
};

fn FamilyAlbedos_x24init_0( warp_4 : Albedos_0,  weft_4 : Albedos_0) -> FamilyAlbedos_0
{
    var _S201 : FamilyAlbedos_0;
    _S201.warp_3 = warp_4;
    _S201.weft_3 = weft_4;
    return _S201;
}

struct LayersBehind_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

fn LayersBehind_x24init_0( reflected_1 : vec3<f32>,  transmitted_1 : vec3<f32>) -> LayersBehind_0
{
    var _S202 : LayersBehind_0;
    _S202.reflected_0 = reflected_1;
    _S202.transmitted_0 = transmitted_1;
    return _S202;
}

struct LayeredAlbedos_0
{
     albedos_0 : FamilyAlbedos_0,
     means_0 : FamilyAlbedos_0,
     behind_0 : LayersBehind_0,
};

fn LayeredAlbedos_x24init_0( albedos_1 : FamilyAlbedos_0,  means_1 : FamilyAlbedos_0,  behind_1 : LayersBehind_0) -> LayeredAlbedos_0
{
    var _S203 : LayeredAlbedos_0;
    _S203.albedos_0 = albedos_1;
    _S203.means_0 = means_1;
    _S203.behind_0 = behind_1;
    return _S203;
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
    var _S204 : LayerSums_0;
    _S204.albedos_2 = albedos_3;
    _S204.means_2 = means_3;
    _S204.weight_2 = weight_3;
    _S204.lit_0 = lit_1;
    _S204.passed_0 = passed_1;
    _S204.behind_2 = behind_3;
    return _S204;
}

struct Plane_0
{
     warp_5 : u32,
     weft_5 : u32,
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

fn plane_at_0( first_5 : u32) -> Plane_0
{
    var record_1 : Plane_0;
    record_1.warp_5 = words_0[first_5];
    record_1.weft_5 = words_0[first_5 + u32(1)];
    record_1.run_words_1 = words_0[first_5 + u32(2)];
    record_1.ends_2 = words_0[first_5 + u32(3)];
    record_1.end_numbers_0 = words_0[first_5 + u32(4)];
    record_1.pick_numbers_0 = words_0[first_5 + u32(5)];
    record_1.max_heights_1 = words_0[first_5 + u32(6)];
    record_1.max_height_columns_1 = words_0[first_5 + u32(7)];
    record_1.height_low_1 = (bitcast<f32>((words_0[first_5 + u32(8)])));
    record_1.height_high_1 = (bitcast<f32>((words_0[first_5 + u32(9)])));
    record_1.front_level_0 = (bitcast<f32>((words_0[first_5 + u32(10)])));
    record_1.back_level_0 = (bitcast<f32>((words_0[first_5 + u32(11)])));
    record_1.start_x_0 = (bitcast<f32>((words_0[first_5 + u32(12)])));
    record_1.start_y_0 = (bitcast<f32>((words_0[first_5 + u32(13)])));
    record_1.fine_x_0 = (bitcast<f32>((words_0[first_5 + u32(14)])));
    record_1.fine_y_0 = (bitcast<f32>((words_0[first_5 + u32(15)])));
    return record_1;
}

struct Bound_0
{
     thread_3 : u32,
     turns_3 : f32,
     cell_5 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_10 : u32,  position_5 : f32) -> Bound_0
{
    var _S205 : Cell_0 = locate_0(family_10, position_5);
    var _S206 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S205.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_3 = _S205.thread_1;
    bound_0.turns_3 = round((position_5 - families_0[family_10].start_0 - _S206 - _S205.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_5 = _S205.below_0;
    var _S207 : f32 = 2.0f * _S205.half_width_1;
    bound_0.width_3 = _S207;
    bound_0.visible_0 = clamp((_S205.across_0 + _S205.half_width_1) / _S207, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S205.below_0, _S205.below_0 - _S205.across_0 - _S205.half_width_1) + max(_S205.across_0 - _S205.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_4 : f32) -> Stretch_0
{
    var _S208 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S209 : f32 = 0.5f * max(size_4, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_11, _S208 - _S209);
    stretch_0.high_0 = bound_at_0(family_11, _S208 + _S209);
    return stretch_0;
}

fn table_colour_0( index_3 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_3), table_number_0(index_3 + u32(1)), table_number_0(index_3 + u32(2)));
}

fn table_albedos_0( row_2 : u32) -> Albedos_0
{
    var albedos_4 : Albedos_0;
    albedos_4.diffuse_reflect_0 = table_colour_0(row_2);
    albedos_4.diffuse_transmit_0 = table_colour_0(row_2 + u32(3));
    albedos_4.specular_reflect_0 = table_colour_0(row_2 + u32(6));
    albedos_4.specular_transmit_0 = table_colour_0(row_2 + u32(9));
    return albedos_4;
}

fn Stretch_turns_0( this_2 : Stretch_0) -> f32
{
    return this_2.high_0.turns_3 - this_2.low_0.turns_3;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S210 : f32 = Stretch_turns_0(stretch_1);
    var _S211 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_0.thread_3;
    var _S212 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_0.thread_3;
    var _S213 : f32 = table_number_0(_S212) - table_number_0(_S211);
    var _S214 : f32 = table_number_0(_S212 + u32(1)) - table_number_0(_S211 + u32(1));
    return vec3<f32>(_S213 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_3 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_3 + _S210 * families_0[family_12].visible_total_0, _S214 - _S213 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S210 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S214 + stretch_1.high_0.cell_5 - stretch_1.low_0.cell_5 + _S210 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S215 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S216 : u32 = families_0[family_13].colour_threads_0 + _S215 * stretch_2.low_0.thread_3 + quantity_0;
    var _S217 : u32 = families_0[family_13].colour_threads_0 + _S215 * stretch_2.high_0.thread_3 + quantity_0;
    var _S218 : u32 = families_0[family_13].colour_threads_0 + _S215 * u32(families_0[family_13].count_0) + quantity_0;
    var _S219 : f32 = table_number_0(_S216);
    var _S220 : f32 = table_number_0(_S217);
    var _S221 : f32 = Stretch_turns_0(stretch_2);
    var _S222 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S217 + families_0[family_13].quantities_0) - table_number_0(_S216 + families_0[family_13].quantities_0) + _S220 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_3 - _S219 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_3 + _S221 * table_number_0(_S218 + families_0[family_13].quantities_0), table_number_0(_S217 + _S222) - table_number_0(_S216 + _S222) + _S220 * stretch_2.high_0.cell_5 - _S219 * stretch_2.low_0.cell_5 + _S221 * table_number_0(_S218 + _S222));
}

fn Stretch_wraps_0( this_3 : Stretch_0) -> bool
{
    return (this_3.high_0.thread_3) < (this_3.low_0.thread_3);
}

fn Stretch_differences_0( this_4 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S223 : u32 = entries_0.z;
    var _S224 : u32 = entries_0.x;
    return vec4<u32>(_S223 - _S224 + select(u32(0), whole_0, Stretch_wraps_0(this_4)), entries_0.w - _S223, entries_0.y - _S224, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_3 : u32,  count_1 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S225 : u32 = row_3 + across_1.low_0.thread_3 * quantities_1;
    var _S226 : u32 = row_3 + across_1.high_0.thread_3 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S225], words_0[_S225 + quantities_1], words_0[_S226], words_0[_S226 + quantities_1]), words_0[row_3 + count_1 * quantities_1]);
}

fn Stretch_weights_0( this_5 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_5.high_0.visible_0, - this_5.low_0.visible_0, Stretch_turns_0(this_5) - select(0.0f, 1.0f, Stretch_wraps_0(this_5)));
}

fn integral_on_top_0( family_14 : u32,  across_2 : Stretch_0,  along_2 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S227 : u32 = u32(families_0[family_14].count_0);
    var _S228 : u32 = (_S227 + u32(1)) * families_0[family_14].quantities_0;
    var _S229 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S230 : vec4<u32> = row_differences_0(across_2, _S229 + along_2.low_0.thread_3 * _S228, _S227, families_0[family_14].quantities_0);
    var _S231 : vec4<u32> = row_differences_0(across_2, _S229 + along_2.high_0.thread_3 * _S228, _S227, families_0[family_14].quantities_0);
    var _S232 : vec4<u32> = row_differences_0(across_2, _S229 + crossing_count_0 * _S228, _S227, families_0[family_14].quantities_0);
    var _S233 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S231 - _S230 + select_vector_3(Stretch_wraps_0(along_2), _S232, vec4<u32>(vec4<i32>(i32(0)))))), _S233), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S229 + (along_2.high_0.thread_3 + u32(1)) * _S228, _S227, families_0[family_14].quantities_0) - _S231)), _S233), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S229 + (along_2.low_0.thread_3 + u32(1)) * _S228, _S227, families_0[family_14].quantities_0) - _S230)), _S233), dot(vec4<f32>(vec4<i32>(_S232)), _S233)), Stretch_weights_0(along_2)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_5 : Albedos_0,  weight_4 : f32,  row_4 : u32) -> Albedos_0
{
    var _S234 : Albedos_0 = table_albedos_0(row_4);
    var sum_0 : Albedos_0;
    var _S235 : vec3<f32> = vec3<f32>(weight_4);
    sum_0.diffuse_reflect_0 = albedos_5.diffuse_reflect_0 + _S235 * _S234.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_5.diffuse_transmit_0 + _S235 * _S234.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_5.specular_reflect_0 + _S235 * _S234.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_5.specular_transmit_0 + _S235 * _S234.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_6 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_6;
    }
    var _S236 : vec3<f32> = lengths_0(crossing_0, other_0);
    var is_exposed_0 : bool = false;
    var weight_5 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_15].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S237 : vec2<f32> = integrals_along_0(family_15, own_0, quantity_2);
        var _S238 : f32 = integral_on_top_0(family_15, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S239 : f32 = _S237.x;
        var _S240 : f32 = _S239 * _S236.x;
        var _S241 : f32 = select(_S238, _S240 - _S238, back_3);
        var _S242 : bool = quantity_2 == u32(0);
        if(_S242)
        {
            is_exposed_0 = _S241 > (16.0f * families_0[family_15].area_unit_0 * min(_S240 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S240);
        }
        var _S243 : f32 = _S239 * _S236.y + select(0.0f, _S241, is_exposed_0) + 0.000244140625f * _S236.z * _S237.y;
        if(_S242)
        {
            weight_5 = 1.0f / max(_S243, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_6 = with_added_albedos_0(albedos_6, _S243 * weight_5, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_6.diffuse_reflect_0 = saturate(albedos_6.diffuse_reflect_0);
    albedos_6.diffuse_transmit_0 = saturate(albedos_6.diffuse_transmit_0);
    albedos_6.specular_reflect_0 = saturate(albedos_6.specular_reflect_0);
    albedos_6.specular_transmit_0 = saturate(albedos_6.specular_transmit_0);
    return albedos_6;
}

fn albedos_in_0( plane_0 : Plane_0,  centre_2 : vec2<f32>,  size_5 : vec2<f32>,  back_4 : bool) -> FamilyAlbedos_0
{
    var _S244 : Stretch_0 = stretch_of_0(plane_0.warp_5, centre_2.x - plane_0.start_x_0, size_5.x);
    var _S245 : Stretch_0 = stretch_of_0(plane_0.weft_5, centre_2.y - plane_0.start_y_0, size_5.y);
    var albedos_7 : FamilyAlbedos_0;
    albedos_7.warp_3 = mean_albedos_0(plane_0.warp_5, plane_0.weft_5, _S244, _S245, back_4);
    albedos_7.weft_3 = mean_albedos_0(plane_0.weft_5, plane_0.warp_5, _S245, _S244, back_4);
    return albedos_7;
}

fn rate_terms_0( direction_3 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(7)>>)
{
    var _S246 : f32 = 1.0f - direction_3.z;
    var _S247 : f32 = _S246 * _S246;
    var _S248 : f32 = direction_3.x;
    var _S249 : f32 = _S248 * _S248;
    var _S250 : f32 = direction_3.y;
    var _S251 : f32 = _S250 * _S250;
    var _S252 : f32 = _S249 - _S251;
    var _S253 : f32 = _S249 + _S251;
    (*terms_0)[i32(1)] = _S253;
    (*terms_0)[i32(0)] = sqrt(_S253);
    (*terms_0)[i32(2)] = _S247;
    (*terms_0)[i32(3)] = _S247 * _S247;
    (*terms_0)[i32(4)] = _S252;
    (*terms_0)[i32(5)] = _S248 * _S250;
    (*terms_0)[i32(6)] = _S252 * _S252;
    return;
}

fn rate_of_view_0( first_6 : u32,  terms_1 : array<f32, i32(7)>) -> f32
{
    var _S254 : f32 = table_number_0(first_6);
    var term_0 : u32 = u32(0);
    var total_6 : f32 = _S254;
    for(;;)
    {
        if(term_0 < u32(7))
        {
        }
        else
        {
            break;
        }
        var total_7 : f32 = total_6 + table_number_0(first_6 + u32(1) + term_0) * terms_1[term_0];
        term_0 = term_0 + u32(1);
        total_6 = total_7;
    }
    return total_6;
}

fn rate_of_light_0( first_7 : u32,  terms_2 : array<f32, i32(7)>,  both_0 : f32) -> f32
{
    var _S255 : u32 = first_7 + u32(8);
    var _S256 : f32 = table_number_0(_S255 + u32(7)) * both_0;
    var term_1 : u32 = u32(0);
    var total_8 : f32 = _S256;
    for(;;)
    {
        if(term_1 < u32(7))
        {
        }
        else
        {
            break;
        }
        var total_9 : f32 = total_8 + table_number_0(_S255 + term_1) * terms_2[term_1];
        term_1 = term_1 + u32(1);
        total_8 = total_9;
    }
    return total_8;
}

fn rate_of_0( logarithm_0 : f32) -> f32
{
    return exponential_0(clamp(logarithm_0, -30.0f, 3.0f));
}

fn with_layer_0( sums_3 : Albedos_0,  albedos_8 : Albedos_0,  lit_2 : f32,  passed_2 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0;
    var _S257 : vec3<f32> = vec3<f32>(lit_2);
    result_0.diffuse_reflect_0 = sums_3.diffuse_reflect_0 + _S257 * albedos_8.diffuse_reflect_0;
    result_0.diffuse_transmit_0 = sums_3.diffuse_transmit_0 + passed_2 * albedos_8.diffuse_transmit_0;
    result_0.specular_reflect_0 = sums_3.specular_reflect_0 + _S257 * albedos_8.specular_reflect_0;
    result_0.specular_transmit_0 = sums_3.specular_transmit_0 + passed_2 * albedos_8.specular_transmit_0;
    return result_0;
}

fn with_seen_0( sums_4 : LayerSums_0,  albedos_9 : Albedos_0,  through_0 : f32,  first_8 : u32,  share_1 : f32,  alone_0 : f32,  light_1 : vec3<f32>,  view_2 : vec3<f32>) -> LayerSums_0
{
    var of_view_0 : array<f32, i32(7)>;
    rate_terms_0(view_2, &(of_view_0));
    var _S258 : f32 = light_1.x;
    var _S259 : f32 = light_1.y;
    var _S260 : f32 = light_1.z;
    var of_light_0 : array<f32, i32(7)>;
    rate_terms_0(vec3<f32>(_S258, _S259, abs(_S260)), &(of_light_0));
    var _S261 : f32 = _S258 * view_2.x + _S259 * view_2.y;
    var _S262 : bool = _S260 < 0.0f;
    var _S263 : u32 = first_8 + u32(16) * select(u32(0), u32(1), _S262);
    var _S264 : u32 = first_8 + u32(32);
    var _S265 : f32 = share_1 * alone_0;
    var _S266 : f32 = _S265 * rate_of_0(rate_of_view_0(_S263, of_view_0) + rate_of_light_0(_S263, of_light_0, _S261));
    var _S267 : f32 = _S265 * rate_of_0(rate_of_view_0(_S264, of_view_0) + rate_of_light_0(_S264, of_light_0, _S261));
    var _S268 : f32 = share_1 * rate_of_0(rate_of_view_0(first_8 + u32(48), of_view_0));
    var _S269 : u32 = first_8 + u32(64);
    var _S270 : vec3<f32> = vec3<f32>(table_number_0(_S269), table_number_0(_S269 + u32(1)), table_number_0(_S269 + u32(2)));
    var _S271 : vec3<f32> = vec3<f32>(table_number_0(_S269 + u32(3)), table_number_0(_S269 + u32(4)), table_number_0(_S269 + u32(5)));
    var _S272 : f32 = _S265 * rate_of_0(rate_of_view_0(first_8, of_view_0));
    var _S273 : f32 = _S265 * rate_of_0(rate_of_view_0(first_8 + u32(16), of_view_0));
    var _S274 : f32 = _S265 * rate_of_0(rate_of_view_0(_S264, of_view_0));
    var result_1 : LayerSums_0;
    result_1.means_2 = with_layer_0(sums_4.means_2, albedos_9, _S272, vec3<f32>(_S273) + vec3<f32>(_S274) * _S270);
    result_1.lit_0 = sums_4.lit_0 + _S272;
    result_1.passed_0 = sums_4.passed_0 + _S273 + _S274;
    result_1.albedos_2 = with_layer_0(sums_4.albedos_2, albedos_9, _S266, vec3<f32>(_S266));
    result_1.weight_2 = sums_4.weight_2 + _S266 + select(0.0f, _S267, _S262);
    var _S275 : vec3<f32> = vec3<f32>(_S268);
    result_1.behind_2.reflected_0 = sums_4.behind_2.reflected_0 + _S275 * _S271;
    result_1.behind_2.transmitted_0 = sums_4.behind_2.transmitted_0 + _S275 * _S270 * (albedos_9.diffuse_transmit_0 + vec3<f32>(through_0) * albedos_9.specular_transmit_0);
    return result_1;
}

fn divided_0( sums_5 : Albedos_0,  lit_3 : f32,  passed_3 : f32) -> Albedos_0
{
    var _S276 : f32 = 1.0f / max(passed_3, 9.99999971718068537e-10f);
    var result_2 : Albedos_0;
    var _S277 : vec3<f32> = vec3<f32>((1.0f / max(lit_3, 9.99999971718068537e-10f)));
    result_2.diffuse_reflect_0 = sums_5.diffuse_reflect_0 * _S277;
    var _S278 : vec3<f32> = vec3<f32>(_S276);
    result_2.diffuse_transmit_0 = sums_5.diffuse_transmit_0 * _S278;
    result_2.specular_reflect_0 = sums_5.specular_reflect_0 * _S277;
    result_2.specular_transmit_0 = sums_5.specular_transmit_0 * _S278;
    return result_2;
}

fn tinted_0( albedos_10 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_3 : Albedos_0 = albedos_10;
    result_3.diffuse_reflect_0 = result_3.diffuse_reflect_0 * tint_0;
    result_3.diffuse_transmit_0 = result_3.diffuse_transmit_0 * tint_0;
    return result_3;
}

struct FaceRadiance_0
{
     warp_6 : vec3<f32>,
     weft_6 : vec3<f32>,
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

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_4 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S279 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_4;
    var found_0 : FaceRadiance_0;
    var _S280 : vec3<f32> = sends_0.sky_warp_0 + _S279 * sends_0.crossing_warp_0;
    found_0.warp_6 = _S280;
    var _S281 : vec3<f32> = sends_0.sky_weft_0 + _S279 * sends_0.crossing_weft_0;
    found_0.weft_6 = _S281;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S280 + vec3<f32>(sends_0.blocks_weft_0) * _S281;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_3 : vec3<f32>,  terms_3 : ptr<function, array<f32, i32(6)>>)
{
    var _S282 : f32 = 1.0f - view_3.z;
    var _S283 : f32 = _S282 * _S282;
    (*terms_3)[i32(0)] = 1.0f;
    var _S284 : f32 = view_3.x;
    var _S285 : f32 = _S284 * _S284;
    var _S286 : f32 = view_3.y;
    var _S287 : f32 = _S286 * _S286;
    (*terms_3)[i32(1)] = sqrt(max(_S285 + _S287, 9.999999960041972e-13f));
    (*terms_3)[i32(2)] = _S283;
    (*terms_3)[i32(3)] = _S283 * _S283;
    (*terms_3)[i32(4)] = _S285 - _S287;
    (*terms_3)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_2 : vec3<f32>,
     transmitted_2 : vec3<f32>,
     is_covered_0 : bool,
};

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

struct Scattered_0
{
     back_5 : vec3<f32>,
     through_1 : vec3<f32>,
};

struct Interior_0
{
     warp_7 : vec3<f32>,
     weft_7 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S288 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S289 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_0.through_1;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_2 = yarn_0.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_7 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_7) + _S289 * interior_0.far_leaked_0;
    bounced_0.transmitted_2 = _S289 * interior_0.far_1 + yarn_0.back_5 * _S288;
    bounced_0.is_covered_0 = false;
    return bounced_0;
}

fn texel_along_0( share_2 : f32,  first_9 : u32,  extent_1 : f32,  count_2 : u32) -> u32
{
    var _S290 : f32 = min(floor(share_2 * extent_1), extent_1 - 1.0f);
    var _S291 : f32 = f32(count_2);
    var _S292 : u32 = first_9 + min(u32(max(_S290 - floor(_S290 / _S291) * _S291, 0.0f)), count_2 - u32(1));
    return select(_S292, _S292 - count_2, _S292 >= count_2);
}

fn texel_of_0( tables_6 : ptr<function, Clustered_std430_0>,  box_4 : TexelBox_0,  share_3 : vec2<f32>) -> u32
{
    return texel_along_0(share_3.y, box_4.first_2.y, box_4.extent_0.y, (*tables_6).rows_0) * (*tables_6).columns_0 + texel_along_0(share_3.x, box_4.first_2.x, box_4.extent_0.x, (*tables_6).columns_0);
}

fn uniform_hash_0( thread_4 : u32,  cell_6 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_4, stream_1), cell_6)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_4 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S293 : u32 = pixel_0.x;
    var _S294 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S293, _S294, stream_2), uniform_hash_0(_S293, _S294, stream_2 + u32(1))) + vec2<f32>(f32((index_4 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_5 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_5])));
}

struct Choice_0
{
     index_6 : u32,
     remainder_0 : f32,
};

fn choose_0( table_1 : u32,  count_3 : u32,  number_6 : f32) -> Choice_0
{
    var high_1 : u32 = count_3;
    var low_1 : u32 = u32(0);
    for(;;)
    {
        if((high_1 - low_1) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S295 : u32 = (low_1 + high_1) / u32(2);
        if((scene_number_0(table_1 + _S295)) <= number_6)
        {
            low_1 = _S295;
        }
        else
        {
            high_1 = _S295;
        }
    }
    var _S296 : u32 = table_1 + low_1;
    var _S297 : f32 = scene_number_0(_S296);
    var _S298 : f32 = scene_number_0(_S296 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_1;
    choice_0.remainder_0 = saturate((number_6 - _S297) / max(_S298 - _S297, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S299 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S300 : f32 = x_7 - _S299 * 1.5703125f - _S299 * 0.00048375129699707f - _S299 * 7.54979012640433211e-08f;
    var _S301 : f32 = _S300 * _S300;
    var _S302 : f32 = ((-0.00019515295571182f * _S301 + 0.00833216123282909f) * _S301 - 0.16666655242443085f) * _S301 * _S300 + _S300;
    var _S303 : f32 = ((0.00002443315679557f * _S301 - 0.00138873164542019f) * _S301 + 0.04166664555668831f) * _S301 * _S301 - 0.5f * _S301 + 1.0f;
    var _S304 : u32 = (u32(i32(_S299)) & (u32(3)));
    var _S305 : vec2<f32> = select_vector_1(((_S304 & (u32(1)))) != u32(0), vec2<f32>(_S303, _S302), vec2<f32>(_S302, _S303));
    var _S306 : f32 = _S305.x;
    var _S307 : f32 = _S305.y;
    return vec2<f32>(select(_S306, - _S306, ((_S304 & (u32(2)))) != u32(0)), select(_S307, - _S307, (((_S304 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_8 : f32,
     y_2 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_10 : u32) -> Light_0
{
    var record_2 : Light_0;
    record_2.is_point_0 = scene_words_0[first_10];
    record_2.x_8 = (bitcast<f32>((scene_words_0[first_10 + u32(1)])));
    record_2.y_2 = (bitcast<f32>((scene_words_0[first_10 + u32(2)])));
    record_2.z_1 = (bitcast<f32>((scene_words_0[first_10 + u32(3)])));
    record_2.red_0 = (bitcast<f32>((scene_words_0[first_10 + u32(4)])));
    record_2.green_0 = (bitcast<f32>((scene_words_0[first_10 + u32(5)])));
    record_2.blue_0 = (bitcast<f32>((scene_words_0[first_10 + u32(6)])));
    return record_2;
}

struct BaseTaps_0
{
     facing_0 : vec3<f32>,
     transmits_1 : bool,
     around_0 : BinTaps_0,
     first_11 : u32,
     half_vector_0 : BinTaps_0,
};

struct ViewedBase_0
{
     view_4 : vec3<f32>,
     back_6 : bool,
     face_6 : u32,
     box_5 : TexelBox_0,
};

fn base_taps_0( seen_0 : ViewedBase_0,  light_2 : vec3<f32>) -> BaseTaps_0
{
    var taps_1 : BaseTaps_0;
    var _S308 : vec3<f32> = to_face_frame_0(light_2, seen_0.back_6);
    taps_1.facing_0 = _S308;
    var _S309 : f32 = _S308.z;
    var _S310 : bool = _S309 < 0.0f;
    taps_1.transmits_1 = _S310;
    taps_1.around_0 = bin_taps_0(vec3<f32>(_S308.xy, abs(_S309)), u32(32));
    taps_1.first_11 = (seen_0.face_6 * u32(2) + select(u32(0), u32(1), _S310)) * u32(1024);
    var _S311 : vec3<f32> = _S308 + seen_0.view_4;
    var half_vector_1 : vec3<f32> = _S311 * vec3<f32>((1.0f / sqrt(max(square_0(_S311), 9.999999960041972e-13f))));
    taps_1.half_vector_0 = bin_taps_0(select_vector_2((half_vector_1.z) < 0.0f, (vec3<f32>(0) - half_vector_1), half_vector_1), u32(32));
    return taps_1;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_0 : f32,
};

fn no_components_0() -> Components_0
{
    var nothing_0 : Components_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_0 = 0.0f;
    return nothing_0;
}

fn clustered_cosine_0( taps_2 : BaseTaps_0,  normal_1 : vec3<f32>) -> f32
{
    var _S312 : f32 = 0.0078740157186985f * dot(normal_1, taps_2.facing_0);
    return select(_S312, - _S312, taps_2.transmits_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S313 : f32 = dot(direction_4, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S313 * _S313 + 1.0f, roughness_1 * roughness_1));
}

fn of_family_0( is_warp_0 : bool,  diffuse_0 : f32,  specular_0 : f32,  light_visibility_2 : f32) -> Components_0
{
    var result_4 : Components_0 = no_components_0();
    result_4.diffuse_warp_0 = select(0.0f, diffuse_0, is_warp_0);
    result_4.diffuse_weft_0 = select(diffuse_0, 0.0f, is_warp_0);
    result_4.specular_warp_0 = select(0.0f, specular_0, is_warp_0);
    result_4.specular_weft_0 = select(specular_0, 0.0f, is_warp_0);
    result_4.light_visibility_1 = light_visibility_2;
    return result_4;
}

fn with_added_0( sums_6 : Components_0,  more_0 : Components_0,  weight_6 : f32) -> Components_0
{
    var result_5 : Components_0;
    result_5.diffuse_warp_0 = sums_6.diffuse_warp_0 + weight_6 * more_0.diffuse_warp_0;
    result_5.diffuse_weft_0 = sums_6.diffuse_weft_0 + weight_6 * more_0.diffuse_weft_0;
    result_5.specular_warp_0 = sums_6.specular_warp_0 + weight_6 * more_0.specular_warp_0;
    result_5.specular_weft_0 = sums_6.specular_weft_0 + weight_6 * more_0.specular_weft_0;
    result_5.light_visibility_1 = sums_6.light_visibility_1 + weight_6 * more_0.light_visibility_1;
    result_5.hole_0 = sums_6.hole_0 + weight_6 * more_0.hole_0;
    return result_5;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S314 : f32 = value_1 * value_1;
    return _S314 * _S314;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_3 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S315 : f32 = light_3.z;
    return select_vector_2((_S315 * view_5.z) < 0.0f, bounced_1.transmitted_2, bounced_1.reflected_2) * vec3<f32>((abs(_S315) * 0.31830987334251404f));
}

fn sheen_scale_0( x_9 : f32,  y_3 : f32) -> f32
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_3 + 0.40672621130943298f) * y_3 + 1.65398800373077393f) * y_3 + -1.29730904102325439f) * y_3 + 0.30570998787879944f) * y_3 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_3 + 1.05947399139404297f) * y_3 + -0.41116121411323547f) * y_3 + -0.93859231472015381f) * y_3 + 0.51606941223144531f) * y_3 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_3 + -0.45962560176849365f) * y_3 + -1.63861405849456787f) * y_3 + 1.33565104007720947f) * y_3 + -0.45725581049919128f) * y_3 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_3 + -1.18879103660583496f) * y_3 + 0.28251591324806213f) * y_3 + 1.168984055519104f) * y_3 + -0.76864629983901978f) * y_3 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_3 + -0.19379159808158875f) * y_3 + 0.2677634060382843f) * y_3 + 0.00270519289188087f) * y_3 + 0.14349560439586639f) * y_3 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_3 + 0.24526430666446686f) * y_3 + 0.19551840424537659f) * y_3 + 0.07586126774549484f) * y_3 + 0.38894739747047424f) * y_3 + 0.15043120086193085f);
}

fn sheen_shear_0( x_10 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_4 + 1.99214303493499756f) * y_4 + -1.42255294322967529f) * y_4 + -1.09495604038238525f) * y_4 + 0.59180057048797607f) * y_4 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_4 + -0.29113379120826721f) * y_4 + 1.39025199413299561f) * y_4 + 0.35589990019798279f) * y_4 + -1.17120099067687988f) * y_4 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_4 + -3.64728999137878418f) * y_4 + -0.72173482179641724f) * y_4 + 3.07659196853637695f) * y_4 + -0.6827620267868042f) * y_4 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_4 + 0.36014080047607422f) * y_4 + -1.72646903991699219f) * y_4 + -0.22630110383033752f) * y_4 + 0.89514690637588501f) * y_4 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_4 + 1.10974001884460449f) * y_4 + 0.17824520170688629f) * y_4 + -1.04968702793121338f) * y_4 + 0.1461234986782074f) * y_4 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_11 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_5 + -21.38032913208007812f) * y_5 + -7.37853097915649414f) * y_5 + 34.55607986450195312f) * y_5 + -23.61347007751464844f) * y_5 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_5 + -6.08202791213989258f) * y_5 + -38.2036285400390625f) * y_5 + 53.3440399169921875f) * y_5 + -21.91996002197265625f) * y_5 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_5 + 36.803619384765625f) * y_5 + -22.94047927856445312f) * y_5 + -10.07973003387451172f) * y_5 + 15.77003955841064453f) * y_5 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_5 + 1.27310299873352051f) * y_5 + 31.19523048400878906f) * y_5 + -44.39989852905273438f) * y_5 + 26.44947052001953125f) * y_5 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_5 + -17.66820907592773438f) * y_5 + 24.65356063842773438f) * y_5 + -19.38941001892089844f) * y_5 + 11.06159019470214844f) * y_5 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_2 : f32) -> vec3<f32>
{
    var _S316 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S317 : f32 = 2.0f * sqrt(_S316) - 1.0f;
    var _S318 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_2, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S317, _S318), 0.00999999977648258f, 1.0f), clamp((1.0f - _S316) * sheen_shear_0(_S317, _S318), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S317, _S318), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_4 : vec3<f32>,  view_6 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S319 : f32 = light_4.z;
    if(((_S319 <= 0.0f) | (((view_6.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S320 : vec2<f32> = view_6.xy;
    var _S321 : f32 = dot(_S320, _S320);
    var _S322 : vec2<f32> = select_vector_1(_S321 > 9.99999968265522539e-21f, _S320 * vec2<f32>(rsqrt_0(max(_S321, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S323 : f32 = scale_0 * dot(light_4.xy, _S322) + shear_0 * _S319;
    var _S324 : f32 = scale_0 * (light_4.y * _S322.x - light_4.x * _S322.y);
    var _S325 : f32 = _S323 * _S323 + _S324 * _S324 + _S319 * _S319;
    return 0.31830987334251404f * scale_0 * scale_0 * _S319 / max(_S325 * _S325, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_5 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_3 : f32) -> vec2<f32>
{
    var _S326 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_3);
    var _S327 : f32 = strength_0 * _S326.z;
    return vec2<f32>(_S327 * transformed_cosine_0(light_5, view_7, _S326.x, _S326.y), 1.0f - _S327);
}

fn table_byte_0( table_2 : u32,  index_7 : u32) -> u32
{
    return (((words_0[table_2 + index_7 / u32(4)] >> ((u32(8) * ((index_7 & (u32(3)))))))) & (u32(255)));
}

fn gaussian_visibility_0( row_5 : u32,  towards_0 : vec3<f32>) -> f32
{
    var _S328 : f32 = dot(towards_0, vec3<f32>(table_number_0(row_5 + u32(3)), table_number_0(row_5 + u32(4)), table_number_0(row_5 + u32(5))));
    var _S329 : f32 = dot(towards_0, vec3<f32>(table_number_0(row_5 + u32(6)), table_number_0(row_5 + u32(7)), table_number_0(row_5 + u32(8))));
    return min(max(dot(towards_0, vec3<f32>(table_number_0(row_5), table_number_0(row_5 + u32(1)), table_number_0(row_5 + u32(2)))), 0.0f) * exponential_0(- (_S328 * _S328 + _S329 * _S329)), 1.0f);
}

fn accumulate_0( index_8 : u32,  light_6 : vec4<f32>)
{
    var _S330 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_6;
    layers_0[index_8].share_0 = _S330 * (1.0f - light_6.w);
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

fn uneven_shift_0( _S331 : u32,  _S332 : u32,  _S333 : u32,  _S334 : vec2<f32>) -> f32
{
    var _S335 : f32 = families_0[_S333].period_0 / families_0[_S333].count_0;
    var _S336 : u32 = hash_key_0(_S332, ((fabrics_0[_S331].seed_0) ^ (u32(625341585))));
    var _S337 : vec2<f32> = vec2<f32>(_S334.x, _S334.y / 4.0f) / vec2<f32>(_S335);
    return 0.20000000298023224f * sqrt(families_0[_S333].slub_0) * _S335 * (uneven_octave_0(_S336, _S337) * 0.66666668653488159f + uneven_octave_0(_S336 + u32(1), vec2<f32>(2.0f) * _S337 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S338 : u32,  _S339 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S338].has_detail_0) == u32(0), _S339, _S339 + vec2<f32>(uneven_shift_0(_S338, u32(0), fabrics_0[_S338].warp_0, _S339), uneven_shift_0(_S338, u32(1), fabrics_0[_S338].weft_0, _S339.yx)));
}

fn face_point_0( _S340 : u32,  _S341 : u32,  _S342 : f32,  _S343 : f32) -> VisiblePoint_0
{
    var _S344 : u32 = u32(3) * _S341;
    var _S345 : Vertex_0 = vertex_at_0(_S344);
    var _S346 : Vertex_0 = vertex_at_0(_S344 + u32(1));
    var _S347 : Vertex_0 = vertex_at_0(_S344 + u32(2));
    var _S348 : vec3<f32> = position_of_0(_S345);
    var _S349 : vec3<f32> = position_of_0(_S346) - _S348;
    var _S350 : vec3<f32> = position_of_0(_S347) - _S348;
    var _S351 : f32 = _S346.u_0 - _S345.u_0;
    var _S352 : f32 = _S346.v_0 - _S345.v_0;
    var _S353 : vec2<f32> = vec2<f32>(_S351, _S352);
    var _S354 : f32 = _S347.u_0 - _S345.u_0;
    var _S355 : f32 = _S347.v_0 - _S345.v_0;
    var _S356 : vec2<f32> = vec2<f32>(_S354, _S355);
    var _S357 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S351 * _S355 - _S352 * _S354) < 0.0f));
    var _S358 : vec3<f32> = _S357 * (vec3<f32>(_S355) * _S349 - vec3<f32>(_S352) * _S350);
    var _S359 : vec3<f32> = _S357 * (vec3<f32>(_S351) * _S350 - vec3<f32>(_S354) * _S349);
    var point_1 : VisiblePoint_0;
    var _S360 : vec3<f32> = vec3<f32>(_S342);
    var _S361 : vec3<f32> = vec3<f32>(_S343);
    var _S362 : vec3<f32> = normalize(vec3<f32>((1.0f - _S342 - _S343)) * normal_of_0(_S345) + _S360 * normal_of_0(_S346) + _S361 * normal_of_0(_S347));
    point_1.normal_0 = _S362;
    var _S363 : vec3<f32> = normalize(_S358 - _S362 * vec3<f32>(dot(_S362, _S358)));
    point_1.axis_x_0 = _S363;
    point_1.axis_y_0 = cross(_S362, _S363);
    var _S364 : vec3<f32> = normalize(cross(_S349, _S350));
    point_1.face_normal_0 = select_vector_2((dot(_S364, _S362)) < 0.0f, (vec3<f32>(0) - _S364), _S364);
    point_1.position_4 = _S348 + _S360 * _S349 + _S361 * _S350;
    point_1.view_0 = _S362;
    var _S365 : vec2<f32> = vec2<f32>(_S345.u_0, _S345.v_0) + vec2<f32>(_S342) * _S353 + vec2<f32>(_S343) * _S356;
    point_1.uv_1 = _S365;
    var _S366 : bool = (dot(cross(_S358, _S359), _S362)) < 0.0f;
    var _S367 : vec2<f32> = vec2<f32>(fabrics_0[_S340].uv_width_0, select(fabrics_0[_S340].uv_height_0, - fabrics_0[_S340].uv_height_0, _S366));
    point_1.draft_per_uv_0 = _S367;
    point_1.draft_0 = uneven_place_0(_S340, _S365 * _S367 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S340].uv_height_0, _S366)));
    var _S368 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S368;
    point_1.draft_dy_0 = _S368;
    return point_1;
}

fn visible_point_0( _S369 : u32,  _S370 : u32,  _S371 : vec2<u32>) -> VisiblePoint_0
{
    var _S372 : u32 = u32(3) * _S370;
    var _S373 : Vertex_0 = vertex_at_0(_S372);
    var _S374 : Vertex_0 = vertex_at_0(_S372 + u32(1));
    var _S375 : Vertex_0 = vertex_at_0(_S372 + u32(2));
    var _S376 : vec3<f32> = position_of_0(_S373);
    var _S377 : vec3<f32> = position_of_0(_S374) - _S376;
    var _S378 : vec3<f32> = position_of_0(_S375) - _S376;
    var _S379 : vec3<f32> = cross(_S377, _S378);
    var _S380 : f32 = f32(frame_record_0.width_0);
    var _S381 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S380));
    var _S382 : f32 = f32(frame_record_0.height_0);
    var _S383 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S382));
    var _S384 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S371.x) + 0.5f - 0.5f * _S380)) * _S381 + vec3<f32>((f32(_S371.y) + 0.5f - 0.5f * _S382)) * _S383;
    var _S385 : f32 = dot(_S384, _S379);
    var _S386 : f32 = 1.0f / select(1.00000000317107685e-30f, _S385, (abs(_S385)) > 1.00000000317107685e-30f);
    var _S387 : vec3<f32> = _S376 - camera_origin_0();
    var _S388 : vec3<f32> = vec3<f32>((dot(_S387, _S379) * _S386));
    var _S389 : vec3<f32> = _S384 * _S388 - _S387;
    var _S390 : vec3<f32> = _S388 * (_S381 - _S384 * vec3<f32>((dot(_S381, _S379) * _S386)));
    var _S391 : vec3<f32> = _S388 * (_S383 - _S384 * vec3<f32>((dot(_S383, _S379) * _S386)));
    var _S392 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S379), 1.00000000317107685e-30f)));
    var _S393 : vec3<f32> = cross(_S378, _S379) * _S392;
    var _S394 : vec3<f32> = cross(_S379, _S377) * _S392;
    var _S395 : vec2<f32> = vec2<f32>(_S374.u_0 - _S373.u_0, _S374.v_0 - _S373.v_0);
    var _S396 : vec2<f32> = vec2<f32>(_S375.u_0 - _S373.u_0, _S375.v_0 - _S373.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S369, _S370, dot(_S389, _S393), dot(_S389, _S394));
    point_2.position_4 = _S376 + _S389;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S384));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S390, _S393)) * _S395 + vec2<f32>(dot(_S390, _S394)) * _S396) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S391, _S393)) * _S395 + vec2<f32>(dot(_S391, _S394)) * _S396) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S397 : u32,  _S398 : VisiblePoint_0) -> vec3<f32>
{
    var _S399 : u32 = fabrics_0[_S397].albedo_map_levels_0;
    if((fabrics_0[_S397].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S400 : vec2<f32> = vec2<f32>(fabrics_0[_S397].uv_width_0, fabrics_0[_S397].uv_height_0);
    var _S401 : vec2<f32> = _S398.draft_dx_0 / _S400;
    var _S402 : vec2<f32> = _S398.draft_dy_0 / _S400;
    var _S403 : u32 = _S399 - u32(1);
    var _S404 : u32 = (u32(1) << (_S403));
    var _S405 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S401.x * _S402.y - _S401.y * _S402.x), 9.99999968265522539e-21f) * (square_1(f32(_S404)) / 3.0f)), 0.0f, f32(_S399) - 1.0f);
    var _S406 : u32 = min(u32(_S405), max(_S399, u32(2)) - u32(2));
    var _S407 : u32 = min(_S406 + u32(1), _S403);
    var _S408 : u32 = (u32(1) << ((u32(2) * _S399)));
    return mix(map_level_0(fabrics_0[_S397].albedo_map_0 + (_S408 - ((_S408 >> ((u32(2) * _S406))))) / u32(3), (_S404 >> (_S406)), _S398.uv_1), map_level_0(fabrics_0[_S397].albedo_map_0 + (_S408 - ((_S408 >> ((u32(2) * _S407))))) / u32(3), (_S404 >> (_S407)), _S398.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S405 - f32(_S406))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S409 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S409].planes_0) != u32(0))));
}

fn irregular_key_0( _S410 : u32,  _S411 : u32) -> u32
{
    return hash_key_0(_S411, ((fabrics_0[_S410].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S412 : u32,  _S413 : vec2<f32>,  _S414 : f32) -> vec2<f32>
{
    var _S415 : u32 = fabrics_0[_S412].warp_0;
    var _S416 : u32 = fabrics_0[_S412].weft_0;
    var _S417 : bool = (((((fabrics_0[_S412].is_irregular_0) != u32(0)) & ((!is_layered_0(_S412))))) & (((max(moved_share_0(fabrics_0[_S412].warp_0, _S414), moved_share_0(fabrics_0[_S412].weft_0, _S414))) > 0.0f)));
    var number_7 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S413;
    for(;;)
    {
        if(number_7 < select(u32(0), u32(2), _S417))
        {
        }
        else
        {
            break;
        }
        var _S418 : bool = number_7 == u32(0);
        var _S419 : u32 = select(_S416, _S415, _S418);
        var _S420 : vec2<f32> = select_vector_1(_S418, _S413, _S413.yx);
        var _S421 : u32 = irregular_key_0(_S412, number_7);
        var _S422 : f32 = _S420.x;
        var _S423 : Cell_0 = locate_0(_S419, _S422);
        var _S424 : f32 = irregular_thread_0(_S419, _S422, _S423);
        var _S425 : f32 = select(1.0f, -1.0f, (_S423.across_0) < 0.0f);
        var _S426 : vec2<f32> = vec2<f32>(0.0f);
        var other_1 : vec2<f32> = _S426;
        var own_1 : vec2<f32> = _S426;
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
            var _S427 : vec2<f32> = irregular_at_0(_S419, _S421, _S424 + _S425 * f32(neighbour_0), _S420.y).xy;
            var _S428 : u32 = neighbour_0 + u32(1);
            own_1 = other_1;
            other_1 = _S427;
            neighbour_0 = _S428;
        }
        var _S429 : f32 = _S423.below_0 + _S423.above_0;
        var _S430 : f32 = min(_S423.half_width_1 / _S429, 0.5f);
        var _S431 : f32 = min(_S430 * (2.0f + own_1.y + other_1.y), 1.0f);
        var _S432 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_1.x), vec2<f32>(0.25f)));
        var _S433 : f32 = _S432.x;
        var _S434 : f32 = _S431 * _S433 / (_S433 + _S432.y);
        var _S435 : f32 = abs(_S423.across_0) / _S429;
        var _S436 : f32 = 1.0f - _S431;
        var _S437 : f32 = _S435 - _S434;
        var _S438 : f32 = moved_share_0(_S419, _S414) * _S425 * _S429 * (select(select((_S437 - _S436) / max(_S431 - _S434, 9.99999997475242708e-07f) * _S430 + (1.0f - _S430), _S437 / max(_S436, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S430) + _S430, _S437 < _S436), _S435 * _S430 / _S434, _S437 < 0.0f) - _S435);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S418, vec2<f32>(_S438, 0.0f), vec2<f32>(0.0f, _S438));
        number_7 = number_7 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct ClusteredView_0
{
     base_0 : ViewedBase_0,
     yarns_0 : Yarns_0,
     even_hole_0 : f32,
     hole_1 : f32,
     albedos_11 : FamilyAlbedos_0,
     bounced_2 : Bounced_0,
     view_8 : vec3<f32>,
};

fn viewed_base_0( _S439 : u32,  _S440 : Footprint_0,  _S441 : vec3<f32>,  _S442 : f32) -> ViewedBase_0
{
    var seen_1 : ViewedBase_0;
    var _S443 : bool = (_S441.z) < 0.0f;
    seen_1.back_6 = _S443;
    var _S444 : vec3<f32> = to_face_frame_0(_S441, _S443);
    seen_1.view_4 = _S444;
    var _S445 : u32 = select(u32(0), u32(1), _S443);
    seen_1.face_6 = _S445;
    var _S446 : Clustered_std430_0 = fabrics_0[_S439].clustered_0;
    var _S447 : f32 = _S442 - 0.5f;
    var _S448 : TexelBox_0 = texel_box_0(&(_S446), _S440, vec2<f32>(0.0f), _S447);
    var _S449 : vec2<f32> = parallax_offset_0(&(_S446), _S448, _S445, _S444);
    var _S450 : TexelBox_0 = texel_box_0(&(_S446), _S440, _S449, _S447);
    seen_1.box_5 = _S450;
    return seen_1;
}

fn texel_hole_0( _S451 : u32,  _S452 : ViewedBase_0) -> f32
{
    var cluster_0 : u32 = u32(0);
    var covered_0 : f32 = 0.0f;
    for(;;)
    {
        var _S453 : Clustered_std430_0 = fabrics_0[_S451].clustered_0;
        if(cluster_0 < (_S453.clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S454 : f32 = box_mean_0(&(_S453), _S452.box_5, _S452.face_6, cluster_0);
        var covered_1 : f32 = covered_0 + _S454;
        cluster_0 = cluster_0 + u32(1);
        covered_0 = covered_1;
    }
    return clamp(1.0f - covered_0, 0.0f, 1.0f);
}

fn yarns_over_0( _S455 : u32,  _S456 : Footprint_0,  _S457 : bool) -> Yarns_0
{
    var _S458 : vec2<f32> = _S456.dx_0;
    var _S459 : vec2<f32> = _S456.dy_0;
    var _S460 : vec2<f32> = sqrt(_S458 * _S458 + _S459 * _S459);
    var _S461 : f32 = Footprint_spread_side_0(_S456);
    var _S462 : vec4<f32> = vec4<f32>(0.0f);
    var yarns_1 : Yarns_0 = Yarns_x24init_0(_S462, _S462, vec3<f32>(0.0f));
    var _S463 : bool = (fabrics_0[_S455].is_irregular_0) != u32(0);
    var number_8 : u32 = u32(0);
    for(;;)
    {
        if(number_8 < select(u32(0), u32(2), _S463))
        {
        }
        else
        {
            break;
        }
        var _S464 : bool = number_8 == u32(0);
        var _S465 : u32 = select(fabrics_0[_S455].weft_0, fabrics_0[_S455].warp_0, _S464);
        var _S466 : vec2<f32> = select_vector_1(_S464, _S456.centre_0, _S456.centre_0.yx);
        var _S467 : vec2<f32> = select_vector_1(_S464, _S460, _S460.yx);
        var _S468 : f32 = _S466.x;
        var _S469 : Cell_0 = locate_0(_S465, _S468);
        var yarn_1 : vec4<f32> = irregular_over_0(_S465, irregular_key_0(_S455, number_8), irregular_thread_0(_S465, _S468, _S469) + _S469.below_0 / (_S469.below_0 + _S469.above_0), _S467.x * (families_0[_S465].count_0 / families_0[_S465].period_0), _S466.y, _S467.y);
        yarn_1[i32(1)] = yarn_1[i32(1)] * (1.0f - moved_share_0(_S465, _S461));
        yarns_1.warp_1 = yarns_1.weft_1;
        yarns_1.weft_1 = yarn_1;
        number_8 = number_8 + u32(1);
    }
    var _S470 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S455].warp_0].cover_0, families_0[fabrics_0[_S455].weft_0].cover_0);
    var _S471 : f32 = select(fabrics_0[_S455].warp_on_top_0, 1.0f - fabrics_0[_S455].warp_on_top_0, _S457);
    var _S472 : vec3<f32> = shown_of_covers_0(_S470, _S471);
    var _S473 : vec3<f32> = select_vector_2(_S463, shown_of_covers_0(saturate(_S470 + _S470 * vec2<f32>(yarns_1.warp_1.y, yarns_1.weft_1.y)), _S471) / max(_S472, vec3<f32>(0.00009999999747379f)), vec3<f32>(1.0f));
    yarns_1.shares_0 = _S473;
    yarns_1.shares_0[i32(2)] = select(1.0f, _S473.z, (_S472.z) > 0.00009999999747379f);
    return yarns_1;
}

fn plane_count_0( _S474 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S474].planes_0, is_layered_0(_S474));
}

fn whole_plane_0( _S475 : u32) -> Plane_0
{
    var plane_1 : Plane_0;
    plane_1.warp_5 = fabrics_0[_S475].warp_0;
    plane_1.weft_5 = fabrics_0[_S475].weft_0;
    plane_1.run_words_1 = fabrics_0[_S475].run_words_0;
    plane_1.ends_2 = fabrics_0[_S475].ends_1;
    plane_1.end_numbers_0 = u32(0);
    plane_1.pick_numbers_0 = u32(0);
    plane_1.max_heights_1 = fabrics_0[_S475].max_heights_0;
    plane_1.max_height_columns_1 = fabrics_0[_S475].max_height_columns_0;
    plane_1.height_low_1 = fabrics_0[_S475].height_low_0;
    plane_1.height_high_1 = fabrics_0[_S475].height_high_0;
    plane_1.front_level_0 = 0.0f;
    plane_1.back_level_0 = 0.0f;
    plane_1.start_x_0 = 0.0f;
    plane_1.start_y_0 = 0.0f;
    plane_1.fine_x_0 = 0.0f;
    plane_1.fine_y_0 = 0.0f;
    return plane_1;
}

fn plane_of_0( _S476 : u32,  _S477 : u32) -> Plane_0
{
    if(!is_layered_0(_S476))
    {
        return whole_plane_0(_S476);
    }
    return plane_at_0(fabrics_0[_S476].plane_records_0 + _S477 * u32(16));
}

fn stack_share_0( _S478 : u32,  _S479 : vec2<f32>,  _S480 : vec2<f32>,  _S481 : u32) -> f32
{
    if((fabrics_0[_S478].stacks_0) == u32(1))
    {
        return 1.0f;
    }
    var _S482 : u32 = fabrics_0[_S478].plane_axes_0 + u32(1);
    var _S483 : Stretch_0 = stretch_of_0(fabrics_0[_S478].plane_axes_0, _S479.x, _S480.x);
    var _S484 : Stretch_0 = stretch_of_0(_S482, _S479.y, _S480.y);
    return clamp(integral_on_top_0(fabrics_0[_S478].plane_axes_0, _S483, _S484, u32(families_0[_S482].count_0), _S481) / (lengths_0(fabrics_0[_S478].plane_axes_0, _S483).x * lengths_0(_S482, _S484).x), 0.0f, 1.0f);
}

fn layered_albedos_0( _S485 : u32,  _S486 : Footprint_0,  _S487 : NearestLayer_0,  _S488 : bool,  _S489 : vec3<f32>,  _S490 : vec3<f32>) -> LayeredAlbedos_0
{
    var _S491 : vec2<f32> = _S486.dx_0;
    var _S492 : vec2<f32> = _S486.dy_0;
    var _S493 : vec2<f32> = sqrt(_S491 * _S491 + _S492 * _S492);
    var _S494 : vec3<f32> = vec3<f32>(0.0f);
    var _S495 : Albedos_0 = Albedos_x24init_0(_S494, _S494, _S494, _S494);
    var _S496 : FamilyAlbedos_0 = FamilyAlbedos_x24init_0(_S495, _S495);
    var _S497 : LayersBehind_0 = LayersBehind_x24init_0(_S494, _S494);
    var found_1 : LayeredAlbedos_0 = LayeredAlbedos_x24init_0(_S496, _S496, _S497);
    var _S498 : LayerSums_0 = LayerSums_x24init_0(_S495, _S495, 0.0f, 0.0f, 0.0f, _S497);
    var warp_8 : LayerSums_0 = _S498;
    var weft_8 : LayerSums_0 = _S498;
    var number_9 : u32 = u32(0);
    for(;;)
    {
        if(number_9 < (plane_count_0(_S485)))
        {
        }
        else
        {
            break;
        }
        var _S499 : FamilyAlbedos_0 = albedos_in_0(plane_of_0(_S485, number_9), _S486.centre_0, _S493, _S488);
        if(!is_layered_0(_S485))
        {
            found_1.albedos_0 = _S499;
            found_1.means_0 = _S499;
            return found_1;
        }
        var _S500 : f32 = select(1.0f - _S487.weight_0, 1.0f, number_9 == (_S487.number_4));
        var stack_0 : u32 = u32(0);
        for(;;)
        {
            if(stack_0 < (fabrics_0[_S485].stacks_0))
            {
            }
            else
            {
                break;
            }
            var _S501 : f32 = stack_share_0(_S485, _S486.centre_0, _S493, stack_0);
            var _S502 : u32 = fabrics_0[_S485].plane_shares_0 + u32(144) * (u32(2) * (stack_0 * fabrics_0[_S485].planes_0 + number_9) + select(u32(0), u32(1), _S488));
            var _S503 : LayerSums_0 = with_seen_0(warp_8, _S499.warp_3, families_0[fabrics_0[_S485].warp_0].layer_through_0, _S502, _S501, _S500, _S489, _S490);
            var _S504 : LayerSums_0 = with_seen_0(weft_8, _S499.weft_3, families_0[fabrics_0[_S485].weft_0].layer_through_0, _S502 + u32(72), _S501, _S500, _S489, _S490);
            var _S505 : u32 = stack_0 + u32(1);
            warp_8 = _S503;
            weft_8 = _S504;
            stack_0 = _S505;
        }
        number_9 = number_9 + u32(1);
    }
    var _S506 : f32 = warp_8.weight_2;
    found_1.albedos_0.warp_3 = divided_0(warp_8.albedos_2, _S506, _S506);
    var _S507 : f32 = weft_8.weight_2;
    found_1.albedos_0.weft_3 = divided_0(weft_8.albedos_2, _S507, _S507);
    found_1.means_0.warp_3 = divided_0(warp_8.means_2, warp_8.lit_0, warp_8.passed_0);
    found_1.means_0.weft_3 = divided_0(weft_8.means_2, weft_8.lit_0, weft_8.passed_0);
    found_1.behind_0.reflected_0 = warp_8.behind_2.reflected_0 + weft_8.behind_2.reflected_0;
    found_1.behind_0.transmitted_0 = warp_8.behind_2.transmitted_0 + weft_8.behind_2.transmitted_0;
    return found_1;
}

fn albedos_over_0( _S508 : u32,  _S509 : Footprint_0,  _S510 : bool) -> FamilyAlbedos_0
{
    const _S511 : vec3<f32> = vec3<f32>(0.0f, 0.0f, 1.0f);
    return layered_albedos_0(_S508, _S509, NearestLayer_x24init_0(u32(0), 0.0f), _S510, _S511, _S511).means_0;
}

fn toned_0( _S512 : u32,  _S513 : u32,  _S514 : Albedos_0,  _S515 : vec4<f32>) -> Albedos_0
{
    var _S516 : vec3<f32> = _S514.diffuse_reflect_0 + _S514.diffuse_transmit_0;
    var _S517 : vec3<f32> = vec3<f32>(1.0f);
    var _S518 : vec3<f32> = _S517 - vec3<f32>(fabrics_0[_S512].layer_bound_0) * max(_S514.specular_reflect_0, _S514.specular_transmit_0);
    var _S519 : vec3<f32> = vec3<f32>(0.0f);
    var _S520 : vec3<f32> = max(_S517 - _S516, _S519) / (_S517 + _S516);
    var _S521 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S522 : vec3<f32> = (_S518 / max(_S516, _S521) - _S517) / max(vec3<f32>(0.89999997615814209f) * _S520, _S521);
    var _S523 : vec3<f32> = _S517 - vec3<f32>((saturate(min(min(_S522.x, _S522.y), _S522.z)) * _S515.z)) * _S520;
    var _S524 : vec3<f32> = min(vec3<f32>(families_0[_S513].nep_red_0, families_0[_S513].nep_green_0, families_0[_S513].nep_blue_0), _S518);
    var found_2 : Albedos_0 = _S514;
    var _S525 : f32 = _S515.w;
    var _S526 : vec3<f32> = _S523 * _S514.diffuse_transmit_0 * vec3<f32>((1.0f - _S525));
    found_2.diffuse_transmit_0 = _S526;
    found_2.diffuse_reflect_0 = clamp(mix(_S523 * _S514.diffuse_reflect_0, _S524, vec3<f32>(_S525)), _S519, max(_S518 - _S526, _S519));
    return found_2;
}

fn with_tones_0( _S527 : u32,  _S528 : FamilyAlbedos_0,  _S529 : Yarns_0) -> FamilyAlbedos_0
{
    if((fabrics_0[_S527].is_irregular_0) == u32(0))
    {
        return _S528;
    }
    var result_6 : FamilyAlbedos_0;
    result_6.warp_3 = toned_0(_S527, fabrics_0[_S527].warp_0, _S528.warp_3, _S529.warp_1);
    result_6.weft_3 = toned_0(_S527, fabrics_0[_S527].weft_0, _S528.weft_3, _S529.weft_1);
    return result_6;
}

fn openness_number_0( _S530 : u32,  _S531 : u32) -> f32
{
    return table_number_0(fabrics_0[_S530].openness_0 + _S531);
}

fn scattered_by_0( _S532 : u32,  _S533 : Albedos_0,  _S534 : u32,  _S535 : vec3<f32>) -> Scattered_0
{
    var _S536 : u32 = u32(159) + u32(2) * _S534;
    var yarn_2 : Scattered_0;
    yarn_2.back_5 = _S535 * _S533.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S532, _S536)) * _S533.specular_reflect_0;
    yarn_2.through_1 = _S535 * _S533.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S532, _S536 + u32(1))) * _S533.specular_transmit_0;
    return yarn_2;
}

fn sent_0( _S537 : u32,  _S538 : u32,  _S539 : vec3<f32>,  _S540 : vec3<f32>,  _S541 : vec3<f32>,  _S542 : vec3<f32>,  _S543 : ptr<function, vec3<f32>>,  _S544 : ptr<function, vec3<f32>>)
{
    var _S545 : u32 = u32(146) + u32(4) * _S538;
    var _S546 : f32 = openness_number_0(_S537, _S545 + u32(1));
    var _S547 : f32 = openness_number_0(_S537, _S545 + u32(2));
    var _S548 : vec3<f32> = vec3<f32>(1.0f);
    var _S549 : vec3<f32> = _S548 - _S541 * vec3<f32>(openness_number_0(_S537, _S545));
    var _S550 : vec3<f32> = _S548 - _S542 * vec3<f32>(openness_number_0(_S537, _S545 + u32(3)));
    var _S551 : vec3<f32> = _S548 / (_S549 * _S550 - _S541 * _S542 * vec3<f32>((_S546 * _S547)));
    (*_S543) = (_S539 * _S550 + _S541 * vec3<f32>(_S546) * _S540) * _S551;
    (*_S544) = (_S540 * _S549 + _S542 * vec3<f32>(_S547) * _S539) * _S551;
    return;
}

fn face_sends_0( _S552 : u32,  _S553 : u32,  _S554 : Scattered_0,  _S555 : Scattered_0) -> FaceSends_0
{
    var _S556 : u32 = u32(2) * _S553;
    var _S557 : u32 = u32(142) + _S556;
    var _S558 : f32 = openness_number_0(_S552, _S557);
    var _S559 : f32 = openness_number_0(_S552, _S557 + u32(1));
    var _S560 : vec3<f32> = vec3<f32>((1.0f - _S558)) * _S554.back_5;
    var _S561 : vec3<f32> = vec3<f32>((1.0f - _S559)) * _S555.back_5;
    var sends_1 : FaceSends_0;
    var _S562 : u32 = u32(154) + _S556;
    var _S563 : f32 = openness_number_0(_S552, _S562);
    sends_1.blocks_warp_0 = _S563;
    var _S564 : f32 = openness_number_0(_S552, _S562 + u32(1));
    sends_1.blocks_weft_0 = _S564;
    sends_1.open_0 = _S563 * _S558 + _S564 * _S559;
    var _S565 : vec3<f32> = vec3<f32>(_S558) * _S554.back_5;
    var _S566 : vec3<f32> = vec3<f32>(_S559) * _S555.back_5;
    var _S567 : vec3<f32> = sends_1.sky_warp_0;
    var _S568 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S552, _S553, _S565, _S566, _S560, _S561, &(_S567), &(_S568));
    sends_1.sky_warp_0 = _S567;
    sends_1.sky_weft_0 = _S568;
    var _S569 : vec3<f32> = sends_1.crossing_warp_0;
    var _S570 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S552, _S553, _S554.through_1, _S555.through_1, _S560, _S561, &(_S569), &(_S570));
    sends_1.crossing_warp_0 = _S569;
    sends_1.crossing_weft_0 = _S570;
    return sends_1;
}

fn interior_between_0( _S571 : u32,  _S572 : u32,  _S573 : u32,  _S574 : vec3<f32>,  _S575 : bool) -> Interior_0
{
    var _S576 : Scattered_0 = scattered_by_0(_S571, table_albedos_0(_S572), u32(0), _S574);
    var _S577 : Scattered_0 = scattered_by_0(_S571, table_albedos_0(_S573), u32(1), _S574);
    var _S578 : FaceSends_0 = face_sends_0(_S571, select(u32(0), u32(1), _S575), _S576, _S577);
    var _S579 : FaceSends_0 = face_sends_0(_S571, select(u32(1), u32(0), _S575), _S576, _S577);
    var _S580 : vec3<f32> = vec3<f32>(_S578.blocks_warp_0);
    var _S581 : vec3<f32> = vec3<f32>(_S578.blocks_weft_0);
    var _S582 : vec3<f32> = _S580 * _S578.crossing_warp_0 + _S581 * _S578.crossing_weft_0;
    var _S583 : vec3<f32> = vec3<f32>(_S579.blocks_warp_0);
    var _S584 : vec3<f32> = vec3<f32>(_S579.blocks_weft_0);
    var _S585 : vec3<f32> = _S583 * _S579.crossing_warp_0 + _S584 * _S579.crossing_weft_0;
    var _S586 : f32 = 1.0f - _S578.open_0;
    var _S587 : f32 = 1.0f - _S579.open_0;
    var _S588 : vec3<f32> = vec3<f32>(1.0f);
    var _S589 : vec3<f32> = _S588 / (_S588 - _S582 * _S585 * vec3<f32>((_S586 * _S587)));
    var _S590 : vec3<f32> = _S585 * (vec3<f32>(_S578.open_0) + vec3<f32>(_S586) * (_S580 * _S578.sky_warp_0 + _S581 * _S578.sky_weft_0)) * _S589;
    var _S591 : vec3<f32> = _S582 * (vec3<f32>(_S579.open_0) + vec3<f32>(_S587) * (_S583 * _S579.sky_warp_0 + _S584 * _S579.sky_weft_0)) * _S589;
    var _S592 : FaceRadiance_0 = face_radiance_0(_S578, _S579.open_0, _S590, _S591);
    var _S593 : FaceRadiance_0 = face_radiance_0(_S579, _S578.open_0, _S591, _S590);
    var interior_1 : Interior_0;
    interior_1.warp_7 = _S592.warp_6;
    interior_1.weft_7 = _S592.weft_6;
    interior_1.leaked_1 = _S592.leaked_0;
    interior_1.far_1 = _S593.mean_0;
    interior_1.far_leaked_0 = _S593.leaked_0;
    return interior_1;
}

fn interior_of_0( _S594 : u32,  _S595 : vec3<f32>,  _S596 : bool) -> Interior_0
{
    return interior_between_0(_S594, families_0[fabrics_0[_S594].warp_0].cloth_mean_0, families_0[fabrics_0[_S594].weft_0].cloth_mean_0, _S595, _S596);
}

fn blocked_of_terms_0( _S597 : u32,  _S598 : u32,  _S599 : array<f32, i32(6)>,  _S600 : u32) -> Blocked_0
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
            if(term_2 < _S600)
            {
            }
            else
            {
                break;
            }
            shares_2[share_4] = shares_2[share_4] + openness_number_0(_S597, _S598 + share_4 * _S600 + term_2) * _S599[term_2];
            term_2 = term_2 + u32(1);
        }
        shares_2[share_4] = saturate(shares_2[share_4]);
        share_4 = share_4 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_2[i32(0)] * shares_2[i32(2)];
    blocked_1.by_weft_0 = shares_2[i32(0)] * (1.0f - shares_2[i32(2)]);
    blocked_1.far_0 = shares_2[i32(1)];
    return blocked_1;
}

fn blocked_from_0( _S601 : u32,  _S602 : vec3<f32>,  _S603 : bool,  _S604 : bool) -> Blocked_0
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_0(_S602, &(terms_4));
    return blocked_of_terms_0(_S601, (select(u32(0), u32(2), _S604) + select(u32(1), u32(0), _S603)) * u32(15), terms_4, u32(5));
}

fn family_share_0( _S605 : u32,  _S606 : u32,  _S607 : f32) -> vec2<f32>
{
    var _S608 : bool = _S606 < (fabrics_0[_S605].clustered_0.clusters_0 / u32(2));
    return vec2<f32>(select(0.0f, _S607, _S608), select(_S607, 0.0f, _S608));
}

fn clustered_shown_0( _S609 : u32,  _S610 : ViewedBase_0) -> vec2<f32>
{
    var _S611 : Clustered_std430_0 = fabrics_0[_S609].clustered_0;
    var _S612 : u32 = _S611.clusters_0;
    var _S613 : vec2<f32> = vec2<f32>(0.0f);
    var cluster_1 : u32 = u32(0);
    var shown_0 : vec2<f32> = _S613;
    for(;;)
    {
        if(cluster_1 < _S612)
        {
        }
        else
        {
            break;
        }
        var _S614 : f32 = box_mean_0(&(_S611), _S610.box_5, _S610.face_6, cluster_1);
        var shown_1 : vec2<f32> = shown_0 + family_share_0(_S609, cluster_1, _S614);
        cluster_1 = cluster_1 + u32(1);
        shown_0 = shown_1;
    }
    return shown_0;
}

fn clustered_view_0( _S615 : u32,  _S616 : Footprint_0,  _S617 : vec3<f32>,  _S618 : vec3<f32>,  _S619 : u32) -> ClusteredView_0
{
    var seen_2 : ClusteredView_0;
    var _S620 : ViewedBase_0 = viewed_base_0(_S615, _S616, _S617, uniform_of_0(_S619, u32(0)));
    seen_2.base_0 = _S620;
    seen_2.view_8 = _S617;
    var _S621 : f32 = texel_hole_0(_S615, _S620);
    seen_2.even_hole_0 = _S621;
    var _S622 : Yarns_0 = yarns_over_0(_S615, _S616, seen_2.base_0.back_6);
    seen_2.yarns_0 = _S622;
    seen_2.hole_1 = min(_S621 * seen_2.yarns_0.shares_0.z, 1.0f);
    var _S623 : FamilyAlbedos_0 = with_tones_0(_S615, albedos_over_0(_S615, _S616, seen_2.base_0.back_6), _S622);
    seen_2.albedos_11.warp_3 = tinted_0(_S623.warp_3, _S618);
    seen_2.albedos_11.weft_3 = tinted_0(_S623.weft_3, _S618);
    var _S624 : vec3<f32> = vec3<f32>(0.0f);
    seen_2.bounced_2.reflected_2 = _S624;
    seen_2.bounced_2.transmitted_2 = _S624;
    if((fabrics_0[_S615].openness_0) == u32(4294967295))
    {
        return seen_2;
    }
    var _S625 : Interior_0 = interior_of_0(_S615, _S618, seen_2.base_0.back_6);
    var _S626 : Bounced_0 = bounced_by_0(blocked_from_0(_S615, seen_2.base_0.view_4, true, seen_2.base_0.back_6), scattered_by_0(_S615, _S623.warp_3, u32(0), _S618), _S625);
    var _S627 : Bounced_0 = bounced_by_0(blocked_from_0(_S615, seen_2.base_0.view_4, false, seen_2.base_0.back_6), scattered_by_0(_S615, _S623.weft_3, u32(1), _S618), _S625);
    var _S628 : vec2<f32> = clustered_shown_0(_S615, seen_2.base_0) * seen_2.yarns_0.shares_0.xy;
    var _S629 : vec3<f32> = vec3<f32>(_S628.x);
    var _S630 : vec3<f32> = vec3<f32>(_S628.y);
    seen_2.bounced_2.reflected_2 = _S629 * _S626.reflected_2 + _S630 * _S627.reflected_2;
    seen_2.bounced_2.transmitted_2 = _S629 * _S626.transmitted_2 + _S630 * _S627.transmitted_2;
    return seen_2;
}

fn residual_texel_0( _S631 : u32,  _S632 : ClusteredView_0,  _S633 : u32,  _S634 : u32) -> u32
{
    var _S635 : u32 = _S633 + _S634 * u32(1663821227);
    var _S636 : Clustered_std430_0 = fabrics_0[_S631].clustered_0;
    var _S637 : u32 = texel_of_0(&(_S636), _S632.base_0.box_5, vec2<f32>(uniform_of_0(_S635, u32(1)), uniform_of_0(_S635, u32(2))));
    return _S637;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S638 : u32,  _S639 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S638 * frame_record_0.height_0 + _S639.y) * frame_record_0.width_0 + _S639.x];
}

struct LightSample_0
{
     towards_1 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_0 : f32,
};

fn environment_texel_0( _S640 : u32,  _S641 : u32) -> vec3<f32>
{
    var _S642 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S640 * frame_record_0.environment_columns_0 + _S641);
    return vec3<f32>(scene_number_0(_S642), scene_number_0(_S642 + u32(1)), scene_number_0(_S642 + u32(2)));
}

fn sample_environment_0( _S643 : vec2<f32>,  _S644 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S645 : u32 = frame_record_0.environment_rows_0;
    var _S646 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S643.y);
    var _S647 : u32 = frame_record_0.environment_columns_0;
    var _S648 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S646.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S643.x);
    var _S649 : vec3<f32> = environment_texel_0(_S646.index_6, _S648.index_6);
    (*_S644) = _S649 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S649), 9.99999968265522539e-21f)));
    var _S650 : f32 = 3.14159274101257324f / f32(_S645);
    var _S651 : f32 = mix(sine_cosine_0(f32(_S646.index_6) * _S650).y, sine_cosine_0(f32(_S646.index_6 + u32(1)) * _S650).y, _S646.remainder_0);
    var _S652 : f32 = sqrt(max(1.0f - _S651 * _S651, 0.0f));
    var _S653 : vec2<f32> = sine_cosine_0((f32(_S648.index_6) + _S648.remainder_0) * (6.28318548202514648f / f32(_S647)));
    var _S654 : f32 = _S652 * _S653.x;
    var _S655 : f32 = - _S652 * _S653.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S654 + frame_record_0.environment_sine_0 * _S655, _S651, frame_record_0.environment_cosine_0 * _S655 - frame_record_0.environment_sine_0 * _S654);
}

fn light_sample_0( _S656 : u32,  _S657 : vec2<u32>,  _S658 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    var _S659 : u32 = frame_record_0.lights_0;
    if(_S656 >= (frame_record_0.lights_0))
    {
        var weight_7 : vec3<f32>;
        var _S660 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S657, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S656 - _S659), u32(3)), &(weight_7));
        sample_0.towards_1 = _S660;
        sample_0.irradiance_1 = weight_7 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S661 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S656);
    sample_0.irradiance_1 = vec3<f32>(_S661.red_0, _S661.green_0, _S661.blue_0);
    sample_0.towards_1 = vec3<f32>(_S661.x_8, _S661.y_2, _S661.z_1);
    if((_S661.is_point_0) != u32(0))
    {
        var _S662 : vec3<f32> = sample_0.towards_1 - _S658;
        var _S663 : f32 = max(square_0(_S662), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S663);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S663);
        sample_0.towards_1 = normalize(_S662);
    }
    return sample_0;
}

fn cluster_density_0( _S664 : u32,  _S665 : ViewedBase_0,  _S666 : BaseTaps_0,  _S667 : u32,  _S668 : u32) -> f32
{
    return BinTaps_read_0(_S666.half_vector_0, fabrics_0[_S664].clustered_0.basis_0, _S665.face_6 * u32(1024), fabrics_0[_S664].clustered_0.clusters_0 * (u32(1) + fabrics_0[_S664].clustered_0.rank_0), _S668 * fabrics_0[_S664].clustered_0.clusters_0 + _S667);
}

fn cluster_visibility_0( _S669 : u32,  _S670 : BaseTaps_0,  _S671 : u32) -> f32
{
    return BinTaps_read_0(_S670.around_0, fabrics_0[_S669].clustered_0.light_0, _S670.first_11, fabrics_0[_S669].clustered_0.clusters_0, _S671);
}

fn clustered_diffuse_0( _S672 : u32,  _S673 : BaseTaps_0,  _S674 : f32,  _S675 : vec3<f32>) -> f32
{
    return 0.31830987334251404f * ((1.0f - fabrics_0[_S672].diffuse_blend_0) * abs(_S673.facing_0.z) * _S674 + fabrics_0[_S672].diffuse_blend_0 * clustered_cosine_0(_S673, _S675));
}

fn cluster_attenuation_0( _S676 : u32,  _S677 : ViewedBase_0,  _S678 : BaseTaps_0,  _S679 : u32) -> f32
{
    var _S680 : u32 = fabrics_0[_S676].clustered_0.moments_1 + (_S677.face_6 * fabrics_0[_S676].clustered_0.clusters_0 + _S679) * u32(8);
    var _S681 : vec3<f32> = vec3<f32>(table_number_0(_S680), table_number_0(_S680 + u32(1)), table_number_0(_S680 + u32(2)));
    var _S682 : vec3<f32> = vec3<f32>(table_number_0(_S680 + u32(3)), table_number_0(_S680 + u32(4)), table_number_0(_S680 + u32(5)));
    var _S683 : f32 = table_number_0(_S680 + u32(7));
    var _S684 : f32 = fabrics_0[_S676].optical_depth_0;
    var _S685 : f32 = dot(_S678.facing_0, _S681);
    var _S686 : f32 = max(dot(_S677.view_4, _S681), 0.10000000149011612f);
    var _S687 : f32 = projected_area_1(_S678.facing_0, _S682, _S683) / max(select(_S685, - _S685, _S678.transmits_1), 0.10000000149011612f);
    var _S688 : f32 = projected_area_1(_S677.view_4, _S682, _S683) / _S686;
    if(!_S678.transmits_1)
    {
        var _S689 : f32 = _S687 + _S688;
        return 0.25f * (1.0f - exponential_0(- _S684 * _S689)) / (_S689 * _S686);
    }
    var _S690 : f32 = max(_S684 * abs(_S687 - _S688), 0.00100000004749745f);
    return 0.25f * _S684 * exponential_0(- _S684 * min(_S687, _S688)) * (1.0f - exponential_0(- _S690)) / (_S690 * _S686);
}

fn clustered_base_0( _S691 : u32,  _S692 : ViewedBase_0,  _S693 : BaseTaps_0) -> Components_0
{
    var _S694 : Clustered_std430_0 = fabrics_0[_S691].clustered_0;
    var _S695 : u32 = _S694.clusters_0;
    var _S696 : u32 = _S694.rank_0;
    var base_1 : Components_0 = no_components_0();
    var cluster_2 : u32 = u32(0);
    for(;;)
    {
        if(cluster_2 < _S695)
        {
        }
        else
        {
            break;
        }
        var _S697 : f32 = box_mean_1(&(_S694), _S692.box_5, _S692.face_6, cluster_2);
        if(_S697 <= 0.0f)
        {
            cluster_2 = cluster_2 + u32(1);
            continue;
        }
        var _S698 : f32 = _S697 * cluster_density_0(_S691, _S692, _S693, cluster_2, u32(0));
        var number_10 : u32 = u32(1);
        var density_0 : f32 = _S698;
        for(;;)
        {
            if(number_10 <= _S696)
            {
            }
            else
            {
                break;
            }
            var _S699 : f32 = box_mean_1(&(_S694), _S692.box_5, _S692.face_6, number_10 * _S695 + cluster_2);
            var density_1 : f32 = density_0 + _S699 * cluster_density_0(_S691, _S692, _S693, cluster_2, number_10);
            number_10 = number_10 + u32(1);
            density_0 = density_1;
        }
        var _S700 : f32 = box_mean_1(&(_S694), _S692.box_5, _S692.face_6, (_S696 + u32(1)) * _S695 + cluster_2);
        var _S701 : f32 = box_mean_1(&(_S694), _S692.box_5, _S692.face_6, (_S696 + u32(2)) * _S695 + cluster_2);
        var _S702 : f32 = box_mean_1(&(_S694), _S692.box_5, _S692.face_6, (_S696 + u32(3)) * _S695 + cluster_2);
        var _S703 : f32 = cluster_visibility_0(_S691, _S693, cluster_2);
        base_1 = with_added_0(base_1, of_family_0(cluster_2 < (_S695 / u32(2)), _S703 * clustered_diffuse_0(_S691, _S693, _S697, vec3<f32>(_S700, _S701, _S702)), _S703 * cluster_attenuation_0(_S691, _S692, _S693, cluster_2) * density_0, _S697 * _S703), 1.0f);
        cluster_2 = cluster_2 + u32(1);
    }
    return base_1;
}

fn with_shares_0( _S704 : u32,  _S705 : Components_0,  _S706 : Yarns_0) -> Components_0
{
    var result_7 : Components_0;
    var _S707 : f32 = min(_S705.hole_0 * _S706.shares_0.z, 1.0f);
    result_7.hole_0 = _S707;
    var _S708 : f32 = _S706.shares_0.x;
    result_7.diffuse_warp_0 = _S705.diffuse_warp_0 * _S708;
    var _S709 : f32 = _S706.shares_0.y;
    result_7.diffuse_weft_0 = _S705.diffuse_weft_0 * _S709;
    result_7.specular_warp_0 = _S705.specular_warp_0 * _S708;
    result_7.specular_weft_0 = _S705.specular_weft_0 * _S709;
    result_7.light_visibility_1 = _S705.light_visibility_1 * select(1.0f, (1.0f - _S707) / max(1.0f - _S705.hole_0, 9.99999997475242708e-07f), (fabrics_0[_S704].is_irregular_0) != u32(0));
    return result_7;
}

fn as_seen_0( _S710 : u32,  _S711 : ClusteredView_0,  _S712 : Components_0) -> Components_0
{
    var whole_1 : Components_0 = _S712;
    whole_1.hole_0 = _S711.even_hole_0;
    return with_shares_0(_S710, whole_1, _S711.yarns_0);
}

fn diffuse_kept_0( _S713 : u32,  _S714 : vec3<f32>,  _S715 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S713].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S714.z), 0.0f))) * (1.0f - fabrics_0[_S713].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S715.z), 0.0f)));
}

fn highlight_rise_0( _S716 : u32,  _S717 : vec3<f32>,  _S718 : vec3<f32>) -> f32
{
    var _S719 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S717, _S718) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S716].grazing_gain_0 * fourth_power_0(_S719) * _S719;
}

fn towards_grazing_0( _S720 : u32,  _S721 : Albedos_0,  _S722 : vec3<f32>,  _S723 : vec3<f32>) -> Albedos_0
{
    var _S724 : f32 = diffuse_kept_0(_S720, _S722, _S723);
    var result_8 : Albedos_0 = _S721;
    var _S725 : vec3<f32> = vec3<f32>(_S724);
    result_8.diffuse_reflect_0 = result_8.diffuse_reflect_0 * _S725;
    result_8.diffuse_transmit_0 = result_8.diffuse_transmit_0 * _S725;
    result_8.specular_reflect_0 = result_8.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S720, _S722, _S723));
    return result_8;
}

fn shaded_0( _S726 : u32,  _S727 : Components_0,  _S728 : FamilyAlbedos_0,  _S729 : vec3<f32>,  _S730 : vec3<f32>,  _S731 : bool) -> vec3<f32>
{
    var _S732 : Albedos_0 = towards_grazing_0(_S726, _S728.warp_3, _S729, _S730);
    var _S733 : Albedos_0 = towards_grazing_0(_S726, _S728.weft_3, _S729, _S730);
    if(_S731)
    {
        return _S732.diffuse_transmit_0 * vec3<f32>(_S727.diffuse_warp_0) + _S733.diffuse_transmit_0 * vec3<f32>(_S727.diffuse_weft_0) + _S732.specular_transmit_0 * vec3<f32>(_S727.specular_warp_0) + _S733.specular_transmit_0 * vec3<f32>(_S727.specular_weft_0);
    }
    return _S732.diffuse_reflect_0 * vec3<f32>(_S727.diffuse_warp_0) + _S733.diffuse_reflect_0 * vec3<f32>(_S727.diffuse_weft_0) + _S732.specular_reflect_0 * vec3<f32>(_S727.specular_warp_0) + _S733.specular_reflect_0 * vec3<f32>(_S727.specular_weft_0);
}

fn under_sheen_0( _S734 : u32,  _S735 : ClusteredView_0,  _S736 : vec3<f32>,  _S737 : f32,  _S738 : vec3<f32>) -> vec3<f32>
{
    var _S739 : f32 = fabrics_0[_S734].sheen_strength_0;
    if((fabrics_0[_S734].sheen_strength_0) <= 0.0f)
    {
        return _S736;
    }
    var _S740 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S738, _S735.base_0.back_6), _S735.base_0.view_4, _S739, fabrics_0[_S734].sheen_roughness_0);
    return vec3<f32>(_S740.y) * _S736 + vec3<f32>((_S737 * _S740.x));
}

fn clustered_base_value_0( _S741 : u32,  _S742 : ClusteredView_0,  _S743 : vec3<f32>) -> vec3<f32>
{
    var _S744 : BaseTaps_0 = base_taps_0(_S742.base_0, _S743);
    var _S745 : Components_0 = as_seen_0(_S741, _S742, clustered_base_0(_S741, _S742.base_0, _S744));
    return under_sheen_0(_S741, _S742, shaded_0(_S741, _S745, _S742.albedos_11, _S743, _S742.view_8, _S744.transmits_1) + bounced_value_0(_S742.bounced_2, _S743, _S742.view_8) * vec3<f32>(diffuse_kept_0(_S741, _S743, _S742.view_8)), _S745.light_visibility_1 + _S742.hole_1, _S743);
}

struct TexelTerms_0
{
     own_2 : Components_0,
     known_0 : Components_0,
};

fn coefficient_0( _S746 : u32,  _S747 : u32,  _S748 : u32) -> f32
{
    var _S749 : i32 = i32(table_byte_0(fabrics_0[_S746].clustered_0.coefficients_0, _S747 * (fabrics_0[_S746].clustered_0.rank_0 + u32(3)) + _S748));
    return f32(select(_S749, _S749 - i32(256), _S749 > i32(127)));
}

fn at_texel_0( _S750 : u32,  _S751 : ViewedBase_0,  _S752 : u32,  _S753 : BaseTaps_0) -> TexelTerms_0
{
    var _S754 : Clustered_std430_0 = fabrics_0[_S750].clustered_0;
    var _S755 : u32 = fabrics_0[_S750].clustered_0.columns_0 * fabrics_0[_S750].clustered_0.rows_0;
    var _S756 : u32 = _S751.face_6 * _S755 + _S752;
    var _S757 : u32 = table_byte_0(fabrics_0[_S750].clustered_0.labels_0, _S756);
    var terms_5 : TexelTerms_0;
    var _S758 : Components_0 = no_components_0();
    terms_5.own_2 = _S758;
    terms_5.known_0 = _S758;
    if(_S757 >= (fabrics_0[_S750].clustered_0.clusters_0))
    {
        return terms_5;
    }
    var _S759 : f32 = cluster_density_0(_S750, _S751, _S753, _S757, u32(0));
    var number_11 : u32 = u32(1);
    var density_2 : f32 = _S759;
    for(;;)
    {
        if(number_11 <= (_S754.rank_0))
        {
        }
        else
        {
            break;
        }
        var density_3 : f32 = density_2 + coefficient_0(_S750, _S756, number_11 - u32(1)) * cluster_density_0(_S750, _S751, _S753, _S757, number_11);
        number_11 = number_11 + u32(1);
        density_2 = density_3;
    }
    var _S760 : f32 = cluster_attenuation_0(_S750, _S751, _S753, _S757) * density_2;
    var _S761 : f32 = clustered_cosine_0(_S753, vec3<f32>(coefficient_0(_S750, _S756, _S754.rank_0), coefficient_0(_S750, _S756, _S754.rank_0 + u32(1)), coefficient_0(_S750, _S756, _S754.rank_0 + u32(2))));
    var _S762 : f32 = abs(_S753.facing_0.z);
    var _S763 : f32 = gaussian_visibility_0(_S754.texels_2 + (select(_S751.face_6, u32(1) - _S751.face_6, _S753.transmits_1) * _S755 + _S752) * u32(12), vec3<f32>(_S753.facing_0.xy, _S762));
    var _S764 : f32 = 0.31830987334251404f * (1.0f - fabrics_0[_S750].diffuse_blend_0) * _S762;
    var _S765 : f32 = cluster_visibility_0(_S750, _S753, _S757);
    var _S766 : bool = _S757 < (_S754.clusters_0 / u32(2));
    var _S767 : f32 = 0.31830987334251404f * fabrics_0[_S750].diffuse_blend_0;
    terms_5.own_2 = of_family_0(_S766, _S763 * (_S764 + _S767 * max(_S761, 0.0f)), _S763 * _S760, _S763);
    terms_5.known_0 = of_family_0(_S766, _S765 * (_S764 + _S767 * _S761), _S765 * _S760, _S765);
    return terms_5;
}

fn texel_albedos_0( _S768 : u32,  _S769 : ClusteredView_0,  _S770 : u32) -> Albedos_0
{
    var _S771 : u32 = _S769.base_0.face_6 * fabrics_0[_S768].clustered_0.columns_0 * fabrics_0[_S768].clustered_0.rows_0 + _S770;
    var _S772 : bool = (table_byte_0(fabrics_0[_S768].clustered_0.labels_0, _S771)) < (fabrics_0[_S768].clustered_0.clusters_0 / u32(2));
    var _S773 : u32 = select(fabrics_0[_S768].weft_0, fabrics_0[_S768].warp_0, _S772);
    var _S774 : u32 = fabrics_0[_S768].clustered_0.texels_2 + _S771 * u32(12) + u32(9);
    var _S775 : Albedos_0 = table_albedos_0(families_0[_S773].albedo_table_0 + min(u32(table_number_0(_S774)) + u32(1024) * u32(table_number_0(_S774 + u32(1))), u32(families_0[_S773].count_0) - u32(1)) * families_0[_S773].albedo_stride_0);
    if((fabrics_0[_S768].is_irregular_0) == u32(0))
    {
        return _S775;
    }
    return toned_0(_S768, _S773, _S775, select_vector_0(_S772, _S769.yarns_0.warp_1, _S769.yarns_0.weft_1));
}

fn clustered_residual_0( _S776 : u32,  _S777 : ClusteredView_0,  _S778 : u32,  _S779 : vec3<f32>,  _S780 : vec3<f32>) -> vec3<f32>
{
    var _S781 : BaseTaps_0 = base_taps_0(_S777.base_0, _S780);
    var _S782 : TexelTerms_0 = at_texel_0(_S776, _S777.base_0, _S778, _S781);
    var own_3 : FamilyAlbedos_0;
    var _S783 : Albedos_0 = tinted_0(texel_albedos_0(_S776, _S777, _S778), _S779);
    own_3.warp_3 = _S783;
    own_3.weft_3 = _S783;
    var _S784 : Components_0 = as_seen_0(_S776, _S777, _S782.own_2);
    var _S785 : Components_0 = as_seen_0(_S776, _S777, _S782.known_0);
    return under_sheen_0(_S776, _S777, shaded_0(_S776, _S784, own_3, _S780, _S777.view_8, _S781.transmits_1) - shaded_0(_S776, _S785, _S777.albedos_11, _S780, _S777.view_8, _S781.transmits_1), _S784.light_visibility_1 - _S785.light_visibility_1, _S780);
}

fn passed_by_sheen_0( _S786 : u32,  _S787 : f32,  _S788 : vec3<f32>) -> f32
{
    var _S789 : f32 = fabrics_0[_S786].sheen_strength_0;
    if((fabrics_0[_S786].sheen_strength_0) <= 0.0f)
    {
        return _S787;
    }
    return _S787 * (1.0f - _S789 * sheen_lobe_0(abs(_S788.z), fabrics_0[_S786].sheen_roughness_0).z);
}

fn light_of_clustered_0( _S790 : u32,  _S791 : VisiblePoint_0,  _S792 : vec2<u32>,  _S793 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.dx_0 = _S791.draft_dx_0;
    footprint_1.dy_0 = _S791.draft_dy_0;
    footprint_1.centre_0 = irregular_place_0(_S790, _S791.draft_0, Footprint_spread_side_0(footprint_1));
    var _S794 : vec3<f32> = to_local_0(_S791, _S791.view_0);
    var _S795 : Clustered_std430_0 = fabrics_0[_S790].clustered_0;
    var _S796 : u32 = mixed_0(mixed_0(_S792.x + u32(65536) * _S792.y) + frame_record_0.pass_number_0 * u32(2654435769));
    var _S797 : ClusteredView_0 = clustered_view_0(_S790, footprint_1, _S794, _S793, _S796);
    var _S798 : vec3<f32> = vec3<f32>(0.0f);
    var term_3 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S798;
    for(;;)
    {
        if(term_3 <= (_S795.samples_1))
        {
        }
        else
        {
            break;
        }
        var texel_0 : u32;
        if(term_3 > u32(0))
        {
            texel_0 = residual_texel_0(_S790, _S797, _S796, term_3 - u32(1));
        }
        else
        {
            texel_0 = u32(0);
        }
        var number_12 : u32 = u32(0);
        var radiance_2 : vec3<f32> = radiance_1;
        for(;;)
        {
            if(number_12 < (light_sample_count_0()))
            {
            }
            else
            {
                break;
            }
            var _S799 : f32 = visibility_at_0(number_12, _S792);
            if(_S799 <= 0.0f)
            {
                number_12 = number_12 + u32(1);
                continue;
            }
            var _S800 : LightSample_0 = light_sample_0(number_12, _S792, _S791.position_4);
            var _S801 : vec3<f32> = to_local_0(_S791, _S800.towards_1);
            var value_2 : vec3<f32>;
            if(term_3 == u32(0))
            {
                value_2 = clustered_base_value_0(_S790, _S797, _S801);
            }
            else
            {
                value_2 = clustered_residual_0(_S790, _S797, texel_0, _S793, _S801) / vec3<f32>(f32(_S795.samples_1));
            }
            radiance_2 = radiance_2 + vec3<f32>(_S799) * _S800.irradiance_1 * value_2;
            number_12 = number_12 + u32(1);
        }
        term_3 = term_3 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - passed_by_sheen_0(_S790, _S797.hole_1, _S794));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_clustered(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S802 : u32 = id_0.x;
    var _S803 : bool;
    if(_S802 >= (frame_record_0.width_0))
    {
        _S803 = true;
    }
    else
    {
        _S803 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S803)
    {
        return;
    }
    var _S804 : u32 = id_0.y * frame_record_0.width_0 + _S802;
    var _S805 : u32 = layers_0[_S804].face_0;
    if((layers_0[_S804].face_0) == u32(0))
    {
        return;
    }
    var _S806 : u32 = _S805 - u32(1);
    var _S807 : u32 = fabric_of_0(_S806);
    var _S808 : vec2<u32> = id_0.xy;
    var _S809 : VisiblePoint_0 = visible_point_0(_S807, _S806, _S808);
    accumulate_0(_S804, light_of_clustered_0(_S807, _S809, _S808, filtered_albedo_0(_S807, _S809)));
    return;
}

