-- What a player sees of a level, what it takes on disk, memory, failures, and views.

ALTER TABLE run ADD COLUMN peak_kb INTEGER;
ALTER TABLE run ADD COLUMN error TEXT;
ALTER TABLE round ADD COLUMN planning_seconds REAL;
ALTER TABLE round ADD COLUMN processor_seconds REAL;
ALTER TABLE round ADD COLUMN reference_seconds REAL;
ALTER TABLE level ADD COLUMN pixels REAL;
ALTER TABLE level ADD COLUMN visible_px REAL;
ALTER TABLE level ADD COLUMN bytes INTEGER;
ALTER TABLE level ADD COLUMN skipped INTEGER;
ALTER TABLE level ADD COLUMN stop TEXT;

-- The newest run of each label on each machine for a mesh, a configuration and a generator, with names instead of numbers.
CREATE VIEW result AS
WITH newest AS (
    SELECT max(run.id) AS run_id
    FROM run JOIN build ON build.id = build_id JOIN configuration ON configuration.id = configuration_id
    GROUP BY machine_id, label, mesh_id, configuration.name, generator
),
median AS (
    SELECT run_id, avg(seconds) AS seconds
    FROM (
        SELECT run_id, seconds,
            row_number() OVER (PARTITION BY run_id ORDER BY seconds) AS place,
            count(*) OVER (PARTITION BY run_id) AS rounds
        FROM round
    )
    WHERE place IN ((rounds + 1) / 2, (rounds + 2) / 2)
    GROUP BY run_id
)
SELECT build.label,
    machine.cpu || ', ' || machine.cores || ' cores, ' || machine.memory_gib || ' GiB, ' || machine.kernel AS machine,
    run.id AS run_id, mesh.id AS mesh_id, mesh.name AS mesh, mesh.triangles AS mesh_triangles,
    mesh.vertices AS mesh_vertices, mesh.radius AS mesh_radius, mesh.has_normals, mesh.has_uvs,
    configuration.name AS configuration, configuration.id AS configuration_id, run.generator,
    1000.0 * median.seconds AS ms, run.peak_kb, run.error
FROM newest
    JOIN run ON run.id = newest.run_id
    JOIN build ON build.id = run.build_id
    JOIN machine ON machine.id = run.machine_id
    JOIN mesh ON mesh.id = run.mesh_id
    JOIN configuration ON configuration.id = run.configuration_id
    LEFT JOIN median ON median.run_id = run.id;

-- Levels of those runs.
CREATE VIEW result_level AS
SELECT result.*, level.number AS level, level.target_kind, level.target_amount, level.pixels, level.visible_px,
    level.vertices, level.triangles, level.bytes, level.skipped, level.stop,
    level.surface_mean, level.surface_maximum, level.normal_mean, level.uv_mean,
    level.new_border_edges, level.new_non_manifold_edges, level.flipped_triangles, level.repeated_triangles,
    level.degenerate_triangles
FROM result JOIN level ON level.run_id = result.run_id;

-- From here on, views for people: label and machine, a position by which rows are in order, then what is shown.

CREATE VIEW speed_up AS
WITH arrived AS (
    SELECT run_id, count(*) AS levels,
        sum(triangles <= 2 + 1.02 * CASE target_kind WHEN 'proportional' THEN (1 - target_amount) * mesh_triangles
                                                     ELSE target_amount END) AS arrivals
    FROM result_level WHERE generator = 'meshoptimizer' GROUP BY run_id
),
side_by_side AS (
    SELECT label, machine, configuration_id, configuration, mesh_id, mesh, mesh_triangles,
        max(CASE generator WHEN 'ogre-curvature' THEN ms END) AS ogre,
        max(CASE generator WHEN 'meshoptimizer' THEN ms END) AS meshoptimizer,
        max(CASE generator WHEN 'lodsmith' THEN ms END) AS lodsmith,
        max(CASE generator WHEN 'lodsmith-core' THEN ms END) AS core,
        max(arrivals) AS arrivals, max(levels) AS levels
    FROM result LEFT JOIN arrived USING (run_id)
    WHERE configuration NOT LIKE '%-counts' GROUP BY label, machine, configuration_id, mesh_id
),
means AS (
    SELECT label, machine, configuration_id, configuration, 'geometric mean' AS title, 1 AS place, * FROM side_by_side
    UNION ALL
    SELECT label, machine, configuration_id, configuration, 'where meshoptimizer arrives', 2, * FROM side_by_side
    WHERE arrivals = levels
)
SELECT label, machine, configuration_id * 1000000 + mesh_id AS position, configuration, mesh, mesh_triangles AS triangles,
    round(ogre, 2) AS "OGRE ms", round(meshoptimizer, 2) AS "meshoptimizer ms", round(lodsmith, 2) AS "Lodsmith ms",
    arrivals || '/' || levels AS "meshoptimizer arrives",
    round(ogre / lodsmith, 1) AS "OGRE / Lodsmith", round(lodsmith / meshoptimizer, 2) AS "Lodsmith / meshoptimizer",
    round(core / meshoptimizer, 2) AS "core / meshoptimizer"
