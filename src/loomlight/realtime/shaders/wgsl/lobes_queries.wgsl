@binding(1) @group(1) var<storage, read> query_count_0 : array<u32>;

struct Query_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) centre_x_0 : f32,
    @align(4) centre_y_0 : f32,
    @align(4) dx_x_0 : f32,
    @align(4) dx_y_0 : f32,
    @align(4) dy_x_0 : f32,
    @align(4) dy_y_0 : f32,
    @align(4) light_x_0 : f32,
    @align(4) light_y_0 : f32,
    @align(4) light_z_0 : f32,
    @align(4) view_x_0 : f32,
    @align(4) view_y_0 : f32,
    @align(4) view_z_0 : f32,
    @align(4) seed_0 : u32,
};

@binding(0) @group(1) var<storage, read> queries_0 : array<Query_std430_0>;

@binding(2) @group(1) var<storage, read_write> answers_0 : array<vec4<f32>>;

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
    @align(4) width_0 : f32,
    @align(4) height_0 : f32,
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
    @align(4) samples_0 : u32,
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
    @align(4) seed_1 : u32,
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

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
var<private> POINT_OFFSETS_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(0.0f, 0.0f), vec2<f32>(-0.23010000586509705f, 0.35670000314712524f), vec2<f32>(0.36809998750686646f, -0.22939999401569366f), vec2<f32>(-0.28040000796318054f, -0.34400001168251038f), vec2<f32>(0.3465999960899353f, 0.28859999775886536f), vec2<f32>(-0.36349999904632568f, 0.0511000007390976f), vec2<f32>(0.09929999709129333f, -0.35699999332427979f), vec2<f32>(0.10710000246763229f, 0.32879999279975891f) );
struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S1 : vec2<f32> = this_0.dx_0;
    var _S2 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S1, _S1) + dot(_S2, _S2)));
}

fn natural_logarithm_0( x_1 : f32) -> f32
{
    var _S3 : u32 = (bitcast<u32>((x_1)));
    var exponent_0 : f32 = f32(i32((_S3 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S3 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S4 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S4 - exponent_1 * 0.00021219444170129f - 0.5f * _S4) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_2 : f32) -> f32
{
    return natural_logarithm_0(x_2) * 1.4426950216293335f;
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S5 : vec2<f32> = direction_0.xy;
    var _S6 : f32;
    if(back_2)
    {
        _S6 = - direction_0.z;
    }
    else
    {
        _S6 = direction_0.z;
    }
    return vec3<f32>(_S5, _S6);
}

struct SurfacePoint_0
{
     hole_0 : bool,
     is_warp_0 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_1 : f32,
     normal_0 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_0 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_2 : f32,  normal_1 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32) -> SurfacePoint_0
{
    var _S7 : SurfacePoint_0;
    _S7.hole_0 = hole_1;
    _S7.is_warp_0 = is_warp_1;
    _S7.warp_thread_0 = warp_thread_1;
    _S7.weft_thread_0 = weft_thread_1;
    _S7.height_1 = height_2;
    _S7.normal_0 = normal_1;
    _S7.tangent_0 = tangent_1;
    _S7.across_0 = across_1;
    _S7.fibre_across_0 = fibre_across_1;
    _S7.fibre_along_0 = fibre_along_1;
    return _S7;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_2 : f32,
};

fn no_components_0() -> Components_0
{
    var nothing_0 : Components_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_2 = 0.0f;
    return nothing_0;
}

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

fn no_blocked_0() -> Blocked_0
{
    var nothing_1 : Blocked_0;
    nothing_1.by_warp_0 = 0.0f;
    nothing_1.by_weft_0 = 0.0f;
    nothing_1.far_0 = 0.0f;
    return nothing_1;
}

struct CloseUp_0
{
     weight_0 : f32,
     warp_1 : Blocked_0,
     weft_1 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_2 : CloseUp_0;
    nothing_2.weight_0 = 0.0f;
    var _S8 : Blocked_0 = no_blocked_0();
    nothing_2.warp_1 = _S8;
    nothing_2.weft_1 = _S8;
    return nothing_2;
}

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn quality_of_0( threads_0 : f32) -> SearchQuality_0
{
    var _S9 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S10 : f32 = mix(2.5f, 5.0f, _S9);
    quality_0.steps_per_thread_0 = _S10;
    quality_0.steps_per_relief_0 = _S10;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S9);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S9) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_0 : f32) -> vec2<f32>
{
    var _S11 : f32 = floor(fma(index_0, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S11, fma(- _S11, families_0[family_0].count_0, index_0));
}

struct Cell_0
{
     thread_0 : u32,
     across_2 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_0 : f32) -> Cell_0
{
    var _S12 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S13 : f32 = fma(- _S12, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S13;
    cell_0.above_0 = families_0[family_1].size_0 - _S13;
    cell_0.across_2 = _S13 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S12).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn locate_varied_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S14 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S15 : u32;
    if(_S14 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S15 = u32(1);
    }
    else
    {
        _S15 = u32(0);
    }
    var _S16 : u32 = min(thread_1 + _S15, u32(families_0[family_2].count_0) - u32(1));
    var _S17 : u32 = families_0[family_2].place_table_0 + _S16 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S16;
    cell_1.below_0 = _S14 - table_number_0(_S17);
    cell_1.above_0 = table_number_0(_S17 + u32(1)) - _S14;
    cell_1.across_2 = _S14 - table_number_0(_S17 + u32(2));
    cell_1.half_width_1 = table_number_0(_S17 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Shown_0
{
     is_warp_2 : bool,
     hole_3 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_2 : Cell_0,
     weft_2 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_0 : Crossing_0,  back_3 : bool) -> Shown_0
{
    var _S18 : bool = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    var _S19 : bool = (abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1);
    var shown_0 : Shown_0;
    var _S20 : bool;
    if(_S18)
    {
        if(!_S19)
        {
            _S20 = true;
        }
        else
        {
            _S20 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S20 = false;
    }
    shown_0.is_warp_2 = _S20;
    if(!_S18)
    {
        _S20 = !_S19;
    }
    else
    {
        _S20 = false;
    }
    shown_0.hole_3 = _S20;
    var _S21 : u32;
    if(shown_0.is_warp_2)
    {
        _S21 = crossing_0.warp_word_0;
    }
    else
    {
        _S21 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S21;
    shown_0.on_top_0 = (((_S21 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    var _S22 : u32;
    if(is_first_0)
    {
        _S22 = first_0.thread_0;
    }
    else
    {
        _S22 = second_0.thread_0;
    }
    cell_2.thread_0 = _S22;
    var _S23 : f32;
    if(is_first_0)
    {
        _S23 = first_0.across_2;
    }
    else
    {
        _S23 = second_0.across_2;
    }
    cell_2.across_2 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.half_width_1;
    }
    else
    {
        _S23 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.below_0;
    }
    else
    {
        _S23 = second_0.below_0;
    }
    cell_2.below_0 = _S23;
    if(is_first_0)
    {
        _S23 = first_0.above_0;
    }
    else
    {
        _S23 = second_0.above_0;
    }
    cell_2.above_0 = _S23;
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S24 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S24.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S24.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_3 : u32,  first_1 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_1) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_4 : u32) -> Bend_0
{
    var _S25 : u32 = families_0[family_6].bend_table_0;
    var _S26 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S26 = u32(0);
    }
    else
    {
        _S26 = thread_4 * u32(4);
    }
    var _S27 : u32 = _S25 + _S26;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S27);
    bend_0.half_tangent_0 = table_number_0(_S27 + u32(1));
    bend_0.arc_0 = table_number_0(_S27 + u32(2));
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

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_5 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S28 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S29 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S30 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S31 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S32 : i32 = - _S28;
    var _S33 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S32, i32(0));
    run_0.from_start_0 = _S33;
    var _S34 : i32 = _S29 + i32(1);
    var _S35 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S34);
    run_0.to_end_0 = _S35;
    var _S36 : bool = _S33 < _S35;
    run_0.near_start_0 = _S36;
    var _S37 : i32;
    if(_S36)
    {
        _S37 = _S32 - _S30;
    }
    else
    {
        _S37 = _S34;
    }
    var _S38 : i32;
    if(run_0.near_start_0)
    {
        _S38 = _S32;
    }
    else
    {
        _S38 = _S34 + _S31;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    var _S39 : f32;
    if(run_0.straight_0)
    {
        _S39 = 1.0e+06f;
    }
    else
    {
        _S39 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S39;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S37, _S38), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S28 == i32(0);
    run_0.last_crossing_0 = _S29 == i32(0);
    return run_0;
}

fn square_0( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_3 : Cell_0) -> Section_0
{
    var _S40 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S41 : f32 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S41;
    var _S42 : f32 = _S40 * _S40 - square_0(_S41);
    var _S43 : f32 = rsqrt_0(_S42);
    section_0.drop_0 = _S40 - _S42 * _S43;
    section_0.slope_0 = - _S41 * _S43;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_6 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_6) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S44 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S45 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S46 : f32;
    if(_S44)
    {
        _S46 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S46 = crossed_1.above_0 + crossed_1.across_2;
    }
    var _S47 : f32 = _S46 - crossed_1.half_width_1;
    var _S48 : bool;
    if(_S44)
    {
        _S48 = run_1.first_crossing_0;
    }
    else
    {
        _S48 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S46 = 0.0f;
    }
    else
    {
        _S46 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S49 : f32;
    if((shown_1.on_top_0) != _S48)
    {
        _S49 = 0.0f;
    }
    else
    {
        var _S50 : f32 = families_0[other_1].height_scale_0;
        var _S51 : i32;
        if(_S44)
        {
            _S51 = i32(-1);
        }
        else
        {
            _S51 = i32(1);
        }
        _S49 = _S50 * edge_drop_0(other_1, crossed_1.thread_0, _S51);
    }
    var _S52 : f32 = 1.0f / max(2.0f * _S47, 9.999999960041972e-13f);
    var _S53 : f32 = clamp((_S47 - _S45) * _S52, 0.0f, 1.0f);
    var _S54 : f32 = _S46 + (_S49 - _S46) * (_S53 * _S53 * (3.0f - 2.0f * _S53));
    var _S55 : f32 = (_S46 - _S49) * (6.0f * _S53 * (1.0f - _S53) * _S52);
    if(_S44)
    {
        _S46 = 1.0f;
    }
    else
    {
        _S46 = -1.0f;
    }
    return vec2<f32>(_S54, _S55 * _S46);
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

fn step_control_0( direction_1 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S56 : f32 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S56), 9.99999971718068537e-10f);
    var _S57 : f32 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S57), 9.99999971718068537e-10f);
    control_0.right_0 = _S56 > 0.0f;
    control_0.up_0 = _S57 > 0.0f;
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

fn outline_distance_0( cell_4 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S58 : f32;
    if(forwards_0)
    {
        _S58 = cell_4.across_2;
    }
    else
    {
        _S58 = - cell_4.across_2;
    }
    var _S59 : f32;
    if(forwards_0)
    {
        _S59 = cell_4.above_0;
    }
    else
    {
        _S59 = cell_4.below_0;
    }
    var _S60 : bool;
    if(forwards_0)
    {
        _S60 = run_2.last_crossing_0;
    }
    else
    {
        _S60 = run_2.first_crossing_0;
    }
    var _S61 : bool;
    if(forwards_0)
    {
        _S61 = run_2.first_crossing_0;
    }
    else
    {
        _S61 = run_2.last_crossing_0;
    }
    var _S62 : f32 = - cell_4.half_width_1;
    var _S63 : bool = _S58 < _S62;
    var _S64 : bool = _S58 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S60 = !_S60;
    }
    else
    {
        _S60 = false;
    }
    if(_S60)
    {
        _S60 = !shown_2.hole_3;
    }
    else
    {
        _S60 = false;
    }
    var _S65 : bool;
    if(_S60)
    {
        _S65 = shown_2.on_top_0;
    }
    else
    {
        _S65 = false;
    }
    if(_S65)
    {
        if(_S61)
        {
            _S61 = _S63;
        }
        else
        {
            _S61 = false;
        }
        _S61 = !_S61;
    }
    else
    {
        _S61 = false;
    }
    if(shown_2.hole_3)
    {
        _S60 = true;
    }
    else
    {
        if(_S60)
        {
            _S60 = !shown_2.on_top_0;
        }
        else
        {
            _S60 = false;
        }
    }
    var _S66 : f32;
    if(_S63)
    {
        _S66 = _S62;
    }
    else
    {
        _S66 = cell_4.half_width_1;
    }
    var _S67 : f32 = _S66 - _S58;
    if(_S60)
    {
        _S58 = 2.0f * _S59 + _S58 - cell_4.half_width_1;
    }
    else
    {
        _S58 = _S59;
    }
    if(_S61)
    {
        if(forwards_0)
        {
            _S58 = run_2.to_end_0;
        }
        else
        {
            _S58 = run_2.from_start_0;
        }
        return _S58;
    }
    if(_S64)
    {
    }
    else
    {
        _S58 = _S67;
    }
    return _S58;
}

