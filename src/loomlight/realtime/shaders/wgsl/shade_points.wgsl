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
    var exponent_0 : f32 = f32(i32((_S1 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S1 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S2 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S2 - exponent_1 * 0.00021219444170129f - 0.5f * _S2) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S3 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S4 : f32 = floor(_S3 * 1.4426950216293335f + 0.5f);
    var _S5 : f32 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f) * _S5 * _S5 + _S5 + 1.0f) * (bitcast<f32>(((u32(i32(_S4) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S6 : u32 = scene_words_0[index_0];
    var _S7 : vec3<f32> = vec3<f32>(f32((_S6 & (u32(1023)))), f32((((_S6 >> (u32(10)))) & (u32(1023)))), f32((_S6 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S7 * _S7;
}

fn map_level_0( first_1 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S8 : f32 = uv_0.x;
    var _S9 : f32 = f32(side_0);
    var _S10 : f32 = (_S8 - floor(_S8)) * _S9 - 0.5f;
    var _S11 : f32 = uv_0.y;
    var _S12 : f32 = (_S11 - floor(_S11)) * _S9 - 0.5f;
    var _S13 : f32 = floor(_S10);
    var _S14 : i32 = i32(side_0);
    var _S15 : u32 = side_0 - u32(1);
    var _S16 : u32 = (u32(i32(_S13) + _S14) & (_S15));
    var _S17 : f32 = floor(_S12);
    var _S18 : u32 = (u32(i32(_S17) + _S14) & (_S15));
    var _S19 : u32 = ((_S16 + u32(1)) & (_S15));
    var _S20 : u32 = first_1 + _S18 * side_0;
    var _S21 : vec3<f32> = vec3<f32>((_S10 - _S13));
    var _S22 : u32 = first_1 + (((_S18 + u32(1)) & (_S15))) * side_0;
    return mix(mix(map_texel_0(_S20 + _S16), map_texel_0(_S20 + _S19), _S21), mix(map_texel_0(_S22 + _S16), map_texel_0(_S22 + _S19), _S21), vec3<f32>((_S12 - _S17)));
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S23 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S24 : u32 = ((((_S23 >> ((((_S23 >> (u32(28)))) + u32(4))))) ^ (_S23))) * u32(277803737);
    return (((_S24 >> (u32(22)))) ^ (_S24));
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
    var _S25 : u32 = pixel_0.x;
    var _S26 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S25, _S26, stream_2), uniform_hash_0(_S25, _S26, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
    var _S27 : vec2<f32> = this_0.dx_0;
    var _S28 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S27, _S27) + dot(_S28, _S28)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S29 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S29, - _S29, back_2));
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S30 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S30, fma(- _S30, families_0[family_0].count_0, index_2));
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
    var _S31 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S32 : f32 = fma(- _S31, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S32;
    cell_2.above_0 = families_0[family_1].size_0 - _S32;
    cell_2.across_0 = _S32 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S31).y, 0.0f, families_0[family_1].count_0 - 1.0f));
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
    var _S33 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S34 : u32 = min(thread_3 + select(u32(0), u32(1), _S33 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S35 : u32 = families_0[family_2].place_table_0 + _S34 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S34;
    cell_3.below_0 = _S33 - table_number_0(_S35);
    cell_3.above_0 = table_number_0(_S35 + u32(1)) - _S33;
    cell_3.across_0 = _S33 - table_number_0(_S35 + u32(2));
    cell_3.half_width_1 = table_number_0(_S35 + u32(3));
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
    var _S36 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var shown_0 : Shown_0;
    var _S37 : bool = !((abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1));
    var _S38 : bool = (_S36 & (((_S37 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_0 = _S38;
    shown_0.hole_0 = ((!_S36) & (_S37));
    var _S39 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S38);
    shown_0.word_0 = _S39;
    shown_0.on_top_0 = (((_S39 & (u32(1)))) == u32(1)) != back_3;
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
    var _S40 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S40.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S40.y) * u32(4)));
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
    var _S41 : u32 = families_0[family_6].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S41);
    bend_0.half_tangent_0 = table_number_0(_S41 + u32(1));
    bend_0.arc_0 = table_number_0(_S41 + u32(2));
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
    var _S42 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S43 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S44 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S45 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S46 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S46;
    var _S47 : i32 = - _S42;
    var _S48 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S47, i32(0));
    run_0.from_start_0 = _S48;
    var _S49 : i32 = _S43 + i32(1);
    var _S50 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S49);
    run_0.to_end_0 = _S50;
    var _S51 : bool = _S48 < _S50;
    run_0.near_start_0 = _S51;
    var _S52 : i32 = select(_S49, _S47 - _S44, _S51);
    var _S53 : i32 = select(_S49 + _S45, _S47, _S51);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S48, _S50), 1.0e+06f, _S46);
    run_0.reach_0 = min(0.5f * (_S48 + _S50), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S52, _S53), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S42 == i32(0);
    run_0.last_crossing_0 = _S43 == i32(0);
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
    var _S54 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S55 : f32 = clamp(cell_5.across_0, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_1 = _S55;
    var _S56 : f32 = _S54 * _S54 - square_1(_S55);
    var _S57 : f32 = rsqrt_0(_S56);
    section_0.drop_0 = _S54 - _S56 * _S57;
    section_0.slope_0 = - _S55 * _S57;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S58 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S59 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S60 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S58) - crossed_1.half_width_1;
    var _S61 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S58);
    var _S62 : f32;
    if(shown_1.on_top_0)
    {
        _S62 = 0.0f;
    }
    else
    {
        _S62 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S63 : f32;
    if((shown_1.on_top_0) != _S61)
    {
        _S63 = 0.0f;
    }
    else
    {
        _S63 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S58));
    }
    var _S64 : f32 = 1.0f / max(2.0f * _S60, 9.999999960041972e-13f);
    var _S65 : f32 = clamp((_S60 - _S59) * _S64, 0.0f, 1.0f);
    return vec2<f32>(_S62 + (_S63 - _S62) * (_S65 * _S65 * (3.0f - 2.0f * _S65)), (_S62 - _S63) * (6.0f * _S65 * (1.0f - _S65) * _S64) * select(-1.0f, 1.0f, _S58));
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
    var _S66 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S66), 9.99999971718068537e-10f);
    var _S67 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S67), 9.99999971718068537e-10f);
    control_0.right_0 = _S66 > 0.0f;
    control_0.up_0 = _S67 > 0.0f;
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
    var _S68 : f32 = select(- cell_6.across_0, cell_6.across_0, forwards_0);
    var _S69 : f32 = select(cell_6.below_0, cell_6.above_0, forwards_0);
    var _S70 : f32 = - cell_6.half_width_1;
    var _S71 : bool = _S68 < _S70;
    var _S72 : bool = _S68 >= (cell_6.half_width_1);
    var _S73 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_0)));
    var _S74 : f32 = select(cell_6.half_width_1, _S70, _S71) - _S68;
    var _S75 : f32 = select(_S69, 2.0f * _S69 + _S68 - cell_6.half_width_1, ((shown_2.hole_0) | (((_S73 & ((!shown_2.on_top_0)))))));
    if((((_S73 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S71)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S74, _S75, _S72);
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
    var _S76 : f32 = previous_1.rate_0 * step_4;
    var _S77 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_1)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S76) >= 0.0f) & (((3.0f * clearance_1 - _S77) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S78 : f32 = clearance_1 - previous_1.clearance_0;
    var _S79 : f32 = 6.0f * _S78 - 4.0f * _S76 - 2.0f * _S77;
    var _S80 : f32 = -2.0f * _S76 / max(_S79 + sqrt(max(_S79 * _S79 - 4.0f * (3.0f * (_S76 + _S77 - 2.0f * _S78)) * _S76, 0.0f)), 9.99999968265522539e-21f);
    var _S81 : f32 = 1.0f - _S80;
    return select(-1.0f, _S81 * step_4, ((((_S80 > 0.01999999955296516f) & ((_S81 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S80 + 1.0f) + _S76 * _S80) * _S81 * _S81 + (clearance_1 * (2.0f * _S81 + 1.0f) - _S77 * _S81) * _S80 * _S80) < 0.0f))));
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
    var _S82 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S82, 0.0f) + this_2.epsilon_0, _S82 - this_2.epsilon_0, ((((!here_2.hole_1) & (((rate_3 * _S82 + clearance_3) < 0.0f)))) & ((_S82 > (2.0f * this_2.epsilon_0))))));
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
    var _S83 : f32 = end_0 - start_1;
    var _S84 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S83;
    var _S85 : f32 = 3.0f * _S83 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S83, 9.99999968265522539e-21f);
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
        var _S86 : f32 = clamp(share_1 - (((_S84 * share_1 + _S85) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S84 * share_1 + 2.0f * _S85) * share_1 + start_rate_0, 0.10000000149011612f * _S83 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S87 : i32 = i_0 + i32(1);
        share_1 = _S86;
        i_0 = _S87;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S88 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S89 : f32 = rsqrt_0(_S88);
    var _S90 : f32 = sine_1 * _S89 * rsqrt_0(_S88 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S90 * _S88, _S90 * across_slope_0 * along_slope_0 + cosine_0 * _S89);
}

fn arc_sine_0( x_6 : f32) -> f32
{
    var _S91 : f32 = abs(x_6);
    var _S92 : bool = _S91 > 0.5f;
    var _S93 : f32 = select(_S91 * _S91, 0.5f * (1.0f - _S91), _S92);
    var _S94 : f32 = select(_S91, sqrt(max(_S93, 0.0f)), _S92);
    var _S95 : f32 = ((((0.04216320067644119f * _S93 + 0.02418131195008755f) * _S93 + 0.04547002539038658f) * _S93 + 0.07495300471782684f) * _S93 + 0.16666752099990845f) * _S93 * _S94 + _S94;
    var _S96 : f32 = select(_S95, 1.57079637050628662f - 2.0f * _S95, _S92);
    return select(_S96, - _S96, x_6 < 0.0f);
}

struct Hair_0
{
     cover_0 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>) -> Hair_0
{
    var _S97 : Hair_0;
    _S97.cover_0 = cover_1;
    _S97.normal_1 = normal_2;
    _S97.tangent_0 = tangent_1;
    return _S97;
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
    var _S98 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S99 : f32 = x_7 - _S98 * 1.5703125f - _S98 * 0.00048375129699707f - _S98 * 7.54979012640433211e-08f;
    var _S100 : f32 = _S99 * _S99;
    var _S101 : f32 = ((-0.00019515295571182f * _S100 + 0.00833216123282909f) * _S100 - 0.16666655242443085f) * _S100 * _S99 + _S99;
    var _S102 : f32 = ((0.00002443315679557f * _S100 - 0.00138873164542019f) * _S100 + 0.04166664555668831f) * _S100 * _S100 - 0.5f * _S100 + 1.0f;
    var _S103 : u32 = (u32(i32(_S98)) & (u32(3)));
    var _S104 : vec2<f32> = select_vector_1(((_S103 & (u32(1)))) != u32(0), vec2<f32>(_S102, _S101), vec2<f32>(_S101, _S102));
    var _S105 : f32 = _S104.x;
    var _S106 : f32 = _S104.y;
    return vec2<f32>(select(_S105, - _S105, ((_S103 & (u32(2)))) != u32(0)), select(_S106, - _S106, (((_S103 + u32(1)) & (u32(2)))) != u32(0)));
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
    var _S107 : f32 = floor(across_2 / width_2);
    return vec3<f32>(_S107, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S107, 2.0f * (across_2 / width_2 - _S107) - 1.0f);
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
};

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S108 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S108 - floor(_S108)) - 1.0f;
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
    var _S109 : f32 = floor(position_4);
    var _S110 : f32 = position_4 - _S109;
    var _S111 : u32 = u32(i32(_S109));
    var _S112 : f32 = signed_noise_0(hash_bits_0(key_1, _S111));
    var _S113 : f32 = signed_noise_0(hash_bits_0(key_1, _S111 + u32(1)));
    return vec2<f32>(mix(_S112, _S113, smooth_share_0(_S110)), 6.0f * _S110 * (1.0f - _S110) * (_S113 - _S112));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S114 : f32 = cell_7.y;
    var _S115 : f32 = floor(_S114);
    var _S116 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S115));
    var _S117 : u32 = hash_bits_0(key_2, _S116);
    var _S118 : u32 = hash_bits_0(key_2, _S116 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S117), signed_noise_0((_S117 >> (u32(16))))), vec2<f32>(signed_noise_0(_S118), signed_noise_0((_S118 >> (u32(16))))), vec2<f32>(smooth_share_0(_S114 - _S115)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S119 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S119.x, _S119.y), _S119.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S120 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S120.x, _S120.y), _S120.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
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
    var _S121 : vec3<f32> = select_vector_0((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_0), hair_0.tangent_0);
    var blended_0 : YarnFrame_0;
    var _S122 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S123 : vec3<f32> = normalize(mix(frame_0.normal_4, hair_0.normal_1, _S122));
    blended_0.normal_4 = _S123;
    var _S124 : vec3<f32> = mix(frame_0.tangent_3, _S121, _S122);
    var _S125 : vec3<f32> = _S124 - vec3<f32>(dot(_S124, _S123)) * _S123;
    blended_0.tangent_3 = _S125 * vec3<f32>(rsqrt_0(max(dot(_S125, _S125), 9.999999960041972e-13f)));
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
    var _S126 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S127 : vec3<f32> = sends_0.sky_warp_0 + _S126 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S127;
    var _S128 : vec3<f32> = sends_0.sky_weft_0 + _S126 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S128;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S127 + vec3<f32>(sends_0.blocks_weft_0) * _S128;
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
    var _S129 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S130 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S130 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S130 * interior_0.far_1 + yarn_2.back_5 * _S129;
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
        var _S131 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S131)) <= number_0)
        {
            low_0 = _S131;
        }
        else
        {
            high_0 = _S131;
        }
    }
    var _S132 : u32 = table_0 + low_0;
    var _S133 : f32 = scene_number_0(_S132);
    var _S134 : f32 = scene_number_0(_S132 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S133) / max(_S134 - _S133, 9.999999960041972e-13f));
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
    var _S135 : f32 = light_1.z;
    if(_S135 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S135, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S136 : f32 = dot(direction_3, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S136 * _S136 + 1.0f, roughness_1 * roughness_1));
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
    var _S137 : f32 = roughness_2 * roughness_2;
    var _S138 : f32 = squared_along_0 * (1.0f - _S137) + _S137;
    return 0.31830987334251404f * _S137 * roughness_2 / (_S138 * _S138);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S139 : vec3<f32> = light_2 + view_1;
    var _S140 : f32 = dot(_S139, tangent_5);
    return flake_density_0(min(_S140 * _S140 / max(square_0(_S139), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S141 : f32 = dot(light_3, normal_6);
    var _S142 : f32 = dot(view_2, normal_6);
    if(((_S141 <= 0.0f) | ((_S142 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S143 : f32 = max(_S141, 9.99999997475242708e-07f);
    var _S144 : f32 = max(_S142, 9.99999997475242708e-07f);
    var _S145 : f32 = projected_area_1(light_3, tangent_6, roughness_4) * _S144 + projected_area_1(view_2, tangent_6, roughness_4) * _S143;
    var _S146 : f32 = optical_depth_1 * _S145 / (_S143 * _S144);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S146 * mean_attenuation_0(_S146)) * _S143 / _S145;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S147 : f32 = - dot(light_4, normal_7);
    var _S148 : f32 = dot(view_3, normal_7);
    if(((_S147 <= 0.0f) | ((_S148 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S149 : f32 = 1.0f / max(_S148, 9.99999997475242708e-07f);
    var _S150 : f32 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S147, 9.99999997475242708e-07f);
    var _S151 : f32 = projected_area_1(view_3, tangent_7, roughness_5) * _S149;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S150, _S151)) * mean_attenuation_0(optical_depth_2 * abs(_S150 - _S151)) * _S149;
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
    var _S152 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S153 : f32 = 2.0f * sqrt(_S152) - 1.0f;
    var _S154 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S153, _S154), 0.00999999977648258f, 1.0f), clamp((1.0f - _S152) * sheen_shear_0(_S153, _S154), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S153, _S154), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S155 : f32 = light_5.z;
    if(((_S155 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S156 : vec2<f32> = view_4.xy;
    var _S157 : f32 = dot(_S156, _S156);
    var _S158 : vec2<f32> = select_vector_1(_S157 > 9.99999968265522539e-21f, _S156 * vec2<f32>(rsqrt_0(max(_S157, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S159 : f32 = scale_0 * dot(light_5.xy, _S158) + shear_0 * _S155;
    var _S160 : f32 = scale_0 * (light_5.y * _S158.x - light_5.x * _S158.y);
    var _S161 : f32 = _S159 * _S159 + _S160 * _S160 + _S155 * _S155;
    return 0.31830987334251404f * scale_0 * scale_0 * _S155 / max(_S161 * _S161, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S162 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S163 : f32 = strength_0 * _S162.z;
    return vec2<f32>(_S163 * transformed_cosine_0(light_6, view_5, _S162.x, _S162.y), 1.0f - _S163);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S164 : f32 = light_7.z;
    return select_vector_0((_S164 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S164) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S165 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S165 * (1.0f - light_8.w);
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

fn face_point_0( _S166 : u32,  _S167 : u32,  _S168 : f32,  _S169 : f32) -> VisiblePoint_0
{
    var _S170 : u32 = u32(3) * _S167;
    var _S171 : Vertex_0 = vertex_at_0(_S170);
    var _S172 : Vertex_0 = vertex_at_0(_S170 + u32(1));
    var _S173 : Vertex_0 = vertex_at_0(_S170 + u32(2));
    var _S174 : vec3<f32> = position_of_0(_S171);
    var _S175 : vec3<f32> = position_of_0(_S172) - _S174;
    var _S176 : vec3<f32> = position_of_0(_S173) - _S174;
    var _S177 : f32 = _S172.u_0 - _S171.u_0;
    var _S178 : f32 = _S172.v_0 - _S171.v_0;
    var _S179 : vec2<f32> = vec2<f32>(_S177, _S178);
    var _S180 : f32 = _S173.u_0 - _S171.u_0;
    var _S181 : f32 = _S173.v_0 - _S171.v_0;
    var _S182 : vec2<f32> = vec2<f32>(_S180, _S181);
    var _S183 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S177 * _S181 - _S178 * _S180) < 0.0f));
    var _S184 : vec3<f32> = _S183 * (vec3<f32>(_S181) * _S175 - vec3<f32>(_S178) * _S176);
    var _S185 : vec3<f32> = _S183 * (vec3<f32>(_S177) * _S176 - vec3<f32>(_S180) * _S175);
    var point_2 : VisiblePoint_0;
    var _S186 : vec3<f32> = vec3<f32>(_S168);
    var _S187 : vec3<f32> = vec3<f32>(_S169);
    var _S188 : vec3<f32> = normalize(vec3<f32>((1.0f - _S168 - _S169)) * normal_of_0(_S171) + _S186 * normal_of_0(_S172) + _S187 * normal_of_0(_S173));
    point_2.normal_0 = _S188;
    var _S189 : vec3<f32> = normalize(_S184 - _S188 * vec3<f32>(dot(_S188, _S184)));
    point_2.axis_x_0 = _S189;
    point_2.axis_y_0 = cross(_S188, _S189);
    var _S190 : vec3<f32> = normalize(cross(_S175, _S176));
    point_2.face_normal_0 = select_vector_0((dot(_S190, _S188)) < 0.0f, (vec3<f32>(0) - _S190), _S190);
    point_2.position_0 = _S174 + _S186 * _S175 + _S187 * _S176;
    point_2.view_0 = _S188;
    var _S191 : vec2<f32> = vec2<f32>(_S171.u_0, _S171.v_0) + vec2<f32>(_S168) * _S179 + vec2<f32>(_S169) * _S182;
    point_2.uv_1 = _S191;
    var _S192 : bool = (dot(cross(_S184, _S185), _S188)) < 0.0f;
    var _S193 : vec2<f32> = vec2<f32>(fabrics_0[_S166].uv_width_0, select(fabrics_0[_S166].uv_height_0, - fabrics_0[_S166].uv_height_0, _S192));
    point_2.draft_per_uv_0 = _S193;
    point_2.draft_0 = _S191 * _S193 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S166].uv_height_0, _S192));
    var _S194 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S194;
    point_2.draft_dy_0 = _S194;
    return point_2;
}

fn visible_point_0( _S195 : u32,  _S196 : u32,  _S197 : vec2<u32>) -> VisiblePoint_0
{
    var _S198 : u32 = u32(3) * _S196;
    var _S199 : Vertex_0 = vertex_at_0(_S198);
    var _S200 : Vertex_0 = vertex_at_0(_S198 + u32(1));
    var _S201 : Vertex_0 = vertex_at_0(_S198 + u32(2));
    var _S202 : vec3<f32> = position_of_0(_S199);
    var _S203 : vec3<f32> = position_of_0(_S200) - _S202;
    var _S204 : vec3<f32> = position_of_0(_S201) - _S202;
    var _S205 : vec3<f32> = cross(_S203, _S204);
    var _S206 : f32 = f32(frame_record_0.width_0);
    var _S207 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S206));
    var _S208 : f32 = f32(frame_record_0.height_0);
    var _S209 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S208));
    var _S210 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S197.x) + 0.5f - 0.5f * _S206)) * _S207 + vec3<f32>((f32(_S197.y) + 0.5f - 0.5f * _S208)) * _S209;
    var _S211 : f32 = dot(_S210, _S205);
    var _S212 : f32 = 1.0f / select(1.00000000317107685e-30f, _S211, (abs(_S211)) > 1.00000000317107685e-30f);
    var _S213 : vec3<f32> = _S202 - camera_origin_0();
    var _S214 : vec3<f32> = vec3<f32>((dot(_S213, _S205) * _S212));
    var _S215 : vec3<f32> = _S210 * _S214 - _S213;
    var _S216 : vec3<f32> = _S214 * (_S207 - _S210 * vec3<f32>((dot(_S207, _S205) * _S212)));
    var _S217 : vec3<f32> = _S214 * (_S209 - _S210 * vec3<f32>((dot(_S209, _S205) * _S212)));
    var _S218 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S205), 1.00000000317107685e-30f)));
    var _S219 : vec3<f32> = cross(_S204, _S205) * _S218;
    var _S220 : vec3<f32> = cross(_S205, _S203) * _S218;
    var _S221 : vec2<f32> = vec2<f32>(_S200.u_0 - _S199.u_0, _S200.v_0 - _S199.v_0);
    var _S222 : vec2<f32> = vec2<f32>(_S201.u_0 - _S199.u_0, _S201.v_0 - _S199.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S195, _S196, dot(_S215, _S219), dot(_S215, _S220));
    point_3.position_0 = _S202 + _S215;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S210));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S216, _S219)) * _S221 + vec2<f32>(dot(_S216, _S220)) * _S222) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S217, _S219)) * _S221 + vec2<f32>(dot(_S217, _S220)) * _S222) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S223 : u32,  _S224 : VisiblePoint_0) -> vec3<f32>
{
    var _S225 : u32 = fabrics_0[_S223].albedo_map_levels_0;
    if((fabrics_0[_S223].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S226 : vec2<f32> = vec2<f32>(fabrics_0[_S223].uv_width_0, fabrics_0[_S223].uv_height_0);
    var _S227 : vec2<f32> = _S224.draft_dx_0 / _S226;
    var _S228 : vec2<f32> = _S224.draft_dy_0 / _S226;
    var _S229 : u32 = _S225 - u32(1);
    var _S230 : u32 = (u32(1) << (_S229));
    var _S231 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S227.x * _S228.y - _S227.y * _S228.x), 9.99999968265522539e-21f) * (square_1(f32(_S230)) / 3.0f)), 0.0f, f32(_S225) - 1.0f);
    var _S232 : u32 = min(u32(_S231), max(_S225, u32(2)) - u32(2));
    var _S233 : u32 = min(_S232 + u32(1), _S229);
    var _S234 : u32 = (u32(1) << ((u32(2) * _S225)));
    return mix(map_level_0(fabrics_0[_S223].albedo_map_0 + (_S234 - ((_S234 >> ((u32(2) * _S232))))) / u32(3), (_S230 >> (_S232)), _S224.uv_1), map_level_0(fabrics_0[_S223].albedo_map_0 + (_S234 - ((_S234 >> ((u32(2) * _S233))))) / u32(3), (_S230 >> (_S233)), _S224.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S231 - f32(_S232))) - 1.0f) / 3.0f)));
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

