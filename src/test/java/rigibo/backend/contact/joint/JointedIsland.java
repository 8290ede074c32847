package rigibo.backend.contact.joint;

import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.RigidBody;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedTurns;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.DataStorage;

/** One island of three boxes beside a fixed body, whose joints a test states. */
final class JointedIsland {

    final Pool pool;
    final DataStorage data;
    final RigidBody ground;
    final RigidBody a;
    final RigidBody b;
    final RigidBody c;

    final Motions motions;
    final PackedContacts contacts = new PackedContacts();
    final NeutralRows rows;
    private final RowBuilder builder;
    final PackedJoints packed;
    final Poses poses;
    final RowStates states = new RowStates();
    final TautLines lines;
    final JointRows jointRows;

    JointedIsland() {
        this(Effects.of(new Contacts(), new Rotation(), new Joints()));
    }

    JointedIsland(Effects effects) {
        pool = new Pool(effects, Accuracy.GAME);
        data = PoolStorage.of(pool);
        ground = pool.add(BodyDefinition.fixed(Polygon.box(1, 1)).at(0, 3));
        a = box(0.3, 0.2, 0.4);
        b = box(1.4, -0.3, -0.9);
        c = box(2.1, 1.1, 2);
        boolean turns = data.bodies.turns();
        motions = new Motions(turns);
        PackedTurns packedTurns = turns ? new PackedTurns(data.bodies, motions) : null;
        rows = new NeutralRows(motions, null);
        builder = new RowBuilder(data, motions, contacts, packedTurns);
        packed = new PackedJoints(data, builder);
        poses = new Poses(data.bodies, motions);
        lines = new TautLines(packed);
        jointRows = new JointRows(data, rows, packed, poses, states, lines);
    }

    private RigidBody box(double x, double y, double angle) {
        return pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.5)).at(x, y).angle(angle));
    }

    /** Packs the three boxes and the first joints of the pool. */
    void pack(int jointCount, double kick) {
        data.islands.count = 1;
        data.islands.bodies[0] = 1;
        data.islands.bodies[1] = 2;
        data.islands.bodies[2] = 3;
        data.islands.bodyStart[1] = 3;
        data.islands.reserveJoints(1, jointCount);
        for (int i = 0; i < jointCount; i++) {
            data.islands.joints[i] = i;
        }
        data.islands.jointStart[1] = jointCount;
        builder.build(0, kick);
        packed.pack(0, kick);
        states.clear(jointCount, 0);
    }
}
