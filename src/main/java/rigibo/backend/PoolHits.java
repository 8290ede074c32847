package rigibo.backend;

import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Hits;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Reports the impacts of the last step. */
final class PoolHits {

    private final Pool pool;
    private final DataStorage data;
    private final Busy busy;
    private final HitView view = new HitView();

    PoolHits(Pool pool, DataStorage data, Busy busy) {
        this.pool = pool;
        this.data = data;
        this.busy = busy;
    }

    List<HitEvent> list() {
        List<HitEvent> events = new ArrayList<>();
        forEach(hit -> events.add(hit.event()));
        return events;
    }

    /** Visits every impact; a visit nested in another one uses a view of its own. */
    void forEach(Consumer<? super HitView> visitor) {
        Hits hits = data.hits;
        HitView shown = busy.isVisited() ? new HitView() : view;
        busy.beginVisit();
        try {
            for (int i = 0; hits != null && i < hits.count; i++) {
                if (hits.areThere(i)) {
                    show(hits, i, shown);
                    visitor.accept(shown);
                }
            }
        } finally {
            busy.endVisit();
        }
    }

    private void show(Hits hits, int i, HitView into) {
        into.a = pool.handle(hits.bodyA[i]);
        into.b = pool.handle(hits.bodyB[i]);
        into.partA = hits.partA[i];
        into.partB = hits.partB[i];
        into.x = hits.x[i];
        into.y = hits.y[i];
        into.normalX = hits.normalX[i];
        into.normalY = hits.normalY[i];
        into.speed = hits.speed[i];
        into.time = hits.time[i];
    }
}
