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

struct Hair_0
{
     cover_1 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     is_warp_1 : bool,
     shade_0 : f32,
};

fn Hair_x24init_0( cover_2 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  is_warp_2 : bool,  shade_1 : f32) -> Hair_0
{
    var _S124 : Hair_0;
    _S124.cover_1 = cover_2;
    _S124.normal_1 = normal_2;
    _S124.tangent_0 = tangent_1;
    _S124.is_warp_1 = is_warp_2;
    _S124.shade_0 = shade_1;
    return _S124;
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S125 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S126 : f32 = x_7 - _S125 * 1.5703125f - _S125 * 0.00048375129699707f - _S125 * 7.54979012640433211e-08f;
    var _S127 : f32 = _S126 * _S126;
    var _S128 : f32 = ((-0.00019515295571182f * _S127 + 0.00833216123282909f) * _S127 - 0.16666655242443085f) * _S127 * _S126 + _S126;
    var _S129 : f32 = ((0.00002443315679557f * _S127 - 0.00138873164542019f) * _S127 + 0.04166664555668831f) * _S127 * _S127 - 0.5f * _S127 + 1.0f;
    var _S130 : u32 = (u32(i32(_S125)) & (u32(3)));
    var _S131 : vec2<f32> = select_vector_1(((_S130 & (u32(1)))) != u32(0), vec2<f32>(_S129, _S128), vec2<f32>(_S128, _S129));
    var _S132 : f32 = _S131.x;
    var _S133 : f32 = _S131.y;
    return vec2<f32>(select(_S132, - _S132, ((_S130 & (u32(2)))) != u32(0)), select(_S133, - _S133, (((_S130 + u32(1)) & (u32(2)))) != u32(0)));
}

fn table_colour_0( index_4 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_4), table_number_0(index_4 + u32(1)), table_number_0(index_4 + u32(2)));
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn table_albedos_0( row_1 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_1);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_1 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_1 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_1 + u32(9));
    return albedos_0;
}

fn albedos_of_0( family_13 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_13].albedo_table_0 + families_0[family_13].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_2 : f32,  along_1 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S134 : f32 = floor(across_2 / width_2);
    return vec3<f32>(_S134, along_1 / (width_2 * 40.0f) + 0.61799997091293335f * _S134, 2.0f * (across_2 / width_2 - _S134) - 1.0f);
}

struct SurfacePoint_0
{
     hole_2 : bool,
     is_warp_3 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_4 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     across_3 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_8 : f32,
     y_1 : f32,
     shown_share_0 : f32,
};

fn ply_offset_0( family_14 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S135 : f32 = (point_1.fibre_across_0 * families_0[family_14].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_14].ply_sine_0, - families_0[family_14].ply_sine_0, back_4)) * families_0[family_14].plies_per_mm_0;
    return 2.0f * (_S135 - floor(_S135)) - 1.0f;
}

fn groove_0( depth_0 : f32,  offset_1 : f32) -> vec2<f32>
{
    return vec2<f32>(depth_0) * vec2<f32>(0.1111111119389534f - square_1(square_1(square_1(offset_1))), 0.1111111119389534f);
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
    var _S136 : f32 = floor(position_5);
    var _S137 : f32 = position_5 - _S136;
    var _S138 : u32 = u32(i32(_S136));
    var _S139 : f32 = signed_noise_0(hash_bits_0(key_4, _S138));
    var _S140 : f32 = signed_noise_0(hash_bits_0(key_4, _S138 + u32(1)));
    return vec2<f32>(mix(_S139, _S140, smooth_share_0(_S137)), 6.0f * _S137 * (1.0f - _S137) * (_S140 - _S139));
}

fn cell_noise_0( key_5 : u32,  cell_9 : vec3<f32>) -> vec2<f32>
{
    var _S141 : f32 = cell_9.y;
    var _S142 : f32 = floor(_S141);
    var _S143 : u32 = u32(i32(cell_9.x)) * u32(65536) + u32(i32(_S142));
    var _S144 : u32 = hash_bits_0(key_5, _S143);
    var _S145 : u32 = hash_bits_0(key_5, _S143 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S144), signed_noise_0((_S144 >> (u32(16))))), vec2<f32>(signed_noise_0(_S145), signed_noise_0((_S145 >> (u32(16))))), vec2<f32>(smooth_share_0(_S141 - _S142)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S146 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S146.x, _S146.y), _S146.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S147 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S147.x, _S147.y), _S147.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_10 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_10, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_4 : vec3<f32>,
     tangent_3 : vec3<f32>,
     loss_0 : f32,
     shade_2 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S148 : vec3<f32> = select_vector_0((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_0), hair_0.tangent_0);
    var blended_0 : YarnFrame_0;
    var _S149 : vec3<f32> = vec3<f32>(hair_0.cover_1);
    var _S150 : vec3<f32> = normalize(mix(frame_0.normal_4, hair_0.normal_1, _S149));
    blended_0.normal_4 = _S150;
    var _S151 : vec3<f32> = mix(frame_0.tangent_3, _S148, _S149);
    var _S152 : vec3<f32> = _S151 - vec3<f32>(dot(_S151, _S150)) * _S150;
    blended_0.tangent_3 = _S152 * vec3<f32>(rsqrt_0(max(dot(_S152, _S152), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_1);
    blended_0.shade_2 = hair_0.shade_0;
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f + frame_1.shade_2, 1.0f / (0.5f * blend_0 * (frame_1.normal_4.z - 1.0f) + 1.0f));
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
    var _S153 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S154 : vec3<f32> = sends_0.sky_warp_0 + _S153 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S154;
    var _S155 : vec3<f32> = sends_0.sky_weft_0 + _S153 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S155;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S154 + vec3<f32>(sends_0.blocks_weft_0) * _S155;
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
     back_5 : vec3<f32>,
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
    var _S156 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S157 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S157 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S157 * interior_0.far_1 + yarn_2.back_5 * _S156;
    return bounced_0;
}

fn tinted_0( albedos_1 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_1;
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
        var _S158 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S158)) <= number_1)
        {
            low_0 = _S158;
        }
        else
        {
            high_0 = _S158;
        }
    }
    var _S159 : u32 = table_0 + low_0;
    var _S160 : f32 = scene_number_0(_S159);
    var _S161 : f32 = scene_number_0(_S159 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_1 - _S160) / max(_S161 - _S160, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

struct Light_0
{
     is_point_0 : u32,
     x_9 : f32,
     y_2 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_4 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_4];
    record_1.x_9 = (bitcast<f32>((scene_words_0[first_4 + u32(1)])));
    record_1.y_2 = (bitcast<f32>((scene_words_0[first_4 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_4 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_4 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_4 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_4 + u32(6)])));
    return record_1;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_5 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S162 : f32 = light_1.z;
    if(_S162 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S162, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S163 : f32 = dot(direction_4, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S163 * _S163 + 1.0f, roughness_1 * roughness_1));
}

