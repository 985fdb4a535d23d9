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
    @align(4) has_plies_0 : f32,
    @align(4) plies_per_mm_0 : f32,
    @align(4) ply_sine_0 : f32,
    @align(4) ply_cosine_0 : f32,
    @align(4) fibre_tilt_0 : f32,
    @align(4) fibre_tone_0 : f32,
    @align(4) slub_0 : f32,
    @align(4) slubs_per_mm_0 : f32,
    @align(4) per_half_width_0 : f32,
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

fn square_1( x_2 : f32) -> f32
{
    return x_2 * x_2;
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S1 : u32 = (bitcast<u32>((x_3)));
    var m_0 : f32 = (bitcast<f32>(((((_S1 & (u32(8388607)))) | (u32(1056964608))))));
    var _S2 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S1 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S2);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S2) - 1.0f;
    var _S3 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S3 - exponent_0 * 0.00021219444170129f - 0.5f * _S3) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S4 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S5 : f32 = floor(_S4 * 1.4426950216293335f + 0.5f);
    var _S6 : f32 = _S4 - _S5 * 0.693359375f + _S5 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S6 + 0.00139819993637502f) * _S6 + 0.00833345204591751f) * _S6 + 0.04166579619050026f) * _S6 + 0.1666666567325592f) * _S6 + 0.5f) * _S6 * _S6 + _S6 + 1.0f) * (bitcast<f32>(((u32(i32(_S5) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S7 : u32 = scene_words_0[index_0];
    var _S8 : vec3<f32> = vec3<f32>(f32((_S7 & (u32(1023)))), f32((((_S7 >> (u32(10)))) & (u32(1023)))), f32((_S7 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S8 * _S8;
}

fn map_level_0( first_1 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S9 : f32 = uv_0.x;
    var _S10 : f32 = f32(side_0);
    var _S11 : f32 = (_S9 - floor(_S9)) * _S10 - 0.5f;
    var _S12 : f32 = uv_0.y;
    var _S13 : f32 = (_S12 - floor(_S12)) * _S10 - 0.5f;
    var _S14 : f32 = floor(_S11);
    var _S15 : i32 = i32(side_0);
    var _S16 : u32 = side_0 - u32(1);
    var _S17 : u32 = (u32(i32(_S14) + _S15) & (_S16));
    var _S18 : f32 = floor(_S13);
    var _S19 : u32 = (u32(i32(_S18) + _S15) & (_S16));
    var _S20 : u32 = ((_S17 + u32(1)) & (_S16));
    var _S21 : u32 = first_1 + _S19 * side_0;
    var _S22 : vec3<f32> = vec3<f32>((_S11 - _S14));
    var _S23 : u32 = first_1 + (((_S19 + u32(1)) & (_S16))) * side_0;
    return mix(mix(map_texel_0(_S21 + _S17), map_texel_0(_S21 + _S20), _S22), mix(map_texel_0(_S23 + _S17), map_texel_0(_S23 + _S20), _S22), vec3<f32>((_S13 - _S18)));
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S24 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S25 : u32 = ((((_S24 >> ((((_S24 >> (u32(28)))) + u32(4))))) ^ (_S24))) * u32(277803737);
    return (((_S25 >> (u32(22)))) ^ (_S25));
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

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_1 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S26 : u32 = pixel_0.x;
    var _S27 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S26, _S27, stream_2), uniform_hash_0(_S26, _S27, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
     position_0 : vec3<f32>,
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
    var _S28 : vec2<f32> = this_0.dx_0;
    var _S29 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S28, _S28) + dot(_S29, _S29)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S30 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S30, - _S30, back_2));
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S31 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S31, fma(- _S31, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
     thread_2 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S32 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S33 : f32 = fma(- _S32, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S33;
    cell_2.above_0 = families_0[family_1].size_0 - _S33;
    cell_2.across_0 = _S33 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S32).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_2;
}

fn table_number_0( index_3 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_3])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S34 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S35 : u32 = min(thread_3 + select(u32(0), u32(1), _S34 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S36 : u32 = families_0[family_2].place_table_0 + _S35 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S35;
    cell_3.below_0 = _S34 - table_number_0(_S36);
    cell_3.above_0 = table_number_0(_S36 + u32(1)) - _S34;
    cell_3.across_0 = _S34 - table_number_0(_S36 + u32(2));
    cell_3.half_width_1 = table_number_0(_S36 + u32(3));
    return cell_3;
}

fn locate_0( family_3 : u32,  position_3 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
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
    var _S37 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var shown_0 : Shown_0;
    var _S38 : bool = !((abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1));
    var _S39 : bool = (_S37 & (((_S38 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_0 = _S39;
    shown_0.hole_0 = ((!_S37) & (_S38));
    var _S40 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S39);
    shown_0.word_0 = _S40;
    shown_0.on_top_0 = (((_S40 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_2 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_4 : Cell_0;
    cell_4.thread_2 = select(second_0.thread_2, first_2.thread_2, is_first_0);
    cell_4.across_0 = select(second_0.across_0, first_2.across_0, is_first_0);
    cell_4.half_width_1 = select(second_0.half_width_1, first_2.half_width_1, is_first_0);
    cell_4.below_0 = select(second_0.below_0, first_2.below_0, is_first_0);
    cell_4.above_0 = select(second_0.above_0, first_2.above_0, is_first_0);
    return cell_4;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S41 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S41.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S41.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_5 : u32,  first_3 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_3) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_5, last_0) - boundary_0(family_5, thread_5, first_3);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_6 : u32) -> Bend_0
{
    var _S42 : u32 = families_0[family_6].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S42);
    bend_0.half_tangent_0 = table_number_0(_S42 + u32(1));
    bend_0.arc_0 = table_number_0(_S42 + u32(2));
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
    var _S43 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S44 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S45 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S46 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S47 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S47;
    var _S48 : i32 = - _S43;
    var _S49 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S48, i32(0));
    run_0.from_start_0 = _S49;
    var _S50 : i32 = _S44 + i32(1);
    var _S51 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S50);
    run_0.to_end_0 = _S51;
    var _S52 : bool = _S49 < _S51;
    run_0.near_start_0 = _S52;
    var _S53 : i32 = select(_S50, _S48 - _S45, _S52);
    var _S54 : i32 = select(_S50 + _S46, _S48, _S52);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S49, _S51), 1.0e+06f, _S47);
    run_0.reach_0 = min(0.5f * (_S49 + _S51), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S53, _S54), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S43 == i32(0);
    run_0.last_crossing_0 = _S44 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_5 : Cell_0) -> Section_0
{
    var _S55 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S56 : f32 = clamp(cell_5.across_0, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_1 = _S56;
    var _S57 : f32 = _S55 * _S55 - square_1(_S56);
    var _S58 : f32 = rsqrt_0(_S57);
    section_0.drop_0 = _S55 - _S57 * _S58;
    section_0.slope_0 = - _S56 * _S58;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S59 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S60 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S61 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S59) - crossed_1.half_width_1;
    var _S62 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S59);
    var _S63 : f32;
    if(shown_1.on_top_0)
    {
        _S63 = 0.0f;
    }
    else
    {
        _S63 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S64 : f32;
    if((shown_1.on_top_0) != _S62)
    {
        _S64 = 0.0f;
    }
    else
    {
        _S64 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S59));
    }
    var _S65 : f32 = 1.0f / max(2.0f * _S61, 9.999999960041972e-13f);
    var _S66 : f32 = clamp((_S61 - _S60) * _S65, 0.0f, 1.0f);
    return vec2<f32>(_S63 + (_S64 - _S63) * (_S66 * _S66 * (3.0f - 2.0f * _S66)), (_S63 - _S64) * (6.0f * _S66 * (1.0f - _S66) * _S65) * select(-1.0f, 1.0f, _S59));
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
    var _S67 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S67), 9.99999971718068537e-10f);
    var _S68 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S68), 9.99999971718068537e-10f);
    control_0.right_0 = _S67 > 0.0f;
    control_0.up_0 = _S68 > 0.0f;
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

