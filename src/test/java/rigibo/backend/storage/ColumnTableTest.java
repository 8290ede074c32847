package rigibo.backend.storage;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.storage.ShownColumns.Shown;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Every array of the bodies and the pairs is a line of its table, once, under its own name. */
public class ColumnTableTest {

    /** Every effect that a column needs. */
    public static final Effects ALL =
            Effects.of(
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new Sleep(),
                    new RollingResistance(),
                    new SurfaceSpeed(),
                    new Drag(),
                    new Thrust());

    private static final String OF_A_STEP = "written in every step before it is read";

    /**
     * Fields besides columns that last from step to step, and why snapshots lose nothing by them.
     */
    private static final Map<String, String> NO_COLUMNS =
            Map.ofEntries(
                    Map.entry("Bodies.slots", "saved beside the table; State.visitSlots"),
                    Map.entry("Bodies.room", "how long the columns are, not what they hold"),
                    Map.entry("Bodies.effects", "saved; Snapshot.effects"),
                    Map.entry("Bodies.asked", "saved; Snapshot.visit"),
                    Map.entry("Pairs.asked", "as of the bodies; DataStorage.hold"),
                    Map.entry("Pairs.effects", "as of the bodies"),
                    Map.entry("Pairs.slots", "saved beside the table; State.visitSlots"),
                    Map.entry("Pairs.room", "how long the columns are, not what they hold"),
                    Map.entry("Pairs.index", "follows from the pairs; Pairs.derive"),
                    Map.entry("Pairs.active", "a list: any pair may be on it; Pairs.derive"),
                    Map.entry("Pairs.activeCount", "any pair may have been; Pairs.derive"),
                    Map.entry("Pairs.step", "counts steps from anywhere"),
                    Map.entry("DataStorage.bodies", "a table"),
                    Map.entry("DataStorage.pairs", "a table"),
                    Map.entry("DataStorage.joints", "a table, null where none are declared"),
                    Map.entry("DataStorage.noJoints", "a table that stays empty"),
                    Map.entry("DataStorage.broken", "empty after a step; PoolJoints.followBreaks"),
                    Map.entry("DataStorage.thrusting", "follows from forces; BodyEditor.derive"),
                    Map.entry("DataStorage.time", OF_A_STEP),
                    Map.entry("DataStorage.visits", "saved beside the tables; State.visitVisits"),
                    Map.entry("DataStorage.ways", "written in a step and read at its end"),
                    Map.entry("DataStorage.hits", "what the last step did, not the next"),
                    Map.entry("DataStorage.steered", "follows from the drives; BodyEditor.derive"),
                    Map.entry("DataStorage.roster", "follows from the bodies when it is stale"),
                    Map.entry("DataStorage.islands", OF_A_STEP),
                    Map.entry("DataStorage.stillContacts", "follows from all having been active"),
                    Map.entry("DataStorage.counters", "what the last step did, not the next"));

    private final Bodies bodies = new Bodies(ALL);
    private final Pairs pairs = new Pairs(ALL);

    ColumnTableTest() {
        bodies.integratePaths(true);
        Need.OF_BODIES.forEach(bodies::hold);
        pairs.holdCompounds();
        pairs.holdOneSided();
    }

    private static Stream<Field> fields(Class<?> type) {
        return Arrays.stream(type.getDeclaredFields())
                .filter(field -> !Modifier.isStatic(field.getModifiers()))
                .peek(field -> field.setAccessible(true));
    }

    private static String nameOf(Field field) {
        return field.getDeclaringClass().getSimpleName() + "." + field.getName();
    }

    private static boolean isColumn(Field field) {
        return field.getType().isArray() && !NO_COLUMNS.containsKey(nameOf(field));
    }

    @Test
    void everyArrayIsALineOfItsTable() throws IllegalAccessException {
        requireLines(bodies, ShownColumns.of(bodies));
        requireLines(pairs, ShownColumns.of(pairs));
    }

    private static void requireLines(Object table, Map<String, Shown> lines)
            throws IllegalAccessException {
        Set<String> names = new TreeSet<>();
        for (Field field : fields(table.getClass()).filter(f -> isColumn(f)).toList()) {
            names.add(field.getName());
            assertThat(lines).as("the table").containsKey(field.getName());
            assertThat(lines.get(field.getName()).array())
                    .as("what the table shows as %s", field.getName())
                    .isNotNull()
                    .isSameAs(field.get(table));
        }
        assertThat(lines.keySet()).isEqualTo(names);
    }

    @Test
    void everyFieldThatIsNoColumnHasAReason() {
        Set<String> found =
                Stream.of(Bodies.class, Pairs.class, DataStorage.class)
                        .flatMap(ColumnTableTest::fields)
                        .filter(field -> !isColumn(field))
                        .map(ColumnTableTest::nameOf)
                        .collect(Collectors.toSet());
        assertThat(found).isEqualTo(NO_COLUMNS.keySet());
    }

