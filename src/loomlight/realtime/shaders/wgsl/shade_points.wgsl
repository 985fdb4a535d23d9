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

struct Shown_0
{
     is_warp_0 : bool,
     hole_0 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_1 : Cell_0,
     weft_1 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_0 : Crossing_0,  back_3 : bool) -> Shown_0
{
    var _S55 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var shown_0 : Shown_0;
    var _S56 : bool = !((abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1));
    var _S57 : bool = (_S55 & (((_S56 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_0 = _S57;
    shown_0.hole_0 = ((!_S55) & (_S56));
    var _S58 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S57);
    shown_0.word_0 = _S58;
    shown_0.on_top_0 = (((_S58 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_2 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_6 : Cell_0;
    cell_6.thread_2 = select(second_0.thread_2, first_2.thread_2, is_first_0);
    cell_6.across_0 = select(second_0.across_0, first_2.across_0, is_first_0);
    cell_6.half_width_1 = select(second_0.half_width_1, first_2.half_width_1, is_first_0);
    cell_6.below_0 = select(second_0.below_0, first_2.below_0, is_first_0);
    cell_6.above_0 = select(second_0.above_0, first_2.above_0, is_first_0);
    return cell_6;
}

fn boundary_0( family_9 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S59 : vec2<f32> = turns_and_remainder_0(family_9, f32(i32(thread_4) + step_0));
    return fma(_S59.x, families_0[family_9].period_0, table_number_0(families_0[family_9].place_table_0 + u32(_S59.y) * u32(4)));
}

fn span_0( family_10 : u32,  thread_5 : u32,  first_3 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_10].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_3) * families_0[family_10].size_0;
    }
    return boundary_0(family_10, thread_5, last_0) - boundary_0(family_10, thread_5, first_3);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_11 : u32,  thread_6 : u32) -> Bend_0
{
    var _S60 : u32 = families_0[family_11].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_11].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S60);
    bend_0.half_tangent_0 = table_number_0(_S60 + u32(1));
    bend_0.arc_0 = table_number_0(_S60 + u32(2));
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
    var _S61 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S62 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S63 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S64 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S65 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S65;
    var _S66 : i32 = - _S61;
    var _S67 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S66, i32(0));
    run_0.from_start_0 = _S67;
    var _S68 : i32 = _S62 + i32(1);
    var _S69 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S68);
    run_0.to_end_0 = _S69;
    var _S70 : bool = _S67 < _S69;
    run_0.near_start_0 = _S70;
    var _S71 : i32 = select(_S68, _S66 - _S63, _S70);
    var _S72 : i32 = select(_S68 + _S64, _S66, _S70);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S67, _S69), 1.0e+06f, _S65);
    run_0.reach_0 = min(0.5f * (_S67 + _S69), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S71, _S72), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S61 == i32(0);
    run_0.last_crossing_0 = _S62 == i32(0);
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
    var _S73 : f32 = cell_7.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S74 : f32 = clamp(cell_7.across_0, - cell_7.half_width_1, cell_7.half_width_1);
    section_0.across_1 = _S74;
    var _S75 : f32 = _S73 * _S73 - square_1(_S74);
    var _S76 : f32 = rsqrt_0(_S75);
    section_0.drop_0 = _S73 - _S75 * _S76;
    section_0.slope_0 = - _S74 * _S76;
    return section_0;
}

fn edge_drop_0( family_12 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_12].bend_table_0 + select(u32(turns_and_remainder_0(family_12, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S77 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S78 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S79 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S77) - crossed_1.half_width_1;
    var _S80 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S77);
    var _S81 : f32;
    if(shown_1.on_top_0)
    {
        _S81 = 0.0f;
    }
    else
    {
        _S81 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S82 : f32;
    if((shown_1.on_top_0) != _S80)
    {
        _S82 = 0.0f;
    }
    else
    {
        _S82 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S77));
    }
    var _S83 : f32 = 2.0f * _S79;
    var _S84 : f32 = 1.0f / max(_S83, 9.999999960041972e-13f);
    var _S85 : f32 = clamp((_S79 - _S78) * _S84, 0.0f, 1.0f);
    var _S86 : f32 = clamp((0.44999998807907104f - _S83 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S81 + (_S82 - _S81) * (_S85 * _S85 * (3.0f - 2.0f * _S85)), (_S81 - _S82) * (6.0f * _S85 * (1.0f - _S85) * _S84) * select(-1.0f, 1.0f, _S77), _S86 * _S86 * (3.0f - 2.0f * _S86));
}

struct StepControl_0
{
     step_2 : f32,
     epsilon_0 : f32,
     per_x_0 : f32,
     per_y_0 : f32,
     right_0 : bool,
     up_0 : bool,
};

fn step_control_0( direction_2 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S87 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S87), 9.99999971718068537e-10f);
    var _S88 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S88), 9.99999971718068537e-10f);
    control_0.right_0 = _S87 > 0.0f;
    control_0.up_0 = _S88 > 0.0f;
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

fn outline_distance_0( cell_8 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S89 : f32 = select(- cell_8.across_0, cell_8.across_0, forwards_0);
    var _S90 : f32 = select(cell_8.below_0, cell_8.above_0, forwards_0);
    var _S91 : f32 = - cell_8.half_width_1;
    var _S92 : bool = _S89 < _S91;
    var _S93 : bool = _S89 >= (cell_8.half_width_1);
    var _S94 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_0)));
    var _S95 : f32 = select(cell_8.half_width_1, _S91, _S92) - _S89;
    var _S96 : f32 = select(_S90, 2.0f * _S90 + _S89 - cell_8.half_width_1, ((shown_2.hole_0) | (((_S94 & ((!shown_2.on_top_0)))))));
    if((((_S94 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S92)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S95, _S96, _S93);
}

struct Probe_0
{
     height_2 : f32,
     hole_1 : bool,
     slope_x_0 : f32,
     slope_y_0 : f32,
     yarn_1 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_0 : Probe_0) -> f32
{
    var _S97 : f32 = previous_1.rate_0 * step_4;
    var _S98 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_1)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S97) >= 0.0f) & (((3.0f * clearance_1 - _S98) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S99 : f32 = clearance_1 - previous_1.clearance_0;
    var _S100 : f32 = 6.0f * _S99 - 4.0f * _S97 - 2.0f * _S98;
    var _S101 : f32 = -2.0f * _S97 / max(_S100 + sqrt(max(_S100 * _S100 - 4.0f * (3.0f * (_S97 + _S98 - 2.0f * _S99)) * _S97, 0.0f)), 9.99999968265522539e-21f);
    var _S102 : f32 = 1.0f - _S101;
    return select(-1.0f, _S102 * step_4, ((((_S101 > 0.01999999955296516f) & ((_S102 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S101 + 1.0f) + _S97 * _S101) * _S102 * _S102 + (clearance_1 * (2.0f * _S102 + 1.0f) - _S98 * _S102) * _S101 * _S101) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_1.hole_1);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    previous_2.known_0 = ((!here_1.hole_1) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S103 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S103, 0.0f) + this_2.epsilon_0, _S103 - this_2.epsilon_0, ((((!here_2.hole_1) & (((rate_3 * _S103 + clearance_3) < 0.0f)))) & ((_S103 > (2.0f * this_2.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_3 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_3);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S104 : f32 = end_0 - start_1;
    var _S105 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S104;
    var _S106 : f32 = 3.0f * _S104 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S104, 9.99999968265522539e-21f);
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
        var _S107 : f32 = clamp(share_1 - (((_S105 * share_1 + _S106) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S105 * share_1 + 2.0f * _S106) * share_1 + start_rate_0, 0.10000000149011612f * _S104 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S108 : i32 = i_0 + i32(1);
        share_1 = _S107;
        i_0 = _S108;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S109 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S110 : f32 = rsqrt_0(_S109);
    var _S111 : f32 = sine_1 * _S110 * rsqrt_0(_S109 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S111 * _S109, _S111 * across_slope_0 * along_slope_0 + cosine_0 * _S110);
}

fn arc_sine_0( x_6 : f32) -> f32
{
    var _S112 : f32 = abs(x_6);
    var _S113 : bool = _S112 > 0.5f;
    var _S114 : f32 = select(_S112 * _S112, 0.5f * (1.0f - _S112), _S113);
    var _S115 : f32 = select(_S112, sqrt(max(_S114, 0.0f)), _S113);
    var _S116 : f32 = ((((0.04216320067644119f * _S114 + 0.02418131195008755f) * _S114 + 0.04547002539038658f) * _S114 + 0.07495300471782684f) * _S114 + 0.16666752099990845f) * _S114 * _S115 + _S115;
    var _S117 : f32 = select(_S116, 1.57079637050628662f - 2.0f * _S116, _S113);
    return select(_S117, - _S117, x_6 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S118 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S118 / (_S118 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S119 : f32 = direction_3.x;
    var _S120 : f32 = arc_sine_0(_S119);
    var _S121 : bool = _S119 < 0.0f;
    var _S122 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S121);
    var _S123 : f32 = direction_3.y;
    return select(0.5f * _S122 - select(1.0f, -1.0f, _S121) * arc_sine_0(_S123), select(_S120, _S122 - _S120, _S123 < 0.0f), (abs(_S119)) < 0.69999998807907104f);
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
    var _S124 : Albedos_0;
    _S124.diffuse_reflect_0 = diffuse_reflect_1;
    _S124.diffuse_transmit_0 = diffuse_transmit_1;
    _S124.specular_reflect_0 = specular_reflect_1;
    _S124.specular_transmit_0 = specular_transmit_1;
    return _S124;
}

struct Hairs_0
{
     place_1 : vec2<f32>,
     below_1 : f32,
     back_4 : bool,
     size_3 : f32,
};

fn Hairs_x24init_0( place_2 : vec2<f32>,  below_2 : f32,  back_5 : bool,  size_4 : f32) -> Hairs_0
{
    var _S125 : Hairs_0;
    _S125.place_1 = place_2;
    _S125.below_1 = below_2;
    _S125.back_4 = back_5;
    _S125.size_3 = size_4;
    return _S125;
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_2 : bool,
     is_warp_1 : bool,
     x_7 : f32,
     y_1 : f32,
     height_4 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_0 : f32,
     roughness_1 : f32,
     albedos_0 : Albedos_0,
     hairs_0 : Hairs_0,
     hair_cover_0 : f32,
};

fn YarnPoint_x24init_0( back_7 : bool,  hole_3 : bool,  is_warp_2 : bool,  x_8 : f32,  y_2 : f32,  height_5 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  surface_normal_1 : vec3<f32>,  diffuse_gain_1 : f32,  roughness_2 : f32,  albedos_1 : Albedos_0,  hairs_1 : Hairs_0,  hair_cover_1 : f32) -> YarnPoint_0
{
    var _S126 : YarnPoint_0;
    _S126.back_6 = back_7;
    _S126.hole_2 = hole_3;
    _S126.is_warp_1 = is_warp_2;
    _S126.x_7 = x_8;
    _S126.y_1 = y_2;
    _S126.height_4 = height_5;
    _S126.normal_1 = normal_2;
    _S126.tangent_0 = tangent_1;
    _S126.surface_normal_0 = surface_normal_1;
    _S126.diffuse_gain_0 = diffuse_gain_1;
    _S126.roughness_1 = roughness_2;
    _S126.albedos_0 = albedos_1;
    _S126.hairs_0 = hairs_1;
    _S126.hair_cover_0 = hair_cover_1;
    return _S126;
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
    var _S127 : Hair_0;
    _S127.cover_1 = cover_2;
    _S127.normal_3 = normal_4;
    _S127.tangent_2 = tangent_3;
    _S127.is_warp_3 = is_warp_4;
    _S127.shade_0 = shade_1;
    return _S127;
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_9 : f32) -> vec2<f32>
{
    var _S128 : f32 = floor(x_9 * 0.63661974668502808f + 0.5f);
    var _S129 : f32 = x_9 - _S128 * 1.5703125f - _S128 * 0.00048375129699707f - _S128 * 7.54979012640433211e-08f;
    var _S130 : f32 = _S129 * _S129;
    var _S131 : f32 = ((-0.00019515295571182f * _S130 + 0.00833216123282909f) * _S130 - 0.16666655242443085f) * _S130 * _S129 + _S129;
    var _S132 : f32 = ((0.00002443315679557f * _S130 - 0.00138873164542019f) * _S130 + 0.04166664555668831f) * _S130 * _S130 - 0.5f * _S130 + 1.0f;
    var _S133 : u32 = (u32(i32(_S128)) & (u32(3)));
    var _S134 : vec2<f32> = select_vector_1(((_S133 & (u32(1)))) != u32(0), vec2<f32>(_S132, _S131), vec2<f32>(_S131, _S132));
    var _S135 : f32 = _S134.x;
    var _S136 : f32 = _S134.y;
    return vec2<f32>(select(_S135, - _S135, ((_S133 & (u32(2)))) != u32(0)), select(_S136, - _S136, (((_S133 + u32(1)) & (u32(2)))) != u32(0)));
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_5 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_6 : f32,
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_10 : f32,
     y_3 : f32,
     shown_share_0 : f32,
};

fn ply_offset_0( family_13 : u32,  point_1 : SurfacePoint_0,  back_8 : bool) -> f32
{
    var _S137 : f32 = (point_1.fibre_across_0 * families_0[family_13].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_13].ply_sine_0, - families_0[family_13].ply_sine_0, back_8)) * families_0[family_13].plies_per_mm_0;
    return 2.0f * (_S137 - floor(_S137)) - 1.0f;
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
    var _S138 : f32 = floor(position_5);
    var _S139 : f32 = position_5 - _S138;
    var _S140 : u32 = u32(i32(_S138));
    var _S141 : f32 = signed_noise_0(hash_bits_0(key_4, _S140));
    var _S142 : f32 = signed_noise_0(hash_bits_0(key_4, _S140 + u32(1)));
    return vec2<f32>(mix(_S141, _S142, smooth_share_0(_S139)), 6.0f * _S139 * (1.0f - _S139) * (_S142 - _S141));
}

fn fibre_cell_0( across_3 : f32,  along_1 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S143 : f32 = floor(across_3 / width_2);
    return vec3<f32>(_S143, along_1 / (width_2 * 40.0f) + 0.61799997091293335f * _S143, 2.0f * (across_3 / width_2 - _S143) - 1.0f);
}

fn cell_noise_0( key_5 : u32,  cell_9 : vec3<f32>) -> vec2<f32>
{
    var _S144 : f32 = cell_9.y;
    var _S145 : f32 = floor(_S144);
    var _S146 : u32 = u32(i32(cell_9.x)) * u32(65536) + u32(i32(_S145));
    var _S147 : u32 = hash_bits_0(key_5, _S146);
    var _S148 : u32 = hash_bits_0(key_5, _S146 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S147), signed_noise_0((_S147 >> (u32(16))))), vec2<f32>(signed_noise_0(_S148), signed_noise_0((_S148 >> (u32(16))))), vec2<f32>(smooth_share_0(_S144 - _S145)));
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
    var _S149 : vec3<f32> = select_vector_0((dot(frame_0.tangent_5, hair_0.tangent_2)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_2), hair_0.tangent_2);
    var blended_0 : YarnFrame_0;
    var _S150 : vec3<f32> = vec3<f32>(hair_0.cover_1);
    var _S151 : vec3<f32> = normalize(mix(frame_0.normal_6, hair_0.normal_3, _S150));
    blended_0.normal_6 = _S151;
    var _S152 : vec3<f32> = mix(frame_0.tangent_5, _S149, _S150);
    var _S153 : vec3<f32> = _S152 - vec3<f32>(dot(_S152, _S151)) * _S151;
    blended_0.tangent_5 = _S153 * vec3<f32>(rsqrt_0(max(dot(_S153, _S153), 9.999999960041972e-13f)));
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
    var _S154 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S154.x, _S154.y), _S154.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S155 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S155.x, _S155.y), _S155.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_10 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_10, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
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
    var _S156 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S157 : vec3<f32> = sends_0.sky_warp_0 + _S156 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S157;
    var _S158 : vec3<f32> = sends_0.sky_weft_0 + _S156 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S158;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S157 + vec3<f32>(sends_0.blocks_weft_0) * _S158;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

struct Scattered_0
{
     back_9 : vec3<f32>,
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

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S159 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S160 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_9 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S160 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S160 * interior_0.far_1 + yarn_2.back_9 * _S159;
    return bounced_0;
}

fn tinted_0( albedos_3 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
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

fn choose_0( table_0 : u32,  count_1 : u32,  number_1 : f32) -> Choice_0
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
        var _S161 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S161)) <= number_1)
        {
            low_0 = _S161;
        }
        else
        {
            high_0 = _S161;
        }
    }
    var _S162 : u32 = table_0 + low_0;
    var _S163 : f32 = scene_number_0(_S162);
    var _S164 : f32 = scene_number_0(_S162 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_1 - _S163) / max(_S164 - _S163, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

struct Light_0
{
     is_point_0 : u32,
     x_11 : f32,
     y_4 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_4 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_4];
    record_1.x_11 = (bitcast<f32>((scene_words_0[first_4 + u32(1)])));
    record_1.y_4 = (bitcast<f32>((scene_words_0[first_4 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_4 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_4 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_4 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_4 + u32(6)])));
    return record_1;
}