fn mean_attenuation_0( depth_1 : f32) -> f32
{
    if(depth_1 < 0.10000000149011612f)
    {
        return (((depth_1 / 120.0f - 0.0416666679084301f) * depth_1 + 0.1666666716337204f) * depth_1 - 0.5f) * depth_1 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_1)) / depth_1;
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S164 : f32 = roughness_2 * roughness_2;
    var _S165 : f32 = squared_along_0 * (1.0f - _S164) + _S164;
    return 0.31830987334251404f * _S164 * roughness_2 / (_S165 * _S165);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S166 : vec3<f32> = light_2 + view_1;
    var _S167 : f32 = dot(_S166, tangent_5);
    return flake_density_0(min(_S167 * _S167 / max(square_0(_S166), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S168 : f32 = dot(light_3, normal_6);
    var _S169 : f32 = dot(view_2, normal_6);
    if(((_S168 <= 0.0f) | ((_S169 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S170 : f32 = max(_S168, 9.99999997475242708e-07f);
    var _S171 : f32 = max(_S169, 9.99999997475242708e-07f);
    var _S172 : f32 = projected_area_1(light_3, tangent_6, roughness_4) * _S171 + projected_area_1(view_2, tangent_6, roughness_4) * _S170;
    var _S173 : f32 = optical_depth_1 * _S172 / (_S170 * _S171);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S173 * mean_attenuation_0(_S173)) * _S170 / _S172;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S174 : f32 = - dot(light_4, normal_7);
    var _S175 : f32 = dot(view_3, normal_7);
    if(((_S174 <= 0.0f) | ((_S175 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S176 : f32 = 1.0f / max(_S175, 9.99999997475242708e-07f);
    var _S177 : f32 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S174, 9.99999997475242708e-07f);
    var _S178 : f32 = projected_area_1(view_3, tangent_7, roughness_5) * _S176;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S177, _S178)) * mean_attenuation_0(optical_depth_2 * abs(_S177 - _S178)) * _S176;
}

fn sheen_scale_0( x_10 : f32,  y_3 : f32) -> f32
{
    return (((((0.0f * x_10 + (((((-1.1402510404586792f * y_3 + 0.40672621130943298f) * y_3 + 1.65398800373077393f) * y_3 + -1.29730904102325439f) * y_3 + 0.30570998787879944f) * y_3 + -0.0220868494361639f)) * x_10 + (((((-0.21142719686031342f * y_3 + 1.05947399139404297f) * y_3 + -0.41116121411323547f) * y_3 + -0.93859231472015381f) * y_3 + 0.51606941223144531f) * y_3 + 0.05409301072359085f)) * x_10 + (((((1.22944498062133789f * y_3 + -0.45962560176849365f) * y_3 + -1.63861405849456787f) * y_3 + 1.33565104007720947f) * y_3 + -0.45725581049919128f) * y_3 + 0.08243165910243988f)) * x_10 + (((((0.39779931306838989f * y_3 + -1.18879103660583496f) * y_3 + 0.28251591324806213f) * y_3 + 1.168984055519104f) * y_3 + -0.76864629983901978f) * y_3 + 0.0091691892594099f)) * x_10 + (((((-0.26563560962677002f * y_3 + -0.19379159808158875f) * y_3 + 0.2677634060382843f) * y_3 + 0.00270519289188087f) * y_3 + 0.14349560439586639f) * y_3 + 0.10290180146694183f)) * x_10 + (((((-0.20701569318771362f * y_3 + 0.24526430666446686f) * y_3 + 0.19551840424537659f) * y_3 + 0.07586126774549484f) * y_3 + 0.38894739747047424f) * y_3 + 0.15043120086193085f);
}

fn sheen_shear_0( x_11 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((-0.10608240216970444f * y_4 + 1.99214303493499756f) * y_4 + -1.42255294322967529f) * y_4 + -1.09495604038238525f) * y_4 + 0.59180057048797607f) * y_4 + 0.06902855634689331f)) * x_11 + (((((-0.46220690011978149f * y_4 + -0.29113379120826721f) * y_4 + 1.39025199413299561f) * y_4 + 0.35589990019798279f) * y_4 + -1.17120099067687988f) * y_4 + 0.15940259397029877f)) * x_11 + (((((2.26068711280822754f * y_4 + -3.64728999137878418f) * y_4 + -0.72173482179641724f) * y_4 + 3.07659196853637695f) * y_4 + -0.6827620267868042f) * y_4 + -0.3039557933807373f)) * x_11 + (((((0.81201767921447754f * y_4 + 0.36014080047607422f) * y_4 + -1.72646903991699219f) * y_4 + -0.22630110383033752f) * y_4 + 0.89514690637588501f) * y_4 + -0.10397960245609283f)) * x_11 + (((((-0.37648698687553406f * y_4 + 1.10974001884460449f) * y_4 + 0.17824520170688629f) * y_4 + -1.04968702793121338f) * y_4 + 0.1461234986782074f) * y_4 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_12 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_12 + (((((12.95646953582763672f * y_5 + -21.38032913208007812f) * y_5 + -7.37853097915649414f) * y_5 + 34.55607986450195312f) * y_5 + -23.61347007751464844f) * y_5 + 5.00126314163208008f)) * x_12 + (((((10.91487026214599609f * y_5 + -6.08202791213989258f) * y_5 + -38.2036285400390625f) * y_5 + 53.3440399169921875f) * y_5 + -21.91996002197265625f) * y_5 + 2.01606011390686035f)) * x_12 + (((((-14.52206039428710938f * y_5 + 36.803619384765625f) * y_5 + -22.94047927856445312f) * y_5 + -10.07973003387451172f) * y_5 + 15.77003955841064453f) * y_5 + -4.92722177505493164f)) * x_12 + (((((-7.62505722045898438f * y_5 + 1.27310299873352051f) * y_5 + 31.19523048400878906f) * y_5 + -44.39989852905273438f) * y_5 + 26.44947052001953125f) * y_5 + -8.73507976531982422f)) * x_12 + (((((5.65633487701416016f * y_5 + -17.66820907592773438f) * y_5 + 24.65356063842773438f) * y_5 + -19.38941001892089844f) * y_5 + 11.06159019470214844f) * y_5 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_6 : f32) -> vec3<f32>
{
    var _S179 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S180 : f32 = 2.0f * sqrt(_S179) - 1.0f;
    var _S181 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S180, _S181), 0.00999999977648258f, 1.0f), clamp((1.0f - _S179) * sheen_shear_0(_S180, _S181), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S180, _S181), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S182 : f32 = light_5.z;
    if(((_S182 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S183 : vec2<f32> = view_4.xy;
    var _S184 : f32 = dot(_S183, _S183);
    var _S185 : vec2<f32> = select_vector_1(_S184 > 9.99999968265522539e-21f, _S183 * vec2<f32>(rsqrt_0(max(_S184, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S186 : f32 = scale_0 * dot(light_5.xy, _S185) + shear_0 * _S182;
    var _S187 : f32 = scale_0 * (light_5.y * _S185.x - light_5.x * _S185.y);
    var _S188 : f32 = _S186 * _S186 + _S187 * _S187 + _S182 * _S182;
    return 0.31830987334251404f * scale_0 * scale_0 * _S182 / max(_S188 * _S188, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S189 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S190 : f32 = strength_0 * _S189.z;
    return vec2<f32>(_S190 * transformed_cosine_0(light_6, view_5, _S189.x, _S189.y), 1.0f - _S190);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S191 : f32 = light_7.z;
    return select_vector_0((_S191 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S191) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S192 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S192 * (1.0f - light_8.w);
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

fn uneven_shift_0( _S193 : u32,  _S194 : u32,  _S195 : u32,  _S196 : vec2<f32>) -> f32
{
    var _S197 : f32 = families_0[_S195].period_0 / families_0[_S195].count_0;
    var _S198 : u32 = hash_key_0(_S194, ((fabrics_0[_S193].seed_0) ^ (u32(625341585))));
    var _S199 : vec2<f32> = vec2<f32>(_S196.x, _S196.y / 4.0f) / vec2<f32>(_S197);
    return 0.20000000298023224f * sqrt(families_0[_S195].slub_0) * _S197 * (uneven_octave_0(_S198, _S199) * 0.66666668653488159f + uneven_octave_0(_S198 + u32(1), vec2<f32>(2.0f) * _S199 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S200 : u32,  _S201 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S200].has_detail_0) == u32(0), _S201, _S201 + vec2<f32>(uneven_shift_0(_S200, u32(0), fabrics_0[_S200].warp_0, _S201), uneven_shift_0(_S200, u32(1), fabrics_0[_S200].weft_0, _S201.yx)));
}

fn face_point_0( _S202 : u32,  _S203 : u32,  _S204 : f32,  _S205 : f32) -> VisiblePoint_0
{
    var _S206 : u32 = u32(3) * _S203;
    var _S207 : Vertex_0 = vertex_at_0(_S206);
    var _S208 : Vertex_0 = vertex_at_0(_S206 + u32(1));
    var _S209 : Vertex_0 = vertex_at_0(_S206 + u32(2));
    var _S210 : vec3<f32> = position_of_0(_S207);
    var _S211 : vec3<f32> = position_of_0(_S208) - _S210;
    var _S212 : vec3<f32> = position_of_0(_S209) - _S210;
    var _S213 : f32 = _S208.u_0 - _S207.u_0;
    var _S214 : f32 = _S208.v_0 - _S207.v_0;
    var _S215 : vec2<f32> = vec2<f32>(_S213, _S214);
    var _S216 : f32 = _S209.u_0 - _S207.u_0;
    var _S217 : f32 = _S209.v_0 - _S207.v_0;
    var _S218 : vec2<f32> = vec2<f32>(_S216, _S217);
    var _S219 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S213 * _S217 - _S214 * _S216) < 0.0f));
    var _S220 : vec3<f32> = _S219 * (vec3<f32>(_S217) * _S211 - vec3<f32>(_S214) * _S212);
    var _S221 : vec3<f32> = _S219 * (vec3<f32>(_S213) * _S212 - vec3<f32>(_S216) * _S211);
    var point_2 : VisiblePoint_0;
    var _S222 : vec3<f32> = vec3<f32>(_S204);
    var _S223 : vec3<f32> = vec3<f32>(_S205);
    var _S224 : vec3<f32> = normalize(vec3<f32>((1.0f - _S204 - _S205)) * normal_of_0(_S207) + _S222 * normal_of_0(_S208) + _S223 * normal_of_0(_S209));
    point_2.normal_0 = _S224;
    var _S225 : vec3<f32> = normalize(_S220 - _S224 * vec3<f32>(dot(_S224, _S220)));
    point_2.axis_x_0 = _S225;
    point_2.axis_y_0 = cross(_S224, _S225);
    var _S226 : vec3<f32> = normalize(cross(_S211, _S212));
    point_2.face_normal_0 = select_vector_0((dot(_S226, _S224)) < 0.0f, (vec3<f32>(0) - _S226), _S226);
    point_2.position_4 = _S210 + _S222 * _S211 + _S223 * _S212;
    point_2.view_0 = _S224;
    var _S227 : vec2<f32> = vec2<f32>(_S207.u_0, _S207.v_0) + vec2<f32>(_S204) * _S215 + vec2<f32>(_S205) * _S218;
    point_2.uv_1 = _S227;
    var _S228 : bool = (dot(cross(_S220, _S221), _S224)) < 0.0f;
    var _S229 : vec2<f32> = vec2<f32>(fabrics_0[_S202].uv_width_0, select(fabrics_0[_S202].uv_height_0, - fabrics_0[_S202].uv_height_0, _S228));
    point_2.draft_per_uv_0 = _S229;
    point_2.draft_0 = uneven_place_0(_S202, _S227 * _S229 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S202].uv_height_0, _S228)));
    var _S230 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S230;
    point_2.draft_dy_0 = _S230;
    return point_2;
}

fn visible_point_0( _S231 : u32,  _S232 : u32,  _S233 : vec2<u32>) -> VisiblePoint_0
{
    var _S234 : u32 = u32(3) * _S232;
    var _S235 : Vertex_0 = vertex_at_0(_S234);
    var _S236 : Vertex_0 = vertex_at_0(_S234 + u32(1));
    var _S237 : Vertex_0 = vertex_at_0(_S234 + u32(2));
    var _S238 : vec3<f32> = position_of_0(_S235);
    var _S239 : vec3<f32> = position_of_0(_S236) - _S238;
    var _S240 : vec3<f32> = position_of_0(_S237) - _S238;
    var _S241 : vec3<f32> = cross(_S239, _S240);
    var _S242 : f32 = f32(frame_record_0.width_0);
    var _S243 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S242));
    var _S244 : f32 = f32(frame_record_0.height_0);
    var _S245 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S244));
    var _S246 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S233.x) + 0.5f - 0.5f * _S242)) * _S243 + vec3<f32>((f32(_S233.y) + 0.5f - 0.5f * _S244)) * _S245;
    var _S247 : f32 = dot(_S246, _S241);
    var _S248 : f32 = 1.0f / select(1.00000000317107685e-30f, _S247, (abs(_S247)) > 1.00000000317107685e-30f);
    var _S249 : vec3<f32> = _S238 - camera_origin_0();
    var _S250 : vec3<f32> = vec3<f32>((dot(_S249, _S241) * _S248));
    var _S251 : vec3<f32> = _S246 * _S250 - _S249;
    var _S252 : vec3<f32> = _S250 * (_S243 - _S246 * vec3<f32>((dot(_S243, _S241) * _S248)));
    var _S253 : vec3<f32> = _S250 * (_S245 - _S246 * vec3<f32>((dot(_S245, _S241) * _S248)));
    var _S254 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S241), 1.00000000317107685e-30f)));
    var _S255 : vec3<f32> = cross(_S240, _S241) * _S254;
    var _S256 : vec3<f32> = cross(_S241, _S239) * _S254;
    var _S257 : vec2<f32> = vec2<f32>(_S236.u_0 - _S235.u_0, _S236.v_0 - _S235.v_0);
    var _S258 : vec2<f32> = vec2<f32>(_S237.u_0 - _S235.u_0, _S237.v_0 - _S235.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S231, _S232, dot(_S251, _S255), dot(_S251, _S256));
    point_3.position_4 = _S238 + _S251;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S246));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S252, _S255)) * _S257 + vec2<f32>(dot(_S252, _S256)) * _S258) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S253, _S255)) * _S257 + vec2<f32>(dot(_S253, _S256)) * _S258) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S259 : u32,  _S260 : VisiblePoint_0) -> vec3<f32>
{
    var _S261 : u32 = fabrics_0[_S259].albedo_map_levels_0;
    if((fabrics_0[_S259].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S262 : vec2<f32> = vec2<f32>(fabrics_0[_S259].uv_width_0, fabrics_0[_S259].uv_height_0);
    var _S263 : vec2<f32> = _S260.draft_dx_0 / _S262;
    var _S264 : vec2<f32> = _S260.draft_dy_0 / _S262;
    var _S265 : u32 = _S261 - u32(1);
    var _S266 : u32 = (u32(1) << (_S265));
    var _S267 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S263.x * _S264.y - _S263.y * _S264.x), 9.99999968265522539e-21f) * (square_1(f32(_S266)) / 3.0f)), 0.0f, f32(_S261) - 1.0f);
    var _S268 : u32 = min(u32(_S267), max(_S261, u32(2)) - u32(2));
    var _S269 : u32 = min(_S268 + u32(1), _S265);
    var _S270 : u32 = (u32(1) << ((u32(2) * _S261)));
    return mix(map_level_0(fabrics_0[_S259].albedo_map_0 + (_S270 - ((_S270 >> ((u32(2) * _S268))))) / u32(3), (_S266 >> (_S268)), _S260.uv_1), map_level_0(fabrics_0[_S259].albedo_map_0 + (_S270 - ((_S270 >> ((u32(2) * _S269))))) / u32(3), (_S266 >> (_S269)), _S260.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S267 - f32(_S268))) - 1.0f) / 3.0f)));
}

