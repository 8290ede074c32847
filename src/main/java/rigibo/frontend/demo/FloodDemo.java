package rigibo.frontend.demo;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Toggle;
import rigibo.frontend.scene.widget.Widget;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.SplittableRandom;

/**
 * How many bodies the pool can handle, and elasticity: bodies are poured into a trough until it is
 * full.
 */
final class FloodDemo implements Demo {

    private final Words words;

    /** Inner sides of the trough, m; to its right the reference ball has a shaft of its own. */
    private static final double LEFT = -11;

    private static final double RIGHT = 8;
    private static final double SHAFT = 10.2;
    private static final Material STONE = new Material(1, 0.4, 0);
    private static final int MOST_BODIES = 8000;
    private static final Skin[] SKINS = {Skin.BALL, Skin.RUBBER, Skin.ICE, Skin.RIGIBO};

    /** The hatch in the floor, through which the trough drains, m. */
    private static final double HATCH_LEFT = -4;

    private static final double HATCH_RIGHT = 1;
    private static final double FLOOR_END = 12;

    private static final int POURED_PER_TURN = 12;
    private static final double HOSE_WIDTH = 1.2;
    private static final double NOZZLE_HEIGHT = 20.5;

    private static final int SEED = 7;

    private SplittableRandom random = new SplittableRandom(SEED);
    private final Deque<RigidBody> drops = new ArrayDeque<>();
    private final Crews crews;
    private Workbench bench;
    private RigidBody hatch;
    private boolean isHosing;
    private double wanted = 600;
    private double elasticity = 0.5;
    private final ReferenceBall reference = new ReferenceBall(SHAFT, () -> elasticity);
    private double size = 0.14;
    private boolean isBoxes;
    private boolean hasFriction;
    private boolean hasSleep;

    FloodDemo(Words words) {
        this(words, Runtime.getRuntime().availableProcessors());
    }

    /** A flood on a machine with a number of processors. */
    FloodDemo(Words words, int processors) {
        this.words = words;
        crews = new Crews(words, processors);
    }

    /** How the menu lists it. */
    static SceneEntry entry() {
        return SceneEntry.of("flood", director -> new DemoScene(director, FloodDemo::new));
    }

    @Override
    public String name() {
        return "flood";
    }