fn fourth_power_0( value_1 : f32) -> f32
{
    var _S165 : f32 = value_1 * value_1;
    return _S165 * _S165;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_7 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S166 : f32 = light_1.z;
    if(_S166 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S166, 0.0f), max(dot(light_1, normal_7), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S167 : f32 = dot(direction_4, tangent_6);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S167 * _S167 + 1.0f, roughness_3 * roughness_3));
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
    var _S168 : f32 = roughness_4 * roughness_4;
    var _S169 : f32 = squared_along_0 * (1.0f - _S168) + _S168;
    return 0.31830987334251404f * _S168 * roughness_4 / (_S169 * _S169);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32) -> f32
{
    var _S170 : vec3<f32> = light_2 + view_1;
    var _S171 : f32 = dot(_S170, tangent_7);
    return flake_density_0(min(_S171 * _S171 / max(square_0(_S170), 9.999999960041972e-13f), 1.0f), roughness_5);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_6 : f32,  optical_depth_1 : f32) -> f32
{
    var _S172 : f32 = dot(light_3, normal_8);
    var _S173 : f32 = dot(view_2, normal_8);
    if(((_S172 <= 0.0f) | ((_S173 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S174 : f32 = max(_S172, 9.99999997475242708e-07f);
    var _S175 : f32 = max(_S173, 9.99999997475242708e-07f);
    var _S176 : f32 = projected_area_1(light_3, tangent_8, roughness_6) * _S175 + projected_area_1(view_2, tangent_8, roughness_6) * _S174;
    var _S177 : f32 = optical_depth_1 * _S176 / (_S174 * _S175);
    return 0.25f * density_between_0(light_3, view_2, tangent_8, roughness_6) * (_S177 * mean_attenuation_0(_S177)) * _S174 / _S176;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_7 : f32,  optical_depth_2 : f32) -> f32
{
    var _S178 : f32 = - dot(light_4, normal_9);
    var _S179 : f32 = dot(view_3, normal_9);
    if(((_S178 <= 0.0f) | ((_S179 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S180 : f32 = 1.0f / max(_S179, 9.99999997475242708e-07f);
    var _S181 : f32 = projected_area_1(light_4, tangent_9, roughness_7) / max(_S178, 9.99999997475242708e-07f);
    var _S182 : f32 = projected_area_1(view_3, tangent_9, roughness_7) * _S180;
    return density_between_0(light_4, view_3, tangent_9, roughness_7) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S181, _S182)) * mean_attenuation_0(optical_depth_2 * abs(_S181 - _S182)) * _S180;
}

fn sheen_scale_0( x_12 : f32,  y_5 : f32) -> f32
{
    return (((((0.0f * x_12 + (((((-1.1402510404586792f * y_5 + 0.40672621130943298f) * y_5 + 1.65398800373077393f) * y_5 + -1.29730904102325439f) * y_5 + 0.30570998787879944f) * y_5 + -0.0220868494361639f)) * x_12 + (((((-0.21142719686031342f * y_5 + 1.05947399139404297f) * y_5 + -0.41116121411323547f) * y_5 + -0.93859231472015381f) * y_5 + 0.51606941223144531f) * y_5 + 0.05409301072359085f)) * x_12 + (((((1.22944498062133789f * y_5 + -0.45962560176849365f) * y_5 + -1.63861405849456787f) * y_5 + 1.33565104007720947f) * y_5 + -0.45725581049919128f) * y_5 + 0.08243165910243988f)) * x_12 + (((((0.39779931306838989f * y_5 + -1.18879103660583496f) * y_5 + 0.28251591324806213f) * y_5 + 1.168984055519104f) * y_5 + -0.76864629983901978f) * y_5 + 0.0091691892594099f)) * x_12 + (((((-0.26563560962677002f * y_5 + -0.19379159808158875f) * y_5 + 0.2677634060382843f) * y_5 + 0.00270519289188087f) * y_5 + 0.14349560439586639f) * y_5 + 0.10290180146694183f)) * x_12 + (((((-0.20701569318771362f * y_5 + 0.24526430666446686f) * y_5 + 0.19551840424537659f) * y_5 + 0.07586126774549484f) * y_5 + 0.38894739747047424f) * y_5 + 0.15043120086193085f);
}

fn sheen_shear_0( x_13 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_13 + (((((-0.10608240216970444f * y_6 + 1.99214303493499756f) * y_6 + -1.42255294322967529f) * y_6 + -1.09495604038238525f) * y_6 + 0.59180057048797607f) * y_6 + 0.06902855634689331f)) * x_13 + (((((-0.46220690011978149f * y_6 + -0.29113379120826721f) * y_6 + 1.39025199413299561f) * y_6 + 0.35589990019798279f) * y_6 + -1.17120099067687988f) * y_6 + 0.15940259397029877f)) * x_13 + (((((2.26068711280822754f * y_6 + -3.64728999137878418f) * y_6 + -0.72173482179641724f) * y_6 + 3.07659196853637695f) * y_6 + -0.6827620267868042f) * y_6 + -0.3039557933807373f)) * x_13 + (((((0.81201767921447754f * y_6 + 0.36014080047607422f) * y_6 + -1.72646903991699219f) * y_6 + -0.22630110383033752f) * y_6 + 0.89514690637588501f) * y_6 + -0.10397960245609283f)) * x_13 + (((((-0.37648698687553406f * y_6 + 1.10974001884460449f) * y_6 + 0.17824520170688629f) * y_6 + -1.04968702793121338f) * y_6 + 0.1461234986782074f) * y_6 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_14 : f32,  y_7 : f32) -> f32
{
    return ((((0.0f * x_14 + (((((12.95646953582763672f * y_7 + -21.38032913208007812f) * y_7 + -7.37853097915649414f) * y_7 + 34.55607986450195312f) * y_7 + -23.61347007751464844f) * y_7 + 5.00126314163208008f)) * x_14 + (((((10.91487026214599609f * y_7 + -6.08202791213989258f) * y_7 + -38.2036285400390625f) * y_7 + 53.3440399169921875f) * y_7 + -21.91996002197265625f) * y_7 + 2.01606011390686035f)) * x_14 + (((((-14.52206039428710938f * y_7 + 36.803619384765625f) * y_7 + -22.94047927856445312f) * y_7 + -10.07973003387451172f) * y_7 + 15.77003955841064453f) * y_7 + -4.92722177505493164f)) * x_14 + (((((-7.62505722045898438f * y_7 + 1.27310299873352051f) * y_7 + 31.19523048400878906f) * y_7 + -44.39989852905273438f) * y_7 + 26.44947052001953125f) * y_7 + -8.73507976531982422f)) * x_14 + (((((5.65633487701416016f * y_7 + -17.66820907592773438f) * y_7 + 24.65356063842773438f) * y_7 + -19.38941001892089844f) * y_7 + 11.06159019470214844f) * y_7 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S183 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S184 : f32 = 2.0f * sqrt(_S183) - 1.0f;
    var _S185 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S184, _S185), 0.00999999977648258f, 1.0f), clamp((1.0f - _S183) * sheen_shear_0(_S184, _S185), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S184, _S185), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S186 : f32 = light_5.z;
    if(((_S186 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S187 : vec2<f32> = view_4.xy;
    var _S188 : f32 = dot(_S187, _S187);
    var _S189 : vec2<f32> = select_vector_1(_S188 > 9.99999968265522539e-21f, _S187 * vec2<f32>(rsqrt_0(max(_S188, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S190 : f32 = scale_0 * dot(light_5.xy, _S189) + shear_0 * _S186;
    var _S191 : f32 = scale_0 * (light_5.y * _S189.x - light_5.x * _S189.y);
    var _S192 : f32 = _S190 * _S190 + _S191 * _S191 + _S186 * _S186;
    return 0.31830987334251404f * scale_0 * scale_0 * _S186 / max(_S192 * _S192, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S193 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_9);
    var _S194 : f32 = strength_0 * _S193.z;
    return vec2<f32>(_S194 * transformed_cosine_0(light_6, view_5, _S193.x, _S193.y), 1.0f - _S194);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S195 : f32 = light_7.z;
    return select_vector_0((_S195 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S195) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S196 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S196 * (1.0f - light_8.w);
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

fn uneven_shift_0( _S197 : u32,  _S198 : u32,  _S199 : u32,  _S200 : vec2<f32>) -> f32
{
    var _S201 : f32 = families_0[_S199].period_0 / families_0[_S199].count_0;
    var _S202 : u32 = hash_key_0(_S198, ((fabrics_0[_S197].seed_0) ^ (u32(625341585))));
    var _S203 : vec2<f32> = vec2<f32>(_S200.x, _S200.y / 4.0f) / vec2<f32>(_S201);
    return 0.20000000298023224f * sqrt(families_0[_S199].slub_0) * _S201 * (uneven_octave_0(_S202, _S203) * 0.66666668653488159f + uneven_octave_0(_S202 + u32(1), vec2<f32>(2.0f) * _S203 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S204 : u32,  _S205 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S204].has_detail_0) == u32(0), _S205, _S205 + vec2<f32>(uneven_shift_0(_S204, u32(0), fabrics_0[_S204].warp_0, _S205), uneven_shift_0(_S204, u32(1), fabrics_0[_S204].weft_0, _S205.yx)));
}

fn face_point_0( _S206 : u32,  _S207 : u32,  _S208 : f32,  _S209 : f32) -> VisiblePoint_0
{
    var _S210 : u32 = u32(3) * _S207;
    var _S211 : Vertex_0 = vertex_at_0(_S210);
    var _S212 : Vertex_0 = vertex_at_0(_S210 + u32(1));
    var _S213 : Vertex_0 = vertex_at_0(_S210 + u32(2));
    var _S214 : vec3<f32> = position_of_0(_S211);
    var _S215 : vec3<f32> = position_of_0(_S212) - _S214;
    var _S216 : vec3<f32> = position_of_0(_S213) - _S214;
    var _S217 : f32 = _S212.u_0 - _S211.u_0;
    var _S218 : f32 = _S212.v_0 - _S211.v_0;
    var _S219 : vec2<f32> = vec2<f32>(_S217, _S218);
    var _S220 : f32 = _S213.u_0 - _S211.u_0;
    var _S221 : f32 = _S213.v_0 - _S211.v_0;
    var _S222 : vec2<f32> = vec2<f32>(_S220, _S221);
    var _S223 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S217 * _S221 - _S218 * _S220) < 0.0f));
    var _S224 : vec3<f32> = _S223 * (vec3<f32>(_S221) * _S215 - vec3<f32>(_S218) * _S216);
    var _S225 : vec3<f32> = _S223 * (vec3<f32>(_S217) * _S216 - vec3<f32>(_S220) * _S215);
    var point_2 : VisiblePoint_0;
    var _S226 : vec3<f32> = vec3<f32>(_S208);
    var _S227 : vec3<f32> = vec3<f32>(_S209);
    var _S228 : vec3<f32> = normalize(vec3<f32>((1.0f - _S208 - _S209)) * normal_of_0(_S211) + _S226 * normal_of_0(_S212) + _S227 * normal_of_0(_S213));
    point_2.normal_0 = _S228;
    var _S229 : vec3<f32> = normalize(_S224 - _S228 * vec3<f32>(dot(_S228, _S224)));
    point_2.axis_x_0 = _S229;
    point_2.axis_y_0 = cross(_S228, _S229);
    var _S230 : vec3<f32> = normalize(cross(_S215, _S216));
    point_2.face_normal_0 = select_vector_0((dot(_S230, _S228)) < 0.0f, (vec3<f32>(0) - _S230), _S230);
    point_2.position_4 = _S214 + _S226 * _S215 + _S227 * _S216;
    point_2.view_0 = _S228;
    var _S231 : vec2<f32> = vec2<f32>(_S211.u_0, _S211.v_0) + vec2<f32>(_S208) * _S219 + vec2<f32>(_S209) * _S222;
    point_2.uv_1 = _S231;
    var _S232 : bool = (dot(cross(_S224, _S225), _S228)) < 0.0f;
    var _S233 : vec2<f32> = vec2<f32>(fabrics_0[_S206].uv_width_0, select(fabrics_0[_S206].uv_height_0, - fabrics_0[_S206].uv_height_0, _S232));
    point_2.draft_per_uv_0 = _S233;
    point_2.draft_0 = uneven_place_0(_S206, _S231 * _S233 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S206].uv_height_0, _S232)));
    var _S234 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S234;
    point_2.draft_dy_0 = _S234;
    return point_2;
}

fn visible_point_0( _S235 : u32,  _S236 : u32,  _S237 : vec2<u32>) -> VisiblePoint_0
{
    var _S238 : u32 = u32(3) * _S236;
    var _S239 : Vertex_0 = vertex_at_0(_S238);
    var _S240 : Vertex_0 = vertex_at_0(_S238 + u32(1));
    var _S241 : Vertex_0 = vertex_at_0(_S238 + u32(2));
    var _S242 : vec3<f32> = position_of_0(_S239);
    var _S243 : vec3<f32> = position_of_0(_S240) - _S242;
    var _S244 : vec3<f32> = position_of_0(_S241) - _S242;
    var _S245 : vec3<f32> = cross(_S243, _S244);
    var _S246 : f32 = f32(frame_record_0.width_0);
    var _S247 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S246));
    var _S248 : f32 = f32(frame_record_0.height_0);
    var _S249 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S248));
    var _S250 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S237.x) + 0.5f - 0.5f * _S246)) * _S247 + vec3<f32>((f32(_S237.y) + 0.5f - 0.5f * _S248)) * _S249;
    var _S251 : f32 = dot(_S250, _S245);
    var _S252 : f32 = 1.0f / select(1.00000000317107685e-30f, _S251, (abs(_S251)) > 1.00000000317107685e-30f);
    var _S253 : vec3<f32> = _S242 - camera_origin_0();
    var _S254 : vec3<f32> = vec3<f32>((dot(_S253, _S245) * _S252));
    var _S255 : vec3<f32> = _S250 * _S254 - _S253;
    var _S256 : vec3<f32> = _S254 * (_S247 - _S250 * vec3<f32>((dot(_S247, _S245) * _S252)));
    var _S257 : vec3<f32> = _S254 * (_S249 - _S250 * vec3<f32>((dot(_S249, _S245) * _S252)));
    var _S258 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S245), 1.00000000317107685e-30f)));
    var _S259 : vec3<f32> = cross(_S244, _S245) * _S258;
    var _S260 : vec3<f32> = cross(_S245, _S243) * _S258;
    var _S261 : vec2<f32> = vec2<f32>(_S240.u_0 - _S239.u_0, _S240.v_0 - _S239.v_0);
    var _S262 : vec2<f32> = vec2<f32>(_S241.u_0 - _S239.u_0, _S241.v_0 - _S239.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S235, _S236, dot(_S255, _S259), dot(_S255, _S260));
    point_3.position_4 = _S242 + _S255;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S250));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S256, _S259)) * _S261 + vec2<f32>(dot(_S256, _S260)) * _S262) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S257, _S259)) * _S261 + vec2<f32>(dot(_S257, _S260)) * _S262) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S263 : u32,  _S264 : VisiblePoint_0) -> vec3<f32>
{
    var _S265 : u32 = fabrics_0[_S263].albedo_map_levels_0;
    if((fabrics_0[_S263].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S266 : vec2<f32> = vec2<f32>(fabrics_0[_S263].uv_width_0, fabrics_0[_S263].uv_height_0);
    var _S267 : vec2<f32> = _S264.draft_dx_0 / _S266;
    var _S268 : vec2<f32> = _S264.draft_dy_0 / _S266;
    var _S269 : u32 = _S265 - u32(1);
    var _S270 : u32 = (u32(1) << (_S269));
    var _S271 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S267.x * _S268.y - _S267.y * _S268.x), 9.99999968265522539e-21f) * (square_1(f32(_S270)) / 3.0f)), 0.0f, f32(_S265) - 1.0f);
    var _S272 : u32 = min(u32(_S271), max(_S265, u32(2)) - u32(2));
    var _S273 : u32 = min(_S272 + u32(1), _S269);
    var _S274 : u32 = (u32(1) << ((u32(2) * _S265)));
    return mix(map_level_0(fabrics_0[_S263].albedo_map_0 + (_S274 - ((_S274 >> ((u32(2) * _S272))))) / u32(3), (_S270 >> (_S272)), _S264.uv_1), map_level_0(fabrics_0[_S263].albedo_map_0 + (_S274 - ((_S274 >> ((u32(2) * _S273))))) / u32(3), (_S270 >> (_S273)), _S264.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S271 - f32(_S272))) - 1.0f) / 3.0f)));
}