fn crossing_at_0( _S235 : u32,  _S236 : f32,  _S237 : f32,  _S238 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S235].warp_0, _S236);
    crossing_2.weft_1 = locate_0(fabrics_0[_S235].weft_0, _S237);
    var _S239 : u32 = fabrics_0[_S235].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S235].ends_1 + crossing_2.warp_1.thread_2);
    var _S240 : u32 = words_0[_S239];
    crossing_2.warp_word_0 = _S240;
    crossing_2.weft_word_0 = words_0[_S239 + u32(1)];
    crossing_2.warp_above_0 = (((_S240 & (u32(1)))) == u32(1)) != _S238;
    return crossing_2;
}

fn sample_at_0( _S241 : u32,  _S242 : f32,  _S243 : f32,  _S244 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S245 : Crossing_0 = crossing_at_0(_S241, _S242, _S243, _S244);
    sample_0.crossing_1 = _S245;
    var _S246 : Shown_0 = shown_at_0(_S245, _S244);
    sample_0.shown_3 = _S246;
    var _S247 : u32 = select(fabrics_0[_S241].weft_0, fabrics_0[_S241].warp_0, _S246.is_warp_0);
    var _S248 : u32 = select(fabrics_0[_S241].warp_0, fabrics_0[_S241].weft_0, _S246.is_warp_0);
    var _S249 : Cell_0 = select_cell_0(_S246.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S250 : Cell_0 = select_cell_0(_S246.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S251 : Run_0 = unpack_0(_S247, _S248, _S249.thread_2, _S250, _S246.word_0);
    var _S252 : Section_0 = section_at_0(_S249);
    var _S253 : bool = ((_S246.on_top_0) & (((_S251.distance_0) < (_S252.drop_0 * _S251.bend_1.sine_0))));
    var _S254 : f32 = select(-1.0f, 1.0f, ((_S246.on_top_0) & ((!_S253))));
    var _S255 : f32 = select(_S251.reach_0, _S251.other_reach_0, _S253);
    var _S256 : f32 = select(max(_S255 - _S251.distance_0, 0.0f), _S255 + _S251.distance_0, _S253);
    var _S257 : f32 = _S255 / _S251.bend_1.sine_0 - _S254 * _S252.drop_0;
    var _S258 : f32 = _S256 * _S256;
    var _S259 : f32 = max(_S257 * _S257 - _S258, 9.99999968265522539e-21f);
    var _S260 : f32 = rsqrt_0(_S259);
    var _S261 : f32 = _S258 / (_S259 * _S260 + _S257);
    var _S262 : bool = _S256 > 0.0f;
    var _S263 : f32 = select(-1.0f, 1.0f, _S246.on_top_0) * select(-1.0f, 1.0f, _S251.near_start_0);
    var _S264 : f32 = _S252.slope_0 * select(1.0f, _S257 * _S260, _S262);
    sample_0.slope_across_0 = _S264;
    var _S265 : f32 = select(0.0f, _S263 * _S256 * _S260, _S262);
    sample_0.slope_along_0 = _S265;
    var _S266 : vec2<f32> = dive_0(_S248, _S246, _S251, _S250);
    sample_0.height_7 = select(families_0[_S247].height_scale_0 * _S254, 0.0f, _S251.straight_0) * (_S255 * _S251.bend_1.half_tangent_0 - _S261) - families_0[_S247].height_scale_0 * _S252.drop_0 - _S266.x;
    var _S267 : f32 = families_0[_S247].height_scale_0 * _S264;
    var _S268 : f32 = families_0[_S247].height_scale_0 * _S265 - _S266.y;
    sample_0.slope_x_1 = select(_S268, _S267, _S246.is_warp_0);
    sample_0.slope_y_1 = select(_S267, _S268, _S246.is_warp_0);
    sample_0.run_3 = _S251;
    sample_0.section_1 = _S252;
    return sample_0;
}

fn steps_per_length_0( _S269 : u32,  _S270 : SearchQuality_0,  _S271 : vec3<f32>) -> f32
{
    return max(max(abs(_S271.x) * fabrics_0[_S269].threads_per_x_0, abs(_S271.y) * fabrics_0[_S269].threads_per_y_0) * _S270.steps_per_thread_0, abs(_S271.z) * fabrics_0[_S269].per_relief_0 * _S270.steps_per_relief_0);
}

fn cell_maximum_0( _S272 : u32,  _S273 : Crossing_0) -> f32
{
    var _S274 : u32 = select(fabrics_0[_S272].weft_0, fabrics_0[_S272].warp_0, _S273.warp_above_0);
    return f32((select(_S273.weft_word_0, _S273.warp_word_0, _S273.warp_above_0) >> (u32(28)))) * families_0[_S274].height_scale_0 * families_0[_S274].level_0;
}

fn probe_0( _S275 : u32,  _S276 : f32,  _S277 : f32,  _S278 : bool,  _S279 : bool,  _S280 : bool) -> Probe_0
{
    var _S281 : Sample_0 = sample_at_0(_S275, _S276, _S277, _S278);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S281.height_7;
    probe_1.hole_1 = _S281.shown_3.hole_0;
    probe_1.slope_x_0 = _S281.slope_x_1;
    probe_1.slope_y_0 = _S281.slope_y_1;
    probe_1.yarn_1 = select(_S281.crossing_1.weft_1.thread_2 * u32(2), _S281.crossing_1.warp_1.thread_2 * u32(2) + u32(1), _S281.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S275, _S281.crossing_1);
    probe_1.side_x_0 = select(_S281.crossing_1.warp_1.below_0, _S281.crossing_1.warp_1.above_0, _S279);
    probe_1.side_y_0 = select(_S281.crossing_1.weft_1.below_0, _S281.crossing_1.weft_1.above_0, _S280);
    probe_1.edge_x_0 = outline_distance_0(_S281.crossing_1.warp_1, _S281.shown_3, _S281.run_3, !_S281.shown_3.is_warp_0, _S279);
    probe_1.edge_y_0 = outline_distance_0(_S281.crossing_1.weft_1, _S281.shown_3, _S281.run_3, _S281.shown_3.is_warp_0, _S280);
    return probe_1;
}

fn is_free_0( _S282 : u32,  _S283 : SearchQuality_0,  _S284 : vec3<f32>,  _S285 : vec3<f32>,  _S286 : bool,  _S287 : f32) -> bool
{
    var _S288 : f32 = _S285.z;
    if(_S288 <= 0.0f)
    {
        return false;
    }
    var _S289 : f32 = 1.0f / max(_S283.shadow_share_0 * steps_per_length_0(_S282, _S283, _S285), 9.99999971718068537e-10f);
    var _S290 : StepControl_0 = step_control_0(_S285.xy, _S289);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S284.z + _S288 * distance_1) < _S287))))
        {
        }
        else
        {
            break;
        }
        var _S291 : vec3<f32> = _S284 + _S285 * vec3<f32>(distance_1);
        var _S292 : Probe_0 = probe_0(_S282, _S291.x, _S291.y, _S286, _S290.right_0, _S290.up_0);
        var _S293 : f32 = _S291.z;
        var _S294 : f32 = _S293 - _S292.height_2;
        var _S295 : f32 = _S288 - _S292.slope_x_0 * _S285.x - _S292.slope_y_0 * _S285.y;
        if(((!_S292.hole_1) & ((_S294 < 0.0f))))
        {
            return false;
        }
        var _S296 : f32 = way_back_to_dip_0(previous_3, _S294, _S295, last_step_0, _S292);
        if(_S296 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S296;
            distance_1 = distance_1 - _S296;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S297 : bool = _S293 > (_S292.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S290, _S292, _S294, _S295), max(StepControl_to_cell_exit_0(_S290, _S292.side_x_0, _S292.side_y_0), _S289), _S297);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S294, _S295, _S292, _S297);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S298 : u32,  _S299 : SearchQuality_0,  _S300 : f32,  _S301 : f32,  _S302 : vec3<f32>,  _S303 : bool) -> bool
{
    if(!sample_at_0(_S298, _S300, _S301, _S303).shown_3.hole_0)
    {
        return false;
    }
    var _S304 : vec3<f32> = vec3<f32>(_S300, _S301, 0.0f);
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
        var _S305 : bool = is_free_0(_S298, _S299, _S304, select_vector_0(side_1 == u32(0), _S302, vec3<f32>(- _S302.x, - _S302.y, _S302.z)), _S303 != (side_1 == u32(1)), fabrics_0[_S298].height_high_0);
        var _S306 : u32 = side_1 + u32(1);
        passes_0 = _S305;
        side_1 = _S306;
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

fn max_height_along_0( _S307 : u32,  _S308 : f32,  _S309 : f32,  _S310 : f32,  _S311 : vec3<f32>,  _S312 : bool) -> f32
{
    var _S313 : f32 = _S311.x;
    var _S314 : f32 = _S311.y;
    var _S315 : u32 = (words_0[fabrics_0[_S307].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S307].weft_0, _S309).thread_2 / u32(2) * fabrics_0[_S307].max_height_columns_0 + locate_0(fabrics_0[_S307].warp_0, _S308).thread_2 / u32(2)) + (select(u32(0), u32(1), _S313 > 0.0f) + select(u32(0), u32(2), _S314 > 0.0f))] >> (u32(select(i32(0), i32(4), _S312))));
    var _S316 : f32 = max(abs(_S313) * fabrics_0[_S307].threads_per_x_0, abs(_S314) * fabrics_0[_S307].threads_per_y_0) / _S311.z;
    var _S317 : f32 = fabrics_0[_S307].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S307].height_high_0;
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
        if(((max_height_0 - _S310) * _S316) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S315 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S317);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S318 : u32,  _S319 : f32,  _S320 : f32,  _S321 : bool,  _S322 : bool,  _S323 : bool) -> vec3<f32>
{
    var _S324 : Crossing_0 = crossing_at_0(_S318, _S319, _S320, _S321);
    return vec3<f32>(cell_maximum_0(_S318, _S324), select(_S324.warp_1.below_0, _S324.warp_1.above_0, _S322), select(_S324.weft_1.below_0, _S324.weft_1.above_0, _S323));
}

