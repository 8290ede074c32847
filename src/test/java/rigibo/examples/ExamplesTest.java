package rigibo.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Checks of what each example shows. */
class ExamplesTest {

    /**
     * Driven evenly, it is halfway after half the time. What stands on it is carried in its frame:
     * a start and a stop of 2 m/s press and lift by no more than 0.1 mm, GAME's tolerance.
     */
    @Test
    void theLiftTakesAlongWhatStandsOnIt() {
        MovingLift example = new MovingLift();
        Pool pool = example.open();
        for (int i = 1; i <= 4; i++) {
            example.run(pool, 0.5);
            double height = example.lift.y() + 0.1;
            assertThat(height).isCloseTo(i * MovingLift.RISE / 4, within(1e-9));
            assertThat(example.crate.y() - 0.4).isCloseTo(height, within(1e-4));
            assertThat(example.crate.x()).isCloseTo(-0.5, within(1e-4));
        }
    }

    /**
     * Thrown at 8 m/s it rises 3.26 m, past the shelf and untouched by it, and comes to lie there.
     */
    @Test
    void theShelfLetsTheBallPassFromBelowOnly() {
        MovingLift example = new MovingLift();
        Pool pool = example.open();
        double highest = 0;
        for (int i = 0; i < 180; i++) {
            example.run(pool, 1.0 / 60);
            highest = Math.max(highest, example.ball.y());
        }
        // Seen at steps it is less by up to g·dt²/8.
        assertThat(highest).isCloseTo(0.3 + 64 / (2 * 9.81), within(0.001));
        double top = example.shelf.y() + 0.1;
        assertThat(example.ball.y() - 0.3).isCloseTo(top, within(1e-3));
    }

    /**
     * The ball flies along the parabola that the coins hang on, past each at the time it was hung
     * for: after t seconds it has met those hung for less than t, and one more that its rim meets.
     */
    @Test
    void theBallCollectsEveryCoinOnItsWayAndNoneBefore() {
        Coins example = new Coins();
        Pool pool = example.open();
        example.run(pool, 0.05);
        assertThat(example.collected).isZero();
        for (int due = 1; due < 5; due++) {
            example.run(pool, due == 1 ? 0.2 + 1.0 / 60 : 0.25);
            assertThat(example.collected).isBetween(due, due + 1);
        }
        example.run(pool, 3);
        assertThat(example.collected).isEqualTo(Coins.COUNT);
        assertThat(pool.bodies()).hasSize(3);
    }

    /** One chain round the air: none of the guests leaves it through a corner or an edge. */
    @Test
    void theCaveKeepsItsGuests() {
        Cave example = new Cave();
        Pool pool = example.open();
        example.run(pool, 10);
        double wall = 1.13;
        assertThat(example.guests)
                .hasSize(30)
                .allMatch(guest -> Math.abs(guest.x()) < wall * Cave.HALF_WIDTH)
                .allMatch(guest -> Math.abs(guest.y() - 4) < wall * 3)
                .noneMatch(RigidBody::isAwake);
    }

    @Test
    void shotsPassThroughFriendsAndHitEnemies() {
        BulletFilters example = new BulletFilters();
        Pool pool = example.open();
        double x = example.friend.x();
        example.run(pool, 3);
        assertThat(example.friend.x()).isEqualTo(x);
        // Shots leave at 0.5, 1, … 2.5 s, and are there after 5.2 m of 60 m/s.
        assertThat(example.hits).isEqualTo(5);
    }

    @Test
    void theCupLosesNoBallUntilItPours() {
        CarryingCup example = new CarryingCup();
        Pool pool = example.open();
        example.run(pool, 4.4);
        assertThat(example.cup.x()).isGreaterThan(CarryingCup.FAR - 0.1);
        assertThat(example.balls)
                .allMatch(ball -> Math.abs(ball.x() - CarryingCup.FAR) < 0.65 && ball.y() > 3.5);
        example.run(pool, 4.6);
        assertThat(example.balls).allMatch(ball -> ball.y() > 0.3 && ball.y() < 2);
    }

