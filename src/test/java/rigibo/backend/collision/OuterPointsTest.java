package rigibo.backend.collision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.Pairs;

/**
 * A body with two feet on a floor. Each foot touches it with one point at first, and with two when
 * they are measured again. The floor's normal points up, so that points lie on the line by their x.
 */
class OuterPointsTest {

    private final FilledStorage storage = new FilledStorage(new Contacts());
    private final Pairs pairs = storage.pairs;
    private final OuterPoints outer = new OuterPoints(storage.data);
    private int left;
    private int right;

    @BeforeEach
    void putTwoFeetOnAFloor() {
        int floor = storage.add(BodyDefinition.fixed(Polygon.box(10, 1)));
        int body = storage.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1));
        left = storage.pair(floor, body);
        right = storage.pair(floor, body);
        outer.begin();
        put(left, -0.5, 0);
        put(right, 0.5, 0);
        outer.lend(left, right);
        outer.giveBack(left);
    }

    /** Sets the points of a pair, each by x and gap, m. */
    private void put(int pair, double... points) {
        pairs.points[pair] = points.length / 2;
        pairs.normalX[pair] = 0;
        pairs.normalY[pair] = 1;
        for (int i = 0; i < points.length / 2; i++) {
            pairs.pointX[2 * pair + i] = points[2 * i];
            pairs.separation[2 * pair + i] = points[2 * i + 1];
            pairs.former[2 * pair + i] = Pairs.NONE;
        }
    }

    /**
     * The gaps of the left foot at −0.6 and −0.5 m, and of the right one at 0.5 and 0.6 m. On a
     * straight sole the outermost points count. A heel deeper than the line through the tips counts
     * in place of the tip beside it.
     */
    @ParameterizedTest
    @CsvSource({
        "0, 0, 0, 0, -0.6, 0.6",
        "0.3, 0.2, -0.8, -0.9, -0.6, 0.6",
        "0.1, 0, 0, 0.1, -0.5, 0.5",
        "0.1, -0.01, 0.2, 0, -0.5, 0.6",
        "0, 0.2, -0.01, 0.1, -0.6, 0.5"
    })
    void whatIsDeepIsKept(double a, double b, double c, double d, double from, double to) {
        put(left, -0.6, a, -0.5, b);
        put(right, 0.5, c, 0.6, d);
        outer.lendAgain(left, 1);

        assertThat(pairs.points[left]).isEqualTo(2);
        assertThat(pairs.points[right]).isZero();
        assertThat(new double[] {pairs.pointX[2 * left], pairs.pointX[2 * left + 1]})
                .containsExactlyInAnyOrder(from, to);
    }
}