fn first_sample_height_0( _S325 : u32,  _S326 : ViewRay_0,  _S327 : StepControl_0,  _S328 : bool) -> f32
{
    var _S329 : f32 = max_height_along_0(_S325, _S326.origin_0.x, _S326.origin_0.y, 0.0f, vec3<f32>(_S326.slope_1, 1.0f), _S328);
    var count_3 : u32 = u32(0);
    var height_9 : f32 = _S329;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S330 : vec2<f32> = ViewRay_at_0(_S326, height_9);
        var _S331 : vec3<f32> = cell_bounds_0(_S325, _S330.x, _S330.y, _S328, _S327.right_0, _S327.up_0);
        var _S332 : f32 = height_9 - _S331.x;
        var _S333 : f32 = StepControl_to_cell_exit_0(_S327, _S331.y, _S331.z);
        var height_10 : f32 = height_9 - clamp(_S332, 0.0f, _S333);
        if(_S332 <= _S333)
        {
            height_9 = height_10;
            break;
        }
        count_3 = count_3 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S334 : u32,  _S335 : ViewRay_0,  _S336 : StepControl_0,  _S337 : bool) -> ViewRayEnd_0
{
    var _S338 : f32 = fabrics_0[_S334].height_low_0 - (fabrics_0[_S334].height_high_0 - fabrics_0[_S334].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S334, _S335, _S336, _S337);
    end_1.last_step_3 = _S336.epsilon_0;
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
        var _S339 : vec2<f32> = ViewRay_at_0(_S335, end_1.height_8);
        var _S340 : Probe_0 = probe_0(_S334, _S339.x, _S339.y, _S337, _S336.right_0, _S336.up_0);
        var _S341 : f32 = end_1.height_8 - _S340.height_2;
        var _S342 : f32 = ViewRay_rate_0(_S335, _S340);
        end_1.depth_1 = - _S341;
        end_1.rate_4 = _S342;
        var _S343 : bool = !_S340.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S343))) & (((end_1.previous_4.yarn_0) == (_S340.yarn_1))));
        if((((_S343 & ((_S341 <= 0.0f)))) | (((end_1.height_8) <= _S338))))
        {
            break;
        }
        var _S344 : f32 = way_back_to_dip_0(end_1.previous_4, _S341, _S342, end_1.last_step_3, _S340);
        if(_S344 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S344;
            end_1.last_step_3 = end_1.last_step_3 - _S344;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S345 : f32 = min(StepControl_to_cell_exit_0(_S336, _S340.side_x_0, _S340.side_y_0), end_1.height_8 - _S340.cell_max_0);
        var _S346 : f32 = StepControl_to_next_sample_0(_S336, _S340, _S341, _S342);
        end_1.previous_4 = after_sample_0(_S341, _S342, _S340, _S345 > _S346);
        var _S347 : f32 = max(_S345, _S346);
        end_1.last_step_3 = _S347;
        end_1.height_8 = end_1.height_8 - _S347;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S348 : u32,  _S349 : ViewRay_0,  _S350 : StepControl_0,  _S351 : bool,  _S352 : ViewRayEnd_0,  _S353 : u32) -> f32
{
    var _S354 : f32 = fabrics_0[_S348].height_high_0 - fabrics_0[_S348].height_low_0;
    var above_2 : f32 = _S352.height_8 + _S352.last_step_3;
    var above_gap_1 : f32 = clamp(_S352.previous_4.clearance_0, 0.0f, _S354);
    var under_gap_1 : f32 = clamp(_S352.depth_1, 0.0f, _S354);
    var middle_0 : f32 = select(between_0(above_2, _S352.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S352.previous_4.rate_0 * _S352.last_step_3, _S352.rate_4 * _S352.last_step_3) * _S352.last_step_3, _S352.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S352.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S353)
        {
        }
        else
        {
            break;
        }
        var _S355 : vec2<f32> = ViewRay_at_0(_S349, middle_0);
        var _S356 : Probe_0 = probe_0(_S348, _S355.x, _S355.y, _S351, _S350.right_0, _S350.up_0);
        var _S357 : f32 = clamp(middle_0 - select(_S356.height_2, -1.0e+09f, _S356.hole_1), - _S354, _S354);
        if(_S357 <= 0.0f)
        {
            var _S358 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S359 : f32 = - _S357;
            under_1 = middle_0;
            above_gap_2 = _S358;
            under_gap_2 = _S359;
            side_2 = 1.0f;
        }
        else
        {
            var _S360 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S357;
            under_gap_2 = _S360;
            side_2 = -1.0f;
        }
        var _S361 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S357 / min(ViewRay_rate_0(_S349, _S356), -9.99999997475242708e-07f), under_1, above_3), _S352.smooth_0);
        var _S362 : u32 = i_1 + u32(1);
        middle_0 = _S361;
        i_1 = _S362;
    }
    return select(under_1, middle_0, _S352.smooth_0);
}

