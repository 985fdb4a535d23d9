struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(4) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(4) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(4) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(4) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(4) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(4) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(4) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(4) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(4) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(4) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(4) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(4) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(4) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(4) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(4) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
};

@binding(4) @group(0) var<storage, read> frames_0 : array<Frame_std430_0>;

struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(12) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(7) @group(0) var<storage, read> face_fabrics_0 : array<u32>;

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
    @align(4) front_hole_weight_0 : f32,
    @align(4) back_hole_weight_0 : f32,
    @align(4) threads_per_mm_0 : f32,
    @align(4) unit_level_0 : f32,
};

struct Woven_std430_0
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
    @align(4) frames_1 : u32,
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

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) woven_0 : Woven_std430_0,
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
    @align(4) uv_width_0 : f32,
    @align(4) uv_height_0 : f32,
    @align(4) is_open_0 : u32,
    @align(4) openness_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
    @align(4) has_yarns_0 : u32,
    @align(4) mean_hole_0 : f32,
    @align(4) latent_0 : Latent_std430_0,
};

@binding(0) @group(0) var<storage, read> fabrics_0 : array<Fabric_std430_0>;

@binding(6) @group(0) var<storage, read> corners_0 : array<u32>;

struct Vertex_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) z_0 : f32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) u_0 : f32,
    @align(4) v_0 : f32,
};

@binding(5) @group(0) var<storage, read> vertices_0 : array<Vertex_std430_0>;

@binding(11) @group(0) var<storage, read> scene_words_0 : array<u32>;

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
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(13) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

struct Light_std430_0
{
    @align(4) is_point_0 : u32,
    @align(4) x_1 : f32,
    @align(4) y_1 : f32,
    @align(4) z_1 : f32,
    @align(4) red_0 : f32,
    @align(4) green_0 : f32,
    @align(4) blue_0 : f32,
};

@binding(3) @group(0) var<storage, read> lights_1 : array<Light_std430_0>;

@binding(8) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn rsqrt_0( x_2 : f32) -> f32
{
    return 1.0f / sqrt(x_2);
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn position_of_0( vertex_0 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_0).x_0, (*vertex_0).y_0, (*vertex_0).z_0);
}

fn position_of_1( vertex_1 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_1).x_0, (*vertex_1).y_0, (*vertex_1).z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_2 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_2).normal_x_0, (*vertex_2).normal_y_0, (*vertex_2).normal_z_0);
}

fn square_1( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S1 : u32 = (bitcast<u32>((x_4)));
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

fn binary_logarithm_0( x_5 : f32) -> f32
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
}