fn outline_distance_0( cell_6 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S69 : f32 = select(- cell_6.across_0, cell_6.across_0, forwards_0);
    var _S70 : f32 = select(cell_6.below_0, cell_6.above_0, forwards_0);
    var _S71 : f32 = - cell_6.half_width_1;
    var _S72 : bool = _S69 < _S71;
    var _S73 : bool = _S69 >= (cell_6.half_width_1);
    var _S74 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_0)));
    var _S75 : f32 = select(cell_6.half_width_1, _S71, _S72) - _S69;
    var _S76 : f32 = select(_S70, 2.0f * _S70 + _S69 - cell_6.half_width_1, ((shown_2.hole_0) | (((_S74 & ((!shown_2.on_top_0)))))));
    if((((_S74 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S72)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S75, _S76, _S73);
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
    var _S77 : f32 = previous_1.rate_0 * step_4;
    var _S78 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_1)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S77) >= 0.0f) & (((3.0f * clearance_1 - _S78) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S79 : f32 = clearance_1 - previous_1.clearance_0;
    var _S80 : f32 = 6.0f * _S79 - 4.0f * _S77 - 2.0f * _S78;
    var _S81 : f32 = -2.0f * _S77 / max(_S80 + sqrt(max(_S80 * _S80 - 4.0f * (3.0f * (_S77 + _S78 - 2.0f * _S79)) * _S77, 0.0f)), 9.99999968265522539e-21f);
    var _S82 : f32 = 1.0f - _S81;
    return select(-1.0f, _S82 * step_4, ((((_S81 > 0.01999999955296516f) & ((_S82 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S81 + 1.0f) + _S77 * _S81) * _S82 * _S82 + (clearance_1 * (2.0f * _S82 + 1.0f) - _S78 * _S82) * _S81 * _S81) < 0.0f))));
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
    var _S83 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S83, 0.0f) + this_2.epsilon_0, _S83 - this_2.epsilon_0, ((((!here_2.hole_1) & (((rate_3 * _S83 + clearance_3) < 0.0f)))) & ((_S83 > (2.0f * this_2.epsilon_0))))));
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
    var _S84 : f32 = end_0 - start_1;
    var _S85 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S84;
    var _S86 : f32 = 3.0f * _S84 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S84, 9.99999968265522539e-21f);
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
        var _S87 : f32 = clamp(share_1 - (((_S85 * share_1 + _S86) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S85 * share_1 + 2.0f * _S86) * share_1 + start_rate_0, 0.10000000149011612f * _S84 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S88 : i32 = i_0 + i32(1);
        share_1 = _S87;
        i_0 = _S88;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S89 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S90 : f32 = rsqrt_0(_S89);
    var _S91 : f32 = sine_1 * _S90 * rsqrt_0(_S89 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S91 * _S89, _S91 * across_slope_0 * along_slope_0 + cosine_0 * _S90);
}

fn arc_sine_0( x_6 : f32) -> f32
{
    var _S92 : f32 = abs(x_6);
    var _S93 : bool = _S92 > 0.5f;
    var _S94 : f32 = select(_S92 * _S92, 0.5f * (1.0f - _S92), _S93);
    var _S95 : f32 = select(_S92, sqrt(max(_S94, 0.0f)), _S93);
    var _S96 : f32 = ((((0.04216320067644119f * _S94 + 0.02418131195008755f) * _S94 + 0.04547002539038658f) * _S94 + 0.07495300471782684f) * _S94 + 0.16666752099990845f) * _S94 * _S95 + _S95;
    var _S97 : f32 = select(_S96, 1.57079637050628662f - 2.0f * _S96, _S93);
    return select(_S97, - _S97, x_6 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S98 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S98 / (_S98 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

struct Hair_0
{
     cover_0 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>) -> Hair_0
{
    var _S99 : Hair_0;
    _S99.cover_0 = cover_1;
    _S99.normal_1 = normal_2;
    _S99.tangent_0 = tangent_1;
    return _S99;
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S100 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S101 : f32 = x_7 - _S100 * 1.5703125f - _S100 * 0.00048375129699707f - _S100 * 7.54979012640433211e-08f;
    var _S102 : f32 = _S101 * _S101;
    var _S103 : f32 = ((-0.00019515295571182f * _S102 + 0.00833216123282909f) * _S102 - 0.16666655242443085f) * _S102 * _S101 + _S101;
    var _S104 : f32 = ((0.00002443315679557f * _S102 - 0.00138873164542019f) * _S102 + 0.04166664555668831f) * _S102 * _S102 - 0.5f * _S102 + 1.0f;
    var _S105 : u32 = (u32(i32(_S100)) & (u32(3)));
    var _S106 : vec2<f32> = select_vector_1(((_S105 & (u32(1)))) != u32(0), vec2<f32>(_S104, _S103), vec2<f32>(_S103, _S104));
    var _S107 : f32 = _S106.x;
    var _S108 : f32 = _S106.y;
    return vec2<f32>(select(_S107, - _S107, ((_S105 & (u32(2)))) != u32(0)), select(_S108, - _S108, (((_S105 + u32(1)) & (u32(2)))) != u32(0)));
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

fn table_albedos_0( row_0 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_0);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_0 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_0 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_0 + u32(9));
    return albedos_0;
}

fn albedos_of_0( family_8 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_2 : f32,  along_0 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S109 : f32 = floor(across_2 / width_2);
    return vec3<f32>(_S109, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S109, 2.0f * (across_2 / width_2 - _S109) - 1.0f);
}

struct SurfacePoint_0
{
     hole_2 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_4 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     across_3 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     shown_share_0 : f32,
};

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S110 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S110 - floor(_S110)) - 1.0f;
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_1 : u32,  position_4 : f32) -> vec2<f32>
{
    var _S111 : f32 = floor(position_4);
    var _S112 : f32 = position_4 - _S111;
    var _S113 : u32 = u32(i32(_S111));
    var _S114 : f32 = signed_noise_0(hash_bits_0(key_1, _S113));
    var _S115 : f32 = signed_noise_0(hash_bits_0(key_1, _S113 + u32(1)));
    return vec2<f32>(mix(_S114, _S115, smooth_share_0(_S112)), 6.0f * _S112 * (1.0f - _S112) * (_S115 - _S114));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S116 : f32 = cell_7.y;
    var _S117 : f32 = floor(_S116);
    var _S118 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S117));
    var _S119 : u32 = hash_bits_0(key_2, _S118);
    var _S120 : u32 = hash_bits_0(key_2, _S118 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S119), signed_noise_0((_S119 >> (u32(16))))), vec2<f32>(signed_noise_0(_S120), signed_noise_0((_S120 >> (u32(16))))), vec2<f32>(smooth_share_0(_S116 - _S117)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S121 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S121.x, _S121.y), _S121.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S122 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S122.x, _S122.y), _S122.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_8 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_4 : vec3<f32>,
     tangent_3 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S123 : vec3<f32> = select_vector_0((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_0), hair_0.tangent_0);
    var blended_0 : YarnFrame_0;
    var _S124 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S125 : vec3<f32> = normalize(mix(frame_0.normal_4, hair_0.normal_1, _S124));
    blended_0.normal_4 = _S125;
    var _S126 : vec3<f32> = mix(frame_0.tangent_3, _S123, _S124);
    var _S127 : vec3<f32> = _S126 - vec3<f32>(dot(_S126, _S125)) * _S125;
    blended_0.tangent_3 = _S127 * vec3<f32>(rsqrt_0(max(dot(_S127, _S127), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_4.z - 1.0f) + 1.0f));
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
    var _S128 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S129 : vec3<f32> = sends_0.sky_warp_0 + _S128 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S129;
    var _S130 : vec3<f32> = sends_0.sky_weft_0 + _S128 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S130;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S129 + vec3<f32>(sends_0.blocks_weft_0) * _S130;
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
    var _S131 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S132 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S132 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S132 * interior_0.far_1 + yarn_2.back_5 * _S131;
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

