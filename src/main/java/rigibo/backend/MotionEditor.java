package rigibo.backend;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;
import rigibo.backend.storage.Waking;

/** Changes how bodies move between steps: velocities, forces, impulses, drives, sleep. */
final class MotionEditor {

    private final DataStorage data;
    private final Bodies bodies;
    private final Waking waking;

    MotionEditor(DataStorage data, Waking waking) {
        this.data = data;
        this.waking = waking;
        bodies = data.bodies;
    }

    void velocity(int slot, double vx, double vy) {
        double most = BodyDefinition.MOST_SPEED;
        Require.within("RigidBody.velocity x", vx, -most, most, "m/s");
        Require.within("RigidBody.velocity y", vy, -most, most, "m/s");
        requireMovable(slot, "velocity", vx != 0 || vy != 0);
        endDrive(slot);
        bodies.velocityX[slot] = vx;
        bodies.velocityY[slot] = vy;
        hold(slot);
        data.roster.isStale = true;
        waking.wake(slot);
    }

    void spin(int slot, double radiansPerSecond) {
        double most = BodyDefinition.MOST_SPIN;
        Require.within("RigidBody.spin", radiansPerSecond, -most, most, "rad/s");
        requireMovable(slot, "spin", radiansPerSecond != 0);
        endDrive(slot);
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
        push(slot, jx, jy, px, py);
        waking.wake(slot);
    }

    /** Applies an impulse without waking any body. */
    void push(int slot, double jx, double jy, double px, double py) {
        Require.finite("RigidBody.applyImpulse jx", jx, "N·s");
        Require.finite("RigidBody.applyImpulse jy", jy, "N·s");
        Require.finite("RigidBody.applyImpulse px", px, "m");
        Require.finite("RigidBody.applyImpulse py", py, "m");
        double moment = (px - bodies.x[slot]) * jy - (py - bodies.y[slot]) * jx;
        double freeX = bodies.isLockedInX(slot) ? 0 : bodies.inverseMass[slot];
        double freeY = bodies.isLockedInY(slot) ? 0 : bodies.inverseMass[slot];
        double vx = bodies.velocityX[slot] + freeX * jx;
        double vy = bodies.velocityY[slot] + freeY * jy;
        double w = bodies.spinOf(slot) + bodies.inverseInertiaOf(slot) * moment;
        double most = BodyDefinition.MOST_SPEED;
        Require.within("RigidBody.applyImpulse resulting velocity x", vx, -most, most, "m/s");
        Require.within("RigidBody.applyImpulse resulting velocity y", vy, -most, most, "m/s");
        double fastest = BodyDefinition.MOST_SPIN;
        Require.within("RigidBody.applyImpulse resulting spin", w, -fastest, fastest, "rad/s");
        bodies.velocityX[slot] = vx;
        bodies.velocityY[slot] = vy;
        hold(slot);
        if (bodies.turns()) {
            bodies.spin[slot] = w;
        }
    }

    void driveTo(int slot, double x, double y, double angle, double seconds) {
        Require.finite("RigidBody.driveTo x", x, "m");
        Require.finite("RigidBody.driveTo y", y, "m");
        double most = BodyDefinition.MOST_ANGLE;
        Require.within("RigidBody.driveTo angle", angle, -most, most, "rad");
        Require.positive("RigidBody.driveTo seconds", seconds, "s");
        if (bodies.type[slot] != BodyType.KINEMATIC) {
            throw new IllegalArgumentException(
                    "RigidBody.driveTo needs a kinematic body, was " + bodies.type[slot]);
        }
        requireFreeWay(slot, x, y);
        double way = Math.abs(x - bodies.x[slot]) + Math.abs(y - bodies.y[slot]);
        double fastest = BodyDefinition.MOST_SPEED;
        // An arc of half a turn is π/2 times as long as its chord.
        double speed = Math.PI / 2 * way / seconds;
        Require.within("RigidBody.driveTo speed", speed, 0, fastest, "m/s");
        double spin = Math.abs(angle - bodies.angle[slot]) / seconds;
        Require.within("RigidBody.driveTo spin", spin, 0, BodyDefinition.MOST_SPIN, "rad/s");
        bodies.hold(Need.DRIVES);
        bodies.driveX[slot] = x;
        bodies.driveY[slot] = y;
        bodies.driveAngle[slot] = angle;
        bodies.driveTime[slot] = seconds;
        steerOn(slot);
        waking.wake(slot);
    }

    /** A drive along a locked axis would never arrive. */
    private void requireFreeWay(int slot, double x, double y) {
        if (bodies.isLockedInX(slot)) {
            double there = bodies.x[slot];
            Require.within("RigidBody.driveTo x of what is locked in x", x, there, there, "m");
        }
        if (bodies.isLockedInY(slot)) {
            double there = bodies.y[slot];
            Require.within("RigidBody.driveTo y of what is locked in y", y, there, there, "m");
        }
    }

    /** Sets the velocity of a body along its locked axes to 0. */
    void hold(int slot) {
        bodies.holdAxes(slot, bodies.velocityX, bodies.velocityY);
    }

    void sleep(int slot) {
        if (bodies.isDynamic(slot)) {
            bodies.halt(slot);
            bodies.clearForces(slot);
            bodies.awake[slot] = false;
            data.roster.isStale = true;
        }
    }

    void wake(int slot) {
        waking.wake(slot);
    }

    void steerOn(int slot) {
        if (bodies.isSteered(slot)) {
            data.steered.add(slot);
        }
    }

    void endDrive(int slot) {
        if (bodies.driveTime != null) {
            bodies.driveTime[slot] = 0;
        }
    }

    /** Sum of a torque in N·m and those applied since the last step; 0 without {@code Rotation}. */
    private double torqueOf(int slot, double more) {
        return bodies.turns() ? bodies.torque[slot] + more : 0;
    }

    /** Lists a body to which the first force since the last step is applied. */
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
