package rigibo.backend;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Shape;
import rigibo.backend.rest.SupportLoss;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.Require;
import rigibo.backend.step.StepPlan;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

/**
 * Changes bodies between steps: every edit is checked first, then made, and wakes what it may move.
 */
final class BodyEditor {

    private final Pool pool;
    private final DataStorage data;
    private final Bodies bodies;
    private final StepPlan plan;
    private final Waking waking;
    private final SupportLoss supportLoss;
    private final BodyShapes shapes;

    BodyEditor(Pool pool, DataStorage data, StepPlan plan) {
        this.pool = pool;
        this.data = data;
        this.plan = plan;
        bodies = data.bodies;
        waking = new Waking(data);
        supportLoss = new SupportLoss(data, waking);
        shapes = new BodyShapes(data);
    }

    int add(BodyDefinition definition) {
        MassProperties plate = definition.massProperties();
        int slot = bodies.take();
        bodies.type[slot] = definition.type();
        bodies.gravityScale[slot] = definition.gravityScale();
        bodies.statedMass[slot] = definition.statesMass() ? plate.mass() : 0;
        bodies.statedInertia[slot] = definition.statesInertia() ? plate.inertia() : 0;
        bodies.velocityX[slot] = definition.velocityX();
        bodies.velocityY[slot] = definition.velocityY();
        bodies.awake[slot] = definition.awake() || definition.type() != BodyType.DYNAMIC;
        bodies.clearForces(slot);
        bodies.clearAccelerations(slot);
        if (bodies.turns()) {
            bodies.spin[slot] = definition.spin();
            bodies.clearAngularAcceleration(slot);
        }
        shapes.add(slot, definition);
        lockRotation(slot, definition.rotationLocked());
        writePose(slot, definition.x(), definition.y(), definition.angle());
        join(slot);
        data.roster.isStale = true;
        return slot;
    }

    /** Lays the first fixture of a body that is new to contacts. */
    private void join(int slot) {
        if (plan.broadphase() != null) {
            bodies.firstPair[slot] = Pairs.NONE;
            plan.broadphase().add(slot);
        }
    }

    /** Lays the fixture of a body that was placed or shaped anew, and forgets its contacts. */
    private void refit(int slot) {
        Broadphase broadphase = plan.broadphase();
        if (broadphase != null) {
            pool.contacts().ended.cutAllOf(slot);
            broadphase.forgetContacts(slot);
            broadphase.refit(slot);
        }
    }

    void remove(int slot) {
        supportLoss.wakeNeighbours(slot);
        if (plan.broadphase() != null) {
            pool.contacts().ended.cutAllOf(slot);
            plan.broadphase().remove(slot);
        }
        shapes.release(slot);
        bodies.release(slot);
        data.roster.isStale = true;
    }

    void moveTo(int slot, double x, double y, double angle) {
        Require.finite("RigidBody.moveTo x", x, "m");
        Require.finite("RigidBody.moveTo y", y, "m");
        double most = BodyDefinition.MOST_ANGLE;
        Require.within("RigidBody.moveTo angle", angle, -most, most, "rad");
        waking.wakeNeighbours(slot);
        writePose(slot, x, y, angle);
        refit(slot);
        waking.wake(slot);
    }

    void velocity(int slot, double vx, double vy) {
        double most = BodyDefinition.MOST_SPEED;
        Require.within("RigidBody.velocity x", vx, -most, most, "m/s");
        Require.within("RigidBody.velocity y", vy, -most, most, "m/s");
        requireMovable(slot, "velocity", vx != 0 || vy != 0);
        bodies.velocityX[slot] = vx;
        bodies.velocityY[slot] = vy;
        data.roster.isStale = true;
        waking.wake(slot);
    }

    void spin(int slot, double radiansPerSecond) {
        double most = BodyDefinition.MOST_SPIN;
        Require.within("RigidBody.spin", radiansPerSecond, -most, most, "rad/s");
        requireMovable(slot, "spin", radiansPerSecond != 0);
        if (bodies.turns() && !bodies.isRotationLocked(slot)) {
            bodies.spin[slot] = radiansPerSecond;
        }
        data.roster.isStale = true;
        waking.wake(slot);
    }

    void applyForce(int slot, double fx, double fy, double px, double py) {
        requireThrust("applyForce");
        Require.finite("RigidBody.applyForce fx", fx, "N");
        Require.finite("RigidBody.applyForce fy", fy, "N");
        Require.finite("RigidBody.applyForce px", px, "m");
        Require.finite("RigidBody.applyForce py", py, "m");
        double moment = (px - bodies.x[slot]) * fy - (py - bodies.y[slot]) * fx;
        Require.finite("RigidBody.applyForce resulting force x", bodies.forceX[slot] + fx, "N");
        Require.finite("RigidBody.applyForce resulting force y", bodies.forceY[slot] + fy, "N");
        Require.finite("RigidBody.applyForce resulting torque", torqueOf(slot, moment), "N·m");
        thrust(slot);
        bodies.forceX[slot] += fx;
        bodies.forceY[slot] += fy;
        if (bodies.turns()) {
            bodies.torque[slot] += moment;
        }
        waking.wake(slot);
    }