    @Test
    void whatAVisitorAnswersIsTheColumn() {
        bodies.visitColumns(ShownColumns.answering(ColumnTableTest::ofTen));
        pairs.visitColumns(ShownColumns.answering(ColumnTableTest::ofTen));
        Stream.of(ShownColumns.of(bodies), ShownColumns.of(pairs))
                .flatMap(lines -> lines.entrySet().stream())
                .forEach(
                        line ->
                                assertThat(Array.getLength(line.getValue().array()))
                                        .as(line.getKey())
                                        .isEqualTo(10));
    }

    private static Object ofTen(Object array) {
        return Array.newInstance(array.getClass().getComponentType(), 10);
    }

    @Test
    void columnsComeAndGoWithWhatNeedsThem() {
        Effects bare = Effects.of();
        bodies.declare(bare);
        pairs.declare(bare);
        bodies.integratePaths(false);
        Stream.of(ShownColumns.of(bodies), ShownColumns.of(pairs))
                .flatMap(lines -> lines.values().stream())
                .forEach(
                        line ->
                                assertThat(line.array() != null)
                                        .as("%s", line)
                                        .isEqualTo(
                                                line.need() == Need.ALWAYS
                                                        || Need.OF_BODIES.contains(line.need())));
    }

    /** Slots are handed out one by one, as pairs are met. */
    @ParameterizedTest
    @ValueSource(ints = {10, 64, 65, 1024, 1536, 1537, 1800, 2047, 2048, 5000})
    void everyColumnHasRoomForEverySlot(int count) {
        Pairs grown = new Pairs(ALL);
        Bodies many = new Bodies(ALL);
        int a = many.take();
        many.firstPair[a] = Pairs.NONE;
        for (int i = 0; i < count; i++) {
            int b = many.take();
            many.firstPair[b] = Pairs.NONE;
            int pair = grown.add(many, a, b);
            grown.load[2 * pair + 1] = i;
        }
        requireRoom(ShownColumns.of(grown), count, grown.room());
        requireRoom(ShownColumns.of(many), count + 1, count + 1);
        for (int i = 0; i < count; i++) {
            assertThat(grown.load[2 * i + 1]).as("pair %d", i).isEqualTo(i);
        }
    }

    private static void requireRoom(Map<String, Shown> lines, int count, int room) {
        assertThat(room).isGreaterThanOrEqualTo(count);
        lines.forEach(
                (name, line) -> {
                    if (line.array() != null) {
                        assertThat(Array.getLength(line.array()))
                                .as(name)
                                .isGreaterThanOrEqualTo(room * line.perSlot());
                    }
                });
    }

    /**
     * From three quarters of some 16,000 on, 4,000 pairs lengthen columns of 27 lines by half: each
     * hundred of them a fortieth, or the one column that is due, the widest of which takes a
     * fourteenth.
     */
    @Test
    void noHundredPairsLengthenManyColumns() {
        pairs.reserve(12000);
        int before = pairs.room();
        Bodies two = new Bodies(ALL);
        int a = two.take();
        two.firstPair[a] = Pairs.NONE;
        long all = bytes(ShownColumns.of(pairs));
        long most = 0;
        while (pairs.slots.high < before) {
            long then = bytes(ShownColumns.of(pairs));
            for (int i = 0; i < 100 && pairs.slots.high < before; i++) {
                int b = two.take();
                two.firstPair[b] = Pairs.NONE;
                pairs.add(two, a, b);
            }
            most = Math.max(most, bytes(ShownColumns.of(pairs)) - then);
        }
        assertThat(pairs.room()).isEqualTo(before / 2 * 3);
        assertThat(bytes(ShownColumns.of(pairs))).isEqualTo(all / 2 * 3);
        assertThat(most).isBetween(1L, all / 8);
    }

    private static long bytes(Map<String, Shown> lines) {
        return lines.values().stream()
                .map(Shown::array)
                .mapToLong(array -> (long) Array.getLength(array) * bytesOfOne(array))
                .sum();
    }

    private static int bytesOfOne(Object array) {
        return array instanceof double[] ? 8 : array instanceof int[] ? 4 : 1;
    }

    @Test
    void whatIsReservedIsThereBeforeTheFirstPair() {
        pairs.reserve(8000);
        double[] loads = pairs.load;
        boolean[] told = pairs.touchedBefore;
        Bodies many = new Bodies(ALL);
        int a = many.take();
        many.firstPair[a] = Pairs.NONE;
        for (int i = 0; i < 8000; i++) {
            int b = many.take();
            many.firstPair[b] = Pairs.NONE;
            pairs.add(many, a, b);
        }
        assertThat(pairs.load).isSameAs(loads);
        assertThat(pairs.touchedBefore).isSameAs(told);
    }
}
