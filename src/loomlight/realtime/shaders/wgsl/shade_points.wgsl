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

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_7 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S165 : f32 = light_1.z;
    if(_S165 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S165, 0.0f), max(dot(light_1, normal_7), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S166 : f32 = dot(direction_4, tangent_6);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S166 * _S166 + 1.0f, roughness_3 * roughness_3));
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
    var _S167 : f32 = roughness_4 * roughness_4;
    var _S168 : f32 = squared_along_0 * (1.0f - _S167) + _S167;
    return 0.31830987334251404f * _S167 * roughness_4 / (_S168 * _S168);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32) -> f32
{
    var _S169 : vec3<f32> = light_2 + view_1;
    var _S170 : f32 = dot(_S169, tangent_7);
    return flake_density_0(min(_S170 * _S170 / max(square_0(_S169), 9.999999960041972e-13f), 1.0f), roughness_5);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_6 : f32,  optical_depth_1 : f32) -> f32
{
    var _S171 : f32 = dot(light_3, normal_8);
    var _S172 : f32 = dot(view_2, normal_8);
    if(((_S171 <= 0.0f) | ((_S172 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S173 : f32 = max(_S171, 9.99999997475242708e-07f);
    var _S174 : f32 = max(_S172, 9.99999997475242708e-07f);
    var _S175 : f32 = projected_area_1(light_3, tangent_8, roughness_6) * _S174 + projected_area_1(view_2, tangent_8, roughness_6) * _S173;
    var _S176 : f32 = optical_depth_1 * _S175 / (_S173 * _S174);
    return 0.25f * density_between_0(light_3, view_2, tangent_8, roughness_6) * (_S176 * mean_attenuation_0(_S176)) * _S173 / _S175;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_7 : f32,  optical_depth_2 : f32) -> f32
{
    var _S177 : f32 = - dot(light_4, normal_9);
    var _S178 : f32 = dot(view_3, normal_9);
    if(((_S177 <= 0.0f) | ((_S178 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S179 : f32 = 1.0f / max(_S178, 9.99999997475242708e-07f);
    var _S180 : f32 = projected_area_1(light_4, tangent_9, roughness_7) / max(_S177, 9.99999997475242708e-07f);
    var _S181 : f32 = projected_area_1(view_3, tangent_9, roughness_7) * _S179;
    return density_between_0(light_4, view_3, tangent_9, roughness_7) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S180, _S181)) * mean_attenuation_0(optical_depth_2 * abs(_S180 - _S181)) * _S179;
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
    var _S182 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S183 : f32 = 2.0f * sqrt(_S182) - 1.0f;
    var _S184 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S183, _S184), 0.00999999977648258f, 1.0f), clamp((1.0f - _S182) * sheen_shear_0(_S183, _S184), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S183, _S184), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S185 : f32 = light_5.z;
    if(((_S185 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S186 : vec2<f32> = view_4.xy;
    var _S187 : f32 = dot(_S186, _S186);
    var _S188 : vec2<f32> = select_vector_1(_S187 > 9.99999968265522539e-21f, _S186 * vec2<f32>(rsqrt_0(max(_S187, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S189 : f32 = scale_0 * dot(light_5.xy, _S188) + shear_0 * _S185;
    var _S190 : f32 = scale_0 * (light_5.y * _S188.x - light_5.x * _S188.y);
    var _S191 : f32 = _S189 * _S189 + _S190 * _S190 + _S185 * _S185;
    return 0.31830987334251404f * scale_0 * scale_0 * _S185 / max(_S191 * _S191, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S192 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_9);
    var _S193 : f32 = strength_0 * _S192.z;
    return vec2<f32>(_S193 * transformed_cosine_0(light_6, view_5, _S192.x, _S192.y), 1.0f - _S193);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S194 : f32 = light_7.z;
    return select_vector_0((_S194 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S194) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S195 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S195 * (1.0f - light_8.w);
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

fn uneven_shift_0( _S196 : u32,  _S197 : u32,  _S198 : u32,  _S199 : vec2<f32>) -> f32
{
    var _S200 : f32 = families_0[_S198].period_0 / families_0[_S198].count_0;
    var _S201 : u32 = hash_key_0(_S197, ((fabrics_0[_S196].seed_0) ^ (u32(625341585))));
    var _S202 : vec2<f32> = vec2<f32>(_S199.x, _S199.y / 4.0f) / vec2<f32>(_S200);
    return 0.20000000298023224f * sqrt(families_0[_S198].slub_0) * _S200 * (uneven_octave_0(_S201, _S202) * 0.66666668653488159f + uneven_octave_0(_S201 + u32(1), vec2<f32>(2.0f) * _S202 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S203 : u32,  _S204 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S203].has_detail_0) == u32(0), _S204, _S204 + vec2<f32>(uneven_shift_0(_S203, u32(0), fabrics_0[_S203].warp_0, _S204), uneven_shift_0(_S203, u32(1), fabrics_0[_S203].weft_0, _S204.yx)));
}

fn face_point_0( _S205 : u32,  _S206 : u32,  _S207 : f32,  _S208 : f32) -> VisiblePoint_0
{
    var _S209 : u32 = u32(3) * _S206;
    var _S210 : Vertex_0 = vertex_at_0(_S209);
    var _S211 : Vertex_0 = vertex_at_0(_S209 + u32(1));
    var _S212 : Vertex_0 = vertex_at_0(_S209 + u32(2));
    var _S213 : vec3<f32> = position_of_0(_S210);
    var _S214 : vec3<f32> = position_of_0(_S211) - _S213;
    var _S215 : vec3<f32> = position_of_0(_S212) - _S213;
    var _S216 : f32 = _S211.u_0 - _S210.u_0;
    var _S217 : f32 = _S211.v_0 - _S210.v_0;
    var _S218 : vec2<f32> = vec2<f32>(_S216, _S217);
    var _S219 : f32 = _S212.u_0 - _S210.u_0;
    var _S220 : f32 = _S212.v_0 - _S210.v_0;
    var _S221 : vec2<f32> = vec2<f32>(_S219, _S220);
    var _S222 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S216 * _S220 - _S217 * _S219) < 0.0f));
    var _S223 : vec3<f32> = _S222 * (vec3<f32>(_S220) * _S214 - vec3<f32>(_S217) * _S215);
    var _S224 : vec3<f32> = _S222 * (vec3<f32>(_S216) * _S215 - vec3<f32>(_S219) * _S214);
    var point_2 : VisiblePoint_0;
    var _S225 : vec3<f32> = vec3<f32>(_S207);
    var _S226 : vec3<f32> = vec3<f32>(_S208);
    var _S227 : vec3<f32> = normalize(vec3<f32>((1.0f - _S207 - _S208)) * normal_of_0(_S210) + _S225 * normal_of_0(_S211) + _S226 * normal_of_0(_S212));
    point_2.normal_0 = _S227;
    var _S228 : vec3<f32> = normalize(_S223 - _S227 * vec3<f32>(dot(_S227, _S223)));
    point_2.axis_x_0 = _S228;
    point_2.axis_y_0 = cross(_S227, _S228);
    var _S229 : vec3<f32> = normalize(cross(_S214, _S215));
    point_2.face_normal_0 = select_vector_0((dot(_S229, _S227)) < 0.0f, (vec3<f32>(0) - _S229), _S229);
    point_2.position_4 = _S213 + _S225 * _S214 + _S226 * _S215;
    point_2.view_0 = _S227;
    var _S230 : vec2<f32> = vec2<f32>(_S210.u_0, _S210.v_0) + vec2<f32>(_S207) * _S218 + vec2<f32>(_S208) * _S221;
    point_2.uv_1 = _S230;
    var _S231 : bool = (dot(cross(_S223, _S224), _S227)) < 0.0f;
    var _S232 : vec2<f32> = vec2<f32>(fabrics_0[_S205].uv_width_0, select(fabrics_0[_S205].uv_height_0, - fabrics_0[_S205].uv_height_0, _S231));
    point_2.draft_per_uv_0 = _S232;
    point_2.draft_0 = uneven_place_0(_S205, _S230 * _S232 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S205].uv_height_0, _S231)));
    var _S233 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S233;
    point_2.draft_dy_0 = _S233;
    return point_2;
}

fn visible_point_0( _S234 : u32,  _S235 : u32,  _S236 : vec2<u32>) -> VisiblePoint_0
{
    var _S237 : u32 = u32(3) * _S235;
    var _S238 : Vertex_0 = vertex_at_0(_S237);
    var _S239 : Vertex_0 = vertex_at_0(_S237 + u32(1));
    var _S240 : Vertex_0 = vertex_at_0(_S237 + u32(2));
    var _S241 : vec3<f32> = position_of_0(_S238);
    var _S242 : vec3<f32> = position_of_0(_S239) - _S241;
    var _S243 : vec3<f32> = position_of_0(_S240) - _S241;
    var _S244 : vec3<f32> = cross(_S242, _S243);
    var _S245 : f32 = f32(frame_record_0.width_0);
    var _S246 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S245));
    var _S247 : f32 = f32(frame_record_0.height_0);
    var _S248 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S247));
    var _S249 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S236.x) + 0.5f - 0.5f * _S245)) * _S246 + vec3<f32>((f32(_S236.y) + 0.5f - 0.5f * _S247)) * _S248;
    var _S250 : f32 = dot(_S249, _S244);
    var _S251 : f32 = 1.0f / select(1.00000000317107685e-30f, _S250, (abs(_S250)) > 1.00000000317107685e-30f);
    var _S252 : vec3<f32> = _S241 - camera_origin_0();
    var _S253 : vec3<f32> = vec3<f32>((dot(_S252, _S244) * _S251));
    var _S254 : vec3<f32> = _S249 * _S253 - _S252;
    var _S255 : vec3<f32> = _S253 * (_S246 - _S249 * vec3<f32>((dot(_S246, _S244) * _S251)));
    var _S256 : vec3<f32> = _S253 * (_S248 - _S249 * vec3<f32>((dot(_S248, _S244) * _S251)));
    var _S257 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S244), 1.00000000317107685e-30f)));
    var _S258 : vec3<f32> = cross(_S243, _S244) * _S257;
    var _S259 : vec3<f32> = cross(_S244, _S242) * _S257;
    var _S260 : vec2<f32> = vec2<f32>(_S239.u_0 - _S238.u_0, _S239.v_0 - _S238.v_0);
    var _S261 : vec2<f32> = vec2<f32>(_S240.u_0 - _S238.u_0, _S240.v_0 - _S238.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S234, _S235, dot(_S254, _S258), dot(_S254, _S259));
    point_3.position_4 = _S241 + _S254;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S249));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S255, _S258)) * _S260 + vec2<f32>(dot(_S255, _S259)) * _S261) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S256, _S258)) * _S260 + vec2<f32>(dot(_S256, _S259)) * _S261) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S262 : u32,  _S263 : VisiblePoint_0) -> vec3<f32>
{
    var _S264 : u32 = fabrics_0[_S262].albedo_map_levels_0;
    if((fabrics_0[_S262].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S265 : vec2<f32> = vec2<f32>(fabrics_0[_S262].uv_width_0, fabrics_0[_S262].uv_height_0);
    var _S266 : vec2<f32> = _S263.draft_dx_0 / _S265;
    var _S267 : vec2<f32> = _S263.draft_dy_0 / _S265;
    var _S268 : u32 = _S264 - u32(1);
    var _S269 : u32 = (u32(1) << (_S268));
    var _S270 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S266.x * _S267.y - _S266.y * _S267.x), 9.99999968265522539e-21f) * (square_1(f32(_S269)) / 3.0f)), 0.0f, f32(_S264) - 1.0f);
    var _S271 : u32 = min(u32(_S270), max(_S264, u32(2)) - u32(2));
    var _S272 : u32 = min(_S271 + u32(1), _S268);
    var _S273 : u32 = (u32(1) << ((u32(2) * _S264)));
    return mix(map_level_0(fabrics_0[_S262].albedo_map_0 + (_S273 - ((_S273 >> ((u32(2) * _S271))))) / u32(3), (_S269 >> (_S271)), _S263.uv_1), map_level_0(fabrics_0[_S262].albedo_map_0 + (_S273 - ((_S273 >> ((u32(2) * _S272))))) / u32(3), (_S269 >> (_S272)), _S263.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S270 - f32(_S271))) - 1.0f) / 3.0f)));
}

