package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

class SurfaceSpeedTest {

    private static final Material SMOOTH = new Material(1, 0, 0);
    private static final Material ROUGH = new Material(1, 0.5, 0);

    private static Pool pool(Accuracy accuracy) {
        return new Pool(Scenes.usualWithoutSleep().with(new SurfaceSpeed()), accuracy);
    }

    /** A positive speed runs counter-clockwise, so on top it carries to the left. */
    @ParameterizedTest
    @ValueSource(doubles = {-2, 0.5})
    void positiveSpeedCarriesWhatLiesOnTopToTheLeft(double speed) {
        Pool pool = pool(Accuracy.GAME);
        pool.add(
                BodyDefinition.fixed(Polygon.box(40, 1))
                        .at(0, -0.5)
                        .material(ROUGH.surfaceSpeed(speed)));
        RigidBody box =
                pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.5)).at(0, 0.25).material(ROUGH));
        Scenes.run(pool, 120);
        assertThat(box.velocityX()).isEqualTo(-speed, within(1e-9));
    }

    /**
     * On ice, a plank of 4 kg whose surface runs and a box of 1 kg on it push each other away: they
     * end with the relative speed 2 and, as nothing else pushes, with momenta that cancel.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void bothBodiesOfAPairFeelTheBelt(boolean isBeltAddedFirst) {
        Pool pool = pool(Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5).material(SMOOTH));
        BodyDefinition plank =
                BodyDefinition.dynamic(Polygon.box(8, 0.5))
                        .at(0, 0.25)
                        .material(ROUGH.surfaceSpeed(-2));
        BodyDefinition box =
                BodyDefinition.dynamic(Polygon.box(2, 0.5)).at(0, 0.75).material(ROUGH);
        RigidBody one = pool.add(isBeltAddedFirst ? plank : box);
        RigidBody other = pool.add(isBeltAddedFirst ? box : plank);
        Scenes.run(pool, 60);

        double plankSpeed = (isBeltAddedFirst ? one : other).velocityX();
        double boxSpeed = (isBeltAddedFirst ? other : one).velocityX();
        assertThat(boxSpeed).isEqualTo(1.6, within(1e-9));
        assertThat(plankSpeed).isEqualTo(-0.4, within(1e-9));
    }

    /** Where two outlines meet their speeds add: 1 of the floor's and 1 of the box's own. */
    @Test
    void surfaceSpeedsAdd() {
        Pool pool = pool(Accuracy.DRAFT);
        BodyDefinition floor = BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5);
        pool.add(floor.material(ROUGH.surfaceSpeed(1)));
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 0.5))
                                .at(0, 0.25)
                                .material(ROUGH.surfaceSpeed(1)));
        Scenes.run(pool, 120);
        assertThat(box.velocityX()).isEqualTo(-2, within(1e-9));
    }

    /** A pile too large to be solved whole is carried as well: 80 boxes, 240 rows on the belt. */
    @Test
    void largePileIsCarried() {
        Pool pool = pool(Accuracy.GAME);
        pool.add(
                BodyDefinition.fixed(Polygon.box(200, 1))
                        .at(0, -0.5)
                        .material(ROUGH.surfaceSpeed(-2)));
        for (int i = 0; i < 80; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.5)).at(i - 40, 0.25).material(ROUGH));
        }
        Scenes.run(pool, 180);
        for (RigidBody body : pool.bodies().subList(1, 81)) {
            assertThat(body.velocityX()).isEqualTo(2, within(1e-3));
        }
    }
}
