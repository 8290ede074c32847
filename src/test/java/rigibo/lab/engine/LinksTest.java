package rigibo.lab.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.List;

/** Joints mean the same in every engine: which way they turn, slide, and stop. */
class LinksTest {

    private static final Effects SPACE = Effects.of(new Contacts(), new Rotation(), new Joints());
    private static final Effects EARTH = SPACE.with(new Gravity(0, -9.81));
    private static final BodyDefinition HOOK = BodyDefinition.fixed(new Circle(0.1));

    /** 5 cm: the peers hold their joints by springs of their own. */
    private static final double SOFT = 0.05;

    static List<Engine> engines() {
        return Engines.all();
    }

    private static World world(
            Engine engine, Effects effects, List<BodyDefinition> bodies, Link link) {
        World world = engine.world(effects, engine.settings().get(0));
        bodies.forEach(world::add);
        world.join(link);
        return world;
    }

    private static void run(World world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step(1.0 / 60);
        }
    }

    /** A bar that falls to the right turns clockwise: to its lower limit. */
    @ParameterizedTest
    @MethodSource("engines")
    void hingeStopsAtItsLowerLimit(Engine engine) {
        BodyDefinition bar = BodyDefinition.dynamic(Polygon.box(1, 0.1)).at(0.5, 0);
        Link hinge = Link.hinge(0, 1, 0, 0).limits(-0.3, 1);
        try (World world = world(engine, EARTH, List.of(HOOK, bar), hinge)) {
            run(world, 300);
            assertThat(world.angle(1)).isCloseTo(-0.3, within(SOFT));
            assertThat(new LinkErrors(List.of(HOOK, bar), List.of(hinge)).worst(world))
                    .isLessThan(SOFT);
        }
    }

    @ParameterizedTest
    @MethodSource("engines")
    void hingeTurnsItsSecondBodyAtTheMotorsSpeed(Engine engine) {
        BodyDefinition wheel = BodyDefinition.dynamic(new Circle(0.5));
        Link hinge = Link.hinge(0, 1, 0, 0).motor(-2, 100);
        try (World world = world(engine, SPACE, List.of(HOOK, wheel), hinge)) {
            run(world, 120);
            assertThat(world.spin(1)).isCloseTo(-2, within(1e-3));
        }
    }

    @ParameterizedTest
    @MethodSource("engines")
    void wheelTurnsAtTheMotorsSpeedAndKeepsToItsAxis(Engine engine) {
        BodyDefinition wheel = BodyDefinition.dynamic(new Circle(0.5)).velocity(1, 0);
        Link strut = Link.wheel(0, 1, 0, 0, 0, 1).spring(3, 0.7).motor(-2, 100);
        try (World world = world(engine, SPACE, List.of(HOOK, wheel), strut)) {
            run(world, 120);
            assertThat(world.spin(1)).isCloseTo(-2, within(1e-3));
            assertThat(world.x(1)).isCloseTo(0, within(SOFT));
        }
    }

    /** Rapier has ropes and springs, but no rods. */
    @ParameterizedTest
    @MethodSource("engines")
    void rodKeepsItsLengthOrIsRefused(Engine engine) {
        BodyDefinition bob = BodyDefinition.dynamic(new Circle(0.1)).at(1, 0);
        Link rod = Link.rod(0, 0, 0, 1, 1, 0);
        if (engine.name().startsWith("Rapier")) {
            assertThatThrownBy(() -> world(engine, EARTH, List.of(HOOK, bob), rod))
                    .isInstanceOf(UnsupportedOperationException.class)
                    .hasMessage("rods");
            return;
        }
        try (World swings = world(engine, EARTH, List.of(HOOK, bob), rod)) {
            run(swings, 60);
            assertThat(Math.hypot(swings.x(1), swings.y(1))).isCloseTo(1, within(SOFT));
        }
    }

    @ParameterizedTest
    @MethodSource("engines")
    void weldKeepsItsPlace(Engine engine) {
        BodyDefinition bob = BodyDefinition.dynamic(new Circle(0.1)).at(1, 0);
        Link weld = Link.weld(0, 1, 0, 0);
        try (World stays = world(engine, EARTH, List.of(HOOK, bob), weld)) {
            run(stays, 60);
            assertThat(stays.y(1)).isCloseTo(0, within(SOFT));
        }
    }

    @ParameterizedTest
    @MethodSource("engines")
    void slideStopsAtItsLowerLimit(Engine engine) {
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(0.4, 0.4)).at(2, 0);
        Link slide = Link.slide(0, 1, 2, 0, 2, 1).limits(-0.5, 1);
        try (World world = world(engine, EARTH, List.of(HOOK, box), slide)) {
            run(world, 120);
            assertThat(world.y(1)).isCloseTo(-0.5, within(SOFT));
            assertThat(world.angle(1)).isCloseTo(0, within(SOFT));
        }
    }
}