fn irregular_key_0( _S274 : u32,  _S275 : u32) -> u32
{
    return hash_key_0(_S275, ((fabrics_0[_S274].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S276 : u32,  _S277 : vec2<f32>,  _S278 : f32) -> vec2<f32>
{
    var _S279 : u32 = fabrics_0[_S276].warp_0;
    var _S280 : u32 = fabrics_0[_S276].weft_0;
    var _S281 : bool = (((fabrics_0[_S276].is_irregular_0) != u32(0)) & (((max(moved_share_0(fabrics_0[_S276].warp_0, _S278), moved_share_0(fabrics_0[_S276].weft_0, _S278))) > 0.0f)));
    var number_2 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S277;
    for(;;)
    {
        if(number_2 < select(u32(0), u32(2), _S281))
        {
        }
        else
        {
            break;
        }
        var _S282 : bool = number_2 == u32(0);
        var _S283 : u32 = select(_S280, _S279, _S282);
        var _S284 : vec2<f32> = select_vector_1(_S282, _S277, _S277.yx);
        var _S285 : u32 = irregular_key_0(_S276, number_2);
        var _S286 : f32 = _S284.x;
        var _S287 : Cell_0 = locate_0(_S283, _S286);
        var _S288 : f32 = irregular_thread_0(_S283, _S286, _S287);
        var _S289 : f32 = select(1.0f, -1.0f, (_S287.across_0) < 0.0f);
        var _S290 : vec2<f32> = vec2<f32>(0.0f);
        var other_2 : vec2<f32> = _S290;
        var own_1 : vec2<f32> = _S290;
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
            var _S291 : vec2<f32> = irregular_at_0(_S283, _S285, _S288 + _S289 * f32(neighbour_0), _S284.y).xy;
            var _S292 : u32 = neighbour_0 + u32(1);
            own_1 = other_2;
            other_2 = _S291;
            neighbour_0 = _S292;
        }
        var _S293 : f32 = _S287.below_0 + _S287.above_0;
        var _S294 : f32 = min(_S287.half_width_1 / _S293, 0.5f);
        var _S295 : f32 = min(_S294 * (2.0f + own_1.y + other_2.y), 1.0f);
        var _S296 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_2.x), vec2<f32>(0.25f)));
        var _S297 : f32 = _S296.x;
        var _S298 : f32 = _S295 * _S297 / (_S297 + _S296.y);
        var _S299 : f32 = abs(_S287.across_0) / _S293;
        var _S300 : f32 = 1.0f - _S295;
        var _S301 : f32 = _S299 - _S298;
        var _S302 : f32 = moved_share_0(_S283, _S278) * _S289 * _S293 * (select(select((_S301 - _S300) / max(_S295 - _S298, 9.99999997475242708e-07f) * _S294 + (1.0f - _S294), _S301 / max(_S300, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S294) + _S294, _S301 < _S300), _S299 * _S294 / _S298, _S301 < 0.0f) - _S299);
        var moved_1 : vec2<f32> = moved_0 + select_vector_1(_S282, vec2<f32>(_S302, 0.0f), vec2<f32>(0.0f, _S302));
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

fn crossing_at_0( _S303 : u32,  _S304 : f32,  _S305 : f32,  _S306 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S303].warp_0, _S304);
    crossing_2.weft_1 = locate_0(fabrics_0[_S303].weft_0, _S305);
    var _S307 : u32 = fabrics_0[_S303].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S303].ends_1 + crossing_2.warp_1.thread_2);
    var _S308 : u32 = words_0[_S307];
    crossing_2.warp_word_0 = _S308;
    crossing_2.weft_word_0 = words_0[_S307 + u32(1)];
    crossing_2.warp_above_0 = (((_S308 & (u32(1)))) == u32(1)) != _S306;
    return crossing_2;
}