fn exponential_0( x_6 : f32) -> f32
{
    var _S3 : f32 = clamp(x_6, -87.0f, 88.0f);
    var _S4 : f32 = floor(_S3 * 1.4426950216293335f + 0.5f);
    var _S5 : f32 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f;
    var _S6 : f32 = (bitcast<f32>(((u32(i32(_S4) + i32(127)) << (u32(23))))));
    var _S7 : f32;
    if(x_6 < -87.0f)
    {
        _S7 = 0.0f;
    }
    else
    {
        _S7 = (p_0 * _S5 * _S5 + _S5 + 1.0f) * _S6;
    }
    return _S7;
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S8 : u32 = scene_words_0[index_0];
    var _S9 : vec3<f32> = vec3<f32>(f32((_S8 & (u32(1023)))), f32((((_S8 >> (u32(10)))) & (u32(1023)))), f32((_S8 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S9 * _S9;
}

fn map_level_0( first_0 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S10 : f32 = uv_0.x;
    var _S11 : f32 = f32(side_0);
    var _S12 : f32 = (_S10 - floor(_S10)) * _S11 - 0.5f;
    var _S13 : f32 = uv_0.y;
    var _S14 : f32 = (_S13 - floor(_S13)) * _S11 - 0.5f;
    var _S15 : f32 = floor(_S12);
    var _S16 : i32 = i32(side_0);
    var _S17 : u32 = side_0 - u32(1);
    var _S18 : u32 = (u32(i32(_S15) + _S16) & (_S17));
    var _S19 : f32 = floor(_S14);
    var _S20 : u32 = (u32(i32(_S19) + _S16) & (_S17));
    var _S21 : u32 = ((_S18 + u32(1)) & (_S17));
    var _S22 : u32 = first_0 + _S20 * side_0;
    var _S23 : vec3<f32> = vec3<f32>((_S12 - _S15));
    var _S24 : u32 = first_0 + (((_S20 + u32(1)) & (_S17))) * side_0;
    return mix(mix(map_texel_0(_S22 + _S18), map_texel_0(_S22 + _S21), _S23), mix(map_texel_0(_S24 + _S18), map_texel_0(_S24 + _S21), _S23), vec3<f32>((_S14 - _S19)));
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S25 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S26 : u32 = ((((_S25 >> ((((_S25 >> (u32(28)))) + u32(4))))) ^ (_S25))) * u32(277803737);
    return (((_S26 >> (u32(22)))) ^ (_S26));
}

fn uniform_hash_0( thread_0 : u32,  cell_0 : u32,  stream_0 : u32) -> f32
{
    return (f32(((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_1 : u32,  stream_1 : u32) -> vec2<f32>
{
    var _S27 : u32 = pixel_0.x;
    var _S28 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S27, _S28, stream_1), uniform_hash_0(_S27, _S28, stream_1 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S29 : vec2<f32> = direction_1.xy;
    var _S30 : f32;
    if(back_2)
    {
        _S30 = - direction_1.z;
    }
    else
    {
        _S30 = direction_1.z;
    }
    return vec3<f32>(_S29, _S30);
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S31 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S31, fma(- _S31, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
     thread_1 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S32 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_1 : Cell_0;
    var _S33 : f32 = fma(- _S32, families_0[family_1].size_0, position_1);
    cell_1.below_0 = _S33;
    cell_1.above_0 = families_0[family_1].size_0 - _S33;
    cell_1.across_0 = _S33 - 0.5f * families_0[family_1].size_0;
    cell_1.half_width_1 = families_0[family_1].half_width_0;
    cell_1.thread_1 = u32(clamp(turns_and_remainder_0(family_1, _S32).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_1;
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
    var thread_2 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S35 : u32;
    if(_S34 >= (table_number_0(families_0[family_2].place_table_0 + thread_2 * u32(4) + u32(1))))
    {
        _S35 = u32(1);
    }
    else
    {
        _S35 = u32(0);
    }
    var _S36 : u32 = min(thread_2 + _S35, u32(families_0[family_2].count_0) - u32(1));
    var _S37 : u32 = families_0[family_2].place_table_0 + _S36 * u32(4);
    var cell_2 : Cell_0;
    cell_2.thread_1 = _S36;
    cell_2.below_0 = _S34 - table_number_0(_S37);
    cell_2.above_0 = table_number_0(_S37 + u32(1)) - _S34;
    cell_2.across_0 = _S34 - table_number_0(_S37 + u32(2));
    cell_2.half_width_1 = table_number_0(_S37 + u32(3));
    return cell_2;
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
    var _S38 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S39 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S40 : bool;
    if(_S38)
    {
        if(!_S39)
        {
            _S40 = true;
        }
        else
        {
            _S40 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S40 = false;
    }
    shown_0.is_warp_0 = _S40;
    if(!_S38)
    {
        _S40 = !_S39;
    }
    else
    {
        _S40 = false;
    }
    shown_0.hole_0 = _S40;
    var _S41 : u32;
    if(shown_0.is_warp_0)
    {
        _S41 = crossing_0.warp_word_0;
    }
    else
    {
        _S41 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S41;
    shown_0.on_top_0 = (((_S41 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_1 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    var _S42 : u32;
    if(is_first_0)
    {
        _S42 = first_1.thread_1;
    }
    else
    {
        _S42 = second_0.thread_1;
    }
    cell_3.thread_1 = _S42;
    var _S43 : f32;
    if(is_first_0)
    {
        _S43 = first_1.across_0;
    }
    else
    {
        _S43 = second_0.across_0;
    }
    cell_3.across_0 = _S43;
    if(is_first_0)
    {
        _S43 = first_1.half_width_1;
    }
    else
    {
        _S43 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S43;
    if(is_first_0)
    {
        _S43 = first_1.below_0;
    }
    else
    {
        _S43 = second_0.below_0;
    }
    cell_3.below_0 = _S43;
    if(is_first_0)
    {
        _S43 = first_1.above_0;
    }
    else
    {
        _S43 = second_0.above_0;
    }
    cell_3.above_0 = _S43;
    return cell_3;
}

fn boundary_0( family_4 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S44 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_3) + step_0));
    return fma(_S44.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S44.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_4 : u32,  first_2 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_2) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_4, last_0) - boundary_0(family_5, thread_4, first_2);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_5 : u32) -> Bend_0
{
    var _S45 : Family_std430_0 = families_0[family_6];
    var _S46 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S46 = u32(0);
    }
    else
    {
        _S46 = thread_5 * u32(4);
    }
    var _S47 : u32 = _S45.bend_table_0 + _S46;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S47);
    bend_0.half_tangent_0 = table_number_0(_S47 + u32(1));
    bend_0.arc_0 = table_number_0(_S47 + u32(2));
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
    var _S48 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S49 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S50 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S51 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S52 : i32 = - _S48;
    var _S53 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S52, i32(0));
    run_0.from_start_0 = _S53;
    var _S54 : i32 = _S49 + i32(1);
    var _S55 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S54);
    run_0.to_end_0 = _S55;
    var _S56 : bool = _S53 < _S55;
    run_0.near_start_0 = _S56;
    var _S57 : i32;
    if(_S56)
    {
        _S57 = _S52 - _S50;
    }
    else
    {
        _S57 = _S54;
    }
    var _S58 : i32;
    if(run_0.near_start_0)
    {
        _S58 = _S52;
    }
    else
    {
        _S58 = _S54 + _S51;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    var _S59 : f32;
    if(run_0.straight_0)
    {
        _S59 = 1.0e+06f;
    }
    else
    {
        _S59 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S59;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S57, _S58), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S48 == i32(0);
    run_0.last_crossing_0 = _S49 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_4 : Cell_0) -> Section_0
{
    var _S60 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S61 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S61;
    var _S62 : f32 = _S60 * _S60 - square_1(_S61);
    var _S63 : f32 = rsqrt_0(_S62);
    section_0.drop_0 = _S60 - _S62 * _S63;
    section_0.slope_0 = - _S61 * _S63;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_7) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S64 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S65 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S66 : f32;
    if(_S64)
    {
        _S66 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S66 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S67 : f32 = _S66 - crossed_1.half_width_1;
    var _S68 : bool;
    if(_S64)
    {
        _S68 = run_1.first_crossing_0;
    }
    else
    {
        _S68 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S66 = 0.0f;
    }
    else
    {
        _S66 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S69 : f32;
    if((shown_1.on_top_0) != _S68)
    {
        _S69 = 0.0f;
    }
    else
    {
        var _S70 : Family_std430_0 = families_0[other_1];
        var _S71 : i32;
        if(_S64)
        {
            _S71 = i32(-1);
        }
        else
        {
            _S71 = i32(1);
        }
        _S69 = _S70.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S71);
    }
    var _S72 : f32 = 1.0f / max(2.0f * _S67, 9.999999960041972e-13f);
    var _S73 : f32 = clamp((_S67 - _S65) * _S72, 0.0f, 1.0f);
    var _S74 : f32 = _S66 + (_S69 - _S66) * (_S73 * _S73 * (3.0f - 2.0f * _S73));
    var _S75 : f32 = (_S66 - _S69) * (6.0f * _S73 * (1.0f - _S73) * _S72);
    if(_S64)
    {
        _S66 = 1.0f;
    }
    else
    {
        _S66 = -1.0f;
    }
    return vec2<f32>(_S74, _S75 * _S66);
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
    var _S76 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S76), 9.99999971718068537e-10f);
    var _S77 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S77), 9.99999971718068537e-10f);
    control_0.right_0 = _S76 > 0.0f;
    control_0.up_0 = _S77 > 0.0f;
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

fn outline_distance_0( cell_5 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S78 : f32;
    if(forwards_0)
    {
        _S78 = cell_5.across_0;
    }
    else
    {
        _S78 = - cell_5.across_0;
    }
    var _S79 : f32;
    if(forwards_0)
    {
        _S79 = cell_5.above_0;
    }
    else
    {
        _S79 = cell_5.below_0;
    }
    var _S80 : bool;
    if(forwards_0)
    {
        _S80 = run_2.last_crossing_0;
    }
    else
    {
        _S80 = run_2.first_crossing_0;
    }
    var _S81 : bool;
    if(forwards_0)
    {
        _S81 = run_2.first_crossing_0;
    }
    else
    {
        _S81 = run_2.last_crossing_0;
    }
    var _S82 : f32 = - cell_5.half_width_1;
    var _S83 : bool = _S78 < _S82;
    var _S84 : bool = _S78 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S80 = !_S80;
    }
    else
    {
        _S80 = false;
    }
    if(_S80)
    {
        _S80 = !shown_2.hole_0;
    }
    else
    {
        _S80 = false;
    }
    var _S85 : bool;
    if(_S80)
    {
        _S85 = shown_2.on_top_0;
    }
    else
    {
        _S85 = false;
    }
    if(_S85)
    {
        if(_S81)
        {
            _S81 = _S83;
        }
        else
        {
            _S81 = false;
        }
        _S81 = !_S81;
    }
    else
    {
        _S81 = false;
    }
    if(shown_2.hole_0)
    {
        _S80 = true;
    }
    else
    {
        if(_S80)
        {
            _S80 = !shown_2.on_top_0;
        }
        else
        {
            _S80 = false;
        }
    }
    var _S86 : f32;
    if(_S83)
    {
        _S86 = _S82;
    }
    else
    {
        _S86 = cell_5.half_width_1;
    }
    var _S87 : f32 = _S86 - _S78;
    if(_S80)
    {
        _S78 = 2.0f * _S79 + _S78 - cell_5.half_width_1;
    }
    else
    {
        _S78 = _S79;
    }
    if(_S81)
    {
        if(forwards_0)
        {
            _S78 = run_2.to_end_0;
        }
        else
        {
            _S78 = run_2.from_start_0;
        }
        return _S78;
    }
    if(_S84)
    {
    }
    else
    {
        _S78 = _S87;
    }
    return _S78;
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
    var _S88 : f32 = previous_1.rate_0 * step_4;
    var _S89 : f32 = rate_1 * step_4;
    var _S90 : bool;
    if(!previous_1.known_0)
    {
        _S90 = true;
    }
    else
    {
        _S90 = here_0.hole_1;
    }
    if(_S90)
    {
        _S90 = true;
    }
    else
    {
        _S90 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S90)
    {
        _S90 = true;
    }
    else
    {
        _S90 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S90)
    {
        _S90 = true;
    }
    else
    {
        _S90 = rate_1 <= 0.0f;
    }
    if(_S90)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S88) >= 0.0f)
    {
        _S90 = (3.0f * clearance_1 - _S89) >= 0.0f;
    }
    else
    {
        _S90 = false;
    }
    if(_S90)
    {
        return -1.0f;
    }
    var _S91 : f32 = clearance_1 - previous_1.clearance_0;
    var _S92 : f32 = 6.0f * _S91 - 4.0f * _S88 - 2.0f * _S89;
    var _S93 : f32 = -2.0f * _S88 / max(_S92 + sqrt(max(_S92 * _S92 - 4.0f * (3.0f * (_S88 + _S89 - 2.0f * _S91)) * _S88, 0.0f)), 9.99999968265522539e-21f);
    var _S94 : f32 = 1.0f - _S93;
    var _S95 : f32 = (previous_1.clearance_0 * (2.0f * _S93 + 1.0f) + _S88 * _S93) * _S94 * _S94;
    var _S96 : f32 = (clearance_1 * (2.0f * _S94 + 1.0f) - _S89 * _S94) * _S93 * _S93;
    if(_S93 > 0.01999999955296516f)
    {
        _S90 = _S94 > 0.01999999955296516f;
    }
    else
    {
        _S90 = false;
    }
    if(_S90)
    {
        _S90 = (_S95 + _S96) < 0.0f;
    }
    else
    {
        _S90 = false;
    }
    var _S97 : f32;
    if(_S90)
    {
        _S97 = _S94 * step_4;
    }
    else
    {
        _S97 = -1.0f;
    }
    return _S97;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S98 : f32;
    if(here_1.hole_1)
    {
        _S98 = 1.0e+09f;
    }
    else
    {
        _S98 = clearance_2;
    }
    previous_2.clearance_0 = _S98;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S99 : bool;
    if(!here_1.hole_1)
    {
        _S99 = !is_cell_exit_0;
    }
    else
    {
        _S99 = false;
    }
    previous_2.known_0 = _S99;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_0 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

fn StepControl_to_next_sample_0( this_1 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S100 : f32 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    var _S101 : bool;
    if(!here_2.hole_1)
    {
        _S101 = (rate_3 * _S100 + clearance_3) < 0.0f;
    }
    else
    {
        _S101 = false;
    }
    if(_S101)
    {
        _S101 = _S100 > (2.0f * this_1.epsilon_0);
    }
    else
    {
        _S101 = false;
    }
    var _S102 : f32;
    if(_S101)
    {
        _S102 = _S100 - this_1.epsilon_0;
    }
    else
    {
        _S102 = max(_S100, 0.0f) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S102);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_2 : ViewRay_0,  height_3 : f32) -> vec2<f32>
{
    return this_2.origin_0 + this_2.slope_1 * vec2<f32>(height_3);
}

fn ViewRay_rate_0( this_3 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_3.slope_1.x + here_3.slope_y_0 * this_3.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S103 : f32 = end_0 - start_1;
    var _S104 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S103;
    var _S105 : f32 = 3.0f * _S103 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S103, 9.99999968265522539e-21f);
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
        var _S106 : f32 = clamp(share_1 - (((_S104 * share_1 + _S105) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S104 * share_1 + 2.0f * _S105) * share_1 + start_rate_0, 0.10000000149011612f * _S103 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S107 : i32 = i_0 + i32(1);
        share_1 = _S106;
        i_0 = _S107;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S108 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S109 : f32 = rsqrt_0(_S108);
    var _S110 : f32 = sine_1 * _S109 * rsqrt_0(_S108 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S110 * _S108, _S110 * across_slope_0 * along_slope_0 + cosine_0 * _S109);
}

fn arc_sine_0( x_7 : f32) -> f32
{
    var _S111 : f32 = abs(x_7);
    var _S112 : bool = _S111 > 0.5f;
    var _S113 : f32;
    if(_S112)
    {
        _S113 = 0.5f * (1.0f - _S111);
    }
    else
    {
        _S113 = _S111 * _S111;
    }
    var _S114 : f32;
    if(_S112)
    {
        _S114 = sqrt(max(_S113, 0.0f));
    }
    else
    {
        _S114 = _S111;
    }
    var _S115 : f32 = ((((0.04216320067644119f * _S113 + 0.02418131195008755f) * _S113 + 0.04547002539038658f) * _S113 + 0.07495300471782684f) * _S113 + 0.16666752099990845f) * _S113 * _S114 + _S114;
    if(_S112)
    {
        _S113 = 1.57079637050628662f - 2.0f * _S115;
    }
    else
    {
        _S113 = _S115;
    }
    if(x_7 < 0.0f)
    {
        _S113 = - _S113;
    }
    return _S113;
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

fn albedos_of_0( family_8 : u32,  thread_8 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_8);
}

fn thread_gain_0( thread_9 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S116 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S116.x, _S116.y), _S116.z), 0.0f));
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
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
    var _S117 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S118 : vec3<f32> = sends_0.sky_warp_0 + _S117 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S118;
    var _S119 : vec3<f32> = sends_0.sky_weft_0 + _S117 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S119;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S118 + vec3<f32>(sends_0.blocks_weft_0) * _S119;
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
     back_4 : vec3<f32>,
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
    var _S120 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S121 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_4 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S121 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S121 * interior_0.far_1 + yarn_2.back_4 * _S120;
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
        var _S122 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S122)) <= number_0)
        {
            low_0 = _S122;
        }
        else
        {
            high_0 = _S122;
        }
    }
    var _S123 : u32 = table_0 + low_0;
    var _S124 : f32 = scene_number_0(_S123);
    var _S125 : f32 = scene_number_0(_S123 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S124) / max(_S125 - _S124, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_8 : f32) -> vec2<f32>
{
    var _S126 : f32 = floor(x_8 * 0.63661974668502808f + 0.5f);
    var _S127 : f32 = x_8 - _S126 * 1.5703125f - _S126 * 0.00048375129699707f - _S126 * 7.54979012640433211e-08f;
    var _S128 : f32 = _S127 * _S127;
    var _S129 : f32 = ((-0.00019515295571182f * _S128 + 0.00833216123282909f) * _S128 - 0.16666655242443085f) * _S128 * _S127 + _S127;
    var _S130 : f32 = ((0.00002443315679557f * _S128 - 0.00138873164542019f) * _S128 + 0.04166664555668831f) * _S128 * _S128 - 0.5f * _S128 + 1.0f;
    var _S131 : u32 = (u32(i32(_S126)) & (u32(3)));
    var _S132 : vec2<f32>;
    if(((_S131 & (u32(1)))) != u32(0))
    {
        _S132 = vec2<f32>(_S130, _S129);
    }
    else
    {
        _S132 = vec2<f32>(_S129, _S130);
    }
    var _S133 : f32;
    if(((_S131 & (u32(2)))) != u32(0))
    {
        _S133 = - _S132.x;
    }
    else
    {
        _S133 = _S132.x;
    }
    var _S134 : f32;
    if((((_S131 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S134 = - _S132.y;
    }
    else
    {
        _S134 = _S132.y;
    }
    return vec2<f32>(_S133, _S134);
}

fn diffuse_reflection_0( light_0 : vec3<f32>,  normal_1 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S135 : f32 = light_0.z;
    if(_S135 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S135, 0.0f), max(dot(light_0, normal_1), 0.0f), blend_0);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S136 : f32 = dot(direction_3, tangent_0);
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

fn density_between_0( light_1 : vec3<f32>,  view_1 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S139 : vec3<f32> = light_1 + view_1;
    var _S140 : f32 = dot(_S139, tangent_1);
    return flake_density_0(min(_S140 * _S140 / max(square_0(_S139), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_2 : vec3<f32>,  view_2 : vec3<f32>,  normal_2 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S141 : f32 = dot(light_2, normal_2);
    var _S142 : bool;
    if(_S141 <= 0.0f)
    {
        _S142 = true;
    }
    else
    {
        _S142 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S142)
    {
        return 0.0f;
    }
    var _S143 : f32 = max(_S141, 9.99999997475242708e-07f);
    var _S144 : f32 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    var _S145 : f32 = projected_area_1(light_2, tangent_2, roughness_4) * _S144 + projected_area_1(view_2, tangent_2, roughness_4) * _S143;
    var _S146 : f32 = optical_depth_1 * _S145 / (_S143 * _S144);
    return 0.25f * density_between_0(light_2, view_2, tangent_2, roughness_4) * (_S146 * mean_attenuation_0(_S146)) * _S143 / _S145;
}

fn transmission_1( light_3 : vec3<f32>,  view_3 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S147 : f32 = - dot(light_3, normal_3);
    var _S148 : f32 = dot(view_3, normal_3);
    var _S149 : bool;
    if(_S147 <= 0.0f)
    {
        _S149 = true;
    }
    else
    {
        _S149 = _S148 <= 0.0f;
    }
    if(_S149)
    {
        return 0.0f;
    }
    var _S150 : f32 = 1.0f / max(_S148, 9.99999997475242708e-07f);
    var _S151 : f32 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S147, 9.99999997475242708e-07f);
    var _S152 : f32 = projected_area_1(view_3, tangent_3, roughness_5) * _S150;
    return density_between_0(light_3, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S151, _S152)) * mean_attenuation_0(optical_depth_2 * abs(_S151 - _S152)) * _S150;
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
    var _S153 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S154 : f32 = 2.0f * sqrt(_S153) - 1.0f;
    var _S155 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S154, _S155), 0.00999999977648258f, 1.0f), clamp((1.0f - _S153) * sheen_shear_0(_S154, _S155), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S154, _S155), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_4 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S156 : f32 = light_4.z;
    var _S157 : bool;
    if(_S156 <= 0.0f)
    {
        _S157 = true;
    }
    else
    {
        _S157 = (view_4.z) <= 0.0f;
    }
    if(_S157)
    {
        return 0.0f;
    }
    var _S158 : vec2<f32> = view_4.xy;
    var _S159 : f32 = dot(_S158, _S158);
    var _S160 : vec2<f32>;
    if(_S159 > 9.99999968265522539e-21f)
    {
        _S160 = _S158 * vec2<f32>(rsqrt_0(_S159));
    }
    else
    {
        _S160 = vec2<f32>(1.0f, 0.0f);
    }
    var _S161 : f32 = scale_0 * dot(light_4.xy, _S160) + shear_0 * _S156;
    var _S162 : f32 = scale_0 * (light_4.y * _S160.x - light_4.x * _S160.y);
    var _S163 : f32 = _S161 * _S161 + _S162 * _S162 + _S156 * _S156;
    return 0.31830987334251404f * scale_0 * scale_0 * _S156 / max(_S163 * _S163, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_5 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S164 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S165 : f32 = strength_0 * _S164.z;
    return vec2<f32>(_S165 * transformed_cosine_0(light_5, view_5, _S164.x, _S164.y), 1.0f - _S165);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_6 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S166 : f32 = light_6.z;
    var _S167 : vec3<f32>;
    if((_S166 * view_6.z) < 0.0f)
    {
        _S167 = bounced_1.transmitted_0;
    }
    else
    {
        _S167 = bounced_1.reflected_0;
    }
    return _S167 * vec3<f32>((abs(_S166) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_7 : vec4<f32>)
{
    var _S168 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_7;
    layers_0[index_7].share_0 = _S168 * (1.0f - light_7.w);
    return;
}

fn camera_right_0( _S169 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S169].right_x_0, frames_0[_S169].right_y_0, frames_0[_S169].right_z_0);
}

fn camera_up_0( _S170 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S170].up_x_0, frames_0[_S170].up_y_0, frames_0[_S170].up_z_0);
}

fn camera_forward_0( _S171 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S171].forward_x_0, frames_0[_S171].forward_y_0, frames_0[_S171].forward_z_0);
}

