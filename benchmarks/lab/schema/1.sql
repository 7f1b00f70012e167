-- What was measured, on what, by whom.

CREATE TABLE machine (
    id INTEGER PRIMARY KEY,
    cpu TEXT NOT NULL,
    cores INTEGER NOT NULL,
    memory_gib REAL NOT NULL,
    kernel TEXT NOT NULL,
    UNIQUE (cpu, cores, memory_gib, kernel)
);

CREATE TABLE build (
    id INTEGER PRIMARY KEY,
    label TEXT NOT NULL,
    version TEXT NOT NULL,
    revision TEXT NOT NULL,
    compiler TEXT NOT NULL,
    build_type TEXT NOT NULL,
    UNIQUE (label, version, revision, compiler, build_type)
);

CREATE TABLE mesh (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL,
    hash TEXT NOT NULL,
    triangles INTEGER NOT NULL,
    vertices INTEGER NOT NULL,
    radius REAL NOT NULL,
    has_normals INTEGER NOT NULL,
    has_uvs INTEGER NOT NULL,
    UNIQUE (name, hash)
);

CREATE TABLE configuration (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL,
    rule TEXT NOT NULL,
    UNIQUE (name, rule)
);

CREATE TABLE run (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    machine_id INTEGER NOT NULL REFERENCES machine (id),
    build_id INTEGER NOT NULL REFERENCES build (id),
    mesh_id INTEGER NOT NULL REFERENCES mesh (id),
    configuration_id INTEGER NOT NULL REFERENCES configuration (id),
    generator TEXT NOT NULL,
    samples INTEGER NOT NULL,
    UNIQUE (machine_id, build_id, mesh_id, configuration_id, generator, samples)
);

CREATE TABLE round (
    run_id INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
    number INTEGER NOT NULL,
    seconds REAL NOT NULL,
    PRIMARY KEY (run_id, number)
) WITHOUT ROWID;

CREATE TABLE level (
    run_id INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
    number INTEGER NOT NULL,
    target_kind TEXT NOT NULL,
    target_amount REAL NOT NULL,
    vertices INTEGER NOT NULL,
    triangles INTEGER NOT NULL,
    surface_mean REAL,
    surface_rms REAL,
    surface_maximum REAL,
    normal_mean REAL,
    normal_rms REAL,
    normal_maximum REAL,
    uv_mean REAL,
    uv_rms REAL,
    uv_maximum REAL,
    new_border_edges INTEGER,
    new_non_manifold_edges INTEGER,
    flipped_triangles INTEGER,
    repeated_triangles INTEGER,
    degenerate_triangles INTEGER,
    PRIMARY KEY (run_id, number)
) WITHOUT ROWID;
