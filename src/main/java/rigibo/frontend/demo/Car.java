package rigibo.frontend.demo;

import rigibo.backend.ContactView;
import rigibo.backend.Joint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.WheelJoint;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Length;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Skin;

import java.util.List;

/** A chassis on two sprung wheels, with a load on it. */
final class Car {

    static final double G = 9.81;
    static final double WHEEL = 0.36;

    /**
     * The share of the load on an axle; a is the distance of the centre of mass from the other
     * axle.
     */
    static final String FORMULA = "N = G·a/L";

    private static final double CHASSIS_MASS = 300;
    private static final double WHEEL_MASS = 15;
    private static final double AXLE = 0.85;

    /** Height of the axles below the middle of the chassis, m. */
    private static final double CLEARANCE = 0.34;

    private static final double GRIP = 0.9;

    /**
     * Steps over which wheel loads are averaged, because a wheel that rolls on a bridge trembles.
     */
    private static final int STEPS = 12;

    private static final int REAR = 0;
    private static final int FRONT = 1;

    /** Values that the controls set. */
    static final class Settings {
        double speed = 12;
        double torque = 500;
        double hertz = 8;
        double damping = 0.7;
        double load = 60;
        double place = -0.4;
        boolean isAllDriven;
    }

    final RigidBody chassis;
    final RigidBody[] wheels = new RigidBody[2];
    private final Workbench bench;
    private final Settings settings;
    private final RigidBody load;
    private final Joint[] struts = new Joint[2];
    private final Joint weld;
    private final double[][] impulses = new double[2][STEPS];
    private int step;

    /** Puts a car on its wheels where the ground is level, m. */
    Car(Workbench bench, double x, double ground, Settings settings) {
        this.bench = bench;
        this.settings = settings;
        double y = ground + WHEEL + CLEARANCE;
        Polygon hull =
                Polygon.of(
                        -1.2, -0.22, 1.2, -0.22, 1.25, 0.05, 0.55, 0.42, -0.75, 0.42, -1.25, 0.1);
        chassis =
                bench.add(
                        BodyDefinition.dynamic(hull)
                                .at(x, y)
                                .mass(CHASSIS_MASS)
                                .material(new Material(1, 0.4, 0)),
                        Skin.RIGIBO);
        for (int i = 0; i < 2; i++) {
            wheels[i] = wheel(x + (i == REAR ? -AXLE : AXLE), ground + WHEEL);
            struts[i] = bench.join(strut(i));
        }
        double top = chassis.originY() + 0.42;
        load =
                bench.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.34))
                                .at(x + settings.place, top + 0.17)
                                .mass(settings.load),
                        Skin.IRON);
        weld = bench.join(WeldJoint.at(chassis, load, load.x(), top));
        drive();
    }

    private RigidBody wheel(double x, double y) {
        return bench.add(
                BodyDefinition.dynamic(new Circle(WHEEL))
                        .at(x, y)
                        .mass(WHEEL_MASS)
                        .material(new Material(1, GRIP, 0)),
                Skin.BALL);
    }

    private WheelJoint strut(int i) {
        double upwards = Math.PI / 2;
        WheelJoint plain = WheelJoint.at(chassis, wheels[i], wheels[i].x(), wheels[i].y(), upwards);
        return (WheelJoint) plain.limits(-0.2, 0.2).spring(settings.hertz, settings.damping);
    }

    boolean isWhole() {
        return weld.isAlive() && struts[REAR].isAlive() && struts[FRONT].isAlive();
    }

    /** Sets motors and springs to what the controls say. */
    void drive() {
        for (int i = 0; i < 2; i++) {
            boolean isDriven = i == REAR || settings.isAllDriven;
            double speed = -settings.speed;
            double torque = isDriven ? settings.torque : 0;
            double hertz = settings.hertz;
            double damping = settings.damping;
            bench.act(struts[i], any -> any.motor(speed, torque));
            bench.act(struts[i], any -> any.spring(hertz, damping));
        }
    }

    void remove() {
        for (RigidBody body : List.of(load, wheels[REAR], wheels[FRONT], chassis)) {
            bench.remove(body);
        }
    }

    /** Stores the forces with which the ground pressed on the wheels in the last step. */
    void afterStep() {
        step = (step + 1) % STEPS;
        impulses[REAR][step] = 0;
        impulses[FRONT][step] = 0;
        bench.pool().forEachContact(this::note);
    }

    private void note(ContactView contact) {
        for (int i = 0; i < 2; i++) {
            if (contact.a == wheels[i] || contact.b == wheels[i]) {
                impulses[i][step] += contact.impulse;
            }
        }
    }

    /** Load on a wheel, N, averaged over the last fifth of a second. */
    private double measured(int wheel) {
        double sum = 0;
        for (double impulse : impulses[wheel]) {
            sum += impulse;
        }
        return sum / STEPS / Scene.STEP;
    }

    double measuredRear() {
        return measured(REAR);
    }

    double measuredFront() {
        return measured(FRONT);
    }

    /**
     * Load on a wheel by the moments about the other wheel's contact, N. Forces along the line
     * through both contacts have no moment, so that N times the distance of the wheels is m·g times
     * the weight's lever.
     */
    double predictedRear() {
        return weight() * (wheels[FRONT].x() + contactX() - centreX()) / base();
    }

    double predictedFront() {
        return weight() * (centreX() - wheels[REAR].x() - contactX()) / base();
    }

    /** From a wheel's middle to where it touches the ground, m to the right. */
    private double contactX() {
        return WHEEL * (wheels[FRONT].y() - wheels[REAR].y()) / base();
    }

    private double base() {
        return Length.hypot(
                wheels[FRONT].x() - wheels[REAR].x(), wheels[FRONT].y() - wheels[REAR].y());
    }

    double weight() {
        return G * (chassis.mass() + load.mass() + 2 * WHEEL_MASS);
    }

    private double centreX() {
        double sum = chassis.mass() * chassis.x() + load.mass() * load.x();
        return (sum + WHEEL_MASS * (wheels[REAR].x() + wheels[FRONT].x())) * G / weight();
    }

    /** Slope of the ground under the car, rad; positive uphill. */
    double slope() {
        return Angle.atan2(
                wheels[FRONT].y() - wheels[REAR].y(), wheels[FRONT].x() - wheels[REAR].x());
    }

    /** m/s to the right. */
    double speed() {
        return chassis.velocityX();
    }

    /** Speed of the driven wheel's rim minus that of the car, m/s. */
    double slip() {
        return -wheels[REAR].angularVelocity() * WHEEL
                - Math.copySign(
                        Length.hypot(wheels[REAR].velocityX(), wheels[REAR].velocityY()),
                        wheels[REAR].velocityX());
    }
}