    /**
     * Every velocity falls as e^(−kt) between impacts, and impacts of elasticity 1 without friction
     * keep the energy, so the energy falls as e^(−2kt) whatever meets. Impacts are resolved to
     * rounding; some hundred of them leave 1e-9.
     */
    @Test
    void theEnergyOfBilliardsFallsEvenlyHoweverTheyMeet() {
        Billiards example = new Billiards();
        Pool pool = example.open();
        double atFirst = pool.kineticEnergy();
        long moved = 0;
        for (int second = 1; second <= 5; second++) {
            example.run(pool, 1);
            double expected = atFirst * Math.exp(-2 * Billiards.CLOTH * pool.time());
            assertThat(pool.kineticEnergy()).isCloseTo(expected, within(1e-9 * atFirst));
            moved =
                    pool.bodies().stream()
                            .filter(body -> Math.hypot(body.velocityX(), body.velocityY()) > 0.01)
                            .count();
        }
        assertThat(moved).isGreaterThan(8);
    }

    /**
     * A solid disc that rolls has a = ⅔·g·sin θ along the rail, tan θ = 0.24 being far below three
     * times the friction. GAME's step is of order two: 1e-3 of the way after one second.
     */
    @Test
    void marblesRollDownTheFirstRailAsDiscsDoAndArriveInTheirOrder() {
        MarbleRun example = new MarbleRun();
        Pool pool = example.open();
        example.run(pool, 0.1);
        RigidBody first = example.marbles.get(0);
        double x = first.x();
        double v = Math.hypot(first.velocityX(), first.velocityY());
        example.run(pool, 1);
        double a = 2.0 / 3 * 9.81 * Math.sin(MarbleRun.SLOPE);
        double way = v + a / 2;
        assertThat((first.x() - x) / Math.cos(MarbleRun.SLOPE)).isCloseTo(way, within(1e-3 * way));
        example.run(pool, 30);
        assertThat(example.marbles).hasSize(8).allMatch(marble -> marble.y() < 1.2);
    }

    /** The two sides are mirror images: neither gets more. Rounding of some kN·s. */
    @Test
    void theBlastDrivesBothSidesEqually() {
        Blast example = new Blast();
        Pool pool = example.open();
        example.run(pool, Blast.AT);
        double before = pool.kineticEnergy();
        example.run(pool, 1.0 / 60);
        assertThat(pool.kineticEnergy()).isGreaterThan(before + 1000);
        assertThat(pool.momentumX()).isCloseTo(0, within(1e-9));
    }

    /** Within the radius the impulse is 150 N·s for each metre of the disc's width of 0.4 m. */
    @Test
    void aBlastGivesADiscItsImpulseForEachMetreOfWidth() {
        Pool pool = new Pool(Effects.of(new Contacts()), Accuracy.GAME);
        RigidBody disc = pool.add(BodyDefinition.dynamic(new Circle(0.2)).mass(3).at(1, 0));
        pool.explode(Explosion.at(0, 0).radius(1.5).impulsePerMetre(150));
        assertThat(disc.velocityX()).isCloseTo(150 * 0.4 / 3, within(1e-9));
    }

    /** It jumps by v²/2g over its stand, sampled at steps: less by up to g·dt²/8 = 0.4 mm. */
    @Test
    void theWalkerJumpsTurnsAtCliffsAndNeverFalls() {
        Walker example = new Walker();
        Pool pool = example.open();
        double highest = 0;
        int turns = 0;
        for (int i = 0; i < 30 * 60; i++) {
            int direction = example.direction;
            example.run(pool, 1.0 / 60);
            turns += direction == example.direction ? 0 : 1;
            boolean isFirstJump = pool.time() < 1.5;
            highest = isFirstJump ? Math.max(highest, example.walker.y() - 0.7) : highest;
            assertThat(example.walker.y()).isGreaterThan(0.699);
            assertThat(Math.abs(example.walker.velocityX())).isLessThanOrEqualTo(2 + 1e-9);
        }
        assertThat(turns).isGreaterThan(4);
        double jump = Walker.JUMP * Walker.JUMP / (2 * 9.81);
        assertThat(highest).isCloseTo(jump, within(0.01));
    }
}
