package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** Flyers that join a pile for the sake of a neighbour that is about to bounce. */
class BystandersTest {

    private static final double BULLET_SPEED = 30;
    private static final double SIDE = 0.5;

    /**
     * A box tips over its corner, so slowly that it may reach the bullet that comes from its right,
     * but not the wall 0.1 m to its left: until the bullet strikes it. A wall that the pile does
     * not know of let it in by 0.4 m within the step.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void whatABystanderStrikesMeetsWhatIsBehindIt(Preset preset) {
        double half = SIDE * Math.sqrt(0.5);
        Pool pool = new Pool(Effects.usual(), preset.accuracy);
        Scenes.addFloor(pool);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 4)).at(-half - 0.6, 2.5));
        Material heavy = new Material(20, 0, 0.5);
        pool.add(
                BodyDefinition.dynamic(Polygon.box(SIDE, SIDE))
                        .at(0, half)
                        .angle(Math.PI / 4)
                        .spin(3)
                        .material(new Material(1, 0.5, 0.5)));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.1))
                        .at(half + 0.15, half)
                        .velocity(-BULLET_SPEED, 0)
                        .material(heavy));
        double deepest = 0;
        for (int i = 0; i < 3; i++) {
            deepest = Math.max(deepest, pool.step(Scenes.DT).deepestOverlap());
        }
        double way = BULLET_SPEED * Scenes.DT / preset.accuracy.substeps();
        assertThat(deepest).isLessThan(way);
    }

    /**
     * A column of discs falls on one that lies. In what is left of the step what bounces gets no
     * farther than twice the way at the speed of the impact, and pushes no more discs than there
     * are gaps in that: the others fly on, and are no rows.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void aBounceReachesNoFartherThanTheGapsLetIt(Preset preset) {
        double speed = 3;
        double radius = 0.1;
        double gap = 0.02;
        Pool pool = new Pool(Effects.usual(), preset.accuracy);
        Scenes.addFloor(pool);
        BodyDefinition disc =
                BodyDefinition.dynamic(new Circle(radius)).material(new Material(1, 0.5, 0.5));
        pool.add(disc.at(0, radius));
        pool.step(Scenes.DT);
        double lowest = 3 * radius + speed * Scenes.DT / 2;
        for (int i = 0; i < 30; i++) {
            pool.add(disc.at(0, lowest + i * (2 * radius + gap)).velocity(0, -speed));
        }
        double pushed = 2 * speed * Scenes.DT / gap;
        // A contact below each disc pushed and below the two that strike, and one above: each has a
        // normal and a friction row.
        assertThat(pool.step(Scenes.DT).rows()).isPositive().isLessThan((int) (2 * (pushed + 4)));
    }
}
