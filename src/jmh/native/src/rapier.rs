//! Rapier, with the settings that it comes with.

use crate::peer::{self, Body, HINGE, Joint, Peer, Piece, ROD, SLIDE, Settings, WHEEL};
use rapier2d::prelude::*;

/// The version that Cargo.toml pins, as major · 10000 + minor · 100 + patch.
pub const VERSION: i32 = 3_601;

/// Rate at which a motor's speed is approached, 1/s: at once, for all that a step can tell.
const MOTOR_RATE: f32 = 1e5;

pub struct Rapier {
    world: PhysicsWorld,
    has_sleep: bool,
    bodies: Vec<RigidBodyHandle>,
    /// Bodies with a force, which Rapier would keep for good.
    pushed: Vec<RigidBodyHandle>,
}

fn vector(xy: [f32; 2]) -> Vector {
    Vector::new(xy[0], xy[1])
}

fn vectors(corners: &[[f32; 2]]) -> Vec<Vector> {
    corners.iter().map(|&corner| vector(corner)).collect()
}

impl Rapier {
    pub fn new(settings: &Settings) -> Self {
        let mut world = PhysicsWorld::default();
        world.gravity = vector(settings.gravity);
        world.integration_parameters.num_solver_iterations = settings.substeps as usize;
        if !settings.has_continuous_impacts {
            world.integration_parameters.max_ccd_substeps = 0;
        }
        Self {
            world,
            has_sleep: settings.has_sleep,
            bodies: Vec::new(),
            pushed: Vec::new(),
        }
    }

    fn body(&self, number: usize) -> &RigidBody {
        &self.world.bodies[self.bodies[number]]
    }

    fn body_mut(&mut self, number: usize) -> &mut RigidBody {
        &mut self.world.bodies[self.bodies[number]]
    }

    fn shape(piece: &Piece) -> ColliderBuilder {
        match piece {
            Piece::Outline { corners, radius } => {
                let points = vectors(corners);
                match points[..] {
                    [center] => ColliderBuilder::ball(*radius).translation(center),
                    [a, b] => ColliderBuilder::capsule_from_endpoints(a, b, *radius),
                    _ if *radius > 0.0 => ColliderBuilder::round_convex_polyline(points, *radius)
                        .expect("a convex outline"),
                    _ => ColliderBuilder::convex_polyline(points).expect("a convex outline"),
                }
            }
            Piece::Chain { corners, is_loop } => {
                let mut points = vectors(corners);
                if *is_loop {
                    points.push(points[0]);
                }
                ColliderBuilder::oriented_polyline(points, None)
            }
        }
    }

    fn groups(group: i32) -> InteractionGroups {
        if group == 0 {
            return InteractionGroups::all();
        }
        let own = Group::from_bits_truncate(1 << (group - 1));
        InteractionGroups::new(own, !own, InteractionTestMode::And)
    }

    /// A frame in a body at a world point, its x axis along a world direction.
    fn frame(&self, body: usize, at: [f32; 2], axis: f32) -> Pose {
        self.body(body).position().inverse() * Pose::new(vector(at), axis)
    }

    fn spring(joint: &mut GenericJoint, axis: JointAxis, at: f32, spring: [f32; 2]) {
        let [hertz, damping_ratio] = spring;
        let rate = std::f32::consts::TAU * hertz;
        joint.set_motor_model(axis, MotorModel::AccelerationBased);
        joint.set_motor_position(axis, at, rate * rate, 2.0 * damping_ratio * rate);
    }

    fn motor(joint: &mut GenericJoint, axis: JointAxis, motor: [f32; 2]) {
        let [speed, most] = motor;
        joint.set_motor_model(axis, MotorModel::AccelerationBased);
        joint.set_motor_velocity(axis, speed, MOTOR_RATE);
        joint.set_motor_max_force(axis, most);
    }
}

impl Peer for Rapier {
    fn add(&mut self, body: &Body, pieces: &[Piece]) {
        let builder = match body.kind {
            peer::STATIC => RigidBodyBuilder::fixed(),
            peer::KINEMATIC => RigidBodyBuilder::kinematic_velocity_based(),
            _ => RigidBodyBuilder::dynamic(),
        };
        let mut builder = builder
            .translation(vector(body.at))
            .rotation(body.angle)
            .linvel(vector(body.velocity))
            .angvel(body.spin)
            .linear_damping(body.damping)
            .gravity_scale(body.gravity_scale)
            .can_sleep(self.has_sleep)
            .sleeping(!body.is_awake)
            .additional_mass_properties(MassProperties::new(
                Vector::ZERO,
                body.mass,
                body.inertia,
            ));
        if !body.may_turn {
            builder = builder.lock_rotations();
        }
        let handle = self.world.insert_body(builder);
        for piece in pieces {
            let collider = Self::shape(piece)
                .density(0.0)
                .friction(body.friction)
                .friction_combine_rule(CoefficientCombineRule::GeometricMean)
                .restitution(body.elasticity)
                .restitution_combine_rule(CoefficientCombineRule::Max)
                .collision_groups(Self::groups(body.group));
            self.world.insert_collider(collider, Some(handle));
        }
        self.bodies.push(handle);
    }

