package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.force.ChangingForces;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;

/** Impacts of bodies under a drag that varies along the path, k = 0.1/s. */
class CourseOfImpactsTest {

    private static final double K = 0.1;
    private static final double DT = 0.1;

    /** Bound on the error of a laid path: j·T³/40 with j = k²·v, m and m/s. */
    private static final double OFF = 1e-5;

    private final Field drag = new Field(at -> at.accelerate(-K * at.velocityX, -K * at.velocityY));
    private final Air air =
            new Air(Accuracy.EXACT, drag, new Contacts(), new Rotation(), new Restitution());

    private void fly() {
        Effects effects = Effects.of(drag, new Contacts(), new Rotation(), new Restitution());
        ChangingForces forces = new ChangingForces(effects);
        Course course = new Course(air.storage.data, forces, air.accuracy);
        air.storage.data.roster.refresh(air.bodies);
        course.begin(DT);
        air.meet(DT);
        new Flight(air.storage.data, air.narrowphase, air.broadphase, air.accuracy, course).fly(DT);
    }

    /** Distance covered under drag: v₀(1 − e^(−kt))/k. */
    private static double way(double speed) {
        return speed * (1 - Math.exp(-K * DT)) / K;
    }

    /** At e = 1 a wall reflects the path and the velocity, and changes nothing else. */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2, 0.35})
    void aWallFoldsTheWay(double gap) {
        air.add(Air.wall(1 + gap, 1));
        int disc = air.add(Air.disc(0, 4, 1).spin(2));
        fly();

        Bodies bodies = air.bodies;
        assertThat(air.storage.data.counters.impacts).isEqualTo(1);
        assertThat(bodies.x[disc]).isEqualTo(2 * gap - way(4), within(OFF));
        assertThat(bodies.velocityX[disc]).isEqualTo(-4 * Math.exp(-K * DT), within(OFF));
    }

    /** Drag acts on the striking body up to the impact, and on the struck body from then on. */
    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2, 0.35})
    void theStruckGoesOnForTheStriker(double gap) {
        int striker = air.add(Air.disc(0, 4, 1));
        int struck = air.add(Air.body(new Circle(1), 1).at(2 + gap, 0));
        fly();

        Bodies bodies = air.bodies;
        assertThat(bodies.x[striker]).isEqualTo(gap, within(OFF));
        assertThat(bodies.velocityX[striker]).isEqualTo(0, within(OFF));
        assertThat(bodies.x[struck]).isEqualTo(2 + way(4), within(OFF));
        assertThat(bodies.velocityX[struck]).isEqualTo(4 * Math.exp(-K * DT), within(OFF));
    }
}
