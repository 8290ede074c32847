package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** Against whose velocity the speeds of a pile are asked. */
class CarriersTest {

    private static final BodyDefinition BOX = BodyDefinition.dynamic(Polygon.box(1, 1));
    private static final BodyDefinition FLOOR = BodyDefinition.kinematic(Polygon.box(9, 1));

    private final FilledStorage storage = new FilledStorage(new Contacts(), new Rotation());
    private final Carriers carriers = new Carriers(storage.data);

    private int add(BodyDefinition body) {
        return storage.add(body);
    }

    private void touch(int a, int b) {
        storage.pairs.points[storage.pair(Math.min(a, b), Math.max(a, b))] = 1;
    }

    private void assertCarried(int body, double vx, double vy) {
        assertThat(carriers.velocityX(body)).isEqualTo(vx);
        assertThat(carriers.velocityY(body)).isEqualTo(vy);
    }

    @Test
    void aPileGoesWithTheFloorThatCarriesIt() {
        int floor = add(FLOOR.velocity(2, 1));
        int lower = add(BOX);
        int upper = add(BOX);
        int other = add(BOX);
        touch(floor, lower);
        touch(lower, upper);
        carriers.begin();
        assertCarried(lower, 2, 1);
        assertCarried(upper, 2, 1);
        assertCarried(other, 0, 0);
    }

    @Test
    void aFloorThatStandsCarriesNobodyAnywhere() {
        int floor = add(FLOOR);
        int box = add(BOX);
        touch(floor, box);
        carriers.begin();
        assertCarried(box, 0, 0);
    }

    @Test
    void whoIsOnlyNearIsNotCarried() {
        int floor = add(FLOOR.velocity(2, 0));
        int box = add(BOX);
        storage.pair(floor, box);
        carriers.begin();
        assertCarried(box, 0, 0);
    }

    /** Its frame is that of the ground it leans on as much as that of the floor. */
    @Test
    void aPileThatLeansOnAWallIsSeenFromTheWorld() {
        int floor = add(FLOOR.velocity(2, 0));
        int wall = add(BodyDefinition.fixed(Polygon.box(1, 9)));
        int between = add(BOX);
        int beside = add(BOX);
        int apart = add(BOX);
        touch(floor, between);
        touch(floor, apart);
        touch(between, beside);
        touch(wall, beside);
        carriers.begin();
        assertCarried(between, 0, 0);
        assertCarried(beside, 0, 0);
        assertCarried(apart, 2, 0);
    }

    @Test
    void aWallThatGoesAlongIsNoHindrance() {
        int floor = add(FLOOR.velocity(2, 0));
        int wall = add(FLOOR.velocity(2, 0));
        int box = add(BOX);
        touch(floor, box);
        touch(wall, box);
        carriers.begin();
        assertCarried(box, 2, 0);
    }

    /** Each of its points has another velocity. */
    @Test
    void whatTurnsCarriesNobody() {
        int wheel = add(FLOOR.velocity(2, 0).spin(1));
        int box = add(BOX);
        touch(wheel, box);
        carriers.begin();
        assertCarried(box, 0, 0);
    }

    @Test
    void sleepersAreNotCarried() {
        int floor = add(FLOOR.velocity(2, 0));
        int box = add(BOX);
        storage.bodies.awake[box] = false;
        touch(floor, box);
        carriers.begin();
        assertCarried(box, 0, 0);
    }

    @Test
    void whatJoinsIsCarriedAsWhatItJoins() {
        int floor = add(FLOOR.velocity(2, 1));
        int box = add(BOX);
        int flyer = add(BOX);
        touch(floor, box);
        carriers.begin();
        carriers.join(flyer, box);
        assertCarried(flyer, 2, 1);
    }

    @Test
    void aFloorThatHasStoppedCarriesNobodyAnyMore() {
        int floor = add(FLOOR.velocity(2, 0));
        int box = add(BOX);
        touch(floor, box);
        carriers.begin();
        storage.bodies.velocityX[floor] = 0;
        storage.data.roster.isStale = true;
        storage.data.roster.refresh(storage.bodies);
        carriers.begin();
        assertCarried(box, 0, 0);
    }
}