fn sample_at_0( _S309 : u32,  _S310 : f32,  _S311 : f32,  _S312 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S313 : Crossing_0 = crossing_at_0(_S309, _S310, _S311, _S312);
    sample_0.crossing_1 = _S313;
    var _S314 : Shown_0 = shown_at_0(_S313, _S312);
    sample_0.shown_3 = _S314;
    var _S315 : u32 = select(fabrics_0[_S309].weft_0, fabrics_0[_S309].warp_0, _S314.is_warp_0);
    var _S316 : u32 = select(fabrics_0[_S309].warp_0, fabrics_0[_S309].weft_0, _S314.is_warp_0);
    var _S317 : Cell_0 = select_cell_0(_S314.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S318 : Cell_0 = select_cell_0(_S314.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S319 : Run_0 = unpack_0(_S315, _S316, _S317.thread_2, _S318, _S314.word_0);
    var _S320 : Section_0 = section_at_0(_S317);
    var _S321 : bool = ((_S314.on_top_0) & (((_S319.distance_0) < (_S320.drop_0 * _S319.bend_1.sine_0))));
    var _S322 : f32 = select(-1.0f, 1.0f, ((_S314.on_top_0) & ((!_S321))));
    var _S323 : f32 = select(_S319.reach_0, _S319.other_reach_0, _S321);
    var _S324 : f32 = select(max(_S323 - _S319.distance_0, 0.0f), _S323 + _S319.distance_0, _S321);
    var _S325 : f32 = _S323 / _S319.bend_1.sine_0 - _S322 * _S320.drop_0;
    var _S326 : f32 = _S324 * _S324;
    var _S327 : f32 = max(_S325 * _S325 - _S326, 9.99999968265522539e-21f);
    var _S328 : f32 = rsqrt_0(_S327);
    var _S329 : f32 = _S326 / (_S327 * _S328 + _S325);
    var _S330 : bool = _S324 > 0.0f;
    var _S331 : f32 = select(-1.0f, 1.0f, _S314.on_top_0) * select(-1.0f, 1.0f, _S319.near_start_0);
    var _S332 : f32 = _S320.slope_0 * select(1.0f, _S325 * _S328, _S330);
    sample_0.slope_across_0 = _S332;
    var _S333 : f32 = select(0.0f, _S331 * _S324 * _S328, _S330);
    sample_0.slope_along_0 = _S333;
    var _S334 : vec3<f32> = dive_0(_S316, _S314, _S319, _S318);
    sample_0.dive_1 = _S334;
    sample_0.height_8 = select(families_0[_S315].height_scale_0 * _S322, 0.0f, _S319.straight_0) * (_S323 * _S319.bend_1.half_tangent_0 - _S329) - families_0[_S315].height_scale_0 * _S320.drop_0 - _S334.x;
    var _S335 : f32 = families_0[_S315].height_scale_0 * _S332;
    var _S336 : f32 = families_0[_S315].height_scale_0 * _S333 - _S334.y;
    sample_0.slope_x_1 = select(_S336, _S335, _S314.is_warp_0);
    sample_0.slope_y_1 = select(_S335, _S336, _S314.is_warp_0);
    sample_0.run_3 = _S319;
    sample_0.section_1 = _S320;
    return sample_0;
}

fn steps_per_length_0( _S337 : u32,  _S338 : SearchQuality_0,  _S339 : vec3<f32>) -> f32
{
    return max(max(abs(_S339.x) * fabrics_0[_S337].threads_per_x_0, abs(_S339.y) * fabrics_0[_S337].threads_per_y_0) * _S338.steps_per_thread_0, abs(_S339.z) * fabrics_0[_S337].per_relief_0 * _S338.steps_per_relief_0);
}

fn cell_maximum_0( _S340 : u32,  _S341 : Crossing_0) -> f32
{
    var _S342 : u32 = select(fabrics_0[_S340].weft_0, fabrics_0[_S340].warp_0, _S341.warp_above_0);
    return f32((select(_S341.weft_word_0, _S341.warp_word_0, _S341.warp_above_0) >> (u32(28)))) * families_0[_S342].height_scale_0 * families_0[_S342].level_0;
}

fn probe_0( _S343 : u32,  _S344 : f32,  _S345 : f32,  _S346 : bool,  _S347 : bool,  _S348 : bool) -> Probe_0
{
    var _S349 : Sample_0 = sample_at_0(_S343, _S344, _S345, _S346);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S349.height_8;
    probe_1.hole_1 = _S349.shown_3.hole_0;
    probe_1.slope_x_0 = _S349.slope_x_1;
    probe_1.slope_y_0 = _S349.slope_y_1;
    probe_1.yarn_1 = select(_S349.crossing_1.weft_1.thread_2 * u32(2), _S349.crossing_1.warp_1.thread_2 * u32(2) + u32(1), _S349.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S343, _S349.crossing_1);
    probe_1.side_x_0 = select(_S349.crossing_1.warp_1.below_0, _S349.crossing_1.warp_1.above_0, _S347);
    probe_1.side_y_0 = select(_S349.crossing_1.weft_1.below_0, _S349.crossing_1.weft_1.above_0, _S348);
    probe_1.edge_x_0 = outline_distance_0(_S349.crossing_1.warp_1, _S349.shown_3, _S349.run_3, !_S349.shown_3.is_warp_0, _S347);
    probe_1.edge_y_0 = outline_distance_0(_S349.crossing_1.weft_1, _S349.shown_3, _S349.run_3, _S349.shown_3.is_warp_0, _S348);
    return probe_1;
}

fn is_free_0( _S350 : u32,  _S351 : SearchQuality_0,  _S352 : vec3<f32>,  _S353 : vec3<f32>,  _S354 : bool,  _S355 : f32) -> bool
{
    var _S356 : f32 = _S353.z;
    if(_S356 <= 0.0f)
    {
        return false;
    }
    var _S357 : f32 = 1.0f / max(_S351.shadow_share_0 * steps_per_length_0(_S350, _S351, _S353), 9.99999971718068537e-10f);
    var _S358 : StepControl_0 = step_control_0(_S353.xy, _S357);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S352.z + _S356 * distance_1) < _S355))))
        {
        }
        else
        {
            break;
        }
        var _S359 : vec3<f32> = _S352 + _S353 * vec3<f32>(distance_1);
        var _S360 : Probe_0 = probe_0(_S350, _S359.x, _S359.y, _S354, _S358.right_0, _S358.up_0);
        var _S361 : f32 = _S359.z;
        var _S362 : f32 = _S361 - _S360.height_2;
        var _S363 : f32 = _S356 - _S360.slope_x_0 * _S353.x - _S360.slope_y_0 * _S353.y;
        if(((!_S360.hole_1) & ((_S362 < 0.0f))))
        {
            return false;
        }
        var _S364 : f32 = way_back_to_dip_0(previous_3, _S362, _S363, last_step_0, _S360);
        if(_S364 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S364;
            distance_1 = distance_1 - _S364;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S365 : bool = _S361 > (_S360.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S358, _S360, _S362, _S363), max(StepControl_to_cell_exit_0(_S358, _S360.side_x_0, _S360.side_y_0), _S357), _S365);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S362, _S363, _S360, _S365);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S366 : u32,  _S367 : SearchQuality_0,  _S368 : f32,  _S369 : f32,  _S370 : vec3<f32>,  _S371 : bool) -> bool
{
    if(!sample_at_0(_S366, _S368, _S369, _S371).shown_3.hole_0)
    {
        return false;
    }
    var _S372 : vec3<f32> = vec3<f32>(_S368, _S369, 0.0f);
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
        var _S373 : bool = is_free_0(_S366, _S367, _S372, select_vector_0(side_2 == u32(0), _S370, vec3<f32>(- _S370.x, - _S370.y, _S370.z)), _S371 != (side_2 == u32(1)), fabrics_0[_S366].height_high_0);
        var _S374 : u32 = side_2 + u32(1);
        passes_0 = _S373;
        side_2 = _S374;
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

fn max_height_along_0( _S375 : u32,  _S376 : f32,  _S377 : f32,  _S378 : f32,  _S379 : vec3<f32>,  _S380 : bool) -> f32
{
    var _S381 : f32 = _S379.x;
    var _S382 : f32 = _S379.y;
    var _S383 : u32 = (words_0[fabrics_0[_S375].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S375].weft_0, _S377).thread_2 / u32(2) * fabrics_0[_S375].max_height_columns_0 + locate_0(fabrics_0[_S375].warp_0, _S376).thread_2 / u32(2)) + (select(u32(0), u32(1), _S381 > 0.0f) + select(u32(0), u32(2), _S382 > 0.0f))] >> (u32(select(i32(0), i32(4), _S380))));
    var _S384 : f32 = max(abs(_S381) * fabrics_0[_S375].threads_per_x_0, abs(_S382) * fabrics_0[_S375].threads_per_y_0) / _S379.z;
    var _S385 : f32 = fabrics_0[_S375].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S375].height_high_0;
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
        if(((max_height_0 - _S378) * _S384) <= (PYRAMID_RADII_0[number_3]))
        {
            max_height_0 = min(max_height_0, f32((((_S383 >> (u32(i32(8) * number_3)))) & (u32(15)))) * 0.06666667014360428f * _S385);
        }
        number_3 = number_3 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S386 : u32,  _S387 : f32,  _S388 : f32,  _S389 : bool,  _S390 : bool,  _S391 : bool) -> vec3<f32>
{
    var _S392 : Crossing_0 = crossing_at_0(_S386, _S387, _S388, _S389);
    return vec3<f32>(cell_maximum_0(_S386, _S392), select(_S392.warp_1.below_0, _S392.warp_1.above_0, _S390), select(_S392.weft_1.below_0, _S392.weft_1.above_0, _S391));
}

fn first_sample_height_0( _S393 : u32,  _S394 : ViewRay_0,  _S395 : StepControl_0,  _S396 : bool) -> f32
{
    var _S397 : f32 = max_height_along_0(_S393, _S394.origin_0.x, _S394.origin_0.y, 0.0f, vec3<f32>(_S394.slope_1, 1.0f), _S396);
    var count_3 : u32 = u32(0);
    var height_10 : f32 = _S397;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S398 : vec2<f32> = ViewRay_at_0(_S394, height_10);
        var _S399 : vec3<f32> = cell_bounds_0(_S393, _S398.x, _S398.y, _S396, _S395.right_0, _S395.up_0);
        var _S400 : f32 = height_10 - _S399.x;
        var _S401 : f32 = StepControl_to_cell_exit_0(_S395, _S399.y, _S399.z);
        var height_11 : f32 = height_10 - clamp(_S400, 0.0f, _S401);
        if(_S400 <= _S401)
        {
            height_10 = height_11;
            break;
        }
        count_3 = count_3 + u32(1);
        height_10 = height_11;
    }
    return height_10;
}

fn search_down_0( _S402 : u32,  _S403 : ViewRay_0,  _S404 : StepControl_0,  _S405 : bool) -> ViewRayEnd_0
{
    var _S406 : f32 = fabrics_0[_S402].height_low_0 - (fabrics_0[_S402].height_high_0 - fabrics_0[_S402].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_9 = first_sample_height_0(_S402, _S403, _S404, _S405);
    end_1.last_step_3 = _S404.epsilon_0;
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
        var _S407 : vec2<f32> = ViewRay_at_0(_S403, end_1.height_9);
        var _S408 : Probe_0 = probe_0(_S402, _S407.x, _S407.y, _S405, _S404.right_0, _S404.up_0);
        var _S409 : f32 = end_1.height_9 - _S408.height_2;
        var _S410 : f32 = ViewRay_rate_0(_S403, _S408);
        end_1.depth_2 = - _S409;
        end_1.rate_4 = _S410;
        var _S411 : bool = !_S408.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S411))) & (((end_1.previous_4.yarn_0) == (_S408.yarn_1))));
        if((((_S411 & ((_S409 <= 0.0f)))) | (((end_1.height_9) <= _S406))))
        {
            break;
        }
        var _S412 : f32 = way_back_to_dip_0(end_1.previous_4, _S409, _S410, end_1.last_step_3, _S408);
        if(_S412 >= 0.0f)
        {
            end_1.height_9 = end_1.height_9 + _S412;
            end_1.last_step_3 = end_1.last_step_3 - _S412;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S413 : f32 = min(StepControl_to_cell_exit_0(_S404, _S408.side_x_0, _S408.side_y_0), end_1.height_9 - _S408.cell_max_0);
        var _S414 : f32 = StepControl_to_next_sample_0(_S404, _S408, _S409, _S410);
        end_1.previous_4 = after_sample_0(_S409, _S410, _S408, _S413 > _S414);
        var _S415 : f32 = max(_S413, _S414);
        end_1.last_step_3 = _S415;
        end_1.height_9 = end_1.height_9 - _S415;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S416 : u32,  _S417 : ViewRay_0,  _S418 : StepControl_0,  _S419 : bool,  _S420 : ViewRayEnd_0,  _S421 : u32) -> f32
{
    var _S422 : f32 = fabrics_0[_S416].height_high_0 - fabrics_0[_S416].height_low_0;
    var above_2 : f32 = _S420.height_9 + _S420.last_step_3;
    var above_gap_1 : f32 = clamp(_S420.previous_4.clearance_0, 0.0f, _S422);
    var under_gap_1 : f32 = clamp(_S420.depth_2, 0.0f, _S422);
    var middle_0 : f32 = select(between_0(above_2, _S420.height_9, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S420.previous_4.rate_0 * _S420.last_step_3, _S420.rate_4 * _S420.last_step_3) * _S420.last_step_3, _S420.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S420.height_9;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S421)
        {
        }
        else
        {
            break;
        }
        var _S423 : vec2<f32> = ViewRay_at_0(_S417, middle_0);
        var _S424 : Probe_0 = probe_0(_S416, _S423.x, _S423.y, _S419, _S418.right_0, _S418.up_0);
        var _S425 : f32 = clamp(middle_0 - select(_S424.height_2, -1.0e+09f, _S424.hole_1), - _S422, _S422);
        if(_S425 <= 0.0f)
        {
            var _S426 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S427 : f32 = - _S425;
            under_1 = middle_0;
            above_gap_2 = _S426;
            under_gap_2 = _S427;
            side_3 = 1.0f;
        }
        else
        {
            var _S428 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S425;
            under_gap_2 = _S428;
            side_3 = -1.0f;
        }
        var _S429 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S425 / min(ViewRay_rate_0(_S417, _S424), -9.99999997475242708e-07f), under_1, above_3), _S420.smooth_0);
        var _S430 : u32 = i_1 + u32(1);
        middle_0 = _S429;
        i_1 = _S430;
    }
    return select(under_1, middle_0, _S420.smooth_0);
}