fn irregular_key_0( _S275 : u32,  _S276 : u32) -> u32
{
    return hash_key_0(_S276, ((fabrics_0[_S275].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S277 : u32,  _S278 : vec2<f32>,  _S279 : f32) -> vec2<f32>
{
    var _S280 : u32 = fabrics_0[_S277].warp_0;
    var _S281 : u32 = fabrics_0[_S277].weft_0;
    var _S282 : bool = (((fabrics_0[_S277].is_irregular_0) != u32(0)) & (((max(moved_share_0(fabrics_0[_S277].warp_0, _S279), moved_share_0(fabrics_0[_S277].weft_0, _S279))) > 0.0f)));
    var number_2 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S278;
    for(;;)
    {
        if(number_2 < select(u32(0), u32(2), _S282))
        {
        }
        else
        {
            break;
        }
        var _S283 : bool = number_2 == u32(0);
        var _S284 : u32 = select(_S281, _S280, _S283);
        var _S285 : vec2<f32> = select_vector_1(_S283, _S278, _S278.yx);
        var _S286 : u32 = irregular_key_0(_S277, number_2);
        var _S287 : f32 = _S285.x;
        var _S288 : Cell_0 = locate_0(_S284, _S287);
        var _S289 : f32 = irregular_thread_0(_S284, _S287, _S288);
        var _S290 : f32 = select(1.0f, -1.0f, (_S288.across_0) < 0.0f);
        var _S291 : vec2<f32> = vec2<f32>(0.0f);
        var other_2 : vec2<f32> = _S291;
        var own_1 : vec2<f32> = _S291;
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
            var _S292 : vec2<f32> = irregular_at_0(_S284, _S286, _S289 + _S290 * f32(neighbour_0), _S285.y).xy;
            var _S293 : u32 = neighbour_0 + u32(1);
            own_1 = other_2;
            other_2 = _S292;
            neighbour_0 = _S293;
        }
        var _S294 : f32 = _S288.below_0 + _S288.above_0;
        var _S295 : f32 = min(_S288.half_width_1 / _S294, 0.5f);
        var _S296 : f32 = min(_S295 * (2.0f + own_1.y + other_2.y), 1.0f);
        var _S297 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_2.x), vec2<f32>(0.25f)));
        var _S298 : f32 = _S297.x;
        var _S299 : f32 = _S296 * _S298 / (_S298 + _S297.y);
        var _S300 : f32 = abs(_S288.across_0) / _S294;
        var _S301 : f32 = 1.0f - _S296;
        var _S302 : f32 = _S300 - _S299;
        var _S303 : f32 = moved_share_0(_S284, _S279) * _S290 * _S294 * (select(select((_S302 - _S301) / max(_S296 - _S299, 9.99999997475242708e-07f) * _S295 + (1.0f - _S295), _S302 / max(_S301, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S295) + _S295, _S302 < _S301), _S300 * _S295 / _S299, _S302 < 0.0f) - _S300);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S283, vec2<f32>(_S303, 0.0f), vec2<f32>(0.0f, _S303));
        number_2 = number_2 + u32(1);
        moved_0 = moved_1;
    }
    return moved_0;
}

struct Hit_0
{
     x_15 : f32,
     y_8 : f32,
     hole_5 : bool,
     height_7 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_8 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S304 : u32,  _S305 : f32,  _S306 : f32,  _S307 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S304].warp_0, _S305);
    crossing_2.weft_1 = locate_0(fabrics_0[_S304].weft_0, _S306);
    var _S308 : u32 = fabrics_0[_S304].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S304].ends_1 + crossing_2.warp_1.thread_2);
    var _S309 : u32 = words_0[_S308];
    crossing_2.warp_word_0 = _S309;
    crossing_2.weft_word_0 = words_0[_S308 + u32(1)];
    crossing_2.warp_above_0 = (((_S309 & (u32(1)))) == u32(1)) != _S307;
    return crossing_2;
}

