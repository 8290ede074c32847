//! What the laboratory asks of an engine: `rigibo.lab.engine.World`, in plain numbers.

/// One of the shapes of a body, relative to its centre of mass, m.
pub enum Piece {
    /// The corners of a convex outline, counter-clockwise, rounded by a radius: one corner makes a
    /// disc, two a capsule.
    Outline { corners: Vec<[f32; 2]>, radius: f32 },
    /// A line without mass, solid on its right side.
    Chain { corners: Vec<[f32; 2]>, is_loop: bool },
}

pub const STATIC: i32 = 0;
pub const KINEMATIC: i32 = 1;

/// A body as the laboratory states it: SI units, places and velocities of the centre of mass.
pub struct Body {
    /// `STATIC`, `KINEMATIC`, or anything else for a dynamic body.
    pub kind: i32,
    pub at: [f32; 2],
    pub angle: f32,
    pub velocity: [f32; 2],
    pub spin: f32,
    pub mass: f32,
    pub inertia: f32,
    pub friction: f32,
    pub elasticity: f32,
    pub damping: f32,
    pub gravity_scale: f32,
    /// Bodies of the same group never collide, if it is not 0.
    pub group: i32,
    pub may_turn: bool,
    pub is_awake: bool,
}

pub const HINGE: i32 = 0;
pub const ROD: i32 = 1;
pub const WHEEL: i32 = 2;
pub const SLIDE: i32 = 3;

/// A joint between two bodies as they stand.
pub struct Joint {
    /// `HINGE`, `ROD`, `WHEEL`, `SLIDE`, or anything else for a weld.
    pub kind: i32,
    pub a: usize,
    pub b: usize,
    /// World point where it holds both bodies, or of a rod where it holds A, m.
    pub at: [f32; 2],
    /// Of a rod where it holds B, of a slide or wheel another point of its axis, m.
    pub to: [f32; 2],
    /// Bounds of its coordinate, rad or m.
    pub limits: Option<[f32; 2]>,
    /// Speed, rad/s or m/s, and the most torque or force, N·m or N.
    pub motor: Option<[f32; 2]>,
    /// Frequency, Hz, and damping ratio.
    pub spring: Option<[f32; 2]>,
}

/// How the world is run.
pub struct Settings {
    pub gravity: [f32; 2],
    pub has_sleep: bool,
    pub has_continuous_impacts: bool,
    pub substeps: i32,
    pub workers: i32,
}

/// A world whose bodies are numbered from 0 on, as they were added.
pub trait Peer {
    fn add(&mut self, body: &Body, pieces: &[Piece]);
    fn join(&mut self, joint: &Joint);
    fn remove(&mut self, body: usize);
    fn step(&mut self, seconds: f32);
    /// Pushes the centre of mass in the next step, N.
    fn push(&mut self, body: usize, force: [f32; 2]);
    fn drive(&mut self, body: usize, velocity: [f32; 2], spin: f32);
    fn place(&self, body: usize) -> [f32; 2];
    fn angle(&self, body: usize) -> f32;
    fn velocity(&self, body: usize) -> [f32; 2];
    fn spin(&self, body: usize) -> f32;
    /// Sum over the contacts of two bodies in the last step, N·s.
    fn normal_impulse(&self, a: usize, b: usize) -> f32;
    /// Share of a ray's way at which it enters the first body; 1 if it meets none.
    fn ray(&self, from: [f32; 2], to: [f32; 2]) -> f32;
}