fn first_hit_of_yarn_0( _S431 : u32,  _S432 : SearchQuality_0,  _S433 : f32,  _S434 : f32,  _S435 : vec3<f32>,  _S436 : bool) -> Hit_0
{
    var _S437 : f32 = max(_S435.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S433, _S434);
    var _S438 : vec2<f32> = _S435.xy / vec2<f32>(_S437);
    ray_0.slope_1 = _S438;
    var _S439 : StepControl_0 = step_control_0((vec2<f32>(0) - _S438), 1.0f / max(steps_per_length_0(_S431, _S432, _S435) / _S437, 9.99999971718068537e-10f));
    var _S440 : ViewRayEnd_0 = search_down_0(_S431, ray_0, _S439, _S436);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S441 : f32 = refined_height_0(_S431, ray_0, _S439, _S436, _S440, _S432.refinements_0);
    hit_0.height_7 = _S441;
    var _S442 : vec2<f32> = ViewRay_at_0(ray_0, _S441);
    hit_0.x_15 = _S442.x;
    hit_0.y_8 = _S442.y;
    return hit_0;
}

fn first_hit_0( _S443 : u32,  _S444 : SearchQuality_0,  _S445 : f32,  _S446 : f32,  _S447 : vec3<f32>,  _S448 : bool) -> Hit_0
{
    if(!passes_through_0(_S443, _S444, _S445, _S446, _S447, _S448))
    {
        return first_hit_of_yarn_0(_S443, _S444, _S445, _S446, _S447, _S448);
    }
    var hit_1 : Hit_0;
    hit_1.x_15 = _S445;
    hit_1.y_8 = _S446;
    hit_1.height_7 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_of_0( _S449 : u32,  _S450 : Sample_0,  _S451 : f32,  _S452 : f32,  _S453 : bool) -> SurfacePoint_0
{
    var _S454 : u32 = select(fabrics_0[_S449].weft_0, fabrics_0[_S449].warp_0, _S450.shown_3.is_warp_0);
    var _S455 : f32 = families_0[_S454].twist_sine_0 * select(1.0f, -1.0f, _S453);
    var _S456 : f32 = select(-1.0f, 1.0f, _S450.shown_3.is_warp_0);
    var _S457 : vec2<f32> = fibre_direction_0(_S450.slope_across_0, _S456 * _S450.slope_along_0, _S455, families_0[_S454].twist_cosine_0);
    var _S458 : f32 = _S457.x;
    var _S459 : f32 = _S457.y;
    var _S460 : f32 = select(_S450.slope_y_1, _S450.slope_x_1, _S450.shown_3.is_warp_0) * _S458 + _S456 * select(_S450.slope_x_1, _S450.slope_y_1, _S450.shown_3.is_warp_0) * _S459;
    var _S461 : f32 = select(_S450.crossing_1.weft_1.half_width_1, _S450.crossing_1.warp_1.half_width_1, _S450.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S462 : f32 = _S461 * arc_sine_0(clamp(_S450.section_1.across_1 / _S461, -1.0f, 1.0f));
    var _S463 : f32 = select(- _S451, _S452, _S450.shown_3.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_4 = _S450.shown_3.hole_0;
    point_4.is_warp_5 = _S450.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S450.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S450.crossing_1.weft_1.thread_2;
    point_4.height_6 = _S450.height_8;
    point_4.normal_5 = normalize(vec3<f32>(- _S450.slope_x_1, - _S450.slope_y_1, 1.0f));
    point_4.tangent_4 = normalize(select_vector_0(_S450.shown_3.is_warp_0, vec3<f32>(_S458, _S459, _S460), vec3<f32>(- _S459, _S458, _S460)));
    point_4.across_2 = _S450.section_1.across_1;
    point_4.fibre_across_0 = _S462 * families_0[_S454].twist_cosine_0 + _S463 * _S455;
    point_4.fibre_along_0 = _S463 * families_0[_S454].twist_cosine_0 - _S462 * _S455;
    var _S464 : f32 = run_share_0(_S450.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S464, _S464, _S450.shown_3.on_top_0);
    point_4.x_10 = _S451;
    point_4.y_3 = _S452;
    return point_4;
}

fn surface_met_0( _S465 : u32,  _S466 : f32,  _S467 : f32,  _S468 : f32,  _S469 : vec3<f32>,  _S470 : bool) -> SurfacePoint_0
{
    var _S471 : Sample_0 = sample_at_0(_S465, _S466, _S467, _S470);
    var point_5 : SurfacePoint_0 = surface_of_0(_S465, _S471, _S466, _S467, _S470);
    var _S472 : u32 = select(fabrics_0[_S465].weft_0, fabrics_0[_S465].warp_0, point_5.is_warp_5);
    var _S473 : f32 = select(_S471.crossing_1.weft_1.half_width_1, _S471.crossing_1.warp_1.half_width_1, point_5.is_warp_5) * 1.0154266357421875f;
    var _S474 : f32 = _S471.dive_1.z;
    var _S475 : f32 = _S471.slope_along_0 - (1.0f - _S474) * _S471.dive_1.y / families_0[_S472].height_scale_0;
    var _S476 : f32 = rsqrt_0(_S475 * _S475 + 1.0f);
    var _S477 : f32 = _S469.x;
    var _S478 : f32 = _S469.y;
    var _S479 : f32 = select(_S478, _S477, point_5.is_warp_5);
    var _S480 : f32 = _S469.z;
    var _S481 : f32 = (_S480 / families_0[_S472].height_scale_0 - _S475 * select(_S477, _S478, point_5.is_warp_5)) * _S476;
    var _S482 : f32 = square_1(_S473);
    var _S483 : f32 = sqrt(max(_S482 - square_1(point_5.across_2), 0.0f)) - (_S471.height_8 + _S474 * _S471.dive_1.x - _S468) / families_0[_S472].height_scale_0 * _S476;
    var _S484 : f32 = square_1(_S479) + square_1(_S481) + 9.999999960041972e-13f;
    var _S485 : f32 = point_5.across_2 * _S479 + _S483 * _S481;
    var _S486 : f32 = square_1(point_5.across_2) + square_1(_S483) - _S482;
    var _S487 : f32 = sqrt(max(square_1(_S485) - _S484 * _S486, 0.0f));
    var _S488 : f32 = clamp(select((_S487 - _S485) / _S484, - _S486 / max(_S485 + _S487, 9.999999960041972e-13f), _S485 > 0.0f), - _S473, _S473);
    var _S489 : f32 = point_5.across_2 + _S488 * _S479;
    point_5.across_2 = _S489;
    var _S490 : vec2<f32> = normalize(vec2<f32>(_S489, _S483 + _S488 * _S481));
    var _S491 : f32 = select(-1.0f, 1.0f, point_5.is_warp_5);
    var _S492 : f32 = families_0[_S472].twist_sine_0 * select(1.0f, -1.0f, _S470);
    var _S493 : f32 = _S490.x;
    var _S494 : f32 = _S492 * _S493 * _S476;
    var _S495 : f32 = _S490.y;
    var _S496 : f32 = - _S492 * _S495;
    var _S497 : f32 = families_0[_S472].twist_cosine_0 * _S476 - _S491 * _S475 * _S494;
    var _S498 : f32 = families_0[_S472].height_scale_0 * (families_0[_S472].twist_cosine_0 * _S491 * _S475 * _S476 + _S494);
    var _S499 : f32 = families_0[_S472].height_scale_0 * _S493;
    var _S500 : f32 = - families_0[_S472].height_scale_0 * _S475 * _S476 * _S495;
    point_5.normal_5 = normalize(vec3<f32>(select(_S500, _S499, point_5.is_warp_5), select(_S499, _S500, point_5.is_warp_5), _S476 * _S495));
    point_5.tangent_4 = normalize(vec3<f32>(select(- _S497, _S496, point_5.is_warp_5), select(_S496, _S497, point_5.is_warp_5), _S498));
    var _S501 : f32 = _S473 * angle_of_0(_S490);
    var _S502 : f32 = select(- _S466 - _S488 * _S477, _S467 + _S488 * _S478, point_5.is_warp_5);
    point_5.fibre_across_0 = _S501 * families_0[_S472].twist_cosine_0 + _S502 * _S492;
    point_5.fibre_along_0 = _S502 * families_0[_S472].twist_cosine_0 - _S501 * _S492;
    var _S503 : f32 = 0.00999999977648258f * _S473;
    var _S504 : f32 = - _S503;
    var _S505 : bool = _S488 < _S504;
    var _S506 : f32 = select(_S503, _S504, _S479 < 0.0f);
    var _S507 : f32 = max(_S488, 0.0f);
    point_5.x_10 = point_5.x_10 + select(_S507 * _S477, select(0.0f, _S506, point_5.is_warp_5), _S505);
    point_5.y_3 = point_5.y_3 + select(_S507 * _S478, select(_S506, 0.0f, point_5.is_warp_5), _S505);
    point_5.height_6 = select(_S468 + _S488 * _S480, _S468, _S505);
    return point_5;
}

fn hairs_over_0( _S508 : u32,  _S509 : SurfacePoint_0,  _S510 : bool,  _S511 : f32) -> Hairs_0
{
    var hairs_2 : Hairs_0;
    hairs_2.place_1 = vec2<f32>(_S509.x_10, _S509.y_3);
    hairs_2.below_1 = fabrics_0[_S508].height_high_0 - _S509.height_6;
    hairs_2.back_4 = _S510;
    hairs_2.size_3 = _S511;
    return hairs_2;
}

fn has_hairs_0( _S512 : u32) -> bool
{
    return (((families_0[fabrics_0[_S512].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S512].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S513 : u32,  _S514 : Hairs_0,  _S515 : vec3<f32>,  _S516 : f32) -> Hair_0
{
    var _S517 : f32 = fabrics_0[_S513].fibre_size_0;
    var _S518 : f32 = 17.0f * fabrics_0[_S513].fibre_size_0;
    var _S519 : f32 = fade_0(_S516, _S518);
    var _S520 : vec2<f32> = _S515.xy / vec2<f32>(max(_S515.z, 0.3333333432674408f));
    var _S521 : u32 = hash_key_0(select(u32(0), u32(1), _S514.back_4), ((fabrics_0[_S513].seed_0) ^ (u32(1013904242))));
    var _S522 : f32 = fabrics_0[_S513].fibre_size_0 / max(_S516, 0.07000000029802322f * fabrics_0[_S513].fibre_size_0);
    const _S523 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S523;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_6 : bool = false;
    var number_4 : u32 = u32(0);
    for(;;)
    {
        if(((_S519 > 0.0f) & ((number_4 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S524 : u32 = number_4 / u32(9);
        var _S525 : u32 = number_4 / u32(3) - u32(3) * _S524;
        var _S526 : vec2<f32> = (vec2<f32>(((f32(_S524) * 6.0f + 2.0f) * _S517 + _S514.below_1)) * _S520 + _S514.place_1) / vec2<f32>(_S518);
        var _S527 : vec2<f32> = floor(_S526) + vec2<f32>(f32(number_4 - u32(3) * _S525 - u32(9) * _S524), f32(_S525)) - vec2<f32>(1.0f);
        var _S528 : u32 = hash_bits_0(_S521 + _S524, u32(i32(_S527.x)) * u32(65536) + u32(i32(_S527.y)));
        var _S529 : u32 = hash_bits_0(_S521, _S528);
        var _S530 : vec2<f32> = _S526 - _S527 - vec2<f32>(share_of_0(_S528), share_of_0((_S528 >> (u32(10)))));
        var _S531 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S528 >> (u32(20)))));
        var _S532 : f32 = mix(5.0f, 16.0f, share_of_0((_S529 >> (u32(10))))) / 17.0f;
        var _S533 : f32 = _S530.x;
        var _S534 : f32 = _S531.y;
        var _S535 : f32 = _S530.y;
        var _S536 : f32 = _S531.x;
        var _S537 : f32 = (_S533 * _S534 + _S535 * _S536) / _S532;
        var _S538 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S529 >> (u32(20)))) - 1.0f);
        var _S539 : f32 = 0.5f * (2.0f * share_of_0((_S528 ^ (_S529))) - 1.0f);
        var _S540 : f32 = _S537 * (3.0f * _S539 * _S537 + 2.0f * _S538);
        var _S541 : f32 = rsqrt_0(_S540 * _S540 + 1.0f);
        var _S542 : f32 = (_S535 * _S534 - _S533 * _S536 - _S532 * _S537 * _S537 * (_S539 * _S537 + _S538)) * _S541 * 17.0f;
        var _S543 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S537)), 0.0f) * _S522;
        var _S544 : f32 = clamp(_S543 + 0.5f - abs(_S542) * _S522, 0.0f, min(2.0f * _S543, 1.0f));
        var _S545 : bool = ((((_S529 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S546 : bool = (((((share_of_0(_S529)) < (families_0[select(fabrics_0[_S513].weft_0, fabrics_0[_S513].warp_0, _S545)].hairiness_0)) & (((abs(_S537)) < 1.0f)))) & ((_S544 > cover_3)));
        var _S547 : vec2<f32> = vec2<f32>(- _S536 - _S540 * _S534, _S534 - _S540 * _S536) * vec2<f32>(_S541);
        var _S548 : f32 = select(cover_3, _S544, _S546);
        var _S549 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S547.x, _S546), select(hair_across_0.y, _S547.y, _S546));
        var _S550 : f32 = select(hair_away_0, _S542, _S546);
        var _S551 : bool = select(is_warp_6, _S545, _S546);
        var _S552 : u32 = number_4 + u32(1);
        cover_3 = _S548;
        hair_across_0 = _S549;
        hair_away_0 = _S550;
        is_warp_6 = _S551;
        number_4 = _S552;
    }
    var _S553 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S519 * cover_3;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S553) * hair_across_0, sqrt(1.0f - _S553 * _S553));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_3 = is_warp_6;
    hair_1.shade_0 = _S519 * 0.03255363181233406f * (families_0[fabrics_0[_S513].warp_0].hairiness_0 + families_0[fabrics_0[_S513].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S554 : u32,  _S555 : SurfacePoint_0) -> i32
{
    var _S556 : u32 = select(fabrics_0[_S554].weft_0, fabrics_0[_S554].warp_0, _S555.is_warp_5);
    return i32(floor((select(_S555.y_3, _S555.x_10, _S555.is_warp_5) - _S555.across_2) / families_0[_S556].period_0)) * i32(families_0[_S556].count_0) + i32(select(_S555.weft_thread_0, _S555.warp_thread_0, _S555.is_warp_5));
}

fn thread_number_0( _S557 : u32,  _S558 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S557, _S558)) * u32(2) + select(u32(0), u32(1), _S558.is_warp_5);
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

fn fibre_noise_at_0( _S559 : u32,  _S560 : u32,  _S561 : SurfacePoint_0,  _S562 : u32,  _S563 : f32) -> FibreNoise_0
{
    var _S564 : f32 = 5.0f * fabrics_0[_S559].fibre_size_0;
    var _S565 : vec2<f32> = wave_noise_0(hash_key_0(_S562, ((fabrics_0[_S559].seed_0) ^ (u32(458671337)))), _S561.fibre_along_0 / (25.0f * fabrics_0[_S559].fibre_size_0));
    var _S566 : f32 = _S561.fibre_across_0 + families_0[_S560].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S559].fibre_size_0 * _S565.x;
    var _S567 : vec3<f32> = fibre_cell_0(_S566, _S561.fibre_along_0, fabrics_0[_S559].fibre_size_0);
    var _S568 : vec3<f32> = fibre_cell_0(_S566, _S561.fibre_along_0, _S564);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S562, ((fabrics_0[_S559].seed_0) ^ (u32(1757159915)))), _S568);
    noise_0.bundle_offset_0 = _S568.z;
    noise_0.bundle_weight_0 = fade_0(_S563, _S564);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S562, ((fabrics_0[_S559].seed_0) ^ (u32(48610963)))), _S567);
    noise_0.fibre_weight_0 = fade_0(_S563, fabrics_0[_S559].fibre_size_0);
    noise_0.offset_2 = _S567.z;
    noise_0.slope_2 = 0.5f * _S565.y;
    return noise_0;
}