fn camera_origin_0( _S172 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S172].origin_x_0, frames_0[_S172].origin_y_0, frames_0[_S172].origin_z_0);
}

fn face_point_0( _S173 : u32,  _S174 : u32,  _S175 : f32,  _S176 : f32) -> VisiblePoint_0
{
    var _S177 : u32 = u32(3) * _S174;
    var _S178 : Vertex_std430_0 = vertices_0[corners_0[_S177]];
    var _S179 : Vertex_std430_0 = vertices_0[corners_0[_S177 + u32(1)]];
    var _S180 : Vertex_std430_0 = vertices_0[corners_0[_S177 + u32(2)]];
    var _S181 : vec3<f32> = position_of_0(&(_S179));
    var _S182 : vec3<f32> = position_of_0(&(_S178));
    var _S183 : vec3<f32> = _S181 - _S182;
    var _S184 : vec3<f32> = position_of_0(&(_S180));
    var _S185 : vec3<f32> = _S184 - _S182;
    var _S186 : f32 = _S178.u_0;
    var _S187 : f32 = _S179.u_0 - _S178.u_0;
    var _S188 : f32 = _S178.v_0;
    var _S189 : f32 = _S179.v_0 - _S178.v_0;
    var _S190 : vec2<f32> = vec2<f32>(_S187, _S189);
    var _S191 : f32 = _S180.u_0 - _S178.u_0;
    var _S192 : f32 = _S180.v_0 - _S178.v_0;
    var _S193 : vec2<f32> = vec2<f32>(_S191, _S192);
    var _S194 : f32;
    if((_S187 * _S192 - _S189 * _S191) < 0.0f)
    {
        _S194 = -1.0f;
    }
    else
    {
        _S194 = 1.0f;
    }
    var _S195 : vec3<f32> = vec3<f32>(_S194) * (vec3<f32>(_S192) * _S183 - vec3<f32>(_S189) * _S185);
    var _S196 : vec3<f32> = vec3<f32>(_S194) * (vec3<f32>(_S187) * _S185 - vec3<f32>(_S191) * _S183);
    var point_1 : VisiblePoint_0;
    var _S197 : f32 = 1.0f - _S175 - _S176;
    var _S198 : vec3<f32> = normal_of_0(&(_S178));
    var _S199 : vec3<f32> = vec3<f32>(_S197) * _S198;
    var _S200 : vec3<f32> = normal_of_0(&(_S179));
    var _S201 : vec3<f32> = vec3<f32>(_S175);
    var _S202 : vec3<f32> = _S199 + _S201 * _S200;
    var _S203 : vec3<f32> = normal_of_0(&(_S180));
    var _S204 : vec3<f32> = vec3<f32>(_S176);
    var _S205 : vec3<f32> = normalize(_S202 + _S204 * _S203);
    point_1.normal_0 = _S205;
    var _S206 : vec3<f32> = normalize(_S195 - _S205 * vec3<f32>(dot(_S205, _S195)));
    point_1.axis_x_0 = _S206;
    point_1.axis_y_0 = cross(_S205, _S206);
    var _S207 : vec3<f32> = normalize(cross(_S183, _S185));
    var _S208 : vec3<f32>;
    if((dot(_S207, _S205)) < 0.0f)
    {
        _S208 = (vec3<f32>(0) - _S207);
    }
    else
    {
        _S208 = _S207;
    }
    point_1.face_normal_0 = _S208;
    point_1.position_0 = _S182 + _S201 * _S183 + _S204 * _S185;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_1 = vec2<f32>(_S186, _S188) + vec2<f32>(_S175) * _S190 + vec2<f32>(_S176) * _S193;
    var _S209 : bool = (dot(cross(_S195, _S196), point_1.normal_0)) < 0.0f;
    var _S210 : f32 = fabrics_0[_S173].uv_width_0;
    if(_S209)
    {
        _S194 = - fabrics_0[_S173].uv_height_0;
    }
    else
    {
        _S194 = fabrics_0[_S173].uv_height_0;
    }
    var _S211 : vec2<f32> = vec2<f32>(_S210, _S194);
    point_1.draft_per_uv_0 = _S211;
    var _S212 : vec2<f32> = point_1.uv_1 * _S211;
    if(_S209)
    {
        _S194 = fabrics_0[_S173].uv_height_0;
    }
    else
    {
        _S194 = 0.0f;
    }
    point_1.draft_0 = _S212 + vec2<f32>(0.0f, _S194);
    var _S213 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S213;
    point_1.draft_dy_0 = _S213;
    return point_1;
}

