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

fn select_vector_0( condition_0 : bool,  yes_0 : vec3<f32>,  no_0 : vec3<f32>) -> vec3<f32>
{
    var chosen_0 : vec3<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
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

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
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

fn uniform_hash_0( thread_1 : u32,  cell_2 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_2)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_1 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S31 : u32 = pixel_0.x;
    var _S32 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S31, _S32, stream_2), uniform_hash_0(_S31, _S32, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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

fn turns_and_remainder_0( family_1 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S33 : f32 = floor(fma(index_2, families_0[family_1].inverse_count_0, families_0[family_1].half_inverse_count_0));
    return vec2<f32>(_S33, fma(- _S33, families_0[family_1].count_0, index_2));
}

struct Cell_0
{
     thread_2 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_2 : u32,  position_0 : f32) -> Cell_0
{
    var _S34 : f32 = floor(position_0 * families_0[family_2].inverse_size_0);
    var cell_3 : Cell_0;
    var _S35 : f32 = fma(- _S34, families_0[family_2].size_0, position_0);
    cell_3.below_0 = _S35;
    cell_3.above_0 = families_0[family_2].size_0 - _S35;
    cell_3.across_0 = _S35 - 0.5f * families_0[family_2].size_0;
    cell_3.half_width_1 = families_0[family_2].half_width_0;
    cell_3.thread_2 = u32(clamp(turns_and_remainder_0(family_2, _S34).y, 0.0f, families_0[family_2].count_0 - 1.0f));
    return cell_3;
}

fn table_number_0( index_3 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_3])));
}

fn locate_varied_0( family_3 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_3].start_0) * families_0[family_3].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S36 : f32 = turns_1 * families_0[family_3].period_0;
    var thread_3 : u32 = words_0[families_0[family_3].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_3].bins_0, 0.0f, families_0[family_3].bins_0 - 1.0f))];
    var _S37 : u32 = min(thread_3 + select(u32(0), u32(1), _S36 >= (table_number_0(families_0[family_3].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_3].count_0) - u32(1));
    var _S38 : u32 = families_0[family_3].place_table_0 + _S37 * u32(4);
    var cell_4 : Cell_0;
    cell_4.thread_2 = _S37;
    cell_4.below_0 = _S36 - table_number_0(_S38);
    cell_4.above_0 = table_number_0(_S38 + u32(1)) - _S36;
    cell_4.across_0 = _S36 - table_number_0(_S38 + u32(2));
    cell_4.half_width_1 = table_number_0(_S38 + u32(3));
    return cell_4;
}

fn locate_0( family_4 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_4].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_4, position_2);
    }
    return locate_varied_0(family_4, position_2);
}

fn irregular_thread_0( family_5 : u32,  position_3 : f32,  cell_5 : Cell_0) -> f32
{
    return floor((position_3 - cell_5.across_0) / families_0[family_5].period_0) * families_0[family_5].count_0 + f32(cell_5.thread_2);
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

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S52 : vec2<f32> = this_0.dx_0;
    var _S53 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S52, _S52) + dot(_S53, _S53)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S54 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S54, - _S54, back_2));
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

fn plane_at_0( first_2 : u32) -> Plane_0
{
    var record_1 : Plane_0;
    record_1.warp_1 = words_0[first_2];
    record_1.weft_1 = words_0[first_2 + u32(1)];
    record_1.run_words_1 = words_0[first_2 + u32(2)];
    record_1.ends_2 = words_0[first_2 + u32(3)];
    record_1.end_numbers_0 = words_0[first_2 + u32(4)];
    record_1.pick_numbers_0 = words_0[first_2 + u32(5)];
    record_1.max_heights_1 = words_0[first_2 + u32(6)];
    record_1.max_height_columns_1 = words_0[first_2 + u32(7)];
    record_1.height_low_1 = (bitcast<f32>((words_0[first_2 + u32(8)])));
    record_1.height_high_1 = (bitcast<f32>((words_0[first_2 + u32(9)])));
    record_1.front_level_0 = (bitcast<f32>((words_0[first_2 + u32(10)])));
    record_1.back_level_0 = (bitcast<f32>((words_0[first_2 + u32(11)])));
    record_1.start_x_0 = (bitcast<f32>((words_0[first_2 + u32(12)])));
    record_1.start_y_0 = (bitcast<f32>((words_0[first_2 + u32(13)])));
    record_1.fine_x_0 = (bitcast<f32>((words_0[first_2 + u32(14)])));
    record_1.fine_y_0 = (bitcast<f32>((words_0[first_2 + u32(15)])));
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

fn crossing_at_0( plane_0 : Plane_0,  x_6 : f32,  y_1 : f32,  back_3 : bool) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.warp_2 = locate_0(plane_0.warp_1, x_6 - plane_0.start_x_0);
    crossing_0.weft_2 = locate_0(plane_0.weft_1, y_1 - plane_0.start_y_0);
    var _S55 : u32 = plane_0.run_words_1 + u32(2) * (crossing_0.weft_2.thread_2 * plane_0.ends_2 + crossing_0.warp_2.thread_2);
    var _S56 : u32 = words_0[_S55];
    crossing_0.warp_word_0 = _S56;
    crossing_0.weft_word_0 = words_0[_S55 + u32(1)];
    crossing_0.warp_above_0 = (((_S56 & (u32(1)))) == u32(1)) != back_3;
    return crossing_0;
}

fn cell_maximum_0( plane_1 : Plane_0,  crossing_1 : Crossing_0) -> f32
{
    var _S57 : u32 = select(plane_1.weft_1, plane_1.warp_1, crossing_1.warp_above_0);
    return f32((select(crossing_1.weft_word_0, crossing_1.warp_word_0, crossing_1.warp_above_0) >> (u32(28)))) * families_0[_S57].height_scale_0 * families_0[_S57].level_0;
}

fn bounds_in_0( plane_2 : Plane_0,  x_7 : f32,  y_2 : f32,  back_4 : bool,  right_0 : bool,  up_0 : bool) -> vec3<f32>
{
    var _S58 : Crossing_0 = crossing_at_0(plane_2, x_7, y_2, back_4);
    return vec3<f32>(cell_maximum_0(plane_2, _S58), select(_S58.warp_2.below_0, _S58.warp_2.above_0, right_0), select(_S58.weft_2.below_0, _S58.weft_2.above_0, up_0));
}

fn hole_edge_0( cell_6 : Cell_0,  forwards_0 : bool) -> f32
{
    var _S59 : f32 = select(- cell_6.across_0, cell_6.across_0, forwards_0);
    var _S60 : f32 = - cell_6.half_width_1;
    return select(select(cell_6.half_width_1, _S60, _S59 < _S60) - _S59, 2.0f * select(cell_6.below_0, cell_6.above_0, forwards_0) + _S59 - cell_6.half_width_1, _S59 >= (cell_6.half_width_1));
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
    var _S61 : bool = (abs(crossing_2.warp_2.across_0)) < (crossing_2.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S62 : bool = !((abs(crossing_2.weft_2.across_0)) < (crossing_2.weft_2.half_width_1));
    var _S63 : bool = (_S61 & (((_S62 | ((crossing_2.warp_above_0))))));
    shown_0.is_warp_0 = _S63;
    shown_0.hole_0 = ((!_S61) & (_S62));
    var _S64 : u32 = select(crossing_2.weft_word_0, crossing_2.warp_word_0, _S63);
    shown_0.word_0 = _S64;
    shown_0.on_top_0 = (((_S64 & (u32(1)))) == u32(1)) != back_5;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_3 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_7 : Cell_0;
    cell_7.thread_2 = select(second_0.thread_2, first_3.thread_2, is_first_0);
    cell_7.across_0 = select(second_0.across_0, first_3.across_0, is_first_0);
    cell_7.half_width_1 = select(second_0.half_width_1, first_3.half_width_1, is_first_0);
    cell_7.below_0 = select(second_0.below_0, first_3.below_0, is_first_0);
    cell_7.above_0 = select(second_0.above_0, first_3.above_0, is_first_0);
    return cell_7;
}

fn boundary_0( family_9 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S65 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_4) + step_0));
    return fma(_S65.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S65.y) * u32(4)));
}

fn span_0( family_10 : u32,  thread_5 : u32,  first_4 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_10].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_4) * families_0[family_10].size_0;
    }
    return boundary_0(family_10, thread_5, last_0) - boundary_0(family_10, thread_5, first_4);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_11 : u32,  thread_6 : u32) -> Bend_0
{
    var _S66 : u32 = families_0[family_11].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S66);
    bend_0.half_tangent_0 = table_number_0(_S66 + u32(1));
    bend_0.arc_0 = table_number_0(_S66 + u32(2));
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

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_7 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S67 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S68 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S69 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S70 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S71 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S71;
    var _S72 : i32 = - _S67;
    var _S73 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S72, i32(0));
    run_0.from_start_0 = _S73;
    var _S74 : i32 = _S68 + i32(1);
    var _S75 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S74);
    run_0.to_end_0 = _S75;
    var _S76 : bool = _S73 < _S75;
    run_0.near_start_0 = _S76;
    var _S77 : i32 = select(_S74, _S72 - _S69, _S76);
    var _S78 : i32 = select(_S74 + _S70, _S72, _S76);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S73, _S75), 1.0e+06f, _S71);
    run_0.reach_0 = min(0.5f * (_S73 + _S75), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S77, _S78), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S67 == i32(0);
    run_0.last_crossing_0 = _S68 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_8 : Cell_0) -> Section_0
{
    var _S79 : f32 = cell_8.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S80 : f32 = clamp(cell_8.across_0, - cell_8.half_width_1, cell_8.half_width_1);
    section_0.across_1 = _S80;
    var _S81 : f32 = _S79 * _S79 - square_1(_S80);
    var _S82 : f32 = rsqrt_0(_S81);
    section_0.drop_0 = _S79 - _S81 * _S82;
    section_0.slope_0 = - _S80 * _S82;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S83 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S84 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S85 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S83) - crossed_1.half_width_1;
    var _S86 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S83);
    var _S87 : f32;
    if(shown_1.on_top_0)
    {
        _S87 = 0.0f;
    }
    else
    {
        _S87 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S88 : f32;
    if((shown_1.on_top_0) != _S86)
    {
        _S88 = 0.0f;
    }
    else
    {
        _S88 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S83));
    }
    var _S89 : f32 = 2.0f * _S85;
    var _S90 : f32 = 1.0f / max(_S89, 9.999999960041972e-13f);
    var _S91 : f32 = clamp((_S85 - _S84) * _S90, 0.0f, 1.0f);
    var _S92 : f32 = clamp((0.44999998807907104f - _S89 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S87 + (_S88 - _S87) * (_S91 * _S91 * (3.0f - 2.0f * _S91)), (_S87 - _S88) * (6.0f * _S91 * (1.0f - _S91) * _S90) * select(-1.0f, 1.0f, _S83), _S92 * _S92 * (3.0f - 2.0f * _S92));
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

fn sample_in_0( here_1 : PlaneHere_0,  x_8 : f32,  y_3 : f32,  back_6 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    sample_0.here_0 = here_1;
    var _S93 : Crossing_0 = crossing_at_0(here_1.plane_3, x_8, y_3, back_6);
    sample_0.crossing_3 = _S93;
    var _S94 : Shown_0 = shown_at_0(_S93, back_6);
    sample_0.shown_2 = _S94;
    var _S95 : u32 = select(here_1.plane_3.weft_1, here_1.plane_3.warp_1, _S94.is_warp_0);
    var _S96 : u32 = select(here_1.plane_3.warp_1, here_1.plane_3.weft_1, _S94.is_warp_0);
    var _S97 : Cell_0 = select_cell_0(_S94.is_warp_0, sample_0.crossing_3.warp_2, sample_0.crossing_3.weft_2);
    var _S98 : Cell_0 = select_cell_0(_S94.is_warp_0, sample_0.crossing_3.weft_2, sample_0.crossing_3.warp_2);
    var _S99 : Run_0 = unpack_0(_S95, _S96, _S97.thread_2, _S98, _S94.word_0);
    var _S100 : Section_0 = section_at_0(_S97);
    var _S101 : bool = ((_S94.on_top_0) & (((_S99.distance_0) < (_S100.drop_0 * _S99.bend_1.sine_0))));
    var _S102 : f32 = select(-1.0f, 1.0f, ((_S94.on_top_0) & ((!_S101))));
    var _S103 : f32 = select(_S99.reach_0, _S99.other_reach_0, _S101);
    var _S104 : f32 = select(max(_S103 - _S99.distance_0, 0.0f), _S103 + _S99.distance_0, _S101);
    var _S105 : f32 = _S103 / _S99.bend_1.sine_0 - _S102 * _S100.drop_0;
    var _S106 : f32 = _S104 * _S104;
    var _S107 : f32 = max(_S105 * _S105 - _S106, 9.99999968265522539e-21f);
    var _S108 : f32 = rsqrt_0(_S107);
    var _S109 : f32 = _S106 / (_S107 * _S108 + _S105);
    var _S110 : bool = _S104 > 0.0f;
    var _S111 : f32 = select(-1.0f, 1.0f, _S94.on_top_0) * select(-1.0f, 1.0f, _S99.near_start_0);
    var _S112 : f32 = _S100.slope_0 * select(1.0f, _S105 * _S108, _S110);
    sample_0.slope_across_0 = _S112;
    var _S113 : f32 = select(0.0f, _S111 * _S104 * _S108, _S110);
    sample_0.slope_along_0 = _S113;
    var _S114 : vec3<f32> = dive_0(_S96, _S94, _S99, _S98);
    sample_0.dive_1 = _S114;
    sample_0.height_2 = select(families_0[_S95].height_scale_0 * _S102, 0.0f, _S99.straight_0) * (_S103 * _S99.bend_1.half_tangent_0 - _S109) - families_0[_S95].height_scale_0 * _S100.drop_0 - _S114.x + here_1.level_1;
    var _S115 : f32 = families_0[_S95].height_scale_0 * _S112;
    var _S116 : f32 = families_0[_S95].height_scale_0 * _S113 - _S114.y;
    sample_0.slope_x_0 = select(_S116, _S115, _S94.is_warp_0);
    sample_0.slope_y_0 = select(_S115, _S116, _S94.is_warp_0);
    sample_0.run_2 = _S99;
    sample_0.section_1 = _S100;
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
    var _S117 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S117), 9.99999971718068537e-10f);
    var _S118 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S118), 9.99999971718068537e-10f);
    control_0.right_1 = _S117 > 0.0f;
    control_0.up_1 = _S118 > 0.0f;
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

