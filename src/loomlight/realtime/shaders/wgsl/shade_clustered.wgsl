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
    @align(4) light_0 : u32,
    @align(4) view_0 : u32,
    @align(4) offset_1 : u32,
    @align(4) trust_0 : u32,
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

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

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
fn select_vector_2( condition_2 : bool,  yes_2 : vec4<u32>,  no_2 : vec4<u32>) -> vec4<u32>
{
    var chosen_2 : vec4<u32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    chosen_2[i32(3)] = select(no_2[i32(3)], yes_2[i32(3)], condition_2);
    return chosen_2;
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

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
     view_1 : vec3<f32>,
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

fn mixed_0( number_0 : u32) -> u32
{
    var bits_0 : u32 = ((number_0 ^ (((number_0 >> (u32(16))))))) * u32(2246822507);
    var bits_1 : u32 = ((bits_0 ^ (((bits_0 >> (u32(13))))))) * u32(3266489909);
    return (bits_1 ^ (((bits_1 >> (u32(16))))));
}

fn uniform_of_0( seed_1 : u32,  dimension_0 : u32) -> f32
{
    return f32(((mixed_0(seed_1 + (dimension_0 + u32(1)) * u32(2654435769))) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S23 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S23, - _S23, back_2));
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
     corner_1 : u32,
     bins_1 : u32,
     weights_0 : vec4<f32>,
};

fn bin_taps_0( direction_2 : vec3<f32>,  bins_2 : u32) -> BinTaps_0
{
    var _S24 : f32 = sqrt(max(1.0f - direction_2.z, 0.0f));
    var _S25 : f32 = direction_2.x;
    var _S26 : f32 = abs(_S25);
    var _S27 : f32 = direction_2.y;
    var _S28 : f32 = abs(_S27);
    var _S29 : bool = _S26 >= _S28;
    var _S30 : f32 = _S24 * (arc_tangent_of_ratio_0(min(_S26, _S28) / max(max(_S26, _S28), 9.999999960041972e-13f)) * 1.27323949337005615f);
    var _S31 : f32 = f32(bins_2);
    var _S32 : vec2<f32> = clamp((vec2<f32>(select(1.0f, -1.0f, _S25 < 0.0f) * select(_S30, _S24, _S29), select(1.0f, -1.0f, _S27 < 0.0f) * select(_S24, _S30, _S29)) + vec2<f32>(1.0f)) * vec2<f32>((0.5f * _S31)) - vec2<f32>(0.5f), vec2<f32>(0.0f), vec2<f32>((_S31 - 1.0f)));
    var _S33 : f32 = _S32.x;
    var _S34 : u32 = bins_2 - u32(2);
    var _S35 : u32 = min(u32(_S33), _S34);
    var _S36 : f32 = _S32.y;
    var _S37 : u32 = min(u32(_S36), _S34);
    var _S38 : f32 = _S33 - f32(_S35);
    var _S39 : f32 = _S36 - f32(_S37);
    var taps_0 : BinTaps_0;
    taps_0.corner_1 = _S37 * bins_2 + _S35;
    taps_0.bins_1 = bins_2;
    var _S40 : f32 = 1.0f - _S38;
    var _S41 : f32 = 1.0f - _S39;
    taps_0.weights_0 = vec4<f32>(_S40 * _S41, _S38 * _S41, _S40 * _S39, _S38 * _S39);
    return taps_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn BinTaps_read_0( this_0 : BinTaps_0,  table_0 : u32,  first_2 : u32,  stride_0 : u32,  offset_2 : u32) -> f32
{
    var _S42 : u32 = table_0 + (first_2 + this_0.corner_1) * stride_0 + offset_2;
    return table_number_0(_S42) * this_0.weights_0.x + table_number_0(_S42 + stride_0) * this_0.weights_0.y + table_number_0(_S42 + this_0.bins_1 * stride_0) * this_0.weights_0.z + table_number_0(_S42 + (this_0.bins_1 + u32(1)) * stride_0) * this_0.weights_0.w;
}

struct TexelBox_0
{
     corner_2 : vec2<f32>,
     size_1 : vec2<f32>,
     first_3 : vec2<u32>,
     extent_0 : vec2<f32>,
     last_0 : vec2<u32>,
     turns_0 : vec2<f32>,
};

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn texel_box_0( tables_0 : ptr<function, Clustered_std430_0>,  footprint_0 : Footprint_0,  offset_3 : vec2<f32>,  place_0 : f32) -> TexelBox_0
{
    var _S43 : f32 = footprint_0.dx_0.x;
    var _S44 : f32 = footprint_0.dy_0.x;
    var _S45 : f32 = sqrt(_S43 * _S43 + _S44 * _S44);
    var _S46 : f32 = footprint_0.dx_0.y;
    var _S47 : f32 = footprint_0.dy_0.y;
    var _S48 : f32 = sqrt(_S46 * _S46 + _S47 * _S47);
    var _S49 : vec2<f32> = vec2<f32>(_S45, _S48);
    var _S50 : f32 = (_S43 * _S46 + _S44 * _S47) / max(_S45 * _S48, 1.00000000317107685e-30f);
    var _S51 : f32 = abs(_S50);
    var _S52 : f32 = place_0 * sqrt(min(_S51, 1.0f));
    var _S53 : vec2<f32> = _S49 * vec2<f32>(_S52, select(_S52, - _S52, _S50 < 0.0f));
    var _S54 : vec2<f32> = vec2<f32>((*tables_0).texel_width_0, (*tables_0).texel_height_0);
    var _S55 : u32 = (*tables_0).columns_0;
    var _S56 : u32 = (*tables_0).rows_0;
    var _S57 : vec2<f32> = vec2<f32>(f32((*tables_0).columns_0), f32((*tables_0).rows_0));
    var box_0 : TexelBox_0;
    var _S58 : vec2<f32> = _S49 * vec2<f32>(sqrt(max(1.0f - _S51, 0.0f)));
    box_0.size_1 = _S58;
    var _S59 : vec2<f32> = vec2<f32>(0.5f);
    var _S60 : vec2<f32> = _S59 * _S58;
    var _S61 : vec2<f32> = footprint_0.centre_0 + _S53 - _S60;
    box_0.corner_2 = _S61;
    var _S62 : vec2<f32> = max(round(_S58 / _S54), vec2<f32>(1.0f));
    box_0.extent_0 = _S62;
    var _S63 : vec2<f32> = round((_S61 + _S60 + offset_3) / _S54 - _S59 * _S62);
    var _S64 : vec2<f32> = vec2<f32>(0.0f);
    var _S65 : vec2<f32> = max(_S63 - floor(_S63 / _S57) * _S57, _S64);
    var _S66 : vec2<u32> = vec2<u32>(min(u32(_S65.x), (*tables_0).columns_0 - u32(1)), min(u32(_S65.y), (*tables_0).rows_0 - u32(1)));
    box_0.first_3 = _S66;
    var _S67 : vec2<f32> = floor(_S62 / _S57);
    box_0.turns_0 = _S67;
    var _S68 : vec2<f32> = max(_S62 - _S67 * _S57, _S64);
    var _S69 : vec2<u32> = _S66 + vec2<u32>(u32(_S68.x), u32(_S68.y));
    box_0.last_0 = _S69;
    if((_S69.x) >= ((*tables_0).columns_0))
    {
        box_0.last_0[i32(0)] = box_0.last_0[i32(0)] - _S55;
        box_0.turns_0[i32(0)] = box_0.turns_0[i32(0)] + 1.0f;
    }
    if((box_0.last_0.y) >= _S56)
    {
        box_0.last_0[i32(1)] = box_0.last_0[i32(1)] - _S56;
        box_0.turns_0[i32(1)] = box_0.turns_0[i32(1)] + 1.0f;
    }
    return box_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S70 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S70, fma(- _S70, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S71 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S72 : f32 = fma(- _S71, families_0[family_1].size_0, position_1);
    cell_0.below_0 = _S72;
    cell_0.above_0 = families_0[family_1].size_0 - _S72;
    cell_0.across_0 = _S72 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S71).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_1 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_2 : f32 = turns_1 - floor(turns_1);
    var _S73 : f32 = turns_2 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_2 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S74 : u32 = min(thread_1 + select(u32(0), u32(1), _S73 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S75 : u32 = families_0[family_2].place_table_0 + _S74 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S74;
    cell_1.below_0 = _S73 - table_number_0(_S75);
    cell_1.above_0 = table_number_0(_S75 + u32(1)) - _S73;
    cell_1.across_0 = _S73 - table_number_0(_S75 + u32(2));
    cell_1.half_width_1 = table_number_0(_S75 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_3 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Bound_0
{
     thread_2 : u32,
     turns_3 : f32,
     cell_2 : f32,
     visible_0 : f32,
     width_2 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_4 : u32,  position_4 : f32) -> Bound_0
{
    var _S76 : Cell_0 = locate_0(family_4, position_4);
    var _S77 : f32 = table_number_0(families_0[family_4].before_0 + u32(2) * _S76.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_2 = _S76.thread_0;
    bound_0.turns_3 = round((position_4 - families_0[family_4].start_0 - _S77 - _S76.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S76.below_0;
    var _S78 : f32 = 2.0f * _S76.half_width_1;
    bound_0.width_2 = _S78;
    bound_0.visible_0 = clamp((_S76.across_0 + _S76.half_width_1) / _S78, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S76.below_0, _S76.below_0 - _S76.across_0 - _S76.half_width_1) + max(_S76.across_0 - _S76.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_5 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S79 : f32 = centre_1 - floor((centre_1 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    var _S80 : f32 = 0.5f * max(size_2, families_0[family_5].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_5, _S79 - _S80);
    stretch_0.high_0 = bound_at_0(family_5, _S79 + _S80);
    return stretch_0;
}

fn table_colour_0( index_3 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_3), table_number_0(index_3 + u32(1)), table_number_0(index_3 + u32(2)));
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

fn Stretch_turns_0( this_1 : Stretch_0) -> f32
{
    return this_1.high_0.turns_3 - this_1.low_0.turns_3;
}

fn lengths_0( family_6 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S81 : f32 = Stretch_turns_0(stretch_1);
    var _S82 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.low_0.thread_2;
    var _S83 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.high_0.thread_2;
    var _S84 : f32 = table_number_0(_S83) - table_number_0(_S82);
    var _S85 : f32 = table_number_0(_S83 + u32(1)) - table_number_0(_S82 + u32(1));
    return vec3<f32>(_S84 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_2 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_2 + _S81 * families_0[family_6].visible_total_0, _S85 - _S84 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S81 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S85 + stretch_1.high_0.cell_2 - stretch_1.low_0.cell_2 + _S81 * families_0[family_6].period_0);
}

fn integrals_along_0( family_7 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S86 : u32 = u32(3) * families_0[family_7].quantities_0;
    var _S87 : u32 = families_0[family_7].colour_threads_0 + _S86 * stretch_2.low_0.thread_2 + quantity_0;
    var _S88 : u32 = families_0[family_7].colour_threads_0 + _S86 * stretch_2.high_0.thread_2 + quantity_0;
    var _S89 : u32 = families_0[family_7].colour_threads_0 + _S86 * u32(families_0[family_7].count_0) + quantity_0;
    var _S90 : f32 = table_number_0(_S87);
    var _S91 : f32 = table_number_0(_S88);
    var _S92 : f32 = Stretch_turns_0(stretch_2);
    var _S93 : u32 = u32(2) * families_0[family_7].quantities_0;
    return vec2<f32>(table_number_0(_S88 + families_0[family_7].quantities_0) - table_number_0(_S87 + families_0[family_7].quantities_0) + _S91 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_2 - _S90 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_2 + _S92 * table_number_0(_S89 + families_0[family_7].quantities_0), table_number_0(_S88 + _S93) - table_number_0(_S87 + _S93) + _S91 * stretch_2.high_0.cell_2 - _S90 * stretch_2.low_0.cell_2 + _S92 * table_number_0(_S89 + _S93));
}

fn Stretch_wraps_0( this_2 : Stretch_0) -> bool
{
    return (this_2.high_0.thread_2) < (this_2.low_0.thread_2);
}

fn Stretch_differences_0( this_3 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S94 : u32 = entries_0.z;
    var _S95 : u32 = entries_0.x;
    return vec4<u32>(_S94 - _S95 + select(u32(0), whole_0, Stretch_wraps_0(this_3)), entries_0.w - _S94, entries_0.y - _S95, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_1 : u32,  count_1 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S96 : u32 = row_1 + across_1.low_0.thread_2 * quantities_1;
    var _S97 : u32 = row_1 + across_1.high_0.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S96], words_0[_S96 + quantities_1], words_0[_S97], words_0[_S97 + quantities_1]), words_0[row_1 + count_1 * quantities_1]);
}

fn Stretch_weights_0( this_4 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_4.high_0.visible_0, - this_4.low_0.visible_0, Stretch_turns_0(this_4) - select(0.0f, 1.0f, Stretch_wraps_0(this_4)));
}

fn integral_on_top_0( family_8 : u32,  across_2 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S98 : u32 = u32(families_0[family_8].count_0);
    var _S99 : u32 = (_S98 + u32(1)) * families_0[family_8].quantities_0;
    var _S100 : u32 = families_0[family_8].colour_areas_0 + quantity_1;
    var _S101 : vec4<u32> = row_differences_0(across_2, _S100 + along_0.low_0.thread_2 * _S99, _S98, families_0[family_8].quantities_0);
    var _S102 : vec4<u32> = row_differences_0(across_2, _S100 + along_0.high_0.thread_2 * _S99, _S98, families_0[family_8].quantities_0);
    var _S103 : vec4<u32> = row_differences_0(across_2, _S100 + crossing_count_0 * _S99, _S98, families_0[family_8].quantities_0);
    var _S104 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S102 - _S101 + select_vector_2(Stretch_wraps_0(along_0), _S103, vec4<u32>(vec4<i32>(i32(0)))))), _S104), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S100 + (along_0.high_0.thread_2 + u32(1)) * _S99, _S98, families_0[family_8].quantities_0) - _S102)), _S104), dot(vec4<f32>(vec4<i32>(row_differences_0(across_2, _S100 + (along_0.low_0.thread_2 + u32(1)) * _S99, _S98, families_0[family_8].quantities_0) - _S101)), _S104), dot(vec4<f32>(vec4<i32>(_S103)), _S104)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_2 : u32) -> Albedos_0
{
    var _S105 : Albedos_0 = table_albedos_0(row_2);
    var sum_0 : Albedos_0;
    var _S106 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S106 * _S105.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S106 * _S105.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S106 * _S105.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S106 * _S105.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_9 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S107 : vec3<f32> = lengths_0(crossing_0, other_0);
    var is_exposed_0 : bool = false;
    var weight_1 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S108 : vec2<f32> = integrals_along_0(family_9, own_0, quantity_2);
        var _S109 : f32 = integral_on_top_0(family_9, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S110 : f32 = _S108.x;
        var _S111 : f32 = _S110 * _S107.x;
        var _S112 : f32 = select(_S109, _S111 - _S109, back_3);
        var _S113 : bool = quantity_2 == u32(0);
        if(_S113)
        {
            is_exposed_0 = _S112 > (16.0f * families_0[family_9].area_unit_0 * min(_S111 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S111);
        }
        var _S114 : f32 = _S110 * _S107.y + select(0.0f, _S112, is_exposed_0) + 0.000244140625f * _S107.z * _S108.y;
        if(_S113)
        {
            weight_1 = 1.0f / max(_S114, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S114 * weight_1, families_0[family_9].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn tinted_0( albedos_3 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
     warp_1 : vec3<f32>,
     weft_1 : vec3<f32>,
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
    var _S115 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S116 : vec3<f32> = sends_0.sky_warp_0 + _S115 * sends_0.crossing_warp_0;
    found_0.warp_1 = _S116;
    var _S117 : vec3<f32> = sends_0.sky_weft_0 + _S115 * sends_0.crossing_weft_0;
    found_0.weft_1 = _S117;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S116 + vec3<f32>(sends_0.blocks_weft_0) * _S117;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S118 : f32 = 1.0f - view_2.z;
    var _S119 : f32 = _S118 * _S118;
    (*terms_0)[i32(0)] = 1.0f;
    var _S120 : f32 = view_2.x;
    var _S121 : f32 = _S120 * _S120;
    var _S122 : f32 = view_2.y;
    var _S123 : f32 = _S122 * _S122;
    (*terms_0)[i32(1)] = sqrt(max(_S121 + _S123, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S119;
    (*terms_0)[i32(3)] = _S119 * _S119;
    (*terms_0)[i32(4)] = _S121 - _S123;
    (*terms_0)[i32(5)] = 0.0f;
    return;
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
     back_4 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S124 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S125 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_2 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_2) + _S125 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S125 * interior_0.far_1 + yarn_0.back_4 * _S124;
    return bounced_0;
}

fn summed_0( tables_1 : ptr<function, Clustered_std430_0>,  first_4 : u32,  column_0 : u32,  row_3 : u32) -> i32
{
    return i32(words_0[first_4 + (row_3 * ((*tables_1).columns_0 + u32(1)) + column_0) * (*tables_1).channels_0]);
}

fn box_mean_0( tables_2 : ptr<function, Clustered_std430_0>,  box_1 : TexelBox_0,  face_2 : u32,  channel_0 : u32) -> f32
{
    var _S126 : u32 = (*tables_2).columns_0;
    var _S127 : u32 = (*tables_2).rows_0;
    var _S128 : u32 = (*tables_2).sums_0 + face_2 * ((*tables_2).columns_0 + u32(1)) * ((*tables_2).rows_0 + u32(1)) * (*tables_2).channels_0 + channel_0;
    var _S129 : u32 = box_1.last_0.x;
    var _S130 : u32 = box_1.first_3.y;
    var _S131 : i32 = summed_0(&((*tables_2)), _S128, _S129, _S130);
    var _S132 : u32 = box_1.first_3.x;
    var _S133 : i32 = summed_0(&((*tables_2)), _S128, _S132, _S130);
    var _S134 : i32 = _S131 - _S133;
    var _S135 : u32 = box_1.last_0.y;
    var _S136 : i32 = summed_0(&((*tables_2)), _S128, _S129, _S135);
    var _S137 : i32 = summed_0(&((*tables_2)), _S128, _S132, _S135);
    var total_0 : f32 = f32(_S136 - _S137 - _S134);
    var _S138 : f32 = box_1.turns_0.x;
    var _S139 : bool = _S138 > 0.0f;
    var total_1 : f32;
    if(_S139)
    {
        var _S140 : i32 = summed_0(&((*tables_2)), _S128, _S126, _S135);
        var _S141 : i32 = summed_0(&((*tables_2)), _S128, _S126, _S130);
        total_1 = total_0 + _S138 * f32(_S140 - _S141);
    }
    else
    {
        total_1 = total_0;
    }
    var _S142 : f32 = box_1.turns_0.y;
    var _S143 : bool = _S142 > 0.0f;
    if(_S143)
    {
        var _S144 : i32 = summed_0(&((*tables_2)), _S128, _S129, _S127);
        var _S145 : i32 = summed_0(&((*tables_2)), _S128, _S132, _S127);
        total_1 = total_1 + _S142 * f32(_S144 - _S145);
    }
    if((_S139 & (_S143)))
    {
        var _S146 : f32 = _S138 * _S142;
        var _S147 : i32 = summed_0(&((*tables_2)), _S128, _S126, _S127);
        total_1 = total_1 + _S146 * f32(_S147);
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

fn box_mean_1( tables_3 : ptr<function, Clustered_std430_0>,  box_2 : TexelBox_0,  face_3 : u32,  channel_1 : u32) -> f32
{
    var _S148 : u32 = (*tables_3).columns_0;
    var _S149 : u32 = (*tables_3).rows_0;
    var _S150 : u32 = (*tables_3).sums_0 + face_3 * ((*tables_3).columns_0 + u32(1)) * ((*tables_3).rows_0 + u32(1)) * (*tables_3).channels_0 + channel_1;
    var _S151 : u32 = box_2.last_0.x;
    var _S152 : u32 = box_2.first_3.y;
    var _S153 : i32 = summed_0(&((*tables_3)), _S150, _S151, _S152);
    var _S154 : u32 = box_2.first_3.x;
    var _S155 : i32 = summed_0(&((*tables_3)), _S150, _S154, _S152);
    var _S156 : i32 = _S153 - _S155;
    var _S157 : u32 = box_2.last_0.y;
    var _S158 : i32 = summed_0(&((*tables_3)), _S150, _S151, _S157);
    var _S159 : i32 = summed_0(&((*tables_3)), _S150, _S154, _S157);
    var total_2 : f32 = f32(_S158 - _S159 - _S156);
    var _S160 : f32 = box_2.turns_0.x;
    var _S161 : bool = _S160 > 0.0f;
    var total_3 : f32;
    if(_S161)
    {
        var _S162 : i32 = summed_0(&((*tables_3)), _S150, _S148, _S157);
        var _S163 : i32 = summed_0(&((*tables_3)), _S150, _S148, _S152);
        total_3 = total_2 + _S160 * f32(_S162 - _S163);
    }
    else
    {
        total_3 = total_2;
    }
    var _S164 : f32 = box_2.turns_0.y;
    var _S165 : bool = _S164 > 0.0f;
    if(_S165)
    {
        var _S166 : i32 = summed_0(&((*tables_3)), _S150, _S151, _S149);
        var _S167 : i32 = summed_0(&((*tables_3)), _S150, _S154, _S149);
        total_3 = total_3 + _S164 * f32(_S166 - _S167);
    }
    if((_S161 & (_S165)))
    {
        var _S168 : f32 = _S160 * _S164;
        var _S169 : i32 = summed_0(&((*tables_3)), _S150, _S148, _S149);
        total_3 = total_3 + _S168 * f32(_S169);
    }
    return total_3 / (box_2.extent_0.x * box_2.extent_0.y);
}

struct ViewedBase_0
{
     view_3 : vec3<f32>,
     back_5 : bool,
     face_4 : u32,
     around_0 : BinTaps_0,
     box_3 : TexelBox_0,
     trust_1 : vec2<f32>,
};

struct FamilyAlbedos_0
{
     warp_3 : Albedos_0,
     weft_3 : Albedos_0,
};

struct ClusteredView_0
{
     base_0 : ViewedBase_0,
     albedos_4 : FamilyAlbedos_0,
     bounced_1 : Bounced_0,
     bounced_warp_0 : Bounced_0,
     bounced_weft_0 : Bounced_0,
     view_4 : vec3<f32>,
     is_alone_0 : bool,
};

fn bounced_by_base_0( seen_0 : ClusteredView_0,  shown_0 : vec2<f32>) -> Bounced_0
{
    var result_1 : Bounced_0;
    var _S170 : vec3<f32> = vec3<f32>(shown_0.x);
    var _S171 : vec3<f32> = vec3<f32>(shown_0.y);
    result_1.reflected_0 = _S170 * seen_0.bounced_warp_0.reflected_0 + _S171 * seen_0.bounced_weft_0.reflected_0;
    result_1.transmitted_0 = _S170 * seen_0.bounced_warp_0.transmitted_0 + _S171 * seen_0.bounced_weft_0.transmitted_0;
    return result_1;
}

fn Albedos_x24init_0( diffuse_reflect_1 : vec3<f32>,  diffuse_transmit_1 : vec3<f32>,  specular_reflect_1 : vec3<f32>,  specular_transmit_1 : vec3<f32>) -> Albedos_0
{
    var _S172 : Albedos_0;
    _S172.diffuse_reflect_0 = diffuse_reflect_1;
    _S172.diffuse_transmit_0 = diffuse_transmit_1;
    _S172.specular_reflect_0 = specular_reflect_1;
    _S172.specular_transmit_0 = specular_transmit_1;
    return _S172;
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_0 : bool,
     is_warp_0 : bool,
     x_7 : f32,
     y_2 : f32,
     height_2 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_0 : f32,
     roughness_1 : f32,
     albedos_5 : Albedos_0,
};

fn YarnPoint_x24init_0( back_7 : bool,  hole_1 : bool,  is_warp_1 : bool,  x_8 : f32,  y_3 : f32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  surface_normal_1 : vec3<f32>,  diffuse_gain_1 : f32,  roughness_2 : f32,  albedos_6 : Albedos_0) -> YarnPoint_0
{
    var _S173 : YarnPoint_0;
    _S173.back_6 = back_7;
    _S173.hole_0 = hole_1;
    _S173.is_warp_0 = is_warp_1;
    _S173.x_7 = x_8;
    _S173.y_2 = y_3;
    _S173.height_2 = height_3;
    _S173.normal_1 = normal_2;
    _S173.tangent_0 = tangent_1;
    _S173.surface_normal_0 = surface_normal_1;
    _S173.diffuse_gain_0 = diffuse_gain_1;
    _S173.roughness_1 = roughness_2;
    _S173.albedos_5 = albedos_6;
    return _S173;
}

fn Bounced_x24init_0( reflected_1 : vec3<f32>,  transmitted_1 : vec3<f32>) -> Bounced_0
{
    var _S174 : Bounced_0;
    _S174.reflected_0 = reflected_1;
    _S174.transmitted_0 = transmitted_1;
    return _S174;
}

struct ResidualPoint_0
{
     point_1 : YarnPoint_0,
     texel_0 : u32,
     bounced_2 : Bounced_0,
};

fn ResidualPoint_x24init_0( point_2 : YarnPoint_0,  texel_1 : u32,  bounced_3 : Bounced_0) -> ResidualPoint_0
{
    var _S175 : ResidualPoint_0;
    _S175.point_1 = point_2;
    _S175.texel_0 = texel_1;
    _S175.bounced_2 = bounced_3;
    return _S175;
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

struct Shown_0
{
     is_warp_2 : bool,
     hole_2 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_4 : Cell_0,
     weft_4 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_1 : Crossing_0,  back_8 : bool) -> Shown_0
{
    var _S176 : bool = (abs(crossing_1.warp_4.across_0)) < (crossing_1.warp_4.half_width_1);
    var shown_1 : Shown_0;
    var _S177 : bool = !((abs(crossing_1.weft_4.across_0)) < (crossing_1.weft_4.half_width_1));
    var _S178 : bool = (_S176 & (((_S177 | ((crossing_1.warp_above_0))))));
    shown_1.is_warp_2 = _S178;
    shown_1.hole_2 = ((!_S176) & (_S177));
    var _S179 : u32 = select(crossing_1.weft_word_0, crossing_1.warp_word_0, _S178);
    shown_1.word_0 = _S179;
    shown_1.on_top_0 = (((_S179 & (u32(1)))) == u32(1)) != back_8;
    return shown_1;
}

fn select_cell_0( is_first_0 : bool,  first_5 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    cell_3.thread_0 = select(second_0.thread_0, first_5.thread_0, is_first_0);
    cell_3.across_0 = select(second_0.across_0, first_5.across_0, is_first_0);
    cell_3.half_width_1 = select(second_0.half_width_1, first_5.half_width_1, is_first_0);
    cell_3.below_0 = select(second_0.below_0, first_5.below_0, is_first_0);
    cell_3.above_0 = select(second_0.above_0, first_5.above_0, is_first_0);
    return cell_3;
}

fn boundary_0( family_10 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S180 : vec2<f32> = turns_and_remainder_0(family_10, f32(i32(thread_3) + step_0));
    return fma(_S180.x, families_0[family_10].period_0, table_number_0(families_0[family_10].place_table_0 + u32(_S180.y) * u32(4)));
}

fn span_0( family_11 : u32,  thread_4 : u32,  first_6 : i32,  last_1 : i32) -> f32
{
    if((families_0[family_11].is_alike_0) != u32(0))
    {
        return f32(last_1 - first_6) * families_0[family_11].size_0;
    }
    return boundary_0(family_11, thread_4, last_1) - boundary_0(family_11, thread_4, first_6);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_12 : u32,  thread_5 : u32) -> Bend_0
{
    var _S181 : u32 = families_0[family_12].bend_table_0 + select(thread_5 * u32(4), u32(0), (families_0[family_12].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S181);
    bend_0.half_tangent_0 = table_number_0(_S181 + u32(1));
    bend_0.arc_0 = table_number_0(_S181 + u32(2));
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

fn unpack_0( own_1 : u32,  other_1 : u32,  thread_6 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S182 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S183 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S184 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S185 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S186 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S186;
    var _S187 : i32 = - _S182;
    var _S188 : f32 = crossed_0.below_0 + span_0(other_1, crossed_0.thread_0, _S187, i32(0));
    run_0.from_start_0 = _S188;
    var _S189 : i32 = _S183 + i32(1);
    var _S190 : f32 = crossed_0.above_0 + span_0(other_1, crossed_0.thread_0, i32(1), _S189);
    run_0.to_end_0 = _S190;
    var _S191 : bool = _S188 < _S190;
    run_0.near_start_0 = _S191;
    var _S192 : i32 = select(_S189, _S187 - _S184, _S191);
    var _S193 : i32 = select(_S189 + _S185, _S187, _S191);
    run_0.bend_1 = bend_of_0(own_1, thread_6);
    run_0.distance_0 = select(min(_S188, _S190), 1.0e+06f, _S186);
    run_0.reach_0 = min(0.5f * (_S188 + _S190), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_1, crossed_0.thread_0, _S192, _S193), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S182 == i32(0);
    run_0.last_crossing_0 = _S183 == i32(0);
    return run_0;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_4 : Cell_0) -> Section_0
{
    var _S194 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S195 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S195;
    var _S196 : f32 = _S194 * _S194 - square_1(_S195);
    var _S197 : f32 = rsqrt_0(_S196);
    section_0.drop_0 = _S194 - _S196 * _S197;
    section_0.slope_0 = - _S195 * _S197;
    return section_0;
}

fn edge_drop_0( family_13 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_13].bend_table_0 + select(u32(turns_and_remainder_0(family_13, f32(i32(thread_7) + step_1)).y) * u32(4), u32(0), (families_0[family_13].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_2 : u32,  shown_2 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S198 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S199 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S200 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S198) - crossed_1.half_width_1;
    var _S201 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S198);
    var _S202 : f32;
    if(shown_2.on_top_0)
    {
        _S202 = 0.0f;
    }
    else
    {
        _S202 = families_0[other_2].height_scale_0 * edge_drop_0(other_2, crossed_1.thread_0, i32(0));
    }
    var _S203 : f32;
    if((shown_2.on_top_0) != _S201)
    {
        _S203 = 0.0f;
    }
    else
    {
        _S203 = families_0[other_2].height_scale_0 * edge_drop_0(other_2, crossed_1.thread_0, select(i32(1), i32(-1), _S198));
    }
    var _S204 : f32 = 1.0f / max(2.0f * _S200, 9.999999960041972e-13f);
    var _S205 : f32 = clamp((_S200 - _S199) * _S204, 0.0f, 1.0f);
    return vec2<f32>(_S202 + (_S203 - _S202) * (_S205 * _S205 * (3.0f - 2.0f * _S205)), (_S202 - _S203) * (6.0f * _S205 * (1.0f - _S205) * _S204) * select(-1.0f, 1.0f, _S198));
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

fn step_control_0( direction_3 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S206 : f32 = direction_3.x;
    control_0.per_x_0 = 1.0f / max(abs(_S206), 9.99999971718068537e-10f);
    var _S207 : f32 = direction_3.y;
    control_0.per_y_0 = 1.0f / max(abs(_S207), 9.99999971718068537e-10f);
    control_0.right_0 = _S206 > 0.0f;
    control_0.up_0 = _S207 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
     clearance_0 : f32,
     rate_0 : f32,
     yarn_1 : u32,
     known_0 : bool,
};

fn no_previous_sample_0() -> PreviousSample_0
{
    var previous_0 : PreviousSample_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_1 = u32(0);
    previous_0.known_0 = false;
    return previous_0;
}

fn outline_distance_0( cell_5 : Cell_0,  shown_3 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S208 : f32 = select(- cell_5.across_0, cell_5.across_0, forwards_0);
    var _S209 : f32 = select(cell_5.below_0, cell_5.above_0, forwards_0);
    var _S210 : f32 = - cell_5.half_width_1;
    var _S211 : bool = _S208 < _S210;
    var _S212 : bool = _S208 >= (cell_5.half_width_1);
    var _S213 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_3.hole_2)));
    var _S214 : f32 = select(cell_5.half_width_1, _S210, _S211) - _S208;
    var _S215 : f32 = select(_S209, 2.0f * _S209 + _S208 - cell_5.half_width_1, ((shown_3.hole_2) | (((_S213 & ((!shown_3.on_top_0)))))));
    if((((_S213 & ((shown_3.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S211)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S214, _S215, _S212);
}

struct Probe_0
{
     height_4 : f32,
     hole_3 : bool,
     slope_x_0 : f32,
     slope_y_0 : f32,
     yarn_2 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_0 : Probe_0) -> f32
{
    var _S216 : f32 = previous_1.rate_0 * step_4;
    var _S217 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_3)))) | (((previous_1.yarn_1) != (here_0.yarn_2))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S216) >= 0.0f) & (((3.0f * clearance_1 - _S217) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S218 : f32 = clearance_1 - previous_1.clearance_0;
    var _S219 : f32 = 6.0f * _S218 - 4.0f * _S216 - 2.0f * _S217;
    var _S220 : f32 = -2.0f * _S216 / max(_S219 + sqrt(max(_S219 * _S219 - 4.0f * (3.0f * (_S216 + _S217 - 2.0f * _S218)) * _S216, 0.0f)), 9.99999968265522539e-21f);
    var _S221 : f32 = 1.0f - _S220;
    return select(-1.0f, _S221 * step_4, ((((_S220 > 0.01999999955296516f) & ((_S221 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S220 + 1.0f) + _S216 * _S220) * _S221 * _S221 + (clearance_1 * (2.0f * _S221 + 1.0f) - _S217 * _S221) * _S220 * _S220) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_1.hole_3);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_1 = here_1.yarn_2;
    previous_2.known_0 = ((!here_1.hole_3) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_5 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_5.per_x_0, side_y_1 * this_5.per_y_0), 0.0f) + this_5.epsilon_0;
}

fn StepControl_to_next_sample_0( this_6 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S222 : f32 = min(here_2.edge_x_0 * this_6.per_x_0, here_2.edge_y_0 * this_6.per_y_0);
    return min(this_6.step_2, select(max(_S222, 0.0f) + this_6.epsilon_0, _S222 - this_6.epsilon_0, ((((!here_2.hole_3) & (((rate_3 * _S222 + clearance_3) < 0.0f)))) & ((_S222 > (2.0f * this_6.epsilon_0))))));
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_7 : ViewRay_0,  height_5 : f32) -> vec2<f32>
{
    return this_7.origin_0 + this_7.slope_1 * vec2<f32>(height_5);
}

fn ViewRay_rate_0( this_8 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_8.slope_1.x + here_3.slope_y_0 * this_8.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S223 : f32 = end_0 - start_1;
    var _S224 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S223;
    var _S225 : f32 = 3.0f * _S223 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S223, 9.99999968265522539e-21f);
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
        var _S226 : f32 = clamp(share_1 - (((_S224 * share_1 + _S225) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S224 * share_1 + 2.0f * _S225) * share_1 + start_rate_0, 0.10000000149011612f * _S223 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S227 : i32 = i_0 + i32(1);
        share_1 = _S226;
        i_0 = _S227;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S228 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S229 : f32 = rsqrt_0(_S228);
    var _S230 : f32 = sine_1 * _S229 * rsqrt_0(_S228 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S230 * _S228, _S230 * across_slope_0 * along_slope_0 + cosine_0 * _S229);
}

fn arc_sine_0( x_9 : f32) -> f32
{
    var _S231 : f32 = abs(x_9);
    var _S232 : bool = _S231 > 0.5f;
    var _S233 : f32 = select(_S231 * _S231, 0.5f * (1.0f - _S231), _S232);
    var _S234 : f32 = select(_S231, sqrt(max(_S233, 0.0f)), _S232);
    var _S235 : f32 = ((((0.04216320067644119f * _S233 + 0.02418131195008755f) * _S233 + 0.04547002539038658f) * _S233 + 0.07495300471782684f) * _S233 + 0.16666752099990845f) * _S233 * _S234 + _S234;
    var _S236 : f32 = select(_S235, 1.57079637050628662f - 2.0f * _S235, _S232);
    return select(_S236, - _S236, x_9 < 0.0f);
}

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S237 : Hair_0;
    _S237.cover_0 = cover_1;
    _S237.normal_3 = normal_4;
    _S237.tangent_2 = tangent_3;
    return _S237;
}

fn fade_0( size_3 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_3 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S238 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S239 : u32 = ((((_S238 >> ((((_S238 >> (u32(28)))) + u32(4))))) ^ (_S238))) * u32(277803737);
    return (((_S239 >> (u32(22)))) ^ (_S239));
}

fn hash_key_0( thread_8 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_8 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_6 : u32) -> u32
{
    return scramble_0(cell_6 + key_0);
}

fn share_of_0( bits_2 : u32) -> f32
{
    return (f32((bits_2 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_10 : f32) -> vec2<f32>
{
    var _S240 : f32 = floor(x_10 * 0.63661974668502808f + 0.5f);
    var _S241 : f32 = x_10 - _S240 * 1.5703125f - _S240 * 0.00048375129699707f - _S240 * 7.54979012640433211e-08f;
    var _S242 : f32 = _S241 * _S241;
    var _S243 : f32 = ((-0.00019515295571182f * _S242 + 0.00833216123282909f) * _S242 - 0.16666655242443085f) * _S242 * _S241 + _S241;
    var _S244 : f32 = ((0.00002443315679557f * _S242 - 0.00138873164542019f) * _S242 + 0.04166664555668831f) * _S242 * _S242 - 0.5f * _S242 + 1.0f;
    var _S245 : u32 = (u32(i32(_S240)) & (u32(3)));
    var _S246 : vec2<f32> = select_vector_1(((_S245 & (u32(1)))) != u32(0), vec2<f32>(_S244, _S243), vec2<f32>(_S243, _S244));
    var _S247 : f32 = _S246.x;
    var _S248 : f32 = _S246.y;
    return vec2<f32>(select(_S247, - _S247, ((_S245 & (u32(2)))) != u32(0)), select(_S248, - _S248, (((_S245 + u32(1)) & (u32(2)))) != u32(0)));
}

fn albedos_of_0( family_14 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_14].albedo_table_0 + families_0[family_14].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_4 : f32,  along_1 : f32,  width_3 : f32) -> vec3<f32>
{
    var _S249 : f32 = floor(across_4 / width_3);
    return vec3<f32>(_S249, along_1 / (width_3 * 40.0f) + 0.61799997091293335f * _S249, 2.0f * (across_4 / width_3 - _S249) - 1.0f);
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_3 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_6 : f32,
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     across_5 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn ply_offset_0( family_15 : u32,  point_3 : SurfacePoint_0,  back_9 : bool) -> f32
{
    var _S250 : f32 = (point_3.fibre_across_0 * families_0[family_15].ply_cosine_0 + point_3.fibre_along_0 * select(families_0[family_15].ply_sine_0, - families_0[family_15].ply_sine_0, back_9)) * families_0[family_15].plies_per_mm_0;
    return 2.0f * (_S250 - floor(_S250)) - 1.0f;
}

fn signed_noise_0( bits_3 : u32) -> f32
{
    return (f32((bits_3 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_1 : u32,  position_5 : f32) -> vec2<f32>
{
    var _S251 : f32 = floor(position_5);
    var _S252 : f32 = position_5 - _S251;
    var _S253 : u32 = u32(i32(_S251));
    var _S254 : f32 = signed_noise_0(hash_bits_0(key_1, _S253));
    var _S255 : f32 = signed_noise_0(hash_bits_0(key_1, _S253 + u32(1)));
    return vec2<f32>(mix(_S254, _S255, smooth_share_0(_S252)), 6.0f * _S252 * (1.0f - _S252) * (_S255 - _S254));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S256 : f32 = cell_7.y;
    var _S257 : f32 = floor(_S256);
    var _S258 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S257));
    var _S259 : u32 = hash_bits_0(key_2, _S258);
    var _S260 : u32 = hash_bits_0(key_2, _S258 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S259), signed_noise_0((_S259 >> (u32(16))))), vec2<f32>(signed_noise_0(_S260), signed_noise_0((_S260 >> (u32(16))))), vec2<f32>(smooth_share_0(_S256 - _S257)));
}

fn uniform_hash_0( thread_10 : u32,  cell_8 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_10, stream_1), cell_8)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_11 : u32,  amount_0 : f32,  seed_2 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_11, u32(0), (seed_2 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S261 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S261.x, _S261.y), _S261.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S262 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S262.x, _S262.y), _S262.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_12 : u32,  cell_9 : u32,  amount_1 : f32,  seed_3 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_12, cell_9, (seed_3 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_6 : vec3<f32>,
     tangent_5 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S263 : vec3<f32> = select_vector_0((dot(frame_0.tangent_5, hair_0.tangent_2)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_2), hair_0.tangent_2);
    var blended_0 : YarnFrame_0;
    var _S264 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S265 : vec3<f32> = normalize(mix(frame_0.normal_6, hair_0.normal_3, _S264));
    blended_0.normal_6 = _S265;
    var _S266 : vec3<f32> = mix(frame_0.tangent_5, _S263, _S264);
    var _S267 : vec3<f32> = _S266 - vec3<f32>(dot(_S266, _S265)) * _S265;
    blended_0.tangent_5 = _S267 * vec3<f32>(rsqrt_0(max(dot(_S267, _S267), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_2( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_6.z - 1.0f) + 1.0f));
}

fn texel_along_0( share_3 : f32,  first_7 : u32,  extent_1 : f32,  count_2 : u32) -> u32
{
    var _S268 : f32 = min(floor(share_3 * extent_1), extent_1 - 1.0f);
    var _S269 : f32 = f32(count_2);
    var _S270 : u32 = first_7 + min(u32(max(_S268 - floor(_S268 / _S269) * _S269, 0.0f)), count_2 - u32(1));
    return select(_S270, _S270 - count_2, _S270 >= count_2);
}

fn texel_of_0( tables_4 : ptr<function, Clustered_std430_0>,  box_4 : TexelBox_0,  share_4 : vec2<f32>) -> u32
{
    return texel_along_0(share_4.y, box_4.first_3.y, box_4.extent_0.y, (*tables_4).rows_0) * (*tables_4).columns_0 + texel_along_0(share_4.x, box_4.first_3.x, box_4.extent_0.x, (*tables_4).columns_0);
}

fn table_byte_0( table_1 : u32,  index_4 : u32) -> u32
{
    return (((words_0[table_1 + index_4 / u32(4)] >> ((u32(8) * ((index_4 & (u32(3)))))))) & (u32(255)));
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_5 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S271 : u32 = pixel_0.x;
    var _S272 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S271, _S272, stream_2), uniform_hash_0(_S271, _S272, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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

fn choose_0( table_2 : u32,  count_3 : u32,  number_1 : f32) -> Choice_0
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
        var _S273 : u32 = (low_1 + high_1) / u32(2);
        if((scene_number_0(table_2 + _S273)) <= number_1)
        {
            low_1 = _S273;
        }
        else
        {
            high_1 = _S273;
        }
    }
    var _S274 : u32 = table_2 + low_1;
    var _S275 : f32 = scene_number_0(_S274);
    var _S276 : f32 = scene_number_0(_S274 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_1;
    choice_0.remainder_0 = saturate((number_1 - _S275) / max(_S276 - _S275, 9.999999960041972e-13f));
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

fn scene_light_0( first_8 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_8];
    record_1.x_11 = (bitcast<f32>((scene_words_0[first_8 + u32(1)])));
    record_1.y_4 = (bitcast<f32>((scene_words_0[first_8 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_8 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_8 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_8 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_8 + u32(6)])));
    return record_1;
}

struct BaseTaps_0
{
     facing_0 : vec3<f32>,
     transmits_1 : bool,
     around_1 : BinTaps_0,
     first_9 : u32,
     half_vector_0 : BinTaps_0,
};

fn base_taps_0( seen_1 : ViewedBase_0,  light_1 : vec3<f32>) -> BaseTaps_0
{
    var taps_1 : BaseTaps_0;
    var _S277 : vec3<f32> = to_face_frame_0(light_1, seen_1.back_5);
    taps_1.facing_0 = _S277;
    var _S278 : f32 = _S277.z;
    var _S279 : bool = _S278 < 0.0f;
    taps_1.transmits_1 = _S279;
    taps_1.around_1 = bin_taps_0(vec3<f32>(_S277.xy, abs(_S278)), u32(32));
    taps_1.first_9 = (seen_1.face_4 * u32(2) + select(u32(0), u32(1), _S279)) * u32(1024);
    var _S280 : vec3<f32> = _S277 + seen_1.view_3;
    var half_vector_1 : vec3<f32> = _S280 * vec3<f32>((1.0f / sqrt(max(square_0(_S280), 9.999999960041972e-13f))));
    taps_1.half_vector_0 = bin_taps_0(select_vector_0((half_vector_1.z) < 0.0f, (vec3<f32>(0) - half_vector_1), half_vector_1), u32(32));
    return taps_1;
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

fn no_components_0() -> Components_0
{
    var nothing_0 : Components_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_5 = 0.0f;
    return nothing_0;
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S281 : f32 = dot(direction_4, tangent_6);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S281 * _S281 + 1.0f, roughness_3 * roughness_3));
}

fn shaded_0( components_0 : Components_0,  albedos_7 : FamilyAlbedos_0,  transmits_2 : bool) -> vec3<f32>
{
    if(transmits_2)
    {
        return albedos_7.warp_3.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_7.weft_3.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_7.warp_3.specular_transmit_0 * vec3<f32>(components_0.specular_warp_0) + albedos_7.weft_3.specular_transmit_0 * vec3<f32>(components_0.specular_weft_0);
    }
    return albedos_7.warp_3.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_7.weft_3.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_7.warp_3.specular_reflect_0 * vec3<f32>(components_0.specular_warp_0) + albedos_7.weft_3.specular_reflect_0 * vec3<f32>(components_0.specular_weft_0);
}

fn bounced_value_0( bounced_4 : Bounced_0,  light_2 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S282 : f32 = light_2.z;
    return select_vector_0((_S282 * view_5.z) < 0.0f, bounced_4.transmitted_0, bounced_4.reflected_0) * vec3<f32>((abs(_S282) * 0.31830987334251404f));
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

fn sheen_lobe_0( cos_view_0 : f32,  roughness_4 : f32) -> vec3<f32>
{
    var _S283 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S284 : f32 = 2.0f * sqrt(_S283) - 1.0f;
    var _S285 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_4, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S284, _S285), 0.00999999977648258f, 1.0f), clamp((1.0f - _S283) * sheen_shear_0(_S284, _S285), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S284, _S285), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_6 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S286 : f32 = light_3.z;
    if(((_S286 <= 0.0f) | (((view_6.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S287 : vec2<f32> = view_6.xy;
    var _S288 : f32 = dot(_S287, _S287);
    var _S289 : vec2<f32> = select_vector_1(_S288 > 9.99999968265522539e-21f, _S287 * vec2<f32>(rsqrt_0(max(_S288, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S290 : f32 = scale_0 * dot(light_3.xy, _S289) + shear_0 * _S286;
    var _S291 : f32 = scale_0 * (light_3.y * _S289.x - light_3.x * _S289.y);
    var _S292 : f32 = _S290 * _S290 + _S291 * _S291 + _S286 * _S286;
    return 0.31830987334251404f * scale_0 * scale_0 * _S286 / max(_S292 * _S292, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_5 : f32) -> vec2<f32>
{
    var _S293 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_5);
    var _S294 : f32 = strength_0 * _S293.z;
    return vec2<f32>(_S294 * transformed_cosine_0(light_4, view_7, _S293.x, _S293.y), 1.0f - _S294);
}

fn diffuse_reflection_0( light_5 : vec3<f32>,  normal_7 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S295 : f32 = light_5.z;
    if(_S295 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S295, 0.0f), max(dot(light_5, normal_7), 0.0f), blend_1);
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn flake_density_0( squared_along_0 : f32,  roughness_6 : f32) -> f32
{
    var _S296 : f32 = roughness_6 * roughness_6;
    var _S297 : f32 = squared_along_0 * (1.0f - _S296) + _S296;
    return 0.31830987334251404f * _S296 * roughness_6 / (_S297 * _S297);
}

fn density_between_0( light_6 : vec3<f32>,  view_8 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_7 : f32) -> f32
{
    var _S298 : vec3<f32> = light_6 + view_8;
    var _S299 : f32 = dot(_S298, tangent_7);
    return flake_density_0(min(_S299 * _S299 / max(square_0(_S298), 9.999999960041972e-13f), 1.0f), roughness_7);
}

fn transmission_1( light_7 : vec3<f32>,  view_9 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_8 : f32,  optical_depth_1 : f32) -> f32
{
    var _S300 : f32 = - dot(light_7, normal_8);
    var _S301 : f32 = dot(view_9, normal_8);
    if(((_S300 <= 0.0f) | ((_S301 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S302 : f32 = 1.0f / max(_S301, 9.99999997475242708e-07f);
    var _S303 : f32 = projected_area_1(light_7, tangent_8, roughness_8) / max(_S300, 9.99999997475242708e-07f);
    var _S304 : f32 = projected_area_1(view_9, tangent_8, roughness_8) * _S302;
    return density_between_0(light_7, view_9, tangent_8, roughness_8) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S303, _S304)) * mean_attenuation_0(optical_depth_1 * abs(_S303 - _S304)) * _S302;
}

fn reflection_0( light_8 : vec3<f32>,  view_10 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_9 : f32,  optical_depth_2 : f32) -> f32
{
    var _S305 : f32 = dot(light_8, normal_9);
    var _S306 : f32 = dot(view_10, normal_9);
    if(((_S305 <= 0.0f) | ((_S306 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S307 : f32 = max(_S305, 9.99999997475242708e-07f);
    var _S308 : f32 = max(_S306, 9.99999997475242708e-07f);
    var _S309 : f32 = projected_area_1(light_8, tangent_9, roughness_9) * _S308 + projected_area_1(view_10, tangent_9, roughness_9) * _S307;
    var _S310 : f32 = optical_depth_2 * _S309 / (_S307 * _S308);
    return 0.25f * density_between_0(light_8, view_10, tangent_9, roughness_9) * (_S310 * mean_attenuation_0(_S310)) * _S307 / _S309;
}

fn accumulate_0( index_8 : u32,  light_9 : vec4<f32>)
{
    var _S311 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_9;
    layers_0[index_8].share_0 = _S311 * (1.0f - light_9.w);
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

fn face_point_0( _S312 : u32,  _S313 : u32,  _S314 : f32,  _S315 : f32) -> VisiblePoint_0
{
    var _S316 : u32 = u32(3) * _S313;
    var _S317 : Vertex_0 = vertex_at_0(_S316);
    var _S318 : Vertex_0 = vertex_at_0(_S316 + u32(1));
    var _S319 : Vertex_0 = vertex_at_0(_S316 + u32(2));
    var _S320 : vec3<f32> = position_of_0(_S317);
    var _S321 : vec3<f32> = position_of_0(_S318) - _S320;
    var _S322 : vec3<f32> = position_of_0(_S319) - _S320;
    var _S323 : f32 = _S318.u_0 - _S317.u_0;
    var _S324 : f32 = _S318.v_0 - _S317.v_0;
    var _S325 : vec2<f32> = vec2<f32>(_S323, _S324);
    var _S326 : f32 = _S319.u_0 - _S317.u_0;
    var _S327 : f32 = _S319.v_0 - _S317.v_0;
    var _S328 : vec2<f32> = vec2<f32>(_S326, _S327);
    var _S329 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S323 * _S327 - _S324 * _S326) < 0.0f));
    var _S330 : vec3<f32> = _S329 * (vec3<f32>(_S327) * _S321 - vec3<f32>(_S324) * _S322);
    var _S331 : vec3<f32> = _S329 * (vec3<f32>(_S323) * _S322 - vec3<f32>(_S326) * _S321);
    var point_4 : VisiblePoint_0;
    var _S332 : vec3<f32> = vec3<f32>(_S314);
    var _S333 : vec3<f32> = vec3<f32>(_S315);
    var _S334 : vec3<f32> = normalize(vec3<f32>((1.0f - _S314 - _S315)) * normal_of_0(_S317) + _S332 * normal_of_0(_S318) + _S333 * normal_of_0(_S319));
    point_4.normal_0 = _S334;
    var _S335 : vec3<f32> = normalize(_S330 - _S334 * vec3<f32>(dot(_S334, _S330)));
    point_4.axis_x_0 = _S335;
    point_4.axis_y_0 = cross(_S334, _S335);
    var _S336 : vec3<f32> = normalize(cross(_S321, _S322));
    point_4.face_normal_0 = select_vector_0((dot(_S336, _S334)) < 0.0f, (vec3<f32>(0) - _S336), _S336);
    point_4.position_0 = _S320 + _S332 * _S321 + _S333 * _S322;
    point_4.view_1 = _S334;
    var _S337 : vec2<f32> = vec2<f32>(_S317.u_0, _S317.v_0) + vec2<f32>(_S314) * _S325 + vec2<f32>(_S315) * _S328;
    point_4.uv_1 = _S337;
    var _S338 : bool = (dot(cross(_S330, _S331), _S334)) < 0.0f;
    var _S339 : vec2<f32> = vec2<f32>(fabrics_0[_S312].uv_width_0, select(fabrics_0[_S312].uv_height_0, - fabrics_0[_S312].uv_height_0, _S338));
    point_4.draft_per_uv_0 = _S339;
    point_4.draft_0 = _S337 * _S339 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S312].uv_height_0, _S338));
    var _S340 : vec2<f32> = vec2<f32>(0.0f);
    point_4.draft_dx_0 = _S340;
    point_4.draft_dy_0 = _S340;
    return point_4;
}

fn visible_point_0( _S341 : u32,  _S342 : u32,  _S343 : vec2<u32>) -> VisiblePoint_0
{
    var _S344 : u32 = u32(3) * _S342;
    var _S345 : Vertex_0 = vertex_at_0(_S344);
    var _S346 : Vertex_0 = vertex_at_0(_S344 + u32(1));
    var _S347 : Vertex_0 = vertex_at_0(_S344 + u32(2));
    var _S348 : vec3<f32> = position_of_0(_S345);
    var _S349 : vec3<f32> = position_of_0(_S346) - _S348;
    var _S350 : vec3<f32> = position_of_0(_S347) - _S348;
    var _S351 : vec3<f32> = cross(_S349, _S350);
    var _S352 : f32 = f32(frame_record_0.width_0);
    var _S353 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S352));
    var _S354 : f32 = f32(frame_record_0.height_0);
    var _S355 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S354));
    var _S356 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S343.x) + 0.5f - 0.5f * _S352)) * _S353 + vec3<f32>((f32(_S343.y) + 0.5f - 0.5f * _S354)) * _S355;
    var _S357 : f32 = dot(_S356, _S351);
    var _S358 : f32 = 1.0f / select(1.00000000317107685e-30f, _S357, (abs(_S357)) > 1.00000000317107685e-30f);
    var _S359 : vec3<f32> = _S348 - camera_origin_0();
    var _S360 : vec3<f32> = vec3<f32>((dot(_S359, _S351) * _S358));
    var _S361 : vec3<f32> = _S356 * _S360 - _S359;
    var _S362 : vec3<f32> = _S360 * (_S353 - _S356 * vec3<f32>((dot(_S353, _S351) * _S358)));
    var _S363 : vec3<f32> = _S360 * (_S355 - _S356 * vec3<f32>((dot(_S355, _S351) * _S358)));
    var _S364 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S351), 1.00000000317107685e-30f)));
    var _S365 : vec3<f32> = cross(_S350, _S351) * _S364;
    var _S366 : vec3<f32> = cross(_S351, _S349) * _S364;
    var _S367 : vec2<f32> = vec2<f32>(_S346.u_0 - _S345.u_0, _S346.v_0 - _S345.v_0);
    var _S368 : vec2<f32> = vec2<f32>(_S347.u_0 - _S345.u_0, _S347.v_0 - _S345.v_0);
    var point_5 : VisiblePoint_0 = face_point_0(_S341, _S342, dot(_S361, _S365), dot(_S361, _S366));
    point_5.position_0 = _S348 + _S361;
    point_5.view_1 = (vec3<f32>(0) - normalize(_S356));
    point_5.draft_dx_0 = (vec2<f32>(dot(_S362, _S365)) * _S367 + vec2<f32>(dot(_S362, _S366)) * _S368) * point_5.draft_per_uv_0;
    point_5.draft_dy_0 = (vec2<f32>(dot(_S363, _S365)) * _S367 + vec2<f32>(dot(_S363, _S366)) * _S368) * point_5.draft_per_uv_0;
    return point_5;
}

fn filtered_albedo_0( _S369 : u32,  _S370 : VisiblePoint_0) -> vec3<f32>
{
    var _S371 : u32 = fabrics_0[_S369].albedo_map_levels_0;
    if((fabrics_0[_S369].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S372 : vec2<f32> = vec2<f32>(fabrics_0[_S369].uv_width_0, fabrics_0[_S369].uv_height_0);
    var _S373 : vec2<f32> = _S370.draft_dx_0 / _S372;
    var _S374 : vec2<f32> = _S370.draft_dy_0 / _S372;
    var _S375 : u32 = _S371 - u32(1);
    var _S376 : u32 = (u32(1) << (_S375));
    var _S377 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S373.x * _S374.y - _S373.y * _S374.x), 9.99999968265522539e-21f) * (square_1(f32(_S376)) / 3.0f)), 0.0f, f32(_S371) - 1.0f);
    var _S378 : u32 = min(u32(_S377), max(_S371, u32(2)) - u32(2));
    var _S379 : u32 = min(_S378 + u32(1), _S375);
    var _S380 : u32 = (u32(1) << ((u32(2) * _S371)));
    return mix(map_level_0(fabrics_0[_S369].albedo_map_0 + (_S380 - ((_S380 >> ((u32(2) * _S378))))) / u32(3), (_S376 >> (_S378)), _S370.uv_1), map_level_0(fabrics_0[_S369].albedo_map_0 + (_S380 - ((_S380 >> ((u32(2) * _S379))))) / u32(3), (_S376 >> (_S379)), _S370.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S377 - f32(_S378))) - 1.0f) / 3.0f)));
}

fn viewed_base_0( _S381 : u32,  _S382 : Footprint_0,  _S383 : vec3<f32>,  _S384 : f32,  _S385 : bool) -> ViewedBase_0
{
    var seen_2 : ViewedBase_0;
    var _S386 : bool = (_S383.z) < 0.0f;
    seen_2.back_5 = _S386;
    var _S387 : vec3<f32> = to_face_frame_0(_S383, _S386);
    seen_2.view_3 = _S387;
    var _S388 : u32 = select(u32(0), u32(1), _S386);
    seen_2.face_4 = _S388;
    var _S389 : BinTaps_0 = bin_taps_0(_S387, u32(16));
    seen_2.around_0 = _S389;
    var _S390 : u32 = _S388 * u32(256);
    var _S391 : Clustered_std430_0 = fabrics_0[_S381].clustered_0;
    var _S392 : TexelBox_0 = texel_box_0(&(_S391), _S382, vec2<f32>(BinTaps_read_0(_S389, _S391.offset_1, _S390, u32(2), u32(0)), BinTaps_read_0(_S389, _S391.offset_1, _S390, u32(2), u32(1))), _S384 - 0.5f);
    seen_2.box_3 = _S392;
    seen_2.trust_1 = vec2<f32>(1.0f);
    if(!_S385)
    {
        seen_2.trust_1 = vec2<f32>(BinTaps_read_0(seen_2.around_0, _S391.trust_0, _S390, u32(2), u32(0)), BinTaps_read_0(seen_2.around_0, _S391.trust_0, _S390, u32(2), u32(1)));
    }
    return seen_2;
}

fn albedos_over_0( _S393 : u32,  _S394 : Footprint_0,  _S395 : bool) -> FamilyAlbedos_0
{
    var _S396 : vec2<f32> = _S394.dx_0;
    var _S397 : vec2<f32> = _S394.dy_0;
    var _S398 : vec2<f32> = sqrt(_S396 * _S396 + _S397 * _S397);
    var _S399 : Stretch_0 = stretch_of_0(fabrics_0[_S393].warp_0, _S394.centre_0.x, _S398.x);
    var _S400 : Stretch_0 = stretch_of_0(fabrics_0[_S393].weft_0, _S394.centre_0.y, _S398.y);
    var albedos_8 : FamilyAlbedos_0;
    albedos_8.warp_3 = mean_albedos_0(fabrics_0[_S393].warp_0, fabrics_0[_S393].weft_0, _S399, _S400, _S395);
    albedos_8.weft_3 = mean_albedos_0(fabrics_0[_S393].weft_0, fabrics_0[_S393].warp_0, _S400, _S399, _S395);
    return albedos_8;
}

fn openness_number_0( _S401 : u32,  _S402 : u32) -> f32
{
    return table_number_0(fabrics_0[_S401].openness_0 + _S402);
}

fn scattered_by_0( _S403 : u32,  _S404 : Albedos_0,  _S405 : u32,  _S406 : vec3<f32>) -> Scattered_0
{
    var _S407 : u32 = u32(159) + u32(2) * _S405;
    var yarn_3 : Scattered_0;
    yarn_3.back_4 = _S406 * _S404.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S403, _S407)) * _S404.specular_reflect_0;
    yarn_3.through_0 = _S406 * _S404.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S403, _S407 + u32(1))) * _S404.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S408 : u32,  _S409 : u32,  _S410 : vec3<f32>,  _S411 : vec3<f32>,  _S412 : vec3<f32>,  _S413 : vec3<f32>,  _S414 : ptr<function, vec3<f32>>,  _S415 : ptr<function, vec3<f32>>)
{
    var _S416 : u32 = u32(146) + u32(4) * _S409;
    var _S417 : f32 = openness_number_0(_S408, _S416 + u32(1));
    var _S418 : f32 = openness_number_0(_S408, _S416 + u32(2));
    var _S419 : vec3<f32> = vec3<f32>(1.0f);
    var _S420 : vec3<f32> = _S419 - _S412 * vec3<f32>(openness_number_0(_S408, _S416));
    var _S421 : vec3<f32> = _S419 - _S413 * vec3<f32>(openness_number_0(_S408, _S416 + u32(3)));
    var _S422 : vec3<f32> = _S419 / (_S420 * _S421 - _S412 * _S413 * vec3<f32>((_S417 * _S418)));
    (*_S414) = (_S410 * _S421 + _S412 * vec3<f32>(_S417) * _S411) * _S422;
    (*_S415) = (_S411 * _S420 + _S413 * vec3<f32>(_S418) * _S410) * _S422;
    return;
}

