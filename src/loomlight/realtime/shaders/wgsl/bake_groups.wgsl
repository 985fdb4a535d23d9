struct Bake_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) per_family_0 : u32,
    @align(4) packs_0 : u32,
    @align(4) max_clusters_0 : u32,
    @align(4) rays_0 : u32,
    @align(4) ends_0 : f32,
    @align(4) picks_0 : f32,
    @align(4) spacing_x_0 : f32,
    @align(4) spacing_y_0 : f32,
    @align(4) columns_0 : u32,
    @align(4) rows_0 : u32,
    @align(4) face_nodes_0 : u32,
    @align(4) texels_across_0 : u32,
    @align(4) texels_along_0 : u32,
    @align(4) texel_x_0 : f32,
    @align(4) texel_y_0 : f32,
    @align(4) far_weight_0 : f32,
    @align(4) moments_table_0 : u32,
    @align(4) record_warp_packs_0 : u32,
    @align(4) record_hole_weights_0 : u32,
    @align(4) facts_0 : u32,
    @align(4) gaps_0 : u32,
    @align(4) gap_nulls_0 : u32,
    @align(4) lit_0 : u32,
    @align(4) lists_0 : u32,
    @align(4) points_0 : u32,
    @align(4) clusters_0 : u32,
    @align(4) cluster_means_0 : u32,
    @align(4) cluster_errors_0 : u32,
    @align(4) centroids_0 : u32,
    @align(4) view_sums_0 : u32,
    @align(4) light_sums_0 : u32,
    @align(4) group_moments_0 : u32,
    @align(4) areas_0 : u32,
    @align(4) area_scales_0 : u32,
    @align(4) stand_ins_0 : u32,
    @align(4) row_totals_0 : u32,
    @align(4) row_largest_0 : u32,
    @align(4) coverage_means_0 : u32,
    @align(4) coverage_scales_0 : u32,
    @align(4) hole_bytes_0 : u32,
};

@binding(11) @group(0) var<storage, read> bakes_0 : array<Bake_std430_0>;

@binding(14) @group(0) var<storage, read_write> scratch_0 : array<u32>;

struct SurfaceHit_std430_0
{
    @align(4) place_x_0 : f32,
    @align(4) place_y_0 : f32,
    @align(4) place_z_0 : f32,
    @align(4) flags_0 : u32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) tangent_x_0 : f32,
    @align(4) tangent_y_0 : f32,
    @align(4) tangent_z_0 : f32,
    @align(4) shown_share_0 : f32,
};

@binding(13) @group(0) var<storage, read_write> hits_0 : array<SurfaceHit_std430_0>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec2<f32>,  no_0 : vec2<f32>) -> vec2<f32>
{
    var chosen_0 : vec2<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    return chosen_0;
}

var<workgroup> labels_0 : array<u32, i32(2048)>;

var<workgroup> is_finished_0 : u32;

fn scratch_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((scratch_0[index_0])));
}

var<workgroup> partial_0 : array<f32, i32(256)>;

var<workgroup> mean_0 : array<f32, i32(8)>;

fn features_of_pair_0( pair_0 : u32) -> vec2<u32>
{
    var first_0 : u32 = u32(0);
    var begin_0 : u32 = u32(0);
    var k_0 : u32 = u32(1);
    for(;;)
    {
        if(k_0 < u32(7))
        {
        }
        else
        {
            break;
        }
        var _S1 : u32 = k_0 + u32(1);
        var _S2 : u32 = k_0 * _S1;
        if(pair_0 >= (_S2 / u32(2)))
        {
            var _S3 : u32 = _S2 / u32(2);
            first_0 = k_0;
            begin_0 = _S3;
        }
        k_0 = _S1;
    }
    return vec2<u32>(first_0, pair_0 - begin_0);
}

var<workgroup> scatter_0 : array<f32, i32(28)>;

var<workgroup> widest_0 : u32;

var<workgroup> matrix_0 : array<f32, i32(49)>;

var<workgroup> squared_0 : array<f32, i32(49)>;