fn outline_distance_0( cell_9 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_1 : bool) -> f32
{
    var _S119 : f32 = select(- cell_9.across_0, cell_9.across_0, forwards_1);
    var _S120 : f32 = select(cell_9.below_0, cell_9.above_0, forwards_1);
    var _S121 : f32 = - cell_9.half_width_1;
    var _S122 : bool = _S119 < _S121;
    var _S123 : bool = _S119 >= (cell_9.half_width_1);
    var _S124 : bool = (((lengthwise_0 & ((!select(run_3.first_crossing_0, run_3.last_crossing_0, forwards_1))))) & ((!shown_3.hole_0)));
    var _S125 : f32 = select(cell_9.half_width_1, _S121, _S122) - _S119;
    var _S126 : f32 = select(_S120, 2.0f * _S120 + _S119 - cell_9.half_width_1, ((shown_3.hole_0) | (((_S124 & ((!shown_3.on_top_0)))))));
    if((((_S124 & ((shown_3.on_top_0)))) & ((!((select(run_3.last_crossing_0, run_3.first_crossing_0, forwards_1) & (_S122)))))))
    {
        return select(run_3.from_start_0, run_3.to_end_0, forwards_1);
    }
    return select(_S125, _S126, _S123);
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
    var _S127 : f32 = previous_1.rate_0 * step_4;
    var _S128 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_2.hole_1)))) | (((previous_1.yarn_0) != (here_2.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S127) >= 0.0f) & (((3.0f * clearance_1 - _S128) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S129 : f32 = clearance_1 - previous_1.clearance_0;
    var _S130 : f32 = 6.0f * _S129 - 4.0f * _S127 - 2.0f * _S128;
    var _S131 : f32 = -2.0f * _S127 / max(_S130 + sqrt(max(_S130 * _S130 - 4.0f * (3.0f * (_S127 + _S128 - 2.0f * _S129)) * _S127, 0.0f)), 9.99999968265522539e-21f);
    var _S132 : f32 = 1.0f - _S131;
    return select(-1.0f, _S132 * step_4, ((((_S131 > 0.01999999955296516f) & ((_S132 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S131 + 1.0f) + _S127 * _S131) * _S132 * _S132 + (clearance_1 * (2.0f * _S132 + 1.0f) - _S128 * _S132) * _S131 * _S131) < 0.0f))));
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

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_4 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S133 : f32 = min(here_4.edge_x_1 * this_2.per_x_0, here_4.edge_y_1 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S133, 0.0f) + this_2.epsilon_0, _S133 - this_2.epsilon_0, ((((!here_4.hole_1) & (((rate_3 * _S133 + clearance_3) < 0.0f)))) & ((_S133 > (2.0f * this_2.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_4 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_4);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_5 : Probe_0) -> f32
{
    return here_5.slope_x_1 * this_4.slope_1.x + here_5.slope_y_1 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S134 : f32 = end_0 - start_1;
    var _S135 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S134;
    var _S136 : f32 = 3.0f * _S134 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S134, 9.99999968265522539e-21f);
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
        var _S137 : f32 = clamp(share_1 - (((_S135 * share_1 + _S136) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S135 * share_1 + 2.0f * _S136) * share_1 + start_rate_0, 0.10000000149011612f * _S134 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S138 : i32 = i_0 + i32(1);
        share_1 = _S137;
        i_0 = _S138;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S139 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S140 : f32 = rsqrt_0(_S139);
    var _S141 : f32 = sine_1 * _S140 * rsqrt_0(_S139 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S141 * _S139, _S141 * across_slope_0 * along_slope_0 + cosine_0 * _S140);
}

fn arc_sine_0( x_9 : f32) -> f32
{
    var _S142 : f32 = abs(x_9);
    var _S143 : bool = _S142 > 0.5f;
    var _S144 : f32 = select(_S142 * _S142, 0.5f * (1.0f - _S142), _S143);
    var _S145 : f32 = select(_S142, sqrt(max(_S144, 0.0f)), _S143);
    var _S146 : f32 = ((((0.04216320067644119f * _S144 + 0.02418131195008755f) * _S144 + 0.04547002539038658f) * _S144 + 0.07495300471782684f) * _S144 + 0.16666752099990845f) * _S144 * _S145 + _S145;
    var _S147 : f32 = select(_S146, 1.57079637050628662f - 2.0f * _S146, _S143);
    return select(_S147, - _S147, x_9 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S148 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S148 / (_S148 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S149 : f32 = direction_3.x;
    var _S150 : f32 = arc_sine_0(_S149);
    var _S151 : bool = _S149 < 0.0f;
    var _S152 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S151);
    var _S153 : f32 = direction_3.y;
    return select(0.5f * _S152 - select(1.0f, -1.0f, _S151) * arc_sine_0(_S153), select(_S150, _S152 - _S150, _S153 < 0.0f), (abs(_S149)) < 0.69999998807907104f);
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
    var _S154 : Albedos_0;
    _S154.diffuse_reflect_0 = diffuse_reflect_1;
    _S154.diffuse_transmit_0 = diffuse_transmit_1;
    _S154.specular_reflect_0 = specular_reflect_1;
    _S154.specular_transmit_0 = specular_transmit_1;
    return _S154;
}

struct Hairs_0
{
     place_1 : vec2<f32>,
     below_1 : f32,
     back_7 : bool,
     size_3 : f32,
};

fn Hairs_x24init_0( place_2 : vec2<f32>,  below_2 : f32,  back_8 : bool,  size_4 : f32) -> Hairs_0
{
    var _S155 : Hairs_0;
    _S155.place_1 = place_2;
    _S155.below_1 = below_2;
    _S155.back_7 = back_8;
    _S155.size_3 = size_4;
    return _S155;
}

struct YarnPoint_0
{
     back_9 : bool,
     hole_2 : bool,
     is_warp_1 : bool,
     x_10 : f32,
     y_4 : f32,
     height_5 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_0 : f32,
     roughness_1 : f32,
     albedos_0 : Albedos_0,
     hairs_0 : Hairs_0,
     hair_cover_0 : f32,
     place_3 : vec2<f32>,
     plane_4 : f32,
};

fn YarnPoint_x24init_0( back_10 : bool,  hole_3 : bool,  is_warp_2 : bool,  x_11 : f32,  y_5 : f32,  height_6 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  surface_normal_1 : vec3<f32>,  diffuse_gain_1 : f32,  roughness_2 : f32,  albedos_1 : Albedos_0,  hairs_1 : Hairs_0,  hair_cover_1 : f32,  place_4 : vec2<f32>,  plane_5 : f32) -> YarnPoint_0
{
    var _S156 : YarnPoint_0;
    _S156.back_9 = back_10;
    _S156.hole_2 = hole_3;
    _S156.is_warp_1 = is_warp_2;
    _S156.x_10 = x_11;
    _S156.y_4 = y_5;
    _S156.height_5 = height_6;
    _S156.normal_1 = normal_2;
    _S156.tangent_0 = tangent_1;
    _S156.surface_normal_0 = surface_normal_1;
    _S156.diffuse_gain_0 = diffuse_gain_1;
    _S156.roughness_1 = roughness_2;
    _S156.albedos_0 = albedos_1;
    _S156.hairs_0 = hairs_1;
    _S156.hair_cover_0 = hair_cover_1;
    _S156.place_3 = place_4;
    _S156.plane_4 = plane_5;
    return _S156;
}

struct Hair_0
{
     cover_1 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     is_warp_3 : bool,
     shade_0 : f32,
};

fn Hair_x24init_0( cover_2 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>,  is_warp_4 : bool,  shade_1 : f32) -> Hair_0
{
    var _S157 : Hair_0;
    _S157.cover_1 = cover_2;
    _S157.normal_3 = normal_4;
    _S157.tangent_2 = tangent_3;
    _S157.is_warp_3 = is_warp_4;
    _S157.shade_0 = shade_1;
    return _S157;
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_12 : f32) -> vec2<f32>
{
    var _S158 : f32 = floor(x_12 * 0.63661974668502808f + 0.5f);
    var _S159 : f32 = x_12 - _S158 * 1.5703125f - _S158 * 0.00048375129699707f - _S158 * 7.54979012640433211e-08f;
    var _S160 : f32 = _S159 * _S159;
    var _S161 : f32 = ((-0.00019515295571182f * _S160 + 0.00833216123282909f) * _S160 - 0.16666655242443085f) * _S160 * _S159 + _S159;
    var _S162 : f32 = ((0.00002443315679557f * _S160 - 0.00138873164542019f) * _S160 + 0.04166664555668831f) * _S160 * _S160 - 0.5f * _S160 + 1.0f;
    var _S163 : u32 = (u32(i32(_S158)) & (u32(3)));
    var _S164 : vec2<f32> = select_vector_1(((_S163 & (u32(1)))) != u32(0), vec2<f32>(_S162, _S161), vec2<f32>(_S161, _S162));
    var _S165 : f32 = _S164.x;
    var _S166 : f32 = _S164.y;
    return vec2<f32>(select(_S165, - _S165, ((_S163 & (u32(2)))) != u32(0)), select(_S166, - _S166, (((_S163 + u32(1)) & (u32(2)))) != u32(0)));
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_5 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_7 : f32,
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_13 : f32,
     y_6 : f32,
     shown_share_0 : f32,
     plane_6 : f32,
     layer_0 : u32,
};

fn ply_offset_0( family_13 : u32,  point_1 : SurfacePoint_0,  back_11 : bool) -> f32
{
    var _S167 : f32 = (point_1.fibre_across_0 * families_0[family_13].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_13].ply_sine_0, - families_0[family_13].ply_sine_0, back_11)) * families_0[family_13].plies_per_mm_0;
    return 2.0f * (_S167 - floor(_S167)) - 1.0f;
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_4 : u32,  position_5 : f32) -> vec2<f32>
{
    var _S168 : f32 = floor(position_5);
    var _S169 : f32 = position_5 - _S168;
    var _S170 : u32 = u32(i32(_S168));
    var _S171 : f32 = signed_noise_0(hash_bits_0(key_4, _S170));
    var _S172 : f32 = signed_noise_0(hash_bits_0(key_4, _S170 + u32(1)));
    return vec2<f32>(mix(_S171, _S172, smooth_share_0(_S169)), 6.0f * _S169 * (1.0f - _S169) * (_S172 - _S171));
}

fn fibre_cell_0( across_3 : f32,  along_1 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S173 : f32 = floor(across_3 / width_2);
    return vec3<f32>(_S173, along_1 / (width_2 * 40.0f) + 0.61799997091293335f * _S173, 2.0f * (across_3 / width_2 - _S173) - 1.0f);
}

fn cell_noise_0( key_5 : u32,  cell_10 : vec3<f32>) -> vec2<f32>
{
    var _S174 : f32 = cell_10.y;
    var _S175 : f32 = floor(_S174);
    var _S176 : u32 = u32(i32(cell_10.x)) * u32(65536) + u32(i32(_S175));
    var _S177 : u32 = hash_bits_0(key_5, _S176);
    var _S178 : u32 = hash_bits_0(key_5, _S176 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S177), signed_noise_0((_S177 >> (u32(16))))), vec2<f32>(signed_noise_0(_S178), signed_noise_0((_S178 >> (u32(16))))), vec2<f32>(smooth_share_0(_S174 - _S175)));
}

struct YarnFrame_0
{
     normal_6 : vec3<f32>,
     tangent_5 : vec3<f32>,
     loss_0 : f32,
     shade_2 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S179 : vec3<f32> = select_vector_0((dot(frame_0.tangent_5, hair_0.tangent_2)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_2), hair_0.tangent_2);
    var blended_0 : YarnFrame_0;
    var _S180 : vec3<f32> = vec3<f32>(hair_0.cover_1);
    var _S181 : vec3<f32> = normalize(mix(frame_0.normal_6, hair_0.normal_3, _S180));
    blended_0.normal_6 = _S181;
    var _S182 : vec3<f32> = mix(frame_0.tangent_5, _S179, _S180);
    var _S183 : vec3<f32> = _S182 - vec3<f32>(dot(_S182, _S181)) * _S181;
    blended_0.tangent_5 = _S183 * vec3<f32>(rsqrt_0(max(dot(_S183, _S183), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_1);
    blended_0.shade_2 = hair_0.shade_0;
    return blended_0;
}

fn diffuse_gain_2( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f + frame_1.shade_2, 1.0f / (0.5f * blend_0 * (frame_1.normal_6.z - 1.0f) + 1.0f));
}

fn table_colour_0( index_4 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_4), table_number_0(index_4 + u32(1)), table_number_0(index_4 + u32(2)));
}

fn table_albedos_0( row_1 : u32) -> Albedos_0
{
    var albedos_2 : Albedos_0;
    albedos_2.diffuse_reflect_0 = table_colour_0(row_1);
    albedos_2.diffuse_transmit_0 = table_colour_0(row_1 + u32(3));
    albedos_2.specular_reflect_0 = table_colour_0(row_1 + u32(6));
    albedos_2.specular_transmit_0 = table_colour_0(row_1 + u32(9));
    return albedos_2;
}

fn albedos_of_0( family_14 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_14].albedo_table_0 + families_0[family_14].albedo_stride_0 * thread_9);
}

fn groove_0( depth_0 : f32,  offset_1 : f32) -> vec2<f32>
{
    return vec2<f32>(depth_0) * vec2<f32>(0.1111111119389534f - square_1(square_1(square_1(offset_1))), 0.1111111119389534f);
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S184 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S184.x, _S184.y), _S184.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S185 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S185.x, _S185.y), _S185.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_11 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_11, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct FaceRadiance_0
{
     warp_3 : vec3<f32>,
     weft_3 : vec3<f32>,
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
    var _S186 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S187 : vec3<f32> = sends_0.sky_warp_0 + _S186 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S187;
    var _S188 : vec3<f32> = sends_0.sky_weft_0 + _S186 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S188;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S187 + vec3<f32>(sends_0.blocks_weft_0) * _S188;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
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
     back_12 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_4 : vec3<f32>,
     weft_4 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S189 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S190 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_12 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_4) + _S190 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S190 * interior_0.far_1 + yarn_2.back_12 * _S189;
    bounced_0.is_covered_0 = false;
    return bounced_0;
}

fn scattered_evenly_0( family_15 : u32,  albedos_3 : Albedos_0,  tint_0 : vec3<f32>) -> Scattered_0
{
    var yarn_3 : Scattered_0;
    yarn_3.back_12 = tint_0 * albedos_3.diffuse_reflect_0 + vec3<f32>(families_0[family_15].layer_turned_0) * albedos_3.specular_reflect_0;
    yarn_3.through_0 = tint_0 * albedos_3.diffuse_transmit_0 + vec3<f32>(families_0[family_15].layer_through_0) * albedos_3.specular_transmit_0;
    return yarn_3;
}

fn beneath_0( upper_0 : Scattered_0,  lower_0 : Scattered_0) -> Scattered_0
{
    var _S191 : vec3<f32> = upper_0.through_0 / (vec3<f32>(1.0f) - min(upper_0.back_12 * lower_0.back_12, vec3<f32>(0.99900001287460327f)));
    var both_0 : Scattered_0;
    both_0.back_12 = upper_0.back_12 + _S191 * lower_0.back_12 * upper_0.through_0;
    both_0.through_0 = _S191 * lower_0.through_0;
    return both_0;
}

fn tinted_0( albedos_4 : Albedos_0,  tint_1 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_4;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_1;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_1;
    return result_0;
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

fn choose_0( table_0 : u32,  count_1 : u32,  number_2 : f32) -> Choice_0
{
    var high_0 : u32 = count_1;
    var low_0 : u32 = u32(0);
    for(;;)
    {
        if((high_0 - low_0) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S192 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S192)) <= number_2)
        {
            low_0 = _S192;
        }
        else
        {
            high_0 = _S192;
        }
    }
    var _S193 : u32 = table_0 + low_0;
    var _S194 : f32 = scene_number_0(_S193);
    var _S195 : f32 = scene_number_0(_S193 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_2 - _S194) / max(_S195 - _S194, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

struct Light_0
{
     is_point_0 : u32,
     x_14 : f32,
     y_7 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_5 : u32) -> Light_0
{
    var record_2 : Light_0;
    record_2.is_point_0 = scene_words_0[first_5];
    record_2.x_14 = (bitcast<f32>((scene_words_0[first_5 + u32(1)])));
    record_2.y_7 = (bitcast<f32>((scene_words_0[first_5 + u32(2)])));
    record_2.z_1 = (bitcast<f32>((scene_words_0[first_5 + u32(3)])));
    record_2.red_0 = (bitcast<f32>((scene_words_0[first_5 + u32(4)])));
    record_2.green_0 = (bitcast<f32>((scene_words_0[first_5 + u32(5)])));
    record_2.blue_0 = (bitcast<f32>((scene_words_0[first_5 + u32(6)])));
    return record_2;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S196 : f32 = value_1 * value_1;
    return _S196 * _S196;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_7 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S197 : f32 = light_1.z;
    if(_S197 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S197, 0.0f), max(dot(light_1, normal_7), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S198 : f32 = dot(direction_4, tangent_6);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S198 * _S198 + 1.0f, roughness_3 * roughness_3));
}

