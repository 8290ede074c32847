//! What `rigibo.peers.rust.Calls` declares, for Java's native interface. All arguments are numbers, so
//! that nothing of Java's is touched from here; a world is known to Java by its address.

mod box2d;
mod peer;
mod rapier;

use peer::{Body, Joint, Peer, Piece, Settings};
use std::ffi::c_void;

type Java = *mut c_void;

/// A world, and the shapes of the body that is to be added next.
struct World {
    peer: Box<dyn Peer>,
    corners: Vec<[f32; 2]>,
    pieces: Vec<Piece>,
}

const BOX2D: i32 = 0;

/// # Safety
/// `world` comes from `create` and was not destroyed.
unsafe fn at<'a>(world: i64) -> &'a mut World {
    unsafe { &mut *(world as *mut World) }
}

fn pair(x: f64, y: f64) -> [f32; 2] {
    [x as f32, y as f32]
}

#[unsafe(no_mangle)]
pub extern "system" fn Java_rigibo_peers_rust_Calls_version(
    _: Java,
    _: Java,
    engine: i32,
) -> i32 {
    if engine == BOX2D { box2d::version() } else { rapier::VERSION }
}

#[unsafe(no_mangle)]
pub extern "system" fn Java_rigibo_peers_rust_Calls_create(
    _: Java,
    _: Java,
    engine: i32,
    gravity_x: f64,
    gravity_y: f64,
    has_sleep: bool,
    has_continuous_impacts: bool,
    substeps: i32,
    workers: i32,
) -> i64 {
    let settings = Settings {
        gravity: pair(gravity_x, gravity_y),
        has_sleep,
        has_continuous_impacts,
        substeps,
        workers,
    };
    let peer: Box<dyn Peer> = if engine == BOX2D {
        Box::new(box2d::Box2d::new(&settings))
    } else {
        Box::new(rapier::Rapier::new(&settings))
    };
    let world = World { peer, corners: Vec::new(), pieces: Vec::new() };
    Box::into_raw(Box::new(world)) as i64
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_destroy(_: Java, _: Java, world: i64) {
    drop(unsafe { Box::from_raw(world as *mut World) });
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_corner(
    _: Java,
    _: Java,
    world: i64,
    x: f64,
    y: f64,
) {
    unsafe { at(world) }.corners.push(pair(x, y));
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_outline(
    _: Java,
    _: Java,
    world: i64,
    radius: f64,
) {
    let world = unsafe { at(world) };
    let corners = std::mem::take(&mut world.corners);
    world.pieces.push(Piece::Outline { corners, radius: radius as f32 });
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_chain(
    _: Java,
    _: Java,
    world: i64,
    is_loop: bool,
) {
    let world = unsafe { at(world) };
    let corners = std::mem::take(&mut world.corners);
    world.pieces.push(Piece::Chain { corners, is_loop });
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_add(
    _: Java,
    _: Java,
    world: i64,
    kind: i32,
    x: f64,
    y: f64,
    angle: f64,
    velocity_x: f64,
    velocity_y: f64,
    spin: f64,
    mass: f64,
    inertia: f64,
    friction: f64,
    elasticity: f64,
    damping: f64,
    gravity_scale: f64,
    group: i32,
    may_turn: bool,
    is_awake: bool,
) {
    let world = unsafe { at(world) };
    let pieces = std::mem::take(&mut world.pieces);
    let body = Body {
        kind,
        at: pair(x, y),
        angle: angle as f32,
        velocity: pair(velocity_x, velocity_y),
        spin: spin as f32,
        mass: mass as f32,
        inertia: inertia as f32,
        friction: friction as f32,
        elasticity: elasticity as f32,
        damping: damping as f32,
        gravity_scale: gravity_scale as f32,
        group,
        may_turn,
        is_awake,
    };
    world.peer.add(&body, &pieces);
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_join(
    _: Java,
    _: Java,
    world: i64,
    kind: i32,
    a: i32,
    b: i32,
    x: f64,
    y: f64,
    to_x: f64,
    to_y: f64,
    has_limits: bool,
    lower: f64,
    upper: f64,
    has_motor: bool,
    speed: f64,
    most: f64,
    has_spring: bool,
    hertz: f64,
    damping_ratio: f64,
) {
    unsafe { at(world) }.peer.join(&Joint {
        kind,
        a: a as usize,
        b: b as usize,
        at: pair(x, y),
        to: pair(to_x, to_y),
        limits: has_limits.then(|| pair(lower, upper)),
        motor: has_motor.then(|| pair(speed, most)),
        spring: has_spring.then(|| pair(hertz, damping_ratio)),
    });
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_remove(
    _: Java,
    _: Java,
    world: i64,
    body: i32,
) {
    unsafe { at(world) }.peer.remove(body as usize);
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_step(
    _: Java,
    _: Java,
    world: i64,
    seconds: f64,
) {
    unsafe { at(world) }.peer.step(seconds as f32);
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_push(
    _: Java,
    _: Java,
    world: i64,
    body: i32,
    force_x: f64,
    force_y: f64,
) {
    unsafe { at(world) }.peer.push(body as usize, pair(force_x, force_y));
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_drive(
    _: Java,
    _: Java,
    world: i64,
    body: i32,
    velocity_x: f64,
    velocity_y: f64,
    spin: f64,
) {
    let velocity = pair(velocity_x, velocity_y);
    unsafe { at(world) }.peer.drive(body as usize, velocity, spin as f32);
}

/// Declares what reads one number of a body.
macro_rules! reader {
    ($name:ident, $peer:ident, $body:ident, $value:expr) => {
        #[unsafe(no_mangle)]
        pub unsafe extern "system" fn $name(_: Java, _: Java, world: i64, body: i32) -> f64 {
            let $peer = &unsafe { at(world) }.peer;
            let $body = body as usize;
            $value as f64
        }
    };
}

reader!(Java_rigibo_peers_rust_Calls_x, peer, body, peer.place(body)[0]);
reader!(Java_rigibo_peers_rust_Calls_y, peer, body, peer.place(body)[1]);
reader!(Java_rigibo_peers_rust_Calls_angle, peer, body, peer.angle(body));
reader!(Java_rigibo_peers_rust_Calls_velocityX, peer, body, peer.velocity(body)[0]);
reader!(Java_rigibo_peers_rust_Calls_velocityY, peer, body, peer.velocity(body)[1]);
reader!(Java_rigibo_peers_rust_Calls_spin, peer, body, peer.spin(body));

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_normalImpulse(
    _: Java,
    _: Java,
    world: i64,
    a: i32,
    b: i32,
) -> f64 {
    unsafe { at(world) }.peer.normal_impulse(a as usize, b as usize) as f64
}

#[unsafe(no_mangle)]
pub unsafe extern "system" fn Java_rigibo_peers_rust_Calls_ray(
    _: Java,
    _: Java,
    world: i64,
    from_x: f64,
    from_y: f64,
    to_x: f64,
    to_y: f64,
) -> f64 {
    unsafe { at(world) }.peer.ray(pair(from_x, from_y), pair(to_x, to_y)) as f64
}
