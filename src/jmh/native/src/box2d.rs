//! Box2D v3, built from its C source.

use crate::peer::{self, Body, HINGE, Joint, Peer, Piece, ROD, SLIDE, Settings, WHEEL};
use boxdd_sys::ffi::*;

pub struct Box2d {
    world: b2WorldId,
    substeps: i32,
    has_sleep: bool,
    bodies: Vec<b2BodyId>,
}

fn vector(xy: [f32; 2]) -> b2Vec2 {
    b2Vec2 { x: xy[0], y: xy[1] }
}

fn turned(angle: f32) -> b2Rot {
    let (s, c) = angle.sin_cos();
    b2Rot { c, s }
}

/// Version of the library, as major · 10000 + minor · 100 + revision.
pub fn version() -> i32 {
    let version = unsafe { b2GetVersion() };
    version.major * 10_000 + version.minor * 100 + version.revision
}

impl Box2d {
    pub fn new(settings: &Settings) -> Self {
        let mut definition = unsafe { b2DefaultWorldDef() };
        definition.gravity = vector(settings.gravity);
        definition.enableSleep = settings.has_sleep;
        definition.enableContinuous = settings.has_continuous_impacts;
        definition.workerCount = settings.workers;
        Self {
            world: unsafe { b2CreateWorld(&definition) },
            substeps: settings.substeps,
            has_sleep: settings.has_sleep,
            bodies: Vec::new(),
        }
    }

    fn outline(body: b2BodyId, shape: &b2ShapeDef, corners: &[[f32; 2]], radius: f32) {
        let points: Vec<b2Vec2> = corners.iter().map(|&corner| vector(corner)).collect();
        unsafe {
            match points[..] {
                [center] => {
                    b2CreateCircleShape(body, shape, &b2Circle { center, radius });
                }
                [center1, center2] => {
                    let capsule = b2Capsule { center1, center2, radius };
                    b2CreateCapsuleShape(body, shape, &capsule);
                }
                _ => {
                    let hull = b2ComputeHull(points.as_ptr(), points.len() as i32);
                    b2CreatePolygonShape(body, shape, &b2MakePolygon(&hull, radius));
                }
            }
        }
    }

    /// Box2D's chains are solid on the right of their direction, as ours are, and an open one needs
    /// a ghost corner at each end, on which nothing collides.
    fn chain(body: b2BodyId, stated: &Body, corners: &[[f32; 2]], is_loop: bool) {
        let mut points: Vec<b2Vec2> = corners.iter().map(|&corner| vector(corner)).collect();
        if !is_loop {
            let beyond = |end: b2Vec2, next: b2Vec2| b2Vec2 {
                x: 2.0 * end.x - next.x,
                y: 2.0 * end.y - next.y,
            };
            let last = points.len() - 1;
            let first_ghost = beyond(points[0], points[1]);
            let last_ghost = beyond(points[last], points[last - 1]);
            points.insert(0, first_ghost);
            points.push(last_ghost);
        }
        unsafe {
            let mut material = b2DefaultSurfaceMaterial();
            material.friction = stated.friction;
            material.restitution = stated.elasticity;
            let mut definition = b2DefaultChainDef();
            definition.points = points.as_ptr();
            definition.count = points.len() as i32;
            definition.materials = &material;
            definition.materialCount = 1;
            definition.filter.groupIndex = -stated.group;
            definition.isLoop = is_loop;
            b2CreateChain(body, &definition);
        }
    }

    /// A frame in a body at a world point, its x axis along a world direction. Frames of two bodies
    /// agree as the bodies stand, so that joints are at 0 there.
    fn frame(body: b2BodyId, at: [f32; 2], axis: f32) -> b2Transform {
        unsafe {
            let rotation = b2Body_GetRotation(body);
            b2Transform {
                p: b2Body_GetLocalPoint(body, vector(at)),
                q: turned(axis - rotation.s.atan2(rotation.c)),
            }
        }
    }