fn visible_point_0( _S214 : i32,  _S215 : u32,  _S216 : u32,  _S217 : vec2<u32>) -> VisiblePoint_0
{
    var _S218 : u32 = u32(3) * _S216;
    var _S219 : Vertex_std430_0 = vertices_0[corners_0[_S218]];
    var _S220 : Vertex_std430_0 = vertices_0[corners_0[_S218 + u32(1)]];
    var _S221 : Vertex_std430_0 = vertices_0[corners_0[_S218 + u32(2)]];
    var _S222 : vec3<f32> = position_of_1(&(_S220));
    var _S223 : vec3<f32> = position_of_1(&(_S219));
    var _S224 : vec3<f32> = _S222 - _S223;
    var _S225 : vec3<f32> = position_of_1(&(_S221));
    var _S226 : vec3<f32> = _S225 - _S223;
    var _S227 : vec3<f32> = cross(_S224, _S226);
    var _S228 : f32 = 1.0f / max(square_0(_S227), 1.00000000317107685e-30f);
    var _S229 : f32 = f32(frames_0[_S214].width_0);
    var _S230 : vec3<f32> = camera_right_0(_S214) * vec3<f32>((2.0f / _S229));
    var _S231 : f32 = f32(frames_0[_S214].height_0);
    var _S232 : vec3<f32> = camera_up_0(_S214) * vec3<f32>((-2.0f / _S231));
    var _S233 : vec3<f32> = camera_forward_0(_S214) + vec3<f32>((f32(_S217.x) + 0.5f - 0.5f * _S229)) * _S230 + vec3<f32>((f32(_S217.y) + 0.5f - 0.5f * _S231)) * _S232;
    var _S234 : f32 = dot(_S233, _S227);
    var _S235 : f32;
    if((abs(_S234)) > 1.00000000317107685e-30f)
    {
        _S235 = _S234;
    }
    else
    {
        _S235 = 1.00000000317107685e-30f;
    }
    var _S236 : f32 = 1.0f / _S235;
    var _S237 : vec3<f32> = _S223 - camera_origin_0(_S214);
    var _S238 : vec3<f32> = vec3<f32>((dot(_S237, _S227) * _S236));
    var _S239 : vec3<f32> = _S233 * _S238 - _S237;
    var _S240 : vec3<f32> = _S238 * (_S230 - _S233 * vec3<f32>((dot(_S230, _S227) * _S236)));
    var _S241 : vec3<f32> = _S238 * (_S232 - _S233 * vec3<f32>((dot(_S232, _S227) * _S236)));
    var _S242 : vec3<f32> = vec3<f32>(_S228);
    var _S243 : vec3<f32> = cross(_S226, _S227) * _S242;
    var _S244 : vec3<f32> = cross(_S227, _S224) * _S242;
    var _S245 : vec2<f32> = vec2<f32>(_S220.u_0 - _S219.u_0, _S220.v_0 - _S219.v_0);
    var _S246 : vec2<f32> = vec2<f32>(_S221.u_0 - _S219.u_0, _S221.v_0 - _S219.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S215, _S216, dot(_S239, _S243), dot(_S239, _S244));
    point_2.position_0 = _S223 + _S239;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S233));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S240, _S243)) * _S245 + vec2<f32>(dot(_S240, _S244)) * _S246) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S241, _S243)) * _S245 + vec2<f32>(dot(_S241, _S244)) * _S246) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S247 : u32,  _S248 : VisiblePoint_0) -> vec3<f32>
{
    var _S249 : u32 = fabrics_0[_S247].albedo_map_levels_0;
    if((fabrics_0[_S247].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S250 : vec2<f32> = vec2<f32>(fabrics_0[_S247].uv_width_0, fabrics_0[_S247].uv_height_0);
    var _S251 : vec2<f32> = _S248.draft_dx_0 / _S250;
    var _S252 : vec2<f32> = _S248.draft_dy_0 / _S250;
    var _S253 : u32 = _S249 - u32(1);
    var _S254 : u32 = (u32(1) << (_S253));
    var _S255 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S251.x * _S252.y - _S251.y * _S252.x), 9.99999968265522539e-21f) * (square_1(f32(_S254)) / 3.0f)), 0.0f, f32(_S249) - 1.0f);
    var _S256 : u32 = min(u32(_S255), max(_S249, u32(2)) - u32(2));
    var _S257 : u32 = min(_S256 + u32(1), _S253);
    var _S258 : u32 = (u32(1) << ((u32(2) * _S249)));
    return mix(map_level_0(fabrics_0[_S247].albedo_map_0 + (_S258 - ((_S258 >> ((u32(2) * _S256))))) / u32(3), (_S254 >> (_S256)), _S248.uv_1), map_level_0(fabrics_0[_S247].albedo_map_0 + (_S258 - ((_S258 >> ((u32(2) * _S257))))) / u32(3), (_S254 >> (_S257)), _S248.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S255 - f32(_S256))) - 1.0f) / 3.0f)));
}

struct YarnPoint_0
{
     back_5 : bool,
     hole_2 : bool,
     is_warp_1 : bool,
     x_12 : f32,
     y_5 : f32,
     height_4 : f32,
     normal_4 : vec3<f32>,
     tangent_4 : vec3<f32>,
     roughness_8 : f32,
     albedos_2 : Albedos_0,
};

struct Hit_0
{
     x_13 : f32,
     y_6 : f32,
     hole_3 : bool,
     height_5 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_6 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S259 : u32,  _S260 : f32,  _S261 : f32,  _S262 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S259].warp_0, _S260);
    crossing_2.weft_1 = locate_0(fabrics_0[_S259].weft_0, _S261);
    var _S263 : u32 = fabrics_0[_S259].run_words_0 + u32(2) * (crossing_2.weft_1.thread_1 * fabrics_0[_S259].ends_1 + crossing_2.warp_1.thread_1);
    var _S264 : u32 = words_0[_S263];
    crossing_2.warp_word_0 = _S264;
    crossing_2.weft_word_0 = words_0[_S263 + u32(1)];
    crossing_2.warp_above_0 = (((_S264 & (u32(1)))) == u32(1)) != _S262;
    return crossing_2;
}

