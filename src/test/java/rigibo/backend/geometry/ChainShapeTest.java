package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.Stream;

class ChainShapeTest {

    static Stream<Object[]> refused() {
        return Stream.of(
                refusal("edge 1 from (1.0, 0.0) m", 2, 0, 1, 0, 0.99995, 0, 0, 0),
                refusal("edge 0", 0, 0, 0, 0),
                refusal("corner 1 must be finite", 0, 0, Double.NaN, 1, 2, 2),
                refusal("edge 0 at (0.0, 0.0) m meets edge 2", 0, 0, 2, 0, 2, 1, 1, -1),
                refusal("edge 0 at (0.0, 0.0) m meets edge 2", 0, 0, 2, 0, 2, 1, 1, 0),
                refusal("edge 0 at (0.0, 0.0) m meets edge 3", 0, 0, 1, 0, 1, 1, 0, 1, 0, 0),
                refusal("right back at corner 1 at (2.0, 0.0) m", 0, 0, 2, 0, 1, 0),
                refusal("2 to 16385 corners, was 2 numbers", 0, 0),
                refusal("was 3 numbers", 0, 0, 1));
    }

    private static Object[] refusal(String words, double... xy) {
        return new Object[] {words, xy};
    }

    @ParameterizedTest
    @MethodSource("refused")
    void namesThePlaceThatIsWrong(String words, double[] xy) {
        assertThatThrownBy(() -> Chain.open(xy))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Chain.open")
                .hasMessageContaining(words);
    }

    @Test
    void aLoopMayNotCrossItself() {
        assertThatThrownBy(() -> Chain.loop(0, 0, 1, 1, 1, 0, 0, 1))
                .hasMessageContaining("edge 0 at (0.0, 0.0) m meets edge 2 at (1.0, 0.0) m");
    }

    @Test
    void hasNoEdgeBeyondItsEnd() {
        Chain chain = Chain.open(1, 0, 0, 0);
        assertThat(chain.edge(0)).isEqualTo(chain);
        assertThatThrownBy(() -> chain.edge(1)).hasMessage("Chain.edge must be 0 to 0, was 1");
        assertThatThrownBy(() -> chain.edge(-1)).hasMessageContaining("was -1");
    }

    @Test
    void manyEdgesAreCheckedInNoTime() {
        double[] xy = new double[2 * Chain.MAX_EDGES];
        for (int i = 0; i < Chain.MAX_EDGES; i++) {
            double angle = 2 * Math.PI * i / Chain.MAX_EDGES;
            xy[2 * i] = 100 * Math.cos(angle);
            xy[2 * i + 1] = 100 * Math.sin(angle);
        }
        Chain ring = Chain.loop(xy);
        assertThat(ring.parts()).isEqualTo(Chain.MAX_EDGES);
        assertThat(ring.boundingRadius()).isBetween(99.99999, 100.00001);
    }

    /** A square's outward normals are those of the polygon with the same corners. */
    @Test
    void airLiesToTheRight() {
        Chain rock = Chain.loop(-1, -1, 1, -1, 1, 1, -1, 1);
        Outline square = Polygon.box(2, 2).outline();
        for (int i = 0; i < 4; i++) {
            assertThat(rock.outline(i).normalX(0)).isEqualTo(square.normalX(i));
            assertThat(rock.outline(i).normalY(0)).isEqualTo(square.normalY(i));
            assertThat(rock.outline(i).isConvexBefore()).isTrue();
            assertThat(rock.outline(i).isConvexAfter()).isTrue();
        }
        Chain cave = rock.reversed();
        assertThat(cave.cornerX(0)).isEqualTo(-1);
        assertThat(cave.cornerY(0)).isEqualTo(1);
        assertThat(cave.outline(0).normalY(0)).isEqualTo(-1);
        assertThat(cave.outline(0).isConvexBefore()).isFalse();
        assertThat(cave.outline(0).after().run()).isEqualTo(8);
        assertThat(cave.reversed()).isEqualTo(rock);
        assertThat(cave).isNotEqualTo(rock);
    }

    @Test
    void anOpenEndIsACorner() {
        Chain floor = Chain.open(1, 0, 0, 0, -1, 0);
        assertThat(floor.outline(0).isConvexBefore()).isTrue();
        assertThat(floor.outline(0).isConvexAfter()).isFalse();
        assertThat(floor.outline(1).isConvexAfter()).isTrue();
        assertThat(floor.area()).isEqualTo(0);
        assertThat(floor.massProperties(3).mass()).isEqualTo(0);
    }
}
