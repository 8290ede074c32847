package rigibo.backend;

import rigibo.backend.SensorEvent.Phase;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Visits;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** Reports the sensor events of the last step, and visits that edits ended since. */
final class PoolSensors {

    private final Pool pool;
    private final DataStorage data;
    private final Bodies bodies;
    private final Busy busy;
    private final SensorView view = new SensorView();

    /** Visits that edits ended since the last step: the next step reports them. */
    private final List<SensorEvent> ending = new ArrayList<>();

    private final List<SensorEvent> ended = new ArrayList<>();

    PoolSensors(Pool pool, DataStorage data, Busy busy) {
        this.pool = pool;
        this.data = data;
        this.busy = busy;
        bodies = data.bodies;
    }

    /** Ends the visits of a body whose shapes are about to be removed. */
    void cutAllOf(int body) {
        Visits visits = data.visits;
        for (int i = 0; i < visits.count; i++) {
            boolean isOfBody =
                    bodies.bodyOf(visits.sensor[i]) == body
                            || bodies.bodyOf(visits.visitor[i]) == body;
            if (isOfBody && visits.isInside(i)) {
                show(i, Phase.LEFT, view);
                ending.add(view.event());
            }
        }
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            visits.forget(slot);
        }
    }

    /** After a step: makes the visits that edits ended before it part of that step's events. */
    void follow() {
        ended.clear();
        // List.addAll allocates an array even for an empty list.
        for (int i = 0; i < ending.size(); i++) {
            ended.add(ending.get(i));
        }
        ending.clear();
    }

    List<SensorEvent> list() {
        List<SensorEvent> events = new ArrayList<>();
        forEach(seen -> events.add(seen.event()));
        return events;
    }

    /** Passes every event to a reader; a call nested in another one uses a view of its own. */
    void forEach(Consumer<? super SensorView> reader) {
        SensorView shown = busy.isVisited() ? new SensorView() : view;
        busy.beginVisit();
        try {
            Visits visits = data.visits;
            for (int i = 0; visits != null && i < visits.count; i++) {
                tell(i, visits.state[i], shown, reader);
            }
            for (int i = 0; i < ended.size(); i++) {
                show(ended.get(i), shown);
                reader.accept(shown);
            }
        } finally {
            busy.endVisit();
        }
    }

    private void tell(int visit, int state, SensorView shown, Consumer<? super SensorView> reader) {
        if (state == Visits.ENTERED || state == Visits.PASSED) {
            show(visit, Phase.ENTERED, shown);
            reader.accept(shown);
        }
        if (state == Visits.INSIDE) {
            show(visit, Phase.INSIDE, shown);
            reader.accept(shown);
        }
        if (state == Visits.LEFT || state == Visits.PASSED) {
            show(visit, Phase.LEFT, shown);
            reader.accept(shown);
        }
    }

    private void show(int visit, Phase phase, SensorView shown) {
        int sensor = data.visits.sensor[visit];
        int visitor = data.visits.visitor[visit];
        shown.sensor = pool.handle(bodies.bodyOf(sensor));
        shown.part = bodies.partOf(sensor);
        shown.visitor = pool.handle(bodies.bodyOf(visitor));
        shown.visitorPart = bodies.partOf(visitor);
        shown.phase = phase;
    }

    private static void show(SensorEvent event, SensorView shown) {
        shown.sensor = event.sensor();
        shown.part = event.part();
        shown.visitor = event.visitor();
        shown.visitorPart = event.visitorPart();
        shown.phase = event.phase();
    }

    /** The bodies inside any sensor of a body, each once, in the order they were found. */
    Set<RigidBody> inside(int body) {
        Set<RigidBody> inside = new LinkedHashSet<>();
        Visits visits = data.visits;
        for (int i = 0; visits != null && i < visits.count; i++) {
            if (bodies.bodyOf(visits.sensor[i]) == body && visits.isInside(i)) {
                inside.add(pool.handle(bodies.bodyOf(visits.visitor[i])));
            }
        }
        return inside;
    }
}