fn first_hit_of_yarn_0( _S363 : u32,  _S364 : SearchQuality_0,  _S365 : f32,  _S366 : f32,  _S367 : vec3<f32>,  _S368 : bool) -> Hit_0
{
    var _S369 : f32 = max(_S367.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S365, _S366);
    var _S370 : vec2<f32> = _S367.xy / vec2<f32>(_S369);
    ray_0.slope_1 = _S370;
    var _S371 : StepControl_0 = step_control_0((vec2<f32>(0) - _S370), 1.0f / max(steps_per_length_0(_S363, _S364, _S367) / _S369, 9.99999971718068537e-10f));
    var _S372 : ViewRayEnd_0 = search_down_0(_S363, ray_0, _S371, _S368);
    var hit_0 : Hit_0;
    hit_0.hole_4 = false;
    var _S373 : f32 = refined_height_0(_S363, ray_0, _S371, _S368, _S372, _S364.refinements_0);
    hit_0.height_6 = _S373;
    var _S374 : vec2<f32> = ViewRay_at_0(ray_0, _S373);
    hit_0.x_13 = _S374.x;
    hit_0.y_6 = _S374.y;
    return hit_0;
}

fn first_hit_0( _S375 : u32,  _S376 : SearchQuality_0,  _S377 : f32,  _S378 : f32,  _S379 : vec3<f32>,  _S380 : bool) -> Hit_0
{
    if(!passes_through_0(_S375, _S376, _S377, _S378, _S379, _S380))
    {
        return first_hit_of_yarn_0(_S375, _S376, _S377, _S378, _S379, _S380);
    }
    var hit_1 : Hit_0;
    hit_1.x_13 = _S377;
    hit_1.y_6 = _S378;
    hit_1.height_6 = 0.0f;
    hit_1.hole_4 = true;
    return hit_1;
}