fn sample_at_0( _S310 : u32,  _S311 : f32,  _S312 : f32,  _S313 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S314 : Crossing_0 = crossing_at_0(_S310, _S311, _S312, _S313);
    sample_0.crossing_1 = _S314;
    var _S315 : Shown_0 = shown_at_0(_S314, _S313);
    sample_0.shown_3 = _S315;
    var _S316 : u32 = select(fabrics_0[_S310].weft_0, fabrics_0[_S310].warp_0, _S315.is_warp_0);
    var _S317 : u32 = select(fabrics_0[_S310].warp_0, fabrics_0[_S310].weft_0, _S315.is_warp_0);
    var _S318 : Cell_0 = select_cell_0(_S315.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S319 : Cell_0 = select_cell_0(_S315.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S320 : Run_0 = unpack_0(_S316, _S317, _S318.thread_2, _S319, _S315.word_0);
    var _S321 : Section_0 = section_at_0(_S318);
    var _S322 : bool = ((_S315.on_top_0) & (((_S320.distance_0) < (_S321.drop_0 * _S320.bend_1.sine_0))));
    var _S323 : f32 = select(-1.0f, 1.0f, ((_S315.on_top_0) & ((!_S322))));
    var _S324 : f32 = select(_S320.reach_0, _S320.other_reach_0, _S322);
    var _S325 : f32 = select(max(_S324 - _S320.distance_0, 0.0f), _S324 + _S320.distance_0, _S322);
    var _S326 : f32 = _S324 / _S320.bend_1.sine_0 - _S323 * _S321.drop_0;
    var _S327 : f32 = _S325 * _S325;
    var _S328 : f32 = max(_S326 * _S326 - _S327, 9.99999968265522539e-21f);
    var _S329 : f32 = rsqrt_0(_S328);
    var _S330 : f32 = _S327 / (_S328 * _S329 + _S326);
    var _S331 : bool = _S325 > 0.0f;
    var _S332 : f32 = select(-1.0f, 1.0f, _S315.on_top_0) * select(-1.0f, 1.0f, _S320.near_start_0);
    var _S333 : f32 = _S321.slope_0 * select(1.0f, _S326 * _S329, _S331);
    sample_0.slope_across_0 = _S333;
    var _S334 : f32 = select(0.0f, _S332 * _S325 * _S329, _S331);
    sample_0.slope_along_0 = _S334;
    var _S335 : vec3<f32> = dive_0(_S317, _S315, _S320, _S319);
    sample_0.dive_1 = _S335;
    sample_0.height_8 = select(families_0[_S316].height_scale_0 * _S323, 0.0f, _S320.straight_0) * (_S324 * _S320.bend_1.half_tangent_0 - _S330) - families_0[_S316].height_scale_0 * _S321.drop_0 - _S335.x;
    var _S336 : f32 = families_0[_S316].height_scale_0 * _S333;
    var _S337 : f32 = families_0[_S316].height_scale_0 * _S334 - _S335.y;
    sample_0.slope_x_1 = select(_S337, _S336, _S315.is_warp_0);
    sample_0.slope_y_1 = select(_S336, _S337, _S315.is_warp_0);
    sample_0.run_3 = _S320;
    sample_0.section_1 = _S321;
    return sample_0;
}

fn steps_per_length_0( _S338 : u32,  _S339 : SearchQuality_0,  _S340 : vec3<f32>) -> f32
{
    return max(max(abs(_S340.x) * fabrics_0[_S338].threads_per_x_0, abs(_S340.y) * fabrics_0[_S338].threads_per_y_0) * _S339.steps_per_thread_0, abs(_S340.z) * fabrics_0[_S338].per_relief_0 * _S339.steps_per_relief_0);
}

fn cell_maximum_0( _S341 : u32,  _S342 : Crossing_0) -> f32
{
    var _S343 : u32 = select(fabrics_0[_S341].weft_0, fabrics_0[_S341].warp_0, _S342.warp_above_0);
    return f32((select(_S342.weft_word_0, _S342.warp_word_0, _S342.warp_above_0) >> (u32(28)))) * families_0[_S343].height_scale_0 * families_0[_S343].level_0;
}

fn probe_0( _S344 : u32,  _S345 : f32,  _S346 : f32,  _S347 : bool,  _S348 : bool,  _S349 : bool) -> Probe_0
{
    var _S350 : Sample_0 = sample_at_0(_S344, _S345, _S346, _S347);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S350.height_8;
    probe_1.hole_1 = _S350.shown_3.hole_0;
    probe_1.slope_x_0 = _S350.slope_x_1;
    probe_1.slope_y_0 = _S350.slope_y_1;
    probe_1.yarn_1 = select(_S350.crossing_1.weft_1.thread_2 * u32(2), _S350.crossing_1.warp_1.thread_2 * u32(2) + u32(1), _S350.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S344, _S350.crossing_1);
    probe_1.side_x_0 = select(_S350.crossing_1.warp_1.below_0, _S350.crossing_1.warp_1.above_0, _S348);
    probe_1.side_y_0 = select(_S350.crossing_1.weft_1.below_0, _S350.crossing_1.weft_1.above_0, _S349);
    probe_1.edge_x_0 = outline_distance_0(_S350.crossing_1.warp_1, _S350.shown_3, _S350.run_3, !_S350.shown_3.is_warp_0, _S348);
    probe_1.edge_y_0 = outline_distance_0(_S350.crossing_1.weft_1, _S350.shown_3, _S350.run_3, _S350.shown_3.is_warp_0, _S349);
    return probe_1;
}

fn is_free_0( _S351 : u32,  _S352 : SearchQuality_0,  _S353 : vec3<f32>,  _S354 : vec3<f32>,  _S355 : bool,  _S356 : f32) -> bool
{
    var _S357 : f32 = _S354.z;
    if(_S357 <= 0.0f)
    {
        return false;
    }
    var _S358 : f32 = 1.0f / max(_S352.shadow_share_0 * steps_per_length_0(_S351, _S352, _S354), 9.99999971718068537e-10f);
    var _S359 : StepControl_0 = step_control_0(_S354.xy, _S358);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S353.z + _S357 * distance_1) < _S356))))
        {
        }
        else
        {
            break;
        }
        var _S360 : vec3<f32> = _S353 + _S354 * vec3<f32>(distance_1);
        var _S361 : Probe_0 = probe_0(_S351, _S360.x, _S360.y, _S355, _S359.right_0, _S359.up_0);
        var _S362 : f32 = _S360.z;
        var _S363 : f32 = _S362 - _S361.height_2;
        var _S364 : f32 = _S357 - _S361.slope_x_0 * _S354.x - _S361.slope_y_0 * _S354.y;
        if(((!_S361.hole_1) & ((_S363 < 0.0f))))
        {
            return false;
        }
        var _S365 : f32 = way_back_to_dip_0(previous_3, _S363, _S364, last_step_0, _S361);
        if(_S365 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S365;
            distance_1 = distance_1 - _S365;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S366 : bool = _S362 > (_S361.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S359, _S361, _S363, _S364), max(StepControl_to_cell_exit_0(_S359, _S361.side_x_0, _S361.side_y_0), _S358), _S366);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S363, _S364, _S361, _S366);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S367 : u32,  _S368 : SearchQuality_0,  _S369 : f32,  _S370 : f32,  _S371 : vec3<f32>,  _S372 : bool) -> bool
{
    if(!sample_at_0(_S367, _S369, _S370, _S372).shown_3.hole_0)
    {
        return false;
    }
    var _S373 : vec3<f32> = vec3<f32>(_S369, _S370, 0.0f);
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
        var _S374 : bool = is_free_0(_S367, _S368, _S373, select_vector_0(side_2 == u32(0), _S371, vec3<f32>(- _S371.x, - _S371.y, _S371.z)), _S372 != (side_2 == u32(1)), fabrics_0[_S367].height_high_0);
        var _S375 : u32 = side_2 + u32(1);
        passes_0 = _S374;
        side_2 = _S375;
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

fn max_height_along_0( _S376 : u32,  _S377 : f32,  _S378 : f32,  _S379 : f32,  _S380 : vec3<f32>,  _S381 : bool) -> f32
{
    var _S382 : f32 = _S380.x;
    var _S383 : f32 = _S380.y;
    var _S384 : u32 = (words_0[fabrics_0[_S376].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S376].weft_0, _S378).thread_2 / u32(2) * fabrics_0[_S376].max_height_columns_0 + locate_0(fabrics_0[_S376].warp_0, _S377).thread_2 / u32(2)) + (select(u32(0), u32(1), _S382 > 0.0f) + select(u32(0), u32(2), _S383 > 0.0f))] >> (u32(select(i32(0), i32(4), _S381))));
    var _S385 : f32 = max(abs(_S382) * fabrics_0[_S376].threads_per_x_0, abs(_S383) * fabrics_0[_S376].threads_per_y_0) / _S380.z;
    var _S386 : f32 = fabrics_0[_S376].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S376].height_high_0;
    var number_3 : i32 = i32(3);
    for(;;)
    {
        if(number_3 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S379) * _S385) <= (PYRAMID_RADII_0[number_3]))
        {
            max_height_0 = min(max_height_0, f32((((_S384 >> (u32(i32(8) * number_3)))) & (u32(15)))) * 0.06666667014360428f * _S386);
        }
        number_3 = number_3 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S387 : u32,  _S388 : f32,  _S389 : f32,  _S390 : bool,  _S391 : bool,  _S392 : bool) -> vec3<f32>
{
    var _S393 : Crossing_0 = crossing_at_0(_S387, _S388, _S389, _S390);
    return vec3<f32>(cell_maximum_0(_S387, _S393), select(_S393.warp_1.below_0, _S393.warp_1.above_0, _S391), select(_S393.weft_1.below_0, _S393.weft_1.above_0, _S392));
}

fn first_sample_height_0( _S394 : u32,  _S395 : ViewRay_0,  _S396 : StepControl_0,  _S397 : bool) -> f32
{
    var _S398 : f32 = max_height_along_0(_S394, _S395.origin_0.x, _S395.origin_0.y, 0.0f, vec3<f32>(_S395.slope_1, 1.0f), _S397);
    var count_3 : u32 = u32(0);
    var height_10 : f32 = _S398;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S399 : vec2<f32> = ViewRay_at_0(_S395, height_10);
        var _S400 : vec3<f32> = cell_bounds_0(_S394, _S399.x, _S399.y, _S397, _S396.right_0, _S396.up_0);
        var _S401 : f32 = height_10 - _S400.x;
        var _S402 : f32 = StepControl_to_cell_exit_0(_S396, _S400.y, _S400.z);
        var height_11 : f32 = height_10 - clamp(_S401, 0.0f, _S402);
        if(_S401 <= _S402)
        {
            height_10 = height_11;
            break;
        }
        count_3 = count_3 + u32(1);
        height_10 = height_11;
    }
    return height_10;
}

fn search_down_0( _S403 : u32,  _S404 : ViewRay_0,  _S405 : StepControl_0,  _S406 : bool) -> ViewRayEnd_0
{
    var _S407 : f32 = fabrics_0[_S403].height_low_0 - (fabrics_0[_S403].height_high_0 - fabrics_0[_S403].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_9 = first_sample_height_0(_S403, _S404, _S405, _S406);
    end_1.last_step_3 = _S405.epsilon_0;
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
        var _S408 : vec2<f32> = ViewRay_at_0(_S404, end_1.height_9);
        var _S409 : Probe_0 = probe_0(_S403, _S408.x, _S408.y, _S406, _S405.right_0, _S405.up_0);
        var _S410 : f32 = end_1.height_9 - _S409.height_2;
        var _S411 : f32 = ViewRay_rate_0(_S404, _S409);
        end_1.depth_2 = - _S410;
        end_1.rate_4 = _S411;
        var _S412 : bool = !_S409.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S412))) & (((end_1.previous_4.yarn_0) == (_S409.yarn_1))));
        if((((_S412 & ((_S410 <= 0.0f)))) | (((end_1.height_9) <= _S407))))
        {
            break;
        }
        var _S413 : f32 = way_back_to_dip_0(end_1.previous_4, _S410, _S411, end_1.last_step_3, _S409);
        if(_S413 >= 0.0f)
        {
            end_1.height_9 = end_1.height_9 + _S413;
            end_1.last_step_3 = end_1.last_step_3 - _S413;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S414 : f32 = min(StepControl_to_cell_exit_0(_S405, _S409.side_x_0, _S409.side_y_0), end_1.height_9 - _S409.cell_max_0);
        var _S415 : f32 = StepControl_to_next_sample_0(_S405, _S409, _S410, _S411);
        end_1.previous_4 = after_sample_0(_S410, _S411, _S409, _S414 > _S415);
        var _S416 : f32 = max(_S414, _S415);
        end_1.last_step_3 = _S416;
        end_1.height_9 = end_1.height_9 - _S416;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S417 : u32,  _S418 : ViewRay_0,  _S419 : StepControl_0,  _S420 : bool,  _S421 : ViewRayEnd_0,  _S422 : u32) -> f32
{
    var _S423 : f32 = fabrics_0[_S417].height_high_0 - fabrics_0[_S417].height_low_0;
    var above_2 : f32 = _S421.height_9 + _S421.last_step_3;
    var above_gap_1 : f32 = clamp(_S421.previous_4.clearance_0, 0.0f, _S423);
    var under_gap_1 : f32 = clamp(_S421.depth_2, 0.0f, _S423);
    var middle_0 : f32 = select(between_0(above_2, _S421.height_9, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S421.previous_4.rate_0 * _S421.last_step_3, _S421.rate_4 * _S421.last_step_3) * _S421.last_step_3, _S421.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S421.height_9;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S422)
        {
        }
        else
        {
            break;
        }
        var _S424 : vec2<f32> = ViewRay_at_0(_S418, middle_0);
        var _S425 : Probe_0 = probe_0(_S417, _S424.x, _S424.y, _S420, _S419.right_0, _S419.up_0);
        var _S426 : f32 = clamp(middle_0 - select(_S425.height_2, -1.0e+09f, _S425.hole_1), - _S423, _S423);
        if(_S426 <= 0.0f)
        {
            var _S427 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S428 : f32 = - _S426;
            under_1 = middle_0;
            above_gap_2 = _S427;
            under_gap_2 = _S428;
            side_3 = 1.0f;
        }
        else
        {
            var _S429 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S426;
            under_gap_2 = _S429;
            side_3 = -1.0f;
        }
        var _S430 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S426 / min(ViewRay_rate_0(_S418, _S425), -9.99999997475242708e-07f), under_1, above_3), _S421.smooth_0);
        var _S431 : u32 = i_1 + u32(1);
        middle_0 = _S430;
        i_1 = _S431;
    }
    return select(under_1, middle_0, _S421.smooth_0);
}

