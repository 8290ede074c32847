package rigibo.frontend.demo;

import rigibo.backend.Joint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Logarithm;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.ghost.Metres;
import rigibo.frontend.scene.joint.JointPen;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Choice;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Widget;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;

/** Joints: a pendulum whose period is known, two in chaos, a chain that must not stretch. */
final class PendulumDemo implements Demo {

    private static final String NOTHING = "–";

    /**
     * Energy, per joule of the chain's weight times its length, below which the chain hangs at
     * rest.
     */
    private static final double STILL = 1e-6;

    /** Number of straight pieces of the arc that the bob is expected to swing along. */
    private static final int ARC_PIECES = 48;

    /**
     * Initial mass ratio of a chain, as a power of ten: the weight equals 10³ links. Two bobs begin
     * equal.
     */
    private static final double HEAVY = 3;

    /** Radius of the pins at both ends of a rod, m. */
    private static final double PIN = 0.06;

    private final Words words;
    private final Trail trail = new Trail();
    private final Trail ghostTrail = new Trail();
    private Workbench bench;
    private Hang hang;
    private Swing swing;
    private Hang.Kind kind = Hang.Kind.SINGLE;
    private double length = 1.6;
    private double degrees = 60;
    private double power;
    private double energyAtFirst;

    PendulumDemo(Words words) {
        this.words = words;
    }

    /** How the menu lists it. */
    static SceneEntry entry() {
        return SceneEntry.of("pendulum", director -> new DemoScene(director, PendulumDemo::new));
    }

    @Override
    public String name() {
        return "pendulum";
    }

