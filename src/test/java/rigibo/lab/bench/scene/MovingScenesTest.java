package rigibo.lab.bench.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.probe.DeepestOverlap;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.World;

import java.util.List;
import java.util.NoSuchElementException;

class MovingScenesTest {

    private static List<Engine> engines() {
        return Engines.all();
    }

    private static World world(Engine engine, Effects effects) {
        return engine.world(effects, engine.settings().get(0));
    }

    /** Pyramids have the sum of 1 to their base, towers their storeys each. */
    @ParameterizedTest
    @CsvSource({
        "rain-boxes-10, 10",
        "rain-discs-1500, 1500",
        "rain-mixed-50, 50",
        "settle-30, 465",
        "struck, 820",
        "towers, 600",
        "belt, 80",
        "shaken, 100",
        "rods, 300",
        "compounds, 1500",
        "capsules, 1500",
        "cave, 500",
        "joint-grid, 898",
        "ragdolls, 1100",
        "bridge, 250",
        "doors, 50",
        "cars, 90"
    })
    void sceneHasAsManyBodiesAsItSays(String name, int bodies) {
        assertThat(MovingScenes.named(name).scene().get().dynamic()).isEqualTo(bodies);
    }

    /** Overlap at the start would be counted as if the engine had allowed it. */
    @Test
    void nothingOverlapsAtTheStartAndNothingSleeps() {
        Engine ours = Engines.all().get(0);
        for (BenchScene moving : MovingScenes.all()) {
            Scene scene = moving.scene().get();
            assertThat(scene.effects().declares(Sleep.class)).as(moving.name()).isFalse();
            try (World world = world(ours, scene.effects())) {
                scene.build(world);
                assertThat(DeepestOverlap.inWidths(scene, world))
                        .as(moving.name())
                        // Round-off of places of some 100 m, in widths of 0.02 m and more.
                        .isLessThan(1e-11);
            }
        }
    }

    @Test
    void sceneThatIsNotThereIsNamed() {
        assertThatThrownBy(() -> MovingScenes.named("moon"))
                .isInstanceOf(NoSuchElementException.class)
                .hasMessageContaining("'moon'");
    }

    /** 3 Hz: a twelfth of a second on, after five steps, its middle is at a·sin(π/2). */
    @ParameterizedTest
    @MethodSource("engines")
    void trayIsFarthestAfterAQuarterOfItsPeriod(Engine engine) {
        Tray tray = new Tray(4, 6, 0.2, 3);
        List<BodyDefinition> walls = tray.bodies(Crowd.STONE);
        try (World world = world(engine, Crowd.EFFECTS)) {
            walls.forEach(world::add);
            for (int i = 0; i < 5; i++) {
                tray.drive(world, i);
                world.step(Scene.STEP);
            }
            for (int i = 0; i < walls.size(); i++) {
                // Some engines keep places in floats.
                assertThat(world.x(i) - walls.get(i).x()).isCloseTo(0.2, within(1e-5));
            }
        }
    }

    /** Momentum: J/m, whatever way an engine integrates a force that lasts one step. */
    @ParameterizedTest
    @MethodSource("engines")
    void strokeGivesItsImpulse(Engine engine) {
        Scene struck = Commotions.struck(2);
        Effects space = struck.effects().with(new Gravity(0, 0));
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.5)).mass(2).at(0, 0);
        Striker striker = new Striker(0, 6, 3);
        try (World world = world(engine, space)) {
            world.add(disc);
            for (int i = 0; i < 5; i++) {
                striker.drive(world, i);
                world.step(Scene.STEP);
            }
            assertThat(world.velocityX(0)).isCloseTo(3, within(1e-5));
        }
    }

    @ParameterizedTest
    @MethodSource("engines")
    void beltSlidesInEveryEngine(Engine engine) {
        Scene scene = Commotions.belt(4);
        try (World world = world(engine, scene.effects())) {
            world.add(scene.bodies().get(0));
            for (int i = 0; i < 60; i++) {
                scene.driver().drive(world, i);
                world.step(Scene.STEP);
            }
            assertThat(world.x(0)).isCloseTo(3, within(1e-4));
        }
    }
}
