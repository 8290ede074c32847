package rigibo.backend;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;
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
 * Changes bodies between steps. Every edit is checked first, then made, and wakes the bodies whose
 * motion it may change.
 */
final class BodyEditor {

    private final Pool pool;
    private final DataStorage data;
    private final Bodies bodies;
    private final StepPlan plan;
    private final Waking waking;
    private final SupportLoss supportLoss;
    private final BodyShapes shapes;

    /** Edits of motion: velocity, forces, drives, sleep. */
    final MotionEditor motion;

    /** Edits of locks. */
    final LockEditor locks;

    BodyEditor(Pool pool, DataStorage data, StepPlan plan) {
        this.pool = pool;
        this.data = data;
        this.plan = plan;
        bodies = data.bodies;
        waking = new Waking(data);
        supportLoss = new SupportLoss(data, waking);
        shapes = new BodyShapes(data);
        motion = new MotionEditor(data, waking);
        locks = new LockEditor(data, plan, waking, motion);
    }

    int add(BodyDefinition definition) {
        MassProperties plate = definition.massProperties();
        requireSensors("Pool.add", definition.isSensor(), definition.shape());
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
        locks.begin(slot, definition);
        writePose(slot, definition.x(), definition.y(), definition.angle());
        join(slot);
        data.roster.isStale = true;
        return slot;
    }

    /** Makes the fixtures of a body that is new to the broadphase. */
    private void join(int slot) {
        if (plan.broadphase() != null) {
            for (int s = slot; s != Pairs.NONE; s = bodies.nextShapeOf(s)) {
                bodies.firstPair[s] = Pairs.NONE;
            }
        }
        if (isInBroadphase(slot)) {
            plan.broadphase().add(slot);
        }
    }

    /** Whether a body has fixtures: {@code Contacts} is declared and the body is enabled. */
    private boolean isInBroadphase(int slot) {
        return plan.broadphase() != null && !bodies.isDisabled(slot);
    }

    /** Refits the fixtures of a body that was moved or reshaped, and removes its contacts. */
    private void refit(int slot) {
        if (isInBroadphase(slot)) {
            pool.contacts().ended.cutAllOf(slot);
            plan.broadphase().forgetContacts(slot);
            plan.broadphase().refit(slot);
        }
    }

    void remove(int slot) {
        leave(slot);
        shapes.release(slot);
        bodies.release(slot);
        if (data.hits != null) {
            data.hits.remove(slot);
        }
        data.roster.isStale = true;
    }

    /** Removes the fixtures of a body that is removed, and wakes what rested on it. */
    private void leave(int slot) {
        supportLoss.wakeNeighbours(slot);
        forgetVisits(slot);
        if (isInBroadphase(slot)) {
            pool.contacts().ended.cutAllOf(slot);
            plan.broadphase().remove(slot);
        }
    }

    void disable(int slot) {
        bodies.hold(Need.ABSENCES);
        if (!bodies.disabled[slot]) {
            leave(slot);
            bodies.disabled[slot] = true;
            bodies.awake[slot] = false;
            if (bodies.firstPair != null) {
                bodies.firstPair[slot] = Pairs.NONE;
            }
            data.roster.isStale = true;
        }
    }

    void enable(int slot) {
        if (bodies.isDisabled(slot)) {
            bodies.disabled[slot] = false;
            bodies.awake[slot] = bodies.type[slot] != BodyType.DYNAMIC;
            join(slot);
            data.roster.isStale = true;
            motion.steerOn(slot);
            waking.wake(slot);
        }
    }

    void moveTo(int slot, double x, double y, double angle) {
        Require.finite("RigidBody.moveTo x", x, "m");
        Require.finite("RigidBody.moveTo y", y, "m");
        double most = BodyDefinition.MOST_ANGLE;
        Require.within("RigidBody.moveTo angle", angle, -most, most, "rad");
        waking.wakeNeighbours(slot);
        motion.endDrive(slot);
        writePose(slot, x, y, angle);
        refit(slot);
        waking.wake(slot);
    }

    void type(int slot, BodyType type) {
        requireMass("type", type, bodies.shape[slot]);
        waking.wakeNeighbours(slot);
        motion.endDrive(slot);
        for (int s = slot; s != Pairs.NONE; s = bodies.nextShapeOf(s)) {
            bodies.type[s] = type;
        }
        if (type == BodyType.STATIC) {
            bodies.halt(slot);
        }
        Weight.write(bodies, slot);
        data.roster.isStale = true;
        pairAnew(slot);
    }

    void material(int slot, Material material) {
        MassProperties plate = Weight.of(bodies, slot, bodies.shape[slot], material);
        shapes.material(slot, material);
        Weight.write(bodies, slot, plate);
        mixAnew(slot);
    }

    void material(int slot, int part, Material surface) {
        shapes.surface(partOf(slot, "material", part), surface);
        mixAnew(slot);
    }