FROM side_by_side
UNION ALL
SELECT label, machine, configuration_id * 1000000 + 900000 + place, configuration, title, count(*) || ' meshes',
    round(exp(avg(ln(ogre))), 2), round(exp(avg(ln(meshoptimizer))), 2), round(exp(avg(ln(lodsmith))), 2), NULL,
    round(exp(avg(ln(ogre / lodsmith))), 1), round(exp(avg(ln(lodsmith / meshoptimizer))), 2),
    round(exp(avg(ln(core / meshoptimizer))), 2)
FROM means GROUP BY label, machine, configuration_id, place;

-- Slope of the straight line through (log triangles, log time) over the planets.
CREATE VIEW growth AS
WITH point AS (
    SELECT label, machine, configuration, configuration_id, generator, mesh_triangles, ms, run_id,
        ln(mesh_triangles) AS x, ln(mesh_triangles * ln(mesh_triangles)) AS z, ln(ms) AS y
    FROM result WHERE mesh LIKE 'planet-%' AND configuration NOT LIKE '%-counts' AND ms > 0
)
SELECT label, machine, configuration_id * 1000000 + min(run_id) AS position, configuration, generator, count(*) AS sizes,
    round((count(*) * sum(x * y) - sum(x) * sum(y)) / (count(*) * sum(x * x) - sum(x) * sum(x)), 3) AS "time ~ n^",
    round((count(*) * sum(z * y) - sum(z) * sum(y)) / (count(*) * sum(z * z) - sum(z) * sum(z)), 3) AS "time ~ (n log n)^",
    round(max(mesh_triangles) / max(ms) / 1000.0, 2) AS "M triangles/s at the largest"
FROM point GROUP BY label, machine, configuration_id, generator HAVING count(*) > 1;

CREATE VIEW memory AS
WITH side_by_side AS (
    SELECT label, machine, configuration_id, configuration, mesh_id, mesh, mesh_triangles,
        max(CASE generator WHEN 'ogre-curvature' THEN max(1, peak_kb) END) AS ogre,
        max(CASE generator WHEN 'meshoptimizer' THEN max(1, peak_kb) END) AS meshoptimizer,
        max(CASE generator WHEN 'lodsmith' THEN max(1, peak_kb) END) AS lodsmith,
        max(CASE generator WHEN 'lodsmith-core' THEN max(1, peak_kb) END) AS core
    FROM result WHERE peak_kb IS NOT NULL GROUP BY label, machine, configuration_id, mesh_id
)
SELECT label, machine, configuration_id * 1000000 + mesh_id AS position, configuration, mesh, mesh_triangles AS triangles,
    ogre AS "OGRE kB", meshoptimizer AS "meshoptimizer kB", lodsmith AS "Lodsmith kB", core AS "core kB",
    round(1.0 * lodsmith / ogre, 3) AS "Lodsmith / OGRE"
FROM side_by_side
UNION ALL
SELECT label, machine, configuration_id * 1000000 + 900000, configuration, 'geometric mean', NULL,
    round(exp(avg(ln(ogre)))), round(exp(avg(ln(meshoptimizer)))), round(exp(avg(ln(lodsmith)))), round(exp(avg(ln(core)))),
    round(exp(avg(ln(1.0 * lodsmith / ogre))), 3)
FROM side_by_side GROUP BY label, machine, configuration_id;

-- A level beside another generator's at the same number of triangles, within 2% or two triangles. Below the floors there is
-- only the rounding of stored floats.
CREATE VIEW level_pair AS
SELECT a.label, a.machine, a.configuration_id, a.configuration, a.mesh_id, a.mesh, a.run_id, a.generator,
    b.generator AS beside, a.level,
    max(a.surface_mean, 1e-6 * a.mesh_radius) / max(b.surface_mean, 1e-6 * a.mesh_radius) AS mean_surface,
    max(a.surface_maximum, 1e-6 * a.mesh_radius) / max(b.surface_maximum, 1e-6 * a.mesh_radius) AS maximum_surface,
    CASE WHEN a.has_normals THEN max(a.normal_mean, 1e-4) / max(b.normal_mean, 1e-4) END AS mean_normal,
    CASE WHEN a.has_uvs THEN max(a.uv_mean, 1e-5) / max(b.uv_mean, 1e-5) END AS mean_uv