fn turned_frame_0( _S569 : u32,  _S570 : u32,  _S571 : SurfacePoint_0,  _S572 : bool,  _S573 : u32,  _S574 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_6 = _S571.normal_5;
    frame_2.tangent_5 = _S571.tangent_4;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S570].has_plies_0) > 0.0f)
    {
        var _S575 : f32 = fade_0(_S574, 1.0f / families_0[_S570].plies_per_mm_0);
        var _S576 : f32 = _S575 * 0.62000000476837158f * ply_offset_0(_S570, _S571, _S572);
        var _S577 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S578 : vec3<f32> = vec3<f32>(families_0[_S570].ply_cosine_0);
        var _S579 : vec3<f32> = vec3<f32>(select(families_0[_S570].ply_sine_0, - families_0[_S570].ply_sine_0, _S572));
        var _S580 : vec3<f32> = _S578 * _S577 + _S579 * frame_2.tangent_5;
        var _S581 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S576 * _S576));
        var _S582 : vec3<f32> = vec3<f32>(_S576);
        frame_2.tangent_5 = _S578 * (_S578 * frame_2.tangent_5 - _S579 * _S577) + _S579 * (_S581 * _S580 - _S582 * frame_2.normal_6);
        frame_2.normal_6 = _S581 * frame_2.normal_6 + _S582 * _S580;
        frame_2.loss_0 = _S575 * _S575 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S583 : f32 = families_0[_S570].fibre_tilt_0;
    if((families_0[_S570].fibre_tilt_0) > 0.0f)
    {
        var _S584 : FibreNoise_0 = fibre_noise_at_0(_S569, _S570, _S571, _S573, _S574);
        var _S585 : f32 = 1.09858846664428711f * _S583 * (_S584.bundle_weight_0 * _S584.bundle_0.x + _S584.fibre_weight_0 * (_S584.fibre_0.x + _S584.offset_2));
        var _S586 : f32 = _S583 * (1.42099642753601074f * (_S584.bundle_weight_0 * _S584.bundle_0.y + _S584.fibre_weight_0 * _S584.fibre_0.y) - _S584.bundle_weight_0 * _S584.slope_2);
        var _S587 : f32 = square_1(_S584.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S583 * _S583 * ((0.24761904776096344f * (square_1(_S584.bundle_weight_0) + _S587) + _S587 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S588 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S589 : vec2<f32> = sine_cosine_0(_S585);
        var _S590 : vec2<f32> = sine_cosine_0(_S586);
        var _S591 : vec3<f32> = vec3<f32>(_S589.y);
        var _S592 : vec3<f32> = vec3<f32>(_S589.x);
        var _S593 : vec3<f32> = _S591 * _S588 - _S592 * frame_2.normal_6;
        frame_2.normal_6 = _S591 * frame_2.normal_6 + _S592 * _S588;
        frame_2.tangent_5 = vec3<f32>(_S590.y) * frame_2.tangent_5 + vec3<f32>(_S590.x) * _S593;
    }
    return frame_2;
}

fn uncoloured_point_0( _S594 : u32,  _S595 : SurfacePoint_0,  _S596 : vec3<f32>,  _S597 : bool,  _S598 : bool,  _S599 : f32) -> YarnPoint_0
{
    var _S600 : u32 = fabrics_0[_S594].warp_0;
    var _S601 : u32 = fabrics_0[_S594].weft_0;
    var _S602 : u32 = select(fabrics_0[_S594].weft_0, fabrics_0[_S594].warp_0, _S595.is_warp_5);
    var _S603 : bool = (((fabrics_0[_S594].has_detail_0) != u32(0)) & ((_S599 >= 0.0f)));
    var _S604 : vec3<f32> = vec3<f32>(0.0f);
    var point_6 : YarnPoint_0 = YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S604, _S604, _S604, 0.0f, 0.0f, Albedos_x24init_0(_S604, _S604, _S604, _S604), Hairs_x24init_0(vec2<f32>(0.0f), 0.0f, false, 0.0f), 0.0f);
    point_6.hairs_0 = hairs_over_0(_S594, _S595, _S597, _S599);
    point_6.hair_cover_0 = 1.0f;
    var _S605 : Hair_0 = Hair_x24init_0(0.0f, _S604, _S604, false, 0.0f);
    point_6.is_warp_1 = _S595.is_warp_5;
    var _S606 : bool = (_S603 & ((has_hairs_0(_S594))));
    var hair_2 : Hair_0;
    if(_S606)
    {
        var _S607 : Hair_0 = hair_towards_0(_S594, point_6.hairs_0, _S596, _S599);
        point_6.hair_cover_0 = _S607.cover_1;
        point_6.is_warp_1 = select(_S595.is_warp_5, _S607.is_warp_3, (_S607.cover_1) > 0.5f);
        hair_2 = _S607;
    }
    else
    {
        hair_2 = _S605;
    }
    var _S608 : u32 = select(_S601, _S600, point_6.is_warp_1);
    point_6.back_6 = _S597;
    point_6.hole_2 = _S598;
    point_6.x_7 = _S595.x_10;
    point_6.y_1 = _S595.y_3;
    point_6.height_4 = _S595.height_6 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_1 = _S595.normal_5;
    point_6.tangent_0 = _S595.tangent_4;
    point_6.surface_normal_0 = normalize(mix(_S595.normal_5, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_0 = 1.0f;
    if(_S603)
    {
        var _S609 : YarnFrame_0 = turned_frame_0(_S594, _S602, _S595, _S597, thread_number_0(_S594, _S595), _S599);
        var frame_3 : YarnFrame_0;
        if(_S606)
        {
            frame_3 = under_hair_0(_S609, hair_2);
        }
        else
        {
            frame_3 = _S609;
        }
        point_6.normal_1 = frame_3.normal_6;
        point_6.tangent_0 = frame_3.tangent_5;
        point_6.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S594].diffuse_blend_0);
    }
    point_6.roughness_1 = families_0[_S608].roughness_0;
    return point_6;
}

fn toned_0( _S610 : u32,  _S611 : u32,  _S612 : Albedos_0,  _S613 : vec4<f32>) -> Albedos_0
{
    var _S614 : vec3<f32> = _S612.diffuse_reflect_0 + _S612.diffuse_transmit_0;
    var _S615 : vec3<f32> = vec3<f32>(1.0f);
    var _S616 : vec3<f32> = _S615 - vec3<f32>(fabrics_0[_S610].layer_bound_0) * max(_S612.specular_reflect_0, _S612.specular_transmit_0);
    var _S617 : vec3<f32> = vec3<f32>(0.0f);
    var _S618 : vec3<f32> = max(_S615 - _S614, _S617) / (_S615 + _S614);
    var _S619 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S620 : vec3<f32> = (_S616 / max(_S614, _S619) - _S615) / max(vec3<f32>(0.89999997615814209f) * _S618, _S619);
    var _S621 : vec3<f32> = _S615 - vec3<f32>((saturate(min(min(_S620.x, _S620.y), _S620.z)) * _S613.z)) * _S618;
    var _S622 : vec3<f32> = min(vec3<f32>(families_0[_S611].nep_red_0, families_0[_S611].nep_green_0, families_0[_S611].nep_blue_0), _S616);
    var found_1 : Albedos_0 = _S612;
    var _S623 : f32 = _S613.w;
    var _S624 : vec3<f32> = _S621 * _S612.diffuse_transmit_0 * vec3<f32>((1.0f - _S623));
    found_1.diffuse_transmit_0 = _S624;
    found_1.diffuse_reflect_0 = clamp(mix(_S621 * _S612.diffuse_reflect_0, _S622, vec3<f32>(_S623)), _S617, max(_S616 - _S624, _S617));
    return found_1;
}

fn toned_at_0( _S625 : u32,  _S626 : bool,  _S627 : Albedos_0,  _S628 : f32,  _S629 : vec2<f32>) -> Albedos_0
{
    var _S630 : u32 = select(fabrics_0[_S625].weft_0, fabrics_0[_S625].warp_0, _S626);
    return toned_0(_S625, _S630, _S627, irregular_at_0(_S630, irregular_key_0(_S625, select(u32(1), u32(0), _S626)), _S628, select(_S629.x, _S629.y, _S626)));
}

fn varies_at_0( _S631 : u32,  _S632 : f32) -> bool
{
    return (((((fabrics_0[_S631].fibre_noise_0) > 0.0f) | (((fabrics_0[_S631].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S631].has_detail_0) != u32(0)) & ((_S632 >= 0.0f))))));
}