fn face_sends_0( _S423 : u32,  _S424 : u32,  _S425 : Scattered_0,  _S426 : Scattered_0) -> FaceSends_0
{
    var _S427 : u32 = u32(2) * _S424;
    var _S428 : u32 = u32(142) + _S427;
    var _S429 : f32 = openness_number_0(_S423, _S428);
    var _S430 : f32 = openness_number_0(_S423, _S428 + u32(1));
    var _S431 : vec3<f32> = vec3<f32>((1.0f - _S429)) * _S425.back_4;
    var _S432 : vec3<f32> = vec3<f32>((1.0f - _S430)) * _S426.back_4;
    var sends_1 : FaceSends_0;
    var _S433 : u32 = u32(154) + _S427;
    var _S434 : f32 = openness_number_0(_S423, _S433);
    sends_1.blocks_warp_0 = _S434;
    var _S435 : f32 = openness_number_0(_S423, _S433 + u32(1));
    sends_1.blocks_weft_0 = _S435;
    sends_1.open_0 = _S434 * _S429 + _S435 * _S430;
    var _S436 : vec3<f32> = vec3<f32>(_S429) * _S425.back_4;
    var _S437 : vec3<f32> = vec3<f32>(_S430) * _S426.back_4;
    var _S438 : vec3<f32> = sends_1.sky_warp_0;
    var _S439 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S423, _S424, _S436, _S437, _S431, _S432, &(_S438), &(_S439));
    sends_1.sky_warp_0 = _S438;
    sends_1.sky_weft_0 = _S439;
    var _S440 : vec3<f32> = sends_1.crossing_warp_0;
    var _S441 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S423, _S424, _S425.through_0, _S426.through_0, _S431, _S432, &(_S440), &(_S441));
    sends_1.crossing_warp_0 = _S440;
    sends_1.crossing_weft_0 = _S441;
    return sends_1;
}