fn sample_at_0( _S265 : u32,  _S266 : f32,  _S267 : f32,  _S268 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S269 : Crossing_0 = crossing_at_0(_S265, _S266, _S267, _S268);
    sample_0.crossing_1 = _S269;
    var _S270 : Shown_0 = shown_at_0(_S269, _S268);
    sample_0.shown_3 = _S270;
    var _S271 : u32;
    if(_S270.is_warp_0)
    {
        _S271 = fabrics_0[_S265].warp_0;
    }
    else
    {
        _S271 = fabrics_0[_S265].weft_0;
    }
    var _S272 : u32;
    if(_S270.is_warp_0)
    {
        _S272 = fabrics_0[_S265].weft_0;
    }
    else
    {
        _S272 = fabrics_0[_S265].warp_0;
    }
    var _S273 : Cell_0 = select_cell_0(_S270.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S274 : Cell_0 = select_cell_0(_S270.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S275 : Run_0 = unpack_0(_S271, _S272, _S273.thread_1, _S274, _S270.word_0);
    var _S276 : Section_0 = section_at_0(_S273);
    var _S277 : bool;
    if(_S270.on_top_0)
    {
        _S277 = (_S275.distance_0) < (_S276.drop_0 * _S275.bend_1.sine_0);
    }
    else
    {
        _S277 = false;
    }
    var _S278 : bool;
    if(_S270.on_top_0)
    {
        _S278 = !_S277;
    }
    else
    {
        _S278 = false;
    }
    var _S279 : f32;
    if(_S278)
    {
        _S279 = 1.0f;
    }
    else
    {
        _S279 = -1.0f;
    }
    var _S280 : f32;
    if(_S277)
    {
        _S280 = _S275.other_reach_0;
    }
    else
    {
        _S280 = _S275.reach_0;
    }
    var _S281 : f32;
    if(_S277)
    {
        _S281 = _S280 + _S275.distance_0;
    }
    else
    {
        _S281 = max(_S280 - _S275.distance_0, 0.0f);
    }
    var _S282 : f32 = _S280 / _S275.bend_1.sine_0 - _S279 * _S276.drop_0;
    var _S283 : f32 = _S281 * _S281;
    var _S284 : f32 = max(_S282 * _S282 - _S283, 9.99999968265522539e-21f);
    var _S285 : f32 = rsqrt_0(_S284);
    var _S286 : f32 = _S283 / (_S284 * _S285 + _S282);
    var _S287 : bool = _S281 > 0.0f;
    var _S288 : f32;
    if(_S270.on_top_0)
    {
        _S288 = 1.0f;
    }
    else
    {
        _S288 = -1.0f;
    }
    var _S289 : f32;
    if(_S275.near_start_0)
    {
        _S289 = 1.0f;
    }
    else
    {
        _S289 = -1.0f;
    }
    var _S290 : f32 = _S288 * _S289;
    if(_S287)
    {
        _S288 = _S282 * _S285;
    }
    else
    {
        _S288 = 1.0f;
    }
    sample_0.slope_across_0 = _S276.slope_0 * _S288;
    if(_S287)
    {
        _S281 = _S290 * _S281 * _S285;
    }
    else
    {
        _S281 = 0.0f;
    }
    sample_0.slope_along_0 = _S281;
    var _S291 : Family_std430_0 = families_0[_S271];
    var _S292 : vec2<f32> = dive_0(_S272, _S270, _S275, _S274);
    if(_S275.straight_0)
    {
        _S279 = 0.0f;
    }
    else
    {
        _S279 = _S291.height_scale_0 * _S279;
    }
    sample_0.height_6 = _S279 * (_S280 * _S275.bend_1.half_tangent_0 - _S286) - _S291.height_scale_0 * _S276.drop_0 - _S292.x;
    var _S293 : f32 = _S291.height_scale_0 * sample_0.slope_across_0;
    var _S294 : f32 = _S291.height_scale_0 * sample_0.slope_along_0 - _S292.y;
    if(_S270.is_warp_0)
    {
        _S279 = _S293;
    }
    else
    {
        _S279 = _S294;
    }
    sample_0.slope_x_1 = _S279;
    if(_S270.is_warp_0)
    {
        _S279 = _S294;
    }
    else
    {
        _S279 = _S293;
    }
    sample_0.slope_y_1 = _S279;
    sample_0.run_3 = _S275;
    sample_0.section_1 = _S276;
    return sample_0;
}

fn steps_per_length_0( _S295 : u32,  _S296 : SearchQuality_0,  _S297 : vec3<f32>) -> f32
{
    return max(max(abs(_S297.x) * fabrics_0[_S295].threads_per_x_0, abs(_S297.y) * fabrics_0[_S295].threads_per_y_0) * _S296.steps_per_thread_0, abs(_S297.z) * fabrics_0[_S295].per_relief_0 * _S296.steps_per_relief_0);
}

fn cell_maximum_0( _S298 : u32,  _S299 : Crossing_0) -> f32
{
    var _S300 : u32;
    if(_S299.warp_above_0)
    {
        _S300 = fabrics_0[_S298].warp_0;
    }
    else
    {
        _S300 = fabrics_0[_S298].weft_0;
    }
    var _S301 : u32;
    if(_S299.warp_above_0)
    {
        _S301 = _S299.warp_word_0;
    }
    else
    {
        _S301 = _S299.weft_word_0;
    }
    return f32((_S301 >> (u32(28)))) * families_0[_S300].height_scale_0 * families_0[_S300].level_0;
}

fn probe_0( _S302 : u32,  _S303 : f32,  _S304 : f32,  _S305 : bool,  _S306 : bool,  _S307 : bool) -> Probe_0
{
    var _S308 : Sample_0 = sample_at_0(_S302, _S303, _S304, _S305);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S308.height_6;
    probe_1.hole_1 = _S308.shown_3.hole_0;
    probe_1.slope_x_0 = _S308.slope_x_1;
    probe_1.slope_y_0 = _S308.slope_y_1;
    var _S309 : u32;
    if(_S308.shown_3.is_warp_0)
    {
        _S309 = _S308.crossing_1.warp_1.thread_1 * u32(2) + u32(1);
    }
    else
    {
        _S309 = _S308.crossing_1.weft_1.thread_1 * u32(2);
    }
    probe_1.yarn_1 = _S309;
    probe_1.cell_max_0 = cell_maximum_0(_S302, _S308.crossing_1);
    var _S310 : f32;
    if(_S306)
    {
        _S310 = _S308.crossing_1.warp_1.above_0;
    }
    else
    {
        _S310 = _S308.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S310;
    if(_S307)
    {
        _S310 = _S308.crossing_1.weft_1.above_0;
    }
    else
    {
        _S310 = _S308.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S310;
    probe_1.edge_x_0 = outline_distance_0(_S308.crossing_1.warp_1, _S308.shown_3, _S308.run_3, !_S308.shown_3.is_warp_0, _S306);
    probe_1.edge_y_0 = outline_distance_0(_S308.crossing_1.weft_1, _S308.shown_3, _S308.run_3, _S308.shown_3.is_warp_0, _S307);
    return probe_1;
}

fn is_free_0( _S311 : u32,  _S312 : SearchQuality_0,  _S313 : vec3<f32>,  _S314 : vec3<f32>,  _S315 : bool,  _S316 : f32) -> bool
{
    var _S317 : f32 = _S314.z;
    if(_S317 <= 0.0f)
    {
        return false;
    }
    var _S318 : f32 = 1.0f / max(_S312.shadow_share_0 * steps_per_length_0(_S311, _S312, _S314), 9.99999971718068537e-10f);
    var _S319 : StepControl_0 = step_control_0(_S314.xy, _S318);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S320 : bool;
        if(count_2 < u32(1024))
        {
            _S320 = (_S313.z + _S317 * distance_1) < _S316;
        }
        else
        {
            _S320 = false;
        }
        if(_S320)
        {
        }
        else
        {
            break;
        }
        var _S321 : vec3<f32> = _S313 + _S314 * vec3<f32>(distance_1);
        var _S322 : Probe_0 = probe_0(_S311, _S321.x, _S321.y, _S315, _S319.right_0, _S319.up_0);
        var _S323 : f32 = _S321.z;
        var _S324 : f32 = _S323 - _S322.height_2;
        var _S325 : f32 = _S317 - _S322.slope_x_0 * _S314.x - _S322.slope_y_0 * _S314.y;
        var _S326 : bool;
        if(!_S322.hole_1)
        {
            _S326 = _S324 < 0.0f;
        }
        else
        {
            _S326 = false;
        }
        if(_S326)
        {
            return false;
        }
        var _S327 : f32 = way_back_to_dip_0(previous_3, _S324, _S325, last_step_0, _S322);
        if(_S327 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S327;
            distance_1 = distance_1 - _S327;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S328 : bool = _S323 > (_S322.cell_max_0);
        var _S329 : PreviousSample_0 = after_sample_0(_S324, _S325, _S322, _S328);
        var last_step_2 : f32;
        if(_S328)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S319, _S322.side_x_0, _S322.side_y_0), _S318);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S319, _S322, _S324, _S325);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S329;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S330 : u32,  _S331 : SearchQuality_0,  _S332 : f32,  _S333 : f32,  _S334 : vec3<f32>,  _S335 : bool) -> bool
{
    if(!sample_at_0(_S330, _S332, _S333, _S335).shown_3.hole_0)
    {
        return false;
    }
    var _S336 : vec3<f32> = vec3<f32>(_S332, _S333, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S337 : bool;
        if(side_1 < u32(2))
        {
            _S337 = passes_0;
        }
        else
        {
            _S337 = false;
        }
        if(_S337)
        {
        }
        else
        {
            break;
        }
        var _S338 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S338 = _S334;
        }
        else
        {
            _S338 = vec3<f32>(- _S334.x, - _S334.y, _S334.z);
        }
        var _S339 : bool = is_free_0(_S330, _S331, _S336, _S338, _S335 != (side_1 == u32(1)), fabrics_0[_S330].height_high_0);
        var _S340 : u32 = side_1 + u32(1);
        passes_0 = _S339;
        side_1 = _S340;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_7 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S341 : u32,  _S342 : f32,  _S343 : f32,  _S344 : f32,  _S345 : vec3<f32>,  _S346 : bool) -> f32
{
    var _S347 : u32 = locate_0(fabrics_0[_S341].warp_0, _S342).thread_1 / u32(2);
    var _S348 : u32 = locate_0(fabrics_0[_S341].weft_0, _S343).thread_1 / u32(2);
    var _S349 : f32 = _S345.x;
    var _S350 : u32;
    if(_S349 > 0.0f)
    {
        _S350 = u32(1);
    }
    else
    {
        _S350 = u32(0);
    }
    var _S351 : f32 = _S345.y;
    var _S352 : u32;
    if(_S351 > 0.0f)
    {
        _S352 = u32(2);
    }
    else
    {
        _S352 = u32(0);
    }
    var _S353 : u32 = words_0[fabrics_0[_S341].max_heights_0 + u32(4) * (_S348 * fabrics_0[_S341].max_height_columns_0 + _S347) + (_S350 + _S352)];
    var number_1 : i32;
    if(_S346)
    {
        number_1 = i32(4);
    }
    else
    {
        number_1 = i32(0);
    }
    var _S354 : u32 = (_S353 >> (u32(number_1)));
    var _S355 : f32 = max(abs(_S349) * fabrics_0[_S341].threads_per_x_0, abs(_S351) * fabrics_0[_S341].threads_per_y_0) / _S345.z;
    var _S356 : f32 = fabrics_0[_S341].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S341].height_high_0;
    number_1 = i32(3);
    for(;;)
    {
        if(number_1 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S344) * _S355) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S354 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S356);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S357 : u32,  _S358 : f32,  _S359 : f32,  _S360 : bool,  _S361 : bool,  _S362 : bool) -> vec3<f32>
{
    var _S363 : Crossing_0 = crossing_at_0(_S357, _S358, _S359, _S360);
    var _S364 : f32 = cell_maximum_0(_S357, _S363);
    var _S365 : f32;
    if(_S361)
    {
        _S365 = _S363.warp_1.above_0;
    }
    else
    {
        _S365 = _S363.warp_1.below_0;
    }
    var _S366 : f32;
    if(_S362)
    {
        _S366 = _S363.weft_1.above_0;
    }
    else
    {
        _S366 = _S363.weft_1.below_0;
    }
    return vec3<f32>(_S364, _S365, _S366);
}

fn first_sample_height_0( _S367 : u32,  _S368 : ViewRay_0,  _S369 : StepControl_0,  _S370 : bool) -> f32
{
    var _S371 : f32 = max_height_along_0(_S367, _S368.origin_0.x, _S368.origin_0.y, 0.0f, vec3<f32>(_S368.slope_1, 1.0f), _S370);
    var count_3 : u32 = u32(0);
    var height_8 : f32 = _S371;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S372 : vec2<f32> = ViewRay_at_0(_S368, height_8);
        var _S373 : vec3<f32> = cell_bounds_0(_S367, _S372.x, _S372.y, _S370, _S369.right_0, _S369.up_0);
        var _S374 : f32 = height_8 - _S373.x;
        var _S375 : f32 = StepControl_to_cell_exit_0(_S369, _S373.y, _S373.z);
        var height_9 : f32 = height_8 - clamp(_S374, 0.0f, _S375);
        if(_S374 <= _S375)
        {
            height_8 = height_9;
            break;
        }
        count_3 = count_3 + u32(1);
        height_8 = height_9;
    }
    return height_8;
}