fn first_hit_of_yarn_0( _S432 : u32,  _S433 : SearchQuality_0,  _S434 : f32,  _S435 : f32,  _S436 : vec3<f32>,  _S437 : bool) -> Hit_0
{
    var _S438 : f32 = max(_S436.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S434, _S435);
    var _S439 : vec2<f32> = _S436.xy / vec2<f32>(_S438);
    ray_0.slope_1 = _S439;
    var _S440 : StepControl_0 = step_control_0((vec2<f32>(0) - _S439), 1.0f / max(steps_per_length_0(_S432, _S433, _S436) / _S438, 9.99999971718068537e-10f));
    var _S441 : ViewRayEnd_0 = search_down_0(_S432, ray_0, _S440, _S437);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S442 : f32 = refined_height_0(_S432, ray_0, _S440, _S437, _S441, _S433.refinements_0);
    hit_0.height_7 = _S442;
    var _S443 : vec2<f32> = ViewRay_at_0(ray_0, _S442);
    hit_0.x_15 = _S443.x;
    hit_0.y_8 = _S443.y;
    return hit_0;
}

fn first_hit_0( _S444 : u32,  _S445 : SearchQuality_0,  _S446 : f32,  _S447 : f32,  _S448 : vec3<f32>,  _S449 : bool) -> Hit_0
{
    if(!passes_through_0(_S444, _S445, _S446, _S447, _S448, _S449))
    {
        return first_hit_of_yarn_0(_S444, _S445, _S446, _S447, _S448, _S449);
    }
    var hit_1 : Hit_0;
    hit_1.x_15 = _S446;
    hit_1.y_8 = _S447;
    hit_1.height_7 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_of_0( _S450 : u32,  _S451 : Sample_0,  _S452 : f32,  _S453 : f32,  _S454 : bool) -> SurfacePoint_0
{
    var _S455 : u32 = select(fabrics_0[_S450].weft_0, fabrics_0[_S450].warp_0, _S451.shown_3.is_warp_0);
    var _S456 : f32 = families_0[_S455].twist_sine_0 * select(1.0f, -1.0f, _S454);
    var _S457 : f32 = select(-1.0f, 1.0f, _S451.shown_3.is_warp_0);
    var _S458 : vec2<f32> = fibre_direction_0(_S451.slope_across_0, _S457 * _S451.slope_along_0, _S456, families_0[_S455].twist_cosine_0);
    var _S459 : f32 = _S458.x;
    var _S460 : f32 = _S458.y;
    var _S461 : f32 = select(_S451.slope_y_1, _S451.slope_x_1, _S451.shown_3.is_warp_0) * _S459 + _S457 * select(_S451.slope_x_1, _S451.slope_y_1, _S451.shown_3.is_warp_0) * _S460;
    var _S462 : f32 = select(_S451.crossing_1.weft_1.half_width_1, _S451.crossing_1.warp_1.half_width_1, _S451.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S463 : f32 = _S462 * arc_sine_0(clamp(_S451.section_1.across_1 / _S462, -1.0f, 1.0f));
    var _S464 : f32 = select(- _S452, _S453, _S451.shown_3.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_4 = _S451.shown_3.hole_0;
    point_4.is_warp_5 = _S451.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S451.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S451.crossing_1.weft_1.thread_2;
    point_4.height_6 = _S451.height_8;
    point_4.normal_5 = normalize(vec3<f32>(- _S451.slope_x_1, - _S451.slope_y_1, 1.0f));
    point_4.tangent_4 = normalize(select_vector_0(_S451.shown_3.is_warp_0, vec3<f32>(_S459, _S460, _S461), vec3<f32>(- _S460, _S459, _S461)));
    point_4.across_2 = _S451.section_1.across_1;
    point_4.fibre_across_0 = _S463 * families_0[_S455].twist_cosine_0 + _S464 * _S456;
    point_4.fibre_along_0 = _S464 * families_0[_S455].twist_cosine_0 - _S463 * _S456;
    var _S465 : f32 = run_share_0(_S451.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S465, _S465, _S451.shown_3.on_top_0);
    point_4.x_10 = _S452;
    point_4.y_3 = _S453;
    return point_4;
}

fn surface_met_0( _S466 : u32,  _S467 : f32,  _S468 : f32,  _S469 : f32,  _S470 : vec3<f32>,  _S471 : bool) -> SurfacePoint_0
{
    var _S472 : Sample_0 = sample_at_0(_S466, _S467, _S468, _S471);
    var point_5 : SurfacePoint_0 = surface_of_0(_S466, _S472, _S467, _S468, _S471);
    var _S473 : u32 = select(fabrics_0[_S466].weft_0, fabrics_0[_S466].warp_0, point_5.is_warp_5);
    var _S474 : f32 = select(_S472.crossing_1.weft_1.half_width_1, _S472.crossing_1.warp_1.half_width_1, point_5.is_warp_5) * 1.0154266357421875f;
    var _S475 : f32 = _S472.dive_1.z;
    var _S476 : f32 = _S472.slope_along_0 - (1.0f - _S475) * _S472.dive_1.y / families_0[_S473].height_scale_0;
    var _S477 : f32 = rsqrt_0(_S476 * _S476 + 1.0f);
    var _S478 : f32 = _S470.x;
    var _S479 : f32 = _S470.y;
    var _S480 : f32 = select(_S479, _S478, point_5.is_warp_5);
    var _S481 : f32 = _S470.z;
    var _S482 : f32 = (_S481 / families_0[_S473].height_scale_0 - _S476 * select(_S478, _S479, point_5.is_warp_5)) * _S477;
    var _S483 : f32 = square_1(_S474);
    var _S484 : f32 = sqrt(max(_S483 - square_1(point_5.across_2), 0.0f)) - (_S472.height_8 + _S475 * _S472.dive_1.x - _S469) / families_0[_S473].height_scale_0 * _S477;
    var _S485 : f32 = square_1(_S480) + square_1(_S482) + 9.999999960041972e-13f;
    var _S486 : f32 = point_5.across_2 * _S480 + _S484 * _S482;
    var _S487 : f32 = square_1(point_5.across_2) + square_1(_S484) - _S483;
    var _S488 : f32 = sqrt(max(square_1(_S486) - _S485 * _S487, 0.0f));
    var _S489 : f32 = clamp(select((_S488 - _S486) / _S485, - _S487 / max(_S486 + _S488, 9.999999960041972e-13f), _S486 > 0.0f), - _S474, _S474);
    var _S490 : f32 = point_5.across_2 + _S489 * _S480;
    point_5.across_2 = _S490;
    var _S491 : vec2<f32> = normalize(vec2<f32>(_S490, _S484 + _S489 * _S482));
    var _S492 : f32 = select(-1.0f, 1.0f, point_5.is_warp_5);
    var _S493 : f32 = families_0[_S473].twist_sine_0 * select(1.0f, -1.0f, _S471);
    var _S494 : f32 = _S491.x;
    var _S495 : f32 = _S493 * _S494 * _S477;
    var _S496 : f32 = _S491.y;
    var _S497 : f32 = - _S493 * _S496;
    var _S498 : f32 = families_0[_S473].twist_cosine_0 * _S477 - _S492 * _S476 * _S495;
    var _S499 : f32 = families_0[_S473].height_scale_0 * (families_0[_S473].twist_cosine_0 * _S492 * _S476 * _S477 + _S495);
    var _S500 : f32 = families_0[_S473].height_scale_0 * _S494;
    var _S501 : f32 = - families_0[_S473].height_scale_0 * _S476 * _S477 * _S496;
    point_5.normal_5 = normalize(vec3<f32>(select(_S501, _S500, point_5.is_warp_5), select(_S500, _S501, point_5.is_warp_5), _S477 * _S496));
    point_5.tangent_4 = normalize(vec3<f32>(select(- _S498, _S497, point_5.is_warp_5), select(_S497, _S498, point_5.is_warp_5), _S499));
    var _S502 : f32 = _S474 * angle_of_0(_S491);
    var _S503 : f32 = select(- _S467 - _S489 * _S478, _S468 + _S489 * _S479, point_5.is_warp_5);
    point_5.fibre_across_0 = _S502 * families_0[_S473].twist_cosine_0 + _S503 * _S493;
    point_5.fibre_along_0 = _S503 * families_0[_S473].twist_cosine_0 - _S502 * _S493;
    var _S504 : f32 = 0.00999999977648258f * _S474;
    var _S505 : f32 = - _S504;
    var _S506 : bool = _S489 < _S505;
    var _S507 : f32 = select(_S504, _S505, _S480 < 0.0f);
    var _S508 : f32 = max(_S489, 0.0f);
    point_5.x_10 = point_5.x_10 + select(_S508 * _S478, select(0.0f, _S507, point_5.is_warp_5), _S506);
    point_5.y_3 = point_5.y_3 + select(_S508 * _S479, select(_S507, 0.0f, point_5.is_warp_5), _S506);
    point_5.height_6 = select(_S469 + _S489 * _S481, _S469, _S506);
    return point_5;
}

fn hairs_over_0( _S509 : u32,  _S510 : SurfacePoint_0,  _S511 : bool,  _S512 : f32) -> Hairs_0
{
    var hairs_2 : Hairs_0;
    hairs_2.place_1 = vec2<f32>(_S510.x_10, _S510.y_3);
    hairs_2.below_1 = fabrics_0[_S509].height_high_0 - _S510.height_6;
    hairs_2.back_4 = _S511;
    hairs_2.size_3 = _S512;
    return hairs_2;
}

fn has_hairs_0( _S513 : u32) -> bool
{
    return (((families_0[fabrics_0[_S513].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S513].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S514 : u32,  _S515 : Hairs_0,  _S516 : vec3<f32>,  _S517 : f32) -> Hair_0
{
    var _S518 : f32 = fabrics_0[_S514].fibre_size_0;
    var _S519 : f32 = 17.0f * fabrics_0[_S514].fibre_size_0;
    var _S520 : f32 = fade_0(_S517, _S519);
    var _S521 : vec2<f32> = _S516.xy / vec2<f32>(max(_S516.z, 0.3333333432674408f));
    var _S522 : u32 = hash_key_0(select(u32(0), u32(1), _S515.back_4), ((fabrics_0[_S514].seed_0) ^ (u32(1013904242))));
    var _S523 : f32 = fabrics_0[_S514].fibre_size_0 / max(_S517, 0.07000000029802322f * fabrics_0[_S514].fibre_size_0);
    const _S524 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S524;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_6 : bool = false;
    var number_4 : u32 = u32(0);
    for(;;)
    {
        if(((_S520 > 0.0f) & ((number_4 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S525 : u32 = number_4 / u32(9);
        var _S526 : u32 = number_4 / u32(3) - u32(3) * _S525;
        var _S527 : vec2<f32> = (vec2<f32>(((f32(_S525) * 6.0f + 2.0f) * _S518 + _S515.below_1)) * _S521 + _S515.place_1) / vec2<f32>(_S519);
        var _S528 : vec2<f32> = floor(_S527) + vec2<f32>(f32(number_4 - u32(3) * _S526 - u32(9) * _S525), f32(_S526)) - vec2<f32>(1.0f);
        var _S529 : u32 = hash_bits_0(_S522 + _S525, u32(i32(_S528.x)) * u32(65536) + u32(i32(_S528.y)));
        var _S530 : u32 = hash_bits_0(_S522, _S529);
        var _S531 : vec2<f32> = _S527 - _S528 - vec2<f32>(share_of_0(_S529), share_of_0((_S529 >> (u32(10)))));
        var _S532 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S529 >> (u32(20)))));
        var _S533 : f32 = mix(5.0f, 16.0f, share_of_0((_S530 >> (u32(10))))) / 17.0f;
        var _S534 : f32 = _S531.x;
        var _S535 : f32 = _S532.y;
        var _S536 : f32 = _S531.y;
        var _S537 : f32 = _S532.x;
        var _S538 : f32 = (_S534 * _S535 + _S536 * _S537) / _S533;
        var _S539 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S530 >> (u32(20)))) - 1.0f);
        var _S540 : f32 = 0.5f * (2.0f * share_of_0((_S529 ^ (_S530))) - 1.0f);
        var _S541 : f32 = _S538 * (3.0f * _S540 * _S538 + 2.0f * _S539);
        var _S542 : f32 = rsqrt_0(_S541 * _S541 + 1.0f);
        var _S543 : f32 = (_S536 * _S535 - _S534 * _S537 - _S533 * _S538 * _S538 * (_S540 * _S538 + _S539)) * _S542 * 17.0f;
        var _S544 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S538)), 0.0f) * _S523;
        var _S545 : f32 = clamp(_S544 + 0.5f - abs(_S543) * _S523, 0.0f, min(2.0f * _S544, 1.0f));
        var _S546 : bool = ((((_S530 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S547 : bool = (((((share_of_0(_S530)) < (families_0[select(fabrics_0[_S514].weft_0, fabrics_0[_S514].warp_0, _S546)].hairiness_0)) & (((abs(_S538)) < 1.0f)))) & ((_S545 > cover_3)));
        var _S548 : vec2<f32> = vec2<f32>(- _S537 - _S541 * _S535, _S535 - _S541 * _S537) * vec2<f32>(_S542);
        var _S549 : f32 = select(cover_3, _S545, _S547);
        var _S550 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S548.x, _S547), select(hair_across_0.y, _S548.y, _S547));
        var _S551 : f32 = select(hair_away_0, _S543, _S547);
        var _S552 : bool = select(is_warp_6, _S546, _S547);
        var _S553 : u32 = number_4 + u32(1);
        cover_3 = _S549;
        hair_across_0 = _S550;
        hair_away_0 = _S551;
        is_warp_6 = _S552;
        number_4 = _S553;
    }
    var _S554 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S520 * cover_3;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S554) * hair_across_0, sqrt(1.0f - _S554 * _S554));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_3 = is_warp_6;
    hair_1.shade_0 = _S520 * 0.03255363181233406f * (families_0[fabrics_0[_S514].warp_0].hairiness_0 + families_0[fabrics_0[_S514].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S555 : u32,  _S556 : SurfacePoint_0) -> i32
{
    var _S557 : u32 = select(fabrics_0[_S555].weft_0, fabrics_0[_S555].warp_0, _S556.is_warp_5);
    return i32(floor((select(_S556.y_3, _S556.x_10, _S556.is_warp_5) - _S556.across_2) / families_0[_S557].period_0)) * i32(families_0[_S557].count_0) + i32(select(_S556.weft_thread_0, _S556.warp_thread_0, _S556.is_warp_5));
}

fn thread_number_0( _S558 : u32,  _S559 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S558, _S559)) * u32(2) + select(u32(0), u32(1), _S559.is_warp_5);
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

fn fibre_noise_at_0( _S560 : u32,  _S561 : u32,  _S562 : SurfacePoint_0,  _S563 : u32,  _S564 : f32) -> FibreNoise_0
{
    var _S565 : f32 = 5.0f * fabrics_0[_S560].fibre_size_0;
    var _S566 : vec2<f32> = wave_noise_0(hash_key_0(_S563, ((fabrics_0[_S560].seed_0) ^ (u32(458671337)))), _S562.fibre_along_0 / (25.0f * fabrics_0[_S560].fibre_size_0));
    var _S567 : f32 = _S562.fibre_across_0 + families_0[_S561].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S560].fibre_size_0 * _S566.x;
    var _S568 : vec3<f32> = fibre_cell_0(_S567, _S562.fibre_along_0, fabrics_0[_S560].fibre_size_0);
    var _S569 : vec3<f32> = fibre_cell_0(_S567, _S562.fibre_along_0, _S565);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S563, ((fabrics_0[_S560].seed_0) ^ (u32(1757159915)))), _S569);
    noise_0.bundle_offset_0 = _S569.z;
    noise_0.bundle_weight_0 = fade_0(_S564, _S565);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S563, ((fabrics_0[_S560].seed_0) ^ (u32(48610963)))), _S568);
    noise_0.fibre_weight_0 = fade_0(_S564, fabrics_0[_S560].fibre_size_0);
    noise_0.offset_2 = _S568.z;
    noise_0.slope_2 = 0.5f * _S566.y;
    return noise_0;
}