fn irregular_key_0( _S271 : u32,  _S272 : u32) -> u32
{
    return hash_key_0(_S272, ((fabrics_0[_S271].seed_0) ^ (u32(1821285621))));
}

fn irregular_place_0( _S273 : u32,  _S274 : vec2<f32>,  _S275 : f32) -> vec2<f32>
{
    if((fabrics_0[_S273].is_irregular_0) == u32(0))
    {
        return _S274;
    }
    var number_2 : u32 = u32(0);
    var moved_0 : vec2<f32> = _S274;
    for(;;)
    {
        if(number_2 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S276 : bool = number_2 == u32(0);
        var _S277 : u32 = select(fabrics_0[_S273].weft_0, fabrics_0[_S273].warp_0, _S276);
        var _S278 : vec2<f32> = select_vector_1(_S276, _S274, _S274.yx);
        var _S279 : f32 = moved_share_0(_S277, _S275);
        if(_S279 <= 0.0f)
        {
            number_2 = number_2 + u32(1);
            continue;
        }
        var _S280 : u32 = irregular_key_0(_S273, number_2);
        var _S281 : f32 = _S278.x;
        var _S282 : Cell_0 = locate_0(_S277, _S281);
        var _S283 : f32 = irregular_thread_0(_S277, _S281, _S282);
        var _S284 : f32 = select(1.0f, -1.0f, (_S282.across_0) < 0.0f);
        var _S285 : vec2<f32> = vec2<f32>(0.0f);
        var other_2 : vec2<f32> = _S285;
        var own_1 : vec2<f32> = _S285;
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
            var _S286 : vec2<f32> = irregular_at_0(_S277, _S280, _S283 + _S284 * f32(neighbour_0), _S278.y).xy;
            var _S287 : u32 = neighbour_0 + u32(1);
            own_1 = other_2;
            other_2 = _S286;
            neighbour_0 = _S287;
        }
        var _S288 : f32 = _S282.below_0 + _S282.above_0;
        var _S289 : f32 = min(_S282.half_width_1 / _S288, 0.5f);
        var _S290 : f32 = min(_S289 * (2.0f + own_1.y + other_2.y), 1.0f);
        var _S291 : vec2<f32> = sqrt(max(vec2<f32>(1.0f) + vec2<f32>(own_1.x, other_2.x), vec2<f32>(0.25f)));
        var _S292 : f32 = _S291.x;
        var _S293 : f32 = _S290 * _S292 / (_S292 + _S291.y);
        var _S294 : f32 = abs(_S282.across_0) / _S288;
        var _S295 : f32 = 1.0f - _S290;
        var _S296 : f32 = _S294 - _S293;
        var _S297 : f32 = _S279 * _S284 * _S288 * (select(select((_S296 - _S295) / max(_S290 - _S293, 9.99999997475242708e-07f) * _S289 + (1.0f - _S289), _S296 / max(_S295, 9.99999997475242708e-07f) * (1.0f - 2.0f * _S289) + _S289, _S296 < _S295), _S294 * _S289 / _S293, _S296 < 0.0f) - _S294);
        moved_0 = moved_0 + select_vector_1(_S276, vec2<f32>(_S297, 0.0f), vec2<f32>(0.0f, _S297));
        number_2 = number_2 + u32(1);
    }
    return moved_0;
}

struct Hairs_0
{
     place_1 : vec2<f32>,
     below_1 : f32,
     back_6 : bool,
     size_3 : f32,
};

struct YarnPoint_0
{
     back_7 : bool,
     hole_3 : bool,
     is_warp_4 : bool,
     x_13 : f32,
     y_6 : f32,
     height_5 : f32,
     normal_8 : vec3<f32>,
     tangent_8 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_8 : f32,
     albedos_2 : Albedos_0,
     hairs_0 : Hairs_0,
     hair_cover_0 : f32,
};

struct Hit_0
{
     x_14 : f32,
     y_7 : f32,
     hole_4 : bool,
     height_6 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_7 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     dive_1 : vec3<f32>,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S298 : u32,  _S299 : f32,  _S300 : f32,  _S301 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S298].warp_0, _S299);
    crossing_2.weft_1 = locate_0(fabrics_0[_S298].weft_0, _S300);
    var _S302 : u32 = fabrics_0[_S298].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S298].ends_1 + crossing_2.warp_1.thread_2);
    var _S303 : u32 = words_0[_S302];
    crossing_2.warp_word_0 = _S303;
    crossing_2.weft_word_0 = words_0[_S302 + u32(1)];
    crossing_2.warp_above_0 = (((_S303 & (u32(1)))) == u32(1)) != _S301;
    return crossing_2;
}

fn sample_at_0( _S304 : u32,  _S305 : f32,  _S306 : f32,  _S307 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S308 : Crossing_0 = crossing_at_0(_S304, _S305, _S306, _S307);
    sample_0.crossing_1 = _S308;
    var _S309 : Shown_0 = shown_at_0(_S308, _S307);
    sample_0.shown_3 = _S309;
    var _S310 : u32 = select(fabrics_0[_S304].weft_0, fabrics_0[_S304].warp_0, _S309.is_warp_0);
    var _S311 : u32 = select(fabrics_0[_S304].warp_0, fabrics_0[_S304].weft_0, _S309.is_warp_0);
    var _S312 : Cell_0 = select_cell_0(_S309.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S313 : Cell_0 = select_cell_0(_S309.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S314 : Run_0 = unpack_0(_S310, _S311, _S312.thread_2, _S313, _S309.word_0);
    var _S315 : Section_0 = section_at_0(_S312);
    var _S316 : bool = ((_S309.on_top_0) & (((_S314.distance_0) < (_S315.drop_0 * _S314.bend_1.sine_0))));
    var _S317 : f32 = select(-1.0f, 1.0f, ((_S309.on_top_0) & ((!_S316))));
    var _S318 : f32 = select(_S314.reach_0, _S314.other_reach_0, _S316);
    var _S319 : f32 = select(max(_S318 - _S314.distance_0, 0.0f), _S318 + _S314.distance_0, _S316);
    var _S320 : f32 = _S318 / _S314.bend_1.sine_0 - _S317 * _S315.drop_0;
    var _S321 : f32 = _S319 * _S319;
    var _S322 : f32 = max(_S320 * _S320 - _S321, 9.99999968265522539e-21f);
    var _S323 : f32 = rsqrt_0(_S322);
    var _S324 : f32 = _S321 / (_S322 * _S323 + _S320);
    var _S325 : bool = _S319 > 0.0f;
    var _S326 : f32 = select(-1.0f, 1.0f, _S309.on_top_0) * select(-1.0f, 1.0f, _S314.near_start_0);
    var _S327 : f32 = _S315.slope_0 * select(1.0f, _S320 * _S323, _S325);
    sample_0.slope_across_0 = _S327;
    var _S328 : f32 = select(0.0f, _S326 * _S319 * _S323, _S325);
    sample_0.slope_along_0 = _S328;
    var _S329 : vec3<f32> = dive_0(_S311, _S309, _S314, _S313);
    sample_0.dive_1 = _S329;
    sample_0.height_7 = select(families_0[_S310].height_scale_0 * _S317, 0.0f, _S314.straight_0) * (_S318 * _S314.bend_1.half_tangent_0 - _S324) - families_0[_S310].height_scale_0 * _S315.drop_0 - _S329.x;
    var _S330 : f32 = families_0[_S310].height_scale_0 * _S327;
    var _S331 : f32 = families_0[_S310].height_scale_0 * _S328 - _S329.y;
    sample_0.slope_x_1 = select(_S331, _S330, _S309.is_warp_0);
    sample_0.slope_y_1 = select(_S330, _S331, _S309.is_warp_0);
    sample_0.run_3 = _S314;
    sample_0.section_1 = _S315;
    return sample_0;
}

fn steps_per_length_0( _S332 : u32,  _S333 : SearchQuality_0,  _S334 : vec3<f32>) -> f32
{
    return max(max(abs(_S334.x) * fabrics_0[_S332].threads_per_x_0, abs(_S334.y) * fabrics_0[_S332].threads_per_y_0) * _S333.steps_per_thread_0, abs(_S334.z) * fabrics_0[_S332].per_relief_0 * _S333.steps_per_relief_0);
}

fn cell_maximum_0( _S335 : u32,  _S336 : Crossing_0) -> f32
{
    var _S337 : u32 = select(fabrics_0[_S335].weft_0, fabrics_0[_S335].warp_0, _S336.warp_above_0);
    return f32((select(_S336.weft_word_0, _S336.warp_word_0, _S336.warp_above_0) >> (u32(28)))) * families_0[_S337].height_scale_0 * families_0[_S337].level_0;
}

fn probe_0( _S338 : u32,  _S339 : f32,  _S340 : f32,  _S341 : bool,  _S342 : bool,  _S343 : bool) -> Probe_0
{
    var _S344 : Sample_0 = sample_at_0(_S338, _S339, _S340, _S341);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S344.height_7;
    probe_1.hole_1 = _S344.shown_3.hole_0;
    probe_1.slope_x_0 = _S344.slope_x_1;
    probe_1.slope_y_0 = _S344.slope_y_1;
    probe_1.yarn_1 = select(_S344.crossing_1.weft_1.thread_2 * u32(2), _S344.crossing_1.warp_1.thread_2 * u32(2) + u32(1), _S344.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S338, _S344.crossing_1);
    probe_1.side_x_0 = select(_S344.crossing_1.warp_1.below_0, _S344.crossing_1.warp_1.above_0, _S342);
    probe_1.side_y_0 = select(_S344.crossing_1.weft_1.below_0, _S344.crossing_1.weft_1.above_0, _S343);
    probe_1.edge_x_0 = outline_distance_0(_S344.crossing_1.warp_1, _S344.shown_3, _S344.run_3, !_S344.shown_3.is_warp_0, _S342);
    probe_1.edge_y_0 = outline_distance_0(_S344.crossing_1.weft_1, _S344.shown_3, _S344.run_3, _S344.shown_3.is_warp_0, _S343);
    return probe_1;
}

fn is_free_0( _S345 : u32,  _S346 : SearchQuality_0,  _S347 : vec3<f32>,  _S348 : vec3<f32>,  _S349 : bool,  _S350 : f32) -> bool
{
    var _S351 : f32 = _S348.z;
    if(_S351 <= 0.0f)
    {
        return false;
    }
    var _S352 : f32 = 1.0f / max(_S346.shadow_share_0 * steps_per_length_0(_S345, _S346, _S348), 9.99999971718068537e-10f);
    var _S353 : StepControl_0 = step_control_0(_S348.xy, _S352);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S347.z + _S351 * distance_1) < _S350))))
        {
        }
        else
        {
            break;
        }
        var _S354 : vec3<f32> = _S347 + _S348 * vec3<f32>(distance_1);
        var _S355 : Probe_0 = probe_0(_S345, _S354.x, _S354.y, _S349, _S353.right_0, _S353.up_0);
        var _S356 : f32 = _S354.z;
        var _S357 : f32 = _S356 - _S355.height_2;
        var _S358 : f32 = _S351 - _S355.slope_x_0 * _S348.x - _S355.slope_y_0 * _S348.y;
        if(((!_S355.hole_1) & ((_S357 < 0.0f))))
        {
            return false;
        }
        var _S359 : f32 = way_back_to_dip_0(previous_3, _S357, _S358, last_step_0, _S355);
        if(_S359 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S359;
            distance_1 = distance_1 - _S359;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S360 : bool = _S356 > (_S355.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S353, _S355, _S357, _S358), max(StepControl_to_cell_exit_0(_S353, _S355.side_x_0, _S355.side_y_0), _S352), _S360);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S357, _S358, _S355, _S360);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S361 : u32,  _S362 : SearchQuality_0,  _S363 : f32,  _S364 : f32,  _S365 : vec3<f32>,  _S366 : bool) -> bool
{
    if(!sample_at_0(_S361, _S363, _S364, _S366).shown_3.hole_0)
    {
        return false;
    }
    var _S367 : vec3<f32> = vec3<f32>(_S363, _S364, 0.0f);
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
        var _S368 : bool = is_free_0(_S361, _S362, _S367, select_vector_0(side_2 == u32(0), _S365, vec3<f32>(- _S365.x, - _S365.y, _S365.z)), _S366 != (side_2 == u32(1)), fabrics_0[_S361].height_high_0);
        var _S369 : u32 = side_2 + u32(1);
        passes_0 = _S368;
        side_2 = _S369;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_8 : f32,
     last_step_3 : f32,
     depth_2 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S370 : u32,  _S371 : f32,  _S372 : f32,  _S373 : f32,  _S374 : vec3<f32>,  _S375 : bool) -> f32
{
    var _S376 : f32 = _S374.x;
    var _S377 : f32 = _S374.y;
    var _S378 : u32 = (words_0[fabrics_0[_S370].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S370].weft_0, _S372).thread_2 / u32(2) * fabrics_0[_S370].max_height_columns_0 + locate_0(fabrics_0[_S370].warp_0, _S371).thread_2 / u32(2)) + (select(u32(0), u32(1), _S376 > 0.0f) + select(u32(0), u32(2), _S377 > 0.0f))] >> (u32(select(i32(0), i32(4), _S375))));
    var _S379 : f32 = max(abs(_S376) * fabrics_0[_S370].threads_per_x_0, abs(_S377) * fabrics_0[_S370].threads_per_y_0) / _S374.z;
    var _S380 : f32 = fabrics_0[_S370].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S370].height_high_0;
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
        if(((max_height_0 - _S373) * _S379) <= (PYRAMID_RADII_0[number_3]))
        {
            max_height_0 = min(max_height_0, f32((((_S378 >> (u32(i32(8) * number_3)))) & (u32(15)))) * 0.06666667014360428f * _S380);
        }
        number_3 = number_3 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S381 : u32,  _S382 : f32,  _S383 : f32,  _S384 : bool,  _S385 : bool,  _S386 : bool) -> vec3<f32>
{
    var _S387 : Crossing_0 = crossing_at_0(_S381, _S382, _S383, _S384);
    return vec3<f32>(cell_maximum_0(_S381, _S387), select(_S387.warp_1.below_0, _S387.warp_1.above_0, _S385), select(_S387.weft_1.below_0, _S387.weft_1.above_0, _S386));
}