fn surface_at_0( _S381 : u32,  _S382 : f32,  _S383 : f32,  _S384 : bool) -> SurfacePoint_0
{
    var _S385 : Sample_0 = sample_at_0(_S381, _S382, _S383, _S384);
    var _S386 : u32 = select(fabrics_0[_S381].weft_0, fabrics_0[_S381].warp_0, _S385.shown_3.is_warp_0);
    var _S387 : f32 = families_0[_S386].twist_sine_0 * select(1.0f, -1.0f, _S384);
    var _S388 : f32 = select(-1.0f, 1.0f, _S385.shown_3.is_warp_0);
    var _S389 : vec2<f32> = fibre_direction_0(_S385.slope_across_0, _S388 * _S385.slope_along_0, _S387, families_0[_S386].twist_cosine_0);
    var _S390 : f32 = _S389.x;
    var _S391 : f32 = _S389.y;
    var _S392 : f32 = select(_S385.slope_y_1, _S385.slope_x_1, _S385.shown_3.is_warp_0) * _S390 + _S388 * select(_S385.slope_x_1, _S385.slope_y_1, _S385.shown_3.is_warp_0) * _S391;
    var _S393 : f32 = select(_S385.crossing_1.weft_1.half_width_1, _S385.crossing_1.warp_1.half_width_1, _S385.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S394 : f32 = _S393 * arc_sine_0(clamp(_S385.section_1.across_1 / _S393, -1.0f, 1.0f));
    var _S395 : f32 = select(- _S382, _S383, _S385.shown_3.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_2 = _S385.shown_3.hole_0;
    point_4.is_warp_1 = _S385.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S385.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S385.crossing_1.weft_1.thread_2;
    point_4.height_4 = _S385.height_7;
    point_4.normal_3 = normalize(vec3<f32>(- _S385.slope_x_1, - _S385.slope_y_1, 1.0f));
    point_4.tangent_2 = normalize(select_vector_0(_S385.shown_3.is_warp_0, vec3<f32>(_S390, _S391, _S392), vec3<f32>(- _S391, _S390, _S392)));
    point_4.across_3 = _S385.section_1.across_1;
    point_4.fibre_across_0 = _S394 * families_0[_S386].twist_cosine_0 + _S395 * _S387;
    point_4.fibre_along_0 = _S395 * families_0[_S386].twist_cosine_0 - _S394 * _S387;
    return point_4;
}

fn has_hairs_0( _S396 : u32) -> bool
{
    return (((families_0[fabrics_0[_S396].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S396].weft_0].hairiness_0) > 0.0f)));
}

fn hair_at_0( _S397 : u32,  _S398 : vec2<f32>,  _S399 : bool,  _S400 : f32) -> Hair_0
{
    var _S401 : f32 = fabrics_0[_S397].fibre_size_0;
    var _S402 : f32 = 17.0f * fabrics_0[_S397].fibre_size_0;
    var _S403 : f32 = fade_0(_S400, _S402);
    var _S404 : vec2<f32> = _S398 / vec2<f32>(_S402);
    var _S405 : u32 = hash_key_0(select(u32(0), u32(1), _S399), ((fabrics_0[_S397].seed_0) ^ (u32(1013904242))));
    var _S406 : f32 = 1.0f / max(_S400, 0.07999999821186066f * fabrics_0[_S397].fibre_size_0);
    var _S407 : f32 = min(0.63999998569488525f * fabrics_0[_S397].fibre_size_0 * _S406, 1.0f);
    const _S408 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S408;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S403 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S409 : u32 = number_2 / u32(9);
        var _S410 : u32 = number_2 / u32(3) - u32(3) * _S409;
        var _S411 : vec2<f32> = floor(_S404) + vec2<f32>(f32(number_2 - u32(3) * _S410 - u32(9) * _S409), f32(_S410)) - vec2<f32>(1.0f);
        var _S412 : u32 = hash_bits_0(_S405 + _S409, u32(i32(_S411.x)) * u32(65536) + u32(i32(_S411.y)));
        var _S413 : u32 = hash_bits_0(_S405, _S412);
        var _S414 : vec2<f32> = _S404 - _S411 - vec2<f32>(share_of_0(_S412), share_of_0((_S412 >> (u32(10)))));
        var _S415 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S412 >> (u32(20)))));
        var _S416 : f32 = mix(5.0f, 16.0f, share_of_0((_S413 >> (u32(10))))) / 17.0f;
        var _S417 : f32 = _S414.x;
        var _S418 : f32 = _S415.y;
        var _S419 : f32 = _S414.y;
        var _S420 : f32 = _S415.x;
        var _S421 : f32 = (_S417 * _S418 + _S419 * _S420) / _S416;
        var _S422 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S413 >> (u32(20)))) - 1.0f);
        var _S423 : f32 = 2.0f * _S422 * _S421;
        var _S424 : f32 = rsqrt_0(_S423 * _S423 + 1.0f);
        var _S425 : f32 = (_S419 * _S418 - _S417 * _S420 - _S422 * _S416 * _S421 * _S421) * _S424 * 17.0f;
        var _S426 : f32 = clamp((0.31999999284744263f - abs(_S425)) * _S401 * _S406 + 0.5f, 0.0f, _S407);
        if((((((share_of_0(_S413)) < (families_0[select(fabrics_0[_S397].weft_0, fabrics_0[_S397].warp_0, ((((_S413 >> (u32(30)))) & (u32(1)))) == u32(1))].hairiness_0)) & (((abs(_S421)) < 1.0f)))) & ((_S426 > cover_2))))
        {
            var _S427 : vec2<f32> = vec2<f32>(- _S420 - _S423 * _S418, _S418 - _S423 * _S420) * vec2<f32>(_S424);
            cover_2 = _S426;
            hair_away_0 = _S425;
            hair_across_0 = _S427;
        }
        number_2 = number_2 + u32(1);
    }
    var _S428 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S403 * cover_2;
    hair_1.normal_1 = vec3<f32>(vec2<f32>(_S428) * hair_across_0, sqrt(1.0f - _S428 * _S428));
    hair_1.tangent_0 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S429 : u32,  _S430 : f32) -> bool
{
    return (((((fabrics_0[_S429].fibre_noise_0) > 0.0f) | (((fabrics_0[_S429].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S429].has_detail_0) != u32(0)) & ((_S430 >= 0.0f))))));
}

