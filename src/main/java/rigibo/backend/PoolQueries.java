package rigibo.backend;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairIndex;
import rigibo.backend.storage.Pairs;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Answers questions about a pool between steps. */
final class PoolQueries {

    private final Pool pool;
    private final DataStorage data;
    private final Broadphase broadphase;

    PoolQueries(Pool pool, DataStorage data, Broadphase broadphase) {
        this.pool = pool;
        this.data = data;
        this.broadphase = broadphase;
    }

    boolean touching(int a, int b) {
        int pair = data.pairs.index.find(Math.min(a, b), Math.max(a, b));
        return pair != PairIndex.ABSENT && data.pairs.touching[pair];
    }

    List<ContactEvent> contactEvents() {
        List<ContactEvent> events = new ArrayList<>();
        for (int pair = 0; pair < data.pairs.slots.high; pair++) {
            if (data.pairs.bodyA[pair] != Pairs.NONE) {
                addEvent(pair, events);
            }
        }
        return events;
    }

    Optional<RigidBody> bodyAt(double x, double y) {
        RigidBody last = null;
        for (RigidBody body : pool.bodies()) {
            double dx = body.x() - x;
            double dy = body.y() - y;
            if (Math.sqrt(dx * dx + dy * dy) <= body.shape().boundingRadius()) {
                last = body;
            }
        }
        return Optional.ofNullable(last);
    }

    Optional<RayHit> rayCast(double fromX, double fromY, double toX, double toY) {
        return Optional.empty();
    }

    List<RigidBody> overlapping(Aabb box) {
        return new ArrayList<>();
    }

    private void addEvent(int pair, List<ContactEvent> events) {
        Pairs pairs = data.pairs;
        boolean now = pairs.touching[pair];
        boolean before = pairs.touchedBefore[pair];
        boolean bounced = pairs.impacts[pair] > 0;
        if (now || before || bounced) {
            events.add(event(pair, phase(now || bounced, before)));
        }
    }

    private static ContactEvent.Phase phase(boolean touched, boolean before) {
        if (!touched) {
            return ContactEvent.Phase.END;
        }
        return before ? ContactEvent.Phase.PERSIST : ContactEvent.Phase.BEGIN;
    }

    private ContactEvent event(int pair, ContactEvent.Phase phase) {
        Pairs p = data.pairs;
        int last = 2 * pair + Math.max(p.points[pair], 1) - 1;
        return new ContactEvent(
                pool.handle(p.bodyA[pair]),
                pool.handle(p.bodyB[pair]),
                phase,
                (p.pointX[2 * pair] + p.pointX[last]) / 2,
                (p.pointY[2 * pair] + p.pointY[last]) / 2,
                p.normalX[pair],
                p.normalY[pair],
                p.impulse[pair]);
    }
}
