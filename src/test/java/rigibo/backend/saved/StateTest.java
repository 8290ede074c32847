package rigibo.backend.saved;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.ColumnTableTest;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Role;
import rigibo.backend.storage.ShownColumns;
import rigibo.backend.storage.ShownColumns.Shown;

import java.lang.reflect.Array;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** Columns with the role SAVED are written and hashed, and no others. */
class StateTest {

    private static final int BODY = 1;
    private static final int PAIR = 1;

    static Stream<String> bodyColumns() {
        return ShownColumns.of(twoPairsOfThree().bodies).keySet().stream();
    }

    static Stream<String> pairColumns() {
        return ShownColumns.of(twoPairsOfThree().pairs).keySet().stream();
    }

    @ParameterizedTest
    @MethodSource("bodyColumns")
    void columnOfBodiesIsWrittenAndHashedJustWhereItIsSaved(String name) {
        DataStorage data = twoPairsOfThree();
        requireSeenIfSaved(data, name, ShownColumns.of(data.bodies).get(name), BODY);
    }

    @ParameterizedTest
    @MethodSource("pairColumns")
    void columnOfPairsIsWrittenAndHashedJustWhereItIsSaved(String name) {
        DataStorage data = twoPairsOfThree();
        Shown column = ShownColumns.of(data.pairs).get(name);
        for (int i = 0; i < column.perSlot(); i++) {
            requireSeenIfSaved(data, name, column, column.perSlot() * PAIR + i);
        }
    }

    private static void requireSeenIfSaved(DataStorage data, String name, Shown column, int at) {
        byte[] before = written(data);
        long hash = StateHash.of(data, 0, List.of());
        Array.set(column.array(), at, other(Array.get(column.array(), at)));
        boolean isSaved = column.role() == Role.SAVED;
        assertThat(!Arrays.equals(written(data), before))
                .as("%s is written", name)
                .isEqualTo(isSaved);
        assertThat(StateHash.of(data, 0, List.of()) != hash)
                .as("%s is hashed", name)
                .isEqualTo(isSaved);
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
        return value instanceof Outline ? new Circle(3).outline() : new Circle(3);
    }

    private static byte[] written(DataStorage data) {
        ByteWriter writer = new ByteWriter();
        State.visit(data, writer);
        return writer.bytes();
    }

    private static DataStorage twoPairsOfThree() {
        DataStorage data = new DataStorage(ColumnTableTest.ALL);
        data.bodies.integratePaths(true);
        Need.OF_BODIES.forEach(data::hold);
        for (int i = 0; i < 3; i++) {
            int slot = data.bodies.take();
            data.bodies.type[slot] = BodyType.DYNAMIC;
            data.bodies.shape[slot] = Polygon.box(1, 1);
            data.bodies.outline[slot] = Polygon.box(1, 1).outline();
            data.bodies.material[slot] = Material.DEFAULT;
            data.bodies.firstPair[slot] = Pairs.NONE;
        }
        data.pairs.add(data.bodies, 0, 1);
        data.pairs.add(data.bodies, 1, 2);
        return data;
    }
}