fn turned_frame_0( _S570 : u32,  _S571 : u32,  _S572 : SurfacePoint_0,  _S573 : bool,  _S574 : u32,  _S575 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_6 = _S572.normal_5;
    frame_2.tangent_5 = _S572.tangent_4;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S571].has_plies_0) > 0.0f)
    {
        var _S576 : f32 = fade_0(_S575, 1.0f / families_0[_S571].plies_per_mm_0);
        var _S577 : f32 = _S576 * 0.62000000476837158f * ply_offset_0(_S571, _S572, _S573);
        var _S578 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S579 : vec3<f32> = vec3<f32>(families_0[_S571].ply_cosine_0);
        var _S580 : vec3<f32> = vec3<f32>(select(families_0[_S571].ply_sine_0, - families_0[_S571].ply_sine_0, _S573));
        var _S581 : vec3<f32> = _S579 * _S578 + _S580 * frame_2.tangent_5;
        var _S582 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S577 * _S577));
        var _S583 : vec3<f32> = vec3<f32>(_S577);
        frame_2.tangent_5 = _S579 * (_S579 * frame_2.tangent_5 - _S580 * _S578) + _S580 * (_S582 * _S581 - _S583 * frame_2.normal_6);
        frame_2.normal_6 = _S582 * frame_2.normal_6 + _S583 * _S581;
        frame_2.loss_0 = _S576 * _S576 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S584 : f32 = families_0[_S571].fibre_tilt_0;
    if((families_0[_S571].fibre_tilt_0) > 0.0f)
    {
        var _S585 : FibreNoise_0 = fibre_noise_at_0(_S570, _S571, _S572, _S574, _S575);
        var _S586 : f32 = 1.09858846664428711f * _S584 * (_S585.bundle_weight_0 * _S585.bundle_0.x + _S585.fibre_weight_0 * (_S585.fibre_0.x + _S585.offset_2));
        var _S587 : f32 = _S584 * (1.42099642753601074f * (_S585.bundle_weight_0 * _S585.bundle_0.y + _S585.fibre_weight_0 * _S585.fibre_0.y) - _S585.bundle_weight_0 * _S585.slope_2);
        var _S588 : f32 = square_1(_S585.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S584 * _S584 * ((0.24761904776096344f * (square_1(_S585.bundle_weight_0) + _S588) + _S588 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S589 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S590 : vec2<f32> = sine_cosine_0(_S586);
        var _S591 : vec2<f32> = sine_cosine_0(_S587);
        var _S592 : vec3<f32> = vec3<f32>(_S590.y);
        var _S593 : vec3<f32> = vec3<f32>(_S590.x);
        var _S594 : vec3<f32> = _S592 * _S589 - _S593 * frame_2.normal_6;
        frame_2.normal_6 = _S592 * frame_2.normal_6 + _S593 * _S589;
        frame_2.tangent_5 = vec3<f32>(_S591.y) * frame_2.tangent_5 + vec3<f32>(_S591.x) * _S594;
    }
    return frame_2;
}

fn uncoloured_point_0( _S595 : u32,  _S596 : SurfacePoint_0,  _S597 : vec3<f32>,  _S598 : bool,  _S599 : bool,  _S600 : f32) -> YarnPoint_0
{
    var _S601 : u32 = fabrics_0[_S595].warp_0;
    var _S602 : u32 = fabrics_0[_S595].weft_0;
    var _S603 : u32 = select(fabrics_0[_S595].weft_0, fabrics_0[_S595].warp_0, _S596.is_warp_5);
    var _S604 : bool = (((fabrics_0[_S595].has_detail_0) != u32(0)) & ((_S600 >= 0.0f)));
    var _S605 : vec3<f32> = vec3<f32>(0.0f);
    var point_6 : YarnPoint_0 = YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S605, _S605, _S605, 0.0f, 0.0f, Albedos_x24init_0(_S605, _S605, _S605, _S605), Hairs_x24init_0(vec2<f32>(0.0f), 0.0f, false, 0.0f), 0.0f);
    point_6.hairs_0 = hairs_over_0(_S595, _S596, _S598, _S600);
    point_6.hair_cover_0 = 1.0f;
    var _S606 : Hair_0 = Hair_x24init_0(0.0f, _S605, _S605, false, 0.0f);
    point_6.is_warp_1 = _S596.is_warp_5;
    var _S607 : bool = (_S604 & ((has_hairs_0(_S595))));
    var hair_2 : Hair_0;
    if(_S607)
    {
        var _S608 : Hair_0 = hair_towards_0(_S595, point_6.hairs_0, _S597, _S600);
        point_6.hair_cover_0 = _S608.cover_1;
        point_6.is_warp_1 = select(_S596.is_warp_5, _S608.is_warp_3, (_S608.cover_1) > 0.5f);
        hair_2 = _S608;
    }
    else
    {
        hair_2 = _S606;
    }
    var _S609 : u32 = select(_S602, _S601, point_6.is_warp_1);
    point_6.back_6 = _S598;
    point_6.hole_2 = _S599;
    point_6.x_7 = _S596.x_10;
    point_6.y_1 = _S596.y_3;
    point_6.height_4 = _S596.height_6 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_1 = _S596.normal_5;
    point_6.tangent_0 = _S596.tangent_4;
    point_6.surface_normal_0 = normalize(mix(_S596.normal_5, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_0 = 1.0f;
    if(_S604)
    {
        var _S610 : YarnFrame_0 = turned_frame_0(_S595, _S603, _S596, _S598, thread_number_0(_S595, _S596), _S600);
        var frame_3 : YarnFrame_0;
        if(_S607)
        {
            frame_3 = under_hair_0(_S610, hair_2);
        }
        else
        {
            frame_3 = _S610;
        }
        point_6.normal_1 = frame_3.normal_6;
        point_6.tangent_0 = frame_3.tangent_5;
        point_6.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S595].diffuse_blend_0);
    }
    point_6.roughness_1 = families_0[_S609].roughness_0;
    return point_6;
}

fn toned_0( _S611 : u32,  _S612 : u32,  _S613 : Albedos_0,  _S614 : vec4<f32>) -> Albedos_0
{
    var _S615 : vec3<f32> = _S613.diffuse_reflect_0 + _S613.diffuse_transmit_0;
    var _S616 : vec3<f32> = vec3<f32>(1.0f);
    var _S617 : vec3<f32> = _S616 - vec3<f32>(fabrics_0[_S611].layer_bound_0) * max(_S613.specular_reflect_0, _S613.specular_transmit_0);
    var _S618 : vec3<f32> = vec3<f32>(0.0f);
    var _S619 : vec3<f32> = max(_S616 - _S615, _S618) / (_S616 + _S615);
    var _S620 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S621 : vec3<f32> = (_S617 / max(_S615, _S620) - _S616) / max(vec3<f32>(0.89999997615814209f) * _S619, _S620);
    var _S622 : vec3<f32> = _S616 - vec3<f32>((saturate(min(min(_S621.x, _S621.y), _S621.z)) * _S614.z)) * _S619;
    var _S623 : vec3<f32> = min(vec3<f32>(families_0[_S612].nep_red_0, families_0[_S612].nep_green_0, families_0[_S612].nep_blue_0), _S617);
    var found_1 : Albedos_0 = _S613;
    var _S624 : f32 = _S614.w;
    var _S625 : vec3<f32> = _S622 * _S613.diffuse_transmit_0 * vec3<f32>((1.0f - _S624));
    found_1.diffuse_transmit_0 = _S625;
    found_1.diffuse_reflect_0 = clamp(mix(_S622 * _S613.diffuse_reflect_0, _S623, vec3<f32>(_S624)), _S618, max(_S617 - _S625, _S618));
    return found_1;
}

fn toned_at_0( _S626 : u32,  _S627 : bool,  _S628 : Albedos_0,  _S629 : f32,  _S630 : vec2<f32>) -> Albedos_0
{
    var _S631 : u32 = select(fabrics_0[_S626].weft_0, fabrics_0[_S626].warp_0, _S627);
    return toned_0(_S626, _S631, _S628, irregular_at_0(_S631, irregular_key_0(_S626, select(u32(1), u32(0), _S627)), _S629, select(_S630.x, _S630.y, _S627)));
}

fn varies_at_0( _S632 : u32,  _S633 : f32) -> bool
{
    return (((((fabrics_0[_S632].fibre_noise_0) > 0.0f) | (((fabrics_0[_S632].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S632].has_detail_0) != u32(0)) & ((_S633 >= 0.0f))))));
}

