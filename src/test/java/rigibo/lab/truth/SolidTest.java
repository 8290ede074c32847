package rigibo.lab.truth;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.setup.BodyDefinition;

import java.util.List;

class SolidTest {

    private static final double CLOSE = 1e-12;

    /** Two boxes of 2 m and one upon them, each storey 0.1 m above what carries it. */
    @Test
    void pyramidStandsStoreyUponStorey() {
        List<BodyDefinition> boxes = Solid.pyramid(Solid.box(2, 2), 2, 2, 0.1).toList();

        double[] x = boxes.stream().mapToDouble(BodyDefinition::x).toArray();
        double[] y = boxes.stream().mapToDouble(BodyDefinition::y).toArray();
        assertThat(x).containsExactly(new double[] {-1, 1, 0}, within(CLOSE));
        assertThat(y).containsExactly(new double[] {1.1, 1.1, 3.2}, within(CLOSE));
    }

    @Test
    void matterIsOfDensityOne() {
        assertThat(Solid.disc(1, 0.3, 0.7).material()).isEqualTo(Solid.matter(0.3, 0.7));
        assertThat(Solid.fixed(1, 2, 0.3, 0.7).material().density()).isEqualTo(1);
    }
}