struct Probe_0
{
     height_3 : f32,
     hole_4 : bool,
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
    var _S68 : f32 = previous_1.rate_0 * step_4;
    var _S69 : f32 = rate_1 * step_4;
    var _S70 : bool;
    if(!previous_1.known_0)
    {
        _S70 = true;
    }
    else
    {
        _S70 = here_0.hole_4;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S70)
    {
        _S70 = true;
    }
    else
    {
        _S70 = rate_1 <= 0.0f;
    }
    if(_S70)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S68) >= 0.0f)
    {
        _S70 = (3.0f * clearance_1 - _S69) >= 0.0f;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        return -1.0f;
    }
    var _S71 : f32 = clearance_1 - previous_1.clearance_0;
    var _S72 : f32 = 6.0f * _S71 - 4.0f * _S68 - 2.0f * _S69;
    var _S73 : f32 = -2.0f * _S68 / max(_S72 + sqrt(max(_S72 * _S72 - 4.0f * (3.0f * (_S68 + _S69 - 2.0f * _S71)) * _S68, 0.0f)), 9.99999968265522539e-21f);
    var _S74 : f32 = 1.0f - _S73;
    var _S75 : f32 = (previous_1.clearance_0 * (2.0f * _S73 + 1.0f) + _S68 * _S73) * _S74 * _S74;
    var _S76 : f32 = (clearance_1 * (2.0f * _S74 + 1.0f) - _S69 * _S74) * _S73 * _S73;
    if(_S73 > 0.01999999955296516f)
    {
        _S70 = _S74 > 0.01999999955296516f;
    }
    else
    {
        _S70 = false;
    }
    if(_S70)
    {
        _S70 = (_S75 + _S76) < 0.0f;
    }
    else
    {
        _S70 = false;
    }
    var _S77 : f32;
    if(_S70)
    {
        _S77 = _S74 * step_4;
    }
    else
    {
        _S77 = -1.0f;
    }
    return _S77;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S78 : f32;
    if(here_1.hole_4)
    {
        _S78 = 1.0e+09f;
    }
    else
    {
        _S78 = clearance_2;
    }
    previous_2.clearance_0 = _S78;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S79 : bool;
    if(!here_1.hole_4)
    {
        _S79 = !is_cell_exit_0;
    }
    else
    {
        _S79 = false;
    }
    previous_2.known_0 = _S79;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S80 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S81 : bool;
    if(!here_2.hole_4)
    {
        _S81 = (rate_3 * _S80 + clearance_3) < 0.0f;
    }
    else
    {
        _S81 = false;
    }
    if(_S81)
    {
        _S81 = _S80 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S81 = false;
    }
    var _S82 : f32;
    if(_S81)
    {
        _S82 = _S80 - this_2.epsilon_0;
    }
    else
    {
        _S82 = max(_S80, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S82);
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

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S83 : f32 = end_0 - start_1;
    var _S84 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S83;
    var _S85 : f32 = 3.0f * _S83 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S83, 9.99999968265522539e-21f);
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
        var _S86 : f32 = clamp(share_0 - (((_S84 * share_0 + _S85) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S84 * share_0 + 2.0f * _S85) * share_0 + start_rate_0, 0.10000000149011612f * _S83 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S87 : i32 = i_0 + i32(1);
        share_0 = _S86;
        i_0 = _S87;
    }
    return share_0;
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

fn arc_sine_0( x_4 : f32) -> f32
{
    var _S91 : f32 = abs(x_4);
    var _S92 : bool = _S91 > 0.5f;
    var _S93 : f32;
    if(_S92)
    {
        _S93 = 0.5f * (1.0f - _S91);
    }
    else
    {
        _S93 = _S91 * _S91;
    }
    var _S94 : f32;
    if(_S92)
    {
        _S94 = sqrt(max(_S93, 0.0f));
    }
    else
    {
        _S94 = _S91;
    }
    var _S95 : f32 = ((((0.04216320067644119f * _S93 + 0.02418131195008755f) * _S93 + 0.04547002539038658f) * _S93 + 0.07495300471782684f) * _S93 + 0.16666752099990845f) * _S93 * _S94 + _S94;
    if(_S92)
    {
        _S93 = 1.57079637050628662f - 2.0f * _S95;
    }
    else
    {
        _S93 = _S95;
    }
    if(x_4 < 0.0f)
    {
        _S93 = - _S93;
    }
    return _S93;
}

struct Hair_0
{
     cover_0 : f32,
     normal_2 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_3 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S96 : Hair_0;
    _S96.cover_0 = cover_1;
    _S96.normal_2 = normal_3;
    _S96.tangent_2 = tangent_3;
    return _S96;
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S97 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S98 : u32 = ((((_S97 >> ((((_S97 >> (u32(28)))) + u32(4))))) ^ (_S97))) * u32(277803737);
    return (((_S98 >> (u32(22)))) ^ (_S98));
}

fn hash_key_0( thread_7 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_7 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_5 : u32) -> u32
{
    return scramble_0(cell_5 + key_0);
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_5 : f32) -> vec2<f32>
{
    var _S99 : f32 = floor(x_5 * 0.63661974668502808f + 0.5f);
    var _S100 : f32 = x_5 - _S99 * 1.5703125f - _S99 * 0.00048375129699707f - _S99 * 7.54979012640433211e-08f;
    var _S101 : f32 = _S100 * _S100;
    var _S102 : f32 = ((-0.00019515295571182f * _S101 + 0.00833216123282909f) * _S101 - 0.16666655242443085f) * _S101 * _S100 + _S100;
    var _S103 : f32 = ((0.00002443315679557f * _S101 - 0.00138873164542019f) * _S101 + 0.04166664555668831f) * _S101 * _S101 - 0.5f * _S101 + 1.0f;
    var _S104 : u32 = (u32(i32(_S99)) & (u32(3)));
    var _S105 : vec2<f32>;
    if(((_S104 & (u32(1)))) != u32(0))
    {
        _S105 = vec2<f32>(_S103, _S102);
    }
    else
    {
        _S105 = vec2<f32>(_S102, _S103);
    }
    var _S106 : f32;
    if(((_S104 & (u32(2)))) != u32(0))
    {
        _S106 = - _S105.x;
    }
    else
    {
        _S106 = _S105.x;
    }
    var _S107 : f32;
    if((((_S104 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S107 = - _S105.y;
    }
    else
    {
        _S107 = _S105.y;
    }
    return vec2<f32>(_S106, _S107);
}

fn table_colour_0( index_2 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_2), table_number_0(index_2 + u32(1)), table_number_0(index_2 + u32(2)));
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

fn fibre_cell_0( across_4 : f32,  along_0 : f32,  width_1 : f32) -> vec3<f32>
{
    var _S108 : f32 = floor(across_4 / width_1);
    return vec3<f32>(_S108, along_0 / (width_1 * 40.0f) + 0.61799997091293335f * _S108, 2.0f * (across_4 / width_1 - _S108) - 1.0f);
}

fn ply_offset_0( family_9 : u32,  point_0 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S109 : f32;
    if(back_4)
    {
        _S109 = - families_0[family_9].ply_sine_0;
    }
    else
    {
        _S109 = families_0[family_9].ply_sine_0;
    }
    var _S110 : f32 = (point_0.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_0.fibre_along_0 * _S109) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S110 - floor(_S110)) - 1.0f;
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_1 : f32) -> f32
{
    return share_1 * share_1 * (3.0f - 2.0f * share_1);
}

fn wave_noise_0( key_1 : u32,  position_3 : f32) -> vec2<f32>
{
    var _S111 : f32 = floor(position_3);
    var _S112 : f32 = position_3 - _S111;
    var _S113 : u32 = u32(i32(_S111));
    var _S114 : f32 = signed_noise_0(hash_bits_0(key_1, _S113));
    var _S115 : f32 = signed_noise_0(hash_bits_0(key_1, _S113 + u32(1)));
    return vec2<f32>(mix(_S114, _S115, smooth_share_0(_S112)), 6.0f * _S112 * (1.0f - _S112) * (_S115 - _S114));
}

fn cell_noise_0( key_2 : u32,  cell_6 : vec3<f32>) -> vec2<f32>
{
    var _S116 : f32 = cell_6.y;
    var _S117 : f32 = floor(_S116);
    var _S118 : u32 = u32(i32(cell_6.x)) * u32(65536) + u32(i32(_S117));
    var _S119 : u32 = hash_bits_0(key_2, _S118);
    var _S120 : u32 = hash_bits_0(key_2, _S118 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S119), signed_noise_0((_S119 >> (u32(16))))), vec2<f32>(signed_noise_0(_S120), signed_noise_0((_S120 >> (u32(16))))), vec2<f32>(smooth_share_0(_S116 - _S117)));
}

fn uniform_hash_0( thread_9 : u32,  cell_7 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_9, stream_1), cell_7)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_2 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_2 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_0 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S121 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_0, max(min(min(_S121.x, _S121.y), _S121.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S122 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S122.x, _S122.y), _S122.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_8 : u32,  amount_1 : f32,  seed_3 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, (seed_3 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_4 : vec3<f32>,
     tangent_4 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S123 : vec3<f32>;
    if((dot(frame_0.tangent_4, hair_0.tangent_2)) < 0.0f)
    {
        _S123 = (vec3<f32>(0) - hair_0.tangent_2);
    }
    else
    {
        _S123 = hair_0.tangent_2;
    }
    var blended_0 : YarnFrame_0;
    var _S124 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S125 : vec3<f32> = normalize(mix(frame_0.normal_4, hair_0.normal_2, _S124));
    blended_0.normal_4 = _S125;
    var _S126 : vec3<f32> = mix(frame_0.tangent_4, _S123, _S124);
    var _S127 : vec3<f32> = _S126 - vec3<f32>(dot(_S126, _S125)) * _S125;
    blended_0.tangent_4 = _S127 * vec3<f32>(rsqrt_0(max(dot(_S127, _S127), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_4.z - 1.0f) + 1.0f));
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_5 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S128 : f32 = light_1.z;
    if(_S128 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S128, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

fn projected_area_1( direction_2 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S129 : f32 = dot(direction_2, tangent_5);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S129 * _S129 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_6 : f32) -> f32
{
    var _S130 : f32 = clamp(x_6, -87.0f, 88.0f);
    var _S131 : f32 = floor(_S130 * 1.4426950216293335f + 0.5f);
    var _S132 : f32 = _S130 - _S131 * 0.693359375f + _S131 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S132 + 0.00139819993637502f) * _S132 + 0.00833345204591751f) * _S132 + 0.04166579619050026f) * _S132 + 0.1666666567325592f) * _S132 + 0.5f;
    var _S133 : f32 = (bitcast<f32>(((u32(i32(_S131) + i32(127)) << (u32(23))))));
    var _S134 : f32;
    if(x_6 < -87.0f)
    {
        _S134 = 0.0f;
    }
    else
    {
        _S134 = (p_0 * _S132 * _S132 + _S132 + 1.0f) * _S133;
    }
    return _S134;
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn square_1( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S135 : f32 = roughness_2 * roughness_2;
    var _S136 : f32 = squared_along_0 * (1.0f - _S135) + _S135;
    return 0.31830987334251404f * _S135 * roughness_2 / (_S136 * _S136);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S137 : vec3<f32> = light_2 + view_1;
    var _S138 : f32 = dot(_S137, tangent_6);
    return flake_density_0(min(_S138 * _S138 / max(square_1(_S137), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S139 : f32 = - dot(light_3, normal_6);
    var _S140 : f32 = dot(view_2, normal_6);
    var _S141 : bool;
    if(_S139 <= 0.0f)
    {
        _S141 = true;
    }
    else
    {
        _S141 = _S140 <= 0.0f;
    }
    if(_S141)
    {
        return 0.0f;
    }
    var _S142 : f32 = 1.0f / max(_S140, 9.99999997475242708e-07f);
    var _S143 : f32 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S139, 9.99999997475242708e-07f);
    var _S144 : f32 = projected_area_1(view_2, tangent_7, roughness_4) * _S142;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S143, _S144)) * mean_attenuation_0(optical_depth_1 * abs(_S143 - _S144)) * _S142;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S145 : f32 = dot(light_4, normal_7);
    var _S146 : bool;
    if(_S145 <= 0.0f)
    {
        _S146 = true;
    }
    else
    {
        _S146 = (dot(view_3, normal_7)) <= 0.0f;
    }
    if(_S146)
    {
        return 0.0f;
    }
    var _S147 : f32 = max(_S145, 9.99999997475242708e-07f);
    var _S148 : f32 = max(dot(view_3, normal_7), 9.99999997475242708e-07f);
    var _S149 : f32 = projected_area_1(light_4, tangent_8, roughness_5) * _S148 + projected_area_1(view_3, tangent_8, roughness_5) * _S147;
    var _S150 : f32 = optical_depth_2 * _S149 / (_S147 * _S148);
    return 0.25f * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S150 * mean_attenuation_0(_S150)) * _S147 / _S149;
}

fn with_added_0( sums_1 : Components_0,  more_0 : Components_0,  weight_1 : f32) -> Components_0
{
    var result_0 : Components_0;
    result_0.diffuse_warp_0 = sums_1.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_1.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_1.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_1.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_1.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_1.hole_2 + weight_1 * more_0.hole_2;
    return result_0;
}

fn scaled_0( blocked_0 : Blocked_0,  share_2 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_2 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_2 * blocked_0.by_weft_0;
    result_1.far_0 = share_2 * blocked_0.far_0;
    return result_1;
}

fn wrapped_cell_0( position_4 : f32,  count_1 : f32) -> f32
{
    return min(floor((position_4 - floor(position_4)) * count_1), count_1 - 1.0f);
}