fn detail_gain_0( _S634 : u32,  _S635 : u32,  _S636 : SurfacePoint_0,  _S637 : bool,  _S638 : u32,  _S639 : f32) -> vec2<f32>
{
    var _S640 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S635].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S639, 1.0f / families_0[_S635].plies_per_mm_0), ply_offset_0(_S635, _S636, _S637));
    }
    else
    {
        gain_2 = _S640;
    }
    if((families_0[_S635].fibre_tone_0) > 0.0f)
    {
        var _S641 : FibreNoise_0 = fibre_noise_at_0(_S634, _S635, _S636, _S638, _S639);
        var _S642 : f32 = 4.5f * families_0[_S635].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S635].fibre_tone_0) * vec2<f32>(_S641.bundle_weight_0 * _S641.bundle_0.y + _S641.fibre_weight_0 * _S641.fibre_0.y, _S641.bundle_weight_0 + _S641.fibre_weight_0) + (groove_0(_S642 * (_S641.bundle_weight_0 * (0.5f * (_S641.bundle_0.x - 1.0f) + 1.0f)), _S641.bundle_offset_0) + groove_0(_S642 * _S641.fibre_weight_0, _S641.offset_2));
    }
    if((families_0[_S635].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S635].slub_0 * fade_0(_S639, 1.0f / families_0[_S635].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S638, ((fabrics_0[_S634].seed_0) ^ (u32(1373058189)))), select(- _S636.x_10, _S636.y_3, _S636.is_warp_5) * families_0[_S635].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S643 : u32,  _S644 : Albedos_0,  _S645 : u32,  _S646 : u32,  _S647 : vec2<f32>) -> Albedos_0
{
    var _S648 : vec3<f32> = max(_S644.specular_reflect_0, _S644.specular_transmit_0);
    var _S649 : vec3<f32> = _S644.diffuse_reflect_0 + _S644.diffuse_transmit_0;
    var _S650 : vec3<f32> = vec3<f32>(fabrics_0[_S643].layer_bound_0);
    var _S651 : vec3<f32> = vec3<f32>(1.0f);
    var _S652 : vec3<f32> = _S651 - _S650 * _S648;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S645, fabrics_0[_S643].colour_noise_0, fabrics_0[_S643].seed_0), _S649, _S652);
    var _S653 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S647.y, vec3<f32>(colour_1) * _S649, _S652) * _S647.x)));
    var _S654 : f32 = bounded_gain_0(fibre_gain_0(_S645, _S646, fabrics_0[_S643].fibre_noise_0, fabrics_0[_S643].seed_0), _S648, min((_S651 - _S653 * _S649) / _S650, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S653 * _S644.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S653 * _S644.diffuse_transmit_0;
    var _S655 : vec3<f32> = vec3<f32>(_S654);
    varied_0.specular_reflect_0 = _S655 * _S644.specular_reflect_0;
    varied_0.specular_transmit_0 = _S655 * _S644.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S656 : u32,  _S657 : SurfacePoint_0,  _S658 : Albedos_0,  _S659 : bool,  _S660 : f32,  _S661 : f32) -> Albedos_0
{
    var _S662 : u32 = thread_number_0(_S656, _S657);
    var _S663 : vec3<f32> = fibre_cell_0(_S657.fibre_across_0, _S657.fibre_along_0, fabrics_0[_S656].fibre_size_0);
    var _S664 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S656].has_detail_0) != u32(0)) & ((_S660 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S656, select(fabrics_0[_S656].weft_0, fabrics_0[_S656].warp_0, _S657.is_warp_5), _S657, _S659, _S662, _S660) * vec2<f32>(1.0f - _S661, 1.0f);
    }
    else
    {
        gain_3 = _S664;
    }
    return vary_albedos_0(_S656, _S658, _S662, u32(i32(_S663.x)) * u32(65536) + u32(i32(floor(_S663.y))), gain_3);
}

fn yarn_point_of_0( _S665 : u32,  _S666 : SurfacePoint_0,  _S667 : vec3<f32>,  _S668 : bool,  _S669 : bool,  _S670 : f32) -> YarnPoint_0
{
    var point_7 : YarnPoint_0 = uncoloured_point_0(_S665, _S666, _S667, _S668, _S669, _S670);
    point_7.albedos_0 = albedos_of_0(select(fabrics_0[_S665].weft_0, fabrics_0[_S665].warp_0, point_7.is_warp_1), select(_S666.weft_thread_0, _S666.warp_thread_0, point_7.is_warp_1));
    if((fabrics_0[_S665].is_irregular_0) != u32(0))
    {
        point_7.albedos_0 = toned_at_0(_S665, point_7.is_warp_1, point_7.albedos_0, f32(thread_of_family_0(_S665, _S666)), vec2<f32>(_S666.x_10, _S666.y_3));
    }
    var _S671 : bool = (((((fabrics_0[_S665].has_detail_0) != u32(0)) & ((_S670 >= 0.0f)))) & ((has_hairs_0(_S665))));
    if(varies_at_0(_S665, _S670))
    {
        point_7.albedos_0 = varied_at_0(_S665, _S666, point_7.albedos_0, _S668, _S670, select(0.0f, point_7.hair_cover_0, _S671));
    }
    return point_7;
}

fn locate_yarn_0( _S672 : u32,  _S673 : SearchQuality_0,  _S674 : f32,  _S675 : f32,  _S676 : vec3<f32>,  _S677 : f32) -> YarnPoint_0
{
    var _S678 : bool = (_S676.z) < 0.0f;
    var _S679 : vec3<f32> = to_face_frame_0(_S676, _S678);
    var _S680 : Hit_0 = first_hit_0(_S672, _S673, _S674, _S675, _S679, _S678);
    return yarn_point_of_0(_S672, surface_met_0(_S672, _S680.x_15, _S680.y_8, _S680.height_7, _S679, _S678), _S679, _S678, _S680.hole_5, _S677);
}

fn openness_number_0( _S681 : u32,  _S682 : u32) -> f32
{
    return table_number_0(fabrics_0[_S681].openness_0 + _S682);
}

fn blocked_of_terms_0( _S683 : u32,  _S684 : u32,  _S685 : array<f32, i32(6)>,  _S686 : u32) -> Blocked_0
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
            if(term_0 < _S686)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S683, _S684 + share_3 * _S686 + term_0) * _S685[term_0];
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

fn blocked_at_0( _S687 : u32,  _S688 : bool,  _S689 : bool,  _S690 : f32,  _S691 : f32) -> Blocked_0
{
    var _S692 : f32 = _S691 * openness_number_0(_S687, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S690, _S692, _S690 * _S690, _S690 * _S692, _S692 * _S692 );
    return blocked_of_terms_0(_S687, u32(60) + (select(u32(0), u32(2), _S689) + select(u32(1), u32(0), _S688)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S693 : u32,  _S694 : Albedos_0,  _S695 : u32,  _S696 : vec3<f32>) -> Scattered_0
{
    var _S697 : u32 = u32(159) + u32(2) * _S695;
    var yarn_3 : Scattered_0;
    yarn_3.back_9 = _S696 * _S694.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S693, _S697)) * _S694.specular_reflect_0;
    yarn_3.through_0 = _S696 * _S694.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S693, _S697 + u32(1))) * _S694.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S698 : u32,  _S699 : u32,  _S700 : vec3<f32>,  _S701 : vec3<f32>,  _S702 : vec3<f32>,  _S703 : vec3<f32>,  _S704 : ptr<function, vec3<f32>>,  _S705 : ptr<function, vec3<f32>>)
{
    var _S706 : u32 = u32(146) + u32(4) * _S699;
    var _S707 : f32 = openness_number_0(_S698, _S706 + u32(1));
    var _S708 : f32 = openness_number_0(_S698, _S706 + u32(2));
    var _S709 : vec3<f32> = vec3<f32>(1.0f);
    var _S710 : vec3<f32> = _S709 - _S702 * vec3<f32>(openness_number_0(_S698, _S706));
    var _S711 : vec3<f32> = _S709 - _S703 * vec3<f32>(openness_number_0(_S698, _S706 + u32(3)));
    var _S712 : vec3<f32> = _S709 / (_S710 * _S711 - _S702 * _S703 * vec3<f32>((_S707 * _S708)));
    (*_S704) = (_S700 * _S711 + _S702 * vec3<f32>(_S707) * _S701) * _S712;
    (*_S705) = (_S701 * _S710 + _S703 * vec3<f32>(_S708) * _S700) * _S712;
    return;
}

fn face_sends_0( _S713 : u32,  _S714 : u32,  _S715 : Scattered_0,  _S716 : Scattered_0) -> FaceSends_0
{
    var _S717 : u32 = u32(2) * _S714;
    var _S718 : u32 = u32(142) + _S717;
    var _S719 : f32 = openness_number_0(_S713, _S718);
    var _S720 : f32 = openness_number_0(_S713, _S718 + u32(1));
    var _S721 : vec3<f32> = vec3<f32>((1.0f - _S719)) * _S715.back_9;
    var _S722 : vec3<f32> = vec3<f32>((1.0f - _S720)) * _S716.back_9;
    var sends_1 : FaceSends_0;
    var _S723 : u32 = u32(154) + _S717;
    var _S724 : f32 = openness_number_0(_S713, _S723);
    sends_1.blocks_warp_0 = _S724;
    var _S725 : f32 = openness_number_0(_S713, _S723 + u32(1));
    sends_1.blocks_weft_0 = _S725;
    sends_1.open_0 = _S724 * _S719 + _S725 * _S720;
    var _S726 : vec3<f32> = vec3<f32>(_S719) * _S715.back_9;
    var _S727 : vec3<f32> = vec3<f32>(_S720) * _S716.back_9;
    var _S728 : vec3<f32> = sends_1.sky_warp_0;
    var _S729 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S713, _S714, _S726, _S727, _S721, _S722, &(_S728), &(_S729));
    sends_1.sky_warp_0 = _S728;
    sends_1.sky_weft_0 = _S729;
    var _S730 : vec3<f32> = sends_1.crossing_warp_0;
    var _S731 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S713, _S714, _S715.through_0, _S716.through_0, _S721, _S722, &(_S730), &(_S731));
    sends_1.crossing_warp_0 = _S730;
    sends_1.crossing_weft_0 = _S731;
    return sends_1;
}

fn interior_of_0( _S732 : u32,  _S733 : vec3<f32>,  _S734 : bool) -> Interior_0
{
    var _S735 : Scattered_0 = scattered_by_0(_S732, table_albedos_0(families_0[fabrics_0[_S732].warp_0].colour_mean_0), u32(0), _S733);
    var _S736 : Scattered_0 = scattered_by_0(_S732, table_albedos_0(families_0[fabrics_0[_S732].weft_0].colour_mean_0), u32(1), _S733);
    var _S737 : FaceSends_0 = face_sends_0(_S732, select(u32(0), u32(1), _S734), _S735, _S736);
    var _S738 : FaceSends_0 = face_sends_0(_S732, select(u32(1), u32(0), _S734), _S735, _S736);
    var _S739 : vec3<f32> = vec3<f32>(_S737.blocks_warp_0);
    var _S740 : vec3<f32> = vec3<f32>(_S737.blocks_weft_0);
    var _S741 : vec3<f32> = _S739 * _S737.crossing_warp_0 + _S740 * _S737.crossing_weft_0;
    var _S742 : vec3<f32> = vec3<f32>(_S738.blocks_warp_0);
    var _S743 : vec3<f32> = vec3<f32>(_S738.blocks_weft_0);
    var _S744 : vec3<f32> = _S742 * _S738.crossing_warp_0 + _S743 * _S738.crossing_weft_0;
    var _S745 : f32 = 1.0f - _S737.open_0;
    var _S746 : f32 = 1.0f - _S738.open_0;
    var _S747 : vec3<f32> = vec3<f32>(1.0f);
    var _S748 : vec3<f32> = _S747 / (_S747 - _S741 * _S744 * vec3<f32>((_S745 * _S746)));
    var _S749 : vec3<f32> = _S744 * (vec3<f32>(_S737.open_0) + vec3<f32>(_S745) * (_S739 * _S737.sky_warp_0 + _S740 * _S737.sky_weft_0)) * _S748;
    var _S750 : vec3<f32> = _S741 * (vec3<f32>(_S738.open_0) + vec3<f32>(_S746) * (_S742 * _S738.sky_warp_0 + _S743 * _S738.sky_weft_0)) * _S748;
    var _S751 : FaceRadiance_0 = face_radiance_0(_S737, _S738.open_0, _S749, _S750);
    var _S752 : FaceRadiance_0 = face_radiance_0(_S738, _S737.open_0, _S750, _S749);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S751.warp_2;
    interior_1.weft_3 = _S751.weft_2;
    interior_1.leaked_1 = _S751.leaked_0;
    interior_1.far_1 = _S752.mean_0;
    interior_1.far_leaked_0 = _S752.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S753 : u32,  _S754 : YarnPoint_0,  _S755 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S756 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S756;
    nothing_0.transmitted_0 = _S756;
    if((((fabrics_0[_S753].openness_0) == u32(4294967295)) | ((_S754.hole_2))))
    {
        return nothing_0;
    }
    return bounced_by_0(blocked_at_0(_S753, _S754.is_warp_1, _S754.back_6, _S754.surface_normal_0.z, _S754.height_4), scattered_by_0(_S753, _S754.albedos_0, select(u32(1), u32(0), _S754.is_warp_1), _S755), interior_of_0(_S753, _S755, _S754.back_6));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S757 : u32,  _S758 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S757 * frame_record_0.height_0 + _S758.y) * frame_record_0.width_0 + _S758.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S759 : u32,  _S760 : u32) -> vec3<f32>
{
    var _S761 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S759 * frame_record_0.environment_columns_0 + _S760);
    return vec3<f32>(scene_number_0(_S761), scene_number_0(_S761 + u32(1)), scene_number_0(_S761 + u32(2)));
}