fn first_sample_height_0( _S388 : u32,  _S389 : ViewRay_0,  _S390 : StepControl_0,  _S391 : bool) -> f32
{
    var _S392 : f32 = max_height_along_0(_S388, _S389.origin_0.x, _S389.origin_0.y, 0.0f, vec3<f32>(_S389.slope_1, 1.0f), _S391);
    var count_3 : u32 = u32(0);
    var height_9 : f32 = _S392;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S393 : vec2<f32> = ViewRay_at_0(_S389, height_9);
        var _S394 : vec3<f32> = cell_bounds_0(_S388, _S393.x, _S393.y, _S391, _S390.right_0, _S390.up_0);
        var _S395 : f32 = height_9 - _S394.x;
        var _S396 : f32 = StepControl_to_cell_exit_0(_S390, _S394.y, _S394.z);
        var height_10 : f32 = height_9 - clamp(_S395, 0.0f, _S396);
        if(_S395 <= _S396)
        {
            height_9 = height_10;
            break;
        }
        count_3 = count_3 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S397 : u32,  _S398 : ViewRay_0,  _S399 : StepControl_0,  _S400 : bool) -> ViewRayEnd_0
{
    var _S401 : f32 = fabrics_0[_S397].height_low_0 - (fabrics_0[_S397].height_high_0 - fabrics_0[_S397].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S397, _S398, _S399, _S400);
    end_1.last_step_3 = _S399.epsilon_0;
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
        var _S402 : vec2<f32> = ViewRay_at_0(_S398, end_1.height_8);
        var _S403 : Probe_0 = probe_0(_S397, _S402.x, _S402.y, _S400, _S399.right_0, _S399.up_0);
        var _S404 : f32 = end_1.height_8 - _S403.height_2;
        var _S405 : f32 = ViewRay_rate_0(_S398, _S403);
        end_1.depth_2 = - _S404;
        end_1.rate_4 = _S405;
        var _S406 : bool = !_S403.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S406))) & (((end_1.previous_4.yarn_0) == (_S403.yarn_1))));
        if((((_S406 & ((_S404 <= 0.0f)))) | (((end_1.height_8) <= _S401))))
        {
            break;
        }
        var _S407 : f32 = way_back_to_dip_0(end_1.previous_4, _S404, _S405, end_1.last_step_3, _S403);
        if(_S407 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S407;
            end_1.last_step_3 = end_1.last_step_3 - _S407;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S408 : f32 = min(StepControl_to_cell_exit_0(_S399, _S403.side_x_0, _S403.side_y_0), end_1.height_8 - _S403.cell_max_0);
        var _S409 : f32 = StepControl_to_next_sample_0(_S399, _S403, _S404, _S405);
        end_1.previous_4 = after_sample_0(_S404, _S405, _S403, _S408 > _S409);
        var _S410 : f32 = max(_S408, _S409);
        end_1.last_step_3 = _S410;
        end_1.height_8 = end_1.height_8 - _S410;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S411 : u32,  _S412 : ViewRay_0,  _S413 : StepControl_0,  _S414 : bool,  _S415 : ViewRayEnd_0,  _S416 : u32) -> f32
{
    var _S417 : f32 = fabrics_0[_S411].height_high_0 - fabrics_0[_S411].height_low_0;
    var above_2 : f32 = _S415.height_8 + _S415.last_step_3;
    var above_gap_1 : f32 = clamp(_S415.previous_4.clearance_0, 0.0f, _S417);
    var under_gap_1 : f32 = clamp(_S415.depth_2, 0.0f, _S417);
    var middle_0 : f32 = select(between_0(above_2, _S415.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S415.previous_4.rate_0 * _S415.last_step_3, _S415.rate_4 * _S415.last_step_3) * _S415.last_step_3, _S415.smooth_0);
    var side_3 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S415.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S416)
        {
        }
        else
        {
            break;
        }
        var _S418 : vec2<f32> = ViewRay_at_0(_S412, middle_0);
        var _S419 : Probe_0 = probe_0(_S411, _S418.x, _S418.y, _S414, _S413.right_0, _S413.up_0);
        var _S420 : f32 = clamp(middle_0 - select(_S419.height_2, -1.0e+09f, _S419.hole_1), - _S417, _S417);
        if(_S420 <= 0.0f)
        {
            var _S421 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_3 > 0.0f);
            var _S422 : f32 = - _S420;
            under_1 = middle_0;
            above_gap_2 = _S421;
            under_gap_2 = _S422;
            side_3 = 1.0f;
        }
        else
        {
            var _S423 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_3 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S420;
            under_gap_2 = _S423;
            side_3 = -1.0f;
        }
        var _S424 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S420 / min(ViewRay_rate_0(_S412, _S419), -9.99999997475242708e-07f), under_1, above_3), _S415.smooth_0);
        var _S425 : u32 = i_1 + u32(1);
        middle_0 = _S424;
        i_1 = _S425;
    }
    return select(under_1, middle_0, _S415.smooth_0);
}

fn first_hit_of_yarn_0( _S426 : u32,  _S427 : SearchQuality_0,  _S428 : f32,  _S429 : f32,  _S430 : vec3<f32>,  _S431 : bool) -> Hit_0
{
    var _S432 : f32 = max(_S430.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S428, _S429);
    var _S433 : vec2<f32> = _S430.xy / vec2<f32>(_S432);
    ray_0.slope_1 = _S433;
    var _S434 : StepControl_0 = step_control_0((vec2<f32>(0) - _S433), 1.0f / max(steps_per_length_0(_S426, _S427, _S430) / _S432, 9.99999971718068537e-10f));
    var _S435 : ViewRayEnd_0 = search_down_0(_S426, ray_0, _S434, _S431);
    var hit_0 : Hit_0;
    hit_0.hole_4 = false;
    var _S436 : f32 = refined_height_0(_S426, ray_0, _S434, _S431, _S435, _S427.refinements_0);
    hit_0.height_6 = _S436;
    var _S437 : vec2<f32> = ViewRay_at_0(ray_0, _S436);
    hit_0.x_14 = _S437.x;
    hit_0.y_7 = _S437.y;
    return hit_0;
}

