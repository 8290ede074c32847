package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class AabbTest {

    private final Aabb box = new Aabb(0, 0, 2, 1);

    @Test
    void boxesThatOnlyTouchOverlap() {
        assertThat(box.overlaps(new Aabb(2, 1, 3, 3))).isTrue();
        assertThat(box.overlaps(new Aabb(2.001, 0, 3, 1))).isFalse();
        assertThat(box.overlaps(new Aabb(0, -1, 2, -0.001))).isFalse();
    }

    @Test
    void edgeBelongsToTheBox() {
        assertThat(box.contains(2, 1)).isTrue();
        assertThat(box.contains(2.001, 1)).isFalse();
        assertThat(box.contains(1, Double.NaN)).isFalse();
    }

    @Test
    void aPointIsABox() {
        assertThat(new Aabb(1, 1, 1, 1).overlaps(box)).isTrue();
    }

    @Test
    void swappedOrMissingEdgesAreRefused() {
        assertThatThrownBy(() -> new Aabb(1, 0, 0, 1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new Aabb(0, 0, Double.NaN, 1))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