fn sample_environment_0( _S762 : vec2<f32>,  _S763 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S764 : u32 = frame_record_0.environment_rows_0;
    var _S765 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S762.y);
    var _S766 : u32 = frame_record_0.environment_columns_0;
    var _S767 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S765.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S762.x);
    var _S768 : vec3<f32> = environment_texel_0(_S765.index_6, _S767.index_6);
    (*_S763) = _S768 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S768), 9.99999968265522539e-21f)));
    var _S769 : f32 = 3.14159274101257324f / f32(_S764);
    var _S770 : f32 = mix(sine_cosine_0(f32(_S765.index_6) * _S769).y, sine_cosine_0(f32(_S765.index_6 + u32(1)) * _S769).y, _S765.remainder_0);
    var _S771 : f32 = sqrt(max(1.0f - _S770 * _S770, 0.0f));
    var _S772 : vec2<f32> = sine_cosine_0((f32(_S767.index_6) + _S767.remainder_0) * (6.28318548202514648f / f32(_S766)));
    var _S773 : f32 = _S771 * _S772.x;
    var _S774 : f32 = - _S771 * _S772.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S773 + frame_record_0.environment_sine_0 * _S774, _S770, frame_record_0.environment_cosine_0 * _S774 - frame_record_0.environment_sine_0 * _S773);
}

fn light_sample_0( _S775 : u32,  _S776 : vec2<u32>,  _S777 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S778 : u32 = frame_record_0.lights_0;
    if(_S775 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S779 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S776, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S775 - _S778), u32(3)), &(weight_0));
        sample_1.towards_0 = _S779;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S780 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S775);
    sample_1.irradiance_1 = vec3<f32>(_S780.red_0, _S780.green_0, _S780.blue_0);
    sample_1.towards_0 = vec3<f32>(_S780.x_11, _S780.y_4, _S780.z_1);
    if((_S780.is_point_0) != u32(0))
    {
        var _S781 : vec3<f32> = sample_1.towards_0 - _S777;
        var _S782 : f32 = max(square_0(_S781), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S782);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S782);
        sample_1.towards_0 = normalize(_S781);
    }
    return sample_1;
}

fn diffuse_kept_0( _S783 : u32,  _S784 : vec3<f32>,  _S785 : vec3<f32>) -> f32
{
    return (1.0f - fabrics_0[_S783].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S784.z), 0.0f))) * (1.0f - fabrics_0[_S783].grazing_loss_0 * fourth_power_0(max(1.0f - abs(_S785.z), 0.0f)));
}

fn highlight_rise_0( _S786 : u32,  _S787 : vec3<f32>,  _S788 : vec3<f32>) -> f32
{
    var _S789 : f32 = 1.0f - sqrt(clamp(0.5f * dot(_S787, _S788) + 0.5f, 9.99999993922529029e-09f, 1.0f));
    return fabrics_0[_S786].grazing_gain_0 * fourth_power_0(_S789) * _S789;
}

fn towards_grazing_0( _S790 : u32,  _S791 : Albedos_0,  _S792 : vec3<f32>,  _S793 : vec3<f32>) -> Albedos_0
{
    var _S794 : f32 = diffuse_kept_0(_S790, _S792, _S793);
    var result_1 : Albedos_0 = _S791;
    var _S795 : vec3<f32> = vec3<f32>(_S794);
    result_1.diffuse_reflect_0 = result_1.diffuse_reflect_0 * _S795;
    result_1.diffuse_transmit_0 = result_1.diffuse_transmit_0 * _S795;
    result_1.specular_reflect_0 = result_1.specular_reflect_0 + vec3<f32>(highlight_rise_0(_S790, _S792, _S793));
    return result_1;
}

fn hairs_lit_0( _S796 : u32,  _S797 : Hairs_0,  _S798 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S796, _S797, _S798, _S797.size_3 + fabrics_0[_S796].fibre_size_0).cover_1;
}

fn under_hairs_0( _S799 : u32,  _S800 : YarnPoint_0,  _S801 : vec3<f32>) -> f32
{
    if((((_S800.hair_cover_0) >= 1.0f) | (((_S801.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S799, _S800.hairs_0, _S801), 1.0f, _S800.hair_cover_0);
}

fn scattered_0( _S802 : u32,  _S803 : YarnPoint_0,  _S804 : vec3<f32>,  _S805 : vec3<f32>) -> vec3<f32>
{
    var _S806 : vec3<f32> = vec3<f32>(0.0f);
    var _S807 : Albedos_0 = towards_grazing_0(_S802, _S803.albedos_0, _S804, _S805);
    var _S808 : bool = !_S803.hole_2;
    var _S809 : f32 = _S804.z;
    var value_2 : vec3<f32>;
    if((_S808 & ((_S809 > 0.0f))))
    {
        value_2 = (_S807.diffuse_reflect_0 * vec3<f32>(_S803.diffuse_gain_0) * vec3<f32>(diffuse_reflection_0(_S804, _S803.normal_1, fabrics_0[_S802].diffuse_blend_0)) + _S807.specular_reflect_0 * vec3<f32>(reflection_0(_S804, _S805, _S803.normal_1, _S803.tangent_0, _S803.roughness_1, fabrics_0[_S802].optical_depth_0))) * vec3<f32>(under_hairs_0(_S802, _S803, _S804));
    }
    else
    {
        if((_S808 & ((_S809 < 0.0f))))
        {
            value_2 = _S807.diffuse_transmit_0 * vec3<f32>(_S803.diffuse_gain_0) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S804), _S803.normal_1, fabrics_0[_S802].diffuse_blend_0)) + _S807.specular_transmit_0 * vec3<f32>(transmission_1(_S804, _S805, _S803.normal_1, _S803.tangent_0, _S803.roughness_1, fabrics_0[_S802].optical_depth_0));
        }
        else
        {
            value_2 = _S806;
        }
    }
    var _S810 : f32 = fabrics_0[_S802].sheen_strength_0;
    if((fabrics_0[_S802].sheen_strength_0) <= 0.0f)
    {
        return value_2;
    }
    var _S811 : vec2<f32> = sheen_with_transmittance_0(_S804, _S805, _S810, fabrics_0[_S802].sheen_roughness_0);
    return vec3<f32>(_S811.y) * value_2 + vec3<f32>(_S811.x);
}

fn surface_at_0( _S812 : u32,  _S813 : f32,  _S814 : f32,  _S815 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S812, sample_at_0(_S812, _S813, _S814, _S815), _S813, _S814, _S815);
}

fn unoccluded_0( _S816 : u32,  _S817 : SearchQuality_0,  _S818 : f32,  _S819 : f32,  _S820 : f32,  _S821 : vec3<f32>,  _S822 : bool) -> bool
{
    if((_S821.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S816, _S817, vec3<f32>(_S818, _S819, _S820 + fabrics_0[_S816].lift_0), _S821, _S822, max_height_along_0(_S816, _S818, _S819, _S820, _S821, _S822));
}

fn is_lit_0( _S823 : u32,  _S824 : SearchQuality_0,  _S825 : YarnPoint_0,  _S826 : vec3<f32>) -> bool
{
    if(_S825.hole_2)
    {
        return true;
    }
    var _S827 : vec3<f32> = to_face_frame_0(_S826, _S825.back_6);
    var _S828 : f32 = _S827.z;
    var _S829 : bool = _S828 < 0.0f;
    var normal_10 : vec3<f32>;
    var height_12 : f32;
    if(_S829)
    {
        var _S830 : SurfacePoint_0 = surface_at_0(_S823, _S825.x_7, _S825.y_1, !_S825.back_6);
        normal_10 = _S830.normal_5;
        height_12 = _S830.height_6;
    }
    else
    {
        normal_10 = _S825.surface_normal_0;
        height_12 = _S825.height_4;
    }
    var _S831 : vec3<f32> = vec3<f32>(_S827.xy, abs(_S828));
    if((dot(normal_10, _S831)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S823, _S824, _S825.x_7, _S825.y_1, height_12, _S831, (_S825.back_6) != _S829);
}

fn evaluate_with_0( _S832 : u32,  _S833 : SearchQuality_0,  _S834 : YarnPoint_0,  _S835 : Bounced_0,  _S836 : vec3<f32>,  _S837 : vec3<f32>) -> vec3<f32>
{
    var _S838 : vec3<f32> = to_face_frame_0(_S837, _S834.back_6);
    var _S839 : vec3<f32> = scattered_0(_S832, _S834, to_face_frame_0(_S836, _S834.back_6), _S838);
    var _S840 : bool;
    if((max(_S839.x, max(_S839.y, _S839.z))) <= 0.0f)
    {
        _S840 = true;
    }
    else
    {
        _S840 = !is_lit_0(_S832, _S833, _S834, _S836);
    }
    var value_3 : vec3<f32>;
    if(_S840)
    {
        value_3 = vec3<f32>(0.0f);
    }
    else
    {
        value_3 = _S839;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S835, _S836, _S837) * vec3<f32>(diffuse_kept_0(_S832, _S836, _S837));
    var _S841 : f32 = fabrics_0[_S832].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S832].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S841 * sheen_lobe_0(abs(_S838.z), fabrics_0[_S832].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_3 + between_2;
}

fn straight_through_0( _S842 : u32,  _S843 : YarnPoint_0,  _S844 : vec3<f32>) -> f32
{
    if(!_S843.hole_2)
    {
        return 0.0f;
    }
    var _S845 : f32 = fabrics_0[_S842].sheen_strength_0;
    if((fabrics_0[_S842].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S845 * sheen_lobe_0(abs(_S844.z), fabrics_0[_S842].sheen_roughness_0).z;
}

fn light_of_point_0( _S846 : u32,  _S847 : VisiblePoint_0,  _S848 : vec2<u32>,  _S849 : vec3<f32>,  _S850 : vec2<f32>) -> vec4<f32>
{
    var _S851 : SearchQuality_0 = default_quality_0();
    var _S852 : vec3<f32> = to_local_0(_S847, _S847.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S850;
    footprint_0.dx_0 = _S847.draft_dx_0;
    footprint_0.dy_0 = _S847.draft_dy_0;
    var _S853 : YarnPoint_0 = locate_yarn_0(_S846, _S851, _S850.x, _S850.y, _S852, Footprint_spread_side_0(footprint_0));
    var point_8 : YarnPoint_0 = _S853;
    var _S854 : Bounced_0 = bounced_at_0(_S846, _S853, _S849);
    point_8.albedos_0 = tinted_0(point_8.albedos_0, _S849);
    var _S855 : vec3<f32> = vec3<f32>(0.0f);
    var number_5 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S855;
    for(;;)
    {
        if(number_5 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S856 : f32 = visibility_at_0(number_5, _S848);
        if(_S856 <= 0.0f)
        {
            number_5 = number_5 + u32(1);
            continue;
        }
        var _S857 : LightSample_0 = light_sample_0(number_5, _S848, _S847.position_4);
        radiance_1 = radiance_1 + vec3<f32>(_S856) * _S857.irradiance_1 * evaluate_with_0(_S846, _S851, point_8, _S854, to_local_0(_S847, _S857.towards_0), _S852);
        number_5 = number_5 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S846, point_8, _S852));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S858 : u32 = id_0.x;
    var _S859 : bool;
    if(_S858 >= (frame_record_0.width_0))
    {
        _S859 = true;
    }
    else
    {
        _S859 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S859)
    {
        return;
    }
    var _S860 : vec2<u32> = id_0.xy;
    var _S861 : u32 = id_0.y * frame_record_0.width_0 + _S858;
    var _S862 : u32 = layers_0[_S861].face_0;
    if((layers_0[_S861].face_0) == u32(0))
    {
        return;
    }
    var _S863 : u32 = _S862 - u32(1);
    var _S864 : u32 = fabric_of_0(_S863);
    var _S865 : VisiblePoint_0 = visible_point_0(_S864, _S863, _S860);
    var _S866 : vec3<f32> = filtered_albedo_0(_S864, _S865);
    var _S867 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S867;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S868 : vec2<f32> = pixel_sequence_0(_S860, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S864, _S865, _S860, _S866, irregular_place_0(_S864, _S865.draft_0 + vec2<f32>(_S868.x) * _S865.draft_dx_0 + vec2<f32>(_S868.y) * _S865.draft_dy_0, 0.0f));
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S861, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