    /** Declares rotation only if something would turn; discs without friction do not. */
    @Override
    public Effects effects() {
        Effects effects =
                Effects.of(
                        new Gravity(0, -9.81),
                        new Contacts(),
                        new Restitution(),
                        new ContinuousImpacts());
        if (hasFriction) {
            effects = effects.with(new Friction());
        }
        if (hasFriction || isBoxes) {
            effects = effects.with(new Rotation());
        }
        return hasSleep ? effects.with(new Sleep()) : effects;
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new Gravity(0, -9.81), words.of("flood.gravity")),
                new EffectReason(new Contacts(), words.of("flood.contacts")),
                new EffectReason(new Rotation(), words.of("flood.rotation")),
                new EffectReason(new Friction(), words.of("flood.friction-why")),
                new EffectReason(new Restitution(), words.of("flood.restitution")),
                new EffectReason(new ContinuousImpacts(), words.of("flood.impacts")),
                new EffectReason(new Sleep(), words.of("flood.sleep-why")));
    }

    @Override
    public Camera camera() {
        return new Camera(0, 8.4, 30);
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        floor(-FLOOR_END, HATCH_LEFT);
        floor(HATCH_RIGHT, FLOOR_END);
        hatch = floor(HATCH_LEFT, HATCH_RIGHT);
        for (double x : new double[] {LEFT - 0.3, RIGHT + 0.3}) {
            bench.add(
                    BodyDefinition.fixed(Polygon.box(0.6, 80)).at(x, 39).material(STONE),
                    Skin.STONE);
        }
        reference.drop(bench);
    }

    private RigidBody floor(double from, double to) {
        return bench.add(
                BodyDefinition.fixed(Polygon.box(to - from, 1))
                        .at((from + to) / 2, -0.5)
                        .material(STONE),
                Skin.STONE);
    }

    @Override
    public List<Widget> widgets() {
        return List.of(
                new Slider(
                        words, "flood.count", "%.0f", 0, 4000, 100, () -> wanted, v -> wanted = v),
                new Slider(
                        words,
                        "flood.elasticity",
                        "%.2f",
                        0,
                        1,
                        0.05,
                        () -> elasticity,
                        v -> elasticity = v),
                new Slider(
                        words, "flood.size", "%.2f m", 0.1, 0.4, 0.02, () -> size, v -> size = v),
                new Toggle(words, "flood.boxes", () -> isBoxes, () -> switchTo(isBoxes = !isBoxes)),
                new Toggle(
                        words,
                        "flood.friction",
                        () -> hasFriction,
                        () -> switchTo(hasFriction = !hasFriction)),
                new Toggle(
                        words, "flood.sleep", () -> hasSleep, () -> switchTo(hasSleep = !hasSleep)),
                new Toggle(words, "flood.hose", () -> isHosing, () -> isHosing = !isHosing),
                new Toggle(words, "flood.drain", () -> hatch == null, this::drain),
                crews.choice(),
                new Button(words.of("flood.search"), this::search),
                new Readout(words.of("flood.bodies"), () -> "" + drops.size()),
                new Readout(words.of("flood.by"), crews::numbers),
                new Readout(words.of("flood.p50"), crews::medians),
                new Readout(words.of("flood.late"), crews::lateSteps),
                new Readout(words.of("flood.drawn"), () -> crews.held(Crew::heldDrawn)),
                new Readout(words.of("flood.alone"), () -> crews.held(Crew::heldAlone)),
                new Readout(words.of("flood.overlap"), this::overlap),
                new Readout(words.of("flood.rise"), () -> reference.predictedIn(words)),
                new Readout("", () -> ReferenceBall.FORMULA),
                new Readout("  " + words.of("flood.seen"), () -> reference.seenIn(words)));
    }

    /** Changes the declared effects; the pool uses them from the next step on. */
    private void switchTo(boolean ignored) {
        bench.pool().effects(effects());
    }

    /** Opens the hatch in the floor, or closes it. */
    private void drain() {
        if (hatch == null) {
            hatch = floor(HATCH_LEFT, HATCH_RIGHT);
        } else {
            bench.remove(hatch);
            hatch = null;
        }
    }

    /**
     * Pours until a step alone no longer fits into a frame; with drawing, the limit is reached
     * earlier.
     */
    private void search() {
        crews.search();
        pourAnew();
    }

    /** Empties the trough and pours the same bodies again, so that all crews get the same flood. */
    private void pourAnew() {
        drops.forEach(bench::remove);
        drops.clear();
        random = new SplittableRandom(SEED);
        isHosing = false;
        if (hatch == null) {
            drain();
        }
    }

    @Override
    public void beforeStep(Workbench on) {
        on.pool().workers(crews.present().workers);
        if (crews.isSearching()) {
            wanted = drops.size() + POURED_PER_TURN;
        }
        for (int i = 0; i < POURED_PER_TURN && (isHosing || drops.size() < wanted); i++) {
            pour();
        }
        while (drops.size() > Math.min(wanted, MOST_BODIES)) {
            bench.remove(drops.removeFirst());
        }
        if (hatch == null) {
            removeDrained();
        }
    }

    private void removeDrained() {
        drops.removeIf(
                drop -> {
                    boolean isGone = drop.y() < -2;
                    if (isGone) {
                        bench.remove(drop);
                    }
                    return isGone;
                });
    }

    /** Adds a body from above or from the hose, unless it would overlap another one. */
    private void pour() {
        double middle = isHosing ? bench.pointerX() : (LEFT + RIGHT) / 2;
        double width = isHosing ? HOSE_WIDTH : RIGHT - LEFT;
        double height = isHosing ? Math.min(bench.pointerY(), NOZZLE_HEIGHT) : NOZZLE_HEIGHT;
        double room = 1.3 * size;
        double x = middle + (random.nextDouble() - 0.5) * width;
        double y = Math.max(room, height) + 2 * random.nextDouble();
        x = Math.max(LEFT + room, Math.min(RIGHT - room, x));
        if (isFree(new Aabb(x - room, y - room, x + room, y + room))) {
            Shape shape = isBoxes ? Polygon.box(1.7 * size, 1.7 * size) : new Circle(size);
            drops.add(
                    bench.add(
                            BodyDefinition.dynamic(shape)
                                    .at(x, y)
                                    .velocity(0, -6)
                                    .material(new Material(1, 0.4, elasticity)),
                            isBoxes ? Skin.RIGIBO : SKINS[drops.size() % 3]));
        }
    }

    private boolean isFree(Aabb place) {
        boolean[] isTaken = new boolean[1];
        bench.pool().overlapping(place, body -> isTaken[0] = true);
        return !isTaken[0];
    }

    @Override
    public void afterStep(Workbench on) {
        reference.afterStep(on);
        boolean isFull = drops.size() >= MOST_BODIES;
        if (crews.goesOnWithTheNext(on.pool().report(), drops.size(), isFull)) {
            pourAnew();
        }
    }

    @Override
    public void drawn(long nanos) {
        crews.present().times.drawing(nanos);
    }

    @Override
    public void draw(Workbench on, Canvas canvas) {
        reference.draw(on.camera(), canvas);
    }

    private String overlap() {
        double metres = bench.pool().report().deepestOverlap();
        return words.number("%.1f mm", 1000 * metres);
    }
}