fn principal_axis_0( worker_0 : u32,  row_0 : u32) -> u32
{
    var _S4 : u32 = min(worker_0, u32(48));
    var _S5 : u32 = _S4 % u32(7);
    var _S6 : u32 = max(_S4 / u32(7), _S5);
    var _S7 : u32 = min(_S4 / u32(7), _S5);
    var _S8 : bool = worker_0 < u32(49);
    if(_S8)
    {
        matrix_0[worker_0] = scratch_number_0(row_0 + u32(1) + u32(7) + _S6 * (_S6 + u32(1)) / u32(2) + _S7);
    }
    workgroupBarrier();
    var step_0 : u32 = u32(0);
    for(;;)
    {
        if(step_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var trace_0 : f32 = 1.00000000317107685e-30f + matrix_0[u32(0)] + matrix_0[u32(8)] + matrix_0[u32(16)] + matrix_0[u32(24)] + matrix_0[u32(32)] + matrix_0[u32(40)] + matrix_0[u32(48)];
        var total_0 : f32 = matrix_0[_S4 / u32(7) * u32(7)] / trace_0 * (matrix_0[_S5] / trace_0) + matrix_0[_S4 / u32(7) * u32(7) + u32(1)] / trace_0 * (matrix_0[u32(7) + _S5] / trace_0) + matrix_0[_S4 / u32(7) * u32(7) + u32(2)] / trace_0 * (matrix_0[u32(14) + _S5] / trace_0) + matrix_0[_S4 / u32(7) * u32(7) + u32(3)] / trace_0 * (matrix_0[u32(21) + _S5] / trace_0) + matrix_0[_S4 / u32(7) * u32(7) + u32(4)] / trace_0 * (matrix_0[u32(28) + _S5] / trace_0) + matrix_0[_S4 / u32(7) * u32(7) + u32(5)] / trace_0 * (matrix_0[u32(35) + _S5] / trace_0) + matrix_0[_S4 / u32(7) * u32(7) + u32(6)] / trace_0 * (matrix_0[u32(42) + _S5] / trace_0);
        if(_S8)
        {
            squared_0[worker_0] = total_0;
        }
        workgroupBarrier();
        if(_S8)
        {
            matrix_0[worker_0] = squared_0[worker_0];
        }
        workgroupBarrier();
        step_0 = step_0 + u32(1);
    }
    var k_1 : u32 = u32(1);
    var largest_0 : u32 = u32(0);
    for(;;)
    {
        if(k_1 < u32(7))
        {
        }
        else
        {
            break;
        }
        var _S9 : u32 = select(largest_0, k_1, (matrix_0[u32(8) * k_1]) > (matrix_0[u32(8) * largest_0]));
        k_1 = k_1 + u32(1);
        largest_0 = _S9;
    }
    return u32(7) * largest_0;
}

var<workgroup> pairs_of_sums_0 : array<vec2<f32>, i32(256)>;

fn sum_of_workers_0( value_0 : vec2<f32>,  worker_1 : u32) -> vec2<f32>
{
    pairs_of_sums_0[worker_1] = value_0;
    var half_0 : u32 = u32(128);
    for(;;)
    {
        if(half_0 > u32(0))
        {
        }
        else
        {
            break;
        }
        workgroupBarrier();
        if(worker_1 < half_0)
        {
            pairs_of_sums_0[worker_1] = pairs_of_sums_0[worker_1] + pairs_of_sums_0[worker_1 + half_0];
        }
        half_0 = half_0 / u32(2);
    }
    workgroupBarrier();
    var _S10 : vec2<f32> = pairs_of_sums_0[i32(0)];
    workgroupBarrier();
    return _S10;
}

fn point_row_0( _S11 : i32,  _S12 : u32,  _S13 : u32) -> u32
{
    return bakes_0[_S11].points_0 + (_S12 * u32(2048) + _S13) * u32(7);
}

fn measure_0( _S14 : i32,  _S15 : u32,  _S16 : u32,  _S17 : u32,  _S18 : u32)
{
    var total_1 : f32;
    var total_2 : f32;
    var total_3 : f32;
    var total_4 : f32;
    var total_5 : f32;
    var total_6 : f32;
    var total_7 : f32;
    var _S19 : u32 = _S18 / u32(32);
    var _S20 : u32 = _S18 % u32(32);
    var i_0 : u32 = u32(0);
    var total_8 : f32 = 0.0f;
    for(;;)
    {
        if(i_0 < u32(256))
        {
        }
        else
        {
            break;
        }
        var _S21 : u32 = _S19 * u32(256) + i_0;
        var _S22 : bool = _S20 <= u32(7);
        if(((((_S21 < _S17) & (((labels_0[_S21]) == _S16)))) & (_S22)))
        {
            if(_S20 == u32(7))
            {
                total_1 = 1.0f;
            }
            else
            {
                total_1 = scratch_number_0(point_row_0(_S14, _S15, _S21) + min(_S20, u32(6)));
            }
            total_1 = total_8 + total_1;
        }
        else
        {
            total_1 = total_8;
        }
        var _S23 : u32 = _S21 + u32(1);
        if(((((_S23 < _S17) & (((labels_0[_S23]) == _S16)))) & (_S22)))
        {
            if(_S20 == u32(7))
            {
                total_2 = 1.0f;
            }
            else
            {
                total_2 = scratch_number_0(point_row_0(_S14, _S15, _S23) + min(_S20, u32(6)));
            }
            total_2 = total_1 + total_2;
        }
        else
        {
            total_2 = total_1;
        }
        var _S24 : u32 = _S21 + u32(2);
        if(((((_S24 < _S17) & (((labels_0[_S24]) == _S16)))) & (_S22)))
        {
            if(_S20 == u32(7))
            {
                total_3 = 1.0f;
            }
            else
            {
                total_3 = scratch_number_0(point_row_0(_S14, _S15, _S24) + min(_S20, u32(6)));
            }
            total_3 = total_2 + total_3;
        }
        else
        {
            total_3 = total_2;
        }
        var _S25 : u32 = _S21 + u32(3);
        if(((((_S25 < _S17) & (((labels_0[_S25]) == _S16)))) & (_S22)))
        {
            if(_S20 == u32(7))
            {
                total_4 = 1.0f;
            }
            else
            {
                total_4 = scratch_number_0(point_row_0(_S14, _S15, _S25) + min(_S20, u32(6)));
            }
            total_4 = total_3 + total_4;
        }
        else
        {
            total_4 = total_3;
        }
        var _S26 : u32 = _S21 + u32(4);
        if(((((_S26 < _S17) & (((labels_0[_S26]) == _S16)))) & (_S22)))
        {
            if(_S20 == u32(7))
            {
                total_5 = 1.0f;
            }
            else
            {
                total_5 = scratch_number_0(point_row_0(_S14, _S15, _S26) + min(_S20, u32(6)));
            }
            total_5 = total_4 + total_5;
        }
        else
        {
            total_5 = total_4;
        }
        var _S27 : u32 = _S21 + u32(5);
        if(((((_S27 < _S17) & (((labels_0[_S27]) == _S16)))) & (_S22)))
        {
            if(_S20 == u32(7))
            {
                total_6 = 1.0f;
            }
            else
            {
                total_6 = scratch_number_0(point_row_0(_S14, _S15, _S27) + min(_S20, u32(6)));
            }
            total_6 = total_5 + total_6;
        }
        else
        {
            total_6 = total_5;
        }
        var _S28 : u32 = _S21 + u32(6);
        if(((((_S28 < _S17) & (((labels_0[_S28]) == _S16)))) & (_S22)))
        {
            if(_S20 == u32(7))
            {
                total_7 = 1.0f;
            }
            else
            {
                total_7 = scratch_number_0(point_row_0(_S14, _S15, _S28) + min(_S20, u32(6)));
            }
            total_7 = total_6 + total_7;
        }
        else
        {
            total_7 = total_6;
        }
        var _S29 : u32 = _S21 + u32(7);
        if(((((_S29 < _S17) & (((labels_0[_S29]) == _S16)))) & (_S22)))
        {
            var _S30 : f32;
            if(_S20 == u32(7))
            {
                _S30 = 1.0f;
            }
            else
            {
                _S30 = scratch_number_0(point_row_0(_S14, _S15, _S29) + min(_S20, u32(6)));
            }
            total_8 = total_7 + _S30;
        }
        else
        {
            total_8 = total_7;
        }
        i_0 = i_0 + u32(8);
    }
    partial_0[_S18] = total_8;
    workgroupBarrier();
    var other_0 : u32;
    if(_S18 < u32(8))
    {
        other_0 = u32(0);
        total_1 = 0.0f;
        for(;;)
        {
            if(other_0 < u32(8))
            {
            }
            else
            {
                break;
            }
            var all_0 : f32 = total_1 + partial_0[other_0 * u32(32) + _S18];
            other_0 = other_0 + u32(1);
            total_1 = all_0;
        }
        mean_0[_S18] = total_1;
    }
    workgroupBarrier();
    var _S31 : f32 = max(mean_0[u32(7)], 1.0f);
    var _S32 : vec2<u32> = features_of_pair_0(min(_S20, u32(27)));
    var _S33 : u32 = _S32.x;
    var _S34 : f32 = mean_0[_S33] / _S31;
    var _S35 : u32 = _S32.y;
    var _S36 : f32 = mean_0[_S35] / _S31;
    i_0 = u32(0);
    total_8 = 0.0f;
    for(;;)
    {
        if(i_0 < u32(256))
        {
        }
        else
        {
            break;
        }
        var _S37 : u32 = _S19 * u32(256) + i_0;
        var _S38 : u32 = point_row_0(_S14, _S15, _S37);
        if(((_S37 < _S17) & (((labels_0[_S37]) == _S16))))
        {
            total_1 = total_8 + (scratch_number_0(_S38 + _S33) - _S34) * (scratch_number_0(_S38 + _S35) - _S36);
        }
        else
        {
            total_1 = total_8;
        }
        var _S39 : u32 = _S37 + u32(1);
        var _S40 : u32 = point_row_0(_S14, _S15, _S39);
        if(((_S39 < _S17) & (((labels_0[_S39]) == _S16))))
        {
            total_2 = total_1 + (scratch_number_0(_S40 + _S33) - _S34) * (scratch_number_0(_S40 + _S35) - _S36);
        }
        else
        {
            total_2 = total_1;
        }
        var _S41 : u32 = _S37 + u32(2);
        var _S42 : u32 = point_row_0(_S14, _S15, _S41);
        if(((_S41 < _S17) & (((labels_0[_S41]) == _S16))))
        {
            total_3 = total_2 + (scratch_number_0(_S42 + _S33) - _S34) * (scratch_number_0(_S42 + _S35) - _S36);
        }
        else
        {
            total_3 = total_2;
        }
        var _S43 : u32 = _S37 + u32(3);
        var _S44 : u32 = point_row_0(_S14, _S15, _S43);
        if(((_S43 < _S17) & (((labels_0[_S43]) == _S16))))
        {
            total_4 = total_3 + (scratch_number_0(_S44 + _S33) - _S34) * (scratch_number_0(_S44 + _S35) - _S36);
        }
        else
        {
            total_4 = total_3;
        }
        var _S45 : u32 = _S37 + u32(4);
        var _S46 : u32 = point_row_0(_S14, _S15, _S45);
        if(((_S45 < _S17) & (((labels_0[_S45]) == _S16))))
        {
            total_5 = total_4 + (scratch_number_0(_S46 + _S33) - _S34) * (scratch_number_0(_S46 + _S35) - _S36);
        }
        else
        {
            total_5 = total_4;
        }
        var _S47 : u32 = _S37 + u32(5);
        var _S48 : u32 = point_row_0(_S14, _S15, _S47);
        if(((_S47 < _S17) & (((labels_0[_S47]) == _S16))))
        {
            total_6 = total_5 + (scratch_number_0(_S48 + _S33) - _S34) * (scratch_number_0(_S48 + _S35) - _S36);
        }
        else
        {
            total_6 = total_5;
        }
        var _S49 : u32 = _S37 + u32(6);
        var _S50 : u32 = point_row_0(_S14, _S15, _S49);
        if(((_S49 < _S17) & (((labels_0[_S49]) == _S16))))
        {
            total_7 = total_6 + (scratch_number_0(_S50 + _S33) - _S34) * (scratch_number_0(_S50 + _S35) - _S36);
        }
        else
        {
            total_7 = total_6;
        }
        var _S51 : u32 = _S37 + u32(7);
        var _S52 : u32 = point_row_0(_S14, _S15, _S51);
        if(((_S51 < _S17) & (((labels_0[_S51]) == _S16))))
        {
            total_8 = total_7 + (scratch_number_0(_S52 + _S33) - _S34) * (scratch_number_0(_S52 + _S35) - _S36);
        }
        else
        {
            total_8 = total_7;
        }
        i_0 = i_0 + u32(8);
    }
    workgroupBarrier();
    partial_0[_S18] = total_8;
    workgroupBarrier();
    var _S53 : bool = _S18 < u32(28);
    if(_S53)
    {
        other_0 = u32(0);
        total_1 = 0.0f;
        for(;;)
        {
            if(other_0 < u32(8))
            {
            }
            else
            {
                break;
            }
            var all_1 : f32 = total_1 + partial_0[other_0 * u32(32) + _S18];
            other_0 = other_0 + u32(1);
            total_1 = all_1;
        }
        scatter_0[_S18] = total_1;
    }
    workgroupBarrier();
    var _S54 : u32 = bakes_0[_S14].clusters_0 + (_S15 * bakes_0[_S14].max_clusters_0 + _S16) * u32(36);
    if(is_finished_0 == u32(0))
    {
        if(_S18 == u32(0))
        {
            scratch_0[_S54] = (bitcast<u32>((scatter_0[i32(0)] + scatter_0[i32(2)] + scatter_0[i32(5)] + scatter_0[i32(9)] + scatter_0[i32(14)] + scatter_0[i32(20)] + scatter_0[i32(27)])));
        }
        if(_S18 < u32(7))
        {
            scratch_0[_S54 + u32(1) + _S18] = (bitcast<u32>((mean_0[_S18] / _S31)));
        }
        if(_S53)
        {
            scratch_0[_S54 + u32(1) + u32(7) + _S18] = (bitcast<u32>((scatter_0[_S18])));
        }
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    return;
}

fn keep_level_0( _S55 : i32,  _S56 : u32,  _S57 : u32,  _S58 : u32)
{
    if(is_finished_0 == u32(0))
    {
        var _S59 : u32 = bakes_0[_S55].max_clusters_0;
        var _S60 : u32 = _S56 * bakes_0[_S55].max_clusters_0;
        var _S61 : u32 = bakes_0[_S55].clusters_0 + _S60 * u32(36);
        var _S62 : u32 = _S60 + _S57 - u32(1);
        var item_0 : u32 = _S58;
        for(;;)
        {
            if(item_0 < (_S57 * u32(7)))
            {
            }
            else
            {
                break;
            }
            scratch_0[bakes_0[_S55].cluster_means_0 + _S62 * _S59 * u32(7) + item_0] = scratch_0[_S61 + item_0 / u32(7) * u32(36) + u32(1) + item_0 % u32(7)];
            item_0 = item_0 + u32(256);
        }
        if(_S58 == u32(0))
        {
            var cluster_0 : u32 = u32(0);
            var error_0 : f32 = 0.0f;
            for(;;)
            {
                if(cluster_0 < _S57)
                {
                }
                else
                {
                    break;
                }
                var error_1 : f32 = error_0 + scratch_number_0(_S61 + cluster_0 * u32(36));
                cluster_0 = cluster_0 + u32(1);
                error_0 = error_1;
            }
            scratch_0[bakes_0[_S55].cluster_errors_0 + _S62] = (bitcast<u32>((error_0)));
            scratch_0[bakes_0[_S55].facts_0 + u32(10) + _S56] = _S57;
        }
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    return;
}

@compute
@workgroup_size(256, 1, 1)
fn bake_bisect(@builtin(workgroup_id) group_0 : vec3<u32>, @builtin(local_invocation_id) thread_0 : vec3<u32>)
{
    var _S63 : u32 = group_0.x;
    var _S64 : u32 = thread_0.x;
    var _S65 : u32 = scratch_0[bakes_0[i32(0)].facts_0 + u32(4) + _S63];
    var _S66 : u32 = _S64 * u32(8);
    labels_0[_S66] = u32(0);
    var _S67 : u32 = _S66 + u32(1);
    labels_0[_S67] = u32(0);
    var _S68 : u32 = _S66 + u32(2);
    labels_0[_S68] = u32(0);
    var _S69 : u32 = _S66 + u32(3);
    labels_0[_S69] = u32(0);
    var _S70 : u32 = _S66 + u32(4);
    labels_0[_S70] = u32(0);
    var _S71 : u32 = _S66 + u32(5);
    labels_0[_S71] = u32(0);
    var _S72 : u32 = _S66 + u32(6);
    labels_0[_S72] = u32(0);
    var _S73 : u32 = _S66 + u32(7);
    labels_0[_S73] = u32(0);
    var _S74 : bool = _S64 == u32(0);
    if(_S74)
    {
        is_finished_0 = u32(0);
    }
    workgroupBarrier();
    measure_0(i32(0), _S63, u32(0), _S65, _S64);
    keep_level_0(i32(0), _S63, u32(1), _S64);
    var new_cluster_0 : u32 = u32(1);
    for(;;)
    {
        var _S75 : u32 = bakes_0[i32(0)].max_clusters_0;
        if(new_cluster_0 < (bakes_0[i32(0)].max_clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S76 : u32 = bakes_0[i32(0)].clusters_0 + _S63 * _S75 * u32(36);
        var i_1 : u32;
        if(_S74)
        {
            widest_0 = u32(0);
            i_1 = u32(1);
            for(;;)
            {
                if(i_1 < new_cluster_0)
                {
                }
                else
                {
                    break;
                }
                if((scratch_number_0(_S76 + i_1 * u32(36))) > (scratch_number_0(_S76 + widest_0 * u32(36))))
                {
                    widest_0 = i_1;
                }
                i_1 = i_1 + u32(1);
            }
        }
        workgroupBarrier();
        var _S77 : u32 = select(u32(0), widest_0, is_finished_0 == u32(0));
        var _S78 : u32 = _S76 + _S77 * u32(36);
        var _S79 : u32 = principal_axis_0(_S64, _S78);
        var along_0 : array<f32, i32(8)>;
        const _S80 : vec2<f32> = vec2<f32>(0.0f, 0.0f);
        i_1 = u32(0);
        var sums_0 : vec2<f32> = _S80;
        for(;;)
        {
            if(i_1 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S81 : u32 = _S66 + i_1;
            along_0[i_1] = 0.0f;
            if(((_S81 < _S65) & (((labels_0[_S81]) == _S77))))
            {
                var _S82 : u32 = _S78 + u32(1);
                var _S83 : f32 = along_0[i_1] + matrix_0[_S79] * (scratch_number_0(point_row_0(i32(0), _S63, _S81)) - scratch_number_0(_S82)) + matrix_0[_S79 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S63, _S81) + u32(1)) - scratch_number_0(_S82 + u32(1))) + matrix_0[_S79 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S63, _S81) + u32(2)) - scratch_number_0(_S82 + u32(2))) + matrix_0[_S79 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S63, _S81) + u32(3)) - scratch_number_0(_S82 + u32(3))) + matrix_0[_S79 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S63, _S81) + u32(4)) - scratch_number_0(_S82 + u32(4))) + matrix_0[_S79 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S63, _S81) + u32(5)) - scratch_number_0(_S82 + u32(5))) + matrix_0[_S79 + u32(6)] * (scratch_number_0(point_row_0(i32(0), _S63, _S81) + u32(6)) - scratch_number_0(_S82 + u32(6)));
                along_0[i_1] = _S83;
                sums_0 = sums_0 + vec2<f32>(1.0f, _S83);
            }
            i_1 = i_1 + u32(1);
        }
        var _S84 : vec2<f32> = sum_of_workers_0(sums_0, _S64);
        var step_1 : u32 = u32(0);
        var boundary_0 : f32 = 0.0f;
        var beyond_0 : vec2<f32> = _S80;
        for(;;)
        {
            if(step_1 <= u32(4))
            {
            }
            else
            {
                break;
            }
            var _S85 : vec2<f32> = vec2<f32>(0.0f);
            var beyond_1 : vec2<f32> = sum_of_workers_0(select_vector_0(((((_S66 < _S65) & (((labels_0[_S66]) == _S77)))) & (((along_0[u32(0)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(0)]), _S85) + select_vector_0(((((_S67 < _S65) & (((labels_0[_S67]) == _S77)))) & (((along_0[u32(1)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(1)]), _S85) + select_vector_0(((((_S68 < _S65) & (((labels_0[_S68]) == _S77)))) & (((along_0[u32(2)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(2)]), _S85) + select_vector_0(((((_S69 < _S65) & (((labels_0[_S69]) == _S77)))) & (((along_0[u32(3)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(3)]), _S85) + select_vector_0(((((_S70 < _S65) & (((labels_0[_S70]) == _S77)))) & (((along_0[u32(4)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(4)]), _S85) + select_vector_0(((((_S71 < _S65) & (((labels_0[_S71]) == _S77)))) & (((along_0[u32(5)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(5)]), _S85) + select_vector_0(((((_S72 < _S65) & (((labels_0[_S72]) == _S77)))) & (((along_0[u32(6)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(6)]), _S85) + select_vector_0(((((_S73 < _S65) & (((labels_0[_S73]) == _S77)))) & (((along_0[u32(7)]) > boundary_0))), vec2<f32>(1.0f, along_0[u32(7)]), _S85), _S64);
            var _S86 : vec2<f32> = _S84 - beyond_1;
            var _S87 : f32 = beyond_1.x;
            var _S88 : f32 = _S86.x;
            if(((((step_1 < u32(4)) & ((_S87 > 0.0f)))) & ((_S88 > 0.0f))))
            {
                boundary_0 = 0.5f * (beyond_1.y / _S87 + _S86.y / _S88);
            }
            step_1 = step_1 + u32(1);
            beyond_0 = beyond_1;
        }
        var _S89 : f32 = beyond_0.x;
        if((_S74 & ((!(((_S89 > 0.0f) & ((_S89 < (_S84.x)))))))))
        {
            is_finished_0 = u32(1);
        }
        workgroupBarrier();
        labels_0[_S66] = select(labels_0[_S66], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S66 < _S65)))) & (((labels_0[_S66]) == _S77)))) & (((along_0[u32(0)]) > boundary_0))));
        labels_0[_S67] = select(labels_0[_S67], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S67 < _S65)))) & (((labels_0[_S67]) == _S77)))) & (((along_0[u32(1)]) > boundary_0))));
        labels_0[_S68] = select(labels_0[_S68], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S68 < _S65)))) & (((labels_0[_S68]) == _S77)))) & (((along_0[u32(2)]) > boundary_0))));
        labels_0[_S69] = select(labels_0[_S69], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S69 < _S65)))) & (((labels_0[_S69]) == _S77)))) & (((along_0[u32(3)]) > boundary_0))));
        labels_0[_S70] = select(labels_0[_S70], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S70 < _S65)))) & (((labels_0[_S70]) == _S77)))) & (((along_0[u32(4)]) > boundary_0))));
        labels_0[_S71] = select(labels_0[_S71], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S71 < _S65)))) & (((labels_0[_S71]) == _S77)))) & (((along_0[u32(5)]) > boundary_0))));
        labels_0[_S72] = select(labels_0[_S72], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S72 < _S65)))) & (((labels_0[_S72]) == _S77)))) & (((along_0[u32(6)]) > boundary_0))));
        labels_0[_S73] = select(labels_0[_S73], new_cluster_0, ((((((is_finished_0 == u32(0)) & ((_S73 < _S65)))) & (((labels_0[_S73]) == _S77)))) & (((along_0[u32(7)]) > boundary_0))));
        workgroupBarrier();
        measure_0(i32(0), _S63, _S77, _S65, _S64);
        measure_0(i32(0), _S63, new_cluster_0, _S65, _S64);
        var _S90 : u32 = new_cluster_0 + u32(1);
        keep_level_0(i32(0), _S63, _S90, _S64);
        new_cluster_0 = _S90;
    }
    return;
}

