package rigibo.lab.bench.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Sleep;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.World;

import java.util.List;
import java.util.NoSuchElementException;
import java.util.stream.Stream;

class BenchScenesTest {

    /** Sums of 1 to the base: a triangle each. */
    @ParameterizedTest
    @CsvSource({
        "pyramid, 820",
        "large-pyramid, 5050",
        "undermined-sleeper, 465",
        "undermined-awake, 465",
        "tumbler, 2025",
        "flood, 5000",
        "many-pyramids, 22000",
        "free, 20000",
        "flood-of-100, 100",
        "flood-of-50000, 50000"
    })
    void sceneHasAsManyBodiesAsItSays(String name, int bodies) {
        assertThat(BenchScenes.named(name).scene().get().dynamic()).isEqualTo(bodies);
    }

    @Test
    void nothingSleepsButWhatIsWokenAndEverythingMayMeet() {
        Stream.concat(BenchScenes.all().stream(), BenchScenes.sweep().stream())
                .forEach(
                        scene -> {
                            var effects = scene.scene().get().effects();
                            assertThat(effects.declares(Sleep.class))
                                    .as(scene.name())
                                    .isEqualTo(scene.name().equals("undermined-sleeper"));
                            assertThat(effects.declares(Contacts.class)).as(scene.name()).isTrue();
                        });
    }

    @Test
    void sceneThatIsNotThereIsNamed() {
        assertThatThrownBy(() -> BenchScenes.named("moon"))
                .isInstanceOf(NoSuchElementException.class)
                .hasMessageContaining("'moon'");
    }

    /** 25 above each other, each in a column of 0.65 m. */
    @Test
    void floodsOfTheSweepAreAsDeepAsEachOther() {
        for (BenchScene scene : BenchScenes.sweep()) {
            double highest =
                    scene.scene().get().bodies().stream()
                            .skip(3)
                            .mapToDouble(body -> body.y())
                            .max()
                            .orElseThrow();
            assertThat(highest).as(scene.name()).isCloseTo((4 + 24 * 2.4) * 0.25, within(0.7));
        }
    }

    @Test
    void fingerprintTellsScenesApart() {
        assertThat(Pyramids.one(3).fingerprint()).isEqualTo(Pyramids.one(3).fingerprint());
        assertThat(Pyramids.one(3).fingerprint()).isNotEqualTo(Pyramids.one(4).fingerprint());
        Scene scene = Pyramids.one(3);
        Scene frictionless = new Scene(scene.effects().without(Friction.class), scene.bodies());
        assertThat(frictionless.fingerprint()).isNotEqualTo(scene.fingerprint());
    }

    @Test
    void stepsThatAreAskedForReplaceThoseTimedAndBoundThoseBefore() {
        assertThat(new Pace(2, 60, 120).timing(10)).isEqualTo(new Pace(2, 10, 10));
        assertThat(new Pace(2, 60, 120).timing(200)).isEqualTo(new Pace(2, 60, 200));
        assertThat(Pace.parse(new Pace(0.5, 60, 120).words())).isEqualTo(new Pace(0.5, 60, 120));
    }

    private static List<Engine> engines() {
        return Engines.all();
    }

    /** 25°/s turn a quarter in 3.6 s, 216 steps: each wall is where the next one began. */
    @ParameterizedTest
    @MethodSource("engines")
    void drumTurnsAQuarterInEveryEngine(Engine engine) {
        Scene scene = Tumbler.of(2);
        int walls = Drum.WALLS;
        try (World world = engine.world(scene.effects(), engine.settings().get(0))) {
            scene.bodies().subList(0, walls).forEach(world::add);
            for (int i = 0; i < 216; i++) {
                scene.driver().drive(world, i);
                world.step(Scene.STEP);
            }
            for (int i = 0; i < walls; i++) {
                var next = scene.bodies().get((i + 1) % walls);
                assertThat(world.x(i)).isCloseTo(next.x(), within(1e-3));
                assertThat(world.y(i)).isCloseTo(next.y(), within(1e-3));
                double turned = world.angle(i) - scene.bodies().get(i).angle();
                // Some engines keep angles within half a turn.
                assertThat(Math.sin(turned)).isCloseTo(1, within(1e-3));
            }
        }
    }
}