fn search_down_0( _S376 : u32,  _S377 : ViewRay_0,  _S378 : StepControl_0,  _S379 : bool) -> ViewRayEnd_0
{
    var _S380 : f32 = fabrics_0[_S376].height_low_0 - (fabrics_0[_S376].height_high_0 - fabrics_0[_S376].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_7 = first_sample_height_0(_S376, _S377, _S378, _S379);
    end_1.last_step_3 = _S378.epsilon_0;
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
        var _S381 : vec2<f32> = ViewRay_at_0(_S377, end_1.height_7);
        var _S382 : Probe_0 = probe_0(_S376, _S381.x, _S381.y, _S379, _S378.right_0, _S378.up_0);
        var _S383 : f32 = end_1.height_7 - _S382.height_2;
        var _S384 : f32 = ViewRay_rate_0(_S377, _S382);
        end_1.depth_1 = - _S383;
        end_1.rate_4 = _S384;
        var _S385 : bool;
        if(end_1.previous_4.known_0)
        {
            _S385 = !_S382.hole_1;
        }
        else
        {
            _S385 = false;
        }
        var _S386 : bool;
        if(_S385)
        {
            _S386 = (end_1.previous_4.yarn_0) == (_S382.yarn_1);
        }
        else
        {
            _S386 = false;
        }
        end_1.smooth_0 = _S386;
        var _S387 : bool;
        if(!_S382.hole_1)
        {
            _S387 = _S383 <= 0.0f;
        }
        else
        {
            _S387 = false;
        }
        var _S388 : bool;
        if(_S387)
        {
            _S388 = true;
        }
        else
        {
            _S388 = (end_1.height_7) <= _S380;
        }
        if(_S388)
        {
            break;
        }
        var _S389 : f32 = way_back_to_dip_0(end_1.previous_4, _S383, _S384, end_1.last_step_3, _S382);
        if(_S389 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S389;
            end_1.last_step_3 = end_1.last_step_3 - _S389;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S390 : f32 = min(StepControl_to_cell_exit_0(_S378, _S382.side_x_0, _S382.side_y_0), end_1.height_7 - _S382.cell_max_0);
        var _S391 : f32 = StepControl_to_next_sample_0(_S378, _S382, _S383, _S384);
        end_1.previous_4 = after_sample_0(_S383, _S384, _S382, _S390 > _S391);
        var _S392 : f32 = max(_S390, _S391);
        end_1.last_step_3 = _S392;
        end_1.height_7 = end_1.height_7 - _S392;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S393 : u32,  _S394 : ViewRay_0,  _S395 : StepControl_0,  _S396 : bool,  _S397 : ViewRayEnd_0,  _S398 : u32) -> f32
{
    var _S399 : f32 = fabrics_0[_S393].height_high_0 - fabrics_0[_S393].height_low_0;
    var above_2 : f32 = _S397.height_7 + _S397.last_step_3;
    var above_gap_1 : f32 = clamp(_S397.previous_4.clearance_0, 0.0f, _S399);
    var under_gap_1 : f32 = clamp(_S397.depth_1, 0.0f, _S399);
    var _S400 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S397.previous_4.rate_0 * _S397.last_step_3, _S397.rate_4 * _S397.last_step_3);
    var middle_0 : f32;
    if(_S397.smooth_0)
    {
        middle_0 = above_2 - _S400 * _S397.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S397.height_7, above_gap_1, under_gap_1);
    }
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S397.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S398)
        {
        }
        else
        {
            break;
        }
        var _S401 : vec2<f32> = ViewRay_at_0(_S394, middle_0);
        var _S402 : Probe_0 = probe_0(_S393, _S401.x, _S401.y, _S396, _S395.right_0, _S395.up_0);
        var _S403 : f32;
        if(_S402.hole_1)
        {
            _S403 = -1.0e+09f;
        }
        else
        {
            _S403 = _S402.height_2;
        }
        var _S404 : f32 = clamp(middle_0 - _S403, - _S399, _S399);
        var _S405 : f32;
        if(_S404 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S405 = 0.5f * above_gap_2;
            }
            else
            {
                _S405 = above_gap_2;
            }
            var _S406 : f32 = - _S404;
            under_1 = middle_0;
            above_gap_2 = _S405;
            under_gap_2 = _S406;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S405 = 0.5f * under_gap_2;
            }
            else
            {
                _S405 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S404;
            under_gap_2 = _S405;
            side_2 = -1.0f;
        }
        if(_S397.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S404 / min(ViewRay_rate_0(_S394, _S402), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S397.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S407 : u32,  _S408 : SearchQuality_0,  _S409 : f32,  _S410 : f32,  _S411 : vec3<f32>,  _S412 : bool) -> Hit_0
{
    var _S413 : f32 = max(_S411.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S409, _S410);
    var _S414 : vec2<f32> = _S411.xy / vec2<f32>(_S413);
    ray_0.slope_1 = _S414;
    var _S415 : StepControl_0 = step_control_0((vec2<f32>(0) - _S414), 1.0f / max(steps_per_length_0(_S407, _S408, _S411) / _S413, 9.99999971718068537e-10f));
    var _S416 : ViewRayEnd_0 = search_down_0(_S407, ray_0, _S415, _S412);
    var hit_0 : Hit_0;
    hit_0.hole_3 = false;
    var _S417 : f32 = refined_height_0(_S407, ray_0, _S415, _S412, _S416, _S408.refinements_0);
    hit_0.height_5 = _S417;
    var _S418 : vec2<f32> = ViewRay_at_0(ray_0, _S417);
    hit_0.x_13 = _S418.x;
    hit_0.y_6 = _S418.y;
    return hit_0;
}

fn first_hit_0( _S419 : u32,  _S420 : SearchQuality_0,  _S421 : f32,  _S422 : f32,  _S423 : vec3<f32>,  _S424 : bool) -> Hit_0
{
    if(!passes_through_0(_S419, _S420, _S421, _S422, _S423, _S424))
    {
        return first_hit_of_yarn_0(_S419, _S420, _S421, _S422, _S423, _S424);
    }
    var hit_1 : Hit_0;
    hit_1.x_13 = _S421;
    hit_1.y_6 = _S422;
    hit_1.height_5 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_2 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_10 : f32,
     normal_5 : vec3<f32>,
     tangent_5 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn surface_at_0( _S425 : u32,  _S426 : f32,  _S427 : f32,  _S428 : bool) -> SurfacePoint_0
{
    var _S429 : Sample_0 = sample_at_0(_S425, _S426, _S427, _S428);
    var _S430 : f32;
    if(_S429.shown_3.is_warp_0)
    {
        _S430 = _S429.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S430 = _S429.crossing_1.weft_1.half_width_1;
    }
    var _S431 : u32;
    if(_S429.shown_3.is_warp_0)
    {
        _S431 = fabrics_0[_S425].warp_0;
    }
    else
    {
        _S431 = fabrics_0[_S425].weft_0;
    }
    var _S432 : Family_std430_0 = families_0[_S431];
    var _S433 : f32;
    if(_S428)
    {
        _S433 = -1.0f;
    }
    else
    {
        _S433 = 1.0f;
    }
    var _S434 : f32 = _S432.twist_sine_0 * _S433;
    var _S435 : Family_std430_0 = families_0[_S431];
    if(_S429.shown_3.is_warp_0)
    {
        _S433 = 1.0f;
    }
    else
    {
        _S433 = -1.0f;
    }
    var _S436 : vec2<f32> = fibre_direction_0(_S429.slope_across_0, _S433 * _S429.slope_along_0, _S434, _S435.twist_cosine_0);
    var _S437 : f32;
    if(_S429.shown_3.is_warp_0)
    {
        _S437 = _S429.slope_x_1;
    }
    else
    {
        _S437 = _S429.slope_y_1;
    }
    var _S438 : f32;
    if(_S429.shown_3.is_warp_0)
    {
        _S438 = _S429.slope_y_1;
    }
    else
    {
        _S438 = _S429.slope_x_1;
    }
    var _S439 : f32 = _S436.x;
    var _S440 : f32 = _S436.y;
    var _S441 : f32 = _S437 * _S439 + _S433 * _S438 * _S440;
    var _S442 : f32 = _S430 * 1.0154266357421875f;
    var _S443 : f32 = _S442 * arc_sine_0(clamp(_S429.section_1.across_1 / _S442, -1.0f, 1.0f));
    if(_S429.shown_3.is_warp_0)
    {
        _S430 = _S427;
    }
    else
    {
        _S430 = - _S426;
    }
    var point_3 : SurfacePoint_0;
    point_3.hole_4 = _S429.shown_3.hole_0;
    point_3.is_warp_2 = _S429.shown_3.is_warp_0;
    point_3.warp_thread_0 = _S429.crossing_1.warp_1.thread_1;
    point_3.weft_thread_0 = _S429.crossing_1.weft_1.thread_1;
    point_3.height_10 = _S429.height_6;
    point_3.normal_5 = normalize(vec3<f32>(- _S429.slope_x_1, - _S429.slope_y_1, 1.0f));
    var _S444 : vec3<f32>;
    if(_S429.shown_3.is_warp_0)
    {
        _S444 = vec3<f32>(_S439, _S440, _S441);
    }
    else
    {
        _S444 = vec3<f32>(- _S440, _S439, _S441);
    }
    point_3.tangent_5 = normalize(_S444);
    point_3.across_2 = _S429.section_1.across_1;
    point_3.fibre_across_0 = _S443 * _S435.twist_cosine_0 + _S430 * _S434;
    point_3.fibre_along_0 = _S430 * _S435.twist_cosine_0 - _S443 * _S434;
    return point_3;
}

fn vary_albedos_0( _S445 : u32,  _S446 : Albedos_0,  _S447 : u32,  _S448 : u32) -> Albedos_0
{
    var _S449 : vec3<f32> = max(_S446.specular_reflect_0, _S446.specular_transmit_0);
    var _S450 : vec3<f32> = _S446.diffuse_reflect_0 + _S446.diffuse_transmit_0;
    var _S451 : vec3<f32> = vec3<f32>(fabrics_0[_S445].layer_bound_0);
    var _S452 : vec3<f32> = vec3<f32>(1.0f);
    var _S453 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S447, fabrics_0[_S445].colour_noise_0, fabrics_0[_S445].seed_0), _S450, _S452 - _S451 * _S449));
    var _S454 : f32 = bounded_gain_0(fibre_gain_0(_S447, _S448, fabrics_0[_S445].fibre_noise_0, fabrics_0[_S445].seed_0), _S449, min((_S452 - _S453 * _S450) / _S451, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S453 * _S446.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S453 * _S446.diffuse_transmit_0;
    var _S455 : vec3<f32> = vec3<f32>(_S454);
    varied_0.specular_reflect_0 = _S455 * _S446.specular_reflect_0;
    varied_0.specular_transmit_0 = _S455 * _S446.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S456 : u32,  _S457 : SurfacePoint_0,  _S458 : Albedos_0,  _S459 : f32,  _S460 : f32) -> Albedos_0
{
    var _S461 : f32;
    if(_S457.is_warp_2)
    {
        _S461 = _S459;
    }
    else
    {
        _S461 = _S460;
    }
    var _S462 : f32 = _S461 - _S457.across_2;
    var _S463 : u32;
    if(_S457.is_warp_2)
    {
        _S463 = fabrics_0[_S456].warp_0;
    }
    else
    {
        _S463 = fabrics_0[_S456].weft_0;
    }
    var _S464 : Family_std430_0 = families_0[_S463];
    var _S465 : i32 = i32(families_0[_S463].count_0);
    if(_S457.is_warp_2)
    {
        _S463 = _S457.warp_thread_0;
    }
    else
    {
        _S463 = _S457.weft_thread_0;
    }
    var _S466 : u32 = u32(i32(floor(_S462 / _S464.period_0)) * _S465 + i32(_S463)) * u32(2);
    if(_S457.is_warp_2)
    {
        _S463 = u32(1);
    }
    else
    {
        _S463 = u32(0);
    }
    var _S467 : f32 = floor(_S457.fibre_across_0 / fabrics_0[_S456].fibre_size_0);
    return vary_albedos_0(_S456, _S458, _S466 + _S463, u32(i32(_S467)) * u32(65536) + u32(i32(floor(_S457.fibre_along_0 / (fabrics_0[_S456].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S467))));
}

fn yarn_point_of_0( _S468 : u32,  _S469 : SurfacePoint_0,  _S470 : f32,  _S471 : f32,  _S472 : bool,  _S473 : bool) -> YarnPoint_0
{
    var _S474 : u32;
    if(_S469.is_warp_2)
    {
        _S474 = fabrics_0[_S468].warp_0;
    }
    else
    {
        _S474 = fabrics_0[_S468].weft_0;
    }
    var _S475 : u32;
    if(_S469.is_warp_2)
    {
        _S475 = _S469.warp_thread_0;
    }
    else
    {
        _S475 = _S469.weft_thread_0;
    }
    var albedos_3 : Albedos_0 = albedos_of_0(_S474, _S475);
    var _S476 : bool;
    if((fabrics_0[_S468].fibre_noise_0) > 0.0f)
    {
        _S476 = true;
    }
    else
    {
        _S476 = (fabrics_0[_S468].colour_noise_0) > 0.0f;
    }
    var albedos_4 : Albedos_0;
    if(_S476)
    {
        albedos_4 = varied_at_0(_S468, _S469, albedos_3, _S470, _S471);
    }
    else
    {
        albedos_4 = albedos_3;
    }
    var point_4 : YarnPoint_0;
    point_4.back_5 = _S472;
    point_4.hole_2 = _S473;
    point_4.is_warp_1 = _S469.is_warp_2;
    point_4.x_12 = _S470;
    point_4.y_5 = _S471;
    point_4.height_4 = _S469.height_10;
    point_4.normal_4 = _S469.normal_5;
    point_4.tangent_4 = _S469.tangent_5;
    point_4.roughness_8 = families_0[_S474].roughness_0;
    point_4.albedos_2 = albedos_4;
    return point_4;
}

fn locate_yarn_0( _S477 : u32,  _S478 : SearchQuality_0,  _S479 : f32,  _S480 : f32,  _S481 : vec3<f32>) -> YarnPoint_0
{
    var _S482 : bool = (_S481.z) < 0.0f;
    var _S483 : Hit_0 = first_hit_0(_S477, _S478, _S479, _S480, to_face_frame_0(_S481, _S482), _S482);
    return yarn_point_of_0(_S477, surface_at_0(_S477, _S483.x_13, _S483.y_6, _S482), _S483.x_13, _S483.y_6, _S482, _S483.hole_3);
}

fn openness_number_0( _S484 : u32,  _S485 : u32) -> f32
{
    return table_number_0(fabrics_0[_S484].openness_0 + _S485);
}

fn blocked_of_terms_0( _S486 : u32,  _S487 : u32,  _S488 : array<f32, i32(6)>,  _S489 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_2 : u32 = u32(0);
    for(;;)
    {
        if(share_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_2] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S489)
            {
            }
            else
            {
                break;
            }
            shares_0[share_2] = shares_0[share_2] + openness_number_0(_S486, _S487 + share_2 * _S489 + term_0) * _S488[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_2] = saturate(shares_0[share_2]);
        share_2 = share_2 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_at_0( _S490 : u32,  _S491 : bool,  _S492 : bool,  _S493 : f32,  _S494 : f32) -> Blocked_0
{
    var _S495 : f32 = _S494 * openness_number_0(_S490, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S493, _S495, _S493 * _S493, _S493 * _S495, _S495 * _S495 );
    var _S496 : u32;
    if(_S492)
    {
        _S496 = u32(2);
    }
    else
    {
        _S496 = u32(0);
    }
    var _S497 : u32;
    if(_S491)
    {
        _S497 = u32(0);
    }
    else
    {
        _S497 = u32(1);
    }
    return blocked_of_terms_0(_S490, u32(60) + (_S496 + _S497) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S498 : u32,  _S499 : Albedos_0,  _S500 : u32,  _S501 : vec3<f32>) -> Scattered_0
{
    var _S502 : u32 = u32(159) + u32(2) * _S500;
    var yarn_3 : Scattered_0;
    yarn_3.back_4 = _S501 * _S499.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S498, _S502)) * _S499.specular_reflect_0;
    yarn_3.through_0 = _S501 * _S499.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S498, _S502 + u32(1))) * _S499.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S503 : u32,  _S504 : u32,  _S505 : vec3<f32>,  _S506 : vec3<f32>,  _S507 : vec3<f32>,  _S508 : vec3<f32>,  _S509 : ptr<function, vec3<f32>>,  _S510 : ptr<function, vec3<f32>>)
{
    var _S511 : u32 = u32(146) + u32(4) * _S504;
    var _S512 : f32 = openness_number_0(_S503, _S511 + u32(1));
    var _S513 : f32 = openness_number_0(_S503, _S511 + u32(2));
    var _S514 : vec3<f32> = vec3<f32>(1.0f);
    var _S515 : vec3<f32> = _S514 - _S507 * vec3<f32>(openness_number_0(_S503, _S511));
    var _S516 : vec3<f32> = _S514 - _S508 * vec3<f32>(openness_number_0(_S503, _S511 + u32(3)));
    var _S517 : vec3<f32> = _S514 / (_S515 * _S516 - _S507 * _S508 * vec3<f32>((_S512 * _S513)));
    (*_S509) = (_S505 * _S516 + _S507 * vec3<f32>(_S512) * _S506) * _S517;
    (*_S510) = (_S506 * _S515 + _S508 * vec3<f32>(_S513) * _S505) * _S517;
    return;
}