FROM result_level AS a JOIN result_level AS b
    ON a.label = b.label AND a.machine = b.machine AND a.configuration_id = b.configuration_id AND a.mesh_id = b.mesh_id
    AND a.level = b.level AND a.generator <> b.generator
WHERE b.generator IN ('ogre-curvature', 'meshoptimizer')
    AND abs(a.triangles - b.triangles) <= max(2, 0.02 * b.triangles)
    AND a.surface_mean IS NOT NULL AND b.surface_mean IS NOT NULL;

CREATE VIEW quality AS
WITH ratio AS (
    SELECT label, machine, configuration_id, configuration, run_id, generator, beside, level, 1 AS place,
        'mean surface' AS figure, mean_surface AS value FROM level_pair
    UNION ALL
    SELECT label, machine, configuration_id, configuration, run_id, generator, beside, level, 2, 'maximum surface',
        maximum_surface FROM level_pair
    UNION ALL
    SELECT label, machine, configuration_id, configuration, run_id, generator, beside, level, 3, 'mean normal',
        mean_normal FROM level_pair
    UNION ALL
    SELECT label, machine, configuration_id, configuration, run_id, generator, beside, level, 4, 'mean UV',
        mean_uv FROM level_pair
)
SELECT label, machine, configuration_id * 1000000000 + min(run_id) * 1000 + (beside = 'meshoptimizer') * 100 + place AS position,
    configuration, generator, beside AS "over that of", figure,
    round(exp(avg(CASE level WHEN 1 THEN ln(value) END)), 3) AS "level 1",
    round(exp(avg(CASE level WHEN 2 THEN ln(value) END)), 3) AS "level 2",
    round(exp(avg(CASE level WHEN 3 THEN ln(value) END)), 3) AS "level 3",
    round(exp(avg(CASE level WHEN 4 THEN ln(value) END)), 3) AS "level 4",
    count(CASE level WHEN 1 THEN value END) || '/' || count(CASE level WHEN 2 THEN value END) || '/'
        || count(CASE level WHEN 3 THEN value END) || '/' || count(CASE level WHEN 4 THEN value END) AS meshes
FROM ratio GROUP BY label, machine, configuration_id, generator, beside, place;

CREATE VIEW quality_by_mesh AS
SELECT label, machine, configuration_id * 1000000000 + mesh_id * 1000 + (beside = 'meshoptimizer') AS position, configuration,
    mesh, beside AS "over that of",
    round(max(CASE level WHEN 1 THEN mean_surface END), 2) AS "level 1",
    round(max(CASE level WHEN 2 THEN mean_surface END), 2) AS "level 2",
    round(max(CASE level WHEN 3 THEN mean_surface END), 2) AS "level 3",
    round(max(CASE level WHEN 4 THEN mean_surface END), 2) AS "level 4"
FROM level_pair WHERE generator = 'lodsmith' GROUP BY label, machine, configuration_id, mesh_id, beside;

CREATE VIEW faults AS
WITH of_mesh AS (
    SELECT label, machine, configuration_id, configuration, generator, mesh_id, min(run_id) AS run_id,
        sum(new_border_edges) AS cracks, sum(new_non_manifold_edges) AS non_manifold, sum(flipped_triangles) AS flips,
        sum(repeated_triangles) AS repeated, sum(degenerate_triangles) AS degenerate
    FROM result_level GROUP BY label, machine, configuration_id, generator, mesh_id
)
SELECT label, machine, configuration_id * 1000000 + min(run_id) AS position, configuration, generator, count(*) AS meshes,
    sum(cracks) || ' (' || sum(cracks > 0) || ')' AS "new border edges",
    sum(non_manifold) || ' (' || sum(non_manifold > 0) || ')' AS "new non-manifold edges",
    sum(flips) || ' (' || sum(flips > 0) || ')' AS "flipped triangles",
    sum(repeated) || ' (' || sum(repeated > 0) || ')' AS "repeated triangles",
    sum(degenerate) || ' (' || sum(degenerate > 0) || ')' AS "degenerate triangles"
FROM of_mesh GROUP BY label, machine, configuration_id, generator;

-- Levels that say when they appear, at that moment: a level is largest then.
CREATE VIEW visible_error AS
SELECT label, machine, configuration_id * 1000000 + min(run_id) AS position, configuration, generator,
    count(*) AS levels,
    round(100.0 * avg(visible_px <= 1), 1) AS "% up to 1 px", round(100.0 * avg(visible_px <= 2), 1) AS "% up to 2 px",
    round(avg(visible_px), 3) AS "mean px", round(max(visible_px), 2) AS "most px", mesh || ' ' || level AS "where"
