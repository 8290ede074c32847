package rigibo.backend.storage;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Whoever adds a column says what becomes of it: it is listed in {@link State}, or here with the
 * reason why it need not be.
 */
class StateColumnsTest {

    private static final String FOLLOWS = "follows from what is stated; BodyEditor.derive";
    private static final String OF_A_STEP = "written in every step before it is read";

    /** Columns and other fields that a snapshot leaves out, each with the reason. */
    private static final Map<String, String> LEFT_OUT =
            Map.ofEntries(
                    Map.entry("Bodies.cos", FOLLOWS),
                    Map.entry("Bodies.sin", FOLLOWS),
                    Map.entry("Bodies.mass", FOLLOWS),
                    Map.entry("Bodies.inertia", FOLLOWS),
                    Map.entry("Bodies.inverseMass", FOLLOWS),
                    Map.entry("Bodies.inverseInertia", FOLLOWS),
                    Map.entry("Bodies.friction", FOLLOWS),
                    Map.entry("Bodies.elasticity", FOLLOWS),
                    Map.entry("Bodies.rollingResistance", FOLLOWS),
                    Map.entry("Bodies.surfaceSpeed", FOLLOWS),
                    Map.entry("Bodies.drag", FOLLOWS),
                    Map.entry("Bodies.boundingRadius", FOLLOWS),
                    Map.entry("Bodies.smallestWidth", FOLLOWS),
                    Map.entry("Bodies.sweepRadius", FOLLOWS),
                    Map.entry("Bodies.leaf", "the tree is made anew; Broadphase.rebuild"),
                    Map.entry("Bodies.startX", OF_A_STEP),
                    Map.entry("Bodies.startY", OF_A_STEP),
                    Map.entry("Bodies.startAngle", OF_A_STEP),
                    Map.entry("Bodies.piled", OF_A_STEP),
                    Map.entry("Bodies.pileTime", OF_A_STEP),
                    Map.entry("Bodies.pullX", OF_A_STEP),
                    Map.entry("Bodies.pullY", OF_A_STEP),
                    Map.entry("Bodies.pullTurn", OF_A_STEP),
                    Map.entry("Pairs.friction", "mixed from the bodies; Pairs.derive"),
                    Map.entry("Pairs.elasticity", "mixed from the bodies; Pairs.derive"),
                    Map.entry("Pairs.index", "follows from the pairs; Pairs.derive"),
                    Map.entry("Pairs.former", "of the last measurement, read right after it"),
                    Map.entry("Pairs.reach", "unknown in a restored pool, which measures anew"),
                    Map.entry("Pairs.active", "any pair may have been; Pairs.derive"),
                    Map.entry("Pairs.activeCount", "any pair may have been; Pairs.derive"),
                    Map.entry("Pairs.activeStep", OF_A_STEP),
                    Map.entry("Pairs.step", OF_A_STEP),
                    Map.entry("DataStorage.thrusting", FOLLOWS),
                    Map.entry("DataStorage.time", OF_A_STEP),
                    Map.entry("DataStorage.roster", "follows from the bodies when it is stale"),
                    Map.entry("DataStorage.islands", OF_A_STEP),
                    Map.entry("DataStorage.stillContacts", "follows from all having been active"),
                    Map.entry("DataStorage.counters", "what the last step did, not the next"));

    /** Listed whole, so that no single element stands for them. */
    private static final Map<String, String> LISTED =
            Map.of(
                    "Bodies.slots", "State.visitSlots",
                    "Pairs.slots", "State.visitSlots",
                    "DataStorage.bodies", "State.visitBodies",
                    "DataStorage.pairs", "State.visitPairs");

    private static final int BODY = 1;
    private static final int PAIR = 1;

    static Stream<String> arrays() {
        return fields().filter(field -> field.getType().isArray()).map(StateColumnsTest::nameOf);
    }

    private static Stream<Field> fields() {
        return Stream.of(Bodies.class, Pairs.class, DataStorage.class)
                .flatMap(type -> Arrays.stream(type.getDeclaredFields()))
                .filter(field -> !Modifier.isStatic(field.getModifiers()));
    }

