package rigibo.frontend.demo;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Toggle;
import rigibo.frontend.scene.widget.Widget;

import java.util.List;

/** Rotation: a wheel on a ramp, driven or braked, rolling or slipping as the formula predicts. */
final class WheelDemo implements Demo {

    private final Words words;

    private static final double GRAVITY = 9.81;
    private static final double RADIUS = 0.45;
    private static final double RAMP_LENGTH = 18;
    private static final double MASS = 10;

    /** Largest torque of the hand that brakes, N·m. */
    private static final double MOST_BRAKE = 40;

    /** Difference of speed between rim and ramp from which on the wheel slips, m/s. */
    private static final double SLIPS = 1e-4;

    private Workbench bench;
    private RigidBody ramp;
    private RigidBody wheel;
    private boolean isHoop;
    private boolean isBraking;
    private double slope = 15;
    private double friction = 0.6;
    private double lever;
    private double torque;
    private double thrust;
    private double brake;
    private double lastSpeed;
    private double predicted;
    private double measured;

    WheelDemo(Words words) {
        this.words = words;
    }

    /** How the menu lists it. */
    static SceneEntry entry() {
        return SceneEntry.of("wheel", director -> new DemoScene(director, WheelDemo::new));
    }

    @Override
    public String name() {
        return "wheel";
    }