fn mean_attenuation_0( depth_1 : f32) -> f32
{
    if(depth_1 < 0.10000000149011612f)
    {
        return (((depth_1 / 120.0f - 0.0416666679084301f) * depth_1 + 0.1666666716337204f) * depth_1 - 0.5f) * depth_1 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_1)) / depth_1;
}

fn flake_density_0( squared_along_0 : f32,  roughness_4 : f32) -> f32
{
    var _S199 : f32 = roughness_4 * roughness_4;
    var _S200 : f32 = squared_along_0 * (1.0f - _S199) + _S199;
    return 0.31830987334251404f * _S199 * roughness_4 / (_S200 * _S200);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32) -> f32
{
    var _S201 : vec3<f32> = light_2 + view_1;
    var _S202 : f32 = dot(_S201, tangent_7);
    return flake_density_0(min(_S202 * _S202 / max(square_0(_S201), 9.999999960041972e-13f), 1.0f), roughness_5);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_6 : f32,  optical_depth_1 : f32) -> f32
{
    var _S203 : f32 = dot(light_3, normal_8);
    var _S204 : f32 = dot(view_2, normal_8);
    if(((_S203 <= 0.0f) | ((_S204 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S205 : f32 = max(_S203, 9.99999997475242708e-07f);
    var _S206 : f32 = max(_S204, 9.99999997475242708e-07f);
    var _S207 : f32 = projected_area_1(light_3, tangent_8, roughness_6) * _S206 + projected_area_1(view_2, tangent_8, roughness_6) * _S205;
    var _S208 : f32 = optical_depth_1 * _S207 / (_S205 * _S206);
    return 0.25f * density_between_0(light_3, view_2, tangent_8, roughness_6) * (_S208 * mean_attenuation_0(_S208)) * _S205 / _S207;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_7 : f32,  optical_depth_2 : f32) -> f32
{
    var _S209 : f32 = - dot(light_4, normal_9);
    var _S210 : f32 = dot(view_3, normal_9);
    if(((_S209 <= 0.0f) | ((_S210 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S211 : f32 = 1.0f / max(_S210, 9.99999997475242708e-07f);
    var _S212 : f32 = projected_area_1(light_4, tangent_9, roughness_7) / max(_S209, 9.99999997475242708e-07f);
    var _S213 : f32 = projected_area_1(view_3, tangent_9, roughness_7) * _S211;
    return density_between_0(light_4, view_3, tangent_9, roughness_7) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S212, _S213)) * mean_attenuation_0(optical_depth_2 * abs(_S212 - _S213)) * _S211;
}

fn sheen_scale_0( x_15 : f32,  y_8 : f32) -> f32
{
    return (((((0.0f * x_15 + (((((-1.1402510404586792f * y_8 + 0.40672621130943298f) * y_8 + 1.65398800373077393f) * y_8 + -1.29730904102325439f) * y_8 + 0.30570998787879944f) * y_8 + -0.0220868494361639f)) * x_15 + (((((-0.21142719686031342f * y_8 + 1.05947399139404297f) * y_8 + -0.41116121411323547f) * y_8 + -0.93859231472015381f) * y_8 + 0.51606941223144531f) * y_8 + 0.05409301072359085f)) * x_15 + (((((1.22944498062133789f * y_8 + -0.45962560176849365f) * y_8 + -1.63861405849456787f) * y_8 + 1.33565104007720947f) * y_8 + -0.45725581049919128f) * y_8 + 0.08243165910243988f)) * x_15 + (((((0.39779931306838989f * y_8 + -1.18879103660583496f) * y_8 + 0.28251591324806213f) * y_8 + 1.168984055519104f) * y_8 + -0.76864629983901978f) * y_8 + 0.0091691892594099f)) * x_15 + (((((-0.26563560962677002f * y_8 + -0.19379159808158875f) * y_8 + 0.2677634060382843f) * y_8 + 0.00270519289188087f) * y_8 + 0.14349560439586639f) * y_8 + 0.10290180146694183f)) * x_15 + (((((-0.20701569318771362f * y_8 + 0.24526430666446686f) * y_8 + 0.19551840424537659f) * y_8 + 0.07586126774549484f) * y_8 + 0.38894739747047424f) * y_8 + 0.15043120086193085f);
}

fn sheen_shear_0( x_16 : f32,  y_9 : f32) -> f32
{
    return ((((0.0f * x_16 + (((((-0.10608240216970444f * y_9 + 1.99214303493499756f) * y_9 + -1.42255294322967529f) * y_9 + -1.09495604038238525f) * y_9 + 0.59180057048797607f) * y_9 + 0.06902855634689331f)) * x_16 + (((((-0.46220690011978149f * y_9 + -0.29113379120826721f) * y_9 + 1.39025199413299561f) * y_9 + 0.35589990019798279f) * y_9 + -1.17120099067687988f) * y_9 + 0.15940259397029877f)) * x_16 + (((((2.26068711280822754f * y_9 + -3.64728999137878418f) * y_9 + -0.72173482179641724f) * y_9 + 3.07659196853637695f) * y_9 + -0.6827620267868042f) * y_9 + -0.3039557933807373f)) * x_16 + (((((0.81201767921447754f * y_9 + 0.36014080047607422f) * y_9 + -1.72646903991699219f) * y_9 + -0.22630110383033752f) * y_9 + 0.89514690637588501f) * y_9 + -0.10397960245609283f)) * x_16 + (((((-0.37648698687553406f * y_9 + 1.10974001884460449f) * y_9 + 0.17824520170688629f) * y_9 + -1.04968702793121338f) * y_9 + 0.1461234986782074f) * y_9 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_17 : f32,  y_10 : f32) -> f32
{
    return ((((0.0f * x_17 + (((((12.95646953582763672f * y_10 + -21.38032913208007812f) * y_10 + -7.37853097915649414f) * y_10 + 34.55607986450195312f) * y_10 + -23.61347007751464844f) * y_10 + 5.00126314163208008f)) * x_17 + (((((10.91487026214599609f * y_10 + -6.08202791213989258f) * y_10 + -38.2036285400390625f) * y_10 + 53.3440399169921875f) * y_10 + -21.91996002197265625f) * y_10 + 2.01606011390686035f)) * x_17 + (((((-14.52206039428710938f * y_10 + 36.803619384765625f) * y_10 + -22.94047927856445312f) * y_10 + -10.07973003387451172f) * y_10 + 15.77003955841064453f) * y_10 + -4.92722177505493164f)) * x_17 + (((((-7.62505722045898438f * y_10 + 1.27310299873352051f) * y_10 + 31.19523048400878906f) * y_10 + -44.39989852905273438f) * y_10 + 26.44947052001953125f) * y_10 + -8.73507976531982422f)) * x_17 + (((((5.65633487701416016f * y_10 + -17.66820907592773438f) * y_10 + 24.65356063842773438f) * y_10 + -19.38941001892089844f) * y_10 + 11.06159019470214844f) * y_10 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S214 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S215 : f32 = 2.0f * sqrt(_S214) - 1.0f;
    var _S216 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S215, _S216), 0.00999999977648258f, 1.0f), clamp((1.0f - _S214) * sheen_shear_0(_S215, _S216), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S215, _S216), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S217 : f32 = light_5.z;
    if(((_S217 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S218 : vec2<f32> = view_4.xy;
    var _S219 : f32 = dot(_S218, _S218);
    var _S220 : vec2<f32> = select_vector_1(_S219 > 9.99999968265522539e-21f, _S218 * vec2<f32>(rsqrt_0(max(_S219, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S221 : f32 = scale_0 * dot(light_5.xy, _S220) + shear_0 * _S217;
    var _S222 : f32 = scale_0 * (light_5.y * _S220.x - light_5.x * _S220.y);
    var _S223 : f32 = _S221 * _S221 + _S222 * _S222 + _S217 * _S217;
    return 0.31830987334251404f * scale_0 * scale_0 * _S217 / max(_S223 * _S223, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S224 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_9);
    var _S225 : f32 = strength_0 * _S224.z;
    return vec2<f32>(_S225 * transformed_cosine_0(light_6, view_5, _S224.x, _S224.y), 1.0f - _S225);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S226 : f32 = light_7.z;
    return select_vector_0((_S226 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S226) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S227 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S227 * (1.0f - light_8.w);
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

fn uneven_shift_0( _S228 : u32,  _S229 : u32,  _S230 : u32,  _S231 : vec2<f32>) -> f32
{
    var _S232 : f32 = families_0[_S230].period_0 / families_0[_S230].count_0;
    var _S233 : u32 = hash_key_0(_S229, ((fabrics_0[_S228].seed_0) ^ (u32(625341585))));
    var _S234 : vec2<f32> = vec2<f32>(_S231.x, _S231.y / 4.0f) / vec2<f32>(_S232);
    return 0.20000000298023224f * sqrt(families_0[_S230].slub_0) * _S232 * (uneven_octave_0(_S233, _S234) * 0.66666668653488159f + uneven_octave_0(_S233 + u32(1), vec2<f32>(2.0f) * _S234 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S235 : u32,  _S236 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S235].has_detail_0) == u32(0), _S236, _S236 + vec2<f32>(uneven_shift_0(_S235, u32(0), fabrics_0[_S235].warp_0, _S236), uneven_shift_0(_S235, u32(1), fabrics_0[_S235].weft_0, _S236.yx)));
}

fn face_point_0( _S237 : u32,  _S238 : u32,  _S239 : f32,  _S240 : f32) -> VisiblePoint_0
{
    var _S241 : u32 = u32(3) * _S238;
    var _S242 : Vertex_0 = vertex_at_0(_S241);
    var _S243 : Vertex_0 = vertex_at_0(_S241 + u32(1));
    var _S244 : Vertex_0 = vertex_at_0(_S241 + u32(2));
    var _S245 : vec3<f32> = position_of_0(_S242);
    var _S246 : vec3<f32> = position_of_0(_S243) - _S245;
    var _S247 : vec3<f32> = position_of_0(_S244) - _S245;
    var _S248 : f32 = _S243.u_0 - _S242.u_0;
    var _S249 : f32 = _S243.v_0 - _S242.v_0;
    var _S250 : vec2<f32> = vec2<f32>(_S248, _S249);
    var _S251 : f32 = _S244.u_0 - _S242.u_0;
    var _S252 : f32 = _S244.v_0 - _S242.v_0;
    var _S253 : vec2<f32> = vec2<f32>(_S251, _S252);
    var _S254 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S248 * _S252 - _S249 * _S251) < 0.0f));
    var _S255 : vec3<f32> = _S254 * (vec3<f32>(_S252) * _S246 - vec3<f32>(_S249) * _S247);
    var _S256 : vec3<f32> = _S254 * (vec3<f32>(_S248) * _S247 - vec3<f32>(_S251) * _S246);
    var point_2 : VisiblePoint_0;
    var _S257 : vec3<f32> = vec3<f32>(_S239);
    var _S258 : vec3<f32> = vec3<f32>(_S240);
    var _S259 : vec3<f32> = normalize(vec3<f32>((1.0f - _S239 - _S240)) * normal_of_0(_S242) + _S257 * normal_of_0(_S243) + _S258 * normal_of_0(_S244));
    point_2.normal_0 = _S259;
    var _S260 : vec3<f32> = normalize(_S255 - _S259 * vec3<f32>(dot(_S259, _S255)));
    point_2.axis_x_0 = _S260;
    point_2.axis_y_0 = cross(_S259, _S260);
    var _S261 : vec3<f32> = normalize(cross(_S246, _S247));
    point_2.face_normal_0 = select_vector_0((dot(_S261, _S259)) < 0.0f, (vec3<f32>(0) - _S261), _S261);
    point_2.position_4 = _S245 + _S257 * _S246 + _S258 * _S247;
    point_2.view_0 = _S259;
    var _S262 : vec2<f32> = vec2<f32>(_S242.u_0, _S242.v_0) + vec2<f32>(_S239) * _S250 + vec2<f32>(_S240) * _S253;
    point_2.uv_1 = _S262;
    var _S263 : bool = (dot(cross(_S255, _S256), _S259)) < 0.0f;
    var _S264 : vec2<f32> = vec2<f32>(fabrics_0[_S237].uv_width_0, select(fabrics_0[_S237].uv_height_0, - fabrics_0[_S237].uv_height_0, _S263));
    point_2.draft_per_uv_0 = _S264;
    point_2.draft_0 = uneven_place_0(_S237, _S262 * _S264 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S237].uv_height_0, _S263)));
    var _S265 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S265;
    point_2.draft_dy_0 = _S265;
    return point_2;
}

fn visible_point_0( _S266 : u32,  _S267 : u32,  _S268 : vec2<u32>) -> VisiblePoint_0
{
    var _S269 : u32 = u32(3) * _S267;
    var _S270 : Vertex_0 = vertex_at_0(_S269);
    var _S271 : Vertex_0 = vertex_at_0(_S269 + u32(1));
    var _S272 : Vertex_0 = vertex_at_0(_S269 + u32(2));
    var _S273 : vec3<f32> = position_of_0(_S270);
    var _S274 : vec3<f32> = position_of_0(_S271) - _S273;
    var _S275 : vec3<f32> = position_of_0(_S272) - _S273;
    var _S276 : vec3<f32> = cross(_S274, _S275);
    var _S277 : f32 = f32(frame_record_0.width_0);
    var _S278 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S277));
    var _S279 : f32 = f32(frame_record_0.height_0);
    var _S280 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S279));
    var _S281 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S268.x) + 0.5f - 0.5f * _S277)) * _S278 + vec3<f32>((f32(_S268.y) + 0.5f - 0.5f * _S279)) * _S280;
    var _S282 : f32 = dot(_S281, _S276);
    var _S283 : f32 = 1.0f / select(1.00000000317107685e-30f, _S282, (abs(_S282)) > 1.00000000317107685e-30f);
    var _S284 : vec3<f32> = _S273 - camera_origin_0();
    var _S285 : vec3<f32> = vec3<f32>((dot(_S284, _S276) * _S283));
    var _S286 : vec3<f32> = _S281 * _S285 - _S284;
    var _S287 : vec3<f32> = _S285 * (_S278 - _S281 * vec3<f32>((dot(_S278, _S276) * _S283)));
    var _S288 : vec3<f32> = _S285 * (_S280 - _S281 * vec3<f32>((dot(_S280, _S276) * _S283)));
    var _S289 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S276), 1.00000000317107685e-30f)));
    var _S290 : vec3<f32> = cross(_S275, _S276) * _S289;
    var _S291 : vec3<f32> = cross(_S276, _S274) * _S289;
    var _S292 : vec2<f32> = vec2<f32>(_S271.u_0 - _S270.u_0, _S271.v_0 - _S270.v_0);
    var _S293 : vec2<f32> = vec2<f32>(_S272.u_0 - _S270.u_0, _S272.v_0 - _S270.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S266, _S267, dot(_S286, _S290), dot(_S286, _S291));
    point_3.position_4 = _S273 + _S286;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S281));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S287, _S290)) * _S292 + vec2<f32>(dot(_S287, _S291)) * _S293) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S288, _S290)) * _S292 + vec2<f32>(dot(_S288, _S291)) * _S293) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S294 : u32,  _S295 : VisiblePoint_0) -> vec3<f32>
{
    var _S296 : u32 = fabrics_0[_S294].albedo_map_levels_0;
    if((fabrics_0[_S294].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S297 : vec2<f32> = vec2<f32>(fabrics_0[_S294].uv_width_0, fabrics_0[_S294].uv_height_0);
    var _S298 : vec2<f32> = _S295.draft_dx_0 / _S297;
    var _S299 : vec2<f32> = _S295.draft_dy_0 / _S297;
    var _S300 : u32 = _S296 - u32(1);
    var _S301 : u32 = (u32(1) << (_S300));
    var _S302 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S298.x * _S299.y - _S298.y * _S299.x), 9.99999968265522539e-21f) * (square_1(f32(_S301)) / 3.0f)), 0.0f, f32(_S296) - 1.0f);
    var _S303 : u32 = min(u32(_S302), max(_S296, u32(2)) - u32(2));
    var _S304 : u32 = min(_S303 + u32(1), _S300);
    var _S305 : u32 = (u32(1) << ((u32(2) * _S296)));
    return mix(map_level_0(fabrics_0[_S294].albedo_map_0 + (_S305 - ((_S305 >> ((u32(2) * _S303))))) / u32(3), (_S301 >> (_S303)), _S295.uv_1), map_level_0(fabrics_0[_S294].albedo_map_0 + (_S305 - ((_S305 >> ((u32(2) * _S304))))) / u32(3), (_S301 >> (_S304)), _S295.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S302 - f32(_S303))) - 1.0f) / 3.0f)));
}