fn interior_of_0( _S442 : u32,  _S443 : vec3<f32>,  _S444 : bool) -> Interior_0
{
    var _S445 : Scattered_0 = scattered_by_0(_S442, table_albedos_0(families_0[fabrics_0[_S442].warp_0].colour_mean_0), u32(0), _S443);
    var _S446 : Scattered_0 = scattered_by_0(_S442, table_albedos_0(families_0[fabrics_0[_S442].weft_0].colour_mean_0), u32(1), _S443);
    var _S447 : FaceSends_0 = face_sends_0(_S442, select(u32(0), u32(1), _S444), _S445, _S446);
    var _S448 : FaceSends_0 = face_sends_0(_S442, select(u32(1), u32(0), _S444), _S445, _S446);
    var _S449 : vec3<f32> = vec3<f32>(_S447.blocks_warp_0);
    var _S450 : vec3<f32> = vec3<f32>(_S447.blocks_weft_0);
    var _S451 : vec3<f32> = _S449 * _S447.crossing_warp_0 + _S450 * _S447.crossing_weft_0;
    var _S452 : vec3<f32> = vec3<f32>(_S448.blocks_warp_0);
    var _S453 : vec3<f32> = vec3<f32>(_S448.blocks_weft_0);
    var _S454 : vec3<f32> = _S452 * _S448.crossing_warp_0 + _S453 * _S448.crossing_weft_0;
    var _S455 : f32 = 1.0f - _S447.open_0;
    var _S456 : f32 = 1.0f - _S448.open_0;
    var _S457 : vec3<f32> = vec3<f32>(1.0f);
    var _S458 : vec3<f32> = _S457 / (_S457 - _S451 * _S454 * vec3<f32>((_S455 * _S456)));
    var _S459 : vec3<f32> = _S454 * (vec3<f32>(_S447.open_0) + vec3<f32>(_S455) * (_S449 * _S447.sky_warp_0 + _S450 * _S447.sky_weft_0)) * _S458;
    var _S460 : vec3<f32> = _S451 * (vec3<f32>(_S448.open_0) + vec3<f32>(_S456) * (_S452 * _S448.sky_warp_0 + _S453 * _S448.sky_weft_0)) * _S458;
    var _S461 : FaceRadiance_0 = face_radiance_0(_S447, _S448.open_0, _S459, _S460);
    var _S462 : FaceRadiance_0 = face_radiance_0(_S448, _S447.open_0, _S460, _S459);
    var interior_1 : Interior_0;
    interior_1.warp_2 = _S461.warp_1;
    interior_1.weft_2 = _S461.weft_1;
    interior_1.leaked_1 = _S461.leaked_0;
    interior_1.far_1 = _S462.mean_0;
    interior_1.far_leaked_0 = _S462.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S463 : u32,  _S464 : u32,  _S465 : array<f32, i32(6)>,  _S466 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_5 : u32 = u32(0);
    for(;;)
    {
        if(share_5 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_5] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S466)
            {
            }
            else
            {
                break;
            }
            shares_0[share_5] = shares_0[share_5] + openness_number_0(_S463, _S464 + share_5 * _S466 + term_0) * _S465[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_5] = saturate(shares_0[share_5]);
        share_5 = share_5 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_from_0( _S467 : u32,  _S468 : vec3<f32>,  _S469 : bool,  _S470 : bool) -> Blocked_0
{
    var terms_1 : array<f32, i32(6)>;
    view_terms_0(_S468, &(terms_1));
    return blocked_of_terms_0(_S467, (select(u32(0), u32(2), _S470) + select(u32(1), u32(0), _S469)) * u32(15), terms_1, u32(5));
}

fn family_share_0( _S471 : u32,  _S472 : u32,  _S473 : f32) -> vec2<f32>
{
    var _S474 : bool = _S472 < (fabrics_0[_S471].clustered_0.clusters_0 / u32(2));
    return vec2<f32>(select(0.0f, _S473, _S474), select(_S473, 0.0f, _S474));
}

fn clustered_shown_0( _S475 : u32,  _S476 : ViewedBase_0) -> vec2<f32>
{
    var _S477 : Clustered_std430_0 = fabrics_0[_S475].clustered_0;
    var _S478 : u32 = _S477.clusters_0;
    var _S479 : u32 = _S476.face_4 * u32(256);
    var _S480 : vec2<f32> = vec2<f32>(0.0f);
    var cluster_0 : u32 = u32(0);
    var shown_4 : vec2<f32> = _S480;
    for(;;)
    {
        if(cluster_0 < _S478)
        {
        }
        else
        {
            break;
        }
        var _S481 : f32 = box_mean_0(&(_S477), _S476.box_3, _S476.face_4, cluster_0);
        if(_S481 > 0.0f)
        {
            shown_4 = shown_4 + family_share_0(_S475, cluster_0, _S476.trust_1.x * _S481 * BinTaps_read_0(_S476.around_0, _S477.view_0, _S479, _S478, cluster_0));
        }
        cluster_0 = cluster_0 + u32(1);
    }
    return shown_4;
}

fn clustered_view_0( _S482 : u32,  _S483 : Footprint_0,  _S484 : vec3<f32>,  _S485 : vec3<f32>,  _S486 : u32,  _S487 : bool) -> ClusteredView_0
{
    var seen_3 : ClusteredView_0;
    seen_3.base_0 = viewed_base_0(_S482, _S483, _S484, uniform_of_0(_S486, u32(0)), _S487);
    seen_3.view_4 = _S484;
    seen_3.is_alone_0 = _S487;
    var _S488 : FamilyAlbedos_0 = albedos_over_0(_S482, _S483, seen_3.base_0.back_5);
    seen_3.albedos_4.warp_3 = tinted_0(_S488.warp_3, _S485);
    seen_3.albedos_4.weft_3 = tinted_0(_S488.weft_3, _S485);
    var _S489 : vec3<f32> = vec3<f32>(0.0f);
    seen_3.bounced_warp_0.reflected_0 = _S489;
    seen_3.bounced_warp_0.transmitted_0 = _S489;
    seen_3.bounced_weft_0 = seen_3.bounced_warp_0;
    seen_3.bounced_1 = seen_3.bounced_warp_0;
    if((fabrics_0[_S482].openness_0) == u32(4294967295))
    {
        return seen_3;
    }
    var _S490 : Interior_0 = interior_of_0(_S482, _S485, seen_3.base_0.back_5);
    seen_3.bounced_warp_0 = bounced_by_0(blocked_from_0(_S482, seen_3.base_0.view_3, true, seen_3.base_0.back_5), scattered_by_0(_S482, _S488.warp_3, u32(0), _S485), _S490);
    seen_3.bounced_weft_0 = bounced_by_0(blocked_from_0(_S482, seen_3.base_0.view_3, false, seen_3.base_0.back_5), scattered_by_0(_S482, _S488.weft_3, u32(1), _S485), _S490);
    seen_3.bounced_1 = bounced_by_base_0(seen_3, clustered_shown_0(_S482, seen_3.base_0));
    return seen_3;
}

fn clustered_hole_0( _S491 : u32,  _S492 : ViewedBase_0) -> f32
{
    var cluster_1 : u32 = u32(0);
    var covered_0 : f32 = 0.0f;
    for(;;)
    {
        var _S493 : Clustered_std430_0 = fabrics_0[_S491].clustered_0;
        if(cluster_1 < (_S493.clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S494 : f32 = box_mean_1(&(_S493), _S492.box_3, _S492.face_4, cluster_1);
        var covered_1 : f32 = covered_0 + _S494;
        cluster_1 = cluster_1 + u32(1);
        covered_0 = covered_1;
    }
    return clamp(1.0f - covered_0, 0.0f, 1.0f);
}

struct Hit_0
{
     x_15 : f32,
     y_8 : f32,
     hole_6 : bool,
     height_7 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_5 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_8 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S495 : u32,  _S496 : f32,  _S497 : f32,  _S498 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_4 = locate_0(fabrics_0[_S495].warp_0, _S496);
    crossing_3.weft_4 = locate_0(fabrics_0[_S495].weft_0, _S497);
    var _S499 : u32 = fabrics_0[_S495].run_words_0 + u32(2) * (crossing_3.weft_4.thread_0 * fabrics_0[_S495].ends_1 + crossing_3.warp_4.thread_0);
    var _S500 : u32 = words_0[_S499];
    crossing_3.warp_word_0 = _S500;
    crossing_3.weft_word_0 = words_0[_S499 + u32(1)];
    crossing_3.warp_above_0 = (((_S500 & (u32(1)))) == u32(1)) != _S498;
    return crossing_3;
}

fn sample_at_0( _S501 : u32,  _S502 : f32,  _S503 : f32,  _S504 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S505 : Crossing_0 = crossing_at_0(_S501, _S502, _S503, _S504);
    sample_0.crossing_2 = _S505;
    var _S506 : Shown_0 = shown_at_0(_S505, _S504);
    sample_0.shown_5 = _S506;
    var _S507 : u32 = select(fabrics_0[_S501].weft_0, fabrics_0[_S501].warp_0, _S506.is_warp_2);
    var _S508 : u32 = select(fabrics_0[_S501].warp_0, fabrics_0[_S501].weft_0, _S506.is_warp_2);
    var _S509 : Cell_0 = select_cell_0(_S506.is_warp_2, sample_0.crossing_2.warp_4, sample_0.crossing_2.weft_4);
    var _S510 : Cell_0 = select_cell_0(_S506.is_warp_2, sample_0.crossing_2.weft_4, sample_0.crossing_2.warp_4);
    var _S511 : Run_0 = unpack_0(_S507, _S508, _S509.thread_0, _S510, _S506.word_0);
    var _S512 : Section_0 = section_at_0(_S509);
    var _S513 : bool = ((_S506.on_top_0) & (((_S511.distance_0) < (_S512.drop_0 * _S511.bend_1.sine_0))));
    var _S514 : f32 = select(-1.0f, 1.0f, ((_S506.on_top_0) & ((!_S513))));
    var _S515 : f32 = select(_S511.reach_0, _S511.other_reach_0, _S513);
    var _S516 : f32 = select(max(_S515 - _S511.distance_0, 0.0f), _S515 + _S511.distance_0, _S513);
    var _S517 : f32 = _S515 / _S511.bend_1.sine_0 - _S514 * _S512.drop_0;
    var _S518 : f32 = _S516 * _S516;
    var _S519 : f32 = max(_S517 * _S517 - _S518, 9.99999968265522539e-21f);
    var _S520 : f32 = rsqrt_0(_S519);
    var _S521 : f32 = _S518 / (_S519 * _S520 + _S517);
    var _S522 : bool = _S516 > 0.0f;
    var _S523 : f32 = select(-1.0f, 1.0f, _S506.on_top_0) * select(-1.0f, 1.0f, _S511.near_start_0);
    var _S524 : f32 = _S512.slope_0 * select(1.0f, _S517 * _S520, _S522);
    sample_0.slope_across_0 = _S524;
    var _S525 : f32 = select(0.0f, _S523 * _S516 * _S520, _S522);
    sample_0.slope_along_0 = _S525;
    var _S526 : vec2<f32> = dive_0(_S508, _S506, _S511, _S510);
    sample_0.height_8 = select(families_0[_S507].height_scale_0 * _S514, 0.0f, _S511.straight_0) * (_S515 * _S511.bend_1.half_tangent_0 - _S521) - families_0[_S507].height_scale_0 * _S512.drop_0 - _S526.x;
    var _S527 : f32 = families_0[_S507].height_scale_0 * _S524;
    var _S528 : f32 = families_0[_S507].height_scale_0 * _S525 - _S526.y;
    sample_0.slope_x_1 = select(_S528, _S527, _S506.is_warp_2);
    sample_0.slope_y_1 = select(_S527, _S528, _S506.is_warp_2);
    sample_0.run_3 = _S511;
    sample_0.section_1 = _S512;
    return sample_0;
}

fn steps_per_length_0( _S529 : u32,  _S530 : SearchQuality_0,  _S531 : vec3<f32>) -> f32
{
    return max(max(abs(_S531.x) * fabrics_0[_S529].threads_per_x_0, abs(_S531.y) * fabrics_0[_S529].threads_per_y_0) * _S530.steps_per_thread_0, abs(_S531.z) * fabrics_0[_S529].per_relief_0 * _S530.steps_per_relief_0);
}

fn cell_maximum_0( _S532 : u32,  _S533 : Crossing_0) -> f32
{
    var _S534 : u32 = select(fabrics_0[_S532].weft_0, fabrics_0[_S532].warp_0, _S533.warp_above_0);
    return f32((select(_S533.weft_word_0, _S533.warp_word_0, _S533.warp_above_0) >> (u32(28)))) * families_0[_S534].height_scale_0 * families_0[_S534].level_0;
}

fn probe_0( _S535 : u32,  _S536 : f32,  _S537 : f32,  _S538 : bool,  _S539 : bool,  _S540 : bool) -> Probe_0
{
    var _S541 : Sample_0 = sample_at_0(_S535, _S536, _S537, _S538);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S541.height_8;
    probe_1.hole_3 = _S541.shown_5.hole_2;
    probe_1.slope_x_0 = _S541.slope_x_1;
    probe_1.slope_y_0 = _S541.slope_y_1;
    probe_1.yarn_2 = select(_S541.crossing_2.weft_4.thread_0 * u32(2), _S541.crossing_2.warp_4.thread_0 * u32(2) + u32(1), _S541.shown_5.is_warp_2);
    probe_1.cell_max_0 = cell_maximum_0(_S535, _S541.crossing_2);
    probe_1.side_x_0 = select(_S541.crossing_2.warp_4.below_0, _S541.crossing_2.warp_4.above_0, _S539);
    probe_1.side_y_0 = select(_S541.crossing_2.weft_4.below_0, _S541.crossing_2.weft_4.above_0, _S540);
    probe_1.edge_x_0 = outline_distance_0(_S541.crossing_2.warp_4, _S541.shown_5, _S541.run_3, !_S541.shown_5.is_warp_2, _S539);
    probe_1.edge_y_0 = outline_distance_0(_S541.crossing_2.weft_4, _S541.shown_5, _S541.run_3, _S541.shown_5.is_warp_2, _S540);
    return probe_1;
}

fn is_free_0( _S542 : u32,  _S543 : SearchQuality_0,  _S544 : vec3<f32>,  _S545 : vec3<f32>,  _S546 : bool,  _S547 : f32) -> bool
{
    var _S548 : f32 = _S545.z;
    if(_S548 <= 0.0f)
    {
        return false;
    }
    var _S549 : f32 = 1.0f / max(_S543.shadow_share_0 * steps_per_length_0(_S542, _S543, _S545), 9.99999971718068537e-10f);
    var _S550 : StepControl_0 = step_control_0(_S545.xy, _S549);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S544.z + _S548 * distance_1) < _S547))))
        {
        }
        else
        {
            break;
        }
        var _S551 : vec3<f32> = _S544 + _S545 * vec3<f32>(distance_1);
        var _S552 : Probe_0 = probe_0(_S542, _S551.x, _S551.y, _S546, _S550.right_0, _S550.up_0);
        var _S553 : f32 = _S551.z;
        var _S554 : f32 = _S553 - _S552.height_4;
        var _S555 : f32 = _S548 - _S552.slope_x_0 * _S545.x - _S552.slope_y_0 * _S545.y;
        if(((!_S552.hole_3) & ((_S554 < 0.0f))))
        {
            return false;
        }
        var _S556 : f32 = way_back_to_dip_0(previous_3, _S554, _S555, last_step_0, _S552);
        if(_S556 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S556;
            distance_1 = distance_1 - _S556;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S557 : bool = _S553 > (_S552.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S550, _S552, _S554, _S555), max(StepControl_to_cell_exit_0(_S550, _S552.side_x_0, _S552.side_y_0), _S549), _S557);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S554, _S555, _S552, _S557);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S558 : u32,  _S559 : SearchQuality_0,  _S560 : f32,  _S561 : f32,  _S562 : vec3<f32>,  _S563 : bool) -> bool
{
    if(!sample_at_0(_S558, _S560, _S561, _S563).shown_5.hole_2)
    {
        return false;
    }
    var _S564 : vec3<f32> = vec3<f32>(_S560, _S561, 0.0f);
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
        var _S565 : bool = is_free_0(_S558, _S559, _S564, select_vector_0(side_1 == u32(0), _S562, vec3<f32>(- _S562.x, - _S562.y, _S562.z)), _S563 != (side_1 == u32(1)), fabrics_0[_S558].height_high_0);
        var _S566 : u32 = side_1 + u32(1);
        passes_0 = _S565;
        side_1 = _S566;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_9 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S567 : u32,  _S568 : f32,  _S569 : f32,  _S570 : f32,  _S571 : vec3<f32>,  _S572 : bool) -> f32
{
    var _S573 : f32 = _S571.x;
    var _S574 : f32 = _S571.y;
    var _S575 : u32 = (words_0[fabrics_0[_S567].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S567].weft_0, _S569).thread_0 / u32(2) * fabrics_0[_S567].max_height_columns_0 + locate_0(fabrics_0[_S567].warp_0, _S568).thread_0 / u32(2)) + (select(u32(0), u32(1), _S573 > 0.0f) + select(u32(0), u32(2), _S574 > 0.0f))] >> (u32(select(i32(0), i32(4), _S572))));
    var _S576 : f32 = max(abs(_S573) * fabrics_0[_S567].threads_per_x_0, abs(_S574) * fabrics_0[_S567].threads_per_y_0) / _S571.z;
    var _S577 : f32 = fabrics_0[_S567].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S567].height_high_0;
    var number_2 : i32 = i32(3);
    for(;;)
    {
        if(number_2 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S570) * _S576) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, f32((((_S575 >> (u32(i32(8) * number_2)))) & (u32(15)))) * 0.06666667014360428f * _S577);
        }
        number_2 = number_2 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S578 : u32,  _S579 : f32,  _S580 : f32,  _S581 : bool,  _S582 : bool,  _S583 : bool) -> vec3<f32>
{
    var _S584 : Crossing_0 = crossing_at_0(_S578, _S579, _S580, _S581);
    return vec3<f32>(cell_maximum_0(_S578, _S584), select(_S584.warp_4.below_0, _S584.warp_4.above_0, _S582), select(_S584.weft_4.below_0, _S584.weft_4.above_0, _S583));
}