fn choose_0( table_0 : u32,  count_1 : u32,  number_0 : f32) -> Choice_0
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
        var _S133 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S133)) <= number_0)
        {
            low_0 = _S133;
        }
        else
        {
            high_0 = _S133;
        }
    }
    var _S134 : u32 = table_0 + low_0;
    var _S135 : f32 = scene_number_0(_S134);
    var _S136 : f32 = scene_number_0(_S134 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S135) / max(_S136 - _S135, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

struct Light_0
{
     is_point_0 : u32,
     x_8 : f32,
     y_1 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_4 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_4];
    record_1.x_8 = (bitcast<f32>((scene_words_0[first_4 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_4 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_4 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_4 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_4 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_4 + u32(6)])));
    return record_1;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_5 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S137 : f32 = light_1.z;
    if(_S137 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S137, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S138 : f32 = dot(direction_3, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S138 * _S138 + 1.0f, roughness_1 * roughness_1));
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S139 : f32 = roughness_2 * roughness_2;
    var _S140 : f32 = squared_along_0 * (1.0f - _S139) + _S139;
    return 0.31830987334251404f * _S139 * roughness_2 / (_S140 * _S140);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S141 : vec3<f32> = light_2 + view_1;
    var _S142 : f32 = dot(_S141, tangent_5);
    return flake_density_0(min(_S142 * _S142 / max(square_0(_S141), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S143 : f32 = dot(light_3, normal_6);
    var _S144 : f32 = dot(view_2, normal_6);
    if(((_S143 <= 0.0f) | ((_S144 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S145 : f32 = max(_S143, 9.99999997475242708e-07f);
    var _S146 : f32 = max(_S144, 9.99999997475242708e-07f);
    var _S147 : f32 = projected_area_1(light_3, tangent_6, roughness_4) * _S146 + projected_area_1(view_2, tangent_6, roughness_4) * _S145;
    var _S148 : f32 = optical_depth_1 * _S147 / (_S145 * _S146);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S148 * mean_attenuation_0(_S148)) * _S145 / _S147;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S149 : f32 = - dot(light_4, normal_7);
    var _S150 : f32 = dot(view_3, normal_7);
    if(((_S149 <= 0.0f) | ((_S150 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S151 : f32 = 1.0f / max(_S150, 9.99999997475242708e-07f);
    var _S152 : f32 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S149, 9.99999997475242708e-07f);
    var _S153 : f32 = projected_area_1(view_3, tangent_7, roughness_5) * _S151;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S152, _S153)) * mean_attenuation_0(optical_depth_2 * abs(_S152 - _S153)) * _S151;
}

fn sheen_scale_0( x_9 : f32,  y_2 : f32) -> f32
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

fn sheen_shear_0( x_10 : f32,  y_3 : f32) -> f32
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_11 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_6 : f32) -> vec3<f32>
{
    var _S154 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S155 : f32 = 2.0f * sqrt(_S154) - 1.0f;
    var _S156 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S155, _S156), 0.00999999977648258f, 1.0f), clamp((1.0f - _S154) * sheen_shear_0(_S155, _S156), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S155, _S156), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S157 : f32 = light_5.z;
    if(((_S157 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S158 : vec2<f32> = view_4.xy;
    var _S159 : f32 = dot(_S158, _S158);
    var _S160 : vec2<f32> = select_vector_1(_S159 > 9.99999968265522539e-21f, _S158 * vec2<f32>(rsqrt_0(max(_S159, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S161 : f32 = scale_0 * dot(light_5.xy, _S160) + shear_0 * _S157;
    var _S162 : f32 = scale_0 * (light_5.y * _S160.x - light_5.x * _S160.y);
    var _S163 : f32 = _S161 * _S161 + _S162 * _S162 + _S157 * _S157;
    return 0.31830987334251404f * scale_0 * scale_0 * _S157 / max(_S163 * _S163, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S164 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S165 : f32 = strength_0 * _S164.z;
    return vec2<f32>(_S165 * transformed_cosine_0(light_6, view_5, _S164.x, _S164.y), 1.0f - _S165);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S166 : f32 = light_7.z;
    return select_vector_0((_S166 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S166) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S167 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S167 * (1.0f - light_8.w);
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

fn face_point_0( _S168 : u32,  _S169 : u32,  _S170 : f32,  _S171 : f32) -> VisiblePoint_0
{
    var _S172 : u32 = u32(3) * _S169;
    var _S173 : Vertex_0 = vertex_at_0(_S172);
    var _S174 : Vertex_0 = vertex_at_0(_S172 + u32(1));
    var _S175 : Vertex_0 = vertex_at_0(_S172 + u32(2));
    var _S176 : vec3<f32> = position_of_0(_S173);
    var _S177 : vec3<f32> = position_of_0(_S174) - _S176;
    var _S178 : vec3<f32> = position_of_0(_S175) - _S176;
    var _S179 : f32 = _S174.u_0 - _S173.u_0;
    var _S180 : f32 = _S174.v_0 - _S173.v_0;
    var _S181 : vec2<f32> = vec2<f32>(_S179, _S180);
    var _S182 : f32 = _S175.u_0 - _S173.u_0;
    var _S183 : f32 = _S175.v_0 - _S173.v_0;
    var _S184 : vec2<f32> = vec2<f32>(_S182, _S183);
    var _S185 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S179 * _S183 - _S180 * _S182) < 0.0f));
    var _S186 : vec3<f32> = _S185 * (vec3<f32>(_S183) * _S177 - vec3<f32>(_S180) * _S178);
    var _S187 : vec3<f32> = _S185 * (vec3<f32>(_S179) * _S178 - vec3<f32>(_S182) * _S177);
    var point_2 : VisiblePoint_0;
    var _S188 : vec3<f32> = vec3<f32>(_S170);
    var _S189 : vec3<f32> = vec3<f32>(_S171);
    var _S190 : vec3<f32> = normalize(vec3<f32>((1.0f - _S170 - _S171)) * normal_of_0(_S173) + _S188 * normal_of_0(_S174) + _S189 * normal_of_0(_S175));
    point_2.normal_0 = _S190;
    var _S191 : vec3<f32> = normalize(_S186 - _S190 * vec3<f32>(dot(_S190, _S186)));
    point_2.axis_x_0 = _S191;
    point_2.axis_y_0 = cross(_S190, _S191);
    var _S192 : vec3<f32> = normalize(cross(_S177, _S178));
    point_2.face_normal_0 = select_vector_0((dot(_S192, _S190)) < 0.0f, (vec3<f32>(0) - _S192), _S192);
    point_2.position_0 = _S176 + _S188 * _S177 + _S189 * _S178;
    point_2.view_0 = _S190;
    var _S193 : vec2<f32> = vec2<f32>(_S173.u_0, _S173.v_0) + vec2<f32>(_S170) * _S181 + vec2<f32>(_S171) * _S184;
    point_2.uv_1 = _S193;
    var _S194 : bool = (dot(cross(_S186, _S187), _S190)) < 0.0f;
    var _S195 : vec2<f32> = vec2<f32>(fabrics_0[_S168].uv_width_0, select(fabrics_0[_S168].uv_height_0, - fabrics_0[_S168].uv_height_0, _S194));
    point_2.draft_per_uv_0 = _S195;
    point_2.draft_0 = _S193 * _S195 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S168].uv_height_0, _S194));
    var _S196 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S196;
    point_2.draft_dy_0 = _S196;
    return point_2;
}

fn visible_point_0( _S197 : u32,  _S198 : u32,  _S199 : vec2<u32>) -> VisiblePoint_0
{
    var _S200 : u32 = u32(3) * _S198;
    var _S201 : Vertex_0 = vertex_at_0(_S200);
    var _S202 : Vertex_0 = vertex_at_0(_S200 + u32(1));
    var _S203 : Vertex_0 = vertex_at_0(_S200 + u32(2));
    var _S204 : vec3<f32> = position_of_0(_S201);
    var _S205 : vec3<f32> = position_of_0(_S202) - _S204;
    var _S206 : vec3<f32> = position_of_0(_S203) - _S204;
    var _S207 : vec3<f32> = cross(_S205, _S206);
    var _S208 : f32 = f32(frame_record_0.width_0);
    var _S209 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S208));
    var _S210 : f32 = f32(frame_record_0.height_0);
    var _S211 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S210));
    var _S212 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S199.x) + 0.5f - 0.5f * _S208)) * _S209 + vec3<f32>((f32(_S199.y) + 0.5f - 0.5f * _S210)) * _S211;
    var _S213 : f32 = dot(_S212, _S207);
    var _S214 : f32 = 1.0f / select(1.00000000317107685e-30f, _S213, (abs(_S213)) > 1.00000000317107685e-30f);
    var _S215 : vec3<f32> = _S204 - camera_origin_0();
    var _S216 : vec3<f32> = vec3<f32>((dot(_S215, _S207) * _S214));
    var _S217 : vec3<f32> = _S212 * _S216 - _S215;
    var _S218 : vec3<f32> = _S216 * (_S209 - _S212 * vec3<f32>((dot(_S209, _S207) * _S214)));
    var _S219 : vec3<f32> = _S216 * (_S211 - _S212 * vec3<f32>((dot(_S211, _S207) * _S214)));
    var _S220 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S207), 1.00000000317107685e-30f)));
    var _S221 : vec3<f32> = cross(_S206, _S207) * _S220;
    var _S222 : vec3<f32> = cross(_S207, _S205) * _S220;
    var _S223 : vec2<f32> = vec2<f32>(_S202.u_0 - _S201.u_0, _S202.v_0 - _S201.v_0);
    var _S224 : vec2<f32> = vec2<f32>(_S203.u_0 - _S201.u_0, _S203.v_0 - _S201.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S197, _S198, dot(_S217, _S221), dot(_S217, _S222));
    point_3.position_0 = _S204 + _S217;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S212));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S218, _S221)) * _S223 + vec2<f32>(dot(_S218, _S222)) * _S224) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S219, _S221)) * _S223 + vec2<f32>(dot(_S219, _S222)) * _S224) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S225 : u32,  _S226 : VisiblePoint_0) -> vec3<f32>
{
    var _S227 : u32 = fabrics_0[_S225].albedo_map_levels_0;
    if((fabrics_0[_S225].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S228 : vec2<f32> = vec2<f32>(fabrics_0[_S225].uv_width_0, fabrics_0[_S225].uv_height_0);
    var _S229 : vec2<f32> = _S226.draft_dx_0 / _S228;
    var _S230 : vec2<f32> = _S226.draft_dy_0 / _S228;
    var _S231 : u32 = _S227 - u32(1);
    var _S232 : u32 = (u32(1) << (_S231));
    var _S233 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S229.x * _S230.y - _S229.y * _S230.x), 9.99999968265522539e-21f) * (square_1(f32(_S232)) / 3.0f)), 0.0f, f32(_S227) - 1.0f);
    var _S234 : u32 = min(u32(_S233), max(_S227, u32(2)) - u32(2));
    var _S235 : u32 = min(_S234 + u32(1), _S231);
    var _S236 : u32 = (u32(1) << ((u32(2) * _S227)));
    return mix(map_level_0(fabrics_0[_S225].albedo_map_0 + (_S236 - ((_S236 >> ((u32(2) * _S234))))) / u32(3), (_S232 >> (_S234)), _S226.uv_1), map_level_0(fabrics_0[_S225].albedo_map_0 + (_S236 - ((_S236 >> ((u32(2) * _S235))))) / u32(3), (_S232 >> (_S235)), _S226.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S233 - f32(_S234))) - 1.0f) / 3.0f)));
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_3 : bool,
     is_warp_2 : bool,
     x_12 : f32,
     y_5 : f32,
     height_5 : f32,
     normal_8 : vec3<f32>,
     tangent_8 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_8 : f32,
     albedos_2 : Albedos_0,
};

struct Hit_0
{
     x_13 : f32,
     y_6 : f32,
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
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S237 : u32,  _S238 : f32,  _S239 : f32,  _S240 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S237].warp_0, _S238);
    crossing_2.weft_1 = locate_0(fabrics_0[_S237].weft_0, _S239);
    var _S241 : u32 = fabrics_0[_S237].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S237].ends_1 + crossing_2.warp_1.thread_2);
    var _S242 : u32 = words_0[_S241];
    crossing_2.warp_word_0 = _S242;
    crossing_2.weft_word_0 = words_0[_S241 + u32(1)];
    crossing_2.warp_above_0 = (((_S242 & (u32(1)))) == u32(1)) != _S240;
    return crossing_2;
}