fn is_layered_0( _S306 : u32) -> bool
{
    return (HAS_LAYERS_0 & (((fabrics_0[_S306].planes_0) != u32(0))));
}

fn irregular_key_0( _S307 : u32,  _S308 : u32) -> u32
{
    return hash_key_0(_S308, ((fabrics_0[_S307].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S309 : u32,  _S310 : vec2<f32>,  _S311 : f32) -> vec2<f32>
{
    var _S312 : u32 = fabrics_0[_S309].warp_0;
    var _S313 : u32 = fabrics_0[_S309].weft_0;
    var _S314 : bool = (((((fabrics_0[_S309].is_irregular_0) != u32(0)) & ((!is_layered_0(_S309))))) & (((max(moved_share_0(fabrics_0[_S309].warp_0, _S311), moved_share_0(fabrics_0[_S309].weft_0, _S311))) > 0.0f)));
    var number_3 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S310;
    for(;;)
    {
        if(number_3 < select(u32(0), u32(2), _S314))
        {
        }
        else
        {
            break;
        }
        var _S315 : bool = number_3 == u32(0);
        var _S316 : u32 = select(_S313, _S312, _S315);
        var _S317 : vec2<f32> = select_vector_1(_S315, _S310, _S310.yx);
        var _S318 : u32 = irregular_key_0(_S309, number_3);
        var _S319 : f32 = _S317.x;
        var _S320 : Cell_0 = locate_0(_S316, _S319);
        var _S321 : f32 = irregular_thread_0(_S316, _S319, _S320);
        var _S322 : f32 = select(1.0f, -1.0f, (_S320.across_0) < 0.0f);
        var _S323 : vec2<f32> = vec2<f32>(0.0f);
        var other_2 : vec2<f32> = _S323;
        var own_1 : vec2<f32> = _S323;
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
            var _S324 : vec2<f32> = irregular_at_0(_S316, _S318, _S321 + _S322 * f32(neighbour_0), _S317.y).xy;
            var _S325 : u32 = neighbour_0 + u32(1);
            own_1 = other_2;
            other_2 = _S324;
            neighbour_0 = _S325;
        }
        var _S326 : f32 = _S320.below_0 + _S320.above_0;
        var _S327 : f32 = min(_S320.half_width_1 / _S326, 0.5f);
        var _S328 : f32 = min(_S327 * (2.0f + own_1.y + other_2.y), 1.0f);
        var _S329 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_2.x), vec2<f32>(0.25f)));
        var _S330 : f32 = _S329.x;
        var _S331 : f32 = _S328 * _S330 / (_S330 + _S329.y);
        var _S332 : f32 = abs(_S320.across_0) / _S326;
        var _S333 : f32 = 1.0f - _S328;
        var _S334 : f32 = _S332 - _S331;
        var _S335 : f32 = moved_share_0(_S316, _S311) * _S322 * _S326 * (select(select((_S334 - _S333) / max(_S328 - _S331, 9.99999997475242708e-07f) * _S327 + (1.0f - _S327), _S334 / max(_S333, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S327) + _S327, _S334 < _S333), _S332 * _S327 / _S331, _S334 < 0.0f) - _S332);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S315, vec2<f32>(_S335, 0.0f), vec2<f32>(0.0f, _S335));
        number_3 = number_3 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct Hit_0
{
     x_18 : f32,
     y_11 : f32,
     hole_5 : bool,
     height_8 : f32,
};

fn whole_plane_0( _S336 : u32) -> Plane_0
{
    var plane_7 : Plane_0;
    plane_7.warp_1 = fabrics_0[_S336].warp_0;
    plane_7.weft_1 = fabrics_0[_S336].weft_0;
    plane_7.run_words_1 = fabrics_0[_S336].run_words_0;
    plane_7.ends_2 = fabrics_0[_S336].ends_1;
    plane_7.end_numbers_0 = u32(0);
    plane_7.pick_numbers_0 = u32(0);
    plane_7.max_heights_1 = fabrics_0[_S336].max_heights_0;
    plane_7.max_height_columns_1 = fabrics_0[_S336].max_height_columns_0;
    plane_7.height_low_1 = fabrics_0[_S336].height_low_0;
    plane_7.height_high_1 = fabrics_0[_S336].height_high_0;
    plane_7.front_level_0 = 0.0f;
    plane_7.back_level_0 = 0.0f;
    plane_7.start_x_0 = 0.0f;
    plane_7.start_y_0 = 0.0f;
    plane_7.fine_x_0 = 0.0f;
    plane_7.fine_y_0 = 0.0f;
    return plane_7;
}

fn plane_order_0( _S337 : u32,  _S338 : f32,  _S339 : f32,  _S340 : bool) -> u32
{
    var _S341 : u32 = select(u32(0), locate_varied_0(fabrics_0[_S337].plane_axes_0 + u32(1), _S339).thread_2 * fabrics_0[_S337].ends_1 + locate_varied_0(fabrics_0[_S337].plane_axes_0, _S338).thread_2, (fabrics_0[_S337].stacks_0) > u32(1));
    return fabrics_0[_S337].plane_orders_0 + u32(2) * fabrics_0[_S337].planes_0 * (u32(2) * ((((words_0[fabrics_0[_S337].regions_0 + _S341 / u32(4)] >> ((u32(8) * (_S341 % u32(4)))))) & (u32(255)))) + select(u32(0), u32(1), _S340));
}

fn first_bounds_0( _S342 : u32,  _S343 : u32,  _S344 : f32,  _S345 : f32,  _S346 : bool,  _S347 : bool,  _S348 : bool) -> vec3<f32>
{
    var _S349 : vec3<f32> = bounds_in_0(plane_at_0(fabrics_0[_S342].plane_records_0 + words_0[_S343] * u32(16)), _S344, _S345, _S346, _S347, _S348);
    var _S350 : Cell_0 = locate_varied_0(fabrics_0[_S342].plane_axes_0, _S344);
    var _S351 : Cell_0 = locate_varied_0(fabrics_0[_S342].plane_axes_0 + u32(1), _S345);
    var _S352 : bool = (fabrics_0[_S342].stacks_0) == u32(1);
    return vec3<f32>(_S349.x + table_number_0(_S343 + u32(1)), min(_S349.y, select(select(_S350.below_0, _S350.above_0, _S347), 1.0e+06f, _S352)), min(_S349.z, select(select(_S351.below_0, _S351.above_0, _S348), 1.0e+06f, _S352)));
}

fn plane_shown_0( _S353 : u32,  _S354 : f32,  _S355 : f32,  _S356 : bool,  _S357 : bool,  _S358 : bool) -> PlaneHere_0
{
    var here_6 : PlaneHere_0;
    here_6.plane_3 = whole_plane_0(_S353);
    here_6.number_1 = u32(0);
    here_6.level_1 = 0.0f;
    here_6.edge_x_0 = 1.0e+06f;
    here_6.edge_y_0 = 1.0e+06f;
    here_6.bounds_0 = vec3<f32>(0.0f);
    if(!is_layered_0(_S353))
    {
        return here_6;
    }
    var _S359 : u32 = plane_order_0(_S353, _S354, _S355, _S356);
    var _S360 : vec3<f32> = first_bounds_0(_S353, _S359, _S354, _S355, _S356, _S357, _S358);
    here_6.bounds_0 = _S360;
    var _S361 : bool = (fabrics_0[_S353].stacks_0) == u32(1);
    here_6.edge_x_0 = select(_S360.y, 1.0e+06f, _S361);
    here_6.edge_y_0 = select(_S360.z, 1.0e+06f, _S361);
    var is_hole_0 : bool = true;
    var rank_1 : u32 = u32(0);
    for(;;)
    {
        if(((rank_1 < (fabrics_0[_S353].planes_0)) & (is_hole_0)))
        {
        }
        else
        {
            break;
        }
        var _S362 : u32 = _S359 + u32(2) * rank_1;
        var _S363 : u32 = words_0[_S362];
        here_6.number_1 = _S363;
        here_6.level_1 = table_number_0(_S362 + u32(1));
        here_6.plane_3 = plane_at_0(fabrics_0[_S353].plane_records_0 + _S363 * u32(16));
        var _S364 : Cell_0 = locate_varied_0(here_6.plane_3.warp_1, _S354 - here_6.plane_3.start_x_0);
        var _S365 : Cell_0 = locate_varied_0(here_6.plane_3.weft_1, _S355 - here_6.plane_3.start_y_0);
        var is_hole_1 : bool = !((((abs(_S364.across_0)) < (_S364.half_width_1)) | (((abs(_S365.across_0)) < (_S365.half_width_1)))));
        here_6.edge_x_0 = min(here_6.edge_x_0, select(1.0e+06f, hole_edge_0(_S364, _S357), is_hole_1));
        here_6.edge_y_0 = min(here_6.edge_y_0, select(1.0e+06f, hole_edge_0(_S365, _S358), is_hole_1));
        var _S366 : u32 = rank_1 + u32(1);
        is_hole_0 = is_hole_1;
        rank_1 = _S366;
    }
    return here_6;
}

fn sample_at_0( _S367 : u32,  _S368 : f32,  _S369 : f32,  _S370 : bool) -> Sample_0
{
    return sample_in_0(plane_shown_0(_S367, _S368, _S369, _S370, true, true), _S368, _S369, _S370);
}

fn steps_per_length_0( _S371 : u32,  _S372 : SearchQuality_0,  _S373 : vec3<f32>) -> f32
{
    return max(max(abs(_S373.x) * fabrics_0[_S371].threads_per_x_0, abs(_S373.y) * fabrics_0[_S371].threads_per_y_0) * _S372.steps_per_thread_0, abs(_S373.z) * fabrics_0[_S371].per_relief_0 * _S372.steps_per_relief_0);
}

fn plane_count_0( _S374 : u32) -> u32
{
    return select(u32(1), fabrics_0[_S374].planes_0, is_layered_0(_S374));
}

fn probe_0( _S375 : u32,  _S376 : f32,  _S377 : f32,  _S378 : bool,  _S379 : bool,  _S380 : bool) -> Probe_0
{
    var _S381 : PlaneHere_0 = plane_shown_0(_S375, _S376, _S377, _S378, _S379, _S380);
    var _S382 : Sample_0 = sample_in_0(_S381, _S376, _S377, _S378);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S382.height_2;
    probe_1.hole_1 = _S382.shown_2.hole_0;
    probe_1.slope_x_1 = _S382.slope_x_0;
    probe_1.slope_y_1 = _S382.slope_y_0;
    var _S383 : bool = !is_layered_0(_S375);
    probe_1.yarn_1 = select(_S382.crossing_3.weft_2.thread_2 * u32(2), _S382.crossing_3.warp_2.thread_2 * u32(2) + u32(1), _S382.shown_2.is_warp_0) * plane_count_0(_S375) + _S381.number_1;
    probe_1.cell_max_0 = select(_S381.bounds_0.x, cell_maximum_0(_S381.plane_3, _S382.crossing_3), _S383);
    probe_1.side_x_0 = select(_S381.bounds_0.y, select(_S382.crossing_3.warp_2.below_0, _S382.crossing_3.warp_2.above_0, _S379), _S383);
    probe_1.side_y_0 = select(_S381.bounds_0.z, select(_S382.crossing_3.weft_2.below_0, _S382.crossing_3.weft_2.above_0, _S380), _S383);
    probe_1.edge_x_1 = min(_S381.edge_x_0, outline_distance_0(_S382.crossing_3.warp_2, _S382.shown_2, _S382.run_2, !_S382.shown_2.is_warp_0, _S379));
    probe_1.edge_y_1 = min(_S381.edge_y_0, outline_distance_0(_S382.crossing_3.weft_2, _S382.shown_2, _S382.run_2, _S382.shown_2.is_warp_0, _S380));
    return probe_1;
}

