package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.stream.Stream;

class PlanWordsTest {

    private static final Gravity GRAVITY = new Gravity(0, -9.81);

    private static Effects most() {
        return Effects.of(
                GRAVITY,
                new CentralForce(0, 0, 1, 2),
                new Thrust(),
                new Wind(1, 0),
                new Drag(),
                new Contacts(),
                new ContinuousImpacts(),
                new Friction(),
                new RollingResistance(),
                new SurfaceSpeed(),
                new Restitution(),
                new Rotation(),
                new Joints(),
                new Sensors(),
                new Sleep());
    }

    /** Between them they have every part of a step. */
    private static Stream<Pool> pools(Preset preset) {
        Pool locked = new Pool(most(), preset.accuracy());
        locked.add(BodyDefinition.dynamic(new Circle(1)).lockX());
        Effects plain = Effects.of(GRAVITY);
        Effects discrete = Effects.of(GRAVITY, new Contacts());
        return Stream.of(
                locked,
                new Pool(most(), preset.accuracy()),
                new Pool(plain, preset.accuracy()),
                new Pool(discrete, preset.accuracy()));
    }

    @ParameterizedTest
    @EnumSource
    void englishPlanIsThatOfTheEngine(Preset preset) {
        PlanWords words = new PlanWords(new Words("en"));
        pools(preset).forEach(pool -> assertThat(words.of(pool.plan())).isEqualTo(pool.plan()));
    }

    @ParameterizedTest
    @EnumSource
    void noLineOfTheGermanPlanIsEnglish(Preset preset) {
        PlanWords words = new PlanWords(new Words("de"));
        pools(preset)
                .forEach(
                        pool -> {
                            List<String> german = words.of(pool.plan()).lines().toList();
                            assertThat(german)
                                    .doesNotContainAnyElementsOf(pool.plan().lines().toList());
                            assertThat(german).hasSameSizeAs(pool.plan().lines().toList());
                        });
    }

    @Test
    void numbersStandInTheirLines() {
        String plan =
                "CONTACT    solve islands in 4 substeps: loads, friction\n"
                        + "columns    pose, mass: 2488 bits a body";
        assertThat(new PlanWords(new Words("de")).of(plan))
                .isEqualTo(
                        "KONTAKT    Inseln in 4 Teilschritten lösen: Lasten, Reibung\n"
                                + "Spalten    Lage, Masse: 2488 Bit je Körper");
    }
}