    @Override
    public Effects effects() {
        return Effects.of(new Gravity(0, -Hang.G), new Contacts(), new Rotation(), new Joints());
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new Gravity(0, -Hang.G), words.of("pendulum.gravity")),
                new EffectReason(new Contacts(), words.of("pendulum.contacts")),
                new EffectReason(new Rotation(), words.of("pendulum.rotation")),
                new EffectReason(new Joints(), words.of("pendulum.joints")),
                new EffectReason(new Friction(), words.of("pendulum.friction")));
    }

    @Override
    public Camera camera() {
        return new Camera(-1.42, 0.58, 95);
    }

    @Override
    public Camera cameraUpright() {
        return new Camera(0, 0.58, 95);
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        lay();
    }

    private void lay() {
        if (hang != null) {
            hang.remove();
        }
        double ratio = Logarithm.pow(10, power);
        hang = new Hang(bench, kind, length, Angle.ofDegrees(degrees), ratio);
        swing = new Swing(hang.last(), length);
        trail.clear();
        ghostTrail.clear();
        energyAtFirst = hang.energy();
    }

    @Override
    public List<Widget> widgets() {
        return List.of(
                new Choice(
                        words,
                        "pendulum.what",
                        Arrays.stream(Hang.Kind.values()).map(any -> words.of(any.key)).toList(),
                        () -> kind.ordinal(),
                        this::choose),
                new Slider(
                        words, "pendulum.amplitude", "%.0f°", 0, 179, 1, () -> degrees, this::turn),
                new Slider(
                        words, "pendulum.length", "%.1f m", 0.4, 2, 0.1, () -> length, this::size),
                new Slider(
                        words, "pendulum.ratio", this::times, 0, 4, 0.5, () -> power, this::weigh),
                new Button(words.of("pendulum.again"), this::lay),
                new Readout(words.of("pendulum.predicted"), () -> seconds(predicted())),
                new Readout("", () -> Swing.FORMULA),
                new Readout(words.of("pendulum.measured"), () -> seconds(measured())),
                new Readout(words.of("pendulum.error"), this::error),
                new Readout(words.of("pendulum.pull"), () -> newtons(pull())),
                new Readout("", () -> isSwing() ? Swing.PULL : Hang.PULL),
                new Readout(words.of("pendulum.tension"), () -> newtons(tension())),
                new Readout(words.of("pendulum.energy"), this::energy),
                new Readout(words.of("pendulum.drift"), this::drift),
                new Readout(words.of("pendulum.stretch"), this::stretch));
    }

    /** The multiple that a power of ten is, with a decimal where rounding would show. */
    private String times(double power) {
        double ratio = Logarithm.pow(10, power);
        return words.number(ratio > 1 && ratio < 10 ? "%.1f ×" : "%,.0f ×", ratio);
    }

    private void choose(int number) {
        kind = Hang.Kind.values()[number];
        power = kind == Hang.Kind.CHAIN ? HEAVY : 0;
        lay();
    }

    private void turn(double wanted) {
        degrees = wanted;
        lay();
    }

    private void size(double wanted) {
        length = wanted;
        lay();
    }

    private void weigh(double wanted) {
        power = wanted;
        lay();
    }

    @Override
    public boolean wantsGhost() {
        return kind == Hang.Kind.DOUBLE;
    }

    private boolean isFree() {
        return hang.isWhole() && !bench.isHeld() && bench.pool().effects().declares(Gravity.class);
    }

    private boolean isSwing() {
        return kind == Hang.Kind.SINGLE && isFree();
    }

    /**
     * Period by the elliptic integral, s, if there is a single pendulum and the pointer does not
     * hold it.
     */
    OptionalDouble predicted() {
        boolean moves = isSwing() && swing.share() > 0 && swing.share() != 1;
        return moves ? OptionalDouble.of(swing.predicted()) : OptionalDouble.empty();
    }

    /** Measured time between two passages, s. */
    OptionalDouble measured() {
        return isSwing() ? swing.measured() : OptionalDouble.empty();
    }

    /**
     * Force that the pin must carry, N: the pull of a swinging bob, or the weight of all that hangs
     * at rest.
     */
    OptionalDouble pull() {
        if (isSwing()) {
            return OptionalDouble.of(swing.pull());
        }
        boolean hangs =
                isFree()
                        && kind == Hang.Kind.CHAIN
                        && hang.energy() < STILL * hang.weight() * hang.length;
        return hangs ? OptionalDouble.of(hang.weight()) : OptionalDouble.empty();
    }

    OptionalDouble tension() {
        return hang.isWhole() ? OptionalDouble.of(hang.tension()) : OptionalDouble.empty();
    }

    /** The pendulum as it hangs. */
    Hang hang() {
        return hang;
    }

    /** Change of the energy, relative to the initial energy. */
    double energyDrift() {
        double least = STILL * hang.weight() * hang.length;
        return (hang.energy() - energyAtFirst) / Math.max(least, energyAtFirst);
    }

    private String error() {
        OptionalDouble predicted = predicted();
        OptionalDouble measured = measured();
        if (predicted.isEmpty() || measured.isEmpty()) {
            return NOTHING;
        }
        return power(Math.abs(measured.getAsDouble() / predicted.getAsDouble() - 1));
    }

    private String seconds(OptionalDouble value) {
        return words(value, "%.6f s");
    }

    private String newtons(OptionalDouble value) {
        return words(value, "%.3f N");
    }

    private String words(OptionalDouble value, String format) {
        return value.isPresent() ? words.number(format, value.getAsDouble()) : NOTHING;
    }

    private String power(double value) {
        return words.number("%.1e", value);
    }

    private String energy() {
        return words.number("%.4f J", hang.energy());
    }

    private String drift() {
        return isFree() ? words.number("%+.1e", energyDrift()) : NOTHING;
    }

    private String stretch() {
        return hang.isWhole() ? Metres.words(words, hang.stretch() * hang.length) : NOTHING;
    }

    /**
     * Hangs the pendulum up again once joints are declared again, because undeclaring them removed
     * all joints.
     */
    @Override
    public void beforeStep(Workbench on) {
        if (!hang.isWhole() && on.pool().effects().declares(Joints.class)) {
            lay();
        }
    }

    @Override
    public void afterStep(Workbench on) {
        swing.afterStep();
        if (!isFree()) {
            swing.begin();
            energyAtFirst = hang.energy();
        }
        RigidBody last = hang.last();
        trail.add(last.x(), last.y());
        if (on.ghost() == null) {
            ghostTrail.clear();
        } else {
            RigidBody twin = on.ghost().twin(last);
            ghostTrail.add(twin.x(), twin.y());
        }
    }

    @Override
    public void draw(Workbench on, Canvas canvas) {
        if (kind == Hang.Kind.DOUBLE) {
            ghostTrail.draw(on.camera(), canvas, Color.TEXT);
            trail.draw(on.camera(), canvas, Color.BRASS);
        } else if (isSwing()) {
            drawReach(on.camera(), canvas);
        }
        if (kind != Hang.Kind.CHAIN && hang.isWhole()) {
            drawRods(new JointPen(canvas, on.camera()));
        }
    }

    /** Draws the rods, which are no bodies. */
    private void drawRods(JointPen pen) {
        for (int i = 0; i < hang.bodies.size(); i++) {
            RigidBody bob = hang.bodies.get(i);
            Joint hinge = hang.joints.get(i);
            pen.rod(hinge.xB(), hinge.yB(), bob.x(), bob.y());
        }
        for (int i = 0; i < hang.bodies.size(); i++) {
            RigidBody bob = hang.bodies.get(i);
            Joint hinge = hang.joints.get(i);
            pen.pin(hinge.xB(), hinge.yB(), PIN, bob.angle());
            pen.pin(bob.x(), bob.y(), PIN, bob.angle());
        }
    }

    /** Draws how far the bob will swing, by its energy. */
    private void drawReach(Camera camera, Canvas canvas) {
        double reach = swing.amplitude();
        double radius = hang.length;
        double[] arc = new double[2 * (ARC_PIECES + 1)];
        for (int i = 0; i <= ARC_PIECES; i++) {
            double angle = reach * (2.0 * i / ARC_PIECES - 1);
            arc[2 * i] = camera.screenX(radius * Angle.sin(angle));
            arc[2 * i + 1] = camera.screenY(-radius * Angle.cos(angle));
        }
        canvas.curve(arc, ARC_PIECES + 1, 1.5, Color.BRASS.alpha(0.45));
        if (reach < Math.PI) {
            canvas.disc(arc[0], arc[1], 4, Color.BRASS);
            canvas.disc(arc[2 * ARC_PIECES], arc[2 * ARC_PIECES + 1], 4, Color.BRASS);
        }
    }
}
