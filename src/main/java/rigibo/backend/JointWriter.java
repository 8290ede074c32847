package rigibo.backend;

import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.JointReading;
import rigibo.backend.storage.JointStore;

/** Writes definitions into the columns of joints, and reads them back. */
final class JointWriter {

    private final Bodies bodies;
    private final JointStore joints;
    private final JointReading reading;

    JointWriter(Bodies bodies, JointStore joints, JointReading reading) {
        this.bodies = bodies;
        this.joints = joints;
        this.reading = reading;
    }

    void write(int joint, JointDefinition definition) {
        frames(joint, JointFrame.CENTRE, JointFrame.CENTRE);
        switch (definition.kind()) {
            case REVOLUTE -> {
                RevoluteJoint hinge = (RevoluteJoint) definition;
                frames(joint, hinge.frameA(), hinge.frameB());
            }
            case PRISMATIC -> {
                PrismaticJoint slide = (PrismaticJoint) definition;
                frames(joint, slide.frameA(), slide.frameB());
            }
            case WELD -> {
                WeldJoint weld = (WeldJoint) definition;
                frames(joint, weld.frameA(), weld.frameB());
            }
            case WHEEL -> {
                WheelJoint wheel = (WheelJoint) definition;
                frames(joint, wheel.frameA(), wheel.frameB());
            }
            case DISTANCE -> {
                DistanceJoint rod = (DistanceJoint) definition;
                frames(joint, rod.frameA(), rod.frameB());
                joints.parameter[JointStore.LENGTH][joint] = rod.length();
            }
            case MOTOR -> write(joint, (MotorJoint) definition);
            case MOUSE -> write(joint, (MouseJoint) definition);
            case GEAR -> write(joint, (GearJoint) definition);
            case PULLEY -> write(joint, (PulleyJoint) definition);
            case FILTER -> {}
        }
        settings(joint, definition.settings());
    }

    private void frames(int joint, JointFrame a, JointFrame b) {
        joints.anchorAX[joint] = a.x();
        joints.anchorAY[joint] = a.y();
        joints.axisA[joint] = a.angle();
        joints.anchorBX[joint] = b.x();
        joints.anchorBY[joint] = b.y();
        joints.axisB[joint] = b.angle();
    }

    private void write(int joint, MotorJoint motor) {
        double[][] p = joints.parameter;
        p[JointStore.VELOCITY_X][joint] = motor.velocityX();
        p[JointStore.VELOCITY_Y][joint] = motor.velocityY();
        p[JointStore.ANGULAR_VELOCITY][joint] = motor.angularVelocity();
        p[JointStore.MOST_FORCE][joint] = motor.mostForce();
        p[JointStore.MOST_TORQUE][joint] = motor.mostTorque();
    }

    private void write(int joint, MouseJoint mouse) {
        frames(joint, JointFrame.CENTRE, mouse.frameB());
        joints.parameter[JointStore.TARGET_X][joint] = mouse.targetX();
        joints.parameter[JointStore.TARGET_Y][joint] = mouse.targetY();
        joints.parameter[JointStore.MOST_FORCE][joint] = mouse.mostForce();
    }

    private void write(int joint, GearJoint gear) {
        boolean isNew = joints.firstGeared[joint] == JointStore.NONE;
        joints.firstGeared[joint] = gear.first().slot();
        joints.secondGeared[joint] = gear.second().slot();
        joints.parameter[JointStore.RATIO][joint] = gear.ratio();
        if (isNew) {
            joints.parameter[JointStore.CONSTANT][joint] = reading.geared(joint);
        }
    }

    private void write(int joint, PulleyJoint pulley) {
        double[][] p = joints.parameter;
        frames(joint, pulley.frameA(), pulley.frameB());
        p[JointStore.RATIO][joint] = pulley.ratio();
        p[JointStore.ROPE][joint] = pulley.length();
        p[JointStore.GROUND_AX][joint] = pulley.groundAX();
        p[JointStore.GROUND_AY][joint] = pulley.groundAY();
        p[JointStore.GROUND_BX][joint] = pulley.groundBX();
        p[JointStore.GROUND_BY][joint] = pulley.groundBY();
    }

