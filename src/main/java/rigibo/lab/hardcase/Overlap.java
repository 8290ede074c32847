package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.lab.truth.Outline;
import rigibo.lab.truth.OutlineSweep;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** Measures how deep bodies overlap, without the engine. */
final class Overlap {

    private final List<RigidBody> known = new ArrayList<>();
    private final List<Outline> outlines = new ArrayList<>();
    private final Map<Outline, RigidBody> bodyOf = new IdentityHashMap<>();
    private OutlineSweep sweep = sweep();

    /** The deepest overlap of all pairs, in widths of the smaller body; 0 if there is none. */
    double deepestShare(List<RigidBody> bodies) {
        if (!isKnown(bodies)) {
            learn(bodies);
        }
        for (int i = 0; i < known.size(); i++) {
            RigidBody body = known.get(i);
            outlines.get(i).place(body.x(), body.y(), body.angle());
        }
        return sweep.deepest();
    }

    private OutlineSweep sweep() {
        return new OutlineSweep(Shape::smallestWidth, (a, b) -> meet(bodyOf.get(a), bodyOf.get(b)));
    }

    private static boolean meet(RigidBody a, RigidBody b) {
        return a.filter().meets(b.filter())
                && a.joints().stream()
                        .filter(joint -> joint.a() == b || joint.b() == b)
                        .allMatch(joint -> joint.definition().settings().collideConnected());
    }

    private boolean isKnown(List<RigidBody> bodies) {
        if (!bodies.equals(known)) {
            return false;
        }
        for (int i = 0; i < known.size(); i++) {
            if (outlines.get(i).shape() != known.get(i).shape()) {
                return false;
            }
        }
        return true;
    }

    private void learn(List<RigidBody> bodies) {
        known.clear();
        known.addAll(bodies);
        outlines.clear();
        sweep = sweep();
        bodyOf.clear();
        for (RigidBody body : bodies) {
            Outline outline = new Outline(body.shape());
            outlines.add(outline);
            bodyOf.put(outline, body);
            sweep.add(outline, body.type() == BodyType.DYNAMIC);
        }
    }
}