    void applyTorque(int slot, double torque) {
        requireThrust("applyTorque");
        Require.finite("RigidBody.applyTorque", torque, "N·m");
        Require.finite("RigidBody.applyTorque resulting torque", torqueOf(slot, torque), "N·m");
        if (bodies.turns()) {
            thrust(slot);
            bodies.torque[slot] += torque;
        }
        waking.wake(slot);
    }

    void applyImpulse(int slot, double jx, double jy, double px, double py) {
        Require.finite("RigidBody.applyImpulse jx", jx, "N·s");
        Require.finite("RigidBody.applyImpulse jy", jy, "N·s");
        Require.finite("RigidBody.applyImpulse px", px, "m");
        Require.finite("RigidBody.applyImpulse py", py, "m");
        double moment = (px - bodies.x[slot]) * jy - (py - bodies.y[slot]) * jx;
        double vx = bodies.velocityX[slot] + bodies.inverseMass[slot] * jx;
        double vy = bodies.velocityY[slot] + bodies.inverseMass[slot] * jy;
        double w = bodies.spinOf(slot) + bodies.inverseInertiaOf(slot) * moment;
        double most = BodyDefinition.MOST_SPEED;
        Require.within("RigidBody.applyImpulse resulting velocity x", vx, -most, most, "m/s");
        Require.within("RigidBody.applyImpulse resulting velocity y", vy, -most, most, "m/s");
        double fastest = BodyDefinition.MOST_SPIN;
        Require.within("RigidBody.applyImpulse resulting spin", w, -fastest, fastest, "rad/s");
        bodies.velocityX[slot] = vx;
        bodies.velocityY[slot] = vy;
        if (bodies.turns()) {
            bodies.spin[slot] = w;
        }
        waking.wake(slot);
    }

    void type(int slot, BodyType type) {
        waking.wakeNeighbours(slot);
        for (int s = slot; s != Pairs.NONE; s = bodies.nextShapeOf(s)) {
            bodies.type[s] = type;
        }
        if (type == BodyType.STATIC) {
            bodies.halt(slot);
        }
        weigh(slot);
        data.roster.isStale = true;
        pairAnew(slot);
    }

    void material(int slot, Material material) {
        MassProperties plate = Weight.of(bodies, slot, bodies.shape[slot], material);
        shapes.material(slot, material);
        weigh(slot, plate);
        mixAnew(slot);
    }

    void material(int slot, int part, Material surface) {
        shapes.surface(partOf(slot, "material", part), surface);
        mixAnew(slot);
    }

    private void mixAnew(int slot) {
        for (int p = bodies.firstPairOf(slot); p != Pairs.NONE; p = data.pairs.nextOf(p, slot)) {
            data.pairs.mix(bodies, p);
        }
        waking.wakeNeighbours(slot);
        waking.wake(slot);
    }

    /** The slot of a part of a body. */
    private int partOf(int slot, String verb, int part) {
        int last = bodies.shape[slot].parts() - 1;
        return bodies.shapeOf(slot, Require.within("RigidBody." + verb + " part", part, 0, last));
    }

    Material material(int slot, int part) {
        return bodies.material[partOf(slot, "material", part)];
    }

    Filter filter(int slot, int part) {
        return shapes.filter(partOf(slot, "filter", part));
    }

    void filter(int slot, Filter filter) {
        waking.wakeNeighbours(slot);
        for (int s = slot; s != Pairs.NONE; s = bodies.nextShapeOf(s)) {
            shapes.filter(s, filter);
        }
        pairAnew(slot);
    }

    void filter(int slot, int part, Filter filter) {
        int shape = partOf(slot, "filter", part);
        waking.wakeNeighbours(slot);
        shapes.filter(shape, filter);
        pairAnew(slot);
    }

    /** Forgets whom a body met, and looks for whom it meets. */
    private void pairAnew(int slot) {
        if (plan.broadphase() != null) {
            pool.contacts().ended.cutAllOf(slot);
            plan.broadphase().forgetPairs(slot);
            plan.broadphase().refit(slot);
        }
        waking.wake(slot);
    }

    void rotationLocked(int slot, boolean isLocked) {
        waking.wakeNeighbours(slot);
        lockRotation(slot, isLocked);
        data.roster.isStale = true;
        waking.wake(slot);
    }