fn is_free_0( _S384 : u32,  _S385 : SearchQuality_0,  _S386 : vec3<f32>,  _S387 : vec3<f32>,  _S388 : bool,  _S389 : f32) -> bool
{
    var _S390 : f32 = _S387.z;
    if(_S390 <= 0.0f)
    {
        return false;
    }
    var _S391 : f32 = 1.0f / max(_S385.shadow_share_0 * steps_per_length_0(_S384, _S385, _S387), 9.99999971718068537e-10f);
    var _S392 : StepControl_0 = step_control_0(_S387.xy, _S391);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S386.z + _S390 * distance_1) < _S389))))
        {
        }
        else
        {
            break;
        }
        var _S393 : vec3<f32> = _S386 + _S387 * vec3<f32>(distance_1);
        var _S394 : Probe_0 = probe_0(_S384, _S393.x, _S393.y, _S388, _S392.right_1, _S392.up_1);
        var _S395 : f32 = _S393.z;
        var _S396 : f32 = _S395 - _S394.height_3;
        var _S397 : f32 = _S390 - _S394.slope_x_1 * _S387.x - _S394.slope_y_1 * _S387.y;
        if(((!_S394.hole_1) & ((_S396 < 0.0f))))
        {
            return false;
        }
        var _S398 : f32 = way_back_to_dip_0(previous_3, _S396, _S397, last_step_0, _S394);
        if(_S398 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S398;
            distance_1 = distance_1 - _S398;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S399 : bool = _S395 > (_S394.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S392, _S394, _S396, _S397), max(StepControl_to_cell_exit_0(_S392, _S394.side_x_0, _S394.side_y_0), _S391), _S399);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S396, _S397, _S394, _S399);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S400 : u32,  _S401 : SearchQuality_0,  _S402 : f32,  _S403 : f32,  _S404 : vec3<f32>,  _S405 : bool) -> bool
{
    if(!sample_at_0(_S400, _S402, _S403, _S405).shown_2.hole_0)
    {
        return false;
    }
    var _S406 : vec3<f32> = vec3<f32>(_S402, _S403, 0.0f);
    var passes_0 : bool = true;
    var side_2 : u32 = u32(0);
    for(;;)
    {
        if(((side_2 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S407 : bool = is_free_0(_S400, _S401, _S406, select_vector_0(side_2 == u32(0), _S404, vec3<f32>(- _S404.x, - _S404.y, _S404.z)), _S405 != (side_2 == u32(1)), fabrics_0[_S400].height_high_0);
        var _S408 : u32 = side_2 + u32(1);
        passes_0 = _S407;
        side_2 = _S408;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_9 : f32,
     last_step_3 : f32,
     depth_2 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn plane_of_0( _S409 : u32,  _S410 : u32) -> Plane_0
{
    if(!is_layered_0(_S409))
    {
        return whole_plane_0(_S409);
    }
    return plane_at_0(fabrics_0[_S409].plane_records_0 + _S410 * u32(16));
}

fn max_height_along_0( _S411 : u32,  _S412 : f32,  _S413 : f32,  _S414 : f32,  _S415 : vec3<f32>,  _S416 : bool) -> f32
{
    var _S417 : f32 = _S415.x;
    var _S418 : f32 = _S415.y;
    var _S419 : u32 = select(u32(0), u32(1), _S417 > 0.0f) + select(u32(0), u32(2), _S418 > 0.0f);
    var _S420 : f32 = max(abs(_S417) * fabrics_0[_S411].threads_per_x_0, abs(_S418) * fabrics_0[_S411].threads_per_y_0) / _S415.z;
    var levels_4 : vec4<f32> = vec4<f32>(-1.00000001504746622e+30f);
    var number_4 : u32 = u32(0);
    for(;;)
    {
        if(number_4 < (plane_count_0(_S411)))
        {
        }
        else
        {
            break;
        }
        var _S421 : Plane_0 = plane_of_0(_S411, number_4);
        var _S422 : u32 = (words_0[_S421.max_heights_1 + u32(4) * (locate_0(_S421.weft_1, _S413 - _S421.start_y_0).thread_2 / u32(2) * _S421.max_height_columns_1 + locate_0(_S421.warp_1, _S412 - _S421.start_x_0).thread_2 / u32(2)) + _S419] >> (u32(select(i32(0), i32(4), _S416))));
        var _S423 : vec4<f32> = max(levels_4, vec4<f32>(f32((_S422 & (u32(15)))), f32((((_S422 >> (u32(8)))) & (u32(15)))), f32((((_S422 >> (u32(16)))) & (u32(15)))), f32((((_S422 >> (u32(24)))) & (u32(15))))) * vec4<f32>(0.06666667014360428f) * vec4<f32>(_S421.height_high_1) + vec4<f32>(select(_S421.front_level_0, _S421.back_level_0, _S416)));
        var _S424 : u32 = number_4 + u32(1);
        levels_4 = _S423;
        number_4 = _S424;
    }
    var max_height_0 : f32 = fabrics_0[_S411].height_high_0;
    var number_5 : i32 = i32(3);
    for(;;)
    {
        if(number_5 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S414) * _S420) <= (PYRAMID_RADII_0[number_5]))
        {
            max_height_0 = min(max_height_0, levels_4[number_5]);
        }
        number_5 = number_5 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S425 : u32,  _S426 : f32,  _S427 : f32,  _S428 : bool,  _S429 : bool,  _S430 : bool) -> vec3<f32>
{
    if(is_layered_0(_S425))
    {
        return first_bounds_0(_S425, plane_order_0(_S425, _S426, _S427, _S428), _S426, _S427, _S428, _S429, _S430);
    }
    return bounds_in_0(whole_plane_0(_S425), _S426, _S427, _S428, _S429, _S430);
}

fn first_sample_height_0( _S431 : u32,  _S432 : ViewRay_0,  _S433 : StepControl_0,  _S434 : bool) -> f32
{
    var _S435 : f32 = max_height_along_0(_S431, _S432.origin_0.x, _S432.origin_0.y, 0.0f, vec3<f32>(_S432.slope_1, 1.0f), _S434);
    var count_3 : u32 = u32(0);
    var height_10 : f32 = _S435;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S436 : vec2<f32> = ViewRay_at_0(_S432, height_10);
        var _S437 : vec3<f32> = cell_bounds_0(_S431, _S436.x, _S436.y, _S434, _S433.right_1, _S433.up_1);
        var _S438 : f32 = height_10 - _S437.x;
        var _S439 : f32 = StepControl_to_cell_exit_0(_S433, _S437.y, _S437.z);
        var height_11 : f32 = height_10 - clamp(_S438, 0.0f, _S439);
        if(_S438 <= _S439)
        {
            height_10 = height_11;
            break;
        }
        count_3 = count_3 + u32(1);
        height_10 = height_11;
    }
    return height_10;
}

fn search_down_0( _S440 : u32,  _S441 : ViewRay_0,  _S442 : StepControl_0,  _S443 : bool) -> ViewRayEnd_0
{
    var _S444 : f32 = fabrics_0[_S440].height_low_0 - (fabrics_0[_S440].height_high_0 - fabrics_0[_S440].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_9 = first_sample_height_0(_S440, _S441, _S442, _S443);
    end_1.last_step_3 = _S442.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_2 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_4 : u32 = u32(0);
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S445 : vec2<f32> = ViewRay_at_0(_S441, end_1.height_9);
        var _S446 : Probe_0 = probe_0(_S440, _S445.x, _S445.y, _S443, _S442.right_1, _S442.up_1);
        var _S447 : f32 = end_1.height_9 - _S446.height_3;
        var _S448 : f32 = ViewRay_rate_0(_S441, _S446);
        end_1.depth_2 = - _S447;
        end_1.rate_4 = _S448;
        var _S449 : bool = !_S446.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S449))) & (((end_1.previous_4.yarn_0) == (_S446.yarn_1))));
        if((((_S449 & ((_S447 <= 0.0f)))) | (((end_1.height_9) <= _S444))))
        {
            break;
        }
        var _S450 : f32 = way_back_to_dip_0(end_1.previous_4, _S447, _S448, end_1.last_step_3, _S446);
        if(_S450 >= 0.0f)
        {
            end_1.height_9 = end_1.height_9 + _S450;
            end_1.last_step_3 = end_1.last_step_3 - _S450;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S451 : f32 = min(StepControl_to_cell_exit_0(_S442, _S446.side_x_0, _S446.side_y_0), end_1.height_9 - _S446.cell_max_0);
        var _S452 : f32 = StepControl_to_next_sample_0(_S442, _S446, _S447, _S448);
        end_1.previous_4 = after_sample_0(_S447, _S448, _S446, _S451 > _S452);
        var _S453 : f32 = max(_S451, _S452);
        end_1.last_step_3 = _S453;
        end_1.height_9 = end_1.height_9 - _S453;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S454 : u32,  _S455 : ViewRay_0,  _S456 : StepControl_0,  _S457 : bool,  _S458 : ViewRayEnd_0,  _S459 : u32) -> f32
{
    var _S460 : f32 = fabrics_0[_S454].height_high_0 - fabrics_0[_S454].height_low_0;
    var above_2 : f32 = _S458.height_9 + _S458.last_step_3;
    var above_gap_1 : f32 = clamp(_S458.previous_4.clearance_0, 0.0f, _S460);
    var under_gap_1 : f32 = clamp(_S458.depth_2, 0.0f, _S460);
    var middle_0 : f32 = select(between_0(above_2, _S458.height_9, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S458.previous_4.rate_0 * _S458.last_step_3, _S458.rate_4 * _S458.last_step_3) * _S458.last_step_3, _S458.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S458.height_9;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S459)
        {
        }
        else
        {
            break;
        }
        var _S461 : vec2<f32> = ViewRay_at_0(_S455, middle_0);
        var _S462 : Probe_0 = probe_0(_S454, _S461.x, _S461.y, _S457, _S456.right_1, _S456.up_1);
        var _S463 : f32 = clamp(middle_0 - select(_S462.height_3, -1.0e+09f, _S462.hole_1), - _S460, _S460);
        if(_S463 <= 0.0f)
        {
            var _S464 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S465 : f32 = - _S463;
            under_1 = middle_0;
            above_gap_2 = _S464;
            under_gap_2 = _S465;
            side_3 = 1.0f;
        }
        else
        {
            var _S466 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S463;
            under_gap_2 = _S466;
            side_3 = -1.0f;
        }
        var _S467 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S463 / min(ViewRay_rate_0(_S455, _S462), -9.99999997475242708e-07f), under_1, above_3), _S458.smooth_0);
        var _S468 : u32 = i_1 + u32(1);
        middle_0 = _S467;
        i_1 = _S468;
    }
    return select(under_1, middle_0, _S458.smooth_0);
}

fn first_hit_of_yarn_0( _S469 : u32,  _S470 : SearchQuality_0,  _S471 : f32,  _S472 : f32,  _S473 : vec3<f32>,  _S474 : bool) -> Hit_0
{
    var _S475 : f32 = max(_S473.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S471, _S472);
    var _S476 : vec2<f32> = _S473.xy / vec2<f32>(_S475);
    ray_0.slope_1 = _S476;
    var _S477 : StepControl_0 = step_control_0((vec2<f32>(0) - _S476), 1.0f / max(steps_per_length_0(_S469, _S470, _S473) / _S475, 9.99999971718068537e-10f));
    var _S478 : ViewRayEnd_0 = search_down_0(_S469, ray_0, _S477, _S474);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S479 : f32 = refined_height_0(_S469, ray_0, _S477, _S474, _S478, _S470.refinements_0);
    hit_0.height_8 = _S479;
    var _S480 : vec2<f32> = ViewRay_at_0(ray_0, _S479);
    hit_0.x_18 = _S480.x;
    hit_0.y_11 = _S480.y;
    return hit_0;
}

