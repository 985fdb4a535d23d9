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
    @align(4) row_totals_0 : u32,
    @align(4) row_largest_0 : u32,
    @align(4) coverage_means_0 : u32,
    @align(4) coverage_scales_0 : u32,
    @align(4) hole_bytes_0 : u32,
};

@binding(15) @group(0) var<storage, read> bakes_0 : array<Bake_std430_0>;

@binding(18) @group(0) var<storage, read_write> scratch_0 : array<u32>;

struct SurfaceHit_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) flags_0 : u32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) tangent_x_0 : f32,
    @align(4) tangent_y_0 : f32,
    @align(4) tangent_z_0 : f32,
};

@binding(17) @group(0) var<storage, read_write> hits_0 : array<SurfaceHit_std430_0>;

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
        if(k_0 < u32(6))
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

var<workgroup> scatter_0 : array<f32, i32(21)>;

var<workgroup> widest_0 : u32;

var<workgroup> matrix_0 : array<f32, i32(36)>;

var<workgroup> squared_0 : array<f32, i32(36)>;

fn principal_axis_0( worker_0 : u32,  row_0 : u32) -> u32
{
    var _S4 : u32 = min(worker_0, u32(35));
    var _S5 : u32 = _S4 % u32(6);
    var _S6 : u32 = max(_S4 / u32(6), _S5);
    var _S7 : u32 = min(_S4 / u32(6), _S5);
    var _S8 : bool = worker_0 < u32(36);
    if(_S8)
    {
        matrix_0[worker_0] = scratch_number_0(row_0 + u32(7) + _S6 * (_S6 + u32(1)) / u32(2) + _S7);
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
        var _S9 : f32 = matrix_0[i32(0)] + matrix_0[i32(7)] + matrix_0[i32(14)] + matrix_0[i32(21)] + matrix_0[i32(28)] + matrix_0[i32(35)] + 1.00000000317107685e-30f;
        var total_0 : f32 = matrix_0[_S4 / u32(6) * u32(6)] / _S9 * (matrix_0[_S5] / _S9) + matrix_0[_S4 / u32(6) * u32(6) + u32(1)] / _S9 * (matrix_0[u32(6) + _S5] / _S9) + matrix_0[_S4 / u32(6) * u32(6) + u32(2)] / _S9 * (matrix_0[u32(12) + _S5] / _S9) + matrix_0[_S4 / u32(6) * u32(6) + u32(3)] / _S9 * (matrix_0[u32(18) + _S5] / _S9) + matrix_0[_S4 / u32(6) * u32(6) + u32(4)] / _S9 * (matrix_0[u32(24) + _S5] / _S9) + matrix_0[_S4 / u32(6) * u32(6) + u32(5)] / _S9 * (matrix_0[u32(30) + _S5] / _S9);
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
        if(k_1 < u32(6))
        {
        }
        else
        {
            break;
        }
        if((matrix_0[u32(7) * k_1]) > (matrix_0[u32(7) * largest_0]))
        {
            step_0 = k_1;
        }
        else
        {
            step_0 = largest_0;
        }
        k_1 = k_1 + u32(1);
        largest_0 = step_0;
    }
    return u32(6) * largest_0;
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
    return bakes_0[_S11].points_0 + (_S12 * u32(2048) + _S13) * u32(6);
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
    var _S19 : bool;
    var _S20 : bool;
    var _S21 : bool;
    var _S22 : bool;
    var _S23 : bool;
    var _S24 : bool;
    var _S25 : bool;
    var _S26 : bool;
    var _S27 : u32 = _S18 / u32(32);
    var _S28 : u32 = _S18 % u32(32);
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
        var _S29 : u32 = _S27 * u32(256) + i_0;
        if(_S29 < _S17)
        {
            _S19 = (labels_0[_S29]) == _S16;
        }
        else
        {
            _S19 = false;
        }
        if(_S19)
        {
            _S20 = _S28 <= u32(6);
        }
        else
        {
            _S20 = false;
        }
        if(_S20)
        {
            if(_S28 == u32(6))
            {
                total_1 = 1.0f;
            }
            else
            {
                total_1 = scratch_number_0(point_row_0(_S14, _S15, _S29) + min(_S28, u32(5)));
            }
            total_1 = total_8 + total_1;
        }
        else
        {
            total_1 = total_8;
        }
        var _S30 : u32 = _S29 + u32(1);
        if(_S30 < _S17)
        {
            _S21 = (labels_0[_S30]) == _S16;
        }
        else
        {
            _S21 = false;
        }
        if(_S21)
        {
            _S22 = _S28 <= u32(6);
        }
        else
        {
            _S22 = false;
        }
        if(_S22)
        {
            if(_S28 == u32(6))
            {
                total_2 = 1.0f;
            }
            else
            {
                total_2 = scratch_number_0(point_row_0(_S14, _S15, _S30) + min(_S28, u32(5)));
            }
            total_2 = total_1 + total_2;
        }
        else
        {
            total_2 = total_1;
        }
        var _S31 : u32 = _S29 + u32(2);
        if(_S31 < _S17)
        {
            _S23 = (labels_0[_S31]) == _S16;
        }
        else
        {
            _S23 = false;
        }
        if(_S23)
        {
            _S24 = _S28 <= u32(6);
        }
        else
        {
            _S24 = false;
        }
        if(_S24)
        {
            if(_S28 == u32(6))
            {
                total_3 = 1.0f;
            }
            else
            {
                total_3 = scratch_number_0(point_row_0(_S14, _S15, _S31) + min(_S28, u32(5)));
            }
            total_3 = total_2 + total_3;
        }
        else
        {
            total_3 = total_2;
        }
        var _S32 : u32 = _S29 + u32(3);
        if(_S32 < _S17)
        {
            _S25 = (labels_0[_S32]) == _S16;
        }
        else
        {
            _S25 = false;
        }
        if(_S25)
        {
            _S26 = _S28 <= u32(6);
        }
        else
        {
            _S26 = false;
        }
        if(_S26)
        {
            if(_S28 == u32(6))
            {
                total_4 = 1.0f;
            }
            else
            {
                total_4 = scratch_number_0(point_row_0(_S14, _S15, _S32) + min(_S28, u32(5)));
            }
            total_4 = total_3 + total_4;
        }
        else
        {
            total_4 = total_3;
        }
        var _S33 : u32 = _S29 + u32(4);
        var _S34 : bool;
        if(_S33 < _S17)
        {
            _S34 = (labels_0[_S33]) == _S16;
        }
        else
        {
            _S34 = false;
        }
        var _S35 : bool;
        if(_S34)
        {
            _S35 = _S28 <= u32(6);
        }
        else
        {
            _S35 = false;
        }
        if(_S35)
        {
            if(_S28 == u32(6))
            {
                total_5 = 1.0f;
            }
            else
            {
                total_5 = scratch_number_0(point_row_0(_S14, _S15, _S33) + min(_S28, u32(5)));
            }
            total_5 = total_4 + total_5;
        }
        else
        {
            total_5 = total_4;
        }
        var _S36 : u32 = _S29 + u32(5);
        var _S37 : bool;
        if(_S36 < _S17)
        {
            _S37 = (labels_0[_S36]) == _S16;
        }
        else
        {
            _S37 = false;
        }
        var _S38 : bool;
        if(_S37)
        {
            _S38 = _S28 <= u32(6);
        }
        else
        {
            _S38 = false;
        }
        if(_S38)
        {
            if(_S28 == u32(6))
            {
                total_6 = 1.0f;
            }
            else
            {
                total_6 = scratch_number_0(point_row_0(_S14, _S15, _S36) + min(_S28, u32(5)));
            }
            total_6 = total_5 + total_6;
        }
        else
        {
            total_6 = total_5;
        }
        var _S39 : u32 = _S29 + u32(6);
        var _S40 : bool;
        if(_S39 < _S17)
        {
            _S40 = (labels_0[_S39]) == _S16;
        }
        else
        {
            _S40 = false;
        }
        var _S41 : bool;
        if(_S40)
        {
            _S41 = _S28 <= u32(6);
        }
        else
        {
            _S41 = false;
        }
        if(_S41)
        {
            if(_S28 == u32(6))
            {
                total_7 = 1.0f;
            }
            else
            {
                total_7 = scratch_number_0(point_row_0(_S14, _S15, _S39) + min(_S28, u32(5)));
            }
            total_7 = total_6 + total_7;
        }
        else
        {
            total_7 = total_6;
        }
        var _S42 : u32 = _S29 + u32(7);
        var _S43 : bool;
        if(_S42 < _S17)
        {
            _S43 = (labels_0[_S42]) == _S16;
        }
        else
        {
            _S43 = false;
        }
        var _S44 : bool;
        if(_S43)
        {
            _S44 = _S28 <= u32(6);
        }
        else
        {
            _S44 = false;
        }
        if(_S44)
        {
            var _S45 : f32;
            if(_S28 == u32(6))
            {
                _S45 = 1.0f;
            }
            else
            {
                _S45 = scratch_number_0(point_row_0(_S14, _S15, _S42) + min(_S28, u32(5)));
            }
            total_8 = total_7 + _S45;
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
    if(_S18 < u32(7))
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
    var _S46 : f32 = max(mean_0[u32(6)], 1.0f);
    var _S47 : vec2<u32> = features_of_pair_0(min(_S28, u32(20)));
    var _S48 : u32 = _S47.x;
    var _S49 : f32 = mean_0[_S48] / _S46;
    var _S50 : u32 = _S47.y;
    var _S51 : f32 = mean_0[_S50] / _S46;
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
        var _S52 : u32 = _S27 * u32(256) + i_0;
        var _S53 : u32 = point_row_0(_S14, _S15, _S52);
        if(_S52 < _S17)
        {
            _S19 = (labels_0[_S52]) == _S16;
        }
        else
        {
            _S19 = false;
        }
        if(_S19)
        {
            total_1 = total_8 + (scratch_number_0(_S53 + _S48) - _S49) * (scratch_number_0(_S53 + _S50) - _S51);
        }
        else
        {
            total_1 = total_8;
        }
        var _S54 : u32 = _S52 + u32(1);
        var _S55 : u32 = point_row_0(_S14, _S15, _S54);
        if(_S54 < _S17)
        {
            _S20 = (labels_0[_S54]) == _S16;
        }
        else
        {
            _S20 = false;
        }
        if(_S20)
        {
            total_2 = total_1 + (scratch_number_0(_S55 + _S48) - _S49) * (scratch_number_0(_S55 + _S50) - _S51);
        }
        else
        {
            total_2 = total_1;
        }
        var _S56 : u32 = _S52 + u32(2);
        var _S57 : u32 = point_row_0(_S14, _S15, _S56);
        if(_S56 < _S17)
        {
            _S21 = (labels_0[_S56]) == _S16;
        }
        else
        {
            _S21 = false;
        }
        if(_S21)
        {
            total_3 = total_2 + (scratch_number_0(_S57 + _S48) - _S49) * (scratch_number_0(_S57 + _S50) - _S51);
        }
        else
        {
            total_3 = total_2;
        }
        var _S58 : u32 = _S52 + u32(3);
        var _S59 : u32 = point_row_0(_S14, _S15, _S58);
        if(_S58 < _S17)
        {
            _S22 = (labels_0[_S58]) == _S16;
        }
        else
        {
            _S22 = false;
        }
        if(_S22)
        {
            total_4 = total_3 + (scratch_number_0(_S59 + _S48) - _S49) * (scratch_number_0(_S59 + _S50) - _S51);
        }
        else
        {
            total_4 = total_3;
        }
        var _S60 : u32 = _S52 + u32(4);
        var _S61 : u32 = point_row_0(_S14, _S15, _S60);
        if(_S60 < _S17)
        {
            _S23 = (labels_0[_S60]) == _S16;
        }
        else
        {
            _S23 = false;
        }
        if(_S23)
        {
            total_5 = total_4 + (scratch_number_0(_S61 + _S48) - _S49) * (scratch_number_0(_S61 + _S50) - _S51);
        }
        else
        {
            total_5 = total_4;
        }
        var _S62 : u32 = _S52 + u32(5);
        var _S63 : u32 = point_row_0(_S14, _S15, _S62);
        if(_S62 < _S17)
        {
            _S24 = (labels_0[_S62]) == _S16;
        }
        else
        {
            _S24 = false;
        }
        if(_S24)
        {
            total_6 = total_5 + (scratch_number_0(_S63 + _S48) - _S49) * (scratch_number_0(_S63 + _S50) - _S51);
        }
        else
        {
            total_6 = total_5;
        }
        var _S64 : u32 = _S52 + u32(6);
        var _S65 : u32 = point_row_0(_S14, _S15, _S64);
        if(_S64 < _S17)
        {
            _S25 = (labels_0[_S64]) == _S16;
        }
        else
        {
            _S25 = false;
        }
        if(_S25)
        {
            total_7 = total_6 + (scratch_number_0(_S65 + _S48) - _S49) * (scratch_number_0(_S65 + _S50) - _S51);
        }
        else
        {
            total_7 = total_6;
        }
        var _S66 : u32 = _S52 + u32(7);
        var _S67 : u32 = point_row_0(_S14, _S15, _S66);
        if(_S66 < _S17)
        {
            _S26 = (labels_0[_S66]) == _S16;
        }
        else
        {
            _S26 = false;
        }
        if(_S26)
        {
            total_8 = total_7 + (scratch_number_0(_S67 + _S48) - _S49) * (scratch_number_0(_S67 + _S50) - _S51);
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
    var _S68 : bool = _S18 < u32(21);
    if(_S68)
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
    var _S69 : u32 = bakes_0[_S14].clusters_0 + (_S15 * bakes_0[_S14].max_clusters_0 + _S16) * u32(32);
    if(is_finished_0 == u32(0))
    {
        if(_S18 == u32(0))
        {
            scratch_0[_S69] = (bitcast<u32>((scatter_0[i32(0)] + scatter_0[i32(2)] + scatter_0[i32(5)] + scatter_0[i32(9)] + scatter_0[i32(14)] + scatter_0[i32(20)])));
        }
        if(_S18 < u32(6))
        {
            scratch_0[_S69 + u32(1) + _S18] = (bitcast<u32>((mean_0[_S18] / _S46)));
        }
        if(_S68)
        {
            scratch_0[_S69 + u32(7) + _S18] = (bitcast<u32>((scatter_0[_S18])));
        }
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    return;
}

fn keep_level_0( _S70 : i32,  _S71 : u32,  _S72 : u32,  _S73 : u32)
{
    if(is_finished_0 == u32(0))
    {
        var _S74 : u32 = bakes_0[_S70].max_clusters_0;
        var _S75 : u32 = _S71 * bakes_0[_S70].max_clusters_0;
        var _S76 : u32 = bakes_0[_S70].clusters_0 + _S75 * u32(32);
        var _S77 : u32 = _S75 + _S72 - u32(1);
        var item_0 : u32 = _S73;
        for(;;)
        {
            if(item_0 < (_S72 * u32(6)))
            {
            }
            else
            {
                break;
            }
            scratch_0[bakes_0[_S70].cluster_means_0 + _S77 * _S74 * u32(6) + item_0] = scratch_0[_S76 + item_0 / u32(6) * u32(32) + u32(1) + item_0 % u32(6)];
            item_0 = item_0 + u32(256);
        }
        if(_S73 == u32(0))
        {
            var cluster_0 : u32 = u32(0);
            var error_0 : f32 = 0.0f;
            for(;;)
            {
                if(cluster_0 < _S72)
                {
                }
                else
                {
                    break;
                }
                var error_1 : f32 = error_0 + scratch_number_0(_S76 + cluster_0 * u32(32));
                cluster_0 = cluster_0 + u32(1);
                error_0 = error_1;
            }
            scratch_0[bakes_0[_S70].cluster_errors_0 + _S77] = (bitcast<u32>((error_0)));
            scratch_0[bakes_0[_S70].facts_0 + u32(10) + _S71] = _S72;
        }
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    return;
}

@compute
@workgroup_size(256, 1, 1)
fn bake_bisect(@builtin(workgroup_id) group_0 : vec3<u32>, @builtin(local_invocation_id) thread_0 : vec3<u32>)
{
    var _S78 : bool;
    var _S79 : bool;
    var _S80 : bool;
    var _S81 : bool;
    var _S82 : bool;
    var _S83 : bool;
    var _S84 : bool;
    var _S85 : bool;
    var _S86 : bool;
    var _S87 : bool;
    var _S88 : bool;
    var _S89 : bool;
    var _S90 : bool;
    var _S91 : bool;
    var _S92 : bool;
    var _S93 : bool;
    var _S94 : bool;
    var _S95 : bool;
    var _S96 : u32 = group_0.x;
    var _S97 : u32 = thread_0.x;
    var _S98 : u32 = scratch_0[bakes_0[i32(0)].facts_0 + u32(4) + _S96];
    var _S99 : u32 = _S97 * u32(8);
    labels_0[_S99] = u32(0);
    var _S100 : u32 = _S99 + u32(1);
    labels_0[_S100] = u32(0);
    var _S101 : u32 = _S99 + u32(2);
    labels_0[_S101] = u32(0);
    var _S102 : u32 = _S99 + u32(3);
    labels_0[_S102] = u32(0);
    var _S103 : u32 = _S99 + u32(4);
    labels_0[_S103] = u32(0);
    var _S104 : u32 = _S99 + u32(5);
    labels_0[_S104] = u32(0);
    var _S105 : u32 = _S99 + u32(6);
    labels_0[_S105] = u32(0);
    var _S106 : u32 = _S99 + u32(7);
    labels_0[_S106] = u32(0);
    var _S107 : bool = _S97 == u32(0);
    if(_S107)
    {
        is_finished_0 = u32(0);
    }
    workgroupBarrier();
    measure_0(i32(0), _S96, u32(0), _S98, _S97);
    keep_level_0(i32(0), _S96, u32(1), _S97);
    var new_cluster_0 : u32 = u32(1);
    for(;;)
    {
        var _S108 : u32 = bakes_0[i32(0)].max_clusters_0;
        if(new_cluster_0 < (bakes_0[i32(0)].max_clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S109 : u32 = bakes_0[i32(0)].clusters_0 + _S96 * _S108 * u32(32);
        var cluster_1 : u32;
        if(_S107)
        {
            widest_0 = u32(0);
            cluster_1 = u32(1);
            for(;;)
            {
                if(cluster_1 < new_cluster_0)
                {
                }
                else
                {
                    break;
                }
                if((scratch_number_0(_S109 + cluster_1 * u32(32))) > (scratch_number_0(_S109 + widest_0 * u32(32))))
                {
                    widest_0 = cluster_1;
                }
                cluster_1 = cluster_1 + u32(1);
            }
        }
        workgroupBarrier();
        if(is_finished_0 == u32(0))
        {
            cluster_1 = widest_0;
        }
        else
        {
            cluster_1 = u32(0);
        }
        var _S110 : u32 = _S109 + cluster_1 * u32(32);
        var _S111 : u32 = principal_axis_0(_S97, _S110);
        var along_0 : array<f32, i32(8)>;
        const _S112 : vec2<f32> = vec2<f32>(0.0f, 0.0f);
        along_0[u32(0)] = 0.0f;
        var _S113 : bool = _S99 < _S98;
        var _S114 : bool;
        if(_S113)
        {
            _S114 = (labels_0[_S99]) == cluster_1;
        }
        else
        {
            _S114 = false;
        }
        var sums_0 : vec2<f32>;
        if(_S114)
        {
            var _S115 : u32 = _S110 + u32(1);
            var _S116 : f32 = along_0[u32(0)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S99)) - scratch_number_0(_S115)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S99) + u32(1)) - scratch_number_0(_S115 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S99) + u32(2)) - scratch_number_0(_S115 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S99) + u32(3)) - scratch_number_0(_S115 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S99) + u32(4)) - scratch_number_0(_S115 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S99) + u32(5)) - scratch_number_0(_S115 + u32(5)));
            along_0[u32(0)] = _S116;
            sums_0 = vec2<f32>(1.0f, _S116);
        }
        else
        {
            sums_0 = _S112;
        }
        along_0[u32(1)] = 0.0f;
        var _S117 : bool = _S100 < _S98;
        var _S118 : bool;
        if(_S117)
        {
            _S118 = (labels_0[_S100]) == cluster_1;
        }
        else
        {
            _S118 = false;
        }
        var sums_1 : vec2<f32>;
        if(_S118)
        {
            var _S119 : u32 = _S110 + u32(1);
            var _S120 : f32 = along_0[u32(1)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S100)) - scratch_number_0(_S119)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S100) + u32(1)) - scratch_number_0(_S119 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S100) + u32(2)) - scratch_number_0(_S119 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S100) + u32(3)) - scratch_number_0(_S119 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S100) + u32(4)) - scratch_number_0(_S119 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S100) + u32(5)) - scratch_number_0(_S119 + u32(5)));
            along_0[u32(1)] = _S120;
            sums_1 = sums_0 + vec2<f32>(1.0f, _S120);
        }
        else
        {
            sums_1 = sums_0;
        }
        along_0[u32(2)] = 0.0f;
        var _S121 : bool = _S101 < _S98;
        var _S122 : bool;
        if(_S121)
        {
            _S122 = (labels_0[_S101]) == cluster_1;
        }
        else
        {
            _S122 = false;
        }
        var sums_2 : vec2<f32>;
        if(_S122)
        {
            var _S123 : u32 = _S110 + u32(1);
            var _S124 : f32 = along_0[u32(2)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S101)) - scratch_number_0(_S123)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S101) + u32(1)) - scratch_number_0(_S123 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S101) + u32(2)) - scratch_number_0(_S123 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S101) + u32(3)) - scratch_number_0(_S123 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S101) + u32(4)) - scratch_number_0(_S123 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S101) + u32(5)) - scratch_number_0(_S123 + u32(5)));
            along_0[u32(2)] = _S124;
            sums_2 = sums_1 + vec2<f32>(1.0f, _S124);
        }
        else
        {
            sums_2 = sums_1;
        }
        along_0[u32(3)] = 0.0f;
        var _S125 : bool = _S102 < _S98;
        var _S126 : bool;
        if(_S125)
        {
            _S126 = (labels_0[_S102]) == cluster_1;
        }
        else
        {
            _S126 = false;
        }
        var sums_3 : vec2<f32>;
        if(_S126)
        {
            var _S127 : u32 = _S110 + u32(1);
            var _S128 : f32 = along_0[u32(3)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S102)) - scratch_number_0(_S127)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S102) + u32(1)) - scratch_number_0(_S127 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S102) + u32(2)) - scratch_number_0(_S127 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S102) + u32(3)) - scratch_number_0(_S127 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S102) + u32(4)) - scratch_number_0(_S127 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S102) + u32(5)) - scratch_number_0(_S127 + u32(5)));
            along_0[u32(3)] = _S128;
            sums_3 = sums_2 + vec2<f32>(1.0f, _S128);
        }
        else
        {
            sums_3 = sums_2;
        }
        along_0[u32(4)] = 0.0f;
        var _S129 : bool = _S103 < _S98;
        var _S130 : bool;
        if(_S129)
        {
            _S130 = (labels_0[_S103]) == cluster_1;
        }
        else
        {
            _S130 = false;
        }
        var sums_4 : vec2<f32>;
        if(_S130)
        {
            var _S131 : u32 = _S110 + u32(1);
            var _S132 : f32 = along_0[u32(4)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S103)) - scratch_number_0(_S131)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S103) + u32(1)) - scratch_number_0(_S131 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S103) + u32(2)) - scratch_number_0(_S131 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S103) + u32(3)) - scratch_number_0(_S131 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S103) + u32(4)) - scratch_number_0(_S131 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S103) + u32(5)) - scratch_number_0(_S131 + u32(5)));
            along_0[u32(4)] = _S132;
            sums_4 = sums_3 + vec2<f32>(1.0f, _S132);
        }
        else
        {
            sums_4 = sums_3;
        }
        along_0[u32(5)] = 0.0f;
        var _S133 : bool = _S104 < _S98;
        var _S134 : bool;
        if(_S133)
        {
            _S134 = (labels_0[_S104]) == cluster_1;
        }
        else
        {
            _S134 = false;
        }
        var sums_5 : vec2<f32>;
        if(_S134)
        {
            var _S135 : u32 = _S110 + u32(1);
            var _S136 : f32 = along_0[u32(5)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S104)) - scratch_number_0(_S135)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S104) + u32(1)) - scratch_number_0(_S135 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S104) + u32(2)) - scratch_number_0(_S135 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S104) + u32(3)) - scratch_number_0(_S135 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S104) + u32(4)) - scratch_number_0(_S135 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S104) + u32(5)) - scratch_number_0(_S135 + u32(5)));
            along_0[u32(5)] = _S136;
            sums_5 = sums_4 + vec2<f32>(1.0f, _S136);
        }
        else
        {
            sums_5 = sums_4;
        }
        along_0[u32(6)] = 0.0f;
        var _S137 : bool = _S105 < _S98;
        var _S138 : bool;
        if(_S137)
        {
            _S138 = (labels_0[_S105]) == cluster_1;
        }
        else
        {
            _S138 = false;
        }
        var sums_6 : vec2<f32>;
        if(_S138)
        {
            var _S139 : u32 = _S110 + u32(1);
            var _S140 : f32 = along_0[u32(6)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S105)) - scratch_number_0(_S139)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S105) + u32(1)) - scratch_number_0(_S139 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S105) + u32(2)) - scratch_number_0(_S139 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S105) + u32(3)) - scratch_number_0(_S139 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S105) + u32(4)) - scratch_number_0(_S139 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S105) + u32(5)) - scratch_number_0(_S139 + u32(5)));
            along_0[u32(6)] = _S140;
            sums_6 = sums_5 + vec2<f32>(1.0f, _S140);
        }
        else
        {
            sums_6 = sums_5;
        }
        along_0[u32(7)] = 0.0f;
        var _S141 : bool = _S106 < _S98;
        var _S142 : bool;
        if(_S141)
        {
            _S142 = (labels_0[_S106]) == cluster_1;
        }
        else
        {
            _S142 = false;
        }
        var sums_7 : vec2<f32>;
        if(_S142)
        {
            var _S143 : u32 = _S110 + u32(1);
            var _S144 : f32 = along_0[u32(7)] + matrix_0[_S111] * (scratch_number_0(point_row_0(i32(0), _S96, _S106)) - scratch_number_0(_S143)) + matrix_0[_S111 + u32(1)] * (scratch_number_0(point_row_0(i32(0), _S96, _S106) + u32(1)) - scratch_number_0(_S143 + u32(1))) + matrix_0[_S111 + u32(2)] * (scratch_number_0(point_row_0(i32(0), _S96, _S106) + u32(2)) - scratch_number_0(_S143 + u32(2))) + matrix_0[_S111 + u32(3)] * (scratch_number_0(point_row_0(i32(0), _S96, _S106) + u32(3)) - scratch_number_0(_S143 + u32(3))) + matrix_0[_S111 + u32(4)] * (scratch_number_0(point_row_0(i32(0), _S96, _S106) + u32(4)) - scratch_number_0(_S143 + u32(4))) + matrix_0[_S111 + u32(5)] * (scratch_number_0(point_row_0(i32(0), _S96, _S106) + u32(5)) - scratch_number_0(_S143 + u32(5)));
            along_0[u32(7)] = _S144;
            sums_7 = sums_6 + vec2<f32>(1.0f, _S144);
        }
        else
        {
            sums_7 = sums_6;
        }
        var _S145 : vec2<f32> = sum_of_workers_0(sums_7, _S97);
        var step_1 : u32 = u32(0);
        var boundary_0 : f32 = 0.0f;
        var beyond_0 : vec2<f32> = _S112;
        for(;;)
        {
            if(step_1 <= u32(4))
            {
            }
            else
            {
                break;
            }
            if(_S113)
            {
                _S78 = (labels_0[_S99]) == cluster_1;
            }
            else
            {
                _S78 = false;
            }
            if(_S78)
            {
                _S79 = (along_0[u32(0)]) > boundary_0;
            }
            else
            {
                _S79 = false;
            }
            var sums_8 : vec2<f32>;
            if(_S79)
            {
                sums_8 = vec2<f32>(1.0f, along_0[u32(0)]);
            }
            else
            {
                sums_8 = _S112;
            }
            if(_S117)
            {
                _S80 = (labels_0[_S100]) == cluster_1;
            }
            else
            {
                _S80 = false;
            }
            if(_S80)
            {
                _S81 = (along_0[u32(1)]) > boundary_0;
            }
            else
            {
                _S81 = false;
            }
            var sums_9 : vec2<f32>;
            if(_S81)
            {
                sums_9 = sums_8 + vec2<f32>(1.0f, along_0[u32(1)]);
            }
            else
            {
                sums_9 = sums_8;
            }
            if(_S121)
            {
                _S82 = (labels_0[_S101]) == cluster_1;
            }
            else
            {
                _S82 = false;
            }
            if(_S82)
            {
                _S83 = (along_0[u32(2)]) > boundary_0;
            }
            else
            {
                _S83 = false;
            }
            var sums_10 : vec2<f32>;
            if(_S83)
            {
                sums_10 = sums_9 + vec2<f32>(1.0f, along_0[u32(2)]);
            }
            else
            {
                sums_10 = sums_9;
            }
            if(_S125)
            {
                _S84 = (labels_0[_S102]) == cluster_1;
            }
            else
            {
                _S84 = false;
            }
            if(_S84)
            {
                _S85 = (along_0[u32(3)]) > boundary_0;
            }
            else
            {
                _S85 = false;
            }
            var sums_11 : vec2<f32>;
            if(_S85)
            {
                sums_11 = sums_10 + vec2<f32>(1.0f, along_0[u32(3)]);
            }
            else
            {
                sums_11 = sums_10;
            }
            if(_S129)
            {
                _S86 = (labels_0[_S103]) == cluster_1;
            }
            else
            {
                _S86 = false;
            }
            if(_S86)
            {
                _S87 = (along_0[u32(4)]) > boundary_0;
            }
            else
            {
                _S87 = false;
            }
            var sums_12 : vec2<f32>;
            if(_S87)
            {
                sums_12 = sums_11 + vec2<f32>(1.0f, along_0[u32(4)]);
            }
            else
            {
                sums_12 = sums_11;
            }
            if(_S133)
            {
                _S88 = (labels_0[_S104]) == cluster_1;
            }
            else
            {
                _S88 = false;
            }
            if(_S88)
            {
                _S89 = (along_0[u32(5)]) > boundary_0;
            }
            else
            {
                _S89 = false;
            }
            var sums_13 : vec2<f32>;
            if(_S89)
            {
                sums_13 = sums_12 + vec2<f32>(1.0f, along_0[u32(5)]);
            }
            else
            {
                sums_13 = sums_12;
            }
            if(_S137)
            {
                _S90 = (labels_0[_S105]) == cluster_1;
            }
            else
            {
                _S90 = false;
            }
            if(_S90)
            {
                _S91 = (along_0[u32(6)]) > boundary_0;
            }
            else
            {
                _S91 = false;
            }
            var sums_14 : vec2<f32>;
            if(_S91)
            {
                sums_14 = sums_13 + vec2<f32>(1.0f, along_0[u32(6)]);
            }
            else
            {
                sums_14 = sums_13;
            }
            if(_S141)
            {
                _S92 = (labels_0[_S106]) == cluster_1;
            }
            else
            {
                _S92 = false;
            }
            if(_S92)
            {
                _S93 = (along_0[u32(7)]) > boundary_0;
            }
            else
            {
                _S93 = false;
            }
            var sums_15 : vec2<f32>;
            if(_S93)
            {
                sums_15 = sums_14 + vec2<f32>(1.0f, along_0[u32(7)]);
            }
            else
            {
                sums_15 = sums_14;
            }
            var beyond_1 : vec2<f32> = sum_of_workers_0(sums_15, _S97);
            var _S146 : vec2<f32> = _S145 - beyond_1;
            if(step_1 < u32(4))
            {
                _S94 = (beyond_1.x) > 0.0f;
            }
            else
            {
                _S94 = false;
            }
            if(_S94)
            {
                _S95 = (_S146.x) > 0.0f;
            }
            else
            {
                _S95 = false;
            }
            if(_S95)
            {
                boundary_0 = 0.5f * (beyond_1.y / beyond_1.x + _S146.y / _S146.x);
            }
            step_1 = step_1 + u32(1);
            beyond_0 = beyond_1;
        }
        if(_S107)
        {
            var _S147 : f32 = beyond_0.x;
            if(_S147 > 0.0f)
            {
                _S78 = _S147 < (_S145.x);
            }
            else
            {
                _S78 = false;
            }
            _S78 = !_S78;
        }
        else
        {
            _S78 = false;
        }
        if(_S78)
        {
            is_finished_0 = u32(1);
        }
        workgroupBarrier();
        if(is_finished_0 == u32(0))
        {
            _S79 = _S113;
        }
        else
        {
            _S79 = false;
        }
        if(_S79)
        {
            _S80 = (labels_0[_S99]) == cluster_1;
        }
        else
        {
            _S80 = false;
        }
        if(_S80)
        {
            _S81 = (along_0[u32(0)]) > boundary_0;
        }
        else
        {
            _S81 = false;
        }
        if(_S81)
        {
            labels_0[_S99] = new_cluster_0;
        }
        if(is_finished_0 == u32(0))
        {
            _S82 = _S117;
        }
        else
        {
            _S82 = false;
        }
        if(_S82)
        {
            _S83 = (labels_0[_S100]) == cluster_1;
        }
        else
        {
            _S83 = false;
        }
        if(_S83)
        {
            _S84 = (along_0[u32(1)]) > boundary_0;
        }
        else
        {
            _S84 = false;
        }
        if(_S84)
        {
            labels_0[_S100] = new_cluster_0;
        }
        if(is_finished_0 == u32(0))
        {
            _S85 = _S121;
        }
        else
        {
            _S85 = false;
        }
        if(_S85)
        {
            _S86 = (labels_0[_S101]) == cluster_1;
        }
        else
        {
            _S86 = false;
        }
        if(_S86)
        {
            _S87 = (along_0[u32(2)]) > boundary_0;
        }
        else
        {
            _S87 = false;
        }
        if(_S87)
        {
            labels_0[_S101] = new_cluster_0;
        }
        if(is_finished_0 == u32(0))
        {
            _S88 = _S125;
        }
        else
        {
            _S88 = false;
        }
        if(_S88)
        {
            _S89 = (labels_0[_S102]) == cluster_1;
        }
        else
        {
            _S89 = false;
        }
        if(_S89)
        {
            _S90 = (along_0[u32(3)]) > boundary_0;
        }
        else
        {
            _S90 = false;
        }
        if(_S90)
        {
            labels_0[_S102] = new_cluster_0;
        }
        if(is_finished_0 == u32(0))
        {
            _S91 = _S129;
        }
        else
        {
            _S91 = false;
        }
        if(_S91)
        {
            _S92 = (labels_0[_S103]) == cluster_1;
        }
        else
        {
            _S92 = false;
        }
        if(_S92)
        {
            _S93 = (along_0[u32(4)]) > boundary_0;
        }
        else
        {
            _S93 = false;
        }
        if(_S93)
        {
            labels_0[_S103] = new_cluster_0;
        }
        if(is_finished_0 == u32(0))
        {
            _S94 = _S133;
        }
        else
        {
            _S94 = false;
        }
        if(_S94)
        {
            _S95 = (labels_0[_S104]) == cluster_1;
        }
        else
        {
            _S95 = false;
        }
        var _S148 : bool;
        if(_S95)
        {
            _S148 = (along_0[u32(5)]) > boundary_0;
        }
        else
        {
            _S148 = false;
        }
        if(_S148)
        {
            labels_0[_S104] = new_cluster_0;
        }
        var _S149 : bool;
        if(is_finished_0 == u32(0))
        {
            _S149 = _S137;
        }
        else
        {
            _S149 = false;
        }
        var _S150 : bool;
        if(_S149)
        {
            _S150 = (labels_0[_S105]) == cluster_1;
        }
        else
        {
            _S150 = false;
        }
        var _S151 : bool;
        if(_S150)
        {
            _S151 = (along_0[u32(6)]) > boundary_0;
        }
        else
        {
            _S151 = false;
        }
        if(_S151)
        {
            labels_0[_S105] = new_cluster_0;
        }
        var _S152 : bool;
        if(is_finished_0 == u32(0))
        {
            _S152 = _S141;
        }
        else
        {
            _S152 = false;
        }
        var _S153 : bool;
        if(_S152)
        {
            _S153 = (labels_0[_S106]) == cluster_1;
        }
        else
        {
            _S153 = false;
        }
        var _S154 : bool;
        if(_S153)
        {
            _S154 = (along_0[u32(7)]) > boundary_0;
        }
        else
        {
            _S154 = false;
        }
        if(_S154)
        {
            labels_0[_S106] = new_cluster_0;
        }
        workgroupBarrier();
        measure_0(i32(0), _S96, cluster_1, _S98, _S97);
        measure_0(i32(0), _S96, new_cluster_0, _S98, _S97);
        var _S155 : u32 = new_cluster_0 + u32(1);
        keep_level_0(i32(0), _S96, _S155, _S97);
        new_cluster_0 = _S155;
    }
    return;
}