fn sample_at_0( _S243 : u32,  _S244 : f32,  _S245 : f32,  _S246 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S247 : Crossing_0 = crossing_at_0(_S243, _S244, _S245, _S246);
    sample_0.crossing_1 = _S247;
    var _S248 : Shown_0 = shown_at_0(_S247, _S246);
    sample_0.shown_3 = _S248;
    var _S249 : u32 = select(fabrics_0[_S243].weft_0, fabrics_0[_S243].warp_0, _S248.is_warp_0);
    var _S250 : u32 = select(fabrics_0[_S243].warp_0, fabrics_0[_S243].weft_0, _S248.is_warp_0);
    var _S251 : Cell_0 = select_cell_0(_S248.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S252 : Cell_0 = select_cell_0(_S248.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S253 : Run_0 = unpack_0(_S249, _S250, _S251.thread_2, _S252, _S248.word_0);
    var _S254 : Section_0 = section_at_0(_S251);
    var _S255 : bool = ((_S248.on_top_0) & (((_S253.distance_0) < (_S254.drop_0 * _S253.bend_1.sine_0))));
    var _S256 : f32 = select(-1.0f, 1.0f, ((_S248.on_top_0) & ((!_S255))));
    var _S257 : f32 = select(_S253.reach_0, _S253.other_reach_0, _S255);
    var _S258 : f32 = select(max(_S257 - _S253.distance_0, 0.0f), _S257 + _S253.distance_0, _S255);
    var _S259 : f32 = _S257 / _S253.bend_1.sine_0 - _S256 * _S254.drop_0;
    var _S260 : f32 = _S258 * _S258;
    var _S261 : f32 = max(_S259 * _S259 - _S260, 9.99999968265522539e-21f);
    var _S262 : f32 = rsqrt_0(_S261);
    var _S263 : f32 = _S260 / (_S261 * _S262 + _S259);
    var _S264 : bool = _S258 > 0.0f;
    var _S265 : f32 = select(-1.0f, 1.0f, _S248.on_top_0) * select(-1.0f, 1.0f, _S253.near_start_0);
    var _S266 : f32 = _S254.slope_0 * select(1.0f, _S259 * _S262, _S264);
    sample_0.slope_across_0 = _S266;
    var _S267 : f32 = select(0.0f, _S265 * _S258 * _S262, _S264);
    sample_0.slope_along_0 = _S267;
    var _S268 : vec2<f32> = dive_0(_S250, _S248, _S253, _S252);
    sample_0.height_7 = select(families_0[_S249].height_scale_0 * _S256, 0.0f, _S253.straight_0) * (_S257 * _S253.bend_1.half_tangent_0 - _S263) - families_0[_S249].height_scale_0 * _S254.drop_0 - _S268.x;
    var _S269 : f32 = families_0[_S249].height_scale_0 * _S266;
    var _S270 : f32 = families_0[_S249].height_scale_0 * _S267 - _S268.y;
    sample_0.slope_x_1 = select(_S270, _S269, _S248.is_warp_0);
    sample_0.slope_y_1 = select(_S269, _S270, _S248.is_warp_0);
    sample_0.run_3 = _S253;
    sample_0.section_1 = _S254;
    return sample_0;
}

fn steps_per_length_0( _S271 : u32,  _S272 : SearchQuality_0,  _S273 : vec3<f32>) -> f32
{
    return max(max(abs(_S273.x) * fabrics_0[_S271].threads_per_x_0, abs(_S273.y) * fabrics_0[_S271].threads_per_y_0) * _S272.steps_per_thread_0, abs(_S273.z) * fabrics_0[_S271].per_relief_0 * _S272.steps_per_relief_0);
}

fn cell_maximum_0( _S274 : u32,  _S275 : Crossing_0) -> f32
{
    var _S276 : u32 = select(fabrics_0[_S274].weft_0, fabrics_0[_S274].warp_0, _S275.warp_above_0);
    return f32((select(_S275.weft_word_0, _S275.warp_word_0, _S275.warp_above_0) >> (u32(28)))) * families_0[_S276].height_scale_0 * families_0[_S276].level_0;
}

fn probe_0( _S277 : u32,  _S278 : f32,  _S279 : f32,  _S280 : bool,  _S281 : bool,  _S282 : bool) -> Probe_0
{
    var _S283 : Sample_0 = sample_at_0(_S277, _S278, _S279, _S280);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S283.height_7;
    probe_1.hole_1 = _S283.shown_3.hole_0;
    probe_1.slope_x_0 = _S283.slope_x_1;
    probe_1.slope_y_0 = _S283.slope_y_1;
    probe_1.yarn_1 = select(_S283.crossing_1.weft_1.thread_2 * u32(2), _S283.crossing_1.warp_1.thread_2 * u32(2) + u32(1), _S283.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S277, _S283.crossing_1);
    probe_1.side_x_0 = select(_S283.crossing_1.warp_1.below_0, _S283.crossing_1.warp_1.above_0, _S281);
    probe_1.side_y_0 = select(_S283.crossing_1.weft_1.below_0, _S283.crossing_1.weft_1.above_0, _S282);
    probe_1.edge_x_0 = outline_distance_0(_S283.crossing_1.warp_1, _S283.shown_3, _S283.run_3, !_S283.shown_3.is_warp_0, _S281);
    probe_1.edge_y_0 = outline_distance_0(_S283.crossing_1.weft_1, _S283.shown_3, _S283.run_3, _S283.shown_3.is_warp_0, _S282);
    return probe_1;
}

fn is_free_0( _S284 : u32,  _S285 : SearchQuality_0,  _S286 : vec3<f32>,  _S287 : vec3<f32>,  _S288 : bool,  _S289 : f32) -> bool
{
    var _S290 : f32 = _S287.z;
    if(_S290 <= 0.0f)
    {
        return false;
    }
    var _S291 : f32 = 1.0f / max(_S285.shadow_share_0 * steps_per_length_0(_S284, _S285, _S287), 9.99999971718068537e-10f);
    var _S292 : StepControl_0 = step_control_0(_S287.xy, _S291);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S286.z + _S290 * distance_1) < _S289))))
        {
        }
        else
        {
            break;
        }
        var _S293 : vec3<f32> = _S286 + _S287 * vec3<f32>(distance_1);
        var _S294 : Probe_0 = probe_0(_S284, _S293.x, _S293.y, _S288, _S292.right_0, _S292.up_0);
        var _S295 : f32 = _S293.z;
        var _S296 : f32 = _S295 - _S294.height_2;
        var _S297 : f32 = _S290 - _S294.slope_x_0 * _S287.x - _S294.slope_y_0 * _S287.y;
        if(((!_S294.hole_1) & ((_S296 < 0.0f))))
        {
            return false;
        }
        var _S298 : f32 = way_back_to_dip_0(previous_3, _S296, _S297, last_step_0, _S294);
        if(_S298 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S298;
            distance_1 = distance_1 - _S298;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S299 : bool = _S295 > (_S294.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S292, _S294, _S296, _S297), max(StepControl_to_cell_exit_0(_S292, _S294.side_x_0, _S294.side_y_0), _S291), _S299);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S296, _S297, _S294, _S299);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S300 : u32,  _S301 : SearchQuality_0,  _S302 : f32,  _S303 : f32,  _S304 : vec3<f32>,  _S305 : bool) -> bool
{
    if(!sample_at_0(_S300, _S302, _S303, _S305).shown_3.hole_0)
    {
        return false;
    }
    var _S306 : vec3<f32> = vec3<f32>(_S302, _S303, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        if(((side_1 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S307 : bool = is_free_0(_S300, _S301, _S306, select_vector_0(side_1 == u32(0), _S304, vec3<f32>(- _S304.x, - _S304.y, _S304.z)), _S305 != (side_1 == u32(1)), fabrics_0[_S300].height_high_0);
        var _S308 : u32 = side_1 + u32(1);
        passes_0 = _S307;
        side_1 = _S308;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_8 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S309 : u32,  _S310 : f32,  _S311 : f32,  _S312 : f32,  _S313 : vec3<f32>,  _S314 : bool) -> f32
{
    var _S315 : f32 = _S313.x;
    var _S316 : f32 = _S313.y;
    var _S317 : u32 = (words_0[fabrics_0[_S309].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S309].weft_0, _S311).thread_2 / u32(2) * fabrics_0[_S309].max_height_columns_0 + locate_0(fabrics_0[_S309].warp_0, _S310).thread_2 / u32(2)) + (select(u32(0), u32(1), _S315 > 0.0f) + select(u32(0), u32(2), _S316 > 0.0f))] >> (u32(select(i32(0), i32(4), _S314))));
    var _S318 : f32 = max(abs(_S315) * fabrics_0[_S309].threads_per_x_0, abs(_S316) * fabrics_0[_S309].threads_per_y_0) / _S313.z;
    var _S319 : f32 = fabrics_0[_S309].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S309].height_high_0;
    var number_1 : i32 = i32(3);
    for(;;)
    {
        if(number_1 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S312) * _S318) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S317 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S319);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S320 : u32,  _S321 : f32,  _S322 : f32,  _S323 : bool,  _S324 : bool,  _S325 : bool) -> vec3<f32>
{
    var _S326 : Crossing_0 = crossing_at_0(_S320, _S321, _S322, _S323);
    return vec3<f32>(cell_maximum_0(_S320, _S326), select(_S326.warp_1.below_0, _S326.warp_1.above_0, _S324), select(_S326.weft_1.below_0, _S326.weft_1.above_0, _S325));
}