fn first_hit_0( _S481 : u32,  _S482 : SearchQuality_0,  _S483 : f32,  _S484 : f32,  _S485 : vec3<f32>,  _S486 : bool) -> Hit_0
{
    if(!passes_through_0(_S481, _S482, _S483, _S484, _S485, _S486))
    {
        return first_hit_of_yarn_0(_S481, _S482, _S483, _S484, _S485, _S486);
    }
    var hit_1 : Hit_0;
    hit_1.x_18 = _S483;
    hit_1.y_11 = _S484;
    hit_1.height_8 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_of_0( _S487 : u32,  _S488 : Sample_0,  _S489 : f32,  _S490 : f32,  _S491 : bool) -> SurfacePoint_0
{
    var _S492 : u32 = select(fabrics_0[_S487].weft_0, fabrics_0[_S487].warp_0, _S488.shown_2.is_warp_0);
    var _S493 : f32 = families_0[_S492].twist_sine_0 * select(1.0f, -1.0f, _S491);
    var _S494 : f32 = families_0[_S492].twist_cosine_0;
    var _S495 : f32 = select(-1.0f, 1.0f, _S488.shown_2.is_warp_0);
    var _S496 : vec2<f32> = fibre_direction_0(_S488.slope_across_0, _S495 * _S488.slope_along_0, _S493, families_0[_S492].twist_cosine_0);
    var _S497 : f32 = _S496.x;
    var _S498 : f32 = _S496.y;
    var _S499 : f32 = select(_S488.slope_y_0, _S488.slope_x_0, _S488.shown_2.is_warp_0) * _S497 + _S495 * select(_S488.slope_x_0, _S488.slope_y_0, _S488.shown_2.is_warp_0) * _S498;
    var _S500 : f32 = select(_S488.crossing_3.weft_2.half_width_1, _S488.crossing_3.warp_2.half_width_1, _S488.shown_2.is_warp_0) * 1.0154266357421875f;
    var _S501 : f32 = _S500 * arc_sine_0(clamp(_S488.section_1.across_1 / _S500, -1.0f, 1.0f));
    var _S502 : f32 = select(_S488.here_0.plane_3.start_x_0 - _S489, _S490 - _S488.here_0.plane_3.start_y_0, _S488.shown_2.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_4 = _S488.shown_2.hole_0;
    point_4.is_warp_5 = _S488.shown_2.is_warp_0;
    point_4.warp_thread_0 = _S488.crossing_3.warp_2.thread_2;
    point_4.weft_thread_0 = _S488.crossing_3.weft_2.thread_2;
    if(is_layered_0(_S487))
    {
        point_4.warp_thread_0 = words_0[_S488.here_0.plane_3.end_numbers_0 + point_4.warp_thread_0];
        point_4.weft_thread_0 = words_0[_S488.here_0.plane_3.pick_numbers_0 + point_4.weft_thread_0];
    }
    point_4.height_7 = _S488.height_2;
    point_4.plane_6 = _S488.here_0.level_1;
    point_4.layer_0 = _S488.here_0.number_1;
    point_4.normal_5 = normalize(vec3<f32>(- _S488.slope_x_0, - _S488.slope_y_0, 1.0f));
    point_4.tangent_4 = normalize(select_vector_0(_S488.shown_2.is_warp_0, vec3<f32>(_S497, _S498, _S499), vec3<f32>(- _S498, _S497, _S499)));
    point_4.across_2 = _S488.section_1.across_1;
    point_4.fibre_across_0 = _S501 * _S494 + _S502 * _S493;
    point_4.fibre_along_0 = _S502 * _S494 - _S501 * _S493;
    var _S503 : f32 = run_share_0(_S488.shown_2.word_0);
    point_4.shown_share_0 = select(1.0f - _S503, _S503, _S488.shown_2.on_top_0);
    point_4.x_13 = _S489;
    point_4.y_6 = _S490;
    return point_4;
}

fn surface_met_0( _S504 : u32,  _S505 : f32,  _S506 : f32,  _S507 : f32,  _S508 : vec3<f32>,  _S509 : bool) -> SurfacePoint_0
{
    var _S510 : Sample_0 = sample_at_0(_S504, _S505, _S506, _S509);
    var point_5 : SurfacePoint_0 = surface_of_0(_S504, _S510, _S505, _S506, _S509);
    var _S511 : u32 = select(fabrics_0[_S504].weft_0, fabrics_0[_S504].warp_0, point_5.is_warp_5);
    var _S512 : f32 = select(_S510.crossing_3.weft_2.half_width_1, _S510.crossing_3.warp_2.half_width_1, point_5.is_warp_5) * 1.0154266357421875f;
    var _S513 : f32 = _S510.dive_1.z;
    var _S514 : f32 = _S510.slope_along_0 - (1.0f - _S513) * _S510.dive_1.y / families_0[_S511].height_scale_0;
    var _S515 : f32 = rsqrt_0(_S514 * _S514 + 1.0f);
    var _S516 : f32 = _S508.x;
    var _S517 : f32 = _S508.y;
    var _S518 : f32 = select(_S517, _S516, point_5.is_warp_5);
    var _S519 : f32 = _S508.z;
    var _S520 : f32 = (_S519 / families_0[_S511].height_scale_0 - _S514 * select(_S516, _S517, point_5.is_warp_5)) * _S515;
    var _S521 : f32 = square_1(_S512);
    var _S522 : f32 = sqrt(max(_S521 - square_1(point_5.across_2), 0.0f)) - (_S510.height_2 + _S513 * _S510.dive_1.x - _S507) / families_0[_S511].height_scale_0 * _S515;
    var _S523 : f32 = square_1(_S518) + square_1(_S520) + 9.999999960041972e-13f;
    var _S524 : f32 = point_5.across_2 * _S518 + _S522 * _S520;
    var _S525 : f32 = square_1(point_5.across_2) + square_1(_S522) - _S521;
    var _S526 : f32 = sqrt(max(square_1(_S524) - _S523 * _S525, 0.0f));
    var _S527 : f32 = clamp(select((_S526 - _S524) / _S523, - _S525 / max(_S524 + _S526, 9.999999960041972e-13f), _S524 > 0.0f), - _S512, _S512);
    var _S528 : f32 = point_5.across_2 + _S527 * _S518;
    point_5.across_2 = _S528;
    var _S529 : vec2<f32> = normalize(vec2<f32>(_S528, _S522 + _S527 * _S520));
    var _S530 : f32 = select(-1.0f, 1.0f, point_5.is_warp_5);
    var _S531 : f32 = families_0[_S511].twist_sine_0 * select(1.0f, -1.0f, _S509);
    var _S532 : f32 = _S529.x;
    var _S533 : f32 = _S531 * _S532 * _S515;
    var _S534 : f32 = _S529.y;
    var _S535 : f32 = - _S531 * _S534;
    var _S536 : f32 = families_0[_S511].twist_cosine_0 * _S515 - _S530 * _S514 * _S533;
    var _S537 : f32 = families_0[_S511].height_scale_0 * (families_0[_S511].twist_cosine_0 * _S530 * _S514 * _S515 + _S533);
    var _S538 : f32 = families_0[_S511].height_scale_0 * _S532;
    var _S539 : f32 = - families_0[_S511].height_scale_0 * _S514 * _S515 * _S534;
    point_5.normal_5 = normalize(vec3<f32>(select(_S539, _S538, point_5.is_warp_5), select(_S538, _S539, point_5.is_warp_5), _S515 * _S534));
    point_5.tangent_4 = normalize(vec3<f32>(select(- _S536, _S535, point_5.is_warp_5), select(_S535, _S536, point_5.is_warp_5), _S537));
    var _S540 : f32 = _S512 * angle_of_0(_S529);
    var _S541 : f32 = select(- _S505 - _S527 * _S516, _S506 + _S527 * _S517, point_5.is_warp_5);
    point_5.fibre_across_0 = _S540 * families_0[_S511].twist_cosine_0 + _S541 * _S531;
    point_5.fibre_along_0 = _S541 * families_0[_S511].twist_cosine_0 - _S540 * _S531;
    var _S542 : f32 = 0.00999999977648258f * _S512;
    var _S543 : f32 = - _S542;
    var _S544 : bool = _S527 < _S543;
    var _S545 : f32 = select(_S542, _S543, _S518 < 0.0f);
    var _S546 : f32 = max(_S527, 0.0f);
    point_5.x_13 = point_5.x_13 + select(_S546 * _S516, select(0.0f, _S545, point_5.is_warp_5), _S544);
    point_5.y_6 = point_5.y_6 + select(_S546 * _S517, select(_S545, 0.0f, point_5.is_warp_5), _S544);
    point_5.height_7 = select(_S507 + _S527 * _S519, _S507, _S544);
    return point_5;
}

fn hairs_over_0( _S547 : u32,  _S548 : SurfacePoint_0,  _S549 : bool,  _S550 : f32) -> Hairs_0
{
    var hairs_2 : Hairs_0;
    hairs_2.place_1 = vec2<f32>(_S548.x_13, _S548.y_6);
    hairs_2.below_1 = fabrics_0[_S547].height_high_0 - _S548.height_7;
    hairs_2.back_7 = _S549;
    hairs_2.size_3 = _S550;
    return hairs_2;
}

fn has_hairs_0( _S551 : u32) -> bool
{
    return (((families_0[fabrics_0[_S551].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S551].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S552 : u32,  _S553 : Hairs_0,  _S554 : vec3<f32>,  _S555 : f32) -> Hair_0
{
    var _S556 : f32 = fabrics_0[_S552].fibre_size_0;
    var _S557 : f32 = 17.0f * fabrics_0[_S552].fibre_size_0;
    var _S558 : f32 = fade_0(_S555, _S557);
    var _S559 : vec2<f32> = _S554.xy / vec2<f32>(max(_S554.z, 0.3333333432674408f));
    var _S560 : u32 = hash_key_0(select(u32(0), u32(1), _S553.back_7), ((fabrics_0[_S552].seed_0) ^ (u32(1013904242))));
    var _S561 : f32 = fabrics_0[_S552].fibre_size_0 / max(_S555, 0.07000000029802322f * fabrics_0[_S552].fibre_size_0);
    const _S562 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S562;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_6 : bool = false;
    var number_6 : u32 = u32(0);
    for(;;)
    {
        if(((_S558 > 0.0f) & ((number_6 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S563 : u32 = number_6 / u32(9);
        var _S564 : u32 = number_6 / u32(3) - u32(3) * _S563;
        var _S565 : vec2<f32> = (vec2<f32>(((f32(_S563) * 6.0f + 2.0f) * _S556 + _S553.below_1)) * _S559 + _S553.place_1) / vec2<f32>(_S557);
        var _S566 : vec2<f32> = floor(_S565) + vec2<f32>(f32(number_6 - u32(3) * _S564 - u32(9) * _S563), f32(_S564)) - vec2<f32>(1.0f);
        var _S567 : u32 = hash_bits_0(_S560 + _S563, u32(i32(_S566.x)) * u32(65536) + u32(i32(_S566.y)));
        var _S568 : u32 = hash_bits_0(_S560, _S567);
        var _S569 : vec2<f32> = _S565 - _S566 - vec2<f32>(share_of_0(_S567), share_of_0((_S567 >> (u32(10)))));
        var _S570 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S567 >> (u32(20)))));
        var _S571 : f32 = mix(5.0f, 16.0f, share_of_0((_S568 >> (u32(10))))) / 17.0f;
        var _S572 : f32 = _S569.x;
        var _S573 : f32 = _S570.y;
        var _S574 : f32 = _S569.y;
        var _S575 : f32 = _S570.x;
        var _S576 : f32 = (_S572 * _S573 + _S574 * _S575) / _S571;
        var _S577 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S568 >> (u32(20)))) - 1.0f);
        var _S578 : f32 = 0.5f * (2.0f * share_of_0((_S567 ^ (_S568))) - 1.0f);
        var _S579 : f32 = _S576 * (3.0f * _S578 * _S576 + 2.0f * _S577);
        var _S580 : f32 = rsqrt_0(_S579 * _S579 + 1.0f);
        var _S581 : f32 = (_S574 * _S573 - _S572 * _S575 - _S571 * _S576 * _S576 * (_S578 * _S576 + _S577)) * _S580 * 17.0f;
        var _S582 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S576)), 0.0f) * _S561;
        var _S583 : f32 = clamp(_S582 + 0.5f - abs(_S581) * _S561, 0.0f, min(2.0f * _S582, 1.0f));
        var _S584 : bool = ((((_S568 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S585 : bool = (((((share_of_0(_S568)) < (families_0[select(fabrics_0[_S552].weft_0, fabrics_0[_S552].warp_0, _S584)].hairiness_0)) & (((abs(_S576)) < 1.0f)))) & ((_S583 > cover_3)));
        var _S586 : vec2<f32> = vec2<f32>(- _S575 - _S579 * _S573, _S573 - _S579 * _S575) * vec2<f32>(_S580);
        var _S587 : f32 = select(cover_3, _S583, _S585);
        var _S588 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S586.x, _S585), select(hair_across_0.y, _S586.y, _S585));
        var _S589 : f32 = select(hair_away_0, _S581, _S585);
        var _S590 : bool = select(is_warp_6, _S584, _S585);
        var _S591 : u32 = number_6 + u32(1);
        cover_3 = _S587;
        hair_across_0 = _S588;
        hair_away_0 = _S589;
        is_warp_6 = _S590;
        number_6 = _S591;
    }
    var _S592 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S558 * cover_3;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S592) * hair_across_0, sqrt(1.0f - _S592 * _S592));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_3 = is_warp_6;
    hair_1.shade_0 = _S558 * 0.03255363181233406f * (families_0[fabrics_0[_S552].warp_0].hairiness_0 + families_0[fabrics_0[_S552].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S593 : u32,  _S594 : SurfacePoint_0) -> i32
{
    var _S595 : u32 = select(fabrics_0[_S593].weft_0, fabrics_0[_S593].warp_0, _S594.is_warp_5);
    return i32(floor((select(_S594.y_6, _S594.x_13, _S594.is_warp_5) - _S594.across_2) / families_0[_S595].period_0)) * i32(families_0[_S595].count_0) + i32(select(_S594.weft_thread_0, _S594.warp_thread_0, _S594.is_warp_5));
}

fn thread_number_0( _S596 : u32,  _S597 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S596, _S597)) * u32(2) + select(u32(0), u32(1), _S597.is_warp_5);
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     bundle_offset_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_2 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S598 : u32,  _S599 : u32,  _S600 : SurfacePoint_0,  _S601 : u32,  _S602 : f32) -> FibreNoise_0
{
    var _S603 : f32 = 5.0f * fabrics_0[_S598].fibre_size_0;
    var _S604 : vec2<f32> = wave_noise_0(hash_key_0(_S601, ((fabrics_0[_S598].seed_0) ^ (u32(458671337)))), _S600.fibre_along_0 / (25.0f * fabrics_0[_S598].fibre_size_0));
    var _S605 : f32 = _S600.fibre_across_0 + families_0[_S599].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S598].fibre_size_0 * _S604.x;
    var _S606 : vec3<f32> = fibre_cell_0(_S605, _S600.fibre_along_0, fabrics_0[_S598].fibre_size_0);
    var _S607 : vec3<f32> = fibre_cell_0(_S605, _S600.fibre_along_0, _S603);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S601, ((fabrics_0[_S598].seed_0) ^ (u32(1757159915)))), _S607);
    noise_0.bundle_offset_0 = _S607.z;
    noise_0.bundle_weight_0 = fade_0(_S602, _S603);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S601, ((fabrics_0[_S598].seed_0) ^ (u32(48610963)))), _S606);
    noise_0.fibre_weight_0 = fade_0(_S602, fabrics_0[_S598].fibre_size_0);
    noise_0.offset_2 = _S606.z;
    noise_0.slope_2 = 0.5f * _S604.y;
    return noise_0;
}

fn turned_frame_0( _S608 : u32,  _S609 : u32,  _S610 : SurfacePoint_0,  _S611 : bool,  _S612 : u32,  _S613 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_6 = _S610.normal_5;
    frame_2.tangent_5 = _S610.tangent_4;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S609].has_plies_0) > 0.0f)
    {
        var _S614 : f32 = fade_0(_S613, 1.0f / families_0[_S609].plies_per_mm_0);
        var _S615 : f32 = _S614 * 0.62000000476837158f * ply_offset_0(_S609, _S610, _S611);
        var _S616 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S617 : vec3<f32> = vec3<f32>(families_0[_S609].ply_cosine_0);
        var _S618 : vec3<f32> = vec3<f32>(select(families_0[_S609].ply_sine_0, - families_0[_S609].ply_sine_0, _S611));
        var _S619 : vec3<f32> = _S617 * _S616 + _S618 * frame_2.tangent_5;
        var _S620 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S615 * _S615));
        var _S621 : vec3<f32> = vec3<f32>(_S615);
        frame_2.tangent_5 = _S617 * (_S617 * frame_2.tangent_5 - _S618 * _S616) + _S618 * (_S620 * _S619 - _S621 * frame_2.normal_6);
        frame_2.normal_6 = _S620 * frame_2.normal_6 + _S621 * _S619;
        frame_2.loss_0 = _S614 * _S614 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S622 : f32 = families_0[_S609].fibre_tilt_0;
    if((families_0[_S609].fibre_tilt_0) > 0.0f)
    {
        var _S623 : FibreNoise_0 = fibre_noise_at_0(_S608, _S609, _S610, _S612, _S613);
        var _S624 : f32 = 1.09858846664428711f * _S622 * (_S623.bundle_weight_0 * _S623.bundle_0.x + _S623.fibre_weight_0 * (_S623.fibre_0.x + _S623.offset_2));
        var _S625 : f32 = _S622 * (1.42099642753601074f * (_S623.bundle_weight_0 * _S623.bundle_0.y + _S623.fibre_weight_0 * _S623.fibre_0.y) - _S623.bundle_weight_0 * _S623.slope_2);
        var _S626 : f32 = square_1(_S623.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S622 * _S622 * ((0.24761904776096344f * (square_1(_S623.bundle_weight_0) + _S626) + _S626 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S627 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S628 : vec2<f32> = sine_cosine_0(_S624);
        var _S629 : vec2<f32> = sine_cosine_0(_S625);
        var _S630 : vec3<f32> = vec3<f32>(_S628.y);
        var _S631 : vec3<f32> = vec3<f32>(_S628.x);
        var _S632 : vec3<f32> = _S630 * _S627 - _S631 * frame_2.normal_6;
        frame_2.normal_6 = _S630 * frame_2.normal_6 + _S631 * _S627;
        frame_2.tangent_5 = vec3<f32>(_S629.y) * frame_2.tangent_5 + vec3<f32>(_S629.x) * _S632;
    }
    return frame_2;
}

fn uncoloured_point_0( _S633 : u32,  _S634 : SurfacePoint_0,  _S635 : vec3<f32>,  _S636 : bool,  _S637 : bool,  _S638 : f32) -> YarnPoint_0
{
    var _S639 : u32 = fabrics_0[_S633].warp_0;
    var _S640 : u32 = fabrics_0[_S633].weft_0;
    var _S641 : u32 = select(fabrics_0[_S633].weft_0, fabrics_0[_S633].warp_0, _S634.is_warp_5);
    var _S642 : bool = (((fabrics_0[_S633].has_detail_0) != u32(0)) & ((_S638 >= 0.0f)));
    var _S643 : vec3<f32> = vec3<f32>(0.0f);
    var _S644 : vec2<f32> = vec2<f32>(0.0f);
    var point_6 : YarnPoint_0 = YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S643, _S643, _S643, 0.0f, 0.0f, Albedos_x24init_0(_S643, _S643, _S643, _S643), Hairs_x24init_0(_S644, 0.0f, false, 0.0f), 0.0f, _S644, 0.0f);
    point_6.hairs_0 = hairs_over_0(_S633, _S634, _S636, _S638);
    point_6.hair_cover_0 = 1.0f;
    var _S645 : Hair_0 = Hair_x24init_0(0.0f, _S643, _S643, false, 0.0f);
    point_6.is_warp_1 = _S634.is_warp_5;
    var _S646 : bool = (_S642 & ((has_hairs_0(_S633))));
    var hair_2 : Hair_0;
    if(_S646)
    {
        var _S647 : Hair_0 = hair_towards_0(_S633, point_6.hairs_0, _S635, _S638);
        point_6.hair_cover_0 = _S647.cover_1;
        point_6.is_warp_1 = select(_S634.is_warp_5, _S647.is_warp_3, (_S647.cover_1) > 0.5f);
        hair_2 = _S647;
    }
    else
    {
        hair_2 = _S645;
    }
    var _S648 : u32 = select(_S640, _S639, point_6.is_warp_1);
    point_6.back_9 = _S636;
    point_6.hole_2 = _S637;
    point_6.x_10 = _S634.x_13;
    point_6.y_4 = _S634.y_6;
    point_6.place_3 = vec2<f32>(_S634.x_13, _S634.y_6);
    point_6.plane_4 = _S634.plane_6;
    point_6.height_5 = _S634.height_7 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_1 = _S634.normal_5;
    point_6.tangent_0 = _S634.tangent_4;
    point_6.surface_normal_0 = normalize(mix(_S634.normal_5, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_0 = 1.0f;
    if(_S642)
    {
        var _S649 : YarnFrame_0 = turned_frame_0(_S633, _S641, _S634, _S636, thread_number_0(_S633, _S634), _S638);
        var frame_3 : YarnFrame_0;
        if(_S646)
        {
            frame_3 = under_hair_0(_S649, hair_2);
        }
        else
        {
            frame_3 = _S649;
        }
        point_6.normal_1 = frame_3.normal_6;
        point_6.tangent_0 = frame_3.tangent_5;
        point_6.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S633].diffuse_blend_0);
    }
    point_6.roughness_1 = families_0[_S648].roughness_0;
    return point_6;
}

fn toned_0( _S650 : u32,  _S651 : u32,  _S652 : Albedos_0,  _S653 : vec4<f32>) -> Albedos_0
{
    var _S654 : vec3<f32> = _S652.diffuse_reflect_0 + _S652.diffuse_transmit_0;
    var _S655 : vec3<f32> = vec3<f32>(1.0f);
    var _S656 : vec3<f32> = _S655 - vec3<f32>(fabrics_0[_S650].layer_bound_0) * max(_S652.specular_reflect_0, _S652.specular_transmit_0);
    var _S657 : vec3<f32> = vec3<f32>(0.0f);
    var _S658 : vec3<f32> = max(_S655 - _S654, _S657) / (_S655 + _S654);
    var _S659 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S660 : vec3<f32> = (_S656 / max(_S654, _S659) - _S655) / max(vec3<f32>(0.89999997615814209f) * _S658, _S659);
    var _S661 : vec3<f32> = _S655 - vec3<f32>((saturate(min(min(_S660.x, _S660.y), _S660.z)) * _S653.z)) * _S658;
    var _S662 : vec3<f32> = min(vec3<f32>(families_0[_S651].nep_red_0, families_0[_S651].nep_green_0, families_0[_S651].nep_blue_0), _S656);
    var found_1 : Albedos_0 = _S652;
    var _S663 : f32 = _S653.w;
    var _S664 : vec3<f32> = _S661 * _S652.diffuse_transmit_0 * vec3<f32>((1.0f - _S663));
    found_1.diffuse_transmit_0 = _S664;
    found_1.diffuse_reflect_0 = clamp(mix(_S661 * _S652.diffuse_reflect_0, _S662, vec3<f32>(_S663)), _S657, max(_S656 - _S664, _S657));
    return found_1;
}

fn toned_at_0( _S665 : u32,  _S666 : bool,  _S667 : Albedos_0,  _S668 : f32,  _S669 : vec2<f32>) -> Albedos_0
{
    var _S670 : u32 = select(fabrics_0[_S665].weft_0, fabrics_0[_S665].warp_0, _S666);
    return toned_0(_S665, _S670, _S667, irregular_at_0(_S670, irregular_key_0(_S665, select(u32(1), u32(0), _S666)), _S668, select(_S669.x, _S669.y, _S666)));
}

fn varies_at_0( _S671 : u32,  _S672 : f32) -> bool
{
    return (((((fabrics_0[_S671].fibre_noise_0) > 0.0f) | (((fabrics_0[_S671].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S671].has_detail_0) != u32(0)) & ((_S672 >= 0.0f))))));
}