fn first_hit_0( _S438 : u32,  _S439 : SearchQuality_0,  _S440 : f32,  _S441 : f32,  _S442 : vec3<f32>,  _S443 : bool) -> Hit_0
{
    if(!passes_through_0(_S438, _S439, _S440, _S441, _S442, _S443))
    {
        return first_hit_of_yarn_0(_S438, _S439, _S440, _S441, _S442, _S443);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S440;
    hit_1.y_7 = _S441;
    hit_1.height_6 = 0.0f;
    hit_1.hole_4 = true;
    return hit_1;
}

fn surface_of_0( _S444 : u32,  _S445 : Sample_0,  _S446 : f32,  _S447 : f32,  _S448 : bool) -> SurfacePoint_0
{
    var _S449 : u32 = select(fabrics_0[_S444].weft_0, fabrics_0[_S444].warp_0, _S445.shown_3.is_warp_0);
    var _S450 : f32 = families_0[_S449].twist_sine_0 * select(1.0f, -1.0f, _S448);
    var _S451 : f32 = select(-1.0f, 1.0f, _S445.shown_3.is_warp_0);
    var _S452 : vec2<f32> = fibre_direction_0(_S445.slope_across_0, _S451 * _S445.slope_along_0, _S450, families_0[_S449].twist_cosine_0);
    var _S453 : f32 = _S452.x;
    var _S454 : f32 = _S452.y;
    var _S455 : f32 = select(_S445.slope_y_1, _S445.slope_x_1, _S445.shown_3.is_warp_0) * _S453 + _S451 * select(_S445.slope_x_1, _S445.slope_y_1, _S445.shown_3.is_warp_0) * _S454;
    var _S456 : f32 = select(_S445.crossing_1.weft_1.half_width_1, _S445.crossing_1.warp_1.half_width_1, _S445.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S457 : f32 = _S456 * arc_sine_0(clamp(_S445.section_1.across_1 / _S456, -1.0f, 1.0f));
    var _S458 : f32 = select(- _S446, _S447, _S445.shown_3.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_2 = _S445.shown_3.hole_0;
    point_4.is_warp_3 = _S445.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S445.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S445.crossing_1.weft_1.thread_2;
    point_4.height_4 = _S445.height_7;
    point_4.normal_3 = normalize(vec3<f32>(- _S445.slope_x_1, - _S445.slope_y_1, 1.0f));
    point_4.tangent_2 = normalize(select_vector_0(_S445.shown_3.is_warp_0, vec3<f32>(_S453, _S454, _S455), vec3<f32>(- _S454, _S453, _S455)));
    point_4.across_3 = _S445.section_1.across_1;
    point_4.fibre_across_0 = _S457 * families_0[_S449].twist_cosine_0 + _S458 * _S450;
    point_4.fibre_along_0 = _S458 * families_0[_S449].twist_cosine_0 - _S457 * _S450;
    var _S459 : f32 = run_share_0(_S445.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S459, _S459, _S445.shown_3.on_top_0);
    point_4.x_8 = _S446;
    point_4.y_1 = _S447;
    return point_4;
}

fn surface_met_0( _S460 : u32,  _S461 : f32,  _S462 : f32,  _S463 : f32,  _S464 : vec3<f32>,  _S465 : bool) -> SurfacePoint_0
{
    var _S466 : Sample_0 = sample_at_0(_S460, _S461, _S462, _S465);
    var point_5 : SurfacePoint_0 = surface_of_0(_S460, _S466, _S461, _S462, _S465);
    var _S467 : u32 = select(fabrics_0[_S460].weft_0, fabrics_0[_S460].warp_0, point_5.is_warp_3);
    var _S468 : f32 = select(_S466.crossing_1.weft_1.half_width_1, _S466.crossing_1.warp_1.half_width_1, point_5.is_warp_3) * 1.0154266357421875f;
    var _S469 : f32 = _S466.dive_1.z;
    var _S470 : f32 = _S466.slope_along_0 - (1.0f - _S469) * _S466.dive_1.y / families_0[_S467].height_scale_0;
    var _S471 : f32 = rsqrt_0(_S470 * _S470 + 1.0f);
    var _S472 : f32 = _S464.x;
    var _S473 : f32 = _S464.y;
    var _S474 : f32 = select(_S473, _S472, point_5.is_warp_3);
    var _S475 : f32 = _S464.z;
    var _S476 : f32 = (_S475 / families_0[_S467].height_scale_0 - _S470 * select(_S472, _S473, point_5.is_warp_3)) * _S471;
    var _S477 : f32 = square_1(_S468);
    var _S478 : f32 = sqrt(max(_S477 - square_1(point_5.across_3), 0.0f)) - (_S466.height_7 + _S469 * _S466.dive_1.x - _S463) / families_0[_S467].height_scale_0 * _S471;
    var _S479 : f32 = square_1(_S474) + square_1(_S476) + 9.999999960041972e-13f;
    var _S480 : f32 = point_5.across_3 * _S474 + _S478 * _S476;
    var _S481 : f32 = square_1(point_5.across_3) + square_1(_S478) - _S477;
    var _S482 : f32 = sqrt(max(square_1(_S480) - _S479 * _S481, 0.0f));
    var _S483 : f32 = clamp(select((_S482 - _S480) / _S479, - _S481 / max(_S480 + _S482, 9.999999960041972e-13f), _S480 > 0.0f), - _S468, _S468);
    var _S484 : f32 = point_5.across_3 + _S483 * _S474;
    point_5.across_3 = _S484;
    var _S485 : vec2<f32> = normalize(vec2<f32>(_S484, _S478 + _S483 * _S476));
    var _S486 : f32 = select(-1.0f, 1.0f, point_5.is_warp_3);
    var _S487 : f32 = families_0[_S467].twist_sine_0 * select(1.0f, -1.0f, _S465);
    var _S488 : f32 = _S485.x;
    var _S489 : f32 = _S487 * _S488 * _S471;
    var _S490 : f32 = _S485.y;
    var _S491 : f32 = - _S487 * _S490;
    var _S492 : f32 = families_0[_S467].twist_cosine_0 * _S471 - _S486 * _S470 * _S489;
    var _S493 : f32 = families_0[_S467].height_scale_0 * (families_0[_S467].twist_cosine_0 * _S486 * _S470 * _S471 + _S489);
    var _S494 : f32 = families_0[_S467].height_scale_0 * _S488;
    var _S495 : f32 = - families_0[_S467].height_scale_0 * _S470 * _S471 * _S490;
    point_5.normal_3 = normalize(vec3<f32>(select(_S495, _S494, point_5.is_warp_3), select(_S494, _S495, point_5.is_warp_3), _S471 * _S490));
    point_5.tangent_2 = normalize(vec3<f32>(select(- _S492, _S491, point_5.is_warp_3), select(_S491, _S492, point_5.is_warp_3), _S493));
    var _S496 : f32 = _S468 * angle_of_0(_S485);
    var _S497 : f32 = select(- _S461 - _S483 * _S472, _S462 + _S483 * _S473, point_5.is_warp_3);
    point_5.fibre_across_0 = _S496 * families_0[_S467].twist_cosine_0 + _S497 * _S487;
    point_5.fibre_along_0 = _S497 * families_0[_S467].twist_cosine_0 - _S496 * _S487;
    var _S498 : f32 = 0.00999999977648258f * _S468;
    var _S499 : f32 = - _S498;
    var _S500 : bool = _S483 < _S499;
    var _S501 : f32 = select(_S498, _S499, _S474 < 0.0f);
    var _S502 : f32 = max(_S483, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S502 * _S472, select(0.0f, _S501, point_5.is_warp_3), _S500);
    point_5.y_1 = point_5.y_1 + select(_S502 * _S473, select(_S501, 0.0f, point_5.is_warp_3), _S500);
    point_5.height_4 = select(_S463 + _S483 * _S475, _S463, _S500);
    return point_5;
}

fn hairs_over_0( _S503 : u32,  _S504 : SurfacePoint_0,  _S505 : bool,  _S506 : f32) -> Hairs_0
{
    var hairs_1 : Hairs_0;
    hairs_1.place_1 = vec2<f32>(_S504.x_8, _S504.y_1);
    hairs_1.below_1 = fabrics_0[_S503].height_high_0 - _S504.height_4;
    hairs_1.back_6 = _S505;
    hairs_1.size_3 = _S506;
    return hairs_1;
}

fn has_hairs_0( _S507 : u32) -> bool
{
    return (((families_0[fabrics_0[_S507].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S507].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S508 : u32,  _S509 : Hairs_0,  _S510 : vec3<f32>,  _S511 : f32) -> Hair_0
{
    var _S512 : f32 = fabrics_0[_S508].fibre_size_0;
    var _S513 : f32 = 17.0f * fabrics_0[_S508].fibre_size_0;
    var _S514 : f32 = fade_0(_S511, _S513);
    var _S515 : vec2<f32> = _S510.xy / vec2<f32>(max(_S510.z, 0.3333333432674408f));
    var _S516 : u32 = hash_key_0(select(u32(0), u32(1), _S509.back_6), ((fabrics_0[_S508].seed_0) ^ (u32(1013904242))));
    var _S517 : f32 = fabrics_0[_S508].fibre_size_0 / max(_S511, 0.07000000029802322f * fabrics_0[_S508].fibre_size_0);
    const _S518 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_3 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S518;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_5 : bool = false;
    var number_4 : u32 = u32(0);
    for(;;)
    {
        if(((_S514 > 0.0f) & ((number_4 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S519 : u32 = number_4 / u32(9);
        var _S520 : u32 = number_4 / u32(3) - u32(3) * _S519;
        var _S521 : vec2<f32> = (vec2<f32>(((f32(_S519) * 6.0f + 2.0f) * _S512 + _S509.below_1)) * _S515 + _S509.place_1) / vec2<f32>(_S513);
        var _S522 : vec2<f32> = floor(_S521) + vec2<f32>(f32(number_4 - u32(3) * _S520 - u32(9) * _S519), f32(_S520)) - vec2<f32>(1.0f);
        var _S523 : u32 = hash_bits_0(_S516 + _S519, u32(i32(_S522.x)) * u32(65536) + u32(i32(_S522.y)));
        var _S524 : u32 = hash_bits_0(_S516, _S523);
        var _S525 : vec2<f32> = _S521 - _S522 - vec2<f32>(share_of_0(_S523), share_of_0((_S523 >> (u32(10)))));
        var _S526 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S523 >> (u32(20)))));
        var _S527 : f32 = mix(5.0f, 16.0f, share_of_0((_S524 >> (u32(10))))) / 17.0f;
        var _S528 : f32 = _S525.x;
        var _S529 : f32 = _S526.y;
        var _S530 : f32 = _S525.y;
        var _S531 : f32 = _S526.x;
        var _S532 : f32 = (_S528 * _S529 + _S530 * _S531) / _S527;
        var _S533 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S524 >> (u32(20)))) - 1.0f);
        var _S534 : f32 = 0.5f * (2.0f * share_of_0((_S523 ^ (_S524))) - 1.0f);
        var _S535 : f32 = _S532 * (3.0f * _S534 * _S532 + 2.0f * _S533);
        var _S536 : f32 = rsqrt_0(_S535 * _S535 + 1.0f);
        var _S537 : f32 = (_S530 * _S529 - _S528 * _S531 - _S527 * _S532 * _S532 * (_S534 * _S532 + _S533)) * _S536 * 17.0f;
        var _S538 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S532)), 0.0f) * _S517;
        var _S539 : f32 = clamp(_S538 + 0.5f - abs(_S537) * _S517, 0.0f, min(2.0f * _S538, 1.0f));
        var _S540 : bool = ((((_S524 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S541 : bool = (((((share_of_0(_S524)) < (families_0[select(fabrics_0[_S508].weft_0, fabrics_0[_S508].warp_0, _S540)].hairiness_0)) & (((abs(_S532)) < 1.0f)))) & ((_S539 > cover_3)));
        var _S542 : vec2<f32> = vec2<f32>(- _S531 - _S535 * _S529, _S529 - _S535 * _S531) * vec2<f32>(_S536);
        var _S543 : f32 = select(cover_3, _S539, _S541);
        var _S544 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S542.x, _S541), select(hair_across_0.y, _S542.y, _S541));
        var _S545 : f32 = select(hair_away_0, _S537, _S541);
        var _S546 : bool = select(is_warp_5, _S540, _S541);
        var _S547 : u32 = number_4 + u32(1);
        cover_3 = _S543;
        hair_across_0 = _S544;
        hair_away_0 = _S545;
        is_warp_5 = _S546;
        number_4 = _S547;
    }
    var _S548 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_1 = _S514 * cover_3;
    hair_1.normal_1 = vec3<f32>(vec2<f32>(_S548) * hair_across_0, sqrt(1.0f - _S548 * _S548));
    hair_1.tangent_0 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_1 = is_warp_5;
    hair_1.shade_0 = _S514 * 0.03255363181233406f * (families_0[fabrics_0[_S508].warp_0].hairiness_0 + families_0[fabrics_0[_S508].weft_0].hairiness_0);
    return hair_1;
}

fn thread_of_family_0( _S549 : u32,  _S550 : SurfacePoint_0) -> i32
{
    var _S551 : u32 = select(fabrics_0[_S549].weft_0, fabrics_0[_S549].warp_0, _S550.is_warp_3);
    return i32(floor((select(_S550.y_1, _S550.x_8, _S550.is_warp_3) - _S550.across_3) / families_0[_S551].period_0)) * i32(families_0[_S551].count_0) + i32(select(_S550.weft_thread_0, _S550.warp_thread_0, _S550.is_warp_3));
}

fn toned_0( _S552 : u32,  _S553 : u32,  _S554 : Albedos_0,  _S555 : vec4<f32>) -> Albedos_0
{
    var _S556 : vec3<f32> = _S554.diffuse_reflect_0 + _S554.diffuse_transmit_0;
    var _S557 : vec3<f32> = vec3<f32>(1.0f);
    var _S558 : vec3<f32> = _S557 - vec3<f32>(fabrics_0[_S552].layer_bound_0) * max(_S554.specular_reflect_0, _S554.specular_transmit_0);
    var _S559 : vec3<f32> = vec3<f32>(0.0f);
    var _S560 : vec3<f32> = max(_S557 - _S556, _S559) / (_S557 + _S556);
    var _S561 : vec3<f32> = vec3<f32>(9.99999997475242708e-07f);
    var _S562 : vec3<f32> = (_S558 / max(_S556, _S561) - _S557) / max(vec3<f32>(0.89999997615814209f) * _S560, _S561);
    var _S563 : vec3<f32> = _S557 - vec3<f32>((saturate(min(min(_S562.x, _S562.y), _S562.z)) * _S555.z)) * _S560;
    var _S564 : vec3<f32> = min(vec3<f32>(families_0[_S553].nep_red_0, families_0[_S553].nep_green_0, families_0[_S553].nep_blue_0), _S558);
    var found_1 : Albedos_0 = _S554;
    var _S565 : f32 = _S555.w;
    var _S566 : vec3<f32> = _S563 * _S554.diffuse_transmit_0 * vec3<f32>((1.0f - _S565));
    found_1.diffuse_transmit_0 = _S566;
    found_1.diffuse_reflect_0 = clamp(mix(_S563 * _S554.diffuse_reflect_0, _S564, vec3<f32>(_S565)), _S559, max(_S558 - _S566, _S559));
    return found_1;
}

fn toned_at_0( _S567 : u32,  _S568 : bool,  _S569 : Albedos_0,  _S570 : f32,  _S571 : vec2<f32>) -> Albedos_0
{
    var _S572 : u32 = select(fabrics_0[_S567].weft_0, fabrics_0[_S567].warp_0, _S568);
    return toned_0(_S567, _S572, _S569, irregular_at_0(_S572, irregular_key_0(_S567, select(u32(1), u32(0), _S568)), _S570, select(_S571.x, _S571.y, _S568)));
}

fn varies_at_0( _S573 : u32,  _S574 : f32) -> bool
{
    return (((((fabrics_0[_S573].fibre_noise_0) > 0.0f) | (((fabrics_0[_S573].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S573].has_detail_0) != u32(0)) & ((_S574 >= 0.0f))))));
}

fn thread_number_0( _S575 : u32,  _S576 : SurfacePoint_0) -> u32
{
    return u32(thread_of_family_0(_S575, _S576)) * u32(2) + select(u32(0), u32(1), _S576.is_warp_3);
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

fn fibre_noise_at_0( _S577 : u32,  _S578 : u32,  _S579 : SurfacePoint_0,  _S580 : u32,  _S581 : f32) -> FibreNoise_0
{
    var _S582 : f32 = 5.0f * fabrics_0[_S577].fibre_size_0;
    var _S583 : vec2<f32> = wave_noise_0(hash_key_0(_S580, ((fabrics_0[_S577].seed_0) ^ (u32(458671337)))), _S579.fibre_along_0 / (25.0f * fabrics_0[_S577].fibre_size_0));
    var _S584 : f32 = _S579.fibre_across_0 + families_0[_S578].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S577].fibre_size_0 * _S583.x;
    var _S585 : vec3<f32> = fibre_cell_0(_S584, _S579.fibre_along_0, fabrics_0[_S577].fibre_size_0);
    var _S586 : vec3<f32> = fibre_cell_0(_S584, _S579.fibre_along_0, _S582);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S580, ((fabrics_0[_S577].seed_0) ^ (u32(1757159915)))), _S586);
    noise_0.bundle_offset_0 = _S586.z;
    noise_0.bundle_weight_0 = fade_0(_S581, _S582);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S580, ((fabrics_0[_S577].seed_0) ^ (u32(48610963)))), _S585);
    noise_0.fibre_weight_0 = fade_0(_S581, fabrics_0[_S577].fibre_size_0);
    noise_0.offset_2 = _S585.z;
    noise_0.slope_2 = 0.5f * _S583.y;
    return noise_0;
}

