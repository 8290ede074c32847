package rigibo.lab.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

import java.util.ArrayList;
import java.util.List;

/** The reference of the demos stands for the truth. */
class DemosTest {

    /** Round-off of a second's steps is far below, m. */
    private static final double NOTHING = 1e-9;

    private static List<DemoScene> scenes() {
        return DemoScenes.all();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyHalvingOfTheStepComesNearerToTheReference(DemoScene scene) {
        double[][] reference = Demos.reference(scene);
        double before = Double.POSITIVE_INFINITY;
        for (int steps = 2; steps <= 16; steps *= 2) {
            double off = Demos.distance(exact(scene, steps), reference);
            assertThat(off)
                    .as("%s, %d steps a look", scene.name(), steps)
                    .isLessThan(Math.max(before, NOTHING));
            before = off;
        }
    }

    /**
     * Sideways, so that nothing is lifted: 1e-9 m is also what EXACT tolerates below a body at
     * rest.
     */
    @ParameterizedTest
    @MethodSource("scenes")
    void nanometreAtTheStartStaysBelowAMicrometre(DemoScene scene) {
        List<BodyDefinition> moved = new ArrayList<>();
        for (BodyDefinition body : scene.bodies()) {
            double aside = moved.size() % 2 == 0 ? 1e-9 : -1e-9;
            boolean moves = body.type() == BodyType.DYNAMIC;
            moved.add(moves ? body.at(body.x() + aside, body.y()) : body);
        }
        DemoScene beside =
                new DemoScene(scene.name(), scene.looks(), scene.effects(), scene.thrust(), moved);
        double apart = Demos.farthest(exact(scene, 2), exact(beside, 2));
        assertThat(apart).as(scene.name()).isLessThan(1e-6);
    }

    private static double[][] exact(DemoScene scene, int steps) {
        try (World world = RigiBoEngine.world(scene.effects(), Accuracy.EXACT)) {
            return scene.places(scene.build(world), steps, at -> at.step(DemoScene.LOOK / steps));
        }
    }
}