fn arc_tangent_quotient_0( x_7 : f32,  y_0 : f32) -> f32
{
    return ((((((0.0f * x_7 + 0.00809729471802711f) * x_7 + -0.0377517081797123f) * x_7 + 0.08475969731807709f) * x_7 + -0.13537675142288208f) * x_7 + 0.19895026087760925f) * x_7 + -0.33327975869178772f) * x_7 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_1 : f32,  x_8 : f32) -> f32
{
    var _S151 : f32 = abs(x_8);
    var _S152 : f32 = abs(y_1);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S151, _S152) / max(max(_S151, _S152), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S152 > _S151)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_8 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_1 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_0( direction_3 : vec3<f32>) -> NodeTaps_0
{
    var _S153 : f32 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    var _S154 : f32 = floor(_S153);
    var _S155 : f32 = _S153 - _S154;
    var _S156 : f32 = sqrt(clamp((1.0f - abs(direction_3.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S157 : f32 = 7.0f * _S156 * sqrt(_S156);
    var _S158 : f32 = min(floor(_S157), 6.0f);
    var _S159 : f32 = _S157 - _S158;
    var _S160 : u32 = u32(i32(_S154) + i32(32)) % u32(32);
    var _S161 : u32 = u32(_S158);
    var _S162 : u32 = _S160 * u32(8) + _S161;
    var _S163 : u32 = (_S160 + u32(1)) % u32(32) * u32(8) + _S161;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S162, _S162 + u32(1), _S163, _S163 + u32(1));
    var _S164 : f32 = 1.0f - _S155;
    var _S165 : f32 = 1.0f - _S159;
    var _S166 : vec4<u32> = vec4<u32>(vec4<f32>(_S164 * _S165, _S164 * _S159, _S155 * _S165, _S155 * _S159) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S166;
    taps_0.inverse_sum_0 = 1.0f / f32(_S166.x + _S166.y + _S166.z + _S166.w);
    return taps_0;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S167 : vec3<f32> = light_5 + view_4;
    return _S167 * vec3<f32>(rsqrt_0(max(square_1(_S167), 9.999999960041972e-13f)));
}

fn shadow_correlation_0( light_6 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S168 : vec2<f32> = light_6.xy;
    var _S169 : vec2<f32> = view_5.xy;
    var _S170 : f32 = dot(_S168, _S169) / max(sqrt(dot(_S168, _S168) * dot(_S169, _S169)), 9.99999997475242708e-07f);
    if((light_6.z) < 0.0f)
    {
        return vec3<f32>(vec2<f32>((-0.09000000357627869f + -0.07999999821186066f * _S170)), 0.0f);
    }
    return vec3<f32>(min(0.62000000476837158f + 0.62999999523162842f * _S170, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S171 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S172 : vec4<u32> = ((packs_1 & (_S171))) * taps_1.weights_0;
    var _S173 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S171))) * taps_1.weights_0;
    return bytes_of_sums_0(_S172.x + _S172.y + _S172.z + _S172.w, _S173.x + _S173.y + _S173.z + _S173.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_0 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S174 : vec4<u32> = vec4<u32>(table_0) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S174.x], words_0[_S174.y], words_0[_S174.z], words_0[_S174.w]));
}

struct Group_0
{
     normal_8 : vec3<f32>,
     weight_2 : f32,
     tangent_9 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_6 : f32,
};

fn group_at_0( row_1 : u32,  roughness_7 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_8 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_2 = table_number_0(row_1 + u32(3));
    var _S175 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_9 = _S175;
    var _S176 : f32 = table_number_0(row_1 + u32(7));
    var _S177 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S176, _S177, 1.0f - square_1(_S175) - _S176 - _S177);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn visibility_gain_0( correlations_0 : vec3<f32>,  from_light_0 : f32,  from_view_0 : f32) -> vec2<f32>
{
    return max(correlations_0.xy * vec2<f32>((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f)) + vec2<f32>(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), vec2<f32>(0.0f));
}

fn Group_variance_along_0( this_5 : Group_0,  direction_4 : vec3<f32>) -> f32
{
    var _S178 : f32 = direction_4.x;
    var _S179 : f32 = direction_4.y;
    var _S180 : f32 = direction_4.z;
    return max(dot(this_5.variance_0, direction_4 * direction_4) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S178 * _S179, _S178 * _S180, _S179 * _S180)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_5 : vec3<f32>) -> f32
{
    var _S181 : f32 = dot(direction_5, group_1.tangent_9);
    var _S182 : f32 = group_1.roughness_6;
    var _S183 : f32 = _S182 * _S182;
    return sqrt(max((_S183 - 1.0f) * (_S181 * _S181 + Group_variance_along_0(group_1, direction_5)) + 1.0f, _S183));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S184 : f32 = group_2.roughness_6;
    var _S185 : f32 = max(sqrt(max(1.0f - _S184 * _S184, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S186 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S187 : f32 = dot(half_0, group_2.tangent_9);
    var _S188 : f32 = _S185 * (_S187 - _S186);
    var _S189 : f32 = _S185 * (_S187 + _S186);
    var _S190 : f32 = _S188 * _S189;
    var _S191 : f32 = 2.0f * _S186 * _S185;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S190) / ((_S188 * _S188 + 1.0f) * (_S189 * _S189 + 1.0f)) + arc_tangent_0(_S191, 1.0f + _S190) / _S191);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_7 : vec3<f32>,  view_6 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S192 : bool = (light_7.z) < 0.0f;
    var _S193 : f32 = dot(light_7, group_3.normal_8);
    var _S194 : f32;
    if(_S192)
    {
        _S194 = - _S193;
    }
    else
    {
        _S194 = _S193;
    }
    var _S195 : f32 = max(dot(view_6, group_3.normal_8), 0.01999999955296516f);
    var _S196 : f32 = mean_area_0(group_3, light_7) / max(_S194, 0.01999999955296516f);
    var _S197 : f32 = mean_area_0(group_3, view_6) / _S195;
    if(_S192)
    {
        _S194 = abs(_S196 - _S197);
    }
    else
    {
        _S194 = _S196 + _S197;
    }
    var _S198 : f32 = optical_depth_3 * max(_S194, 0.00100000004749745f);
    if(_S192)
    {
        _S194 = exponential_0(- optical_depth_3 * min(_S196, _S197));
    }
    else
    {
        _S194 = 1.0f;
    }
    var _S199 : f32 = optical_depth_3 * _S194 * (1.0f - exponential_0(- _S198)) / _S198 / _S195;
    if(_S192)
    {
        _S194 = 1.0f;
    }
    else
    {
        _S194 = 1.0f - 0.34999999403953552f * (1.0f - square_1(group_3.normal_8));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S194 * _S199;
}

struct Bound_0
{
     thread_12 : u32,
     turns_2 : f32,
     cell_9 : f32,
     visible_0 : f32,
     width_2 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_10 : u32,  position_5 : f32) -> Bound_0
{
    var _S200 : Cell_0 = locate_0(family_10, position_5);
    var _S201 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S200.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_12 = _S200.thread_0;
    bound_0.turns_2 = round((position_5 - families_0[family_10].start_0 - _S201 - _S200.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_9 = _S200.below_0;
    var _S202 : f32 = 2.0f * _S200.half_width_1;
    bound_0.width_2 = _S202;
    bound_0.visible_0 = clamp((_S200.across_2 + _S200.half_width_1) / _S202, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S200.below_0, _S200.below_0 - _S200.across_2 - _S200.half_width_1) + max(_S200.across_2 - _S200.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S203 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S204 : f32 = 0.5f * max(size_2, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_11, _S203 - _S204);
    stretch_0.high_0 = bound_at_0(family_11, _S203 + _S204);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S205 : f32 = Stretch_turns_0(stretch_1);
    var _S206 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_0.thread_12;
    var _S207 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_0.thread_12;
    var _S208 : f32 = table_number_0(_S207) - table_number_0(_S206);
    var _S209 : f32 = table_number_0(_S207 + u32(1)) - table_number_0(_S206 + u32(1));
    return vec3<f32>(_S208 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_2 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_2 + _S205 * families_0[family_12].visible_total_0, _S209 - _S208 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S205 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S209 + stretch_1.high_0.cell_9 - stretch_1.low_0.cell_9 + _S205 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S210 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S211 : u32 = families_0[family_13].colour_threads_0 + _S210 * stretch_2.low_0.thread_12 + quantity_0;
    var _S212 : u32 = families_0[family_13].colour_threads_0 + _S210 * stretch_2.high_0.thread_12 + quantity_0;
    var _S213 : u32 = families_0[family_13].colour_threads_0 + _S210 * u32(families_0[family_13].count_0) + quantity_0;
    var _S214 : f32 = table_number_0(_S211);
    var _S215 : f32 = table_number_0(_S212);
    var _S216 : f32 = Stretch_turns_0(stretch_2);
    var _S217 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S212 + families_0[family_13].quantities_0) - table_number_0(_S211 + families_0[family_13].quantities_0) + _S215 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_2 - _S214 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_2 + _S216 * table_number_0(_S213 + families_0[family_13].quantities_0), table_number_0(_S212 + _S217) - table_number_0(_S211 + _S217) + _S215 * stretch_2.high_0.cell_9 - _S214 * stretch_2.low_0.cell_9 + _S216 * table_number_0(_S213 + _S217));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_0.thread_12) < (this_7.low_0.thread_12);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S218 : u32 = entries_0.z;
    var _S219 : u32 = entries_0.x;
    var _S220 : u32 = _S218 - _S219;
    var _S221 : u32;
    if(Stretch_wraps_0(this_8))
    {
        _S221 = whole_0;
    }
    else
    {
        _S221 = u32(0);
    }
    return vec4<u32>(_S220 + _S221, entries_0.w - _S218, entries_0.y - _S219, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_2 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S222 : u32 = row_2 + across_5.low_0.thread_12 * quantities_1;
    var _S223 : u32 = row_2 + across_5.high_0.thread_12 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S222], words_0[_S222 + quantities_1], words_0[_S223], words_0[_S223 + quantities_1]), words_0[row_2 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    var _S224 : f32 = - this_9.low_0.visible_0;
    var _S225 : f32 = Stretch_turns_0(this_9);
    var _S226 : f32;
    if(Stretch_wraps_0(this_9))
    {
        _S226 = 1.0f;
    }
    else
    {
        _S226 = 0.0f;
    }
    return vec4<f32>(1.0f, this_9.high_0.visible_0, _S224, _S225 - _S226);
}

fn integral_on_top_0( family_14 : u32,  across_6 : Stretch_0,  along_1 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S227 : u32 = u32(families_0[family_14].count_0);
    var _S228 : u32 = (_S227 + u32(1)) * families_0[family_14].quantities_0;
    var _S229 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S230 : vec4<u32> = row_differences_0(across_6, _S229 + along_1.low_0.thread_12 * _S228, _S227, families_0[family_14].quantities_0);
    var _S231 : vec4<u32> = row_differences_0(across_6, _S229 + (along_1.low_0.thread_12 + u32(1)) * _S228, _S227, families_0[family_14].quantities_0);
    var _S232 : vec4<u32> = row_differences_0(across_6, _S229 + along_1.high_0.thread_12 * _S228, _S227, families_0[family_14].quantities_0);
    var _S233 : vec4<u32> = row_differences_0(across_6, _S229 + (along_1.high_0.thread_12 + u32(1)) * _S228, _S227, families_0[family_14].quantities_0);
    var _S234 : vec4<u32> = row_differences_0(across_6, _S229 + crossing_count_0 * _S228, _S227, families_0[family_14].quantities_0);
    var _S235 : vec4<u32> = _S232 - _S230;
    var _S236 : vec4<u32>;
    if(Stretch_wraps_0(along_1))
    {
        _S236 = _S234;
    }
    else
    {
        _S236 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S237 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S235 + _S236)), _S237), dot(vec4<f32>(vec4<i32>(_S233 - _S232)), _S237), dot(vec4<f32>(vec4<i32>(_S231 - _S230)), _S237), dot(vec4<f32>(vec4<i32>(_S234)), _S237)), Stretch_weights_0(along_1)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S238 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S239 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S239 * _S238.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S239 * _S238.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S239 * _S238.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S239 * _S238.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_5 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S240 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_4 : f32 = 0.0f;
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
        var _S241 : vec2<f32> = integrals_along_0(family_15, own_1, quantity_2);
        var _S242 : f32 = integral_on_top_0(family_15, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S243 : f32 = _S241.x;
        var _S244 : f32 = _S243 * _S240.x;
        var _S245 : f32;
        if(back_5)
        {
            _S245 = _S244 - _S242;
        }
        else
        {
            _S245 = _S242;
        }
        var _S246 : bool = quantity_2 == u32(0);
        if(_S246)
        {
            is_exposed_0 = _S245 > (16.0f * families_0[family_15].area_unit_0 * min(_S244 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S244);
        }
        var _S247 : f32 = _S243 * _S240.y;
        var _S248 : f32;
        if(is_exposed_0)
        {
            _S248 = _S245;
        }
        else
        {
            _S248 = 0.0f;
        }
        var _S249 : f32 = _S247 + _S248 + 0.000244140625f * _S240.z * _S241.y;
        if(_S246)
        {
            weight_4 = 1.0f / max(_S249, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S249 * weight_4, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn lerp_albedos_0( first_2 : Albedos_0,  second_1 : Albedos_0,  weight_5 : f32) -> Albedos_0
{
    var albedos_3 : Albedos_0;
    var _S250 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S250);
    albedos_3.diffuse_transmit_0 = mix(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S250);
    albedos_3.specular_reflect_0 = mix(first_2.specular_reflect_0, second_1.specular_reflect_0, _S250);
    albedos_3.specular_transmit_0 = mix(first_2.specular_transmit_0, second_1.specular_transmit_0, _S250);
    return albedos_3;
}

fn tinted_0( albedos_4 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_2 : Albedos_0 = albedos_4;
    result_2.diffuse_reflect_0 = result_2.diffuse_reflect_0 * tint_0;
    result_2.diffuse_transmit_0 = result_2.diffuse_transmit_0 * tint_0;
    return result_2;
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
    var _S251 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S252 : vec3<f32> = sends_0.sky_warp_0 + _S251 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S252;
    var _S253 : vec3<f32> = sends_0.sky_weft_0 + _S251 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S253;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S252 + vec3<f32>(sends_0.blocks_weft_0) * _S253;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_7 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S254 : f32 = 1.0f - view_7.z;
    var _S255 : f32 = _S254 * _S254;
    (*terms_0)[i32(0)] = 1.0f;
    var _S256 : f32 = view_7.x;
    var _S257 : f32 = _S256 * _S256;
    var _S258 : f32 = view_7.y;
    var _S259 : f32 = _S258 * _S258;
    (*terms_0)[i32(1)] = sqrt(max(_S257 + _S259, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S255;
    (*terms_0)[i32(3)] = _S255 * _S255;
    (*terms_0)[i32(4)] = _S257 - _S259;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_8 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S260 : f32 = 1.0f - view_8.z;
    var _S261 : f32 = _S260 * _S260;
    (*terms_1)[i32(0)] = 1.0f;
    var _S262 : f32 = view_8.x;
    var _S263 : f32 = _S262 * _S262;
    var _S264 : f32 = view_8.y;
    var _S265 : f32 = _S264 * _S264;
    (*terms_1)[i32(1)] = sqrt(max(_S263 + _S265, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S261;
    (*terms_1)[i32(3)] = _S261 * _S261;
    (*terms_1)[i32(4)] = _S263 - _S265;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Scattered_0
{
     back_6 : vec3<f32>,
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

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S266 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S267 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_6 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S267 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S267 * interior_0.far_1 + yarn_2.back_6 * _S266;
    return bounced_0;
}

fn sum_of_0( first_3 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_3.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_3.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_8 : vec3<f32>,  view_9 : vec3<f32>) -> vec3<f32>
{
    var _S268 : f32 = light_8.z;
    var _S269 : vec3<f32>;
    if((_S268 * view_9.z) < 0.0f)
    {
        _S269 = bounced_1.transmitted_0;
    }
    else
    {
        _S269 = bounced_1.reflected_0;
    }
    return _S269 * vec3<f32>((abs(_S268) * 0.31830987334251404f));
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

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S270 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S271 : f32 = 2.0f * sqrt(_S270) - 1.0f;
    var _S272 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S271, _S272), 0.00999999977648258f, 1.0f), clamp((1.0f - _S270) * sheen_shear_0(_S271, _S272), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S271, _S272), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S273 : f32 = light_9.z;
    var _S274 : bool;
    if(_S273 <= 0.0f)
    {
        _S274 = true;
    }
    else
    {
        _S274 = (view_10.z) <= 0.0f;
    }
    if(_S274)
    {
        return 0.0f;
    }
    var _S275 : vec2<f32> = view_10.xy;
    var _S276 : f32 = dot(_S275, _S275);
    var _S277 : vec2<f32>;
    if(_S276 > 9.99999968265522539e-21f)
    {
        _S277 = _S275 * vec2<f32>(rsqrt_0(_S276));
    }
    else
    {
        _S277 = vec2<f32>(1.0f, 0.0f);
    }
    var _S278 : f32 = scale_0 * dot(light_9.xy, _S277) + shear_0 * _S273;
    var _S279 : f32 = scale_0 * (light_9.y * _S277.x - light_9.x * _S277.y);
    var _S280 : f32 = _S278 * _S278 + _S279 * _S279 + _S273 * _S273;
    return 0.31830987334251404f * scale_0 * scale_0 * _S273 / max(_S280 * _S280, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_10 : vec3<f32>,  view_11 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S281 : vec3<f32> = sheen_lobe_0(view_11.z, roughness_9);
    var _S282 : f32 = strength_0 * _S281.z;
    return vec2<f32>(_S282 * transformed_cosine_0(light_10, view_11, _S281.x, _S281.y), 1.0f - _S282);
}

struct FamilyAlbedos_0
{
     warp_5 : Albedos_0,
     weft_5 : Albedos_0,
};

struct Estimate_0
{
     components_0 : Components_0,
     close_0 : CloseUp_0,
     albedos_5 : FamilyAlbedos_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_1 : f32,
     points_0 : f32,
};

fn regime_of_0( _S283 : u32,  _S284 : Footprint_0,  _S285 : f32) -> Regime_0
{
    var _S286 : f32 = Footprint_spread_side_0(_S284);
    var _S287 : f32 = clamp((binary_logarithm_0(max(_S286, 9.99999971718068537e-10f)) - fabrics_0[_S283].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S288 : f32 = _S287 * _S287 * (3.0f - 2.0f * _S287);
    regime_0.prefiltered_0 = _S288;
    regime_0.threads_1 = _S286 * fabrics_0[_S283].lobes_0.threads_per_mm_0;
    var _S289 : f32 = mix(max(8.0f / _S285, 1.0f), 1.0f, _S288);
    var _S290 : f32;
    if(_S288 < 1.0f)
    {
        _S290 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S289);
    }
    else
    {
        _S290 = 0.0f;
    }
    regime_0.points_0 = _S290;
    return regime_0;
}

fn varies_at_0( _S291 : u32,  _S292 : f32) -> bool
{
    var _S293 : bool;
    if((fabrics_0[_S291].fibre_noise_0) > 0.0f)
    {
        _S293 = true;
    }
    else
    {
        _S293 = (fabrics_0[_S291].colour_noise_0) > 0.0f;
    }
    if(_S293)
    {
        _S293 = true;
    }
    else
    {
        if((fabrics_0[_S291].has_detail_0) != u32(0))
        {
            _S293 = _S292 >= 0.0f;
        }
        else
        {
            _S293 = false;
        }
    }
    return _S293;
}

struct Hit_0
{
     x_12 : f32,
     y_5 : f32,
     hole_5 : bool,
     height_5 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_6 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S294 : u32,  _S295 : f32,  _S296 : f32,  _S297 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S294].warp_0, _S295);
    crossing_3.weft_2 = locate_0(fabrics_0[_S294].weft_0, _S296);
    var _S298 : u32 = fabrics_0[_S294].run_words_0 + u32(2) * (crossing_3.weft_2.thread_0 * fabrics_0[_S294].ends_1 + crossing_3.warp_2.thread_0);
    var _S299 : u32 = words_0[_S298];
    crossing_3.warp_word_0 = _S299;
    crossing_3.weft_word_0 = words_0[_S298 + u32(1)];
    crossing_3.warp_above_0 = (((_S299 & (u32(1)))) == u32(1)) != _S297;
    return crossing_3;
}

fn sample_at_0( _S300 : u32,  _S301 : f32,  _S302 : f32,  _S303 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S304 : Crossing_0 = crossing_at_0(_S300, _S301, _S302, _S303);
    sample_0.crossing_2 = _S304;
    var _S305 : Shown_0 = shown_at_0(_S304, _S303);
    sample_0.shown_3 = _S305;
    var _S306 : u32;
    if(_S305.is_warp_2)
    {
        _S306 = fabrics_0[_S300].warp_0;
    }
    else
    {
        _S306 = fabrics_0[_S300].weft_0;
    }
    var _S307 : u32;
    if(_S305.is_warp_2)
    {
        _S307 = fabrics_0[_S300].weft_0;
    }
    else
    {
        _S307 = fabrics_0[_S300].warp_0;
    }
    var _S308 : Cell_0 = select_cell_0(_S305.is_warp_2, sample_0.crossing_2.warp_2, sample_0.crossing_2.weft_2);
    var _S309 : Cell_0 = select_cell_0(_S305.is_warp_2, sample_0.crossing_2.weft_2, sample_0.crossing_2.warp_2);
    var _S310 : Run_0 = unpack_0(_S306, _S307, _S308.thread_0, _S309, _S305.word_0);
    var _S311 : Section_0 = section_at_0(_S308);
    var _S312 : bool;
    if(_S305.on_top_0)
    {
        _S312 = (_S310.distance_0) < (_S311.drop_0 * _S310.bend_1.sine_0);
    }
    else
    {
        _S312 = false;
    }
    var _S313 : bool;
    if(_S305.on_top_0)
    {
        _S313 = !_S312;
    }
    else
    {
        _S313 = false;
    }
    var _S314 : f32;
    if(_S313)
    {
        _S314 = 1.0f;
    }
    else
    {
        _S314 = -1.0f;
    }
    var _S315 : f32;
    if(_S312)
    {
        _S315 = _S310.other_reach_0;
    }
    else
    {
        _S315 = _S310.reach_0;
    }
    var _S316 : f32;
    if(_S312)
    {
        _S316 = _S315 + _S310.distance_0;
    }
    else
    {
        _S316 = max(_S315 - _S310.distance_0, 0.0f);
    }
    var _S317 : f32 = _S315 / _S310.bend_1.sine_0 - _S314 * _S311.drop_0;
    var _S318 : f32 = _S316 * _S316;
    var _S319 : f32 = max(_S317 * _S317 - _S318, 9.99999968265522539e-21f);
    var _S320 : f32 = rsqrt_0(_S319);
    var _S321 : f32 = _S318 / (_S319 * _S320 + _S317);
    var _S322 : bool = _S316 > 0.0f;
    var _S323 : f32;
    if(_S305.on_top_0)
    {
        _S323 = 1.0f;
    }
    else
    {
        _S323 = -1.0f;
    }
    var _S324 : f32;
    if(_S310.near_start_0)
    {
        _S324 = 1.0f;
    }
    else
    {
        _S324 = -1.0f;
    }
    var _S325 : f32 = _S323 * _S324;
    if(_S322)
    {
        _S323 = _S317 * _S320;
    }
    else
    {
        _S323 = 1.0f;
    }
    sample_0.slope_across_0 = _S311.slope_0 * _S323;
    if(_S322)
    {
        _S316 = _S325 * _S316 * _S320;
    }
    else
    {
        _S316 = 0.0f;
    }
    sample_0.slope_along_0 = _S316;
    var _S326 : f32 = families_0[_S306].height_scale_0;
    var _S327 : vec2<f32> = dive_0(_S307, _S305, _S310, _S309);
    if(_S310.straight_0)
    {
        _S314 = 0.0f;
    }
    else
    {
        _S314 = _S326 * _S314;
    }
    sample_0.height_6 = _S314 * (_S315 * _S310.bend_1.half_tangent_0 - _S321) - _S326 * _S311.drop_0 - _S327.x;
    var _S328 : f32 = _S326 * sample_0.slope_across_0;
    var _S329 : f32 = _S326 * sample_0.slope_along_0 - _S327.y;
    if(_S305.is_warp_2)
    {
        _S314 = _S328;
    }
    else
    {
        _S314 = _S329;
    }
    sample_0.slope_x_1 = _S314;
    if(_S305.is_warp_2)
    {
        _S314 = _S329;
    }
    else
    {
        _S314 = _S328;
    }
    sample_0.slope_y_1 = _S314;
    sample_0.run_3 = _S310;
    sample_0.section_1 = _S311;
    return sample_0;
}

fn steps_per_length_0( _S330 : u32,  _S331 : SearchQuality_0,  _S332 : vec3<f32>) -> f32
{
    return max(max(abs(_S332.x) * fabrics_0[_S330].threads_per_x_0, abs(_S332.y) * fabrics_0[_S330].threads_per_y_0) * _S331.steps_per_thread_0, abs(_S332.z) * fabrics_0[_S330].per_relief_0 * _S331.steps_per_relief_0);
}

fn cell_maximum_0( _S333 : u32,  _S334 : Crossing_0) -> f32
{
    var _S335 : u32;
    if(_S334.warp_above_0)
    {
        _S335 = fabrics_0[_S333].warp_0;
    }
    else
    {
        _S335 = fabrics_0[_S333].weft_0;
    }
    var _S336 : u32;
    if(_S334.warp_above_0)
    {
        _S336 = _S334.warp_word_0;
    }
    else
    {
        _S336 = _S334.weft_word_0;
    }
    return f32((_S336 >> (u32(28)))) * families_0[_S335].height_scale_0 * families_0[_S335].level_0;
}

fn probe_0( _S337 : u32,  _S338 : f32,  _S339 : f32,  _S340 : bool,  _S341 : bool,  _S342 : bool) -> Probe_0
{
    var _S343 : Sample_0 = sample_at_0(_S337, _S338, _S339, _S340);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S343.height_6;
    probe_1.hole_4 = _S343.shown_3.hole_3;
    probe_1.slope_x_0 = _S343.slope_x_1;
    probe_1.slope_y_0 = _S343.slope_y_1;
    var _S344 : u32;
    if(_S343.shown_3.is_warp_2)
    {
        _S344 = _S343.crossing_2.warp_2.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S344 = _S343.crossing_2.weft_2.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S344;
    probe_1.cell_max_0 = cell_maximum_0(_S337, _S343.crossing_2);
    var _S345 : f32;
    if(_S341)
    {
        _S345 = _S343.crossing_2.warp_2.above_0;
    }
    else
    {
        _S345 = _S343.crossing_2.warp_2.below_0;
    }
    probe_1.side_x_0 = _S345;
    if(_S342)
    {
        _S345 = _S343.crossing_2.weft_2.above_0;
    }
    else
    {
        _S345 = _S343.crossing_2.weft_2.below_0;
    }
    probe_1.side_y_0 = _S345;
    probe_1.edge_x_0 = outline_distance_0(_S343.crossing_2.warp_2, _S343.shown_3, _S343.run_3, !_S343.shown_3.is_warp_2, _S341);
    probe_1.edge_y_0 = outline_distance_0(_S343.crossing_2.weft_2, _S343.shown_3, _S343.run_3, _S343.shown_3.is_warp_2, _S342);
    return probe_1;
}

fn is_free_0( _S346 : u32,  _S347 : SearchQuality_0,  _S348 : vec3<f32>,  _S349 : vec3<f32>,  _S350 : bool,  _S351 : f32) -> bool
{
    var _S352 : f32 = _S349.z;
    if(_S352 <= 0.0f)
    {
        return false;
    }
    var _S353 : f32 = 1.0f / max(_S347.shadow_share_0 * steps_per_length_0(_S346, _S347, _S349), 9.99999971718068537e-10f);
    var _S354 : StepControl_0 = step_control_0(_S349.xy, _S353);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S355 : bool;
        if(count_3 < u32(1024))
        {
            _S355 = (_S348.z + _S352 * distance_1) < _S351;
        }
        else
        {
            _S355 = false;
        }
        if(_S355)
        {
        }
        else
        {
            break;
        }
        var _S356 : vec3<f32> = _S348 + _S349 * vec3<f32>(distance_1);
        var _S357 : Probe_0 = probe_0(_S346, _S356.x, _S356.y, _S350, _S354.right_0, _S354.up_0);
        var _S358 : f32 = _S356.z;
        var _S359 : f32 = _S358 - _S357.height_3;
        var _S360 : f32 = _S352 - _S357.slope_x_0 * _S349.x - _S357.slope_y_0 * _S349.y;
        var _S361 : bool;
        if(!_S357.hole_4)
        {
            _S361 = _S359 < 0.0f;
        }
        else
        {
            _S361 = false;
        }
        if(_S361)
        {
            return false;
        }
        var _S362 : f32 = way_back_to_dip_0(previous_3, _S359, _S360, last_step_0, _S357);
        if(_S362 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S362;
            distance_1 = distance_1 - _S362;
            last_step_0 = last_step_1;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S363 : bool = _S358 > (_S357.cell_max_0);
        var _S364 : PreviousSample_0 = after_sample_0(_S359, _S360, _S357, _S363);
        var last_step_2 : f32;
        if(_S363)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S354, _S357.side_x_0, _S357.side_y_0), _S353);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S354, _S357, _S359, _S360);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S364;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S365 : u32,  _S366 : SearchQuality_0,  _S367 : f32,  _S368 : f32,  _S369 : vec3<f32>,  _S370 : bool) -> bool
{
    if(!sample_at_0(_S365, _S367, _S368, _S370).shown_3.hole_3)
    {
        return false;
    }
    var _S371 : vec3<f32> = vec3<f32>(_S367, _S368, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S372 : bool;
        if(side_0 < u32(2))
        {
            _S372 = passes_0;
        }
        else
        {
            _S372 = false;
        }
        if(_S372)
        {
        }
        else
        {
            break;
        }
        var _S373 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S373 = _S369;
        }
        else
        {
            _S373 = vec3<f32>(- _S369.x, - _S369.y, _S369.z);
        }
        var _S374 : bool = is_free_0(_S365, _S366, _S371, _S373, _S370 != (side_0 == u32(1)), fabrics_0[_S365].height_high_0);
        var _S375 : u32 = side_0 + u32(1);
        passes_0 = _S374;
        side_0 = _S375;
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

fn max_height_along_0( _S376 : u32,  _S377 : f32,  _S378 : f32,  _S379 : f32,  _S380 : vec3<f32>,  _S381 : bool) -> f32
{
    var _S382 : u32 = locate_0(fabrics_0[_S376].warp_0, _S377).thread_0 / u32(2);
    var _S383 : u32 = locate_0(fabrics_0[_S376].weft_0, _S378).thread_0 / u32(2);
    var _S384 : f32 = _S380.x;
    var _S385 : u32;
    if(_S384 > 0.0f)
    {
        _S385 = u32(1);
    }
    else
    {
        _S385 = u32(0);
    }
    var _S386 : f32 = _S380.y;
    var _S387 : u32;
    if(_S386 > 0.0f)
    {
        _S387 = u32(2);
    }
    else
    {
        _S387 = u32(0);
    }
    var _S388 : u32 = words_0[fabrics_0[_S376].max_heights_0 + u32(4) * (_S383 * fabrics_0[_S376].max_height_columns_0 + _S382) + (_S385 + _S387)];
    var number_0 : i32;
    if(_S381)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S389 : u32 = (_S388 >> (u32(number_0)));
    var _S390 : f32 = max(abs(_S384) * fabrics_0[_S376].threads_per_x_0, abs(_S386) * fabrics_0[_S376].threads_per_y_0) / _S380.z;
    var _S391 : f32 = fabrics_0[_S376].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S376].height_high_0;
    number_0 = i32(3);
    for(;;)
    {
        if(number_0 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S379) * _S390) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S389 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S391);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S392 : u32,  _S393 : f32,  _S394 : f32,  _S395 : bool,  _S396 : bool,  _S397 : bool) -> vec3<f32>
{
    var _S398 : Crossing_0 = crossing_at_0(_S392, _S393, _S394, _S395);
    var _S399 : f32 = cell_maximum_0(_S392, _S398);
    var _S400 : f32;
    if(_S396)
    {
        _S400 = _S398.warp_2.above_0;
    }
    else
    {
        _S400 = _S398.warp_2.below_0;
    }
    var _S401 : f32;
    if(_S397)
    {
        _S401 = _S398.weft_2.above_0;
    }
    else
    {
        _S401 = _S398.weft_2.below_0;
    }
    return vec3<f32>(_S399, _S400, _S401);
}

fn first_sample_height_0( _S402 : u32,  _S403 : ViewRay_0,  _S404 : StepControl_0,  _S405 : bool) -> f32
{
    var _S406 : f32 = max_height_along_0(_S402, _S403.origin_0.x, _S403.origin_0.y, 0.0f, vec3<f32>(_S403.slope_1, 1.0f), _S405);
    var count_4 : u32 = u32(0);
    var height_8 : f32 = _S406;
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S407 : vec2<f32> = ViewRay_at_0(_S403, height_8);
        var _S408 : vec3<f32> = cell_bounds_0(_S402, _S407.x, _S407.y, _S405, _S404.right_0, _S404.up_0);
        var _S409 : f32 = height_8 - _S408.x;
        var _S410 : f32 = StepControl_to_cell_exit_0(_S404, _S408.y, _S408.z);
        var height_9 : f32 = height_8 - clamp(_S409, 0.0f, _S410);
        if(_S409 <= _S410)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + u32(1);
        height_8 = height_9;
    }
    return height_8;
}

fn search_down_0( _S411 : u32,  _S412 : ViewRay_0,  _S413 : StepControl_0,  _S414 : bool) -> ViewRayEnd_0
{
    var _S415 : f32 = fabrics_0[_S411].height_low_0 - (fabrics_0[_S411].height_high_0 - fabrics_0[_S411].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_7 = first_sample_height_0(_S411, _S412, _S413, _S414);
    end_1.last_step_3 = _S413.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_5 : u32 = u32(0);
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S416 : vec2<f32> = ViewRay_at_0(_S412, end_1.height_7);
        var _S417 : Probe_0 = probe_0(_S411, _S416.x, _S416.y, _S414, _S413.right_0, _S413.up_0);
        var _S418 : f32 = end_1.height_7 - _S417.height_3;
        var _S419 : f32 = ViewRay_rate_0(_S412, _S417);
        end_1.depth_1 = - _S418;
        end_1.rate_4 = _S419;
        var _S420 : bool;
        if(end_1.previous_4.known_0)
        {
            _S420 = !_S417.hole_4;
        }
        else
        {
            _S420 = false;
        }
        var _S421 : bool;
        if(_S420)
        {
            _S421 = (end_1.previous_4.yarn_0) == (_S417.yarn_1);
        }
        else
        {
            _S421 = false;
        }
        end_1.smooth_0 = _S421;
        var _S422 : bool;
        if(!_S417.hole_4)
        {
            _S422 = _S418 <= 0.0f;
        }
        else
        {
            _S422 = false;
        }
        var _S423 : bool;
        if(_S422)
        {
            _S423 = true;
        }
        else
        {
            _S423 = (end_1.height_7) <= _S415;
        }
        if(_S423)
        {
            break;
        }
        var _S424 : f32 = way_back_to_dip_0(end_1.previous_4, _S418, _S419, end_1.last_step_3, _S417);
        if(_S424 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S424;
            end_1.last_step_3 = end_1.last_step_3 - _S424;
            count_5 = count_5 + u32(1);
            continue;
        }
        var _S425 : f32 = min(StepControl_to_cell_exit_0(_S413, _S417.side_x_0, _S417.side_y_0), end_1.height_7 - _S417.cell_max_0);
        var _S426 : f32 = StepControl_to_next_sample_0(_S413, _S417, _S418, _S419);
        end_1.previous_4 = after_sample_0(_S418, _S419, _S417, _S425 > _S426);
        var _S427 : f32 = max(_S425, _S426);
        end_1.last_step_3 = _S427;
        end_1.height_7 = end_1.height_7 - _S427;
        count_5 = count_5 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S428 : u32,  _S429 : ViewRay_0,  _S430 : StepControl_0,  _S431 : bool,  _S432 : ViewRayEnd_0,  _S433 : u32) -> f32
{
    var _S434 : f32 = fabrics_0[_S428].height_high_0 - fabrics_0[_S428].height_low_0;
    var above_2 : f32 = _S432.height_7 + _S432.last_step_3;
    var above_gap_1 : f32 = clamp(_S432.previous_4.clearance_0, 0.0f, _S434);
    var under_gap_1 : f32 = clamp(_S432.depth_1, 0.0f, _S434);
    var _S435 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S432.previous_4.rate_0 * _S432.last_step_3, _S432.rate_4 * _S432.last_step_3);
    var middle_0 : f32;
    if(_S432.smooth_0)
    {
        middle_0 = above_2 - _S435 * _S432.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S432.height_7, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S432.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S433)
        {
        }
        else
        {
            break;
        }
        var _S436 : vec2<f32> = ViewRay_at_0(_S429, middle_0);
        var _S437 : Probe_0 = probe_0(_S428, _S436.x, _S436.y, _S431, _S430.right_0, _S430.up_0);
        var _S438 : f32;
        if(_S437.hole_4)
        {
            _S438 = -1.0e+09f;
        }
        else
        {
            _S438 = _S437.height_3;
        }
        var _S439 : f32 = clamp(middle_0 - _S438, - _S434, _S434);
        var _S440 : f32;
        if(_S439 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S440 = 0.5f * above_gap_2;
            }
            else
            {
                _S440 = above_gap_2;
            }
            var _S441 : f32 = - _S439;
            under_1 = middle_0;
            above_gap_2 = _S440;
            under_gap_2 = _S441;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S440 = 0.5f * under_gap_2;
            }
            else
            {
                _S440 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S439;
            under_gap_2 = _S440;
            side_1 = -1.0f;
        }
        if(_S432.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S439 / min(ViewRay_rate_0(_S429, _S437), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S432.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S442 : u32,  _S443 : SearchQuality_0,  _S444 : f32,  _S445 : f32,  _S446 : vec3<f32>,  _S447 : bool) -> Hit_0
{
    var _S448 : f32 = max(_S446.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S444, _S445);
    var _S449 : vec2<f32> = _S446.xy / vec2<f32>(_S448);
    ray_0.slope_1 = _S449;
    var _S450 : StepControl_0 = step_control_0((vec2<f32>(0) - _S449), 1.0f / max(steps_per_length_0(_S442, _S443, _S446) / _S448, 9.99999971718068537e-10f));
    var _S451 : ViewRayEnd_0 = search_down_0(_S442, ray_0, _S450, _S447);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S452 : f32 = refined_height_0(_S442, ray_0, _S450, _S447, _S451, _S443.refinements_0);
    hit_0.height_5 = _S452;
    var _S453 : vec2<f32> = ViewRay_at_0(ray_0, _S452);
    hit_0.x_12 = _S453.x;
    hit_0.y_5 = _S453.y;
    return hit_0;
}

fn first_hit_0( _S454 : u32,  _S455 : SearchQuality_0,  _S456 : f32,  _S457 : f32,  _S458 : vec3<f32>,  _S459 : bool) -> Hit_0
{
    if(!passes_through_0(_S454, _S455, _S456, _S457, _S458, _S459))
    {
        return first_hit_of_yarn_0(_S454, _S455, _S456, _S457, _S458, _S459);
    }
    var hit_1 : Hit_0;
    hit_1.x_12 = _S456;
    hit_1.y_5 = _S457;
    hit_1.height_5 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S460 : u32,  _S461 : f32,  _S462 : f32,  _S463 : bool) -> SurfacePoint_0
{
    var _S464 : Sample_0 = sample_at_0(_S460, _S461, _S462, _S463);
    var _S465 : f32;
    if(_S464.shown_3.is_warp_2)
    {
        _S465 = _S464.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S465 = _S464.crossing_2.weft_2.half_width_1;
    }
    var _S466 : u32;
    if(_S464.shown_3.is_warp_2)
    {
        _S466 = fabrics_0[_S460].warp_0;
    }
    else
    {
        _S466 = fabrics_0[_S460].weft_0;
    }
    var _S467 : f32 = families_0[_S466].twist_sine_0;
    var _S468 : f32;
    if(_S463)
    {
        _S468 = -1.0f;
    }
    else
    {
        _S468 = 1.0f;
    }
    var _S469 : f32 = _S467 * _S468;
    var _S470 : f32 = families_0[_S466].twist_cosine_0;
    if(_S464.shown_3.is_warp_2)
    {
        _S468 = 1.0f;
    }
    else
    {
        _S468 = -1.0f;
    }
    var _S471 : vec2<f32> = fibre_direction_0(_S464.slope_across_0, _S468 * _S464.slope_along_0, _S469, _S470);
    var _S472 : f32;
    if(_S464.shown_3.is_warp_2)
    {
        _S472 = _S464.slope_x_1;
    }
    else
    {
        _S472 = _S464.slope_y_1;
    }
    var _S473 : f32;
    if(_S464.shown_3.is_warp_2)
    {
        _S473 = _S464.slope_y_1;
    }
    else
    {
        _S473 = _S464.slope_x_1;
    }
    var _S474 : f32 = _S471.x;
    var _S475 : f32 = _S471.y;
    var _S476 : f32 = _S472 * _S474 + _S468 * _S473 * _S475;
    var _S477 : f32 = _S465 * 1.0154266357421875f;
    var _S478 : f32 = _S477 * arc_sine_0(clamp(_S464.section_1.across_3 / _S477, -1.0f, 1.0f));
    if(_S464.shown_3.is_warp_2)
    {
        _S465 = _S462;
    }
    else
    {
        _S465 = - _S461;
    }
    var point_1 : SurfacePoint_0;
    point_1.hole_0 = _S464.shown_3.hole_3;
    point_1.is_warp_0 = _S464.shown_3.is_warp_2;
    point_1.warp_thread_0 = _S464.crossing_2.warp_2.thread_0;
    point_1.weft_thread_0 = _S464.crossing_2.weft_2.thread_0;
    point_1.height_1 = _S464.height_6;
    point_1.normal_0 = normalize(vec3<f32>(- _S464.slope_x_1, - _S464.slope_y_1, 1.0f));
    var _S479 : vec3<f32>;
    if(_S464.shown_3.is_warp_2)
    {
        _S479 = vec3<f32>(_S474, _S475, _S476);
    }
    else
    {
        _S479 = vec3<f32>(- _S475, _S474, _S476);
    }
    point_1.tangent_0 = normalize(_S479);
    point_1.across_0 = _S464.section_1.across_3;
    point_1.fibre_across_0 = _S478 * _S470 + _S465 * _S469;
    point_1.fibre_along_0 = _S465 * _S470 - _S478 * _S469;
    return point_1;
}

struct YarnPoint_0
{
     back_7 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_13 : f32,
     y_6 : f32,
     height_10 : f32,
     normal_9 : vec3<f32>,
     tangent_10 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
};

fn has_hairs_0( _S480 : u32) -> bool
{
    var _S481 : bool;
    if((families_0[fabrics_0[_S480].warp_0].hairiness_0) > 0.0f)
    {
        _S481 = true;
    }
    else
    {
        _S481 = (families_0[fabrics_0[_S480].weft_0].hairiness_0) > 0.0f;
    }
    return _S481;
}

fn hair_at_0( _S482 : u32,  _S483 : vec2<f32>,  _S484 : bool,  _S485 : f32) -> Hair_0
{
    var _S486 : f32 = fabrics_0[_S482].fibre_size_0;
    var _S487 : f32 = 17.0f * fabrics_0[_S482].fibre_size_0;
    var _S488 : f32 = fade_0(_S485, _S487);
    var _S489 : vec2<f32> = _S483 / vec2<f32>(_S487);
    var number_1 : u32;
    if(_S484)
    {
        number_1 = u32(1);
    }
    else
    {
        number_1 = u32(0);
    }
    var _S490 : u32 = hash_key_0(number_1, ((fabrics_0[_S482].seed_1) ^ (u32(1013904242))));
    var _S491 : f32 = 1.0f / max(_S485, 0.07999999821186066f * _S486);
    var _S492 : f32 = min(0.63999998569488525f * _S486 * _S491, 1.0f);
    const _S493 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S493;
    number_1 = u32(0);
    for(;;)
    {
        var _S494 : bool;
        if(_S488 > 0.0f)
        {
            _S494 = number_1 < u32(18);
        }
        else
        {
            _S494 = false;
        }
        if(_S494)
        {
        }
        else
        {
            break;
        }
        var _S495 : u32 = number_1 / u32(9);
        var _S496 : u32 = number_1 / u32(3) - u32(3) * _S495;
        var _S497 : vec2<f32> = floor(_S489) + vec2<f32>(f32(number_1 - u32(3) * _S496 - u32(9) * _S495), f32(_S496)) - vec2<f32>(1.0f);
        var _S498 : u32 = hash_bits_0(_S490 + _S495, u32(i32(_S497.x)) * u32(65536) + u32(i32(_S497.y)));
        var _S499 : u32 = hash_bits_0(_S490, _S498);
        var _S500 : vec2<f32> = _S489 - _S497 - vec2<f32>(share_of_0(_S498), share_of_0((_S498 >> (u32(10)))));
        var _S501 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S498 >> (u32(20)))));
        var _S502 : f32 = mix(5.0f, 16.0f, share_of_0((_S499 >> (u32(10))))) / 17.0f;
        var _S503 : f32 = _S500.x;
        var _S504 : f32 = _S501.y;
        var _S505 : f32 = _S500.y;
        var _S506 : f32 = _S501.x;
        var _S507 : f32 = (_S503 * _S504 + _S505 * _S506) / _S502;
        var _S508 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S499 >> (u32(20)))) - 1.0f);
        var _S509 : f32 = 2.0f * _S508 * _S507;
        var _S510 : f32 = rsqrt_0(_S509 * _S509 + 1.0f);
        var _S511 : f32 = (_S505 * _S504 - _S503 * _S506 - _S508 * _S502 * _S507 * _S507) * _S510 * 17.0f;
        var _S512 : f32 = clamp((0.31999999284744263f - abs(_S511)) * _S486 * _S491 + 0.5f, 0.0f, _S492);
        var _S513 : u32;
        if(((((_S499 >> (u32(30)))) & (u32(1)))) == u32(1))
        {
            _S513 = fabrics_0[_S482].warp_0;
        }
        else
        {
            _S513 = fabrics_0[_S482].weft_0;
        }
        var _S514 : bool;
        if((share_of_0(_S499)) < (families_0[_S513].hairiness_0))
        {
            _S514 = (abs(_S507)) < 1.0f;
        }
        else
        {
            _S514 = false;
        }
        var _S515 : bool;
        if(_S514)
        {
            _S515 = _S512 > cover_2;
        }
        else
        {
            _S515 = false;
        }
        if(_S515)
        {
            var _S516 : vec2<f32> = vec2<f32>(- _S506 - _S509 * _S504, _S504 - _S509 * _S506) * vec2<f32>(_S510);
            cover_2 = _S512;
            hair_away_0 = _S511;
            hair_across_0 = _S516;
        }
        number_1 = number_1 + u32(1);
    }
    var _S517 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S488 * cover_2;
    hair_1.normal_2 = vec3<f32>(vec2<f32>(_S517) * hair_across_0, sqrt(1.0f - _S517 * _S517));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn thread_number_0( _S518 : u32,  _S519 : SurfacePoint_0,  _S520 : f32,  _S521 : f32) -> u32
{
    var _S522 : f32;
    if(_S519.is_warp_0)
    {
        _S522 = _S520;
    }
    else
    {
        _S522 = _S521;
    }
    var _S523 : f32 = _S522 - _S519.across_0;
    var _S524 : u32;
    if(_S519.is_warp_0)
    {
        _S524 = fabrics_0[_S518].warp_0;
    }
    else
    {
        _S524 = fabrics_0[_S518].weft_0;
    }
    var _S525 : f32 = families_0[_S524].period_0;
    var _S526 : i32 = i32(families_0[_S524].count_0);
    if(_S519.is_warp_0)
    {
        _S524 = _S519.warp_thread_0;
    }
    else
    {
        _S524 = _S519.weft_thread_0;
    }
    var _S527 : u32 = u32(i32(floor(_S523 / _S525)) * _S526 + i32(_S524)) * u32(2);
    if(_S519.is_warp_0)
    {
        _S524 = u32(1);
    }
    else
    {
        _S524 = u32(0);
    }
    return _S527 + _S524;
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_2 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S528 : u32,  _S529 : u32,  _S530 : SurfacePoint_0,  _S531 : u32,  _S532 : f32) -> FibreNoise_0
{
    var _S533 : f32 = 5.0f * fabrics_0[_S528].fibre_size_0;
    var _S534 : vec2<f32> = wave_noise_0(hash_key_0(_S531, ((fabrics_0[_S528].seed_1) ^ (u32(458671337)))), _S530.fibre_along_0 / (25.0f * fabrics_0[_S528].fibre_size_0));
    var _S535 : f32 = _S530.fibre_across_0 + families_0[_S529].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S528].fibre_size_0 * _S534.x;
    var _S536 : vec3<f32> = fibre_cell_0(_S535, _S530.fibre_along_0, fabrics_0[_S528].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S531, ((fabrics_0[_S528].seed_1) ^ (u32(1757159915)))), fibre_cell_0(_S535, _S530.fibre_along_0, _S533));
    noise_0.bundle_weight_0 = fade_0(_S532, _S533);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S531, ((fabrics_0[_S528].seed_1) ^ (u32(48610963)))), _S536);
    noise_0.fibre_weight_0 = fade_0(_S532, fabrics_0[_S528].fibre_size_0);
    noise_0.offset_2 = _S536.z;
    noise_0.slope_2 = 0.5f * _S534.y;
    return noise_0;
}