    fn frames(&self, base: &mut b2JointDef, joint: &Joint, at_b: [f32; 2], axis: f32) {
        base.bodyIdA = self.bodies[joint.a];
        base.bodyIdB = self.bodies[joint.b];
        base.localFrameA = Self::frame(base.bodyIdA, joint.at, axis);
        base.localFrameB = Self::frame(base.bodyIdB, at_b, axis);
    }
}

impl Peer for Box2d {
    fn add(&mut self, body: &Body, pieces: &[Piece]) {
        unsafe {
            let mut definition = b2DefaultBodyDef();
            definition.type_ = match body.kind {
                peer::STATIC => b2BodyType_b2_staticBody,
                peer::KINEMATIC => b2BodyType_b2_kinematicBody,
                _ => b2BodyType_b2_dynamicBody,
            };
            definition.position = vector(body.at);
            definition.rotation = turned(body.angle);
            definition.linearVelocity = vector(body.velocity);
            definition.angularVelocity = body.spin;
            definition.linearDamping = body.damping;
            definition.gravityScale = body.gravity_scale;
            definition.motionLocks.angularZ = !body.may_turn;
            definition.enableSleep = self.has_sleep;
            definition.isAwake = body.is_awake;
            let id = b2CreateBody(self.world, &definition);
            let mut shape = b2DefaultShapeDef();
            shape.material.friction = body.friction;
            shape.material.restitution = body.elasticity;
            shape.filter.groupIndex = -body.group;
            shape.density = 0.0;
            for piece in pieces {
                match piece {
                    Piece::Outline { corners, radius } => {
                        Self::outline(id, &shape, corners, *radius)
                    }
                    Piece::Chain { corners, is_loop } => Self::chain(id, body, corners, *is_loop),
                }
            }
            if definition.type_ == b2BodyType_b2_dynamicBody {
                b2Body_SetMassData(
                    id,
                    b2MassData {
                        mass: body.mass,
                        center: b2Vec2 { x: 0.0, y: 0.0 },
                        rotationalInertia: body.inertia,
                    },
                );
            }
            self.bodies.push(id);
        }
    }

    fn join(&mut self, joint: &Joint) {
        let [x, y] = joint.at;
        let [to_x, to_y] = joint.to;
        let axis = (to_y - y).atan2(to_x - x);
        let [lower, upper] = joint.limits.unwrap_or_default();
        let [speed, most] = joint.motor.unwrap_or_default();
        let [hertz, damping_ratio] = joint.spring.unwrap_or_default();
        unsafe {
            match joint.kind {
                HINGE => {
                    let mut hinge = b2DefaultRevoluteJointDef();
                    self.frames(&mut hinge.base, joint, joint.at, 0.0);
                    hinge.enableLimit = joint.limits.is_some();
                    hinge.lowerAngle = lower;
                    hinge.upperAngle = upper;
                    hinge.enableMotor = joint.motor.is_some();
                    hinge.motorSpeed = speed;
                    hinge.maxMotorTorque = most;
                    hinge.enableSpring = joint.spring.is_some();
                    hinge.hertz = hertz;
                    hinge.dampingRatio = damping_ratio;
                    b2CreateRevoluteJoint(self.world, &hinge);
                }
                ROD => {
                    let mut rod = b2DefaultDistanceJointDef();
                    self.frames(&mut rod.base, joint, joint.to, axis);
                    rod.length = (to_x - x).hypot(to_y - y);
                    rod.enableSpring = joint.spring.is_some();
                    rod.hertz = hertz;
                    rod.dampingRatio = damping_ratio;
                    b2CreateDistanceJoint(self.world, &rod);
                }
                WHEEL => {
                    let mut wheel = b2DefaultWheelJointDef();
                    self.frames(&mut wheel.base, joint, joint.at, axis);
                    wheel.enableSpring = joint.spring.is_some();
                    wheel.hertz = hertz;
                    wheel.dampingRatio = damping_ratio;
                    wheel.enableMotor = joint.motor.is_some();
                    wheel.motorSpeed = speed;
                    wheel.maxMotorTorque = most;
                    b2CreateWheelJoint(self.world, &wheel);
                }
                SLIDE => {
                    let mut slide = b2DefaultPrismaticJointDef();
                    self.frames(&mut slide.base, joint, joint.at, axis);
                    slide.enableLimit = joint.limits.is_some();
                    slide.lowerTranslation = lower;
                    slide.upperTranslation = upper;
                    slide.enableMotor = joint.motor.is_some();
                    slide.motorSpeed = speed;
                    slide.maxMotorForce = most;
                    b2CreatePrismaticJoint(self.world, &slide);
                }
                _ => {
                    let mut weld = b2DefaultWeldJointDef();
                    self.frames(&mut weld.base, joint, joint.at, 0.0);
                    weld.angularHertz = hertz;
                    weld.angularDampingRatio = damping_ratio;
                    b2CreateWeldJoint(self.world, &weld);
                }
            }
        }
    }

