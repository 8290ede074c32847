package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.RecordingSounds;
import rigibo.frontend.scene.Skin;

/** Demos are heard as levels are. */
class DemoSoundsTest {

    private static final double STEP = 1.0 / 60;

    @Test
    void whatIsDroppedOnAWorkbenchKnocksWithItsSkinUntilItRests() {
        Effects effects = Effects.of(new Gravity(0, -9.81), new Contacts(), new Rotation());
        Workbench bench = new Workbench(effects, new Camera(0, 0, 40));
        RecordingSounds sounds = new RecordingSounds();
        bench.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, -0.5), Skin.STONE);
        RigidBody crate =
                bench.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 1.5), Skin.WOOD);
        for (int i = 0; i < 120; i++) {
            bench.step(STEP);
            bench.tell(sounds);
        }
        assertThat(crate.y()).isLessThan(0.51);
        // Nothing bounces: restitution is not declared.
        assertThat(sounds.knocks)
                .hasSize(1)
                .allSatisfy(knock -> assertThat(knock.skin()).isEqualTo(Skin.WOOD));
    }
}