fn detail_gain_0( _S587 : u32,  _S588 : u32,  _S589 : SurfacePoint_0,  _S590 : bool,  _S591 : u32,  _S592 : f32) -> vec2<f32>
{
    var _S593 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S588].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S592, 1.0f / families_0[_S588].plies_per_mm_0), ply_offset_0(_S588, _S589, _S590));
    }
    else
    {
        gain_2 = _S593;
    }
    if((families_0[_S588].fibre_tone_0) > 0.0f)
    {
        var _S594 : FibreNoise_0 = fibre_noise_at_0(_S587, _S588, _S589, _S591, _S592);
        var _S595 : f32 = 4.5f * families_0[_S588].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S588].fibre_tone_0) * vec2<f32>(_S594.bundle_weight_0 * _S594.bundle_0.y + _S594.fibre_weight_0 * _S594.fibre_0.y, _S594.bundle_weight_0 + _S594.fibre_weight_0) + (groove_0(_S595 * (_S594.bundle_weight_0 * (0.5f * (_S594.bundle_0.x - 1.0f) + 1.0f)), _S594.bundle_offset_0) + groove_0(_S595 * _S594.fibre_weight_0, _S594.offset_2));
    }
    if((families_0[_S588].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S588].slub_0 * fade_0(_S592, 1.0f / families_0[_S588].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S591, ((fabrics_0[_S587].seed_0) ^ (u32(1373058189)))), select(- _S589.x_8, _S589.y_1, _S589.is_warp_3) * families_0[_S588].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S596 : u32,  _S597 : Albedos_0,  _S598 : u32,  _S599 : u32,  _S600 : vec2<f32>) -> Albedos_0
{
    var _S601 : vec3<f32> = max(_S597.specular_reflect_0, _S597.specular_transmit_0);
    var _S602 : vec3<f32> = _S597.diffuse_reflect_0 + _S597.diffuse_transmit_0;
    var _S603 : vec3<f32> = vec3<f32>(fabrics_0[_S596].layer_bound_0);
    var _S604 : vec3<f32> = vec3<f32>(1.0f);
    var _S605 : vec3<f32> = _S604 - _S603 * _S601;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S598, fabrics_0[_S596].colour_noise_0, fabrics_0[_S596].seed_0), _S602, _S605);
    var _S606 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S600.y, vec3<f32>(colour_1) * _S602, _S605) * _S600.x)));
    var _S607 : f32 = bounded_gain_0(fibre_gain_0(_S598, _S599, fabrics_0[_S596].fibre_noise_0, fabrics_0[_S596].seed_0), _S601, min((_S604 - _S606 * _S602) / _S603, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S606 * _S597.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S606 * _S597.diffuse_transmit_0;
    var _S608 : vec3<f32> = vec3<f32>(_S607);
    varied_0.specular_reflect_0 = _S608 * _S597.specular_reflect_0;
    varied_0.specular_transmit_0 = _S608 * _S597.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S609 : u32,  _S610 : SurfacePoint_0,  _S611 : Albedos_0,  _S612 : bool,  _S613 : f32,  _S614 : f32) -> Albedos_0
{
    var _S615 : u32 = thread_number_0(_S609, _S610);
    var _S616 : vec3<f32> = fibre_cell_0(_S610.fibre_across_0, _S610.fibre_along_0, fabrics_0[_S609].fibre_size_0);
    var _S617 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S609].has_detail_0) != u32(0)) & ((_S613 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S609, select(fabrics_0[_S609].weft_0, fabrics_0[_S609].warp_0, _S610.is_warp_3), _S610, _S612, _S615, _S613) * vec2<f32>(1.0f - _S614, 1.0f);
    }
    else
    {
        gain_3 = _S617;
    }
    return vary_albedos_0(_S609, _S611, _S615, u32(i32(_S616.x)) * u32(65536) + u32(i32(floor(_S616.y))), gain_3);
}