fn face_sends_0( _S518 : u32,  _S519 : u32,  _S520 : Scattered_0,  _S521 : Scattered_0) -> FaceSends_0
{
    var _S522 : u32 = u32(2) * _S519;
    var _S523 : u32 = u32(142) + _S522;
    var _S524 : f32 = openness_number_0(_S518, _S523);
    var _S525 : f32 = openness_number_0(_S518, _S523 + u32(1));
    var _S526 : vec3<f32> = vec3<f32>((1.0f - _S524)) * _S520.back_4;
    var _S527 : vec3<f32> = vec3<f32>((1.0f - _S525)) * _S521.back_4;
    var sends_1 : FaceSends_0;
    var _S528 : u32 = u32(154) + _S522;
    var _S529 : f32 = openness_number_0(_S518, _S528);
    sends_1.blocks_warp_0 = _S529;
    var _S530 : f32 = openness_number_0(_S518, _S528 + u32(1));
    sends_1.blocks_weft_0 = _S530;
    sends_1.open_0 = _S529 * _S524 + _S530 * _S525;
    var _S531 : vec3<f32> = vec3<f32>(_S524) * _S520.back_4;
    var _S532 : vec3<f32> = vec3<f32>(_S525) * _S521.back_4;
    var _S533 : vec3<f32> = sends_1.sky_warp_0;
    var _S534 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S518, _S519, _S531, _S532, _S526, _S527, &(_S533), &(_S534));
    sends_1.sky_warp_0 = _S533;
    sends_1.sky_weft_0 = _S534;
    var _S535 : vec3<f32> = sends_1.crossing_warp_0;
    var _S536 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S518, _S519, _S520.through_0, _S521.through_0, _S526, _S527, &(_S535), &(_S536));
    sends_1.crossing_warp_0 = _S535;
    sends_1.crossing_weft_0 = _S536;
    return sends_1;
}

fn interior_of_0( _S537 : u32,  _S538 : vec3<f32>,  _S539 : bool) -> Interior_0
{
    var _S540 : Scattered_0 = scattered_by_0(_S537, table_albedos_0(families_0[fabrics_0[_S537].warp_0].colour_mean_0), u32(0), _S538);
    var _S541 : Scattered_0 = scattered_by_0(_S537, table_albedos_0(families_0[fabrics_0[_S537].weft_0].colour_mean_0), u32(1), _S538);
    var _S542 : u32;
    if(_S539)
    {
        _S542 = u32(1);
    }
    else
    {
        _S542 = u32(0);
    }
    var _S543 : FaceSends_0 = face_sends_0(_S537, _S542, _S540, _S541);
    if(_S539)
    {
        _S542 = u32(0);
    }
    else
    {
        _S542 = u32(1);
    }
    var _S544 : FaceSends_0 = face_sends_0(_S537, _S542, _S540, _S541);
    var _S545 : vec3<f32> = vec3<f32>(_S543.blocks_warp_0);
    var _S546 : vec3<f32> = vec3<f32>(_S543.blocks_weft_0);
    var _S547 : vec3<f32> = _S545 * _S543.crossing_warp_0 + _S546 * _S543.crossing_weft_0;
    var _S548 : vec3<f32> = vec3<f32>(_S544.blocks_warp_0);
    var _S549 : vec3<f32> = vec3<f32>(_S544.blocks_weft_0);
    var _S550 : vec3<f32> = _S548 * _S544.crossing_warp_0 + _S549 * _S544.crossing_weft_0;
    var _S551 : f32 = 1.0f - _S543.open_0;
    var _S552 : f32 = 1.0f - _S544.open_0;
    var _S553 : vec3<f32> = vec3<f32>(1.0f);
    var _S554 : vec3<f32> = _S553 / (_S553 - _S547 * _S550 * vec3<f32>((_S551 * _S552)));
    var _S555 : vec3<f32> = _S550 * (vec3<f32>(_S543.open_0) + vec3<f32>(_S551) * (_S545 * _S543.sky_warp_0 + _S546 * _S543.sky_weft_0)) * _S554;
    var _S556 : vec3<f32> = _S547 * (vec3<f32>(_S544.open_0) + vec3<f32>(_S552) * (_S548 * _S544.sky_warp_0 + _S549 * _S544.sky_weft_0)) * _S554;
    var _S557 : FaceRadiance_0 = face_radiance_0(_S543, _S544.open_0, _S555, _S556);
    var _S558 : FaceRadiance_0 = face_radiance_0(_S544, _S543.open_0, _S556, _S555);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S557.warp_2;
    interior_1.weft_3 = _S557.weft_2;
    interior_1.leaked_1 = _S557.leaked_0;
    interior_1.far_1 = _S558.mean_0;
    interior_1.far_leaked_0 = _S558.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S559 : u32,  _S560 : YarnPoint_0,  _S561 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S562 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S562;
    nothing_0.transmitted_0 = _S562;
    var _S563 : bool;
    if((fabrics_0[_S559].openness_0) == u32(4294967295))
    {
        _S563 = true;
    }
    else
    {
        _S563 = _S560.hole_2;
    }
    if(_S563)
    {
        return nothing_0;
    }
    var _S564 : Blocked_0 = blocked_at_0(_S559, _S560.is_warp_1, _S560.back_5, _S560.normal_4.z, _S560.height_4);
    var _S565 : u32;
    if(_S560.is_warp_1)
    {
        _S565 = u32(0);
    }
    else
    {
        _S565 = u32(1);
    }
    return bounced_by_0(_S564, scattered_by_0(_S559, _S560.albedos_2, _S565, _S561), interior_of_0(_S559, _S561, _S560.back_5));
}

fn light_sample_count_0( _S566 : i32) -> u32
{
    return frames_0[_S566].lights_0 + frames_0[_S566].environment_samples_0;
}

