package rigibo.backend.rest;

import static org.assertj.core.api.Assertions.assertThat;

import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/** Bodies and contacts as numbers, without shapes: what this room looks at. */
final class Pile {

    final DataStorage data;
    final Bodies bodies;
    final Pairs pairs;

    Pile(Effect... effects) {
        data = new DataStorage(Effects.of(effects));
        bodies = data.bodies;
        pairs = data.pairs;
        pairs.beginStep();
    }

    /** An awake body 1 m wide whose farthest point is 1 m away, at the origin and at rest. */
    int body(BodyType type) {
        int slot = bodies.take();
        bodies.type[slot] = type;
        bodies.awake[slot] = type == BodyType.DYNAMIC;
        bodies.boundingRadius[slot] = 1;
        bodies.smallestWidth[slot] = 1;
        bodies.firstPair[slot] = Pairs.NONE;
        return slot;
    }

    /** A body of 1 kg that is pulled down by g m/s². */
    int falling(double g) {
        int slot = body(BodyType.DYNAMIC);
        bodies.accelerationY[slot] = -g;
        bodies.inverseMass[slot] = 1;
        return slot;
    }

    /** A contact that this step looks at; the normal points up, from the lower slot. */
    int contact(int a, int b, int points) {
        int pair = pairs.add(bodies, Math.min(a, b), Math.max(a, b));
        pairs.normalY[pair] = 1;
        pairs.points[pair] = points;
        pairs.activate(pair);
        return pair;
    }

    /** Lists the bodies of this step. */
    void accept() {
        data.roster.isStale = true;
        data.roster.refresh(bodies);
    }

    void requireAwake(boolean isAwake, int... slots) {
        for (int slot : slots) {
            assertThat(bodies.awake[slot]).as("body %s is awake", slot).isEqualTo(isAwake);
        }
    }
}