fn turned_frame_0( _S618 : u32,  _S619 : u32,  _S620 : SurfacePoint_0,  _S621 : bool,  _S622 : u32,  _S623 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_4 = _S620.normal_3;
    frame_2.tangent_3 = _S620.tangent_2;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S619].has_plies_0) > 0.0f)
    {
        var _S624 : f32 = fade_0(_S623, 1.0f / families_0[_S619].plies_per_mm_0);
        var _S625 : f32 = _S624 * 0.62000000476837158f * ply_offset_0(_S619, _S620, _S621);
        var _S626 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S627 : vec3<f32> = vec3<f32>(families_0[_S619].ply_cosine_0);
        var _S628 : vec3<f32> = vec3<f32>(select(families_0[_S619].ply_sine_0, - families_0[_S619].ply_sine_0, _S621));
        var _S629 : vec3<f32> = _S627 * _S626 + _S628 * frame_2.tangent_3;
        var _S630 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S625 * _S625));
        var _S631 : vec3<f32> = vec3<f32>(_S625);
        frame_2.tangent_3 = _S627 * (_S627 * frame_2.tangent_3 - _S628 * _S626) + _S628 * (_S630 * _S629 - _S631 * frame_2.normal_4);
        frame_2.normal_4 = _S630 * frame_2.normal_4 + _S631 * _S629;
        frame_2.loss_0 = _S624 * _S624 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S632 : f32 = families_0[_S619].fibre_tilt_0;
    if((families_0[_S619].fibre_tilt_0) > 0.0f)
    {
        var _S633 : FibreNoise_0 = fibre_noise_at_0(_S618, _S619, _S620, _S622, _S623);
        var _S634 : f32 = 1.09858846664428711f * _S632 * (_S633.bundle_weight_0 * _S633.bundle_0.x + _S633.fibre_weight_0 * (_S633.fibre_0.x + _S633.offset_2));
        var _S635 : f32 = _S632 * (1.42099642753601074f * (_S633.bundle_weight_0 * _S633.bundle_0.y + _S633.fibre_weight_0 * _S633.fibre_0.y) - _S633.bundle_weight_0 * _S633.slope_2);
        var _S636 : f32 = square_1(_S633.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S632 * _S632 * ((0.24761904776096344f * (square_1(_S633.bundle_weight_0) + _S636) + _S636 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S637 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S638 : vec2<f32> = sine_cosine_0(_S634);
        var _S639 : vec2<f32> = sine_cosine_0(_S635);
        var _S640 : vec3<f32> = vec3<f32>(_S638.y);
        var _S641 : vec3<f32> = vec3<f32>(_S638.x);
        var _S642 : vec3<f32> = _S640 * _S637 - _S641 * frame_2.normal_4;
        frame_2.normal_4 = _S640 * frame_2.normal_4 + _S641 * _S637;
        frame_2.tangent_3 = vec3<f32>(_S639.y) * frame_2.tangent_3 + vec3<f32>(_S639.x) * _S642;
    }
    return frame_2;
}

fn yarn_point_of_0( _S643 : u32,  _S644 : SurfacePoint_0,  _S645 : vec3<f32>,  _S646 : bool,  _S647 : bool,  _S648 : f32) -> YarnPoint_0
{
    var _S649 : u32 = fabrics_0[_S643].warp_0;
    var _S650 : u32 = fabrics_0[_S643].weft_0;
    var _S651 : u32 = select(fabrics_0[_S643].weft_0, fabrics_0[_S643].warp_0, _S644.is_warp_3);
    var _S652 : bool = (((fabrics_0[_S643].has_detail_0) != u32(0)) & ((_S648 >= 0.0f)));
    var point_6 : YarnPoint_0;
    point_6.hairs_0 = hairs_over_0(_S643, _S644, _S646, _S648);
    point_6.hair_cover_0 = 1.0f;
    var _S653 : vec3<f32> = vec3<f32>(0.0f);
    var _S654 : Hair_0 = Hair_x24init_0(0.0f, _S653, _S653, false, 0.0f);
    point_6.is_warp_4 = _S644.is_warp_3;
    var _S655 : bool = (_S652 & ((has_hairs_0(_S643))));
    var hair_2 : Hair_0;
    if(_S655)
    {
        var _S656 : Hair_0 = hair_towards_0(_S643, point_6.hairs_0, _S645, _S648);
        point_6.hair_cover_0 = _S656.cover_1;
        point_6.is_warp_4 = select(_S644.is_warp_3, _S656.is_warp_1, (_S656.cover_1) > 0.5f);
        hair_2 = _S656;
    }
    else
    {
        hair_2 = _S654;
    }
    var _S657 : u32 = select(_S650, _S649, point_6.is_warp_4);
    var albedos_3 : Albedos_0 = albedos_of_0(_S657, select(_S644.weft_thread_0, _S644.warp_thread_0, point_6.is_warp_4));
    var albedos_4 : Albedos_0;
    if((fabrics_0[_S643].is_irregular_0) != u32(0))
    {
        albedos_4 = toned_at_0(_S643, point_6.is_warp_4, albedos_3, f32(thread_of_family_0(_S643, _S644)), vec2<f32>(_S644.x_8, _S644.y_1));
    }
    else
    {
        albedos_4 = albedos_3;
    }
    if(varies_at_0(_S643, _S648))
    {
        albedos_4 = varied_at_0(_S643, _S644, albedos_4, _S646, _S648, hair_2.cover_1);
    }
    point_6.back_7 = _S646;
    point_6.hole_3 = _S647;
    point_6.x_13 = _S644.x_8;
    point_6.y_6 = _S644.y_1;
    point_6.height_5 = _S644.height_4 + hair_2.cover_1 * point_6.hairs_0.below_1;
    point_6.normal_8 = _S644.normal_3;
    point_6.tangent_8 = _S644.tangent_2;
    point_6.surface_normal_0 = normalize(mix(_S644.normal_3, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_1)));
    point_6.diffuse_gain_1 = 1.0f;
    if(_S652)
    {
        var _S658 : YarnFrame_0 = turned_frame_0(_S643, _S651, _S644, _S646, thread_number_0(_S643, _S644), _S648);
        var frame_3 : YarnFrame_0;
        if(_S655)
        {
            frame_3 = under_hair_0(_S658, hair_2);
        }
        else
        {
            frame_3 = _S658;
        }
        point_6.normal_8 = frame_3.normal_4;
        point_6.tangent_8 = frame_3.tangent_3;
        point_6.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S643].diffuse_blend_0);
    }
    point_6.roughness_8 = families_0[_S657].roughness_0;
    point_6.albedos_2 = albedos_4;
    return point_6;
}

fn locate_yarn_0( _S659 : u32,  _S660 : SearchQuality_0,  _S661 : f32,  _S662 : f32,  _S663 : vec3<f32>,  _S664 : f32) -> YarnPoint_0
{
    var _S665 : bool = (_S663.z) < 0.0f;
    var _S666 : vec3<f32> = to_face_frame_0(_S663, _S665);
    var _S667 : Hit_0 = first_hit_0(_S659, _S660, _S661, _S662, _S666, _S665);
    return yarn_point_of_0(_S659, surface_met_0(_S659, _S667.x_14, _S667.y_7, _S667.height_6, _S666, _S665), _S666, _S665, _S667.hole_4, _S664);
}

fn openness_number_0( _S668 : u32,  _S669 : u32) -> f32
{
    return table_number_0(fabrics_0[_S668].openness_0 + _S669);
}

fn blocked_of_terms_0( _S670 : u32,  _S671 : u32,  _S672 : array<f32, i32(6)>,  _S673 : u32) -> Blocked_0
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
            if(term_0 < _S673)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S670, _S671 + share_3 * _S673 + term_0) * _S672[term_0];
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

fn blocked_at_0( _S674 : u32,  _S675 : bool,  _S676 : bool,  _S677 : f32,  _S678 : f32) -> Blocked_0
{
    var _S679 : f32 = _S678 * openness_number_0(_S674, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S677, _S679, _S677 * _S677, _S677 * _S679, _S679 * _S679 );
    return blocked_of_terms_0(_S674, u32(60) + (select(u32(0), u32(2), _S676) + select(u32(1), u32(0), _S675)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S680 : u32,  _S681 : Albedos_0,  _S682 : u32,  _S683 : vec3<f32>) -> Scattered_0
{
    var _S684 : u32 = u32(159) + u32(2) * _S682;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S683 * _S681.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S680, _S684)) * _S681.specular_reflect_0;
    yarn_3.through_0 = _S683 * _S681.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S680, _S684 + u32(1))) * _S681.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S685 : u32,  _S686 : u32,  _S687 : vec3<f32>,  _S688 : vec3<f32>,  _S689 : vec3<f32>,  _S690 : vec3<f32>,  _S691 : ptr<function, vec3<f32>>,  _S692 : ptr<function, vec3<f32>>)
{
    var _S693 : u32 = u32(146) + u32(4) * _S686;
    var _S694 : f32 = openness_number_0(_S685, _S693 + u32(1));
    var _S695 : f32 = openness_number_0(_S685, _S693 + u32(2));
    var _S696 : vec3<f32> = vec3<f32>(1.0f);
    var _S697 : vec3<f32> = _S696 - _S689 * vec3<f32>(openness_number_0(_S685, _S693));
    var _S698 : vec3<f32> = _S696 - _S690 * vec3<f32>(openness_number_0(_S685, _S693 + u32(3)));
    var _S699 : vec3<f32> = _S696 / (_S697 * _S698 - _S689 * _S690 * vec3<f32>((_S694 * _S695)));
    (*_S691) = (_S687 * _S698 + _S689 * vec3<f32>(_S694) * _S688) * _S699;
    (*_S692) = (_S688 * _S697 + _S690 * vec3<f32>(_S695) * _S687) * _S699;
    return;
}

fn face_sends_0( _S700 : u32,  _S701 : u32,  _S702 : Scattered_0,  _S703 : Scattered_0) -> FaceSends_0
{
    var _S704 : u32 = u32(2) * _S701;
    var _S705 : u32 = u32(142) + _S704;
    var _S706 : f32 = openness_number_0(_S700, _S705);
    var _S707 : f32 = openness_number_0(_S700, _S705 + u32(1));
    var _S708 : vec3<f32> = vec3<f32>((1.0f - _S706)) * _S702.back_5;
    var _S709 : vec3<f32> = vec3<f32>((1.0f - _S707)) * _S703.back_5;
    var sends_1 : FaceSends_0;
    var _S710 : u32 = u32(154) + _S704;
    var _S711 : f32 = openness_number_0(_S700, _S710);
    sends_1.blocks_warp_0 = _S711;
    var _S712 : f32 = openness_number_0(_S700, _S710 + u32(1));
    sends_1.blocks_weft_0 = _S712;
    sends_1.open_0 = _S711 * _S706 + _S712 * _S707;
    var _S713 : vec3<f32> = vec3<f32>(_S706) * _S702.back_5;
    var _S714 : vec3<f32> = vec3<f32>(_S707) * _S703.back_5;
    var _S715 : vec3<f32> = sends_1.sky_warp_0;
    var _S716 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S700, _S701, _S713, _S714, _S708, _S709, &(_S715), &(_S716));
    sends_1.sky_warp_0 = _S715;
    sends_1.sky_weft_0 = _S716;
    var _S717 : vec3<f32> = sends_1.crossing_warp_0;
    var _S718 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S700, _S701, _S702.through_0, _S703.through_0, _S708, _S709, &(_S717), &(_S718));
    sends_1.crossing_warp_0 = _S717;
    sends_1.crossing_weft_0 = _S718;
    return sends_1;
}

fn interior_of_0( _S719 : u32,  _S720 : vec3<f32>,  _S721 : bool) -> Interior_0
{
    var _S722 : Scattered_0 = scattered_by_0(_S719, table_albedos_0(families_0[fabrics_0[_S719].warp_0].colour_mean_0), u32(0), _S720);
    var _S723 : Scattered_0 = scattered_by_0(_S719, table_albedos_0(families_0[fabrics_0[_S719].weft_0].colour_mean_0), u32(1), _S720);
    var _S724 : FaceSends_0 = face_sends_0(_S719, select(u32(0), u32(1), _S721), _S722, _S723);
    var _S725 : FaceSends_0 = face_sends_0(_S719, select(u32(1), u32(0), _S721), _S722, _S723);
    var _S726 : vec3<f32> = vec3<f32>(_S724.blocks_warp_0);
    var _S727 : vec3<f32> = vec3<f32>(_S724.blocks_weft_0);
    var _S728 : vec3<f32> = _S726 * _S724.crossing_warp_0 + _S727 * _S724.crossing_weft_0;
    var _S729 : vec3<f32> = vec3<f32>(_S725.blocks_warp_0);
    var _S730 : vec3<f32> = vec3<f32>(_S725.blocks_weft_0);
    var _S731 : vec3<f32> = _S729 * _S725.crossing_warp_0 + _S730 * _S725.crossing_weft_0;
    var _S732 : f32 = 1.0f - _S724.open_0;
    var _S733 : f32 = 1.0f - _S725.open_0;
    var _S734 : vec3<f32> = vec3<f32>(1.0f);
    var _S735 : vec3<f32> = _S734 / (_S734 - _S728 * _S731 * vec3<f32>((_S732 * _S733)));
    var _S736 : vec3<f32> = _S731 * (vec3<f32>(_S724.open_0) + vec3<f32>(_S732) * (_S726 * _S724.sky_warp_0 + _S727 * _S724.sky_weft_0)) * _S735;
    var _S737 : vec3<f32> = _S728 * (vec3<f32>(_S725.open_0) + vec3<f32>(_S733) * (_S729 * _S725.sky_warp_0 + _S730 * _S725.sky_weft_0)) * _S735;
    var _S738 : FaceRadiance_0 = face_radiance_0(_S724, _S725.open_0, _S736, _S737);
    var _S739 : FaceRadiance_0 = face_radiance_0(_S725, _S724.open_0, _S737, _S736);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S738.warp_2;
    interior_1.weft_3 = _S738.weft_2;
    interior_1.leaked_1 = _S738.leaked_0;
    interior_1.far_1 = _S739.mean_0;
    interior_1.far_leaked_0 = _S739.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S740 : u32,  _S741 : YarnPoint_0,  _S742 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S743 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S743;
    nothing_0.transmitted_0 = _S743;
    if((((fabrics_0[_S740].openness_0) == u32(4294967295)) | ((_S741.hole_3))))
    {
        return nothing_0;
    }
    return bounced_by_0(blocked_at_0(_S740, _S741.is_warp_4, _S741.back_7, _S741.surface_normal_0.z, _S741.height_5), scattered_by_0(_S740, _S741.albedos_2, select(u32(1), u32(0), _S741.is_warp_4), _S742), interior_of_0(_S740, _S742, _S741.back_7));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S744 : u32,  _S745 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S744 * frame_record_0.height_0 + _S745.y) * frame_record_0.width_0 + _S745.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S746 : u32,  _S747 : u32) -> vec3<f32>
{
    var _S748 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S746 * frame_record_0.environment_columns_0 + _S747);
    return vec3<f32>(scene_number_0(_S748), scene_number_0(_S748 + u32(1)), scene_number_0(_S748 + u32(2)));
}