fn first_sample_height_0( _S585 : u32,  _S586 : ViewRay_0,  _S587 : StepControl_0,  _S588 : bool) -> f32
{
    var _S589 : f32 = max_height_along_0(_S585, _S586.origin_0.x, _S586.origin_0.y, 0.0f, vec3<f32>(_S586.slope_1, 1.0f), _S588);
    var count_5 : u32 = u32(0);
    var height_10 : f32 = _S589;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S590 : vec2<f32> = ViewRay_at_0(_S586, height_10);
        var _S591 : vec3<f32> = cell_bounds_0(_S585, _S590.x, _S590.y, _S588, _S587.right_0, _S587.up_0);
        var _S592 : f32 = height_10 - _S591.x;
        var _S593 : f32 = StepControl_to_cell_exit_0(_S587, _S591.y, _S591.z);
        var height_11 : f32 = height_10 - clamp(_S592, 0.0f, _S593);
        if(_S592 <= _S593)
        {
            height_10 = height_11;
            break;
        }
        count_5 = count_5 + u32(1);
        height_10 = height_11;
    }
    return height_10;
}

fn search_down_0( _S594 : u32,  _S595 : ViewRay_0,  _S596 : StepControl_0,  _S597 : bool) -> ViewRayEnd_0
{
    var _S598 : f32 = fabrics_0[_S594].height_low_0 - (fabrics_0[_S594].height_high_0 - fabrics_0[_S594].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_9 = first_sample_height_0(_S594, _S595, _S596, _S597);
    end_1.last_step_3 = _S596.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
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
        var _S599 : vec2<f32> = ViewRay_at_0(_S595, end_1.height_9);
        var _S600 : Probe_0 = probe_0(_S594, _S599.x, _S599.y, _S597, _S596.right_0, _S596.up_0);
        var _S601 : f32 = end_1.height_9 - _S600.height_4;
        var _S602 : f32 = ViewRay_rate_0(_S595, _S600);
        end_1.depth_1 = - _S601;
        end_1.rate_4 = _S602;
        var _S603 : bool = !_S600.hole_3;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S603))) & (((end_1.previous_4.yarn_1) == (_S600.yarn_2))));
        if((((_S603 & ((_S601 <= 0.0f)))) | (((end_1.height_9) <= _S598))))
        {
            break;
        }
        var _S604 : f32 = way_back_to_dip_0(end_1.previous_4, _S601, _S602, end_1.last_step_3, _S600);
        if(_S604 >= 0.0f)
        {
            end_1.height_9 = end_1.height_9 + _S604;
            end_1.last_step_3 = end_1.last_step_3 - _S604;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S605 : f32 = min(StepControl_to_cell_exit_0(_S596, _S600.side_x_0, _S600.side_y_0), end_1.height_9 - _S600.cell_max_0);
        var _S606 : f32 = StepControl_to_next_sample_0(_S596, _S600, _S601, _S602);
        end_1.previous_4 = after_sample_0(_S601, _S602, _S600, _S605 > _S606);
        var _S607 : f32 = max(_S605, _S606);
        end_1.last_step_3 = _S607;
        end_1.height_9 = end_1.height_9 - _S607;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S608 : u32,  _S609 : ViewRay_0,  _S610 : StepControl_0,  _S611 : bool,  _S612 : ViewRayEnd_0,  _S613 : u32) -> f32
{
    var _S614 : f32 = fabrics_0[_S608].height_high_0 - fabrics_0[_S608].height_low_0;
    var above_2 : f32 = _S612.height_9 + _S612.last_step_3;
    var above_gap_1 : f32 = clamp(_S612.previous_4.clearance_0, 0.0f, _S614);
    var under_gap_1 : f32 = clamp(_S612.depth_1, 0.0f, _S614);
    var middle_0 : f32 = select(between_0(above_2, _S612.height_9, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S612.previous_4.rate_0 * _S612.last_step_3, _S612.rate_4 * _S612.last_step_3) * _S612.last_step_3, _S612.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S612.height_9;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S613)
        {
        }
        else
        {
            break;
        }
        var _S615 : vec2<f32> = ViewRay_at_0(_S609, middle_0);
        var _S616 : Probe_0 = probe_0(_S608, _S615.x, _S615.y, _S611, _S610.right_0, _S610.up_0);
        var _S617 : f32 = clamp(middle_0 - select(_S616.height_4, -1.0e+09f, _S616.hole_3), - _S614, _S614);
        if(_S617 <= 0.0f)
        {
            var _S618 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S619 : f32 = - _S617;
            under_1 = middle_0;
            above_gap_2 = _S618;
            under_gap_2 = _S619;
            side_2 = 1.0f;
        }
        else
        {
            var _S620 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S617;
            under_gap_2 = _S620;
            side_2 = -1.0f;
        }
        var _S621 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S617 / min(ViewRay_rate_0(_S609, _S616), -9.99999997475242708e-07f), under_1, above_3), _S612.smooth_0);
        var _S622 : u32 = i_1 + u32(1);
        middle_0 = _S621;
        i_1 = _S622;
    }
    return select(under_1, middle_0, _S612.smooth_0);
}