fn detail_gain_0( _S537 : u32,  _S538 : u32,  _S539 : SurfacePoint_0,  _S540 : vec2<f32>,  _S541 : bool,  _S542 : u32,  _S543 : f32) -> vec2<f32>
{
    var _S544 : vec2<f32> = vec2<f32>(0.0f);
    var gain_1 : vec2<f32>;
    if((families_0[_S538].has_plies_0) > 0.0f)
    {
        gain_1 = vec2<f32>((0.60000002384185791f * fade_0(_S543, 1.0f / families_0[_S538].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_0(square_0(ply_offset_0(_S538, _S539, _S541))), 0.20000000298023224f);
    }
    else
    {
        gain_1 = _S544;
    }
    if((families_0[_S538].fibre_tone_0) > 0.0f)
    {
        var _S545 : FibreNoise_0 = fibre_noise_at_0(_S537, _S538, _S539, _S542, _S543);
        gain_1 = gain_1 + vec2<f32>(families_0[_S538].fibre_tone_0) * vec2<f32>(_S545.bundle_weight_0 * _S545.bundle_0.y + _S545.fibre_weight_0 * _S545.fibre_0.y, _S545.bundle_weight_0 + _S545.fibre_weight_0);
    }
    if((families_0[_S538].slub_0) > 0.0f)
    {
        var _S546 : f32 = 0.25f * families_0[_S538].slub_0 * fade_0(_S543, 1.0f / families_0[_S538].slubs_per_mm_0);
        var _S547 : f32;
        if(_S539.is_warp_0)
        {
            _S547 = _S540.y;
        }
        else
        {
            _S547 = - _S540.x;
        }
        gain_1 = gain_1 + vec2<f32>(_S546) * vec2<f32>(wave_noise_0(hash_key_0(_S542, ((fabrics_0[_S537].seed_1) ^ (u32(1373058189)))), _S547 * families_0[_S538].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_0(_S539.across_0 * families_0[_S538].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_1;
}

fn vary_albedos_0( _S548 : u32,  _S549 : Albedos_0,  _S550 : u32,  _S551 : u32,  _S552 : vec2<f32>) -> Albedos_0
{
    var _S553 : vec3<f32> = max(_S549.specular_reflect_0, _S549.specular_transmit_0);
    var _S554 : vec3<f32> = _S549.diffuse_reflect_0 + _S549.diffuse_transmit_0;
    var _S555 : vec3<f32> = vec3<f32>(fabrics_0[_S548].layer_bound_0);
    var _S556 : vec3<f32> = vec3<f32>(1.0f);
    var _S557 : vec3<f32> = _S556 - _S555 * _S553;
    var colour_0 : f32 = bounded_gain_0(thread_gain_0(_S550, fabrics_0[_S548].colour_noise_0, fabrics_0[_S548].seed_1), _S554, _S557);
    var _S558 : vec3<f32> = vec3<f32>((colour_0 * (1.0f + flattened_0(_S552.y, vec3<f32>(colour_0) * _S554, _S557) * _S552.x)));
    var _S559 : f32 = bounded_gain_0(fibre_gain_0(_S550, _S551, fabrics_0[_S548].fibre_noise_0, fabrics_0[_S548].seed_1), _S553, min((_S556 - _S558 * _S554) / _S555, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S558 * _S549.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S558 * _S549.diffuse_transmit_0;
    var _S560 : vec3<f32> = vec3<f32>(_S559);
    varied_0.specular_reflect_0 = _S560 * _S549.specular_reflect_0;
    varied_0.specular_transmit_0 = _S560 * _S549.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S561 : u32,  _S562 : SurfacePoint_0,  _S563 : Albedos_0,  _S564 : f32,  _S565 : f32,  _S566 : bool,  _S567 : f32,  _S568 : f32) -> Albedos_0
{
    var _S569 : u32 = thread_number_0(_S561, _S562, _S564, _S565);
    var _S570 : vec3<f32> = fibre_cell_0(_S562.fibre_across_0, _S562.fibre_along_0, fabrics_0[_S561].fibre_size_0);
    var _S571 : vec2<f32> = vec2<f32>(0.0f);
    var _S572 : bool;
    if((fabrics_0[_S561].has_detail_0) != u32(0))
    {
        _S572 = _S567 >= 0.0f;
    }
    else
    {
        _S572 = false;
    }
    var gain_2 : vec2<f32>;
    if(_S572)
    {
        var _S573 : u32;
        if(_S562.is_warp_0)
        {
            _S573 = fabrics_0[_S561].warp_0;
        }
        else
        {
            _S573 = fabrics_0[_S561].weft_0;
        }
        gain_2 = detail_gain_0(_S561, _S573, _S562, vec2<f32>(_S564, _S565), _S566, _S569, _S567) * vec2<f32>(1.0f - _S568, 1.0f);
    }
    else
    {
        gain_2 = _S571;
    }
    return vary_albedos_0(_S561, _S563, _S569, u32(i32(_S570.x)) * u32(65536) + u32(i32(floor(_S570.y))), gain_2);
}

fn turned_frame_0( _S574 : u32,  _S575 : u32,  _S576 : SurfacePoint_0,  _S577 : bool,  _S578 : u32,  _S579 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_4 = _S576.normal_0;
    frame_2.tangent_4 = _S576.tangent_0;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S575].has_plies_0) > 0.0f)
    {
        var _S580 : f32 = fade_0(_S579, 1.0f / families_0[_S575].plies_per_mm_0);
        var _S581 : f32 = _S580 * 0.41999998688697815f * ply_offset_0(_S575, _S576, _S577);
        var _S582 : f32 = sqrt(1.0f - _S581 * _S581);
        var _S583 : f32;
        if(_S577)
        {
            _S583 = - families_0[_S575].ply_sine_0;
        }
        else
        {
            _S583 = families_0[_S575].ply_sine_0;
        }
        var _S584 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_4);
        var _S585 : vec3<f32> = vec3<f32>(families_0[_S575].ply_cosine_0);
        var _S586 : vec3<f32> = _S585 * _S584 + vec3<f32>(_S583) * frame_2.tangent_4;
        var _S587 : vec3<f32> = vec3<f32>(_S582);
        var _S588 : vec3<f32> = vec3<f32>(_S581);
        frame_2.tangent_4 = _S585 * (_S585 * frame_2.tangent_4 - vec3<f32>(_S583) * _S584) + vec3<f32>(_S583) * (_S587 * _S586 - _S588 * frame_2.normal_4);
        frame_2.normal_4 = _S587 * frame_2.normal_4 + _S588 * _S586;
        frame_2.loss_0 = _S580 * _S580 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S589 : f32 = families_0[_S575].fibre_tilt_0;
    if((families_0[_S575].fibre_tilt_0) > 0.0f)
    {
        var _S590 : FibreNoise_0 = fibre_noise_at_0(_S574, _S575, _S576, _S578, _S579);
        var _S591 : f32 = 1.09858846664428711f * _S589 * (_S590.bundle_weight_0 * _S590.bundle_0.x + _S590.fibre_weight_0 * (_S590.fibre_0.x + _S590.offset_2));
        var _S592 : f32 = _S589 * (1.42099642753601074f * (_S590.bundle_weight_0 * _S590.bundle_0.y + _S590.fibre_weight_0 * _S590.fibre_0.y) - _S590.bundle_weight_0 * _S590.slope_2);
        var _S593 : f32 = square_0(_S590.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S589 * _S589 * ((0.24761904776096344f * (square_0(_S590.bundle_weight_0) + _S593) + _S593 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S594 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_4);
        var _S595 : vec2<f32> = sine_cosine_0(_S591);
        var _S596 : vec2<f32> = sine_cosine_0(_S592);
        var _S597 : vec3<f32> = vec3<f32>(_S595.y);
        var _S598 : vec3<f32> = vec3<f32>(_S595.x);
        var _S599 : vec3<f32> = _S597 * _S594 - _S598 * frame_2.normal_4;
        frame_2.normal_4 = _S597 * frame_2.normal_4 + _S598 * _S594;
        frame_2.tangent_4 = vec3<f32>(_S596.y) * frame_2.tangent_4 + vec3<f32>(_S596.x) * _S599;
    }
    return frame_2;
}

fn yarn_point_of_0( _S600 : u32,  _S601 : SurfacePoint_0,  _S602 : f32,  _S603 : f32,  _S604 : bool,  _S605 : bool,  _S606 : f32) -> YarnPoint_0
{
    var _S607 : u32;
    if(_S601.is_warp_0)
    {
        _S607 = fabrics_0[_S600].warp_0;
    }
    else
    {
        _S607 = fabrics_0[_S600].weft_0;
    }
    var _S608 : bool;
    if((fabrics_0[_S600].has_detail_0) != u32(0))
    {
        _S608 = _S606 >= 0.0f;
    }
    else
    {
        _S608 = false;
    }
    var _S609 : vec3<f32> = vec3<f32>(0.0f);
    var _S610 : Hair_0 = Hair_x24init_0(0.0f, _S609, _S609);
    var _S611 : bool;
    if(_S608)
    {
        _S611 = has_hairs_0(_S600);
    }
    else
    {
        _S611 = false;
    }
    var hair_2 : Hair_0;
    if(_S611)
    {
        hair_2 = hair_at_0(_S600, vec2<f32>(_S602, _S603), _S604, _S606);
    }
    else
    {
        hair_2 = _S610;
    }
    var _S612 : u32;
    if(_S601.is_warp_0)
    {
        _S612 = _S601.warp_thread_0;
    }
    else
    {
        _S612 = _S601.weft_thread_0;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S607, _S612);
    var albedos_8 : Albedos_0;
    if(varies_at_0(_S600, _S606))
    {
        albedos_8 = varied_at_0(_S600, _S601, albedos_7, _S602, _S603, _S604, _S606, hair_2.cover_0);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_2 : YarnPoint_0;
    point_2.back_7 = _S604;
    point_2.hole_6 = _S605;
    point_2.is_warp_3 = _S601.is_warp_0;
    point_2.x_13 = _S602;
    point_2.y_6 = _S603;
    point_2.height_10 = _S601.height_1;
    point_2.normal_9 = _S601.normal_0;
    point_2.tangent_10 = _S601.tangent_0;
    point_2.surface_normal_0 = _S601.normal_0;
    point_2.diffuse_gain_1 = 1.0f;
    if(_S608)
    {
        var _S613 : YarnFrame_0 = turned_frame_0(_S600, _S607, _S601, _S604, thread_number_0(_S600, _S601, _S602, _S603), _S606);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S600))
        {
            frame_3 = under_hair_0(_S613, hair_2);
        }
        else
        {
            frame_3 = _S613;
        }
        point_2.normal_9 = frame_3.normal_4;
        point_2.tangent_10 = frame_3.tangent_4;
        point_2.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S600].diffuse_blend_0);
    }
    point_2.roughness_10 = families_0[_S607].roughness_0;
    point_2.albedos_6 = albedos_8;
    return point_2;
}

fn unoccluded_0( _S614 : u32,  _S615 : SearchQuality_0,  _S616 : f32,  _S617 : f32,  _S618 : f32,  _S619 : vec3<f32>,  _S620 : bool) -> bool
{
    if((_S619.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S614, _S615, vec3<f32>(_S616, _S617, _S618 + fabrics_0[_S614].lift_0), _S619, _S620, max_height_along_0(_S614, _S616, _S617, _S618, _S619, _S620));
}

fn is_lit_0( _S621 : u32,  _S622 : SearchQuality_0,  _S623 : YarnPoint_0,  _S624 : vec3<f32>) -> bool
{
    if(_S623.hole_6)
    {
        return true;
    }
    var _S625 : vec3<f32> = to_face_frame_0(_S624, _S623.back_7);
    var _S626 : f32 = _S625.z;
    var _S627 : bool = _S626 < 0.0f;
    var normal_10 : vec3<f32>;
    var height_11 : f32;
    if(_S627)
    {
        var _S628 : SurfacePoint_0 = surface_at_0(_S621, _S623.x_13, _S623.y_6, !_S623.back_7);
        normal_10 = _S628.normal_0;
        height_11 = _S628.height_1;
    }
    else
    {
        normal_10 = _S623.surface_normal_0;
        height_11 = _S623.height_10;
    }
    var _S629 : vec3<f32> = vec3<f32>(_S625.xy, abs(_S626));
    if((dot(normal_10, _S629)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S621, _S622, _S623.x_13, _S623.y_6, height_11, _S629, (_S623.back_7) != _S627);
}

fn components_of_point_0( _S630 : u32,  _S631 : SearchQuality_0,  _S632 : YarnPoint_0,  _S633 : vec3<f32>,  _S634 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    var _S635 : f32;
    if(_S632.hole_6)
    {
        _S635 = 1.0f;
    }
    else
    {
        _S635 = 0.0f;
    }
    result_3.hole_2 = _S635;
    var _S636 : bool;
    if(_S632.hole_6)
    {
        _S636 = true;
    }
    else
    {
        _S636 = !is_lit_0(_S630, _S631, _S632, _S633);
    }
    if(_S636)
    {
        return result_3;
    }
    var _S637 : vec3<f32> = to_face_frame_0(_S633, _S632.back_7);
    var _S638 : vec3<f32> = to_face_frame_0(_S634, _S632.back_7);
    var _S639 : bool = (_S637.z) < 0.0f;
    var _S640 : vec3<f32>;
    if(_S639)
    {
        _S640 = (vec3<f32>(0) - _S637);
    }
    else
    {
        _S640 = _S637;
    }
    var _S641 : f32 = _S632.diffuse_gain_1 * diffuse_reflection_0(_S640, _S632.normal_9, fabrics_0[_S630].diffuse_blend_0);
    if(_S639)
    {
        _S635 = transmission_1(_S637, _S638, _S632.normal_9, _S632.tangent_10, _S632.roughness_10, fabrics_0[_S630].optical_depth_0);
    }
    else
    {
        _S635 = reflection_0(_S637, _S638, _S632.normal_9, _S632.tangent_10, _S632.roughness_10, fabrics_0[_S630].optical_depth_0);
    }
    var _S642 : f32;
    if(_S632.is_warp_3)
    {
        _S642 = _S641;
    }
    else
    {
        _S642 = 0.0f;
    }
    result_3.diffuse_warp_0 = _S642;
    if(_S632.is_warp_3)
    {
        _S642 = 0.0f;
    }
    else
    {
        _S642 = _S641;
    }
    result_3.diffuse_weft_0 = _S642;
    if(_S632.is_warp_3)
    {
        _S642 = _S635;
    }
    else
    {
        _S642 = 0.0f;
    }
    result_3.specular_warp_0 = _S642;
    if(_S632.is_warp_3)
    {
        _S635 = 0.0f;
    }
    result_3.specular_weft_0 = _S635;
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S643 : u32,  _S644 : u32) -> f32
{
    return table_number_0(fabrics_0[_S643].openness_0 + _S644);
}

fn blocked_of_terms_0( _S645 : u32,  _S646 : u32,  _S647 : array<f32, i32(6)>,  _S648 : u32) -> Blocked_0
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
            if(term_0 < _S648)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S645, _S646 + share_3 * _S648 + term_0) * _S647[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_3] = saturate(shares_0[share_3]);
        share_3 = share_3 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_at_0( _S649 : u32,  _S650 : bool,  _S651 : bool,  _S652 : f32,  _S653 : f32) -> Blocked_0
{
    var _S654 : f32 = _S653 * openness_number_0(_S649, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S652, _S654, _S652 * _S652, _S652 * _S654, _S654 * _S654 );
    var _S655 : u32;
    if(_S651)
    {
        _S655 = u32(2);
    }
    else
    {
        _S655 = u32(0);
    }
    var _S656 : u32;
    if(_S650)
    {
        _S656 = u32(0);
    }
    else
    {
        _S656 = u32(1);
    }
    return blocked_of_terms_0(_S649, u32(60) + (_S655 + _S656) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S657 : u32,  _S658 : Blocked_0,  _S659 : YarnPoint_0,  _S660 : bool,  _S661 : f32) -> Blocked_0
{
    var _S662 : bool;
    if(_S659.hole_6)
    {
        _S662 = true;
    }
    else
    {
        _S662 = (_S659.is_warp_3) != _S660;
    }
    if(_S662)
    {
        return _S658;
    }
    var _S663 : Blocked_0 = blocked_at_0(_S657, _S660, _S659.back_7, _S659.normal_9.z, _S659.height_10);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S658.by_warp_0 + _S661 * _S663.by_warp_0;
    result_4.by_weft_0 = _S658.by_weft_0 + _S661 * _S663.by_weft_0;
    result_4.far_0 = _S658.far_0 + _S661 * _S663.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S664 : u32,  _S665 : f32) -> vec3<f32>
{
    var _S666 : u32 = fabrics_0[_S664].lobes_0.levels_0 + u32(4) * u32(min(_S665, fabrics_0[_S664].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S666), table_number_0(_S666 + u32(1)), table_number_0(_S666 + u32(2)));
}

fn coverage_taps_0( _S667 : u32,  _S668 : Footprint_0,  _S669 : bool) -> CoverageTaps_0
{
    var _S670 : Lobes_std430_0 = fabrics_0[_S667].lobes_0;
    var _S671 : f32 = Footprint_spread_side_0(_S668) * fabrics_0[_S667].lobes_0.inverse_base_size_0;
    var _S672 : vec3<f32> = pyramid_level_0(_S667, floor(binary_logarithm_0(max(0.68000000715255737f * _S671, 1.0f))));
    var _S673 : f32 = 1.0f / max(_S671, 9.99999997475242708e-07f);
    var _S674 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S667].warp_0].inverse_period_0, families_0[fabrics_0[_S667].weft_0].inverse_period_0);
    var _S675 : vec2<f32> = _S668.centre_0 * _S674;
    var _S676 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S673 * _S673), 0.0f, 1.0f)), 0.3333333432674408f * _S673), 1.0f));
    var _S677 : vec2<f32> = _S668.dx_0 * _S674 * _S676;
    var _S678 : vec2<f32> = _S668.dy_0 * _S674 * _S676;
    var taps_3 : CoverageTaps_0;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(number_2 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S679 : vec2<f32> = _S675 + vec2<f32>(TAP_OFFSETS_0[number_2].x) * _S677 + vec2<f32>(TAP_OFFSETS_0[number_2].y) * _S678;
        var _S680 : f32 = _S672.y;
        var _S681 : f32 = wrapped_cell_0(_S679.x, _S680);
        var _S682 : f32 = wrapped_cell_0(_S679.y, _S672.z);
        var _S683 : u32;
        if(_S669)
        {
            _S683 = _S670.face_nodes_0;
        }
        else
        {
            _S683 = u32(0);
        }
        taps_3.nodes_1[number_2] = _S683 + u32(_S682 * _S680 + _S681 + _S672.x);
        number_2 = number_2 + u32(1);
    }
    return taps_3;
}

