package rigibo.backend;

import rigibo.backend.DebugDraw.Layer;
import rigibo.backend.DebugDraw.Look;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.setup.BodyType;

/** Goes through a pool, layer by layer, and calls a {@link DebugDraw} for each thing. */
final class PoolDrawing {

    private final Pool pool;
    private final DebugDraw pen;
    private final DrawnOutline outline = new DrawnOutline();
    private final Aabb bounds = new Aabb();

    PoolDrawing(Pool pool, DebugDraw pen) {
        this.pool = pool;
        this.pen = pen;
    }

    void draw(Layer layer) {
        switch (layer) {
            case BOUNDS -> pool.bodies().forEach(this::drawBounds);
            case SHAPES -> pool.bodies().forEach(this::drawShape);
            case JOINTS -> pool.joints().forEach(pen::joint);
            case CONTACTS -> drawContacts();
            case CENTRES -> pool.bodies().forEach(this::drawCentre);
        }
    }

    private void drawBounds(RigidBody body) {
        body.sizeFixture(bounds);
        pen.bounds(body, bounds);
    }

    private void drawShape(RigidBody body) {
        Look look = look(body);
        boolean isSensor = body.isSensor();
        for (int part = 0; part < body.shape().parts(); part++) {
            boolean isHollow = isSensor || body.shape().isSensor(part);
            outline.trace(body, body.shape().outline(part));
            pen.outline(
                    body,
                    outline.x,
                    outline.y,
                    outline.points,
                    isHollow && look != Look.DISABLED ? Look.SENSOR : look);
        }
    }

    private void drawContacts() {
        pool.forEachContact(
                contact -> {
                    if (contact.phase != ContactEvent.Phase.END) {
                        pen.contact(contact);
                    }
                });
    }

    private void drawCentre(RigidBody body) {
        if (body.type() == BodyType.DYNAMIC) {
            pen.centre(body, look(body));
        }
    }

    private static Look look(RigidBody body) {
        if (!body.isEnabled()) {
            return Look.DISABLED;
        }
        return switch (body.type()) {
            case STATIC -> Look.FIXED;
            case KINEMATIC -> Look.DRIVEN;
            case DYNAMIC -> body.isAwake() ? Look.AWAKE : Look.ASLEEP;
        };
    }
}