FROM result_level WHERE visible_px IS NOT NULL AND NOT skipped
GROUP BY label, machine, configuration_id, generator;

-- When levels take over, as the radius on screen in pixels: as they say, and ("moved") where they would be one pixel off, which
-- is what makes levels comparable that were shown at different errors. Of levels that are within a pixel, the one with the
-- fewest triangles is shown. Level 0 is there from the beginning.
CREATE VIEW appearance AS
WITH said AS (
    SELECT label, machine, configuration_id, configuration, generator, mesh_id, mesh_triangles, run_id, triangles,
        sqrt(pixels / pi()) AS radius, visible_px
    FROM result_level WHERE pixels > 0
),
shown AS (
    SELECT label, machine, configuration_id, configuration, generator, mesh_id, mesh_triangles, run_id, triangles, radius, 0 AS moved
    FROM said
    UNION ALL
    SELECT label, machine, configuration_id, configuration, generator, mesh_id, mesh_triangles, run_id,
        min(triangles) OVER (PARTITION BY run_id ORDER BY radius / max(visible_px, 1e-3) DESC),
        radius / max(visible_px, 1e-3), 1
    FROM said
    UNION ALL
    SELECT label, machine, configuration_id, configuration, generator, mesh_id, mesh_triangles, run_id, mesh_triangles, 1e9, moved
    FROM (SELECT DISTINCT label, machine, configuration_id, configuration, generator, mesh_id, mesh_triangles, run_id FROM said),
        (SELECT 0 AS moved UNION ALL SELECT 1)
)
SELECT * FROM shown;

-- Triangles drawn, as shares of the mesh's own, over distances from where its radius is 512 pixels on: on average over the doublings until it is
-- 1.4 pixels (what one mesh costs, wherever the camera may be), and over all distances up to 50 times as far (many copies in a row).
CREATE VIEW drawn AS
WITH span AS (
    SELECT *,
        ln(max(1.4142, min(512.0, radius)) / max(1.4142, min(512.0, lead(radius, 1, 0.0) OVER shown))) AS doublings,
        min(50.0, max(1.0, 512.0 / max(1e-9, lead(radius, 1, 0.0) OVER shown))) - min(50.0, max(1.0, 512.0 / radius)) AS distances
    FROM appearance
    WINDOW shown AS (PARTITION BY run_id, moved ORDER BY radius DESC)
)
SELECT label, machine, configuration_id, configuration, generator, mesh_id, run_id, moved,
    sum(1.0 * triangles / mesh_triangles * doublings) / ln(512.0 / 1.4142) AS over_doublings,
    sum(1.0 * triangles / mesh_triangles * distances) / 49.0 AS over_distances
FROM span GROUP BY label, machine, configuration_id, generator, mesh_id, run_id, moved;

CREATE VIEW triangles_drawn AS
SELECT a.label, a.machine, (a.configuration_id * 1000000 + min(a.run_id)) * 2 + a.moved AS position,
    a.configuration || CASE a.moved WHEN 1 THEN ', moved to 1 px' ELSE '' END AS levels, a.generator, count(*) AS meshes,
    round(exp(avg(ln(a.over_doublings))), 3) AS "share of the original, by doublings",
    round(exp(avg(ln(a.over_doublings / b.over_doublings))), 3) AS "over lodsmith-curvature, classic",
    round(exp(avg(ln(a.over_distances))), 3) AS "share of the original, by distance",
    round(exp(avg(ln(a.over_distances / b.over_distances))), 3) AS "over lodsmith-curvature, classic, by distance"
FROM drawn AS a LEFT JOIN drawn AS b
    ON a.label = b.label AND a.machine = b.machine AND a.mesh_id = b.mesh_id AND b.configuration = 'classic'
    AND b.generator = 'lodsmith-curvature' AND b.moved = 0
GROUP BY a.label, a.machine, a.configuration_id, a.generator, a.moved;

-- What levels cost that say when they appear: how many there are, their index buffers over the mesh's own triangles, and the time to make
-- them over that of the same generator's four halvings.
CREATE VIEW cost_of_levels AS
WITH of_run AS (
    SELECT run_id, sum(NOT skipped) AS levels, 1.0 * sum(CASE WHEN skipped THEN 0 ELSE triangles END) / max(mesh_triangles) AS indices
    FROM result_level WHERE pixels > 0 GROUP BY run_id
)
SELECT a.label, a.machine, a.configuration_id * 1000000 + min(a.run_id) AS position, a.configuration, a.generator,
    count(*) AS meshes, round(avg(levels), 1) AS levels, round(avg(indices), 2) AS "indices over the mesh's",
    CASE WHEN a.configuration NOT LIKE '%-%' THEN round(exp(avg(ln(a.ms / b.ms))), 2) END AS "time over that of halvings",
    CASE WHEN a.configuration NOT LIKE '%-%' THEN round(max(a.ms / b.ms), 1) END AS "at most"