fn coverage_of_pack_0( _S684 : u32,  _S685 : CoverageTaps_0,  _S686 : u32) -> vec4<f32>
{
    var number_3 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S687 : u32 = words_0[fabrics_0[_S684].lobes_0.coverage_0 + _S685.nodes_1[number_3] * fabrics_0[_S684].lobes_0.packs_0 + _S686];
        var even_2 : u32 = even_1 + ((_S687 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S687 >> (u32(8)))) & (u32(16711935))));
        number_3 = number_3 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S688 : u32,  _S689 : CoverageTaps_0) -> f32
{
    var number_4 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_4 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S688].lobes_0.coverage_holes_0 + _S689.nodes_1[number_4] / u32(4)] >> ((u32(8) * (_S689.nodes_1[number_4] % u32(4)))))) & (u32(255))));
        number_4 = number_4 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S690 : u32,  _S691 : CoverageTaps_0,  _S692 : NodeTaps_0,  _S693 : bool) -> f32
{
    var _S694 : Lobes_std430_0 = fabrics_0[_S690].lobes_0;
    var _S695 : f32 = interpolate_table_0(_S692, fabrics_0[_S690].lobes_0.projected_area_0 + fabrics_0[_S690].lobes_0.packs_0, fabrics_0[_S690].lobes_0.packs_0 + u32(1)).x;
    var _S696 : f32;
    if(_S693)
    {
        _S696 = _S694.back_hole_weight_0;
    }
    else
    {
        _S696 = _S694.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S690, _S691) * _S695 * _S695 * _S696, 1.0f);
}