fn detail_gain_0( _S673 : u32,  _S674 : u32,  _S675 : SurfacePoint_0,  _S676 : bool,  _S677 : u32,  _S678 : f32) -> vec2<f32>
{
    var _S679 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S674].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S678, 1.0f / families_0[_S674].plies_per_mm_0), ply_offset_0(_S674, _S675, _S676));
    }
    else
    {
        gain_2 = _S679;
    }
    if((families_0[_S674].fibre_tone_0) > 0.0f)
    {
        var _S680 : FibreNoise_0 = fibre_noise_at_0(_S673, _S674, _S675, _S677, _S678);
        var _S681 : f32 = 4.5f * families_0[_S674].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S674].fibre_tone_0) * vec2<f32>(_S680.bundle_weight_0 * _S680.bundle_0.y + _S680.fibre_weight_0 * _S680.fibre_0.y, _S680.bundle_weight_0 + _S680.fibre_weight_0) + (groove_0(_S681 * (_S680.bundle_weight_0 * (0.5f * (_S680.bundle_0.x - 1.0f) + 1.0f)), _S680.bundle_offset_0) + groove_0(_S681 * _S680.fibre_weight_0, _S680.offset_2));
    }
    if((families_0[_S674].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S674].slub_0 * fade_0(_S678, 1.0f / families_0[_S674].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S677, ((fabrics_0[_S673].seed_0) ^ (u32(1373058189)))), select(- _S675.x_13, _S675.y_6, _S675.is_warp_5) * families_0[_S674].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S682 : u32,  _S683 : Albedos_0,  _S684 : u32,  _S685 : u32,  _S686 : vec2<f32>) -> Albedos_0
{
    var _S687 : vec3<f32> = max(_S683.specular_reflect_0, _S683.specular_transmit_0);
    var _S688 : vec3<f32> = _S683.diffuse_reflect_0 + _S683.diffuse_transmit_0;
    var _S689 : vec3<f32> = vec3<f32>(fabrics_0[_S682].layer_bound_0);
    var _S690 : vec3<f32> = vec3<f32>(1.0f);
    var _S691 : vec3<f32> = _S690 - _S689 * _S687;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S684, fabrics_0[_S682].colour_noise_0, fabrics_0[_S682].seed_0), _S688, _S691);
    var _S692 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S686.y, vec3<f32>(colour_1) * _S688, _S691) * _S686.x)));
    var _S693 : f32 = bounded_gain_0(fibre_gain_0(_S684, _S685, fabrics_0[_S682].fibre_noise_0, fabrics_0[_S682].seed_0), _S687, min((_S690 - _S692 * _S688) / _S689, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S692 * _S683.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S692 * _S683.diffuse_transmit_0;
    var _S694 : vec3<f32> = vec3<f32>(_S693);
    varied_0.specular_reflect_0 = _S694 * _S683.specular_reflect_0;
    varied_0.specular_transmit_0 = _S694 * _S683.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S695 : u32,  _S696 : SurfacePoint_0,  _S697 : Albedos_0,  _S698 : bool,  _S699 : f32,  _S700 : f32) -> Albedos_0
{
    var _S701 : u32 = thread_number_0(_S695, _S696);
    var _S702 : vec3<f32> = fibre_cell_0(_S696.fibre_across_0, _S696.fibre_along_0, fabrics_0[_S695].fibre_size_0);
    var _S703 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S695].has_detail_0) != u32(0)) & ((_S699 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S695, select(fabrics_0[_S695].weft_0, fabrics_0[_S695].warp_0, _S696.is_warp_5), _S696, _S698, _S701, _S699) * vec2<f32>(1.0f - _S700, 1.0f);
    }
    else
    {
        gain_3 = _S703;
    }
    return vary_albedos_0(_S695, _S697, _S701, u32(i32(_S702.x)) * u32(65536) + u32(i32(floor(_S702.y))), gain_3);
}

fn yarn_point_of_0( _S704 : u32,  _S705 : SurfacePoint_0,  _S706 : vec3<f32>,  _S707 : bool,  _S708 : bool,  _S709 : f32) -> YarnPoint_0
{
    var point_7 : YarnPoint_0 = uncoloured_point_0(_S704, _S705, _S706, _S707, _S708, _S709);
    point_7.albedos_0 = albedos_of_0(select(fabrics_0[_S704].weft_0, fabrics_0[_S704].warp_0, point_7.is_warp_1), select(_S705.weft_thread_0, _S705.warp_thread_0, point_7.is_warp_1));
    if((fabrics_0[_S704].is_irregular_0) != u32(0))
    {
        point_7.albedos_0 = toned_at_0(_S704, point_7.is_warp_1, point_7.albedos_0, f32(thread_of_family_0(_S704, _S705)), vec2<f32>(_S705.x_13, _S705.y_6));
    }
    var _S710 : bool = (((((fabrics_0[_S704].has_detail_0) != u32(0)) & ((_S709 >= 0.0f)))) & ((has_hairs_0(_S704))));
    if(varies_at_0(_S704, _S709))
    {
        point_7.albedos_0 = varied_at_0(_S704, _S705, point_7.albedos_0, _S707, _S709, select(0.0f, point_7.hair_cover_0, _S710));
    }
    return point_7;
}

fn locate_yarn_0( _S711 : u32,  _S712 : SearchQuality_0,  _S713 : f32,  _S714 : f32,  _S715 : vec3<f32>,  _S716 : f32) -> YarnPoint_0
{
    var _S717 : bool = (_S715.z) < 0.0f;
    var _S718 : vec3<f32> = to_face_frame_0(_S715, _S717);
    var _S719 : Hit_0 = first_hit_0(_S711, _S712, _S713, _S714, _S718, _S717);
    var point_8 : YarnPoint_0 = yarn_point_of_0(_S711, surface_met_0(_S711, _S719.x_18, _S719.y_11, _S719.height_8, _S718, _S717), _S718, _S717, _S719.hole_5, _S716);
    point_8.place_3 = vec2<f32>(_S719.x_18, _S719.y_11);
    return point_8;
}

fn openness_number_0( _S720 : u32,  _S721 : u32) -> f32
{
    return table_number_0(fabrics_0[_S720].openness_0 + _S721);
}

fn blocked_of_terms_0( _S722 : u32,  _S723 : u32,  _S724 : array<f32, i32(6)>,  _S725 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_3 : u32 = u32(0);
    for(;;)
    {
        if(share_3 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_3] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S725)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S722, _S723 + share_3 * _S725 + term_0) * _S724[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_3] = saturate(shares_0[share_3]);
        share_3 = share_3 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_at_0( _S726 : u32,  _S727 : bool,  _S728 : bool,  _S729 : f32,  _S730 : f32) -> Blocked_0
{
    var _S731 : f32 = _S730 * openness_number_0(_S726, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S729, _S731, _S729 * _S729, _S729 * _S731, _S731 * _S731 );
    return blocked_of_terms_0(_S726, u32(60) + (select(u32(0), u32(2), _S728) + select(u32(1), u32(0), _S727)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S732 : u32,  _S733 : Albedos_0,  _S734 : u32,  _S735 : vec3<f32>) -> Scattered_0
{
    var _S736 : u32 = u32(159) + u32(2) * _S734;
    var yarn_4 : Scattered_0;
    yarn_4.back_12 = _S735 * _S733.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S732, _S736)) * _S733.specular_reflect_0;
    yarn_4.through_0 = _S735 * _S733.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S732, _S736 + u32(1))) * _S733.specular_transmit_0;
    return yarn_4;
}

fn sent_0( _S737 : u32,  _S738 : u32,  _S739 : vec3<f32>,  _S740 : vec3<f32>,  _S741 : vec3<f32>,  _S742 : vec3<f32>,  _S743 : ptr<function, vec3<f32>>,  _S744 : ptr<function, vec3<f32>>)
{
    var _S745 : u32 = u32(146) + u32(4) * _S738;
    var _S746 : f32 = openness_number_0(_S737, _S745 + u32(1));
    var _S747 : f32 = openness_number_0(_S737, _S745 + u32(2));
    var _S748 : vec3<f32> = vec3<f32>(1.0f);
    var _S749 : vec3<f32> = _S748 - _S741 * vec3<f32>(openness_number_0(_S737, _S745));
    var _S750 : vec3<f32> = _S748 - _S742 * vec3<f32>(openness_number_0(_S737, _S745 + u32(3)));
    var _S751 : vec3<f32> = _S748 / (_S749 * _S750 - _S741 * _S742 * vec3<f32>((_S746 * _S747)));
    (*_S743) = (_S739 * _S750 + _S741 * vec3<f32>(_S746) * _S740) * _S751;
    (*_S744) = (_S740 * _S749 + _S742 * vec3<f32>(_S747) * _S739) * _S751;
    return;
}

fn face_sends_0( _S752 : u32,  _S753 : u32,  _S754 : Scattered_0,  _S755 : Scattered_0) -> FaceSends_0
{
    var _S756 : u32 = u32(2) * _S753;
    var _S757 : u32 = u32(142) + _S756;
    var _S758 : f32 = openness_number_0(_S752, _S757);
    var _S759 : f32 = openness_number_0(_S752, _S757 + u32(1));
    var _S760 : vec3<f32> = vec3<f32>((1.0f - _S758)) * _S754.back_12;
    var _S761 : vec3<f32> = vec3<f32>((1.0f - _S759)) * _S755.back_12;
    var sends_1 : FaceSends_0;
    var _S762 : u32 = u32(154) + _S756;
    var _S763 : f32 = openness_number_0(_S752, _S762);
    sends_1.blocks_warp_0 = _S763;
    var _S764 : f32 = openness_number_0(_S752, _S762 + u32(1));
    sends_1.blocks_weft_0 = _S764;
    sends_1.open_0 = _S763 * _S758 + _S764 * _S759;
    var _S765 : vec3<f32> = vec3<f32>(_S758) * _S754.back_12;
    var _S766 : vec3<f32> = vec3<f32>(_S759) * _S755.back_12;
    var _S767 : vec3<f32> = sends_1.sky_warp_0;
    var _S768 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S752, _S753, _S765, _S766, _S760, _S761, &(_S767), &(_S768));
    sends_1.sky_warp_0 = _S767;
    sends_1.sky_weft_0 = _S768;
    var _S769 : vec3<f32> = sends_1.crossing_warp_0;
    var _S770 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S752, _S753, _S754.through_0, _S755.through_0, _S760, _S761, &(_S769), &(_S770));
    sends_1.crossing_warp_0 = _S769;
    sends_1.crossing_weft_0 = _S770;
    return sends_1;
}

fn interior_between_0( _S771 : u32,  _S772 : u32,  _S773 : u32,  _S774 : vec3<f32>,  _S775 : bool) -> Interior_0
{
    var _S776 : Scattered_0 = scattered_by_0(_S771, table_albedos_0(_S772), u32(0), _S774);
    var _S777 : Scattered_0 = scattered_by_0(_S771, table_albedos_0(_S773), u32(1), _S774);
    var _S778 : FaceSends_0 = face_sends_0(_S771, select(u32(0), u32(1), _S775), _S776, _S777);
    var _S779 : FaceSends_0 = face_sends_0(_S771, select(u32(1), u32(0), _S775), _S776, _S777);
    var _S780 : vec3<f32> = vec3<f32>(_S778.blocks_warp_0);
    var _S781 : vec3<f32> = vec3<f32>(_S778.blocks_weft_0);
    var _S782 : vec3<f32> = _S780 * _S778.crossing_warp_0 + _S781 * _S778.crossing_weft_0;
    var _S783 : vec3<f32> = vec3<f32>(_S779.blocks_warp_0);
    var _S784 : vec3<f32> = vec3<f32>(_S779.blocks_weft_0);
    var _S785 : vec3<f32> = _S783 * _S779.crossing_warp_0 + _S784 * _S779.crossing_weft_0;
    var _S786 : f32 = 1.0f - _S778.open_0;
    var _S787 : f32 = 1.0f - _S779.open_0;
    var _S788 : vec3<f32> = vec3<f32>(1.0f);
    var _S789 : vec3<f32> = _S788 / (_S788 - _S782 * _S785 * vec3<f32>((_S786 * _S787)));
    var _S790 : vec3<f32> = _S785 * (vec3<f32>(_S778.open_0) + vec3<f32>(_S786) * (_S780 * _S778.sky_warp_0 + _S781 * _S778.sky_weft_0)) * _S789;
    var _S791 : vec3<f32> = _S782 * (vec3<f32>(_S779.open_0) + vec3<f32>(_S787) * (_S783 * _S779.sky_warp_0 + _S784 * _S779.sky_weft_0)) * _S789;
    var _S792 : FaceRadiance_0 = face_radiance_0(_S778, _S779.open_0, _S790, _S791);
    var _S793 : FaceRadiance_0 = face_radiance_0(_S779, _S778.open_0, _S791, _S790);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S792.warp_3;
    interior_1.weft_4 = _S792.weft_3;
    interior_1.leaked_1 = _S792.leaked_0;
    interior_1.far_1 = _S793.mean_0;
    interior_1.far_leaked_0 = _S793.leaked_0;
    return interior_1;
}

struct Behind_0
{
     scattered_0 : Scattered_0,
     is_covered_1 : bool,
};