fn first_hit_of_yarn_0( _S623 : u32,  _S624 : SearchQuality_0,  _S625 : f32,  _S626 : f32,  _S627 : vec3<f32>,  _S628 : bool) -> Hit_0
{
    var _S629 : f32 = max(_S627.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S625, _S626);
    var _S630 : vec2<f32> = _S627.xy / vec2<f32>(_S629);
    ray_0.slope_1 = _S630;
    var _S631 : StepControl_0 = step_control_0((vec2<f32>(0) - _S630), 1.0f / max(steps_per_length_0(_S623, _S624, _S627) / _S629, 9.99999971718068537e-10f));
    var _S632 : ViewRayEnd_0 = search_down_0(_S623, ray_0, _S631, _S628);
    var hit_0 : Hit_0;
    hit_0.hole_6 = false;
    var _S633 : f32 = refined_height_0(_S623, ray_0, _S631, _S628, _S632, _S624.refinements_0);
    hit_0.height_7 = _S633;
    var _S634 : vec2<f32> = ViewRay_at_0(ray_0, _S633);
    hit_0.x_15 = _S634.x;
    hit_0.y_8 = _S634.y;
    return hit_0;
}

fn first_hit_0( _S635 : u32,  _S636 : SearchQuality_0,  _S637 : f32,  _S638 : f32,  _S639 : vec3<f32>,  _S640 : bool) -> Hit_0
{
    if(!passes_through_0(_S635, _S636, _S637, _S638, _S639, _S640))
    {
        return first_hit_of_yarn_0(_S635, _S636, _S637, _S638, _S639, _S640);
    }
    var hit_1 : Hit_0;
    hit_1.x_15 = _S637;
    hit_1.y_8 = _S638;
    hit_1.height_7 = 0.0f;
    hit_1.hole_6 = true;
    return hit_1;
}