fn prefiltered_components_0( _S697 : u32,  _S698 : Footprint_0,  _S699 : vec3<f32>,  _S700 : vec3<f32>,  _S701 : bool) -> Components_0
{
    var _S702 : CoverageTaps_0 = coverage_taps_0(_S697, _S698, _S701);
    var _S703 : NodeTaps_0 = node_taps_0(_S700);
    var view_nodes_0 : NodeTaps_0 = _S703;
    var light_nodes_0 : NodeTaps_0 = node_taps_0(_S699);
    var seen_nodes_0 : NodeTaps_0 = _S703;
    var _S704 : u32;
    if(_S701)
    {
        _S704 = u32(1);
    }
    else
    {
        _S704 = u32(0);
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S704 * u32(256)));
    var _S705 : u32 = u32(2) * _S704;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + vec4<u32>((_S705 * u32(256)));
    var _S706 : u32;
    if((_S699.z) < 0.0f)
    {
        _S706 = u32(1);
    }
    else
    {
        _S706 = u32(0);
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((_S705 + _S706) * u32(256)));
    var _S707 : vec3<f32> = half_vector_0(_S699, _S700);
    var _S708 : vec3<f32> = shadow_correlation_0(_S699, _S700);
    if(_S701)
    {
        _S706 = fabrics_0[_S697].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S706 = fabrics_0[_S697].lobes_0.front_warp_packs_0;
    }
    var sums_2 : Components_0;
    sums_2.diffuse_warp_0 = 0.0f;
    sums_2.diffuse_weft_0 = 0.0f;
    sums_2.specular_warp_0 = 0.0f;
    sums_2.specular_weft_0 = 0.0f;
    sums_2.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        var _S709 : Lobes_std430_0 = fabrics_0[_S697].lobes_0;
        if(pack_0 < (fabrics_0[_S697].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S710 : vec4<f32> = coverage_of_pack_0(_S697, _S702, pack_0);
        var _S711 : vec4<f32> = interpolate_table_0(view_nodes_0, _S709.projected_area_0 + pack_0, _S709.packs_0 + u32(1));
        var _S712 : u32 = _S709.light_visibility_0 + pack_0;
        var _S713 : vec4<f32> = vec4<f32>(255.0f);
        var _S714 : vec4<f32> = interpolate_table_0(seen_nodes_0, _S712, _S709.packs_0) / _S713;
        var _S715 : vec4<f32> = interpolate_table_0(light_nodes_0, _S712, _S709.packs_0) / _S713;
        var _S716 : vec4<f32> = interpolate_table_0(light_nodes_0, _S709.irradiance_0 + pack_0, _S709.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S717 : bool = pack_0 < _S706;
        var _S718 : u32;
        if(_S717)
        {
            _S718 = fabrics_0[_S697].warp_0;
        }
        else
        {
            _S718 = fabrics_0[_S697].weft_0;
        }
        var _S719 : f32 = families_0[_S718].roughness_0;
        var number_5 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_5 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S720 : Group_0 = group_at_0(_S709.moments_0 + u32(12) * (u32(4) * (_S704 * _S709.packs_0 + pack_0) + number_5), _S719);
            var _S721 : f32 = _S710[number_5] * _S711[number_5] * _S711[number_5] * _S720.weight_2;
            var _S722 : vec2<f32> = visibility_gain_0(_S708, _S715[number_5], _S714[number_5]);
            var _S723 : f32 = _S722.x;
            var diffuse_1 : f32 = diffuse_0 + _S721 * _S716[number_5] * _S723;
            var specular_1 : f32 = specular_0 + _S721 * layer_value_0(_S720, _S707, _S699, _S700, fabrics_0[_S697].optical_depth_0) * _S715[number_5] * _S722.y;
            sums_2.light_visibility_1 = sums_2.light_visibility_1 + _S721 * _S715[number_5] * _S723;
            var total_3 : f32 = total_2 + _S721;
            number_5 = number_5 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        var _S724 : f32;
        if(_S717)
        {
            _S724 = diffuse_0;
        }
        else
        {
            _S724 = 0.0f;
        }
        sums_2.diffuse_warp_0 = sums_2.diffuse_warp_0 + _S724;
        var _S725 : f32;
        if(_S717)
        {
            _S725 = 0.0f;
        }
        else
        {
            _S725 = diffuse_0;
        }
        sums_2.diffuse_weft_0 = sums_2.diffuse_weft_0 + _S725;
        var _S726 : f32;
        if(_S717)
        {
            _S726 = specular_0;
        }
        else
        {
            _S726 = 0.0f;
        }
        sums_2.specular_warp_0 = sums_2.specular_warp_0 + _S726;
        var _S727 : f32;
        if(_S717)
        {
            _S727 = 0.0f;
        }
        else
        {
            _S727 = specular_0;
        }
        sums_2.specular_weft_0 = sums_2.specular_weft_0 + _S727;
        pack_0 = pack_0 + u32(1);
    }
    var _S728 : f32 = prefiltered_hole_0(_S697, _S702, view_nodes_0, _S701);
    sums_2.hole_2 = _S728;
    var _S729 : f32 = (1.0f - _S728) / max(total_2, 9.999999960041972e-13f);
    sums_2.diffuse_warp_0 = sums_2.diffuse_warp_0 * _S729;
    sums_2.diffuse_weft_0 = sums_2.diffuse_weft_0 * _S729;
    sums_2.specular_warp_0 = sums_2.specular_warp_0 * _S729;
    sums_2.specular_weft_0 = sums_2.specular_weft_0 * _S729;
    sums_2.light_visibility_1 = sums_2.light_visibility_1 * _S729;
    return sums_2;
}

fn albedos_over_0( _S730 : u32,  _S731 : Footprint_0,  _S732 : bool) -> FamilyAlbedos_0
{
    var _S733 : vec2<f32> = _S731.dx_0;
    var _S734 : vec2<f32> = _S731.dy_0;
    var _S735 : vec2<f32> = sqrt(_S733 * _S733 + _S734 * _S734);
    var _S736 : Stretch_0 = stretch_of_0(fabrics_0[_S730].warp_0, _S731.centre_0.x, _S735.x);
    var _S737 : Stretch_0 = stretch_of_0(fabrics_0[_S730].weft_0, _S731.centre_0.y, _S735.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S730].warp_0, fabrics_0[_S730].weft_0, _S736, _S737, _S732);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S730].weft_0, fabrics_0[_S730].warp_0, _S737, _S736, _S732);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S738 : u32,  _S739 : Footprint_0,  _S740 : f32,  _S741 : vec2<f32>,  _S742 : vec3<f32>,  _S743 : vec3<f32>) -> Estimate_0
{
    var _S744 : f32;
    var _S745 : f32;
    var _S746 : Regime_0 = regime_of_0(_S738, _S739, _S740);
    var _S747 : bool = (_S743.z) < 0.0f;
    var _S748 : vec3<f32> = to_face_frame_0(_S743, _S747);
    var _S749 : f32 = Footprint_spread_side_0(_S739);
    var _S750 : bool = varies_at_0(_S738, _S749);
    var _S751 : bool;
    if((families_0[fabrics_0[_S738].warp_0].quantities_0) > u32(1))
    {
        _S751 = true;
    }
    else
    {
        _S751 = (families_0[fabrics_0[_S738].weft_0].quantities_0) > u32(1);
    }
    var _S752 : f32 = 1.0f - _S746.prefiltered_0;
    if(_S752 > 0.0f)
    {
        if(_S750)
        {
            _S751 = true;
        }
    }
    else
    {
        _S751 = false;
    }
    var box_0 : Footprint_0 = _S739;
    var _S753 : vec3<f32> = vec3<f32>(0.0f);
    var _S754 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S753, _S753, 0.0f, 0.0f, 0.0f);
    var _S755 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S756 : i32;
    if(_S751)
    {
        _S756 = i32(0);
    }
    else
    {
        _S756 = i32(1);
    }
    var _S757 : u32 = u32(_S756);
    var points_1 : Components_0 = _S755;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S754;
    var central_place_0 : vec2<f32> = _S739.centre_0;
    var number_6 : u32 = _S757;
    for(;;)
    {
        var _S758 : f32 = f32(number_6);
        _S744 = _S746.points_0;
        if(_S758 < (_S746.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S759 : bool = number_6 == u32(0);
        var _S760 : u32;
        if(_S759)
        {
            _S760 = u32(0);
        }
        else
        {
            _S760 = number_6 - u32(1);
        }
        var _S761 : vec2<f32> = POINT_OFFSETS_0[_S760] + _S741;
        var _S762 : vec2<f32>;
        if(_S759)
        {
            _S762 = vec2<f32>(0.0f);
        }
        else
        {
            _S762 = _S761 - round(_S761);
        }
        var _S763 : vec2<f32> = _S739.centre_0 + vec2<f32>(_S762.x) * _S739.dx_0 + vec2<f32>(_S762.y) * _S739.dy_0;
        if(_S759)
        {
            _S745 = 0.0f;
        }
        else
        {
            _S745 = _S746.threads_1;
        }
        var _S764 : SearchQuality_0 = quality_of_0(_S745);
        var _S765 : Hit_0 = first_hit_0(_S738, _S764, _S763.x, _S763.y, _S748, _S747);
        var _S766 : SurfacePoint_0 = surface_at_0(_S738, _S765.x_12, _S765.y_5, _S747);
        if(_S759)
        {
            var central_weight_1 : f32;
            if(_S765.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S752;
            }
            var central_place_1 : vec2<f32> = vec2<f32>(_S765.x_12, _S765.y_5);
            box_0.centre_0 = mix(_S739.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S766;
            central_place_0 = central_place_1;
            number_6 = number_6 + u32(1);
            continue;
        }
        var _S767 : YarnPoint_0 = yarn_point_of_0(_S738, _S766, _S765.x_12, _S765.y_5, _S747, _S765.hole_5, _S749);
        var _S768 : f32 = min(_S746.points_0 - f32(number_6 - u32(1)), 1.0f);
        var _S769 : Components_0 = with_added_0(points_1, components_of_point_0(_S738, _S764, _S767, _S742, _S743), _S768);
        if((fabrics_0[_S738].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S738, close_1.warp_1, _S767, true, _S768);
            close_1.weft_1 = with_blocked_0(_S738, close_1.weft_1, _S767, false, _S768);
        }
        points_1 = _S769;
        number_6 = number_6 + u32(1);
    }
    close_1.weight_0 = _S752;
    var _S770 : f32 = max(_S744, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S770);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S770);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S755, points_1, _S752 / _S770);
    if((_S746.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S738, _S739, to_face_frame_0(_S742, _S747), _S748, _S747), _S746.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S738, box_0, _S747);
    if(_S750)
    {
        _S751 = central_weight_0 > 0.0f;
    }
    else
    {
        _S751 = false;
    }
    if(_S751)
    {
        var _S771 : SurfacePoint_0 = central_0;
        var _S772 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S772 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S772 = estimate_0.albedos_5.weft_5;
        }
        if((fabrics_0[_S738].has_detail_0) != u32(0))
        {
            _S751 = has_hairs_0(_S738);
        }
        else
        {
            _S751 = false;
        }
        if(_S751)
        {
            _S745 = hair_at_0(_S738, central_place_0, _S747, _S749).cover_0;
        }
        else
        {
            _S745 = 0.0f;
        }
        var _S773 : Albedos_0 = lerp_albedos_0(_S772, varied_at_0(_S738, central_0, _S772, central_place_0.x, central_place_0.y, _S747, _S749, _S745), central_weight_0);
        if(_S771.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S773;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S773;
        }
    }
    return estimate_0;
}

