package rigibo.frontend.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.HashMap;
import java.util.Map;

/** Impacts are heard, resting contacts are not. */
class ImpactsTest {

    private static final double STEP = 1.0 / 60;
    private static final double GRAVITY = 9.81;

    /** Nothing bounces. */
    private static final Material DULL = new Material(500, 0.5, 0);

    private final Pool pool = new Pool();
    private final Map<RigidBody, Skin> skins = new HashMap<>();
    private final Impacts impacts = new Impacts();
    private final RecordingSounds sounds = new RecordingSounds();

    private RigidBody box(double size, double x, double y, Skin skin) {
        RigidBody box =
                pool.add(BodyDefinition.dynamic(Polygon.box(size, size)).at(x, y).material(DULL));
        skins.put(box, skin);
        return box;
    }

    private void floor() {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5).material(DULL));
    }

    private void run(double seconds) {
        for (int i = 0; i < Math.round(seconds / STEP); i++) {
            pool.step(STEP);
            impacts.tell(pool, skins::get, sounds);
        }
    }

    /** It arrives with v = √(2gh) and stops there: the floor gives it m·v. */
    @Test
    void aBoxThatDropsKnocksOnceWithTheMomentumItHad() {
        floor();
        double height = 1.25;
        RigidBody box = box(0.8, 0, 0.4 + height, Skin.STONE);
        double momentum = box.mass() * Math.sqrt(2 * GRAVITY * height);
        run(3);
        assertThat(sounds.knocks).hasSize(1);
        RecordingSounds.Knock knock = sounds.knocks.get(0);
        assertThat(knock.skin()).isEqualTo(Skin.STONE);
        assertThat(knock.size()).isCloseTo(0.8, within(1e-12));
        // The weight presses on it for the rest of the step, too.
        assertThat(knock.impulse())
                .isBetween(0.99 * momentum, 1.01 * momentum + box.mass() * GRAVITY * STEP);
    }

    @Test
    void aStackThatRestsIsSilent() {
        floor();
        for (int i = 0; i < 5; i++) {
            box(0.8, 0, 0.4 + 0.8 * i, Skin.RIGIBO);
        }
        run(5);
        assertThat(sounds.knocks).isEmpty();
    }

    @Test
    void ofTwoBodiesTheLighterIsHeard() {
        floor();
        box(2, 0, 1, Skin.IRON);
        box(0.5, 0, 3.5, Skin.WOOD);
        run(3);
        assertThat(sounds.knocks)
                .isNotEmpty()
                .allSatisfy(knock -> assertThat(knock.skin()).isEqualTo(Skin.WOOD));
    }

    @Test
    void whatSlidesOnIsHeardNoMoreThanWhatRests() {
        floor();
        box(1, -5, 0.5, Skin.ICE).velocity(3, 0);
        run(3);
        assertThat(sounds.knocks).isEmpty();
    }
}
