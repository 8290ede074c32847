package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Locks that change, and what a pool with locked bodies keeps and refuses. */
class AxisLockEditsTest {

    private static final double DT = 1 / 60.0;
    private static final double G = 9.81;

    @Test
    void locksChangeWhileTheBodyMoves() {
        Pool pool = new Pool(Effects.of(new Gravity(0, -G), new Contacts()), Accuracy.GAME);
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.5)).velocity(3, 0));
        for (int i = 0; i < 30; i++) {
            pool.step(DT);
        }
        double y = ball.y();
        ball.yLocked(true);
        assertThat(ball.yLocked()).isTrue();
        assertThat(ball.xLocked()).isFalse();
        assertThat(ball.velocityY()).isZero();
        assertThat(ball.velocityX()).isEqualTo(3);
        ball.velocity(2, 7);
        assertThat(ball.velocityY()).isZero();
        for (int i = 0; i < 30; i++) {
            pool.step(DT);
        }
        assertThat(ball.y()).isEqualTo(y);
        ball.yLocked(false);
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        assertThat(ball.y()).isEqualTo(y - G / 2, within(1e-9));
    }

    /** Bodies on a locked shelf fall when the shelf is unlocked, even if they sleep. */
    @Test
    void aShelfLetGoWakesWhatLiesOnIt() {
        Pool pool = new Pool();
        RigidBody shelf =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(3, 0.2)).lockX().lockY().lockRotation());
        RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(0, 0.35));
        for (int i = 0; i < 120; i++) {
            pool.step(DT);
        }
        assertThat(box.isAwake()).isFalse();
        assertThat(shelf.isAwake()).isFalse();
        shelf.yLocked(false);
        assertThat(box.isAwake()).isTrue();
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        assertThat(shelf.y()).isEqualTo(-G / 2, within(1e-2));
        assertThat(box.y()).isEqualTo(0.35 - G / 2, within(1e-2));
    }

    @Test
    void aSleepingLockedBodyIsWokenByWhatStrikesIt() {
        Pool pool = new Pool();
        RigidBody bead = pool.add(BodyDefinition.dynamic(new Circle(0.5)).lockY().awake(false));
        RigidBody ball =
                pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(-3, 0.6).velocity(20, 0));
        for (int i = 0; i < 20; i++) {
            pool.step(DT);
        }
        assertThat(bead.isAwake()).isTrue();
        assertThat(bead.velocityX()).isGreaterThan(1);
        assertThat(bead.y()).isZero();
        assertThat(ball.velocityX()).isLessThan(19);
    }

    /** To the bit, whatever else the pool solves. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void aSceneWithoutLocksKeepsItsBitsBesideALockedStranger(Preset preset) {
        Random random = new Random(5);
        Pool alone = new Pool(Effects.usual().with(new Joints()), preset.accuracy);
        Pool beside = new Pool(Effects.usual().with(new Joints()), preset.accuracy);
        beside.add(BodyDefinition.dynamic(new Circle(1)).at(1000, 0).lockX());
        List<RigidBody> first = new ArrayList<>();
        List<RigidBody> second = new ArrayList<>();
        alone.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        beside.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int i = 0; i < 20; i++) {
            BodyDefinition box =
                    BodyDefinition.dynamic(Polygon.box(0.5, 0.4))
                            .at(random.nextDouble() * 4 - 2, 1 + i * 0.5)
                            .angle(random.nextDouble());
            first.add(alone.add(box));
            second.add(beside.add(box));
        }
        for (int i = 0; i < 150; i++) {
            alone.step(DT);
            beside.step(DT);
        }
        for (int i = 0; i < first.size(); i++) {
            assertThat(second.get(i).x()).isEqualTo(first.get(i).x());
            assertThat(second.get(i).y()).isEqualTo(first.get(i).y());
            assertThat(second.get(i).angle()).isEqualTo(first.get(i).angle());
        }
    }

    /** Bytes, plan and stages of a pool without a locked body know nothing of locks. */
    @Test
    void whoLocksNothingPaysNothing() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.dynamic(new Circle(1)));
        int bits = pool.bitsPerBody();
        String plan = pool.plan();
        assertThat(plan).doesNotContain("locked");
        pool.add(BodyDefinition.dynamic(new Circle(1)).at(5, 0).lockX());
        assertThat(pool.bitsPerBody()).isEqualTo(bits + 16);
        assertThat(pool.plan()).contains("locked");
    }

    @Test
    void aDriveAlongALockedAxisIsRefused() {
        Pool pool = new Pool();
        RigidBody lift = pool.add(BodyDefinition.kinematic(Polygon.box(2, 0.2)).lockX());
        assertThatThrownBy(() -> lift.driveTo(1, 3, 0, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "RigidBody.driveTo x of what is locked in x must be 0.0 to 0.0 (m), was"
                                + " 1.0");
        lift.driveTo(0, 3, 0, 1);
        for (int i = 0; i < 61; i++) {
            pool.step(DT);
        }
        assertThat(lift.y()).isEqualTo(3, within(1e-12));
        assertThat(lift.x()).isZero();
    }

    /** A snapshot in the midst of it goes on to the same bits. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void aRestoredPoolGoesOnAlike(Preset preset) {
        Pool pool = new Pool(Effects.usual(), preset.accuracy);
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(2, 0.2)).at(0, 1).lockY().lockRotation());
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0.3, 2).lockX());
        pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(-0.6, 2.5));
        for (int i = 0; i < 40; i++) {
            pool.step(DT);
        }
        Pool restored = Pool.restore(pool.snapshot());
        assertThat(restored.bodies().get(1).yLocked()).isTrue();
        assertThat(restored.bodies().get(2).xLocked()).isTrue();
        for (int i = 0; i < 40; i++) {
            pool.step(DT);
            restored.step(DT);
        }
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
    }
}
