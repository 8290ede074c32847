package rigibo.backend;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Need;
import rigibo.backend.storage.Pairs;

/**
 * Writes the columns of a body's shapes, one slot for each part: outline, surface, filter, sensor.
 */
final class BodyShapes {

    private final DataStorage data;
    private final Bodies bodies;

    /** Outline of the disc that was written last; discs of one size in a row share it. */
    private Outline disc;

    BodyShapes(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
    }

    /**
     * Takes a slot for each further part of a new body (the first has one) and writes all parts.
     */
    void add(int body, BodyDefinition definition) {
        take(body, definition.shape());
        write(body, definition.shape());
        int slot = body;
        for (int part = 0; part < definition.shape().parts(); part++) {
            writeSurface(slot, surface(definition.material(part), definition.material()));
            filter(slot, definition.filter(part));
            sensor(slot, definition.isSensor() || isSensor(definition.shape(), part));
            slot = bodies.nextShapeOf(slot);
        }
    }

    /**
     * Gives a body a shape with other parts; all of them get the old first part's material, filter.
     */
    void exchange(int body, Shape shape) {
        Filter filter = filter(body);
        boolean isWhole = bodies.isSensor(body) && !isSensor(bodies.shape[body], 0);
        release(body);
        if (bodies.holdsCompounds()) {
            bodies.nextShape[body] = Pairs.NONE;
        }
        take(body, shape);
        write(body, shape);
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            writeSurface(slot, bodies.material[body]);
            filter(slot, filter);
            sensor(slot, isWhole || isSensor(shape, bodies.partOf(slot)));
        }
    }

    /** Releases the slots of all parts but the first. */
    void release(int body) {
        int slot = bodies.nextShapeOf(body);
        while (slot != Pairs.NONE) {
            int next = bodies.nextShapeOf(slot);
            bodies.release(slot);
            slot = next;
        }
    }

    /** Takes the slots; the columns of compounds and chains are made when the first one comes. */
    private void take(int body, Shape shape) {
        if (shape.parts() > 1) {
            data.hold(Need.COMPOUNDS);
        }
        if (shape.kind() == ShapeKind.CHAIN) {
            data.hold(Need.ONE_SIDED);
        }
        int last = body;
        for (int part = 1; part < shape.parts(); part++) {
            last = bodies.takeShape(body, last);
            bodies.standBy(last);
        }
    }

    /**
     * Writes each part's outline into its slot. The body's own slot (of its first part) also holds
     * the shape, bounding radius and width of the whole.
     */
    void write(int body, Shape shape) {
        double sweep = 0;
        int slot = body;
        for (int part = 0; part < shape.parts(); part++) {
            Outline outline = shape instanceof Circle circle ? of(circle) : shape.outline(part);
            bodies.outline[slot] = outline;
            bodies.shape[slot] = part == 0 ? shape : alone(shape, part);
            sweep = Math.max(sweep, outline.sweepRadius());
            slot = bodies.nextShapeOf(slot);
        }
        bodies.boundingRadius[body] = shape.boundingRadius();
        if (bodies.smallestWidth != null) {
            bodies.smallestWidth[body] = shape.smallestWidth();
        }
        if (bodies.sweepRadius != null) {
            bodies.sweepRadius[body] = sweep;
        }
    }

    private Outline of(Circle circle) {
        if (disc == null || disc.radius() != circle.radius()) {
            disc = circle.outline();
        }
        return disc;
    }

    /** Whether a part of a shape is a sensor by itself. */
    static boolean isSensor(Shape shape, int part) {
        return shape.isSensor(part);
    }

    private void sensor(int slot, boolean isSensor) {
        if (isSensor) {
            data.hold(Need.SENSORS);
        }
        if (bodies.sensor != null) {
            bodies.sensor[slot] = isSensor;
        }
    }

    private static Shape alone(Shape shape, int part) {
        return shape instanceof Chain chain
                ? chain.edge(part)
                : ((Compound) shape).part(part).shape();
    }

    /** Gives every part the same material. */
    void material(int body, Material material) {
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            writeSurface(slot, material);
        }
    }

    /** Gives the part of a slot a surface of its own. */
    void surface(int slot, Material material) {
        writeSurface(slot, surface(material, bodies.material[bodies.bodyOf(slot)]));
    }

    /** A part's surface material, with the density and drag of the body. */
    private static Material surface(Material stated, Material body) {
        // Most bodies have one material, and most of these are the same object.
        return stated == body ? body : stated.density(body.density()).drag(body.drag());
    }

    /** Writes the columns that depend on the materials again. */
    void writeSurfaces(int body) {
        for (int slot = body; slot != Pairs.NONE; slot = bodies.nextShapeOf(slot)) {
            writeSurface(slot, bodies.material[slot]);
        }
    }

    private void writeSurface(int slot, Material material) {
        if (material.isOneWay()) {
            data.hold(Need.ONE_SIDED);
        }
        bodies.material[slot] = material;
        if (bodies.oneWayX != null) {
            bodies.oneWayX[slot] = material.oneWayX();
            bodies.oneWayY[slot] = material.oneWayY();
        }
        if (bodies.friction != null) {
            bodies.friction[slot] = material.friction();
        }
        if (bodies.elasticity != null) {
            bodies.elasticity[slot] = material.elasticity();
        }
        if (bodies.rollingResistance != null) {
            bodies.rollingResistance[slot] = material.rollingResistance();
        }
        if (bodies.surfaceSpeed != null) {
            bodies.surfaceSpeed[slot] = material.surfaceSpeed();
        }
        if (bodies.drag != null) {
            bodies.drag[slot] = material.drag();
        }
    }

    /** Writes a filter; the columns of categories are made when the first body needs them. */
    void filter(int slot, Filter filter) {
        if (!filter.isPlain()) {
            bodies.hold(Need.FILTERS);
        }
        bodies.group[slot] = filter.group();
        if (bodies.category != null) {
            bodies.category[slot] = filter.category();
            bodies.mask[slot] = filter.mask();
        }
    }

    Filter filter(int slot) {
        Filter plain = Filter.ALL.group(bodies.group[slot]);
        return bodies.category == null
                ? plain
                : plain.category(bodies.category[slot]).mask(bodies.mask[slot]);
    }
}
