package rigibo.frontend.demo;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Angle;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.ghost.Metres;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Toggle;
import rigibo.frontend.scene.widget.Widget;

import java.util.List;

/** Joints at work: a car on springs crosses a hill, a bridge and a see-saw. */
final class CarDemo implements Demo {

    private static final String NOTHING = "–";

    /** Position of the car in the window, m from the middle at the first scale. */
    private static final double AHEAD = 2.6;

    private static final double BELOW = 1.6;
    private static final double SCALE = 52;

    /** Speed that one key press adds, and the highest speed, rad/s. */
    private static final double NOTCH = 2;

    private static final double FASTEST = 20;

    /**
     * Length of an arrow per newton, px, and the distance between the two arrows of a wheel, px.
     */
    private static final double PX_PER_NEWTON = 0.03;

    private static final double BESIDE = 5;

    private final Words words;
    private final Car.Settings settings = new Car.Settings();
    private Workbench bench;
    private Track track;
    private Car car;
    private boolean isFollowed = true;

    CarDemo(Words words) {
        this.words = words;
    }

    /** How the menu lists it. */
    static SceneEntry entry() {
        return SceneEntry.of("car", director -> new DemoScene(director, CarDemo::new));
    }

    @Override
    public String name() {
        return "car";
    }

    @Override
    public Effects effects() {
        return Effects.of(
                new Gravity(0, -Car.G),
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Joints(),
                new ContinuousImpacts());
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new Gravity(0, -Car.G), words.of("car.gravity")),
                new EffectReason(new Contacts(), words.of("car.contacts")),
                new EffectReason(new Rotation(), words.of("car.rotation")),
                new EffectReason(new Friction(), words.of("car.friction")),
                new EffectReason(new Joints(), words.of("car.joints")),
                new EffectReason(new ContinuousImpacts(), words.of("car.impacts")),
                new EffectReason(new Restitution(), words.of("car.restitution")));
    }

    @Override
    public Camera camera() {
        return new Camera(-AHEAD, BELOW, SCALE);
    }

    /** More is seen of the way ahead. */
    @Override
    public Camera cameraUpright() {
        return new Camera(AHEAD, BELOW, SCALE);
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        lay();
    }

    private void lay() {
        if (track != null) {
            car.remove();
            track.remove();
        }
        track = new Track(bench);
        place();
    }

    private void again() {
        car.remove();
        place();
    }

    private void place() {
        car = new Car(bench, 0, 0, settings);
    }

    @Override
    public List<Widget> widgets() {
        return List.of(
                new Slider(
                        words,
                        "car.speed",
                        "%.0f rad/s",
                        -FASTEST,
                        FASTEST,
                        NOTCH,
                        () -> settings.speed,
                        this::drive),
                new Slider(
                        words,
                        "car.torque",
                        "%.0f Nm",
                        0,
                        800,
                        20,
                        () -> settings.torque,
                        this::push),
                new Slider(
                        words,
                        "car.springs",
                        "%.0f Hz",
                        4,
                        16,
                        1,
                        () -> settings.hertz,
                        this::spring),
                new Slider(
                        words,
                        "car.damping",
                        "%.1f",
                        0,
                        1.5,
                        0.1,
                        () -> settings.damping,
                        this::damp),
                new Slider(
                        words, "car.load", "%.0f kg", 10, 300, 10, () -> settings.load, this::load),
                new Slider(
                        words,
                        "car.place",
                        "%.1f m",
                        -0.5,
                        0.3,
                        0.1,
                        () -> settings.place,
                        this::shift),
                new Toggle(words, "car.all", () -> settings.isAllDriven, this::flip),
                new Toggle(words, "car.follow", () -> isFollowed, () -> isFollowed = !isFollowed),
                new Button(words.of("car.again"), this::again),
                new Readout(words.of("car.rear.predicted"), () -> newtons(rear()[0])),
                new Readout(words.of("car.rear.measured"), () -> newtons(rear()[1])),
                new Readout(words.of("car.front.predicted"), () -> newtons(front()[0])),
                new Readout(words.of("car.front.measured"), () -> newtons(front()[1])),
                new Readout("", () -> Car.FORMULA),
                new Readout(words.of("car.velocity"), () -> metresPerSecond(car.speed())),
                new Readout(words.of("car.slip"), () -> metresPerSecond(car.slip())),
                new Readout(words.of("car.sag"), () -> Metres.words(words, track.sag())),
                new Readout(words.of("car.pull"), this::pull),
                new Readout(words.of("car.gap"), () -> Metres.words(words, track.gap())));
    }

    private void drive(double speed) {
        settings.speed = speed;
        apply();
    }

    private void push(double torque) {
        settings.torque = torque;
        apply();
    }

    private void spring(double hertz) {
        settings.hertz = hertz;
        apply();
    }

    private void damp(double ratio) {
        settings.damping = ratio;
        apply();
    }

    private void flip() {
        settings.isAllDriven = !settings.isAllDriven;
        apply();
    }

    private void apply() {
        if (car.isWhole()) {
            car.drive();
        }
    }

    private void load(double mass) {
        settings.load = mass;
        again();
    }

    private void shift(double place) {
        settings.place = place;
        again();
    }

    /** Load on the rear wheel, N: by statics, and as measured. */
    double[] rear() {
        return new double[] {car.predictedRear(), car.measuredRear()};
    }

    /** Load on the front wheel, N: by statics, and as measured. */
    double[] front() {
        return new double[] {car.predictedFront(), car.measuredFront()};
    }

    Car car() {
        return car;
    }

    Track track() {
        return track;
    }

    private String newtons(double load) {
        return Fixed.words(words, "%.0f N", load);
    }

    private String metresPerSecond(double value) {
        return Fixed.words(words, "%.2f m/s", value);
    }

    private String pull() {
        return track.isWhole() ? newtons(track.pull()) : NOTHING;
    }

    /**
     * Rebuilds the car and the track once joints are declared again, because undeclaring them
     * removed all joints.
     */
    @Override
    public void beforeStep(Workbench on) {
        boolean isWhole = car.isWhole() && track.isWhole();
        if (!isWhole && on.pool().effects().declares(Joints.class)) {
            lay();
        } else if (car.chassis.y() < -30) {
            again();
        }
    }

    @Override
    public void afterStep(Workbench on) {
        car.afterStep();
        if (isFollowed && !on.isHeld()) {
            Camera camera = on.camera();
            double scale = camera.scale();
            double share = SCALE / scale;
            double x = car.chassis.x() + share * camera.homeX();
            camera.look(x, car.chassis.y() + share * BELOW, scale);
        }
    }

    @Override
    public void key(Workbench on, Key key) {
        if (key == Key.LEFT) {
            drive(Math.max(-FASTEST, settings.speed - NOTCH));
        } else if (key == Key.RIGHT) {
            drive(Math.min(FASTEST, settings.speed + NOTCH));
        }
    }

    @Override
    public void draw(Workbench on, Canvas canvas) {
        draw(on.camera(), canvas, car.wheels[0], rear());
        draw(on.camera(), canvas, car.wheels[1], front());
    }

    /**
     * Draws the loads as arrows that point up to the wheels: brass by statics, green as measured.
     */
    private void draw(Camera camera, Canvas canvas, RigidBody wheel, double[] loads) {
        double angle = car.slope();
        for (int i = 0; i < 2; i++) {
            double aside = i == 0 ? -BESIDE : BESIDE;
            double length = PX_PER_NEWTON * loads[i];
            double rootX = camera.screenX(wheel.x() + Car.WHEEL * Angle.sin(angle)) + aside;
            double rootY = camera.screenY(wheel.y() - Car.WHEEL * Angle.cos(angle)) + 4;
            double tailX = rootX + length * Angle.sin(angle);
            double tailY = rootY + length * Angle.cos(angle);
            Color color = i == 0 ? Color.BRASS : Color.GOOD;
            canvas.line(tailX, tailY, rootX, rootY, 4, color);
            head(canvas, rootX, rootY, angle, color);
        }
    }

    private static void head(Canvas canvas, double x, double y, double angle, Color color) {
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        double[] xy = {
            x - 5 * cos + 8 * sin,
            y + 5 * sin + 8 * cos,
            x,
            y,
            x + 5 * cos + 8 * sin,
            y - 5 * sin + 8 * cos
        };
        canvas.curve(xy, 3, 3.5, color);
    }
}