fn surface_at_0( _S641 : u32,  _S642 : f32,  _S643 : f32,  _S644 : bool) -> SurfacePoint_0
{
    var _S645 : Sample_0 = sample_at_0(_S641, _S642, _S643, _S644);
    var _S646 : u32 = select(fabrics_0[_S641].weft_0, fabrics_0[_S641].warp_0, _S645.shown_5.is_warp_2);
    var _S647 : f32 = families_0[_S646].twist_sine_0 * select(1.0f, -1.0f, _S644);
    var _S648 : f32 = select(-1.0f, 1.0f, _S645.shown_5.is_warp_2);
    var _S649 : vec2<f32> = fibre_direction_0(_S645.slope_across_0, _S648 * _S645.slope_along_0, _S647, families_0[_S646].twist_cosine_0);
    var _S650 : f32 = _S649.x;
    var _S651 : f32 = _S649.y;
    var _S652 : f32 = select(_S645.slope_y_1, _S645.slope_x_1, _S645.shown_5.is_warp_2) * _S650 + _S648 * select(_S645.slope_x_1, _S645.slope_y_1, _S645.shown_5.is_warp_2) * _S651;
    var _S653 : f32 = select(_S645.crossing_2.weft_4.half_width_1, _S645.crossing_2.warp_4.half_width_1, _S645.shown_5.is_warp_2) * 1.0154266357421875f;
    var _S654 : f32 = _S653 * arc_sine_0(clamp(_S645.section_1.across_3 / _S653, -1.0f, 1.0f));
    var _S655 : f32 = select(- _S642, _S643, _S645.shown_5.is_warp_2);
    var point_6 : SurfacePoint_0;
    point_6.hole_4 = _S645.shown_5.hole_2;
    point_6.is_warp_3 = _S645.shown_5.is_warp_2;
    point_6.warp_thread_0 = _S645.crossing_2.warp_4.thread_0;
    point_6.weft_thread_0 = _S645.crossing_2.weft_4.thread_0;
    point_6.height_6 = _S645.height_8;
    point_6.normal_5 = normalize(vec3<f32>(- _S645.slope_x_1, - _S645.slope_y_1, 1.0f));
    point_6.tangent_4 = normalize(select_vector_0(_S645.shown_5.is_warp_2, vec3<f32>(_S650, _S651, _S652), vec3<f32>(- _S651, _S650, _S652)));
    point_6.across_5 = _S645.section_1.across_3;
    point_6.fibre_across_0 = _S654 * families_0[_S646].twist_cosine_0 + _S655 * _S647;
    point_6.fibre_along_0 = _S655 * families_0[_S646].twist_cosine_0 - _S654 * _S647;
    return point_6;
}

fn has_hairs_0( _S656 : u32) -> bool
{
    return (((families_0[fabrics_0[_S656].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S656].weft_0].hairiness_0) > 0.0f)));
}

fn hair_at_0( _S657 : u32,  _S658 : vec2<f32>,  _S659 : bool,  _S660 : f32) -> Hair_0
{
    var _S661 : f32 = fabrics_0[_S657].fibre_size_0;
    var _S662 : f32 = 17.0f * fabrics_0[_S657].fibre_size_0;
    var _S663 : f32 = fade_0(_S660, _S662);
    var _S664 : vec2<f32> = _S658 / vec2<f32>(_S662);
    var _S665 : u32 = hash_key_0(select(u32(0), u32(1), _S659), ((fabrics_0[_S657].seed_0) ^ (u32(1013904242))));
    var _S666 : f32 = 1.0f / max(_S660, 0.07999999821186066f * fabrics_0[_S657].fibre_size_0);
    var _S667 : f32 = min(0.63999998569488525f * fabrics_0[_S657].fibre_size_0 * _S666, 1.0f);
    const _S668 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S668;
    var number_3 : u32 = u32(0);
    for(;;)
    {
        if(((_S663 > 0.0f) & ((number_3 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S669 : u32 = number_3 / u32(9);
        var _S670 : u32 = number_3 / u32(3) - u32(3) * _S669;
        var _S671 : vec2<f32> = floor(_S664) + vec2<f32>(f32(number_3 - u32(3) * _S670 - u32(9) * _S669), f32(_S670)) - vec2<f32>(1.0f);
        var _S672 : u32 = hash_bits_0(_S665 + _S669, u32(i32(_S671.x)) * u32(65536) + u32(i32(_S671.y)));
        var _S673 : u32 = hash_bits_0(_S665, _S672);
        var _S674 : vec2<f32> = _S664 - _S671 - vec2<f32>(share_of_0(_S672), share_of_0((_S672 >> (u32(10)))));
        var _S675 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S672 >> (u32(20)))));
        var _S676 : f32 = mix(5.0f, 16.0f, share_of_0((_S673 >> (u32(10))))) / 17.0f;
        var _S677 : f32 = _S674.x;
        var _S678 : f32 = _S675.y;
        var _S679 : f32 = _S674.y;
        var _S680 : f32 = _S675.x;
        var _S681 : f32 = (_S677 * _S678 + _S679 * _S680) / _S676;
        var _S682 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S673 >> (u32(20)))) - 1.0f);
        var _S683 : f32 = 2.0f * _S682 * _S681;
        var _S684 : f32 = rsqrt_0(_S683 * _S683 + 1.0f);
        var _S685 : f32 = (_S679 * _S678 - _S677 * _S680 - _S682 * _S676 * _S681 * _S681) * _S684 * 17.0f;
        var _S686 : f32 = clamp((0.31999999284744263f - abs(_S685)) * _S661 * _S666 + 0.5f, 0.0f, _S667);
        if((((((share_of_0(_S673)) < (families_0[select(fabrics_0[_S657].weft_0, fabrics_0[_S657].warp_0, ((((_S673 >> (u32(30)))) & (u32(1)))) == u32(1))].hairiness_0)) & (((abs(_S681)) < 1.0f)))) & ((_S686 > cover_2))))
        {
            var _S687 : vec2<f32> = vec2<f32>(- _S680 - _S683 * _S678, _S678 - _S683 * _S680) * vec2<f32>(_S684);
            cover_2 = _S686;
            hair_away_0 = _S685;
            hair_across_0 = _S687;
        }
        number_3 = number_3 + u32(1);
    }
    var _S688 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S663 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S688) * hair_across_0, sqrt(1.0f - _S688 * _S688));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S689 : u32,  _S690 : f32) -> bool
{
    return (((((fabrics_0[_S689].fibre_noise_0) > 0.0f) | (((fabrics_0[_S689].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S689].has_detail_0) != u32(0)) & ((_S690 >= 0.0f))))));
}

fn thread_number_0( _S691 : u32,  _S692 : SurfacePoint_0,  _S693 : f32,  _S694 : f32) -> u32
{
    var _S695 : u32 = select(fabrics_0[_S691].weft_0, fabrics_0[_S691].warp_0, _S692.is_warp_3);
    return u32(i32(floor((select(_S694, _S693, _S692.is_warp_3) - _S692.across_5) / families_0[_S695].period_0)) * i32(families_0[_S695].count_0) + i32(select(_S692.weft_thread_0, _S692.warp_thread_0, _S692.is_warp_3))) * u32(2) + select(u32(0), u32(1), _S692.is_warp_3);
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_4 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S696 : u32,  _S697 : u32,  _S698 : SurfacePoint_0,  _S699 : u32,  _S700 : f32) -> FibreNoise_0
{
    var _S701 : f32 = 5.0f * fabrics_0[_S696].fibre_size_0;
    var _S702 : vec2<f32> = wave_noise_0(hash_key_0(_S699, ((fabrics_0[_S696].seed_0) ^ (u32(458671337)))), _S698.fibre_along_0 / (25.0f * fabrics_0[_S696].fibre_size_0));
    var _S703 : f32 = _S698.fibre_across_0 + families_0[_S697].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S696].fibre_size_0 * _S702.x;
    var _S704 : vec3<f32> = fibre_cell_0(_S703, _S698.fibre_along_0, fabrics_0[_S696].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S699, ((fabrics_0[_S696].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S703, _S698.fibre_along_0, _S701));
    noise_0.bundle_weight_0 = fade_0(_S700, _S701);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S699, ((fabrics_0[_S696].seed_0) ^ (u32(48610963)))), _S704);
    noise_0.fibre_weight_0 = fade_0(_S700, fabrics_0[_S696].fibre_size_0);
    noise_0.offset_4 = _S704.z;
    noise_0.slope_2 = 0.5f * _S702.y;
    return noise_0;
}