fn detail_gain_0( _S633 : u32,  _S634 : u32,  _S635 : SurfacePoint_0,  _S636 : bool,  _S637 : u32,  _S638 : f32) -> vec2<f32>
{
    var _S639 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S634].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S638, 1.0f / families_0[_S634].plies_per_mm_0), ply_offset_0(_S634, _S635, _S636));
    }
    else
    {
        gain_2 = _S639;
    }
    if((families_0[_S634].fibre_tone_0) > 0.0f)
    {
        var _S640 : FibreNoise_0 = fibre_noise_at_0(_S633, _S634, _S635, _S637, _S638);
        var _S641 : f32 = 4.5f * families_0[_S634].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S634].fibre_tone_0) * vec2<f32>(_S640.bundle_weight_0 * _S640.bundle_0.y + _S640.fibre_weight_0 * _S640.fibre_0.y, _S640.bundle_weight_0 + _S640.fibre_weight_0) + (groove_0(_S641 * (_S640.bundle_weight_0 * (0.5f * (_S640.bundle_0.x - 1.0f) + 1.0f)), _S640.bundle_offset_0) + groove_0(_S641 * _S640.fibre_weight_0, _S640.offset_2));
    }
    if((families_0[_S634].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S634].slub_0 * fade_0(_S638, 1.0f / families_0[_S634].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S637, ((fabrics_0[_S633].seed_0) ^ (u32(1373058189)))), select(- _S635.x_10, _S635.y_3, _S635.is_warp_5) * families_0[_S634].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S642 : u32,  _S643 : Albedos_0,  _S644 : u32,  _S645 : u32,  _S646 : vec2<f32>) -> Albedos_0
{
    var _S647 : vec3<f32> = max(_S643.specular_reflect_0, _S643.specular_transmit_0);
    var _S648 : vec3<f32> = _S643.diffuse_reflect_0 + _S643.diffuse_transmit_0;
    var _S649 : vec3<f32> = vec3<f32>(fabrics_0[_S642].layer_bound_0);
    var _S650 : vec3<f32> = vec3<f32>(1.0f);
    var _S651 : vec3<f32> = _S650 - _S649 * _S647;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S644, fabrics_0[_S642].colour_noise_0, fabrics_0[_S642].seed_0), _S648, _S651);
    var _S652 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S646.y, vec3<f32>(colour_1) * _S648, _S651) * _S646.x)));
    var _S653 : f32 = bounded_gain_0(fibre_gain_0(_S644, _S645, fabrics_0[_S642].fibre_noise_0, fabrics_0[_S642].seed_0), _S647, min((_S650 - _S652 * _S648) / _S649, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S652 * _S643.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S652 * _S643.diffuse_transmit_0;
    var _S654 : vec3<f32> = vec3<f32>(_S653);
    varied_0.specular_reflect_0 = _S654 * _S643.specular_reflect_0;
    varied_0.specular_transmit_0 = _S654 * _S643.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S655 : u32,  _S656 : SurfacePoint_0,  _S657 : Albedos_0,  _S658 : bool,  _S659 : f32,  _S660 : f32) -> Albedos_0
{
    var _S661 : u32 = thread_number_0(_S655, _S656);
    var _S662 : vec3<f32> = fibre_cell_0(_S656.fibre_across_0, _S656.fibre_along_0, fabrics_0[_S655].fibre_size_0);
    var _S663 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S655].has_detail_0) != u32(0)) & ((_S659 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S655, select(fabrics_0[_S655].weft_0, fabrics_0[_S655].warp_0, _S656.is_warp_5), _S656, _S658, _S661, _S659) * vec2<f32>(1.0f - _S660, 1.0f);
    }
    else
    {
        gain_3 = _S663;
    }
    return vary_albedos_0(_S655, _S657, _S661, u32(i32(_S662.x)) * u32(65536) + u32(i32(floor(_S662.y))), gain_3);
}

