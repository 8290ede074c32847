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
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.StepStage;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Toggle;
import rigibo.frontend.scene.widget.Widget;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/** How many bodies the pool can handle, and elasticity: a trough that is poured full. */
final class FloodDemo implements Demo {

    /** The trough's inner sides, m; right of it the reference ball has a shaft of its own. */
    private static final double LEFT = -11;

    private static final double RIGHT = 8;
    private static final double SHAFT = 10.2;
    private static final double BUDGET_MILLIS = 1000.0 / 60;
    private static final int WINDOW = 120;
    private static final int MOST_BODIES = 8000;
    private static final Skin[] SKINS = {Skin.BALL, Skin.RUBBER, Skin.ICE, Skin.RIGIBO};

    private final SplittableRandom random = new SplittableRandom(7);
    private final Deque<RigidBody> drops = new ArrayDeque<>();
    private final double[] millis = new double[WINDOW];
    private Workbench bench;
    private int turn;
    private double wanted = 600;
    private double elasticity = 0.5;
    private final ReferenceBall reference = new ReferenceBall(SHAFT, () -> elasticity);
    private double size = 0.14;
    private boolean isBoxes;
    private boolean hasFriction;
    private boolean hasSleep;
    private boolean isSearching;
    private int best;

    /** How the menu lists it. */
    static SceneEntry entry() {
        return new SceneEntry(
                "flood",
                "Flood",
                "How many bodies hold 60 Hz?",
                SceneEntry.Kind.DEMO,
                director -> new DemoScene(director, FloodDemo::new));
    }

    @Override
    public String title() {
        return "Flood";
    }

    /** Rotation only while something would turn: discs without friction do not. */
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
    public Camera camera() {
        return new Camera(0, 9.4, 30);
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        Material stone = new Material(1, 0.4, 0);
        bench.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5).material(stone), Skin.STONE);
        for (double x : new double[] {LEFT - 0.3, RIGHT + 0.3}) {
            bench.add(
                    BodyDefinition.fixed(Polygon.box(0.6, 80)).at(x, 39).material(stone),
                    Skin.STONE);
        }
        reference.drop(bench);
    }

    @Override
    public List<Widget> widgets() {
        return List.of(
                new Slider("count", "%.0f", 0, 4000, 100, () -> wanted, v -> wanted = v),
                new Slider("elasticity", "%.2f", 0, 1, 0.05, () -> elasticity, v -> elasticity = v),
                new Slider("size", "%.2f m", 0.1, 0.4, 0.02, () -> size, v -> size = v),
                new Toggle("boxes", () -> isBoxes, () -> switchTo(isBoxes = !isBoxes)),
                new Toggle(
                        "friction", () -> hasFriction, () -> switchTo(hasFriction = !hasFriction)),
                new Toggle("sleep", () -> hasSleep, () -> switchTo(hasSleep = !hasSleep)),
                new Button("drain", this::drain),
                new Button("find my maximum", () -> isSearching = true),
                new Readout("bodies", () -> "" + drops.size()),
                new Readout("p50", () -> percentile(50)),
                new Readout("p95", () -> percentile(95)),
                new Readout("p99", () -> percentile(99)),
                new Readout("holds 60 Hz", () -> isSearching ? "searching" : best + ""),
                new Readout("overlap", this::overlap),
                new Readout("ball should rise", reference::predictedWords),
                new Readout("  seen", reference::seenWords));
    }

    /** The toggles change what is simulated; the pool takes it from the next step on. */
    private void switchTo(boolean ignored) {
        bench.pool().effects(effects());
    }

    private void drain() {
        wanted = 0;
        isSearching = false;
        while (!drops.isEmpty()) {
            bench.remove(drops.removeFirst());
        }
    }

    @Override
    public void beforeStep(Workbench on) {
        if (isSearching) {
            wanted = drops.size() + 20;
        }
        int perTurn = isSearching ? 10 : 12;
        for (int i = 0; i < perTurn && drops.size() < Math.min(wanted, MOST_BODIES); i++) {
            pour();
        }
        while (drops.size() > wanted) {
            bench.remove(drops.removeFirst());
        }
    }

    private void pour() {
        double x = LEFT + 1 + random.nextDouble() * (RIGHT - LEFT - 2);
        double y = 20.5 + 2 * random.nextDouble();
        Shape shape = isBoxes ? Polygon.box(1.7 * size, 1.7 * size) : new Circle(size);
        drops.add(
                bench.add(
                        BodyDefinition.dynamic(shape)
                                .at(x, y)
                                .velocity(0, -6)
                                .material(new Material(1, 0.4, elasticity)),
                        isBoxes ? Skin.RIGIBO : SKINS[drops.size() % 3]));
    }

    @Override
    public void afterStep(Workbench on) {
        long nanos = 0;
        for (StepStage stage : StepStage.values()) {
            nanos += on.pool().report().nanos(stage);
        }
        millis[turn++ % WINDOW] = nanos / 1e6;
        reference.afterStep(on);
        if (isSearching && turn > WINDOW && at(95) > BUDGET_MILLIS || drops.size() >= MOST_BODIES) {
            best = drops.size();
            isSearching = false;
        }
    }

    @Override
    public void draw(Workbench on, Canvas canvas) {
        reference.draw(on.camera(), canvas);
    }

    private double at(int percent) {
        double[] sorted = Arrays.copyOf(millis, Math.max(1, Math.min(turn, WINDOW)));
        Arrays.sort(sorted);
        return sorted[(sorted.length - 1) * percent / 100];
    }

    private String percentile(int percent) {
        return String.format(Locale.ROOT, "%.2f ms", at(percent));
    }

    private String overlap() {
        double metres = bench.pool().report().deepestOverlap();
        return String.format(Locale.ROOT, "%.1f mm", 1000 * metres);
    }
}
