package rigibo.backend.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.FieldPoint;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Polygon;

import java.util.Arrays;
import java.util.Collections;
import java.util.Random;

/** Which declared effects change along a body's way, and that all of them are summed. */
class ChangingForcesTest {

    private static final Gravity GRAVITY = new Gravity(1, -9.81);
    private static final Wind STEADY = new Wind(6, -2);
    private static final Wind GUSTY = new Wind(6, -2, time -> time / 3);
    private static final AirDrag AIR = new AirDrag(1.2, 2);
    private static final Buoyancy WATER = new Buoyancy(2, 3, 0.5);
    private static final CentralForce CENTRE = new CentralForce(10, 20, 3, -1);
    private static final Field FIELD =
            new Field(at -> at.push(at.velocityY * at.mass, -at.time * at.x * at.mass));

    /** Anything but 0, 1 and 2, so that every term shows. */
    private static Instant somewhere() {
        Instant at = Instants.of(Polygon.box(2, 1), 3, 4, 0.3);
        at.drag = 0.7;
        at.time = 1.5;
        at.x = 1.25;
        at.y = 1.75;
        at.velocityX = 4;
        at.velocityY = -2.5;
        at.spin = 0.6;
        // Left over from the body before.
        at.accelerationX = 100;
        at.accelerationY = 200;
        at.angularAcceleration = 300;
        return at;
    }

    private static Instant by(Effect... effects) {
        Instant at = somewhere();
        new ChangingForces(Effects.of(effects)).evaluate(at);
        return at;
    }

    private static void requireNothing(Instant at) {
        assertThat(at.accelerationX).isZero();
        assertThat(at.accelerationY).isZero();
        assertThat(at.angularAcceleration).isZero();
    }

    /** Constant along a step, or part of the path itself. */
    @Test
    void whatIsSteadyIsNotOnTheList() {
        Effect[] steady = {GRAVITY, new Thrust(), new Rotation(), new Drag(), STEADY};
        assertThat(new ChangingForces(Effects.of(steady)).isEmpty()).isTrue();
        requireNothing(by(steady));
    }

    @Test
    void everyForceThatChangesIsOnTheList() {
        assertThat(new ChangingForces(Effects.of(AIR)).isEmpty()).isFalse();
        assertThat(new ChangingForces(Effects.of(new Drag(), GUSTY)).isEmpty()).isFalse();
        assertThat(new ChangingForces(Effects.of(CENTRE)).isEmpty()).isFalse();
        assertThat(new ChangingForces(Effects.of(GRAVITY, WATER)).isEmpty()).isFalse();
        assertThat(new ChangingForces(Effects.of(FIELD)).isEmpty()).isFalse();
    }

    /** Half of the wind blows at 1.5 s; the drag is 0.7/s. */
    @Test
    void aGustBlowsAsTheDragTakesIt() {
        Instant at = by(new Drag(), GUSTY);
        assertThat(at.accelerationX).isEqualTo(0.7 * 3, within(1e-15));
        assertThat(at.accelerationY).isEqualTo(0.7 * -1, within(1e-15));
        assertThat(at.angularAcceleration).isZero();
    }

    /** Without linear drag a gust acts through the air's alone, at the speed of the difference. */
    @Test
    void aGustWithoutLinearDragIsTheAirs() {
        Instant gust = by(AIR, GUSTY);
        Instant alone = somewhere();
        alone.accelerationX = 0;
        alone.accelerationY = 0;
        new AirDragForce(AIR, GUSTY).add(alone);
        assertThat(gust.accelerationX).isEqualTo(alone.accelerationX);
        assertThat(gust.accelerationY).isEqualTo(alone.accelerationY);
    }

    @Test
    void withoutWindTheAirIsCalm() {
        Instant still = by(AIR);
        Instant calm = by(AIR, new Wind(0, 0));
        assertThat(still.accelerationX).isEqualTo(calm.accelerationX);
        assertThat(still.accelerationY).isEqualTo(calm.accelerationY);
    }

    /** The field is told all there is to know, and starts from nothing. */
    @Test
    void aFieldIsToldOfTheInstant() {
        FieldPoint told = new FieldPoint();
        Field field =
                new Field(
                        at -> {
                            told.x = at.x;
                            told.y = at.y;
                            told.velocityX = at.velocityX;
                            told.velocityY = at.velocityY;
                            told.mass = at.mass;
                            told.time = at.time;
                            told.accelerationX = at.accelerationX;
                            told.accelerationY = at.accelerationY;
                            at.push(6, 9);
                        });
        ChangingForces forces = new ChangingForces(Effects.of(CENTRE, field));
        Instant at = somewhere();
        forces.evaluate(at);
        forces.evaluate(at);

        assertThat(told).usingRecursiveComparison().isEqualTo(expected());
        Instant central = by(CENTRE);
        assertThat(at.accelerationX).isEqualTo(central.accelerationX + 2, within(1e-15));
        assertThat(at.accelerationY).isEqualTo(central.accelerationY + 3, within(1e-15));
        assertThat(at.angularAcceleration).isZero();
    }

    private static FieldPoint expected() {
        FieldPoint point = new FieldPoint();
        point.x = 1.25;
        point.y = 1.75;
        point.velocityX = 4;
        point.velocityY = -2.5;
        point.mass = 3;
        point.time = 1.5;
        return point;
    }

    /** To the bit, in whatever order they were declared. */
    @Test
    void theOrderOfDeclarationDoesNotMatter() {
        Effect[] all = {AIR, new Drag(), GUSTY, CENTRE, GRAVITY, WATER, FIELD};
        Instant first = by(all);
        Random random = new Random(5);
        for (int i = 0; i < 20; i++) {
            Collections.shuffle(Arrays.asList(all), random);
            Instant again = by(all);
            assertThat(again.accelerationX).isEqualTo(first.accelerationX);
            assertThat(again.accelerationY).isEqualTo(first.accelerationY);
            assertThat(again.angularAcceleration).isEqualTo(first.angularAcceleration);
        }
    }

    /** Forces superpose, within the round-off of five terms of some tens of m/s². */
    @Test
    void forcesAreSummed() {
        Instant all = by(AIR, new Drag(), GUSTY, CENTRE, GRAVITY, WATER, FIELD);
        Instant[] alone = {
            by(AIR, GUSTY), by(new Drag(), GUSTY), by(CENTRE), by(GRAVITY, WATER), by(FIELD)
        };
        double x = Arrays.stream(alone).mapToDouble(at -> at.accelerationX).sum();
        double y = Arrays.stream(alone).mapToDouble(at -> at.accelerationY).sum();
        double turn = Arrays.stream(alone).mapToDouble(at -> at.angularAcceleration).sum();

        assertThat(alone).allSatisfy(at -> assertThat(at.accelerationX).isNotZero());
        assertThat(all.accelerationX).isEqualTo(x, within(1e-13));
        assertThat(all.accelerationY).isEqualTo(y, within(1e-13));
        assertThat(all.angularAcceleration).isEqualTo(turn, within(1e-13));
    }
}