fn yarn_point_of_0( _S664 : u32,  _S665 : SurfacePoint_0,  _S666 : vec3<f32>,  _S667 : bool,  _S668 : bool,  _S669 : f32) -> YarnPoint_0
{
    var point_7 : YarnPoint_0 = uncoloured_point_0(_S664, _S665, _S666, _S667, _S668, _S669);
    point_7.albedos_0 = albedos_of_0(select(fabrics_0[_S664].weft_0, fabrics_0[_S664].warp_0, point_7.is_warp_1), select(_S665.weft_thread_0, _S665.warp_thread_0, point_7.is_warp_1));
    if((fabrics_0[_S664].is_irregular_0) != u32(0))
    {
        point_7.albedos_0 = toned_at_0(_S664, point_7.is_warp_1, point_7.albedos_0, f32(thread_of_family_0(_S664, _S665)), vec2<f32>(_S665.x_10, _S665.y_3));
    }
    var _S670 : bool = (((((fabrics_0[_S664].has_detail_0) != u32(0)) & ((_S669 >= 0.0f)))) & ((has_hairs_0(_S664))));
    if(varies_at_0(_S664, _S669))
    {
        point_7.albedos_0 = varied_at_0(_S664, _S665, point_7.albedos_0, _S667, _S669, select(0.0f, point_7.hair_cover_0, _S670));
    }
    return point_7;
}

fn locate_yarn_0( _S671 : u32,  _S672 : SearchQuality_0,  _S673 : f32,  _S674 : f32,  _S675 : vec3<f32>,  _S676 : f32) -> YarnPoint_0
{
    var _S677 : bool = (_S675.z) < 0.0f;
    var _S678 : vec3<f32> = to_face_frame_0(_S675, _S677);
    var _S679 : Hit_0 = first_hit_0(_S671, _S672, _S673, _S674, _S678, _S677);
    return yarn_point_of_0(_S671, surface_met_0(_S671, _S679.x_15, _S679.y_8, _S679.height_7, _S678, _S677), _S678, _S677, _S679.hole_5, _S676);
}

fn openness_number_0( _S680 : u32,  _S681 : u32) -> f32
{
    return table_number_0(fabrics_0[_S680].openness_0 + _S681);
}

fn blocked_of_terms_0( _S682 : u32,  _S683 : u32,  _S684 : array<f32, i32(6)>,  _S685 : u32) -> Blocked_0
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
            if(term_0 < _S685)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S682, _S683 + share_3 * _S685 + term_0) * _S684[term_0];
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

fn blocked_at_0( _S686 : u32,  _S687 : bool,  _S688 : bool,  _S689 : f32,  _S690 : f32) -> Blocked_0
{
    var _S691 : f32 = _S690 * openness_number_0(_S686, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S689, _S691, _S689 * _S689, _S689 * _S691, _S691 * _S691 );
    return blocked_of_terms_0(_S686, u32(60) + (select(u32(0), u32(2), _S688) + select(u32(1), u32(0), _S687)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S692 : u32,  _S693 : Albedos_0,  _S694 : u32,  _S695 : vec3<f32>) -> Scattered_0
{
    var _S696 : u32 = u32(159) + u32(2) * _S694;
    var yarn_3 : Scattered_0;
    yarn_3.back_9 = _S695 * _S693.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S692, _S696)) * _S693.specular_reflect_0;
    yarn_3.through_0 = _S695 * _S693.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S692, _S696 + u32(1))) * _S693.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S697 : u32,  _S698 : u32,  _S699 : vec3<f32>,  _S700 : vec3<f32>,  _S701 : vec3<f32>,  _S702 : vec3<f32>,  _S703 : ptr<function, vec3<f32>>,  _S704 : ptr<function, vec3<f32>>)
{
    var _S705 : u32 = u32(146) + u32(4) * _S698;
    var _S706 : f32 = openness_number_0(_S697, _S705 + u32(1));
    var _S707 : f32 = openness_number_0(_S697, _S705 + u32(2));
    var _S708 : vec3<f32> = vec3<f32>(1.0f);
    var _S709 : vec3<f32> = _S708 - _S701 * vec3<f32>(openness_number_0(_S697, _S705));
    var _S710 : vec3<f32> = _S708 - _S702 * vec3<f32>(openness_number_0(_S697, _S705 + u32(3)));
    var _S711 : vec3<f32> = _S708 / (_S709 * _S710 - _S701 * _S702 * vec3<f32>((_S706 * _S707)));
    (*_S703) = (_S699 * _S710 + _S701 * vec3<f32>(_S706) * _S700) * _S711;
    (*_S704) = (_S700 * _S709 + _S702 * vec3<f32>(_S707) * _S699) * _S711;
    return;
}

fn face_sends_0( _S712 : u32,  _S713 : u32,  _S714 : Scattered_0,  _S715 : Scattered_0) -> FaceSends_0
{
    var _S716 : u32 = u32(2) * _S713;
    var _S717 : u32 = u32(142) + _S716;
    var _S718 : f32 = openness_number_0(_S712, _S717);
    var _S719 : f32 = openness_number_0(_S712, _S717 + u32(1));
    var _S720 : vec3<f32> = vec3<f32>((1.0f - _S718)) * _S714.back_9;
    var _S721 : vec3<f32> = vec3<f32>((1.0f - _S719)) * _S715.back_9;
    var sends_1 : FaceSends_0;
    var _S722 : u32 = u32(154) + _S716;
    var _S723 : f32 = openness_number_0(_S712, _S722);
    sends_1.blocks_warp_0 = _S723;
    var _S724 : f32 = openness_number_0(_S712, _S722 + u32(1));
    sends_1.blocks_weft_0 = _S724;
    sends_1.open_0 = _S723 * _S718 + _S724 * _S719;
    var _S725 : vec3<f32> = vec3<f32>(_S718) * _S714.back_9;
    var _S726 : vec3<f32> = vec3<f32>(_S719) * _S715.back_9;
    var _S727 : vec3<f32> = sends_1.sky_warp_0;
    var _S728 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S712, _S713, _S725, _S726, _S720, _S721, &(_S727), &(_S728));
    sends_1.sky_warp_0 = _S727;
    sends_1.sky_weft_0 = _S728;
    var _S729 : vec3<f32> = sends_1.crossing_warp_0;
    var _S730 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S712, _S713, _S714.through_0, _S715.through_0, _S720, _S721, &(_S729), &(_S730));
    sends_1.crossing_warp_0 = _S729;
    sends_1.crossing_weft_0 = _S730;
    return sends_1;
}

fn interior_of_0( _S731 : u32,  _S732 : vec3<f32>,  _S733 : bool) -> Interior_0
{
    var _S734 : Scattered_0 = scattered_by_0(_S731, table_albedos_0(families_0[fabrics_0[_S731].warp_0].colour_mean_0), u32(0), _S732);
    var _S735 : Scattered_0 = scattered_by_0(_S731, table_albedos_0(families_0[fabrics_0[_S731].weft_0].colour_mean_0), u32(1), _S732);
    var _S736 : FaceSends_0 = face_sends_0(_S731, select(u32(0), u32(1), _S733), _S734, _S735);
    var _S737 : FaceSends_0 = face_sends_0(_S731, select(u32(1), u32(0), _S733), _S734, _S735);
    var _S738 : vec3<f32> = vec3<f32>(_S736.blocks_warp_0);
    var _S739 : vec3<f32> = vec3<f32>(_S736.blocks_weft_0);
    var _S740 : vec3<f32> = _S738 * _S736.crossing_warp_0 + _S739 * _S736.crossing_weft_0;
    var _S741 : vec3<f32> = vec3<f32>(_S737.blocks_warp_0);
    var _S742 : vec3<f32> = vec3<f32>(_S737.blocks_weft_0);
    var _S743 : vec3<f32> = _S741 * _S737.crossing_warp_0 + _S742 * _S737.crossing_weft_0;
    var _S744 : f32 = 1.0f - _S736.open_0;
    var _S745 : f32 = 1.0f - _S737.open_0;
    var _S746 : vec3<f32> = vec3<f32>(1.0f);
    var _S747 : vec3<f32> = _S746 / (_S746 - _S740 * _S743 * vec3<f32>((_S744 * _S745)));
    var _S748 : vec3<f32> = _S743 * (vec3<f32>(_S736.open_0) + vec3<f32>(_S744) * (_S738 * _S736.sky_warp_0 + _S739 * _S736.sky_weft_0)) * _S747;
    var _S749 : vec3<f32> = _S740 * (vec3<f32>(_S737.open_0) + vec3<f32>(_S745) * (_S741 * _S737.sky_warp_0 + _S742 * _S737.sky_weft_0)) * _S747;
    var _S750 : FaceRadiance_0 = face_radiance_0(_S736, _S737.open_0, _S748, _S749);
    var _S751 : FaceRadiance_0 = face_radiance_0(_S737, _S736.open_0, _S749, _S748);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S750.warp_2;
    interior_1.weft_3 = _S750.weft_2;
    interior_1.leaked_1 = _S750.leaked_0;
    interior_1.far_1 = _S751.mean_0;
    interior_1.far_leaked_0 = _S751.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S752 : u32,  _S753 : YarnPoint_0,  _S754 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S755 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S755;
    nothing_0.transmitted_0 = _S755;
    if((((fabrics_0[_S752].openness_0) == u32(4294967295)) | ((_S753.hole_2))))
    {
        return nothing_0;
    }
    return bounced_by_0(blocked_at_0(_S752, _S753.is_warp_1, _S753.back_6, _S753.surface_normal_0.z, _S753.height_4), scattered_by_0(_S752, _S753.albedos_0, select(u32(1), u32(0), _S753.is_warp_1), _S754), interior_of_0(_S752, _S754, _S753.back_6));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S756 : u32,  _S757 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S756 * frame_record_0.height_0 + _S757.y) * frame_record_0.width_0 + _S757.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S758 : u32,  _S759 : u32) -> vec3<f32>
{
    var _S760 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S758 * frame_record_0.environment_columns_0 + _S759);
    return vec3<f32>(scene_number_0(_S760), scene_number_0(_S760 + u32(1)), scene_number_0(_S760 + u32(2)));
}