fn layers_behind_0( _S794 : u32,  _S795 : YarnPoint_0,  _S796 : vec3<f32>) -> Behind_0
{
    var _S797 : f32 = _S795.place_3.x;
    var _S798 : f32 = _S795.place_3.y;
    var _S799 : PlaneHere_0 = plane_shown_0(_S794, _S797, _S798, _S795.back_9, true, true);
    var _S800 : u32 = plane_order_0(_S794, _S797, _S798, _S795.back_9);
    var behind_0 : Behind_0;
    behind_0.scattered_0.back_12 = vec3<f32>(0.0f);
    behind_0.scattered_0.through_0 = vec3<f32>(1.0f);
    behind_0.is_covered_1 = false;
    var _S801 : u32 = fabrics_0[_S794].planes_0;
    var nearer_0 : u32 = u32(0);
    var left_0 : u32 = fabrics_0[_S794].planes_0;
    var is_shown_0 : bool = false;
    for(;;)
    {
        if(left_0 > u32(0))
        {
        }
        else
        {
            break;
        }
        var _S802 : u32 = left_0 - u32(1);
        var _S803 : u32 = words_0[_S800 + u32(2) * _S802];
        var is_shown_1 : bool = (is_shown_0 | ((_S803 == (_S799.number_1))));
        var _S804 : Plane_0 = plane_at_0(fabrics_0[_S794].plane_records_0 + _S803 * u32(16));
        var _S805 : Crossing_0 = crossing_at_0(_S804, _S797, _S798, _S795.back_9);
        var _S806 : Shown_0 = shown_at_0(_S805, _S795.back_9);
        var _S807 : u32 = select(fabrics_0[_S794].weft_0, fabrics_0[_S794].warp_0, _S806.is_warp_0);
        var _S808 : Scattered_0 = beneath_0(scattered_evenly_0(_S807, albedos_of_0(_S807, words_0[select(_S804.pick_numbers_0 + _S805.weft_2.thread_2, _S804.end_numbers_0 + _S805.warp_2.thread_2, _S806.is_warp_0)]), _S796), behind_0.scattered_0);
        var _S809 : bool = ((((!_S806.hole_0) & ((!is_shown_1)))) & ((!(((left_0 < _S801) & ((_S803 == nearer_0)))))));
        behind_0.scattered_0.back_12 = select_vector_0(_S809, _S808.back_12, behind_0.scattered_0.back_12);
        behind_0.scattered_0.through_0 = select_vector_0(_S809, _S808.through_0, behind_0.scattered_0.through_0);
        behind_0.is_covered_1 = ((behind_0.is_covered_1) | (_S809));
        nearer_0 = _S803;
        left_0 = _S802;
        is_shown_0 = is_shown_1;
    }
    return behind_0;
}

fn bounced_at_0( _S810 : u32,  _S811 : YarnPoint_0,  _S812 : vec3<f32>) -> Bounced_0
{
    var found_2 : Bounced_0;
    var _S813 : vec3<f32> = vec3<f32>(0.0f);
    found_2.reflected_0 = _S813;
    found_2.transmitted_0 = _S813;
    found_2.is_covered_0 = false;
    if(_S811.hole_2)
    {
        return found_2;
    }
    if((fabrics_0[_S810].openness_0) != u32(4294967295))
    {
        found_2 = bounced_by_0(blocked_at_0(_S810, _S811.is_warp_1, _S811.back_9, _S811.surface_normal_0.z, _S811.height_5 - _S811.plane_4), scattered_by_0(_S810, _S811.albedos_0, select(u32(1), u32(0), _S811.is_warp_1), _S812), interior_between_0(_S810, families_0[fabrics_0[_S810].warp_0].colour_mean_0, families_0[fabrics_0[_S810].weft_0].colour_mean_0, _S812, _S811.back_9));
    }
    if(!is_layered_0(_S810))
    {
        return found_2;
    }
    var _S814 : Behind_0 = layers_behind_0(_S810, _S811, _S812);
    if(!_S814.is_covered_1)
    {
        return found_2;
    }
    var own_2 : Scattered_0 = scattered_evenly_0(select(fabrics_0[_S810].weft_0, fabrics_0[_S810].warp_0, _S811.is_warp_1), _S811.albedos_0, _S812);
    own_2.through_0 = own_2.through_0 + found_2.transmitted_0;
    var _S815 : Scattered_0 = beneath_0(own_2, _S814.scattered_0);
    found_2.reflected_0 = found_2.reflected_0 + (_S815.back_12 - own_2.back_12);
    found_2.transmitted_0 = _S815.through_0;
    found_2.is_covered_0 = true;
    return found_2;
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S816 : u32,  _S817 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S816 * frame_record_0.height_0 + _S817.y) * frame_record_0.width_0 + _S817.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S818 : u32,  _S819 : u32) -> vec3<f32>
{
    var _S820 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S818 * frame_record_0.environment_columns_0 + _S819);
    return vec3<f32>(scene_number_0(_S820), scene_number_0(_S820 + u32(1)), scene_number_0(_S820 + u32(2)));
}

fn sample_environment_0( _S821 : vec2<f32>,  _S822 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S823 : u32 = frame_record_0.environment_rows_0;
    var _S824 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S821.y);
    var _S825 : u32 = frame_record_0.environment_columns_0;
    var _S826 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S824.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S821.x);
    var _S827 : vec3<f32> = environment_texel_0(_S824.index_6, _S826.index_6);
    (*_S822) = _S827 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S827), 9.99999968265522539e-21f)));
    var _S828 : f32 = 3.14159274101257324f / f32(_S823);
    var _S829 : f32 = mix(sine_cosine_0(f32(_S824.index_6) * _S828).y, sine_cosine_0(f32(_S824.index_6 + u32(1)) * _S828).y, _S824.remainder_0);
    var _S830 : f32 = sqrt(max(1.0f - _S829 * _S829, 0.0f));
    var _S831 : vec2<f32> = sine_cosine_0((f32(_S826.index_6) + _S826.remainder_0) * (6.28318548202514648f / f32(_S825)));
    var _S832 : f32 = _S830 * _S831.x;
    var _S833 : f32 = - _S830 * _S831.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S832 + frame_record_0.environment_sine_0 * _S833, _S829, frame_record_0.environment_cosine_0 * _S833 - frame_record_0.environment_sine_0 * _S832);
}

fn light_sample_0( _S834 : u32,  _S835 : vec2<u32>,  _S836 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S837 : u32 = frame_record_0.lights_0;
    if(_S834 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S838 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S835, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S834 - _S837), u32(3)), &(weight_0));
        sample_1.towards_0 = _S838;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S839 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S834);
    sample_1.irradiance_1 = vec3<f32>(_S839.red_0, _S839.green_0, _S839.blue_0);
    sample_1.towards_0 = vec3<f32>(_S839.x_14, _S839.y_7, _S839.z_1);
    if((_S839.is_point_0) != u32(0))
    {
        var _S840 : vec3<f32> = sample_1.towards_0 - _S836;
        var _S841 : f32 = max(square_0(_S840), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S841);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S841);
        sample_1.towards_0 = normalize(_S840);
    }
    return sample_1;
}

fn diffuse_kept_0( _S842 : u32,  _S843 : vec3<f32>,  _S844 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S842].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S843.z), 0.0f))) * (1.0f - fabrics_0[_S842].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S844.z), 0.0f)));
}

fn highlight_rise_0( _S845 : u32,  _S846 : vec3<f32>,  _S847 : vec3<f32>) -> f32
{
    var _S848 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S846, _S847) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S845].grazing_gain_0 * fourth_power_0(_S848) * _S848;
}

fn towards_grazing_0( _S849 : u32,  _S850 : Albedos_0,  _S851 : vec3<f32>,  _S852 : vec3<f32>) -> Albedos_0
{
    var _S853 : f32 = diffuse_kept_0(_S849, _S851, _S852);
    var result_1 : Albedos_0 = _S850;
    var _S854 : vec3<f32> = vec3<f32>(_S853);
    result_1.diffuse_reflect_0 = result_1.diffuse_reflect_0 * _S854;
    result_1.diffuse_transmit_0 = result_1.diffuse_transmit_0 * _S854;
    result_1.specular_reflect_0 = result_1.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S849, _S851, _S852));
    return result_1;
}

fn hairs_lit_0( _S855 : u32,  _S856 : Hairs_0,  _S857 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S855, _S856, _S857, _S856.size_3 + fabrics_0[_S855].fibre_size_0).cover_1;
}

fn under_hairs_0( _S858 : u32,  _S859 : YarnPoint_0,  _S860 : vec3<f32>) -> f32
{
    if((((_S859.hair_cover_0) >= 1.0f) | (((_S860.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S858, _S859.hairs_0, _S860), 1.0f, _S859.hair_cover_0);
}

fn scattered_1( _S861 : u32,  _S862 : YarnPoint_0,  _S863 : vec3<f32>,  _S864 : vec3<f32>) -> vec3<f32>
{
    var _S865 : vec3<f32> = vec3<f32>(0.0f);
    var _S866 : Albedos_0 = towards_grazing_0(_S861, _S862.albedos_0, _S863, _S864);
    var _S867 : bool = !_S862.hole_2;
    var _S868 : f32 = _S863.z;
    var value_2 : vec3<f32>;
    if((_S867 & ((_S868 > 0.0f))))
    {
        value_2 = (_S866.diffuse_reflect_0 * vec3<f32>(_S862.diffuse_gain_0) * vec3<f32>(diffuse_reflection_0(_S863, _S862.normal_1, fabrics_0[_S861].diffuse_blend_0)) + _S866.specular_reflect_0 * vec3<f32>(reflection_0(_S863, _S864, _S862.normal_1, _S862.tangent_0, _S862.roughness_1, fabrics_0[_S861].optical_depth_0))) * vec3<f32>(under_hairs_0(_S861, _S862, _S863));
    }
    else
    {
        if((_S867 & ((_S868 < 0.0f))))
        {
            value_2 = _S866.diffuse_transmit_0 * vec3<f32>(_S862.diffuse_gain_0) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S863), _S862.normal_1, fabrics_0[_S861].diffuse_blend_0)) + _S866.specular_transmit_0 * vec3<f32>(transmission_1(_S863, _S864, _S862.normal_1, _S862.tangent_0, _S862.roughness_1, fabrics_0[_S861].optical_depth_0));
        }
        else
        {
            value_2 = _S865;
        }
    }
    var _S869 : f32 = fabrics_0[_S861].sheen_strength_0;
    if((fabrics_0[_S861].sheen_strength_0) <= 0.0f)
    {
        return value_2;
    }
    var _S870 : vec2<f32> = sheen_with_transmittance_0(_S863, _S864, _S869, fabrics_0[_S861].sheen_roughness_0);
    return vec3<f32>(_S870.y) * value_2 + vec3<f32>(_S870.x);
}

fn surface_at_0( _S871 : u32,  _S872 : f32,  _S873 : f32,  _S874 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S871, sample_at_0(_S871, _S872, _S873, _S874), _S872, _S873, _S874);
}

fn unoccluded_0( _S875 : u32,  _S876 : SearchQuality_0,  _S877 : f32,  _S878 : f32,  _S879 : f32,  _S880 : vec3<f32>,  _S881 : bool) -> bool
{
    if((_S880.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S875, _S876, vec3<f32>(_S877, _S878, _S879 + fabrics_0[_S875].lift_0), _S880, _S881, max_height_along_0(_S875, _S877, _S878, _S879, _S880, _S881));
}

fn is_lit_0( _S882 : u32,  _S883 : SearchQuality_0,  _S884 : YarnPoint_0,  _S885 : vec3<f32>) -> bool
{
    if(_S884.hole_2)
    {
        return true;
    }
    var _S886 : vec3<f32> = to_face_frame_0(_S885, _S884.back_9);
    var _S887 : f32 = _S886.z;
    var _S888 : bool = _S887 < 0.0f;
    var normal_10 : vec3<f32>;
    var height_12 : f32;
    if(_S888)
    {
        var _S889 : SurfacePoint_0 = surface_at_0(_S882, _S884.x_10, _S884.y_4, !_S884.back_9);
        normal_10 = _S889.normal_5;
        height_12 = _S889.height_7;
    }
    else
    {
        normal_10 = _S884.surface_normal_0;
        height_12 = _S884.height_5;
    }
    var _S890 : vec3<f32> = vec3<f32>(_S886.xy, abs(_S887));
    if((dot(normal_10, _S890)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S882, _S883, _S884.x_10, _S884.y_4, height_12, _S890, (_S884.back_9) != _S888);
}

fn evaluate_with_0( _S891 : u32,  _S892 : SearchQuality_0,  _S893 : YarnPoint_0,  _S894 : Bounced_0,  _S895 : vec3<f32>,  _S896 : vec3<f32>) -> vec3<f32>
{
    var _S897 : vec3<f32> = to_face_frame_0(_S896, _S893.back_9);
    var shown_4 : YarnPoint_0 = _S893;
    if(_S894.is_covered_0)
    {
        var _S898 : vec3<f32> = vec3<f32>(0.0f);
        shown_4.albedos_0.diffuse_transmit_0 = _S898;
        shown_4.albedos_0.specular_transmit_0 = _S898;
    }
    var _S899 : vec3<f32> = scattered_1(_S891, shown_4, to_face_frame_0(_S895, _S893.back_9), _S897);
    var _S900 : bool;
    if((max(_S899.x, max(_S899.y, _S899.z))) <= 0.0f)
    {
        _S900 = true;
    }
    else
    {
        _S900 = !is_lit_0(_S891, _S892, _S893, _S895);
    }
    var value_3 : vec3<f32>;
    if(_S900)
    {
        value_3 = vec3<f32>(0.0f);
    }
    else
    {
        value_3 = _S899;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S894, _S895, _S896) * vec3<f32>(diffuse_kept_0(_S891, _S895, _S896));
    var _S901 : f32 = fabrics_0[_S891].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S891].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S901 * sheen_lobe_0(abs(_S897.z), fabrics_0[_S891].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_3 + between_2;
}

fn straight_through_0( _S902 : u32,  _S903 : YarnPoint_0,  _S904 : vec3<f32>) -> f32
{
    if(!_S903.hole_2)
    {
        return 0.0f;
    }
    var _S905 : f32 = fabrics_0[_S902].sheen_strength_0;
    if((fabrics_0[_S902].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S905 * sheen_lobe_0(abs(_S904.z), fabrics_0[_S902].sheen_roughness_0).z;
}

fn light_of_point_0( _S906 : u32,  _S907 : VisiblePoint_0,  _S908 : vec2<u32>,  _S909 : vec3<f32>,  _S910 : vec2<f32>) -> vec4<f32>
{
    var _S911 : SearchQuality_0 = default_quality_0();
    var _S912 : vec3<f32> = to_local_0(_S907, _S907.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S910;
    footprint_0.dx_0 = _S907.draft_dx_0;
    footprint_0.dy_0 = _S907.draft_dy_0;
    var _S913 : YarnPoint_0 = locate_yarn_0(_S906, _S911, _S910.x, _S910.y, _S912, Footprint_spread_side_0(footprint_0));
    var point_9 : YarnPoint_0 = _S913;
    var _S914 : Bounced_0 = bounced_at_0(_S906, _S913, _S909);
    point_9.albedos_0 = tinted_0(point_9.albedos_0, _S909);
    var _S915 : vec3<f32> = vec3<f32>(0.0f);
    var number_7 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S915;
    for(;;)
    {
        if(number_7 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S916 : f32 = visibility_at_0(number_7, _S908);
        if(_S916 <= 0.0f)
        {
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S917 : LightSample_0 = light_sample_0(number_7, _S908, _S907.position_4);
        radiance_1 = radiance_1 + vec3<f32>(_S916) * _S917.irradiance_1 * evaluate_with_0(_S906, _S911, point_9, _S914, to_local_0(_S907, _S917.towards_0), _S912);
        number_7 = number_7 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S906, point_9, _S912));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S918 : u32 = id_0.x;
    var _S919 : bool;
    if(_S918 >= (frame_record_0.width_0))
    {
        _S919 = true;
    }
    else
    {
        _S919 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S919)
    {
        return;
    }
    var _S920 : vec2<u32> = id_0.xy;
    var _S921 : u32 = id_0.y * frame_record_0.width_0 + _S918;
    var _S922 : u32 = layers_0[_S921].face_0;
    if((layers_0[_S921].face_0) == u32(0))
    {
        return;
    }
    var _S923 : u32 = _S922 - u32(1);
    var _S924 : u32 = fabric_of_0(_S923);
    var _S925 : VisiblePoint_0 = visible_point_0(_S924, _S923, _S920);
    var _S926 : vec3<f32> = filtered_albedo_0(_S924, _S925);
    var _S927 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S927;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S928 : vec2<f32> = pixel_sequence_0(_S920, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S924, _S925, _S920, _S926, irregular_place_0(_S924, _S925.draft_0 + vec2<f32>(_S928.x) * _S925.draft_dx_0 + vec2<f32>(_S928.y) * _S925.draft_dy_0, 0.0f));
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S921, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