fn visibility_at_0( _S567 : i32,  _S568 : u32,  _S569 : vec2<u32>) -> f32
{
    if((frames_0[_S567].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S568 * frames_0[_S567].height_0 + _S569.y) * frames_0[_S567].width_0 + _S569.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S570 : i32,  _S571 : u32,  _S572 : u32) -> vec3<f32>
{
    var _S573 : u32 = frames_0[_S570].environment_table_0 + frames_0[_S570].environment_rows_0 + u32(1) + frames_0[_S570].environment_rows_0 * (frames_0[_S570].environment_columns_0 + u32(1)) + u32(3) * (_S571 * frames_0[_S570].environment_columns_0 + _S572);
    return vec3<f32>(scene_number_0(_S573), scene_number_0(_S573 + u32(1)), scene_number_0(_S573 + u32(2)));
}

fn sample_environment_0( _S574 : i32,  _S575 : vec2<f32>,  _S576 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S577 : u32 = frames_0[_S574].environment_rows_0;
    var _S578 : Choice_0 = choose_0(frames_0[_S574].environment_table_0, frames_0[_S574].environment_rows_0, _S575.y);
    var _S579 : u32 = frames_0[_S574].environment_columns_0;
    var _S580 : Choice_0 = choose_0(frames_0[_S574].environment_table_0 + frames_0[_S574].environment_rows_0 + u32(1) + _S578.index_6 * (frames_0[_S574].environment_columns_0 + u32(1)), frames_0[_S574].environment_columns_0, _S575.x);
    var _S581 : vec3<f32> = environment_texel_0(_S574, _S578.index_6, _S580.index_6);
    (*_S576) = _S581 * vec3<f32>((frames_0[_S574].environment_total_0 / max(mean_1(_S581), 9.99999968265522539e-21f)));
    var _S582 : f32 = 3.14159274101257324f / f32(_S577);
    var _S583 : f32 = mix(sine_cosine_0(f32(_S578.index_6) * _S582).y, sine_cosine_0(f32(_S578.index_6 + u32(1)) * _S582).y, _S578.remainder_0);
    var _S584 : f32 = sqrt(max(1.0f - _S583 * _S583, 0.0f));
    var _S585 : vec2<f32> = sine_cosine_0((f32(_S580.index_6) + _S580.remainder_0) * (6.28318548202514648f / f32(_S579)));
    var _S586 : f32 = _S584 * _S585.x;
    var _S587 : f32 = - _S584 * _S585.y;
    return vec3<f32>(frames_0[_S574].environment_cosine_0 * _S586 + frames_0[_S574].environment_sine_0 * _S587, _S583, frames_0[_S574].environment_cosine_0 * _S587 - frames_0[_S574].environment_sine_0 * _S586);
}

fn light_sample_0( _S588 : i32,  _S589 : u32,  _S590 : vec2<u32>,  _S591 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S592 : u32 = frames_0[_S588].lights_0;
    if(_S589 >= (frames_0[_S588].lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S593 : vec3<f32> = sample_environment_0(_S588, pixel_sequence_0(_S590, frames_0[_S588].pass_number_0 * frames_0[_S588].environment_samples_0 + (_S589 - _S592), u32(3)), &(weight_0));
        sample_1.towards_0 = _S593;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frames_0[_S588].environment_samples_0));
        return sample_1;
    }
    var _S594 : Light_std430_0 = lights_1[_S589];
    sample_1.irradiance_1 = vec3<f32>(_S594.red_0, _S594.green_0, _S594.blue_0);
    sample_1.towards_0 = vec3<f32>(_S594.x_1, _S594.y_1, _S594.z_1);
    if((_S594.is_point_0) != u32(0))
    {
        var _S595 : vec3<f32> = sample_1.towards_0 - _S591;
        var _S596 : f32 = max(square_0(_S595), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S596);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S596);
        sample_1.towards_0 = normalize(_S595);
    }
    return sample_1;
}

fn scattered_0( _S597 : u32,  _S598 : YarnPoint_0,  _S599 : vec3<f32>,  _S600 : vec3<f32>) -> vec3<f32>
{
    var _S601 : vec3<f32> = vec3<f32>(0.0f);
    var _S602 : bool = !_S598.hole_2;
    var _S603 : bool;
    if(_S602)
    {
        _S603 = (_S599.z) > 0.0f;
    }
    else
    {
        _S603 = false;
    }
    var value_1 : vec3<f32>;
    if(_S603)
    {
        value_1 = _S598.albedos_2.diffuse_reflect_0 * vec3<f32>(diffuse_reflection_0(_S599, _S598.normal_4, fabrics_0[_S597].diffuse_blend_0)) + _S598.albedos_2.specular_reflect_0 * vec3<f32>(reflection_0(_S599, _S600, _S598.normal_4, _S598.tangent_4, _S598.roughness_8, fabrics_0[_S597].optical_depth_0));
    }
    else
    {
        if(_S602)
        {
            _S603 = (_S599.z) < 0.0f;
        }
        else
        {
            _S603 = false;
        }
        if(_S603)
        {
            value_1 = _S598.albedos_2.diffuse_transmit_0 * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S599), _S598.normal_4, fabrics_0[_S597].diffuse_blend_0)) + _S598.albedos_2.specular_transmit_0 * vec3<f32>(transmission_1(_S599, _S600, _S598.normal_4, _S598.tangent_4, _S598.roughness_8, fabrics_0[_S597].optical_depth_0));
        }
        else
        {
            value_1 = _S601;
        }
    }
    var _S604 : f32 = fabrics_0[_S597].sheen_strength_0;
    if((fabrics_0[_S597].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S605 : vec2<f32> = sheen_with_transmittance_0(_S599, _S600, _S604, fabrics_0[_S597].sheen_roughness_0);
    return vec3<f32>(_S605.y) * value_1 + vec3<f32>(_S605.x);
}

fn unoccluded_0( _S606 : u32,  _S607 : SearchQuality_0,  _S608 : f32,  _S609 : f32,  _S610 : f32,  _S611 : vec3<f32>,  _S612 : bool) -> bool
{
    if((_S611.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S606, _S607, vec3<f32>(_S608, _S609, _S610 + fabrics_0[_S606].lift_0), _S611, _S612, max_height_along_0(_S606, _S608, _S609, _S610, _S611, _S612));
}

fn is_lit_0( _S613 : u32,  _S614 : SearchQuality_0,  _S615 : YarnPoint_0,  _S616 : vec3<f32>) -> bool
{
    if(_S615.hole_2)
    {
        return true;
    }
    var _S617 : vec3<f32> = to_face_frame_0(_S616, _S615.back_5);
    var _S618 : f32 = _S617.z;
    var _S619 : bool = _S618 < 0.0f;
    var normal_6 : vec3<f32>;
    var height_11 : f32;
    if(_S619)
    {
        var _S620 : SurfacePoint_0 = surface_at_0(_S613, _S615.x_12, _S615.y_5, !_S615.back_5);
        normal_6 = _S620.normal_5;
        height_11 = _S620.height_10;
    }
    else
    {
        normal_6 = _S615.normal_4;
        height_11 = _S615.height_4;
    }
    var _S621 : vec3<f32> = vec3<f32>(_S617.xy, abs(_S618));
    if((dot(normal_6, _S621)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S613, _S614, _S615.x_12, _S615.y_5, height_11, _S621, (_S615.back_5) != _S619);
}

fn evaluate_with_0( _S622 : u32,  _S623 : SearchQuality_0,  _S624 : YarnPoint_0,  _S625 : Bounced_0,  _S626 : vec3<f32>,  _S627 : vec3<f32>) -> vec3<f32>
{
    var _S628 : vec3<f32> = to_face_frame_0(_S627, _S624.back_5);
    var _S629 : vec3<f32> = scattered_0(_S622, _S624, to_face_frame_0(_S626, _S624.back_5), _S628);
    var _S630 : bool;
    if((max(_S629.x, max(_S629.y, _S629.z))) <= 0.0f)
    {
        _S630 = true;
    }
    else
    {
        _S630 = !is_lit_0(_S622, _S623, _S624, _S626);
    }
    var value_2 : vec3<f32>;
    if(_S630)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S629;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S625, _S626, _S627);
    var _S631 : f32 = fabrics_0[_S622].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S622].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S631 * sheen_lobe_0(abs(_S628.z), fabrics_0[_S622].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S632 : u32,  _S633 : YarnPoint_0,  _S634 : vec3<f32>) -> f32
{
    if(!_S633.hole_2)
    {
        return 0.0f;
    }
    var _S635 : f32 = fabrics_0[_S632].sheen_strength_0;
    if((fabrics_0[_S632].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S635 * sheen_lobe_0(abs(_S634.z), fabrics_0[_S632].sheen_roughness_0).z;
}

fn light_of_point_0( _S636 : i32,  _S637 : u32,  _S638 : VisiblePoint_0,  _S639 : vec2<u32>,  _S640 : vec3<f32>,  _S641 : vec2<f32>) -> vec4<f32>
{
    var _S642 : SearchQuality_0 = default_quality_0();
    var _S643 : vec3<f32> = to_local_0(_S638, _S638.view_0);
    var _S644 : YarnPoint_0 = locate_yarn_0(_S637, _S642, _S641.x, _S641.y, _S643);
    var point_5 : YarnPoint_0 = _S644;
    var _S645 : Bounced_0 = bounced_at_0(_S637, _S644, _S640);
    point_5.albedos_2 = tinted_0(point_5.albedos_2, _S640);
    var _S646 : vec3<f32> = vec3<f32>(0.0f);
    var number_2 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S646;
    for(;;)
    {
        if(number_2 < (light_sample_count_0(_S636)))
        {
        }
        else
        {
            break;
        }
        var _S647 : f32 = visibility_at_0(_S636, number_2, _S639);
        if(_S647 <= 0.0f)
        {
            number_2 = number_2 + u32(1);
            continue;
        }
        var _S648 : LightSample_0 = light_sample_0(_S636, number_2, _S639, _S638.position_0);
        radiance_1 = radiance_1 + vec3<f32>(_S647) * _S648.irradiance_1 * evaluate_with_0(_S637, _S642, point_5, _S645, to_local_0(_S638, _S648.towards_0), _S643);
        number_2 = number_2 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S637, point_5, _S643));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S649 : u32;
    var _S650 : u32 = id_0.x;
    var _S651 : u32 = frames_0[i32(0)].width_0;
    var _S652 : bool;
    if(_S650 >= (frames_0[i32(0)].width_0))
    {
        _S652 = true;
    }
    else
    {
        _S652 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S652)
    {
        return;
    }
    var _S653 : vec2<u32> = id_0.xy;
    var _S654 : u32 = id_0.y * _S651 + _S650;
    var _S655 : u32 = layers_0[_S654].face_0;
    if((layers_0[_S654].face_0) == u32(0))
    {
        return;
    }
    var _S656 : u32 = _S655 - u32(1);
    var _S657 : u32 = face_fabrics_0[_S656];
    var _S658 : VisiblePoint_0 = visible_point_0(i32(0), _S657, _S656, _S653);
    var _S659 : vec3<f32> = filtered_albedo_0(_S657, _S658);
    var _S660 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S660;
    for(;;)
    {
        var _S661 : u32 = frames_0[i32(0)].samples_0;
        _S649 = frames_0[i32(0)].samples_0;
        if(k_0 < (frames_0[i32(0)].samples_0))
        {
        }
        else
        {
            break;
        }
        var _S662 : vec2<f32> = pixel_sequence_0(_S653, frames_0[i32(0)].pass_number_0 * _S661 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(i32(0), _S657, _S658, _S653, _S659, _S658.draft_0 + vec2<f32>(_S662.x) * _S658.draft_dx_0 + vec2<f32>(_S662.y) * _S658.draft_dy_0);
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S654, sum_0 / vec4<f32>(f32(_S649)));
    return;
}

