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

    final Pool pool =
            new Pool(Effects.of(new Contacts(), new Rotation(), new Joints()), Accuracy.GAME);
    final DataStorage data = PoolStorage.of(pool);
    final RigidBody ground = pool.add(BodyDefinition.fixed(Polygon.box(1, 1)).at(0, 3));
    final RigidBody a = box(0.3, 0.2, 0.4);
    final RigidBody b = box(1.4, -0.3, -0.9);
    final RigidBody c = box(2.1, 1.1, 2);

    final Motions motions = new Motions(true);
    final PackedContacts contacts = new PackedContacts();
    final NeutralRows rows = new NeutralRows(motions, null);
    private final RowBuilder builder =
            new RowBuilder(data, motions, contacts, new PackedTurns(data.bodies, motions));
    final PackedJoints packed = new PackedJoints(data, builder);
    final Poses poses = new Poses(data.bodies, motions);
    final RowStates states = new RowStates();
    final TautLines lines = new TautLines(packed);
    final JointRows jointRows = new JointRows(data, rows, packed, poses, states, lines);

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