    private void settings(int joint, JointSettings settings) {
        boolean isSameSpring =
                joints.hertz[joint] == settings.spring().hertz()
                        && joints.dampingRatio[joint] == settings.spring().dampingRatio()
                        && joints.stiffness[joint] > 0;
        joints.lower[joint] = settings.limits().lower();
        joints.upper[joint] = settings.limits().upper();
        joints.elasticity[joint] = settings.limits().elasticity();
        joints.motorSpeed[joint] = settings.motor().speed();
        joints.motorMost[joint] = settings.motor().most();
        joints.hertz[joint] = settings.spring().hertz();
        joints.dampingRatio[joint] = settings.spring().dampingRatio();
        joints.breakForce[joint] = settings.breakForce();
        joints.breakTorque[joint] = settings.breakTorque();
        joints.meets[joint] = settings.collideConnected();
        if (joints.kindOf(joint) == JointKind.FILTER) {
            joints.meets[joint] = false;
        }
        if (!isSameSpring) {
            stiffen(joint);
        }
    }

    /** k = m·ω² and c = 2·ζ·m·ω with the reduced mass m, or the reduced inertia for an angle. */
    private void stiffen(int joint) {
        boolean turns =
                joints.kindOf(joint) == JointKind.REVOLUTE
                        || joints.kindOf(joint) == JointKind.WELD;
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        boolean isHand = joints.kindOf(joint) == JointKind.MOUSE;
        double inverse = turns ? bodies.inverseInertiaOf(b) : bodies.inverseMass[b];
        if (!isHand) {
            inverse += turns ? bodies.inverseInertiaOf(a) : bodies.inverseMass[a];
        }
        double reduced = inverse > 0 ? 1 / inverse : 0;
        double omega = 2 * Math.PI * joints.hertz[joint];
        joints.stiffness[joint] = reduced * omega * omega;
        joints.damping[joint] = 2 * joints.dampingRatio[joint] * reduced * omega;
    }

    JointDefinition read(Pool pool, int joint) {
        RigidBody a = pool.handle(joints.bodyA[joint]);
        RigidBody b = pool.handle(joints.bodyB[joint]);
        JointFrame frameA =
                new JointFrame(joints.anchorAX[joint], joints.anchorAY[joint], joints.axisA[joint]);
        JointFrame frameB =
                new JointFrame(joints.anchorBX[joint], joints.anchorBY[joint], joints.axisB[joint]);
        JointSettings settings = readSettings(joint);
        double[] p = parameters(joint);
        return switch (joints.kindOf(joint)) {
            case REVOLUTE -> new RevoluteJoint(a, b, frameA, frameB, settings);
            case PRISMATIC -> new PrismaticJoint(a, b, frameA, frameB, settings);
            case WELD -> new WeldJoint(a, b, frameA, frameB, settings);
            case WHEEL -> new WheelJoint(a, b, frameA, frameB, settings);
            case DISTANCE -> new DistanceJoint(a, b, frameA, frameB, p[0], settings);
            case MOTOR -> new MotorJoint(a, b, p[0], p[1], p[2], p[3], p[4], settings);
            case MOUSE ->
                    new MouseJoint(a, b, frameB, p[0], p[1], p[JointStore.MOST_FORCE], settings);
            case GEAR ->
                    new GearJoint(
                            pool.joint(joints.firstGeared[joint]),
                            pool.joint(joints.secondGeared[joint]),
                            p[JointStore.RATIO],
                            settings);
            case PULLEY ->
                    new PulleyJoint(
                            a, b, frameA, frameB, p[2], p[3], p[4], p[5], p[0], p[1], settings);
            case FILTER -> new FilterJoint(a, b);
        };
    }

    private double[] parameters(int joint) {
        double[] all = new double[JointStore.PARAMETERS];
        for (int i = 0; i < all.length; i++) {
            all[i] = joints.parameter[i][joint];
        }
        return all;
    }

    private JointSettings readSettings(int joint) {
        return new JointSettings(
                new JointLimits(joints.lower[joint], joints.upper[joint], joints.elasticity[joint]),
                new JointMotor(joints.motorSpeed[joint], joints.motorMost[joint]),
                new JointSpring(joints.hertz[joint], joints.dampingRatio[joint]),
                joints.meets[joint],
                joints.breakForce[joint],
                joints.breakTorque[joint]);
    }
}