fn detail_gain_0( _S705 : u32,  _S706 : u32,  _S707 : SurfacePoint_0,  _S708 : vec2<f32>,  _S709 : bool,  _S710 : u32,  _S711 : f32) -> vec2<f32>
{
    var _S712 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S706].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S711, 1.0f / families_0[_S706].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S706, _S707, _S709))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S712;
    }
    if((families_0[_S706].fibre_tone_0) > 0.0f)
    {
        var _S713 : FibreNoise_0 = fibre_noise_at_0(_S705, _S706, _S707, _S710, _S711);
        gain_2 = gain_2 + vec2<f32>(families_0[_S706].fibre_tone_0) * vec2<f32>(_S713.bundle_weight_0 * _S713.bundle_0.y + _S713.fibre_weight_0 * _S713.fibre_0.y, _S713.bundle_weight_0 + _S713.fibre_weight_0);
    }
    if((families_0[_S706].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.25f * families_0[_S706].slub_0 * fade_0(_S711, 1.0f / families_0[_S706].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S710, ((fabrics_0[_S705].seed_0) ^ (u32(1373058189)))), select(- _S708.x, _S708.y, _S707.is_warp_3) * families_0[_S706].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S707.across_5 * families_0[_S706].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S714 : u32,  _S715 : Albedos_0,  _S716 : u32,  _S717 : u32,  _S718 : vec2<f32>) -> Albedos_0
{
    var _S719 : vec3<f32> = max(_S715.specular_reflect_0, _S715.specular_transmit_0);
    var _S720 : vec3<f32> = _S715.diffuse_reflect_0 + _S715.diffuse_transmit_0;
    var _S721 : vec3<f32> = vec3<f32>(fabrics_0[_S714].layer_bound_0);
    var _S722 : vec3<f32> = vec3<f32>(1.0f);
    var _S723 : vec3<f32> = _S722 - _S721 * _S719;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S716, fabrics_0[_S714].colour_noise_0, fabrics_0[_S714].seed_0), _S720, _S723);
    var _S724 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S718.y, vec3<f32>(colour_1) * _S720, _S723) * _S718.x)));
    var _S725 : f32 = bounded_gain_0(fibre_gain_0(_S716, _S717, fabrics_0[_S714].fibre_noise_0, fabrics_0[_S714].seed_0), _S719, min((_S722 - _S724 * _S720) / _S721, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S724 * _S715.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S724 * _S715.diffuse_transmit_0;
    var _S726 : vec3<f32> = vec3<f32>(_S725);
    varied_0.specular_reflect_0 = _S726 * _S715.specular_reflect_0;
    varied_0.specular_transmit_0 = _S726 * _S715.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S727 : u32,  _S728 : SurfacePoint_0,  _S729 : Albedos_0,  _S730 : f32,  _S731 : f32,  _S732 : bool,  _S733 : f32,  _S734 : f32) -> Albedos_0
{
    var _S735 : u32 = thread_number_0(_S727, _S728, _S730, _S731);
    var _S736 : vec3<f32> = fibre_cell_0(_S728.fibre_across_0, _S728.fibre_along_0, fabrics_0[_S727].fibre_size_0);
    var _S737 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S727].has_detail_0) != u32(0)) & ((_S733 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S727, select(fabrics_0[_S727].weft_0, fabrics_0[_S727].warp_0, _S728.is_warp_3), _S728, vec2<f32>(_S730, _S731), _S732, _S735, _S733) * vec2<f32>(1.0f - _S734, 1.0f);
    }
    else
    {
        gain_3 = _S737;
    }
    return vary_albedos_0(_S727, _S729, _S735, u32(i32(_S736.x)) * u32(65536) + u32(i32(floor(_S736.y))), gain_3);
}

fn turned_frame_0( _S738 : u32,  _S739 : u32,  _S740 : SurfacePoint_0,  _S741 : bool,  _S742 : u32,  _S743 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_6 = _S740.normal_5;
    frame_2.tangent_5 = _S740.tangent_4;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S739].has_plies_0) > 0.0f)
    {
        var _S744 : f32 = fade_0(_S743, 1.0f / families_0[_S739].plies_per_mm_0);
        var _S745 : f32 = _S744 * 0.41999998688697815f * ply_offset_0(_S739, _S740, _S741);
        var _S746 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S747 : vec3<f32> = vec3<f32>(families_0[_S739].ply_cosine_0);
        var _S748 : vec3<f32> = vec3<f32>(select(families_0[_S739].ply_sine_0, - families_0[_S739].ply_sine_0, _S741));
        var _S749 : vec3<f32> = _S747 * _S746 + _S748 * frame_2.tangent_5;
        var _S750 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S745 * _S745));
        var _S751 : vec3<f32> = vec3<f32>(_S745);
        frame_2.tangent_5 = _S747 * (_S747 * frame_2.tangent_5 - _S748 * _S746) + _S748 * (_S750 * _S749 - _S751 * frame_2.normal_6);
        frame_2.normal_6 = _S750 * frame_2.normal_6 + _S751 * _S749;
        frame_2.loss_0 = _S744 * _S744 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S752 : f32 = families_0[_S739].fibre_tilt_0;
    if((families_0[_S739].fibre_tilt_0) > 0.0f)
    {
        var _S753 : FibreNoise_0 = fibre_noise_at_0(_S738, _S739, _S740, _S742, _S743);
        var _S754 : f32 = 1.09858846664428711f * _S752 * (_S753.bundle_weight_0 * _S753.bundle_0.x + _S753.fibre_weight_0 * (_S753.fibre_0.x + _S753.offset_4));
        var _S755 : f32 = _S752 * (1.42099642753601074f * (_S753.bundle_weight_0 * _S753.bundle_0.y + _S753.fibre_weight_0 * _S753.fibre_0.y) - _S753.bundle_weight_0 * _S753.slope_2);
        var _S756 : f32 = square_1(_S753.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S752 * _S752 * ((0.24761904776096344f * (square_1(_S753.bundle_weight_0) + _S756) + _S756 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S757 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S758 : vec2<f32> = sine_cosine_0(_S754);
        var _S759 : vec2<f32> = sine_cosine_0(_S755);
        var _S760 : vec3<f32> = vec3<f32>(_S758.y);
        var _S761 : vec3<f32> = vec3<f32>(_S758.x);
        var _S762 : vec3<f32> = _S760 * _S757 - _S761 * frame_2.normal_6;
        frame_2.normal_6 = _S760 * frame_2.normal_6 + _S761 * _S757;
        frame_2.tangent_5 = vec3<f32>(_S759.y) * frame_2.tangent_5 + vec3<f32>(_S759.x) * _S762;
    }
    return frame_2;
}

fn yarn_point_of_0( _S763 : u32,  _S764 : SurfacePoint_0,  _S765 : f32,  _S766 : f32,  _S767 : bool,  _S768 : bool,  _S769 : f32) -> YarnPoint_0
{
    var _S770 : u32 = select(fabrics_0[_S763].weft_0, fabrics_0[_S763].warp_0, _S764.is_warp_3);
    var _S771 : bool = (((fabrics_0[_S763].has_detail_0) != u32(0)) & ((_S769 >= 0.0f)));
    var _S772 : vec3<f32> = vec3<f32>(0.0f);
    var _S773 : Hair_0 = Hair_x24init_0(0.0f, _S772, _S772);
    var _S774 : bool;
    if(_S771)
    {
        _S774 = has_hairs_0(_S763);
    }
    else
    {
        _S774 = false;
    }
    var hair_2 : Hair_0;
    if(_S774)
    {
        hair_2 = hair_at_0(_S763, vec2<f32>(_S765, _S766), _S767, _S769);
    }
    else
    {
        hair_2 = _S773;
    }
    var albedos_9 : Albedos_0 = albedos_of_0(_S770, select(_S764.weft_thread_0, _S764.warp_thread_0, _S764.is_warp_3));
    var albedos_10 : Albedos_0;
    if(varies_at_0(_S763, _S769))
    {
        albedos_10 = varied_at_0(_S763, _S764, albedos_9, _S765, _S766, _S767, _S769, hair_2.cover_0);
    }
    else
    {
        albedos_10 = albedos_9;
    }
    var point_7 : YarnPoint_0;
    point_7.back_6 = _S767;
    point_7.hole_0 = _S768;
    point_7.is_warp_0 = _S764.is_warp_3;
    point_7.x_7 = _S765;
    point_7.y_2 = _S766;
    point_7.height_2 = _S764.height_6;
    point_7.normal_1 = _S764.normal_5;
    point_7.tangent_0 = _S764.tangent_4;
    point_7.surface_normal_0 = _S764.normal_5;
    point_7.diffuse_gain_0 = 1.0f;
    if(_S771)
    {
        var _S775 : YarnFrame_0 = turned_frame_0(_S763, _S770, _S764, _S767, thread_number_0(_S763, _S764, _S765, _S766), _S769);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S763))
        {
            frame_3 = under_hair_0(_S775, hair_2);
        }
        else
        {
            frame_3 = _S775;
        }
        point_7.normal_1 = frame_3.normal_6;
        point_7.tangent_0 = frame_3.tangent_5;
        point_7.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S763].diffuse_blend_0);
    }
    point_7.roughness_1 = families_0[_S770].roughness_0;
    point_7.albedos_5 = albedos_10;
    return point_7;
}

fn locate_yarn_0( _S776 : u32,  _S777 : SearchQuality_0,  _S778 : f32,  _S779 : f32,  _S780 : vec3<f32>,  _S781 : f32) -> YarnPoint_0
{
    var _S782 : bool = (_S780.z) < 0.0f;
    var _S783 : Hit_0 = first_hit_0(_S776, _S777, _S778, _S779, to_face_frame_0(_S780, _S782), _S782);
    return yarn_point_of_0(_S776, surface_at_0(_S776, _S783.x_15, _S783.y_8, _S782), _S783.x_15, _S783.y_8, _S782, _S783.hole_6, _S781);
}

fn locate_yarn_1( _S784 : u32,  _S785 : SearchQuality_0,  _S786 : f32,  _S787 : f32,  _S788 : vec3<f32>) -> YarnPoint_0
{
    return locate_yarn_0(_S784, _S785, _S786, _S787, _S788, -1.0f);
}

fn blocked_at_0( _S789 : u32,  _S790 : bool,  _S791 : bool,  _S792 : f32,  _S793 : f32) -> Blocked_0
{
    var _S794 : f32 = _S793 * openness_number_0(_S789, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S792, _S794, _S792 * _S792, _S792 * _S794, _S794 * _S794 );
    return blocked_of_terms_0(_S789, u32(60) + (select(u32(0), u32(2), _S791) + select(u32(1), u32(0), _S790)) * u32(18), terms_2, u32(6));
}

fn bounced_at_0( _S795 : u32,  _S796 : YarnPoint_0,  _S797 : vec3<f32>) -> Bounced_0
{
    var nothing_1 : Bounced_0;
    var _S798 : vec3<f32> = vec3<f32>(0.0f);
    nothing_1.reflected_0 = _S798;
    nothing_1.transmitted_0 = _S798;
    if((((fabrics_0[_S795].openness_0) == u32(4294967295)) | ((_S796.hole_0))))
    {
        return nothing_1;
    }
    return bounced_by_0(blocked_at_0(_S795, _S796.is_warp_0, _S796.back_6, _S796.surface_normal_0.z, _S796.height_2), scattered_by_0(_S795, _S796.albedos_5, select(u32(1), u32(0), _S796.is_warp_0), _S797), interior_of_0(_S795, _S797, _S796.back_6));
}

fn shown_at_texel_0( _S799 : u32,  _S800 : ViewedBase_0,  _S801 : u32) -> vec2<f32>
{
    var _S802 : Clustered_std430_0 = fabrics_0[_S799].clustered_0;
    var _S803 : u32 = table_byte_0(fabrics_0[_S799].clustered_0.labels_0, _S800.face_4 * fabrics_0[_S799].clustered_0.columns_0 * fabrics_0[_S799].clustered_0.rows_0 + _S801);
    if(_S803 >= (fabrics_0[_S799].clustered_0.clusters_0))
    {
        return vec2<f32>(0.0f);
    }
    return family_share_0(_S799, _S803, _S800.trust_1.x * BinTaps_read_0(_S800.around_0, _S802.view_0, _S800.face_4 * u32(256), _S802.clusters_0, _S803));
}

fn residual_point_0( _S804 : u32,  _S805 : ClusteredView_0,  _S806 : vec3<f32>,  _S807 : u32,  _S808 : u32) -> ResidualPoint_0
{
    var _S809 : u32 = _S807 + _S808 * u32(1663821227);
    var _S810 : vec2<f32> = vec2<f32>(uniform_of_0(_S809, u32(1)), uniform_of_0(_S809, u32(2)));
    var _S811 : vec2<f32> = _S805.base_0.box_3.corner_2 + _S810 * _S805.base_0.box_3.size_1;
    var result_2 : ResidualPoint_0;
    var _S812 : YarnPoint_0 = locate_yarn_1(_S804, default_quality_0(), _S811.x, _S811.y, _S805.view_4);
    result_2.point_1 = _S812;
    var _S813 : Clustered_std430_0 = fabrics_0[_S804].clustered_0;
    var _S814 : u32 = texel_of_0(&(_S813), _S805.base_0.box_3, _S810);
    result_2.texel_0 = _S814;
    result_2.bounced_2 = bounced_at_0(_S804, _S812, _S806);
    if((fabrics_0[_S804].openness_0) != u32(4294967295))
    {
        var _S815 : Bounced_0 = bounced_by_base_0(_S805, shown_at_texel_0(_S804, _S805.base_0, result_2.texel_0));
        result_2.bounced_2.reflected_0 = result_2.bounced_2.reflected_0 - _S815.reflected_0;
        result_2.bounced_2.transmitted_0 = result_2.bounced_2.transmitted_0 - _S815.transmitted_0;
    }
    return result_2;
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
    var _S826 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S824.index_7 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S821.x);
    var _S827 : vec3<f32> = environment_texel_0(_S824.index_7, _S826.index_7);
    (*_S822) = _S827 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S827), 9.99999968265522539e-21f)));
    var _S828 : f32 = 3.14159274101257324f / f32(_S823);
    var _S829 : f32 = mix(sine_cosine_0(f32(_S824.index_7) * _S828).y, sine_cosine_0(f32(_S824.index_7 + u32(1)) * _S828).y, _S824.remainder_0);
    var _S830 : f32 = sqrt(max(1.0f - _S829 * _S829, 0.0f));
    var _S831 : vec2<f32> = sine_cosine_0((f32(_S826.index_7) + _S826.remainder_0) * (6.28318548202514648f / f32(_S825)));
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
        var weight_2 : vec3<f32>;
        var _S838 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S835, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S834 - _S837), u32(3)), &(weight_2));
        sample_1.towards_0 = _S838;
        sample_1.irradiance_1 = weight_2 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S839 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S834);
    sample_1.irradiance_1 = vec3<f32>(_S839.red_0, _S839.green_0, _S839.blue_0);
    sample_1.towards_0 = vec3<f32>(_S839.x_11, _S839.y_4, _S839.z_1);
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

fn cluster_density_0( _S842 : u32,  _S843 : ViewedBase_0,  _S844 : BaseTaps_0,  _S845 : u32,  _S846 : u32) -> f32
{
    return BinTaps_read_0(_S844.half_vector_0, fabrics_0[_S842].clustered_0.basis_0, _S843.face_4 * u32(1024), fabrics_0[_S842].clustered_0.clusters_0 * (u32(1) + fabrics_0[_S842].clustered_0.rank_0), _S846 * fabrics_0[_S842].clustered_0.clusters_0 + _S845);
}

struct ClusterTerms_0
{
     diffuse_0 : f32,
     specular_0 : f32,
     lit_0 : f32,
};

fn cluster_attenuation_0( _S847 : u32,  _S848 : ViewedBase_0,  _S849 : BaseTaps_0,  _S850 : u32) -> f32
{
    var _S851 : u32 = fabrics_0[_S847].clustered_0.moments_1 + (_S848.face_4 * fabrics_0[_S847].clustered_0.clusters_0 + _S850) * u32(8);
    var _S852 : vec3<f32> = vec3<f32>(table_number_0(_S851), table_number_0(_S851 + u32(1)), table_number_0(_S851 + u32(2)));
    var _S853 : vec3<f32> = vec3<f32>(table_number_0(_S851 + u32(3)), table_number_0(_S851 + u32(4)), table_number_0(_S851 + u32(5)));
    var _S854 : f32 = table_number_0(_S851 + u32(7));
    var _S855 : f32 = fabrics_0[_S847].optical_depth_0;
    var _S856 : f32 = dot(_S849.facing_0, _S852);
    var _S857 : f32 = max(dot(_S848.view_3, _S852), 0.10000000149011612f);
    var _S858 : f32 = projected_area_1(_S849.facing_0, _S853, _S854) / max(select(_S856, - _S856, _S849.transmits_1), 0.10000000149011612f);
    var _S859 : f32 = projected_area_1(_S848.view_3, _S853, _S854) / _S857;
    if(!_S849.transmits_1)
    {
        var _S860 : f32 = _S858 + _S859;
        return 0.25f * (1.0f - exponential_0(- _S855 * _S860)) / (_S860 * _S857);
    }
    var _S861 : f32 = max(_S855 * abs(_S858 - _S859), 0.00100000004749745f);
    return 0.25f * _S855 * exponential_0(- _S855 * min(_S858, _S859)) * (1.0f - exponential_0(- _S861)) / (_S861 * _S857);
}

