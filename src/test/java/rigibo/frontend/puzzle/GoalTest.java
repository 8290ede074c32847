package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.geometry.Aabb;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.scene.Skin;

import java.util.List;

/** The goal is told from everything else by its colour and by its flag. */
class GoalTest {

    @ParameterizedTest
    @EnumSource(Substance.class)
    void nothingElseLooksLikeIt(Substance substance) {
        assertThat(Skins.of(substance)).isNotEqualTo(Skin.GOAL);
    }

    @Test
    void itsFlagStandsOnItAndStaysWithinTheWorld() {
        for (Level level : Levels.all()) {
            List<Part> parts = Goal.parts(level.platform());
            Aabb pole = bounds(parts.get(0));
            Aabb cloth = bounds(parts.get(1));
            Aabb cushion = bounds(parts.get(2));
            assertThat(pole.minY).as(level.id()).isBetween(cushion.minY, cushion.maxY + 1e-9);
            assertThat(cloth.minY).as(level.id()).isGreaterThan(cushion.maxY + 0.5);
            assertThat(cloth.minX).as(level.id()).isGreaterThan(Math.max(0, cushion.minX));
            assertThat(pole.maxX).as(level.id()).isLessThan(cushion.maxX);
            assertThat(pole.maxY).as(level.id()).isLessThan(level.world().height());
        }
    }

    private static Aabb bounds(Part part) {
        Aabb bounds = new Aabb();
        part.bounds(bounds);
        return bounds;
    }
}