fn square_0( x_0 : f32) -> f32
{
    return x_0 * x_0;
}

fn weighted_error_0( _S91 : i32,  _S92 : u32,  _S93 : u32) -> f32
{
    return scratch_number_0(bakes_0[_S91].cluster_errors_0 + _S92 * bakes_0[_S91].max_clusters_0 + (min(_S93, scratch_0[bakes_0[_S91].facts_0 + u32(10) + _S92]) - u32(1))) / f32(scratch_0[bakes_0[_S91].facts_0 + u32(4) + _S92]) * f32(scratch_0[bakes_0[_S91].facts_0 + _S92]);
}

fn best_warp_count_0( _S94 : i32,  _S95 : u32) -> u32
{
    var _S96 : u32 = bakes_0[_S94].per_family_0;
    var _S97 : u32 = u32(2) * bakes_0[_S94].per_family_0;
    var _S98 : u32 = u32(2) * _S95;
    var _S99 : u32 = bakes_0[_S94].facts_0 + u32(4) + _S98;
    var _S100 : bool;
    if(scratch_0[_S99] > u32(0))
    {
        _S100 = scratch_0[_S99 + u32(1)] > u32(0);
    }
    else
    {
        _S100 = false;
    }
    if((_S97 % u32(8)) != u32(0))
    {
        _S100 = true;
    }
    else
    {
        _S100 = !_S100;
    }
    if(_S100)
    {
        return _S96;
    }
    var least_0 : f32 = 3.00000000549775576e+38f;
    var best_0 : u32 = _S96;
    var count_0 : u32 = u32(4);
    for(;;)
    {
        if(count_0 < _S97)
        {
        }
        else
        {
            break;
        }
        var _S101 : f32 = weighted_error_0(_S94, _S98, count_0) + weighted_error_0(_S94, _S98 + u32(1), _S97 - count_0);
        var _S102 : i32 = i32(_S96);
        var _S103 : i32 = abs(i32(count_0) - _S102);
        if(_S101 < least_0)
        {
            _S100 = true;
        }
        else
        {
            if(_S101 == least_0)
            {
                _S100 = _S103 < (abs(i32(best_0) - _S102));
            }
            else
            {
                _S100 = false;
            }
        }
        if(_S100)
        {
            least_0 = _S101;
            best_0 = count_0;
        }
        count_0 = count_0 + u32(4);
    }
    return best_0;
}