fn cluster_terms_0( _S862 : u32,  _S863 : ViewedBase_0,  _S864 : BaseTaps_0,  _S865 : u32) -> ClusterTerms_0
{
    var _S866 : u32 = u32(2) * fabrics_0[_S862].clustered_0.clusters_0;
    var _S867 : f32 = BinTaps_read_0(_S864.around_1, fabrics_0[_S862].clustered_0.light_0, _S864.first_9, _S866, _S865);
    var _S868 : f32 = BinTaps_read_0(_S863.around_0, fabrics_0[_S862].clustered_0.view_0, _S863.face_4 * u32(256), fabrics_0[_S862].clustered_0.clusters_0, _S865);
    var terms_3 : ClusterTerms_0;
    var _S869 : f32 = _S863.trust_1.x * _S868;
    terms_3.diffuse_0 = _S869 * 0.31830987334251404f * ((1.0f - fabrics_0[_S862].diffuse_blend_0) * abs(_S864.facing_0.z) * _S867 + fabrics_0[_S862].diffuse_blend_0 * BinTaps_read_0(_S864.around_1, fabrics_0[_S862].clustered_0.light_0, _S864.first_9, _S866, fabrics_0[_S862].clustered_0.clusters_0 + _S865));
    terms_3.specular_0 = _S863.trust_1.y * _S868 * _S867 * cluster_attenuation_0(_S862, _S863, _S864, _S865);
    terms_3.lit_0 = _S869 * _S867;
    return terms_3;
}

fn with_cluster_0( _S870 : u32,  _S871 : Components_0,  _S872 : ClusterTerms_0,  _S873 : u32,  _S874 : f32,  _S875 : f32) -> Components_0
{
    var _S876 : bool = _S873 < (fabrics_0[_S870].clustered_0.clusters_0 / u32(2));
    var result_3 : Components_0 = _S871;
    var _S877 : f32 = _S874 * _S872.diffuse_0;
    result_3.diffuse_warp_0 = result_3.diffuse_warp_0 + select(0.0f, _S877, _S876);
    result_3.diffuse_weft_0 = result_3.diffuse_weft_0 + select(_S877, 0.0f, _S876);
    var _S878 : f32 = _S872.specular_0 * _S875;
    result_3.specular_warp_0 = result_3.specular_warp_0 + select(0.0f, _S878, _S876);
    result_3.specular_weft_0 = result_3.specular_weft_0 + select(_S878, 0.0f, _S876);
    result_3.light_visibility_1 = result_3.light_visibility_1 + _S874 * _S872.lit_0;
    return result_3;
}

fn clustered_base_0( _S879 : u32,  _S880 : ViewedBase_0,  _S881 : BaseTaps_0) -> Components_0
{
    var _S882 : Clustered_std430_0 = fabrics_0[_S879].clustered_0;
    var _S883 : u32 = _S882.clusters_0;
    var base_1 : Components_0 = no_components_0();
    var cluster_2 : u32 = u32(0);
    for(;;)
    {
        if(cluster_2 < _S883)
        {
        }
        else
        {
            break;
        }
        var _S884 : f32 = box_mean_1(&(_S882), _S880.box_3, _S880.face_4, cluster_2);
        if(_S884 <= 0.0f)
        {
            cluster_2 = cluster_2 + u32(1);
            continue;
        }
        var _S885 : f32 = _S884 * cluster_density_0(_S879, _S880, _S881, cluster_2, u32(0));
        var number_4 : u32 = u32(1);
        var density_0 : f32 = _S885;
        for(;;)
        {
            if(number_4 <= (_S882.rank_0))
            {
            }
            else
            {
                break;
            }
            var _S886 : f32 = box_mean_1(&(_S882), _S880.box_3, _S880.face_4, number_4 * _S883 + cluster_2);
            var density_1 : f32 = density_0 + _S886 * cluster_density_0(_S879, _S880, _S881, cluster_2, number_4);
            number_4 = number_4 + u32(1);
            density_0 = density_1;
        }
        base_1 = with_cluster_0(_S879, base_1, cluster_terms_0(_S879, _S880, _S881, cluster_2), cluster_2, _S884, density_0);
        cluster_2 = cluster_2 + u32(1);
    }
    return base_1;
}

fn under_sheen_0( _S887 : u32,  _S888 : ClusteredView_0,  _S889 : vec3<f32>,  _S890 : f32,  _S891 : vec3<f32>) -> vec3<f32>
{
    var _S892 : f32 = fabrics_0[_S887].sheen_strength_0;
    if((fabrics_0[_S887].sheen_strength_0) <= 0.0f)
    {
        return _S889;
    }
    var _S893 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S891, _S888.base_0.back_5), _S888.base_0.view_3, _S892, fabrics_0[_S887].sheen_roughness_0);
    return vec3<f32>(_S893.y) * _S889 + vec3<f32>((_S890 * _S893.x));
}

fn clustered_base_value_0( _S894 : u32,  _S895 : ClusteredView_0,  _S896 : f32,  _S897 : vec3<f32>) -> vec3<f32>
{
    var _S898 : BaseTaps_0 = base_taps_0(_S895.base_0, _S897);
    var _S899 : Components_0 = clustered_base_0(_S894, _S895.base_0, _S898);
    return under_sheen_0(_S894, _S895, shaded_0(_S899, _S895.albedos_4, _S898.transmits_1) + bounced_value_0(_S895.bounced_1, _S897, _S895.view_4), _S899.light_visibility_1 + _S896, _S897);
}

fn clustered_at_texel_0( _S900 : u32,  _S901 : ViewedBase_0,  _S902 : u32,  _S903 : BaseTaps_0) -> Components_0
{
    var _S904 : Clustered_std430_0 = fabrics_0[_S900].clustered_0;
    var _S905 : u32 = _S901.face_4 * fabrics_0[_S900].clustered_0.columns_0 * fabrics_0[_S900].clustered_0.rows_0 + _S902;
    var _S906 : u32 = table_byte_0(fabrics_0[_S900].clustered_0.labels_0, _S905);
    var base_2 : Components_0 = no_components_0();
    if(_S906 >= (fabrics_0[_S900].clustered_0.clusters_0))
    {
        return base_2;
    }
    var _S907 : f32 = cluster_density_0(_S900, _S901, _S903, _S906, u32(0));
    var number_5 : u32 = u32(1);
    var density_2 : f32 = _S907;
    for(;;)
    {
        if(number_5 <= (_S904.rank_0))
        {
        }
        else
        {
            break;
        }
        var _S908 : i32 = i32(table_byte_0(_S904.coefficients_0, _S905 * _S904.rank_0 + number_5 - u32(1)));
        var density_3 : f32 = density_2 + f32(select(_S908, _S908 - i32(256), _S908 > i32(127))) * cluster_density_0(_S900, _S901, _S903, _S906, number_5);
        number_5 = number_5 + u32(1);
        density_2 = density_3;
    }
    return with_cluster_0(_S900, base_2, cluster_terms_0(_S900, _S901, _S903, _S906), _S906, 1.0f, density_2);
}

fn unoccluded_0( _S909 : u32,  _S910 : SearchQuality_0,  _S911 : f32,  _S912 : f32,  _S913 : f32,  _S914 : vec3<f32>,  _S915 : bool) -> bool
{
    if((_S914.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S909, _S910, vec3<f32>(_S911, _S912, _S913 + fabrics_0[_S909].lift_0), _S914, _S915, max_height_along_0(_S909, _S911, _S912, _S913, _S914, _S915));
}

fn is_lit_0( _S916 : u32,  _S917 : SearchQuality_0,  _S918 : YarnPoint_0,  _S919 : vec3<f32>) -> bool
{
    if(_S918.hole_0)
    {
        return true;
    }
    var _S920 : vec3<f32> = to_face_frame_0(_S919, _S918.back_6);
    var _S921 : f32 = _S920.z;
    var _S922 : bool = _S921 < 0.0f;
    var normal_10 : vec3<f32>;
    var height_12 : f32;
    if(_S922)
    {
        var _S923 : SurfacePoint_0 = surface_at_0(_S916, _S918.x_7, _S918.y_2, !_S918.back_6);
        normal_10 = _S923.normal_5;
        height_12 = _S923.height_6;
    }
    else
    {
        normal_10 = _S918.surface_normal_0;
        height_12 = _S918.height_2;
    }
    var _S924 : vec3<f32> = vec3<f32>(_S920.xy, abs(_S921));
    if((dot(normal_10, _S924)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S916, _S917, _S918.x_7, _S918.y_2, height_12, _S924, (_S918.back_6) != _S922);
}

fn components_of_point_0( _S925 : u32,  _S926 : SearchQuality_0,  _S927 : YarnPoint_0,  _S928 : vec3<f32>,  _S929 : vec3<f32>) -> Components_0
{
    var result_4 : Components_0 = no_components_0();
    result_4.hole_5 = select(0.0f, 1.0f, _S927.hole_0);
    var _S930 : bool;
    if(_S927.hole_0)
    {
        _S930 = true;
    }
    else
    {
        _S930 = !is_lit_0(_S925, _S926, _S927, _S928);
    }
    if(_S930)
    {
        return result_4;
    }
    var _S931 : vec3<f32> = to_face_frame_0(_S928, _S927.back_6);
    var _S932 : vec3<f32> = to_face_frame_0(_S929, _S927.back_6);
    var _S933 : bool = (_S931.z) < 0.0f;
    var _S934 : f32 = _S927.diffuse_gain_0 * diffuse_reflection_0(select_vector_0(_S933, (vec3<f32>(0) - _S931), _S931), _S927.normal_1, fabrics_0[_S925].diffuse_blend_0);
    var _S935 : f32;
    if(_S933)
    {
        _S935 = transmission_1(_S931, _S932, _S927.normal_1, _S927.tangent_0, _S927.roughness_1, fabrics_0[_S925].optical_depth_0);
    }
    else
    {
        _S935 = reflection_0(_S931, _S932, _S927.normal_1, _S927.tangent_0, _S927.roughness_1, fabrics_0[_S925].optical_depth_0);
    }
    result_4.diffuse_warp_0 = select(0.0f, _S934, _S927.is_warp_0);
    result_4.diffuse_weft_0 = select(_S934, 0.0f, _S927.is_warp_0);
    result_4.specular_warp_0 = select(0.0f, _S935, _S927.is_warp_0);
    result_4.specular_weft_0 = select(_S935, 0.0f, _S927.is_warp_0);
    result_4.light_visibility_1 = 1.0f;
    return result_4;
}

fn clustered_residual_0( _S936 : u32,  _S937 : ClusteredView_0,  _S938 : ResidualPoint_0,  _S939 : vec3<f32>,  _S940 : vec3<f32>) -> vec3<f32>
{
    var _S941 : BaseTaps_0 = base_taps_0(_S937.base_0, _S940);
    var _S942 : Components_0 = clustered_at_texel_0(_S936, _S937.base_0, _S938.texel_0, _S941);
    var _S943 : Components_0 = components_of_point_0(_S936, default_quality_0(), _S938.point_1, _S940, _S937.view_4);
    var own_2 : FamilyAlbedos_0;
    var _S944 : Albedos_0 = tinted_0(_S938.point_1.albedos_5, _S939);
    own_2.warp_3 = _S944;
    own_2.weft_3 = _S944;
    return under_sheen_0(_S936, _S937, shaded_0(_S943, own_2, _S941.transmits_1) - shaded_0(_S942, _S937.albedos_4, _S941.transmits_1) + bounced_value_0(_S938.bounced_2, _S940, _S937.view_4), _S943.light_visibility_1 + _S943.hole_5 - _S942.light_visibility_1, _S940);
}

fn passed_by_sheen_0( _S945 : u32,  _S946 : f32,  _S947 : vec3<f32>) -> f32
{
    var _S948 : f32 = fabrics_0[_S945].sheen_strength_0;
    if((fabrics_0[_S945].sheen_strength_0) <= 0.0f)
    {
        return _S946;
    }
    return _S946 * (1.0f - _S948 * sheen_lobe_0(abs(_S947.z), fabrics_0[_S945].sheen_roughness_0).z);
}

fn light_of_clustered_0( _S949 : u32,  _S950 : VisiblePoint_0,  _S951 : vec2<u32>,  _S952 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = _S950.draft_0;
    footprint_1.dx_0 = _S950.draft_dx_0;
    footprint_1.dy_0 = _S950.draft_dy_0;
    var _S953 : vec3<f32> = to_local_0(_S950, _S950.view_1);
    var _S954 : Clustered_std430_0 = fabrics_0[_S949].clustered_0;
    var _S955 : u32 = mixed_0(mixed_0(_S951.x + u32(65536) * _S951.y) + frame_record_0.pass_number_0 * u32(2654435769));
    var _S956 : bool = (fabrics_0[_S949].clustered_0.samples_1) == u32(0);
    var _S957 : ClusteredView_0 = clustered_view_0(_S949, footprint_1, _S953, _S952, _S955, _S956);
    var _S958 : vec3<f32> = vec3<f32>(0.0f);
    var hole_7 : f32;
    if(_S956)
    {
        hole_7 = clustered_hole_0(_S949, _S957.base_0);
    }
    else
    {
        hole_7 = 0.0f;
    }
    var term_1 : u32 = u32(0);
    var hole_8 : f32 = hole_7;
    var radiance_1 : vec3<f32> = _S958;
    for(;;)
    {
        if(term_1 <= (_S954.samples_1))
        {
        }
        else
        {
            break;
        }
        var _S959 : ResidualPoint_0 = ResidualPoint_x24init_0(YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S958, _S958, _S958, 0.0f, 0.0f, Albedos_x24init_0(_S958, _S958, _S958, _S958)), u32(0), Bounced_x24init_0(_S958, _S958));
        var sample_2 : ResidualPoint_0;
        if(term_1 > u32(0))
        {
            var _S960 : ResidualPoint_0 = residual_point_0(_S949, _S957, _S952, _S955, term_1 - u32(1));
            var hole_9 : f32 = hole_8 + select(0.0f, 1.0f, _S960.point_1.hole_0) / f32(_S954.samples_1);
            sample_2 = _S960;
            hole_8 = hole_9;
        }
        else
        {
            sample_2 = _S959;
        }
        var number_6 : u32 = u32(0);
        var radiance_2 : vec3<f32> = radiance_1;
        for(;;)
        {
            if(number_6 < (light_sample_count_0()))
            {
            }
            else
            {
                break;
            }
            var _S961 : f32 = visibility_at_0(number_6, _S951);
            if(_S961 <= 0.0f)
            {
                number_6 = number_6 + u32(1);
                continue;
            }
            var _S962 : LightSample_0 = light_sample_0(number_6, _S951, _S950.position_0);
            var _S963 : vec3<f32> = to_local_0(_S950, _S962.towards_0);
            var value_1 : vec3<f32>;
            if(term_1 == u32(0))
            {
                value_1 = clustered_base_value_0(_S949, _S957, hole_7, _S963);
            }
            else
            {
                value_1 = clustered_residual_0(_S949, _S957, sample_2, _S952, _S963) / vec3<f32>(f32(_S954.samples_1));
            }
            radiance_2 = radiance_2 + vec3<f32>(_S961) * _S962.irradiance_1 * value_1;
            number_6 = number_6 + u32(1);
        }
        term_1 = term_1 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - passed_by_sheen_0(_S949, hole_8, _S953));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_clustered(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S964 : u32 = id_0.x;
    var _S965 : bool;
    if(_S964 >= (frame_record_0.width_0))
    {
        _S965 = true;
    }
    else
    {
        _S965 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S965)
    {
        return;
    }
    var _S966 : u32 = id_0.y * frame_record_0.width_0 + _S964;
    var _S967 : u32 = layers_0[_S966].face_0;
    if((layers_0[_S966].face_0) == u32(0))
    {
        return;
    }
    var _S968 : u32 = _S967 - u32(1);
    var _S969 : u32 = fabric_of_0(_S968);
    var _S970 : vec2<u32> = id_0.xy;
    var _S971 : VisiblePoint_0 = visible_point_0(_S969, _S968, _S970);
    accumulate_0(_S966, light_of_clustered_0(_S969, _S971, _S970, filtered_albedo_0(_S969, _S971)));
    return;
}