fn lobes_estimate_0( _S774 : u32,  _S775 : Footprint_0,  _S776 : f32,  _S777 : vec3<f32>,  _S778 : vec3<f32>) -> Estimate_0
{
    return lobes_estimate_of_pass_0(_S774, _S775, _S776, vec2<f32>(0.0f), _S777, _S778);
}

fn scattered_by_0( _S779 : u32,  _S780 : Albedos_0,  _S781 : u32,  _S782 : vec3<f32>) -> Scattered_0
{
    var _S783 : u32 = u32(159) + u32(2) * _S781;
    var yarn_3 : Scattered_0;
    yarn_3.back_6 = _S782 * _S780.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S779, _S783)) * _S780.specular_reflect_0;
    yarn_3.through_0 = _S782 * _S780.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S779, _S783 + u32(1))) * _S780.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S784 : u32,  _S785 : u32,  _S786 : vec3<f32>,  _S787 : vec3<f32>,  _S788 : vec3<f32>,  _S789 : vec3<f32>,  _S790 : ptr<function, vec3<f32>>,  _S791 : ptr<function, vec3<f32>>)
{
    var _S792 : u32 = u32(146) + u32(4) * _S785;
    var _S793 : f32 = openness_number_0(_S784, _S792 + u32(1));
    var _S794 : f32 = openness_number_0(_S784, _S792 + u32(2));
    var _S795 : vec3<f32> = vec3<f32>(1.0f);
    var _S796 : vec3<f32> = _S795 - _S788 * vec3<f32>(openness_number_0(_S784, _S792));
    var _S797 : vec3<f32> = _S795 - _S789 * vec3<f32>(openness_number_0(_S784, _S792 + u32(3)));
    var _S798 : vec3<f32> = _S795 / (_S796 * _S797 - _S788 * _S789 * vec3<f32>((_S793 * _S794)));
    (*_S790) = (_S786 * _S797 + _S788 * vec3<f32>(_S793) * _S787) * _S798;
    (*_S791) = (_S787 * _S796 + _S789 * vec3<f32>(_S794) * _S786) * _S798;
    return;
}