fn first_sample_height_0( _S327 : u32,  _S328 : ViewRay_0,  _S329 : StepControl_0,  _S330 : bool) -> f32
{
    var _S331 : f32 = max_height_along_0(_S327, _S328.origin_0.x, _S328.origin_0.y, 0.0f, vec3<f32>(_S328.slope_1, 1.0f), _S330);
    var count_3 : u32 = u32(0);
    var height_9 : f32 = _S331;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S332 : vec2<f32> = ViewRay_at_0(_S328, height_9);
        var _S333 : vec3<f32> = cell_bounds_0(_S327, _S332.x, _S332.y, _S330, _S329.right_0, _S329.up_0);
        var _S334 : f32 = height_9 - _S333.x;
        var _S335 : f32 = StepControl_to_cell_exit_0(_S329, _S333.y, _S333.z);
        var height_10 : f32 = height_9 - clamp(_S334, 0.0f, _S335);
        if(_S334 <= _S335)
        {
            height_9 = height_10;
            break;
        }
        count_3 = count_3 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S336 : u32,  _S337 : ViewRay_0,  _S338 : StepControl_0,  _S339 : bool) -> ViewRayEnd_0
{
    var _S340 : f32 = fabrics_0[_S336].height_low_0 - (fabrics_0[_S336].height_high_0 - fabrics_0[_S336].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S336, _S337, _S338, _S339);
    end_1.last_step_3 = _S338.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
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
        var _S341 : vec2<f32> = ViewRay_at_0(_S337, end_1.height_8);
        var _S342 : Probe_0 = probe_0(_S336, _S341.x, _S341.y, _S339, _S338.right_0, _S338.up_0);
        var _S343 : f32 = end_1.height_8 - _S342.height_2;
        var _S344 : f32 = ViewRay_rate_0(_S337, _S342);
        end_1.depth_1 = - _S343;
        end_1.rate_4 = _S344;
        var _S345 : bool = !_S342.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S345))) & (((end_1.previous_4.yarn_0) == (_S342.yarn_1))));
        if((((_S345 & ((_S343 <= 0.0f)))) | (((end_1.height_8) <= _S340))))
        {
            break;
        }
        var _S346 : f32 = way_back_to_dip_0(end_1.previous_4, _S343, _S344, end_1.last_step_3, _S342);
        if(_S346 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S346;
            end_1.last_step_3 = end_1.last_step_3 - _S346;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S347 : f32 = min(StepControl_to_cell_exit_0(_S338, _S342.side_x_0, _S342.side_y_0), end_1.height_8 - _S342.cell_max_0);
        var _S348 : f32 = StepControl_to_next_sample_0(_S338, _S342, _S343, _S344);
        end_1.previous_4 = after_sample_0(_S343, _S344, _S342, _S347 > _S348);
        var _S349 : f32 = max(_S347, _S348);
        end_1.last_step_3 = _S349;
        end_1.height_8 = end_1.height_8 - _S349;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S350 : u32,  _S351 : ViewRay_0,  _S352 : StepControl_0,  _S353 : bool,  _S354 : ViewRayEnd_0,  _S355 : u32) -> f32
{
    var _S356 : f32 = fabrics_0[_S350].height_high_0 - fabrics_0[_S350].height_low_0;
    var above_2 : f32 = _S354.height_8 + _S354.last_step_3;
    var above_gap_1 : f32 = clamp(_S354.previous_4.clearance_0, 0.0f, _S356);
    var under_gap_1 : f32 = clamp(_S354.depth_1, 0.0f, _S356);
    var middle_0 : f32 = select(between_0(above_2, _S354.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S354.previous_4.rate_0 * _S354.last_step_3, _S354.rate_4 * _S354.last_step_3) * _S354.last_step_3, _S354.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S354.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S355)
        {
        }
        else
        {
            break;
        }
        var _S357 : vec2<f32> = ViewRay_at_0(_S351, middle_0);
        var _S358 : Probe_0 = probe_0(_S350, _S357.x, _S357.y, _S353, _S352.right_0, _S352.up_0);
        var _S359 : f32 = clamp(middle_0 - select(_S358.height_2, -1.0e+09f, _S358.hole_1), - _S356, _S356);
        if(_S359 <= 0.0f)
        {
            var _S360 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S361 : f32 = - _S359;
            under_1 = middle_0;
            above_gap_2 = _S360;
            under_gap_2 = _S361;
            side_2 = 1.0f;
        }
        else
        {
            var _S362 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S359;
            under_gap_2 = _S362;
            side_2 = -1.0f;
        }
        var _S363 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S359 / min(ViewRay_rate_0(_S351, _S358), -9.99999997475242708e-07f), under_1, above_3), _S354.smooth_0);
        var _S364 : u32 = i_1 + u32(1);
        middle_0 = _S363;
        i_1 = _S364;
    }
    return select(under_1, middle_0, _S354.smooth_0);
}

fn first_hit_of_yarn_0( _S365 : u32,  _S366 : SearchQuality_0,  _S367 : f32,  _S368 : f32,  _S369 : vec3<f32>,  _S370 : bool) -> Hit_0
{
    var _S371 : f32 = max(_S369.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S367, _S368);
    var _S372 : vec2<f32> = _S369.xy / vec2<f32>(_S371);
    ray_0.slope_1 = _S372;
    var _S373 : StepControl_0 = step_control_0((vec2<f32>(0) - _S372), 1.0f / max(steps_per_length_0(_S365, _S366, _S369) / _S371, 9.99999971718068537e-10f));
    var _S374 : ViewRayEnd_0 = search_down_0(_S365, ray_0, _S373, _S370);
    var hit_0 : Hit_0;
    hit_0.hole_4 = false;
    var _S375 : f32 = refined_height_0(_S365, ray_0, _S373, _S370, _S374, _S366.refinements_0);
    hit_0.height_6 = _S375;
    var _S376 : vec2<f32> = ViewRay_at_0(ray_0, _S375);
    hit_0.x_13 = _S376.x;
    hit_0.y_6 = _S376.y;
    return hit_0;
}

fn first_hit_0( _S377 : u32,  _S378 : SearchQuality_0,  _S379 : f32,  _S380 : f32,  _S381 : vec3<f32>,  _S382 : bool) -> Hit_0
{
    if(!passes_through_0(_S377, _S378, _S379, _S380, _S381, _S382))
    {
        return first_hit_of_yarn_0(_S377, _S378, _S379, _S380, _S381, _S382);
    }
    var hit_1 : Hit_0;
    hit_1.x_13 = _S379;
    hit_1.y_6 = _S380;
    hit_1.height_6 = 0.0f;
    hit_1.hole_4 = true;
    return hit_1;
}

fn surface_at_0( _S383 : u32,  _S384 : f32,  _S385 : f32,  _S386 : bool) -> SurfacePoint_0
{
    var _S387 : Sample_0 = sample_at_0(_S383, _S384, _S385, _S386);
    var _S388 : u32 = select(fabrics_0[_S383].weft_0, fabrics_0[_S383].warp_0, _S387.shown_3.is_warp_0);
    var _S389 : f32 = families_0[_S388].twist_sine_0 * select(1.0f, -1.0f, _S386);
    var _S390 : f32 = select(-1.0f, 1.0f, _S387.shown_3.is_warp_0);
    var _S391 : vec2<f32> = fibre_direction_0(_S387.slope_across_0, _S390 * _S387.slope_along_0, _S389, families_0[_S388].twist_cosine_0);
    var _S392 : f32 = _S391.x;
    var _S393 : f32 = _S391.y;
    var _S394 : f32 = select(_S387.slope_y_1, _S387.slope_x_1, _S387.shown_3.is_warp_0) * _S392 + _S390 * select(_S387.slope_x_1, _S387.slope_y_1, _S387.shown_3.is_warp_0) * _S393;
    var _S395 : f32 = select(_S387.crossing_1.weft_1.half_width_1, _S387.crossing_1.warp_1.half_width_1, _S387.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S396 : f32 = _S395 * arc_sine_0(clamp(_S387.section_1.across_1 / _S395, -1.0f, 1.0f));
    var _S397 : f32 = select(- _S384, _S385, _S387.shown_3.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_2 = _S387.shown_3.hole_0;
    point_4.is_warp_1 = _S387.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S387.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S387.crossing_1.weft_1.thread_2;
    point_4.height_4 = _S387.height_7;
    point_4.normal_3 = normalize(vec3<f32>(- _S387.slope_x_1, - _S387.slope_y_1, 1.0f));
    point_4.tangent_2 = normalize(select_vector_0(_S387.shown_3.is_warp_0, vec3<f32>(_S392, _S393, _S394), vec3<f32>(- _S393, _S392, _S394)));
    point_4.across_3 = _S387.section_1.across_1;
    point_4.fibre_across_0 = _S396 * families_0[_S388].twist_cosine_0 + _S397 * _S389;
    point_4.fibre_along_0 = _S397 * families_0[_S388].twist_cosine_0 - _S396 * _S389;
    var _S398 : f32 = run_share_0(_S387.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S398, _S398, _S387.shown_3.on_top_0);
    return point_4;
}

fn has_hairs_0( _S399 : u32) -> bool
{
    return (((families_0[fabrics_0[_S399].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S399].weft_0].hairiness_0) > 0.0f)));
}

fn hair_at_0( _S400 : u32,  _S401 : vec2<f32>,  _S402 : bool,  _S403 : f32) -> Hair_0
{
    var _S404 : f32 = fabrics_0[_S400].fibre_size_0;
    var _S405 : f32 = 17.0f * fabrics_0[_S400].fibre_size_0;
    var _S406 : f32 = fade_0(_S403, _S405);
    var _S407 : vec2<f32> = _S401 / vec2<f32>(_S405);
    var _S408 : u32 = hash_key_0(select(u32(0), u32(1), _S402), ((fabrics_0[_S400].seed_0) ^ (u32(1013904242))));
    var _S409 : f32 = 1.0f / max(_S403, 0.07999999821186066f * fabrics_0[_S400].fibre_size_0);
    var _S410 : f32 = min(0.63999998569488525f * fabrics_0[_S400].fibre_size_0 * _S409, 1.0f);
    const _S411 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S411;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S406 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S412 : u32 = number_2 / u32(9);
        var _S413 : u32 = number_2 / u32(3) - u32(3) * _S412;
        var _S414 : vec2<f32> = floor(_S407) + vec2<f32>(f32(number_2 - u32(3) * _S413 - u32(9) * _S412), f32(_S413)) - vec2<f32>(1.0f);
        var _S415 : u32 = hash_bits_0(_S408 + _S412, u32(i32(_S414.x)) * u32(65536) + u32(i32(_S414.y)));
        var _S416 : u32 = hash_bits_0(_S408, _S415);
        var _S417 : vec2<f32> = _S407 - _S414 - vec2<f32>(share_of_0(_S415), share_of_0((_S415 >> (u32(10)))));
        var _S418 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S415 >> (u32(20)))));
        var _S419 : f32 = mix(5.0f, 16.0f, share_of_0((_S416 >> (u32(10))))) / 17.0f;
        var _S420 : f32 = _S417.x;
        var _S421 : f32 = _S418.y;
        var _S422 : f32 = _S417.y;
        var _S423 : f32 = _S418.x;
        var _S424 : f32 = (_S420 * _S421 + _S422 * _S423) / _S419;
        var _S425 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S416 >> (u32(20)))) - 1.0f);
        var _S426 : f32 = 2.0f * _S425 * _S424;
        var _S427 : f32 = rsqrt_0(_S426 * _S426 + 1.0f);
        var _S428 : f32 = (_S422 * _S421 - _S420 * _S423 - _S425 * _S419 * _S424 * _S424) * _S427 * 17.0f;
        var _S429 : f32 = clamp((0.31999999284744263f - abs(_S428)) * _S404 * _S409 + 0.5f, 0.0f, _S410);
        if((((((share_of_0(_S416)) < (families_0[select(fabrics_0[_S400].weft_0, fabrics_0[_S400].warp_0, ((((_S416 >> (u32(30)))) & (u32(1)))) == u32(1))].hairiness_0)) & (((abs(_S424)) < 1.0f)))) & ((_S429 > cover_2))))
        {
            var _S430 : vec2<f32> = vec2<f32>(- _S423 - _S426 * _S421, _S421 - _S426 * _S423) * vec2<f32>(_S427);
            cover_2 = _S429;
            hair_away_0 = _S428;
            hair_across_0 = _S430;
        }
        number_2 = number_2 + u32(1);
    }
    var _S431 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S406 * cover_2;
    hair_1.normal_1 = vec3<f32>(vec2<f32>(_S431) * hair_across_0, sqrt(1.0f - _S431 * _S431));
    hair_1.tangent_0 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S432 : u32,  _S433 : f32) -> bool
{
    return (((((fabrics_0[_S432].fibre_noise_0) > 0.0f) | (((fabrics_0[_S432].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S432].has_detail_0) != u32(0)) & ((_S433 >= 0.0f))))));
}