    @Override
    public Effects effects() {
        return Effects.of(
                new Gravity(0, -GRAVITY),
                new Contacts(),
                new Rotation(),
                new Friction(),
                new RollingResistance(),
                new Thrust(),
                new ContinuousImpacts());
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new Gravity(0, -GRAVITY), words.of("wheel.gravity")),
                new EffectReason(new Contacts(), words.of("wheel.contacts")),
                new EffectReason(new Rotation(), words.of("wheel.rotation")),
                new EffectReason(new Friction(), words.of("wheel.friction-why")),
                new EffectReason(new RollingResistance(), words.of("wheel.rolling-why")),
                new EffectReason(new Thrust(), words.of("wheel.thrust-why")),
                new EffectReason(new ContinuousImpacts(), words.of("wheel.impacts")),
                new EffectReason(new Restitution(), words.of("wheel.restitution")));
    }

    @Override
    public Camera camera() {
        return new Camera(-2.4, 2.7, 50);
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        lay();
    }

    /** Lays the ramp anew and puts the wheel at its upper end. */
    private void lay() {
        if (ramp != null) {
            bench.remove(ramp);
            bench.remove(wheel);
        }
        double angle = -Angle.ofDegrees(slope);
        ramp =
                bench.add(
                        BodyDefinition.fixed(Polygon.box(RAMP_LENGTH, 0.6))
                                .angle(angle)
                                .material(new Material(1, friction, 0)),
                        Skin.WOOD);
        double along = -3.4;
        double above = 0.3 + RADIUS;
        double x = along * Angle.cos(angle) - above * Angle.sin(angle);
        double y = along * Angle.sin(angle) + above * Angle.cos(angle);
        BodyDefinition made =
                BodyDefinition.dynamic(new Circle(RADIUS))
                        .at(x, y)
                        .mass(MASS)
                        .inertia(k() * MASS * RADIUS * RADIUS)
                        .material(new Material(1, friction, 0).rollingResistance(lever));
        wheel = bench.add(made, Skin.BALL);
        lastSpeed = 0;
    }

    @Override
    public List<Widget> widgets() {
        return List.of(
                new Slider(words, "wheel.ramp", "%.0f°", 0, 45, 1, () -> slope, this::tilt),
                new Slider(words, "wheel.grip", "%.2f", 0, 1, 0.05, () -> friction, this::grip),
                new Slider(
                        words,
                        "wheel.rolling",
                        "%.0f mm",
                        0,
                        20,
                        1,
                        () -> 1000 * lever,
                        this::resist),
                new Slider(
                        words,
                        "wheel.torque",
                        "%.0f Nm",
                        -60,
                        60,
                        5,
                        () -> torque,
                        v -> torque = v),
                new Slider(
                        words,
                        "wheel.thrust",
                        "%.0f N",
                        -120,
                        120,
                        10,
                        () -> thrust,
                        v -> thrust = v),
                new Toggle(words, "wheel.brake", () -> isBraking, () -> isBraking = !isBraking),
                new Toggle(words, "wheel.hoop", () -> isHoop, this::flip),
                new Button(words.of("wheel.again"), this::lay),
                new Readout(words.of("wheel.speed"), () -> metres(speed())),
                new Readout(words.of("wheel.rim"), () -> metres(rim())),
                new Readout(words.of("wheel.slip"), () -> metres(speed() - rim())),
                new Readout(words.of("wheel.used"), this::share),
                new Readout(words.of("wheel.predicted"), () -> acceleration(predicted)),
                new Readout("", this::formula),
                new Readout(words.of("wheel.measured"), () -> acceleration(measured)));
    }

    private void tilt(double degrees) {
        slope = degrees;
        lay();
    }

    private void grip(double coefficient) {
        friction = coefficient;
        lay();
    }

    private void resist(double millimetres) {
        lever = millimetres / 1000;
        lay();
    }

    private void flip() {
        isHoop = !isHoop;
        lay();
    }

    /** Speed down the ramp, m/s. */
    private double speed() {
        double angle = ramp.angle();
        return wheel.velocityX() * Angle.cos(angle) + wheel.velocityY() * Angle.sin(angle);
    }

    private double rim() {
        return -wheel.angularVelocity() * RADIUS;
    }

    /** I/(m·r²): ½ for a disc, 1 for a hoop. */
    private double k() {
        return isHoop ? 1 : 0.5;
    }

    /** Acceleration down the ramp by everything but friction, m/s². */
    private double pull() {
        return GRAVITY * Angle.sin(Angle.ofDegrees(slope)) + thrust / MASS;
    }

    /** Largest acceleration by friction, m/s². */
    private double grip() {
        return friction * GRAVITY * Angle.cos(Angle.ofDegrees(slope));
    }

    /**
     * The formula of the acceleration down the ramp with what is switched on: F is the thrust, τ
     * the torque, brake included, and c the rolling resistance, beside which … is all of these.
     */
    private String formula() {
        if (slips()) {
            return thrust == 0 ? "g·sinα ± µ·g·cosα" : "g·sinα + F/m ± µ·g·cosα";
        }
        if (lever > 0) {
            return "(… − c·g·cosα/r)/(1 + k)";
        }
        boolean isDriven = torque != 0 || thrust != 0 || isBraking;
        return isDriven ? "(g·sinα + F/m + τ/mr)/(1+k)" : "g·sinα/(1 + k)";
    }

    private boolean slips() {
        return Math.abs(speed() - rim()) > SLIPS;
    }

    /**
     * Torque that accelerates the wheel's turning, N·m: about the contact while it rolls, and about
     * the centre, where friction turns it, while it slips.
     */
    private double turning() {
        double byRamp = slips() ? Math.signum(speed() - rim()) * grip() : pull();
        return torque + byRamp * MASS * RADIUS;
    }

    /** Torque that stops the wheel within a step, at most that of a strong hand. */
    private double brake() {
        double inertia = (slips() ? k() : 1 + k()) * MASS * RADIUS * RADIUS;
        double stop = -turning() - rim() / RADIUS * inertia / Scene.STEP;
        return Math.max(-MOST_BRAKE, Math.min(MOST_BRAKE, stop));
    }

    /**
     * Acceleration down the ramp, m/s². A rolling wheel has τ/(m·r·(1 + k)), with τ the torque
     * about the contact less the rolling resistance c·N, if the friction for that is no more than
     * μ·g·cos; otherwise the wheel slips.
     */
    private double predicted() {
        double grip = grip();
        if (slips()) {
            return pull() - Math.signum(speed() - rim()) * grip;
        }
        double driven = turning() + brake;
        double resisted = lever * MASS * GRAVITY * Angle.cos(Angle.ofDegrees(slope));
        double way = Math.abs(rim()) > SLIPS ? Math.signum(rim()) : Math.signum(driven);
        boolean stands = way * driven < resisted && Math.abs(rim()) <= SLIPS;
        double left = stands ? 0 : driven - way * resisted;
        double rolling = left / (MASS * RADIUS * (1 + k()));
        double needed = rolling - pull();
        return Math.abs(needed) <= grip ? rolling : pull() + Math.signum(needed) * grip;
    }

    private String share() {
        double used = grip() > 0 ? Math.min(1, Math.abs(measured - pull()) / grip()) : 0;
        return words.number("%.0f %%", 100 * used);
    }

    /** Acceleration down the ramp in the last step, m/s²: by the formula, and as measured. */
    double[] accelerations() {
        return new double[] {predicted, measured};
    }

    @Override
    public void beforeStep(Workbench on) {
        double angle = ramp.angle();
        brake = isBraking ? brake() : 0;
        predicted = predicted();
        if (on.pool().effects().declares(Thrust.class)) {
            drive(angle);
        }
    }

    private void drive(double angle) {
        double fx = thrust * Angle.cos(angle);
        double fy = thrust * Angle.sin(angle);
        bench.act(wheel, any -> any.applyTorque(-torque - brake));
        bench.act(wheel, any -> any.applyForce(fx, fy, any.x(), any.y()));
    }

    @Override
    public void afterStep(Workbench on) {
        measured = (speed() - lastSpeed) / Scene.STEP;
        lastSpeed = speed();
        if (wheel.y() < -12 || Math.abs(wheel.x()) > 30) {
            lay();
        }
    }

    @Override
    public void draw(Workbench on, Canvas canvas) {
        Camera camera = on.camera();
        double x = camera.screenX(wheel.x());
        double y = camera.screenY(wheel.y());
        double length = 12 * speed();
        double angle = ramp.angle();
        double tipX = x + length * Angle.cos(angle);
        double tipY = y - length * Angle.sin(angle);
        canvas.line(x, y, tipX, tipY, 4, Color.GOOD);
        canvas.disc(tipX, tipY, 6, Color.GOOD);
    }

    private String metres(double speed) {
        return Fixed.words(words, "%.3f m/s", speed);
    }

    private String acceleration(double value) {
        return Fixed.words(words, "%.3f m/s²", value);
    }
}