    /** The column of locks comes with the first body that has one. */
    private void lockRotation(int slot, boolean isLocked) {
        if (isLocked) {
            bodies.hold(Need.LOCKS);
            bodies.haltTurning(slot);
        }
        if (bodies.rotationLocked != null) {
            bodies.rotationLocked[slot] = isLocked;
        }
        weigh(slot);
    }

    void shape(int slot, Shape shape) {
        MassProperties plate = Weight.of(bodies, slot, shape, bodies.material[slot]);
        waking.wakeNeighbours(slot);
        if (shape.parts() == 1 && bodies.shape[slot].parts() == 1) {
            shapes.write(slot, shape);
            weigh(slot, plate);
            refit(slot);
        } else {
            exchange(slot, shape, plate);
        }
        waking.wake(slot);
    }

    /** Another number of shapes takes other slots, and other fixtures. */
    private void exchange(int slot, Shape shape, MassProperties plate) {
        if (plan.broadphase() != null) {
            pool.contacts().ended.cutAllOf(slot);
            plan.broadphase().remove(slot);
        }
        shapes.exchange(slot, shape);
        weigh(slot, plate);
        join(slot);
    }

    void wake(int slot) {
        waking.wake(slot);
    }

    /**
     * Declares other effects: columns come and go, everything wakes. Where bodies begin to turn,
     * they do so from rest, with the inertia stated or that of their shape; where they no longer
     * do, they keep the angle they have.
     */
    void effects(Effects effects) {
        boolean hadContacts = plan.broadphase() != null;
        if (hadContacts && !effects.declares(Contacts.class)) {
            forgetAllPairs();
        }
        if (!effects.declares(Thrust.class)) {
            data.thrusting.clear();
        }
        bodies.declare(effects);
        data.pairs.declare(effects);
        plan.compile(effects, plan.accuracy());
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot)) {
                shapes.write(slot, bodies.shape[slot]);
                shapes.writeSurfaces(slot);
                weigh(slot);
                if (!hadContacts) {
                    join(slot);
                }
            }
        }
        for (int pair = 0; pair < data.pairs.slots.high; pair++) {
            if (data.pairs.bodyA[pair] != Pairs.NONE) {
                data.pairs.mix(bodies, pair);
            }
        }
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot)) {
                waking.wake(slot);
            }
        }
        // What is driven by its spin alone is driven only where bodies turn.
        data.roster.isStale = true;
    }

    private void forgetAllPairs() {
        pool.contacts().ended.cutAll();
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot)) {
                plan.broadphase().forgetPairs(slot);
            }
        }
    }

    /** Writes what follows from what a snapshot holds. */
    void derive() {
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot)) {
                bodies.aim(slot);
                shapes.write(slot, bodies.shape[slot]);
                shapes.writeSurfaces(slot);
                weigh(slot);
                if (bodies.isThrust(slot)) {
                    data.thrusting.add(slot);
                }
            }
        }
        data.pairs.derive(bodies);
        if (plan.broadphase() != null) {
            plan.broadphase().rebuild();
        }
    }

    private void writePose(int slot, double x, double y, double angle) {
        bodies.x[slot] = x;
        bodies.y[slot] = y;
        bodies.angle[slot] = angle;
        bodies.aim(slot);
        bodies.restartStillness(slot);
    }

    private void weigh(int slot) {
        weigh(slot, Weight.of(bodies, slot));
    }

    private void weigh(int slot, MassProperties plate) {
        boolean moves = bodies.type[slot] == BodyType.DYNAMIC;
        bodies.mass[slot] = plate.mass();
        bodies.inverseMass[slot] = moves ? 1 / plate.mass() : 0;
        if (bodies.turns()) {
            bodies.inertia[slot] = plate.inertia();
            boolean turns = moves && !bodies.isRotationLocked(slot);
            bodies.inverseInertia[slot] = turns ? 1 / plate.inertia() : 0;
        }
    }

    /** What a torque in N·m makes together with those asked for before; 0 where nothing turns. */
    private double torqueOf(int slot, double more) {
        return bodies.turns() ? bodies.torque[slot] + more : 0;
    }

    /** Lists a body that a force is asked for the first time since the last step. */
    private void thrust(int slot) {
        if (!bodies.isThrust(slot)) {
            data.thrusting.add(slot);
        }
    }

    private void requireThrust(String verb) {
        if (bodies.forceX == null) {
            throw new IllegalStateException(
                    "RigidBody." + verb + " needs the effect Thrust, which is not declared");
        }
    }

    private void requireMovable(int slot, String field, boolean moves) {
        if (moves && bodies.type[slot] == BodyType.STATIC) {
            throw new IllegalArgumentException(
                    "RigidBody." + field + " must be 0 for a static body");
        }
    }
}