fn sample_environment_0( _S749 : vec2<f32>,  _S750 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S751 : u32 = frame_record_0.environment_rows_0;
    var _S752 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S749.y);
    var _S753 : u32 = frame_record_0.environment_columns_0;
    var _S754 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S752.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S749.x);
    var _S755 : vec3<f32> = environment_texel_0(_S752.index_6, _S754.index_6);
    (*_S750) = _S755 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S755), 9.99999968265522539e-21f)));
    var _S756 : f32 = 3.14159274101257324f / f32(_S751);
    var _S757 : f32 = mix(sine_cosine_0(f32(_S752.index_6) * _S756).y, sine_cosine_0(f32(_S752.index_6 + u32(1)) * _S756).y, _S752.remainder_0);
    var _S758 : f32 = sqrt(max(1.0f - _S757 * _S757, 0.0f));
    var _S759 : vec2<f32> = sine_cosine_0((f32(_S754.index_6) + _S754.remainder_0) * (6.28318548202514648f / f32(_S753)));
    var _S760 : f32 = _S758 * _S759.x;
    var _S761 : f32 = - _S758 * _S759.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S760 + frame_record_0.environment_sine_0 * _S761, _S757, frame_record_0.environment_cosine_0 * _S761 - frame_record_0.environment_sine_0 * _S760);
}

fn light_sample_0( _S762 : u32,  _S763 : vec2<u32>,  _S764 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S765 : u32 = frame_record_0.lights_0;
    if(_S762 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S766 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S763, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S762 - _S765), u32(3)), &(weight_0));
        sample_1.towards_0 = _S766;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S767 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S762);
    sample_1.irradiance_1 = vec3<f32>(_S767.red_0, _S767.green_0, _S767.blue_0);
    sample_1.towards_0 = vec3<f32>(_S767.x_9, _S767.y_2, _S767.z_1);
    if((_S767.is_point_0) != u32(0))
    {
        var _S768 : vec3<f32> = sample_1.towards_0 - _S764;
        var _S769 : f32 = max(square_0(_S768), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S769);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S769);
        sample_1.towards_0 = normalize(_S768);
    }
    return sample_1;
}

fn hairs_lit_0( _S770 : u32,  _S771 : Hairs_0,  _S772 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S770, _S771, _S772, _S771.size_3 + fabrics_0[_S770].fibre_size_0).cover_1;
}

fn under_hairs_0( _S773 : u32,  _S774 : YarnPoint_0,  _S775 : vec3<f32>) -> f32
{
    if((((_S774.hair_cover_0) >= 1.0f) | (((_S775.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S773, _S774.hairs_0, _S775), 1.0f, _S774.hair_cover_0);
}

fn scattered_0( _S776 : u32,  _S777 : YarnPoint_0,  _S778 : vec3<f32>,  _S779 : vec3<f32>) -> vec3<f32>
{
    var _S780 : vec3<f32> = vec3<f32>(0.0f);
    var _S781 : bool = !_S777.hole_3;
    var _S782 : f32 = _S778.z;
    var value_1 : vec3<f32>;
    if((_S781 & ((_S782 > 0.0f))))
    {
        value_1 = (_S777.albedos_2.diffuse_reflect_0 * vec3<f32>(_S777.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0(_S778, _S777.normal_8, fabrics_0[_S776].diffuse_blend_0)) + _S777.albedos_2.specular_reflect_0 * vec3<f32>(reflection_0(_S778, _S779, _S777.normal_8, _S777.tangent_8, _S777.roughness_8, fabrics_0[_S776].optical_depth_0))) * vec3<f32>(under_hairs_0(_S776, _S777, _S778));
    }
    else
    {
        if((_S781 & ((_S782 < 0.0f))))
        {
            value_1 = _S777.albedos_2.diffuse_transmit_0 * vec3<f32>(_S777.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S778), _S777.normal_8, fabrics_0[_S776].diffuse_blend_0)) + _S777.albedos_2.specular_transmit_0 * vec3<f32>(transmission_1(_S778, _S779, _S777.normal_8, _S777.tangent_8, _S777.roughness_8, fabrics_0[_S776].optical_depth_0));
        }
        else
        {
            value_1 = _S780;
        }
    }
    var _S783 : f32 = fabrics_0[_S776].sheen_strength_0;
    if((fabrics_0[_S776].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S784 : vec2<f32> = sheen_with_transmittance_0(_S778, _S779, _S783, fabrics_0[_S776].sheen_roughness_0);
    return vec3<f32>(_S784.y) * value_1 + vec3<f32>(_S784.x);
}

fn surface_at_0( _S785 : u32,  _S786 : f32,  _S787 : f32,  _S788 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S785, sample_at_0(_S785, _S786, _S787, _S788), _S786, _S787, _S788);
}

fn unoccluded_0( _S789 : u32,  _S790 : SearchQuality_0,  _S791 : f32,  _S792 : f32,  _S793 : f32,  _S794 : vec3<f32>,  _S795 : bool) -> bool
{
    if((_S794.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S789, _S790, vec3<f32>(_S791, _S792, _S793 + fabrics_0[_S789].lift_0), _S794, _S795, max_height_along_0(_S789, _S791, _S792, _S793, _S794, _S795));
}

fn is_lit_0( _S796 : u32,  _S797 : SearchQuality_0,  _S798 : YarnPoint_0,  _S799 : vec3<f32>) -> bool
{
    if(_S798.hole_3)
    {
        return true;
    }
    var _S800 : vec3<f32> = to_face_frame_0(_S799, _S798.back_7);
    var _S801 : f32 = _S800.z;
    var _S802 : bool = _S801 < 0.0f;
    var normal_9 : vec3<f32>;
    var height_11 : f32;
    if(_S802)
    {
        var _S803 : SurfacePoint_0 = surface_at_0(_S796, _S798.x_13, _S798.y_6, !_S798.back_7);
        normal_9 = _S803.normal_3;
        height_11 = _S803.height_4;
    }
    else
    {
        normal_9 = _S798.surface_normal_0;
        height_11 = _S798.height_5;
    }
    var _S804 : vec3<f32> = vec3<f32>(_S800.xy, abs(_S801));
    if((dot(normal_9, _S804)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S796, _S797, _S798.x_13, _S798.y_6, height_11, _S804, (_S798.back_7) != _S802);
}

fn evaluate_with_0( _S805 : u32,  _S806 : SearchQuality_0,  _S807 : YarnPoint_0,  _S808 : Bounced_0,  _S809 : vec3<f32>,  _S810 : vec3<f32>) -> vec3<f32>
{
    var _S811 : vec3<f32> = to_face_frame_0(_S810, _S807.back_7);
    var _S812 : vec3<f32> = scattered_0(_S805, _S807, to_face_frame_0(_S809, _S807.back_7), _S811);
    var _S813 : bool;
    if((max(_S812.x, max(_S812.y, _S812.z))) <= 0.0f)
    {
        _S813 = true;
    }
    else
    {
        _S813 = !is_lit_0(_S805, _S806, _S807, _S809);
    }
    var value_2 : vec3<f32>;
    if(_S813)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S812;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S808, _S809, _S810);
    var _S814 : f32 = fabrics_0[_S805].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S805].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S814 * sheen_lobe_0(abs(_S811.z), fabrics_0[_S805].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S815 : u32,  _S816 : YarnPoint_0,  _S817 : vec3<f32>) -> f32
{
    if(!_S816.hole_3)
    {
        return 0.0f;
    }
    var _S818 : f32 = fabrics_0[_S815].sheen_strength_0;
    if((fabrics_0[_S815].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S818 * sheen_lobe_0(abs(_S817.z), fabrics_0[_S815].sheen_roughness_0).z;
}

fn light_of_point_0( _S819 : u32,  _S820 : VisiblePoint_0,  _S821 : vec2<u32>,  _S822 : vec3<f32>,  _S823 : vec2<f32>) -> vec4<f32>
{
    var _S824 : SearchQuality_0 = default_quality_0();
    var _S825 : vec3<f32> = to_local_0(_S820, _S820.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S823;
    footprint_0.dx_0 = _S820.draft_dx_0;
    footprint_0.dy_0 = _S820.draft_dy_0;
    var _S826 : YarnPoint_0 = locate_yarn_0(_S819, _S824, _S823.x, _S823.y, _S825, Footprint_spread_side_0(footprint_0));
    var point_7 : YarnPoint_0 = _S826;
    var _S827 : Bounced_0 = bounced_at_0(_S819, _S826, _S822);
    point_7.albedos_2 = tinted_0(point_7.albedos_2, _S822);
    var _S828 : vec3<f32> = vec3<f32>(0.0f);
    var number_5 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S828;
    for(;;)
    {
        if(number_5 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S829 : f32 = visibility_at_0(number_5, _S821);
        if(_S829 <= 0.0f)
        {
            number_5 = number_5 + u32(1);
            continue;
        }
        var _S830 : LightSample_0 = light_sample_0(number_5, _S821, _S820.position_4);
        radiance_1 = radiance_1 + vec3<f32>(_S829) * _S830.irradiance_1 * evaluate_with_0(_S819, _S824, point_7, _S827, to_local_0(_S820, _S830.towards_0), _S825);
        number_5 = number_5 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S819, point_7, _S825));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S831 : u32 = id_0.x;
    var _S832 : bool;
    if(_S831 >= (frame_record_0.width_0))
    {
        _S832 = true;
    }
    else
    {
        _S832 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S832)
    {
        return;
    }
    var _S833 : vec2<u32> = id_0.xy;
    var _S834 : u32 = id_0.y * frame_record_0.width_0 + _S831;
    var _S835 : u32 = layers_0[_S834].face_0;
    if((layers_0[_S834].face_0) == u32(0))
    {
        return;
    }
    var _S836 : u32 = _S835 - u32(1);
    var _S837 : u32 = fabric_of_0(_S836);
    var _S838 : VisiblePoint_0 = visible_point_0(_S837, _S836, _S833);
    var _S839 : vec3<f32> = filtered_albedo_0(_S837, _S838);
    var _S840 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S840;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S841 : vec2<f32> = pixel_sequence_0(_S833, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S837, _S838, _S833, _S839, irregular_place_0(_S837, _S838.draft_0 + vec2<f32>(_S841.x) * _S838.draft_dx_0 + vec2<f32>(_S841.y) * _S838.draft_dy_0, 0.0f));
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S834, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

