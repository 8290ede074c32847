package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Where something must give, bodies that move do, and say so; what nobody moves never does. */
@Execution(ExecutionMode.CONCURRENT)
class CrushedTest {

    private static final Material MATTER = new Material(1, 0.5, 0.2);
    private static final Effects NO_WEIGHT =
            Effects.of(
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new ContinuousImpacts());

    private static Pool pool(Effects effects) {
        return new Pool(effects, Accuracy.GAME);
    }

    private static RigidBody box(Pool pool, double x, double y) {
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1));
        return pool.add(box.at(x, y).material(MATTER));
    }

    /** Two square metres in a closed room of 1.7 m × 1.05 m: neither can slide out either. */
    @Test
    void whatFindsNoRoomIsToldAsCrushed() {
        Pool pool = pool(NO_WEIGHT);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 4)).at(-0.5, 0).material(MATTER));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 4)).at(2.2, 0).material(MATTER));
        pool.add(BodyDefinition.fixed(Polygon.box(4, 1)).at(0.85, -1.025).material(MATTER));
        pool.add(BodyDefinition.fixed(Polygon.box(4, 1)).at(0.85, 1.025).material(MATTER));
        box(pool, 0.5, 0);
        box(pool, 1.2, 0);
        for (int step = 0; step < 120; step++) {
            assertThat(pool.step(Scenes.DT).crushed()).as("step %d", step).isPositive();
        }
    }

    /**
     * Discs of 1.2 times the area of the room that is closed round them, too many to be solved
     * whole, begin within it and overlap. They cannot all part, so that the outermost are pushed
     * against the walls in every step; none of them gets half of its width into one.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void crowdIsNotPushedThroughWalls(long seed) {
        double side = 5;
        Pool pool = new Pool();
        BodyDefinition wall = BodyDefinition.fixed(Polygon.box(side + 4, 2));
        pool.add(wall.at(0, -1));
        pool.add(wall.at(0, side + 1));
        pool.add(wall.at(-side / 2 - 1, side / 2).angle(Math.PI / 2));
        pool.add(wall.at(side / 2 + 1, side / 2).angle(Math.PI / 2));
        Circle disc = new Circle(0.3);
        SplittableRandom random = new SplittableRandom(seed);
        double inside = side - 2 * disc.radius();
        for (double area = 0; area < 1.2 * side * side; area += disc.area()) {
            double x = inside * (random.nextDouble() - 0.5);
            double y = side / 2 + inside * (random.nextDouble() - 0.5);
            pool.add(BodyDefinition.dynamic(disc).at(x, y).material(MATTER));
        }
        for (int step = 0; step < 240; step++) {
            pool.step(Scenes.DT);
            for (RigidBody body : pool.bodies()) {
                if (body.type() == BodyType.DYNAMIC) {
                    double out = Math.max(Math.abs(body.x()), Math.abs(body.y() - side / 2));
                    assertThat(out)
                            .as("seed %d, step %d, %s", seed, step, body)
                            .isLessThan(side / 2);
                }
            }
        }
    }

    /**
     * Bodies at rest that overlap by a twentieth of a width are not reported as crushed; they only
     * part.
     */
    @Test
    void whatTouchesIsNotToldAsCrushed() {
        Pool pool = pool(NO_WEIGHT);
        box(pool, 0, 0);
        box(pool, 0.96, 0);
        assertThat(pool.step(Scenes.DT).crushed()).isZero();
    }

    /** Parted from a heavy neighbour a box goes no deeper into the wall that it leans on. */
    @Test
    void whatIsPartedIsNotPushedIntoAWall() {
        Pool pool = pool(NO_WEIGHT);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 4)).at(0.5, 0).material(MATTER));
        RigidBody light = box(pool, -0.5, 0);
        BodyDefinition heavy = BodyDefinition.dynamic(Polygon.box(1, 1)).mass(1e4);
        RigidBody other = pool.add(heavy.at(-1.3, 0).material(MATTER));
        for (int step = 0; step < 120; step++) {
            pool.step(Scenes.DT);
            // Of every overlap, 10⁻⁵ of a width is left.
            assertThat(light.x()).as("step %d", step).isLessThan(-0.5 + 1.1e-5);
        }
        assertThat(light.x() - other.x()).isGreaterThan(1 - 2e-3);
    }

    /**
     * A bullet of a hundred to ten thousand times the mass of a box meets boxes on a floor that
     * lean on a wall. It stays before them, in their order, and none is in wall or floor by 2 % of
     * it.
     */
    @ParameterizedTest
    @CsvSource({"100, 300", "1000, 60", "1000, 300", "10000, 60", "10000, 1000"})
    void heavyBulletPassesThroughNothing(double ratio, double speed) {
        Pool pool = pool(NO_WEIGHT.with(new Gravity(0, -9.81)));
        pool.add(BodyDefinition.fixed(Polygon.box(800, 2)).at(0, -1).material(MATTER));
        pool.add(BodyDefinition.fixed(Polygon.box(0.1, 40)).at(0.05, 20).material(MATTER));
        List<RigidBody> row = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            row.add(box(pool, -0.5 - i, 0.5));
        }
        BodyDefinition bullet = BodyDefinition.dynamic(new Circle(0.3)).mass(ratio);
        row.add(pool.add(bullet.at(-5, 0.5).velocity(speed, 0).material(MATTER)));
        for (int step = 0; step < 30; step++) {
            pool.step(Scenes.DT);
            for (int i = 0; i < row.size(); i++) {
                String where = "step " + step + ", body " + i;
                double half = i < 3 ? 0.5 : 0.3;
                // A box that turns is higher and wider than half its side, never lower.
                assertThat(row.get(i).y()).as(where).isGreaterThan(half - 0.02);
                assertThat(row.get(i).x()).as(where).isLessThan(-half + 0.02);
                if (i > 0) {
                    assertThat(row.get(i).x()).as(where).isLessThan(row.get(i - 1).x());
                }
            }
        }
    }
}