fn thread_number_0( _S434 : u32,  _S435 : SurfacePoint_0,  _S436 : f32,  _S437 : f32) -> u32
{
    var _S438 : u32 = select(fabrics_0[_S434].weft_0, fabrics_0[_S434].warp_0, _S435.is_warp_1);
    return u32(i32(floor((select(_S437, _S436, _S435.is_warp_1) - _S435.across_3) / families_0[_S438].period_0)) * i32(families_0[_S438].count_0) + i32(select(_S435.weft_thread_0, _S435.warp_thread_0, _S435.is_warp_1))) * u32(2) + select(u32(0), u32(1), _S435.is_warp_1);
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_1 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S439 : u32,  _S440 : u32,  _S441 : SurfacePoint_0,  _S442 : u32,  _S443 : f32) -> FibreNoise_0
{
    var _S444 : f32 = 5.0f * fabrics_0[_S439].fibre_size_0;
    var _S445 : vec2<f32> = wave_noise_0(hash_key_0(_S442, ((fabrics_0[_S439].seed_0) ^ (u32(458671337)))), _S441.fibre_along_0 / (25.0f * fabrics_0[_S439].fibre_size_0));
    var _S446 : f32 = _S441.fibre_across_0 + families_0[_S440].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S439].fibre_size_0 * _S445.x;
    var _S447 : vec3<f32> = fibre_cell_0(_S446, _S441.fibre_along_0, fabrics_0[_S439].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S442, ((fabrics_0[_S439].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S446, _S441.fibre_along_0, _S444));
    noise_0.bundle_weight_0 = fade_0(_S443, _S444);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S442, ((fabrics_0[_S439].seed_0) ^ (u32(48610963)))), _S447);
    noise_0.fibre_weight_0 = fade_0(_S443, fabrics_0[_S439].fibre_size_0);
    noise_0.offset_1 = _S447.z;
    noise_0.slope_2 = 0.5f * _S445.y;
    return noise_0;
}

fn detail_gain_0( _S448 : u32,  _S449 : u32,  _S450 : SurfacePoint_0,  _S451 : vec2<f32>,  _S452 : bool,  _S453 : u32,  _S454 : f32) -> vec2<f32>
{
    var _S455 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S449].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S454, 1.0f / families_0[_S449].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S449, _S450, _S452))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S455;
    }
    if((families_0[_S449].fibre_tone_0) > 0.0f)
    {
        var _S456 : FibreNoise_0 = fibre_noise_at_0(_S448, _S449, _S450, _S453, _S454);
        gain_2 = gain_2 + vec2<f32>(families_0[_S449].fibre_tone_0) * vec2<f32>(_S456.bundle_weight_0 * _S456.bundle_0.y + _S456.fibre_weight_0 * _S456.fibre_0.y, _S456.bundle_weight_0 + _S456.fibre_weight_0);
    }
    if((families_0[_S449].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.25f * families_0[_S449].slub_0 * fade_0(_S454, 1.0f / families_0[_S449].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S453, ((fabrics_0[_S448].seed_0) ^ (u32(1373058189)))), select(- _S451.x, _S451.y, _S450.is_warp_1) * families_0[_S449].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S450.across_3 * families_0[_S449].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S457 : u32,  _S458 : Albedos_0,  _S459 : u32,  _S460 : u32,  _S461 : vec2<f32>) -> Albedos_0
{
    var _S462 : vec3<f32> = max(_S458.specular_reflect_0, _S458.specular_transmit_0);
    var _S463 : vec3<f32> = _S458.diffuse_reflect_0 + _S458.diffuse_transmit_0;
    var _S464 : vec3<f32> = vec3<f32>(fabrics_0[_S457].layer_bound_0);
    var _S465 : vec3<f32> = vec3<f32>(1.0f);
    var _S466 : vec3<f32> = _S465 - _S464 * _S462;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S459, fabrics_0[_S457].colour_noise_0, fabrics_0[_S457].seed_0), _S463, _S466);
    var _S467 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S461.y, vec3<f32>(colour_1) * _S463, _S466) * _S461.x)));
    var _S468 : f32 = bounded_gain_0(fibre_gain_0(_S459, _S460, fabrics_0[_S457].fibre_noise_0, fabrics_0[_S457].seed_0), _S462, min((_S465 - _S467 * _S463) / _S464, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S467 * _S458.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S467 * _S458.diffuse_transmit_0;
    var _S469 : vec3<f32> = vec3<f32>(_S468);
    varied_0.specular_reflect_0 = _S469 * _S458.specular_reflect_0;
    varied_0.specular_transmit_0 = _S469 * _S458.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S470 : u32,  _S471 : SurfacePoint_0,  _S472 : Albedos_0,  _S473 : f32,  _S474 : f32,  _S475 : bool,  _S476 : f32,  _S477 : f32) -> Albedos_0
{
    var _S478 : u32 = thread_number_0(_S470, _S471, _S473, _S474);
    var _S479 : vec3<f32> = fibre_cell_0(_S471.fibre_across_0, _S471.fibre_along_0, fabrics_0[_S470].fibre_size_0);
    var _S480 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S470].has_detail_0) != u32(0)) & ((_S476 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S470, select(fabrics_0[_S470].weft_0, fabrics_0[_S470].warp_0, _S471.is_warp_1), _S471, vec2<f32>(_S473, _S474), _S475, _S478, _S476) * vec2<f32>(1.0f - _S477, 1.0f);
    }
    else
    {
        gain_3 = _S480;
    }
    return vary_albedos_0(_S470, _S472, _S478, u32(i32(_S479.x)) * u32(65536) + u32(i32(floor(_S479.y))), gain_3);
}

fn turned_frame_0( _S481 : u32,  _S482 : u32,  _S483 : SurfacePoint_0,  _S484 : bool,  _S485 : u32,  _S486 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_4 = _S483.normal_3;
    frame_2.tangent_3 = _S483.tangent_2;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S482].has_plies_0) > 0.0f)
    {
        var _S487 : f32 = fade_0(_S486, 1.0f / families_0[_S482].plies_per_mm_0);
        var _S488 : f32 = _S487 * 0.41999998688697815f * ply_offset_0(_S482, _S483, _S484);
        var _S489 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S490 : vec3<f32> = vec3<f32>(families_0[_S482].ply_cosine_0);
        var _S491 : vec3<f32> = vec3<f32>(select(families_0[_S482].ply_sine_0, - families_0[_S482].ply_sine_0, _S484));
        var _S492 : vec3<f32> = _S490 * _S489 + _S491 * frame_2.tangent_3;
        var _S493 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S488 * _S488));
        var _S494 : vec3<f32> = vec3<f32>(_S488);
        frame_2.tangent_3 = _S490 * (_S490 * frame_2.tangent_3 - _S491 * _S489) + _S491 * (_S493 * _S492 - _S494 * frame_2.normal_4);
        frame_2.normal_4 = _S493 * frame_2.normal_4 + _S494 * _S492;
        frame_2.loss_0 = _S487 * _S487 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S495 : f32 = families_0[_S482].fibre_tilt_0;
    if((families_0[_S482].fibre_tilt_0) > 0.0f)
    {
        var _S496 : FibreNoise_0 = fibre_noise_at_0(_S481, _S482, _S483, _S485, _S486);
        var _S497 : f32 = 1.09858846664428711f * _S495 * (_S496.bundle_weight_0 * _S496.bundle_0.x + _S496.fibre_weight_0 * (_S496.fibre_0.x + _S496.offset_1));
        var _S498 : f32 = _S495 * (1.42099642753601074f * (_S496.bundle_weight_0 * _S496.bundle_0.y + _S496.fibre_weight_0 * _S496.fibre_0.y) - _S496.bundle_weight_0 * _S496.slope_2);
        var _S499 : f32 = square_1(_S496.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S495 * _S495 * ((0.24761904776096344f * (square_1(_S496.bundle_weight_0) + _S499) + _S499 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S500 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S501 : vec2<f32> = sine_cosine_0(_S497);
        var _S502 : vec2<f32> = sine_cosine_0(_S498);
        var _S503 : vec3<f32> = vec3<f32>(_S501.y);
        var _S504 : vec3<f32> = vec3<f32>(_S501.x);
        var _S505 : vec3<f32> = _S503 * _S500 - _S504 * frame_2.normal_4;
        frame_2.normal_4 = _S503 * frame_2.normal_4 + _S504 * _S500;
        frame_2.tangent_3 = vec3<f32>(_S502.y) * frame_2.tangent_3 + vec3<f32>(_S502.x) * _S505;
    }
    return frame_2;
}

fn yarn_point_of_0( _S506 : u32,  _S507 : SurfacePoint_0,  _S508 : f32,  _S509 : f32,  _S510 : bool,  _S511 : bool,  _S512 : f32) -> YarnPoint_0
{
    var _S513 : u32 = select(fabrics_0[_S506].weft_0, fabrics_0[_S506].warp_0, _S507.is_warp_1);
    var _S514 : bool = (((fabrics_0[_S506].has_detail_0) != u32(0)) & ((_S512 >= 0.0f)));
    var _S515 : vec3<f32> = vec3<f32>(0.0f);
    var _S516 : Hair_0 = Hair_x24init_0(0.0f, _S515, _S515);
    var _S517 : bool;
    if(_S514)
    {
        _S517 = has_hairs_0(_S506);
    }
    else
    {
        _S517 = false;
    }
    var hair_2 : Hair_0;
    if(_S517)
    {
        hair_2 = hair_at_0(_S506, vec2<f32>(_S508, _S509), _S510, _S512);
    }
    else
    {
        hair_2 = _S516;
    }
    var albedos_3 : Albedos_0 = albedos_of_0(_S513, select(_S507.weft_thread_0, _S507.warp_thread_0, _S507.is_warp_1));
    var albedos_4 : Albedos_0;
    if(varies_at_0(_S506, _S512))
    {
        albedos_4 = varied_at_0(_S506, _S507, albedos_3, _S508, _S509, _S510, _S512, hair_2.cover_0);
    }
    else
    {
        albedos_4 = albedos_3;
    }
    var point_5 : YarnPoint_0;
    point_5.back_6 = _S510;
    point_5.hole_3 = _S511;
    point_5.is_warp_2 = _S507.is_warp_1;
    point_5.x_12 = _S508;
    point_5.y_5 = _S509;
    point_5.height_5 = _S507.height_4;
    point_5.normal_8 = _S507.normal_3;
    point_5.tangent_8 = _S507.tangent_2;
    point_5.surface_normal_0 = _S507.normal_3;
    point_5.diffuse_gain_1 = 1.0f;
    if(_S514)
    {
        var _S518 : YarnFrame_0 = turned_frame_0(_S506, _S513, _S507, _S510, thread_number_0(_S506, _S507, _S508, _S509), _S512);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S506))
        {
            frame_3 = under_hair_0(_S518, hair_2);
        }
        else
        {
            frame_3 = _S518;
        }
        point_5.normal_8 = frame_3.normal_4;
        point_5.tangent_8 = frame_3.tangent_3;
        point_5.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S506].diffuse_blend_0);
    }
    point_5.roughness_8 = families_0[_S513].roughness_0;
    point_5.albedos_2 = albedos_4;
    return point_5;
}