fn sample_environment_0( _S761 : vec2<f32>,  _S762 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S763 : u32 = frame_record_0.environment_rows_0;
    var _S764 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S761.y);
    var _S765 : u32 = frame_record_0.environment_columns_0;
    var _S766 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S764.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S761.x);
    var _S767 : vec3<f32> = environment_texel_0(_S764.index_6, _S766.index_6);
    (*_S762) = _S767 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S767), 9.99999968265522539e-21f)));
    var _S768 : f32 = 3.14159274101257324f / f32(_S763);
    var _S769 : f32 = mix(sine_cosine_0(f32(_S764.index_6) * _S768).y, sine_cosine_0(f32(_S764.index_6 + u32(1)) * _S768).y, _S764.remainder_0);
    var _S770 : f32 = sqrt(max(1.0f - _S769 * _S769, 0.0f));
    var _S771 : vec2<f32> = sine_cosine_0((f32(_S766.index_6) + _S766.remainder_0) * (6.28318548202514648f / f32(_S765)));
    var _S772 : f32 = _S770 * _S771.x;
    var _S773 : f32 = - _S770 * _S771.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S772 + frame_record_0.environment_sine_0 * _S773, _S769, frame_record_0.environment_cosine_0 * _S773 - frame_record_0.environment_sine_0 * _S772);
}

fn light_sample_0( _S774 : u32,  _S775 : vec2<u32>,  _S776 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S777 : u32 = frame_record_0.lights_0;
    if(_S774 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S778 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S775, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S774 - _S777), u32(3)), &(weight_0));
        sample_1.towards_0 = _S778;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S779 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S774);
    sample_1.irradiance_1 = vec3<f32>(_S779.red_0, _S779.green_0, _S779.blue_0);
    sample_1.towards_0 = vec3<f32>(_S779.x_11, _S779.y_4, _S779.z_1);
    if((_S779.is_point_0) != u32(0))
    {
        var _S780 : vec3<f32> = sample_1.towards_0 - _S776;
        var _S781 : f32 = max(square_0(_S780), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S781);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S781);
        sample_1.towards_0 = normalize(_S780);
    }
    return sample_1;
}

fn hairs_lit_0( _S782 : u32,  _S783 : Hairs_0,  _S784 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S782, _S783, _S784, _S783.size_3 + fabrics_0[_S782].fibre_size_0).cover_1;
}

fn under_hairs_0( _S785 : u32,  _S786 : YarnPoint_0,  _S787 : vec3<f32>) -> f32
{
    if((((_S786.hair_cover_0) >= 1.0f) | (((_S787.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S785, _S786.hairs_0, _S787), 1.0f, _S786.hair_cover_0);
}

fn scattered_0( _S788 : u32,  _S789 : YarnPoint_0,  _S790 : vec3<f32>,  _S791 : vec3<f32>) -> vec3<f32>
{
    var _S792 : vec3<f32> = vec3<f32>(0.0f);
    var _S793 : bool = !_S789.hole_2;
    var _S794 : f32 = _S790.z;
    var value_1 : vec3<f32>;
    if((_S793 & ((_S794 > 0.0f))))
    {
        value_1 = (_S789.albedos_0.diffuse_reflect_0 * vec3<f32>(_S789.diffuse_gain_0) * vec3<f32>(diffuse_reflection_0(_S790, _S789.normal_1, fabrics_0[_S788].diffuse_blend_0)) + _S789.albedos_0.specular_reflect_0 * vec3<f32>(reflection_0(_S790, _S791, _S789.normal_1, _S789.tangent_0, _S789.roughness_1, fabrics_0[_S788].optical_depth_0))) * vec3<f32>(under_hairs_0(_S788, _S789, _S790));
    }
    else
    {
        if((_S793 & ((_S794 < 0.0f))))
        {
            value_1 = _S789.albedos_0.diffuse_transmit_0 * vec3<f32>(_S789.diffuse_gain_0) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S790), _S789.normal_1, fabrics_0[_S788].diffuse_blend_0)) + _S789.albedos_0.specular_transmit_0 * vec3<f32>(transmission_1(_S790, _S791, _S789.normal_1, _S789.tangent_0, _S789.roughness_1, fabrics_0[_S788].optical_depth_0));
        }
        else
        {
            value_1 = _S792;
        }
    }
    var _S795 : f32 = fabrics_0[_S788].sheen_strength_0;
    if((fabrics_0[_S788].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S796 : vec2<f32> = sheen_with_transmittance_0(_S790, _S791, _S795, fabrics_0[_S788].sheen_roughness_0);
    return vec3<f32>(_S796.y) * value_1 + vec3<f32>(_S796.x);
}

fn surface_at_0( _S797 : u32,  _S798 : f32,  _S799 : f32,  _S800 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S797, sample_at_0(_S797, _S798, _S799, _S800), _S798, _S799, _S800);
}

fn unoccluded_0( _S801 : u32,  _S802 : SearchQuality_0,  _S803 : f32,  _S804 : f32,  _S805 : f32,  _S806 : vec3<f32>,  _S807 : bool) -> bool
{
    if((_S806.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S801, _S802, vec3<f32>(_S803, _S804, _S805 + fabrics_0[_S801].lift_0), _S806, _S807, max_height_along_0(_S801, _S803, _S804, _S805, _S806, _S807));
}

fn is_lit_0( _S808 : u32,  _S809 : SearchQuality_0,  _S810 : YarnPoint_0,  _S811 : vec3<f32>) -> bool
{
    if(_S810.hole_2)
    {
        return true;
    }
    var _S812 : vec3<f32> = to_face_frame_0(_S811, _S810.back_6);
    var _S813 : f32 = _S812.z;
    var _S814 : bool = _S813 < 0.0f;
    var normal_10 : vec3<f32>;
    var height_12 : f32;
    if(_S814)
    {
        var _S815 : SurfacePoint_0 = surface_at_0(_S808, _S810.x_7, _S810.y_1, !_S810.back_6);
        normal_10 = _S815.normal_5;
        height_12 = _S815.height_6;
    }
    else
    {
        normal_10 = _S810.surface_normal_0;
        height_12 = _S810.height_4;
    }
    var _S816 : vec3<f32> = vec3<f32>(_S812.xy, abs(_S813));
    if((dot(normal_10, _S816)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S808, _S809, _S810.x_7, _S810.y_1, height_12, _S816, (_S810.back_6) != _S814);
}

fn evaluate_with_0( _S817 : u32,  _S818 : SearchQuality_0,  _S819 : YarnPoint_0,  _S820 : Bounced_0,  _S821 : vec3<f32>,  _S822 : vec3<f32>) -> vec3<f32>
{
    var _S823 : vec3<f32> = to_face_frame_0(_S822, _S819.back_6);
    var _S824 : vec3<f32> = scattered_0(_S817, _S819, to_face_frame_0(_S821, _S819.back_6), _S823);
    var _S825 : bool;
    if((max(_S824.x, max(_S824.y, _S824.z))) <= 0.0f)
    {
        _S825 = true;
    }
    else
    {
        _S825 = !is_lit_0(_S817, _S818, _S819, _S821);
    }
    var value_2 : vec3<f32>;
    if(_S825)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S824;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S820, _S821, _S822);
    var _S826 : f32 = fabrics_0[_S817].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S817].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S826 * sheen_lobe_0(abs(_S823.z), fabrics_0[_S817].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S827 : u32,  _S828 : YarnPoint_0,  _S829 : vec3<f32>) -> f32
{
    if(!_S828.hole_2)
    {
        return 0.0f;
    }
    var _S830 : f32 = fabrics_0[_S827].sheen_strength_0;
    if((fabrics_0[_S827].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S830 * sheen_lobe_0(abs(_S829.z), fabrics_0[_S827].sheen_roughness_0).z;
}

fn light_of_point_0( _S831 : u32,  _S832 : VisiblePoint_0,  _S833 : vec2<u32>,  _S834 : vec3<f32>,  _S835 : vec2<f32>) -> vec4<f32>
{
    var _S836 : SearchQuality_0 = default_quality_0();
    var _S837 : vec3<f32> = to_local_0(_S832, _S832.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S835;
    footprint_0.dx_0 = _S832.draft_dx_0;
    footprint_0.dy_0 = _S832.draft_dy_0;
    var _S838 : YarnPoint_0 = locate_yarn_0(_S831, _S836, _S835.x, _S835.y, _S837, Footprint_spread_side_0(footprint_0));
    var point_8 : YarnPoint_0 = _S838;
    var _S839 : Bounced_0 = bounced_at_0(_S831, _S838, _S834);
    point_8.albedos_0 = tinted_0(point_8.albedos_0, _S834);
    var _S840 : vec3<f32> = vec3<f32>(0.0f);
    var number_5 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S840;
    for(;;)
    {
        if(number_5 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S841 : f32 = visibility_at_0(number_5, _S833);
        if(_S841 <= 0.0f)
        {
            number_5 = number_5 + u32(1);
            continue;
        }
        var _S842 : LightSample_0 = light_sample_0(number_5, _S833, _S832.position_4);
        radiance_1 = radiance_1 + vec3<f32>(_S841) * _S842.irradiance_1 * evaluate_with_0(_S831, _S836, point_8, _S839, to_local_0(_S832, _S842.towards_0), _S837);
        number_5 = number_5 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S831, point_8, _S837));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S843 : u32 = id_0.x;
    var _S844 : bool;
    if(_S843 >= (frame_record_0.width_0))
    {
        _S844 = true;
    }
    else
    {
        _S844 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S844)
    {
        return;
    }
    var _S845 : vec2<u32> = id_0.xy;
    var _S846 : u32 = id_0.y * frame_record_0.width_0 + _S843;
    var _S847 : u32 = layers_0[_S846].face_0;
    if((layers_0[_S846].face_0) == u32(0))
    {
        return;
    }
    var _S848 : u32 = _S847 - u32(1);
    var _S849 : u32 = fabric_of_0(_S848);
    var _S850 : VisiblePoint_0 = visible_point_0(_S849, _S848, _S845);
    var _S851 : vec3<f32> = filtered_albedo_0(_S849, _S850);
    var _S852 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S852;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S853 : vec2<f32> = pixel_sequence_0(_S845, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S849, _S850, _S845, _S851, irregular_place_0(_S849, _S850.draft_0 + vec2<f32>(_S853.x) * _S850.draft_dx_0 + vec2<f32>(_S853.y) * _S850.draft_dy_0, 0.0f));
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S846, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

