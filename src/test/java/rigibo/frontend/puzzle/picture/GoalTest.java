package rigibo.frontend.puzzle.picture;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Polygon;
import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Platform;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.scene.Skin;

import java.util.List;

/** The goal is recognised by its colour and its flag. */
class GoalTest {

    @ParameterizedTest
    @EnumSource(Substance.class)
    void nothingElseLooksLikeIt(Substance substance) {
        assertThat(Skins.of(substance)).isNotEqualTo(Skin.GOAL);
    }

    @Test
    void itsFlagStandsOnItAndStaysWithinTheWorld() {
        for (Level level : Levels.all()) {
            List<Part> parts = Goal.of(level).parts();
            Aabb pole = bounds(parts.get(0));
            Aabb cloth = bounds(parts.get(1));
            Aabb cushion = bounds(parts.get(2));
            assertThat(pole.minY).as(level.id()).isBetween(cushion.minY, cushion.maxY + 1e-9);
            assertThat(cloth.minY).as(level.id()).isGreaterThan(cushion.maxY + 0.3);
            assertThat(cloth.minX).as(level.id()).isGreaterThan(Math.max(0, cushion.minX));
            assertThat(cloth.maxX).as(level.id()).isLessThan(cushion.maxX);
            assertThat(pole.maxX).as(level.id()).isLessThan(cushion.maxX);
            assertThat(pole.maxY).as(level.id()).isLessThan(level.world().height());
        }
    }

    @Test
    void nothingHidesItsFlagAtTheStartOfALevel() {
        for (Level level : Levels.all()) {
            Aabb cloth = bounds(Goal.of(level).parts().get(1));
            double x = (cloth.minX + cloth.maxX) / 2;
            double y = (cloth.minY + cloth.maxY) / 2;
            assertThat(level.bodies()).as(level.id()).noneMatch(body -> Part.of(body).covers(x, y));
        }
    }

    @Test
    void itsFlagStandsOnTheOtherEndWhereTheUsualOneIsHidden() {
        Platform goal = new Platform(4, 1, 3, 0.3, 0);
        assertThat(pole(goal, List.of())).isGreaterThan(5);
        assertThat(pole(goal, List.of(box(5.2)))).isLessThan(3);
        assertThat(pole(goal, List.of(box(5.2), box(2.8)))).isBetween(3.0, 5.0);
    }

    @Test
    void itsFlagStandsEvenOnADraftsGoalThatIsTooNarrow() {
        Platform narrow = new Platform(4, 1, 0.1, 0.3, 0);
        assertThat(new Goal(narrow, List.of()).parts().get(1).shape().area()).isPositive();
    }

    /** Position of the flag's pole among bodies, m. */
    private static double pole(Platform goal, List<Part> bodies) {
        return new Goal(goal, bodies).parts().get(0).x();
    }

    /** A box as high as a tall pole, standing on the goal. */
    private static Part box(double x) {
        return new Part(Polygon.box(0.9, 2), x, 2.15, 0, Skin.RIGIBO);
    }

    private static Aabb bounds(Part part) {
        Aabb bounds = new Aabb();
        part.bounds(bounds);
        return bounds;
    }
}