FROM result AS a JOIN of_run ON of_run.run_id = a.run_id
    LEFT JOIN result AS b ON a.label = b.label AND a.machine = b.machine AND a.mesh_id = b.mesh_id
        AND a.generator = b.generator AND b.configuration = 'halvings'
GROUP BY a.label, a.machine, a.configuration_id, a.generator;

-- The levels that appear at a size on screen: what is left, and how far it is off.
CREATE VIEW by_size AS
WITH level_at AS (
    SELECT label, machine, configuration_id, configuration, generator, sqrt(pixels / pi()) AS radius,
        100.0 * triangles / mesh_triangles AS left_over, visible_px
    FROM result_level WHERE pixels > 0 AND visible_px IS NOT NULL
        AND configuration IN ('candidates', 'classic', 'plain')
),
ordered AS (
    SELECT *, round(radius) AS size, count(*) OVER same AS meshes,
        row_number() OVER (PARTITION BY label, machine, configuration_id, generator, round(radius) ORDER BY left_over) AS by_left,
        row_number() OVER (PARTITION BY label, machine, configuration_id, generator, round(radius) ORDER BY visible_px) AS by_error
    FROM level_at WINDOW same AS (PARTITION BY label, machine, configuration_id, generator, round(radius))
)
SELECT label, machine, configuration_id * 1000000000 + (dense_rank() OVER (ORDER BY generator)) * 10000000 + 10000 - size AS position,
    configuration, generator, size AS "radius on screen", meshes,
    round(min(left_over), 2) AS "% left, least", round(max(CASE by_left WHEN (meshes + 1) / 2 THEN left_over END), 2) AS "median",
    round(max(left_over), 1) AS "most",
    round(min(visible_px), 2) AS "px off, least", round(max(CASE by_error WHEN (meshes + 1) / 2 THEN visible_px END), 2) AS "px, median",
    round(max(visible_px), 2) AS "px, most"
FROM ordered GROUP BY label, machine, configuration_id, generator, size;

-- Vertex targets that are missed by more than 1%.
CREATE VIEW missed_targets AS
SELECT label, machine, run_id * 100 + level AS position, configuration, generator, mesh, level,
    round((1 - target_amount) * mesh_vertices) AS target, vertices, coalesce(stop, '') AS reason
FROM result_level
WHERE target_kind = 'proportional' AND generator LIKE 'lodsmith%'
    AND abs(vertices - (1 - target_amount) * mesh_vertices) > max(1.0, 0.01 * (1 - target_amount) * mesh_vertices);

CREATE VIEW failures AS
SELECT label, machine, run_id AS position, configuration, generator, mesh, error FROM result WHERE error IS NOT NULL;

-- The ten worst of each kind.
CREATE VIEW worst_cases AS
WITH figure AS (
    SELECT label, machine, 1 AS place, 'visible error, px' AS kind, mesh, configuration, level, visible_px AS value
    FROM result_level WHERE generator = 'lodsmith' AND visible_px > 0 AND NOT skipped
    UNION ALL
    SELECT label, machine, 2 + (beside = 'meshoptimizer'), 'mean surface over that of ' || beside, mesh, configuration,
        level, mean_surface
    FROM level_pair WHERE generator = 'lodsmith' AND configuration = beside || '-counts'
    UNION ALL
    SELECT a.label, a.machine, 4 + (b.generator = 'meshoptimizer'), 'time over that of ' || b.generator, a.mesh,
        a.configuration, NULL, a.ms / b.ms
    FROM result AS a JOIN result AS b ON a.label = b.label AND a.machine = b.machine AND a.mesh_id = b.mesh_id
        AND a.configuration_id = b.configuration_id
    WHERE a.generator = 'lodsmith' AND b.generator IN ('ogre-curvature', 'meshoptimizer')
        AND a.configuration NOT LIKE '%-counts'
),
ranked AS (
    SELECT *, row_number() OVER (PARTITION BY label, machine, place ORDER BY value DESC) AS number FROM figure
)
SELECT label, machine, place * 1000 + number AS position, kind, mesh, configuration, level, round(value, 3) AS value
FROM ranked WHERE number <= 10;