    fn remove(&mut self, body: usize) {
        unsafe { b2DestroyBody(self.bodies[body]) }
    }

    fn step(&mut self, seconds: f32) {
        unsafe { b2World_Step(self.world, seconds, self.substeps) }
    }

    fn push(&mut self, body: usize, force: [f32; 2]) {
        unsafe { b2Body_ApplyForceToCenter(self.bodies[body], vector(force), true) }
    }

    fn drive(&mut self, body: usize, velocity: [f32; 2], spin: f32) {
        unsafe {
            b2Body_SetLinearVelocity(self.bodies[body], vector(velocity));
            b2Body_SetAngularVelocity(self.bodies[body], spin);
        }
    }

    fn place(&self, body: usize) -> [f32; 2] {
        let place = unsafe { b2Body_GetWorldCenter(self.bodies[body]) };
        [place.x, place.y]
    }

    fn angle(&self, body: usize) -> f32 {
        let rotation = unsafe { b2Body_GetRotation(self.bodies[body]) };
        rotation.s.atan2(rotation.c)
    }

    fn velocity(&self, body: usize) -> [f32; 2] {
        let velocity = unsafe { b2Body_GetLinearVelocity(self.bodies[body]) };
        [velocity.x, velocity.y]
    }

    fn spin(&self, body: usize) -> f32 {
        unsafe { b2Body_GetAngularVelocity(self.bodies[body]) }
    }

    fn normal_impulse(&self, a: usize, b: usize) -> f32 {
        let (a, b) = (self.bodies[a], self.bodies[b]);
        let same = |one: b2BodyId, other: b2BodyId| one.index1 == other.index1;
        unsafe {
            let most = b2Body_GetContactCapacity(a);
            let mut contacts: Vec<b2ContactData> = Vec::with_capacity(most as usize);
            let count = b2Body_GetContactData(a, contacts.as_mut_ptr(), most);
            contacts.set_len(count as usize);
            contacts
                .iter()
                .filter(|contact| {
                    same(b2Shape_GetBody(contact.shapeIdA), b)
                        || same(b2Shape_GetBody(contact.shapeIdB), b)
                })
                .flat_map(|contact| {
                    contact.manifold.points[..contact.manifold.pointCount as usize].iter()
                })
                .map(|point| point.totalNormalImpulse)
                .sum()
        }
    }

    fn ray(&self, from: [f32; 2], to: [f32; 2]) -> f32 {
        let way = vector([to[0] - from[0], to[1] - from[1]]);
        unsafe {
            let filter = b2DefaultQueryFilter();
            let result = b2World_CastRayClosest(self.world, vector(from), way, filter);
            if result.hit { result.fraction } else { 1.0 }
        }
    }
}

impl Drop for Box2d {
    fn drop(&mut self) {
        unsafe { b2DestroyWorld(self.world) }
    }
}