fn locate_yarn_0( _S519 : u32,  _S520 : SearchQuality_0,  _S521 : f32,  _S522 : f32,  _S523 : vec3<f32>,  _S524 : f32) -> YarnPoint_0
{
    var _S525 : bool = (_S523.z) < 0.0f;
    var _S526 : Hit_0 = first_hit_0(_S519, _S520, _S521, _S522, to_face_frame_0(_S523, _S525), _S525);
    return yarn_point_of_0(_S519, surface_at_0(_S519, _S526.x_13, _S526.y_6, _S525), _S526.x_13, _S526.y_6, _S525, _S526.hole_4, _S524);
}

fn openness_number_0( _S527 : u32,  _S528 : u32) -> f32
{
    return table_number_0(fabrics_0[_S527].openness_0 + _S528);
}

fn blocked_of_terms_0( _S529 : u32,  _S530 : u32,  _S531 : array<f32, i32(6)>,  _S532 : u32) -> Blocked_0
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
            if(term_0 < _S532)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S529, _S530 + share_3 * _S532 + term_0) * _S531[term_0];
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

fn blocked_at_0( _S533 : u32,  _S534 : bool,  _S535 : bool,  _S536 : f32,  _S537 : f32) -> Blocked_0
{
    var _S538 : f32 = _S537 * openness_number_0(_S533, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S536, _S538, _S536 * _S536, _S536 * _S538, _S538 * _S538 );
    return blocked_of_terms_0(_S533, u32(60) + (select(u32(0), u32(2), _S535) + select(u32(1), u32(0), _S534)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S539 : u32,  _S540 : Albedos_0,  _S541 : u32,  _S542 : vec3<f32>) -> Scattered_0
{
    var _S543 : u32 = u32(159) + u32(2) * _S541;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S542 * _S540.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S539, _S543)) * _S540.specular_reflect_0;
    yarn_3.through_0 = _S542 * _S540.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S539, _S543 + u32(1))) * _S540.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S544 : u32,  _S545 : u32,  _S546 : vec3<f32>,  _S547 : vec3<f32>,  _S548 : vec3<f32>,  _S549 : vec3<f32>,  _S550 : ptr<function, vec3<f32>>,  _S551 : ptr<function, vec3<f32>>)
{
    var _S552 : u32 = u32(146) + u32(4) * _S545;
    var _S553 : f32 = openness_number_0(_S544, _S552 + u32(1));
    var _S554 : f32 = openness_number_0(_S544, _S552 + u32(2));
    var _S555 : vec3<f32> = vec3<f32>(1.0f);
    var _S556 : vec3<f32> = _S555 - _S548 * vec3<f32>(openness_number_0(_S544, _S552));
    var _S557 : vec3<f32> = _S555 - _S549 * vec3<f32>(openness_number_0(_S544, _S552 + u32(3)));
    var _S558 : vec3<f32> = _S555 / (_S556 * _S557 - _S548 * _S549 * vec3<f32>((_S553 * _S554)));
    (*_S550) = (_S546 * _S557 + _S548 * vec3<f32>(_S553) * _S547) * _S558;
    (*_S551) = (_S547 * _S556 + _S549 * vec3<f32>(_S554) * _S546) * _S558;
    return;
}

fn face_sends_0( _S559 : u32,  _S560 : u32,  _S561 : Scattered_0,  _S562 : Scattered_0) -> FaceSends_0
{
    var _S563 : u32 = u32(2) * _S560;
    var _S564 : u32 = u32(142) + _S563;
    var _S565 : f32 = openness_number_0(_S559, _S564);
    var _S566 : f32 = openness_number_0(_S559, _S564 + u32(1));
    var _S567 : vec3<f32> = vec3<f32>((1.0f - _S565)) * _S561.back_5;
    var _S568 : vec3<f32> = vec3<f32>((1.0f - _S566)) * _S562.back_5;
    var sends_1 : FaceSends_0;
    var _S569 : u32 = u32(154) + _S563;
    var _S570 : f32 = openness_number_0(_S559, _S569);
    sends_1.blocks_warp_0 = _S570;
    var _S571 : f32 = openness_number_0(_S559, _S569 + u32(1));
    sends_1.blocks_weft_0 = _S571;
    sends_1.open_0 = _S570 * _S565 + _S571 * _S566;
    var _S572 : vec3<f32> = vec3<f32>(_S565) * _S561.back_5;
    var _S573 : vec3<f32> = vec3<f32>(_S566) * _S562.back_5;
    var _S574 : vec3<f32> = sends_1.sky_warp_0;
    var _S575 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S559, _S560, _S572, _S573, _S567, _S568, &(_S574), &(_S575));
    sends_1.sky_warp_0 = _S574;
    sends_1.sky_weft_0 = _S575;
    var _S576 : vec3<f32> = sends_1.crossing_warp_0;
    var _S577 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S559, _S560, _S561.through_0, _S562.through_0, _S567, _S568, &(_S576), &(_S577));
    sends_1.crossing_warp_0 = _S576;
    sends_1.crossing_weft_0 = _S577;
    return sends_1;
}

fn interior_of_0( _S578 : u32,  _S579 : vec3<f32>,  _S580 : bool) -> Interior_0
{
    var _S581 : Scattered_0 = scattered_by_0(_S578, table_albedos_0(families_0[fabrics_0[_S578].warp_0].colour_mean_0), u32(0), _S579);
    var _S582 : Scattered_0 = scattered_by_0(_S578, table_albedos_0(families_0[fabrics_0[_S578].weft_0].colour_mean_0), u32(1), _S579);
    var _S583 : FaceSends_0 = face_sends_0(_S578, select(u32(0), u32(1), _S580), _S581, _S582);
    var _S584 : FaceSends_0 = face_sends_0(_S578, select(u32(1), u32(0), _S580), _S581, _S582);
    var _S585 : vec3<f32> = vec3<f32>(_S583.blocks_warp_0);
    var _S586 : vec3<f32> = vec3<f32>(_S583.blocks_weft_0);
    var _S587 : vec3<f32> = _S585 * _S583.crossing_warp_0 + _S586 * _S583.crossing_weft_0;
    var _S588 : vec3<f32> = vec3<f32>(_S584.blocks_warp_0);
    var _S589 : vec3<f32> = vec3<f32>(_S584.blocks_weft_0);
    var _S590 : vec3<f32> = _S588 * _S584.crossing_warp_0 + _S589 * _S584.crossing_weft_0;
    var _S591 : f32 = 1.0f - _S583.open_0;
    var _S592 : f32 = 1.0f - _S584.open_0;
    var _S593 : vec3<f32> = vec3<f32>(1.0f);
    var _S594 : vec3<f32> = _S593 / (_S593 - _S587 * _S590 * vec3<f32>((_S591 * _S592)));
    var _S595 : vec3<f32> = _S590 * (vec3<f32>(_S583.open_0) + vec3<f32>(_S591) * (_S585 * _S583.sky_warp_0 + _S586 * _S583.sky_weft_0)) * _S594;
    var _S596 : vec3<f32> = _S587 * (vec3<f32>(_S584.open_0) + vec3<f32>(_S592) * (_S588 * _S584.sky_warp_0 + _S589 * _S584.sky_weft_0)) * _S594;
    var _S597 : FaceRadiance_0 = face_radiance_0(_S583, _S584.open_0, _S595, _S596);
    var _S598 : FaceRadiance_0 = face_radiance_0(_S584, _S583.open_0, _S596, _S595);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S597.warp_2;
    interior_1.weft_3 = _S597.weft_2;
    interior_1.leaked_1 = _S597.leaked_0;
    interior_1.far_1 = _S598.mean_0;
    interior_1.far_leaked_0 = _S598.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S599 : u32,  _S600 : YarnPoint_0,  _S601 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S602 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S602;
    nothing_0.transmitted_0 = _S602;
    if((((fabrics_0[_S599].openness_0) == u32(4294967295)) | ((_S600.hole_3))))
    {
        return nothing_0;
    }
    return bounced_by_0(blocked_at_0(_S599, _S600.is_warp_2, _S600.back_6, _S600.surface_normal_0.z, _S600.height_5), scattered_by_0(_S599, _S600.albedos_2, select(u32(1), u32(0), _S600.is_warp_2), _S601), interior_of_0(_S599, _S601, _S600.back_6));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S603 : u32,  _S604 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S603 * frame_record_0.height_0 + _S604.y) * frame_record_0.width_0 + _S604.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S605 : u32,  _S606 : u32) -> vec3<f32>
{
    var _S607 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S605 * frame_record_0.environment_columns_0 + _S606);
    return vec3<f32>(scene_number_0(_S607), scene_number_0(_S607 + u32(1)), scene_number_0(_S607 + u32(2)));
}