    private static String nameOf(Field field) {
        return field.getDeclaringClass().getSimpleName() + "." + field.getName();
    }

    @Test
    void everyFieldIsListedOrLeftOutForAReason() {
        assertThat(
                        fields().filter(field -> !field.getType().isArray())
                                .map(StateColumnsTest::nameOf)
                                .collect(Collectors.toList()))
                .allSatisfy(
                        name ->
                                assertThat(LEFT_OUT.containsKey(name) || LISTED.containsKey(name))
                                        .as("%s is neither listed nor left out", name)
                                        .isTrue());
        assertThat(fields().map(StateColumnsTest::nameOf)).containsAll(LEFT_OUT.keySet());
    }

    @ParameterizedTest
    @MethodSource("arrays")
    void everyColumnIsListedOrLeftOutForAReason(String name) throws IllegalAccessException {
        DataStorage data = twoPairsOfThree();
        byte[] before = written(data);
        long hash = StateHash.of(data, 0, List.of());
        alter(data, name);
        boolean isSeen = !Arrays.equals(written(data), before);
        assertThat(StateHash.of(data, 0, List.of()) != hash)
                .as("%s is hashed just where it is written", name)
                .isEqualTo(isSeen);
        assertThat(isSeen)
                .as("%s: list it in State, or here with the reason why not", name)
                .isNotEqualTo(LEFT_OUT.containsKey(name));
    }

    @Test
    void everyEffectIsStatedByNumbersOrHoldsAFunction() {
        assertThat(Effect.class.getPermittedSubclasses())
                .allSatisfy(
                        kind -> {
                            boolean holdsFunction =
                                    Arrays.stream(kind.getDeclaredMethods())
                                            .anyMatch(m -> m.getName().equals("holdsFunction"));
                            if (!holdsFunction) {
                                assertThat(EffectForms.named(kind.getSimpleName()).count())
                                        .as("%s", kind)
                                        .isEqualTo(kind.getRecordComponents().length);
                            }
                        });
    }

    private static void alter(DataStorage data, String name) throws IllegalAccessException {
        Field field = fields().filter(f -> nameOf(f).equals(name)).findFirst().orElseThrow();
        field.setAccessible(true);
        boolean isOfBodies = field.getDeclaringClass() == Bodies.class;
        Object column = field.get(isOfBodies ? data.bodies : data.pairs);
        assertThat(column).as("%s: declare the effect that needs it", name).isNotNull();
        int at = isOfBodies ? BODY : PAIR;
        Array.set(column, at, other(Array.get(column, at)));
    }

    private static Object other(Object value) {
        if (value instanceof Double) {
            return Math.nextUp((Double) value);
        }
        if (value instanceof Integer) {
            return (Integer) value + 1;
        }
        if (value instanceof Boolean) {
            return !(Boolean) value;
        }
        if (value instanceof BodyType) {
            return BodyType.KINEMATIC;
        }
        if (value instanceof Material) {
            return Material.DEFAULT.friction(0.25);
        }
        return new Circle(3);
    }

    private static byte[] written(DataStorage data) {
        ByteWriter writer = new ByteWriter();
        State.visit(data, writer);
        return writer.bytes();
    }

    private static DataStorage twoPairsOfThree() {
        DataStorage data =
                new DataStorage(
                        Effects.of(
                                new Contacts(),
                                new Rotation(),
                                new Friction(),
                                new Restitution(),
                                new Sleep(),
                                new RollingResistance(),
                                new SurfaceSpeed(),
                                new Drag(),
                                new Thrust()));
        data.bodies.integratePaths(true);
        for (int i = 0; i < 3; i++) {
            int slot = data.bodies.take();
            data.bodies.type[slot] = BodyType.DYNAMIC;
            data.bodies.shape[slot] = Polygon.box(1, 1);
            data.bodies.material[slot] = Material.DEFAULT;
            data.bodies.firstPair[slot] = Pairs.NONE;
        }
        data.pairs.add(data.bodies, 0, 1);
        data.pairs.add(data.bodies, 1, 2);
        return data;
    }
}