    private void mixAnew(int slot) {
        for (int p = bodies.firstPairOf(slot); p != Pairs.NONE; p = data.pairs.nextOf(p, slot)) {
            data.pairs.mix(bodies, p);
            data.pairs.reconsider(p);
        }
        waking.wakeNeighbours(slot);
        waking.wake(slot);
    }

    /** The slot of a part of a body; refuses a part that the shape does not have. */
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

    /** Removes the pairs of a body and searches for new ones. */
    private void pairAnew(int slot) {
        if (isInBroadphase(slot)) {
            pool.contacts().ended.cutAllOf(slot);
            plan.broadphase().forgetPairs(slot);
            plan.broadphase().refit(slot);
        }
        waking.wake(slot);
    }

    void shape(int slot, Shape shape) {
        requireMass("shape", bodies.type[slot], shape);
        requireSensors("RigidBody.shape", false, shape);
        MassProperties plate = Weight.of(bodies, slot, shape, bodies.material[slot]);
        waking.wakeNeighbours(slot);
        if (shape.parts() == 1 && bodies.shape[slot].parts() == 1 && !isChain(shape)) {
            shapes.write(slot, shape);
            Weight.write(bodies, slot, plate);
            refit(slot);
        } else {
            exchange(slot, shape, plate);
        }
        waking.wake(slot);
    }

    private void forgetVisits(int slot) {
        if (data.visits != null) {
            pool.sensors().cutAllOf(slot);
        }
    }

    private void requireSensors(String verb, boolean isWhole, Shape shape) {
        boolean isAny = isWhole;
        for (int part = 0; part < shape.parts() && !isAny; part++) {
            isAny = BodyShapes.isSensor(shape, part);
        }
        if (isAny && !plan.effects().declares(Sensors.class)) {
            throw new IllegalStateException(
                    verb + " of a sensor needs the effect Sensors, which is not declared");
        }
    }

    private static boolean isChain(Shape shape) {
        return shape.kind() == ShapeKind.CHAIN;
    }

    /** Refuses a dynamic chain, which has no mass. */
    private static void requireMass(String verb, BodyType type, Shape shape) {
        if (type == BodyType.DYNAMIC && isChain(shape)) {
            throw new IllegalArgumentException(
                    "RigidBody." + verb + " must not make a Chain dynamic: it has no mass");
        }
    }

    /** Gives a body a shape with other parts, hence other slots and other fixtures. */
    private void exchange(int slot, Shape shape, MassProperties plate) {
        forgetVisits(slot);
        if (isInBroadphase(slot)) {
            pool.contacts().ended.cutAllOf(slot);
            plan.broadphase().remove(slot);
        }
        shapes.exchange(slot, shape);
        Weight.write(bodies, slot, plate);
        join(slot);
    }

    /**
     * Declares other effects: adds and drops columns and wakes every body. If {@code Rotation} is
     * newly declared, bodies start to turn from rest, with the inertia stated or that of their
     * shape; if it no longer is, they keep their present angle.
     */
    void effects(Effects effects) {
        boolean hadContacts = plan.broadphase() != null;
        if (hadContacts && !effects.declares(Contacts.class)) {
            forgetAllPairs();
        }
        if (!effects.declares(Thrust.class)) {
            data.thrusting.clear();
        }
        boolean sensed = plan.effects().declares(Sensors.class);
        bodies.declare(effects);
        data.pairs.declare(effects);
        data.declareJoints(effects);
        plan.compile(effects, plan.accuracy());
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot)) {
                shapes.write(slot, bodies.shape[slot]);
                shapes.writeSurfaces(slot);
                Weight.write(bodies, slot);
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
        if (data.visits != null && sensed != effects.declares(Sensors.class)) {
            findVisitsAnew();
        }
        // A kinematic body that only spins counts as moving only while rotation is declared.
        data.roster.isStale = true;
    }

    /** Makes the pairs of sensors again once {@code Sensors} is declared. */
    private void findVisitsAnew() {
        data.visits.clear();
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot) && isInBroadphase(slot)) {
                plan.broadphase().refit(slot);
            }
        }
    }

    private void forgetAllPairs() {
        pool.contacts().ended.cutAll();
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot) && !bodies.isDisabled(slot)) {
                plan.broadphase().forgetPairs(slot);
            }
        }
    }

    /** Computes the derived columns from those that a snapshot holds. */
    void derive() {
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isBody(slot)) {
                bodies.aim(slot);
                shapes.write(slot, bodies.shape[slot]);
                shapes.writeSurfaces(slot);
                Weight.write(bodies, slot);
                motion.steerOn(slot);
                bodies.keepStart(slot);
                if (bodies.turns()) {
                    bodies.keepStartAngle(slot);
                }
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
        bodies.keepStart(slot);
        if (bodies.turns()) {
            bodies.keepStartAngle(slot);
        }
        bodies.restartStillness(slot);
    }
}