fn square_0( x_1 : f32) -> f32
{
    return x_1 * x_1;
}

fn weighted_error_0( _S156 : i32,  _S157 : u32,  _S158 : u32) -> f32
{
    return scratch_number_0(bakes_0[_S156].cluster_errors_0 + _S157 * bakes_0[_S156].max_clusters_0 + (min(_S158, scratch_0[bakes_0[_S156].facts_0 + u32(10) + _S157]) - u32(1))) / f32(scratch_0[bakes_0[_S156].facts_0 + u32(4) + _S157]) * f32(scratch_0[bakes_0[_S156].facts_0 + _S157]);
}

fn best_warp_count_0( _S159 : i32,  _S160 : u32) -> u32
{
    var _S161 : u32 = bakes_0[_S159].per_family_0;
    var _S162 : u32 = u32(2) * bakes_0[_S159].per_family_0;
    var _S163 : u32 = u32(2) * _S160;
    var _S164 : u32 = bakes_0[_S159].facts_0 + u32(4) + _S163;
    var _S165 : bool;
    if(scratch_0[_S164] > u32(0))
    {
        _S165 = scratch_0[_S164 + u32(1)] > u32(0);
    }
    else
    {
        _S165 = false;
    }
    if((_S162 % u32(8)) != u32(0))
    {
        _S165 = true;
    }
    else
    {
        _S165 = !_S165;
    }
    if(_S165)
    {
        return _S161;
    }
    var least_0 : f32 = 3.00000000549775576e+38f;
    var best_0 : u32 = _S161;
    var count_0 : u32 = u32(4);
    for(;;)
    {
        if(count_0 < _S162)
        {
        }
        else
        {
            break;
        }
        var _S166 : f32 = weighted_error_0(_S159, _S163, count_0) + weighted_error_0(_S159, _S163 + u32(1), _S162 - count_0);
        var _S167 : i32 = i32(_S161);
        var _S168 : i32 = abs(i32(count_0) - _S167);
        if(_S166 < least_0)
        {
            _S165 = true;
        }
        else
        {
            if(_S166 == least_0)
            {
                _S165 = _S168 < (abs(i32(best_0) - _S167));
            }
            else
            {
                _S165 = false;
            }
        }
        if(_S165)
        {
            least_0 = _S166;
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
    var _S169 : u32;
    var step_2 : u32;
    var least_1 : f32;
    var distance_0 : f32;
    var nearest_0 : u32;
    var _S170 : u32 = group_1.x;
    var _S171 : u32 = _S170 / u32(2);
    var _S172 : u32 = thread_1.x;
    var _S173 : u32 = bakes_0[i32(0)].facts_0;
    var _S174 : u32 = scratch_0[bakes_0[i32(0)].facts_0 + u32(4) + _S170];
    var _S175 : u32 = best_warp_count_0(i32(0), _S171);
    var _S176 : bool = (_S170 % u32(2)) == u32(0);
    var _S177 : u32;
    if(_S176)
    {
        _S177 = _S175;
    }
    else
    {
        _S177 = u32(2) * bakes_0[i32(0)].per_family_0 - _S175;
    }
    var _S178 : u32 = bakes_0[i32(0)].centroids_0;
    var _S179 : u32 = _S171 * u32(2) * bakes_0[i32(0)].per_family_0;
    var item_1 : u32;
    if(_S176)
    {
        item_1 = u32(0);
    }
    else
    {
        item_1 = _S175;
    }
    var _S180 : u32 = _S178 + (_S179 + item_1) * u32(6);
    var _S181 : u32 = min(_S177, scratch_0[_S173 + u32(10) + _S170]);
    var _S182 : u32 = bakes_0[i32(0)].cluster_means_0 + (_S170 * bakes_0[i32(0)].max_clusters_0 + _S181 - u32(1)) * bakes_0[i32(0)].max_clusters_0 * u32(6);
    item_1 = _S172;
    for(;;)
    {
        var _S183 : u32 = _S177 * u32(6);
        _S169 = _S183;
        if(item_1 < _S183)
        {
        }
        else
        {
            break;
        }
        if((item_1 / u32(6)) < _S181)
        {
            step_2 = item_1;
        }
        else
        {
            step_2 = item_1 % u32(6);
        }
        scratch_0[_S180 + item_1] = scratch_0[_S182 + step_2];
        item_1 = item_1 + u32(256);
    }
    var _S184 : bool;
    if(_S172 == u32(0))
    {
        _S184 = _S176;
    }
    else
    {
        _S184 = false;
    }
    if(_S184)
    {
        scratch_0[_S173 + u32(14) + _S171] = _S175;
    }
    storageBarrier(); textureBarrier(); workgroupBarrier();;
    step_2 = u32(0);
    for(;;)
    {
        if(step_2 < u32(2))
        {
        }
        else
        {
            break;
        }
        var i_1 : u32 = u32(0);
        for(;;)
        {
            if(i_1 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S185 : u32 = _S172 * u32(8) + i_1;
            least_1 = 3.00000000549775576e+38f;
            nearest_0 = u32(0);
            var cluster_2 : u32 = u32(0);
            for(;;)
            {
                if(cluster_2 < _S177)
                {
                    _S184 = _S185 < _S174;
                }
                else
                {
                    _S184 = false;
                }
                if(_S184)
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
                    if(k_2 < u32(6))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var distance_1 : f32 = distance_0 + square_0(scratch_number_0(point_row_0(i32(0), _S170, _S185) + k_2) - scratch_number_0(_S180 + cluster_2 * u32(6) + k_2));
                    k_2 = k_2 + u32(1);
                    distance_0 = distance_1;
                }
                if(distance_0 < least_1)
                {
                    item_1 = cluster_2;
                }
                else
                {
                    item_1 = nearest_0;
                }
                var _S186 : f32 = min(least_1, distance_0);
                var _S187 : u32 = cluster_2 + u32(1);
                least_1 = _S186;
                nearest_0 = item_1;
                cluster_2 = _S187;
            }
            labels_0[_S185] = nearest_0;
            i_1 = i_1 + u32(1);
        }
        storageBarrier(); textureBarrier(); workgroupBarrier();;
        item_1 = _S172;
        for(;;)
        {
            if(item_1 < _S169)
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
                if(nearest_0 < _S174)
                {
                }
                else
                {
                    break;
                }
                if((labels_0[nearest_0]) == (item_1 / u32(6)))
                {
                    var total_9 : f32 = distance_0 + scratch_number_0(point_row_0(i32(0), _S170, nearest_0) + item_1 % u32(6));
                    least_1 = least_1 + 1.0f;
                    distance_0 = total_9;
                }
                nearest_0 = nearest_0 + u32(1);
            }
            if(least_1 > 0.0f)
            {
                scratch_0[_S180 + item_1] = (bitcast<u32>((distance_0 / least_1)));
            }
            item_1 = item_1 + u32(256);
        }
        storageBarrier(); textureBarrier(); workgroupBarrier();;
        step_2 = step_2 + u32(1);
    }
    item_1 = _S172;
    for(;;)
    {
        if(item_1 < _S169)
        {
        }
        else
        {
            break;
        }
        var _S188 : u32 = item_1 % u32(6);
        if(_S188 == u32(2))
        {
            least_1 = 0.5f;
        }
        else
        {
            if(_S188 == u32(4))
            {
                least_1 = 1.0f;
            }
            else
            {
                least_1 = 0.0f;
            }
        }
        var _S189 : u32 = _S180 + item_1;
        if(_S174 > u32(0))
        {
            distance_0 = scratch_number_0(_S189) / 10000.0f;
        }
        else
        {
            distance_0 = least_1;
        }
        scratch_0[_S189] = (bitcast<u32>((distance_0)));
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

fn nearest_group_0( _S190 : i32,  _S191 : bool,  _S192 : bool,  _S193 : vec3<f32>,  _S194 : vec3<f32>) -> u32
{
    var _S195 : u32;
    if(_S191)
    {
        _S195 = u32(1);
    }
    else
    {
        _S195 = u32(0);
    }
    var _S196 : u32 = scratch_0[bakes_0[_S190].facts_0 + u32(14) + _S195];
    var nearest_1 : u32;
    if(_S192)
    {
        nearest_1 = u32(0);
    }
    else
    {
        nearest_1 = _S196;
    }
    var _S197 : u32;
    if(_S192)
    {
        _S197 = _S196;
    }
    else
    {
        _S197 = u32(2) * bakes_0[_S190].per_family_0;
    }
    var least_2 : f32 = 1000.0f;
    var group_2 : u32 = nearest_1;
    for(;;)
    {
        if(group_2 < _S197)
        {
        }
        else
        {
            break;
        }
        var _S198 : u32 = bakes_0[_S190].centroids_0 + (_S195 * u32(2) * bakes_0[_S190].per_family_0 + group_2) * u32(6);
        var _S199 : vec3<f32> = vec3<f32>(0.5f) * _S193 - vec3<f32>(scratch_number_0(_S198), scratch_number_0(_S198 + u32(1)), scratch_number_0(_S198 + u32(2)));
        var _S200 : vec3<f32> = _S194 - vec3<f32>(scratch_number_0(_S198 + u32(3)), scratch_number_0(_S198 + u32(4)), scratch_number_0(_S198 + u32(5)));
        var _S201 : f32 = dot(_S199, _S199) + dot(_S200, _S200);
        if(_S201 < least_2)
        {
            nearest_1 = group_2;
        }
        var _S202 : f32 = min(least_2, _S201);
        var _S203 : u32 = group_2 + u32(1);
        least_2 = _S202;
        group_2 = _S203;
    }
    return nearest_1;
}

@compute
@workgroup_size(64, 1, 1)
fn bake_assign(@builtin(global_invocation_id) id_1 : vec3<u32>)
{
    var _S204 : u32 = thread_index_0(id_1);
    var _S205 : u32 = bakes_0[i32(0)].rays_0;
    if(_S204 >= (u32(512) * bakes_0[i32(0)].rays_0))
    {
        return;
    }
    var _S206 : SurfaceHit_std430_0 = hits_0[_S204];
    var _S207 : u32 = _S206.flags_0;
    if((((_S206.flags_0) & (u32(10)))) != u32(0))
    {
        return;
    }
    var _S208 : bool = _S204 >= (u32(256) * _S205);
    var _S209 : bool = ((_S207 & (u32(1)))) != u32(0);
    var _S210 : vec3<f32> = hit_normal_0(&(_S206));
    var _S211 : vec3<f32> = hit_tangent_0(&(_S206));
    hits_0[_S204].flags_0 = (_S207 | ((((nearest_group_0(i32(0), _S208, _S209, _S210, _S211) + u32(1)) << (u32(8))))));
    return;
}

