package rigibo.backend.storage;

import static rigibo.backend.storage.Need.ABSENCES;
import static rigibo.backend.storage.Need.ALWAYS;
import static rigibo.backend.storage.Need.AXES;
import static rigibo.backend.storage.Need.COMPOUNDS;
import static rigibo.backend.storage.Need.CONTACTS;
import static rigibo.backend.storage.Need.DRAG;
import static rigibo.backend.storage.Need.DRIVES;
import static rigibo.backend.storage.Need.FILTERS;
import static rigibo.backend.storage.Need.FRICTION;
import static rigibo.backend.storage.Need.LOCKS;
import static rigibo.backend.storage.Need.ONE_SIDED;
import static rigibo.backend.storage.Need.PATHS;
import static rigibo.backend.storage.Need.RESTITUTION;
import static rigibo.backend.storage.Need.ROLLING_RESISTANCE;
import static rigibo.backend.storage.Need.ROTATION;
import static rigibo.backend.storage.Need.SENSORS;
import static rigibo.backend.storage.Need.SLEEP;
import static rigibo.backend.storage.Need.SURFACE_SPEED;
import static rigibo.backend.storage.Need.THRUST;
import static rigibo.backend.storage.Need.TURNING_CONTACTS;
import static rigibo.backend.storage.Need.TURNING_PATHS;
import static rigibo.backend.storage.Need.TURNING_SLEEP;
import static rigibo.backend.storage.Need.TURNING_THRUST;
import static rigibo.backend.storage.Role.DERIVED;
import static rigibo.backend.storage.Role.SAVED;
import static rigibo.backend.storage.Role.SCRATCH;

/**
 * The table of the bodies' columns, in the order in which they are saved. Apart from its field, a
 * column is declared by one line here.
 */
final class BodyColumns {

    private BodyColumns() {}

    /**
     * Passes every column to a visitor, and stores the array that the visitor returns in the field.
     */
    static void visit(Bodies b, ColumnVisitor v) {
        visitStated(b, v);
        visitMotion(b, v);
        visitForces(b, v);
        visitContacts(b, v);
        visitStillness(b, v);
        visitShape(b, v);
        visitMaterial(b, v);
        visitStep(b, v);
    }

    private static void visitStated(Bodies b, ColumnVisitor v) {
        b.type = v.column("type", SAVED, b.type);
        b.shape = v.column("shape", SAVED, b.shape);
        b.material = v.column("material", SAVED, b.material);
        b.owner = v.column("owner", SAVED, COMPOUNDS, b.owner);
        b.nextShape = v.column("nextShape", SAVED, COMPOUNDS, b.nextShape);
        b.part = v.column("part", SAVED, COMPOUNDS, b.part);
        b.category = v.column("category", SAVED, FILTERS, b.category);
        b.mask = v.column("mask", SAVED, FILTERS, b.mask);
        b.rotationLocked = v.column("rotationLocked", SAVED, LOCKS, b.rotationLocked);
        b.lockedX = v.column("lockedX", SAVED, AXES, b.lockedX);
        b.lockedY = v.column("lockedY", SAVED, AXES, b.lockedY);
        b.driveX = v.column("driveX", SAVED, DRIVES, b.driveX);
        b.driveY = v.column("driveY", SAVED, DRIVES, b.driveY);
        b.driveAngle = v.column("driveAngle", SAVED, DRIVES, b.driveAngle);
        b.driveTime = v.column("driveTime", SAVED, DRIVES, b.driveTime);
        b.sensor = v.column("sensor", SAVED, SENSORS, b.sensor);
        b.disabled = v.column("disabled", SAVED, ABSENCES, b.disabled);
        b.group = v.column("group", SAVED, ALWAYS, b.group);
        b.gravityScale = v.column("gravityScale", SAVED, ALWAYS, b.gravityScale);
        b.statedMass = v.column("statedMass", SAVED, ALWAYS, b.statedMass);
        b.statedInertia = v.column("statedInertia", SAVED, ALWAYS, b.statedInertia);
    }

    private static void visitMotion(Bodies b, ColumnVisitor v) {
        b.x = v.column("x", SAVED, ALWAYS, b.x);
        b.y = v.column("y", SAVED, ALWAYS, b.y);
        b.angle = v.column("angle", SAVED, ALWAYS, b.angle);
        b.cos = v.column("cos", DERIVED, ALWAYS, b.cos);
        b.sin = v.column("sin", DERIVED, ALWAYS, b.sin);
        b.velocityX = v.column("velocityX", SAVED, ALWAYS, b.velocityX);
        b.velocityY = v.column("velocityY", SAVED, ALWAYS, b.velocityY);
        b.spin = v.column("spin", SAVED, ROTATION, b.spin);
        b.awake = v.column("awake", SAVED, ALWAYS, b.awake);
    }