fn face_sends_0( _S799 : u32,  _S800 : u32,  _S801 : Scattered_0,  _S802 : Scattered_0) -> FaceSends_0
{
    var _S803 : u32 = u32(2) * _S800;
    var _S804 : u32 = u32(142) + _S803;
    var _S805 : f32 = openness_number_0(_S799, _S804);
    var _S806 : f32 = openness_number_0(_S799, _S804 + u32(1));
    var _S807 : vec3<f32> = vec3<f32>((1.0f - _S805)) * _S801.back_6;
    var _S808 : vec3<f32> = vec3<f32>((1.0f - _S806)) * _S802.back_6;
    var sends_1 : FaceSends_0;
    var _S809 : u32 = u32(154) + _S803;
    var _S810 : f32 = openness_number_0(_S799, _S809);
    sends_1.blocks_warp_0 = _S810;
    var _S811 : f32 = openness_number_0(_S799, _S809 + u32(1));
    sends_1.blocks_weft_0 = _S811;
    sends_1.open_0 = _S810 * _S805 + _S811 * _S806;
    var _S812 : vec3<f32> = vec3<f32>(_S805) * _S801.back_6;
    var _S813 : vec3<f32> = vec3<f32>(_S806) * _S802.back_6;
    var _S814 : vec3<f32> = sends_1.sky_warp_0;
    var _S815 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S799, _S800, _S812, _S813, _S807, _S808, &(_S814), &(_S815));
    sends_1.sky_warp_0 = _S814;
    sends_1.sky_weft_0 = _S815;
    var _S816 : vec3<f32> = sends_1.crossing_warp_0;
    var _S817 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S799, _S800, _S801.through_0, _S802.through_0, _S807, _S808, &(_S816), &(_S817));
    sends_1.crossing_warp_0 = _S816;
    sends_1.crossing_weft_0 = _S817;
    return sends_1;
}

fn interior_of_0( _S818 : u32,  _S819 : vec3<f32>,  _S820 : bool) -> Interior_0
{
    var _S821 : Scattered_0 = scattered_by_0(_S818, table_albedos_0(families_0[fabrics_0[_S818].warp_0].colour_mean_0), u32(0), _S819);
    var _S822 : Scattered_0 = scattered_by_0(_S818, table_albedos_0(families_0[fabrics_0[_S818].weft_0].colour_mean_0), u32(1), _S819);
    var _S823 : u32;
    if(_S820)
    {
        _S823 = u32(1);
    }
    else
    {
        _S823 = u32(0);
    }
    var _S824 : FaceSends_0 = face_sends_0(_S818, _S823, _S821, _S822);
    if(_S820)
    {
        _S823 = u32(0);
    }
    else
    {
        _S823 = u32(1);
    }
    var _S825 : FaceSends_0 = face_sends_0(_S818, _S823, _S821, _S822);
    var _S826 : vec3<f32> = vec3<f32>(_S824.blocks_warp_0);
    var _S827 : vec3<f32> = vec3<f32>(_S824.blocks_weft_0);
    var _S828 : vec3<f32> = _S826 * _S824.crossing_warp_0 + _S827 * _S824.crossing_weft_0;
    var _S829 : vec3<f32> = vec3<f32>(_S825.blocks_warp_0);
    var _S830 : vec3<f32> = vec3<f32>(_S825.blocks_weft_0);
    var _S831 : vec3<f32> = _S829 * _S825.crossing_warp_0 + _S830 * _S825.crossing_weft_0;
    var _S832 : f32 = 1.0f - _S824.open_0;
    var _S833 : f32 = 1.0f - _S825.open_0;
    var _S834 : vec3<f32> = vec3<f32>(1.0f);
    var _S835 : vec3<f32> = _S834 / (_S834 - _S828 * _S831 * vec3<f32>((_S832 * _S833)));
    var _S836 : vec3<f32> = _S831 * (vec3<f32>(_S824.open_0) + vec3<f32>(_S832) * (_S826 * _S824.sky_warp_0 + _S827 * _S824.sky_weft_0)) * _S835;
    var _S837 : vec3<f32> = _S828 * (vec3<f32>(_S825.open_0) + vec3<f32>(_S833) * (_S829 * _S825.sky_warp_0 + _S830 * _S825.sky_weft_0)) * _S835;
    var _S838 : FaceRadiance_0 = face_radiance_0(_S824, _S825.open_0, _S836, _S837);
    var _S839 : FaceRadiance_0 = face_radiance_0(_S825, _S824.open_0, _S837, _S836);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S838.warp_3;
    interior_1.weft_4 = _S838.weft_3;
    interior_1.leaked_1 = _S838.leaked_0;
    interior_1.far_1 = _S839.mean_0;
    interior_1.far_leaked_0 = _S839.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S840 : u32,  _S841 : vec3<f32>,  _S842 : bool,  _S843 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S841, &(terms_3));
    var _S844 : u32;
    if(_S843)
    {
        _S844 = u32(2);
    }
    else
    {
        _S844 = u32(0);
    }
    var _S845 : u32;
    if(_S842)
    {
        _S845 = u32(0);
    }
    else
    {
        _S845 = u32(1);
    }
    return blocked_of_terms_0(_S840, (_S844 + _S845) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S846 : u32,  _S847 : vec3<f32>,  _S848 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S847, &(terms_4));
    var term_1 : u32 = u32(0);
    var share_4 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var _S849 : u32;
        if(_S848)
        {
            _S849 = u32(5);
        }
        else
        {
            _S849 = u32(0);
        }
        var share_5 : f32 = share_4 + openness_number_0(_S846, u32(132) + _S849 + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_4 = share_5;
    }
    return saturate(share_4);
}

fn bounced_of_families_0( _S850 : u32,  _S851 : FamilyAlbedos_0,  _S852 : vec3<f32>,  _S853 : Interior_0,  _S854 : Blocked_0,  _S855 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S854, scattered_by_0(_S850, _S851.warp_5, u32(0), _S852), _S853), bounced_by_0(_S855, scattered_by_0(_S850, _S851.weft_5, u32(1), _S852), _S853));
}

fn bounced_far_0( _S856 : u32,  _S857 : FamilyAlbedos_0,  _S858 : vec3<f32>,  _S859 : Interior_0,  _S860 : vec3<f32>,  _S861 : bool,  _S862 : f32,  _S863 : f32,  _S864 : f32) -> Bounced_0
{
    var _S865 : Blocked_0 = blocked_from_0(_S856, _S860, true, _S861);
    var _S866 : Blocked_0 = blocked_from_0(_S856, _S860, false, _S861);
    var _S867 : f32 = _S862 / max(1.0f - _S865.by_warp_0 - _S865.by_weft_0, 0.10000000149011612f);
    var _S868 : f32 = (0.0020000000949949f * warp_seen_from_0(_S856, _S860, _S861) + _S867) / (_S867 + _S863 / max(1.0f - _S866.by_warp_0 - _S866.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S869 : f32 = 1.0f - _S864;
    return bounced_of_families_0(_S856, _S857, _S858, _S859, scaled_0(_S865, _S868 * _S869), scaled_0(_S866, (1.0f - _S868) * _S869));
}

fn bounced_over_0( _S870 : u32,  _S871 : Components_0,  _S872 : CloseUp_0,  _S873 : FamilyAlbedos_0,  _S874 : vec3<f32>,  _S875 : vec3<f32>) -> Bounced_0
{
    var _S876 : bool = (_S875.z) < 0.0f;
    var _S877 : Interior_0 = interior_of_0(_S870, _S874, _S876);
    var bounced_2 : Bounced_0 = bounced_far_0(_S870, _S873, _S874, _S877, to_face_frame_0(_S875, _S876), _S876, _S871.diffuse_warp_0, _S871.diffuse_weft_0, _S871.hole_2);
    if((_S872.weight_0) > 0.0f)
    {
        var _S878 : Bounced_0 = bounced_of_families_0(_S870, _S873, _S874, _S877, _S872.warp_1, _S872.weft_1);
        var _S879 : vec3<f32> = vec3<f32>(_S872.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S878.reflected_0, _S879);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S878.transmitted_0, _S879);
    }
    return bounced_2;
}

fn composed_0( _S880 : u32,  _S881 : Components_0,  _S882 : CloseUp_0,  _S883 : FamilyAlbedos_0,  _S884 : vec3<f32>,  _S885 : vec3<f32>,  _S886 : vec3<f32>) -> vec3<f32>
{
    var _S887 : Albedos_0 = tinted_0(_S883.warp_5, _S884);
    var _S888 : Albedos_0 = tinted_0(_S883.weft_5, _S884);
    var _S889 : vec3<f32> = vec3<f32>(_S881.diffuse_warp_0);
    var _S890 : vec3<f32> = vec3<f32>(_S881.diffuse_weft_0);
    var _S891 : vec3<f32> = vec3<f32>(_S881.specular_warp_0);
    var _S892 : vec3<f32> = vec3<f32>(_S881.specular_weft_0);
    var _S893 : vec3<f32> = _S887.diffuse_reflect_0 * _S889 + _S888.diffuse_reflect_0 * _S890 + _S887.specular_reflect_0 * _S891 + _S888.specular_reflect_0 * _S892;
    var _S894 : f32 = _S886.z;
    var body_0 : vec3<f32>;
    if((_S885.z * _S894) < 0.0f)
    {
        body_0 = _S887.diffuse_transmit_0 * _S889 + _S888.diffuse_transmit_0 * _S890 + _S887.specular_transmit_0 * _S891 + _S888.specular_transmit_0 * _S892;
    }
    else
    {
        body_0 = _S893;
    }
    if((fabrics_0[_S880].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S880, _S881, _S882, _S883, _S884, _S886), _S885, _S886);
    }
    var _S895 : f32 = fabrics_0[_S880].sheen_strength_0;
    if((fabrics_0[_S880].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S896 : bool = _S894 < 0.0f;
    var _S897 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S885, _S896), to_face_frame_0(_S886, _S896), _S895, fabrics_0[_S880].sheen_roughness_0);
    return vec3<f32>(_S897.y) * body_0 + vec3<f32>(((_S881.light_visibility_1 + _S881.hole_2) * _S897.x));
}

fn cloth_value_0( fabric_1 : u32,  centre_2 : vec2<f32>,  dx_1 : vec2<f32>,  dy_1 : vec2<f32>,  light_11 : vec3<f32>,  view_12 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = centre_2;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    var _S898 : Estimate_0 = lobes_estimate_0(fabric_1, footprint_0, 1.0f, light_11, view_12);
    var _S899 : vec3<f32> = composed_0(fabric_1, _S898.components_0, _S898.close_0, _S898.albedos_5, vec3<f32>(1.0f), light_11, view_12);
    var through_1 : f32;
    if((fabrics_0[fabric_1].sheen_strength_0) > 0.0f)
    {
        through_1 = _S898.components_0.hole_2 * (1.0f - fabrics_0[fabric_1].sheen_strength_0 * sheen_lobe_0(abs(view_12.z), fabrics_0[fabric_1].sheen_roughness_0).z);
    }
    else
    {
        through_1 = _S898.components_0.hole_2;
    }
    return vec4<f32>(_S899, through_1);
}

@compute
@workgroup_size(64, 1, 1)
fn lobes_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S900 : u32 = id_0.x;
    if(_S900 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S901 : Query_std430_0 = queries_0[_S900];
    answers_0[_S900] = cloth_value_0(_S901.fabric_0, vec2<f32>(_S901.centre_x_0, _S901.centre_y_0), vec2<f32>(_S901.dx_x_0, _S901.dx_y_0), vec2<f32>(_S901.dy_x_0, _S901.dy_y_0), vec3<f32>(_S901.light_x_0, _S901.light_y_0, _S901.light_z_0), vec3<f32>(_S901.view_x_0, _S901.view_y_0, _S901.view_z_0));
    return;
}