fn sample_environment_0( _S608 : vec2<f32>,  _S609 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S610 : u32 = frame_record_0.environment_rows_0;
    var _S611 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S608.y);
    var _S612 : u32 = frame_record_0.environment_columns_0;
    var _S613 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S611.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S608.x);
    var _S614 : vec3<f32> = environment_texel_0(_S611.index_6, _S613.index_6);
    (*_S609) = _S614 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S614), 9.99999968265522539e-21f)));
    var _S615 : f32 = 3.14159274101257324f / f32(_S610);
    var _S616 : f32 = mix(sine_cosine_0(f32(_S611.index_6) * _S615).y, sine_cosine_0(f32(_S611.index_6 + u32(1)) * _S615).y, _S611.remainder_0);
    var _S617 : f32 = sqrt(max(1.0f - _S616 * _S616, 0.0f));
    var _S618 : vec2<f32> = sine_cosine_0((f32(_S613.index_6) + _S613.remainder_0) * (6.28318548202514648f / f32(_S612)));
    var _S619 : f32 = _S617 * _S618.x;
    var _S620 : f32 = - _S617 * _S618.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S619 + frame_record_0.environment_sine_0 * _S620, _S616, frame_record_0.environment_cosine_0 * _S620 - frame_record_0.environment_sine_0 * _S619);
}

fn light_sample_0( _S621 : u32,  _S622 : vec2<u32>,  _S623 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S624 : u32 = frame_record_0.lights_0;
    if(_S621 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S625 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S622, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S621 - _S624), u32(3)), &(weight_0));
        sample_1.towards_0 = _S625;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S626 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S621);
    sample_1.irradiance_1 = vec3<f32>(_S626.red_0, _S626.green_0, _S626.blue_0);
    sample_1.towards_0 = vec3<f32>(_S626.x_8, _S626.y_1, _S626.z_1);
    if((_S626.is_point_0) != u32(0))
    {
        var _S627 : vec3<f32> = sample_1.towards_0 - _S623;
        var _S628 : f32 = max(square_0(_S627), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S628);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S628);
        sample_1.towards_0 = normalize(_S627);
    }
    return sample_1;
}

fn scattered_0( _S629 : u32,  _S630 : YarnPoint_0,  _S631 : vec3<f32>,  _S632 : vec3<f32>) -> vec3<f32>
{
    var _S633 : vec3<f32> = vec3<f32>(0.0f);
    var _S634 : bool = !_S630.hole_3;
    var _S635 : f32 = _S631.z;
    var value_1 : vec3<f32>;
    if((_S634 & ((_S635 > 0.0f))))
    {
        value_1 = _S630.albedos_2.diffuse_reflect_0 * vec3<f32>(_S630.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0(_S631, _S630.normal_8, fabrics_0[_S629].diffuse_blend_0)) + _S630.albedos_2.specular_reflect_0 * vec3<f32>(reflection_0(_S631, _S632, _S630.normal_8, _S630.tangent_8, _S630.roughness_8, fabrics_0[_S629].optical_depth_0));
    }
    else
    {
        if((_S634 & ((_S635 < 0.0f))))
        {
            value_1 = _S630.albedos_2.diffuse_transmit_0 * vec3<f32>(_S630.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S631), _S630.normal_8, fabrics_0[_S629].diffuse_blend_0)) + _S630.albedos_2.specular_transmit_0 * vec3<f32>(transmission_1(_S631, _S632, _S630.normal_8, _S630.tangent_8, _S630.roughness_8, fabrics_0[_S629].optical_depth_0));
        }
        else
        {
            value_1 = _S633;
        }
    }
    var _S636 : f32 = fabrics_0[_S629].sheen_strength_0;
    if((fabrics_0[_S629].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S637 : vec2<f32> = sheen_with_transmittance_0(_S631, _S632, _S636, fabrics_0[_S629].sheen_roughness_0);
    return vec3<f32>(_S637.y) * value_1 + vec3<f32>(_S637.x);
}

fn unoccluded_0( _S638 : u32,  _S639 : SearchQuality_0,  _S640 : f32,  _S641 : f32,  _S642 : f32,  _S643 : vec3<f32>,  _S644 : bool) -> bool
{
    if((_S643.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S638, _S639, vec3<f32>(_S640, _S641, _S642 + fabrics_0[_S638].lift_0), _S643, _S644, max_height_along_0(_S638, _S640, _S641, _S642, _S643, _S644));
}

fn is_lit_0( _S645 : u32,  _S646 : SearchQuality_0,  _S647 : YarnPoint_0,  _S648 : vec3<f32>) -> bool
{
    if(_S647.hole_3)
    {
        return true;
    }
    var _S649 : vec3<f32> = to_face_frame_0(_S648, _S647.back_6);
    var _S650 : f32 = _S649.z;
    var _S651 : bool = _S650 < 0.0f;
    var normal_9 : vec3<f32>;
    var height_11 : f32;
    if(_S651)
    {
        var _S652 : SurfacePoint_0 = surface_at_0(_S645, _S647.x_12, _S647.y_5, !_S647.back_6);
        normal_9 = _S652.normal_3;
        height_11 = _S652.height_4;
    }
    else
    {
        normal_9 = _S647.surface_normal_0;
        height_11 = _S647.height_5;
    }
    var _S653 : vec3<f32> = vec3<f32>(_S649.xy, abs(_S650));
    if((dot(normal_9, _S653)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S645, _S646, _S647.x_12, _S647.y_5, height_11, _S653, (_S647.back_6) != _S651);
}

fn evaluate_with_0( _S654 : u32,  _S655 : SearchQuality_0,  _S656 : YarnPoint_0,  _S657 : Bounced_0,  _S658 : vec3<f32>,  _S659 : vec3<f32>) -> vec3<f32>
{
    var _S660 : vec3<f32> = to_face_frame_0(_S659, _S656.back_6);
    var _S661 : vec3<f32> = scattered_0(_S654, _S656, to_face_frame_0(_S658, _S656.back_6), _S660);
    var _S662 : bool;
    if((max(_S661.x, max(_S661.y, _S661.z))) <= 0.0f)
    {
        _S662 = true;
    }
    else
    {
        _S662 = !is_lit_0(_S654, _S655, _S656, _S658);
    }
    var value_2 : vec3<f32>;
    if(_S662)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S661;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S657, _S658, _S659);
    var _S663 : f32 = fabrics_0[_S654].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S654].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S663 * sheen_lobe_0(abs(_S660.z), fabrics_0[_S654].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S664 : u32,  _S665 : YarnPoint_0,  _S666 : vec3<f32>) -> f32
{
    if(!_S665.hole_3)
    {
        return 0.0f;
    }
    var _S667 : f32 = fabrics_0[_S664].sheen_strength_0;
    if((fabrics_0[_S664].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S667 * sheen_lobe_0(abs(_S666.z), fabrics_0[_S664].sheen_roughness_0).z;
}

fn light_of_point_0( _S668 : u32,  _S669 : VisiblePoint_0,  _S670 : vec2<u32>,  _S671 : vec3<f32>,  _S672 : vec2<f32>) -> vec4<f32>
{
    var _S673 : SearchQuality_0 = default_quality_0();
    var _S674 : vec3<f32> = to_local_0(_S669, _S669.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S672;
    footprint_0.dx_0 = _S669.draft_dx_0;
    footprint_0.dy_0 = _S669.draft_dy_0;
    var _S675 : YarnPoint_0 = locate_yarn_0(_S668, _S673, _S672.x, _S672.y, _S674, Footprint_spread_side_0(footprint_0));
    var point_6 : YarnPoint_0 = _S675;
    var _S676 : Bounced_0 = bounced_at_0(_S668, _S675, _S671);
    point_6.albedos_2 = tinted_0(point_6.albedos_2, _S671);
    var _S677 : vec3<f32> = vec3<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S677;
    for(;;)
    {
        if(number_3 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S678 : f32 = visibility_at_0(number_3, _S670);
        if(_S678 <= 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S679 : LightSample_0 = light_sample_0(number_3, _S670, _S669.position_0);
        radiance_1 = radiance_1 + vec3<f32>(_S678) * _S679.irradiance_1 * evaluate_with_0(_S668, _S673, point_6, _S676, to_local_0(_S669, _S679.towards_0), _S674);
        number_3 = number_3 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S668, point_6, _S674));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S680 : u32 = id_0.x;
    var _S681 : bool;
    if(_S680 >= (frame_record_0.width_0))
    {
        _S681 = true;
    }
    else
    {
        _S681 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S681)
    {
        return;
    }
    var _S682 : vec2<u32> = id_0.xy;
    var _S683 : u32 = id_0.y * frame_record_0.width_0 + _S680;
    var _S684 : u32 = layers_0[_S683].face_0;
    if((layers_0[_S683].face_0) == u32(0))
    {
        return;
    }
    var _S685 : u32 = _S684 - u32(1);
    var _S686 : u32 = fabric_of_0(_S685);
    var _S687 : VisiblePoint_0 = visible_point_0(_S686, _S685, _S682);
    var _S688 : vec3<f32> = filtered_albedo_0(_S686, _S687);
    var _S689 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S689;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S690 : vec2<f32> = pixel_sequence_0(_S682, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S686, _S687, _S682, _S688, _S687.draft_0 + vec2<f32>(_S690.x) * _S687.draft_dx_0 + vec2<f32>(_S690.y) * _S687.draft_dy_0);
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S683, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

