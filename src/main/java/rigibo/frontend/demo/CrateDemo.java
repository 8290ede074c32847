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
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Widget;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Creation and motion of rigid bodies: crates that stack, tumble, rest and fly apart. */
final class CrateDemo implements Demo {

    private static final double BLAST_SPEED = 9;
    private static final double BLAST_RADIUS = 4;
    private static final double LEDGE_X = 6.2;

    /** Of the floor where surfaces run, m/s; negative carries to the right. */
    private static final double BELT_SPEED = -0.8;

    private Workbench bench;
    private final List<RigidBody> stack = new ArrayList<>();
    private RigidBody edgeBox;
    private double size = 0.6;
    private double mass = 1;
    private double ratio = 1;
    private double overhang = 0.4;

    /** How the menu lists it. */
    static SceneEntry entry() {
        return new SceneEntry(
                "crate",
                "Crate",
                "Stacks, blasts, a box on an edge",
                SceneEntry.Kind.DEMO,
                director -> new DemoScene(director, CrateDemo::new));
    }

    @Override
    public String title() {
        return "Crate";
    }

    @Override
    public Effects effects() {
        return Effects.usual();
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new Gravity(0, -9.81), "crates fall and press on what is below"),
                new EffectReason(new Contacts(), "crates lie on each other and on the floor"),
                new EffectReason(new Rotation(), "crates tumble, and the box tips off its edge"),
                new EffectReason(new Friction(), "crates hold each other in the stack"),
                new EffectReason(new Restitution(), "a crate that is thrown bounces a little"),
                new EffectReason(
                        new ContinuousImpacts(), "a flung crate cannot pass through another"),
                new EffectReason(new Sleep(), "a stack at rest costs nothing until it is touched"),
                new EffectReason(
                        new SurfaceSpeed(), "the floor runs to the right and carries crates off"));
    }

    @Override
    public Camera camera() {
        return new Camera(2.4, 3.4, 68);
    }

    @Override
    public void build(Workbench on) {
        bench = on;
        bench.add(
                BodyDefinition.fixed(Polygon.box(24, 1))
                        .at(2, -0.5)
                        .material(new Material(1, 0.6, 0).surfaceSpeed(BELT_SPEED)),
                Skin.STONE);
        bench.add(BodyDefinition.fixed(Polygon.box(1.6, 1.2)).at(LEDGE_X, 0.6), Skin.WOOD);
        stack(10);
        placeOnEdge();
    }

    private void stack(int count) {
        clear();
        for (int i = 0; i < count; i++) {
            stack.add(crate(2.4, (i + 0.5) * size, i == count - 1 ? ratio : 1));
        }
    }

    private void pyramid() {
        clear();
        int base = 8;
        for (int row = 0; row < base; row++) {
            for (int i = 0; i < base - row; i++) {
                double x = 2.4 + (i - (base - row - 1) / 2.0) * 1.04 * size;
                stack.add(crate(x, (row + 0.5) * size, row == base - 1 ? ratio : 1));
            }
        }
    }

    private RigidBody crate(double x, double y, double times) {
        return bench.add(
                BodyDefinition.dynamic(Polygon.box(size, size))
                        .at(x, y)
                        .mass(mass * times)
                        .material(new Material(1, 0.5, 0.1)),
                times > 1 ? Skin.IRON : Skin.RIGIBO);
    }

    private void clear() {
        for (RigidBody body : List.copyOf(bench.pool().bodies())) {
            if (body.type() == BodyType.DYNAMIC && body != edgeBox) {
                bench.remove(body);
            }
        }
        stack.clear();
    }

    /** A box of 1 m whose share beyond the ledge's left edge is set by the slider. */
    private void placeOnEdge() {
        if (edgeBox != null && edgeBox.isAlive()) {
            bench.remove(edgeBox);
        }
        double edge = LEDGE_X - 0.8;
        edgeBox =
                bench.add(
                        BodyDefinition.dynamic(Polygon.box(1, 0.5))
                                .at(edge + 0.5 - overhang, 1.45)
                                .name("on the edge"),
                        Skin.ICE);
    }

    @Override
    public List<Widget> widgets() {
        return List.of(
                new Button("stack of 5", () -> stack(5)),
                new Button("stack of 10", () -> stack(10)),
                new Button("stack of 20", () -> stack(20)),
                new Button("pyramid", this::pyramid),
                new Button("blast (B)", () -> blast(2.4, 0.3)),
                new Slider("size", "%.1f m", 0.3, 1, 0.1, () -> size, value -> size = value),
                new Slider("mass", "%.0f kg", 1, 50, 1, () -> mass, value -> mass = value),
                new Slider("top's mass", "%.0f ×", 1, 100, 1, () -> ratio, v -> ratio = v),
                new Slider("over the edge", "%.2f", 0.1, 0.9, 0.02, () -> overhang, this::hang),
                new Readout("predicted", () -> overhang < 0.5 ? "stays" : "tips"),
                new Readout("seen", this::seen),
                new Readout("bodies", () -> "" + bench.pool().report().bodies()),
                new Readout("contacts", () -> "" + bench.pool().report().contacts()),
                new Readout("asleep", this::asleep),
                new Readout("overlap", () -> millis(bench.pool().report().deepestOverlap())),
                new Readout("lean", () -> millis(lean())),
                new Readout("energy", this::energy));
    }

    private void hang(double share) {
        overhang = share;
        placeOnEdge();
    }

    private String seen() {
        return edgeBox.isAlive() && edgeBox.y() > 1.3 ? "stays" : "tipped";
    }

    private String asleep() {
        long count =
                bench.pool().bodies().stream()
                        .filter(body -> body.type() == BodyType.DYNAMIC && !body.isAwake())
                        .count();
        return "" + count;
    }

    private double lean() {
        double most = 0;
        for (RigidBody body : stack) {
            most = body.isAlive() ? Math.max(most, Math.abs(body.x() - 2.4)) : most;
        }
        return most;
    }

    /** Of motion and of height over the floor. */
    private String energy() {
        double joules = bench.pool().kineticEnergy() + bench.pool().potentialEnergy();
        return String.format(Locale.ROOT, "%.2f J", joules);
    }

    private static String millis(double metres) {
        return String.format(Locale.ROOT, "%.3f mm", 1000 * metres);
    }

    @Override
    public void rightClick(Workbench on, double x, double y) {
        crate(x, y, 1);
    }

    @Override
    public void key(Workbench on, Key key) {
        if (key == Key.B) {
            blast(on.pointerX(), on.pointerY());
        }
    }

    /** Drives everything near a point away from it, m. */
    private void blast(double x, double y) {
        for (RigidBody any : bench.pool().bodies()) {
            bench.act(any, body -> blast(body, x, y));
        }
    }

    private static void blast(RigidBody body, double x, double y) {
        double dx = body.x() - x;
        double dy = body.y() - y;
        double distance = Math.max(0.1, Math.sqrt(dx * dx + dy * dy));
        if (body.type() == BodyType.DYNAMIC && distance < BLAST_RADIUS) {
            double speed = BLAST_SPEED * (1 - distance / BLAST_RADIUS) / distance;
            body.velocity(body.velocityX() + speed * dx, body.velocityY() + speed * dy + 1);
        }
    }

    @Override
    public void afterStep(Workbench on) {
        on.removeBelow(-30);
    }
}