fn thread_number_0( _S431 : u32,  _S432 : SurfacePoint_0,  _S433 : f32,  _S434 : f32) -> u32
{
    var _S435 : u32 = select(fabrics_0[_S431].weft_0, fabrics_0[_S431].warp_0, _S432.is_warp_1);
    return u32(i32(floor((select(_S434, _S433, _S432.is_warp_1) - _S432.across_3) / families_0[_S435].period_0)) * i32(families_0[_S435].count_0) + i32(select(_S432.weft_thread_0, _S432.warp_thread_0, _S432.is_warp_1))) * u32(2) + select(u32(0), u32(1), _S432.is_warp_1);
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

fn fibre_noise_at_0( _S436 : u32,  _S437 : u32,  _S438 : SurfacePoint_0,  _S439 : u32,  _S440 : f32) -> FibreNoise_0
{
    var _S441 : f32 = 5.0f * fabrics_0[_S436].fibre_size_0;
    var _S442 : vec2<f32> = wave_noise_0(hash_key_0(_S439, ((fabrics_0[_S436].seed_0) ^ (u32(458671337)))), _S438.fibre_along_0 / (25.0f * fabrics_0[_S436].fibre_size_0));
    var _S443 : f32 = _S438.fibre_across_0 + families_0[_S437].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S436].fibre_size_0 * _S442.x;
    var _S444 : vec3<f32> = fibre_cell_0(_S443, _S438.fibre_along_0, fabrics_0[_S436].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S439, ((fabrics_0[_S436].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S443, _S438.fibre_along_0, _S441));
    noise_0.bundle_weight_0 = fade_0(_S440, _S441);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S439, ((fabrics_0[_S436].seed_0) ^ (u32(48610963)))), _S444);
    noise_0.fibre_weight_0 = fade_0(_S440, fabrics_0[_S436].fibre_size_0);
    noise_0.offset_1 = _S444.z;
    noise_0.slope_2 = 0.5f * _S442.y;
    return noise_0;
}

fn detail_gain_0( _S445 : u32,  _S446 : u32,  _S447 : SurfacePoint_0,  _S448 : vec2<f32>,  _S449 : bool,  _S450 : u32,  _S451 : f32) -> vec2<f32>
{
    var _S452 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S446].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S451, 1.0f / families_0[_S446].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S446, _S447, _S449))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S452;
    }
    if((families_0[_S446].fibre_tone_0) > 0.0f)
    {
        var _S453 : FibreNoise_0 = fibre_noise_at_0(_S445, _S446, _S447, _S450, _S451);
        gain_2 = gain_2 + vec2<f32>(families_0[_S446].fibre_tone_0) * vec2<f32>(_S453.bundle_weight_0 * _S453.bundle_0.y + _S453.fibre_weight_0 * _S453.fibre_0.y, _S453.bundle_weight_0 + _S453.fibre_weight_0);
    }
    if((families_0[_S446].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.25f * families_0[_S446].slub_0 * fade_0(_S451, 1.0f / families_0[_S446].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S450, ((fabrics_0[_S445].seed_0) ^ (u32(1373058189)))), select(- _S448.x, _S448.y, _S447.is_warp_1) * families_0[_S446].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S447.across_3 * families_0[_S446].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S454 : u32,  _S455 : Albedos_0,  _S456 : u32,  _S457 : u32,  _S458 : vec2<f32>) -> Albedos_0
{
    var _S459 : vec3<f32> = max(_S455.specular_reflect_0, _S455.specular_transmit_0);
    var _S460 : vec3<f32> = _S455.diffuse_reflect_0 + _S455.diffuse_transmit_0;
    var _S461 : vec3<f32> = vec3<f32>(fabrics_0[_S454].layer_bound_0);
    var _S462 : vec3<f32> = vec3<f32>(1.0f);
    var _S463 : vec3<f32> = _S462 - _S461 * _S459;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S456, fabrics_0[_S454].colour_noise_0, fabrics_0[_S454].seed_0), _S460, _S463);
    var _S464 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S458.y, vec3<f32>(colour_1) * _S460, _S463) * _S458.x)));
    var _S465 : f32 = bounded_gain_0(fibre_gain_0(_S456, _S457, fabrics_0[_S454].fibre_noise_0, fabrics_0[_S454].seed_0), _S459, min((_S462 - _S464 * _S460) / _S461, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S464 * _S455.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S464 * _S455.diffuse_transmit_0;
    var _S466 : vec3<f32> = vec3<f32>(_S465);
    varied_0.specular_reflect_0 = _S466 * _S455.specular_reflect_0;
    varied_0.specular_transmit_0 = _S466 * _S455.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S467 : u32,  _S468 : SurfacePoint_0,  _S469 : Albedos_0,  _S470 : f32,  _S471 : f32,  _S472 : bool,  _S473 : f32,  _S474 : f32) -> Albedos_0
{
    var _S475 : u32 = thread_number_0(_S467, _S468, _S470, _S471);
    var _S476 : vec3<f32> = fibre_cell_0(_S468.fibre_across_0, _S468.fibre_along_0, fabrics_0[_S467].fibre_size_0);
    var _S477 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S467].has_detail_0) != u32(0)) & ((_S473 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S467, select(fabrics_0[_S467].weft_0, fabrics_0[_S467].warp_0, _S468.is_warp_1), _S468, vec2<f32>(_S470, _S471), _S472, _S475, _S473) * vec2<f32>(1.0f - _S474, 1.0f);
    }
    else
    {
        gain_3 = _S477;
    }
    return vary_albedos_0(_S467, _S469, _S475, u32(i32(_S476.x)) * u32(65536) + u32(i32(floor(_S476.y))), gain_3);
}

fn turned_frame_0( _S478 : u32,  _S479 : u32,  _S480 : SurfacePoint_0,  _S481 : bool,  _S482 : u32,  _S483 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_4 = _S480.normal_3;
    frame_2.tangent_3 = _S480.tangent_2;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S479].has_plies_0) > 0.0f)
    {
        var _S484 : f32 = fade_0(_S483, 1.0f / families_0[_S479].plies_per_mm_0);
        var _S485 : f32 = _S484 * 0.41999998688697815f * ply_offset_0(_S479, _S480, _S481);
        var _S486 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S487 : vec3<f32> = vec3<f32>(families_0[_S479].ply_cosine_0);
        var _S488 : vec3<f32> = vec3<f32>(select(families_0[_S479].ply_sine_0, - families_0[_S479].ply_sine_0, _S481));
        var _S489 : vec3<f32> = _S487 * _S486 + _S488 * frame_2.tangent_3;
        var _S490 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S485 * _S485));
        var _S491 : vec3<f32> = vec3<f32>(_S485);
        frame_2.tangent_3 = _S487 * (_S487 * frame_2.tangent_3 - _S488 * _S486) + _S488 * (_S490 * _S489 - _S491 * frame_2.normal_4);
        frame_2.normal_4 = _S490 * frame_2.normal_4 + _S491 * _S489;
        frame_2.loss_0 = _S484 * _S484 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S492 : f32 = families_0[_S479].fibre_tilt_0;
    if((families_0[_S479].fibre_tilt_0) > 0.0f)
    {
        var _S493 : FibreNoise_0 = fibre_noise_at_0(_S478, _S479, _S480, _S482, _S483);
        var _S494 : f32 = 1.09858846664428711f * _S492 * (_S493.bundle_weight_0 * _S493.bundle_0.x + _S493.fibre_weight_0 * (_S493.fibre_0.x + _S493.offset_1));
        var _S495 : f32 = _S492 * (1.42099642753601074f * (_S493.bundle_weight_0 * _S493.bundle_0.y + _S493.fibre_weight_0 * _S493.fibre_0.y) - _S493.bundle_weight_0 * _S493.slope_2);
        var _S496 : f32 = square_1(_S493.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S492 * _S492 * ((0.24761904776096344f * (square_1(_S493.bundle_weight_0) + _S496) + _S496 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S497 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S498 : vec2<f32> = sine_cosine_0(_S494);
        var _S499 : vec2<f32> = sine_cosine_0(_S495);
        var _S500 : vec3<f32> = vec3<f32>(_S498.y);
        var _S501 : vec3<f32> = vec3<f32>(_S498.x);
        var _S502 : vec3<f32> = _S500 * _S497 - _S501 * frame_2.normal_4;
        frame_2.normal_4 = _S500 * frame_2.normal_4 + _S501 * _S497;
        frame_2.tangent_3 = vec3<f32>(_S499.y) * frame_2.tangent_3 + vec3<f32>(_S499.x) * _S502;
    }
    return frame_2;
}

fn yarn_point_of_0( _S503 : u32,  _S504 : SurfacePoint_0,  _S505 : f32,  _S506 : f32,  _S507 : bool,  _S508 : bool,  _S509 : f32) -> YarnPoint_0
{
    var _S510 : u32 = select(fabrics_0[_S503].weft_0, fabrics_0[_S503].warp_0, _S504.is_warp_1);
    var _S511 : bool = (((fabrics_0[_S503].has_detail_0) != u32(0)) & ((_S509 >= 0.0f)));
    var _S512 : vec3<f32> = vec3<f32>(0.0f);
    var _S513 : Hair_0 = Hair_x24init_0(0.0f, _S512, _S512);
    var _S514 : bool;
    if(_S511)
    {
        _S514 = has_hairs_0(_S503);
    }
    else
    {
        _S514 = false;
    }
    var hair_2 : Hair_0;
    if(_S514)
    {
        hair_2 = hair_at_0(_S503, vec2<f32>(_S505, _S506), _S507, _S509);
    }
    else
    {
        hair_2 = _S513;
    }
    var albedos_3 : Albedos_0 = albedos_of_0(_S510, select(_S504.weft_thread_0, _S504.warp_thread_0, _S504.is_warp_1));
    var albedos_4 : Albedos_0;
    if(varies_at_0(_S503, _S509))
    {
        albedos_4 = varied_at_0(_S503, _S504, albedos_3, _S505, _S506, _S507, _S509, hair_2.cover_0);
    }
    else
    {
        albedos_4 = albedos_3;
    }
    var point_5 : YarnPoint_0;
    point_5.back_6 = _S507;
    point_5.hole_3 = _S508;
    point_5.is_warp_2 = _S504.is_warp_1;
    point_5.x_12 = _S505;
    point_5.y_5 = _S506;
    point_5.height_5 = _S504.height_4;
    point_5.normal_8 = _S504.normal_3;
    point_5.tangent_8 = _S504.tangent_2;
    point_5.surface_normal_0 = _S504.normal_3;
    point_5.diffuse_gain_1 = 1.0f;
    if(_S511)
    {
        var _S515 : YarnFrame_0 = turned_frame_0(_S503, _S510, _S504, _S507, thread_number_0(_S503, _S504, _S505, _S506), _S509);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S503))
        {
            frame_3 = under_hair_0(_S515, hair_2);
        }
        else
        {
            frame_3 = _S515;
        }
        point_5.normal_8 = frame_3.normal_4;
        point_5.tangent_8 = frame_3.tangent_3;
        point_5.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S503].diffuse_blend_0);
    }
    point_5.roughness_8 = families_0[_S510].roughness_0;
    point_5.albedos_2 = albedos_4;
    return point_5;
}