@compute
@workgroup_size(256, 1, 1)
fn bake_refine(@builtin(workgroup_id) group_1 : vec3<u32>, @builtin(local_invocation_id) thread_1 : vec3<u32>)
{
    var _S104 : u32;
    var least_1 : f32;
    var nearest_0 : u32;
    var distance_0 : f32;
    var _S105 : u32 = group_1.x;
    var _S106 : u32 = _S105 / u32(2);
    var _S107 : u32 = thread_1.x;
    var _S108 : u32 = bakes_0[i32(0)].facts_0;
    var _S109 : u32 = scratch_0[bakes_0[i32(0)].facts_0 + u32(4) + _S105];
    var _S110 : u32 = best_warp_count_0(i32(0), _S106);
    var _S111 : bool = (_S105 % u32(2)) == u32(0);
    var _S112 : u32 = select(u32(2) * bakes_0[i32(0)].per_family_0 - _S110, _S110, _S111);
    var _S113 : u32 = bakes_0[i32(0)].centroids_0 + (_S106 * u32(2) * bakes_0[i32(0)].per_family_0 + select(_S110, u32(0), _S111)) * u32(7);
    var _S114 : u32 = min(_S112, scratch_0[bakes_0[i32(0)].facts_0 + u32(10) + _S105]);
    var _S115 : u32 = bakes_0[i32(0)].cluster_means_0 + (_S105 * bakes_0[i32(0)].max_clusters_0 + _S114 - u32(1)) * bakes_0[i32(0)].max_clusters_0 * u32(7);
    var item_1 : u32 = _S107;
    for(;;)
    {
        var _S116 : u32 = _S112 * u32(7);
        _S104 = _S116;
        if(item_1 < _S116)
        {
        }
        else
        {
            break;
        }
        scratch_0[_S113 + item_1] = scratch_0[_S115 + select(item_1 % u32(7), item_1, (item_1 / u32(7)) < _S114)];
        item_1 = item_1 + u32(256);
    }
    var _S117 : bool;
    if(_S107 == u32(0))
    {
        _S117 = _S111;
    }
    else
    {
        _S117 = false;
    }
    if(_S117)
    {
        scratch_0[_S108 + u32(14) + _S106] = _S110;
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    var step_2 : u32 = u32(0);
    for(;;)
    {
        if(step_2 < u32(2))
        {
        }
        else
        {
            break;
        }
        var i_2 : u32 = u32(0);
        for(;;)
        {
            if(i_2 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S118 : u32 = _S107 * u32(8) + i_2;
            least_1 = 3.00000000549775576e+38f;
            nearest_0 = u32(0);
            var cluster_1 : u32 = u32(0);
            for(;;)
            {
                if(cluster_1 < _S112)
                {
                    _S117 = _S118 < _S109;
                }
                else
                {
                    _S117 = false;
                }
                if(_S117)
                {
                }
                else
                {
                    break;
                }
                var k_2 : u32 = u32(0);
                distance_0 = 0.0f;
                for(;;)
                {
                    if(k_2 < u32(7))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var distance_1 : f32 = distance_0 + square_0(scratch_number_0(point_row_0(i32(0), _S105, _S118) + k_2) - scratch_number_0(_S113 + cluster_1 * u32(7) + k_2));
                    k_2 = k_2 + u32(1);
                    distance_0 = distance_1;
                }
                var _S119 : u32 = select(nearest_0, cluster_1, distance_0 < least_1);
                var _S120 : f32 = min(least_1, distance_0);
                var _S121 : u32 = cluster_1 + u32(1);
                least_1 = _S120;
                nearest_0 = _S119;
                cluster_1 = _S121;
            }
            labels_0[_S118] = nearest_0;
            i_2 = i_2 + u32(1);
        }
        storageBarrier(); textureBarrier(); workgroupBarrier();;
        item_1 = _S107;
        for(;;)
        {
            if(item_1 < _S104)
            {
            }
            else
            {
                break;
            }
            nearest_0 = u32(0);
            least_1 = 0.0f;
            distance_0 = 0.0f;
            for(;;)
            {
                if(nearest_0 < _S109)
                {
                }
                else
                {
                    break;
                }
                if((labels_0[nearest_0]) == (item_1 / u32(7)))
                {
                    var total_9 : f32 = distance_0 + scratch_number_0(point_row_0(i32(0), _S105, nearest_0) + item_1 % u32(7));
                    least_1 = least_1 + 1.0f;
                    distance_0 = total_9;
                }
                nearest_0 = nearest_0 + u32(1);
            }
            if(least_1 > 0.0f)
            {
                scratch_0[_S113 + item_1] = (bitcast<u32>((distance_0 / least_1)));
            }
            item_1 = item_1 + u32(256);
        }
        storageBarrier(); textureBarrier(); workgroupBarrier();;
        step_2 = step_2 + u32(1);
    }
    item_1 = _S107;
    for(;;)
    {
        if(item_1 < _S104)
        {
        }
        else
        {
            break;
        }
        var _S122 : u32 = item_1 % u32(7);
        var _S123 : f32 = select(select(0.0f, 1.0f, _S122 == u32(4)), 0.5f, _S122 == u32(2));
        var _S124 : u32 = _S113 + item_1;
        if(_S109 > u32(0))
        {
            least_1 = scratch_number_0(_S124) / 10000.0f;
        }
        else
        {
            least_1 = _S123;
        }
        scratch_0[_S124] = (bitcast<u32>((least_1)));
        item_1 = item_1 + u32(256);
    }
    return;
}

fn thread_index_0( id_0 : vec3<u32>) -> u32
{
    return id_0.y * u32(2097152) + id_0.x;
}

fn hit_normal_0( hit_0 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_0).normal_x_0, (*hit_0).normal_y_0, (*hit_0).normal_z_0);
}

