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
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Widget;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Creation and motion of rigid bodies: crates that stack, tumble, rest and fly apart. */
final class CrateDemo implements Demo {

    private final Words words;

    private static final double BLAST_SPEED = 9;
    private static final double BLAST_RADIUS = 4;

    /** The condition for a box to stay on the ledge: it overhangs by less than half its width. */
    private static final String FORMULA = "x < w/2";

    private static final double LEDGE_X = 6.2;

    /** The ledge's left edge, m. */
    private static final double EDGE_X = LEDGE_X - 0.8;

    /** Where stacks stand, and pyramids that do not reach the ledge from there, m. */
    private static final double MIDDLE = 2.4;

    /** Widest pyramid that the ground has room for to the left of the ledge, m. */
    private static final double ROOM = 15;

    /** Distance of a pyramid from the ledge, m. */
    private static final double GAP = 0.1;

    /** Speed of the floor where surfaces run, m/s; a negative one carries bodies to the right. */
    private static final double BELT_SPEED = -0.8;

    /** Crates of the stack with which it begins. */
    private static final int FIRST = 10;

    private Workbench bench;

    /** By crate of the stack: the x at which it was placed, m. */
    private final Map<RigidBody, Double> stack = new HashMap<>();

    private RigidBody edgeBox;
    private double size = 0.6;

    /** Rows of a pyramid; twenty hold 210 boxes. */
    private double rows = 8;

    private double mass = 1;
    private double ratio = 1;
    private double overhang = 0.4;

    CrateDemo(Words words) {
        this.words = words;
    }

    /** How the menu lists it. */
    static SceneEntry entry() {
        return SceneEntry.of("crate", director -> new DemoScene(director, CrateDemo::new));
    }

    @Override
    public String name() {
        return "crate";
    }

    @Override
    public Effects effects() {
        return Effects.usual();
    }

    @Override
    public List<EffectReason> reasons() {
        return List.of(
                new EffectReason(new Gravity(0, -9.81), words.of("crate.gravity")),
                new EffectReason(new Contacts(), words.of("crate.contacts")),
                new EffectReason(new Rotation(), words.of("crate.rotation")),
                new EffectReason(new Friction(), words.of("crate.friction-why")),
                new EffectReason(new Restitution(), words.of("crate.restitution")),
                new EffectReason(new ContinuousImpacts(), words.of("crate.impacts")),
                new EffectReason(new Sleep(), words.of("crate.sleep")),
                new EffectReason(new SurfaceSpeed(), words.of("crate.belt")));
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
        stack(FIRST);
        placeOnEdge();
    }

    @Override
    public void followed() {
        stack(FIRST);
    }

    private void stack(int count) {
        clear();
        for (int i = 0; i < count; i++) {
            stack.put(crate(MIDDLE, (i + 0.5) * size, i == count - 1 ? ratio : 1), MIDDLE);
        }
    }

    private void pyramid() {
        clear();
        double pitch = 1.04 * size;
        int base = (int) Math.min(Math.round(rows), ROOM / pitch);
        double middle = Math.min(MIDDLE, EDGE_X - GAP - base * pitch / 2);
        for (int row = 0; row < base; row++) {
            for (int i = 0; i < base - row; i++) {
                double x = middle + (i - (base - row - 1) / 2.0) * pitch;
                stack.put(crate(x, (row + 0.5) * size, row == base - 1 ? ratio : 1), x);
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

    /** Places a box 1 m long on the ledge; the slider sets the share of it beyond the left edge. */
    private void placeOnEdge() {
        if (edgeBox != null && edgeBox.isAlive()) {
            bench.remove(edgeBox);
        }
        edgeBox =
                bench.add(
                        BodyDefinition.dynamic(Polygon.box(1, 0.5))
                                .at(EDGE_X + 0.5 - overhang, 1.45)
                                .name("on the edge"),
                        Skin.ICE);
    }

    @Override
    public List<Widget> widgets() {
        return List.of(
                new Button(words.of("crate.stack", 5), () -> stack(5)),
                new Button(words.of("crate.stack", 10), () -> stack(10)),
                new Button(words.of("crate.stack", 20), () -> stack(20)),
                new Button(words.of("crate.pyramid"), this::pyramid),
                new Button(words.of("crate.blast"), () -> blast(MIDDLE, 0.3)),
                new Slider(words, "crate.rows", "%.0f", 4, 20, 1, () -> rows, v -> rows = v),
                new Slider(
                        words,
                        "crate.size",
                        "%.1f m",
                        0.3,
                        1,
                        0.1,
                        () -> size,
                        value -> size = value),
                new Slider(
                        words,
                        "crate.mass",
                        "%.0f kg",
                        1,
                        50,
                        1,
                        () -> mass,
                        value -> mass = value),
                new Slider(words, "crate.ratio", "%.0f ×", 1, 100, 1, () -> ratio, v -> ratio = v),
                new Slider(
                        words,
                        "crate.overhang",
                        "%.2f",
                        0.1,
                        0.9,
                        0.02,
                        () -> overhang,
                        this::hang),
                new Readout(
                        words.of("crate.predicted"),
                        () -> overhang < 0.5 ? words.of("crate.stays") : words.of("crate.tips")),
                new Readout("", () -> FORMULA),
                new Readout(words.of("crate.seen"), this::seen),
                new Readout(words.of("crate.bodies"), () -> "" + bench.pool().report().bodies()),
                new Readout(
                        words.of("crate.touching"), () -> "" + bench.pool().report().contacts()),
                new Readout(words.of("crate.asleep"), this::asleep),
                new Readout(
                        words.of("crate.overlap"),
                        () -> millis(bench.pool().report().deepestOverlap())),
                new Readout(words.of("crate.lean"), () -> millis(lean())),
                new Readout(words.of("crate.energy"), this::energy));
    }

    private void hang(double share) {
        overhang = share;
        placeOnEdge();
    }

    private String seen() {
        return edgeBox.isAlive() && edgeBox.y() > 1.3
                ? words.of("crate.stays")
                : words.of("crate.tipped");
    }

    private String asleep() {
        long count =
                bench.pool().bodies().stream()
                        .filter(body -> body.type() == BodyType.DYNAMIC && !body.isAwake())
                        .count();
        return "" + count;
    }

    /** Largest distance that a crate of the stack has moved sideways from its place, m. */
    private double lean() {
        return stack.entrySet().stream()
                .filter(crate -> crate.getKey().isAlive())
                .mapToDouble(crate -> Math.abs(crate.getKey().x() - crate.getValue()))
                .max()
                .orElse(0);
    }

    /** Energy of motion and of height above the floor. */
    private String energy() {
        double joules = bench.pool().kineticEnergy() + bench.pool().potentialEnergy();
        return words.number("%.2f J", joules);
    }

    private String millis(double metres) {
        return words.number("%.3f mm", 1000 * metres);
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

    /** Drives everything near a point, in m, away from it. */
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