fn locate_yarn_0( _S516 : u32,  _S517 : SearchQuality_0,  _S518 : f32,  _S519 : f32,  _S520 : vec3<f32>,  _S521 : f32) -> YarnPoint_0
{
    var _S522 : bool = (_S520.z) < 0.0f;
    var _S523 : Hit_0 = first_hit_0(_S516, _S517, _S518, _S519, to_face_frame_0(_S520, _S522), _S522);
    return yarn_point_of_0(_S516, surface_at_0(_S516, _S523.x_13, _S523.y_6, _S522), _S523.x_13, _S523.y_6, _S522, _S523.hole_4, _S521);
}

fn openness_number_0( _S524 : u32,  _S525 : u32) -> f32
{
    return table_number_0(fabrics_0[_S524].openness_0 + _S525);
}

fn blocked_of_terms_0( _S526 : u32,  _S527 : u32,  _S528 : array<f32, i32(6)>,  _S529 : u32) -> Blocked_0
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
            if(term_0 < _S529)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S526, _S527 + share_3 * _S529 + term_0) * _S528[term_0];
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

fn blocked_at_0( _S530 : u32,  _S531 : bool,  _S532 : bool,  _S533 : f32,  _S534 : f32) -> Blocked_0
{
    var _S535 : f32 = _S534 * openness_number_0(_S530, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S533, _S535, _S533 * _S533, _S533 * _S535, _S535 * _S535 );
    return blocked_of_terms_0(_S530, u32(60) + (select(u32(0), u32(2), _S532) + select(u32(1), u32(0), _S531)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S536 : u32,  _S537 : Albedos_0,  _S538 : u32,  _S539 : vec3<f32>) -> Scattered_0
{
    var _S540 : u32 = u32(159) + u32(2) * _S538;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S539 * _S537.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S536, _S540)) * _S537.specular_reflect_0;
    yarn_3.through_0 = _S539 * _S537.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S536, _S540 + u32(1))) * _S537.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S541 : u32,  _S542 : u32,  _S543 : vec3<f32>,  _S544 : vec3<f32>,  _S545 : vec3<f32>,  _S546 : vec3<f32>,  _S547 : ptr<function, vec3<f32>>,  _S548 : ptr<function, vec3<f32>>)
{
    var _S549 : u32 = u32(146) + u32(4) * _S542;
    var _S550 : f32 = openness_number_0(_S541, _S549 + u32(1));
    var _S551 : f32 = openness_number_0(_S541, _S549 + u32(2));
    var _S552 : vec3<f32> = vec3<f32>(1.0f);
    var _S553 : vec3<f32> = _S552 - _S545 * vec3<f32>(openness_number_0(_S541, _S549));
    var _S554 : vec3<f32> = _S552 - _S546 * vec3<f32>(openness_number_0(_S541, _S549 + u32(3)));
    var _S555 : vec3<f32> = _S552 / (_S553 * _S554 - _S545 * _S546 * vec3<f32>((_S550 * _S551)));
    (*_S547) = (_S543 * _S554 + _S545 * vec3<f32>(_S550) * _S544) * _S555;
    (*_S548) = (_S544 * _S553 + _S546 * vec3<f32>(_S551) * _S543) * _S555;
    return;
}

fn face_sends_0( _S556 : u32,  _S557 : u32,  _S558 : Scattered_0,  _S559 : Scattered_0) -> FaceSends_0
{
    var _S560 : u32 = u32(2) * _S557;
    var _S561 : u32 = u32(142) + _S560;
    var _S562 : f32 = openness_number_0(_S556, _S561);
    var _S563 : f32 = openness_number_0(_S556, _S561 + u32(1));
    var _S564 : vec3<f32> = vec3<f32>((1.0f - _S562)) * _S558.back_5;
    var _S565 : vec3<f32> = vec3<f32>((1.0f - _S563)) * _S559.back_5;
    var sends_1 : FaceSends_0;
    var _S566 : u32 = u32(154) + _S560;
    var _S567 : f32 = openness_number_0(_S556, _S566);
    sends_1.blocks_warp_0 = _S567;
    var _S568 : f32 = openness_number_0(_S556, _S566 + u32(1));
    sends_1.blocks_weft_0 = _S568;
    sends_1.open_0 = _S567 * _S562 + _S568 * _S563;
    var _S569 : vec3<f32> = vec3<f32>(_S562) * _S558.back_5;
    var _S570 : vec3<f32> = vec3<f32>(_S563) * _S559.back_5;
    var _S571 : vec3<f32> = sends_1.sky_warp_0;
    var _S572 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S556, _S557, _S569, _S570, _S564, _S565, &(_S571), &(_S572));
    sends_1.sky_warp_0 = _S571;
    sends_1.sky_weft_0 = _S572;
    var _S573 : vec3<f32> = sends_1.crossing_warp_0;
    var _S574 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S556, _S557, _S558.through_0, _S559.through_0, _S564, _S565, &(_S573), &(_S574));
    sends_1.crossing_warp_0 = _S573;
    sends_1.crossing_weft_0 = _S574;
    return sends_1;
}

fn interior_of_0( _S575 : u32,  _S576 : vec3<f32>,  _S577 : bool) -> Interior_0
{
    var _S578 : Scattered_0 = scattered_by_0(_S575, table_albedos_0(families_0[fabrics_0[_S575].warp_0].colour_mean_0), u32(0), _S576);
    var _S579 : Scattered_0 = scattered_by_0(_S575, table_albedos_0(families_0[fabrics_0[_S575].weft_0].colour_mean_0), u32(1), _S576);
    var _S580 : FaceSends_0 = face_sends_0(_S575, select(u32(0), u32(1), _S577), _S578, _S579);
    var _S581 : FaceSends_0 = face_sends_0(_S575, select(u32(1), u32(0), _S577), _S578, _S579);
    var _S582 : vec3<f32> = vec3<f32>(_S580.blocks_warp_0);
    var _S583 : vec3<f32> = vec3<f32>(_S580.blocks_weft_0);
    var _S584 : vec3<f32> = _S582 * _S580.crossing_warp_0 + _S583 * _S580.crossing_weft_0;
    var _S585 : vec3<f32> = vec3<f32>(_S581.blocks_warp_0);
    var _S586 : vec3<f32> = vec3<f32>(_S581.blocks_weft_0);
    var _S587 : vec3<f32> = _S585 * _S581.crossing_warp_0 + _S586 * _S581.crossing_weft_0;
    var _S588 : f32 = 1.0f - _S580.open_0;
    var _S589 : f32 = 1.0f - _S581.open_0;
    var _S590 : vec3<f32> = vec3<f32>(1.0f);
    var _S591 : vec3<f32> = _S590 / (_S590 - _S584 * _S587 * vec3<f32>((_S588 * _S589)));
    var _S592 : vec3<f32> = _S587 * (vec3<f32>(_S580.open_0) + vec3<f32>(_S588) * (_S582 * _S580.sky_warp_0 + _S583 * _S580.sky_weft_0)) * _S591;
    var _S593 : vec3<f32> = _S584 * (vec3<f32>(_S581.open_0) + vec3<f32>(_S589) * (_S585 * _S581.sky_warp_0 + _S586 * _S581.sky_weft_0)) * _S591;
    var _S594 : FaceRadiance_0 = face_radiance_0(_S580, _S581.open_0, _S592, _S593);
    var _S595 : FaceRadiance_0 = face_radiance_0(_S581, _S580.open_0, _S593, _S592);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S594.warp_2;
    interior_1.weft_3 = _S594.weft_2;
    interior_1.leaked_1 = _S594.leaked_0;
    interior_1.far_1 = _S595.mean_0;
    interior_1.far_leaked_0 = _S595.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S596 : u32,  _S597 : YarnPoint_0,  _S598 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S599 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S599;
    nothing_0.transmitted_0 = _S599;
    if((((fabrics_0[_S596].openness_0) == u32(4294967295)) | ((_S597.hole_3))))
    {
        return nothing_0;
    }
    return bounced_by_0(blocked_at_0(_S596, _S597.is_warp_2, _S597.back_6, _S597.surface_normal_0.z, _S597.height_5), scattered_by_0(_S596, _S597.albedos_2, select(u32(1), u32(0), _S597.is_warp_2), _S598), interior_of_0(_S596, _S598, _S597.back_6));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S600 : u32,  _S601 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S600 * frame_record_0.height_0 + _S601.y) * frame_record_0.width_0 + _S601.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S602 : u32,  _S603 : u32) -> vec3<f32>
{
    var _S604 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S602 * frame_record_0.environment_columns_0 + _S603);
    return vec3<f32>(scene_number_0(_S604), scene_number_0(_S604 + u32(1)), scene_number_0(_S604 + u32(2)));
}