fn hit_tangent_0( hit_1 : ptr<function, SurfaceHit_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*hit_1).tangent_x_0, (*hit_1).tangent_y_0, (*hit_1).tangent_z_0);
}

fn nearest_group_0( _S125 : i32,  _S126 : bool,  _S127 : bool,  _S128 : vec3<f32>,  _S129 : vec3<f32>,  _S130 : f32) -> u32
{
    var _S131 : u32 = select(u32(0), u32(1), _S126);
    var _S132 : u32 = select(scratch_0[bakes_0[_S125].facts_0 + u32(14) + _S131], u32(0), _S127);
    var _S133 : u32 = bakes_0[_S125].per_family_0;
    var _S134 : u32 = select(u32(2) * bakes_0[_S125].per_family_0, scratch_0[bakes_0[_S125].facts_0 + u32(14) + _S131], _S127);
    var least_2 : f32 = 1000.0f;
    var nearest_1 : u32 = _S132;
    var group_2 : u32 = _S132;
    for(;;)
    {
        if(group_2 < _S134)
        {
        }
        else
        {
            break;
        }
        var _S135 : u32 = bakes_0[_S125].centroids_0 + (_S131 * u32(2) * _S133 + group_2) * u32(7);
        var _S136 : vec3<f32> = vec3<f32>(0.5f) * _S128 - vec3<f32>(scratch_number_0(_S135), scratch_number_0(_S135 + u32(1)), scratch_number_0(_S135 + u32(2)));
        var _S137 : vec3<f32> = _S129 - vec3<f32>(scratch_number_0(_S135 + u32(3)), scratch_number_0(_S135 + u32(4)), scratch_number_0(_S135 + u32(5)));
        var _S138 : f32 = dot(_S136, _S136) + dot(_S137, _S137) + square_0(2.0f * _S130 - scratch_number_0(_S135 + u32(6)));
        var _S139 : u32 = select(nearest_1, group_2, _S138 < least_2);
        var _S140 : f32 = min(least_2, _S138);
        var _S141 : u32 = group_2 + u32(1);
        least_2 = _S140;
        nearest_1 = _S139;
        group_2 = _S141;
    }
    return nearest_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_assign(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S142 : u32 = thread_index_0(id_1);
    var _S143 : u32 = bakes_0[i32(0)].rays_0;
    if(_S142 >= (u32(512) * bakes_0[i32(0)].rays_0))
    {
        return;
    }
    var _S144 : SurfaceHit_std430_0 = hits_0[_S142];
    var _S145 : u32 = _S144.flags_0;
    if((((_S144.flags_0) & (u32(10)))) != u32(0))
    {
        return;
    }
    var _S146 : bool = _S142 >= (u32(256) * _S143);
    var _S147 : bool = ((_S145 & (u32(1)))) != u32(0);
    var _S148 : vec3<f32> = hit_normal_0(&(_S144));
    var _S149 : vec3<f32> = hit_tangent_0(&(_S144));
    hits_0[_S142].flags_0 = (_S145 | ((((nearest_group_0(i32(0), _S146, _S147, _S148, _S149, _S144.shown_share_0) + u32(1)) << (u32(8))))));
    return;
}