    fn join(&mut self, joint: &Joint) {
        let [x, y] = joint.at;
        let [to_x, to_y] = joint.to;
        let has_axis = joint.kind == WHEEL || joint.kind == SLIDE;
        let axis = if has_axis { (to_y - y).atan2(to_x - x) } else { 0.0 };
        let locked = match joint.kind {
            HINGE => JointAxesMask::LOCKED_REVOLUTE_AXES,
            ROD => JointAxesMask::empty(),
            WHEEL => JointAxesMask::LIN_Y,
            SLIDE => JointAxesMask::LOCKED_PRISMATIC_AXES,
            _ if joint.spring.is_some() => JointAxesMask::LOCKED_REVOLUTE_AXES,
            _ => JointAxesMask::LOCKED_FIXED_AXES,
        };
        let free = if joint.kind == SLIDE { JointAxis::LinX } else { JointAxis::AngX };
        let at_b = if joint.kind == ROD { joint.to } else { joint.at };
        let mut data = GenericJoint::new(locked);
        data.set_local_frame1(self.frame(joint.a, joint.at, axis));
        data.set_local_frame2(self.frame(joint.b, at_b, axis));
        data.set_contacts_enabled(false);
        if let Some(limits) = joint.limits {
            data.set_limits(free, limits);
        }
        if let Some(motor) = joint.motor {
            Self::motor(&mut data, free, motor);
        }
        if let Some(spring) = joint.spring {
            match joint.kind {
                ROD => {
                    data.coupled_axes = JointAxesMask::LIN_AXES;
                    let length = (to_x - x).hypot(to_y - y);
                    Self::spring(&mut data, JointAxis::LinX, length, spring);
                }
                WHEEL => Self::spring(&mut data, JointAxis::LinX, 0.0, spring),
                _ => Self::spring(&mut data, JointAxis::AngX, 0.0, spring),
            }
        }
        self.world
            .insert_impulse_joint(self.bodies[joint.a], self.bodies[joint.b], data);
    }

    fn remove(&mut self, body: usize) {
        self.world.remove_body(self.bodies[body]);
    }

    fn step(&mut self, seconds: f32) {
        self.world.integration_parameters.dt = seconds;
        self.world.step();
        for handle in self.pushed.drain(..) {
            self.world.bodies[handle].reset_forces(false);
        }
    }

    fn push(&mut self, body: usize, force: [f32; 2]) {
        self.body_mut(body).add_force(vector(force), true);
        self.pushed.push(self.bodies[body]);
    }

    fn drive(&mut self, body: usize, velocity: [f32; 2], spin: f32) {
        let driven = self.body_mut(body);
        driven.set_linvel(vector(velocity), true);
        driven.set_angvel(spin, true);
    }

    fn place(&self, body: usize) -> [f32; 2] {
        let place = self.body(body).center_of_mass();
        [place.x, place.y]
    }

    fn angle(&self, body: usize) -> f32 {
        self.body(body).rotation().angle()
    }

    fn velocity(&self, body: usize) -> [f32; 2] {
        let velocity = self.body(body).linvel();
        [velocity.x, velocity.y]
    }

    fn spin(&self, body: usize) -> f32 {
        self.body(body).angvel()
    }

    fn normal_impulse(&self, a: usize, b: usize) -> f32 {
        let mut sum = 0.0;
        for &one in self.body(a).colliders() {
            for &other in self.body(b).colliders() {
                if let Some(pair) = self.world.contact_pair(one, other) {
                    sum += pair.total_impulse_magnitude();
                }
            }
        }
        sum
    }

    fn ray(&self, from: [f32; 2], to: [f32; 2]) -> f32 {
        let ray = Ray::new(vector(from), vector(to) - vector(from));
        self.world
            .cast_ray(&ray, 1.0, true, QueryFilter::default())
            .map_or(1.0, |(_, share)| share)
    }
}
