package rigibo.lab.ablation;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;

import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;

/**
 * The engine's classes that exist only for some effects. A new effect adds one line.
 *
 * @param owners the effects that need the classes; they are needed if at least one of these is
 *     declared
 * @param classes in the package {@code rigibo.backend}, by room and simple name, with all that is
 *     nested in them; {@code contact.*} is a whole room
 */
record OwnClasses(List<Class<? extends Effect>> owners, List<String> classes) {

    private static final String ENGINE = "rigibo/backend/";
    private static final String SUFFIX = ".class";
    private static final String WHOLE_ROOM = "*";

    /** All lines. A class that needs several effects at once appears in several lines. */
    static final List<OwnClasses> ALL =
            List.of(
                    of(Gravity.class, "force.GravityKernel"),
                    of(Thrust.class, "force.ThrustKernel", "force.TorqueKernel"),
                    of(Wind.class, "force.WindKernel", "force.GustForce"),
                    of(AirDrag.class, "force.AirDragForce"),
                    of(Buoyancy.class, "force.BuoyantForce", "force.Submerged"),
                    of(CentralForce.class, "force.CentralPull"),
                    of(Fan.class, "force.FanForce"),
                    of(Magnet.class, "force.MagnetForce"),
                    of(Field.class, "force.FieldForce"),
                    ofAny(List.of(AirDrag.class, Fan.class), "force.Extent"),
                    ofAny(
                            List.of(
                                    AirDrag.class,
                                    Buoyancy.class,
                                    CentralForce.class,
                                    Fan.class,
                                    Field.class,
                                    Magnet.class,
                                    Wind.class),
                            "force.Instant",
                            "flight.Course",
                            "flight.Deviation",
                            "flight.TurningCourse",
                            "contact.row.IslandForces"),
                    of(
                            Contacts.class,
                            "broadphase.*",
                            "contact.*",
                            "collision.manifold.BoxFaces",
                            "collision.manifold.CircleCircle",
                            "collision.manifold.Collider",
                            "collision.manifold.FaceClip",
                            "collision.manifold.FaceSearch",
                            "collision.manifold.Manifold",
                            "collision.Narrowphase",
                            "collision.manifold.NormalSource",
                            "collision.manifold.PolygonCircle",
                            "collision.manifold.PolygonPolygon",
                            "collision.SeamCover",
                            "collision.SeamPoint",
                            "collision.Seams",
                            "flight.FreeFlight",
                            "flight.Trajectories",
                            "flight.TurningPaths",
                            "rest.IslandBuilder",
                            "rest.PileClassifier",
                            "storage.PairTolerances"),
                    of(Friction.class, "contact.solve.FrictionSolver"),
                    of(RollingResistance.class, "contact.solve.RollingSolver"),
                    of(SurfaceSpeed.class, "contact.row.RunningRows"),
                    of(
                            Rotation.class,
                            "contact.row.PackedTurns",
                            "contact.row.TurningRows",
                            "flight.OpenTurning",
                            "flight.TurningCourse",
                            "flight.TurningPaths",
                            "force.TorqueKernel",
                            "step.StepTurns"),
                    of(Drag.class, "contact.row.DragKick"),
                    of(
                            Restitution.class,
                            "contact.bounce.BounceRows",
                            "contact.bounce.SimultaneousImpacts",
                            "contact.bounce.IslandImpacts",
                            "contact.bounce.PairwiseImpacts"),
                    of(
                            ContinuousImpacts.class,
                            "collision.distance.Approach",
                            "collision.distance.AxisReach",
                            "collision.distance.Distance",
                            "collision.distance.FarthestCorner",
                            "collision.distance.FixedAxisGap",
                            "collision.distance.GapAlong",
                            "collision.distance.RootSearch",
                            "collision.distance.SafeAdvance",
                            "collision.distance.TimeOfImpact",
                            "collision.distance.TurningFaceGap",
                            "flight.FlightImpacts",
                            "flight.Bystanders",
                            "flight.Flight",
                            "flight.ImpactQueue"),
                    ofAny(List.of(Restitution.class, ContinuousImpacts.class), "impact.*"),
                    of(Sensors.class, "sense.*"),
                    of(
                            Joints.class,
                            "contact.joint.*",
                            "contact.JointedIslands",
                            "rest.JointedBodies"),
                    of(Sleep.class, "rest.Sleeping"));

    private static OwnClasses of(Class<? extends Effect> owner, String... classes) {
        return ofAny(List.of(owner), classes);
    }

    private static OwnClasses ofAny(List<Class<? extends Effect>> owners, String... classes) {
        return new OwnClasses(owners, List.of(classes));
    }

    /**
     * The files, such as {@code rigibo/backend/force/ThrustKernel.class}, of all classes that no
     * declared effect needs.
     *
     * @param files of the engine
     * @throws IllegalStateException when a listed class is not among them
     */
    static List<String> undeclared(Effects declared, Iterable<String> files) {
        TreeSet<String> found = new TreeSet<>();
        for (OwnClasses line : ALL) {
            List<String> own = line.files(files);
            if (line.owners.stream().noneMatch(declared::declares)) {
                found.addAll(own);
            }
        }
        return List.copyOf(found);
    }

    private List<String> files(Iterable<String> engine) {
        return classes.stream().flatMap(name -> filesOf(name, engine).stream()).toList();
    }

    private List<String> filesOf(String name, Iterable<String> engine) {
        TreeSet<String> found = new TreeSet<>();
        for (String file : engine) {
            if (isOf(name, file)) {
                found.add(file);
            }
        }
        if (found.isEmpty()) {
            throw new IllegalStateException(
                    "the class "
                            + name
                            + " is listed as existing for "
                            + names()
                            + " only, but the engine has none of that name");
        }
        return List.copyOf(found);
    }

    private static boolean isOf(String name, String file) {
        String path = ENGINE + name.replace('.', '/');
        if (path.endsWith(WHOLE_ROOM)) {
            return file.startsWith(path.substring(0, path.length() - 1))
                    && !file.endsWith("package-info" + SUFFIX);
        }
        return file.equals(path + SUFFIX) || file.startsWith(path + "$");
    }

    private String names() {
        return Arrays.toString(owners.stream().map(Class::getSimpleName).toArray());
    }
}