    /**
     * The accelerations of a sleeping body keep the values with which it fell asleep: they decide
     * which bodies lean on which, and a body that wakes within a step starts with them.
     */
    private static void visitForces(Bodies b, ColumnVisitor v) {
        b.accelerationX = v.column("accelerationX", SAVED, ALWAYS, b.accelerationX);
        b.accelerationY = v.column("accelerationY", SAVED, ALWAYS, b.accelerationY);
        b.angularAcceleration =
                v.column("angularAcceleration", SAVED, ROTATION, b.angularAcceleration);
        b.pullX = v.column("pullX", SAVED, PATHS, b.pullX);
        b.pullY = v.column("pullY", SAVED, PATHS, b.pullY);
        b.pullTurn = v.column("pullTurn", SAVED, TURNING_PATHS, b.pullTurn);
        b.forceX = v.column("forceX", SAVED, THRUST, b.forceX);
        b.forceY = v.column("forceY", SAVED, THRUST, b.forceY);
        b.torque = v.column("torque", SAVED, TURNING_THRUST, b.torque);
    }

    private static void visitContacts(Bodies b, ColumnVisitor v) {
        b.fixtureMinX = v.column("fixtureMinX", SAVED, CONTACTS, b.fixtureMinX);
        b.fixtureMinY = v.column("fixtureMinY", SAVED, CONTACTS, b.fixtureMinY);
        b.fixtureMaxX = v.column("fixtureMaxX", SAVED, CONTACTS, b.fixtureMaxX);
        b.fixtureMaxY = v.column("fixtureMaxY", SAVED, CONTACTS, b.fixtureMaxY);
        b.refitted = v.column("refitted", SAVED, CONTACTS, b.refitted);
        b.firstPair = v.column("firstPair", SAVED, CONTACTS, b.firstPair);
        b.leaf = v.column("leaf", DERIVED, CONTACTS, b.leaf);
    }

    private static void visitStillness(Bodies b, ColumnVisitor v) {
        b.stillTime = v.column("stillTime", SAVED, SLEEP, b.stillTime);
        b.stillX = v.column("stillX", SAVED, SLEEP, b.stillX);
        b.stillY = v.column("stillY", SAVED, SLEEP, b.stillY);
        // Where no body has turned since, the anchor angle is the body's angle, as it is without
        // rotation.
        b.stillAngle = v.column("stillAngle", SAVED, TURNING_SLEEP, b.stillAngle, b.angle);
    }

    private static void visitShape(Bodies b, ColumnVisitor v) {
        b.outline = v.column("outline", DERIVED, b.outline);
        b.mass = v.column("mass", DERIVED, ALWAYS, b.mass);
        b.inverseMass = v.column("inverseMass", DERIVED, ALWAYS, b.inverseMass);
        b.inertia = v.column("inertia", DERIVED, ROTATION, b.inertia);
        b.inverseInertia = v.column("inverseInertia", DERIVED, ROTATION, b.inverseInertia);
        b.boundingRadius = v.column("boundingRadius", DERIVED, ALWAYS, b.boundingRadius);
        b.smallestWidth = v.column("smallestWidth", DERIVED, CONTACTS, b.smallestWidth);
        b.sweepRadius = v.column("sweepRadius", DERIVED, TURNING_CONTACTS, b.sweepRadius);
    }

    private static void visitMaterial(Bodies b, ColumnVisitor v) {
        b.friction = v.column("friction", DERIVED, FRICTION, b.friction);
        b.elasticity = v.column("elasticity", DERIVED, RESTITUTION, b.elasticity);
        b.rollingResistance =
                v.column("rollingResistance", DERIVED, ROLLING_RESISTANCE, b.rollingResistance);
        b.surfaceSpeed = v.column("surfaceSpeed", DERIVED, SURFACE_SPEED, b.surfaceSpeed);
        b.drag = v.column("drag", DERIVED, DRAG, b.drag);
        b.oneWayX = v.column("oneWayX", DERIVED, ONE_SIDED, b.oneWayX);
        b.oneWayY = v.column("oneWayY", DERIVED, ONE_SIDED, b.oneWayY);
    }

    private static void visitStep(Bodies b, ColumnVisitor v) {
        b.startX = v.column("startX", SCRATCH, ALWAYS, b.startX);
        b.startY = v.column("startY", SCRATCH, ALWAYS, b.startY);
        b.startAngle = v.column("startAngle", SCRATCH, ROTATION, b.startAngle);
        b.piled = v.column("piled", SCRATCH, CONTACTS, b.piled);
        b.pileTime = v.column("pileTime", SCRATCH, CONTACTS, b.pileTime);
    }
}