fn sample_environment_0( _S605 : vec2<f32>,  _S606 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S607 : u32 = frame_record_0.environment_rows_0;
    var _S608 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S605.y);
    var _S609 : u32 = frame_record_0.environment_columns_0;
    var _S610 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S608.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S605.x);
    var _S611 : vec3<f32> = environment_texel_0(_S608.index_6, _S610.index_6);
    (*_S606) = _S611 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S611), 9.99999968265522539e-21f)));
    var _S612 : f32 = 3.14159274101257324f / f32(_S607);
    var _S613 : f32 = mix(sine_cosine_0(f32(_S608.index_6) * _S612).y, sine_cosine_0(f32(_S608.index_6 + u32(1)) * _S612).y, _S608.remainder_0);
    var _S614 : f32 = sqrt(max(1.0f - _S613 * _S613, 0.0f));
    var _S615 : vec2<f32> = sine_cosine_0((f32(_S610.index_6) + _S610.remainder_0) * (6.28318548202514648f / f32(_S609)));
    var _S616 : f32 = _S614 * _S615.x;
    var _S617 : f32 = - _S614 * _S615.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S616 + frame_record_0.environment_sine_0 * _S617, _S613, frame_record_0.environment_cosine_0 * _S617 - frame_record_0.environment_sine_0 * _S616);
}

fn light_sample_0( _S618 : u32,  _S619 : vec2<u32>,  _S620 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S621 : u32 = frame_record_0.lights_0;
    if(_S618 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S622 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S619, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S618 - _S621), u32(3)), &(weight_0));
        sample_1.towards_0 = _S622;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S623 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S618);
    sample_1.irradiance_1 = vec3<f32>(_S623.red_0, _S623.green_0, _S623.blue_0);
    sample_1.towards_0 = vec3<f32>(_S623.x_8, _S623.y_1, _S623.z_1);
    if((_S623.is_point_0) != u32(0))
    {
        var _S624 : vec3<f32> = sample_1.towards_0 - _S620;
        var _S625 : f32 = max(square_0(_S624), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S625);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S625);
        sample_1.towards_0 = normalize(_S624);
    }
    return sample_1;
}

fn scattered_0( _S626 : u32,  _S627 : YarnPoint_0,  _S628 : vec3<f32>,  _S629 : vec3<f32>) -> vec3<f32>
{
    var _S630 : vec3<f32> = vec3<f32>(0.0f);
    var _S631 : bool = !_S627.hole_3;
    var _S632 : f32 = _S628.z;
    var value_1 : vec3<f32>;
    if((_S631 & ((_S632 > 0.0f))))
    {
        value_1 = _S627.albedos_2.diffuse_reflect_0 * vec3<f32>(_S627.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0(_S628, _S627.normal_8, fabrics_0[_S626].diffuse_blend_0)) + _S627.albedos_2.specular_reflect_0 * vec3<f32>(reflection_0(_S628, _S629, _S627.normal_8, _S627.tangent_8, _S627.roughness_8, fabrics_0[_S626].optical_depth_0));
    }
    else
    {
        if((_S631 & ((_S632 < 0.0f))))
        {
            value_1 = _S627.albedos_2.diffuse_transmit_0 * vec3<f32>(_S627.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S628), _S627.normal_8, fabrics_0[_S626].diffuse_blend_0)) + _S627.albedos_2.specular_transmit_0 * vec3<f32>(transmission_1(_S628, _S629, _S627.normal_8, _S627.tangent_8, _S627.roughness_8, fabrics_0[_S626].optical_depth_0));
        }
        else
        {
            value_1 = _S630;
        }
    }
    var _S633 : f32 = fabrics_0[_S626].sheen_strength_0;
    if((fabrics_0[_S626].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S634 : vec2<f32> = sheen_with_transmittance_0(_S628, _S629, _S633, fabrics_0[_S626].sheen_roughness_0);
    return vec3<f32>(_S634.y) * value_1 + vec3<f32>(_S634.x);
}

fn unoccluded_0( _S635 : u32,  _S636 : SearchQuality_0,  _S637 : f32,  _S638 : f32,  _S639 : f32,  _S640 : vec3<f32>,  _S641 : bool) -> bool
{
    if((_S640.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S635, _S636, vec3<f32>(_S637, _S638, _S639 + fabrics_0[_S635].lift_0), _S640, _S641, max_height_along_0(_S635, _S637, _S638, _S639, _S640, _S641));
}

fn is_lit_0( _S642 : u32,  _S643 : SearchQuality_0,  _S644 : YarnPoint_0,  _S645 : vec3<f32>) -> bool
{
    if(_S644.hole_3)
    {
        return true;
    }
    var _S646 : vec3<f32> = to_face_frame_0(_S645, _S644.back_6);
    var _S647 : f32 = _S646.z;
    var _S648 : bool = _S647 < 0.0f;
    var normal_9 : vec3<f32>;
    var height_11 : f32;
    if(_S648)
    {
        var _S649 : SurfacePoint_0 = surface_at_0(_S642, _S644.x_12, _S644.y_5, !_S644.back_6);
        normal_9 = _S649.normal_3;
        height_11 = _S649.height_4;
    }
    else
    {
        normal_9 = _S644.surface_normal_0;
        height_11 = _S644.height_5;
    }
    var _S650 : vec3<f32> = vec3<f32>(_S646.xy, abs(_S647));
    if((dot(normal_9, _S650)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S642, _S643, _S644.x_12, _S644.y_5, height_11, _S650, (_S644.back_6) != _S648);
}

fn evaluate_with_0( _S651 : u32,  _S652 : SearchQuality_0,  _S653 : YarnPoint_0,  _S654 : Bounced_0,  _S655 : vec3<f32>,  _S656 : vec3<f32>) -> vec3<f32>
{
    var _S657 : vec3<f32> = to_face_frame_0(_S656, _S653.back_6);
    var _S658 : vec3<f32> = scattered_0(_S651, _S653, to_face_frame_0(_S655, _S653.back_6), _S657);
    var _S659 : bool;
    if((max(_S658.x, max(_S658.y, _S658.z))) <= 0.0f)
    {
        _S659 = true;
    }
    else
    {
        _S659 = !is_lit_0(_S651, _S652, _S653, _S655);
    }
    var value_2 : vec3<f32>;
    if(_S659)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S658;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S654, _S655, _S656);
    var _S660 : f32 = fabrics_0[_S651].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S651].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S660 * sheen_lobe_0(abs(_S657.z), fabrics_0[_S651].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S661 : u32,  _S662 : YarnPoint_0,  _S663 : vec3<f32>) -> f32
{
    if(!_S662.hole_3)
    {
        return 0.0f;
    }
    var _S664 : f32 = fabrics_0[_S661].sheen_strength_0;
    if((fabrics_0[_S661].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S664 * sheen_lobe_0(abs(_S663.z), fabrics_0[_S661].sheen_roughness_0).z;
}

fn light_of_point_0( _S665 : u32,  _S666 : VisiblePoint_0,  _S667 : vec2<u32>,  _S668 : vec3<f32>,  _S669 : vec2<f32>) -> vec4<f32>
{
    var _S670 : SearchQuality_0 = default_quality_0();
    var _S671 : vec3<f32> = to_local_0(_S666, _S666.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S669;
    footprint_0.dx_0 = _S666.draft_dx_0;
    footprint_0.dy_0 = _S666.draft_dy_0;
    var _S672 : YarnPoint_0 = locate_yarn_0(_S665, _S670, _S669.x, _S669.y, _S671, Footprint_spread_side_0(footprint_0));
    var point_6 : YarnPoint_0 = _S672;
    var _S673 : Bounced_0 = bounced_at_0(_S665, _S672, _S668);
    point_6.albedos_2 = tinted_0(point_6.albedos_2, _S668);
    var _S674 : vec3<f32> = vec3<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S674;
    for(;;)
    {
        if(number_3 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S675 : f32 = visibility_at_0(number_3, _S667);
        if(_S675 <= 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S676 : LightSample_0 = light_sample_0(number_3, _S667, _S666.position_0);
        radiance_1 = radiance_1 + vec3<f32>(_S675) * _S676.irradiance_1 * evaluate_with_0(_S665, _S670, point_6, _S673, to_local_0(_S666, _S676.towards_0), _S671);
        number_3 = number_3 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S665, point_6, _S671));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S677 : u32 = id_0.x;
    var _S678 : bool;
    if(_S677 >= (frame_record_0.width_0))
    {
        _S678 = true;
    }
    else
    {
        _S678 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S678)
    {
        return;
    }
    var _S679 : vec2<u32> = id_0.xy;
    var _S680 : u32 = id_0.y * frame_record_0.width_0 + _S677;
    var _S681 : u32 = layers_0[_S680].face_0;
    if((layers_0[_S680].face_0) == u32(0))
    {
        return;
    }
    var _S682 : u32 = _S681 - u32(1);
    var _S683 : u32 = fabric_of_0(_S682);
    var _S684 : VisiblePoint_0 = visible_point_0(_S683, _S682, _S679);
    var _S685 : vec3<f32> = filtered_albedo_0(_S683, _S684);
    var _S686 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S686;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S687 : vec2<f32> = pixel_sequence_0(_S679, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S683, _S684, _S679, _S685, _S684.draft_0 + vec2<f32>(_S687.x) * _S684.draft_dx_0 + vec2<f32>(_S687.y) * _S684.draft_dy_0);
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S680, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

